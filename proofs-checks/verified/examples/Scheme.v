(* The joint spectral radius of the difference matrices of primal:n=5, the primal least squares scheme of ten points and
   degree 1, and the Hoelder exponent of its limit, in the kernel of Coq alone: no extraction, no OCaml, no parser. *)
Require Import Reals List ZArith QArith Lra Lia.
From Subcert Require Import Radius Existence Integers Sections Check Subdivision Coefficients Stability Exponent Enclosure
  Complex Number Exact S5 Shifts S5Exact.
Import ListNotations.
Open Scope Z_scope.

Definition S5_scheme : scheme := Scheme 2 (-9) [9; 10; 9; 10; 9; 10; 9; 10; 9; 10; 9; 10; 9; 10; 9; 10; 9; 10; 9] 90.

(* 4 times the mask without the factor (1 + z)^2, over 45 *)
Definition S5_symbol : list Z := [18; (-16); 32; (-28); 42; (-36); 48; (-40); 50; (-40); 48; (-36); 42; (-28); 32; (-16); 18].

Lemma S5_symbol_right : divides S5_scheme 2 = true /\ difference_symbol S5_scheme 2 = map (Z.mul 2) S5_symbol.
Proof. vm_compute. auto. Qed.

Lemma S5_family : matrices_of S5_claim = Family 16 45 (transition 2 16 S5_symbol).
Proof. vm_compute. reflexivity. Qed.

Theorem S5_radius : forall x, is_radius 16 2 (real (Family 16 45 (transition 2 16 S5_symbol))) x ->
  (100685507596714 / 100000000000000 <= x <= 10068550759671506 / 10000000000000000)%R.
Proof.
  intros x Hx. rewrite <- S5_family in Hx. destruct (S5_claim_holds x Hx) as [L U].
  specialize (L _ eq_refl). specialize (U _ eq_refl). unfold real_of in *. simpl in *. lra.
Qed.

(* With the mask over 90 the matrices are the same. *)
Lemma S5_difference_family r : let T := difference_family S5_scheme 2 in
  growth (size T) (count T) (real T) r <-> growth 16 2 (real (Family 16 45 (transition 2 16 S5_symbol))) r.
Proof.
  assert (E : forall t i j, (t < 2)%nat -> (i < 16)%nat -> (j < 16)%nat ->
    real (difference_family S5_scheme 2) t i j = real (Family 16 45 (transition 2 16 S5_symbol)) t i j).
  { intros t i j Ht Hi Hj. unfold difference_family. cbv zeta.
    change (matrix_size (arity S5_scheme) (difference_symbol S5_scheme 2)) with 16%nat.
    rewrite !transition_entry by auto. destruct S5_symbol_right as [_ E]. cbn [arity common S5_scheme].
    unfold scheme_matrix. rewrite E, coefficient_map. unfold coefficient. destruct (_ <? 0); lra. }
  split; intros G; eapply growth_ext; try apply G; intros; [|symmetry]; apply E; auto.
Qed.

(* The scheme converges, and the exponent of its limit is between 1.990143959386255 and 1.990143959386271. *)
Theorem S5_exponent : exists phi, limit_of S5_scheme phi /\
  exponent_at_least phi (1990143959386255 / 1000000000000000)%R /\ exponent_at_most phi (1990143959386271 / 1000000000000000)%R.
Proof.
  destruct (radius_exists 16 2 (real (Family 16 45 (transition 2 16 S5_symbol)))) as [x Hx].
  assert (B := S5_radius x Hx). destruct Hx as [_ [Gx Lx]].
  apply (enclosure_of_radius S5_scheme (1990143959386255 # 1000000000000000) (1990143959386271 # 1000000000000000) 2
    (10068550759671506 # 10000000000000000) (100685507596714 # 100000000000000) S5_shifts).
  - vm_compute. reflexivity.
  - intros r Hr H0. apply S5_difference_family. apply Gx. unfold real_of in Hr. simpl in Hr. lra.
  - intros r Hr G. apply S5_difference_family in G. apply Lx in G; auto. unfold real_of. simpl. lra.
Qed.

Definition S5_polynomial : list Z :=
  [16777216; 75497472; 182452224; 461897728; (-763822080); 4373053440; (-13634355200); (-26514432000); 56755584000;
   (-1258944768000); (-1657104480000); (-4205601000000); 6285766050000; 16740391500000; (-376658808750000); (-403563009375000);
   756680642578125].

(* The supremum of the exponents of the limit is 2 less the logarithm of z to the base 2, z the one zero of the polynomial
   within 1/1000 of 1007/1000: 2^(2 - s) = |z|. *)
Theorem S5_exact : exists phi s z lambda, limit_of S5_scheme phi /\ is_lub (exponents phi) s /\
  value S5_polynomial z = real_number 0 /\ (cabs (cminus z (real_number (1007 / 1000))) <= 1 / 1000)%R /\
  (forall y, value S5_polynomial y = real_number 0 -> (cabs (cminus y (real_number (1007 / 1000))) <= 1 / 1000)%R -> y = z) /\
  exp lambda = 2%R /\ exp ((2 - s) * lambda) = cabs z.
Proof.
  destruct S5Exact_exact_exponent_holds as [[z [Iz Uz]] [phi [r [s [lambda [Lim [[_ [y [Iy Ey]]] [Hlog [Hs [Lub _]]]]]]]]]].
  assert (C : complex_over 1007 0 1000 = real_number (1007 / 1000)) by (unfold complex_over, real_number; f_equal; lra).
  assert (One : (IZR 1 / IZR 1000 = 1 / 1000)%R) by reflexivity.
  unfold is_zero_of in *. cbn [polynomial disc_re disc_im disc_radius disc_scale] in *. rewrite C in *.
  destruct Iz as [Z1 Z2]. exists phi, s, z, lambda. repeat (split; [assumption|]). split; [|split].
  - intros x X1 X2. apply Uz. auto.
  - rewrite Hlog. simpl. lra.
  - rewrite <- (Uz y Iy). simpl root in Ey. rewrite pow_1 in Ey. rewrite <- Ey, <- Hs. reflexivity.
Qed.
