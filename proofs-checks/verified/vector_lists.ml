(* Claims about schemes of vectors, of one mask or of a list of them: the masks, and what a certificate says of the space, with what the
   checker wants beside: a functional that all masks keep. Of this only the masks that are read are trusted. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith
open Text
open Vectors

(* Masks of matrices of one size, over one denominator *)
let of_texts texts arity =
  let masks = List.map read_matrices texts in
  let size (functions, _, _) = functions and first (_, first, _) = first and matrices (_, _, matrices) = matrices in
  let functions = size (List.hd masks) in
  require (List.for_all (fun m -> size m = functions) masks) "the matrices of two masks have different sizes";
  let common = common_denominator (List.map matrices masks) in
  { list_arity = arity; list_functions = functions; list_common = common;
    each_vector = List.map (fun m -> (first m, cleared common (matrices m))) masks }

let read_list text arity =
  let texts = String.split_on_char ';' text in
  require (List.length texts <= 64) "more masks than this checker allows";
  let m = of_texts texts arity in
  let least = List.fold_left (fun low (first, _) -> Z.min low first) (fst (List.hd m.each_vector)) m.each_vector in
  let past (first, matrices) = Z.add first (Z.of_int (List.length matrices)) in
  let most = List.fold_left (fun high p -> Z.max high (past p)) least m.each_vector in
  let entries = Z.mul (Z.sub most least) (Z.of_int (m.list_functions * m.list_functions)) in
  require (Z.leq entries (Z.of_int 1000)) "the masks of a list have more than 1000 entries together";
  m

(* Masks in turn as a list, and what follows what in it *)
let in_turn m numbers =
  let count = List.length numbers in
  ( { m with each_vector = List.map (List.nth m.each_vector) numbers }, Follows (List.init count (fun k -> (k, (k + 1) mod count))) )

(* ---- the data, and a functional --------------------------------------------------------------------------------------------- *)

let times_vector rows y = Array.map (fun row -> Array.fold_left Q.add Q.zero (Array.map2 Q.mul row y)) rows

(* What a sequence in the window from low on, of vectors with so many components, reads in each of the data: line l of `data` is y_l,
   and the data e_l are at j the sum of the y_s j^(l-s)/(l-s)! *)
let reading data n low u =
  let order = Array.length data in
  let total = Array.make order Q.zero in
  Array.iteri (fun place x ->
      if Q.sign x <> 0 then
        let j = Q.of_int (-(low + (place / n))) and component = place mod n in
        let power = ref Q.one in
        for e = 0 to order - 1 do
          if e > 0 then power := Q.div (Q.mul !power j) (Q.of_int e);
          for l = e to order - 1 do
            total.(l) <- Q.add total.(l) (Q.mul x (Q.mul !power data.(l - e).(component)))
          done
        done) u;
  total

let rationals u = Array.map Q.of_bigint (Array.of_list u)
let otherwise = "no functional is found that the first mask keeps"

(* The functional, and the weights for each component: those that read of the data what they should. The first mask decides. *)
let find_functional m data low window =
  let n = m.list_functions and order = Array.length data in
  let read = reading data n low in
  let unit place = Array.init (window * n) (fun p -> if p = place then Q.one else Q.zero) in
  let candidates = Array.init (order * n) (fun k -> unit ((-low * n) + k)) in
  spend (order * n * order * order * (window + order) * n);
  match independent (Array.map read candidates) order with
  | None -> reject "the data are not independent"
  | Some (chosen, inverse) ->
      let dual = Array.map (fun row ->
          let u = Array.make (window * n) Q.zero in
          Array.iteri (fun k i -> u.((-low * n) + i) <- row.(k)) chosen;
          u) inverse in
      let first, matrices = List.hd m.each_vector in
      (* a step by the first mask, on these *)
      let moved u =
        let numbers, scale = whole [| u |] in
        let image = move m.list_arity n (Z.of_int low) window first matrices 0 (List.hd numbers) in
        Array.map (fun x -> Q.div x (Q.of_bigint (Z.mul scale m.list_common))) (rationals image)
      in
      spend (order * window * List.length matrices * n * n);
      let steps = Array.map (fun u -> read (moved u)) dual in
      let value = Array.make order Q.zero in
      value.(0) <- Q.one;
      for l = 1 to order - 1 do
        let sum = ref Q.zero in
        for j = 0 to l - 1 do sum := Q.add !sum (Q.mul steps.(j).(l) value.(j)) done;
        let rest = Q.sub Q.one steps.(l).(l) in
        require (Q.sign rest <> 0) otherwise;
        value.(l) <- Q.div !sum rest
      done;
      let functional = Array.init (window * n) (fun p ->
          Array.fold_left Q.add Q.zero (Array.mapi (fun j u -> Q.mul value.(j) u.(p)) dual)) in
      let numbers, _ = whole [| functional |] in
      let rec trimmed = function x :: rest when Z.sign x = 0 -> trimmed rest | l -> List.rev l in
      let functional = trimmed (List.rev (List.hd numbers)) in
      let shifts = Array.init order (fun j -> read (rationals (List.init (j * n) (fun _ -> Z.zero) @ functional))) in
      match independent shifts order with
      | Some (rows, inverse) when rows = Array.init order Fun.id ->
          let column c = Array.map (fun y -> y.(c)) data in
          let transposed = Array.init order (fun i -> Array.init order (fun j -> inverse.(j).(i))) in
          let weights, scale = whole (Array.init n (fun c -> times_vector transposed (column c))) in
          (functional, weights, scale)
      | _ -> reject otherwise

(* A basis of the sums of vectors of the space and of their shifts, each with its own place; and how it is made of these *)
let widened shifted size =
  let count = List.length shifted in
  spend (count * count * (size + count));
  let chosen = ref [] in
  List.iteri (fun index u ->
      let u = Array.append (rationals u) (Array.make (size - List.length u) Q.zero) in
      let row = Array.append u (Array.init count (fun k -> if k = index then Q.one else Q.zero)) in
      let take_off (pivot, other) = let f = row.(pivot) in if Q.sign f <> 0 then Array.iteri (fun k x -> row.(k) <- Q.sub row.(k) (Q.mul f x)) other in
      List.iter take_off !chosen;
      let rec first k = if k = size then None else if Q.sign row.(k) <> 0 then Some k else first (k + 1) in
      match first 0 with
      | None -> ()
      | Some pivot ->
          let f = row.(pivot) in
          let row = Array.map (fun x -> Q.div x f) row in
          List.iter (fun (_, other) -> let f = other.(pivot) in
            if Q.sign f <> 0 then Array.iteri (fun k x -> other.(k) <- Q.sub other.(k) (Q.mul f x)) row) !chosen;
          chosen := !chosen @ [ (pivot, row) ]) shifted;
  let part from length = Array.of_list (List.map (fun (_, row) -> Array.sub row from length) !chosen) in
  let basis, pivot = whole (part 0 size) and rows, scale = whole (part size count) in
  (* rows over `scale` make the basis over `pivot` *)
  (basis, List.map fst !chosen, pivot, List.map (List.map (Z.mul pivot)) rows, scale)

(* ---- the certificate --------------------------------------------------------------------------------------------------------- *)

(* What the lines from `sum-rules` to `vector` say, with what the checker wants beside; of the radius nothing yet. Data of Hermite
   schemes are those of polynomials and their derivatives. *)
let read_space ?(hermite = false) m lower r =
  let a = m.list_arity and n = m.list_functions in
  let order = size (List.hd (take r "sum-rules" 1 1)) 1 64 in
  require (Q.leq lower (Q.of_int order)) "the lower end is above the number of sum rules";
  let derivative l = Array.init n (fun c -> if c = l then Q.one else Q.zero) in
  let line l = if hermite then derivative l else Array.of_list (List.map rational (take r "data" n n)) in
  let data = Array.init order line in
  let digits = List.map integer (take r "digits" a a) in
  if digits <> List.init a Z.of_int then undecided "certificates with other digits are";
  let mask = vector_number m 0 in
  for _ = 2 to n do ignore (read_terms mask (take r "reading" 1 100_000)) done;
  let dimension = size (List.hd (take r "space" 1 1)) 1 256 in
  let vectors = List.init dimension (fun _ -> read_terms mask (take r "vector" 1 100_000)) in
  let floor_div x y = Z.to_int (Z.fdiv x (Z.of_int y)) in
  let last (first, matrices) = Z.add first (Z.of_int (List.length matrices - 1)) in
  List.iter (fun p -> require (Z.numbits (fst p) <= 30) "a mask is too far") m.each_vector;
  let points = List.map (fun ((j, _), _) -> j) (List.concat vectors) in
  let firsts = List.map (fun p -> floor_div (fst p) (a - 1)) m.each_vector in
  let lasts = List.map (fun p -> - floor_div (Z.neg (last p)) (a - 1)) m.each_vector in
  let low = List.fold_left min 0 (firsts @ List.map pred points) in
  let high = List.fold_left max ((2 * order) - 1) (lasts @ List.map succ points) in
  let window = high - low + 1 in
  require (window * n <= 4096) "sequences are too long for this checker";
  let place (j, c) = ((j - low) * n) + c in
  let flat terms =
    let u = Array.make (List.fold_left (fun most (p, _) -> max most (place p + 1)) 0 terms) Z.zero in
    List.iter (fun (p, x) -> u.(place p) <- x) terms;
    Array.to_list u
  in
  let list_spanning = List.map flat vectors in
  let list_places = List.map (fun v -> place (fst (List.hd v))) vectors and list_place_value = snd (List.hd (List.hd vectors)) in
  require (Z.sign list_place_value > 0) "a pivot is not positive";
  let points = List.fold_left (fun most (_, matrices) -> max most (List.length matrices)) 0 m.each_vector in
  let moves = List.length m.each_vector * a in
  let work = window * points * n * n in
  spend_times moves ((dimension + 4) * work);
  let restricted (first, matrices) = List.init a (fun t ->
      let images = List.map (fun b -> Array.of_list (move a n (Z.of_int low) window first matrices t b)) list_spanning in
      List.map (fun p -> List.map (fun u -> u.(p)) images) list_places) in
  let functional, weights, list_scale = find_functional m data low window in
  let constants = List.hd (fst (whole [| data.(0) |])) in
  let c = { list_first = Z.of_int low; list_window = window; list_order = order; list_spanning; list_places; list_place_value;
      list_restricted = List.map restricted m.each_vector; wide = []; wide_places = []; wide_pivot = Z.one; wide_rows = []; wide_scale = Z.one;
      list_entering = 0; functional; constants; list_weights = weights; list_scale; list_bound = { qnum = Z.zero; qden = Z.one };
      list_radius = { new_basis = None; sections = []; sizes = []; chosen = 0; eigenvector = None } } in
  require (list_window_fits m c) "the certificate does not fit into a window";
  let annihilates u = Array.for_all (fun x -> Q.sign x = 0) (reading data n low (rationals u)) in
  require (List.for_all (fun p -> annihilates (list_change m c p)) m.each_vector) "the masks do not keep the data, or at different places";
  let wide, wide_places, wide_pivot, wide_rows, wide_scale = widened (list_shifted m c) (window * n) in
  let c = { c with wide; wide_places; wide_pivot; wide_rows; wide_scale } in
  spend_times moves (dimension * work);
  require (list_constants m c) "a mask does not keep the constant data";
  require (list_spaces m c) "the space is not mapped to itself";
  let all c = List.for_all (fun p -> comes m c (list_change m c p)) m.each_vector && comes m c (list_differences m c)
    && List.for_all (fun d -> comes m c (list_component m c d)) (List.init n Fun.id) in
  (* how many letters lead all of these into the space and its shifts *)
  let rec entering k =
    require (k <= 12) "differences of the data do not come into the space";
    let functionals = List.length m.each_vector + 1 + n in
    let words = (float_of_int moves ** float_of_int k) *. float_of_int (8 * functionals * (work + (List.length wide * window * n))) in
    require (words <= float_of_int max_work) "more work than this checker allows";
    spend (int_of_float words);
    let c = { c with list_entering = k } in
    if all c then c else entering (k + 1)
  in
  entering 0

(* The weights of component s as differences of order s, which they are if the functional reads values of polynomials *)
let derivative_factors_of m c =
  let divided l =
    let sums = List.rev (snd (List.fold_left (fun (sum, l) x -> let sum = Z.add sum x in (sum, sum :: l)) (Z.zero, []) l)) in
    List.filteri (fun i _ -> i < List.length l - 1) sums
  in
  let rec times s l = if s = 0 then l else times (s - 1) (divided l) in
  let factors = List.mapi times c.list_weights in
  require (derivative_factors c m.list_functions factors) "the masks do not keep values and derivatives of polynomials";
  factors

let show m order what =
  Printf.printf "%s of arity %d and size %d\n" what m.list_arity m.list_functions;
  List.iteri (fun i (first, matrices) ->
      List.iteri (fun k matrix ->
          List.iteri (fun row numbers ->
              Printf.printf "mask %d, matrix %s, row %d: %s\n" i (Z.to_string (Z.add first (Z.of_int k))) row
                (String.concat " " (List.map (fun x -> Q.to_string (Q.make x m.list_common)) numbers))) matrix) matrices) m.each_vector;
  match order with
  | Any -> print_endline "all sequences of these masks"
  | Follows pairs -> List.iter (fun (b, c) -> Printf.printf "mask %d may be followed by mask %d\n" b c) pairs
