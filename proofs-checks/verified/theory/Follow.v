(* A mask with a parameter whose value at each level follows from that of the level before by a recurrence (SPEC.md, section
   6.5, Theorem 49): the values come into a range and stay there, and from there on what is proved of all sequences holds. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Subcert Require Import Radius Integers Sections Check Subdivision Coefficients Exponent Levels Ranges.
Import ListNotations.
Open Scope Z_scope.

(* ---- claims ------------------------------------------------------------------------------------------------------------------ *)

(* w -> p(w)/q(w), or the root of that *)
Record rule := Rule { above_bar : list Z; below_bar : list Z; of_root : bool }.
Definition leads_to (r : rule) (x y : R) : Prop := let p := polynomial_at (above_bar r) x in let q := polynomial_at (below_bar r) x in
  (q <> 0 /\ if of_root r then 0 <= y /\ y * y * q = p else y * q = p)%R.
Definition follow (r : rule) (w : nat -> R) : Prop := forall k, leads_to r (w k) (w (S k)).

(* Without a last value all from the first one on *)
Definition starts (first : Q) (last : option Q) (x : R) : Prop :=
  (real_of first <= x)%R /\ forall u, last = Some u -> (x <= real_of u)%R.

(* There is a mask for each value in the range, and a sequence for each first value. From some level on, that of the claim if it
   has one, values are in the range; for data of each of these levels the scheme converges, and all exponents are above l. *)
Definition follow_hold (a : ranged) (r : rule) (first : Q) (last : option Q) (from : option nat) (low high l : Q) : Prop :=
  (forall x, between low high x -> polynomial_at (ranged_divisor a) x <> 0%R) /\
  (forall x, starts first last x -> exists w, w O = x /\ follow r w) /\
  exists s, (real_of l < s)%R /\ forall w, starts first last (w O) -> follow r w ->
  exists k0, (forall n, from = Some n -> (k0 <= n)%nat) /\ forall k, (k0 <= k)%nat -> between low high (w k) /\
  exists phi, limit_of_values a (fun i => w (k + i)%nat) phi /\ exponent_at_least phi s.

(* ---- the checker ------------------------------------------------------------------------------------------------------------- *)

(* Whether a polynomial is positive, or nowhere negative, from a/e to b/e: by its form, or by halves *)
Definition fits (strict : bool) (c : Z) : bool := if strict then 0 <? c else 0 <=? c.
Fixpoint signed_on (fuel : nat) (strict : bool) (a b e : Z) (l : list Z) : bool :=
  let f := polynomial_form a b e l in
  if negb (fits strict (hd 0 f) && fits strict (last f 0)) then false else if forallb (fits strict) f then true else
  match fuel with
  | O => false
  | S k => if signed_on k strict (2 * a) (a + b) (2 * e) l then signed_on k strict (a + b) (2 * b) (2 * e) l else false
  end.

Definition signed_between (strict : bool) (low high : Q) (l : list Z) : bool := (1 <=? length l)%nat &&
  signed_on 60 strict (Qnum low * Zpos (Qden high)) (Qnum high * Zpos (Qden low)) (Zpos (Qden low) * Zpos (Qden high)) l.

(* Of a polynomial of degree n at a/e + t, times e^n *)
Fixpoint shifted (a e : Z) (l : list Z) : list Z :=
  match l with [] => [] | c :: rest => let s := shifted a e rest in addmul (c * e ^ Z.of_nat (length rest)) [1] (addmul a s (0 :: map (Z.mul e) s)) end.

(* The same from the lower end on without an end: as far as `far` like this, and beyond by the coefficients *)
Definition signed_beyond (strict : bool) (low far : Q) (l : list Z) : bool :=
  let s := shifted (Qnum far) (Zpos (Qden far)) l in
  (Qnum low * Zpos (Qden far) <=? Qnum far * Zpos (Qden low)) && signed_between strict low far l && fits strict (hd 0 s) && forallb (Z.leb 0) s.

(* Times a sign: p - c q and d q - p, times the denominators of c and d *)
Definition bounded_below (sign : Z) (c : Q) (p q : list Z) : list Z := addmul (- (sign * Qnum c)) q (map (Z.mul (sign * Zpos (Qden c))) p).
Definition bounded_above (sign : Z) (d : Q) (p q : list Z) : list Z := addmul (- (sign * Zpos (Qden d))) p (map (Z.mul (sign * Qnum d)) q).
Definition squared (c : Q) : Q := Qmake (Qnum c * Qnum c) (Qden c * Qden c).
Definition not_negative (c : Q) : Q := if Qnum c <? 0 then Qmake 0 1 else c.

(* `test` tells whether a polynomial is positive, or nowhere negative, where the values are; `sign` is that of the denominator. *)
Section Leads.
Variables (r : rule) (sign : Z) (test : bool -> list Z -> bool).
Let p := above_bar r.
Let q := below_bar r.
Definition denominator_signed : bool := ((sign =? 1) || (sign =? -1)) && test true (map (Z.mul sign) q).
Definition next_at_least (c : Q) : bool := test false (bounded_below sign (if of_root r then squared (not_negative c) else c) p q).
Definition next_at_most (d : Q) : bool :=
  if of_root r then (0 <=? Qnum d) && test false (bounded_above sign (squared d) p q) else test false (bounded_above sign d p q).
(* At most nine tenths *)
Definition next_smaller : bool :=
  if of_root r then test false (addmul (- (sign * 100)) p (0 :: 0 :: map (Z.mul (sign * 81)) q))
  else test false (addmul (- (sign * 10)) p (0 :: map (Z.mul (sign * 9)) q)).
End Leads.

Definition leads (r : rule) (sign : Z) (from to : Q * Q) : bool :=
  let test strict l := signed_between strict (fst from) (snd from) l in
  denominator_signed r sign test && next_at_least r sign test (fst to) && next_at_most r sign test (snd to).

Definition descends (r : rule) (sign : Z) (low high far : Q) : bool :=
  let test strict l := signed_beyond strict high far l in
  (0 <? Qnum high) && denominator_signed r sign test && next_at_least r sign test low && next_smaller r sign test.

Definition less_or_equal (x y : Q) : bool := Qnum x * Zpos (Qden y) <=? Qnum y * Zpos (Qden x).
(* From one interval to the next one, with the sign of the denominator on it; the last one lies in the range. *)
Fixpoint way (r : rule) (at_ : Q * Q) (levels : list (Z * (Q * Q))) (low high : Q) : bool :=
  match levels with
  | [] => less_or_equal low (fst at_) && less_or_equal (snd at_) high
  | (sign, next) :: rest => leads r sign at_ next && way r next rest low high
  end.

Record follow_certificate := Follows_by { range_sign : Z; way_levels : list (Z * (Q * Q)); descent : option (Z * Q) }.

Definition check_follow (a : ranged) (r : rule) (first : Q) (last : option Q) (from : option nat) (low high l : Q)
    (common : Z) (cert : exponent_certificate) (c : follow_certificate) : bool :=
  check_range_levels a low high l common cert && leads r (range_sign c) (low, high) (low, high) &&
  way r (first, match last with Some u => u | None => high end) (way_levels c) low high &&
  match last, from with
  | Some _, Some n => (length (way_levels c) <=? n)%nat
  | Some _, None => true
  | None, Some _ => false
  | None, None => match descent c with Some (sign, far) => descends r sign low high far | None => false end
  end.

(* ---- signs of polynomials ---------------------------------------------------------------------------------------------------- *)

Open Scope R_scope.

Definition sign_holds (strict : bool) (x : R) : Prop := if strict then 0 < x else 0 <= x.

Lemma fits_sound strict c : fits strict c = true -> sign_holds strict (IZR c).
Proof. unfold fits, sign_holds. destruct strict; intros H; [apply Z.ltb_lt in H; apply IZR_lt|apply Z.leb_le in H; apply IZR_le]; auto. Qed.

Lemma sign_weaker strict x : sign_holds strict x -> 0 <= x.
Proof. unfold sign_holds. destruct strict; lra. Qed.

Lemma sign_scaled strict z x : 0 < z -> sign_holds strict (z * x) -> sign_holds strict x.
Proof.
  unfold sign_holds. intros Hz H. destruct strict.
  - apply (Rmult_lt_reg_l z); auto. lra.
  - apply (Rmult_le_reg_l z); auto. lra.
Qed.

Lemma form_signed strict f u v : 0 <= u -> 0 <= v -> u + v = 1 -> (1 <= length f)%nat -> forallb (fits strict) f = true ->
  sign_holds strict (form_at u v f).
Proof.
  intros Hu Hv Hs Hl H. rewrite forallb_forall in H. rewrite form_at_sum.
  assert (Each : forall j, (j < length f)%nat -> sign_holds strict (IZR (nth j f 0%Z))) by (intros j Hj; apply fits_sound, H, nth_In; auto).
  assert (Pos : forall j, (j < length f)%nat -> 0 <= IZR (nth j f 0%Z) * (u ^ j * v ^ (length f - 1 - j))).
  { intros j Hj. apply Rmult_le_pos. apply (sign_weaker strict); auto. apply Rmult_le_pos; apply pow_le; auto. }
  destruct strict; [|apply sum_nonneg; auto]. destruct (Rle_lt_dec (/ 2) u) as [U|U].
  - eapply Rlt_le_trans; [|apply (sum_term (length f) _ (length f - 1)); [auto|lia]]. cbv beta.
    replace (length f - 1 - (length f - 1))%nat with O by lia. simpl. rewrite Rmult_1_r. apply Rmult_lt_0_compat.
    apply (Each (length f - 1)%nat). lia. apply pow_lt. lra.
  - eapply Rlt_le_trans; [|apply (sum_term (length f) _ 0); [auto|lia]]. cbv beta. simpl. rewrite Rmult_1_l, Nat.sub_0_r.
    apply Rmult_lt_0_compat. apply (Each O). lia. apply pow_lt. lra.
Qed.

Lemma signed_on_sound fuel strict l : (1 <= length l)%nat -> forall a b e, (0 < e)%Z -> signed_on fuel strict a b e l = true ->
  forall x u v, 0 <= u -> 0 <= v -> u + v = 1 -> IZR e * x = IZR a * v + IZR b * u -> sign_holds strict (polynomial_at l x).
Proof.
  intros Hl. induction fuel; intros a b e He H x u v Hu Hv Hs E; cbn [signed_on] in H;
    (destruct (negb _); [discriminate|]); destruct (forallb _ _) eqn:Fits; assert (E0 : 0 < IZR e) by (apply IZR_lt; auto).
  1, 3: apply form_signed with (u := u) (v := v) in Fits; auto; [|rewrite form_length; auto];
    assert (Form := form_at_form u v Hs a b e x l E); apply (sign_scaled strict (IZR e ^ length l)); [apply pow_lt; auto|];
    rewrite <- Form; unfold sign_holds in *; destruct strict; [apply Rmult_lt_0_compat|apply Rmult_le_pos]; auto; lra.
  - discriminate.
  - destruct (signed_on fuel strict (2 * a) (a + b) (2 * e) l) eqn:H1; [|discriminate]. rename H into H2. destruct (Rle_lt_dec u (/ 2)) as [U|U].
    + apply (IHfuel (2 * a)%Z (a + b)%Z (2 * e)%Z ltac:(lia) H1 x (2 * u) (v - u)); try lra. rewrite plus_IZR, !mult_IZR. simpl (IZR 2).
      replace (2 * IZR e * x) with (2 * (IZR e * x)) by ring. rewrite E. ring.
    + apply (IHfuel (a + b)%Z (2 * b)%Z (2 * e)%Z ltac:(lia) H2 x (2 * u - 1) (2 * v)); try lra. rewrite plus_IZR, !mult_IZR. simpl (IZR 2).
      replace (2 * IZR e * x) with (2 * (IZR e * x)) by ring. rewrite E. replace u with (1 - v) by lra. ring.
Qed.

(* The ends of an interval, which may be one point *)
Lemma signed_between_sound strict low high l : signed_between strict low high l = true -> forall x, between low high x ->
  sign_holds strict (polynomial_at l x).
Proof.
  intros H x [X1 X2]. apply andb_prop in H. destruct H as [Hl H]. apply Nat.leb_le in Hl.
  assert (D1 : 0 < IZR (Zpos (Qden low))) by (apply IZR_lt; lia). assert (D2 : 0 < IZR (Zpos (Qden high))) by (apply IZR_lt; lia).
  set (a := real_of low) in *. set (b := real_of high) in *.
  assert (Ends : exists u v, 0 <= u /\ 0 <= v /\ u + v = 1 /\ x = a * v + b * u).
  { destruct (Rle_lt_or_eq_dec a b ltac:(lra)) as [L|L].
    - exists ((x - a) / (b - a)), ((b - x) / (b - a)). assert (0 < / (b - a)) by (apply Rinv_0_lt_compat; lra).
      split. apply Rmult_le_pos; lra. split. apply Rmult_le_pos; lra. split; field; lra.
    - exists 0, 1. repeat split; lra. }
  destruct Ends as [u [v [U [V [W E]]]]].
  eapply (signed_on_sound 60 strict l Hl); [|apply H|apply U|apply V|apply W|]. lia. rewrite !mult_IZR, E. unfold a, b, real_of. field. lra.
Qed.

Lemma polynomial_addmul c : forall f g x, polynomial_at (addmul c f g) x = IZR c * polynomial_at f x + polynomial_at g x.
Proof.
  induction f as [|y f IH]; intros [|z g] x; simpl; try lra.
  - unfold polynomial_at in IH |- *. cbn [fold_right]. rewrite mult_IZR. specialize (IH [] x). simpl in IH. rewrite IH. ring.
  - unfold polynomial_at in IH |- *. cbn [fold_right]. rewrite plus_IZR, mult_IZR, IH. ring.
Qed.

Lemma polynomial_map c l x : polynomial_at (map (Z.mul c) l) x = IZR c * polynomial_at l x.
Proof. induction l as [|y l IH]; unfold polynomial_at in *; cbn [map fold_right]. ring. rewrite IH, mult_IZR. ring. Qed.

Lemma polynomial_next l x : polynomial_at (0%Z :: l) x = x * polynomial_at l x.
Proof. unfold polynomial_at. cbn [fold_right]. simpl (IZR 0). ring. Qed.

Lemma shifted_sound a e x t l : IZR e * x = IZR a + IZR e * t -> IZR e * polynomial_at (shifted a e l) t = IZR e ^ length l * polynomial_at l x.
Proof.
  intros E. induction l as [|c l IH]. { unfold polynomial_at. simpl. ring. }
  cbn [shifted length]. rewrite !polynomial_addmul, polynomial_next, polynomial_map, mult_IZR, <- pow_IZR.
  change (polynomial_at [1%Z] t) with (1 + t * 0). change (polynomial_at (c :: l) x) with (IZR c + x * polynomial_at l x).
  rewrite <- tech_pow_Rmult. set (s := polynomial_at (shifted a e l) t) in *.
  replace (IZR e * (IZR c * IZR e ^ length l * (1 + t * 0) + (IZR a * s + t * (IZR e * s)))) with
    (IZR c * IZR e * IZR e ^ length l + (IZR a + IZR e * t) * (IZR e * s)) by ring.
  rewrite IH, <- E. ring.
Qed.

Lemma coefficients_not_negative l t : 0 <= t -> forallb (Z.leb 0) l = true -> 0 <= polynomial_at l t.
Proof.
  intros Ht. induction l as [|c l IH]; intros H; unfold polynomial_at in *; cbn [fold_right]. lra.
  cbn [forallb] in H. apply andb_prop in H. destruct H as [H1 H2]. apply Z.leb_le, IZR_le in H1.
  apply Rplus_le_le_0_compat; auto. apply Rmult_le_pos; auto.
Qed.

Lemma signed_beyond_sound strict low far l : signed_beyond strict low far l = true -> forall x, real_of low <= x -> sign_holds strict (polynomial_at l x).
Proof.
  intros H x Hx. unfold signed_beyond in H. cbv zeta in H. rewrite !andb_true_iff in H. destruct H as [[[_ H1] H2] H3].
  destruct (Rle_lt_dec x (real_of far)) as [L|L]. { apply (signed_between_sound strict low far l H1 x). split; auto. }
  assert (D : 0 < IZR (Zpos (Qden far))) by (apply IZR_lt; lia).
  assert (E : IZR (Zpos (Qden far)) * x = IZR (Qnum far) + IZR (Zpos (Qden far)) * (x - real_of far)) by (unfold real_of; field; lra).
  assert (S := shifted_sound _ _ _ _ l E). set (s := shifted (Qnum far) (Zpos (Qden far)) l) in *.
  apply (sign_scaled strict (IZR (Zpos (Qden far)) ^ length l)). apply pow_lt; auto. rewrite <- S.
  assert (V : sign_holds strict (polynomial_at s (x - real_of far))).
  { destruct s as [|c s]. apply fits_sound in H2. exact H2. cbn [hd] in H2. apply fits_sound in H2.
    cbn [forallb] in H3. apply andb_prop in H3. destruct H3 as [_ H3]. apply (coefficients_not_negative s (x - real_of far)) in H3; [|lra].
    change (polynomial_at (c :: s) (x - real_of far)) with (IZR c + (x - real_of far) * polynomial_at s (x - real_of far)).
    assert (0 <= (x - real_of far) * polynomial_at s (x - real_of far)) by (apply Rmult_le_pos; lra).
    unfold sign_holds in *. destruct strict; lra. }
  unfold sign_holds in *. destruct strict; [apply Rmult_lt_0_compat|apply Rmult_le_pos]; auto; lra.
Qed.

(* ---- one step ---------------------------------------------------------------------------------------------------------------- *)

Section Step.
Variables (r : rule) (sign : Z) (test : bool -> list Z -> bool) (values : R -> Prop).
Hypothesis Test : forall strict l, test strict l = true -> forall x, values x -> sign_holds strict (polynomial_at l x).
Hypothesis Signed : denominator_signed r sign test = true.
Let p := polynomial_at (above_bar r).
Let q := polynomial_at (below_bar r).

Lemma denominator_positive_there x : values x -> 0 < IZR sign * q x.
Proof.
  intros H. apply andb_prop in Signed. destruct Signed as [_ S]. assert (T0 := Test true _ S x H). rewrite polynomial_map in T0. exact T0.
Qed.

Lemma denominator_not_zero x : values x -> q x <> 0.
Proof. intros H E. assert (P := denominator_positive_there x H). rewrite E in P. lra. Qed.

(* A bound c of the quotient y of p and q at x, multiplied by both denominators *)
Ltac by_denominators bounded c x y Hx H E :=
  assert (T0 := Test false _ H x Hx); unfold bounded in T0; rewrite polynomial_addmul, polynomial_map in T0;
  fold p q in T0; simpl in T0; rewrite opp_IZR, !mult_IZR in T0; assert (P := denominator_positive_there x Hx);
  assert (D : 0 < IZR (Zpos (Qden c))) by (apply IZR_lt; lia); unfold real_of;
  apply (Rmult_le_reg_r (IZR (Zpos (Qden c)) * (IZR sign * q x))); [apply Rmult_lt_0_compat; auto|];
  replace (IZR (Qnum c) / IZR (Zpos (Qden c)) * (IZR (Zpos (Qden c)) * (IZR sign * q x))) with (IZR sign * IZR (Qnum c) * q x) by (field; lra);
  replace (y * (IZR (Zpos (Qden c)) * (IZR sign * q x))) with (IZR sign * IZR (Zpos (Qden c)) * (y * q x)) by ring; rewrite E; lra.

Lemma quotient_below c x y : values x -> test false (bounded_below sign c (above_bar r) (below_bar r)) = true -> y * q x = p x -> real_of c <= y.
Proof. intros Hx H E. by_denominators bounded_below c x y Hx H E. Qed.

Lemma quotient_above d x y : values x -> test false (bounded_above sign d (above_bar r) (below_bar r)) = true -> y * q x = p x -> y <= real_of d.
Proof. intros Hx H E. by_denominators bounded_above d x y Hx H E. Qed.

Lemma squared_real c : real_of (squared c) = real_of c * real_of c.
Proof.
  unfold real_of, squared. cbn [Qnum Qden]. rewrite Pos2Z.inj_mul, !mult_IZR. assert (0 < IZR (Zpos (Qden c))) by (apply IZR_lt; lia). field. lra.
Qed.

Lemma not_negative_real c : 0 <= real_of (not_negative c) /\ real_of c <= real_of (not_negative c).
Proof.
  assert (D : 0 < / IZR (Zpos (Qden c))) by (apply Rinv_0_lt_compat, IZR_lt; lia).
  unfold not_negative. destruct (Z.ltb_spec (Qnum c) 0) as [L|L].
  - apply IZR_lt in L. unfold real_of. cbn [Qnum Qden]. split. lra. assert (IZR (Qnum c) * / IZR (Zpos (Qden c)) <= 0); [|unfold Rdiv; lra].
    replace 0 with (0 * / IZR (Zpos (Qden c))) by ring. apply Rmult_le_compat_r; lra.
  - apply IZR_le in L. split; [|lra]. unfold real_of, Rdiv. apply Rmult_le_pos; lra.
Qed.

Lemma step_at_least c x y : next_at_least r sign test c = true -> values x -> leads_to r x y -> real_of c <= y.
Proof.
  intros H Hx [_ Hy]. unfold next_at_least in H. destruct (of_root r).
  - destruct Hy as [Y0 Hy]. apply (quotient_below _ x (y * y) Hx) in H; auto. rewrite squared_real in H.
    destruct (not_negative_real c) as [M0 M1]. eapply Rle_trans. apply M1. apply Rnot_lt_le. intros N. assert (y * y < real_of (not_negative c) * real_of (not_negative c)); [|lra].
    nra.
  - apply (quotient_below c x y Hx H Hy).
Qed.

Lemma step_at_most d x y : next_at_most r sign test d = true -> values x -> leads_to r x y -> y <= real_of d.
Proof.
  intros H Hx [_ Hy]. unfold next_at_most in H. destruct (of_root r).
  - apply andb_prop in H. destruct H as [H0 H]. destruct Hy as [Y0 Hy]. apply (quotient_above _ x (y * y) Hx) in H; auto. rewrite squared_real in H.
    apply Z.leb_le, IZR_le in H0. assert (0 <= real_of d) by (unfold real_of, Rdiv; apply Rmult_le_pos; auto; left; apply Rinv_0_lt_compat, IZR_lt; lia).
    apply Rnot_lt_le. intros N. assert (real_of d * real_of d < y * y); [|lra]. nra.
  - apply (quotient_above d x y Hx H Hy).
Qed.

Lemma step_smaller x y : next_smaller r sign test = true -> values x -> 0 < x -> leads_to r x y -> y <= 9 / 10 * x.
Proof.
  intros H Hx X0 [_ Hy]. unfold next_smaller in H. assert (P := denominator_positive_there x Hx). destruct (of_root r).
  - destruct Hy as [Y0 Hy]. assert (T0 := Test false _ H x Hx). rewrite polynomial_addmul, !polynomial_next, polynomial_map in T0.
    fold p q in T0, Hy. simpl in T0. rewrite opp_IZR, !mult_IZR in T0. rewrite <- Hy in T0.
    assert (S : 0 <= (IZR sign * q x) * (81 * (x * x) - 100 * (y * y))) by lra.
    assert (S' : 0 <= 81 * (x * x) - 100 * (y * y)). { apply (Rmult_le_reg_l (IZR sign * q x)); auto. lra. }
    apply Rnot_lt_le. intros N. nra.
  - assert (T0 := Test false _ H x Hx). rewrite polynomial_addmul, polynomial_next, polynomial_map in T0.
    fold p q in T0, Hy. simpl in T0. rewrite opp_IZR, !mult_IZR in T0. rewrite <- Hy in T0.
    assert (S : 0 <= (IZR sign * q x) * (9 * x - 10 * y)) by lra.
    assert (S' : 0 <= 9 * x - 10 * y). { apply (Rmult_le_reg_l (IZR sign * q x)); auto. lra. } lra.
Qed.

Definition next_value (x : R) : R := if of_root r then sqrt (p x / q x) else p x / q x.

Lemma step_exists c x : next_at_least r sign test c = true -> values x -> leads_to r x (next_value x).
Proof.
  intros H Hx. assert (Q0 := denominator_not_zero x Hx). split; auto. fold p q. unfold next_value, next_at_least in *. destruct (of_root r).
  - assert (Y : 0 <= p x / q x).
    { apply Rle_trans with (real_of (squared (not_negative c))). rewrite squared_real. apply Rmult_le_pos; apply not_negative_real.
      apply (quotient_below _ x _ Hx H). field. auto. }
    split. apply sqrt_pos. rewrite sqrt_sqrt by auto. field. auto.
  - field. auto.
Qed.
End Step.

(* ---- sequences --------------------------------------------------------------------------------------------------------------- *)

Fixpoint orbit (r : rule) (x : R) (k : nat) : R := match k with O => x | S k' => next_value r (orbit r x k') end.

Lemma orbit_next r x k : orbit r (next_value r x) k = orbit r x (S k).
Proof. induction k; auto. cbn [orbit] in *. rewrite IHk. auto. Qed.

Lemma leads_sound r sign at_ to : leads r sign at_ to = true -> forall x, between (fst at_) (snd at_) x ->
  leads_to r x (next_value r x) /\ forall y, leads_to r x y -> between (fst to) (snd to) y.
Proof.
  intros H x Hx. unfold leads in H. cbv zeta in H. rewrite !andb_true_iff in H. destruct H as [[H1 H2] H3].
  assert (Test : forall strict l, signed_between strict (fst at_) (snd at_) l = true -> forall x, between (fst at_) (snd at_) x -> sign_holds strict (polynomial_at l x)).
  { intros strict l. apply signed_between_sound. }
  split. { apply (step_exists r sign _ _ Test H1 (fst to) x H2 Hx). } intros y Hy. split.
  - apply (step_at_least r sign _ _ Test H1 (fst to) x y H2 Hx Hy).
  - apply (step_at_most r sign _ _ Test H1 (snd to) x y H3 Hx Hy).
Qed.

Lemma less_or_equal_sound x y : less_or_equal x y = true -> real_of x <= real_of y.
Proof.
  unfold less_or_equal. intros H. apply Z.leb_le, IZR_le in H. rewrite !mult_IZR in H.
  assert (0 < IZR (Zpos (Qden x))) by (apply IZR_lt; lia). assert (0 < IZR (Zpos (Qden y))) by (apply IZR_lt; lia). unfold real_of.
  apply (Rmult_le_reg_r (IZR (Zpos (Qden x)) * IZR (Zpos (Qden y)))). apply Rmult_lt_0_compat; auto.
  replace (IZR (Qnum x) / IZR (Zpos (Qden x)) * (IZR (Zpos (Qden x)) * IZR (Zpos (Qden y)))) with (IZR (Qnum x) * IZR (Zpos (Qden y))) by (field; lra).
  replace (IZR (Qnum y) / IZR (Zpos (Qden y)) * (IZR (Zpos (Qden x)) * IZR (Zpos (Qden y)))) with (IZR (Qnum y) * IZR (Zpos (Qden x))) by (field; lra). auto.
Qed.

Section Sequences.
Variables (r : rule) (low high : Q) (range_sign : Z).
Hypothesis Stays : leads r range_sign (low, high) (low, high) = true.

Lemma stays w : follow r w -> forall k0, between low high (w k0) -> forall k, (k0 <= k)%nat -> between low high (w k).
Proof.
  intros F k0 H0 k Hk. induction Hk; auto. destruct (leads_sound _ _ _ _ Stays (w m) IHHk) as [_ L]. apply L. apply F.
Qed.

Lemma orbit_from x : leads_to r x (next_value r x) -> follow r (orbit r (next_value r x)) -> follow r (orbit r x).
Proof. intros H F k. destruct k. exact H. rewrite <- (orbit_next r x k), <- (orbit_next r x (S k)). apply F. Qed.

Lemma orbit_stays x : between low high x -> follow r (orbit r x).
Proof.
  intros H. assert (B : forall k, between low high (orbit r x k)).
  { induction k; auto. destruct (leads_sound _ _ _ _ Stays (orbit r x k) IHk) as [L1 L2]. apply L2. exact L1. }
  intros k. apply (leads_sound _ _ _ _ Stays (orbit r x k) (B k)).
Qed.

Lemma way_sound levels : forall at_, way r at_ levels low high = true ->
  (forall x, between (fst at_) (snd at_) x -> follow r (orbit r x)) /\
  forall w, follow r w -> between (fst at_) (snd at_) (w O) -> between low high (w (length levels)).
Proof.
  induction levels as [|[sign next] rest IH]; intros at_ H; cbn [way] in H; apply andb_prop in H; destruct H as [H1 H2].
  - apply less_or_equal_sound in H1, H2.
    assert (I : forall x, between (fst at_) (snd at_) x -> between low high x) by (intros x [X1 X2]; split; lra).
    split. intros x Hx. apply orbit_stays; auto. intros w _ Hw. apply I. exact Hw.
  - destruct (IH next H2) as [E G]. split.
    + intros x Hx. destruct (leads_sound _ _ _ _ H1 x Hx) as [L1 L2]. apply orbit_from; auto.
    + intros w F Hw. cbn [length]. destruct (leads_sound _ _ _ _ H1 (w O) Hw) as [_ L2].
      apply (G (fun k => w (S k))). intros k. apply F. apply L2, F.
Qed.

Variables (sign : Z) (far : Q).
Hypothesis Descends : descends r sign low high far = true.

Lemma high_positive : 0 < real_of high.
Proof.
  unfold descends in Descends. cbv zeta in Descends. rewrite !andb_true_iff in Descends. destruct Descends as [[[H _] _] _].
  apply Z.ltb_lt, IZR_lt in H. unfold real_of. apply Rdiv_lt_0_compat; auto. apply IZR_lt. lia.
Qed.

Lemma step_down x : real_of high < x -> leads_to r x (next_value r x) /\ forall y, leads_to r x y -> real_of low <= y <= 9 / 10 * x.
Proof.
  intros Hx. assert (H0 := high_positive). assert (H := Descends). unfold descends in H. cbv zeta in H. rewrite !andb_true_iff in H. destruct H as [[[_ H1] H2] H3].
  assert (Test : forall strict l, signed_beyond strict high far l = true -> forall x, real_of high <= x -> sign_holds strict (polynomial_at l x)).
  { intros strict l. apply signed_beyond_sound. }
  assert (Hx' : real_of high <= x) by lra.
  split. { apply (step_exists r sign _ _ Test H1 low x H2 Hx'). } intros y Hy. split.
  - apply (step_at_least r sign _ _ Test H1 low x y H2 Hx' Hy).
  - apply (step_smaller r sign _ _ Test H1 x y H3 Hx'); auto. lra.
Qed.

Lemma orbit_descends x : real_of high < x -> follow r (orbit r x).
Proof.
  intros Hx. assert (B : forall k, real_of high < orbit r x k \/ between low high (orbit r x k)).
  { induction k; auto. destruct IHk as [K|K].
    - destruct (step_down _ K) as [L1 L2]. destruct (L2 _ L1) as [L3 _]. cbn [orbit].
      destruct (Rle_lt_dec (next_value r (orbit r x k)) (real_of high)); [right; split|left]; auto.
    - destruct (leads_sound _ _ _ _ Stays _ K) as [L1 L2]. right. apply L2. exact L1. }
  intros k. destruct (B k) as [K|K]. apply (step_down _ K). apply (leads_sound _ _ _ _ Stays _ K).
Qed.

Lemma comes_down n : forall w, follow r w -> real_of high < w O -> w O * (9 / 10) ^ n <= real_of high -> exists k, between low high (w k).
Proof.
  induction n; intros w F H0 Hn. { simpl in Hn. lra. }
  destruct (step_down _ H0) as [_ L]. destruct (L _ (F O)) as [L1 L2]. destruct (Rle_lt_dec (w 1%nat) (real_of high)) as [K|K].
  - exists 1%nat. split; auto.
  - destruct (IHn (fun k => w (S k)) (fun k => F (S k)) K) as [k Hk]. 2: exists (S k); exact Hk.
    eapply Rle_trans; [|apply Hn]. rewrite <- tech_pow_Rmult. assert (P : 0 < (9 / 10) ^ n) by (apply pow_lt; lra).
    replace (w O * (9 / 10 * (9 / 10) ^ n)) with (9 / 10 * w O * (9 / 10) ^ n) by ring. apply Rmult_le_compat_r; lra.
Qed.

Lemma comes_into w : follow r w -> real_of high < w O -> exists k, between low high (w k).
Proof.
  intros F H0. assert (P := high_positive).
  destruct (pow_lt_1_zero (9 / 10) ltac:(rewrite Rabs_pos_eq; lra) (real_of high / w O) ltac:(apply Rdiv_lt_0_compat; lra)) as [n Hn].
  apply (comes_down n); auto. specialize (Hn n (le_n n)). rewrite Rabs_pos_eq in Hn by (apply pow_le; lra).
  apply (Rmult_lt_compat_l (w O)) in Hn; [|lra]. replace (w O * (real_of high / w O)) with (real_of high) in Hn by (field; lra). lra.
Qed.
End Sequences.

(* What the checker accepts is true. *)
Theorem check_follow_sound a r first last from low high l common cert c :
  check_follow a r first last from low high l common cert c = true -> follow_hold a r first last from low high l.
Proof.
  intros H. unfold check_follow in H. rewrite !andb_true_iff in H. destruct H as [[[HR HS] HW] HL].
  destruct (check_range_levels_sound a low high l common cert HR) as [D [s [Hs E]]]. split; auto.
  destruct (way_sound r low high _ HS (way_levels c) _ HW) as [WE WI]. cbn [fst snd] in WE, WI.
  set (n0 := length (way_levels c)) in *.
  assert (Late : forall w k0, follow r w -> between low high (w k0) -> forall k, (k0 <= k)%nat -> between low high (w k) /\
    exists phi, limit_of_values a (fun i => w (k + i)%nat) phi /\ exponent_at_least phi s).
  { intros w k0 F H0 k Hk. assert (St := stays r low high _ HS w F k0 H0). split. apply St; auto. apply E. intros i. apply St. lia. }
  destruct last as [u|].
  - split. { intros x [X1 X2]. exists (orbit r x). split; auto. apply WE. split; auto. }
    exists s. split; auto. intros w [X1 X2] F. exists n0. split.
    { intros n ->. apply Nat.leb_le in HL. exact HL. }
    apply Late; auto. apply WI; auto. split; auto.
  - destruct from as [n|]; [discriminate|]. destruct (descent c) as [[sign far]|]; [|discriminate]. split.
    { intros x [X1 _]. exists (orbit r x). split; auto. destruct (Rle_lt_dec x (real_of high)) as [K|K].
      apply WE. split; auto. apply (orbit_descends r low high _ HS sign far HL x K). }
    exists s. split; auto. intros w [X1 _] F. destruct (Rle_lt_dec (w O) (real_of high)) as [K|K].
    + exists n0. split. discriminate. apply Late; auto. apply WI; auto. split; auto.
    + destruct (comes_into r low high sign far HL w F K) as [k0 Hk0]. exists k0. split. discriminate. apply Late; auto.
Qed.
