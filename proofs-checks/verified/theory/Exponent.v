(* Lower ends of Hoelder exponents: the checker takes the factors out of a mask, forms the difference matrices, and has
   their joint spectral radius checked. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Integers Sections Check Subdivision Coefficients Stability.
Import ListNotations.
Open Scope Z_scope.

(* ---- claims: what is proved of a mask ---------------------------------------------------------------------------- *)

(* The coefficients first, first + 1, ... are those of the list, common a common denominator; others are 0. *)
Record scheme := Scheme { arity : nat; first : Z; coefficients : list Z; common : Z }.
Definition coefficient (l : list Z) (common first : Z) : Z -> R := fun i =>
  if i <? first then 0%R else (IZR (nth (Z.to_nat (i - first)) l 0%Z) / IZR common)%R.

Definition limit_of (a : scheme) (phi : R -> R) : Prop :=
  is_limit (arity a) (first a) (length (coefficients a) - 1) (coefficient (coefficients a) (common a) (first a)) phi.

(* The scheme converges, and the Hoelder exponent of its limit is at least l. *)
Definition exponent_holds (a : scheme) (l : Q) : Prop := exists phi, limit_of a phi /\ exponent_at_least phi (real_of l).

(* ---- symbols ----------------------------------------------------------------------------------------------------- *)

(* The product with 1 + z + ... + z^(arity - 1), and the quotient if there is unity *)
Fixpoint times_sigma (arity : nat) (l : list Z) : list Z :=
  match arity with O => [] | S k => addmul 1 l (0 :: times_sigma k l) end.
Fixpoint quotients (degree : nat) (recent l : list Z) : list Z :=
  match l with
  | [] => []
  | x :: rest => let q := x - fold_right Z.add 0 recent in q :: quotients degree (firstn degree (q :: recent)) rest
  end.
Definition over_sigma (arity : nat) (l : list Z) : list Z :=
  firstn (length l - (arity - 1)) (quotients (arity - 1) [] l).
Fixpoint iterate (m : nat) (f : list Z -> list Z) (l : list Z) : list Z :=
  match m with O => l | S k => f (iterate k f l) end.

(* (T_t)_jk = b_(arity j + t - k), for t = 0, ..., arity - 1 and j, k = 0, ..., size - 1. *)
Definition transition (arity size : nat) (b : list Z) : list zmat :=
  map (fun t => map (fun j => let s := (arity * j + t)%nat in
    map (fun k => if (k <=? s)%nat then nth (s - k) b 0 else 0) (seq 0 size)) (seq 0 size)) (seq 0 arity).

Definition matrix_size (arity : nat) (b : list Z) : nat := Nat.max 1 ((length b - 1 + (arity - 2)) / (arity - 1)).

(* arity^order times the mask without its factor (1 + z + ... + z^(arity - 1))^order, and its difference matrices *)
Definition quotient (a : scheme) (order : nat) : list Z := iterate order (over_sigma (arity a)) (coefficients a).
Definition difference_symbol (a : scheme) (order : nat) : list Z :=
  map (Z.mul (Z.of_nat (arity a) ^ Z.of_nat order)) (quotient a order).
Definition difference_family (a : scheme) (order : nat) : family :=
  let b := difference_symbol a order in let size := matrix_size (arity a) b in
  Family size (common a) (transition (arity a) size b).

(* ---- powers ------------------------------------------------------------------------------------------------------ *)

Definition unity : Z := 2 ^ 320.

(* At most unity * base^(top/bottom): so many binary digits of the exponent, square roots rounded down *)
Definition digits : nat := 8 * 16.
Fixpoint roots_below (base : Z) (k : nat) (top bottom : Z) : Z :=
  match k with
  | O => unity
  | S k' => Z.sqrt (unity * (if bottom <=? 2 * top then base * roots_below base k' (2 * top - bottom) bottom
                             else roots_below base k' (2 * top) bottom))
  end.
Fixpoint power_below (base : Z) (whole : nat) (top bottom : Z) : Z :=
  match whole with
  | O => roots_below base digits top bottom
  | S k => if bottom <=? top then base * power_below base k (top - bottom) bottom else roots_below base digits top bottom
  end.

Lemma unity_positive : (0 < IZR unity)%R.
Proof. apply IZR_lt. reflexivity. Qed.

Section Powers.
Variables (base : Z) (lambda : R).
Hypothesis Base : 2 <= base.
Hypothesis Log : exp lambda = IZR base.

Lemma base_log_positive : (0 < lambda)%R.
Proof.
  apply Rnot_le_lt. intros H. apply exp_at_most in H. rewrite exp_0, Log in H. apply IZR_le in Base. lra.
Qed.

Lemma roots_below_sound k : forall top bottom, 0 <= top -> 0 < bottom ->
  0 <= roots_below base k top bottom /\
  (IZR (roots_below base k top bottom) <= IZR unity * exp (IZR top / IZR bottom * lambda))%R.
Proof.
  assert (L := base_log_positive). assert (P1 := unity_positive).
  induction k; intros top bottom Ht Hd; cbn [roots_below].
  - split. { unfold unity. lia. }
    assert (H : (1 <= exp (IZR top / IZR bottom * lambda))%R).
    { rewrite <- exp_0. apply exp_at_most. apply IZR_le in Ht. apply IZR_lt in Hd.
      apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
    generalize (Rmult_le_compat_l (IZR unity) _ _ (Rlt_le _ _ P1) H). lra.
  - set (v := if bottom <=? 2 * top then base * roots_below base k (2 * top - bottom) bottom
              else roots_below base k (2 * top) bottom).
    assert (V : 0 <= v /\ (IZR v <= IZR unity * exp (2 * (IZR top / IZR bottom) * lambda))%R).
    { assert (Hd' := Hd). apply IZR_lt in Hd'. unfold v. destruct (Z.leb_spec bottom (2 * top)) as [H|H].
      - destruct (IHk (2 * top - bottom) bottom ltac:(lia) Hd) as [V1 V2]. split. nia.
        rewrite mult_IZR. apply Rmult_le_compat_l with (r := IZR base) in V2; [|apply IZR_le; lia]. eapply Rle_trans. apply V2. right.
        replace (2 * (IZR top / IZR bottom) * lambda)%R with (lambda + (IZR (2 * top - bottom) / IZR bottom * lambda))%R
          by (rewrite minus_IZR, mult_IZR; field; lra).
        rewrite exp_plus, Log. ring.
      - destruct (IHk (2 * top) bottom ltac:(lia) Hd) as [V1 V2]. split; auto. eapply Rle_trans. apply V2. right. f_equal. f_equal.
        rewrite mult_IZR. field. lra. }
    destruct V as [V1 V2]. split. apply Z.sqrt_nonneg.
    destruct (Z.sqrt_spec (unity * v) ltac:(unfold unity; nia)) as [S _]. set (r := Z.sqrt (unity * v)) in *.
    assert (R0 : 0 <= r) by apply Z.sqrt_nonneg. apply IZR_le in S, R0. rewrite !mult_IZR in S.
    set (p := exp (IZR top / IZR bottom * lambda)) in *. assert (Pp : (0 < p)%R) by apply exp_pos.
    assert (E : exp (2 * (IZR top / IZR bottom) * lambda) = (p * p)%R).
    { unfold p. rewrite <- exp_plus. f_equal. ring. }
    rewrite E in V2. apply Rsqr_incr_0_var; [|apply Rmult_le_pos; lra]. unfold Rsqr.
    eapply Rle_trans. apply S. apply Rmult_le_compat_l with (r := IZR unity) in V2; [|lra]. lra.
Qed.

Lemma power_below_sound whole : forall top bottom, 0 <= top -> 0 < bottom ->
  (IZR (power_below base whole top bottom) <= IZR unity * exp (IZR top / IZR bottom * lambda))%R.
Proof.
  induction whole; intros top bottom Ht Hd; cbn [power_below]. apply roots_below_sound; auto.
  destruct (Z.leb_spec bottom top); [|apply roots_below_sound; auto].
  rewrite mult_IZR. specialize (IHwhole (top - bottom) bottom ltac:(lia) Hd). apply IZR_lt in Hd.
  apply Rmult_le_compat_l with (r := IZR base) in IHwhole; [|apply IZR_le; lia]. eapply Rle_trans. apply IHwhole. right.
  replace (IZR top / IZR bottom * lambda)%R with (lambda + (IZR (top - bottom) / IZR bottom * lambda))%R by (rewrite minus_IZR; field; lra).
  rewrite exp_plus, Log. ring.
Qed.
End Powers.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

(* The order of the factor, a bound of the radius, and why it holds. *)
Record exponent_certificate := Exponent { order : nat; bound : Q; of_radius : certificate }.

Definition below_power (a : scheme) (l : Q) (order : nat) (u : Q) : bool :=
  let bottom := Zpos (Qden l) in let top := Z.of_nat order * bottom - Qnum l in
  (0 <? Qnum l) && (0 <=? top) && (Qnum u * unity <=? power_below (Z.of_nat (arity a)) order top bottom * Zpos (Qden u)).

Definition divides (a : scheme) (order : nat) : bool :=
  same (iterate order (times_sigma (arity a)) (quotient a order)) (coefficients a) &&
  (length (quotient a order) - 1 + order * (arity a - 1) <=? length (coefficients a) - 1)%nat.

(* ---- what it says of the symbols --------------------------------------------------------------------------------- *)

Lemma coefficient_addmul l r e F i : coefficient (addmul 1 l (0 :: r)) e F i = (coefficient l e F i + coefficient r e F (i - 1))%R.
Proof.
  unfold coefficient. destruct (Z.ltb_spec i F), (Z.ltb_spec (i - 1) F); try lia.
  - lra.
  - replace (Z.to_nat (i - F)) with O by lia. assert (H1 := f_equal (fun f => f O) (vr_addmul 1 l (0 :: r))).
    unfold vr, plus, scal in H1. rewrite H1. simpl. unfold Rdiv. lra.
  - replace (Z.to_nat (i - F)) with (S (Z.to_nat (i - 1 - F))) by lia.
    assert (H1 := f_equal (fun f => f (S (Z.to_nat (i - 1 - F)))) (vr_addmul 1 l (0 :: r))).
    unfold vr, plus, scal in H1. rewrite H1. simpl nth. unfold Rdiv. lra.
Qed.

Lemma coefficient_sigma k l e F i : coefficient (times_sigma k l) e F i = sum k (fun s => coefficient l e F (i - Z.of_nat s)).
Proof.
  revert i. induction k; intros i.
  - simpl. unfold coefficient. destruct (i <? F); auto. rewrite nth_nil. unfold Rdiv. lra.
  - cbn [times_sigma]. rewrite coefficient_addmul, IHk. change (S k) with (1 + k)%nat. rewrite sum_add. cbn [sum].
    rewrite Rplus_0_l. f_equal. f_equal. lia. apply sum_ext; intros. f_equal. lia.
Qed.

Lemma coefficient_iterate A m l e F : (2 <= A)%nat -> forall i,
  coefficient (iterate m (times_sigma A) l) e F i = (INR A ^ m * smoothed A m (coefficient l e F) i)%R.
Proof.
  intros HA. assert (PA := arity_positive A HA). induction m; intros i. simpl. lra.
  cbn [iterate smoothed]. rewrite coefficient_sigma. rewrite (sum_ext A _ (fun s => INR A ^ m * smoothed A m (coefficient l e F) (i - Z.of_nat s))%R) by auto.
  rewrite sum_scal. unfold smooth. simpl pow. field. lra.
Qed.

Lemma smoothed_scal A m c f : forall i, smoothed A m (fun i => c * f i)%R i = (c * smoothed A m f i)%R.
Proof.
  induction m; intros i; simpl; auto. unfold smooth.
  rewrite (sum_ext A _ (fun s => c * smoothed A m f (i - Z.of_nat s))%R) by auto. rewrite sum_scal. ring.
Qed.

Lemma coefficient_map c l e F i : coefficient (map (Z.mul c) l) e F i = (IZR c * coefficient l e F i)%R.
Proof.
  unfold coefficient. destruct (i <? F). lra. replace 0 with (c * 0) at 1 by lia. rewrite map_nth, mult_IZR. unfold Rdiv. ring.
Qed.

Lemma coefficient_shift l e F i : coefficient l e F i = coefficient l e 0 (i - F).
Proof. unfold coefficient. replace (i - F - 0) with (i - F) by lia. destruct (Z.ltb_spec i F), (Z.ltb_spec (i - F) 0); auto; lia. Qed.

Lemma coefficient_support l e i : i < 0 \/ Z.of_nat (length l - 1) < i -> coefficient l e 0 i = 0%R.
Proof.
  intros H. unfold coefficient. destruct (Z.ltb_spec i 0); auto. rewrite nth_overflow by lia. unfold Rdiv. lra.
Qed.

Lemma sum_list l n : (length l <= n)%nat -> sum n (fun i => IZR (nth i l 0)) = IZR (fold_right Z.add 0 l).
Proof.
  revert n. induction l; intros n H.
  - apply sum_zero. intros. rewrite nth_nil. auto.
  - destruct n; [simpl in H; lia|]. change (S n) with (1 + n)%nat. rewrite sum_add. cbn [sum fold_right]. rewrite plus_IZR.
    rewrite <- (IHl n) by (simpl in H; lia). simpl. lra.
Qed.

Lemma coefficient_total l e F L : (length l - 1 <= L)%nat -> total F L (coefficient l e F) = (IZR (fold_right Z.add 0%Z l) / IZR e)%R.
Proof.
  intros H. rewrite <- (sum_list l (S L)) by lia. unfold Rdiv. rewrite Rmult_comm, <- sum_scal. unfold total. apply sum_ext; intros i Hi.
  unfold coefficient. destruct (Z.ltb_spec (F + Z.of_nat i) F); [lia|]. replace (Z.to_nat (F + Z.of_nat i - F)) with i by lia.
  unfold Rdiv. ring.
Qed.

Lemma matrix_size_fits A b : (2 <= A)%nat -> (length b - 1 <= matrix_size A b * (A - 1))%nat /\ (1 <= matrix_size A b)%nat.
Proof.
  intros HA. unfold matrix_size. set (N := (length b - 1)%nat). assert (D := Nat.div_mod (N + (A - 2)) (A - 1) ltac:(lia)).
  assert (M := Nat.mod_upper_bound (N + (A - 2)) (A - 1) ltac:(lia)). set (d := ((N + (A - 2)) / (A - 1))%nat) in *. split; [|lia].
  apply Nat.le_trans with (d * (A - 1))%nat. nia. apply Nat.mul_le_mono_r. lia.
Qed.

Lemma transition_entry A size b e t j k : (t < A)%nat -> (j < size)%nat -> (k < size)%nat ->
  real (Family size e (transition A size b)) t j k = scheme_matrix A (coefficient b e 0) t j k.
Proof.
  intros Ht Hj Hk. unfold real, scheme_matrix, mr, letter, transition, entry. cbn [matrices denominator].
  rewrite nth_map_seq, nth_map_seq by auto. cbv zeta. rewrite nth_map_seq by auto.
  unfold coefficient.
  destruct (Nat.leb_spec k (A * j + t)), (Z.ltb_spec (Z.of_nat A * Z.of_nat j + Z.of_nat t - Z.of_nat k) 0); try lia.
  - f_equal. f_equal. f_equal. lia.
  - unfold Rdiv. lra.
Qed.

(* A bound of the radius holds for the unity radius that there is. *)
Lemma radius_bounded F u : claim_holds (Claim F None (Some u)) -> radius_at_most (size F) (count F) (real F) (real_of u).
Proof.
  intros H r Hr H0. destruct (radius_exists (size F) (count F) (real F)) as [x Hx].
  destruct (H x Hx) as [_ U]. specialize (U u eq_refl). destruct Hx as [_ [G _]]. apply G. lra.
Qed.

Lemma below_power_sound lambda a l m u : exp lambda = INR (arity a) -> (2 <= arity a)%nat -> below_power a l m u = true ->
  (0 < real_of l <= INR m)%R /\ (real_of u <= exp ((INR m - real_of l) * lambda))%R.
Proof.
  intros Hlog HA H. unfold below_power in H. cbv zeta in H. apply andb_prop in H. destruct H as [H H3]. apply andb_prop in H. destruct H as [H1 H2].
  apply Z.ltb_lt in H1. apply Z.leb_le in H2, H3. set (top := Z.of_nat m * Zpos (Qden l) - Qnum l) in *.
  assert (D : (0 < IZR (Zpos (Qden l)))%R) by (apply IZR_lt; lia). assert (D' : (0 < IZR (Zpos (Qden u)))%R) by (apply IZR_lt; lia).
  assert (E : (INR m - real_of l)%R = (IZR top / IZR (Zpos (Qden l)))%R).
  { unfold top, real_of. rewrite minus_IZR, mult_IZR, <- INR_IZR_INZ. field. lra. }
  split.
  - assert (0 <= IZR top / IZR (Zpos (Qden l)))%R.
    { apply IZR_le in H2. apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
    split; [|lra]. unfold real_of. apply IZR_lt in H1. apply Rdiv_lt_0_compat; auto.
  - rewrite E. rewrite INR_IZR_INZ in Hlog.
    assert (P := power_below_sound (Z.of_nat (arity a)) lambda ltac:(lia) Hlog m top (Zpos (Qden l)) H2 ltac:(lia)).
    set (x := power_below (Z.of_nat (arity a)) m top (Zpos (Qden l))) in *.
    apply IZR_le in H3. rewrite !mult_IZR in H3. assert (P1 := unity_positive).
    unfold real_of. apply (Rmult_le_reg_r (IZR unity * IZR (Zpos (Qden u)))). apply Rmult_lt_0_compat; auto.
    replace (IZR (Qnum u) / IZR (Zpos (Qden u)) * (IZR unity * IZR (Zpos (Qden u))))%R with (IZR (Qnum u) * IZR unity)%R by (field; lra).
    eapply Rle_trans. apply H3. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra.
Qed.

(* All but the radius *)
Definition reducible (a : scheme) (order : nat) : bool :=
  (2 <=? arity a)%nat && (0 <? common a) && divides a order &&
  (fold_right Z.add 0 (difference_symbol a order) =? Z.of_nat (arity a) * common a).
Definition reduces (a : scheme) (l : Q) (order : nat) (u : Q) : bool := reducible a order && below_power a l order u.

(* The symbol of the differences in its place *)
Definition shifted_symbol (a : scheme) (order : nat) : Z -> R :=
  fun i => coefficient (difference_symbol a order) (common a) 0 (i - first a).

Lemma reducible_arity a m : reducible a m = true -> (2 <= arity a)%nat /\ (0 < IZR (common a))%R.
Proof.
  unfold reducible. rewrite !andb_true_iff. intros [[[HA HO] _] _]. split. apply Nat.leb_le; auto. apply IZR_lt, Z.ltb_lt; auto.
Qed.

Lemma symbol_fits a m : reducible a m = true ->
  (length (difference_symbol a m) - 1 + m * (arity a - 1) <= length (coefficients a) - 1)%nat.
Proof.
  unfold reducible, divides. rewrite !andb_true_iff. intros [[_ [_ HL]] _].
  unfold difference_symbol. rewrite map_length. apply Nat.leb_le. auto.
Qed.

Lemma mask_smoothed a m : reducible a m = true ->
  coefficient (coefficients a) (common a) (first a) = smoothed (arity a) m (shifted_symbol a m).
Proof.
  intros H. destruct (reducible_arity a m H) as [HA _]. unfold reducible, divides in H. rewrite !andb_true_iff in H.
  destruct H as [[_ [HD _]] _]. apply same_spec in HD. extensionality i.
  rewrite <- HD, coefficient_iterate, <- smoothed_scal by auto. f_equal. extensionality k.
  unfold shifted_symbol. rewrite <- coefficient_shift. unfold difference_symbol.
  rewrite coefficient_map, <- (arity_power (arity a) HA). reflexivity.
Qed.

Lemma symbol_total a m L : reducible a m = true -> (length (difference_symbol a m) - 1 <= L)%nat ->
  total (first a) L (shifted_symbol a m) = INR (arity a).
Proof.
  intros H HL. destruct (reducible_arity a m H) as [_ HO]. unfold reducible in H. rewrite !andb_true_iff in H.
  destruct H as [_ HT]. apply Z.eqb_eq in HT.
  replace (shifted_symbol a m) with (coefficient (difference_symbol a m) (common a) (first a))
    by (extensionality i; apply coefficient_shift).
  rewrite coefficient_total, HT, mult_IZR, <- INR_IZR_INZ by auto. field. lra.
Qed.

Definition refined_data (a : scheme) : nat -> Z -> R :=
  refined (arity a) (first a) (length (coefficients a) - 1) (coefficient (coefficients a) (common a) (first a)).

(* The limit, and all that the checkers need of it *)
Theorem limit_of_growth a lambda l m most : reducible a m = true -> exp lambda = INR (arity a) -> (0 < l <= INR m)%R ->
  (most <= exp ((INR m - l) * lambda))%R -> let T := difference_family a m in
  radius_at_most (size T) (count T) (real T) most ->
  exists phi, limit_of a phi /\ exponent_at_least phi l /\ tends (arity a) (refined_data a) phi /\
  (forall i, subdivide (arity a) (first a) (length (coefficients a) - 1) (coefficient (coefficients a) (common a) (first a)) (fun _ => 1%R) i = 1%R) /\
  forall lambda g upper, exp lambda = INR (arity a) -> stable phi -> radius_at_least (size T) (count T) (real T) g -> (1 < g)%R ->
    (exp ((INR m - upper) * lambda) <= g)%R -> exponent_at_most phi upper.
Proof.
  intros H Hlog Hl HU T HR. destruct (reducible_arity a m H) as [HA _]. assert (HL := symbol_fits a m H).
  assert (EM := mask_smoothed a m H). set (A := arity a) in *.
  set (b := difference_symbol a m) in *. set (F := first a) in *. set (L := (length (coefficients a) - 1)%nat) in *.
  destruct (matrix_size_fits A b HA) as [W1 W2]. set (W := matrix_size A b) in *.
  assert (PA := arity_positive A HA).
  set (f := shifted_symbol a m) in *.
  assert (EC : count T = A) by (unfold T, difference_family; cbv zeta; unfold count, transition; cbn [matrices]; rewrite map_length, seq_length; auto).
  assert (ET : forall r, growth (size T) (count T) (real T) r <-> growth W A (scheme_matrix A (coefficient b (common a) 0)) r).
  { intros r. rewrite EC. split; intros G; eapply growth_ext; try apply G; intros t i j Ht Hi Hj; [|symmetry]; apply transition_entry; auto. }
  assert (Sb : forall i, i < 0 \/ Z.of_nat (length b - 1) < i -> coefficient b (common a) 0 i = 0%R) by (intros; apply coefficient_support; auto).
  assert (Sf : supported F (length b - 1) f) by (intros i Hi; apply Sb; lia).
  assert (Tf : total F L f = INR A) by (apply symbol_total; auto; fold b; clear -HL; lia).
  destruct (radius_exponent A (length b - 1) W (coefficient b (common a) 0) HA Sb W1 W2 L
    ltac:(clear -HL; lia) lambda F most m l Hlog) as [phi [Lim [Td Ex]]]; auto.
  { intros r Hr H0. apply ET. apply HR; auto. }
  fold f in Lim, Td. exists phi. unfold limit_of, refined_data. fold A F L. rewrite EM.
  split; auto. split; auto. split; auto. split.
  - destruct m as [|k]. { simpl in Hl. lra. } intros i. cbn [smoothed]. rewrite Nat.mul_succ_l in HL.
    apply (smooth_classes A F L HA (length b - 1 + k * (A - 1))).
    + apply (smoothed_supported A F HA). auto.
    + revert HL. generalize (k * (A - 1))%nat. clear -HA. lia.
    + rewrite (smoothed_total A F L HA (length b - 1)); auto. revert HL. generalize (k * (A - 1))%nat. clear -HA. lia.
  - intros lambda' g upper Hlog' St HG G1 GU.
    apply (radius_upper A (length b - 1) W (coefficient b (common a) 0) L F m lambda' phi g upper HA Sb W1 W2 HL Hlog' Td St); auto.
    intros r Hr G. apply HG; auto. apply ET. auto.
Qed.

Theorem limit_of_radius a l m u : reduces a l m u = true -> let T := difference_family a m in
  radius_at_most (size T) (count T) (real T) (real_of u) ->
  exists phi, limit_of a phi /\ exponent_at_least phi (real_of l) /\ tends (arity a) (refined_data a) phi /\
  (forall i, subdivide (arity a) (first a) (length (coefficients a) - 1) (coefficient (coefficients a) (common a) (first a)) (fun _ => 1%R) i = 1%R) /\
  forall lambda g upper, exp lambda = INR (arity a) -> stable phi -> radius_at_least (size T) (count T) (real T) g -> (1 < g)%R ->
    (exp ((INR m - upper) * lambda) <= g)%R -> exponent_at_most phi upper.
Proof.
  intros H T HR. apply andb_prop in H. destruct H as [H HU].
  assert (HA : (2 <= arity a)%nat).
  { unfold reducible in H. repeat rewrite andb_true_iff in H. destruct H as [[[HA _] _] _]. apply Nat.leb_le; auto. }
  destruct (exp_onto (INR (arity a)) (arity_positive (arity a) HA)) as [lambda Hlog].
  apply (below_power_sound lambda) in HU; auto. destruct HU as [Hl HU].
  apply (limit_of_growth a lambda (real_of l) m (real_of u)); auto.
Qed.

Theorem exponent_of_radius a l m u : reduces a l m u = true -> let T := difference_family a m in
  radius_at_most (size T) (count T) (real T) (real_of u) -> exponent_holds a l.
Proof. intros H T HR. destruct (limit_of_radius a l m u H HR) as [phi [Lim [Ex _]]]. exists phi. auto. Qed.

Definition check_exponent_lower (a : scheme) (l : Q) (cert : exponent_certificate) : bool :=
  reduces a l (order cert) (bound cert) &&
  check_radius (Claim (difference_family a (order cert)) None (Some (bound cert))) (of_radius cert).

(* What the checker accepts is true. *)
Theorem check_exponent_lower_sound a l cert : check_exponent_lower a l cert = true -> exponent_holds a l.
Proof.
  intros H. apply andb_prop in H. destruct H as [H1 H2]. apply (exponent_of_radius a l (order cert) (bound cert) H1).
  apply radius_bounded, (check_radius_sound _ _ H2).
Qed.

(* There is unity limit, and its exponent as a number, if it is unity, is at least l. *)
Corollary exponent_of_limit a l : (2 <= arity a)%nat -> exponent_holds a l ->
  forall phi s, limit_of a phi -> is_lub (exponents phi) s -> (real_of l <= s)%R.
Proof.
  intros HA [psi [Lim H]] phi s Lim' [U _]. replace psi with phi in H.
  - apply le_epsilon. intros eps He. destruct (H (real_of l - eps)%R ltac:(lra)) as [t [Ht Hl]]. specialize (U t Ht). lra.
  - extensionality x. eapply limit_unique; eauto.
Qed.
