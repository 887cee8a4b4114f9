(* What the lines `cycle`, `seed`, `rest`, `origin` and `same` of the certificate of a joint spectral subradius say, written out for
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

type vertex = {
  given : vector;
  factor : Q.t; (* the true vertex is the given one at least, and so many times it at most *)
  parent : int; path : int list; (* from the first vertex, the last letter first *)
  length : int; (* of the path *)
  cut : bool (* coordinates of it, or of one before it, were dropped *) }

(* Images of vertices under letters *)
type draft = {
  body_family : family; (* transposed, if the climb says so *)
  matrix_bits : int; climb : climb; vertices : vertex array;
  eigenvector : base; alpha : Q.t; (* the first true vertex is so many times that *)
  off : Q.t; (* error of the eigenvector at the point of the line `root` *)
  rest : vector; children : (int * int, int) Hashtbl.t; closing : int * int;
  same : (int * int, int * int * int) Hashtbl.t (* the vertex, and the turns before image and vertex *) }

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

(* The line `seed`: the eigenvector, alpha, its error, and the factor of the first vertex *)
let read_eigenvector r family moved (e : exact_number) root vertex letters_of =
  let degree = List.length e.polynomial - 1 in
  let around x = List.fold_left moved x letters_of in
  let coefficients, seed = read_seed r family e "a seed is 0" around in
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
  let point x = (Array.to_list (sign x), []) in
  let vectors = List.map point (Array.to_list coefficients) in
  let eigenvector = { vectors; conjugated = false; previous = Some (0, (List.rev letters_of, point seed)) } in
  (eigenvector, alpha, off, rounded_up (largest (List.map factor positive)))

(* The line `rest`, with zeros where the first vertex has none; no numbers if it has no zeros *)
let read_rest r family moved (e : exact_number) root vertex letters_of =
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
    let image = List.fold_left moved rest letters_of in
    let allowed = power (Q.mul (whole family.denominator) root.low_bound) e.root in
    let right i x = Z.sign x = 0 || Q.leq (whole image.(i)) (Q.mul allowed (whole x)) in
    Array.iteri (fun i x -> require (right i x) "the product takes the rest to more than the power of the exact subradius") rest;
    rest
  end

(* The line `origin` of vertex j, and its letter *)
let read_origin r family moved root vertices j given =
  match take r (Printf.sprintf "origin %d" j) 2 2 with
  | [ parent; letter ] ->
      let parent = size parent 0 (j - 1) and letter = size letter 0 (List.length family.matrices - 1) in
      let from = vertices.(parent) in
      let image = Array.map (fun x -> Q.make x family.denominator) (moved from.given letter) in
      let below i a = Q.leq (Q.mul root.high_bound (whole a)) image.(i) in
      Array.iteri (fun i a -> require (below i a) "a vertex is above the image from which it stems") given;
      let all = List.init family.size Fun.id in
      let zeros, positive = List.partition (fun i -> Z.sign given.(i) = 0) all in
      let cut = from.cut || List.exists (fun i -> Q.sign image.(i) > 0) zeros in
      let part i = Q.div image.(i) (Q.mul root.low_bound (whole given.(i))) in
      let factor = rounded_up (Q.mul from.factor (largest (List.map part positive))) in
      ({ given; factor; parent; path = letter :: from.path; length = from.length + 1; cut }, letter)
  | _ -> assert false

(* The image that closes the cycle *)
let close vertices children letters_of =
  let rec follow at = function
    | [] -> assert false
    | [ last ] -> (at, last)
    | t :: rest -> (
        match Hashtbl.find_opt children (at, t) with
        | Some next -> follow next rest
        | None -> reject "a vertex of the cycle is missing")
  in
  let ((last, _) as closing) = follow 0 letters_of in
  require (not vertices.(last).cut) "a vertex of the cycle is cut";
  closing

(* Two images of the eigenvector by words of so many letters *)
let spend_words family matrix_bits eigenvector vector_bits letters =
  let long = vector_bits + (letters * (matrix_bits + 8)) and n = family.size in
  spend_times (List.length eigenvector.vectors) (2 * letters * n * n * width matrix_bits * width long)

let bits_of_base base = List.fold_left (fun m (x, _) -> max m (widest_of x)) 0 base.vectors

(* A line `same`: the image, the vertex that it is above, and the turns before them *)
let read_same r family moved matrix_bits (e : exact_number) eigenvector needed vertices =
  match take r "same" 3 3 with
  | [ source; letter; target ] ->
      let count = Array.length vertices in
      let source = size source 0 (count - 1) and letter = size letter 0 (List.length family.matrices - 1) in
      let target = size target 0 (count - 1) in
      let x = vertices.(source) and y = vertices.(target) in
      let more = y.length - (x.length + 1) in
      let turns, others = if more mod e.root <> 0 then (0, 0) else (max 0 (more / e.root), max 0 (-more / e.root)) in
      let equal =
        if x.cut || y.cut || more mod e.root <> 0 then fun _ -> false
        else begin
          spend_words family matrix_bits eigenvector (bits_of_base eigenvector) (max (x.length + 1) y.length);
          equal_at family [ eigenvector ] 0 (letter :: x.path) turns 0 y.path others
        end
      in
      let image = moved x.given letter in
      let more_than i a = Q.geq (Q.make image.(i) family.denominator) (Q.mul needed (whole a)) in
      Array.iteri (fun i a -> require (equal i || more_than i a) "an image is not above the vertex that it is said to be") y.given;
      ((source, letter), (target, turns, others))
  | _ -> assert false

let sum_of terms = List.fold_left (fun sum (_, (weight, _)) -> Z.add sum weight) Z.zero terms

let read r family climb (e : exact_number) root =
  let family = if climb.climb_transposed then transpose family else family in
  let moved = moving_by 1 family and matrix_bits = bits_of_family family in
  let givens = Array.of_list (List.map (fun (x, _) -> Array.of_list x) climb.climb_points) in
  let letters_of =
    match take r "cycle" (2 + e.root) (2 + e.root) with
    | first :: word :: rest ->
        ignore (size first 0 0);
        require (word = "-") "the cycle of a subradius has no word";
        List.map (fun f -> size f 0 (List.length family.matrices - 1)) rest
    | _ -> assert false
  in
  let eigenvector, alpha, off, factor = read_eigenvector r family moved e root givens.(0) letters_of in
  let rest = read_rest r family moved e root givens.(0) letters_of in
  let first = { given = givens.(0); factor; parent = 0; path = []; length = 0; cut = false } in
  let vertices = Array.make (Array.length givens) first and children = Hashtbl.create 97 and same = Hashtbl.create 97 in
  for j = 1 to Array.length givens - 1 do
    let vertex, letter = read_origin r family moved root vertices j givens.(j) in
    vertices.(j) <- vertex;
    Hashtbl.replace children (vertex.parent, letter) j
  done;
  let closing = close vertices children letters_of in
  let needed = Q.mul root.high_bound (Array.fold_left (fun m x -> Q.max m x.factor) Q.zero vertices) in
  while at r "same" do
    let image, target = read_same r family moved matrix_bits e eigenvector needed vertices in
    Hashtbl.replace same image target
  done;
  let right j t terms =
    let exceeds = Q.leq (Q.mul needed (whole climb.climb_scale)) (whole (sum_of terms)) in
    let known = Hashtbl.mem children (j, t) || closing = (j, t) || Hashtbl.mem same (j, t) in
    require (exceeds || known) (Printf.sprintf "image %d %d may lie below" j t)
  in
  List.iteri (fun j -> List.iteri (right j)) climb.climb_terms;
  { body_family = family; matrix_bits; climb; vertices; eigenvector; alpha; off; rest; children; closing; same }

(* Where the number is: bounds of it as near as is known, and the zero so near that the errors of the eigenvector are
   small beside those of the line `root`. Also the bits by which its coefficients are made longer for that. *)
let place_of draft (e : exact_number) root =
  let degree = List.length e.polynomial - 1 and numbits x = Z.numbits (Z.cdiv (Q.num x) (Q.den x)) in
  let smaller x = max 0 (Z.numbits (Q.den x) - Z.numbits (Q.num x) + 1) in
  let powers = degree * (1 + numbits (Q.add (Q.abs root.re) root.error)) in
  let more = 64 + powers + Z.numbits (Z.of_int (degree * draft.body_family.size)) in
  let place = Attained_hint.place_of e root (max least_bits (more + smaller root.error)) in
  let low = Q.max root.low_bound (Q.make place.low place.bottom) and high = Q.min root.high_bound (Q.make place.high place.bottom) in
  let bottom = Z.lcm (Q.den low) (Q.den high) in
  ({ place with low = over bottom low; high = over bottom high; bottom }, more + smaller draft.off)

let write_out draft (e : exact_number) root =
  let { body_family = family; climb; eigenvector; _ } = draft in
  let place, bits = place_of draft e root in
  let degree = List.length e.polynomial - 1 and n = family.size in
  let scale = if Z.sign place.near_radius = 0 then Z.pow place.near_scale (degree - 1) else Z.shift_left Z.one bits in
  let vector_bits = bits_of_base eigenvector + Z.numbits scale in
  let long = width (vector_bits + Z.numbits place.near_scale) in
  spend_times degree (4 * n * n * long * long);
  let longer (x, _) = (List.map (Z.mul scale) x, []) in
  let eigenvector_base =
    { eigenvector with
      vectors = List.map longer eigenvector.vectors;
      previous = Option.map (fun (k, (word, seed)) -> (k, (word, longer seed))) eigenvector.previous }
  in
  let peak j terms =
    let x = draft.vertices.(j) in
    spend (2 * (x.length + 1));
    let rise t terms =
      match (Hashtbl.find_opt draft.children (j, t), Hashtbl.find_opt draft.same (j, t)) with
      | Some child, _ -> Reaches (Z.of_int (child + 1))
      | None, _ when draft.closing = (j, t) -> Closes
      | None, Some (target, turns, others) ->
          spend_words family draft.matrix_bits eigenvector vector_bits (x.length + 1 + (turns * e.root));
          Passes (Z.of_int (target + 1), turns, others)
      | None, None -> Exceeds terms
    in
    { peak_given = Array.to_list x.given; peak_factor = factor_of x.factor; peak_whole = not x.cut; peak_word = x.path;
      peak_origin = Z.of_int (x.parent + 1); peak_rises = List.mapi rise terms }
  in
  let peaks = List.mapi peak climb.climb_terms in
  let eigenvector_multiple = bound_of (Q.div draft.alpha (whole scale)) in
  ( place,
    { ascent_transposed = climb.climb_transposed; eigenvector_base; eigenvector_multiple; beside = Array.to_list draft.rest;
      ascent_scale = climb.climb_scale; factor_scale; peaks } )
