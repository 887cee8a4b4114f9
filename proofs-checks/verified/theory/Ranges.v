(* A mask with a parameter: what is proved of all its values in an interval, and of all sequences of them, one for each level
   (SPEC.md, sections 6.1 and 6.5, Theorems 19 and 44). Between its ends each mask is a convex combination of finitely many,
   the control masks, and products of matrices of such combinations are convex combinations of products. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Integers Sections Check Subdivision Coefficients Exponent Along Levels.
Import ListNotations.
Open Scope Z_scope.

(* ---- claims ------------------------------------------------------------------------------------------------------------ *)

(* c0 + c1 x + c2 x^2 + ... *)
Definition polynomial_at (l : list Z) (x : R) : R := fold_right (fun c rest => IZR c + x * rest)%R 0%R l.

(* The coefficients first, first + 1, ... are polynomials in the parameter over one polynomial; others are 0. *)
Record ranged := Ranged { ranged_arity : nat; ranged_first : Z; numerators : list (list Z); ranged_divisor : list Z }.
Definition mask_of_value (a : ranged) (x : R) : Z -> R := fun i =>
  if i <? ranged_first a then 0%R
  else (polynomial_at (nth (Z.to_nat (i - ranged_first a)) (numerators a) []) x / polynomial_at (ranged_divisor a) x)%R.

(* Level k + 1 is made from level k by the mask of the value w k. *)
Definition limit_of_values (a : ranged) (w : nat -> R) (phi : R -> R) : Prop :=
  is_levels_limit (ranged_arity a) (ranged_first a) (length (numerators a)) (fun k => mask_of_value a (w k)) phi.
(* One value for all levels *)
Definition limit_of_value (a : ranged) (x : R) (phi : R -> R) : Prop :=
  is_limit (ranged_arity a) (ranged_first a) (length (numerators a)) (mask_of_value a x) phi.

Definition between (low high : Q) (x : R) : Prop := (real_of low <= x <= real_of high)%R.

(* There is a mask for each value; for each sequence of values the scheme converges, and all exponents are above l: from one
   number on that is larger than l. *)
Definition range_levels_hold (a : ranged) (low high l : Q) : Prop :=
  (forall x, between low high x -> polynomial_at (ranged_divisor a) x <> 0%R) /\
  exists s, (real_of l < s)%R /\
  forall w, (forall k, between low high (w k)) -> exists phi, limit_of_values a w phi /\ exponent_at_least phi s.
(* The same for each value *)
Definition range_holds (a : ranged) (low high l : Q) : Prop :=
  (forall x, between low high x -> polynomial_at (ranged_divisor a) x <> 0%R) /\
  exists s, (real_of l < s)%R /\
  forall x, between low high x -> exists phi, limit_of_value a x phi /\ exponent_at_least phi s.

(* ---- the checker ------------------------------------------------------------------------------------------------------- *)

(* Forms in u and v: the list f0, ..., fn is the sum of fj u^j v^(n - j). The product with c v + d u: *)
Definition times_linear (c d : Z) (f : list Z) : list Z := addmul c (f ++ [0]) (0 :: map (Z.mul d) f).
Fixpoint powers_of (e : Z) (n : nat) : list Z := match n with O => [1] | S k => times_linear e e (powers_of e k) end.

(* Of a polynomial of degree n at the value (a v + b u) / (e (u + v)), times (e (u + v))^n *)
Fixpoint polynomial_form (a b e : Z) (l : list Z) : list Z :=
  match l with [] => [] | c :: rest => addmul c (powers_of e (length rest)) (times_linear a b (polynomial_form a b e rest)) end.

Definition form_between (low high : Q) : list Z -> list Z :=
  polynomial_form (Qnum low * Zpos (Qden high)) (Qnum high * Zpos (Qden low)) (Zpos (Qden low) * Zpos (Qden high)).

(* Mask number j has the coefficients number j of the forms, over that of the divisor. *)
Definition control_masks (a : ranged) (low high : Q) (common : Z) : masks :=
  let q := form_between low high (ranged_divisor a) in let forms := map (form_between low high) (numerators a) in
  Masks (ranged_arity a) common
    (map (fun j => let factor := common / nth j q 0 in (ranged_first a, map (fun f => factor * nth j f 0) forms))
      (seq 0 (length (ranged_divisor a)))).

Definition has_control_masks (a : ranged) (low high : Q) (common : Z) : bool :=
  let q := form_between low high (ranged_divisor a) in
  (0 <? common) && (Qnum low * Zpos (Qden high) <? Qnum high * Zpos (Qden low)) &&
  (1 <=? length (ranged_divisor a))%nat && (1 <=? length (numerators a))%nat &&
  forallb (fun l => length l =? length (ranged_divisor a))%nat (numerators a) &&
  (forallb (Z.ltb 0) q || forallb (fun c => c <? 0) q) && forallb (fun c => common / c * c =? common) q.

(* The matrices of digit 0 of all masks, then those of digit 1, and so on *)
Definition range_family (m : masks) (order : nat) : family :=
  let all := levels_family m Any order in let n := length (each m) in
  Family (size all) (masks_common m)
    (flat_map (fun t => map (fun j => letter all (j * masks_arity m + t)) (seq 0 n)) (seq 0 (masks_arity m))).

Definition below_power_strictly (arity : nat) (l : Q) (order : nat) (u : Q) : bool :=
  let bottom := Zpos (Qden l) in let top := Z.of_nat order * bottom - Qnum l in
  (0 <=? Qnum l) && (0 <? top) && (Qnum u * unity <? power_below (Z.of_nat arity) order top bottom * Zpos (Qden u)).

Definition check_interval (a : ranged) (low high l : Q) (common : Z) (cert : exponent_certificate) : bool :=
  let m := control_masks a low high common in
  (2 <=? ranged_arity a)%nat && has_control_masks a low high common &&
  forallb (fun p => reducible (scheme_of m p) (order cert)) (each m) &&
  below_power_strictly (ranged_arity a) l (order cert) (bound cert) &&
  check_radius (Claim (range_family m (order cert)) None (Some (bound cert))) (of_radius cert).

(* Sequences need one interval for all values; for each value some that follow on each other do. *)
Definition check_range_levels := check_interval.
Fixpoint check_range (a : ranged) (low high l : Q) (pieces : list (Q * (Z * exponent_certificate))) : bool :=
  match pieces with
  | [] => false
  | [(high', (common, cert))] => check_interval a low high l common cert
  | (next, (common, cert)) :: pieces' => check_interval a low next l common cert && check_range a next high l pieces'
  end.

(* ---- forms --------------------------------------------------------------------------------------------------------------- *)

Section Forms.
Variables u v : R.

Fixpoint form_at (f : list Z) : R := match f with [] => 0%R | c :: rest => (IZR c * v ^ length rest + u * form_at rest)%R end.

Lemma form_at_sum f : form_at f = sum (length f) (fun j => IZR (nth j f 0%Z) * (u ^ j * v ^ (length f - 1 - j)))%R.
Proof.
  induction f as [|c f IH]. reflexivity. cbn [form_at length]. change (S (length f)) with (1 + length f)%nat. rewrite sum_add.
  rewrite IH, <- sum_scal. cbn [sum nth pow]. replace (1 + length f - 1 - 0)%nat with (length f) by lia. rewrite Rplus_0_l. f_equal. ring.
  apply sum_ext; intros j Hj. cbn [nth Nat.add]. replace (S (length f) - 1 - S j)%nat with (length f - 1 - j)%nat by lia. cbn [pow]. ring.
Qed.

Lemma addmul_length c : forall f g, length f = length g -> length (addmul c f g) = length f.
Proof. induction f; intros [|y g] H; simpl in *; auto; try discriminate; try (rewrite map_length; auto). Qed.

Lemma form_at_addmul c : forall f g, length f = length g -> form_at (addmul c f g) = (IZR c * form_at f + form_at g)%R.
Proof.
  induction f as [|x f IH]; intros [|y g] H; simpl in H; try discriminate. simpl. lra.
  assert (L := addmul_length c f g ltac:(lia)). cbn [addmul form_at]. rewrite L, IH by lia.
  replace (length g) with (length f) by lia. rewrite plus_IZR, mult_IZR. ring.
Qed.

Lemma form_at_map c f : form_at (map (Z.mul c) f) = (IZR c * form_at f)%R.
Proof. induction f; simpl. lra. rewrite IHf, map_length, mult_IZR. ring. Qed.

Lemma form_at_zero_last f : form_at (f ++ [0]) = (v * form_at f)%R.
Proof.
  induction f; simpl. lra. rewrite IHf, app_length. simpl length.
  replace (length f + 1)%nat with (S (length f)) by lia. simpl pow. ring.
Qed.

Lemma times_linear_length c d f : length (times_linear c d f) = S (length f).
Proof. unfold times_linear. rewrite addmul_length; rewrite app_length; simpl; rewrite ?map_length; lia. Qed.

Lemma form_at_times_linear c d f : form_at (times_linear c d f) = ((IZR c * v + IZR d * u) * form_at f)%R.
Proof.
  unfold times_linear. rewrite form_at_addmul by (rewrite app_length; simpl; rewrite map_length; lia).
  rewrite form_at_zero_last. cbn [form_at]. rewrite form_at_map. ring.
Qed.

Lemma powers_of_length e n : length (powers_of e n) = S n.
Proof. induction n; auto. cbn [powers_of]. rewrite times_linear_length, IHn. auto. Qed.

Hypothesis Sum : (u + v = 1)%R.

Lemma form_at_powers_of e n : form_at (powers_of e n) = (IZR e ^ n)%R.
Proof.
  induction n. simpl. lra. cbn [powers_of]. rewrite form_at_times_linear, IHn.
  replace (IZR e * v + IZR e * u)%R with (IZR e * (u + v))%R by ring. rewrite Sum. simpl. ring.
Qed.

Lemma form_length a b e l : length (polynomial_form a b e l) = length l.
Proof.
  induction l; auto. cbn [polynomial_form]. rewrite addmul_length; rewrite powers_of_length; auto. rewrite times_linear_length. auto.
Qed.

(* A polynomial as a form *)
Lemma form_at_form a b e x l : (IZR e * x = IZR a * v + IZR b * u)%R ->
  (IZR e * form_at (polynomial_form a b e l) = IZR e ^ length l * polynomial_at l x)%R.
Proof.
  intros E. induction l as [|c l IH]. simpl. lra. cbn [polynomial_form].
  rewrite form_at_addmul by (rewrite times_linear_length, form_length, powers_of_length; auto).
  rewrite form_at_times_linear, form_at_powers_of, <- E. cbn [polynomial_at fold_right length pow]. fold (polynomial_at l x).
  rewrite Rmult_plus_distr_l.
  replace (IZR e * (IZR e * x * form_at (polynomial_form a b e l)))%R
    with (IZR e * x * (IZR e * form_at (polynomial_form a b e l)))%R by ring.
  rewrite IH. ring.
Qed.
End Forms.

(* ---- products of convex combinations are those of products --------------------------------------------------------------- *)

Lemma convex_bound n (weights f : nat -> R) B : (forall j, (j < n)%nat -> (0 <= weights j)%R) -> sum n weights = 1%R ->
  (forall j, (j < n)%nat -> (Rabs (f j) <= B)%R) -> (Rabs (sum n (fun j => weights j * f j)) <= B)%R.
Proof.
  intros W0 W1 H. eapply Rle_trans. apply sum_abs. replace B with (sum n (fun j => B * weights j)%R) by (rewrite sum_scal, W1; lra).
  apply sum_le; intros j Hj. rewrite Rabs_mult, (Rabs_pos_eq (weights j)) by auto. rewrite Rmult_comm.
  apply Rmult_le_compat_r; auto.
Qed.

Section Hull.
Variables (A W n count : nat) (symbol : nat -> Z -> R) (T : nat -> mat) (number : nat -> nat -> nat).
Hypothesis Letters : forall j t, (j < n)%nat -> (t < A)%nat -> (number j t < count)%nat.
Hypothesis Matrices : forall j t p q, (j < n)%nat -> (t < A)%nat -> (p < W)%nat -> (q < W)%nat ->
  T (number j t) p q = scheme_matrix A (symbol j) t p q.

Definition weights_of (theta : nat -> R) : Prop := (forall j, (j < n)%nat -> (0 <= theta j)%R) /\ sum n theta = 1%R.
Definition combined (theta : nat -> R) : Z -> R := fun i => sum n (fun j => theta j * symbol j i)%R.

Lemma level_product_hull q B : (q < W)%nat -> forall w, letters A w -> forall theta, (forall k, weights_of (theta k)) -> forall x : vec,
  (forall v, letters count v -> length v = length w -> (Rabs (sum W (fun p => x p * product W T v p q)) <= B)%R) ->
  (Rabs (sum W (fun p => x p * level_product A W (fun k => combined (theta k)) w p q)) <= B)%R.
Proof.
  intros Hq. induction w as [|t w IH]; intros Hw theta Ht x H.
  - cbn [level_product]. apply (H []); auto. constructor.
  - inversion Hw as [|? ? Hd Hw']; subst. destruct (Ht O) as [T0 T1].
    set (rest := level_product A W (later (fun k => combined (theta k))) w).
    set (y := fun j k => sum W (fun p => x p * T (number j t) p k)%R).
    rewrite (sum_ext W _ (fun p => sum W (fun k => sum n (fun j => theta O j * (x p * T (number j t) p k * rest k q)))%R)).
    + rewrite sum_swap.
      rewrite (sum_ext W _ (fun k => sum n (fun j => theta O j * (y j k * rest k q)))%R).
      * rewrite sum_swap. rewrite (sum_ext n _ (fun j => theta O j * sum W (fun k => y j k * rest k q))%R) by (intros; apply sum_scal).
        apply convex_bound; auto. intros j Hj. apply (IH Hw' (fun k => theta (S k)) (fun k => Ht (S k)) (y j)).
        intros v Hv Hl. specialize (H (number j t :: v)). cbn [product length] in H.
        replace (sum W (fun p => y j p * product W T v p q)%R)
          with (sum W (fun p => x p * times W (T (number j t)) (product W T v) p q)%R).
        -- apply H. constructor; auto. auto.
        -- rewrite (sum_ext W _ (fun p => sum W (fun k => x p * T (number j t) p k * product W T v k q))%R).
           ++ rewrite sum_swap. apply sum_ext; intros k Hk. unfold y. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros; ring.
           ++ intros p Hp. unfold times. rewrite <- sum_scal. apply sum_ext; intros; ring.
      * intros k Hk. rewrite sum_swap. apply sum_ext; intros j Hj. rewrite sum_scal. f_equal. unfold y.
        rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros; ring.
    + intros p Hp. cbn [level_product]. unfold times. rewrite <- sum_scal. apply sum_ext; intros k Hk. fold rest.
      change (scheme_matrix A (combined (theta O)) t p k) with (sum n (fun j => theta O j * scheme_matrix A (symbol j) t p k)%R).
      rewrite (Rmult_comm (sum n _)), <- Rmult_assoc, <- sum_scal. apply sum_ext; intros j Hj. rewrite Matrices by auto. ring.
Qed.

(* So bounds of products are bounds of products of combinations. *)
Lemma hull_growth theta g : (forall k, weights_of (theta k)) -> growth W count T g -> exists C, forall w, letters A w ->
  forall p q, (p < W)%nat -> (q < W)%nat ->
  (Rabs (level_product A W (fun k => combined (theta k)) w p q) <= C * g ^ length w)%R.
Proof.
  intros Ht [C HC]. exists C. intros w Hw p q Hp Hq.
  assert (E : forall f : nat -> R, sum W (fun i => identity i p * f i)%R = f p) by (intros; apply sum_identity; auto).
  rewrite <- (E (fun p => level_product A W (fun k => combined (theta k)) w p q)).
  apply level_product_hull; auto. intros v Hv Hl. rewrite (E (fun p => product W T v p q)), <- Hl. apply HC; auto.
Qed.
End Hull.

(* ---- convex combinations of masks of a list ------------------------------------------------------------------------------- *)

Lemma smoothed_sum A k n (c : nat -> R) (f : nat -> Z -> R) : forall i,
  smoothed A k (fun i => sum n (fun j => c j * f j i)%R) i = sum n (fun j => c j * smoothed A k (f j) i)%R.
Proof.
  induction k; intros i; auto. cbn [smoothed]. unfold smooth.
  rewrite (sum_ext A _ (fun s => sum n (fun j => c j * smoothed A k (f j) (i - Z.of_nat s)))%R) by auto.
  rewrite sum_swap, <- sum_scal. apply sum_ext; intros j Hj. rewrite sum_scal. ring.
Qed.

Section Combinations.
Variables (m : masks) (M : nat).
Let A := masks_arity m.
Let n := length (each m).
Let W := level_size m M.
Hypothesis Arity : (2 <= A)%nat.
Hypothesis Some_mask : (1 <= n)%nat.
Hypothesis Reducible : forall p, In p (each m) -> reducible (scheme_of m p) M = true.
Hypothesis One_first : forall j, (j < n)%nat -> first_number m j = lowest m.

Lemma range_count : count (range_family m M) = (A * n)%nat.
Proof.
  unfold count, range_family. cbn [matrices]. rewrite (length_flat_map _ n), seq_length; auto.
  intros t _. rewrite map_length, seq_length. auto.
Qed.

Lemma range_entry j t p q : (j < n)%nat -> (t < A)%nat -> (p < W)%nat -> (q < W)%nat ->
  real (range_family m M) (t * n + j) p q = scheme_matrix A (symbol_number m M j) t p q.
Proof.
  intros Hj Ht Hp Hq. transitivity (matrix_of W (masks_common m) (level_matrices m M) j t p q); [|apply (level_matrix m M); auto].
  rewrite <- (any_entry A _ _ _ (matrices_digits m M)) by (auto; rewrite matrices_length; auto). unfold real, mr. f_equal. f_equal. f_equal.
  unfold letter at 1. unfold range_family. cbv zeta. cbn [matrices]. fold A n.
  change (any_of W (masks_common m) (level_matrices m M)) with (levels_family m Any M).
  rewrite (nth_flat_map (fun t => map (fun j => letter (levels_family m Any M) (j * A + t)) (seq 0 n)) n 0%nat [] (seq 0 A) t j)
    by (rewrite ?seq_length; auto; intros; rewrite map_length, seq_length; auto).
  rewrite seq_nth by auto. cbn [Nat.add].
  rewrite nth_indep with (d' := letter (levels_family m Any M) (0 * A + t)) by (rewrite map_length, seq_length; auto).
  rewrite (map_nth (fun j => letter (levels_family m Any M) (j * A + t)) (seq 0 n) 0%nat j), seq_nth by auto. reflexivity.
Qed.

Lemma combinations_alike theta : (forall k, weights_of n (theta k)) -> exists K P,
  masks_alike A (lowest m) (reach m) K P (fun k i => combined n (symbol_number m M) (theta k) (i - lowest m)) /\
  (K + M * (A - 1) <= reach m)%nat.
Proof.
  intros Ht.
  assert (HI : forall k, ((fun k => k mod n) k < length (each m))%nat) by (intros k; apply Nat.mod_upper_bound; lia).
  destruct (symbols_alike m M Reducible Arity (fun k => k mod n)%nat HI) as [K [P [[P0 Al] HK]]].
  fold A in Al, HK. exists K, P. split; auto. split; auto. intros k. destruct (Ht k) as [T0 T1].
  assert (Each : forall j, (j < n)%nat -> supported (lowest m) K (fun i => symbol_number m M j (i - lowest m)) /\
    total (lowest m) (reach m) (fun i => symbol_number m M j (i - lowest m)) = INR A /\
    forall i, (Rabs (symbol_number m M j (i - lowest m)) <= P)%R).
  { intros j Hj. specialize (Al j). cbv beta in Al. rewrite (Nat.mod_small j n Hj), One_first in Al by auto. exact Al. }
  unfold combined. split; [|split].
  - intros i Hi. apply sum_zero; intros j Hj. destruct (Each j Hj) as [S _]. rewrite (S i Hi). lra.
  - unfold total. rewrite sum_swap.
    rewrite (sum_ext n _ (fun j => INR A * theta k j)%R).
    + rewrite sum_scal, T1. lra.
    + intros j Hj. destruct (Each j Hj) as [_ [E _]]. unfold total in E. rewrite sum_scal, E. lra.
  - intros i. apply convex_bound; auto. intros j Hj. apply Each. auto.
Qed.

(* The masks of the list, combined *)
Definition mask_combined (theta : nat -> R) : Z -> R := fun i => sum n (fun j => theta j * mask_at m j i)%R.

Lemma mask_combined_smoothed theta :
  smoothed A M (fun i => combined n (symbol_number m M) theta (i - lowest m)) = mask_combined theta.
Proof.
  extensionality i. unfold combined, mask_combined.
  rewrite (smoothed_sum A M n theta (fun j i => symbol_number m M j (i - lowest m))). apply sum_ext; intros j Hj. f_equal.
  assert (E := mask_smoothed _ _ (Reducible _ (nth_In _ no_mask Hj))). cbn [arity first coefficients common scheme_of] in E.
  fold A in E. unfold mask_at. rewrite E. f_equal. extensionality k. unfold shifted_symbol, symbol_number.
  rewrite symbol_of by auto. cbn [first scheme_of]. rewrite <- (One_first j Hj). reflexivity.
Qed.

(* The theorem for one sequence of combinations *)
Theorem combinations_exponent lambda theta G s : exp lambda = INR A -> (forall k, weights_of n (theta k)) -> (0 < s <= INR M)%R ->
  radius_at_most (size (range_family m M)) (count (range_family m M)) (real (range_family m M)) G ->
  (G <= exp ((INR M - s) * lambda))%R ->
  exists phi, is_levels_limit A (lowest m) (reach m) (fun k => mask_combined (theta k)) phi /\ exponent_at_least phi s.
Proof.
  intros Hlog Ht Hs HR HG. destruct (combinations_alike theta Ht) as [K [P [Al HK]]]. set (N := (W * (A - 1))%nat).
  assert (Sb : short N (fun k => combined n (symbol_number m M) (theta k))).
  { intros k i Hi. unfold combined. apply sum_zero; intros j Hj.
    rewrite (short_symbols m M Arity (fun _ => j) (fun _ => Hj) O i Hi). lra. }
  destruct (levels_radius_exponent A N W N Arity (le_n N) (le_n N) (level_size_positive m M) lambda (lowest m) (reach m)
    (fun _ => lowest m) (fun k => combined n (symbol_number m M) (theta k)) K P G M s Hlog Sb) as [phi [Lim [_ Ex]]]; auto.
  - intros g Hg H0.
    apply (hull_growth A W n (count (range_family m M)) (symbol_number m M) (real (range_family m M)) (fun j t => t * n + j)%nat); auto.
    + intros j t Hj Htt. rewrite range_count. nia.
    + intros j t p q. apply range_entry.
  - exists phi. split; auto. replace (fun k => mask_combined (theta k))
      with (fun k => smoothed A M (fun i => combined n (symbol_number m M) (theta k) (i - lowest m))); auto.
    extensionality k. apply mask_combined_smoothed.
Qed.
End Combinations.

(* ---- the masks of an interval ---------------------------------------------------------------------------------------------- *)

Lemma lowest_of_equal F : forall (l : list (Z * list Z)), (forall p, In p l -> fst p = F) ->
  fold_right (fun p low => Z.min (fst p) low) F l = F.
Proof. induction l; intros H; simpl; auto. rewrite IHl, (H a) by (intros; try apply H; simpl; auto). lia. Qed.

Lemma reach_of_equal F n : forall (l : list (Z * list Z)), (forall p, In p l -> fst p = F /\ length (snd p) = n) -> (1 <= length l)%nat ->
  fold_right (fun p most => Nat.max (Z.to_nat (fst p - F) + length (snd p)) most) O l = n.
Proof.
  assert (G : forall l : list (Z * list Z), (forall p, In p l -> fst p = F /\ length (snd p) = n) ->
    (fold_right (fun p most => Nat.max (Z.to_nat (fst p - F) + length (snd p)) most) O l <= n)%nat).
  { induction l; intros H; simpl. lia. destruct (H a (or_introl eq_refl)) as [-> ->].
    assert (I := IHl (fun p Hp => H p (or_intror Hp))). lia. }
  intros [|p l] H Hl; simpl in Hl. lia. cbn [fold_right]. destruct (H p (or_introl eq_refl)) as [-> ->].
  assert (I := G l (fun p Hp => H p (or_intror Hp))). lia.
Qed.

Section Interval.
Variables (a : ranged) (low high : Q) (common : Z).
Hypothesis Has : has_control_masks a low high common = true.
Let m := control_masks a low high common.
Let n := length (ranged_divisor a).
Let F := ranged_first a.
Let q := form_between low high (ranged_divisor a).
Let factor := fun j => common / nth j q 0.

Lemma interval_facts : (0 < IZR common)%R /\ (real_of low < real_of high)%R /\ (1 <= n)%nat /\ (1 <= length (numerators a))%nat /\
  (forall l, In l (numerators a) -> length l = n) /\
  ((forall c, In c q -> 0 < c) \/ (forall c, In c q -> c < 0)) /\ (forall c, In c q -> common / c * c = common).
Proof.
  unfold has_control_masks in Has. fold q in Has. rewrite !andb_true_iff in Has.
  destruct Has as [[[[[[H1 H2] H3] H4] H5] H6] H7]. rewrite !forallb_forall in *.
  apply Z.ltb_lt in H1, H2. apply Nat.leb_le in H3, H4. split. { apply IZR_lt. auto. } split; [|split; [|split; [|split; [|split]]]]; auto.
  - unfold real_of. apply IZR_lt in H2. rewrite !mult_IZR in H2.
    assert (0 < IZR (Zpos (Qden low)))%R by (apply IZR_lt; lia). assert (0 < IZR (Zpos (Qden high)))%R by (apply IZR_lt; lia).
    apply (Rmult_lt_reg_r (IZR (Zpos (Qden low)) * IZR (Zpos (Qden high)))). apply Rmult_lt_0_compat; auto.
    replace (IZR (Qnum low) / IZR (Zpos (Qden low)) * (IZR (Zpos (Qden low)) * IZR (Zpos (Qden high))))%R
      with (IZR (Qnum low) * IZR (Zpos (Qden high)))%R by (field; lra).
    replace (IZR (Qnum high) / IZR (Zpos (Qden high)) * (IZR (Zpos (Qden low)) * IZR (Zpos (Qden high))))%R
      with (IZR (Qnum high) * IZR (Zpos (Qden low)))%R by (field; lra). auto.
  - intros l Hl. apply Nat.eqb_eq. apply H5. auto.
  - apply orb_prop in H6. rewrite !forallb_forall in H6.
    destruct H6 as [H6|H6]; [left|right]; intros c Hc; apply Z.ltb_lt, H6; auto.
  - intros c Hc. apply Z.eqb_eq, H7. auto.
Qed.

Lemma q_length : length q = n.
Proof. apply form_length. Qed.

Lemma control_count : length (each m) = n.
Proof. unfold m, control_masks. cbn [each]. rewrite map_length, seq_length. reflexivity. Qed.

Lemma control_number j : (j < n)%nat -> nth j (each m) no_mask =
  (F, map (fun f => factor j * nth j f 0) (map (form_between low high) (numerators a))).
Proof.
  intros Hj. unfold m, control_masks. cbn [each]. rewrite (nth_map_seq _ n j) by auto. reflexivity.
Qed.

Lemma control_in p : In p (each m) -> fst p = F /\ length (snd p) = length (numerators a).
Proof.
  intros H. destruct (In_nth _ _ no_mask H) as [j [Hj <-]]. rewrite control_count in Hj. rewrite control_number by auto.
  cbn [fst snd]. rewrite !map_length. auto.
Qed.

Lemma control_lowest : lowest m = F.
Proof.
  destruct interval_facts as [_ [_ [Hn _]]]. unfold lowest. rewrite control_number by (fold n; lia). cbn [fst].
  apply lowest_of_equal. intros p Hp. apply control_in; auto.
Qed.

Lemma control_reach : reach m = length (numerators a).
Proof.
  destruct interval_facts as [_ [_ [Hn _]]]. unfold reach. rewrite control_lowest. apply reach_of_equal.
  intros p Hp. apply control_in; auto. rewrite control_count. auto.
Qed.

Lemma control_first j : (j < length (each m))%nat -> first_number m j = lowest m.
Proof. rewrite control_count. intros Hj. unfold first_number. rewrite control_number, control_lowest by auto. reflexivity. Qed.

(* The weights of the control masks in the mask of a value *)
Definition weights_at (x : R) : nat -> R :=
  let u := ((x - real_of low) / (real_of high - real_of low))%R in let v := (1 - u)%R in
  fun j => (IZR (nth j q 0%Z) * (u ^ j * v ^ (n - 1 - j)) / form_at u v q)%R.

(* Each mask of the interval is a convex combination of the control masks. *)
Theorem mask_between x : between low high x -> polynomial_at (ranged_divisor a) x <> 0%R /\
  weights_of (length (each m)) (weights_at x) /\ mask_of_value a x = mask_combined m (weights_at x).
Proof.
  intros [X0 X1]. destruct interval_facts as [Hc [Hlow [Hn [_ [Same_length [Signs Multiples]]]]]].
  set (e := (Zpos (Qden low) * Zpos (Qden high))%Z).
  assert (E : (0 < IZR e)%R) by (apply IZR_lt; unfold e; lia).
  set (u := ((x - real_of low) / (real_of high - real_of low))%R). set (v := (1 - u)%R).
  assert (UV : (u + v = 1)%R) by (unfold v; lra).
  assert (U0 : (0 <= u)%R) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
  assert (V0 : (0 <= v)%R).
  { unfold v, u. apply (Rmult_le_reg_r (real_of high - real_of low)). lra.
    replace ((1 - (x - real_of low) / (real_of high - real_of low)) * (real_of high - real_of low))%R
      with (real_of high - x)%R by (field; lra). lra. }
  assert (Value : (IZR e * x = IZR (Qnum low * Zpos (Qden high)) * v + IZR (Qnum high * Zpos (Qden low)) * u)%R).
  { assert (DL : (0 < IZR (Zpos (Qden low)))%R) by (apply IZR_lt; lia).
    assert (DH : (0 < IZR (Zpos (Qden high)))%R) by (apply IZR_lt; lia).
    replace x with (real_of low * v + real_of high * u)%R by (unfold v, u; field; lra).
    unfold e, real_of. rewrite !mult_IZR. field. lra. }
  assert (Form : forall l, (IZR e * form_at u v (form_between low high l) = IZR e ^ length l * polynomial_at l x)%R)
    by (intros l; apply form_at_form; auto).
  set (b := fun j => (u ^ j * v ^ (n - 1 - j))%R).
  assert (B0 : forall j, (0 <= b j)%R) by (intros j; apply Rmult_le_pos; apply pow_le; auto).
  assert (Sum : forall l, length l = n ->
    form_at u v (form_between low high l) = sum n (fun j => IZR (nth j (form_between low high l) 0%Z) * b j)%R).
  { intros l Hl. rewrite form_at_sum. unfold form_between at 1. rewrite form_length, Hl. apply sum_ext; intros j Hj.
    unfold form_between at 2. rewrite form_length, Hl. reflexivity. }
  set (total := form_at u v q).
  assert (Positive : exists j, (j < n)%nat /\ (0 < b j)%R).
  { destruct (Rle_lt_or_eq_dec 0 u U0) as [U|U].
    - exists (n - 1)%nat. split. lia. unfold b. rewrite Nat.sub_diag. simpl. rewrite Rmult_1_r. apply pow_lt; auto.
    - exists O. split. lia. unfold b. simpl. rewrite Rmult_1_l. apply pow_lt. lra. }
  assert (Member : forall j, (j < n)%nat -> In (nth j q 0) q) by (intros j Hj; apply nth_In; rewrite q_length; auto).
  assert (Total : total <> 0%R /\ forall j, (j < n)%nat -> (0 <= IZR (nth j q 0%Z) * b j / total)%R).
  { destruct Positive as [j0 [J0 B1]]. assert (T : total = sum n (fun j => IZR (nth j q 0%Z) * b j)%R) by (apply Sum; auto).
    destruct Signs as [S|S].
    - assert (P : forall j, (j < n)%nat -> (0 <= IZR (nth j q 0%Z) * b j)%R).
      { intros j Hj. apply Rmult_le_pos; auto. apply IZR_le. specialize (S _ (Member j Hj)). lia. }
      assert (0 < total)%R.
      { rewrite T. eapply Rlt_le_trans; [|apply (sum_term n (fun j => IZR (nth j q 0%Z) * b j)%R j0 P J0)].
        apply Rmult_lt_0_compat; auto. apply IZR_lt. auto. }
      split. lra. intros j Hj. apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto.
    - assert (P : forall j, (j < n)%nat -> (0 <= - (IZR (nth j q 0%Z) * b j))%R).
      { intros j Hj. rewrite Ropp_mult_distr_l. apply Rmult_le_pos; auto. rewrite <- opp_IZR. apply IZR_le.
        specialize (S _ (Member j Hj)). lia. }
      assert (0 < - total)%R.
      { assert (O : (- total = sum n (fun j => - (IZR (nth j q 0%Z) * b j)))%R).
        { rewrite T. replace (- sum n (fun j => IZR (nth j q 0%Z) * b j))%R with (-1 * sum n (fun j => IZR (nth j q 0%Z) * b j))%R by ring.
          rewrite <- sum_scal. apply sum_ext; intros; ring. }
        rewrite O. eapply Rlt_le_trans; [|apply (sum_term n (fun j => - (IZR (nth j q 0%Z) * b j))%R j0 P J0)].
        rewrite Ropp_mult_distr_l. apply Rmult_lt_0_compat; auto. rewrite <- opp_IZR. apply IZR_lt.
        specialize (S _ (Member j0 J0)). lia. }
      split. lra. intros j Hj. replace (IZR (nth j q 0%Z) * b j / total)%R with (- (IZR (nth j q 0%Z) * b j) / - total)%R by (field; lra).
      apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
  destruct Total as [T0 T1].
  assert (Divisor : (IZR e * total = IZR e ^ n * polynomial_at (ranged_divisor a) x)%R) by apply Form.
  assert (En : (0 < IZR e ^ n)%R) by (apply pow_lt; auto).
  assert (D0 : polynomial_at (ranged_divisor a) x <> 0%R).
  { intros D. rewrite D, Rmult_0_r in Divisor. apply Rmult_integral in Divisor. destruct Divisor; lra. }
  split; auto. change (weights_at x) with (fun j => IZR (nth j q 0%Z) * b j / total)%R. rewrite control_count. split.
  - split; auto. unfold Rdiv. rewrite (sum_ext n _ (fun j => / total * (IZR (nth j q 0%Z) * b j))%R) by (intros; ring).
    rewrite sum_scal. replace (sum n (fun j => IZR (nth j q 0%Z) * b j)%R) with total by (apply Sum; auto). field. auto.
  - extensionality i. unfold mask_of_value, mask_combined. rewrite control_count.
    rewrite (sum_ext n _ (fun j => IZR (nth j q 0%Z) * b j / total *
      coefficient (map (fun f => factor j * nth j f 0)%Z (map (form_between low high) (numerators a))) common F i)%R).
    2:{ intros j Hj. unfold mask_at. rewrite control_number by auto. reflexivity. }
    unfold coefficient. fold F. destruct (i <? F). symmetry; apply sum_zero; intros; ring.
    set (k := Z.to_nat (i - F)). set (p := nth k (numerators a) []).
    rewrite (sum_ext n _ (fun j => / total * (IZR (nth j (form_between low high p) 0%Z) * b j))%R).
    2:{ intros j Hj.
        assert (N0 : nth k (map (fun f => factor j * nth j f 0)%Z (map (form_between low high) (numerators a))) 0%Z =
          (factor j * nth j (form_between low high p) 0)%Z).
        { unfold p. rewrite <- (map_nth (form_between low high)).
          rewrite <- (map_nth (fun f => factor j * nth j f 0)%Z). f_equal. cbn. destruct j; lia. }
        rewrite N0, mult_IZR. unfold factor.
        assert (M := Multiples _ (Member j Hj)). apply (f_equal IZR) in M. rewrite mult_IZR in M.
        set (y := IZR (nth j (form_between low high p) 0%Z)).
        replace (IZR (nth j q 0%Z) * b j / total * (IZR (common / nth j q 0%Z) * y / IZR common))%R
          with (IZR (common / nth j q 0%Z) * IZR (nth j q 0%Z) / IZR common * (/ total * (y * b j)))%R
          by (field; lra).
        rewrite M. field. lra. }
    rewrite sum_scal.
    assert (P : sum n (fun j => IZR (nth j (form_between low high p) 0%Z) * b j)%R = (IZR e ^ n * polynomial_at p x / IZR e)%R).
    { destruct (Nat.lt_ge_cases k (length (numerators a))) as [H|H].
      - assert (L := Same_length p (nth_In _ [] H)). rewrite <- Sum, <- L, <- Form by auto. field. lra.
      - unfold p. rewrite nth_overflow by auto. cbn. rewrite Rmult_0_r. unfold Rdiv. rewrite Rmult_0_l.
        apply sum_zero. intros j Hj. destruct j; ring. }
    rewrite P. replace total with (IZR e ^ n * polynomial_at (ranged_divisor a) x / IZR e)%R by (rewrite <- Divisor; field; lra).
    field. repeat split; lra.
Qed.
End Interval.

(* ---- the theorems ------------------------------------------------------------------------------------------------------------ *)

Lemma below_power_strictly_sound lambda A l M u : exp lambda = INR A -> (2 <= A)%nat -> below_power_strictly A l M u = true ->
  (0 <= real_of l)%R /\ exists s, (real_of l < s <= INR M)%R /\ (real_of u <= exp ((INR M - s) * lambda))%R.
Proof.
  intros Hlog HA H. unfold below_power_strictly in H. cbv zeta in H. rewrite !andb_true_iff in H. destruct H as [[H1 H2] H3].
  apply Z.leb_le in H1. apply Z.ltb_lt in H2, H3. set (top := Z.of_nat M * Zpos (Qden l) - Qnum l) in *.
  assert (D : (0 < IZR (Zpos (Qden l)))%R) by (apply IZR_lt; lia). assert (D' : (0 < IZR (Zpos (Qden u)))%R) by (apply IZR_lt; lia).
  assert (E : (INR M - real_of l)%R = (IZR top / IZR (Zpos (Qden l)))%R).
  { unfold top, real_of. rewrite minus_IZR, mult_IZR, <- INR_IZR_INZ. field. lra. }
  assert (L0 : (0 < lambda)%R) by (apply (log_positive A HA lambda Hlog)).
  assert (Lm : (0 < INR M - real_of l)%R) by (rewrite E; apply Rdiv_lt_0_compat; auto; apply IZR_lt; auto).
  assert (U : (real_of u < exp ((INR M - real_of l) * lambda))%R).
  { rewrite E. rewrite INR_IZR_INZ in Hlog.
    assert (P := power_below_sound (Z.of_nat A) lambda ltac:(lia) Hlog M top (Zpos (Qden l)) ltac:(lia) ltac:(lia)).
    set (x := power_below (Z.of_nat A) M top (Zpos (Qden l))) in *.
    apply IZR_lt in H3. rewrite !mult_IZR in H3. assert (P1 := unity_positive).
    unfold real_of. apply (Rmult_lt_reg_r (IZR unity * IZR (Zpos (Qden u)))). apply Rmult_lt_0_compat; auto.
    replace (IZR (Qnum u) / IZR (Zpos (Qden u)) * (IZR unity * IZR (Zpos (Qden u))))%R with (IZR (Qnum u) * IZR unity)%R by (field; lra).
    eapply Rlt_le_trans. apply H3. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra. }
  split. { unfold real_of. apply Rmult_le_pos. apply IZR_le; auto. left; apply Rinv_0_lt_compat; auto. }
  destruct (exp_onto_above (Rmax 1 (real_of u)) (Rmax_l _ _)) as [y Hy].
  assert (Y : (y < (INR M - real_of l) * lambda)%R).
  { apply Rnot_le_lt. intros N. apply exp_at_most in N. rewrite Hy in N.
    assert (1 < exp ((INR M - real_of l) * lambda))%R by (rewrite <- exp_0; apply exp_less; apply Rmult_lt_0_compat; auto).
    destruct (Rmax_Rle 1 (real_of u) (exp ((INR M - real_of l) * lambda))) as [N' _]. destruct (N' N); lra. }
  assert (Y0 : (0 <= y)%R).
  { apply Rnot_lt_le. intros N. apply exp_less in N. rewrite exp_0, Hy in N. generalize (Rmax_l 1 (real_of u)). lra. }
  exists (INR M - y / lambda)%R. split; [split|].
  - assert (y / lambda < INR M - real_of l)%R; [|lra]. apply (Rmult_lt_reg_r lambda); auto.
    replace (y / lambda * lambda)%R with y by (field; lra). auto.
  - assert (0 <= y / lambda)%R; [|lra]. apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto.
  - replace ((INR M - (INR M - y / lambda)) * lambda)%R with y by (field; lra). rewrite Hy. apply Rmax_r.
Qed.

(* What the checker accepts is true. *)
Theorem check_range_levels_sound a low high l common cert :
  check_range_levels a low high l common cert = true -> range_levels_hold a low high l.
Proof.
  intros H. unfold check_range_levels, check_interval in H. cbv zeta in H. set (m := control_masks a low high common) in *.
  rewrite !andb_true_iff in H. destruct H as [[[[HA Has] HM] HB] HR]. apply Nat.leb_le in HA. rewrite forallb_forall in HM.
  set (M := order cert) in *.
  assert (HR' := radius_bounded _ _ (check_radius_sound _ _ HR)).
  destruct (exp_onto (INR (ranged_arity a)) (arity_positive _ HA)) as [lambda Hlog].
  destruct (below_power_strictly_sound lambda _ _ _ _ Hlog HA HB) as [L0 [s [Hs HU]]].
  destruct (interval_facts a low high common Has) as [_ [_ [Hn _]]].
  assert (Hn' : (1 <= length (each m))%nat) by (unfold m; rewrite control_count; auto).
  split. { intros x Hx. apply (mask_between a low high common Has x Hx). }
  exists s. split. lra. intros w Hw.
  set (theta := fun k => weights_at a low high (w k)).
  assert (Ht : forall k, weights_of (length (each m)) (theta k) /\ mask_of_value a (w k) = mask_combined m (theta k)).
  { intros k. apply (mask_between a low high common Has (w k) (Hw k)). }
  destruct (combinations_exponent m M HA Hn' HM (control_first a low high common Has) lambda theta (real_of (bound cert)) s Hlog)
    as [phi [Lim Ex]]; auto.
  { intros k. apply Ht. } { lra. }
  exists phi. split; auto. unfold limit_of_values.
  replace (fun k => mask_of_value a (w k)) with (fun k => mask_combined m (theta k)).
  - rewrite <- (control_reach a low high common Has), <- (control_lowest a low high common Has). exact Lim.
  - extensionality k. symmetry. apply Ht.
Qed.

Theorem check_range_sound a l : forall pieces low high, check_range a low high l pieces = true -> range_holds a low high l.
Proof.
  assert (One : forall low high common cert, check_interval a low high l common cert = true -> range_holds a low high l).
  { intros low high common cert H. destruct (check_range_levels_sound a low high l common cert H) as [D [s [Hs Hw]]].
    split; auto. exists s. split; auto. intros x Hx. destruct (Hw (fun _ => x) (fun _ => Hx)) as [phi [Lim Ex]].
    exists phi. split; auto. }
  induction pieces as [|[next [common cert]] pieces IH]; intros low high H. discriminate.
  destruct pieces as [|p pieces]. { exact (One low high common cert H). }
  change (check_interval a low next l common cert && check_range a next high l (p :: pieces) = true) in H.
  apply andb_prop in H. destruct H as [H1 H2]. destruct (One _ _ _ _ H1) as [D1 [s1 [S1 E1]]]. destruct (IH _ _ H2) as [D2 [s2 [S2 E2]]].
  assert (Less : forall s t phi, (s <= t)%R -> exponent_at_least phi t -> exponent_at_least phi s).
  { intros s t phi Hst E x Hx. apply E. lra. }
  split.
  - intros x [X0 X1]. destruct (Rle_lt_dec x (real_of next)); [apply D1|apply D2]; split; lra.
  - exists (Rmin s1 s2). split. apply Rmin_glb_lt; auto.
    intros x [X0 X1]. destruct (Rle_lt_dec x (real_of next)).
    + destruct (E1 x ltac:(split; lra)) as [phi [Lim Ex]]. exists phi. split; auto. eapply Less; [apply Rmin_l|apply Ex].
    + destruct (E2 x ltac:(split; lra)) as [phi [Lim Ex]]. exists phi. split; auto. eapply Less; [apply Rmin_r|apply Ex].
Qed.

(* There is one limit for each sequence, and its exponent as a number, if it is one, is above l. *)
Corollary exponent_of_values a low high l : (2 <= ranged_arity a)%nat -> range_levels_hold a low high l ->
  forall w, (forall k, between low high (w k)) -> forall phi t, limit_of_values a w phi -> is_lub (exponents phi) t -> (real_of l < t)%R.
Proof.
  intros HA [_ [s [Hs H]]] w Hw phi t Lim [U _]. destruct (H w Hw) as [psi [Lim' Hx]]. replace phi with psi in *.
  - destruct (Hx ((real_of l + s) / 2)%R ltac:(lra)) as [x [Ex Hl]]. specialize (U x Ex). lra.
  - extensionality x. eapply levels_unique; eauto.
Qed.
