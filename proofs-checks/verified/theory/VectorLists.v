(* Schemes of vectors with a mask of matrices for each level, from a list: what is proved of all sequences of its masks, or of those
   along the edges of a graph, and of one mask (SPEC.md, sections 6.7 and 6.12, Theorems 47 and 73). *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Integers Sections Check Subdivision Coefficients Grid Refinable Exponent Along VectorLevels Vectors Ranges.
Import ListNotations.
Open Scope Z_scope.

(* ---- claims ---------------------------------------------------------------------------------------------------------- *)

(* Masks of one arity, with matrices of one size: the first index and the matrices of each, over one denominator *)
Record vector_masks := VectorMasks { list_arity : nat; list_functions : nat; list_common : Z; each_vector : list (Z * list zmat) }.
Definition vector_number (m : vector_masks) (i : nat) : vector_mask :=
  VectorMask (list_arity m) (list_functions m) (fst (nth i (each_vector m) (0, []))) (snd (nth i (each_vector m) (0, []))) (list_common m).

(* The data of each level from f, of a sequence of numbers of masks: level k + 1 is made from level k by the mask number i k. *)
Definition list_data (m : vector_masks) (i : nat -> nat) (f : vectors) : nat -> vectors :=
  vector_levels (list_arity m) (list_functions m) (fun k => vector_first (vector_number m (i k)))
    (fun k => (length (of_points (vector_number m (i k))) - 1)%nat) (fun k => point_matrix (vector_number m (i k))) f.
Definition limit_of_data (m : vector_masks) (i : nat -> nat) (f : vectors) (y : vec) (F : R -> R) : Prop :=
  bounded_data (list_functions m) f /\ tends_to_vector (list_arity m) (list_functions m) (list_data m i f) y F.

(* There is one vector y such that for each of the sequences and all bounded data those of the levels tend to y F, the exponent of F
   is at least l, and F is not always 0. *)
Definition lists_hold_real (m : vector_masks) (s : sequences) (l : R) : Prop :=
  exists y, (exists c, (c < list_functions m)%nat /\ y c <> 0%R) /\ forall i, allowed (length (each_vector m)) s i ->
  (forall f, bounded_data (list_functions m) f -> exists F, limit_of_data m i f y F /\ exponent_at_least F l) /\
  exists f F x, limit_of_data m i f y F /\ F x <> 0%R.
Definition vector_lists_hold (m : vector_masks) (s : sequences) (l : Q) : Prop := lists_hold_real m s (real_of l).

(* Of one mask, with an exponent above l *)
Definition vector_scheme_holds (a : vector_mask) (l : Q) : Prop := exists x, (real_of l < x)%R /\
  lists_hold_real (VectorMasks (vector_arity a) (functions a) (vector_common a) [(vector_first a, of_points a)]) Any x.

(* ---- the checker ------------------------------------------------------------------------------------------------------- *)

(* The space as in Vectors.v, with matrices of each mask on it. What a step changes in `functional`, its differences, and, times
   `list_scale`, each component at 0 less `list_weights` times the functional there and before, are in the span of `wide` after so many
   letters; these are, times `wide_scale`, sums of vectors of the space and of their shifts by 1 to either side. `constants` are kept by
   all masks. *)
Record list_certificate := ListCertificate {
  list_first : Z; list_window : nat; list_order : nat; list_spanning : list (list Z); list_places : list nat; list_place_value : Z;
  list_restricted : list (list zmat);
  wide : list (list Z); wide_places : list nat; wide_pivot : Z; wide_rows : list (list Z); wide_scale : Z; list_entering : nat; functional : list Z;
  constants : list Z; list_weights : list (list Z); list_scale : Z;  list_bound : Q; list_radius : certificate }.

Definition space_of (c : list_certificate) (i : nat) : vector_certificate :=
  VectorCertificate (list_first c) (list_window c) [] (list_order c) (list_spanning c) (list_places c) (list_place_value c) (nth i (list_restricted c) [])
    (list_entering c) 0 0 0 [] 0 (list_bound c) (list_radius c).

(* Times arity^order *)
Definition lists_family (m : vector_masks) (s : sequences) (c : list_certificate) : family :=
  along s (length (list_spanning c)) (list_common m * list_place_value c)
    (map (map (map (map (Z.mul (Z.of_nat (list_arity m) ^ Z.of_nat (list_order c)))))) (list_restricted c)).

(* What the matrices of the points k, k + 1, ... that are t modulo the arity make of constants, component d *)
Fixpoint constants_total (A : nat) (k : Z) (Ms : list zmat) (y : list Z) (t : Z) (d : nat) : Z :=
  match Ms with
  | [] => 0
  | M :: rest => (if Z.of_nat A * ((t - k) / Z.of_nat A) =? t - k then dot (map (fun row => nth d row 0) M) y else 0) + constants_total A (k + 1) rest y t d
  end.

(* All images by so many of the moves *)
Fixpoint arrives (moves : list (list Z -> list Z)) (inside : list Z -> bool) (n : nat) (u : list Z) : bool :=
  match n with O => inside u | S k => forallb (fun move => arrives moves inside k (move u)) moves end.

Section Checker.
Variables (m : vector_masks) (c : list_certificate).
Let A := list_arity m.
Let r := list_functions m.
Let lo := list_first c.
Let len := list_window c.
Let size := (len * r)%nat.
Definition list_moves : list (list Z -> list Z) :=
  flat_map (fun p => map (move A r lo len (fst p) (snd p)) (seq 0 A)) (each_vector m).
Definition comes (u : list Z) : bool := zero_list (skipn size u) &&
  arrives list_moves (in_space (wide c) (wide_places c) (wide_pivot c)) (list_entering c) (firstn size u).
Definition list_shifted : list (list Z) := map (skipn r) (list_spanning c) ++ list_spanning c ++ map (app (repeat 0 r)) (list_spanning c).

(* What a step changes in the functional, times the denominator; its differences; a component at 0, less those multiples *)
Definition list_change (p : Z * list zmat) : list Z := addmul (- list_common m) (functional c) (move A r lo len (fst p) (snd p) 0 (functional c)).
Definition list_differences : list Z := iterate (list_order c) (step_difference r) (functional c).
Definition list_component (d : nat) : list Z := addmul (list_scale c) (unit_at 1 (Z.to_nat (- lo) * r + d))
  (combine_lists (map Z.opp (nth d (list_weights c) [])) (map (fun j => repeat 0 (j * r) ++ functional c) (seq 0 (S (list_order c))))).

Definition list_window_fits : bool :=
  (2 <=? A)%nat && (0 <? list_common m) && (1 <=? r)%nat && (lo <=? 0) && (0 <? lo + Z.of_nat len) && (list_order c <=? len)%nat &&
  forallb (fun b => (r + length b <=? size)%nat && zero_list (firstn r b)) (list_spanning c) && (length (functional c) <=? (len - list_order c) * r)%nat &&
  forallb (fun p => (1 <=? length (snd p))%nat && forallb (square r) (snd p) && ((Z.of_nat A - 1) * lo <=? fst p) &&
    (fst p + Z.of_nat (length (snd p) - 1) <=? (Z.of_nat A - 1) * (lo + Z.of_nat len - 1))) (each_vector m).
Definition list_spaces : bool :=
  (length (list_restricted c) =? length (each_vector m))%nat && forallb (forallb (square (length (list_spanning c)))) (list_restricted c) &&
  forallb (fun i => checks_space (vector_number m i) (space_of c i)) (seq 0 (length (each_vector m))) &&
  negb (wide_pivot c =? 0) && negb (wide_scale c =? 0) &&
  forallb (fun k => zero_list (addmul (- wide_scale c) (nth k (wide c) []) (combine_lists (nth k (wide_rows c) []) list_shifted))) (seq 0 (length (wide c))).
Definition list_constants : bool :=
  existsb (fun d => negb (nth d (constants c) 0 =? 0)) (seq 0 r) && (length (constants c) =? r)%nat &&
  forallb (fun p => forallb (fun t => forallb (fun d =>
    constants_total A (fst p) (snd p) (constants c) (Z.of_nat t) d =? list_common m * nth d (constants c) 0) (seq 0 r)) (seq 0 A)) (each_vector m).
Definition list_comes : bool :=
  forallb (fun p => comes (list_change p)) (each_vector m) && comes list_differences && forallb (fun d => comes (list_component d)) (seq 0 r) &&
  negb (list_scale c =? 0) && existsb (fun d => negb (fold_right Z.add 0 (firstn (S (list_order c)) (nth d (list_weights c) [])) =? 0)) (seq 0 r).
End Checker.

Definition lists_space (m : vector_masks) (s : sequences) (c : list_certificate) : bool :=
  list_window_fits m c && list_spaces m c && list_constants m c && list_comes m c && known (length (each_vector m)) s.

Definition check_vector_lists (m : vector_masks) (s : sequences) (l : Q) (c : list_certificate) : bool :=
  lists_space m s c && below_power (Scheme (list_arity m) 0 [] 1) l (list_order c) (list_bound c) &&
  check_radius (Claim (lists_family m s c) None (Some (list_bound c))) (list_radius c).

Definition check_vector_scheme (a : vector_mask) (l : Q) (c : list_certificate) : bool :=
  let m := VectorMasks (vector_arity a) (functions a) (vector_common a) [(vector_first a, of_points a)] in
  lists_space m Any c && below_power_strictly (list_arity m) l (list_order c) (list_bound c) &&
  check_radius (Claim (lists_family m Any c) None (Some (list_bound c))) (list_radius c).

(* ---- what the checker computes ------------------------------------------------------------------------------------------ *)

Open Scope R_scope.

Lemma all_in_list {X} (l : list X) (Q : X -> R -> Prop) : (forall x y z, y <= z -> Q x y -> Q x z) -> (forall x, In x l -> exists y, Q x y) ->
  exists y, forall x, In x l -> Q x y.
Proof.
  intros Mono. induction l as [|x l IH]; intros H. exists 0. intros x [].
  destruct (H x (or_introl eq_refl)) as [y Hy]. destruct IH as [z Hz]. intros; apply H; right; auto.
  exists (Rmax y z). intros x' [<-|I]. eapply Mono; eauto. apply Rmax_l. eapply Mono; eauto. apply Rmax_r.
Qed.

Lemma all_below (n : nat) (Q : nat -> R -> Prop) : (forall x y z, y <= z -> Q x y -> Q x z) -> (forall x, (x < n)%nat -> exists y, Q x y) ->
  exists y, forall x, (x < n)%nat -> Q x y.
Proof.
  intros Mono H. destruct (all_in_list (seq 0 n) Q Mono) as [y Hy]. intros x Hx. apply H. apply in_seq in Hx. lia.
  exists y. intros x Hx. apply Hy. apply in_seq. lia.
Qed.

Section Sound.
Variables (m : vector_masks) (c : list_certificate).
Let A := list_arity m.
Let r := list_functions m.
Let lo := list_first c.
Let len := list_window c.
Let size := (len * r)%nat.
Let n := length (each_vector m).
Let N := length (list_spanning c).
Hypothesis Fits : list_window_fits m c = true.
Hypothesis Spaces : list_spaces m c = true.
Hypothesis Constants : list_constants m c = true.
Hypothesis Comes : list_comes m c = true.

Lemma window_facts : (2 <= A)%nat /\ (0 < list_common m)%Z /\ (1 <= r)%nat /\ (lo <= 0 < lo + Z.of_nat len)%Z /\ (list_order c <= len)%nat /\
  (forall u, In u (list_spanning c) -> (r + length u <= size)%nat /\ zero_list (firstn r u) = true) /\ (length (functional c) <= (len - list_order c) * r)%nat.
Proof.
  unfold list_window_fits in Fits. rewrite !andb_true_iff in Fits. fold A r lo len size in Fits.
  destruct Fits as [[[[[[[[H1 H2] H3] H4] H5] H6] H7] H8] _]. apply Nat.leb_le in H1, H3, H6, H8. apply Z.ltb_lt in H2, H5. apply Z.leb_le in H4.
  rewrite forallb_forall in H7. repeat (split; [lia|]). split; [|lia]. intros u Hu. specialize (H7 u Hu). apply andb_prop in H7.
  rewrite Nat.leb_le in H7. exact H7.
Qed.

Lemma mask_facts i : (i < n)%nat -> let a := vector_number m i in (1 <= length (of_points a))%nat /\ forallb (square r) (of_points a) = true /\
  ((Z.of_nat A - 1) * lo <= vector_first a)%Z /\ (vector_first a + Z.of_nat (length (of_points a) - 1) <= (Z.of_nat A - 1) * (lo + Z.of_nat len - 1))%Z.
Proof.
  intros Hi a. unfold list_window_fits in Fits. rewrite !andb_true_iff in Fits. destruct Fits as [_ H]. rewrite forallb_forall in H.
  specialize (H _ (nth_In (each_vector m) (0%Z, []) Hi)). rewrite !andb_true_iff in H. destruct H as [[[H1 H2] H3] H4].
  apply Nat.leb_le in H1. apply Z.leb_le in H3, H4. auto.
Qed.

Lemma space_facts i : (i < n)%nat -> checks_space (vector_number m i) (space_of c i) = true.
Proof.
  intros Hi. unfold list_spaces in Spaces. rewrite !andb_true_iff in Spaces. destruct Spaces as [[[[_ H] _] _] _]. rewrite forallb_forall in H. apply H.
  apply in_seq. fold n. lia.
Qed.

Lemma short_space i : forallb (fun b => length b <=? window (space_of c i) * functions (vector_number m i))%nat (fixed (space_of c i) :: spanning (space_of c i)) = true.
Proof. apply forallb_forall. intros u [<-|Hu]. auto. apply Nat.leb_le.
  assert (W := proj1 (proj1 (proj2 (proj2 (proj2 (proj2 (proj2 window_facts))))) u Hu)). cbn [window space_of functions vector_number]. fold len r size. lia. Qed.

(* Sequences are the same for all masks. *)
Definition list_sequence (u : list Z) : vectors := sequence (vector_number m 0) (space_of c 0) u.
Lemma same_sequence i u : sequence (vector_number m i) (space_of c i) u = list_sequence u.
Proof. reflexivity. Qed.

Section One.
Variable i : nat -> nat.
Hypothesis Numbers : forall k, (i k < n)%nat.
Notation F := (fun k => vector_first (vector_number m (i k))).
Notation L := (fun k => (length (of_points (vector_number m (i k))) - 1)%nat).
Notation a := (fun k => point_matrix (vector_number m (i k))).
Let b (k : nat) : vectors := list_sequence (nth k (list_spanning c) []).
Let T (k t : nat) : mat := real (vector_family (vector_number m (i k)) (space_of c (i k))) t.

Lemma list_move k t u j d : (length u <= size)%nat -> (t < A)%nat -> (d < r)%nat ->
  list_sequence (move A r lo len (F k) (of_points (vector_number m (i k))) t u) j d = IZR (list_common m) * transit A r (F k) (L k) (a k) t (list_sequence u) j d.
Proof.
  intros Hu Ht Hd. destruct window_facts as [W1 [W2 [W3 _]]]. destruct (mask_facts (i k) (Numbers k)) as [M1 [M2 [M3 M4]]].
  apply (move_real (vector_number m (i k)) (space_of c (i k)) W1 W2 M1 W3 M2 M3 M4 t u j d Hu Ht Hd).
Qed.

Lemma list_invariant k t q : (t < A)%nat -> (q < N)%nat -> forall j d, (d < r)%nat ->
  transit A r (F k) (L k) (a k) t (b q) j d = sum N (fun l => T k t l q * b l j d).
Proof.
  intros Ht Hq. destruct window_facts as [W1 [W2 [W3 _]]]. destruct (mask_facts (i k) (Numbers k)) as [M1 [M2 [M3 M4]]].
  apply (space_invariant (vector_number m (i k)) (space_of c (i k)) W1 W2 M1 W3 M2 M3 M4 (short_space (i k)) (space_facts (i k) (Numbers k)) t q Ht Hq).
Qed.

Lemma list_combine y l j d : list_sequence (combine_lists y l) j d = sum (length l) (fun k => IZR (nth k y 0%Z) * list_sequence (nth k l []) j d).
Proof. apply (sequence_combine (vector_number m 0) (space_of c 0)). Qed.

Lemma list_outside u j d : (length u <= size)%nat -> (d < r)%nat -> (j < lo \/ lo + Z.of_nat len <= j)%Z -> list_sequence u j d = 0.
Proof.
  destruct window_facts as [W1 [W2 [W3 _]]]. destruct (mask_facts (i O) (Numbers O)) as [M1 [M2 [M3 M4]]].
  apply (sequence_outside (vector_number m (i O)) (space_of c (i O)) W1 M1 W3 M3 M4 u j d).
Qed.

Lemma list_left u j d : (d < r)%nat -> zero_list (firstn r u) = true -> list_sequence (skipn r u) j d = list_sequence u (j + 1)%Z d.
Proof.
  intros Hd H. unfold list_sequence, sequence. cbn [window_first space_of]. fold lo. unfold vr, place. cbn [window_first space_of functions vector_number]. fold lo r.
  destruct (Z.ltb_spec j lo), (Z.ltb_spec (j + 1) lo); try lia; auto.
  - replace (Z.to_nat (j + 1 - lo) * r + d)%nat with d by (replace (j + 1 - lo)%Z with 0%Z by lia; auto).
    assert (Z0 := zero_list_vr _ H d). unfold vr in Z0. destruct (Nat.lt_ge_cases d (length u)) as [Hl|Hl].
    + rewrite <- Z0. f_equal. rewrite <- (firstn_skipn r u) at 2. symmetry. apply app_nth1. rewrite firstn_length. lia.
    + rewrite nth_overflow; auto.
  - rewrite nth_skipn_at. do 2 f_equal. replace (Z.to_nat (j + 1 - lo)) with (S (Z.to_nat (j - lo))) by lia. lia.
Qed.

Lemma list_right u s j d : (d < r)%nat -> list_sequence (repeat 0%Z (s * r) ++ u) j d = list_sequence u (j - Z.of_nat s)%Z d.
Proof.
  intros Hd. unfold list_sequence, sequence. cbn [window_first space_of]. fold lo. unfold vr, place. cbn [window_first space_of functions vector_number]. fold lo r.
  destruct (Z.ltb_spec j lo), (Z.ltb_spec (j - Z.of_nat s) lo); try lia; auto.
  - rewrite app_nth1. rewrite nth_zeros. auto. rewrite repeat_length. assert (S (Z.to_nat (j - lo)) <= s)%nat by lia. nia.
  - rewrite app_nth2; rewrite repeat_length. 2: { assert (s <= Z.to_nat (j - lo))%nat by lia. nia. }
    do 2 f_equal. replace (Z.to_nat (j - Z.of_nat s - lo)) with (Z.to_nat (j - lo) - s)%nat by lia. rewrite Nat.mul_sub_distr_r.
    assert (s * r <= Z.to_nat (j - lo) * r)%nat by (apply Nat.mul_le_mono_r; lia). lia.
Qed.

(* The space, moved by -1, 0 and 1 *)
Definition shift_by (s : nat) : Z := (Z.of_nat s - 1)%Z.

Lemma nth_shifted s l j d : (s < 3)%nat -> (l < N)%nat -> (d < r)%nat -> list_sequence (nth (s * N + l) (list_shifted m c) []) j d = b l (j - shift_by s)%Z d.
Proof.
  intros Hs Hl Hd. destruct window_facts as [_ [_ [_ [_ [_ [W _]]]]]]. unfold list_shifted, b, shift_by. fold r. unfold N in *.
  destruct (W _ (nth_In (list_spanning c) [] Hl)) as [_ Z0]. destruct s as [|[|[|s]]]; [| | |lia].
  - change (0 * length (list_spanning c) + l)%nat with l. rewrite app_nth1 by (rewrite map_length; auto).
    rewrite nth_indep with (d' := skipn r []) by (rewrite map_length; auto). rewrite map_nth, list_left by auto. f_equal; lia.
  - rewrite app_nth2 by (rewrite map_length; lia). rewrite map_length, app_nth1 by lia. replace (1 * length (list_spanning c) + l - length (list_spanning c))%nat with l by lia. f_equal; lia.
  - rewrite app_nth2 by (rewrite map_length; lia). rewrite map_length, app_nth2 by lia.
    replace (2 * length (list_spanning c) + l - length (list_spanning c) - length (list_spanning c))%nat with l by lia.
    rewrite nth_indep with (d' := repeat 0%Z r ++ []) by (rewrite map_length; auto). rewrite (map_nth (app (repeat 0%Z r))).
    replace r with (1 * r)%nat at 1 by lia. rewrite list_right by auto. f_equal; lia.
Qed.

(* What is in the span of `wide` *)
Lemma list_in_wide u : in_space (wide c) (wide_places c) (wide_pivot c) u = true ->
  exists y, forall j d, (d < r)%nat -> list_sequence u j d = sum 3 (fun s => span N b (y s) (j - shift_by s)%Z d).
Proof.
  intros H. assert (S := Spaces). unfold list_spaces in S. rewrite !andb_true_iff in S. destruct S as [[[_ P0] S0] HW].
  apply negb_true_iff, Z.eqb_neq, IZR_neq in P0. apply negb_true_iff, Z.eqb_neq, IZR_neq in S0. simpl (IZR 0) in P0, S0. rewrite forallb_forall in HW.
  set (n3 := length (wide c)) in *. set (x := fun k => IZR (nth k (map (fun p => nth p u 0%Z) (wide_places c)) 0%Z)).
  assert (E1 : forall j d, IZR (wide_pivot c) * list_sequence u j d = sum n3 (fun k => x k * list_sequence (nth k (wide c) []) j d)).
  { intros j d. assert (Z0 := sequence_zero (vector_number m 0) (space_of c 0) _ j d H). rewrite sequence_addmul, opp_IZR in Z0.
    change (sequence (vector_number m 0) (space_of c 0)) with list_sequence in Z0. rewrite list_combine in Z0. fold n3 in Z0. unfold x. lra. }
  assert (E2 : forall k j d, (k < n3)%nat -> (d < r)%nat -> IZR (wide_scale c) * list_sequence (nth k (wide c) []) j d =
    sum 3 (fun s => sum N (fun l => IZR (nth (s * N + l) (nth k (wide_rows c) []) 0%Z) * b l (j - shift_by s)%Z d))).
  { intros k j d Hk Hd. assert (Z0 := sequence_zero (vector_number m 0) (space_of c 0) _ j d (HW k ltac:(apply in_seq; lia))).
    rewrite sequence_addmul, opp_IZR in Z0. change (sequence (vector_number m 0) (space_of c 0)) with list_sequence in Z0. rewrite list_combine in Z0.
    replace (length (list_shifted m c)) with (3 * N)%nat in Z0 by (unfold list_shifted; rewrite !app_length, !map_length; unfold N; lia).
    rewrite sum_blocks in Z0.
    rewrite (sum_ext 3 _ (fun s => sum N (fun l => IZR (nth (s * N + l) (nth k (wide_rows c) []) 0%Z) * b l (j - shift_by s)%Z d))) in Z0. lra.
    intros s Hs. apply sum_ext; intros l Hl. rewrite nth_shifted by auto. reflexivity. }
  exists (fun s l => sum n3 (fun k => x k * IZR (nth (s * N + l) (nth k (wide_rows c) []) 0%Z)) / (IZR (wide_pivot c) * IZR (wide_scale c))).
  intros j d Hd. apply (Rmult_eq_reg_l (IZR (wide_pivot c) * IZR (wide_scale c))). 2: { apply Rmult_integral_contrapositive; split; auto. }
  replace (IZR (wide_pivot c) * IZR (wide_scale c) * list_sequence u j d) with (IZR (wide_scale c) * (IZR (wide_pivot c) * list_sequence u j d)) by ring.
  rewrite E1, <- !sum_scal.
  rewrite (sum_ext n3 _ (fun k => sum 3 (fun s => sum N (fun l => x k * IZR (nth (s * N + l) (nth k (wide_rows c) []) 0%Z) * b l (j - shift_by s)%Z d)))).
  2: { intros k Hk. replace (IZR (wide_scale c) * (x k * list_sequence (nth k (wide c) []) j d)) with (x k * (IZR (wide_scale c) * list_sequence (nth k (wide c) []) j d)) by ring.
       rewrite E2 by auto. rewrite <- sum_scal. apply sum_ext; intros s Hs. rewrite <- sum_scal. apply sum_ext; intros. ring. }
  rewrite sum_swap. apply sum_ext; intros s Hs. unfold span. rewrite <- sum_scal, sum_swap. apply sum_ext; intros l Hl.
  rewrite (sum_ext n3 _ (fun k => b l (j - shift_by s)%Z d * (x k * IZR (nth (s * N + l) (nth k (wide_rows c) []) 0%Z)))) by (intros; ring).
  rewrite sum_scal. field. auto.
Qed.

Lemma arrives_in p : forall u, (length u <= size)%nat -> arrives (list_moves m c) (in_space (wide c) (wide_places c) (wide_pivot c)) p u = true ->
  forall z, exists Y, forall k w, letters A w -> length w = p -> exists y, (forall s q, (s < 3)%nat -> (q < N)%nat -> Rabs (y s q) <= Y) /\
  forall j d, (d < r)%nat -> lead A r F L a k w (fun j d => z * list_sequence u j d) j d = sum 3 (fun s => span N b (y s) (j - shift_by s)%Z d).
Proof.
  destruct window_facts as [W1 [W2 [W3 _]]]. assert (E0 : 0 < IZR (list_common m)) by (apply IZR_lt; auto).
  induction p; intros u Hu H z; cbn [arrives] in H.
  - destruct (list_in_wide u H) as [y0 Hy]. set (y := fun s k => z * y0 s k).
    exists (sum 3 (fun s => norm N (y s))). intros k [|] _ Hl; [|discriminate]. exists y. split.
    + intros s q Hs Hq. eapply Rle_trans. apply (norm_term N (y s) q Hq). apply (sum_term 3 (fun s => norm N (y s)) s); auto. intros; apply norm_nonneg.
    + intros j d Hd. cbn [lead]. rewrite Hy by auto. rewrite <- sum_scal. apply sum_ext; intros s Hs. unfold span. rewrite <- sum_scal. apply sum_ext; intros. unfold y. ring.
  - rewrite forallb_forall in H.
    assert (Each : exists Y, forall x, (x < n)%nat -> forall t, (t < A)%nat -> forall k w, letters A w -> length w = p ->
      exists y, (forall s q, (s < 3)%nat -> (q < N)%nat -> Rabs (y s q) <= Y) /\ forall j d, (d < r)%nat ->
      lead A r F L a k w (fun j d => z / IZR (list_common m) * list_sequence (move A r lo len (vector_first (vector_number m x)) (of_points (vector_number m x)) t u) j d) j d =
      sum 3 (fun s => span N b (y s) (j - shift_by s)%Z d)).
    { apply all_below. { intros x y y' Hy G t Ht k w Hw Hl. destruct (G t Ht k w Hw Hl) as [v [V1 V2]]. exists v. split; auto. intros s q Hs Hq. eapply Rle_trans; eauto. }
      intros x Hx. apply all_below. { intros t y y' Hy G k w Hw Hl. destruct (G k w Hw Hl) as [v [V1 V2]]. exists v. split; auto. intros s q Hs Hq. eapply Rle_trans; eauto. }
      intros t Ht. apply IHp.
      - apply Nat.eq_le_incl. apply (moved_length (vector_number m x) (space_of c x) t u).
      - apply H. unfold list_moves. apply in_flat_map. exists (nth x (each_vector m) (0%Z, [])). split. apply nth_In. auto.
        fold A r lo len. apply (in_map (fun t => move A r lo len _ _ t)) with (x := t). apply in_seq. lia. }
    destruct Each as [Y HY]. exists Y. intros k w Hw Hl. destruct (exists_last (l := w)) as [v [t ->]]. { intros ->. discriminate. }
    apply letters_app in Hw. destruct Hw as [Hv Ht]. inversion Ht; subst. rewrite app_length in Hl. simpl in Hl. assert (Lv : length v = p) by lia.
    destruct (HY (i (k + length v)%nat) (Numbers _) t H2 k v Hv Lv) as [y [Y1 Y2]]. exists y. split; auto. intros j d Hd. rewrite <- Y2 by auto.
    rewrite lead_app. cbn [lead]. apply lead_ext; auto. intros j' d' Hd'. rewrite (list_move (k + length v)) by auto. unfold transit. rewrite mix_scal. field. lra.
Qed.

(* A sequence of integers that comes into the space, divided by z *)
Lemma comes_sound u z : comes m c u = true -> exists Y Q, comes_in A r lo len F L a N b 3 shift_by (list_entering c) Y Q (fun j d => z * list_sequence u j d).
Proof.
  intros H. apply andb_prop in H. destruct H as [H1 H2]. fold r len size in H1, H2.
  assert (E : list_sequence u = list_sequence (firstn size u)).
  { extensionality j. extensionality d. unfold list_sequence, sequence. destruct (j <? _)%Z; auto. unfold vr. set (x := place _ _ j d).
    destruct (Nat.lt_ge_cases x size) as [X|X].
    - rewrite <- (firstn_skipn size u) at 1. destruct (Nat.lt_ge_cases x (length (firstn size u))). rewrite app_nth1; auto.
      rewrite app_nth2 by auto. rewrite (nth_overflow (firstn size u)) by auto.
      apply (zero_list_vr (skipn size u) H1 (x - length (firstn size u))).
    - rewrite (nth_overflow (firstn size u)). 2: { rewrite firstn_length. lia. }
      assert (Z0 := zero_list_vr _ H1 (x - size)). unfold vr in Z0. rewrite nth_skipn_at in Z0. replace (size + (x - size))%nat with x in Z0 by lia. exact Z0. }
  rewrite E. set (v := firstn size u) in *. assert (Hv : (length v <= size)%nat) by (unfold v; rewrite firstn_length; lia).
  destruct (arrives_in (list_entering c) v Hv H2 z) as [Y HY]. destruct (sequence_bounded (vector_number m 0) (space_of c 0) v) as [B HB].
  exists Y, (Rabs z * B). split; [|split; auto].
  - intros j d Hd Hj. rewrite list_outside by auto. ring.
  - intros j d Hd. rewrite Rabs_mult. apply Rmult_le_compat_l. apply Rabs_pos. apply HB.
Qed.

(* ---- the theorem for one sequence ---------------------------------------------------------------------------------------- *)

Lemma short_outside q u j d : (length u <= q * r)%nat -> (d < r)%nat -> (j < lo \/ lo + Z.of_nat q <= j)%Z -> list_sequence u j d = 0.
Proof.
  intros Hu Hd Hj. unfold list_sequence, sequence. cbn [window_first space_of]. fold lo. destruct (Z.ltb_spec j lo); auto. unfold vr, place.
  cbn [window_first space_of functions vector_number]. fold lo r. rewrite nth_overflow; auto. eapply Nat.le_trans. apply Hu.
  assert (q <= Z.to_nat (j - lo))%nat by lia. nia.
Qed.

Lemma point_sequence d j d' : (d < r)%nat -> (d' < r)%nat -> (lo <= 0)%Z -> list_sequence (unit_at 1 (Z.to_nat (- lo) * r + d)) j d' = point_of d j d'.
Proof.
  intros Hd Hd' H0. unfold list_sequence, sequence, point_of. cbn [window_first space_of]. fold lo. unfold vr, place, unit_at.
  cbn [window_first space_of functions vector_number]. fold lo r. set (x := (Z.to_nat (- lo) * r + d)%nat).
  destruct (Z.ltb_spec j lo). { destruct (Z.eqb_spec j 0); [lia|auto]. }
  set (y := (Z.to_nat (j - lo) * r + d')%nat).
  destruct (Z.eqb_spec j 0) as [->|J]; [destruct (Nat.eqb_spec d' d) as [->|D]|]; cbn [andb].
  - replace y with x by (unfold x, y; change (0 - lo)%Z with (- lo)%Z; reflexivity). rewrite app_nth2, repeat_length by (rewrite repeat_length; lia). rewrite Nat.sub_diag. auto.
  - assert (y <> x). { unfold x, y. replace (0 - lo)%Z with (- lo)%Z by lia. lia. }
    destruct (Nat.lt_ge_cases y x). rewrite app_nth1 by (rewrite repeat_length; auto). rewrite nth_zeros. auto.
    rewrite app_nth2, repeat_length by (rewrite repeat_length; lia). destruct (y - x)%nat eqn:E; [lia|]. destruct n0; auto.
  - assert (y <> x).
    { unfold x, y. destruct (Z_lt_ge_dec j 0).
      - apply place_before; auto. lia.
      - apply not_eq_sym. apply place_before; auto. lia. }
    destruct (Nat.lt_ge_cases y x). rewrite app_nth1 by (rewrite repeat_length; auto). rewrite nth_zeros. auto.
    rewrite app_nth2, repeat_length by (rewrite repeat_length; lia). destruct (y - x)%nat eqn:E; [lia|]. destruct n0; auto.
Qed.

Definition list_weight (d j : nat) : R := IZR (nth j (nth d (list_weights c) []) 0%Z).

Lemma component_sequence d j d' : (d < r)%nat -> (d' < r)%nat -> list_sequence (list_component m c d) j d' =
  IZR (list_scale c) * point_of d j d' - sum (S (list_order c)) (fun s => list_weight d s * list_sequence (functional c) (j - Z.of_nat s)%Z d').
Proof.
  intros Hd Hd'. destruct window_facts as [_ [_ [_ [W _]]]]. unfold list_component. fold r lo. unfold list_sequence. rewrite sequence_addmul, sequence_combine.
  rewrite map_length, seq_length. change (sequence (vector_number m 0) (space_of c 0)) with list_sequence. rewrite point_sequence by (auto; lia).
  unfold Rminus. f_equal. match goal with |- _ = - sum ?n ?g => replace (- sum n g) with (sum n (fun x => -1 * g x)) by (rewrite sum_scal; ring) end.
  apply sum_ext; intros s Hs.
  change 0%Z with (Z.opp 0) at 1. rewrite (map_nth Z.opp), opp_IZR. unfold list_weight.
  rewrite nth_map_seq by auto. rewrite list_right by auto. ring.
Qed.

Lemma differences_sequence j d : (d < r)%nat -> list_sequence (list_differences m c) j d = vector_differences (list_order c) (list_sequence (functional c)) j d.
Proof.
  intros Hd. destruct window_facts as [W1 [W2 [W3 _]]]. destruct (mask_facts (i O) (Numbers O)) as [M1 _].
  apply (sequence_differences (vector_number m (i O)) (space_of c (i O)) W1 M1 W3 (functional c) (list_order c) j d Hd).
Qed.

Lemma change_sequence k j d : (d < r)%nat -> list_sequence (list_change m c (nth (i k) (each_vector m) (0%Z, []))) j d =
  IZR (list_common m) * (transit A r (F k) (L k) (a k) 0 (list_sequence (functional c)) j d - list_sequence (functional c) j d).
Proof.
  intros Hd. destruct window_facts as [W1 [W2 [W3 [_ [_ [_ W4]]]]]]. unfold list_change. unfold list_sequence at 1. rewrite sequence_addmul, opp_IZR.
  change (sequence (vector_number m 0) (space_of c 0)) with list_sequence. fold A r lo len.
  assert (Hu : (length (functional c) <= size)%nat) by (eapply Nat.le_trans; [apply W4|]; unfold size; apply Nat.mul_le_mono_r; lia).
  assert (E := list_move k 0 (functional c) j d Hu ltac:(lia) Hd). cbv beta in E. change (vector_first (vector_number m (i k))) with (fst (nth (i k) (each_vector m) (0%Z, []))) in E at 1.
  change (of_points (vector_number m (i k))) with (snd (nth (i k) (each_vector m) (0%Z, []))) in E at 1. rewrite E. ring.
Qed.

Lemma basis_outside k j d : (k < N)%nat -> (d < r)%nat -> (j < lo \/ lo + Z.of_nat len <= j)%Z -> b k j d = 0.
Proof.
  intros Hk Hd Hj. destruct window_facts as [_ [_ [_ [_ [_ [W _]]]]]]. destruct (W _ (nth_In (list_spanning c) [] Hk)) as [W1 _].
  unfold b. apply list_outside; auto. lia.
Qed.

Lemma shifted_outside s k : (s < 3)%nat -> (k < N)%nat -> in_window r lo len (fun j d => b k (j - shift_by s)%Z d).
Proof.
  intros Hs Hk j d Hd Hj. rewrite <- nth_shifted by auto. destruct window_facts as [_ [_ [_ [_ [_ [W _]]]]]].
  apply list_outside; auto. assert (I : In (nth (s * N + k) (list_shifted m c) []) (list_shifted m c)).
  { apply nth_In. unfold list_shifted. rewrite !app_length, !map_length. fold N. nia. }
  set (u := nth _ _ _) in *. unfold list_shifted in I. rewrite !in_app_iff in I. destruct I as [I|[I|I]].
  - apply in_map_iff in I. destruct I as [v [<- I]]. destruct (W v I) as [W1 _]. rewrite skipn_length. lia.
  - destruct (W u I) as [W1 _]. lia.
  - apply in_map_iff in I. destruct I as [v [<- I]]. destruct (W v I) as [W1 _]. rewrite app_length, repeat_length. fold r. lia.
Qed.

Definition comes_at (Y : R) (u : vectors) : Prop := comes_in A r lo len F L a N b 3 shift_by (list_entering c) Y Y u.

Lemma comes_more u x y : x <= y -> comes_at x u -> comes_at y u.
Proof.
  intros H [C1 [C2 C3]]. split; auto. split. intros; eapply Rle_trans; eauto. intros k w Hw Hl. destruct (C3 k w Hw Hl) as [v [V1 V2]].
  exists v. split; auto. intros; eapply Rle_trans; eauto.
Qed.

Lemma comes_ext u v Y : (forall j d, (d < r)%nat -> u j d = v j d) -> comes_at Y u -> comes_at Y v.
Proof.
  intros H [C1 [C2 C3]]. split; [|split].
  - intros j d Hd Hj. rewrite <- H by auto. auto.
  - intros j d Hd. rewrite <- H by auto. auto.
  - intros k w Hw Hl. destruct (C3 k w Hw Hl) as [y [V1 V2]]. exists y. split; auto. intros j d Hd. rewrite <- V2 by auto. apply lead_ext; auto.
    intros. symmetry. auto.
Qed.

Lemma comes_list u z : comes m c u = true -> exists Y, comes_at Y (fun j d => z * list_sequence u j d).
Proof.
  intros H. destruct (comes_sound u z H) as [Y [Q [C1 [C2 C3]]]]. exists (Rmax Y Q). split; auto. split.
  - intros j d Hd. eapply Rle_trans. apply C2; auto. apply Rmax_r.
  - intros k w Hw Hl. destruct (C3 k w Hw Hl) as [v [V1 V2]]. exists v. split; auto. intros s q Hs Hq. eapply Rle_trans. apply V1; auto. apply Rmax_l.
Qed.

Definition list_vector : vec := fun d => sum (S (list_order c)) (list_weight d) / IZR (list_scale c).

Theorem data_of_growth lambda l f : exp lambda = INR A -> 0 < l <= INR (list_order c) ->
  (forall x, 0 < x < l -> exists C, forall w, letters A w -> forall p q, (p < N)%nat -> (q < N)%nat -> Rabs (level_word N T w p q) <= C * exp (- x * lambda) ^ length w) ->
  bounded_data r f -> exists phi, tends_to_vector A r (list_data m i f) list_vector phi /\ exponent_at_least phi l /\
  near_grids A r (list_order c) lambda l (IZR (list_scale c)) (S (list_order c)) list_weight (list_data m i f).
Proof.
  intros Log Hl Growth Hf. destruct window_facts as [W1 [W2 [W3 [W4 [W5 [W6 W7]]]]]]. assert (E0 : 0 < IZR (list_common m)) by (apply IZR_lt; auto).
  assert (Com := Comes). unfold list_comes in Com. rewrite !andb_true_iff in Com. destruct Com as [[[[C1 C2] C3] C4] _].
  rewrite forallb_forall in C1, C3. apply negb_true_iff, Z.eqb_neq in C4. set (U := list_sequence (functional c)).
  assert (Kept : exists Y, forall x, (x < n)%nat -> forall k, i k = x -> comes_at Y (fun j d => transit A r (F k) (L k) (a k) 0 U j d - U j d)).
  { apply all_below. intros x y z Hyz G k Hk. eapply comes_more; eauto. intros x Hx.
    destruct (comes_list _ (/ IZR (list_common m)) (C1 _ (nth_In (each_vector m) (0%Z, []) Hx))) as [Y HY]. exists Y. intros k Hk.
    eapply comes_ext; [|apply HY]. intros j d Hd. rewrite <- Hk. rewrite change_sequence by auto. fold U. field. lra. }
  destruct Kept as [Y1 K1].
  destruct (comes_list _ 1 C2) as [Y2 K2].
  assert (Comp : exists Y, forall d, (d < r)%nat -> comes_at Y (fun j d' => IZR (list_scale c) * point_of d j d' - sum (S (list_order c)) (fun s => list_weight d s * U (j - Z.of_nat s)%Z d'))).
  { apply all_below. intros x y z Hyz G. eapply comes_more; eauto. intros d Hd.
    destruct (comes_list _ 1 (C3 d ltac:(apply in_seq; fold r; lia))) as [Y HY]. exists Y. eapply comes_ext; [|apply HY]. intros j d' Hd'.
    cbv beta. rewrite Rmult_1_l, component_sequence by auto. reflexivity. }
  destruct Comp as [Y3 K3].
  assert (Basis : exists P, forall k, (k < N)%nat -> forall j d, (d < r)%nat -> Rabs (b k j d) <= P).
  { apply all_below. intros x y z Hyz G j d Hd. eapply Rle_trans; eauto. intros k Hk.
    destruct (sequence_bounded (vector_number m 0) (space_of c 0) (nth k (list_spanning c) [])) as [B HB]. exists B. intros j d _. apply HB. }
  destruct Basis as [P HP]. destruct (sequence_bounded (vector_number m 0) (space_of c 0) (functional c)) as [Y4 K4].
  set (Y := Rmax (Rmax Y1 Y2) (Rmax Y3 Y4)).
  assert (Y1' : Y1 <= Y) by (eapply Rle_trans; [apply (Rmax_l Y1 Y2)|apply Rmax_l]). assert (Y2' : Y2 <= Y) by (eapply Rle_trans; [apply (Rmax_r Y1 Y2)|apply Rmax_l]).
  assert (Y3' : Y3 <= Y) by (eapply Rle_trans; [apply (Rmax_l Y3 Y4)|apply Rmax_r]). assert (Y4' : Y4 <= Y) by (eapply Rle_trans; [apply (Rmax_r Y3 Y4)|apply Rmax_r]).
  destruct (data_limit A r lo len W1 F L a (fun k => proj1 (proj2 (proj2 (mask_facts (i k) (Numbers k))))) (fun k => proj2 (proj2 (proj2 (mask_facts (i k) (Numbers k)))))
    N b T P list_invariant HP 3%nat shift_by (fun k Hk j d Hd => basis_outside k j d Hk Hd) shifted_outside (list_order c) lambda l Log Hl Growth U
    (list_order c) (list_entering c) Y Y (S (list_order c)) list_weight (IZR (list_scale c))) with (f := f) as [phi [Lim [Ex Gr]]]; auto.
  - intros j d Hd Hj. apply (short_outside (len - list_order c)); auto. destruct Hj; [left|right]; lia.
  - intros j d Hd. eapply Rle_trans. apply K4. auto.
  - apply IZR_neq. auto.
  - intros k. eapply comes_more; [apply Y1'|]. apply (K1 (i k) (Numbers k) k eq_refl).
  - eapply comes_more; [apply Y2'|]. eapply comes_ext; [|apply K2]. intros j d Hd. cbv beta. rewrite Rmult_1_l. apply differences_sequence. auto.
  - intros d Hd. eapply comes_more; [apply Y3'|]. apply K3. auto.
  - exists phi. split; auto.
Qed.

(* Constants are kept. *)
Lemma constants_total_real Ms y t d : (forall M, In M Ms -> square r M = true) -> (d < r)%nat -> forall k, IZR (constants_total A k Ms y t d) =
  sum (length Ms) (fun x => if (Z.of_nat A * ((t - (k + Z.of_nat x)) / Z.of_nat A) =? t - (k + Z.of_nat x))%Z
    then sum r (fun d' => IZR (entry (nth x Ms []) d' d) * IZR (nth d' y 0%Z)) else 0).
Proof.
  intros HM Hd. induction Ms as [|M Ms IH]; intros k; auto. cbn [constants_total length]. rewrite plus_IZR, (IH (fun M' I => HM M' (or_intror I))).
  change (S (length Ms)) with (1 + length Ms)%nat. rewrite sum_add. cbn [sum]. rewrite Rplus_0_l. f_equal.
  - rewrite Z.add_0_r. destruct (_ =? _)%Z; auto. destruct (proj1 (square_spec r M) (HM M (or_introl eq_refl))) as [HL _].
    rewrite (dot_sum r) by (rewrite map_length; apply Nat.eq_le_incl; exact HL). apply sum_ext; intros d' Hd'. f_equal. f_equal. simpl nth.
    unfold entry. apply (nth_map_nil (fun row => nth d row 0%Z)). destruct d; auto.
  - apply sum_ext; intros x _. replace (k + 1 + Z.of_nat x)%Z with (k + Z.of_nat (1 + x))%Z by lia. reflexivity.
Qed.

Definition constant_data : vectors := fun _ d => IZR (nth d (constants c) 0%Z).

Lemma constants_kept k j d : (d < r)%nat -> vector_step A r (F k) (L k) (a k) constant_data j d = constant_data j d.
Proof.
  intros Hd. destruct window_facts as [W1 [W2 _]]. assert (E0 : 0 < IZR (list_common m)) by (apply IZR_lt; auto).
  destruct (mask_facts (i k) (Numbers k)) as [M1 [M2 _]]. rewrite forallb_forall in M2.
  assert (Con := Constants). unfold list_constants in Con. rewrite !andb_true_iff in Con. destruct Con as [[_ _] H]. rewrite forallb_forall in H.
  specialize (H _ (nth_In (each_vector m) (0%Z, []) (Numbers k))). rewrite forallb_forall in H.
  assert (B := Z.mod_pos_bound j (Z.of_nat A) ltac:(lia)). assert (D := Z.div_mod j (Z.of_nat A) ltac:(lia)).
  specialize (H (Z.to_nat (j mod Z.of_nat A)) ltac:(apply in_seq; fold A; lia)). rewrite forallb_forall in H. specialize (H d ltac:(apply in_seq; fold r; lia)).
  apply Z.eqb_eq in H. rewrite Z2Nat.id in H by lia. apply (f_equal IZR) in H. rewrite mult_IZR in H. fold A in H.
  rewrite (constants_total_real (of_points (vector_number m (i k))) (constants c) _ d M2 Hd) in H.
  apply (Rmult_eq_reg_l (IZR (list_common m))); [|lra]. unfold constant_data at 2. rewrite <- H. unfold vector_step. rewrite <- sum_scal.
  replace (S (L k)) with (length (of_points (vector_number m (i k)))) by lia. apply sum_ext; intros x Hx. cbv zeta. cbn beta.
  change (fst (nth (i k) (each_vector m) (0%Z, []))) with (F k). cbv beta. set (k0 := (vector_first (vector_number m (i k)) + Z.of_nat x)%Z).
  assert (E : ((j - k0) / Z.of_nat A = j / Z.of_nat A + (j mod Z.of_nat A - k0) / Z.of_nat A)%Z).
  { rewrite D at 1. replace (Z.of_nat A * (j / Z.of_nat A) + j mod Z.of_nat A - k0)%Z with (j / Z.of_nat A * Z.of_nat A + (j mod Z.of_nat A - k0))%Z by ring.
    apply Z.div_add_l. lia. }
  replace (Z.of_nat A * ((j - k0) / Z.of_nat A) =? j - k0)%Z with (Z.of_nat A * ((j mod Z.of_nat A - k0) / Z.of_nat A) =? j mod Z.of_nat A - k0)%Z.
  2: { rewrite E. destruct (Z.eqb_spec (Z.of_nat A * ((j mod Z.of_nat A - k0) / Z.of_nat A)) (j mod Z.of_nat A - k0)),
       (Z.eqb_spec (Z.of_nat A * (j / Z.of_nat A + (j mod Z.of_nat A - k0) / Z.of_nat A)) (j - k0)); auto; lia. }
  destruct (_ =? _)%Z; [|ring]. rewrite <- sum_scal. apply sum_ext; intros d' Hd'. unfold point_matrix, constant_data.
  change (vector_common (vector_number m (i k))) with (list_common m). unfold k0.
  replace (Z.to_nat (vector_first (vector_number m (i k)) + Z.of_nat x - vector_first (vector_number m (i k)))) with x by lia. field. lra.
Qed.

Lemma constant_levels k j d : (d < r)%nat -> list_data m i constant_data k j d = constant_data j d.
Proof.
  revert j d. induction k; intros j d Hd; auto. unfold list_data. cbn [vector_levels]. fold A r. fold (list_data m i constant_data).
  rewrite <- (constants_kept k j d Hd). unfold vector_step. apply sum_ext; intros x _. cbv zeta. destruct (_ =? _)%Z; auto.
  apply sum_ext; intros d' Hd'. f_equal. apply IHk. auto.
Qed.

(* So a limit is not always 0. *)
Lemma some_limit : (forall f, bounded_data r f -> exists phi, tends_to_vector A r (list_data m i f) list_vector phi) ->
  exists f phi x, bounded_data r f /\ tends_to_vector A r (list_data m i f) list_vector phi /\ phi x <> 0.
Proof.
  intros H. assert (Cb : bounded_data r constant_data).
  { destruct (all_below r (fun d y => Rabs (IZR (nth d (constants c) 0%Z)) <= y)) as [B HB]. intros; eapply Rle_trans; eauto.
    intros d _. eexists. apply Rle_refl. exists B. intros j d Hd. apply HB. auto. }
  destruct (H _ Cb) as [phi Lim]. exists constant_data, phi, 0. split; auto. split; auto. intros Zero.
  assert (Con := Constants). unfold list_constants in Con. rewrite !andb_true_iff in Con. destruct Con as [[E _] _]. apply existsb_exists in E.
  destruct E as [d [Hd E]]. apply in_seq in Hd. fold r in Hd. apply negb_true_iff, Z.eqb_neq in E. apply E. apply eq_IZR. apply cond_eq. intros eps He.
  destruct Lim as [_ Lim]. destruct (Lim (eps / 2) ltac:(lra)) as [n0 Hn]. specialize (Hn n0 (le_n n0) 0%Z d ltac:(lia)). rewrite constant_levels in Hn by lia.
  unfold constant_data in Hn. replace (IZR 0 / INR A ^ n0) with 0 in Hn by (unfold Rdiv; ring). rewrite Zero, Rmult_0_r in Hn. lra.
Qed.
End One.
End Sound.

(* ---- the theorems -------------------------------------------------------------------------------------------------------- *)

Lemma nth_map_default {X Y} (f : X -> Y) l n x y : f x = y -> nth n (map f l) y = f (nth n l x).
Proof. intros <-. apply map_nth. Qed.

Lemma list_radius_growth m s c lambda l u : lists_space m s c = true -> exp lambda = INR (list_arity m) -> u <= exp ((INR (list_order c) - l) * lambda) ->
  (let T := lists_family m s c in radius_at_most (size T) (count T) (real T) u) ->
  forall i, allowed (length (each_vector m)) s i -> (forall k, (i k < length (each_vector m))%nat) /\
  forall x, 0 < x < l -> exists C, forall w, letters (list_arity m) w -> forall p q, (p < length (list_spanning c))%nat -> (q < length (list_spanning c))%nat ->
  Rabs (level_word (length (list_spanning c)) (fun k t => real (vector_family (vector_number m (i k)) (space_of c (i k))) t) w p q) <= C * exp (- x * lambda) ^ length w.
Proof.
  intros H Log HU HR i Hi. unfold lists_space in H. rewrite !andb_true_iff in H. destruct H as [[[[HW HS] _] _] HK].
  destruct (window_facts m c HW) as [A2 _]. set (A := list_arity m) in *. set (N := length (list_spanning c)) in *. set (z := (Z.of_nat A ^ Z.of_nat (list_order c))%Z) in *.
  set (each := map (map (map (map (Z.mul z)))) (list_restricted c)).
  assert (S := HS). unfold list_spaces in S. rewrite !andb_true_iff in S. destruct S as [[[[[S1 S2] S3] _] _] _]. apply Nat.eqb_eq in S1. rewrite forallb_forall in S2, S3. fold N in S2.
  assert (Len : length each = length (each_vector m)) by (unfold each; rewrite map_length; auto).
  assert (Digits : forall Ms, In Ms each -> length Ms = A).
  { intros Ms I. apply in_map_iff in I. destruct I as [Ms' [<- I]]. rewrite map_length. destruct (In_nth _ _ [] I) as [x [Hx E]].
    assert (K := space_count (vector_number m x) (space_of c x) (S3 x (proj2 (in_seq _ _ _) (conj (Nat.le_0_l x) (eq_ind _ (fun y => (x < y)%nat) Hx _ S1))))).
    change (length (nth x (list_restricted c) []) = A) in K.
    unfold zmat, zvec in *. rewrite E in K. exact K. }
  assert (Squares : forall Ms M, In Ms each -> In M Ms -> square N M = true).
  { intros Ms M I J. apply in_map_iff in I. destruct I as [Ms' [<- I]]. apply in_map_iff in J. destruct J as [M' [<- J]].
    specialize (S2 Ms' I). rewrite forallb_forall in S2. specialize (S2 M' J). apply square_spec in S2. destruct S2 as [Q1 Q2]. apply square_spec. split.
    rewrite map_length. auto. intros row R. apply in_map_iff in R. destruct R as [row' [<- R]]. rewrite map_length. auto. }
  rewrite <- Len in HK, Hi. destruct (along_growth s A N _ each u Digits Squares HK HR i Hi) as [Hn G].
  split. { intros k. rewrite <- Len. apply Hn. }
  intros x Hx. set (g := exp ((INR (list_order c) - x) * lambda)).
  assert (L0 := log_positive A A2 lambda Log).
  assert (Hg : u < g). { eapply Rle_lt_trans. apply HU. unfold g. apply exp_less. apply Rmult_lt_compat_r; lra. }
  destruct (G g Hg (exp_pos _)) as [C HC]. exists C. intros w Hw p q Hp Hq. specialize (HC w Hw p q Hp Hq).
  assert (Ez : IZR z = INR A ^ list_order c) by (unfold z; apply (arity_power A A2)). assert (P0 : 0 < INR A ^ list_order c) by (apply power_positive; auto).
  set (T := fun k t => real (vector_family (vector_number m (i k)) (space_of c (i k))) t).
  replace (fun k => matrix_of N (list_common m * list_place_value c) each (i k)) with (fun k t p q => IZR z * T k t p q) in HC.
  - rewrite level_word_scaled, Ez, Rabs_mult, Rabs_pos_eq in HC by (apply pow_le; lra).
    apply (Rmult_le_reg_l ((INR A ^ list_order c) ^ length w)). apply pow_lt; auto. eapply Rle_trans. apply HC.
    right. replace g with (INR A ^ list_order c * exp (- x * lambda)). rewrite Rpow_mult_distr. ring.
    unfold g. rewrite <- Log, exp_power, <- exp_plus. f_equal. ring.
  - extensionality k. extensionality t. extensionality p'. extensionality q'. unfold T, matrix_of, real, mr, letter, each.
    cbn [vector_family matrices denominator restricted space_of place_value vector_common vector_number].
    unfold entry. rewrite (nth_map_default (map (map (map (Z.mul z)))) _ _ [] []), (nth_map_default (map (map (Z.mul z))) _ _ [] []),
      (nth_map_default (map (Z.mul z)) _ _ [] []), (nth_map_default (Z.mul z) _ _ 0%Z 0%Z) by (auto; lia).
    rewrite !mult_IZR. unfold Rdiv. symmetry. apply Rmult_assoc.
Qed.

Theorem lists_of_radius m s c l : lists_space m s c = true ->
  (exists lambda, exp lambda = INR (list_arity m) /\ 0 < l <= INR (list_order c) /\ real_of (list_bound c) <= exp ((INR (list_order c) - l) * lambda)) ->
  (let T := lists_family m s c in radius_at_most (size T) (count T) (real T) (real_of (list_bound c))) -> lists_hold_real m s l.
Proof.
  intros H [lambda [Log [Hl HU]]] HR. assert (H' := H). unfold lists_space in H'. rewrite !andb_true_iff in H'. destruct H' as [[[[HW HS] HC] HM] HK].
  exists (list_vector c). split.
  - assert (Com := HM). unfold list_comes in Com. rewrite !andb_true_iff in Com. destruct Com as [[_ C4] C5]. apply negb_true_iff, Z.eqb_neq in C4.
    apply existsb_exists in C5. destruct C5 as [d [Hd C5]]. apply in_seq in Hd. apply negb_true_iff, Z.eqb_neq in C5. exists d. split. lia.
    unfold list_vector, list_weight. intros E. apply C5. apply eq_IZR. simpl (IZR 0).
    assert (S0 : sum (S (list_order c)) (fun j => IZR (nth j (nth d (list_weights c) []) 0%Z)) = 0).
    { apply (Rmult_eq_reg_r (/ IZR (list_scale c))). unfold Rdiv in E. rewrite E. ring. apply Rinv_neq_0_compat, IZR_neq. auto. }
    rewrite <- S0. clear. generalize (nth d (list_weights c) []) (S (list_order c)). intros w n. revert w. induction n; intros w. simpl. auto.
    change (S n) with (1 + n)%nat. rewrite sum_add. cbn [sum]. destruct w as [|x w].
    + simpl. rewrite sum_zero. ring. intros k _. destruct k; auto.
    + change (1 + n)%nat with (S n). cbn [firstn fold_right]. rewrite plus_IZR, IHn. simpl nth. ring.
  - intros i Hi. destruct (list_radius_growth m s c lambda l _ H Log HU HR i Hi) as [Hn G].
    assert (D := fun f => data_of_growth m c HW HS HM i Hn lambda l f Log Hl G). split.
    + intros f Hf. destruct (D f Hf) as [F [Lim [Ex _]]]. exists F. split; auto. split; auto.
    + destruct (some_limit m c HW HC i Hn) as [f [F [x [Hf [Lim Hx]]]]]. intros f Hf. destruct (D f Hf) as [F [Lim _]]. exists F. auto.
      exists f, F, x. split; auto. split; auto.
Qed.

(* What the checkers accept is true. *)
Theorem check_vector_lists_sound m s l c : check_vector_lists m s l c = true -> vector_lists_hold m s l.
Proof.
  intros H. unfold check_vector_lists in H. rewrite !andb_true_iff in H. destruct H as [[HS HB] HR].
  assert (A2 : (2 <= list_arity m)%nat). { unfold lists_space in HS. rewrite !andb_true_iff in HS. apply (window_facts m c). apply HS. }
  destruct (exp_onto (INR (list_arity m)) (arity_positive _ A2)) as [lambda Log].
  apply (below_power_sound lambda) in HB; auto. destruct HB as [Hl HU]. apply (lists_of_radius m s c (real_of l) HS). exists lambda. auto.
  apply radius_bounded, (check_radius_sound _ _ HR).
Qed.

Theorem check_vector_scheme_sound a l c : check_vector_scheme a l c = true -> vector_scheme_holds a l.
Proof.
  intros H. unfold check_vector_scheme in H. cbv zeta in H. rewrite !andb_true_iff in H. destruct H as [[HS HB] HR]. unfold vector_scheme_holds.
  set (m := VectorMasks _ _ _ _) in *. assert (A2 : (2 <= list_arity m)%nat). { unfold lists_space in HS. rewrite !andb_true_iff in HS. apply (window_facts m c). apply HS. }
  destruct (exp_onto (INR (list_arity m)) (arity_positive _ A2)) as [lambda Log].
  destruct (below_power_strictly_sound lambda _ _ _ _ Log A2 HB) as [L0 [x [Hx HU]]]. exists x. split. lra. apply (lists_of_radius m Any c x HS).
  exists lambda. split; auto. split; auto. lra. apply radius_bounded, (check_radius_sound _ _ HR).
Qed.
