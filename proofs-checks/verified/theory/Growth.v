(* Sequences that satisfy a linear recurrence: those without negative terms grow no faster than the largest zero of its
   polynomial, which Descartes' rule of signs bounds. *)
Require Import Reals List ZArith Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper.
Import ListNotations.
Open Scope R_scope.

(* ---- polynomials of a shift -------------------------------------------------------------------------------------- *)

(* f_(n+1) - u f_n, and the polynomial p of this operator *)
Definition step (u : R) (f : nat -> R) : nat -> R := fun n => f (S n) - u * f n.
Fixpoint along (u : R) (p : list R) (f : nat -> R) : nat -> R :=
  match p with [] => fun _ => 0 | c :: p' => fun n => c * f n + step u (along u p' f) n end.

Fixpoint padd (p q : list R) : list R :=
  match p, q with [], _ => q | _, [] => p | a :: p', b :: q' => (a + b) :: padd p' q' end.
Definition pscal (c : R) (p : list R) : list R := map (Rmult c) p.
(* p(X + t) *)
Fixpoint pshift (t : R) (p : list R) : list R :=
  match p with [] => [] | c :: p' => let q := pshift t p' in padd (c :: q) (pscal t q) end.
Fixpoint pvalue (p : list R) (x : R) : R := match p with [] => 0 | c :: p' => c + x * pvalue p' x end.

Lemma step_linear u a b f g n : step u (fun k => a * f k + b * g k) n = a * step u f n + b * step u g n.
Proof. unfold step. ring. Qed.

Lemma along_linear u p a b f g : forall n, along u p (fun k => a * f k + b * g k) n = a * along u p f n + b * along u p g n.
Proof. induction p; intros n; cbn [along]. ring. unfold step. rewrite !IHp. ring. Qed.

Lemma along_scal u p a f n : along u p (fun k => a * f k) n = a * along u p f n.
Proof.
  replace (fun k => a * f k) with (fun k => a * f k + 0 * f k) by (extensionality k; ring). rewrite along_linear. ring.
Qed.

Lemma along_step u v p f n : along u p (step v f) n = step v (along u p f) n.
Proof.
  replace (step v f) with (fun k => 1 * (fun k => f (S k)) k + (- v) * f k) by (extensionality k; unfold step; ring). rewrite along_linear.
  assert (E : forall q n, along u q (fun k => f (S k)) n = along u q f (S n)).
  { induction q; intros m; cbn [along]. auto. unfold step. rewrite !IHq. reflexivity. }
  rewrite E. unfold step. ring.
Qed.

Lemma along_commute u v p q f n : along u p (along v q f) n = along v q (along u p f) n.
Proof.
  revert n. induction q; intros n; cbn [along].
  - transitivity (along u p (fun k => 0 * f k) n). f_equal. extensionality k. ring. rewrite along_scal. ring.
  - replace (fun n0 => a * f n0 + step v (along v q f) n0) with (fun n0 => a * f n0 + 1 * step v (along v q f) n0) by (extensionality k; ring).
    rewrite along_linear, along_step. unfold step. rewrite !IHq. ring.
Qed.

Lemma along_zero u p n : along u p (fun _ => 0) n = 0.
Proof. revert n. induction p; intros n; cbn [along]; auto. unfold step. rewrite !IHp. ring. Qed.

Lemma along_add u p : forall q f n, along u (padd p q) f n = along u p f n + along u q f n.
Proof.
  induction p; intros q f n; cbn [padd along]. ring. destruct q; cbn [along]. ring. unfold step. rewrite !IHp. ring.
Qed.

Lemma along_pscal u c p f : forall n, along u (pscal c p) f n = c * along u p f n.
Proof. unfold pscal. induction p; intros n; cbn [map along]. ring. unfold step. rewrite !IHp. ring. Qed.

Lemma along_shift u t p f : forall n, along (u + t) (pshift t p) f n = along u p f n.
Proof.
  induction p; intros n. auto. cbn [pshift]. rewrite along_add, along_pscal. cbn [along]. unfold step. rewrite !IHp. ring.
Qed.

Lemma nth_padd p : forall q i, nth i (padd p q) 0 = nth i p 0 + nth i q 0.
Proof. induction p; intros [|b q] i; destruct i; simpl; try lra; apply IHp. Qed.

Lemma nth_pscal c p i : nth i (pscal c p) 0 = c * nth i p 0.
Proof. unfold pscal. replace 0 with (c * 0) at 1 by ring. apply map_nth. Qed.

Lemma nth_pshift t c p i : nth i (pshift t (c :: p)) 0 =
  (match i with O => c | S k => nth k (pshift t p) 0 end) + t * nth i (pshift t p) 0.
Proof. cbn [pshift]. rewrite nth_padd, nth_pscal. destruct i; reflexivity. Qed.

Lemma length_padd p : forall q, length (padd p q) = Nat.max (length p) (length q).
Proof. induction p; intros [|b q]; simpl; auto. Qed.

Lemma length_pshift t p : length (pshift t p) = length p.
Proof. induction p; auto. cbn [pshift]. rewrite length_padd. unfold pscal. rewrite map_length. cbn [length]. rewrite IHp. lia. Qed.

Definition nonnegative (p : list R) : Prop := forall i, 0 <= nth i p 0.

Lemma nonnegative_cons c p : nonnegative (c :: p) -> 0 <= c /\ nonnegative p.
Proof. intros H. split. apply (H O). intros i. apply (H (S i)). Qed.

Lemma pshift_nonnegative t p : 0 <= t -> nonnegative p -> nonnegative (pshift t p).
Proof.
  intros Ht. induction p; intros H i. simpl. destruct i; lra.
  apply nonnegative_cons in H. destruct H as [Ha H]. rewrite nth_pshift. assert (P := IHp H).
  assert (0 <= t * nth i (pshift t p) 0) by (apply Rmult_le_pos; auto). destruct i. lra. specialize (P i). lra.
Qed.

(* The coefficients of p(X + y) for p without negative coefficients: the first one is the largest, up to powers of y. *)
Lemma pshift_bound y p : 0 < y -> nonnegative p -> forall i, y ^ i * nth i (pshift y p) 0 <= 2 ^ length p * nth 0 (pshift y p) 0.
Proof.
  intros Hy. induction p; intros H i. simpl. destruct i; lra.
  apply nonnegative_cons in H. destruct H as [Ha H]. specialize (IHp H). assert (P := pshift_nonnegative y p (Rlt_le _ _ Hy) H).
  rewrite !nth_pshift. cbn [length pow]. set (s := fun i => nth i (pshift y p) 0) in *. fold (s i) (s O) in *.
  assert (M : 1 <= 2 ^ length p) by (apply pow_R1_Rle; lra). assert (S0 : 0 <= s O) by apply P.
  assert (B : 0 <= y * s O) by (apply Rmult_le_pos; lra).
  assert (C : 0 <= 2 ^ length p * (y * s O)) by (apply Rmult_le_pos; lra).
  assert (C' : y * s O <= 2 ^ length p * (y * s O)) by (rewrite <- (Rmult_1_l (y * s O)) at 1; apply Rmult_le_compat_r; lra).
  assert (E : a <= 2 ^ length p * a) by (rewrite <- (Rmult_1_l a) at 1; apply Rmult_le_compat_r; lra).
  destruct i.
  - simpl. lra.
  - fold (s i). assert (B1 := IHp i). assert (B2 := IHp (S i)). fold (s i) in B1. fold (s (S i)) in B2 |- *.
    apply (Rmult_le_compat_l y) in B1, B2; try lra. cbn [pow] in *. lra.
Qed.

Lemma pshift_first y p : 0 < y -> nonnegative p -> (exists i, 0 < nth i p 0) -> 0 < nth 0 (pshift y p) 0.
Proof.
  intros Hy H [i Hi]. revert i Hi. induction p; intros i Hi. destruct i; simpl in Hi; lra.
  apply nonnegative_cons in H. destruct H as [Ha H]. rewrite nth_pshift.
  assert (P := pshift_nonnegative y p (Rlt_le _ _ Hy) H O). destruct i; simpl in Hi.
  - assert (0 <= y * nth 0 (pshift y p) 0) by (apply Rmult_le_pos; lra). lra.
  - assert (0 < y * nth 0 (pshift y p) 0) by (apply Rmult_lt_0_compat; eauto). lra.
Qed.

(* ---- sequences without negative terms ---------------------------------------------------------------------------- *)

Definition grows (m : nat -> R) (r : R) : Prop := exists C, forall n, Rabs (m n) <= C * r ^ n.

Lemma grows_linear a b f g r : grows f r -> grows g r -> grows (fun k => a * f k + b * g k) r.
Proof.
  intros [C H] [D K]. exists (Rabs a * C + Rabs b * D). intros n. eapply Rle_trans. apply Rabs_triang. rewrite !Rabs_mult.
  assert (Rabs a * Rabs (f n) <= Rabs a * (C * r ^ n)) by (apply Rmult_le_compat_l; auto; apply Rabs_pos).
  assert (Rabs b * Rabs (g n) <= Rabs b * (D * r ^ n)) by (apply Rmult_le_compat_l; auto; apply Rabs_pos). lra.
Qed.

Lemma grows_next f r : grows f r -> grows (fun n => f (S n)) r.
Proof. intros [C H]. exists (C * r). intros n. eapply Rle_trans. apply H. simpl. lra. Qed.

Lemma grows_zero r : grows (fun _ => 0) r.
Proof. exists 0. intros n. rewrite Rabs_R0. lra. Qed.

Lemma grows_step u f r : grows f r -> grows (step u f) r.
Proof.
  intros H. replace (step u f) with (fun k => 1 * (fun k => f (S k)) k + (- u) * f k) by (extensionality k; unfold step; ring).
  apply grows_linear; auto. apply grows_next; auto.
Qed.

Lemma grows_along u p f r : grows f r -> grows (along u p f) r.
Proof.
  intros H. induction p; cbn [along]. apply grows_zero.
  replace (fun n => a * f n + step u (along u p f) n) with (fun n => a * f n + 1 * step u (along u p f) n) by (extensionality k; ring).
  apply grows_linear; auto. apply grows_step; auto.
Qed.

Lemma grows_more f r r' : 0 <= r <= r' -> grows f r -> grows f r'.
Proof.
  intros Hr [C H]. exists C. intros n. eapply Rle_trans. apply H.
  assert (C0 : 0 <= C). { specialize (H O). simpl in H. assert (P := Rabs_pos (f O)). lra. }
  apply Rmult_le_compat_l; auto. apply pow_incr. auto.
Qed.

Lemma vanishing a b theta : 0 <= theta < 1 -> (forall k, a <= b * theta ^ k) -> a <= 0.
Proof.
  intros Ht H. apply Rnot_lt_le. intros Ha. destruct (pow_lt_1_zero theta ltac:(rewrite Rabs_pos_eq; lra) (a / (Rabs b + 1))) as [n Hn].
  { apply Rdiv_lt_0_compat; auto. assert (P := Rabs_pos b). lra. }
  specialize (Hn n (le_n n)). specialize (H n). assert (P := Rabs_pos b). assert (T : 0 <= theta ^ n) by (apply pow_le; lra).
  rewrite Rabs_pos_eq in Hn by auto. assert (b * theta ^ n <= Rabs b * theta ^ n) by (apply Rmult_le_compat_r; auto; apply Rle_abs).
  apply (Rmult_lt_compat_r (Rabs b + 1)) in Hn; [|lra]. unfold Rdiv in Hn. rewrite Rmult_assoc, Rinv_l in Hn by lra.
  assert (Rabs b * theta ^ n <= theta ^ n * (Rabs b + 1)) by lra. lra.
Qed.

Section Step.
(* The coefficients p of the recurrence around u, and of its polynomial around x = u + y, where the first is c *)
Variables (u y : R) (p : list R) (m : nat -> R).
Hypothesis U0 : 0 <= u.
Hypothesis Y0 : 0 < y.
Hypothesis P0 : nonnegative p.
Hypothesis P1 : exists i, 0 < nth i p 0.
Hypothesis M0 : forall n, 0 <= m n.
Hypothesis Recurrence : forall n, along u p m n = 0.
Variable below : R.
Hypothesis Below : 0 <= below < u + y.
Hypothesis Grows : grows m below.

Let x := u + y.
Let c := nth 0 (pshift y p) 0.
Let t := tl (pshift y p).
Let d := length p.
Let D := INR d * 2 ^ d + 1.
Let q := D / y.
Let h := y / (2 * D).

Lemma shifted : pshift y p = c :: t.
Proof.
  unfold c, t. destruct (pshift y p) eqn:E; auto. exfalso. apply (f_equal (@length R)) in E. rewrite length_pshift in E.
  destruct p; [|discriminate]. destruct P1 as [i Hi]. destruct i; simpl in Hi; lra.
Qed.

Lemma first_positive : 0 < c.
Proof. apply pshift_first; auto. Qed.

Definition resolvent (f : nat -> R) : nat -> R := fun n => / c * along x t f n.
Fixpoint iterated (k : nat) : nat -> R := match k with O => m | S k' => resolvent (iterated k') end.

Lemma iterated_recurrence k : forall n, along x (pshift y p) (iterated k) n = 0.
Proof.
  induction k; intros n.
  - unfold x. rewrite along_shift. apply Recurrence.
  - cbn [iterated]. unfold resolvent. rewrite along_scal, along_commute.
    replace (along x (pshift y p) (iterated k)) with (fun _ : nat => 0) by (extensionality i; auto). rewrite along_zero. ring.
Qed.

Lemma iterated_step k n : step x (iterated (S k)) n = - iterated k n.
Proof.
  assert (H := iterated_recurrence k n). rewrite shifted in H. cbn [along] in H. cbn [iterated]. unfold resolvent.
  assert (C := first_positive). unfold step in *. apply (Rmult_eq_reg_l c); [|lra].
  transitivity (along x t (iterated k) (S n) - x * along x t (iterated k) n). field; lra. lra.
Qed.

Lemma iterated_grows k : grows (iterated k) below.
Proof.
  induction k; auto. cbn [iterated]. unfold resolvent.
  replace (fun n => / c * along x t (iterated k) n) with (fun n => / c * along x t (iterated k) n + 0 * along x t (iterated k) n) by (extensionality i; ring).
  apply grows_linear; apply grows_along; auto.
Qed.

Lemma x_positive : 0 < x.
Proof. unfold x. lra. Qed.

Lemma iterated_next k n : iterated (S k) (S n) = x * iterated (S k) n - iterated k n.
Proof. assert (H := iterated_step k n). unfold step in H. lra. Qed.

Lemma iterated_nonnegative k : forall n, 0 <= iterated k n.
Proof.
  assert (X := x_positive). induction k; intros n. apply M0. destruct (iterated_grows (S k)) as [C HC].
  assert (Far : forall j, - (C * below ^ n) * (below / x) ^ j <= iterated (S k) n).
  { intros j. assert (G : / x ^ j * iterated (S k) (n + j) <= iterated (S k) n).
    { induction j. rewrite Nat.add_0_r. simpl. lra. eapply Rle_trans; [|apply IHj]. replace (n + S j)%nat with (S (n + j)) by lia.
      rewrite iterated_next. assert (I := IHk (n + j)%nat). assert (XJ : 0 < x ^ j) by (apply pow_lt; auto).
      simpl pow. apply (Rmult_le_reg_l (x * x ^ j)). apply Rmult_lt_0_compat; auto.
      replace (x * x ^ j * (/ (x * x ^ j) * (x * iterated (S k) (n + j) - iterated k (n + j)))) with (x * iterated (S k) (n + j) - iterated k (n + j)) by (field; lra).
      replace (x * x ^ j * (/ x ^ j * iterated (S k) (n + j))) with (x * iterated (S k) (n + j)) by (field; lra). lra. }
    eapply Rle_trans; [|apply G]. specialize (HC (n + j)%nat). rewrite pow_add in HC. assert (XJ : 0 < x ^ j) by (apply pow_lt; auto).
    assert (- (C * (below ^ n * below ^ j)) <= iterated (S k) (n + j)).
    { assert (A := Rle_abs (- iterated (S k) (n + j))). rewrite Rabs_Ropp in A. lra. }
    unfold Rdiv. rewrite Rpow_mult_distr, pow_inv by lra. apply (Rmult_le_reg_l (x ^ j)); auto.
    replace (x ^ j * (- (C * below ^ n) * (below ^ j * / x ^ j))) with (- (C * (below ^ n * below ^ j))) by (field; lra).
    replace (x ^ j * (/ x ^ j * iterated (S k) (n + j))) with (iterated (S k) (n + j)) by (field; lra). auto. }
  assert (V : - iterated (S k) n <= 0); [|lra]. apply (vanishing _ (C * below ^ n) (below / x)).
  - assert (I : 0 < / x) by (apply Rinv_0_lt_compat; auto). split. apply Rmult_le_pos; lra. apply (Rmult_lt_reg_r x); auto.
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. unfold x. lra.
  - intros j. specialize (Far j). lra.
Qed.

Lemma iterated_more k n : iterated (S k) (S n) <= x * iterated (S k) n /\ iterated k n <= x * iterated (S k) n.
Proof.
  assert (H := iterated_next k n). assert (A := iterated_nonnegative k n). assert (B := iterated_nonnegative (S k) (S n)). lra.
Qed.

Lemma D_large : 1 <= D.
Proof. unfold D. assert (0 <= INR d * 2 ^ d) by (apply Rmult_le_pos; [apply pos_INR|apply pow_le; lra]). lra. Qed.

Lemma q_positive : 0 < q.
Proof. assert (L := D_large). apply Rdiv_lt_0_compat; lra. Qed.

Fixpoint weight (s : list R) : R := match s with [] => 0 | a :: s' => Rabs a + weight s' / q end.

Lemma along_bounded a : forall s k n, (length s <= S k)%nat -> (forall j, (j <= k)%nat -> iterated j n <= a * q ^ j) ->
  Rabs (along x s (iterated k) n) <= a * q ^ k * weight s.
Proof.
  assert (Q := q_positive). induction s as [|b s IH]; intros k n Hl H; cbn [along weight]. rewrite Rabs_R0. lra.
  assert (N := iterated_nonnegative k n). assert (Hk := H k (le_n k)).
  assert (B1 : Rabs (b * iterated k n) <= a * q ^ k * Rabs b).
  { rewrite Rabs_mult, (Rabs_pos_eq (iterated k n)) by auto. rewrite Rmult_comm. apply Rmult_le_compat_r; auto. apply Rabs_pos. }
  eapply Rle_trans. apply Rabs_triang. rewrite Rmult_plus_distr_l. apply Rplus_le_compat; auto.
  rewrite <- along_step. destruct k.
  - destruct s; [|simpl in Hl; lia]. simpl. rewrite Rabs_R0. unfold Rdiv. lra.
  - replace (step x (iterated (S k))) with (fun i => (-1) * iterated k i) by (extensionality i; rewrite iterated_step; ring).
    rewrite along_scal, Rabs_mult, Rabs_left by lra. specialize (IH k n ltac:(simpl in Hl; lia) (fun j Hj => H j ltac:(lia))).
    replace (a * q ^ S k * (weight s / q)) with (a * q ^ k * weight s) by (simpl; field; lra). lra.
Qed.

Lemma weight_bounded b : 1 <= y * q -> forall s e, 0 <= b -> (forall i, y ^ (e + i) * Rabs (nth i s 0) <= b) -> weight s <= INR (length s) * (b / y ^ e).
Proof.
  intros YQ. assert (Q := q_positive). induction s as [|a s IH]; intros e Hb H. simpl. lra.
  cbn [weight length]. rewrite S_INR. assert (YE : 0 < y ^ e) by (apply pow_lt; auto).
  assert (A : Rabs a <= b / y ^ e).
  { assert (H0 := H O). rewrite Nat.add_0_r in H0. simpl nth in H0. apply (Rmult_le_reg_l (y ^ e)); auto.
    replace (y ^ e * (b / y ^ e)) with b by (field; lra). auto. }
  specialize (IH (S e) Hb). assert (S : weight s <= INR (length s) * (b / y ^ S e)).
  { apply IH. intros i. specialize (H (S i)). replace (S e + i)%nat with (e + S i)%nat by lia. auto. }
  assert (T : weight s / q <= INR (length s) * (b / y ^ e)).
  { apply (Rmult_le_reg_r q); auto. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    eapply Rle_trans. apply S. simpl pow. replace (INR (length s) * (b / (y * y ^ e))) with (INR (length s) * (b / y ^ e) * / y) by (field; lra).
    apply Rmult_le_compat_l.
    - apply Rmult_le_pos. apply pos_INR. apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto.
    - apply (Rmult_le_reg_l y); auto. rewrite Rinv_r by lra. auto. }
  lra.
Qed.

Lemma tail_weight : weight t <= c * q.
Proof.
  assert (L := D_large). assert (C := first_positive). assert (B := pshift_bound y p Y0 P0). fold c d in B.
  assert (N := pshift_nonnegative y p (Rlt_le _ _ Y0) P0). rewrite shifted in B, N.
  assert (YQ : y * q = D) by (unfold q; field; lra).
  assert (TL : length t = Nat.pred d). { assert (E := length_pshift y p). rewrite shifted in E. simpl in E. unfold d. lia. }
  assert (W := weight_bounded (2 ^ d * c) ltac:(lra) t 1 ltac:(apply Rmult_le_pos; [apply pow_le|]; lra)).
  eapply Rle_trans. apply W.
  - intros i. assert (NI := N (S i)). simpl nth in NI. rewrite Rabs_pos_eq by auto. specialize (B (S i)). simpl nth in B. exact B.
  - rewrite pow_1. unfold q. apply (Rmult_le_reg_r y); auto.
    replace (INR (length t) * (2 ^ d * c / y) * y) with (c * (INR (length t) * 2 ^ d)) by (field; lra).
    replace (c * (D / y) * y) with (c * D) by (field; lra). apply Rmult_le_compat_l. lra.
    assert (INR (length t) <= INR d) by (apply le_INR; lia). assert (0 < 2 ^ d) by (apply pow_lt; lra).
    assert (INR (length t) * 2 ^ d <= INR d * 2 ^ d) by (apply Rmult_le_compat_r; lra). unfold D. lra.
Qed.

Lemma iterated_bounded : exists a, 0 <= a /\ forall k, iterated k 0 <= a * q ^ k.
Proof.
  assert (Q := q_positive). assert (C := first_positive).
  set (term := fun k => iterated k 0 / q ^ k). set (a := sum (S (length t)) term).
  assert (T0 : forall k, 0 <= term k). { intros k. apply Rmult_le_pos. apply iterated_nonnegative. left. apply Rinv_0_lt_compat, pow_lt; auto. }
  assert (A0 : 0 <= a) by (apply sum_nonneg; auto). exists a. split; auto.
  assert (B : forall k j, (j <= k)%nat -> iterated j 0 <= a * q ^ j).
  { induction k as [k IH] using lt_wf_ind. intros j Hj. destruct (le_lt_dec j (length t)) as [H|H].
    - assert (S : term j <= a) by (apply (sum_term (S (length t)) term); auto; lia). assert (QJ : 0 < q ^ j) by (apply pow_lt; auto).
      unfold term in S. apply (Rmult_le_compat_r (q ^ j)) in S; [|lra]. unfold Rdiv in S. rewrite Rmult_assoc, Rinv_l in S by lra. lra.
    - destruct j. lia. assert (E := along_bounded a t j 0 ltac:(lia)). cbn [iterated]. unfold resolvent.
      apply (Rmult_le_reg_l c); auto. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra.
      eapply Rle_trans. apply Rle_abs. eapply Rle_trans. apply E. { intros i Hi. apply (IH j ltac:(lia)). auto. }
      assert (W := tail_weight). assert (0 <= a * q ^ j) by (apply Rmult_le_pos; auto; apply pow_le; lra).
      replace (c * (a * q ^ S j)) with (a * q ^ j * (c * q)) by (simpl; ring). apply Rmult_le_compat_l; auto. }
  intros k. apply (B k k). auto.
Qed.

Definition total_to (k n : nat) : R := sum k (fun i => h ^ S i * iterated (S i) n).

Lemma total_next k n : total_to k (S n) = (x - h) * total_to k n - h * m n + h * (h ^ k * iterated k n).
Proof.
  unfold total_to. induction k. simpl. ring.
  cbn [sum]. rewrite IHk, iterated_next. simpl pow. ring.
Qed.

(* If the terms grow like `below`, a little less than u + y, they grow like a little less than that. *)
Theorem grows_less : grows m (u + y * (1 - / (2 * D))).
Proof.
  assert (L := D_large). assert (Q := q_positive). assert (X := x_positive). destruct iterated_bounded as [a [A0 A]].
  assert (HP : 0 < h) by (apply Rdiv_lt_0_compat; lra). assert (HQ : h * q = / 2) by (unfold h, q; field; lra).
  assert (XH : x - h = u + y * (1 - / (2 * D))) by (unfold x, h; field; lra).
  assert (Small : / (2 * D) <= / 2) by (apply Rinv_le_contravar; lra).
  assert (X1 : 0 < x - h). { rewrite XH. assert (0 < y * (1 - / (2 * D))) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (Half : forall k, h ^ k * q ^ k = (/ 2) ^ k) by (intros; rewrite <- Rpow_mult_distr, HQ; auto).
  assert (Far : forall k n, h ^ S k * iterated (S k) n <= x ^ n * a * (/ 2) ^ S k).
  { intros k n. assert (iterated (S k) n <= x ^ n * iterated (S k) 0).
    { induction n. rewrite pow_O; lra. eapply Rle_trans. apply (proj1 (iterated_more k n)). change (x ^ S n) with (x * x ^ n).
      rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|exact IHn]. }
    assert (x ^ n * iterated (S k) 0 <= x ^ n * (a * q ^ S k)) by (apply Rmult_le_compat_l; auto; apply pow_le; lra).
    rewrite <- Half. apply (Rle_trans _ (h ^ S k * (x ^ n * (a * q ^ S k)))); [|right; ring].
    apply Rmult_le_compat_l. apply pow_le; lra. eapply Rle_trans; eassumption. }
  assert (Total : forall n, exists E, forall k, total_to (S k) n <= (x - h) ^ n * a + E * (/ 2) ^ k).
  { induction n.
    - exists 0. intros k. simpl pow at 1. rewrite Rmult_1_l, Rmult_0_l, Rplus_0_r. unfold total_to.
      apply Rle_trans with (sum (S k) (fun i => a * (/ 2) ^ S i)).
      { apply sum_le. intros i _. specialize (Far i O). simpl pow in Far at 2. lra. }
      rewrite sum_scal. rewrite <- (Rmult_1_r a) at 2. apply Rmult_le_compat_l; auto.
      assert (G : forall j, sum j (fun i => (/ 2) ^ S i) = 1 - (/ 2) ^ j). { induction j. simpl. lra. cbn [sum]. rewrite IHj. simpl. lra. }
      rewrite G. assert (0 < (/ 2) ^ S k) by (apply pow_lt; lra). lra.
    - destruct IHn as [E HE]. exists ((x - h) * E + h * (x ^ n * a)). intros k. rewrite total_next. specialize (HE k). specialize (Far k n).
      apply (Rmult_le_compat_l (x - h)) in HE; [|lra]. apply (Rmult_le_compat_l h) in Far; [|lra].
      assert (0 <= h * m n) by (apply Rmult_le_pos; auto; lra).
      assert (XN : 0 <= x ^ n * a) by (apply Rmult_le_pos; [apply pow_le; lra|auto]).
      assert (0 <= (/ 2) ^ k) by (apply pow_le; lra). assert (0 <= h * (x ^ n * a * (/ 2) ^ k)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; auto]).
      simpl pow in *. lra. }
  exists (x / h * a). intros n. rewrite Rabs_pos_eq by auto. rewrite <- XH. destruct (Total n) as [E HE].
  assert (Bound : h / x * m n - (x - h) ^ n * a <= 0).
  { apply (vanishing _ E (/ 2)); [lra|]. intros k. specialize (HE k).
    assert (h ^ 1 * iterated 1 n <= total_to (S k) n).
    { apply (sum_term (S k) (fun i => h ^ S i * iterated (S i) n)); [|lia]. intros i _. apply Rmult_le_pos. apply pow_le; lra. apply iterated_nonnegative. }
    assert (I := proj2 (iterated_more 0 n)). change (iterated 0 n) with (m n) in I.
    assert (h / x * m n <= h ^ 1 * iterated 1 n); [|lra].
    rewrite pow_1. apply (Rmult_le_reg_l x); auto. replace (x * (h / x * m n)) with (h * m n) by (field; lra).
    replace (x * (h * iterated 1 n)) with (h * (x * iterated 1 n)) by ring. apply Rmult_le_compat_l. lra. exact I. }
  apply (Rmult_le_reg_l (h / x)). apply Rdiv_lt_0_compat; lra. replace (h / x * (x / h * a * (x - h) ^ n)) with ((x - h) ^ n * a) by (field; lra). lra.
Qed.
End Step.

(* The growth of a sequence without negative terms is at most u if its recurrence, around u, has no negative coefficients. *)
Theorem recurrence_growth u p m : 0 <= u -> nonnegative p -> (exists i, 0 < nth i p 0) -> (forall n, 0 <= m n) ->
  (forall n, along u p m n = 0) -> (exists k, 0 <= k /\ grows m k) -> forall r, u < r -> grows m r.
Proof.
  intros U0 P0 P1 M0 Rec [k [K0 G]] r Hr. set (D := INR (length p) * 2 ^ length p + 1).
  assert (D1 : 1 <= D). { unfold D. assert (0 <= INR (length p) * 2 ^ length p) by (apply Rmult_le_pos; [apply pos_INR|apply pow_le; lra]). lra. }
  set (theta := 1 - / (4 * D)).
  assert (T0 : 0 < / (4 * D)) by (apply Rinv_0_lt_compat; lra). assert (T1 : / (4 * D) <= / 4) by (apply Rinv_le_contravar; lra).
  assert (Th : 0 <= theta < 1) by (unfold theta; lra).
  assert (Some : forall j, grows m (u + (k + 1) * theta ^ j)).
  { induction j.
    - apply (grows_more m k); auto. simpl. lra.
    - set (y' := (k + 1) * theta ^ j) in *. assert (Y' : 0 < y'). { apply Rmult_lt_0_compat. lra. apply pow_lt. unfold theta. lra. }
      set (y := y' * ((4 * D - 1) / (4 * D - 2))).
      assert (F : 1 < (4 * D - 1) / (4 * D - 2)).
      { apply (Rmult_lt_reg_r (4 * D - 2)). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
      assert (Y : y' < y). { unfold y. rewrite <- (Rmult_1_r y') at 1. apply Rmult_lt_compat_l; auto. }
      replace (u + (k + 1) * theta ^ S j) with (u + y * (1 - / (2 * D))).
      + apply (grows_less u y p m U0 ltac:(lra) P0 P1 M0 Rec (u + y')); auto. lra.
      + simpl pow. rewrite (Rmult_comm theta), <- Rmult_assoc. fold y'. unfold y, theta. field. lra. }
  destruct (pow_lt_1_zero theta ltac:(rewrite Rabs_pos_eq; lra) ((r - u) / (k + 1))) as [j Hj]. { apply Rdiv_lt_0_compat; lra. }
  specialize (Hj j (le_n j)). rewrite Rabs_pos_eq in Hj by (apply pow_le; lra). apply (grows_more m (u + (k + 1) * theta ^ j)); auto.
  assert (0 <= (k + 1) * theta ^ j) by (apply Rmult_le_pos; [lra|apply pow_le; lra]). split. lra.
  apply (Rmult_lt_compat_l (k + 1)) in Hj; [|lra]. replace ((k + 1) * ((r - u) / (k + 1))) with (r - u) in Hj by (field; lra). lra.
Qed.
