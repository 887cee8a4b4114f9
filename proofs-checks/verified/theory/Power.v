(* The first power of a logarithm: differences of the order of an integer exponent grow like n. From above that follows from
   the differences of one order more, from below from a double pole of the middle coefficients at 1. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Integers Sections Subdivision Coefficients Growth Squares Single Descartes Complex Number
  Largest.
Import ListNotations.
Open Scope R_scope.

Lemma smooth_growth_one A F L K c D : (2 <= A)%nat -> supported F K c -> (K + A - 1 <= L)%nat -> total F L c = INR A ->
  (forall n i, Rabs (refined A F L c n i) <= D * INR A ^ n) ->
  exists D', forall n i, Rabs (refined A F L (smooth A c) n i) <= D' * INR (n + 1).
Proof.
  intros Arity H HK Ht HD. assert (PA := arity_positive A Arity).
  assert (HD0 : 0 <= D). { specialize (HD O 0%Z). simpl in HD. assert (X := Rabs_pos (delta 0)). lra. }
  assert (Dif : forall n i, Rabs (refined A F L (smooth A c) n i - refined A F L (smooth A c) n (i - 1)%Z) <= 2 * D).
  { intros n i. rewrite (refined_difference A F L Arity K) by auto. rewrite Rabs_mult. assert (PN : 0 < INR A ^ n) by (apply pow_lt; auto).
    rewrite Rabs_pos_eq by (left; apply Rinv_0_lt_compat; auto). apply (Rmult_le_reg_l (INR A ^ n)); auto. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra.
    unfold Rminus. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. generalize (HD n i) (HD n (i - Z.of_nat A ^ Z.of_nat n)%Z). unfold Z.sub. lra. }
  destruct (step_near A F L Arity _ (smooth A c) (supported_smooth A F Arity K c H) (fun i => smooth_classes A F L Arity K c i H HK Ht)) as [C [HC Near]].
  exists (1 + C * (2 * D)). assert (G : 0 <= C * (2 * D)) by (apply Rmult_le_pos; lra). induction n; intros i.
  - simpl. unfold delta. destruct (Z.eqb i 0); [rewrite Rabs_R1 | rewrite Rabs_R0]; lra.
  - cbn [refined]. specialize (Near _ _ (Dif n) i). specialize (IHn (i / Z.of_nat A)%Z).
    set (y := subdivide A F L (smooth A c) (refined A F L (smooth A c) n) i) in *. set (x := refined A F L (smooth A c) n (i / Z.of_nat A)%Z) in *.
    replace y with ((y - x) + x) by lra. eapply Rle_trans. apply Rabs_triang. change (S n + 1)%nat with (S (n + 1)). rewrite S_INR. lra.
Qed.

Lemma smoothed_add A j k b : smoothed A (j + k) b = smoothed A j (smoothed A k b).
Proof. induction j; auto. simpl. rewrite IHj. auto. Qed.

Fixpoint zvalue (p : list Z) (x : Z) : Z := match p with [] => 0%Z | c :: p' => (c + x * zvalue p' x)%Z end.

Lemma zvalue_real p x : pvalue (reals p) (IZR x) = IZR (zvalue p x).
Proof. induction p; auto. cbn [reals map pvalue zvalue]. fold (reals p). rewrite IHp, plus_IZR, mult_IZR. auto. Qed.

Section Linear.
Variables (F : family) (c : pole).
Hypothesis WF : well_formed F = true.
Let one := [(-1)%Z; 1%Z].
Hypothesis Right : pole_right F one c = true.
Let s := squares_of c.
Let Sq := proj1 (pole_facts F one c Right).
Let m := moments F s.
Let q := reduced one c.

Lemma moments_step : exists K, 0 <= K /\ forall n, m (S n) <= K * m n.
Proof.
  destruct (facts F s Sq) as [HA _]. set (N := (length (symbol s) - 1)%nat).
  assert (Sup : supported (- Z.of_nat (middle (symbol s))) N (centred F s)).
  { intros i Hi. unfold centred. apply (symbol_support F s Sq). unfold N in Hi. lia. }
  assert (X : exists P, 0 <= P /\ forall i, Rabs (centred F s i) <= P) by (eapply supported_bounded; eauto).
  destruct X as [P [P0 HP]]. exists (INR (S N) * P). split. apply Rmult_le_pos; auto. apply pos_INR.
  intros n. change (m (S n)) with (subdivide (count F) (- Z.of_nat (middle (symbol s))) N (centred F s) (powers F s n) 0).
  eapply Rle_trans. apply Rle_abs. unfold subdivide. eapply Rle_trans. apply sum_abs. rewrite Rmult_assoc. apply sum_bound. intros i _. cbv zeta.
  rewrite Rabs_mult. apply Rmult_le_compat; auto; try apply Rabs_pos. apply (powers_central F s WF Sq).
Qed.

Lemma along_small e : exists C, 0 <= C /\ forall n, Rabs (along 1 e m n) <= C * m n.
Proof.
  assert (M0 : forall n, 0 <= m n) by (apply (moments_nonnegative F s WF Sq)). destruct moments_step as [K [K0 HK]].
  induction e as [|a e [C [C0 IH]]]. exists 0. split. lra. intros n. simpl. rewrite Rabs_R0. lra.
  exists (Rabs a + C * (K + 1)). assert (A0 := Rabs_pos a). split. assert (0 <= C * (K + 1)) by (apply Rmult_le_pos; lra). lra.
  intros n. cbn [along]. unfold step. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_mult, (Rabs_pos_eq (m n)) by auto.
  assert (T : Rabs (along 1 e m (S n) - 1 * along 1 e m n) <= C * m (S n) + C * m n).
  { unfold Rminus. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp, Rmult_1_l. apply Rplus_le_compat; auto. }
  assert (C * m (S n) <= C * (K * m n)) by (apply Rmult_le_compat_l; auto). lra.
Qed.

Theorem moments_linear c0 : multiplicity c = 2%nat -> zvalue (numerator q (middles_of F one c)) 1 <> 0%Z -> 0 < c0 ->
  (forall n, (1 <= n)%nat -> c0 <= m n) -> exists k, 0 < k /\ forall n, (1 <= n)%nat -> k * INR n <= m n.
Proof.
  intros Twice NZ C0 Least. assert (M0 : forall n, 0 <= m n) by (apply (moments_nonnegative F s WF Sq)).
  assert (Z1 : pvalue (reals one) 1 = 0) by (simpl; ring).
  assert (Order := reduced_order one c 1 Z1). rewrite Twice in Order. fold q in Order. set (d := pshift 1 (reals q)) in *.
  set (e := tl (tl d)). assert (O0 := Order 0%nat ltac:(lia)). assert (O1 := Order 1%nat ltac:(lia)).
  assert (Td : forall i, nth i (tl d) 0 = nth i (0 :: e) 0).
  { unfold e. intros i. destruct d as [|x [|y l]]; simpl in *; destruct i; auto; try (destruct i; auto). }
  assert (Dd : forall i, nth i d 0 = nth i (0 :: 0 :: e) 0).
  { unfold e. intros i. destruct d as [|x [|y l]]; simpl in *; destruct i as [|[|i]]; auto; destruct i; auto. }
  set (w := along 1 e m). set (v := step 1 w).
  assert (Vt : forall n, along 1 (tl d) m n = v n). { intros n. rewrite (along_nth 1 (tl d) (0 :: e) m n Td). cbn [along]. fold w v. ring. }
  assert (Vd : forall n, step 1 v n = 0).
  { intros n. assert (S := along_shift 0 1 (reals q) m n). rewrite Rplus_0_l in S. fold d in S. unfold m, s in S. rewrite (reduced_recurs F one c WF Right) in S. fold s m in S.
    rewrite (along_nth 1 d (0 :: 0 :: e) m n Dd) in S. cbn [along] in S. fold w in S.
    replace (fun n0 : nat => 0 * m n0 + step 1 w n0) with v in S by (extensionality j; unfold v; ring). lra. }
  assert (Vn : forall n, v n = v O). { induction n; auto. specialize (Vd n). unfold step in Vd. lra. }
  assert (B : v O <> 0).
  { intros E. apply NZ. apply eq_IZR. rewrite <- zvalue_real.
    rewrite (numerator_value q m _ (IZR (denominator F) ^ (length (recurrence c) + length q - 1))) by (intros i Hi; apply (middles_right F one c WF Right); fold q; lia).
    fold d. rewrite Vt, E. ring. }
  assert (Wn : forall n, w n = w O + INR n * v O).
  { induction n. simpl. ring. assert (V := Vn n). unfold v at 1 in V. unfold step in V. rewrite S_INR. lra. }
  destruct (along_small e) as [C [C1 HC]]. fold w in HC. set (T := C + Rabs (w O) / c0 + 1).
  assert (Q0 : 0 <= Rabs (w O) / c0). { apply Rmult_le_pos. apply Rabs_pos. left. apply Rinv_0_lt_compat; auto. }
  assert (T0 : 0 < T) by (unfold T; lra). assert (B0 : 0 < Rabs (v O)) by (apply Rabs_pos_lt; auto).
  exists (Rabs (v O) / T). split. apply Rdiv_lt_0_compat; auto. intros n Hn. specialize (HC n). specialize (Least n Hn). assert (Mn := M0 n).
  assert (L : INR n * Rabs (v O) <= Rabs (w n) + Rabs (w O)).
  { rewrite <- (Rabs_pos_eq (INR n)) by apply pos_INR. rewrite <- Rabs_mult. replace (INR n * v O) with (w n + - w O) by (rewrite (Wn n); ring).
    eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. lra. }
  assert (U : Rabs (w O) <= Rabs (w O) / c0 * m n).
  { replace (Rabs (w O)) with (Rabs (w O) / c0 * c0) at 1 by (field; lra). apply Rmult_le_compat_l; auto. }
  apply (Rmult_le_reg_r T); auto. replace (Rabs (v O) / T * INR n * T) with (INR n * Rabs (v O)) by (field; lra). unfold T. lra.
Qed.
End Linear.
