(* A mask for each level, from a list: what is proved of all sequences of its masks, or of those along the edges of a graph
   (SPEC.md, section 6.5, Theorem 50). *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Integers Sections Check Subdivision Coefficients Exponent Along.
Import ListNotations.
Open Scope Z_scope.

(* ---- claims: what is proved of a list -------------------------------------------------------------------------------- *)

(* Masks of one arity: the first index and the coefficients of each, over one denominator *)
Record masks := Masks { masks_arity : nat; masks_common : Z; each : list (Z * list Z) }.
Definition no_mask : Z * list Z := (0, []).
Definition mask_at (m : masks) (i : nat) : Z -> R :=
  coefficient (snd (nth i (each m) no_mask)) (masks_common m) (fst (nth i (each m) no_mask)).

(* All their coefficients have indices from lowest m to lowest m + reach m. *)
Definition lowest (m : masks) : Z := fold_right (fun p low => Z.min (fst p) low) (fst (nth 0 (each m) no_mask)) (each m).
Definition reach (m : masks) : nat :=
  fold_right (fun p most => Nat.max (Z.to_nat (fst p - lowest m) + length (snd p)) most) O (each m).

(* Of a sequence of numbers of masks: level k + 1 is made from level k by the mask number i k. *)
Definition limit_of_sequence (m : masks) (i : nat -> nat) (phi : R -> R) : Prop :=
  is_levels_limit (masks_arity m) (lowest m) (reach m) (fun k => mask_at m (i k)) phi.

(* For each of the sequences the scheme converges, and the exponent of its limit is at least l. *)
Definition levels_hold (m : masks) (s : sequences) (l : Q) : Prop :=
  forall i, allowed (length (each m)) s i -> exists phi, limit_of_sequence m i phi /\ exponent_at_least phi (real_of l).

(* ---- the checker ------------------------------------------------------------------------------------------------------- *)

Definition scheme_of (m : masks) (p : Z * list Z) : scheme := Scheme (masks_arity m) (fst p) (snd p) (masks_common m).
Definition level_symbols (m : masks) (order : nat) : list (list Z) := map (fun p => difference_symbol (scheme_of m p) order) (each m).
Definition level_size (m : masks) (order : nat) : nat :=
  fold_right (fun b most => Nat.max (matrix_size (masks_arity m) b) most) 1%nat (level_symbols m order).

(* The matrices of each mask *)
Definition level_matrices (m : masks) (order : nat) : list (list zmat) :=
  map (transition (masks_arity m) (level_size m order)) (level_symbols m order).
Definition levels_family (m : masks) (s : sequences) (order : nat) : family :=
  along s (level_size m order) (masks_common m) (level_matrices m order).

Definition levels_reduce (m : masks) (s : sequences) (l : Q) (order : nat) (u : Q) : bool :=
  (2 <=? masks_arity m)%nat && forallb (fun p => reducible (scheme_of m p) order) (each m) &&
  below_power (scheme_of m no_mask) l order u &&
  known (length (each m)) s.

Definition check_levels (m : masks) (s : sequences) (l : Q) (cert : exponent_certificate) : bool :=
  levels_reduce m s l (order cert) (bound cert) &&
  check_radius (Claim (levels_family m s (order cert)) None (Some (bound cert))) (of_radius cert).

(* ---- lists --------------------------------------------------------------------------------------------------------------- *)

Lemma minimum_below {A} (f : A -> Z) most l x : In x l -> fold_right (fun p low => Z.min (f p) low) most l <= f x.
Proof. induction l; simpl; intros []; subst. lia. specialize (IHl H). lia. Qed.

(* ---- what all masks have in common --------------------------------------------------------------------------------------- *)

Definition first_number (m : masks) (i : nat) : Z := fst (nth i (each m) no_mask).

Lemma first_above_lowest m i : (i < length (each m))%nat -> lowest m <= first_number m i.
Proof. intros H. apply (minimum_below fst). apply nth_In. auto. Qed.

Lemma within_reach m i : (i < length (each m))%nat ->
  first_number m i + Z.of_nat (length (snd (nth i (each m) no_mask))) <= lowest m + Z.of_nat (reach m).
Proof.
  intros H. assert (L := first_above_lowest m i H).
  assert (R := maximum_above (fun p => (Z.to_nat (fst p - lowest m) + length (snd p))%nat) 0 (each m) _ (nth_In _ no_mask H)).
  unfold reach. unfold first_number in *. lia.
Qed.

Section Reduced.
Variables (m : masks) (M : nat).
Let A := masks_arity m.
Hypothesis Reducible : forall p, In p (each m) -> reducible (scheme_of m p) M = true.
Hypothesis Arity : (2 <= A)%nat.
Let W := level_size m M.
Let N := (W * (A - 1))%nat.

(* The symbol of mask number i *)
Definition symbol_number (i : nat) : Z -> R := coefficient (nth i (level_symbols m M) []) (masks_common m) 0.
Lemma symbol_of i : (i < length (each m))%nat -> nth i (level_symbols m M) [] = difference_symbol (scheme_of m (nth i (each m) no_mask)) M.
Proof.
  intros H. unfold level_symbols. rewrite nth_indep with (d' := difference_symbol (scheme_of m no_mask) M) by (rewrite map_length; auto).
  apply (map_nth (fun p => difference_symbol (scheme_of m p) M)).
Qed.

Lemma level_size_fits i : (i < length (each m))%nat -> (length (nth i (level_symbols m M) []) - 1 <= N)%nat.
Proof.
  intros H. set (b := nth i (level_symbols m M) []). destruct (matrix_size_fits A b Arity) as [S _].
  eapply Nat.le_trans. apply S. unfold N. apply Nat.mul_le_mono_r. unfold W, level_size. fold A.
  apply (maximum_above (matrix_size A)). apply nth_In. unfold level_symbols. rewrite map_length. auto.
Qed.

Lemma level_size_positive : (1 <= W)%nat.
Proof. apply (maximum_least (matrix_size A)). Qed.

Lemma short_symbols i : (forall k, (i k < length (each m))%nat) -> short N (fun k => symbol_number (i k)).
Proof.
  intros H k j Hj. apply coefficient_support. generalize (level_size_fits (i k) (H k)). lia.
Qed.

(* A bound of the coefficients of all masks *)
Lemma symbols_bounded : exists P, (0 <= P)%R /\ forall i j, (i < length (each m))%nat -> (Rabs (symbol_number i j) <= P)%R.
Proof.
  assert (B : forall l : list (list Z), exists P, (0 <= P)%R /\ forall b j, In b l -> (Rabs (coefficient b (masks_common m) 0 j) <= P)%R).
  { induction l as [|b l [P [P0 HP]]].
    - exists 0%R. split. lra. intros b j [].
    - destruct (supported_bounded A 0 Arity (length b - 1) (coefficient b (masks_common m) 0)) as [Q [Q0 HQ]].
      { intros j Hj. apply coefficient_support. lia. }
      exists (P + Q)%R. split. lra. intros c j [<-|H]. generalize (HQ j). lra. generalize (HP c j H). lra. }
  destruct (B (level_symbols m M)) as [P [P0 HP]]. exists P. split; auto. intros i j Hi. apply HP. apply nth_In.
  unfold level_symbols. rewrite map_length. auto.
Qed.

Lemma symbols_alike i : (forall k, (i k < length (each m))%nat) -> exists K P,
  masks_alike A (lowest m) (reach m) K P (fun k j => symbol_number (i k) (j - first_number m (i k))) /\ (K + M * (A - 1) <= reach m)%nat.
Proof.
  intros H. destruct symbols_bounded as [P [P0 HP]].
  assert (Fit : forall k, first_number m (i k) + Z.of_nat (length (nth (i k) (level_symbols m M) []) - 1 + M * (A - 1)) <=
    lowest m + Z.of_nat (reach m)).
  { intros k. assert (R := within_reach m (i k) (H k)). set (p := nth (i k) (each m) no_mask) in *.
    assert (F := symbol_fits (scheme_of m p) M (Reducible p (nth_In _ _ (H k)))). cbn [arity coefficients scheme_of] in F. fold A in F.
    rewrite symbol_of by auto. fold p. unfold first_number in *. fold p in R. fold p. lia. }
  exists (reach m - M * (A - 1))%nat, P. assert (F0 := Fit O). assert (L0 := first_above_lowest m _ (H O)).
  split; [|lia]. split; auto. intros k. assert (Fk := Fit k). assert (Lk := first_above_lowest m _ (H k)).
  set (p := nth (i k) (each m) no_mask) in *. assert (Red := Reducible p (nth_In _ _ (H k))).
  set (b := nth (i k) (level_symbols m M) []) in *.
  assert (Out : forall j, (j < first_number m (i k) \/ first_number m (i k) + Z.of_nat (length b - 1) < j)%Z ->
    symbol_number (i k) (j - first_number m (i k)) = 0%R).
  { intros j Hj. apply coefficient_support. fold b. lia. }
  split; [|split].
  - intros j Hj. apply Out. lia.
  - assert (T := symbol_total (scheme_of m p) M (length b - 1) Red ltac:(unfold b; rewrite symbol_of by auto; fold p; lia)).
    unfold total in *. cbn [first arity scheme_of] in T. change (fst p) with (first_number m (i k)) in T. fold A in T. rewrite <- T.
    set (c := fun j => symbol_number (i k) (j - first_number m (i k))).
    transitivity (sum (S (reach m)) (fun j => c (lowest m + Z.of_nat j)%Z)); [reflexivity|].
    rewrite (sum_two_windows c (lowest m) (S (reach m)) (first_number m (i k)) (S (length b - 1))).
    + apply sum_ext; intros j Hj. unfold c, symbol_number, shifted_symbol. rewrite symbol_of by auto. reflexivity.
    + intros j Hj. apply Out. lia.
    + intros j Hj. apply Out. lia.
  - intros j. apply HP. auto.
Qed.

(* The theorem for one sequence: a bound of its products *)
Theorem sequence_exponent lambda i G l : exp lambda = INR A -> (forall k, (i k < length (each m))%nat) -> (0 < l <= INR M)%R ->
  (forall g, (G < g)%R -> (0 < g)%R -> exists C, forall w, letters A w -> forall p q, (p < W)%nat -> (q < W)%nat ->
    (Rabs (level_product A W (fun k => symbol_number (i k)) w p q) <= C * g ^ length w)%R) ->
  (G <= exp ((INR M - l) * lambda))%R -> exists phi, limit_of_sequence m i phi /\ exponent_at_least phi l.
Proof.
  intros Hlog H Hl HG HGl. destruct (symbols_alike i H) as [K [P [Al HK]]].
  destruct (levels_radius_exponent A N W N Arity (le_n N) (le_n N) level_size_positive lambda (lowest m) (reach m)
    (fun k => first_number m (i k)) (fun k => symbol_number (i k)) K P G M l Hlog (short_symbols i H)) as [phi [Lim [_ Ex]]]; auto.
  exists phi. split; auto. unfold limit_of_sequence. fold A.
  replace (fun k => mask_at m (i k)) with (fun k => smoothed A M (fun j => symbol_number (i k) (j - first_number m (i k)))); auto.
  extensionality k. assert (E := mask_smoothed _ _ (Reducible _ (nth_In _ no_mask (H k)))).
  unfold mask_at. cbn [arity first coefficients common scheme_of] in E. rewrite E. fold A. f_equal.
  extensionality j. unfold shifted_symbol, symbol_number. rewrite symbol_of by auto. reflexivity.
Qed.
End Reduced.

(* ---- products ------------------------------------------------------------------------------------------------------------- *)

Section Families.
Variables (m : masks) (M : nat).
Let A := masks_arity m.
Let W := level_size m M.

Lemma transition_square b : forall T, In T (transition A W b) -> square W T = true.
Proof.
  intros T H. unfold transition in H. apply in_map_iff in H. destruct H as [t [<- _]]. apply square_spec. split.
  - rewrite map_length, seq_length. auto.
  - intros row H. apply in_map_iff in H. destruct H as [j [<- _]]. cbv zeta. rewrite map_length, seq_length. auto.
Qed.

Lemma transition_length b : length (transition A W b) = A.
Proof. unfold transition. rewrite map_length, seq_length. auto. Qed.

Lemma matrices_length : length (level_matrices m M) = length (each m).
Proof. unfold level_matrices, level_symbols. rewrite !map_length. auto. Qed.

Lemma matrices_digits Ms : In Ms (level_matrices m M) -> length Ms = A.
Proof. intros H. apply in_map_iff in H. destruct H as [b [<- _]]. apply transition_length. Qed.

Lemma matrices_square Ms T : In Ms (level_matrices m M) -> In T Ms -> square W T = true.
Proof. intros H. apply in_map_iff in H. destruct H as [b [<- _]]. apply transition_square. Qed.

Lemma level_matrix i t j k : (i < length (each m))%nat -> (t < A)%nat -> (j < W)%nat -> (k < W)%nat ->
  matrix_of W (masks_common m) (level_matrices m M) i t j k = scheme_matrix A (symbol_number m M i) t j k.
Proof.
  intros Hi Ht Hj Hk. unfold symbol_number. rewrite <- (transition_entry A W _ (masks_common m)) by auto. unfold matrix_of. do 2 f_equal.
  unfold level_matrices. fold A W. rewrite nth_indep with (d' := transition A W []) by (rewrite map_length; unfold level_symbols; rewrite map_length; auto).
  apply map_nth.
Qed.

Lemma word_levels w : letters A w -> forall i, (forall k, (i k < length (each m))%nat) -> forall p q, (p < W)%nat -> (q < W)%nat ->
  level_product A W (fun k => symbol_number m M (i k)) w p q = level_word W (fun k => matrix_of W (masks_common m) (level_matrices m M) (i k)) w p q.
Proof.
  induction w as [|t w IH]; intros Hw i Hi p q Hp Hq; auto. inversion Hw; subst. cbn [level_product level_word]. unfold times.
  apply sum_ext; intros l Hl. rewrite level_matrix by auto. f_equal. apply (IH H2 (fun k => i (S k)) (fun k => Hi (S k))); auto.
Qed.
End Families.

(* ---- the theorems -------------------------------------------------------------------------------------------------------- *)

Theorem levels_of_radius m s l order u : levels_reduce m s l order u = true -> let T := levels_family m s order in
  radius_at_most (size T) (count T) (real T) (real_of u) -> levels_hold m s l.
Proof.
  intros H T HR i Hi. unfold levels_reduce in H. rewrite !andb_true_iff in H. destruct H as [[[HA HM] HB] HS].
  apply Nat.leb_le in HA. rewrite forallb_forall in HM. set (A := masks_arity m) in *.
  destruct (exp_onto (INR A) (arity_positive A HA)) as [lambda Hlog].
  apply (below_power_sound lambda) in HB; auto. destruct HB as [Hl HU]. rewrite <- (matrices_length m order) in HS, Hi.
  destruct (along_growth s A _ _ _ (real_of u) (matrices_digits m order) (matrices_square m order) HS HR i Hi) as [Hn G].
  rewrite matrices_length in Hn. apply (sequence_exponent m order HM HA lambda i (real_of u) (real_of l)); auto.
  intros g Hg H0. destruct (G g Hg H0) as [C HC]. exists C. intros w Hw p q Hp Hq. rewrite word_levels; auto.
Qed.

(* What the checker accepts is true. *)
Theorem check_levels_sound m s l cert : check_levels m s l cert = true -> levels_hold m s l.
Proof.
  intros H. apply andb_prop in H. destruct H as [H1 H2]. apply (levels_of_radius m s l (order cert) (bound cert) H1).
  apply radius_bounded, (check_radius_sound _ _ H2).
Qed.

(* There is one limit for each sequence, and its exponent as a number, if it is one, is at least l. *)
Corollary exponent_of_sequence m s l : (2 <= masks_arity m)%nat -> levels_hold m s l -> forall i, allowed (length (each m)) s i ->
  forall phi t, limit_of_sequence m i phi -> is_lub (exponents phi) t -> (real_of l <= t)%R.
Proof.
  intros HA H i Hi phi t Lim [U _]. destruct (H i Hi) as [psi [Lim' Hx]]. replace phi with psi in *.
  - apply le_epsilon. intros eps He. destruct (Hx (real_of l - eps)%R ltac:(lra)) as [x [Hs Hl]]. specialize (U x Hs). lra.
  - extensionality x. eapply levels_unique; eauto.
Qed.
