(* What the lines `cycle`, `seed`, `rest` and `origin` of the certificate of a joint spectral subradius say, written out for
   the checker: section 4.15 of SPEC.md. Nothing here is proved: what is wrong is not accepted. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith
open Text
open Sections
open Attained_hint

(* Factors are rounded up to multiples of 2^-512. *)
let factor_scale = Z.shift_left Z.one 512
let factor_of x = Z.cdiv (Z.mul (Q.num x) factor_scale) (Q.den x)
let rounded_up x = Q.make (factor_of x) factor_scale
let largest = List.fold_left Q.max Q.zero
let whole = Q.of_bigint

(* True vertices are at least the given ones, and at most these multiples of them. *)
type draft = {
  body_family : family; (* transposed, if the climb says so *)
  climb : climb; vertices : vector array; letters_of : int list; (* the first one is applied first *)
  coefficients_of : vector array; seed_of : vector;
  off : Q.t; (* error of the eigenvector at the point of the line `root` *)
  alpha : Q.t; (* the first true vertex is so many times the eigenvector *)
  rest : vector; parents : (int * int) array; factors : Q.t array; children : (int * int, int) Hashtbl.t;
  closing : int * int (* vertex and letter of the image that closes the cycle *) }

(* u of section 4.10, the error of the eigenvector *)
let error_of coefficients root =
  let norm y = whole (Array.fold_left (fun sum a -> Z.add sum (Z.abs a)) Z.zero y) in
  let size = Q.add (Q.abs root.re) root.error in
  let slope = ref Q.zero and powers = ref Q.one in
  for k = 1 to Array.length coefficients - 1 do
    slope := Q.add !slope (Q.mul (Q.of_int k) (Q.mul !powers (norm coefficients.(k))));
    powers := rounded_up (Q.mul !powers size)
  done;
  Q.mul (Q.of_int 2) (Q.mul root.error !slope)

(* The line `seed`: the coefficients and the seed, the error, alpha, and the factor of the first vertex *)
let read_eigenvector r family (e : exact_number) root vertex letters_of =
  let degree = List.length e.polynomial - 1 in
  let around x = List.fold_left (moving_by 1 family) x letters_of in
  let coefficients, seed = read_seed r family e "a seed is 0" around in
  require (Q.sign root.im = 0 && Z.sign e.disc_im = 0) "the eigenvalue is not real";
  let long = width (bits_of coefficients + (degree * max (Z.numbits (Q.num root.re)) (Z.numbits (Q.den root.re)))) in
  spend_times degree (family.size * long * long);
  let off = error_of coefficients root in
  let value i = Array.fold_right (fun y x -> Q.add (whole y.(i)) (Q.mul root.re x)) coefficients Q.zero in
  let values = Array.init family.size value in
  let positive = List.filter (fun i -> Z.sign vertex.(i) > 0) (List.init family.size Fun.id) in
  let negative = Q.sign values.(List.hd positive) < 0 in
  let values = if negative then Array.map Q.neg values else values in
  let sign x = if negative then negate x else x in
  let right i a = if Z.sign a > 0 then Q.gt values.(i) off else Array.for_all (fun y -> Z.sign y.(i) = 0) coefficients in
  let same_zeros = "the eigenvector may be zero where vertex 0 is not, or is not where that is" in
  Array.iteri (fun i a -> require (right i a) same_zeros) vertex;
  let alpha = largest (List.map (fun i -> Q.div (whole vertex.(i)) (Q.sub values.(i) off)) positive) in
  let factor i = Q.div (Q.mul alpha (Q.add values.(i) off)) (whole vertex.(i)) in
  (Array.map sign coefficients, sign seed, off, alpha, rounded_up (largest (List.map factor positive)))

(* The line `rest`, with zeros where the first vertex has none; no numbers if it has no zeros *)
let read_rest r family (e : exact_number) root vertex letters_of =
  let n = family.size in
  if Array.for_all (fun a -> Z.sign a > 0) vertex then [||]
  else begin
    let read text =
      let x = integer text in
      require (Z.sign x > 0) "a number of the rest is not positive";
      x
    in
    let all = Array.of_list (List.map read (take r "rest" n n)) in
    let rest = Array.mapi (fun i x -> if Z.sign vertex.(i) = 0 then x else Z.zero) all in
    let moved = List.fold_left (moving_by 1 family) rest letters_of in
    let allowed = power (Q.mul (whole family.denominator) root.low_bound) e.root in
    let right i x = Z.sign x = 0 || Q.leq (whole moved.(i)) (Q.mul allowed (whole x)) in
    Array.iteri (fun i x -> require (right i x) "the product takes the rest to more than the power of the exact subradius") rest;
    rest
  end

(* A line `origin`: the parent, the letter, and the factor *)
let read_origin r family root vertices factors j =
  match take r (Printf.sprintf "origin %d" j) 2 2 with
  | [ parent; letter ] ->
      let parent = size parent 0 (j - 1) and letter = size letter 0 (List.length family.matrices - 1) in
      let moved = moving_by 1 family vertices.(parent) letter in
      let part i a =
        let image = Q.div (whole moved.(i)) (whole family.denominator) and vertex = whole a in
        require
          (Q.leq (Q.mul root.high_bound vertex) image && (Z.sign a > 0 || Q.sign image = 0))
          "a vertex is not below the image that it is said to be";
        if Z.sign a = 0 then Q.zero else Q.div image (Q.mul root.low_bound vertex)
      in
      factors.(j) <- rounded_up (Q.mul factors.(parent) (largest (Array.to_list (Array.mapi part vertices.(j)))));
      (parent, letter)
  | _ -> assert false

(* The vertex and the letter that close the cycle *)
let close children letters_of =
  let rec follow at = function
    | [] -> assert false
    | [ last ] -> (at, last)
    | t :: rest -> (
        match Hashtbl.find_opt children (at, t) with
        | Some next -> follow next rest
        | None -> reject "a vertex of the cycle is missing")
  in
  follow 0 letters_of

let sum_of terms = List.fold_left (fun sum (_, (weight, _)) -> Z.add sum weight) Z.zero terms

let read r family climb (e : exact_number) root =
  let family = if climb.climb_transposed then transpose family else family in
  let vertices = Array.of_list (List.map (fun (x, _) -> Array.of_list x) climb.climb_points) in
  let count = Array.length vertices and letters = List.length family.matrices in
  let letters_of =
    match take r "cycle" (2 + e.root) (2 + e.root) with
    | first :: word :: rest ->
        ignore (size first 0 0);
        require (word = "-") "the cycle of a subradius has no word";
        List.map (fun f -> size f 0 (letters - 1)) rest
    | _ -> assert false
  in
  let coefficients_of, seed_of, off, alpha, first = read_eigenvector r family e root vertices.(0) letters_of in
  let rest = read_rest r family e root vertices.(0) letters_of in
  let factors = Array.make count first and parents = Array.make count (0, 0) and children = Hashtbl.create 97 in
  for j = 1 to count - 1 do
    parents.(j) <- read_origin r family root vertices factors j;
    Hashtbl.replace children parents.(j) j
  done;
  let closing = close children letters_of in
  let least = Q.mul root.high_bound (largest (Array.to_list factors)) in
  let right j t terms =
    let exceeds = Q.leq (Q.mul least (whole climb.climb_scale)) (whole (sum_of terms)) in
    require (exceeds || Hashtbl.mem children (j, t) || closing = (j, t)) (Printf.sprintf "image %d %d may be too small" j t)
  in
  List.iteri (fun j -> List.iteri (right j)) climb.climb_terms;
  { body_family = family; climb; vertices; letters_of; coefficients_of; seed_of; off; alpha; rest; parents; factors; children;
    closing }

(* Where the number is: bounds of it as near as is known, and the zero so near that the errors of the eigenvector are
   small beside those of the line `root`. Also the bits by which its coefficients are made longer for that. *)
let place_of draft (e : exact_number) root =
  let degree = Array.length draft.coefficients_of and numbits x = Z.numbits (Z.cdiv (Q.num x) (Q.den x)) in
  let smaller x = max 0 (Z.numbits (Q.den x) - Z.numbits (Q.num x) + 1) in
  let powers = degree * (1 + numbits (Q.add (Q.abs root.re) root.error)) in
  let more = 64 + powers + Z.numbits (Z.of_int (degree * draft.body_family.size)) in
  let place = Attained_hint.place_of e root (max least_bits (more + smaller root.error)) in
  let low = Q.max root.low_bound (Q.make place.low place.bottom) and high = Q.min root.high_bound (Q.make place.high place.bottom) in
  let bottom = Z.lcm (Q.den low) (Q.den high) in
  ({ place with low = over bottom low; high = over bottom high; bottom }, more + smaller draft.off)

let write_out draft (e : exact_number) root =
  let { body_family = family; climb; vertices; coefficients_of; parents; children; closing; _ } = draft in
  let n = family.size and count = List.length family.matrices in
  let place, bits = place_of draft e root in
  let degree = Array.length coefficients_of in
  let scale = if Z.sign place.near_radius = 0 then Z.pow place.near_scale (degree - 1) else Z.shift_left Z.one bits in
  let long = width (bits_of coefficients_of + Z.numbits scale + Z.numbits place.near_scale) in
  spend_times degree (4 * n * n * long * long);
  let longer x = Array.to_list (scaled scale x) in
  let vectors = List.map (fun y -> (longer y, [])) (Array.to_list coefficients_of) in
  let word = List.rev draft.letters_of in
  let eigenvector_base = { vectors; conjugated = false; previous = Some (0, (word, (longer draft.seed_of, []))) } in
  let paths = Array.make (Array.length vertices) [] and depths = Array.make (Array.length vertices) 0 in
  let peak j terms =
    let parent, letter = parents.(j) in
    if j > 0 then begin
      paths.(j) <- letter :: paths.(parent);
      depths.(j) <- depths.(parent) + 1
    end;
    spend ((count + 1) * (depths.(j) + 1));
    let rise t terms =
      match Hashtbl.find_opt children (j, t) with
      | Some child -> Reaches (Z.of_int (child + 1))
      | None -> if closing = (j, t) then Reaches Z.one else Exceeds terms
    in
    { peak_given = Array.to_list vertices.(j); peak_factor = factor_of draft.factors.(j); peak_word = paths.(j);
      peak_origin = Z.of_int (parent + 1); peak_rises = List.mapi rise terms }
  in
  let peaks = List.mapi peak climb.climb_terms in
  let eigenvector_multiple = bound_of (Q.div draft.alpha (whole scale)) in
  ( place,
    { ascent_transposed = climb.climb_transposed; eigenvector_base; eigenvector_multiple; beside = Array.to_list draft.rest;
      ascent_scale = climb.climb_scale; factor_scale; peaks } )
