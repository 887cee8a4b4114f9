(* The axioms that the theorems rest on. *)
From Subcert Require Import Radius Existence Check Scheme.

Print Assumptions radius_exists.
Print Assumptions check_radius_sound.
Print Assumptions S5_radius.
