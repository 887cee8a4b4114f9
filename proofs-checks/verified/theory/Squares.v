(* Coefficients of sums of squares: the central one is the largest. Of such sums it is kept that all sums of
   x_j x_k f_(j - k) are 0 or more, which passes on to products with p(z) p(1/z) and to f(z^A). *)
Require Import Reals List ZArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Subdivision Growth.
Import ListNotations.
Open Scope R_scope.

(* The coefficients of p(1/z) f(z) and of p(z) f(z) *)
Fixpoint ahead (p : list R) (f : Z -> R) (i : Z) : R := match p with [] => 0 | c :: p' => c * f i + ahead p' f (i + 1)%Z end.
Fixpoint back (p : list R) (f : Z -> R) (i : Z) : R := match p with [] => 0 | c :: p' => c * f i + back p' f (i - 1)%Z end.

Fixpoint product_of (p q : list R) : list R := match p with [] => [] | c :: p' => padd (pscal c q) (0 :: product_of p' q) end.

Definition even (f : Z -> R) : Prop := forall i, f (- i)%Z = f i.
Definition positive (f : Z -> R) : Prop := forall x, 0 <= ahead x (back x f) 0.

(* ---- both operations --------------------------------------------------------------------------------------------- *)

Lemma ahead_sum p f : forall i n, (length p <= n)%nat -> ahead p f i = sum n (fun k => nth k p 0 * f (i + Z.of_nat k)%Z).
Proof.
  induction p; intros i n H; cbn [ahead].
  - rewrite sum_zero; auto. intros k _. destruct k; simpl; lra.
  - destruct n; [simpl in H; lia|]. change (S n) with (1 + n)%nat. rewrite sum_add, (IHp (i + 1)%Z n) by (simpl in H; lia).
    cbn [sum nth]. rewrite Z.add_0_r. f_equal. lra. apply sum_ext; intros k _. cbn [Nat.add nth]. do 2 f_equal. lia.
Qed.

Lemma back_sum p f : forall i n, (length p <= n)%nat -> back p f i = sum n (fun k => nth k p 0 * f (i - Z.of_nat k)%Z).
Proof.
  induction p; intros i n H; cbn [back].
  - rewrite sum_zero; auto. intros k _. destruct k; simpl; lra.
  - destruct n; [simpl in H; lia|]. change (S n) with (1 + n)%nat. rewrite sum_add, (IHp (i - 1)%Z n) by (simpl in H; lia).
    cbn [sum nth]. rewrite Z.sub_0_r. f_equal. lra. apply sum_ext; intros k _. cbn [Nat.add nth]. do 2 f_equal. lia.
Qed.

Lemma back_ext p f g : forall i, (forall j, f j = g j) -> back p f i = back p g i.
Proof. intros i H. replace g with f; auto. extensionality j. auto. Qed.

Lemma ahead_linear p a f b g : forall i, ahead p (fun j => a * f j + b * g j) i = a * ahead p f i + b * ahead p g i.
Proof. induction p; intros i; cbn [ahead]. ring. rewrite IHp. ring. Qed.
Lemma back_linear p a f b g : forall i, back p (fun j => a * f j + b * g j) i = a * back p f i + b * back p g i.
Proof. induction p; intros i; cbn [back]. ring. rewrite IHp. ring. Qed.

Lemma ahead_move p f t : forall i, ahead p (fun j => f (j + t)%Z) i = ahead p f (i + t)%Z.
Proof. induction p; intros i; cbn [ahead]; auto. rewrite IHp. do 2 f_equal. lia. Qed.
Lemma back_move p f t : forall i, back p (fun j => f (j + t)%Z) i = back p f (i + t)%Z.
Proof. induction p; intros i; cbn [back]; auto. rewrite IHp. do 2 f_equal. lia. Qed.

Lemma ahead_zero p i : ahead p (fun _ => 0) i = 0.
Proof. revert i. induction p; intros i; cbn [ahead]; auto. rewrite IHp. ring. Qed.
Lemma back_zero p i : back p (fun _ => 0) i = 0.
Proof. revert i. induction p; intros i; cbn [back]; auto. rewrite IHp. ring. Qed.

Lemma ahead_back p q f : forall i, ahead p (back q f) i = back q (ahead p f) i.
Proof.
  induction p; intros i; cbn [ahead]. rewrite back_zero. auto.
  rewrite IHp. rewrite <- (back_move q (ahead p f) 1).
  replace (fun i0 => a * f i0 + ahead p f (i0 + 1)%Z) with (fun i0 => a * f i0 + 1 * ahead p f (i0 + 1)%Z) by (extensionality j; ring).
  rewrite back_linear. ring.
Qed.

Lemma back_back p q f : forall i, back p (back q f) i = back q (back p f) i.
Proof.
  induction p; intros i; cbn [back]. rewrite back_zero. auto.
  rewrite IHp. replace (i - 1)%Z with (i + -1)%Z by lia. rewrite <- (back_move q (back p f) (-1)).
  replace (fun i0 => a * f i0 + back p f (i0 - 1)%Z) with (fun i0 => a * f i0 + 1 * back p f (i0 + -1)%Z)
    by (extensionality j; replace (j + -1)%Z with (j - 1)%Z by lia; ring).
  rewrite back_linear. ring.
Qed.

Lemma ahead_ahead p q f : forall i, ahead p (ahead q f) i = ahead q (ahead p f) i.
Proof.
  induction p; intros i; cbn [ahead]. rewrite ahead_zero. auto.
  rewrite IHp. rewrite <- (ahead_move q (ahead p f) 1).
  replace (fun i0 => a * f i0 + ahead p f (i0 + 1)%Z) with (fun i0 => a * f i0 + 1 * ahead p f (i0 + 1)%Z) by (extensionality j; ring).
  rewrite ahead_linear. ring.
Qed.

Lemma ahead_padd p : forall q f i, ahead (padd p q) f i = ahead p f i + ahead q f i.
Proof. induction p; intros [|b q] f i; cbn [padd ahead]; try ring. rewrite IHp. ring. Qed.
Lemma back_padd p : forall q f i, back (padd p q) f i = back p f i + back q f i.
Proof. induction p; intros [|b q] f i; cbn [padd back]; try ring. rewrite IHp. ring. Qed.
Lemma ahead_scale c p f : forall i, ahead (pscal c p) f i = c * ahead p f i.
Proof. unfold pscal. induction p; intros i; cbn [map ahead]. ring. rewrite IHp. ring. Qed.
Lemma back_scale c p f : forall i, back (pscal c p) f i = c * back p f i.
Proof. unfold pscal. induction p; intros i; cbn [map back]. ring. rewrite IHp. ring. Qed.

Lemma ahead_product p q f : forall i, ahead (product_of p q) f i = ahead p (ahead q f) i.
Proof.
  induction p; intros i; cbn [product_of ahead]; auto. rewrite ahead_padd, ahead_scale. cbn [ahead]. rewrite IHp. ring.
Qed.
Lemma back_product p q f : forall i, back (product_of p q) f i = back p (back q f) i.
Proof.
  induction p; intros i; cbn [product_of back]; auto. rewrite back_padd, back_scale. cbn [back]. rewrite IHp. ring.
Qed.

Lemma ahead_app p q f : forall i, ahead (p ++ q) f i = ahead p f i + ahead q f (i + Z.of_nat (length p))%Z.
Proof.
  induction p; intros i; cbn [app ahead length]. rewrite Z.add_0_r. ring. rewrite IHp.
  replace (i + 1 + Z.of_nat (length p))%Z with (i + Z.of_nat (S (length p)))%Z by lia. ring.
Qed.
Lemma back_app p q f : forall i, back (p ++ q) f i = back p f i + back q f (i - Z.of_nat (length p))%Z.
Proof.
  induction p; intros i; cbn [app back length]. rewrite Z.sub_0_r. ring. rewrite IHp.
  replace (i - 1 - Z.of_nat (length p))%Z with (i - Z.of_nat (S (length p)))%Z by lia. ring.
Qed.

Lemma back_padded k p f i : back (repeat 0 k ++ p) f i = back p f (i - Z.of_nat k)%Z.
Proof.
  rewrite back_app, repeat_length. replace (back (repeat 0 k) f i) with 0. ring.
  clear p. revert i. induction k; intros i; cbn [repeat back]; auto. rewrite <- IHk. ring.
Qed.

Lemma ahead_padded k p f i : ahead (repeat 0 k ++ p) f i = ahead p f (i + Z.of_nat k)%Z.
Proof.
  rewrite ahead_app, repeat_length. replace (ahead (repeat 0 k) f i) with 0. ring.
  clear p. revert i. induction k; intros i; cbn [repeat ahead]; auto. rewrite <- IHk. ring.
Qed.

Lemma back_rev p f : forall i, back (rev p) f (i + Z.of_nat (length p) - 1)%Z = ahead p f i.
Proof.
  induction p; intros i; cbn [rev ahead]. auto.
  rewrite back_app, rev_length. cbn [back length]. rewrite <- IHp.
  replace (i + Z.of_nat (S (length p)) - 1)%Z with (i + 1 + Z.of_nat (length p) - 1)%Z by lia.
  replace (i + 1 + Z.of_nat (length p) - 1 - Z.of_nat (length p))%Z with i by lia. ring.
Qed.

(* ---- what keeps these properties --------------------------------------------------------------------------------- *)

Lemma even_move p f : even f -> forall i, ahead p f (- i)%Z = back p f i.
Proof. intros H. induction p; intros i; cbn [ahead back]; auto. rewrite H, <- IHp. do 3 f_equal. lia. Qed.

Lemma mirror p f : forall i, ahead p f (- i)%Z = back p (fun k => f (- k)%Z) i.
Proof. induction p; intros i; cbn [ahead back]; auto. rewrite <- IHp. do 3 f_equal. lia. Qed.

Lemma positive_square q f : positive f -> positive (ahead q (back q f)).
Proof.
  intros H x. specialize (H (product_of x q)). eapply Rle_trans. apply H. right.
  rewrite ahead_product. replace (back (product_of x q) f) with (back x (back q f)) by (extensionality i; rewrite back_product; auto).
  f_equal. extensionality i. apply ahead_back.
Qed.

Lemma positive_sum a b f g : 0 <= a -> 0 <= b -> positive f -> positive g -> positive (fun i => a * f i + b * g i).
Proof.
  intros Ha Hb F G x. replace (back x (fun i => a * f i + b * g i)) with (fun i => a * back x f i + b * back x g i)
    by (extensionality i; rewrite back_linear; auto).
  rewrite ahead_linear. specialize (F x). specialize (G x). assert (0 <= a * ahead x (back x f) 0) by (apply Rmult_le_pos; auto).
  assert (0 <= b * ahead x (back x g) 0) by (apply Rmult_le_pos; auto). lra.
Qed.

Theorem central f : even f -> positive f -> forall i, Rabs (f i) <= f 0%Z.
Proof.
  intros E P i.
  assert (H : forall s k, s * s = 1 -> 0 <= f 0%Z + s * f (Z.of_nat k)).
  { intros s k Hs. specialize (P (padd [1] (repeat 0 k ++ [s]))).
    assert (A : forall g j, ahead (padd [1] (repeat 0 k ++ [s])) g j = g j + s * g (j + Z.of_nat k)%Z).
    { intros g j. rewrite ahead_padd, ahead_padded. cbn [ahead]. ring. }
    assert (B : forall g j, back (padd [1] (repeat 0 k ++ [s])) g j = g j + s * g (j - Z.of_nat k)%Z).
    { intros g j. rewrite back_padd, back_padded. cbn [back]. ring. }
    rewrite A, !B in P. replace (0 + Z.of_nat k - Z.of_nat k)%Z with 0%Z in P by lia.
    replace (0 - Z.of_nat k)%Z with (- Z.of_nat k)%Z in P by lia. replace (0 + Z.of_nat k)%Z with (Z.of_nat k) in P by lia. rewrite E in P.
    assert (X : s * (s * f 0%Z) = f 0%Z) by (rewrite <- Rmult_assoc, Hs; ring). lra. }
  assert (K : exists k, f i = f (Z.of_nat k)).
  { destruct (Z_le_gt_dec 0 i). exists (Z.to_nat i). f_equal. lia. exists (Z.to_nat (- i)). rewrite <- E. f_equal. lia. }
  destruct K as [k ->]. assert (H1 := H 1 k ltac:(ring)). assert (H2 := H (-1) k ltac:(ring)). apply Rabs_le. lra.
Qed.

(* A symbol whose central coefficient is at least the sum of the moduli of the others *)
Lemma positive_dominant e mid f : even f -> positive f ->
  sum (length e) (fun k => Rabs (nth k e 0)) <= 2 * nth mid e 0 -> positive (fun i => back e f (i + Z.of_nat mid)%Z).
Proof.
  intros E P H x.
  replace (back x (fun i => back e f (i + Z.of_nat mid)%Z)) with (fun i => back e (back x f) (i + Z.of_nat mid)%Z)
    by (extensionality i; rewrite back_move, back_back; auto).
  rewrite (ahead_move x (back e (back x f))), ahead_back. set (g := ahead x (back x f)).
  assert (PG : positive g).
  { unfold g. apply positive_square. auto. }
  assert (EG : even g).
  { intros i. unfold g. rewrite mirror, ahead_back. apply back_ext. intros j. rewrite <- (even_move x f E). f_equal. lia. }
  assert (C := central g EG PG). assert (G0 : 0 <= g 0%Z). { eapply Rle_trans; [|apply (C 0%Z)]. apply Rabs_pos. }
  rewrite (back_sum e g _ (length e)) by auto. set (at_ := fun k => g (0 + Z.of_nat mid - Z.of_nat k)%Z).
  destruct (lt_dec mid (length e)) as [M|M].
  2:{ rewrite (nth_overflow e) in H by lia. assert (Z : forall k, (k < length e)%nat -> nth k e 0 = 0).
      { intros k Hk. assert (T := sum_term (length e) (fun k => Rabs (nth k e 0)) k (fun i _ => Rabs_pos _) Hk). cbv beta in T.
        destruct (Req_dec (nth k e 0) 0) as [Z|Z]; auto. apply Rabs_pos_lt in Z. lra. }
      rewrite sum_zero. lra. intros k Hk. rewrite Z by auto. ring. }
  assert (Split : forall F : nat -> R, sum (length e) F = F mid + sum (length e) (fun k => if Nat.eqb k mid then 0 else F k)).
  { intros F. rewrite <- (sum_identity (length e) mid F M) at 1. rewrite <- sum_plus. apply sum_ext. intros k _. unfold identity.
    destruct (Nat.eqb_spec k mid); subst; ring. }
  rewrite Split. replace (0 + Z.of_nat mid - Z.of_nat mid)%Z with 0%Z by lia.
  rewrite Split in H. set (rest := sum (length e) (fun k => if Nat.eqb k mid then 0 else Rabs (nth k e 0))) in *.
  assert (R0 : 0 <= rest). { apply sum_nonneg. intros k _. destruct (Nat.eqb k mid). lra. apply Rabs_pos. }
  assert (A := Rabs_pos (nth mid e 0)). rewrite Rabs_pos_eq in H by lra.
  assert (L : - (g 0%Z * rest) <= sum (length e) (fun k => if Nat.eqb k mid then 0 else nth k e 0 * g (0 + Z.of_nat mid - Z.of_nat k)%Z)).
  { replace (- (g 0%Z * rest)) with (- g 0%Z * rest) by ring. unfold rest. rewrite <- sum_scal. apply sum_le. intros k _. destruct (Nat.eqb k mid). lra.
    set (v := g (0 + Z.of_nat mid - Z.of_nat k)%Z). assert (B : Rabs v <= g 0%Z) by apply C.
    assert (D := Rabs_pos (nth k e 0)). assert (N : - (Rabs (nth k e 0) * Rabs v) <= nth k e 0 * v).
    { rewrite <- Rabs_mult. assert (X := Rle_abs (- (nth k e 0 * v))). rewrite Rabs_Ropp in X. lra. }
    assert (Rabs (nth k e 0) * Rabs v <= Rabs (nth k e 0) * g 0%Z) by (apply Rmult_le_compat_l; auto). lra. }
  assert (g 0%Z * rest <= g 0%Z * nth mid e 0) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(* f(z^A) *)
Definition spread (A : nat) (f : Z -> R) (i : Z) : R := if Z.eqb (i mod Z.of_nat A) 0 then f (i / Z.of_nat A)%Z else 0.

Lemma even_spread A f : (1 <= A)%nat -> even f -> even (spread A f).
Proof.
  intros HA H i. unfold spread. destruct (Z.eqb_spec (i mod Z.of_nat A) 0) as [E|E].
  - assert (Q : (i = Z.of_nat A * (i / Z.of_nat A))%Z) by (assert (D := Z.div_mod i (Z.of_nat A) ltac:(lia)); lia).
    set (j := (i / Z.of_nat A)%Z) in *. replace (- i)%Z with ((- j) * Z.of_nat A)%Z by lia. rewrite Z.mod_mul, Z.div_mul by lia.
    simpl. apply H.
  - destruct (Z.eqb_spec ((- i) mod Z.of_nat A) 0) as [E'|E']; auto. exfalso. apply E. apply Z.mod_opp_l_z in E'; [|lia].
    rewrite Z.opp_involutive in E'. auto.
Qed.

Lemma spread_split A M (x : nat -> R) f : (1 <= A)%nat ->
  sum (M * A) (fun j => x j * sum (M * A) (fun k => x k * spread A f (Z.of_nat j - Z.of_nat k))) =
  sum A (fun s => sum M (fun j => x (j * A + s)%nat * sum M (fun k => x (k * A + s)%nat * f (Z.of_nat j - Z.of_nat k)%Z))).
Proof.
  intros HA. rewrite sum_blocks, sum_swap. apply sum_ext. intros s Hs. apply sum_ext. intros j _. f_equal.
  rewrite sum_blocks. apply sum_ext. intros k _.
  rewrite (sum_ext A _ (fun t => identity t s * (x (k * A + t)%nat * f (Z.of_nat j - Z.of_nat k)%Z))).
  - apply sum_identity. auto.
  - intros t Ht. unfold identity, spread. destruct (Nat.eqb_spec t s) as [->|N].
    + replace (Z.of_nat (j * A + s) - Z.of_nat (k * A + s))%Z with ((Z.of_nat j - Z.of_nat k) * Z.of_nat A)%Z by (rewrite !Nat2Z.inj_add, !Nat2Z.inj_mul; ring).
      rewrite Z.mod_mul, Z.div_mul by lia. simpl. ring.
    + destruct (Z.eqb_spec ((Z.of_nat (j * A + s) - Z.of_nat (k * A + t)) mod Z.of_nat A) 0) as [E|E]; [|ring]. exfalso.
      apply Z.mod_divide in E; [|lia]. destruct E as [c E]. rewrite !Nat2Z.inj_add, !Nat2Z.inj_mul in E.
      assert (Z.of_nat s - Z.of_nat t = (c - Z.of_nat j + Z.of_nat k) * Z.of_nat A)%Z by lia.
      set (v := (c - Z.of_nat j + Z.of_nat k)%Z) in *. destruct (Z_lt_ge_dec v 0); [|destruct (Z_lt_ge_dec 0 v)]; [nia|nia|]. assert (v = 0%Z) by lia. nia.
Qed.

Lemma double_sum x f n : (length x <= n)%nat ->
  ahead x (back x f) 0 = sum n (fun j => nth j x 0 * sum n (fun k => nth k x 0 * f (Z.of_nat j - Z.of_nat k)%Z)).
Proof. intros H. rewrite (ahead_sum x _ _ n H). apply sum_ext. intros j _. f_equal. rewrite (back_sum x _ _ n H). auto. Qed.

Lemma nth_map_seq_real (x : nat -> R) n i : (i < n)%nat -> nth i (map x (seq 0 n)) 0 = x i.
Proof.
  intros H. rewrite nth_indep with (d' := x 0%nat) by (rewrite map_length, seq_length; auto). rewrite map_nth, seq_nth; auto.
Qed.

Lemma positive_spread A f : (1 <= A)%nat -> positive f -> positive (spread A f).
Proof.
  intros HA H x. set (M := length x). rewrite (double_sum x _ (M * A)) by (unfold M; nia). rewrite (spread_split A M) by auto.
  apply sum_nonneg. intros s Hs. specialize (H (map (fun j => nth (j * A + s) x 0) (seq 0 M))).
  rewrite (double_sum _ _ M) in H by (rewrite map_length, seq_length; auto). eapply Rle_trans. apply H. right.
  apply sum_ext. intros j Hj. rewrite (nth_map_seq_real (fun j => nth (j * A + s) x 0)) by auto. f_equal.
  apply sum_ext. intros k Hk. rewrite (nth_map_seq_real (fun j => nth (j * A + s) x 0)) by auto. auto.
Qed.

Lemma even_delta : even delta.
Proof. intros i. unfold delta. destruct (Z.eqb_spec (- i) 0), (Z.eqb_spec i 0); auto; lia. Qed.

Lemma positive_delta : positive delta.
Proof.
  intros x. rewrite (double_sum x _ (length x)) by auto. apply sum_nonneg. intros j Hj.
  rewrite (sum_ext _ _ (fun k => identity k j * nth k x 0)).
  - rewrite sum_identity by auto. assert (P := Rle_0_sqr (nth j x 0)). unfold Rsqr in P. auto.
  - intros k _. unfold delta, identity. destruct (Z.eqb_spec (Z.of_nat j - Z.of_nat k) 0), (Nat.eqb_spec k j); try (exfalso; lia); ring.
Qed.
