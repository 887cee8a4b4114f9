(* What the joint spectral subradius of a family without negative entries is exactly, Theorem 32 of SPEC.md: the eigenvector
   of a product and images of it, known from below and up to factors, climb at the rate of the product. *)
Require Import Reals List ZArith QArith FMapPositive Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Lower Integers Sections Eigenvalue Check Subradius Complex Number Attained Exact.
Import ListNotations.
Open Scope Z_scope.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

(* Why an image climbs: it is the number times another true vertex, or it is above a combination of the given ones. *)
Inductive rise := Reaches (i : positive) | Exceeds (ts : list term).

(* A given vertex v, for the true one V that the word leads to from the eigenvector: v <= V <= D v, D over `factor_scale`. The
   origin is the vertex that its first letter leads to it from. *)
Record peak := Peak { peak_given : zvec; peak_factor : Z; peak_word : list nat; peak_origin : positive; peak_rises : list rise }.

(* The first true vertex is a multiple of the eigenvector; `beside` are positive numbers where that is 0, which its product
   makes no larger than the power of the number. *)
Record ascent := Ascent {
  ascent_transposed : bool; eigenvector_base : base; eigenvector_multiple : Q; beside : zvec; ascent_scale : Z; factor_scale : Z;
  peaks : list peak }.

Section Checker.
Variables (F : family) (e : exact_number) (h : place) (a : ascent).
Let n := size F.
Let D := denominator F.
Let ys := vectors (eigenvector_base a).

Definition eigenvector_word : list nat := match previous (eigenvector_base a) with Some (_, (w, _)) => w | None => [] end.

Definition at_eigenvector (v : zvec) (d : Z) : bool :=
  let '((u, _), off) := evaluate n (near_scale h) (near_re h) (near_im h) (near_radius h) ys in
  forallb (fun i =>
    let x := Zpos (Qden (eigenvector_multiple a)) * nth i v 0 in
    if x =? 0 then forallb (fun y => nth i (fst y) 0 =? 0) ys
    else (x <=? Qnum (eigenvector_multiple a) * (nth i u 0 - off)) &&
         (factor_scale a * Qnum (eigenvector_multiple a) * (nth i u 0 + off) <=? d * x)) (seq 0 n).

Definition beside_right (v : zvec) : bool :=
  let moved := zrun (matrices F) eigenvector_word (beside a) in
  let low_power := (low h * D) ^ Z.of_nat (root e) in let bottom_power := bottom h ^ Z.of_nat (root e) in
  forallb (fun i =>
    let x := nth i (beside a) 0 in
    if nth i v 0 =? 0 then (0 <? x) && (bottom_power * nth i moved 0 <=? low_power * x) else x =? 0) (seq 0 n).

(* From y the letter leads to x. *)
Definition follows (x y : peak) (t : nat) : bool :=
  let moved := mv (letter F t) (peak_given y) in
  forallb (fun i =>
    let v := nth i (peak_given x) 0 in let above := bottom h * nth i moved 0 in
    (high h * D * v <=? above) && (peak_factor y * above <=? peak_factor x * (low h * D * v))) (seq 0 n).

Section Peaks.
Variables (known : PositiveMap.t peak) (ps : points) (most : Z).

Definition peak_right (x : peak) : bool :=
  vector_nonnegative (peak_given x) && (length (peak_given x) <=? n)%nat && (0 <? norm1 (peak_given x)) &&
  match peak_word x with
  | [] => at_eigenvector (peak_given x) (peak_factor x)
  | t :: w =>
      match PositiveMap.find (peak_origin x) known with
      | Some y => Nat.ltb t (count F) && same_word w (peak_word y) && follows x y t
      | None => false
      end
  end.

Definition rise_right (x : peak) (t : nat) (i : rise) : bool :=
  match i with
  | Reaches j =>
      match PositiveMap.find j known with
      | Some y =>
          let w := t :: peak_word x in
          same_word w (peak_word y) || (same_word w eigenvector_word && same_word [] (peak_word y))
      | None => false
      end
  | Exceeds ts =>
      image_above F ps (ascent_scale a) (high h * most # Z.to_pos (bottom h * factor_scale a)) (peak_given x) (letter F t) ts
  end.
End Peaks.

Definition check_ascent : bool :=
  let most := largest_of (map peak_factor (peaks a)) in
  let known := number 1 (peaks a) in
  let ps := number 1 (map (fun x => (peak_given x, [])) (peaks a)) in
  all_nonnegative F [] && (0 <? ascent_scale a) && (0 <? factor_scale a) && (0 <? most) && (0 <? Qnum (eigenvector_multiple a)) &&
  negb (conjugated (eigenvector_base a)) && forallb (fun y => vanishes (snd y)) ys &&
  base_right F (polynomial e) (root e) [eigenvector_base a] (eigenvector_base a) &&
  match previous (eigenvector_base a), peaks a with
  | Some _, x :: _ => same_word [] (peak_word x) && beside_right (peak_given x)
  | _, _ => false
  end &&
  forallb (fun x => peak_right known x && paired (rise_right known ps most x) (seq 0 (count F)) (peak_rises x)) (peaks a).
End Checker.

Definition check_exact_subradius (F : family) (e : exact_number) (lower upper : option Q) (h : place) (a : ascent)
    (bounds : subradius_certificate) : bool :=
  well_formed F && check_number e h && positive_zero e h && check_ascent (if ascent_transposed a then transpose F else F) e h a &&
  check_subradius (Claim F lower upper) bounds.

(* The joint spectral subradius is the number. *)
Definition exact_subradius_holds (F : family) (e : exact_number) (lower upper : option Q) : Prop :=
  one_number e /\ exists r, is_number e r /\ is_subradius (size F) (count F) (real F) r /\ within lower upper r.

(* ---- why that proves the claim ----------------------------------------------------------------------------------- *)

Open Scope R_scope.

(* The upper end: of the vector that is V where V is not 0, and small elsewhere *)
Lemma eigenvector_bound n count T v V X r : (forall t, (t < count)%nat -> forall i j, 0 <= T t i j) -> letters count v -> v <> [] ->
  0 <= r -> run n T v V = scal (r ^ length v) V ->
  (forall i, (i < n)%nat -> 1 <= V i /\ X i = 0 \/ V i = 0 /\ 1 <= X i /\ run n T v X i <= r ^ length v * X i) ->
  subradius_at_most n count T r.
Proof.
  intros HT Hv Nv Hr HV HX s Hs. set (m := (r + s) / 2). assert (Hm : r < m < s) by (unfold m; lra).
  set (L := length v) in *. assert (HL : (0 < L)%nat). { unfold L. destruct v; [congruence|simpl; lia]. }
  assert (P : r ^ L < m ^ L).
  { destruct (Rle_lt_dec (m ^ L) (r ^ L)) as [B|]; auto. apply (pow_le_reg _ _ L) in B; auto; lra. }
  set (K := norm n (run n T v X)). assert (HK : 0 <= K) by apply norm_nonneg.
  set (eta := m ^ L - r ^ L). assert (He : 0 < eta) by (unfold eta; lra).
  set (tau := eta / (1 + K)). assert (Ht : 0 < tau) by (apply Rdiv_lt_0_compat; lra).
  assert (Et : tau * (1 + K) = eta) by (unfold tau; field; lra).
  set (W := plus V (scal tau X)).
  assert (Low : exists c, 0 < c /\ forall i, (i < n)%nat -> 1 <= c * W i).
  { exists (1 + / tau). assert (I : 0 < / tau) by (apply Rinv_0_lt_compat; auto). split. lra.
    intros i Hi. unfold W, plus, scal. destruct (HX i Hi) as [[A B]|[A [B _]]].
    - rewrite B. nra.
    - rewrite A. assert (E : / tau * tau = 1) by (field; lra). assert (X i = / tau * tau * X i) by (rewrite E; ring).
      assert (0 < tau * X i) by (apply Rmult_lt_0_compat; lra). nra. }
  destruct Low as [c [Hc Low]].
  apply (slow_product_bound n count T HT v (scal c W) (m ^ L) m); auto; try lra.
  - apply pow_le; lra.
  - intros i Hi. rewrite run_scal. unfold scal. replace (m ^ L * (c * W i)) with (c * (m ^ L * W i)) by ring.
    apply Rmult_le_compat_l. lra. unfold W. rewrite run_plus, run_scal, HV. unfold plus, scal. fold L.
    assert (B : run n T v X i <= K). { eapply Rle_trans. apply Rle_abs. apply (norm_term n); auto. }
    replace (m ^ L) with (r ^ L + eta) by (unfold eta; ring).
    destruct (HX i Hi) as [[A Z]|[A [Z M]]].
    + rewrite Z. assert (tau * run n T v X i <= tau * K) by (apply Rmult_le_compat_l; lra).
      assert (eta * 1 <= eta * V i) by (apply Rmult_le_compat_l; lra). lra.
    + rewrite A. fold L in M. assert (tau * run n T v X i <= tau * (r ^ L * X i)) by (apply Rmult_le_compat_l; lra).
      assert (0 <= eta * (tau * X i)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). lra.
  - apply Rle_refl.
Qed.

Section Sound.
Variables (F : family) (e : exact_number) (h : place) (a : ascent) (z : complex) (r : R).
Let n := size F.
Let D := IZR (denominator F).
Let T := real F.
Let L := root e.
Hypothesis WF : well_formed F = true.
Hypothesis Zero : value (polynomial e) z = real_number 0.
Hypothesis Scale : (0 < near_scale h)%Z.
Hypothesis Small : (0 <= near_radius h)%Z.
Hypothesis Near_re : Rabs (fst z - IZR (near_re h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h).
Hypothesis Near_im : Rabs (snd z - IZR (near_im h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h).
Hypothesis Positive : z = real_number (r ^ L).
Hypothesis Radius : 0 < r.
Hypothesis Length : (0 < L)%nat.
Hypothesis Low : (0 < low h)%Z.
Hypothesis Common : (0 < bottom h)%Z.
Hypothesis Between : IZR (low h) / IZR (bottom h) <= r <= IZR (high h) / IZR (bottom h).
Hypothesis Accepted : check_ascent F e h a = true.

Let b := eigenvector_base a.
Let v := eigenvector_word a.
Let V0 : vec := fst (horner z (vectors b)).
Let U : vec := scal (real_of (eigenvector_multiple a)) V0.
Let known := number 1 (peaks a).
Let ps : points := number 1 (map (fun x => (peak_given x, [])) (peaks a)).
Let most := largest_of (map peak_factor (peaks a)).

(* The true vertex that a word leads to *)
Definition true_peak (w : list nat) : vec := scal (/ r ^ length w) (run n T w U).

Lemma true_peak_step t w : apply n (T t) (true_peak w) = scal r (true_peak (t :: w)).
Proof.
  unfold true_peak. rewrite apply_scal. cbn [run length pow]. extensionality i. unfold scal. field.
  split; [apply pow_nonzero|]; lra.
Qed.

Lemma accepted_parts :
  (forall t, (t < count F)%nat -> forall i j, 0 <= T t i j) /\ (0 < ascent_scale a)%Z /\ (0 < factor_scale a)%Z /\ (0 < most)%Z /\
  (0 < Qnum (eigenvector_multiple a))%Z /\ conjugated b = false /\ (forall y, In y (vectors b) -> vr (snd y) = zero) /\
  (letters (count F) v /\ length v = L /\ run n T v U = scal (r ^ L) U) /\
  (exists x, In x (peaks a) /\ peak_word x = [] /\ beside_right F e h a (peak_given x) = true) /\
  (forall x, In x (peaks a) -> peak_right F h a known x = true /\
     forall t, (t < count F)%nat -> exists i, rise_right F h a known ps most x t i = true).
Proof.
  assert (H := Accepted). unfold check_ascent in H. cbv zeta in H. fold known b most in H. fold ps in H.
  repeat rewrite andb_true_iff in H. destruct H as [[[[[[[[[H1 H2] H3] H4] HM] H5] H6] H7] H8] H9].
  apply Z.ltb_lt in H2, H3, H4, HM. apply negb_true_iff in H5. rewrite forallb_forall in H6, H9.
  split. apply (all_nonnegative_matrices F WF []); auto. split; auto. split; auto. split; auto. split; auto. split; auto. split.
  { intros y I. apply vanishes_spec; auto. }
  destruct (previous b) as [[k [w seed]]|] eqn:E; [|discriminate].
  assert (Ev : v = w) by (unfold v, eigenvector_word; fold b; rewrite E; auto).
  split.
  { assert (R : forallb (base_right F (polynomial e) (root e) [b]) [b] = true) by (simpl; rewrite H7; auto).
    destruct k as [|k]. 2:{ unfold base_right in H7. rewrite E in H7. destruct k; discriminate. }
    destruct (base_step F (polynomial e) (root e) z WF Zero [b] R 0 b 0 w seed eq_refl E) as [S1 [S2 [S3 _]]].
    rewrite Ev. split; auto. split; auto. unfold true_base, zero_for in S3. cbn [nth_error] in S3. rewrite H5 in S3. fold V0 n T in S3.
    unfold U. rewrite run_scal, S3, Positive. unfold turn_re, real_number. cbn [fst snd]. vectors. ring. }
  split.
  { destruct (peaks a) as [|x l]; [discriminate|]. apply andb_prop in H8. destruct H8 as [B1 B2]. apply same_word_spec in B1.
    exists x. split. left; auto. split; auto. }
  intros x I. specialize (H9 x I). apply andb_prop in H9. destruct H9 as [P1 P2]. split; auto.
  intros t Ht. apply (paired_spec _ _ _ P2). apply in_seq. lia.
Qed.

Lemma eigenvector_near u0 u1 off : evaluate n (near_scale h) (near_re h) (near_im h) (near_radius h) (vectors b) = ((u0, u1), off) ->
  forall i, (i < n)%nat -> Rabs (V0 i - vr u0 i) <= IZR off.
Proof.
  intros E i Hi. destruct (evaluate_sound n _ _ _ _ z Scale Small Near_re Near_im _ _ _ E) as [_ B].
  unfold distance_pair in B. cbn [fst snd] in B. fold V0 in B.
  assert (N := norm_nonneg n (sub (snd (horner z (vectors b))) (vr u1))).
  assert (Q := norm_term n (sub V0 (vr u0)) i Hi). unfold sub in Q at 1. lra.
Qed.

Lemma eigenvector_zero i : (forall y, In y (vectors b) -> nth i (fst y) 0%Z = 0%Z) -> V0 i = 0.
Proof.
  unfold V0. rewrite Positive, horner_first. induction (vectors b) as [|y l IH]; intros H; simpl. auto.
  unfold plus, scal, vr. rewrite IH by (intros; apply H; right; auto). rewrite H by (left; auto). simpl. ring.
Qed.

(* v <= V <= D v *)
Definition between_peak (x : peak) : Prop := letters (count F) (peak_word x) /\ forall i, (i < n)%nat ->
  vr (peak_given x) i <= true_peak (peak_word x) i /\
  IZR (factor_scale a) * true_peak (peak_word x) i <= IZR (peak_factor x) * vr (peak_given x) i.

Lemma peaks_between : forall k x, In x (peaks a) -> (length (peak_word x) <= k)%nat -> between_peak x.
Proof.
  destruct accepted_parts as [HT [_ [Hf [_ [Hm [_ [_ [_ [_ All]]]]]]]]].
  assert (Fp : 0 < IZR (factor_scale a)) by (apply IZR_lt; auto). assert (Dp := denominator_positive F WF). fold D in Dp.
  assert (Bp : 0 < IZR (bottom h)) by (apply IZR_lt; auto). assert (Lp : 0 < IZR (low h)) by (apply IZR_lt; auto).
  induction k as [k IH] using lt_wf_ind. intros x I Hk. destruct (All x I) as [P _]. unfold peak_right in P.
  repeat rewrite andb_true_iff in P. destruct P as [[[P1 _] _] P]. unfold between_peak.
  destruct (peak_word x) as [|t w] eqn:E.
  - split. constructor. intros i Hi. unfold at_eigenvector in P. fold n b in P.
    destruct (evaluate n _ _ _ _ (vectors b)) as [[u0 u1] off] eqn:EV.
    assert (Near := eigenvector_near u0 u1 off EV i Hi). rewrite forallb_forall in P. specialize (P i ltac:(apply in_seq; lia)). cbv zeta in P.
    replace (true_peak []) with U by (unfold true_peak; vectors; simpl; field).
    set (q := IZR (Zpos (Qden (eigenvector_multiple a)))) in *. assert (Qp : 0 < q) by (apply IZR_lt; lia).
    set (p := IZR (Qnum (eigenvector_multiple a))) in *. assert (Pp : 0 < p) by (apply IZR_lt; auto).
    assert (EU : q * U i = p * V0 i). { unfold U, scal, real_of. fold p q. field. lra. }
    unfold vr. destruct (Z.eqb_spec (Zpos (Qden (eigenvector_multiple a)) * nth i (peak_given x) 0)%Z 0) as [Q|Q].
    + assert (Z0 : nth i (peak_given x) 0%Z = 0%Z) by lia. rewrite Z0. rewrite eigenvector_zero in EU.
      2:{ intros y Iy. rewrite forallb_forall in P. apply Z.eqb_eq; auto. }
      assert (E0 : U i = 0) by (apply (Rmult_eq_reg_l q); lra). rewrite E0. simpl. lra.
    + apply andb_prop in P. destruct P as [A B]. apply Z.leb_le, IZR_le in A. apply Z.leb_le, IZR_le in B.
      rewrite !mult_IZR, minus_IZR in A. rewrite !mult_IZR, plus_IZR in B. fold p q in A, B. unfold vr in Near. rewrite abs_le in Near.
      set (x0 := IZR (nth i (peak_given x) 0%Z)) in *. set (u := IZR (nth i u0 0%Z)) in *.
      assert (A' : p * (u - IZR off) <= p * V0 i) by (apply Rmult_le_compat_l; lra).
      assert (B' : p * V0 i <= p * (u + IZR off)) by (apply Rmult_le_compat_l; lra).
      split; apply (Rmult_le_reg_l q); auto. lra.
      apply (Rmult_le_compat_l (IZR (factor_scale a))) in B'; [|lra]. rewrite <- EU in B'. lra.
  - destruct (PositiveMap.find (peak_origin x) known) as [y|] eqn:Ey; [|discriminate]. apply number_in in Ey.
    repeat rewrite andb_true_iff in P. destruct P as [[Ht Hw] P]. apply Nat.ltb_lt in Ht. apply same_word_spec in Hw.
    cbn [length] in Hk. destruct (IH (length w) ltac:(lia) y Ey ltac:(subst w; auto)) as [Ly By]. rewrite <- Hw in Ly, By.
    split. constructor; auto. intros i Hi. unfold follows in P. fold n in P. rewrite forallb_forall in P. specialize (P i ltac:(apply in_seq; lia)).
    cbv zeta in P. apply andb_prop in P. destruct P as [A B]. apply Z.leb_le, IZR_le in A. apply Z.leb_le, IZR_le in B. rewrite !mult_IZR in A. rewrite !mult_IZR in B. fold D in A, B.
    assert (Mv : IZR (nth i (mv (letter F t) (peak_given y)) 0%Z) = D * apply n (T t) (vr (peak_given y)) i).
    { change (vr (mv (letter F t) (peak_given y)) i = D * apply n (T t) (vr (peak_given y)) i). rewrite vr_letter by auto. reflexivity. }
    rewrite Mv in A, B. change (IZR (nth i (peak_given x) 0%Z)) with (vr (peak_given x) i) in A, B.
    assert (Step := f_equal (fun f => f i) (true_peak_step t w)). cbv beta in Step. unfold scal in Step.
    assert (Up : apply n (T t) (vr (peak_given y)) i <= apply n (T t) (true_peak w) i).
    { apply sum_le. intros j Hj. apply Rmult_le_compat_l. apply HT; auto. apply By; auto. }
    assert (Down : IZR (factor_scale a) * apply n (T t) (true_peak w) i <= IZR (peak_factor y) * apply n (T t) (vr (peak_given y)) i).
    { unfold apply. rewrite <- !sum_scal. apply sum_le. intros j Hj. assert (Q := proj2 (By j Hj)). assert (H0 := HT t Ht i j).
      apply (Rmult_le_compat_l _ _ _ H0) in Q. lra. }
    set (m := apply n (T t) (vr (peak_given y)) i) in *. set (V := true_peak (t :: w) i) in *. set (x0 := vr (peak_given x) i) in *.
    assert (X0 : 0 <= x0) by (apply vector_nonnegative_vr; auto). rewrite Step in Up, Down. destruct Between as [B1 B2].
    assert (B1' : IZR (low h) <= r * IZR (bottom h)).
    { apply (Rmult_le_compat_r (IZR (bottom h))) in B1; [|lra]. unfold Rdiv in B1. rewrite Rmult_assoc, Rinv_l in B1; lra. }
    assert (B2' : r * IZR (bottom h) <= IZR (high h)).
    { apply (Rmult_le_compat_r (IZR (bottom h))) in B2; [|lra]. unfold Rdiv in B2. rewrite Rmult_assoc, Rinv_l in B2; lra. }
    assert (M0 : 0 <= m). { apply sum_nonneg. intros j Hj. apply Rmult_le_pos. apply HT; auto.
      destruct (All y Ey) as [Py _]. unfold peak_right in Py. repeat rewrite andb_true_iff in Py. apply vector_nonnegative_vr. apply Py. }
    split.
    + (* HIGH x0 <= m <= r V *)
      assert (Q : r * IZR (bottom h) * D * x0 <= r * IZR (bottom h) * D * V).
      { apply Rle_trans with (IZR (high h) * D * x0). apply Rmult_le_compat_r; auto. apply Rmult_le_compat_r; lra.
        eapply Rle_trans. apply A. replace (r * IZR (bottom h) * D * V) with (IZR (bottom h) * (D * (r * V))) by ring.
        apply Rmult_le_compat_l. lra. apply Rmult_le_compat_l; lra. }
      apply (Rmult_le_reg_l (r * IZR (bottom h) * D)); auto. repeat apply Rmult_lt_0_compat; auto.
    + (* factor r V <= D_y m <= D_x LOW x0 <= D_x r x0 *)
      assert (Dx : 0 <= IZR (peak_factor x) * x0).
      { assert (Q : 0 <= IZR (factor_scale a) * (r * V)) by (apply Rmult_le_pos; [lra|]; eapply Rle_trans; [apply M0|apply Up]).
        assert (Q2 : 0 <= IZR (bottom h) * D * (IZR (peak_factor y) * m)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]).
        apply (Rmult_le_reg_l (IZR (low h) * D)). apply Rmult_lt_0_compat; auto. lra. }
      assert (Q : IZR (bottom h) * D * r * (IZR (factor_scale a) * V) <= IZR (bottom h) * D * r * (IZR (peak_factor x) * x0)).
      { replace (IZR (bottom h) * D * r * (IZR (factor_scale a) * V)) with (IZR (bottom h) * D * (IZR (factor_scale a) * (r * V))) by ring.
        apply Rle_trans with (IZR (bottom h) * D * (IZR (peak_factor y) * m)). apply Rmult_le_compat_l; auto. apply Rmult_le_pos; lra.
        apply Rle_trans with (IZR (low h) * D * (IZR (peak_factor x) * x0)). lra.
        replace (IZR (bottom h) * D * r * (IZR (peak_factor x) * x0)) with (r * IZR (bottom h) * D * (IZR (peak_factor x) * x0)) by ring.
        apply Rmult_le_compat_r; auto. apply Rmult_le_compat_r; lra. }
      apply (Rmult_le_reg_l (IZR (bottom h) * D * r)); auto. repeat apply Rmult_lt_0_compat; auto.
Qed.

Lemma ascent_at_least : subradius_at_least n (count F) T r.
Proof.
  destruct accepted_parts as [HT [Hs [Hf [Hm [_ [_ [_ [[Lv [Ll Hv]] [[x0 [I0 [E0 _]]] All]]]]]]]]].
  assert (Fp : 0 < IZR (factor_scale a)) by (apply IZR_lt; auto). assert (Mp : 0 < IZR most) by (apply IZR_lt; auto).
  assert (Bp : 0 < IZR (bottom h)) by (apply IZR_lt; auto).
  assert (Btw : forall x, In x (peaks a) -> between_peak x) by (intros x I; apply (peaks_between (length (peak_word x))); auto).
  set (Point := fun V : vec => exists x, In x (peaks a) /\ V = true_peak (peak_word x)).
  apply (growing_bound n (count F) T Point (true_peak (peak_word x0))).
  - lra.
  - exists x0. auto.
  - intros V [x [I ->]]. destruct (All x I) as [P _]. unfold peak_right in P. repeat rewrite andb_true_iff in P. destruct P as [[[P1 P2] P3] _].
    apply Nat.leb_le in P2. apply Z.ltb_lt in P3. assert (N := norm1_sum (peak_given x) n P2).
    apply Rle_trans with (IZR (norm1 (peak_given x))). apply IZR_le, (Z.le_succ_l 0), P3.
    rewrite N. apply sum_le; intros i Hi. rewrite Rabs_pos_eq by (apply vector_nonnegative_vr; auto). apply (Btw x I); auto.
  - intros V t w c [x [I ->]] Ht Hw Hc HP. destruct (All x I) as [_ Q]. destruct (Q t Ht) as [i Hi]. clear Q.
    destruct (Btw x I) as [Lx Bx]. destruct i as [j|ts]; unfold rise_right in Hi.
    + destruct (PositiveMap.find j known) as [y|] eqn:E; [|discriminate]. apply number_in in E.
      assert (V : apply n (T t) (true_peak (peak_word x)) = scal r (true_peak (peak_word y))).
      { rewrite true_peak_step. f_equal. cbv zeta in Hi. apply orb_prop in Hi. destruct Hi as [Hi|Hi].
        - apply same_word_spec in Hi. rewrite Hi. auto.
        - apply andb_prop in Hi. destruct Hi as [H1 H2]. apply same_word_spec in H1, H2. rewrite <- H2, H1. fold v.
          unfold true_peak. rewrite Hv, Ll. vectors. simpl. field. apply pow_nonzero; lra. }
      rewrite V, run_scal. unfold scal. rewrite sum_scal. apply Rmult_le_compat_l. lra. apply HP. exists y. auto.
    + apply Rle_trans with (sum n (run n T w (apply n (T t) (vr (peak_given x))))).
      2:{ apply sum_le. apply (run_monotone n (count F) T HT); auto. intros i Hi'. apply sum_le. intros j Hj.
          apply Rmult_le_compat_l. apply HT; auto. apply Bx; auto. }
      assert (Fm : 0 < IZR (factor_scale a) / IZR most) by (apply Rdiv_lt_0_compat; auto).
      set (l := (high h * most # Z.to_pos (bottom h * factor_scale a))%Q) in Hi.
      assert (C := image_above_sound F ps (ascent_scale a) l (peak_given x) t ts w (c * (IZR (factor_scale a) / IZR most)) WF HT Hs Ht Hw
        ltac:(apply Rmult_le_pos; lra)).
      eapply Rle_trans; [|apply C; [|apply Hi]].
      * assert (Qp : (0 < bottom h * factor_scale a)%Z) by (apply Z.mul_pos_pos; auto).
        unfold l. rewrite real_of_low, !mult_IZR by auto.
        replace (IZR (high h) * IZR most / (IZR (bottom h) * IZR (factor_scale a)) * (c * (IZR (factor_scale a) / IZR most)))
          with (IZR (high h) / IZR (bottom h) * c) by (field; lra).
        apply Rmult_le_compat_r; lra.
      * intros i q E. unfold ps in E. apply number_in, in_map_iff in E. destruct E as [y [<- E]]. cbn [fst].
        destruct (Btw y E) as [_ By].
        assert (G : IZR (factor_scale a) * sum n (run n T w (true_peak (peak_word y))) <= IZR most * sum n (run n T w (vr (peak_given y)))).
        { rewrite <- !sum_scal. apply sum_le. intros k Hk.
          assert (R := run_monotone n (count F) T HT w (scal (IZR (factor_scale a)) (true_peak (peak_word y))) (scal (IZR most) (vr (peak_given y))) Hw).
          rewrite !run_scal in R. unfold scal in R. apply R; auto. intros j Hj. eapply Rle_trans. apply (By j Hj).
          apply Rmult_le_compat_r. destruct (All y E) as [P _]. unfold peak_right in P. repeat rewrite andb_true_iff in P. apply vector_nonnegative_vr; tauto.
          apply IZR_le. apply (largest_of_bound peak_factor); auto. }
        assert (Hy := HP (true_peak (peak_word y)) ltac:(exists y; auto)).
        apply (Rmult_le_compat_l (IZR (factor_scale a))) in Hy; [|lra].
        apply (Rmult_le_reg_l (IZR most)); auto.
        replace (IZR most * (c * (IZR (factor_scale a) / IZR most))) with (IZR (factor_scale a) * c) by (field; lra).
        exact (Rle_trans _ _ _ Hy G).
Qed.

Lemma ascent_at_most : subradius_at_most n (count F) T r.
Proof.
  destruct accepted_parts as [HT [_ [_ [_ [_ [_ [_ [[Lv [Ll Hv]] [[x [I [E B]]] All]]]]]]]]].
  destruct (peaks_between 0 x I ltac:(rewrite E; auto)) as [_ Bx]. rewrite E in Bx. destruct (All x I) as [P _]. unfold peak_right in P.
  repeat rewrite andb_true_iff in P. destruct P as [[[P1 _] _] P]. rewrite E in P.
  assert (Bp : 0 < IZR (bottom h)) by (apply IZR_lt; auto). assert (Dp := denominator_positive F WF). fold D in Dp.
  assert (ET : true_peak [] = U) by (unfold true_peak; vectors; simpl; field).
  apply (eigenvector_bound n (count F) T v U (vr (beside a)) r); auto.
  - intros N. rewrite N in Ll. simpl in Ll. lia.
  - lra.
  - rewrite Ll. auto.
  - intros i Hi. unfold beside_right in B. cbv zeta in B. fold n v in B. rewrite forallb_forall in B. specialize (B i ltac:(apply in_seq; lia)).
    cbv zeta in B. destruct (Bx i Hi) as [B1 B2]. rewrite ET in B1, B2. destruct (Z.eqb_spec (nth i (peak_given x) 0%Z) 0) as [Q|Q].
    + right. unfold vr in B1, B2 at 1. rewrite Q in B1, B2. assert (Fp : 0 < IZR (factor_scale a)). { destruct accepted_parts as [_ [_ [H _]]]. apply IZR_lt; auto. }
      apply andb_prop in B. destruct B as [X1 X2]. apply Z.ltb_lt in X1. apply Z.leb_le, IZR_le in X2. split. nra. split.
      * unfold vr. apply IZR_le. lia.
      * change (IZR (bottom h ^ Z.of_nat (root e) * nth i (zrun (matrices F) v (beside a)) 0%Z) <=
          IZR ((low h * denominator F) ^ Z.of_nat (root e) * nth i (beside a) 0%Z)) in X2.
        rewrite !mult_IZR, <- !pow_IZR, mult_IZR in X2. fold L D in X2.
        change (IZR (nth i (zrun (matrices F) v (beside a)) 0%Z)) with (vr (zrun (matrices F) v (beside a)) i) in X2.
        rewrite (vr_zrun F WF) in X2 by auto. fold D n T in X2. unfold scal in X2. rewrite Ll, Rpow_mult_distr in *.
        change (IZR (nth i (beside a) 0%Z)) with (vr (beside a) i) in X2.
        assert (X0 : 0 <= vr (beside a) i) by (apply IZR_le; lia).
        assert (DL : 0 < D ^ L) by (apply pow_lt; auto). assert (BL : 0 < IZR (bottom h) ^ L) by (apply pow_lt; auto).
        assert (R : IZR (low h) ^ L <= IZR (bottom h) ^ L * r ^ L).
        { rewrite <- Rpow_mult_distr. apply pow_incr. split. apply IZR_le; lia.
          destruct Between as [R1 _]. apply (Rmult_le_compat_r (IZR (bottom h))) in R1; [|lra]. unfold Rdiv in R1. rewrite Rmult_assoc, Rinv_l in R1; lra. }
        apply (Rmult_le_reg_l (IZR (bottom h) ^ L * D ^ L)). apply Rmult_lt_0_compat; auto.
        eapply Rle_trans; [|eapply Rle_trans; [apply X2|]]. right; ring.
        replace (IZR (bottom h) ^ L * D ^ L * (r ^ L * vr (beside a) i)) with (IZR (bottom h) ^ L * r ^ L * D ^ L * vr (beside a) i) by ring.
        apply Rmult_le_compat_r; auto. apply Rmult_le_compat_r; lra.
    + left. apply Z.eqb_eq in B. split. eapply Rle_trans; [|apply B1]. unfold vr. apply IZR_le.
      assert (0 <= nth i (peak_given x) 0)%Z by (apply vector_nonnegative_nth; auto). lia.
      unfold vr. rewrite B. auto.
Qed.
End Sound.

(* What the checker accepts is true. *)
Theorem check_exact_subradius_sound F e lower upper h a bounds : check_exact_subradius F e lower upper h a bounds = true ->
  exact_subradius_holds F e lower upper.
Proof.
  unfold check_exact_subradius. intros H. repeat rewrite andb_true_iff in H. destruct H as [[[[WF HN] HP] HA] HB].
  destruct (check_number_sound e h HN) as [S [Rho [HL [Hlow [Hcom [z [r [Iz [Uz [N1 [N2 [R0 [Rp B]]]]]]]]]]]]].
  assert (Sc : (0 < near_scale h)%Z) by (apply lt_IZR; auto).
  assert (Sm : (0 <= near_radius h)%Z).
  { apply le_IZR. apply (Rmult_le_reg_r (/ IZR (near_scale h))). apply Rinv_0_lt_compat; auto. unfold Rdiv in Rho. lra. }
  assert (Pz := positive_zero_sound e h z HP S Iz Uz N1). rewrite <- Rp in Pz.
  assert (Both : forall G, well_formed G = true -> check_ascent G e h a = true -> is_subradius (size G) (count G) (real G) r).
  { intros G W A. split. lra. split.
    - apply (ascent_at_most G e h a z r); auto. apply Iz.
    - apply (ascent_at_least G e h a z r); auto. apply Iz. }
  assert (Is : is_subradius (size F) (count F) (real F) r).
  { destruct (ascent_transposed a); auto.
    destruct (Both (transpose F) (transpose_well_formed F WF) HA) as [X [Up Down]]. split; auto. split.
    - intros s Hs. apply transpose_slow. apply Up; auto.
    - intros s Hs G. apply Down; auto. apply transpose_slow in G. exact G. }
  split. exists z. auto. exists r. split. split; auto. exists z; auto. split; auto.
  apply (check_subradius_sound _ _ HB r Is).
Qed.
