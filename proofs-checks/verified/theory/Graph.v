(* Upper bounds by a graph: each state has coordinates, in which steps are matrices with few digits; trees of words lead from
   state to state. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Blocks Integers Sections Eigenvalue.
Import ListNotations.
Open Scope Z_scope.

(* ---- semidefinite matrices: rows from the diagonal on --------------------------------------------------------- *)

(* c A + B *)
Fixpoint add_rows (c : Z) (A B : zmat) : zmat :=
  match A with
  | [] => B
  | a :: A' => match B with [] => addmul c a [] :: add_rows c A' [] | b :: B' => addmul c a b :: add_rows c A' B' end
  end.

(* rows - q q^T *)
Fixpoint less_square (q : zvec) (rows : zmat) : zmat :=
  match q with
  | [] => rows
  | a :: q' =>
      match rows with
      | [] => addmul (- a) q [] :: less_square q' []
      | row :: rows' => addmul (- a) q row :: less_square q' rows'
      end
  end.

(* s and an inner product, without a stack *)
Fixpoint add_dot (s : Z) (x y : zvec) : Z :=
  match x with [] => s | a :: x' => match y with [] => s | b :: y' => add_dot (s + a * b) x' y' end end.

(* The inner products of vectors *)
Fixpoint gram (vectors : list zvec) : zmat :=
  match vectors with [] => [] | x :: vectors' => map (add_dot 0 x) vectors :: gram vectors' end.

(* A multiple of the unit matrix *)
Definition diagonal (n : nat) (a : Z) : zmat := repeat [a] n.

(* The decomposition of Lemma 17 of SPEC.md, of a matrix from whose diagonal n * most has been taken *)
Fixpoint decomposed (n : nat) (most : Z) (rows : zmat) : bool :=
  match rows, n with
  | [], _ => true
  | (x :: row) :: rows', S n' =>
      let root := Z.sqrt x in
      (0 <? x) && (root <=? most) && (length row <=? n')%nat &&
      decomposed n' most (less_square (map (fun a => a / root) row) rows')
  | _, _ => false
  end.

Definition semidefinite (n : nat) (rows : zmat) : bool :=
  forallb (forallb (Z.eqb 0)) rows ||
  let largest := fold_right (fun row most => Z.max (hd 0 row) most) 0 rows in
  let most := 2 ^ 128 * (1 + Z.sqrt_up largest) in
  decomposed n most (add_rows (2 ^ 256) rows (diagonal n (- (Z.of_nat n * most)))).

(* ---- states, steps and trees of words -------------------------------------------------------------------------- *)

(* An element of a group of maps, its inverse, and for each letter t the class of letters s with T_s u = u T_t *)
Record element := Element { action : zmat; undone : zmat; reading : list nat }.

(* A map, and for each element of the group the number of what it is after the map, up to its sign *)
Record turn := Turn { turning : zmat; moved : list nat }.

(* A step to a state turned by a map; its matrix, which stands for one over `unity`, and a bound of the norm *)
Record step := Step { target : nat; turned_by : nat; step_norm : Z; step_matrix : zmat }.

(* Words that begin with a letter: one ends by the step of this number, or all go on by the first step. *)
Inductive branch := Stop (k : nat) | Further (branches : list branch).

(* For each class of letters steps and words *)
Record state := State { coordinates : zmat; steps : list (list step); trees : list branch }.

Section Check.
(* Equal letters are a class, of which `firsts` has the first one. *)
Variables (F : family) (g : Q) (unity : Z) (firsts : list nat) (group : list element) (turns : list turn) (states : list state).
Let n := size F.
Let d := Z.of_nat n.

Definition no_element := Element [] [] [].
Definition no_turn := Turn [] [].
Definition no_state := State [] [] [].
Definition action_of (u : nat) : zmat := action (nth u group no_element).
Definition coordinates_of (j : nat) : zmat := coordinates (nth j states no_state).
Definition unit_matrix : zmat := table n (fun i j => if_equal i j 1).
Definition multiple (s : Z) (A B : zmat) : bool :=
  forallb (fun i => forallb (fun j => entry A i j =? s * entry B i j) (seq 0 n)) (seq 0 n).

Definition element_right (u : element) : bool :=
  square n (action u) && square n (undone u) && multiple 1 (products (action u) (columns n (undone u))) unit_matrix &&
  forallb (fun t =>
    let class := nth t (reading u) 0%nat in
    let first := nth class firsts 0%nat in
    (class <? length firsts)%nat && (first <? count F)%nat &&
    multiple 1 (products (letter F first) (columns n (action u))) (products (action u) (columns n (letter F t)))) (seq 0 (count F)).

Definition turn_right (h : turn) : bool :=
  square n (turning h) &&
  forallb (fun u =>
    let v := nth u (moved h) 0%nat in
    let image := products (turning h) (columns n (action_of u)) in
    (v <? length group)%nat && (multiple 1 (action_of v) image || multiple (-1) (action_of v) image)) (seq 0 (length group)).

Definition step_right (L : zmat) (t : nat) (s : step) : bool :=
  let h := nth (turned_by s) turns no_turn in
  let K := map (mv (coordinates_of (target s))) (columns n (turning h)) in
  let A := map (mv L) (columns n (letter F t)) in
  let B := map (mv (step_matrix s)) K in
  let a := unity * Zpos (Qden g) in
  let b := denominator F * Qnum g in
  let W := map (fun j => addmul a (nth j A []) (addmul (- b) (nth j B []) [])) (seq 0 n) in
  (target s <? length states)%nat && (turned_by s <? length turns)%nat && (0 <=? step_norm s) && square n (step_matrix s) &&
  semidefinite n (add_rows (-1) (gram W) (add_rows ((d * b) * (d * b)) (gram K) [])) &&
  semidefinite n (add_rows (-1) (gram (columns n (step_matrix s))) (diagonal n (step_norm s * step_norm s))).

Definition state_right (s : state) : bool :=
  let L := coordinates s in
  square n L &&
  forallb (fun i => negb (entry L i i =? 0) && forallb (fun j => (j <=? i)%nat || (entry L i j =? 0)) (seq 0 n)) (seq 0 n) &&
  Nat.eqb (length (steps s)) (length firsts) && Nat.eqb (length (trees s)) (length firsts) &&
  forallb (fun c => forallb (step_right L (nth c firsts 0%nat)) (nth c (steps s) [])) (seq 0 (length firsts)).

(* Products over `unity`, each number rounded down, and a number over `unity` rounded up *)
Definition rounded_product (rows columns : zmat) : zmat := map (fun row => map (fun column => add_dot 0 row column / unity) columns) rows.
Definition quotient_up (a : Z) : Z := - (- a / unity).

Definition with_columns (s : step) : step := Step (target s) (turned_by s) (step_norm s) (columns n (step_matrix s)).

(* The steps of each state by classes of letters, their matrices as columns *)
Variable by_state : list (list (list step)).

(* Words have led to the matrix M, whose norm is at most p, with an error of at most e; all of that over `unity`. *)
Fixpoint branch_right (M : zmat) (p e : Z) (here : list step) (b : branch) {struct b} : bool :=
  match match b with Stop k => nth_error here k | Further _ => hd_error here end with
  | None => false
  | Some s =>
      let p' := quotient_up (p * (step_norm s + d)) in
      let e' := quotient_up (e * step_norm s + p * d) + d in
      match b with
      | Stop _ =>
          let c := unity - e' in
          (0 <? c) &&
          decomposed n unity (add_rows (-1) (gram (rounded_product (step_matrix s) M)) (diagonal n (c * c - d * unity)))
      | Further branches =>
          let M' := rounded_product M (step_matrix s) in
          (p' + e' <=? 4 * unity) &&
          (fix each (classes : list (list step)) (l : list branch) {struct l} : bool :=
             match classes, l with
             | [], [] => true
             | class :: classes', b' :: l' => branch_right M' p' e' class b' && each classes' l'
             | _, _ => false
             end) (nth (target s) by_state []) branches
      end
  end.

(* Words of the letter c alone from a state that are `kept` are shown otherwise. *)
Definition words_right (kept : nat -> nat -> bool) (j : nat) : bool :=
  forallb (fun c =>
    if kept j c then true else
    match nth_error (trees (nth j states no_state)) c with
    | None => false
    | Some b => branch_right (table n (fun i j => if_equal i j unity)) unity 0 (nth c (nth j by_state []) []) b
    end) (seq 0 (length firsts)).
End Check.

Definition graph_but (kept : nat -> nat -> bool) (F : family) (g : Q) (unity : Z) (firsts : list nat) (group : list element)
    (turns : list turn) (states : list state) : bool :=
  let by_state := map (fun s => map (map (with_columns F)) (steps s)) states in
  (0 <? Qnum g) && (0 <? unity) && (0 <? length states)%nat && (0 <? length group)%nat &&
  multiple F 1 (action_of group 0) (unit_matrix F) &&
  forallb (element_right F firsts) group && forallb (turn_right F group) turns &&
  forallb (state_right F g unity firsts turns states) states &&
  forallb (words_right F unity firsts states by_state kept) (seq 0 (length states)).

Definition graph (F : family) (u g : Q) (unity : Z) (firsts : list nat) (group : list element) (turns : list turn)
    (states : list state) : bool :=
  Qle_bool g u && graph_but (fun _ _ => false) F g unity firsts group turns states.

(* ---- why that proves the bound: semidefinite matrices ---------------------------------------------------------- *)

Open Scope R_scope.

Definition tail (x : vec) : vec := fun k => x (S k).
Definition squares_of (n : nat) (x : vec) : R := sum n (fun i => x i * x i).

(* r_0 x_0 + r_1 x_1 + ..., the vectors combined likewise, and the form of a symmetric matrix *)
Fixpoint linear (r : zvec) (x : vec) : R := match r with [] => 0 | a :: r' => IZR a * x 0%nat + linear r' (tail x) end.
Fixpoint combined (vectors : list zvec) (x : vec) : vec :=
  match vectors with [] => zero | v :: vectors' => plus (scal (x 0%nat) (vr v)) (combined vectors' (tail x)) end.
Definition row_form (row : zvec) (x : vec) : R := x 0%nat * (2 * linear row x - IZR (hd 0%Z row) * x 0%nat).
Fixpoint rows_form (rows : zmat) (x : vec) : R :=
  match rows with [] => 0 | row :: rows' => row_form row x + rows_form rows' (tail x) end.

Lemma squares_nonneg n x : 0 <= squares_of n x.
Proof. apply sum_nonneg; intros. apply (Rle_0_sqr (x i)). Qed.

Lemma squares_first n x : squares_of (S n) x = x 0%nat * x 0%nat + squares_of n (tail x).
Proof. unfold squares_of. change (S n) with (1 + n)%nat. rewrite sum_add. simpl sum at 1. unfold tail. simpl. lra. Qed.

Lemma linear_addmul c r : forall s x, linear (addmul c r s) x = IZR c * linear r x + linear s x.
Proof.
  induction r; intros s x; simpl. lra. destruct s; simpl; rewrite IHr; simpl; rewrite ?plus_IZR, mult_IZR; lra.
Qed.

Lemma row_form_addmul c r s x : row_form (addmul c r s) x = IZR c * row_form r x + row_form s x.
Proof.
  unfold row_form. rewrite linear_addmul.
  assert (E : IZR (hd 0%Z (addmul c r s)) = IZR c * IZR (hd 0%Z r) + IZR (hd 0%Z s)).
  { rewrite <- mult_IZR, <- plus_IZR. f_equal. destruct r, s; simpl; lia. }
  rewrite E. ring.
Qed.

Lemma add_rows_form c A : forall B x, rows_form (add_rows c A B) x = IZR c * rows_form A x + rows_form B x.
Proof.
  induction A; intros B x; simpl. lra. destruct B; simpl; rewrite IHA, row_form_addmul; simpl; [|lra].
  unfold row_form at 2. simpl. lra.
Qed.

Lemma less_square_form q : forall rows x, rows_form (less_square q rows) x = rows_form rows x - linear q x * linear q x.
Proof.
  induction q as [|a q IH]; intros rows x. simpl; lra.
  assert (E : row_form (a :: q) x = IZR a * (x 0%nat * x 0%nat) + 2 * (x 0%nat * linear q (tail x))) by (unfold row_form; simpl; ring).
  assert (L : linear (a :: q) x = IZR a * x 0%nat + linear q (tail x)) by reflexivity.
  assert (Z : row_form [] x = 0) by (unfold row_form; simpl; ring).
  destruct rows as [|row rows]; cbn [less_square rows_form]; rewrite IH, row_form_addmul, E, L, opp_IZR; simpl rows_form; [rewrite Z|]; ring.
Qed.

Lemma diagonal_form n a : forall x, rows_form (diagonal n a) x = IZR a * squares_of n x.
Proof.
  unfold diagonal. induction n; intros x. unfold squares_of; simpl; ring. rewrite squares_first. simpl. rewrite IHn.
  unfold row_form. simpl. ring.
Qed.

(* Rounding down loses little. *)
Lemma rounded_row root most row : (0 < root)%Z -> (root <= most)%Z -> forall m x0 x, (length row <= m)%nat ->
  - (IZR most * (INR m * (x0 * x0) + squares_of m x)) <=
  2 * (x0 * (linear row x - IZR root * linear (map (fun a => (a / root)%Z) row) x)).
Proof.
  intros Hr Hm. assert (M0 : 0 <= IZR most) by (apply IZR_le; lia).
  induction row as [|a row IH]; intros m x0 x Hl.
  - simpl. assert (S := squares_nonneg m x). assert (0 <= INR m * (x0 * x0)) by (apply Rmult_le_pos; [apply pos_INR|apply (Rle_0_sqr x0)]).
    assert (0 <= IZR most * (INR m * (x0 * x0) + squares_of m x)) by (apply Rmult_le_pos; lra). lra.
  - destruct m; [simpl in Hl; lia|]. simpl length in Hl. specialize (IH m x0 (tail x) ltac:(lia)).
    rewrite squares_first, S_INR. simpl linear.
    set (e := (a - root * (a / root))%Z).
    assert (He : (0 <= e < root)%Z) by (unfold e; assert (D := Z.div_mod a root ltac:(lia)); assert (B := Z.mod_pos_bound a root Hr); lia).
    assert (Ea : IZR a = IZR root * IZR (a / root) + IZR e) by (unfold e; rewrite minus_IZR, mult_IZR; ring).
    assert (E0 : 0 <= IZR e) by (apply IZR_le; lia). assert (E1 : IZR e <= IZR most) by (apply IZR_le; lia).
    rewrite Ea. set (y := x 0%nat).
    assert (P : - (IZR most * (x0 * x0 + y * y)) <= 2 * (x0 * (IZR e * y))).
    { assert (S1 := Rle_0_sqr (x0 + y)). assert (S2 := Rle_0_sqr x0). assert (S3 := Rle_0_sqr y). unfold Rsqr in *.
      assert (IZR e * (x0 * x0 + y * y) <= IZR most * (x0 * x0 + y * y)) by (apply Rmult_le_compat_r; lra).
      assert (0 <= IZR e * ((x0 + y) * (x0 + y))) by (apply Rmult_le_pos; lra). lra. }
    lra.
Qed.

Lemma decomposed_sound n most : (0 <= most)%Z -> forall rows, decomposed n most rows = true -> forall x,
  - (IZR most * (INR n * squares_of n x)) <= rows_form rows x.
Proof.
  intros Hm. assert (M0 : 0 <= IZR most) by (apply IZR_le; auto).
  assert (Nothing : forall k x, - (IZR most * (INR k * squares_of k x)) <= 0).
  { intros k x. assert (0 <= IZR most * (INR k * squares_of k x)); [|lra].
    apply Rmult_le_pos; auto. apply Rmult_le_pos; [apply pos_INR | apply squares_nonneg]. }
  induction n; intros rows H x; (destruct rows as [|row rows]; [apply Nothing|]).
  - destruct row; discriminate.
  - destruct row as [|a row]; [discriminate|]. cbn [decomposed] in H.
    repeat rewrite andb_true_iff in H. destruct H as [[[H1 H2] H3] H4].
    apply Z.ltb_lt in H1. apply Z.leb_le in H2. apply Nat.leb_le in H3.
    set (root := Z.sqrt a) in *. set (q := map (fun a => (a / root)%Z) row) in *.
    destruct (Z.sqrt_spec a ltac:(lia)) as [R1 R2]. fold root in R1, R2.
    assert (Rp : (0 < root)%Z). { assert (0 <= root)%Z by apply Z.sqrt_nonneg. destruct (Z.eq_dec root 0) as [E|]; [|lia]. rewrite E in R2. lia. }
    specialize (IHn _ H4 (tail x)). rewrite less_square_form in IHn.
    assert (B := rounded_row root most row Rp H2 n (x 0%nat) (tail x) H3). fold q in B.
    simpl rows_form. unfold row_form. simpl linear. simpl hd. rewrite squares_first, S_INR.
    set (x0 := x 0%nat) in *. set (l := linear row (tail x)) in *. set (k := linear q (tail x)) in *.
    set (s := squares_of n (tail x)) in *. set (r := rows_form rows (tail x)) in *.
    apply IZR_le in R1. rewrite mult_IZR in R1.
    assert (Sq := Rle_0_sqr (IZR root * x0 + k)). assert (X := Rle_0_sqr x0). unfold Rsqr in *.
    assert (IZR root * IZR root * (x0 * x0) <= IZR a * (x0 * x0)) by (apply Rmult_le_compat_r; auto).
    assert (0 <= IZR most * (x0 * x0)) by (apply Rmult_le_pos; auto).
    lra.
Qed.

Lemma zero_form rows : forallb (forallb (Z.eqb 0)) rows = true -> forall x, rows_form rows x = 0.
Proof.
  induction rows as [|row rows IH]; intros H x; [auto|]. cbn [forallb] in H. apply andb_prop in H. destruct H as [H1 H2].
  cbn [rows_form]. rewrite (IH H2). rewrite forallb_forall in H1.
  assert (L : forall y, linear row y = 0).
  { clear - H1. induction row as [|a row]; intros y; [auto|]. simpl. rewrite IHrow by (intros; apply H1; right; auto).
    rewrite <- (proj1 (Z.eqb_eq 0 a) (H1 a (or_introl eq_refl))). lra. }
  assert (E : hd 0%Z row = 0%Z). { destruct row; auto. symmetry. apply Z.eqb_eq, H1. left; auto. }
  unfold row_form. rewrite L, E. ring.
Qed.

Lemma semidefinite_sound n rows : semidefinite n rows = true -> forall x, 0 <= rows_form rows x.
Proof.
  intros H x. unfold semidefinite in H. apply orb_prop in H. destruct H as [H|H]. rewrite zero_form; auto. lra.
  set (largest := fold_right (fun row most => Z.max (hd 0%Z row) most) 0%Z rows) in *.
  set (most := (2 ^ 128 * (1 + Z.sqrt_up largest))%Z) in *.
  assert (M : (0 <= most)%Z) by (unfold most; assert (0 <= Z.sqrt_up largest)%Z by apply Z.sqrt_up_nonneg; lia).
  apply (decomposed_sound n most M _) with (x := x) in H.
  rewrite add_rows_form, diagonal_form, opp_IZR, mult_IZR, <- INR_IZR_INZ in H.
  assert (P : 0 < IZR (2 ^ 256)) by (apply IZR_lt; reflexivity).
  apply (Rmult_le_reg_l (IZR (2 ^ 256))); auto. lra.
Qed.

(* Inner products: the form is the square of the length. *)
Lemma add_dot_spec x : forall s y, add_dot s x y = (s + dot x y)%Z.
Proof. induction x; intros s [|b y]; simpl; try lia. rewrite IHx. lia. Qed.

Lemma add_dot_0 x : add_dot 0 x = dot x.
Proof. extensionality y. apply add_dot_spec. Qed.

Lemma linear_dots n v vectors : (length v <= n)%nat -> forall x,
  linear (map (dot v) vectors) x = sum n (fun i => vr v i * combined vectors x i).
Proof.
  intros Hv. induction vectors as [|w vectors IH]; intros x; simpl.
  - rewrite sum_zero; auto. intros. unfold zero. ring.
  - rewrite IH, (dot_sum n) by auto. rewrite Rmult_comm, <- sum_scal, <- sum_plus. apply sum_ext; intros. unfold plus, scal, vr. ring.
Qed.

Lemma gram_form n vectors : (forall v, In v vectors -> (length v <= n)%nat) -> forall x,
  rows_form (gram vectors) x = squares_of n (combined vectors x).
Proof.
  induction vectors as [|v vectors IH]; intros H x. simpl. unfold squares_of. rewrite sum_zero; auto. intros; unfold zero; ring.
  cbn [gram rows_form]. rewrite add_dot_0, IH by (intros; apply H; right; auto).
  assert (Hv : (length v <= n)%nat) by (apply H; left; auto).
  unfold row_form. change (hd 0%Z (map (dot v) (v :: vectors))) with (dot v v). rewrite (linear_dots n) by auto.
  rewrite (dot_sum n) by auto. cbn [combined]. set (y := combined vectors (tail x)). unfold squares_of.
  rewrite (sum_ext n (fun i => plus _ _ i * plus _ _ i) (fun i => x 0%nat * (2 * (vr v i * plus (scal (x 0%nat) (vr v)) y i)) +
    ((- (x 0%nat * x 0%nat)) * (vr v i * vr v i) + y i * y i))).
  - rewrite !sum_plus, !sum_scal. unfold vr. ring.
  - intros i Hi. unfold plus, scal. ring.
Qed.

Lemma combined_sum n vectors i : forall x, (length vectors <= n)%nat ->
  combined vectors x i = sum n (fun j => vr (nth j vectors []) i * x j).
Proof.
  revert n. induction vectors as [|v vectors IH]; intros n x H.
  - rewrite sum_zero; auto. intros j Hj. rewrite nth_nil, vr_nil. unfold zero. ring.
  - destruct n; [simpl in H; lia|]. change (S n) with (1 + n)%nat. rewrite sum_add. simpl combined. unfold plus, scal.
    rewrite (IH n) by (simpl in H; lia). unfold tail. simpl. ring.
Qed.

Lemma combined_columns n M x i : (i < n)%nat -> combined (columns n M) x i = apply n (mr M) x i.
Proof.
  intros Hi. rewrite (combined_sum n) by (unfold columns, table; rewrite map_length, seq_length; auto).
  apply sum_ext; intros j Hj. change (vr (nth j (columns n M) []) i) with (IZR (entry (columns n M) j i)).
  unfold columns. rewrite entry_table; auto.
Qed.

Lemma combined_map n L vectors x : square n L = true -> combined (map (mv L) vectors) x = apply n (mr L) (combined vectors x).
Proof.
  intros HL. revert x. induction vectors as [|v vectors IH]; intros x; simpl. symmetry. apply apply_zero.
  rewrite IH, apply_plus, apply_scal, (vr_mv n); auto.
Qed.

Lemma mv_length n L v : square n L = true -> (length (mv L v) <= n)%nat.
Proof. intros H. apply square_spec in H. destruct H as [H _]. destruct v; simpl. lia. rewrite map_length. lia. Qed.

Lemma addmul_length n c x : forall y, (length x <= n)%nat -> (length y <= n)%nat -> (length (addmul c x y) <= n)%nat.
Proof.
  revert n. induction x; intros n y Hx Hy; simpl; auto. destruct n; [simpl in Hx; lia|].
  destruct y; simpl; apply le_n_S, IHx; simpl in *; lia.
Qed.

(* ---- lengths --------------------------------------------------------------------------------------------------- *)

Definition len (n : nat) (x : vec) : R := sqrt (squares_of n x).

Lemma len_nonneg n x : 0 <= len n x.
Proof. apply sqrt_pos. Qed.

Lemma len_ext n x y : (forall i, (i < n)%nat -> x i = y i) -> len n x = len n y.
Proof. intros H. unfold len. f_equal. apply sum_ext; intros. rewrite H; auto. Qed.

Lemma len_scal n c x : len n (scal c x) = Rabs c * len n x.
Proof.
  unfold len. rewrite <- sqrt_Rsqr_abs, <- sqrt_mult_alt by apply Rle_0_sqr. f_equal. unfold squares_of, Rsqr, scal.
  rewrite <- sum_scal. apply sum_ext; intros; ring.
Qed.

Lemma len_last n x : len (S n) x = modulus (len n x) (x n).
Proof. unfold len, modulus. rewrite sqrt_sqrt by apply squares_nonneg. reflexivity. Qed.

Lemma len_plus n x y : len n (plus x y) <= len n x + len n y.
Proof.
  induction n. unfold len, squares_of; simpl. rewrite sqrt_0; lra.
  rewrite !len_last. eapply Rle_trans; [|apply modulus_triangle]. unfold modulus, plus at 2 3. apply sqrt_le_1_alt, Rplus_le_compat_r.
  assert (P := len_nonneg n (plus x y)). apply Rmult_le_compat; auto.
Qed.

Lemma len_le n m c x y : 0 <= c -> squares_of n x <= c * c * squares_of m y -> len n x <= c * len m y.
Proof.
  intros Hc H. unfold len. rewrite <- (sqrt_Rsqr c) by auto. rewrite <- sqrt_mult_alt by apply Rle_0_sqr. apply sqrt_le_1_alt. exact H.
Qed.

Lemma squares_len n x : squares_of n x = len n x * len n x.
Proof. unfold len. rewrite sqrt_sqrt; auto. apply squares_nonneg. Qed.

Lemma coordinate_len n x i : (i < n)%nat -> Rabs (x i) <= len n x.
Proof.
  intros Hi. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. apply (sum_term n (fun i => x i * x i)); auto.
  intros; apply (Rle_0_sqr (x i0)).
Qed.

Lemma len_norm n x : len n x <= norm n x.
Proof.
  rewrite <- (Rmult_1_l (norm n x)). unfold len. rewrite <- (sqrt_Rsqr (1 * norm n x)) by (rewrite Rmult_1_l; apply norm_nonneg).
  apply sqrt_le_1_alt. unfold Rsqr, squares_of. rewrite !Rmult_1_l. unfold norm at 1. rewrite Rmult_comm, <- sum_scal. apply sum_le; intros i Hi.
  assert (A := norm_term n x i Hi). assert (B := Rabs_pos (x i)).
  eapply Rle_trans. apply Rle_abs. rewrite Rabs_mult. apply Rmult_le_compat_r; auto.
Qed.

Lemma norm_len n x : norm n x <= INR n * len n x.
Proof. apply sum_bound; intros. apply coordinate_len; auto. Qed.

Lemma norm_squares n x : norm n x * norm n x <= INR n * squares_of n x.
Proof.
  assert (D : 0 <= sum n (fun i => sum n (fun j => (Rabs (x i) - Rabs (x j)) * (Rabs (x i) - Rabs (x j))))).
  { apply sum_nonneg; intros. apply sum_nonneg; intros. apply (Rle_0_sqr (Rabs (x i) - Rabs (x i0))). }
  assert (C : forall c, sum n (fun _ => c) = INR n * c).
  { intros c. clear. induction n. simpl; lra. rewrite S_INR. simpl. rewrite IHn. lra. }
  rewrite (sum_ext n _ (fun i => (INR n * (x i * x i) + squares_of n x) + (-2) * (norm n x * Rabs (x i)))) in D.
  - rewrite !sum_plus, !sum_scal, C in D. fold (norm n x) in D. change (sum n (fun i => x i * x i)) with (squares_of n x) in D. lra.
  - intros i Hi. assert (Sq : forall a, Rabs a * Rabs a = a * a) by (intros a; rewrite <- Rabs_mult; apply Rabs_pos_eq, (Rle_0_sqr a)).
    rewrite (sum_ext n _ (fun j => (x i * x i + x j * x j) + (-2 * Rabs (x i)) * Rabs (x j))).
    rewrite !sum_plus, C, sum_scal. unfold squares_of, norm. ring.
    intros j Hj. rewrite <- (Sq (x i)), <- (Sq (x j)). ring.
Qed.

(* A matrix with entries between 0 and 1 *)
Lemma fractions_len n (E : mat) x : (forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= E i j <= 1) ->
  len n (apply n E x) <= INR n * len n x.
Proof.
  intros H. apply len_le. apply pos_INR.
  apply Rle_trans with (INR n * (norm n x * norm n x)).
  - unfold squares_of at 1. apply sum_bound; intros i Hi.
    assert (B : Rabs (apply n E x i) <= norm n x).
    { unfold apply. eapply Rle_trans. apply sum_abs. apply sum_le; intros j Hj. rewrite Rabs_mult.
      destruct (H i j Hi Hj). rewrite (Rabs_pos_eq (E i j)) by auto. rewrite <- (Rmult_1_l (Rabs (x j))) at 2. apply Rmult_le_compat_r; auto. apply Rabs_pos. }
    eapply Rle_trans. apply Rle_abs. rewrite Rabs_mult. apply Rmult_le_compat; auto; apply Rabs_pos.
  - rewrite Rmult_assoc. apply Rmult_le_compat_l. apply pos_INR. apply norm_squares.
Qed.

(* ---- triangular matrices --------------------------------------------------------------------------------------- *)

Section Triangular.
Variables (n : nat) (L : mat).
Hypothesis Regular : forall i, (i < n)%nat -> L i i <> 0.
Hypothesis Lower : forall i j, (i < n)%nat -> (j < n)%nat -> (i < j)%nat -> L i j = 0.

Lemma triangular_onto y : exists x, forall i, (i < n)%nat -> apply n L x i = y i.
Proof.
  assert (G : forall k, (k <= n)%nat -> exists x, forall i, (i < k)%nat -> apply n L x i = y i).
  { induction k; intros Hk. exists zero. intros; lia.
    destruct IHk as [x Hx]. lia.
    exists (plus x (scal ((y k - apply n L x k) / L k k) (unit k))). intros i Hi.
    rewrite apply_plus, apply_scal. unfold plus, scal.
    assert (E : apply n L (unit k) i = L i k).
    { unfold apply, unit. rewrite (sum_ext n _ (fun j => identity j k * L i j)) by (intros; ring). apply (sum_identity n k (L i)). lia. }
    rewrite E. destruct (Nat.eq_dec i k) as [->|N].
    - field. apply Regular. lia.
    - rewrite (Lower i k), Hx by lia. ring. }
  apply (G n). lia.
Qed.

Lemma triangular_low : exists C, 0 <= C /\ forall x i, (i < n)%nat -> Rabs (x i) <= C * len n (apply n L x).
Proof.
  assert (G : forall k, (k <= n)%nat -> exists C, 0 <= C /\ forall x i, (i < k)%nat -> Rabs (x i) <= C * len n (apply n L x)).
  { induction k; intros Hk. exists 0. split. lra. intros; lia.
    destruct IHk as [C [HC H]]. lia.
    set (D := / Rabs (L k k) * (1 + C * sum k (fun j => Rabs (L k j)))).
    assert (Lk : 0 < Rabs (L k k)) by (apply Rabs_pos_lt, Regular; lia).
    assert (Sn : 0 <= sum k (fun j => Rabs (L k j))) by (apply sum_nonneg; intros; apply Rabs_pos).
    assert (HD : 0 <= D).
    { unfold D. apply Rmult_le_pos. left; apply Rinv_0_lt_compat; auto. assert (0 <= C * sum k (fun j => Rabs (L k j))) by (apply Rmult_le_pos; auto). lra. }
    exists (C + D). split. lra. intros x i Hi. assert (P := len_nonneg n (apply n L x)).
    destruct (Nat.eq_dec i k) as [->|N].
    2:{ eapply Rle_trans. apply H; lia. apply Rmult_le_compat_r; lra. }
    assert (E : L k k * x k = apply n L x k - sum k (fun j => L k j * x j)).
    { unfold apply. replace n with (k + (1 + (n - k - 1)))%nat at 1 by lia. rewrite !sum_add.
      rewrite (sum_zero (n - k - 1)). simpl sum at 2. rewrite Nat.add_0_r. ring.
      intros j Hj. rewrite Lower by lia. ring. }
    apply Rle_trans with (D * len n (apply n L x)). 2: apply Rmult_le_compat_r; lra.
    apply (Rmult_le_reg_l (Rabs (L k k))); auto. rewrite <- Rabs_mult, E. unfold D.
    replace (Rabs (L k k) * (/ Rabs (L k k) * (1 + C * sum k (fun j => Rabs (L k j))) * len n (apply n L x)))
      with (len n (apply n L x) + sum k (fun j => Rabs (L k j)) * (C * len n (apply n L x))) by (field; lra).
    unfold Rminus. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. apply Rplus_le_compat. apply coordinate_len; lia.
    eapply Rle_trans. apply sum_abs. rewrite Rmult_comm, <- sum_scal. apply sum_le; intros j Hj. rewrite Rabs_mult, Rmult_comm.
    apply Rmult_le_compat_r. apply Rabs_pos. apply H; auto. }
  apply (G n). lia.
Qed.
End Triangular.

(* ---- steps and words ------------------------------------------------------------------------------------------- *)

Lemma multiple_apply F s A B x i : multiple F s A B = true -> (i < size F)%nat ->
  apply (size F) (mr A) x i = IZR s * apply (size F) (mr B) x i.
Proof.
  intros H Hi. unfold multiple in H. rewrite forallb_forall in H. specialize (H i ltac:(apply in_seq; lia)).
  rewrite forallb_forall in H. unfold apply. rewrite <- sum_scal. apply sum_ext; intros j Hj.
  specialize (H j ltac:(apply in_seq; lia)). apply Z.eqb_eq in H. unfold mr. rewrite H, mult_IZR. ring.
Qed.

Lemma unit_matrix_apply F a x i : (i < size F)%nat ->
  apply (size F) (mr (table (size F) (fun i j => if_equal i j a))) x i = IZR a * x i.
Proof.
  intros Hi. unfold apply. rewrite (sum_ext _ _ (fun j => IZR a * (identity j i * x j))).
  rewrite sum_scal, sum_identity; auto. intros j Hj. unfold mr. rewrite entry_table by auto. unfold if_equal, identity.
  rewrite (Nat.eqb_sym j i). destruct (Nat.eqb i j); ring.
Qed.

Lemma nth_forallb {A} (f : A -> bool) l k x : forallb f l = true -> (k < length l)%nat -> f (nth k l x) = true.
Proof. intros H Hk. rewrite forallb_forall in H. apply H, nth_In, Hk. Qed.

Lemma seq_forallb f n k : forallb f (seq 0 n) = true -> (k < n)%nat -> f k = true.
Proof. intros H Hk. rewrite forallb_forall in H. apply H, in_seq. lia. Qed.

Section Sound.
Variables (F : family) (g : Q) (unity : Z) (firsts : list nat) (group : list element) (turns : list turn) (states : list state).
Hypothesis WF : well_formed F = true.
Hypothesis G0 : (0 < Qnum g)%Z.
Hypothesis U0 : (0 < unity)%Z.
Hypothesis Elements : forallb (element_right F firsts) group = true.
Hypothesis Turns : forallb (turn_right F group) turns = true.
Hypothesis States : forallb (state_right F g unity firsts turns states) states = true.
Let n := size F.
Let T := real F.
Let d := Z.of_nat n.
Let U := IZR unity.
Let r := real_of g.

Let act (u : nat) (x : vec) : vec := apply n (mr (action_of group u)) x.
Let place (j : nat) (y : vec) : vec := apply n (mr (coordinates_of states j)) y.
Let at_ (j u : nat) (x : vec) : vec := place j (act u x).

Lemma unity_positive : 0 < U.
Proof. apply IZR_lt; auto. Qed.

Lemma bound_positive : 0 < r.
Proof. unfold r, real_of. apply Rmult_lt_0_compat. apply IZR_lt; auto. apply Rinv_0_lt_compat, IZR_lt. lia. Qed.

(* What is known of elements, turns and states *)
Lemma element_facts u : (u < length group)%nat ->
  square n (action_of group u) = true /\
  (forall y, exists x, forall i, (i < n)%nat -> act u x i = y i) /\
  (forall t, (t < count F)%nat -> exists c, nth t (reading (nth u group no_element)) 0%nat = c /\ (c < length firsts)%nat /\
     (nth c firsts 0%nat < count F)%nat /\
     forall x i, (i < n)%nat -> act u (apply n (T t) x) i = apply n (T (nth c firsts 0%nat)) (act u x) i).
Proof.
  intros Hu. assert (E := nth_forallb _ _ _ no_element Elements Hu). unfold element_right in E.
  repeat rewrite andb_true_iff in E. destruct E as [[[E1 E2] E3] E4].
  fold (action_of group u) in E1, E3, E4. fold n in E1, E2, E3.
  set (e := nth u group no_element) in *. split; [exact E1|split].
  - intros y. exists (apply n (mr (undone e)) y). intros i Hi. unfold act.
    assert (P := apply_products n (action_of group u) (undone e) y i E1 Hi).
    assert (M := multiple_apply F 1 _ _ y i E3 Hi). unfold unit_matrix in M.
    rewrite unit_matrix_apply in M by auto. rewrite <- P. unfold n in *. etransitivity. exact M. ring.
  - intros t Ht. apply (seq_forallb _ _ t) in E4; auto.
    cbv beta zeta in E4. set (c := nth t (reading e) 0%nat) in *. exists c. split; auto.
    repeat rewrite andb_true_iff in E4. destruct E4 as [[C1 C2] C3]. apply Nat.ltb_lt in C1, C2. split; auto. split; auto.
    set (f := nth c firsts 0%nat) in *.
    intros x i Hi. assert (M := multiple_apply F 1 _ _ x i C3 Hi). fold n in M.
    rewrite !apply_products in M by (auto; apply letter_square; auto).
    assert (D := denominator_positive F WF).
    assert (L : forall k y, apply n (mr (letter F k)) y = scal (IZR (denominator F)) (apply n (T k) y)).
    { intros k y. extensionality m. unfold apply, scal, T, real. rewrite <- sum_scal. apply sum_ext; intros. field. lra. }
    rewrite !L, apply_scal in M. unfold scal in M. fold (act u (apply n (T t) x)) in M. fold (act u x) in M.
    apply (Rmult_eq_reg_l (IZR (denominator F))); lra.
Qed.

Lemma turn_facts h u : (h < length turns)%nat -> (u < length group)%nat ->
  let v := nth u (moved (nth h turns no_turn)) 0%nat in
  (v < length group)%nat /\ exists s, (s = 1 \/ s = -1) /\
  forall x i, (i < n)%nat -> apply n (mr (turning (nth h turns no_turn))) (act u x) i = s * act v x i.
Proof.
  intros Hh Hu v. assert (E := nth_forallb _ _ _ no_turn Turns Hh). unfold turn_right in E.
  apply andb_prop in E. destruct E as [E1 E2]. apply (seq_forallb _ _ u) in E2; auto. cbv beta zeta in E2. fold v in E2.
  set (M := turning (nth h turns no_turn)) in *.
  apply andb_prop in E2. destruct E2 as [E2 E3]. apply Nat.ltb_lt in E2. split; auto.
  assert (A : forall x i, (i < n)%nat -> apply n (mr (products M (columns (size F) (action_of group u)))) x i = apply n (mr M) (act u x) i).
  { intros x i Hi. apply apply_products; auto. }
  apply orb_prop in E3. destruct E3 as [E3|E3]; [exists 1 | exists (-1)]; (split; [auto|]); intros x i Hi;
    assert (B := multiple_apply F _ _ _ x i E3 Hi); fold n in B; fold (act v x) in B; rewrite <- A by auto; fold n; rewrite B, ?opp_IZR; ring.
Qed.

Lemma state_facts j : (j < length states)%nat ->
  square n (coordinates_of states j) = true /\
  (forall i, (i < n)%nat -> mr (coordinates_of states j) i i <> 0) /\
  (forall i k, (i < n)%nat -> (k < n)%nat -> (i < k)%nat -> mr (coordinates_of states j) i k = 0) /\
  length (steps (nth j states no_state)) = length firsts /\
  length (trees (nth j states no_state)) = length firsts /\
  forall c s, (c < length firsts)%nat -> In s (nth c (steps (nth j states no_state)) []) ->
    step_right F g unity turns states (coordinates_of states j) (nth c firsts 0%nat) s = true.
Proof.
  intros Hj. assert (E := nth_forallb _ _ _ no_state States Hj). unfold state_right in E.
  repeat rewrite andb_true_iff in E. destruct E as [[[[E1 E2] E3] E4] E5]. apply Nat.eqb_eq in E3, E4.
  split; [exact E1|]. split; [|split; [|split; [auto|split; auto]]].
  - intros i Hi. apply (seq_forallb _ _ i) in E2; auto. apply andb_prop in E2. destruct E2 as [E2 _].
    unfold mr. intros Z. apply eq_IZR in Z. unfold coordinates_of in Z. rewrite Z in E2. discriminate.
  - intros i k Hi Hk L. apply (seq_forallb _ _ i) in E2; auto. apply andb_prop in E2. destruct E2 as [_ E2].
    apply (seq_forallb _ _ k) in E2; auto. apply orb_prop in E2. destruct E2 as [E2|E2]. apply Nat.leb_le in E2. lia.
    apply Z.eqb_eq in E2. unfold mr, coordinates_of. rewrite E2. auto.
  - intros c s Hc Hs. apply (seq_forallb _ _ c) in E5; auto. rewrite forallb_forall in E5. apply E5, Hs.
Qed.

(* One step: U L_j A_t = r (B + E) L_i h *)
Lemma step_facts j t s : (j < length states)%nat -> (t < count F)%nat ->
  step_right F g unity turns states (coordinates_of states j) t s = true ->
  (target s < length states)%nat /\ (turned_by s < length turns)%nat /\ (0 <= step_norm s)%Z /\ square n (step_matrix s) = true /\
  (forall y, len n (apply n (mr (step_matrix s)) y) <= IZR (step_norm s) * len n y) /\
  forall x, let y := place (target s) (apply n (mr (turning (nth (turned_by s) turns no_turn))) x) in
    exists rest, len n rest <= IZR d * len n y /\
    forall i, (i < n)%nat -> U * place j (apply n (T t) x) i = r * (apply n (mr (step_matrix s)) y i + rest i).
Proof.
  intros Hj Ht H. destruct (state_facts j Hj) as [SJ _].
  unfold step_right in H. cbv zeta in H. repeat rewrite andb_true_iff in H. destruct H as [[[[[H1 H2] H3] H4] H5] H6].
  apply Nat.ltb_lt in H1, H2. apply Z.leb_le in H3. fold n in H4, H5, H6. fold d in H5.
  destruct (state_facts _ H1) as [SI _].
  set (h := nth (turned_by s) turns no_turn) in *. set (Li := coordinates_of states (target s)) in *.
  set (Lj := coordinates_of states j) in *. set (B := step_matrix s) in *.
  set (a := (unity * Zpos (Qden g))%Z) in *. set (b := (denominator F * Qnum g)%Z) in *.
  assert (HN : 0 <= IZR (step_norm s)) by (apply IZR_le; auto).
  split; auto. split; auto. split; auto. split; auto. split.
  - intros y. apply len_le; auto. assert (P := semidefinite_sound n _ H6 y).
    rewrite add_rows_form, diagonal_form, mult_IZR, (gram_form n) in P.
    2:{ intros v Hv. apply In_nth with (d := []) in Hv. destruct Hv as [k [_ <-]]. apply row_length, square_table. }
    replace (squares_of n (apply n (mr B) y)) with (squares_of n (combined (columns n B) y)). lra.
    apply sum_ext; intros i Hi. rewrite combined_columns; auto.
  - intros x y.
    set (K := map (mv Li) (columns n (turning h))) in *.
    set (A := map (mv Lj) (columns n (letter F t))) in *.
    set (C := map (mv B) K) in *.
    set (W := map (fun j => addmul a (nth j A []) (addmul (- b) (nth j C []) [])) (seq 0 n)) in *.
    assert (LK : forall v, In v K -> (length v <= n)%nat).
    { intros v Hv. apply in_map_iff in Hv. destruct Hv as [w [<- _]]. apply mv_length; auto. }
    assert (LA : forall M vs v, square n M = true -> In v (map (mv M) vs) -> (length v <= n)%nat).
    { intros M vs v HM Hv. apply in_map_iff in Hv. destruct Hv as [w [<- _]]. apply mv_length; auto. }
    assert (Ln : forall M vs k, square n M = true -> (length (nth k (map (mv M) vs) []) <= n)%nat).
    { intros M vs k HM. destruct (nth_in_or_default k (map (mv M) vs) []) as [I | ->]; [|simpl; lia]. eapply LA; eauto. }
    assert (LW : forall v, In v W -> (length v <= n)%nat).
    { intros v Hv. apply in_map_iff in Hv. destruct Hv as [k [<- _]].
      apply addmul_length. apply Ln; auto. apply addmul_length. apply Ln; auto. simpl; lia. }
    assert (EK : forall i, (i < n)%nat -> combined K x i = y i).
    { intros i Hi. unfold K. rewrite (combined_map n) by auto. unfold y, place. fold Li.
      apply (f_equal (fun f => f i)). apply apply_ext. intros k Hk. apply combined_columns; auto. }
    assert (EA : forall i, (i < n)%nat -> combined A x i = IZR (denominator F) * place j (apply n (T t) x) i).
    { intros i Hi. unfold A. rewrite (combined_map n) by auto. unfold place. fold Lj.
      change (IZR (denominator F) * apply n (mr Lj) (apply n (T t) x) i) with (scal (IZR (denominator F)) (apply n (mr Lj) (apply n (T t) x)) i).
      rewrite <- apply_scal. apply (f_equal (fun f => f i)). apply apply_ext. intros k Hk. rewrite combined_columns by auto.
      assert (D := denominator_positive F WF). unfold apply, scal, T, real. rewrite <- sum_scal. apply sum_ext; intros. field. lra. }
    assert (EC : forall i, (i < n)%nat -> combined C x i = apply n (mr B) y i).
    { intros i Hi. unfold C. rewrite (combined_map n) by auto. apply (f_equal (fun f => f i)). apply apply_ext. exact EK. }
    assert (Length : forall M vs, (length (map (mv M) vs) = length vs)%nat) by (intros; apply map_length).
    assert (Lc : forall M, (length (columns n M) = n)%nat) by (intros; unfold columns, table; rewrite map_length, seq_length; auto).
    assert (EW : forall i, (i < n)%nat -> combined W x i = IZR a * combined A x i - IZR b * combined C x i).
    { intros i Hi. rewrite !(combined_sum n) by (unfold W, A, C, K; rewrite ?map_length, ?seq_length, ?Lc; auto).
      unfold Rminus. rewrite Ropp_mult_distr_l, <- !sum_scal, <- sum_plus. apply sum_ext; intros k Hk.
      unfold W. rewrite (nth_map_seq _ n k) by auto. rewrite !vr_addmul, vr_nil, opp_IZR. unfold plus, scal, zero. ring. }
    assert (D := denominator_positive F WF). set (D0 := IZR (denominator F)) in *.
    set (p := IZR (Qnum g)). set (q := IZR (Zpos (Qden g))).
    assert (Hp : 0 < p) by (apply IZR_lt; auto). assert (Hq : 0 < q) by (apply IZR_lt; lia).
    assert (Ea : IZR a = U * q) by (unfold a; rewrite mult_IZR; auto).
    assert (Eb : IZR b = D0 * p) by (unfold b; rewrite mult_IZR; auto).
    assert (Hb : 0 < IZR b) by (rewrite Eb; apply Rmult_lt_0_compat; auto).
    assert (Hd : 0 <= IZR d) by (apply IZR_le; unfold d; lia).
    exists (scal (/ IZR b) (combined W x)). split.
    + rewrite len_scal, Rabs_pos_eq by (left; apply Rinv_0_lt_compat; auto).
      assert (P := semidefinite_sound n _ H5 x). rewrite !add_rows_form, !(gram_form n) in P by auto.
      rewrite !mult_IZR in P. simpl rows_form in P.
      apply (Rmult_le_reg_l (IZR b)); auto. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra.
      rewrite <- (len_ext n _ _ EK). rewrite <- Rmult_assoc. apply len_le. apply Rmult_le_pos; lra. lra.
    + intros i Hi. unfold scal. rewrite EW, EA, EC, Ea, Eb by auto. unfold r, real_of. fold p q. field. lra.
Qed.

(* Products, rounded down *)
Lemma dot_comm x : forall y, dot x y = dot y x.
Proof. induction x; intros [|b y]; simpl; auto. rewrite IHx. lia. Qed.

Lemma entry_rounded rows cols i j : (i < length rows)%nat -> (j < length cols)%nat ->
  entry (rounded_product unity rows cols) i j = (dot (nth i rows []) (nth j cols []) / unity)%Z.
Proof.
  intros Hi Hj. unfold entry, rounded_product. rewrite <- add_dot_0.
  rewrite (nth_indep _ [] (map (fun column => (add_dot 0 [] column / unity)%Z) cols)) by (rewrite map_length; auto).
  rewrite (map_nth (fun row => map (fun column => (add_dot 0 row column / unity)%Z) cols) rows [] i).
  rewrite (nth_indep _ 0%Z (add_dot 0 (nth i rows []) [] / unity)%Z) by (rewrite map_length; auto).
  apply (map_nth (fun column => (add_dot 0 (nth i rows []) column / unity)%Z)).
Qed.

Lemma columns_length M : length (columns n M) = n.
Proof. unfold columns, table. rewrite map_length, seq_length. auto. Qed.

Lemma rounded_square M B : square n M = true -> square n (rounded_product unity M (columns n B)) = true.
Proof.
  intros H. apply square_spec in H. destruct H as [H _]. apply square_spec. unfold rounded_product. rewrite map_length. split; auto.
  intros row I. apply in_map_iff in I. destruct I as [x [<- _]]. rewrite map_length. apply columns_length.
Qed.

Lemma rounded_error M B y : square n M = true -> exists f, len n f <= IZR d * len n y /\
  forall i, (i < n)%nat -> apply n (mr M) (apply n (mr B) y) i = U * (apply n (mr (rounded_product unity M (columns n B))) y i + f i).
Proof.
  intros H. assert (HU := unity_positive). assert (LM : length M = n) by (apply square_spec in H; tauto).
  set (E := fun i j => IZR (dot (nth i M []) (nth j (columns n B) []) mod unity) / U).
  exists (apply n E y). split.
  - unfold d. rewrite <- INR_IZR_INZ. apply fractions_len. intros i j Hi Hj. unfold E.
    assert (R := Z.mod_pos_bound (dot (nth i M []) (nth j (columns n B) [])) unity U0). destruct R as [R1 R2].
    apply IZR_le in R1. apply IZR_lt in R2. fold U in R2. split.
    + apply Rmult_le_pos; auto. left; apply Rinv_0_lt_compat; auto.
    + apply (Rmult_le_reg_r U); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_l, Rmult_1_r by lra. lra.
  - intros i Hi. rewrite <- apply_products by auto. unfold apply. rewrite <- sum_plus, <- sum_scal. apply sum_ext; intros j Hj.
    rewrite <- Rmult_plus_distr_r, <- Rmult_assoc. f_equal. unfold mr. rewrite entry_rounded by (rewrite ?columns_length; lia).
    assert (Ep : entry (products M (columns n B)) i j = dot (nth i M []) (nth j (columns n B) [])).
    { unfold entry, products. rewrite (nth_indep _ [] (map (dot []) (columns n B))) by (rewrite map_length; lia).
      rewrite (map_nth (fun r => map (dot r) (columns n B))). rewrite nth_map_nil by apply dot_nil. auto. }
    rewrite Ep. unfold E. set (a := dot _ _). rewrite (Z.div_mod a unity) at 1 by lia. rewrite plus_IZR, mult_IZR. fold U. field. lra.
Qed.

Lemma rounded_turned M B y i : square n M = true -> (i < n)%nat ->
  combined (rounded_product unity (columns n B) M) y i = apply n (mr (rounded_product unity M (columns n B))) y i.
Proof.
  intros H Hi. assert (LM : length M = n) by (apply square_spec in H; tauto).
  rewrite (combined_sum n) by (unfold rounded_product; rewrite map_length, columns_length; auto).
  apply sum_ext; intros j Hj. f_equal. change (vr (nth j (rounded_product unity (columns n B) M) []) i) with (IZR (entry (rounded_product unity (columns n B) M) j i)).
  unfold mr. rewrite !entry_rounded, dot_comm by (rewrite ?columns_length; lia). auto.
Qed.

Lemma quotient_up_above a : IZR a <= U * IZR (quotient_up unity a).
Proof.
  unfold quotient_up, U. rewrite <- mult_IZR. apply IZR_le. assert (D := Z.mul_div_le (- a) unity U0). lia.
Qed.

Lemma quotient_up_nonneg a : (0 <= a)%Z -> (0 <= quotient_up unity a)%Z.
Proof. intros H. unfold quotient_up. assert (- a / unity <= 0)%Z; [|lia]. apply Z.div_le_upper_bound; lia. Qed.

(* States turned by elements of the group are numbered. *)
Let m := length group.
Let total := (length states * m)%nat.
Definition state_norm (i : nat) (x : vec) : R :=
  len (size F) (apply (size F) (mr (coordinates_of states (i / length group)))
    (apply (size F) (mr (action_of group (i mod length group))) x)).
Let N := state_norm.
Let from (i : nat) (x : vec) : vec := at_ (i / m) (i mod m) x.

Lemma sign_one s : s = 1 \/ s = -1 -> Rabs s = 1.
Proof. intros [-> | ->]. apply Rabs_R1. rewrite <- abs_IZR. reflexivity. Qed.

Lemma at_plus j u x c y : at_ j u (plus x (scal c y)) = plus (at_ j u x) (scal c (at_ j u y)).
Proof. unfold at_, place, act. rewrite !apply_plus, !apply_scal. auto. Qed.

(* After a word from the state i0 we are at the state j turned by u, with a matrix that is nearly M. *)
Definition follows (i0 : nat) (w : list nat) (j u : nat) (M : zmat) (p e : Z) : Prop :=
  exists s, (s = 1 \/ s = -1) /\ forall x,
    U * len n (from i0 (run n T w x)) <= r ^ length w * (IZR p * len n (at_ j u x)) /\
    len n (plus (scal U (from i0 (run n T w x))) (scal (- (s * r ^ length w)) (apply n (mr M) (at_ j u x)))) <=
      r ^ length w * (IZR e * len n (at_ j u x)).

Lemma step_follows i0 w j u M p e t s : follows i0 w j u M p e -> square n M = true -> (0 <= p)%Z -> (0 <= e)%Z ->
  (j < length states)%nat -> (u < length group)%nat -> (t < count F)%nat ->
  step_right F g unity turns states (coordinates_of states j) (nth (nth t (reading (nth u group no_element)) 0%nat) firsts 0%nat) s = true ->
  let v := nth u (moved (nth (turned_by s) turns no_turn)) 0%nat in
  let p' := quotient_up unity (p * (step_norm s + d)) in
  let e' := (quotient_up unity (e * step_norm s + p * d) + d)%Z in
  (target s < length states)%nat /\ (v < length group)%nat /\ (0 <= p')%Z /\ (0 <= e')%Z /\
  follows i0 (w ++ [t]) (target s) v (rounded_product unity M (columns n (step_matrix s))) p' e'.
Proof.
  intros Hf HM Hp He Hj Hu Ht HS v p' e'.
  destruct (element_facts u Hu) as [_ [Onto Reading]]. destruct (Reading t Ht) as [c [Ec [_ [Hc Move]]]]. rewrite Ec in HS.
  destruct (state_facts j Hj) as [_ [Regular [Lower _]]].
  destruct (step_facts j _ s Hj Hc HS) as [Hi [Hh [Hb [_ [Norm Step]]]]].
  destruct (turn_facts (turned_by s) u Hh Hu) as [Hv [s1 [Hs1 Turned]]]. fold v in Hv, Turned.
  set (i := target s) in *. set (h := turning (nth (turned_by s) turns no_turn)) in *. set (B := step_matrix s) in *.
  set (b := step_norm s) in *.
  assert (Hd : (0 <= d)%Z) by (unfold d; lia).
  assert (Hp' : (0 <= p')%Z) by (apply quotient_up_nonneg, Z.mul_nonneg_nonneg; lia).
  assert (Hq : (0 <= quotient_up unity (e * b + p * d))%Z) by (apply quotient_up_nonneg; apply Z.add_nonneg_nonneg; apply Z.mul_nonneg_nonneg; auto).
  split; auto. split; auto. split; auto. split; [unfold e'; lia|].
  destruct Hf as [s0 [Hs0 Hf]]. exists (s0 * s1). split. { destruct Hs0 as [-> | ->], Hs1 as [-> | ->]; [left|right|right|left]; ring. }
  intros x. rewrite run_app, app_length, pow_add. simpl run. simpl length. rewrite pow_1.
  set (x1 := apply n (T t) x). set (k := length w) in *. set (G := r ^ k) in *.
  set (y := at_ i v x). set (y2 := place i (apply n (mr h) (act u x))).
  assert (Ey : y2 = scal s1 y).
  { unfold y2, y, at_, place. rewrite <- apply_scal. apply apply_ext. intros a Ha. unfold scal. apply Turned; auto. }
  assert (Ly : len n y2 = len n y).
  { rewrite Ey, len_scal, sign_one by auto. ring. }
  destruct (Step (act u x)) as [rest [Lr Er]]. fold y2 in Lr, Er. rewrite Ly in Lr.
  assert (E1 : at_ j u x1 = place j (apply n (T (nth c firsts 0%nat)) (act u x))) by (apply apply_ext; intros; apply Move; auto).
  rewrite <- E1 in Er.
  destruct (triangular_onto n (mr (coordinates_of states j)) Regular Lower (apply n (mr B) y2)) as [zb Hzb].
  destruct (Onto zb) as [xb Hxb].
  assert (Eb : forall a, (a < n)%nat -> at_ j u xb a = apply n (mr B) y2 a).
  { intros a Ha. unfold at_, place. rewrite (apply_ext n _ (act u xb) zb) by auto. auto. }
  destruct (rounded_error M B y2 HM) as [f [Lf Ef]]. rewrite Ly in Lf.
  set (M' := rounded_product unity M (columns n B)) in *.
  assert (HU := unity_positive). assert (Hr := bound_positive).
  assert (HG : 0 < G) by (apply pow_lt; auto).
  set (l := len n y) in *. assert (Hl : 0 <= l) by apply len_nonneg.
  assert (NB := Norm y2). rewrite Ly in NB.
  apply IZR_le in Hp, He, Hb, Hd.
  assert (Ln1 : U * len n (at_ j u x1) <= r * ((IZR b + IZR d) * l)).
  { rewrite <- (Rabs_pos_eq U) at 1 by lra. rewrite <- len_scal.
    rewrite (len_ext n _ (scal r (plus (apply n (mr B) y2) rest))) by (intros a Ha; unfold scal, plus; apply Er; auto).
    rewrite len_scal, (Rabs_pos_eq r) by lra. apply Rmult_le_compat_l. lra. eapply Rle_trans. apply len_plus. lra. }
  split.
  - destruct (Hf x1) as [H1 _].
    assert (Up := quotient_up_above (p * (b + d))). fold p' in Up. rewrite mult_IZR, plus_IZR in Up.
    set (z := len n (from i0 (run n T w x1))) in *. set (l1 := len n (at_ j u x1)) in *.
    apply (Rmult_le_reg_l U); auto.
    apply Rle_trans with (G * (IZR p * (U * l1))). { replace (G * (IZR p * (U * l1))) with (U * (G * (IZR p * l1))) by ring. apply Rmult_le_compat_l; lra. }
    apply Rle_trans with (G * (IZR p * (r * ((IZR b + IZR d) * l)))).
    { apply Rmult_le_compat_l. lra. apply Rmult_le_compat_l; auto. }
    replace (G * (IZR p * (r * ((IZR b + IZR d) * l)))) with (G * r * l * (IZR p * (IZR b + IZR d))) by ring.
    replace (U * (G * r * (IZR p' * l))) with (G * r * l * (U * IZR p')) by ring.
    apply Rmult_le_compat_l; auto. apply Rmult_le_pos; auto. apply Rmult_le_pos; lra.
  - set (x2 := plus x1 (scal (- (r / U)) xb)).
    assert (E2 : from i0 (run n T w x2) = plus (from i0 (run n T w x1)) (scal (- (r / U)) (from i0 (run n T w xb)))).
    { unfold x2. rewrite run_plus, run_scal. apply at_plus. }
    set (z := from i0 (run n T w x1)) in *. set (zb' := from i0 (run n T w xb)) in *.
    destruct (Hf x2) as [D1 _]. rewrite E2 in D1.
    assert (L2 : U * len n (at_ j u x2) <= r * (IZR d * l)).
    { rewrite <- (Rabs_pos_eq U) at 1 by lra. rewrite <- len_scal.
      rewrite (len_ext n _ (scal r rest)).
      - rewrite len_scal, (Rabs_pos_eq r) by lra. apply Rmult_le_compat_l; lra.
      - intros a Ha. unfold x2. rewrite at_plus. unfold plus, scal. rewrite Eb by auto.
        rewrite Rmult_plus_distr_l, Er by auto. field. lra. }
    destruct (Hf xb) as [_ D2]. fold zb' in D2.
    rewrite (apply_ext n (mr M) (at_ j u xb) (apply n (mr B) y2)) in D2 by auto.
    rewrite (len_ext n (at_ j u xb) (apply n (mr B) y2)) in D2 by auto.
    set (first := plus z (scal (- (r / U)) zb')) in *.
    set (second := plus (scal U zb') (scal (- (s0 * G)) (apply n (mr M) (apply n (mr B) y2)))) in *.
    rewrite (len_ext n _ (plus (scal U first) (plus (scal (r / U) second) (scal (s0 * G * r) f)))).
    2:{ intros a Ha. unfold first, second, plus, scal. rewrite Ef by auto. rewrite Ey, apply_scal. unfold scal. field. lra. }
    assert (Hs : Rabs (s0 * G * r) = G * r).
    { rewrite !Rabs_mult, (Rabs_pos_eq G), (Rabs_pos_eq r) by lra. rewrite sign_one by auto. ring. }
    assert (HrU : 0 < r / U) by (apply Rmult_lt_0_compat; auto; apply Rinv_0_lt_compat; auto).
    assert (Sum := len_plus n (scal U first) (plus (scal (r / U) second) (scal (s0 * G * r) f))).
    assert (Sum' := len_plus n (scal (r / U) second) (scal (s0 * G * r) f)).
    rewrite !len_scal, (Rabs_pos_eq (r / U)), Hs in Sum' by lra. rewrite len_scal, (Rabs_pos_eq U) in Sum by lra.
    assert (Up := quotient_up_above (e * b + p * d)). rewrite plus_IZR, !mult_IZR in Up.
    set (q := quotient_up unity (e * b + p * d)) in *.
    assert (A1 : U * len n first <= r / U * (G * (IZR p * (IZR d * l)))).
    { eapply Rle_trans. apply D1. apply (Rmult_le_reg_l U); auto.
      replace (U * (r / U * (G * (IZR p * (IZR d * l))))) with (G * (IZR p * (r * (IZR d * l)))) by (field; lra).
      replace (U * (G * (IZR p * len n (at_ j u x2)))) with (G * (IZR p * (U * len n (at_ j u x2)))) by ring.
      apply Rmult_le_compat_l. lra. apply Rmult_le_compat_l; auto. }
    assert (A2 : r / U * len n second <= r / U * (G * (IZR e * (IZR b * l)))).
    { apply Rmult_le_compat_l. lra. eapply Rle_trans. apply D2. apply Rmult_le_compat_l. lra. apply Rmult_le_compat_l; auto. }
    assert (A3 : G * r * len n f <= G * r * (IZR d * l)) by (apply Rmult_le_compat_l; auto; apply Rmult_le_pos; lra).
    assert (A4 : r / U * (G * (IZR p * (IZR d * l))) + r / U * (G * (IZR e * (IZR b * l))) <= G * r * (IZR q * l)).
    { apply (Rmult_le_reg_l U); auto.
      replace (U * (r / U * (G * (IZR p * (IZR d * l))) + r / U * (G * (IZR e * (IZR b * l)))))
        with (G * r * l * (IZR e * IZR b + IZR p * IZR d)) by (field; lra).
      replace (U * (G * r * (IZR q * l))) with (G * r * l * (U * IZR q)) by ring.
      apply Rmult_le_compat_l; auto. apply Rmult_le_pos; auto. apply Rmult_le_pos; lra. }
    unfold e'. rewrite plus_IZR.
    replace (G * r * ((IZR q + IZR d) * l)) with (G * r * (IZR q * l) + G * r * (IZR d * l)) by ring. lra.
Qed.

(* Where a word ends *)
Lemma follows_leads i0 w j u M p e : follows i0 w j u M p e -> w <> [] -> (j < length states)%nat -> (u < length group)%nat ->
  (forall y, len n (apply n (mr M) y) <= IZR (unity - e) * len n y) -> leads n total T N r i0 w.
Proof.
  intros [s [Hs H]] Hw Hj Hu HM. split; auto. exists (j * m + u)%nat. fold m in Hu. split. { unfold total. nia. }
  intros x. unfold N at 2. unfold state_norm. fold m. rewrite Nat.div_add_l, Nat.div_small, Nat.add_0_r by lia.
  rewrite (Nat.add_comm (j * m)), Nat.mod_add, Nat.mod_small by lia.
  change (len (size F) (apply (size F) (mr (coordinates_of states j)) (apply (size F) (mr (action_of group u)) x))) with (len n (at_ j u x)).
  change (N i0 (run n T w x)) with (len n (from i0 (run n T w x))).
  destruct (H x) as [_ D]. set (z := from i0 (run n T w x)) in *. set (y := at_ j u x) in *. set (G := r ^ length w) in *.
  assert (HU := unity_positive). assert (Hr := bound_positive). assert (HG : 0 < G) by (apply pow_lt; auto).
  specialize (HM y). rewrite minus_IZR in HM. fold U in HM.
  set (rest := plus (scal U z) (scal (- (s * G)) (apply n (mr M) y))) in *.
  apply (Rmult_le_reg_l U); auto. rewrite <- (Rabs_pos_eq U) at 1 by lra. rewrite <- len_scal.
  rewrite (len_ext n _ (plus rest (scal (s * G) (apply n (mr M) y)))) by (intros i Hi; unfold rest, plus, scal; ring).
  eapply Rle_trans. apply len_plus. rewrite len_scal, Rabs_mult, (Rabs_pos_eq G) by lra.
  rewrite sign_one by auto.
  apply Rle_trans with (G * (IZR e * len n y) + G * ((U - IZR e) * len n y)); [|right; ring].
  apply Rplus_le_compat; auto. rewrite Rmult_1_l. apply Rmult_le_compat_l; auto. lra.
Qed.

Lemma end_bounded c M B : (0 < c)%Z -> square n M = true ->
  decomposed n unity (add_rows (-1) (gram (rounded_product unity (columns n B) M)) (diagonal n (c * c - d * unity))) = true ->
  forall y, len n (apply n (mr (rounded_product unity M (columns n B))) y) <= IZR c * len n y.
Proof.
  intros Hc HM H y. assert (LM : length M = n) by (apply square_spec in HM; tauto).
  apply (decomposed_sound n unity) with (x := y) in H; [|lia].
  rewrite add_rows_form, diagonal_form, minus_IZR, !mult_IZR, (gram_form n) in H.
  2:{ intros v Hv. apply in_map_iff in Hv. destruct Hv as [x [<- _]]. rewrite map_length. lia. }
  apply len_le. apply IZR_le; lia.
  replace (squares_of n (apply n (mr (rounded_product unity M (columns n B))) y))
    with (squares_of n (combined (rounded_product unity (columns n B) M) y)).
  2:{ apply sum_ext; intros i Hi. rewrite rounded_turned; auto. }
  unfold d in H. rewrite <- INR_IZR_INZ in H. lra.
Qed.

Fixpoint height (b : branch) : nat :=
  match b with Stop _ => 0%nat | Further l => S (fold_right (fun b h => Nat.max (height b) h) 0%nat l) end.

Lemma branch_all (P : branch -> Prop) : (forall k, P (Stop k)) -> (forall l, Forall P l -> P (Further l)) -> forall b, P b.
Proof.
  intros HS HF. fix IH 1. intros [k|l]. apply HS. apply HF. revert l. fix each 1. intros [|b l]; constructor. apply IH. apply each.
Qed.

Variable by_state : list (list (list step)).
Hypothesis ByState : by_state = map (fun s => map (map (with_columns F)) (steps s)) states.

Lemma by_state_steps j c : (j < length states)%nat ->
  nth c (nth j by_state []) [] = map (with_columns F) (nth c (steps (nth j states no_state)) []) /\
  length (nth j by_state []) = length firsts.
Proof.
  intros Hj. assert (E : nth j by_state [] = map (map (with_columns F)) (steps (nth j states no_state))).
  { rewrite ByState. rewrite (nth_indep _ [] (map (map (with_columns F)) (steps no_state))) by (rewrite map_length; auto).
    apply (map_nth (fun s => map (map (with_columns F)) (steps s))). }
  rewrite E, map_length. split. apply (map_nth (map (with_columns F)) _ []). apply (state_facts j Hj).
Qed.

Lemma taken j c s : (j < length states)%nat -> (c < length firsts)%nat -> In s (nth c (nth j by_state []) []) ->
  exists s', s = with_columns F s' /\ step_right F g unity turns states (coordinates_of states j) (nth c firsts 0%nat) s' = true.
Proof.
  intros Hj Hc I. destruct (by_state_steps j c Hj) as [Here _]. rewrite Here in I. apply in_map_iff in I. destruct I as [s' [<- I]].
  exists s'. split; auto. destruct (state_facts j Hj) as [_ [_ [_ [_ [_ R]]]]]. apply R; auto.
Qed.

Lemma branch_sound i0 : forall b M p e j u t w, follows i0 w j u M p e -> square n M = true -> (0 <= p)%Z -> (0 <= e)%Z ->
  (j < length states)%nat -> (u < length group)%nat -> (t < count F)%nat ->
  branch_right F unity by_state M p e (nth (nth t (reading (nth u group no_element)) 0%nat) (nth j by_state []) []) b = true ->
  cuts n (count F) total T N r i0 (w ++ [t]) (height b).
Proof.
  induction b as [k|branches IH] using branch_all; intros M p e j u t w Hf HM Hp He Hj Hu Ht H;
    destruct (element_facts u Hu) as [_ [_ Reading]]; destruct (Reading t Ht) as [c [Ec [Hc _]]]; rewrite Ec in H;
    assert (Taken := fun s => taken j c s Hj Hc); cbn [branch_right] in H.
  - destruct (nth_error _ k) as [s|] eqn:Es; [|discriminate]. apply nth_error_In, Taken in Es. destruct Es as [s' [-> Hs]].
    rewrite <- Ec in Hs. cbv zeta in H. cbn [step_norm step_matrix with_columns] in H. fold n d in H.
    apply andb_prop in H. destruct H as [H1 H2]. apply Z.ltb_lt in H1.
    destruct (step_follows i0 w j u M p e t s' Hf HM Hp He Hj Hu Ht Hs) as [Hi [Hv [_ [_ Hf']]]].
    intros v Lv _. exists [], v. split; auto. split. simpl; lia. rewrite app_nil_r.
    eapply follows_leads. exact Hf'. destruct w; discriminate. auto. auto.
    apply end_bounded; auto.
  - destruct (hd_error (nth c (nth j by_state []) [])) as [s|] eqn:Es; [|discriminate].
    assert (I : In s (nth c (nth j by_state []) [])) by (destruct (nth c (nth j by_state []) []); [discriminate|]; inversion Es; left; auto).
    apply Taken in I. destruct I as [s' [-> Hs]]. rewrite <- Ec in Hs.
    cbv zeta in H. cbn [step_norm step_matrix target with_columns] in H. fold n d in H.
    apply andb_prop in H. destruct H as [_ H].
    destruct (step_follows i0 w j u M p e t s' Hf HM Hp He Hj Hu Ht Hs) as [Hi [Hv [Hp' [He' Hf']]]].
    set (M' := rounded_product unity M (columns n (step_matrix s'))) in *.
    set (p' := quotient_up unity (p * (step_norm s' + d))) in *.
    set (e' := (quotient_up unity (e * step_norm s' + p * d) + d)%Z) in *.
    set (v := nth u (moved (nth (turned_by s') turns no_turn)) 0%nat) in *.
    assert (HM' : square n M' = true) by (apply rounded_square; auto).
    assert (Each : forall t', (t' < count F)%nat -> cuts n (count F) total T N r i0 ((w ++ [t]) ++ [t']) (fold_right (fun b h => Nat.max (height b) h) 0%nat branches)).
    { intros t' Ht'. destruct (element_facts v Hv) as [_ [_ Reading']]. destruct (Reading' t' Ht') as [c' [Ec' [Hc' _]]].
      assert (Hl : length (nth (target s') by_state []) = length firsts) by apply (by_state_steps (target s') 0 Hi).
      rewrite <- Hl in Hc'.
      rewrite Forall_forall in IH. assert (G : forall l, (forall b, In b l -> In b branches) -> forall classes k, (k < length classes)%nat ->
        (fix each (classes : list (list step)) (l : list branch) {struct l} : bool :=
           match classes with
           | [] => match l with [] => true | _ :: _ => false end
           | class :: classes' => match l with [] => false | b' :: l' => branch_right F unity by_state M' p' e' class b' && each classes' l' end
           end) classes l = true ->
        nth k classes [] = nth c' (nth (target s') by_state []) [] ->
        cuts n (count F) total T N r i0 ((w ++ [t]) ++ [t']) (fold_right (fun b h => Nat.max (height b) h) 0%nat l)).
      { clear H. induction l as [|b' l IHl]; intros Sub classes k Hk H En; destruct classes as [|class classes]; simpl in Hk; try lia; try discriminate.
        apply andb_prop in H. destruct H as [H1 H2]. destruct k as [|k]; simpl in En.
        - apply cuts_le with (d := height b'). 2: simpl; lia.
          apply (IH b' (Sub b' (or_introl eq_refl)) M' p' e' (target s') v t' (w ++ [t])); auto. rewrite Ec', <- En. exact H1.
        - apply cuts_le with (d := fold_right (fun b h => Nat.max (height b) h) 0%nat l). 2: simpl; lia.
          apply (IHl (fun b I => Sub b (or_intror I)) classes k); auto. lia. }
      apply (G branches (fun b I => I) (nth (target s') by_state []) c'); auto. }
    intros z Lz Hz. simpl height in *. destruct z as [|t' z]; [simpl in Hz; lia|].
    destruct (Each t' (Forall_inv Lz) z (Forall_inv_tail Lz) ltac:(simpl in Hz; lia)) as [a [b [E1 [E2 E3]]]].
    exists (t' :: a), b. subst z. rewrite <- app_assoc in E3. split; auto. split. simpl; lia. exact E3.
Qed.

(* ---- seminorms beside the norms -------------------------------------------------------------------------------- *)

Variables (beside : nat -> vec -> R) (rho : R) (kept : nat -> nat -> bool).
Hypothesis Rate : r <= rho.
Hypothesis Beside_ext : forall j x y, (forall i, (i < n)%nat -> x i = y i) -> beside j x = beside j y.
Hypothesis Beside_below : forall j x, (j < length states)%nat -> r * beside j x <= rho * len n (place j x).

Definition larger (j : nat) (x : vec) : R := Rmax (len (size F) (apply (size F) (mr (coordinates_of states j)) x)) (beside j x).
Definition larger_norm (i : nat) (x : vec) : R :=
  larger (i / length group) (apply (size F) (mr (action_of group (i mod length group))) x).

Hypothesis Kept : forall j c, kept j c = true -> (j < length states)%nat -> (c < length firsts)%nat ->
  exists i, (i < length states)%nat /\ forall x, larger j (apply n (T (nth c firsts 0%nat)) x) <= rho * larger i x.

Lemma state_of i : (i < total)%nat -> (i / m < length states)%nat /\ (i mod m < m)%nat.
Proof.
  intros Hi. assert (Hm : (0 < m)%nat) by (unfold total in Hi; destruct m; lia). split.
  apply Nat.div_lt_upper_bound; unfold total in Hi; lia. apply Nat.mod_upper_bound; lia.
Qed.

Lemma larger_norm_between i x : (i < total)%nat -> N i x <= larger_norm i x /\ r * larger_norm i x <= rho * N i x.
Proof.
  intros Hi. assert (Hr := bound_positive). destruct (state_of i Hi) as [Hj _].
  unfold larger_norm, larger. split. apply Rmax_l.
  apply Rmax_case; [|apply Beside_below; auto]. apply Rmult_le_compat_r; auto. apply len_nonneg.
Qed.

Lemma leads_larger i w : (i < total)%nat -> leads n total T N r i w -> leads n total T larger_norm rho i w.
Proof.
  intros Hi [Hw [j [Hj H]]]. split; auto. exists j. split; auto. intros x. assert (Hr := bound_positive).
  destruct (larger_norm_between j x Hj) as [B _]. destruct (larger_norm_between i (run n T w x) Hi) as [_ A].
  assert (P := len_nonneg n (at_ (j / m) (j mod m) x)). change (0 <= N j x) in P. specialize (H x).
  destruct w as [|t w]; [congruence|]. cbn [length pow] in *. set (k := length w) in *.
  assert (R1 : 0 <= r ^ k <= rho ^ k) by (split; [apply pow_le; lra | apply pow_incr; lra]).
  apply (Rmult_le_reg_l r); auto. eapply Rle_trans. apply A.
  apply Rle_trans with (rho * (r * r ^ k * N j x)). apply Rmult_le_compat_l; lra.
  replace (rho * (r * r ^ k * N j x)) with (r * (rho * (r ^ k * N j x))) by ring. apply Rmult_le_compat_l. lra.
  rewrite Rmult_assoc. apply Rmult_le_compat_l. lra. apply Rmult_le_compat; lra.
Qed.

Lemma larger_ext j x y : (forall i, (i < n)%nat -> x i = y i) -> larger j x = larger j y.
Proof. intros E. unfold larger. fold n. rewrite (apply_ext n _ x y), (Beside_ext j x y) by auto. auto. Qed.

(* Of each state turned by each element *)
Lemma words_cut i : (i < total)%nat -> forallb (words_right F unity firsts states by_state kept) (seq 0 (length states)) = true ->
  exists depth, cuts n (count F) total T larger_norm rho i [] depth.
Proof.
  intros Hi H. destruct (state_of i Hi) as [Hj Hu]. set (j := (i / m)%nat) in *. set (u := (i mod m)%nat) in *.
  apply (seq_forallb _ _ j) in H; auto. unfold words_right in H.
  set (l := trees (nth j states no_state)) in *.
  exists (S (fold_right (fun b h => Nat.max (height b) h) 0%nat l)).
  intros v Lv Hv. destruct v as [|t v]; [simpl in Hv; lia|].
  assert (Ht := Forall_inv Lv : (t < count F)%nat). apply Forall_inv_tail in Lv.
  destruct (element_facts u Hu) as [_ [_ Reading]]. destruct (Reading t Ht) as [c [Ec [Hc [_ Move]]]].
  apply (seq_forallb _ _ c) in H; auto. cbv beta in H. destruct (kept j c) eqn:EK.
  { destruct (Kept j c EK Hj Hc) as [k [Hk HK]]. exists [t], v. split; auto. split. simpl; lia. split. discriminate.
    exists (k * m + u)%nat. split. { unfold total. nia. }
    assert (Hm : m <> 0%nat) by lia. intros x. cbn [app run length pow]. unfold larger_norm. fold m j u. rewrite Nat.div_add_l, Nat.div_small, Nat.add_0_r by lia.
    rewrite (Nat.add_comm (k * m)), Nat.mod_add, Nat.mod_small, Rmult_1_r by lia.
    rewrite (larger_ext j _ (apply n (T (nth c firsts 0%nat)) (act u x))) by (intros; apply Move; auto). apply HK. }
  destruct (nth_error l c) as [b|] eqn:Eb; [|discriminate]. fold n in H. rewrite <- Ec in H.
  assert (Hf : follows i [] j u (table n (fun i j => if_equal i j unity)) unity 0).
  { exists 1. split; auto. intros x. simpl run. simpl length. simpl pow. change (from i x) with (at_ j u x). split. fold U. lra.
    rewrite (len_ext n _ (scal 0 x)). rewrite len_scal, Rabs_R0. lra.
    intros k Hk. unfold plus, scal. unfold n. rewrite unit_matrix_apply by auto. fold U. ring. }
  assert (C := branch_sound i b _ _ _ j u t [] Hf (square_table _ _) ltac:(lia) ltac:(lia) Hj Hu Ht H).
  assert (Le : (height b <= fold_right (fun b h => Nat.max (height b) h) 0 l)%nat).
  { apply nth_error_In in Eb. clear - Eb. induction l as [|b' l IH]; [destruct Eb|]. simpl. destruct Eb as [-> | I]. lia. apply IH in I. lia. }
  destruct (C v Lv ltac:(simpl in Hv; lia)) as [a [z [E1 [E2 E3]]]].
  exists (t :: a), z. subst v. split; auto. split. simpl; lia. apply leads_larger; auto.
Qed.

(* Each of the norms is bounded. *)
Lemma norm_high : exists high, forall i x, (i < total)%nat -> 0 <= N i x <= high * norm n x.
Proof.
  assert (Bound : forall A : mat, exists c, 0 <= c /\ forall x, norm n (apply n A x) <= c * norm n x).
  { intros A. exists (sum n (fun k => norm n (apply n A (unit k)))).
    split. apply sum_nonneg; intros; apply norm_nonneg. intros x. apply (run_bound n (fun _ => A) [0%nat] x). intros k Hk. simpl.
    apply (sum_term n (fun k => norm n (apply n A (unit k)))); auto. intros; apply norm_nonneg. }
  generalize total as bound. induction bound as [|bound [high H]]. exists 0. intros; lia.
  destruct (Bound (mr (coordinates_of states (bound / length group)))) as [a [Ha HA]].
  destruct (Bound (mr (action_of group (bound mod length group)))) as [b [Hb HB]].
  exists (Rmax high (a * b)). intros i x Hi. split. apply len_nonneg. assert (P := norm_nonneg n x).
  destruct (Nat.eq_dec i bound) as [->|D].
  - apply Rle_trans with (a * b * norm n x). 2: apply Rmult_le_compat_r; auto; apply Rmax_r.
    unfold N, state_norm. eapply Rle_trans. apply len_norm. fold n. eapply Rle_trans. apply HA. rewrite Rmult_assoc.
    apply Rmult_le_compat_l; auto.
  - eapply Rle_trans. apply H. lia. apply Rmult_le_compat_r; auto. apply Rmax_l.
Qed.

Lemma norm_low : (0 < length states)%nat -> (0 < length group)%nat -> multiple F 1 (action_of group 0) (unit_matrix F) = true ->
  exists low, 0 < low /\ forall x, low * norm n x <= N 0%nat x.
Proof.
  intros HS Hm H. destruct (state_facts 0 HS) as [_ [Regular [Lower _]]].
  destruct (triangular_low n _ Regular Lower) as [C [HC B]].
  assert (Hn : 0 <= INR n) by apply pos_INR.
  assert (P : 0 < INR n * C + 1) by (assert (0 <= INR n * C) by (apply Rmult_le_pos; auto); lra).
  exists (/ (INR n * C + 1)). split. apply Rinv_0_lt_compat; auto. intros x.
  assert (E : N 0%nat x = len n (apply n (mr (coordinates_of states 0)) x)).
  { unfold N, state_norm. rewrite Nat.div_0_l, Nat.mod_0_l by lia. fold n. f_equal. apply apply_ext. intros i Hi.
    assert (M := multiple_apply F 1 _ _ x i H Hi). unfold unit_matrix in M. rewrite unit_matrix_apply in M by auto. unfold n. rewrite M. ring. }
  apply (Rmult_le_reg_l (INR n * C + 1)); auto. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. rewrite E.
  set (l := len n (apply n (mr (coordinates_of states 0)) x)). assert (0 <= l) by apply len_nonneg.
  apply Rle_trans with (INR n * (C * l)). 2: lra.
  apply sum_bound. intros i Hi. apply B; auto.
Qed.
Lemma larger_norm_high : exists high, forall i x, (i < total)%nat -> 0 <= larger_norm i x <= high * norm n x.
Proof.
  destruct norm_high as [high H]. exists (rho / r * high). intros i x Hi. destruct (larger_norm_between i x Hi) as [A B].
  specialize (H i x Hi). assert (Hr := bound_positive). split. lra. apply (Rmult_le_reg_l r); auto. eapply Rle_trans. apply B.
  replace (r * (rho / r * high * norm n x)) with (rho * (high * norm n x)) by (field; lra). apply Rmult_le_compat_l; lra.
Qed.
End Sound.

(* Theorem 29 of SPEC.md, and what Theorem 30 needs of it: seminorms beside the norms of states *)
Theorem graph_but_sound kept F g unity firsts group turns states beside rho : well_formed F = true ->
  graph_but kept F g unity firsts group turns states = true -> real_of g <= rho ->
  (forall j x y, (forall i, (i < size F)%nat -> x i = y i) -> beside j x = beside j y) ->
  (forall j x, (j < length states)%nat ->
     real_of g * beside j x <= rho * len (size F) (apply (size F) (mr (coordinates_of states j)) x)) ->
  (forall j c, kept j c = true -> (j < length states)%nat -> (c < length firsts)%nat -> exists i, (i < length states)%nat /\
     forall x, larger F states beside j (apply (size F) (real F (nth c firsts 0%nat)) x) <= rho * larger F states beside i x) ->
  grows_at_most (size F) (count F) (real F) rho.
Proof.
  intros WF H Le Ext Below Kept. unfold graph_but in H. cbv zeta in H. repeat rewrite andb_true_iff in H.
  destruct H as [[[[[[[[H1 H3] H4] H5] H6] H7] H8] H9] H10].
  apply Z.ltb_lt in H1, H3. apply Nat.ltb_lt in H4, H5.
  assert (Hg : 0 < real_of g) by (eapply bound_positive; eauto).
  set (by_state := map (fun s => map (map (with_columns F)) (steps s)) states) in *.
  destruct (norm_low F g unity firsts group turns states H9 H4 H5 H6) as [low [Hlow Low]].
  destruct (larger_norm_high F g group states H1 beside rho Le Below) as [high High].
  apply (cuts_bound (size F) (count F) (length states * length group) (real F) (larger_norm F group states beside) rho low high); auto.
  - lra.
  - nia.
  - intros x. eapply Rle_trans. apply Low. apply (larger_norm_between F g group states H1 beside rho Le Below). nia.
  - intros i Hi. apply (words_cut F g unity firsts group turns states WF H1 H3 H7 H8 H9 by_state eq_refl beside rho kept Le Ext Below Kept i Hi H10).
Qed.

Theorem graph_sound F u g unity firsts group turns states : well_formed F = true ->
  graph F u g unity firsts group turns states = true -> radius_at_most (size F) (count F) (real F) (real_of u).
Proof.
  intros WF H. apply andb_prop in H. destruct H as [H2 H].
  assert (Le : real_of g <= real_of u).
  { apply Qle_bool_iff in H2. unfold Qle in H2. apply IZR_le in H2. rewrite !mult_IZR in H2. unfold real_of.
    assert (P1 : 0 < IZR (Zpos (Qden g))) by (apply IZR_lt; lia). assert (P2 : 0 < IZR (Zpos (Qden u))) by (apply IZR_lt; lia).
    apply (Rmult_le_reg_r (IZR (Zpos (Qden g)) * IZR (Zpos (Qden u)))). apply Rmult_lt_0_compat; auto.
    replace (IZR (Qnum g) / IZR (Zpos (Qden g)) * (IZR (Zpos (Qden g)) * IZR (Zpos (Qden u)))) with (IZR (Qnum g) * IZR (Zpos (Qden u))) by (field; lra).
    replace (IZR (Qnum u) / IZR (Zpos (Qden u)) * (IZR (Zpos (Qden g)) * IZR (Zpos (Qden u)))) with (IZR (Qnum u) * IZR (Zpos (Qden g))) by (field; lra).
    exact H2. }
  assert (Hg : 0 < real_of g).
  { unfold graph_but in H. cbv zeta in H. repeat rewrite andb_true_iff in H. destruct H as [[[[[[[[H1 _] _] _] _] _] _] _] _].
    apply Z.ltb_lt in H1. eapply bound_positive; eauto. }
  intros x Hx Hx0.
  apply (graph_but_sound (fun _ _ => false) F g unity firsts group turns states (fun _ _ => 0) (real_of g)); auto; try lra.
  - intros j y Hj. rewrite Rmult_0_r. apply Rmult_le_pos. lra. apply len_nonneg.
  - intros j c D. discriminate.
Qed.
