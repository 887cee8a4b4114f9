(* What a radius or an exponent is exactly: the checkers, and the theorems that what they accept is true. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Upper Blocks Integers Sections Eigenvalue Graph Single Check Complex Number Attained Cycles
  Largest Subdivision Coefficients Growth Stability Exponent Enclosure.
Import ListNotations.
Open Scope Z_scope.

(* ---- claims ------------------------------------------------------------------------------------------------------ *)

(* The polynomial has one zero in the disc. *)
Definition one_number (e : exact_number) : Prop := exists z, is_zero_of e z /\ forall y, is_zero_of e y -> y = z.
Definition within (lower upper : option Q) (x : R) : Prop :=
  (forall l, lower = Some l -> (real_of l <= x)%R) /\ (forall u, upper = Some u -> (x <= real_of u)%R).

(* The joint spectral radius is the number. *)
Definition exact_radius_holds (F : family) (e : exact_number) (lower upper : option Q) : Prop :=
  one_number e /\ exists r, is_number e r /\ is_radius (size F) (count F) (real F) r /\ within lower upper r.

(* The scheme converges, and the supremum s of the exponents of its limit is order less the logarithm of the number, to the
   base arity: arity^(order - s) is the number. *)
Definition exact_exponent_holds (a : scheme) (order : nat) (e : exact_number) (lower upper : option Q) : Prop :=
  one_number e /\ exists phi r s lambda, limit_of a phi /\ is_number e r /\ exp lambda = INR (arity a) /\
  (exp ((INR order - s) * lambda) = r)%R /\ is_lub (exponents phi) s /\ within lower upper s.

(* ---- the checkers ------------------------------------------------------------------------------------------------ *)

(* Of one diagonal block: a bound that is the number at most, a polytope that attains it, a graph that does so in cycles,
   or one spectral radius *)
Inductive exact_section :=
| Bounded (s : section)
| Attains (transposed : bool) (b : body)
| Cyclic (bound : Q) (unity : Z) (firsts : list nat) (group : list element) (turns : list turn) (states : list state)
    (carriers : list base) (cycles : list cycle)
| Leading (c : pole).

(* The zero is real and positive, as cones need it. *)
Definition positive_zero (e : exact_number) (h : place) : bool := (disc_im e =? 0) && (near_radius h <? near_re h).

Definition simple_number (e : exact_number) (h : place) : bool := positive_zero e h && (root e =? 1)%nat.

Definition block_below (e : exact_number) (h : place) (F : family) (s : exact_section) : bool :=
  match s with
  | Bounded s => check_section F (low h # Z.to_pos (bottom h)) s
  | Attains transposed b =>
      (if cone b then positive_zero e h else true) && below (if transposed then transpose F else F) (polynomial e) (root e) h b
  | Cyclic g unity firsts group turns states bs cycles =>
      graph_below F (polynomial e) (root e) h g unity firsts group turns states bs cycles
  | Leading c => simple_number e h && no_larger F (polynomial e) h c
  end.

Definition block_reaches (e : exact_number) (h : place) (F : family) (s : exact_section) : bool :=
  match s with
  | Bounded _ => false
  | Attains transposed b => reached (if transposed then transpose F else F) (polynomial e) (root e) h (bases b) (full_turn b) (first_base b)
  | Cyclic _ _ _ _ _ _ bs _ => reached (transpose F) (polynomial e) (root e) h bs 1 0
  | Leading c => simple_number e h && is_pole F (polynomial e) h c
  end.

Record exact_certificate := Exact { number_place : place; exact_basis : option basis; exact_blocks : list (nat * exact_section) }.

Definition check_blocks (F : family) (e : exact_number) (c : exact_certificate) : bool :=
  let h := number_place c in
  all_blocks (block_below e h) F (exact_blocks c) && some_block (block_reaches e h) F (exact_blocks c).

Definition check_number_and_blocks (F : family) (e : exact_number) (c : exact_certificate) : bool :=
  well_formed F && check_number e (number_place c) &&
  match exact_basis c with
  | None => check_blocks F e c
  | Some b => basis_valid (size F) b && check_blocks (in_basis F b) e c
  end.

Definition check_exact_radius (F : family) (e : exact_number) (lower upper : option Q) (c : exact_certificate) : bool :=
  let h := number_place c in
  check_number_and_blocks F e c &&
  match lower with None => true | Some l => Qnum l * bottom h <=? low h * Zpos (Qden l) end &&
  match upper with None => true | Some u => high h * Zpos (Qden u) <=? Qnum u * bottom h end.

Definition check_exact_exponent (a : scheme) (order : nat) (e : exact_number) (lower upper : option Q) (c : exact_certificate)
    (shifts : stability) : bool :=
  let h := number_place c in let q := Z.to_pos (bottom h) in
  reducible a order && (1 <=? length (coefficients a))%nat && check_stable a shifts &&
  (bottom h <? low h) && (high h <? Z.of_nat (arity a) ^ Z.of_nat order * bottom h) &&
  check_number_and_blocks (difference_family a order) e c &&
  match lower with None => true | Some l => (Qnum l <=? 0) || below_power a l order (high h # q) end &&
  match upper with None => true | Some u => above_power a u order (low h # q) end.

(* ---- why that proves the claims ---------------------------------------------------------------------------------- *)

Definition at_number (F : family) (r : R) : Prop :=
  radius_at_most (size F) (count F) (real F) r /\ radius_at_least (size F) (count F) (real F) r.

Lemma real_of_low x q : 0 < q -> real_of (x # Z.to_pos q) = (IZR x / IZR q)%R.
Proof. intros H. unfold real_of. cbn [Qnum Qden]. rewrite Z2Pos.id; auto. Qed.

Lemma positive_zero_sound e h z : positive_zero e h = true -> (0 < IZR (near_scale h))%R ->
  is_zero_of e z -> (forall y, is_zero_of e y -> y = z) ->
  (Rabs (fst z - IZR (near_re h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h))%R -> z = real_number (cabs z).
Proof.
  intros H S [Zz Ez] U N. unfold positive_zero in H. apply andb_prop in H. destruct H as [H1 H2]. apply Z.eqb_eq in H1. apply Z.ltb_lt, IZR_lt in H2.
  assert (C : conjugate z = z).
  { apply U. split. rewrite value_conjugate, Zz. unfold conjugate, real_number; simpl. f_equal. ring.
    rewrite H1 in *. eapply Rle_trans; [|apply Ez]. right. unfold cabs, modulus, cminus, conjugate, complex_over. simpl.
    replace (0 / IZR (disc_scale e))%R with 0%R by (unfold Rdiv; ring). f_equal. ring. }
  assert (I : snd z = 0%R). { apply (f_equal snd) in C. unfold conjugate in C. simpl in C. lra. }
  assert (P : (0 < fst z)%R).
  { apply (Rmult_lt_compat_r (/ IZR (near_scale h))) in H2; [|apply Rinv_0_lt_compat; auto]. unfold Rdiv in N.
    unfold Rabs in N. destruct (Rcase_abs _) in N; lra. }
  destruct z as [a b]. cbn [fst snd] in *. subst b. unfold real_number, cabs, modulus. cbn [fst snd]. f_equal.
  replace (a * a + 0 * 0)%R with (a * a)%R by ring. symmetry. apply sqrt_square. lra.
Qed.

Lemma transpose_least F l : radius_at_least (size F) (count (transpose F)) (real (transpose F)) l -> radius_at_least (size F) (count F) (real F) l.
Proof.
  intros H r Hr G. apply H; auto. unfold transpose at 1. rewrite count_map.
  apply (growth_ext _ _ (transposed (real F))).
  - intros. symmetry. apply transpose_entry; auto.
  - apply growth_transposed. exact G.
Qed.

Lemma blocks_at_number F e c r : well_formed F = true -> check_number e (number_place c) = true ->
  check_blocks F e c = true -> is_number e r -> at_number F r.
Proof.
  intros WF HN H Hr. set (h := number_place c) in *.
  destruct (check_number_sound e h HN) as [S [Rho [HL [Hlow [Hcom [z' [r' [Iz [Uz [N1 [N2 [R0 [Rp B]]]]]]]]]]]]].
  assert (Er : r = r').
  { destruct Hr as [Pr [y [Iy Ey]]]. rewrite (Uz y Iy), <- Rp in Ey. apply Rle_antisym; apply (pow_le_reg _ _ (root e)); auto; lra. }
  subst r'. assert (Vz := proj1 Iz).
  assert (Sc : 0 < near_scale h) by (apply lt_IZR; auto).
  assert (Sm : 0 <= near_radius h).
  { apply le_IZR. apply (Rmult_le_reg_r (/ IZR (near_scale h))). apply Rinv_0_lt_compat; auto. unfold Rdiv in Rho. lra. }
  apply andb_prop in H. destruct H as [H1 H2].
  assert (TW : forall G (b : bool), well_formed G = true -> well_formed (if b then transpose G else G) = true).
  { intros G [|] W; auto. apply transpose_well_formed; auto. }
  assert (Simple : simple_number e h = true -> z' = real_number r /\ pvalue (reals (polynomial e)) r = 0%R).
  { intros HS. apply andb_prop in HS. destruct HS as [HS HR1]. apply Nat.eqb_eq in HR1. apply (positive_zero_sound e h z') in HS; auto.
    rewrite HR1, pow_1 in Rp. rewrite <- Rp in HS. split; auto. rewrite HS, value_real in Vz. apply (f_equal fst) in Vz. exact Vz. }
  split.
  - revert H1. apply (all_blocks_sound (block_below e h) r); auto. intros G s W HB. destruct s as [s|tr b|g unity firsts group turns states bs cycles|p]; cbn [block_below] in HB.
    + apply section_sound in HB; auto. rewrite real_of_low in HB by auto. intros g Hg H0. apply HB; auto. lra.
    + apply andb_prop in HB. destruct HB as [HC HB].
      assert (Cone : cone b = true -> z' = real_number (cabs z')).
      { intros EC. rewrite EC in HC. apply (positive_zero_sound e h); auto. }
      apply (below_sound _ _ _ _ z' r (TW G tr W) Vz Sc Sm N1 N2 R0 Rp HL Hlow Hcom B b Cone) in HB. apply grows_radius in HB. destruct tr; auto. apply transpose_sound. exact HB.
    + apply grows_radius. apply (graph_below_sound G (polynomial e) (root e) h z' r g unity firsts group turns states bs cycles); auto.
    + apply andb_prop in HB. destruct HB as [HS HB]. apply Simple in HS. destruct HS as [_ HS]. assert (HB' := HB).
      unfold no_larger in HB'. cbv zeta in HB'. repeat rewrite andb_true_iff in HB'. destruct HB' as [[HP _] _].
      apply (no_larger_sound G (polynomial e) p W HP h r HS); auto. apply B.
  - revert H2. apply (some_block_sound (block_reaches e h) r); auto. intros G s W HB. destruct s as [s|tr b|g unity firsts group turns states bs cycles|p]; cbn [block_reaches] in HB. discriminate.
    + apply (reached_sound _ _ _ _ z' r (TW G tr W) Vz Sc Sm N1 N2 R0 Rp HL) in HB. destruct tr; auto. apply transpose_least. exact HB.
    + apply (reached_sound _ _ _ _ z' r (TW G true W) Vz Sc Sm N1 N2 R0 Rp HL) in HB. apply transpose_least. exact HB.
    + apply andb_prop in HB. destruct HB as [HS HB]. apply Simple in HS. destruct HS as [HZ HS]. assert (HB' := HB).
      unfold is_pole in HB'. repeat rewrite andb_true_iff in HB'. destruct HB' as [[HP _] _]. rewrite HZ in N1, N2. cbn [fst snd real_number] in N1, N2.
      apply (is_pole_sound G (polynomial e) p W HP h r HS); auto. apply IZR_le. auto.
Qed.

Lemma at_number_radius F r : (0 <= r)%R -> at_number F r -> is_radius (size F) (count F) (real F) r.
Proof.
  intros Hr [U L]. split; auto. split; auto. intros g Hg. apply U; auto. lra.
Qed.

Theorem number_and_blocks_sound F e c : check_number_and_blocks F e c = true -> let h := number_place c in
  one_number e /\ 0 < low h /\ 0 < bottom h /\ exists r, is_number e r /\ is_radius (size F) (count F) (real F) r /\
  (IZR (low h) / IZR (bottom h) <= r <= IZR (high h) / IZR (bottom h))%R.
Proof.
  intros H h. unfold check_number_and_blocks in H. fold h in H. repeat rewrite andb_true_iff in H. destruct H as [[WF HN] H].
  destruct (check_number_sound e h HN) as [S [Rho [HL [Hlow [Hcom [z [r [Iz [Uz [N1 [N2 [R0 [Rp B]]]]]]]]]]]]].
  split. exists z; auto. split; auto. split; auto. exists r. assert (Nr : is_number e r) by (split; auto; exists z; auto). split; auto. split; auto.
  destruct (exact_basis c) as [b|].
  - apply andb_prop in H. destruct H as [V H]. assert (WF' := in_basis_well_formed F b WF V).
    destruct (blocks_at_number (in_basis F b) e c r WF' HN H Nr) as [U L].
    assert (EC : count (in_basis F b) = count F) by apply count_map. rewrite EC in U, L. change (size (in_basis F b)) with (size F) in U, L.
    apply at_number_radius. lra. split.
    + intros g Hg H0. apply (growth_in_basis F b WF V); [lra|]. apply U; auto.
    + intros g Hg G. apply L; auto. apply (growth_in_basis F b WF V); auto.
  - apply at_number_radius. lra. eapply blocks_at_number; eauto.
Qed.

Lemma le_fraction a q l : 0 < q -> Qnum l * q <=? a * Zpos (Qden l) = true -> (real_of l <= IZR a / IZR q)%R.
Proof.
  intros Hq H. apply Z.leb_le, IZR_le in H. rewrite !mult_IZR in H. assert (P : (0 < IZR q)%R) by (apply IZR_lt; auto).
  assert (D : (0 < IZR (Zpos (Qden l)))%R) by (apply IZR_lt; lia). unfold real_of.
  apply (Rmult_le_reg_r (IZR (Zpos (Qden l)) * IZR q)). apply Rmult_lt_0_compat; auto.
  replace (IZR (Qnum l) / IZR (Zpos (Qden l)) * (IZR (Zpos (Qden l)) * IZR q))%R with (IZR (Qnum l) * IZR q)%R by (field; lra).
  replace (IZR a / IZR q * (IZR (Zpos (Qden l)) * IZR q))%R with (IZR a * IZR (Zpos (Qden l)))%R by (field; lra). auto.
Qed.

Lemma fraction_le a q u : 0 < q -> a * Zpos (Qden u) <=? Qnum u * q = true -> (IZR a / IZR q <= real_of u)%R.
Proof.
  intros Hq H. apply Z.leb_le, IZR_le in H. rewrite !mult_IZR in H. assert (P : (0 < IZR q)%R) by (apply IZR_lt; auto).
  assert (D : (0 < IZR (Zpos (Qden u)))%R) by (apply IZR_lt; lia). unfold real_of.
  apply (Rmult_le_reg_r (IZR (Zpos (Qden u)) * IZR q)). apply Rmult_lt_0_compat; auto.
  replace (IZR (Qnum u) / IZR (Zpos (Qden u)) * (IZR (Zpos (Qden u)) * IZR q))%R with (IZR (Qnum u) * IZR q)%R by (field; lra).
  replace (IZR a / IZR q * (IZR (Zpos (Qden u)) * IZR q))%R with (IZR a * IZR (Zpos (Qden u)))%R by (field; lra). auto.
Qed.

(* What the checker accepts is true. *)
Theorem check_exact_radius_sound F e lower upper c : check_exact_radius F e lower upper c = true -> exact_radius_holds F e lower upper.
Proof.
  intros H. unfold check_exact_radius in H. cbv zeta in H. repeat rewrite andb_true_iff in H. destruct H as [[H HL] HU].
  destruct (number_and_blocks_sound F e c H) as [One [Lp [Cp [r [Nr [Rr [B1 B2]]]]]]]. split; auto. exists r. split; auto. split; auto. split.
  - intros l ->. apply le_fraction in HL; auto. lra.
  - intros u ->. apply fraction_le in HU; auto. lra.
Qed.

Lemma log_onto lambda order r : (0 < lambda)%R -> (0 < r)%R -> exists s, (exp ((INR order - s) * lambda) = r)%R.
Proof.
  intros Hl Hr. destruct (exp_onto r Hr) as [t Ht]. exists (INR order - t / lambda)%R. rewrite <- Ht. f_equal. field. lra.
Qed.

Lemma exp_reflects x y lambda : (0 < lambda)%R -> (exp (x * lambda) <= exp (y * lambda))%R -> (x <= y)%R.
Proof.
  intros Hl H. apply Rnot_lt_le. intros N. assert (exp (y * lambda) < exp (x * lambda))%R; [|lra]. apply exp_less.
  apply Rmult_lt_compat_r; auto.
Qed.

Theorem exact_exponent_facts a order e lower upper c shifts : check_exact_exponent a order e lower upper c shifts = true ->
  let T := difference_family a order in
  one_number e /\ exists phi r s lambda, limit_of a phi /\ is_number e r /\ exp lambda = INR (arity a) /\
  (exp ((INR order - s) * lambda) = r)%R /\ is_lub (exponents phi) s /\ within lower upper s /\
  stable phi /\ (0 < s <= INR order)%R /\ is_radius (size T) (count T) (real T) r /\
  (IZR (low (number_place c)) / IZR (bottom (number_place c)) <= r <= IZR (high (number_place c)) / IZR (bottom (number_place c)))%R.
Proof.
  intros H T'. unfold check_exact_exponent in H. cbv zeta in H. repeat rewrite andb_true_iff in H.
  destruct H as [[[[[[[H1 H2] H3] H4] H5] H6] HL] HU]. set (h := number_place c) in *.
  destruct (number_and_blocks_sound _ e c H6) as [One [Lp [Cp [r [Nr [Rr [B1 B2]]]]]]]. fold h in Lp, Cp, B1, B2. split; auto.
  assert (HA : (2 <= arity a)%nat /\ 0 < common a).
  { unfold reducible in H1. repeat rewrite andb_true_iff in H1. destruct H1 as [[[HA HD] _] _]. apply Nat.leb_le in HA. apply Z.ltb_lt in HD. auto. }
  destruct HA as [HA HD]. apply Nat.leb_le in H2. apply Z.ltb_lt, IZR_lt in H4, H5.
  destruct (exp_onto (INR (arity a)) (arity_positive (arity a) HA)) as [lambda Hlog].
  assert (Lam := log_positive (arity a) HA lambda Hlog).
  assert (R0 : (0 < r)%R) by apply Nr. destruct (log_onto lambda order r Lam R0) as [s Hs].
  assert (CP : (0 < IZR (bottom h))%R) by (apply IZR_lt; auto).
  assert (R1 : (1 < r)%R).
  { eapply Rlt_le_trans; [|apply B1]. apply (Rmult_lt_reg_r (IZR (bottom h))); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (R2 : (r < exp (INR order * lambda))%R).
  { eapply Rle_lt_trans. apply B2. rewrite <- exp_power, Hlog. rewrite mult_IZR, (arity_power (arity a) HA) in H5.
    apply (Rmult_lt_reg_r (IZR (bottom h))); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (S0 : (0 < s)%R).
  { apply Rnot_le_lt. intros N. assert (exp (INR order * lambda) <= exp ((INR order - s) * lambda))%R; [|lra].
    apply exp_at_most. apply Rmult_le_compat_r; lra. }
  assert (S1 : (s <= INR order)%R).
  { apply Rnot_lt_le. intros N. assert (exp ((INR order - s) * lambda) <= 1)%R; [|lra]. rewrite <- exp_0. apply exp_at_most.
    assert ((s - INR order) * lambda >= 0)%R by (apply Rle_ge, Rmult_le_pos; lra). lra. }
  set (T := difference_family a order) in *. assert (Rr' := Rr). destruct Rr as [_ [Gr Lr]].
  destruct (limit_of_growth a lambda s order r H1 Hlog (conj S0 S1) ltac:(lra)) as [phi [Lim [Ex [Td [Cl Up]]]]].
  { intros g Hg _. apply Gr. auto. }
  assert (Stab : stable phi) by (apply (accepted_stable a shifts); auto).
  assert (Most : exponent_at_most phi s) by (apply (Up lambda r); auto; lra).
  exists phi, r, s, lambda. split; auto. split; auto. split; auto. split; auto. split; [|split; [|auto]]; [|split].
  - split. exact Most. intros b Hb. apply Rnot_lt_le. intros N. destruct (Ex b N) as [t [Ht Hbt]]. specialize (Hb t Ht). lra.
  - intros l ->. apply orb_prop in HL. destruct HL as [HL|HL].
    + apply Z.leb_le, IZR_le in HL. unfold real_of. assert (0 < / IZR (Zpos (Qden l)))%R by (apply Rinv_0_lt_compat, IZR_lt; lia). unfold Rdiv. nra.
    + apply (below_power_sound lambda) in HL; auto. destruct HL as [_ HL]. rewrite real_of_low in HL by auto.
      assert (D : (INR order - s <= INR order - real_of l)%R) by (apply (exp_reflects _ _ lambda); auto; lra). lra.
  - intros u ->. apply (above_power_sound a u order _ lambda Hlog HA) in HU. destruct HU as [_ HU]. rewrite real_of_low in HU by auto.
    assert (D : (INR order - real_of u <= INR order - s)%R) by (apply (exp_reflects _ _ lambda); auto; lra). lra.
Qed.

Theorem check_exact_exponent_sound a order e lower upper c shifts : check_exact_exponent a order e lower upper c shifts = true ->
  exact_exponent_holds a order e lower upper.
Proof.
  intros H. destruct (exact_exponent_facts a order e lower upper c shifts H) as [One [phi [r [s [lambda [H1 [H2 [H3 [H4 [H5 [H6 _]]]]]]]]]]].
  split; auto. exists phi, r, s, lambda. auto 7.
Qed.

(* Whatever function the scheme converges to, and whatever the supremum of its exponents is: it is that number. *)
Corollary exact_exponent_of_limit a order e lower upper : (2 <= arity a)%nat -> exact_exponent_holds a order e lower upper ->
  forall phi s, limit_of a phi -> is_lub (exponents phi) s ->
  exists r lambda, is_number e r /\ exp lambda = INR (arity a) /\ (exp ((INR order - s) * lambda) = r)%R /\ within lower upper s.
Proof.
  intros HA [_ [psi [r [t [lambda [Lim [Nr [Hlog [Ht [Lub W]]]]]]]]]] phi s Lim' Lub'. exists r, lambda.
  assert (E : phi = psi) by (extensionality x; eapply limit_unique; eauto). subst psi.
  assert (Es : s = t) by (apply (is_lub_u (exponents phi)); auto). subst t. auto.
Qed.
