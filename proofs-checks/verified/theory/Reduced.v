(* Theorem 24 of SPEC.md: where the mask a times p(z) is the mask b times p(z^A), and p(1) and p_0 are not 0, the limits of
   both schemes are equally smooth. So what is shown of b, whose shifts may be stable, is true of a, whose shifts are not. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Integers Sections Check Subdivision Differences Stability Modulus Smooth Exponent Enclosure
  Number Exact Logarithm Rough.
Import ListNotations.
Open Scope R_scope.

Lemma sum_first n f : sum (S n) f = f O + sum n (fun l => f (S l)).
Proof. change (S n) with (1 + n)%nat. rewrite sum_add. change (sum 1 f) with (0 + f O). rewrite Rplus_0_l. reflexivity. Qed.

(* ---- limits of two masks ----------------------------------------------------------------------------------------- *)

Section Masks.
Variables (A : nat) (F : Z).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.

Section Factor.
Variables (La Lb d : nat) (a b : Z -> R) (p : nat -> R) (phi psi : R -> R).
Hypothesis SupportA : supported F La a.
Hypothesis SupportB : supported F Lb b.
Hypothesis Relation : forall i, sum (S d) (fun l => p l * a (i - Z.of_nat l)%Z) = sum (S d) (fun l => p l * b (i -
  ZA * Z.of_nat l)%Z).

(* One step *)
Lemma step_relation f i : sum (S d) (fun l => p l * subdivide A F La a f (i - Z.of_nat l)) =
  subdivide A F Lb b (fun j => sum (S d) (fun l => p l * f (j - Z.of_nat l)%Z)) i.
Proof.
  rewrite (subdivide_sum A F Lb b (S d) p (fun l j => f (j - Z.of_nat l)%Z)).
  set (w := (Z.abs i + Z.abs F + Z.of_nat La + Z.of_nat Lb + Z.of_nat d + 1)%Z). set (m := Z.to_nat (2 * w + 1)).
  assert (A2 : (2 <= Z.of_nat A)%Z) by lia.
  assert (Out : forall K c, supported F K c -> (K <= La + Lb)%nat -> forall l, (l < S d)%nat -> forall j, (j < - w \/ - w +
    Z.of_nat m <= j)%Z ->
    c (i - Z.of_nat l - ZA * j)%Z = 0 /\ c (i - ZA * Z.of_nat l - ZA * j)%Z = 0).
  { intros K c Sc HK l Hl j Hj. unfold ZA. replace (Z.of_nat m) with (2 * w + 1)%Z in Hj by (unfold m, w; lia). split; apply Sc.
    - destruct Hj as [Hj|Hj]; [right|left].
      + assert (Z.of_nat A * (w + 1) <= Z.of_nat A * - j)%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        assert (2 * (w + 1) <= Z.of_nat A * (w + 1))%Z by (apply Z.mul_le_mono_nonneg_r; unfold w; lia). unfold w in *. lia.
      + assert (Z.of_nat A * (w + 1) <= Z.of_nat A * j)%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        assert (2 * (w + 1) <= Z.of_nat A * (w + 1))%Z by (apply Z.mul_le_mono_nonneg_r; unfold w; lia). unfold w in *. lia.
    - replace (i - Z.of_nat A * Z.of_nat l - Z.of_nat A * j)%Z with (i - Z.of_nat A * (Z.of_nat l + j))%Z by ring.
      destruct Hj as [Hj|Hj]; [right|left].
      + assert (Z.of_nat A * (w + 1 - Z.of_nat d) <= Z.of_nat A * - (Z.of_nat l + j))%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        assert (2 * (w + 1 - Z.of_nat d) <= Z.of_nat A * (w + 1 - Z.of_nat d))%Z by (apply Z.mul_le_mono_nonneg_r; unfold w;
          lia). unfold w in *. lia.
      + assert (Z.of_nat A * (w + 1) <= Z.of_nat A * (Z.of_nat l + j))%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        assert (2 * (w + 1) <= Z.of_nat A * (w + 1))%Z by (apply Z.mul_le_mono_nonneg_r; unfold w; lia). unfold w in *. lia. }
  transitivity (sum (S d) (fun l => sum m (fun k => p l * a (i - Z.of_nat l - ZA * (- w + Z.of_nat k))%Z * f (- w +
    Z.of_nat k)%Z))).
  { apply sum_ext; intros l Hl. rewrite <- (subdivide_window A F La Arity La a f (i - Z.of_nat l) (- w) m) by
      (auto; intros j Hj; apply (Out La a SupportA ltac:(lia) l Hl j Hj)).
    rewrite <- sum_scal. apply sum_ext; intros k Hk. fold ZA. ring. }
  transitivity (sum (S d) (fun l => sum m (fun k => p l * b (i - ZA * Z.of_nat l - ZA * (- w + Z.of_nat k))%Z * f (- w +
    Z.of_nat k)%Z))).
  - rewrite !(sum_swap (S d) m). apply sum_ext; intros k Hk. specialize (Relation (i - ZA * (- w + Z.of_nat k))).
    apply (f_equal (fun y => f (- w + Z.of_nat k)%Z * y)) in Relation. rewrite <- !sum_scal in Relation.
    rewrite (sum_ext (S d) _ (fun l => f (- w + Z.of_nat k)%Z * (p l * a (i - ZA * (- w + Z.of_nat k) - Z.of_nat l)%Z))).
    + rewrite Relation. apply sum_ext; intros l Hl. rewrite Rmult_comm. do 3 f_equal. ring.
    + intros l Hl. rewrite Rmult_comm. do 3 f_equal. ring.
  - apply sum_ext; intros l Hl. rewrite (subdivide_shift A F Lb Arity). fold ZA.
    rewrite <- (subdivide_window A F Lb Arity Lb b f (i - ZA * Z.of_nat l) (- w) m) by
      (auto; intros j Hj; apply (Out Lb b SupportB ltac:(lia) l Hl j Hj)).
    rewrite <- sum_scal. apply sum_ext; intros k Hk. fold ZA. ring.
Qed.

(* n steps: the symbol of a times p(z) is that of b times p(z^(A^n)). *)
Lemma steps_relation n : forall i, sum (S d) (fun l => p l * refined A F La a n (i - Z.of_nat l)) =
  sum (S d) (fun l => p l * refined A F Lb b n (i - ZA ^ Z.of_nat n * Z.of_nat l)).
Proof.
  induction n; intros i.
  - apply sum_ext; intros l Hl. change (ZA ^ Z.of_nat 0)%Z with 1%Z. cbn [refined]. do 2 f_equal. ring.
  - cbn [refined]. rewrite step_relation, (subdivide_ext A F Lb b _ _ i IHn).
    rewrite (subdivide_sum A F Lb b (S d) p (fun l j => refined A F Lb b n (j - ZA ^ Z.of_nat n * Z.of_nat l))).
    apply sum_ext; intros l Hl. rewrite (subdivide_shift A F Lb Arity). do 2 f_equal.
    rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. fold ZA. ring.
Qed.

Hypothesis Phi : is_limit A F La a phi.
Hypothesis Psi : is_limit A F Lb b psi.
Let whole := sum (S d) p.

(* p(1) times the one limit is a combination of the other. *)
Theorem limit_relation x : whole * phi x = mix (S d) p psi x.
Proof.
  apply (UL_sequence (fun n => sum (S d) (fun l => p l * refined A F La a n (floor (INR A ^ n * x) - Z.of_nat l)%Z))).
  - replace (whole * phi x) with (sum (S d) (fun l => p l * phi x)) by (unfold whole; rewrite Rmult_comm, <- sum_scal;
      apply sum_ext; intros; ring).
    apply (sum_converges (S d) p (fun l n => refined A F La a n (floor (INR A ^ n * x) - Z.of_nat l)%Z) (fun _ => phi x)).
    intros l Hl. apply limit_point; auto.
  - replace (fun n => sum (S d) (fun l => p l * refined A F La a n (floor (INR A ^ n * x) - Z.of_nat l)%Z)) with
      (fun n => sum (S d) (fun l => p l * refined A F Lb b n (floor (INR A ^ n * (x - INR l)) - 0)%Z)).
    + apply (sum_converges (S d) p (fun l n => refined A F Lb b n (floor (INR A ^ n * (x - INR l)) - 0)%Z) (fun l => psi (x -
        INR l))).
      intros l Hl. apply limit_point; auto.
    + extensionality n. rewrite steps_relation. apply sum_ext; intros l Hl. do 2 f_equal.
      rewrite Z.sub_0_r, (INR_IZR_INZ l). apply (floor_shift A Arity).
Qed.

Hypothesis Whole : whole <> 0.
Hypothesis First : p O <> 0.
Let bound := IZR (Z.abs F + Z.of_nat Lb + 1).
Let rest (l : nat) : R := match l with O => 0 | _ => p l end.

Lemma psi_vanishes : vanishes (- bound) bound psi.
Proof. apply (limit_zero A F Arity Lb b psi SupportB Psi). Qed.

Lemma mix_first f x : mix (S d) p f x = p O * f x + mix (S d) rest f x.
Proof. unfold mix. rewrite !sum_first. unfold rest. rewrite Rminus_0_r. ring. Qed.

Lemma bound_positive : 0 < bound.
Proof. apply IZR_lt. lia. Qed.

Lemma beyond x : exists m, x < - bound - 1 + INR m.
Proof.
  destruct (archimed (x + bound + 1)) as [U _]. exists (Z.to_nat (Z.max 0 (up (x + bound + 1)))).
  rewrite INR_IZR_INZ, Z2Nat.id by lia. assert (IZR (up (x + bound + 1)) <= IZR (Z.max 0 (up (x + bound + 1)))) by
    (apply IZR_le; lia). lra.
Qed.

(* Each of them is as smooth as the other one. *)
Section Kind.
Variable kind : (R -> R) -> Prop.
Hypothesis Closed : closed kind.

Theorem smooth_phi k : smooth kind k psi -> smooth kind k phi.
Proof.
  intros H. replace phi with (fun x => / whole * mix (S d) p psi x).
  apply smooth_scal, smooth_mix, H; auto. extensionality x. rewrite <- limit_relation. field. exact Whole.
Qed.

Theorem smooth_psi k : smooth kind k phi -> smooth kind k psi.
Proof.
  intros H. assert (V := psi_vanishes).
  assert (Up : forall m, exists g, smooth kind k g /\ forall x, x <= - bound - 1 + INR m -> psi x = g x).
  { induction m as [|m [g [Hg E]]].
    - exists (fun _ => 0). split. apply smooth_zero; auto. intros x Hx. apply V. simpl in Hx. lra.
    - exists (fun x => / p O * (whole * phi x - mix (S d) rest g x)). split.
      + apply smooth_scal, smooth_minus; auto. apply smooth_scal, H; auto. apply smooth_mix, Hg; auto.
      + intros x Hx. rewrite limit_relation, mix_first. replace (mix (S d) rest psi x) with (mix (S d) rest g x). field; auto.
        unfold mix. apply sum_ext; intros l Hl. destruct l as [|l]. simpl. ring. rewrite E. auto. rewrite S_INR in *.
        assert (Q := pos_INR l). lra. }
  destruct (beyond bound) as [m Hm]. destruct (Up m) as [g [Hg E]].
  apply (smooth_local kind Closed k psi g bound (- bound - 1 + INR m)); auto.
Qed.
End Kind.

Theorem same_exponents s : exponents phi s <-> exponents psi s.
Proof.
  split; intros [k [alpha [Ha [E H]]]]; exists k, alpha; (split; [auto|]; split; [auto|]); apply smooth_holder;
    apply smooth_holder in H.
  - apply smooth_psi; auto. apply closed_holder. lra.
  - apply smooth_phi; auto. apply closed_holder. lra.
Qed.

Theorem modulus_phi lambda s P : exp lambda = INR A -> has_modulus lambda s P psi -> has_modulus lambda s P phi.
Proof.
  intros Log [k [g [c [C [Ks [C0 [D [Up Low]]]]]]]]. assert (Lam := log_positive A Arity lambda Log).
  assert (V := derivative_vanishes _ _ k psi g D psi_vanishes). assert (B0 := bound_positive).
  set (h := fun x => / whole * mix (S d) p g x).
  assert (Rel : forall x, whole * h x = mix (S d) p g x) by (intros x; unfold h; field; exact Whole).
  set (T := sum (S d) (fun l => Rabs (p l))).
  assert (Change : forall m, exists E, 0 <= E /\ forall r w, (forall x t, 0 < t <= r -> Rabs (h (x + t) - h x) <= w) ->
    forall x t, 0 < t <= r -> x + t <= - bound - 1 + INR m -> Rabs (g (x + t) - g x) <= E * w).
  { induction m as [|m [E [E0 IH]]].
    - exists 0. split. lra. intros r w _ x t Ht Hx. simpl in Hx. rewrite !V, Rminus_0_r, Rabs_R0 by lra. lra.
    - assert (P0 : 0 < Rabs (p O)) by (apply Rabs_pos_lt; auto). set (S1 := sum (S d) (fun l => Rabs (rest l))).
      assert (S0 : 0 <= S1) by (apply sum_nonneg; intros; apply Rabs_pos). assert (W0 := Rabs_pos whole).
      exists (/ Rabs (p O) * (Rabs whole + S1 * E)). split.
      { apply Rmult_le_pos. left; apply Rinv_0_lt_compat; auto. assert (0 <= S1 * E) by (apply Rmult_le_pos; auto). lra. }
      intros r w Hw x t Ht Hx. specialize (IH r w Hw).
      assert (Eq : p O * (g (x + t) - g x) = whole * (h (x + t) - h x) - (mix (S d) rest g (x + t) - mix (S d) rest g x)).
      { assert (R1 := Rel x). assert (R2 := Rel (x + t)). rewrite mix_first in R1, R2. lra. }
      assert (Mix : Rabs (mix (S d) rest g (x + t) - mix (S d) rest g x) <= S1 * (E * w)).
      { unfold mix. rewrite <- sum_minus. eapply Rle_trans. apply sum_abs. unfold S1. rewrite Rmult_comm, <- sum_scal.
        apply sum_le; intros l Hl. rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_comm. destruct l as [|l].
        - simpl rest. rewrite Rabs_R0. lra.
        - apply Rmult_le_compat_r. apply Rabs_pos. replace (x + t - INR (S l)) with (x - INR (S l) + t) by ring. apply IH; auto.
          rewrite S_INR in *. assert (Q := pos_INR l). lra. }
      apply (Rmult_le_reg_l (Rabs (p O))); auto. rewrite <- Rabs_mult, Eq.
      replace (Rabs (p O) * (/ Rabs (p O) * (Rabs whole + S1 * E) * w)) with (Rabs whole * w + S1 * (E * w)) by (field; lra).
      unfold Rminus at 1. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp, Rabs_mult. apply Rplus_le_compat; auto.
      apply Rmult_le_compat_l; auto. }
  destruct (beyond (bound + 1)) as [m Hm]. destruct (Change m) as [E [E0 HE]].
  exists k, h, (/ (E + 1) * c), (/ Rabs whole * (T * C)). split; auto. split; [|split; [|split]].
  - apply Rmult_lt_0_compat; auto. apply Rinv_0_lt_compat. lra.
  - replace phi with (fun x => / whole * mix (S d) p psi x).
    + apply derivative_sequence_scal, derivative_sequence_mix, D.
    + extensionality x. rewrite <- limit_relation. field. exact Whole.
  - intros x t Ht. unfold h. rewrite <- Rmult_minus_distr_l, Rabs_mult, Rabs_inv, !Rmult_assoc.
    apply Rmult_le_compat_l. left. apply Rinv_0_lt_compat, Rabs_pos_lt, Whole.
    apply mix_change. intros l Hl. replace (x + exp t - INR l) with (x - INR l + exp t) by ring. rewrite <- Rmult_assoc.
    apply Up. auto.
  - intros n w Hn Hw. assert (HE' := HE _ w Hw). set (r := exp (- (INR n * lambda))) in *.
    assert (R1 : 0 < r <= 1). { split. apply exp_pos. unfold r. rewrite <- exp_0. apply exp_at_most.
      assert (0 <= INR n * lambda) by (apply Rmult_le_pos; [apply pos_INR|lra]). lra. }
    assert (W0 : 0 <= w) by (eapply Rle_trans; [apply Rabs_pos|apply (Hw 0 r); lra]).
    assert (Low' : c * exp (- ((s - INR k) * (INR n * lambda))) * (INR n * lambda) ^ P <= E * w).
    { apply (Low n); auto. intros x t Ht. fold r in Ht. destruct (Rle_lt_dec (x + t) (bound + 1)). apply HE'; auto. lra.
      rewrite !V, Rminus_0_r, Rabs_R0 by lra. apply Rmult_le_pos; auto. }
    rewrite !(Rmult_assoc (/ (E + 1))). apply (Rmult_le_reg_l (E + 1)). lra. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. lra.
Qed.
End Factor.
End Masks.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

Open Scope Z_scope.

(* The other mask and the coefficients of p; and why the scheme of the mask of the claim converges: the order of its
   differences, and a bound of their radius. *)
Record reduction := Reduction { shift_factor : list Z; other_scheme : scheme; own_order : nat; own_bound : Q;
  own_radius : certificate }.

Definition converges (a : scheme) (c : reduction) : bool :=
  let m := own_order c in let u := own_bound c in
  (1 <=? m)%nat && reducible a m && (Qnum u <? Z.of_nat (arity a) ^ Z.of_nat m * Zpos (Qden u)) &&
  check_radius (Claim (difference_family a m) None (Some u)) (own_radius c).

Definition check_factor (a b : scheme) (p : list Z) : bool :=
  (arity b =? arity a)%nat && (first b =? first a) && (0 <? common b) &&
  negb (nth 0 p 0 =? 0) && negb (fold_right Z.add 0 p =? 0) &&
  same (map (Z.mul (common b)) (times_up 1 p (coefficients a))) (map (Z.mul (common a)) (times_up (arity a) p (coefficients b))).

(* What is to be shown of a mask is shown of the other one. *)
Definition check_reduced (a : scheme) (c : reduction) (check : scheme -> bool) : bool :=
  check_factor a (other_scheme c) (shift_factor c) && converges a c && check (other_scheme c).

(* ---- what it says ------------------------------------------------------------------------------------------------ *)

Lemma converges_sound a c : converges a c = true -> exists phi, limit_of a phi.
Proof.
  intros H. unfold converges in H. cbv zeta in H. repeat rewrite andb_true_iff in H. destruct H as [[[H1 H2] H3] H4].
  set (m := own_order c) in *. set (u := own_bound c) in *. apply Nat.leb_le in H1. apply Z.ltb_lt, IZR_lt in H3.
  assert (HA : (2 <= arity a)%nat).
  { unfold reducible in H2. repeat rewrite andb_true_iff in H2. destruct H2 as [[[HA _] _] _]. apply Nat.leb_le; auto. }
  destruct (exp_onto (INR (arity a)) (arity_positive (arity a) HA)) as [lambda Log].
  assert (Lam := log_positive (arity a) HA lambda Log). set (most := Rmax (real_of u) 1).
  assert (M1 : (real_of u <= most /\ 1 <= most)%R) by (split; [apply Rmax_l|apply Rmax_r]).
  assert (D : (0 < IZR (Zpos (Qden u)))%R) by (apply IZR_lt; lia).
  assert (Em : (exp (INR m * lambda) = INR (arity a) ^ m)%R) by (rewrite <- exp_power, Log; auto).
  assert (M2 : (most < exp (INR m * lambda))%R).
  { apply Rmax_lub_lt.
    - rewrite mult_IZR, (Subdivision.arity_power (arity a) HA), <- Em in H3. unfold real_of.
      apply (Rmult_lt_reg_r (IZR (Zpos (Qden u)))); auto.
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
    - rewrite <- exp_0. apply exp_less. apply Rmult_lt_0_compat; auto. apply (lt_INR 0). lia. }
  destruct (log_onto lambda m most Lam ltac:(lra)) as [l Hl].
  assert (L0 : (0 < l)%R).
  { apply Rnot_le_lt. intros N. assert (exp (INR m * lambda) <= exp ((INR m - l) * lambda))%R; [|lra].
    apply exp_at_most. apply Rmult_le_compat_r; lra. }
  assert (L1 : (l <= INR m)%R).
  { apply Rnot_lt_le. intros N. assert (exp ((INR m - l) * lambda) < 1)%R; [|lra]. rewrite <- exp_0. apply exp_less.
    assert (0 < (l - INR m) * lambda)%R by (apply Rmult_lt_0_compat; lra). lra. }
  destruct (limit_of_growth a lambda l m most H2 Log (conj L0 L1) ltac:(lra)) as [phi [Lim _]].
  - apply check_radius_sound, radius_bounded in H4. intros r Hr R0. apply H4; auto. lra.
  - exists phi. exact Lim.
Qed.

Lemma factor_relation a b p : check_factor a b p = true -> 0 < common a -> (2 <= arity a)%nat -> forall i,
  let q := fun l => IZR (nth l p 0) in
  sum (S (length p - 1)) (fun l => q l * coefficient (coefficients a) (common a) (first a) (i - Z.of_nat l))%R =
  sum (S (length p - 1)) (fun l => q l * coefficient (coefficients b) (common b) (first a) (i - Z.of_nat (arity a) * Z.of_nat l))%R.
Proof.
  intros H Da HA i q. unfold check_factor in H. repeat rewrite andb_true_iff in H. destruct H as [[[[[_ _] Db] H0] _] Hs].
  apply Z.ltb_lt in Db. apply negb_true_iff, Z.eqb_neq in H0. apply same_spec in Hs.
  assert (Lp : S (length p - 1) = length p) by (destruct p; simpl in *; lia). rewrite Lp.
  assert (Pa : (0 < IZR (common a))%R) by (apply IZR_lt; auto). assert (Pb : (0 < IZR (common b))%R) by (apply IZR_lt; auto).
  assert (Scale : forall l e f k, 0 < e -> 0 < f ->
    coefficient (map (Z.mul e) l) (e * f) (first a) k = coefficient l f (first a) k).
  { intros l e f k He Hf. apply IZR_lt in He, Hf. rewrite coefficient_map. unfold coefficient. destruct (k <? first a). ring.
    rewrite mult_IZR. field. lra. }
  assert (E := f_equal (fun l => coefficient l (common b * common a) (first a) i) Hs). cbv beta in E.
  rewrite Scale in E by auto. rewrite (Z.mul_comm (common b)), Scale in E by auto. rewrite !coefficient_times in E.
  etransitivity; [|exact E]. apply sum_ext; intros l Hl. unfold q. do 2 f_equal. lia.
Qed.

(* The limits of both schemes are alike. *)
Theorem reduced_limit a c check : check_reduced a c check = true -> check (other_scheme c) = true /\
  ((2 <= arity a)%nat /\ arity (other_scheme c) = arity a) /\
  forall psi, limit_of (other_scheme c) psi -> exists phi, limit_of a phi /\ (forall s, exponents phi s <-> exponents psi s) /\
  (forall k, smooth continuity k phi -> smooth continuity k psi) /\
  forall lambda s P, exp lambda = INR (arity a) -> has_modulus lambda s P psi -> has_modulus lambda s P phi.
Proof.
  intros H. unfold check_reduced in H. repeat rewrite andb_true_iff in H. destruct H as [[HF HC] H]. split; auto.
  assert (Facts : (2 <= arity a)%nat /\ 0 < common a).
  { unfold converges in HC. cbv zeta in HC. repeat rewrite andb_true_iff in HC. destruct HC as [[[_ HC] _] _].
    unfold reducible in HC. repeat rewrite andb_true_iff in HC. destruct HC as [[[HA HD] _] _]. apply Nat.leb_le in HA.
    apply Z.ltb_lt in HD. auto. }
  destruct Facts as [HA HD]. destruct (converges_sound a c HC) as [phi Lim].
  assert (Rel := factor_relation a (other_scheme c) (shift_factor c) HF HD HA). cbv zeta in Rel.
  unfold check_factor in HF. repeat rewrite andb_true_iff in HF. destruct HF as [[[[[E1 E2] Db] H0] H1] _].
  apply Nat.eqb_eq in E1. apply Z.eqb_eq in E2. apply negb_true_iff, Z.eqb_neq in H0, H1. split; auto.
  set (p := shift_factor c) in *. set (b := other_scheme c) in *. set (q := fun l => IZR (nth l p 0)) in *.
  assert (Whole : sum (S (length p - 1)) q <> 0%R). { unfold q. rewrite sum_list by lia. apply not_0_IZR. auto. }
  assert (First : q O <> 0%R) by (apply not_0_IZR; auto).
  intros psi Lim'. exists phi. split; auto. unfold limit_of in Lim, Lim'. rewrite E1, E2 in Lim'. split; [|split].
  - intros s. eapply same_exponents; eauto using coefficient_supported.
  - intros k. eapply smooth_psi; eauto using coefficient_supported, closed_continuity.
  - intros lambda s P Log M. eapply modulus_phi; eauto using coefficient_supported.
Qed.

(* What the checker accepts is true. *)
Theorem check_reduced_exponent_lower_sound a c l cert :
  check_reduced a c (fun b => check_exponent_lower b l cert) = true -> exponent_holds a l.
Proof.
  intros H. apply reduced_limit in H. destruct H as [H [_ Same]]. apply check_exponent_lower_sound in H.
  destruct H as [psi [Lim Ex]].
  destruct (Same psi Lim) as [phi [Lim' [E _]]]. exists phi. split; auto. intros x Hx. destruct (Ex x Hx) as [s [Hs Xs]].
  exists s. split; auto. apply E. auto.
Qed.

Lemma reduced_enclosure a c check l u : (forall b, check b = true -> enclosure_holds b l u) ->
  check_reduced a c check = true -> enclosure_holds a l u.
Proof.
  intros Sound H. apply reduced_limit in H. destruct H as [H [_ Same]]. apply Sound in H. destruct H as [psi [Lim [Lo Hi]]].
  destruct (Same psi Lim) as [phi [Lim' [E _]]]. exists phi. split; auto. split.
  - intros x Hx. destruct (Lo x Hx) as [s [Hs Xs]]. exists s. split; auto. apply E. auto.
  - intros s Hs. apply Hi, E, Hs.
Qed.

Theorem check_reduced_exponent_sound a c l u cert :
  check_reduced a c (fun b => check_exponent b l u cert) = true -> enclosure_holds a l u.
Proof. apply reduced_enclosure. intros b. apply check_exponent_sound. Qed.

Theorem check_reduced_full_sound a c l u low shifts :
  check_reduced a c (fun b => check_full b l u low shifts) = true -> enclosure_holds a l u.
Proof. apply reduced_enclosure. intros b. apply check_full_sound. Qed.

Lemma same_lub (P Q : R -> Prop) s : (forall x, P x <-> Q x) -> is_lub Q s -> is_lub P s.
Proof.
  intros E [U M]. split. intros x Hx. apply U, E, Hx. intros b Hb. apply M. intros x Hx. apply Hb, E, Hx.
Qed.

Theorem check_reduced_exact_exponent_sound a c order e lower upper cert shifts :
  check_reduced a c (fun b => check_exact_exponent b order e lower upper cert shifts) = true ->
    exact_exponent_holds a order e lower upper.
Proof.
  intros H. apply reduced_limit in H. destruct H as [H [Ar Same]]. apply check_exact_exponent_sound in H.
  destruct H as [One [psi [r [s [lambda [Lim [Nr [Log [Es [Lub W]]]]]]]]]]. rewrite (proj2 Ar) in Log.
  destruct (Same psi Lim) as [phi [Lim' [E _]]]. split; auto. exists phi, r, s, lambda. split; auto. split; auto. split; auto.
  split; auto.
  split; auto. apply (same_lub _ _ s E Lub).
Qed.

Theorem check_reduced_logarithm_sound a c order e lower upper cert shifts proof P :
  check_reduced a c (fun b => check_logarithm b order e lower upper cert shifts proof P) = true ->
    logarithm_holds a order e lower upper P.
Proof.
  intros H. apply reduced_limit in H. destruct H as [H [Ar Same]]. apply check_logarithm_sound in H.
  destruct H as [One [psi [r [s [lambda [Lim [Nr [Log [Es [Lub [W M]]]]]]]]]]]. rewrite (proj2 Ar) in Log.
  destruct (Same psi Lim) as [phi [Lim' [E [_ Mod]]]]. split; auto. exists phi, r, s, lambda. split; auto. split; auto.
  split; auto. split; auto.
  split. apply (same_lub _ _ s E Lub). split; auto.
Qed.

(* That the limit is not C^k follows where the other scheme converges, by the first part of what is checked. *)
Definition converging (check : scheme -> bool) : Prop := forall b, check b = true -> exists psi, limit_of b psi.

Lemma lower_converges l cert : converging (fun b => check_exponent_lower b l cert).
Proof. intros b H. apply check_exponent_lower_sound in H. destruct H as [psi [H _]]. exists psi. exact H. Qed.

Lemma exact_exponent_converges order e lower upper cert shifts : converging (fun b => check_exact_exponent b order e lower
  upper cert shifts).
Proof. intros b H. apply check_exact_exponent_sound in H. destruct H as [_ [psi [r [s [lambda [H _]]]]]]. exists psi. exact H. Qed.

Lemma logarithm_converges order e lower upper cert shifts proof P :
  converging (fun b => check_logarithm b order e lower upper cert shifts proof P).
Proof. intros b H. apply check_logarithm_sound in H. destruct H as [_ [psi [r [s [lambda [H _]]]]]]. exists psi. exact H. Qed.

Lemma check_reduced_first a c f g : check_reduced a c (fun b => f b && g b) = true -> check_reduced a c f = true.
Proof. unfold check_reduced. rewrite !andb_true_iff. tauto. Qed.

Theorem check_reduced_rough_sound a c check order k shifts : converging check ->
  check_reduced a c (fun b => check b && check_rough b order k shifts) = true -> rough_holds a k.
Proof.
  intros Conv H.
  apply reduced_limit in H. destruct H as [H [Ar Same]]. apply andb_prop in H. destruct H as [H1 H2].
  destruct (Conv _ H1) as [psi Lim]. destruct (Same psi Lim) as [phi [Lim' [_ [Sm _]]]]. intros phi' Lim2 Sm2.
  apply (check_rough_sound _ _ _ _ H2 psi Lim), Sm. replace phi with phi'; auto. extensionality x.
  apply (limit_unique _ _ _ (proj1 Ar) _ _ _ Lim2 Lim').
Qed.
