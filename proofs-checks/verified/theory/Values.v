(* Exact values of the limit at the integers and at A-adic points, and stability of its shifts by a combination of values. *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision Differences Stability.
Import ListNotations.
Open Scope R_scope.

Lemma for_large n (P : nat -> nat -> Prop) : (forall m, (m < n)%nat -> exists R0, forall r, (R0 <= r)%nat -> P m r) ->
  exists R0, forall r, (R0 <= r)%nat -> forall m, (m < n)%nat -> P m r.
Proof.
  induction n; intros H. exists O. intros; lia.
  destruct IHn as [R1 H1]. { intros. apply H. lia. } destruct (H n ltac:(lia)) as [R2 H2].
  exists (R1 + R2)%nat. intros r Hr m Hm. destruct (Nat.eq_dec m n). subst. apply H2. lia. apply H1; lia.
Qed.

Lemma largest c lo w : inside lo w c -> exists i, forall j, Rabs (c j) <= Rabs (c i).
Proof.
  revert c. induction w; intros c H.
  - exists lo. intros j. rewrite (H j) by lia. rewrite Rabs_R0. apply Rabs_pos.
  - set (top := (lo + Z.of_nat w)%Z). destruct (IHw (fun i => if Z.eqb i top then 0 else c i)) as [i Hi].
    { intros j Hj. destruct (Z.eqb_spec j top); auto. apply H. unfold top in n. lia. }
    assert (Hi' : forall j, j <> top -> Rabs (c j) <= Rabs (c i)).
    { intros j Hj. specialize (Hi j). destruct (Z.eqb_spec j top); [lia|]. destruct (Z.eqb_spec i top).
      rewrite Rabs_R0 in Hi. generalize (Rabs_pos (c i)). lra. auto. }
    destruct (Rle_lt_dec (Rabs (c top)) (Rabs (c i))); [exists i|exists top]; intros j; destruct (Z.eq_dec j top);
      try (subst j; lra); specialize (Hi' j n); lra.
Qed.

(* Sums of values do not depend on the window, forwards or backwards. *)
Lemma sum_reflect (g : Z -> R) lo m lo' m' : (forall l, (l < lo \/ lo + Z.of_nat m <= l)%Z -> g l = 0) ->
  (forall l, (- l < lo' \/ lo' + Z.of_nat m' <= - l)%Z -> g l = 0) ->
  sum m' (fun i => g (- (lo' + Z.of_nat i))%Z) = sum m (fun i => g (lo + Z.of_nat i)%Z).
Proof.
  intros H H'. rewrite sum_reverse. rewrite <- (sum_two_windows g (- (lo' + Z.of_nat m' - 1)) m' lo m); auto.
  - apply sum_ext; intros i Hi. f_equal. lia.
  - intros l Hl. apply H'. lia.
Qed.

Section Values.
Variables (A : nat) (F : Z) (L : nat).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.
Notation steps a := (refined A F L a).
Variables (a : Z -> R) (phi : R -> R).
Hypothesis Support : supported F L a.
Hypothesis Classes : forall i, subdivide A F L a (fun _ => 1) i = 1.
Hypothesis Tends : tends A (steps a) phi.

(* ---- the shifts sum to 1 ------------------------------------------------------------------------------------------- *)

Lemma refined_partition n : forall i, exists R0, forall r, (R0 <= r)%nat ->
  sum (2 * r + 1) (fun k => steps a n (i - ZA ^ Z.of_nat n * (- Z.of_nat r + Z.of_nat k))%Z) = 1.
Proof.
  induction n; intros i.
  - exists (Z.abs_nat i). intros r Hr. change (ZA ^ Z.of_nat 0)%Z with 1%Z. cbn [refined].
    rewrite <- (sum_identity (2 * r + 1) (Z.to_nat (i + Z.of_nat r)) (fun _ => 1)) by lia. apply sum_ext; intros k Hk.
    unfold delta, identity. cbv beta. destruct (Z.eqb_spec (i - 1 * (- Z.of_nat r + Z.of_nat k)) 0), (Nat.eqb_spec k (Z.to_nat (i + Z.of_nat r)));
      try lra; exfalso; lia.
  - set (y := fun m : nat => ((i - F) / Z.of_nat A - Z.of_nat L + Z.of_nat m)%Z).
    destruct (for_large (S L) (fun m r => sum (2 * r + 1) (fun k => steps a n (y m - ZA ^ Z.of_nat n * (- Z.of_nat r + Z.of_nat k))%Z) = 1)) as [R0 H].
    { intros m _. apply IHn. }
    exists R0. intros r Hr. specialize (H r Hr).
    rewrite (sum_ext _ _ (fun k => 1 * subdivide A F L a (fun j => steps a n (j - ZA ^ Z.of_nat n * (- Z.of_nat r + Z.of_nat k))%Z) i)).
    + rewrite <- subdivide_sum. etransitivity; [|exact (Classes i)]. unfold subdivide. apply sum_ext; intros m Hm. cbv zeta. f_equal.
      etransitivity; [|exact (H m Hm)]. apply sum_ext; intros k Hk. apply Rmult_1_l.
    + intros k Hk. rewrite (subdivide_shift A F L Arity), Rmult_1_l. cbn [refined]. f_equal. rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. fold ZA. ring.
Qed.

Variables (start : Z) (w : nat).
Hypothesis Low : ((ZA - 1) * start <= F)%Z.
Hypothesis High : (F + Z.of_nat L <= (ZA - 1) * (start + Z.of_nat w - 1))%Z.

Lemma arity_integer : INR A = IZR ZA.
Proof. unfold ZA. apply INR_IZR_INZ. Qed.

Lemma phi_outside j : (j < start \/ start + Z.of_nat w <= j)%Z -> phi (IZR j) = 0.
Proof.
  intros Hj. apply (limit_vanishes A F L Arity a phi Support Tends). assert (A2 : 2 <= INR A) by (apply (le_INR 2); auto).
  assert (IA := arity_integer). assert (HA : (2 <= ZA)%Z) by (unfold ZA; lia).
  destruct Hj as [Hj|Hj]; [left|right]; apply (Rmult_lt_reg_l (INR A - 1)); try lra.
  - replace ((INR A - 1) * (IZR F / (INR A - 1))) with (IZR F) by (field; lra).
    replace (INR A - 1) with (IZR (ZA - 1)) by (rewrite minus_IZR, IA; auto). rewrite <- mult_IZR. apply IZR_lt.
    assert ((ZA - 1) * j <= (ZA - 1) * (start - 1))%Z by (apply Z.mul_le_mono_nonneg_l; lia). lia.
  - replace ((INR A - 1) * (IZR (F + Z.of_nat L) / (INR A - 1))) with (IZR (F + Z.of_nat L)) by (field; lra).
    replace (INR A - 1) with (IZR (ZA - 1)) by (rewrite minus_IZR, IA; auto). rewrite <- mult_IZR. apply IZR_lt.
    assert ((ZA - 1) * (start + Z.of_nat w) <= (ZA - 1) * j)%Z by (apply Z.mul_le_mono_nonneg_l; lia). lia.
Qed.

Lemma power_large n : (Z.of_nat n < ZA ^ Z.of_nat n)%Z.
Proof.
  assert (HA : (2 <= ZA)%Z) by (unfold ZA; lia). induction n. simpl. lia.
  rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. nia.
Qed.

Lemma partition_of_unity : sum w (fun k => phi (IZR (start + Z.of_nat k))) = 1.
Proof.
  apply cond_eq. intros eps He. set (eta := eps / (2 * (INR w + 1))).
  assert (W0 : 0 <= INR w) by apply pos_INR. assert (E0 : 0 < eta) by (apply Rdiv_lt_0_compat; lra).
  destruct (Tends eta E0) as [n0 Hn]. set (n := (n0 + Z.abs_nat F + Z.abs_nat (F + Z.of_nat L))%nat).
  specialize (Hn n ltac:(unfold n; lia)).
  (* the refined data at the integers vanish outside, too *)
  assert (P := power_large n). assert (HA : (2 <= ZA)%Z) by (unfold ZA; lia).
  assert (Out : forall j, (j < start \/ start + Z.of_nat w <= j)%Z -> steps a n (ZA ^ Z.of_nat n * j)%Z = 0).
  { intros j Hj. apply (refined_support A F L Arity L a n Support (le_n L)). fold ZA. set (p := (ZA ^ Z.of_nat n)%Z) in *.
    assert (B1 : (Z.abs F < p)%Z) by (unfold n in P; lia). assert (B2 : (Z.abs (F + Z.of_nat L) < p)%Z) by (unfold n in P; lia). clear P.
    assert (PA : (1 * p <= (ZA - 1) * p)%Z) by (apply Z.mul_le_mono_nonneg_r; lia).
    destruct Hj as [Hj|Hj]; [left|right].
    - assert (M1 : ((ZA - 1) * (j + 1) <= (ZA - 1) * start)%Z) by (apply Z.mul_le_mono_nonneg_l; lia).
      assert (M2 : (p * ((ZA - 1) * (j + 1)) <= p * F)%Z) by (apply Z.mul_le_mono_nonneg_l; lia). lia.
    - assert (M1 : ((ZA - 1) * (start + Z.of_nat w) <= (ZA - 1) * j)%Z) by (apply Z.mul_le_mono_nonneg_l; lia).
      assert (M2 : (p * (F + Z.of_nat L + (ZA - 1)) <= p * ((ZA - 1) * j))%Z) by (apply Z.mul_le_mono_nonneg_l; lia). lia. }
  assert (S1 : sum w (fun k => steps a n (ZA ^ Z.of_nat n * (start + Z.of_nat k))%Z) = 1).
  { destruct (refined_partition n 0) as [r0 Hr]. set (r := (r0 + Z.abs_nat start + Z.abs_nat (start + Z.of_nat w) + 1)%nat).
    specialize (Hr r ltac:(unfold r; lia)). rewrite <- Hr. symmetry.
    rewrite <- (sum_reflect (fun j => steps a n (ZA ^ Z.of_nat n * j)%Z) start w (- Z.of_nat r) (2 * r + 1)).
    - apply sum_ext; intros k Hk. f_equal. ring.
    - exact Out.
    - intros l Hl. apply Out. unfold r in *. lia. }
  rewrite <- S1, <- sum_minus. eapply Rle_lt_trans. apply sum_abs.
  apply Rle_lt_trans with (INR w * eta).
  - apply sum_bound. intros k Hk. specialize (Hn (IZR (start + Z.of_nat k))). rewrite Rabs_minus_sym.
    replace (floor (INR A ^ n * IZR (start + Z.of_nat k))) with (ZA ^ Z.of_nat n * (start + Z.of_nat k))%Z in Hn. exact Hn.
    rewrite <- (arity_power A Arity), <- mult_IZR, (floor_integer A Arity). reflexivity.
  - replace eps with ((INR w + 1) * eta * 2) by (unfold eta; field; lra).
    assert (0 < (INR w + 1) * eta) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* The values at the integers solve the equation phi(i) = sum of a (A i - j) phi(j). *)
Lemma values_refine i : phi (IZR i) = sum w (fun k => a (ZA * i - (start + Z.of_nat k))%Z * phi (IZR (start + Z.of_nat k))).
Proof.
  assert (E : forall j, steps a 1 j = a j). { intros j. cbn [refined]. apply (subdivide_point A F L Arity a j Support). }
  rewrite (refinement A F L Arity a phi Tends 1 F (S L)).
  - unfold combination. rewrite pow_1, arity_integer, <- mult_IZR.
    set (g := fun j => a (ZA * i - j)%Z * phi (IZR j)).
    change (sum w (fun k => a (ZA * i - (start + Z.of_nat k))%Z * phi (IZR (start + Z.of_nat k)))) with (sum w (fun k => g (start + Z.of_nat k)%Z)).
    rewrite <- (sum_reflect g start w (F - ZA * i) (S L)).
    + apply sum_ext; intros k Hk. unfold g. rewrite E, <- minus_IZR. f_equal; f_equal; [|f_equal]; lia.
    + intros l Hl. unfold g. rewrite phi_outside by auto. lra.
    + intros l Hl. unfold g. rewrite Support by lia. lra.
  - intros j Hj. rewrite E. apply Support. lia.
Qed.

End Values.

(* ---- stability ------------------------------------------------------------------------------------------------------ *)

Lemma sum_peak n f k : (k < n)%nat -> 2 * Rabs (f k) - sum n (fun i => Rabs (f i)) <= Rabs (sum n f).
Proof.
  induction n; intros Hk. lia. cbn [sum]. destruct (Nat.eq_dec k n) as [->|].
  - assert (T := sum_abs n f). assert (U := Rabs_triang_inv (f n) (- sum n f)). rewrite Rabs_Ropp in U.
    replace (f n - - sum n f) with (sum n f + f n) in U by lra. lra.
  - specialize (IHn ltac:(lia)). assert (U := Rabs_triang_inv (sum n f) (- f n)). rewrite Rabs_Ropp in U.
    replace (sum n f - - f n) with (sum n f + f n) in U by lra. lra.
Qed.

Section Stable.
Variables (A : nat) (phi : R -> R).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.

(* A combination of values is nearly 1 for phi and nearly 0 for its shifts. *)
Theorem stable_by_values m nw v omega (h : Z -> R) r0 r1 :
  (forall r, sum nw (fun k => omega k * phi (IZR (Z.of_nat k + ZA ^ Z.of_nat m * r) / INR A ^ m)) = h r) ->
  inside r1 v h -> sum v (fun k => Rabs (h (r1 + Z.of_nat k)%Z)) < 2 * Rabs (h r0) -> stable phi.
Proof.
  intros HH In Peak. set (H := sum v (fun k => Rabs (h (r1 + Z.of_nat k)%Z))) in *.
  set (W := sum nw (fun k => Rabs (omega k))). exists (W / (2 * Rabs (h r0) - H)). intros c lo w' G Hc HG i.
  destruct (largest c lo w' Hc) as [s Hs]. set (t := (s + r0)%Z). assert (P := power_positive A Arity m).
  assert (ET : sum nw (fun k => omega k * combination phi c lo w' (IZR t + INR k / INR A ^ m)) =
    sum w' (fun l => c (lo + Z.of_nat l)%Z * h (t - (lo + Z.of_nat l))%Z)).
  { unfold combination. rewrite (sum_ext nw _ (fun k => sum w' (fun l =>
      omega k * (c (lo + Z.of_nat l)%Z * phi (IZR t + INR k / INR A ^ m - IZR (lo + Z.of_nat l)))))).
    2:{ intros k Hk. rewrite <- sum_scal. auto. }
    rewrite sum_swap. apply sum_ext; intros l Hl. rewrite <- HH, <- sum_scal. apply sum_ext; intros k Hk.
    replace (IZR (Z.of_nat k + ZA ^ Z.of_nat m * (t - (lo + Z.of_nat l))) / INR A ^ m) with (IZR t + INR k / INR A ^ m - IZR (lo + Z.of_nat l)). ring.
    rewrite (plus_IZR (Z.of_nat k)), mult_IZR, (arity_power A Arity), (minus_IZR t), <- (INR_IZR_INZ k). field. lra. }
  assert (BT : Rabs (sum w' (fun l => c (lo + Z.of_nat l)%Z * h (t - (lo + Z.of_nat l))%Z)) <= W * G).
  { rewrite <- ET. eapply Rle_trans. apply sum_abs. unfold W. rewrite Rmult_comm, <- sum_scal. apply sum_le; intros k Hk.
    rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos. apply HG. }
  set (e := (Z.abs lo + Z.of_nat w' + Z.abs t + Z.abs r1 + Z.of_nat v + Z.abs s + 1)%Z).
  set (g := fun l => c l * h (t - l)%Z).
  assert (EX : sum (Z.to_nat (2 * e)) (fun l => g (- e + Z.of_nat l)%Z) = sum w' (fun l => g (lo + Z.of_nat l)%Z)).
  { apply (sum_window g lo w'). intros l Hl. unfold g. rewrite (Hc l Hl). lra. unfold e; lia. unfold e; lia. }
  unfold g in EX at 2. rewrite <- EX in BT.
  assert (PK := sum_peak (Z.to_nat (2 * e)) (fun l => g (- e + Z.of_nat l)%Z) (Z.to_nat (s + e)) ltac:(unfold e; lia)). cbv beta in PK.
  replace (- e + Z.of_nat (Z.to_nat (s + e)))%Z with s in PK by (unfold e; lia).
  assert (TotalH : sum (Z.to_nat (2 * e)) (fun l => Rabs (h (t - (- e + Z.of_nat l))%Z)) = H).
  { unfold H. transitivity (sum v (fun k => (fun l => Rabs (h (t + l)%Z)) (r1 - t + Z.of_nat k)%Z)).
    - rewrite <- (sum_reflect (fun l => Rabs (h (t + l)%Z)) (r1 - t) v (- e) (Z.to_nat (2 * e))).
      + apply sum_ext; intros x Hx. cbv beta. f_equal; f_equal; lia.
      + intros l Hl. rewrite In, Rabs_R0 by lia. auto.
      + intros l Hl. rewrite In, Rabs_R0; auto. unfold e in Hl. lia.
    - apply sum_ext; intros x Hx. cbv beta. f_equal; f_equal; lia. }
  assert (Sum : sum (Z.to_nat (2 * e)) (fun l => Rabs (g (- e + Z.of_nat l)%Z)) <= Rabs (c s) * H).
  { rewrite <- TotalH, <- sum_scal. apply sum_le; intros l Hl. unfold g. rewrite Rabs_mult. apply Rmult_le_compat_r. apply Rabs_pos. apply Hs. }
  unfold g in PK at 1. rewrite Rabs_mult in PK. unfold t in PK at 1. replace (s + r0 - s)%Z with r0 in PK by lia.
  eapply Rle_trans. apply (Hs i). apply (Rmult_le_reg_r (2 * Rabs (h r0) - H)). lra.
  replace (W / (2 * Rabs (h r0) - H) * G * (2 * Rabs (h r0) - H)) with (W * G) by (field; lra). lra.
Qed.
End Stable.
