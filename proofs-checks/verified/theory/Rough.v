(* Theorem 23 of SPEC.md: where the integer shifts are stable and the mask has a factor (1 + z + ... + z^(A-1))^M but not one
   more, the limit is not C^M. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Integers Sections Subdivision Differences Stability Modulus Values Smooth Exponent
  Enclosure Logarithm.
Import ListNotations.
Open Scope R_scope.

(* Differences divided by powers of their step are near the derivative. *)
Lemma backs_near m : forall f g, derivative m f g -> forall h v w x, 0 < h ->
  (forall t, x - INR m * h <= t <= x -> Rabs (g t - v) <= w) -> Rabs (backs m h f x - h ^ m * v) <= h ^ m * w.
Proof.
  induction m; intros f g H h v w x Hh Hw.
  - simpl. rewrite !Rmult_1_l, H. apply Hw. simpl. lra.
  - destruct H as [f' [D H]].
    assert (I : forall t, x - h <= t <= x -> Rabs (backs m h f' t - h ^ m * v) <= h ^ m * w).
    { intros t Ht. apply (IHm f' g H); auto. intros y Hy. apply Hw. rewrite S_INR. lra. }
    assert (MV := mean_value_within (fun t => backs m h f t - h ^ m * v * t) (fun t => backs m h f' t -
      h ^ m * v) (h ^ m * w) (x - h) x).
    assert (D' : forall t, derivable_pt_lim (fun t => backs m h f t - h ^ m * v * t) t (backs m h f' t - h ^ m * v)).
    { intros t. apply (derivable_pt_lim_minus (backs m h f) (fun t => h ^ m * v * t)). apply backs_derivative; auto.
      assert (X := derivable_pt_lim_scal id (h ^ m * v) t 1 (derivable_pt_lim_id t)). rewrite Rmult_1_r in X. exact X. }
    specialize (MV D' I ltac:(lra)). change (backs (S m) h f x) with (backs m h f x - backs m h f (x - h)). simpl pow.
    replace (backs m h f x - backs m h f (x - h) - h * h ^ m * v) with
      (backs m h f x - h ^ m * v * x - (backs m h f (x - h) - h ^ m * v * (x - h))) by ring.
    eapply Rle_trans. apply MV. right. ring.
Qed.

Lemma derivative_zero lo hi m : forall f g, derivative m f g -> vanishes lo hi f -> (forall x, g x = 0) -> forall x, f x = 0.
Proof.
  induction m; intros f g H V Z x. rewrite H. auto.
  destruct H as [f' [D H]]. assert (Z' := IHm f' g H (vanishing_derivative lo hi f f' V D) Z).
  assert (B : forall t, Rabs (f' t) <= 0) by (intros t; rewrite Z', Rabs_R0; lra).
  set (y := Rmin x lo - 1). assert (Y : y <= x /\ y < lo) by (unfold y; generalize (Rmin_l x lo) (Rmin_r x lo); lra).
  assert (MV := mean_value f f' 0 D B y x ltac:(lra)). rewrite (V y), Rminus_0_r in MV by lra.
  destruct (Req_dec (f x) 0) as [|N]; auto. apply Rabs_pos_lt in N. lra.
Qed.

Section Scheme.
Variables (A : nat) (F : Z) (L : nat).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.
Notation steps a := (refined A F L a).

Section Limit.
Variables (a : Z -> R) (phi : R -> R).
Hypothesis Support : supported F L a.
Hypothesis Classes : forall i, subdivide A F L a (fun _ => 1) i = 1.
Hypothesis Phi : is_limit A F L a phi.
Let reach := (Z.abs F + Z.of_nat L + 1)%Z.

Definition covers (y : R) (lo : Z) (w : nat) : Prop := IZR lo <= y - IZR reach - 1 /\ y + IZR reach + 1 <= IZR (lo + Z.of_nat w).

Lemma outside y lo w l : covers y lo w -> (l < lo \/ lo + Z.of_nat w <= l)%Z -> y - IZR l < - IZR reach \/ IZR reach < y - IZR l.
Proof. intros [C1 C2] [Hl|Hl]; [right; apply IZR_lt in Hl|left; apply IZR_le in Hl]; lra. Qed.

(* The shifts sum to 1 everywhere. *)
Lemma partition y lo w : covers y lo w -> combination phi (fun _ => 1) lo w y = 1.
Proof.
  intros Co. apply (UL_sequence (fun n => sum w (fun k => 1 * steps a n (floor (INR A ^ n * (y - IZR (lo + Z.of_nat k))) - 0)%Z))).
  - unfold combination. apply (sum_converges w (fun _ => 1) (fun k n => steps a n (floor (INR A ^ n * (y - IZR (lo +
      Z.of_nat k))) - 0)%Z)
      (fun k => phi (y - IZR (lo + Z.of_nat k)))). intros k Hk. apply limit_point; auto.
  - intros eps He. exists O. intros n _. set (g := fun l => steps a n (floor (INR A ^ n * (y - IZR l)))).
    rewrite (sum_ext w _ (fun k => g (lo + Z.of_nat k)%Z)) by (intros k Hk; unfold g; rewrite Z.sub_0_r; ring).
    destruct (refined_partition A F L Arity a Classes n (floor (INR A ^ n * y))) as [r0 Hr].
    set (r := (r0 + Z.abs_nat lo + w + 1)%nat). specialize (Hr r ltac:(unfold r; lia)).
    rewrite <- (sum_window g lo w (- Z.of_nat r) (2 * r + 1)).
    + unfold g. rewrite (sum_ext _ _ (fun k => steps a n (floor (INR A ^ n * y) - Z.of_nat A ^ Z.of_nat n * (- Z.of_nat r +
        Z.of_nat k))%Z))
        by (intros k Hk; rewrite (floor_shift A Arity); reflexivity).
      rewrite Hr. unfold R_dist. rewrite Rminus_diag_eq, Rabs_R0; auto.
    + intros l Hl. unfold g. apply (refined_beyond A F Arity L a Support). fold reach. apply (outside y lo w l Co Hl).
    + unfold r. lia.
    + unfold r. lia.
Qed.

Lemma limit_bounded_everywhere : exists P, 0 <= P /\ forall x, Rabs (phi x) <= P.
Proof.
  destruct (limit_tends_between A F Arity L a phi Support Phi 1 ltac:(lra)) as [n H]. specialize (H n (le_n n)).
  destruct (largest (steps a n) _ _ (refined_inside A F L Arity L a n Support (le_n L))) as [i Hi].
  exists (Rabs (steps a n i) + 1). split. generalize (Rabs_pos (steps a n i)). lra. intros x. specialize (H x).
  specialize (Hi (floor (INR A ^ n * x))).
  replace (phi x) with (- (steps a n (floor (INR A ^ n * x)) - phi x) + steps a n (floor (INR A ^ n * x))) by ring.
  eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. lra.
Qed.

Lemma shifts_bounded : exists T, 0 <= T /\ forall y lo w, covers y lo w -> sum w (fun k => Rabs (phi (y - IZR (lo +
  Z.of_nat k)))) <= T.
Proof.
  destruct limit_bounded_everywhere as [P [P0 H]]. exists (INR (Z.to_nat (2 * reach + 4)) * P). split.
  apply Rmult_le_pos; auto. apply pos_INR.
  intros y lo w Co. set (g := fun l => Rabs (phi (y - IZR l))).
  assert (Z0 : forall lo w, covers y lo w -> forall l, (l < lo \/ lo + Z.of_nat w <= l)%Z -> g l = 0).
  { intros lo' w' Co' l Hl. unfold g. rewrite (limit_zero A F Arity L a phi Support Phi). apply Rabs_R0.
    apply (outside y lo' w' l Co' Hl). }
  set (lo0 := (floor y - reach - 1)%Z). set (w0 := Z.to_nat (2 * reach + 4)).
  assert (Co0 : covers y lo0 w0).
  { destruct (floor_bounds y) as [F1 F2]. split; unfold lo0, w0; [|rewrite Z2Nat.id by (unfold reach; lia)];
      repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR; lra. }
  change (sum w (fun k => g (lo + Z.of_nat k)%Z) <= INR w0 * P).
  rewrite (sum_two_windows g lo w lo0 w0 (Z0 lo w Co) (Z0 lo0 w0 Co0)).
  apply sum_bound. intros k Hk. apply H.
Qed.

(* ---- derivatives ------------------------------------------------------------------------------------------------- *)

Section Derivative.
Variables (M : nat) (psi : R -> R).
Hypothesis Order : derivative M phi psi.
Hypothesis Continuous : continuity psi.
Hypothesis Stable : stable phi.

Lemma psi_zero : vanishes (- IZR reach) (IZR reach) psi.
Proof. apply (derivative_vanishes _ _ M phi psi Order (limit_zero A F Arity L a phi Support Phi)). Qed.

Lemma cell_small k eps : 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> k * / INR A ^ n < eps.
Proof.
  intros He. assert (K0 := Rabs_pos k). destruct (small_cell A Arity (eps / (Rabs k + 1) / 2)) as [n0 H].
  { apply Rdiv_lt_0_compat; [|lra]. apply Rdiv_lt_0_compat; lra. }
  exists n0. intros n Hn. specialize (H n Hn). assert (IP : 0 < / INR A ^ n) by apply Rinv_0_lt_compat, power_positive, Arity.
  apply Rle_lt_trans with ((Rabs k + 1) * / INR A ^ n). apply Rmult_le_compat_r. lra. generalize (Rle_abs k). lra.
  apply (Rmult_le_compat_l (Rabs k + 1)) in H; [|lra].
  replace ((Rabs k + 1) * (eps / (Rabs k + 1) / 2)) with (eps / 2) in H by (field; lra). lra.
Qed.

(* Values of the derivative as coefficients give the derivative. *)
Lemma sampled eps : 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> forall y lo w, covers y lo w ->
  Rabs (combination phi (fun j => psi (IZR j / INR A ^ n)) lo w y - psi (y / INR A ^ n)) <= eps.
Proof.
  intros He. destruct shifts_bounded as [T [T0 HT]]. set (e := eps / (T + 1)). assert (E0 : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  destruct (uniform psi _ _ Continuous psi_zero e E0) as [d [Hd Ev]]. destruct (cell_small (IZR reach) d Hd) as [n0 H].
  exists n0. intros n Hn y lo w Co. specialize (H n Hn). assert (P := power_positive A Arity n).
  rewrite <- (Rmult_1_r (psi (y / INR A ^ n))), <- (partition y lo w Co). unfold combination. rewrite <- sum_scal, <- sum_minus.
  eapply Rle_trans. apply sum_abs. apply Rle_trans with (e * T).
  - eapply Rle_trans; [|apply Rmult_le_compat_l; [left; exact E0|apply (HT y lo w Co)]]. rewrite <- sum_scal.
    apply sum_le; intros k Hk.
    set (j := (lo + Z.of_nat k)%Z). rewrite Rmult_1_l, <- Rmult_minus_distr_r, Rabs_mult.
    destruct (Rle_lt_dec (Rabs (y - IZR j)) (IZR reach)) as [In|Out].
    + apply Rmult_le_compat_r. apply Rabs_pos. apply Ev.
      replace (IZR j / INR A ^ n - y / INR A ^ n) with (- ((y - IZR j) * / INR A ^ n)) by (field; lra).
      rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; auto).
      eapply Rle_lt_trans; [|apply H]. apply Rmult_le_compat_r; auto. left; apply Rinv_0_lt_compat; auto.
    + rewrite (limit_zero A F Arity L a phi Support Phi (y - IZR j)), Rabs_R0. lra.
      fold reach. unfold Rabs in Out. destruct (Rcase_abs (y - IZR j)); lra.
  - unfold e. apply (Rmult_le_reg_r (T + 1)). lra. replace (eps / (T + 1) * T * (T + 1)) with (eps * T) by (field; lra).
    apply Rmult_le_compat_l; lra.
Qed.

Definition scaled (n : nat) (i : Z) : R := (INR A ^ n) ^ M * zbacks M 1 (steps a n) i.

(* The divided differences of the data are near the derivative: that is where stability is needed. *)
Lemma scaled_near eps : 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> forall i, Rabs (scaled n i -
  psi (IZR i / INR A ^ n)) <= eps.
Proof.
  intros He. destruct Stable as [K HK]. assert (K0 := Rabs_pos K). set (e := eps / (2 * (Rabs K + 1))).
  assert (E0 : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  destruct (sampled e E0) as [n1 H1]. destruct (uniform psi _ _ Continuous psi_zero e E0) as [d [Hd Ev]].
  destruct (cell_small (INR M) d Hd) as [n2 H2]. exists (n1 + n2)%nat. intros n Hn. specialize (H1 n ltac:(lia)).
  specialize (H2 n ltac:(lia)).
  assert (P := power_positive A Arity n). set (h := / INR A ^ n) in *. assert (Hh : 0 < h) by (apply Rinv_0_lt_compat; auto).
  assert (In := refined_inside A F L Arity L a n Support (le_n L)).
  set (lo0 := (F * (Z.of_nat A ^ Z.of_nat n - 1) / (Z.of_nat A - 1))%Z) in *. set (w0 := Z.to_nat _) in In.
  assert (Eb := combination_backs A Arity phi (steps a n) lo0 w0 n M In).
  assert (In' : inside lo0 (w0 + M) (scaled n)).
  { destruct (Eb 0) as [I _]. intros i Hi. unfold scaled. rewrite (I i Hi). ring. }
  assert (Ep : (fun x => combination phi (steps a n) lo0 w0 (INR A ^ n * x)) = phi).
  { extensionality x. symmetry. apply (refinement A F L Arity a phi (limit_tends_between A F Arity L a phi Support Phi) n lo0
      w0 In). }
  rewrite Ep in Eb.
  set (q := (ZA ^ Z.of_nat n * reach)%Z). assert (Q0 : (0 <= q)%Z) by (apply Z.mul_nonneg_nonneg; [apply Z.pow_nonneg;
    lia|unfold reach; lia]).
  set (R0 := (Z.abs lo0 + Z.of_nat w0 + Z.of_nat M + q + 1)%Z).
  assert (InE : inside (- R0) (Z.to_nat (2 * R0 + 1)) (fun i => scaled n i - psi (IZR i / INR A ^ n))).
  { intros i Hi. rewrite Z2Nat.id in Hi by (unfold R0; lia). rewrite In' by (unfold R0 in Hi; lia).
    rewrite psi_zero. lra. assert (E := Subdivision.arity_power A Arity n). fold ZA in E.
    assert (X : (q < i \/ q < - i)%Z) by (unfold R0 in Hi; lia).
    destruct X as [X|X]; apply IZR_lt in X; unfold q in X; rewrite ?opp_IZR, mult_IZR, E in X; [right|left];
      apply (Rmult_lt_reg_l (INR A ^ n)); auto; replace (INR A ^ n * (IZR i / INR A ^ n)) with (IZR i) by (field; lra); lra. }
  intros i. eapply Rle_trans. apply (HK _ _ _ (2 * e) InE).
  - intros y. set (R1 := (R0 + Z.abs (floor y) + reach + 3)%Z). set (w1 := Z.to_nat (2 * R1 + 1)).
    assert (Z1 : (0 <= 2 * R1 + 1)%Z) by (unfold R1, R0, reach; lia).
    assert (Co : covers y (- R1) w1).
    { destruct (floor_bounds y) as [F1 F2]. assert (B1 : (reach + 1 - floor y <= R1)%Z) by (unfold R1, R0, reach; lia).
      assert (B2 : (floor y + 2 + reach <= R1)%Z) by (unfold R1, R0, reach; lia). apply IZR_le in B1, B2.
      rewrite minus_IZR, plus_IZR in B1. rewrite !plus_IZR in B2.
      split; unfold w1; [|rewrite Z2Nat.id by auto]; repeat rewrite ?plus_IZR, ?opp_IZR, ?mult_IZR; lra. }
    assert (E1 : combination phi (fun i => scaled n i - psi (IZR i / INR A ^ n)) (- R0) (Z.to_nat (2 * R0 + 1)) y =
      combination phi (scaled n) lo0 (w0 + M) y - combination phi (fun i => psi (IZR i / INR A ^ n)) (- R1) w1 y).
    { unfold combination.
      rewrite <- (sum_window (fun j => (scaled n j - psi (IZR j / INR A ^ n)) * phi (y - IZR j)) (- R0) (Z.to_nat (2 * R0 +
        1)) (- R1) w1).
      - rewrite <- (sum_window (fun j => scaled n j * phi (y - IZR j)) lo0 (w0 + M) (- R1) w1).
        + rewrite <- sum_minus. apply sum_ext; intros k Hk. ring.
        + intros l Hl. rewrite (In' l Hl). ring.
        + unfold R1, R0, reach. lia.
        + unfold w1. rewrite Z2Nat.id by auto. unfold R1, R0, reach. lia.
      - intros l Hl. rewrite (InE l Hl). ring.
      - unfold R1, reach. lia.
      - unfold w1. rewrite !Z2Nat.id by (auto; unfold R0; lia). unfold R1, reach. lia. }
    rewrite E1. specialize (H1 y (- R1)%Z w1 Co).
    assert (B : Rabs (combination phi (scaled n) lo0 (w0 + M) y - psi (y / INR A ^ n)) <= e).
    { set (x := y / INR A ^ n). destruct (Eb x) as [_ Ex]. replace (INR A ^ n * x) with y in Ex by (unfold x; field; lra).
      assert (Near := backs_near M phi psi Order h (psi x) e x Hh). assert (Hm : 0 < (INR A ^ n) ^ M) by (apply pow_lt; auto).
      assert (One : (INR A ^ n) ^ M * h ^ M = 1). { rewrite <- Rpow_mult_distr. unfold h. rewrite Rinv_r, pow1; lra. }
      replace (combination phi (scaled n) lo0 (w0 + M) y) with ((INR A ^ n) ^ M * backs M h phi x).
      - replace ((INR A ^ n) ^ M * backs M h phi x - psi x) with ((INR A ^ n) ^ M * (backs M h phi x - h ^ M * psi x))
          by (rewrite Rmult_minus_distr_l, <- Rmult_assoc, One; ring).
        rewrite Rabs_mult, Rabs_pos_eq by lra. rewrite <- (Rmult_1_l e), <- One, Rmult_assoc. apply Rmult_le_compat_l. lra.
        apply Near. intros t Ht. apply Ev. rewrite Rabs_minus_sym, Rabs_pos_eq by lra. lra.
      - unfold h. rewrite Ex. unfold combination, scaled. rewrite <- sum_scal. apply sum_ext; intros k Hk. ring. }
    set (u := combination phi (scaled n) lo0 (w0 + M) y) in *.
    set (v := combination phi (fun i => psi (IZR i / INR A ^ n)) (- R1) w1 y) in *.
    replace (u - v) with ((u - psi (y / INR A ^ n)) + - (v - psi (y / INR A ^ n))) by ring. eapply Rle_trans.
    apply Rabs_triang. rewrite Rabs_Ropp. lra.
  - apply Rle_trans with (Rabs K * (2 * e)). apply Rmult_le_compat_r. lra. apply Rle_abs.
    unfold e. apply (Rmult_le_reg_r (Rabs K + 1)). lra.
    replace (Rabs K * (2 * (eps / (2 * (Rabs K + 1)))) * (Rabs K + 1)) with (Rabs K * eps) by (field; lra). lra.
Qed.

(* Places that stay near x *)
Lemma scaled_value x k eps : 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> forall i, Rabs (IZR i - INR A ^ n * x) <= k ->
  Rabs (scaled n i - psi x) <= eps.
Proof.
  intros He. destruct (scaled_near (eps / 2) ltac:(lra)) as [n1 H1].
  destruct (uniform psi _ _ Continuous psi_zero (eps / 2) ltac:(lra)) as [d [Hd Ev]].
  destruct (cell_small k d Hd) as [n2 H2]. exists (n1 + n2)%nat. intros n Hn i Hi. specialize (H1 n ltac:(lia) i).
  specialize (H2 n ltac:(lia)).
  assert (P := power_positive A Arity n). assert (IP : 0 < / INR A ^ n) by (apply Rinv_0_lt_compat; auto).
  assert (E : Rabs (psi (IZR i / INR A ^ n) - psi x) <= eps / 2).
  { apply Ev. replace (IZR i / INR A ^ n - x) with ((IZR i - INR A ^ n * x) * / INR A ^ n) by (field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by lra. eapply Rle_lt_trans; [|apply H2]. apply Rmult_le_compat_r; lra. }
  replace (scaled n i - psi x) with ((scaled n i - psi (IZR i / INR A ^ n)) + (psi (IZR i / INR A ^ n) - psi x)) by ring.
  eapply Rle_trans. apply Rabs_triang. lra.
Qed.
End Derivative.
End Limit.

(* ---- Theorem 23 -------------------------------------------------------------------------------------------------- *)

Lemma zbacks_step M s b f : forall i, zbacks M (ZA * s) (subdivide A F L b f) i = subdivide A F L b (zbacks M s f) i.
Proof.
  induction M; intros i; auto. cbn [zbacks]. unfold zback. rewrite !IHM, subdivide_minus. f_equal. symmetry.
  apply (subdivide_shift A F L Arity).
Qed.

Section Rough.
Variables (N M : nat) (b : Z -> R) (phi psi : R -> R).
Hypothesis Support : supported F N b.
Hypothesis Fits : (N + M * (A - 1) <= L)%nat.
Let a := smoothed A M b.
Hypothesis Classes : forall i, subdivide A F L a (fun _ => 1) i = 1.
Hypothesis Phi : is_limit A F L a phi.
Hypothesis Stable : stable phi.

Lemma scaled_steps n i : scaled a M n i = zbacks M (ZA ^ Z.of_nat n) (steps b n) i.
Proof.
  unfold scaled, a. rewrite (zbacks_refined A F L Arity N) by auto. fold ZA. assert (P := power_positive A Arity n).
  rewrite <- Rmult_assoc, <- Rpow_mult_distr, Rinv_r, pow1 by lra. ring.
Qed.

Lemma scaled_next n i : scaled a M (S n) i = subdivide A F L b (scaled a M n) i.
Proof.
  rewrite scaled_steps. cbn [refined]. rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. rewrite zbacks_step.
  apply (subdivide_ext A F L). intros j. symmetry. apply scaled_steps.
Qed.

Hypothesis Order : derivative M phi psi.
Hypothesis Continuous : continuity psi.

Lemma class_value x r : psi x = subdivide A F L b (fun _ => 1) r * psi x.
Proof.
  apply cond_eq. intros eps He. assert (SA : supported F L a).
  { apply (supported_more A F Arity (N + M * (A - 1))); auto. apply (smoothed_supported A F Arity); auto. }
  destruct (supported_bounded A F Arity N b Support) as [Pb [Pb0 HPb]].
  set (C := 1 + INR (S L) * Pb). assert (C0 : 1 <= C). { unfold C.
  assert (0 <= INR (S L) * Pb) by (apply Rmult_le_pos; auto; apply pos_INR). lra. }
  set (e := eps / (2 * C)). assert (E0 : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  set (k := INR A + Rabs (IZR r) + Rabs (IZR ((r - F) / ZA)) + INR L + INR (S L) + 1).
  destruct (scaled_value a phi SA Classes Phi M psi Order Continuous Stable x k e E0) as [n0 H].
  set (f := floor (INR A ^ n0 * x)). set (i := (ZA * f + r)%Z). destruct (floor_bounds (INR A ^ n0 * x)) as [F1 F2].
  fold f in F1, F2.
  assert (PA := arity_positive A Arity). assert (EA : IZR ZA = INR A) by (unfold ZA; rewrite <- INR_IZR_INZ; auto).
  assert (Ab : forall y, - Rabs y <= y <= Rabs y). { intros y. split. rewrite <- (Rabs_Ropp y). generalize (Rle_abs (- y)).
  lra. apply Rle_abs. }
  assert (L0 := pos_INR L). assert (L1 := pos_INR (S L)).
  (* one step later *)
  assert (Next : Rabs (scaled a M (S n0) i - psi x) <= e).
  { apply H. lia. unfold i. rewrite plus_IZR, mult_IZR, EA. simpl pow. assert (X := Ab (IZR r)).
    assert (Y := Rabs_pos (IZR ((r - F) / ZA))).
    assert (D1 : INR A * IZR f <= INR A * (INR A ^ n0 * x)) by (apply Rmult_le_compat_l; lra).
    assert (D2 : INR A * (INR A ^ n0 * x) <= INR A * (IZR f + 1)) by (apply Rmult_le_compat_l; lra).
    apply Rabs_le. unfold k. rewrite Rmult_assoc. lra. }
  rewrite scaled_next in Next.
  assert (One : subdivide A F L b (fun _ => 1) i = subdivide A F L b (fun _ => 1) r).
  { replace r with (i - ZA * f)%Z by (unfold i; ring). symmetry. rewrite <- (subdivide_shift A F L Arity b (fun _ => 1)).
    reflexivity. }
  assert (Now : Rabs (subdivide A F L b (scaled a M n0) i - psi x * subdivide A F L b (fun _ => 1) i) <= INR (S L) * (Pb * e)).
  { rewrite <- subdivide_scal, <- subdivide_minus. unfold subdivide. eapply Rle_trans. apply sum_abs. apply sum_bound.
    intros m Hm. cbv zeta.
    rewrite Rabs_mult, Rmult_1_r. apply Rmult_le_compat; auto; try apply Rabs_pos. apply H. lia. fold ZA.
    replace ((i - F) / ZA)%Z with (f + (r - F) / ZA)%Z by (unfold i; replace (ZA * f + r - F)%Z with (r - F + f * ZA)%Z by
      ring; rewrite Z.div_add by (unfold ZA; lia); ring).
    repeat rewrite ?plus_IZR, ?minus_IZR. rewrite <- !INR_IZR_INZ. assert (X := Ab (IZR ((r - F) / ZA))).
    assert (Y := Rabs_pos (IZR r)). apply lt_INR in Hm.
    assert (Z0 := pos_INR m). apply Rabs_le. unfold k. lra. }
  rewrite One in Now. set (s := subdivide A F L b (fun _ => 1) r) in *. set (v := subdivide A F L b (scaled a M n0) i) in *.
  replace (psi x - s * psi x) with (- (v - psi x) + (v - psi x * s)) by ring. eapply Rle_lt_trans. apply Rabs_triang.
  rewrite Rabs_Ropp.
  apply Rle_lt_trans with (C * e). unfold C. lra. unfold e. replace (C * (eps / (2 * C))) with (eps / 2) by (field; lra). lra.
Qed.

Lemma all_classes r : subdivide A F L b (fun _ => 1) r = 1.
Proof.
  destruct (Req_dec (subdivide A F L b (fun _ => 1) r) 1) as [|N']; auto. exfalso.
  assert (SA : supported F L a).
  { apply (supported_more A F Arity (N + M * (A - 1))); auto. apply (smoothed_supported A F Arity); auto. }
  assert (Z : forall x, psi x = 0).
  { intros x. assert (E := class_value x r). assert (E' : (subdivide A F L b (fun _ => 1) r - 1) * psi x = 0) by lra.
    apply Rmult_integral in E'. destruct E'; auto. exfalso. apply N'. lra. }
  assert (Zp := derivative_zero _ _ M phi psi Order (limit_zero A F Arity L a phi SA Phi) Z).
  destruct Stable as [K HK]. specialize (HK delta 0%Z 1%nat 0). assert (D : Rabs (delta 0) <= K * 0).
  { apply HK. intros i Hi. unfold delta. destruct (Z.eqb_spec i 0); auto. exfalso; lia. intros y. unfold combination. simpl.
    rewrite Zp. rewrite Rmult_0_r, Rplus_0_r, Rabs_R0. lra. }
  change (delta 0) with 1 in D. rewrite Rabs_R1 in D. lra.
Qed.
End Rough.
End Scheme.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

Open Scope Z_scope.

(* The scheme does not converge, or its limit is not C^k. *)
Definition rough_holds (a : scheme) (k : nat) : Prop := forall phi, limit_of a phi -> ~ smooth continuity k phi.

(* The sum of the coefficients in one residue class *)
Definition class_sum (A : nat) (b : list Z) (r : nat) : Z :=
  fold_right Z.add 0 (map (fun k => nth (r + A * k) b 0) (seq 0 (length b))).

(* The shifts are stable, and there is no factor more. *)
Definition no_more_factors (a : scheme) (order : nat) (c : stability) : bool :=
  reducible a order && (1 <=? order)%nat && (1 <=? length (coefficients a))%nat && check_stable a c &&
  existsb (fun r => negb (class_sum (arity a) (difference_symbol a order) r =? common a)) (seq 0 (arity a)).

Definition check_rough (a : scheme) (order k : nat) (c : stability) : bool := no_more_factors a order c && (order <=? k)%nat.

(* Both ends, the upper one by the order *)
Definition check_full (a : scheme) (l u : Q) (low : exponent_certificate) (c : stability) : bool :=
  check_exponent_lower a l low && no_more_factors a (order low) c && (Z.of_nat (order low) * Zpos (Qden u) <=? Qnum u).

Lemma coefficient_supported l e F : supported F (length l - 1) (coefficient l e F).
Proof. intros i Hi. rewrite coefficient_shift. apply coefficient_support. lia. Qed.

Lemma class_sum_sound A F L b e r : (2 <= A)%nat -> 0 < e -> (length b - 1 <= L)%nat -> (r < A)%nat ->
  subdivide A F L (fun i => coefficient b e 0 (i - F)) (fun _ => 1%R) (F + Z.of_nat r) = (IZR (class_sum A b r) / IZR e)%R.
Proof.
  intros HA He HL Hr. set (f := fun i => coefficient b e 0 (i - F)). set (n := length b).
  assert (Out : forall i, i < 0 \/ Z.of_nat n <= i -> coefficient b e 0 i = 0%R).
  { intros i Hi. unfold coefficient. destruct (Z.ltb_spec i 0); auto. rewrite nth_overflow by (fold n; lia). unfold Rdiv; lra. }
  assert (Sf : supported F (n - 1) f) by (intros i Hi; apply coefficient_support; fold n; lia).
  rewrite <- (subdivide_window A F L HA (n - 1) f (fun _ => 1%R) (F + Z.of_nat r) (1 - Z.of_nat n) n Sf HL).
  - rewrite sum_reverse. unfold class_sum. fold n. rewrite <- (sum_list _ n) by (rewrite map_length, seq_length; lia).
    unfold Rdiv. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros k Hk. rewrite nth_map_seq by auto. unfold f, coefficient.
    replace (F + Z.of_nat r - Z.of_nat A * (1 - Z.of_nat n + Z.of_nat (n - 1 - k)) - F) with (Z.of_nat (r + A * k))
      by (replace (1 - Z.of_nat n + Z.of_nat (n - 1 - k)) with (- Z.of_nat k) by lia; rewrite Nat2Z.inj_add, Nat2Z.inj_mul; ring).
    destruct (Z.ltb_spec (Z.of_nat (r + A * k)) 0); [lia|]. rewrite Z.sub_0_r, Nat2Z.id. unfold Rdiv. ring.
  - intros j Hj. unfold f. apply Out. replace (F + Z.of_nat r - Z.of_nat A * j - F) with (Z.of_nat r - Z.of_nat A * j) by ring.
    destruct Hj as [Hj|Hj]; [right|left].
    + assert (Z.of_nat A * Z.of_nat n <= Z.of_nat A * - j) by (apply Z.mul_le_mono_nonneg_l; lia).
      assert (2 * Z.of_nat n <= Z.of_nat A * Z.of_nat n) by (apply Z.mul_le_mono_nonneg_r; lia). lia.
    + assert (Z.of_nat A * 1 <= Z.of_nat A * j) by (apply Z.mul_le_mono_nonneg_l; lia). lia.
Qed.

Theorem no_more_factors_sound a order c phi : no_more_factors a order c = true -> limit_of a phi -> ~ smooth continuity order phi.
Proof.
  intros H Lim Sm. unfold no_more_factors in H. repeat rewrite andb_true_iff in H. destruct H as [[[[H1 H2] H3] H4] H5].
  apply Nat.leb_le in H2, H3. apply existsb_exists in H5. destruct H5 as [r [Hr H5]]. apply in_seq in Hr.
  apply negb_true_iff, Z.eqb_neq in H5.
  destruct (mask_facts a order H1) as [HA [HO [HL [Sb [W1 [W2 [EM [HT _]]]]]]]].
  set (A := arity a) in *. set (F := first a) in *. set (L := (length (coefficients a) - 1)%nat) in *.
  set (bl := difference_symbol a order) in *. set (N := (length bl - 1)%nat) in *.
  set (f := fun i => coefficient bl (common a) 0 (i - F)) in *.
  assert (Sf : supported F N f) by (intros i Hi; apply Sb; lia).
  assert (Dp : 0 < common a) by (apply lt_IZR; auto).
  assert (SA := coefficient_supported (coefficients a) (common a) F). fold L in SA.
  assert (Cl : forall i, subdivide A F L (coefficient (coefficients a) (common a) F) (fun _ => 1%R) i = 1%R).
  { intros i. rewrite EM. destruct order as [|k]; [lia|]. cbn [smoothed]. rewrite Nat.mul_succ_l in HL.
    apply (smooth_classes A F L HA (N + k * (A - 1))).
    - apply (smoothed_supported A F HA). auto.
    - revert HL. generalize (k * (A - 1))%nat. clear -HA. lia.
    - rewrite (smoothed_total A F L HA N); auto. apply HT. revert HL. generalize (k * (A - 1))%nat. clear. lia.
      revert HL. generalize (k * (A - 1))%nat. clear -HA. lia. }
  assert (Td := limit_tends_between A F HA L _ phi SA Lim).
  assert (Stab : stable phi) by (apply (accepted_stable a c); auto).
  destruct (smooth_derivative_sequence continuity order phi Sm) as [psi [D C]].
  unfold limit_of in Lim. fold A F L in Lim. rewrite EM in Lim, Cl.
  assert (All := all_classes A F L HA N order f phi psi Sf HL Cl Lim Stab D C (F + Z.of_nat r)).
  unfold f in All. rewrite (class_sum_sound A F L bl (common a) r) in All; auto; [|revert HL; unfold N;
    generalize (order * (A - 1))%nat; lia|lia].
  apply H5. apply eq_IZR. apply (Rmult_eq_reg_r (/ IZR (common a))). unfold Rdiv in All. rewrite All. field. lra.
  apply Rinv_neq_0_compat. lra.
Qed.

Lemma more_smooth k phi s : exponents phi s -> (INR k < s)%R -> smooth continuity k phi.
Proof.
  intros [m [alpha [Ha [E H]]]] Hs. apply (smooth_fewer (holder 0 alpha) k m).
  - intros f. apply holder_continuous. lra.
  - apply Nat.lt_succ_r, INR_lt. rewrite S_INR. lra.
  - apply smooth_holder, H.
Qed.

(* What the checkers accept is true. *)
Theorem check_rough_sound a order k c : check_rough a order k c = true -> rough_holds a k.
Proof.
  intros H phi Lim Sm. apply andb_prop in H. destruct H as [H Hk]. apply Nat.leb_le in Hk.
  apply (no_more_factors_sound a order c phi H Lim). apply (smooth_fewer continuity order k); auto.
Qed.

Theorem check_full_sound a l u low c : check_full a l u low c = true -> enclosure_holds a l u.
Proof.
  intros H. unfold check_full in H. repeat rewrite andb_true_iff in H. destruct H as [[H1 H2] H3]. apply Z.leb_le, IZR_le in H3.
  apply check_exponent_lower_sound in H1. destruct H1 as [phi [Lim Ex]]. exists phi. split; auto. split; auto. intros s Hs.
  assert (Hu : (INR (order low) <= real_of u)%R).
  { assert (D : (0 < IZR (Zpos (Qden u)))%R) by (apply IZR_lt; lia). rewrite mult_IZR, <- INR_IZR_INZ in H3. unfold real_of.
    apply (Rmult_le_reg_r (IZR (Zpos (Qden u)))); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  apply Rnot_lt_le. intros N. apply (no_more_factors_sound a (order low) c phi H2 Lim), (more_smooth _ _ s); auto. lra.
Qed.
