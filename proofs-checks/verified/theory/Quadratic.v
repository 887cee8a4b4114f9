(* Upper bounds by quadratic forms on trees of words, checked with integers. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Blocks Integers Sections Eigenvalue.
Import ListNotations.
Open Scope Z_scope.

(* A symmetric S is positive as factor * S - scale * L L^T is nearly diagonal; the rows of L and these are hints. *)
Record square_root := Root { root_rows : zmat; root_factor : Z; root_scale : Z }.

Inductive word_tree := Word (root : square_root) | Words (children : list word_tree).

(* The rest of S after the square root, and what its diagonal exceeds all else by, twice, in row and column i. *)
Definition root_rest (S : nat -> nat -> Z) (h : square_root) (i j : nat) : Z :=
  root_factor h * S i j - root_scale h * dot (nth i (root_rows h) []) (nth j (root_rows h) []).
Definition others (n i : nat) (E : zmat) : Z :=
  fold_right Z.add 0 (map (fun j => if Nat.eqb i j then 0 else Z.abs (entry E i j) + Z.abs (entry E j i)) (seq 0 n)).
Definition positive_form (n : nat) (margin : Z) (S : nat -> nat -> Z) (h : square_root) : bool :=
  let E := table n (root_rest S h) in
  (0 <? root_factor h) && (0 <=? root_scale h) && forallb (fun row => (length row <=? n)%nat) (root_rows h) &&
  forallb (fun i => 2 * margin + others n i E <=? 2 * entry E i i) (seq 0 n).

Section Check.
Variables (F : family) (u : Q) (P : zmat).
Let n := size F.


(* The rows of the product of a word, times one more letter. *)
Definition extended (rows : zmat) (t : nat) : zmat := map (mv (columns n (letter F t))) rows.

Definition below_bound (w : list nat) (rows : zmat) (h : square_root) : bool :=
  let k := 2 * Z.of_nat (length w) in
  let cs := columns n rows in
  let pcs := map (mv P) cs in
  let a := (Qnum u * denominator F) ^ k in
  let b := Zpos (Qden u) ^ k in
  match w with
  | [] => false
  | _ => positive_form n 0 (fun i j => a * entry P i j - b * dot (nth i cs []) (nth j pcs [])) h
  end.

Fixpoint check_tree (w : list nat) (rows : zmat) (t : word_tree) : bool :=
  match t with
  | Word h => below_bound w rows h
  | Words children =>
      Nat.eqb (length children) (count F) &&
      (fix each (k : nat) (l : list word_tree) : bool :=
         match l with [] => true | c :: l' => check_tree (w ++ [k]) (extended rows k) c && each (S k) l' end) 0%nat children
  end.

Definition quadratic (definite : square_root) (words : word_tree) : bool :=
  (0 <=? Qnum u) && square n P && positive_form n 1 (entry P) definite &&
  check_tree [] (table n (fun i j => if_equal i j 1)) words.
End Check.

(* ---- why that proves the bound --------------------------------------------------------------------------------- *)

Open Scope R_scope.

Lemma sum_scal_r n c f : sum n (fun i => f i * c) = sum n f * c.
Proof. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros; ring. Qed.

Definition form (n : nat) (S : nat -> nat -> R) (x : vec) : R := sum n (fun i => sum n (fun j => S i j * (x i * x j))).

Lemma form_plus n A B x : form n (fun i j => A i j + B i j) x = form n A x + form n B x.
Proof.
  unfold form. rewrite <- sum_plus. apply sum_ext; intros. rewrite <- sum_plus. apply sum_ext; intros. ring.
Qed.

Lemma form_scal n c A x : form n (fun i j => c * A i j) x = c * form n A x.
Proof.
  unfold form. rewrite <- sum_scal. apply sum_ext; intros. rewrite <- sum_scal. apply sum_ext; intros. ring.
Qed.

Lemma form_ext n A B x : (forall i j, (i < n)%nat -> (j < n)%nat -> A i j = B i j) -> form n A x = form n B x.
Proof. intros H. apply sum_ext; intros. apply sum_ext; intros. rewrite H; auto. Qed.

(* Diagonal dominance. *)
Lemma dominant n E d x : (forall i, (i < n)%nat ->
    2 * d + sum n (fun j => if Nat.eqb i j then 0 else Rabs (E i j) + Rabs (E j i)) <= 2 * E i i) ->
  d * sum n (fun i => x i * x i) <= form n E x.
Proof.
  intros H.
  set (off := fun i j => if Nat.eqb i j then 0 else Rabs (E i j)).
  assert (Diagonal : forall i j, (i < n)%nat -> (j < n)%nat ->
    2 * (E i j * (x i * x j)) >= 2 * (identity j i * (E i i * (x i * x i))) - off i j * (x i * x i) - off i j * (x j * x j)).
  { intros i j Hi Hj. unfold off, identity. rewrite (Nat.eqb_sym j i). destruct (Nat.eqb_spec i j) as [->|N]. lra.
    assert (A := Rle_0_sqr (x i + x j)). assert (B := Rle_0_sqr (x i - x j)). unfold Rsqr in *.
    unfold Rabs. destruct (Rcase_abs (E i j)); nra. }
  assert (Sum : 2 * form n E x >= sum n (fun i => sum n (fun j =>
      2 * (identity j i * (E i i * (x i * x i))) + (-1) * (off i j * (x i * x i)) + (-1) * (off i j * (x j * x j))))).
  { unfold form. rewrite <- sum_scal. apply Rle_ge, sum_le; intros i Hi. rewrite <- sum_scal. apply sum_le; intros j Hj.
    specialize (Diagonal i j Hi Hj). lra. }
  assert (Split : sum n (fun i => sum n (fun j =>
      2 * (identity j i * (E i i * (x i * x i))) + (-1) * (off i j * (x i * x i)) + (-1) * (off i j * (x j * x j)))) =
    sum n (fun i => (2 * E i i - sum n (fun j => off i j + off j i)) * (x i * x i))).
  { rewrite (sum_ext n _ (fun i => 2 * (E i i * (x i * x i)) + (-1) * (sum n (fun j => off i j) * (x i * x i)) + (-1) * sum n (fun j => off i j * (x j * x j)))).
    2:{ intros i Hi. rewrite !sum_plus, !sum_scal. rewrite (sum_identity n i (fun _ => E i i * (x i * x i))) by auto.
        rewrite sum_scal_r. reflexivity. }
    rewrite !sum_plus, !sum_scal, (sum_swap n n (fun i j => off i j * (x j * x j))).
    rewrite (sum_ext n (fun j => sum n (fun i => off i j * (x j * x j))) (fun j => sum n (fun i => off i j) * (x j * x j))).
    2:{ intros j Hj. apply sum_scal_r. }
    rewrite <- !sum_scal, <- !sum_plus. apply sum_ext; intros i Hi. rewrite (sum_plus n (off i)). change (fun j : nat => off i j) with (off i). ring. }
  rewrite Split in Sum.
  assert (Low : sum n (fun i => 2 * d * (x i * x i)) <= sum n (fun i => (2 * E i i - sum n (fun j => off i j + off j i)) * (x i * x i))).
  { apply sum_le; intros i Hi. apply Rmult_le_compat_r. apply (Rle_0_sqr (x i)). specialize (H i Hi).
    rewrite (sum_ext n (fun j => off i j + off j i) (fun j => if Nat.eqb i j then 0 else Rabs (E i j) + Rabs (E j i))). lra.
    intros j Hj. unfold off. rewrite (Nat.eqb_sym j i). destruct (Nat.eqb i j); ring. }
  rewrite sum_scal in Low. lra.
Qed.

(* A sum of squares. *)
Lemma gram_nonneg n L x : (forall row, In row L -> (length row <= n)%nat) ->
  0 <= form n (fun i j => IZR (dot (nth i L []) (nth j L []))) x.
Proof.
  intros H. rewrite (form_ext n _ (fun i j => sum n (fun k => mr L i k * mr L j k))).
  2:{ intros i j Hi Hj. unfold mr, entry. apply dot_sum.
      exact (match nth_in_or_default i L [] with left K => H _ K | right E => eq_ind_r (fun r : list Z => (length r <= n)%nat) (Nat.le_0_l n : (length (@nil Z) <= n)%nat) E end). }
  replace (form n (fun i j => sum n (fun k => mr L i k * mr L j k)) x)
    with (sum n (fun k => sum n (fun i => mr L i k * x i) * sum n (fun i => mr L i k * x i))).
  - apply sum_nonneg; intros. apply (Rle_0_sqr (sum n (fun i0 => mr L i0 i * x i0))).
  - unfold form. symmetry.
    rewrite (sum_ext n _ (fun i => sum n (fun k => sum n (fun j => mr L i k * x i * (mr L j k * x j))))).
    + rewrite sum_swap. apply sum_ext; intros k Hk.
      rewrite (sum_ext n _ (fun i => sum n (fun j => mr L j k * x j) * (mr L i k * x i))).
      rewrite sum_scal. reflexivity. intros i Hi. rewrite sum_scal. ring.
    + intros i Hi. rewrite sum_swap. apply sum_ext; intros j Hj. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros; ring.
Qed.

Lemma others_sum n i E : IZR (others n i E) = sum n (fun j => if Nat.eqb i j then 0 else Rabs (mr E i j) + Rabs (mr E j i)).
Proof.
  unfold others.
  assert (G : forall f k m, IZR (fold_right Z.add 0%Z (map f (seq k m))) = sum m (fun j => IZR (f (k + j)%nat))).
  { intros f k m. revert k. induction m; intros k. auto.
    change (sum (S m)) with (sum (1 + m)). rewrite sum_add. simpl map. simpl fold_right. rewrite plus_IZR, IHm.
    simpl sum at 2. rewrite Nat.add_0_r, Rplus_0_l. f_equal. apply sum_ext; intros. f_equal. f_equal. lia. }
  rewrite G. apply sum_ext; intros j Hj. simpl. destruct (Nat.eqb i j); auto.
  rewrite plus_IZR, !abs_IZR. reflexivity.
Qed.

Lemma positive_form_sound n margin S h x : positive_form n margin S h = true ->
  0 < IZR (root_factor h) /\
  IZR margin * sum n (fun i => x i * x i) <= IZR (root_factor h) * form n (fun i j => IZR (S i j)) x.
Proof.
  intros H. unfold positive_form in H. repeat rewrite andb_true_iff in H. destruct H as [[[H1 H0] H2] H3].
  apply Z.ltb_lt in H1. apply Z.leb_le, IZR_le in H0. rewrite forallb_forall in H2, H3.
  split. apply IZR_lt; auto.
  rewrite <- form_scal.
  rewrite (form_ext n _ (fun i j => mr (table n (root_rest S h)) i j + IZR (root_scale h) * IZR (dot (nth i (root_rows h) []) (nth j (root_rows h) [])))).
  2:{ intros i j Hi Hj. unfold mr. rewrite entry_table by auto. unfold root_rest. rewrite minus_IZR, !mult_IZR. ring. }
  rewrite form_plus, (form_scal n (IZR (root_scale h))).
  assert (G := gram_nonneg n (root_rows h) x ltac:(intros row I; apply Nat.leb_le, H2, I)).
  assert (D := dominant n (mr (table n (root_rest S h))) (IZR margin) x).
  change (form n (fun i j => mr (table n (root_rest S h)) i j) x) with (form n (mr (table n (root_rest S h))) x).
  eapply Rle_trans. apply D. 2: { rewrite <- (Rplus_0_r (form n (mr (table n (root_rest S h))) x)) at 1. apply Rplus_le_compat_l. apply Rmult_le_pos; [exact H0 | exact G]. }
  intros i Hi. specialize (H3 i ltac:(apply in_seq; lia)). apply Z.leb_le, IZR_le in H3.
  rewrite plus_IZR, !mult_IZR, others_sum in H3. exact H3.
Qed.

(* A form after a linear map. *)
Lemma form_image n P (c : nat -> nat -> R) x :
  form n (fun i j => sum n (fun a => c i a * sum n (fun b => P a b * c j b))) x = form n P (fun a => sum n (fun i => c i a * x i)).
Proof.
  unfold form.
  rewrite (sum_ext n _ (fun i => sum n (fun a => sum n (fun j => c i a * sum n (fun b => P a b * c j b) * (x i * x j))))).
  2:{ intros i Hi. rewrite sum_swap. apply sum_ext; intros j Hj. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros; ring. }
  rewrite sum_swap. apply sum_ext; intros a Ha.
  rewrite (sum_ext n _ (fun i => sum n (fun b => P a b * sum n (fun j => c j b * x j)) * (c i a * x i))).
  - rewrite sum_scal, Rmult_comm, <- sum_scal. apply sum_ext; intros b Hb. ring.
  - intros i Hi. rewrite (sum_ext n (fun b => P a b * _) (fun b => sum n (fun j => P a b * (c j b * x j)))).
    2:{ intros. rewrite sum_scal. auto. }
    rewrite sum_swap. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros j Hj.
    rewrite (sum_ext n (fun i0 => P a i0 * (c j i0 * x j)) (fun b => x j * (P a b * c j b))) by (intros; ring).
    rewrite sum_scal. ring.
Qed.

Section Sound.
Variables (F : family) (u : Q) (P : zmat).
Hypothesis WF : well_formed F = true.
Hypothesis U0 : (0 <= Qnum u)%Z.
Hypothesis SP : square (size F) P = true.
Let n := size F.
Let T := real F.
Let N (_ : nat) (x : vec) : R := sqrt (form n (mr P) x).

Definition rows_of (w : list nat) (rows : zmat) : Prop := forall i j, (i < n)%nat -> (j < n)%nat ->
  IZR (entry rows i j) = IZR (denominator F) ^ length w * product n T w i j.

Lemma rows_of_extended w rows t : (t < count F)%nat -> rows_of w rows -> rows_of (w ++ [t]) (extended F rows t).
Proof.
  intros Ht H i j Hi Hj. unfold entry, extended. rewrite nth_map_nil by reflexivity.
  fold n. change (IZR (nth j (mv (columns n (letter F t)) (nth i rows [])) 0%Z))
    with (vr (mv (columns n (letter F t)) (nth i rows [])) j).
  rewrite (vr_mv n) by apply square_table. unfold apply. rewrite product_app, app_length, pow_add by auto.
  rewrite <- sum_scal. apply sum_ext; intros k Hk. rewrite product_letter by auto.
  unfold mr, columns. rewrite entry_table by auto. change (vr (nth i rows []) k) with (IZR (entry rows i k)).
  rewrite H by auto. assert (D := denominator_positive F WF). unfold T, real, mr. simpl. field. lra.
Qed.

Lemma rows_of_nothing : rows_of [] (table n (fun i j => if_equal i j 1)).
Proof.
  intros i j Hi Hj. rewrite entry_table by auto. simpl. unfold identity, if_equal. destruct (Nat.eqb i j); lra.
Qed.

Lemma below_bound_sound w rows h : letters (count F) w -> rows_of w rows -> below_bound F u P w rows h = true ->
  leads n 1 T N (real_of u) 0 w.
Proof.
  intros Hw HR H. unfold below_bound in H. destruct w as [|t w']; [discriminate|]. set (w := t :: w') in *.
  split. discriminate. exists 0%nat. split; auto. intros x. fold n in H.
  set (cs := columns n rows) in *.
  set (k := length w) in *.
  assert (D := denominator_positive F WF).
  destruct (positive_form_sound n 0 _ h x H) as [Hf H']. rewrite Rmult_0_l in H'.
  set (a := ((Qnum u * denominator F) ^ (2 * Z.of_nat k))%Z) in *. set (b := (Zpos (Qden u) ^ (2 * Z.of_nat k))%Z) in *.
  rewrite (form_ext n _ (fun i j => IZR a * mr P i j + (- IZR b) * sum n (fun p => mr cs i p * sum n (fun q => mr P p q * mr cs j q)))) in H'.
  2:{ intros i j Hi Hj. rewrite minus_IZR, !mult_IZR. unfold Rminus. rewrite Ropp_mult_distr_l. f_equal. f_equal.
      assert (Lc : (length (nth i cs []) <= n)%nat) by (apply row_length, square_table).
      rewrite (dot_sum n) by auto. apply sum_ext; intros p Hp. unfold mr at 1, entry. f_equal.
      rewrite (nth_map_nil (mv P)) by reflexivity.
      change (IZR (nth p (mv P (nth j cs [])) 0%Z)) with (vr (mv P (nth j cs [])) p).
      rewrite (vr_mv n) by auto. reflexivity. }
  rewrite form_plus, !form_scal, form_image in H'.
  assert (E : forall i, (i < n)%nat -> sum n (fun j => mr cs j i * x j) = IZR (denominator F) ^ k * run n T w x i).
  { intros i Hi. rewrite run_product, <- sum_scal by auto. apply sum_ext; intros j Hj.
    unfold mr, cs, columns. rewrite entry_table, HR by auto. fold k. ring. }
  set (d := IZR (denominator F)) in *.
  replace (form n (mr P) (fun a0 => sum n (fun i => mr cs i a0 * x i))) with (d ^ k * d ^ k * form n (mr P) (run n T w x)) in H'.
  2:{ rewrite <- form_scal. unfold form. apply sum_ext; intros i Hi. apply sum_ext; intros j Hj. rewrite !E by auto. ring. }
  assert (Hdk : 0 < d ^ k) by (apply pow_lt; auto).
  set (q := IZR (Zpos (Qden u))) in *. set (p := IZR (Qnum u)) in *.
  assert (Hq : 0 < q) by (apply IZR_lt; lia). assert (Hqk : 0 < q ^ k) by (apply pow_lt; auto).
  assert (Hp : 0 <= p) by (apply IZR_le; auto).
  assert (Ea : IZR a = p ^ k * p ^ k * (d ^ k * d ^ k)).
  { unfold a. replace (2 * Z.of_nat k)%Z with (Z.of_nat (k + k)) by lia. rewrite <- pow_IZR, mult_IZR. fold p d.
    rewrite pow_add, Rpow_mult_distr. ring. }
  assert (Eb : IZR b = q ^ k * q ^ k).
  { unfold b. replace (2 * Z.of_nat k)%Z with (Z.of_nat (k + k)) by lia. rewrite <- pow_IZR. fold q. apply pow_add. }
  rewrite Ea, Eb in H'.
  assert (Final : form n (mr P) (run n T w x) <= (real_of u ^ k * real_of u ^ k) * form n (mr P) x).
  { assert (Er : real_of u ^ k = p ^ k / q ^ k).
    { unfold real_of. fold p q. unfold Rdiv. rewrite Rpow_mult_distr, pow_inv by lra. reflexivity. }
    rewrite Er. set (fx := form n (mr P) x) in *. set (fy := form n (mr P) (run n T w x)) in *.
    assert (H2 : 0 <= p ^ k * p ^ k * (d ^ k * d ^ k) * fx + - (q ^ k * q ^ k) * (d ^ k * d ^ k * fy)).
    { apply (Rmult_le_reg_l (IZR (root_factor h))); auto. rewrite Rmult_0_r. exact H'. }
    assert (Hpos : 0 < q ^ k * q ^ k * (d ^ k * d ^ k)) by (apply Rmult_lt_0_compat; [exact (Rmult_lt_0_compat _ _ Hqk Hqk) | exact (Rmult_lt_0_compat _ _ Hdk Hdk)]).
    apply (Rmult_le_reg_l _ _ _ Hpos).
    replace (q ^ k * q ^ k * (d ^ k * d ^ k) * (p ^ k / q ^ k * (p ^ k / q ^ k) * fx)) with (p ^ k * p ^ k * (d ^ k * d ^ k) * fx) by (field; lra).
    lra. }
  assert (Hg : 0 <= real_of u ^ k).
  { apply pow_le. unfold real_of. apply Rmult_le_pos; auto. left; apply Rinv_0_lt_compat; auto. }
  unfold N. rewrite <- (sqrt_Rsqr (real_of u ^ k)) by auto. rewrite <- sqrt_mult_alt by apply Rle_0_sqr.
  apply sqrt_le_1_alt. exact Final.
Qed.

Fixpoint shape (t : word_tree) : tree := match t with Word _ => Leaf | Words l => Node (map shape l) end.

Lemma check_tree_sound : forall t w rows, letters (count F) w -> rows_of w rows -> check_tree F u P w rows t = true ->
  good n (count F) 1 T N (real_of u) 0 w (shape t).
Proof.
  fix IH 1. intros t w rows Hw HR H. destruct t as [h|children]; simpl.
  - simpl in H. apply below_bound_sound in H; auto. constructor; auto.
  - simpl in H. apply andb_prop in H. destruct H as [H1 H2]. apply Nat.eqb_eq in H1.
    constructor. rewrite map_length; auto.
    assert (G : forall l off, (off + length l <= count F)%nat ->
      (fix each (k : nat) (l : list word_tree) : bool :=
         match l with [] => true | c :: l' => check_tree F u P (w ++ [k]) (extended F rows k) c && each (S k) l' end) off l = true ->
      forall t child, nth_error (map shape l) t = Some child -> 
      good n (count F) 1 T N (real_of u) 0 (w ++ [(off + t)%nat]) child).
    { clear H1 H2 children. fix IHl 1. intros l off Hl H t child E. destruct l as [|c l]; [destruct t; discriminate|].
      apply andb_prop in H. destruct H as [H1 H2]. destruct t as [|t]; simpl in E.
      - inversion E; subst. rewrite Nat.add_0_r. simpl in Hl. apply (IH c (w ++ [off]) (extended F rows off)); auto.
        apply letters_app; split; auto. constructor; [lia|constructor]. apply rows_of_extended; auto. lia.
      - replace (off + S t)%nat with (S off + t)%nat by lia. apply (IHl l (S off)); auto. simpl in Hl; lia. }
    apply (G children 0%nat); auto. lia.
Qed.
End Sound.

Theorem quadratic_sound F u P definite words : well_formed F = true -> quadratic F u P definite words = true ->
  radius_at_most (size F) (count F) (real F) (real_of u).
Proof.
  intros WF H. unfold quadratic in H. repeat rewrite andb_true_iff in H. destruct H as [[[H1 H2] H3] H4].
  apply Z.leb_le in H1. set (n := size F) in *.
  set (N := fun (_ : nat) x => sqrt (form n (mr P) x)).
  assert (Hr : 0 <= real_of u).
  { unfold real_of. apply Rmult_le_pos. apply IZR_le; auto. left; apply Rinv_0_lt_compat, IZR_lt; lia. }
  set (f := IZR (root_factor definite)).
  assert (Hf : 0 < f) by (apply (positive_form_sound n 1 (entry P) definite zero H3)).
  assert (HP : forall x, sum n (fun i => x i * x i) <= f * form n (mr P) x).
  { intros x. destruct (positive_form_sound n 1 (entry P) definite x H3) as [_ D]. rewrite Rmult_1_l in D. exact D. }
  set (c := sum n (fun i => sum n (fun j => Rabs (mr P i j)))).
  assert (Hsf : 0 < sqrt f) by (apply sqrt_lt_R0; auto).
  assert (Hn : 0 <= INR n) by apply pos_INR.
  assert (Hlow : 0 < / ((INR n + 1) * sqrt f)) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra).
  apply grows_radius, (cuts_bound n (count F) 1 (real F) N (real_of u) (/ ((INR n + 1) * sqrt f)) (sqrt c)); auto.
  - intros x. apply (Rmult_le_reg_l ((INR n + 1) * sqrt f)). apply Rmult_lt_0_compat; lra.
    rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by (apply Rgt_not_eq, Rmult_lt_0_compat; lra).
    assert (B : norm n x <= INR n * (sqrt f * N 0%nat x)).
    { apply sum_bound; intros i Hi. unfold N. rewrite <- sqrt_mult_alt by lra. rewrite <- sqrt_Rsqr_abs.
      apply sqrt_le_1_alt. eapply Rle_trans; [|apply HP]. unfold Rsqr.
      apply (sum_term n (fun i => x i * x i)); auto. intros; apply (Rle_0_sqr (x i0)). }
    assert (0 <= sqrt f * N 0%nat x) by (apply Rmult_le_pos; [lra|apply sqrt_pos]).
    rewrite Rmult_assoc. lra.
  - intros state x _. split. apply sqrt_pos. unfold N. rewrite <- (sqrt_Rsqr (norm n x)) by apply norm_nonneg.
    assert (Hc : 0 <= c). { apply sum_nonneg; intros. apply sum_nonneg; intros. apply Rabs_pos. }
    rewrite <- sqrt_mult_alt by auto. apply sqrt_le_1_alt. unfold c, Rsqr. unfold form.
    rewrite Rmult_comm, <- sum_scal. apply sum_le; intros i Hi. rewrite <- sum_scal. apply sum_le; intros j Hj.
    eapply Rle_trans. apply Rle_abs. rewrite !Rabs_mult. rewrite Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos.
    apply Rmult_le_compat; try apply Rabs_pos; apply norm_term; auto.
  - intros i Hi. replace i with 0%nat by lia. apply good_cuts with (tr := shape words).
    apply (check_tree_sound F u P WF H1 H2) with (rows := table (size F) (fun i j => if_equal i j 1)); auto.
    constructor. apply rows_of_nothing.
Qed.
