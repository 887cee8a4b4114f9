(* The sections of a certificate: upper bounds of the radius of one block, checked with integers. *)
Require Import Reals List ZArith QArith FMapPositive Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Blocks Integers.
Import ListNotations.
Open Scope Z_scope.

(* What the checker says of bounds: numerator and denominator. *)
Definition real_of (u : Q) : R := (IZR (Qnum u) / IZR (Zpos (Qden u)))%R.

(* ---- polytopes ------------------------------------------------------------------------------------------------- *)

Definition point := (zvec * zvec)%type.                (* real and imaginary parts; [] for 0 *)
Definition term := (positive * (Z * Z))%type.          (* number of a point, from 1 on, and its weight *)
Definition points := PositiveMap.t point.

Fixpoint number {A : Type} (i : positive) (ps : list A) : PositiveMap.t A :=
  match ps with [] => PositiveMap.empty _ | p :: ps' => PositiveMap.add i p (number (Pos.succ i) ps') end.

Definition zmodulus (a b : Z) : Z := if b =? 0 then Z.abs a else Z.sqrt_up (a * a + b * b).

(* The sum of terms, and of their weights. *)
Fixpoint combine (ps : points) (ts : list term) : option (Z * point) :=
  match ts with
  | [] => Some (0, ([], []))
  | (i, (a, b)) :: ts' =>
      match PositiveMap.find i ps, combine ps ts' with
      | Some (x, y), Some (w, (u, v)) =>
          Some (zmodulus a b + w,
                if b =? 0 then (addmul a x u, addmul a y v)
                else (addmul a x (addmul (- b) y u), addmul a y (addmul b x v)))
      | _, _ => None
      end
  end.

(* scale * target = divisor * (terms) + rest: the sum of the weights, and the norm of the rest. *)
Definition line (nonnegative : bool) (ps : points) (scale divisor : Z) (target : point) (ts : list term) : option (Z * Z) :=
  match combine ps ts with
  | None => None
  | Some (w, (x, y)) =>
      let u := addmul (- divisor) x (addmul scale (fst target) []) in
      let v := addmul (- divisor) y (addmul scale (snd target) []) in
      if nonnegative then match v with [] => Some (w, norm1 (positive_part u)) | _ => None end
      else Some (w, norm1 u + norm1 v)
  end.

(* The largest sum of weights and the largest rest of the lines of units k, k+1, ... *)
Fixpoint units (nonnegative : bool) (ps : points) (one : Z) (k : nat) (lines : list (list term)) : option (Z * Z) :=
  match lines with
  | [] => Some (0, 0)
  | ts :: lines' =>
      match line nonnegative ps one 1 (unit_at 1 k, []) ts, units nonnegative ps one (S k) lines' with
      | Some (w, r), Some (s, t) => Some (Z.max w s, Z.max r t)
      | _, _ => None
      end
  end.

Section Images.
Variables (nonnegative : bool) (ps : points) (scale one divisor s r : Z) (u : Q).

(* The images of one point under all matrices. *)
Fixpoint images (p : point) (Ms : list zmat) (lines : list (list term)) : bool :=
  match Ms, lines with
  | [], _ => true
  | M :: Ms', ts :: lines' =>
      match line nonnegative ps scale divisor (mv M (fst p), mv M (snd p)) ts with
      | None => false
      | Some (w, t) =>
          (Zpos (Qden u) * (w * divisor * (one - r) + t * s) <=? Qnum u * scale * divisor * (one - r)) && images p Ms' lines'
      end
  | _, [] => false
  end.

Fixpoint all_images (Ms : list zmat) (all : list point) (lines : list (list (list term))) : bool :=
  match all, lines with
  | [], _ => true
  | p :: all', l :: lines' => images p Ms l && all_images Ms all' lines'
  | _, [] => false
  end.
End Images.

Definition vector_nonnegative : zvec -> bool := forallb (Z.leb 0).
Definition all_nonnegative (F : family) (all : list point) : bool :=
  forallb (forallb vector_nonnegative) (matrices F) &&
  forallb (fun p => vector_nonnegative (fst p) && match snd p with [] => true | _ => false end) all.

(* Weights are over `scale`, those of units over `one`. *)
Definition polytope (F : family) (u : Q) (nonnegative : bool) (scale one : Z) (all : list point)
    (unit_lines : list (list term)) (image_lines : list (list (list term))) : bool :=
  let ps := number 1 all in
  (0 <? scale) && (0 <=? Qnum u) && (if nonnegative then all_nonnegative F all else true) &&
  Nat.eqb (length unit_lines) (size F) &&
  match units nonnegative ps one 0 unit_lines with
  | None => false
  | Some (s, r) => (r <? one) && all_images nonnegative ps scale one (denominator F) s r u (matrices F) all image_lines
  end.

(* ---- why that proves the bound --------------------------------------------------------------------------------- *)

Lemma zmodulus_bound a b : (modulus (IZR a) (IZR b) <= IZR (zmodulus a b))%R.
Proof.
  unfold zmodulus. destruct (Z.eqb_spec b 0) as [->|N].
  - rewrite modulus_real, abs_IZR. lra.
  - assert (P : 0 < a * a + b * b) by nia. apply Z.sqrt_up_spec in P. destruct P as [_ P].
    assert (S := Z.sqrt_up_nonneg (a * a + b * b)).
    apply IZR_le in P, S. rewrite !plus_IZR, !mult_IZR in P.
    set (m := IZR (Z.sqrt_up (a * a + b * b))) in *.
    unfold modulus. rewrite <- (sqrt_Rsqr m) by auto. apply sqrt_le_1; unfold Rsqr; nra.
Qed.

Lemma zmodulus_nonneg a b : 0 <= zmodulus a b.
Proof. unfold zmodulus. destruct (b =? 0). lia. apply Z.sqrt_up_nonneg. Qed.

Lemma norm1_nonneg x : 0 <= norm1 x.
Proof. induction x; simpl; lia. Qed.

Lemma vector_nonnegative_nth x i : vector_nonnegative x = true -> 0 <= nth i x 0.
Proof.
  unfold vector_nonnegative. rewrite forallb_forall. intros H.
  destruct (nth_in_or_default i x 0) as [I | ->]; [|lia]. apply H in I. lia.
Qed.

(* Each listed point is one for which the bound is to be shown, or at most eps from one. *)
Section Near.
Variables (n count : nat) (T : nat -> mat) (P : vec -> vec -> Prop) (ps : points) (eps : R).
Let comb := combination n count T P.
Hypothesis Eps : (0 <= eps)%R.
Hypothesis Near : forall i p, PositiveMap.find i ps = Some p -> comb (vr (fst p)) (vr (snd p)) 1%R eps.

Lemma combine_near ts : forall w x y, combine ps ts = Some (w, (x, y)) -> comb (vr x) (vr y) (IZR w) (IZR w * eps)%R /\ 0 <= w.
Proof.
  induction ts as [|[i [a b]] ts IH]; intros w x y H; cbn [combine] in H.
  - inversion H; subst. rewrite vr_nil. split; [|lia]. rewrite Rmult_0_l. apply combination_zero.
  - destruct (PositiveMap.find i ps) as [[x1 y1]|] eqn:E; [|discriminate].
    destruct (combine ps ts) as [[w1 [u v]]|]; [|discriminate].
    destruct (IH _ _ _ eq_refl) as [C Hw].
    assert (D := combination_plus n count T P _ _ _ _ _ _ _ _ (combination_mult n count T P (IZR a) (IZR b) _ _ _ _ (Near _ _ E)) C).
    cbn [fst snd] in D.
    assert (M := zmodulus_bound a b). assert (Mn := zmodulus_nonneg a b).
    assert (Le : (modulus (IZR a) (IZR b) * 1 + IZR w1 <= IZR (zmodulus a b + w1))%R) by (rewrite plus_IZR; lra).
    assert (Le' : (modulus (IZR a) (IZR b) * eps + IZR w1 * eps <= IZR (zmodulus a b + w1) * eps)%R).
    { rewrite plus_IZR, <- Rmult_plus_distr_r. apply Rmult_le_compat_r; auto. lra. }
    destruct (Z.eqb_spec b 0) as [->|N]; inversion H; subst; split; try lia; rewrite !vr_addmul; (eapply combination_le; [|apply Le|apply Le']).
    + replace (plus (scal (IZR a) (vr x1)) (vr u)) with (plus (plus (scal (IZR a) (vr x1)) (scal (- 0) (vr y1))) (vr u)).
      replace (plus (scal (IZR a) (vr y1)) (vr v)) with (plus (plus (scal (IZR a) (vr y1)) (scal 0 (vr x1))) (vr v)).
      exact D.
      1, 2: extensionality j; unfold plus, scal; lra.
    + rewrite opp_IZR.
      replace (plus (scal (IZR a) (vr x1)) (plus (scal (- IZR b) (vr y1)) (vr u)))
        with (plus (plus (scal (IZR a) (vr x1)) (scal (- IZR b) (vr y1))) (vr u)).
      replace (plus (scal (IZR a) (vr y1)) (plus (scal (IZR b) (vr x1)) (vr v)))
        with (plus (plus (scal (IZR a) (vr y1)) (scal (IZR b) (vr x1))) (vr v)).
      exact D.
      1, 2: extensionality j; unfold plus, scal; lra.
Qed.

Lemma line_near scale divisor tx ty ts w r : 0 <= divisor -> line false ps scale divisor (tx, ty) ts = Some (w, r) ->
  comb (scal (IZR scale) (vr tx)) (scal (IZR scale) (vr ty)) (IZR (divisor * w)) (IZR r + IZR (divisor * w) * eps)%R /\ 0 <= w /\ 0 <= r.
Proof.
  intros HD H. unfold line in H. simpl fst in H. simpl snd in H.
  destruct (combine ps ts) as [[w' [x y]]|] eqn:E; [|discriminate].
  destruct (combine_near ts _ _ _ E) as [C Hw].
  set (u := addmul (- divisor) x (addmul scale tx [])) in *.
  set (v := addmul (- divisor) y (addmul scale ty [])) in *.
  apply (combination_scal n count T P (IZR divisor)) in C.
  rewrite Rabs_pos_eq, <- Rmult_assoc, <- mult_IZR in C by (apply IZR_le; auto).
  assert (Eu : scal (IZR scale) (vr tx) = plus (scal (IZR divisor) (vr x)) (vr u)).
  { unfold u. rewrite !vr_addmul, vr_nil, opp_IZR. extensionality i. unfold plus, scal, zero. lra. }
  assert (Ev : scal (IZR scale) (vr ty) = plus (scal (IZR divisor) (vr y)) (vr v)).
  { unfold v. rewrite !vr_addmul, vr_nil, opp_IZR. extensionality i. unfold plus, scal, zero. lra. }
  inversion H; subst w' r. assert (P1 := norm1_nonneg u). assert (P2 := norm1_nonneg v). split; [|split; lia].
  rewrite Eu, Ev. apply (combination_rest n count T P _ _ (vr u) (vr v)) in C.
  eapply combination_le. exact C. apply Rle_refl. rewrite plus_IZR.
  assert (N1 := norm_norm1 n u). assert (N2 := norm_norm1 n v). lra.
Qed.

(* Of cones only a bound is a combination. *)
Lemma addmul_nil c x y : addmul c x y = [] -> x = [] /\ y = [].
Proof. destruct x, y; simpl; intros H; try discriminate; auto. Qed.

Lemma line_cone scale divisor tx ty ts w r : 0 <= divisor -> line true ps scale divisor (tx, ty) ts = Some (w, r) ->
  ty = [] /\ 0 <= w /\ 0 <= r /\ exists y, comb y zero (IZR (divisor * w)) (IZR r + IZR (divisor * w) * eps)%R /\
  forall i, (IZR scale * vr tx i <= y i)%R.
Proof.
  intros HD H. unfold line in H. simpl fst in H. simpl snd in H.
  destruct (combine ps ts) as [[w' [x y]]|] eqn:E; [|discriminate].
  destruct (combine_near ts _ _ _ E) as [C Hw].
  set (u := addmul (- divisor) x (addmul scale tx [])) in *.
  destruct (addmul (- divisor) y (addmul scale ty [])) eqn:EV; [|discriminate].
  apply addmul_nil in EV. destruct EV as [-> EV]. apply addmul_nil in EV. destruct EV as [-> _].
  inversion H; subst w' r. clear H. split; auto. split; auto. split. apply norm1_nonneg.
  apply (combination_scal n count T P (IZR divisor)) in C.
  rewrite Rabs_pos_eq, <- Rmult_assoc, <- mult_IZR in C by (apply IZR_le; auto).
  apply (combination_rest n count T P _ _ (vr (positive_part u)) zero) in C. rewrite norm_zero, vr_nil in C.
  replace (plus (scal (IZR divisor) zero) zero) with zero in C by (extensionality i; unfold plus, scal, zero; lra).
  exists (plus (scal (IZR divisor) (vr x)) (vr (positive_part u))). split.
  - eapply combination_le. exact C. apply Rle_refl. assert (N := norm_norm1 n (positive_part u)). lra.
  - intros i. assert (Eu : (IZR scale * vr tx i = IZR divisor * vr x i + vr u i)%R).
    { unfold u. rewrite !vr_addmul, vr_nil, opp_IZR. unfold plus, scal, zero. lra. }
    rewrite Eu. unfold plus, scal. apply Rplus_le_compat_l.
    unfold vr. assert (Q : nth i (positive_part u) 0 = Z.max 0 (nth i u 0)) by exact (map_nth (Z.max 0) u 0 i).
    rewrite Q. apply IZR_le. lia.
Qed.

Lemma units_near nonnegative one lines : 0 < one ->
  (forall k ts w t, line nonnegative ps one 1 (unit_at 1 k, []) ts = Some (w, t) ->
     comb (scal (IZR one) (vr (unit_at 1 k))) (scal (IZR one) (vr [])) (IZR (1 * w)) (IZR t + IZR (1 * w) * eps)%R /\ 0 <= w /\ 0 <= t) ->
  forall k s r, units nonnegative ps one k lines = Some (s, r) -> 0 <= s /\ 0 <= r /\
  forall j, (k <= j < k + length lines)%nat -> comb (unit j) zero (IZR s / IZR one)%R ((IZR r + IZR s * eps) / IZR one)%R.
Proof.
  intros Ho HL. induction lines as [|ts lines IH]; intros k s r H; cbn [units] in H.
  - inversion H; subst. split; [lia|]. split; [lia|]. simpl. intros; lia.
  - destruct (line nonnegative ps one 1 (unit_at 1 k, []) ts) as [[w t]|] eqn:E; [|discriminate].
    destruct (units nonnegative ps one (S k) lines) as [[s' r']|] eqn:EU; [|discriminate].
    destruct (IH _ _ _ EU) as [Hs [Hr HI]]. inversion H; subst. clear H.
    split; [lia|]. split; [lia|]. intros j Hj.
    assert (O : (0 < IZR one)%R) by (apply IZR_lt; auto).
    assert (O' : (0 < / IZR one)%R) by (apply Rinv_0_lt_compat; auto).
    assert (More : forall a b c d, a <= Z.max a b /\ b <= Z.max a b /\ c <= Z.max c d /\ d <= Z.max c d) by (intros; lia).
    assert (Sum : forall a b c d, a <= c -> b <= d -> (/ IZR one * (IZR b + IZR a * eps) <= (IZR d + IZR c * eps) / IZR one)%R).
    { intros a b c d H1 H2. apply IZR_le in H1, H2. unfold Rdiv. rewrite Rmult_comm. apply Rmult_le_compat_r. lra.
      assert (IZR a * eps <= IZR c * eps)%R by (apply Rmult_le_compat_r; auto). lra. }
    destruct (Nat.eq_dec j k) as [->|N].
    + apply HL in E. destruct E as [C [Hw Ht]]. apply (combination_scal n count T P (/ IZR one)) in C.
      rewrite Rabs_pos_eq in C by lra. rewrite Z.mul_1_l in C.
      eapply combination_le.
      * replace (unit k) with (scal (/ IZR one) (scal (IZR one) (vr (unit_at 1 k)))).
        replace zero with (scal (/ IZR one) (scal (IZR one) (vr []))). exact C.
        -- rewrite vr_nil. extensionality i. unfold scal, zero. lra.
        -- rewrite vr_unit. extensionality i. unfold scal. field. lra.
      * unfold Rdiv. rewrite Rmult_comm. apply Rmult_le_compat_r. lra. apply IZR_le. lia.
      * apply Sum; lia.
    + eapply combination_le. apply HI. simpl in Hj. lia.
      unfold Rdiv; apply Rmult_le_compat_r; [lra|]; apply IZR_le; lia.
      assert (S := Sum s' r' (Z.max w s') (Z.max t r') ltac:(lia) ltac:(lia)). unfold Rdiv. rewrite Rmult_comm. auto.
Qed.
End Near.

Section Polytope.
Variables (F : family) (nonnegative : bool) (ps : points).
Hypothesis WF : well_formed F = true.
Let n := size F.
Let T := real F.

Definition Point (x y : vec) : Prop := exists i p, PositiveMap.find i ps = Some p /\ x = vr (fst p) /\ y = vr (snd p).
Let comb := combination n (count F) T Point.

Lemma point_alone i p : PositiveMap.find i ps = Some p -> comb (vr (fst p)) (vr (snd p)) 1%R 0%R.
Proof. intros E. apply combination_alone. exists i, p. auto. Qed.

Hypothesis Nonnegative : nonnegative = true ->
  (forall t, (t < count F)%nat -> forall i j, (0 <= T t i j)%R) /\ (forall x y, Point x y -> y = zero /\ forall i, (0 <= x i)%R).

Lemma line_sound scale divisor tx ty ts w r : 0 <= divisor ->
  line nonnegative ps scale divisor (tx, ty) ts = Some (w, r) ->
  (nonnegative = true -> vr ty = zero /\ forall i, (0 <= IZR scale * vr tx i)%R) ->
  comb (scal (IZR scale) (vr tx)) (scal (IZR scale) (vr ty)) (IZR (divisor * w)) (IZR r) /\ 0 <= w /\ 0 <= r.
Proof.
  intros HD H HN. destruct nonnegative.
  - destruct (line_cone n (count F) T Point ps 0 (Rle_refl 0) point_alone scale divisor tx ty ts w r HD H) as [_ [Hw [Hr [y [C Hy]]]]].
    split; [|split; auto]. destruct (HN eq_refl) as [Ty Tx]. destruct (Nonnegative eq_refl) as [HT _].
    rewrite Ty. replace (scal (IZR scale) zero) with zero by (extensionality i; unfold scal, zero; lra).
    eapply combination_below; [exact HT| |eapply combination_le; [exact C|apply Rle_refl|lra]].
    intros i Hi. split. apply Tx. apply Hy.
  - destruct (line_near n (count F) T Point ps 0 (Rle_refl 0) point_alone scale divisor tx ty ts w r HD H) as [C [Hw Hr]].
    split; auto. eapply combination_le. exact C. apply Rle_refl. lra.
Qed.

Lemma units_sound one lines : 0 < one -> forall k s r, units nonnegative ps one k lines = Some (s, r) -> 0 <= s /\ 0 <= r /\
  forall j, (k <= j < k + length lines)%nat -> comb (unit j) zero (IZR s / IZR one) (IZR r / IZR one).
Proof.
  intros Ho k s r H. destruct (units_near n (count F) T Point ps 0 (Rle_refl 0) nonnegative one lines Ho) with (k := k) (s := s) (r := r) as [Hs [Hr C]]; auto.
  - intros j ts w t HL. destruct (line_sound one 1 (unit_at 1 j) [] ts w t ltac:(lia) HL) as [D [Hw Ht]].
    + intros _. split. apply vr_nil. intros i. rewrite vr_unit. unfold scal, unit, identity. apply IZR_lt in Ho. destruct (Nat.eqb i j); lra.
    + split; auto. eapply combination_le. exact D. apply Rle_refl. lra.
  - split; auto. split; auto. intros j Hj. eapply combination_le. apply C; auto. apply Rle_refl. right. f_equal. lra.
Qed.

Section Bound.
Variables (scale one s r : Z) (u : Q).
Hypothesis Scale : 0 < scale.
Hypothesis One : 0 <= r < one.
Hypothesis S0 : 0 <= s.

Definition image_bounded (x y : vec) (t : nat) : Prop := exists a b,
  comb (apply n (T t) x) (apply n (T t) y) a b /\ (0 <= b /\
  a + b * (IZR s / IZR one / (1 - IZR r / IZR one)) <= real_of u)%R.

Lemma image_sound x y t ts w b : (t < count F)%nat ->
  (nonnegative = true -> vr y = zero /\ forall i, (0 <= vr x i)%R) ->
  line nonnegative ps scale (denominator F) (mv (letter F t) x, mv (letter F t) y) ts = Some (w, b) ->
  Zpos (Qden u) * (w * denominator F * (one - r) + b * s) <= Qnum u * scale * denominator F * (one - r) ->
  image_bounded (vr x) (vr y) t.
Proof.
  intros Ht HN HL HB. assert (D := denominator_positive F WF).
  assert (D' : 0 < denominator F) by (apply lt_IZR; auto).
  assert (Sc : (0 < IZR scale)%R) by (apply IZR_lt; auto).
  apply line_sound in HL; [|lia|].
  - destruct HL as [C [Hw Hb]].
    apply (combination_scal n (count F) T Point (/ (IZR scale * IZR (denominator F)))) in C.
    assert (I : (0 < / (IZR scale * IZR (denominator F)))%R) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; auto).
    rewrite Rabs_pos_eq in C by lra. rewrite !vr_letter in C by auto.
    exists (/ (IZR scale * IZR (denominator F)) * IZR (denominator F * w))%R, (/ (IZR scale * IZR (denominator F)) * IZR b)%R.
    split; [|split].
    + replace (apply n (T t) (vr x)) with (scal (/ (IZR scale * IZR (denominator F))) (scal (IZR scale) (scal (IZR (denominator F)) (apply n (T t) (vr x))))).
      replace (apply n (T t) (vr y)) with (scal (/ (IZR scale * IZR (denominator F))) (scal (IZR scale) (scal (IZR (denominator F)) (apply n (T t) (vr y))))).
      exact C.
      all: extensionality i; unfold scal; field; lra.
    + apply Rmult_le_pos. lra. apply IZR_le; auto.
    + unfold real_of.
      assert (O : (0 < IZR one - IZR r)%R) by (rewrite <- minus_IZR; apply IZR_lt; lia).
      assert (O1 : (0 < IZR one)%R) by (apply IZR_lt; lia).
      assert (Q0 : (0 < IZR (Zpos (Qden u)))%R) by (apply IZR_lt; lia).
      apply IZR_le in HB. repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR in HB. rewrite mult_IZR.
      set (d := IZR (denominator F)) in *. set (o := IZR one) in *. set (rr := IZR r) in *. set (q := IZR (Zpos (Qden u))) in *.
      set (sc := IZR scale) in *.
      apply (Rmult_le_reg_r (q * (sc * d * (o - rr)))).
      { repeat apply Rmult_lt_0_compat; auto. }
      replace (IZR (Qnum u) / q * (q * (sc * d * (o - rr))))%R with (IZR (Qnum u) * sc * d * (o - rr))%R by (field; lra).
      eapply Rle_trans; [|apply HB]. right. field. repeat split; lra.
  - intros N. destruct (HN N) as [Y X]. destruct (Nonnegative N) as [HT _].
    rewrite !vr_letter by auto. rewrite Y, apply_zero. split. extensionality i; unfold scal, zero; lra.
    intros i. apply Rmult_le_pos. lra. apply Rmult_le_pos. lra. apply sum_nonneg; intros. apply Rmult_le_pos; auto.
Qed.

Lemma images_sound x y Ms lines : (nonnegative = true -> vr y = zero /\ forall i, (0 <= vr x i)%R) ->
  images nonnegative ps scale one (denominator F) s r u (x, y) Ms lines = true ->
  forall t off, (off + length Ms = count F)%nat -> (forall k, nth k Ms [] = letter F (off + k)%nat) -> (off <= t < count F)%nat ->
  image_bounded (vr x) (vr y) t.
Proof.
  intros HN. revert lines. induction Ms as [|M Ms IH]; intros lines H t off Hl HM Ht. simpl in Hl; lia.
  destruct lines as [|ts lines]; [discriminate|]. cbn [images] in H.
  destruct (line _ _ _ _ _ _) as [[w b]|] eqn:E in H; [|discriminate].
  apply andb_prop in H. destruct H as [H1 H2]. simpl in E.
  destruct (Nat.eq_dec t off) as [->|N].
  - apply (image_sound x y off ts w b); auto. lia.
    specialize (HM 0%nat). simpl in HM. rewrite Nat.add_0_r in HM. rewrite <- HM. exact E. lia.
  - apply (IH lines H2 t (S off)); auto. simpl in Hl; lia. intros k. specialize (HM (S k)). simpl in HM.
    replace (S off + k)%nat with (off + S k)%nat by lia. auto. lia.
Qed.

Lemma all_images_sound all : forall lines,
  all_images nonnegative ps scale one (denominator F) s r u (matrices F) all lines = true ->
  (nonnegative = true -> forall x y, In (x, y) all -> vr y = zero /\ forall i, (0 <= vr x i)%R) ->
  forall x y t, In (x, y) all -> (t < count F)%nat -> image_bounded (vr x) (vr y) t.
Proof.
  induction all as [|p all IH]; intros lines H HN x y t HI Ht. destruct HI.
  destruct lines as [|l lines]; [discriminate|]. cbn [all_images] in H.
  apply andb_prop in H. destruct H as [H1 H2]. destruct HI as [->|HI].
  - apply (images_sound x y (matrices F) l) with (off := 0%nat); auto.
    intros N. apply (HN N x y). left; auto. lia.
  - apply (IH lines); auto. intros N a b Hab. apply (HN N a b). right; auto.
Qed.
End Bound.
End Polytope.

Lemma number_in {A : Type} (all : list A) : forall k i p, PositiveMap.find i (number k all) = Some p -> In p all.
Proof.
  induction all; intros k i p H; simpl in H. rewrite PositiveMap.gempty in H. discriminate.
  destruct (Pos.eq_dec i k) as [->|N].
  - rewrite PositiveMap.gss in H. inversion H. left; auto.
  - rewrite PositiveMap.gso in H by auto. right. eapply IHall; eauto.
Qed.

Lemma all_nonnegative_matrices F : well_formed F = true -> forall all, all_nonnegative F all = true ->
  forall t, (t < count F)%nat -> forall i j, (0 <= real F t i j)%R.
Proof.
  intros WF all H t Ht i j. assert (D := denominator_positive F WF). unfold all_nonnegative in H. apply andb_prop in H. destruct H as [HM _].
  rewrite forallb_forall in HM. unfold real. apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat; auto].
  apply IZR_le. unfold entry. assert (I : In (letter F t) (matrices F)) by (apply nth_In; auto).
  apply HM in I. rewrite forallb_forall in I.
  destruct (nth_in_or_default i (letter F t) []) as [J | ->]; [|rewrite nth_nil; lia].
  apply vector_nonnegative_nth, I; auto.
Qed.

Theorem polytope_sound F u nonnegative scale one all unit_lines image_lines : well_formed F = true ->
  polytope F u nonnegative scale one all unit_lines image_lines = true ->
  radius_at_most (size F) (count F) (real F) (real_of u).
Proof.
  intros WF H. unfold polytope in H.
  apply andb_prop in H. destruct H as [H H5]. apply andb_prop in H. destruct H as [H H4].
  apply andb_prop in H. destruct H as [H H3]. apply andb_prop in H. destruct H as [H1 H2].
  apply Z.ltb_lt in H1. apply Z.leb_le in H2. apply Nat.eqb_eq in H4.
  set (ps := number 1 all) in *.
  destruct (units nonnegative ps one 0 unit_lines) as [[s r]|] eqn:EU; [|discriminate].
  apply andb_prop in H5. destruct H5 as [H5 H6]. apply Z.ltb_lt in H5.
  assert (D := denominator_positive F WF).
  assert (N0 : nonnegative = true -> (forall t, (t < count F)%nat -> forall i j, (0 <= real F t i j)%R) /\
    forall x y, In (x, y) all -> vr y = zero /\ forall i, (0 <= vr x i)%R).
  { intros ->. split. apply (all_nonnegative_matrices F WF all H3). apply andb_prop in H3. destruct H3 as [_ HP]. rewrite forallb_forall in HP.
    intros x y I. apply HP in I. simpl in I. apply andb_prop in I. destruct I as [I1 I2].
      destruct y; [|discriminate]. split. apply vr_nil. intros i. apply IZR_le, vector_nonnegative_nth; auto. }
  assert (N1 : nonnegative = true -> (forall t, (t < count F)%nat -> forall i j, (0 <= real F t i j)%R) /\
    forall x y, Point ps x y -> y = zero /\ forall i, (0 <= x i)%R).
  { intros N. destruct (N0 N) as [A B]. split; auto. intros x y [i [[x1 y1] [E [-> ->]]]]. apply number_in in E. apply B; auto. }
  assert (Hr : 0 <= r /\ 0 <= s).
  { clear - EU. revert s r EU. generalize 0%nat. induction unit_lines as [|ts l IH]; intros k s r E; cbn [units] in E.
    inversion E; lia.
    destruct (line _ _ _ _ _ _) as [[w t]|]; [|discriminate].
    destruct (units nonnegative ps one (S k) l) as [[s' r']|] eqn:E2; [|discriminate].
    destruct (IH _ _ _ E2). inversion E. lia. }
  assert (Ho : 0 < one) by lia.
  destruct (units_sound F nonnegative ps N1 one unit_lines Ho _ _ _ EU) as [_ [_ HU]].
  assert (O1 : (0 < IZR one)%R) by (apply IZR_lt; auto).
  apply grows_radius, (polytope_bound (size F) (count F) (real F) (Point ps)
    (fold_right (fun p a => IZR (norm1 (fst p) + norm1 (snd p)) + a)%R 0%R all) (IZR s / IZR one) (IZR r / IZR one)).
  - clear. induction all; simpl. lra. apply Rplus_le_le_0_compat; auto. apply IZR_le.
    assert (P1 := norm1_nonneg (fst a)). assert (P2 := norm1_nonneg (snd a)). lia.
  - apply Rmult_le_pos. apply IZR_le; lia. left; apply Rinv_0_lt_compat; auto.
  - split. apply Rmult_le_pos. apply IZR_le; lia. left; apply Rinv_0_lt_compat; auto.
    apply (Rmult_lt_reg_r (IZR one)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_l, Rmult_1_r by lra. apply IZR_lt; lia.
  - unfold real_of. apply Rmult_le_pos. apply IZR_le; auto. left; apply Rinv_0_lt_compat. apply IZR_lt; lia.
  - intros x y [i [p [E [-> ->]]]]. apply number_in in E.
    assert (Hc : (cnorm (size F) (vr (fst p)) (vr (snd p)) <= IZR (norm1 (fst p) + norm1 (snd p)))%R).
    { rewrite plus_IZR. assert (A := norm_norm1 (size F) (fst p)). assert (B := norm_norm1 (size F) (snd p)).
      eapply Rle_trans; [|apply Rplus_le_compat; [apply A|apply B]].
      unfold cnorm, norm. rewrite <- sum_plus. apply sum_le; intros.
      assert (M := modulus_triangle (vr (fst p) i0) 0 0 (vr (snd p) i0)).
      rewrite Rplus_0_r, Rplus_0_l, modulus_real, modulus_imaginary in M. auto. }
    eapply Rle_trans. apply Hc. clear - E. induction all as [|a all IH]; [destruct E|].
    assert (P : forall l : list point, (0 <= fold_right (fun p a => IZR (norm1 (fst p) + norm1 (snd p)) + a) 0 l)%R).
    { induction l; simpl. lra. apply Rplus_le_le_0_compat; auto. apply IZR_le.
      assert (P1 := norm1_nonneg (fst a0)). assert (P2 := norm1_nonneg (snd a0)). lia. }
    simpl. destruct E as [->|E]. specialize (P all). lra.
    specialize (IH E). assert (0 <= IZR (norm1 (fst a) + norm1 (snd a)))%R.
    { apply IZR_le. assert (P1 := norm1_nonneg (fst a)). assert (P2 := norm1_nonneg (snd a)). lia. } lra.
  - intros k Hk. apply HU. lia.
  - intros x y t [i [[x1 y1] [E [-> ->]]]] Ht. apply number_in in E.
    destruct (all_images_sound F nonnegative ps WF N1 scale one s r u H1 ltac:(lia) all image_lines H6
      ltac:(intros N; apply (N0 N)) x1 y1 t E Ht) as [a [b [C [B1 B2]]]].
    exists a, b. auto.
Qed.
