(* Vectors and matrices of integers as lists, and the real ones that they stand for. *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius.
Import ListNotations.
Open Scope Z_scope.

(* A list stands for its numbers and zeros after them: the empty one is 0. *)
Definition zvec := list Z.
Definition zmat := list zvec.   (* rows *)

Fixpoint dot (x y : zvec) : Z :=
  match x, y with a :: x', b :: y' => a * b + dot x' y' | _, _ => 0 end.
(* c x + y *)
Fixpoint addmul (c : Z) (x y : zvec) : zvec :=
  match x with
  | [] => y
  | a :: x' => match y with [] => c * a :: addmul c x' [] | b :: y' => c * a + b :: addmul c x' y' end
  end.
Definition mv (M : zmat) (x : zvec) : zvec :=
  match x with [] => [] | _ => map (fun row => dot row x) M end.
Definition norm1 (x : zvec) : Z := fold_right (fun a s => Z.abs a + s) 0 x.
Definition positive_part (x : zvec) : zvec := map (Z.max 0) x.
Definition unit_at (a : Z) (k : nat) : zvec := repeat 0 k ++ [a].
Definition entry (M : zmat) (i j : nat) : Z := nth j (nth i M []) 0.
Definition table (n : nat) (f : nat -> nat -> Z) : zmat := map (fun i => map (f i) (seq 0 n)) (seq 0 n).
(* rows times columns *)
Definition products (rows columns : zmat) : zmat := map (fun r => map (dot r) columns) rows.
Fixpoint zrun (Ms : list zmat) (w : list nat) (x : zvec) : zvec :=
  match w with [] => x | t :: w' => mv (nth t Ms []) (zrun Ms w' x) end.

Definition square (n : nat) (M : zmat) : bool :=
  Nat.eqb (length M) n && forallb (fun row => Nat.eqb (length row) n) M.

Fixpoint same (x y : zvec) : bool :=
  match x, y with [], [] => true | a :: x', b :: y' => (a =? b) && same x' y' | _, _ => false end.

Definition vr (x : zvec) : vec := fun i => IZR (nth i x 0).
Definition mr (M : zmat) : mat := fun i j => IZR (entry M i j).

Lemma nth_nil {A} i (d : A) : nth i [] d = d.
Proof. destruct i; auto. Qed.

Lemma same_spec x : forall y, same x y = true -> x = y.
Proof.
  induction x; intros [|b y] H; simpl in H; try discriminate; auto. apply andb_prop in H. destruct H as [H1 H2].
  apply Z.eqb_eq in H1. f_equal; auto.
Qed.

Lemma dot_nil x : dot x [] = 0.
Proof. destruct x; auto. Qed.

Lemma vr_nil : vr [] = zero.
Proof. extensionality i. unfold vr. rewrite nth_nil. reflexivity. Qed.

Lemma vr_addmul c x y : vr (addmul c x y) = plus (scal (IZR c) (vr x)) (vr y).
Proof.
  extensionality i. unfold vr, plus, scal. rewrite <- mult_IZR, <- plus_IZR. f_equal.
  revert y i. induction x; intros y i; simpl. destruct i; simpl; lia.
  destruct y; destruct i; simpl; try lia; rewrite IHx; rewrite ?nth_nil; lia.
Qed.

Lemma dot_sum n : forall x y, (length x <= n)%nat ->
  IZR (dot x y) = sum n (fun i => (IZR (nth i x 0%Z) * IZR (nth i y 0%Z))%R).
Proof.
  intros x. revert n. induction x; intros n y H.
  - change (dot [] y) with 0. rewrite sum_zero; auto. intros. rewrite nth_nil. lra.
  - destruct n; [simpl in H; lia|]. change (S n) with (1 + n)%nat. rewrite sum_add.
    destruct y.
    + rewrite dot_nil, !sum_zero; [lra| |]; intros; rewrite nth_nil; lra.
    + simpl dot. rewrite plus_IZR, mult_IZR, (IHx n) by (simpl in H; lia). simpl. lra.
Qed.

Lemma nth_map_nil {A} (f : zvec -> A) M i d : f [] = d -> nth i (map f M) d = f (nth i M []).
Proof. intros <-. apply map_nth. Qed.

Lemma square_spec n M : square n M = true <-> length M = n /\ forall row, In row M -> length row = n.
Proof.
  unfold square. rewrite Bool.andb_true_iff, Nat.eqb_eq, forallb_forall. split; intros [H1 H2]; split; auto; intros row I;
  specialize (H2 row I); [apply Nat.eqb_eq in H2 | apply Nat.eqb_eq]; auto.
Qed.

Lemma row_length n M i : square n M = true -> (length (nth i M []) <= n)%nat.
Proof.
  unfold square. rewrite Bool.andb_true_iff. intros [H1 H2]. rewrite forallb_forall in H2.
  destruct (nth_in_or_default i M []) as [H | ->]; [|simpl; lia].
  apply H2 in H. apply Nat.eqb_eq in H. lia.
Qed.

Lemma vr_mv n M x : square n M = true -> vr (mv M x) = apply n (mr M) (vr x).
Proof.
  intros H. extensionality i. unfold vr, apply, mr, entry.
  rewrite <- dot_sum by (apply row_length; auto). f_equal.
  destruct x. rewrite dot_nil. apply nth_nil.
  unfold mv. rewrite nth_map_nil; auto.
Qed.

Lemma norm_norm1 n x : (norm n (vr x) <= IZR (norm1 x))%R.
Proof.
  revert n. induction x; intros n.
  - simpl. rewrite vr_nil, norm_zero. lra.
  - destruct n. unfold norm; simpl. apply IZR_le.
    assert (0 <= norm1 x) by (clear; induction x; simpl; lia). lia.
    unfold norm. change (S n) with (1 + n)%nat. rewrite sum_add.
    simpl norm1. rewrite plus_IZR, abs_IZR. apply Rplus_le_compat. unfold vr; simpl; lra. apply (IHx n).
Qed.

Lemma norm1_sum x n : (length x <= n)%nat -> IZR (norm1 x) = norm n (vr x).
Proof.
  revert n. induction x; intros n H.
  - simpl. rewrite vr_nil, norm_zero. auto.
  - destruct n; [simpl in H; lia|]. unfold norm. change (S n) with (1 + n)%nat. rewrite sum_add.
    simpl norm1. rewrite plus_IZR, abs_IZR. rewrite (IHx n) by (simpl in H; lia).
    unfold norm, vr. cbn [sum Nat.add nth]. lra.
Qed.

Lemma vr_unit a k : vr (unit_at a k) = scal (IZR a) (unit k).
Proof.
  extensionality i. unfold vr, scal, unit, identity, unit_at.
  destruct (Nat.eqb_spec i k).
  - subst. rewrite app_nth2; rewrite repeat_length; auto. rewrite Nat.sub_diag. simpl. lra.
  - destruct (lt_dec i k).
    + rewrite app_nth1 by (rewrite repeat_length; auto). rewrite nth_repeat. simpl; lra.
    + rewrite app_nth2; rewrite repeat_length; [|lia]. rewrite (nth_overflow [a]) by (simpl; lia). lra.
Qed.

Lemma nth_map_seq {A} (f : nat -> A) n i d : (i < n)%nat -> nth i (map f (seq 0 n)) d = f i.
Proof.
  intros H. rewrite nth_indep with (d' := f 0%nat) by (rewrite map_length, seq_length; auto).
  rewrite map_nth, seq_nth; auto.
Qed.

Lemma entry_table n f i j : (i < n)%nat -> (j < n)%nat -> entry (table n f) i j = f i j.
Proof. intros. unfold entry, table. rewrite (nth_map_seq _ n i), nth_map_seq; auto. Qed.

Lemma square_table n f : square n (table n f) = true.
Proof.
  unfold square, table. rewrite map_length, seq_length, Nat.eqb_refl. simpl. apply forallb_forall.
  intros x Hx. apply in_map_iff in Hx. destruct Hx as [i [<- _]]. rewrite map_length, seq_length. apply Nat.eqb_refl.
Qed.

Lemma entry_products n A B i j : square n A = true ->
  IZR (entry (products A B) i j) = sum n (fun k => (IZR (entry A i k) * IZR (nth k (nth j B []) 0%Z))%R).
Proof.
  intros H. unfold entry. rewrite <- dot_sum by (apply row_length; auto). f_equal.
  assert (E : nth i (products A B) [] = map (dot (nth i A [])) B \/ nth i A [] = [] /\ nth i (products A B) [] = []).
  { unfold products. destruct (lt_dec i (length A)).
    - left. rewrite nth_indep with (d' := map (dot []) B) by (rewrite map_length; auto).
      rewrite (map_nth (fun r => map (dot r) B)). auto.
    - right. split; apply nth_overflow; rewrite ?map_length; lia. }
  destruct E as [E | [E1 E2]].
  - rewrite E. rewrite nth_map_nil; auto. apply dot_nil.
  - rewrite E1, E2. rewrite nth_nil. auto.
Qed.

(* ---- families -------------------------------------------------------------------------------------------------- *)

(* The matrices over one denominator. *)
Record family := Family { size : nat; denominator : Z; matrices : list zmat }.
Definition count (F : family) : nat := length (matrices F).
Definition letter (F : family) (t : nat) : zmat := nth t (matrices F) [].
Definition real (F : family) : nat -> mat := fun t i j => (mr (letter F t) i j / IZR (denominator F))%R.

Definition well_formed (F : family) : bool :=
  (0 <? denominator F) && forallb (square (size F)) (matrices F).

Section Family.
Variable F : family.
Hypothesis WF : well_formed F = true.

Lemma denominator_positive : (0 < IZR (denominator F))%R.
Proof. unfold well_formed in WF. apply Bool.andb_true_iff in WF. destruct WF as [H _]. apply IZR_lt. lia. Qed.

Lemma letter_square t : (t < count F)%nat -> square (size F) (letter F t) = true.
Proof.
  intros H. unfold well_formed in WF. apply Bool.andb_true_iff in WF. destruct WF as [_ H'].
  rewrite forallb_forall in H'. apply H'. apply nth_In. auto.
Qed.

Lemma vr_letter t x : (t < count F)%nat ->
  vr (mv (letter F t) x) = scal (IZR (denominator F)) (apply (size F) (real F t) (vr x)).
Proof.
  intros H. rewrite (vr_mv (size F)) by (apply letter_square; auto). extensionality i.
  assert (D := denominator_positive).
  unfold apply, scal, real. rewrite <- sum_scal. apply sum_ext; intros. field. lra.
Qed.

Lemma vr_zrun w x : letters (count F) w ->
  vr (zrun (matrices F) w x) = scal (IZR (denominator F) ^ length w) (run (size F) (real F) w (vr x)).
Proof.
  induction w; intros Hw; simpl.
  - extensionality i. unfold scal. lra.
  - inversion Hw; subst. fold (letter F a). rewrite vr_letter, IHw, apply_scal by auto.
    extensionality i. unfold scal. ring.
Qed.
End Family.
