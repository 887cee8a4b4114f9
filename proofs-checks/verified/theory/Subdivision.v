(* Subdivision schemes of curves, their limits, and Theorem 2 of SPEC.md: coefficients of the differences that grow slowly
   make a limit that is smooth. *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius.
Import ListNotations.
Open Scope R_scope.

(* ---- definitions: what the theorems are about ------------------------------------------------------------------ *)

(* A mask a of arity A has the coefficients a first, ..., a (first + length); elsewhere it is 0. One step takes f to
   f' i = the sum over all j of a (i - A j) f j. The sum is over those j for which the coefficient may not be 0. *)
Definition subdivide (A : nat) (first : Z) (length : nat) (a f : Z -> R) : Z -> R := fun i =>
  sum (S length) (fun m => let j := ((i - first) / Z.of_nat A - Z.of_nat length + Z.of_nat m)%Z in
    a (i - Z.of_nat A * j)%Z * f j).

(* n steps from the data 1 at 0 *)
Definition delta (i : Z) : R := if Z.eqb i 0 then 1 else 0.
Section Steps.
Variables (A : nat) (first : Z) (length : nat) (a : Z -> R).
Fixpoint refined (n : nat) : Z -> R :=
  match n with O => delta | S m => subdivide A first length a (refined m) end.

(* The scheme converges to phi: it is continuous, and the refined data tend to its values at the points i / A^n,
   uniformly. There is at most one such phi (limit_unique below). *)
Definition is_limit (phi : R -> R) : Prop :=
  continuity phi /\ forall eps, 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> forall i,
  Rabs (refined n i - phi (IZR i / INR A ^ n)) <= eps.
End Steps.

(* The same with a mask for each level: a 0 makes the data of level 1 from those of level 0, and so on. *)
Section Levels.
Variables (A : nat) (first : Z) (length : nat) (a : nat -> Z -> R).
Fixpoint levels (n : nat) : Z -> R :=
  match n with O => delta | S m => subdivide A first length (a m) (levels m) end.
Definition is_levels_limit (phi : R -> R) : Prop :=
  continuity phi /\ forall eps, 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> forall i,
  Rabs (levels n i - phi (IZR i / INR A ^ n)) <= eps.
End Levels.

(* One mask for all levels *)
Lemma levels_constant A first length a : levels A first length (fun _ => a) = refined A first length a.
Proof. reflexivity. Qed.

(* f has k derivatives, and the last one is Hoelder continuous with the exponent alpha > 0, hence continuous: over a
   distance d it changes by at most C d^alpha. Each d > 0 is exp t for some t (exp_onto below), and d^alpha is exp (alpha t).
   (The logarithm of Coq's library, and its real powers with it, need one axiom more.) *)
Fixpoint holder (k : nat) (alpha : R) (f : R -> R) : Prop :=
  match k with
  | O => exists C, forall x t, Rabs (f (x + exp t) - f x) <= C * exp (alpha * t)
  | S m => exists f', (forall x, derivable_pt_lim f x (f' x)) /\ holder m alpha f'
  end.

(* The Hoelder exponent of f is the supremum of these numbers. *)
Definition exponents (f : R -> R) (s : R) : Prop :=
  exists k alpha, 0 < alpha <= 1 /\ s = INR k + alpha /\ holder k alpha f.
Definition exponent_at_least (f : R -> R) (l : R) : Prop :=
  forall x, x < l -> exists s, exponents f s /\ x < s.
Definition exponent_at_most (f : R -> R) (u : R) : Prop := forall s, exponents f s -> s <= u.

(* ---- the exponential function -------------------------------------------------------------------------------------- *)

Lemma exp_at_least x : 0 <= x -> 1 + x <= exp x.
Proof.
  intros Hx. unfold exp. destruct (exist_exp x) as [l H]. simpl. unfold exp_in, infinite_sum in H.
  apply Rnot_lt_le. intros N. destruct (H (1 + x - l) ltac:(lra)) as [n0 Hn]. specialize (Hn (S n0) ltac:(lia)).
  unfold R_dist in Hn. apply Rabs_def2 in Hn. destruct Hn as [Hn _].
  assert (P : forall n, 1 + x <= sum_f_R0 (fun i => / INR (fact i) * x ^ i) (S n)).
  { induction n. simpl. lra. eapply Rle_trans. apply IHn. rewrite (tech5 _ (S n)).
    assert (0 <= / INR (fact (S (S n))) * x ^ S (S n)); [|lra].
    apply Rmult_le_pos. left. apply Rinv_0_lt_compat, INR_fact_lt_0. apply pow_le; auto. }
  specialize (P n0). lra.
Qed.

Lemma exp_less x y : x < y -> exp x < exp y.
Proof.
  intros H. replace y with (x + (y - x)) by lra. rewrite exp_plus. assert (P := exp_pos x).
  assert (Q := exp_at_least (y - x) ltac:(lra)). rewrite <- (Rmult_1_r (exp x)) at 1. apply Rmult_lt_compat_l; auto. lra.
Qed.

Lemma exp_at_most x y : x <= y -> exp x <= exp y.
Proof. intros [H | ->]. left. apply exp_less; auto. lra. Qed.

Lemma exp_reflects x y : exp x <= exp y -> x <= y.
Proof. intros H. apply Rnot_lt_le. intros N. apply exp_less in N. lra. Qed.

Lemma exp_power x n : exp x ^ n = exp (INR n * x).
Proof.
  induction n. simpl. rewrite Rmult_0_l, exp_0. auto. rewrite <- tech_pow_Rmult, IHn, <- exp_plus, S_INR. f_equal. ring.
Qed.

Lemma exp_onto_above d : 1 <= d -> exists t, exp t = d.
Proof.
  intros H. destruct (IVT_cor (fun t => exp t - d) 0 d) as [t [_ Ht]].
  - apply continuity_minus. apply derivable_continuous, derivable_exp. apply derivable_continuous, derivable_const.
  - lra.
  - rewrite exp_0. assert (P := exp_at_least d ltac:(lra)). assert (0 <= (d - 1) * (exp d - d)) by (apply Rmult_le_pos; lra). lra.
  - exists t. lra.
Qed.

Lemma exp_onto d : 0 < d -> exists t, exp t = d.
Proof.
  intros H. destruct (Rle_lt_dec 1 d) as [L|L]. apply exp_onto_above; auto.
  destruct (exp_onto_above (/ d)) as [t Ht]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
  exists (- t). rewrite exp_Ropp, Ht, Rinv_inv. auto.
Qed.

(* ---- sums over integers ---------------------------------------------------------------------------------------- *)

Lemma sum_reverse m f : sum m f = sum m (fun i => f (m - 1 - i)%nat).
Proof.
  induction m. auto.
  change (sum (S m) (fun i => f (S m - 1 - i)%nat)) with (sum (1 + m) (fun i => f (S m - 1 - i)%nat)).
  rewrite sum_add. cbn [sum]. rewrite IHm. replace (S m - 1 - 0)%nat with m by lia.
  rewrite Rplus_0_l, Rplus_comm. f_equal. apply sum_ext; intros. f_equal. lia.
Qed.

(* Sums over intervals of integers outside of which nothing is left. *)
Lemma sum_window (g : Z -> R) lo m lo' m' : (forall l, (l < lo \/ lo + Z.of_nat m <= l)%Z -> g l = 0) ->
  (lo' <= lo)%Z -> (lo + Z.of_nat m <= lo' + Z.of_nat m')%Z ->
  sum m' (fun i => g (lo' + Z.of_nat i)%Z) = sum m (fun i => g (lo + Z.of_nat i)%Z).
Proof.
  intros H H1 H2. set (a := Z.to_nat (lo - lo')). set (c := (m' - m - a)%nat).
  replace m' with (a + m + c)%nat by lia. rewrite !sum_add, (sum_zero a), (sum_zero c).
  - rewrite Rplus_0_l, Rplus_0_r. apply sum_ext; intros. f_equal. lia.
  - intros i Hi. apply H. lia.
  - intros i Hi. apply H. lia.
Qed.

Lemma sum_two_windows (g : Z -> R) lo m lo' m' : (forall l, (l < lo \/ lo + Z.of_nat m <= l)%Z -> g l = 0) ->
  (forall l, (l < lo' \/ lo' + Z.of_nat m' <= l)%Z -> g l = 0) ->
  sum m (fun i => g (lo + Z.of_nat i)%Z) = sum m' (fun i => g (lo' + Z.of_nat i)%Z).
Proof.
  intros H H'. set (low := Z.min lo lo'). set (high := Z.max (lo + Z.of_nat m) (lo' + Z.of_nat m')).
  rewrite <- (sum_window g lo m low (Z.to_nat (high - low))) by (auto; lia).
  apply sum_window; auto; lia.
Qed.

Lemma sum_minus n f g : sum n (fun i => f i - g i) = sum n f - sum n g.
Proof. induction n; simpl. lra. rewrite IHn. lra. Qed.

Lemma sum_telescope n g : sum n (fun s => g s - g (S s)) = g O - g n.
Proof. induction n; simpl. lra. rewrite IHn. lra. Qed.

Lemma sum_blocks m n f : sum (m * n) f = sum m (fun j => sum n (fun s => f (j * n + s)%nat)).
Proof.
  induction m. auto. replace (S m * n)%nat with (m * n + n)%nat by lia. rewrite sum_add, IHm. reflexivity.
Qed.

Lemma sum_const n c : sum n (fun _ => c) = INR n * c.
Proof. induction n. simpl; lra. rewrite S_INR. simpl sum. rewrite IHn. lra. Qed.

(* ---- one step -------------------------------------------------------------------------------------------------- *)

Section Scheme.
Variables (A : nat) (F : Z) (L : nat).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.

Definition supported (K : nat) (a : Z -> R) : Prop := forall i, (i < F \/ F + Z.of_nat K < i)%Z -> a i = 0.

Lemma supported_more K K' a : (K <= K')%nat -> supported K a -> supported K' a.
Proof. intros H S i Hi. apply S. lia. Qed.

Lemma arity_positive : 0 < INR A.
Proof. apply (lt_INR 0). lia. Qed.

Lemma arity_real : IZR ZA = INR A.
Proof. unfold ZA. rewrite <- INR_IZR_INZ. auto. Qed.

Lemma division i : (ZA * (i / ZA) <= i < ZA * (i / ZA) + ZA)%Z.
Proof. unfold ZA. generalize (Z.div_mod i (Z.of_nat A) ltac:(lia)) (Z.mod_pos_bound i (Z.of_nat A) ltac:(lia)). lia. Qed.

(* The sum in subdivide is over all j. *)
Lemma all_terms K a i j : supported K a -> (K <= L)%nat ->
  (j < (i - F) / ZA - Z.of_nat L \/ (i - F) / ZA - Z.of_nat L + Z.of_nat (S L) <= j)%Z -> a (i - ZA * j)%Z = 0.
Proof.
  intros Ha HK H. apply Ha. assert (D := division (i - F)). set (q := ((i - F) / ZA)%Z) in *.
  unfold ZA in *. destruct H; [right|left]; nia.
Qed.

Lemma subdivide_window K a f i lo m : supported K a -> (K <= L)%nat ->
  (forall j, (j < lo \/ lo + Z.of_nat m <= j)%Z -> a (i - ZA * j)%Z = 0) ->
  sum m (fun k => a (i - ZA * (lo + Z.of_nat k))%Z * f (lo + Z.of_nat k)%Z) = subdivide A F L a f i.
Proof.
  intros Ha HK H. unfold subdivide. fold ZA.
  apply (sum_two_windows (fun j => a (i - ZA * j)%Z * f j)).
  - intros j Hj. rewrite H by auto. lra.
  - intros j Hj. rewrite (all_terms K) by auto. lra.
Qed.

(* One step from the data 1 at 0 gives the mask. *)
Lemma subdivide_point a i : supported L a -> subdivide A F L a delta i = a i.
Proof.
  intros Ha. set (g := fun j => a (i - ZA * j)%Z * delta j). transitivity (sum 1 (fun m => g (0 + Z.of_nat m)%Z)).
  - unfold subdivide. fold ZA. apply (sum_two_windows g).
    + intros j Hj. unfold g. rewrite (all_terms L) by auto. lra.
    + intros j Hj. unfold g, delta. destruct (Z.eqb_spec j 0). exfalso; lia. lra.
  - cbn [sum]. unfold g. replace (i - ZA * (0 + Z.of_nat 0))%Z with i by lia. change (delta (0 + Z.of_nat 0)) with 1. lra.
Qed.

Lemma subdivide_minus a f g i : subdivide A F L a (fun j => f j - g j) i = subdivide A F L a f i - subdivide A F L a g i.
Proof. unfold subdivide. rewrite <- sum_minus. apply sum_ext; intros. cbv zeta. lra. Qed.

Lemma subdivide_scal a c f i : subdivide A F L a (fun j => c * f j) i = c * subdivide A F L a f i.
Proof. unfold subdivide. rewrite <- sum_scal. apply sum_ext; intros. cbv zeta. lra. Qed.

Lemma subdivide_ext a f g i : (forall j, f j = g j) -> subdivide A F L a f i = subdivide A F L a g i.
Proof. intros H. unfold subdivide. apply sum_ext; intros. cbv zeta. rewrite H. auto. Qed.

Lemma subdivide_sum a m (c : nat -> R) (h : nat -> Z -> R) i :
  subdivide A F L a (fun j => sum m (fun l => c l * h l j)) i = sum m (fun l => c l * subdivide A F L a (h l) i).
Proof.
  induction m. cbn [sum]. unfold subdivide. apply sum_zero. intros. cbv zeta. lra.
  cbn [sum]. rewrite <- IHm, <- subdivide_scal. unfold subdivide. rewrite <- sum_plus. apply sum_ext; intros. cbv zeta. lra.
Qed.

Lemma subdivide_shift a f s i : subdivide A F L a (fun j => f (j - s)%Z) i = subdivide A F L a f (i - ZA * s)%Z.
Proof.
  unfold subdivide. fold ZA. apply sum_ext; intros m Hm. cbv zeta.
  replace (i - ZA * s - F)%Z with (i - F + (- s) * ZA)%Z by ring. rewrite Z.div_add by (unfold ZA; lia).
  f_equal; f_equal; ring.
Qed.

(* ---- smoothing: c gets the factor (1 + z + ... + z^(A-1)) / A ---------------------------------------------------- *)

Definition smooth (c : Z -> R) : Z -> R := fun i => / INR A * sum A (fun s => c (i - Z.of_nat s)%Z).
Definition total (c : Z -> R) : R := sum (S L) (fun m => c (F + Z.of_nat m)%Z).

Lemma supported_smooth K c : supported K c -> supported (K + A - 1) (smooth c).
Proof. intros H i Hi. unfold smooth. rewrite sum_zero. lra. intros s Hs. apply H. lia. Qed.

Lemma total_smooth K c : supported K c -> (K + A - 1 <= L)%nat -> total (smooth c) = total c.
Proof.
  intros H HK. unfold total, smooth. rewrite sum_scal, sum_swap.
  rewrite (sum_ext A _ (fun _ => total c)).
  - rewrite sum_const. fold (total c). assert (P := arity_positive). field. lra.
  - intros s Hs. unfold total.
    rewrite (sum_ext (S L) _ (fun i => c (F - Z.of_nat s + Z.of_nat i)%Z)) by (intros; f_equal; lia).
    rewrite (sum_window c F (S K) (F - Z.of_nat s) (S L)), (sum_window c F (S K) F (S L)); auto; try lia;
      intros l Hl; apply H; lia.
Qed.

Lemma smooth_difference c i : smooth c i - smooth c (i - 1)%Z = / INR A * (c i - c (i - ZA)%Z).
Proof.
  unfold smooth. rewrite <- Rmult_minus_distr_l, <- sum_minus. f_equal.
  rewrite (sum_ext A _ (fun s => (fun s => c (i - Z.of_nat s)%Z) s - (fun s => c (i - Z.of_nat s)%Z) (S s))).
  - rewrite sum_telescope. f_equal; f_equal; lia.
  - intros s Hs. cbv beta. f_equal. f_equal. lia.
Qed.

(* What remains of a step with a smoothed mask between neighbours. *)
Lemma subdivide_difference K c f i : supported K c -> (K + A - 1 <= L)%nat ->
  subdivide A F L (smooth c) f i - subdivide A F L (smooth c) f (i - 1)%Z =
  / INR A * subdivide A F L c (fun j => f j - f (j - 1)%Z) i.
Proof.
  intros H HK. assert (HS := supported_smooth K c H).
  assert (D := division (i - F)). set (q := ((i - F) / ZA)%Z) in *.
  set (lo := (q - Z.of_nat L - 2)%Z). set (m := (L + 5)%nat).
  assert (out : forall K' a e j, supported K' a -> (K' <= L)%nat -> (0 <= e <= 1)%Z ->
    (j < lo \/ lo + Z.of_nat m <= j)%Z -> a (i - e - ZA * j)%Z = 0).
  { intros K' a e j Ha HK' He Hj. apply Ha. unfold ZA, lo, m in *. destruct Hj; [right|left]; nia. }
  rewrite <- (subdivide_window (K + A - 1) (smooth c) f i lo m) by
    (auto; intros j Hj; replace (i - ZA * j)%Z with (i - 0 - ZA * j)%Z by lia; apply (out (K + A - 1)%nat); auto; lia).
  rewrite <- (subdivide_window (K + A - 1) (smooth c) f (i - 1) lo m) by
    (auto; intros j Hj; apply (out (K + A - 1)%nat); auto; lia).
  rewrite <- sum_minus, subdivide_minus.
  rewrite (sum_ext m _ (fun k => / INR A * (c (i - ZA * (lo + Z.of_nat k))%Z * f (lo + Z.of_nat k)%Z -
     c (i - ZA * (lo + 1 + Z.of_nat k))%Z * f (lo + 1 + Z.of_nat k - 1)%Z))).
  - rewrite sum_scal, sum_minus. f_equal. f_equal.
    + apply (subdivide_window K); auto. lia. intros j Hj. replace (i - ZA * j)%Z with (i - 0 - ZA * j)%Z by lia. apply (out K); auto; lia.
    + apply (subdivide_window K c (fun j => f (j - 1)%Z)); auto. lia.
      intros j Hj. apply H. unfold ZA, lo, m in *. destruct Hj; [right|left]; nia.
  - intros k Hk. replace (lo + 1 + Z.of_nat k - 1)%Z with (lo + Z.of_nat k)%Z by lia.
    replace (i - 1 - ZA * (lo + Z.of_nat k))%Z with (i - ZA * (lo + Z.of_nat k) - 1)%Z by lia.
    rewrite <- Rmult_minus_distr_r, smooth_difference.
    replace (i - ZA * (lo + Z.of_nat k) - ZA)%Z with (i - ZA * (lo + 1 + Z.of_nat k))%Z by lia. ring.
Qed.

Notation steps a := (refined A F L a).
Notation data a := (levels A F L a).

Lemma levels_difference K (c : nat -> Z -> R) n : (forall k, supported K (c k)) -> (K + A - 1 <= L)%nat -> forall i,
  data (fun k => smooth (c k)) n i - data (fun k => smooth (c k)) n (i - 1)%Z =
  / INR A ^ n * (data c n i - data c n (i - ZA ^ Z.of_nat n)%Z).
Proof.
  intros H HK. induction n; intros i.
  - simpl. rewrite Rinv_1. lra.
  - cbn [levels]. rewrite (subdivide_difference K) by auto.
    rewrite (subdivide_ext (c n) _ (fun j => / INR A ^ n * (data c n j - data c n (j - ZA ^ Z.of_nat n)%Z))) by auto.
    rewrite subdivide_scal, subdivide_minus, subdivide_shift.
    replace (ZA * ZA ^ Z.of_nat n)%Z with (ZA ^ Z.of_nat (S n))%Z.
    + rewrite <- tech_pow_Rmult. assert (P := arity_positive). assert (0 < INR A ^ n) by (apply pow_lt; auto). field. lra.
    + rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. auto.
Qed.

Corollary refined_difference K c n : supported K c -> (K + A - 1 <= L)%nat -> forall i,
  steps (smooth c) n i - steps (smooth c) n (i - 1)%Z = / INR A ^ n * (steps c n i - steps c n (i - ZA ^ Z.of_nat n)%Z).
Proof. intros H. exact (levels_difference K (fun _ => c) n (fun _ => H)). Qed.

(* The coefficients of a smoothed mask sum to 1 over each residue class. *)
Lemma smooth_classes K c i : supported K c -> (K + A - 1 <= L)%nat -> total c = INR A ->
  subdivide A F L (smooth c) (fun _ => 1) i = 1.
Proof.
  intros H HK Ht. unfold subdivide. fold ZA. assert (D := division (i - F)). set (q := ((i - F) / ZA)%Z) in *. cbv zeta.
  unfold smooth. rewrite (sum_ext _ _ (fun m => / INR A * sum A (fun s => c (i - ZA * (q - Z.of_nat L + Z.of_nat m) - Z.of_nat s)%Z)))
    by (intros; ring).
  rewrite sum_scal, sum_reverse.
  set (e := (i - ZA * q - ZA + 1)%Z).
  rewrite (sum_ext _ _ (fun m => sum A (fun s => (fun k => c (e + Z.of_nat k)%Z) (m * A + s)%nat))).
  - rewrite <- (sum_blocks (S L) A (fun k => c (e + Z.of_nat k)%Z)). rewrite (sum_window c F (S L) e (S L * A)).
    + fold (total c). rewrite Ht. assert (P := arity_positive). field. lra.
    + intros l Hl. apply H. lia.
    + unfold e. lia.
    + unfold e, ZA in *. nia.
  - intros m Hm. rewrite sum_reverse. apply sum_ext; intros s Hs. cbv beta. f_equal. unfold e, ZA in *. nia.
Qed.

(* ---- coefficients that stay small -------------------------------------------------------------------------------- *)

Lemma neighbours (f : Z -> R) d : (forall i, Rabs (f i - f (i - 1)%Z) <= d) -> forall i m, Rabs (f (i + Z.of_nat m)%Z - f i) <= INR m * d.
Proof.
  intros H i m. induction m.
  - replace (i + Z.of_nat 0)%Z with i by lia. simpl. rewrite Rminus_diag_eq, Rabs_R0; auto. lra.
  - rewrite S_INR. specialize (H (i + Z.of_nat (S m))%Z). replace (i + Z.of_nat (S m) - 1)%Z with (i + Z.of_nat m)%Z in H by lia.
    replace (f (i + Z.of_nat (S m))%Z - f i) with
      ((f (i + Z.of_nat (S m))%Z - f (i + Z.of_nat m)%Z) + (f (i + Z.of_nat m)%Z - f i)) by lra.
    eapply Rle_trans. apply Rabs_triang. lra.
Qed.

Lemma neighbours_within (f : Z -> R) d B : (forall i, Rabs (f i - f (i - 1)%Z) <= d) ->
  forall i j, (Z.abs (i - j) <= Z.of_nat B)%Z -> Rabs (f i - f j) <= INR B * d.
Proof.
  intros H i j Hij. assert (0 <= d) by (eapply Rle_trans; [apply Rabs_pos|apply (H 0%Z)]).
  assert (M : forall i j, (j <= i)%Z -> (Z.abs (i - j) <= Z.of_nat B)%Z -> Rabs (f i - f j) <= INR B * d).
  { intros k l Hkl Hd. replace k with (l + Z.of_nat (Z.to_nat (k - l)))%Z by lia.
    eapply Rle_trans. apply neighbours; eauto. apply Rmult_le_compat_r; auto. apply le_INR. lia. }
  destruct (Z_le_gt_dec j i). apply M; auto. rewrite Rabs_minus_sym. apply M; lia.
Qed.

Lemma supported_bounded K a : supported K a -> exists P, 0 <= P /\ forall i, Rabs (a i) <= P.
Proof.
  intros H. exists (sum (S K) (fun m => Rabs (a (F + Z.of_nat m)%Z))).
  assert (0 <= sum (S K) (fun m => Rabs (a (F + Z.of_nat m)%Z))) by (apply sum_nonneg; intros; apply Rabs_pos).
  split; auto. intros i. destruct (Z_lt_ge_dec i F). rewrite H, Rabs_R0 by lia; auto.
  destruct (Z_lt_ge_dec (F + Z.of_nat K) i). rewrite H, Rabs_R0 by lia; auto.
  replace i with (F + Z.of_nat (Z.to_nat (i - F)))%Z at 1 by lia.
  apply (sum_term (S K) (fun m => Rabs (a (F + Z.of_nat m)%Z))). intros; apply Rabs_pos. lia.
Qed.

Lemma smooth_bounded c P : (forall i, Rabs (c i) <= P) -> forall i, Rabs (smooth c i) <= P.
Proof.
  intros H i. assert (PA := arity_positive). unfold smooth. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (INR A)) by lra.
  apply Rle_trans with (/ INR A * (INR A * P)). 2: right; field; lra.
  apply Rmult_le_compat_l. left; apply Rinv_0_lt_compat; auto. eapply Rle_trans. apply sum_abs. apply sum_bound. auto.
Qed.

(* One step moves the data by no more than a multiple of their differences; it is the same for all masks with coefficients
   up to P. *)
Lemma steps_near_all P : 0 <= P -> exists C, 0 <= C /\ forall a, (forall i, Rabs (a i) <= P) ->
  (forall i, subdivide A F L a (fun _ => 1) i = 1) -> forall f d, (forall i, Rabs (f i - f (i - 1)%Z) <= d) ->
  forall i, Rabs (subdivide A F L a f i - f (i / ZA)%Z) <= C * d.
Proof.
  intros HP. set (B := (L + Z.to_nat (Z.abs F) + 1)%nat).
  exists (INR (S L) * (P * INR B)). split.
  { apply Rmult_le_pos. apply pos_INR. apply Rmult_le_pos; auto. apply pos_INR. }
  intros a HB H1 f d Hf i. rewrite <- (Rmult_1_r (f (i / ZA)%Z)), <- (H1 i), <- subdivide_scal, <- subdivide_minus.
  unfold subdivide. eapply Rle_trans. apply sum_abs. rewrite Rmult_assoc. apply sum_bound. intros m Hm. cbv zeta.
  rewrite Rabs_mult, Rmult_1_r. rewrite Rmult_assoc. apply Rmult_le_compat; auto; try apply Rabs_pos.
  apply neighbours_within; auto. fold ZA. unfold B.
  assert (D := division (i - F)). assert (D' := division i). unfold ZA in *.
  set (q := ((i - F) / Z.of_nat A)%Z) in *. set (q' := (i / Z.of_nat A)%Z) in *.
  assert (q' - q <= Z.abs F + 1)%Z by nia. assert (q - q' <= Z.abs F + 1)%Z by nia. lia.
Qed.

Corollary step_near K a : supported K a -> (forall i, subdivide A F L a (fun _ => 1) i = 1) ->
  exists C, 0 <= C /\ forall f d, (forall i, Rabs (f i - f (i - 1)%Z) <= d) ->
  forall i, Rabs (subdivide A F L a f i - f (i / ZA)%Z) <= C * d.
Proof.
  intros H H1. destruct (supported_bounded K a H) as [P [HP HB]]. destruct (steps_near_all P HP) as [C [HC Near]]. eauto.
Qed.

(* What the masks of the levels have in common: coefficients outside of which they are 0, their sum and their size *)
Definition masks_alike (K : nat) (P : R) (c : nat -> Z -> R) : Prop :=
  0 <= P /\ forall k, supported K (c k) /\ total (c k) = INR A /\ forall i, Rabs (c k i) <= P.

Lemma constant_alike K c : supported K c -> total c = INR A -> exists P, masks_alike K P (fun _ => c).
Proof. intros H Ht. destruct (supported_bounded K c H) as [P [HP HB]]. exists P. split; auto. Qed.

Lemma smooth_near K P c : masks_alike K P c -> (K + A - 1 <= L)%nat -> exists C, 0 <= C /\
  forall n f d, (forall i, Rabs (f i - f (i - 1)%Z) <= d) ->
  forall i, Rabs (subdivide A F L (smooth (c n)) f i - f (i / ZA)%Z) <= C * d.
Proof.
  intros [HP Al] HK. destruct (steps_near_all P HP) as [C [HC Near]]. exists C. split; auto. intros n.
  destruct (Al n) as [H [Ht HB]]. apply Near. apply smooth_bounded; auto. intros i. apply (smooth_classes K); auto.
Qed.

(* A smoothed mask has smaller coefficients, by a factor A, as long as they grow. *)
Lemma levels_growth K B c D r r' : masks_alike K B c -> (K + A - 1 <= L)%nat -> 0 < r -> 1 < r' -> r <= INR A * r' ->
  (forall n i, Rabs (data c n i) <= D * r ^ n) ->
  exists D', forall n i, Rabs (data (fun k => smooth (c k)) n i) <= D' * r' ^ n.
Proof.
  intros Al HK Hr Hr' Hrr HD. assert (PA := arity_positive).
  assert (HD0 : 0 <= D). { specialize (HD O 0%Z). simpl in HD. assert (P := Rabs_pos (delta 0)). lra. }
  assert (Dif : forall n i, Rabs (data (fun k => smooth (c k)) n i - data (fun k => smooth (c k)) n (i - 1)%Z) <= 2 * D * r' ^ n).
  { intros n i. rewrite (levels_difference K) by (auto; intros k; apply Al). rewrite Rabs_mult.
    assert (PN : 0 < INR A ^ n) by (apply pow_lt; auto).
    rewrite Rabs_pos_eq by (left; apply Rinv_0_lt_compat; auto).
    apply Rle_trans with (/ INR A ^ n * (2 * D * (INR A ^ n * r' ^ n))).
    - apply Rmult_le_compat_l. left; apply Rinv_0_lt_compat; auto.
      rewrite <- Rpow_mult_distr. apply Rle_trans with (2 * D * r ^ n).
      + unfold Rminus. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp.
        generalize (HD n i) (HD n (i - ZA ^ Z.of_nat n)%Z). lra.
      + apply Rmult_le_compat_l. lra. apply pow_incr. lra.
    - right. field. lra. }
  destruct (smooth_near K B c Al HK) as [C [HC Near]].
  exists (1 + C * (2 * D) / (r' - 1)). intros n. induction n; intros i.
  - simpl. unfold delta. assert (0 <= C * (2 * D) / (r' - 1)).
    { apply Rmult_le_pos. apply Rmult_le_pos; lra. left; apply Rinv_0_lt_compat; lra. }
    destruct (Z.eqb i 0); [rewrite Rabs_R1 | rewrite Rabs_R0]; lra.
  - cbn [levels]. specialize (Near n _ _ (Dif n) i). specialize (IHn (i / ZA)%Z).
    set (y := subdivide A F L (smooth (c n)) (data (fun k => smooth (c k)) n) i) in *. set (x := data (fun k => smooth (c k)) n (i / ZA)%Z) in *.
    replace y with ((y - x) + x) by lra. eapply Rle_trans. apply Rabs_triang.
    assert (P0 : 0 < r' ^ n) by (apply pow_lt; lra).
    apply Rle_trans with (C * (2 * D * r' ^ n) + (1 + C * (2 * D) / (r' - 1)) * r' ^ n). lra.
    rewrite <- tech_pow_Rmult.
    replace ((1 + C * (2 * D) / (r' - 1)) * (r' * r' ^ n)) with
      (((1 + C * (2 * D) / (r' - 1)) * r' ^ n) + ((r' - 1) + C * (2 * D)) * r' ^ n) by (field; lra).
    assert (0 <= (r' - 1) * r' ^ n) by (apply Rmult_le_pos; lra). lra.
Qed.

Corollary smooth_growth K c D r r' : supported K c -> (K + A - 1 <= L)%nat -> total c = INR A -> 0 < r -> 1 < r' -> r <= INR A * r' ->
  (forall n i, Rabs (steps c n i) <= D * r ^ n) -> exists D', forall n i, Rabs (steps (smooth c) n i) <= D' * r' ^ n.
Proof. intros H HK Ht. destruct (constant_alike K c H Ht) as [P Al]. exact (levels_growth K P (fun _ => c) D r r' Al HK). Qed.

(* ---- limits ---------------------------------------------------------------------------------------------------- *)

(* The largest integer that is not above x *)
Definition floor (x : R) : Z := (up x - 1)%Z.

Lemma floor_bounds x : IZR (floor x) <= x < IZR (floor x) + 1.
Proof. unfold floor. rewrite minus_IZR. destruct (archimed x). lra. Qed.

(* An exponent that is no whole number, above x and below l, with the number of derivatives that it needs. *)
Lemma order_between m x l : x < l -> 0 < l <= INR m ->
  exists k w, (k < m)%nat /\ INR k < w < INR k + 1 /\ 0 < w < l /\ x < w.
Proof.
  intros Hx Hl. set (y := Rmax x 0). assert (Y1 : x <= y) by apply Rmax_l. assert (Y0 : 0 <= y) by apply Rmax_r.
  assert (Yl : y < l) by (unfold y; apply Rmax_lub_lt; lra). destruct (floor_bounds y) as [F1 F2].
  assert (F0 : (0 <= floor y)%Z) by (apply Z.lt_succ_r, lt_IZR; rewrite <- Z.add_1_r, plus_IZR; lra).
  set (k := Z.to_nat (floor y)). assert (Hk : INR k = IZR (floor y)) by (unfold k; rewrite INR_IZR_INZ, Z2Nat.id; auto).
  rewrite <- Hk in F1, F2. set (z := Rmin l (INR k + 1)).
  assert (Z1 : z <= l) by apply Rmin_l. assert (Z2 : z <= INR k + 1) by apply Rmin_r.
  assert (Z0 : y < z) by (apply Rmin_glb_lt; auto).
  exists k, ((y + z) / 2). split; [apply INR_lt; lra|]. repeat split; lra.
Qed.

Lemma floor_unique x k : IZR k <= x < IZR k + 1 -> floor x = k.
Proof.
  intros [H1 H2]. destruct (floor_bounds x) as [H3 H4].
  assert (k < floor x + 1)%Z by (apply lt_IZR; rewrite plus_IZR; lra).
  assert (floor x < k + 1)%Z by (apply lt_IZR; rewrite plus_IZR; lra). lia.
Qed.

Lemma floor_integer k : floor (IZR k) = k.
Proof. apply floor_unique. lra. Qed.

Lemma floor_step x : (floor (INR A * x) / ZA)%Z = floor x.
Proof.
  assert (P := arity_positive). assert (D := division (floor (INR A * x))). set (q := (floor (INR A * x) / ZA)%Z) in *.
  symmetry. apply floor_unique. destruct (floor_bounds (INR A * x)) as [H1 H2]. destruct D as [D1 D2].
  apply IZR_le in D1. assert (D3 : (floor (INR A * x) + 1 <= ZA * q + ZA)%Z) by lia. apply IZR_le in D3.
  rewrite mult_IZR, arity_real in D1. rewrite !plus_IZR, mult_IZR, arity_real in D3.
  split; apply (Rmult_le_reg_l (INR A)) || apply (Rmult_lt_reg_l (INR A)); auto; lra.
Qed.

Lemma limit_bound u l c b n0 : Un_cv u l -> (forall n, (n0 <= n)%nat -> Rabs (u n - c) <= b) -> Rabs (l - c) <= b.
Proof.
  intros H Hb. apply le_epsilon. intros eps He. destruct (H eps He) as [n1 Hn].
  specialize (Hn (n0 + n1)%nat ltac:(lia)). specialize (Hb (n0 + n1)%nat ltac:(lia)). unfold R_dist in Hn.
  replace (l - c) with (- (u (n0 + n1)%nat - l) + (u (n0 + n1)%nat - c)) by lra.
  eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. lra.
Qed.

(* The data of all steps as functions of real numbers, constant between the points i / A^n, tend to phi uniformly. *)
Definition tends (f : nat -> Z -> R) (phi : R -> R) : Prop :=
  forall eps, 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> forall x, Rabs (f n (floor (INR A ^ n * x)) - phi x) <= eps.

Lemma power_positive n : 0 < INR A ^ n.
Proof. apply pow_lt, arity_positive. Qed.

Section Limit.
Variables (f : nat -> Z -> R) (E B theta : R).
Hypothesis Theta : 0 < theta < 1.
Hypothesis Start : forall i, Rabs (f O i) <= B.
Hypothesis Near : forall n i, Rabs (f n i - f n (i - 1)%Z) <= E * theta ^ n.
Hypothesis Step : forall n i, Rabs (f (S n) i - f n (i / ZA)%Z) <= E * theta ^ n.
Let u (x : R) (n : nat) : R := f n (floor (INR A ^ n * x)).
Let K := E / (1 - theta).

Lemma error_nonneg : 0 <= E.
Proof. specialize (Near O 0%Z). simpl in Near. eapply Rle_trans. apply Rabs_pos. rewrite Rmult_1_r in Near. apply Near. Qed.

Lemma steps_near x n m : Rabs (u x (n + m)%nat - u x n) <= K * theta ^ n * (1 - theta ^ m).
Proof.
  assert (P := error_nonneg). induction m.
  - rewrite Nat.add_0_r. simpl. rewrite Rminus_diag_eq, Rabs_R0; auto. lra.
  - replace (u x (n + S m)%nat - u x n) with ((u x (n + S m)%nat - u x (n + m)%nat) + (u x (n + m)%nat - u x n)) by lra.
    eapply Rle_trans. apply Rabs_triang.
    assert (Rabs (u x (n + S m)%nat - u x (n + m)%nat) <= E * theta ^ (n + m)).
    { unfold u. rewrite Nat.add_succ_r. rewrite <- (floor_step (INR A ^ (n + m) * x)).
      rewrite <- Rmult_assoc, tech_pow_Rmult. apply Step. }
    rewrite pow_add in H. unfold K in *. rewrite <- (tech_pow_Rmult theta m).
    replace (E / (1 - theta) * theta ^ n * (1 - theta * theta ^ m)) with
      (E / (1 - theta) * theta ^ n * (1 - theta ^ m) + E * (theta ^ n * theta ^ m)) by (field; lra). lra.
Qed.

Lemma steps_within x n m : (n <= m)%nat -> Rabs (u x m - u x n) <= K * theta ^ n.
Proof.
  intros H. replace m with (n + (m - n))%nat by lia. eapply Rle_trans. apply steps_near.
  assert (0 <= K). { unfold K. apply Rmult_le_pos. apply error_nonneg. left; apply Rinv_0_lt_compat; lra. }
  assert (0 < theta ^ n) by (apply pow_lt; lra). assert (0 < theta ^ (m - n)) by (apply pow_lt; lra).
  assert (0 <= K * theta ^ n) by (apply Rmult_le_pos; lra).
  assert (0 <= K * theta ^ n * theta ^ (m - n)) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma small_power b eps : 0 <= b -> 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> b * theta ^ n <= eps.
Proof.
  intros Hb He. destruct (pow_lt_1_zero theta ltac:(rewrite Rabs_pos_eq; lra) (eps / (b + 1)) ltac:(apply Rdiv_lt_0_compat; lra)) as [n0 H].
  exists n0. intros n Hn. specialize (H n Hn). rewrite Rabs_pos_eq in H by (apply pow_le; lra).
  assert (0 < theta ^ n) by (apply pow_lt; lra).
  apply (Rmult_lt_compat_l (b + 1)) in H; [|lra]. replace ((b + 1) * (eps / (b + 1))) with eps in H by (field; lra). lra.
Qed.

Lemma constant_nonneg : 0 <= K.
Proof. unfold K. apply Rmult_le_pos. apply error_nonneg. left; apply Rinv_0_lt_compat; lra. Qed.

Lemma steps_cauchy x : Cauchy_crit (u x).
Proof.
  intros eps He. destruct (small_power K (eps / 3) constant_nonneg ltac:(lra)) as [n0 H].
  exists n0. intros n m Hn Hm. unfold R_dist. specialize (H n0 ltac:(lia)).
  assert (H1 := steps_within x n0 n Hn). assert (H2 := steps_within x n0 m Hm). rewrite Rabs_minus_sym in H2.
  replace (u x n - u x m) with ((u x n - u x n0) + (u x n0 - u x m)) by lra.
  eapply Rle_lt_trans. apply Rabs_triang. lra.
Qed.

Definition limit (x : R) : R := proj1_sig (R_complete (u x) (steps_cauchy x)).

Lemma limit_near n x : Rabs (limit x - f n (floor (INR A ^ n * x))) <= K * theta ^ n.
Proof.
  unfold limit. destruct (R_complete (u x) (steps_cauchy x)) as [l H]. simpl.
  apply (limit_bound (u x) l _ _ n H). intros. apply steps_within. auto.
Qed.

Lemma limit_tends : tends f limit.
Proof.
  intros eps He. destruct (small_power K eps constant_nonneg He) as [n0 H]. exists n0. intros n Hn x.
  rewrite Rabs_minus_sym. eapply Rle_trans. apply limit_near. auto.
Qed.

Lemma data_bounded n i : Rabs (f n i) <= B + K.
Proof.
  assert (H := steps_within (IZR i / INR A ^ n) 0 n ltac:(lia)). unfold u in H.
  replace (INR A ^ n * (IZR i / INR A ^ n)) with (IZR i) in H by (field; assert (P := power_positive n); lra).
  rewrite floor_integer in H. simpl in H.
  set (y := f 0%nat (floor (1 * (IZR i / INR A ^ n)))) in *. assert (Rabs y <= B) by apply Start.
  replace (f n i) with ((f n i - y) + y) by lra. eapply Rle_trans. apply Rabs_triang. lra.
Qed.

Lemma limit_bounded x : Rabs (limit x) <= B + 2 * K.
Proof.
  assert (H := limit_near 0 x). assert (H1 := data_bounded 0 (floor (INR A ^ 0 * x))). simpl in *.
  set (y := f 0%nat (floor (1 * x))) in *. replace (limit x) with ((limit x - y) + y) by lra.
  eapply Rle_trans. apply Rabs_triang. lra.
Qed.

(* Points closer than one cell *)
Lemma limit_close n x y : x <= y -> INR A ^ n * (y - x) <= 1 -> Rabs (limit y - limit x) <= (2 * K + E) * theta ^ n.
Proof.
  intros Hxy H. assert (Hx := limit_near n x). assert (Hy := limit_near n y).
  assert (P := power_positive n). set (fx := floor (INR A ^ n * x)) in *. set (fy := floor (INR A ^ n * y)) in *.
  assert (H0 : Rabs (f n fy - f n fx) <= E * theta ^ n).
  { destruct (floor_bounds (INR A ^ n * x)) as [X1 X2]. destruct (floor_bounds (INR A ^ n * y)) as [Y1 Y2]. fold fx in X1, X2. fold fy in Y1, Y2.
    assert (INR A ^ n * x <= INR A ^ n * y) by (apply Rmult_le_compat_l; lra).
    assert (fx < fy + 1)%Z by (apply lt_IZR; rewrite plus_IZR; lra).
    assert (fy < fx + 2)%Z by (apply lt_IZR; rewrite plus_IZR; lra).
    destruct (Z.eq_dec fy fx) as [->|].
    - rewrite Rminus_diag_eq, Rabs_R0 by auto. apply Rmult_le_pos. apply error_nonneg. apply pow_le; lra.
    - replace fx with (fy - 1)%Z by lia. apply Near. }
  replace (limit y - limit x) with ((limit y - f n fy) + (f n fy - f n fx) + - (limit x - f n fx)) by lra.
  eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp.
  eapply Rle_trans. apply Rplus_le_compat_r. apply Rabs_triang. lra.
Qed.

Lemma limit_holder lambda alpha : exp lambda = INR A -> 0 < alpha -> theta = exp (- alpha * lambda) -> holder 0 alpha limit.
Proof.
  intros Hlog Ha Ht. assert (K0 := constant_nonneg). assert (E0 := error_nonneg).
  assert (B0 : 0 <= B) by (eapply Rle_trans; [apply Rabs_pos|apply (Start 0%Z)]).
  assert (A2 : 2 <= INR A) by (apply (le_INR 2); auto).
  set (C1 := (2 * K + E) / theta). set (C2 := 2 * (B + 2 * K)). exists (C1 + C2).
  assert (C1p : 0 <= C1) by (unfold C1; apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
  assert (C2p : 0 <= C2) by (unfold C2; lra).
  intros x t. set (d := exp t). assert (Hd : 0 < d) by apply exp_pos.
  assert (PR : 0 < exp (alpha * t)) by apply exp_pos.
  destruct (Rle_lt_dec 1 d) as [H1|H1].
  - assert (Ht0 : 0 <= t) by (apply exp_reflects; rewrite exp_0; auto).
    assert (1 <= exp (alpha * t)) by (rewrite <- exp_0; apply exp_at_most, Rmult_le_pos; lra).
    apply Rle_trans with C2.
    + unfold C2, Rminus. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp.
      generalize (limit_bounded x) (limit_bounded (x + d)). lra.
    + assert (C2 * 1 <= C2 * exp (alpha * t)) by (apply Rmult_le_compat_l; lra).
      assert (0 <= C1 * exp (alpha * t)) by (apply Rmult_le_pos; lra). lra.
  - (* the last n with d <= A^-n *)
    assert (N : exists n, INR A ^ n * d <= 1 < INR A ^ (S n) * d).
    { destruct (Pow_x_infinity (INR A) ltac:(rewrite Rabs_pos_eq; lra) (2 / d)) as [N HN].
      specialize (HN N ltac:(lia)). rewrite Rabs_pos_eq in HN by (left; apply power_positive).
      assert (1 < INR A ^ N * d).
      { apply Rge_le in HN. apply (Rmult_le_compat_r d) in HN; [|lra]. replace (2 / d * d) with 2 in HN by (field; lra). lra. }
      clear HN. induction N. simpl in H; lra.
      destruct (Rle_lt_dec (INR A ^ N * d) 1). exists N; auto. auto. }
    destruct N as [n [N1 N2]].
    apply Rle_trans with ((2 * K + E) * theta ^ n).
    { apply limit_close. lra. replace (x + d - x) with d by lra. auto. }
    assert (T : theta ^ n <= exp (alpha * t) / theta).
    { apply (Rmult_le_reg_r theta). lra. replace (exp (alpha * t) / theta * theta) with (exp (alpha * t)) by (field; lra).
      rewrite Rmult_comm, tech_pow_Rmult, Ht, exp_power. apply exp_at_most.
      rewrite <- Hlog, exp_power in N2. unfold d in N2. rewrite <- exp_plus in N2.
      assert (0 <= INR (S n) * lambda + t) by (apply exp_reflects; rewrite exp_0; lra).
      assert (0 <= alpha * (INR (S n) * lambda + t)) by (apply Rmult_le_pos; lra). lra. }
    apply Rle_trans with ((2 * K + E) * (exp (alpha * t) / theta)). apply Rmult_le_compat_l; lra.
    replace ((2 * K + E) * (exp (alpha * t) / theta)) with (C1 * exp (alpha * t)) by (unfold C1; field; lra).
    assert (0 <= C2 * exp (alpha * t)) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma limit_continuous : continuity limit.
Proof.
  intros x eps He. destruct (small_power (2 * K + E) (eps / 2)) as [n H]; [|lra|].
  { assert (K0 := constant_nonneg). assert (E0 := error_nonneg). lra. }
  specialize (H n ltac:(lia)). assert (P := power_positive n). exists (/ INR A ^ n). split. apply Rinv_0_lt_compat; auto.
  intros y [_ Hy]. simpl in *. unfold R_dist in *.
  assert (M : forall a b, a <= b -> b - a < / INR A ^ n -> Rabs (limit b - limit a) < eps).
  { intros a b Hab Hd. eapply Rle_lt_trans. apply (limit_close n); auto.
    - apply (Rmult_lt_compat_l (INR A ^ n)) in Hd; auto. rewrite Rinv_r in Hd by lra. lra.
    - lra. }
  destruct (Rle_lt_dec x y). apply M; auto. rewrite Rabs_pos_eq in Hy; lra.
  rewrite Rabs_minus_sym. apply M. lra. rewrite Rabs_left in Hy; lra.
Qed.
End Limit.

(* ---- derivatives ------------------------------------------------------------------------------------------------ *)

Lemma floor_monotone x y : x <= y -> (floor x <= floor y)%Z.
Proof.
  intros H. destruct (floor_bounds x), (floor_bounds y). apply Z.lt_succ_r, lt_IZR. rewrite <- Z.add_1_r, plus_IZR. lra.
Qed.

Lemma sum_differences (g : Z -> R) i m : sum m (fun k => g (i + Z.of_nat (S k))%Z - g (i + Z.of_nat (S k) - 1)%Z) = g (i + Z.of_nat m)%Z - g i.
Proof.
  induction m; cbn [sum]. replace (i + Z.of_nat 0)%Z with i by lia. lra.
  rewrite IHm. replace (i + Z.of_nat (S m) - 1)%Z with (i + Z.of_nat m)%Z by lia. lra.
Qed.

Lemma arity_power n : IZR (ZA ^ Z.of_nat n) = INR A ^ n.
Proof.
  induction n. reflexivity. rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. rewrite mult_IZR, arity_real, IHn. reflexivity.
Qed.

Lemma grid_value n i : INR A ^ n * (IZR i / INR A ^ n) = IZR i.
Proof. field. assert (P := power_positive n). lra. Qed.

(* Data whose differences, divided by the step, tend to a continuous function: it is the derivative of what they tend to. *)
Section Derivative.
Variables (p s : nat -> Z -> R) (phi slope : R -> R).
Hypothesis Differences : forall n i, p n i - p n (i - 1)%Z = / INR A ^ n * s n i.
Hypothesis Phi : tends p phi.
Hypothesis Slope : forall eta, 0 < eta -> exists n0, forall n, (n0 <= n)%nat -> forall m, Rabs (s n m - slope (IZR m / INR A ^ n)) <= eta.

Lemma small_cell eta : 0 < eta -> exists n0, forall n, (n0 <= n)%nat -> / INR A ^ n <= eta.
Proof.
  intros He. assert (A2 : 2 <= INR A) by (apply (le_INR 2); auto).
  destruct (small_power (/ INR A) ltac:(split; [apply Rinv_0_lt_compat; lra|rewrite <- Rinv_1; apply Rinv_lt_contravar; lra]) 1 eta ltac:(lra) He) as [n0 H].
  exists n0. intros n Hn. specialize (H n Hn). rewrite pow_inv, Rmult_1_l in H. exact H.
Qed.

Lemma chord x y d e : x < y -> (forall t, x <= t <= y -> Rabs (slope t - d) <= e) ->
  Rabs (phi y - phi x - (y - x) * d) <= (y - x) * e.
Proof.
  intros Hxy Hs. assert (He : 0 <= e) by (eapply Rle_trans; [apply Rabs_pos|apply (Hs x); lra]).
  apply le_epsilon. intros eps Heps.
  set (W := 4 + (y - x) + e + Rabs d). assert (HW : 0 < W) by (unfold W; assert (P := Rabs_pos d); lra).
  set (eta := Rmin 1 (eps / W)).
  assert (E0 : 0 < eta) by (unfold eta; apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; auto]).
  assert (E1 : eta <= 1) by apply Rmin_l.
  assert (E2 : eta * W <= eps).
  { apply Rle_trans with (eps / W * W). apply Rmult_le_compat_r. lra. apply Rmin_r. right. field. lra. }
  destruct (Phi eta E0) as [n1 H1]. destruct (Slope eta E0) as [n2 H2]. destruct (small_cell eta E0) as [n3 H3].
  set (n := (n1 + n2 + n3)%nat). specialize (H1 n ltac:(unfold n; lia)). specialize (H2 n ltac:(unfold n; lia)). specialize (H3 n ltac:(unfold n; lia)).
  assert (P := power_positive n). set (h := / INR A ^ n) in *. assert (Ph : 0 < h) by (apply Rinv_0_lt_compat; auto).
  assert (Hx := H1 x). assert (Hy := H1 y). set (u := p n) in *.
  set (i := floor (INR A ^ n * x)) in *. set (k := floor (INR A ^ n * y)) in *.
  assert (ik : (i <= k)%Z) by (apply floor_monotone, Rmult_le_compat_l; lra).
  destruct (floor_bounds (INR A ^ n * x)) as [X1 X2]. destruct (floor_bounds (INR A ^ n * y)) as [Y1 Y2]. fold i in X1, X2. fold k in Y1, Y2.
  set (m := Z.to_nat (k - i)). assert (Hm : k = (i + Z.of_nat m)%Z) by (unfold m; lia).
  assert (Hk : IZR k = IZR i + INR m) by (rewrite Hm, plus_IZR, <- INR_IZR_INZ; auto).
  (* the sum of the differences *)
  assert (HS : Rabs (u k - u i - h * (INR m * d)) <= h * (INR m * (e + eta))).
  { rewrite Hm, <- sum_differences. replace (h * (INR m * d)) with (sum m (fun _ => h * d)) by (rewrite sum_const; ring).
    replace (h * (INR m * (e + eta))) with (INR m * (h * (e + eta))) by ring. rewrite <- sum_minus.
    eapply Rle_trans. apply sum_abs. apply sum_bound. intros j Hj. cbv beta.
    set (q := (i + Z.of_nat (S j))%Z). unfold u. rewrite Differences. fold h. specialize (H2 q).
    rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq h) by lra. apply Rmult_le_compat_l. lra.
    assert (Hq : x <= IZR q / INR A ^ n <= y).
    { assert (IZR i + 1 <= IZR q) by (rewrite <- plus_IZR; apply IZR_le; unfold q; lia).
      assert (IZR q <= IZR k) by (apply IZR_le; unfold q; lia).
      split; apply (Rmult_le_reg_l (INR A ^ n)); auto; rewrite grid_value; lra. }
    specialize (Hs _ Hq). set (v := s n q) in *. set (t := IZR q / INR A ^ n) in *.
    replace (v - d) with ((v - slope t) + (slope t - d)) by lra. eapply Rle_trans. apply Rabs_triang. lra. }
  (* the number of cells *)
  assert (HM : Rabs (h * INR m - (y - x)) <= h).
  { assert (HX : h * (INR A ^ n * x) = x) by (unfold h; field; lra). assert (HY : h * (INR A ^ n * y) = y) by (unfold h; field; lra).
    replace (h * INR m - (y - x)) with (h * (INR m - (INR A ^ n * y - INR A ^ n * x))) by lra.
    rewrite Rabs_mult, (Rabs_pos_eq h) by lra. rewrite <- (Rmult_1_r h) at 2. apply Rmult_le_compat_l. lra.
    apply Rabs_le. lra. }
  assert (HM' : h * INR m <= (y - x) + eta) by (generalize (Rle_abs (h * INR m - (y - x))); lra).
  replace (phi y - phi x - (y - x) * d) with
    (- (u k - phi y) + (u i - phi x) + (u k - u i - h * (INR m * d)) + (h * INR m - (y - x)) * d) by ring.
  eapply Rle_trans. apply Rabs_triang. eapply Rle_trans. apply Rplus_le_compat_r, Rabs_triang.
  eapply Rle_trans. apply Rplus_le_compat_r, Rplus_le_compat_r, Rabs_triang. rewrite Rabs_Ropp, Rabs_mult.
  assert (Rabs (h * INR m - (y - x)) * Rabs d <= eta * Rabs d) by (apply Rmult_le_compat_r; [apply Rabs_pos|lra]).
  assert (h * (INR m * (e + eta)) <= ((y - x) + eta) * (e + eta)).
  { rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra. }
  assert (((y - x) + eta) * (e + eta) <= (y - x) * e + eta * (y - x + e + 1)).
  { replace (((y - x) + eta) * (e + eta)) with ((y - x) * e + eta * (y - x + e + eta)) by ring.
    apply Rplus_le_compat_l, Rmult_le_compat_l; lra. }
  apply Rle_trans with ((y - x) * e + eta * (4 + (y - x) + e + Rabs d)). 2: fold W; lra.
  replace (eta * (4 + (y - x) + e + Rabs d)) with (eta + eta + eta * (y - x + e + 1) + eta * Rabs d + eta) by ring. lra.
Qed.

Theorem data_derivative : continuity slope -> forall x, derivable_pt_lim phi x (slope x).
Proof.
  intros HS x eps He.
  destruct (HS x (eps / 2) ltac:(lra)) as [delta [Hd H]]. exists (mkposreal delta Hd). intros h Hh0 Hh. simpl in Hh.
  assert (Near : forall t, Rabs (t - x) < delta -> Rabs (slope t - slope x) <= eps / 2).
  { intros t Ht. destruct (Req_dec t x) as [->|N]. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra.
    left. apply (H t). split. split. exact I. auto. exact Ht. }
  assert (R : Rabs (phi (x + h) - phi x - h * slope x) <= Rabs h * (eps / 2)).
  { destruct (Rlt_le_dec 0 h) as [Hp|Hn].
    - rewrite (Rabs_pos_eq h) in * by lra. replace h with ((x + h) - x) at 2 3 by lra. apply chord. lra.
      intros t Ht. apply Near. apply Rabs_def1; lra.
    - rewrite (Rabs_left h) in * by lra.
      replace (phi (x + h) - phi x - h * slope x) with (- (phi x - phi (x + h) - (x - (x + h)) * slope x)) by ring.
      rewrite Rabs_Ropp. replace (- h) with (x - (x + h)) by lra. apply chord. lra.
      intros t Ht. apply Near. apply Rabs_def1; lra. }
  replace ((phi (x + h) - phi x) / h - slope x) with ((phi (x + h) - phi x - h * slope x) / h) by (field; auto).
  unfold Rdiv. rewrite Rabs_mult, Rabs_inv. assert (0 < Rabs h) by (apply Rabs_pos_lt; auto).
  apply (Rmult_lt_reg_r (Rabs h)). auto. rewrite Rmult_assoc, Rinv_l by lra. assert (0 < Rabs h * (eps / 2)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
End Derivative.

Lemma slope_near (c : nat -> Z -> R) psi eta : tends (data c) psi -> 0 < eta -> exists n0, forall n, (n0 <= n)%nat -> forall m,
  Rabs (data c n m - data c n (m - ZA ^ Z.of_nat n)%Z - (psi (IZR m / INR A ^ n) - psi (IZR m / INR A ^ n - 1))) <= eta.
Proof.
  intros Psi He. destruct (Psi (eta / 2) ltac:(lra)) as [n0 H]. exists n0. intros n Hn m.
  assert (P := power_positive n). assert (H1 := H n Hn (IZR m / INR A ^ n)). assert (H2 := H n Hn (IZR m / INR A ^ n - 1)).
  rewrite grid_value, floor_integer in H1.
  replace (INR A ^ n * (IZR m / INR A ^ n - 1)) with (IZR (m - ZA ^ Z.of_nat n)) in H2
    by (rewrite minus_IZR, arity_power; field; lra).
  rewrite floor_integer in H2.
  set (a := data c n m) in *. set (b := data c n (m - ZA ^ Z.of_nat n)%Z) in *.
  replace (a - b - (psi (IZR m / INR A ^ n) - psi (IZR m / INR A ^ n - 1))) with
    ((a - psi (IZR m / INR A ^ n)) + - (b - psi (IZR m / INR A ^ n - 1))) by lra.
  eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. lra.
Qed.

(* The limit of a smoothed scheme has the differences of the limit of the scheme as its derivative. *)
Theorem levels_derivative K c phi psi : (forall k, supported K (c k)) -> (K + A - 1 <= L)%nat ->
  tends (data (fun k => smooth (c k))) phi -> tends (data c) psi -> continuity psi ->
  forall x, derivable_pt_lim phi x (psi x - psi (x - 1)).
Proof.
  intros H HK Phi Psi HC. apply (data_derivative (data (fun k => smooth (c k)))
    (fun n i => data c n i - data c n (i - ZA ^ Z.of_nat n)%Z) phi (fun x => psi x - psi (x - 1))); auto.
  - intros n i. apply (levels_difference K); auto.
  - intros eta He. apply slope_near; auto.
  - apply continuity_minus; auto. apply (continuity_comp (fun x => x - 1) psi); auto.
    apply continuity_minus. apply derivable_continuous, derivable_id. apply derivable_continuous, derivable_const.
Qed.

Corollary smooth_derivative K c phi psi : supported K c -> (K + A - 1 <= L)%nat -> tends (steps (smooth c)) phi ->
  tends (steps c) psi -> continuity psi -> forall x, derivable_pt_lim phi x (psi x - psi (x - 1)).
Proof. intros H. exact (levels_derivative K (fun _ => c) phi psi (fun _ => H)). Qed.

Lemma holder_difference k : forall alpha f, holder k alpha f -> holder k alpha (fun x => f x - f (x - 1)).
Proof.
  induction k; intros alpha f H.
  - destruct H as [C H]. exists (2 * C). intros x t. assert (H1 := H x t). assert (H2 := H (x - 1) t).
    replace (x + exp t - 1) with (x - 1 + exp t) by lra.
    replace (f (x + exp t) - f (x - 1 + exp t) - (f x - f (x - 1))) with
      ((f (x + exp t) - f x) + - (f (x - 1 + exp t) - f (x - 1))) by lra.
    eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. lra.
  - destruct H as [f' [D H]]. exists (fun x => f' x - f' (x - 1)). split; [|apply IHk; auto].
    intros x. apply (derivable_pt_lim_minus f (fun x => f (x - 1))). auto.
    intros eps He. destruct (D (x - 1) eps He) as [delta Hd]. exists delta. intros h H0 Hh.
    replace (x + h - 1) with (x - 1 + h) by lra. auto.
Qed.

Lemma levels_tends_limit a phi : continuity phi -> tends (data a) phi -> is_levels_limit A F L a phi.
Proof.
  intros HC HT. split; auto. intros eps He. destruct (HT eps He) as [n0 H]. exists n0. intros n Hn i.
  specialize (H n Hn (IZR i / INR A ^ n)). rewrite grid_value, floor_integer in H. auto.
Qed.

Corollary tends_limit a phi : continuity phi -> tends (steps a) phi -> is_limit A F L a phi.
Proof. exact (levels_tends_limit (fun _ => a) phi). Qed.

(* ---- the chain from the differences up to the scheme ------------------------------------------------------------- *)

Theorem levels_unique a phi psi : is_levels_limit A F L a phi -> is_levels_limit A F L a psi -> forall x, phi x = psi x.
Proof.
  intros [HC H] [HC' H'] x. apply cond_eq. intros eps He.
  destruct (HC x (eps / 5) ltac:(lra)) as [d1 [D1 C1]]. destruct (HC' x (eps / 5) ltac:(lra)) as [d2 [D2 C2]].
  destruct (H (eps / 5) ltac:(lra)) as [n1 H1]. destruct (H' (eps / 5) ltac:(lra)) as [n2 H2].
  set (d := Rmin d1 d2). assert (Hd : 0 < d) by (apply Rmin_glb_lt; auto).
  destruct (small_cell (d / 2) ltac:(lra)) as [n3 H3]. set (n := (n1 + n2 + n3)%nat).
  specialize (H1 n ltac:(unfold n; lia)). specialize (H2 n ltac:(unfold n; lia)). specialize (H3 n ltac:(unfold n; lia)).
  set (i := floor (INR A ^ n * x)). specialize (H1 i). specialize (H2 i). assert (P := power_positive n).
  set (y := IZR i / INR A ^ n) in *.
  assert (Hy : Rabs (y - x) < d).
  { destruct (floor_bounds (INR A ^ n * x)) as [X1 X2]. fold i in X1, X2.
    replace (y - x) with (/ INR A ^ n * (IZR i - INR A ^ n * x)) by (unfold y; field; lra).
    rewrite Rabs_mult, Rabs_pos_eq by (left; apply Rinv_0_lt_compat; auto).
    assert (Rabs (IZR i - INR A ^ n * x) <= 1) by (apply Rabs_le; lra).
    apply Rle_lt_trans with (/ INR A ^ n * 1); [|lra]. apply Rmult_le_compat_l; auto. left; apply Rinv_0_lt_compat; auto. }
  assert (N1 : Rabs (phi y - phi x) <= eps / 5).
  { destruct (Req_dec y x) as [->|N]. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra.
    left. apply C1. split. split. exact I. auto. simpl. unfold R_dist. apply Rlt_le_trans with d; auto. apply Rmin_l. }
  assert (N2 : Rabs (psi y - psi x) <= eps / 5).
  { destruct (Req_dec y x) as [->|N]. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra.
    left. apply C2. split. split. exact I. auto. simpl. unfold R_dist. apply Rlt_le_trans with d; auto. apply Rmin_r. }
  set (v := data a n i) in *.
  replace (phi x - psi x) with (- (phi y - phi x) + - (v - phi y) + (v - psi y) + (psi y - psi x)) by lra.
  eapply Rle_lt_trans. apply Rabs_triang. eapply Rle_lt_trans. apply Rplus_le_compat_r, Rabs_triang.
  eapply Rle_lt_trans. apply Rplus_le_compat_r, Rplus_le_compat_r, Rabs_triang. rewrite !Rabs_Ropp. lra.
Qed.

Corollary limit_unique a phi psi : is_limit A F L a phi -> is_limit A F L a psi -> forall x, phi x = psi x.
Proof. exact (levels_unique (fun _ => a) phi psi). Qed.

(* A smoothed scheme converges if the coefficients of the scheme grow by less than A in each step. *)
Lemma levels_limit K B c D r : masks_alike K B c -> (K + A - 1 <= L)%nat -> 0 < r < INR A ->
  (forall n i, Rabs (data c n i) <= D * r ^ n) ->
  exists phi, tends (data (fun k => smooth (c k))) phi /\ continuity phi /\ (exists P, forall n i, Rabs (data (fun k => smooth (c k)) n i) <= P) /\
  forall lambda alpha, exp lambda = INR A -> 0 < alpha -> r / INR A = exp (- alpha * lambda) -> holder 0 alpha phi.
Proof.
  intros Al HK Hr HD. assert (PA := arity_positive). set (theta := r / INR A).
  assert (Theta : 0 < theta < 1).
  { unfold theta. split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r (INR A)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (HD0 : 0 <= D). { specialize (HD O 0%Z). simpl in HD. assert (P := Rabs_pos (delta 0)). lra. }
  assert (Dif : forall n i, Rabs (data (fun k => smooth (c k)) n i - data (fun k => smooth (c k)) n (i - 1)%Z) <= 2 * D * theta ^ n).
  { intros n i. rewrite (levels_difference K) by (auto; intros k; apply Al). assert (PN := power_positive n).
    rewrite Rabs_mult, Rabs_pos_eq by (left; apply Rinv_0_lt_compat; auto).
    unfold theta, Rdiv. rewrite Rpow_mult_distr, pow_inv. replace (2 * D * (r ^ n * / INR A ^ n)) with (/ INR A ^ n * (2 * D * r ^ n)) by ring.
    apply Rmult_le_compat_l. left; apply Rinv_0_lt_compat; auto.
    unfold Rminus. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. generalize (HD n i) (HD n (i - ZA ^ Z.of_nat n)%Z). lra. }
  destruct (smooth_near K B c Al HK) as [C [HC Near]].
  set (E := 2 * D * (1 + C)).
  assert (S0 : forall i, Rabs (data (fun k => smooth (c k)) 0 i) <= 1).
  { intros i. simpl. unfold delta. destruct (Z.eqb i 0); [rewrite Rabs_R1 | rewrite Rabs_R0]; lra. }
  assert (S1 : forall n i, Rabs (data (fun k => smooth (c k)) n i - data (fun k => smooth (c k)) n (i - 1)%Z) <= E * theta ^ n).
  { intros n i. eapply Rle_trans. apply Dif. apply Rmult_le_compat_r. apply pow_le; lra. unfold E.
    assert (0 <= D * C) by (apply Rmult_le_pos; auto). lra. }
  assert (S2 : forall n i, Rabs (data (fun k => smooth (c k)) (S n) i - data (fun k => smooth (c k)) n (i / ZA)%Z) <= E * theta ^ n).
  { intros n i. cbn [levels]. eapply Rle_trans. apply (Near n _ _ (Dif n)). rewrite <- Rmult_assoc. apply Rmult_le_compat_r. apply pow_le; lra.
    unfold E. assert (0 <= D * C) by (apply Rmult_le_pos; auto). lra. }
  exists (limit _ E theta Theta S1 S2). split; [|split; [|split]].
  - apply limit_tends.
  - eapply limit_continuous; eauto.
  - exists (1 + E / (1 - theta)). intros. eapply data_bounded; eauto.
  - intros lambda alpha Hlog Ha Hth. eapply limit_holder; eauto.
Qed.

Corollary smooth_limit K c D r : supported K c -> (K + A - 1 <= L)%nat -> total c = INR A -> 0 < r < INR A ->
  (forall n i, Rabs (steps c n i) <= D * r ^ n) ->
  exists phi, tends (steps (smooth c)) phi /\ continuity phi /\ (exists P, forall n i, Rabs (steps (smooth c) n i) <= P) /\
  forall lambda alpha, exp lambda = INR A -> 0 < alpha -> r / INR A = exp (- alpha * lambda) -> holder 0 alpha phi.
Proof. intros H HK Ht. destruct (constant_alike K c H Ht) as [P Al]. exact (levels_limit K P (fun _ => c) D r Al HK). Qed.

Fixpoint smoothed (m : nat) (b : Z -> R) : Z -> R := match m with O => b | S k => smooth (smoothed k b) end.

Lemma smoothed_supported N b m : supported N b -> supported (N + m * (A - 1)) (smoothed m b).
Proof.
  intros H. induction m; cbn [smoothed]. replace (N + 0 * (A - 1))%nat with N by lia. auto.
  apply (supported_more (N + m * (A - 1) + A - 1)). rewrite Nat.mul_succ_l. generalize (m * (A - 1))%nat; lia. apply supported_smooth. auto.
Qed.

Lemma smoothed_total N b m : supported N b -> (N + m * (A - 1) <= L)%nat -> total (smoothed m b) = total b.
Proof.
  intros H. induction m; cbn [smoothed]; intros HL; auto. rewrite Nat.mul_succ_l in HL.
  rewrite (total_smooth (N + m * (A - 1))). apply IHm; lia. apply smoothed_supported; auto.
  revert HL. generalize (m * (A - 1))%nat; lia.
Qed.

Lemma smoothed_alike N P b m : masks_alike N P b -> (N + m * (A - 1) <= L)%nat ->
  masks_alike (N + m * (A - 1)) P (fun k => smoothed m (b k)).
Proof.
  intros [HP Al] HL. split; auto. intros k. destruct (Al k) as [H [Ht HB]]. split; [|split].
  - apply smoothed_supported. auto.
  - rewrite (smoothed_total N); auto.
  - clear - HB ZA Arity. induction m; cbn [smoothed]; auto. apply smooth_bounded. auto.
Qed.

(* A^x is exp (x lambda). *)
Section Powers.
Variable lambda : R.
Hypothesis Log : exp lambda = INR A.

Lemma log_positive : 0 < lambda.
Proof.
  apply Rnot_le_lt. intros H. apply exp_at_most in H. rewrite exp_0, Log in H. assert (2 <= INR A) by (apply (le_INR 2); auto). lra.
Qed.

Lemma power_less x y : x < y -> exp (x * lambda) < exp (y * lambda).
Proof. intros H. apply exp_less, Rmult_lt_compat_r; auto. apply log_positive. Qed.

Lemma power_succ x : exp ((1 + x) * lambda) = INR A * exp (x * lambda).
Proof. rewrite <- Log, <- exp_plus. f_equal. ring. Qed.

(* Theorem 2 for one number below the exponent *)
Theorem levels_holder N B b M k x D : masks_alike N B b -> (N + M * (A - 1) <= L)%nat ->
  (k < M)%nat -> INR k < x < INR k + 1 -> (forall n i, Rabs (data b n i) <= D * exp ((INR M - x) * lambda) ^ n) ->
  exists phi, is_levels_limit A F L (fun l => smoothed M (b l)) phi /\ tends (data (fun l => smoothed M (b l))) phi /\ holder k (x - INR k) phi.
Proof.
  intros Al HL HkM Hx HD. assert (PA := arity_positive).
  assert (Fit : forall m, (m < M)%nat -> (N + m * (A - 1) + A - 1 <= L)%nat)
    by (intros m Hm; generalize (Nat.mul_le_mono_r (S m) M (A - 1) Hm); rewrite Nat.mul_succ_l;
      revert HL; generalize (m * (A - 1))%nat (M * (A - 1))%nat; lia).
  assert (Sm : forall m, (m < M)%nat -> masks_alike (N + m * (A - 1)) B (fun l => smoothed m (b l))).
  { intros m Hm. apply smoothed_alike; auto. specialize (Fit m Hm). lia. }
  (* coefficients grow less and less *)
  assert (G : forall m, (m + k + 1 <= M)%nat -> exists D', forall n i,
    Rabs (data (fun l => smoothed m (b l)) n i) <= D' * exp ((INR M - INR m - x) * lambda) ^ n).
  { induction m; intros Hm.
    - exists D. simpl INR. rewrite Rminus_0_r. exact HD.
    - destruct (IHm ltac:(lia)) as [D' H']. cbn [smoothed].
      apply (levels_growth (N + m * (A - 1)) B (fun l => smoothed m (b l)) D' (exp ((INR M - INR m - x) * lambda))); auto.
      + apply Sm. lia.
      + apply Fit. lia.
      + apply exp_pos.
      + rewrite <- exp_0, <- (Rmult_0_l lambda). apply power_less. apply le_INR in Hm. rewrite !plus_INR in Hm. simpl (INR 1) in Hm. lra.
      + right. rewrite <- power_succ. f_equal. f_equal. rewrite S_INR. ring. }
  (* the derivative of order k *)
  assert (Base : forall e, (e <= k)%nat -> exists phi, tends (data (fun l => smoothed (M - k + e) (b l))) phi /\ continuity phi /\
    (exists P, forall n i, Rabs (data (fun l => smoothed (M - k + e) (b l)) n i) <= P) /\ holder e (x - INR k) phi).
  { induction e; intros He.
    - destruct (G (M - k - 1)%nat ltac:(lia)) as [D' H'].
      replace (M - k + 0)%nat with (S (M - k - 1)) by lia. cbn [smoothed].
      assert (Ex : INR M - INR (M - k - 1) - x = 1 + - (x - INR k)).
      { rewrite !minus_INR by lia. simpl. ring. }
      rewrite Ex, power_succ in H'. assert (Lt : exp (- (x - INR k) * lambda) < 1).
      { rewrite <- exp_0, <- (Rmult_0_l lambda). apply power_less. lra. }
      assert (Gt : 0 < exp (- (x - INR k) * lambda)) by apply exp_pos.
      destruct (levels_limit (N + (M - k - 1) * (A - 1)) B (fun l => smoothed (M - k - 1) (b l)) D' (INR A * exp (- (x - INR k) * lambda))) as [phi [T [C [P Ho]]]]; auto.
      + apply Sm. lia.
      + apply Fit. lia.
      + split. apply Rmult_lt_0_compat; auto. generalize (Rmult_lt_compat_l _ _ _ PA Lt). lra.
      + exists phi. split; auto. split; auto. split; auto. apply (Ho lambda); auto. lra. field. lra.
    - destruct (IHe ltac:(lia)) as [psi [T [C [[P HP] Ho]]]]. replace (M - k + S e)%nat with (S (M - k + e)) by lia. cbn [smoothed].
      destruct (levels_limit (N + (M - k + e) * (A - 1)) B (fun l => smoothed (M - k + e) (b l)) P 1) as [phi [T' [C' [P' _]]]]; auto.
      + apply Sm. lia.
      + apply Fit. lia.
      + split. lra. apply (lt_INR 1). lia.
      + intros n i. rewrite pow1, Rmult_1_r. auto.
      + exists phi. split; auto. split; auto. split; auto.
        exists (fun t => psi t - psi (t - 1)). split; [|apply holder_difference; auto].
        apply (levels_derivative (N + (M - k + e) * (A - 1)) (fun l => smoothed (M - k + e) (b l))); auto.
        * intros l. apply (Sm (M - k + e)%nat). lia.
        * apply Fit. lia. }
  destruct (Base k ltac:(lia)) as [phi [T [C [_ Ho]]]]. replace (M - k + k)%nat with M in T by lia.
  exists phi. split; auto. apply levels_tends_limit; auto.
Qed.

(* Theorem 2, with a mask for each level: coefficients that grow more slowly than (A^(M - x))^n for each x < l make a limit
   of the exponent l. *)
Theorem levels_exponent N B b M l : masks_alike N B b -> (N + M * (A - 1) <= L)%nat -> 0 < l <= INR M ->
  (forall x, 0 < x < l -> exists D, forall n i, Rabs (data b n i) <= D * exp ((INR M - x) * lambda) ^ n) ->
  exists phi, is_levels_limit A F L (fun l => smoothed M (b l)) phi /\ tends (data (fun l => smoothed M (b l))) phi /\ exponent_at_least phi l.
Proof.
  intros Al HL Hl HD.
  assert (One : forall x, x < l -> exists phi, is_levels_limit A F L (fun l => smoothed M (b l)) phi /\
    tends (data (fun l => smoothed M (b l))) phi /\ exists s, exponents phi s /\ x < s).
  { intros x Hx. destruct (order_between M x l Hx Hl) as [k [w [Hk [Hw [Wl Wx]]]]].
    destruct (HD w Wl) as [D HD'].
    destruct (levels_holder N B b M k w D Al HL Hk Hw HD') as [phi [Lim [T Ho]]].
    exists phi. split; auto. split; auto. exists w. split; [|auto]. exists k, (w - INR k). split; [lra|]. split; auto. lra. }
  destruct (One 0 ltac:(lra)) as [phi [Lim [T _]]]. exists phi. split; auto. split; auto. intros x Hx.
  destruct (One x Hx) as [psi [Lim' [_ Hs]]]. replace phi with psi; auto. extensionality t. apply (levels_unique (fun l => smoothed M (b l))); auto.
Qed.

Corollary smoothed_exponent N b M l : supported N b -> (N + M * (A - 1) <= L)%nat -> total b = INR A -> 0 < l <= INR M ->
  (forall x, 0 < x < l -> exists D, forall n i, Rabs (steps b n i) <= D * exp ((INR M - x) * lambda) ^ n) ->
  exists phi, is_limit A F L (smoothed M b) phi /\ tends (steps (smoothed M b)) phi /\ exponent_at_least phi l.
Proof. intros H HL Ht. destruct (constant_alike N b H Ht) as [P Al]. exact (levels_exponent N P (fun _ => b) M l Al HL). Qed.
End Powers.
End Scheme.
