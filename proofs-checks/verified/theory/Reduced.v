(* Theorem 24 of SPEC.md: where the mask a times p(z) is the mask b times p(z^A), and p(1) and p_0 are not 0, the limits of
   both schemes are equally smooth. So what is shown of b, whose shifts may be stable, is true of a, whose shifts are not. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Integers Sections Check Subdivision Differences Coefficients Stability Modulus Exponent Enclosure
  Number Exact Logarithm.
Import ListNotations.
Open Scope R_scope.

(* ---- combinations of shifts -------------------------------------------------------------------------------------- *)

(* The sum of p l f (x - l) over l < n *)
Definition mix (n : nat) (p : nat -> R) (f : R -> R) : R -> R := fun x => sum n (fun l => p l * f (x - INR l)).

Lemma mix_change n p f C x y : (forall l, (l < n)%nat -> Rabs (f (y - INR l) - f (x - INR l)) <= C) ->
  Rabs (mix n p f y - mix n p f x) <= sum n (fun l => Rabs (p l)) * C.
Proof.
  intros H. unfold mix. rewrite <- sum_minus. eapply Rle_trans. apply sum_abs. rewrite Rmult_comm, <- sum_scal.
  apply sum_le; intros l Hl. rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos. auto.
Qed.

Lemma derivative_near f g x l r : 0 < r -> (forall y, Rabs (y - x) < r -> f y = g y) -> derivable_pt_lim g x l -> derivable_pt_lim f x l.
Proof.
  intros Hr E D eps He. destruct (D eps He) as [[d Hd] H]. simpl in H. assert (M : 0 < Rmin d r) by (apply Rmin_glb_lt; auto).
  exists (mkposreal _ M). intros h H0 Hh. simpl in Hh. rewrite !E.
  - apply H; auto. eapply Rlt_le_trans. apply Hh. apply Rmin_l.
  - rewrite Rminus_diag_eq, Rabs_R0; auto.
  - replace (x + h - x) with h by ring. eapply Rlt_le_trans. apply Hh. apply Rmin_r.
Qed.

Lemma derivative_shift f x s l : derivable_pt_lim f (x - s) l -> derivable_pt_lim (fun x => f (x - s)) x l.
Proof.
  intros D eps He. destruct (D eps He) as [d Hd]. exists d. intros h H0 Hh. replace (x + h - s) with (x - s + h) by ring. auto.
Qed.

Lemma derivative_mix n p f f' : (forall x, derivable_pt_lim f x (f' x)) -> forall x, derivable_pt_lim (mix n p f) x (mix n p f' x).
Proof.
  intros D x. induction n. apply (derivable_pt_lim_const 0).
  apply (derivable_pt_lim_plus (mix n p f) (fun x => p n * f (x - INR n))); auto.
  apply (derivable_pt_lim_scal (fun x => f (x - INR n))). apply derivative_shift. auto.
Qed.

Lemma derivative_sequence_mix n p k : forall f g, derivative k f g -> derivative k (mix n p f) (mix n p g).
Proof.
  induction k; intros f g H.
  - intros x. unfold mix. apply sum_ext; intros. rewrite H. auto.
  - destruct H as [f' [D H]]. exists (mix n p f'). split; auto. apply derivative_mix. auto.
Qed.

Lemma derivative_sequence_scal c k : forall f g, derivative k f g -> derivative k (fun x => c * f x) (fun x => c * g x).
Proof.
  induction k; intros f g H.
  - intros x. rewrite H. auto.
  - destruct H as [f' [D H]]. exists (fun x => c * f' x). split; auto. intros x. apply (derivable_pt_lim_scal f). auto.
Qed.

Lemma derivative_vanishes lo hi k : forall f g, derivative k f g -> vanishes lo hi f -> vanishes lo hi g.
Proof.
  induction k; intros f g H V.
  - intros x Hx. rewrite <- H. auto.
  - destruct H as [f' [D H]]. apply (IHk f'); auto. apply (vanishing_derivative lo hi f); auto.
Qed.

Lemma holder_mix n p k : forall alpha f, holder k alpha f -> holder k alpha (mix n p f).
Proof.
  induction k; intros alpha f H.
  - destruct H as [C H]. exists (sum n (fun l => Rabs (p l)) * C). intros x t. rewrite Rmult_assoc. apply mix_change. intros l Hl.
    replace (x + exp t - INR l) with (x - INR l + exp t) by ring. apply H.
  - destruct H as [f' [D H]]. exists (mix n p f'). split; auto. apply derivative_mix. auto.
Qed.

Lemma holder_scal c k : forall alpha f, holder k alpha f -> holder k alpha (fun x => c * f x).
Proof.
  induction k; intros alpha f H.
  - destruct H as [C H]. exists (Rabs c * C). intros x t. rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_assoc.
    apply Rmult_le_compat_l. apply Rabs_pos. auto.
  - destruct H as [f' [D H]]. exists (fun x => c * f' x). split; auto. intros x. apply (derivable_pt_lim_scal f). auto.
Qed.

Lemma holder_minus k : forall alpha f g, holder k alpha f -> holder k alpha g -> holder k alpha (fun x => f x - g x).
Proof.
  induction k; intros alpha f g H G.
  - destruct H as [C H], G as [C' G]. exists (C + C'). intros x t.
    replace (f (x + exp t) - g (x + exp t) - (f x - g x)) with ((f (x + exp t) - f x) + - (g (x + exp t) - g x)) by ring.
    eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp, Rmult_plus_distr_r. apply Rplus_le_compat; auto.
  - destruct H as [f' [D H]], G as [g' [E G]]. exists (fun x => f' x - g' x). split; auto.
    intros x. apply (derivable_pt_lim_minus f g); auto.
Qed.

Lemma holder_zero k alpha : holder k alpha (fun _ => 0).
Proof.
  induction k.
  - exists 0. intros x t. rewrite Rminus_0_r, Rabs_R0. lra.
  - exists (fun _ => 0). split; auto. intros x. apply (derivable_pt_lim_const 0).
Qed.

(* A function that is 0 from hi on is as smooth as one that it equals up to some larger number. *)
Lemma holder_local k : forall alpha f g hi top, 0 < alpha -> hi < top -> (forall x, hi < x -> f x = 0) ->
  (forall x, x <= top -> f x = g x) -> holder k alpha g -> holder k alpha f.
Proof.
  induction k; intros alpha f g hi top Ha Hlt Z E H.
  - destruct H as [C H]. exists C. intros x t. assert (Pt := exp_pos t).
    assert (C0 : 0 <= C * exp (alpha * t)) by (eapply Rle_trans; [apply Rabs_pos|apply (H 0 t)]).
    destruct (Rle_lt_dec (x + exp t) top) as [T|T]. { rewrite !E by lra. apply H. }
    rewrite (Z (x + exp t)) by lra. destruct (Rlt_le_dec hi x) as [X|X]. { rewrite Z, Rminus_0_r, Rabs_R0; auto. }
    destruct (exp_onto (top - x) ltac:(lra)) as [t' Ht']. rewrite <- (Z top) by lra. rewrite !E by lra.
    specialize (H x t'). rewrite Ht' in H. replace (x + (top - x)) with top in H by ring. eapply Rle_trans. apply H.
    assert (CP : 0 <= C). { apply (Rmult_le_reg_r (exp (alpha * t))). apply exp_pos. lra. }
    apply Rmult_le_compat_l; auto. apply exp_at_most, Rmult_le_compat_l; [lra|]. apply Subdivision.exp_reflects. lra.
  - destruct H as [g' [D H]]. set (middle := (hi + top) / 2). assert (M : hi < middle < top) by (unfold middle; lra).
    assert (Zg : forall x, hi < x < top -> g' x = 0).
    { intros x Hx. apply (uniqueness_limite g x); auto.
      apply (derivative_near g (fun _ => 0) x 0 (Rmin (x - hi) (top - x))). apply Rmin_glb_lt; lra.
      - intros y Hy. assert (B1 := Rmin_l (x - hi) (top - x)). assert (B2 := Rmin_r (x - hi) (top - x)). apply Rabs_def2 in Hy; destruct Hy.
        rewrite <- E, Z by lra. auto.
      - apply (derivable_pt_lim_const 0). }
    exists (fun x => if Rle_dec x middle then g' x else 0). split.
    + intros x. destruct (Rle_dec x middle) as [X|X].
      * apply (derivative_near f g x (g' x) (top - x)); auto. lra. intros y Hy. apply Rabs_def2 in Hy; destruct Hy. apply E. lra.
      * apply (derivative_near f (fun _ => 0) x 0 (x - hi)). lra. intros y Hy. apply Rabs_def2 in Hy; destruct Hy. apply Z. lra.
        apply (derivable_pt_lim_const 0).
    + apply (IHk alpha _ g' hi middle); auto; try lra.
      * intros x Hx. destruct (Rle_dec x middle); auto. apply Zg. lra.
      * intros x Hx. destruct (Rle_dec x middle); [auto|contradiction].
Qed.

Lemma sum_first n f : sum (S n) f = f O + sum n (fun l => f (S l)).
Proof. change (S n) with (1 + n)%nat. rewrite sum_add. change (sum 1 f) with (0 + f O). rewrite Rplus_0_l. reflexivity. Qed.

(* ---- limits of two masks ----------------------------------------------------------------------------------------- *)

Lemma sum_converges n c (u : nat -> nat -> R) v : (forall l, (l < n)%nat -> Un_cv (u l) (v l)) ->
  Un_cv (fun k => sum n (fun l => c l * u l k)) (sum n (fun l => c l * v l)).
Proof.
  induction n; intros H.
  - intros eps He. exists O. intros. simpl. unfold R_dist. rewrite Rminus_0_r, Rabs_R0. auto.
  - cbn [sum]. apply (CV_plus (fun k => sum n (fun l => c l * u l k)) (fun k => c n * u n k)). apply IHn; auto.
    intros eps He. assert (P := Rabs_pos (c n)).
    destruct (H n ltac:(lia) (eps / (Rabs (c n) + 1)) ltac:(apply Rdiv_lt_0_compat; lra)) as [n0 Hn].
    exists n0. intros k Hk. specialize (Hn k Hk). unfold R_dist in *. rewrite <- Rmult_minus_distr_l, Rabs_mult.
    assert (Q := Rabs_pos (u n k - v n)).
    apply Rle_lt_trans with ((Rabs (c n) + 1) * Rabs (u n k - v n)). apply Rmult_le_compat_r; lra.
    apply (Rmult_lt_compat_l (Rabs (c n) + 1)) in Hn; [|lra].
    replace ((Rabs (c n) + 1) * (eps / (Rabs (c n) + 1))) with eps in Hn by (field; lra). exact Hn.
Qed.

Section Masks.
Variables (A : nat) (F : Z).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.

(* Refined data near a point, always the same number of places from it, tend to the value there. *)
Lemma limit_point L a phi x k : is_limit A F L a phi -> Un_cv (fun n => refined A F L a n (floor (INR A ^ n * x) - k)%Z) (phi x).
Proof.
  intros [C H] eps He. destruct (C x (eps / 2) ltac:(lra)) as [delta [Hd Near]].
  destruct (H (eps / 3) ltac:(lra)) as [n1 H1]. assert (K0 := Rabs_pos (IZR k)).
  destruct (small_cell A Arity (delta / (2 * (1 + Rabs (IZR k)))) ltac:(apply Rdiv_lt_0_compat; lra)) as [n2 H2].
  exists (n1 + n2)%nat. intros n Hn. specialize (H1 n ltac:(lia)). specialize (H2 n ltac:(lia)). assert (P := power_positive A Arity n).
  set (i := (floor (INR A ^ n * x) - k)%Z). specialize (H1 i). set (y := IZR i / INR A ^ n) in *.
  assert (Hy : Rabs (y - x) < delta).
  { destruct (floor_bounds (INR A ^ n * x)) as [F1 F2].
    replace (y - x) with (/ INR A ^ n * ((IZR (floor (INR A ^ n * x)) - INR A ^ n * x) - IZR k))
      by (unfold y, i; rewrite minus_IZR; field; lra).
    assert (IP : 0 < / INR A ^ n) by (apply Rinv_0_lt_compat; auto). rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by lra.
    assert (B : Rabs ((IZR (floor (INR A ^ n * x)) - INR A ^ n * x) - IZR k) <= 1 + Rabs (IZR k)).
    { unfold Rminus at 1. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. apply Rplus_le_compat_r, Rabs_le. lra. }
    apply Rle_lt_trans with (delta / (2 * (1 + Rabs (IZR k))) * (1 + Rabs (IZR k))). apply Rmult_le_compat; auto; try lra. apply Rabs_pos.
    replace (delta / (2 * (1 + Rabs (IZR k))) * (1 + Rabs (IZR k))) with (delta / 2) by (field; lra). lra. }
  assert (N : Rabs (phi y - phi x) <= eps / 2).
  { destruct (Req_dec y x) as [->|N]. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra.
    left. apply Near. split. split. exact I. auto. exact Hy. }
  unfold R_dist. replace (refined A F L a n i - phi x) with ((refined A F L a n i - phi y) + (phi y - phi x)) by ring.
  eapply Rle_lt_trans. apply Rabs_triang. lra.
Qed.

Lemma limit_zero L a phi : supported F L a -> is_limit A F L a phi ->
  let B := IZR (Z.abs F + Z.of_nat L + 1) in vanishes (- B) B phi.
Proof.
  intros S H B x Hx. apply (UL_sequence (fun n => refined A F L a n (floor (INR A ^ n * x) - 0)%Z)). apply limit_point; auto.
  intros eps He. exists O. intros n _. rewrite Z.sub_0_r, (refined_support A F L Arity L a n S (le_n L)).
  { unfold R_dist. rewrite Rminus_0_r, Rabs_R0. auto. }
  assert (P := power_positive A Arity n). destruct (floor_bounds (INR A ^ n * x)) as [F1 F2]. set (i := floor (INR A ^ n * x)) in *.
  assert (Q : (0 < Z.of_nat A ^ Z.of_nat n)%Z) by (apply Z.pow_pos_nonneg; lia).
  rewrite <- (Subdivision.arity_power A Arity) in *. set (q := (Z.of_nat A ^ Z.of_nat n)%Z) in *.
  set (w := (Z.abs F + Z.of_nat L + 1)%Z) in *. assert (A2 : (2 <= Z.of_nat A)%Z) by lia. destruct Hx as [Hx|Hx]; [left|right].
  - assert (X : IZR q * x < IZR q * - B) by (apply Rmult_lt_compat_l; auto).
    assert (I : (i < q * - w)%Z). { apply lt_IZR. rewrite mult_IZR, opp_IZR. fold B. lra. }
    assert (M : ((Z.of_nat A - 1) * i <= 1 * i)%Z) by (apply Z.mul_le_mono_nonpos_r; nia).
    assert (- Z.abs F * q <= F * q)%Z by (apply Z.mul_le_mono_nonneg_r; lia). unfold w in I. nia.
  - assert (X : IZR q * B < IZR q * x) by (apply Rmult_lt_compat_l; auto).
    assert (I : (q * w < i + 1)%Z). { apply lt_IZR. rewrite plus_IZR, mult_IZR. fold B. lra. }
    assert (M : (1 * i <= (Z.of_nat A - 1) * i)%Z) by (apply Z.mul_le_mono_nonneg_r; nia).
    assert ((F + Z.of_nat L) * (q - 1) <= (Z.abs F + Z.of_nat L) * (q - 1))%Z by (apply Z.mul_le_mono_nonneg_r; lia). unfold w in I. nia.
Qed.

Section Factor.
Variables (La Lb d : nat) (a b : Z -> R) (p : nat -> R) (phi psi : R -> R).
Hypothesis SupportA : supported F La a.
Hypothesis SupportB : supported F Lb b.
Hypothesis Relation : forall i, sum (S d) (fun l => p l * a (i - Z.of_nat l)%Z) = sum (S d) (fun l => p l * b (i - ZA * Z.of_nat l)%Z).

(* One step *)
Lemma step_relation f i : sum (S d) (fun l => p l * subdivide A F La a f (i - Z.of_nat l)) =
  subdivide A F Lb b (fun j => sum (S d) (fun l => p l * f (j - Z.of_nat l)%Z)) i.
Proof.
  rewrite (subdivide_sum A F Lb b (S d) p (fun l j => f (j - Z.of_nat l)%Z)).
  set (w := (Z.abs i + Z.abs F + Z.of_nat La + Z.of_nat Lb + Z.of_nat d + 1)%Z). set (m := Z.to_nat (2 * w + 1)).
  assert (A2 : (2 <= Z.of_nat A)%Z) by lia.
  assert (Out : forall K c, supported F K c -> (K <= La + Lb)%nat -> forall l, (l < S d)%nat -> forall j, (j < - w \/ - w + Z.of_nat m <= j)%Z ->
    c (i - Z.of_nat l - ZA * j)%Z = 0 /\ c (i - ZA * Z.of_nat l - ZA * j)%Z = 0).
  { intros K c Sc HK l Hl j Hj. unfold ZA. replace (Z.of_nat m) with (2 * w + 1)%Z in Hj by (unfold m, w; lia). split; apply Sc.
    - destruct Hj as [Hj|Hj]; [right|left].
      + assert (Z.of_nat A * (w + 1) <= Z.of_nat A * - j)%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        assert (2 * (w + 1) <= Z.of_nat A * (w + 1))%Z by (apply Z.mul_le_mono_nonneg_r; unfold w; lia). unfold w in *. lia.
      + assert (Z.of_nat A * (w + 1) <= Z.of_nat A * j)%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        assert (2 * (w + 1) <= Z.of_nat A * (w + 1))%Z by (apply Z.mul_le_mono_nonneg_r; unfold w; lia). unfold w in *. lia.
    - replace (i - Z.of_nat A * Z.of_nat l - Z.of_nat A * j)%Z with (i - Z.of_nat A * (Z.of_nat l + j))%Z by ring. destruct Hj as [Hj|Hj]; [right|left].
      + assert (Z.of_nat A * (w + 1 - Z.of_nat d) <= Z.of_nat A * - (Z.of_nat l + j))%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        assert (2 * (w + 1 - Z.of_nat d) <= Z.of_nat A * (w + 1 - Z.of_nat d))%Z by (apply Z.mul_le_mono_nonneg_r; unfold w; lia). unfold w in *. lia.
      + assert (Z.of_nat A * (w + 1) <= Z.of_nat A * (Z.of_nat l + j))%Z by (apply Z.mul_le_mono_nonneg_l; lia).
        assert (2 * (w + 1) <= Z.of_nat A * (w + 1))%Z by (apply Z.mul_le_mono_nonneg_r; unfold w; lia). unfold w in *. lia. }
  transitivity (sum (S d) (fun l => sum m (fun k => p l * a (i - Z.of_nat l - ZA * (- w + Z.of_nat k))%Z * f (- w + Z.of_nat k)%Z))).
  { apply sum_ext; intros l Hl. rewrite <- (subdivide_window A F La Arity La a f (i - Z.of_nat l) (- w) m) by
      (auto; intros j Hj; apply (Out La a SupportA ltac:(lia) l Hl j Hj)).
    rewrite <- sum_scal. apply sum_ext; intros k Hk. fold ZA. ring. }
  transitivity (sum (S d) (fun l => sum m (fun k => p l * b (i - ZA * Z.of_nat l - ZA * (- w + Z.of_nat k))%Z * f (- w + Z.of_nat k)%Z))).
  - rewrite !(sum_swap (S d) m). apply sum_ext; intros k Hk. specialize (Relation (i - ZA * (- w + Z.of_nat k))).
    apply (f_equal (fun y => f (- w + Z.of_nat k)%Z * y)) in Relation. rewrite <- !sum_scal in Relation.
    rewrite (sum_ext (S d) _ (fun l => f (- w + Z.of_nat k)%Z * (p l * a (i - ZA * (- w + Z.of_nat k) - Z.of_nat l)%Z))).
    + rewrite Relation. apply sum_ext; intros l Hl. rewrite Rmult_comm. do 3 f_equal. ring.
    + intros l Hl. rewrite Rmult_comm. do 3 f_equal. ring.
  - apply sum_ext; intros l Hl. rewrite (subdivide_shift A F Lb Arity). fold ZA.
    rewrite <- (subdivide_window A F Lb Arity Lb b f (i - ZA * Z.of_nat l) (- w) m) by
      (auto; intros j Hj; apply (Out Lb b SupportB ltac:(lia) l Hl j Hj)).
    rewrite <- sum_scal. apply sum_ext; intros k Hk. fold ZA. ring.
Qed.

(* n steps: the symbol of a times p(z) is that of b times p(z^(A^n)). *)
Lemma steps_relation n : forall i, sum (S d) (fun l => p l * refined A F La a n (i - Z.of_nat l)) =
  sum (S d) (fun l => p l * refined A F Lb b n (i - ZA ^ Z.of_nat n * Z.of_nat l)).
Proof.
  induction n; intros i.
  - apply sum_ext; intros l Hl. change (ZA ^ Z.of_nat 0)%Z with 1%Z. cbn [refined]. do 2 f_equal. ring.
  - cbn [refined]. rewrite step_relation, (subdivide_ext A F Lb b _ _ i IHn).
    rewrite (subdivide_sum A F Lb b (S d) p (fun l j => refined A F Lb b n (j - ZA ^ Z.of_nat n * Z.of_nat l))).
    apply sum_ext; intros l Hl. rewrite (subdivide_shift A F Lb Arity). do 2 f_equal. rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. fold ZA. ring.
Qed.

Hypothesis Phi : is_limit A F La a phi.
Hypothesis Psi : is_limit A F Lb b psi.
Let whole := sum (S d) p.

(* p(1) times the one limit is a combination of the other. *)
Theorem limit_relation x : whole * phi x = mix (S d) p psi x.
Proof.
  apply (UL_sequence (fun n => sum (S d) (fun l => p l * refined A F La a n (floor (INR A ^ n * x) - Z.of_nat l)%Z))).
  - replace (whole * phi x) with (sum (S d) (fun l => p l * phi x)) by (unfold whole; rewrite Rmult_comm, <- sum_scal; apply sum_ext; intros; ring).
    apply (sum_converges (S d) p (fun l n => refined A F La a n (floor (INR A ^ n * x) - Z.of_nat l)%Z) (fun _ => phi x)).
    intros l Hl. apply limit_point. exact Phi.
  - replace (fun n => sum (S d) (fun l => p l * refined A F La a n (floor (INR A ^ n * x) - Z.of_nat l)%Z)) with
      (fun n => sum (S d) (fun l => p l * refined A F Lb b n (floor (INR A ^ n * (x - INR l)) - 0)%Z)).
    + apply (sum_converges (S d) p (fun l n => refined A F Lb b n (floor (INR A ^ n * (x - INR l)) - 0)%Z) (fun l => psi (x - INR l))).
      intros l Hl. apply limit_point. exact Psi.
    + extensionality n. rewrite steps_relation. apply sum_ext; intros l Hl. do 2 f_equal.
      rewrite Z.sub_0_r, (INR_IZR_INZ l). apply (floor_shift A Arity).
Qed.

Hypothesis Whole : whole <> 0.
Hypothesis First : p O <> 0.
Let bound := IZR (Z.abs F + Z.of_nat Lb + 1).
Let rest (l : nat) : R := match l with O => 0 | _ => p l end.

Lemma psi_vanishes : vanishes (- bound) bound psi.
Proof. apply (limit_zero Lb b psi SupportB Psi). Qed.

Lemma mix_first f x : mix (S d) p f x = p O * f x + mix (S d) rest f x.
Proof. unfold mix. rewrite !sum_first. unfold rest. rewrite Rminus_0_r. ring. Qed.

Lemma bound_positive : 0 < bound.
Proof. apply IZR_lt. lia. Qed.

Lemma beyond x : exists m, x < - bound - 1 + INR m.
Proof.
  destruct (archimed (x + bound + 1)) as [U _]. exists (Z.to_nat (Z.max 0 (up (x + bound + 1)))).
  rewrite INR_IZR_INZ, Z2Nat.id by lia. assert (IZR (up (x + bound + 1)) <= IZR (Z.max 0 (up (x + bound + 1)))) by (apply IZR_le; lia). lra.
Qed.

(* Each of them is as smooth as the other one. *)
Theorem holder_phi k alpha : holder k alpha psi -> holder k alpha phi.
Proof.
  intros H. replace phi with (fun x => / whole * mix (S d) p psi x).
  apply holder_scal, holder_mix, H. extensionality x. rewrite <- limit_relation. field. exact Whole.
Qed.

Theorem holder_psi k alpha : 0 < alpha -> holder k alpha phi -> holder k alpha psi.
Proof.
  intros Ha H. assert (V := psi_vanishes).
  assert (Up : forall m, exists g, holder k alpha g /\ forall x, x <= - bound - 1 + INR m -> psi x = g x).
  { induction m as [|m [g [Hg E]]].
    - exists (fun _ => 0). split. apply holder_zero. intros x Hx. apply V. simpl in Hx. lra.
    - exists (fun x => / p O * (whole * phi x - mix (S d) rest g x)). split.
      + apply holder_scal, holder_minus. apply holder_scal, H. apply holder_mix, Hg.
      + intros x Hx. rewrite limit_relation, mix_first. replace (mix (S d) rest psi x) with (mix (S d) rest g x). field; auto.
        unfold mix. apply sum_ext; intros l Hl. destruct l as [|l]. simpl. ring. rewrite E. auto. rewrite S_INR in *. assert (Q := pos_INR l). lra. }
  destruct (beyond bound) as [m Hm]. destruct (Up m) as [g [Hg E]].
  apply (holder_local k alpha psi g bound (- bound - 1 + INR m)); auto.
Qed.

Theorem same_exponents s : exponents phi s <-> exponents psi s.
Proof.
  split; intros [k [alpha [Ha [E H]]]]; exists k, alpha; split; auto; split; auto. apply holder_psi; auto; lra. apply holder_phi; auto.
Qed.

Theorem modulus_phi lambda s P : exp lambda = INR A -> has_modulus lambda s P psi -> has_modulus lambda s P phi.
Proof.
  intros Log [k [g [c [C [Ks [C0 [D [Up Low]]]]]]]]. assert (Lam := log_positive A Arity lambda Log).
  assert (V := derivative_vanishes _ _ k psi g D psi_vanishes). assert (B0 := bound_positive).
  set (h := fun x => / whole * mix (S d) p g x).
  assert (Rel : forall x, whole * h x = mix (S d) p g x) by (intros x; unfold h; field; exact Whole).
  set (T := sum (S d) (fun l => Rabs (p l))).
  assert (Change : forall m, exists E, 0 <= E /\ forall r w, (forall x t, 0 < t <= r -> Rabs (h (x + t) - h x) <= w) ->
    forall x t, 0 < t <= r -> x + t <= - bound - 1 + INR m -> Rabs (g (x + t) - g x) <= E * w).
  { induction m as [|m [E [E0 IH]]].
    - exists 0. split. lra. intros r w _ x t Ht Hx. simpl in Hx. rewrite !V, Rminus_0_r, Rabs_R0 by lra. lra.
    - assert (P0 : 0 < Rabs (p O)) by (apply Rabs_pos_lt; auto). set (S1 := sum (S d) (fun l => Rabs (rest l))).
      assert (S0 : 0 <= S1) by (apply sum_nonneg; intros; apply Rabs_pos). assert (W0 := Rabs_pos whole).
      exists (/ Rabs (p O) * (Rabs whole + S1 * E)). split.
      { apply Rmult_le_pos. left; apply Rinv_0_lt_compat; auto. assert (0 <= S1 * E) by (apply Rmult_le_pos; auto). lra. }
      intros r w Hw x t Ht Hx. specialize (IH r w Hw).
      assert (Eq : p O * (g (x + t) - g x) = whole * (h (x + t) - h x) - (mix (S d) rest g (x + t) - mix (S d) rest g x)).
      { assert (R1 := Rel x). assert (R2 := Rel (x + t)). rewrite mix_first in R1, R2. lra. }
      assert (Mix : Rabs (mix (S d) rest g (x + t) - mix (S d) rest g x) <= S1 * (E * w)).
      { unfold mix. rewrite <- sum_minus. eapply Rle_trans. apply sum_abs. unfold S1. rewrite Rmult_comm, <- sum_scal.
        apply sum_le; intros l Hl. rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_comm. destruct l as [|l].
        - simpl rest. rewrite Rabs_R0. lra.
        - apply Rmult_le_compat_r. apply Rabs_pos. replace (x + t - INR (S l)) with (x - INR (S l) + t) by ring. apply IH; auto.
          rewrite S_INR in *. assert (Q := pos_INR l). lra. }
      apply (Rmult_le_reg_l (Rabs (p O))); auto. rewrite <- Rabs_mult, Eq.
      replace (Rabs (p O) * (/ Rabs (p O) * (Rabs whole + S1 * E) * w)) with (Rabs whole * w + S1 * (E * w)) by (field; lra).
      unfold Rminus at 1. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp, Rabs_mult. apply Rplus_le_compat; auto.
      apply Rmult_le_compat_l; auto. }
  destruct (beyond (bound + 1)) as [m Hm]. destruct (Change m) as [E [E0 HE]].
  exists k, h, (/ (E + 1) * c), (/ Rabs whole * (T * C)). split; auto. split; [|split; [|split]].
  - apply Rmult_lt_0_compat; auto. apply Rinv_0_lt_compat. lra.
  - replace phi with (fun x => / whole * mix (S d) p psi x).
    + apply derivative_sequence_scal, derivative_sequence_mix, D.
    + extensionality x. rewrite <- limit_relation. field. exact Whole.
  - intros x t Ht. unfold h. rewrite <- Rmult_minus_distr_l, Rabs_mult, Rabs_inv, !Rmult_assoc.
    apply Rmult_le_compat_l. left. apply Rinv_0_lt_compat, Rabs_pos_lt, Whole.
    apply mix_change. intros l Hl. replace (x + exp t - INR l) with (x - INR l + exp t) by ring. rewrite <- Rmult_assoc. apply Up. auto.
  - intros n w Hn Hw. assert (HE' := HE _ w Hw). set (r := exp (- (INR n * lambda))) in *.
    assert (R1 : 0 < r <= 1). { split. apply exp_pos. unfold r. rewrite <- exp_0. apply exp_at_most.
      assert (0 <= INR n * lambda) by (apply Rmult_le_pos; [apply pos_INR|lra]). lra. }
    assert (W0 : 0 <= w) by (eapply Rle_trans; [apply Rabs_pos|apply (Hw 0 r); lra]).
    assert (Low' : c * exp (- ((s - INR k) * (INR n * lambda))) * (INR n * lambda) ^ P <= E * w).
    { apply (Low n); auto. intros x t Ht. fold r in Ht. destruct (Rle_lt_dec (x + t) (bound + 1)). apply HE'; auto. lra.
      rewrite !V, Rminus_0_r, Rabs_R0 by lra. apply Rmult_le_pos; auto. }
    rewrite !(Rmult_assoc (/ (E + 1))). apply (Rmult_le_reg_l (E + 1)). lra. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. lra.
Qed.
End Factor.
End Masks.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

Open Scope Z_scope.

(* The other mask and the coefficients of p; and why the scheme of the mask of the claim converges: the order of its
   differences, and a bound of their radius. *)
Record reduction := Reduction { shift_factor : list Z; other_scheme : scheme; own_order : nat; own_bound : Q; own_radius : certificate }.

Definition converges (a : scheme) (c : reduction) : bool :=
  let m := own_order c in let u := own_bound c in
  (1 <=? m)%nat && reducible a m && (Qnum u <? Z.of_nat (arity a) ^ Z.of_nat m * Zpos (Qden u)) &&
  check_radius (Claim (difference_family a m) None (Some u)) (own_radius c).

Definition check_factor (a b : scheme) (p : list Z) : bool :=
  (arity b =? arity a)%nat && (first b =? first a) && (0 <? common b) &&
  negb (nth 0 p 0 =? 0) && negb (fold_right Z.add 0 p =? 0) &&
  same (map (Z.mul (common b)) (times_up 1 p (coefficients a))) (map (Z.mul (common a)) (times_up (arity a) p (coefficients b))).

(* What is to be shown of a mask is shown of the other one. *)
Definition check_reduced (a : scheme) (c : reduction) (check : scheme -> bool) : bool :=
  check_factor a (other_scheme c) (shift_factor c) && converges a c && check (other_scheme c).

(* ---- what it says ------------------------------------------------------------------------------------------------ *)

Lemma coefficient_supported l e F : supported F (length l - 1) (coefficient l e F).
Proof. intros i Hi. rewrite coefficient_shift. apply coefficient_support. lia. Qed.

Lemma converges_sound a c : converges a c = true -> exists phi, limit_of a phi.
Proof.
  intros H. unfold converges in H. cbv zeta in H. repeat rewrite andb_true_iff in H. destruct H as [[[H1 H2] H3] H4].
  set (m := own_order c) in *. set (u := own_bound c) in *. apply Nat.leb_le in H1. apply Z.ltb_lt, IZR_lt in H3.
  assert (HA : (2 <= arity a)%nat).
  { unfold reducible in H2. repeat rewrite andb_true_iff in H2. destruct H2 as [[[HA _] _] _]. apply Nat.leb_le; auto. }
  destruct (exp_onto (INR (arity a)) (arity_positive (arity a) HA)) as [lambda Log].
  assert (Lam := log_positive (arity a) HA lambda Log). set (most := Rmax (real_of u) 1).
  assert (M1 : (real_of u <= most /\ 1 <= most)%R) by (split; [apply Rmax_l|apply Rmax_r]).
  assert (D : (0 < IZR (Zpos (Qden u)))%R) by (apply IZR_lt; lia).
  assert (Em : (exp (INR m * lambda) = INR (arity a) ^ m)%R) by (rewrite <- exp_power, Log; auto).
  assert (M2 : (most < exp (INR m * lambda))%R).
  { apply Rmax_lub_lt.
    - rewrite mult_IZR, (Subdivision.arity_power (arity a) HA), <- Em in H3. unfold real_of. apply (Rmult_lt_reg_r (IZR (Zpos (Qden u)))); auto.
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
    - rewrite <- exp_0. apply exp_less. apply Rmult_lt_0_compat; auto. apply (lt_INR 0). lia. }
  destruct (log_onto lambda m most Lam ltac:(lra)) as [l Hl].
  assert (L0 : (0 < l)%R).
  { apply Rnot_le_lt. intros N. assert (exp (INR m * lambda) <= exp ((INR m - l) * lambda))%R; [|lra].
    apply exp_at_most. apply Rmult_le_compat_r; lra. }
  assert (L1 : (l <= INR m)%R).
  { apply Rnot_lt_le. intros N. assert (exp ((INR m - l) * lambda) < 1)%R; [|lra]. rewrite <- exp_0. apply exp_less.
    assert (0 < (l - INR m) * lambda)%R by (apply Rmult_lt_0_compat; lra). lra. }
  destruct (limit_of_growth a lambda l m most H2 Log (conj L0 L1) ltac:(lra)) as [phi [Lim _]].
  - apply check_radius_sound, radius_bounded in H4. intros r Hr R0. apply H4; auto. lra.
  - exists phi. exact Lim.
Qed.

Lemma factor_relation a b p : check_factor a b p = true -> 0 < common a -> (2 <= arity a)%nat -> forall i,
  let q := fun l => IZR (nth l p 0) in
  sum (S (length p - 1)) (fun l => q l * coefficient (coefficients a) (common a) (first a) (i - Z.of_nat l))%R =
  sum (S (length p - 1)) (fun l => q l * coefficient (coefficients b) (common b) (first a) (i - Z.of_nat (arity a) * Z.of_nat l))%R.
Proof.
  intros H Da HA i q. unfold check_factor in H. repeat rewrite andb_true_iff in H. destruct H as [[[[[_ _] Db] H0] _] Hs].
  apply Z.ltb_lt in Db. apply negb_true_iff, Z.eqb_neq in H0. apply same_spec in Hs.
  assert (Lp : S (length p - 1) = length p) by (destruct p; simpl in *; lia). rewrite Lp.
  assert (Pa : (0 < IZR (common a))%R) by (apply IZR_lt; auto). assert (Pb : (0 < IZR (common b))%R) by (apply IZR_lt; auto).
  assert (Scale : forall l e f k, 0 < e -> 0 < f -> coefficient (map (Z.mul e) l) (e * f) (first a) k = coefficient l f (first a) k).
  { intros l e f k He Hf. apply IZR_lt in He, Hf. rewrite coefficient_map. unfold coefficient. destruct (k <? first a). ring. rewrite mult_IZR. field. lra. }
  assert (E := f_equal (fun l => coefficient l (common b * common a) (first a) i) Hs). cbv beta in E.
  rewrite Scale in E by auto. rewrite (Z.mul_comm (common b)), Scale in E by auto. rewrite !coefficient_times in E.
  etransitivity; [|exact E]. apply sum_ext; intros l Hl. unfold q. do 2 f_equal. lia.
Qed.

(* The limits of both schemes are alike. *)
Theorem reduced_limit a c check : check_reduced a c check = true -> check (other_scheme c) = true /\ arity (other_scheme c) = arity a /\
  forall psi, limit_of (other_scheme c) psi -> exists phi, limit_of a phi /\ (forall s, exponents phi s <-> exponents psi s) /\
  forall lambda s P, exp lambda = INR (arity a) -> has_modulus lambda s P psi -> has_modulus lambda s P phi.
Proof.
  intros H. unfold check_reduced in H. repeat rewrite andb_true_iff in H. destruct H as [[HF HC] H]. split; auto.
  assert (Facts : (2 <= arity a)%nat /\ 0 < common a).
  { unfold converges in HC. cbv zeta in HC. repeat rewrite andb_true_iff in HC. destruct HC as [[[_ HC] _] _].
    unfold reducible in HC. repeat rewrite andb_true_iff in HC. destruct HC as [[[HA HD] _] _]. apply Nat.leb_le in HA. apply Z.ltb_lt in HD. auto. }
  destruct Facts as [HA HD]. destruct (converges_sound a c HC) as [phi Lim].
  assert (Rel := factor_relation a (other_scheme c) (shift_factor c) HF HD HA). cbv zeta in Rel.
  unfold check_factor in HF. repeat rewrite andb_true_iff in HF. destruct HF as [[[[[E1 E2] Db] H0] H1] _].
  apply Nat.eqb_eq in E1. apply Z.eqb_eq in E2. apply negb_true_iff, Z.eqb_neq in H0, H1. split; auto.
  set (p := shift_factor c) in *. set (b := other_scheme c) in *. set (q := fun l => IZR (nth l p 0)) in *.
  assert (Whole : sum (S (length p - 1)) q <> 0%R). { unfold q. rewrite sum_list by lia. apply not_0_IZR. auto. }
  assert (First : q O <> 0%R) by (apply not_0_IZR; auto).
  intros psi Lim'. exists phi. split; auto. unfold limit_of in Lim, Lim'. rewrite E1, E2 in Lim'. split.
  - intros s. eapply same_exponents; eauto using coefficient_supported.
  - intros lambda s P Log M. eapply modulus_phi; eauto using coefficient_supported.
Qed.

(* What the checker accepts is true. *)
Theorem check_reduced_exponent_lower_sound a c l cert :
  check_reduced a c (fun b => check_exponent_lower b l cert) = true -> exponent_holds a l.
Proof.
  intros H. apply reduced_limit in H. destruct H as [H [_ Same]]. apply check_exponent_lower_sound in H. destruct H as [psi [Lim Ex]].
  destruct (Same psi Lim) as [phi [Lim' [E _]]]. exists phi. split; auto. intros x Hx. destruct (Ex x Hx) as [s [Hs Xs]].
  exists s. split; auto. apply E. auto.
Qed.

Theorem check_reduced_exponent_sound a c l u cert :
  check_reduced a c (fun b => check_exponent b l u cert) = true -> enclosure_holds a l u.
Proof.
  intros H. apply reduced_limit in H. destruct H as [H [_ Same]]. apply check_exponent_sound in H. destruct H as [psi [Lim [Lo Hi]]].
  destruct (Same psi Lim) as [phi [Lim' [E _]]]. exists phi. split; auto. split.
  - intros x Hx. destruct (Lo x Hx) as [s [Hs Xs]]. exists s. split; auto. apply E. auto.
  - intros s Hs. apply Hi, E, Hs.
Qed.

Lemma same_lub (P Q : R -> Prop) s : (forall x, P x <-> Q x) -> is_lub Q s -> is_lub P s.
Proof.
  intros E [U M]. split. intros x Hx. apply U, E, Hx. intros b Hb. apply M. intros x Hx. apply Hb, E, Hx.
Qed.

Theorem check_reduced_exact_exponent_sound a c order e lower upper cert shifts :
  check_reduced a c (fun b => check_exact_exponent b order e lower upper cert shifts) = true -> exact_exponent_holds a order e lower upper.
Proof.
  intros H. apply reduced_limit in H. destruct H as [H [Ar Same]]. apply check_exact_exponent_sound in H.
  destruct H as [One [psi [r [s [lambda [Lim [Nr [Log [Es [Lub W]]]]]]]]]]. rewrite Ar in Log.
  destruct (Same psi Lim) as [phi [Lim' [E _]]]. split; auto. exists phi, r, s, lambda. split; auto. split; auto. split; auto. split; auto.
  split; auto. apply (same_lub _ _ s E Lub).
Qed.

Theorem check_reduced_logarithm_sound a c order e lower upper cert shifts proof P :
  check_reduced a c (fun b => check_logarithm b order e lower upper cert shifts proof P) = true -> logarithm_holds a order e lower upper P.
Proof.
  intros H. apply reduced_limit in H. destruct H as [H [Ar Same]]. apply check_logarithm_sound in H.
  destruct H as [One [psi [r [s [lambda [Lim [Nr [Log [Es [Lub [W M]]]]]]]]]]]. rewrite Ar in Log.
  destruct (Same psi Lim) as [phi [Lim' [E Mod]]]. split; auto. exists phi, r, s, lambda. split; auto. split; auto. split; auto. split; auto.
  split. apply (same_lub _ _ s E Lub). split; auto.
Qed.
