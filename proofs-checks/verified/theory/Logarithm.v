(* Claims about the modulus of continuity beside exact exponents: the checker, and the theorem that what it accepts is true.
   Without a power of a logarithm the exponent is attained. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Upper Integers Sections Eigenvalue Single Check Complex Number Attained Cycles Largest Sharp Power Subdivision
  Coefficients Growth Squares Descartes Stability Modulus Exponent Enclosure Exact.
Import ListNotations.
Open Scope Z_scope.

(* ---- the claim, and the checker ---------------------------------------------------------------------------------- *)

(* What exact_exponent_holds says, and the modulus of continuity *)
Definition logarithm_holds (a : scheme) (order : nat) (e : exact_number) (lower upper : option Q) (P : nat) : Prop :=
  one_number e /\ exists phi r s lambda, limit_of a phi /\ is_number e r /\ exp lambda = INR (arity a) /\
  (exp ((INR order - s) * lambda) = r)%R /\ is_lub (exponents phi) s /\ within lower upper s /\ has_modulus lambda s P phi.

(* The number is between arity^below and arity^(below + 1), and products grow like its powers; or it is arity^below, and
   products of so many matrices of another family have norms of at most 1, or its middle coefficients have a double pole at
   1. The matrices of that family are of the order of the exponent, here times `scale` over `scale`. *)
Inductive modulus_proof := Between (below : nat) | Whole (below level : nat) | Double (below : nat) (scale : Z) (c : pole).

Definition is_power (e : exact_number) (x : Z) : bool :=
  let t := x ^ Z.of_nat (root e) in let d := t * disc_scale e - disc_re e in
  (zvalue (polynomial e) t =? 0) && (0 <? x) && (d * d + disc_im e * disc_im e <=? disc_radius e * disc_radius e).

Definition attains_alone (c : exact_certificate) : bool :=
  match exact_basis c, exact_blocks c with
  | None, [(_, Attains _ _)] => true
  | None, [(_, Cyclic _ _ _ _ _ _ _ _)] => true
  | None, [(_, Leading p)] => (multiplicity p =? 1)%nat
  | _, _ => false
  end.

(* arity^(order - below) times the mask without so many factors, and its matrices *)
Definition symbol_above (a : scheme) (order below : nat) : list Z :=
  map (Z.mul (Z.of_nat (arity a) ^ Z.of_nat (order - below))) (iterate below (times_sigma (arity a)) (quotient a order)).
Definition family_above (a : scheme) (order below : nat) (scale : Z) : family :=
  let b := map (Z.mul scale) (symbol_above a order below) in let size := matrix_size (arity a) b in
  Family size (scale * common a) (transition (arity a) size b).
Definition at_one : list Z := [-1; 1].

Definition check_modulus (a : scheme) (order : nat) (e : exact_number) (exact : exact_certificate) (m : modulus_proof) : bool :=
  let h := number_place exact in let A := Z.of_nat (arity a) in
  match m with
  | Between below =>
      attains_alone exact && (below <? order)%nat && (A ^ Z.of_nat below * bottom h <? low h) && (high h <? A ^ Z.of_nat (below + 1) * bottom h)
  | Whole below level =>
      let k := (order - below)%nat in let T := difference_family a k in
      (below <? order)%nat && is_power e (A ^ Z.of_nat below) && reducible a k && well_formed T && norm_section T (1 # 1) level
  | Double below scale c =>
      let T := family_above a order below scale in
      (below <? order)%nat && (1 <=? below)%nat && is_power e (A ^ Z.of_nat below) && attains_alone exact && (0 <? scale) && well_formed T &&
      same (symbol (squares_of c)) (map (Z.mul scale) (symbol_above a order below)) &&
      (length (symbol (squares_of c)) <=? length (coefficients a))%nat &&
      pole_right T at_one c && (multiplicity c =? 2)%nat && negb (zvalue (numerator (reduced at_one c) (middles_of T at_one c)) 1 =? 0)
  end.

Definition power_of (m : modulus_proof) : nat := match m with Double _ _ _ => 1 | _ => 0 end.

Definition check_logarithm (a : scheme) (order : nat) (e : exact_number) (lower upper : option Q) (c : exact_certificate)
    (shifts : stability) (m : modulus_proof) (P : nat) : bool :=
  check_exact_exponent a order e lower upper c shifts && check_modulus a order e c m && (P =? power_of m)%nat.

(* ---- the largest coefficients from below ------------------------------------------------------------------------- *)

Open Scope R_scope.

Section Least.
Variables (A N W : nat) (b : Z -> R).
Hypothesis Arity : (2 <= A)%nat.
Hypothesis Support : forall i, (i < 0 \/ Z.of_nat N < i)%Z -> b i = 0.
Hypothesis Size : (N <= W * (A - 1))%nat.
Hypothesis Size1 : (1 <= W)%nat.

Lemma power_window n i : (i < 0 \/ Z.of_nat (W * A ^ n) <= i)%Z -> power A N b n i = 0.
Proof.
  intros H. apply (power_support A N b Arity Support). destruct H as [H|H]; [left; auto|right].
  assert (E : Z.of_nat (A ^ n) = (Z.of_nat A ^ Z.of_nat n)%Z) by apply Nat2Z.inj_pow. rewrite Nat2Z.inj_mul, E in H.
  assert (P : (0 < Z.of_nat A ^ Z.of_nat n)%Z) by (apply Z.pow_pos_nonneg; lia). set (p := (Z.of_nat A ^ Z.of_nat n)%Z) in *.
  assert (S := size_integers A N W Arity Size). nia.
Qed.

(* Some coefficient is large if all words of the length together are. *)
Lemma found n x : 0 < x -> (exists i, x <= Rabs (power A N b n i)) \/ (forall i, Rabs (power A N b n i) < x).
Proof.
  intros Hx. destruct (finite_search (fun k => Rabs (power A N b n (Z.of_nat k))) x (W * A ^ n)) as [[k [_ H]]|H]; eauto.
  right. intros i. destruct (Z_lt_ge_dec i 0). rewrite power_window, Rabs_R0 by auto. auto.
  destruct (Z_lt_ge_dec i (Z.of_nat (W * A ^ n))). replace i with (Z.of_nat (Z.to_nat i)) by lia. apply H. lia.
  rewrite power_window, Rabs_R0 by lia. auto.
Qed.

Theorem coefficients_least r : 0 < r -> radius_at_least W A (scheme_matrix A b) r ->
  exists c, 0 < c /\ forall n, (1 <= n)%nat -> exists i, c * r ^ n <= Rabs (power A N b n i).
Proof.
  intros Hr H. assert (W0 : 0 < INR W) by (apply (lt_INR 0); lia). exists (/ (2 * INR W)). split. apply Rinv_0_lt_compat; lra.
  intros n Hn. assert (Rn : 0 < r ^ n) by (apply pow_lt; auto). set (x := / (2 * INR W) * r ^ n).
  assert (X : 0 < x). { apply Rmult_lt_0_compat; auto. apply Rinv_0_lt_compat; lra. }
  destruct (found n x X) as [F|F]; auto. exfalso.
  destruct (root_exists (r ^ n / 2) n ltac:(lra) ltac:(lia)) as [g [Hg Eg]].
  assert (G : grows_at_most W A (scheme_matrix A b) g).
  { apply (level_bound W A (scheme_matrix A b) g n); try lra; try lia. intros w Hw Hl k Hk. rewrite Eg.
    apply Rle_trans with (INR W * x); [|right; unfold x; field; lra]. unfold norm. apply sum_bound. intros j Hj.
    rewrite run_product by auto. rewrite (sum_ext W _ (fun i => identity i k * product W (scheme_matrix A b) w j i)) by (intros; unfold unit; ring).
    rewrite sum_identity by auto. rewrite (product_coefficient A N W b Arity Support Size Size1 w Hw j k Hj Hk), Hl. left. apply F. }
  assert (L : r <= g). { apply H; [lra|]. apply G; auto. apply Rle_refl. }
  assert (P : r ^ n <= g ^ n) by (apply pow_incr; lra). lra.
Qed.

(* The sum of all coefficients *)
Hypothesis Total : sum (N + 1) (fun l => b (Z.of_nat l)) = INR A.

Lemma power_total n : forall lo w, (lo <= 0)%Z -> (Z.of_nat (W * A ^ n) <= lo + Z.of_nat w)%Z ->
  sum w (fun k => power A N b n (lo + Z.of_nat k)) = INR A ^ n.
Proof.
  induction n; intros lo w Hlo Hhi.
  - rewrite (sum_window (power A N b 0) 0 1 lo w); [simpl; ring| |lia|simpl in *; lia].
    intros l Hl. simpl. destruct (Z.eqb_spec l 0); auto. lia.
  - cbn [power]. rewrite sum_swap.
    rewrite (sum_ext (N + 1) _ (fun l => INR A ^ n * b (Z.of_nat l))).
    + rewrite sum_scal, Total. simpl. ring.
    + intros l Hl. rewrite sum_scal, Rmult_comm. f_equal.
      rewrite <- (IHn (lo - Z.of_nat A ^ Z.of_nat n * Z.of_nat l)%Z w).
      * apply sum_ext. intros k _. f_equal. lia.
      * assert (0 < Z.of_nat A ^ Z.of_nat n)%Z by (apply Z.pow_pos_nonneg; lia). nia.
      * assert (E : forall j, Z.of_nat (A ^ j) = (Z.of_nat A ^ Z.of_nat j)%Z) by (intros; apply Nat2Z.inj_pow).
        rewrite Nat2Z.inj_mul, E in *. rewrite Nat2Z.inj_succ, Z.pow_succ_r in Hhi by lia.
        assert (P : (0 < Z.of_nat A ^ Z.of_nat n)%Z) by (apply Z.pow_pos_nonneg; lia). set (p := (Z.of_nat A ^ Z.of_nat n)%Z) in *.
        assert (S := size_integers A N W Arity Size). assert (Z.of_nat l <= Z.of_nat N)%Z by lia.
        assert (p * Z.of_nat l <= p * (Z.of_nat W * (Z.of_nat A - 1)))%Z by (apply Z.mul_le_mono_nonneg_l; lia). lia.
Qed.

Theorem total_least : exists c, 0 < c /\ forall n, (1 <= n)%nat -> exists i, c * 1 ^ n <= Rabs (power A N b n i).
Proof.
  assert (W0 : 0 < INR W) by (apply (lt_INR 0); lia). exists (/ (2 * INR W)). assert (C : 0 < / (2 * INR W)) by (apply Rinv_0_lt_compat; lra). split; auto.
  intros n Hn. rewrite pow1, Rmult_1_r. destruct (found n _ C) as [F|F]; auto. exfalso.
  assert (T := power_total n 0 (W * A ^ n) ltac:(lia) ltac:(lia)).
  assert (B : Rabs (INR A ^ n) <= INR (W * A ^ n) * / (2 * INR W)).
  { rewrite <- T. eapply Rle_trans. apply sum_abs. apply sum_bound. intros k _. left. apply F. }
  assert (P : 0 < INR A ^ n) by (apply pow_lt, (lt_INR 0); lia). rewrite Rabs_pos_eq in B by lra.
  rewrite mult_INR, pow_INR in B. replace (INR W * INR A ^ n * / (2 * INR W)) with (INR A ^ n / 2) in B by (field; lra). lra.
Qed.
End Least.

(* ---- the differences of a mask ----------------------------------------------------------------------------------- *)

Section Mask.
Variables (a : scheme) (m : nat).
Hypothesis Reducible : reducible a m = true.
Let A := arity a.
Let F := first a.
Let L := (length (coefficients a) - 1)%nat.
Let bl := difference_symbol a m.
Let W := matrix_size A bl.
Let N := (length bl - 1)%nat.
Let bz := coefficient bl (common a) 0.
Let T := difference_family a m.

Lemma mask_facts : (2 <= A)%nat /\ (0 < IZR (common a)) /\ (N + m * (A - 1) <= L)%nat /\
  (forall i, (i < 0 \/ Z.of_nat N < i)%Z -> bz i = 0) /\ (N <= W * (A - 1))%nat /\ (1 <= W)%nat /\
  coefficient (coefficients a) (common a) F = smoothed A m (fun i => bz (i - F)%Z) /\
  (forall K, (N <= K)%nat -> total F K (fun i => bz (i - F)%Z) = INR A) /\
  (forall r, growth (size T) (count T) (real T) r <-> growth W A (scheme_matrix A bz) r).
Proof.
  assert (H := Reducible). unfold reducible in H. repeat rewrite andb_true_iff in H.
  destruct H as [[[HA HO] HD] HT]. fold A in HA, HD, HT. apply Nat.leb_le in HA. apply Z.ltb_lt, IZR_lt in HO. apply Z.eqb_eq in HT.
  unfold divides in HD. apply andb_prop in HD. destruct HD as [HD HL]. apply same_spec in HD. apply Nat.leb_le in HL. fold A in HD, HL.
  assert (Hlen : length bl = length (quotient a m)) by apply map_length.
  destruct (matrix_size_fits A bl HA) as [W1 W2]. fold W N in W1, W2. split; auto. split; auto.
  split. { unfold N, L. rewrite Hlen. exact HL. } split. { intros i Hi. apply coefficient_support. unfold N in Hi. lia. }
  split; auto. split; auto. split; [|split].
  - extensionality i. rewrite <- HD, coefficient_iterate by auto. fold A. rewrite <- smoothed_scal. f_equal. extensionality k.
    unfold bz. rewrite <- coefficient_shift. unfold bl, difference_symbol. fold A. rewrite coefficient_map, <- (arity_power A HA). reflexivity.
  - intros K HK. replace (fun i => bz (i - F)%Z) with (coefficient bl (common a) F) by (extensionality i; apply coefficient_shift).
    rewrite coefficient_total by (unfold N in HK; lia). fold bl in HT. rewrite HT, mult_IZR, <- INR_IZR_INZ. fold A. field. lra.
  - assert (EC : count T = A) by (unfold T, difference_family; cbv zeta; unfold count, transition; cbn [matrices]; rewrite map_length, seq_length; auto).
    intros r. rewrite EC. split; intros G; eapply growth_ext; try apply G; intros t i j Ht Hi Hj; [|symmetry]; apply transition_entry; auto.
Qed.

Lemma steps_power n i : refined A F L (fun i => bz (i - F)%Z) n i = power A N bz n (i - shift A F n).
Proof.
  destruct mask_facts as [HA [_ [HL [Sb [W1 [W2 _]]]]]]. apply (refined_power A N W bz HA Sb W1 W2 L).
  revert HL. generalize (m * (A - 1))%nat. lia.
Qed.

Definition grows_least (g : R) : Prop := exists c, 0 < c /\ forall n, (1 <= n)%nat -> exists i, c * g ^ n <= Rabs (power A N bz n i).

Lemma least_of_radius g : 0 < g -> radius_at_least (size T) (count T) (real T) g -> grows_least g.
Proof.
  destruct mask_facts as [HA [_ [_ [Sb [W1 [W2 [_ [_ ET]]]]]]]]. intros Hg H. apply (coefficients_least A N W bz HA Sb W1 W2 g Hg).
  intros r Hr G. apply H; auto. apply ET. auto.
Qed.

Lemma least_of_total : grows_least 1.
Proof.
  destruct mask_facts as [HA [_ [_ [Sb [W1 [W2 [_ [HT ET]]]]]]]]. apply (total_least A N W bz HA Sb W1 W2).
  rewrite <- (HT N (le_n N)). unfold total. replace (N + 1)%nat with (S N) by lia. apply sum_ext. intros k _. f_equal. lia.
Qed.

Theorem modulus_of_growth lambda s k phi : exp lambda = INR A -> (k < m)%nat -> INR k < s <= INR k + 1 -> s < INR k + 1 \/ m = S k ->
  growth (size T) (count T) (real T) (exp ((INR m - s) * lambda)) -> grows_least (exp ((INR m - s) * lambda)) ->
  limit_of a phi -> stable phi -> has_modulus lambda s 0 phi.
Proof.
  destruct mask_facts as [HA [_ [HL [Sb [W1 [W2 [EM [HT ET]]]]]]]]. intros Log Hk Hs St G [c [C0 Least]] Lim Stab.
  apply ET in G. set (g := exp ((INR m - s) * lambda)) in *.
  assert (NL : (N <= L)%nat) by (revert HL; generalize (m * (A - 1))%nat; lia).
  destruct (refined_bounded A N W bz HA Sb W1 W2 L NL F g (exp_pos _) G) as [C HC].
  unfold limit_of in Lim. fold A F L in Lim. rewrite EM in Lim.
  apply (growth_modulus A F L HA lambda N m k 0 (fun i => bz (i - F)%Z) s C c phi); auto.
  - intros i Hi. apply Sb. lia.
  - intros n i. rewrite pow_O, Rmult_1_r. apply HC.
  - intros n Hn. destruct (Least n Hn) as [i Hi]. exists (i + shift A F n)%Z. rewrite pow_O, Rmult_1_r.
    rewrite steps_power. replace (i + shift A F n - shift A F n)%Z with i by lia. exact Hi.
Qed.
End Mask.

Section Double.
Variables (a : scheme) (order below : nat) (scale : Z) (c : pole) (lambda s : R) (phi : R -> R).
Let A := arity a.
Let F := first a.
Let L := (length (coefficients a) - 1)%nat.
Let k := (order - below)%nat.
Let T := family_above a order below scale.
Hypothesis Reducible : reducible a order = true.
Hypothesis Below : (1 <= below < order)%nat.
Hypothesis Scale : (0 < scale)%Z.
Hypothesis WF : well_formed T = true.
Hypothesis Same : symbol (squares_of c) = map (Z.mul scale) (symbol_above a order below).
Hypothesis Short : (length (symbol (squares_of c)) <= length (coefficients a))%nat.
Hypothesis Right : pole_right T at_one c = true.
Hypothesis Twice : multiplicity c = 2%nat.
Hypothesis NZ : zvalue (numerator (reduced at_one c) (middles_of T at_one c)) 1 <> 0%Z.
Hypothesis Log : exp lambda = INR A.
Hypothesis Es : s = INR k.
Hypothesis Growth : growth (size (difference_family a order)) (count (difference_family a order)) (real (difference_family a order)) (exp (INR below * lambda)).
Hypothesis Lim : limit_of a phi.
Hypothesis Stab : stable phi.

Theorem double_modulus : has_modulus lambda s 1 phi.
Proof.
  destruct (mask_facts a order Reducible) as [HA [HO [HL [Sb [W1 [W2 [EM [HT ET]]]]]]]]. fold A F L in HA, HL, EM, HT.
  set (bl := difference_symbol a order) in *. set (N := (length bl - 1)%nat) in *. set (W := matrix_size (arity a) bl) in *. fold A in W, W1, ET.
  set (bz := coefficient bl (common a) 0) in *. set (f := fun i => bz (i - F)%Z) in *.
  assert (NL : (N <= L)%nat) by (revert HL; generalize (order * (A - 1))%nat; lia).
  assert (Ok : order = (k + below)%nat) by (unfold k; lia).
  assert (Sf : supported F N f) by (intros i Hi; apply Sb; lia).
  apply ET in Growth. destruct (refined_bounded A N W bz HA Sb W1 W2 L NL F (exp (INR below * lambda)) (exp_pos _) Growth) as [C HC].
  assert (Fit : forall j, (j < order)%nat -> (N + j * (A - 1) + A - 1 <= L)%nat).
  { intros j Hj. generalize (Nat.mul_le_mono_r (S j) order (A - 1) Hj). rewrite Nat.mul_succ_l. revert HL. generalize (j * (A - 1))%nat (order * (A - 1))%nat. lia. }
  assert (Tot : forall j, (j < order)%nat -> total F L (smoothed A j f) = INR A).
  { intros j Hj. rewrite (smoothed_total A F L HA N); auto. specialize (Fit j Hj). lia. }
  assert (G : forall j, (j < below)%nat -> exists D, forall n i, Rabs (refined A F L (smoothed A j f) n i) <= D * exp ((INR below - INR j) * lambda) ^ n).
  { induction j; intros Hj.
    - exists C. simpl INR at 2. rewrite Rminus_0_r. exact HC.
    - destruct (IHj ltac:(lia)) as [D HD]. cbn [smoothed].
      apply (smooth_growth A F L HA (N + j * (A - 1)) (smoothed A j f) D (exp ((INR below - INR j) * lambda))); auto.
      + apply smoothed_supported; auto.
      + apply Fit. lia.
      + apply Tot. lia.
      + apply exp_pos.
      + rewrite <- exp_0, <- (Rmult_0_l lambda). apply (power_less A HA lambda Log). apply lt_INR in Hj. lra.
      + right. rewrite <- (power_succ A lambda Log). f_equal. f_equal. rewrite S_INR. ring. }
  destruct (G (below - 1)%nat ltac:(lia)) as [D HD]. set (c1 := smoothed A (below - 1) f) in *.
  replace ((INR below - INR (below - 1)) * lambda) with lambda in HD by (rewrite minus_INR by lia; simpl; ring). rewrite Log in HD.
  set (b := smoothed A below f).
  assert (Eb : b = smooth A c1). { unfold b, c1. replace below with (S (below - 1)) at 1 by lia. reflexivity. }
  destruct (smooth_growth_one A F L (N + (below - 1) * (A - 1)) c1 D HA ltac:(apply smoothed_supported; auto) ltac:(apply Fit; lia) ltac:(apply Tot; lia) HD) as [D' HD'].
  rewrite <- Eb in HD'.
  (* the symbol of the middle coefficients *)
  set (sq := squares_of c). destruct (pole_facts T at_one c Right) as [Sq _]. fold sq in Sq.
  destruct (Single.facts T sq Sq) as [_ [F2 [_ [F4 [F5 _]]]]]. fold sq in Same, Short. set (bs := symbol_above a order below) in *.
  assert (Cnt : count T = A). { unfold T, family_above. cbv zeta. unfold count, transition. cbn [matrices]. rewrite map_length, seq_length. auto. }
  set (Ns := (length (symbol sq) - 1)%nat) in *. set (bsz := symbol_at T sq).
  assert (Es' : forall i, b i = bsz (i - F)%Z).
  { intros i. unfold b. assert (PA : 0 < INR A) by (apply arity_positive; auto).
    assert (Ef : f = fun j => (INR A ^ order * coefficient (quotient a order) (common a) F j)).
    { extensionality j. unfold f, bz, bl. rewrite <- coefficient_shift. unfold difference_symbol. fold A. rewrite coefficient_map, (arity_power A HA). reflexivity. }
    rewrite Ef, smoothed_scal. assert (It := coefficient_iterate A below (quotient a order) (common a) F HA i).
    assert (E1 : bsz (i - F)%Z = INR A ^ k * coefficient (iterate below (times_sigma A) (quotient a order)) (common a) F i).
    { rewrite <- (arity_power A HA), <- coefficient_map. change (Z.of_nat A ^ Z.of_nat k)%Z with (Z.of_nat (arity a) ^ Z.of_nat (order - below))%Z. fold bs.
      rewrite coefficient_shift. unfold bsz, symbol_at, coefficient. rewrite Same. replace (i - F - 0)%Z with (i - F)%Z by lia.
      destruct (i - F <? 0)%Z; auto. unfold T, family_above. cbn [denominator]. replace 0%Z with (scale * 0)%Z at 1 by lia. rewrite map_nth, !mult_IZR.
      fold A bs. apply IZR_lt in Scale. unfold bs, symbol_above. fold A. field. lra. }
    rewrite E1, It, Ok, pow_add. ring. }
  assert (Bsup : forall i, (i < 0 \/ Z.of_nat Ns < i)%Z -> bsz i = 0) by (apply (symbol_support T sq Sq)).
  rewrite Cnt in F5. fold Ns in F5.
  assert (Ps : forall n i, refined A F L b n i = power A Ns bsz n (i - shift A F n)).
  { intros n i. replace b with (fun i => bsz (i - F)%Z) by (extensionality j; rewrite Es'; auto).
    apply (refined_power A Ns (size T) bsz HA Bsup F5 F2 L). unfold Ns, L. lia. }
  assert (Pm : forall n, moments T sq n = power A Ns bsz n (0 - shift A (- Z.of_nat (middle (symbol sq))) n)).
  { intros n. assert (P := power_shifted T sq Sq n (0 - shift A (- Z.of_nat (middle (symbol sq))) n)). rewrite Cnt in P. fold Ns bsz in P. rewrite P. unfold moments. f_equal. lia. }
  assert (Tb : total F L b = INR A) by (apply Tot; lia).
  assert (Ts : sum (Ns + 1) (fun l => bsz (Z.of_nat l)) = INR A).
  { rewrite <- Tb. unfold total. rewrite (sum_ext (S L) _ (fun l => bsz (0 + Z.of_nat l)%Z)).
    - symmetry. rewrite (sum_window bsz 0 (Ns + 1) 0 (S L)).
      + apply sum_ext. intros. auto.
      + intros l Hl. apply Bsup. lia.
      + lia.
      + unfold Ns, L. lia.
    - intros l _. rewrite Es'. f_equal. lia. }
  destruct (total_least A Ns (size T) bsz HA Bsup F5 F2 Ts) as [c0 [C0 Least]].
  assert (Lm : forall n, (1 <= n)%nat -> c0 <= moments T sq n).
  { intros n Hn. destruct (Least n Hn) as [i Hi]. rewrite pow1, Rmult_1_r in Hi. eapply Rle_trans. apply Hi.
    assert (P := power_shifted T sq Sq n i). rewrite Cnt in P. fold Ns bsz in P. rewrite P. apply (powers_central T sq WF Sq). }
  destruct (moments_linear T c WF Right c0 Twice NZ C0 Lm) as [kk [KK Lin]]. fold sq in Lin.
  (* both together *)
  assert (E1 : exp ((INR k - s) * lambda) = 1). { rewrite Es. replace ((INR k - INR k) * lambda) with 0 by ring. apply exp_0. }
  unfold limit_of in Lim. fold A F L in Lim. rewrite EM in Lim. rewrite Ok, smoothed_add in Lim. fold f b in Lim.
  apply (growth_modulus A F L HA lambda (N + below * (A - 1)) k (k - 1) 1 b s D' kk phi); auto.
  - apply smoothed_supported; auto.
  - rewrite Ok in HL. rewrite Nat.mul_add_distr_r in HL. lia.
  - unfold k. lia.
  - rewrite Es. rewrite minus_INR by (unfold k; lia). simpl. lra.
  - right. unfold k. lia.
  - intros n i. rewrite E1, pow1, pow_1, Rmult_1_r. apply HD'.
  - intros n Hn. rewrite E1, pow1, pow_1, Rmult_1_r. specialize (Lin n Hn). rewrite Pm in Lin.
    exists (0 - shift A (- Z.of_nat (middle (symbol sq))) n + shift A F n)%Z. rewrite Ps.
    replace (0 - shift A (- Z.of_nat (middle (symbol sq))) n + shift A F n - shift A F n)%Z with (0 - shift A (- Z.of_nat (middle (symbol sq))) n)%Z by lia.
    eapply Rle_trans. apply Lin. apply Rle_abs.
Qed.
End Double.

(* ---- what is accepted is true ------------------------------------------------------------------------------------ *)

Lemma value_integer p x : value p (real_number (IZR x)) = real_number (IZR (zvalue p x)).
Proof.
  induction p; auto. cbn [value zvalue]. rewrite IHp, plus_IZR, mult_IZR. unfold cplus, ctimes, real_number; simpl. f_equal; ring.
Qed.

Lemma is_power_sound e x r : (0 < disc_scale e)%Z -> (0 < root e)%nat -> (0 <= disc_radius e)%Z -> (forall y z, is_zero_of e y -> is_zero_of e z -> y = z) ->
  is_power e x = true -> is_number e r -> r = IZR x.
Proof.
  intros Hs HL Hd One H [R0 [z [Hz Ez]]]. unfold is_power in H. cbv zeta in H. set (t := (x ^ Z.of_nat (root e))%Z) in *.
  repeat rewrite andb_true_iff in H. destruct H as [[H1 H2] H3]. apply Z.eqb_eq in H1. apply Z.ltb_lt, IZR_lt in H2. apply Z.leb_le, IZR_le in H3.
  assert (S : 0 < IZR (disc_scale e)) by (apply IZR_lt; auto). assert (Et : IZR t = IZR x ^ root e) by (unfold t; rewrite <- pow_IZR; auto).
  assert (T0 : 0 < IZR t) by (rewrite Et; apply pow_lt; auto).
  assert (Zt : is_zero_of e (real_number (IZR t))).
  { split. rewrite value_integer, H1. auto. set (cc := complex_over _ _ _).
    assert (E : ctimes (real_number (IZR (disc_scale e))) (cminus (real_number (IZR t)) cc) = cz (t * disc_scale e - disc_re e, - disc_im e)%Z).
    { unfold ctimes, real_number, cminus, cc, complex_over, cz; simpl. rewrite minus_IZR, mult_IZR, opp_IZR. f_equal; field; lra. }
    apply (f_equal cabs) in E. rewrite cabs_times, cabs_real, Rabs_pos_eq in E by lra.
    apply (Rmult_le_reg_l (IZR (disc_scale e))); auto. rewrite E. replace (IZR (disc_scale e) * (IZR (disc_radius e) / IZR (disc_scale e))) with (IZR (disc_radius e)) by (field; lra).
    apply square_le. apply cabs_nonneg. apply IZR_le; auto. rewrite cabs_cz, <- mult_IZR. eapply Rle_trans; [|apply H3]. right. f_equal. unfold zsquare. simpl. ring. }
  rewrite (One z _ Hz Zt) in Ez. rewrite cabs_real, Rabs_pos_eq, Et in Ez by lra.
  apply Rle_antisym; apply (pow_le_reg _ _ (root e)); auto; lra.
Qed.

Lemma one_block_growth F e c r : check_number_and_blocks F e c = true -> attains_alone c = true -> is_number e r -> grows_at_most (size F) (count F) (real F) r.
Proof.
  intros H HA Hr. unfold attains_alone in HA. unfold check_number_and_blocks in H. set (h := number_place c) in *.
  destruct (exact_basis c); [discriminate|]. repeat rewrite andb_true_iff in H. destruct H as [[WF HN] H].
  unfold check_blocks in H. apply andb_prop in H. destruct H as [H _].
  destruct (check_number_sound e h HN) as [S [Rho [HL [Hlow [Hcom [z' [r' [Iz [Uz [N1 [N2 [R0 [Rp B]]]]]]]]]]]]].
  assert (Er : r = r').
  { destruct Hr as [Pr [y [Iy Ey]]]. rewrite (Uz y Iy), <- Rp in Ey. apply Rle_antisym; apply (pow_le_reg _ _ (root e)); auto; lra. }
  subst r'. assert (Vz := proj1 Iz).
  assert (Sc : (0 < near_scale h)%Z) by (apply lt_IZR; auto).
  assert (Sm : (0 <= near_radius h)%Z).
  { apply le_IZR. apply (Rmult_le_reg_r (/ IZR (near_scale h))). apply Rinv_0_lt_compat; auto. unfold Rdiv in Rho. lra. }
  destruct (exact_blocks c) as [|[d [s|tr b|g unity firsts group turns states bs cycles|p]] [|x l]]; try discriminate; cbn [all_blocks] in H; apply andb_prop in H; destruct H as [_ HB].
  2:{ apply (graph_below_sound F (polynomial e) (root e) h z' r g unity firsts group turns states bs cycles); auto. }
  2:{ cbn [block_below] in HB. fold h in HB. apply andb_prop in HB. destruct HB as [HS HB]. apply Nat.eqb_eq in HA.
    unfold simple_number in HS. apply andb_prop in HS. destruct HS as [HS HR1]. apply Nat.eqb_eq in HR1. apply (positive_zero_sound e h z') in HS; auto.
    rewrite HR1, pow_1 in Rp. rewrite <- Rp in HS. rewrite HS, value_real in Vz. apply (f_equal fst) in Vz.
    assert (HB' := HB). unfold no_larger in HB'. cbv zeta in HB'. repeat rewrite andb_true_iff in HB'. destruct HB' as [[HP _] _].
    apply (sharp_growth F (polynomial e) p WF HP h r Vz R0); auto. apply B. }
  cbn [block_below] in HB. fold h in HB. apply andb_prop in HB. destruct HB as [HC HB].
  assert (Cone : cone b = true -> z' = real_number (cabs z')).
  { intros EC. rewrite EC in HC. apply (positive_zero_sound e h); auto. }
  assert (WT : well_formed (if tr then transpose F else F) = true) by (destruct tr; auto; apply transpose_well_formed; auto).
  apply (below_sound _ _ _ _ z' r WT Vz Sc Sm N1 N2 R0 Rp HL Hlow Hcom B b Cone) in HB.
  destruct tr; auto. intros g Hg G0. apply transpose_growth. apply HB; auto.
Qed.

(* What the checker accepts is true. *)
Theorem check_logarithm_sound a order e lower upper c shifts p P : check_logarithm a order e lower upper c shifts p P = true ->
  logarithm_holds a order e lower upper P.
Proof.
  intros H. apply andb_prop in H. destruct H as [H HP0]. apply Nat.eqb_eq in HP0. subst P. apply andb_prop in H. destruct H as [H HM].
  destruct (exact_exponent_facts a order e lower upper c shifts H) as [One [phi [r [s [lambda [Lim [Nr [Log [Es [Lub [Wi [Stab [S0 [Rr [B1 B2]]]]]]]]]]]]]]].
  split; auto. exists phi, r, s, lambda. split; auto. split; auto. split; auto. split; auto. split; auto. split; auto.
  unfold check_exact_exponent in H. cbv zeta in H. repeat rewrite andb_true_iff in H.
  destruct H as [[[[[[[H1 _] _] _] _] HB] _] _]. set (h := number_place c) in *.
  assert (HA : (2 <= arity a)%nat). { unfold reducible in H1. repeat rewrite andb_true_iff in H1. destruct H1 as [[[HA _] _] _]. apply Nat.leb_le; auto. }
  assert (Lam := log_positive (arity a) HA lambda Log). assert (R0 : 0 < r) by apply Nr.
  assert (HN : check_number e h = true). { unfold check_number_and_blocks in HB. repeat rewrite andb_true_iff in HB. tauto. }
  assert (Cp : 0 < IZR (bottom h)). { destruct (check_number_sound e h HN) as [_ [_ [_ [_ [Cp _]]]]]. apply IZR_lt; auto. }
  assert (Ap : forall j, INR (arity a) ^ j = exp (INR j * lambda)) by (intros; rewrite <- Log, exp_power; auto).
  assert (whole_number : forall below, (below < order)%nat -> is_power e (Z.of_nat (arity a) ^ Z.of_nat below) = true ->
    r = exp (INR below * lambda) /\ s = INR (order - below)).
  { intros below Hb HP.
    assert (HZ : one_zero e = true /\ (0 < disc_scale e)%Z /\ (0 <= disc_radius e)%Z /\ (0 < root e)%nat).
    { unfold check_number in HN. cbv zeta in HN. repeat rewrite andb_true_iff in HN. destruct HN as [[[[[[[[[[HN1 _] HNk] _] _] _] _] _] _] _] _].
      apply Z.ltb_lt in HNk. split; auto. assert (HN2 := HN1). unfold one_zero in HN2. cbv zeta in HN2. repeat rewrite andb_true_iff in HN2.
      destruct HN2 as [[Q1 Q2] _]. apply Z.ltb_lt in Q1. apply Z.leb_le in Q2. split; auto. split; auto. lia. }
    destruct HZ as [OZ [DS [DR RT]]].
    assert (Er : r = exp (INR below * lambda)).
    { rewrite (is_power_sound e _ r DS RT DR (fun y z => one_zero_sound e y z OZ) HP Nr). rewrite (arity_power (arity a) HA), Ap. auto. }
    assert (Sm : s = INR (order - below)).
    { rewrite minus_INR by lia. rewrite Er in Es. assert (X : INR order - s <= INR below) by (apply (exp_reflects _ _ lambda); lra).
      assert (Y : INR below <= INR order - s) by (apply (exp_reflects _ _ lambda); lra). lra. } auto. }
  destruct p as [below|below level|below scale pl]; cbn [check_modulus power_of] in HM |- *; cbv zeta in HM; fold h in HM; repeat rewrite andb_true_iff in HM.
  - destruct HM as [[[HS Hb] HL] HH]. apply Nat.ltb_lt in Hb. apply Z.ltb_lt, IZR_lt in HL, HH. rewrite mult_IZR, (arity_power (arity a) HA), Ap in HL, HH.
    assert (L : exp (INR below * lambda) < r).
    { eapply Rlt_le_trans; [|apply B1]. apply (Rmult_lt_reg_r (IZR (bottom h))); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    assert (U : r < exp (INR (below + 1) * lambda)).
    { eapply Rle_lt_trans; [apply B2|]. apply (Rmult_lt_reg_r (IZR (bottom h))); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    rewrite <- Es in L, U. assert (X : INR below < INR order - s).
    { apply Rnot_le_lt. intros Q. assert (exp ((INR order - s) * lambda) <= exp (INR below * lambda)) by (apply exp_at_most, Rmult_le_compat_r; lra). lra. }
    assert (Y : INR order - s < INR below + 1).
    { apply Rnot_le_lt. intros Q. rewrite plus_INR in U. simpl (INR 1) in U.
      assert (exp ((INR below + 1) * lambda) <= exp ((INR order - s) * lambda)) by (apply exp_at_most, Rmult_le_compat_r; lra). lra. }
    assert (Ek : INR (order - below - 1) = INR order - INR below - 1) by (rewrite !minus_INR by lia; simpl; ring).
    assert (G : growth (size (difference_family a order)) (count (difference_family a order)) (real (difference_family a order)) (exp ((INR order - s) * lambda))).
    { rewrite Es. apply (one_block_growth _ e c r HB HS Nr); [apply Rle_refl|exact R0]. }
    assert (Le : grows_least a order (exp ((INR order - s) * lambda))).
    { rewrite Es. apply (least_of_radius a order H1 r R0). destruct Rr as [_ [_ Lr]]. exact Lr. }
    assert (K1 : (order - below - 1 < order)%nat) by lia.
    assert (K2 : INR (order - below - 1) < s <= INR (order - below - 1) + 1) by (rewrite Ek; lra).
    assert (K3 : s < INR (order - below - 1) + 1) by (rewrite Ek; lra).
    exact (modulus_of_growth a order H1 lambda s (order - below - 1) phi Log K1 K2 (or_introl K3) G Le Lim Stab).
  - destruct HM as [[[[Hb HP] HR] WF] HNo]. apply Nat.ltb_lt in Hb.
    destruct (whole_number below Hb HP) as [Er Sm].
    apply norm_sound in HNo; auto. set (k := (order - below)%nat) in *. assert (Ek : INR (k - 1) = INR k - 1) by (rewrite minus_INR by lia; simpl; ring).
    assert (Eg : exp ((INR k - s) * lambda) = 1). { rewrite Sm. replace ((INR k - INR k) * lambda) with 0 by ring. apply exp_0. }
    assert (G : growth (size (difference_family a k)) (count (difference_family a k)) (real (difference_family a k)) (exp ((INR k - s) * lambda))).
    { rewrite Eg. apply HNo; unfold real_of; simpl; lra. }
    assert (Le : grows_least a k (exp ((INR k - s) * lambda))) by (rewrite Eg; apply (least_of_total a k HR)).
    assert (K1 : (k - 1 < k)%nat) by (unfold k; lia). assert (K2 : INR (k - 1) < s <= INR (k - 1) + 1) by (rewrite Ek; lra).
    assert (K3 : k = S (k - 1)) by (unfold k; lia).
    exact (modulus_of_growth a k HR lambda s (k - 1) phi Log K1 K2 (or_intror K3) G Le Lim Stab).
  - destruct HM as [[[[[[[[[[Hb Hb1] HP] HS] Hsc] WF] Hsame] Hlen] HR] Hm] Hz]. apply Nat.ltb_lt in Hb. apply Nat.leb_le in Hb1, Hlen.
    apply Z.ltb_lt in Hsc. apply same_spec in Hsame. apply Nat.eqb_eq in Hm. apply negb_true_iff, Z.eqb_neq in Hz.
    destruct (whole_number below Hb HP) as [Er Sm].
    assert (G : growth (size (difference_family a order)) (count (difference_family a order)) (real (difference_family a order)) (exp (INR below * lambda))).
    { rewrite <- Er. apply (one_block_growth _ e c r HB HS Nr); [apply Rle_refl|exact R0]. }
    exact (double_modulus a order below scale pl lambda s phi H1 (conj Hb1 Hb) Hsc WF Hsame Hlen HR Hm Hz Log Sm G Lim Stab).
Qed.
