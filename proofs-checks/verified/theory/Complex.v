(* Complex numbers as pairs, and zeros of polynomials with integer coefficients: that there is one in a disc, and only one,
   checked with integers. *)
Require Import Reals List ZArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Lower.
Import ListNotations.
Open Scope R_scope.

Definition complex := (R * R)%type.
Definition real_number (a : R) : complex := (a, 0).
Definition cplus (x y : complex) : complex := (fst x + fst y, snd x + snd y).
Definition cminus (x y : complex) : complex := (fst x - fst y, snd x - snd y).
Definition copposite (x : complex) : complex := (- fst x, - snd x).
Definition ctimes (x y : complex) : complex := (fst x * fst y - snd x * snd y, fst x * snd y + snd x * fst y).
Definition conjugate (x : complex) : complex := (fst x, - snd x).
Definition cabs (x : complex) : R := modulus (fst x) (snd x).

(* p0 + p1 x + p2 x^2 + ... *)
Fixpoint value (p : list Z) (x : complex) : complex :=
  match p with [] => real_number 0 | c :: p' => cplus (real_number (IZR c)) (ctimes x (value p' x)) end.

Lemma complex_ring : ring_theory (real_number 0) (real_number 1) cplus ctimes cminus copposite eq.
Proof.
  constructor; intros; unfold cplus, ctimes, cminus, copposite, real_number; try destruct x; try destruct y; try destruct z; simpl; f_equal; ring.
Qed.
Add Ring complex_numbers : complex_ring.

Lemma cabs_nonneg x : 0 <= cabs x.
Proof. apply modulus_nonneg. Qed.

Lemma cabs_plus x y : cabs (cplus x y) <= cabs x + cabs y.
Proof. apply modulus_triangle. Qed.

Lemma cabs_times x y : cabs (ctimes x y) = cabs x * cabs y.
Proof. apply modulus_mult. Qed.

Lemma cabs_real a : cabs (real_number a) = Rabs a.
Proof. apply modulus_real. Qed.

Lemma cabs_sum x : cabs x <= Rabs (fst x) + Rabs (snd x).
Proof.
  unfold cabs. assert (D := modulus_triangle (fst x) 0 0 (snd x)).
  rewrite Rplus_0_r, Rplus_0_l, modulus_real, modulus_imaginary in D. auto.
Qed.

Lemma cabs_square x : cabs x * cabs x = fst x * fst x + snd x * snd x.
Proof. unfold cabs, modulus. apply sqrt_sqrt. nra. Qed.

Lemma cabs_first x : Rabs (fst x) <= cabs x.
Proof. apply Rsqr_incr_0_var; [|apply cabs_nonneg]. unfold Rsqr. rewrite cabs_square, <- Rabs_mult, Rabs_pos_eq; nra. Qed.

Lemma cabs_second x : Rabs (snd x) <= cabs x.
Proof. apply Rsqr_incr_0_var; [|apply cabs_nonneg]. unfold Rsqr. rewrite cabs_square, <- Rabs_mult, Rabs_pos_eq; nra. Qed.

Lemma cabs_zero x : cabs x = 0 -> x = real_number 0.
Proof.
  intros H. assert (A := cabs_first x). assert (B := cabs_second x). rewrite H in A, B.
  assert (fst x = 0 /\ snd x = 0). { split; destruct (Req_dec (fst x) 0), (Req_dec (snd x) 0); auto;
    try (assert (0 < Rabs (fst x)) by (apply Rabs_pos_lt; auto); lra); assert (0 < Rabs (snd x)) by (apply Rabs_pos_lt; auto); lra. }
  destruct x; simpl in *. unfold real_number. f_equal; tauto.
Qed.

Lemma value_conjugate p x : value p (conjugate x) = conjugate (value p x).
Proof.
  induction p; simpl. unfold conjugate, real_number; simpl. f_equal; ring.
  rewrite IHp. unfold conjugate, cplus, ctimes, real_number; simpl. f_equal; ring.
Qed.

(* ---- differences ------------------------------------------------------------------------------------------------- *)

(* (p(x) - p(y)) / (x - y) *)
Fixpoint slope (p : list Z) (x y : complex) : complex :=
  match p with [] => real_number 0 | c :: p' => cplus (value p' x) (ctimes y (slope p' x y)) end.

Lemma value_difference p x y : cminus (value p x) (value p y) = ctimes (cminus x y) (slope p x y).
Proof.
  induction p; simpl. ring.
  transitivity (cplus (ctimes (cminus x y) (value p x)) (ctimes y (cminus (value p x) (value p y)))). ring. rewrite IHp. ring.
Qed.

(* Bounds for |x| <= m of the values, of the slopes, and of the changes of slopes *)
Fixpoint value_bound (p : list Z) (m : R) : R := match p with [] => 0 | c :: p' => Rabs (IZR c) + m * value_bound p' m end.
Fixpoint slope_bound (p : list Z) (m : R) : R := match p with [] => 0 | c :: p' => value_bound p' m + m * slope_bound p' m end.
Fixpoint change_bound (p : list Z) (m : R) : R := match p with [] => 0 | c :: p' => 2 * slope_bound p' m + m * change_bound p' m end.

Lemma bounds_nonneg p m : 0 <= m -> 0 <= value_bound p m /\ 0 <= slope_bound p m /\ 0 <= change_bound p m.
Proof.
  intros Hm. induction p; simpl. lra. destruct IHp as [A [B C]]. assert (D := Rabs_pos (IZR a)).
  assert (0 <= m * value_bound p m) by (apply Rmult_le_pos; auto). assert (0 <= m * slope_bound p m) by (apply Rmult_le_pos; auto).
  assert (0 <= m * change_bound p m) by (apply Rmult_le_pos; auto). lra.
Qed.

Lemma value_bounded p m x : cabs x <= m -> cabs (value p x) <= value_bound p m.
Proof.
  intros Hx. assert (X := cabs_nonneg x). induction p; simpl. rewrite cabs_real, Rabs_R0. lra.
  eapply Rle_trans. apply cabs_plus. rewrite cabs_real, cabs_times. apply Rplus_le_compat_l.
  apply Rmult_le_compat; auto. apply cabs_nonneg.
Qed.

Lemma slope_bounded p m x y : cabs x <= m -> cabs y <= m -> cabs (slope p x y) <= slope_bound p m.
Proof.
  intros Hx Hy. assert (X := cabs_nonneg x). assert (Y := cabs_nonneg y). induction p; simpl. rewrite cabs_real, Rabs_R0. lra.
  eapply Rle_trans. apply cabs_plus. rewrite cabs_times. apply Rplus_le_compat. apply value_bounded; auto.
  apply Rmult_le_compat; auto. apply cabs_nonneg.
Qed.

Lemma change_bounded p m e x y c : cabs x <= m -> cabs y <= m -> cabs c <= m -> cabs (cminus x c) <= e -> cabs (cminus y c) <= e ->
  cabs (cminus (slope p x y) (slope p c c)) <= e * change_bound p m.
Proof.
  intros Hx Hy Hc Ex Ey. assert (X := cabs_nonneg x). assert (Y := cabs_nonneg y).
  assert (E : 0 <= e). { eapply Rle_trans; [|apply Ex]. apply cabs_nonneg. }
  induction p; simpl. replace (cminus (real_number 0) (real_number 0)) with (real_number 0) by ring. rewrite cabs_real, Rabs_R0. lra.
  replace (cminus (cplus (value p x) (ctimes y (slope p x y))) (cplus (value p c) (ctimes c (slope p c c))))
    with (cplus (cminus (value p x) (value p c)) (cplus (ctimes y (cminus (slope p x y) (slope p c c))) (ctimes (cminus y c) (slope p c c)))) by ring.
  rewrite value_difference. eapply Rle_trans. apply cabs_plus.
  assert (A := cabs_plus (ctimes y (cminus (slope p x y) (slope p c c))) (ctimes (cminus y c) (slope p c c))).
  rewrite !cabs_times in *. assert (B := slope_bounded p m x c Hx Hc). assert (D := slope_bounded p m c c Hc Hc).
  assert (N1 := cabs_nonneg (slope p x c)). assert (N2 := cabs_nonneg (slope p c c)).
  assert (N3 := cabs_nonneg (cminus (slope p x y) (slope p c c))).
  assert (cabs (cminus x c) * cabs (slope p x c) <= e * slope_bound p m) by (apply Rmult_le_compat; auto; apply cabs_nonneg).
  assert (cabs (cminus y c) * cabs (slope p c c) <= e * slope_bound p m) by (apply Rmult_le_compat; auto; apply cabs_nonneg).
  assert (cabs y * cabs (cminus (slope p x y) (slope p c c)) <= m * (e * change_bound p m)) by (apply Rmult_le_compat; auto).
  lra.
Qed.

(* In a disc where the slopes change less than they are large there is one zero at most. *)
Lemma zero_unique p c e m x y : cabs c + e <= m -> e * change_bound p m < cabs (slope p c c) ->
  cabs (cminus x c) <= e -> cabs (cminus y c) <= e -> value p x = real_number 0 -> value p y = real_number 0 -> x = y.
Proof.
  intros Hm Hs Ex Ey Zx Zy.
  assert (Bound : forall u, cabs (cminus u c) <= e -> cabs u <= m).
  { intros u Hu. replace u with (cplus (cminus u c) c) by ring. eapply Rle_trans. apply cabs_plus. lra. }
  assert (E : 0 <= e). { eapply Rle_trans; [|apply Ex]. apply cabs_nonneg. }
  assert (C := change_bounded p m e x y c (Bound x Ex) (Bound y Ey) ltac:(assert (N := cabs_nonneg c); lra) Ex Ey).
  assert (D := value_difference p x y). rewrite Zx, Zy in D.
  assert (A := f_equal cabs D). rewrite cabs_times in A. replace (cminus (real_number 0) (real_number 0)) with (real_number 0) in A by ring.
  rewrite cabs_real, Rabs_R0 in A.
  assert (S : 0 < cabs (slope p x y)).
  { assert (T := cabs_plus (slope p x y) (cminus (slope p c c) (slope p x y))).
    replace (cplus (slope p x y) (cminus (slope p c c) (slope p x y))) with (slope p c c) in T by ring.
    replace (cabs (cminus (slope p c c) (slope p x y))) with (cabs (cminus (slope p x y) (slope p c c))) in T.
    lra. unfold cabs, cminus, modulus; simpl. f_equal. ring. }
  assert (Z : cabs (cminus x y) = 0).
  { symmetry in A. apply Rmult_integral in A. destruct A; auto. lra. }
  apply cabs_zero in Z. replace x with (cplus (cminus x y) y) by ring. rewrite Z. ring.
Qed.

(* ---- Newton's iteration ------------------------------------------------------------------------------------------ *)

Definition pair (x : vec) : complex := (x 0%nat, x 1%nat).
Definition of_pair (x : complex) : vec := fun i => match i with O => fst x | _ => snd x end.
Definition multiplication (x : complex) : mat := fun i j =>
  match i, j with O, O => fst x | O, _ => - snd x | _, O => snd x | _, _ => fst x end.

Lemma apply_multiplication x u i : (i < 2)%nat -> apply 2 (multiplication x) u i = of_pair (ctimes x (pair u)) i.
Proof. intros H. destruct i as [|[|i]]; [| |lia]; unfold apply, multiplication, of_pair, ctimes, pair; simpl; ring. Qed.

Lemma near_pair u v d : near 2 u v d <-> Rabs (fst (cminus (pair u) (pair v))) <= d /\ Rabs (snd (cminus (pair u) (pair v))) <= d.
Proof.
  split.
  - intros H. split; [apply (H 0%nat); lia | apply (H 1%nat); lia].
  - intros [A B] i Hi. destruct i as [|[|i]]; [exact A | exact B | lia].
Qed.

Lemma near_cabs u v d : near 2 u v d -> cabs (cminus (pair u) (pair v)) <= 2 * d.
Proof. intros H. apply near_pair in H. eapply Rle_trans. apply cabs_sum. lra. Qed.

Lemma cabs_near u v d : cabs (cminus (pair u) (pair v)) <= d -> near 2 u v d.
Proof.
  intros H. apply near_pair. split; eapply Rle_trans; try apply H. apply cabs_first. apply cabs_second.
Qed.

Theorem zero_near p c rho m alpha : 0 <= rho -> cabs c + 2 * rho <= m -> ctimes alpha (slope p c c) = real_number 1 ->
  2 * (cabs alpha * cabs (value p c)) <= rho -> 16 * cabs alpha * rho * change_bound p m <= 1 ->
  exists z, value p z = real_number 0 /\ Rabs (fst z - fst c) <= rho /\ Rabs (snd z - snd c) <= rho.
Proof.
  intros Hr Hm Ha Hv Hc. assert (N0 := cabs_nonneg alpha). assert (Nc := cabs_nonneg c).
  assert (W := proj2 (proj2 (bounds_nonneg p m ltac:(lra)))). set (w := change_bound p m) in *.
  set (q := fun x => of_pair (ctimes (pair x) (cminus (slope p (cplus c (pair x)) c) (slope p c c)))).
  assert (Pq : forall x, pair (q x) = ctimes (pair x) (cminus (slope p (cplus c (pair x)) c) (slope p c c))).
  { intros x. unfold q. destruct (ctimes _ _); reflexivity. }
  assert (P0 : pair zero = real_number 0) by reflexivity.
  assert (Near0 : forall x d, near 2 x zero d -> cabs (pair x) <= 2 * d).
  { intros x d H. apply near_cabs in H. rewrite P0 in H. replace (cminus (pair x) (real_number 0)) with (pair x) in H by ring. auto. }
  assert (Difference : forall x y, cminus (pair (q x)) (pair (q y)) = ctimes (cminus (pair x) (pair y)) (cminus (slope p (cplus c (pair x)) (cplus c (pair y))) (slope p c c))).
  { intros x y. rewrite !Pq.
    assert (D1 := value_difference p (cplus c (pair x)) c). assert (D2 := value_difference p (cplus c (pair y)) c).
    assert (D3 := value_difference p (cplus c (pair x)) (cplus c (pair y))).
    replace (cminus (cplus c (pair x)) c) with (pair x) in D1 by ring. replace (cminus (cplus c (pair y)) c) with (pair y) in D2 by ring.
    replace (cminus (cplus c (pair x)) (cplus c (pair y))) with (cminus (pair x) (pair y)) in D3 by ring.
    transitivity (cminus (cminus (ctimes (pair x) (slope p (cplus c (pair x)) c)) (ctimes (pair y) (slope p (cplus c (pair y)) c)))
                    (ctimes (cminus (pair x) (pair y)) (slope p c c))). ring.
    rewrite <- D1, <- D2. transitivity (cminus (cminus (value p (cplus c (pair x))) (value p (cplus c (pair y)))) (ctimes (cminus (pair x) (pair y)) (slope p c c))).
    ring. rewrite D3. ring. }
  assert (Inverse : forall x i, (i < 2)%nat -> apply 2 (multiplication alpha) (apply 2 (multiplication (slope p c c)) x) i = x i).
  { intros x i Hi. rewrite (apply_ext 2 _ _ (of_pair (ctimes (slope p c c) (pair x)))) by (intros; apply apply_multiplication; auto).
    rewrite apply_multiplication by auto. replace (ctimes alpha (pair (of_pair (ctimes (slope p c c) (pair x))))) with (pair x).
    destruct i as [|[|i]]; [reflexivity|reflexivity|lia].
    transitivity (ctimes (ctimes alpha (slope p c c)) (pair x)). rewrite Ha; ring.
    replace (pair (of_pair (ctimes (slope p c c) (pair x)))) with (ctimes (slope p c c) (pair x)) by (destruct (ctimes (slope p c c) (pair x)); reflexivity). ring. }
  assert (Inverse' : forall x i, (i < 2)%nat -> apply 2 (multiplication (slope p c c)) (apply 2 (multiplication alpha) x) i = x i).
  { intros x i Hi. rewrite (apply_ext 2 _ _ (of_pair (ctimes alpha (pair x)))) by (intros; apply apply_multiplication; auto).
    rewrite apply_multiplication by auto. replace (ctimes (slope p c c) (pair (of_pair (ctimes alpha (pair x))))) with (pair x).
    destruct i as [|[|i]]; [reflexivity|reflexivity|lia].
    transitivity (ctimes (ctimes alpha (slope p c c)) (pair x)). rewrite Ha; ring.
    replace (pair (of_pair (ctimes alpha (pair x)))) with (ctimes alpha (pair x)) by (destruct (ctimes alpha (pair x)); reflexivity). ring. }
  destruct (zero_exists 2 (multiplication (slope p c c)) (multiplication alpha) (of_pair (value p c)) q rho 0 0 (2 * cabs alpha) (4 * rho * w)
    (cabs alpha * cabs (value p c))) as [x [Hx Zx]].
  - exact Hr.
  - intros d x _ i Hi. rewrite Inverse by auto. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra.
  - intros d x _ i Hi. rewrite Inverse' by auto. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra.
  - intros d x Hx. apply Near0 in Hx. intros i Hi. rewrite apply_multiplication by auto. unfold zero. rewrite Rminus_0_r.
    assert (T := cabs_times alpha (pair x)). assert (A := cabs_first (ctimes alpha (pair x))). assert (B := cabs_second (ctimes alpha (pair x))).
    assert (cabs alpha * cabs (pair x) <= cabs alpha * (2 * d)) by (apply Rmult_le_compat_l; auto).
    destruct i; [eapply Rle_trans; [exact A|] | eapply Rle_trans; [exact B|]]; lra.
  - intros i Hi. unfold q. rewrite P0. replace (ctimes (real_number 0) (cminus (slope p (cplus c (real_number 0)) c) (slope p c c))) with (real_number 0) by ring.
    destruct i; reflexivity.
  - intros x y d Hx Hy Hd. apply cabs_near. rewrite Difference, cabs_times. apply near_cabs in Hd. apply Near0 in Hx, Hy.
    assert (Ball : forall u, cabs u <= 2 * rho -> cabs (cplus c u) <= m). { intros u Hu. eapply Rle_trans. apply cabs_plus. lra. }
    assert (B := change_bounded p m (2 * rho) (cplus c (pair x)) (cplus c (pair y)) c (Ball _ Hx) (Ball _ Hy) ltac:(lra)).
    replace (cminus (cplus c (pair x)) c) with (pair x) in B by ring. replace (cminus (cplus c (pair y)) c) with (pair y) in B by ring.
    specialize (B Hx Hy). fold w in B.
    replace (4 * rho * w * d) with ((2 * d) * (2 * rho * w)) by ring. apply Rmult_le_compat; auto; apply cabs_nonneg.
  - intros i Hi. rewrite apply_multiplication by auto. unfold zero. rewrite Rminus_0_r.
    replace (pair (of_pair (value p c))) with (value p c) by (destruct (value p c); reflexivity).
    assert (T := cabs_times alpha (value p c)). assert (A := cabs_first (ctimes alpha (value p c))). assert (B := cabs_second (ctimes alpha (value p c))).
    destruct i; [eapply Rle_trans; [exact A|] | eapply Rle_trans; [exact B|]]; lra.
  - assert (0 <= 2 * cabs alpha * (4 * rho * w)) by (repeat apply Rmult_le_pos; lra). split. lra.
    assert (2 * cabs alpha * (4 * rho * w) = 8 * cabs alpha * rho * w) by ring. lra.
  - assert (2 * cabs alpha * (4 * rho * w) * rho = 8 * cabs alpha * rho * w * rho) by ring.
    assert (16 * cabs alpha * rho * w * rho <= 1 * rho) by (apply Rmult_le_compat_r; auto). lra.
  - lra.
  - exists (cplus c (pair x)). apply near_pair in Hx. rewrite P0 in Hx. unfold cminus, real_number in Hx. simpl in Hx. rewrite !Rminus_0_r in Hx.
    split; [|unfold cplus, pair; simpl; split; [replace (fst c + x 0%nat - fst c) with (x 0%nat) by ring | replace (snd c + x 1%nat - snd c) with (x 1%nat) by ring]; tauto].
    assert (E : cplus (cplus (value p c) (ctimes (slope p c c) (pair x))) (pair (q x)) = real_number 0).
    { assert (E0 := Zx 0%nat ltac:(lia)). assert (E1 := Zx 1%nat ltac:(lia)). rewrite !apply_multiplication in E0, E1 by lia. simpl in E0, E1.
      unfold real_number, cplus, pair in *. f_equal; simpl; [exact E0 | exact E1]. }
    rewrite Pq in E. assert (D := value_difference p (cplus c (pair x)) c). replace (cminus (cplus c (pair x)) c) with (pair x) in D by ring.
    transitivity (cplus (cminus (value p (cplus c (pair x))) (value p c)) (value p c)). ring. rewrite D, <- E. ring.
Qed.
