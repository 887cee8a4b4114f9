(* The checker of vectors of functions: sequences of vectors as lists of integers, a space of them that the transitions map to
   itself, its joint spectral radius, and that fixed vectors at the integers are multiples of one. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Integers Sections Check Subdivision Coefficients Grid Refinable Exponent Along.
Import ListNotations.
Open Scope Z_scope.

(* ---- claims ---------------------------------------------------------------------------------------------------------- *)

(* The matrices of the mask, of size functions, from the first one on, over one denominator *)
Record vector_mask := VectorMask { vector_arity : nat; functions : nat; vector_first : Z; of_points : list zmat; vector_common : Z }.
Definition point_matrix (a : vector_mask) : Z -> nat -> nat -> R := fun k c d =>
  (IZR (entry (nth (Z.to_nat (k - vector_first a)) (of_points a) []) c d) / IZR (vector_common a))%R.

Definition vectors_hold (a : vector_mask) (l : Q) : Prop :=
  one_solution (vector_arity a) (functions a) (vector_first a) (length (of_points a) - 1) (point_matrix a) (real_of l).

(* ---- the checker ------------------------------------------------------------------------------------------------------- *)

(* Sequences have their values at the points from window_first on, so many points; those of a point follow each other.
   `fixed` are the values at the integers, `space` is spanned by the lists of `spanning`, `places` tell the coordinates, times
   `place_value`; after so many letters differences of `fixed` of the order are in it. Points from inner_first on, so many, are
   those inside; `kernel` shows that fixed vectors on them are multiples of `fixed`, by the one at `nonzero`. *)
Record vector_certificate := VectorCertificate {
  window_first : Z; window : nat; fixed : list Z; difference_order : nat;
  spanning : list (list Z); places : list nat; place_value : Z; restricted : list zmat; entering : nat;
  inner_first : Z; inner : nat; nonzero : nat; kernel : list (list Z); kernel_scale : Z;
  space_bound : Q; space_radius : certificate }.

Section Sequences.
Variables (A r : nat) (lo : Z) (len : nat) (first : Z) (matrices : list zmat).

Definition block (u : list Z) (i : Z) : list Z := if i <? lo then [] else skipn (Z.to_nat (i - lo) * r) u.
Fixpoint mix_rows (Ms : list zmat) (k : Z) (u : Z -> list Z) (c : nat) : Z :=
  match Ms with [] => 0 | M :: rest => dot (nth c M []) (u k) + mix_rows rest (k + 1) u c end.
Definition move (t : nat) (u : list Z) : list Z :=
  flat_map (fun j => map (mix_rows matrices first (fun k => block u (Z.of_nat A * (lo + Z.of_nat j) + Z.of_nat t - k))) (seq 0 r)) (seq 0 len).
Definition zero_list (l : list Z) : bool := forallb (Z.eqb 0) l.
Definition step_difference (u : list Z) : list Z := addmul (-1) (repeat 0 r ++ u) u.
Fixpoint combine_lists (y : list Z) (b : list (list Z)) : list Z :=
  match y, b with c :: y', x :: b' => addmul c x (combine_lists y' b') | _, _ => [] end.

(* u is in the space, times the place_value; or all of its images by one letter are, and so on *)
Definition in_space (b : list (list Z)) (places : list nat) (place_value : Z) (u : list Z) : bool :=
  zero_list (addmul (- place_value) u (combine_lists (map (fun p => nth p u 0) places) b)).
Fixpoint enters (b : list (list Z)) (places : list nat) (place_value : Z) (n : nat) (u : list Z) : bool :=
  in_space b places place_value u ||
  match n with O => false | S m => forallb (fun t => enters b places place_value m (move t u)) (seq 0 A) end.
End Sequences.

Definition vector_family (a : vector_mask) (c : vector_certificate) : family :=
  Family (length (spanning c)) (vector_common a * place_value c) (restricted c).

Definition checks_space (a : vector_mask) (c : vector_certificate) : bool :=
  let move := move (vector_arity a) (functions a) (window_first c) (window c) (vector_first a) (of_points a) in
  (0 <? place_value c) && (length (restricted c) =? vector_arity a)%nat &&
  forallb (fun t => forallb (fun k =>
    zero_list (addmul (- place_value c) (move t (nth k (spanning c) [])) (combine_lists (map (fun row => nth k row 0) (nth t (restricted c) [])) (spanning c))))
    (seq 0 (length (spanning c)))) (seq 0 (vector_arity a)).

Definition differences_of (a : vector_mask) (c : vector_certificate) : list Z :=
  iterate (difference_order c) (step_difference (functions a)) (fixed c).

Definition checks_start (a : vector_mask) (c : vector_certificate) : bool :=
  let size := (window c * functions a)%nat in
  forallb (fun b => length b <=? size)%nat (fixed c :: spanning c) && zero_list (skipn size (differences_of a c)) &&
  enters (vector_arity a) (functions a) (window_first c) (window c) (vector_first a) (of_points a) (spanning c) (places c) (place_value c) (entering c)
    (firstn size (differences_of a c)).

(* (T_0 - 1) e, times the denominator *)
Definition unfixed (a : vector_mask) (c : vector_certificate) (u : list Z) : list Z :=
  addmul (- vector_common a) u (move (vector_arity a) (functions a) (window_first c) (window c) (vector_first a) (of_points a) 0 u).

Definition checks_kernel (a : vector_mask) (c : vector_certificate) : bool :=
  let n := (inner c * functions a)%nat in let base := (Z.to_nat (inner_first c - window_first c) * functions a)%nat in
  let value q := nth (base + q) (fixed c) 0 in
  (window_first c <=? inner_first c) && ((inner_first c - 1) * (Z.of_nat (vector_arity a) - 1) <=? vector_first a) &&
  (vector_first a + Z.of_nat (length (of_points a) - 1) <=? (inner_first c + Z.of_nat (inner c)) * (Z.of_nat (vector_arity a) - 1)) &&
  (inner_first c + Z.of_nat (inner c) <=? window_first c + Z.of_nat (window c)) && (nonzero c <? n)%nat && negb (value (nonzero c) =? 0) && negb (kernel_scale c =? 0) &&
  forallb (fun q => let column := unfixed a c (unit_at 1 (base + q)) in
    forallb (fun i => dot (firstn (window c * functions a) (nth i (kernel c) [])) column =? kernel_scale c *
      ((if (i =? q)%nat then value (nonzero c) else 0) - (if (q =? nonzero c)%nat then value i else 0))) (seq 0 n)) (seq 0 n).

Definition vector_space (a : vector_mask) (c : vector_certificate) : bool :=
  let A := Z.of_nat (vector_arity a) in let high := window_first c + Z.of_nat (window c) - 1 in
  (2 <=? vector_arity a)%nat && (0 <? vector_common a) && (1 <=? length (of_points a))%nat && (1 <=? functions a)%nat &&
  forallb (square (functions a)) (of_points a) &&
  ((A - 1) * window_first c <=? vector_first a) && (vector_first a + Z.of_nat (length (of_points a) - 1) <=? (A - 1) * high) &&
  zero_list (unfixed a c (fixed c)) && checks_space a c && checks_start a c && checks_kernel a c.

(* A radius of at most bound is at most arity^(-l), and l at most the order of the differences. *)
Definition vector_power (a : vector_mask) (l : Q) (order : nat) (bound : Q) : bool :=
  below_power (Scheme (vector_arity a) 0 [] 1) l order (Qmake (Z.of_nat (vector_arity a) ^ Z.of_nat order * Qnum bound) (Qden bound)).

Definition vector_reduces (a : vector_mask) (l : Q) (c : vector_certificate) : bool :=
  vector_space a c && vector_power a l (difference_order c) (space_bound c).

Definition check_vectors (a : vector_mask) (l : Q) (c : vector_certificate) : bool :=
  vector_reduces a l c && check_radius (Claim (vector_family a c) None (Some (space_bound c))) (space_radius c).

(* ---- sequences --------------------------------------------------------------------------------------------------------- *)

Open Scope R_scope.

Lemma nth_skipn_at (l : list Z) n d : nth d (skipn n l) 0%Z = nth (n + d) l 0%Z.
Proof. revert l. induction n; intros l; simpl; auto. destruct l; simpl; auto. destruct d; auto. Qed.

Lemma zero_list_vr l : zero_list l = true -> forall i, vr l i = 0.
Proof.
  intros H i. unfold zero_list in H. rewrite forallb_forall in H. unfold vr. destruct (Nat.lt_ge_cases i (length l)).
  - assert (E := H _ (nth_In l 0%Z H0)). apply Z.eqb_eq in E. rewrite <- E. auto.
  - rewrite nth_overflow; auto.
Qed.

Lemma combine_lists_vr y : forall b i, vr (combine_lists y b) i = sum (length b) (fun k => IZR (nth k y 0%Z) * vr (nth k b []) i).
Proof.
  induction y as [|c y IH]; intros b i.
  - rewrite sum_zero. unfold vr. simpl. destruct i; auto. intros k _. destruct k; simpl; ring.
  - destruct b as [|x b]. unfold vr. simpl. destruct i; auto. cbn [combine_lists length].
    rewrite vr_addmul. unfold plus, scal. rewrite IH. change (S (length b)) with (1 + length b)%nat. rewrite sum_add. cbn [sum]. simpl nth. ring.
Qed.

(* Places before and behind those inside, and points that are no inner ones *)
Lemma place_before x y r k q : (x < y)%nat -> (k < r)%nat -> (x * r + k)%nat <> (y * r + q)%nat.
Proof. intros H Hk. assert (S x * r <= y * r)%nat by (apply Nat.mul_le_mono_r; lia). simpl in H0. lia. Qed.

Lemma place_behind x y n r k q : (y + n <= x)%nat -> (q < n * r)%nat -> (x * r + k)%nat <> (y * r + q)%nat.
Proof. intros H Hq. assert ((y + n) * r <= x * r)%nat by (apply Nat.mul_le_mono_r; lia). rewrite Nat.mul_add_distr_r in H0. lia. Qed.

Lemma place_inside x n r k : (x < n)%nat -> (k < r)%nat -> (x * r + k < n * r)%nat.
Proof. intros H Hk. assert (S x * r <= n * r)%nat by (apply Nat.mul_le_mono_r; lia). simpl in H0. lia. Qed.

Lemma place_fits y n r q len : (y + n <= len)%nat -> (q < n * r)%nat -> (y * r + q + 1 <= len * r)%nat.
Proof. intros H Hq. assert ((y + n) * r <= len * r)%nat by (apply Nat.mul_le_mono_r; lia). rewrite Nat.mul_add_distr_r in H0. lia. Qed.

Lemma point_before A i p F : (2 <= A)%nat -> (i < p)%Z -> ((p - 1) * (Z.of_nat A - 1) <= F)%Z -> ((Z.of_nat A - 1) * i <= F)%Z.
Proof. intros HA Hi H. assert ((Z.of_nat A - 1) * i <= (Z.of_nat A - 1) * (p - 1))%Z by (apply Z.mul_le_mono_nonneg_l; lia). lia. Qed.

Lemma point_behind A i p F : (2 <= A)%nat -> (p <= i)%Z -> (F <= p * (Z.of_nat A - 1))%Z -> (F <= (Z.of_nat A - 1) * i)%Z.
Proof. intros HA Hi H. assert ((Z.of_nat A - 1) * p <= (Z.of_nat A - 1) * i)%Z by (apply Z.mul_le_mono_nonneg_l; lia). lia. Qed.

Section Real.
Variables (a : vector_mask) (c : vector_certificate).
Let A := vector_arity a.
Let r := functions a.
Let F := vector_first a.
Let L := (length (of_points a) - 1)%nat.
Let lo := window_first c.
Let len := window c.
Let e := vector_common a.
Let size := (len * r)%nat.
Hypothesis Arity : (2 <= A)%nat.
Hypothesis Common : (0 < e)%Z.
Hypothesis Points : (1 <= length (of_points a))%nat.
Hypothesis Positive : (1 <= r)%nat.
Hypothesis Square : forallb (square r) (of_points a) = true.
Hypothesis Low : ((Z.of_nat A - 1) * lo <= F)%Z.
Hypothesis High : (F + Z.of_nat L <= (Z.of_nat A - 1) * (lo + Z.of_nat len - 1))%Z.

Definition place (i : Z) (k : nat) : nat := (Z.to_nat (i - window_first c) * functions a + k)%nat.
Definition sequence (u : list Z) : Z -> nat -> R := fun i k => if (i <? window_first c)%Z then 0 else vr u (place i k).
Notation moved_list := (move A r lo len F (of_points a)).
Notation moved_by := (transit A r F L (point_matrix a)).

Lemma common_real : 0 < IZR e.
Proof. apply IZR_lt. auto. Qed.

Lemma sequence_outside u i k : (length u <= size)%nat -> (k < r)%nat -> (i < lo \/ lo + Z.of_nat len <= i)%Z -> sequence u i k = 0.
Proof.
  intros Hu Hk Hi. unfold sequence. fold lo. destruct (Z.ltb_spec i lo); auto. unfold vr, place. fold lo r. rewrite nth_overflow; auto.
  eapply Nat.le_trans. apply Hu. unfold size. assert (len <= Z.to_nat (i - lo))%nat by lia. nia.
Qed.

Lemma block_row M k i u : square r M = true -> (k < r)%nat ->
  IZR (dot (nth k M []) (block r lo u i)) = sum r (fun d => IZR (entry M k d) * sequence u i d).
Proof.
  intros HM Hk. apply square_spec in HM. destruct HM as [HM Hr].
  rewrite (dot_sum r). 2: { rewrite (Hr (nth k M [])). auto. apply nth_In. rewrite HM. auto. }
  apply sum_ext; intros d Hd. unfold block, sequence, entry. fold lo. destruct (i <? lo)%Z.
  - destruct d; simpl; ring.
  - rewrite nth_skipn_at. reflexivity.
Qed.

Lemma mix_rows_real Ms : (forall M, In M Ms -> square r M = true) -> forall k (u : Z -> list Z) v d, (d < r)%nat ->
  (forall M i, square r M = true -> IZR (dot (nth d M []) (u i)) = sum r (fun d' => IZR (entry M d d') * v i d')) ->
  IZR (mix_rows Ms k u d) = sum (length Ms) (fun m => sum r (fun d' => IZR (entry (nth m Ms []) d d') * v (k + Z.of_nat m)%Z d')).
Proof.
  induction Ms as [|M Ms IH]; intros HM k u v d Hd H. reflexivity.
  cbn [mix_rows length]. rewrite plus_IZR, (IH (fun M' I => HM M' (or_intror I)) (k + 1)%Z u v d Hd H), (H M) by (apply HM; left; auto).
  change (S (length Ms)) with (1 + length Ms)%nat. rewrite sum_add. cbn [sum]. rewrite Rplus_0_l. f_equal.
  - apply sum_ext; intros d' _. simpl nth. do 2 f_equal. lia.
  - apply sum_ext; intros m _. apply sum_ext; intros d' _. simpl nth. do 2 f_equal. lia.
Qed.

(* One transition *)
Lemma move_real t u j k : (length u <= size)%nat -> (t < A)%nat -> (k < r)%nat ->
  sequence (moved_list t u) j k = IZR e * moved_by t (sequence u) j k.
Proof.
  intros Hu Ht Hk. assert (E0 := common_real).
  assert (Out : (j < lo \/ lo + Z.of_nat len <= j)%Z -> moved_by t (sequence u) j k = 0).
  { intros Hj. apply mix_zero. intros m d Hm Hd. apply sequence_outside; auto. destruct Hj as [Hj|Hj]; [left|right]; nia. }
  assert (Len : length (moved_list t u) = size).
  { unfold move. rewrite (length_flat_map _ r), seq_length. reflexivity. intros x _. rewrite map_length, seq_length. auto. }
  destruct (Z_lt_ge_dec j lo) as [J|J]; [|destruct (Z_lt_ge_dec j (lo + Z.of_nat len)) as [J'|J']].
  - rewrite Out, sequence_outside by (auto; lia). ring.
  - unfold sequence at 1. fold lo. destruct (Z.ltb_spec j lo); [lia|]. unfold vr, place. fold lo r. unfold move.
    set (q := Z.to_nat (j - lo)). rewrite (nth_flat_map _ r O); auto.
    2: { intros. rewrite map_length, seq_length. auto. }
    2: { rewrite seq_length. unfold q. lia. }
    rewrite seq_nth by (unfold q; lia). rewrite nth_map_seq by auto. rewrite Nat.add_0_l. replace (lo + Z.of_nat q)%Z with j by (unfold q; lia).
    rewrite forallb_forall in Square.
    rewrite (mix_rows_real (of_points a) Square F (fun k => block r lo u (Z.of_nat A * j + Z.of_nat t - k)%Z) (fun i d => sequence u (Z.of_nat A * j + Z.of_nat t - i)%Z d) k Hk).
    + unfold transit, mix. replace (S L) with (length (of_points a)) by (unfold L; lia). rewrite <- sum_scal.
      apply sum_ext; intros m _. cbv zeta. rewrite <- sum_scal. apply sum_ext; intros d _. unfold point_matrix. fold F e.
      replace (Z.to_nat (F + Z.of_nat m - F)) with m by lia. field. lra.
    + intros M i HM. apply block_row; auto.
  - rewrite Out, sequence_outside by (auto; lia). ring.
Qed.

Lemma sequence_addmul z u v i k : sequence (addmul z u v) i k = IZR z * sequence u i k + sequence v i k.
Proof. unfold sequence. destruct (i <? window_first c)%Z. ring. rewrite vr_addmul. reflexivity. Qed.

Lemma sequence_zero l i k : zero_list l = true -> sequence l i k = 0.
Proof. intros H. unfold sequence. destruct (i <? window_first c)%Z; auto. apply zero_list_vr. auto. Qed.

Lemma sequence_combine y b i k : sequence (combine_lists y b) i k = sum (length b) (fun l => IZR (nth l y 0%Z) * sequence (nth l b []) i k).
Proof.
  unfold sequence. destruct (i <? window_first c)%Z. symmetry. apply sum_zero. intros; ring. apply combine_lists_vr.
Qed.

Lemma sequence_difference u i k : (k < r)%nat -> sequence (step_difference r u) i k = difference (sequence u) i k.
Proof.
  intros Hk. unfold step_difference. rewrite sequence_addmul. unfold difference.
  replace (sequence (repeat 0%Z r ++ u) i k) with (sequence u (i - 1)%Z k). simpl IZR. ring.
  unfold sequence, vr, place. fold lo r. destruct (Z.ltb_spec i lo), (Z.ltb_spec (i - 1) lo); try lia; auto.
  - replace (Z.to_nat (i - lo)) with O by lia. rewrite Nat.mul_0_l, Nat.add_0_l, app_nth1 by (rewrite repeat_length; auto). rewrite nth_zeros. auto.
  - replace (Z.to_nat (i - lo)) with (S (Z.to_nat (i - 1 - lo))) by lia. rewrite Nat.mul_succ_l.
    generalize (Z.to_nat (i - 1 - lo) * r)%nat. intros q. rewrite app_nth2, repeat_length by (rewrite repeat_length; lia).
    do 2 f_equal. lia.
Qed.

Lemma sequence_differences u m : forall i k, (k < r)%nat ->
  sequence (iterate m (step_difference r) u) i k = vector_differences m (sequence u) i k.
Proof.
  induction m; intros i k Hk; auto. cbn [iterate vector_differences]. rewrite sequence_difference by auto. unfold difference. rewrite !IHm; auto.
Qed.

(* ---- what the checker computes ----------------------------------------------------------------------------------------- *)

Lemma moved_length t u : length (moved_list t u) = size.
Proof. unfold move. rewrite (length_flat_map _ r), seq_length. reflexivity. intros x _. rewrite map_length, seq_length. auto. Qed.

Let N := length (spanning c).
Let b (k : nat) : Z -> nat -> R := sequence (nth k (spanning c) []).
Let T := vector_family a c.

Hypothesis Short : forallb (fun b => length b <=? size)%nat (fixed c :: spanning c) = true.

Lemma short_basis k : (k < N)%nat -> (length (nth k (spanning c) []) <= size)%nat.
Proof.
  intros H. rewrite forallb_forall in Short. apply Nat.leb_le. apply Short. right. apply nth_In. auto.
Qed.

Lemma short_fixed : (length (fixed c) <= size)%nat.
Proof. rewrite forallb_forall in Short. apply Nat.leb_le. apply Short. left. auto. Qed.

Hypothesis Space : checks_space a c = true.

Lemma space_pivot : (0 < place_value c)%Z.
Proof. unfold checks_space in Space. rewrite !andb_true_iff in Space. destruct Space as [[H _] _]. apply Z.ltb_lt. auto. Qed.

Lemma space_count : count T = A.
Proof. unfold checks_space in Space. rewrite !andb_true_iff in Space. destruct Space as [[_ H] _]. apply Nat.eqb_eq in H. exact H. Qed.

Lemma space_invariant t k : (t < A)%nat -> (k < N)%nat -> forall j d, (d < r)%nat ->
  moved_by t (b k) j d = sum N (fun l => real T t l k * b l j d).
Proof.
  intros Ht Hk j d Hd. assert (E0 := common_real). assert (P0 : 0 < IZR (place_value c)) by (apply IZR_lt, space_pivot).
  unfold checks_space in Space. rewrite !andb_true_iff in Space. destruct Space as [_ H].
  rewrite forallb_forall in H. specialize (H t ltac:(apply in_seq; fold A; lia)). rewrite forallb_forall in H.
  specialize (H k ltac:(apply in_seq; fold N; lia)). fold A r lo len F in H.
  assert (Z0 := sequence_zero _ j d H). rewrite sequence_addmul, sequence_combine, opp_IZR in Z0.
  rewrite move_real in Z0 by (auto; apply short_basis; auto). fold (b k) in Z0.
  apply (Rmult_eq_reg_l (IZR e * IZR (place_value c))). 2: { apply Rmult_integral_contrapositive; split; lra. }
  rewrite <- sum_scal. fold N in Z0.
  rewrite (sum_ext N (fun i => IZR e * IZR (place_value c) * (real T t i k * b i j d))
    (fun l => IZR (nth l (map (fun row => nth k row 0%Z) (nth t (restricted c) [])) 0%Z) * sequence (nth l (spanning c) []) j d)).
  - lra.
  - intros l Hl. unfold real, mr, letter, entry, T, vector_family. cbn [matrices denominator].
    rewrite (nth_map_nil (fun row => nth k row 0%Z)) by (destruct k; auto). fold e. rewrite mult_IZR. fold (b l). field. lra.
Qed.

Lemma in_space_span u : in_space (spanning c) (places c) (place_value c) u = true -> exists y, forall j d, sequence u j d = span N b y j d.
Proof.
  intros H. assert (P0 : 0 < IZR (place_value c)) by (apply IZR_lt, space_pivot). unfold in_space in H.
  exists (fun k => IZR (nth k (map (fun p => nth p u 0%Z) (places c)) 0%Z) / IZR (place_value c)). intros j d.
  assert (Z0 := sequence_zero _ j d H). rewrite sequence_addmul, sequence_combine, opp_IZR in Z0. fold N in Z0.
  apply (Rmult_eq_reg_l (IZR (place_value c))). 2: lra. unfold span. rewrite <- sum_scal.
  rewrite (sum_ext N (fun i => IZR (place_value c) * (IZR (nth i (map (fun p => nth p u 0%Z) (places c)) 0%Z) / IZR (place_value c) * b i j d))
    (fun l => IZR (nth l (map (fun p => nth p u 0%Z) (places c)) 0%Z) * sequence (nth l (spanning c) []) j d)).
  - lra.
  - intros l Hl. unfold b. field. lra.
Qed.

Lemma span_scal z y j d : z * span N b y j d = span N b (fun k => z * y k) j d.
Proof. unfold span. rewrite <- sum_scal. apply sum_ext. intros. ring. Qed.

(* `enters` looks at numerators; it does not matter by which number they are divided. *)
Lemma enters_span n : forall u, (length u <= size)%nat -> enters A r lo len F (of_points a) (spanning c) (places c) (place_value c) n u = true ->
  forall z w, letters A w -> length w = n -> exists y, forall j d, (d < r)%nat ->
  after A r F L (point_matrix a) w (fun i k => z * sequence u i k) j d = span N b y j d.
Proof.
  assert (E0 := common_real). induction n; intros u Hu H z w Hw Hl; cbn [enters] in H; apply orb_prop in H.
  - destruct w; [|discriminate]. destruct H as [H|H]; [|discriminate]. destruct (in_space_span u H) as [y Hy].
    exists (fun k => z * y k). intros j d _. cbn [after]. rewrite Hy. apply span_scal.
  - destruct H as [H|H].
    + destruct (in_space_span u H) as [y Hy]. exists (run N (real T) w (fun k => z * y k)). intros j d Hd.
      apply (after_span A r F L (point_matrix a) N b (real T)); auto using space_invariant.
      intros i k _. rewrite Hy. apply span_scal.
    + destruct (exists_last (l := w)) as [v [t ->]]. { intros ->. discriminate. }
      apply letters_app in Hw. destruct Hw as [Hv Ht]. inversion Ht; subst. rewrite app_length in Hl. simpl in Hl.
      rewrite forallb_forall in H. specialize (H t ltac:(apply in_seq; lia)).
      destruct (IHn (moved_list t u) ltac:(rewrite moved_length; auto) H (z / IZR e) v Hv ltac:(lia)) as [y Hy].
      exists y. intros j d Hd. rewrite <- Hy, after_app by auto. cbn [after]. revert j d Hd.
      assert (X : forall i k, (k < r)%nat -> moved_by t (fun i k => z * sequence u i k) i k = z / IZR e * sequence (moved_list t u) i k).
      { intros i k Hk. rewrite move_real by auto. unfold transit. rewrite mix_scal. field. lra. }
      clear - X Arity. induction v as [|s v IH]; intros j d Hd; cbn [after]; auto.
      unfold transit at 1 3. apply mix_ext. intros. apply IH; auto.
Qed.

(* ---- the theorem ----------------------------------------------------------------------------------------------------------- *)

Hypothesis Fixed : zero_list (unfixed a c (fixed c)) = true.
Let v := sequence (fixed c).

Lemma unfixed_real u i k : (length u <= size)%nat -> (k < r)%nat ->
  sequence (unfixed a c u) i k = IZR e * (moved_by 0 (sequence u) i k - sequence u i k).
Proof.
  intros Hu Hk. unfold unfixed. fold A r lo len F e. rewrite sequence_addmul, opp_IZR, move_real by (auto; lia). ring.
Qed.

Lemma values_fixed i k : (k < r)%nat -> moved_by 0 v i k = v i k.
Proof.
  intros Hk. assert (E0 := common_real). assert (Z0 := sequence_zero _ i k Fixed). rewrite unfixed_real in Z0 by (auto using short_fixed).
  apply Rmult_integral in Z0. destruct Z0 as [Z0|Z0]. lra. unfold v. lra.
Qed.

Lemma values_outside i k : (k < r)%nat -> (i < lo \/ lo + Z.of_nat len - 1 < i)%Z -> v i k = 0.
Proof. intros Hk Hi. apply sequence_outside; auto using short_fixed. lia. Qed.

Lemma sequence_bounded u : exists B, forall i k, Rabs (sequence u i k) <= B.
Proof.
  exists (sum (length u) (fun n => Rabs (vr u n))). intros i k.
  assert (S0 : 0 <= sum (length u) (fun n => Rabs (vr u n))) by (apply sum_nonneg; intros; apply Rabs_pos).
  unfold sequence. destruct (i <? window_first c)%Z. rewrite Rabs_R0. auto.
  destruct (Nat.lt_ge_cases (place i k) (length u)).
  - apply (sum_term (length u) (fun n => Rabs (vr u n))); auto. intros; apply Rabs_pos.
  - unfold vr at 1. rewrite nth_overflow, Rabs_R0; auto.
Qed.

Lemma basis_bounded : exists P, forall k, (k < N)%nat -> forall j d, (d < r)%nat -> Rabs (b k j d) <= P.
Proof.
  unfold N, b. generalize (spanning c). intros lists. induction lists as [|x l [P HP]].
  - exists 0. intros k Hk. simpl in Hk. lia.
  - destruct (sequence_bounded x) as [Q HQ]. exists (Rmax P Q). intros k Hk j d Hd. destruct k; simpl nth.
    + eapply Rle_trans. apply HQ. apply Rmax_r.
    + eapply Rle_trans. apply HP; auto. simpl in Hk. lia. apply Rmax_l.
Qed.

Hypothesis Kernel : checks_kernel a c = true.
Let inside := (inner c * r)%nat.
Let base := (Z.to_nat (inner_first c - lo) * r)%nat.

(* A sequence that is 0 outside of the inner points as a sum *)
Lemma unit_sequence q i k : (q < inside)%nat -> (k < r)%nat -> sequence (unit_at 1 (base + q)) i k =
  if ((lo <=? i)%Z && (place i k =? base + q)%nat)%bool then 1 else 0.
Proof.
  intros Hq Hk. unfold sequence. fold lo. rewrite Z.leb_antisym. destruct (Z.ltb_spec i lo); auto. simpl negb. simpl andb.
  unfold vr, unit_at. destruct (Nat.eqb_spec (place i k) (base + q)) as [->|N0].
  - rewrite app_nth2, repeat_length by (rewrite repeat_length; lia). rewrite Nat.sub_diag. auto.
  - destruct (Nat.lt_ge_cases (place i k) (base + q)).
    + rewrite app_nth1 by (rewrite repeat_length; auto). rewrite nth_zeros. auto.
    + rewrite app_nth2, repeat_length by (rewrite repeat_length; lia). replace (place i k - (base + q))%nat with (S (place i k - (base + q) - 1)) by lia.
      simpl. destruct (place i k - (base + q) - 1)%nat; auto.
Qed.

Lemma kernel_facts : (lo <= inner_first c)%Z /\ ((inner_first c - 1) * (Z.of_nat A - 1) <= F)%Z /\
  (F + Z.of_nat L <= (inner_first c + Z.of_nat (inner c)) * (Z.of_nat A - 1))%Z /\
  (inner_first c + Z.of_nat (inner c) <= lo + Z.of_nat len)%Z /\ (nonzero c < inside)%nat /\
  nth (base + nonzero c) (fixed c) 0%Z <> 0%Z /\ kernel_scale c <> 0%Z /\
  forall q i, (q < inside)%nat -> (i < inside)%nat ->
  dot (firstn size (nth i (kernel c) [])) (unfixed a c (unit_at 1 (base + q))) = (kernel_scale c *
    ((if (i =? q)%nat then nth (base + nonzero c) (fixed c) 0 else 0) - (if (q =? nonzero c)%nat then nth (base + i) (fixed c) 0 else 0)))%Z.
Proof.
  unfold checks_kernel in Kernel. rewrite !andb_true_iff in Kernel. fold A r F L lo len size inside base in Kernel.
  destruct Kernel as [[[[[[[H1 H2] H3] HW] H4] H5] H6] H7].
  apply Z.leb_le in H1, H2, H3, HW. apply Nat.ltb_lt in H4. apply negb_true_iff in H5, H6. apply Z.eqb_neq in H5, H6.
  repeat (split; [assumption|]). intros q i Hq Hi. rewrite forallb_forall in H7. specialize (H7 q ltac:(apply in_seq; lia)).
  rewrite forallb_forall in H7. specialize (H7 i ltac:(apply in_seq; lia)). apply Z.eqb_eq in H7. exact H7.
Qed.

Lemma fixed_kernel u : (forall i k, (k < r)%nat -> ((Z.of_nat A - 1) * i <= F \/ F + Z.of_nat L <= (Z.of_nat A - 1) * i)%Z -> u i k = 0) ->
  (forall i k, (k < r)%nat -> moved_by 0 u i k = u i k) -> (forall i k, (k < r)%nat -> ((Z.of_nat A - 1) * i <= F \/ F + Z.of_nat L <= (Z.of_nat A - 1) * i)%Z -> v i k = 0) ->
  exists z, forall i k, (k < r)%nat -> u i k = z * v i k.
Proof.
  intros Out Fix OutV. assert (E0 := common_real). destruct kernel_facts as [K1 [K2 [K3 [KW [K4 [K5 [K6 K7]]]]]]].
  (* the values of u inside *)
  set (y := fun q => u (inner_first c + Z.of_nat (q / r))%Z (q mod r)%nat).
  set (z0 := nth (base + nonzero c) (fixed c) 0%Z) in *.
  assert (Z0 : IZR z0 <> 0) by (apply IZR_neq; auto).
  assert (Sum : forall i k, (k < r)%nat -> u i k = sum inside (fun q => y q * sequence (unit_at 1 (base + q)) i k)).
  { intros i k Hk. destruct (Z_lt_ge_dec i (inner_first c)) as [I|I]; [|destruct (Z_lt_ge_dec i (inner_first c + Z.of_nat (inner c))) as [J|J]].
    - rewrite Out by (auto; left; apply (point_before A i (inner_first c)); auto; lia). symmetry. apply sum_zero. intros q Hq. rewrite unit_sequence by auto.
      destruct (Z.leb_spec lo i); simpl; [|ring]. destruct (Nat.eqb_spec (place i k) (base + q)) as [E|E]; [|ring]. exfalso.
      unfold place, base in E. fold lo r in E. revert E. apply place_before; auto. lia.
    - set (q := (Z.to_nat (i - inner_first c) * r + k)%nat).
      assert (Hq : (q < inside)%nat) by (unfold q, inside; apply place_inside; auto; lia).
      assert (Ei : (q / r)%nat = Z.to_nat (i - inner_first c)) by (unfold q; rewrite Nat.div_add_l, Nat.div_small by lia; lia).
      assert (Ek : (q mod r)%nat = k) by (unfold q; rewrite Nat.add_comm, Nat.mod_add, Nat.mod_small by lia; lia).
      rewrite (sum_ext inside _ (fun p => identity p q * y p)).
      + rewrite sum_identity by auto. unfold y. rewrite Ei, Ek. f_equal. lia.
      + intros p Hp. rewrite unit_sequence by auto. replace (lo <=? i)%Z with true by (symmetry; apply Z.leb_le; lia). simpl andb.
        assert (Ep : place i k = (base + q)%nat).
        { unfold place, base, q. fold lo r. replace (Z.to_nat (i - lo)) with (Z.to_nat (inner_first c - lo) + Z.to_nat (i - inner_first c))%nat by lia. ring. }
        rewrite Ep. unfold identity. destruct (Nat.eqb_spec (base + q) (base + p)), (Nat.eqb_spec p q); try lia; ring.
    - rewrite Out by (auto; right; apply (point_behind A i (inner_first c + Z.of_nat (inner c))); auto; lia). symmetry. apply sum_zero. intros q Hq. rewrite unit_sequence by auto.
      destruct (Z.leb_spec lo i); simpl; [|ring]. destruct (Nat.eqb_spec (place i k) (base + q)) as [E|E]; [|ring]. exfalso.
      unfold place, base in E. unfold inside in Hq. fold lo r in E. revert E. apply (place_behind _ _ (inner c)); auto. lia. }
  (* the equations *)
  assert (Hunit : forall q, (q < inside)%nat -> (length (unit_at 1 (base + q)) <= size)%nat).
  { intros q Hq. unfold unit_at. rewrite app_length, repeat_length. simpl.
    unfold inside in Hq. unfold base, size. apply (place_fits _ (inner c)); auto. lia. }
  assert (Eq : forall i k, (k < r)%nat -> sum inside (fun q => y q * sequence (unfixed a c (unit_at 1 (base + q))) i k) = 0).
  { intros i k Hk. rewrite (sum_ext inside _ (fun q => IZR e * (y q * moved_by 0 (sequence (unit_at 1 (base + q))) i k - y q * sequence (unit_at 1 (base + q)) i k))).
    - rewrite sum_scal, sum_minus, <- Sum by auto. unfold transit. rewrite <- mix_sum.
      rewrite (mix_ext r F L (point_matrix a) _ (fun k0 d => u (Z.of_nat A * i + Z.of_nat 0 - k0)%Z d)).
      + change (mix r F L (point_matrix a) (fun k0 d => u (Z.of_nat A * i + Z.of_nat 0 - k0)%Z d) k) with (moved_by 0 u i k). rewrite Fix by auto. ring.
      + intros k0 d Hd. symmetry. apply Sum. auto.
    - intros q Hq. rewrite unfixed_real by auto. ring. }
  assert (Rel : forall i, (i < inside)%nat -> IZR z0 * y i = y (nonzero c) * IZR (nth (base + i) (fixed c) 0%Z)).
  { intros i Hi. assert (S0 : sum inside (fun q => y q * IZR (dot (firstn size (nth i (kernel c) [])) (unfixed a c (unit_at 1 (base + q))))) = 0).
    { rewrite (sum_ext inside _ (fun q => y q * sum size (fun p => IZR (nth p (firstn size (nth i (kernel c) [])) 0%Z) * vr (unfixed a c (unit_at 1 (base + q))) p))).
      - rewrite (sum_ext inside _ (fun q => sum size (fun p => y q * (IZR (nth p (firstn size (nth i (kernel c) [])) 0%Z) * vr (unfixed a c (unit_at 1 (base + q))) p))))
          by (intros; rewrite sum_scal; auto).
        rewrite sum_swap. apply sum_zero. intros p Hp.
        rewrite (sum_ext inside _ (fun q => IZR (nth p (firstn size (nth i (kernel c) [])) 0%Z) * (y q * sequence (unfixed a c (unit_at 1 (base + q))) (lo + Z.of_nat (p / r))%Z (p mod r)%nat))).
        + rewrite sum_scal, Eq. ring. apply Nat.mod_upper_bound. lia.
        + intros q Hq. unfold sequence. fold lo. destruct (Z.ltb_spec (lo + Z.of_nat (p / r)) lo); [lia|].
          replace (place (lo + Z.of_nat (p / r)) (p mod r)) with p. ring.
          unfold place. fold lo r. replace (Z.to_nat (lo + Z.of_nat (p / r) - lo)) with (p / r)%nat by lia. assert (D := Nat.div_mod p r ltac:(lia)). lia.
      - intros q Hq. f_equal. apply dot_sum. rewrite firstn_length. lia. }
    rewrite (sum_ext inside _ (fun q => IZR (kernel_scale c) * (IZR z0 * (identity q i * y q) - IZR (nth (base + i) (fixed c) 0%Z) * (identity q (nonzero c) * y q)))) in S0.
    - rewrite sum_scal, sum_minus, !sum_scal, !sum_identity in S0 by auto. apply Rmult_integral in S0. destruct S0 as [S0|S0].
      exfalso. apply K6. apply eq_IZR. auto. lra.
    - intros q Hq. rewrite K7 by auto. rewrite mult_IZR, minus_IZR. unfold identity. fold z0.
      destruct (Nat.eqb_spec i q), (Nat.eqb_spec q i), (Nat.eqb_spec q (nonzero c)); try lia; ring. }
  exists (y (nonzero c) / IZR z0). intros i k Hk.
  destruct (Z_lt_ge_dec i (inner_first c)) as [I|I]; [|destruct (Z_lt_ge_dec i (inner_first c + Z.of_nat (inner c))) as [J|J]].
  - assert (X : ((Z.of_nat A - 1) * i <= F)%Z) by (apply (point_before A i (inner_first c)); auto; lia). rewrite Out, OutV by auto. ring.
  - set (q := (Z.to_nat (i - inner_first c) * r + k)%nat).
    assert (Hq : (q < inside)%nat) by (unfold q, inside; apply place_inside; auto; lia).
    assert (Ei : (q / r)%nat = Z.to_nat (i - inner_first c)) by (unfold q; rewrite Nat.div_add_l, Nat.div_small by lia; lia).
    assert (Ek : (q mod r)%nat = k) by (unfold q; rewrite Nat.add_comm, Nat.mod_add, Nat.mod_small by lia; lia).
    assert (R0 := Rel q Hq). unfold y at 1 in R0. rewrite Ei, Ek in R0. replace (inner_first c + Z.of_nat (Z.to_nat (i - inner_first c)))%Z with i in R0 by lia.
    replace (v i k) with (IZR (nth (base + q) (fixed c) 0%Z)).
    + apply (Rmult_eq_reg_l (IZR z0)); auto. rewrite R0. field. auto.
    + unfold v, sequence. fold lo. destruct (Z.ltb_spec i lo); [lia|]. unfold vr. do 2 f_equal. unfold place, base, q. fold lo r.
      replace (Z.to_nat (i - lo)) with (Z.to_nat (inner_first c - lo) + Z.to_nat (i - inner_first c))%nat by lia. ring.
  - assert (X : (F + Z.of_nat L <= (Z.of_nat A - 1) * i)%Z) by (apply (point_behind A i (inner_first c + Z.of_nat (inner c))); auto; lia). rewrite Out, OutV by auto. ring.
Qed.

Lemma nonzero_value : exists i k, (k < r)%nat /\ v i k <> 0.
Proof.
  destruct kernel_facts as [K1 [_ [_ [_ [_ [K5 _]]]]]]. set (q := nonzero c) in *.
  assert (D := Nat.div_mod q r ltac:(lia)). assert (M := Nat.mod_upper_bound q r ltac:(lia)).
  exists (inner_first c + Z.of_nat (q / r))%Z, (q mod r)%nat. split; auto.
  unfold v, sequence. fold lo. destruct (Z.ltb_spec (inner_first c + Z.of_nat (q / r)) lo); [lia|]. unfold vr.
  replace (place (inner_first c + Z.of_nat (q / r)) (q mod r)) with (base + q)%nat. apply IZR_neq. auto.
  unfold place, base. fold lo r. replace (Z.to_nat (inner_first c + Z.of_nat (q / r) - lo)) with (Z.to_nat (inner_first c - lo) + q / r)%nat by lia.
  rewrite Nat.mul_add_distr_r, (Nat.mul_comm (q / r)). lia.
Qed.

Definition start_differences : list Z := firstn (window c * functions a) (differences_of a c).
Lemma start_real : checks_start a c = true -> let u0 := start_differences in (length u0 <= size)%nat /\
  (forall i k, (k < r)%nat -> sequence u0 i k = vector_differences (difference_order c) v i k) /\
  enters A r lo len F (of_points a) (spanning c) (places c) (place_value c) (entering c) u0 = true.
Proof.
  unfold checks_start. rewrite !andb_true_iff. intros [[_ HZ] HE]. fold A r lo len F size in HZ, HE.
  unfold start_differences. fold len r size. cbv zeta. split. rewrite firstn_length; lia. split; auto. intros i k Hk.
  unfold v. rewrite <- sequence_differences by auto. fold r. change (iterate (difference_order c) (step_difference r) (fixed c)) with (differences_of a c).
  unfold sequence. destruct (i <? window_first c)%Z; auto. rewrite <- (firstn_skipn size (differences_of a c)) at 2.
  unfold vr. set (l := differences_of a c) in *. destruct (Nat.lt_ge_cases (place i k) (length (firstn size l))).
  - rewrite app_nth1; auto.
  - rewrite app_nth2 by auto. rewrite nth_overflow by auto. symmetry.
    apply (zero_list_vr (skipn size l) HZ (place i k - length (firstn size l))).
Qed.

(* The solution, and its values on the grids *)
Theorem values_of_radius l bound : checks_start a c = true -> radius_at_most N A (real T) bound ->
  (exists lambda, exp lambda = INR A /\ 0 < l <= INR (difference_order c) /\ bound <= exp (- l * lambda)) ->
  exists phi, solution_at_least A r F L (point_matrix a) phi l /\
  forall n i k, (k < r)%nat -> phi k (IZR i / INR A ^ n) = values A r F L (point_matrix a) v n i k.
Proof.
  intros HS HR [lambda [Log [Hl HB]]]. destruct (start_real HS) as [U1 [U2 U3]]. set (u0 := start_differences) in *.
  destruct basis_bounded as [P HP]. destruct (sequence_bounded u0) as [B HB0]. destruct (sequence_bounded (fixed c)) as [B' HB1].
  assert (Lp := log_positive A Arity lambda Log).
  assert (Shrink : forall x, 0 < x < l -> exists C, forall n i k, (k < r)%nat ->
    Rabs (values A r F L (point_matrix a) (vector_differences (difference_order c) v) n i k) <= C * exp (- x * lambda) ^ n).
  { intros x Hx. assert (G0 : 0 < exp (- x * lambda)) by apply exp_pos.
    assert (G1 : exp (- x * lambda) <= 1) by (rewrite <- exp_0, <- (Rmult_0_l lambda); left; apply (power_less A Arity lambda Log); lra).
    assert (G : growth N A (real T) (exp (- x * lambda))).
    { apply HR; auto. eapply Rle_lt_trans. apply HB. apply (power_less A Arity lambda Log). lra. }
    destruct (values_shrink A r F L (point_matrix a) Arity N b (real T) space_invariant P HP (fun i k => 1 * sequence u0 i k) (entering c) B
      (fun i k _ => Rle_trans _ _ _ (Req_le _ _ (f_equal Rabs (Rmult_1_l _))) (HB0 i k)) (fun w => enters_span (entering c) u0 U1 U3 1 w)
      (exp (- x * lambda)) (conj G0 G1) G) as [C HC].
    exists C. intros n i k Hk. rewrite <- (values_ext A r F L (point_matrix a) (fun i k => 1 * sequence u0 i k)); auto.
    intros j d Hd. rewrite Rmult_1_l. auto. }
  destruct (solution_exists A r F L (point_matrix a) Arity v lo (lo + Z.of_nat len - 1) (fun i k Hk => values_outside i k Hk)
    (fun i k Hk => values_fixed i k Hk) (difference_order c) l lambda Log Hl (ex_intro _ B' (fun i k _ => HB1 i k)) Shrink) as [phi [Phi [V Ex]]].
  assert (V0 : forall i k, (k < r)%nat -> phi k (IZR i) = v i k).
  { intros i k Hk. specialize (V O i k Hk). rewrite pow_O in V. unfold Rdiv in V. rewrite Rinv_1, Rmult_1_r in V. exact V. }
  exists phi. split; auto. split; auto. split; [|split]; auto.
  - destruct nonzero_value as [i [k [Hk Hv]]]. exists k, (IZR i). split; auto. rewrite V0; auto.
  - apply (solutions_multiple A r F L (point_matrix a) Arity v); auto. intros u Out Fix. apply fixed_kernel; auto.
    intros i k Hk Hi. rewrite <- V0 by auto. apply (integers_inside A r F L (point_matrix a) Arity phi Phi); auto.
Qed.

Corollary vectors_of_radius l bound : checks_start a c = true -> radius_at_most N A (real T) bound ->
  (exists lambda, exp lambda = INR A /\ 0 < l <= INR (difference_order c) /\ bound <= exp (- l * lambda)) ->
  one_solution A r F L (point_matrix a) l.
Proof. intros HS HR HB. destruct (values_of_radius l bound HS HR HB) as [phi [S _]]. exists phi. exact S. Qed.
End Real.

Lemma vector_power_sound a l m bound lambda : (2 <= vector_arity a)%nat -> exp lambda = INR (vector_arity a) ->
  vector_power a l m bound = true -> 0 < real_of l <= INR m /\ real_of bound <= exp (- real_of l * lambda).
Proof.
  intros HA Log HB. apply (below_power_sound lambda) in HB; auto. destruct HB as [Hl HB]. split; auto.
  assert (PM : 0 < INR (vector_arity a) ^ m) by (apply pow_lt, arity_positive; auto).
  apply (Rmult_le_reg_l (INR (vector_arity a) ^ m)); auto.
  replace (INR (vector_arity a) ^ m * exp (- real_of l * lambda)) with (exp ((INR m - real_of l) * lambda)).
  - eapply Rle_trans. 2: apply HB. right. unfold real_of. cbn [Qnum Qden]. rewrite mult_IZR, (arity_power _ HA). unfold Rdiv. ring.
  - rewrite <- Log, exp_power, <- exp_plus. f_equal. ring.
Qed.

(* What the checker accepts is true. *)
Theorem check_vectors_sound a l c : check_vectors a l c = true -> vectors_hold a l.
Proof.
  intros H. apply andb_prop in H. destruct H as [H HR]. apply andb_prop in H. destruct H as [H HB].
  unfold vector_space in H. rewrite !andb_true_iff in H.
  destruct H as [[[[[[[[[[HA HO] HP] Hf] HQ] Hlo] Hhi] HF] HS] HT] HK].
  apply Nat.leb_le in HA, HP, Hf. apply Z.ltb_lt in HO. apply Z.leb_le in Hlo, Hhi.
  destruct (exp_onto (INR (vector_arity a)) (arity_positive _ HA)) as [lambda Log].
  apply (vector_power_sound a l _ _ lambda HA Log) in HB. destruct HB as [Hl HB].
  apply (check_radius_sound) in HR. apply radius_bounded in HR.
  assert (Sh := HT). unfold checks_start in Sh. rewrite !andb_true_iff in Sh. destruct Sh as [[Sh _] _].
  unfold vectors_hold. apply (vectors_of_radius a c HA HO HP Hf HQ Hlo ltac:(lia) Sh HS HF HK (real_of l) (real_of (space_bound c)) HT).
  - intros g G1 G2. rewrite <- (space_count a c HS). apply HR; auto.
  - exists lambda. auto.
Qed.
