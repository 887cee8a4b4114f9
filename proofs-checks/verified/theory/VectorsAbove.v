(* The upper end of the exponent of vectors of functions (SPEC.md, section 5.6, Theorem 15): where the images of the differences
   of the values span the space, products on it grow no faster than differences of the functions shrink. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Integers Sections Eigenvalue Check Subdivision Coefficients Grid Differences Stability
  Refinable Exponent Levels Vectors.
Import ListNotations.
Open Scope R_scope.

(* ---- one component of a vector that is not smooth --------------------------------------------------------------------------- *)

(* Of finitely many functions one is not so smooth, if not all of them are. *)
Lemma one_above r u (phi : nat -> R -> R) : ~ (forall c, (c < r)%nat -> exists s, exponents (phi c) s /\ u < s) ->
  exists c, (c < r)%nat /\ exponent_at_most (phi c) u.
Proof.
  intros H.
  assert (G : forall n, (n <= r)%nat -> (exists c, (c < n)%nat /\ exponent_at_most (phi c) u) \/
    ~ ~ (forall c, (c < n)%nat -> exists s, exponents (phi c) s /\ u < s)).
  { induction n; intros Hn. { right. intros N. apply N. intros; lia. }
    destruct (IHn ltac:(lia)) as [[c [Hc E]]|E]. { left. exists c. split; auto. }
    destruct (ClassicalDedekindReals.sig_not_dec (exists s, exponents (phi n) s /\ u < s)) as [D|D].
    - right. intros N. apply D. intros Dn. apply E. intros En. apply N. intros c Hc.
      destruct (Nat.eq_dec c n) as [->|]; auto. apply En. lia.
    - left. exists n. split. lia. intros s Hs. apply Rnot_lt_le. intros L. apply D. exists s. auto. }
  destruct (G r (le_n r)) as [E|E]; auto. exfalso. apply E. exact H.
Qed.

Section Above.
Variables (A r : nat) (F : Z) (L : nat) (a : Z -> nat -> nat -> R).
Hypothesis Arity : (2 <= A)%nat.
Variables (phi : nat -> R -> R) (v : vectors).
Hypothesis Phi : is_solution A r F L a phi.
Hypothesis Values : forall n i c, (c < r)%nat -> phi c (IZR i / INR A ^ n) = values A r F L a v n i c.
Variables (lambda : R) (m : nat).
Hypothesis Log : exp lambda = INR A.

Lemma grid_differences n c : (c < r)%nat -> forall k i,
  differences k (fun i => values A r F L a v n i c) i = backs k (exp (- INR n * lambda)) (phi c) (IZR i / INR A ^ n).
Proof.
  intros Hc. assert (P : 0 < INR A ^ n) by (apply pow_lt, arity_positive; auto).
  assert (E : exp (- INR n * lambda) = / INR A ^ n).
  { rewrite <- Log, exp_power, Ropp_mult_distr_l_reverse, exp_Ropp. reflexivity. }
  induction k; intros i. { cbn [differences backs]. rewrite Values; auto. }
  cbn [differences backs]. unfold back. rewrite !IHk. f_equal. f_equal. rewrite E, minus_IZR. field. lra.
Qed.

(* A component is smooth: its differences shrink. *)
Lemma component_differences u g c : (c < r)%nat -> (exists s, exponents (phi c) s /\ u < s) ->
  exp (- u * lambda) <= g -> exp (- INR m * lambda) < g ->
  exists q C, 0 < q < g /\ 0 <= C /\ forall n i, Rabs (values A r F L a (vector_differences m v) n i c) <= C * q ^ n.
Proof.
  intros Hc H G1 G2. assert (Lp := log_positive A Arity lambda Log).
  destruct Phi as [_ [[S0 V] _]].
  destruct H as [s [[k [alpha [[A0 _] [Es Hk]]]] Hs]].
  destruct (differences_bounded (- S0) S0 m k alpha (phi c) A0 Hk (fun x => V c x Hc)) as [C [e [He HC]]].
  exists (exp (- e * lambda)), (Rmax C 0). split; [split|split].
  - apply exp_pos.
  - destruct He as [->| ->]; auto. eapply Rlt_le_trans; [|apply G1]. apply (power_less A Arity lambda Log). lra.
  - apply Rmax_r.
  - intros n i. rewrite values_differences, grid_differences by auto.
    eapply Rle_trans. apply HC. rewrite exp_power.
    replace (e * (- INR n * lambda)) with (INR n * (- e * lambda)) by ring.
    apply Rmult_le_compat_r. left; apply exp_pos. apply Rmax_l.
Qed.

(* All components are smooth: differences shrink. *)
Lemma differences_shrink u g : (forall c, (c < r)%nat -> exists s, exponents (phi c) s /\ u < s) ->
  exp (- u * lambda) <= g -> exp (- INR m * lambda) < g ->
  exists q C, 0 < q < g /\ 0 <= C /\ forall n i c, (c < r)%nat -> Rabs (values A r F L a (vector_differences m v) n i c) <= C * q ^ n.
Proof.
  intros H G1 G2.
  assert (One : forall c, (c < r)%nat -> exists q C, 0 < q < g /\ 0 <= C /\
    forall n i, Rabs (values A r F L a (vector_differences m v) n i c) <= C * q ^ n).
  { intros c Hc. apply (component_differences u); auto. }
  assert (All : forall n, (n <= r)%nat -> exists q C, 0 < q < g /\ 0 <= C /\
    forall l i c, (c < n)%nat -> Rabs (values A r F L a (vector_differences m v) l i c) <= C * q ^ l).
  { assert (G0 : 0 < g) by (eapply Rlt_trans; [apply exp_pos|apply G2]).
    induction n; intros Hn. { exists (g / 2), 0. split. lra. split. lra. intros; lia. }
    destruct (IHn ltac:(lia)) as [q1 [C1 [[Q1 Q1'] [C10 H1]]]]. destruct (One n ltac:(lia)) as [q2 [C2 [[Q2 Q2'] [C20 H2]]]].
    exists (Rmax q1 q2), (C1 + C2). split; [split|split].
    - eapply Rlt_le_trans. apply Q1. apply Rmax_l.
    - apply Rmax_lub_lt; auto.
    - lra.
    - intros l i c Hc.
      assert (P1 : q1 ^ l <= Rmax q1 q2 ^ l) by (apply pow_incr; split; [lra|apply Rmax_l]).
      assert (P2 : q2 ^ l <= Rmax q1 q2 ^ l) by (apply pow_incr; split; [lra|apply Rmax_r]).
      assert (P0 : 0 <= Rmax q1 q2 ^ l) by (apply pow_le; eapply Rle_trans; [|apply Rmax_l]; lra).
      destruct (Nat.eq_dec c n) as [->|D].
      + eapply Rle_trans. apply H2. nra.
      + eapply Rle_trans. apply H1; lia. nra. }
  destruct (All r (le_n r)) as [q [C [Q [C0 HC]]]]. exists q, C. auto.
Qed.

(* ---- a space that the images span -------------------------------------------------------------------------------------------- *)

Variables (N : nat) (b : nat -> vectors) (T : nat -> mat).
Hypothesis Invariant : forall t k, (t < A)%nat -> (k < N)%nat -> forall j c, (c < r)%nat ->
  transit A r F L a t (b k) j c = sum N (fun l => T t l k * b l j c).
(* Vector number k is a sum of images of the differences by words. *)
Variables (images : nat) (factor : nat -> nat -> R) (word : nat -> list nat).
Hypothesis Words : forall h, (h < images)%nat -> letters A (word h).
Hypothesis Spanned : forall k, (k < N)%nat -> forall j c, (c < r)%nat ->
  b k j c = sum images (fun h => factor k h * after A r F L a (word h) (vector_differences m v) j c).
(* Coordinate number l of a combination is its value at a place, but for a factor. *)
Variables (point : nat -> Z) (component : nat -> nat) (pivot : R).
Hypothesis Pivot : pivot <> 0.
Hypothesis Components : forall l, (l < N)%nat -> (component l < r)%nat.
Hypothesis Coordinates : forall l k, (l < N)%nat -> (k < N)%nat -> b k (point l) (component l) = pivot * identity k l.

Lemma after_sum n (y : nat -> R) (u : nat -> vectors) w : forall j c,
  after A r F L a w (fun j c => sum n (fun h => y h * u h j c)) j c = sum n (fun h => y h * after A r F L a w (u h) j c).
Proof.
  induction w as [|t w IH]; intros j c. reflexivity. cbn [after]. unfold transit.
  rewrite (mix_ext r F L a _ (fun k d => sum n (fun h => y h * after A r F L a w (u h) (Z.of_nat A * j + Z.of_nat t - k)%Z d)))
    by (intros; apply IH).
  apply (mix_sum r F L a n y (fun h k d => after A r F L a w (u h) (Z.of_nat A * j + Z.of_nat t - k)%Z d)).
Qed.

Lemma after_ext w : forall u u', (forall j c, (c < r)%nat -> u j c = u' j c) -> forall j c, (c < r)%nat ->
  after A r F L a w u j c = after A r F L a w u' j c.
Proof. induction w as [|t w IH]; intros u u' H j c Hc; cbn [after]; auto. apply mix_ext. intros. apply IH; auto. Qed.

Lemma products_shrink q C : 0 < q -> 0 <= C ->
  (forall n i c, (c < r)%nat -> Rabs (values A r F L a (vector_differences m v) n i c) <= C * q ^ n) -> growth N A T q.
Proof.
  intros Q C0 H. set (size := sum N (fun k => sum images (fun h => Rabs (factor k h) * q ^ length (word h)))).
  exists (/ Rabs pivot * (size * C)). intros w Hw p k Hp Hk.
  assert (P0 : 0 < Rabs pivot) by (apply Rabs_pos_lt; auto).
  assert (E : after A r F L a w (b k) (point p) (component p) = pivot * product N T w p k).
  { rewrite (after_span A r F L a N b T Invariant w Hw (b k) (unit k)).
    - unfold span. rewrite (sum_ext N _ (fun l => identity l p * (pivot * run N T w (unit k) l))).
      + rewrite sum_identity by auto. rewrite run_unit by auto. reflexivity.
      + intros l Hl. rewrite Coordinates by auto. ring.
    - intros j c Hc. unfold span, unit. rewrite sum_identity by auto. reflexivity.
    - apply Components; auto. }
  assert (B : Rabs (after A r F L a w (b k) (point p) (component p)) <= size * C * q ^ length w).
  { rewrite (after_ext w (b k) (fun j c => sum images (fun h => factor k h * after A r F L a (word h) (vector_differences m v) j c)))
      by (auto; intros; apply Spanned; auto).
    rewrite after_sum. eapply Rle_trans. apply sum_abs.
    apply Rle_trans with (sum images (fun h => Rabs (factor k h) * q ^ length (word h)) * (C * q ^ length w)).
    - rewrite Rmult_comm, <- sum_scal. apply sum_le. intros h Hh. rewrite Rabs_mult, <- after_app.
      rewrite <- (values_after A r F L a Arity). eapply Rle_trans. apply Rmult_le_compat_l. apply Rabs_pos. apply H.
      apply Components; auto.
      rewrite app_length, pow_add. right. ring.
    - rewrite Rmult_assoc. apply Rmult_le_compat_r. apply Rmult_le_pos; auto. apply pow_le; lra.
      apply (sum_term N (fun k => sum images (fun h => Rabs (factor k h) * q ^ length (word h)))); auto.
      intros i _. apply sum_nonneg. intros h _. apply Rmult_le_pos. apply Rabs_pos. apply pow_le; lra. }
  rewrite E, Rabs_mult in B. apply (Rmult_le_reg_l (Rabs pivot)); auto. eapply Rle_trans. apply B. right. field. lra.
Qed.

(* Theorem 15 *)
Theorem solution_above u g : radius_at_least N A T g -> exp (- u * lambda) <= g -> exp (- INR m * lambda) < g ->
  exists c, (c < r)%nat /\ exponent_at_most (phi c) u.
Proof.
  intros HR G1 G2. apply one_above. intros H. destruct (differences_shrink u g H G1 G2) as [q [C [Q [C0 HC]]]].
  assert (g <= q); [|lra]. apply HR. lra. apply (products_shrink q C); auto. lra.
Qed.
End Above.

(* ---- the checker ------------------------------------------------------------------------------------------------------------- *)

(* As claimed of vectors of functions, and the exponent of one of them is at most u: that of the worst one. *)
Definition vectors_between (a : vector_mask) (l u : Q) : Prop := exists phi,
  solution_at_least (vector_arity a) (functions a) (vector_first a) (length (of_points a) - 1) (point_matrix a) phi (real_of l) /\
  exists c, (c < functions a)%nat /\ exponent_at_most (phi c) (real_of u).

(* The images of the differences of the values by these words span the space: rows of `combinations`, over `combination_scale`,
   give its vectors. `space_least` is a lower bound of the radius. *)
Record above_certificate := AboveCertificate {
  space_proof : vector_certificate; image_words : list (list nat); combinations : list (list Z); combination_scale : Z; space_least : Q }.

Definition image_by (a : vector_mask) (c : vector_certificate) (w : list nat) : list Z :=
  fold_right (move (vector_arity a) (functions a) (window_first c) (window c) (vector_first a) (of_points a)) (start_differences a c) w.

Definition checks_images (a : vector_mask) (d : above_certificate) : bool :=
  let c := space_proof d in let images := map (image_by a c) (image_words d) in
  (0 <? combination_scale d)%Z && forallb (forallb (fun t => t <? vector_arity a)%nat) (image_words d) &&
  forallb (fun k => zero_list (addmul (- combination_scale d) (nth k (spanning c) []) (combine_lists (nth k (combinations d) []) images)))
    (seq 0 (length (spanning c))).

Definition checks_places (a : vector_mask) (c : vector_certificate) : bool :=
  forallb (fun l => forallb (fun k => (nth (nth l (places c) O) (nth k (spanning c) []) 0 =? if_equal k l (place_value c))%Z)
    (seq 0 (length (spanning c)))) (seq 0 (length (spanning c))).

(* arity^(-u) is at most g, and arity^(-order) below it. *)
Definition above_powers (arity : nat) (u : Q) (order : nat) (g : Q) : bool :=
  (0 <=? Qnum u)%Z && (unity * Zpos (Qden g) <=? Qnum g * power_below (Z.of_nat arity) order (Qnum u) (Zpos (Qden u)))%Z &&
  (Zpos (Qden g) <? Qnum g * Z.of_nat arity ^ Z.of_nat order)%Z.

Definition check_vectors_between (a : vector_mask) (l u : Q) (d : above_certificate) : bool :=
  let c := space_proof d in
  vector_space a c && checks_images a d && checks_places a c && vector_power a l (difference_order c) (space_bound c) &&
  above_powers (vector_arity a) u (difference_order c) (space_least d) &&
  check_radius (Claim (vector_family a c) (Some (space_least d)) (Some (space_bound c))) (space_radius c).

Lemma above_powers_sound lambda A u m g : exp lambda = INR A -> (2 <= A)%nat -> above_powers A u m g = true ->
  exp (- real_of u * lambda) <= real_of g /\ exp (- INR m * lambda) < real_of g.
Proof.
  intros Hlog HA H. unfold above_powers in H. rewrite !andb_true_iff in H. destruct H as [[H1 H2] H3].
  apply Z.leb_le in H1, H2. apply Z.ltb_lt in H3.
  assert (Dg : 0 < IZR (Zpos (Qden g))) by (apply IZR_lt; lia).
  assert (Eg : real_of g * IZR (Zpos (Qden g)) = IZR (Qnum g)) by (unfold real_of; field; lra).
  assert (PA := arity_positive A HA). assert (Up := unity_positive).
  split.
  - assert (Hl := Hlog). rewrite INR_IZR_INZ in Hl.
    assert (P := power_below_sound (Z.of_nat A) lambda ltac:(lia) Hl m (Qnum u) (Zpos (Qden u)) H1 ltac:(lia)). fold (real_of u) in P.
    set (x := power_below _ _ _ _) in *. apply IZR_le in H2. rewrite !mult_IZR in H2.
    assert (E : 0 < exp (real_of u * lambda)) by apply exp_pos.
    replace (- real_of u * lambda) with (- (real_of u * lambda)) by ring. rewrite exp_Ropp.
    assert (G0 : 0 <= IZR (Qnum g)).
    { apply IZR_le. destruct (Z_lt_ge_dec (Qnum g) 0) as [N|N]; [|lia]. exfalso.
      assert (0 < Z.of_nat A ^ Z.of_nat m)%Z by (apply Z.pow_pos_nonneg; lia). nia. }
    apply (Rmult_le_reg_r (IZR unity * exp (real_of u * lambda) * IZR (Zpos (Qden g)))).
    { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; auto. }
    replace (/ exp (real_of u * lambda) * (IZR unity * exp (real_of u * lambda) * IZR (Zpos (Qden g))))
      with (IZR unity * IZR (Zpos (Qden g))) by (field; lra).
    replace (real_of g * (IZR unity * exp (real_of u * lambda) * IZR (Zpos (Qden g))))
      with (IZR (Qnum g) * (IZR unity * exp (real_of u * lambda))) by (rewrite <- Eg; ring).
    eapply Rle_trans. apply H2. apply Rmult_le_compat_l; auto.
  - apply IZR_lt in H3. rewrite mult_IZR, (arity_power A HA) in H3. replace (- INR m * lambda) with (- (INR m * lambda)) by ring.
    rewrite exp_Ropp, <- exp_power, Hlog. assert (PM : 0 < INR A ^ m) by (apply pow_lt; auto).
    apply (Rmult_lt_reg_r (INR A ^ m * IZR (Zpos (Qden g)))). apply Rmult_lt_0_compat; auto.
    replace (/ INR A ^ m * (INR A ^ m * IZR (Zpos (Qden g)))) with (IZR (Zpos (Qden g))) by (field; lra).
    replace (real_of g * (INR A ^ m * IZR (Zpos (Qden g)))) with (IZR (Qnum g) * INR A ^ m) by (rewrite <- Eg; ring). auto.
Qed.

(* Images as lists *)
Section Images.
Variables (a : vector_mask) (c : vector_certificate).
Let A := vector_arity a.
Let r := functions a.
Let F := vector_first a.
Let L := (length (of_points a) - 1)%nat.
Hypothesis Arity : (2 <= A)%nat.
Hypothesis Common : (0 < vector_common a)%Z.
Hypothesis Points : (1 <= length (of_points a))%nat.
Hypothesis Positive : (1 <= r)%nat.
Hypothesis Square : forallb (square r) (of_points a) = true.
Hypothesis Low : ((Z.of_nat A - 1) * window_first c <= F)%Z.
Hypothesis High : (F + Z.of_nat L <= (Z.of_nat A - 1) * (window_first c + Z.of_nat (window c) - 1))%Z.
Hypothesis Start : checks_start a c = true.
Let d : vectors := vector_differences (difference_order c) (sequence a c (fixed c)).

Lemma image_real w : letters A w -> (length (image_by a c w) <= window c * r)%nat /\ forall j k, (k < r)%nat ->
  sequence a c (image_by a c w) j k = IZR (vector_common a) ^ length w * after A r F L (point_matrix a) w d j k.
Proof.
  induction w as [|t w IH]; intros Hw.
  - destruct (start_real a c Arity Points Positive Start) as [U1 [U2 _]]. split. exact U1.
    intros j k Hk. cbn [length pow after]. rewrite Rmult_1_l. apply U2. auto.
  - inversion Hw as [|? ? Ht Hw']; subst. destruct (IH Hw') as [I1 I2]. cbn [image_by fold_right]. fold (image_by a c w). split.
    + rewrite (moved_length a c t). apply le_n.
    + intros j k Hk. rewrite (move_real a c Arity Common Points Positive Square Low High) by auto. cbn [length after].
      rewrite <- tech_pow_Rmult, Rmult_assoc. f_equal.
      unfold transit. rewrite <- mix_scal. apply mix_ext. intros i q Hq. apply I2; auto.
Qed.

Lemma place_value_at u p : (1 <= r)%nat -> sequence a c u (window_first c + Z.of_nat (p / r)) (p mod r) = IZR (nth p u 0%Z).
Proof.
  intros H. unfold sequence. destruct (Z.ltb_spec (window_first c + Z.of_nat (p / r)) (window_first c)); [lia|].
  unfold vr. do 2 f_equal. unfold place. fold r.
  replace (Z.to_nat (window_first c + Z.of_nat (p / r) - window_first c)) with (p / r)%nat by lia.
  assert (D := Nat.div_mod p r ltac:(lia)). lia.
Qed.
End Images.

(* Vectors of the space as sums of images of the differences *)
Definition image_word (d : above_certificate) (h : nat) : list nat := nth h (image_words d) [].
Definition image_factor (a : vector_mask) (d : above_certificate) (k h : nat) : R :=
  IZR (nth h (nth k (combinations d) []) 0%Z) * IZR (vector_common a) ^ length (image_word d h) / IZR (combination_scale d).

Lemma spanned_by_images a d : let c := space_proof d in let images := length (image_words d) in
  vector_space a c = true -> checks_images a d = true -> (forall h, (h < images)%nat -> letters (vector_arity a) (image_word d h)) /\
  forall k, (k < length (spanning c))%nat -> forall j q, (q < functions a)%nat -> sequence a c (nth k (spanning c) []) j q =
    sum images (fun h => image_factor a d k h * after (vector_arity a) (functions a) (vector_first a) (length (of_points a) - 1)
      (point_matrix a) (image_word d h) (vector_differences (difference_order c) (sequence a c (fixed c))) j q).
Proof.
  cbv zeta. set (c := space_proof d). set (images := length (image_words d)). intros H HI.
  unfold vector_space in H. rewrite !andb_true_iff in H. destruct H as [[[[[[[[[[HA HO] Hpt] Hf] HQ] Hlo] Hhi] HF] HS] HT] HK].
  apply Nat.leb_le in HA, Hpt, Hf. apply Z.ltb_lt in HO. apply Z.leb_le in Hlo, Hhi.
  unfold checks_images in HI. cbv zeta in HI. fold c in HI. rewrite !andb_true_iff in HI. destruct HI as [[HI1 HI2] HI3].
  apply Z.ltb_lt in HI1. rewrite forallb_forall in HI2, HI3.
  assert (S0 : 0 < IZR (combination_scale d)) by (apply IZR_lt; auto).
  assert (Words : forall h, (h < images)%nat -> letters (vector_arity a) (image_word d h)).
  { intros h Hh. assert (W := HI2 _ (nth_In _ [] Hh)). rewrite forallb_forall in W. apply Forall_forall.
    intros t Ht. apply Nat.ltb_lt, W. exact Ht. }
  split; auto. intros k Hk j q Hq. assert (Z0 := HI3 k ltac:(apply in_seq; lia)). apply (sequence_zero a c) with (i := j) (k := q) in Z0.
  rewrite sequence_addmul, sequence_combine, map_length, opp_IZR in Z0. fold images in Z0.
  rewrite (sum_ext images _ (fun h => IZR (combination_scale d) * (image_factor a d k h * after (vector_arity a) (functions a) (vector_first a)
    (length (of_points a) - 1) (point_matrix a) (image_word d h) (vector_differences (difference_order c) (sequence a c (fixed c))) j q))) in Z0.
  - rewrite sum_scal in Z0. apply (Rmult_eq_reg_l (IZR (combination_scale d))); lra.
  - intros h Hh.
    assert (E : nth h (map (image_by a c) (image_words d)) [] = image_by a c (image_word d h)).
    { unfold image_word. rewrite <- (map_nth (image_by a c)). apply nth_indep. rewrite map_length. exact Hh. }
    rewrite E. destruct (image_real a c HA HO Hpt Hf HQ Hlo ltac:(lia) HT (image_word d h) (Words h Hh)) as [_ I]. rewrite I by auto.
    unfold image_factor. field. lra.
Qed.

(* A space whose radius is at most arity^(-s) and at least g, that the images span *)
Theorem vectors_of_bounds a d lambda s u g : let c := space_proof d in
  let T := real (vector_family a c) in let N := length (spanning c) in let m := INR (difference_order c) in
  vector_space a c && checks_images a d && checks_places a c = true -> exp lambda = INR (vector_arity a) -> 0 < s <= m ->
  radius_at_most N (vector_arity a) T (exp (- s * lambda)) -> radius_at_least N (vector_arity a) T g ->
  exp (- u * lambda) <= g -> exp (- m * lambda) < g -> exists phi,
  solution_at_least (vector_arity a) (functions a) (vector_first a) (length (of_points a) - 1) (point_matrix a) phi s /\
  exists k, (k < functions a)%nat /\ exponent_at_most (phi k) u.
Proof.
  cbv zeta. set (c := space_proof d). intros H Log Hs Most Least G1 G2. rewrite !andb_true_iff in H. destruct H as [[H HI] HP].
  assert (H' := H). unfold vector_space in H. rewrite !andb_true_iff in H. destruct H as [[[[[[[[[[HA HO] Hpt] Hf] HQ] Hlo] Hhi] HF] HS] HT] HK].
  apply Nat.leb_le in HA, Hpt, Hf. apply Z.ltb_lt in HO. apply Z.leb_le in Hlo, Hhi.
  assert (Sh := HT). unfold checks_start in Sh. rewrite !andb_true_iff in Sh. destruct Sh as [[Sh _] _].
  set (A := vector_arity a) in *. set (r := functions a) in *. set (F := vector_first a) in *.
  set (L := (length (of_points a) - 1)%nat) in *.
  set (m := difference_order c) in *. set (N := length (spanning c)) in *.
  destruct (values_of_radius a c HA HO Hpt Hf HQ Hlo ltac:(lia) Sh HS HF HK s (exp (- s * lambda)) HT Most) as [phi [Sol V]].
  { exists lambda. split; auto. split; auto. apply Rle_refl. }
  exists phi. split. exact Sol. fold A r F L in Sol, V.
  destruct (spanned_by_images a d H' HI) as [Words Spanned]. fold c A r F L N m in Words, Spanned.
  unfold checks_places in HP. fold N in HP. rewrite forallb_forall in HP.
  set (place := fun l => nth l (places c) O).
  apply (solution_above A r F L (point_matrix a) HA phi (sequence a c (fixed c)) (proj1 Sol) V lambda m Log N
    (fun k => sequence a c (nth k (spanning c) [])) (real (vector_family a c))
    (space_invariant a c HA HO Hpt Hf HQ Hlo ltac:(lia) Sh HS) (length (image_words d)) (image_factor a d) (image_word d))
    with (point := fun l => (window_first c + Z.of_nat (place l / r))%Z) (component := fun l => (place l mod r)%nat)
    (pivot := IZR (place_value c)) (g := g); auto.
  - assert (0 < place_value c)%Z by (apply (space_pivot a c HS)). apply IZR_neq. lia.
  - intros i Hi. apply Nat.mod_upper_bound. lia.
  - intros i k Hi Hk. rewrite (place_value_at a c) by auto. specialize (HP i ltac:(apply in_seq; lia)). rewrite forallb_forall in HP.
    specialize (HP k ltac:(apply in_seq; lia)). apply Z.eqb_eq in HP. fold (place i) in HP. rewrite HP. unfold if_equal, identity.
    destruct (Nat.eqb k i); lra.
Qed.

(* What the checker accepts is true. *)
Theorem check_vectors_between_sound a l u d : check_vectors_between a l u d = true -> vectors_between a l u.
Proof.
  intros H. unfold check_vectors_between in H. cbv zeta in H. set (c := space_proof d) in *.
  apply andb_prop in H. destruct H as [H HR]. apply andb_prop in H. destruct H as [H HU].
  apply andb_prop in H. destruct H as [H HB].
  assert (H' := H). unfold vector_space in H'. rewrite !andb_true_iff in H'. destruct H' as [[H1 _] _].
  destruct H1 as [[[[[[[[[[HA _] _] _] _] _] _] _] HS] _] _]. apply Nat.leb_le in HA.
  destruct (exp_onto (INR (vector_arity a)) (arity_positive _ HA)) as [lambda Log].
  apply (vector_power_sound a l _ _ lambda HA Log) in HB. destruct HB as [Hl HB].
  destruct (above_powers_sound lambda _ _ _ _ Log HA HU) as [G1 G2].
  apply (check_radius_sound) in HR. set (T := vector_family a c) in *.
  assert (Count : count T = vector_arity a) by (apply (space_count a c HS)).
  destruct (radius_exists (length (spanning c)) (vector_arity a) (real T)) as [x Hx]. rewrite <- Count in Hx.
  destruct (HR x Hx) as [Lo Up]. specialize (Lo _ eq_refl). specialize (Up _ eq_refl). destruct Hx as [_ [Gr Le]]. rewrite Count in Gr, Le.
  apply (vectors_of_bounds a d lambda (real_of l) (real_of u) (real_of (space_least d))); auto.
  - intros g G3 _. apply Gr. fold c T in HB. lra.
  - intros g G3 G. specialize (Le g G3 G). lra.
Qed.
