(* Upper ends: if the coefficients of a combination of the shifts of the limit are bounded by its values, and some product of
   difference matrices is large, then the limit is not too smooth. Theorem 3 of SPEC.md. *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision Differences Coefficients.
Open Scope R_scope.

(* The sum of c (lo + k) phi (y - lo - k) over k < w *)
Definition combination (phi : R -> R) (c : Z -> R) (lo : Z) (w : nat) (y : R) : R :=
  sum w (fun k => c (lo + Z.of_nat k)%Z * phi (y - IZR (lo + Z.of_nat k))).
Definition inside (lo : Z) (w : nat) (c : Z -> R) : Prop := forall i, (i < lo \/ lo + Z.of_nat w <= i)%Z -> c i = 0.
Definition stable (phi : R -> R) : Prop := exists K, forall c lo w G, inside lo w c ->
  (forall y, Rabs (combination phi c lo w y) <= G) -> forall i, Rabs (c i) <= K * G.

(* ---- differences of sequences ------------------------------------------------------------------------------------ *)

Definition zback (s : Z) (f : Z -> R) : Z -> R := fun i => f i - f (i - s)%Z.
Fixpoint zbacks (m : nat) (s : Z) (f : Z -> R) : Z -> R := match m with O => f | S k => zback s (zbacks k s f) end.

Lemma zbacks_commute m s t f : forall i, zbacks m s (zback t f) i = zback t (zbacks m s f) i.
Proof.
  induction m; intros i; auto. simpl. unfold zback in *. rewrite !IHm. replace (i - s - t)%Z with (i - t - s)%Z by lia. lra.
Qed.

Lemma zbacks_scal m s r f : forall i, zbacks m s (fun i => r * f i) i = r * zbacks m s f i.
Proof. induction m; intros i; auto. simpl. unfold zback in *. rewrite !IHm. lra. Qed.

Lemma zbacks_ext m s f g : (forall i, f i = g i) -> forall i, zbacks m s f i = zbacks m s g i.
Proof. intros H. induction m; intros i; auto. simpl. unfold zback. rewrite !IHm. auto. Qed.

(* A sequence of bounded length is bounded by its differences. *)
Lemma zback_bound s J lo f D : (0 < s)%Z -> (forall i, (i < lo \/ lo + Z.of_nat J * s <= i)%Z -> f i = 0) ->
  (forall i, Rabs (zback s f i) <= D) -> forall i, Rabs (f i) <= INR J * D.
Proof.
  intros Hs H HD i. assert (D0 : 0 <= D) by (eapply Rle_trans; [apply Rabs_pos|apply (HD 0%Z)]).
  assert (P0 : 0 <= INR J * D) by (apply Rmult_le_pos; auto; apply pos_INR).
  destruct (Z_lt_ge_dec i (lo + Z.of_nat J * s)) as [L|L]; [|rewrite H, Rabs_R0 by lia; auto].
  assert (E : forall j, f i = sum j (fun k => zback s f (i - Z.of_nat k * s)%Z) + f (i - Z.of_nat j * s)%Z).
  { induction j. cbn [sum]. replace (i - Z.of_nat 0 * s)%Z with i by lia. lra.
    rewrite IHj. cbn [sum]. unfold zback at 3. replace (i - Z.of_nat j * s - s)%Z with (i - Z.of_nat (S j) * s)%Z by lia. lra. }
  rewrite (E J), (H (i - Z.of_nat J * s)%Z), Rplus_0_r by lia. eapply Rle_trans. apply sum_abs. apply sum_bound. auto.
Qed.

Section Scheme.
Variables (A : nat) (F : Z) (L : nat).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.
Notation steps a := (refined A F L a).

Lemma power_integer n : (0 < ZA ^ Z.of_nat n)%Z.
Proof. unfold ZA. apply Z.pow_pos_nonneg; lia. Qed.

(* ---- supports ---------------------------------------------------------------------------------------------------- *)

Lemma refined_support K a n : supported F K a -> (K <= L)%nat -> forall i,
  ((ZA - 1) * i < F * (ZA ^ Z.of_nat n - 1) \/ (F + Z.of_nat K) * (ZA ^ Z.of_nat n - 1) < (ZA - 1) * i)%Z -> steps a n i = 0.
Proof.
  intros H HK. induction n; intros i Hi.
  - simpl. unfold delta. destruct (Z.eqb_spec i 0); auto. subst. rewrite Z.mul_0_r in Hi. simpl in Hi. lia.
  - cbn [refined]. rewrite Nat2Z.inj_succ, Z.pow_succ_r in Hi by lia. assert (P := power_integer n). set (p := (ZA ^ Z.of_nat n)%Z) in *.
    assert (A2 : (2 <= ZA)%Z) by (unfold ZA; lia).
    unfold subdivide. apply sum_zero. intros m Hm. cbv zeta. fold ZA. set (j := ((i - F) / ZA - Z.of_nat L + Z.of_nat m)%Z). clearbody j.
    destruct (Z_lt_ge_dec ((ZA - 1) * j) (F * (p - 1))) as [J1|J1]. { rewrite IHn by auto. lra. }
    destruct (Z_lt_ge_dec ((F + Z.of_nat K) * (p - 1)) ((ZA - 1) * j)) as [J2|J2]. { rewrite IHn by auto. lra. }
    rewrite H. lra.
    assert (M1 : (ZA * (F * (p - 1)) <= ZA * ((ZA - 1) * j))%Z) by (apply Z.mul_le_mono_nonneg_l; lia).
    assert (M2 : (ZA * ((ZA - 1) * j) <= ZA * ((F + Z.of_nat K) * (p - 1)))%Z) by (apply Z.mul_le_mono_nonneg_l; lia).
    destruct (Z_lt_ge_dec (i - ZA * j) F); auto. destruct (Z_lt_ge_dec (F + Z.of_nat K) (i - ZA * j)); auto. exfalso.
    assert (M3 : ((ZA - 1) * F <= (ZA - 1) * (i - ZA * j))%Z) by (apply Z.mul_le_mono_nonneg_l; lia).
    assert (M4 : ((ZA - 1) * (i - ZA * j) <= (ZA - 1) * (F + Z.of_nat K))%Z) by (apply Z.mul_le_mono_nonneg_l; lia).
    clear - Hi M1 M2 M3 M4. destruct Hi; lia.
Qed.

Lemma refined_inside K a n : supported F K a -> (K <= L)%nat ->
  inside (F * (ZA ^ Z.of_nat n - 1) / (ZA - 1)) (Z.to_nat (Z.of_nat (K + 1) * ZA ^ Z.of_nat n)) (steps a n).
Proof.
  intros H HK i Hi. assert (P := power_integer n). set (p := (ZA ^ Z.of_nat n)%Z) in *. assert (A2 : (2 <= ZA)%Z) by (unfold ZA; lia).
  apply (refined_support K); auto. fold p.
  assert (D := Z.div_mod (F * (p - 1)) (ZA - 1) ltac:(lia)). assert (M := Z.mod_pos_bound (F * (p - 1)) (ZA - 1) ltac:(lia)).
  set (q := (F * (p - 1) / (ZA - 1))%Z) in *. rewrite Z2Nat.id in Hi by (apply Z.mul_nonneg_nonneg; lia). destruct Hi as [Hi|Hi]; [left|right].
  - assert ((ZA - 1) * i <= (ZA - 1) * (q - 1))%Z by (apply Z.mul_le_mono_nonneg_l; lia). lia.
  - assert (M1 : ((ZA - 1) * (q + Z.of_nat (K + 1) * p) <= (ZA - 1) * i)%Z) by (apply Z.mul_le_mono_nonneg_l; lia).
    assert (M2 : (1 * (Z.of_nat (K + 1) * p - 1) <= (ZA - 1) * (Z.of_nat (K + 1) * p - 1))%Z) by (apply Z.mul_le_mono_nonneg_r; nia).
    assert (M3 : (Z.of_nat (K + 1) * p = Z.of_nat K * p + p)%Z) by (rewrite Nat2Z.inj_add; ring).
    nia.
Qed.

(* ---- the limit is a combination of its own shifts ----------------------------------------------------------------- *)

Lemma refined_compose a n m lo w : inside lo w (steps a n) -> forall i,
  steps a (m + n) i = sum w (fun k => steps a n (lo + Z.of_nat k)%Z * steps a m (i - ZA ^ Z.of_nat m * (lo + Z.of_nat k))%Z).
Proof.
  intros H. induction m; intros i.
  - cbn [plus refined]. destruct (Z_lt_ge_dec i lo) as [I|I]; [|destruct (Z_lt_ge_dec i (lo + Z.of_nat w)) as [J|J]].
    + rewrite H, sum_zero; auto. intros k Hk. unfold delta. destruct (Z.eqb_spec (i - ZA ^ Z.of_nat 0 * (lo + Z.of_nat k)) 0); [|lra].
      change (ZA ^ Z.of_nat 0)%Z with 1%Z in e. lia.
    + transitivity (steps a n (lo + Z.of_nat (Z.to_nat (i - lo)))%Z). f_equal; lia.
      rewrite <- (sum_identity w (Z.to_nat (i - lo)) (fun k => steps a n (lo + Z.of_nat k)%Z)) by lia.
      apply sum_ext; intros k Hk. change (ZA ^ Z.of_nat 0)%Z with 1%Z. unfold identity, delta. cbv beta.
      destruct (Nat.eqb_spec k (Z.to_nat (i - lo))), (Z.eqb_spec (i - 1 * (lo + Z.of_nat k)) 0); try lra; exfalso; lia.
    + rewrite H by lia. rewrite sum_zero; auto. intros k Hk. unfold delta. destruct (Z.eqb_spec (i - ZA ^ Z.of_nat 0 * (lo + Z.of_nat k)) 0); [|lra].
      change (ZA ^ Z.of_nat 0)%Z with 1%Z in e. lia.
  - change (steps a (S m + n) i) with (subdivide A F L a (steps a (m + n)) i).
    rewrite (subdivide_ext A F L a _ _ i IHm), subdivide_sum. apply sum_ext; intros k Hk. f_equal.
    rewrite (subdivide_shift A F L Arity). cbn [refined]. f_equal. rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. fold ZA. ring.
Qed.

Lemma floor_shift m y l : floor (INR A ^ m * (y - IZR l)) = (floor (INR A ^ m * y) - ZA ^ Z.of_nat m * l)%Z.
Proof.
  apply (floor_unique A Arity). destruct (floor_bounds (INR A ^ m * y)). rewrite minus_IZR, mult_IZR. unfold ZA. rewrite (arity_power A Arity). lra.
Qed.

Section Limit.
Variables (a : Z -> R) (phi : R -> R).
Hypothesis Support : supported F L a.
Hypothesis Tends : tends A (steps a) phi.

Theorem refinement n lo w : inside lo w (steps a n) -> forall x, phi x = combination phi (steps a n) lo w (INR A ^ n * x).
Proof.
  intros H x. apply cond_eq. intros eps He.
  set (T := sum w (fun k => Rabs (steps a n (lo + Z.of_nat k)%Z))). assert (T0 : 0 <= T) by (apply sum_nonneg; intros; apply Rabs_pos).
  set (eta := eps / (2 * (1 + T))). assert (E0 : 0 < eta) by (apply Rdiv_lt_0_compat; lra).
  destruct (Tends eta E0) as [m Hm]. assert (H1 := Hm (m + n)%nat ltac:(lia) x).
  rewrite (refined_compose a n m lo w H) in H1. set (v := sum w _) in H1.
  assert (H2 : Rabs (v - combination phi (steps a n) lo w (INR A ^ n * x)) <= T * eta).
  { replace (T * eta) with (sum w (fun k => eta * Rabs (steps a n (lo + Z.of_nat k)%Z))) by (rewrite sum_scal; unfold T; ring).
    unfold v, combination. rewrite <- sum_minus. eapply Rle_trans. apply sum_abs. apply sum_le; intros k Hk.
    rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos.
    specialize (Hm m ltac:(lia) (INR A ^ n * x - IZR (lo + Z.of_nat k))). rewrite floor_shift in Hm.
    replace (INR A ^ m * (INR A ^ n * x)) with (INR A ^ (m + n) * x) in Hm by (rewrite pow_add; ring). exact Hm. }
  replace (phi x - combination phi (steps a n) lo w (INR A ^ n * x)) with
    (- (v - phi x) + (v - combination phi (steps a n) lo w (INR A ^ n * x))) by lra.
  eapply Rle_lt_trans. apply Rabs_triang. rewrite Rabs_Ropp.
  apply Rle_lt_trans with (eta * (1 + T)). lra. replace eps with (eta * (1 + T) * 2) by (unfold eta; field; lra).
  assert (0 < eta * (1 + T)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* The support of the limit *)
Lemma limit_vanishes : vanishes (IZR F / (INR A - 1)) (IZR (F + Z.of_nat L) / (INR A - 1)) phi.
Proof.
  assert (A2 : 2 <= INR A) by (apply (le_INR 2); auto). assert (PA := arity_positive A Arity).
  assert (IA : INR A = IZR ZA) by (unfold ZA; apply INR_IZR_INZ).
  intros x Hx. apply cond_eq. intros eps He. rewrite Rminus_0_r.
  destruct (Tends (eps / 2) ltac:(lra)) as [n0 H0].
  set (gap := if Rlt_dec ((INR A - 1) * x) (IZR F) then IZR F - (INR A - 1) * x else (INR A - 1) * x - IZR (F + Z.of_nat L)).
  assert (Gap : 0 < gap).
  { unfold gap. destruct (Rlt_dec ((INR A - 1) * x) (IZR F)); [lra|]. destruct Hx as [Hx|Hx].
    - exfalso. apply n. apply (Rmult_lt_compat_l (INR A - 1)) in Hx; [|lra]. replace ((INR A - 1) * (IZR F / (INR A - 1))) with (IZR F) in Hx by (field; lra). auto.
    - apply (Rmult_lt_compat_l (INR A - 1)) in Hx; [|lra].
      replace ((INR A - 1) * (IZR (F + Z.of_nat L) / (INR A - 1))) with (IZR (F + Z.of_nat L)) in Hx by (field; lra). lra. }
  set (R0 := Rabs (IZR F) + Rabs (IZR (F + Z.of_nat L)) + INR A).
  assert (R1 : 0 < R0) by (unfold R0; generalize (Rabs_pos (IZR F)) (Rabs_pos (IZR (F + Z.of_nat L))); lra).
  destruct (small_cell A Arity (gap / (2 * R0)) ltac:(apply Rdiv_lt_0_compat; lra)) as [n1 H1].
  set (n := (n0 + n1)%nat). specialize (H0 n ltac:(unfold n; lia) x). specialize (H1 n ltac:(unfold n; lia)).
  assert (P := power_positive A Arity n).
  assert (Big : R0 < INR A ^ n * gap).
  { apply (Rmult_le_compat_l (INR A ^ n * (2 * R0))) in H1; [|apply Rmult_le_pos; lra].
    replace (INR A ^ n * (2 * R0) * / INR A ^ n) with (2 * R0) in H1 by (field; lra).
    replace (INR A ^ n * (2 * R0) * (gap / (2 * R0))) with (INR A ^ n * gap) in H1 by (field; lra). lra. }
  rewrite (refined_support L a n Support (le_n L)) in H0.
  - rewrite Rminus_0_l, Rabs_Ropp in H0. lra.
  - set (i := floor (INR A ^ n * x)). destruct (floor_bounds (INR A ^ n * x)) as [F1 F2]. fold i in F1, F2.
    assert (AF := Rle_abs (IZR F)). assert (AL := Rle_abs (IZR (F + Z.of_nat L))).
    assert (AF' := Rle_abs (- IZR F)). assert (AL' := Rle_abs (- IZR (F + Z.of_nat L))). rewrite Rabs_Ropp in AF', AL'.
    unfold gap in Big. destruct (Rlt_dec ((INR A - 1) * x) (IZR F)); [left|right].
    + apply lt_IZR. rewrite !mult_IZR, !minus_IZR. unfold ZA at 2. rewrite (arity_power A Arity), <- IA.
      assert ((INR A - 1) * IZR i <= (INR A - 1) * (INR A ^ n * x)) by (apply Rmult_le_compat_l; lra). unfold R0 in Big. lra.
    + apply lt_IZR. rewrite !mult_IZR, !minus_IZR. unfold ZA at 1. rewrite (arity_power A Arity), <- IA.
      assert ((INR A - 1) * (INR A ^ n * x - 1) <= (INR A - 1) * IZR i) by (apply Rmult_le_compat_l; lra). unfold R0 in Big. lra.
Qed.
End Limit.

(* ---- differences of the limit -------------------------------------------------------------------------------------- *)

Lemma combination_back phi c lo w y : inside lo w c ->
  combination phi c lo w y - combination phi c lo w (y - 1) = combination phi (zback 1 c) lo (w + 1) y.
Proof.
  intros H. unfold combination.
  transitivity (sum (w + 1) (fun k => c (lo + Z.of_nat k)%Z * phi (y - IZR (lo + Z.of_nat k))) -
                sum (w + 1) (fun k => c (lo + Z.of_nat k - 1)%Z * phi (y - IZR (lo + Z.of_nat k)))).
  - f_equal.
    + rewrite sum_add. cbn [sum]. rewrite (H (lo + Z.of_nat (w + 0))%Z) by lia. lra.
    + replace (w + 1)%nat with (1 + w)%nat by lia. rewrite sum_add. cbn [sum]. rewrite (H (lo + Z.of_nat 0 - 1)%Z) by lia.
      rewrite Rplus_0_l, Rmult_0_l, Rplus_0_l. apply sum_ext; intros k Hk. f_equal. f_equal. lia. f_equal.
      rewrite (Nat2Z.inj_add 1 k), !plus_IZR. simpl. lra.
  - rewrite <- sum_minus. apply sum_ext; intros k Hk. unfold zback. lra.
Qed.

Lemma inside_back lo w c : inside lo w c -> inside lo (w + 1) (zback 1 c).
Proof. intros H i Hi. unfold zback. rewrite !H by lia. lra. Qed.

Lemma combination_backs phi c lo w n M : inside lo w c -> forall x,
  inside lo (w + M) (zbacks M 1 c) /\
  backs M (/ INR A ^ n) (fun x => combination phi c lo w (INR A ^ n * x)) x = combination phi (zbacks M 1 c) lo (w + M) (INR A ^ n * x).
Proof.
  intros H. induction M; intros x.
  - rewrite Nat.add_0_r. simpl. auto.
  - replace (w + S M)%nat with (w + M + 1)%nat by lia. destruct (IHM x) as [I E]. split. apply inside_back; auto.
    cbn [backs zbacks]. unfold back. rewrite E. destruct (IHM (x - / INR A ^ n)) as [_ E']. rewrite E'.
    rewrite <- combination_back by auto. f_equal. f_equal. assert (P := power_positive A Arity n). field. lra.
Qed.

Lemma zbacks_refined N b n : supported F N b -> forall M, (N + M * (A - 1) <= L)%nat -> forall i,
  zbacks M 1 (steps (smoothed A M b) n) i = (/ INR A ^ n) ^ M * zbacks M (ZA ^ Z.of_nat n) (steps b n) i.
Proof.
  intros H. induction M; intros HM i. simpl. lra.
  rewrite Nat.mul_succ_l in HM.
  cbn [smoothed]. cbn [zbacks]. rewrite <- zbacks_commute.
  rewrite (zbacks_ext M 1 _ (fun i => / INR A ^ n * zback (ZA ^ Z.of_nat n) (steps (smoothed A M b) n) i)).
  - rewrite zbacks_scal, zbacks_commute. unfold zback. rewrite !IHM by (revert HM; generalize (M * (A - 1))%nat; lia).
    simpl pow. ring.
  - intros j. unfold zback. apply (refined_difference A F L Arity (N + M * (A - 1))).
    apply (smoothed_supported A F Arity); auto. revert HM; generalize (M * (A - 1))%nat; lia.
Qed.

Lemma zbacks_bound J m s lo f D : (0 < s)%Z -> (forall i, (i < lo \/ lo + Z.of_nat J * s <= i)%Z -> f i = 0) ->
  (forall i, Rabs (zbacks m s f i) <= D) -> forall i, Rabs (f i) <= INR (J + m) ^ m * D.
Proof.
  intros Hs H. revert D. induction m; intros D HD i. simpl. rewrite Rmult_1_l. apply HD.
  assert (D0 : 0 <= D) by (eapply Rle_trans; [apply Rabs_pos|apply (HD 0%Z)]).
  assert (In : forall k i, (i < lo \/ lo + Z.of_nat (J + k) * s <= i)%Z -> zbacks k s f i = 0).
  { induction k; intros j Hj. apply H. rewrite Nat.add_0_r in Hj. auto. simpl. unfold zback. rewrite !IHk. lra.
    rewrite Nat.add_succ_r, Nat2Z.inj_succ in Hj. lia. rewrite Nat.add_succ_r, Nat2Z.inj_succ in Hj. nia. }
  apply Rle_trans with (INR (J + m) ^ m * (INR (J + m) * D)).
  - apply IHm. apply (zback_bound s (J + m) lo); auto.
  - assert (P : 0 <= INR (J + m)) by apply pos_INR. assert (Q : INR (J + m) <= INR (J + S m)) by (apply le_INR; lia).
    rewrite <- tech_pow_Rmult, (Rmult_comm (INR (J + S m))), Rmult_assoc.
    apply Rmult_le_compat. apply pow_le; auto. apply Rmult_le_pos; auto. apply pow_incr; auto. apply Rmult_le_compat_r; auto.
Qed.

(* ---- Theorem 3 ----------------------------------------------------------------------------------------------------- *)

Section Upper.
Variables (lambda : R) (N M : nat) (b : Z -> R) (phi : R -> R).
Hypothesis Log : exp lambda = INR A.
Hypothesis Support : supported F N b.
Hypothesis Fits : (N + M * (A - 1) <= L)%nat.
Let a := smoothed A M b.
Hypothesis Tends : tends A (steps a) phi.
Hypothesis Stable : stable phi.

(* Smoothness of the limit bounds the coefficients of the differences. *)
Lemma smooth_coefficients k alpha : 0 < alpha -> holder k alpha phi -> exists C e, (e = INR M \/ e = INR k + alpha) /\
  forall n i, Rabs (steps b n i) <= C * exp ((INR M - e) * lambda) ^ n.
Proof.
  intros Ha H. assert (SA : supported F L a).
  { apply (supported_more A F Arity (N + M * (A - 1))); auto. apply (smoothed_supported A F Arity); auto. }
  destruct (differences_bounded _ _ M k alpha phi Ha H (limit_vanishes a phi SA Tends)) as [C [e [He HC]]].
  destruct Stable as [K HK]. exists (INR (N + 1 + M) ^ M * (K * C)), e. split; auto. intros n i.
  assert (P := power_positive A Arity n). assert (IP := power_integer n).
  assert (Et : exp (- (INR n * lambda)) = / INR A ^ n) by (rewrite exp_Ropp, <- exp_power, Log; auto).
  (* the differences of the refined data *)
  assert (Small : forall j, Rabs (zbacks M 1 (steps a n) j) <= K * (C * exp (e * - (INR n * lambda)))).
  { assert (In := refined_inside L a n SA (le_n L)). set (lo := (F * (ZA ^ Z.of_nat n - 1) / (ZA - 1))%Z) in *. set (w := Z.to_nat _) in In.
    apply (HK _ lo (w + M)%nat). apply (combination_backs phi (steps a n) lo w n M In 0).
    intros y. replace y with (INR A ^ n * (y / INR A ^ n)) by (field; lra).
    destruct (combination_backs phi (steps a n) lo w n M In (y / INR A ^ n)) as [_ E]. rewrite <- E.
    replace (fun x => combination phi (steps a n) lo w (INR A ^ n * x)) with phi by (extensionality x; apply (refinement a phi Tends n lo w In)).
    rewrite <- Et. apply HC. }
  assert (Back : forall j, Rabs (zbacks M (ZA ^ Z.of_nat n) (steps b n) j) <= K * C * exp ((INR M - e) * lambda) ^ n).
  { intros j. specialize (Small j). unfold a in Small. rewrite (zbacks_refined N) in Small by auto.
    rewrite Rabs_mult in Small. rewrite Rabs_pos_eq in Small by (apply pow_le; left; apply Rinv_0_lt_compat; auto).
    apply (Rmult_le_compat_l ((INR A ^ n) ^ M)) in Small; [|apply pow_le; lra].
    rewrite <- Rmult_assoc, <- Rpow_mult_distr, Rinv_r, pow1, Rmult_1_l in Small by lra. eapply Rle_trans. apply Small. right.
    rewrite <- Log, exp_power, exp_power, exp_power.
    replace (exp (INR M * (INR n * lambda)) * (K * (C * exp (e * - (INR n * lambda))))) with
      (K * C * (exp (INR M * (INR n * lambda)) * exp (e * - (INR n * lambda)))) by ring.
    rewrite <- exp_plus. f_equal. f_equal. ring. }
  rewrite (Rmult_assoc (INR (N + 1 + M) ^ M)).
  apply (zbacks_bound (N + 1) M (ZA ^ Z.of_nat n) (F * (ZA ^ Z.of_nat n - 1) / (ZA - 1)) (steps b n)); auto.
  intros j Hj. assert (In := refined_inside N b n Support ltac:(revert Fits; generalize (M * (A - 1))%nat; lia)). apply In.
  rewrite Z2Nat.id by (apply Z.mul_nonneg_nonneg; lia). exact Hj.
Qed.
End Upper.
End Scheme.

(* Theorem 3 of SPEC.md *)
Theorem radius_upper A N W b L F M lambda phi g u : (2 <= A)%nat -> (forall i, (i < 0 \/ Z.of_nat N < i)%Z -> b i = 0) ->
  (N <= W * (A - 1))%nat -> (1 <= W)%nat -> (N + M * (A - 1) <= L)%nat -> exp lambda = INR A ->
  tends A (refined A F L (smoothed A M (fun i => b (i - F)%Z))) phi -> stable phi ->
  radius_at_least W A (scheme_matrix A b) g -> 1 < g -> exp ((INR M - u) * lambda) <= g -> exponent_at_most phi u.
Proof.
  intros HA Sb W1 W2 HL Log T St HG G1 GU s [k [alpha [Ha [Es H]]]].
  destruct (smooth_coefficients A F L HA lambda N M (fun i => b (i - F)%Z) phi Log ltac:(intros i Hi; apply Sb; lia) HL T St k alpha ltac:(lra) H)
    as [C [e [He HC]]].
  assert (Gr : growth W A (scheme_matrix A b) (exp ((INR M - e) * lambda))).
  { exists C. intros w Hw i j Hi Hj. rewrite (product_coefficient A N W b HA Sb W1 W2) by auto.
    set (x := (Z.of_nat A ^ Z.of_nat (length w) * Z.of_nat i + offset A w - Z.of_nat j)%Z).
    specialize (HC (length w) (x + shift A F (length w))%Z).
    rewrite (refined_power A N W b HA Sb W1 W2 L) in HC by (revert HL; generalize (M * (A - 1))%nat; lia).
    replace (x + shift A F (length w) - shift A F (length w))%Z with x in HC by lia. exact HC. }
  apply HG in Gr; [|left; apply exp_pos]. assert (LP := log_positive A HA lambda Log). destruct He as [->| ->].
  - rewrite Rminus_diag_eq, Rmult_0_l, exp_0 in Gr by auto. lra.
  - assert (X : (INR M - u) * lambda <= (INR M - (INR k + alpha)) * lambda) by (apply exp_reflects; lra).
    apply Rmult_le_reg_r in X; auto. lra.
Qed.
