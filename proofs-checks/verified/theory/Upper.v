(* Upper bounds of the joint spectral radius, over the reals: polytopes, norms and quadratic forms on trees of words,
   transposed families, block triangular families. *)
Require Import Reals List ZArith Lia Lra Rgeom.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius.
Import ListNotations.
Open Scope R_scope.

(* ---- numbers --------------------------------------------------------------------------------------------------- *)

Lemma bernoulli h k : 0 <= h -> 1 + INR k * h <= (1 + h) ^ k.
Proof.
  intros Hh. induction k. simpl; lra.
  rewrite S_INR. simpl. assert (0 <= INR k) by apply pos_INR.
  assert (0 <= INR k * h) by (apply Rmult_le_pos; auto).
  assert (0 <= INR k * h * h) by (apply Rmult_le_pos; auto).
  apply Rle_trans with ((1 + h) * (1 + INR k * h)). nra. apply Rmult_le_compat_l; lra.
Qed.

Lemma pow_mult_distr x y k : (x * y) ^ k = x ^ k * y ^ k.
Proof. apply Rpow_mult_distr. Qed.

(* k r^(k-1) is bounded by a multiple of s^k for s > r. *)
Lemma linear_power r s : 0 < r < s -> exists C, 0 <= C /\ forall k, INR k * r ^ k <= C * s ^ k.
Proof.
  intros Hrs. set (h := s / r - 1).
  assert (Hh : 0 < h). { unfold h. assert (1 < s / r); [|lra]. apply (Rmult_lt_reg_r r). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  exists (/ h). split. left; apply Rinv_0_lt_compat; auto.
  intros k. replace s with ((1 + h) * r) at 1.
  2:{ unfold h. field. lra. }
  rewrite pow_mult_distr. assert (0 < r ^ k) by (apply pow_lt; lra).
  assert (B := bernoulli h k ltac:(lra)).
  apply Rmult_le_reg_l with h; auto.
  replace (h * (/ h * ((1 + h) ^ k * r ^ k))) with ((1 + h) ^ k * r ^ k) by (field; lra).
  replace (h * (INR k * r ^ k)) with (INR k * h * r ^ k) by lra.
  apply Rmult_le_compat_r; lra.
Qed.

Lemma exceeded x : exists m, x < INR m.
Proof.
  destruct (archimed x) as [H _]. destruct (Z_lt_le_dec (up x) 0) as [L|L].
  - exists 0%nat. simpl. apply IZR_lt in L. lra.
  - exists (Z.to_nat (up x)). rewrite INR_IZR_INZ, Z2Nat.id; auto.
Qed.

Lemma power_bound C x y : 0 <= y -> 0 <= x -> (forall m, x ^ m <= C * y ^ m) -> x <= y.
Proof.
  intros Hy Hx H. destruct (Rle_lt_dec x y) as [|L]; auto. exfalso.
  destruct (Req_dec y 0) as [->|Ny].
  - specialize (H 1%nat). simpl in H. lra.
  - set (h := x / y - 1).
    assert (Hh : 0 < h). { unfold h. assert (1 < x / y); [|lra]. apply (Rmult_lt_reg_r y). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
    destruct (exceeded (C / h)) as [m Hm].
    assert (C < INR m * h). { apply (Rmult_lt_reg_r (/ h)). apply Rinv_0_lt_compat; auto. rewrite Rmult_assoc, Rinv_r; lra. }
    specialize (H m). replace x with ((1 + h) * y) in H by (unfold h; field; lra).
    rewrite pow_mult_distr in H. assert (0 < y ^ m) by (apply pow_lt; lra).
    apply Rmult_le_reg_r in H; auto.
    assert (B := bernoulli h m ltac:(lra)).
    lra.
Qed.

(* ---- complex vectors as pairs ---------------------------------------------------------------------------------- *)

Definition modulus (a b : R) : R := sqrt (a * a + b * b).

Lemma modulus_nonneg a b : 0 <= modulus a b.
Proof. apply sqrt_pos. Qed.

Lemma modulus_triangle a b c d : modulus (a + c) (b + d) <= modulus a b + modulus c d.
Proof.
  assert (T := triangle (a + c) (b + d) 0 0 c d). unfold dist_euc, Rsqr in T. unfold modulus.
  replace ((a + c - 0) * (a + c - 0) + (b + d - 0) * (b + d - 0)) with ((a + c) * (a + c) + (b + d) * (b + d)) in T by ring.
  replace ((a + c - c) * (a + c - c) + (b + d - d) * (b + d - d)) with (a * a + b * b) in T by ring.
  replace ((c - 0) * (c - 0) + (d - 0) * (d - 0)) with (c * c + d * d) in T by ring. exact T.
Qed.

Lemma modulus_mult a b x y : modulus (a * x - b * y) (a * y + b * x) = modulus a b * modulus x y.
Proof. unfold modulus. rewrite <- sqrt_mult by nra. f_equal. ring. Qed.

Lemma modulus_real a : modulus a 0 = Rabs a.
Proof. unfold modulus. rewrite <- sqrt_Rsqr_abs. unfold Rsqr. f_equal. ring. Qed.

Lemma modulus_imaginary a : modulus 0 a = Rabs a.
Proof. unfold modulus. rewrite <- sqrt_Rsqr_abs. unfold Rsqr. f_equal. ring. Qed.

Definition cnorm (n : nat) (x y : vec) : R := sum n (fun i => modulus (x i) (y i)).

Lemma cnorm_real n x : cnorm n x zero = norm n x.
Proof. apply sum_ext; intros. apply modulus_real. Qed.

Lemma cnorm_imaginary n x : cnorm n zero x = norm n x.
Proof. apply sum_ext; intros. apply modulus_imaginary. Qed.

Lemma cnorm_nonneg n x y : 0 <= cnorm n x y.
Proof. apply sum_nonneg; intros; apply modulus_nonneg. Qed.

(* ---- polytopes ------------------------------------------------------------------------------------------------- *)

Section Polytope.
Variables (n count : nat) (T : nat -> mat) (Point : vec -> vec -> Prop).

(* The length of a point after a product. *)
Definition reach (w : list nat) (x y : vec) : R := cnorm n (run n T w x) (run n T w y).

(* x + i y is a combination of points with weights of sum at most a, and of units with weights of sum at most r; of
   that only this consequence is used. *)
Definition combination (x y : vec) (a r : R) : Prop :=
  forall w A B, letters count w -> 0 <= A -> 0 <= B -> (forall u v, Point u v -> reach w u v <= A) ->
  (forall k, (k < n)%nat -> reach w (unit k) zero <= B) -> reach w x y <= a * A + r * B.

Lemma reach_plus w x y u v : reach w (plus x u) (plus y v) <= reach w x y + reach w u v.
Proof.
  unfold reach, cnorm. rewrite !run_plus, <- sum_plus. apply sum_le; intros. apply modulus_triangle.
Qed.

Lemma reach_mult w a b x y :
  reach w (plus (scal a x) (scal (- b) y)) (plus (scal a y) (scal b x)) = modulus a b * reach w x y.
Proof.
  unfold reach, cnorm. rewrite !run_plus, !run_scal, <- sum_scal. apply sum_ext; intros.
  unfold plus, scal. rewrite <- modulus_mult. f_equal; ring.
Qed.

Lemma reach_scal w a x y : reach w (scal a x) (scal a y) = Rabs a * reach w x y.
Proof.
  rewrite <- modulus_real, <- reach_mult. unfold reach, cnorm. rewrite !run_plus, !run_scal.
  apply sum_ext; intros; unfold plus, scal; f_equal; ring.
Qed.

Lemma reach_units w B x y : (forall k, (k < n)%nat -> reach w (unit k) zero <= B) ->
  reach w x y <= (norm n x + norm n y) * B.
Proof.
  intros H.
  assert (Hx : forall z, norm n (run n T w z) <= norm n z * B).
  { intros z. rewrite Rmult_comm. apply run_bound. intros k Hk. specialize (H k Hk). unfold reach in H.
    rewrite run_zero, cnorm_real in H. auto. }
  replace x with (plus x zero) by (extensionality i; unfold plus, zero; lra).
  replace y with (plus zero y) by (extensionality i; unfold plus, zero; lra).
  eapply Rle_trans. apply reach_plus.
  unfold reach. rewrite !run_zero, cnorm_real, cnorm_imaginary.
  replace (plus x zero) with x by (extensionality i; unfold plus, zero; lra).
  replace (plus zero y) with y by (extensionality i; unfold plus, zero; lra).
  rewrite Rmult_plus_distr_r. apply Rplus_le_compat; auto.
Qed.

Lemma combination_zero : combination zero zero 0 0.
Proof.
  intros w A B _ _ _ _ _. unfold reach. rewrite run_zero, cnorm_real, norm_zero. lra.
Qed.

Lemma combination_alone x y : Point x y -> combination x y 1 0.
Proof. intros HP w A B Hw HA HB H1 H2. specialize (H1 x y HP). lra. Qed.

Lemma combination_plus x y u v a r b s : combination x y a r -> combination u v b s ->
  combination (plus x u) (plus y v) (a + b) (r + s).
Proof.
  intros H H' w A B Hw HA HB H1 H2. specialize (H w A B Hw HA HB H1 H2). specialize (H' w A B Hw HA HB H1 H2).
  eapply Rle_trans. apply reach_plus. lra.
Qed.

Lemma combination_mult a b x y s r : combination x y s r ->
  combination (plus (scal a x) (scal (- b) y)) (plus (scal a y) (scal b x)) (modulus a b * s) (modulus a b * r).
Proof.
  intros H w A B Hw HA HB H1 H2. specialize (H w A B Hw HA HB H1 H2). rewrite reach_mult. assert (M := modulus_nonneg a b).
  apply (Rmult_le_compat_l (modulus a b)) in H; auto. lra.
Qed.

Lemma combination_rest x y u v a r : combination x y a r ->
  combination (plus x u) (plus y v) a (r + (norm n u + norm n v)).
Proof.
  intros HC w A B Hw HA HB H1 H2. eapply Rle_trans. apply reach_plus.
  specialize (HC w A B Hw HA HB H1 H2). assert (U := reach_units w B u v H2). lra.
Qed.

Lemma combination_scal c x y a r : combination x y a r ->
  combination (scal c x) (scal c y) (Rabs c * a) (Rabs c * r).
Proof.
  intros HC w A B Hw HA HB H1 H2. rewrite reach_scal.
  specialize (HC w A B Hw HA HB H1 H2). assert (P := Rabs_pos c).
  apply (Rmult_le_compat_l (Rabs c)) in HC; auto. lra.
Qed.

Lemma combination_le x y a r a' r' : combination x y a r -> a <= a' -> r <= r' -> combination x y a' r'.
Proof.
  intros HC Ha Hr w A B Hw HA HB H1 H2. specialize (HC w A B Hw HA HB H1 H2).
  assert (a * A <= a' * A) by (apply Rmult_le_compat_r; auto).
  assert (r * B <= r' * B) by (apply Rmult_le_compat_r; auto). lra.
Qed.

(* With non-negative matrices a larger combination will do. *)
Lemma run_nonnegative : (forall t, (t < count)%nat -> forall i j, 0 <= T t i j) -> forall w x, letters count w ->
  (forall i, (i < n)%nat -> 0 <= x i) -> forall i, (i < n)%nat -> 0 <= run n T w x i.
Proof.
  intros HT. induction w; simpl; intros x Hw Hx i Hi; auto. inversion Hw; subst.
  apply sum_nonneg; intros. apply Rmult_le_pos; auto.
Qed.

Lemma combination_below x y a r : (forall t, (t < count)%nat -> forall i j, 0 <= T t i j) ->
  (forall i, (i < n)%nat -> 0 <= x i <= y i) -> combination y zero a r -> combination x zero a r.
Proof.
  intros HT Hxy HC w A B Hw HA HB H1 H2. eapply Rle_trans; [|apply (HC w A B); auto].
  unfold reach. rewrite run_zero, !cnorm_real. apply sum_le; intros i Hi.
  assert (Hx : 0 <= run n T w x i) by (apply run_nonnegative; auto; apply Hxy).
  assert (Hd : 0 <= run n T w (plus y (scal (-1) x)) i).
  { apply run_nonnegative; auto. intros j Hj. unfold plus, scal. specialize (Hxy j Hj). lra. }
  rewrite run_plus, run_scal in Hd. unfold plus, scal in Hd.
  rewrite !Rabs_pos_eq; lra.
Qed.

Lemma largest f m : exists b, 0 <= b /\ (forall k, (k < m)%nat -> f k <= b) /\ (b = 0 \/ exists k, (k < m)%nat /\ f k = b).
Proof.
  induction m. exists 0. split; [lra|]. split; auto. intros; lia.
  destruct IHm as [b [Hb [H1 H2]]]. destruct (Rle_lt_dec (f m) b).
  - exists b. split; auto. split. intros k Hk. destruct (Nat.eq_dec k m). subst; auto. apply H1; lia.
    destruct H2 as [->|[k [Hk E]]]; auto. right. exists k. split; auto.
  - exists (f m). split. lra. split. intros k Hk. destruct (Nat.eq_dec k m). subst; lra.
    assert (f k <= b) by (apply H1; lia). lra.
    right. exists m. split; auto.
Qed.

(* Theorem 6 of SPEC.md *)
Theorem polytope_bound A0 S R g : 0 <= A0 -> 0 <= S -> 0 <= R < 1 -> 0 <= g ->
  (forall x y, Point x y -> cnorm n x y <= A0) ->
  (forall k, (k < n)%nat -> combination (unit k) zero S R) ->
  (forall x y t, Point x y -> (t < count)%nat ->
     exists a r, combination (apply n (T t) x) (apply n (T t) y) a r /\ 0 <= r /\ a + r * (S / (1 - R)) <= g) ->
  grows_at_most n count T g.
Proof.
  intros HA HS HR Hg HP HU HI.
  set (E := S / (1 - R)).
  assert (HE : 0 <= E) by (apply Rmult_le_pos; [auto | left; apply Rinv_0_lt_compat; lra]).
  (* units after a product *)
  assert (Units : forall w A, letters count w -> 0 <= A -> (forall x y, Point x y -> reach w x y <= A) ->
    forall k, (k < n)%nat -> reach w (unit k) zero <= E * A).
  { intros w A Hw HA' H k Hk.
    destruct (largest (fun k => reach w (unit k) zero) n) as [b [Hb [H1 H2]]].
    eapply Rle_trans. apply H1; auto. destruct H2 as [->|[j [Hj Ej]]].
    - apply Rmult_le_pos; auto.
    - assert (D := HU j Hj w A b Hw HA' Hb H H1). simpl in Ej. rewrite Ej in D.
      unfold E. apply (Rmult_le_reg_r (1 - R)). lra.
      replace (S / (1 - R) * A * (1 - R)) with (S * A) by (field; lra). lra. }
  assert (Points : forall w, letters count w -> forall x y, Point x y -> reach w x y <= A0 * g ^ length w).
  { induction w using rev_ind; intros Hw u v HP'.
    - simpl. unfold reach; simpl. rewrite Rmult_1_r. auto.
    - apply letters_app in Hw. destruct Hw as [Hw Hx]. inversion Hx; subst.
      unfold reach. rewrite !run_app. simpl run.
      destruct (HI u v x HP' H1) as [a [r [HC [Hr Hg']]]].
      assert (HAk : 0 <= A0 * g ^ length w) by (apply Rmult_le_pos; auto; apply pow_le; auto).
      assert (HEA : 0 <= E * (A0 * g ^ length w)) by (apply Rmult_le_pos; auto).
      eapply Rle_trans. apply (HC w (A0 * g ^ length w) (E * (A0 * g ^ length w)) Hw HAk HEA (IHw Hw)).
      intros; apply Units; auto.
      rewrite app_length. simpl length. rewrite Nat.add_1_r. simpl pow.
      replace (a * (A0 * g ^ length w) + r * (E * (A0 * g ^ length w))) with ((a + r * E) * (A0 * g ^ length w)) by ring.
      replace (A0 * (g * g ^ length w)) with (g * (A0 * g ^ length w)) by ring.
      apply Rmult_le_compat_r; auto. }
  intros r Hr Hr0.
  apply (growth_norm n count T r (E * A0)). lra.
  intros w Hw x. apply run_bound. intros k Hk.
  assert (HAk : 0 <= A0 * g ^ length w) by (apply Rmult_le_pos; auto; apply pow_le; auto).
  assert (D := Units w (A0 * g ^ length w) Hw HAk (Points w Hw) k Hk). unfold reach in D. rewrite run_zero, cnorm_real in D.
  eapply Rle_trans. apply D. rewrite Rmult_assoc. apply Rmult_le_compat_l; auto. apply Rmult_le_compat_l; auto.
  apply pow_incr; lra.
Qed.

End Polytope.

(* ---- trees of words -------------------------------------------------------------------------------------------- *)

(* A node has one child for each letter, or it is a leaf; the leaves are words that cut every long word. *)
Inductive tree := Leaf | Node (children : list tree).

Section Trees.
Variables (n count states : nat) (T : nat -> mat) (N : nat -> vec -> R) (g : R).

(* A word leads from one of the norms to one of them. *)
Definition leads (i : nat) (w : list nat) : Prop :=
  w <> [] /\ exists j, (j < states)%nat /\ forall x, N i (run n T w x) <= g ^ length w * N j x.

Inductive good (i : nat) : list nat -> tree -> Prop :=
| good_leaf w : leads i w -> good i w Leaf
| good_node w children : length children = count ->
    (forall t child, nth_error children t = Some child -> good i (w ++ [t]) child) -> good i w (Node children).

(* Every word of at least this length begins with one that follows w in the tree. *)
Definition cuts (i : nat) (w : list nat) (depth : nat) : Prop := forall v, letters count v -> (depth <= length v)%nat ->
  exists a b, v = a ++ b /\ (length a <= depth)%nat /\ leads i (w ++ a).

Lemma cuts_le i w d e : cuts i w d -> (d <= e)%nat -> cuts i w e.
Proof.
  intros H L v Hv Hl. destruct (H v Hv ltac:(lia)) as [a [b [E [Ha Hc]]]].
  exists a, b. repeat split; try apply Hc; auto. lia.
Qed.

Lemma good_cuts i w tr : good i w tr -> exists depth, cuts i w depth.
Proof.
  revert w tr. fix IH 2. intros w tr Hg. destruct tr as [|children].
  - exists 0%nat. intros v _ _. inversion Hg; subst. exists [], v. rewrite app_nil_r. auto.
  - inversion Hg as [|w' c' Hl Hc]; subst.
    assert (D : forall off, (forall t child, nth_error children t = Some child -> good i (w ++ [(off + t)%nat]) child) ->
      exists depth, forall t, (t < length children)%nat -> cuts i (w ++ [(off + t)%nat]) depth).
    { clear Hc Hl Hg. revert children. fix IHc 1. intros children off Hc. destruct children as [|c cs].
      - exists 0%nat. intros t Ht. simpl in Ht. lia.
      - destruct (IH (w ++ [(off + 0)%nat]) c (Hc 0%nat c eq_refl)) as [d1 H1].
        destruct (IHc cs (S off)) as [d2 H2].
        { intros t child E. replace (S off + t)%nat with (off + S t)%nat by lia. apply Hc; auto. }
        exists (d1 + d2)%nat. intros [|t] Ht.
        + apply (cuts_le _ _ d1); auto. lia.
        + replace (off + S t)%nat with (S off + t)%nat by lia. apply (cuts_le _ _ d2); [apply H2|]; simpl in Ht; lia. }
    destruct (D 0%nat Hc) as [d H]. exists (S d). intros v Hv Hlen. destruct v as [|t v]; [simpl in Hlen; lia|].
    inversion Hv; subst.
    destruct (H t ltac:(lia) v) as [a [b [E1 [E2 E3]]]]; auto. simpl in Hlen; lia.
    exists (t :: a), b. subst. rewrite <- app_assoc in E3. repeat split; try apply E3. simpl; lia.
Qed.

(* From each norm long words are cut; one of the norms is bounded from below. *)
Variables (low high : R).
Theorem cuts_bound : 0 <= g -> 0 < low -> (0 < states)%nat -> (forall x, low * norm n x <= N 0%nat x) ->
  (forall i x, (i < states)%nat -> 0 <= N i x <= high * norm n x) ->
  (forall i, (i < states)%nat -> exists depth, cuts i [] depth) -> grows_at_most n count T g.
Proof.
  intros Hg Hlow HS HN1 HN2 Ht r Hr Hr0.
  assert (D : exists depth, forall i, (i < states)%nat -> cuts i [] depth).
  { clear HN2 HS. revert Ht. generalize states at 1 2 as m. induction m; intros Ht. exists 0%nat. intros; lia.
    destruct IHm as [d H]. intros; apply Ht; lia. destruct (Ht m ltac:(lia)) as [e Hm].
    exists (d + e)%nat. intros i Hi. destruct (Nat.eq_dec i m) as [->|]. apply (cuts_le _ _ e); auto; lia.
    apply (cuts_le _ _ d); [apply H|]; lia. }
  destruct D as [depth H].
  destruct (word_bound n count T) as [K [HK HW]].
  set (m := Rmin 1 r).
  assert (Hm : 0 < m) by (unfold m; apply Rmin_glb_lt; lra).
  assert (Hm1 : m <= 1) by apply Rmin_l. assert (Hmr : m <= r) by apply Rmin_r.
  assert (Hmd : 0 < m ^ depth) by (apply pow_lt; auto).
  assert (HKd : 0 < K ^ depth) by (apply pow_lt; lra).
  set (h := Rmax high 0).
  assert (Hh : 0 <= h) by apply Rmax_r.
  assert (HN2' : forall i x, (i < states)%nat -> N i x <= h * norm n x).
  { intros i x Hi. eapply Rle_trans. apply HN2; auto. apply Rmult_le_compat_r. apply norm_nonneg. apply Rmax_l. }
  set (C := h * (K ^ depth * / m ^ depth)).
  assert (HC : forall len i v, (i < states)%nat -> (length v <= len)%nat -> letters count v ->
    forall x, N i (run n T v x) <= C * r ^ length v * norm n x).
  { induction len.
    - intros i v Hi Hl Hv x. destruct v; [|simpl in Hl; lia]. simpl. rewrite Rmult_1_r.
      eapply Rle_trans. apply HN2'; auto. apply Rmult_le_compat_r. apply norm_nonneg. unfold C.
      rewrite <- (Rmult_1_r h) at 1. apply Rmult_le_compat_l; auto.
      apply (Rmult_le_reg_r (m ^ depth)); auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_l, Rmult_1_r by lra.
      apply Rle_trans with 1. rewrite <- (pow1 depth). apply pow_incr; lra. apply pow_R1_Rle; auto.
    - intros i v Hi Hl Hv x. destruct (le_lt_dec depth (length v)) as [Hd|Hd].
      + destruct (H i Hi v Hv Hd) as [a [b [E [_ [Ha [j [Hj Hb]]]]]]]. simpl in Ha, Hb. subst v.
        apply letters_app in Hv. destruct Hv as [Hva Hvb].
        rewrite run_app. eapply Rle_trans. apply Hb. rewrite app_length, pow_add.
        assert (Hrec : N j (run n T b x) <= C * r ^ length b * norm n x).
        { apply IHlen; auto. rewrite app_length in Hl. destruct a; [congruence|simpl in Hl; lia]. }
        assert (g ^ length a <= r ^ length a) by (apply pow_incr; lra).
        assert (0 <= g ^ length a) by (apply pow_le; auto).
        assert (0 <= N j (run n T b x)) by (apply HN2; auto).
        apply Rle_trans with (r ^ length a * (C * r ^ length b * norm n x)); [|right; ring].
        apply Rmult_le_compat; auto.
      + eapply Rle_trans. apply HN2'; auto. eapply Rle_trans. apply Rmult_le_compat_l; [apply Hh | apply HW; apply Hv].
        rewrite <- Rmult_assoc. apply Rmult_le_compat_r. apply norm_nonneg.
        unfold C. rewrite Rmult_assoc. apply Rmult_le_compat_l; auto.
        apply Rle_trans with (K ^ depth * 1).
        * rewrite Rmult_1_r. apply Rle_pow; auto. lia.
        * rewrite Rmult_assoc. apply Rmult_le_compat_l. lra.
          apply (Rmult_le_reg_l (m ^ depth)); auto. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l, Rmult_1_r by lra.
          apply Rle_trans with (m ^ length v).
          -- replace depth with (length v + (depth - length v))%nat by lia. rewrite pow_add.
             assert (0 < m ^ length v) by (apply pow_lt; auto).
             assert (m ^ (depth - length v) <= 1) by (rewrite <- (pow1 (depth - length v)); apply pow_incr; lra).
             rewrite <- (Rmult_1_r (m ^ length v)) at 2. apply Rmult_le_compat_l; lra.
          -- apply pow_incr; lra. }
  apply (growth_norm n count T r (/ low * C)). lra.
  intros w Hw x. apply (Rmult_le_reg_l low); auto.
  eapply Rle_trans. apply HN1. eapply Rle_trans. apply (HC (length w) 0%nat); auto.
  right. field. lra.
Qed.
End Trees.
