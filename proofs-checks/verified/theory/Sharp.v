(* With one spectral radius that is a simple pole, products grow like its powers: the middle coefficients are bounded on
   the average, and that of n steps is at most a multiple of the product of those of j and n - j steps. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Integers Sections Subdivision Stability Coefficients Growth Squares Single Descartes
  Complex Number Largest.
Import ListNotations.
Open Scope R_scope.

Lemma finite_search (f : nat -> R) x w : (exists k, (k < w)%nat /\ x <= f k) \/ (forall k, (k < w)%nat -> f k < x).
Proof.
  induction w. right. intros. lia. destruct IHw as [[k [Hk H]]|H]. left. exists k. split; auto.
  destruct (Rle_lt_dec x (f w)). left. exists w. split; auto. right. intros k Hk. destruct (Nat.eq_dec k w). subst; auto. apply H. lia.
Qed.

Lemma pvalue_bounded p X : exists B, 0 <= B /\ forall x, 0 <= x <= X -> Rabs (pvalue p x) <= B.
Proof.
  induction p as [|c p [B [B0 H]]]. exists 0. split. lra. intros. simpl. rewrite Rabs_R0. lra.
  exists (Rabs c + Rabs X * B). assert (C := Rabs_pos c). assert (D := Rabs_pos X). split. assert (0 <= Rabs X * B) by (apply Rmult_le_pos; auto). lra.
  intros x Hx. cbn [pvalue]. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_mult. apply Rplus_le_compat_l.
  apply Rmult_le_compat; auto; try apply Rabs_pos. rewrite !Rabs_pos_eq by lra. lra.
Qed.

Lemma order_count low z l q : low <= z -> (forall i, (i < l)%nat -> nth i (pshift z q) 0 = 0) -> (l <= length q)%nat ->
  (l <= sign_count (signs (pshift low q)))%nat.
Proof.
  intros Hz Order Hl. set (a := z - low). set (d := pshift z q) in *.
  assert (Ld : length d = length q) by apply length_pshift. set (e := skipn l d).
  assert (Ed : d = repeat 0 l ++ e).
  { rewrite <- (firstn_skipn l d) at 1. fold e. f_equal. assert (LF : length (firstn l d) = l) by (rewrite firstn_length; lia).
    apply (nth_ext _ _ 0 0). rewrite repeat_length; auto. intros i Hi. rewrite LF in Hi.
    rewrite nth_repeat. assert (N : nth i (firstn l d ++ skipn l d) 0 = 0) by (rewrite firstn_skipn; auto).
    rewrite app_nth1 in N by (rewrite LF; auto). auto. }
  assert (Back : pshift (- a) d = pshift low q) by (unfold d; rewrite pshift_pshift; f_equal; unfold a; lra).
  rewrite <- Back, Ed. assert (Ha : 0 <= a) by (unfold a; lra). revert Ha. clearbody a e. clear. intros Ha. induction l; cbn [repeat app]. lia.
  change (pshift (- a) (0 :: repeat 0 l ++ e)) with (padd (0 :: pshift (- a) (repeat 0 l ++ e)) (pscal (- a) (pshift (- a) (repeat 0 l ++ e)))).
  rewrite with_root_spec. eapply Nat.le_trans; [|apply count_root; auto]. lia.
Qed.

(* Averages *)
Section Average.
Variables (v : nat -> R) (K C : R).
Hypothesis V0 : forall n, 0 <= v n.
Hypothesis K0 : 0 <= K.
Hypothesis Average : forall n, sum (S n) v <= C * INR (S n).
Hypothesis Product : forall n k, v (n + k)%nat <= K * (v n * v k).

Lemma average_bounded n : v n <= K * ((2 * C) * (2 * C)).
Proof.
  destruct (finite_search (fun j => - (v j + v (n - j)%nat)) (- (2 * C)) (S n)) as [[j [Hj H]]|H].
  - replace n with (j + (n - j))%nat at 1 by lia. eapply Rle_trans. apply Product. apply Rmult_le_compat_l; auto.
    assert (A := V0 j). assert (B := V0 (n - j)%nat). apply Rmult_le_compat; lra.
  - exfalso. assert (A := Average n).
    assert (R : sum (S n) (fun j => v (n - j)%nat) = sum (S n) v).
    { rewrite (sum_reverse (S n) v). apply sum_ext. intros i Hi. f_equal. lia. }
    assert (L : sum (S n) (fun j => v j + v (n - j)%nat) <= 2 * (C * INR (S n))) by (rewrite sum_plus, R; lra).
    assert (G : forall N, (forall j, (j < S N)%nat -> 2 * C < v j + v (n - j)%nat) -> INR (S N) * (2 * C) < sum (S N) (fun j => v j + v (n - j)%nat)).
    { induction N; intros HN. simpl. specialize (HN O ltac:(lia)). lra.
      rewrite S_INR. change (sum (S (S N)) (fun j => v j + v (n - j)%nat)) with (sum (S N) (fun j => v j + v (n - j)%nat) + (v (S N) + v (n - S N)%nat)).
      specialize (IHN (fun j Hj => HN j ltac:(lia))). specialize (HN (S N) ltac:(lia)). lra. }
    specialize (G n (fun j Hj => ltac:(specialize (H j Hj); cbv beta in H; lra))). lra.
Qed.
End Average.

Section Sharp.
Variables (F : family) (p : list Z) (c : pole).
Hypothesis WF : well_formed F = true.
Hypothesis Right : pole_right F p c = true.
Let s := squares_of c.
Let A := count F.
Let b := symbol s.
Let q := reduced p c.
Let Sq := proj1 (pole_facts F p c Right).
Let m := moments F s.
Let cc := middle b.

Lemma moments_product n k : m (k + n)%nat <= INR (3 * cc + 2) * (m n * m k).
Proof.
  destruct (facts F s Sq) as [HA [_ [_ [Lb [_ _]]]]]. fold A in HA. fold b cc in Lb. set (N := (length b - 1)%nat).
  assert (Sup : supported (- Z.of_nat cc) N (centred F s)).
  { intros i Hi. unfold centred. apply (symbol_support F s Sq). fold b cc. unfold N in Hi. lia. }
  assert (In : forall j, inside ((- Z.of_nat cc) * (Z.of_nat A ^ Z.of_nat j - 1) / (Z.of_nat A - 1))%Z (Z.to_nat (Z.of_nat (N + 1) * Z.of_nat A ^ Z.of_nat j)) (powers F s j)).
  { intros j. apply (refined_inside A (- Z.of_nat cc) N HA N (centred F s) j Sup (le_n N)). }
  assert (E := refined_compose A (- Z.of_nat cc) N HA (centred F s) n k _ _ (In n) 0%Z).
  set (lo := ((- Z.of_nat cc) * (Z.of_nat A ^ Z.of_nat n - 1) / (Z.of_nat A - 1))%Z) in *. set (w := Z.to_nat (Z.of_nat (N + 1) * Z.of_nat A ^ Z.of_nat n)) in *.
  set (g := fun j => powers F s n j * powers F s k (0 - Z.of_nat A ^ Z.of_nat k * j)%Z).
  assert (E' : m (k + n)%nat = sum w (fun i => g (lo + Z.of_nat i)%Z)) by exact E.
  rewrite E'. rewrite (sum_two_windows g lo w (- (2 * Z.of_nat cc + 1)) (3 * cc + 2)).
  - eapply Rle_trans. apply Rle_abs. eapply Rle_trans. apply sum_abs. apply sum_bound. intros i Hi. unfold g. rewrite Rabs_mult.
    apply Rmult_le_compat; try apply Rabs_pos; apply (powers_central F s WF Sq).
  - intros j Hj. unfold g. rewrite (In n j Hj). ring.
  - intros j Hj. unfold g. rewrite (In k). ring.
    assert (P : (0 < Z.of_nat A ^ Z.of_nat k)%Z) by (apply Z.pow_pos_nonneg; lia). set (x := (Z.of_nat A ^ Z.of_nat k)%Z) in *.
    set (l := ((- Z.of_nat cc) * (x - 1) / (Z.of_nat A - 1))%Z).
    assert (L1 : (- Z.of_nat cc * (x - 1) <= l)%Z). { unfold l. apply Z.div_le_lower_bound. lia. assert (0 <= Z.of_nat cc * (x - 1))%Z by (apply Z.mul_nonneg_nonneg; lia). nia. }
    assert (L2 : (l <= 0)%Z). { unfold l. apply Z.div_le_upper_bound. lia. assert (0 <= Z.of_nat cc * (x - 1))%Z by (apply Z.mul_nonneg_nonneg; lia). lia. }
    rewrite Z2Nat.id by (apply Z.mul_nonneg_nonneg; lia). replace (Z.of_nat (N + 1)) with (2 * Z.of_nat cc + 1)%Z by (unfold N; lia).
    destruct Hj as [Hj|Hj].
    + right. assert (x * (2 * Z.of_nat cc + 2) <= x * - j)%Z by (apply Z.mul_le_mono_nonneg_l; lia). lia.
    + left. assert (x * (Z.of_nat cc + 1) <= x * j)%Z by (apply Z.mul_le_mono_nonneg_l; lia). lia.
Qed.

Variables (h : place) (z : R).
Hypothesis Zero : pvalue (reals p) z = 0.
Hypothesis Zp : 0 < z.
Hypothesis Low : IZR (low h) / IZR (bottom h) <= z.
Hypothesis Bottom : (0 < bottom h)%Z.
Hypothesis Largest : no_larger F p h c = true.
Hypothesis Once : multiplicity c = 1%nat.

Lemma simple_zero : exists g, (g = 1 \/ g = -1)%Z /\ nonnegative (pshift z (reals (map (Z.mul g) q))) /\
  nth 0 (pshift z (reals (map (Z.mul g) q))) 0 = 0 /\ 0 < nth 1 (pshift z (reals (map (Z.mul g) q))) 0.
Proof.
  assert (H := Largest). unfold no_larger in H. cbv zeta in H. fold q in H. rewrite Once in H. repeat rewrite andb_true_iff in H. destruct H as [[_ H1] H2].
  apply Nat.ltb_lt in H1. apply Nat.leb_le in H2. rewrite <- signs_shifted in H2 by auto.
  assert (Order := reduced_order p c z Zero). fold q in Order. rewrite Once in Order.
  assert (Lr : length (reals q) = length q) by apply reals_length.
  destruct (largest_zero _ z 1 (reals q) Low Order ltac:(lia) H2) as [g [Hg [N _]]].
  assert (E : pscal (IZR g) (reals q) = reals (map (Z.mul g) q)). { unfold pscal, reals. rewrite !map_map. apply map_ext. intros. rewrite mult_IZR. auto. }
  exists g. rewrite <- E. split; auto. split; auto. assert (O0 := Order O ltac:(lia)). split. rewrite pshift_pscal, O0. ring.
  destruct (N 1%nat) as [P|P]; auto. exfalso. rewrite pshift_pscal in P. symmetry in P. apply Rmult_integral in P. destruct P as [P|P].
  - destruct Hg as [-> | ->]; lra.
  - assert (T := order_count _ z 2 (reals q) Low ltac:(intros [|[|i]] Hi; auto; lia) ltac:(lia)). lia.
Qed.

Theorem sharp_growth : grows_at_most (size F) (count F) (real F) z.
Proof.
  destruct simple_zero as [g [Hg [N [D0 D1]]]]. set (qz := map (Z.mul g) q) in *. set (d := pshift z (reals qz)) in *.
  assert (M0 : forall n, 0 <= m n) by (apply (moments_nonnegative F s WF Sq)).
  assert (Rec : forall n, along z d m n = 0).
  { intros n. unfold d. rewrite <- (Rplus_0_l z) at 1. rewrite along_shift.
    assert (E : reals qz = pscal (IZR g) (reals q)). { unfold qz, pscal, reals. rewrite !map_map. apply map_ext. intros. rewrite mult_IZR. auto. }
    rewrite E, along_pscal. unfold m, s. rewrite (reduced_recurs F p c WF Right). ring. }
  assert (P1 : exists i, 0 < nth i d 0) by (exists 1%nat; auto).
  assert (Up := no_larger_sound F p c WF Right h z Zero Zp Low Bottom Largest).
  assert (Gr : forall r, z < r -> grows m r). { intros r Hr. apply (moments_growth F s WF Sq r ltac:(lra)). apply Up; lra. }
  set (l := middles_of F p c). set (kappa := IZR (denominator F) ^ (length (recurrence c) + length q - 1)).
  assert (Kp : 0 < kappa) by (apply (kappa_positive F p c WF)).
  assert (Lq : length qz = length q) by apply map_length.
  assert (Nv : forall x, pvalue (reals (numerator qz l)) x = kappa * along x (tl (pshift x (reals qz))) m 0).
  { intros x. apply numerator_value. intros i Hi. apply (middles_right F p c WF Right). fold q. lia. }
  destruct (pvalue_bounded (reals (numerator qz l)) (2 * z)) as [B [B0 HB]].
  set (d1 := nth 1 d 0) in *. set (C := exp 1 * (B / kappa) / d1).
  assert (E0 := exp_pos 1).
  assert (Average : forall n, sum (S n) (fun j => m j / z ^ j) <= C * INR (S n)).
  { intros n. set (k := INR (S n)). assert (K0 : 1 <= k) by (unfold k; rewrite S_INR; assert (X := pos_INR n); lra).
    set (y := z / k). assert (Y0 : 0 < y) by (apply Rdiv_lt_0_compat; lra). assert (Y1 : y <= z). { unfold y. apply (Rmult_le_reg_r k). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. assert (z * 1 <= z * k) by (apply Rmult_le_compat_l; lra). lra. }
    set (x := z + y). assert (X0 : 0 < x) by (unfold x; lra).
    assert (Bel : 0 <= z + y / 2 < z + y) by lra. assert (Gb := Gr (z + y / 2) ltac:(lra)).
    assert (Non := iterated_nonnegative z y d m (Rlt_le _ _ Zp) Y0 N P1 M0 Rec (z + y / 2) Bel Gb 1).
    assert (Nxt := iterated_next z y d m Y0 N P1 Rec 0). fold x in Nxt.
    set (it := iterated z y d m 1) in *. change (iterated z y d m 0) with m in Nxt.
    assert (Part : forall J, sum J (fun j => m j / x ^ S j) + it J / x ^ J = it O).
    { induction J. simpl. field. cbn [sum]. rewrite Nxt. rewrite <- IHJ. assert (0 < x ^ J) by (apply pow_lt; auto). simpl. field. lra. }
    assert (First : y * d1 <= nth 0 (pshift y d) 0).
    { rewrite pshift_value. unfold d1. destruct d as [|e0 [|e1 d']]; simpl in *; try lra. subst e0.
      assert (Q : 0 <= pvalue d' y). { assert (Nd : nonnegative d') by (intros i; apply (N (S (S i)))). clear - Nd Y0. induction d'; simpl. lra.
        apply nonnegative_cons in Nd. destruct Nd as [A0 Nd]. assert (0 <= y * pvalue d' y) by (apply Rmult_le_pos; auto; lra). lra. }
      assert (0 <= y * (y * pvalue d' y)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). lra. }
    assert (Yd : 0 < y * d1) by (apply Rmult_lt_0_compat; auto).
    assert (It : it O <= B / kappa / (y * d1)).
    { unfold it. cbn [iterated]. unfold resolvent. assert (Sh : pshift y d = pshift x (reals qz)). { unfold d, x. rewrite pshift_pshift. f_equal. lra. }
      rewrite Sh in First |- *. fold x.
      assert (V : Rabs (along x (tl (pshift x (reals qz))) m 0) <= B / kappa).
      { specialize (Nv x). apply (Rmult_le_reg_l kappa); auto. replace (kappa * (B / kappa)) with B by (field; lra).
        rewrite <- (Rabs_pos_eq kappa) at 1 by lra. rewrite <- Rabs_mult, <- Nv. apply HB. unfold x. lra. }
      set (t := along x (tl (pshift x (reals qz))) m 0) in *. set (c0 := nth 0 (pshift x (reals qz)) 0) in *.
      apply Rle_trans with (/ c0 * (B / kappa)).
      - apply Rmult_le_compat_l. left. apply Rinv_0_lt_compat. lra. eapply Rle_trans; [apply Rle_abs|exact V].
      - unfold Rdiv at 2. rewrite Rmult_comm. apply Rmult_le_compat_l. apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto.
        apply Rinv_le_contravar; auto. }
    assert (Small : x ^ S n <= exp 1 * z ^ S n).
    { assert (X1 : x <= z * exp (/ k)). { unfold x, y. assert (T := exp_at_least (/ k) ltac:(left; apply Rinv_0_lt_compat; lra)).
        replace (z + z / k) with (z * (1 + / k)) by (field; lra). apply Rmult_le_compat_l; lra. }
      apply Rle_trans with ((z * exp (/ k)) ^ S n). apply pow_incr. lra. rewrite Rpow_mult_distr, exp_power. fold k. rewrite Rinv_r by lra. lra. }
    assert (Terms : sum (S n) (fun j => m j / z ^ j) <= exp 1 * z * sum (S n) (fun j => m j / x ^ S j)).
    { rewrite <- sum_scal. apply sum_le. intros j Hj. assert (Zj : 0 < z ^ S j) by (apply pow_lt; auto). assert (Xj : 0 < x ^ S j) by (apply pow_lt; auto).
      assert (Q : x ^ S j <= exp 1 * z ^ S j).
      { assert (Qn : 0 < x ^ (S n - S j)) by (apply pow_lt; auto). assert (Zn : 0 < z ^ (S n - S j)) by (apply pow_lt; auto).
        assert (Zx : z ^ (S n - S j) <= x ^ (S n - S j)) by (apply pow_incr; unfold x; lra).
        apply (Rmult_le_reg_r (x ^ (S n - S j))); auto. rewrite <- pow_add. replace (S j + (S n - S j))%nat with (S n) by lia.
        eapply Rle_trans. apply Small. replace (S n) with (S j + (S n - S j))%nat at 1 by lia. rewrite pow_add.
        rewrite <- Rmult_assoc. apply Rmult_le_compat_l; auto. apply Rmult_le_pos; lra. }
      specialize (M0 j). apply (Rmult_le_reg_r (x ^ S j * z ^ S j)). apply Rmult_lt_0_compat; auto.
      replace (m j / z ^ j * (x ^ S j * z ^ S j)) with (m j * z * x ^ S j) by (simpl; field; apply Rgt_not_eq, pow_lt; auto).
      replace (exp 1 * z * (m j / x ^ S j) * (x ^ S j * z ^ S j)) with (m j * z * (exp 1 * z ^ S j)) by (field; lra).
      apply Rmult_le_compat_l; auto. apply Rmult_le_pos; lra. }
    specialize (Part (S n)). assert (Last : 0 <= it (S n) / x ^ S n). { apply Rmult_le_pos. apply Non. left. apply Rinv_0_lt_compat, pow_lt; auto. }
    eapply Rle_trans. apply Terms. apply Rle_trans with (exp 1 * z * (B / kappa / (y * d1))).
    - apply Rmult_le_compat_l. apply Rmult_le_pos; lra. lra.
    - right. unfold C, y. field. repeat split; lra. }
  assert (Bound : forall n, m n / z ^ n <= INR (3 * cc + 2) * ((2 * C) * (2 * C))).
  { apply average_bounded; auto.
    - intros n. apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat, pow_lt; auto.
    - apply pos_INR.
    - intros n k. assert (T := moments_product k n). assert (Zn : 0 < z ^ n) by (apply pow_lt; auto). assert (Zk : 0 < z ^ k) by (apply pow_lt; auto).
      rewrite pow_add. apply (Rmult_le_reg_r (z ^ n * z ^ k)). apply Rmult_lt_0_compat; auto.
      replace (m (n + k)%nat / (z ^ n * z ^ k) * (z ^ n * z ^ k)) with (m (n + k)%nat) by (field; lra).
      replace (INR (3 * cc + 2) * (m n / z ^ n * (m k / z ^ k)) * (z ^ n * z ^ k)) with (INR (3 * cc + 2) * (m k * m n)) by (field; lra). exact T. }
  assert (Gz : growth (size F) (count F) (real F) z).
  { apply (moments_growth F s WF Sq z Zp). exists (INR (3 * cc + 2) * ((2 * C) * (2 * C))). intros n. fold m. rewrite Rabs_pos_eq by auto.
    assert (Zn : 0 < z ^ n) by (apply pow_lt; auto). specialize (Bound n). apply (Rmult_le_compat_r (z ^ n)) in Bound; [|lra].
    replace (m n / z ^ n * z ^ n) with (m n) in Bound by (field; lra). exact Bound. }
  intros r Hr R0. apply (growth_mono _ _ _ z); auto. lra.
Qed.
End Sharp.
