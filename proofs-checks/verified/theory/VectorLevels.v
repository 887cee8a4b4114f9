(* Schemes of vectors, a mask of matrices for each level: finite functionals of the data that shrink from level to level, and what
   the data tend to (SPEC.md, sections 6.7 and 6.12, Theorems 47 and 73). *)
Require Import Reals List ZArith Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision Coefficients Grid Refinable Along.
Import ListNotations.
Open Scope R_scope.

(* ---- definitions: what the theorems are about ------------------------------------------------------------------ *)

(* A mask has the matrices a first, ..., a (first + length), of size r, as in Refinable.v. A step takes f to f' i = the sum over all
   j of P (i - A j) f j, P k the transpose of a k. The sum is over those k for which i - k is A j. *)
Definition vector_step (A r : nat) (first : Z) (length : nat) (a : Z -> nat -> nat -> R) (f : vectors) : vectors := fun i c =>
  sum (S length) (fun m => let k := (first + Z.of_nat m)%Z in let j := ((i - k) / Z.of_nat A)%Z in
    if (Z.of_nat A * j =? i - k)%Z then sum r (fun d => a k d c * f j d) else 0).

(* n steps from f, the first by the mask of level 0, and so on *)
Fixpoint vector_levels (A r : nat) (first : nat -> Z) (length : nat -> nat) (a : nat -> Z -> nat -> nat -> R) (f : vectors) (n : nat) : vectors :=
  match n with O => f | S m => vector_step A r (first m) (length m) (a m) (vector_levels A r first length a f m) end.

Definition bounded_data (r : nat) (f : vectors) : Prop := exists B, forall i c, (c < r)%nat -> Rabs (f i c) <= B.

(* The data of level n tend to y F at the points i / A^n, uniformly, and F is continuous. *)
Definition tends_to_vector (A r : nat) (data : nat -> vectors) (y : vec) (F : R -> R) : Prop :=
  continuity F /\ forall eps, 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> forall i c, (c < r)%nat ->
  Rabs (data n i c - y c * F (IZR i / INR A ^ n)) <= eps.

(* What is proved of them with an exponent l: with errors of A^(-n x) for each x < l, multiples of the components of level n are sums of
   `weight` times values h n at and before a point, h n is near to values v n of one function on the grid of the points i / A^n, and
   differences of order m of v n are that small. *)
Definition near_grids (A r m : nat) (lambda l scale : R) (points : nat) (weight : nat -> nat -> R) (data : nat -> vectors) : Prop :=
  exists h v : nat -> Z -> R, (forall n i, v (S n) (Z.of_nat A * i)%Z = v n i) /\ (exists B, forall i, Rabs (v O i) <= B) /\
  forall x, 0 < x < l -> exists K, 0 <= K /\ forall n i, Rabs (differences m (v n) i) <= K * exp (- x * lambda) ^ n /\
  Rabs (h n i - v n i) <= K * exp (- x * lambda) ^ n /\
  forall c, (c < r)%nat -> Rabs (scale * data n i c - sum points (fun j => weight c j * h n (i - Z.of_nat j)%Z)) <= K * exp (- x * lambda) ^ n.

(* ---- functionals ------------------------------------------------------------------------------------------------- *)

Lemma sum_single n f x : (x < n)%nat -> (forall i, (i < n)%nat -> i <> x -> f i = 0) -> sum n f = f x.
Proof.
  intros Hx H. rewrite (sum_ext n f (fun i => identity i x * f i)). apply sum_identity; auto.
  intros i Hi. unfold identity. destruct (Nat.eqb_spec i x). ring. rewrite H by auto. ring.
Qed.

Section Functionals.
Variables (A r : nat) (lo : Z) (len : nat).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.

(* What a sequence u of vectors, which is 0 outside of the window, reads in data f at i *)
Definition in_window (u : vectors) : Prop := forall j c, (c < r)%nat -> (j < lo \/ lo + Z.of_nat len <= j)%Z -> u j c = 0.
Definition reads (u f : vectors) (i : Z) : R :=
  sum len (fun q => sum r (fun c => u (lo + Z.of_nat q)%Z c * f (i - (lo + Z.of_nat q))%Z c)).

Lemma reads_ext u v f i : (forall j c, (c < r)%nat -> u j c = v j c) -> reads u f i = reads v f i.
Proof. intros H. apply sum_ext; intros q _. apply sum_ext; intros c Hc. rewrite H; auto. Qed.

Lemma reads_minus u v f i : reads (fun j c => u j c - v j c) f i = reads u f i - reads v f i.
Proof.
  unfold reads. rewrite <- sum_minus. apply sum_ext; intros q _. rewrite <- sum_minus. apply sum_ext; intros. ring.
Qed.

Lemma reads_scal z u f i : reads (fun j c => z * u j c) f i = z * reads u f i.
Proof. unfold reads. rewrite <- sum_scal. apply sum_ext; intros q _. rewrite <- sum_scal. apply sum_ext; intros. ring. Qed.

Lemma reads_sum n (y : nat -> R) (u : nat -> vectors) f i :
  reads (fun j c => sum n (fun k => y k * u k j c)) f i = sum n (fun k => y k * reads (u k) f i).
Proof.
  induction n; cbn [sum].
  - unfold reads. apply sum_zero; intros. apply sum_zero; intros. ring.
  - rewrite <- IHn, <- reads_scal. unfold reads. rewrite <- sum_plus. apply sum_ext; intros q _. rewrite <- sum_plus.
    apply sum_ext; intros. ring.
Qed.

Lemma reads_bound u f Q B i : 0 <= Q -> 0 <= B -> (forall j c, (c < r)%nat -> Rabs (u j c) <= Q) -> (forall j c, (c < r)%nat -> Rabs (f j c) <= B) ->
  Rabs (reads u f i) <= INR len * (INR r * (Q * B)).
Proof.
  intros HQ HB Hu Hf. unfold reads. eapply Rle_trans. apply sum_abs. apply sum_bound. intros q _.
  eapply Rle_trans. apply sum_abs. apply sum_bound. intros c Hc. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos.
Qed.

(* A shift within the window reads the data elsewhere. *)
Lemma reads_shift u f s i : in_window u -> in_window (fun j c => u (j - s)%Z c) -> reads (fun j c => u (j - s)%Z c) f i = reads u f (i - s)%Z.
Proof.
  intros Hu Hs. unfold reads.
  rewrite (sum_two_windows (fun x => sum r (fun c => u (x - s)%Z c * f (i - x)%Z c)) lo len (lo + s) len).
  - apply sum_ext; intros q _. apply sum_ext; intros c _. f_equal; f_equal; lia.
  - intros x Hx. apply sum_zero; intros c Hc. rewrite (Hs x c Hc) by lia. ring.
  - intros x Hx. apply sum_zero; intros c Hc. rewrite (Hu (x - s)%Z c Hc) by lia. ring.
Qed.

Lemma reads_difference u f i : in_window u -> in_window (fun j c => u (j - 1)%Z c) -> reads (difference u) f i = reads u f i - reads u f (i - 1)%Z.
Proof. intros Hu Hs. unfold difference. rewrite reads_minus, reads_shift; auto. Qed.

(* Of a point and component *)
Definition point_of (c : nat) : vectors := fun i d => if ((i =? 0)%Z && (d =? c)%nat)%bool then 1 else 0.
Lemma reads_point c f i : (c < r)%nat -> (lo <= 0 < lo + Z.of_nat len)%Z -> reads (point_of c) f i = f i c.
Proof.
  intros Hc Hw. unfold reads. rewrite (sum_single len _ (Z.to_nat (- lo))) by (first [lia |
    intros q Hq N; apply sum_zero; intros d Hd; unfold point_of; destruct (Z.eqb_spec (lo + Z.of_nat q) 0); [lia|simpl; ring]]).
  rewrite (sum_single r _ c Hc).
  - unfold point_of. replace (lo + Z.of_nat (Z.to_nat (- lo)))%Z with 0%Z by lia. rewrite Nat.eqb_refl. simpl. rewrite Z.sub_0_r. ring.
  - intros d Hd N. unfold point_of. destruct (Nat.eqb_spec d c); [lia|]. rewrite Bool.andb_false_r. ring.
Qed.

(* ---- one step ------------------------------------------------------------------------------------------------------ *)

Section Step.
Variables (F : Z) (L : nat) (a : Z -> nat -> nat -> R).
Hypothesis Low : ((ZA - 1) * lo <= F)%Z.
Hypothesis High : (F + Z.of_nat L <= (ZA - 1) * (lo + Z.of_nat len - 1))%Z.

Lemma transit_window t u : (t < A)%nat -> in_window u -> in_window (transit A r F L a t u).
Proof.
  intros Ht Hu j c Hc Hj. apply mix_zero. intros m d Hm Hd. apply Hu; auto. fold ZA. destruct Hj as [Hj|Hj]; [left|right]; unfold ZA in *; nia.
Qed.

(* One coefficient and component of the functional *)
Lemma read_one (U G : Z -> R) k t p : (forall j, (j < lo \/ lo + Z.of_nat len <= j)%Z -> U j = 0) -> (t < A)%nat -> (F <= k <= F + Z.of_nat L)%Z ->
  sum len (fun q => U (lo + Z.of_nat q)%Z * (let i := (ZA * p + Z.of_nat t - (lo + Z.of_nat q))%Z in let j := ((i - k) / ZA)%Z in
    if (ZA * j =? i - k)%Z then G j else 0)) =
  sum len (fun x => U (ZA * (lo + Z.of_nat x) + Z.of_nat t - k)%Z * G (p - (lo + Z.of_nat x))%Z).
Proof.
  intros Out Ht Hk. assert (A2 : (2 <= ZA)%Z) by (unfold ZA; lia).
  set (both := fun q x => if (lo + Z.of_nat q =? ZA * (lo + Z.of_nat x) + Z.of_nat t - k)%Z then U (lo + Z.of_nat q)%Z * G (p - (lo + Z.of_nat x))%Z else 0).
  transitivity (sum len (fun q => sum len (fun x => both q x))).
  - apply sum_ext; intros q Hq. cbv zeta. set (i := (ZA * p + Z.of_nat t - (lo + Z.of_nat q))%Z).
    destruct (Z.eqb_spec (ZA * ((i - k) / ZA)) (i - k)) as [E|N].
    + set (J := ((i - k) / ZA)%Z) in *. set (y := (p - J)%Z).
      assert (Ey : (lo + Z.of_nat q = ZA * y + Z.of_nat t - k)%Z) by (unfold y, i in *; lia).
      assert (Y : (lo <= y < lo + Z.of_nat len)%Z). { clear E. clearbody y. unfold ZA in *. split; nia. }
      transitivity (both q (Z.to_nat (y - lo))); [|symmetry; apply sum_single].
      * unfold both. replace (lo + Z.of_nat (Z.to_nat (y - lo)))%Z with y by lia. rewrite <- Ey, Z.eqb_refl. do 2 f_equal. unfold y. lia.
      * lia.
      * intros x Hx N. unfold both. destruct (Z.eqb_spec (lo + Z.of_nat q) (ZA * (lo + Z.of_nat x) + Z.of_nat t - k)) as [E'|]; auto. exfalso.
        assert (ZA * (lo + Z.of_nat x) = ZA * y)%Z by lia. apply Z.mul_cancel_l in H; lia.
    + rewrite Rmult_0_r. symmetry. apply sum_zero. intros x Hx. unfold both.
      destruct (Z.eqb_spec (lo + Z.of_nat q) (ZA * (lo + Z.of_nat x) + Z.of_nat t - k)) as [E'|]; auto. exfalso. apply N.
      replace (i - k)%Z with ((p - (lo + Z.of_nat x)) * ZA)%Z by (unfold i; lia). rewrite Z.div_mul by lia. ring.
  - rewrite sum_swap. apply sum_ext; intros x Hx. set (Y := (ZA * (lo + Z.of_nat x) + Z.of_nat t - k)%Z).
    destruct (Z_lt_ge_dec Y lo) as [Y1|Y1]; [|destruct (Z_lt_ge_dec Y (lo + Z.of_nat len)) as [Y2|Y2]].
    1, 3: rewrite Out, Rmult_0_l by lia; apply sum_zero; intros q Hq; unfold both; fold Y; destruct (Z.eqb_spec (lo + Z.of_nat q) Y); [lia|auto].
    rewrite (sum_single len _ (Z.to_nat (Y - lo))).
    + unfold both. fold Y. replace (lo + Z.of_nat (Z.to_nat (Y - lo)))%Z with Y by lia. rewrite Z.eqb_refl. auto.
    + lia.
    + intros q Hq N. unfold both. fold Y. destruct (Z.eqb_spec (lo + Z.of_nat q) Y); [lia|auto].
Qed.

(* What u reads after a step is what its transition reads before. *)
Lemma reads_step u f t p : in_window u -> (t < A)%nat ->
  reads u (vector_step A r F L a f) (ZA * p + Z.of_nat t) = reads (transit A r F L a t u) f p.
Proof.
  intros Hu Ht.
  set (H := fun m c j => sum r (fun d => a (F + Z.of_nat m)%Z d c * f j d)).
  transitivity (sum (S L) (fun m => sum r (fun c => sum len (fun x =>
    u (ZA * (lo + Z.of_nat x) + Z.of_nat t - (F + Z.of_nat m))%Z c * H m c (p - (lo + Z.of_nat x))%Z)))).
  - transitivity (sum (S L) (fun m => sum r (fun c => sum len (fun q => u (lo + Z.of_nat q)%Z c *
      (let i := (ZA * p + Z.of_nat t - (lo + Z.of_nat q))%Z in let j := ((i - (F + Z.of_nat m)) / ZA)%Z in
       if (ZA * j =? i - (F + Z.of_nat m))%Z then H m c j else 0))))).
    + unfold reads, vector_step. symmetry. rewrite (sum_ext (S L) _ (fun m => sum len (fun q => sum r (fun c => u (lo + Z.of_nat q)%Z c *
        (let i := (ZA * p + Z.of_nat t - (lo + Z.of_nat q))%Z in let j := ((i - (F + Z.of_nat m)) / ZA)%Z in
         if (ZA * j =? i - (F + Z.of_nat m))%Z then H m c j else 0))))) by (intros; apply sum_swap).
      rewrite sum_swap. apply sum_ext; intros q _. rewrite sum_swap. apply sum_ext; intros c _. rewrite sum_scal. reflexivity.
    + apply sum_ext; intros m Hm. apply sum_ext; intros c Hc. apply (read_one (fun j => u j c) (H m c)); auto. lia.
  - unfold reads, transit, mix, H.
    rewrite (sum_ext (S L) _ (fun m => sum len (fun x => sum r (fun c => u (ZA * (lo + Z.of_nat x) + Z.of_nat t - (F + Z.of_nat m))%Z c *
      sum r (fun d => a (F + Z.of_nat m)%Z d c * f (p - (lo + Z.of_nat x))%Z d))))) by (intros; apply sum_swap).
    rewrite sum_swap. apply sum_ext; intros x _. cbv zeta.
    rewrite (sum_ext r _ (fun d => sum (S L) (fun m => f (p - (lo + Z.of_nat x))%Z d *
      sum r (fun c => a (F + Z.of_nat m)%Z d c * u (ZA * (lo + Z.of_nat x) + Z.of_nat t - (F + Z.of_nat m))%Z c)))).
    2: { intros d _. rewrite sum_scal, Rmult_comm. reflexivity. }
    symmetry. rewrite sum_swap. apply sum_ext; intros m _. symmetry.
    rewrite (sum_ext r _ (fun c => sum r (fun d => u (ZA * (lo + Z.of_nat x) + Z.of_nat t - (F + Z.of_nat m))%Z c *
      (a (F + Z.of_nat m)%Z d c * f (p - (lo + Z.of_nat x))%Z d)))) by (intros; rewrite sum_scal; auto).
    rewrite sum_swap. apply sum_ext; intros d _. rewrite <- sum_scal. apply sum_ext; intros c _. ring.
Qed.

Lemma step_bounded f : bounded_data r f -> bounded_data r (vector_step A r F L a f).
Proof.
  intros [B0 H0]. set (B := Rmax B0 0). assert (HB : 0 <= B) by apply Rmax_r.
  assert (H : forall i c, (c < r)%nat -> Rabs (f i c) <= B) by (intros; eapply Rle_trans; [apply H0; auto|apply Rmax_l]).
  set (Q := sum (S L) (fun m => sum r (fun c => sum r (fun d => Rabs (a (F + Z.of_nat m)%Z d c))))).
  exists (Q * B). intros i c Hc. unfold vector_step, Q. rewrite Rmult_comm, <- sum_scal. eapply Rle_trans. apply sum_abs.
  apply sum_le; intros m Hm. cbv zeta.
  assert (N : forall c, 0 <= sum r (fun d => Rabs (a (F + Z.of_nat m)%Z d c))) by (intros; apply sum_nonneg; intros; apply Rabs_pos).
  assert (T := sum_term r (fun c => sum r (fun d => Rabs (a (F + Z.of_nat m)%Z d c))) c (fun i _ => N i) Hc). cbv beta in T.
  apply Rle_trans with (B * sum r (fun d => Rabs (a (F + Z.of_nat m)%Z d c))). 2: apply Rmult_le_compat_l; auto.
  destruct (_ =? _)%Z.
  - rewrite <- sum_scal. eapply Rle_trans. apply sum_abs. apply sum_le; intros d Hd. rewrite Rabs_mult, Rmult_comm.
    apply Rmult_le_compat_r; auto using Rabs_pos.
  - rewrite Rabs_R0. apply Rmult_le_pos; auto.
Qed.
End Step.
End Functionals.

(* A sequence that changes less and less *)
Lemma settles (x : nat -> R) K g : 0 <= K -> 0 < g < 1 -> (forall m, Rabs (x (S m) - x m) <= K * g ^ m) ->
  { l | forall m, Rabs (x m - l) <= K / (1 - g) * g ^ m }.
Proof.
  intros HK Hg H. assert (Q0 : 0 <= K / (1 - g)) by (apply Rmult_le_pos; auto; left; apply Rinv_0_lt_compat; lra).
  assert (W : forall m k, Rabs (x (m + k)%nat - x m) <= K / (1 - g) * g ^ m).
  { intros m k. assert (P : 0 <= g ^ m) by (apply pow_le; lra).
    assert (B : Rabs (x (m + k)%nat - x m) <= K / (1 - g) * (g ^ m - g ^ (m + k))).
    { induction k. rewrite Nat.add_0_r, !Rminus_diag_eq, Rabs_R0 by auto. lra. rewrite Nat.add_succ_r.
      replace (x (S (m + k)) - x m) with ((x (S (m + k)) - x (m + k)%nat) + (x (m + k)%nat - x m)) by ring.
      eapply Rle_trans. apply Rabs_triang. specialize (H (m + k)%nat). rewrite <- tech_pow_Rmult.
      replace (K / (1 - g) * (g ^ m - g * g ^ (m + k))) with (K * g ^ (m + k) + K / (1 - g) * (g ^ m - g ^ (m + k))) by (field; lra). lra. }
    assert (0 <= K / (1 - g) * g ^ (m + k)) by (apply Rmult_le_pos; auto; apply pow_le; lra). lra. }
  assert (C : Cauchy_crit x).
  { intros eps He. destruct (small_power g Hg (K / (1 - g)) (eps / 3) Q0 ltac:(lra)) as [n0 Hn]. exists n0. intros n m Hn1 Hm1. unfold R_dist.
    specialize (Hn n0 (le_n n0)). assert (W1 := W n0 (n - n0)%nat). assert (W2 := W n0 (m - n0)%nat).
    replace (n0 + (n - n0))%nat with n in W1 by lia. replace (n0 + (m - n0))%nat with m in W2 by lia. rewrite Rabs_minus_sym in W2.
    replace (x n - x m) with ((x n - x n0) + (x n0 - x m)) by ring. eapply Rle_lt_trans. apply Rabs_triang. lra. }
  destruct (R_complete x C) as [l Hl]. exists l. intros m. rewrite Rabs_minus_sym.
  apply (limit_bound 2 (le_n 2) x l _ _ m Hl). intros n Hn. replace n with (m + (n - m))%nat by lia. apply W.
Qed.

(* ---- a mask for each level ------------------------------------------------------------------------------------------ *)

Section Levels.
Variables (A r : nat) (lo : Z) (len : nat).
Hypothesis Arity : (2 <= A)%nat.
Let ZA := Z.of_nat A.
Variables (F : nat -> Z) (L : nat -> nat) (a : nat -> Z -> nat -> nat -> R).
Hypothesis Low : forall n, ((ZA - 1) * lo <= F n)%Z.
Hypothesis High : forall n, (F n + Z.of_nat (L n) <= (ZA - 1) * (lo + Z.of_nat len - 1))%Z.
Notation data f := (vector_levels A r F L a f).
Notation window := (in_window r lo len).
Notation reading := (reads r lo len).

(* What is read of level n + the length of w, at level n *)
Fixpoint lead (n : nat) (w : list nat) (u : vectors) : vectors :=
  match w with [] => u | t :: w' => transit A r (F n) (L n) (a n) t (lead (S n) w' u) end.

Lemma lead_app w v u : forall n, lead n (w ++ v) u = lead n w (lead (n + length w) v u).
Proof.
  induction w as [|t w IH]; intros n; cbn [lead app length]. rewrite Nat.add_0_r. auto.
  rewrite IH. rewrite Nat.add_succ_r. reflexivity.
Qed.

Lemma lead_ext u v w : (forall j c, (c < r)%nat -> u j c = v j c) -> forall n j c, (c < r)%nat -> lead n w u j c = lead n w v j c.
Proof. intros H. induction w as [|t w IH]; intros n j c Hc; cbn [lead]; auto. apply mix_ext. intros. apply IH; auto. Qed.

(* All data that are read at one place of a level are read at one place of an earlier one. *)
Lemma reads_lead n1 n : forall p, exists w j, letters A w /\ length w = n /\ forall u f, window u -> reading u (data f (n1 + n)) p = reading (lead n1 w u) (data f n1) j.
Proof.
  induction n; intros p.
  - exists [], p. rewrite Nat.add_0_r. split. constructor. split; auto.
  - destruct (IHn (p / ZA)%Z) as [w [j [Hw [Hl E]]]]. assert (B := Z.mod_pos_bound p ZA ltac:(unfold ZA; lia)).
    assert (D := Z.div_mod p ZA ltac:(unfold ZA; lia)). set (t := Z.to_nat (p mod ZA)). assert (Ht : (t < A)%nat) by (unfold t, ZA in *; lia).
    exists (w ++ [t]), j. split; [|split].
    + apply letters_app. split; auto. repeat constructor. auto.
    + rewrite app_length. simpl. lia.
    + intros u f Hu. rewrite lead_app, Hl. cbn [lead]. rewrite Nat.add_succ_r. cbn [vector_levels].
      replace p with (Z.of_nat A * (p / ZA) + Z.of_nat t)%Z by (unfold t, ZA in *; lia).
      rewrite (reads_step A r lo len Arity) by auto. replace ((Z.of_nat A * (p / ZA) + Z.of_nat t) / ZA)%Z with (p / ZA)%Z.
      apply E. apply transit_window; auto. unfold t. rewrite Z2Nat.id by lia. fold ZA. rewrite <- D. auto.
Qed.

Lemma data_bounded_at f n : bounded_data r f -> bounded_data r (data f n).
Proof. intros H. induction n; auto. cbn [vector_levels]. apply step_bounded; auto. Qed.

(* ---- functionals that come into a space ----------------------------------------------------------------------------- *)

Variables (N : nat) (b : nat -> vectors) (T : nat -> nat -> mat) (P : R).
Hypothesis Invariant : forall n t k, (t < A)%nat -> (k < N)%nat -> forall j c, (c < r)%nat ->
  transit A r (F n) (L n) (a n) t (b k) j c = sum N (fun l => T n t l k * b l j c).
Hypothesis Basis : forall k, (k < N)%nat -> forall j c, (c < r)%nat -> Rabs (b k j c) <= P.

Fixpoint run_levels (T : nat -> nat -> mat) (w : list nat) (y : vec) : vec :=
  match w with [] => y | t :: w' => apply N (T O t) (run_levels (fun k => T (S k)) w' y) end.

Lemma run_level_word w y : forall T i, (i < N)%nat -> run_levels T w y i = sum N (fun j => level_word N T w i j * y j).
Proof.
  induction w as [|t w IH]; intros T' i Hi; cbn [run_levels level_word].
  - rewrite (sum_ext N _ (fun j => identity j i * y j)). symmetry. apply sum_identity; auto.
    intros j Hj. unfold identity. destruct (Nat.eqb_spec i j), (Nat.eqb_spec j i); try lia; auto.
  - unfold apply. rewrite (sum_ext N _ (fun k => sum N (fun j => T' O t i k * (level_word N (fun k => T' (S k)) w k j * y j)))).
    + rewrite sum_swap. apply sum_ext; intros j Hj. unfold times. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros. ring.
    + intros k Hk. rewrite IH by auto. rewrite sum_scal. auto.
Qed.

Lemma lead_span w : letters A w -> forall n u y, (forall j c, (c < r)%nat -> u j c = span N b y j c) ->
  forall j c, (c < r)%nat -> lead n w u j c = span N b (run_levels (fun k => T (n + k)%nat) w y) j c.
Proof.
  induction w as [|t w IH]; intros Hw n u y Hu j c Hc. apply Hu; auto. inversion Hw; subst. cbn [lead run_levels].
  unfold transit. rewrite (mix_ext _ _ _ _ _ (fun k d => span N b (run_levels (fun k => T (S n + k)%nat) w y) (Z.of_nat A * j + Z.of_nat t - k)%Z d))
    by (intros; apply IH; auto).
  replace (fun k => T (n + S k)%nat) with (fun k => T (S n + k)%nat) by (extensionality k; f_equal; lia). rewrite Nat.add_0_r.
  unfold span. rewrite mix_sum. set (x := run_levels _ w y).
  rewrite (sum_ext N _ (fun i => sum N (fun l => x i * (T n t l i * b l j c)))).
  - rewrite sum_swap. apply sum_ext; intros l Hl. unfold apply. rewrite Rmult_comm, <- sum_scal. apply sum_ext; intros. ring.
  - intros i Hi. rewrite sum_scal. f_equal. rewrite <- Invariant; auto.
Qed.

(* Some shifts of the space, within the window *)
Variables (shifts : nat) (shift : nat -> Z).
Hypothesis Basis_window : forall k, (k < N)%nat -> window (b k).
Hypothesis Shift_window : forall s k, (s < shifts)%nat -> (k < N)%nat -> window (fun j c => b k (j - shift s)%Z c).

(* After so many letters it is a sum of shifts of what is in the space, with coordinates up to Y. *)
Definition comes_in (start : nat) (Y Q : R) (u : vectors) : Prop := window u /\ (forall j c, (c < r)%nat -> Rabs (u j c) <= Q) /\
  forall n w, letters A w -> length w = start -> exists y, (forall s k, (s < shifts)%nat -> (k < N)%nat -> Rabs (y s k) <= Y) /\
  forall j c, (c < r)%nat -> lead n w u j c = sum shifts (fun s => span N b (y s) (j - shift s)%Z c).

Section Data.
Variable f : vectors.
Hypothesis Bounded : bounded_data r f.

Lemma reads_early s Q : exists K, 0 <= K /\ forall u, (forall j c, (c < r)%nat -> Rabs (u j c) <= Q) -> forall n, (n < s)%nat ->
  forall p, Rabs (reading u (data f n) p) <= K.
Proof.
  induction s. exists 0. split. lra. intros; lia. destruct IHs as [K [K0 HK]].
  destruct (data_bounded_at f s Bounded) as [B HB]. set (Q' := Rmax Q 0). set (B' := Rmax B 0).
  assert (Q0 : 0 <= Q') by apply Rmax_r. assert (B0 : 0 <= B') by apply Rmax_r.
  exists (Rmax K (INR len * (INR r * (Q' * B')))). split. eapply Rle_trans. apply K0. apply Rmax_l.
  intros u Hu n Hn p. destruct (Nat.eq_dec n s) as [->|].
  - eapply Rle_trans; [|apply Rmax_r]. apply reads_bound; auto; intros; eapply Rle_trans; eauto; apply Rmax_l.
  - eapply Rle_trans; [|apply Rmax_l]. apply HK; auto. lia.
Qed.

(* What is in the space reads less and less, and so does what comes into it. *)
Lemma span_shrinks Y C g : 0 < g <= 1 -> (forall w, letters A w -> forall p q, (p < N)%nat -> (q < N)%nat -> Rabs (level_word N T w p q) <= C * g ^ length w) ->
  exists K, 0 <= K /\ forall y, (forall k, (k < N)%nat -> Rabs (y k) <= Y) -> forall n p, Rabs (reading (span N b y) (data f n) p) <= K * g ^ n.
Proof.
  intros Hg HC. destruct Bounded as [B0 HB0]. set (B := Rmax B0 0). set (C' := Rmax C 0). set (P' := Rmax P 0). set (Y' := Rmax Y 0).
  assert (B1 : 0 <= B) by apply Rmax_r. assert (C1 : 0 <= C') by apply Rmax_r. assert (P1 : 0 <= P') by apply Rmax_r. assert (Y1 : 0 <= Y') by apply Rmax_r.
  assert (N0 := pos_INR N). assert (L0 := pos_INR len). assert (R0 := pos_INR r).
  exists (INR len * (INR r * (INR N * (INR N * (C' * Y') * P') * B))). split. { repeat (apply Rmult_le_pos; auto). }
  intros y Hy n p. assert (G0 : 0 <= g ^ n) by (apply pow_le; lra).
  assert (Wy : window (span N b y)) by (intros j c Hc Hj; unfold span; apply sum_zero; intros k Hk; rewrite (Basis_window k Hk j c Hc Hj); ring).
  destruct (reads_lead 0 n p) as [w [j [Hw [Hl E]]]]. rewrite Nat.add_0_l in E. rewrite E by auto.
  rewrite (reads_ext r lo len _ (span N b (run_levels T w y))) by (intros; apply (lead_span w Hw 0 _ y); auto).
  assert (Run : forall k, (k < N)%nat -> Rabs (run_levels T w y k) <= INR N * (C' * Y') * g ^ n).
  { intros k Hk. rewrite run_level_word by auto. eapply Rle_trans. apply sum_abs.
    replace (INR N * (C' * Y') * g ^ n) with (INR N * (C' * g ^ n * Y')) by ring. apply sum_bound. intros q Hq. rewrite Rabs_mult.
    apply Rmult_le_compat; auto using Rabs_pos.
    - rewrite <- Hl. eapply Rle_trans. apply HC; auto. apply Rmult_le_compat_r. apply pow_le; lra. apply Rmax_l.
    - eapply Rle_trans. apply Hy; auto. apply Rmax_l. }
  replace (INR len * (INR r * (INR N * (INR N * (C' * Y') * P') * B)) * g ^ n) with
    (INR len * (INR r * (INR N * (INR N * (C' * Y') * g ^ n * P') * B))) by ring.
  apply reads_bound; auto.
  - repeat (apply Rmult_le_pos; auto).
  - intros i c Hc. unfold span. eapply Rle_trans. apply sum_abs. apply sum_bound. intros k Hk. rewrite Rabs_mult.
    apply Rmult_le_compat; auto using Rabs_pos. eapply Rle_trans. apply Basis; auto. apply Rmax_l.
  - intros i c Hc. eapply Rle_trans. apply HB0; auto. apply Rmax_l.
Qed.

Theorem reads_shrink start Y Q C g : 0 < g <= 1 -> (forall w, letters A w -> forall p q, (p < N)%nat -> (q < N)%nat ->
  Rabs (level_word N T w p q) <= C * g ^ length w) ->
  exists K, 0 <= K /\ forall u, comes_in start Y Q u -> forall n p, Rabs (reading u (data f n) p) <= K * g ^ n.
Proof.
  intros Hg HC. destruct (reads_early start Q) as [K1 [K10 HK1]]. destruct (span_shrinks Y C g Hg HC) as [K2 [K20 HK2]].
  assert (GS : 0 < g ^ start) by (apply pow_lt; lra). assert (S0 := pos_INR shifts).
  assert (D : forall x, 0 <= x -> 0 <= x / g ^ start) by (intros; apply Rmult_le_pos; auto; left; apply Rinv_0_lt_compat; auto).
  assert (K30 : 0 <= INR shifts * K2) by (apply Rmult_le_pos; auto).
  exists (K1 / g ^ start + INR shifts * K2 / g ^ start). split. { generalize (D K1 K10) (D _ K30). lra. }
  intros u [Wu [Qu Eu]] n p. assert (Gn : 0 < g ^ n) by (apply pow_lt; lra). assert (D1 := D K1 K10). assert (D2 := D _ K30).
  rewrite Rmult_plus_distr_r. assert (0 <= K1 / g ^ start * g ^ n) by (apply Rmult_le_pos; lra). assert (0 <= INR shifts * K2 / g ^ start * g ^ n) by (apply Rmult_le_pos; lra).
  destruct (Nat.lt_ge_cases n start) as [S|S].
  - assert (G1 : g ^ start <= g ^ n).
    { replace start with (n + (start - n))%nat by lia. rewrite pow_add. rewrite <- (Rmult_1_r (g ^ n)) at 2. apply Rmult_le_compat_l. lra.
      rewrite <- (pow1 (start - n)). apply pow_incr. lra. }
    assert (E := HK1 u Qu n S p). assert (K1 / g ^ start * g ^ start <= K1 / g ^ start * g ^ n) by (apply Rmult_le_compat_l; auto).
    assert (K1 / g ^ start * g ^ start = K1) by (field; lra). lra.
  - destruct (reads_lead (n - start) start p) as [w [i [Hw [Hl E]]]]. replace (n - start + start)%nat with n in E by lia. rewrite E by auto.
    destruct (Eu (n - start)%nat w Hw Hl) as [y [Hy Ey]].
    rewrite (reads_ext r lo len _ (fun j c => sum shifts (fun s => 1 * span N b (y s) (j - shift s)%Z c)))
      by (intros; rewrite Ey by auto; apply sum_ext; intros; ring).
    rewrite (reads_sum r lo len shifts (fun _ => 1) (fun s j c => span N b (y s) (j - shift s)%Z c)).
    apply Rle_trans with (INR shifts * (K2 * g ^ (n - start))).
    + eapply Rle_trans. apply sum_abs. apply sum_bound. intros s Hs. rewrite Rmult_1_l.
      rewrite (reads_shift A r lo len Arity (span N b (y s))).
      * apply HK2. auto.
      * intros j c Hc Hj. unfold span. apply sum_zero; intros k Hk. rewrite (Basis_window k Hk j c Hc Hj). ring.
      * intros j c Hc Hj. unfold span. apply sum_zero; intros k Hk. assert (Z0 := Shift_window s k Hs Hk j c Hc Hj). cbv beta in Z0. rewrite Z0. ring.
    + replace (INR shifts * K2 / g ^ start * g ^ n) with (INR shifts * (K2 * g ^ (n - start))). lra.
      replace (g ^ n) with (g ^ (n - start) * g ^ start) by (rewrite <- pow_add; f_equal; lia). field. lra.
Qed.
End Data.

(* ---- the limit ------------------------------------------------------------------------------------------------------ *)

Variables (M : nat) (lambda l : R).
Hypothesis Log : exp lambda = INR A.
Hypothesis End : 0 < l <= INR M.
Hypothesis Growth : forall x, 0 < x < l -> exists C, forall w, letters A w -> forall p q, (p < N)%nat -> (q < N)%nat ->
  Rabs (level_word N T w p q) <= C * exp (- x * lambda) ^ length w.

(* A functional U that all steps keep, but for what comes into the space. So do its differences of order M, and each component of the
   data at a point less multiples of what U reads at it and before it. *)
Variables (U : vectors) (margin start : nat) (Y Q : R) (points : nat) (weight : nat -> nat -> R) (scale : R).
Hypothesis Narrow : forall j c, (c < r)%nat -> (j < lo \/ lo + Z.of_nat len - Z.of_nat margin <= j)%Z -> U j c = 0.
Hypothesis Size : forall j c, (c < r)%nat -> Rabs (U j c) <= Q.
Hypothesis Order : (M <= margin)%nat.
Hypothesis Points : (points <= S margin)%nat.
Hypothesis Scale : scale <> 0.
Hypothesis Inside : (lo <= 0 < lo + Z.of_nat len)%Z.
Hypothesis Kept : forall n, comes_in start Y Q (fun j c => transit A r (F n) (L n) (a n) 0 U j c - U j c).
Hypothesis Smooth : comes_in start Y Q (vector_differences M U).
Hypothesis Components : forall c, (c < r)%nat ->
  comes_in start Y Q (fun i d => scale * point_of c i d - sum points (fun j => weight c j * U (i - Z.of_nat j)%Z d)).

Lemma shift_window s : (s <= margin)%nat -> window (fun j c => U (j - Z.of_nat s)%Z c).
Proof. intros H j c Hc Hj. apply Narrow; auto. lia. Qed.

Lemma whole_window : window U.
Proof. intros j c Hc Hj. apply Narrow; auto. lia. Qed.

Lemma reads_differences f : forall m, (m <= margin)%nat -> (forall i, reading (vector_differences m U) f i = differences m (fun i => reading U f i) i) /\
  forall j c, (c < r)%nat -> (j < lo \/ lo + Z.of_nat len - Z.of_nat margin + Z.of_nat m <= j)%Z -> vector_differences m U j c = 0.
Proof.
  induction m; intros Hm. { split; auto. intros j c Hc Hj. apply Narrow; auto. lia. }
  destruct (IHm ltac:(lia)) as [E W]. split.
  - intros i. cbn [vector_differences differences]. rewrite (reads_difference A r lo len Arity).
    + rewrite !E. auto.
    + intros j c Hc Hj. apply W; auto. lia.
    + intros j c Hc Hj. apply W; auto. lia.
  - intros j c Hc Hj. cbn [vector_differences]. unfold difference. rewrite !W by (auto; lia). ring.
Qed.

Lemma differences_near (h k : Z -> R) e : (forall i, Rabs (h i - k i) <= e) -> forall m i, Rabs (differences m h i - differences m k i) <= 2 ^ m * e.
Proof.
  intros H. induction m; intros i; cbn [differences pow]. rewrite Rmult_1_l. auto.
  replace (differences m h i - differences m h (i - 1)%Z - (differences m k i - differences m k (i - 1)%Z)) with
    ((differences m h i - differences m k i) - (differences m h (i - 1)%Z - differences m k (i - 1)%Z)) by ring.
  unfold Rminus at 1. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. generalize (IHm i) (IHm (i - 1)%Z). lra.
Qed.

Section Limit.
Variable f : vectors.
Hypothesis Bounded : bounded_data r f.
Let h n i := reading U (data f n) i.
Let g x := exp (- x * lambda).

Lemma rate_between x : 0 < x -> 0 < g x < 1.
Proof.
  intros Hx. split. apply exp_pos. unfold g. rewrite <- exp_0. apply exp_less. assert (X := log_positive A Arity lambda Log). nra.
Qed.

Lemma component_read n i c : (c < r)%nat -> reading (fun i d => scale * point_of c i d - sum points (fun j => weight c j * U (i - Z.of_nat j)%Z d)) (data f n) i =
  scale * data f n i c - sum points (fun j => weight c j * h n (i - Z.of_nat j)%Z).
Proof.
  intros Hc. rewrite (reads_minus r lo len (fun i d => scale * point_of c i d)), reads_scal, (reads_point A) by auto. f_equal.
  rewrite (reads_sum r lo len points (weight c) (fun j i d => U (i - Z.of_nat j)%Z d)). apply sum_ext; intros j Hj. f_equal.
  apply (reads_shift A r lo len Arity U). apply whole_window. apply shift_window. lia.
Qed.

(* All that shrinks, at one rate *)
Lemma all_shrink x : 0 < x < l -> exists K, 0 <= K /\ forall n i, Rabs (h (S n) (ZA * i)%Z - h n i) <= K * g x ^ n /\
  Rabs (differences M (h n) i) <= K * g x ^ n /\
  forall c, (c < r)%nat -> Rabs (scale * data f n i c - sum points (fun j => weight c j * h n (i - Z.of_nat j)%Z)) <= K * g x ^ n.
Proof.
  intros Hx. destruct (Growth x Hx) as [C HC]. assert (R0 := rate_between x ltac:(lra)).
  destruct (reads_shrink f Bounded start Y Q C (g x) ltac:(lra) HC) as [K [K0 HK]]. exists K. split; auto. intros n i. split; [|split].
  - specialize (HK _ (Kept n) n i). rewrite (reads_minus r lo len (transit A r (F n) (L n) (a n) 0 U)) in HK.
    rewrite <- (reads_step A r lo len Arity (F n) (L n) (a n) (Low n) (High n) U (data f n) 0 i whole_window ltac:(lia)) in HK.
    fold ZA in HK. rewrite Z.add_0_r in HK. exact HK.
  - specialize (HK _ Smooth n i). destruct (reads_differences (data f n) M Order) as [E _]. rewrite E in HK. exact HK.
  - intros c Hc. specialize (HK _ (Components c Hc) n i). rewrite component_read in HK by auto. exact HK.
Qed.

(* The values at the points of the grids *)
Lemma grid_values : exists v : nat -> Z -> R, (forall n i, v (S n) (ZA * i)%Z = v n i) /\
  forall x, 0 < x < l -> exists K, 0 <= K /\ forall n i, Rabs (h n i - v n i) <= K * g x ^ n.
Proof.
  assert (Sig : forall x, 0 < x < l -> exists K, 0 <= K /\ forall n i, exists v, forall m, Rabs (h (n + m)%nat (ZA ^ Z.of_nat m * i)%Z - v) <= K * g x ^ n * g x ^ m).
  { intros x Hx. destruct (all_shrink x Hx) as [K [K0 HK]]. assert (R0 := rate_between x ltac:(lra)). exists (K / (1 - g x)). split.
    { apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat. lra. }
    intros n i. assert (P0 : 0 <= g x ^ n) by (apply pow_le; lra).
    destruct (settles (fun m => h (n + m)%nat (ZA ^ Z.of_nat m * i)%Z) (K * g x ^ n) (g x)) as [v Hv]; auto.
    - apply Rmult_le_pos; auto.
    - intros m. destruct (HK (n + m)%nat (ZA ^ Z.of_nat m * i)%Z) as [H _]. rewrite Nat.add_succ_r, Nat2Z.inj_succ, Z.pow_succ_r by lia.
      rewrite pow_add in H. replace (ZA * ZA ^ Z.of_nat m * i)%Z with (ZA * (ZA ^ Z.of_nat m * i))%Z by ring. rewrite Rmult_assoc. exact H.
    - exists v. intros m. eapply Rle_trans. apply Hv. right. field. lra. }
  assert (Hl : 0 < l / 2 < l) by lra. destruct (all_shrink (l / 2) Hl) as [K0 [K00 HK0]]. assert (R0 := rate_between (l / 2) ltac:(lra)).
  assert (Pick : forall n i, { v | forall m, Rabs (h (n + m)%nat (ZA ^ Z.of_nat m * i)%Z - v) <= K0 * g (l / 2) ^ n / (1 - g (l / 2)) * g (l / 2) ^ m }).
  { intros n i. apply settles; auto.
    - apply Rmult_le_pos; auto. apply pow_le. lra.
    - intros m. destruct (HK0 (n + m)%nat (ZA ^ Z.of_nat m * i)%Z) as [H _]. rewrite Nat.add_succ_r, Nat2Z.inj_succ, Z.pow_succ_r by lia.
      rewrite pow_add in H. replace (ZA * ZA ^ Z.of_nat m * i)%Z with (ZA * (ZA ^ Z.of_nat m * i))%Z by ring. rewrite Rmult_assoc. exact H. }
  set (v := fun n i => proj1_sig (Pick n i)).
  assert (Hv : forall n i m, Rabs (h (n + m)%nat (ZA ^ Z.of_nat m * i)%Z - v n i) <= K0 * g (l / 2) ^ n / (1 - g (l / 2)) * g (l / 2) ^ m).
  { intros n i m. unfold v. destruct (Pick n i) as [y Hy]. simpl. apply Hy. }
  (* what is as near to the same values is the same *)
  assert (Same : forall (x y : R) (z : nat -> R) D D' q q', 0 <= D -> 0 <= D' -> 0 < q < 1 -> 0 < q' < 1 -> (forall m, Rabs (z m - x) <= D * q ^ m) ->
    (forall m, Rabs (z m - y) <= D' * q' ^ m) -> x = y).
  { intros x y z D D' q q' HD HD' Hq Hq' H H'. apply cond_eq. intros eps He.
    destruct (small_power q Hq D (eps / 3) HD ltac:(lra)) as [n1 H1]. destruct (small_power q' Hq' D' (eps / 3) HD' ltac:(lra)) as [n2 H2].
    specialize (H (n1 + n2)%nat). specialize (H' (n1 + n2)%nat). specialize (H1 (n1 + n2)%nat ltac:(lia)). specialize (H2 (n1 + n2)%nat ltac:(lia)).
    rewrite Rabs_minus_sym in H. replace (x - y) with ((x - z (n1 + n2)%nat) + (z (n1 + n2)%nat - y)) by ring. eapply Rle_lt_trans. apply Rabs_triang. lra. }
  assert (D0 : forall n, 0 <= K0 * g (l / 2) ^ n / (1 - g (l / 2))).
  { intros n. apply Rmult_le_pos. apply Rmult_le_pos; auto. apply pow_le; lra. left; apply Rinv_0_lt_compat; lra. }
  exists v. split.
  - intros n i. apply (Same _ _ (fun m => h (S n + m)%nat (ZA ^ Z.of_nat m * (ZA * i))%Z) _ (K0 * g (l / 2) ^ n / (1 - g (l / 2))) _ (g (l / 2)) (D0 (S n)) (D0 n) R0 R0 (Hv (S n) (ZA * i)%Z)).
    intros m. specialize (Hv n i (S m)). rewrite Nat2Z.inj_succ, Z.pow_succ_r in Hv by lia. rewrite Nat.add_succ_r in Hv.
    replace (S n + m)%nat with (S (n + m)) by lia. replace (ZA ^ Z.of_nat m * (ZA * i))%Z with (ZA * ZA ^ Z.of_nat m * i)%Z by ring.
    eapply Rle_trans. apply Hv. apply Rmult_le_compat_l; auto. rewrite <- tech_pow_Rmult. rewrite <- (Rmult_1_l (g (l / 2) ^ m)) at 2.
    apply Rmult_le_compat_r. apply pow_le; lra. lra.
  - intros x Hx. destruct (Sig x Hx) as [K [HK HS]]. exists K. split; auto. intros n i. destruct (HS n i) as [y Hy]. assert (Rx := rate_between x ltac:(lra)).
    assert (E : v n i = y).
    { assert (D1 : 0 <= K * g x ^ n) by (apply Rmult_le_pos; auto; apply pow_le; lra).
      apply (Same _ _ (fun m => h (n + m)%nat (ZA ^ Z.of_nat m * i)%Z) _ _ _ _ (D0 n) D1 R0 Rx (Hv n i) Hy). }
    rewrite E. specialize (Hy O). rewrite Nat.add_0_r in Hy. change (ZA ^ Z.of_nat 0)%Z with 1%Z in Hy. rewrite Z.mul_1_l, Rmult_1_r in Hy. exact Hy.
Qed.

(* The limit, and how near data are to it *)
Theorem data_limit : exists phi, tends_to_vector A r (data f) (fun c => sum points (weight c) / scale) phi /\ exponent_at_least phi l /\
  near_grids A r M lambda l scale points weight (data f).
Proof.
  destruct grid_values as [v [Same Near]].
  assert (Start : exists B, forall i, Rabs (v O i) <= B).
  { destruct (Near (l / 2) ltac:(lra)) as [K [K0 HK]]. destruct (reads_early f Bounded 1 Q) as [B [B0 HB]]. exists (B + K). intros i.
    specialize (HK O i). rewrite pow_O, Rmult_1_r, Rabs_minus_sym in HK. specialize (HB U Size O ltac:(lia) i). fold (h O i) in HB.
    replace (v O i) with ((v O i - h O i) + h O i) by ring. eapply Rle_trans. apply Rabs_triang. lra. }
  destruct Start as [B HB].
  assert (Diff : forall x, 0 < x < l -> exists C, forall n i, Rabs (differences M (v n) i) <= C * exp (- x * lambda) ^ n).
  { intros x Hx. destruct (Near x Hx) as [K [K0 HK]]. destruct (all_shrink x Hx) as [K' [K0' HK']]. exists (2 ^ M * K + K'). intros n i.
    destruct (HK' n i) as [_ [D _]]. assert (D' := differences_near (v n) (h n) (K * g x ^ n) (fun i => eq_ind _ (fun z => z <= _) (HK n i) _ (Rabs_minus_sym _ _)) M i).
    fold (g x). replace (differences M (v n) i) with ((differences M (v n) i - differences M (h n) i) + differences M (h n) i) by ring.
    eapply Rle_trans. apply Rabs_triang. lra. }
  destruct (grid_exponent A Arity v Same lambda Log M l B End HB Diff) as [phi [Tends [Co Ex]]].
  assert (V := tends_values A Arity v Same phi Tends).
  (* neighbours *)
  set (x := Rmin l 1 / 2). assert (Hx : 0 < x < l /\ x < 1).
  { unfold x. assert (0 < Rmin l 1) by (apply Rmin_glb_lt; lra). generalize (Rmin_l l 1) (Rmin_r l 1). lra. }
  destruct Hx as [Hx X1]. assert (R0 := rate_between x ltac:(lra)).
  assert (M1 : (0 < M)%nat). { destruct M; [simpl in End; lra|lia]. }
  assert (Holder : exists C, 0 <= C /\ forall n i, Rabs (phi (IZR i / INR A ^ n) - phi (IZR (i - 1) / INR A ^ n)) <= C * g x ^ n).
  { destruct (Diff x Hx) as [C HC]. destruct (grid_holder A Arity v Same lambda Log M 0 x C B M1) as [psi [Tends' [_ Ho]]]; auto. { simpl. lra. }
    simpl in Ho. rewrite Rminus_0_r in Ho. destruct Ho as [C' HC']. exists (Rmax C' 0). split. apply Rmax_r. intros n i.
    rewrite !(tends_unique A Arity v phi psi Tends Tends'). assert (PN := power_positive A Arity n).
    assert (E : exp (- (INR n * lambda)) = / INR A ^ n) by (rewrite exp_Ropp, <- Log, exp_power; auto).
    specialize (HC' (IZR (i - 1) / INR A ^ n) (- (INR n * lambda))). rewrite E in HC'.
    replace (IZR (i - 1) / INR A ^ n + / INR A ^ n) with (IZR i / INR A ^ n) in HC' by (rewrite minus_IZR; field; lra).
    eapply Rle_trans. apply HC'. unfold g. rewrite exp_power. replace (x * - (INR n * lambda)) with (INR n * (- x * lambda)) by ring.
    apply Rmult_le_compat_r. left; apply exp_pos. apply Rmax_l. }
  destruct Holder as [C [C0 HC]]. destruct (Near x Hx) as [K [K0 HK]]. destruct (all_shrink x Hx) as [K' [K0' HK']].
  assert (Back : forall n i j, Rabs (phi (IZR i / INR A ^ n) - phi (IZR (i - Z.of_nat j) / INR A ^ n)) <= INR j * (C * g x ^ n)).
  { intros n i j. induction j.
    - rewrite Z.sub_0_r, Rminus_diag_eq, Rabs_R0 by auto. simpl. lra.
    - rewrite S_INR. specialize (HC n (i - Z.of_nat j)%Z). replace (i - Z.of_nat j - 1)%Z with (i - Z.of_nat (S j))%Z in HC by lia.
      match goal with |- Rabs (?y - ?z) <= _ => replace (y - z) with ((y - phi (IZR (i - Z.of_nat j) / INR A ^ n)) + (phi (IZR (i - Z.of_nat j) / INR A ^ n) - z)) by ring end.
      eapply Rle_trans. apply Rabs_triang. lra. }
  exists phi. split; [split; auto|split; auto].
  - intros eps He. set (W := sum r (fun c => sum points (fun j => Rabs (weight c j)))).
    assert (W0 : forall c, 0 <= sum points (fun j => Rabs (weight c j))) by (intros; apply sum_nonneg; intros; apply Rabs_pos).
    assert (W1 : 0 <= W) by (apply sum_nonneg; auto).
    set (D := K + INR points * C). assert (D0 : 0 <= D) by (unfold D; apply Rplus_le_le_0_compat; auto; apply Rmult_le_pos; auto; apply pos_INR).
    assert (S0 : 0 < Rabs scale) by (apply Rabs_pos_lt; auto).
    destruct (small_power (g x) R0 (K' + W * D) (Rabs scale * eps)) as [n0 Hn].
    { apply Rplus_le_le_0_compat; auto. apply Rmult_le_pos; auto. } { apply Rmult_lt_0_compat; auto. }
    exists n0. intros n Hle i c Hc. specialize (Hn n Hle). destruct (HK' n i) as [_ [_ Comp]]. specialize (Comp c Hc).
    assert (G0 : 0 <= g x ^ n) by (apply pow_le; lra).
    set (p := phi (IZR i / INR A ^ n)) in *. apply (Rmult_le_reg_l (Rabs scale)); auto. rewrite <- Rabs_mult.
    replace (scale * (data f n i c - sum points (weight c) / scale * p)) with
      ((scale * data f n i c - sum points (fun j => weight c j * h n (i - Z.of_nat j)%Z)) + sum points (fun j => weight c j * (h n (i - Z.of_nat j)%Z - p))).
    2: { rewrite (sum_ext points (fun j => weight c j * (h n (i - Z.of_nat j)%Z - p)) (fun j => weight c j * h n (i - Z.of_nat j)%Z - p * weight c j)) by (intros; ring).
         rewrite sum_minus, sum_scal. field. auto. }
    eapply Rle_trans. apply Rabs_triang. apply Rle_trans with (K' * g x ^ n + W * D * g x ^ n); [|lra]. apply Rplus_le_compat; auto.
    eapply Rle_trans. apply sum_abs. apply Rle_trans with (sum points (fun j => D * g x ^ n * Rabs (weight c j))).
    + apply sum_le; intros j Hj. rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos.
      specialize (HK n (i - Z.of_nat j)%Z). rewrite <- V in HK. specialize (Back n i j). fold p in Back. rewrite Rabs_minus_sym in Back.
      match type of HK with Rabs (?y - ?z) <= _ => replace (y - p) with ((y - z) + (z - p)) by ring end.
      eapply Rle_trans. apply Rabs_triang. unfold D. assert (INR j * (C * g x ^ n) <= INR points * (C * g x ^ n)); [|lra].
      apply Rmult_le_compat_r. apply Rmult_le_pos; auto. apply le_INR. lia.
    + rewrite sum_scal. replace (W * D * g x ^ n) with (D * g x ^ n * W) by ring. apply Rmult_le_compat_l. apply Rmult_le_pos; auto.
      apply (sum_term r (fun c => sum points (fun j => Rabs (weight c j))) c); auto.
  - exists h, v. split; auto. split. exists B; auto. intros y Hy. destruct (Near y Hy) as [K1 [K10 HK1]]. destruct (all_shrink y Hy) as [K2 [K20 HK2]].
    destruct (Diff y Hy) as [K3 HK3]. exists (K1 + K2 + Rmax K3 0). assert (K30 := Rmax_r K3 0). split. lra.
    intros n i. assert (G0 : 0 <= exp (- y * lambda) ^ n) by (apply pow_le; left; apply exp_pos).
    assert (More : forall z k, z <= k * exp (- y * lambda) ^ n -> k <= K1 + K2 + Rmax K3 0 -> z <= (K1 + K2 + Rmax K3 0) * exp (- y * lambda) ^ n).
    { intros z k Hz Hk. eapply Rle_trans. apply Hz. apply Rmult_le_compat_r; auto. }
    split; [|split].
    + apply (More _ K3). apply HK3. generalize (Rmax_l K3 0). lra.
    + apply (More _ K1). apply HK1. lra.
    + intros c Hc. apply (More _ K2). destruct (HK2 n i) as [_ [_ HC2]]. apply HC2; auto. lra.
Qed.
End Limit.
End Levels.
