(* Lower bounds of the joint spectral radius: a product has an eigenvalue near a given number, as Newton's iteration
   from a given approximate eigenvector contracts. *)
Require Import Reals List Lia Lra.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Blocks.
Import ListNotations.
Open Scope R_scope.

(* ---- a zero of a map that is nearly linear --------------------------------------------------------------------- *)

Definition near (n : nat) (x y : vec) (d : R) : Prop := forall i, (i < n)%nat -> Rabs (x i - y i) <= d.

Lemma abs_le x d : Rabs x <= d <-> - d <= x <= d.
Proof. split; intros H. split; unfold Rabs in H; destruct (Rcase_abs x); lra. apply Rabs_le; auto. Qed.

Definition sub (x y : vec) : vec := fun i => x i - y i.

Lemma apply_sub n A x y : apply n A (sub x y) = sub (apply n A x) (apply n A y).
Proof.
  replace (sub x y) with (plus x (scal (-1) y)) by (extensionality i; unfold sub, plus, scal; lra).
  rewrite apply_plus, apply_scal. extensionality i; unfold sub, plus, scal; lra.
Qed.

Section Newton.
Variables (n : nat) (J A : mat) (f : vec) (q : vec -> vec) (rho e1 e2 e3 l eta : R).
Hypothesis Rho : 0 <= rho.
Hypothesis E1 : forall d x, near n x zero d -> near n x (apply n A (apply n J x)) (e1 * d).
Hypothesis E2 : forall d x, near n x zero d -> near n x (apply n J (apply n A x)) (e2 * d).
Hypothesis E3 : forall d x, near n x zero d -> near n (apply n A x) zero (e3 * d).
Hypothesis Q0 : forall i, (i < n)%nat -> q zero i = 0.
Hypothesis Q : forall x y d, near n x zero rho -> near n y zero rho -> near n x y d -> near n (q x) (q y) (l * d).
Hypothesis Eta : near n (apply n A f) zero eta.
Hypothesis Contracts : 0 <= e1 + e3 * l < 1.
Hypothesis Ball : eta + (e1 + e3 * l) * rho <= rho.
Hypothesis Regular : e2 < 1.

Let kappa := e1 + e3 * l.
Definition value (x : vec) : vec := plus (plus f (apply n J x)) (q x).
Definition next (x : vec) : vec := sub x (apply n A (value x)).

Lemma next_is x i : next x i = x i - (apply n A f i + apply n A (apply n J x) i + apply n A (q x) i).
Proof. unfold next, value, sub. rewrite !apply_plus. reflexivity. Qed.

Lemma next_contracts x y d : near n x zero rho -> near n y zero rho -> near n x y d -> near n (next x) (next y) (kappa * d).
Proof.
  intros Hx Hy Hd i Hi.
  assert (D1 : near n (sub x y) zero d).
  { intros j Hj. specialize (Hd j Hj). unfold sub, zero. rewrite Rminus_0_r. auto. }
  apply E1 in D1. specialize (D1 i Hi). rewrite !apply_sub in D1.
  assert (D2 : near n (sub (q x) (q y)) zero (l * d)).
  { intros j Hj. assert (D := Q x y d Hx Hy Hd j Hj). unfold sub, zero. rewrite Rminus_0_r. auto. }
  apply E3 in D2. specialize (D2 i Hi). rewrite apply_sub in D2.
  rewrite !next_is. unfold sub, zero, kappa in *. rewrite abs_le in *. lra.
Qed.

Lemma next_ball x : near n x zero rho -> near n (next x) zero rho.
Proof.
  intros Hx i Hi. assert (D1 := E1 _ _ Hx i Hi).
  assert (D2 : near n (q x) zero (l * rho)).
  { intros j Hj. change (zero j) with 0. rewrite <- (Q0 j Hj). apply Q; auto. intros k Hk. unfold zero.
    rewrite Rminus_0_r, Rabs_R0. auto. }
  apply E3 in D2. specialize (D2 i Hi). assert (D3 := Eta i Hi).
  rewrite next_is. unfold zero in *. rewrite abs_le in *. lra.
Qed.

Fixpoint iterate (k : nat) : vec := match k with O => zero | S j => next (iterate j) end.

Lemma iterate_ball k : near n (iterate k) zero rho.
Proof. induction k; simpl. intros i Hi. unfold zero. rewrite Rminus_0_r, Rabs_R0; auto. apply next_ball; auto. Qed.

Lemma iterate_far k p : near n (iterate (k + p)) (iterate k) (kappa ^ k * rho).
Proof.
  induction k; simpl. rewrite Rmult_1_l. apply iterate_ball.
  rewrite Rmult_assoc. apply next_contracts; auto; apply iterate_ball.
Qed.

Lemma kappa_small eps : 0 < eps -> exists k, kappa ^ k * rho < eps.
Proof.
  intros He. destruct (pow_lt_1_zero kappa) with (y := eps / (rho + 1)) as [k Hk].
  - rewrite Rabs_pos_eq; unfold kappa; lra.
  - apply Rdiv_lt_0_compat; lra.
  - exists k. specialize (Hk k (le_n k)). assert (P : 0 <= kappa ^ k) by (apply pow_le; unfold kappa; lra).
    rewrite Rabs_pos_eq in Hk by auto. apply (Rmult_lt_compat_r (rho + 1)) in Hk; [|lra].
    unfold Rdiv in Hk. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in Hk by lra. lra.
Qed.

Lemma iterate_cauchy i : (i < n)%nat -> Cauchy_crit (fun k => iterate k i).
Proof.
  intros Hi eps He. destruct (kappa_small (eps / 2)) as [k Hk]; [lra|].
  exists k. intros a b Ha Hb. unfold R_dist.
  assert (Da := iterate_far k (a - k) i Hi). assert (Db := iterate_far k (b - k) i Hi).
  replace (k + (a - k))%nat with a in Da by lia. replace (k + (b - k))%nat with b in Db by lia.
  rewrite abs_le in *. unfold Rabs. destruct (Rcase_abs (iterate a i - iterate b i)); lra.
Qed.

Definition fixpoint : vec := fun i =>
  match lt_dec i n with left H => proj1_sig (R_complete _ (iterate_cauchy i H)) | right _ => 0 end.

Lemma fixpoint_limit k : near n fixpoint (iterate k) (kappa ^ k * rho).
Proof.
  intros i Hi. unfold fixpoint. destruct (lt_dec i n) as [H|]; [|lia].
  destruct (R_complete _ (iterate_cauchy i H)) as [x Hx]. simpl.
  apply le_epsilon. intros eps He. destruct (Hx eps He) as [m Hm].
  specialize (Hm (k + m)%nat ltac:(lia)). unfold R_dist in Hm.
  assert (D := iterate_far k m i Hi). rewrite abs_le in *. apply Rabs_def2 in Hm. lra.
Qed.

Theorem zero_exists : exists x, near n x zero rho /\ forall i, (i < n)%nat -> f i + apply n J x i + q x i = 0.
Proof.
  assert (Hball : near n fixpoint zero rho).
  { assert (D := fixpoint_limit 0). simpl in D. rewrite Rmult_1_l in D. auto. }
  exists fixpoint. split; auto.
  assert (Hfix : forall i, (i < n)%nat -> next fixpoint i = fixpoint i).
  { intros i Hi. apply Rminus_diag_uniq.
    destruct (Req_dec (next fixpoint i - fixpoint i) 0) as [|N]; auto. exfalso.
    assert (P : 0 < Rabs (next fixpoint i - fixpoint i)) by (apply Rabs_pos_lt; auto).
    destruct (kappa_small (Rabs (next fixpoint i - fixpoint i) / 2)) as [k Hk]; [lra|].
    assert (D1 := fixpoint_limit (S k) i Hi).
    assert (D2 := next_contracts _ _ _ Hball (iterate_ball k) (fixpoint_limit k) i Hi).
    simpl in D1. set (z := kappa ^ k * rho) in *.
    assert (Hz : 0 <= z) by (unfold z; apply Rmult_le_pos; auto; apply pow_le; unfold kappa; lra).
    assert (kappa * z <= z). { rewrite <- (Rmult_1_l z) at 2. apply Rmult_le_compat_r; auto. unfold kappa; lra. }
    replace (kappa * kappa ^ k * rho) with (kappa * z) in D1 by (unfold z; ring).
    assert (Rabs (next fixpoint i - fixpoint i) <= 2 * z).
    { rewrite abs_le in *. lra. }
    lra. }
  assert (HA : forall i, (i < n)%nat -> apply n A (value fixpoint) i = 0).
  { intros i Hi. assert (D := Hfix i Hi). unfold next, sub in D. lra. }
  destruct (largest (fun i => Rabs (value fixpoint i)) n) as [b [Hb [B1 B2]]].
  assert (D : near n (value fixpoint) zero b).
  { intros i Hi. unfold zero. rewrite Rminus_0_r. auto. }
  apply E2 in D.
  assert (Z : b = 0).
  { destruct B2 as [|[k [Hk E]]]; auto.
    specialize (D k Hk). rewrite (apply_ext n J _ zero), apply_zero in D by (apply HA).
    unfold zero in D. rewrite Rminus_0_r in D. rewrite E in D. destruct (Req_dec b 0); auto. nra. }
  intros i Hi. specialize (B1 i Hi). rewrite Z in B1. unfold value, plus in B1.
  assert (P := Rabs_pos (f i + apply n J fixpoint i + q fixpoint i)).
  destruct (Req_dec (f i + apply n J fixpoint i + q fixpoint i) 0) as [|N]; auto.
  apply Rabs_pos_lt in N. lra.
Qed.
End Newton.

(* ---- eigenvalues bound the radius ------------------------------------------------------------------------------ *)

Theorem eigenvalue_at_least n count T w r x y a b k : 0 <= r -> growth n count T r -> letters count w ->
  (forall i, (i < n)%nat -> run n T w x i = a * x i - b * y i) ->
  (forall i, (i < n)%nat -> run n T w y i = a * y i + b * x i) ->
  (k < n)%nat -> x k <> 0 \/ y k <> 0 -> modulus a b <= r ^ length w.
Proof.
  intros Hr G Hw Hx Hy Hk Hk0.
  destruct (norm_growth n count T r Hr G) as [C [HC H]].
  set (word := fix word m := match m with O => [] | S j => word j ++ w end).
  assert (Hword : forall m, letters count (word m)).
  { induction m; simpl. constructor. apply letters_app; auto. }
  assert (Hlen : forall m, r ^ length (word m) = (r ^ length w) ^ m).
  { induction m; simpl. reflexivity. rewrite app_length, pow_add, IHm. ring. }
  assert (E : forall m, cnorm n (run n T (word m) x) (run n T (word m) y) = modulus a b ^ m * cnorm n x y).
  { induction m. simpl. lra.
    assert (Ex : forall i, (i < n)%nat -> run n T (word (S m)) x i = a * run n T (word m) x i - b * run n T (word m) y i).
    { intros i Hi. simpl word. rewrite run_app, (run_ext n T (word m) _ (plus (scal a x) (scal (- b) y))); auto.
      rewrite run_plus, !run_scal. unfold plus, scal. ring. intros j Hj. rewrite Hx by auto. unfold plus, scal; ring. }
    assert (Ey : forall i, (i < n)%nat -> run n T (word (S m)) y i = a * run n T (word m) y i + b * run n T (word m) x i).
    { intros i Hi. simpl word. rewrite run_app, (run_ext n T (word m) _ (plus (scal a y) (scal b x))); auto.
      rewrite run_plus, !run_scal. unfold plus, scal. ring. }
    simpl pow. rewrite Rmult_assoc, <- IHm. unfold cnorm. rewrite <- sum_scal. apply sum_ext; intros i Hi.
    rewrite Ex, Ey, modulus_mult by auto. reflexivity. }
  assert (P : 0 < cnorm n x y).
  { assert (D := sum_term n (fun i => modulus (x i) (y i)) k ltac:(intros; apply modulus_nonneg) Hk). simpl in D.
    assert (0 < modulus (x k) (y k)). { apply sqrt_lt_R0. destruct Hk0; nra. }
    unfold cnorm. lra. }
  assert (Sum : forall u v, cnorm n u v <= norm n u + norm n v).
  { intros u v. unfold cnorm, norm. rewrite <- sum_plus. apply sum_le; intros.
    assert (D := modulus_triangle (u i) 0 0 (v i)). rewrite Rplus_0_r, Rplus_0_l, modulus_real, modulus_imaginary in D. auto. }
  apply (power_bound (C * (norm n x + norm n y) / cnorm n x y)).
  - apply pow_le; auto.
  - apply modulus_nonneg.
  - intros m. apply (Rmult_le_reg_r (cnorm n x y)); auto. rewrite <- E.
    replace (C * (norm n x + norm n y) / cnorm n x y * (r ^ length w) ^ m * cnorm n x y)
      with (C * (r ^ length w) ^ m * norm n x + C * (r ^ length w) ^ m * norm n y) by (field; lra).
    eapply Rle_trans. apply Sum. rewrite <- Hlen. apply Rplus_le_compat; apply H; auto.
Qed.
