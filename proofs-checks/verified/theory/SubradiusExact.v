(* What the joint spectral subradius of a family without negative entries is exactly, Theorem 32 of SPEC.md: the eigenvector
   of a product and images of it, known from below and up to factors, climb at the rate of the product. *)
Require Import Reals List ZArith QArith FMapPositive Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Lower Integers Sections Eigenvalue Check Subradius Complex Number Attained Exact.
Import ListNotations.
Open Scope Z_scope.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

(* Why an image climbs: it is at least the number times the true vertex that stems from it; or that times the first one, as
   the cycle closes; or that times another one, as each coordinate is equal, because both stem from the eigenvector by words made
   longer by so many turns, or clearly more; or it is above a combination of the given ones. *)
Inductive rise := Reaches (i : positive) | Closes | Passes (i : positive) (turns turns' : nat) | Exceeds (ts : list term).

(* A given vertex v, for a true one V with v <= V <= D v, D over `factor_scale`: a multiple of the eigenvector, or where v is
   not 0 the image of that of the origin under the first letter of the word, over the number. `peak_whole` says that nothing
   was cut off: it is an image of the eigenvector by the word. *)
Record peak := Peak {
  peak_given : zvec; peak_factor : Z; peak_whole : bool; peak_word : list nat; peak_origin : positive; peak_rises : list rise }.

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
    if v =? 0 then negb (peak_whole x) || (nth i moved 0 =? 0)
    else (high h * D * v <=? above) && (peak_factor y * above <=? peak_factor x * (low h * D * v))) (seq 0 n).

Section Peaks.
Variables (known : PositiveMap.t peak) (ps : points) (most : Z).

Definition peak_right (x : peak) : bool :=
  vector_nonnegative (peak_given x) && (length (peak_given x) <=? n)%nat && (0 <? norm1 (peak_given x)) &&
  match peak_word x with
  | [] => at_eigenvector (peak_given x) (peak_factor x)
  | t :: w =>
      match PositiveMap.find (peak_origin x) known with
      | Some y => Nat.ltb t (count F) && same_word w (peak_word y) && implb (peak_whole x) (peak_whole y) && follows x y t
      | None => false
      end
  end.

(* Image t of x is at least the number times y. *)
Definition passes (x : peak) (t turns : nat) (y : peak) (turns' : nat) : bool :=
  let moved := mv (letter F t) (peak_given x) in
  let equal :=
    if peak_whole x && peak_whole y then equal_at F [eigenvector_base a] 0 (t :: peak_word x) turns 0 (peak_word y) turns'
    else fun _ => false in
  forallb (fun i => equal i ||
    (high h * D * most * nth i (peak_given y) 0 <=? bottom h * factor_scale a * nth i moved 0)) (seq 0 n).

(* x is number k *)
Definition rise_right (k : positive) (x : peak) (t : nat) (i : rise) : bool :=
  match i with
  | Reaches j =>
      match PositiveMap.find j known with
      | Some y => Pos.eqb (peak_origin y) k && match peak_word y with s :: _ => Nat.eqb s t | [] => false end
      | None => false
      end
  | Closes => peak_whole x && same_word (t :: peak_word x) eigenvector_word
  | Passes j turns turns' => match PositiveMap.find j known with Some y => passes x t turns y turns' | None => false end
  | Exceeds ts =>
      image_above F ps (ascent_scale a) (high h * most # Z.to_pos (bottom h * factor_scale a)) (peak_given x) (letter F t) ts
  end.

Fixpoint all_right (k : positive) (xs : list peak) : bool :=
  match xs with
  | [] => true
  | x :: xs' => peak_right x && paired (rise_right k x) (seq 0 (count F)) (peak_rises x) && all_right (Pos.succ k) xs'
  end.
End Peaks.

Definition check_ascent : bool :=
  let most := largest_of (map peak_factor (peaks a)) in
  let known := number 1 (peaks a) in
  let ps := number 1 (map (fun x => (peak_given x, [])) (peaks a)) in
  all_nonnegative F [] && (0 <? ascent_scale a) && (0 <? factor_scale a) && (0 <? most) && (0 <? Qnum (eigenvector_multiple a)) &&
  negb (conjugated (eigenvector_base a)) &&
  base_right F (polynomial e) (root e) [eigenvector_base a] (eigenvector_base a) &&
  match previous (eigenvector_base a), peaks a with
  | Some _, x :: _ => same_word [] (peak_word x) && beside_right (peak_given x)
  | _, _ => false
  end &&
  all_right known ps most 1 (peaks a).
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

Lemma number_map {A B : Type} (f : A -> B) xs : forall k i,
  PositiveMap.find i (number k (map f xs)) = option_map f (PositiveMap.find i (number k xs)).
Proof.
  induction xs as [|x xs IH]; intros k i; cbn [map number]. rewrite !PositiveMap.gempty. auto.
  destruct (Pos.eq_dec i k) as [->|N]. rewrite !PositiveMap.gss. auto. rewrite !PositiveMap.gso by auto. apply IH.
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

(* The true vertex that a word leads to, if nothing is cut off *)
Definition true_peak (w : list nat) : vec := scal (/ r ^ length w) (run n T w U).

Definition cut_to (x : zvec) (V : vec) : vec := fun i => if (nth i x 0 =? 0)%Z then 0 else V i.

(* V is a true vertex for x. *)
Inductive stands : peak -> vec -> Prop :=
| stands_first x : peak_word x = [] -> stands x U
| stands_next x t w y V : peak_word x = t :: w -> PositiveMap.find (peak_origin x) known = Some y -> stands y V ->
    stands x (cut_to (peak_given x) (scal (/ r) (apply n (T t) V))).

Lemma all_right_spec ks qs most0 : forall xs k, all_right F h a ks qs most0 k xs = true ->
  forall i x, PositiveMap.find i (number k xs) = Some x -> peak_right F h a ks x = true /\
  forall t, (t < count F)%nat -> exists j, rise_right F h a ks qs most0 i x t j = true.
Proof.
  induction xs as [|x0 xs IH]; intros k H i x E; cbn [number] in E. rewrite PositiveMap.gempty in E. discriminate.
  cbn [all_right] in H. apply andb_prop in H. destruct H as [H H3]. apply andb_prop in H. destruct H as [H1 H2].
  destruct (Pos.eq_dec i k) as [->|N].
  - rewrite PositiveMap.gss in E. inversion E; subst. split; auto. intros t Ht. apply (paired_spec _ _ _ H2). apply in_seq. lia.
  - rewrite PositiveMap.gso in E by auto. apply (IH _ H3); auto.
Qed.

Lemma accepted_parts :
  (forall t, (t < count F)%nat -> forall i j, 0 <= T t i j) /\ (0 < ascent_scale a)%Z /\ (0 < factor_scale a)%Z /\ (0 < most)%Z /\
  (0 < Qnum (eigenvector_multiple a))%Z /\ conjugated b = false /\ forallb (base_right F (polynomial e) (root e) [b]) [b] = true /\
  (letters (count F) v /\ length v = L /\ run n T v U = scal (r ^ L) U) /\
  (exists x, PositiveMap.find 1%positive known = Some x /\ peak_word x = [] /\ beside_right F e h a (peak_given x) = true) /\
  (forall k x, PositiveMap.find k known = Some x -> peak_right F h a known x = true /\
     forall t, (t < count F)%nat -> exists i, rise_right F h a known ps most k x t i = true).
Proof.
  assert (H := Accepted). unfold check_ascent in H. cbv zeta in H. fold known b most in H. fold ps in H.
  repeat rewrite andb_true_iff in H. destruct H as [[[[[[[[H1 H2] H3] H4] HM] H5] H7] H8] H9].
  apply Z.ltb_lt in H2, H3, H4, HM. apply negb_true_iff in H5.
  assert (R : forallb (base_right F (polynomial e) (root e) [b]) [b] = true) by (simpl; rewrite H7; auto).
  split. apply (all_nonnegative_matrices F WF []); auto. do 5 (split; [auto|]). split; auto.
  destruct (previous b) as [[k [w seed]]|] eqn:E; [|discriminate].
  assert (Ev : v = w) by (unfold v, eigenvector_word; fold b; rewrite E; auto).
  split.
  { destruct k as [|k]. 2:{ unfold base_right in H7. rewrite E in H7. destruct k; discriminate. }
    destruct (base_step F (polynomial e) (root e) z WF Zero [b] R 0 b 0 w seed eq_refl E) as [S1 [S2 [S3 _]]].
    rewrite Ev. split; auto. split; auto. unfold true_base, zero_for in S3. cbn [nth_error] in S3. rewrite H5 in S3. fold V0 n T in S3.
    unfold U. rewrite run_scal, S3, Positive. unfold turn_re, real_number. cbn [fst snd]. vectors. ring. }
  split.
  { unfold known. destruct (peaks a) as [|x l]; [discriminate|]. apply andb_prop in H8. destruct H8 as [B1 B2]. apply same_word_spec in B1.
    exists x. split. apply PositiveMap.gss. split; auto. }
  apply (all_right_spec known ps most (peaks a) 1); auto.
Qed.

Lemma eigenvector_near u0 u1 off :
  evaluate n (near_scale h) (near_re h) (near_im h) (near_radius h) (vectors b) = ((u0, u1), off) ->
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

Lemma near_number : IZR (low h) <= r * IZR (bottom h) <= IZR (high h).
Proof.
  assert (Bp : 0 < IZR (bottom h)) by (apply IZR_lt; auto). destruct Between as [B1 B2]. split.
  - apply (Rmult_le_compat_r (IZR (bottom h))) in B1; [|lra]. unfold Rdiv in B1. rewrite Rmult_assoc, Rinv_l in B1; lra.
  - apply (Rmult_le_compat_r (IZR (bottom h))) in B2; [|lra]. unfold Rdiv in B2. rewrite Rmult_assoc, Rinv_l in B2; lra.
Qed.

(* What is known of a vertex and of a true one for it *)
Definition between_peak (x : peak) (V : vec) : Prop := letters (count F) (peak_word x) /\
  (forall i, (i < n)%nat -> vr (peak_given x) i <= V i /\ IZR (factor_scale a) * V i <= IZR (peak_factor x) * vr (peak_given x) i) /\
  (peak_whole x = true -> forall i, (i < n)%nat -> V i = true_peak (peak_word x) i).

Lemma first_between x : peak_right F h a known x = true -> peak_word x = [] -> between_peak x U.
Proof.
  intros P E. destruct accepted_parts as [_ [_ [Hf [_ [Hm _]]]]].
  assert (Fp : 0 < IZR (factor_scale a)) by (apply IZR_lt; auto).
  unfold peak_right in P. rewrite E in P. repeat rewrite andb_true_iff in P. destruct P as [_ P].
  assert (ET : true_peak [] = U) by (unfold true_peak; vectors; simpl; field).
  unfold between_peak. rewrite E, ET. split. constructor. split; auto. intros i Hi. unfold at_eigenvector in P. fold n b in P.
  destruct (evaluate n _ _ _ _ (vectors b)) as [[u0 u1] off] eqn:EV.
  assert (Near := eigenvector_near u0 u1 off EV i Hi). rewrite forallb_forall in P. specialize (P i ltac:(apply in_seq; lia)). cbv zeta in P.
  set (q := IZR (Zpos (Qden (eigenvector_multiple a)))) in *. assert (Qp : 0 < q) by (apply IZR_lt; lia).
  set (p := IZR (Qnum (eigenvector_multiple a))) in *. assert (Pp : 0 < p) by (apply IZR_lt; auto).
  assert (EU : q * U i = p * V0 i). { unfold U, scal, real_of. fold p q. field. lra. }
  unfold vr. destruct (Z.eqb_spec (Zpos (Qden (eigenvector_multiple a)) * nth i (peak_given x) 0)%Z 0) as [Q|Q].
  - assert (Z0 : nth i (peak_given x) 0%Z = 0%Z) by lia. rewrite Z0. rewrite eigenvector_zero in EU.
    2:{ intros y Iy. rewrite forallb_forall in P. apply Z.eqb_eq; auto. }
    assert (E0 : U i = 0) by (apply (Rmult_eq_reg_l q); lra). rewrite E0. simpl. lra.
  - apply andb_prop in P. destruct P as [A B]. apply Z.leb_le, IZR_le in A. apply Z.leb_le, IZR_le in B.
    rewrite !mult_IZR, minus_IZR in A. rewrite !mult_IZR, plus_IZR in B. fold p q in A, B. unfold vr in Near. rewrite abs_le in Near.
    set (x0 := IZR (nth i (peak_given x) 0%Z)) in *. set (u := IZR (nth i u0 0%Z)) in *.
    assert (A' : p * (u - IZR off) <= p * V0 i) by (apply Rmult_le_compat_l; lra).
    assert (B' : p * V0 i <= p * (u + IZR off)) by (apply Rmult_le_compat_l; lra).
    split; apply (Rmult_le_reg_l q); auto. lra.
    apply (Rmult_le_compat_l (IZR (factor_scale a))) in B'; [|lra]. rewrite <- EU in B'. lra.
Qed.

Lemma peak_nonnegative k x i : PositiveMap.find k known = Some x -> 0 <= vr (peak_given x) i.
Proof.
  intros E. destruct accepted_parts as [_ [_ [_ [_ [_ [_ [_ [_ [_ All]]]]]]]]]. destruct (All k x E) as [P _].
  unfold peak_right in P. repeat rewrite andb_true_iff in P. apply vector_nonnegative_vr. apply P.
Qed.

Lemma vr_moved t x i : (t < count F)%nat -> IZR (nth i (mv (letter F t) x) 0%Z) = D * apply n (T t) (vr x) i.
Proof. intros Ht. change (vr (mv (letter F t) x) i = D * apply n (T t) (vr x) i). rewrite vr_letter by auto. reflexivity. Qed.

Lemma apply_at_most t x y i : (t < count F)%nat -> (forall j, (j < n)%nat -> x j <= y j) -> apply n (T t) x i <= apply n (T t) y i.
Proof.
  intros Ht H. destruct accepted_parts as [HT _]. apply sum_le. intros j Hj. apply Rmult_le_compat_l. apply HT; auto. auto.
Qed.

Lemma next_between k l x t w y V : PositiveMap.find k known = Some x -> peak_word x = t :: w ->
  PositiveMap.find (peak_origin x) known = Some y -> l = peak_origin x -> between_peak y V ->
  (t < count F)%nat /\ between_peak x (cut_to (peak_given x) (scal (/ r) (apply n (T t) V))).
Proof.
  intros Ex E Ey _ [Ly [By Wy]]. destruct accepted_parts as [HT [_ [Hf [_ [_ [_ [_ [_ [_ All]]]]]]]]].
  assert (Fp : 0 < IZR (factor_scale a)) by (apply IZR_lt; auto). assert (Dp := denominator_positive F WF). fold D in Dp.
  assert (Bp : 0 < IZR (bottom h)) by (apply IZR_lt; auto). assert (Lp : 0 < IZR (low h)) by (apply IZR_lt; auto).
  destruct (All k x Ex) as [P _]. unfold peak_right in P. rewrite E, Ey in P. repeat rewrite andb_true_iff in P.
  destruct P as [_ [[[Ht Hw] Hwhole] P]]. apply Nat.ltb_lt in Ht. apply same_word_spec in Hw. split; auto.
  unfold between_peak. rewrite E. split. { constructor; auto. rewrite Hw. auto. }
  assert (Each : forall i, (i < n)%nat -> let m := apply n (T t) (vr (peak_given y)) i in let x0 := vr (peak_given x) i in
    (nth i (peak_given x) 0%Z = 0%Z /\ (peak_whole x = true -> m = 0)) \/ (nth i (peak_given x) 0%Z <> 0%Z /\
    IZR (high h) * D * x0 <= IZR (bottom h) * (D * m) /\
    IZR (peak_factor y) * (IZR (bottom h) * (D * m)) <= IZR (peak_factor x) * (IZR (low h) * D * x0))).
  { intros i Hi m x0. unfold follows in P. fold n in P. rewrite forallb_forall in P. specialize (P i ltac:(apply in_seq; lia)). cbv zeta in P.
    assert (Mv := vr_moved t (peak_given y) i Ht). fold m in Mv.
    destruct (Z.eqb_spec (nth i (peak_given x) 0%Z) 0) as [Q|Q].
    - left. split; auto. intros HW. rewrite HW in P. cbn [negb orb] in P. apply Z.eqb_eq in P. rewrite P in Mv.
      apply (Rmult_eq_reg_l D); lra.
    - right. split; auto. apply andb_prop in P. destruct P as [A B]. apply Z.leb_le, IZR_le in A. apply Z.leb_le, IZR_le in B.
      rewrite !mult_IZR in A. rewrite !mult_IZR in B. rewrite Mv in A, B. fold D in A, B. split; auto. }
  assert (Down : forall i, IZR (factor_scale a) * apply n (T t) V i <= IZR (peak_factor y) * apply n (T t) (vr (peak_given y)) i).
  { intros i. unfold apply. rewrite <- !sum_scal. apply sum_le. intros j Hj. assert (Q := proj2 (By j Hj)). assert (H0 := HT t Ht i j).
    apply (Rmult_le_compat_l _ _ _ H0) in Q. lra. }
  destruct near_number as [B1 B2].
  split.
  - intros i Hi. destruct (Each i Hi) as [[Q _]|[Q [A B]]]; unfold cut_to.
    + rewrite Q. unfold vr. rewrite Q. simpl. lra.
    + destruct (Z.eqb_spec (nth i (peak_given x) 0%Z) 0) as [Q'|_]; [contradiction|].
      assert (Up := apply_at_most t (vr (peak_given y)) V i Ht ltac:(intros; apply By; auto)). specialize (Down i).
      set (m := apply n (T t) (vr (peak_given y)) i) in *. set (x0 := vr (peak_given x) i) in *.
      set (V1 := scal (/ r) (apply n (T t) V) i) in *.
      assert (Step : apply n (T t) V i = r * V1) by (unfold V1, scal; field; lra). rewrite Step in Up, Down.
      assert (X0 : 0 <= x0) by apply (peak_nonnegative k), Ex.
      assert (M0 : 0 <= m). { apply sum_nonneg. intros j Hj. apply Rmult_le_pos. apply HT; auto. eapply peak_nonnegative; eauto. }
      split.
      * (* HIGH x0 <= m <= r V1 *)
        assert (Q1 : r * IZR (bottom h) * D * x0 <= r * IZR (bottom h) * D * V1).
        { apply Rle_trans with (IZR (high h) * D * x0). apply Rmult_le_compat_r; auto. apply Rmult_le_compat_r; lra.
          eapply Rle_trans. apply A. replace (r * IZR (bottom h) * D * V1) with (IZR (bottom h) * (D * (r * V1))) by ring.
          apply Rmult_le_compat_l. lra. apply Rmult_le_compat_l; lra. }
        apply (Rmult_le_reg_l (r * IZR (bottom h) * D)); auto. repeat apply Rmult_lt_0_compat; auto.
      * (* factor r V1 <= D_y m <= D_x LOW x0 <= D_x r x0 *)
        assert (Dx : 0 <= IZR (peak_factor x) * x0).
        { assert (Q1 : 0 <= IZR (factor_scale a) * (r * V1)) by (apply Rmult_le_pos; [lra|]; eapply Rle_trans; [apply M0|apply Up]).
          assert (Q2 : 0 <= IZR (bottom h) * D * (IZR (peak_factor y) * m)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]).
          apply (Rmult_le_reg_l (IZR (low h) * D)). apply Rmult_lt_0_compat; auto. lra. }
        assert (Q1 : IZR (bottom h) * D * r * (IZR (factor_scale a) * V1) <= IZR (bottom h) * D * r * (IZR (peak_factor x) * x0)).
        { replace (IZR (bottom h) * D * r * (IZR (factor_scale a) * V1)) with (IZR (bottom h) * D * (IZR (factor_scale a) * (r * V1))) by ring.
          apply Rle_trans with (IZR (bottom h) * D * (IZR (peak_factor y) * m)). apply Rmult_le_compat_l; auto. apply Rmult_le_pos; lra.
          apply Rle_trans with (IZR (low h) * D * (IZR (peak_factor x) * x0)). lra.
          replace (IZR (bottom h) * D * r * (IZR (peak_factor x) * x0)) with (r * IZR (bottom h) * D * (IZR (peak_factor x) * x0)) by ring.
          apply Rmult_le_compat_r; auto. apply Rmult_le_compat_r; lra. }
        apply (Rmult_le_reg_l (IZR (bottom h) * D * r)); auto. repeat apply Rmult_lt_0_compat; auto.
  - intros HW i Hi. rewrite HW in Hwhole. cbn [implb] in Hwhole. specialize (Wy Hwhole).
    assert (EV : scal (/ r) (apply n (T t) V) i = true_peak (t :: w) i).
    { rewrite (apply_ext n (T t) V _ Wy), <- Hw. unfold true_peak. rewrite apply_scal. cbn [run length pow]. unfold scal. field.
      split; [apply pow_nonzero|]; lra. }
    unfold cut_to. destruct (Z.eqb_spec (nth i (peak_given x) 0%Z) 0) as [Q|Q]; auto.
    rewrite <- EV. destruct (Each i Hi) as [[_ M0]|[Q' _]]; [|contradiction]. specialize (M0 HW). specialize (Down i). rewrite M0 in Down.
    assert (Up := apply_at_most t (vr (peak_given y)) V i Ht ltac:(intros; apply By; auto)). rewrite M0 in Up.
    assert (E0 : apply n (T t) V i = 0) by nra. unfold scal. rewrite E0. ring.
Qed.

Lemma stands_between x V : stands x V -> forall k, PositiveMap.find k known = Some x -> between_peak x V.
Proof.
  induction 1 as [x E|x t w y V E Ey Hy IH]; intros k Ex.
  - apply first_between; auto. destruct accepted_parts as [_ [_ [_ [_ [_ [_ [_ [_ [_ All]]]]]]]]]. apply (All k x Ex).
  - apply (next_between k (peak_origin x) x t w y V); auto. eapply IH; eauto.
Qed.

Lemma some_stands : forall m k x, PositiveMap.find k known = Some x -> (length (peak_word x) <= m)%nat -> exists V, stands x V.
Proof.
  destruct accepted_parts as [_ [_ [_ [_ [_ [_ [_ [_ [_ All]]]]]]]]].
  induction m as [m IH] using lt_wf_ind. intros k x Ex Hm. destruct (All k x Ex) as [P _]. unfold peak_right in P.
  destruct (peak_word x) as [|t w] eqn:E. { exists U. constructor. auto. }
  destruct (PositiveMap.find (peak_origin x) known) as [y|] eqn:Ey; [|rewrite andb_false_r in P; discriminate].
  repeat rewrite andb_true_iff in P. destruct P as [_ [[[_ Hw] _] _]]. apply same_word_spec in Hw. cbn [length] in Hm.
  destruct (IH (length w) ltac:(lia) (peak_origin x) y Ey ltac:(rewrite <- Hw; auto)) as [V HV].
  eexists. eapply stands_next; eauto.
Qed.

Lemma passes_sound k l x V y W t m1 m2 : PositiveMap.find k known = Some x -> stands x V -> PositiveMap.find l known = Some y ->
  stands y W -> (t < count F)%nat -> passes F h a most x t m1 y m2 = true ->
  forall i, (i < n)%nat -> r * W i <= apply n (T t) V i.
Proof.
  intros Ex SV Ey SW Ht H i Hi. destruct accepted_parts as [HT [_ [Hf [Hm [_ [Hc [HR _]]]]]]].
  destruct (stands_between x V SV k Ex) as [Lx [Bx Wx]]. destruct (stands_between y W SW l Ey) as [Ly [By Wy]].
  unfold passes in H. cbv zeta in H. fold n b in H. rewrite forallb_forall in H. specialize (H i ltac:(apply in_seq; lia)).
  apply orb_prop in H. destruct H as [H|H].
  - destruct (peak_whole x); [|discriminate]. destruct (peak_whole y); [|discriminate]. cbn [andb] in H. specialize (Wx eq_refl). specialize (Wy eq_refl).
    assert (RL : 0 <= r ^ L) by (apply pow_le; lra).
    assert (Az : cabs z = r ^ L) by (rewrite Positive, cabs_real, Rabs_pos_eq; auto).
    assert (Rz : z = real_number (cabs z)) by (rewrite Az; auto).
    apply (equal_at_sound F (polynomial e) L z WF Zero Length [b] HR Rz) in H; auto. 2:{ constructor; auto. }
    destruct H as [HL H]. unfold true_base, zero_for in H. cbn [nth_error] in H. rewrite Hc in H. fold V0 n T in H. cbn [length] in HL.
    apply (powers_equal F L z r Radius (eq_sym Az) Length m1 _ _ m2 _ _ HL) in H.
    rewrite (apply_ext n (T t) V _ Wx), (Wy i Hi). unfold true_peak, U. rewrite !run_scal, !apply_scal. cbn [run] in H. unfold scal.
    right. apply (f_equal (Rmult (real_of (eigenvector_multiple a)))) in H. lra.
  - apply Z.leb_le, IZR_le in H. rewrite !mult_IZR in H. rewrite (vr_moved t (peak_given x) i Ht) in H. fold D in H.
    assert (Fp : 0 < IZR (factor_scale a)) by (apply IZR_lt; auto). assert (Dp := denominator_positive F WF). fold D in Dp.
    assert (Bp : 0 < IZR (bottom h)) by (apply IZR_lt; auto).
    assert (Up := apply_at_most t (vr (peak_given x)) V i Ht ltac:(intros; apply Bx; auto)). destruct (By i Hi) as [_ B]. destruct near_number as [_ B2].
    change (IZR (nth i (peak_given y) 0%Z)) with (vr (peak_given y) i) in H. assert (Y0 := peak_nonnegative l y i Ey).
    set (m := apply n (T t) (vr (peak_given x)) i) in *. set (y0 := vr (peak_given y) i) in *.
    assert (Most : IZR (factor_scale a) * W i <= IZR most * y0).
    { eapply Rle_trans. apply B. apply Rmult_le_compat_r; auto. apply IZR_le. apply (largest_of_bound peak_factor). apply number_in in Ey. auto. }
    assert (Mp : 0 < IZR most) by (apply IZR_lt; auto).
    apply Rle_trans with m; auto. apply (Rmult_le_reg_l (IZR (bottom h) * IZR (factor_scale a) * D)). repeat apply Rmult_lt_0_compat; auto.
    apply Rle_trans with (IZR (high h) * D * IZR most * y0); [|lra].
    replace (IZR (bottom h) * IZR (factor_scale a) * D * (r * W i)) with (r * IZR (bottom h) * D * (IZR (factor_scale a) * W i)) by ring.
    apply Rle_trans with (r * IZR (bottom h) * D * (IZR most * y0)).
    + apply Rmult_le_compat_l; auto. repeat apply Rmult_le_pos; lra.
    + replace (IZR (high h) * D * IZR most * y0) with (IZR (high h) * D * (IZR most * y0)) by ring.
      apply Rmult_le_compat_r. apply Rmult_le_pos; lra. apply Rmult_le_compat_r; lra.
Qed.

Lemma ascent_at_least : subradius_at_least n (count F) T r.
Proof.
  destruct accepted_parts as [HT [Hs [Hf [Hm [_ [_ [_ [[Lv [Ll Hv]] [[x0 [I0 [E0 _]]] All]]]]]]]]].
  assert (Fp : 0 < IZR (factor_scale a)) by (apply IZR_lt; auto). assert (Mp : 0 < IZR most) by (apply IZR_lt; auto).
  assert (Bp : 0 < IZR (bottom h)) by (apply IZR_lt; auto).
  set (Point := fun V : vec => exists k x, PositiveMap.find k known = Some x /\ stands x V).
  apply (growing_bound n (count F) T Point U).
  - lra.
  - exists 1%positive, x0. split; auto. constructor; auto.
  - intros V [k [x [Ex SV]]]. destruct (All k x Ex) as [P _]. unfold peak_right in P. repeat rewrite andb_true_iff in P. destruct P as [[[_ P2] P3] _].
    apply Nat.leb_le in P2. apply Z.ltb_lt in P3. assert (N := norm1_sum (peak_given x) n P2).
    apply Rle_trans with (IZR (norm1 (peak_given x))). apply IZR_le, (Z.le_succ_l 0), P3.
    rewrite N. apply sum_le; intros i Hi. rewrite Rabs_pos_eq by (eapply peak_nonnegative; eauto).
    destruct (stands_between x V SV k Ex) as [_ [B _]]. apply B; auto.
  - intros V t w c [k [x [Ex SV]]] Ht Hw Hc HP. destruct (All k x Ex) as [_ Q]. destruct (Q t Ht) as [i Hi]. clear Q.
    destruct (stands_between x V SV k Ex) as [Lx [Bx Wx]].
    (* it is enough that the image is at least the number times a true vertex *)
    assert (Enough : forall W, Point W -> (forall j, (j < n)%nat -> r * W j <= apply n (T t) V j) ->
      r * c <= sum n (run n T w (apply n (T t) V))).
    { intros W PW HW. apply Rle_trans with (sum n (run n T w (scal r W))).
      - rewrite run_scal. unfold scal. rewrite sum_scal. apply Rmult_le_compat_l. lra. auto.
      - apply sum_le. apply (run_monotone n (count F) T HT); auto. }
    destruct i as [l| |l m1 m2|ts]; unfold rise_right in Hi.
    + destruct (PositiveMap.find l known) as [y|] eqn:Ey; [|discriminate].
      apply andb_prop in Hi. destruct Hi as [H1 H2]. apply Pos.eqb_eq in H1. destruct (peak_word y) as [|s u] eqn:E; [discriminate|].
      apply Nat.eqb_eq in H2. subst s.
      apply (Enough (cut_to (peak_given y) (scal (/ r) (apply n (T t) V)))).
      * exists l, y. split; auto. apply (stands_next y t u x V); auto. rewrite H1. auto.
      * intros j Hj. assert (A : 0 <= apply n (T t) V j).
        { apply sum_nonneg. intros q Hq. apply Rmult_le_pos. apply HT; auto. eapply Rle_trans; [|apply Bx; auto]. eapply peak_nonnegative; eauto. }
        unfold cut_to. destruct (Z.eqb_spec (nth j (peak_given y) 0%Z) 0); [lra|]. unfold scal. right. field. lra.
    + apply andb_prop in Hi. destruct Hi as [H1 H2]. specialize (Wx H1). apply same_word_spec in H2. fold v in H2.
      apply (Enough U). { exists 1%positive, x0. split; auto. constructor; auto. }
      intros j Hj. rewrite (apply_ext n (T t) V _ Wx). unfold true_peak. rewrite apply_scal.
      change (apply n (T t) (run n T (peak_word x) U)) with (run n T (t :: peak_word x) U). rewrite H2, Hv, <- Ll, <- H2. unfold scal. cbn [length pow].
      right. field. apply pow_nonzero; lra.
    + destruct (PositiveMap.find l known) as [y|] eqn:Ey; [|discriminate]. destruct (some_stands (length (peak_word y)) l y Ey) as [W SW]; auto.
      apply (Enough W). { exists l, y. auto. } intros j Hj. apply (passes_sound k l x V y W t m1 m2); auto.
    + apply Rle_trans with (sum n (run n T w (apply n (T t) (vr (peak_given x))))).
      2:{ apply sum_le. apply (run_monotone n (count F) T HT); auto. intros j Hj. apply apply_at_most; auto. intros; apply Bx; auto. }
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
      * intros i q E. unfold ps in E. rewrite number_map in E. fold known in E. destruct (PositiveMap.find i known) as [y|] eqn:Ey; [|discriminate].
        inversion E; subst q. clear E. cbn [fst]. destruct (some_stands (length (peak_word y)) i y Ey) as [W SW]; auto.
        destruct (stands_between y W SW i Ey) as [_ [By _]].
        assert (G : IZR (factor_scale a) * sum n (run n T w W) <= IZR most * sum n (run n T w (vr (peak_given y)))).
        { rewrite <- !sum_scal. apply sum_le. intros j Hj.
          assert (R := run_monotone n (count F) T HT w (scal (IZR (factor_scale a)) W) (scal (IZR most) (vr (peak_given y))) Hw).
          rewrite !run_scal in R. unfold scal in R. apply R; auto. intros q Hq. eapply Rle_trans. apply (By q Hq).
          apply Rmult_le_compat_r. eapply peak_nonnegative; eauto.
          apply IZR_le. apply (largest_of_bound peak_factor). eapply number_in; eauto. }
        assert (Hy := HP W ltac:(exists i, y; auto)).
        apply (Rmult_le_compat_l (IZR (factor_scale a))) in Hy; [|lra].
        apply (Rmult_le_reg_l (IZR most)); auto.
        replace (IZR most * (c * (IZR (factor_scale a) / IZR most))) with (IZR (factor_scale a) * c) by (field; lra).
        exact (Rle_trans _ _ _ Hy G).
Qed.

Lemma ascent_at_most : subradius_at_most n (count F) T r.
Proof.
  destruct accepted_parts as [HT [_ [_ [_ [_ [_ [_ [[Lv [Ll Hv]] [[x [Ex [E B]]] All]]]]]]]]].
  destruct (first_between x (proj1 (All 1%positive x Ex)) E) as [_ [Bx _]].
  assert (Bp : 0 < IZR (bottom h)) by (apply IZR_lt; auto). assert (Dp := denominator_positive F WF). fold D in Dp.
  apply (eigenvector_bound n (count F) T v U (vr (beside a)) r); auto.
  - intros N. rewrite N in Ll. simpl in Ll. lia.
  - lra.
  - rewrite Ll. auto.
  - intros i Hi. unfold beside_right in B. cbv zeta in B. fold n v in B. rewrite forallb_forall in B. specialize (B i ltac:(apply in_seq; lia)).
    cbv zeta in B. destruct (Bx i Hi) as [B1 B2]. assert (X0 := peak_nonnegative 1%positive x i Ex). unfold vr in X0.
    destruct (Z.eqb_spec (nth i (peak_given x) 0%Z) 0) as [Q|Q].
    + right. unfold vr in B1, B2 at 1. rewrite Q in B1, B2. assert (Fp : 0 < IZR (factor_scale a)). { destruct accepted_parts as [_ [_ [H _]]]. apply IZR_lt; auto. }
      apply andb_prop in B. destruct B as [X1 X2]. apply Z.ltb_lt in X1. apply Z.leb_le, IZR_le in X2. split. nra. split.
      * unfold vr. apply IZR_le. lia.
      * rewrite !mult_IZR, <- !pow_IZR, mult_IZR in X2. fold L D in X2.
        change (IZR (nth i (zrun (matrices F) v (beside a)) 0%Z)) with (vr (zrun (matrices F) v (beside a)) i) in X2.
        rewrite (vr_zrun F WF) in X2 by auto. fold D n T in X2. unfold scal in X2. rewrite Ll, Rpow_mult_distr in *.
        change (IZR (nth i (beside a) 0%Z)) with (vr (beside a) i) in X2.
        assert (X3 : 0 <= vr (beside a) i) by (apply IZR_le; lia).
        assert (DL : 0 < D ^ L) by (apply pow_lt; auto). assert (BL : 0 < IZR (bottom h) ^ L) by (apply pow_lt; auto).
        assert (R : IZR (low h) ^ L <= IZR (bottom h) ^ L * r ^ L).
        { rewrite <- Rpow_mult_distr. apply pow_incr. split. apply IZR_le; lia. destruct near_number; lra. }
        apply (Rmult_le_reg_l (IZR (bottom h) ^ L * D ^ L)). apply Rmult_lt_0_compat; auto.
        eapply Rle_trans; [|eapply Rle_trans; [apply X2|]]. right; ring.
        replace (IZR (bottom h) ^ L * D ^ L * (r ^ L * vr (beside a) i)) with (IZR (bottom h) ^ L * r ^ L * D ^ L * vr (beside a) i) by ring.
        apply Rmult_le_compat_r; auto. apply Rmult_le_compat_r; lra.
    + left. apply Z.eqb_eq in B. split. eapply Rle_trans; [|apply B1]. unfold vr. apply IZR_le. apply le_IZR in X0. lia.
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
