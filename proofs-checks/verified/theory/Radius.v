(* The joint spectral radius of finitely many real matrices, from first principles. *)
Require Import Reals List Lia Lra.
From Coq Require Import FunctionalExtensionality.
Import ListNotations.
Open Scope R_scope.

(* ---- definitions: what the theorems are about ------------------------------------------------------------------ *)

(* f 0 + ... + f (n - 1) *)
Fixpoint sum (n : nat) (f : nat -> R) : R :=
  match n with O => 0 | S k => sum k f + f k end.

(* Entries are numbered from 0; those of a matrix of size n beyond n - 1 play no part. *)
Definition vec := nat -> R.
Definition mat := nat -> nat -> R.
Definition identity : mat := fun i j => if Nat.eqb i j then 1 else 0.
Definition times (n : nat) (A B : mat) : mat := fun i j => sum n (fun k => A i k * B k j).

(* A family of matrices is a function from its letters 0, ..., count - 1. The product T_w1 T_w2 ... of a word: *)
Definition letters (count : nat) (w : list nat) : Prop := Forall (fun t => (t < count)%nat) w.
Fixpoint product (n : nat) (T : nat -> mat) (w : list nat) : mat :=
  match w with [] => identity | t :: w' => times n (T t) (product n T w') end.

(* All entries of products of k matrices are at most a constant times r^k. *)
Definition growth (n count : nat) (T : nat -> mat) (r : R) : Prop :=
  exists C, forall w, letters count w -> forall i j, (i < n)%nat -> (j < n)%nat ->
  Rabs (product n T w i j) <= C * r ^ length w.

(* The joint spectral radius is the infimum of these r. It is one number (radius_unique below), and exists for every
   family (radius_exists in Existence.v). *)
Definition is_radius (n count : nat) (T : nat -> mat) (x : R) : Prop :=
  0 <= x /\ (forall r, x < r -> growth n count T r) /\ (forall r, 0 <= r -> growth n count T r -> x <= r).

Definition radius_at_most n count T u := forall r, u < r -> 0 < r -> growth n count T r.
(* The same with products that grow like u^k themselves *)
Definition grows_at_most n count T u := forall r, u <= r -> 0 < r -> growth n count T r.
Definition radius_at_least n count T l := forall r, 0 <= r -> growth n count T r -> l <= r.

(* ---- sums ------------------------------------------------------------------------------------------------------ *)

Lemma sum_ext n f g : (forall i, (i < n)%nat -> f i = g i) -> sum n f = sum n g.
Proof. induction n; simpl; intros H; auto. rewrite IHn, H; auto. Qed.

Lemma sum_le n f g : (forall i, (i < n)%nat -> f i <= g i) -> sum n f <= sum n g.
Proof. induction n; simpl; intros H. lra. apply Rplus_le_compat; auto. Qed.

Lemma sum_plus n f g : sum n (fun i => f i + g i) = sum n f + sum n g.
Proof. induction n; simpl. lra. rewrite IHn. lra. Qed.

Lemma sum_scal n c f : sum n (fun i => c * f i) = c * sum n f.
Proof. induction n; simpl. lra. rewrite IHn. lra. Qed.

Lemma sum_zero n f : (forall i, (i < n)%nat -> f i = 0) -> sum n f = 0.
Proof. induction n; simpl; intros H; auto. rewrite IHn, H; auto. lra. Qed.

Lemma sum_nonneg n f : (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= sum n f.
Proof. intros H. rewrite <- (sum_zero n (fun _ => 0)) by auto. apply sum_le; auto. Qed.

Lemma sum_abs n f : Rabs (sum n f) <= sum n (fun i => Rabs (f i)).
Proof.
  induction n; simpl. rewrite Rabs_R0; lra.
  eapply Rle_trans. apply Rabs_triang. lra.
Qed.

Lemma sum_swap n m f : sum n (fun i => sum m (fun j => f i j)) = sum m (fun j => sum n (fun i => f i j)).
Proof.
  induction n; simpl. symmetry; apply sum_zero; auto.
  rewrite IHn, <- sum_plus. reflexivity.
Qed.

Lemma sum_add n m f : sum (n + m) f = sum n f + sum m (fun i => f (n + i)%nat).
Proof.
  induction m; simpl. rewrite Nat.add_0_r; lra.
  rewrite Nat.add_succ_r; simpl. rewrite IHm; lra.
Qed.

Lemma sum_term n f k : (forall i, (i < n)%nat -> 0 <= f i) -> (k < n)%nat -> f k <= sum n f.
Proof.
  induction n; simpl; intros H Hk. lia.
  assert (0 <= sum n f) by (apply sum_nonneg; auto).
  assert (0 <= f n) by auto.
  destruct (Nat.eq_dec k n). subst; lra.
  assert (f k <= sum n f) by (apply IHn; auto; lia). lra.
Qed.

Lemma sum_bound n f b : (forall i, (i < n)%nat -> f i <= b) -> sum n f <= INR n * b.
Proof.
  induction n; intros H. simpl; lra.
  rewrite S_INR. simpl. assert (f n <= b) by auto. assert (sum n f <= INR n * b) by auto. lra.
Qed.

Lemma sum_identity n k f : (k < n)%nat -> sum n (fun i => identity i k * f i) = f k.
Proof.
  unfold identity. induction n; simpl; intros H. lia.
  destruct (Nat.eqb_spec n k).
  - subst. rewrite sum_zero; [lra|]. intros i Hi. destruct (Nat.eqb_spec i k); [lia|lra].
  - rewrite IHn by lia. lra.
Qed.

Lemma identity_comm i j : identity i j = identity j i.
Proof. unfold identity. rewrite Nat.eqb_sym. reflexivity. Qed.

(* ---- matrices act on vectors ----------------------------------------------------------------------------------- *)

Definition unit (k : nat) : vec := fun i => identity i k.
Definition plus (x y : vec) : vec := fun i => x i + y i.
Definition scal (c : R) (x : vec) : vec := fun i => c * x i.
Definition zero : vec := fun _ => 0.
Definition apply (n : nat) (A : mat) (x : vec) : vec := fun i => sum n (fun j => A i j * x j).
Fixpoint run (n : nat) (T : nat -> mat) (w : list nat) (x : vec) : vec :=
  match w with [] => x | t :: w' => apply n (T t) (run n T w' x) end.
Definition norm (n : nat) (x : vec) : R := sum n (fun i => Rabs (x i)).

Lemma apply_plus n A x y : apply n A (plus x y) = plus (apply n A x) (apply n A y).
Proof.
  extensionality i. unfold apply, plus. rewrite <- sum_plus. apply sum_ext; intros; lra.
Qed.

Lemma apply_scal n A c x : apply n A (scal c x) = scal c (apply n A x).
Proof. extensionality i. unfold apply, scal. rewrite <- sum_scal. apply sum_ext; intros; lra. Qed.

Lemma apply_ext n A x y : (forall i, (i < n)%nat -> x i = y i) -> apply n A x = apply n A y.
Proof. intros H. extensionality i. unfold apply. apply sum_ext; intros. rewrite H; auto. Qed.

Lemma apply_zero n A : apply n A zero = zero.
Proof. extensionality i. apply sum_zero; intros; unfold zero; lra. Qed.

Lemma run_plus n T w x y : run n T w (plus x y) = plus (run n T w x) (run n T w y).
Proof. induction w; simpl; auto. rewrite IHw, apply_plus; auto. Qed.

Lemma run_scal n T w c x : run n T w (scal c x) = scal c (run n T w x).
Proof. induction w; simpl; auto. rewrite IHw, apply_scal; auto. Qed.

Lemma run_zero n T w : run n T w zero = zero.
Proof. induction w; simpl; auto. rewrite IHw, apply_zero; auto. Qed.

Lemma run_app n T w v x : run n T (w ++ v) x = run n T w (run n T v x).
Proof. induction w; simpl; auto. rewrite IHw; auto. Qed.

Lemma run_ext n T w x y : (forall i, (i < n)%nat -> x i = y i) ->
  forall i, (i < n)%nat -> run n T w x i = run n T w y i.
Proof. induction w; simpl; intros; auto. erewrite apply_ext; eauto. Qed.

Lemma run_product n T w x i : (i < n)%nat -> run n T w x i = sum n (fun j => product n T w i j * x j).
Proof.
  revert i; induction w; simpl; intros i Hi.
  - rewrite <- (sum_identity n i x) at 1; auto. apply sum_ext; intros. rewrite identity_comm; auto.
  - unfold apply, times.
    rewrite (sum_ext n _ (fun k => sum n (fun j => T a i k * (product n T w k j * x j)))).
    2:{ intros k Hk. rewrite IHw, <- sum_scal by auto. reflexivity. }
    rewrite sum_swap. apply sum_ext; intros j Hj.
    rewrite (Rmult_comm _ (x j)), <- sum_scal. apply sum_ext; intros; lra.
Qed.

Lemma run_unit n T w i k : (i < n)%nat -> (k < n)%nat -> run n T w (unit k) i = product n T w i k.
Proof.
  intros. rewrite run_product by auto. rewrite <- (sum_identity n k) by auto.
  apply sum_ext; intros. unfold unit. lra.
Qed.

Lemma norm_nonneg n x : 0 <= norm n x.
Proof. apply sum_nonneg; intros; apply Rabs_pos. Qed.

Lemma norm_plus n x y : norm n (plus x y) <= norm n x + norm n y.
Proof. unfold norm. rewrite <- sum_plus. apply sum_le; intros. apply Rabs_triang. Qed.

Lemma norm_scal n c x : norm n (scal c x) = Rabs c * norm n x.
Proof. unfold norm. rewrite <- sum_scal. apply sum_ext; intros. apply Rabs_mult. Qed.

Lemma norm_ext n x y : (forall i, (i < n)%nat -> x i = y i) -> norm n x = norm n y.
Proof. intros H. apply sum_ext; intros. rewrite H; auto. Qed.

Lemma norm_term n x i : (i < n)%nat -> Rabs (x i) <= norm n x.
Proof. intros. apply (sum_term n (fun i => Rabs (x i))); auto. intros; apply Rabs_pos. Qed.

Lemma norm_unit n k : (k < n)%nat -> norm n (unit k) = 1.
Proof.
  intros. unfold norm. rewrite <- (sum_identity n k (fun _ => 1)) by auto. apply sum_ext; intros.
  unfold unit, identity. destruct (Nat.eqb i k); [rewrite Rabs_R1 | rewrite Rabs_R0]; lra.
Qed.

Lemma norm_zero n : norm n zero = 0.
Proof. apply sum_zero; intros. apply Rabs_R0. Qed.

(* The units bound everything. *)
Lemma run_bound n T w x b : (forall k, (k < n)%nat -> norm n (run n T w (unit k)) <= b) ->
  norm n (run n T w x) <= b * norm n x.
Proof.
  intros H. unfold norm at 1.
  eapply Rle_trans with (sum n (fun i => sum n (fun j => Rabs (product n T w i j) * Rabs (x j)))).
  - apply sum_le; intros. rewrite run_product by auto. eapply Rle_trans. apply sum_abs.
    apply Req_le, sum_ext; intros. apply Rabs_mult.
  - rewrite sum_swap. unfold norm at 1. rewrite <- sum_scal. apply sum_le; intros j Hj.
    rewrite (sum_ext n _ (fun i => Rabs (x j) * Rabs (run n T w (unit j) i))).
    2:{ intros. rewrite run_unit by auto. lra. }
    rewrite sum_scal. rewrite Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos. apply H; auto.
Qed.

Lemma growth_norm n count T r C : 0 <= r ->
  (forall w, letters count w -> forall x, norm n (run n T w x) <= C * r ^ length w * norm n x) -> growth n count T r.
Proof.
  intros Hr H. exists C. intros w Hw i j Hi Hj. rewrite <- run_unit by auto.
  eapply Rle_trans. apply (norm_term n); auto.
  eapply Rle_trans. apply H; auto. rewrite norm_unit by auto. lra.
Qed.

Lemma norm_growth n count T r : 0 <= r -> growth n count T r ->
  exists C, 0 <= C /\ forall w, letters count w -> forall x, norm n (run n T w x) <= C * r ^ length w * norm n x.
Proof.
  intros Hr [C H]. exists (INR n * Rmax C 0).
  assert (HC : 0 <= Rmax C 0) by apply Rmax_r.
  split. apply Rmult_le_pos; auto. apply pos_INR.
  intros w Hw x. apply run_bound. intros k Hk.
  unfold norm. rewrite Rmult_assoc. apply sum_bound; intros i Hi.
  rewrite run_unit by auto. eapply Rle_trans. apply H; auto.
  apply Rmult_le_compat_r. apply pow_le; auto. apply Rmax_l.
Qed.

Lemma letters_app count w v : letters count (w ++ v) <-> letters count w /\ letters count v.
Proof. unfold letters. apply Forall_app. Qed.

(* Words of one length have bounded norms; so some r bounds the growth. *)
Lemma word_bound n count (T : nat -> mat) :
  exists K, 1 <= K /\ forall w, letters count w -> forall x, norm n (run n T w x) <= K ^ length w * norm n x.
Proof.
  assert (H1 : exists K, 1 <= K /\ forall t, (t < count)%nat -> forall x, norm n (apply n (T t) x) <= K * norm n x).
  { induction count. exists 1. split; [lra|]. intros; lia.
    destruct IHcount as [K [HK H]].
    set (b := sum n (fun k => norm n (apply n (T count) (unit k)))).
    exists (Rmax K b). split. eapply Rle_trans. apply HK. apply Rmax_l.
    intros t Ht x. destruct (Nat.eq_dec t count).
    - subst. apply (run_bound n T [count] x). intros k Hk. simpl.
      eapply Rle_trans; [|apply Rmax_r].
      apply (sum_term n (fun k => norm n (apply n (T count) (unit k)))); auto.
      intros; apply norm_nonneg.
    - eapply Rle_trans. apply H; lia. apply Rmult_le_compat_r. apply norm_nonneg. apply Rmax_l. }
  destruct H1 as [K [HK H]]. exists K. split; auto.
  induction w; intros Hw x; simpl. lra.
  inversion Hw; subst. eapply Rle_trans. apply H; auto.
  rewrite Rmult_assoc. apply Rmult_le_compat_l. lra. apply IHw; auto.
Qed.

(* ---- the radius is one number ---------------------------------------------------------------------------------- *)

Lemma growth_mono n count T r s : 0 <= r <= s -> growth n count T r -> growth n count T s.
Proof.
  intros Hrs G. destruct (norm_growth n count T r ltac:(lra) G) as [C [HC H]].
  apply (growth_norm n count T s C). lra. intros w Hw x. eapply Rle_trans. apply H; auto.
  apply Rmult_le_compat_r. apply norm_nonneg. apply Rmult_le_compat_l; auto. apply pow_incr; lra.
Qed.

Theorem radius_unique n count T x y : is_radius n count T x -> is_radius n count T y -> x = y.
Proof.
  assert (H : forall x y, is_radius n count T x -> is_radius n count T y -> x <= y).
  { intros a b [Ha [Ua La]] [Hb [Ub Lb]]. destruct (Rle_lt_dec a b) as [|L]; auto.
    assert (a <= (a + b) / 2); [|lra]. apply La. lra. apply Ub. lra. }
  intros. apply Rle_antisym; auto.
Qed.

Lemma grows_radius n count T u : grows_at_most n count T u -> radius_at_most n count T u.
Proof. intros H r Hr. apply H. lra. Qed.

Lemma at_most n count T u x : radius_at_most n count T u -> 0 <= u -> is_radius n count T x -> x <= u.
Proof.
  intros H Hu [Hx [_ L]]. destruct (Rle_lt_dec x u) as [|D]; auto.
  assert (x <= (x + u) / 2); [|lra]. apply L. lra. apply H; lra.
Qed.

Lemma at_least n count T l x : radius_at_least n count T l -> is_radius n count T x -> l <= x.
Proof.
  intros H [Hx [U _]]. destruct (Rle_lt_dec l x) as [|D]; auto.
  assert (l <= (x + l) / 2); [|lra]. apply H. lra. apply U. lra.
Qed.
