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

let section = function
  | Norm level -> "(Norm " ^ natural level ^ ")"
  | Polytope (nonnegative, transposed, scale, one, points, units, images) ->
      Printf.sprintf "(Polytope %b %b %s %s %s\n%s\n%s)" nonnegative transposed (integer scale) (integer one)
        (list (pair vector vector) points)
        (list (list term) units)
        (list (list (list term)) images)
  | Quadratic (form, definite, tree) -> Printf.sprintf "(Quadratic %s %s %s)" (matrix form) (root definite) (words tree)

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

(* The file of a claim, a certificate and a theorem; `modules` are what it needs beside those of every file. *)
let print name modules claim certificate theorem =
  Printf.printf
    "(* Made by subcert-check-verified --theorem %s: the claim, its certificate, and the proof by computation. *)\n\
     Require Import Reals List ZArith QArith.\n\
     From Subcert Require Import Radius Integers Sections Eigenvalue Quadratic Check%s.\n\
     Import ListNotations.\n\
     Open Scope Z_scope.\n\n\
     Definition %s_%s.\n\n\
     Definition %s_certificate := %s.\n\n\
     Theorem %s_%s.\n"
    name modules name claim name certificate name theorem

let print_radius name claim c =
  print name ""
    (Printf.sprintf "claim : claim := Claim %s %s %s" (family claim.matrices_of) (option fraction claim.lower)
       (option fraction claim.upper))
    (certificate c)
    (Printf.sprintf
       "claim_holds : claim_holds %s_claim.\nProof. apply (check_radius_sound _ %s_certificate). vm_compute. reflexivity. Qed"
       name name)

let scheme_of s =
  Printf.sprintf "scheme : scheme := Scheme %s %s %s %s" (natural s.arity) (integer s.first) (vector s.coefficients)
    (integer s.common)

let print_exponent name s l c =
  print name " Subdivision Exponent" (scheme_of s)
    (Printf.sprintf "Exponent %s %s %s" (natural c.order) (fraction c.bound) (certificate c.of_radius))
    (Printf.sprintf
       "exponent_holds : exponent_holds %s_scheme %s.\n\
        Proof. apply (check_exponent_lower_sound _ _ %s_certificate). vm_compute. reflexivity. Qed"
       name (fraction l) name)

let print_enclosure name s l u c =
  let shifts =
    Printf.sprintf "(Stability %s %s %s %s %s\n%s %s %s %s)" (integer c.shifts.start) (vector c.shifts.values)
      (integer c.shifts.scale) (matrix c.shifts.inverse_matrix) (integer c.shifts.inverse_over) (natural c.shifts.level)
      (vector c.shifts.weights) (integer c.shifts.row) (natural c.shifts.center)
  in
  let low = c.lower_end in
  print name " Subdivision Stability Exponent Enclosure" (scheme_of s)
    (Printf.sprintf "Enclosure (Exponent %s %s %s) %s\n%s" (natural low.order) (fraction low.bound)
       (certificate low.of_radius) (fraction c.radius_least) shifts)
    (Printf.sprintf
       "enclosure_holds : enclosure_holds %s_scheme %s %s.\n\
        Proof. apply (check_exponent_sound _ _ _ %s_certificate). vm_compute. reflexivity. Qed"
       name (fraction l) (fraction u) name)
