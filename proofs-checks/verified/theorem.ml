(* A claim and its certificate as a file for Coq, whose kernel then checks it without OCaml. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith

let list item items = "[" ^ String.concat "; " (List.map item items) ^ "]"
let integer x = if Z.sign x < 0 then "(" ^ Z.to_string x ^ ")" else Z.to_string x
let vector = list integer
let matrix = list vector
let pair first second (a, b) = Printf.sprintf "(%s, %s)" (first a) (second b)
let natural k = string_of_int k ^ "%nat"
let option item = function None -> "None" | Some x -> "(Some " ^ item x ^ ")"
let fraction q = Printf.sprintf "(%s # %s)" (integer q.qnum) (Z.to_string q.qden)

let family f = Printf.sprintf "(Family %s %s %s)" (natural f.size) (integer f.denominator) (list matrix f.matrices)
let term = pair (fun i -> Z.to_string i ^ "%positive") (pair integer integer)
let root r = Printf.sprintf "(Root %s %s %s)" (matrix r.root_rows) (integer r.root_factor) (integer r.root_scale)

let rec words = function
  | Word r -> "(Word " ^ root r ^ ")"
  | Words children -> "(Words " ^ list words children ^ ")"

let rec branch = function Stop k -> "(Stop " ^ natural k ^ ")" | Further l -> "(Further " ^ list branch l ^ ")"
let element e = Printf.sprintf "(Element %s %s %s)" (matrix e.action) (matrix e.undone) (list natural e.reading)
let turn h = Printf.sprintf "(Turn %s %s)" (matrix h.turning) (list natural h.moved)

let step s =
  Printf.sprintf "(Step %s %s %s %s)" (natural s.target) (natural s.turned_by) (integer s.step_norm) (matrix s.step_matrix)

let state s =
  Printf.sprintf "(State %s\n%s\n%s)" (matrix s.coordinates) (list (list step) s.steps) (list branch s.trees)

let squares s =
  Printf.sprintf "(Squares %s %s %s %s %s %s)" (vector s.symbol) (integer s.content) (vector s.divisor) (vector s.cosine)
    (vector s.factor) (natural s.bits)

let graph (bound, unity, firsts, group, turns, states) =
  Printf.sprintf "%s %s %s %s %s\n%s" (fraction bound) (integer unity) (list natural firsts) (list element group)
    (list turn turns) (list state states)

let section = function
  | Norm level -> "(Norm " ^ natural level ^ ")"
  | Polytope (nonnegative, transposed, scale, one, points, units, images) ->
      Printf.sprintf "(Polytope %b %b %s %s %s\n%s\n%s)" nonnegative transposed (integer scale) (integer one)
        (list (pair vector vector) points)
        (list (list term) units)
        (list (list (list term)) images)
  | Quadratic (form, definite, tree) -> Printf.sprintf "(Quadratic %s %s %s)" (matrix form) (root definite) (words tree)
  | Graph (bound, unity, firsts, group, turns, states) -> "(Graph " ^ graph (bound, unity, firsts, group, turns, states) ^ ")"
  | Single (s, recurrence) -> Printf.sprintf "(Single %s %s)" (squares s) (vector recurrence)

let eigen e =
  Printf.sprintf "(Eigen %s %s %s %s %s %s %s %s\n%s %s %s)" (list natural e.word) (integer e.multiplier) (vector e.xr)
    (vector e.xi) (integer e.er) (integer e.ei) (natural e.pivot) (integer e.pivot_scale) (matrix e.inverse)
    (integer e.over) (integer e.distance)

let basis b =
  Printf.sprintf "(Basis %s %s %s)" (matrix b.basis_rows) (matrix b.inverse_rows) (integer b.basis_scale)

let certificate c =
  Printf.sprintf "(Certificate %s\n%s\n%s %s %s)" (option basis c.new_basis)
    (list (pair natural section) c.sections)
    (list natural c.sizes) (natural c.chosen) (option eigen c.eigenvector)

(* The kernel computes that the checker accepts; once, at Qed. *)
let by_computation = "vm_cast_no_check (eq_refl true). Qed"

(* The file of a claim, a certificate and a theorem; `modules` are what it needs beside those of every file. *)
let print name modules claim certificate theorem =
  Printf.printf
    "(* Made by subcert-check-verified --theorem %s: the claim, its certificate, and the proof by computation. *)\n\
     Require Import Reals List ZArith QArith.\n\
     From Subcert Require Import Radius Integers Sections Eigenvalue Quadratic Graph Single Check%s.\n\
     Import ListNotations.\n\
     Open Scope Z_scope.\n\n\
     Definition %s_%s.\n\n\
     Definition %s_certificate := %s.\n\n\
     Theorem %s_%s.\n"
    name modules name claim name certificate name theorem

let claim_of c =
  Printf.sprintf "claim : claim := Claim %s %s %s" (family c.matrices_of) (option fraction c.lower) (option fraction c.upper)

let print_radius name claim c =
  print name "" (claim_of claim) (certificate c)
    (Printf.sprintf
       "claim_holds : claim_holds %s_claim.\nProof. apply (check_radius_sound _ %s_certificate). %s"
       name name by_computation)

let slow_product p =
  Printf.sprintf "(SlowProduct %s %s %s)" (list natural p.slow_word) (fraction p.slow_factor) (vector p.slow_weights)

let climb c =
  Printf.sprintf "(Climb %b %s %s\n%s)" c.climb_transposed (integer c.climb_scale)
    (list (pair vector vector) c.climb_points)
    (list (list (list term)) c.climb_terms)

let subradius_certificate c =
  Printf.sprintf "SubradiusCertificate %s\n%s" (option slow_product c.upper_product) (option climb c.lower_climb)

let print_subradius name claim c =
  print name " Subradius" (claim_of claim) (subradius_certificate c)
    (Printf.sprintf
       "subradius_claim_holds : subradius_claim_holds %s_claim.\nProof. apply (check_subradius_sound _ %s_certificate). %s"
       name name by_computation)

let stability c =
  Printf.sprintf "(Stability %s %s %s %s %s\n%s %s %s %s)" (integer c.start) (vector c.values) (integer c.scale)
    (matrix c.inverse_matrix) (integer c.inverse_over) (natural c.level) (vector c.weights) (integer c.row) (natural c.center)

(* Exact numbers *)
let point = pair vector vector

let number e =
  Printf.sprintf "(ExactNumber %s %s %s %s %s %s)" (vector e.polynomial) (integer e.disc_re) (integer e.disc_im)
    (integer e.disc_radius) (integer e.disc_scale) (natural e.root)

let base b =
  let before (k, (word, seed)) = Printf.sprintf "(%s, (%s, %s))" (natural k) (list natural word) (point seed) in
  Printf.sprintf "(Base %s %b %s)" (list point b.vectors) b.conjugated (option before b.previous)

let numeral i = Z.to_string i ^ "%positive"
let source = function FromBase k -> "(FromBase " ^ natural k ^ ")" | FromPoint (i, t) -> Printf.sprintf "(FromPoint %s %s)" (numeral i) (natural t)

let image = function
  | Link (i, a, b) -> Printf.sprintf "(Link %s %s %s)" (numeral i) (natural a) (natural b)
  | Below (i, a, b) -> Printf.sprintf "(Below %s %s %s)" (numeral i) (natural a) (natural b)
  | Inside terms -> "(Inside " ^ list term terms ^ ")"

let pole c =
  Printf.sprintf "(Pole %s %s %s %s)" (squares c.squares_of) (vector c.recurrence) (natural c.multiplicity) (vector c.cofactor)

let stop (state, (c, row)) = Printf.sprintf "(%s, (%s, %s))" (natural state) (natural c) (point row)

let cycle c =
  Printf.sprintf "(Cycle %s %s %s %s %s %s)" (natural c.carrier) (fraction c.part) (fraction c.weight) (integer c.cut)
    (fraction c.least) (list stop c.stops)

let exact_section = function
  | Bounded s -> "(Bounded " ^ section s ^ ")"
  | Attains (transposed, b) ->
      Printf.sprintf "(Attains %b (Body %b %s\n%s\n%s %s\n%s\n%s %s))" transposed b.cone (list base b.bases)
        (list (pair source (pair point (list image))) b.given)
        (integer b.weight_one) (integer b.unit_one) (list (list term) b.unit_lines) (natural b.first_base) (natural b.full_turn)
  | Cyclic (bound, unity, firsts, group, turns, states, carriers, cycles) ->
      Printf.sprintf "(Cyclic %s\n%s\n%s)" (graph (bound, unity, firsts, group, turns, states)) (list base carriers)
        (list cycle cycles)
  | Leading c -> "(Leading " ^ pole c ^ ")"

let place p =
  Printf.sprintf "(Place %s %s %s %s %s %s %s)" (integer p.near_re) (integer p.near_im) (integer p.near_radius)
    (integer p.near_scale) (integer p.low) (integer p.high) (integer p.bottom)

let exact_certificate c =
  Printf.sprintf "Exact %s\n%s\n%s" (place c.number_place) (option basis c.exact_basis)
    (list (pair natural exact_section) c.exact_blocks)

let exact_modules = " Subdivision Stability Exponent Enclosure Number Attained Cycles Largest Exact"

let print_exact_radius name claim e c =
  print name exact_modules (Printf.sprintf "family : family := %s" (family claim.matrices_of)) (exact_certificate c)
    (Printf.sprintf
       "exact_radius_holds : exact_radius_holds %s_family %s %s %s.\n\
        Proof. apply (check_exact_radius_sound _ _ _ _ %s_certificate). %s"
       name (number e) (option fraction claim.lower) (option fraction claim.upper) name by_computation)

let rise = function
  | Reaches i -> "(Reaches " ^ numeral i ^ ")"
  | Closes -> "Closes"
  | Passes (i, a, b) -> Printf.sprintf "(Passes %s %s %s)" (numeral i) (natural a) (natural b)
  | Exceeds terms -> "(Exceeds " ^ list term terms ^ ")"

let peak x =
  Printf.sprintf "(Peak %s %s %b %s %s %s)" (vector x.peak_given) (integer x.peak_factor) x.peak_whole
    (list natural x.peak_word) (numeral x.peak_origin) (list rise x.peak_rises)

let ascent a =
  Printf.sprintf "Ascent %b %s %s %s %s %s\n%s" a.ascent_transposed (base a.eigenvector_base) (fraction a.eigenvector_multiple)
    (vector a.beside) (integer a.ascent_scale) (integer a.factor_scale) (list peak a.peaks)

let print_exact_subradius name claim e h a bounds =
  print name (" Subradius" ^ exact_modules ^ " SubradiusExact")
    (Printf.sprintf "family : family := %s" (family claim.matrices_of))
    (ascent a)
    (Printf.sprintf
       "exact_subradius_holds : exact_subradius_holds %s_family %s %s %s.\n\
        Proof. apply (check_exact_subradius_sound _ _ _ _ %s %s_certificate (%s)). %s"
       name (number e) (option fraction claim.lower) (option fraction claim.upper) (place h) name (subradius_certificate bounds)
       by_computation)

let modulus_proof = function
  | Between below -> "(Between " ^ natural below ^ ")"
  | Whole (below, level) -> Printf.sprintf "(Whole %s %s)" (natural below) (natural level)
  | Double (below, scale, c) -> Printf.sprintf "(Double %s %s %s)" (natural below) (integer scale) (pole c)

(* ---- masks ---- *)

let scheme s =
  Printf.sprintf "Scheme %s %s %s %s" (natural s.arity) (integer s.first) (vector s.coefficients) (integer s.common)

let reduction c =
  Printf.sprintf "Reduction %s (%s)\n%s %s %s" (vector c.shift_factor) (scheme c.other_scheme) (natural c.own_order)
    (fraction c.own_bound) (certificate c.own_radius)

(* What is said of a mask by the theorem of a checker with the arguments `rest`, where all depends on the name: `shifts` and
   the certificate are defined before. With a reduction it is said by the theorem of Reduced.v; that the limit is not C^k,
   beside it, by one more theorem, for which `converges` shows that there is a limit. *)
type statement = {
  modules : string;
  shifts : stability option;
  certificate : string;
  said : string -> string;
  checker : string;
  rest : string -> string;
  converges : string -> string;
  rough : (int * int * stability) option;
}

let rough_modules = exact_modules ^ " Smooth Modulus Logarithm Rough"
let rough_said k name = Printf.sprintf "rough_holds : rough_holds %s_scheme %s" name (natural k)

let masks m =
  Printf.sprintf "Masks %s %s\n%s" (natural m.masks_arity) (integer m.masks_common) (list (pair integer vector) m.each)

let sequences = function Any -> "Any" | Follows pairs -> "(Follows " ^ list (pair natural natural) pairs ^ ")"

(* How the scheme NAME_scheme is defined, beginning after `Definition NAME_`; the modules for that; and what is said beside *)
type subject = { more_modules : string; definition : string; beside : string }

let scheme_of_mask s _ = { more_modules = ""; definition = "scheme : scheme := " ^ scheme s; beside = "" }

(* The product of masks in turn, which has the same limits *)
let scheme_of_period m i others name =
  let turn = Printf.sprintf "%s %s" (natural i) (list natural others) in
  { more_modules = rough_modules ^ " Along Levels Period";
    definition =
      Printf.sprintf "masks : masks := %s.\n\nDefinition %s_scheme : scheme := period_scheme %s_masks %s" (masks m) name name turn;
    beside =
      Printf.sprintf
        "\nTheorem %s_limits : forall phi, limit_of_sequence %s_masks (in_turn %s) phi <-> limit_of %s_scheme phi.\n\
         Proof. apply period_sound. %s.\n"
        name name turn name by_computation }

let print_mask name reduced subject statement =
  let definition part value = Printf.sprintf ".\n\nDefinition %s_%s := %s" name part value in
  let shifts = match statement.rough with Some (_, _, shifts) -> Some shifts | None -> statement.shifts in
  let defined part render = Option.fold ~none:"" ~some:(fun c -> definition part (render c)) in
  let sound kind =
    match reduced with
    | None -> "check_" ^ kind ^ "_sound _"
    | Some _ -> Printf.sprintf "check_reduced_%s_sound _ %s_reduction" kind name
  in
  let modules =
    match (reduced, statement.rough) with
    | None, None -> statement.modules
    | None, Some _ -> rough_modules
    | Some _, _ -> rough_modules ^ " Reduced"
  in
  print name (modules ^ subject.more_modules)
    (subject.definition ^ defined "reduction" reduction reduced ^ defined "shifts" stability shifts)
    statement.certificate
    (Printf.sprintf "%s.\nProof. apply (%s %s). %s" (statement.said name) (sound statement.checker) (statement.rest name) by_computation);
  let rough (order, k, _) =
    let rest = Printf.sprintf "%s _ %s_shifts" (natural order) name in
    let rest = if reduced = None then rest else Printf.sprintf "_ %s (%s)" rest (statement.converges name) in
    Printf.printf "\nTheorem %s_%s.\nProof. apply (%s %s). %s.\n" name (rough_said k name) (sound "rough") rest by_computation
  in
  Option.iter rough statement.rough;
  print_string subject.beside

let lower_end c = Printf.sprintf "Exponent %s %s %s" (natural c.order) (fraction c.bound) (certificate c.of_radius)

let exponent l c =
  let said name = Printf.sprintf "exponent_holds : exponent_holds %s_scheme %s" name (fraction l) in
  let rest name = Printf.sprintf "_ %s_certificate" name in
  let converges name = Printf.sprintf "lower_converges %s %s_certificate" (fraction l) name in
  { modules = " Subdivision Exponent"; shifts = None; certificate = lower_end c; said; checker = "exponent_lower"; rest; converges;
    rough = None }

(* A mask for each level *)
let print_levels name m s l c =
  print name " Subdivision Exponent Along Levels" ("masks : masks := " ^ masks m) (lower_end c)
    (Printf.sprintf
       "levels_hold : levels_hold %s_masks %s %s.\nProof. apply (check_levels_sound _ _ _ %s_certificate). %s"
       name (sequences s) (fraction l) name by_computation)

(* A mask with a parameter *)
let print_ranged name a l claim checker certificate =
  let mask =
    Printf.sprintf "mask : ranged := Ranged %s %s\n%s\n%s" (natural a.ranged_arity) (integer a.ranged_first)
      (list vector a.numerators) (vector a.ranged_divisor)
  in
  print name " Subdivision Exponent Along Levels Ranges" mask certificate
    (Printf.sprintf "%s : %s %s_mask %s.\nProof. %s. %s" claim claim name l checker by_computation)

let ends low high l = Printf.sprintf "%s %s %s" (fraction low) (fraction high) (fraction l)

let print_range_levels name a low high l common c =
  print_ranged name a (ends low high l) "range_levels_hold"
    (Printf.sprintf "apply (check_range_levels_sound _ _ _ _ %s %s_certificate)" (integer common) name)
    (lower_end c)

let print_range name a low high l intervals =
  let interval = pair fraction (pair integer (fun c -> "(" ^ lower_end c ^ ")")) in
  print_ranged name a (ends low high l) "range_holds"
    (Printf.sprintf "apply (check_range_sound _ _ %s_certificate)" name)
    (list interval intervals)

(* Values that follow from each other *)
let print_follow name a r first last from low high l common c way =
  let step (sign, (x, y)) = Printf.sprintf "(%s, (%s, %s))" (integer sign) (fraction x) (fraction y) in
  let path =
    Printf.sprintf "(Follows_by %s %s %s)" (integer way.range_sign) (list step way.way_levels)
      (option (fun (sign, far) -> Printf.sprintf "(%s, %s)" (integer sign) (fraction far)) way.descent)
  in
  let mask =
    Printf.sprintf "mask : ranged := Ranged %s %s\n%s\n%s.\n\nDefinition %s_step : rule := Rule %s %s %b"
      (natural a.ranged_arity) (integer a.ranged_first) (list vector a.numerators) (vector a.ranged_divisor) name
      (vector r.above_bar) (vector r.below_bar) r.of_root
  in
  print name " Subdivision Exponent Along Levels Ranges Follow" mask (lower_end c)
    (Printf.sprintf "follow_hold : follow_hold %s_mask %s_step %s %s %s %s.\nProof. apply (check_follow_sound _ _ _ _ _ _ _ _ %s %s_certificate %s). %s"
       name name (fraction first) (option fraction last) (option natural from) (ends low high l) (integer common) name path by_computation)

(* Vectors of functions *)
let vector_mask a =
  Printf.sprintf "vector_mask : vector_mask := VectorMask %s %s %s\n%s %s" (natural a.vector_arity) (natural a.functions)
    (integer a.vector_first) (list matrix a.of_points) (integer a.vector_common)

let vector_certificate c =
  Printf.sprintf "VectorCertificate %s %s\n%s %s\n%s\n%s %s\n%s %s %s %s %s\n%s %s %s\n%s" (integer c.window_first)
    (natural c.window) (vector c.fixed) (natural c.difference_order) (matrix c.spanning) (list natural c.places) (integer c.place_value)
    (list matrix c.restricted) (natural c.entering) (integer c.inner_first) (natural c.inner) (natural c.nonzero) (matrix c.kernel)
    (integer c.kernel_scale) (fraction c.space_bound) (certificate c.space_radius)

let vector_modules = " Subdivision Exponent Along Levels Vectors"

let print_vectors name a l c =
  print name vector_modules (vector_mask a) (vector_certificate c)
    (Printf.sprintf
       "vectors_hold : vectors_hold %s_vector_mask %s.\nProof. apply (check_vectors_sound _ _ %s_certificate). %s"
       name (fraction l) name by_computation)

let list_certificate c =
  Printf.sprintf "ListCertificate %s %s %s\n%s %s %s\n%s\n%s %s %s\n%s %s %s\n%s %s\n%s %s\n%s %s" (integer c.list_first) (natural c.list_window)
    (natural c.list_order) (matrix c.list_spanning) (list natural c.list_places) (integer c.list_place_value) (list (list matrix) c.list_restricted)
    (matrix c.wide) (list natural c.wide_places) (integer c.wide_pivot) (matrix c.wide_rows) (integer c.wide_scale) (natural c.list_entering)
    (vector c.functional) (vector c.constants) (matrix c.list_weights) (integer c.list_scale) (fraction c.list_bound) (certificate c.list_radius)

let list_modules = " Subdivision Exponent Along VectorLevels Vectors VectorLists"

let vector_masks m =
  Printf.sprintf "vector_masks : vector_masks := VectorMasks %s %s %s\n%s" (natural m.list_arity) (natural m.list_functions) (integer m.list_common)
    (list (pair integer (list matrix)) m.each_vector)

let print_vector_lists name m s l c =
  print name list_modules (vector_masks m) (list_certificate c)
    (Printf.sprintf
       "vector_lists_hold : vector_lists_hold %s_vector_masks %s %s.\nProof. apply (check_vector_lists_sound _ _ _ %s_certificate). %s"
       name (sequences s) (fraction l) name by_computation)

let print_hermite_lists name m s k c factors =
  print name (list_modules ^ " HermiteLists") (vector_masks m) (list_certificate c)
    (Printf.sprintf
       "hermite_lists_hold : hermite_lists_hold %s_vector_masks %s %s.\nProof. apply (check_hermite_lists_sound _ _ _ %s_certificate\n%s). %s"
       name (sequences s) (natural k) name (matrix factors) by_computation)

let print_vector_scheme name a l c =
  print name list_modules (vector_mask a) (list_certificate c)
    (Printf.sprintf
       "vector_scheme_holds : vector_scheme_holds %s_vector_mask %s.\nProof. apply (check_vector_scheme_sound _ _ %s_certificate). %s"
       name (fraction l) name by_computation)

let above_certificate d =
  Printf.sprintf "AboveCertificate (%s)\n%s\n%s %s %s" (vector_certificate d.space_proof) (list (list natural) d.image_words)
    (matrix d.combinations) (integer d.combination_scale) (fraction d.space_least)

let print_vectors_between name a l u d =
  print name (vector_modules ^ " VectorsAbove") (vector_mask a) (above_certificate d)
    (Printf.sprintf
       "vectors_between : vectors_between %s_vector_mask %s %s.\n\
        Proof. apply (check_vectors_between_sound _ _ _ %s_certificate). %s"
       name (fraction l) (fraction u) name by_computation)

let print_exact_vectors name a e lower upper d c =
  print name
    (exact_modules ^ " Along Levels Vectors VectorsAbove VectorsExact")
    (Printf.sprintf "%s.\n\nDefinition %s_space := %s" (vector_mask a) name (above_certificate d))
    (exact_certificate c)
    (Printf.sprintf
       "exact_vectors_hold : exact_vectors_hold %s_vector_mask %s %s %s.\n\
        Proof. apply (check_exact_vectors_sound _ _ _ _ %s_space %s_certificate). %s"
       name (number e) (option fraction lower) (option fraction upper) name name by_computation)

(* One component of a vector of functions *)
let hidden p =
  Printf.sprintf "hidden : hidden := Hidden %s %s\n%s (%s)" (natural p.unseen) (basis p.observing) (fraction p.unseen_bound)
    (certificate p.unseen_radius)

let observation o =
  Printf.sprintf "observation : observation := Observation %s\n%s %s"
    (list (pair (list natural) natural) o.seen_at) (matrix o.seen_rows) (integer o.seen_scale)

let component_modules = exact_modules ^ " Along Levels Vectors VectorsAbove VectorsExact VectorsComponent"

let component name a p more certificate said proof =
  let definition text = Printf.sprintf ".\n\nDefinition %s_%s" name text in
  print name component_modules (vector_mask a ^ definition (hidden p) ^ String.concat "" (List.map definition more)) certificate
    (Printf.sprintf "%s.\nProof. apply %s. %s" said proof by_computation)

let print_component name a k l c p =
  component name a p [] (vector_certificate c)
    (Printf.sprintf "component_holds : component_holds %s_vector_mask %s %s" name (natural k) (fraction l))
    (Printf.sprintf "(check_component_sound _ _ _ %s_certificate %s_hidden)" name name)

let print_component_between name a k l u d p o =
  component name a p [ observation o ] (above_certificate d)
    (Printf.sprintf "component_between : component_between %s_vector_mask %s %s %s" name (natural k) (fraction l) (fraction u))
    (Printf.sprintf "(check_component_between_sound _ _ _ _ %s_certificate %s_hidden %s_observation)" name name name)

let print_exact_component name a k e lower upper d p o c =
  component name a p [ observation o; "space := " ^ above_certificate d ] (exact_certificate c)
    (Printf.sprintf "exact_component_holds : exact_component_holds %s_vector_mask %s %s %s %s" name (natural k) (number e)
       (option fraction lower) (option fraction upper))
    (Printf.sprintf "(check_exact_component_sound _ _ _ _ _ %s_space %s_hidden %s_observation %s_certificate)" name name name name)

let enclosed l u name = Printf.sprintf "enclosure_holds : enclosure_holds %s_scheme %s %s" name (fraction l) (fraction u)

let enclosure l u c =
  let rest name = Printf.sprintf "_ _ %s_certificate" name in
  let certificate = Printf.sprintf "Enclosure (%s) %s\n%s" (lower_end c.lower_end) (fraction c.radius_least) (stability c.shifts) in
  let modules = " Subdivision Stability Exponent Enclosure" in
  { (exponent l c.lower_end) with modules; certificate; said = enclosed l u; checker = "exponent"; rest }

(* The upper end by the number of sum rules *)
let full l u low shifts =
  let rest name = Printf.sprintf "_ _ %s_certificate %s_shifts" name name in
  { (exponent l low) with modules = rough_modules; shifts = Some shifts; said = enclosed l u; checker = "full"; rest }

let rough order k shifts =
  let rest name = Printf.sprintf "%s _ %s_certificate" (natural order) name in
  { modules = rough_modules; shifts = None; certificate = stability shifts; said = rough_said k;
    checker = "rough"; rest; converges = Fun.id; rough = None }

let exact_claim order e lower upper =
  Printf.sprintf "%s\n%s %s %s" (natural order) (number e) (option fraction lower) (option fraction upper)

let exactly kind order e lower upper name =
  Printf.sprintf "%s_holds : %s_holds %s_scheme %s" kind kind name (exact_claim order e lower upper)

let exact_exponent order e lower upper c shifts =
  let proof name = Printf.sprintf "%s_certificate %s_shifts" name name in
  let rest name = "_ _ _ _ " ^ proof name in
  let converges name = Printf.sprintf "exact_exponent_converges %s %s" (exact_claim order e lower upper) (proof name) in
  { modules = exact_modules; shifts = Some shifts; certificate = exact_certificate c; said = exactly "exact_exponent" order e lower upper;
    checker = "exact_exponent"; rest; converges; rough = None }

let logarithm order e lower upper c shifts p power =
  let proof name = Printf.sprintf "%s_certificate %s_shifts %s" name name (modulus_proof p) in
  let rest name = "_ _ _ _ " ^ proof name in
  let said name = exactly "logarithm" order e lower upper name ^ " " ^ natural power in
  let converges name = Printf.sprintf "logarithm_converges %s %s %s" (exact_claim order e lower upper) (proof name) (natural power) in
  { modules = exact_modules ^ " Modulus Logarithm"; shifts = Some shifts; certificate = exact_certificate c; said;
    checker = "logarithm"; rest; converges; rough = None }
