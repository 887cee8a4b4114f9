(* Differences of smooth functions are small: what is needed to bound exponents from above. *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision.
Open Scope R_scope.

(* ---- the mean value inequality, by bisection --------------------------------------------------------------------- *)

Section MeanValue.
Variables (f f' : R -> R) (B a b : R).
Hypothesis Derivative : forall x, derivable_pt_lim f x (f' x).
Hypothesis Bound : forall x, a <= x <= b -> Rabs (f' x) <= B.

Lemma near_derivative c eps : a <= c <= b -> 0 < eps -> exists d, 0 < d /\ forall x, Rabs (x - c) < d -> Rabs (f x - f c) <= (B + eps) * Rabs (x - c).
Proof.
  intros Hc He. destruct (Derivative c eps He) as [[d Hd] H]. exists d. split; auto. intros x Hx. simpl in H.
  destruct (Req_dec x c) as [->|N]. rewrite !Rminus_diag_eq, Rabs_R0 by auto. lra.
  specialize (H (x - c) ltac:(lra) Hx). replace (c + (x - c)) with x in H by lra.
  assert (P : 0 < Rabs (x - c)) by (apply Rabs_pos_lt; lra).
  replace (f x - f c) with (((f x - f c) / (x - c) - f' c) * (x - c) + f' c * (x - c)) by (field; lra).
  eapply Rle_trans. apply Rabs_triang. rewrite !Rabs_mult. specialize (Bound c Hc).
  assert (Rabs ((f x - f c) / (x - c) - f' c) * Rabs (x - c) <= eps * Rabs (x - c)) by (apply Rmult_le_compat_r; lra).
  assert (Rabs (f' c) * Rabs (x - c) <= B * Rabs (x - c)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Lemma mean_value_within : a <= b -> Rabs (f b - f a) <= B * (b - a).
Proof.
  intros Hab. apply Rnot_lt_le. intros N.
  assert (Lt : a < b). { destruct Hab as [|E]; auto. subst b. rewrite !Rminus_diag_eq, Rabs_R0 in N by auto. lra. }
  set (eps := (Rabs (f b - f a) - B * (b - a)) / (2 * (b - a))).
  assert (He : 0 < eps) by (apply Rdiv_lt_0_compat; lra).
  assert (Start : (B + eps) * (b - a) < Rabs (f b - f a)).
  { replace ((B + eps) * (b - a)) with (B * (b - a) + (Rabs (f b - f a) - B * (b - a)) / 2) by (unfold eps; field; lra). lra. }
  clearbody eps. clear N Hab.
  set (I := fix I n := match n with O => (a, b) | S m => let z := (fst (I m) + snd (I m)) / 2 in
    if Rlt_dec ((B + eps) * (z - fst (I m))) (Rabs (f z - f (fst (I m)))) then (fst (I m), z) else (z, snd (I m)) end).
  assert (Inv : forall n, fst (I n) < snd (I n) /\ snd (I n) - fst (I n) = (b - a) * (/ 2) ^ n /\
    (B + eps) * (snd (I n) - fst (I n)) < Rabs (f (snd (I n)) - f (fst (I n)))).
  { induction n. simpl. split; auto. split; auto. lra.
    destruct IHn as [H1 [H2 H3]]. cbn [I]. fold I. set (x := fst (I n)) in *. set (y := snd (I n)) in *. cbv zeta.
    set (z := (x + y) / 2). destruct (Rlt_dec ((B + eps) * (z - x)) (Rabs (f z - f x))) as [H|H]; simpl fst; simpl snd.
    - split. unfold z; lra. split; auto. simpl pow. unfold z. lra.
    - split. unfold z; lra. split. simpl pow. unfold z. lra.
      apply Rnot_lt_le in H. replace (f y - f x) with ((f y - f z) + (f z - f x)) in H3 by lra.
      assert (T := Rabs_triang (f y - f z) (f z - f x)).
      replace (y - x) with ((y - z) + (z - x)) in H3 by lra. rewrite Rmult_plus_distr_l in H3. lra. }
  assert (Mono : forall n, fst (I n) <= fst (I (S n)) /\ snd (I (S n)) <= snd (I n)).
  { intros n. destruct (Inv n) as [H1 _]. cbn [I]. fold I. cbv zeta. destruct (Rlt_dec _ _); simpl; lra. }
  assert (Low : forall n m, fst (I n) <= fst (I (n + m)%nat) /\ snd (I (n + m)%nat) <= snd (I n)).
  { induction m. rewrite Nat.add_0_r. lra. rewrite Nat.add_succ_r. destruct (Mono (n + m)%nat). lra. }
  assert (Cross : forall n m, fst (I n) <= snd (I m)).
  { intros n m. destruct (Low n m) as [L1 _]. destruct (Low m n) as [_ L2]. rewrite (Nat.add_comm m n) in L2.
    destruct (Inv (n + m)%nat) as [L3 _]. lra. }
  destruct (completeness (fun x => exists n, x = fst (I n))) as [c [C1 C2]].
  { exists b. intros x [n ->]. apply (Cross n O). }
  { exists a. exists O. auto. }
  assert (X : forall n, fst (I n) <= c) by (intros n; apply C1; exists n; auto).
  assert (Y : forall n, c <= snd (I n)) by (intros n; apply C2; intros x [m ->]; apply Cross).
  destruct (near_derivative c eps (conj (X O) (Y O)) He) as [d [Hd Near]].
  destruct (pow_lt_1_zero (/ 2) ltac:(rewrite Rabs_pos_eq; lra) (d / (b - a)) ltac:(apply Rdiv_lt_0_compat; lra)) as [n Hn].
  specialize (Hn n ltac:(lia)). rewrite Rabs_pos_eq in Hn by (apply pow_le; lra).
  destruct (Inv n) as [I1 [I2 I3]]. specialize (X n). specialize (Y n). set (x := fst (I n)) in *. set (y := snd (I n)) in *.
  assert (Sm : y - x < d).
  { rewrite I2. apply (Rmult_lt_compat_l (b - a)) in Hn; [|lra]. replace ((b - a) * (d / (b - a))) with d in Hn by (field; lra). lra. }
  assert (N1 := Near x ltac:(apply Rabs_def1; lra)). assert (N2 := Near y ltac:(apply Rabs_def1; lra)).
  rewrite (Rabs_pos_eq (y - c)) in N2 by lra. rewrite Rabs_minus_sym in N1. rewrite (Rabs_minus_sym x c), (Rabs_pos_eq (c - x)) in N1 by lra.
  replace (f y - f x) with ((f y - f c) + (f c - f x)) in I3 by lra. assert (T := Rabs_triang (f y - f c) (f c - f x)).
  replace ((B + eps) * (y - x)) with ((B + eps) * (y - c) + (B + eps) * (c - x)) in I3 by ring. lra.
Qed.
End MeanValue.

Lemma mean_value f f' B : (forall x, derivable_pt_lim f x (f' x)) -> (forall x, Rabs (f' x) <= B) ->
  forall a b, a <= b -> Rabs (f b - f a) <= B * (b - a).
Proof. intros D H a b. apply (mean_value_within f f'); auto. Qed.

(* ---- differences ------------------------------------------------------------------------------------------------- *)

Definition back (h : R) (f : R -> R) : R -> R := fun x => f x - f (x - h).
Fixpoint backs (m : nat) (h : R) (f : R -> R) : R -> R := match m with O => f | S k => back h (backs k h f) end.

Lemma back_derivative h f f' : (forall x, derivable_pt_lim f x (f' x)) -> forall x, derivable_pt_lim (back h f) x (back h f' x).
Proof.
  intros D x. unfold back. apply (derivable_pt_lim_minus f (fun x => f (x - h))). auto.
  intros eps He. destruct (D (x - h) eps He) as [delta Hd]. exists delta. intros k H0 Hk.
  replace (x + k - h) with (x - h + k) by lra. auto.
Qed.

Lemma backs_derivative m h f f' : (forall x, derivable_pt_lim f x (f' x)) -> forall x, derivable_pt_lim (backs m h f) x (backs m h f' x).
Proof. intros D. induction m; simpl; auto. apply back_derivative. auto. Qed.

Lemma backs_more m e h f B : (forall x, Rabs (backs m h f x) <= B) -> forall x, Rabs (backs (e + m) h f x) <= 2 ^ e * B.
Proof.
  intros H. induction e; intros x. simpl. rewrite Rmult_1_l. auto.
  simpl. unfold back at 1, Rminus. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. generalize (IHe x) (IHe (x + - h)). lra.
Qed.

Lemma holder_differences k : forall alpha f, holder k alpha f ->
  exists C, forall t x, Rabs (backs (S k) (exp t) f x) <= C * exp ((INR k + alpha) * t).
Proof.
  induction k; intros alpha f H.
  - destruct H as [C H]. exists C. intros t x. simpl. unfold back. specialize (H (x - exp t) t).
    replace (x - exp t + exp t) with x in H by lra. replace ((0 + alpha) * t) with (alpha * t) by ring. auto.
  - destruct H as [f' [D H]]. destruct (IHk alpha f' H) as [C HC]. exists C. intros t x.
    change (backs (S (S k)) (exp t) f x) with (backs (S k) (exp t) f x - backs (S k) (exp t) f (x - exp t)).
    eapply Rle_trans. apply (mean_value _ (backs (S k) (exp t) f') (C * exp ((INR k + alpha) * t))).
    + apply backs_derivative. auto.
    + apply HC.
    + generalize (exp_pos t). lra.
    + right. replace (x - (x - exp t)) with (exp t) by lra. rewrite Rmult_assoc, <- exp_plus, S_INR. f_equal. f_equal. ring.
Qed.

Definition vanishes (lo hi : R) (f : R -> R) : Prop := forall x, x < lo \/ hi < x -> f x = 0.

Lemma vanishing_derivative lo hi f f' : vanishes lo hi f -> (forall x, derivable_pt_lim f x (f' x)) -> vanishes lo hi f'.
Proof.
  intros V D x Hx. apply cond_eq. intros eps He. destruct (D x eps He) as [[d Hd] H]. simpl in H.
  set (h := if Rlt_dec x lo then - (d / 2) else d / 2).
  assert (P : h <> 0 /\ Rabs h < d /\ f (x + h) = 0).
  { unfold h. destruct (Rlt_dec x lo); (split; [lra|split]).
    - rewrite Rabs_Ropp, Rabs_pos_eq; lra.
    - apply V. lra.
    - rewrite Rabs_pos_eq; lra.
    - apply V. lra. }
  destruct P as [P1 [P2 P3]]. specialize (H h P1 P2). rewrite P3, (V x Hx) in H.
  replace ((0 - 0) / h - f' x) with (- (f' x - 0)) in H by (field; auto). rewrite Rabs_Ropp in H. auto.
Qed.

Lemma holder_bounded lo hi k : forall alpha f, 0 < alpha -> holder k alpha f -> vanishes lo hi f -> exists B, forall x, Rabs (f x) <= B.
Proof.
  assert (W : 0 < Rabs (hi - lo) + 1) by (generalize (Rabs_pos (hi - lo)); lra).
  induction k; intros alpha f Ha H V.
  - destruct H as [C H]. destruct (exp_onto _ W) as [T HT]. exists (Rmax 0 C * exp (alpha * T)). intros x.
    assert (P : 0 < exp (alpha * T)) by apply exp_pos. assert (P0 : 0 <= Rmax 0 C) by apply Rmax_l.
    assert (PP : 0 <= Rmax 0 C * exp (alpha * T)) by (apply Rmult_le_pos; lra).
    destruct (Rlt_le_dec x lo). rewrite V, Rabs_R0 by auto. auto. destruct (Rlt_le_dec hi x). rewrite V, Rabs_R0 by auto. auto.
    destruct (exp_onto (x - (lo - 1)) ltac:(lra)) as [t Ht]. specialize (H (lo - 1) t). rewrite Ht in H.
    replace (lo - 1 + (x - (lo - 1))) with x in H by lra. rewrite (V (lo - 1)), Rminus_0_r in H by lra.
    assert (t <= T). { apply exp_reflects. rewrite Ht, HT. rewrite Rabs_pos_eq; lra. }
    eapply Rle_trans. apply H. apply Rle_trans with (Rmax 0 C * exp (alpha * t)).
    apply Rmult_le_compat_r. left; apply exp_pos. apply Rmax_r. apply Rmult_le_compat_l; auto. apply exp_at_most. apply Rmult_le_compat_l; lra.
  - destruct H as [f' [D H]]. destruct (IHk alpha f' Ha H (vanishing_derivative lo hi f f' V D)) as [B HB].
    assert (B0 : 0 <= B) by (eapply Rle_trans; [apply Rabs_pos|apply (HB 0)]).
    exists (B * (Rabs (hi - lo) + 1)). intros x. assert (PP : 0 <= B * (Rabs (hi - lo) + 1)) by (apply Rmult_le_pos; lra).
    destruct (Rlt_le_dec x lo). rewrite V, Rabs_R0 by auto. auto. destruct (Rlt_le_dec hi x). rewrite V, Rabs_R0 by auto. auto.
    assert (M := mean_value f f' B D HB (lo - 1) x ltac:(lra)). rewrite (V (lo - 1)), Rminus_0_r in M by lra.
    eapply Rle_trans. apply M. apply Rmult_le_compat_l; auto. rewrite Rabs_pos_eq; lra.
Qed.

(* Differences of order m of a function with more than m derivatives *)
Lemma smooth_differences lo hi m : forall k alpha f, (m <= k)%nat -> 0 < alpha -> holder k alpha f -> vanishes lo hi f ->
  exists C, forall t x, Rabs (backs m (exp t) f x) <= C * exp (INR m * t).
Proof.
  induction m; intros k alpha f Hk Ha H V.
  - destruct (holder_bounded lo hi k alpha f Ha H V) as [B HB]. exists B. intros t x. simpl. rewrite Rmult_0_l, exp_0, Rmult_1_r. auto.
  - destruct k; [lia|]. destruct H as [f' [D H]].
    destruct (IHm k alpha f' ltac:(lia) Ha H (vanishing_derivative lo hi f f' V D)) as [C HC]. exists C. intros t x.
    change (backs (S m) (exp t) f x) with (backs m (exp t) f x - backs m (exp t) f (x - exp t)).
    eapply Rle_trans. apply (mean_value _ (backs m (exp t) f') (C * exp (INR m * t))).
    + apply backs_derivative. auto.
    + apply HC.
    + generalize (exp_pos t). lra.
    + right. replace (x - (x - exp t)) with (exp t) by lra. rewrite Rmult_assoc, <- exp_plus, S_INR. f_equal. f_equal. ring.
Qed.

(* Both cases: the differences of order m are at most a multiple of h^min(m, k + alpha). *)
Theorem differences_bounded lo hi m k alpha f : 0 < alpha -> holder k alpha f -> vanishes lo hi f ->
  exists C e, (e = INR m \/ e = INR k + alpha) /\ forall t x, Rabs (backs m (exp t) f x) <= C * exp (e * t).
Proof.
  intros Ha H V. destruct (le_lt_dec m k) as [L|L].
  - destruct (smooth_differences lo hi m k alpha f L Ha H V) as [C HC]. exists C, (INR m). auto.
  - destruct (holder_differences k alpha f H) as [C HC]. exists (2 ^ (m - S k) * C), (INR k + alpha). split; auto. intros t x.
    rewrite Rmult_assoc. replace m with ((m - S k) + S k)%nat at 1 by lia. apply backs_more. auto.
Qed.
