(* The difference matrices of a scheme, made from its mask; and the joint spectral radius of those of primal:n=5, the primal
   least squares scheme of ten points and degree 1, in the kernel of Coq alone: no extraction, no OCaml, no parser. *)
Require Import Reals List ZArith QArith Lra.
From Subcert Require Import Radius Integers Sections Check S5.
Import ListNotations.
Open Scope Z_scope.

(* Products of polynomials, the coefficients from the constant one on. *)
Definition polynomial_product (p q : list Z) : list Z :=
  fold_right (fun a rest => addmul a q (0 :: rest)) [] p.
Fixpoint polynomial_power (p : list Z) (k : nat) : list Z :=
  match k with O => [1] | S j => polynomial_product p (polynomial_power p j) end.

(* (T_t)_jk = b_(arity j + t - k), for t = 0, ..., arity - 1 and j, k = 0, ..., size - 1. *)
Definition transition (arity size : nat) (b : list Z) : list zmat :=
  map (fun t => table size (fun j k => if (k <=? arity * j + t)%nat then nth (arity * j + t - k) b 0 else 0)) (seq 0 arity).

(* b is arity^order times a symbol, mask / d, without its factor ((1 + z + ... + z^(arity - 1)))^order; b is over e. *)
Definition is_difference_symbol (arity order : nat) (mask : list Z) (d : Z) (b : list Z) (e : Z) : Prop :=
  map (Z.mul d) (polynomial_product (polynomial_power (repeat 1 arity) order) b) =
  map (Z.mul (Z.of_nat arity ^ Z.of_nat order * e)) mask.

Definition S5_mask : list Z := [9; 10; 9; 10; 9; 10; 9; 10; 9; 10; 9; 10; 9; 10; 9; 10; 9; 10; 9].  (* over 90 *)
Definition S5_symbol : list Z := [18; (-16); 32; (-28); 42; (-36); 48; (-40); 50; (-40); 48; (-36); 42; (-28); 32; (-16); 18].  (* over 45 *)

Lemma S5_symbol_right : is_difference_symbol 2 2 S5_mask 90 S5_symbol 45.
Proof. vm_compute. reflexivity. Qed.

Lemma S5_family : matrices_of S5_claim = Family 16 45 (transition 2 16 S5_symbol).
Proof. vm_compute. reflexivity. Qed.

Theorem S5_radius : forall x, is_radius 16 2 (real (Family 16 45 (transition 2 16 S5_symbol))) x ->
  (100685507596714 / 100000000000000 <= x <= 100685507596716 / 100000000000000)%R.
Proof.
  intros x Hx. rewrite <- S5_family in Hx. destruct (S5_claim_holds x Hx) as [L U].
  specialize (L _ eq_refl). specialize (U _ eq_refl). unfold real_of in *. simpl in *. lra.
Qed.
