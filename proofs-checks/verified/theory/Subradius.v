(* The joint spectral subradius of finitely many real matrices, from first principles; and the checker of bounds of that of
   a family without negative entries: Theorem 31 of SPEC.md. *)
Require Import Reals List ZArith QArith FMapPositive Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Coq Require ClassicalDedekindReals.
From Subcert Require Import Radius Upper Existence Blocks Integers Sections Check.
Import ListNotations.
Open Scope R_scope.

(* ---- definitions: what the theorems are about ------------------------------------------------------------------ *)

(* For each k all entries of some product of k matrices are at most a constant times r^k. *)
Definition slow (n count : nat) (T : nat -> mat) (r : R) : Prop :=
  exists C, forall k, exists w, letters count w /\ length w = k /\
  forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (product n T w i j) <= C * r ^ k.

(* The joint spectral subradius is the infimum of these r: the limit of m_k^(1/k), m_k the smallest norm of a product of k
   matrices. It is one number (subradius_unique below) and exists for every family of one matrix or more (subradius_exists).
   m_k is at most C r^k for each r above it, and at least its power (subradius_power). *)
Definition is_subradius (n count : nat) (T : nat -> mat) (x : R) : Prop :=
  0 <= x /\ (forall r, x < r -> slow n count T r) /\ (forall r, 0 <= r -> slow n count T r -> x <= r).

Definition subradius_at_most n count T u := forall r, u < r -> slow n count T r.
Definition subradius_at_least n count T l := forall r, 0 <= r -> slow n count T r -> l <= r.

(* ---- the subradius is one number ------------------------------------------------------------------------------- *)

Lemma slow_norm n count T r C :
  (forall k, exists w, letters count w /\ length w = k /\ forall x, norm n (run n T w x) <= C * r ^ k * norm n x) ->
  slow n count T r.
Proof.
  intros H. exists C. intros k. destruct (H k) as [w [Hw [Hl B]]]. exists w. split; auto. split; auto. intros i j Hi Hj.
  rewrite <- run_unit by auto. eapply Rle_trans. apply (norm_term n); auto.
  eapply Rle_trans. apply B. rewrite norm_unit by auto. lra.
Qed.

Lemma norm_slow n count T r : 0 <= r -> slow n count T r ->
  exists C, 0 <= C /\ forall k, exists w, letters count w /\ length w = k /\ forall x, norm n (run n T w x) <= C * r ^ k * norm n x.
Proof.
  intros Hr [C H]. exists (INR n * Rmax C 0).
  assert (HC : 0 <= Rmax C 0) by apply Rmax_r.
  split. apply Rmult_le_pos; auto. apply pos_INR.
  intros k. destruct (H k) as [w [Hw [Hl B]]]. exists w. split; auto. split; auto.
  intros x. apply run_bound. intros j Hj. unfold norm. rewrite Rmult_assoc. apply sum_bound; intros i Hi.
  rewrite run_unit by auto. eapply Rle_trans. apply B; auto.
  apply Rmult_le_compat_r. apply pow_le; auto. apply Rmax_l.
Qed.

Lemma slow_mono n count T r s : 0 <= r <= s -> slow n count T r -> slow n count T s.
Proof.
  intros Hrs G. destruct (norm_slow n count T r ltac:(lra) G) as [C [HC H]].
  apply (slow_norm n count T s C). intros k. destruct (H k) as [w [Hw [Hl B]]]. exists w. split; auto. split; auto.
  intros x. eapply Rle_trans. apply B. apply Rmult_le_compat_r. apply norm_nonneg.
  apply Rmult_le_compat_l; auto. apply pow_incr; lra.
Qed.

Lemma subradius_most n count T u x : subradius_at_most n count T u -> 0 <= u -> is_subradius n count T x -> x <= u.
Proof.
  intros H Hu [Hx [_ L]]. destruct (Rle_lt_dec x u) as [|D]; auto.
  assert (x <= (x + u) / 2); [|lra]. apply L. lra. apply H; lra.
Qed.

Lemma subradius_least n count T l x : subradius_at_least n count T l -> is_subradius n count T x -> l <= x.
Proof.
  intros H [Hx [U _]]. destruct (Rle_lt_dec l x) as [|D]; auto.
  assert (l <= (x + l) / 2); [|lra]. apply H. lra. apply U. lra.
Qed.

Theorem subradius_unique n count T x y : is_subradius n count T x -> is_subradius n count T y -> x = y.
Proof.
  intros Hx Hy. assert (Hx' := Hx). assert (Hy' := Hy). destruct Hx' as [X [Ux _]]. destruct Hy' as [Y [Uy _]].
  apply Rle_antisym; [apply (subradius_most n count T y x) | apply (subradius_most n count T x y)]; auto.
Qed.

(* ---- a word that is repeated ----------------------------------------------------------------------------------- *)

Fixpoint again (v : list nat) (q : nat) : list nat := match q with O => [] | S p => v ++ again v p end.

Lemma again_letters count v q : letters count v -> letters count (again v q).
Proof. intros H. induction q; simpl. constructor. apply letters_app; auto. Qed.

Lemma again_length v q : length (again v q) = (q * length v)%nat.
Proof. induction q; simpl; auto. rewrite app_length, IHq. auto. Qed.

(* A prefix after it makes words of all lengths. *)
Lemma again_slow n count T v C b r : letters count v -> v <> [] -> 0 <= C -> 0 < r -> 0 <= b <= r ^ length v ->
  (forall q x, norm n (run n T (again v q) x) <= C * b ^ q * norm n x) -> slow n count T r.
Proof.
  intros Hv Nv HC Hr Hb H. destruct (word_bound n count T) as [K [HK HB]].
  set (L := length v) in *. assert (HL : (0 < L)%nat). { unfold L. destruct v; [congruence|simpl; lia]. }
  set (m := Rmax 1 (/ r)). assert (M1 : 1 <= m) by apply Rmax_l.
  assert (Mr : 1 <= m * r).
  { rewrite <- (Rinv_l r) by lra. apply Rmult_le_compat_r. lra. apply Rmax_r. }
  apply (slow_norm n count T r (C * (K * m) ^ L)).
  intros k. set (q := (k / L)%nat). set (j := (k mod L)%nat).
  assert (Ek : k = (L * q + j)%nat) by (apply Nat.div_mod; lia).
  assert (Hj : (j < L)%nat) by (apply Nat.mod_upper_bound; lia).
  assert (Lj : length (firstn j v) = j) by (apply firstn_length_le; fold L; lia).
  assert (Hf : letters count (firstn j v)). { rewrite <- (firstn_skipn j v) in Hv. apply letters_app in Hv. apply Hv. }
  exists (again v q ++ firstn j v). split; [|split].
  - apply letters_app. split; auto. apply again_letters; auto.
  - rewrite app_length, again_length, Lj. fold L. lia.
  - intros x. rewrite run_app. eapply Rle_trans. apply H.
    assert (B := HB (firstn j v) Hf x). rewrite Lj in B.
    assert (N := norm_nonneg n (run n T (firstn j v) x)). assert (X := norm_nonneg n x).
    assert (P : 0 <= (r ^ L) ^ q) by (apply pow_le, pow_le; lra).
    assert (Bq : b ^ q <= (r ^ L) ^ q) by (apply pow_incr; auto).
    assert (KM : 1 <= K * m) by nra.
    assert (S1 : K ^ j <= (K * m) ^ j * r ^ j). { rewrite <- Rpow_mult_distr. apply pow_incr. nra. }
    assert (S2 : (K * m) ^ j <= (K * m) ^ L) by (apply Rle_pow; [auto|lia]).
    assert (S3 : 0 <= r ^ j) by (apply pow_le; lra).
    apply Rle_trans with (C * (r ^ L) ^ q * (K ^ j * norm n x)).
    + apply Rmult_le_compat; auto. apply Rmult_le_pos; auto. apply pow_le; lra. apply Rmult_le_compat_l; auto.
    + rewrite Ek, pow_add, pow_mult.
      replace (C * (r ^ L) ^ q * (K ^ j * norm n x)) with (C * norm n x * (r ^ L) ^ q * K ^ j) by ring.
      replace (C * (K * m) ^ L * ((r ^ L) ^ q * r ^ j) * norm n x) with (C * norm n x * (r ^ L) ^ q * ((K * m) ^ L * r ^ j)) by ring.
      apply Rmult_le_compat_l. repeat apply Rmult_le_pos; auto.
      eapply Rle_trans. apply S1. apply Rmult_le_compat_r; auto.
Qed.

Lemma word_slow n count T v b r : letters count v -> v <> [] -> 0 < r -> 0 <= b <= r ^ length v ->
  (forall k, (k < n)%nat -> norm n (run n T v (unit k)) <= b) -> slow n count T r.
Proof.
  intros Hv Nv Hr Hb H. apply (again_slow n count T v 1 b r); auto. lra.
  induction q; intros x; simpl. lra.
  rewrite run_app. eapply Rle_trans. apply run_bound, H.
  replace (1 * (b * b ^ q) * norm n x) with (b * (1 * b ^ q * norm n x)) by ring. apply Rmult_le_compat_l. lra. auto.
Qed.

Lemma bernoulli_below h k : 0 <= h <= 1 -> 1 - INR k * h <= (1 - h) ^ k.
Proof.
  intros Hh. induction k. simpl; lra.
  rewrite S_INR. simpl. assert (0 <= INR k) by apply pos_INR. assert (0 <= INR k * h * h) by (repeat apply Rmult_le_pos; lra).
  apply Rle_trans with ((1 - h) * (1 - INR k * h)). nra. apply Rmult_le_compat_l; lra.
Qed.

(* No product has a norm below the power of the subradius. *)
Theorem subradius_power n count T x w b : is_subradius n count T x -> letters count w -> w <> [] -> 0 <= b ->
  (forall k, (k < n)%nat -> norm n (run n T w (unit k)) <= b) -> x ^ length w <= b.
Proof.
  intros [Hx [_ Least]] Hw Nw Hb H. set (L := length w). destruct (Rle_lt_dec (x ^ L) b) as [|D]; auto. exfalso.
  assert (HL : (0 < L)%nat). { unfold L. destruct w; [congruence|simpl; lia]. }
  assert (X : 0 < x). { destruct Hx as [|<-]; auto. rewrite pow_i in D by auto. lra. }
  assert (P : 0 < x ^ L) by (apply pow_lt; auto).
  assert (I : 1 <= INR L) by (apply (le_INR 1); lia).
  set (d := 1 - b / x ^ L).
  assert (Hd : 0 < d <= 1).
  { unfold d. assert (0 <= b / x ^ L) by (apply Rmult_le_pos; auto; left; apply Rinv_0_lt_compat; auto).
    assert (b / x ^ L < 1); [|lra]. apply (Rmult_lt_reg_r (x ^ L)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  set (h := d / (INR L + 1)).
  assert (Eh : h * (INR L + 1) = d) by (unfold h; field; lra).
  assert (Hh : 0 < h < 1) by (split; [apply Rdiv_lt_0_compat; lra | nra]).
  assert (B := bernoulli_below h L ltac:(lra)).
  assert (x <= x * (1 - h)); [|nra]. apply Least. nra.
  apply (word_slow n count T w b); auto. nra. split; auto. fold L. rewrite Rpow_mult_distr.
  replace b with (x ^ L * (1 - d)) by (unfold d; field; lra). apply Rmult_le_compat_l. lra. nra.
Qed.

(* ---- it exists ------------------------------------------------------------------------------------------------- *)

Section Existence.
Variables (n count : nat) (T : nat -> mat).
Hypothesis Count : (0 < count)%nat.

Fixpoint words (k : nat) : list (list nat) :=
  match k with O => [[]] | S j => flat_map (fun t => map (cons t) (words j)) (seq 0 count) end.

Lemma in_words k : forall w, In w (words k) <-> letters count w /\ length w = k.
Proof.
  induction k; intros w; simpl.
  - split. intros [<-|[]]. split; auto. constructor. intros [_ E]. left. destruct w; auto. discriminate.
  - rewrite in_flat_map. split.
    + intros [t [Ht I]]. apply in_seq in Ht. apply in_map_iff in I. destruct I as [v [<- I]]. apply IHk in I. destruct I as [Hv Hl].
      split. constructor; auto. lia. simpl; auto.
    + intros [Hw Hl]. destruct w as [|t v]; [discriminate|]. inversion Hw; subst. exists t. split. apply in_seq; lia.
      apply in_map. apply IHk. split; auto.
Qed.

Let columns_norm (w : list nat) : R := sum n (fun k => norm n (run n T w (unit k))).

(* Decidable as comparisons of real numbers are. *)
Lemma some_word g : {k | exists w, In w (words (S k)) /\ columns_norm w < g ^ S k} +
  {forall k w, In w (words (S k)) -> g ^ S k <= columns_norm w}.
Proof.
  assert (Dec : forall k w, {g ^ S k <= columns_norm w} + {~ g ^ S k <= columns_norm w}) by (intros; apply Rle_dec).
  destruct (ClassicalDedekindReals.sig_forall_dec (fun k => Forall (fun w => g ^ S k <= columns_norm w) (words (S k)))) as [[k H]|H].
  - intros k. apply Forall_dec. apply Dec.
  - left. exists k. destruct (Forall_Exists_dec _ (Dec k) (words (S k))) as [A|E]; [contradiction|].
    apply Exists_exists in E. destruct E as [w [I N]]. exists w. split; auto. lra.
  - right. intros k w I. specialize (H k). rewrite Forall_forall in H. auto.
Qed.

Theorem subradius_exists : exists x, is_subradius n count T x.
Proof.
  assert (A : exists K, 1 <= K /\ slow n count T K).
  { destruct (word_bound n count T) as [K [HK H]]. exists K. split; auto. apply (slow_norm n count T K 1).
    intros k. exists (repeat 0%nat k).
    assert (Hw : letters count (repeat 0%nat k)).
    { unfold letters. rewrite Forall_forall. intros t I. apply repeat_spec in I. subst; auto. }
    split; auto. split. apply repeat_length. intros x. assert (B := H _ Hw x). rewrite repeat_length in B. lra. }
  destruct A as [K [HK AK]].
  destruct (completeness (fun y => exists s, y = - s /\ 0 <= s /\ slow n count T s)) as [y [Hub Hlub]].
  - exists 0. intros y [s [-> [Hs _]]]. lra.
  - exists (- K), K. split; auto. split; auto. lra.
  - exists (- y). assert (Hy : y <= 0). { apply Hlub. intros z [s [-> [Hs _]]]. lra. }
    split. lra. split.
    + intros r Hr. set (g := (r - y) / 2).
      destruct (some_word g) as [[k [w [I Hk]]]|N].
      * apply in_words in I. destruct I as [Hw Hl].
        assert (P : 0 <= columns_norm w) by (apply sum_nonneg; intros; apply norm_nonneg).
        apply (slow_mono n count T g). unfold g; lra.
        apply (word_slow n count T w (columns_norm w)); auto. intros ->; discriminate. unfold g; lra.
        rewrite Hl. lra. intros j Hj. apply (sum_term n (fun k => norm n (run n T w (unit k)))); auto. intros; apply norm_nonneg.
      * exfalso. assert (y <= - g); [|unfold g in *; lra]. apply Hlub. intros z [s [-> [Hs G]]].
        destruct (norm_slow n count T s Hs G) as [C [HC H]].
        assert (g <= s); [|lra]. apply (power_bound (INR n * C + 1)); auto. unfold g; lra.
        assert (I := pos_INR n). assert (0 <= INR n * C) by (apply Rmult_le_pos; auto).
        intros m. destruct m. simpl; lra. destruct (H (S m)) as [w [Hw [Hl B]]].
        eapply Rle_trans. apply (N m w). apply in_words; auto.
        assert (0 <= s ^ S m) by (apply pow_le; auto).
        replace ((INR n * C + 1) * s ^ S m) with (INR n * (C * s ^ S m) + s ^ S m) by ring.
        apply Rle_trans with (INR n * (C * s ^ S m)); [|lra].
        apply sum_bound; intros j Hj. eapply Rle_trans. apply B. rewrite norm_unit by auto. lra.
    + intros r Hr G. assert (- r <= y); [|lra]. apply Hub. exists r. auto.
Qed.
End Existence.

(* ---- families that differ in nothing that matters -------------------------------------------------------------- *)

Lemma slow_ext n count T T' r : (forall t i j, (t < count)%nat -> (i < n)%nat -> (j < n)%nat -> T t i j = T' t i j) ->
  slow n count T r -> slow n count T' r.
Proof.
  intros H [C G]. exists C. intros k. destruct (G k) as [w [Hw [Hl B]]]. exists w. split; auto. split; auto.
  intros i j Hi Hj. rewrite <- (product_ext n count T T') by auto. auto.
Qed.

Lemma slow_transposed n count T r : slow n count T r -> slow n count (transposed T) r.
Proof.
  intros [C G]. exists C. intros k. destruct (G k) as [w [Hw [Hl B]]]. exists (rev w). split. apply letters_rev; auto.
  split. rewrite rev_length; auto. intros i j Hi Hj. rewrite product_transposed by auto. auto.
Qed.

(* ---- Theorem 31 of SPEC.md ------------------------------------------------------------------------------------- *)

Section Nonnegative.
Variables (n count : nat) (T : nat -> mat).
Hypothesis Entries : forall t, (t < count)%nat -> forall i j, 0 <= T t i j.

Lemma run_monotone w x y : letters count w -> (forall i, (i < n)%nat -> x i <= y i) ->
  forall i, (i < n)%nat -> run n T w x i <= run n T w y i.
Proof.
  intros Hw H i Hi. assert (D : 0 <= run n T w (plus y (scal (-1) x)) i).
  { apply (run_nonnegative n count T); auto. intros j Hj. unfold plus, scal. specialize (H j Hj). lra. }
  rewrite run_plus, run_scal in D. unfold plus, scal in D. lra.
Qed.

(* Upper end: a product that makes a positive vector at most b times as long. *)
Theorem slow_product_bound v X b u : letters count v -> v <> [] -> (forall i, (i < n)%nat -> 1 <= X i) -> 0 <= b ->
  (forall i, (i < n)%nat -> run n T v X i <= b * X i) -> 0 <= u -> b <= u ^ length v -> subradius_at_most n count T u.
Proof.
  intros Hv Nv HX Hb H Hu Hbu r Hr.
  assert (Q : forall q i, (i < n)%nat -> run n T (again v q) X i <= b ^ q * X i).
  { induction q; intros i Hi; simpl. lra.
    rewrite run_app. eapply Rle_trans. apply (run_monotone v _ (scal (b ^ q) X)); auto.
    rewrite run_scal. unfold scal. replace (b * b ^ q * X i) with (b ^ q * (b * X i)) by ring.
    apply Rmult_le_compat_l. apply pow_le; auto. auto. }
  apply (again_slow n count T v (norm n X) b r); auto. apply norm_nonneg. lra.
  - split; auto. eapply Rle_trans. apply Hbu. apply pow_incr; lra.
  - intros q x. apply run_bound. intros k Hk. unfold norm. rewrite Rmult_comm, <- sum_scal. apply sum_le; intros i Hi.
    assert (Hw := again_letters count v q Hv).
    assert (U : forall j, (j < n)%nat -> 0 <= unit k j <= X j).
    { intros j Hj. specialize (HX j Hj). unfold unit, identity. destruct (Nat.eqb j k); lra. }
    rewrite Rabs_pos_eq by (apply (run_nonnegative n count T); auto; apply U).
    eapply Rle_trans. apply (run_monotone _ _ X); auto. apply U.
    eapply Rle_trans. apply Q; auto. apply Rmult_le_compat_l. apply pow_le; auto. apply Rle_abs.
Qed.

(* Lower end: points with images that are above combinations of points with weights of sum g at least; of that only this
   consequence is used. *)
Theorem growing_bound (Point : vec -> Prop) v0 g : 0 <= g -> Point v0 -> (forall v, Point v -> 1 <= sum n v) ->
  (forall v t w c, Point v -> (t < count)%nat -> letters count w -> 0 <= c ->
     (forall p, Point p -> c <= sum n (run n T w p)) -> g * c <= sum n (run n T w (apply n (T t) v))) ->
  subradius_at_least n count T g.
Proof.
  intros Hg P0 P1 H r Hr G.
  assert (Grow : forall w, letters count w -> forall v, Point v -> g ^ length w <= sum n (run n T w v)).
  { induction w as [|t w IH] using rev_ind; intros Hw v Hv. simpl; auto.
    apply letters_app in Hw. destruct Hw as [Hw Ht]. inversion Ht; subst.
    rewrite app_length, run_app. simpl length. rewrite Nat.add_1_r. simpl. apply H; auto. apply pow_le; auto. }
  destruct (norm_slow n count T r Hr G) as [C [HC B]].
  apply (power_bound (C * norm n v0)); auto. intros m. destruct (B m) as [w [Hw [Hl D]]].
  subst m. eapply Rle_trans. apply (Grow w Hw v0 P0).
  apply Rle_trans with (norm n (run n T w v0)). apply sum_le. intros i Hi. apply Rle_abs.
  eapply Rle_trans. apply D. lra.
Qed.
End Nonnegative.

(* ---- the checker ----------------------------------------------------------------------------------------------- *)
Open Scope Z_scope.

(* N X <= factor X for a product N. *)
Record slow_product := SlowProduct { slow_word : list nat; slow_factor : Q; slow_weights : zvec }.

(* Vertices, and for each of them and each matrix the terms of a combination; their weights are over `climb_scale`. *)
Record climb := Climb {
  climb_transposed : bool; climb_scale : Z; climb_points : list point; climb_terms : list (list (list term)) }.

Record subradius_certificate := SubradiusCertificate { upper_product : option slow_product; lower_climb : option climb }.

Definition check_product (F : family) (p : slow_product) : bool :=
  forallb (fun t => Nat.ltb t (count F)) (slow_word p) && Nat.ltb 0 (length (slow_word p)) &&
  Nat.eqb (length (slow_weights p)) (size F) && forallb (Z.leb 1) (slow_weights p) && (0 <=? Qnum (slow_factor p)) &&
  vector_nonnegative
    (addmul (- Zpos (Qden (slow_factor p))) (zrun (matrices F) (slow_word p) (slow_weights p))
       (addmul (Qnum (slow_factor p) * denominator F ^ Z.of_nat (length (slow_word p))) (slow_weights p) [])).

Definition factor_below (u : Q) (p : slow_product) : bool :=
  let L := Z.of_nat (length (slow_word p)) in
  (0 <=? Qnum u) && (Qnum (slow_factor p) * Zpos (Qden u) ^ L <=? Qnum u ^ L * Zpos (Qden (slow_factor p))).

Definition positive_terms : list term -> bool := forallb (fun t => (0 <=? fst (snd t)) && (snd (snd t) =? 0)).

(* The image of x is above the combination, and the sum of the weights is l at least. *)
Definition image_above (F : family) (ps : points) (scale : Z) (l : Q) (x : zvec) (M : zmat) (ts : list term) : bool :=
  match combine ps ts with
  | None => false
  | Some (w, (y, _)) =>
      positive_terms ts && vector_nonnegative (addmul (- denominator F) y (addmul scale (mv M x) [])) &&
      (Qnum l * scale <=? w * Zpos (Qden l))
  end.

(* Each of these with its line *)
Fixpoint paired {A B : Type} (check : A -> B -> bool) (xs : list A) (ys : list B) : bool :=
  match xs, ys with
  | [], _ => true
  | x :: xs', y :: ys' => check x y && paired check xs' ys'
  | _, [] => false
  end.

Definition check_climb (F : family) (l : Q) (c : climb) : bool :=
  let all := climb_points c in
  let ps := number 1 all in
  (0 <? climb_scale c) && all_nonnegative F all && Nat.ltb 0 (length all) &&
  forallb (fun p => (length (fst p) <=? size F)%nat && (0 <? norm1 (fst p))) all &&
  paired (fun p => paired (image_above F ps (climb_scale c) l (fst p)) (matrices F)) all (climb_terms c).

Definition check_subradius (c : claim) (cert : subradius_certificate) : bool :=
  let F := matrices_of c in
  well_formed F && all_nonnegative F [] &&
  match upper c with
  | None => true
  | Some u => match upper_product cert with None => false | Some p => check_product F p && factor_below u p end
  end &&
  match lower c with
  | None => true
  | Some l =>
      (Qnum l <=? 0) ||
      match lower_climb cert with
      | None => false
      | Some d => check_climb (if climb_transposed d then transpose F else F) l d
      end
  end.

Definition subradius_claim_holds (c : claim) : Prop :=
  forall x, is_subradius (size (matrices_of c)) (count (matrices_of c)) (real (matrices_of c)) x ->
  (forall l, lower c = Some l -> (real_of l <= x)%R) /\ (forall u, upper c = Some u -> (x <= real_of u)%R).

(* ---- why that proves the claim --------------------------------------------------------------------------------- *)

Lemma real_of_nonneg u : 0 <= Qnum u -> (0 <= real_of u)%R.
Proof. intros H. apply Rmult_le_pos. apply IZR_le; auto. left; apply Rinv_0_lt_compat, IZR_lt; lia. Qed.

Lemma vector_nonnegative_vr x i : vector_nonnegative x = true -> (0 <= vr x i)%R.
Proof. intros H. apply IZR_le, vector_nonnegative_nth; auto. Qed.

Lemma paired_spec {A B} (check : A -> B -> bool) xs : forall ys, paired check xs ys = true ->
  forall x, In x xs -> exists y, check x y = true.
Proof.
  induction xs as [|a xs IH]; intros ys H x I. destruct I. destruct ys as [|b ys]; [discriminate|].
  simpl in H. apply andb_prop in H. destruct H as [H1 H2]. destruct I as [<-|I]; eauto.
Qed.

Theorem check_product_sound F p u : well_formed F = true -> all_nonnegative F [] = true ->
  check_product F p = true -> factor_below u p = true -> subradius_at_most (size F) (count F) (real F) (real_of u).
Proof.
  intros WF NF H HU. unfold check_product in H. repeat rewrite andb_true_iff in H. destruct H as [[[[[H1 H2] H3] H4] H5] H6].
  rewrite forallb_forall in H1. apply Nat.ltb_lt in H2. apply Nat.eqb_eq in H3. rewrite forallb_forall in H4. apply Z.leb_le in H5.
  unfold factor_below in HU. cbv zeta in HU. apply andb_prop in HU. destruct HU as [U1 U2]. apply Z.leb_le in U1, U2.
  set (w := slow_word p) in *. set (X := slow_weights p) in *. set (f := slow_factor p) in *.
  assert (D := denominator_positive F WF).
  assert (Hw : letters (count F) w). { unfold letters. rewrite Forall_forall. intros t I. apply Nat.ltb_lt; auto. }
  assert (Qf : (0 < IZR (Zpos (Qden f)))%R) by (apply IZR_lt; lia). assert (Qu : (0 < IZR (Zpos (Qden u)))%R) by (apply IZR_lt; lia).
  assert (DL : (0 < IZR (denominator F) ^ length w)%R) by (apply pow_lt; auto).
  apply (slow_product_bound (size F) (count F) (real F) (all_nonnegative_matrices F WF [] NF) w (vr X) (real_of f)); auto.
  - intros E. rewrite E in H2. simpl in H2. lia.
  - intros i Hi. unfold vr. apply IZR_le. assert (L := H4 (nth i X 0) ltac:(apply nth_In; lia)). lia.
  - apply real_of_nonneg; auto.
  - intros i Hi. apply (vector_nonnegative_vr _ i) in H6. rewrite !vr_addmul, vr_nil, vr_zrun in H6 by auto.
    unfold plus, scal, zero in H6. rewrite opp_IZR, mult_IZR, <- pow_IZR in H6.
    unfold real_of. apply (Rmult_le_reg_l (IZR (Zpos (Qden f)) * IZR (denominator F) ^ length w)). apply Rmult_lt_0_compat; auto.
    replace (IZR (Zpos (Qden f)) * IZR (denominator F) ^ length w * (IZR (Qnum f) / IZR (Zpos (Qden f)) * vr X i))%R
      with (IZR (Qnum f) * IZR (denominator F) ^ length w * vr X i)%R by (field; lra).
    lra.
  - apply real_of_nonneg; auto.
  - apply IZR_le in U2. rewrite !mult_IZR, <- !pow_IZR in U2. unfold real_of, Rdiv. rewrite Rpow_mult_distr, pow_inv by lra.
    assert (QL : (0 < IZR (Zpos (Qden u)) ^ length w)%R) by (apply pow_lt; auto).
    apply (Rmult_le_reg_r (IZR (Zpos (Qden f)) * IZR (Zpos (Qden u)) ^ length w)). apply Rmult_lt_0_compat; auto.
    replace (IZR (Qnum f) * / IZR (Zpos (Qden f)) * (IZR (Zpos (Qden f)) * IZR (Zpos (Qden u)) ^ length w))%R
      with (IZR (Qnum f) * IZR (Zpos (Qden u)) ^ length w)%R by (field; lra).
    replace (IZR (Qnum u) ^ length w * / IZR (Zpos (Qden u)) ^ length w * (IZR (Zpos (Qden f)) * IZR (Zpos (Qden u)) ^ length w))%R
      with (IZR (Qnum u) ^ length w * IZR (Zpos (Qden f)))%R by (field; lra).
    auto.
Qed.

(* A linear form that is c at least at the points is c times the weights at least at a combination. *)
Lemma combine_above n T w (ps : points) c : (0 <= c)%R ->
  (forall i p, PositiveMap.find i ps = Some p -> (c <= sum n (run n T w (vr (fst p))))%R) ->
  forall ts s x y, positive_terms ts = true -> combine ps ts = Some (s, (x, y)) -> (IZR s * c <= sum n (run n T w (vr x)))%R.
Proof.
  intros Hc HP. induction ts as [|[i [a b]] ts IH]; intros s x y P H; cbn [combine] in H.
  - inversion H; subst. rewrite vr_nil, run_zero, sum_zero by auto. lra.
  - cbn [positive_terms forallb fst snd] in P. apply andb_prop in P. destruct P as [P1 P2]. apply andb_prop in P1. destruct P1 as [Pa Pb].
    apply Z.leb_le in Pa. apply Z.eqb_eq in Pb. subst b.
    destruct (PositiveMap.find i ps) as [[x1 y1]|] eqn:E; [|discriminate].
    destruct (combine ps ts) as [[s1 [u v]]|]; [|discriminate].
    specialize (IH _ _ _ P2 eq_refl). apply HP in E. cbn [fst] in E.
    unfold zmodulus in H. rewrite Z.eqb_refl, Z.abs_eq in H by auto. inversion H; subst.
    rewrite plus_IZR, vr_addmul, run_plus, run_scal. unfold plus, scal. rewrite sum_plus, sum_scal.
    apply IZR_le in Pa. apply (Rmult_le_compat_l (IZR a)) in E; auto. lra.
Qed.

(* A linear form that is d at least at the points is l d at least at an image that is above a combination with weights of
   sum l. *)
Lemma image_above_sound F (ps : points) scale l x t ts w d : well_formed F = true ->
  (forall t, (t < count F)%nat -> forall i j, (0 <= real F t i j)%R) -> 0 < scale -> (t < count F)%nat -> letters (count F) w -> (0 <= d)%R ->
  (forall i p, PositiveMap.find i ps = Some p -> (d <= sum (size F) (run (size F) (real F) w (vr (fst p))))%R) ->
  image_above F ps scale l x (letter F t) ts = true ->
  (real_of l * d <= sum (size F) (run (size F) (real F) w (apply (size F) (real F t) (vr x))))%R.
Proof.
  intros WF HT H2 Ht Hw Hd HW H.
  unfold image_above in H. destruct (combine ps ts) as [[s [y z]]|] eqn:EC; [|discriminate].
  repeat rewrite andb_true_iff in H. destruct H as [[A1 A2] A3]. apply Z.leb_le in A3.
  assert (B := combine_above (size F) (real F) w ps d Hd HW ts s y z A1 EC).
  assert (D := denominator_positive F WF). assert (Sc : (0 < IZR scale)%R) by (apply IZR_lt; auto).
  assert (Ql : (0 < IZR (Zpos (Qden l)))%R) by (apply IZR_lt; lia).
  (* the product of the image less the combination has no negative coordinate *)
  assert (M : (0 <= sum (size F) (run (size F) (real F) w (vr (addmul (- denominator F) y (addmul scale (mv (letter F t) x) [])))))%R).
  { apply sum_nonneg. apply (run_nonnegative (size F) (count F)); auto. intros i Hi. apply vector_nonnegative_vr; auto. }
  rewrite !vr_addmul, vr_nil, vr_letter in M by auto. rewrite !run_plus, !run_scal, run_zero in M. unfold plus, scal, zero in M.
  rewrite !sum_plus, !sum_scal, (sum_zero _ (fun _ => 0%R)) in M by auto. rewrite opp_IZR in M.
  set (image := sum (size F) (run (size F) (real F) w (apply (size F) (real F t) (vr x)))) in *.
  assert (M' : (IZR (denominator F) * (IZR s * d) <= IZR (denominator F) * (IZR scale * image))%R).
  { apply Rle_trans with (IZR (denominator F) * sum (size F) (run (size F) (real F) w (vr y)))%R; [|lra].
    apply Rmult_le_compat_l; lra. }
  apply Rmult_le_reg_l in M'; auto.
  apply IZR_le in A3. rewrite !mult_IZR in A3. unfold real_of.
  apply (Rmult_le_reg_l (IZR scale * IZR (Zpos (Qden l)))). apply Rmult_lt_0_compat; auto.
  replace (IZR scale * IZR (Zpos (Qden l)) * (IZR (Qnum l) / IZR (Zpos (Qden l)) * d))%R with (IZR (Qnum l) * IZR scale * d)%R by (field; lra).
  apply Rle_trans with (IZR s * IZR (Zpos (Qden l)) * d)%R. apply Rmult_le_compat_r; auto.
  replace (IZR s * IZR (Zpos (Qden l)) * d)%R with (IZR (Zpos (Qden l)) * (IZR s * d))%R by ring.
  replace (IZR scale * IZR (Zpos (Qden l)) * image)%R with (IZR (Zpos (Qden l)) * (IZR scale * image))%R by ring.
  apply Rmult_le_compat_l; lra.
Qed.

Theorem check_climb_sound F l c : well_formed F = true -> 0 <= Qnum l -> check_climb F l c = true ->
  subradius_at_least (size F) (count F) (real F) (real_of l).
Proof.
  intros WF Hl H. unfold check_climb in H. cbv zeta in H. repeat rewrite andb_true_iff in H. destruct H as [[[[H1 H2] H3] H4] H5].
  apply Z.ltb_lt in H1. apply Nat.ltb_lt in H3. rewrite forallb_forall in H4.
  set (all := climb_points c) in *. set (ps := number 1 all) in *. set (scale := climb_scale c) in *.
  assert (HT := all_nonnegative_matrices F WF all H2).
  assert (HP : forall p, In p all -> forall i, (0 <= vr (fst p) i)%R).
  { intros p I i. apply andb_prop in H2. destruct H2 as [_ HP]. rewrite forallb_forall in HP. apply HP in I. apply andb_prop in I.
    apply vector_nonnegative_vr, I. }
  set (Point := fun v : vec => exists p, In p all /\ v = vr (fst p)).
  assert (I0 : exists p0, In p0 all). { clearbody all. destruct all as [|p0 rest]. simpl in H3; lia. exists p0. left; auto. }
  destruct I0 as [p0 I0].
  apply (growing_bound (size F) (count F) (real F) Point (vr (fst p0))).
  - apply real_of_nonneg; auto.
  - exists p0. auto.
  - intros v [p [I ->]]. assert (L := H4 p I). apply andb_prop in L. destruct L as [L1 L2]. apply Nat.leb_le in L1. apply Z.ltb_lt in L2.
    assert (N := norm1_sum (fst p) (size F) L1). apply Rle_trans with (IZR (norm1 (fst p))). apply IZR_le, (Z.le_succ_l 0), L2.
    rewrite N. apply sum_le; intros i Hi. rewrite Rabs_pos_eq; auto. lra.
  - intros v t w d [p [I ->]] Ht Hw Hd HW.
    destruct (paired_spec _ _ _ H5 p I) as [lines HL].
    destruct (paired_spec _ _ _ HL (letter F t) ltac:(apply nth_In; auto)) as [ts HA].
    apply (image_above_sound F ps scale l (fst p) t ts w d); auto.
    intros i q E. apply number_in in E. apply HW. exists q. auto.
Qed.

Lemma transpose_slow F r :
  slow (size F) (count F) (real F) r <-> slow (size F) (count (transpose F)) (real (transpose F)) r.
Proof.
  unfold transpose at 1. rewrite count_map. split; intros H; apply slow_transposed in H; revert H; apply slow_ext; intros.
  - symmetry. apply transpose_entry; auto.
  - apply transpose_entry; auto.
Qed.

Lemma transpose_slowest F l : subradius_at_least (size F) (count (transpose F)) (real (transpose F)) l ->
  subradius_at_least (size F) (count F) (real F) l.
Proof. intros H r Hr G. apply H; auto. apply transpose_slow. auto. Qed.

(* What the checker accepts is true. *)
Theorem check_subradius_sound c cert : check_subradius c cert = true -> subradius_claim_holds c.
Proof.
  intros H x Hx. unfold check_subradius in H. repeat rewrite andb_true_iff in H. destruct H as [[[WF NF] HU] HL].
  set (F := matrices_of c) in *. split.
  - intros l E. rewrite E in HL. destruct (Z_le_gt_dec (Qnum l) 0) as [N|N].
    + apply Rle_trans with 0%R; [|apply Hx]. apply IZR_le in N. unfold real_of.
      assert (0 < / IZR (Zpos (Qden l)))%R by (apply Rinv_0_lt_compat, IZR_lt; lia). unfold Rdiv. nra.
    + apply orb_prop in HL. destruct HL as [HL|HL]; [apply Z.leb_le in HL; lia|].
      destruct (lower_climb cert) as [d|]; [|discriminate]. apply (subradius_least (size F) (count F) (real F)); auto.
      destruct (climb_transposed d).
      * apply transpose_slowest. change (size F) with (size (transpose F)). apply (check_climb_sound _ l d); auto. apply transpose_well_formed; auto. lia.
      * apply (check_climb_sound _ l d); auto. lia.
  - intros u E. rewrite E in HU. destruct (upper_product cert) as [p|]; [|discriminate]. apply andb_prop in HU. destruct HU as [H1 H2].
    apply (subradius_most (size F) (count F) (real F)); auto. eapply check_product_sound; eauto.
    unfold factor_below in H2. apply andb_prop in H2. apply real_of_nonneg, Z.leb_le, H2.
Qed.
