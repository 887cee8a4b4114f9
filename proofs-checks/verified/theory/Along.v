(* Sequences of numbers, one for each level, and the family of the products of what belongs to them: to each number one matrix for
   each digit (SPEC.md, sections 6.5 and 6.12, Theorems 50 and 73). *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Subcert Require Import Radius Integers Sections Subdivision.
Import ListNotations.
Open Scope Z_scope.

(* All sequences of numbers below n, or those in which each pair of neighbours is one of these *)
Inductive sequences := Any | Follows (pairs : list (nat * nat)).
Definition allowed (n : nat) (s : sequences) (i : nat -> nat) : Prop :=
  match s with
  | Any => forall k, (i k < n)%nat
  | Follows pairs => forall k, In (i k, i (S k)) pairs
  end.

(* ---- families ------------------------------------------------------------------------------------------------------------ *)

(* `each` has the matrices of each number, one for each digit, over one denominator: those of the first number, then those of the
   second one, and so on *)
Definition any_of (size : nat) (denominator : Z) (each : list (list zmat)) : family := Family size denominator (flat_map (fun Ms => Ms) each).

(* A matrix as the block of row i and column j of a matrix of k times k blocks, the others of which are 0 *)
Definition row_in_place (k size j : nat) (row : list Z) : list Z := repeat 0 (j * size) ++ row ++ repeat 0 ((k - 1 - j) * size).
Definition in_place (k size i j : nat) (M : zmat) : zmat :=
  repeat (repeat 0 (k * size)) (i * size) ++ map (row_in_place k size j) M ++ repeat (repeat 0 (k * size)) ((k - 1 - i) * size).

(* Pair by pair the matrices of its second number *)
Definition states (pairs : list (nat * nat)) : nat := S (fold_right (fun e most => Nat.max (fst e) (Nat.max (snd e) most)) O pairs).
Definition follows_of (size : nat) (denominator : Z) (each : list (list zmat)) (pairs : list (nat * nat)) : family :=
  let k := states pairs in
  Family (k * size) denominator (flat_map (fun e => map (in_place k size (fst e) (snd e)) (nth (snd e) each [])) pairs).

Definition along (s : sequences) (size : nat) (denominator : Z) (each : list (list zmat)) : family :=
  match s with Any => any_of size denominator each | Follows pairs => follows_of size denominator each pairs end.

(* The second numbers of pairs are numbers below n, and the first ones. *)
Definition known (n : nat) (s : sequences) : bool :=
  match s with Any => true | Follows pairs => forallb (fun e => (fst e <? n) && (snd e <? n))%nat pairs end.

(* ---- lists --------------------------------------------------------------------------------------------------------------- *)

Lemma maximum_above {A} (f : A -> nat) least l x : In x l -> (f x <= fold_right (fun p most => Nat.max (f p) most) least l)%nat.
Proof. induction l; simpl; intros []; subst. lia. specialize (IHl H). lia. Qed.

Lemma maximum_least {A} (f : A -> nat) least l : (least <= fold_right (fun p most => Nat.max (f p) most) least l)%nat.
Proof. induction l; simpl; lia. Qed.

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

(* ---- products ------------------------------------------------------------------------------------------------------------ *)

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

(* Of matrices for each level and digit, the product of a word, with the first level on the left *)
Fixpoint level_word (n : nat) (T : nat -> nat -> mat) (w : list nat) : mat :=
  match w with [] => identity | t :: w' => times n (T O t) (level_word n (fun k => T (S k)) w') end.

Lemma level_word_scaled n z w : forall T i j, level_word n (fun k t i j => z * T k t i j)%R w i j = (z ^ length w * level_word n T w i j)%R.
Proof.
  induction w as [|t w IH]; intros T i j; cbn [level_word length pow]. lra.
  unfold times. rewrite <- sum_scal. apply sum_ext; intros k Hk. rewrite (IH (fun k => T (S k))). ring.
Qed.

Section Along.
Variables (A W : nat) (e : Z) (each : list (list zmat)).
Hypothesis Digits : forall Ms, In Ms each -> length Ms = A.
Hypothesis Squares : forall Ms M, In Ms each -> In M Ms -> square W M = true.
Let n := length each.

(* The matrix of number i and digit t *)
Definition matrix_of (i t : nat) : mat := real (Family W e (nth i each [])) t.
Notation word_along i w := (level_word W (fun k => matrix_of (i k)) w).

Lemma digits_of i : (i < n)%nat -> length (nth i each []) = A.
Proof. intros H. apply Digits, nth_In. auto. Qed.

Lemma any_entry i t j k : (i < n)%nat -> (t < A)%nat -> real (any_of W e each) (i * A + t) j k = matrix_of i t j k.
Proof.
  intros Hi Ht. unfold matrix_of, real, mr, letter. cbn [any_of matrices denominator].
  rewrite (nth_flat_map (fun Ms => Ms) A []); auto.
Qed.

Lemma any_count : count (any_of W e each) = (n * A)%nat.
Proof. unfold count. cbn [any_of matrices]. apply (length_flat_map (fun Ms => Ms)). auto. Qed.

Lemma any_product w : letters A w -> forall i, (forall k, (i k < n)%nat) -> exists v,
  letters (count (any_of W e each)) v /\ length v = length w /\ forall p q, (p < W)%nat -> (q < W)%nat ->
  word_along i w p q = product W (real (any_of W e each)) v p q.
Proof.
  induction w as [|t w IH]; intros Hw i Hi. { exists []. repeat split. constructor. }
  inversion Hw as [|? ? Ht Hw']; subst. destruct (IH Hw' (fun k => i (S k)) (fun k => Hi (S k))) as [v [Hv [Hl E]]].
  exists ((i O * A + t)%nat :: v). split; [|split].
  - constructor; auto. rewrite any_count. specialize (Hi O). nia.
  - simpl. auto.
  - intros p q Hp Hq. cbn [level_word product]. unfold times. apply sum_ext; intros l Hl'. rewrite any_entry by auto.
    f_equal. apply E; auto.
Qed.

(* The letter of digit t of pair number x, in the family along pairs *)
Variable pairs : list (nat * nat).
Let K := states pairs.
Let T := follows_of W e each pairs.
Hypothesis Known : forall p, In p pairs -> (snd p < n)%nat.

Lemma pair_matrices p : In p pairs -> length (map (in_place K W (fst p) (snd p)) (nth (snd p) each [])) = A.
Proof. intros H. rewrite map_length. apply digits_of. apply Known. auto. Qed.

Lemma follows_entry x t a b j k : (x < length pairs)%nat -> (t < A)%nat -> (a < K)%nat -> (b < K)%nat -> (j < W)%nat -> (k < W)%nat ->
  real T (x * A + t)%nat (a * W + j)%nat (b * W + k)%nat = if ((a =? fst (nth x pairs (O, O))) && (b =? snd (nth x pairs (O, O))))%nat
  then matrix_of (snd (nth x pairs (O, O))) t j k else 0%R.
Proof.
  intros Hx Ht Ha Hb Hj Hk. assert (I := nth_In pairs (O, O) Hx). set (p := nth x pairs (O, O)) in *.
  destruct (pair_below pairs p I) as [K1 K2]. assert (Kn := Known p I).
  unfold matrix_of, real, mr, letter, T. cbn [follows_of matrices denominator]. fold K.
  rewrite (nth_flat_map (fun p => map (in_place K W (fst p) (snd p)) (nth (snd p) each [])) A (O, O)) by (auto using pair_matrices).
  fold p. rewrite nth_indep with (d' := in_place K W (fst p) (snd p) []) by (rewrite pair_matrices; auto).
  rewrite map_nth, in_place_entry; auto.
  - destruct ((a =? fst p) && (b =? snd p))%nat; auto. unfold Rdiv. lra.
  - apply (Squares (nth (snd p) each [])); apply nth_In; auto. rewrite digits_of; auto.
Qed.

Lemma follows_count : count T = (length pairs * A)%nat.
Proof. unfold count, T. cbn [follows_of matrices]. apply length_flat_map. intros; apply pair_matrices; auto. Qed.

(* Along the pairs the block of the first and the last number is the product of the matrices of all numbers but the first. *)
Lemma follows_product w : letters A w -> forall i, (forall k, In (i k, i (S k)) pairs) -> exists v,
  letters (count T) v /\ length v = length w /\ forall p q, (p < W)%nat -> (q < W)%nat ->
  word_along (fun k => i (S k)) w p q = product (K * W) (real T) v (i O * W + p)%nat (i (length w) * W + q)%nat.
Proof.
  induction w as [|t w IH]; intros Hw i Hi.
  - exists []. split; [constructor|split; auto]. intros p q Hp Hq. cbn [level_word product length]. unfold identity.
    destruct (Nat.eqb_spec p q), (Nat.eqb_spec (i O * W + p)%nat (i O * W + q)%nat); auto; lia.
  - inversion Hw as [|? ? Ht Hw']; subst. destruct (IH Hw' (fun k => i (S k)) (fun k => Hi (S k))) as [v [Hv [Hl E]]].
    destruct (In_nth _ _ (O, O) (Hi O)) as [x [Hx Ex]].
    exists ((x * A + t)%nat :: v). split; [|split].
    + constructor; auto. rewrite follows_count. nia.
    + simpl. auto.
    + intros p q Hp Hq. cbn [level_word product length]. unfold times.
      destruct (pair_below pairs _ (Hi O)) as [K0 K1]. cbn [fst snd] in K0, K1.
      rewrite (sum_block K W (i 1%nat)); auto.
      * apply sum_ext; intros l Hl'. rewrite follows_entry, Ex by auto. cbn [fst snd].
        rewrite !Nat.eqb_refl. cbn [andb]. f_equal. apply E; auto.
      * intros a y Ha N Hy. rewrite follows_entry, Ex by auto. cbn [fst snd].
        destruct (Nat.eqb_spec a (i 1%nat)); [lia|]. rewrite andb_false_r. lra.
Qed.
End Along.

(* A bound of all matrices of finitely many numbers *)
Lemma matrices_bounded W e each : exists P, (0 <= P)%R /\ forall i t j k, (t < length (nth i each []))%nat -> (j < W)%nat -> (k < W)%nat ->
  (Rabs (matrix_of W e each i t j k) <= P)%R.
Proof.
  assert (B : forall l : list zmat, exists P, (0 <= P)%R /\ forall t j k, (t < length l)%nat -> (j < W)%nat -> (k < W)%nat -> (Rabs (real (Family W e l) t j k) <= P)%R).
  { intros l. exists (sum (length l) (fun t => sum W (fun j => sum W (fun k => Rabs (real (Family W e l) t j k))))). split.
    - apply sum_nonneg; intros. apply sum_nonneg; intros. apply sum_nonneg; intros. apply Rabs_pos.
    - intros t j k Ht Hj Hk.
      eapply Rle_trans; [|apply (sum_term (length l) (fun t => sum W (fun j => sum W (fun k => Rabs (real (Family W e l) t j k)))) t); auto].
      2: { intros. apply sum_nonneg; intros. apply sum_nonneg; intros. apply Rabs_pos. }
      eapply Rle_trans; [|apply (sum_term W (fun j => sum W (fun k => Rabs (real (Family W e l) t j k))) j); auto].
      2: { intros. apply sum_nonneg; intros. apply Rabs_pos. }
      apply (sum_term W (fun k => Rabs (real (Family W e l) t j k)) k); auto. intros. apply Rabs_pos. }
  unfold matrix_of. induction each as [|l each [P [P0 HP]]].
  - exists 0%R. split. lra. intros i t j k Ht. destruct i; simpl in Ht; lia.
  - destruct (B l) as [Q [Q0 HQ]]. exists (P + Q)%R. split. lra. intros [|i] t j k Ht Hj Hk; cbn [nth] in *.
    + specialize (HQ t j k Ht Hj Hk). lra.
    + specialize (HP i t j k Ht Hj Hk). lra.
Qed.

(* Products along each of the sequences grow as the radius of the family says. *)
Theorem along_growth s A W e each u : (forall Ms, In Ms each -> length Ms = A) -> (forall Ms M, In Ms each -> In M Ms -> square W M = true) ->
  known (length each) s = true -> let T := along s W e each in radius_at_most (size T) (count T) (real T) u ->
  forall i, allowed (length each) s i -> (forall k, (i k < length each)%nat) /\
  forall g, (u < g)%R -> (0 < g)%R -> exists C, forall w, letters A w -> forall p q, (p < W)%nat -> (q < W)%nat ->
  (Rabs (level_word W (fun k => matrix_of W e each (i k)) w p q) <= C * g ^ length w)%R.
Proof.
  intros HA HS HK T HR i Hi.
  assert (Kn : forall pairs, s = Follows pairs -> forall p, In p pairs -> (fst p < length each)%nat /\ (snd p < length each)%nat).
  { intros pairs -> p Hp. cbn [known] in HK. rewrite forallb_forall in HK. specialize (HK p Hp). apply andb_prop in HK.
    destruct HK as [K1 K2]. apply Nat.ltb_lt in K1, K2. auto. }
  assert (Hn : forall k, (i k < length each)%nat).
  { intros k. destruct s; cbn [allowed] in Hi; auto. apply (Kn _ eq_refl _ (Hi k)). }
  split; auto. intros g Hg H0. destruct (HR g Hg H0) as [C HC]. destruct s as [|pairs]; cbn [allowed] in Hi; unfold T in *; cbn [along] in *.
  - exists C. intros w Hw p q Hp Hq. destruct (any_product A W e each HA w Hw i Hn) as [v [Hv [Hlen E]]].
    rewrite E by auto. rewrite <- Hlen. apply HC; auto.
  - destruct (matrices_bounded W e each) as [P [P0 HP]]. assert (C0 : (0 <= Rmax C 0)%R) by apply Rmax_r.
    exists (1 + INR W * (P * (Rmax C 0 / g)))%R. intros w Hw p q Hp Hq.
    assert (Q0 : (0 <= P * (Rmax C 0 / g))%R).
    { apply Rmult_le_pos; auto. apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
    assert (R0 : (0 <= INR W * (P * (Rmax C 0 / g)))%R) by (apply Rmult_le_pos; auto; apply pos_INR).
    destruct w as [|t w].
    + cbn [level_word length pow]. unfold identity. destruct (Nat.eqb p q); [rewrite Rabs_R1|rewrite Rabs_R0]; lra.
    + inversion Hw as [|? ? Ht Hw']; subst.
      destruct (follows_product A W e each HA HS pairs (fun p H => proj2 (Kn pairs eq_refl p H)) w Hw' i Hi) as [v [Hv [Hlen E]]].
      cbn [level_word length]. unfold times. assert (PG : (0 < g ^ length w)%R) by (apply pow_lt; auto).
      eapply Rle_trans. apply sum_abs.
      apply Rle_trans with (INR W * (P * (Rmax C 0 * g ^ length w)))%R.
      * apply sum_bound. intros x Hx. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos.
        { apply HP; auto. rewrite (digits_of A each HA); auto. }
        rewrite E by auto. eapply Rle_trans. apply HC; auto.
        -- destruct (pair_below pairs _ (Hi O)) as [K0 _]. cbn [fst follows_of size] in *. nia.
        -- destruct (pair_below pairs _ (Hi (length w))) as [K0 _]. cbn [fst follows_of size] in *. nia.
        -- rewrite Hlen. apply Rmult_le_compat_r. lra. apply Rmax_l.
      * rewrite <- tech_pow_Rmult. replace (INR W * (P * (Rmax C 0 * g ^ length w)))%R with
          (INR W * (P * (Rmax C 0 / g)) * (g * g ^ length w))%R by (field; lra).
        apply Rmult_le_compat_r. apply Rmult_le_pos; lra. lra.
Qed.
