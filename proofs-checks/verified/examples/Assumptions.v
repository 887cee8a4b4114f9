(* The axioms that the theorems rest on. *)
From Subcert Require Import Radius Existence Check Subradius Exponent Enclosure Exact SubradiusExact Logarithm Rough Reduced Levels Ranges Follow Period Vectors VectorsAbove VectorsExact VectorsComponent VectorLists HermiteLists Scheme.

Print Assumptions radius_exists.
Print Assumptions check_radius_sound.
Print Assumptions subradius_exists.
Print Assumptions check_subradius_sound.
Print Assumptions check_exponent_lower_sound.
Print Assumptions check_exponent_sound.
Print Assumptions S5_radius.
Print Assumptions S5_exponent.
Print Assumptions check_exact_radius_sound.
Print Assumptions check_exact_subradius_sound.
Print Assumptions check_exact_exponent_sound.
Print Assumptions S5_exact.
Print Assumptions check_logarithm_sound.
Print Assumptions check_rough_sound.
Print Assumptions check_full_sound.
Print Assumptions check_reduced_exponent_lower_sound.
Print Assumptions check_reduced_exponent_sound.
Print Assumptions check_reduced_exact_exponent_sound.
Print Assumptions check_reduced_logarithm_sound.
Print Assumptions check_reduced_full_sound.
Print Assumptions check_reduced_rough_sound.
Print Assumptions check_levels_sound.
Print Assumptions check_range_levels_sound.
Print Assumptions check_range_sound.
Print Assumptions period_sound.
Print Assumptions check_vectors_sound.
Print Assumptions check_vectors_between_sound.
Print Assumptions check_exact_vectors_sound.
Print Assumptions check_component_sound.
Print Assumptions check_component_between_sound.
Print Assumptions check_exact_component_sound.
Print Assumptions check_follow_sound.
Print Assumptions check_vector_lists_sound.
Print Assumptions check_vector_scheme_sound.
Print Assumptions check_hermite_lists_sound.
