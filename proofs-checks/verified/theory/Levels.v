(* A mask for each level, from a list: what is proved of all sequences of its masks, or of those along the edges of a graph
   (SPEC.md, section 6.5, Theorem 50). *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Integers Sections Check Subdivision Coefficients Exponent.
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

(* All sequences, or those in which each pair of neighbours is one of these *)
Inductive sequences := Any | Follows (pairs : list (nat * nat)).
Definition allowed (m : masks) (s : sequences) (i : nat -> nat) : Prop :=
  match s with
  | Any => forall k, (i k < length (each m))%nat
  | Follows pairs => forall k, In (i k, i (S k)) pairs
  end.

(* For each of the sequences the scheme converges, and the exponent of its limit is at least l. *)
Definition levels_hold (m : masks) (s : sequences) (l : Q) : Prop :=
  forall i, allowed m s i -> exists phi, limit_of_sequence m i phi /\ exponent_at_least phi (real_of l).

(* ---- the checker ------------------------------------------------------------------------------------------------------- *)

Definition scheme_of (m : masks) (p : Z * list Z) : scheme := Scheme (masks_arity m) (fst p) (snd p) (masks_common m).
Definition level_symbols (m : masks) (order : nat) : list (list Z) := map (fun p => difference_symbol (scheme_of m p) order) (each m).
Definition level_size (m : masks) (order : nat) : nat :=
  fold_right (fun b most => Nat.max (matrix_size (masks_arity m) b) most) 1%nat (level_symbols m order).

(* The matrices of the first mask, then those of the second one, and so on *)
Definition any_family (m : masks) (order : nat) : family :=
  let size := level_size m order in
  Family size (masks_common m) (flat_map (transition (masks_arity m) size) (level_symbols m order)).

(* A matrix as the block of row i and column j of a matrix of k times k blocks, the others of which are 0 *)
Definition row_in_place (k size j : nat) (row : list Z) : list Z := repeat 0 (j * size) ++ row ++ repeat 0 ((k - 1 - j) * size).
Definition in_place (k size i j : nat) (M : zmat) : zmat :=
  repeat (repeat 0 (k * size)) (i * size) ++ map (row_in_place k size j) M ++ repeat (repeat 0 (k * size)) ((k - 1 - i) * size).

(* Pair by pair the matrices of its second mask *)
Definition states (pairs : list (nat * nat)) : nat := S (fold_right (fun e most => Nat.max (fst e) (Nat.max (snd e) most)) O pairs).
Definition follows_family (m : masks) (order : nat) (pairs : list (nat * nat)) : family :=
  let size := level_size m order in let k := states pairs in let symbols := level_symbols m order in
  Family (k * size) (masks_common m)
    (flat_map (fun e => map (in_place k size (fst e) (snd e)) (transition (masks_arity m) size (nth (snd e) symbols []))) pairs).

Definition levels_family (m : masks) (s : sequences) (order : nat) : family :=
  match s with Any => any_family m order | Follows pairs => follows_family m order pairs end.

Definition levels_reduce (m : masks) (s : sequences) (l : Q) (order : nat) (u : Q) : bool :=
  (2 <=? masks_arity m)%nat && forallb (fun p => reducible (scheme_of m p) order) (each m) &&
  below_power (scheme_of m no_mask) l order u &&
  match s with Any => true | Follows pairs => forallb (fun e => (fst e <? length (each m)) && (snd e <? length (each m)))%nat pairs end.

Definition check_levels (m : masks) (s : sequences) (l : Q) (cert : exponent_certificate) : bool :=
  levels_reduce m s l (order cert) (bound cert) &&
  check_radius (Claim (levels_family m s (order cert)) None (Some (bound cert))) (of_radius cert).

(* ---- lists --------------------------------------------------------------------------------------------------------------- *)

Lemma maximum_above {A} (f : A -> nat) least l x : In x l -> (f x <= fold_right (fun p most => Nat.max (f p) most) least l)%nat.
Proof. induction l; simpl; intros []; subst. lia. specialize (IHl H). lia. Qed.

Lemma maximum_least {A} (f : A -> nat) least l : (least <= fold_right (fun p most => Nat.max (f p) most) least l)%nat.
Proof. induction l; simpl; lia. Qed.

Lemma minimum_below {A} (f : A -> Z) most l x : In x l -> fold_right (fun p low => Z.min (f p) low) most l <= f x.
Proof. induction l; simpl; intros []; subst. lia. specialize (IHl H). lia. Qed.

Lemma nth_flat_map {A B} (f : A -> list B) n a d : forall l p t, (forall x, In x l -> length (f x) = n) -> (p < length l)%nat ->
  (t < n)%nat -> nth (p * n + t) (flat_map f l) d = nth t (f (nth p l a)) d.
Proof.
  induction l; intros p t H Hp Ht; simpl in Hp. lia. cbn [flat_map].
  assert (E := H a0 (or_introl eq_refl)). destruct p.
  - rewrite app_nth1 by lia. reflexivity.
  - rewrite app_nth2, E by lia. replace (S p * n + t - n)%nat with (p * n + t)%nat by lia.
    apply IHl; auto. intros; apply H; right; auto. lia.
Qed.

Lemma length_flat_map {A B} (f : A -> list B) n l : (forall x, In x l -> length (f x) = n) -> length (flat_map f l) = (length l * n)%nat.
Proof.
  induction l; intros H; auto. simpl. rewrite app_length, IHl, H; auto. left; auto. intros; apply H; right; auto.
Qed.

Lemma nth_zeros i n : nth i (repeat 0 n) 0 = 0.
Proof. revert i. induction n; destruct i; simpl; auto. Qed.

Lemma entry_zeros n rows i x : entry (repeat (repeat 0 n) rows) i x = 0.
Proof.
  unfold entry. revert i. induction rows; intros i; simpl. destruct i, x; auto.
  destruct i; auto. apply nth_zeros.
Qed.

Lemma entry_app_left (M M' : zmat) i x : (i < length M)%nat -> entry (M ++ M') i x = entry M i x.
Proof. intros H. unfold entry. rewrite app_nth1; auto. Qed.

Lemma entry_app_right (M M' : zmat) i x : (length M <= i)%nat -> entry (M ++ M') i x = entry M' (i - length M) x.
Proof. intros H. unfold entry. rewrite app_nth2; auto. Qed.

Lemma row_in_place_entry k size j row b x : length row = size -> (j < k)%nat -> (b < k)%nat -> (x < size)%nat ->
  nth (b * size + x) (row_in_place k size j row) 0 = if (b =? j)%nat then nth x row 0 else 0.
Proof.
  intros Hr Hj Hb Hx. unfold row_in_place. destruct (Nat.eqb_spec b j) as [->|N].
  - rewrite app_nth2, repeat_length by (rewrite repeat_length; lia). rewrite app_nth1 by lia. f_equal. lia.
  - destruct (Nat.lt_ge_cases b j) as [H|H].
    + rewrite app_nth1. apply nth_zeros. rewrite repeat_length. nia.
    + rewrite app_nth2, repeat_length by (rewrite repeat_length; nia). rewrite app_nth2 by nia. apply nth_zeros.
Qed.

Lemma in_place_entry k size i j M a x b y : square size M = true -> (i < k)%nat -> (j < k)%nat -> (a < k)%nat -> (b < k)%nat ->
  (x < size)%nat -> (y < size)%nat ->
  entry (in_place k size i j M) (a * size + x) (b * size + y) = if ((a =? i) && (b =? j))%nat then entry M x y else 0.
Proof.
  intros HM Hi Hj Ha Hb Hx Hy. apply square_spec in HM. destruct HM as [HM Hrow]. unfold in_place. unfold zmat, zvec in *.
  destruct (Nat.eqb_spec a i) as [->|N]; simpl andb.
  - rewrite entry_app_right, repeat_length by (rewrite repeat_length; lia). replace (i * size + x - i * size)%nat with x by lia.
    rewrite entry_app_left by (rewrite map_length; lia).
    unfold entry. rewrite nth_indep with (d' := row_in_place k size j []) by (rewrite map_length; lia).
    rewrite map_nth. apply row_in_place_entry; auto. apply Hrow, nth_In.
    change (x < @length (list Z) M)%nat. lia.
  - destruct (Nat.lt_ge_cases a i) as [H|H].
    + rewrite entry_app_left. apply entry_zeros. rewrite repeat_length. nia.
    + rewrite entry_app_right by (rewrite repeat_length; nia). rewrite entry_app_right by (rewrite map_length, repeat_length; nia).
      apply entry_zeros.
Qed.

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

Lemma sum_block k size b (f : nat -> R) : (b < k)%nat ->
  (forall a x, (a < k)%nat -> a <> b -> (x < size)%nat -> f (a * size + x)%nat = 0%R) ->
  sum (k * size) f = sum size (fun x => f (b * size + x)%nat).
Proof.
  intros Hb H. rewrite sum_blocks.
  rewrite (sum_ext k _ (fun a => (identity a b * sum size (fun x => f (a * size + x)%nat))%R)).
  - apply sum_identity. auto.
  - intros a Ha. unfold identity. destruct (Nat.eqb_spec a b). lra. rewrite sum_zero. lra. intros x Hx. apply H; auto.
Qed.

Lemma pair_below pairs e : In e pairs -> (fst e < states pairs)%nat /\ (snd e < states pairs)%nat.
Proof.
  unfold states. induction pairs as [|p pairs IH]; intros []; cbn [fold_right]; subst. lia. specialize (IH H). lia.
Qed.

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

Lemma symbols_length : length (level_symbols m M) = length (each m).
Proof. unfold level_symbols. apply map_length. Qed.

(* The letter of digit t of mask number i, in the family of all sequences *)
Lemma any_entry i t j k : (i < length (each m))%nat -> (t < A)%nat -> (j < W)%nat -> (k < W)%nat ->
  real (any_family m M) (i * A + t) j k = scheme_matrix A (symbol_number m M i) t j k.
Proof.
  intros Hi Ht Hj Hk. unfold symbol_number. rewrite <- (transition_entry A W _ (masks_common m)) by auto.
  unfold real, mr, letter. cbn [any_family matrices denominator]. fold A W.
  rewrite (nth_flat_map (transition A W) A []); auto. intros; apply transition_length. rewrite symbols_length. auto.
Qed.

Lemma any_count : count (any_family m M) = (length (each m) * A)%nat.
Proof.
  unfold count. cbn [any_family matrices]. fold A W. rewrite (length_flat_map _ A), symbols_length; auto. intros; apply transition_length.
Qed.

Lemma any_product w : letters A w -> forall i, (forall k, (i k < length (each m))%nat) -> exists v,
  letters (count (any_family m M)) v /\ length v = length w /\ forall p q, (p < W)%nat -> (q < W)%nat ->
  level_product A W (fun k => symbol_number m M (i k)) w p q = product W (real (any_family m M)) v p q.
Proof.
  induction w as [|t w IH]; intros Hw i Hi. { exists []. repeat split. constructor. }
  inversion Hw as [|? ? Ht Hw']; subst. destruct (IH Hw' (fun k => i (S k)) (fun k => Hi (S k))) as [v [Hv [Hl E]]].
  exists ((i O * A + t)%nat :: v). split; [|split].
  - constructor; auto. rewrite any_count. specialize (Hi O). nia.
  - simpl. auto.
  - intros p q Hp Hq. cbn [level_product product]. unfold times. apply sum_ext; intros l Hl'. rewrite any_entry by auto.
    f_equal. apply E; auto.
Qed.

(* The letter of digit t of pair number e, in the family along pairs *)
Variable pairs : list (nat * nat).
Let K := states pairs.

Lemma follows_entry e t a b j k : (e < length pairs)%nat -> (t < A)%nat -> (a < K)%nat -> (b < K)%nat -> (j < W)%nat -> (k < W)%nat ->
  (snd (nth e pairs (O, O)) < length (each m))%nat ->
  real (follows_family m M pairs) (e * A + t)%nat (a * W + j)%nat (b * W + k)%nat =
  if ((a =? fst (nth e pairs (O, O))) && (b =? snd (nth e pairs (O, O))))%nat
  then scheme_matrix A (symbol_number m M (snd (nth e pairs (O, O)))) t j k else 0%R.
Proof.
  intros He Ht Ha Hb Hj Hk Hi. set (p := nth e pairs (O, O)) in *.
  destruct (pair_below pairs p (nth_In _ _ He)) as [K1 K2].
  unfold symbol_number. rewrite <- (transition_entry A W _ (masks_common m)) by auto.
  unfold real, mr, letter. cbn [follows_family matrices denominator]. fold A W K.
  rewrite (nth_flat_map (fun e => map (in_place K W (fst e) (snd e)) (transition A W (nth (snd e) (level_symbols m M) []))) A (O, O));
    auto; [|intros; rewrite map_length; apply transition_length].
  fold p. rewrite nth_indep with (d' := in_place K W (fst p) (snd p) []) by (rewrite map_length, transition_length; auto).
  rewrite map_nth, in_place_entry; auto.
  - destruct ((a =? fst p) && (b =? snd p))%nat; auto. unfold Rdiv. lra.
  - apply (transition_square (nth (snd p) (level_symbols m M) [])). apply nth_In. rewrite transition_length. auto.
Qed.

Lemma follows_count : count (follows_family m M pairs) = (length pairs * A)%nat.
Proof.
  unfold count. cbn [follows_family matrices]. fold A W. rewrite (length_flat_map _ A); auto.
  intros; rewrite map_length; apply transition_length.
Qed.

Hypothesis Known : forall e, In e pairs -> (snd e < length (each m))%nat.

(* Along the pairs the block of the first and the last number is the product of the matrices of all masks but the first. *)
Lemma follows_product w : letters A w -> forall i, (forall k, In (i k, i (S k)) pairs) -> exists v,
  letters (count (follows_family m M pairs)) v /\ length v = length w /\ forall p q, (p < W)%nat -> (q < W)%nat ->
  level_product A W (fun k => symbol_number m M (i (S k))) w p q =
  product (K * W) (real (follows_family m M pairs)) v (i O * W + p)%nat (i (length w) * W + q)%nat.
Proof.
  induction w as [|t w IH]; intros Hw i Hi.
  - exists []. split; [constructor|split; auto]. intros p q Hp Hq. cbn [level_product product length]. unfold identity.
    destruct (Nat.eqb_spec p q), (Nat.eqb_spec (i O * W + p)%nat (i O * W + q)%nat); auto; lia.
  - inversion Hw as [|? ? Ht Hw']; subst. destruct (IH Hw' (fun k => i (S k)) (fun k => Hi (S k))) as [v [Hv [Hl E]]].
    destruct (In_nth _ _ (O, O) (Hi O)) as [e [He Ee]].
    exists ((e * A + t)%nat :: v). split; [|split].
    + constructor; auto. rewrite follows_count. nia.
    + simpl. auto.
    + intros p q Hp Hq. cbn [level_product product length]. unfold times.
      destruct (pair_below pairs _ (Hi O)) as [K0 K1]. cbn [fst snd] in K0, K1.
      assert (Kn := Known _ (Hi O)). cbn [snd] in Kn.
      rewrite (sum_block K W (i 1%nat)); auto.
      * apply sum_ext; intros l Hl'. rewrite follows_entry, Ee by (rewrite ?Ee; auto). cbn [fst snd].
        rewrite !Nat.eqb_refl. cbn [andb]. f_equal. apply E; auto.
      * intros a x Ha N Hx. rewrite follows_entry, Ee by (rewrite ?Ee; auto). cbn [fst snd].
        destruct (Nat.eqb_spec a (i 1%nat)); [lia|]. rewrite andb_false_r. lra.
Qed.
End Families.

(* ---- the theorems -------------------------------------------------------------------------------------------------------- *)

Theorem levels_of_radius m s l order u : levels_reduce m s l order u = true -> let T := levels_family m s order in
  radius_at_most (size T) (count T) (real T) (real_of u) -> levels_hold m s l.
Proof.
  intros H T HR i Hi. unfold levels_reduce in H. rewrite !andb_true_iff in H. destruct H as [[[HA HM] HB] HS].
  apply Nat.leb_le in HA. rewrite forallb_forall in HM. set (A := masks_arity m) in *. set (W := level_size m order).
  destruct (exp_onto (INR A) (arity_positive A HA)) as [lambda Hlog].
  apply (below_power_sound lambda) in HB; auto. destruct HB as [Hl HU].
  assert (Hn : forall k, (i k < length (each m))%nat).
  { intros k. destruct s; cbn [allowed] in Hi; auto. rewrite forallb_forall in HS. specialize (HS _ (Hi k)).
    apply andb_prop in HS. destruct HS as [HS _]. apply Nat.ltb_lt in HS. auto. }
  apply (sequence_exponent m order HM HA lambda i (real_of u) (real_of l)); auto.
  intros g Hg H0. destruct (HR g Hg H0) as [C HC]. destruct s as [|pairs]; cbn [allowed] in Hi; unfold T in *; cbn [levels_family] in *.
  - exists C. intros w Hw p q Hp Hq. destruct (any_product m order w Hw i Hn) as [v [Hv [Hlen E]]].
    fold A W in E. rewrite E by auto. rewrite <- Hlen. apply HC; auto.
  - rewrite forallb_forall in HS.
    assert (Kn : forall e, In e pairs -> (snd e < length (each m))%nat).
    { intros e He. specialize (HS e He). apply andb_prop in HS. destruct HS as [_ HS]. apply Nat.ltb_lt; auto. }
    destruct (symbols_bounded m order HA) as [P [P0 HP]].
    assert (C0 : (0 <= Rmax C 0)%R) by apply Rmax_r.
    exists (1 + INR W * (P * (Rmax C 0 / g)))%R. intros w Hw p q Hp Hq.
    assert (Q0 : (0 <= P * (Rmax C 0 / g))%R).
    { apply Rmult_le_pos; auto. apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
    assert (R0 : (0 <= INR W * (P * (Rmax C 0 / g)))%R) by (apply Rmult_le_pos; auto; apply pos_INR).
    destruct w as [|t w].
    + cbn [level_product length pow]. unfold identity. destruct (Nat.eqb p q); [rewrite Rabs_R1|rewrite Rabs_R0]; lra.
    + inversion Hw as [|? ? Ht Hw']; subst. destruct (follows_product m order pairs Kn w Hw' i Hi) as [v [Hv [Hlen E]]].
      fold A W in E. cbn [level_product length]. unfold times.
      assert (PG : (0 < g ^ length w)%R) by (apply pow_lt; auto).
      eapply Rle_trans. apply sum_abs.
      apply Rle_trans with (INR W * (P * (Rmax C 0 * g ^ length w)))%R.
      * apply sum_bound. intros x Hx. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos. apply HP; auto.
        unfold later. rewrite E by auto. eapply Rle_trans. apply HC; auto.
        -- destruct (pair_below pairs _ (Hi O)) as [K0 _]. cbn [fst follows_family size] in *. fold W. nia.
        -- destruct (pair_below pairs _ (Hi (length w))) as [K0 _]. cbn [fst follows_family size] in *. fold W. nia.
        -- rewrite Hlen. apply Rmult_le_compat_r. lra. apply Rmax_l.
      * rewrite <- tech_pow_Rmult. replace (INR W * (P * (Rmax C 0 * g ^ length w)))%R with
          (INR W * (P * (Rmax C 0 / g)) * (g * g ^ length w))%R by (field; lra).
        apply Rmult_le_compat_r. apply Rmult_le_pos; lra. lra.
Qed.

(* What the checker accepts is true. *)
Theorem check_levels_sound m s l cert : check_levels m s l cert = true -> levels_hold m s l.
Proof.
  intros H. apply andb_prop in H. destruct H as [H1 H2]. apply (levels_of_radius m s l (order cert) (bound cert) H1).
  apply radius_bounded, (check_radius_sound _ _ H2).
Qed.

(* There is one limit for each sequence, and its exponent as a number, if it is one, is at least l. *)
Corollary exponent_of_sequence m s l : (2 <= masks_arity m)%nat -> levels_hold m s l -> forall i, allowed m s i ->
  forall phi t, limit_of_sequence m i phi -> is_lub (exponents phi) t -> (real_of l <= t)%R.
Proof.
  intros HA H i Hi phi t Lim [U _]. destruct (H i Hi) as [psi [Lim' Hx]]. replace phi with psi in *.
  - apply le_epsilon. intros eps He. destruct (Hx (real_of l - eps)%R ltac:(lra)) as [x [Hs Hl]]. specialize (U x Hs). lra.
  - extensionality x. eapply levels_unique; eauto.
Qed.
