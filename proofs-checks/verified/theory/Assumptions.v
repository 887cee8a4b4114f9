(* The axioms that the theorems rest on. *)
From Subcert Require Import Radius Existence Check.

Print Assumptions radius_exists.
Print Assumptions check_radius_sound.
