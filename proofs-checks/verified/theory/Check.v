(* The checker: claims about the joint spectral radius, certificates, and the theorem that what is accepted is true. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Existence Blocks Integers Sections Eigenvalue Quadratic Graph Single.
Import ListNotations.
Open Scope Z_scope.

(* ---- families that differ in nothing that matters -------------------------------------------------------------- *)

Lemma product_ext n count T T' : (forall t i j, (t < count)%nat -> (i < n)%nat -> (j < n)%nat -> T t i j = T' t i j) ->
  forall w, letters count w -> forall i j, (i < n)%nat -> (j < n)%nat -> product n T w i j = product n T' w i j.
Proof.
  intros H. induction w; intros Hw i j Hi Hj; auto. inversion Hw; subst. simpl. unfold times.
  apply sum_ext; intros k Hk. rewrite H, IHw; auto.
Qed.

Lemma growth_ext n count T T' r : (forall t i j, (t < count)%nat -> (i < n)%nat -> (j < n)%nat -> T t i j = T' t i j) ->
  growth n count T r -> growth n count T' r.
Proof. intros H [C G]. exists C. intros w Hw i j Hi Hj. rewrite <- (product_ext n count T T') by auto. auto. Qed.

(* ---- norms ----------------------------------------------------------------------------------------------------- *)

(* The largest norm of P x over all products P of so many matrices. *)
Fixpoint largest_norm (Ms : list zmat) (level : nat) (x : zvec) : Z :=
  match level with O => norm1 x | S k => largest_of (map (fun M => largest_norm Ms k (mv M x)) Ms) end.

Definition norm_section (F : family) (u : Q) (level : nat) : bool :=
  (0 <=? Qnum u) && (0 <? level)%nat &&
  forallb (fun k => largest_norm (matrices F) level (unit_at 1 k) * Zpos (Qden u) ^ Z.of_nat level
                    <=? (Qnum u * denominator F) ^ Z.of_nat level) (seq 0 (size F)).

Lemma largest_norm_bound F level : forall w x, length w = level -> letters (count F) w ->
  norm1 (zrun (matrices F) w x) <= largest_norm (matrices F) level x.
Proof.
  induction level; intros w x Hl Hw.
  - destruct w; [|discriminate]. simpl. lia.
  - destruct (exists_last (l := w)) as [v [t ->]]. { intros ->. discriminate. }
    apply letters_app in Hw. destruct Hw as [Hv Ht]. inversion Ht; subst.
    rewrite app_length in Hl. simpl in Hl.
    assert (E : forall v, zrun (matrices F) (v ++ [t]) x = zrun (matrices F) v (mv (letter F t) x)).
    { clear. induction v; simpl; auto. rewrite IHv; auto. }
    rewrite E. eapply Z.le_trans. apply (IHlevel v); auto. lia.
    simpl. apply (largest_of_bound (fun M => largest_norm (matrices F) level (mv M x))). apply nth_In; auto.
Qed.

Theorem norm_sound F u level : well_formed F = true -> norm_section F u level = true ->
  grows_at_most (size F) (count F) (real F) (real_of u).
Proof.
  intros WF H. unfold norm_section in H. apply andb_prop in H. destruct H as [H H3]. apply andb_prop in H. destruct H as [H1 H2].
  apply Z.leb_le in H1. apply Nat.ltb_lt in H2. rewrite forallb_forall in H3.
  assert (D := denominator_positive F WF).
  assert (Hg : (0 <= real_of u)%R).
  { unfold real_of. apply Rmult_le_pos. apply IZR_le; auto. left; apply Rinv_0_lt_compat, IZR_lt; lia. }
  apply (level_bound (size F) (count F) (real F) (real_of u) level); auto. intros w Hw Hl k Hk.
  specialize (H3 k ltac:(apply in_seq; lia)). apply Z.leb_le in H3.
  assert (B := largest_norm_bound F level w (unit_at 1 k) Hl Hw).
  assert (V : norm (size F) (vr (zrun (matrices F) w (unit_at 1 k))) = (IZR (denominator F) ^ level * norm (size F) (run (size F) (real F) w (unit k)))%R).
  { rewrite vr_zrun, vr_unit, run_scal by auto. rewrite Hl, !norm_scal, Rabs_R1, Rmult_1_l.
    f_equal. apply Rabs_pos_eq. apply pow_le. lra. }
  assert (N := norm_norm1 (size F) (zrun (matrices F) w (unit_at 1 k))). rewrite V in N.
  set (q := Zpos (Qden u)) in *. assert (Hq : (0 < IZR q)%R) by (apply IZR_lt; unfold q; lia).
  assert (Hqk : (0 < IZR q ^ level)%R) by (apply pow_lt; auto). assert (HDk : (0 < IZR (denominator F) ^ level)%R) by (apply pow_lt; auto).
  apply IZR_le in H3, B. rewrite mult_IZR, <- !pow_IZR, mult_IZR, Rpow_mult_distr in H3.
  unfold real_of. fold q. unfold Rdiv. rewrite Rpow_mult_distr, pow_inv by lra.
  apply (Rmult_le_reg_l (IZR (denominator F) ^ level * IZR q ^ level)). apply Rmult_lt_0_compat; auto.
  replace (IZR (denominator F) ^ level * IZR q ^ level * (IZR (Qnum u) ^ level * / IZR q ^ level))%R
    with (IZR (Qnum u) ^ level * IZR (denominator F) ^ level)%R by (field; lra).
  eapply Rle_trans; [|apply H3].
  apply Rle_trans with (IZR (norm1 (zrun (matrices F) w (unit_at 1 k))) * IZR q ^ level)%R.
  - replace (IZR (denominator F) ^ level * IZR q ^ level * norm (size F) (run (size F) (real F) w (unit k)))%R
      with (IZR (denominator F) ^ level * norm (size F) (run (size F) (real F) w (unit k)) * IZR q ^ level)%R by ring.
    apply Rmult_le_compat_r; lra.
  - apply Rmult_le_compat_r; lra.
Qed.

(* ---- transposes ------------------------------------------------------------------------------------------------ *)

Definition transpose (F : family) : family := Family (size F) (denominator F) (map (columns (size F)) (matrices F)).

Lemma map_well_formed f F n d Ms : well_formed F = true -> 0 < d -> Ms = map f (matrices F) ->
  (forall M, square (size F) M = true -> square n (f M) = true) -> well_formed (Family n d Ms) = true.
Proof.
  intros WF Hd -> H. unfold well_formed in *. simpl. apply andb_true_intro. split. apply Z.ltb_lt; auto.
  apply andb_prop in WF. destruct WF as [_ WF]. rewrite forallb_forall in *. intros M HM.
  apply in_map_iff in HM. destruct HM as [M' [<- HM]]. apply H, WF; auto.
Qed.

Lemma wf_denominator F : well_formed F = true -> 0 < denominator F.
Proof. intros WF. apply lt_IZR, denominator_positive; auto. Qed.

Lemma transpose_well_formed F : well_formed F = true -> well_formed (transpose F) = true.
Proof. intros WF. eapply map_well_formed; eauto. apply wf_denominator; auto. intros. apply square_table. Qed.

Lemma letter_map (f : zmat -> zmat) F n d t : (t < count F)%nat -> letter (Family n d (map f (matrices F))) t = f (letter F t).
Proof.
  intros H. unfold letter. simpl. rewrite nth_indep with (d' := f []) by (rewrite map_length; auto). apply map_nth.
Qed.

Lemma count_map (f : zmat -> zmat) F n d : count (Family n d (map f (matrices F))) = count F.
Proof. apply map_length. Qed.

Lemma transpose_entry F t i j : (t < count F)%nat -> (i < size F)%nat -> (j < size F)%nat ->
  real (transpose F) t i j = transposed (real F) t i j.
Proof.
  intros Ht Hi Hj. unfold transposed, real. simpl denominator. f_equal.
  unfold mr, transpose. rewrite letter_map by auto. unfold columns. rewrite entry_table; auto.
Qed.

Lemma transpose_growth F r : growth (size F) (count (transpose F)) (real (transpose F)) r -> growth (size F) (count F) (real F) r.
Proof.
  intros H. apply growth_transposed. unfold transpose in H. rewrite count_map in H.
  eapply growth_ext; [|apply H]. intros. apply transpose_entry; auto.
Qed.

Lemma transpose_sound F u : radius_at_most (size F) (count (transpose F)) (real (transpose F)) u ->
  radius_at_most (size F) (count F) (real F) u.
Proof. intros H r Hr H0. apply transpose_growth, H; auto. Qed.

(* ---- sections -------------------------------------------------------------------------------------------------- *)

Inductive section :=
| Norm (level : nat)
| Polytope (nonnegative transposed : bool) (scale one : Z) (all : list point)
    (unit_lines : list (list term)) (image_lines : list (list (list term)))
| Quadratic (form : zmat) (definite : square_root) (words : word_tree)
| Graph (bound : Q) (unity : Z) (firsts : list nat) (group : list element) (turns : list turn) (states : list state)
| Single (sum : squares) (recurrence : list Z).

Definition check_section (F : family) (u : Q) (s : section) : bool :=
  match s with
  | Norm level => norm_section F u level
  | Polytope nonnegative transposed scale one all ul il =>
      polytope (if transposed then transpose F else F) u nonnegative scale one all ul il
  | Quadratic form definite words => quadratic F u form definite words
  | Graph bound unity firsts group turns states => graph F u bound unity firsts group turns states
  | Single sum recurrence => single_section F u sum recurrence
  end.

Theorem section_sound F u s : well_formed F = true -> check_section F u s = true ->
  radius_at_most (size F) (count F) (real F) (real_of u).
Proof.
  intros WF H. destruct s as [level|nonnegative transposed scale one all ul il|form definite words|bound unity firsts group turns states|sum recurrence];
    simpl in H.
  - apply grows_radius. eapply norm_sound; eauto.
  - destruct transposed.
    + apply transpose_sound. change (size F) with (size (transpose F)).
      eapply polytope_sound; eauto. apply transpose_well_formed; auto.
    + eapply polytope_sound; eauto.
  - eapply quadratic_sound; eauto.
  - eapply graph_sound; eauto.
  - eapply single_sound; eauto.
Qed.

(* ---- diagonal blocks ------------------------------------------------------------------------------------------- *)

Definition first_block (d : nat) (F : family) : family :=
  Family d (denominator F) (map (fun M => map (firstn d) (firstn d M)) (matrices F)).
Definition other_blocks (d : nat) (F : family) : family :=
  Family (size F - d) (denominator F) (map (fun M => map (skipn d) (skipn d M)) (matrices F)).
Definition triangular (d : nat) (F : family) : bool :=
  (d <=? size F)%nat && forallb (fun M => forallb (fun row => forallb (Z.eqb 0) (firstn d row)) (skipn d M)) (matrices F).

Lemma In_firstn {A} d (l : list A) x : In x (firstn d l) -> In x l.
Proof. intros H. rewrite <- (firstn_skipn d l). apply in_or_app; auto. Qed.
Lemma In_skipn {A} d (l : list A) x : In x (skipn d l) -> In x l.
Proof. intros H. rewrite <- (firstn_skipn d l). apply in_or_app; auto. Qed.

Lemma nth_firstn {A} d (l : list A) i x : (i < d)%nat -> nth i (firstn d l) x = nth i l x.
Proof. revert l i. induction d; intros l i H. lia. destruct l; auto. destruct i; simpl; auto. apply IHd. lia. Qed.
Lemma nth_skipn {A} d (l : list A) i x : nth i (skipn d l) x = nth (d + i) l x.
Proof. revert l. induction d; intros l; auto. destruct l; simpl; auto. destruct i; auto. Qed.

Lemma first_well_formed d F : well_formed F = true -> (d <= size F)%nat -> well_formed (first_block d F) = true.
Proof.
  intros WF Hd. eapply map_well_formed; eauto. apply wf_denominator; auto. intros M H. apply square_spec in H. destruct H as [H1 H2].
  apply square_spec. rewrite map_length, firstn_length. split. apply Nat.min_l. refine (eq_ind_r (fun k => (d <= k)%nat) Hd H1). intros row I. apply in_map_iff in I. destruct I as [r [<- I]].
  rewrite firstn_length. apply In_firstn, H2 in I. apply Nat.min_l. refine (eq_ind_r (fun k => (d <= k)%nat) Hd I).
Qed.

Lemma other_well_formed d F : well_formed F = true -> well_formed (other_blocks d F) = true.
Proof.
  intros WF. eapply map_well_formed; eauto. apply wf_denominator; auto. intros M H. apply square_spec in H. destruct H as [H1 H2].
  apply square_spec. rewrite map_length, skipn_length. split. exact (f_equal (fun k => (k - d)%nat) H1). intros row I. apply in_map_iff in I. destruct I as [r [<- I]].
  rewrite skipn_length. apply In_skipn, H2 in I. exact (f_equal (fun k => (k - d)%nat) I).
Qed.

Lemma first_entry d F t i j : (t < count F)%nat -> (i < d)%nat -> (j < d)%nat -> real (first_block d F) t i j = real F t i j.
Proof.
  intros Ht Hi Hj. unfold real. simpl denominator. f_equal. unfold mr. f_equal. unfold first_block. rewrite letter_map by auto.
  unfold entry. rewrite nth_map_nil by apply firstn_nil. rewrite !nth_firstn; auto.
Qed.

Lemma other_entry d F t i j : (t < count F)%nat -> real (other_blocks d F) t i j = rest d (real F) t i j.
Proof.
  intros Ht. unfold rest, real. simpl denominator. f_equal. unfold mr. f_equal. unfold other_blocks. rewrite letter_map by auto.
  unfold entry. rewrite nth_map_nil by apply skipn_nil. rewrite !nth_skipn; auto.
Qed.

Lemma triangular_spec d F : triangular d F = true -> (d <= size F)%nat /\
  forall t, (t < count F)%nat -> forall i j, (i < size F - d)%nat -> (j < d)%nat -> real F t (d + i)%nat j = 0%R.
Proof.
  unfold triangular. rewrite andb_true_iff, Nat.leb_le, forallb_forall. intros [Hd H]. split; auto.
  intros t Ht i j Hi Hj. unfold real, mr. replace (entry (letter F t) (d + i) j) with 0. apply Rmult_0_l.
  specialize (H (letter F t) ltac:(apply nth_In; auto)). rewrite forallb_forall in H. unfold entry. rewrite <- nth_skipn.
  destruct (nth_in_or_default i (skipn d (letter F t)) []) as [I | ->]; [|rewrite nth_nil; auto].
  apply H in I. rewrite forallb_forall in I. rewrite <- (nth_firstn d) by auto.
  destruct (nth_in_or_default j (firstn d (nth i (skipn d (letter F t)) [])) 0) as [J | ->]; auto.
  apply I in J. apply Z.eqb_eq in J. auto.
Qed.

(* One section for each diagonal block, all of them right, or at least one *)
Fixpoint all_blocks {S : Type} (check : family -> S -> bool) (F : family) (blocks : list (nat * S)) : bool :=
  match blocks with
  | [] => false
  | [(d, s)] => Nat.eqb d (size F) && check F s
  | (d, s) :: blocks' => triangular d F && check (first_block d F) s && all_blocks check (other_blocks d F) blocks'
  end.

Fixpoint some_block {S : Type} (check : family -> S -> bool) (F : family) (blocks : list (nat * S)) : bool :=
  match blocks with
  | [] => false
  | [(d, s)] => Nat.eqb d (size F) && check F s
  | (d, s) :: blocks' => triangular d F && (check (first_block d F) s || some_block check (other_blocks d F) blocks')
  end.

Definition check_upper (F : family) (u : Q) : list (nat * section) -> bool := all_blocks (fun F => check_section F u) F.

Lemma growth_first d F x : growth d (count (first_block d F)) (real (first_block d F)) x <-> growth d (count F) (real F) x.
Proof.
  unfold first_block at 1. rewrite count_map. split; intros G; eapply growth_ext; try apply G; intros; [|symmetry]; apply first_entry; auto.
Qed.

Lemma growth_other d F x :
  growth (size F - d) (count (other_blocks d F)) (real (other_blocks d F)) x <-> growth (size F - d) (count F) (rest d (real F)) x.
Proof.
  unfold other_blocks at 1. rewrite count_map. split; intros G; eapply growth_ext; try apply G; intros; [|symmetry]; apply other_entry; auto.
Qed.

Theorem all_blocks_sound {S : Type} (check : family -> S -> bool) u :
  (forall F s, well_formed F = true -> check F s = true -> radius_at_most (size F) (count F) (real F) u) ->
  forall blocks F, well_formed F = true -> all_blocks check F blocks = true -> radius_at_most (size F) (count F) (real F) u.
Proof.
  intros Sound. induction blocks as [|[d s] blocks IH]; intros F WF H. discriminate.
  destruct blocks as [|b blocks].
  - simpl in H. apply andb_prop in H. destruct H as [_ H]. eauto.
  - assert (H' : triangular d F && check (first_block d F) s && all_blocks check (other_blocks d F) (b :: blocks) = true) by exact H.
    clear H. apply andb_prop in H'. destruct H' as [H H3]. apply andb_prop in H. destruct H as [H1 H2].
    apply triangular_spec in H1. destruct H1 as [Hd HT].
    apply Sound in H2; [|apply first_well_formed; auto]. apply IH in H3; [|apply other_well_formed; auto].
    replace (size F) with (n d (size F - d)) by (unfold n; lia).
    apply blocks_at_most.
    + exact HT.
    + intros r Hr H0. apply growth_first. apply H2; auto.
    + intros r Hr H0. apply growth_other. apply H3; auto.
Qed.

Theorem some_block_sound {S : Type} (check : family -> S -> bool) l :
  (forall F s, well_formed F = true -> check F s = true -> radius_at_least (size F) (count F) (real F) l) ->
  forall blocks F, well_formed F = true -> some_block check F blocks = true -> radius_at_least (size F) (count F) (real F) l.
Proof.
  intros Sound. induction blocks as [|[d s] blocks IH]; intros F WF H. discriminate.
  destruct blocks as [|b blocks].
  - simpl in H. apply andb_prop in H. destruct H as [_ H]. eauto.
  - assert (H' : triangular d F && (check (first_block d F) s || some_block check (other_blocks d F) (b :: blocks)) = true) by exact H.
    clear H. apply andb_prop in H'. destruct H' as [H1 H]. apply triangular_spec in H1. destruct H1 as [Hd HT].
    replace (size F) with (n d (size F - d)) by (unfold n; lia). apply orb_prop in H. destruct H as [H|H].
    + apply Sound in H; [|apply first_well_formed; auto]. apply first_at_least. exact HT.
      intros r Hr G. apply H; auto. apply growth_first. auto.
    + apply IH in H; [|apply other_well_formed; auto]. apply rest_at_least. exact HT.
      intros r Hr G. apply H; auto. apply growth_other. auto.
Qed.

Theorem upper_sound blocks F u : well_formed F = true -> check_upper F u blocks = true ->
  radius_at_most (size F) (count F) (real F) (real_of u).
Proof. apply all_blocks_sound. intros G s WF H. eapply section_sound; eauto. Qed.

(* A product of one of the blocks, after some that are skipped. *)
Fixpoint check_lower (F : family) (l : Q) (sizes : list nat) (block : nat) (e : eigen) : bool :=
  match block, sizes with
  | O, [] => eigenvalue F e l
  | O, d :: _ => triangular d F && eigenvalue (first_block d F) e l
  | S k, d :: sizes' => triangular d F && check_lower (other_blocks d F) l sizes' k e
  | _, _ => false
  end.

Theorem lower_sound block : forall F l sizes e, well_formed F = true -> check_lower F l sizes block e = true ->
  radius_at_least (size F) (count F) (real F) (real_of l).
Proof.
  induction block; intros F l sizes e WF H; destruct sizes as [|d sizes]; simpl in H; try discriminate.
  - apply eigenvalue_sound in H; auto.
  - apply andb_prop in H. destruct H as [H1 H2]. apply triangular_spec in H1. destruct H1 as [Hd HT].
    apply eigenvalue_sound in H2; [|apply first_well_formed; auto].
    replace (size F) with (n d (size F - d)) by (unfold n; lia).
    apply first_at_least. exact HT. intros r Hr G. apply H2; auto. apply growth_first. auto.
  - apply andb_prop in H. destruct H as [H1 H2]. apply triangular_spec in H1. destruct H1 as [Hd HT].
    apply IHblock in H2; [|apply other_well_formed; auto].
    replace (size F) with (n d (size F - d)) by (unfold n; lia).
    apply rest_at_least. exact HT. intros r Hr G. apply H2; auto. apply growth_other. auto.
Qed.

(* ---- another basis --------------------------------------------------------------------------------------------- *)

(* The rows of B and C, where B C = C B = scale. *)
Record basis := Basis { basis_rows : zmat; inverse_rows : zmat; basis_scale : Z }.

Definition zproduct (n : nat) (A B : zmat) : zmat := products A (columns n B).

Definition is_scaled_unit (n : nat) (a : Z) (M : zmat) : bool :=
  forallb (fun i => forallb (fun j => entry M i j =? if_equal i j a) (seq 0 n)) (seq 0 n).

Definition basis_valid (n : nat) (b : basis) : bool :=
  (0 <? basis_scale b) && square n (basis_rows b) && square n (inverse_rows b) &&
  is_scaled_unit n (basis_scale b) (zproduct n (basis_rows b) (inverse_rows b)) &&
  is_scaled_unit n (basis_scale b) (zproduct n (inverse_rows b) (basis_rows b)).

Definition in_basis (F : family) (b : basis) : family :=
  Family (size F) (denominator F * basis_scale b)
    (map (fun M => zproduct (size F) (zproduct (size F) (inverse_rows b) M) (basis_rows b)) (matrices F)).

Lemma square_products n A B : square n A = true -> square n (products A (columns n B)) = true.
Proof.
  intros H. apply square_spec in H. destruct H as [H1 H2]. apply square_spec. unfold products. rewrite map_length. split; auto.
  intros row I. apply in_map_iff in I. destruct I as [r [<- _]]. unfold columns, table. rewrite !map_length, seq_length. auto.
Qed.

Lemma scaled_unit_spec n a A B x i : square n A = true -> is_scaled_unit n a (zproduct n A B) = true -> (i < n)%nat ->
  apply n (mr A) (apply n (mr B) x) i = (IZR a * x i)%R.
Proof.
  intros HA H Hi. rewrite <- apply_products by auto. unfold apply.
  unfold is_scaled_unit in H. rewrite forallb_forall in H. specialize (H i ltac:(apply in_seq; lia)). rewrite forallb_forall in H.
  rewrite <- (sum_identity n i x) by auto. rewrite <- sum_scal. apply sum_ext; intros j Hj.
  specialize (H j ltac:(apply in_seq; lia)). apply Z.eqb_eq in H. unfold zproduct in H. unfold mr. rewrite H.
  unfold if_equal, identity. rewrite (Nat.eqb_sym j i). destruct (Nat.eqb i j); ring.
Qed.

Section InBasis.
Variables (F : family) (b : basis).
Hypothesis WF : well_formed F = true.
Hypothesis Valid : basis_valid (size F) b = true.
Let n := size F.
Let s := IZR (basis_scale b).

Lemma basis_facts : (0 < s)%R /\ square n (basis_rows b) = true /\ square n (inverse_rows b) = true /\
  (forall x i, (i < n)%nat -> apply n (mr (basis_rows b)) (apply n (mr (inverse_rows b)) x) i = (s * x i)%R) /\
  (forall x i, (i < n)%nat -> apply n (mr (inverse_rows b)) (apply n (mr (basis_rows b)) x) i = (s * x i)%R).
Proof.
  unfold basis_valid in Valid. repeat rewrite andb_true_iff in Valid. destruct Valid as [[[[V1 V2] V3] V4] V5].
  split. apply IZR_lt. apply Z.ltb_lt; auto. split; auto. split; auto.
  split; intros; apply scaled_unit_spec; auto.
Qed.

Lemma in_basis_well_formed : well_formed (in_basis F b) = true.
Proof.
  destruct basis_facts as [Hs [HB [HC _]]]. apply lt_IZR in Hs. eapply map_well_formed; eauto.
  - assert (D := wf_denominator F WF). lia.
  - intros M HM. apply square_products, square_products; auto.
Qed.

Lemma in_basis_apply t x i : (t < count F)%nat -> (i < n)%nat -> apply n (real (in_basis F b) t) x i =
  (/ s * apply n (mr (inverse_rows b)) (apply n (real F t) (apply n (mr (basis_rows b)) x)) i)%R.
Proof.
  intros Ht Hi. destruct basis_facts as [Hs [HB [HC _]]].
  assert (D := denominator_positive F WF). assert (HM := letter_square F WF t Ht). fold n in HM.
  assert (E : apply n (real F t) (apply n (mr (basis_rows b)) x) =
              scal (/ IZR (denominator F)) (apply n (mr (letter F t)) (apply n (mr (basis_rows b)) x))).
  { extensionality k. unfold apply at 1. unfold scal, apply at 2. rewrite <- sum_scal. apply sum_ext; intros. unfold real, Rdiv. ring. }
  rewrite E, apply_scal. unfold scal.
  rewrite <- apply_products, <- apply_products by (auto; apply square_products; auto).
  unfold apply. rewrite <- !sum_scal. apply sum_ext; intros j Hj.
  unfold real. simpl denominator. rewrite mult_IZR. unfold in_basis. rewrite letter_map by auto.
  fold n s. unfold zproduct. field. lra.
Qed.

Let B := mr (basis_rows b).
Let C : mat := fun i j => (mr (inverse_rows b) i j / s)%R.

Lemma C_apply x : apply n C x = scal (/ s) (apply n (mr (inverse_rows b)) x).
Proof. extensionality i. unfold apply, scal, C. rewrite <- sum_scal. apply sum_ext; intros. unfold Rdiv; ring. Qed.

Lemma growth_in_basis r : (0 <= r)%R ->
  growth n (count F) (real (in_basis F b)) r <-> growth n (count F) (real F) r.
Proof.
  intros Hr. destruct basis_facts as [Hs [HB [HC [H1 H2]]]]. split.
  - apply (growth_basis n (count F) (real F) (real (in_basis F b)) B C); auto.
    + intros t Ht y i Hi.
      rewrite (apply_ext n B (apply n (real (in_basis F b) t) y)
        (scal (/ s) (apply n (mr (inverse_rows b)) (apply n (real F t) (apply n B y))))).
      * rewrite apply_scal. unfold scal, B. rewrite H1 by auto. field. lra.
      * intros k Hk. rewrite in_basis_apply by auto. reflexivity.
    + intros x i Hi. rewrite C_apply, apply_scal. unfold scal, B. rewrite H1 by auto. field. lra.
  - apply (growth_basis n (count F) (real (in_basis F b)) (real F) C B); auto.
    + intros t Ht y i Hi. rewrite in_basis_apply by auto. rewrite (C_apply (apply n (real F t) y)). unfold scal. f_equal.
      apply (f_equal (fun f => f i)). apply apply_ext. intros k Hk. apply (f_equal (fun f => f k)). apply apply_ext. intros j Hj.
      rewrite C_apply, apply_scal. unfold scal. rewrite H1 by auto. field. lra.
    + intros x i Hi. rewrite C_apply. unfold scal, B. rewrite H2 by auto. field. lra.
Qed.
End InBasis.

(* ---- claims and certificates ----------------------------------------------------------------------------------- *)

(* lower <= joint spectral radius <= upper of a family. *)
Record claim := Claim { matrices_of : family; lower : option Q; upper : option Q }.

Record certificate := Certificate {
  new_basis : option basis;
  sections : list (nat * section);     (* sizes of diagonal blocks, and for each why the upper end holds *)
  sizes : list nat;                    (* sizes of diagonal blocks, for the lower end *)
  chosen : nat; eigenvector : option eigen }.

Definition check_bounds (F : family) (c : claim) (cert : certificate) : bool :=
  match upper c with None => true | Some u => (0 <=? Qnum u) && check_upper F u (sections cert) end &&
  match lower c with
  | None => true
  | Some l => (Qnum l <=? 0) || match eigenvector cert with None => false | Some e => check_lower F l (sizes cert) (chosen cert) e end
  end.

Definition check_radius (c : claim) (cert : certificate) : bool :=
  let F := matrices_of c in
  well_formed F &&
  match new_basis cert with
  | None => check_bounds F c cert
  | Some b => basis_valid (size F) b && check_bounds (in_basis F b) c cert
  end.

Definition claim_holds (c : claim) : Prop :=
  forall x, is_radius (size (matrices_of c)) (count (matrices_of c)) (real (matrices_of c)) x ->
  (forall l, lower c = Some l -> (real_of l <= x)%R) /\ (forall u, upper c = Some u -> (x <= real_of u)%R).

Lemma bounds_sound F c cert : well_formed F = true -> check_bounds F c cert = true ->
  (forall l, lower c = Some l -> radius_at_least (size F) (count F) (real F) (real_of l)) /\
  (forall u, upper c = Some u -> radius_at_most (size F) (count F) (real F) (real_of u) /\ (0 <= real_of u)%R).
Proof.
  intros WF H. unfold check_bounds in H. apply andb_prop in H. destruct H as [HU HL]. split.
  - intros l E. rewrite E in HL. apply orb_prop in HL. destruct HL as [HL|HL].
    + intros r Hr _. apply Z.leb_le, IZR_le in HL. unfold real_of.
      assert (0 < / IZR (Zpos (Qden l)))%R by (apply Rinv_0_lt_compat, IZR_lt; lia). unfold Rdiv. nra.
    + destruct (eigenvector cert) as [e|]; [|discriminate]. eapply lower_sound; eauto.
  - intros u E. rewrite E in HU. apply andb_prop in HU. destruct HU as [H0 HU]. split. eapply upper_sound; eauto.
    unfold real_of. apply Rmult_le_pos. apply IZR_le, Z.leb_le; auto. left; apply Rinv_0_lt_compat, IZR_lt; lia.
Qed.

(* What the checker accepts is true. *)
Theorem check_radius_sound c cert : check_radius c cert = true -> claim_holds c.
Proof.
  intros H x Hx. unfold check_radius in H. apply andb_prop in H. destruct H as [WF H].
  set (F := matrices_of c) in *. destruct (new_basis cert) as [b|].
  - apply andb_prop in H. destruct H as [V H]. assert (WF' := in_basis_well_formed F b WF V).
    destruct (bounds_sound _ c cert WF' H) as [L U].
    assert (EC : count (in_basis F b) = count F) by apply count_map. rewrite EC in L, U.
    change (size (in_basis F b)) with (size F) in L, U.
    split.
    + intros l E. apply (at_least (size F) (count F) (real F)); auto. intros r Hr G. apply (L l E); auto.
      apply (growth_in_basis F b WF V); auto.
    + intros u E. destruct (U u E) as [U1 U2]. apply (at_most (size F) (count F) (real F)); auto.
      intros r Hr H0. apply (growth_in_basis F b WF V); auto. lra.
  - destruct (bounds_sound F c cert WF H) as [L U]. split.
    + intros l E. apply (at_least (size F) (count F) (real F)); auto.
    + intros u E. destruct (U u E). apply (at_most (size F) (count F) (real F)); auto.
Qed.
