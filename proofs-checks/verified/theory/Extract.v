(* The checker as a program in OCaml, with the integers of zarith: of numbers only what ../number.ml lists is trusted. *)
Require Import ZArith QArith.
From Subcert Require Import Integers Sections Eigenvalue Quadratic Graph Check Subradius Exponent Enclosure Number Attained Cycles Largest Exact Logarithm
  SubradiusExact Rough Reduced Along Levels Ranges Follow Period Vectors VectorsAbove VectorsExact VectorsComponent
  VectorLists HermiteLists.
Require Import Extraction.

Extraction Language OCaml.
Extract Inductive bool => "bool" ["true" "false"].
Extract Inductive list => "list" ["[]" "(::)"].
Extract Inductive prod => "(*)" ["(,)"].
Extract Inductive option => "option" ["Some" "None"].
Extract Inductive sumbool => "bool" ["true" "false"].
Extract Inlined Constant andb => "(&&)".
Extract Inlined Constant orb => "(||)".

Extract Inductive positive => "Number.t" ["Number.twice_plus_one" "Number.twice" "Number.one"] "Number.case_positive".
Extract Inductive Z => "Number.t" ["Number.zero" "" "Number.opposite"] "Number.case_integer".
Extract Inlined Constant Z.add => "Number.add".
Extract Inlined Constant Z.sub => "Number.sub".
Extract Inlined Constant Z.mul => "Number.mul".
Extract Inlined Constant Z.opp => "Number.opposite".
Extract Inlined Constant Z.abs => "Number.abs".
Extract Inlined Constant Z.max => "Number.max".
Extract Inlined Constant Z.eqb => "Number.equal".
Extract Inlined Constant Z.leb => "Number.less_equal".
Extract Inlined Constant Z.ltb => "Number.less".
Extract Inlined Constant Z.div => "Number.divide".
Extract Inlined Constant Z.pow => "Number.power".
Extract Inlined Constant Z.sqrt => "Number.square_root".
Extract Inlined Constant Z.sqrt_up => "Number.square_root_up".
Extract Inlined Constant Z.of_nat => "Number.of_natural".
Extract Inlined Constant Pos.succ => "Number.successor".
Extract Inductive nat => "int" ["0" "Stdlib.succ"] "(fun zero next n -> if n = 0 then zero () else next (n - 1))".

Extraction "verified.ml" check_radius check_upper check_lower in_basis basis_valid first_block other_blocks transpose
  check_section value_entry derivative_entry product_columns zrun addmul well_formed check_exponent_lower reduces
  power_below unity difference_family divides check_exponent check_stable value_matrix fine fine_start
  check_number block_below block_reaches check_exact_radius check_exact_exponent check_logarithm symbol_above evaluate
  check_reduced check_factor check_rough check_full class_sum
  check_subradius check_product factor_below image_above check_exact_subradius equal_at
  check_levels levels_family level_size states scheme_of
  check_follow leads descends denominator_signed next_at_least next_at_most next_smaller signed_between signed_beyond
  check_range check_range_levels control_masks has_control_masks range_family form_between
  in_period period_scheme
  check_vectors checks_space checks_start checks_kernel unfixed move vector_family
  check_vectors_between checks_images checks_places image_by start_differences
  check_exact_vectors check_component check_component_between check_exact_component component_space seen_family seen_vectors seen_values observes
  check_vector_lists check_vector_scheme lists_family list_window_fits list_spaces list_constants list_shifted list_change list_component
  list_differences comes arrives list_moves vector_number check_hermite_lists derivative_factors.
