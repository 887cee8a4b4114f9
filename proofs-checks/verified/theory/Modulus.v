(* The modulus of continuity of the last derivative, with powers of a logarithm: Theorem 28 of SPEC.md. *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision Differences Stability.
Open Scope R_scope.

(* g is the derivative of order k of f. *)
Fixpoint derivative (k : nat) (f g : R -> R) : Prop :=
  match k with
  | O => forall x, f x = g x
  | S m => exists f', (forall x, derivable_pt_lim f x (f' x)) /\ derivative m f' g
  end.

(* Let s be the exponent, k the largest integer below s, and g the derivative of order k. Over a distance h = exp t of at
   most 1/2 it changes by at most C h^(s - k) |log h|^P; and whatever bounds its changes over distances of at most
   h = A^(-n) is at least c h^(s - k) |log h|^P. *)
Definition has_modulus (lambda s : R) (P : nat) (phi : R -> R) : Prop := exists k g c C,
  INR k < s <= INR k + 1 /\ 0 < c /\ derivative k phi g /\
  (forall x t, exp t <= / 2 -> Rabs (g (x + exp t) - g x) <= C * exp ((s - INR k) * t) * (- t) ^ P) /\
  (forall n w, (1 <= n)%nat -> (forall x h, 0 < h <= exp (- (INR n * lambda)) -> Rabs (g (x + h) - g x) <= w) ->
    c * exp (- ((s - INR k) * (INR n * lambda))) * (INR n * lambda) ^ P <= w).

(* ---- powers of n ------------------------------------------------------------------------------------------------- *)

Lemma power_ratio P : forall rho, 1 < rho -> exists N, forall n, (N <= n)%nat -> INR (S n) ^ P <= rho * INR n ^ P.
Proof.
  induction P; intros rho Hr. exists O. intros. simpl. lra.
  destruct (IHP ((1 + rho) / 2) ltac:(lra)) as [N H]. set (r1 := (1 + rho) / 2) in *. assert (R1 : 1 < r1 < rho) by (unfold r1; lra).
  set (r2 := rho / r1). assert (R2 : 1 < r2). { apply (Rmult_lt_reg_r r1). lra. unfold r2, Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Un : exists N2, / (r2 - 1) < INR N2).
  { destruct (archimed (/ (r2 - 1))) as [U _]. exists (Z.to_nat (up (/ (r2 - 1)))). assert (0 < / (r2 - 1)) by (apply Rinv_0_lt_compat; lra).
    rewrite INR_IZR_INZ, Z2Nat.id. lra. apply le_IZR. lra. }
  destruct Un as [N2 H2]. exists (N + N2)%nat. intros n Hn. specialize (H n ltac:(lia)).
  assert (A : INR (S n) <= r2 * INR n).
  { assert (INR N2 <= INR n) by (apply le_INR; lia). rewrite S_INR.
    assert (B : (r2 - 1) * / (r2 - 1) <= (r2 - 1) * INR n) by (apply Rmult_le_compat_l; lra). rewrite Rinv_r in B by lra. lra. }
  change (INR (S n) ^ S P) with (INR (S n) * INR (S n) ^ P). change (INR n ^ S P) with (INR n * INR n ^ P). replace rho with (r2 * r1) by (unfold r2; field; lra). replace (r2 * r1 * (INR n * INR n ^ P)) with ((r2 * INR n) * (r1 * INR n ^ P)) by ring.
  apply Rmult_le_compat; auto. apply pos_INR. apply pow_le, pos_INR.
Qed.

Lemma power_small P rho : 1 < rho -> exists C, 0 <= C /\ forall n, INR (n + 1) ^ P <= C * rho ^ n.
Proof.
  intros Hr. destruct (power_ratio P rho Hr) as [N H]. exists (INR (N + 1) ^ P). split. apply pow_le, pos_INR. intros n.
  apply Rle_trans with (INR (n + (N + 1)) ^ P). apply pow_incr. split. apply pos_INR. apply le_INR. lia.
  induction n. simpl. lra. replace (S n + (N + 1))%nat with (S (n + (N + 1))) by lia. eapply Rle_trans. apply H. lia.
  simpl pow. apply (Rmult_le_compat_l rho) in IHn; lra.
Qed.

Section Scheme.
Variables (A : nat) (F : Z) (L : nat).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.
Let steps := refined A F L.

(* ---- data of steps that change little ---------------------------------------------------------------------------- *)

Section Close.
Variables (f : nat -> Z -> R) (phi : R -> R) (E theta : R) (P : nat).
Hypothesis Theta : 0 < theta < 1.
Hypothesis E0 : 0 <= E.
Hypothesis Near : forall n i, Rabs (f n i - f n (i - 1)%Z) <= E * INR (n + 1) ^ P * theta ^ n.
Hypothesis Step : forall n i, Rabs (f (S n) i - f n (i / ZA)%Z) <= E * INR (n + 1) ^ P * theta ^ n.
Hypothesis Tends : tends A f phi.
Let u (x : R) (n : nat) : R := f n (floor (INR A ^ n * x)).

Lemma close_limit : exists K, 0 <= K /\ forall n x y, x <= y -> INR A ^ n * (y - x) <= 1 ->
  Rabs (phi y - phi x) <= K * INR (n + 1) ^ P * theta ^ n.
Proof.
  set (rho := (1 + theta) / (2 * theta)).
  assert (Rho : 1 < rho). { apply (Rmult_lt_reg_r (2 * theta)). lra. unfold rho, Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (TR : theta * rho = (1 + theta) / 2) by (unfold rho; field; lra).
  destruct (power_ratio P rho Rho) as [N Ratio]. set (q := (N + 1)%nat).
  set (K0 := 2 * E / (1 - theta)). assert (HK0 : 0 <= K0) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
  set (e := fun n => K0 * INR (n + q) ^ P * theta ^ n).
  assert (Pow : forall n, 0 < theta ^ n) by (intros; apply pow_lt; lra).
  assert (Num : forall n, 0 <= INR (n + q) ^ P) by (intros; apply pow_le, pos_INR).
  assert (More : forall n, E * INR (n + 1) ^ P * theta ^ n <= E * INR (n + q) ^ P * theta ^ n).
  { intros n. apply Rmult_le_compat_r. left; auto. apply Rmult_le_compat_l; auto. apply pow_incr. split. apply pos_INR. apply le_INR. unfold q. lia. }
  assert (Down : forall n, E * INR (n + q) ^ P * theta ^ n <= e n - e (S n)).
  { intros n. unfold e. specialize (Ratio (n + q)%nat ltac:(unfold q; lia)). change (S n + q)%nat with (S (n + q)). specialize (Num n). specialize (Pow n).
    set (v := INR (n + q) ^ P) in *. set (v' := INR (S (n + q)) ^ P) in *. simpl pow.
    assert (H1 : theta * v' <= (1 + theta) / 2 * v). { rewrite <- TR, Rmult_assoc. apply Rmult_le_compat_l; lra. }
    assert (H2 : K0 * theta ^ n * (theta * v') <= K0 * theta ^ n * ((1 + theta) / 2 * v)) by (apply Rmult_le_compat_l; auto; apply Rmult_le_pos; lra).
    replace (E * v * theta ^ n) with (K0 * v * theta ^ n - K0 * theta ^ n * ((1 + theta) / 2 * v)) by (unfold K0; field; lra). lra. }
  assert (Epos : forall n, 0 <= e n). { intros n. unfold e. apply Rmult_le_pos; [apply Rmult_le_pos; auto|left; auto]. }
  assert (Steps : forall x n m, Rabs (u x (n + m)%nat - u x n) <= e n - e (n + m)%nat).
  { intros x n m. induction m. rewrite Nat.add_0_r, !Rminus_diag_eq, Rabs_R0 by auto. lra.
    replace (u x (n + S m)%nat - u x n) with ((u x (n + S m)%nat - u x (n + m)%nat) + (u x (n + m)%nat - u x n)) by ring.
    eapply Rle_trans. apply Rabs_triang. assert (S1 : Rabs (u x (n + S m)%nat - u x (n + m)%nat) <= e (n + m)%nat - e (S (n + m))).
    { eapply Rle_trans; [|apply Down]. eapply Rle_trans; [|apply More]. unfold u. rewrite Nat.add_succ_r. rewrite <- (floor_step A Arity (INR A ^ (n + m) * x)).
      rewrite <- Rmult_assoc, tech_pow_Rmult. apply Step. }
    rewrite Nat.add_succ_r. rewrite Nat.add_succ_r in S1. lra. }
  assert (Lim : forall x n, Rabs (phi x - u x n) <= e n).
  { intros x n. apply le_epsilon. intros eps He. destruct (Tends eps He) as [n0 H]. specialize (H (n + n0)%nat ltac:(lia) x). fold (u x (n + n0)%nat) in H.
    specialize (Steps x n n0). specialize (Epos (n + n0)%nat). rewrite Rabs_minus_sym in H.
    replace (phi x - u x n) with ((phi x - u x (n + n0)%nat) + (u x (n + n0)%nat - u x n)) by ring. eapply Rle_trans. apply Rabs_triang. lra. }
  exists ((2 * K0 + E) * INR q ^ P). split. apply Rmult_le_pos. lra. apply pow_le, pos_INR.
  intros n x y Hxy H. assert (Hx := Lim x n). assert (Hy := Lim y n). unfold u in Hx, Hy.
  set (fx := floor (INR A ^ n * x)) in *. set (fy := floor (INR A ^ n * y)) in *. assert (PN := power_positive A Arity n).
  assert (H0 : Rabs (f n fy - f n fx) <= E * INR (n + q) ^ P * theta ^ n).
  { destruct (floor_bounds (INR A ^ n * x)) as [X1 X2]. destruct (floor_bounds (INR A ^ n * y)) as [Y1 Y2]. fold fx in X1, X2. fold fy in Y1, Y2.
    assert (INR A ^ n * x <= INR A ^ n * y) by (apply Rmult_le_compat_l; lra).
    assert (fx < fy + 1)%Z by (apply lt_IZR; rewrite plus_IZR; lra).
    assert (fy < fx + 2)%Z by (apply lt_IZR; rewrite plus_IZR; lra).
    destruct (Z.eq_dec fy fx) as [->|].
    - rewrite Rminus_diag_eq, Rabs_R0 by auto. apply Rmult_le_pos; [apply Rmult_le_pos; auto|left; auto].
    - replace fx with (fy - 1)%Z by lia. eapply Rle_trans; [apply Near|apply More]. }
  replace (phi y - phi x) with ((phi y - f n fy) + (f n fy - f n fx) + - (phi x - f n fx)) by ring.
  eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. eapply Rle_trans. apply Rplus_le_compat_r, Rabs_triang.
  assert (Q : INR (n + q) ^ P <= INR q ^ P * INR (n + 1) ^ P).
  { rewrite <- Rpow_mult_distr. apply pow_incr. split. apply pos_INR. rewrite <- mult_INR. apply le_INR. unfold q. nia. }
  assert (T : (2 * K0 + E) * theta ^ n * INR (n + q) ^ P <= (2 * K0 + E) * theta ^ n * (INR q ^ P * INR (n + 1) ^ P)).
  { apply Rmult_le_compat_l; auto. apply Rmult_le_pos. lra. left; auto. }
  unfold e in Hx, Hy. lra.
Qed.
End Close.

(* ---- the chain ---------------------------------------------------------------------------------------------------- *)

Lemma smooth_growth_power K c D r r' P : supported F K c -> (K + A - 1 <= L)%nat -> total F L c = INR A -> 0 < r -> 1 < r' -> r <= INR A * r' ->
  (forall n i, Rabs (steps c n i) <= D * INR (n + 1) ^ P * r ^ n) ->
  exists D', forall n i, Rabs (steps (smooth A c) n i) <= D' * INR (n + 1) ^ P * r' ^ n.
Proof.
  intros H HK Ht Hr Hr' Hrr HD. assert (PA := arity_positive A Arity).
  assert (HD0 : 0 <= D). { specialize (HD O 0%Z). simpl in HD. rewrite pow1 in HD. assert (X := Rabs_pos (delta 0)). unfold steps in HD. simpl in HD. lra. }
  assert (Num : forall n, 0 <= INR (n + 1) ^ P) by (intros; apply pow_le, pos_INR).
  assert (Dif : forall n i, Rabs (steps (smooth A c) n i - steps (smooth A c) n (i - 1)%Z) <= 2 * D * INR (n + 1) ^ P * r' ^ n).
  { intros n i. unfold steps. rewrite (refined_difference A F L Arity K) by auto. rewrite Rabs_mult.
    assert (PN : 0 < INR A ^ n) by (apply pow_lt; auto).
    rewrite Rabs_pos_eq by (left; apply Rinv_0_lt_compat; auto).
    apply Rle_trans with (/ INR A ^ n * (2 * D * INR (n + 1) ^ P * (INR A ^ n * r' ^ n))).
    - apply Rmult_le_compat_l. left; apply Rinv_0_lt_compat; auto.
      rewrite <- Rpow_mult_distr. apply Rle_trans with (2 * D * INR (n + 1) ^ P * r ^ n).
      + unfold Rminus. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp.
        generalize (HD n i) (HD n (i - ZA ^ Z.of_nat n)%Z). unfold steps, ZA. unfold Z.sub. lra.
      + apply Rmult_le_compat_l. apply Rmult_le_pos; auto. lra. apply pow_incr. lra.
    - right. field. lra. }
  destruct (step_near A F L Arity _ (smooth A c) (supported_smooth A F Arity K c H) (fun i => smooth_classes A F L Arity K c i H HK Ht)) as [C [HC Near]].
  set (G := 1 + C * (2 * D) / (r' - 1)). assert (G0 : 0 <= C * (2 * D) / (r' - 1)).
  { apply Rmult_le_pos. apply Rmult_le_pos; lra. left; apply Rinv_0_lt_compat; lra. }
  exists G. intros n. induction n; intros i.
  - unfold steps. simpl. rewrite pow1. unfold delta, G. destruct (Z.eqb i 0); [rewrite Rabs_R1 | rewrite Rabs_R0]; lra.
  - unfold steps in *. cbn [refined]. specialize (Near _ _ (Dif n) i). specialize (IHn (i / ZA)%Z). fold ZA in Near.
    set (y := subdivide A F L (smooth A c) (refined A F L (smooth A c) n) i) in *. set (x := refined A F L (smooth A c) n (i / ZA)%Z) in *.
    replace y with ((y - x) + x) by lra. eapply Rle_trans. apply Rabs_triang.
    assert (Q : 0 < r' ^ n) by (apply pow_lt; lra). assert (Nn := Num n).
    assert (Inc : INR (n + 1) ^ P <= INR (S n + 1) ^ P) by (apply pow_incr; split; [apply pos_INR|apply le_INR; lia]).
    apply Rle_trans with ((C * (2 * D) + G) * INR (n + 1) ^ P * r' ^ n). lra.
    rewrite <- tech_pow_Rmult.
    assert (X : C * (2 * D) + G <= G * r'). { unfold G. replace ((1 + C * (2 * D) / (r' - 1)) * r') with ((1 + C * (2 * D) / (r' - 1)) + (r' - 1) + C * (2 * D)) by (field; lra). lra. }
    assert (GC : 0 <= C * (2 * D) + G). { unfold G. assert (0 <= C * (2 * D)) by (apply Rmult_le_pos; lra). lra. }
    replace (G * INR (S n + 1) ^ P * (r' * r' ^ n)) with ((G * r') * INR (S n + 1) ^ P * r' ^ n) by ring.
    apply Rmult_le_compat_r. lra. apply Rmult_le_compat; auto.
Qed.

Lemma derivative_difference k : forall f g, derivative k f g -> derivative k (fun x => f x - f (x - 1)) (fun x => g x - g (x - 1)).
Proof.
  induction k; intros f g H. intros x. rewrite !H. auto.
  destruct H as [f' [D H]]. exists (fun x => f' x - f' (x - 1)). split; [|apply IHk; auto].
  intros x. apply (derivable_pt_lim_minus f (fun x => f (x - 1))). auto.
  intros eps He. destruct (D (x - 1) eps He) as [delta Hd]. exists delta. intros h H0 Hh.
  replace (x + h - 1) with (x - 1 + h) by lra. auto.
Qed.

Definition modulus_bound (P : nat) (theta : R) (g : R -> R) : Prop := exists K, 0 <= K /\ forall n x y, x <= y -> INR A ^ n * (y - x) <= 1 ->
  Rabs (g y - g x) <= K * INR (n + 1) ^ P * theta ^ n.

Lemma modulus_difference P theta g : modulus_bound P theta g -> modulus_bound P theta (fun x => g x - g (x - 1)).
Proof.
  intros [K [K0 H]]. exists (2 * K). split. lra. intros n x y Hxy Hn. assert (H1 := H n x y Hxy Hn).
  assert (H2 := H n (x - 1) (y - 1) ltac:(lra) ltac:(replace (y - 1 - (x - 1)) with (y - x) by ring; auto)).
  replace (g y - g (y - 1) - (g x - g (x - 1))) with ((g y - g x) + - (g (y - 1) - g (x - 1))) by ring.
  eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. lra.
Qed.

Section Chain.
Variables (lambda : R) (N M k P : nat) (b : Z -> R) (s C : R).
Hypothesis Log : exp lambda = INR A.
Hypothesis Support : supported F N b.
Hypothesis Fits : (N + M * (A - 1) <= L)%nat.
Hypothesis Total : total F L b = INR A.
Hypothesis Order : (k < M)%nat.
Hypothesis Between : INR k < s <= INR k + 1.
Hypothesis Strict : s < INR k + 1 \/ M = S k.
Hypothesis Growth : forall n i, Rabs (steps b n i) <= C * INR (n + 1) ^ P * exp ((INR M - s) * lambda) ^ n.

Let theta := exp ((INR k - s) * lambda).

Lemma theta_small : 0 < theta < 1.
Proof.
  split. apply exp_pos. unfold theta. rewrite <- exp_0, <- (Rmult_0_l lambda). apply (power_less A Arity lambda Log). lra.
Qed.

Theorem limit_modulus : exists phi g, is_limit A F L (smoothed A M b) phi /\ tends A (steps (smoothed A M b)) phi /\
  derivative k phi g /\ modulus_bound P theta g.
Proof.
  assert (PA := arity_positive A Arity). assert (Th := theta_small).
  assert (Fit : forall m, (m < M)%nat -> (N + m * (A - 1) + A - 1 <= L)%nat)
    by (intros m Hm; generalize (Nat.mul_le_mono_r (S m) M (A - 1) Hm); rewrite Nat.mul_succ_l;
      revert Fits; generalize (m * (A - 1))%nat (M * (A - 1))%nat; lia).
  assert (Tot : forall m, (m < M)%nat -> total F L (smoothed A m b) = INR A).
  { intros m Hm. rewrite (smoothed_total A F L Arity N); auto. specialize (Fit m Hm). lia. }
  assert (G : forall m, (m + k + 1 <= M)%nat -> exists D', forall n i,
    Rabs (steps (smoothed A m b) n i) <= D' * INR (n + 1) ^ P * exp ((INR M - INR m - s) * lambda) ^ n).
  { induction m; intros Hm.
    - exists C. simpl INR at 3. rewrite Rminus_0_r. exact Growth.
    - destruct (IHm ltac:(lia)) as [D' H']. cbn [smoothed]. destruct Strict as [St|St]; [|exfalso; lia].
      apply (smooth_growth_power (N + m * (A - 1)) (smoothed A m b) D' (exp ((INR M - INR m - s) * lambda))); auto.
      + apply smoothed_supported; auto.
      + apply Fit. lia.
      + apply Tot. lia.
      + apply exp_pos.
      + rewrite <- exp_0, <- (Rmult_0_l lambda). apply (power_less A Arity lambda Log). apply le_INR in Hm. rewrite !plus_INR in Hm. simpl (INR 1) in Hm. lra.
      + right. rewrite <- (power_succ A lambda Log). f_equal. f_equal. rewrite S_INR. ring. }
  assert (Base : forall e, (e <= k)%nat -> exists phi g, tends A (steps (smoothed A (M - k + e) b)) phi /\ continuity phi /\
    (exists B, forall n i, Rabs (steps (smoothed A (M - k + e) b) n i) <= B) /\ derivative e phi g /\ modulus_bound P theta g).
  { induction e; intros He.
    - destruct (G (M - k - 1)%nat ltac:(lia)) as [D' H']. set (c := smoothed A (M - k - 1) b) in *.
      replace (M - k + 0)%nat with (S (M - k - 1)) by lia. cbn [smoothed]. fold c.
      assert (Ex : INR M - INR (M - k - 1) - s = 1 + (INR k - s)). { rewrite !minus_INR by lia. simpl. ring. }
      rewrite Ex, (power_succ A lambda Log) in H'. fold theta in H'.
      assert (D0 : 0 <= D'). { assert (X := H' O 0%Z). simpl in X. rewrite pow1 in X. assert (Y := Rabs_pos (steps c 0 0%Z)). unfold steps in *. simpl in *. lra. }
      assert (Sc : supported F (N + (M - k - 1) * (A - 1)) c) by (apply smoothed_supported; auto).
      assert (Fc : (N + (M - k - 1) * (A - 1) + A - 1 <= L)%nat) by (apply Fit; lia). assert (Tc : total F L c = INR A) by (apply Tot; lia).
      set (rho := (1 + theta) / (2 * theta)).
      assert (Rho : 1 < rho). { apply (Rmult_lt_reg_r (2 * theta)). lra. unfold rho, Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
      assert (TR : theta * rho = (1 + theta) / 2) by (unfold rho; field; lra).
      destruct (power_small P rho Rho) as [B [B0 HB]].
      destruct (smooth_limit A F L Arity (N + (M - k - 1) * (A - 1)) c (D' * B) (INR A * (theta * rho))) as [phi [T [Co [Bo _]]]]; auto.
      { split. apply Rmult_lt_0_compat; auto; rewrite TR; lra. rewrite TR. rewrite <- (Rmult_1_r (INR A)) at 2. apply Rmult_lt_compat_l; lra. }
      { intros n i. eapply Rle_trans. apply H'. rewrite !Rpow_mult_distr. specialize (HB n).
        replace (D' * B * (INR A ^ n * (theta ^ n * rho ^ n))) with (D' * (B * rho ^ n) * (INR A ^ n * theta ^ n)) by ring.
        apply Rmult_le_compat_r. apply Rmult_le_pos; apply pow_le; lra. apply Rmult_le_compat_l; auto. }
      exists phi, phi. split; auto. split; auto. split; auto. split. intros x; auto.
      assert (Num : forall n, 0 <= INR (n + 1) ^ P) by (intros; apply pow_le, pos_INR).
      assert (Dif : forall n i, Rabs (steps (smooth A c) n i - steps (smooth A c) n (i - 1)%Z) <= 2 * D' * INR (n + 1) ^ P * theta ^ n).
      { intros n i. unfold steps. rewrite (refined_difference A F L Arity (N + (M - k - 1) * (A - 1))) by auto. assert (PN := power_positive A Arity n).
        rewrite Rabs_mult, Rabs_pos_eq by (left; apply Rinv_0_lt_compat; auto).
        replace (2 * D' * INR (n + 1) ^ P * theta ^ n) with (/ INR A ^ n * (2 * D' * INR (n + 1) ^ P * (INR A ^ n * theta ^ n))) by (field; lra).
        rewrite <- Rpow_mult_distr. apply Rmult_le_compat_l. left; apply Rinv_0_lt_compat; auto.
        unfold Rminus. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. generalize (H' n i) (H' n (i - ZA ^ Z.of_nat n)%Z). unfold steps, ZA, Z.sub. lra. }
      destruct (step_near A F L Arity _ (smooth A c) (supported_smooth A F Arity _ c Sc) (fun i => smooth_classes A F L Arity _ c i Sc Fc Tc)) as [C' [HC Near]].
      apply (close_limit (steps (smooth A c)) phi (2 * D' * (1 + C')) theta P Th); auto.
      + apply Rmult_le_pos; lra.
      + intros n i. eapply Rle_trans. apply Dif. apply Rmult_le_compat_r. apply pow_le; lra. apply Rmult_le_compat_r; auto.
        assert (0 <= D' * C') by (apply Rmult_le_pos; auto). lra.
      + intros n i. unfold steps. cbn [refined]. fold steps. eapply Rle_trans. apply (Near _ _ (Dif n)). rewrite <- !Rmult_assoc.
        apply Rmult_le_compat_r. apply pow_le; lra. apply Rmult_le_compat_r; auto. assert (0 <= D' * C') by (apply Rmult_le_pos; auto). lra.
    - destruct (IHe ltac:(lia)) as [psi [g [T [Co [[B HB] [De Mo]]]]]]. replace (M - k + S e)%nat with (S (M - k + e)) by lia. cbn [smoothed].
      destruct (smooth_limit A F L Arity (N + (M - k + e) * (A - 1)) (smoothed A (M - k + e) b) B 1) as [phi [T' [C' [B' _]]]]; auto.
      + apply smoothed_supported; auto.
      + apply Fit. lia.
      + apply Tot. lia.
      + split. lra. apply (lt_INR 1). lia.
      + intros n i. rewrite pow1, Rmult_1_r. apply HB.
      + exists phi, (fun x => g x - g (x - 1)). split; auto. split; auto. split; auto. split; [|apply modulus_difference; auto].
        exists (fun t => psi t - psi (t - 1)). split; [|apply derivative_difference; auto].
        apply (smooth_derivative A F L Arity (N + (M - k + e) * (A - 1)) (smoothed A (M - k + e) b)); auto.
        * apply smoothed_supported; auto.
        * apply Fit. lia. }
  destruct (Base k (le_n k)) as [phi [g [T [Co [_ [De Mo]]]]]]. replace (M - k + k)%nat with M in T by lia.
  exists phi, g. split; [|split]; auto. apply tends_limit; auto.
Qed.

(* The same over the distance exp t *)
Lemma modulus_upper g : modulus_bound P theta g ->
  exists K, forall x t, exp t <= / 2 -> Rabs (g (x + exp t) - g x) <= K * exp ((s - INR k) * t) * (- t) ^ P.
Proof.
  intros [K [K0 H]]. assert (Lam := log_positive A Arity lambda Log).
  destruct (exp_onto 2 ltac:(lra)) as [tau Tau].
  assert (Tau0 : 0 < tau). { apply Rnot_le_lt. intros Z. apply exp_at_most in Z. rewrite exp_0 in Z. lra. }
  exists (K * (/ lambda + / tau) ^ P * exp ((s - INR k) * lambda)). intros x t Ht.
  assert (T : tau <= - t). { apply exp_reflects. rewrite Tau, exp_Ropp. rewrite <- (Rinv_inv 2). apply Rinv_le_contravar; auto. apply exp_pos. }
  assert (T1 : 1 <= / tau * - t). { apply (Rmult_le_reg_l tau); auto. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l, Rmult_1_r by lra. auto. }
  set (n := Z.to_nat (floor (- t / lambda))). destruct (floor_bounds (- t / lambda)) as [F1 F2].
  assert (Q0 : 0 <= - t / lambda) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; auto]).
  assert (Fl : (0 <= floor (- t / lambda))%Z) by (apply Z.lt_succ_r, lt_IZR; rewrite <- Z.add_1_r, plus_IZR; lra).
  assert (Hn : INR n = IZR (floor (- t / lambda))) by (unfold n; rewrite INR_IZR_INZ, Z2Nat.id; auto). rewrite <- Hn in F1, F2.
  assert (N1 : INR n * lambda <= - t). { apply (Rmult_le_compat_r lambda) in F1; [|lra]. unfold Rdiv in F1. rewrite Rmult_assoc, Rinv_l in F1; lra. }
  assert (N2 : - t < INR n * lambda + lambda). { apply (Rmult_lt_compat_r lambda) in F2; [|lra]. unfold Rdiv in F2. rewrite Rmult_assoc, Rinv_l in F2; lra. }
  assert (B : Rabs (g (x + exp t) - g x) <= K * INR (n + 1) ^ P * theta ^ n).
  { apply H. assert (Ep := exp_pos t). lra. replace (x + exp t - x) with (exp t) by ring. rewrite <- Log, exp_power, <- exp_plus, <- exp_0. apply exp_at_most. lra. }
  eapply Rle_trans. apply B.
  assert (B1 : INR (n + 1) ^ P <= (/ lambda + / tau) ^ P * (- t) ^ P).
  { rewrite <- Rpow_mult_distr. apply pow_incr. split. apply pos_INR. rewrite plus_INR. simpl (INR 1). unfold Rdiv in F1. lra. }
  assert (B2 : theta ^ n <= exp ((s - INR k) * lambda) * exp ((s - INR k) * t)).
  { unfold theta. rewrite exp_power, <- exp_plus. apply exp_at_most. assert ((s - INR k) * (- t) <= (s - INR k) * (INR n * lambda + lambda)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (0 <= theta ^ n) by (apply pow_le; left; apply exp_pos). assert (0 <= INR (n + 1) ^ P) by (apply pow_le, pos_INR).
  apply Rle_trans with (K * ((/ lambda + / tau) ^ P * (- t) ^ P) * (exp ((s - INR k) * lambda) * exp ((s - INR k) * t))).
  - apply Rmult_le_compat; auto. apply Rmult_le_pos; auto. apply Rmult_le_compat_l; auto.
  - right. ring.
Qed.

(* ---- from below --------------------------------------------------------------------------------------------------- *)

Lemma derivative_differences h w : 0 <= h -> forall j f g, derivative j f g -> (forall x, Rabs (back h g x) <= w) ->
  forall x, Rabs (backs (S j) h f x) <= w * h ^ j.
Proof.
  intros Hh. induction j; intros f g D H x.
  - simpl. rewrite Rmult_1_r. replace f with g; auto. extensionality y. symmetry. apply D.
  - destruct D as [f' [D D']]. change (backs (S (S j)) h f x) with (backs (S j) h f x - backs (S j) h f (x - h)).
    eapply Rle_trans. apply (mean_value _ (backs (S j) h f') (w * h ^ j)).
    + apply backs_derivative. auto.
    + apply (IHj f' g); auto.
    + lra.
    + right. replace (x - (x - h)) with h by lra. simpl. ring.
Qed.

Let a := smoothed A M b.
Variables (phi g : R -> R) (c : R).
Hypothesis Tends : tends A (steps a) phi.
Hypothesis Stable : stable phi.
Hypothesis Derivative : derivative k phi g.
Hypothesis C0 : 0 < c.
Hypothesis Large : forall n, (1 <= n)%nat -> exists i, c * INR n ^ P * exp ((INR M - s) * lambda) ^ n <= Rabs (steps b n i).

Lemma coefficients_small : exists K, 0 < K /\ forall n w, (forall x, Rabs (backs M (/ INR A ^ n) phi x) <= w) ->
  forall i, Rabs (steps b n i) <= K * (INR A ^ n) ^ M * w.
Proof.
  assert (SA : supported F L a).
  { apply (supported_more A F Arity (N + M * (A - 1))); auto. apply (smoothed_supported A F Arity); auto. }
  destruct Stable as [K HK]. exists (INR (N + 1 + M) ^ M * (Rabs K + 1)). split.
  { apply Rmult_lt_0_compat. apply pow_lt, (lt_INR 0). lia. assert (X := Rabs_pos K). lra. }
  intros n w Hw i. assert (PN := power_positive A Arity n). assert (IP := power_integer A Arity n).
  assert (W0 : 0 <= w) by (eapply Rle_trans; [apply Rabs_pos|apply (Hw 0)]).
  assert (Small : forall j, Rabs (zbacks M 1 (steps a n) j) <= K * w).
  { assert (In := refined_inside A F L Arity L a n SA (le_n L)). set (lo := (F * (Z.of_nat A ^ Z.of_nat n - 1) / (Z.of_nat A - 1))%Z) in *. set (wd := Z.to_nat _) in In.
    apply (HK _ lo (wd + M)%nat). apply (combination_backs A Arity phi (steps a n) lo wd n M In 0).
    intros y. replace y with (INR A ^ n * (y / INR A ^ n)) by (field; lra).
    destruct (combination_backs A Arity phi (steps a n) lo wd n M In (y / INR A ^ n)) as [_ E]. rewrite <- E.
    replace (fun x => combination phi (steps a n) lo wd (INR A ^ n * x)) with phi by (extensionality x; apply (refinement A F L Arity a phi Tends n lo wd In)).
    apply Hw. }
  assert (Back : forall j, Rabs (zbacks M (Z.of_nat A ^ Z.of_nat n) (steps b n) j) <= (INR A ^ n) ^ M * (K * w)).
  { intros j. specialize (Small j). unfold a in Small. unfold steps in Small. rewrite (zbacks_refined A F L Arity N) in Small by auto.
    rewrite Rabs_mult in Small. rewrite Rabs_pos_eq in Small by (apply pow_le; left; apply Rinv_0_lt_compat; auto).
    apply (Rmult_le_compat_l ((INR A ^ n) ^ M)) in Small; [|apply pow_le; lra].
    rewrite <- Rmult_assoc, <- Rpow_mult_distr, Rinv_r, pow1, Rmult_1_l in Small by lra. exact Small. }
  apply Rle_trans with (INR (N + 1 + M) ^ M * ((INR A ^ n) ^ M * (K * w))).
  - apply (zbacks_bound A Arity (N + 1) M (Z.of_nat A ^ Z.of_nat n) (F * (Z.of_nat A ^ Z.of_nat n - 1) / (Z.of_nat A - 1)) (steps b n)); auto.
    intros j Hj. assert (In := refined_inside A F L Arity N b n Support ltac:(revert Fits; generalize (M * (A - 1))%nat; lia)). apply In.
    rewrite Z2Nat.id by (apply Z.mul_nonneg_nonneg; lia). exact Hj.
  - rewrite !Rmult_assoc. apply Rmult_le_compat_l. apply pow_le, pos_INR.
    replace ((Rabs K + 1) * ((INR A ^ n) ^ M * w)) with ((INR A ^ n) ^ M * ((Rabs K + 1) * w)) by ring.
    apply Rmult_le_compat_l. apply pow_le; lra. apply Rmult_le_compat_r; auto. assert (X := Rle_abs K). lra.
Qed.

Lemma modulus_lower : exists c', 0 < c' /\ forall n w, (1 <= n)%nat ->
  (forall x h, 0 < h <= exp (- (INR n * lambda)) -> Rabs (g (x + h) - g x) <= w) ->
  c' * exp (- ((s - INR k) * (INR n * lambda))) * (INR n * lambda) ^ P <= w.
Proof.
  assert (Lam := log_positive A Arity lambda Log). destruct coefficients_small as [K [K0 HK]].
  set (T := 2 ^ (M - S k)). assert (T0 : 0 < T) by (apply pow_lt; lra). assert (LP : 0 < lambda ^ P) by (apply pow_lt; auto).
  exists (c / (K * T * lambda ^ P)). split. { apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; auto. apply Rmult_lt_0_compat; auto. }
  intros n w Hn H. assert (PN := power_positive A Arity n). assert (Et : exp (- (INR n * lambda)) = / INR A ^ n) by (rewrite exp_Ropp, <- exp_power, Log; auto).
  set (h := / INR A ^ n) in *. assert (H0 : 0 < h) by (apply Rinv_0_lt_compat; auto).
  assert (D : forall x, Rabs (backs M h phi x) <= T * (w * h ^ k)).
  { unfold T. intros x. replace M with ((M - S k) + S k)%nat at 1 by lia. apply backs_more. intros y.
    apply (derivative_differences h w ltac:(lra) k phi g); auto. intros z. unfold back. specialize (H (z - h) h ltac:(lra)).
    replace (z - h + h) with z in H by ring. exact H. }
  destruct (Large n Hn) as [i Hi]. specialize (HK n _ D i). assert (B := Rle_trans _ _ _ Hi HK).
  assert (Eh : (INR A ^ n) ^ M * h ^ k = exp ((INR M - INR k) * (INR n * lambda))).
  { unfold h. rewrite <- Log, exp_power, <- exp_Ropp, !exp_power, <- exp_plus. f_equal. ring. }
  replace (K * (INR A ^ n) ^ M * (T * (w * h ^ k))) with (K * T * w * ((INR A ^ n) ^ M * h ^ k)) in B by ring. rewrite Eh in B. rewrite exp_power in B.
  set (E := exp ((INR M - INR k) * (INR n * lambda))) in *. assert (E0 : 0 < E) by apply exp_pos.
  assert (Split : exp (INR n * ((INR M - s) * lambda)) = exp (- ((s - INR k) * (INR n * lambda))) * E).
  { unfold E. rewrite <- exp_plus. f_equal. ring. }
  rewrite Split in B. set (e := exp (- ((s - INR k) * (INR n * lambda)))) in *.
  rewrite Rpow_mult_distr. apply (Rmult_le_reg_r (K * T * E)). repeat apply Rmult_lt_0_compat; auto.
  replace (c / (K * T * lambda ^ P) * e * (INR n ^ P * lambda ^ P) * (K * T * E)) with (c * INR n ^ P * (e * E)) by (field; lra). lra.
Qed.
End Chain.

(* Theorem 28 of SPEC.md. *)
Theorem growth_modulus lambda N M k P b s C c phi : exp lambda = INR A -> supported F N b -> (N + M * (A - 1) <= L)%nat -> total F L b = INR A ->
  (k < M)%nat -> INR k < s <= INR k + 1 -> s < INR k + 1 \/ M = S k ->
  (forall n i, Rabs (steps b n i) <= C * INR (n + 1) ^ P * exp ((INR M - s) * lambda) ^ n) ->
  0 < c -> (forall n, (1 <= n)%nat -> exists i, c * INR n ^ P * exp ((INR M - s) * lambda) ^ n <= Rabs (steps b n i)) ->
  is_limit A F L (smoothed A M b) phi -> stable phi -> has_modulus lambda s P phi.
Proof.
  intros Log HS HL HT Hk Hs St G C0 Large Lim Stab.
  destruct (limit_modulus lambda N M k P b s C Log HS HL HT Hk Hs St G) as [psi [g [Lim' [T [De Mo]]]]].
  assert (E : phi = psi) by (extensionality x; apply (limit_unique A F L Arity _ phi psi Lim Lim')). subst psi.
  destruct (modulus_upper lambda k P s Log Hs g Mo) as [K HK].
  destruct (modulus_lower lambda N M k P b s Log HS HL Hk St phi g c T Stab De C0 Large) as [c' [C0' HC]].
  exists k, g, c', K. split; auto.
Qed.
End Scheme.
