(* One spectral radius: Theorem 27 of SPEC.md. If the symbol of a scheme is a sum of squares, its powers are largest in the
   middle, and these numbers satisfy a linear recurrence. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Existence Integers Sections Subdivision Coefficients Growth Squares.
Import ListNotations.
Open Scope Z_scope.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

(* The symbol b_(-c), ..., b_c times the denominator of the family is content * squares(z) squares(1/z) cosine(z), and
   4^bits cosine is factor(z) factor(1/z) but for a small difference. *)
Record squares := Squares { symbol : zvec; content : Z; divisor : zvec; cosine : zvec; factor : zvec; bits : nat }.

Fixpoint zproduct_of (p q : zvec) : zvec := match p with [] => [] | c :: p' => addmul c q (0 :: zproduct_of p' q) end.
Definition mirrored (p : zvec) : zvec := zproduct_of p (rev p).
Definition middle (p : zvec) : nat := length p / 2.

Definition difference_of (s : squares) : nat * zvec :=
  let m := middle (cosine s) in let d := (length (factor s) - 1)%nat in let mid := Nat.max m d in
  (mid, addmul (4 ^ Z.of_nat (bits s)) (repeat 0 (mid - m) ++ cosine s) (map (Z.mul (-1)) (repeat 0 (mid - d) ++ mirrored (factor s)))).

Definition is_transition (F : family) (b : zvec) : bool :=
  forallb (fun t => forallb (fun j => let at_ := (count F * j + t)%nat in
    forallb (fun k => entry (letter F t) j k =? (if (k <=? at_)%nat then nth (at_ - k) b 0 else 0)) (seq 0 (size F)))
    (seq 0 (size F))) (seq 0 (count F)).

Definition sum_of_squares (F : family) (s : squares) : bool :=
  let b := symbol s in let '(mid, e) := difference_of s in
  (2 <=? count F)%nat && (1 <=? size F)%nat && same b (rev b) && (length b =? 2 * middle b + 1)%nat &&
  (length b - 1 <=? size F * (count F - 1))%nat && is_transition F b &&
  (0 <? content s) && same b (map (Z.mul (content s)) (zproduct_of (mirrored (divisor s)) (cosine s))) &&
  (middle b + 1 =? length (divisor s) + middle (cosine s))%nat && (1 <=? length (factor s))%nat &&
  (norm1 e <=? 2 * nth mid e 0).

(* The coefficients of the powers at multiples of A^n: a matrix for the coefficients -r, ..., r, times the denominator *)
Definition reach_of (A : nat) (b : zvec) : nat := (middle b / (A - 1))%nat.
Definition central_matrix (A : nat) (b : zvec) : zmat :=
  let r := reach_of A b in
  table (2 * r + 1) (fun j i => let high := (middle b + i + (A - 1) * r)%nat in
    if (A * j <=? high)%nat then nth (high - A * j) b 0 else 0).

(* d^length times the polynomial of matrix / d, applied to a vector *)
Fixpoint applied (M : zmat) (d : Z) (x : zvec) (p : list Z) : Z * zvec :=
  match p with [] => (1, []) | c :: p' => let '(k, v) := applied M d x p' in (k * d, addmul (c * (k * d)) x (mv M v)) end.

Definition recurs (F : family) (b : zvec) (p : list Z) : bool :=
  let '(_, v) := applied (central_matrix (count F) b) (denominator F) (unit_at 1 (reach_of (count F) b)) p in
  forallb (Z.eqb 0) v.

(* The coefficients of q^length p((x + a) / q) *)
Fixpoint shifted_by (a q : Z) (p : list Z) : Z * zvec :=
  match p with [] => (1, []) | c :: p' => let '(k, s) := shifted_by a q p' in (k * q, addmul a s (c * (k * q) :: s)) end.

Definition no_negative (p : zvec) : bool := forallb (Z.leb 0) p && existsb (Z.ltb 0) p.
Definition one_sign (p : zvec) : bool := no_negative p || no_negative (map (Z.mul (-1)) p).

Definition single_section (F : family) (u : Q) (s : squares) (p : list Z) : bool :=
  sum_of_squares F s && recurs F (symbol s) p && (0 <=? Qnum u) &&
  one_sign (snd (shifted_by (Qnum u) (Zpos (Qden u)) p)).

(* ---- lists of integers as polynomials ---------------------------------------------------------------------------- *)

Definition reals : zvec -> list R := map IZR.

Lemma nth_reals p i : nth i (reals p) 0%R = IZR (nth i p 0).
Proof. unfold reals. apply (map_nth IZR). Qed.

Lemma reals_addmul c x : forall y, reals (addmul c x y) = padd (pscal (IZR c) (reals x)) (reals y).
Proof.
  unfold reals, pscal. induction x; intros y; auto. destruct y; cbn [addmul map padd]; rewrite ?plus_IZR, mult_IZR, IHx.
  - cbn [map]. f_equal. destruct x; auto.
  - auto.
Qed.

Lemma back_addmul c x y f i : back (reals (addmul c x y)) f i = (IZR c * back (reals x) f i + back (reals y) f i)%R.
Proof. rewrite reals_addmul, back_padd, back_scale. auto. Qed.

Lemma back_zproduct p q f : forall i, back (reals (zproduct_of p q)) f i = back (reals p) (back (reals q) f) i.
Proof.
  induction p; intros i; cbn [zproduct_of reals map back]; auto. fold (reals p). rewrite back_addmul. cbn [reals map back]. fold (reals (zproduct_of p q)).
  rewrite IHp. ring.
Qed.

Lemma back_times c p f i : back (reals (map (Z.mul c) p)) f i = (IZR c * back (reals p) f i)%R.
Proof.
  rewrite <- back_scale. f_equal. unfold reals, pscal. rewrite !map_map. apply map_ext. intros a. apply mult_IZR.
Qed.

Lemma reals_length p : length (reals p) = length p.
Proof. apply map_length. Qed.

Lemma reals_repeat k p : reals (repeat 0 k ++ p) = repeat 0%R k ++ reals p.
Proof. unfold reals. rewrite map_app. f_equal. induction k; simpl; f_equal; auto. Qed.

(* p(z) p(1/z) f(z) *)
Lemma back_mirrored p f i : back (reals (mirrored p)) f (i + Z.of_nat (length p) - 1) = ahead (reals p) (back (reals p) f) i.
Proof.
  unfold mirrored. rewrite back_zproduct, back_back. unfold reals at 1. rewrite map_rev. fold (reals p).
  rewrite <- (reals_length p), back_rev. auto.
Qed.

Section Squares.
Variables (F : family) (s : squares).
Hypothesis WF : well_formed F = true.
Hypothesis Right : sum_of_squares F s = true.
Let b := symbol s.
Let A := count F.
Let W := size F.
Let D := denominator F.
Let c := middle b.
Let N := (length b - 1)%nat.

Definition symbol_at (i : Z) : R := if i <? 0 then 0%R else (IZR (nth (Z.to_nat i) b 0%Z) / IZR D)%R.

Lemma facts : (2 <= A)%nat /\ (1 <= W)%nat /\ b = rev b /\ (length b = 2 * c + 1)%nat /\ (N <= W * (A - 1))%nat /\
  is_transition F b = true /\ 0 < content s /\ b = map (Z.mul (content s)) (zproduct_of (mirrored (divisor s)) (cosine s)) /\
  (c + 1 = length (divisor s) + middle (cosine s))%nat /\ (1 <= length (factor s))%nat /\
  norm1 (snd (difference_of s)) <= 2 * nth (fst (difference_of s)) (snd (difference_of s)) 0.
Proof.
  assert (H := Right). unfold sum_of_squares in H. destruct (difference_of s) as [mid e] eqn:E. cbv zeta in H. repeat rewrite andb_true_iff in H.
  destruct H as [[[[[[[[[[H1 H2] H3] H4] H5] H6] H7] H8] H9] H10] H11]. cbn [fst snd].
  apply Nat.leb_le in H1, H2, H5, H10. apply same_spec in H3, H8. apply Nat.eqb_eq in H4, H9. apply Z.ltb_lt in H7. apply Z.leb_le in H11.
  repeat split; auto.
Qed.

Lemma D_positive : (0 < IZR D)%R.
Proof. apply denominator_positive; auto. Qed.

Lemma symbol_support i : i < 0 \/ Z.of_nat N < i -> symbol_at i = 0%R.
Proof.
  intros H. unfold symbol_at. destruct (Z.ltb_spec i 0); auto. rewrite nth_overflow. unfold Rdiv; ring.
  destruct facts as [_ [_ [_ [L _]]]]. unfold N in H. lia.
Qed.

Lemma matrices_right t j k : (t < A)%nat -> (j < W)%nat -> (k < W)%nat -> real F t j k = scheme_matrix A symbol_at t j k.
Proof.
  intros Ht Hj Hk. destruct facts as [_ [_ [_ [_ [_ [T _]]]]]]. unfold is_transition in T. rewrite forallb_forall in T.
  specialize (T t ltac:(apply in_seq; unfold A in *; lia)). rewrite forallb_forall in T. specialize (T j ltac:(apply in_seq; unfold W in *; lia)).
  cbv zeta in T. rewrite forallb_forall in T. specialize (T k ltac:(apply in_seq; unfold W in *; lia)). apply Z.eqb_eq in T.
  unfold real, mr. rewrite T. fold A b D. unfold scheme_matrix, symbol_at.
  destruct (Nat.leb_spec k (A * j + t)), (Z.ltb_spec (Z.of_nat A * Z.of_nat j + Z.of_nat t - Z.of_nat k) 0); try lia.
  - do 3 f_equal. lia.
  - unfold Rdiv. ring.
Qed.

Lemma growth_same r : growth W A (real F) r <-> growth W A (scheme_matrix A symbol_at) r.
Proof.
  assert (E : forall w, letters A w -> forall i j, (i < W)%nat -> (j < W)%nat -> product W (real F) w i j = product W (scheme_matrix A symbol_at) w i j).
  { induction w; intros Hw i j Hi Hj; auto. inversion Hw; subst. cbn [product]. unfold times. apply sum_ext; intros k Hk. rewrite matrices_right, IHw; auto. }
  split; intros [C H]; exists C; intros w Hw i j Hi Hj; [rewrite <- E|rewrite E]; auto.
Qed.

(* ---- the powers of the scheme, centred --------------------------------------------------------------------------- *)

Definition centred (i : Z) : R := symbol_at (i - (- Z.of_nat c)).
Definition powers : nat -> Z -> R := refined A (- Z.of_nat c) N centred.

Lemma power_shifted n i : power A N symbol_at n i = powers n (i + shift A (- Z.of_nat c) n).
Proof.
  destruct facts as [HA [HW [_ [_ [HN _]]]]]. unfold powers, centred.
  rewrite (refined_power A N W symbol_at HA symbol_support HN HW N (le_n N)). f_equal. lia.
Qed.

Lemma step_back f i : subdivide A (- Z.of_nat c) N centred f i = (/ IZR D * back (reals b) (spread A f) (i + Z.of_nat c))%R.
Proof.
  destruct facts as [HA [_ [_ [L _]]]]. assert (PD := D_positive). assert (ZA : 0 < Z.of_nat A) by lia.
  set (v := i + Z.of_nat c). set (Q := v / Z.of_nat A). set (rho := Z.to_nat (v mod Z.of_nat A)).
  assert (V : v = Z.of_nat A * Q + Z.of_nat rho). { unfold Q, rho. rewrite Z2Nat.id by (apply Z.mod_pos_bound; lia). apply Z.div_mod. lia. }
  assert (Rh : (rho < A)%nat). { unfold rho. assert (B := Z.mod_pos_bound v (Z.of_nat A) ZA). lia. }
  unfold subdivide. replace (i - - Z.of_nat c) with v by (unfold v; lia). fold Q.
  rewrite sum_reverse. rewrite (back_sum _ _ _ (rho + S N * A)) by (rewrite reals_length; unfold N; nia).
  rewrite sum_add, (sum_zero rho), Rplus_0_l.
  - rewrite sum_blocks, <- sum_scal. apply sum_ext. intros j Hj. cbv zeta.
    rewrite (sum_ext A _ (fun t => identity t 0%nat * (IZR (nth (rho + j * A)%nat b 0%Z) * f (Q - Z.of_nat j)%Z))%R).
    + rewrite sum_identity by lia. unfold centred, symbol_at.
      replace (Q - Z.of_nat N + Z.of_nat (S N - 1 - j)) with (Q - Z.of_nat j) by lia.
      replace (i - Z.of_nat A * (Q - Z.of_nat j) - - Z.of_nat c) with (Z.of_nat (rho + j * A)) by (rewrite Nat2Z.inj_add, Nat2Z.inj_mul; unfold v in V; lia).
      destruct (Z.ltb_spec (Z.of_nat (rho + j * A)) 0); [lia|]. rewrite Nat2Z.id. unfold Rdiv. ring.
    + intros t Ht. rewrite nth_reals. unfold identity, spread. replace (v - Z.of_nat (rho + (j * A + t))) with ((Q - Z.of_nat j) * Z.of_nat A - Z.of_nat t)
        by (rewrite !Nat2Z.inj_add, Nat2Z.inj_mul; lia).
      destruct (Nat.eqb_spec t 0) as [->|T].
      * rewrite Nat.add_0_r, Z.sub_0_r, Z.mod_mul, Z.div_mul by lia. simpl. ring.
      * destruct (Z.eqb_spec (((Q - Z.of_nat j) * Z.of_nat A - Z.of_nat t) mod Z.of_nat A) 0) as [E|E]; [|ring]. exfalso.
        apply Z.mod_divide in E; [|lia]. destruct E as [d E]. assert (Z.of_nat t = (Q - Z.of_nat j - d) * Z.of_nat A) by lia.
        set (g := Q - Z.of_nat j - d) in *. destruct (Z_le_gt_dec g 0); nia.
  - intros k Hk. unfold spread. replace (v - Z.of_nat k) with (Q * Z.of_nat A + Z.of_nat (rho - k)) by lia.
    destruct (Z.eqb_spec ((Q * Z.of_nat A + Z.of_nat (rho - k)) mod Z.of_nat A) 0) as [E|E]; [|ring]. exfalso.
    rewrite Z.add_comm, Z.mod_add, Z.mod_small in E by lia. lia.
Qed.

(* One step keeps what makes the middle the largest. *)
Lemma step_even f : even f -> even (subdivide A (- Z.of_nat c) N centred f).
Proof.
  intros E i. destruct facts as [HA [_ [Sym [L _]]]]. rewrite !step_back. f_equal.
  assert (ES : even (spread A f)) by (apply even_spread; auto; lia).
  assert (R : forall j, back (reals b) (spread A f) (j + Z.of_nat (length b) - 1) = ahead (reals b) (spread A f) j).
  { intros j. rewrite <- (reals_length b). rewrite Sym at 1. unfold reals at 1. rewrite map_rev. fold (reals b). apply back_rev. }
  transitivity (ahead (reals b) (spread A f) (- (i + Z.of_nat c))).
  - rewrite <- R. f_equal. lia.
  - apply even_move. auto.
Qed.

Lemma step_positive f : even f -> positive f -> positive (subdivide A (- Z.of_nat c) N centred f).
Proof.
  intros E P. destruct facts as [HA [_ [_ [L [_ [_ [HC [HB [HM [HF HE]]]]]]]]]]. assert (PD := D_positive).
  set (g := spread A f). assert (Eg : even g) by (apply even_spread; auto; lia). assert (Pg : positive g) by (apply positive_spread; auto; lia).
  set (h := fun i => back (reals (cosine s)) g (i + Z.of_nat (middle (cosine s)))).
  assert (H : positive h).
  { unfold difference_of in HE. cbv zeta in HE. cbn [fst snd] in HE. set (m := middle (cosine s)) in *. set (d := (length (factor s) - 1)%nat) in *.
    set (mid := Nat.max m d) in *. set (e := addmul _ _ _) in *.
    assert (Q4 : (0 < IZR (4 ^ Z.of_nat (bits s)))%R) by (apply IZR_lt, Z.pow_pos_nonneg; lia). set (k := IZR (4 ^ Z.of_nat (bits s))) in *.
    assert (Pe : positive (fun i => back (reals e) g (i + Z.of_nat mid))).
    { apply positive_dominant; auto. rewrite nth_reals, <- mult_IZR. eapply Rle_trans; [|apply IZR_le; apply HE].
      right. rewrite (norm1_sum e (length e)) by auto. rewrite reals_length. unfold norm, vr. apply sum_ext. intros j _. rewrite nth_reals. auto. }
    assert (Pf := positive_square (reals (factor s)) g Pg).
    assert (Eh : h = (fun i => / k * back (reals e) g (i + Z.of_nat mid) + / k * ahead (reals (factor s)) (back (reals (factor s)) g) i)%R).
    { extensionality i. unfold e. rewrite back_addmul, back_times, !reals_repeat, !back_padded.
      replace (i + Z.of_nat mid - Z.of_nat (mid - m)) with (i + Z.of_nat m) by lia.
      replace (i + Z.of_nat mid - Z.of_nat (mid - d)) with (i + Z.of_nat (length (factor s)) - 1) by lia. rewrite back_mirrored.
      fold k. fold (h i). field. lra. }
    rewrite Eh. apply positive_sum; auto; left; apply Rinv_0_lt_compat; auto. }
  replace (subdivide A (- Z.of_nat c) N centred f) with
    (fun i => (IZR (content s) / IZR D) * ahead (reals (divisor s)) (back (reals (divisor s)) h) i + 0 * f i)%R.
  - apply positive_sum; auto. left. apply Rdiv_lt_0_compat; auto. apply IZR_lt; auto. lra. apply positive_square. auto.
  - extensionality i. rewrite step_back. rewrite HB, back_times, back_zproduct. fold g.
    rewrite <- back_mirrored. unfold h. rewrite back_move. 
    replace (i + Z.of_nat (length (divisor s)) - 1 + Z.of_nat (middle (cosine s))) with (i + Z.of_nat c) by lia. unfold Rdiv. ring.
Qed.

Theorem powers_central n i : (Rabs (powers n i) <= powers n 0)%R.
Proof.
  apply central; revert i.
  - intros _. induction n. apply even_delta. apply step_even. auto.
  - intros _. assert (forall n, even (powers n) /\ positive (powers n)) as G; [|apply G]. clear n. induction n.
    split. apply even_delta. apply positive_delta. destruct IHn. split. apply step_even; auto. apply step_positive; auto.
Qed.

(* ---- the recurrence ---------------------------------------------------------------------------------------------- *)

Let r := reach_of A b.
Let S1 := (2 * r + 1)%nat.
Let M := central_matrix A b.

Definition against (y : zvec) (f : Z -> R) : R := sum S1 (fun i => vr y i * f (Z.of_nat i - Z.of_nat r)%Z)%R.

Lemma against_step y f : against y (subdivide A (- Z.of_nat c) N centred f) = (/ IZR D * against (mv M y) f)%R.
Proof.
  destruct facts as [HA [_ [_ [L _]]]]. assert (PD := D_positive). unfold against.
  assert (Rr : (c < (r + 1) * (A - 1))%nat).
  { unfold r, reach_of. fold c. assert (Dv := Nat.div_mod c (A - 1) ltac:(lia)). assert (Mb := Nat.mod_upper_bound c (A - 1) ltac:(lia)). nia. }
  rewrite (sum_ext S1 _ (fun i => sum S1 (fun j => (/ IZR D * (vr y i * (mr M j i * f (Z.of_nat j - Z.of_nat r)%Z))))%R)).
  - rewrite sum_swap, <- sum_scal. apply sum_ext. intros j Hj. rewrite (vr_mv S1) by apply square_table. unfold apply.
    rewrite sum_scal. f_equal. rewrite (Rmult_comm (sum S1 _)), <- sum_scal. apply sum_ext. intros. ring.
  - intros i Hi. rewrite sum_scal, sum_scal.
    rewrite <- (subdivide_window A (- Z.of_nat c) N HA N centred f _ (- Z.of_nat r) S1).
    + rewrite <- Rmult_assoc, (Rmult_comm (/ IZR D)), Rmult_assoc. f_equal. rewrite <- sum_scal. apply sum_ext. intros j Hj.
      replace (- Z.of_nat r + Z.of_nat j) with (Z.of_nat j - Z.of_nat r) by lia. rewrite <- Rmult_assoc. f_equal.
      unfold centred, symbol_at, mr, M, central_matrix. cbv zeta. fold r c S1. rewrite entry_table by auto.
      assert (EA : Z.of_nat ((A - 1) * r) = Z.of_nat A * Z.of_nat r - Z.of_nat r) by (rewrite Nat2Z.inj_mul, Nat2Z.inj_sub by lia; ring).
      assert (EJ : Z.of_nat (A * j) = Z.of_nat A * Z.of_nat j) by apply Nat2Z.inj_mul.
      destruct (Z.ltb_spec (Z.of_nat i - Z.of_nat r - Z.of_nat A * (Z.of_nat j - Z.of_nat r) - - Z.of_nat c) 0), (Nat.leb_spec (A * j) (c + i + (A - 1) * r)); try (exfalso; lia).
      * ring.
      * unfold Rdiv. rewrite Rmult_comm. do 3 f_equal. lia.
    + intros j Hj. unfold centred. apply symbol_support. lia.
    + lia.
    + intros j Hj. unfold centred. apply symbol_support. assert (EL : Z.of_nat N = 2 * Z.of_nat c) by (unfold N; lia).
      assert (Z.of_nat c < (Z.of_nat r + 1) * (Z.of_nat A - 1)) by nia. unfold S1 in *.
      destruct Hj as [Hj|Hj]; [right|left]; nia.
Qed.

Lemma against_addmul a x y f : against (addmul a x y) f = (IZR a * against x f + against y f)%R.
Proof. unfold against. rewrite <- sum_scal, <- sum_plus. apply sum_ext. intros i _. rewrite vr_addmul. unfold plus, scal. ring. Qed.

Lemma against_nil f : against [] f = 0%R.
Proof. unfold against. apply sum_zero. intros. rewrite vr_nil. unfold zero. ring. Qed.

Lemma against_unit f : against (unit_at 1 r) f = f 0.
Proof.
  unfold against. rewrite (sum_ext S1 _ (fun i => identity i r * f (Z.of_nat i - Z.of_nat r)%Z)%R).
  - rewrite sum_identity by (unfold S1; lia). f_equal. lia.
  - intros i _. rewrite vr_unit. unfold scal, unit. ring.
Qed.

Definition moments (n : nat) : R := powers n 0.

Lemma applied_sound p : let '(k, v) := applied M D (unit_at 1 r) p in (0 < IZR k)%R /\
  forall n, against v (powers n) = (IZR k * along 0 (reals p) moments n)%R.
Proof.
  assert (PD := D_positive). induction p as [|a p IH]; cbn [applied reals map along].
  - split. lra. intros n. rewrite against_nil. ring.
  - fold (reals p). destruct (applied M D (unit_at 1 r) p) as [k v]. destruct IH as [K IH].
    split. rewrite mult_IZR. apply Rmult_lt_0_compat; auto. intros n.
    rewrite against_addmul, against_unit, !mult_IZR.
    assert (E : against (mv M v) (powers n) = (IZR D * against v (powers (S n)))%R).
    { change (powers (S n)) with (subdivide A (- Z.of_nat c) N centred (powers n)). rewrite against_step. field. lra. }
    rewrite E, IH. unfold step, moments. ring.
Qed.

Lemma recurs_sound p : recurs F b p = true -> forall n, along 0 (reals p) moments n = 0%R.
Proof.
  intros H n. unfold recurs in H. fold A D r M in H. assert (S := applied_sound p). destruct (applied M D (unit_at 1 r) p) as [k v].
  destruct S as [K S]. specialize (S n). replace (against v (powers n)) with 0%R in S.
  - symmetry in S. apply Rmult_integral in S. destruct S; auto. lra.
  - unfold against. symmetry. apply sum_zero. intros i _. rewrite forallb_forall in H. unfold vr.
    destruct (nth_in_or_default i v 0) as [I | ->]. apply H, Z.eqb_eq in I. rewrite <- I. ring. ring.
Qed.

Lemma moments_nonnegative n : (0 <= moments n)%R.
Proof. eapply Rle_trans; [|apply (powers_central n 0)]. apply Rabs_pos. Qed.

(* The growth of the middle and that of products are the same. *)
Lemma moments_growth g : (0 < g)%R -> grows moments g <-> growth W A (real F) g.
Proof.
  intros Hg. destruct facts as [HA [HW [_ [L [HN _]]]]]. rewrite growth_same. split.
  - intros [C H]. exists C. intros w Hw j k Hj Hk.
    rewrite (product_coefficient A N W symbol_at HA symbol_support HN HW w Hw j k Hj Hk), power_shifted.
    eapply Rle_trans. apply powers_central. specialize (H (length w)). eapply Rle_trans; [|apply H]. apply Rle_abs.
  - intros H. destruct (coefficients_bounded A N W symbol_at HA symbol_support HN HW g Hg H) as [C HC]. exists C. intros n.
    specialize (HC n (0 - shift A (- Z.of_nat c) n)). rewrite power_shifted in HC.
    replace (0 - shift A (- Z.of_nat c) n + shift A (- Z.of_nat c) n) with 0 in HC by lia. exact HC.
Qed.

Lemma moments_grow : exists k, (0 <= k)%R /\ grows moments k.
Proof.
  destruct (radius_exists W A (real F)) as [x [X [G _]]]. exists (x + 1)%R. split. lra. apply moments_growth. lra. apply G. lra.
Qed.

Theorem single_bound p u : (forall n, along 0 (reals p) moments n = 0%R) -> (0 <= u)%R ->
  nonnegative (pshift u (reals p)) -> (exists i, (0 < nth i (pshift u (reals p)) 0)%R) -> radius_at_most W A (real F) u.
Proof.
  intros Rec U P0 P1 g Hg G0. apply moments_growth; auto.
  apply (recurrence_growth u (pshift u (reals p)) moments U P0 P1 moments_nonnegative); auto.
  - intros n. rewrite <- (Rplus_0_l u) at 1. rewrite along_shift. auto.
  - apply moments_grow.
Qed.
End Squares.

(* ---- the shifted polynomial -------------------------------------------------------------------------------------- *)

Lemma shifted_sound a q p : 0 < q -> let '(k, s) := shifted_by a q p in (0 < IZR k)%R /\
  forall i, (IZR (nth i s 0%Z) * IZR q ^ i = IZR k * nth i (pshift (IZR a / IZR q) (reals p)) 0)%R.
Proof.
  intros Hq. apply IZR_lt in Hq. induction p as [|c p IH]; cbn [shifted_by].
  - split. lra. intros i. destruct i; simpl; ring.
  - destruct (shifted_by a q p) as [k s]. destruct IH as [K IH]. split. rewrite mult_IZR. apply Rmult_lt_0_compat; auto.
    intros i. change (reals (c :: p)) with (IZR c :: reals p). rewrite nth_pshift.
    assert (V := f_equal (fun f => f i) (vr_addmul a s (c * (k * q) :: s))). unfold vr, plus, scal in V. rewrite V.
    assert (I := IH i). rewrite mult_IZR. destruct i.
    + simpl in I |- *. rewrite !mult_IZR. transitivity (IZR a * (IZR (nth 0 s 0%Z) * 1) + IZR c * (IZR k * IZR q))%R. ring. rewrite I. field. lra.
    + cbn [nth]. specialize (IH i). set (v := nth (S i) s 0) in *. transitivity (IZR a * (IZR v * IZR q ^ S i) + IZR q * (IZR (nth i s 0%Z) * IZR q ^ i))%R.
      simpl; ring. rewrite I, IH. field. lra.
Qed.

Lemma no_negative_sound a q p : 0 < q -> no_negative (snd (shifted_by a q p)) = true ->
  nonnegative (pshift (IZR a / IZR q) (reals p)) /\ exists i, (0 < nth i (pshift (IZR a / IZR q) (reals p)) 0)%R.
Proof.
  intros Hq H. assert (S := shifted_sound a q p Hq). destruct (shifted_by a q p) as [k s]. destruct S as [K S]. cbn [snd] in H.
  apply IZR_lt in Hq. apply andb_prop in H. destruct H as [H1 H2]. rewrite forallb_forall in H1. apply existsb_exists in H2.
  assert (Pow : forall i, (0 < IZR q ^ i)%R) by (intros; apply pow_lt; auto). split.
  - intros i. specialize (S i). apply (Rmult_le_reg_l (IZR k)); auto. rewrite Rmult_0_r, <- S. apply Rmult_le_pos; [|left; auto].
    apply IZR_le. destruct (nth_in_or_default i s 0) as [I | ->]; [|lia]. apply H1, Z.leb_le in I. auto.
  - destruct H2 as [x [I X]]. apply Z.ltb_lt in X. apply (In_nth s x 0) in I. destruct I as [i [_ E]]. exists i. specialize (S i). rewrite E in S.
    apply (Rmult_lt_reg_l (IZR k)); auto. rewrite Rmult_0_r, <- S. apply Rmult_lt_0_compat; auto. apply IZR_lt; auto.
Qed.

Lemma shifted_opposite a q p : snd (shifted_by a q (map (Z.mul (-1)) p)) = map (Z.mul (-1)) (snd (shifted_by a q p)) /\
  fst (shifted_by a q (map (Z.mul (-1)) p)) = fst (shifted_by a q p).
Proof.
  induction p as [|c p IH]; auto. cbn [map shifted_by]. destruct (shifted_by a q p) as [k s], (shifted_by a q (map (Z.mul (-1)) p)) as [k' s'].
  cbn [fst snd] in *. destruct IH as [-> ->]. split; auto.
  assert (E : forall x y, addmul a (map (Z.mul (-1)) x) (map (Z.mul (-1)) y) = map (Z.mul (-1)) (addmul a x y)).
  { induction x; intros y; auto. destruct y; cbn [map addmul]; f_equal; try ring; [apply (IHx [])|apply IHx]. }
  rewrite <- E. cbn [map]. do 2 f_equal. ring.
Qed.

Lemma along_opposite u p m n : along u (reals (map (Z.mul (-1)) p)) m n = (- along u (reals p) m n)%R.
Proof.
  replace (reals (map (Z.mul (-1)) p)) with (pscal (-1) (reals p)). rewrite along_pscal. ring.
  unfold pscal, reals. rewrite !map_map. apply map_ext. intros a. rewrite mult_IZR. auto.
Qed.

Theorem single_sound F u s p : well_formed F = true -> single_section F u s p = true ->
  radius_at_most (size F) (count F) (real F) (real_of u).
Proof.
  intros WF H. unfold single_section in H. repeat rewrite andb_true_iff in H. destruct H as [[[H1 H2] H3] H4].
  apply Z.leb_le, IZR_le in H3. assert (Rec := recurs_sound F s WF H1 p H2).
  assert (U : (0 <= real_of u)%R). { apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat, IZR_lt. lia. }
  apply orb_prop in H4. destruct H4 as [H4|H4].
  - apply no_negative_sound in H4; [|lia]. destruct H4. apply (single_bound F s WF H1 p); auto.
  - rewrite <- (proj1 (shifted_opposite _ _ p)) in H4. apply no_negative_sound in H4; [|lia]. destruct H4.
    apply (single_bound F s WF H1 (map (Z.mul (-1)) p)); auto. intros n. rewrite along_opposite, Rec. ring.
Qed.
