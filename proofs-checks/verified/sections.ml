(* The sections of a certificate, with flips, conjugates and images under groups written out. Nothing here is proved. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith
open Text

exception Undecided of string

let bound_of q = { qnum = Q.num q; qden = Q.den q }

let widest = Array.fold_left (fun most x -> max most (Z.numbits x)) 0
let bits_of = Array.fold_left (fun most row -> max most (widest row)) 0

(* The product of so many matrices, whose entries grow. *)
let spend_product family length =
  let n = family.size in
  spend (length * n * n * n * (1 + (length * Z.numbits family.denominator / 640)))

(* All products of so many matrices *)
let spend_norm family level =
  let count = float_of_int (List.length family.matrices) and n = family.size in
  let work = (count ** float_of_int level) *. float_of_int (n * n * n) in
  require (work <= float_of_int max_work) "more work than this checker allows";
  spend (int_of_float work * (1 + (level * Z.numbits family.denominator / 640)))

(* Vectors are the real parts of coordinates and then, if complex, the imaginary ones. *)
type vector = Z.t array

let apply (matrix : Z.t array array) parts (x : vector) : vector =
  let n = Array.length matrix in
  spend (parts * n * n * width (bits_of matrix) * width (widest x));
  Array.init (parts * n) (fun k ->
      let start = k / n * n and sum = ref Z.zero in
      Array.iteri
        (fun j a -> if not (Z.equal a Z.zero) then sum := Z.add !sum (Z.mul a x.(start + j)))
        matrix.(k mod n);
      !sum)

let multiply a b =
  let n = Array.length a in
  let column j = apply a 1 (Array.init n (fun i -> b.(i).(j))) in
  let columns = Array.init n column in
  Array.init n (fun i -> Array.init n (fun j -> columns.(j).(i)))

let negate = Array.map Z.neg
let array_of rows = Array.of_list (List.map Array.of_list rows)

(* Of a matrix or a vector and its negative one. *)
let normal rows =
  let leading = Array.fold_left (fun found row -> Array.fold_left (fun f x -> if f = 0 then Z.sign x else f) found row) 0 rows in
  if leading < 0 then (Array.map negate rows, true) else (rows, false)

let normal_vector x =
  let rows, negative = normal [| x |] in
  (rows.(0), negative)

let conjugate n x = Array.mapi (fun k a -> if k < n then a else Z.neg a) x

let widest_of row = widest (Array.of_list row)

let bits_of_family family =
  let wider most matrix = max most (bits_of (array_of matrix)) in
  List.fold_left wider (Z.numbits family.denominator) family.matrices

type element = { map : Z.t array array; letters : int array }

let compose g h = { map = multiply g.map h.map; letters = Array.map (fun t -> h.letters.(t)) g.letters }

(* The elements, each up to its sign; the identity is the first. *)
let elements n count generators =
  let known = Hashtbl.create 97 and all = ref [] in
  let identity = Array.init n (fun i -> Array.init n (fun j -> if i = j then Z.one else Z.zero)) in
  let rec add fresh element =
    let map, _ = normal element.map in
    if Hashtbl.mem known map then fresh
    else begin
      require (Array.exists (Array.exists (fun x -> Z.sign x <> 0)) map) "a generator is singular";
      Hashtbl.add known map ();
      all := element :: !all;
      require (Hashtbl.length known <= 96) "the generators span a group of more than 96 elements";
      List.fold_left add fresh (List.map (fun g -> compose g element) generators)
    end
  in
  add () { map = identity; letters = Array.init count Fun.id };
  let all = Array.of_list (List.rev !all) in
  let one = fst (normal identity) in
  let has_inverse g = Array.exists (fun h -> fst (normal (multiply g.map h.map)) = one) all in
  require (List.for_all has_inverse generators) "a generator is singular";
  all

(* The numbers of products, and of maps that are elements up to their signs *)
let numbered group =
  let numbers = Hashtbl.create 97 and products = Hashtbl.create 97 in
  Array.iteri (fun e element -> Hashtbl.add numbers (fst (normal element.map)) e) group;
  let number_of element = Hashtbl.find numbers (fst (normal element.map)) in
  let product a b =
    match Hashtbl.find_opt products (a, b) with
    | Some e -> e
    | None ->
        let e = number_of (compose group.(a) group.(b)) in
        Hashtbl.add products (a, b) e;
        e
  in
  (number_of, fun a b -> if a = 0 then b else if b = 0 then a else product a b)

(* K of group:K, or 0 of other text *)
let group_size text =
  if String.starts_with ~prefix:"group:" text then size (String.sub text 6 (String.length text - 6)) 1 8 else 0

let read_generators r family count =
  let n = family.size and letters = List.length family.matrices in
  let matrices = Array.of_list (List.map array_of family.matrices) in
  List.init count (fun _ ->
      let numbers = Array.of_list (List.map (fun f -> size f 0 (letters - 1)) (take r "generator" letters letters)) in
      let map = array_of (List.init n (fun _ -> List.map integer (take r "map" n n))) in
      for t = 0 to letters - 1 do
        require
          (multiply matrices.(t) map = multiply map matrices.(numbers.(t)))
          "a generator does not permute the matrices as it says"
      done;
      { map; letters = numbers })

let split_term text = String.split_on_char ':' text

(* INDEX[WORD], the index below `count` *)
let split_index text count =
  let length = String.length text and digits = ref 0 in
  while !digits < length && text.[!digits] >= '0' && text.[!digits] <= '9' do incr digits done;
  require (length - !digits <= 16) "a word of more than 16 generators";
  (size (String.sub text 0 !digits) 0 (count - 1), String.sub text !digits (length - !digits))

(* What a polytope section says, beside the section for the checker. Points are numbered from 1 on; each comes from an
   element of the group, a conjugation and a vertex. *)
type origin = element * bool * int
type terms = (int * (Z.t * Z.t)) list

type polytope = {
  body_family : family; (* transposed, if it says so *)
  turned : bool; cone : bool; parts : int; vertex_bits : int; weight_one : Z.t;
  vertices : vector array; group : element array;
  element_of : string -> element; (* of a word of generators *)
  point_origins : origin array; units : terms list; line_of : origin -> int -> terms }

let read_polytope r family fields =
  let n = family.size and count = List.length family.matrices in
  let vertices = size (List.nth fields 1) 1 max_bytes in
  let vertex_bits = size (List.nth fields 2) 0 4096 and weight_bits = size (List.nth fields 3) 0 4096 in
  let properties = List.filteri (fun i _ -> i >= 4) fields in
  require (List.length (List.sort_uniq compare properties) = List.length properties) "a property occurs twice";
  let has p = List.mem p properties in
  let complex = has "complex" and nonnegative = has "nonnegative" and symmetric = has "symmetric" and transposed = has "transposed" in
  let others = List.filter (fun p -> not (List.mem p [ "complex"; "nonnegative"; "symmetric"; "transposed" ])) properties in
  let groups = match others with [] -> 0 | [ p ] -> group_size p | _ -> reject "unknown polytope property" in
  require (others = [] || groups > 0) "unknown polytope property";
  require (not (groups > 0 && (symmetric || nonnegative))) "a group goes with neither 'symmetric' nor 'nonnegative'";
  require (not (complex && nonnegative)) "unknown polytope property";
  let family = if transposed then transpose family else family in
  let entries = List.concat (List.concat family.matrices) in
  require ((not symmetric) || entries = List.rev entries) "the family is not symmetric";
  require ((not nonnegative) || List.for_all (fun x -> Z.sign x >= 0) entries) "a matrix is not non-negative";
  let flip =
    { map = Array.init n (fun i -> Array.init n (fun j -> if i + j = n - 1 then Z.one else Z.zero));
      letters = Array.init count (fun t -> count - 1 - t) }
  in
  let generators = if symmetric then [ flip ] else read_generators r family groups in
  let group = elements n count generators in
  let parts = if complex then 2 else 1 in
  let base =
    Array.of_list
      (List.init vertices (fun _ ->
           spend (100 + (parts * n));
           let vertex = Array.of_list (List.map integer (take r "vertex" (parts * n) (parts * n))) in
           require ((not nonnegative) || Array.for_all (fun x -> Z.sign x >= 0) vertex) "negative coordinate";
           vertex))
  in
  let act element x =
    if symmetric && element != group.(0) then begin
      spend n;
      Array.init (parts * n) (fun k -> x.((k / n * n) + n - 1 - (k mod n)))
    end
    else if element == group.(0) then x
    else apply element.map parts x
  in
  let conjugate = conjugate n in
  (* all points, each up to its sign: the element, whether conjugated, and the vertex that it comes from *)
  let numbers = Hashtbl.create 997 and points = ref [] and origins = ref [] in
  let enter origin x =
    let key, _ = normal_vector x in
    if not (Hashtbl.mem numbers key) then begin
      Hashtbl.add numbers key (Hashtbl.length numbers + 1, snd (normal_vector x));
      points := x :: !points;
      origins := origin :: !origins
    end
  in
  let sides = if complex then [ false; true ] else [ false ] in
  Array.iteri
    (fun j vertex ->
      Array.iter
        (fun element ->
          List.iter
            (fun side -> enter (element, side, j) (act element (if side then conjugate vertex else vertex)))
            sides)
        group)
    base;
  let points = Array.of_list (List.rev !points) and origins = List.rev !origins in
  (* number of a point from 1 on, and whether it is the negative of the one that is listed *)
  let find x =
    let key, turned = normal_vector x in
    let number, listed_turned = Hashtbl.find numbers key in
    (number, turned <> listed_turned)
  in
  let signed (number, negative) (a, b) = if negative then (number, (Z.neg a, Z.neg b)) else (number, (a, b)) in
  let word_of text = List.init (String.length text) (String.get text) in
  let images_of_words = Hashtbl.create 997 in
  let generator letter =
    if letter = 'f' && symmetric then flip
    else begin
      let k = Char.code letter - Char.code 'A' in
      require (k >= 0 && (not symmetric) && k < List.length generators) "unknown generator";
      List.nth generators k
    end
  in
  let rec image_of vertex word =
    match Hashtbl.find_opt images_of_words (vertex, word) with
    | Some x -> x
    | None ->
        let x =
          match word with [] -> base.(vertex) | g :: rest -> apply (generator g).map parts (image_of vertex rest)
        in
        Hashtbl.add images_of_words (vertex, word) x;
        x
  in
  let read_term text =
    match split_term text with
    | index :: weights when List.length weights = parts ->
        let length = String.length index in
        let side = complex && length > 0 && index.[length - 1] = 'c' in
        let index = if side then String.sub index 0 (length - 1) else index in
        let vertex, word = split_index index vertices in
        require ((not symmetric) || String.length word <= 1) "unknown generator";
        let x = image_of vertex (word_of word) in
        let a, b = match List.map integer weights with [ a ] -> (a, Z.zero) | [ a; b ] -> (a, b) | _ -> assert false in
        require ((not nonnegative) || Z.sign a >= 0) "negative weight";
        signed (find (if side then conjugate x else x)) (a, b)
    | _ -> reject "a term is INDEX:WEIGHT"
  in
  let read_line head = List.map read_term (take r head 0 max_line) in
  let moved = Hashtbl.create 997 in
  let move (e, element) side (number, (a, b)) =
    if e = 0 && not side then (number, (a, b))
    else begin
      let target =
        match Hashtbl.find_opt moved (e, side, number) with
        | Some target -> target
        | None ->
            let x = points.(number - 1) in
            let target = find (act element (if side then conjugate x else x)) in
            Hashtbl.add moved (e, side, number) target;
            target
      in
      (* the conjugate of a combination has the conjugate weights *)
      signed target (a, if side then Z.neg b else b)
    end
  in
  let given = (if symmetric then (n + 1) / 2 else n) in
  let units = Array.of_list (List.init given (fun k -> read_line (Printf.sprintf "unit %d" k))) in
  let unit_lines =
    List.init n (fun k -> if k < given then units.(k) else List.map (move (1, group.(Array.length group - 1)) false) units.(n - 1 - k))
  in
  let images =
    Array.of_list
      (List.init vertices (fun j ->
           Array.of_list (List.init count (fun t -> read_line (Printf.sprintf "image %d %d" j t)))))
  in
  let index_of element =
    let rec search k = if group.(k) == element then k else search (k + 1) in
    search 0
  in
  let line_of (element, side, j) t =
    let line = images.(j).(element.letters.(t)) in
    spend (List.length line * n);
    List.map (move (index_of element, element) side) line
  in
  let image_lines = List.map (fun origin -> List.init count (line_of origin)) origins in
  let terms = List.fold_left (fun s l -> List.fold_left (fun s t -> s + List.length t) s l) 0 image_lines in
  let long = 1 + (Z.numbits family.denominator / 640) in
  spend (((terms * parts * parts) + (Array.length points * parts * count * n)) * n * long);
  let halves x = (Array.to_list (Array.sub x 0 n), if complex then Array.to_list (Array.sub x n n) else []) in
  let scale = Z.shift_left Z.one weight_bits in
  let numbered = List.map (fun (number, weight) -> (Z.of_int number, weight)) in
  let element_of word =
    require (String.length word <= 16) "a word of more than 16 generators";
    require ((not symmetric) || String.length word <= 1) "unknown generator";
    List.fold_left (fun e letter -> compose e (generator letter)) group.(0) (word_of word)
  in
  ( Polytope
      ( nonnegative, transposed, scale, Z.shift_left scale vertex_bits,
        List.map halves (Array.to_list points), List.map numbered unit_lines, List.map (List.map numbered) image_lines ),
    { body_family = family; turned = transposed; cone = nonnegative; parts; vertex_bits; weight_one = scale; vertices = base; group;
      element_of; point_origins = Array.of_list origins; units = unit_lines; line_of } )

(* ---- quadratic forms ---- *)

(* The rows of L where factor * S - scale * L L^T is small against the diagonal; None if S is not positive. *)
let root_of s =
  let n = Array.length s in
  let most = Array.fold_left (Array.fold_left (fun m x -> Z.max m (Z.abs x))) Z.zero s in
  if Z.equal most Z.zero then Some { root_rows = []; root_factor = Z.one; root_scale = Z.zero }
  else begin
    let shift = 256 - Z.numbits most in
    let half = if shift >= 0 then 0 else (1 - shift) / 2 in
    let factor = if shift >= 0 then Z.shift_left Z.one shift else if -shift mod 2 = 0 then Z.one else Z.of_int 2 in
    let margin = Z.add (Z.shift_left (Z.of_int n) 128) (Z.of_int n) in
    let rest = Array.map (Array.map (fun x -> Z.shift_right (Z.mul factor x) (2 * half))) s in
    Array.iteri (fun i row -> row.(i) <- Z.sub row.(i) margin) rest;
    spend (n * n * n / 3);
    try
      for k = 0 to n - 1 do
        if Z.sign rest.(k).(k) <= 0 then raise Exit;
        let pivot = Z.sqrt rest.(k).(k) in
        rest.(k).(k) <- pivot;
        for j = k + 1 to n - 1 do rest.(k).(j) <- Z.fdiv rest.(k).(j) pivot done;
        for i = k + 1 to n - 1 do
          for j = i to n - 1 do rest.(i).(j) <- Z.sub rest.(i).(j) (Z.mul rest.(k).(i) rest.(k).(j)) done
        done
      done;
      let row i = List.init (i + 1) (fun k -> rest.(k).(i)) in
      Some { root_rows = List.init n row; root_factor = factor; root_scale = Z.shift_left Z.one (2 * half) }
    with Exit -> None
  end

let transposed_array m = Array.init (Array.length m) (fun i -> Array.init (Array.length m) (fun j -> m.(j).(i)))
let congruent m form = multiply (transposed_array m) (multiply form m)
let longest_word = 1000

let incomplete = "the words are not those of a complete tree"

module Word_set = Set.Make (struct type t = int list let compare = compare end)

(* For each letter the first one of the equal ones *)
let first_letters matrices =
  Array.map (fun m -> let rec search t = if matrices.(t) = m then t else search (t + 1) in search 0) matrices

(* The words as a tree in which every node has a child for each letter, or none; with the products of the words. Equal
   letters have the same child, which then counts as so many copies. *)
let rec tree_of first equals words copies leaf longer product =
  match words with
  | [ [] ] -> leaf copies product
  | _ ->
      let count = Array.length first in
      spend_times copies count;
      let rests = Array.make count [] and children = Array.make count None in
      List.iter (function t :: rest -> rests.(t) <- rest :: rests.(t) | [] -> reject incomplete) words;
      let child t =
        require (rests.(t) <> []) incomplete;
        let copies = copies * equals.(t) in
        require (copies <= max_work) "more work than this checker allows";
        tree_of first equals rests.(t) copies leaf longer (longer copies product t)
      in
      Words
        (List.init count (fun t ->
             if first.(t) = t then children.(t) <- Some (child t);
             Option.get children.(first.(t))))

let read_quadratic r family upper fields =
  let n = family.size and count = List.length family.matrices and length = List.length fields in
  let groups = if length = 4 then group_size (List.nth fields 3) else 0 in
  require (length = 3 || groups > 0) "expected 'quadratic', a number of words, a bound and perhaps a group";
  let words = size (List.nth fields 1) 1 max_bytes and bound = rational (List.nth fields 2) in
  require (Q.sign bound >= 0) "the bound of a quadratic form is negative";
  let generators = read_generators r family groups in
  ignore (elements n count generators);
  let rows = Array.init n (fun i -> Array.of_list (List.map integer (take r "form" (i + 1) (i + 1)))) in
  let form = Array.init n (fun i -> Array.init n (fun j -> rows.(max i j).(min i j))) in
  let definite =
    match root_of form with
    | Some root when Z.sign form.(0).(0) <> 0 -> root
    | _ -> reject "the form is not positive definite"
  in
  List.iter (fun g -> require (congruent g.map form = form) "a generator does not keep the form") generators;
  let matrices = Array.of_list (List.map array_of family.matrices) in
  let first = first_letters matrices in
  let equals = Array.make count 0 in
  Array.iter (fun t -> equals.(t) <- equals.(t) + 1) first;
  let known = ref Word_set.empty and waiting = Queue.create () in
  let add word =
    spend (1000 + (100 * List.length word));
    let fresh = not (Word_set.mem word !known) in
    if fresh then begin
      known := Word_set.add word !known;
      Queue.add word waiting
    end;
    fresh
  in
  for _ = 1 to words do
    let word = List.map (fun f -> first.(size f 0 (count - 1))) (take r "word" 1 longest_word) in
    require (add word) "a word occurs twice"
  done;
  (* with the images under the generators *)
  while not (Queue.is_empty waiting) do
    let word = Queue.pop waiting in
    List.iter (fun g -> ignore (add (List.map (fun t -> first.(g.letters.(t))) word))) generators
  done;
  (* each product has to be below the bound of the certificate; the hint is for that of the claim *)
  let wanted = match upper with Some u when Q.gt u bound -> u | _ -> bound in
  let longer copies (k, product) t =
    let product = if k = 0 then matrices.(t) else multiply product matrices.(t) in
    let wide = width (bits_of product) in
    spend_times copies (n * n * ((n * width (bits_of matrices.(t)) * wide) + (500 * (wide - 1))));
    (k + 1, product)
  in
  let leaf copies (k, product) =
    let bits g = 2 * k * (Z.numbits (Q.num g) + Z.numbits (Q.den g) + Z.numbits family.denominator) in
    let wide = width (max (bits bound) (bits wanted) + bits_of form) and long = width (bits_of product) in
    require (n * n * wide <= 1 lsl 23) "more work than this checker allows";
    let entries = (n * (5 + (2 * long * (long + width (bits_of form))))) + (wide * width (bits_of form)) in
    spend_times copies ((200 * wide) + (n * n * entries));
    let moved = congruent product form in
    let root g =
      let a = Z.pow (Z.mul (Q.num g) family.denominator) (2 * k) and b = Z.pow (Q.den g) (2 * k) in
      root_of (Array.mapi (fun i row -> Array.mapi (fun j x -> Z.sub (Z.mul a x) (Z.mul b moved.(i).(j))) row) form)
    in
    match (if Q.equal bound wanted then Some definite else root bound), root wanted with
    | Some _, Some hint -> Word hint
    | _ -> reject "a product is not below the bound in the quadratic form"
  in
  let tree = tree_of first equals (Word_set.elements !known) 1 leaf longer (0, [||]) in
  (bound, Quadratic (Array.to_list (Array.map Array.to_list form), definite, tree))

(* ---- graphs ---- *)

(* An element of the group, with its inverse and the classes of the letters that it moves to letters *)
let moving (group : element array) product first class_of e =
  (* the power before the first one that is 1 or -1 *)
  let rec before power taken =
    require (taken <= Array.length group) "a generator is singular";
    let next = product e power in
    if next = 0 then power else before next (taken + 1)
  in
  let inverse = group.(before 0 0).map and classes = Array.map (fun _ -> 0) first in
  let one = (multiply group.(e).map inverse).(0).(0) in
  Array.iteri (fun s t -> classes.(first.(t)) <- class_of first.(s)) group.(e).letters;
  let rows m = Array.to_list (Array.map Array.to_list m) in
  { action = rows group.(e).map;
    undone = rows (if Z.sign one > 0 then inverse else Array.map negate inverse);
    reading = List.map (fun t -> classes.(t)) (Array.to_list first) }

(* ENDS for so many letters, as trees. `visit` is told of each word and of each beginning of words, `keep` of the classes of
   letters of kept words, if there may be any. *)
let read_trees text letters visit keep =
  let position = ref 0 in
  let rec branches length =
    List.init letters (fun letter ->
        require (!position < String.length text) "a tree has fewer characters than its words";
        let character = text.[!position] in
        incr position;
        if character <> '*' then visit (character <> '+');
        match (character, keep) with
        | '*', Some keep ->
            require (length = 1) "a kept word has more than one letter";
            keep letter;
            Stop 0
        | '+', _ ->
            require (length < longest_word) "a word of more than 1000 letters";
            Further (branches (length + 1))
        | '0' .. '9', _ -> Stop (Char.code character - Char.code '0')
        | 'A' .. 'Z', _ -> Stop (Char.code character - Char.code 'A' + 10)
        | 'a' .. 'z', _ -> Stop (Char.code character - Char.code 'a' + 36)
        | _ -> reject "a word ends with none of 0-9, A-Z, a-z")
  in
  let trees = branches 1 in
  require (!position = String.length text) "a tree has more characters than its words";
  trees

(* What stands beside a section: of a graph by states the class of the letter of a kept word, and where it leads *)
type beside = Alone | Body of polytope | Kept of (int * int) option array

let keeps = Array.exists (fun k -> k <> None)

let read_graph ~may_keep r family upper fields =
  let n = family.size and count = List.length family.matrices and length = List.length fields in
  let groups = if length = 5 then group_size (List.nth fields 4) else 0 in
  require (length = 4 || groups > 0) "expected 'graph', a number of states, a bound, a number of bits and perhaps a group";
  let states = size (List.nth fields 1) 1 4096 and bound = rational (List.nth fields 2) and bits = size (List.nth fields 3) 8 1000 in
  require (Q.sign bound > 0) "the bound of a graph is not positive";
  let unity = Z.shift_left Z.one bits in
  let generators = read_generators r family groups in
  let group = elements n count generators in
  let number_of, product = numbered group in
  let matrices = Array.of_list (List.map array_of family.matrices) in
  let first = first_letters matrices in
  let firsts = List.filter (fun t -> first.(t) = t) (List.init count Fun.id) in
  let classes = Array.make count 0 in
  List.iteri (fun c t -> classes.(t) <- c) firsts;
  let everyone = List.init (Array.length group) Fun.id in
  let group_of_graph = List.map (moving group product first (fun t -> classes.(t))) everyone in
  let cube = n * n * n in
  spend (3 * List.length everyone * count * cube);
  (* the words of steps, numbered as they come; of their maps signs matter *)
  let numbers = Hashtbl.create 97 and turns = ref [] in
  let turn word =
    match Hashtbl.find_opt numbers word with
    | Some k -> k
    | None ->
        let generator letter =
          let k = Char.code letter - Char.code 'A' in
          require (k >= 0 && k < groups) "unknown generator";
          List.nth generators k
        in
        let element = String.fold_left (fun e letter -> compose e (generator letter)) group.(0) word in
        let moved = List.map (product (number_of element)) everyone in
        spend (List.length everyone * cube);
        turns := { turning = Array.to_list (Array.map Array.to_list element.map); moved } :: !turns;
        Hashtbl.add numbers word (Hashtbl.length numbers);
        Hashtbl.length numbers - 1
  in
  let coordinate_bits = ref 0 and taken = ref 0 in
  let read_coordinates i =
    let row = List.map integer (take r "coordinates" (i + 1) (i + 1)) in
    require (Z.sign (List.nth row i) <> 0) "the coordinates of a state have a 0 on the diagonal";
    List.iter (fun x -> coordinate_bits := max !coordinate_bits (Z.numbits x)) row;
    row @ List.init (n - 1 - i) (fun _ -> Z.zero)
  in
  let rec read_steps head =
    match take r head (2 + (n * n)) (2 + (n * n)) with
    | target :: norm :: entries ->
        let target, word = split_index target states in
        let step_norm = integer norm and entries = Array.of_list (List.map integer entries) in
        require (Z.sign step_norm > 0 && Z.leq step_norm (Z.mul (Z.of_int 7) unity)) "the norm of a step is not from 1 to 7 2^BITS";
        require (Array.for_all (fun x -> Z.leq (Z.abs x) step_norm) entries) "the norm of a step is larger than it says";
        incr taken;
        let step_matrix = List.init n (fun i -> Array.to_list (Array.sub entries (i * n) n)) in
        let step = { target; turned_by = turn word; step_norm; step_matrix } in
        step :: (if at r head then read_steps head else [])
    | _ -> assert false
  in
  (* products of steps, and what ends of words take beside: with few bits numbers are those of the machine *)
  let looking = 20 + ((states + count) / 16) in
  let price work = looking + if bits <= 24 then work / 12 else if bits <= 100 then work / 2 else work * width bits in
  let product = price cube and compared = price (2 * cube / 3) in
  let visit ends = spend (if ends then product + compared else product) in
  let kept = Array.make states None in
  let read_state j =
    let coordinates = List.init n read_coordinates in
    let steps = List.map (fun t -> read_steps (Printf.sprintf "step %d" t)) firsts in
    let keep c =
      let step = List.hd (List.nth steps c) in
      require (Hashtbl.find_opt numbers "" = Some step.turned_by) "the step of a kept word has a word of the group";
      require (kept.(j) = None) "a state has two kept words";
      kept.(j) <- Some (c, step.target)
    in
    let keep = if may_keep then Some keep else None in
    { coordinates; steps; trees = read_trees (List.hd (take r "tree" 1 1)) (List.length firsts) visit keep }
  in
  let states = List.init states read_state in
  let most f = Array.fold_left (fun most x -> max most (bits_of (f x))) 0 in
  let fractions = Z.numbits (Q.num bound) + Z.numbits (Q.den bound) + Z.numbits family.denominator in
  let apart = bits + fractions + !coordinate_bits + max (most Fun.id matrices) (most (fun e -> e.map) group) + 20 in
  spend_times (max 1 !taken) (looking + (6 * cube * width (128 + apart) * width (128 + apart)));
  let section = Graph (bound_of bound, unity, firsts, group_of_graph, List.rev !turns, states) in
  (* with an upper end of the claim that comes later *)
  require (upper <> None || keeps kept || check_section family (bound_of bound) section) "the words do not prove the bound";
  (bound, section, Kept kept)

(* Middle coefficients of so many powers *)
let spend_powers family symbol count =
  let width = (2 * reach_of (List.length family.matrices) symbol) + 1 in
  spend (count * width * width * (1 + (count * Z.numbits family.denominator / 640)))

(* One spectral radius: the work is that of the recurrence. *)
let read_single r family fields =
  let bound, squares, recurrence = Single_hint.read r family fields in
  spend_powers family squares.symbol (List.length recurrence);
  require (recurs family squares.symbol recurrence) "the recurrence is wrong";
  require (Single_hint.bounded_by bound recurrence) "the recurrence may have a zero above the bound";
  (Some bound, Single (squares, recurrence), Alone)

(* The section, the bound that it shows if it says so itself, and what stands beside it. `single`: those of 4.11 are
   allowed; `may_keep`: words of graphs may be kept. *)
let read_section ~single ~may_keep r number family upper =
  let fields = take r (Printf.sprintf "block %d" number) 2 8 in
  match List.hd fields with
  | "norm" ->
      require (List.length fields = 2) "wrong number of fields after 'norm'";
      let level = size (List.nth fields 1) 1 64 in
      spend_norm family level;
      (None, Norm level, Alone)
  | "quadratic" ->
      let bound, section = read_quadratic r family upper fields in
      (Some bound, section, Alone)
  | "graph" ->
      let bound, section, beside = read_graph ~may_keep r family upper fields in
      (Some bound, section, beside)
  | "polytope" when List.length fields >= 4 ->
      let section, polytope = read_polytope r family fields in
      (None, section, Body polytope)
  | "single" when single -> read_single r family fields
  | "frequency" when single -> raise (Undecided "bounds by frequencies are not decided here, but by subcert-check")
  | _ -> reject "expected 'norm', 'polytope', 'quadratic' or 'graph' and its numbers"
