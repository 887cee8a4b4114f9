(* Lemma 1 of SPEC.md: entries of products of the matrices of a scheme, or of a mask for each level, are the coefficients of
   the data of these levels. So bounds of such products, as the joint spectral radius, bound these coefficients. *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision.
Import ListNotations.
Open Scope R_scope.

(* ---- words of digits --------------------------------------------------------------------------------------------------- *)

Section Words.
Variable A : nat.
Hypothesis Arity : (2 <= A)%nat.

(* The number whose digits are a word. *)
Fixpoint offset (w : list nat) : Z :=
  match w with [] => 0 | t :: w' => (Z.of_nat t * Z.of_nat A ^ Z.of_nat (length w') + offset w')%Z end.

Lemma offset_range w : letters A w -> (0 <= offset w < Z.of_nat A ^ Z.of_nat (length w))%Z.
Proof.
  induction w; intros Hw. simpl; lia. inversion Hw; subst. specialize (IHw H2). simpl offset. simpl length.
  replace (Z.of_nat (S (length w))) with (Z.of_nat (length w) + 1)%Z by lia. rewrite Z.pow_add_r, Z.pow_1_r by lia.
  set (p := (Z.of_nat A ^ Z.of_nat (length w))%Z) in *. nia.
Qed.

(* Each number below A^n is that of a word. *)
Lemma offset_onto n : forall r, (0 <= r < Z.of_nat A ^ Z.of_nat n)%Z -> exists w, letters A w /\ length w = n /\ offset w = r.
Proof.
  induction n; intros r Hr.
  - exists []. split. constructor. simpl in *. split; auto. lia.
  - rewrite Nat2Z.inj_succ, Z.pow_succ_r in Hr by lia. set (p := (Z.of_nat A ^ Z.of_nat n)%Z) in *.
    assert (P : (0 < p)%Z) by (apply Z.pow_pos_nonneg; lia).
    assert (D := Z.div_mod r p ltac:(lia)). assert (B := Z.mod_pos_bound r p P).
    destruct (IHn (r mod p)%Z B) as [w [Hw [Hl Ho]]]. exists (Z.to_nat (r / p) :: w). split; [|split].
    + constructor; auto. assert (r / p < Z.of_nat A)%Z by (apply Z.div_lt_upper_bound; lia). lia.
    + simpl. auto.
    + simpl offset. rewrite Hl, Ho. fold p. rewrite Z2Nat.id by (apply Z.div_pos; lia). lia.
Qed.

End Words.

Lemma size_integers A N W : (2 <= A)%nat -> (N <= W * (A - 1))%nat -> (Z.of_nat N <= Z.of_nat W * (Z.of_nat A - 1))%Z.
Proof. intros HA H. replace (Z.of_nat A - 1)%Z with (Z.of_nat (A - 1)) by lia. rewrite <- Nat2Z.inj_mul. lia. Qed.

(* ---- a mask for each level ------------------------------------------------------------------------------------------- *)

Section Levels.
(* The symbols have the coefficients 0, ..., N; the matrices have the size W. *)
Variables (A N W L : nat).
Hypothesis Arity : (2 <= A)%nat.
Hypothesis Fits : (N <= L)%nat.

Definition scheme_matrix (b : Z -> R) : nat -> mat := fun t j k => b (Z.of_nat A * Z.of_nat j + Z.of_nat t - Z.of_nat k)%Z.

(* Masks for the levels 0, 1, ...; those from level 1 on; the product with the first digit and the first mask on the left *)
Definition short (b : nat -> Z -> R) : Prop := forall k i, (i < 0 \/ Z.of_nat N < i)%Z -> b k i = 0.
Definition later (b : nat -> Z -> R) : nat -> Z -> R := fun k => b (S k).
Fixpoint level_product (b : nat -> Z -> R) (w : list nat) : mat :=
  match w with [] => identity | t :: w' => times W (scheme_matrix (b O) t) (level_product (later b) w') end.
Notation data b := (levels A 0 L b).

Lemma short_later b : short b -> short (later b).
Proof. intros H k. apply H. Qed.

Lemma short_supported b k : short b -> supported 0 N (b k).
Proof. intros H i Hi. apply H. lia. Qed.

Lemma one_level b : short b -> forall i, data b 1 i = b O i.
Proof.
  intros H i. cbn [levels]. apply (subdivide_point A 0 L Arity). apply (supported_more A 0 Arity N); auto. apply short_supported; auto.
Qed.

(* The first mask taken off *)
Lemma levels_first b n : short b -> forall i, data b (S n) i =
  sum (N + 1) (fun l => b O (Z.of_nat l) * data (later b) n (i - Z.of_nat A ^ Z.of_nat n * Z.of_nat l)%Z).
Proof.
  intros H. induction n; intros i.
  - rewrite one_level by auto. change (Z.of_nat A ^ Z.of_nat 0)%Z with 1%Z. cbn [levels]. unfold delta.
    destruct (Z_lt_ge_dec i 0) as [I|I]; [|destruct (Z_lt_ge_dec (Z.of_nat N) i) as [J|J]].
    + rewrite sum_zero, H; auto. intros l Hl. destruct (Z.eqb_spec (i - 1 * Z.of_nat l) 0). exfalso; lia. lra.
    + rewrite sum_zero, H; auto. intros l Hl. destruct (Z.eqb_spec (i - 1 * Z.of_nat l) 0). exfalso; lia. lra.
    + replace (b O i) with (b O (Z.of_nat (Z.to_nat i))) by (f_equal; lia).
      rewrite <- (sum_identity (N + 1) (Z.to_nat i) (fun l => b O (Z.of_nat l))) by lia.
      apply sum_ext; intros l Hl. unfold identity.
      destruct (Z.eqb_spec (i - 1 * Z.of_nat l) 0), (Nat.eqb_spec l (Z.to_nat i)); (exfalso; lia) || lra.
  - change (data b (S (S n)) i) with (subdivide A 0 L (b (S n)) (data b (S n)) i).
    rewrite (subdivide_ext A 0 L _ _ _ i IHn), subdivide_sum. apply sum_ext; intros l Hl. f_equal.
    rewrite (subdivide_shift A 0 L Arity). cbn [levels]. unfold later at 1. f_equal.
    rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. ring.
Qed.

Lemma levels_support n : forall b, short b -> forall i,
  (i < 0 \/ Z.of_nat N * (Z.of_nat A ^ Z.of_nat n - 1) < (Z.of_nat A - 1) * i)%Z -> data b n i = 0.
Proof.
  induction n; intros b H i Hi.
  - cbn [levels]. unfold delta. destruct (Z.eqb_spec i 0); auto. subst. simpl in Hi. lia.
  - rewrite levels_first by auto. apply sum_zero. intros l Hl. rewrite IHn. lra. apply short_later; auto.
    replace (Z.of_nat (S n)) with (Z.of_nat n + 1)%Z in Hi by lia. rewrite Z.pow_add_r, Z.pow_1_r in Hi by lia.
    assert (P : (0 < Z.of_nat A ^ Z.of_nat n)%Z) by (apply Z.pow_pos_nonneg; lia).
    set (p := (Z.of_nat A ^ Z.of_nat n)%Z) in *. destruct Hi as [Hi|Hi]; [left; nia|right].
    assert (M : ((Z.of_nat A - 1) * p * Z.of_nat l <= (Z.of_nat A - 1) * p * Z.of_nat N)%Z) by (apply Z.mul_le_mono_nonneg_l; nia).
    lia.
Qed.

Hypothesis Size : (N <= W * (A - 1))%nat.
Hypothesis Size1 : (1 <= W)%nat.

(* Lemma 1 *)
Theorem level_product_coefficient w : letters A w -> forall b, short b -> forall j k, (j < W)%nat -> (k < W)%nat ->
  level_product b w j k = data b (length w) (Z.of_nat A ^ Z.of_nat (length w) * Z.of_nat j + offset A w - Z.of_nat k)%Z.
Proof.
  induction w as [|t w IH]; intros Hw b Sb j k Hj Hk.
  - cbn [level_product length offset levels]. change (Z.of_nat A ^ Z.of_nat 0)%Z with 1%Z. unfold identity, delta.
    destruct (Nat.eqb_spec j k), (Z.eqb_spec (1 * Z.of_nat j + 0 - Z.of_nat k) 0); auto; lia.
  - inversion Hw; subst. assert (R0 := offset_range A Arity w H2). assert (Sl := short_later b Sb).
    set (n := length w) in *. set (p := (Z.of_nat A ^ Z.of_nat n)%Z) in *.
    assert (P : (0 < p)%Z) by (apply Z.pow_pos_nonneg; lia).
    set (c := (Z.of_nat A * Z.of_nat j + Z.of_nat t)%Z).
    set (g := fun l => b O (c - l)%Z * data (later b) n (p * l + offset A w - Z.of_nat k)%Z).
    transitivity (sum W (fun l => g (0 + Z.of_nat l)%Z)).
    + cbn [level_product]. unfold times. apply sum_ext; intros l Hl. unfold g, scheme_matrix.
      rewrite IH by auto. f_equal.
    + rewrite (sum_two_windows g 0 W (c - Z.of_nat N) (N + 1)).
      * rewrite sum_reverse. cbn [length]. fold n. rewrite levels_first by auto. apply sum_ext; intros l Hl. unfold g. cbn [offset]. fold n p. f_equal.
        -- f_equal. lia.
        -- f_equal. replace (Z.of_nat (S n)) with (Z.of_nat n + 1)%Z by lia. rewrite Z.pow_add_r, Z.pow_1_r by lia. fold p.
           replace (Z.of_nat (N + 1 - 1 - l)) with (Z.of_nat N - Z.of_nat l)%Z by lia. unfold c. ring.
      * intros l Hl. unfold g. rewrite (levels_support n); [lra|auto|]. fold p. destruct Hl as [Hl|Hl]; [left; nia|right].
        assert (SZ := size_integers A N W Arity Size). assert (Z.of_nat N * (p - 1) <= Z.of_nat W * (Z.of_nat A - 1) * (p - 1))%Z by (apply Z.mul_le_mono_nonneg_r; lia).
        assert (p * Z.of_nat W <= p * l)%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        assert ((Z.of_nat A - 1) * (Z.of_nat W * (p - 1) + 1) <= (Z.of_nat A - 1) * (p * l + offset A w - Z.of_nat k))%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        lia.
      * intros l Hl. unfold g. rewrite Sb. lra. lia.
Qed.

(* A bound of the products is one of all coefficients. *)
Theorem levels_bounded b C g : short b -> 0 < g -> 0 <= C ->
  (forall w, letters A w -> forall i j, (i < W)%nat -> (j < W)%nat -> Rabs (level_product b w i j) <= C * g ^ length w) ->
  forall n i, Rabs (data b n i) <= C * g ^ n.
Proof.
  intros Sb Hg HC H n i. assert (P : 0 < g ^ n) by (apply pow_lt; auto).
  assert (Pos : 0 <= C * g ^ n) by (apply Rmult_le_pos; lra).
  set (p := (Z.of_nat A ^ Z.of_nat n)%Z). assert (P' : (0 < p)%Z) by (apply Z.pow_pos_nonneg; lia).
  destruct (Z_lt_ge_dec i 0) as [I|I]. { rewrite levels_support, Rabs_R0; auto. }
  destruct (Z_lt_ge_dec (Z.of_nat N * (p - 1)) ((Z.of_nat A - 1) * i)) as [U|U]. { rewrite levels_support, Rabs_R0; auto. }
  assert (D := Z.div_mod i p ltac:(lia)). assert (B := Z.mod_pos_bound i p P').
  assert (J0 : (0 <= i / p)%Z) by (apply Z.div_pos; lia).
  assert (J : (i / p < Z.of_nat W)%Z).
  { apply Z.div_lt_upper_bound; auto. assert (SZ := size_integers A N W Arity Size).
    assert (Z.of_nat N * (p - 1) <= Z.of_nat W * (Z.of_nat A - 1) * (p - 1))%Z by (apply Z.mul_le_mono_nonneg_r; lia).
    assert (i <= Z.of_nat W * (p - 1))%Z by (apply (Zmult_le_reg_r _ _ (Z.of_nat A - 1)); lia). lia. }
  destruct (offset_onto A Arity n (i mod p)%Z B) as [w [Hw [Hl Ho]]].
  specialize (H w Hw (Z.to_nat (i / p)) 0%nat ltac:(lia) ltac:(lia)).
  rewrite level_product_coefficient, Hl, Ho in H by (auto; lia). fold p in H.
  replace (p * Z.of_nat (Z.to_nat (i / p)) + i mod p - Z.of_nat 0)%Z with i in H by lia. exact H.
Qed.

(* Other first indices shift the data. *)
Lemma levels_shifted F L' (f : nat -> Z) b n : short b -> (forall k, supported F L' (fun i => b k (i - f k)%Z)) ->
  exists s, forall i, levels A F L' (fun k i => b k (i - f k)%Z) n i = data b n (i - s).
Proof.
  intros Sb Sf. induction n as [|n [s IH]].
  - exists 0%Z. intros i. rewrite Z.sub_0_r. reflexivity.
  - exists (f n + Z.of_nat A * s)%Z. intros i. cbn [levels].
    rewrite (subdivide_ext A F L' _ _ _ i IH), (subdivide_shift A F L' Arity).
    set (i' := (i - Z.of_nat A * s)%Z). replace (i - (f n + Z.of_nat A * s))%Z with (i' - f n)%Z by (unfold i'; lia).
    set (g := fun j => b n (i' - f n - Z.of_nat A * j)%Z * data b n j).
    unfold subdivide. rewrite (sum_ext _ _ (fun m => g ((i' - F) / Z.of_nat A - Z.of_nat L' + Z.of_nat m)%Z)).
    + apply (sum_two_windows g).
      * intros j Hj. unfold g. assert (E := all_terms A F L' Arity L' _ i' j (Sf n) (le_n L') Hj). cbv beta in E.
        replace (i' - f n - Z.of_nat A * j)%Z with (i' - Z.of_nat A * j - f n)%Z by lia. rewrite E. lra.
      * intros j Hj. unfold g. rewrite (all_terms A 0 L Arity N); auto. lra. apply short_supported; auto.
    + intros m Hm. cbv zeta. unfold g. f_equal. f_equal. lia.
Qed.

(* Theorem 2 of SPEC.md with a mask for each level *)
Theorem levels_radius_exponent lambda F L' f b K B G M l : exp lambda = INR A -> short b ->
  masks_alike A F L' K B (fun k i => b k (i - f k)%Z) -> (K + M * (A - 1) <= L')%nat -> 0 < l <= INR M ->
  (forall g, G < g -> 0 < g -> exists C, forall w, letters A w -> forall i j, (i < W)%nat -> (j < W)%nat ->
    Rabs (level_product b w i j) <= C * g ^ length w) -> G <= exp ((INR M - l) * lambda) ->
  let a := fun k => smoothed A M (fun i => b k (i - f k)%Z) in
  exists phi, is_levels_limit A F L' a phi /\ tends A (levels A F L' a) phi /\ exponent_at_least phi l.
Proof.
  intros Hlog Sb Al HK Hl HG HGl. apply (levels_exponent A F L' Arity lambda Hlog K B); auto.
  intros x Hx. destruct (HG (exp ((INR M - x) * lambda))) as [C HC].
  - eapply Rle_lt_trans. apply HGl. apply (power_less A Arity lambda Hlog). lra.
  - apply exp_pos.
  - exists (Rmax C 0). intros n i. destruct (levels_shifted F L' f b n Sb) as [s Hs].
    { intros k. apply (supported_more A F Arity K). revert HK. generalize (M * (A - 1))%nat. lia. apply Al. }
    rewrite Hs. apply levels_bounded; auto. apply exp_pos. apply Rmax_r.
    intros w Hw p q Hp Hq. eapply Rle_trans. apply HC; auto. apply Rmult_le_compat_r. apply pow_le. left; apply exp_pos. apply Rmax_l.
Qed.
End Levels.

(* ---- one mask for all levels ------------------------------------------------------------------------------------------- *)

Section Scheme.
(* The symbol b has the coefficients b 0, ..., b N; the matrices have the size W. *)
Variables (A N W : nat) (b : Z -> R).
Hypothesis Arity : (2 <= A)%nat.
Hypothesis Support : forall i, (i < 0 \/ Z.of_nat N < i)%Z -> b i = 0.
Hypothesis Size : (N <= W * (A - 1))%nat.
Hypothesis Size1 : (1 <= W)%nat.

(* b(z) b(z^A) ... b(z^(A^(n-1))), the symbol of n steps *)
Fixpoint power (n : nat) (i : Z) : R :=
  match n with
  | O => if Z.eqb i 0 then 1 else 0
  | S m => sum (N + 1) (fun l => b (Z.of_nat l) * power m (i - Z.of_nat A ^ Z.of_nat m * Z.of_nat l))
  end.

Lemma short_b : short N (fun _ => b).
Proof. intros k. exact Support. Qed.

Lemma power_levels L n : (N <= L)%nat -> forall i, power n i = levels A 0 L (fun _ => b) n i.
Proof.
  intros HL. induction n; intros i. reflexivity.
  rewrite (levels_first A N L Arity HL (fun _ => b) n short_b). cbn [power]. apply sum_ext; intros l Hl. rewrite IHn. reflexivity.
Qed.

Lemma power_support n : forall i, (i < 0 \/ Z.of_nat N * (Z.of_nat A ^ Z.of_nat n - 1) < (Z.of_nat A - 1) * i)%Z -> power n i = 0.
Proof. intros i Hi. rewrite (power_levels N n (le_n N)). apply (levels_support A N N Arity (le_n N) n (fun _ => b) short_b i Hi). Qed.

Lemma product_levels w : level_product A W (fun _ => b) w = product W (scheme_matrix A b) w.
Proof. induction w; auto. cbn [level_product product]. rewrite <- IHw. reflexivity. Qed.

Theorem product_coefficient w : letters A w -> forall j k, (j < W)%nat -> (k < W)%nat ->
  product W (scheme_matrix A b) w j k =
  power (length w) (Z.of_nat A ^ Z.of_nat (length w) * Z.of_nat j + offset A w - Z.of_nat k).
Proof.
  intros Hw j k Hj Hk. rewrite (power_levels N _ (le_n N)), <- product_levels.
  apply (level_product_coefficient A N W N Arity (le_n N) Size Size1 w Hw (fun _ => b) short_b j k Hj Hk).
Qed.

(* The growth of products bounds all coefficients of n steps. *)
Theorem coefficients_bounded g : 0 < g -> growth W A (scheme_matrix A b) g -> exists C, forall n i, Rabs (power n i) <= C * g ^ n.
Proof.
  intros Hg [C H]. exists (Rmax C 0). intros n i. rewrite (power_levels N n (le_n N)).
  apply (levels_bounded A N W N Arity (le_n N) Size Size1); auto using short_b, Rmax_r.
  intros w Hw p q Hp Hq. rewrite product_levels. eapply Rle_trans. apply H; auto.
  apply Rmult_le_compat_r. apply pow_le. lra. apply Rmax_l.
Qed.

(* ---- the same coefficients by steps of the scheme -------------------------------------------------------------------- *)

Section Steps.
Variable L : nat.
Hypothesis Fits : (N <= L)%nat.

Lemma power_step n : forall i, power (S n) i = subdivide A 0 L b (power n) i.
Proof.
  intros i. rewrite (power_levels L) by auto. cbn [levels]. apply subdivide_ext. intros j. rewrite (power_levels L); auto.
Qed.

(* Another first index shifts the coefficients. *)
Fixpoint shift (F : Z) (n : nat) : Z := match n with O => 0 | S m => (F + Z.of_nat A * shift F m)%Z end.

Lemma refined_power F n : forall i, refined A F L (fun i => b (i - F)%Z) n i = power n (i - shift F n).
Proof.
  induction n; intros i.
  - simpl. unfold delta. replace (i - 0)%Z with i by lia. auto.
  - cbn [refined shift]. rewrite power_step. rewrite (subdivide_ext A F L _ _ _ i IHn), (subdivide_shift A F L Arity).
    unfold subdivide. apply sum_ext; intros m Hm. cbv zeta. replace (i - (F + Z.of_nat A * shift F n) - 0)%Z with (i - Z.of_nat A * shift F n - F)%Z by lia.
    f_equal. f_equal. ring.
Qed.

Theorem refined_bounded F g : 0 < g -> growth W A (scheme_matrix A b) g ->
  exists C, forall n i, Rabs (refined A F L (fun i => b (i - F)%Z) n i) <= C * g ^ n.
Proof. intros Hg H. destruct (coefficients_bounded g Hg H) as [C HC]. exists C. intros. rewrite refined_power. auto. Qed.

(* Theorem 2 of SPEC.md *)
Theorem radius_exponent lambda F G M l : exp lambda = INR A -> (N + M * (A - 1) <= L)%nat -> total F L (fun i => b (i - F)%Z) = INR A -> 0 < l <= INR M ->
  radius_at_most W A (scheme_matrix A b) G -> G <= exp ((INR M - l) * lambda) ->
  let a := smoothed A M (fun i => b (i - F)%Z) in
  exists phi, is_limit A F L a phi /\ tends A (refined A F L a) phi /\ exponent_at_least phi l.
Proof.
  intros Hlog HL Ht Hl HG HGl. apply (smoothed_exponent A F L Arity lambda Hlog N); auto.
  - intros i Hi. apply Support. lia.
  - intros x Hx. apply refined_bounded. apply exp_pos. apply HG; [|apply exp_pos].
    eapply Rle_lt_trans. apply HGl. apply (power_less A Arity lambda Hlog). lra.
Qed.
End Steps.
End Scheme.
