(* Hermite schemes, of one mask of matrices or with one for each level: data that, divided by powers of the step, tend to a function
   and its derivatives (SPEC.md, sections 6.7 and 6.12, Theorems 47 and 73). *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Integers Sections Check Subdivision Coefficients Grid Refinable Exponent Along VectorLevels Vectors Ranges VectorLists.
Import ListNotations.
Open Scope R_scope.

(* ---- definitions: what the theorems are about ------------------------------------------------------------------ *)

(* Functions phi 0, ..., phi k, each the derivative of the one before, the last one continuous; component s < r of the data of level n
   times A^(n s) tends to phi s at the points i / A^n, uniformly. *)
Definition tends_to_derivatives (A r k : nat) (data : nat -> vectors) (phi : nat -> R -> R) : Prop :=
  (forall s, (s < k)%nat -> forall x, derivable_pt_lim (phi s) x (phi (S s) x)) /\ continuity (phi k) /\
  forall eps, 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> forall i s, (s < r)%nat ->
  Rabs ((INR A ^ n) ^ s * data n i s - phi s (IZR i / INR A ^ n)) <= eps.

(* ---- derivatives of a function on grids ------------------------------------------------------------------------------ *)

Section Derivatives.
Variable A : nat.
Hypothesis Arity : (2 <= A)%nat.
Variable f : nat -> Z -> R.
Hypothesis Same : forall n i, f (S n) (Z.of_nat A * i)%Z = f n i.
Variable lambda : R.
Hypothesis Log : exp lambda = INR A.
Variables (m k : nat) (x C B : R).
Hypothesis Order : (k < m)%nat.
Hypothesis Between : INR k < x < INR k + 1.
Hypothesis Bounded : forall i, Rabs (f O i) <= B.
Hypothesis Shrink : forall n i, Rabs (differences m (f n) i) <= C * exp (- x * lambda) ^ n.
Notation quotients := (divided A f).

Lemma quotients_bounded e : (e <= k)%nat -> exists D q, 0 <= D /\ 0 < q < INR A /\ forall n i, Rabs (quotients (S (k - e)) n i) <= D * q ^ n.
Proof.
  assert (PA := arity_positive A Arity). assert (A1 : 1 < INR A) by (apply (lt_INR 1); lia). induction e; intros He.
  - destruct (divided_growth A Arity f Same lambda Log m k x C B Order Between Bounded Shrink (m - k - 1) ltac:(lia)) as [D [D0 HD]].
    replace (m - (m - k - 1))%nat with (S k) in HD by lia. rewrite Nat.sub_0_r. exists D, (exp ((INR (S k) - x) * lambda)). split; auto. split; auto.
    split. apply exp_pos. rewrite <- Log.
    replace (exp lambda) with (exp (1 * lambda)) by (f_equal; ring). apply (power_less A Arity lambda Log). rewrite S_INR. lra.
  - destruct (IHe ltac:(lia)) as [D [q [D0 [Hq HD]]]]. replace (S (k - S e)) with (k - e)%nat by lia.
    destruct (divided_limit A Arity f Same lambda Log B Bounded (k - e) D q D0 Hq HD) as [_ [_ [_ [[P [P0 HP]] _]]]].
    exists P, 1. split; auto. split. lra. intros n i. rewrite pow1, Rmult_1_r. auto.
Qed.

Theorem grid_derivatives : exists phi : nat -> R -> R, (forall j, (j < k)%nat -> forall t, derivable_pt_lim (phi j) t (phi (S j) t)) /\ continuity (phi k) /\
  forall j, (j <= k)%nat -> tends A (quotients j) (phi j) /\ exists D q, 0 <= D /\ 0 < q < 1 /\
  forall n i, Rabs (quotients j n i - quotients j n (i - 1)%Z) <= D * q ^ n.
Proof.
  assert (PA := arity_positive A Arity).
  destruct (choose_components A Arity (fun j phi => tends A (quotients j) phi /\ continuity phi) (S k)) as [phi Hphi].
  { intros j Hj. destruct (quotients_bounded (k - j) ltac:(lia)) as [D [q [D0 [Hq HD]]]]. replace (k - (k - j))%nat with j in HD by lia.
    destruct (divided_limit A Arity f Same lambda Log B Bounded j D q D0 Hq HD) as [phi [T [Co _]]]. exists phi. auto. }
  exists phi. split; [|split].
  - intros j Hj. destruct (Hphi j ltac:(lia)) as [T _]. destruct (Hphi (S j) ltac:(lia)) as [T' Co'].
    apply (data_derivative A Arity (quotients j) (quotients (S j)) (phi j) (phi (S j))); auto.
    + intros n i. apply (divided_succ A Arity).
    + intros eta Heta. destruct (T' eta Heta) as [n0 Hn]. exists n0. intros n Hle l. specialize (Hn n Hle (IZR l / INR A ^ n)).
      rewrite (grid_value A Arity), (floor_integer A Arity) in Hn. auto.
  - apply Hphi. lia.
  - intros j Hj. split. apply Hphi. lia. destruct (quotients_bounded (k - j) ltac:(lia)) as [D [q [D0 [Hq HD]]]]. replace (k - (k - j))%nat with j in HD by lia.
    exists D, (q / INR A). split; auto. split.
    + split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r (INR A)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    + intros n i. apply (divided_near A Arity f j D q n i HD).
Qed.
End Derivatives.

(* ---- the theorem ------------------------------------------------------------------------------------------------------ *)

Section Hermite.
Variables (A r m k : nat) (lambda l scale : R) (points : nat) (weight : nat -> nat -> R) (data : nat -> vectors).
Hypothesis Arity : (2 <= A)%nat.
Hypothesis Log : exp lambda = INR A.
Hypothesis Near : near_grids A r m lambda l scale points weight data.
Hypothesis End : INR k < l <= INR m.
Hypothesis Components : (r <= S k)%nat.
Hypothesis Scale : scale <> 0.
(* The sums of component s are multiples of differences of order s, and the factors sum to the scale. *)
Variables (terms : nat) (factor : nat -> nat -> R).
Hypothesis Factors : forall s, (s < r)%nat -> sum terms (factor s) = scale /\ forall h i,
  sum points (fun j => weight s j * h (i - Z.of_nat j)%Z) = sum terms (fun j => factor s j * differences s h (i - Z.of_nat j)%Z).

Theorem hermite_limit : exists phi, tends_to_derivatives A r k data phi.
Proof.
  destruct Near as [h [v [Same [[B HB] All]]]]. assert (PA := arity_positive A Arity). assert (L0 := log_positive A Arity lambda Log).
  set (x := (INR k + Rmin l (INR k + 1)) / 2).
  assert (Hx : INR k < x < INR k + 1 /\ x < l).
  { unfold x. assert (INR k < Rmin l (INR k + 1)) by (apply Rmin_glb_lt; lra). generalize (Rmin_l l (INR k + 1)) (Rmin_r l (INR k + 1)). lra. }
  destruct Hx as [Hx Xl]. assert (K0 := pos_INR k).
  assert (Hkm : (k < m)%nat) by (apply INR_lt; lra).
  destruct (All x ltac:(lra)) as [K [K00 HK]]. set (g := exp (- x * lambda)) in *.
  destruct (grid_derivatives A Arity v Same lambda Log m k x K B Hkm Hx HB (fun n i => proj1 (HK n i))) as [phi [Der [Co Ten]]].
  exists phi. split; auto. split; auto.
  (* one component, then all *)
  assert (One : forall s, (s < r)%nat -> forall eps, 0 < eps -> exists n0, forall n, (n0 <= n)%nat -> forall i,
    Rabs ((INR A ^ n) ^ s * data n i s - phi s (IZR i / INR A ^ n)) <= eps).
  { intros s Hs eps He. destruct (Ten s ltac:(lia)) as [T [D [q [D0 [Hq Nb]]]]]. destruct (Factors s Hs) as [Sum Fac].
    set (W := sum terms (fun j => Rabs (factor s j))). assert (W0 : 0 <= W) by (apply sum_nonneg; intros; apply Rabs_pos).
    assert (S0 : 0 < Rabs scale) by (apply Rabs_pos_lt; auto). assert (P0 : 0 <= 2 ^ s) by (apply pow_le; lra). assert (T0 := pos_INR terms).
    set (y := exp ((INR s - x) * lambda)).
    assert (Hy : 0 < y < 1).
    { split. apply exp_pos. rewrite <- exp_0. apply exp_less. assert (INR s <= INR k) by (apply le_INR; lia). nra. }
    assert (Yn : forall n, (INR A ^ n) ^ s * g ^ n = y ^ n).
    { intros n. rewrite <- pow_mult, (Nat.mul_comm n s), pow_mult, <- Rpow_mult_distr. f_equal. unfold g, y. rewrite <- Log, exp_power, <- exp_plus. f_equal. ring. }
    assert (E0 : 0 < Rabs scale * eps / 3) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; auto|lra]).
    destruct (small_power y Hy (K + W * (2 ^ s * K)) (Rabs scale * eps / 3)) as [n1 H1]; auto.
    { apply Rplus_le_le_0_compat; auto. apply Rmult_le_pos; auto. apply Rmult_le_pos; auto. }
    destruct (small_power q Hq (W * (INR terms * D)) (Rabs scale * eps / 3)) as [n2 H2]; auto.
    { apply Rmult_le_pos; auto. apply Rmult_le_pos; auto. }
    destruct (T (eps / 3) ltac:(lra)) as [n3 H3].
    exists (n1 + n2 + n3)%nat. intros n Hn i. specialize (H1 n ltac:(lia)). specialize (H2 n ltac:(lia)).
    specialize (H3 n ltac:(lia) (IZR i / INR A ^ n)). rewrite (grid_value A Arity), (floor_integer A Arity) in H3.
    destruct (HK n i) as [_ [_ Comp]]. specialize (Comp s Hs). rewrite Fac in Comp. set (a := (INR A ^ n) ^ s) in *. set (p := phi s _) in *.
    assert (A0 : 0 <= a) by (apply pow_le, pow_le; lra). assert (Q0 : 0 <= q ^ n) by (apply pow_le; lra).
    set (d := divided A v s n i) in *.
    assert (Back : forall j, Rabs (divided A v s n (i - Z.of_nat j)%Z - d) <= INR j * (D * q ^ n)).
    { induction j.
      - rewrite Z.sub_0_r. unfold d. rewrite Rminus_diag_eq, Rabs_R0 by auto. simpl. lra.
      - rewrite S_INR. specialize (Nb n (i - Z.of_nat j)%Z). replace (i - Z.of_nat j - 1)%Z with (i - Z.of_nat (S j))%Z in Nb by lia. rewrite Rabs_minus_sym in Nb.
        match goal with |- Rabs (?u - d) <= _ => replace (u - d) with ((u - divided A v s n (i - Z.of_nat j)%Z) + (divided A v s n (i - Z.of_nat j)%Z - d)) by ring end.
        eapply Rle_trans. apply Rabs_triang. lra. }
    assert (Each : forall j, (j < terms)%nat -> Rabs (a * differences s (h n) (i - Z.of_nat j)%Z - d) <= 2 ^ s * K * y ^ n + INR terms * D * q ^ n).
    { intros j Hj. assert (N1 := differences_near (h n) (v n) (K * g ^ n) (fun i => proj1 (proj2 (HK n i))) s (i - Z.of_nat j)%Z).
      specialize (Back j). unfold divided in Back at 1. fold a in Back.
      replace (a * differences s (h n) (i - Z.of_nat j)%Z - d) with
        (a * (differences s (h n) (i - Z.of_nat j)%Z - differences s (v n) (i - Z.of_nat j)%Z) + (a * differences s (v n) (i - Z.of_nat j)%Z - d)) by ring.
      eapply Rle_trans. apply Rabs_triang. apply Rplus_le_compat.
      - rewrite Rabs_mult, (Rabs_pos_eq a) by auto. rewrite <- Yn. fold a. replace (2 ^ s * K * (a * g ^ n)) with (a * (2 ^ s * (K * g ^ n))) by ring.
        apply Rmult_le_compat_l; auto.
      - eapply Rle_trans. apply Back. replace (INR terms * D * q ^ n) with (INR terms * (D * q ^ n)) by ring.
        apply Rmult_le_compat_r. apply Rmult_le_pos; auto. apply le_INR. lia. }
    assert (All' : Rabs (a * sum terms (fun j => factor s j * differences s (h n) (i - Z.of_nat j)%Z) - scale * d) <= W * (2 ^ s * K * y ^ n + INR terms * D * q ^ n)).
    { rewrite <- Sum. rewrite (Rmult_comm (sum terms (factor s)) d), <- !sum_scal, <- sum_minus. eapply Rle_trans. apply sum_abs. unfold W.
      rewrite Rmult_comm, <- sum_scal. apply sum_le; intros j Hj.
      replace (a * (factor s j * differences s (h n) (i - Z.of_nat j)%Z) - d * factor s j) with (factor s j * (a * differences s (h n) (i - Z.of_nat j)%Z - d)) by ring.
      rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos. auto. }
    assert (Comp' : Rabs (a * (scale * data n i s) - a * sum terms (fun j => factor s j * differences s (h n) (i - Z.of_nat j)%Z)) <= K * y ^ n).
    { rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq a), <- Yn by auto. fold a. replace (K * (a * g ^ n)) with (a * (K * g ^ n)) by ring.
      apply Rmult_le_compat_l; auto. }
    apply (Rmult_le_reg_l (Rabs scale)); auto. rewrite <- Rabs_mult.
    set (u := a * sum terms _) in *.
    replace (scale * (a * data n i s - p)) with ((a * (scale * data n i s) - u) + ((u - scale * d) + scale * (d - p))) by ring.
    eapply Rle_trans. apply Rabs_triang. eapply Rle_trans. apply Rplus_le_compat_l. apply Rabs_triang. rewrite (Rabs_mult scale).
    assert (Rabs scale * Rabs (d - p) <= Rabs scale * (eps / 3)) by (apply Rmult_le_compat_l; lra). lra. }
  intros eps He. clear - One He. induction r as [|r' IH]. exists O. intros; lia.
  destruct (IH (fun s Hs => One s ltac:(lia))) as [n1 H1]. destruct (One r' ltac:(lia) eps He) as [n2 H2].
  exists (n1 + n2)%nat. intros n Hn i s Hs. destruct (Nat.eq_dec s r') as [->|]. apply H2; lia. apply H1; lia.
Qed.
End Hermite.

(* ---- claims ---------------------------------------------------------------------------------------------------------- *)

(* The data of level n from f, times A^(n s) in component s, are those of the Hermite scheme. *)
Definition limit_of_hermite (m : vector_masks) (i : nat -> nat) (k : nat) (f : vectors) (phi : nat -> R -> R) : Prop :=
  bounded_data (list_functions m) f /\ tends_to_derivatives (list_arity m) (list_functions m) k (list_data m i f) phi.

(* For each of the sequences, and all bounded first data, they tend to a function with k continuous derivatives and to its derivatives,
   and it is not always 0. *)
Definition hermite_lists_hold (m : vector_masks) (s : sequences) (k : nat) : Prop :=
  (list_functions m <= S k)%nat /\ forall i, allowed (length (each_vector m)) s i ->
  (forall f, bounded_data (list_functions m) f -> exists phi, limit_of_hermite m i k f phi) /\
  exists f phi x, limit_of_hermite m i k f phi /\ phi O x <> 0.

(* ---- the checker ------------------------------------------------------------------------------------------------------- *)

Open Scope Z_scope.

(* Times (1 - z)^s *)
Fixpoint times_differences (s : nat) (l : list Z) : list Z :=
  match s with O => l | S s' => times_differences s' (addmul (-1) (0 :: l) l) end.

(* The weights of component s are differences of order s of these factors, which sum to the scale. *)
Definition derivative_factors (c : list_certificate) (r : nat) (factors : list (list Z)) : bool :=
  forallb (fun s => let q := nth s factors [] in let w := nth s (list_weights c) [] in
    zero_list (addmul (-1) (times_differences s q) w) && (length w <=? S (list_order c))%nat && (length q <=? S (list_order c))%nat &&
    (fold_right Z.add 0 q =? list_scale c)) (seq 0 r).

Definition check_hermite_lists (m : vector_masks) (s : sequences) (k : nat) (c : list_certificate) (factors : list (list Z)) : bool :=
  lists_space m s c && (list_functions m <=? S k)%nat && below_power_strictly (list_arity m) (Qmake (Z.of_nat k) 1) (list_order c) (list_bound c) &&
  derivative_factors c (list_functions m) factors && negb (nth 0 (constants c) 0 =? 0) &&
  check_radius (Claim (lists_family m s c) None (Some (list_bound c))) (list_radius c).

Open Scope R_scope.

(* ---- sums of differences ------------------------------------------------------------------------------------------------- *)

Fixpoint acts (l : list Z) (h : Z -> R) (i : Z) : R := match l with [] => 0 | c :: l' => IZR c * h i + acts l' h (i - 1)%Z end.

Lemma acts_addmul c : forall x y h i, acts (addmul c x y) h i = IZR c * acts x h i + acts y h i.
Proof.
  induction x as [|a x IH]; intros [|b y] h i; simpl; try ring.
  - specialize (IH [] h (i - 1)%Z). simpl in IH. rewrite mult_IZR, IH. ring.
  - rewrite IH, plus_IZR, mult_IZR. ring.
Qed.

Lemma acts_zero l : zero_list l = true -> forall h i, acts l h i = 0.
Proof.
  induction l as [|c l IH]; intros H h i; auto. unfold zero_list in H. cbn [forallb] in H. apply andb_prop in H. destruct H as [H1 H2].
  apply Z.eqb_eq in H1. subst. cbn [acts]. rewrite IH by auto. simpl. ring.
Qed.

Lemma acts_minus l f g i : acts l (fun i => f i - g i) i = acts l f i - acts l g i.
Proof. revert i. induction l as [|c l IH]; intros i; cbn [acts]. ring. rewrite IH. ring. Qed.

Lemma acts_back l f : forall i, acts l (fun i => f (i - 1)%Z) i = acts l f (i - 1)%Z.
Proof. induction l as [|c l IH]; intros i; cbn [acts]; auto. rewrite IH. auto. Qed.

Lemma acts_differences s : forall l h i, acts (times_differences s l) h i = acts l (differences s h) i.
Proof.
  induction s; intros l h i; auto. cbn [times_differences]. rewrite IHs, acts_addmul. cbn [acts differences].
  rewrite (acts_minus l (differences s h) (fun i => differences s h (i - 1)%Z)), acts_back. simpl. ring.
Qed.

Lemma acts_sum : forall l n, (length l <= n)%nat -> forall h i, acts l h i = sum n (fun j => IZR (nth j l 0%Z) * h (i - Z.of_nat j)%Z).
Proof.
  induction l as [|c l IH]; intros n Hn h i.
  - symmetry. apply sum_zero. intros j _. destruct j; simpl; ring.
  - destruct n as [|n]; simpl in Hn; [lia|]. change (S n) with (1 + n)%nat. rewrite sum_add. cbn [sum acts]. rewrite (IH n) by lia. simpl nth. rewrite Z.sub_0_r.
    rewrite Rplus_0_l. f_equal. apply sum_ext; intros j _. f_equal. f_equal. lia.
Qed.

Lemma acts_total l : forall i, acts l (fun _ => 1) i = IZR (fold_right Z.add 0%Z l).
Proof. induction l as [|c l IH]; intros i; auto. cbn [acts fold_right]. rewrite IH, plus_IZR. ring. Qed.

(* ---- the theorem of the checker ----------------------------------------------------------------------------------------------- *)

(* What the checker accepts is true. *)
Theorem check_hermite_lists_sound m s k c factors : check_hermite_lists m s k c factors = true -> hermite_lists_hold m s k.
Proof.
  intros H. unfold check_hermite_lists in H. rewrite !andb_true_iff in H. destruct H as [[[[[H HR] HB] HF] HC0] HJ].
  apply Nat.leb_le in HR. split; auto. assert (H' := H). unfold lists_space in H'. rewrite !andb_true_iff in H'. destruct H' as [[[[HW HS] HC] HM] _].
  destruct (window_facts m c HW) as [A2 [_ [R1 _]]]. destruct (exp_onto (INR (list_arity m)) (arity_positive _ A2)) as [lambda Log].
  destruct (below_power_strictly_sound lambda _ _ _ _ Log A2 HB) as [_ [l [Hl HU]]].
  assert (Ek : real_of (Qmake (Z.of_nat k) 1) = INR k) by (unfold real_of; cbn [Qnum Qden]; rewrite <- INR_IZR_INZ; field). rewrite Ek in Hl.
  assert (K0 := pos_INR k). intros i Hi.
  assert (HG := radius_bounded _ _ (check_radius_sound _ _ HJ)).
  destruct (list_radius_growth m s c lambda l _ H Log HU HG i Hi) as [Hn G].
  assert (Com := HM). unfold list_comes in Com. rewrite !andb_true_iff in Com. destruct Com as [[_ C4] _]. apply negb_true_iff, Z.eqb_neq in C4.
  assert (D : forall f, bounded_data (list_functions m) f -> exists phi, limit_of_hermite m i k f phi).
  { intros f Hf. destruct (data_of_growth m c HW HS HM i Hn lambda l f Log ltac:(lra) G Hf) as [_ [_ [_ Near]]].
    destruct (hermite_limit (list_arity m) (list_functions m) (list_order c) k lambda l (IZR (list_scale c)) (S (list_order c)) (list_weight c) (list_data m i f)
      A2 Log Near Hl HR (IZR_neq _ _ C4) (S (list_order c)) (fun s j => IZR (nth j (nth s factors []) 0%Z))) as [phi Lim].
    2: { exists phi. split; auto. }
    intros d Hd. unfold derivative_factors in HF. rewrite forallb_forall in HF. specialize (HF d ltac:(apply in_seq; lia)). cbv zeta in HF.
    rewrite !andb_true_iff in HF. destruct HF as [[[F1 F2] F3] F4]. apply Nat.leb_le in F2, F3. apply Z.eqb_eq in F4. split.
    - rewrite <- F4, <- (acts_total _ 0%Z), (acts_sum _ _ F3). apply sum_ext; intros. ring.
    - intros h x. assert (Z0 := acts_zero _ F1 h x). rewrite acts_addmul, acts_differences in Z0. unfold list_weight.
      rewrite <- (acts_sum _ _ F2), <- (acts_sum _ _ F3). simpl (IZR (-1)) in Z0. lra. }
  split; auto. apply negb_true_iff, Z.eqb_neq in HC0.
  assert (Cb : bounded_data (list_functions m) (constant_data c)).
  { destruct (all_below (list_functions m) (fun d y => Rabs (IZR (nth d (constants c) 0%Z)) <= y)) as [B HB']. intros; eapply Rle_trans; eauto.
    intros d _. eexists. apply Rle_refl. exists B. intros j d Hd. apply HB'. auto. }
  destruct (D _ Cb) as [phi Lim]. exists (constant_data c), phi, 0. split; auto. intros Zero. apply HC0. apply eq_IZR. apply cond_eq. intros eps He.
  destruct Lim as [_ [_ [_ Lim]]]. destruct (Lim (eps / 2) ltac:(lra)) as [n0 Hn0]. specialize (Hn0 n0 (le_n n0) 0%Z O ltac:(lia)).
  rewrite (constant_levels m c HW HC i Hn) in Hn0 by lia. unfold constant_data in Hn0. replace (IZR 0 / INR (list_arity m) ^ n0) with 0 in Hn0 by (unfold Rdiv; ring).
  rewrite Zero, pow_O in Hn0. replace (IZR (nth 0 (constants c) 0%Z) - 0) with (1 * IZR (nth 0 (constants c) 0%Z) - 0) by ring. lra.
Qed.
