(* Every family has a joint spectral radius. *)
Require Import Reals List Lia Lra.
From Coq Require Import ClassicalDedekindReals.
From Subcert Require Import Radius Upper.
Import ListNotations.
Open Scope R_scope.

(* Products of one length bound the radius. *)
Lemma level_bound n count T g level : (0 < level)%nat -> 0 <= g ->
  (forall w, letters count w -> length w = level -> forall k, (k < n)%nat -> norm n (run n T w (unit k)) <= g ^ level) ->
  grows_at_most n count T g.
Proof.
  intros Hl Hg H. apply (cuts_bound n count 1 T (fun _ => norm n) g 1 1); auto; try lra; try (intros; lra).
  - intros i x _. split; [apply norm_nonneg | lra].
  - intros i _. exists level. intros v Hv Hlv. exists (firstn level v), (skipn level v).
    assert (E : length (firstn level v) = level) by (apply firstn_length_le; auto).
    rewrite <- (firstn_skipn level v) in Hv. apply letters_app in Hv.
    split. symmetry; apply firstn_skipn. split. lia. split. simpl. intros Z. rewrite Z in E. simpl in E. lia.
    exists 0%nat. split. lia. intros x. simpl app. rewrite E. apply run_bound. apply H; [apply Hv | auto].
Qed.

Section Existence.
Variables (n count : nat) (T : nat -> mat).

Fixpoint maximum (m : nat) (f : nat -> R) : R := match m with O => 0 | S k => Rmax (f k) (maximum k f) end.

Lemma maximum_bound m f k : (k < m)%nat -> f k <= maximum m f.
Proof.
  induction m; simpl; intros H. lia. destruct (Nat.eq_dec k m). subst; apply Rmax_l.
  eapply Rle_trans. apply IHm; lia. apply Rmax_r.
Qed.

Lemma maximum_least m f b : 0 <= b -> (forall k, (k < m)%nat -> f k <= b) -> maximum m f <= b.
Proof. induction m; simpl; intros Hb H; auto. apply Rmax_lub; auto. Qed.

(* The largest norm of P x over all products of k matrices, and of that over the units. *)
Fixpoint grown (k : nat) (x : vec) : R :=
  match k with O => norm n x | S j => maximum count (fun t => grown j (apply n (T t) x)) end.
Definition level (k : nat) : R := maximum n (fun j => grown k (unit j)).

Lemma grown_bound k : forall w x, length w = k -> letters count w -> norm n (run n T w x) <= grown k x.
Proof.
  induction k; intros w x Hl Hw. destruct w; [|discriminate]. simpl; lra.
  destruct (exists_last (l := w)) as [v [t ->]]. { intros ->; discriminate. }
  apply letters_app in Hw. destruct Hw as [Hv Ht]. inversion Ht; subst. rewrite app_length in Hl. simpl in Hl.
  rewrite run_app. eapply Rle_trans. apply IHk; auto. lia.
  simpl. apply (maximum_bound count (fun t => grown k (apply n (T t) x))); auto.
Qed.

Lemma grown_least k : forall x b, 0 <= b -> (forall w, length w = k -> letters count w -> norm n (run n T w x) <= b) -> grown k x <= b.
Proof.
  induction k; intros x b Hb H; simpl.
  - apply (H []); auto. constructor.
  - apply maximum_least; auto. intros t Ht. apply IHk; auto. intros w Hl Hw.
    assert (D := H (w ++ [t])). rewrite run_app in D. apply D.
    rewrite app_length; simpl; lia. apply letters_app; split; auto. constructor; auto; constructor.
Qed.

Lemma level_at_most g k : (0 < k)%nat -> 0 <= g -> level k <= g ^ k -> radius_at_most n count T g.
Proof.
  intros Hk Hg H. apply grows_radius, (level_bound n count T g k); auto. intros w Hw Hl j Hj.
  eapply Rle_trans. apply (grown_bound k); auto. eapply Rle_trans; [|apply H].
  apply (maximum_bound n (fun j => grown k (unit j))); auto.
Qed.

(* Decidable as comparisons of real numbers are. *)
Lemma some_level (f g : nat -> R) : {k | f k < g k} + {forall k, g k <= f k}.
Proof.
  destruct (sig_forall_dec (fun k => g k <= f k)) as [[k H]|H].
  - intros k. apply Rle_dec.
  - left. exists k. lra.
  - right. auto.
Qed.

Theorem radius_exists : exists x, is_radius n count T x.
Proof.
  set (A := fun s => 0 <= s /\ exists k, level (S k) < s ^ S k).
  destruct (word_bound n count T) as [K [HK H]].
  assert (AK : A (K + 1)).
  { split. lra. exists 0%nat. apply Rle_lt_trans with K; [|simpl; lra]. apply maximum_least. lra.
    intros j Hj. apply grown_least. lra. intros w Hl Hw. eapply Rle_trans. apply H; auto. rewrite Hl, norm_unit by auto. simpl; lra. }
  destruct (completeness (fun y => exists s, y = - s /\ A s)) as [y [Hub Hlub]].
  - exists 0. intros y [s [-> [Hs _]]]. lra.
  - exists (- (K + 1)), (K + 1). auto.
  - exists (- y). assert (Hy : y <= 0). { apply Hlub. intros z [s [-> [Hs _]]]. lra. }
    split. lra. split.
    + intros r Hr. set (g := (r - y) / 2).
      destruct (some_level (fun k => level (S k)) (fun k => g ^ S k)) as [[k Hk]|N].
      * apply (level_at_most g (S k)); unfold g in *; try lra; try lia.
      * exfalso. assert (y <= - g); [|unfold g in *; lra]. apply Hlub. intros z [s [-> [Hs [k Hk]]]].
        specialize (N k). destruct (Rle_lt_dec s g) as [L|L]; [|lra]. exfalso.
        assert (s ^ S k <= g ^ S k) by (apply pow_incr; lra). lra.
    + intros r Hr G. destruct (norm_growth n count T r Hr G) as [C [HC HG]].
      apply le_epsilon. intros eps He.
      destruct (some_level (fun k => (C + 1) * r ^ S k) (fun k => (r + eps) ^ S k)) as [[k Hk]|N].
      * assert (A (r + eps)); [|assert (- (r + eps) <= y); [apply Hub; exists (r + eps); auto | lra]].
        split. lra. exists k. eapply Rle_lt_trans; [|apply Hk]. assert (P : 0 <= r ^ S k) by (apply pow_le; auto).
        apply maximum_least. apply Rmult_le_pos; lra. intros j Hj. apply grown_least. apply Rmult_le_pos; lra.
        intros w Hl Hw. eapply Rle_trans. apply HG; auto. rewrite Hl, norm_unit, Rmult_1_r by auto.
        apply Rmult_le_compat_r; lra.
      * exfalso. assert (r + eps <= r); [|lra]. apply (power_bound (C + 1)); try lra.
        intros m. destruct m. simpl; lra. apply N.
Qed.
End Existence.
