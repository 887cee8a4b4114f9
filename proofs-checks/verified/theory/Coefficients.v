(* Lemma 1 of SPEC.md: entries of products of the matrices of a scheme are the coefficients of the powers of the scheme. So
   their joint spectral radius bounds these coefficients. *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision.
Import ListNotations.
Open Scope R_scope.

Section Scheme.
(* The symbol b has the coefficients b 0, ..., b N; the matrices have the size W. *)
Variables (A N W : nat) (b : Z -> R).
Hypothesis Arity : (2 <= A)%nat.
Hypothesis Support : forall i, (i < 0 \/ Z.of_nat N < i)%Z -> b i = 0.
Hypothesis Size : (N <= W * (A - 1))%nat.
Hypothesis Size1 : (1 <= W)%nat.

Lemma size_integers : (Z.of_nat N <= Z.of_nat W * (Z.of_nat A - 1))%Z.
Proof. replace (Z.of_nat A - 1)%Z with (Z.of_nat (A - 1)) by lia. rewrite <- Nat2Z.inj_mul. lia. Qed.

Definition scheme_matrix : nat -> mat := fun t j k => b (Z.of_nat A * Z.of_nat j + Z.of_nat t - Z.of_nat k)%Z.

(* b(z) b(z^A) ... b(z^(A^(n-1))), the symbol of n steps *)
Fixpoint power (n : nat) (i : Z) : R :=
  match n with
  | O => if Z.eqb i 0 then 1 else 0
  | S m => sum (N + 1) (fun l => b (Z.of_nat l) * power m (i - Z.of_nat A ^ Z.of_nat m * Z.of_nat l))
  end.

Lemma power_support n : forall i, (i < 0 \/ Z.of_nat N * (Z.of_nat A ^ Z.of_nat n - 1) < (Z.of_nat A - 1) * i)%Z -> power n i = 0.
Proof.
  induction n; intros i Hi.
  - simpl. destruct (Z.eqb_spec i 0); auto. subst. simpl in Hi. lia.
  - simpl power. apply sum_zero. intros l Hl. rewrite IHn. lra.
    replace (Z.of_nat (S n)) with (Z.of_nat n + 1)%Z in Hi by lia. rewrite Z.pow_add_r, Z.pow_1_r in Hi by lia.
    assert (P : (0 < Z.of_nat A ^ Z.of_nat n)%Z) by (apply Z.pow_pos_nonneg; lia).
    set (p := (Z.of_nat A ^ Z.of_nat n)%Z) in *. destruct Hi as [Hi|Hi]; [left; nia|right].
    assert (M : ((Z.of_nat A - 1) * p * Z.of_nat l <= (Z.of_nat A - 1) * p * Z.of_nat N)%Z) by (apply Z.mul_le_mono_nonneg_l; nia).
    lia.
Qed.

(* The number whose digits are a word. *)
Fixpoint offset (w : list nat) : Z :=
  match w with [] => 0 | t :: w' => (Z.of_nat t * Z.of_nat A ^ Z.of_nat (length w') + offset w')%Z end.

Lemma offset_range w : letters A w -> (0 <= offset w < Z.of_nat A ^ Z.of_nat (length w))%Z.
Proof.
  induction w; intros Hw. simpl; lia. inversion Hw; subst. specialize (IHw H2). simpl offset. simpl length.
  replace (Z.of_nat (S (length w))) with (Z.of_nat (length w) + 1)%Z by lia. rewrite Z.pow_add_r, Z.pow_1_r by lia.
  set (p := (Z.of_nat A ^ Z.of_nat (length w))%Z) in *. nia.
Qed.

(* Lemma 1 *)
Theorem product_coefficient w : letters A w -> forall j k, (j < W)%nat -> (k < W)%nat ->
  product W scheme_matrix w j k =
  power (length w) (Z.of_nat A ^ Z.of_nat (length w) * Z.of_nat j + offset w - Z.of_nat k).
Proof.
  induction w as [|t w IH]; intros Hw j k Hj Hk.
  - cbn [product length offset power]. change (Z.of_nat A ^ Z.of_nat 0)%Z with 1%Z. unfold identity.
    destruct (Nat.eqb_spec j k), (Z.eqb_spec (1 * Z.of_nat j + 0 - Z.of_nat k) 0); auto; lia.
  - inversion Hw; subst. assert (R0 := offset_range w H2).
    set (n := length w) in *. set (p := (Z.of_nat A ^ Z.of_nat n)%Z) in *.
    assert (P : (0 < p)%Z) by (apply Z.pow_pos_nonneg; lia).
    set (c := (Z.of_nat A * Z.of_nat j + Z.of_nat t)%Z).
    set (g := fun l => b (c - l)%Z * power n (p * l + offset w - Z.of_nat k)%Z).
    transitivity (sum W (fun l => g (0 + Z.of_nat l)%Z)).
    + simpl product. unfold times. apply sum_ext; intros l Hl. unfold g, scheme_matrix.
      rewrite IH by auto. f_equal.
    + rewrite (sum_two_windows g 0 W (c - Z.of_nat N) (N + 1)).
      * rewrite sum_reverse. cbn [length]. fold n. cbn [power]. apply sum_ext; intros l Hl. unfold g. cbn [offset]. fold n p. f_equal.
        -- f_equal. lia.
        -- f_equal. replace (Z.of_nat (S n)) with (Z.of_nat n + 1)%Z by lia. rewrite Z.pow_add_r, Z.pow_1_r by lia. fold p.
           replace (Z.of_nat (N + 1 - 1 - l)) with (Z.of_nat N - Z.of_nat l)%Z by lia. unfold c. ring.
      * intros l Hl. unfold g. rewrite (power_support n). lra. fold p. destruct Hl as [Hl|Hl]; [left; nia|right].
        assert (SZ := size_integers). assert (Z.of_nat N * (p - 1) <= Z.of_nat W * (Z.of_nat A - 1) * (p - 1))%Z by (apply Z.mul_le_mono_nonneg_r; lia).
        assert (p * Z.of_nat W <= p * l)%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        assert ((Z.of_nat A - 1) * (Z.of_nat W * (p - 1) + 1) <= (Z.of_nat A - 1) * (p * l + offset w - Z.of_nat k))%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        lia.
      * intros l Hl. unfold g. rewrite Support. lra. lia.
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

(* The growth of products bounds all coefficients of n steps. *)
Theorem coefficients_bounded g : 0 < g -> growth W A scheme_matrix g -> exists C, forall n i, Rabs (power n i) <= C * g ^ n.
Proof.
  intros Hg [C H]. exists (Rmax C 0). intros n i. assert (P : 0 < g ^ n) by (apply pow_lt; auto).
  assert (Pos : 0 <= Rmax C 0 * g ^ n) by (apply Rmult_le_pos; [apply Rmax_r|lra]).
  set (p := (Z.of_nat A ^ Z.of_nat n)%Z). assert (P' : (0 < p)%Z) by (apply Z.pow_pos_nonneg; lia).
  destruct (Z_lt_ge_dec i 0) as [L|L]. { rewrite power_support, Rabs_R0; auto. }
  destruct (Z_lt_ge_dec (Z.of_nat N * (p - 1)) ((Z.of_nat A - 1) * i)) as [U|U]. { rewrite power_support, Rabs_R0; auto. }
  assert (D := Z.div_mod i p ltac:(lia)). assert (B := Z.mod_pos_bound i p P').
  assert (J0 : (0 <= i / p)%Z) by (apply Z.div_pos; lia).
  assert (J : (i / p < Z.of_nat W)%Z).
  { apply Z.div_lt_upper_bound; auto. assert (SZ := size_integers).
    assert (Z.of_nat N * (p - 1) <= Z.of_nat W * (Z.of_nat A - 1) * (p - 1))%Z by (apply Z.mul_le_mono_nonneg_r; lia).
    assert (i <= Z.of_nat W * (p - 1))%Z by (apply (Zmult_le_reg_r _ _ (Z.of_nat A - 1)); lia). lia. }
  destruct (offset_onto n (i mod p)%Z B) as [w [Hw [Hl Ho]]].
  specialize (H w Hw (Z.to_nat (i / p)) 0%nat ltac:(lia) ltac:(lia)).
  rewrite product_coefficient, Hl, Ho in H by (auto; lia). fold p in H.
  replace (p * Z.of_nat (Z.to_nat (i / p)) + i mod p - Z.of_nat 0)%Z with i in H by lia.
  eapply Rle_trans. apply H. apply Rmult_le_compat_r. lra. apply Rmax_l.
Qed.

(* ---- the same coefficients by steps of the scheme -------------------------------------------------------------------- *)

Section Steps.
Variable L : nat.
Hypothesis Fits : (N <= L)%nat.

Lemma supported_b : supported 0 N b.
Proof. intros i Hi. apply Support. lia. Qed.

Lemma power_one i : power 1 i = b i.
Proof.
  cbn [power]. change (Z.of_nat A ^ Z.of_nat 0)%Z with 1%Z. destruct (Z_lt_ge_dec i 0) as [H|H]; [|destruct (Z_lt_ge_dec (Z.of_nat N) i) as [H'|H']].
  - rewrite sum_zero, Support; auto. intros l Hl. destruct (Z.eqb_spec (i - 1 * Z.of_nat l) 0). exfalso; lia. lra.
  - rewrite sum_zero, Support; auto. intros l Hl. destruct (Z.eqb_spec (i - 1 * Z.of_nat l) 0). exfalso; lia. lra.
  - replace (b i) with (b (Z.of_nat (Z.to_nat i))) by (f_equal; lia).
    rewrite <- (sum_identity (N + 1) (Z.to_nat i) (fun l => b (Z.of_nat l))) by lia.
    apply sum_ext; intros l Hl. unfold identity.
    destruct (Z.eqb_spec (i - 1 * Z.of_nat l) 0), (Nat.eqb_spec l (Z.to_nat i)); (exfalso; lia) || lra.
Qed.

Lemma power_step n : forall i, power (S n) i = subdivide A 0 L b (power n) i.
Proof.
  induction n; intros i.
  - rewrite power_one. symmetry. apply (subdivide_point A 0 L Arity). apply (supported_more A 0 Arity N); auto using supported_b.
  - change (power (S (S n)) i) with (sum (N + 1) (fun l => b (Z.of_nat l) * power (S n) (i - Z.of_nat A ^ Z.of_nat (S n) * Z.of_nat l)%Z)).
    rewrite (sum_ext _ _ (fun l => b (Z.of_nat l) * subdivide A 0 L b (fun j => power n (j - Z.of_nat A ^ Z.of_nat n * Z.of_nat l)%Z) i)).
    + rewrite <- subdivide_sum. reflexivity.
    + intros l Hl. rewrite IHn, (subdivide_shift A 0 L Arity). f_equal. f_equal.
      rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. ring.
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

Theorem refined_bounded F g : 0 < g -> growth W A scheme_matrix g ->
  exists C, forall n i, Rabs (refined A F L (fun i => b (i - F)%Z) n i) <= C * g ^ n.
Proof. intros Hg H. destruct (coefficients_bounded g Hg H) as [C HC]. exists C. intros. rewrite refined_power. auto. Qed.

(* Theorem 2 of SPEC.md *)
Theorem radius_exponent lambda F G M l : exp lambda = INR A -> (N + M * (A - 1) <= L)%nat -> total F L (fun i => b (i - F)%Z) = INR A -> 0 < l <= INR M ->
  radius_at_most W A scheme_matrix G -> G <= exp ((INR M - l) * lambda) ->
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
