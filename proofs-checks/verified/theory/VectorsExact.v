(* What the exponent of vectors of functions is exactly: the least one of the components, where the joint spectral radius of
   the space is the number that a certificate names (SPEC.md, sections 4.10 and 5.9). *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Integers Sections Eigenvalue Check Subdivision Coefficients Differences Stability
  Refinable Exponent Levels Enclosure Number Exact Vectors VectorsAbove.
Import ListNotations.
Open Scope R_scope.

(* There is one solution but for factors, and the supremum s of the exponents of its worst component is less the logarithm of
   the number, to the base arity: arity^(-s) is the number. *)
Definition exact_vectors_hold (a : vector_mask) (e : exact_number) (lower upper : option Q) : Prop :=
  one_number e /\ exists phi r s lambda, is_number e r /\ exp lambda = INR (vector_arity a) /\ exp (- s * lambda) = r /\
  solution_at_least (vector_arity a) (functions a) (vector_first a) (length (of_points a) - 1) (point_matrix a) phi s /\
  (exists c, (c < functions a)%nat /\ is_lub (exponents (phi c)) s) /\ within lower upper s.

(* The number is above arity^(-order) and below 1, and the exponent between the ends. *)
Definition number_between (arity order : nat) (h : Number.place) : bool :=
  (high h <? bottom h)%Z && (bottom h <? low h * Z.of_nat arity ^ Z.of_nat order)%Z.
Definition exponent_within (a : vector_mask) (order : nat) (lower upper : option Q) (h : Number.place) : bool :=
  let q := Z.to_pos (bottom h) in
  match lower with None => true | Some l => (Qnum l <=? 0)%Z || vector_power a l order (high h # q) end &&
  match upper with None => true | Some u => above_powers (vector_arity a) u order (low h # q) end.

(* The bound of the certificate of a lower end, its radius, and the least radius are not looked at. *)
Definition check_exact_vectors (a : vector_mask) (e : exact_number) (lower upper : option Q) (d : above_certificate)
    (x : exact_certificate) : bool :=
  let c := space_proof d in let m := difference_order c in let h := number_place x in
  vector_space a c && checks_images a d && checks_places a c && number_between (vector_arity a) m h &&
  check_number_and_blocks (vector_family a c) e x && exponent_within a m lower upper h.

Lemma least_lub f s : exponent_at_least f s -> exponent_at_most f s -> is_lub (exponents f) s.
Proof.
  intros Lo Hi. split. exact Hi. intros b Hb. apply Rnot_lt_le. intros N. destruct (Lo b N) as [t [Ht Hbt]].
  specialize (Hb t Ht). lra.
Qed.

Section Exponent.
Variables (a : vector_mask) (m : nat) (lambda r : R) (h : Number.place).
Hypothesis Arity : (2 <= vector_arity a)%nat.
Hypothesis Log : exp lambda = INR (vector_arity a).
Hypothesis Bottom : (0 < bottom h)%Z.
Hypothesis Positive : 0 < r.
Hypothesis Near : IZR (low h) / IZR (bottom h) <= r <= IZR (high h) / IZR (bottom h).

Lemma exponent_of_number : number_between (vector_arity a) m h = true ->
  exists s, exp (- s * lambda) = r /\ 0 < s <= INR m /\ exp (- INR m * lambda) < r.
Proof.
  intros H. apply andb_prop in H. destruct H as [H1 H2]. assert (Lam := log_positive _ Arity lambda Log).
  apply Z.ltb_lt, IZR_lt in H1, H2. rewrite mult_IZR, (arity_power _ Arity) in H2.
  assert (CP : 0 < IZR (bottom h)) by (apply IZR_lt; auto).
  assert (PM : 0 < INR (vector_arity a) ^ m) by (apply pow_lt, arity_positive; auto).
  destruct (log_onto lambda 0 r Lam Positive) as [s Hs]. simpl INR in Hs. rewrite Rminus_0_l in Hs.
  assert (R1 : r < 1).
  { eapply Rle_lt_trans. apply Near. apply (Rmult_lt_reg_r (IZR (bottom h))); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (R2 : exp (- INR m * lambda) < r).
  { eapply Rlt_le_trans; [|apply Near]. replace (- INR m * lambda) with (- (INR m * lambda)) by ring.
    rewrite exp_Ropp, <- exp_power, Log. apply (Rmult_lt_reg_r (INR (vector_arity a) ^ m * IZR (bottom h))). apply Rmult_lt_0_compat; auto.
    replace (/ INR (vector_arity a) ^ m * (INR (vector_arity a) ^ m * IZR (bottom h))) with (IZR (bottom h)) by (field; lra).
    replace (IZR (low h) / IZR (bottom h) * (INR (vector_arity a) ^ m * IZR (bottom h))) with (IZR (low h) * INR (vector_arity a) ^ m)
      by (field; lra). auto. }
  exists s. split; auto. split; auto. split.
  - apply Rnot_le_lt. intros N. assert (1 <= exp (- s * lambda)); [|lra]. rewrite <- exp_0. apply exp_at_most. nra.
  - apply Rnot_lt_le. intros N. assert (exp (- s * lambda) <= exp (- INR m * lambda)); [|lra]. apply exp_at_most. nra.
Qed.

Lemma exponent_between lower upper s : exp (- s * lambda) = r -> 0 < s -> exponent_within a m lower upper h = true -> within lower upper s.
Proof.
  intros Hs S0 H. apply andb_prop in H. destruct H as [HL HU]. assert (Lam := log_positive _ Arity lambda Log). split.
  - intros l ->. apply orb_prop in HL. destruct HL as [HL|HL].
    + apply Z.leb_le, IZR_le in HL. unfold real_of. assert (0 < / IZR (Zpos (Qden l))) by (apply Rinv_0_lt_compat, IZR_lt; lia). unfold Rdiv. nra.
    + apply (vector_power_sound a l _ _ lambda Arity Log) in HL. destruct HL as [_ HL]. rewrite real_of_low in HL by auto.
      assert (D : - s <= - real_of l) by (apply (exp_reflects _ _ lambda); auto; lra). lra.
  - intros u ->. apply (above_powers_sound lambda _ _ _ _ Log Arity) in HU. destruct HU as [HU _]. rewrite real_of_low in HU by auto.
    assert (D : - real_of u <= - s) by (apply (exp_reflects _ _ lambda); auto; lra). lra.
Qed.
End Exponent.

(* What the checker accepts is true. *)
Theorem check_exact_vectors_sound a e lower upper d x :
  check_exact_vectors a e lower upper d x = true -> exact_vectors_hold a e lower upper.
Proof.
  intros H. unfold check_exact_vectors in H. cbv zeta in H. set (c := space_proof d) in *. set (h := number_place x) in *.
  apply andb_prop in H. destruct H as [H HW]. apply andb_prop in H. destruct H as [H HN]. apply andb_prop in H. destruct H as [H HB].
  assert (H' := H). rewrite !andb_true_iff in H'. destruct H' as [[H0 _] _]. unfold vector_space in H0. rewrite !andb_true_iff in H0.
  destruct H0 as [[[[[[[[[[HA _] _] _] _] _] _] _] HS] _] _]. apply Nat.leb_le in HA.
  destruct (number_and_blocks_sound _ e x HN) as [One [Lp [Cp [r [Nr [Rr Near]]]]]]. fold h in Lp, Cp, Near. split; auto.
  destruct (exp_onto (INR (vector_arity a)) (arity_positive _ HA)) as [lambda Log].
  destruct (exponent_of_number a (difference_order c) lambda r h HA Log Cp (proj1 Nr) Near HB) as [s [Hs [Sm Rm]]].
  assert (Count : count (vector_family a c) = vector_arity a) by (apply (space_count a c HS)).
  destruct Rr as [_ [Gr Le]]. rewrite Count in Gr, Le. change (size (vector_family a c)) with (length (spanning c)) in Gr, Le.
  destruct (vectors_of_bounds a d lambda s s r) as [phi [Sol [k [Hk Most]]]]; fold c; try lra; auto.
  { intros g Hg _. apply Gr. lra. }
  exists phi, r, s, lambda. split; auto. split; auto. split; auto. split; auto. split.
  - exists k. split; auto. apply least_lub; auto. apply Sol; auto.
  - apply (exponent_between a (difference_order c) lambda r h HA Log Cp); auto. apply Sm.
Qed.
