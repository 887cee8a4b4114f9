(* Theorem 30 of SPEC.md: a graph whose bound is a little below the radius, and cycles of states whose norms know the
   eigenvector of the product of the letters on the way round. Checked with integers. *)
Require Import Reals List ZArith QArith FMapPositive Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Lower Blocks Integers Sections Eigenvalue Graph Check Complex Number Attained.
Import ListNotations.
Open Scope Z_scope.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

(* The states of a cycle, each with the class of the letter of its kept word and a row near the true one: the first is that
   of the base, of the transposed matrices, the others are its images, over powers of the radius. `part` is KEPT; rows are
   divided by `cut`, and `weight` is the square of what they are multiplied by then. The radius is `least` or more. *)
Record cycle := Cycle { carrier : nat; part : Q; weight : Q; cut : Z; least : Q; stops : list (nat * (nat * point)) }.
Record station := Station { state_at : nat; class_at : nat; row_at : vertex }.

Fixpoint distinct (l : list nat) : bool :=
  match l with [] => true | a :: l' => negb (existsb (Nat.eqb a) l') && distinct l' end.

(* Each with the next one, and the last with the first *)
Definition pairs (ss : list station) : list (station * station) :=
  match ss with [] => [] | s :: rest => List.combine ss (rest ++ [s]) end.

Section Checker.
(* G has the transposed matrices. *)
Variables (F G : family) (p : list Z) (L : nat) (h : place) (g : Q) (firsts : list nat) (states : list state) (bs : list base).
Let n := size F.
Let letter_at (s : station) : nat := nth (class_at s) firsts 0%nat.

Fixpoint stations (j c : nat) (x : vertex) (l : list (nat * (nat * point))) : option (list station) :=
  match l with
  | [] => Some [Station j c x]
  | (j', (c', v)) :: l' =>
      match make G h bs (PositiveMap.add 1%positive x (PositiveMap.empty _)) (FromPoint 1 (nth c firsts 0%nat)) v [] with
      | None => None
      | Some y => match stations j' c' y l' with None => None | Some ss => Some (Station j c x :: ss) end
      end
  end.

(* The base is led to z times itself by the letters on the way. *)
Definition turns_round (k : nat) (ss : list station) : bool :=
  match nth_error bs k with
  | None => false
  | Some b =>
      match previous b with
      | None => false
      | Some (k', (w, _)) => Nat.eqb k' k && same_word w (rev (map letter_at ss))
      end
  end.

Definition way (c : cycle) : option (list station) :=
  match stops c with
  | [] => None
  | (j, (k, v)) :: l =>
      match make G h bs (PositiveMap.empty _) (FromBase (carrier c)) v [] with
      | None => None
      | Some x => match stations j k x l with None => None | Some ss => if turns_round (carrier c) ss then Some ss else None end
      end
  end.

Fixpoint ways (l : list cycle) : option (list (cycle * (station * station))) :=
  match l with
  | [] => Some []
  | c :: l' =>
      match way c, ways l' with
      | Some ss, Some all => Some (map (fun q => (c, q)) (pairs ss) ++ all)
      | _, _ => None
      end
  end.

(* A row over `cut`, and its error *)
Definition shortened (c : cycle) (x : vertex) : point * Z :=
  let s := cut c in let v := shown x in
  ((cut_by s (fst v), cut_by s (snd v)), over_up (off x) s + (cut_error n s (fst v) + cut_error n s (snd v))).

(* The square of the modulus of what a row is at x, as a form *)
Definition row_square (v : point) : zmat := gram (map (fun k => [nth k (fst v) 0; nth k (snd v) 0]) (seq 0 n)).
Definition length_square (j : nat) : zmat := gram (columns n (coordinates_of states j)).

Definition station_right (c : cycle) (s s' : station) : bool :=
  let t := letter_at s in let '(x, off_x) := shortened c (row_at s) in let '(y, off_y) := shortened c (row_at s') in
  let l1 := Qnum (least c) in let l2 := Zpos (Qden (least c)) in let lo := l1 * l1 in let bo := l2 * l2 in
  let k1 := Qnum (part c) in let k2 := Zpos (Qden (part c)) in
  let c1 := Qnum (weight c) in let c2 := Zpos (Qden (weight c)) in
  let a := denominator F * denominator F * lo in
  let b := a * (k2 - k1) * c1 in
  let d := bo * (Qnum g * Qnum g) * c1 in
  (state_at s <? length states)%nat && (state_at s' <? length states)%nat && (t <? count F)%nat &&
  (0 <=? k1) && (k1 <=? k2) && (0 <=? c1) && (0 <? cut c) && (0 <? l1) && (l1 * bottom h <=? low h * l2) &&
  semidefinite n
    (add_rows (- (bo * k2 * c2)) (gram (map (mv (coordinates_of states (state_at s))) (columns n (letter F t))))
    (add_rows (a * k1 * c2) (length_square (state_at s'))
    (add_rows b (row_square y) (diagonal n (- (b * (2 * norm_pair y * off_y))))))) &&
  semidefinite n
    (add_rows (lo * (Zpos (Qden g) * Zpos (Qden g)) * c2) (length_square (state_at s))
    (add_rows (- d) (row_square x) (diagonal n (- (d * (2 * norm_pair x * off_x + off_x * off_x)))))).
End Checker.

Definition keeps (l : list (cycle * (station * station))) (j c : nat) : bool :=
  existsb (fun q => let s := fst (snd q) in Nat.eqb (state_at s) j && Nat.eqb (class_at s) c) l.

(* The radius is that of the claim at most. *)
Definition graph_below (F : family) (p : list Z) (L : nat) (h : place) (g : Q) (unity : Z) (firsts : list nat) (group : list element)
    (turns : list turn) (states : list state) (bs : list base) (cycles : list cycle) : bool :=
  let G := transpose F in
  forallb (base_right G p L bs) bs && (Qnum g * bottom h <=? low h * Zpos (Qden g)) &&
  match ways G h firsts bs cycles with
  | None => false
  | Some l =>
      distinct (map (fun q => state_at (fst (snd q))) l) &&
      forallb (fun q => station_right F h g firsts states (fst q) (fst (snd q)) (snd (snd q))) l &&
      graph_but (keeps l) F g unity firsts group turns states
  end.

(* ---- rows ---------------------------------------------------------------------------------------------------------- *)

Open Scope R_scope.

Definition at_row (n : nat) (X x : vec) : R := sum n (fun k => X k * x k).

Lemma at_row_scal n c X x : at_row n (scal c X) x = c * at_row n X x.
Proof. unfold at_row, scal. rewrite <- sum_scal. apply sum_ext; intros; ring. Qed.

Lemma at_row_plus n X Y x : at_row n (plus X Y) x = at_row n X x + at_row n Y x.
Proof. unfold at_row, plus. rewrite <- sum_plus. apply sum_ext; intros; ring. Qed.

Lemma at_row_bound n X x : Rabs (at_row n X x) <= norm n X * len n x.
Proof.
  unfold at_row, norm. eapply Rle_trans. apply sum_abs. rewrite Rmult_comm, <- sum_scal. apply sum_le; intros k Hk.
  rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos. apply coordinate_len; auto.
Qed.

Lemma at_row_transposed F t X x : (t < count F)%nat ->
  at_row (size F) (apply (size F) (real (transpose F) t) X) x = at_row (size F) X (apply (size F) (real F t) x).
Proof.
  intros Ht. unfold at_row, apply.
  rewrite (sum_ext _ _ (fun k => sum (size F) (fun j => X j * (real F t j k * x k)))).
  - rewrite sum_swap. apply sum_ext; intros j Hj. rewrite <- sum_scal. auto.
  - intros k Hk. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros j Hj.
    assert (E : real (transpose F) t k j = real F t j k).
    { unfold real. simpl denominator. f_equal. unfold mr, transpose. rewrite letter_map by auto. unfold columns. rewrite entry_table; auto. }
    rewrite E. ring.
Qed.

(* Two complex numbers that are near each other *)
Lemma squares_near a b da db m e s : 0 <= m -> 0 <= e -> 0 <= s -> Rabs a + Rabs b <= m * s -> Rabs da + Rabs db <= e * s ->
  Rabs ((a + da) * (a + da) + (b + db) * (b + db) - (a * a + b * b) - (da * da + db * db)) <= 2 * m * e * (s * s) /\
  0 <= da * da + db * db <= e * e * (s * s).
Proof.
  intros Hm He Hs H1 H2. assert (A := Rabs_pos a). assert (B := Rabs_pos b). assert (C := Rabs_pos da). assert (D := Rabs_pos db). split.
  - replace ((a + da) * (a + da) + (b + db) * (b + db) - (a * a + b * b) - (da * da + db * db)) with (2 * (a * da + b * db)) by ring.
    rewrite Rabs_mult, (Rabs_pos_eq 2) by lra. assert (T := Rabs_triang (a * da) (b * db)). rewrite !Rabs_mult in T.
    assert (P : (Rabs a + Rabs b) * (Rabs da + Rabs db) <= (m * s) * (e * s)) by (apply Rmult_le_compat; lra).
    assert (0 <= Rabs a * Rabs db) by (apply Rmult_le_pos; auto). assert (0 <= Rabs b * Rabs da) by (apply Rmult_le_pos; auto). lra.
  - assert (Sq : forall x, x * x = Rabs x * Rabs x) by (intros; rewrite <- Rabs_mult; symmetry; apply Rabs_pos_eq, (Rle_0_sqr x)).
    rewrite (Sq da), (Sq db). assert (0 <= Rabs da * Rabs da) by (apply Rmult_le_pos; auto). assert (0 <= Rabs db * Rabs db) by (apply Rmult_le_pos; auto).
    assert (0 <= Rabs da * Rabs db) by (apply Rmult_le_pos; auto).
    assert (P : (Rabs da + Rabs db) * (Rabs da + Rabs db) <= (e * s) * (e * s)) by (apply Rmult_le_compat; lra). lra.
Qed.

Lemma distinct_sound l : distinct l = true -> NoDup l.
Proof.
  induction l as [|a l IH]; intros H; constructor; cbn [distinct] in H; apply andb_prop in H; destruct H as [H1 H2]; auto.
  intros I. apply negb_true_iff in H1. assert (E : existsb (Nat.eqb a) l = true) by (apply existsb_exists; exists a; split; auto; apply Nat.eqb_refl).
  congruence.
Qed.

Lemma find_distinct {A} (f : A -> nat) l x : NoDup (map f l) -> In x l -> find (fun y => Nat.eqb (f y) (f x)) l = Some x.
Proof.
  induction l as [|a l IH]; intros H I; [destruct I|]. cbn [map] in H. inversion H; subst. cbn [find]. destruct I as [->|I].
  - rewrite Nat.eqb_refl. auto.
  - destruct (Nat.eqb_spec (f a) (f x)) as [E|E]; auto. exfalso. apply H2. rewrite E. apply in_map; auto.
Qed.

Lemma fst_combine {A B} (l : list A) : forall l' : list B, length l = length l' -> map fst (List.combine l l') = l.
Proof. induction l as [|a l IH]; intros [|b l'] H; try discriminate; auto. simpl. rewrite IH; auto. Qed.

(* ---- why that proves it ------------------------------------------------------------------------------------------ *)

Section Sound.
Variables (F : family) (p : list Z) (L : nat) (h : place) (g : Q) (firsts : list nat) (states : list state) (bs : list base) (z : complex) (r : R).
Let G := transpose F.
Let n := size F.
Let D := IZR (denominator F).
Let T := real F.
Hypothesis WF : well_formed F = true.
Hypothesis Zero : value p z = real_number 0.
Hypothesis Scale : (0 < near_scale h)%Z.
Hypothesis Small : (0 <= near_radius h)%Z.
Hypothesis Near_re : Rabs (fst z - IZR (near_re h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h).
Hypothesis Near_im : Rabs (snd z - IZR (near_im h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h).
Hypothesis Radius : 0 < r.
Hypothesis Power : r ^ L = cabs z.
Hypothesis Length : (0 < L)%nat.
Hypothesis Low : (0 < low h)%Z.
Hypothesis Common : (0 < bottom h)%Z.
Hypothesis Between : IZR (low h) / IZR (bottom h) <= r <= IZR (high h) / IZR (bottom h).
Hypothesis Right : forallb (base_right G p L bs) bs = true.
Hypothesis Lower : forall j, (j < length states)%nat -> square n (coordinates_of states j) = true.

Let WG : well_formed G = true := transpose_well_formed F WF.
Let good := good_vertex G z r bs.
Let letter_at (s : station) : nat := nth (class_at s) firsts 0%nat.
Let re := true_re G z r bs.
Let im := true_im G z r bs.
Definition value_at (x : vertex) (y : vec) : R :=
  modulus (at_row (size F) (true_re (transpose F) z r bs x) y) (at_row (size F) (true_im (transpose F) z r bs x) y).

Lemma good_made known s v x : (forall i y, PositiveMap.find i known = Some y -> good y) -> make G h bs known s v [] = Some x -> good x.
Proof. apply (make_sound G L h z r WG Scale Small Near_re Near_im Radius Length Low Common Between). Qed.

(* Where the way leads from a station on *)
Lemma stations_sound l : forall j c x ss, stations G h firsts bs j c x l = Some ss -> good x -> exists rest, ss = Station j c x :: rest /\
  (forall s, In s ss -> good (row_at s) /\ from (row_at s) = from x) /\
  forall f s s', In (s, s') (List.combine ss (rest ++ [f])) ->
    path (row_at s') = letter_at s :: path (row_at s) \/
    s' = f /\ letter_at s :: path (row_at s) = rev (map letter_at ss) ++ path x.
Proof.
  induction l as [|[j' [c' v]] l IH]; intros j c x ss H Hx; cbn [stations] in H.
  - inversion H; subst. exists []. split; auto. split. { intros s [<-|[]]. auto. }
    intros f s s' [E|[]]. inversion E; subst. right. auto.
  - destruct (make G h bs _ _ v []) as [y|] eqn:EM; [|discriminate]. destruct (stations G h firsts bs j' c' y l) as [ss'|] eqn:ES; [|discriminate].
    inversion H; subst ss. clear H.
    assert (Hy : good y).
    { eapply good_made; [|exact EM]. intros i u E. destruct (Pos.eq_dec i 1) as [->|N].
      rewrite PositiveMap.gss in E. inversion E; subst; auto. rewrite PositiveMap.gso, PositiveMap.gempty in E by auto. discriminate. }
    assert (Path : path y = nth c firsts 0%nat :: path x /\ from y = from x).
    { unfold make in EM. rewrite PositiveMap.gss in EM. destruct (Nat.ltb _ _); [|discriminate]. inversion EM; subst y. auto. }
    destruct Path as [Path From]. destruct (IH _ _ _ _ ES Hy) as [rest [-> [All Next]]].
    exists (Station j' c' y :: rest). split; auto. split.
    { intros s [<-|I]; auto. destruct (All s I) as [A B]. split; auto. rewrite B. auto. }
    intros f s s' I. cbn [List.combine app] in I. destruct I as [E|I].
    + inversion E; subst. left. exact Path.
    + apply Next in I. destruct I as [I|[I1 I2]]; auto. right. split; auto. rewrite I2, Path. cbn [map rev]. rewrite <- !app_assoc. auto.
Qed.

(* What is known of a station and the next one *)
Definition linked_rows (s s' : station) : Prop :=
  good_vertex (transpose F) z r bs (row_at s) /\ good_vertex (transpose F) z r bs (row_at s') /\
  ((nth (class_at s) firsts 0%nat < count F)%nat ->
   forall y, value_at (row_at s) (apply (size F) (real F (nth (class_at s) firsts 0%nat)) y) = r * value_at (row_at s') y).

Lemma next_row s s' : from (row_at s') = from (row_at s) -> path (row_at s') = letter_at s :: path (row_at s) ->
  (letter_at s < count F)%nat -> forall y, value_at (row_at s) (apply n (T (letter_at s)) y) = r * value_at (row_at s') y.
Proof.
  intros HF HP Ht y. unfold value_at. fold G re im.
  destruct (true_step G z r Radius bs (row_at s) (row_at s') _ HF HP) as [E1 E2]. fold re in E1. fold im in E2. rewrite E1, E2.
  rewrite !at_row_scal. change (size G) with (size F). rewrite !at_row_transposed by auto. fold n T.
  set (a := at_row n (re (row_at s)) _). set (b := at_row n (im (row_at s)) _).
  assert (M := modulus_mult (/ r) 0 a b). rewrite modulus_real, Rabs_pos_eq in M by (left; apply Rinv_0_lt_compat; auto).
  replace (/ r * a - 0 * b) with (/ r * a) in M by ring. replace (/ r * b + 0 * a) with (/ r * b) in M by ring. rewrite M. field. lra.
Qed.

Lemma last_row k ss s s' : turns_round firsts bs k ss = true -> from (row_at s) = k -> from (row_at s') = k -> path (row_at s') = [] ->
  letter_at s :: path (row_at s) = rev (map letter_at ss) ->
  (letter_at s < count F)%nat -> forall y, value_at (row_at s) (apply n (T (letter_at s)) y) = r * value_at (row_at s') y.
Proof.
  intros H F1 F2 P' P Ht y. unfold turns_round in H. destruct (nth_error bs k) as [b|] eqn:EB; [|discriminate].
  destruct (previous b) as [[k' [w seed]]|] eqn:EP; [|discriminate]. apply andb_prop in H. destruct H as [H1 H2].
  apply Nat.eqb_eq in H1. subst k'. apply same_word_spec in H2. fold letter_at in H2. rewrite <- P in H2.
  destruct (base_step G p L z WG Zero bs Right k b k w seed EB EP) as [_ [Lw [S1 S2]]]. rewrite H2 in Lw, S1, S2. cbn [length] in Lw.
  change (size G) with n in S1, S2. cbn [run] in S1, S2.
  unfold value_at, n, T. rewrite <- !at_row_transposed by auto. fold G n.
  unfold true_re, true_im. rewrite P', F1, F2. change (size G) with n. cbn [length pow run].
  set (X := fst (true_base z bs k)) in *. set (Y := snd (true_base z bs k)) in *. set (m := length (path (row_at s))) in *.
  rewrite !apply_scal, S1, S2, !at_row_scal. unfold turn_re, turn_im. rewrite !at_row_plus, !at_row_scal.
  set (a := at_row n X y). set (b' := at_row n Y y). set (lambda := zero_for z b).
  assert (Zl : modulus (fst lambda) (snd lambda) = cabs z) by (apply (zero_for_right p z Zero b)).
  assert (Pm : 0 < / r ^ m) by (apply Rinv_0_lt_compat, pow_lt; auto).
  replace (/ r ^ m * (fst lambda * a + - snd lambda * b')) with ((/ r ^ m * fst lambda) * a - (/ r ^ m * snd lambda) * b') by ring.
  replace (/ r ^ m * (fst lambda * b' + snd lambda * a)) with ((/ r ^ m * fst lambda) * b' + (/ r ^ m * snd lambda) * a) by ring.
  rewrite modulus_mult.
  assert (M := modulus_mult (/ r ^ m) 0 (fst lambda) (snd lambda)). rewrite modulus_real, Rabs_pos_eq in M by lra.
  replace (/ r ^ m * fst lambda - 0 * snd lambda) with (/ r ^ m * fst lambda) in M by ring.
  replace (/ r ^ m * snd lambda + 0 * fst lambda) with (/ r ^ m * snd lambda) in M by ring. rewrite M, Zl, <- Power, <- Lw.
  replace (/ 1 * a) with a by field. replace (/ 1 * b') with b' by field. cbn [pow]. field. apply pow_nonzero. lra.
Qed.

Lemma way_sound c ss : way G h firsts bs c = Some ss -> (forall s s', In (s, s') (pairs ss) -> linked_rows s s') /\
  map fst (pairs ss) = ss /\ forall s s', In (s, s') (pairs ss) -> In s' ss.
Proof.
  intros H. unfold way in H. destruct (stops c) as [|[j [k v]] l]; [discriminate|].
  destruct (make G h bs _ _ v []) as [x|] eqn:EM; [|discriminate].
  destruct (stations G h firsts bs j k x l) as [ss'|] eqn:ES; [|discriminate]. destruct (turns_round _ _ _ _) eqn:ET; [|discriminate].
  inversion H; subst ss'. clear H.
  assert (Hx : good x). { eapply good_made; [|exact EM]. intros i u E. rewrite PositiveMap.gempty in E. discriminate. }
  assert (Path : path x = [] /\ from x = carrier c).
  { unfold make in EM. destruct (nth_error bs (carrier c)); [|discriminate]. destruct (evaluate _ _ _ _ _ _). inversion EM; auto. }
  destruct Path as [Path From]. destruct (stations_sound _ _ _ _ _ ES Hx) as [rest [E [All Next]]]. subst ss. cbn [pairs].
  set (s0 := Station j k x) in *. set (ss := s0 :: rest) in *.
  assert (Member : forall s s', In (s, s') (List.combine ss (rest ++ [s0])) -> In s' ss).
  { intros s s' I. apply in_combine_r in I. apply in_app_or in I. destruct I as [I|[<-|[]]]; [right|left]; auto. }
  split; [|split]; auto.
  - intros s s' I. destruct (All s (in_combine_l _ _ _ _ I)) as [A1 A2]. destruct (All s' (Member s s' I)) as [B1 B2].
    split; auto. split; auto. destruct (Next s0 s s' I) as [N|[N1 N2]].
    + apply next_row; auto. congruence.
    + subst s'. apply (last_row (carrier c) ss); auto. congruence. rewrite N2, Path, app_nil_r. auto.
  - apply fst_combine. unfold ss. rewrite app_length. simpl. lia.
Qed.

(* What a row is at x, from what the row near it is *)
Lemma near_square_sound X Y v e y : (0 <= e)%Z -> distance_pair n X Y v <= IZR e ->
  let m := IZR (2 * norm_pair v * e) in let s := squares_of n y in let q := modulus (at_row n X y) (at_row n Y y) in
  rows_form (row_square F v) y - m * s <= q * q <= rows_form (row_square F v) y + (m + IZR (e * e)) * s.
Proof.
  intros Ox Dx m s q. set (a := at_row n (vr (fst v)) y). set (b := at_row n (vr (snd v)) y).
  assert (EN : rows_form (row_square F v) y = a * a + b * b).
  { unfold row_square. fold n. set (row := fun k => [nth k (fst v) 0%Z; nth k (snd v) 0%Z]).
    rewrite (gram_form 2). 2:{ intros u Hu. apply in_map_iff in Hu. destruct Hu as [k [<- _]]. auto. }
    assert (C : forall i, combined (map row (seq 0 n)) y i = sum n (fun k => vr (row k) i * y k)).
    { intros i. rewrite (combined_sum n) by (rewrite map_length, seq_length; auto). apply sum_ext; intros k Hk.
      rewrite (nth_map_seq row n k) by auto. auto. }
    unfold squares_of. simpl sum. rewrite !C. unfold a, b, at_row, vr, row. simpl nth. ring. }
  assert (N := norm_pair_nonneg v).
  set (da := at_row n (sub X (vr (fst v))) y). set (db := at_row n (sub Y (vr (snd v))) y).
  assert (Sub : forall X Y, at_row n X y = at_row n Y y + at_row n (sub X Y) y).
  { intros U V. rewrite <- at_row_plus. apply sum_ext; intros k Hk. unfold plus, sub. ring. }
  assert (EV : q * q = (a + da) * (a + da) + (b + db) * (b + db)).
  { unfold q, modulus. rewrite sqrt_sqrt. 2:{ apply Rplus_le_le_0_compat; apply (Rle_0_sqr). }
    rewrite (Sub X (vr (fst v))), (Sub Y (vr (snd v))). auto. }
  assert (P := len_nonneg n y).
  assert (B1 : Rabs a + Rabs b <= IZR (norm_pair v) * len n y).
  { assert (A1 := at_row_bound n (vr (fst v)) y). assert (A2 := at_row_bound n (vr (snd v)) y). fold a in A1. fold b in A2.
    apply Rle_trans with ((norm n (vr (fst v)) + norm n (vr (snd v))) * len n y). lra. apply Rmult_le_compat_r; auto.
    unfold norm_pair. rewrite plus_IZR. apply Rplus_le_compat; apply norm_norm1. }
  assert (B2 : Rabs da + Rabs db <= IZR e * len n y).
  { assert (A1 := at_row_bound n (sub X (vr (fst v))) y). assert (A2 := at_row_bound n (sub Y (vr (snd v))) y). fold da in A1. fold db in A2.
    apply Rle_trans with ((norm n (sub X (vr (fst v))) + norm n (sub Y (vr (snd v)))) * len n y). lra. apply Rmult_le_compat_r; auto. }
  destruct (squares_near a b da db (IZR (norm_pair v)) (IZR e) (len n y)) as [H1 H2]; auto. apply IZR_le; auto. apply IZR_le; auto.
  rewrite EN, EV. rewrite <- squares_len in H1, H2. fold s in H1, H2. unfold m. rewrite !mult_IZR. apply abs_le in H1. lra.
Qed.

Lemma shortened_sound c x v e y : good x -> (0 < cut c)%Z -> shortened F c x = (v, e) ->
  let m := IZR (2 * norm_pair v * e) in let s := squares_of n y in let q := / IZR (cut c) * value_at x y in
  rows_form (row_square F v) y - m * s <= q * q <= rows_form (row_square F v) y + (m + IZR (e * e)) * s.
Proof.
  intros [_ [Ox Dx]] Hc H m s q. assert (P : 0 < IZR (cut c)) by (apply IZR_lt; auto). assert (I : 0 < / IZR (cut c)) by (apply Rinv_0_lt_compat; auto).
  assert (Ev := f_equal fst H). assert (Ee := f_equal snd H). unfold shortened in Ev, Ee. cbn [fst snd] in Ev, Ee. clear H. fold n in Ee.
  set (k := / IZR (cut c)) in *.
  assert (Eq : q = modulus (at_row n (scal k (re x)) y) (at_row n (scal k (im x)) y)).
  { unfold q, value_at. fold G n re im. rewrite !at_row_scal. set (a := at_row n (re x) y). set (b := at_row n (im x) y).
    assert (M := modulus_mult k 0 a b). rewrite modulus_real, Rabs_pos_eq in M by lra.
    replace (k * a - 0 * b) with (k * a) in M by ring. replace (k * b + 0 * a) with (k * b) in M by ring. auto. }
  rewrite Eq. apply near_square_sound. { rewrite <- Ee. repeat apply Z.add_nonneg_nonneg; try apply cut_error_nonneg. apply over_up_nonneg; auto. }
  assert (Part : forall U u, norm n (sub (scal k U) (vr (cut_by (cut c) u))) <= k * norm n (sub U (vr u)) + IZR (cut_error n (cut c) u)).
  { intros U u. replace (sub (scal k U) (vr (cut_by (cut c) u)))
      with (plus (scal k (sub U (vr u))) (sub (scal k (vr u)) (vr (cut_by (cut c) u)))) by (vectors; ring).
    eapply Rle_trans. apply norm_plus. rewrite norm_scal, Rabs_pos_eq by lra. apply Rplus_le_compat_l. apply cut_sound; auto. }
  unfold distance_pair in *. rewrite <- Ev, <- Ee. cbn [fst snd]. rewrite !plus_IZR.
  assert (A := Part (re x) (fst (shown x))). assert (B := Part (im x) (snd (shown x))).
  change (size G) with n in Dx. fold re im in Dx. assert (Q := over_up_sound (off x) (cut c) Hc). unfold Rdiv in Q. fold k in Q.
  apply (Rmult_le_compat_l k) in Dx; [|lra]. lra.
Qed.

Lemma length_square_sound j y : rows_form (length_square F states j) y = squares_of n (apply n (mr (coordinates_of states j)) y).
Proof.
  unfold length_square. fold n. rewrite (gram_form n).
  - apply sum_ext; intros i Hi. rewrite combined_columns; auto.
  - intros v Hv. apply In_nth with (d := []) in Hv. destruct Hv as [k [_ <-]]. apply row_length, square_table.
Qed.

Lemma image_square j t y : (j < length states)%nat -> (t < count F)%nat ->
  rows_form (gram (map (mv (coordinates_of states j)) (columns n (letter F t)))) y =
  D * D * squares_of n (apply n (mr (coordinates_of states j)) (apply n (T t) y)).
Proof.
  intros Hj Ht. rewrite (gram_form n).
  2:{ intros v Hv. apply in_map_iff in Hv. destruct Hv as [w [<- _]]. apply mv_length; auto. }
  unfold squares_of. rewrite <- sum_scal. apply sum_ext; intros i Hi. rewrite (combined_map n) by auto.
  assert (E : apply n (mr (coordinates_of states j)) (combined (columns n (letter F t)) y) = scal D (apply n (mr (coordinates_of states j)) (apply n (T t) y))).
  { rewrite <- apply_scal. apply apply_ext. intros k Hk. rewrite combined_columns by auto.
    assert (P := denominator_positive F WF). unfold apply, scal, T, real. rewrite <- sum_scal. apply sum_ext; intros. unfold D. field. lra. }
  rewrite E. unfold scal. ring.
Qed.

(* With the norm of the state and the row of a station *)
Definition heavy (c : cycle) (x : vertex) (y : vec) : R := sqrt (real_of (weight c)) * (/ IZR (cut c) * value_at x y).
Definition both (c : cycle) (s : station) (y : vec) : R :=
  Rmax (len (size F) (apply (size F) (mr (coordinates_of states (state_at s))) y)) (heavy c (row_at s) y).

Lemma square_root_le a b : 0 <= b -> a * a <= b * b -> a <= b.
Proof. intros Hb H. apply Rnot_lt_le. intros N. assert (b * b < a * a) by (apply Rmult_le_0_lt_compat; lra). lra. Qed.

Lemma at_most_low u : (Qnum u * bottom h <=? low h * Zpos (Qden u))%Z = true -> real_of u <= r.
Proof.
  intros H. apply Rle_trans with (IZR (low h) / IZR (bottom h)); [|tauto]. apply Z.leb_le, IZR_le in H. rewrite !mult_IZR in H. unfold real_of.
  assert (P1 : 0 < IZR (Zpos (Qden u))) by (apply IZR_lt; lia). assert (P2 : 0 < IZR (bottom h)) by (apply IZR_lt; auto).
  apply (Rmult_le_reg_r (IZR (Zpos (Qden u)) * IZR (bottom h))). apply Rmult_lt_0_compat; auto.
  replace (IZR (Qnum u) / IZR (Zpos (Qden u)) * (IZR (Zpos (Qden u)) * IZR (bottom h))) with (IZR (Qnum u) * IZR (bottom h)) by (field; lra).
  replace (IZR (low h) / IZR (bottom h) * (IZR (Zpos (Qden u)) * IZR (bottom h))) with (IZR (low h) * IZR (Zpos (Qden u))) by (field; lra). auto.
Qed.

Lemma station_sound c s s' : station_right F h g firsts states c s s' = true -> linked_rows s s' -> (0 < Qnum g)%Z ->
  (state_at s < length states)%nat /\ (state_at s' < length states)%nat /\
  (forall y, real_of g * heavy c (row_at s) y <= r * len n (apply n (mr (coordinates_of states (state_at s))) y)) /\
  forall y, both c s (apply n (T (letter_at s)) y) <= r * both c s' y.
Proof.
  intros H [Gs [Gs' Linked]] Hg. unfold station_right in H. cbv zeta in H. fold letter_at n in H.
  destruct (shortened F c (row_at s)) as [vx ex] eqn:EX. destruct (shortened F c (row_at s')) as [vy ey] eqn:EY.
  repeat rewrite andb_true_iff in H. destruct H as [[[[[[[[[[H1 H2] H3] H4] H5] H6] H0] Pl] Ple] H7] H8]. apply Z.ltb_lt in H0, Pl. apply Nat.ltb_lt in H1, H2, H3. apply Z.leb_le in H4, H5, H6. unfold letter_at in *.
  specialize (Linked H3). set (t := nth (class_at s) firsts 0%nat) in *. split; auto. split; auto.
  set (k1 := Qnum (part c)) in *. set (k2 := Zpos (Qden (part c))) in *. set (c1 := Qnum (weight c)) in *. set (c2 := Zpos (Qden (weight c))) in *.
  set (g1 := Qnum g) in *. set (g2 := Zpos (Qden g)) in *. set (W := real_of (weight c)).
  assert (K2 : 0 < IZR k2) by (apply IZR_lt; unfold k2; lia). assert (C2 : 0 < IZR c2) by (apply IZR_lt; unfold c2; lia).
  assert (G2 : 0 < IZR g2) by (apply IZR_lt; unfold g2; lia). assert (G1 : 0 < IZR g1) by (apply IZR_lt; auto).
  assert (C1 : 0 <= IZR c1) by (apply IZR_le; auto). assert (K1 : 0 <= IZR k1 <= IZR k2) by (split; apply IZR_le; auto).
  assert (EW : W = IZR c1 / IZR c2) by auto. assert (W0 : 0 <= W) by (rewrite EW; apply Rmult_le_pos; auto; left; apply Rinv_0_lt_compat; auto).
  assert (SW : sqrt W * sqrt W = W) by (apply sqrt_sqrt; auto). assert (SW0 := sqrt_pos W).
  apply at_most_low in Ple.
  assert (Lo : 0 < IZR (Qnum (least c))) by (apply IZR_lt; auto). assert (Bo : 0 < IZR (Zpos (Qden (least c)))) by (apply IZR_lt; lia).
  assert (Dp := denominator_positive F WF). fold D in Dp.
  change (real_of (least c)) with (IZR (Qnum (least c)) / IZR (Zpos (Qden (least c)))) in Ple.
  set (lo := IZR (Qnum (least c))) in *. set (bo := IZR (Zpos (Qden (least c)))) in *.
  assert (Lr : lo / bo <= r) by exact Ple. assert (Lb : 0 < lo / bo) by (apply Rmult_lt_0_compat; auto; apply Rinv_0_lt_compat; auto).
  assert (Cu : 0 < / IZR (cut c)) by (apply Rinv_0_lt_compat, IZR_lt; auto). set (k0 := / IZR (cut c)) in *.
  assert (V0 : forall x y, 0 <= k0 * value_at x y) by (intros; apply Rmult_le_pos; [lra | apply modulus_nonneg]).
  assert (Below : forall y, real_of g * heavy c (row_at s) y <= lo / bo * len n (apply n (mr (coordinates_of states (state_at s))) y)).
  { intros y. unfold heavy. fold W k0. set (l := len n _). set (q := k0 * value_at (row_at s) y). assert (Hl : 0 <= l) by apply len_nonneg.
    apply square_root_le. apply Rmult_le_pos; lra.
    assert (S := semidefinite_sound n _ H8 y). rewrite !add_rows_form, diagonal_form, length_square_sound, squares_len in S. fold l in S.
    repeat rewrite ?opp_IZR, ?mult_IZR in S. fold lo bo in S.
    assert (N := shortened_sound c (row_at s) vx ex y Gs H0 EX). cbv zeta in N. destruct N as [_ N]. fold k0 q in N.
    set (f := rows_form (row_square F vx) y) in *. set (sq := squares_of n y) in *. rewrite plus_IZR in S.
    repeat rewrite ?mult_IZR in N. repeat rewrite ?mult_IZR in S. set (m := 2 * IZR (norm_pair vx) * IZR ex) in *.
    set (e := IZR ex) in *.
    replace (real_of g * (sqrt W * q) * (real_of g * (sqrt W * q))) with ((real_of g * real_of g) * ((sqrt W * sqrt W) * (q * q))) by ring.
    rewrite SW, EW. replace (real_of g) with (IZR g1 / IZR g2) by auto.
    apply (Rmult_le_reg_r (bo * bo * (IZR g2 * IZR g2) * IZR c2)). repeat apply Rmult_lt_0_compat; auto.
    replace (IZR g1 / IZR g2 * (IZR g1 / IZR g2) * (IZR c1 / IZR c2 * (q * q)) * (bo * bo * (IZR g2 * IZR g2) * IZR c2))
      with (bo * bo * (IZR g1 * IZR g1) * IZR c1 * (q * q)) by (field; lra).
    replace (lo / bo * l * (lo / bo * l) * (bo * bo * (IZR g2 * IZR g2) * IZR c2)) with (lo * lo * (IZR g2 * IZR g2) * IZR c2 * (l * l)) by (field; lra).
    apply Rle_trans with (bo * bo * (IZR g1 * IZR g1) * IZR c1 * (f + (m + e * e) * sq)).
    - apply Rmult_le_compat_l; auto. repeat apply Rmult_le_pos; lra.
    - lra. }
  split.
  { intros y. eapply Rle_trans. apply Below. apply Rmult_le_compat_r; auto. apply len_nonneg. }
  intros y. fold t T n. unfold both at 1. fold n W. apply Rmax_lub.
  2:{ unfold heavy. rewrite Linked. fold W k0. replace (sqrt W * (k0 * (r * value_at (row_at s') y))) with (r * heavy c (row_at s') y) by (unfold heavy; fold W k0; ring).
      apply Rmult_le_compat_l. lra. unfold both. apply Rmax_r. }
  set (M := both c s' y). assert (M1 : len n (apply n (mr (coordinates_of states (state_at s'))) y) <= M) by apply Rmax_l.
  assert (M2 : heavy c (row_at s') y <= M) by apply Rmax_r. unfold heavy in M2. fold W k0 in M2.
  set (l := len n (apply n (mr (coordinates_of states (state_at s'))) y)) in *. set (q := k0 * value_at (row_at s') y) in *.
  assert (Hl : 0 <= l) by apply len_nonneg. assert (Hq : 0 <= q) by apply V0.
  set (k := len n (apply n (mr (coordinates_of states (state_at s))) (apply n (T t) y))).
  apply Rle_trans with (lo / bo * M). 2:{ apply Rmult_le_compat_r; lra. }
  apply square_root_le. apply Rmult_le_pos; lra.
  assert (S := semidefinite_sound n _ H7 y). rewrite !add_rows_form, diagonal_form, length_square_sound, image_square, !squares_len in S by auto. fold t k l in S.
  repeat rewrite ?opp_IZR, ?mult_IZR, ?minus_IZR in S. fold lo bo D in S.
  assert (N := shortened_sound c (row_at s') vy ey y Gs' H0 EY). cbv zeta in N. destruct N as [N _]. fold k0 q in N.
  set (f := rows_form (row_square F vy) y) in *. rewrite (squares_len n y) in N. set (sq := len n y * len n y) in *.
  repeat rewrite ?mult_IZR in N.
  assert (LM : l * l <= M * M) by (apply Rmult_le_compat; auto).
  assert (QM : W * (q * q) <= M * M).
  { rewrite <- SW. replace (sqrt W * sqrt W * (q * q)) with ((sqrt W * q) * (sqrt W * q)) by ring. apply Rmult_le_compat; auto; apply Rmult_le_pos; auto. }
  rewrite EW in QM. apply (Rmult_le_compat_l (IZR c2)) in QM; [|lra]. replace (IZR c2 * (IZR c1 / IZR c2 * (q * q))) with (IZR c1 * (q * q)) in QM by (field; lra).
  apply (Rmult_le_reg_l (bo * bo * IZR k2 * IZR c2 * (D * D))). repeat apply Rmult_lt_0_compat; auto.
  replace (bo * bo * IZR k2 * IZR c2 * (D * D) * (lo / bo * M * (lo / bo * M))) with (D * D * (lo * lo) * (IZR k2 * (IZR c2 * (M * M)))) by (field; lra).
  set (a := D * D * (lo * lo)) in *. assert (A0 : 0 <= a) by (unfold a; repeat apply Rmult_le_pos; lra).
  assert (U1 : a * IZR k1 * IZR c2 * (l * l) <= a * IZR k1 * IZR c2 * (M * M)) by (apply Rmult_le_compat_l; auto; repeat apply Rmult_le_pos; lra).
  assert (U2 : a * (IZR k2 - IZR k1) * (IZR c1 * (f - 2 * IZR (norm_pair vy) * IZR ey * sq)) <= a * (IZR k2 - IZR k1) * (IZR c2 * (M * M))).
  { apply Rmult_le_compat_l. apply Rmult_le_pos; lra. eapply Rle_trans; [|apply QM]. apply Rmult_le_compat_l; auto. }
  lra.
Qed.
Lemma ways_sound cycles : forall l, ways G h firsts bs cycles = Some l -> forall c s s', In (c, (s, s')) l ->
  linked_rows s s' /\ exists s'', In (c, (s', s'')) l.
Proof.
  induction cycles as [|d cycles IH]; intros l H c s s' I; cbn [ways] in H. { inversion H; subst. destruct I. }
  destruct (way G h firsts bs d) as [ss|] eqn:EW; [|discriminate]. destruct (ways G h firsts bs cycles) as [all|] eqn:EA; [|discriminate].
  inversion H; subst l. clear H. apply in_app_or in I. destruct I as [I|I].
  - apply in_map_iff in I. destruct I as [[a b] [E I]]. inversion E; subst. apply way_sound in EW. destruct EW as [W1 [W2 W3]].
    split. apply W1; auto. apply W3 in I. rewrite <- W2 in I. apply in_map_iff in I. destruct I as [[a b] [E' I]]. simpl in E'. subst a.
    exists b. apply in_or_app. left. apply in_map_iff. exists (s', b). auto.
  - destruct (IH all eq_refl c s s' I) as [A [s'' B]]. split; auto. exists s''. apply in_or_app. auto.
Qed.
End Sound.

(* Theorem 30 of SPEC.md, upper half *)
Theorem graph_below_sound F p L h z r g unity firsts group turns states bs cycles : well_formed F = true ->
  value p z = real_number 0 -> (0 < near_scale h)%Z -> (0 <= near_radius h)%Z ->
  Rabs (fst z - IZR (near_re h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h) ->
  Rabs (snd z - IZR (near_im h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h) ->
  0 < r -> r ^ L = cabs z -> (0 < L)%nat -> (0 < low h)%Z -> (0 < bottom h)%Z ->
  IZR (low h) / IZR (bottom h) <= r <= IZR (high h) / IZR (bottom h) ->
  graph_below F p L h g unity firsts group turns states bs cycles = true -> grows_at_most (size F) (count F) (real F) r.
Proof.
  intros WF Zero Scale Small Near_re Near_im Radius Power Length Low Common Between H.
  unfold graph_below in H. cbv zeta in H. repeat rewrite andb_true_iff in H. destruct H as [[Right Le] H].
  destruct (ways (transpose F) h firsts bs cycles) as [l|] eqn:EL; [|discriminate]. repeat rewrite andb_true_iff in H. destruct H as [[Dis Sts] HG].
  assert (Facts := HG). unfold graph_but in Facts. cbv zeta in Facts. repeat rewrite andb_true_iff in Facts.
  destruct Facts as [[[[[[[[Hg _] _] _] _] _] _] States] _]. apply Z.ltb_lt in Hg.
  assert (Lower : forall j, (j < length states)%nat -> square (size F) (coordinates_of states j) = true).
  { intros j Hj. assert (S := nth_forallb _ _ _ no_state States Hj). unfold state_right in S. repeat rewrite andb_true_iff in S. apply S. }
  set (first := fun q : cycle * (station * station) => state_at (fst (snd q))) in *.
  apply distinct_sound in Dis. rewrite forallb_forall in Sts.
  assert (Rows := ways_sound F p L h firsts bs z r WF Zero Scale Small Near_re Near_im Radius Power Length Low Common Between Right cycles l EL).
  assert (Known : forall c s s', In (c, (s, s')) l -> (state_at s < length states)%nat /\ (state_at s' < length states)%nat /\
    (forall y, real_of g * heavy F bs z r c (row_at s) y <=
       r * len (size F) (apply (size F) (mr (coordinates_of states (state_at s))) y)) /\
    forall y, both F states bs z r c s (apply (size F) (real F (nth (class_at s) firsts 0%nat)) y) <= r * both F states bs z r c s' y).
  { intros c s s' I. destruct (Rows c s s' I) as [Linked _]. assert (H := Sts _ I). cbn [fst snd] in H.
    apply (station_sound F L h g firsts states bs z r WF Radius Length Common Between Lower c s s' H Linked Hg). }
  set (beside := fun j x => match find (fun q => Nat.eqb (first q) j) l with
    | Some q => heavy F bs z r (fst q) (row_at (fst (snd q))) x | None => 0 end).
  assert (There : forall c s s' x, In (c, (s, s')) l -> larger F states beside (state_at s) x = both F states bs z r c s x).
  { intros c s s' x I. unfold larger, both, beside. assert (E := find_distinct first l _ Dis I). unfold first at 2 in E. cbn [fst snd] in E.
    rewrite E. auto. }
  assert (HgR : 0 < real_of g) by (eapply bound_positive; eauto).
  assert (LeR : real_of g <= r) by (eapply at_most_low; eauto).
  apply (graph_but_sound (keeps l) F g unity firsts group turns states beside r); auto.
  - intros j x y E. unfold beside. destruct (find _ l); auto. unfold heavy, value_at. do 2 f_equal.
    f_equal; apply sum_ext; intros; rewrite E; auto.
  - intros j x Hj. unfold beside. destruct (find _ l) as [[c [s s']]|] eqn:EF.
    + apply find_some in EF. destruct EF as [I E]. apply Nat.eqb_eq in E. unfold first in E. cbn [fst snd] in *. rewrite <- E.
      apply (Known c s s' I).
    + rewrite Rmult_0_r. apply Rmult_le_pos. lra. apply len_nonneg.
  - intros j k HK Hj Hk. unfold keeps in HK. apply existsb_exists in HK. destruct HK as [[c [s s']] [I E]]. cbn [fst snd] in E.
    apply andb_prop in E. destruct E as [E1 E2]. apply Nat.eqb_eq in E1, E2. subst j k.
    destruct (Known c s s' I) as [_ [K2 [_ K4]]]. destruct (Rows c s s' I) as [_ [s'' I']]. exists (state_at s'). split; auto.
    intros x. rewrite (There c s s' _ I), (There c s' s'' x I'). apply K4.
Qed.
