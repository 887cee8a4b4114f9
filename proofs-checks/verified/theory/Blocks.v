(* Families with one radius: transposes, other bases; and block triangular families. *)
Require Import Reals List Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper.
Import ListNotations.
Open Scope R_scope.

Lemma product_app n T w v i j : (i < n)%nat -> (j < n)%nat ->
  product n T (w ++ v) i j = sum n (fun k => product n T w i k * product n T v k j).
Proof.
  intros Hi Hj. rewrite <- run_unit, run_app, run_product by auto.
  apply sum_ext; intros k Hk. rewrite run_unit; auto.
Qed.

Lemma product_letter n T t i j : (i < n)%nat -> (j < n)%nat -> product n T [t] i j = T t i j.
Proof.
  intros Hi Hj. simpl. unfold times. rewrite <- (sum_identity n j (T t i)) by auto. apply sum_ext; intros; lra.
Qed.

Definition transposed (T : nat -> mat) : nat -> mat := fun t i j => T t j i.

Lemma product_transposed n T w : forall i j, (i < n)%nat -> (j < n)%nat ->
  product n (transposed T) (rev w) j i = product n T w i j.
Proof.
  induction w; intros i j Hi Hj. simpl. apply identity_comm.
  simpl rev. rewrite product_app by auto.
  change (product n T (a :: w) i j) with (sum n (fun k => T a i k * product n T w k j)).
  apply sum_ext; intros k Hk. rewrite product_letter, IHw by auto. unfold transposed. lra.
Qed.

Lemma letters_rev count w : letters count w -> letters count (rev w).
Proof. unfold letters. rewrite !Forall_forall. intros H x Hx. apply H. apply in_rev; auto. Qed.

Lemma growth_transposed n count T r : growth n count (transposed T) r -> growth n count T r.
Proof.
  intros [C H]. exists C. intros w Hw i j Hi Hj. rewrite <- product_transposed, <- (rev_length w) by auto.
  apply H; auto. apply letters_rev; auto.
Qed.

Theorem transposed_at_most n count T u : radius_at_most n count (transposed T) u -> radius_at_most n count T u.
Proof. intros H r Hr H0. apply growth_transposed, H; auto. Qed.

(* ---- another basis --------------------------------------------------------------------------------------------- *)

Lemma apply_bound n m (B : mat) : exists K, 0 <= K /\ forall x, norm n (apply m B x) <= K * norm m x.
Proof.
  exists (sum m (fun j => sum n (fun i => Rabs (B i j)))). split.
  - apply sum_nonneg; intros. apply sum_nonneg; intros. apply Rabs_pos.
  - intros x. unfold norm at 2. rewrite <- sum_scal. unfold norm, apply.
    eapply Rle_trans. apply sum_le; intros. apply sum_abs.
    rewrite sum_swap. apply sum_le; intros j Hj.
    rewrite (sum_ext n _ (fun i => Rabs (x j) * Rabs (B i j))) by (intros; rewrite Rabs_mult; ring).
    rewrite sum_scal, Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos.
    apply (sum_term m (fun j => sum n (fun i => Rabs (B i j)))); auto.
    intros; apply sum_nonneg; intros; apply Rabs_pos.
Qed.

Section Basis.
Variables (n count : nat) (T T' : nat -> mat) (B C : mat).
Hypothesis H1 : forall t, (t < count)%nat -> forall y i, (i < n)%nat ->
  apply n (T t) (apply n B y) i = apply n B (apply n (T' t) y) i.
Hypothesis H2 : forall x i, (i < n)%nat -> apply n B (apply n C x) i = x i.

Lemma run_basis w x : letters count w ->
  forall i, (i < n)%nat -> run n T w x i = apply n B (run n T' w (apply n C x)) i.
Proof.
  induction w; intros Hw i Hi; simpl. symmetry; apply H2; auto.
  inversion Hw; subst. rewrite <- H1 by auto.
  rewrite (apply_ext n (T a) (run n T w x) (apply n B (run n T' w (apply n C x)))); auto.
Qed.

Lemma growth_basis r : 0 <= r -> growth n count T' r -> growth n count T r.
Proof.
  intros Hr G. destruct (norm_growth n count T' r Hr G) as [K [HK H]].
  destruct (apply_bound n n B) as [b [Hb HB]]. destruct (apply_bound n n C) as [c [Hc HC]].
  apply (growth_norm n count T r (b * (K * c))); auto. intros w Hw x.
  rewrite (norm_ext n _ (apply n B (run n T' w (apply n C x)))) by (apply run_basis; auto).
  eapply Rle_trans. apply HB.
  replace (b * (K * c) * r ^ length w * norm n x) with (b * (K * r ^ length w * (c * norm n x))) by ring.
  apply Rmult_le_compat_l; auto. eapply Rle_trans. apply H; auto.
  apply Rmult_le_compat_l. apply Rmult_le_pos; auto. apply pow_le; auto. auto.
Qed.
End Basis.

(* ---- block triangular families --------------------------------------------------------------------------------- *)

Section Blocks.
Variables (d m count : nat) (T : nat -> mat).
Hypothesis Triangular : forall t, (t < count)%nat -> forall i j, (i < m)%nat -> (j < d)%nat -> T t (d + i)%nat j = 0.

Definition rest (T : nat -> mat) : nat -> mat := fun t i j => T t (d + i)%nat (d + j)%nat.
Definition n := (d + m)%nat.

Lemma product_below w : letters count w -> forall i j, (i < m)%nat -> (j < d)%nat -> product n T w (d + i)%nat j = 0.
Proof.
  induction w; intros Hw i j Hi Hj; simpl.
  - unfold identity. destruct (Nat.eqb_spec (d + i) j); [lia|auto].
  - inversion Hw; subst. unfold times, n. rewrite sum_add, !sum_zero; [lra| |].
    + intros k Hk. fold n. rewrite IHw by auto. lra.
    + intros k Hk. rewrite Triangular by auto. lra.
Qed.

Lemma product_first w : letters count w -> forall i j, (i < d)%nat -> (j < d)%nat -> product n T w i j = product d T w i j.
Proof.
  induction w; intros Hw i j Hi Hj; simpl. auto.
  inversion Hw; subst. unfold times. unfold n at 1. rewrite sum_add. fold n.
  rewrite (sum_zero m), Rplus_0_r.
  - apply sum_ext; intros k Hk. rewrite IHw; auto.
  - intros k Hk. rewrite product_below by auto. lra.
Qed.

Lemma product_rest w : letters count w -> forall i j, (i < m)%nat -> (j < m)%nat ->
  product n T w (d + i)%nat (d + j)%nat = product m (rest T) w i j.
Proof.
  induction w; intros Hw i j Hi Hj; simpl.
  - unfold identity. destruct (Nat.eqb_spec (d + i) (d + j)), (Nat.eqb_spec i j); auto; lia.
  - inversion Hw; subst. unfold times. unfold n at 1. rewrite sum_add. fold n.
    rewrite sum_zero, Rplus_0_l.
    + apply sum_ext; intros k Hk. rewrite IHw; auto.
    + intros k Hk. rewrite Triangular by auto. lra.
Qed.

Theorem first_at_least l : radius_at_least d count T l -> radius_at_least n count T l.
Proof.
  intros H r Hr [C G]. apply H; auto. exists C. intros w Hw i j Hi Hj.
  rewrite <- product_first by auto. apply G; auto; unfold n; lia.
Qed.

Theorem rest_at_least l : radius_at_least m count (rest T) l -> radius_at_least n count T l.
Proof.
  intros H r Hr [C G]. apply H; auto. exists C. intros w Hw i j Hi Hj.
  rewrite <- product_rest by auto. apply G; auto; unfold n; lia.
Qed.

(* Column d + j of a product, above the block. *)
Definition above (w : list nat) (j : nat) : vec := fun i => product n T w i (d + j)%nat.

Lemma above_step t w j : letters count (t :: w) -> (j < m)%nat ->
  above (t :: w) j = plus (apply d (T t) (above w j))
    (apply m (fun i k => T t i (d + k)%nat) (run m (rest T) w (unit j))).
Proof.
  intros Hw Hj. extensionality i. inversion Hw; subst. unfold above, plus, apply. simpl. unfold times. unfold n at 1.
  rewrite sum_add. fold n. f_equal. apply sum_ext; intros k Hk.
  rewrite product_rest, run_unit by auto. auto.
Qed.

Lemma growth_blocks s r : 0 < s < r -> growth d count T s -> growth m count (rest T) s -> growth n count T r.
Proof.
  intros Hsr GA GD.
  destruct (norm_growth d count T s ltac:(lra) GA) as [CA [HCA HA]].
  destruct (norm_growth m count (rest T) s ltac:(lra) GD) as [CD [HCD HD]].
  assert (HX : exists X, 0 <= X /\ forall t, (t < count)%nat -> forall z,
    norm d (apply m (fun i k => T t i (d + k)%nat) z) <= X * norm m z).
  { clear. induction count as [|c IH]. exists 0. split; [lra|]. intros; lia.
    destruct IH as [X [HX H]]. destruct (apply_bound d m (fun i k => T c i (d + k)%nat)) as [Y [HY H']].
    exists (Rmax X Y). split. eapply Rle_trans; [apply HX|apply Rmax_l].
    intros t Ht z. assert (P := norm_nonneg m z). destruct (Nat.eq_dec t c).
    - subst. eapply Rle_trans. apply H'. apply Rmult_le_compat_r; auto. apply Rmax_r.
    - eapply Rle_trans. apply H; lia. apply Rmult_le_compat_r; auto. apply Rmax_l. }
  destruct HX as [X [HX0 HX]].
  set (K := CA * (X * CD) / s).
  assert (HK : 0 <= K).
  { unfold K. apply Rmult_le_pos. repeat (apply Rmult_le_pos; auto). left. apply Rinv_0_lt_compat; lra. }
  assert (Above : forall w, letters count w -> forall j, (j < m)%nat -> forall u, letters count u ->
    norm d (run d T u (above w j)) <= INR (length w) * K * s ^ (length u + length w)).
  { induction w; intros Hw j Hj u Hu.
    - rewrite (norm_ext d _ zero). rewrite norm_zero. simpl. lra.
      intros i Hi. rewrite <- (run_zero d T u). apply run_ext; auto.
      intros k Hk. unfold above, zero. simpl. unfold identity. destruct (Nat.eqb_spec k (d + j)); [lia|auto].
    - inversion Hw; subst. rewrite above_step, run_plus by auto.
      eapply Rle_trans. apply norm_plus.
      change (run d T u (apply d (T a) (above w j))) with (run d T u (run d T [a] (above w j))).
      rewrite <- run_app.
      assert (Hua : letters count (u ++ [a])) by (apply letters_app; split; auto; constructor; auto; constructor).
      assert (E1 := IHw H2 j Hj (u ++ [a]) Hua).
      rewrite app_length in E1. simpl length in E1.
      assert (E2 : norm d (run d T u (apply m (fun i k => T a i (d + k)%nat) (run m (rest T) w (unit j))))
                   <= CA * s ^ length u * (X * (CD * s ^ length w))).
      { eapply Rle_trans. apply HA; auto. apply Rmult_le_compat_l.
        apply Rmult_le_pos; auto. apply pow_le; lra.
        eapply Rle_trans. apply HX; auto. apply Rmult_le_compat_l; auto.
        eapply Rle_trans. apply HD; auto. rewrite norm_unit by auto. lra. }
      replace (length u + length (a :: w))%nat with (length u + 1 + length w)%nat by (simpl; lia).
      simpl length. rewrite S_INR.
      assert (E3 : CA * s ^ length u * (X * (CD * s ^ length w)) = K * s ^ (length u + 1 + length w)).
      { unfold K. rewrite !pow_add. simpl. field. lra. }
      rewrite E3 in E2. lra. }
  destruct (linear_power s r Hsr) as [L [HL HLk]].
  destruct GA as [C1 G1]. destruct GD as [C2 G2].
  assert (Q : forall k, 0 < s ^ k <= r ^ k). { intros; split. apply pow_lt; lra. apply pow_incr; lra. }
  set (M := Rmax (Rmax C1 C2) (Rmax 0 (K * L))).
  assert (M1 : C1 <= M). { eapply Rle_trans. apply Rmax_l. apply Rmax_l. }
  assert (M2 : C2 <= M). { eapply Rle_trans. apply Rmax_r. apply Rmax_l. }
  assert (M3 : 0 <= M). { eapply Rle_trans. apply Rmax_l. apply Rmax_r. }
  assert (M4 : K * L <= M). { eapply Rle_trans. apply (Rmax_r 0). apply Rmax_r. }
  exists M. intros w Hw i j Hi Hj. specialize (Q (length w)). unfold n in Hi, Hj.
  assert (Diagonal : forall C x, C <= M -> x <= C * s ^ length w -> x <= M * r ^ length w).
  { intros C x HC Hx. eapply Rle_trans. apply Hx. apply Rle_trans with (M * s ^ length w).
    apply Rmult_le_compat_r; lra. apply Rmult_le_compat_l; lra. }
  destruct (lt_dec i d) as [Li|Li], (lt_dec j d) as [Lj|Lj].
  - apply (Diagonal C1); auto. rewrite product_first by auto. apply G1; auto.
  - replace j with (d + (j - d))%nat by lia.
    assert (E := Above w Hw (j - d)%nat ltac:(lia) [] ltac:(constructor)). simpl in E.
    assert (N := norm_term d (above w (j - d)) i Li). unfold above in N at 1.
    eapply Rle_trans. apply N. eapply Rle_trans. apply E.
    apply Rle_trans with (K * (L * r ^ length w)).
    + replace (INR (length w) * K * s ^ length w) with (K * (INR (length w) * s ^ length w)) by ring.
      apply Rmult_le_compat_l; auto.
    + rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra.
  - replace i with (d + (i - d))%nat by lia. rewrite product_below by (auto; lia). rewrite Rabs_R0.
    apply Rmult_le_pos; lra.
  - replace i with (d + (i - d))%nat by lia. replace j with (d + (j - d))%nat by lia.
    apply (Diagonal C2); auto. rewrite product_rest by (auto; lia). apply G2; auto; lia.
Qed.

Theorem blocks_at_most u : radius_at_most d count T u -> radius_at_most m count (rest T) u -> radius_at_most n count T u.
Proof.
  intros HA HD r Hr H0. set (s := (Rmax u 0 + r) / 2).
  assert (Rmax u 0 < r) by (apply Rmax_lub_lt; auto). assert (u <= Rmax u 0) by apply Rmax_l.
  assert (0 <= Rmax u 0) by apply Rmax_r.
  apply (growth_blocks s r); unfold s. lra. apply HA; lra. apply HD; lra.
Qed.
End Blocks.
