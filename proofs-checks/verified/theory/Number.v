(* An exact number: the root of the modulus of a zero of a polynomial with integer coefficients. That there is one such
   zero in a disc, and where, is checked with integers. *)
Require Import Reals List ZArith Lia Lra Bool.
From Subcert Require Import Radius Upper Lower Eigenvalue Subdivision Complex.
Import ListNotations.
Open Scope Z_scope.

(* |z|^(1/root), z the zero of the polynomial within disc_radius / disc_scale of (disc_re + i disc_im) / disc_scale *)
Record exact_number := ExactNumber { polynomial : list Z; disc_re : Z; disc_im : Z; disc_radius : Z; disc_scale : Z; root : nat }.

Definition complex_over (x y s : Z) : complex := (IZR x / IZR s, IZR y / IZR s)%R.
Definition is_zero_of (e : exact_number) (z : complex) : Prop :=
  value (polynomial e) z = real_number 0 /\
  (cabs (cminus z (complex_over (disc_re e) (disc_im e) (disc_scale e))) <= IZR (disc_radius e) / IZR (disc_scale e))%R.
Definition is_number (e : exact_number) (r : R) : Prop := (0 < r)%R /\ exists z, is_zero_of e z /\ (r ^ root e = cabs z)%R.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

Definition ztimes (x y : Z * Z) : Z * Z := (fst x * fst y - snd x * snd y, fst x * snd y + snd x * fst y).
Definition zsquare (x : Z * Z) : Z := fst x * fst x + snd x * snd x.

(* At x / s: s^length, and that times the value, and the slope *)
Fixpoint taylor (s : Z) (x : Z * Z) (p : list Z) : Z * ((Z * Z) * (Z * Z)) :=
  match p with
  | [] => (1, ((0, 0), (0, 0)))
  | c :: p' =>
      let '(k, (v, d)) := taylor s x p' in let xv := ztimes x v in let xd := ztimes x d in
      (s * k, ((c * (s * k) + fst xv, snd xv), (s * fst v + fst xd, s * snd v + snd xd)))
  end.

(* s^length, and that times the bounds of values, slopes and changes for moduli up to m / s *)
Fixpoint majorants (s m : Z) (p : list Z) : Z * (Z * (Z * Z)) :=
  match p with
  | [] => (1, (0, (0, 0)))
  | c :: p' =>
      let '(k, (v, (d, w))) := majorants s m p' in
      (s * k, (Z.abs c * (s * k) + m * v, (s * v + m * d, 2 * s * d + m * w)))
  end.

(* Where the zero and the number are: the zero is near_radius / near_scale from (near_re + i near_im) / near_scale in both
   parts, and the number between low / bottom and high / bottom. *)
Record place := Place { near_re : Z; near_im : Z; near_radius : Z; near_scale : Z; low : Z; high : Z; bottom : Z }.

Definition one_zero (e : exact_number) : bool :=
  let s := disc_scale e in let x := (disc_re e, disc_im e) in
  let m := Z.abs (disc_re e) + Z.abs (disc_im e) + disc_radius e in
  let d := snd (snd (taylor s x (polynomial e))) in let w := snd (snd (snd (majorants s m (polynomial e)))) in
  (0 <? s) && (0 <=? disc_radius e) && ((disc_radius e * w) * (disc_radius e * w) <? s * s * zsquare d).

Definition zero_there (p : list Z) (h : place) : bool :=
  let s := near_scale h in let x := (near_re h, near_im h) in
  let m := Z.abs (near_re h) + Z.abs (near_im h) + 2 * near_radius h in
  let '(_, (v, d)) := taylor s x p in let w := snd (snd (snd (majorants s m p))) in
  (0 <? s) && (0 <=? near_radius h) && (0 <? zsquare d) &&
  (4 * (s * s) * zsquare v <=? near_radius h * near_radius h * zsquare d) &&
  ((16 * near_radius h * w) * (16 * near_radius h * w) <=? s * s * zsquare d).

Definition check_number (e : exact_number) (h : place) : bool :=
  let s := disc_scale e in let n := near_scale h in let k := Z.of_nat (root e) in
  let dx := near_re h * s - disc_re e * n in let dy := near_im h * s - disc_im e * n in
  let slack := disc_radius e * n - 2 * near_radius h * s in
  let c := bottom h ^ k in let size := c * c * zsquare (near_re h, near_im h) in
  let lower := low h ^ k * n + 2 * near_radius h * c in let upper := high h ^ k * n - 2 * near_radius h * c in
  one_zero e && zero_there (polynomial e) h && (0 <? k) && (0 <? low h) && (0 <? high h) && (0 <? bottom h) &&
  (0 <=? slack) && (dx * dx + dy * dy <=? slack * slack) &&
  (lower * lower <=? size) && (0 <=? upper) && (size <=? upper * upper).

(* ---- what it says ------------------------------------------------------------------------------------------------ *)

Definition cz (x : Z * Z) : complex := (IZR (fst x), IZR (snd x)).

Lemma cz_times x y : cz (ztimes x y) = ctimes (cz x) (cz y).
Proof. unfold cz, ztimes, ctimes; simpl. rewrite minus_IZR, plus_IZR, !mult_IZR. reflexivity. Qed.

Lemma cabs_cz x : (cabs (cz x) * cabs (cz x) = IZR (zsquare x))%R.
Proof. rewrite cabs_square. unfold zsquare, cz; simpl. rewrite plus_IZR, !mult_IZR. reflexivity. Qed.

Section Place.
Variable s : Z.
Hypothesis Scale : 0 < s.

Lemma scale_positive : (0 < IZR s)%R.
Proof. apply IZR_lt; auto. Qed.

Lemma over_scaled x : ctimes (real_number (IZR s)) (complex_over (fst x) (snd x) s) = cz x.
Proof. assert (P := scale_positive). unfold ctimes, real_number, complex_over, cz; simpl. f_equal; field; lra. Qed.

Lemma taylor_sound x p : let c := complex_over (fst x) (snd x) s in let '(k, (v, d)) := taylor s x p in
  (0 < IZR k)%R /\ IZR k = (IZR s ^ length p)%R /\ cz v = ctimes (real_number (IZR k)) (value p c) /\
  cz d = ctimes (real_number (IZR k)) (slope p c c).
Proof.
  intros c. assert (P := scale_positive). assert (X : ctimes (real_number (IZR s)) c = cz x) by apply over_scaled. induction p as [|a p IH]; cbn [taylor value slope].
  - repeat split; try (simpl; lra). all: unfold cz, ctimes, real_number; simpl; f_equal; ring.
  - destruct (taylor s x p) as [k [v d]]. destruct IH as [K [E [V D]]].
    assert (K' : real_number (IZR (s * k)) = ctimes (real_number (IZR s)) (real_number (IZR k))).
    { unfold ctimes, real_number; simpl. rewrite mult_IZR. f_equal; ring. }
    split. rewrite mult_IZR. apply Rmult_lt_0_compat; auto. split. rewrite mult_IZR, E. reflexivity.
    rewrite K'. split.
    + transitivity (cplus (ctimes (real_number (IZR a)) (real_number (IZR (s * k)))) (cz (ztimes x v))).
      { unfold cz, cplus, ctimes, real_number; simpl. rewrite plus_IZR, mult_IZR. f_equal; ring. }
      rewrite cz_times, V, <- X, K'. ring.
    + transitivity (cplus (ctimes (real_number (IZR s)) (cz v)) (cz (ztimes x d))).
      { unfold cz, cplus, ctimes, real_number; simpl. rewrite !plus_IZR, !mult_IZR. f_equal; ring. }
      rewrite cz_times, V, D, <- X. ring.
Qed.

Lemma majorants_sound m p : let '(k, (v, (d, w))) := majorants s m p in let r := (IZR m / IZR s)%R in
  IZR k = (IZR s ^ length p)%R /\ IZR v = (IZR k * value_bound p r)%R /\ IZR d = (IZR k * slope_bound p r)%R /\ IZR w = (IZR k * change_bound p r)%R.
Proof.
  assert (P := scale_positive). induction p as [|a p IH]; cbn [majorants value_bound slope_bound change_bound length pow].
  - repeat split; lra.
  - destruct (majorants s m p) as [k [v [d w]]]. cbv zeta in *. destruct IH as [K [V [D W]]].
    repeat rewrite ?plus_IZR, ?mult_IZR. rewrite abs_IZR, V, D, W, K. repeat split; field; lra.
Qed.

Lemma taylor_abs x p k v d : taylor s x p = (k, (v, d)) -> (0 < IZR k)%R /\ IZR k = (IZR s ^ length p)%R /\
  (IZR (zsquare v) = (IZR k * cabs (value p (complex_over (fst x) (snd x) s))) ^ 2)%R /\
  (IZR (zsquare d) = (IZR k * cabs (slope p (complex_over (fst x) (snd x) s) (complex_over (fst x) (snd x) s))) ^ 2)%R.
Proof.
  intros E. assert (T := taylor_sound x p). cbv zeta in T. rewrite E in T. destruct T as [K [KL [V D]]].
  split; auto. split; auto. rewrite <- !cabs_cz, V, D, !cabs_times, !cabs_real, Rabs_pos_eq by lra. split; ring.
Qed.
End Place.

Lemma square_le x y : (0 <= x -> 0 <= y -> x * x <= y * y -> x <= y)%R.
Proof. intros X Y H. apply Rsqr_incr_0; auto. Qed.
Lemma square_lt x y : (0 <= y -> x * x < y * y -> x < y)%R.
Proof. intros Y H. apply Rsqr_incrst_0_var_ || idtac. apply Rnot_le_lt. intros N. assert (y * y <= x * x)%R by (apply Rmult_le_compat; lra). lra. Qed.

Lemma over_abs x y s : 0 < s -> (cabs (complex_over x y s) <= (IZR (Z.abs x) + IZR (Z.abs y)) / IZR s)%R.
Proof.
  intros Hs. assert (P : (0 < IZR s)%R) by (apply IZR_lt; auto). assert (I : (0 < / IZR s)%R) by (apply Rinv_0_lt_compat; auto).
  eapply Rle_trans. apply cabs_sum. unfold complex_over; simpl. unfold Rdiv. rewrite !Rabs_mult, !(Rabs_pos_eq (/ IZR s)), <- !abs_IZR by lra. lra.
Qed.

Lemma one_zero_sound e x y : one_zero e = true -> is_zero_of e x -> is_zero_of e y -> x = y.
Proof.
  intros H [Zx Ex] [Zy Ey]. unfold one_zero in H. set (s := disc_scale e) in *. cbv zeta in H.
  destruct (taylor s (disc_re e, disc_im e) (polynomial e)) as [k [v d]] eqn:ET. assert (M := majorants_sound s).
  set (m := Z.abs (disc_re e) + Z.abs (disc_im e) + disc_radius e) in *.
  repeat rewrite andb_true_iff in H. destruct H as [[Hs Hr] H]. apply Z.ltb_lt in Hs, H. apply Z.leb_le in Hr.
  specialize (M Hs m (polynomial e)). destruct (majorants s m (polynomial e)) as [k' [v' [d' w]]]. cbv zeta in M. cbn [snd fst] in *.
  destruct M as [K' [_ [_ W]]]. destruct (taylor_abs s Hs _ _ _ _ _ ET) as [K [KL [_ D]]]. cbn [fst snd] in D.
  assert (P : (0 < IZR s)%R) by (apply IZR_lt; auto).
  apply (zero_unique (polynomial e) (complex_over (disc_re e) (disc_im e) s) (IZR (disc_radius e) / IZR s) (IZR m / IZR s)); auto.
  - assert (A := over_abs (disc_re e) (disc_im e) s Hs). unfold m. rewrite !plus_IZR. unfold Rdiv in *. lra.
  - apply IZR_lt in H, Hr || (apply IZR_lt in H; apply IZR_le in Hr). rewrite !mult_IZR, W, K', <- KL, D in H.
    set (c := change_bound _ _) in *. set (a := cabs (slope _ _ _)) in *. assert (A0 : (0 <= a)%R) by apply cabs_nonneg.
    apply square_lt; auto. apply (Rmult_lt_reg_l (IZR s * IZR s * (IZR k * IZR k))). repeat apply Rmult_lt_0_compat; auto.
    replace (IZR s * IZR s * (IZR k * IZR k) * (IZR (disc_radius e) / IZR s * c * (IZR (disc_radius e) / IZR s * c)))%R
      with (IZR (disc_radius e) * (IZR k * c) * (IZR (disc_radius e) * (IZR k * c)))%R by (field; lra).
    eapply Rlt_le_trans. apply H. right. ring.
Qed.

Lemma inverse_exists x : (0 < cabs x)%R -> exists y, ctimes y x = real_number 1 /\ (cabs y = / cabs x)%R.
Proof.
  intros H. assert (S := cabs_square x). assert (N : (0 < cabs x * cabs x)%R) by (apply Rmult_lt_0_compat; auto). rewrite S in N.
  set (n := (fst x * fst x + snd x * snd x)%R) in *. exists (fst x / n, - snd x / n)%R.
  assert (E : ctimes (fst x / n, - snd x / n)%R x = real_number 1).
  { unfold ctimes, real_number; simpl. f_equal; unfold n in *; field; lra. }
  split; auto. apply (f_equal cabs) in E. rewrite cabs_times, cabs_real, Rabs_R1 in E.
  apply (Rmult_eq_reg_r (cabs x)); [|lra]. rewrite E. field. lra.
Qed.

Lemma zero_there_sound p h : zero_there p h = true ->
  let s := IZR (near_scale h) in let rho := (IZR (near_radius h) / s)%R in
  (0 < s)%R /\ (0 <= rho)%R /\ exists z, value p z = real_number 0 /\
  (Rabs (fst z - IZR (near_re h) / s) <= rho)%R /\ (Rabs (snd z - IZR (near_im h) / s) <= rho)%R.
Proof.
  intros H s' rho. unfold zero_there in H. set (s := near_scale h) in *. cbv zeta in H.
  destruct (taylor s (near_re h, near_im h) p) as [k [v d]] eqn:ET. assert (M := majorants_sound s).
  set (m := Z.abs (near_re h) + Z.abs (near_im h) + 2 * near_radius h) in *.
  repeat rewrite andb_true_iff in H. destruct H as [[[[Hs Hr] H0] H1] H2]. apply Z.ltb_lt in Hs, H0. apply Z.leb_le in Hr, H1, H2.
  specialize (M Hs m p). destruct (majorants s m p) as [k' [v' [d' w]]]. cbv zeta in M. cbn [snd fst] in *.
  destruct M as [K' [_ [_ W]]]. destruct (taylor_abs s Hs _ _ _ _ _ ET) as [K [KL [V D]]]. cbn [fst snd] in V, D.
  assert (P : (0 < IZR s)%R) by (apply IZR_lt; auto). split; auto.
  assert (Rho : (0 <= rho)%R).
  { apply Rmult_le_pos. apply IZR_le; auto. left. apply Rinv_0_lt_compat; auto. }
  split; auto. set (c := complex_over (near_re h) (near_im h) s) in *.
  apply IZR_le in Hr, H1, H2. apply IZR_lt in H0. rewrite !mult_IZR in H1, H2. rewrite W, K', <- KL in H2. rewrite V, D in H1. rewrite D in H0, H2.
  set (a := cabs (slope p c c)) in *. assert (A0 : (0 <= a)%R) by apply cabs_nonneg.
  set (b := cabs (value p c)) in *. assert (B0 : (0 <= b)%R) by apply cabs_nonneg.
  set (cb := change_bound _ _) in *.
  assert (A : (0 < a)%R). { destruct A0 as [A|A]; auto. rewrite <- A in H0. exfalso. simpl in H0. lra. }
  assert (C0 : (0 <= cb)%R).
  { apply bounds_nonneg. apply Rmult_le_pos. apply IZR_le. unfold m. apply le_IZR in Hr. lia. left. apply Rinv_0_lt_compat; auto. }
  destruct (inverse_exists (slope p c c) A) as [alpha [Ea Na]].
  assert (F1 : (2 * b <= rho * a)%R).
  { apply square_le. lra. apply Rmult_le_pos; lra. apply (Rmult_le_reg_l (IZR s * IZR s * (IZR k * IZR k))). repeat apply Rmult_lt_0_compat; auto.
    replace (IZR s * IZR s * (IZR k * IZR k) * (rho * a * (rho * a)))%R with (IZR (near_radius h) * IZR (near_radius h) * (IZR k * a) ^ 2)%R
      by (unfold rho, s'; fold s; field; lra).
    eapply Rle_trans; [|apply H1]. right. ring. }
  assert (F2 : (16 * rho * cb <= a)%R).
  { apply square_le; auto. apply Rmult_le_pos; [apply Rmult_le_pos|]; lra. apply (Rmult_le_reg_l (IZR s * IZR s * (IZR k * IZR k))). repeat apply Rmult_lt_0_compat; auto.
    replace (IZR s * IZR s * (IZR k * IZR k) * (16 * rho * cb * (16 * rho * cb)))%R
      with (16 * IZR (near_radius h) * (IZR k * cb) * (16 * IZR (near_radius h) * (IZR k * cb)))%R by (unfold rho, s'; fold s; field; lra).
    eapply Rle_trans; [apply H2|]. right. ring. }
  destruct (zero_near p c rho (IZR m / IZR s) alpha Rho) as [z [Zz [Z1 Z2]]].
  - assert (O := over_abs (near_re h) (near_im h) s Hs). fold c in O. unfold m. rewrite !plus_IZR, mult_IZR. unfold rho, s', Rdiv in *. fold s. lra.
  - exact Ea.
  - rewrite Na. fold a b. apply (Rmult_le_reg_l a); auto. replace (a * (2 * (/ a * b)))%R with (2 * b)%R by (field; lra). lra.
  - rewrite Na. fold a cb. apply (Rmult_le_reg_l a); auto. replace (a * (16 * / a * rho * cb))%R with (16 * rho * cb)%R by (field; lra). lra.
  - exists z. auto.
Qed.

Lemma root_exists x k : (0 < x)%R -> (0 < k)%nat -> exists r, (0 < r)%R /\ (r ^ k = x)%R.
Proof.
  intros Hx Hk. destruct (exp_onto x Hx) as [t Ht]. exists (exp (t / INR k)). split. apply exp_pos.
  rewrite exp_power. rewrite <- Ht. f_equal. field. apply not_0_INR. lia.
Qed.

Theorem check_number_sound e h : check_number e h = true ->
  let s := IZR (near_scale h) in let rho := (IZR (near_radius h) / s)%R in
  (0 < s)%R /\ (0 <= rho)%R /\ (0 < root e)%nat /\ 0 < low h /\ 0 < bottom h /\ exists z r, is_zero_of e z /\ (forall y, is_zero_of e y -> y = z) /\
  (Rabs (fst z - IZR (near_re h) / s) <= rho)%R /\ (Rabs (snd z - IZR (near_im h) / s) <= rho)%R /\
  (0 < r)%R /\ (r ^ root e = cabs z)%R /\ (IZR (low h) / IZR (bottom h) <= r <= IZR (high h) / IZR (bottom h))%R.
Proof.
  intros H s rho. unfold check_number in H. cbv zeta in H. repeat rewrite andb_true_iff in H.
  destruct H as [[[[[[[[[[H1 H2] Hk] Hl] Hh] Hc] Hs0] Hs] HL] HU0] HU].
  apply Z.ltb_lt in Hk, Hl, Hh, Hc. apply Z.leb_le in Hs0, Hs, HL, HU0, HU.
  destruct (zero_there_sound _ _ H2) as [S [Rho [z [Zz [Z1 Z2]]]]]. fold s in S, Rho, Z1, Z2. fold rho in Rho, Z1, Z2.
  split; auto. split; auto. split. lia. split; auto. split; auto.
  set (c := complex_over (near_re h) (near_im h) (near_scale h)) in *.
  assert (Dz : (cabs (cminus z c) <= 2 * rho)%R).
  { eapply Rle_trans. apply cabs_sum. unfold cminus, c, complex_over; simpl. fold s. lra. }
  assert (SE : 0 < disc_scale e). { unfold one_zero in H1. cbv zeta in H1. repeat rewrite andb_true_iff in H1. destruct H1 as [[A _] _]. apply Z.ltb_lt in A. auto. }
  assert (SP : (0 < IZR (disc_scale e))%R) by (apply IZR_lt; auto).
  assert (Cc : cabs c = (cabs (cz (near_re h, near_im h)) / s)%R).
  { rewrite <- (over_scaled (near_scale h)) by (apply lt_IZR; auto). rewrite cabs_times, cabs_real, Rabs_pos_eq by (fold s; lra). cbn [fst snd]. fold c s. field. lra. }
  assert (Inz : is_zero_of e z).
  { split; auto. set (c' := complex_over (disc_re e) (disc_im e) (disc_scale e)).
    replace (cminus z c') with (cplus (cminus z c) (cminus c c')) by ring. eapply Rle_trans. apply cabs_plus.
    assert (D : (cabs (cminus c c') <= IZR (disc_radius e) / IZR (disc_scale e) - 2 * rho)%R); [|lra].
    set (dx := near_re h * disc_scale e - disc_re e * near_scale h) in *. set (dy := near_im h * disc_scale e - disc_im e * near_scale h) in *.
    set (k := (s * IZR (disc_scale e))%R). assert (K : (0 < k)%R) by (apply Rmult_lt_0_compat; auto).
    assert (E : ctimes (real_number k) (cminus c c') = cz (dx, dy)).
    { unfold ctimes, real_number, cminus, c, c', complex_over, cz, dx, dy, k; simpl. rewrite !minus_IZR, !mult_IZR. fold s. f_equal; field; lra. }
    apply (f_equal cabs) in E. rewrite cabs_times, cabs_real, Rabs_pos_eq in E by lra.
    set (slack := disc_radius e * near_scale h - 2 * near_radius h * disc_scale e) in *.
    apply (Rmult_le_reg_l k); auto. rewrite E.
    replace (k * (IZR (disc_radius e) / IZR (disc_scale e) - 2 * rho))%R with (IZR slack).
    - apply square_le. apply cabs_nonneg. apply IZR_le; auto. rewrite cabs_cz, <- mult_IZR. apply IZR_le. exact Hs.
    - unfold slack, rho, k. rewrite minus_IZR, !mult_IZR. fold s. field. lra. }
  set (L := root e) in *. set (cL := bottom h ^ Z.of_nat L) in *.
  assert (CP : (0 < IZR (bottom h))%R) by (apply IZR_lt; auto).
  assert (CL : IZR cL = (IZR (bottom h) ^ L)%R) by (unfold cL; rewrite <- pow_IZR; auto).
  assert (CLP : (0 < IZR cL)%R) by (rewrite CL; apply pow_lt; auto).
  set (N := cabs (cz (near_re h, near_im h))) in *. assert (N0 : (0 <= N)%R) by apply cabs_nonneg.
  assert (SZ : (IZR (cL * cL * zsquare (near_re h, near_im h)) = (IZR cL * N) * (IZR cL * N))%R).
  { rewrite !mult_IZR, <- cabs_cz. fold N. ring. }
  apply IZR_le in HL, HU0, HU. rewrite SZ in HL, HU. rewrite mult_IZR in HL, HU.
  assert (CN : (0 <= IZR cL * N)%R) by (apply Rmult_le_pos; lra).
  assert (NR : (0 <= IZR (near_radius h))%R).
  { replace (IZR (near_radius h)) with (rho * s)%R by (unfold rho; field; lra). apply Rmult_le_pos; lra. }
  assert (LP : (0 < IZR (low h) ^ L)%R) by (apply pow_lt, IZR_lt; auto).
  apply square_le in HL; auto. 2:{ rewrite plus_IZR, !mult_IZR, <- pow_IZR. fold s. assert (0 < IZR (low h) ^ L * s)%R by (apply Rmult_lt_0_compat; auto).
    assert (0 <= 2 * IZR (near_radius h) * IZR cL)%R by (repeat apply Rmult_le_pos; lra). lra. }
  apply square_le in HU; auto.
  rewrite plus_IZR, !mult_IZR, <- pow_IZR in HL. rewrite minus_IZR, !mult_IZR, <- pow_IZR in HU. fold s in HL, HU.
  assert (ZL : ((IZR (low h) / IZR (bottom h)) ^ L <= cabs z)%R).
  { assert (T := cabs_plus z (cminus c z)). replace (cplus z (cminus c z)) with c in T by ring.
    replace (cabs (cminus c z)) with (cabs (cminus z c)) in T by (unfold cabs, cminus, modulus; simpl; f_equal; ring). rewrite Cc in T. fold N in T.
    assert (D : (IZR (low h) ^ L / IZR cL + 2 * rho <= N / s)%R).
    { apply (Rmult_le_reg_r (IZR cL * s)). apply Rmult_lt_0_compat; auto.
      replace ((IZR (low h) ^ L / IZR cL + 2 * rho) * (IZR cL * s))%R with (IZR (low h) ^ L * s + 2 * IZR (near_radius h) * IZR cL)%R by (unfold rho; field; lra).
      replace (N / s * (IZR cL * s))%R with (IZR cL * N)%R by (field; lra). auto. }
    unfold Rdiv at 1. rewrite Rpow_mult_distr, pow_inv, <- CL by lra. unfold Rdiv in D. fold N in Dz. lra. }
  assert (ZU : (cabs z <= (IZR (high h) / IZR (bottom h)) ^ L)%R).
  { assert (T := cabs_plus c (cminus z c)). replace (cplus c (cminus z c)) with z in T by ring. rewrite Cc in T. fold N in T.
    assert (D : (N / s <= IZR (high h) ^ L / IZR cL - 2 * rho)%R).
    { apply (Rmult_le_reg_r (IZR cL * s)). apply Rmult_lt_0_compat; auto.
      replace ((IZR (high h) ^ L / IZR cL - 2 * rho) * (IZR cL * s))%R with (IZR (high h) ^ L * s - 2 * IZR (near_radius h) * IZR cL)%R by (unfold rho; field; lra).
      replace (N / s * (IZR cL * s))%R with (IZR cL * N)%R by (field; lra). auto. }
    unfold Rdiv at 1. rewrite Rpow_mult_distr, pow_inv, <- CL by lra. unfold Rdiv in D. lra. }
  assert (Low : (0 < IZR (low h) / IZR (bottom h))%R) by (apply Rdiv_lt_0_compat; auto; apply IZR_lt; auto).
  assert (HighP : (0 < IZR (high h) / IZR (bottom h))%R) by (apply Rdiv_lt_0_compat; auto; apply IZR_lt; auto).
  assert (Zp : (0 < cabs z)%R) by (eapply Rlt_le_trans; [|apply ZL]; apply pow_lt; auto).
  assert (HkN : (0 < L)%nat) by lia.
  destruct (root_exists (cabs z) L Zp HkN) as [r [Hr Er]]. exists z, r. split; auto. split. { intros y Hy. eapply one_zero_sound; eauto. }
  split; auto. split; auto. split; auto. split; auto. rewrite <- Er in ZL, ZU. split; apply (pow_le_reg _ _ L); lra || auto.
Qed.
