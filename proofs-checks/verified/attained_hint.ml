(* Polytopes that attain the radius: what the lines `root`, `cycle`, `seed`, `origin` and `same` of a certificate say, written
   out for the checker. The flips and images under groups of true points are true points like others, stemming from images of
   the bases. Nothing here is proved: what is wrong is not accepted. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith
open Text
open Sections

(* ---- where the number is ----------------------------------------------------------------------------------------- *)

type root_line = { re : Q.t; im : Q.t; error : Q.t; low_bound : Q.t; high_bound : Q.t }

let square x = Q.mul x x
let over s x = Z.divexact (Z.mul (Q.num x) s) (Q.den x)
let words bits = 1 + (bits / 640)

let value_at s x p =
  let long = words (Z.numbits s) and length = List.length p in
  spend (length * length * long * long);
  let _, (value, slope) = taylor s x p in
  (value, slope)

(* The line `root`, which must be right in the sense of SPEC.md, too. *)
let read_root r (e : exact_number) =
  match List.map rational (take r "root" 5 5) with
  | [ re; im; eps; low; high ] ->
      let disc x = Q.make x e.disc_scale and root = e.root in
      require (Q.sign eps >= 0 && Q.sign low > 0 && Q.sign high > 0) "the error of a root is negative, or its modulus not positive";
      let slack = Q.sub (disc e.disc_radius) eps in
      let away = Q.add (square (Q.sub re (disc e.disc_re))) (square (Q.sub im (disc e.disc_im))) in
      require (Q.sign slack >= 0 && Q.leq away (square slack)) "the root is not the one of the claim";
      let modulus = Q.add (square re) (square im) and lower = power low root and upper = power high root in
      require
        (Q.leq (square (Q.add lower eps)) modulus && Q.geq upper eps && Q.leq modulus (square (Q.sub upper eps)))
        "the bounds of the exact radius are wrong";
      let s = Z.lcm (Q.den re) (Q.den im) in
      let x = (over s re, over s im) and degree = List.length e.polynomial - 1 in
      let value, slope = value_at s x e.polynomial in
      let allowed = Q.mul (square eps) (Q.of_bigint (Z.mul (Z.mul s s) (zsquare slope))) in
      (* value and slope have the same power of s, the slope is that of the polynomial *)
      require
        (Z.sign (zsquare slope) > 0
        && Q.leq (Q.of_bigint (Z.mul (Z.of_int (degree * degree)) (Z.mul (zsquare value) (Z.mul s s)))) allowed)
        "no zero is proved so near";
      require (one_zero e) "more than one zero may be so near";
      { re; im; error = eps; low_bound = low; high_bound = high }
  | _ -> assert false

(* A better approximation of the zero over 2^bits, by Newton's iteration; that of the line if it is exact. *)
let approximate (e : exact_number) root bits =
  let s = Z.lcm (Q.den root.re) (Q.den root.im) in
  let exact = (over s root.re, over s root.im) in
  let value, _ = value_at s exact e.polynomial in
  if value = (Z.zero, Z.zero) then (exact, s, Z.zero)
  else begin
    let more = bits + 64 in
    let times (a, b) (c, d) =
      (Z.shift_right (Z.sub (Z.mul a c) (Z.mul b d)) more, Z.shift_right (Z.add (Z.mul a d) (Z.mul b c)) more)
    in
    let plus (a, b) (c, d) = (Z.add a c, Z.add b d) in
    let cut x = Z.fdiv (Z.shift_left (Q.num x) more) (Q.den x) in
    let step x =
      let value, slope =
        List.fold_left
          (fun (v, d) c -> (plus (Z.shift_left c more, Z.zero) (times x v), plus v (times x d)))
          ((Z.zero, Z.zero), (Z.zero, Z.zero))
          (List.rev e.polynomial)
      in
      let (a, b), (c, d) = (value, slope) in
      let below = zsquare slope in
      require (Z.sign below > 0) "no zero is proved so near";
      let quotient x = Z.fdiv (Z.shift_left x more) below in
      let back = (quotient (Z.add (Z.mul a c) (Z.mul b d)), quotient (Z.sub (Z.mul b c) (Z.mul a d))) in
      ((Z.sub (fst x) (fst back), Z.sub (snd x) (snd back)), Z.max (Z.abs (fst back)) (Z.abs (snd back)))
    in
    let rec iterate x left =
      let next, moved = step x in
      if left = 0 || Z.numbits moved <= 48 then next else iterate next (left - 1)
    in
    spend (12 * List.length e.polynomial * words more * words more);
    let x, y = iterate (cut root.re, cut root.im) 12 in
    let back x = Z.shift_right (Z.add x (Z.shift_left Z.one 63)) 64 in
    let y = if Q.sign root.im = 0 then Z.zero else back y in
    let x = back x and s = Z.shift_left Z.one bits in
    let value, slope = value_at s (x, y) e.polynomial in
    let ratio = Z.fdiv (Z.mul (Z.mul (Z.of_int 4) (Z.mul s s)) (zsquare value)) (Z.max Z.one (zsquare slope)) in
    ((x, y), s, if value = (Z.zero, Z.zero) then Z.zero else Z.add (Z.sqrt ratio) Z.one)
  end

(* Binary digits of the bounds of the number, and more of the zero. With `margin` there are so many more of all. *)
let bound_bits = 256
let least_bits = bound_bits + 64

(* The zero to so many bits, and bounds of the number: those of the line where they are equal. *)
let place_of ?(margin = 0) (e : exact_number) root bits =
  let bound_bits = bound_bits + margin in
  let (near_re, near_im), near_scale, near_radius = approximate e root (bits + margin) in
  if Q.equal root.low_bound root.high_bound then
    { near_re; near_im; near_radius; near_scale; low = Q.num root.low_bound; high = Q.num root.low_bound; bottom = Q.den root.low_bound }
  else begin
    let fine x = Z.shift_left x bound_bits in
    let bottom = fine Z.one and twice = fine (Z.mul (Z.of_int 2) near_radius) in
    let whole = Z.pow bottom e.root and modulus = Z.sqrt (fine (fine (zsquare (near_re, near_im)))) in
    let root_of x = if Z.sign x <= 0 then Z.zero else Z.root x e.root in
    let low = root_of (Z.fdiv (Z.mul (Z.sub modulus twice) whole) (fine near_scale)) in
    let high = Z.succ (root_of (Z.cdiv (Z.mul (Z.succ (Z.add modulus twice)) whole) (fine near_scale))) in
    { near_re; near_im; near_radius; near_scale; low; high; bottom }
  end

(* The zero as the line `root` says it. *)
let coarse root place =
  let s = Z.lcm (Q.den root.error) (Z.lcm (Q.den root.re) (Q.den root.im)) in
  { place with near_re = over s root.re; near_im = over s root.im; near_radius = over s root.error; near_scale = s }

(* ---- cycles, origins and equal images ---------------------------------------------------------------------------- *)

type cycle = {
  first : int; turn : element; letters_of : int list; (* the first one is applied first *)
  coefficients_of : vector array; seed_of : vector }

(* Image t of vertex j is the image of vertex k under the element: because a cycle closes, or by a line `same`. *)
type equal_image = int * int * int * element

type draft = {
  polytope : polytope; cycles : cycle array; parents : (int * int) option array; closed : equal_image list; equal : equal_image list;
  extra_bits : int; bits_needed : int; margin : int }

let scaled c = Array.map (Z.mul c)
let added = Array.map2 Z.add

(* The line `seed`, whose images `around` a cycle give the coefficients of an eigenvector: they and the seed. `around` is
   that of integers, with the power of the denominator of the family that belongs to the length of the cycle. *)
let read_seed r family (e : exact_number) zero around =
  let n = family.size in
  let seed = Array.of_list (List.map integer (take r "seed" n n)) in
  let p = Array.of_list e.polynomial in
  let degree = Array.length p - 1 and whole = Z.pow family.denominator e.root in
  let seed = scaled (Z.pow whole (degree - 1)) seed in
  let ys = Array.make degree [||] in
  ys.(degree - 1) <- scaled p.(degree) seed;
  for k = degree - 1 downto 1 do
    ys.(k - 1) <- added (Array.map (fun x -> Z.divexact x whole) (around ys.(k))) (scaled p.(k) seed)
  done;
  require
    (Array.for_all (fun x -> Z.sign x = 0) (added (around ys.(0)) (scaled (Z.mul p.(0) whole) seed)))
    "the polynomial of the cycle does not vanish on the seed";
  let common = Array.fold_left (Array.fold_left Z.gcd) (Array.fold_left Z.gcd Z.zero seed) ys in
  require (Z.sign common > 0) zero;
  let less = Array.map (fun x -> Z.divexact x common) in
  (Array.map less ys, less seed)

(* Image of a vector under a letter, `copies` times. *)
let moving_by copies family =
  let n = family.size and matrices = Array.of_list (List.map array_of family.matrices) in
  let matrix_bits = Array.fold_left (fun m a -> max m (bits_of a)) 0 matrices in
  fun x t ->
    spend (2 * copies * n * n * words (widest x) * words matrix_bits);
    apply matrices.(t) 1 x

let zero_vertex = "the eigenvector of a cycle may be zero where the vertex is large"

let read_cycle r polytope (e : exact_number) =
  let family = polytope.body_family and count = Array.length polytope.vertices in
  let letters = List.length family.matrices in
  match take r "cycle" (2 + e.root) (2 + e.root) with
  | first :: word :: rest ->
      let first = size first 0 (count - 1) in
      require (word <> "") "a cycle has a word, or '-'";
      let turn = polytope.element_of (if word = "-" then "" else word) in
      let letters_of = List.map (fun f -> size f 0 (letters - 1)) rest in
      (* the checker does the same once for each element of the group *)
      let moved = moving_by (Array.length polytope.group) family in
      let around x = apply turn.map 1 (List.fold_left moved x letters_of) in
      let coefficients_of, seed_of = read_seed r family e zero_vertex around in
      { first; turn; letters_of; coefficients_of; seed_of }
  | _ -> assert false

let pad n x = let x = Array.of_list x in Array.init n (fun i -> if i < Array.length x then x.(i) else Z.zero)

(* A vector as the checker has it. *)
let pair_of n (x : vector) = (Array.to_list (Array.sub x 0 n), if Array.length x = n then [] else Array.to_list (Array.sub x n n))

(* At the zero, which is known well enough. *)
let evaluated n place conjugated coefficients =
  let im = if conjugated then Z.neg place.near_im else place.near_im in
  let (x, y), error = evaluate n place.near_scale place.near_re im place.near_radius (Array.to_list (Array.map (pair_of n) coefficients)) in
  (Array.append (pad n x) (pad n y), error)

(* The multiple of the eigenvector that is near the vertex: complex factors over 2^bits. *)
let factor_of polytope place cycle =
  let n = polytope.body_family.size and start = 512 in
  let u, _ = evaluated n place false (Array.map (Array.map (fun x -> Z.shift_left x start)) cycle.coefficients_of) in
  let vertex = polytope.vertices.(cycle.first) in
  let re i = vertex.(i) and im i = if polytope.parts = 2 then vertex.(n + i) else Z.zero in
  let length i = Z.add (Z.abs (re i)) (Z.abs (im i)) in
  let pivot = ref 0 in
  for i = 1 to n - 1 do if Z.gt (length i) (length !pivot) then pivot := i done;
  let i = !pivot in
  let a = u.(i) and b = if polytope.parts = 2 then u.(n + i) else Z.zero in
  let below = Z.add (Z.mul a a) (Z.mul b b) in
  require (Z.sign below > 0 && Z.sign (length i) > 0) zero_vertex;
  let extra = max 64 (160 + Z.numbits (Z.max (Z.abs a) (Z.abs b)) - start - Z.numbits (length i)) in
  let factor bits =
    let quotient x = Z.fdiv (Z.shift_left x (bits + start)) below in
    ( quotient (Z.add (Z.mul (re i) a) (Z.mul (im i) b)), quotient (Z.sub (Z.mul (im i) a) (Z.mul (re i) b)) )
  in
  (extra, factor)

(* A real vector times a complex number *)
let times_factor parts (a, b) x = if parts = 1 then scaled a x else Array.append (scaled a x) (scaled b x)

(* Bits that so many images, one of another, take *)
let margin_of family place depth =
  let most = List.fold_left (fun m a -> Z.max m (column_norm a)) Z.one family.matrices in
  let growth = Z.cdiv (Z.mul most place.bottom) (Z.mul family.denominator (Z.max Z.one place.low)) in
  min 16384 (depth * Z.numbits growth)

let read_lines r polytope (e : exact_number) root place =
  let count = Array.length polytope.vertices and letters = List.length polytope.body_family.matrices in
  require (polytope.parts = 2 || (Q.sign root.im = 0 && Z.sign e.disc_im = 0)) "a real polytope, but no real eigenvalue";
  let cycles = ref [] and taken = Array.make count false in
  while at r "cycle" do
    let cycle = read_cycle r polytope e in
    require (not taken.(cycle.first)) "a vertex is the first one of two cycles";
    taken.(cycle.first) <- true;
    cycles := cycle :: !cycles
  done;
  let parents = Array.make count None in
  for j = 0 to count - 1 do
    let head = Printf.sprintf "origin %d" j in
    if at r head then
      match take r head 2 2 with
      | [ parent; letter ] ->
          require (j > 0 && not taken.(j)) "the first vertex of a cycle is no image";
          parents.(j) <- Some (size parent 0 (j - 1), size letter 0 (letters - 1))
      | _ -> assert false
  done;
  let cycles = Array.of_list (List.rev !cycles) in
  (* the last image of a cycle is its first vertex, up to a factor and the group *)
  let inverse g =
    let identity = fst (normal polytope.group.(0).map) in
    List.find (fun h -> fst (normal (multiply g.map h.map)) = identity) (Array.to_list polytope.group)
  in
  let close cycle =
    let rec follow at = function
      | [] -> assert false
      | [ last ] -> (at, last, cycle.first, inverse cycle.turn)
      | t :: rest ->
          let rec search j =
            if j = count then reject "a vertex of a cycle is missing" else if parents.(j) = Some (at, t) then j else search (j + 1)
          in
          follow (search 0) rest
    in
    follow cycle.first cycle.letters_of
  in
  let closed = Array.to_list (Array.map close cycles) and equal = ref [] in
  while at r "same" do
    match take r "same" 3 3 with
    | [ source; letter; target ] ->
        let k, word = split_index target count in
        let element = polytope.element_of word in
        equal := (size source 0 (count - 1), size letter 0 (letters - 1), k, element) :: !equal
    | _ -> assert false
  done;
  (* errors grow with each image by the norm of a matrix over the radius *)
  let margin =
    let depth = Array.make count 0 in
    Array.iteri (fun j parent -> Option.iter (fun (k, _) -> depth.(j) <- depth.(k) + 1) parent) parents;
    margin_of polytope.body_family place (Array.fold_left max 0 depth)
  in
  let factors = Array.map (factor_of polytope place) cycles in
  let extra_bits = margin + Array.fold_left (fun m (extra, _) -> max m extra) 64 factors in
  let cycles =
    Array.map2
      (fun cycle (_, factor) ->
        let times = times_factor polytope.parts (factor extra_bits) in
        { cycle with coefficients_of = Array.map times cycle.coefficients_of; seed_of = times cycle.seed_of })
      cycles factors
  in
  let longest = Array.fold_left (fun m c -> Array.fold_left (Array.fold_left (fun m x -> max m (Z.numbits x))) m c.coefficients_of) 0 cycles in
  let bits_needed = 256 + max 0 (longest - polytope.vertex_bits - extra_bits) in
  { polytope; cycles; parents; closed; equal = List.rev !equal; extra_bits; bits_needed; margin }

(* ---- written out ------------------------------------------------------------------------------------------------- *)

type key = Given of vector | Eigenvector of int * bool * vector | Image of int * int

let write_out draft (e : exact_number) root place =
  let { polytope; cycles; parents; closed; equal; extra_bits; _ } = draft in
  let family = polytope.body_family and group = polytope.group and parts = polytope.parts in
  let n = family.size and count = List.length family.matrices in
  let matrices = Array.of_list (List.map array_of family.matrices) in
  let sides = if parts = 2 then [ false; true ] else [ false ] in
  let long = words (polytope.vertex_bits + extra_bits) in
  let matrix_bits = List.fold_left (List.fold_left (List.fold_left (fun m x -> max m (Z.numbits x)))) 0 family.matrices in
  spend (Array.length polytope.vertices * Array.length group * parts * parts * n * n * long * words matrix_bits);
  let turned element side x =
    let x = if side then conjugate n x else x in
    if element == group.(0) then x else apply element.map (Array.length x / n) x
  in
  let before element t =
    let rec search k = if element.letters.(k) = t then k else search (k + 1) in
    search 0
  in
  (* bases *)
  let bases = ref [] and base_count = ref 0 and base_numbers = Hashtbl.create 97 in
  let add_base make =
    let k = !base_count in
    incr base_count;
    let base = make k in
    bases := (k, base) :: !bases;
    k
  in
  let given x = add_base (fun _ -> { vectors = [ pair_of n x ]; conjugated = false; previous = None }) in
  let rec eigenvector c side element =
    let cycle = cycles.(c) in
    let seed = turned element side cycle.seed_of and vectors = Array.map (turned element side) cycle.coefficients_of in
    (* by all vectors: another product may have the same seed *)
    match Hashtbl.find_opt base_numbers (c, side, vectors) with
    | Some k -> k
    | None ->
        add_base (fun k ->
            Hashtbl.add base_numbers (c, side, vectors) k;
            let around = compose element cycle.turn in
            let from = eigenvector c side around in
            let word = List.rev_map (before around) cycle.letters_of in
            { vectors = Array.to_list (Array.map (pair_of n) vectors);
              conjugated = side; previous = Some (from, (word, pair_of n seed)) })
  in
  let roots = Hashtbl.create 97 in
  Array.iteri (fun c cycle -> Hashtbl.add roots cycle.first c) cycles;
  (* points: those of all vertices under the group, up to signs *)
  let index = Hashtbl.create 97 in
  Array.iteri (fun k element -> Hashtbl.replace index (fst (normal element.map)) k) group;
  let index_of element = Hashtbl.find index (fst (normal element.map)) in
  let numbers = Hashtbl.create 997 and table = Hashtbl.create 997 and points = ref [] and point_count = ref 0 in
  let children = Hashtbl.create 997 in
  let shown = Hashtbl.create 997 and paths = Hashtbl.create 997 in
  (* The number of a point, and whether the one that is asked for is its negative; `own` says that of what `vector` gives. *)
  let enter key origin negative own source vector path =
    match Hashtbl.find_opt numbers key with
    | Some (number, own) -> (number, negative <> own)
    | None ->
        incr point_count;
        let number = !point_count in
        Hashtbl.add numbers key (number, own);
        Hashtbl.add shown number (vector ());
        Hashtbl.add paths number (path ());
        points := (number, origin, source ()) :: !points;
        (number, negative <> own)
  in
  let r_top = Z.mul family.denominator place.low in
  let image_over_r t x = Array.map (fun a -> Z.fdiv (Z.mul a place.bottom) r_top) (apply matrices.(t) parts x) in
  let nearer j parent t =
    (* the sign with which the image is near the vertex *)
    let image = apply matrices.(t) parts polytope.vertices.(parent) in
    let off sign =
      let sum = ref Z.zero in
      Array.iteri
        (fun i a ->
          let b = Z.mul r_top polytope.vertices.(j).(i) in
          sum := Z.add !sum (Z.abs (Z.sub (Z.mul place.bottom a) (if sign then Z.neg b else b))))
        image;
      !sum
    in
    Z.lt (off true) (off false)
  in
  Array.iteri
    (fun j vertex ->
      let negative_origin = match parents.(j) with Some (parent, t) -> (not polytope.cone) && nearer j parent t | None -> false in
      Array.iteri
        (fun h element ->
          List.iter
            (fun side ->
              let origin = (element, side, j) in
              let place_of_point =
                match (parents.(j), Hashtbl.find_opt roots j) with
                | Some (parent, t), _ ->
                    let letter = before element t in
                    let from, negative = Hashtbl.find table (h, side, parent) in
                    let ((number, _) as point) =
                      enter (Image (from, letter)) origin (negative <> negative_origin) false
                        (fun () -> FromPoint (Z.of_int from, letter))
                        (fun () -> image_over_r letter (Hashtbl.find shown from))
                        (fun () -> let base, path = Hashtbl.find paths from in (base, letter :: path))
                    in
                    Hashtbl.replace children (from, letter) number;
                    point
                | None, Some c ->
                    let all = Array.map (turned element side) cycles.(c).coefficients_of in
                    let coefficients, negative = normal_vector (Array.concat (Array.to_list all)) in
                    let base = lazy (eigenvector c side element) in
                    enter (Eigenvector (c, side, coefficients)) origin negative negative
                      (fun () -> FromBase (Lazy.force base))
                      (fun () ->
                        let x, _ = evaluated n place side (Array.map (turned element side) cycles.(c).coefficients_of) in
                        if parts = 2 then x else Array.sub x 0 n)
                      (fun () -> (Lazy.force base, []))
                | None, None ->
                    let x = Array.map (fun a -> Z.shift_left a extra_bits) (turned element side vertex) in
                    let key, negative = normal_vector x in
                    let base = lazy (given x) in
                    enter (Given key) origin negative negative (fun () -> FromBase (Lazy.force base)) (fun () -> x)
                      (fun () -> (Lazy.force base, []))
              in
              Hashtbl.replace table (h, side, j) place_of_point)
            sides)
        group)
    polytope.vertices;
  let lookup (element, side, j) = Hashtbl.find table (index_of element, side, j) in
  let convert flip terms =
    List.map
      (fun (number, (a, b)) ->
        let number, negative = lookup polytope.point_origins.(number - 1) in
        (Z.of_int number, if negative <> flip then (Z.neg a, Z.neg b) else (a, b)))
      terms
  in
  (* equal images *)
  let ordered = List.map snd (List.sort (fun (k, _) (j, _) -> compare k j) !bases) in
  let turns number t target =
    let base, path = Hashtbl.find paths number and base', path' = Hashtbl.find paths target in
    let more = List.length path' - (List.length path + 1) in
    let a, b =
      if more mod e.root <> 0 || (more <> 0 && (List.nth ordered base).previous = None) then (0, 0)
      else (max 0 (more / e.root), max 0 (-more / e.root))
    in
    (match (walk ordered a base, walk ordered b base') with
    | Some (j, v), Some (j', w) when polytope.cone || not (j = j' && (t :: path) @ v = path' @ w) ->
        let applied = List.length path + List.length v + List.length path' + List.length w + 1 in
        spend (applied * List.length (List.nth ordered j).vectors * parts * n * n * long)
    | _ -> ());
    (a, b)
  in
  let check (j, t, k, element) =
    let number, _ = lookup (group.(0), false, j) and target, _ = lookup (element, false, k) in
    let base, path = Hashtbl.find paths number and base', path' = Hashtbl.find paths target in
    let a, b = turns number t target in
    require (linked family ordered base (t :: path) a base' path' b) "an image is not the vertex that it is said to be"
  in
  List.iter check closed;
  if not polytope.cone then List.iter check equal;
  let met = Hashtbl.create 97 in
  let meet link = List.iter (fun (j, t, k, element) -> Hashtbl.replace met (j, t) (link, k, element)) in
  meet (fun i a b -> if polytope.cone then Below (i, a, b) else Link (i, a, b)) equal;
  meet (fun i a b -> Link (i, a, b)) closed;
  let all = List.rev !points in
  let image (number, ((element, side, j) as origin), _) t =
    match Hashtbl.find_opt children (number, t) with
    | Some child -> Link (Z.of_int child, 0, 0)
    | None -> (
        match Hashtbl.find_opt met (j, element.letters.(t)) with
        | Some (link, k, word) ->
            let target, _ = lookup (compose element word, side, k) in
            let a, b = turns number t target in
            link (Z.of_int target) a b
        | None ->
            let _, negative = lookup origin in
            Inside (convert negative (polytope.line_of origin t)))
  in
  let given = List.map (fun ((number, _, source) as point) -> (source, (pair_of n (Hashtbl.find shown number), List.init count (image point)))) all in
  let first_base = Hashtbl.find base_numbers (0, false, cycles.(0).coefficients_of) in
  let rec around k steps =
    match (List.nth ordered k).previous with
    | Some (k', _) -> if k' = first_base then steps + 1 else around k' (steps + 1)
    | None -> assert false
  in
  let unit_one = Z.shift_left polytope.weight_one (polytope.vertex_bits + extra_bits) in
  let unit_lines = List.map (convert false) polytope.units in
  (* the given vertices must be near the true ones, and known that well from the line `root` alone *)
  let listed = number Z.one (List.map (fun (_, (x, _)) -> x) given) in
  let units, rest = match units polytope.cone listed unit_one 0 unit_lines with Some bounds -> bounds | None -> (Z.zero, unit_one) in
  let near off = require (Z.lt (Z.mul (Z.of_int 16) (Z.mul units off)) (Z.sub unit_one rest)) "the true vertices are too far from the given ones" in
  Array.iteri
    (fun j vertex ->
      let number, negative = lookup (group.(0), false, j) in
      let off = ref Z.zero in
      Array.iteri
        (fun k a ->
          let b = Z.shift_left vertex.(k) extra_bits in
          off := Z.add !off (Z.abs (if negative then Z.add a b else Z.sub a b)))
        (Hashtbl.find shown number);
      near !off)
    polytope.vertices;
  let coarse = coarse root place in
  Array.iter (fun cycle -> near (snd (evaluated n coarse false cycle.coefficients_of))) cycles;
  let terms = List.fold_left (fun s (_, (_, l)) -> List.fold_left (fun s i -> match i with Inside ts -> s + List.length ts | _ -> s + 1) s l) 0 given in
  spend (((terms * parts * parts) + (List.length given * parts * count * n * 3)) * n * long);
  let body =
    { cone = polytope.cone; bases = ordered; given; weight_one = polytope.weight_one;
      unit_one; unit_lines; first_base; full_turn = around first_base 0 }
  in
  Attains (polytope.turned, body)
