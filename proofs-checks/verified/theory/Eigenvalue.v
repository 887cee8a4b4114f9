(* A product has an eigenvalue near a given number: checked with integers. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Blocks Lower Integers Sections.
Import ListNotations.
Open Scope Z_scope.

Definition largest_of (xs : list Z) : Z := fold_right Z.max 0 xs.

Lemma largest_of_bound {A} (f : A -> Z) l x : In x l -> f x <= largest_of (map f l).
Proof. induction l; simpl; intros []. subst; lia. apply IHl in H. lia. Qed.

Lemma largest_of_nonneg xs : 0 <= largest_of xs.
Proof. induction xs; simpl; lia. Qed.

Definition columns (n : nat) (M : zmat) : zmat := table n (fun i j => entry M j i).
(* The largest sum of moduli in a row, of M and of a - M. *)
Definition size_of (n : nat) (M : zmat) : Z := largest_of (map (fun i => norm1 (nth i M [])) (seq 0 n)).
Definition defect (n : nat) (a : Z) (M : zmat) : Z :=
  largest_of (map (fun i => norm1 (addmul (-1) (nth i M []) (unit_at a i))) (seq 0 n)).

(* All of it is a hint: `word` names a product P of integer matrices; s P has an eigenvalue within `distance` of
   er + i ei, in both parts, as xr + i xi is nearly an eigenvector, whose coordinate `pivot` is kept, and
   inverse / over is nearly the inverse of the derivative. *)
Record eigen := Eigen {
  word : list nat; multiplier : Z; xr : zvec; xi : zvec; er : Z; ei : Z; pivot : nat; pivot_scale : Z;
  inverse : zmat; over : Z; distance : Z }.

Section Check.
Variables (F : family) (e : eigen).
Let n := size F.
Let m := (n + n + 2)%nat.
Let s := multiplier e.

(* The product, column by column. *)
Definition product_columns : zmat := map (fun j => addmul s (zrun (matrices F) (word e) (unit_at 1 j)) []) (seq 0 n).

Definition if_equal (i j : nat) (a : Z) : Z := if Nat.eqb i j then a else 0.

Definition derivative_entry (cols : zmat) (i j : nat) : Z :=
  if (i <? n)%nat then
    if (j <? n)%nat then entry cols j i - if_equal i j (er e)
    else if (j <? n + n)%nat then if_equal i (j - n)%nat (ei e)
    else if (j =? n + n)%nat then - nth i (xr e) 0 else nth i (xi e) 0
  else if (i <? n + n)%nat then
    if (j <? n)%nat then - if_equal (i - n)%nat j (ei e)
    else if (j <? n + n)%nat then entry cols (j - n)%nat (i - n)%nat - if_equal (i - n)%nat (j - n)%nat (er e)
    else if (j =? n + n)%nat then - nth (i - n)%nat (xi e) 0 else - nth (i - n)%nat (xr e) 0
  else if (i =? n + n)%nat then if_equal j (pivot e) (pivot_scale e) else if_equal j (n + pivot e)%nat (pivot_scale e).

Definition value_entry (px py : zvec) (i : nat) : Z :=
  if (i <? n)%nat then nth i px 0 - er e * nth i (xr e) 0 + ei e * nth i (xi e) 0
  else if (i <? n + n)%nat then nth (i - n)%nat py 0 - er e * nth (i - n)%nat (xi e) 0 - ei e * nth (i - n)%nat (xr e) 0
  else 0.

(* Newton's iteration contracts in the ball of this distance. *)
Definition contracts (value : zvec) : bool :=
  let derivative := table m (derivative_entry product_columns) in
  let e1 := defect m (over e) (products (inverse e) (columns m derivative)) in
  let e2 := defect m (over e) (products derivative (columns m (inverse e))) in
  let e3 := size_of m (inverse e) in
  let eta := largest_of (map Z.abs (mv (inverse e) value)) in
  let rest := over e - e1 - 4 * distance e * e3 in
  (0 <? over e) && negb (pivot_scale e =? 0) && square m (inverse e) && (0 <? rest) && (e2 <? over e) &&
  (eta <=? rest * distance e).

(* Either the eigenvector is exact, or Newton's iteration contracts. *)
Definition eigenvalue (l : Q) : bool :=
  let value := map (value_entry (addmul s (zrun (matrices F) (word e) (xr e)) [])
                                (addmul s (zrun (matrices F) (word e) (xi e)) [])) (seq 0 m) in
  let a := Z.max 0 (Z.abs (er e) - distance e) in
  let b := Z.max 0 (Z.abs (ei e) - distance e) in
  let k := Z.of_nat (length (word e)) in
  (0 <? s) && (0 <=? distance e) && (pivot e <? n)%nat &&
  forallb (fun t => Nat.ltb t (count F)) (word e) && (0 <? k) &&
  negb ((nth (pivot e) (xr e) 0 =? 0) && (nth (pivot e) (xi e) 0 =? 0)) &&
  (forallb (Z.eqb 0) value || contracts value) &&
  (0 <=? Qnum l) && ((Qnum l * denominator F) ^ (2 * k) * (s * s) <=? Zpos (Qden l) ^ (2 * k) * (a * a + b * b)).
End Check.

(* ---- why that proves the bound --------------------------------------------------------------------------------- *)

Open Scope R_scope.

Lemma near_apply_bound m (X : mat) b d x : (forall i, (i < m)%nat -> norm m (X i) <= b) -> near m x zero d ->
  forall i, (i < m)%nat -> Rabs (apply m X x i) <= b * d.
Proof.
  intros HX Hx i Hi. unfold apply. eapply Rle_trans. apply sum_abs.
  assert (Hd : 0 <= d). { specialize (Hx i Hi). eapply Rle_trans; [|apply Hx]. apply Rabs_pos. }
  apply Rle_trans with (sum m (fun j => d * Rabs (X i j))).
  - apply sum_le; intros j Hj. rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat_r. apply Rabs_pos.
    specialize (Hx j Hj). unfold zero in Hx. rewrite Rminus_0_r in Hx. auto.
  - rewrite sum_scal, Rmult_comm. apply Rmult_le_compat_r; auto. apply HX; auto.
Qed.

Lemma size_sound m M b : (size_of m M <= b)%Z -> forall i, (i < m)%nat -> norm m (mr M i) <= IZR b.
Proof.
  intros H i Hi. eapply Rle_trans. apply (norm_norm1 m (nth i M [])). apply IZR_le.
  eapply Z.le_trans; [|apply H]. apply (largest_of_bound (fun i => norm1 (nth i M []))). apply in_seq. lia.
Qed.

Lemma defect_sound m a M d x : near m x zero d -> forall i, (i < m)%nat ->
  Rabs (IZR a * x i - apply m (mr M) x i) <= IZR (defect m a M) * d.
Proof.
  intros Hx i Hi.
  assert (B := near_apply_bound m (fun i => vr (addmul (-1) (nth i M []) (unit_at a i))) (IZR (defect m a M)) d x).
  simpl in B. replace (IZR a * x i - apply m (mr M) x i)
    with (apply m (fun i => vr (addmul (-1) (nth i M []) (unit_at a i))) x i).
  - apply B; auto. intros j Hj. eapply Rle_trans. apply norm_norm1. apply IZR_le.
    apply (largest_of_bound (fun i => norm1 (addmul (-1) (nth i M []) (unit_at a i)))). apply in_seq. lia.
  - unfold apply. rewrite (sum_ext m _ (fun j => IZR a * (identity j i * x j) + (-1) * (mr M i j * x j))).
    + rewrite sum_plus, !sum_scal, sum_identity by auto. lra.
    + intros j Hj. rewrite vr_addmul, vr_unit. unfold plus, scal, unit, mr, entry, vr. lra.
Qed.

Lemma apply_products m A B x i : square m A = true -> (i < m)%nat ->
  apply m (mr (products A (columns m B))) x i = apply m (mr A) (apply m (mr B) x) i.
Proof.
  intros HA Hi. unfold apply.
  rewrite (sum_ext m _ (fun j => sum m (fun k => mr A i k * (mr B k j * x j)))).
  - rewrite sum_swap. apply sum_ext; intros k Hk. rewrite <- sum_scal. reflexivity.
  - intros j Hj. unfold mr at 1. rewrite (entry_products m) by auto. rewrite Rmult_comm, <- sum_scal.
    apply sum_ext; intros k Hk. change (nth k (nth j (columns m B) []) 0%Z) with (entry (columns m B) j k).
    unfold columns. rewrite entry_table by auto. unfold mr. ring.
Qed.

Section Sound.
Variables (F : family) (e : eigen) (l : Q).
Hypothesis WF : well_formed F = true.
Let n := size F.
Let m := (n + n + 2)%nat.
Let s := IZR (multiplier e).
Let D := IZR (denominator F).
Let T := real F.
Hypothesis Word : letters (count F) (word e).

Let P (x : vec) : vec := scal (s * D ^ length (word e)) (run n T (word e) x).

Lemma product_image x i : vr (addmul (multiplier e) (zrun (matrices F) (word e) x) []) i = P (vr x) i.
Proof. rewrite vr_addmul, vr_nil, vr_zrun by auto. unfold P, plus, scal, zero, s, D, n, T. ring. Qed.

Lemma product_entry i x : (i < n)%nat -> P x i = sum n (fun j => IZR (entry (product_columns F e) j i) * x j).
Proof.
  intros Hi. unfold P, scal. rewrite run_product, <- sum_scal by auto. apply sum_ext; intros j Hj.
  rewrite <- Rmult_assoc. f_equal. unfold entry, product_columns. fold n. rewrite nth_map_seq by auto.
  change (IZR (nth i (addmul (multiplier e) (zrun (matrices F) (word e) (unit_at 1 j)) []) 0%Z))
    with (vr (addmul (multiplier e) (zrun (matrices F) (word e) (unit_at 1 j)) []) i).
  rewrite product_image. unfold P. rewrite vr_unit, run_scal. unfold scal. fold T. rewrite run_unit by auto. ring.
Qed.

Definition quadratic_part (u : vec) : vec := fun i =>
  if (i <? n)%nat then - u (n + n)%nat * u i + u (n + n + 1)%nat * u (n + i)%nat
  else if (i <? n + n)%nat then - u (n + n)%nat * u i - u (n + n + 1)%nat * u (i - n)%nat
  else 0.

Lemma product_close a b x y rho d : Rabs a <= rho -> Rabs y <= rho -> Rabs (a - b) <= d -> Rabs (x - y) <= d -> 0 <= rho ->
  Rabs (a * x - b * y) <= 2 * rho * d.
Proof.
  intros Ha Hy Hab Hxy Hr. replace (a * x - b * y) with (a * (x - y) + (a - b) * y) by ring.
  eapply Rle_trans. apply Rabs_triang. rewrite !Rabs_mult.
  assert (Rabs a * Rabs (x - y) <= rho * d) by (apply Rmult_le_compat; auto; apply Rabs_pos).
  assert (Rabs (a - b) * Rabs y <= d * rho) by (apply Rmult_le_compat; auto; apply Rabs_pos). lra.
Qed.

Lemma quadratic_close u v rho d : 0 <= rho -> near m u zero rho -> near m v zero rho -> near m u v d ->
  near m (quadratic_part u) (quadratic_part v) (4 * rho * d).
Proof.
  intros Hr Hu Hv Hd i Hi.
  assert (Hu' : forall j, (j < m)%nat -> Rabs (u j) <= rho).
  { intros j Hj. specialize (Hu j Hj). unfold zero in Hu. rewrite Rminus_0_r in Hu. auto. }
  assert (Hv' : forall j, (j < m)%nat -> Rabs (v j) <= rho).
  { intros j Hj. specialize (Hv j Hj). unfold zero in Hv. rewrite Rminus_0_r in Hv. auto. }
  assert (Pair : forall j k, (j < m)%nat -> (k < m)%nat -> Rabs (u j * u k - v j * v k) <= 2 * rho * d).
  { intros j k Hj Hk. apply product_close; auto. }
  unfold quadratic_part. destruct (Nat.ltb_spec i n) as [Li|Li].
  - assert (A := Pair (n + n)%nat i ltac:(unfold m; lia) Hi). assert (B := Pair (n + n + 1)%nat (n + i)%nat ltac:(unfold m; lia) ltac:(unfold m; lia)).
    rewrite abs_le in *. lra.
  - destruct (Nat.ltb_spec i (n + n)) as [Lj|Lj].
    + assert (A := Pair (n + n)%nat i ltac:(unfold m; lia) Hi). assert (B := Pair (n + n + 1)%nat (i - n)%nat ltac:(unfold m; lia) ltac:(unfold m; lia)).
      rewrite abs_le in *. lra.
    + rewrite Rminus_0_r, Rabs_R0. assert (A := Pair i i Hi Hi). assert (B := Rabs_pos (u i * u i - v i * v i)). lra.
Qed.

(* What a row of the derivative does. *)
Let derivative := table m (derivative_entry F e (product_columns F e)).
Let xpart (u : vec) : vec := u.
Let ypart (u : vec) : vec := fun i => u (n + i)%nat.

Lemma split_sum f : sum m f = sum n f + sum n (fun j => f (n + j)%nat) + f (n + n)%nat + f (n + n + 1)%nat.
Proof. unfold m. rewrite sum_add, sum_add. simpl. rewrite Nat.add_0_r. ring. Qed.

Lemma if_equal_sum i a f : (i < n)%nat -> sum n (fun j => IZR (if_equal i j a) * f j) = IZR a * f i.
Proof.
  intros Hi. rewrite <- (sum_identity n i f) at 1 by auto. rewrite <- sum_scal. apply sum_ext; intros j Hj.
  unfold if_equal, identity. rewrite (Nat.eqb_sym j i). destruct (Nat.eqb i j); lra.
Qed.

Ltac entries := repeat match goal with |- context [Nat.ltb ?a ?b] => destruct (Nat.ltb_spec a b); try lia end;
  repeat match goal with |- context [Nat.eqb (n + n) (n + n)] => rewrite Nat.eqb_refl
  | |- context [Nat.eqb (n + n + 1) (n + n)] => replace (Nat.eqb (n + n + 1) (n + n)) with false by (symmetry; apply Nat.eqb_neq; lia) end.

Lemma derivative_first u i : (i < n)%nat -> apply m (mr derivative) u i =
  P (xpart u) i - IZR (er e) * u i + IZR (ei e) * u (n + i)%nat - IZR (nth i (xr e) 0%Z) * u (n + n)%nat + IZR (nth i (xi e) 0%Z) * u (n + n + 1)%nat.
Proof.
  intros Hi. unfold apply. rewrite split_sum.
  rewrite (sum_ext n _ (fun j => IZR (entry (product_columns F e) j i) * u j + (-1) * (IZR (if_equal i j (er e)) * u j))).
  2:{ intros j Hj. unfold mr, derivative. rewrite entry_table by (unfold m; lia). unfold derivative_entry. fold n. entries.
      rewrite minus_IZR. ring. }
  rewrite (sum_ext n (fun j => mr derivative i (n + j)%nat * _) (fun j => IZR (if_equal i j (ei e)) * (fun j => u (n + j)%nat) j)).
  2:{ intros j Hj. unfold mr, derivative. rewrite entry_table by (unfold m; lia). unfold derivative_entry. fold n. entries.
      replace (n + j - n)%nat with j by lia. reflexivity. }
  rewrite sum_plus, sum_scal, !if_equal_sum, <- product_entry by auto.
  unfold mr, derivative. rewrite !entry_table by (unfold m; lia). unfold derivative_entry. fold n. entries.
  rewrite opp_IZR. unfold xpart. ring.
Qed.

Lemma derivative_second u i : (i < n)%nat -> apply m (mr derivative) u (n + i)%nat =
  P (ypart u) i - IZR (er e) * u (n + i)%nat - IZR (ei e) * u i - IZR (nth i (xi e) 0%Z) * u (n + n)%nat - IZR (nth i (xr e) 0%Z) * u (n + n + 1)%nat.
Proof.
  intros Hi. unfold apply. rewrite split_sum.
  rewrite (sum_ext n _ (fun j => (-1) * (IZR (if_equal i j (ei e)) * u j))).
  2:{ intros j Hj. unfold mr, derivative. rewrite entry_table by (unfold m; lia). unfold derivative_entry. fold n. entries.
      replace (n + i - n)%nat with i by lia. rewrite opp_IZR. ring. }
  rewrite (sum_ext n (fun j => mr derivative (n + i)%nat (n + j)%nat * _)
    (fun j => IZR (entry (product_columns F e) j i) * ypart u j + (-1) * (IZR (if_equal i j (er e)) * ypart u j))).
  2:{ intros j Hj. unfold mr, derivative. rewrite entry_table by (unfold m; lia). unfold derivative_entry. fold n. entries.
      replace (n + j - n)%nat with j by lia. replace (n + i - n)%nat with i by lia. rewrite minus_IZR. unfold ypart. ring. }
  rewrite sum_plus, !sum_scal, !if_equal_sum, <- product_entry by auto.
  unfold mr, derivative. rewrite !entry_table by (unfold m; lia). unfold derivative_entry. fold n. entries.
  replace (n + i - n)%nat with i by lia. rewrite !opp_IZR. unfold ypart. ring.
Qed.

Lemma sum_pick k a u : (k < m)%nat -> sum m (fun j => IZR (if_equal j k a) * u j) = IZR a * u k.
Proof.
  intros Hk. rewrite <- (sum_identity m k u) at 1 by auto. rewrite <- sum_scal. apply sum_ext; intros j Hj.
  unfold if_equal, identity. destruct (Nat.eqb j k); lra.
Qed.

Lemma derivative_third u : (pivot e < n)%nat ->
  apply m (mr derivative) u (n + n)%nat = IZR (pivot_scale e) * u (pivot e) /\
  apply m (mr derivative) u (n + n + 1)%nat = IZR (pivot_scale e) * u (n + pivot e)%nat.
Proof.
  intros Hp. unfold apply. split.
  - rewrite <- (sum_pick (pivot e)) by (unfold m; lia). apply sum_ext; intros j Hj.
    unfold mr, derivative. rewrite entry_table by (unfold m; lia). unfold derivative_entry. fold n. entries. reflexivity.
  - rewrite <- (sum_pick (n + pivot e)%nat) by (unfold m; lia). apply sum_ext; intros j Hj.
    unfold mr, derivative. rewrite entry_table by (unfold m; lia). unfold derivative_entry. fold n. entries. reflexivity.
Qed.
End Sound.

Lemma pow_le_reg x y k : (0 < k)%nat -> 0 <= x -> 0 <= y -> x ^ k <= y ^ k -> x <= y.
Proof.
  intros Hk Hx Hy H. destruct (Rle_lt_dec x y) as [|L]; auto. exfalso.
  destruct k; [lia|]. clear Hk. assert (y ^ S k < x ^ S k); [|lra]. clear H.
  induction k; simpl in *. lra.
  apply Rle_lt_trans with (y * (x * x ^ k)). apply Rmult_le_compat_l; lra.
  apply Rmult_lt_compat_r; auto. assert (0 <= y * y ^ k) by (apply Rmult_le_pos; auto; apply pow_le; auto). lra.
Qed.

Lemma contracts_sound F e f : (0 <= distance e)%Z -> contracts F e f = true ->
  let m := (size F + size F + 2)%nat in
  let J := table m (derivative_entry F e (product_columns F e)) in
  IZR (pivot_scale e) <> 0 /\
  exists u, near m u zero (IZR (distance e)) /\ forall i, (i < m)%nat -> vr f i + apply m (mr J) u i + quadratic_part F u i = 0.
Proof.
  intros H0 H m J. unfold contracts in H. fold m in H. fold J in H.
  set (e1 := defect m (over e) (products (inverse e) (columns m J))) in *.
  set (e2 := defect m (over e) (products J (columns m (inverse e)))) in *.
  set (e3 := size_of m (inverse e)) in *.
  set (eta := largest_of _) in *.
  repeat rewrite andb_true_iff in H. destruct H as [[[[[KA KP] K4] K3] K2] K1].
  apply Z.ltb_lt in KA. apply negb_true_iff, Z.eqb_neq in KP. apply Z.ltb_lt in K3. apply Z.ltb_lt in K2. apply Z.leb_le in K1.
  split. apply not_0_IZR; auto.
  set (al := IZR (over e)). assert (Hal : 0 < al) by (apply IZR_lt; auto).
  set (rho := IZR (distance e)). assert (Hrho : 0 <= rho) by (apply IZR_le; auto).
  set (A := fun i j => mr (inverse e) i j / al).
  assert (HA : forall x i, apply m A x i = / al * apply m (mr (inverse e)) x i).
  { intros x i. unfold apply, A. rewrite <- sum_scal. apply sum_ext; intros. unfold Rdiv. ring. }
  assert (HA' : forall x, apply m A x = scal (/ al) (apply m (mr (inverse e)) x)).
  { intros x. extensionality i. apply HA. }
  assert (E1n : (0 <= e1)%Z) by apply largest_of_nonneg.
  assert (E3n : (0 <= e3)%Z) by apply largest_of_nonneg.
  assert (Hial : 0 < / al) by (apply Rinv_0_lt_compat; auto).
  apply (zero_exists m (mr J) A (vr f) (quadratic_part F) rho (IZR e1 / al) (IZR e2 / al) (IZR e3 / al) (4 * rho) (IZR eta / al)).
  - exact Hrho.
  - intros d x Hx i Hi. rewrite HA.
    assert (B := defect_sound m (over e) (products (inverse e) (columns m J)) d x Hx i Hi).
    rewrite apply_products in B by auto. fold e1 al in B.
    replace (x i - / al * apply m (mr (inverse e)) (apply m (mr J) x) i)
      with (/ al * (al * x i - apply m (mr (inverse e)) (apply m (mr J) x) i)) by (field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (/ al)) by lra. replace (IZR e1 / al * d) with (/ al * (IZR e1 * d)) by (field; lra).
    apply Rmult_le_compat_l; lra.
  - intros d x Hx i Hi. rewrite HA', apply_scal. unfold scal.
    assert (B := defect_sound m (over e) (products J (columns m (inverse e))) d x Hx i Hi).
    rewrite apply_products in B by (auto; apply square_table). fold e2 al in B.
    replace (x i - / al * apply m (mr J) (apply m (mr (inverse e)) x) i)
      with (/ al * (al * x i - apply m (mr J) (apply m (mr (inverse e)) x) i)) by (field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (/ al)) by lra. replace (IZR e2 / al * d) with (/ al * (IZR e2 * d)) by (field; lra).
    apply Rmult_le_compat_l; lra.
  - intros d x Hx i Hi. rewrite HA. unfold zero. rewrite Rminus_0_r, Rabs_mult, (Rabs_pos_eq (/ al)) by lra.
    replace (IZR e3 / al * d) with (/ al * (IZR e3 * d)) by (field; lra). apply Rmult_le_compat_l. lra.
    apply (near_apply_bound m); auto. apply size_sound. apply Z.le_refl.
  - intros i Hi. unfold quadratic_part, zero. destruct (i <? size F)%nat, (i <? size F + size F)%nat; ring.
  - intros x y d Hx Hy Hd. apply quadratic_close; auto.
  - intros i Hi. rewrite HA. unfold zero. rewrite Rminus_0_r, Rabs_mult, (Rabs_pos_eq (/ al)) by lra.
    unfold Rdiv. rewrite Rmult_comm. apply Rmult_le_compat_r. lra.
    rewrite <- vr_mv by auto. unfold vr. rewrite <- abs_IZR. apply IZR_le.
    destruct (nth_in_or_default i (mv (inverse e) f) 0%Z) as [I | ->].
    apply (largest_of_bound Z.abs); auto. apply largest_of_nonneg.
  - replace (IZR e1 / al + IZR e3 / al * (4 * rho)) with (/ al * (IZR e1 + 4 * rho * IZR e3)) by (field; lra).
    assert (B : IZR e1 + 4 * rho * IZR e3 < al).
    { unfold rho, al. rewrite <- !mult_IZR, <- plus_IZR. apply IZR_lt. lia. }
    assert (0 <= IZR e1) by (apply IZR_le; auto). assert (0 <= IZR e3) by (apply IZR_le; auto).
    split. apply Rmult_le_pos. lra. assert (0 <= 4 * rho * IZR e3) by (apply Rmult_le_pos; lra). lra.
    apply (Rmult_lt_reg_l al); auto. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l, Rmult_1_r by lra. auto.
  - apply IZR_le in K1. rewrite mult_IZR, !minus_IZR, !mult_IZR in K1. fold al rho in K1.
    apply (Rmult_le_reg_l al); auto.
    replace (al * (IZR eta / al + (IZR e1 / al + IZR e3 / al * (4 * rho)) * rho))
      with (IZR eta + (IZR e1 + 4 * rho * IZR e3) * rho) by (field; lra). lra.
  - apply (Rmult_lt_reg_l al); auto. replace (al * (IZR e2 / al)) with (IZR e2) by (field; lra). rewrite Rmult_1_r.
    apply IZR_lt; auto.
Qed.

Theorem eigenvalue_sound F e l : well_formed F = true -> eigenvalue F e l = true ->
  radius_at_least (size F) (count F) (real F) (real_of l).
Proof.
  intros WF H r Hr G. unfold eigenvalue in H.
  set (n := size F) in *. set (m := (n + n + 2)%nat) in *.
  set (J := table m (derivative_entry F e (product_columns F e))) in *.
  set (f := map _ (seq 0 m)) in H.
  set (a := Z.max 0 (Z.abs (er e) - distance e)) in *. set (b := Z.max 0 (Z.abs (ei e) - distance e)) in *.
  repeat rewrite andb_true_iff in H. destruct H as [[[[[[[[H KD] K9] K7] K6] K5] KV] K0] K].
  apply Z.ltb_lt in H. apply Z.leb_le in KD. apply Nat.ltb_lt in K9. apply Z.ltb_lt in K6. apply Z.leb_le in K0. apply Z.leb_le in K.
  assert (Word : letters (count F) (word e)).
  { unfold letters. rewrite Forall_forall. rewrite forallb_forall in K7. intros t Ht. apply Nat.ltb_lt, K7; auto. }
  assert (D0 := denominator_positive F WF).
  set (rho := IZR (distance e)). assert (Hrho : 0 <= rho) by (apply IZR_le; auto).
  assert (Zero : exists u, (near m u zero rho /\ forall i, (i < m)%nat -> vr f i + apply m (mr J) u i + quadratic_part F u i = 0) /\
    (IZR (pivot_scale e) <> 0 \/ u = zero)).
  { apply orb_prop in KV. destruct KV as [KV|KV].
    - exists zero. split; [split|right; auto].
      + intros i Hi. unfold zero. rewrite Rminus_0_r, Rabs_R0. auto.
      + intros i Hi. rewrite apply_zero. unfold quadratic_part, zero.
        assert (Vz : vr f i = 0).
        { unfold vr. destruct (nth_in_or_default i f 0%Z) as [I | ->]; auto. rewrite forallb_forall in KV. apply KV in I.
          apply Z.eqb_eq in I. rewrite <- I. auto. }
        rewrite Vz. destruct (i <? size F)%nat, (i <? size F + size F)%nat; ring.
    - destruct (contracts_sound F e f KD KV) as [NZ [u Hu]]. exists u. auto. }
  destruct Zero as [u [[Hu Hz] NZ]].
  (* u corrects the eigenvector and the eigenvalue *)
  set (s := IZR (multiplier e)). assert (Hs : 0 < s) by (apply IZR_lt; auto).
  set (D := IZR (denominator F)) in *.
  set (x := plus (vr (xr e)) u). set (y := plus (vr (xi e)) (fun i => u (n + i)%nat)).
  set (ca := IZR (er e) + u (n + n)%nat). set (cb := IZR (ei e) + u (n + n + 1)%nat).
  set (c := s * D ^ length (word e)).
  assert (Hc : 0 < c) by (apply Rmult_lt_0_compat; auto; apply pow_lt; auto).
  assert (Vf : forall i, (i < m)%nat -> vr f i = IZR (value_entry F e (addmul (multiplier e) (zrun (matrices F) (word e) (xr e)) [])
    (addmul (multiplier e) (zrun (matrices F) (word e) (xi e)) []) i)).
  { intros i Hi. unfold vr, f. rewrite nth_map_seq; auto. }
  assert (Hx : forall i, (i < n)%nat -> c * run n (real F) (word e) x i = ca * x i - cb * y i).
  { intros i Hi. assert (Zi := Hz i ltac:(unfold m; lia)). rewrite Vf in Zi by (unfold m; lia).
    unfold J, m in Zi. unfold n in Zi. rewrite derivative_first in Zi by auto. fold n in Zi.
    unfold value_entry, quadratic_part in Zi. fold n in Zi.
    destruct (Nat.ltb_spec i n); [|lia]. rewrite plus_IZR, minus_IZR, !mult_IZR in Zi.
    change (IZR (nth i (addmul (multiplier e) (zrun (matrices F) (word e) (xr e)) []) 0%Z))
      with (vr (addmul (multiplier e) (zrun (matrices F) (word e) (xr e)) []) i) in Zi.
    rewrite product_image in Zi by auto. fold n s D c in Zi.
    unfold x at 1. rewrite run_plus. unfold scal in Zi. unfold ca, cb, x, y, plus, vr at 2. unfold vr at 2.
    fold (vr (xr e)). lra. }
  assert (Hy : forall i, (i < n)%nat -> c * run n (real F) (word e) y i = ca * y i + cb * x i).
  { intros i Hi. assert (Zi := Hz (n + i)%nat ltac:(unfold m; lia)). rewrite Vf in Zi by (unfold m; lia).
    unfold J, m in Zi. unfold n in Zi. rewrite derivative_second in Zi by auto. fold n in Zi.
    unfold value_entry, quadratic_part in Zi. fold n in Zi.
    destruct (Nat.ltb_spec (n + i) n); [lia|]. destruct (Nat.ltb_spec (n + i) (n + n)); [|lia].
    replace (n + i - n)%nat with i in Zi by lia. rewrite !minus_IZR, !mult_IZR in Zi.
    change (IZR (nth i (addmul (multiplier e) (zrun (matrices F) (word e) (xi e)) []) 0%Z))
      with (vr (addmul (multiplier e) (zrun (matrices F) (word e) (xi e)) []) i) in Zi.
    rewrite product_image in Zi by auto. fold n s D c in Zi.
    unfold y at 1. rewrite run_plus. unfold scal in Zi. unfold ca, cb, x, y, plus, vr at 2. unfold vr at 2.
    fold (vr (xi e)). lra. }
  assert (Pivot : x (pivot e) <> 0 \/ y (pivot e) <> 0).
  { assert (U : u (pivot e) = 0 /\ u (n + pivot e)%nat = 0).
    { destruct NZ as [NZ | ->]; [|split; reflexivity].
    assert (Zp := Hz (n + n)%nat ltac:(unfold m; lia)). assert (Zq := Hz (n + n + 1)%nat ltac:(unfold m; lia)).
    rewrite Vf in Zp, Zq by (unfold m; lia). unfold value_entry, quadratic_part in Zp, Zq. fold n in Zp, Zq.
    unfold J, m, n in Zp, Zq.
    rewrite (proj1 (derivative_third F e u K9)) in Zp. rewrite (proj2 (derivative_third F e u K9)) in Zq. fold n in Zp, Zq.
    destruct (Nat.ltb_spec (n + n) n); [lia|]. destruct (Nat.ltb_spec (n + n) (n + n)); [lia|].
    destruct (Nat.ltb_spec (n + n + 1) n); [lia|]. destruct (Nat.ltb_spec (n + n + 1) (n + n)); [lia|].
    split. { apply (Rmult_eq_reg_l (IZR (pivot_scale e))); auto. lra. }
    { apply (Rmult_eq_reg_l (IZR (pivot_scale e))); auto. lra. }
    }
    destruct U as [U1 U2]. unfold x, y, plus. rewrite U1, U2, !Rplus_0_r. apply negb_true_iff, andb_false_iff in K5.
    destruct K5 as [K5|K5]; apply Z.eqb_neq in K5; [left|right]; apply not_0_IZR; auto. }
  assert (Bound := eigenvalue_at_least n (count F) (real F) (word e) r x y (ca / c) (cb / c) (pivot e) Hr G Word).
  assert (Bound' : modulus (ca / c) (cb / c) <= r ^ length (word e)).
  { apply Bound; auto.
    - intros i Hi. apply (Rmult_eq_reg_l c); [|lra]. rewrite Hx by auto. field. lra.
    - intros i Hi. apply (Rmult_eq_reg_l c); [|lra]. rewrite Hy by auto. field. lra. }
  clear Bound.
  (* the eigenvalue is at least that far from 0 *)
  set (k := length (word e)) in *.
  assert (Hk : (0 < k)%nat) by (unfold k; lia).
  assert (Far : forall z v, Rabs v <= rho -> IZR (Z.max 0 (Z.abs z - distance e)) * IZR (Z.max 0 (Z.abs z - distance e)) <= (IZR z + v) * (IZR z + v)).
  { intros z v Hv. destruct (Z_le_gt_dec (Z.abs z) (distance e)).
    - rewrite Z.max_l by lia. rewrite Rmult_0_l. apply (Rle_0_sqr (IZR z + v)).
    - rewrite Z.max_r by lia. rewrite minus_IZR, abs_IZR. fold rho.
      assert (Hz' : rho <= Rabs (IZR z)). { unfold rho. rewrite <- abs_IZR. apply IZR_le. lia. }
      assert (B : Rabs (IZR z) - rho <= Rabs (IZR z + v)).
      { assert (B := Rabs_triang (IZR z + v) (- v)). rewrite Rabs_Ropp in B. replace (IZR z + v + - v) with (IZR z) in B by ring. lra. }
      assert (Q : (IZR z + v) * (IZR z + v) = Rabs (IZR z + v) * Rabs (IZR z + v)).
      { rewrite <- Rabs_mult. symmetry. apply Rabs_pos_eq. apply (Rle_0_sqr (IZR z + v)). }
      rewrite Q. apply Rmult_le_compat; lra. }
  assert (Hua : Rabs (u (n + n)%nat) <= rho).
  { specialize (Hu (n + n)%nat ltac:(unfold m; lia)). unfold zero in Hu. rewrite Rminus_0_r in Hu. auto. }
  assert (Hub : Rabs (u (n + n + 1)%nat) <= rho).
  { specialize (Hu (n + n + 1)%nat ltac:(unfold m; lia)). unfold zero in Hu. rewrite Rminus_0_r in Hu. auto. }
  assert (Fa := Far (er e) _ Hua). assert (Fb := Far (ei e) _ Hub). fold a ca in Fa. fold b cb in Fb.
  (* and so is the claim *)
  assert (Hq : 0 < IZR (Zpos (Qden l))) by (apply IZR_lt; lia).
  assert (Hp : 0 <= IZR (Qnum l)) by (apply IZR_le; auto).
  assert (Hl : 0 <= real_of l).
  { unfold real_of. apply Rmult_le_pos; auto. left; apply Rinv_0_lt_compat; auto. }
  apply (pow_le_reg _ _ k Hk); auto. eapply Rle_trans; [|apply Bound'].
  apply IZR_le in K. rewrite !mult_IZR, plus_IZR, !mult_IZR in K.
  replace (2 * Z.of_nat k)%Z with (Z.of_nat (k + k)) in K by lia. rewrite <- !pow_IZR, mult_IZR in K.
  fold s D in K. rewrite Rpow_mult_distr, !pow_add in K.
  set (q := IZR (Zpos (Qden l))) in *. set (p := IZR (Qnum l)) in *.
  assert (Hqk : 0 < q ^ k) by (apply pow_lt; auto). assert (HDk : 0 < D ^ k) by (apply pow_lt; auto).
  unfold modulus. rewrite <- (sqrt_Rsqr (real_of l ^ k)) by (apply pow_le; auto).
  apply sqrt_le_1_alt. unfold Rsqr.
  assert (E : real_of l ^ k = p ^ k / q ^ k).
  { unfold real_of. fold p q. unfold Rdiv. rewrite Rpow_mult_distr, pow_inv by lra. reflexivity. }
  rewrite E. apply (Rmult_le_reg_r (c * c * (q ^ k * q ^ k))).
  { repeat apply Rmult_lt_0_compat; auto. }
  replace (p ^ k / q ^ k * (p ^ k / q ^ k) * (c * c * (q ^ k * q ^ k))) with (p ^ k * p ^ k * (D ^ k * D ^ k) * (s * s)) by (unfold c; fold k; field; lra).
  replace ((ca / c * (ca / c) + cb / c * (cb / c)) * (c * c * (q ^ k * q ^ k))) with (q ^ k * q ^ k * (ca * ca + cb * cb)) by (field; lra).
  eapply Rle_trans. apply K. apply Rmult_le_compat_l. apply Rmult_le_pos; lra. lra.
Qed.
