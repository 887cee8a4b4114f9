(* The exponent of one component of vectors of functions (SPEC.md, section 5.9, Theorem 45): a part of the space on which the
   component is 0 says nothing of it; values of the component at points after words tell the rest apart. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Blocks Integers Sections Eigenvalue Check Subdivision Coefficients Grid Differences
  Stability Refinable Exponent Levels Enclosure Number Exact Vectors VectorsAbove VectorsExact.
Import ListNotations.
Open Scope R_scope.

(* ---- a component that does not see a part of the space ----------------------------------------------------------------------- *)

Section Component.
Variables (A r : nat) (F : Z) (L : nat) (a : Z -> nat -> nat -> R).
Hypothesis Arity : (2 <= A)%nat.
Variables (U M : nat) (b : nat -> vectors) (T : nat -> mat).
Let N := (U + M)%nat.
Hypothesis Invariant : forall t k, (t < A)%nat -> (k < N)%nat -> forall j c, (c < r)%nat ->
  transit A r F L a t (b k) j c = sum N (fun l => T t l k * b l j c).
Hypothesis Triangular : forall t, (t < A)%nat -> forall i j, (i < M)%nat -> (j < U)%nat -> T t (U + i)%nat j = 0.
Variable k : nat.
Hypothesis Component : (k < r)%nat.
Hypothesis Unseen : forall i j, (i < U)%nat -> b i j k = 0.
Notation seen := (rest U T).

Lemma span_seen w y j : letters A w ->
  span N b (run N T w y) j k = sum M (fun p => sum M (fun l => product M seen w p l * y (U + l)%nat) * b (U + p)%nat j k).
Proof.
  intros Hw. unfold span. unfold N at 1. rewrite sum_add, sum_zero, Rplus_0_l by (intros i Hi; rewrite Unseen by auto; ring).
  apply sum_ext; intros p Hp. f_equal. rewrite run_product by (unfold N; lia). unfold N at 1. rewrite sum_add, sum_zero, Rplus_0_l.
  - apply sum_ext; intros l Hl. f_equal. apply (product_rest U M A T Triangular w Hw p l Hp Hl).
  - intros l Hl. change (product N T w (U + p)%nat l) with (product (n U M) T w (U + p)%nat l).
    rewrite (product_below U M A T Triangular w Hw p l Hp Hl). ring.
Qed.

Lemma component_values P u start B g : (forall l, (l < N)%nat -> forall j c, (c < r)%nat -> Rabs (b l j c) <= P) ->
  (forall i c, (c < r)%nat -> Rabs (u i c) <= B) ->
  (forall w, letters A w -> length w = start -> exists y, forall j c, (c < r)%nat -> after A r F L a w u j c = span N b y j c) ->
  0 < g <= 1 -> growth M A seen g -> exists C, forall n i, Rabs (Refinable.values A r F L a u n i k) <= C * g ^ n.
Proof.
  intros HP HB HE Hg [C0 HC]. apply (component_shrinks A r F L a Arity N b T Invariant u start B HB HE k g Hg Component).
  set (C := Rmax C0 0). assert (CP : 0 <= C) by apply Rmax_r. set (P' := Rmax P 0). assert (PP : 0 <= P') by apply Rmax_r.
  intros Y Y0. exists (INR M * (INR M * (C * Y) * P')). split.
  { apply Rmult_le_pos. apply pos_INR. apply Rmult_le_pos; auto. apply Rmult_le_pos. apply pos_INR. apply Rmult_le_pos; auto. }
  intros w y Hw Hy j. rewrite span_seen by auto. eapply Rle_trans. apply sum_abs.
  replace (INR M * (INR M * (C * Y) * P') * g ^ length w) with (INR M * (INR M * (C * g ^ length w * Y) * P')) by ring.
  apply sum_bound. intros p Hp. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos.
  - eapply Rle_trans. apply sum_abs. apply sum_bound. intros l Hl. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos.
    + eapply Rle_trans. apply HC; auto. apply Rmult_le_compat_r. apply pow_le; lra. apply Rmax_l.
    + apply Hy. unfold N. lia.
  - eapply Rle_trans. apply HP; auto. unfold N. lia. apply Rmax_l.
Qed.

(* ---- values of the component that tell the rest ------------------------------------------------------------------------------ *)

Variables (d : vectors) (images : nat) (factor : nat -> nat -> R) (word : nat -> list nat).
Hypothesis Words : forall h, (h < images)%nat -> letters A (word h).
Hypothesis Spanned : forall l, (l < M)%nat -> forall j c, (c < r)%nat ->
  b (U + l)%nat j c = sum images (fun h => factor l h * after A r F L a (word h) d j c).
Variables (readings : nat) (weight : nat -> nat -> R) (looking : nat -> list nat) (point : nat -> Z) (pivot : R).
Hypothesis Pivot : pivot <> 0.
Hypothesis Looking : forall h, (h < readings)%nat -> letters A (looking h).
Hypothesis Tell : forall l i, (l < M)%nat -> (i < M)%nat -> sum readings (fun h => weight l h *
  sum M (fun p => product M seen (looking h) p i * b (U + p)%nat (point h) k)) = pivot * identity i l.

Lemma reading_after w i j : letters A w -> (i < M)%nat ->
  after A r F L a w (b (U + i)%nat) j k = sum M (fun p => product M seen w p i * b (U + p)%nat j k).
Proof.
  intros Hw Hi. rewrite (after_span A r F L a N b T Invariant w Hw (b (U + i)%nat) (unit (U + i)%nat)); auto.
  - rewrite span_seen by auto. apply sum_ext; intros p Hp. f_equal. rewrite <- (sum_identity M i) by auto.
    apply sum_ext; intros l Hl. unfold unit. rewrite Rmult_comm. f_equal. unfold identity.
    destruct (Nat.eqb_spec (U + l) (U + i)), (Nat.eqb_spec l i); auto; lia.
  - intros j' c Hc. unfold span, unit. rewrite sum_identity; auto. unfold N. lia.
Qed.

Lemma seen_products q C : 0 < q -> 0 <= C -> (forall n i, Rabs (Refinable.values A r F L a d n i k) <= C * q ^ n) -> growth M A seen q.
Proof.
  intros Q C0 H. assert (P0 : 0 < Rabs pivot) by (apply Rabs_pos_lt; auto).
  set (cost := fun l i => sum readings (fun h => Rabs (weight l h) * (q ^ length (looking h) * sum images (fun g => Rabs (factor i g) * q ^ length (word g))))).
  set (most := sum M (fun l => sum M (fun i => cost l i))).
  assert (Im : forall i, 0 <= sum images (fun g => Rabs (factor i g) * q ^ length (word g))).
  { intros i. apply sum_nonneg. intros. apply Rmult_le_pos. apply Rabs_pos. apply pow_le; lra. }
  assert (Cost : forall l i, 0 <= cost l i).
  { intros l i. apply sum_nonneg. intros h _. apply Rmult_le_pos. apply Rabs_pos. apply Rmult_le_pos; auto. apply pow_le; lra. }
  exists (/ Rabs pivot * (most * C)). intros w Hw l i Hl Hi.
  assert (E : pivot * product M seen w l i = sum readings (fun h => weight l h * after A r F L a (looking h ++ w) (b (U + i)%nat) (point h) k)).
  { rewrite (sum_ext readings _ (fun h => sum M (fun o => weight l h * sum M (fun p => product M seen (looking h) p o * b (U + p)%nat (point h) k) *
      product M seen w o i))).
    - rewrite sum_swap. rewrite (sum_ext M _ (fun o => identity o l * (pivot * product M seen w o i))).
      + rewrite sum_identity; auto.
      + intros o Ho. rewrite (sum_ext readings _ (fun h => product M seen w o i * (weight l h *
          sum M (fun p => product M seen (looking h) p o * b (U + p)%nat (point h) k)))) by (intros; ring).
        rewrite sum_scal, Tell by auto. ring.
    - intros h Hh. rewrite reading_after by (auto; apply letters_app; split; auto). symmetry.
      transitivity (sum M (fun p => sum M (fun o => weight l h * (product M seen (looking h) p o * product M seen w o i * b (U + p)%nat (point h) k)))).
      + rewrite sum_swap. apply sum_ext; intros o Ho.
        transitivity (sum M (fun p => weight l h * product M seen w o i * (product M seen (looking h) p o * b (U + p)%nat (point h) k))).
        rewrite sum_scal. ring. apply sum_ext; intros; ring.
      + rewrite <- sum_scal. apply sum_ext; intros p Hp. rewrite product_app by auto. rewrite sum_scal. f_equal. rewrite Rmult_comm, <- sum_scal.
        apply sum_ext; intros. ring. }
  assert (B : Rabs (pivot * product M seen w l i) <= most * C * q ^ length w).
  { rewrite E. eapply Rle_trans. apply sum_abs. apply Rle_trans with (cost l i * (C * q ^ length w)).
    - unfold cost. rewrite (Rmult_comm (sum readings _)), <- sum_scal. apply sum_le. intros h Hh. rewrite Rabs_mult.
      replace (C * q ^ length w * (Rabs (weight l h) * (q ^ length (looking h) * sum images (fun g => Rabs (factor i g) * q ^ length (word g)))))
        with (Rabs (weight l h) * (C * q ^ length w * q ^ length (looking h) * sum images (fun g => Rabs (factor i g) * q ^ length (word g)))) by ring.
      apply Rmult_le_compat_l. apply Rabs_pos.
      rewrite (after_ext A r F L a _ (b (U + i)%nat) (fun j c => sum images (fun g => factor i g * after A r F L a (word g) d j c)))
        by (auto; intros; apply Spanned; auto).
      rewrite after_sum. eapply Rle_trans. apply sum_abs. rewrite <- sum_scal. apply sum_le. intros g Hg.
      rewrite Rabs_mult, <- after_app, <- (values_after A r F L a Arity). eapply Rle_trans. apply Rmult_le_compat_l. apply Rabs_pos. apply H.
      rewrite !app_length, !pow_add. right. ring.
    - rewrite Rmult_assoc. apply Rmult_le_compat_r. apply Rmult_le_pos; auto. apply pow_le; lra.
      unfold most. eapply Rle_trans. apply (sum_term M (fun i => cost l i) i); auto.
      apply (sum_term M (fun l => sum M (fun i => cost l i)) l); auto. intros. apply sum_nonneg; auto. }
  rewrite Rabs_mult in B. apply (Rmult_le_reg_l (Rabs pivot)); auto. eapply Rle_trans. apply B. right. field. lra.
Qed.
End Component.

(* ---- claims ------------------------------------------------------------------------------------------------------------------ *)

Definition only_solution (a : vector_mask) (phi : nat -> R -> R) : Prop :=
  let solves := is_solution (vector_arity a) (functions a) (vector_first a) (length (of_points a) - 1) (point_matrix a) in
  solves phi /\ (exists c x, (c < functions a)%nat /\ phi c x <> 0) /\
  forall psi, solves psi -> exists z, forall c x, (c < functions a)%nat -> psi c x = z * phi c x.

(* The exponent of component k is at least l, or between l and u, or what a number says, as for all components. *)
Definition component_holds (a : vector_mask) (k : nat) (l : Q) : Prop := (k < functions a)%nat /\
  exists phi, only_solution a phi /\ exponent_at_least (phi k) (real_of l).
Definition component_between (a : vector_mask) (k : nat) (l u : Q) : Prop := (k < functions a)%nat /\
  exists phi, only_solution a phi /\ exponent_at_least (phi k) (real_of l) /\ exponent_at_most (phi k) (real_of u).
Definition exact_component_holds (a : vector_mask) (k : nat) (e : exact_number) (lower upper : option Q) : Prop :=
  (k < functions a)%nat /\ one_number e /\ exists phi r s lambda, is_number e r /\ exp lambda = INR (vector_arity a) /\
  exp (- s * lambda) = r /\ only_solution a phi /\ is_lub (exponents (phi k)) s /\ within lower upper s.

(* ---- the checker ------------------------------------------------------------------------------------------------------------- *)

(* In another basis of the space the component is 0 on the first vectors, so many; the radius of their block is below 1. *)
Record hidden := Hidden { unseen : nat; observing : basis; unseen_bound : Q; unseen_radius : certificate }.

Definition rebased (a : vector_mask) (c : vector_certificate) (p : hidden) : family := in_basis (vector_family a c) (observing p).
Definition seen_family (a : vector_mask) (c : vector_certificate) (p : hidden) : family := other_blocks (unseen p) (rebased a c p).
Definition rebased_vector (c : vector_certificate) (p : hidden) (i : nat) : list Z :=
  combine_lists (map (fun row => nth i row 0%Z) (basis_rows (observing p))) (spanning c).

(* Each value of component k is 0; the list begins with one of component q. *)
Fixpoint component_zero (r k q : nat) (l : list Z) : bool :=
  match l with [] => true | x :: l' => (negb (q =? k)%nat || (x =? 0)%Z) && component_zero r k (if (S q =? r)%nat then O else S q) l' end.

Definition component_space (a : vector_mask) (k : nat) (c : vector_certificate) (p : hidden) : bool :=
  vector_space a c && (k <? functions a)%nat && well_formed (vector_family a c) && basis_valid (length (spanning c)) (observing p) &&
  triangular (unseen p) (rebased a c p) &&
  forallb (fun i => component_zero (functions a) k 0 (rebased_vector c p i)) (seq 0 (unseen p)) &&
  ((unseen p =? 0)%nat || (Qnum (unseen_bound p) <? Zpos (Qden (unseen_bound p)))%Z &&
    check_radius (Claim (first_block (unseen p) (rebased a c p)) None (Some (unseen_bound p))) (unseen_radius p)).

(* Words, and points after them: values of the component there, combined by rows over a scale, are coordinates of the rest. *)
Record observation := Observation { seen_at : list (list nat * nat); seen_rows : list (list Z); seen_scale : Z }.

Definition seen_vectors (c : vector_certificate) (p : hidden) : list (list Z) :=
  map (fun i => rebased_vector c p (unseen p + i)) (seq 0 (length (spanning c) - unseen p)).
Definition seen_values (a : vector_mask) (k : nat) (us : list (list Z)) (x : nat) : list Z :=
  map (fun u => nth (x * functions a + k) u 0%Z) us.

Definition observes (a : vector_mask) (k : nat) (c : vector_certificate) (p : hidden) (o : observation) : bool :=
  let turned := matrices (transpose (seen_family a c p)) in let us := seen_vectors c p in
  let rows := map (fun at_ => zrun turned (rev (fst at_)) (seen_values a k us (snd at_))) (seen_at o) in
  negb (seen_scale o =? 0)%Z && forallb (fun at_ => forallb (fun t => t <? vector_arity a)%nat (fst at_)) (seen_at o) &&
  forallb (fun l => zero_list (addmul (-1) (unit_at (seen_scale o) l) (combine_lists (nth l (seen_rows o) []) rows)))
    (seq 0 (length (spanning c) - unseen p)).

(* The radius of a certificate is that of the rest of the space. *)
Definition check_component (a : vector_mask) (k : nat) (l : Q) (c : vector_certificate) (p : hidden) : bool :=
  component_space a k c p && vector_power a l (difference_order c) (space_bound c) &&
  check_radius (Claim (seen_family a c p) None (Some (space_bound c))) (space_radius c).

Definition check_component_between (a : vector_mask) (k : nat) (l u : Q) (d : above_certificate) (p : hidden) (o : observation) : bool :=
  let c := space_proof d in
  component_space a k c p && checks_images a d && observes a k c p o && vector_power a l (difference_order c) (space_bound c) &&
  above_powers (vector_arity a) u (difference_order c) (space_least d) &&
  check_radius (Claim (seen_family a c p) (Some (space_least d)) (Some (space_bound c))) (space_radius c).

Definition check_exact_component (a : vector_mask) (k : nat) (e : exact_number) (lower upper : option Q) (d : above_certificate)
    (p : hidden) (o : observation) (x : exact_certificate) : bool :=
  let c := space_proof d in let m := difference_order c in let h := number_place x in
  component_space a k c p && checks_images a d && observes a k c p o && number_between (vector_arity a) m h &&
  check_number_and_blocks (seen_family a c p) e x && exponent_within a m lower upper h.

(* ---- what it computes -------------------------------------------------------------------------------------------------------- *)

Lemma component_zero_sound r k : forall l q, (q < r)%nat -> component_zero r k q l = true -> forall x y, (q + x = y * r + k)%nat -> (k < r)%nat ->
  nth x l 0%Z = 0%Z.
Proof.
  induction l as [|z l IH]; intros q Hq H x y E Hk. destruct x; auto. cbn [component_zero] in H. apply andb_prop in H. destruct H as [H1 H2].
  destruct x.
  - assert (y = O /\ q = k) as [-> ->]. { destruct y; simpl in E; [lia|]. exfalso. lia. }
    rewrite Nat.eqb_refl in H1. simpl in H1. apply Z.eqb_eq in H1. exact H1.
  - simpl nth. destruct (Nat.eqb_spec (S q) r) as [S0|S0].
    + destruct y. { exfalso. simpl in E. lia. } apply (IH O ltac:(lia) H2 x y); auto. simpl in E. lia.
    + apply (IH (S q) ltac:(lia) H2 x y); auto. lia.
Qed.

Lemma basis_commutes F b t y i : well_formed F = true -> basis_valid (size F) b = true -> (t < count F)%nat -> (i < size F)%nat ->
  apply (size F) (real F t) (apply (size F) (mr (basis_rows b)) y) i =
  apply (size F) (mr (basis_rows b)) (apply (size F) (real (in_basis F b) t) y) i.
Proof.
  intros WF V Ht Hi. destruct (basis_facts F b V) as [Hs [_ [_ [H1 _]]]]. set (n := size F) in *.
  rewrite (apply_ext n (mr (basis_rows b)) (apply n (real (in_basis F b) t) y)
    (scal (/ IZR (basis_scale b)) (apply n (mr (inverse_rows b)) (apply n (real F t) (apply n (mr (basis_rows b)) y))))).
  - rewrite apply_scal. unfold scal. rewrite H1 by auto. field. lra.
  - intros l Hl. rewrite (in_basis_apply F b WF V) by auto. reflexivity.
Qed.

Section Checked.
Variables (a : vector_mask) (k : nat) (c : vector_certificate) (p : hidden).
Hypothesis Space : component_space a k c p = true.
Let A := vector_arity a.
Let r := functions a.
Let F := vector_first a.
Let L := (length (of_points a) - 1)%nat.
Let N := length (spanning c).
Let U := unseen p.
Let M := (N - U)%nat.
Let S := vector_family a c.
Let B := mr (basis_rows (observing p)).
Let T := real (rebased a c p).
Let b (i : nat) : Z -> nat -> R := sequence a c (rebased_vector c p i).

Lemma component_facts : vector_space a c = true /\ (k < r)%nat /\ well_formed S = true /\ basis_valid (size S) (observing p) = true /\
  (U + M = N)%nat /\ (forall t, (t < A)%nat -> forall i j, (i < M)%nat -> (j < U)%nat -> T t (U + i)%nat j = 0) /\
  (2 <= A)%nat /\ checks_space a c = true.
Proof.
  assert (H := Space). unfold component_space in H. rewrite !andb_true_iff in H. destruct H as [[[[[[H1 H2] H3] H4] H5] _] _].
  apply Nat.ltb_lt in H2. apply triangular_spec in H5. destruct H5 as [H5 H6].
  assert (H1' := H1). unfold vector_space in H1'. rewrite !andb_true_iff in H1'. destruct H1' as [[[[[[[[[[HA _] _] _] _] _] _] _] HS] _] _].
  apply Nat.leb_le in HA. split; auto. split; auto. split; auto. split; auto.
  assert (E : count (rebased a c p) = A) by (unfold rebased, in_basis, count; cbn [matrices]; rewrite map_length; apply (space_count a c HS)).
  change (size (rebased a c p)) with N in H5, H6. split. unfold M, U. lia. split; auto. intros t Ht i j Hi Hj. apply H6; auto. rewrite E. auto.
Qed.

Lemma rebased_sum i j q : b i j q = sum N (fun l => B l i * sequence a c (nth l (spanning c) []) j q).
Proof.
  unfold b, rebased_vector. rewrite sequence_combine. apply sum_ext; intros l Hl. f_equal.
  unfold B, mr, entry. rewrite (nth_map_nil (fun row => nth i row 0%Z)); auto. destruct i; auto.
Qed.

Lemma rebased_invariant t i : (t < A)%nat -> (i < N)%nat -> forall j q, (q < r)%nat ->
  transit A r F L (point_matrix a) t (b i) j q = sum N (fun l => T t l i * b l j q).
Proof.
  intros Ht Hi j q Hq. destruct component_facts as [HV [Hk [WF [V [UM [_ [HA HS]]]]]]].
  unfold vector_space in HV. rewrite !andb_true_iff in HV. destruct HV as [[[[[[[[[[_ HO] HP] Hf] HQ] Hlo] Hhi] HF] _] HT] HK].
  apply Nat.leb_le in HP, Hf. apply Z.ltb_lt in HO. apply Z.leb_le in Hlo, Hhi.
  assert (Sh := HT). unfold checks_start in Sh. rewrite !andb_true_iff in Sh. destruct Sh as [[Sh _] _].
  assert (Inv := space_invariant a c HA HO HP Hf HQ Hlo ltac:(lia) Sh HS). fold A r F L N S in Inv.
  unfold transit. rewrite (mix_ext r F L (point_matrix a) _ (fun k0 d => sum N (fun l => B l i * sequence a c (nth l (spanning c) []) (Z.of_nat A * j + Z.of_nat t - k0)%Z d)))
    by (intros; apply rebased_sum).
  rewrite (mix_sum r F L (point_matrix a) N (fun l => B l i) (fun l k0 d => sequence a c (nth l (spanning c) []) (Z.of_nat A * j + Z.of_nat t - k0)%Z d)).
  transitivity (sum N (fun l => B l i * sum N (fun o => real S t o l * sequence a c (nth o (spanning c) []) j q))).
  { apply sum_ext; intros l Hl. f_equal. apply (Inv t l Ht Hl j q Hq). }
  transitivity (sum N (fun o => apply N (real S t) (apply N B (unit i)) o * sequence a c (nth o (spanning c) []) j q)).
  { transitivity (sum N (fun o => sum N (fun l => B l i * (real S t o l * sequence a c (nth o (spanning c) []) j q)))).
    - rewrite sum_swap. apply sum_ext; intros l Hl. rewrite <- sum_scal. apply sum_ext; intros; ring.
    - apply sum_ext; intros o Ho. unfold apply at 1. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros l Hl.
      unfold apply. unfold unit. rewrite (sum_ext N _ (fun j0 => identity j0 i * B l j0)) by (intros; ring). rewrite sum_identity by auto. ring. }
  transitivity (sum N (fun o => sum N (fun l => B o l * T t l i * sequence a c (nth o (spanning c) []) j q))).
  { apply sum_ext; intros o Ho. assert (E := basis_commutes S (observing p) t (unit i) o WF V). change (size S) with N in E. fold B in E.
    assert (ES : count S = A) by (apply (space_count a c HS)).
    rewrite E by (rewrite ?ES; auto). unfold apply at 1. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros l Hl.
    unfold apply, unit. rewrite (sum_ext N (fun j0 => real (in_basis S (observing p)) t l j0 * identity j0 i) (fun j0 => identity j0 i * T t l j0)) by (intros; unfold T, rebased, S; ring).
    rewrite sum_identity by auto. ring. }
  rewrite sum_swap. apply sum_ext; intros l Hl. rewrite rebased_sum, <- sum_scal. apply sum_ext; intros; ring.
Qed.

Lemma rebased_span y : exists y', forall j q, span N (fun l => sequence a c (nth l (spanning c) [])) y j q = span N b y' j q.
Proof.
  destruct component_facts as [HV [Hk [WF [V [UM [_ [HA HS]]]]]]]. destruct (basis_facts S (observing p) V) as [Hs [_ [_ [H1 _]]]].
  change (size S) with N in H1. fold B in H1. set (s := IZR (basis_scale (observing p))) in *.
  set (x := apply N (mr (inverse_rows (observing p))) y) in *. exists (fun i => / s * x i). intros j q. unfold span.
  transitivity (sum N (fun i => sum N (fun l => / s * x i * (B l i * sequence a c (nth l (spanning c) []) j q)))).
  - rewrite sum_swap. apply sum_ext; intros l Hl. assert (E := H1 y l Hl). fold x in E.
    transitivity (/ s * (s * y l) * sequence a c (nth l (spanning c) []) j q). field; lra. rewrite <- E. unfold apply.
    rewrite Rmult_assoc, (Rmult_comm (sum N _)), <- !sum_scal. apply sum_ext; intros; ring.
  - apply sum_ext; intros i Hi. rewrite rebased_sum, <- sum_scal. reflexivity.
Qed.

Lemma rebased_unseen i j : (i < U)%nat -> b i j k = 0.
Proof.
  intros Hi. destruct component_facts as [_ [Hk _]]. assert (H := Space). unfold component_space in H. rewrite !andb_true_iff in H.
  destruct H as [[_ H] _]. rewrite forallb_forall in H. specialize (H i ltac:(apply in_seq; fold U; lia)). fold r in H.
  unfold b, sequence. destruct (j <? window_first c)%Z; auto. unfold vr, place. fold r.
  rewrite (component_zero_sound r k _ O ltac:(lia) H _ (Z.to_nat (j - window_first c))); auto.
Qed.

Lemma rebased_bounded : exists P, forall l, (l < N)%nat -> forall j q, (q < r)%nat -> Rabs (b l j q) <= P.
Proof.
  generalize N. intros w. induction w as [|w [P HP]]. exists 0. intros; lia. destruct (sequence_bounded a c (rebased_vector c p w)) as [Q HQ].
  exists (Rmax P Q). intros l Hl j q Hq. destruct (Nat.eq_dec l w) as [->|].
  - eapply Rle_trans. apply HQ. apply Rmax_r.
  - eapply Rle_trans. apply HP; auto. lia. apply Rmax_l.
Qed.

(* The whole space: the part that is not seen, and the rest *)
Lemma whole_radius w : 0 < w < 1 -> radius_at_most M A (rest U T) w -> exists g, w <= g < 1 /\ radius_at_most N A (real S) g.
Proof.
  intros Hw HR. destruct component_facts as [_ [_ [WF [V [UM [Tri [_ HS]]]]]]].
  assert (ES : count S = A) by (apply (space_count a c HS)).
  assert (Rebased : count (rebased a c p) = A) by (unfold rebased, in_basis; rewrite count_map; exact ES).
  assert (First : exists g, g < 1 /\ radius_at_most U A T g).
  { assert (H := Space). unfold component_space in H. rewrite !andb_true_iff in H. destruct H as [_ H]. apply orb_prop in H.
    destruct H as [H|H]. { apply Nat.eqb_eq in H. exists 0. split. lra. intros g _ _. exists 0. unfold U. rewrite H. intros; lia. }
    apply andb_prop in H. destruct H as [H1 H2]. apply Z.ltb_lt, IZR_lt in H1. apply check_radius_sound, radius_bounded in H2.
    exists (real_of (unseen_bound p)). split.
    - unfold real_of. assert (0 < IZR (Zpos (Qden (unseen_bound p)))) by (apply IZR_lt; lia).
      apply (Rmult_lt_reg_r (IZR (Zpos (Qden (unseen_bound p))))); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    - assert (EF : count (first_block U (rebased a c p)) = A).
      { unfold first_block. rewrite count_map. exact Rebased. }
      intros g G1 G2. specialize (H2 g G1 G2). change (size (first_block (unseen p) (rebased a c p))) with U in H2.
      assert (G := proj1 (growth_first U (rebased a c p) g) H2). rewrite Rebased in G. exact G. }
  destruct First as [g [G1 HF]]. exists (Rmax g w). split.
  { split. apply Rmax_r. apply Rmax_lub_lt; lra. }
  assert (HB : radius_at_most (n U M) A T (Rmax g w)).
  { apply blocks_at_most; auto.
    - intros x X1 X2. apply HF; auto. eapply Rle_lt_trans; [|apply X1]. apply Rmax_l.
    - intros x X1 X2. apply HR; auto. eapply Rle_lt_trans; [|apply X1]. apply Rmax_r. }
  intros x X1 X2. specialize (HB x X1 X2). unfold n in HB. rewrite UM in HB. rewrite <- ES in HB |- *.
  apply (growth_in_basis S (observing p) WF V x ltac:(lra)). exact HB.
Qed.

(* Theorem 45, the lower end *)
Theorem component_of_radius s lambda : exp lambda = INR A -> 0 < s <= INR (difference_order c) ->
  radius_at_most M A (rest U T) (exp (- s * lambda)) -> exists phi, only_solution a phi /\
  (forall n i q, (q < r)%nat -> phi q (IZR i / INR A ^ n) = Refinable.values A r F L (point_matrix a) (sequence a c (fixed c)) n i q) /\
  exponent_at_least (phi k) s.
Proof.
  intros Log Hs HR. destruct component_facts as [HV [Hk [WF [V [UM [Tri [HA HS]]]]]]].
  assert (Lam := log_positive A HA lambda Log).
  assert (W1 : exp (- s * lambda) < 1). { rewrite <- exp_0. apply exp_less. assert (0 < s * lambda) by (apply Rmult_lt_0_compat; lra). lra. }
  destruct (whole_radius (exp (- s * lambda)) (conj (exp_pos _) W1) HR) as [g [[G1 G2] HG]].
  assert (G0 : 0 < g) by (eapply Rlt_le_trans; [apply exp_pos|apply G1]).
  destruct (log_onto lambda 0 g Lam G0) as [l Hl]. simpl INR in Hl. rewrite Rminus_0_l in Hl.
  assert (L0 : 0 < l).
  { apply Rnot_le_lt. intros N0. assert (1 <= exp (- l * lambda)); [|lra]. rewrite <- exp_0. apply exp_at_most.
    assert (0 <= - l * lambda); [|lra]. apply Rmult_le_pos; lra. }
  assert (L1 : l <= s). { assert (- s <= - l) by (apply (exp_reflects _ _ lambda); auto; lra). lra. }
  unfold vector_space in HV. rewrite !andb_true_iff in HV. destruct HV as [[[[[[[[[[_ HO] HP] Hf] HQ] Hlo] Hhi] HF] _] HT] HK].
  apply Nat.leb_le in HP, Hf. apply Z.ltb_lt in HO. apply Z.leb_le in Hlo, Hhi.
  assert (Sh := HT). unfold checks_start in Sh. rewrite !andb_true_iff in Sh. destruct Sh as [[Sh _] _].
  destruct (values_of_radius a c HA HO HP Hf HQ Hlo ltac:(lia) Sh HS HF HK l g HT HG) as [phi [Sol Val]].
  { exists lambda. split; auto. split. lra. lra. }
  fold A r F L in Sol, Val. destruct Sol as [Sol1 [Sol2 [Sol3 _]]].
  exists phi. split. { split; auto. } split; auto.
  set (v := sequence a c (fixed c)) in *. set (m := difference_order c) in *.
  destruct (start_real a c HA HP Hf HT) as [U1 [U2 U3]]. set (u0 := start_differences a c) in *.
  destruct rebased_bounded as [P HPb]. destruct (sequence_bounded a c u0) as [B0 HB0]. destruct (sequence_bounded a c (fixed c)) as [B1 HB1].
  assert (Same : forall n i, Refinable.values A r F L (point_matrix a) v (Datatypes.S n) (Z.of_nat A * i)%Z k = Refinable.values A r F L (point_matrix a) v n i k).
  { intros n i. rewrite <- !Val by auto. f_equal. rewrite mult_IZR, <- tech_pow_Rmult, <- INR_IZR_INZ.
    assert (PA := arity_positive A HA). assert (PN := power_positive A HA n). field. lra. }
  destruct (grid_exponent A HA (fun n i => Refinable.values A r F L (point_matrix a) v n i k) Same lambda Log m s B1 Hs (fun i => HB1 i k)) as [f [Tf [Cf Ef]]].
  { intros x Hx. destruct (component_values A r F L (point_matrix a) HA U M b T) with (k := k) (P := P) (B := B0) (start := entering c)
      (u := fun i q => 1 * sequence a c u0 i q) (g := exp (- x * lambda)) as [C HC]; auto.
    - rewrite UM. exact rebased_invariant.
    - intros i j. apply rebased_unseen.
    - rewrite UM. exact HPb.
    - intros i q Hq. rewrite Rmult_1_l. apply HB0.
    - intros w Hw Hl'. destruct (enters_span a c HA HO HP Hf HQ Hlo ltac:(lia) Sh HS (entering c) u0 U1 U3 1 w Hw Hl') as [y Hy].
      destruct (rebased_span y) as [y' Hy']. exists y'. intros j q Hq. rewrite UM, <- Hy'. apply Hy. auto.
    - split. apply exp_pos. rewrite <- exp_0. apply exp_at_most. assert (0 <= x * lambda) by (apply Rmult_le_pos; lra). lra.
    - apply HR; [|apply exp_pos]. apply exp_less. apply Rmult_lt_compat_r; lra.
    - exists C. intros n i. rewrite <- values_differences. rewrite <- (values_ext A r F L (point_matrix a) (fun i q => 1 * sequence a c u0 i q)); auto.
      intros j q Hq. rewrite Rmult_1_l. auto. }
  replace (phi k) with f; auto. extensionality x. apply (dense A HA); auto. apply Sol1; auto.
  intros n i. rewrite Val by auto. apply (tends_values A HA (fun n i => Refinable.values A r F L (point_matrix a) v n i k)); auto.
Qed.
End Checked.

(* ---- what a component sees --------------------------------------------------------------------------------------------------- *)

Section Observed.
Variables (a : vector_mask) (k : nat) (c : vector_certificate) (p : hidden) (o : observation).
Hypothesis Space : component_space a k c p = true.
Hypothesis Observes : observes a k c p o = true.
Let A := vector_arity a.
Let r := functions a.
Let N := length (spanning c).
Let U := unseen p.
Let M := (N - U)%nat.
Let T := real (rebased a c p).
Let O := seen_family a c p.
Definition looking_by (h : nat) : list nat := fst (nth h (seen_at o) ([], 0%nat)).
Definition looking_at (h : nat) : Z := (window_first c + Z.of_nat (snd (nth h (seen_at o) ([], 0%nat))))%Z.
Definition seen_weight (l h : nat) : R := IZR (nth h (nth l (seen_rows o) []) 0%Z) * IZR (denominator (seen_family a c p)) ^ length (looking_by h).

Lemma seen_facts : well_formed O = true /\ count O = A /\ size O = M /\
  forall w, letters A w -> forall i j, (i < M)%nat -> (j < M)%nat -> product M (real O) w i j = product M (rest U T) w i j.
Proof.
  destruct (component_facts a k c p Space) as [_ [_ [WF [V [_ [_ [_ HS]]]]]]].
  assert (ER : count (rebased a c p) = A) by (unfold rebased, in_basis; rewrite count_map; apply (space_count a c HS)).
  assert (WR : well_formed (rebased a c p) = true) by (apply in_basis_well_formed; auto).
  split. apply other_well_formed; auto. split. unfold O, seen_family, other_blocks. rewrite count_map. exact ER. split. reflexivity.
  intros w Hw i j Hi Hj. apply (product_ext M A); auto. intros t i' j' Ht _ _. apply other_entry. rewrite ER. auto.
Qed.

Lemma seen_growth g : growth M A (real O) g <-> growth M A (rest U T) g.
Proof.
  destruct seen_facts as [_ [_ [_ H]]]. split; intros [C G]; exists C; intros w Hw i j Hi Hj; [rewrite <- H|rewrite H]; auto.
Qed.

Lemma looking_letters h : (h < length (seen_at o))%nat -> letters A (looking_by h).
Proof.
  intros Hh. assert (H := Observes). unfold observes in H. cbv zeta in H. rewrite !andb_true_iff in H. destruct H as [[_ H] _].
  rewrite forallb_forall in H. specialize (H _ (nth_In _ ([], 0%nat) Hh)). rewrite forallb_forall in H. apply Forall_forall.
  intros t Ht. apply Nat.ltb_lt, H. exact Ht.
Qed.

Lemma observed l i : (l < M)%nat -> (i < M)%nat -> sum (length (seen_at o)) (fun h => seen_weight l h *
  sum M (fun q => product M (rest U T) (looking_by h) q i * sequence a c (rebased_vector c p (U + q)) (looking_at h) k)) =
  IZR (seen_scale o) * identity i l.
Proof.
  intros Hl Hi. destruct seen_facts as [WF [EC [ES EP]]].
  assert (H := Observes). unfold observes in H. cbv zeta in H. rewrite !andb_true_iff in H. destruct H as [[_ _] H].
  rewrite forallb_forall in H. specialize (H l ltac:(apply in_seq; unfold M, N, U in Hl; lia)).
  assert (Z0 := zero_list_vr _ H i). rewrite vr_addmul, vr_unit in Z0. unfold plus, scal in Z0. rewrite combine_lists_vr, map_length in Z0.
  transitivity (IZR (seen_scale o) * unit l i); [|reflexivity].
  match type of Z0 with _ + ?s = 0 => transitivity s; [|lra] end. apply sum_ext; intros h Hh. unfold seen_weight. rewrite Rmult_assoc. f_equal.
  assert (Lt := looking_letters h Hh).
  assert (Lt' : letters (count (transpose O)) (rev (looking_by h))).
  { apply letters_rev. unfold transpose. rewrite count_map, EC. exact Lt. }
  rewrite (nth_indep _ [] (zrun (matrices (transpose O)) (rev (fst ([], 0%nat))) (seen_values a k (seen_vectors c p) (snd ([] : list nat, 0%nat)))))
    by (rewrite map_length; exact Hh).
  rewrite (map_nth (fun at_ => zrun (matrices (transpose O)) (rev (fst at_)) (seen_values a k (seen_vectors c p) (snd at_)))).
  fold (looking_by h). rewrite (vr_zrun (transpose O)) by (auto; apply transpose_well_formed; auto).
  unfold scal. rewrite rev_length. change (denominator (transpose O)) with (denominator O). f_equal.
  change (size (transpose O)) with M. rewrite run_product by auto. apply sum_ext; intros q Hq. f_equal.
  - rewrite <- EP, <- (product_transposed M (real O) (looking_by h)) by auto.
    apply (product_ext M (count (transpose O))); auto. intros t i' j' Ht Hi' Hj'. symmetry. apply transpose_entry; auto.
    unfold transpose in Ht. rewrite count_map in Ht. exact Ht.
  - unfold seen_values, seen_vectors, vr. rewrite map_map, nth_map_seq by (unfold M, N, U in Hq; exact Hq).
    unfold sequence, looking_at. set (x := snd (nth h (seen_at o) ([], 0%nat))).
    destruct (Z.ltb_spec (window_first c + Z.of_nat x) (window_first c)); [lia|]. unfold vr, place.
    replace (Z.to_nat (window_first c + Z.of_nat x - window_first c)) with x by lia. reflexivity.
Qed.
End Observed.

(* Theorem 45, the upper end *)
Theorem component_above a k d p o phi lambda u g : let c := space_proof d in let A := vector_arity a in
  component_space a k c p = true -> checks_images a d = true -> observes a k c p o = true -> exp lambda = INR A -> only_solution a phi ->
  (forall n i q, (q < functions a)%nat -> phi q (IZR i / INR A ^ n) = Refinable.values A (functions a) (vector_first a)
    (length (of_points a) - 1) (point_matrix a) (sequence a c (fixed c)) n i q) ->
  radius_at_least (length (spanning c) - unseen p) A (rest (unseen p) (real (rebased a c p))) g -> exp (- u * lambda) <= g ->
  exp (- INR (difference_order c) * lambda) < g -> exponent_at_most (phi k) u.
Proof.
  cbv zeta. set (c := space_proof d). intros Space HI HO Log Sol Val Least G1 G2 s Hs. apply Rnot_lt_le. intros Hu.
  destruct (component_facts a k c p Space) as [HV [Hk [WF [V [UM [Tri [HA HS]]]]]]].
  set (A := vector_arity a) in *. set (r := functions a) in *. set (F := vector_first a) in *.
  set (L := (length (of_points a) - 1)%nat) in *. set (N := length (spanning c)) in *. set (U := unseen p) in *. set (M := (N - U)%nat) in *.
  destruct (component_differences A r F L (point_matrix a) HA phi (sequence a c (fixed c)) (proj1 Sol) Val lambda (difference_order c) Log u g k Hk
    (ex_intro _ s (conj Hs Hu)) G1 G2) as [q [C [[Q0 Q1] [C0 HC]]]].
  assert (g <= q); [|lra]. apply Least. lra.
  destruct (spanned_by_images a d HV HI) as [Words Spanned]. fold c A r F L N in Words, Spanned.
  set (images := length (image_words d)) in *. set (D := vector_differences (difference_order c) (sequence a c (fixed c))) in *.
  apply (seen_products A r F L (point_matrix a) HA U M (fun i => sequence a c (rebased_vector c p i)) (real (rebased a c p))) with
    (k := k) (d := D) (images := images) (factor := fun l h => sum N (fun j => mr (basis_rows (observing p)) j (U + l)%nat * image_factor a d j h))
    (word := image_word d) (readings := length (seen_at o)) (weight := seen_weight a c p o) (looking := looking_by o)
    (point := looking_at c o) (pivot := IZR (seen_scale o)) (C := C); auto.
  - rewrite UM. apply (rebased_invariant a k c p Space).
  - intros i j Hi. apply (rebased_unseen a k c p Space). exact Hi.
  - intros l Hl j x Hx. rewrite (rebased_sum a c p). fold N.
    transitivity (sum N (fun i => sum images (fun h => mr (basis_rows (observing p)) i (U + l)%nat * (image_factor a d i h *
      after A r F L (point_matrix a) (image_word d h) D j x)))).
    + apply sum_ext; intros i Hi. rewrite sum_scal. f_equal. apply Spanned; auto.
    + rewrite sum_swap. apply sum_ext; intros h Hh. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros; ring.
  - assert (H := HO). unfold observes in H. cbv zeta in H. rewrite !andb_true_iff in H. destruct H as [[H _] _].
    apply negb_true_iff, Z.eqb_neq in H. apply IZR_neq. exact H.
  - intros h Hh. apply (looking_letters a k c p o HO h Hh).
  - intros l i Hl Hi. apply (observed a k c p o Space HO l i Hl Hi).
Qed.

(* ---- the theorems ------------------------------------------------------------------------------------------------------------ *)

Lemma seen_at_most a k c p g : component_space a k c p = true ->
  (forall x, is_radius (size (seen_family a c p)) (count (seen_family a c p)) (real (seen_family a c p)) x -> x <= g) ->
  radius_at_most (length (spanning c) - unseen p) (vector_arity a) (rest (unseen p) (real (rebased a c p))) g.
Proof.
  intros Space H x X1 X2. destruct (seen_facts a k c p Space) as [_ [EC [ES _]]]. apply (seen_growth a k c p Space).
  destruct (radius_exists (size (seen_family a c p)) (count (seen_family a c p)) (real (seen_family a c p))) as [y Hy].
  specialize (H y Hy). destruct Hy as [_ [G _]]. rewrite EC, ES in G. apply G. lra.
Qed.

Lemma seen_at_least a k c p g : component_space a k c p = true ->
  (forall x, is_radius (size (seen_family a c p)) (count (seen_family a c p)) (real (seen_family a c p)) x -> g <= x) ->
  radius_at_least (length (spanning c) - unseen p) (vector_arity a) (rest (unseen p) (real (rebased a c p))) g.
Proof.
  intros Space H x X1 X2. destruct (seen_facts a k c p Space) as [_ [EC [ES _]]]. apply (seen_growth a k c p Space) in X2.
  destruct (radius_exists (size (seen_family a c p)) (count (seen_family a c p)) (real (seen_family a c p))) as [y Hy].
  specialize (H y Hy). destruct Hy as [_ [_ G]]. rewrite EC, ES in G. specialize (G x X1 X2). lra.
Qed.

(* What the checkers accept is true. *)
Theorem check_component_sound a k l c p : check_component a k l c p = true -> component_holds a k l.
Proof.
  intros H. unfold check_component in H. apply andb_prop in H. destruct H as [H HR]. apply andb_prop in H. destruct H as [Space HB].
  destruct (component_facts a k c p Space) as [_ [Hk [_ [_ [_ [_ [HA _]]]]]]]. split; auto.
  destruct (exp_onto (INR (vector_arity a)) (arity_positive _ HA)) as [lambda Log].
  apply (vector_power_sound a l _ _ lambda HA Log) in HB. destruct HB as [Hl HB]. apply check_radius_sound in HR.
  destruct (component_of_radius a k c p Space (real_of l) lambda Log Hl) as [phi [Sol [_ Ex]]].
  { apply (seen_at_most a k); auto. intros x Hx. destruct (HR x Hx) as [_ Up]. specialize (Up _ eq_refl). lra. }
  exists phi. auto.
Qed.

Theorem check_component_between_sound a k l u d p o : check_component_between a k l u d p o = true -> component_between a k l u.
Proof.
  intros H. unfold check_component_between in H. cbv zeta in H. set (c := space_proof d) in *. rewrite !andb_true_iff in H.
  destruct H as [[[[[Space HI] HO] HB] HU] HR].
  destruct (component_facts a k c p Space) as [_ [Hk [_ [_ [_ [_ [HA _]]]]]]]. split; auto.
  destruct (exp_onto (INR (vector_arity a)) (arity_positive _ HA)) as [lambda Log].
  apply (vector_power_sound a l _ _ lambda HA Log) in HB. destruct HB as [Hl HB]. apply check_radius_sound in HR.
  destruct (above_powers_sound lambda _ _ _ _ Log HA HU) as [G1 G2].
  destruct (component_of_radius a k c p Space (real_of l) lambda Log Hl) as [phi [Sol [Val Ex]]].
  { apply (seen_at_most a k); auto. intros x Hx. destruct (HR x Hx) as [_ Up]. specialize (Up _ eq_refl). lra. }
  exists phi. split; auto. split; auto.
  apply (component_above a k d p o phi lambda (real_of u) (real_of (space_least d)) Space HI HO Log Sol Val); auto.
  apply (seen_at_least a k); auto. intros x Hx. destruct (HR x Hx) as [Lo _]. specialize (Lo _ eq_refl). lra.
Qed.

Theorem check_exact_component_sound a k e lower upper d p o x :
  check_exact_component a k e lower upper d p o x = true -> exact_component_holds a k e lower upper.
Proof.
  intros H. unfold check_exact_component in H. cbv zeta in H. set (c := space_proof d) in *. set (h := number_place x) in *.
  rewrite !andb_true_iff in H. destruct H as [[[[[Space HI] HO] HB] HN] HW].
  destruct (component_facts a k c p Space) as [_ [Hk [_ [_ [_ [_ [HA _]]]]]]]. split; auto.
  destruct (number_and_blocks_sound _ e x HN) as [One [Lp [Cp [r [Nr [Rr Near]]]]]]. fold h in Lp, Cp, Near. split; auto.
  destruct (exp_onto (INR (vector_arity a)) (arity_positive _ HA)) as [lambda Log].
  destruct (exponent_of_number a (difference_order c) lambda r h HA Log Cp (proj1 Nr) Near HB) as [s [Hs [Sm Rm]]].
  assert (Is : forall y, is_radius (size (seen_family a c p)) (count (seen_family a c p)) (real (seen_family a c p)) y -> y = r).
  { intros y Hy. eapply radius_unique; eauto. }
  destruct (component_of_radius a k c p Space s lambda Log Sm) as [phi [Sol [Val Ex]]].
  { apply (seen_at_most a k); auto. intros y Hy. rewrite (Is y Hy). lra. }
  assert (Most : exponent_at_most (phi k) s).
  { apply (component_above a k d p o phi lambda s r Space HI HO Log Sol Val); auto; try lra.
    apply (seen_at_least a k); auto. intros y Hy. rewrite (Is y Hy). lra. }
  exists phi, r, s, lambda. split; auto. split; auto. split; auto. split; auto. split.
  - apply least_lub; auto.
  - apply (exponent_between a (difference_order c) lambda r h HA Log Cp); auto. apply Sm.
Qed.
