(* Values on the grids of the points i / A^n, each of which contains the last one: differences of order m that shrink like
   A^(-n x), x below m, make one function that is smooth. *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision.
Import ListNotations.
Open Scope R_scope.

Section Grid.
Variable A : nat.
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.

(* Means of neighbours, j times *)
Lemma smoothed_near h e : (forall i, Rabs (h i - h (i - 1)%Z) <= e) -> forall j B i k, (Z.abs (i - k) <= Z.of_nat B)%Z ->
  Rabs (smoothed A j h i - h k) <= INR (B + j * A) * e.
Proof.
  intros H. assert (PA := arity_positive A Arity). induction j; intros B i k Hik.
  - rewrite Nat.add_0_r. cbn [smoothed]. apply (neighbours_within A Arity h e B H i k Hik).
  - cbn [smoothed]. unfold smooth.
    replace (/ INR A * sum A (fun s => smoothed A j h (i - Z.of_nat s)) - h k) with
      (/ INR A * sum A (fun s => smoothed A j h (i - Z.of_nat s)%Z - h k)) by (rewrite sum_minus, sum_const; field; lra).
    rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (INR A)) by lra.
    apply Rle_trans with (/ INR A * (INR A * (INR (B + S j * A) * e))). 2: right; field; lra.
    apply Rmult_le_compat_l. left; apply Rinv_0_lt_compat; auto. eapply Rle_trans. apply sum_abs. apply sum_bound. intros s Hs.
    replace (B + S j * A)%nat with ((B + A) + j * A)%nat by (simpl; lia). apply IHj. lia.
Qed.

Lemma smoothed_shift j h s : forall i, smoothed A j (fun i => h (i - s)%Z) i = smoothed A j h (i - s)%Z.
Proof.
  induction j; intros i; cbn [smoothed]; auto. unfold smooth. f_equal. apply sum_ext. intros l Hl. rewrite IHj. f_equal. lia.
Qed.

Lemma smoothed_minus j f g : forall i, smoothed A j (fun i => f i - g i) i = smoothed A j f i - smoothed A j g i.
Proof.
  induction j; intros i; cbn [smoothed]; auto. unfold smooth.
  rewrite (sum_ext A _ (fun s => smoothed A j f (i - Z.of_nat s)%Z - smoothed A j g (i - Z.of_nat s)%Z)) by auto.
  rewrite sum_minus. ring.
Qed.

Lemma smoothed_times j c f : forall i, smoothed A j (fun i => c * f i) i = c * smoothed A j f i.
Proof.
  induction j; intros i; cbn [smoothed]; auto. unfold smooth.
  rewrite (sum_ext A _ (fun s => c * smoothed A j f (i - Z.of_nat s)%Z)) by auto. rewrite sum_scal. ring.
Qed.

(* Differences of order j *)
Fixpoint differences (j : nat) (h : Z -> R) : Z -> R :=
  match j with O => h | S k => fun i => differences k h i - differences k h (i - 1)%Z end.

Section Values.
Variable f : nat -> Z -> R.
Hypothesis Same : forall n i, f (S n) (ZA * i)%Z = f n i.

(* Divided by the power of the step *)
Definition divided (j n : nat) (i : Z) : R := (INR A ^ n) ^ j * differences j (f n) i.

Lemma divided_succ j n i : divided j n i - divided j n (i - 1)%Z = / INR A ^ n * divided (S j) n i.
Proof.
  unfold divided. cbn [differences]. rewrite <- tech_pow_Rmult. assert (P := power_positive A Arity n). field. lra.
Qed.

(* Those of a level are means of those of the next one. *)
Lemma divided_mean j n : forall i, divided j n i = smoothed A j (divided j (S n)) (ZA * i)%Z.
Proof.
  assert (PA := arity_positive A Arity). assert (PN := power_positive A Arity n). assert (PS := power_positive A Arity (S n)).
  induction j; intros i.
  - unfold divided. simpl pow. cbn [differences smoothed]. rewrite Same. reflexivity.
  - replace (divided (S j) n i) with (INR A ^ n * (divided j n i - divided j n (i - 1)%Z)) by (rewrite divided_succ; field; lra).
    rewrite !IHj. set (G := divided j (S n)). cbn [smoothed].
    assert (E := smooth_difference A Arity (smoothed A j G) (ZA * i)).
    replace (ZA * (i - 1))%Z with (ZA * i - Z.of_nat A)%Z by (unfold ZA; ring).
    replace (smoothed A j G (ZA * i)%Z - smoothed A j G (ZA * i - Z.of_nat A)%Z) with
      (INR A * (smooth A (smoothed A j G) (ZA * i)%Z - smooth A (smoothed A j G) (ZA * i - 1)%Z)) by (rewrite E; field; lra).
    change (smooth A (smoothed A j G)) with (smoothed A (S j) G).
    rewrite <- smoothed_shift, <- smoothed_minus.
    change (smooth A (smoothed A j (divided (S j) (S n))) (ZA * i)%Z) with (smoothed A (S j) (divided (S j) (S n)) (ZA * i)%Z).
    replace (divided (S j) (S n)) with (fun i => INR A ^ S n * (G i - G (i - 1)%Z)).
    + rewrite smoothed_times. rewrite <- tech_pow_Rmult. ring.
    + extensionality k. unfold G. rewrite divided_succ. field. lra.
Qed.

(* From one level to the next *)
Lemma divided_step j n e i : (forall i, Rabs (divided j (S n) i - divided j (S n) (i - 1)%Z) <= e) ->
  Rabs (divided j (S n) i - divided j n (i / ZA)%Z) <= INR (A + j * A) * e.
Proof.
  intros H. rewrite (divided_mean j n (i / ZA)%Z), Rabs_minus_sym. apply smoothed_near; auto.
  assert (D := division A Arity i). fold ZA in D. unfold ZA in *. lia.
Qed.

Lemma floor_grid n k i : floor (INR A ^ (n + k) * (IZR i / INR A ^ n)) = (ZA ^ Z.of_nat k * i)%Z.
Proof.
  assert (P := power_positive A Arity n). rewrite pow_add.
  replace (INR A ^ n * INR A ^ k * (IZR i / INR A ^ n)) with (IZR (ZA ^ Z.of_nat k * i)).
  - apply (floor_integer A Arity).
  - rewrite mult_IZR. unfold ZA. rewrite (arity_power A Arity). field. lra.
Qed.

Lemma same_point n i : forall k, f (n + k) (ZA ^ Z.of_nat k * i)%Z = f n i.
Proof.
  induction k. rewrite Nat.add_0_r. change (ZA ^ Z.of_nat 0)%Z with 1%Z. f_equal. lia.
  rewrite Nat.add_succ_r, Nat2Z.inj_succ, Z.pow_succ_r by lia. rewrite <- Z.mul_assoc, Same. auto.
Qed.

(* What they tend to has these values. *)
Lemma tends_values phi : tends A f phi -> forall n i, phi (IZR i / INR A ^ n) = f n i.
Proof.
  intros T n i. apply cond_eq. intros eps He. destruct (T (eps / 2) ltac:(lra)) as [n0 H].
  specialize (H (n + n0)%nat ltac:(lia) (IZR i / INR A ^ n)). rewrite floor_grid, same_point, Rabs_minus_sym in H. lra.
Qed.

Lemma tends_unique phi psi : tends A f phi -> tends A f psi -> forall x, phi x = psi x.
Proof.
  intros T T' x. apply cond_eq. intros eps He. destruct (T (eps / 3) ltac:(lra)) as [n1 H1]. destruct (T' (eps / 3) ltac:(lra)) as [n2 H2].
  specialize (H1 (n1 + n2)%nat ltac:(lia) x). specialize (H2 (n1 + n2)%nat ltac:(lia) x). set (v := f _ _) in *.
  replace (phi x - psi x) with (- (v - phi x) + (v - psi x)) by ring. eapply Rle_lt_trans. apply Rabs_triang. rewrite Rabs_Ropp. lra.
Qed.

Variable lambda : R.
Hypothesis Log : exp lambda = INR A.

Section Smooth.
Variables (m k : nat) (x C B : R).
Hypothesis Order : (k < m)%nat.
Hypothesis Between : INR k < x < INR k + 1.
Hypothesis Bounded : forall i, Rabs (f O i) <= B.
Hypothesis Shrink : forall n i, Rabs (differences m (f n) i) <= C * exp (- x * lambda) ^ n.

Lemma differences_bounded j : forall i, Rabs (differences j (f O) i) <= 2 ^ j * B.
Proof.
  induction j; intros i; cbn [differences]. rewrite pow_O, Rmult_1_l. auto.
  unfold Rminus. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp, <- tech_pow_Rmult. generalize (IHj i) (IHj (i - 1)%Z). lra.
Qed.

Lemma divided_start j i : Rabs (divided j 0 i) <= 2 ^ j * B.
Proof. unfold divided. rewrite pow_O, pow1, Rmult_1_l. apply differences_bounded. Qed.

(* Differences that are divided once more bound those of neighbours. *)
Lemma divided_near j D r n i : (forall n i, Rabs (divided (S j) n i) <= D * r ^ n) ->
  Rabs (divided j n i - divided j n (i - 1)%Z) <= D * (r / INR A) ^ n.
Proof.
  intros H. assert (P := power_positive A Arity n). rewrite divided_succ, Rabs_mult, Rabs_pos_eq by (left; apply Rinv_0_lt_compat; auto).
  unfold Rdiv. rewrite Rpow_mult_distr, pow_inv. replace (D * (r ^ n * / INR A ^ n)) with (/ INR A ^ n * (D * r ^ n)) by ring.
  apply Rmult_le_compat_l. left; apply Rinv_0_lt_compat; auto. apply H.
Qed.

Lemma divided_next j D r n i : 0 < r -> (forall n i, Rabs (divided (S j) n i) <= D * r ^ n) ->
  Rabs (divided j (S n) i - divided j n (i / ZA)%Z) <= INR (A + j * A) * (D * (r / INR A)) * (r / INR A) ^ n.
Proof.
  intros Hr H. eapply Rle_trans. apply divided_step. intros l. apply (divided_near j D r (S n) l H).
  right. rewrite <- tech_pow_Rmult. ring.
Qed.

(* Above order x they grow less and less. *)
Lemma divided_growth e : (k + 1 + e <= m)%nat -> exists D, 0 <= D /\ forall n i, Rabs (divided (m - e) n i) <= D * exp ((INR (m - e) - x) * lambda) ^ n.
Proof.
  assert (PA := arity_positive A Arity). induction e; intros He.
  - rewrite Nat.sub_0_r. exists (Rmax C 0). split. apply Rmax_r. intros n i. assert (P := power_positive A Arity n). unfold divided.
    rewrite Rabs_mult, Rabs_pos_eq by (apply pow_le; lra).
    replace (exp ((INR m - x) * lambda)) with (INR A ^ m * exp (- x * lambda)).
    + rewrite Rpow_mult_distr, <- !pow_mult, (Nat.mul_comm m n).
      replace (Rmax C 0 * (INR A ^ (n * m) * exp (- x * lambda) ^ n)) with (INR A ^ (n * m) * (Rmax C 0 * exp (- x * lambda) ^ n)) by ring.
      apply Rmult_le_compat_l. apply pow_le; lra. eapply Rle_trans. apply Shrink.
      apply Rmult_le_compat_r. apply pow_le. left; apply exp_pos. apply Rmax_l.
    + rewrite <- Log, exp_power, <- exp_plus. f_equal. ring.
  - destruct (IHe ltac:(lia)) as [D [D0 HD]]. set (j := (m - S e)%nat). replace (m - e)%nat with (S j) in HD by (unfold j; lia).
    set (r' := exp ((INR j - x) * lambda)).
    assert (Er : exp ((INR (S j) - x) * lambda) = INR A * r').
    { unfold r'. rewrite S_INR, <- (power_succ A lambda Log). f_equal. ring. }
    rewrite Er in HD. assert (R0 : 0 < r') by apply exp_pos.
    assert (Hr' : 1 < r').
    { unfold r'. rewrite <- exp_0. apply exp_less. apply Rmult_lt_0_compat. assert (INR (k + 1) <= INR j) by (apply le_INR; unfold j; lia).
      rewrite plus_INR in H. simpl in H. lra. apply (log_positive A Arity lambda Log). }
    set (Q := INR (A + j * A) * (D * r')). assert (Q0 : 0 <= Q).
    { unfold Q. apply Rmult_le_pos. apply pos_INR. apply Rmult_le_pos; lra. }
    assert (B0 : 0 <= 2 ^ j * B). { eapply Rle_trans. apply Rabs_pos. apply (divided_start j 0). }
    assert (W : 0 <= Q / (r' - 1)) by (apply Rmult_le_pos; [auto|left; apply Rinv_0_lt_compat; lra]).
    exists (2 ^ j * B + Q / (r' - 1)). split. lra. induction n; intros i.
    + simpl pow. assert (S0 := divided_start j i). lra.
    + assert (N := divided_next j D (INR A * r') n i ltac:(apply Rmult_lt_0_compat; lra) HD).
      replace (INR A * r' / INR A) with r' in N by (field; lra). fold Q in N. specialize (IHn (i / ZA)%Z).
      set (y := divided j (S n) i) in *. set (z := divided j n (i / ZA)%Z) in *.
      replace y with ((y - z) + z) by ring. eapply Rle_trans. apply Rabs_triang. rewrite <- tech_pow_Rmult.
      assert (P : 0 < r' ^ n) by (apply pow_lt; lra).
      replace ((2 ^ j * B + Q / (r' - 1)) * (r' * r' ^ n)) with
        ((2 ^ j * B + Q / (r' - 1)) * r' ^ n + (Q + 2 ^ j * B * (r' - 1)) * r' ^ n) by (field; lra).
      assert (0 <= 2 ^ j * B * (r' - 1) * r' ^ n) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]). lra.
Qed.

(* The limits of those of orders up to k, and their derivatives *)
Lemma divided_limit j D r : 0 <= D -> 0 < r < INR A -> (forall n i, Rabs (divided (S j) n i) <= D * r ^ n) ->
  exists phi, tends A (divided j) phi /\ continuity phi /\ (exists P, 0 <= P /\ forall n i, Rabs (divided j n i) <= P) /\
  forall alpha, 0 < alpha -> r / INR A = exp (- alpha * lambda) -> holder 0 alpha phi.
Proof.
  intros D0 Hr HD. assert (PA := arity_positive A Arity). set (theta := r / INR A).
  assert (Theta : 0 < theta < 1).
  { unfold theta. split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r (INR A)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  set (N := INR (A + j * A) * (D * theta)). assert (N0 : 0 <= N).
  { unfold N. apply Rmult_le_pos. apply pos_INR. apply Rmult_le_pos; lra. }
  set (E := D + N).
  assert (S1 : forall n i, Rabs (divided j n i - divided j n (i - 1)%Z) <= E * theta ^ n).
  { intros n i. eapply Rle_trans. apply (divided_near j D r n i HD). fold theta. apply Rmult_le_compat_r. apply pow_le; lra. unfold E. lra. }
  assert (S2 : forall n i, Rabs (divided j (S n) i - divided j n (i / Z.of_nat A)%Z) <= E * theta ^ n).
  { intros n i. eapply Rle_trans. apply (divided_next j D r n i (proj1 Hr) HD). fold theta. fold N. apply Rmult_le_compat_r. apply pow_le; lra.
    unfold E. lra. }
  exists (limit A Arity _ E theta Theta S1 S2). split; [|split; [|split]].
  - apply limit_tends.
  - eapply limit_continuous; eauto using divided_start.
  - exists (2 ^ j * B + E / (1 - theta)). split.
    + apply Rplus_le_le_0_compat. eapply Rle_trans. apply Rabs_pos. apply (divided_start j 0).
      apply Rmult_le_pos. unfold E; lra. left; apply Rinv_0_lt_compat; lra.
    + intros. eapply data_bounded; eauto using divided_start.
  - intros alpha Ha Hth. eapply limit_holder; eauto using divided_start.
Qed.

Theorem grid_holder : exists phi, tends A f phi /\ continuity phi /\ holder k (x - INR k) phi.
Proof.
  assert (PA := arity_positive A Arity).
  assert (Base : forall e, (e <= k)%nat -> exists phi, tends A (divided (k - e)) phi /\ continuity phi /\
    (exists P, 0 <= P /\ forall n i, Rabs (divided (k - e) n i) <= P) /\ holder e (x - INR k) phi).
  { induction e; intros He.
    - destruct (divided_growth (m - k - 1) ltac:(lia)) as [D [D0 HD]]. replace (m - (m - k - 1))%nat with (S k) in HD by lia.
      assert (Er : exp ((INR (S k) - x) * lambda) = INR A * exp (- (x - INR k) * lambda)).
      { rewrite S_INR, <- (power_succ A lambda Log). f_equal. ring. }
      rewrite Er in HD. assert (R0 : 0 < exp (- (x - INR k) * lambda)) by apply exp_pos.
      assert (R1 : exp (- (x - INR k) * lambda) < 1).
      { rewrite <- exp_0, <- (Rmult_0_l lambda). apply (power_less A Arity lambda Log). lra. }
      rewrite Nat.sub_0_r. destruct (divided_limit k D (INR A * exp (- (x - INR k) * lambda)) D0) as [phi [T [Co [P Ho]]]]; auto.
      + split. apply Rmult_lt_0_compat; auto. rewrite <- (Rmult_1_r (INR A)) at 2. apply Rmult_lt_compat_l; auto.
      + exists phi. split; auto. split; auto. split; auto. apply Ho. lra. field. lra.
    - destruct (IHe ltac:(lia)) as [psi [T [Co [[P [P0 HP]] Ho]]]]. set (j := (k - S e)%nat). replace (k - e)%nat with (S j) in * by (unfold j; lia).
      destruct (divided_limit j P 1 P0) as [phi [T' [Co' [P' _]]]].
      + split. lra. apply (lt_INR 1). lia.
      + intros n i. rewrite pow1, Rmult_1_r. auto.
      + exists phi. split; auto. split; auto. split; auto. exists psi. split; auto.
        apply (data_derivative A Arity (divided j) (divided (S j)) phi psi); auto.
        * intros n i. apply divided_succ.
        * intros eta Heta. destruct (T eta Heta) as [n0 Hn]. exists n0. intros n Hle l. specialize (Hn n Hle (IZR l / INR A ^ n)).
          rewrite (grid_value A Arity), (floor_integer A Arity) in Hn. auto. }
  destruct (Base k (le_n k)) as [phi [T [Co [_ Ho]]]]. rewrite Nat.sub_diag in T. exists phi. split; [|auto].
  replace f with (divided 0); auto. extensionality n. extensionality i. unfold divided. simpl. ring.
Qed.
End Smooth.

Theorem grid_exponent m l B : 0 < l <= INR m -> (forall i, Rabs (f O i) <= B) ->
  (forall x, 0 < x < l -> exists C, forall n i, Rabs (differences m (f n) i) <= C * exp (- x * lambda) ^ n) ->
  exists phi, tends A f phi /\ continuity phi /\ exponent_at_least phi l.
Proof.
  intros Hl HB HD.
  assert (One : forall x, x < l -> exists phi, tends A f phi /\ continuity phi /\ exists s, exponents phi s /\ x < s).
  { intros x Hx. destruct (order_between m x l Hx Hl) as [k [w [Hk [Hw [Wl Wx]]]]].
    destruct (HD w Wl) as [C HC].
    destruct (grid_holder m k w C B Hk Hw HB HC) as [phi [T [Co Ho]]].
    exists phi. split; auto. split; auto. exists w. split; [|auto]. exists k, (w - INR k). split; [lra|]. split; auto. lra. }
  destruct (One 0 ltac:(lra)) as [phi [T [Co _]]]. exists phi. split; auto. split; auto. intros x Hx.
  destruct (One x Hx) as [psi [T' [_ Hs]]]. replace phi with psi; auto. extensionality t. apply (tends_unique psi phi); auto.
Qed.
End Values.
End Grid.
