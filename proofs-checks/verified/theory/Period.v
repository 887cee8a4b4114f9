(* Masks in turn: so many levels are one step of a scheme of a larger arity, whose mask is their product; if that scheme
   converges, all levels do, to the same limit (SPEC.md, section 6.5, `period`). *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Integers Sections Subdivision Coefficients Exponent Smooth Rough Levels.
Import ListNotations.
Open Scope Z_scope.

(* ---- the product of the masks ------------------------------------------------------------------------------------------ *)

(* symbol(z) factor(z^step) *)
Fixpoint spread_times (step : nat) (symbol factor : list Z) : list Z :=
  match factor with
  | [] => []
  | [c] => map (Z.mul c) symbol
  | c :: rest => addmul c symbol (repeat 0 step ++ spread_times step symbol rest)
  end.

(* A step of the mask p after one of the scheme a, as one step *)
Definition then_mask (m : masks) (a : scheme) (p : Z * list Z) : scheme :=
  Scheme (masks_arity m * arity a) (fst p + Z.of_nat (masks_arity m) * first a)
    (spread_times (masks_arity m) (snd p) (coefficients a)) (masks_common m * common a).

(* The masks number i, and those of the list after it, as one step *)
Definition period_scheme (m : masks) (i : nat) (others : list nat) : scheme :=
  fold_left (fun a j => then_mask m a (nth j (each m) no_mask)) others (scheme_of m (nth i (each m) no_mask)).

(* The sequence that repeats them *)
Definition in_turn (i : nat) (others : list nat) (k : nat) : nat := nth (k mod S (length others)) (i :: others) O.

(* All masks keep constant data: the coefficients of each residue class sum to 1. *)
Definition keeps_constants (m : masks) : bool :=
  (2 <=? masks_arity m)%nat && (0 <? masks_common m) &&
  forallb (fun p => forallb (fun r => class_sum (masks_arity m) (snd p) r =? masks_common m) (seq 0 (masks_arity m))) (each m).

Definition in_period (m : masks) (i : nat) (others : list nat) : bool :=
  keeps_constants m && forallb (fun j => j <? length (each m))%nat (i :: others) &&
  forallb (fun p => negb (length (snd p) =? 0))%nat (each m).

(* ---- coefficients of products -------------------------------------------------------------------------------------------- *)

Lemma coefficient_add c x y e F i : coefficient (addmul c x y) e F i = (IZR c * coefficient x e F i + coefficient y e F i)%R.
Proof.
  unfold coefficient. destruct (Z.ltb_spec i F). lra.
  assert (E := f_equal (fun f => f (Z.to_nat (i - F))) (vr_addmul c x y)). unfold vr, plus, scal in E. rewrite E. unfold Rdiv. lra.
Qed.

Lemma coefficient_behind n r e F i : coefficient (repeat 0 n ++ r) e F i = coefficient r e (F + Z.of_nat n) i.
Proof.
  unfold coefficient. destruct (Z.ltb_spec i F), (Z.ltb_spec i (F + Z.of_nat n)); auto; try lia.
  - rewrite app_nth1 by (rewrite repeat_length; lia). rewrite nth_zeros. unfold Rdiv. lra.
  - rewrite app_nth2, repeat_length by (rewrite repeat_length; lia). f_equal. f_equal. f_equal. lia.
Qed.

Lemma coefficient_over d x e F i : d <> 0 -> e <> 0 -> coefficient x (e * d) F i = (coefficient x e F i / IZR d)%R.
Proof.
  intros Hd He. unfold coefficient. destruct (i <? F). unfold Rdiv. lra. rewrite mult_IZR. field.
  split; apply IZR_neq; auto.
Qed.

Lemma coefficient_cons c r e F i : coefficient (c :: r) e F i = (IZR c / IZR e * delta (i - F) + coefficient r e (F + 1) i)%R.
Proof.
  unfold coefficient, delta. destruct (Z.ltb_spec i F), (Z.ltb_spec i (F + 1)), (Z.eqb_spec (i - F) 0); try lia; try lra.
  - replace (Z.to_nat (i - F)) with O by lia. simpl. lra.
  - replace (Z.to_nat (i - F)) with (S (Z.to_nat (i - (F + 1)))) by lia. simpl nth. lra.
Qed.

(* A step does not depend on the window in which the mask is looked at. *)
Lemma subdivide_same A F L F' L' a f i : (2 <= A)%nat -> supported F L a -> supported F' L' a ->
  subdivide A F L a f i = subdivide A F' L' a f i.
Proof.
  intros HA S S'. unfold subdivide. apply (sum_two_windows (fun j => (a (i - Z.of_nat A * j)%Z * f j)%R)); intros j Hj.
  - rewrite (all_terms A F L HA L) by auto. lra.
  - rewrite (all_terms A F' L' HA L') by auto. lra.
Qed.

Lemma spread_times_coefficient A symbol e d F : (2 <= A)%nat -> e <> 0 -> d <> 0 -> forall factor F' i,
  coefficient (spread_times A symbol factor) (e * d) (F + Z.of_nat A * F') i =
  subdivide A F (length symbol - 1) (coefficient symbol e F) (coefficient factor d F') i.
Proof.
  intros HA He Hd. set (L := (length symbol - 1)%nat). assert (S := coefficient_supported symbol e F). fold L in S.
  assert (Point : forall c F' i, coefficient (map (Z.mul c) symbol) (e * d) (F + Z.of_nat A * F') i =
    subdivide A F L (coefficient symbol e F) (fun j => IZR c / IZR d * delta (j - F'))%R i).
  { intros c F' i. rewrite subdivide_scal, (subdivide_shift A F L HA), (subdivide_point A F L HA) by auto.
    rewrite coefficient_map, coefficient_over by auto. rewrite (coefficient_shift symbol e (F + Z.of_nat A * F')), (coefficient_shift symbol e F).
    replace (i - Z.of_nat A * F' - F) with (i - (F + Z.of_nat A * F')) by ring. unfold Rdiv. ring. }
  assert (Zero : forall F' i, subdivide A F L (coefficient symbol e F) (coefficient [] d F') i = 0%R).
  { intros F' i. unfold subdivide. apply sum_zero. intros. cbv zeta. unfold coefficient at 2. destruct (_ <? F'). lra.
    rewrite nth_nil. unfold Rdiv. lra. }
  induction factor as [|c rest IH]; intros F' i.
  - rewrite Zero. unfold coefficient. destruct (i <? _); auto. simpl. rewrite nth_nil. unfold Rdiv. lra.
  - rewrite (subdivide_ext A F L _ _ _ i (coefficient_cons c rest d F')).
    assert (Split : forall g h, subdivide A F L (coefficient symbol e F) (fun j => g j + h j)%R i =
      (subdivide A F L (coefficient symbol e F) g i + subdivide A F L (coefficient symbol e F) h i)%R).
    { intros g h. unfold subdivide. rewrite <- sum_plus. apply sum_ext; intros. cbv zeta. lra. }
    rewrite Split, <- Point. destruct rest as [|c' rest].
    + rewrite Zero. cbn [spread_times]. lra.
    + change (spread_times A symbol (c :: c' :: rest)) with (addmul c symbol (repeat 0 A ++ spread_times A symbol (c' :: rest))).
      rewrite coefficient_add, coefficient_behind. replace (F + Z.of_nat A * F' + Z.of_nat A) with (F + Z.of_nat A * (F' + 1)) by ring.
      rewrite IH, coefficient_map. reflexivity.
Qed.

(* ---- two steps in one ------------------------------------------------------------------------------------------------------ *)

Theorem two_steps A B F L F' L' FC LC a a' f n : (2 <= A)%nat -> (2 <= B)%nat -> supported F L a -> supported F' L' a' ->
  let c := subdivide A F L a a' in supported FC LC c ->
  subdivide (A * B) FC LC c f n = subdivide A F L a (fun i => subdivide B F' L' a' f i) n.
Proof.
  intros HA HB S S' c SC. set (q := (n - F) / Z.of_nat A). set (R := (Z.to_nat (Z.abs q + Z.abs F') + L + L' + 2)%nat).
  set (lo := - Z.of_nat R). set (w := (2 * R + 1)%nat).
  set (I := fun k : nat => q - Z.of_nat L + Z.of_nat k).
  assert (Out : forall k j, (k < Datatypes.S L)%nat -> j < lo \/ lo + Z.of_nat w <= j -> a' (I k - Z.of_nat B * j) = 0%R).
  { intros k j Hk Hj. apply S'. unfold I, lo, w, R in *. nia. }
  assert (E : forall k, (k < Datatypes.S L)%nat -> subdivide B F' L' a' f (I k) =
    sum w (fun m => a' (I k - Z.of_nat B * (lo + Z.of_nat m)) * f (lo + Z.of_nat m))%R).
  { intros k Hk. symmetry. apply (subdivide_window B F' L' HB L' a' f (I k) lo w S' (le_n L')). intros j Hj. apply Out; auto. }
  assert (C : forall j, c (n - Z.of_nat (A * B) * j) = sum (Datatypes.S L) (fun k => a (n - Z.of_nat A * I k) * a' (I k - Z.of_nat B * j))%R).
  { intros j. unfold c. replace (n - Z.of_nat (A * B) * j) with (n - Z.of_nat A * (Z.of_nat B * j)) by (rewrite Nat2Z.inj_mul; ring).
    rewrite <- (subdivide_shift A F L HA). reflexivity. }
  assert (HAB : (2 <= A * B)%nat) by nia.
  rewrite <- (subdivide_window (A * B) FC LC HAB LC c f n lo w SC (le_n LC)).
  - rewrite (sum_ext w _ (fun m => sum (Datatypes.S L) (fun k => a (n - Z.of_nat A * I k) *
      (a' (I k - Z.of_nat B * (lo + Z.of_nat m)) * f (lo + Z.of_nat m)%Z)))%R).
    + rewrite sum_swap. change (subdivide A F L a (fun i => subdivide B F' L' a' f i) n) with
        (sum (Datatypes.S L) (fun k => a (n - Z.of_nat A * I k) * subdivide B F' L' a' f (I k)))%R.
      apply sum_ext; intros k Hk. rewrite sum_scal, E by auto. reflexivity.
    + intros m Hm. rewrite C, Rmult_comm, <- sum_scal. apply sum_ext; intros k Hk. ring.
  - intros j Hj. rewrite C. apply sum_zero. intros k Hk. rewrite Out by auto. lra.
Qed.

(* ---- a period --------------------------------------------------------------------------------------------------------------- *)

Section Period.
Variables (m : masks) (i : nat) (others : list nat).
Hypothesis Good : in_period m i others = true.
Let A := masks_arity m.
Let d := masks_common m.
Let turn := i :: others.

Definition step_of (a : scheme) (f : Z -> R) : Z -> R :=
  subdivide (arity a) (first a) (length (coefficients a) - 1) (coefficient (coefficients a) (common a) (first a)) f.
Definition level_step (j : nat) (f : Z -> R) : Z -> R := subdivide A (lowest m) (reach m) (mask_at m j) f.

Lemma good_arity : (2 <= A)%nat /\ d <> 0.
Proof.
  unfold in_period, keeps_constants in Good. rewrite !andb_true_iff in Good. destruct Good as [[[[HA Hd] _] _] _].
  apply Nat.leb_le in HA. apply Z.ltb_lt in Hd. unfold d. split; auto. lia.
Qed.

Lemma good_number j : In j turn -> (j < length (each m))%nat.
Proof.
  intros H. unfold in_period in Good. rewrite !andb_true_iff in Good. destruct Good as [[_ HN] _].
  rewrite forallb_forall in HN. apply Nat.ltb_lt. apply HN. exact H.
Qed.

Lemma mask_supported j : (j < length (each m))%nat -> supported (lowest m) (reach m) (mask_at m j).
Proof.
  intros H k Hk. apply coefficient_supported. assert (W := within_reach m j H). assert (F := first_above_lowest m j H).
  unfold first_number in *. lia.
Qed.

Lemma level_step_scheme j f k : (j < length (each m))%nat -> level_step j f k = step_of (scheme_of m (nth j (each m) no_mask)) f k.
Proof.
  intros H. destruct good_arity as [HA _]. apply (subdivide_same A); auto. apply mask_supported; auto. apply coefficient_supported.
Qed.

Lemma step_of_mask a j f k : (2 <= arity a)%nat -> common a <> 0 -> (j < length (each m))%nat ->
  step_of (then_mask m a (nth j (each m) no_mask)) f k = level_step j (step_of a f) k.
Proof.
  intros Ha Hc Hj. destruct good_arity as [HA Hd]. rewrite level_step_scheme by auto.
  set (p := nth j (each m) no_mask). unfold step_of. cbn [then_mask scheme_of arity first coefficients common]. fold A d.
  assert (E : coefficient (spread_times A (snd p) (coefficients a)) (d * common a) (fst p + Z.of_nat A * first a) =
    subdivide A (fst p) (length (snd p) - 1) (coefficient (snd p) d (fst p)) (coefficient (coefficients a) (common a) (first a))).
  { extensionality l. apply spread_times_coefficient; auto. }
  rewrite E. apply two_steps; auto; try apply coefficient_supported. rewrite <- E. apply coefficient_supported.
Qed.

Definition walk (l : list nat) (f : Z -> R) : Z -> R := fold_left (fun f j => level_step j f) l f.

Lemma level_step_ext j f g : (forall k, f k = g k) -> forall k, level_step j f k = level_step j g k.
Proof. intros H k. apply subdivide_ext. auto. Qed.

Lemma walk_ext l : forall f g, (forall k, f k = g k) -> forall k, walk l f k = walk l g k.
Proof. induction l; intros f g H; simpl; auto. apply IHl. apply level_step_ext. auto. Qed.

Lemma period_step : forall l a, (2 <= arity a)%nat -> common a <> 0 -> (forall j, In j l -> (j < length (each m))%nat) ->
  (2 <= arity (fold_left (fun a j => then_mask m a (nth j (each m) no_mask)) l a))%nat /\
  arity (fold_left (fun a j => then_mask m a (nth j (each m) no_mask)) l a) = (A ^ length l * arity a)%nat /\
  forall f k, step_of (fold_left (fun a j => then_mask m a (nth j (each m) no_mask)) l a) f k = walk l (step_of a f) k.
Proof.
  destruct good_arity as [HA Hd]. induction l as [|j l IH]; intros a Ha Hc Hl.
  - simpl. split; auto. split; auto. lia.
  - assert (B2 : (2 <= arity (then_mask m a (nth j (each m) no_mask)))%nat) by (cbn [then_mask arity]; fold A; nia).
    assert (C2 : common (then_mask m a (nth j (each m) no_mask)) <> 0) by (cbn [then_mask common]; fold d; nia).
    destruct (IH _ B2 C2 (fun x H => Hl x (or_intror H))) as [I1 [I2 I3]]. cbn [fold_left]. split; auto. split.
    + rewrite I2. cbn [then_mask arity length]. fold A. rewrite Nat.pow_succ_r'. ring.
    + intros f k. rewrite I3. cbn [walk fold_left]. apply walk_ext. intros x. apply step_of_mask; auto. apply Hl. left; auto.
Qed.

Let P := period_scheme m i others.
Let len := Datatypes.S (length others).

Theorem period_facts : (2 <= arity P)%nat /\ arity P = (A ^ len)%nat /\ forall f k, step_of P f k = walk turn f k.
Proof.
  destruct good_arity as [HA Hd].
  assert (Hi : (i < length (each m))%nat) by (apply good_number; left; auto).
  destruct (period_step others (scheme_of m (nth i (each m) no_mask)) HA Hd (fun j H => good_number j (or_intror H))) as [I1 [I2 I3]].
  split; auto. split.
  - unfold P, period_scheme. rewrite I2. unfold len. rewrite Nat.pow_succ_r'. cbn [scheme_of arity]. fold A. ring.
  - intros f k. unfold P, period_scheme. rewrite I3. unfold turn. cbn [walk fold_left]. apply walk_ext. intros x.
    symmetry. apply level_step_scheme. auto.
Qed.

Let data := levels A (lowest m) (reach m) (fun k => mask_at m (in_turn i others k)).

Lemma data_walk n : forall l, (forall t, (t < length l)%nat -> in_turn i others (n + t) = nth t l O) ->
  forall k, data (n + length l) k = walk l (data n) k.
Proof.
  intros l. revert n. induction l as [|j l IH]; intros n H k. rewrite Nat.add_0_r. reflexivity.
  cbn [length walk fold_left]. replace (n + Datatypes.S (length l))%nat with (Datatypes.S n + length l)%nat by lia.
  rewrite IH.
  - apply walk_ext. intros x. unfold data. cbn [levels]. assert (E := H O ltac:(simpl; lia)). rewrite Nat.add_0_r in E. rewrite E. reflexivity.
  - intros t Ht. replace (Datatypes.S n + t)%nat with (n + Datatypes.S t)%nat by lia. rewrite H; auto. simpl; lia.
Qed.

(* So many levels are one step of the scheme of the product. *)
Theorem period_levels n : forall k, data (n * len) k = refined_data P n k.
Proof.
  destruct period_facts as [_ [_ E]]. induction n; intros k. reflexivity.
  replace (Datatypes.S n * len)%nat with (n * len + length turn)%nat by (unfold len, turn; simpl; lia).
  rewrite data_walk.
  - rewrite (walk_ext turn _ _ IHn), <- E. reflexivity.
  - intros t Ht. unfold in_turn. fold turn. fold len. f_equal.
    change (Datatypes.S (length others)) with len. rewrite Nat.add_comm, Nat.mod_add by (unfold len; lia). apply Nat.mod_small.
    unfold len. unfold turn in Ht. simpl in Ht. auto.
Qed.
End Period.
