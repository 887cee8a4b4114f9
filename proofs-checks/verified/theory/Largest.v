(* With one spectral radius, what it is exactly: the largest zero of the recurrence, and a pole of the generating function
   of the middle coefficients. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Existence Integers Sections Subdivision Coefficients Growth Squares Single Descartes
  Complex Number.
Import ListNotations.
Open Scope Z_scope.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

(* The middle coefficients of the first n powers, times d^(n - 1) *)
Fixpoint middles (M : zmat) (d : Z) (r : nat) (x : zvec) (n : nat) : list Z :=
  match n with O => [] | S k => nth r x 0 * d ^ Z.of_nat k :: middles M d r (mv M x) k end.

(* The polynomial part of q(x) (m_0 / x + m_1 / x^2 + ...) *)
Fixpoint numerator (q middles : list Z) : list Z := match q with [] => [] | _ :: q' => dot q' middles :: numerator q' middles end.

Fixpoint zpower_times (l : nat) (p q : list Z) : list Z := match l with O => q | S k => zproduct_of p (zpower_times k p q) end.

(* The recurrence, and one that the middle coefficients satisfy, too: polynomial^multiplicity * cofactor. Both in their own way. *)
Record pole := Pole { squares_of : squares; recurrence : list Z; multiplicity : nat; cofactor : list Z }.
Definition reduced (p : list Z) (c : pole) : list Z := zpower_times (multiplicity c) p (cofactor c).
Definition middles_of (F : family) (p : list Z) (c : pole) : list Z :=
  let b := symbol (squares_of c) in let r := reach_of (count F) b in
  middles (central_matrix (count F) b) (denominator F) r (unit_at 1 r) (length (recurrence c) + length (reduced p c)).

Definition satisfies (p q middles : list Z) : bool :=
  negb (last p 0 =? 0) && forallb (fun n => dot q (skipn n middles) =? 0) (seq 0 (length p - 1)).

Definition pole_right (F : family) (p : list Z) (c : pole) : bool :=
  sum_of_squares F (squares_of c) && recurs F (symbol (squares_of c)) (recurrence c) &&
  satisfies (recurrence c) (reduced p c) (middles_of F p c).

Definition no_larger (F : family) (p : list Z) (h : place) (c : pole) : bool :=
  let q := reduced p c in
  pole_right F p c && (multiplicity c <? length q)%nat &&
  (sign_count (map Z.sgn (snd (shifted_by (low h) (bottom h) q))) <=? multiplicity c)%nat.

(* The value of p at the zero is not 0. *)
Definition not_zero (p : list Z) (h : place) : bool :=
  let s := near_scale h in let x := (near_re h, near_im h) in
  let m := Z.abs (near_re h) + Z.abs (near_im h) + 2 * near_radius h in
  let v := fst (snd (taylor s x p)) in let d := fst (snd (snd (majorants s m p))) in
  (2 * near_radius h * d) * (2 * near_radius h * d) <? s * s * zsquare v.

Definition is_pole (F : family) (p : list Z) (h : place) (c : pole) : bool :=
  pole_right F p c && (1 <=? multiplicity c)%nat && not_zero (numerator (reduced p c) (middles_of F p c)) h.

(* ---- why that proves it ------------------------------------------------------------------------------------------ *)

Lemma reals_product p q : reals (zproduct_of p q) = product_of (reals p) (reals q).
Proof.
  induction p; auto. cbn [zproduct_of]. rewrite reals_addmul. change (reals (0 :: zproduct_of p q)) with (0%R :: reals (zproduct_of p q)).
  rewrite IHp. reflexivity.
Qed.

Lemma reals_power_times l p q : reals (zpower_times l p q) = power_times l (reals p) (reals q).
Proof. induction l; auto. cbn [zpower_times power_times]. rewrite reals_product, IHl. auto. Qed.

Lemma value_real p x : value p (real_number x) = real_number (pvalue (reals p) x).
Proof.
  induction p; auto. cbn [value reals map pvalue]. fold (reals p). rewrite IHp. unfold cplus, ctimes, real_number; simpl. f_equal; ring.
Qed.

Lemma pshift_value p x : nth 0 (pshift x p) 0%R = pvalue p x.
Proof. induction p; auto. rewrite nth_pshift. cbn [pvalue]. rewrite IHp. auto. Qed.

Lemma along_dot q m : forall n l kappa, (forall i, (i < length q)%nat -> IZR (nth i l 0) = (kappa * m (n + i)%nat)%R) ->
  IZR (dot q l) = (kappa * along 0 (reals q) m n)%R.
Proof.
  induction q as [|c q IH]; intros n l kappa H. simpl. ring.
  destruct l as [|a l].
  - assert (Z : forall i, (i < length (c :: q))%nat -> (kappa * m (n + i)%nat = 0)%R). { intros i Hi. rewrite <- H by auto. rewrite nth_nil. auto. }
    rewrite dot_nil. symmetry. clear H IH. revert n Z. generalize (c :: q). intros p. induction p as [|a p IH]; intros n Z. simpl. ring.
    cbn [reals map along]. fold (reals p). unfold step. assert (Z0 := Z O ltac:(simpl; lia)). rewrite Nat.add_0_r in Z0.
    assert (I := IH (S n) ltac:(intros i Hi; specialize (Z (S i) ltac:(simpl; lia)); rewrite Nat.add_succ_r in Z; exact Z)).
    replace (kappa * (IZR a * m n + (along 0 (reals p) m (S n) - 0 * along 0 (reals p) m n)))%R
      with (IZR a * (kappa * m n) + kappa * along 0 (reals p) m (S n))%R by ring. rewrite Z0, I. ring.
  - cbn [dot reals map along]. fold (reals q). rewrite plus_IZR, mult_IZR, (IH (S n) l kappa).
    + assert (H0 := H O ltac:(simpl; lia)). rewrite Nat.add_0_r in H0. simpl nth in H0. rewrite H0. unfold step. ring.
    + intros i Hi. specialize (H (S i) ltac:(simpl; lia)). rewrite Nat.add_succ_r in H. exact H.
Qed.

Lemma tl_pshift x c p i : nth i (tl (pshift x (c :: p))) 0%R = (nth i (pshift x p) 0 + x * nth i (tl (pshift x p)) 0)%R.
Proof.
  assert (T : forall l : list R, nth i (tl l) 0%R = nth (S i) l 0%R) by (intros [|a l]; auto; destruct i; auto).
  rewrite !T, nth_pshift. auto.
Qed.

Lemma along_nth u p : forall q f n, (forall i, nth i p 0%R = nth i q 0%R) -> along u p f n = along u q f n.
Proof.
  induction p as [|a p IH]; intros q f n H.
  - revert n. induction q as [|b q IH]; intros n; auto. assert (H0 := H O). simpl in H0. subst b. cbn [along]. unfold step.
    assert (E : forall k, along u [] f k = along u q f k) by (intros; apply IH; intros i; specialize (H (S i)); simpl in H; destruct i; auto).
    rewrite <- !E. cbn [along]. ring.
  - destruct q as [|b q].
    + assert (H0 := H O). simpl in H0. subst a. cbn [along]. unfold step.
      assert (E : forall k, along u p f k = along u [] f k) by (intros; apply IH; intros i; specialize (H (S i)); simpl in H; destruct i; auto).
      rewrite !E. cbn [along]. ring.
    + assert (H0 := H O). simpl in H0. subst b. cbn [along]. unfold step. rewrite !(IH q) by (intros i; apply (H (S i))). auto.
Qed.

Lemma numerator_value q m l kappa x : (forall i, (i < length q)%nat -> IZR (nth i l 0) = (kappa * m i)%R) ->
  pvalue (reals (numerator q l)) x = (kappa * along x (tl (pshift x (reals q))) m 0)%R.
Proof.
  intros H. induction q as [|c q IH]. simpl. ring.
  cbn [numerator]. change (reals (dot q l :: numerator q l)) with (IZR (dot q l) :: reals (numerator q l)). cbn [pvalue].
  rewrite IH by (intros i Hi; apply H; simpl; lia). rewrite (along_dot q m 0 l kappa) by (intros i Hi; apply H; simpl; lia).
  rewrite (along_nth x (tl (pshift x (reals (c :: q)))) (padd (pshift x (reals q)) (pscal x (tl (pshift x (reals q)))))).
  - rewrite along_add, along_pscal. assert (E := along_shift 0 x (reals q) m 0). rewrite Rplus_0_l in E. rewrite E. ring.
  - intros i. change (reals (c :: q)) with (IZR c :: reals q). rewrite tl_pshift, nth_padd, nth_pscal. auto.
Qed.

Lemma along_last p c f : forall n, along 0 (p ++ [c]) f n = (along 0 p f n + c * f (n + length p)%nat)%R.
Proof.
  induction p; intros n; cbn [app along length]. rewrite Nat.add_0_r. unfold step. ring.
  unfold step. rewrite !IHp. replace (n + S (length p))%nat with (S n + length p)%nat by lia. ring.
Qed.

Lemma along_vanishing p f n : (forall i, (i < length p)%nat -> f (n + i)%nat = 0%R) -> along 0 p f n = 0%R.
Proof.
  revert n. induction p; intros n H; auto. cbn [along]. unfold step. assert (H0 := H O ltac:(simpl; lia)). rewrite Nat.add_0_r in H0. rewrite H0.
  rewrite (IHp (S n)). ring. intros i Hi. specialize (H (S i) ltac:(simpl; lia)). rewrite Nat.add_succ_r in H. exact H.
Qed.

Lemma recurrence_zero p w : last p 0 <> 0 -> (forall n, along 0 (reals p) w n = 0%R) ->
  (forall n, (n < length p - 1)%nat -> w n = 0%R) -> forall n, w n = 0%R.
Proof.
  intros Hl H Start. destruct p as [|a p']. simpl in Hl. congruence.
  destruct (exists_last (l := a :: p') ltac:(discriminate)) as [p [c E]]. rewrite E in *. clear a p' E. rewrite last_last in Hl. rewrite app_length in Start. simpl in Start.
  induction n as [n IH] using lt_wf_ind. destruct (lt_dec n (length p)) as [L|L]. apply Start. lia.
  specialize (H (n - length p)%nat). unfold reals in H. rewrite map_app in H. cbn [map] in H. rewrite along_last, map_length in H.
  replace (n - length p + length p)%nat with n in H by lia. rewrite along_vanishing in H.
  - rewrite Rplus_0_l in H. apply Rmult_integral in H. destruct H as [H|H]; auto. apply eq_IZR in H. lia.
  - intros i Hi. rewrite map_length in Hi. apply IH. lia.
Qed.

Section Pole.
Variables (F : family) (p : list Z) (c : pole).
Hypothesis WF : well_formed F = true.
Hypothesis Right : pole_right F p c = true.
Let s := squares_of c.
Let A := count F.
Let b := symbol s.
Let r := reach_of A b.
Let M := central_matrix A b.
Let D := denominator F.
Let q := reduced p c.

Lemma pole_facts : sum_of_squares F s = true /\ recurs F b (recurrence c) = true /\ satisfies (recurrence c) q (middles_of F p c) = true.
Proof. assert (H := Right). unfold pole_right in H. repeat rewrite andb_true_iff in H. tauto. Qed.

Let Sq := proj1 pole_facts.
Let m := moments F s.

Lemma middles_sound : forall n x j, (forall i, against F s x (powers F s i) = (IZR D ^ j * m (i + j)%nat)%R) ->
  forall i, (i < n)%nat -> IZR (nth i (middles M D r x n) 0) = (IZR D ^ (j + n - 1) * m (j + i)%nat)%R.
Proof.
  induction n as [|n IH]; intros x j H i Hi. lia. cbn [middles]. destruct i.
  - simpl nth. rewrite mult_IZR, <- pow_IZR. assert (H0 := H O). replace (j + S n - 1)%nat with (j + n)%nat by lia. rewrite Nat.add_0_r.
    replace (IZR (nth r x 0)) with (against F s x (powers F s 0)). rewrite H0, pow_add. simpl. ring.
    unfold against. change (powers F s 0) with delta. fold A b r.
    rewrite (sum_ext _ _ (fun i => identity i r * vr x i)%R). rewrite sum_identity by lia. auto.
    intros i _. unfold delta, identity. fold A b r. destruct (Z.eqb_spec (Z.of_nat i - Z.of_nat r) 0), (Nat.eqb_spec i r); try (exfalso; lia); ring.
  - simpl nth. rewrite (IH _ (S j)).
    + f_equal; f_equal; lia.
    + intros k. assert (St := against_step F s WF Sq x (powers F s k)). assert (PD := D_positive F WF).
      change (against F s x (powers F s (S k)) = / IZR D * against F s (mv M x) (powers F s k))%R in St. rewrite H in St.
      apply (Rmult_eq_reg_l (/ IZR D)); [|apply Rinv_neq_0_compat; apply Rgt_not_eq; auto]. rewrite <- St. simpl. rewrite Nat.add_succ_r. field.
      apply Rgt_not_eq. auto.
    + lia.
Qed.

Let K := (length (recurrence c) + length q)%nat.
Let kappa := (IZR D ^ (K - 1))%R.

Lemma middles_right i : (i < K)%nat -> IZR (nth i (middles_of F p c) 0) = (kappa * m i)%R.
Proof.
  intros Hi. unfold middles_of. cbv zeta. fold s b A r M D q K.
  rewrite (middles_sound K (unit_at 1 r) 0); auto. intros k. unfold m, moments. rewrite (against_unit F s). rewrite Nat.add_0_r. simpl. ring.
Qed.

Lemma kappa_positive : (0 < kappa)%R.
Proof. apply pow_lt. apply (D_positive F WF). Qed.

Lemma reduced_recurs : forall n, along 0 (reals q) m n = 0%R.
Proof.
  assert (Facts := pole_facts). destruct Facts as [HS [HR HV]]. unfold satisfies in HV. apply andb_prop in HV. destruct HV as [HL HV]. apply negb_true_iff, Z.eqb_neq in HL.
  rewrite forallb_forall in HV. assert (KP := kappa_positive).
  apply (recurrence_zero (recurrence c)); auto.
  - intros n. rewrite along_commute. replace (along 0 (reals (recurrence c)) m) with (fun _ : nat => 0%R). apply along_zero.
    extensionality i. symmetry. apply (recurs_sound F s WF HS (recurrence c) HR).
  - intros n Hn. specialize (HV n ltac:(apply in_seq; lia)). apply Z.eqb_eq in HV.
    assert (E := along_dot q m n (skipn n (middles_of F p c)) kappa). rewrite HV in E.
    assert (E' : (0 = kappa * along 0 (reals q) m n)%R).
    { apply E. intros i Hi. assert (NS : nth i (skipn n (middles_of F p c)) 0 = nth (n + i) (middles_of F p c) 0).
      { clear. generalize (middles_of F p c). induction n; intros l; auto. destruct l; simpl; auto. destruct i; auto. }
      rewrite NS. apply middles_right. unfold K. lia. }
    symmetry in E'. apply Rmult_integral in E'. destruct E'; auto. lra.
Qed.

Variables (h : place) (z : R).
Hypothesis Zero : pvalue (reals p) z = 0%R.
Hypothesis Zp : (0 < z)%R.

Lemma reduced_order : forall i, (i < multiplicity c)%nat -> nth i (pshift z (reals q)) 0%R = 0%R.
Proof.
  intros i Hi. unfold q, reduced. rewrite reals_power_times. apply (zero_order z (reals p) (reals (cofactor c))) with (l := multiplicity c); auto.
  rewrite pshift_value. auto.
Qed.

Lemma sign_sgn x y : (0 < y)%R -> forall w v, (0 < v)%R -> (IZR x * y = v * w)%R -> sign_of w = Z.sgn x.
Proof.
  intros Hy w v Hv E. destruct (sign_cases w) as [[P Q]|[[P Q]|[P Q]]]; rewrite Q; symmetry.
  - assert (X : IZR x = 0%R). { subst w. rewrite Rmult_0_r in E. apply Rmult_integral in E. destruct E; lra. } apply eq_IZR in X. subst x. auto.
  - apply Z.sgn_pos_iff. apply lt_IZR. assert (0 < v * w)%R by (apply Rmult_lt_0_compat; auto). rewrite <- E in H.
    apply (Rmult_lt_reg_r y); auto. lra.
  - apply Z.sgn_neg_iff. apply lt_IZR. assert (0 < v * - w)%R by (apply Rmult_lt_0_compat; lra).
    apply (Rmult_lt_reg_r y); auto. lra.
Qed.

Lemma shifted_length a d l : length (snd (shifted_by a d l)) = length l.
Proof.
  induction l; auto. cbn [shifted_by]. destruct (shifted_by a d l) as [k t]. cbn [snd] in *.
  assert (L : forall x y, length (addmul a x y) = Nat.max (length x) (length y)).
  { induction x; intros y; auto. destruct y; cbn [addmul length]; rewrite IHx; simpl; lia. }
  rewrite L. simpl. rewrite IHl. lia.
Qed.

Lemma signs_shifted a d l : 0 < d -> signs (pshift (IZR a / IZR d) (reals l)) = map Z.sgn (snd (shifted_by a d l)).
Proof.
  intros Hd. assert (S := shifted_sound a d l Hd). assert (L := shifted_length a d l). destruct (shifted_by a d l) as [k t]. destruct S as [K0 S]. cbn [snd] in *.
  apply IZR_lt in Hd. unfold signs. apply (nth_ext _ _ 0 0). rewrite !map_length, length_pshift. unfold reals. rewrite map_length. auto.
  intros i _. rewrite <- sign_zero at 1. change 0 with (Z.sgn 0) at 2. rewrite !map_nth. apply (sign_sgn _ (IZR d ^ i) ltac:(apply pow_lt; auto) _ (IZR k) K0). apply S.
Qed.

Theorem no_larger_sound : (IZR (low h) / IZR (bottom h) <= z)%R -> 0 < bottom h -> no_larger F p h c = true ->
  radius_at_most (size F) (count F) (real F) z.
Proof.
  intros Hlow Hb H. unfold no_larger in H. cbv zeta in H. fold q in H. repeat rewrite andb_true_iff in H. destruct H as [[_ H1] H2].
  apply Nat.ltb_lt in H1. apply Nat.leb_le in H2. rewrite <- signs_shifted in H2 by auto.
  destruct (largest_zero _ z (multiplicity c) (reals q) Hlow reduced_order ltac:(rewrite reals_length; auto) H2) as [g [Hg [N P]]].
  assert (E : pscal (IZR g) (reals q) = reals (map (Z.mul g) q)). { unfold pscal, reals. rewrite !map_map. apply map_ext. intros. rewrite mult_IZR. auto. }
  rewrite E in N, P. apply (single_bound F s WF Sq (map (Z.mul g) q)); auto; [|lra].
  intros n. rewrite <- E, along_pscal. fold m. rewrite reduced_recurs. ring.
Qed.

Lemma not_zero_sound l x : (0 < IZR (near_scale h))%R -> (0 <= IZR (near_radius h))%R -> not_zero l h = true ->
  (Rabs (fst x - IZR (near_re h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h))%R ->
  (Rabs (snd x - IZR (near_im h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h))%R -> value l x <> real_number 0.
Proof.
  intros Hs Hr H N1 N2 V. unfold not_zero in H. cbv zeta in H. set (sc := near_scale h) in *. assert (Sz : 0 < sc) by (apply lt_IZR; auto).
  set (mm := Z.abs (near_re h) + Z.abs (near_im h) + 2 * near_radius h) in *.
  destruct (taylor sc (near_re h, near_im h) l) as [k [v d]] eqn:ET. assert (Mj := majorants_sound sc Sz mm l).
  destruct (majorants sc mm l) as [k' [v' [d' w']]]. cbv zeta in Mj. cbn [fst snd] in H. destruct Mj as [K' [_ [D' _]]].
  destruct (taylor_abs sc Sz _ _ _ _ _ ET) as [KP [KL [VA _]]]. cbn [fst snd] in VA.
  set (cc := complex_over (near_re h) (near_im h) sc) in *. set (R0 := (IZR mm / IZR sc)%R) in *.
  assert (Dz : (cabs (cminus x cc) <= 2 * (IZR (near_radius h) / IZR sc))%R).
  { eapply Rle_trans. apply cabs_sum. unfold cminus, cc, complex_over; simpl. lra. }
  assert (Oc := over_abs (near_re h) (near_im h) sc Sz). fold cc in Oc.
  assert (Bc : (cabs cc <= R0)%R).
  { eapply Rle_trans. apply Oc. unfold R0, mm, Rdiv. apply Rmult_le_compat_r. left; apply Rinv_0_lt_compat; auto. rewrite !plus_IZR, mult_IZR. lra. }
  assert (Bx : (cabs x <= R0)%R).
  { replace x with (cplus (cminus x cc) cc) by ring. eapply Rle_trans. apply cabs_plus. unfold R0, mm. rewrite !plus_IZR, mult_IZR. unfold Rdiv in *. lra. }
  assert (Diff := value_difference l x cc). rewrite V in Diff. apply (f_equal cabs) in Diff. rewrite cabs_times in Diff.
  assert (Neg : cabs (cminus (real_number 0) (value l cc)) = cabs (value l cc)).
  { unfold cabs, modulus, cminus, real_number; simpl. f_equal. ring. }
  rewrite Neg in Diff. assert (Sb := slope_bounded l R0 x cc Bx Bc). set (sb := slope_bound l R0) in *.
  assert (U : (cabs (value l cc) <= 2 * (IZR (near_radius h) / IZR sc) * sb)%R).
  { rewrite Diff. apply Rmult_le_compat; auto; apply cabs_nonneg. }
  apply Z.ltb_lt, IZR_lt in H. rewrite !mult_IZR, D', K', <- KL, VA in H.
  set (a := cabs (value l cc)) in *. assert (A0 : (0 <= a)%R) by apply cabs_nonneg.
  apply (Rmult_le_compat_l (IZR sc * IZR k)) in U; [|left; apply Rmult_lt_0_compat; auto].
  replace (IZR sc * IZR k * (2 * (IZR (near_radius h) / IZR sc) * sb))%R with (2 * IZR (near_radius h) * (IZR k * sb))%R in U by (field; lra).
  assert (U2 : (IZR sc * IZR k * a * (IZR sc * IZR k * a) <= 2 * IZR (near_radius h) * (IZR k * sb) * (2 * IZR (near_radius h) * (IZR k * sb)))%R).
  { assert (0 <= IZR sc * IZR k * a)%R by (apply Rmult_le_pos; auto; left; apply Rmult_lt_0_compat; auto). apply Rmult_le_compat; auto. }
  replace (IZR sc * IZR sc * (IZR k * a) ^ 2)%R with (IZR sc * IZR k * a * (IZR sc * IZR k * a))%R in H by ring. lra.
Qed.

Theorem is_pole_sound : (0 < IZR (near_scale h))%R -> (0 <= IZR (near_radius h))%R ->
  (Rabs (z - IZR (near_re h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h))%R ->
  (Rabs (0 - IZR (near_im h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h))%R ->
  is_pole F p h c = true -> radius_at_least (size F) (count F) (real F) z.
Proof.
  intros Hs Hr N1 N2 H. unfold is_pole in H. fold q in H. repeat rewrite andb_true_iff in H. destruct H as [[_ H1] H2]. apply Nat.leb_le in H1.
  assert (NZ := not_zero_sound _ (real_number z) Hs Hr H2 N1 N2). rewrite value_real in NZ.
  rewrite (numerator_value q m _ kappa) in NZ by (intros i Hi; apply middles_right; unfold K; lia).
  set (w := along z (tl (pshift z (reals q))) m) in *.
  assert (W0 : w O <> 0%R). { intros E. apply NZ. rewrite E. f_equal. ring. }
  assert (Ex : pshift z (reals q) = 0%R :: tl (pshift z (reals q))).
  { assert (O0 := reduced_order O ltac:(lia)). destruct (pshift z (reals q)) as [|a l] eqn:E.
    - exfalso. apply W0. unfold w. reflexivity.
    - simpl in O0. subst a. auto. }
  assert (Wn : forall n, w n = (z ^ n * w O)%R).
  { induction n. simpl. ring. assert (S := along_shift 0 z (reals q) m n). rewrite reduced_recurs, Rplus_0_l, Ex in S. cbn [along] in S. fold w in S.
    unfold step in S. simpl pow. rewrite Rmult_assoc, <- IHn. lra. }
  intros g Hg G. apply Rnot_lt_le. intros L. set (g' := ((g + z) / 2)%R). assert (G' : (0 < g')%R) by (unfold g'; lra).
  assert (GM : growth (size F) (count F) (real F) g').
  { apply (growth_mono _ _ _ g); auto. unfold g'. lra. }
  apply (moments_growth F s WF Sq g' G') in GM. fold m in GM. apply (grows_along z (tl (pshift z (reals q)))) in GM. fold w in GM. destruct GM as [C HC].
  assert (V : (Rabs (w O) <= 0)%R).
  { apply (vanishing _ C (g' / z)).
    - assert (0 < / z)%R by (apply Rinv_0_lt_compat; auto). split. apply Rmult_le_pos; lra. apply (Rmult_lt_reg_r z); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. unfold g'. lra.
    - intros k. specialize (HC k). rewrite Wn, Rabs_mult, Rabs_pos_eq in HC by (apply pow_le; lra). assert (ZK : (0 < z ^ k)%R) by (apply pow_lt; auto).
      apply (Rmult_le_reg_l (z ^ k)); auto. unfold Rdiv. rewrite Rpow_mult_distr, pow_inv by lra.
      replace (z ^ k * (C * (g' ^ k * / z ^ k)))%R with (C * g' ^ k)%R by (field; lra). auto. }
  apply W0. destruct (Req_dec (w O) 0); auto. apply Rabs_pos_lt in H. lra.
Qed.
End Pole.
