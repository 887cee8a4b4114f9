(* Claims about vectors of functions: the mask, the sequences of a certificate in one window, and what shows that fixed vectors
   are multiples of one. Of this only the mask that is read is trusted. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith
open Text

let undecided why = raise (Sections.Undecided (why ^ " decided by subcert-check"))

(* [[[a,b],[c,d]],...]/D@first: the text, and lists of lists of lists *)
type tree = Leaf of string | Lists of tree list

let rec tree text at =
  let finish = String.length text in
  if at < finish && text.[at] = '[' then
    let rec items taken at =
      let item, at = tree text at in
      require (at < finish) "a list of a mask has no end";
      match text.[at] with
      | ',' -> items (item :: taken) (at + 1)
      | ']' -> (Lists (List.rev (item :: taken)), at + 1)
      | _ -> reject "expected ',' or ']' in a mask"
    in
    items [] (at + 1)
  else
    let rec stop k = if k < finish && text.[k] <> ',' && text.[k] <> ']' && text.[k] <> '[' then stop (k + 1) else k in
    let k = stop at in
    (Leaf (String.sub text at (k - at)), k)

let expected = "a mask of matrices is [[[a,b],[c,d]],...]/D@first"

let has_root text =
  let part = "sqrt" in
  let n = String.length part in
  let rec search k = k + n <= String.length text && (String.sub text k n = part || search (k + 1)) in
  search 0

(* The size, the first index and the matrices, of rational numbers *)
let read_matrices text =
  let lists, stop = tree text 0 in
  let tail = String.sub text stop (String.length text - stop) in
  let over, first = read_tail tail expected in
  let scale = rational ("1" ^ over) in
  let entry = function Leaf x -> Q.mul (rational x) scale | Lists _ -> reject expected in
  let items = function Lists l -> l | Leaf _ -> reject expected in
  let matrices = List.map (fun m -> List.map (fun row -> List.map entry (items row)) (items m)) (items lists) in
  let functions = List.length (List.hd matrices) in
  require (List.for_all (fun m -> List.length m = functions && List.for_all (fun row -> List.length row = functions) m) matrices)
    "the matrices of a mask are squares of one size";
  require (List.length matrices * functions * functions <= 10_000) "a mask with too many coefficients";
  (functions, first, matrices)

(* Of the matrices of some masks, and matrices over it *)
let common_denominator masks =
  let common = List.fold_left (List.fold_left (List.fold_left (List.fold_left (fun d x -> Z.lcm d (Q.den x))))) Z.one masks in
  require (Z.numbits common <= 10_000) "common denominator too large";
  common

let cleared common = List.map (List.map (List.map (fun x -> Z.mul (Q.num x) (Z.divexact common (Q.den x)))))

let read_mask text dilation =
  let length = String.length dilation in
  require (length > 2 && dilation.[0] = '[' && dilation.[length - 1] = ']') "a dilation is [2] or its rows, [1,2;-2,-1]";
  let inner = String.sub dilation 1 (length - 2) in
  if String.exists (fun c -> c = ',' || c = ';') inner then undecided "refinable functions of several variables are";
  let arity = integer inner in
  require (Z.gt (Z.abs arity) Z.one && Z.leq (Z.abs arity) (Z.of_int 64)) "a dilation has a determinant of 2 to 64";
  if Z.sign arity < 0 then undecided "refinable functions with a negative dilation are";
  if has_root text then undecided "masks with square roots are";
  let functions, first, matrices = read_matrices text in
  let vector_common = common_denominator [ matrices ] in
  { vector_arity = Z.to_int arity; functions; vector_first = first; of_points = cleared vector_common matrices; vector_common }

(* POINT.COMPONENT:INTEGER, no place twice *)
let read_terms mask fields =
  let term field =
    match String.split_on_char ':' field with
    | [ place; value ] -> (
        match String.split_on_char '.' place with
        | [ point; component ] ->
            let point = integer point and value = integer value in
            require (Z.leq (Z.abs point) (Z.of_int 1_000_000_000)) "a point is too far";
            require (Z.sign value <> 0) "a term is zero";
            ((Z.to_int point, size component 0 (mask.functions - 1)), value)
        | _ -> reject "a point is followed by a component")
    | _ -> reject "a term is POINT.COMPONENT:INTEGER"
  in
  let terms = List.map term fields in
  let places = List.map fst terms in
  require (List.length (List.sort_uniq compare places) = List.length places) "a place occurs twice";
  terms

(* Independent rows of a matrix with so many columns, and the inverse of the matrix of these *)
let independent rows n =
  let reduced = ref [] and chosen = ref [] in
  let reduce row = List.iter (fun (pivot, other) ->
      let f = row.(pivot) in
      if Q.sign f <> 0 then Array.iteri (fun k x -> if Q.sign x <> 0 then row.(k) <- Q.sub row.(k) (Q.mul f x)) other) (List.rev !reduced)
  in
  let look index row =
    if List.length !reduced < n then begin
      let row = Array.copy row in
      reduce row;
      let rec first k = if k = n then None else if Q.sign row.(k) <> 0 then Some k else first (k + 1) in
      match first 0 with
      | None -> ()
      | Some pivot ->
          let f = row.(pivot) in
          reduced := (pivot, Array.map (fun x -> Q.div x f) row) :: !reduced;
          chosen := index :: !chosen
    end
  in
  Array.iteri look rows;
  if List.length !chosen < n then None
  else begin
    let chosen = Array.of_list (List.rev !chosen) in
    let work = Array.map (fun i -> Array.append (Array.copy rows.(i)) (Array.make n Q.zero)) chosen in
    Array.iteri (fun i row -> row.(n + i) <- Q.one) work;
    for k = 0 to n - 1 do
      let rec find i = if Q.sign work.(i).(k) <> 0 then i else find (i + 1) in
      let i = find k in
      let row = work.(i) in
      work.(i) <- work.(k);
      let f = row.(k) in
      let row = Array.map (fun x -> Q.div x f) row in
      work.(k) <- row;
      Array.iteri (fun j other ->
          let f = other.(k) in
          if j <> k && Q.sign f <> 0 then Array.iteri (fun p x -> if Q.sign x <> 0 then other.(p) <- Q.sub other.(p) (Q.mul f x)) row) work
    done;
    Some (chosen, Array.map (fun row -> Array.sub row n n) work)
  end

(* Rows over one denominator *)
let whole rows =
  let common = Array.fold_left (Array.fold_left (fun d x -> Z.lcm d (Q.den x))) Z.one rows in
  (Array.to_list (Array.map (fun row -> Array.to_list (Array.map (fun x -> Z.mul (Q.num x) (Z.divexact common (Q.den x))) row)) rows), common)

(* What the lines from `differences` to `vector` say, with what the checker wants beside; of the radius nothing yet *)
let read_space mask lower r =
  let a = mask.vector_arity and n = mask.functions in
  let order = size (List.hd (take r "differences" 1 1)) 1 64 in
  Option.iter (fun lower ->
      require (Q.sign lower > 0) "the lower end of an exponent must be positive";
      require (Q.leq lower (Q.of_int order)) "the lower end is above the order of the differences") lower;
  let digits = List.map integer (take r "digits" a a) in
  if digits <> List.init a Z.of_int then undecided "certificates with other digits are";
  let values = read_terms mask (take r "values" 1 100_000) in
  let dimension = size (List.hd (take r "space" 1 1)) 1 256 in
  let vectors = List.init dimension (fun _ -> read_terms mask (take r "vector" 1 100_000)) in
  let first = Z.to_int mask.vector_first in
  let last = first + List.length mask.of_points - 1 in
  let points = List.map (fun ((j, _), _) -> j) (values @ List.concat vectors) in
  let floor_div x y = Z.to_int (Z.fdiv (Z.of_int x) (Z.of_int y)) in
  let low = List.fold_left min (floor_div first (a - 1)) points in
  let high = List.fold_left max (- floor_div (-last) (a - 1)) points + order in
  let window = high - low + 1 in
  require (window * n <= 4096) "sequences are too long for this checker";
  let place (j, c) = ((j - low) * n) + c in
  let flat terms =
    let u = Array.make (window * n) Z.zero in
    List.iter (fun (p, x) -> u.(place p) <- x) terms;
    Array.to_list u
  in
  let fixed = flat values and spanning = List.map flat vectors in
  let places = List.map (fun v -> place (fst (List.hd v))) vectors and place_value = snd (List.hd (List.hd vectors)) in
  require (Z.sign place_value > 0) "a pivot is not positive";
  let at u p = List.nth u p in
  spend (a * (dimension + 4) * window * List.length mask.of_points * n * n);
  let moved_by t u = move a n (Z.of_int low) window mask.vector_first mask.of_points t u in
  let images = List.init a (fun t -> List.map (fun b -> Array.of_list (moved_by t b)) spanning) in
  let restricted = List.map (fun images -> List.map (fun p -> List.map (fun u -> u.(p)) images) places) images in
  let inner_low = floor_div first (a - 1) + 1 and inner_high = -floor_div (-last) (a - 1) - 1 in
  require (inner_high >= inner_low) "there is no point at which a solution may not be zero";
  let inside = (inner_high - inner_low + 1) * n and start = (inner_low - low) * n in
  require (inside <= 256) "more places inside than this checker allows";
  let rec first_nonzero q = if q = inside then reject "the values are zero inside" else if Z.sign (at fixed (start + q)) <> 0 then q else first_nonzero (q + 1) in
  let nonzero = first_nonzero 0 in
  let certificate =
    { window_first = Z.of_int low; window; fixed; difference_order = order; spanning; places; place_value; restricted; entering = 0;
      inner_first = Z.of_int inner_low; inner = inner_high - inner_low + 1; nonzero; kernel = []; kernel_scale = Z.one;
      space_bound = { qnum = Z.zero; qden = Z.one };
      space_radius = { new_basis = None; sections = []; sizes = []; chosen = 0; eigenvector = None } }
  in
  let zero l = List.for_all (fun x -> Z.sign x = 0) l in
  require (zero (unfixed mask certificate fixed)) "the values are not fixed by the first transition";
  require (checks_space mask certificate) "the space is not mapped to itself";
  (* how many letters lead the differences into the space *)
  let rec entering k =
    require (k <= 12) "differences of the values do not come into the space";
    spend (int_of_float (float_of_int a ** float_of_int k) * window * List.length mask.of_points * n * n);
    if checks_start mask { certificate with entering = k } then k else entering (k + 1)
  in
  let entering = entering 0 in
  (* fixed vectors are multiples of the values *)
  let unit q = List.init (window * n) (fun p -> if p = start + q then Z.one else Z.zero) in
  spend (inside * window * List.length mask.of_points * n * n);
  spend (inside * inside * (inside + (window * n)));
  let columns = Array.init inside (fun q -> Array.of_list (unfixed mask certificate (unit q))) in
  let reading = Array.init inside (fun q -> if q = nonzero then Q.one else Q.zero) in
  let equations = Array.init (window * n) (fun p -> Array.init inside (fun q -> Q.of_bigint columns.(q).(p))) in
  match independent (Array.append [| reading |] equations) inside with
  | None -> reject "not shown that all solutions are multiples of one"
  | Some (chosen, inverse) ->
      let scale = Q.of_bigint (at fixed (start + nonzero)) in
      let rows = Array.map (fun row ->
          let h = Array.make (window * n) Q.zero in
          Array.iteri (fun k i -> if i > 0 then h.(i - 1) <- Q.mul scale row.(k)) chosen;
          h) inverse
      in
      let kernel, common = whole rows in
      let certificate = { certificate with entering; kernel; kernel_scale = common } in
      require (checks_kernel mask certificate) "not shown that all solutions are multiples of one";
      certificate

(* Whether a vector of numbers modulo a prime is independent of those that `reduced` remembers, which it joins then *)
let prime = 2_147_483_647

let joins reduced row =
  let rec power x k = if k = 0 then 1 else let h = power (x * x mod prime) (k / 2) in if k land 1 = 1 then h * x mod prime else h in
  let row = Array.map (fun x -> Z.to_int (Z.erem x (Z.of_int prime))) row in
  List.iter (fun (pivot, other) ->
      let f = row.(pivot) in
      if f <> 0 then Array.iteri (fun k x -> row.(k) <- ((row.(k) - (f * x mod prime)) + prime) mod prime) other) (List.rev !reduced);
  let rec first k = if k = Array.length row then None else if row.(k) <> 0 then Some k else first (k + 1) in
  match first 0 with
  | None -> false
  | Some pivot ->
      let inverse = power row.(pivot) (prime - 2) in
      reduced := (pivot, Array.map (fun x -> x * inverse mod prime) row) :: !reduced;
      true

(* Words whose images of the differences of the values span the space, and the vectors of the space as sums of these images *)
let read_images mask certificate =
  let a = mask.vector_arity and dimension = List.length certificate.spanning in
  let moved t u =
    spend (certificate.window * List.length mask.of_points * mask.functions * mask.functions);
    move a mask.functions certificate.window_first certificate.window mask.vector_first mask.of_points t u
  in
  let coordinates u = let u = Array.of_list u in Array.of_list (List.map (fun p -> u.(p)) certificate.places) in
  let digits = List.init a Fun.id in
  let rec long k = if k = 0 then [ ([], start_differences mask certificate) ]
    else List.concat_map (fun (w, u) -> List.map (fun t -> (t :: w, moved t u)) digits) (long (k - 1)) in
  let reduced = ref [] in
  let rec search found = function
    | [] -> List.rev found
    | _ when List.length found = dimension -> List.rev found
    | (w, u) :: rest ->
        let row = coordinates u in
        if joins reduced row then search ((w, row) :: found) (rest @ List.map (fun t -> (t :: w, moved t u)) digits) else search found rest
  in
  let found = search [] (long certificate.entering) in
  require (List.length found = dimension) "the differences of the values do not span the space";
  let pivot = Q.of_bigint certificate.place_value in
  let rows = Array.of_list (List.map (fun (_, row) -> Array.map (fun x -> Q.div (Q.of_bigint x) pivot) row) found) in
  spend (dimension * dimension * dimension);
  match independent rows dimension with
  | None -> reject "the differences of the values do not span the space"
  | Some (_, inverse) ->
      let rows, common = whole inverse in
      (List.map fst found, rows, common)

(* With the words and sums of these images, and a bound from below of the radius *)
let with_images space_proof (image_words, combinations, combination_scale) space_least =
  { space_proof; image_words; combinations; combination_scale; space_least }

let same_basis n =
  let rows = List.init n (fun i -> List.init n (fun j -> if i = j then Z.one else Z.zero)) in
  { basis_rows = rows; inverse_rows = rows; basis_scale = Z.one }

(* Words, and points after them, at which values of component k tell the part of the space that is seen apart *)
let observe mask k certificate part =
  let family = transpose (seen_family mask certificate part) and vectors = seen_vectors certificate part in
  let dimension = family.size and digits = List.init mask.vector_arity Fun.id in
  let matrices = List.map (fun m -> [ m ]) family.matrices in
  let led t row =
    spend (dimension * dimension);
    zrun (List.nth matrices t) [ 0 ] row
  in
  spend (certificate.window * certificate.window * dimension);
  let start = List.init certificate.window (fun x -> (([], x), seen_values mask k vectors x)) in
  let reduced = ref [] in
  let rec search found = function
    | [] -> List.rev found
    | _ when List.length found = dimension -> List.rev found
    | ((word, x), row) :: rest ->
        if joins reduced (Array.of_list row) then
          search ((List.rev word, x, row) :: found) (rest @ List.map (fun t -> ((t :: word, x), led t row)) digits)
        else search found rest
  in
  let found = search [] start in
  let otherwise = "more than what is said to be unobservable may be so" in
  require (List.length found = dimension) otherwise;
  spend (dimension * dimension * dimension);
  match independent (Array.of_list (List.map (fun (_, _, row) -> Array.of_list (List.map Q.of_bigint row)) found)) dimension with
  | None -> reject otherwise
  | Some (_, inverse) ->
      let seen_rows, seen_scale = whole inverse in
      let observation = { seen_at = List.map (fun (word, x, _) -> (word, x)) found; seen_rows; seen_scale } in
      require (observes mask k certificate part observation) otherwise;
      observation

let show mask component lower upper =
  let side words = Option.fold ~none:"" ~some:(fun q -> words ^ Q.to_string q) in
  let subject = Option.fold ~none:"" ~some:(Printf.sprintf "function %d of ") component in
  Printf.printf "the Hoelder exponent of %s%d functions of arity %d%s%s\n" subject mask.functions mask.vector_arity
    (side ", at least " lower) (side ", at most " upper);
  List.iteri (fun k ->
      List.iteri (fun i row ->
          Printf.printf "matrix %s, row %d: %s\n" (Z.to_string (Z.add mask.vector_first (Z.of_int k))) i
            (String.concat " " (List.map (fun x -> Q.to_string (Q.make x mask.vector_common)) row)))) mask.of_points
