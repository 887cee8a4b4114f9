(* Both ends of Hoelder exponents: the checker finds stability of the shifts by exact values of the limit. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Existence Integers Sections Eigenvalue Check Subdivision Differences Coefficients Exponent Stability Values.
Import ListNotations.
Open Scope Z_scope.

(* ---- the checker ---------------------------------------------------------------------------------------------------- *)

(* The values of the limit at the integers start, start + 1, ... are values / scale. They solve a linear system, of which
   `inverse_rows` / inverse_over is nearly the inverse. The combination with the weights of the values at the distance
   A^-level is far from 0 for one shift, number center from row on, and small for the sum of all others. *)
Record stability := Stability {
  start : Z; values : list Z; scale : Z; inverse_matrix : zmat; inverse_over : Z;
  level : nat; weights : list Z; row : Z; center : nat }.

Definition coefficient_at (a : scheme) (k : Z) : Z := if k <? first a then 0 else nth (Z.to_nat (k - first a)) (coefficients a) 0.

(* Of the equations phi(i) = sum of a (A i - j) phi(j) and sum of phi(j) = 1 *)
Definition value_matrix (a : scheme) (start : Z) (w : nat) : zmat :=
  table w (fun i j => coefficient_at a (Z.of_nat (arity a) * (start + Z.of_nat i) - (start + Z.of_nat j)) -
    (if Nat.eqb i j then common a else 0) + common a).

Definition values_right (a : scheme) (c : stability) : bool :=
  let w := length (values c) in let E := value_matrix a (start c) w in
  forallb (fun r => dot r (values c) =? common a * scale c) E.

Definition values_unique (a : scheme) (c : stability) : bool :=
  let w := length (values c) in let P := zproduct w (inverse_matrix c) (value_matrix a (start c) w) in
  square w (inverse_matrix c) &&
  forallb (fun j => norm1 (map (fun i => (if Nat.eqb i j then inverse_over c else 0) - entry P i j) (seq 0 w)) <? inverse_over c) (seq 0 w).

(* c(z^step) U(z) *)
Fixpoint times_up (step : nat) (c U : list Z) : list Z :=
  match c with [] => [] | x :: c' => addmul x U (repeat 0 step ++ times_up step c' U) end.
Fixpoint fine (A : nat) (c : list Z) (m : nat) (U : list Z) : list Z :=
  match m with O => U | S k => times_up (A ^ k) c (fine A c k U) end.
Fixpoint fine_start (A : nat) (F : Z) (m : nat) (s : Z) : Z :=
  match m with O => s | S k => fine_start A F k s + Z.of_nat (A ^ k) * F end.
Fixpoint correlate (fuel step : nat) (omega U : list Z) : list Z :=
  match fuel with O => [] | S f => dot omega U :: correlate f step omega (skipn step U) end.

Definition combined (a : scheme) (c : stability) : list Z :=
  let U := fine (arity a) (coefficients a) (level c) (values c) in let step := (arity a ^ level c)%nat in
  let padded := repeat 0 (Z.to_nat (fine_start (arity a) (first a) (level c) (start c) - Z.of_nat step * row c)) ++ U in
  correlate (length padded) step (weights c) padded.

Definition check_stable (a : scheme) (c : stability) : bool :=
  let w := Z.of_nat (length (values c)) in let A := Z.of_nat (arity a) in
  let s := fine_start (arity a) (first a) (level c) (start c) in let step := Z.of_nat (arity a ^ level c) in
  (0 <? scale c) && ((A - 1) * start c <=? first a) &&
  (first a + Z.of_nat (length (coefficients a) - 1) <=? (A - 1) * (start c + w - 1)) &&
  values_right a c && values_unique a c &&
  (step * row c <=? s) && (Z.of_nat (length (weights c)) + step * (row c - 1) <=? s) &&
  (norm1 (combined a c) <? 2 * Z.abs (nth (center c) (combined a c) 0)).

(* ---- what it says --------------------------------------------------------------------------------------------------- *)

Lemma coefficient_plus x U r e s i : coefficient (addmul x U r) e s i = (IZR x * coefficient U e s i + coefficient r e s i)%R.
Proof.
  unfold coefficient. destruct (i <? s). lra. assert (H := f_equal (fun f => f (Z.to_nat (i - s))) (vr_addmul x U r)).
  unfold vr, plus, scal in H. rewrite H. unfold Rdiv. ring.
Qed.

Lemma coefficient_padded n r e s i : coefficient (repeat 0 n ++ r) e s i = coefficient r e (s + Z.of_nat n) i.
Proof.
  unfold coefficient. destruct (Z.ltb_spec i s), (Z.ltb_spec i (s + Z.of_nat n)); try lia; auto.
  - rewrite app_nth1 by (rewrite repeat_length; lia). rewrite nth_repeat. unfold Rdiv. lra.
  - rewrite app_nth2; rewrite repeat_length; [|lia]. do 3 f_equal. lia.
Qed.

Lemma coefficient_times step c U e : forall s i,
  coefficient (times_up step c U) e s i =
  sum (length c) (fun l => (IZR (nth l c 0%Z) * coefficient U e s (i - Z.of_nat step * Z.of_nat l))%R).
Proof.
  induction c as [|x c IH]; intros s i.
  - simpl. unfold coefficient. destruct (i <? s); auto. rewrite nth_nil. unfold Rdiv. lra.
  - cbn [times_up length]. rewrite coefficient_plus, coefficient_padded. change (S (length c)) with (1 + length c)%nat. rewrite sum_add.
    cbn [sum nth]. rewrite Rplus_0_l. f_equal.
    + do 2 f_equal. lia.
    + rewrite IH. apply sum_ext; intros l Hl. cbn [Nat.add nth]. f_equal. unfold coefficient.
      replace (i - Z.of_nat step * Z.of_nat (S l) - s) with (i - Z.of_nat step * Z.of_nat l - (s + Z.of_nat step)) by lia.
      destruct (Z.ltb_spec (i - Z.of_nat step * Z.of_nat l) (s + Z.of_nat step)), (Z.ltb_spec (i - Z.of_nat step * Z.of_nat (S l)) s); auto; lia.
Qed.

Lemma skipn_twice x y (l : list Z) : skipn x (skipn y l) = skipn (x + y) l.
Proof.
  revert l. induction y; intros l. rewrite Nat.add_0_r. auto. rewrite Nat.add_succ_r. destruct l; [apply skipn_nil|]. apply IHy.
Qed.

Lemma nth_correlate step omega k : forall fuel U, nth k (correlate fuel step omega U) 0 =
  if (k <? fuel)%nat then dot omega (skipn (k * step) U) else 0.
Proof.
  induction k; intros [|f] U; auto. cbn [correlate nth]. rewrite IHk. change (S k <? S f)%nat with (k <? f)%nat.
  destruct (k <? f)%nat; auto. f_equal. replace (S k * step)%nat with (k * step + step)%nat by lia. apply skipn_twice.
Qed.

Lemma correlate_length step omega n : forall U, length (correlate n step omega U) = n.
Proof. induction n; intros U; simpl; auto. Qed.

Section Sound.
Variables (a : scheme) (c : stability) (phi : R -> R).
Let A := arity a.
Let F := first a.
Let D := common a.
Let L := (length (coefficients a) - 1)%nat.
Let w := length (values c).
Let mask := coefficient (coefficients a) D F.
Hypothesis Arity : (2 <= A)%nat.
Hypothesis Positive : 0 < D.
Hypothesis Long : (1 <= length (coefficients a))%nat.
Hypothesis Classes : forall i, subdivide A F L mask (fun _ => 1%R) i = 1%R.
Hypothesis Tends : tends A (refined A F L mask) phi.
Hypothesis Accepted : check_stable a c = true.

Lemma mask_supported : supported F L mask.
Proof.
  intros i Hi. unfold mask, coefficient. destruct (Z.ltb_spec i F); auto. rewrite nth_overflow. unfold Rdiv; lra. unfold L in Hi. lia.
Qed.

Lemma mask_value k : mask k = (IZR (coefficient_at a k) / IZR D)%R.
Proof. unfold mask, coefficient, coefficient_at. fold F. destruct (k <? F); auto. unfold Rdiv. lra. Qed.

Lemma facts : 0 < scale c /\ (Z.of_nat A - 1) * start c <= F /\ F + Z.of_nat L <= (Z.of_nat A - 1) * (start c + Z.of_nat w - 1) /\
  values_right a c = true /\ values_unique a c = true.
Proof.
  unfold check_stable in Accepted. cbv zeta in Accepted. repeat rewrite andb_true_iff in Accepted.
  destruct Accepted as [[[[[[[H1 H2] H3] H4] H5] _] _] _].
  apply Z.ltb_lt in H1. apply Z.leb_le in H2, H3. auto.
Qed.

Let v (k : nat) := phi (IZR (start c + Z.of_nat k)).

(* The values solve the system. *)
Lemma system_values i : (i < w)%nat -> apply w (mr (value_matrix a (start c) w)) v i = IZR D.
Proof.
  intros Hi. destruct facts as [_ [Lo [Hi' _]]].
  assert (Rf := values_refine A F L Arity mask phi mask_supported Tends (start c) w Lo Hi' (start c + Z.of_nat i)).
  assert (Pu := partition_of_unity A F L Arity mask phi mask_supported Classes Tends (start c) w Lo Hi').
  assert (DP : (0 < IZR D)%R) by (apply IZR_lt; auto).
  unfold apply. rewrite (sum_ext w _ (fun j => (IZR D * (mask (Z.of_nat A * (start c + Z.of_nat i) - (start c + Z.of_nat j)) * v j)
     + ((- IZR D) * (identity j i * v j) + IZR D * v j))%R)).
  - rewrite sum_plus, sum_plus, !sum_scal, sum_identity by auto.
    unfold v at 1. rewrite <- Rf. unfold v at 2. rewrite Pu. unfold v. lra.
  - intros j Hj. unfold mr, value_matrix. rewrite entry_table by auto. rewrite mask_value. fold A D. unfold identity. rewrite (Nat.eqb_sym j i).
    rewrite plus_IZR, minus_IZR. destruct (Nat.eqb i j); field; lra.
Qed.

Lemma system_certificate i : (i < w)%nat -> apply w (mr (value_matrix a (start c) w)) (vr (values c)) i = (IZR D * IZR (scale c))%R.
Proof.
  intros Hi. destruct facts as [_ [_ [_ [H _]]]]. unfold values_right in H. cbv zeta in H. fold w in H. rewrite forallb_forall in H.
  set (E := value_matrix a (start c) w) in *. specialize (H (nth i E [])). assert (Sq : square w E = true) by apply square_table.
  rewrite <- vr_mv by auto. unfold vr, mv. apply square_spec in Sq. destruct Sq as [S1 _].
  assert (H' := H ltac:(apply nth_In; rewrite S1; auto)). apply Z.eqb_eq in H'. rewrite <- mult_IZR. f_equal.
  destruct (values c) eqn:EV. { exfalso. unfold w in Hi. try rewrite EV in Hi. simpl in Hi. lia. }
  rewrite nth_map_nil by apply (dot_nil []). exact H'.
Qed.

(* There is one solution. *)
Lemma system_unique d : (forall i, (i < w)%nat -> apply w (mr (value_matrix a (start c) w)) d i = 0%R) -> forall j, (j < w)%nat -> d j = 0%R.
Proof.
  intros H. destruct facts as [_ [_ [_ [_ U]]]]. unfold values_unique in U. cbv zeta in U. fold w in U. apply andb_prop in U. destruct U as [Sq U].
  set (E := value_matrix a (start c) w) in *. set (P := zproduct w (inverse_matrix c) E) in *. rewrite forallb_forall in U.
  set (S0 := inverse_over c) in *.
  assert (Z0 : forall i, (i < w)%nat -> apply w (mr P) d i = 0%R).
  { intros i Hi. unfold P, zproduct. rewrite apply_products by auto. unfold apply at 1. apply sum_zero. intros k Hk. rewrite (H k Hk). lra. }
  set (r := fun i j => (IZR S0 * identity i j - mr P i j)%R).
  assert (Col : forall j, (j < w)%nat -> (sum w (fun i => Rabs (r i j)) <= IZR S0 - 1)%R).
  { intros j Hj. specialize (U j ltac:(apply in_seq; lia)). apply Z.ltb_lt in U. set (l := map _ _) in U.
    assert (Ul : (norm1 l <= S0 - 1)%Z) by lia. apply IZR_le in Ul. rewrite minus_IZR in Ul.
    rewrite (norm1_sum l w) in Ul by (unfold l; rewrite map_length, seq_length; auto). eapply Rle_trans; [|apply Ul]. right.
    unfold norm. apply sum_ext; intros i Hi. unfold vr, l. rewrite nth_map_seq by auto. unfold r, mr, identity.
    rewrite minus_IZR. destruct (Nat.eqb i j); f_equal; ring. }
  assert (Nd : (IZR S0 * norm w d <= (IZR S0 - 1) * norm w d)%R).
  { apply Rle_trans with (norm w (fun i => sum w (fun j => r i j * d j)%R)).
    - right. unfold norm. rewrite <- sum_scal. apply sum_ext; intros i Hi.
      assert (S0p : (0 <= IZR S0)%R). { specialize (Col i Hi). assert (0 <= sum w (fun k => Rabs (r k i)))%R by (apply sum_nonneg; intros; apply Rabs_pos). lra. }
      replace (sum w (fun j => r i j * d j)%R) with (IZR S0 * d i)%R.
      { rewrite Rabs_mult, (Rabs_pos_eq (IZR S0)) by auto. auto. }
      rewrite (sum_ext w _ (fun j => IZR S0 * (identity j i * d j) + (-1) * (mr P i j * d j))%R).
      + rewrite sum_plus, !sum_scal, sum_identity by auto. specialize (Z0 i Hi). unfold apply in Z0. rewrite Z0. lra.
      + intros j Hj. unfold r. rewrite (identity_comm j i). ring.
    - unfold norm at 1. apply Rle_trans with (sum w (fun i => sum w (fun j => Rabs (r i j) * Rabs (d j))%R)).
      + apply sum_le; intros i Hi. eapply Rle_trans. apply sum_abs. right. apply sum_ext; intros. apply Rabs_mult.
      + rewrite sum_swap. unfold norm. rewrite <- sum_scal. apply sum_le; intros j Hj.
        rewrite (sum_ext w _ (fun i => Rabs (d j) * Rabs (r i j))%R) by (intros; ring). rewrite sum_scal, Rmult_comm.
        apply Rmult_le_compat_r. apply Rabs_pos. auto. }
  intros j Hj. assert (N0 := norm_nonneg w d). assert (T := norm_term w d j Hj). destruct (Req_dec (d j) 0); auto.
  assert (0 < Rabs (d j))%R by (apply Rabs_pos_lt; auto). lra.
Qed.

Lemma integer_values q : phi (IZR q) = coefficient (values c) (scale c) (start c) q.
Proof.
  destruct facts as [Sc [Lo [Hi _]]]. assert (SP : (0 < IZR (scale c))%R) by (apply IZR_lt; auto).
  unfold coefficient. destruct (Z.ltb_spec q (start c)).
  - apply (phi_outside A F L Arity mask phi mask_supported Tends (start c) w Lo Hi). auto.
  - destruct (Z_lt_ge_dec q (start c + Z.of_nat w)).
    + set (k := Z.to_nat (q - start c)). replace (IZR q) with (IZR (start c + Z.of_nat k)) by (f_equal; unfold k; lia). fold (v k).
      assert (U := system_unique (fun j => v j - vr (values c) j / IZR (scale c))%R).
      assert (U' : (v k - vr (values c) k / IZR (scale c) = 0)%R).
      { apply U; [|unfold k; lia]. intros i Hi'. unfold apply.
        rewrite (sum_ext w _ (fun j => mr (value_matrix a (start c) w) i j * v j + (- / IZR (scale c)) * (mr (value_matrix a (start c) w) i j * vr (values c) j))%R)
          by (intros j Hj; cbv beta; unfold Rdiv; ring).
        rewrite sum_plus, sum_scal. assert (E1 := system_values i Hi'). assert (E2 := system_certificate i Hi'). unfold apply in E1, E2.
        rewrite E1, E2. field. lra. }
      unfold vr in U'. lra.
    + rewrite nth_overflow by (fold w; lia). rewrite (phi_outside A F L Arity mask phi mask_supported Tends (start c) w Lo Hi) by lia.
      unfold Rdiv. lra.
Qed.

(* The values at the distance A^-m *)
Lemma fine_values m : forall q, phi (IZR q / INR A ^ m)%R =
  coefficient (fine A (coefficients a) m (values c)) (scale c * D ^ Z.of_nat m) (fine_start A F m (start c)) q.
Proof.
  assert (SPz : 0 < scale c) by apply facts. assert (DP : (0 < IZR D)%R) by (apply IZR_lt; auto).
  induction m; intros q.
  - simpl. replace (IZR q / 1)%R with (IZR q) by field. rewrite integer_values. f_equal. lia.
  - assert (E : forall j, refined A F L mask 1 j = mask j).
    { intros j. cbn [refined]. apply (subdivide_point A F L Arity mask j mask_supported). }
    assert (P := power_positive A Arity m). assert (PA := arity_positive A Arity).
    rewrite (refinement A F L Arity mask phi Tends 1 F (S L)).
    2:{ intros j Hj. rewrite E. apply mask_supported. lia. }
    cbn [fine fine_start]. set (U := fine A (coefficients a) m (values c)) in *. set (s := fine_start A F m (start c)) in *.
    rewrite coefficient_times. unfold combination. replace (length (coefficients a)) with (S L) by (unfold L; lia).
    apply sum_ext; intros l Hl. rewrite E.
    replace (INR A ^ 1 * (IZR q / INR A ^ S m) - IZR (F + Z.of_nat l))%R with (IZR (q - Z.of_nat (A ^ m) * (F + Z.of_nat l)) / INR A ^ m)%R.
    + rewrite IHm. unfold mask, coefficient at 1. destruct (Z.ltb_spec (F + Z.of_nat l) F); [lia|].
      replace (Z.to_nat (F + Z.of_nat l - F)) with l by lia.
      unfold coefficient.
      replace (q - Z.of_nat (A ^ m) * (F + Z.of_nat l) - s) with (q - Z.of_nat (A ^ m) * Z.of_nat l - (s + Z.of_nat (A ^ m) * F)) by ring.
      destruct (Z.ltb_spec (q - Z.of_nat (A ^ m) * (F + Z.of_nat l)) s), (Z.ltb_spec (q - Z.of_nat (A ^ m) * Z.of_nat l) (s + Z.of_nat (A ^ m) * F)); try lia.
      * lra.
      * rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. rewrite !mult_IZR. field.
        assert (DD : (0 < IZR (D ^ Z.of_nat m))%R) by (apply IZR_lt, Z.pow_pos_nonneg; lia). assert ((0 < IZR (scale c))%R) by (apply IZR_lt; auto). lra.
    + rewrite minus_IZR, mult_IZR, <- (INR_IZR_INZ (A ^ m)), pow_INR. simpl pow. field. lra.
Qed.

Theorem accepted_stable : stable phi.
Proof.
  assert (SPz : 0 < scale c) by apply facts.
  assert (Acc := Accepted). unfold check_stable in Acc. cbv zeta in Acc. repeat rewrite andb_true_iff in Acc.
  destruct Acc as [[[_ H1] H2] H3]. apply Z.leb_le in H1, H2. apply Z.ltb_lt in H3. fold A F in H1, H2.
  set (m := level c) in *. set (U := fine A (coefficients a) m (values c)). set (s := fine_start A F m (start c)) in *.
  set (step := (A ^ m)%nat) in *. set (pad := Z.to_nat (s - Z.of_nat step * row c)).
  set (V := repeat 0 pad ++ U). set (e := scale c * D ^ Z.of_nat m).
  assert (EC : combined a c = correlate (length V) step (weights c) V) by reflexivity. rewrite EC in H3.
  set (h := coefficient (correlate (length V) step (weights c) V) e (row c)).
  assert (Pst : (1 <= step)%nat) by (unfold step; apply Nat.neq_0_lt_0, Nat.pow_nonzero; lia).
  assert (Est : Z.of_nat A ^ Z.of_nat m = Z.of_nat step) by (unfold step; rewrite Nat2Z.inj_pow; auto).
  assert (Pe : (0 < IZR e)%R) by (apply IZR_lt, Z.mul_pos_pos; auto; apply Z.pow_pos_nonneg; lia).
  assert (EV : forall q, phi (IZR q / INR A ^ m)%R = coefficient V e (Z.of_nat step * row c) q).
  { intros q. rewrite fine_values. unfold V. rewrite coefficient_padded. unfold pad. do 2 f_equal. fold s. lia. }
  apply (stable_by_values A phi Arity m (length (weights c)) (length V) (fun k => IZR (nth k (weights c) 0)) h (row c + Z.of_nat (center c)) (row c)).
  - intros r. rewrite Est. rewrite (sum_ext _ _ (fun k =>
      (IZR (nth k (weights c) 0%Z) * coefficient V e (Z.of_nat step * row c) (Z.of_nat k + Z.of_nat step * r))%R))
      by (intros; rewrite EV; auto).
    unfold h. unfold coefficient at 2. destruct (Z.ltb_spec r (row c)) as [R|R].
    + apply sum_zero. intros k Hk. unfold V. rewrite coefficient_padded. unfold coefficient.
      destruct (Z.ltb_spec (Z.of_nat k + Z.of_nat step * r) (Z.of_nat step * row c + Z.of_nat pad)); [lra|]. exfalso.
      assert (M : Z.of_nat step * r <= Z.of_nat step * (row c - 1)) by (apply Z.mul_le_mono_nonneg_l; lia). unfold pad in *. lia.
    + set (k := Z.to_nat (r - row c)). rewrite nth_correlate.
      assert (EN : forall j, (coefficient V e (Z.of_nat step * row c) (Z.of_nat j + Z.of_nat step * r) = IZR (nth j (skipn (k * step) V) 0%Z) / IZR e)%R).
      { intros j. unfold coefficient. assert (M : Z.of_nat step * row c <= Z.of_nat step * r) by (apply Z.mul_le_mono_nonneg_l; lia).
        destruct (Z.ltb_spec (Z.of_nat j + Z.of_nat step * r) (Z.of_nat step * row c)); [lia|]. do 2 f_equal. rewrite nth_skipn. f_equal.
        replace (Z.of_nat j + Z.of_nat step * r - Z.of_nat step * row c) with (Z.of_nat (k * step + j)). lia.
        rewrite Nat2Z.inj_add, Nat2Z.inj_mul. unfold k. rewrite Z2Nat.id by lia. ring. }
      rewrite (sum_ext _ _ (fun j => (/ IZR e * (IZR (nth j (weights c) 0%Z) * IZR (nth j (skipn (k * step) V) 0%Z)))%R))
        by (intros j Hj; rewrite EN; unfold Rdiv; ring).
      rewrite sum_scal, <- dot_sum by auto. destruct (Nat.ltb_spec k (length V)). unfold Rdiv; ring.
      rewrite skipn_all2 by nia. rewrite dot_nil. unfold Rdiv. ring.
  - intros i Hi. unfold h, coefficient. destruct (Z.ltb_spec i (row c)); auto. rewrite nth_correlate.
    destruct (Nat.ltb_spec (Z.to_nat (i - row c)) (length V)); [lia|]. unfold Rdiv. lra.
  - assert (Eh : forall k, (h (row c + Z.of_nat k)%Z = IZR (nth k (correlate (length V) step (weights c) V) 0%Z) / IZR e)%R).
    { intros k. unfold h, coefficient. destruct (Z.ltb_spec (row c + Z.of_nat k) (row c)); [lia|]. do 3 f_equal. lia. }
    set (l := correlate (length V) step (weights c) V) in *. rewrite Eh.
    assert (Ll : length l = length V).
    { apply correlate_length. }
    rewrite (sum_ext _ _ (fun k => (/ IZR e * Rabs (vr l k))%R)).
    + rewrite sum_scal. fold (norm (length V) (vr l)). rewrite <- (norm1_sum l) by lia.
      apply IZR_lt in H3. rewrite mult_IZR, abs_IZR in H3. unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ IZR e)) by (left; apply Rinv_0_lt_compat; auto).
      apply (Rmult_lt_compat_l (/ IZR e)) in H3; [|apply Rinv_0_lt_compat; auto]. lra.
    + intros k Hk. rewrite Eh. unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ IZR e)) by (left; apply Rinv_0_lt_compat; auto). unfold vr. ring.
Qed.
End Sound.

(* ---- both ends ---------------------------------------------------------------------------------------------------- *)

(* A bound of the radius from below beside that from above, which is in `lower_end` with the proof of both *)
Record enclosure := Enclosure { lower_end : exponent_certificate; radius_least : Q; shifts : stability }.

Definition above_power (a : scheme) (u : Q) (order : nat) (g : Q) : bool :=
  (0 <=? Qnum u) && (Zpos (Qden g) <? Qnum g) &&
  (Z.of_nat (arity a) ^ Z.of_nat order * unity * Zpos (Qden g) <=?
   Qnum g * power_below (Z.of_nat (arity a)) order (Qnum u) (Zpos (Qden u))).

(* All but the radius *)
Definition encloses (a : scheme) (l u : Q) (order : nat) (most least : Q) (c : stability) : bool :=
  reduces a l order most && above_power a u order least && (1 <=? length (coefficients a))%nat && check_stable a c.

(* lower <= exponent <= upper *)
Definition check_exponent (a : scheme) (l u : Q) (cert : enclosure) : bool :=
  let low := lower_end cert in
  encloses a l u (order low) (bound low) (radius_least cert) (shifts cert) &&
  check_radius (Claim (difference_family a (order low)) (Some (radius_least cert)) (Some (bound low))) (of_radius low).

Lemma above_power_sound a u m g lambda : exp lambda = INR (arity a) -> (2 <= arity a)%nat -> above_power a u m g = true ->
  (1 < real_of g)%R /\ (exp ((INR m - real_of u) * lambda) <= real_of g)%R.
Proof.
  intros Hlog HA H. unfold above_power in H. apply andb_prop in H. destruct H as [H H3]. apply andb_prop in H. destruct H as [H1 H2].
  apply Z.leb_le in H1, H3. apply Z.ltb_lt, IZR_lt in H2.
  assert (Dg : (0 < IZR (Zpos (Qden g)))%R) by (apply IZR_lt; lia). split.
  - unfold real_of. apply (Rmult_lt_reg_r (IZR (Zpos (Qden g)))); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
  - assert (Hl := Hlog). rewrite INR_IZR_INZ in Hl.
    assert (P := power_below_sound (Z.of_nat (arity a)) lambda ltac:(lia) Hl m (Qnum u) (Zpos (Qden u)) H1 ltac:(lia)).
    fold (real_of u) in P. set (x := power_below _ _ _ _) in *. apply IZR_le in H3. rewrite !mult_IZR in H3.
    rewrite (arity_power (arity a) HA), <- Hlog, exp_power in H3. assert (Up := unity_positive).
    assert (E : exp ((INR m - real_of u) * lambda) = (exp (INR m * lambda) * / exp (real_of u * lambda))%R).
    { rewrite <- exp_Ropp, <- exp_plus. f_equal. ring. }
    rewrite E. assert (Pu := exp_pos (real_of u * lambda)). apply (Rmult_le_reg_r (exp (real_of u * lambda) * IZR unity * IZR (Zpos (Qden g)))).
    { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; auto. }
    replace (exp (INR m * lambda) * / exp (real_of u * lambda) * (exp (real_of u * lambda) * IZR unity * IZR (Zpos (Qden g))))%R with
      (exp (INR m * lambda) * IZR unity * IZR (Zpos (Qden g)))%R by (field; lra).
    eapply Rle_trans. apply H3. unfold real_of at 1.
    replace (IZR (Qnum g) / IZR (Zpos (Qden g)) * (exp (real_of u * lambda) * IZR unity * IZR (Zpos (Qden g))))%R with
      (IZR (Qnum g) * (IZR unity * exp (real_of u * lambda)))%R by (field; lra).
    apply Rmult_le_compat_l; auto. apply Rle_trans with (IZR (Zpos (Qden g))); lra.
Qed.

Definition enclosure_holds (a : scheme) (l u : Q) : Prop :=
  exists phi, limit_of a phi /\ exponent_at_least phi (real_of l) /\ exponent_at_most phi (real_of u).

Theorem enclosure_of_radius a l u m most least c : encloses a l u m most least c = true -> let T := difference_family a m in
  radius_at_most (size T) (count T) (real T) (real_of most) -> radius_at_least (size T) (count T) (real T) (real_of least) ->
  enclosure_holds a l u.
Proof.
  intros H T RU RL. unfold encloses in H. repeat rewrite andb_true_iff in H. destruct H as [[[H1 H2] H3] H4]. apply Nat.leb_le in H3.
  assert (HA : (2 <= arity a)%nat /\ 0 < common a).
  { unfold reduces, reducible in H1. repeat rewrite andb_true_iff in H1. destruct H1 as [[[[HA HD] _] _] _].
    apply Nat.leb_le in HA. apply Z.ltb_lt in HD. auto. }
  destruct HA as [HA HD].
  destruct (limit_of_radius a l m most H1 RU) as [phi [Lim [Ex [Td [Cl Up]]]]]. exists phi. split; auto. split; auto.
  destruct (exp_onto (INR (arity a)) (arity_positive (arity a) HA)) as [lambda Hlog].
  destruct (above_power_sound a u m least lambda Hlog HA H2) as [G1 GU].
  apply (Up lambda (real_of least)); auto. apply (accepted_stable a c); auto.
Qed.

(* What the checker accepts is true. *)
Theorem check_exponent_sound a l u cert : check_exponent a l u cert = true -> enclosure_holds a l u.
Proof.
  intros H. apply andb_prop in H. destruct H as [H1 H2]. apply check_radius_sound in H2. set (low := lower_end cert) in *.
  set (T := difference_family a (order low)) in *.
  destruct (radius_exists (size T) (count T) (real T)) as [x Hx]. destruct (H2 x Hx) as [XL XU].
  specialize (XL _ eq_refl). specialize (XU _ eq_refl). destruct Hx as [_ [Gx Lx]].
  apply (enclosure_of_radius a l u (order low) (bound low) (radius_least cert) (shifts cert) H1).
  - intros r Hr H0. apply Gx; auto. fold low T in XU. lra.
  - intros r Hr G. apply Rle_trans with x; auto.
Qed.

(* If the exponents have a supremum, it is between the ends. *)
Corollary enclosure_of_limit a l u : (2 <= arity a)%nat -> enclosure_holds a l u ->
  forall phi s, limit_of a phi -> is_lub (exponents phi) s -> (real_of l <= s <= real_of u)%R.
Proof.
  intros HA [psi [Lim [Lo Hi]]] phi s Lim' Lub. split.
  - apply (exponent_of_limit a l HA (ex_intro _ psi (conj Lim Lo)) phi); auto.
  - destruct Lub as [_ M]. apply M. replace phi with psi. exact Hi. extensionality x. eapply limit_unique; eauto.
Qed.
