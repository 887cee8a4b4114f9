(* Functions with so many derivatives, of which the last one is of a kind: combinations of their shifts, and limits of
   schemes. *)
Require Import Reals List ZArith Lia Lra ClassicalDedekindReals.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision Differences Stability Values Modulus.
Open Scope R_scope.

(* f has k derivatives, and the last one is of the kind: f is C^k if that is `continuity`. *)
Fixpoint smooth (kind : (R -> R) -> Prop) (k : nat) (f : R -> R) : Prop :=
  match k with O => kind f | S m => exists f', (forall x, derivable_pt_lim f x (f' x)) /\ smooth kind m f' end.

Lemma smooth_holder k alpha : forall f, holder k alpha f <-> smooth (holder 0 alpha) k f.
Proof.
  induction k; intros f; [reflexivity|]. split; intros [f' [D H]]; exists f'; (split; [exact D|]); apply IHk; exact H.
Qed.

Lemma smooth_derivative_sequence kind k : forall f, smooth kind k f -> exists g, derivative k f g /\ kind g.
Proof.
  induction k; intros f H. exists f. split; [intros x; reflexivity|exact H].
  destruct H as [f' [D H]]. destruct (IHk f' H) as [g [G K]]. exists g. split; auto. exists f'. auto.
Qed.

(* ---- combinations of shifts -------------------------------------------------------------------------------------- *)

(* The sum of p l f (x - l) over l < n *)
Definition mix (n : nat) (p : nat -> R) (f : R -> R) : R -> R := fun x => sum n (fun l => p l * f (x - INR l)).

Lemma mix_change n p f C x y : (forall l, (l < n)%nat -> Rabs (f (y - INR l) - f (x - INR l)) <= C) ->
  Rabs (mix n p f y - mix n p f x) <= sum n (fun l => Rabs (p l)) * C.
Proof.
  intros H. unfold mix. rewrite <- sum_minus. eapply Rle_trans. apply sum_abs. rewrite Rmult_comm, <- sum_scal.
  apply sum_le; intros l Hl. rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos. auto.
Qed.

Lemma derivative_near f g x l r : 0 < r -> (forall y,
  Rabs (y - x) < r -> f y = g y) -> derivable_pt_lim g x l -> derivable_pt_lim f x l.
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

(* A kind of functions that allows all that *)
Definition closed (kind : (R -> R) -> Prop) : Prop :=
  kind (fun _ => 0) /\ (forall c f, kind f -> kind (fun x => c * f x)) /\
  (forall f g, kind f -> kind g -> kind (fun x => f x - g x)) /\ (forall n p f, kind f -> kind (mix n p f)) /\
  forall f g hi top, hi < top -> (forall x, hi < x -> f x = 0) -> (forall x, x <= top -> f x = g x) -> kind g -> kind f.

Section Closed.
Variable kind : (R -> R) -> Prop.
Hypothesis Closed : closed kind.

Lemma smooth_mix n p k : forall f, smooth kind k f -> smooth kind k (mix n p f).
Proof.
  induction k; intros f H. apply Closed, H.
  destruct H as [f' [D H]]. exists (mix n p f'). split; auto. apply derivative_mix. auto.
Qed.

Lemma smooth_scal c k : forall f, smooth kind k f -> smooth kind k (fun x => c * f x).
Proof.
  induction k; intros f H. apply Closed, H.
  destruct H as [f' [D H]]. exists (fun x => c * f' x). split; auto. intros x. apply (derivable_pt_lim_scal f). auto.
Qed.

Lemma smooth_minus k : forall f g, smooth kind k f -> smooth kind k g -> smooth kind k (fun x => f x - g x).
Proof.
  induction k; intros f g H G. apply Closed; auto.
  destruct H as [f' [D H]], G as [g' [E G]]. exists (fun x => f' x - g' x). split; auto.
  intros x. apply (derivable_pt_lim_minus f g); auto.
Qed.

Lemma smooth_zero k : smooth kind k (fun _ => 0).
Proof. induction k. apply Closed. exists (fun _ => 0). split; auto. intros x. apply (derivable_pt_lim_const 0). Qed.

(* A function that is 0 from hi on is as smooth as one that it equals up to some larger number. *)
Lemma smooth_local k : forall f g hi top, hi < top -> (forall x, hi < x -> f x = 0) -> (forall x, x <= top -> f x = g x) ->
  smooth kind k g -> smooth kind k f.
Proof.
  induction k; intros f g hi top Hlt Z E H. { destruct Closed as [_ [_ [_ [_ L]]]]. apply (L f g hi top); auto. }
  destruct H as [g' [D H]]. set (middle := (hi + top) / 2). assert (M : hi < middle < top) by (unfold middle; lra).
  assert (Zg : forall x, hi < x < top -> g' x = 0).
  { intros x Hx. apply (uniqueness_limite g x); auto.
    apply (derivative_near g (fun _ => 0) x 0 (Rmin (x - hi) (top - x))). apply Rmin_glb_lt; lra.
    - intros y Hy. assert (B1 := Rmin_l (x - hi) (top - x)). assert (B2 := Rmin_r (x - hi) (top - x)).
      apply Rabs_def2 in Hy; destruct Hy.
      rewrite <- E, Z by lra. auto.
    - apply (derivable_pt_lim_const 0). }
  exists (fun x => if Rle_dec x middle then g' x else 0). split.
  + intros x. destruct (Rle_dec x middle) as [X|X].
    * apply (derivative_near f g x (g' x) (top - x)); auto. lra. intros y Hy. apply Rabs_def2 in Hy; destruct Hy. apply E. lra.
    * apply (derivative_near f (fun _ => 0) x 0 (x - hi)). lra. intros y Hy. apply Rabs_def2 in Hy; destruct Hy. apply Z. lra.
      apply (derivable_pt_lim_const 0).
  + apply (IHk _ g' hi middle); auto; try lra.
    * intros x Hx. destruct (Rle_dec x middle); auto. apply Zg. lra.
    * intros x Hx. destruct (Rle_dec x middle); [auto|contradiction].
Qed.

End Closed.

Lemma closed_holder alpha : 0 < alpha -> closed (holder 0 alpha).
Proof.
  intros Ha. split; [|split; [|split; [|split]]].
  - exists 0. intros x t. rewrite Rminus_0_r, Rabs_R0. lra.
  - intros c f [C H]. exists (Rabs c * C). intros x t. rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_assoc.
    apply Rmult_le_compat_l. apply Rabs_pos. auto.
  - intros f g [C H] [C' G]. exists (C + C'). intros x t.
    replace (f (x + exp t) - g (x + exp t) - (f x - g x)) with ((f (x + exp t) - f x) + - (g (x + exp t) - g x)) by ring.
    eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp, Rmult_plus_distr_r. apply Rplus_le_compat; auto.
  - intros n p f [C H]. exists (sum n (fun l => Rabs (p l)) * C). intros x t. rewrite Rmult_assoc. apply mix_change. intros l Hl.
    replace (x + exp t - INR l) with (x - INR l + exp t) by ring. apply H.
  - intros f g hi top Hlt Z E H.
    destruct H as [C H]. exists C. intros x t. assert (Pt := exp_pos t).
    assert (C0 : 0 <= C * exp (alpha * t)) by (eapply Rle_trans; [apply Rabs_pos|apply (H 0 t)]).
    destruct (Rle_lt_dec (x + exp t) top) as [T|T]. { rewrite !E by lra. apply H. }
    rewrite (Z (x + exp t)) by lra. destruct (Rlt_le_dec hi x) as [X|X]. { rewrite Z, Rminus_0_r, Rabs_R0; auto. }
    destruct (exp_onto (top - x) ltac:(lra)) as [t' Ht']. rewrite <- (Z top) by lra. rewrite !E by lra.
    specialize (H x t'). rewrite Ht' in H. replace (x + (top - x)) with top in H by ring. eapply Rle_trans. apply H.
    assert (CP : 0 <= C). { apply (Rmult_le_reg_r (exp (alpha * t))). apply exp_pos. lra. }
    apply Rmult_le_compat_l; auto. apply exp_at_most, Rmult_le_compat_l; [lra|]. apply Subdivision.exp_reflects. lra.
Qed.

Lemma continuous_near f g x r : 0 < r -> (forall y, Rabs (y - x) < r -> f y = g y) -> continuity_pt g x -> continuity_pt f x.
Proof.
  intros Hr E C eps He. destruct (C eps He) as [d [Hd H]]. exists (Rmin d r). split. apply Rmin_glb_lt; auto.
  intros y [Dy Hy]. simpl in *. unfold R_dist in *. rewrite !E.
  - apply H. split; auto. eapply Rlt_le_trans. apply Hy. apply Rmin_l.
  - rewrite Rminus_diag_eq, Rabs_R0; auto.
  - eapply Rlt_le_trans. apply Hy. apply Rmin_r.
Qed.

Lemma closed_continuity : closed continuity.
Proof.
  split; [|split; [|split; [|split]]].
  - apply continuity_const. intros x y. auto.
  - intros c f H. apply (continuity_scal f c H).
  - intros f g H G. apply (continuity_minus f g H G).
  - intros n p f H. induction n. apply continuity_const. intros x y. auto.
    apply (continuity_plus (mix n p f) (fun x => p n * f (x - INR n))); auto.
    apply (continuity_scal (fun x => f (x - INR n)) (p n)).
    apply (continuity_comp (fun x => x - INR n) f); auto. apply derivable_continuous. intros x. exists 1.
    replace 1 with (1 - 0) by ring. apply (derivable_pt_lim_minus id (fun _ => INR n)). apply derivable_pt_lim_id.
    apply derivable_pt_lim_const.
  - intros f g hi top Hlt Z E H x. destruct (Rlt_le_dec x top) as [X|X].
    + apply (continuous_near f g x (top - x)); auto. lra. intros y Hy. apply Rabs_def2 in Hy; destruct Hy. apply E. lra.
    + apply (continuous_near f (fun _ => 0) x (x - hi)). lra. intros y Hy. apply Rabs_def2 in Hy; destruct Hy. apply Z. lra.
      apply continuity_const. intros y z. auto.
Qed.

(* A function with k derivatives is C^m for m <= k. *)
Lemma derivable_continuous_at f f' : (forall x, derivable_pt_lim f x (f' x)) -> continuity f.
Proof. intros D x. apply derivable_continuous_pt. exists (f' x). apply D. Qed.

Lemma smooth_fewer (kind : (R -> R) -> Prop) m k : (forall f, kind f -> continuity f) -> (m <= k)%nat -> forall f,
  smooth kind k f -> smooth continuity m f.
Proof.
  intros HK. revert k. induction m; intros k Hk f H.
  - destruct k. apply HK, H. destruct H as [f' [D _]]. apply (derivable_continuous_at f f' D).
  - destruct k; [lia|]. destruct H as [f' [D H]]. exists f'. split; auto. apply (IHm k); auto. lia.
Qed.

Lemma holder_continuous alpha f : 0 < alpha -> holder 0 alpha f -> continuity f.
Proof.
  intros Ha [C H] x eps He. assert (C1 : 0 < Rabs C + 1) by (generalize (Rabs_pos C); lra).
  destruct (exp_onto (eps / (Rabs C + 1)) ltac:(apply Rdiv_lt_0_compat; lra)) as [T HT].
  assert (Small : forall y t, exp t < exp (T / alpha) -> Rabs (f (y + exp t) - f y) < eps).
  { intros y t Ht. eapply Rle_lt_trans. apply H. assert (L : alpha * t < T).
    { apply (Rmult_lt_reg_l (/ alpha)). apply Rinv_0_lt_compat; auto. rewrite <- Rmult_assoc, Rinv_l, Rmult_1_l by lra.
      rewrite Rmult_comm.
      apply Rnot_le_lt. intros N. apply exp_at_most in N. unfold Rdiv in Ht. lra. }
    apply exp_less in L. rewrite HT in L. assert (P := exp_pos (alpha * t)).
    apply Rle_lt_trans with ((Rabs C + 1) * exp (alpha * t)). apply Rmult_le_compat_r; [lra|]. generalize (Rle_abs C). lra.
    apply (Rmult_lt_compat_l (Rabs C + 1)) in L; auto. replace ((Rabs C + 1) * (eps / (Rabs C + 1))) with eps in L by (field;
      lra). exact L. }
  exists (exp (T / alpha)). split. apply exp_pos. intros y [[_ N] Hy]. simpl in *. unfold R_dist in *.
  destruct (Rlt_le_dec x y) as [L|L].
  - destruct (exp_onto (y - x) ltac:(lra)) as [t Ht]. rewrite Rabs_pos_eq in Hy by lra. specialize (Small x t). rewrite Ht in Small.
    replace (x + (y - x)) with y in Small by ring. auto.
  - destruct (exp_onto (x - y)) as [t Ht]. destruct L; [lra|congruence]. rewrite Rabs_left1 in Hy by lra.
    specialize (Small y t). rewrite Ht in Small.
    replace (y + (x - y)) with x in Small by ring. rewrite Rabs_minus_sym. apply Small. lra.
Qed.

(* ---- uniform continuity ------------------------------------------------------------------------------------------ *)

Definition even (f : R -> R) (eps d : R) : Prop := forall x y, Rabs (x - y) < d -> Rabs (f x - f y) <= eps.

(* A continuous function that vanishes outside of an interval: the same distance for all points *)
Section Uniform.
Variables (f : R -> R) (lo hi : R).
Hypothesis Continuous : continuity f.
Hypothesis Vanishes : vanishes lo hi f.

Lemma not_uneven eps : 0 < eps -> ~ (forall d, 0 < d -> ~ even f eps d).
Proof.
  intros He N.
  set (good := fun x => exists d, 0 < d /\ forall y z, y <= x -> z <= x -> Rabs (y - z) < d -> Rabs (f y - f z) <= eps).
  set (top := Rmax lo hi + 1). assert (T : lo < top /\ hi < top) by (unfold top; generalize (Rmax_l lo hi) (Rmax_r lo hi); lra).
  assert (NG : ~ good top).
  { intros [d [Hd H]]. apply (N (Rmin d (top - hi))). apply Rmin_glb_lt; lra. intros x y Hxy.
    assert (M1 := Rmin_l d (top - hi)). assert (M2 := Rmin_r d (top - hi)). assert (Hxy' := Hxy).
    apply Rabs_def2 in Hxy'; destruct Hxy'.
    destruct (Rle_lt_dec x top), (Rle_lt_dec y top); try (apply H; lra); rewrite !Vanishes by lra; rewrite Rminus_0_r, Rabs_R0;
      lra. }
  destruct (completeness (fun x => x <= top /\ good x)) as [s [Up Least]].
  { exists top. intros x [Hx _]. exact Hx. }
  { exists (lo - 1). split. lra. exists 1. split. lra. intros y z Hy Hz _. rewrite !Vanishes by lra.
    rewrite Rminus_0_r, Rabs_R0; lra. }
  destruct (Continuous s (eps / 2) ltac:(lra)) as [d [Hd Near]].
  assert (Close : forall y, Rabs (y - s) < d -> Rabs (f y - f s) < eps / 2).
  { intros y Hy. destruct (Req_dec y s) as [->|E]. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra. apply Near. split; auto.
    split. exact I. auto. }
  assert (Low : s <= s - d / 2); [|lra].
  apply Least. intros x [Hx [dx [Dx H]]]. apply Rnot_lt_le. intros L.
  set (t := Rmin top (s + d / 2)). assert (T1 := Rmin_l top (s + d / 2)). assert (T2 := Rmin_r top (s + d / 2)). fold t in T1, T2.
  assert (Gt : good t).
  { exists (Rmin dx (d / 2)). split. apply Rmin_glb_lt; lra. intros y z Hy Hz Hyz.
    assert (M1 := Rmin_l dx (d / 2)). assert (M2 := Rmin_r dx (d / 2)). assert (Hyz' := Hyz).
    apply Rabs_def2 in Hyz'; destruct Hyz'.
    destruct (Rle_lt_dec y x), (Rle_lt_dec z x); try (apply H; lra);
      (assert (Cy := Close y ltac:(apply Rabs_def1; lra)); assert (Cz := Close z ltac:(apply Rabs_def1; lra));
       replace (f y - f z) with ((f y - f s) + - (f z - f s)) by ring; eapply Rle_trans; [apply Rabs_triang|];
         rewrite Rabs_Ropp; lra). }
  assert (St : t <= s) by (apply Up; auto). destruct (Rle_lt_dec top (s + d / 2)).
  - apply NG. replace top with t; auto. unfold t. apply Rmin_left. auto.
  - assert (t = s + d / 2) by (unfold t; apply Rmin_right; lra). lra.
Qed.

Theorem uniform eps : 0 < eps -> exists d, 0 < d /\ even f eps d.
Proof.
  intros He. assert (Stable : forall n, ~ ~ even f eps (/ INR (S n)) -> even f eps (/ INR (S n))).
  { intros n H x y Hxy. apply Rnot_lt_le. intros L. apply H. intros E. specialize (E x y Hxy). lra. }
  destruct (sig_forall_dec (fun n => ~ even f eps (/ INR (S n)))) as [[n Hn]|H].
  - intros n. destruct (sig_not_dec (even f eps (/ INR (S n)))) as [D|D]; [right|left]; auto.
  - exists (/ INR (S n)). split. apply Rinv_0_lt_compat, lt_0_INR. lia. apply Stable, Hn.
  - exfalso. apply (not_uneven eps He). intros d Hd E. destruct (archimed (/ d)) as [U _].
    assert (I0 : 0 < / d) by (apply Rinv_0_lt_compat; auto). set (n := Z.to_nat (up (/ d))).
    assert (In : / d < INR (S n)). { rewrite S_INR. unfold n. rewrite INR_IZR_INZ, Z2Nat.id. lra. apply le_IZR. lra. }
    apply (H n). intros x y Hxy. apply E. eapply Rlt_le_trans. apply Hxy. rewrite <- (Rinv_inv d). apply Rinv_le_contravar; lra.
Qed.
End Uniform.

(* ---- limits of schemes ------------------------------------------------------------------------------------------- *)

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

Section Limits.
Variables (A : nat) (F : Z).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.

(* Refined data near a point, always the same number of places from it, tend to the value there. *)
Lemma limit_point L a phi x k : is_limit A F L a phi -> Un_cv (fun n => refined A F L a n (floor (INR A ^ n * x) - k)%Z) (phi x).
Proof.
  intros [C H] eps He. destruct (C x (eps / 2) ltac:(lra)) as [delta [Hd Near]].
  destruct (H (eps / 3) ltac:(lra)) as [n1 H1]. assert (K0 := Rabs_pos (IZR k)).
  destruct (small_cell A Arity (delta / (2 * (1 + Rabs (IZR k)))) ltac:(apply Rdiv_lt_0_compat; lra)) as [n2 H2].
  exists (n1 + n2)%nat. intros n Hn. specialize (H1 n ltac:(lia)). specialize (H2 n ltac:(lia)).
  assert (P := power_positive A Arity n).
  set (i := (floor (INR A ^ n * x) - k)%Z). specialize (H1 i). set (y := IZR i / INR A ^ n) in *.
  assert (Hy : Rabs (y - x) < delta).
  { destruct (floor_bounds (INR A ^ n * x)) as [F1 F2].
    replace (y - x) with (/ INR A ^ n * ((IZR (floor (INR A ^ n * x)) - INR A ^ n * x) - IZR k))
      by (unfold y, i; rewrite minus_IZR; field; lra).
    assert (IP : 0 < / INR A ^ n) by (apply Rinv_0_lt_compat; auto). rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by lra.
    assert (B : Rabs ((IZR (floor (INR A ^ n * x)) - INR A ^ n * x) - IZR k) <= 1 + Rabs (IZR k)).
    { unfold Rminus at 1. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. apply Rplus_le_compat_r, Rabs_le. lra. }
    apply Rle_lt_trans with (delta / (2 * (1 + Rabs (IZR k))) * (1 + Rabs (IZR k))). apply Rmult_le_compat; auto; try lra.
    apply Rabs_pos.
    replace (delta / (2 * (1 + Rabs (IZR k))) * (1 + Rabs (IZR k))) with (delta / 2) by (field; lra). lra. }
  assert (N : Rabs (phi y - phi x) <= eps / 2).
  { destruct (Req_dec y x) as [->|N]. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra.
    left. apply Near. split. split. exact I. auto. exact Hy. }
  unfold R_dist. replace (refined A F L a n i - phi x) with ((refined A F L a n i - phi y) + (phi y - phi x)) by ring.
  eapply Rle_lt_trans. apply Rabs_triang. lra.
Qed.

Section Limit.
Variables (L : nat) (a : Z -> R) (phi : R -> R).
Hypothesis Support : supported F L a.
Let reach := (Z.abs F + Z.of_nat L + 1)%Z.

Lemma refined_far n i : (i < - (ZA ^ Z.of_nat n * reach) \/ ZA ^ Z.of_nat n * reach < i + 1)%Z -> refined A F L a n i = 0.
Proof.
  intros Hi. apply (refined_support A F L Arity L a n Support (le_n L)). fold ZA. assert (A2 : (2 <= ZA)%Z) by (unfold ZA; lia).
  assert (Q : (0 < ZA ^ Z.of_nat n)%Z) by (apply Z.pow_pos_nonneg; lia). set (q := (ZA ^ Z.of_nat n)%Z) in *.
  destruct Hi as [Hi|Hi]; [left|right].
  - assert (M : ((ZA - 1) * i <= 1 * i)%Z) by (apply Z.mul_le_mono_nonpos_r; unfold reach in Hi; nia).
    assert (- Z.abs F * q <= F * q)%Z by (apply Z.mul_le_mono_nonneg_r; lia). unfold reach in Hi. nia.
  - assert (M : (1 * i <= (ZA - 1) * i)%Z) by (apply Z.mul_le_mono_nonneg_r; unfold reach in Hi; nia).
    assert ((F + Z.of_nat L) * (q - 1) <= (Z.abs F + Z.of_nat L) * (q - 1))%Z by (apply Z.mul_le_mono_nonneg_r; lia).
    unfold reach in Hi. nia.
Qed.

Lemma refined_beyond n x : x < - IZR reach \/ IZR reach < x -> refined A F L a n (floor (INR A ^ n * x)) = 0.
Proof.
  intros Hx. apply refined_far. assert (P := power_positive A Arity n). destruct (floor_bounds (INR A ^ n * x)) as [F1 F2].
  assert (E := Subdivision.arity_power A Arity n). fold ZA in E. destruct Hx as [Hx|Hx]; [left|right].
  - apply (Rmult_lt_compat_l (INR A ^ n)) in Hx; auto. apply lt_IZR. rewrite opp_IZR, mult_IZR, E. lra.
  - apply (Rmult_lt_compat_l (INR A ^ n)) in Hx; auto. apply lt_IZR. rewrite plus_IZR, mult_IZR, E. lra.
Qed.

Hypothesis Phi : is_limit A F L a phi.

Lemma limit_zero : vanishes (- IZR reach) (IZR reach) phi.
Proof.
  intros x Hx. apply (UL_sequence (fun n => refined A F L a n (floor (INR A ^ n * x) - 0)%Z)). apply limit_point; auto.
  intros eps He. exists O. intros n _. rewrite Z.sub_0_r, refined_beyond by auto. unfold R_dist. rewrite Rminus_0_r, Rabs_R0. auto.
Qed.

(* What tends to a limit at the points i / A^n does so between them. *)
Theorem limit_tends_between : tends A (refined A F L a) phi.
Proof.
  intros eps He. destruct Phi as [C H]. destruct (H (eps / 2) ltac:(lra)) as [n1 H1].
  destruct (uniform phi _ _ C limit_zero (eps / 2) ltac:(lra)) as [d [Hd E]].
  destruct (small_cell A Arity (d / 2) ltac:(lra)) as [n2 H2]. exists (n1 + n2)%nat. intros n Hn x.
  specialize (H1 n ltac:(lia)). specialize (H2 n ltac:(lia)).
  assert (P := power_positive A Arity n). set (i := floor (INR A ^ n * x)). destruct (floor_bounds (INR A ^ n * x)) as [F1 F2].
  fold i in F1, F2.
  specialize (H1 i). specialize (E (IZR i / INR A ^ n) x).
  replace (refined A F L a n i - phi x) with ((refined A F L a n i - phi (IZR i / INR A ^ n)) +
    (phi (IZR i / INR A ^ n) - phi x)) by ring.
  eapply Rle_trans. apply Rabs_triang. assert (Rabs (phi (IZR i / INR A ^ n) - phi x) <= eps / 2); [|lra]. apply E.
  replace (IZR i / INR A ^ n - x) with (- (/ INR A ^ n * (INR A ^ n * x - IZR i))) by (field; lra). rewrite Rabs_Ropp.
  assert (IP : 0 < / INR A ^ n) by (apply Rinv_0_lt_compat; auto). rewrite Rabs_mult, !Rabs_pos_eq by lra.
  apply Rle_lt_trans with (/ INR A ^ n * 1). apply Rmult_le_compat_l; lra. lra.
Qed.
End Limit.
End Limits.
