(* Vectors of functions: continuous solutions of compact support of phi(x) = sum of A_k phi(A x - k), one but for a factor, and
   the Hoelder exponent of their worst component from below (SPEC.md, sections 5.6 and 5.9, Theorems 14 and 42). *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision Coefficients Grid.
Import ListNotations.
Open Scope R_scope.

(* ---- definitions: what the theorems are about ------------------------------------------------------------------ *)

(* The mask has the matrices a first, ..., a (first + length), of size r: a k c d is the entry in row c, column d. The sum of
   a k u k over these k, component c of it: *)
Definition mix (r : nat) (first : Z) (length : nat) (a : Z -> nat -> nat -> R) (u : Z -> nat -> R) (c : nat) : R :=
  sum (S length) (fun m => let k := (first + Z.of_nat m)%Z in sum r (fun d => a k c d * u k d)).

(* A vector of r continuous functions that are 0 outside of an interval and satisfy the equation; component c is phi c. *)
Definition is_solution (A r : nat) (first : Z) (length : nat) (a : Z -> nat -> nat -> R) (phi : nat -> R -> R) : Prop :=
  (forall c, (c < r)%nat -> continuity (phi c)) /\
  (exists S, forall c x, (c < r)%nat -> x < - S \/ S < x -> phi c x = 0) /\
  forall c x, (c < r)%nat -> phi c x = mix r first length a (fun k d => phi d (INR A * x - IZR k)) c.

(* One that is not 0; all others are its multiples, and the exponent of each component is at least l. *)
Definition solution_at_least (A r : nat) (first : Z) (length : nat) (a : Z -> nat -> nat -> R) (phi : nat -> R -> R) (l : R) : Prop :=
  is_solution A r first length a phi /\ (exists c x, (c < r)%nat /\ phi c x <> 0) /\
  (forall psi, is_solution A r first length a psi -> exists z, forall c x, (c < r)%nat -> psi c x = z * phi c x) /\
  forall c, (c < r)%nat -> exponent_at_least (phi c) l.
Definition one_solution (A r : nat) (first : Z) (length : nat) (a : Z -> nat -> nat -> R) (l : R) : Prop :=
  exists phi, solution_at_least A r first length a phi l.

(* ---- sequences of vectors ---------------------------------------------------------------------------------------- *)

Section Refinable.
Variables (A r : nat) (F : Z) (L : nat) (a : Z -> nat -> nat -> R).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.
Notation blend := (mix r F L a).
Definition vectors := Z -> nat -> R.

Lemma mix_ext u v c : (forall k d, (d < r)%nat -> u k d = v k d) -> blend u c = blend v c.
Proof. intros H. apply sum_ext; intros m _. cbv zeta. apply sum_ext; intros d Hd. rewrite H; auto. Qed.

Lemma mix_zero u c : (forall m d, (m < S L)%nat -> (d < r)%nat -> u (F + Z.of_nat m)%Z d = 0) -> blend u c = 0.
Proof. intros H. apply sum_zero; intros m Hm. cbv zeta. apply sum_zero; intros d Hd. rewrite H by auto. ring. Qed.

Lemma mix_minus u v c : blend (fun k d => u k d - v k d) c = blend u c - blend v c.
Proof.
  unfold mix. rewrite <- sum_minus. apply sum_ext; intros m _. cbv zeta. rewrite <- sum_minus. apply sum_ext; intros. ring.
Qed.

Lemma mix_scal z u c : blend (fun k d => z * u k d) c = z * blend u c.
Proof. unfold mix. rewrite <- sum_scal. apply sum_ext; intros m _. cbv zeta. rewrite <- sum_scal. apply sum_ext; intros. ring. Qed.

Lemma mix_sum n (y : nat -> R) (u : nat -> vectors) c :
  blend (fun k d => sum n (fun i => y i * u i k d)) c = sum n (fun i => y i * blend (u i) c).
Proof.
  induction n; cbn [sum]. apply mix_zero. auto.
  rewrite <- IHn, <- mix_scal. unfold mix. rewrite <- sum_plus. apply sum_ext; intros m _. cbv zeta. rewrite <- sum_plus.
  apply sum_ext; intros. ring.
Qed.

(* What one step enlarges at most *)
Definition most : R := 1 + sum r (fun c => sum (S L) (fun m => sum r (fun d => Rabs (a (F + Z.of_nat m)%Z c d)))).

Lemma most_least : 1 <= most.
Proof.
  unfold most. assert (0 <= sum r (fun c => sum (S L) (fun m => sum r (fun d => Rabs (a (F + Z.of_nat m)%Z c d))))); [|lra].
  apply sum_nonneg; intros. apply sum_nonneg; intros. apply sum_nonneg; intros. apply Rabs_pos.
Qed.

Lemma mix_bound u B c : (c < r)%nat -> 0 <= B -> (forall k d, (d < r)%nat -> Rabs (u k d) <= B) -> Rabs (blend u c) <= most * B.
Proof.
  intros Hc HB H. apply Rle_trans with (sum (S L) (fun m => sum r (fun d => Rabs (a (F + Z.of_nat m)%Z c d))) * B).
  - unfold mix. rewrite Rmult_comm, <- sum_scal. eapply Rle_trans. apply sum_abs. apply sum_le; intros m _. cbv zeta.
    rewrite <- sum_scal. eapply Rle_trans. apply sum_abs. apply sum_le; intros d Hd. rewrite Rabs_mult, Rmult_comm.
    apply Rmult_le_compat_r. apply Rabs_pos. auto.
  - apply Rmult_le_compat_r; auto. unfold most.
    assert (T := sum_term r (fun c => sum (S L) (fun m => sum r (fun d => Rabs (a (F + Z.of_nat m)%Z c d)))) c). cbv beta in T.
    assert (sum (S L) (fun m => sum r (fun d => Rabs (a (F + Z.of_nat m)%Z c d))) <=
      sum r (fun c => sum (S L) (fun m => sum r (fun d => Rabs (a (F + Z.of_nat m)%Z c d))))); [|lra].
    apply T; auto. intros. apply sum_nonneg; intros. apply sum_nonneg; intros. apply Rabs_pos.
Qed.

(* The values of n levels from those at the integers *)
Fixpoint values (u : vectors) (n : nat) : vectors :=
  match n with O => u | S m => fun i c => blend (fun k d => values u m (i - ZA ^ Z.of_nat m * k)%Z d) c end.

Definition transit (t : nat) (u : vectors) : vectors := fun j c => blend (fun k d => u (ZA * j + Z.of_nat t - k)%Z d) c.
Fixpoint after (w : list nat) (u : vectors) : vectors := match w with [] => u | t :: w' => transit t (after w' u) end.

Lemma values_ext u v n : (forall i c, (c < r)%nat -> u i c = v i c) -> forall i c, (c < r)%nat -> values u n i c = values v n i c.
Proof. intros H. induction n; intros i c Hc; cbn [values]; auto. apply mix_ext. intros. apply IHn; auto. Qed.

Lemma values_step n : forall u t i c, values u (S n) (ZA * i + Z.of_nat t)%Z c = values (transit t u) n i c.
Proof.
  induction n; intros u t i c.
  - cbn [values]. unfold transit. apply mix_ext. intros k d _. f_equal. change (ZA ^ Z.of_nat 0)%Z with 1%Z. ring.
  - change (values u (S (S n)) (ZA * i + Z.of_nat t)%Z c) with
      (blend (fun k d => values u (S n) (ZA * i + Z.of_nat t - ZA ^ Z.of_nat (S n) * k)%Z d) c).
    cbn [values]. apply mix_ext. intros k d _. rewrite <- IHn. cbn [values]. f_equal.
    rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. extensionality k'. extensionality d'. f_equal. ring.
Qed.

Lemma values_after u w : forall j c, values u (length w) (ZA ^ Z.of_nat (length w) * j + offset A w)%Z c = after w u j c.
Proof.
  induction w as [|t w IH]; intros j c.
  - cbn [length values after offset]. change (ZA ^ Z.of_nat 0)%Z with 1%Z. f_equal. ring.
  - cbn [length values after offset]. unfold transit. apply mix_ext. intros k d _. rewrite <- IH. f_equal.
    fold ZA. rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. ring.
Qed.

Lemma after_app w v u : after (w ++ v) u = after w (after v u).
Proof. induction w; simpl; auto. rewrite IHw. auto. Qed.

Lemma values_word n i : exists w j, letters A w /\ length w = n /\ forall u c, values u n i c = after w u j c.
Proof.
  assert (P : (0 < ZA ^ Z.of_nat n)%Z) by (apply Z.pow_pos_nonneg; unfold ZA; lia).
  destruct (offset_onto A Arity n (i mod ZA ^ Z.of_nat n)%Z (Z.mod_pos_bound i _ P)) as [w [Hw [Hl Ho]]].
  exists w, (i / ZA ^ Z.of_nat n)%Z. split; auto. split; auto. intros u c. rewrite <- values_after, Hl, Ho. f_equal.
  apply Z.div_mod. lia.
Qed.

Lemma after_bound w : forall u B, 0 <= B -> (forall i c, (c < r)%nat -> Rabs (u i c) <= B) ->
  forall i c, (c < r)%nat -> Rabs (after w u i c) <= most ^ length w * B.
Proof.
  assert (M1 := most_least). induction w as [|t w IH]; intros u B HB H i c Hc.
  - simpl. rewrite Rmult_1_l. auto.
  - cbn [after length]. rewrite <- tech_pow_Rmult, Rmult_assoc. apply mix_bound; auto.
    apply Rmult_le_pos; auto. apply pow_le; lra.
Qed.

(* Differences *)
Definition difference (u : vectors) : vectors := fun i c => u i c - u (i - 1)%Z c.
Fixpoint vector_differences (m : nat) (u : vectors) : vectors := match m with O => u | S k => difference (vector_differences k u) end.

Lemma values_difference u n : forall i c, values (difference u) n i c = values u n i c - values u n (i - 1)%Z c.
Proof.
  induction n; intros i c. reflexivity. cbn [values]. rewrite <- mix_minus. apply mix_ext. intros k d _. rewrite IHn.
  f_equal. f_equal. ring.
Qed.

Lemma values_differences u n m : forall i c, values (vector_differences m u) n i c = differences m (fun i => values u n i c) i.
Proof. induction m; intros i c. reflexivity. cbn [vector_differences differences]. rewrite values_difference, !IHm. auto. Qed.

(* ---- a space that the transitions map to itself ------------------------------------------------------------------ *)

Section Space.
Variables (N : nat) (b : nat -> vectors) (T : nat -> mat).
Hypothesis Invariant : forall t k, (t < A)%nat -> (k < N)%nat -> forall j c, (c < r)%nat ->
  transit t (b k) j c = sum N (fun l => T t l k * b l j c).
Variable P : R.
Hypothesis Basis : forall k, (k < N)%nat -> forall j c, (c < r)%nat -> Rabs (b k j c) <= P.
Definition span (y : vec) : vectors := fun j c => sum N (fun k => y k * b k j c).

Lemma after_span w : letters A w -> forall u y, (forall j c, (c < r)%nat -> u j c = span y j c) ->
  forall j c, (c < r)%nat -> after w u j c = span (run N T w y) j c.
Proof.
  induction w as [|t w IH]; intros Hw u y Hu j c Hc. apply Hu; auto. inversion Hw; subst.
  cbn [after run]. unfold transit.
  rewrite (mix_ext _ (fun k d => span (run N T w y) (ZA * j + Z.of_nat t - k)%Z d)) by (intros; apply IH; auto).
  unfold span. rewrite mix_sum. set (x := run N T w y).
  rewrite (sum_ext N _ (fun i => sum N (fun l => x i * (T t l i * b l j c)))).
  - rewrite sum_swap. apply sum_ext; intros l Hl. unfold apply. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros. ring.
  - intros i Hi. rewrite sum_scal. f_equal. rewrite <- Invariant; auto.
Qed.

Variables (u : vectors) (start : nat) (B : R).
Hypothesis Bounded : forall i c, (c < r)%nat -> Rabs (u i c) <= B.
Hypothesis Enters : forall w, letters A w -> length w = start -> exists y, forall j c, (c < r)%nat -> after w u j c = span y j c.

Lemma all_words (Q : list nat -> R -> Prop) n : (forall w x y, x <= y -> Q w x -> Q w y) ->
  (forall w, letters A w -> length w = n -> exists x, Q w x) -> exists x, 0 <= x /\ forall w, letters A w -> length w = n -> Q w x.
Proof.
  intros Mono. revert Q Mono. induction n; intros Q Mono H.
  - destruct (H []) as [x Hx]; auto. constructor. exists (Rmax x 0). split. apply Rmax_r. intros w _ Hl. destruct w; [|discriminate].
    apply (Mono _ x); auto. apply Rmax_l.
  - assert (E : forall t, (t < A)%nat -> exists x, 0 <= x /\ forall w, letters A w -> length w = n -> Q (t :: w) x).
    { intros t Ht. apply (IHn (fun w => Q (t :: w))). intros. eapply Mono; eauto.
      intros w Hw Hl. apply H. constructor; auto. simpl; auto. }
    assert (G : forall q, (q <= A)%nat -> exists x, 0 <= x /\ forall t w, (t < q)%nat -> letters A w -> length w = n -> Q (t :: w) x).
    { induction q; intros Hq. exists 0. split. lra. intros; lia.
      destruct (IHq ltac:(lia)) as [x [X0 Hx]]. destruct (E q ltac:(lia)) as [y [Y0 Hy]]. exists (x + y). split. lra.
      intros t w Ht Hw Hl. destruct (Nat.eq_dec t q) as [->|]. apply (Mono _ y); auto; lra. apply (Mono _ x); auto. lra. apply Hx; auto. lia. }
    destruct (G A (le_n A)) as [x [X0 Hx]]. exists x. split; auto. intros w Hw Hl. destruct w as [|t w]; [discriminate|].
    inversion Hw; subst. apply Hx; auto.
Qed.

(* So values of a component that enter the space shrink as those of its products do. *)
Theorem component_shrinks c g : 0 < g <= 1 -> (c < r)%nat ->
  (forall Y, 0 <= Y -> exists K, 0 <= K /\ forall w y, letters A w -> (forall k, (k < N)%nat -> Rabs (y k) <= Y) ->
    forall j, Rabs (span (run N T w y) j c) <= K * g ^ length w) ->
  exists C, forall n i, Rabs (values u n i c) <= C * g ^ n.
Proof.
  intros Hg Hc Readings. assert (M1 := most_least).
  destruct (all_words (fun w x => exists y, (forall k, (k < N)%nat -> Rabs (y k) <= x) /\
    forall j c, (c < r)%nat -> after w u j c = span y j c) start) as [Y [Y0 HY]].
  { intros w x y Hxy [z [Hz E]]. exists z. split; auto. intros k Hk. eapply Rle_trans. apply Hz; auto. auto. }
  { intros w Hw Hl. destruct (Enters w Hw Hl) as [y Hy]. exists (norm N y), y. split; auto. intros. apply norm_term; auto. }
  destruct (Readings Y Y0) as [K [K0 HK]]. set (B' := Rmax B 0). assert (BP : 0 <= B') by apply Rmax_r.
  assert (GS : 0 < g ^ start) by (apply pow_lt; lra).
  set (D1 := most ^ start * B' / g ^ start). set (D2 := K / g ^ start).
  assert (D1P : 0 <= D1). { unfold D1. apply Rmult_le_pos. apply Rmult_le_pos; auto. apply pow_le; lra. left; apply Rinv_0_lt_compat; auto. }
  assert (D2P : 0 <= D2). { unfold D2. apply Rmult_le_pos; auto. left; apply Rinv_0_lt_compat; auto. }
  exists (D1 + D2). intros n i. assert (Gn : 0 < g ^ n) by (apply pow_lt; lra).
  destruct (values_word n i) as [w [j [Hw [Hl E]]]]. rewrite E. destruct (Nat.lt_ge_cases n start) as [S|S].
  - apply Rle_trans with (D1 * g ^ n).
    2: { apply Rmult_le_compat_r; lra. }
    assert (W := after_bound w u B' BP (fun i c Hc => Rle_trans _ _ _ (Bounded i c Hc) (Rmax_l B 0)) j c Hc). rewrite Hl in W.
    assert (G1 : g ^ start <= g ^ n).
    { replace start with (n + (start - n))%nat by lia. rewrite pow_add. rewrite <- (Rmult_1_r (g ^ n)) at 2. apply Rmult_le_compat_l. lra.
      rewrite <- (pow1 (start - n)). apply pow_incr. lra. }
    assert (M2 : most ^ n * B' <= most ^ start * B').
    { apply Rmult_le_compat_r; auto. apply Rle_pow; auto. lia. }
    eapply Rle_trans. apply W. eapply Rle_trans. apply M2. unfold D1. apply (Rmult_le_reg_r (g ^ start)); auto.
    replace (most ^ start * B' / g ^ start * g ^ n * g ^ start) with (most ^ start * B' * g ^ n) by (field; lra).
    apply Rmult_le_compat_l; auto. apply Rmult_le_pos; auto. apply pow_le; lra.
  - apply Rle_trans with (D2 * g ^ n).
    2: { apply Rmult_le_compat_r; lra. }
    set (w1 := firstn (n - start) w). set (w2 := skipn (n - start) w).
    assert (Ew : w = w1 ++ w2) by (symmetry; apply firstn_skipn). rewrite Ew in Hw. apply letters_app in Hw. destruct Hw as [Hw1 Hw2].
    assert (L1 : length w1 = (n - start)%nat) by (unfold w1; apply firstn_length_le; lia).
    assert (L2 : length w2 = start) by (unfold w2; rewrite skipn_length; lia).
    destruct (HY w2 Hw2 L2) as [y [Hy Ey]]. rewrite Ew, after_app, (after_span w1 Hw1 _ y Ey j c Hc).
    eapply Rle_trans. apply HK; auto. rewrite L1. unfold D2. right.
    replace (g ^ n) with (g ^ (n - start) * g ^ start) by (rewrite <- pow_add; f_equal; lia). field. lra.
Qed.

Lemma run_bounded C g Y w y : 0 <= C -> 0 <= g -> 0 <= Y -> (forall i j, (i < N)%nat -> (j < N)%nat -> Rabs (product N T w i j) <= C * g ^ length w) ->
  (forall k, (k < N)%nat -> Rabs (y k) <= Y) -> forall k, (k < N)%nat -> Rabs (run N T w y k) <= INR N * (C * g ^ length w * Y).
Proof.
  intros C0 G0 Y0 HC Hy k Hk. rewrite run_product by auto. eapply Rle_trans. apply sum_abs. apply sum_bound. intros l Hl. rewrite Rabs_mult.
  apply Rmult_le_compat; try apply Rabs_pos; auto.
Qed.

Theorem values_shrink g : 0 < g <= 1 -> growth N A T g ->
  exists C, forall n i c, (c < r)%nat -> Rabs (values u n i c) <= C * g ^ n.
Proof.
  intros Hg [C0 HC]. set (C := Rmax C0 0). assert (CP : 0 <= C) by apply Rmax_r.
  set (P' := Rmax P 0). assert (PP : 0 <= P') by apply Rmax_r.
  assert (One : forall c, (c < r)%nat -> exists D, forall n i, Rabs (values u n i c) <= D * g ^ n).
  { intros c Hc. apply component_shrinks; auto. intros Y Y0. exists (INR N * (INR N * (C * Y) * P')). split.
    { apply Rmult_le_pos. apply pos_INR. apply Rmult_le_pos; auto. apply Rmult_le_pos. apply pos_INR. apply Rmult_le_pos; auto. }
    intros w y Hw Hy j. unfold span. eapply Rle_trans. apply sum_abs.
    replace (INR N * (INR N * (C * Y) * P') * g ^ length w) with (INR N * (INR N * (C * g ^ length w * Y) * P')) by ring.
    apply sum_bound. intros k Hk. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos.
    - apply run_bounded; auto; try lra. intros i j' Hi Hj. eapply Rle_trans. apply HC; auto. apply Rmult_le_compat_r. apply pow_le; lra. apply Rmax_l.
    - eapply Rle_trans. apply Basis; auto. apply Rmax_l. }
  assert (All : forall n, (n <= r)%nat -> exists D, forall l i c, (c < n)%nat -> Rabs (values u l i c) <= D * g ^ l).
  { induction n; intros Hn. exists 0. intros; lia. destruct (IHn ltac:(lia)) as [D1 H1]. destruct (One n ltac:(lia)) as [D2 H2].
    exists (Rmax D1 D2). intros l i c Hc. assert (0 <= g ^ l) by (apply pow_le; lra). destruct (Nat.eq_dec c n) as [->|].
    - eapply Rle_trans. apply H2. apply Rmult_le_compat_r; auto. apply Rmax_r.
    - eapply Rle_trans. apply H1; lia. apply Rmult_le_compat_r; auto. apply Rmax_l. }
  destruct (All r (le_n r)) as [D HD]. exists D. auto.
Qed.
End Space.

(* ---- the solution ------------------------------------------------------------------------------------------------ *)

Lemma choose_components (Q : nat -> (R -> R) -> Prop) : forall n, (forall c, (c < n)%nat -> exists f, Q c f) ->
  exists phi : nat -> R -> R, forall c, (c < n)%nat -> Q c (phi c).
Proof.
  induction n; intros H. exists (fun _ _ => 0). intros; lia.
  destruct IHn as [phi Hp]. intros; apply H; lia. destruct (H n ltac:(lia)) as [f Hf].
  exists (fun c => if Nat.eqb c n then f else phi c). intros c Hc. destruct (Nat.eqb_spec c n). subst; auto. apply Hp. lia.
Qed.

Lemma dense f g : continuity f -> continuity g -> (forall n i, f (IZR i / INR A ^ n) = g (IZR i / INR A ^ n)) -> forall x, f x = g x.
Proof.
  intros Cf Cg H x. apply cond_eq. intros eps He.
  destruct (Cf x (eps / 2) ltac:(lra)) as [d1 [D1 N1]]. destruct (Cg x (eps / 2) ltac:(lra)) as [d2 [D2 N2]].
  assert (Hd : 0 < Rmin d1 d2) by (apply Rmin_glb_lt; auto).
  destruct (small_cell A Arity (Rmin d1 d2 / 2) ltac:(lra)) as [n Hn]. specialize (Hn n (le_n n)).
  assert (P := power_positive A Arity n). set (i := floor (INR A ^ n * x)). set (y := IZR i / INR A ^ n).
  assert (Hy : Rabs (y - x) < Rmin d1 d2).
  { destruct (floor_bounds (INR A ^ n * x)) as [X1 X2]. fold i in X1, X2.
    replace (y - x) with (/ INR A ^ n * (IZR i - INR A ^ n * x)) by (unfold y; field; lra).
    rewrite Rabs_mult, Rabs_pos_eq by (left; apply Rinv_0_lt_compat; auto).
    assert (Rabs (IZR i - INR A ^ n * x) <= 1) by (apply Rabs_le; lra).
    apply Rle_lt_trans with (/ INR A ^ n * 1); [|lra]. apply Rmult_le_compat_l; auto. left; apply Rinv_0_lt_compat; auto. }
  assert (M1 := Rmin_l d1 d2). assert (M2 := Rmin_r d1 d2).
  assert (E1 : Rabs (f y - f x) < eps / 2).
  { destruct (Req_dec y x) as [->|N]. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra.
    apply N1. split. split. exact I. auto. simpl. unfold R_dist. lra. }
  assert (E2 : Rabs (g y - g x) < eps / 2).
  { destruct (Req_dec y x) as [->|N]. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra.
    apply N2. split. split. exact I. auto. simpl. unfold R_dist. lra. }
  replace (f x - g x) with (- (f y - f x) + (g y - g x)) by (unfold y; rewrite (H n i); ring).
  eapply Rle_lt_trans. apply Rabs_triang. rewrite Rabs_Ropp. lra.
Qed.

Lemma sum_continuous n (h : nat -> R -> R) : (forall i, (i < n)%nat -> continuity (h i)) -> continuity (fun x => sum n (fun i => h i x)).
Proof.
  induction n; intros H. apply derivable_continuous, derivable_const. cbn [sum].
  apply (continuity_plus (fun x => sum n (fun i => h i x)) (h n)). apply IHn; auto. apply H; lia.
Qed.

Lemma mix_continuous (phi : nat -> R -> R) c : (forall d, (d < r)%nat -> continuity (phi d)) ->
  continuity (fun x => blend (fun k d => phi d (INR A * x - IZR k)) c).
Proof.
  intros H. unfold mix. apply (sum_continuous (S L) (fun m x => sum r (fun d => a (F + Z.of_nat m)%Z c d * phi d (INR A * x - IZR (F + Z.of_nat m))))).
  intros m _. apply (sum_continuous r (fun d x => a (F + Z.of_nat m)%Z c d * phi d (INR A * x - IZR (F + Z.of_nat m)))).
  intros d Hd. apply (continuity_scal (fun x => phi d (INR A * x - IZR (F + Z.of_nat m)))).
  apply (continuity_comp (fun x => INR A * x - IZR (F + Z.of_nat m)) (phi d)); auto.
  apply continuity_minus. apply (continuity_scal (fun x => x)). apply derivable_continuous, derivable_id.
  apply derivable_continuous, derivable_const.
Qed.

(* At the points of the grids *)
Lemma grid_argument n i k : INR A * (IZR i / INR A ^ S n) - IZR k = IZR (i - ZA ^ Z.of_nat n * k) / INR A ^ n.
Proof.
  assert (P := power_positive A Arity n). assert (PA := arity_positive A Arity).
  rewrite minus_IZR, mult_IZR. unfold ZA. rewrite (arity_power A Arity). rewrite <- tech_pow_Rmult. field. lra.
Qed.

Section Solution.
Variables (v : vectors) (lo hi : Z).
Hypothesis Inside : forall i c, (c < r)%nat -> (i < lo \/ hi < i)%Z -> v i c = 0.
Hypothesis Fixed : forall i c, (c < r)%nat -> transit 0 v i c = v i c.

Let K := (Z.abs F + Z.of_nat L)%Z.
Let S0 := (Z.abs lo + Z.abs hi)%Z.

Lemma values_inside n : forall i c, (c < r)%nat -> (S0 + K * (ZA ^ Z.of_nat n - 1) < Z.abs i)%Z -> values v n i c = 0.
Proof.
  assert (A2 : (2 <= ZA)%Z) by (unfold ZA; lia).
  induction n; intros i c Hc Hi.
  - cbn [values]. change (ZA ^ Z.of_nat 0)%Z with 1%Z in Hi. apply Inside; auto. unfold S0 in Hi. lia.
  - cbn [values]. apply mix_zero. intros m d Hm Hd. apply IHn; auto. rewrite Nat2Z.inj_succ, Z.pow_succ_r in Hi by lia.
    assert (P : (0 < ZA ^ Z.of_nat n)%Z) by (apply Z.pow_pos_nonneg; lia). set (p := (ZA ^ Z.of_nat n)%Z) in *.
    assert (K0 : (Z.abs (F + Z.of_nat m) <= K)%Z) by (unfold K; lia). set (k := (F + Z.of_nat m)%Z) in *.
    assert (Z.abs (p * k) <= p * K)%Z by (rewrite Z.abs_mul, (Z.abs_eq p) by lia; apply Z.mul_le_mono_nonneg_l; lia).
    assert (0 <= K)%Z by (unfold K; lia). assert (K * p * 2 <= K * p * ZA)%Z by (apply Z.mul_le_mono_nonneg_l; nia).
    replace (K * (ZA * p - 1))%Z with (K * p * ZA - K)%Z in Hi by ring. lia.
Qed.

Lemma values_same n i c : (c < r)%nat -> values v (S n) (ZA * i)%Z c = values v n i c.
Proof.
  intros Hc. replace (ZA * i)%Z with (ZA * i + Z.of_nat 0)%Z by lia. rewrite values_step. apply values_ext; auto.
Qed.

Variables (m : nat) (l lambda : R).
Hypothesis Log : exp lambda = INR A.
Hypothesis End : 0 < l <= INR m.
Hypothesis Start : exists B, forall i c, (c < r)%nat -> Rabs (v i c) <= B.
Hypothesis Shrink : forall x, 0 < x < l -> exists C, forall n i c, (c < r)%nat ->
  Rabs (values (vector_differences m v) n i c) <= C * exp (- x * lambda) ^ n.

Theorem solution_exists : exists phi, is_solution A r F L a phi /\
  (forall n i c, (c < r)%nat -> phi c (IZR i / INR A ^ n) = values v n i c) /\ forall c, (c < r)%nat -> exponent_at_least (phi c) l.
Proof.
  destruct Start as [B HB].
  destruct (choose_components (fun c f => tends A (fun n i => values v n i c) f /\ continuity f /\ exponent_at_least f l) r) as [phi Hphi].
  { intros c Hc. apply (grid_exponent A Arity (fun n i => values v n i c) (fun n i => values_same n i c Hc) lambda Log m l B End (fun i => HB i c Hc)).
    intros x Hx. destruct (Shrink x Hx) as [C HC]. exists C. intros n i. rewrite <- values_differences. apply HC; auto. }
  assert (V : forall n i c, (c < r)%nat -> phi c (IZR i / INR A ^ n) = values v n i c).
  { intros n i c Hc. apply (tends_values A Arity (fun n i => values v n i c)). intros; apply values_same; auto. apply Hphi; auto. }
  exists phi. split; [|split; auto; intros c Hc; apply Hphi; auto]. split; [|split].
  - intros c Hc. apply Hphi; auto.
  - exists (IZR (S0 + K + 2)). intros c x Hc Hx. apply cond_eq. intros eps He. destruct (Hphi c Hc) as [T _].
    destruct (T (eps / 2) ltac:(lra)) as [n0 H]. specialize (H n0 (le_n n0) x). rewrite values_inside, Rabs_minus_sym in H; auto. lra.
    assert (P := power_positive A Arity n0). assert (E := arity_power A Arity n0). fold ZA in E.
    destruct (floor_bounds (INR A ^ n0 * x)) as [X1 X2]. set (i := floor (INR A ^ n0 * x)) in *.
    assert (P' : (0 < ZA ^ Z.of_nat n0)%Z) by (apply Z.pow_pos_nonneg; unfold ZA; lia). set (p := (ZA ^ Z.of_nat n0)%Z) in *.
    assert (S00 : (0 <= S0)%Z) by (unfold S0; lia). assert (K00 : (0 <= K)%Z) by (unfold K; lia).
    assert (Big : ((S0 + K + 2) * p <= Z.abs i + 1)%Z).
    { destruct Hx as [Hx|Hx]; apply (Rmult_lt_compat_l (INR A ^ n0)) in Hx; auto; rewrite <- E in *.
      - assert (i < - ((S0 + K + 2) * p))%Z by (apply lt_IZR; rewrite opp_IZR, mult_IZR; lra). lia.
      - assert ((S0 + K + 2) * p < i + 1)%Z by (apply lt_IZR; rewrite plus_IZR, mult_IZR; lra). lia. }
    nia.
  - intros c x Hc. revert x. apply dense. apply Hphi; auto. apply mix_continuous. intros; apply Hphi; auto.
    intros n i. assert (PA := arity_positive A Arity).
    replace (IZR i / INR A ^ n) with (IZR (ZA * i) / INR A ^ S n).
    + rewrite V by auto. cbn [values]. apply mix_ext. intros k d Hd. rewrite grid_argument, V; auto.
    + assert (P := power_positive A Arity n). rewrite mult_IZR. unfold ZA. rewrite arity_real, <- tech_pow_Rmult. field. lra.
Qed.
End Solution.

(* ---- all solutions ------------------------------------------------------------------------------------------------ *)

Section Unique.
Variables (v : vectors).
(* Vectors at the integers that are fixed, and 0 where continuous functions are *)
Hypothesis Kernel : forall u : vectors, (forall i c, (c < r)%nat -> ((ZA - 1) * i <= F \/ F + Z.of_nat L <= (ZA - 1) * i)%Z -> u i c = 0) ->
  (forall i c, (c < r)%nat -> transit 0 u i c = u i c) -> exists z, forall i c, (c < r)%nat -> u i c = z * v i c.

Section One.
Variable psi : nat -> R -> R.
Hypothesis Psi : is_solution A r F L a psi.
Let right := IZR (F + Z.of_nat L) / (INR A - 1).
Let left := IZR F / (INR A - 1).

Lemma above_one : 1 < INR A.
Proof. apply (lt_INR 1). lia. Qed.

Lemma zero_right c x : (c < r)%nat -> right < x -> psi c x = 0.
Proof.
  destruct Psi as [_ [[s HS] E]]. assert (A1 := above_one). intros Hc Hx.
  set (R0 := Rabs s + Rabs right + 1). assert (R1 : 0 < R0) by (unfold R0; generalize (Rabs_pos s) (Rabs_pos right); lra).
  assert (H : forall n c x, (c < r)%nat -> right + R0 / INR A ^ n < x -> psi c x = 0).
  { induction n; intros e y He Hy.
    - apply HS; auto. right. unfold R0 in Hy. rewrite pow_O in Hy. unfold Rdiv in Hy. rewrite Rinv_1, Rmult_1_r in Hy.
      assert (R2 := Rle_abs s). assert (R3 := Rle_abs (- right)). rewrite Rabs_Ropp in R3. lra.
    - rewrite E by auto. apply mix_zero. intros m d Hm Hd. apply IHn; auto.
      assert (P := power_positive A Arity n).
      assert (Hk : IZR (F + Z.of_nat m) <= IZR (F + Z.of_nat L)) by (apply IZR_le; lia).
      assert (Er : INR A * right - IZR (F + Z.of_nat L) = right) by (unfold right; field; lra).
      apply (Rmult_lt_compat_l (INR A)) in Hy; [|lra].
      replace (INR A * (right + R0 / INR A ^ S n)) with (INR A * right + R0 / INR A ^ n) in Hy
        by (rewrite <- tech_pow_Rmult; field; lra). lra. }
  destruct (small_cell A Arity ((x - right) / (2 * R0))) as [n Hn]. { apply Rdiv_lt_0_compat; lra. }
  specialize (Hn n (le_n n)). apply (H n); auto. apply (Rmult_le_compat_l R0) in Hn; [|lra].
  replace (R0 * ((x - right) / (2 * R0))) with ((x - right) / 2) in Hn by (field; lra). unfold Rdiv at 1. lra.
Qed.

Lemma zero_left c x : (c < r)%nat -> x < left -> psi c x = 0.
Proof.
  destruct Psi as [_ [[s HS] E]]. assert (A1 := above_one). intros Hc Hx.
  set (R0 := Rabs s + Rabs left + 1). assert (R1 : 0 < R0) by (unfold R0; generalize (Rabs_pos s) (Rabs_pos left); lra).
  assert (H : forall n c x, (c < r)%nat -> x < left - R0 / INR A ^ n -> psi c x = 0).
  { induction n; intros e y He Hy.
    - apply HS; auto. left. unfold R0 in Hy. rewrite pow_O in Hy. unfold Rdiv in Hy. rewrite Rinv_1, Rmult_1_r in Hy.
      assert (R2 := Rle_abs s). assert (R3 := Rle_abs left). lra.
    - rewrite E by auto. apply mix_zero. intros m d Hm Hd. apply IHn; auto.
      assert (P := power_positive A Arity n).
      assert (Hk : IZR F <= IZR (F + Z.of_nat m)) by (apply IZR_le; lia).
      assert (Er : INR A * left - IZR F = left) by (unfold left; field; lra).
      apply (Rmult_lt_compat_l (INR A)) in Hy; [|lra].
      replace (INR A * (left - R0 / INR A ^ S n)) with (INR A * left - R0 / INR A ^ n) in Hy
        by (rewrite <- tech_pow_Rmult; field; lra). lra. }
  destruct (small_cell A Arity ((left - x) / (2 * R0))) as [n Hn]. { apply Rdiv_lt_0_compat; lra. }
  specialize (Hn n (le_n n)). apply (H n); auto. apply (Rmult_le_compat_l R0) in Hn; [|lra].
  replace (R0 * ((left - x) / (2 * R0))) with ((left - x) / 2) in Hn by (field; lra). unfold Rdiv at 1. lra.
Qed.

(* A continuous function that is 0 on one side of a point is 0 there. *)
Lemma zero_limit f x s : continuity f -> (s = 1 \/ s = -1) -> (forall h, 0 < h -> f (x + s * h) = 0) -> f x = 0.
Proof.
  intros C Hs H. apply cond_eq. intros eps He. destruct (C x eps He) as [d [Hd N]]. simpl in N. unfold R_dist in N.
  assert (X : Rabs (f (x + s * (d / 2)) - f x) < eps).
  { apply N. split. split. exact I. destruct Hs; subst; lra.
    replace (x + s * (d / 2) - x) with (s * (d / 2)) by ring. destruct Hs; subst; [rewrite Rabs_pos_eq|rewrite Rabs_left]; lra. }
  rewrite H, Rabs_minus_sym in X by lra. auto.
Qed.

Lemma integers_inside i c : (c < r)%nat -> ((ZA - 1) * i <= F \/ F + Z.of_nat L <= (ZA - 1) * i)%Z -> psi c (IZR i) = 0.
Proof.
  intros Hc Hi. assert (A1 := above_one). assert (Co := proj1 Psi c Hc).
  assert (EA : IZR ZA = INR A) by (unfold ZA; apply arity_real).
  destruct Hi as [Hi|Hi]; apply IZR_le in Hi; rewrite mult_IZR, minus_IZR, EA in Hi.
  - apply (zero_limit (psi c) (IZR i) (-1)); auto. intros h Hh. apply zero_left; auto. unfold left.
    apply (Rmult_lt_reg_l (INR A - 1)); [lra|]. replace ((INR A - 1) * (IZR F / (INR A - 1))) with (IZR F) by (field; lra).
    assert (0 < (INR A - 1) * h) by (apply Rmult_lt_0_compat; lra). lra.
  - apply (zero_limit (psi c) (IZR i) 1); auto. intros h Hh. apply zero_right; auto. unfold right.
    apply (Rmult_lt_reg_l (INR A - 1)); [lra|]. replace ((INR A - 1) * (IZR (F + Z.of_nat L) / (INR A - 1))) with (IZR (F + Z.of_nat L)) by (field; lra).
    assert (0 < (INR A - 1) * h) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Theorem integers_multiple : exists z, forall i c, (c < r)%nat -> psi c (IZR i) = z * v i c.
Proof.
  apply (Kernel (fun i c => psi c (IZR i))). intros; apply integers_inside; auto.
  intros i c Hc. unfold transit. rewrite (proj2 (proj2 Psi) c (IZR i) Hc). apply mix_ext. intros k d Hd. f_equal.
  rewrite minus_IZR, plus_IZR, mult_IZR. unfold ZA. rewrite arity_real. simpl. ring.
Qed.
End One.

(* Solutions with multiples of values at the integers are multiples. *)
Theorem solutions_multiple phi : is_solution A r F L a phi -> (forall i c, (c < r)%nat -> phi c (IZR i) = v i c) ->
  forall psi, is_solution A r F L a psi -> exists z, forall c x, (c < r)%nat -> psi c x = z * phi c x.
Proof.
  intros Phi V psi Psi. destruct (integers_multiple psi Psi) as [z Hz]. exists z.
  assert (G : forall n i c, (c < r)%nat -> psi c (IZR i / INR A ^ n) = z * phi c (IZR i / INR A ^ n)).
  { induction n; intros i c Hc.
    - rewrite pow_O. unfold Rdiv. rewrite Rinv_1, Rmult_1_r, Hz, V; auto.
    - rewrite (proj2 (proj2 Psi) c _ Hc), (proj2 (proj2 Phi) c _ Hc), <- mix_scal. apply mix_ext. intros k d Hd.
      rewrite grid_argument. apply IHn; auto. }
  intros c x Hc. revert x. apply dense. apply (proj1 Psi); auto.
  apply (continuity_scal (phi c)). apply (proj1 Phi); auto. intros n i. apply G; auto.
Qed.
End Unique.
End Refinable.
