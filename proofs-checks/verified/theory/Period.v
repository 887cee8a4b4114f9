(* Masks in turn: so many levels are one step of a scheme of a larger arity, whose mask is their product; if that scheme
   converges, all levels do, to the same limit (SPEC.md, section 6.5, `period`). *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Integers Sections Subdivision Coefficients Exponent Smooth Rough Along Levels.
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
  keeps_constants m && forallb (fun j => j <? length (each m))%nat (i :: others).

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
    destruct (Z.to_nat _); simpl; unfold Rdiv; lra. }
  induction factor as [|c rest IH]; intros F' i.
  - rewrite Zero. unfold coefficient. destruct (i <? _); auto. cbn [spread_times]. destruct (Z.to_nat _); simpl; unfold Rdiv; lra.
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
  intros HA HB S S' c SC. set (q := (n - F) / Z.of_nat A). set (r := (Z.to_nat (Z.abs q + Z.abs F') + L + L' + 2)%nat).
  set (lo := - Z.of_nat r). set (w := (2 * r + 1)%nat).
  set (I := fun k : nat => q - Z.of_nat L + Z.of_nat k).
  assert (Out : forall k j, (k < Datatypes.S L)%nat -> j < lo \/ lo + Z.of_nat w <= j -> a' (I k - Z.of_nat B * j) = 0%R).
  { intros k j Hk Hj. apply S'. unfold I, lo, w, r in *. nia. }
  assert (E : forall k, (k < Datatypes.S L)%nat -> subdivide B F' L' a' f (I k) =
    sum w (fun m => a' (I k - Z.of_nat B * (lo + Z.of_nat m))%Z * f (lo + Z.of_nat m)%Z)%R).
  { intros k Hk. symmetry. apply (subdivide_window B F' L' HB L' a' f (I k) lo w S' (le_n L')). intros j Hj. apply Out; auto. }
  assert (C : forall j, c (n - Z.of_nat (A * B) * j) = sum (Datatypes.S L) (fun k => a (n - Z.of_nat A * I k)%Z * a' (I k - Z.of_nat B * j)%Z)%R).
  { intros j. unfold c. replace (n - Z.of_nat (A * B) * j) with (n - Z.of_nat A * (Z.of_nat B * j)) by (rewrite Nat2Z.inj_mul; ring).
    rewrite <- (subdivide_shift A F L HA). reflexivity. }
  assert (HAB : (2 <= A * B)%nat) by nia.
  rewrite <- (subdivide_window (A * B) FC LC HAB LC c f n lo w SC (le_n LC)).
  - rewrite (sum_ext w _ (fun m => sum (Datatypes.S L) (fun k => a (n - Z.of_nat A * I k)%Z *
      (a' (I k - Z.of_nat B * (lo + Z.of_nat m))%Z * f (lo + Z.of_nat m)%Z)))%R).
    + rewrite sum_swap. change (subdivide A F L a (fun i => subdivide B F' L' a' f i) n) with
        (sum (Datatypes.S L) (fun k => a (n - Z.of_nat A * I k)%Z * subdivide B F' L' a' f (I k)))%R.
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
  unfold in_period, keeps_constants in Good. rewrite !andb_true_iff in Good. destruct Good as [[[HA Hd] _] _].
  apply Nat.leb_le in HA. apply Z.ltb_lt in Hd. unfold d. split; auto. lia.
Qed.

Lemma good_number j : In j turn -> (j < length (each m))%nat.
Proof.
  intros H. unfold in_period in Good. rewrite !andb_true_iff in Good. destruct Good as [_ HN].
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
  - split; [auto|]. split; [simpl; lia|auto].
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

(* ---- the levels between --------------------------------------------------------------------------------------------------- *)

Lemma good_classes j : (j < length (each m))%nat -> forall k, level_step j (fun _ => 1%R) k = 1%R.
Proof.
  intros Hj k. destruct good_arity as [HA Hd]. rewrite level_step_scheme by auto. set (p := nth j (each m) no_mask).
  assert (Hp : In p (each m)) by (apply nth_In; auto).
  unfold in_period, keeps_constants in Good. rewrite !andb_true_iff in Good. destruct Good as [[[_ H0] HC] _].
  rewrite forallb_forall in HC. specialize (HC p Hp). rewrite forallb_forall in HC. fold A d in HC. apply Z.ltb_lt in H0. fold d in H0.
  unfold step_of. cbn [scheme_of arity first coefficients common]. fold A d.
  set (r := Z.to_nat ((k - fst p) mod Z.of_nat A)). set (s := (k - fst p) / Z.of_nat A).
  assert (Dv := Z.div_mod (k - fst p) (Z.of_nat A) ltac:(lia)). assert (Md := Z.mod_pos_bound (k - fst p) (Z.of_nat A) ltac:(lia)).
  assert (Ek : k - Z.of_nat A * s = fst p + Z.of_nat r) by (unfold s, r; lia).
  assert (Hr : (r < A)%nat) by (unfold r; lia).
  change (fun _ : Z => 1%R) with (fun j : Z => (fun _ : Z => 1%R) (j - s)).
  rewrite (subdivide_shift A (fst p) (length (snd p) - 1) HA), Ek.
  replace (coefficient (snd p) d (fst p)) with (fun l => coefficient (snd p) d 0 (l - fst p)) by
    (extensionality l; symmetry; apply coefficient_shift).
  rewrite class_sum_sound by (auto; lia). specialize (HC r ltac:(apply in_seq; lia)). apply Z.eqb_eq in HC. rewrite HC.
  field. apply IZR_neq. auto.
Qed.

Lemma turn_near : exists C, (0 <= C)%R /\ forall j, In j turn -> forall (f : Z -> R) e, (forall k, (Rabs (f k - f (k - 1)%Z) <= e)%R) ->
  forall k, (Rabs (level_step j f k - f (k / Z.of_nat A)%Z) <= C * e)%R.
Proof.
  destruct good_arity as [HA _]. assert (G : forall j, In j turn -> (j < length (each m))%nat) by apply good_number.
  induction turn as [|j l IH].
  - exists 0%R. split. lra. intros j [].
  - destruct IH as [C [C0 HC]]. { intros x Hx. apply G. right; auto. }
    destruct (step_near A (lowest m) (reach m) HA (reach m) (mask_at m j)) as [C' [C0' HC']].
    { apply mask_supported. apply G. left; auto. }
    { intros k. apply good_classes. apply G. left; auto. }
    exists (C + C')%R. split. lra. intros x Hx f e He k.
    assert (E0 : (0 <= e)%R) by (eapply Rle_trans; [apply Rabs_pos|apply (He 0)]).
    destruct Hx as [<-|Hx].
    + eapply Rle_trans. apply (HC' f e He k). apply Rmult_le_compat_r; lra.
    + eapply Rle_trans. apply (HC x Hx f e He k). apply Rmult_le_compat_r; lra.
Qed.

Lemma in_turn_in k : In (in_turn i others k) turn.
Proof. apply nth_In. apply Nat.mod_upper_bound. discriminate. Qed.

Lemma between r : exists D, (0 <= D)%R /\ forall n e, (forall k, (Rabs (data n k - data n (k - 1)%Z) <= e)%R) ->
  (forall k, (Rabs (data (n + r)%nat k - data (n + r)%nat (k - 1)%Z) <= D * e)%R) /\
  forall k, (Rabs (data (n + r)%nat k - data n (k / Z.of_nat A ^ Z.of_nat r)%Z) <= D * e)%R.
Proof.
  destruct good_arity as [HA _]. destruct turn_near as [C [C0 Near]]. induction r as [|r [D [D0 IH]]].
  - exists 1%R. split. lra. intros n e He. rewrite Nat.add_0_r, Rmult_1_l. split; auto. intros k.
    change (Z.of_nat A ^ Z.of_nat 0) with 1. rewrite Z.div_1_r, Rminus_diag_eq, Rabs_R0 by auto.
    eapply Rle_trans; [apply Rabs_pos|apply (He 0)].
  - exists ((2 * C + 2) * D)%R. split. apply Rmult_le_pos; lra. intros n e He. destruct (IH n e He) as [I1 I2].
    assert (E0 : (0 <= e)%R) by (eapply Rle_trans; [apply Rabs_pos|apply (He 0)]).
    assert (DE : (0 <= D * e)%R) by (apply Rmult_le_pos; auto). assert (CDE : (0 <= C * (D * e))%R) by (apply Rmult_le_pos; auto).
    rewrite Nat.add_succ_r. set (g := data (n + r)) in *.
    assert (S : forall k, (Rabs (data (Datatypes.S (n + r))%nat k - g (k / Z.of_nat A)%Z) <= C * (D * e))%R).
    { intros k. apply (Near (in_turn i others (n + r)) (in_turn_in _) g (D * e)%R I1 k). }
    replace ((2 * C + 2) * D * e)%R with (2 * (C * (D * e)) + 2 * (D * e))%R by ring. set (x := (C * (D * e))%R) in *. split; intros k.
    + assert (S1 := S k). assert (S2 := S (k - 1)). set (y := data _ k) in *. set (z := data _ (k - 1)) in *.
      assert (M : (Rabs (g (k / Z.of_nat A)%Z - g ((k - 1) / Z.of_nat A)%Z) <= D * e)%R).
      { assert (E : (k - 1) / Z.of_nat A = k / Z.of_nat A \/ (k - 1) / Z.of_nat A = k / Z.of_nat A - 1).
        { assert (D1 := Z.div_mod k (Z.of_nat A) ltac:(lia)). assert (M1 := Z.mod_pos_bound k (Z.of_nat A) ltac:(lia)).
          assert (D2 := Z.div_mod (k - 1) (Z.of_nat A) ltac:(lia)). assert (M2 := Z.mod_pos_bound (k - 1) (Z.of_nat A) ltac:(lia)). nia. }
        destruct E as [->| ->]. rewrite Rminus_diag_eq, Rabs_R0; auto. apply I1. }
      replace (y - z)%R with ((y - g (k / Z.of_nat A)%Z) + (g (k / Z.of_nat A)%Z - g ((k - 1) / Z.of_nat A)%Z) +
        - (z - g ((k - 1) / Z.of_nat A)%Z))%R by ring.
      eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. eapply Rle_trans. apply Rplus_le_compat_r, Rabs_triang. lra.
    + assert (S1 := S k). assert (I := I2 (k / Z.of_nat A)). rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia.
      rewrite Z.div_div in I by (try lia; apply Z.pow_pos_nonneg; lia).
      set (y := data (Datatypes.S (n + r)) k) in *. set (v := data n _) in *.
      replace (y - v)%R with ((y - g (k / Z.of_nat A)%Z) + (g (k / Z.of_nat A)%Z - v))%R by ring.
      eapply Rle_trans. apply Rabs_triang. lra.
Qed.

Lemma between_all top : exists D, (0 <= D)%R /\ forall r, (r < top)%nat -> forall n e,
  (forall k, (Rabs (data n k - data n (k - 1)%Z) <= e)%R) ->
  forall k, (Rabs (data (n + r)%nat k - data n (k / Z.of_nat A ^ Z.of_nat r)%Z) <= D * e)%R.
Proof.
  induction top as [|top [D [D0 H]]]. { exists 0%R. split. lra. intros r Hr. lia. }
  destruct (between top) as [D' [D0' H']]. exists (D + D')%R. split. lra. intros r Hr n e He k.
  assert (E0 : (0 <= e)%R) by (eapply Rle_trans; [apply Rabs_pos|apply (He 0)]).
  destruct (Nat.eq_dec r top) as [->|N].
  - eapply Rle_trans. apply (proj2 (H' n e He) k). apply Rmult_le_compat_r; lra.
  - eapply Rle_trans. apply (H r ltac:(lia) n e He k). apply Rmult_le_compat_r; lra.
Qed.

(* If the scheme of the product converges, so do all levels, to the same limit. *)
Theorem period_limit phi : limit_of P phi -> limit_of_sequence m (in_turn i others) phi.
Proof.
  intros Lim. destruct good_arity as [HA _]. destruct period_facts as [HB [EB _]].
  assert (Lim' := Lim). destruct Lim' as [Co H]. split; auto. intros eps He.
  destruct (between_all len) as [D [D0 HD]]. set (e := (eps / (3 * D + 2))%R).
  assert (E0 : (0 < e)%R) by (apply Rdiv_lt_0_compat; lra).
  assert (Ee : ((3 * D + 2) * e = eps)%R) by (unfold e; field; lra).
  destruct (H e E0) as [n1 H1].
  destruct (uniform phi _ _ Co (limit_zero (arity P) (first P) HB _ _ phi (coefficient_supported (coefficients P) (common P) (first P)) Lim) e E0) as [g [G0 HG]].
  destruct (small_cell (arity P) HB (g / 2) ltac:(lra)) as [n2 H2].
  exists ((n1 + n2) * len)%nat. intros n Hn k.
  assert (L0 : (len <> 0)%nat) by discriminate.
  assert (Dn := Nat.div_mod n len L0). assert (Mn := Nat.mod_upper_bound n len L0). set (q := (n / len)%nat) in *. set (r := (n mod len)%nat) in *.
  assert (Hq : (n1 + n2 <= q)%nat) by nia.
  specialize (H1 q ltac:(lia)). specialize (H2 q ltac:(lia)).
  assert (PB := power_positive (arity P) HB q). set (h := (INR (arity P) ^ q)%R) in *.
  assert (Close : forall x y, (Rabs (x - y) <= / h)%R -> (Rabs (phi x - phi y) <= e)%R) by (intros x y Hxy; apply HG; lra).
  assert (V : forall l, (Rabs (data (q * len)%nat l - phi (IZR l / h)) <= e)%R).
  { intros l. rewrite period_levels. apply H1. }
  assert (Dif : forall l, (Rabs (data (q * len)%nat l - data (q * len)%nat (l - 1)%Z) <= 3 * e)%R).
  { intros l. assert (V1 := V l). assert (V2 := V (l - 1)).
    assert (X : (Rabs (phi (IZR l / h) - phi (IZR (l - 1)%Z / h)) <= e)%R).
    { apply Close. rewrite minus_IZR. replace (IZR l / h - (IZR l - 1) / h)%R with (/ h)%R by (field; lra).
      rewrite Rabs_pos_eq. lra. left. apply Rinv_0_lt_compat; auto. }
    set (a := data (q * len)%nat l) in *. set (b := data (q * len)%nat (l - 1)%Z) in *.
    replace (a - b)%R with ((a - phi (IZR l / h)) + (phi (IZR l / h) - phi (IZR (l - 1)%Z / h)) + - (b - phi (IZR (l - 1)%Z / h)))%R by ring.
    eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. eapply Rle_trans. apply Rplus_le_compat_r, Rabs_triang. lra. }
  assert (X := HD r Mn (q * len)%nat (3 * e)%R Dif k). fold A. change (levels A (lowest m) (reach m) _) with data.
  replace (q * len + r)%nat with n in X by lia.
  set (z := Z.of_nat A ^ Z.of_nat r) in *. assert (Z0 : 0 < z) by (apply Z.pow_pos_nonneg; lia).
  assert (Y := V (k / z)). set (v := data (q * len)%nat (k / z)) in *.
  assert (Pn : (INR A ^ n = h * IZR z)%R).
  { unfold h, z. rewrite EB, (arity_power A HA), pow_INR, <- pow_mult, <- pow_add. f_equal. lia. }
  assert (Zr : (0 < IZR z)%R) by (apply IZR_lt; auto).
  assert (W : (Rabs (phi (IZR (k / z)%Z / h) - phi (IZR k / INR A ^ n)) <= e)%R).
  { apply Close. rewrite Pn. assert (Dk := Z.div_mod k z ltac:(lia)). assert (Mk := Z.mod_pos_bound k z Z0).
    replace (IZR (k / z)%Z / h - IZR k / (h * IZR z))%R with (- (/ h * (IZR (k mod z)%Z / IZR z)))%R.
    - rewrite Rabs_Ropp, Rabs_pos_eq.
      + rewrite <- (Rmult_1_r (/ h)) at 2. apply Rmult_le_compat_l. left; apply Rinv_0_lt_compat; auto.
        apply (Rmult_le_reg_r (IZR z)); auto. replace (IZR (k mod z)%Z / IZR z * IZR z)%R with (IZR (k mod z)%Z) by (field; lra).
        rewrite Rmult_1_l. apply IZR_le. lia.
      + apply Rmult_le_pos. left; apply Rinv_0_lt_compat; auto. apply Rmult_le_pos. apply IZR_le; lia. left; apply Rinv_0_lt_compat; auto.
    - rewrite Dk at 3. rewrite plus_IZR, mult_IZR. field. lra. }
  set (y := data n k) in *.
  replace (y - phi (IZR k / INR A ^ n))%R with ((y - v) + (v - phi (IZR (k / z)%Z / h)) + (phi (IZR (k / z)%Z / h) - phi (IZR k / INR A ^ n)))%R by ring.
  eapply Rle_trans. apply Rabs_triang. eapply Rle_trans. apply Rplus_le_compat_r, Rabs_triang.
  apply Rle_trans with (D * (3 * e) + e + e)%R. lra. rewrite <- Ee. right. ring.
Qed.
(* A limit of all levels is one of these, too. *)
Theorem limit_of_period phi : limit_of_sequence m (in_turn i others) phi -> limit_of P phi.
Proof.
  intros [Co H]. destruct period_facts as [_ [EB _]]. split; auto. intros eps He. destruct (H eps He) as [n0 Hn].
  exists n0. intros n Hle k. change (refined _ _ _ _ n k) with (refined_data P n k). rewrite <- period_levels.
  assert (Hl : (n0 <= n * len)%nat) by (unfold len; nia). specialize (Hn (n * len)%nat Hl k). rewrite EB.
  replace (INR (A ^ len) ^ n)%R with (INR A ^ (n * len))%R; auto. rewrite pow_INR, <- pow_mult. f_equal. lia.
Qed.
End Period.

(* What holds of the scheme of the product is about the limit of all levels. *)
Theorem period_sound m i others : in_period m i others = true ->
  forall phi, limit_of_sequence m (in_turn i others) phi <-> limit_of (period_scheme m i others) phi.
Proof. intros H phi. split. apply limit_of_period; auto. apply period_limit; auto. Qed.
