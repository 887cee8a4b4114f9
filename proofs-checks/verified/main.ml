(* subcert-check-verified: reads a claim and a certificate and asks the proved checker. The claim is what was proved;
   --show prints it as the checker was given it. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith
open Text

let usage =
  "usage: subcert-check-verified --matrices MATRICES [--lower P/Q] [--upper P/Q] [--show] FILE    (at least one bound)\n\
  \       subcert-check-verified --subradius MATRICES [--lower P/Q] [--upper P/Q] [--show] FILE    (the joint spectral subradius)\n\
  \       subcert-check-verified --mask '[c0,c1,...]/D@first' --arity A --lower P/Q [--upper P/Q] [--show] FILE\n\
  \       subcert-check-verified --matrices MATRICES --exact '|[p0,p1,...,pd]@RE,IM,EPS|^1/L' [...] FILE    (what the radius is)\n\
  \       subcert-check-verified --subradius MATRICES --exact '|[p0,p1,...,pd]@RE,IM,EPS|^1/L' [...] FILE    (likewise)\n\
  \       subcert-check-verified --mask ... --arity A --exact 'M-log|[p0,p1,...,pd]@RE,IM,EPS|^1/L' [...] FILE\n\
  \       subcert-check-verified --mask ... --exact ... --logarithm P FILE    (the modulus of continuity takes |log h|^P)\n\
  \       subcert-check-verified --mask ... --upper CK [...] FILE    (no C^K limits)\n\
  \       subcert-check-verified --masks 'MASK;MASK;...' --arity A --order any --lower P/Q [--show] FILE    (a mask for each level:\n\
  \                              all sequences; follows=0-1,1-0,...: those where each pair is one of these)\n\
  \       subcert-check-verified --mask '[-w,0,1/2+w,...]@first' --arity A --for w=LOW..HIGH --lower P/Q [--show] FILE\n\
  \                              (for all these w; <, not <=; --levels w=LOW..HIGH: for all sequences of them, one for each level;\n\
  \                              with --recurrence '[P]/(Q)' --start LOW..HIGH --from K: where values follow from each other)\n\
  \       subcert-check-verified --refinable MASK --dilation '[A]' [--component C] --lower P/Q [--upper P/Q] [--show] FILE\n\
  \                              (vectors of functions; or --exact '0-log|[p0,p1,...,pd]@RE,IM,EPS|^1/L' [...])\n\
  \       subcert-check-verified --vectors 'MASK;MASK;...' --arity A --order any --lower P/Q [--show] FILE    (schemes of vectors, likewise;\n\
  \                              without --order one MASK of matrices: it converges, <, not <=; --hermite ... --lower K: HC^K)\n\
  \       subcert-check-verified ... --theorem NAME FILE    (prints a file in which the kernel of Coq checks all of it)\n\
   prints VERIFIED <claim> (exit 0), REJECTED <why, line n> (exit 1), or UNDECIDED <why> (exit 2): other claims about\n\
   exponents, and about surfaces, refinable functions, several variables and least absolute deviations, for which subcert-check is there\n\
   exit 64: wrong usage, 65: malformed MATRICES, 66: missing file"

let known = [ "--mask"; "--arity"; "--for"; "--levels"; "--each-point"; "--recurrence"; "--start"; "--from"; "--limit"; "--masks"; "--order"; "--within"; "--surface"; "--refinable"; "--integral"; "--component"; "--vertex"; "--not-c1"; "--vectors"; "--hermite"; "--dilation"; "--matrices"; "--subradius"; "--l1"; "--contraction"; "--lower"; "--upper"; "--exact"; "--attains"; "--logarithm"; "--theorem" ]

let rec options given = function
  | [] -> given
  | "--show" :: rest -> options (("--show", "") :: given) rest
  | name :: rest when String.starts_with ~prefix:"--" name -> (
      require (List.mem name known) ("unknown option " ^ name);
      match rest with
      | value :: rest when not (List.mem_assoc name given) -> options ((name, value) :: given) rest
      | _ -> reject (name ^ " needs a value, and only one"))
  | file :: rest ->
      require (not (List.mem_assoc "FILE" given)) "FILE needs a value, and only one";
      options (("FILE", file) :: given) rest

(* Matrices over one denominator. *)
let clear_denominators size rows =
  let denominator =
    List.fold_left
      (fun d row ->
        List.fold_left
          (fun d x ->
            let d = Z.lcm d (Q.den x) in
            require (Z.numbits d <= 10_000) "common denominator too large";
            d)
          d row)
      Z.one rows
  in
  require (List.length rows * size * Z.numbits denominator <= 1 lsl 32) "matrices too large";
  let cleared = List.map (List.map (fun x -> Z.mul (Q.num x) (Z.divexact denominator (Q.den x)))) rows in
  let rec split k taken rows =
    match rows with row :: rest when k > 0 -> split (k - 1) (row :: taken) rest | _ -> (List.rev taken, rows)
  in
  let rec cut rows = match split size [] rows with [], _ -> [] | matrix, rest -> matrix :: cut rest in
  { size; denominator; matrices = cut cleared }

let read_rows r head count size = List.init (count * size) (fun _ -> List.map rational (take r head size size))

let read_matrices file =
  read file 65 (fun r ->
      match take r "matrices" 2 2 with
      | [ count; n ] ->
          let count = size count 1 4096 and n = size n 1 256 in
          require (count * n * n <= 1 lsl 22) "more entries than 2^22";
          let rows = read_rows r "row" count n in
          require (at_end r) "text after the last row";
          clear_denominators n rows
      | _ -> assert false)

let integers_of_basis r head n =
  let family = clear_denominators n (read_rows r head 1 n) in
  (List.hd family.matrices, family.denominator)

let rec blocks_of family = function
  | [] -> []
  | [ _ ] -> [ family ]
  | d :: rest ->
      require (triangular d family) "not block upper triangular";
      first_block d family :: blocks_of (other_blocks d family) rest

(* The lines `inverse` and `column`: what Theorem 25 of SPEC.md says, or a rejection. Only a hint to begin with, it is
   looked at so that a certificate that is wrong is rejected. *)
let check_inverse r family word re im lower =
  let n = family.size and parts = if Q.sign im = 0 then 1 else 2 in
  let bits = size (List.hd (take r "inverse" 1 1)) 0 4096 in
  let columns =
    List.init n (fun k -> Array.of_list (List.map integer (take r (Printf.sprintf "column %d" k) (parts * n) (parts * n))))
  in
  let whole = Q.of_bigint (Z.pow family.denominator (List.length word)) and unit = Q.of_bigint (Z.shift_left Z.one bits) in
  let product = Eigenvalue_hint.product_of family word Z.one in
  let x = Q.mul re whole and y = Q.mul im whole in
  let sum f = List.fold_left Q.add Q.zero (List.init n f) in
  let absolute x = Q.abs x in
  let column k values =
    let real = Array.sub values 0 n and imaginary = if parts = 2 then Array.sub values n n else Array.make n Z.zero in
    let moved v i = Array.fold_left Z.add Z.zero (Array.mapi (fun j a -> Z.mul a v.(j)) product.(i)) in
    let off i =
      let q = Q.of_bigint in
      let a = Q.sub (Q.sub (Q.mul x (q real.(i))) (Q.mul y (q imaginary.(i)))) (q (moved real i)) in
      let b = Q.sub (Q.add (Q.mul x (q imaginary.(i))) (Q.mul y (q real.(i)))) (q (moved imaginary i)) in
      let one = if i = k then Q.mul whole unit else Q.zero in
      Q.add (absolute (Q.sub one a)) (absolute b)
    in
    let size i = Q.of_bigint (Z.add (Z.abs real.(i)) (Z.abs imaginary.(i))) in
    (sum off, sum size, real.(k), imaginary.(k))
  in
  let columns = List.mapi column columns in
  let most f = List.fold_left (fun m c -> Q.max m (f c)) Q.zero columns in
  let off = Q.div (most (fun (a, _, _, _) -> a)) (Q.mul whole unit) and length = Q.div (most (fun (_, b, _, _) -> b)) unit in
  require (Q.lt off Q.one) "the inverse is none of the product less the given eigenvalue";
  let modulus a b =
    let square = Q.add (Q.mul a a) (Q.mul b b) in
    let scaled = Q.mul square (Q.of_bigint (Z.shift_left Z.one 640)) in
    Q.make (Z.sqrt (Z.fdiv (Q.num scaled) (Q.den scaled))) (Z.shift_left Z.one 320)
  in
  let total f = Q.of_bigint (List.fold_left (fun s c -> Z.add s (f c)) Z.zero columns) in
  let trace = Q.div (modulus (total (fun (_, _, a, _) -> a)) (total (fun (_, _, _, b) -> b))) unit in
  let steep = Q.sub trace (Q.div (Q.mul (Q.mul (Q.of_int n) length) off) (Q.sub Q.one off)) in
  require (Q.sign steep > 0) "the inverse proves no eigenvalue near the given one";
  let bound = Q.sub (modulus re im) (Q.div (Q.of_int n) (Q.mul steep whole)) in
  require (Q.sign bound > 0) "the product proves no positive spectral radius";
  match lower with
  | Some l when Q.sign l > 0 ->
      require (Q.geq bound (power l (List.length word))) "the product's spectral radius does not prove the claim"
  | _ -> ()

let bound_of = Sections.bound_of

(* Whether a section proves a bound of its block. Graphs and norms, which take long, are looked at once, by the check of the
   claim. *)
let proves block u section = match section with Graph _ | Norm _ -> true | _ -> check_section block (bound_of u) section

(* The bounds that the certificate says of itself, for people: what is proved is the claim. *)
let read_bounds r =
  match take r "bounds" 2 2 with
  | [ low; high ] ->
      if low <> "-" then ignore (rational low);
      if String.starts_with ~prefix:"C" high then ignore (size (String.sub high 1 (String.length high - 1)) 1 500)
      else if high <> "-" then ignore (rational high)
  | _ -> assert false

let line r head = ignore (take r head 0 0)

let read_end r =
  line r "end";
  require (at_end r) "text after 'end'"

(* An exact number, of which the program is given its text and its parts; the same must stand in the certificate. *)
type exact = { text : string; order : int option; number : exact_number }

(* |[p0,p1,...,pd]@RE,IM,EPS|^1/L, for exponents M-log before it *)
let read_exact exponent text =
  let expected = "an exact exponent is M-log|[p0,p1,...]@RE,IM,EPS|^1/L, an exact radius the same without M-log" in
  let find part from =
    let rec search k =
      if k + String.length part > String.length text then reject expected
      else if String.sub text k (String.length part) = part then k
      else search (k + 1)
    in
    search from
  in
  let between start stop = require (start <= stop) expected; String.sub text start (stop - start) in
  let bar = find "|[" 0 in
  let close = find "]@" bar in
  let root = find "|^1/" close in
  let before = between 0 bar in
  require (exponent = String.ends_with ~suffix:"-log" before && (exponent || before = "")) expected;
  let order = if exponent then Some (size (String.sub before 0 (bar - 4)) 0 500) else None in
  let polynomial = List.map integer (String.split_on_char ',' (between (bar + 2) close)) in
  let degree = List.length polynomial - 1 in
  require
    (degree >= 1 && degree <= 256 && Z.sign (List.nth polynomial degree) <> 0)
    "a polynomial has the degree 1 to 256 and a leading coefficient that is not zero";
  match List.map rational (String.split_on_char ',' (between (close + 2) root)) with
  | [ re; im; eps ] ->
      require (Q.sign eps > 0) "the distance of a zero must be positive";
      let disc_scale = Z.lcm (Q.den re) (Z.lcm (Q.den im) (Q.den eps)) in
      let scaled x = Z.mul (Q.num x) (Z.divexact disc_scale (Q.den x)) in
      let length = size (between (root + 4) (String.length text)) 1 1000 in
      { text; order;
        number = { polynomial; disc_re = scaled re; disc_im = scaled im; disc_radius = scaled eps; disc_scale; root = length } }
  | _ -> reject expected

let show_exact exact =
  let e = exact.number in
  let over x = Q.to_string (Q.make x e.disc_scale) in
  let logarithm = match exact.order with Some m -> Printf.sprintf "%d less the logarithm, to the base of the arity, of " m | None -> "" in
  Printf.printf "exactly %sthe root %d of the modulus of the zero within %s of %s + i %s of the polynomial\n" logarithm e.root
    (over e.disc_radius) (over e.disc_re) (over e.disc_im);
  List.iteri (fun k c -> Printf.printf "coefficient of x^%d is %s\n" k (Z.to_string c)) e.polynomial

(* The number that is claimed or, where none is, that which the certificate names all the same; and where it is. `domain`
   is asked with the line of the claim. *)
let read_head ?(domain = ignore) ~exponent r claim exact =
  line r "subcert-certificate 3";
  line r claim;
  domain ();
  read_bounds r;
  let named () = if at r "exact" then Some (read_exact exponent (List.hd (take r "exact" 1 1))) else None in
  let exact = match exact with Some e -> line r ("exact " ^ e.text); exact | None -> named () in
  Option.map (fun e -> (e, Attained_hint.read_root r e.number)) exact

(* A basis, and the diagonal blocks of the family in it; no basis where there is one block. *)
type lines = { new_basis_of : basis option; block_sizes : int list; blocks : family list }

let read_basis family r =
  let n = family.size in
  let divided = at r "blocks" in
  let sizes = if divided then List.map (fun f -> size f 1 n) (take r "blocks" 1 n) else [ n ] in
  require (List.fold_left ( + ) 0 sizes = n) "the block sizes do not sum to n";
  let new_basis_of =
    if not divided then None
    else begin
      let basis_rows, b = integers_of_basis r "basis" n in
      let inverse_rows, c = integers_of_basis r "inverse" n in
      let basis = { basis_rows; inverse_rows; basis_scale = Z.mul b c } in
      require (basis_valid n basis) "basis times inverse is not the unit matrix";
      Some basis
    end
  in
  let whole = match new_basis_of with None -> family | Some basis -> in_basis family basis in
  { new_basis_of; block_sizes = (if divided then sizes else []); blocks = blocks_of whole sizes }

(* The product, of one of the blocks from number `first` on. `of_values`: it is one of the matrices of each value, from which
   nothing follows here. *)
let read_product ?(of_values = false) ?(first = 0) lines lower r =
  if lower = None && not (at r "product") then (0, None)
  else if of_values then (ignore (take r "product" 4 (3 + 4096)); (0, None))
  else
    match take r "product" 4 (3 + 4096) with
    | block :: re :: im :: letters ->
        let chosen = size block first (List.length lines.blocks - 1) in
        let block = List.nth lines.blocks chosen in
        let re = rational re and im = rational im in
        let word = List.map (fun f -> size f 0 (List.length block.matrices - 1)) letters in
        Sections.spend_product block (List.length word);
        if at r "inverse" then check_inverse r block word re im lower;
        let hint = Eigenvalue_hint.make block word re im in
        let proves l = match hint with Some e -> eigenvalue block e (bound_of l) | None -> false in
        let needed = match lower with Some l when Q.sign l > 0 -> l | _ -> Q.zero in
        require (proves needed) "the product's spectral radius is not shown to be that large";
        (chosen - first, hint)
    | _ -> assert false

let read_logarithm r =
  let logarithm = if at r "logarithm" then take r "logarithm" 1 3 else [] in
  (logarithm, if logarithm <> [] && at r "recurrence" then Single_hint.polynomial r "recurrence" 2 else [])

(* The section of block i, which proves the upper bound *)
let read_bound ~single upper r i block =
  let own, section, _ = Sections.read_section ~single ~may_keep:false r i block upper in
  (match (own, upper) with
  | Some g, Some u -> require (Q.leq g u) "the bound does not prove the claim"
  | _ -> ());
  (match upper with
  | Some u when Q.sign u >= 0 ->
      require (proves block u section) (Printf.sprintf "block %d does not prove the upper end" i)
  | Some _ -> reject "the upper end is negative"
  | None -> ());
  (block.size, section)

(* What proves bounds of the radius. *)
let read_proof ?of_values ~single family lower upper r =
  let lines = read_basis family r in
  let chosen, eigenvector = read_product ?of_values lines lower r in
  let single = single && lines.new_basis_of = None in
  let sections = if upper = None && not (at r "block 0") then [] else List.mapi (read_bound ~single upper r) lines.blocks in
  { new_basis = lines.new_basis_of; sections; sizes = lines.block_sizes; chosen; eigenvector }

(* Where the number is, and sections of blocks, the first of them number `first`, that prove that their radius is the number *)
let read_exact_sections ~single (e, root) first blocks r =
  let place = Attained_hint.place_of e root Attained_hint.least_bits in
  require (check_number e place) "no zero is proved so near";
  let low = Q.make place.low place.bottom in
  let section i block =
    let own, section, beside = Sections.read_section ~single ~may_keep:true r (first + i) block (Some low) in
    match (section, beside) with
    | Single (squares, recurrence), _ ->
        Sections.spend_powers block squares.symbol (8 * List.length recurrence);
        let pole = Single_hint.make_pole block squares recurrence e.polynomial in
        require (simple_number e place) "one spectral radius is a positive zero";
        require (no_larger block e.polynomial place pole) "the exact radius may not be the largest zero of the recurrence";
        require (is_pole block e.polynomial place pole) "the exact radius may be no pole";
        (block, `Whole (Leading pole))
    | _, Body polytope when at r "cycle" -> (block, `Draft (Attained_hint.read_lines r polytope e root place))
    | _, Kept kept when Sections.keeps kept || at r "cycle" -> (block, `Cycles (Cycles_hint.read r block e root place section kept))
    | _ ->
        require (Option.fold ~none:true ~some:(fun g -> Q.leq g low) own) "the bound of a block is above the exact radius";
        require (proves block low section) "the bound of a block is above the exact radius";
        (block, `Whole (Bounded section))
  in
  let sections = List.mapi section blocks in
  let most least polytope graph =
    let larger m = function _, `Draft draft -> max m (polytope draft) | _, `Cycles draft -> max m (graph draft) | _ -> m in
    List.fold_left larger least sections
  in
  let margin = most 0 (fun d -> d.Attained_hint.margin) (fun d -> d.Cycles_hint.more) in
  let bits = most Attained_hint.least_bits (fun d -> d.Attained_hint.bits_needed) (fun d -> d.Cycles_hint.bits) in
  let place = Attained_hint.place_of ~margin e root bits in
  require (check_number e place) "no zero is proved so near";
  let written (block, section) =
    match section with
    | `Whole section -> (block.size, section)
    | `Draft draft ->
        let section = Attained_hint.write_out draft e root place in
        require (block_below e place block section) "an image may lie outside";
        require (block_reaches e place block section) "the eigenvector of a cycle may be zero where the vertex is large";
        (block.size, section)
    | `Cycles draft ->
        (* the words, which take long, are followed once, by the check of the claim *)
        let section = draft.Cycles_hint.write place in
        require (block_reaches e place block section) Cycles_hint.zero_coordinate;
        (block.size, section)
  in
  let exact_blocks = List.map written sections in
  if List.for_all (function _, Bounded _ -> true | _ -> false) exact_blocks then
    if List.exists (function _, Bounded (Quadratic _) -> true | _ -> false) exact_blocks then
      raise (Sections.Undecided "whether a word keeps a form is not decided here, but by subcert-check")
    else reject "no block attains the exact radius";
  { number_place = place; exact_basis = None; exact_blocks }

(* What proves that the radius is the number. *)
let read_exact_proof ~single family number r =
  let lines = read_basis family r in
  ignore (read_product lines None r);
  let single = single && lines.new_basis_of = None in
  { (read_exact_sections ~single number 0 lines.blocks r) with exact_basis = lines.new_basis_of }

let show what claim =
  let text q = Q.to_string (Q.make q.qnum q.qden) in
  let family = claim.matrices_of in
  Printf.printf "the joint spectral %s of %d matrices of size %d%s%s\n" what (List.length family.matrices) family.size
    (match claim.lower with Some l -> ", at least " ^ text l | None -> "")
    (match claim.upper with Some u -> ", at most " ^ text u | None -> "");
  List.iter
    (List.iter (fun row ->
         print_endline
           ("row " ^ String.concat " " (List.map (fun x -> Q.to_string (Q.make x family.denominator)) row))))
    family.matrices

let side value render = match value with Some q -> render (Q.to_string q) | None -> ""
let number_text exact = match exact with Some e -> " = " ^ e.text | None -> ""

let unproved = "the certificate does not prove the claim"

(* Matrices, what is claimed of them, and the line that says so *)
let read_claim what matrices lower upper =
  let family = read_matrices matrices in
  let claim = { matrices_of = family; lower = Option.map bound_of lower; upper = Option.map bound_of upper } in
  (family, claim, Printf.sprintf "%s %d %d" what (List.length family.matrices) family.size)

(* The text of a claim about matrices, its proof, and what --show prints *)
let matrix_claim what matrices lower upper exact claim theorem =
  ( side lower (fun l -> l ^ " <= ") ^ "joint spectral " ^ what ^ number_text exact ^ side upper (fun u -> " <= " ^ u) ^ " of " ^ matrices,
    theorem,
    fun () ->
      show what claim;
      Option.iter show_exact exact )

(* A claim about the radius, and what --theorem prints of it *)
let radius matrices lower upper exact file =
  let family, claim, head = read_claim "radius" matrices lower upper in
  matrix_claim "radius" matrices lower upper exact claim
    (read file 1 (fun r ->
         match read_head ~exponent:false r head exact with
         | None ->
             let certificate = read_proof ~single:false family lower upper r in
             read_end r;
             require (check_radius claim certificate) unproved;
             fun name -> Theorem.print_radius name claim certificate
         | Some ({ number; _ }, root) ->
             let certificate = read_exact_proof ~single:false family (number, root) r in
             read_end r;
             require (check_exact_radius family number claim.lower claim.upper certificate) unproved;
             fun name -> Theorem.print_exact_radius name claim number certificate))

(* The same of the subradius *)
let subradius matrices lower upper exact file =
  let family, claim, head = read_claim "subradius" matrices lower upper in
  let domain () = require (all_nonnegative family []) "a matrix is not non-negative" in
  matrix_claim "subradius" matrices lower upper exact claim
    (read file 1 (fun r ->
         let number = Option.map (fun (e, root) -> (e.number, root)) (read_head ~domain ~exponent:false r head exact) in
         let bounds, draft = Subradius.read r family lower upper number in
         read_end r;
         match (number, draft) with
         | Some (e, root), Some draft ->
             let place, ascent = Ascent_hint.write_out draft e root in
             require (check_exact_subradius family e claim.lower claim.upper place ascent bounds) unproved;
             fun name -> Theorem.print_exact_subradius name claim e place ascent bounds
         | _ ->
             require (check_subradius claim bounds) unproved;
             fun name -> Theorem.print_subradius name claim bounds))

(* The text [c0,c1,...]/D@first *)
let read_mask text arity =
  let expected = "a mask is [c0,c1,...]/D@first" in
  let entries, over, first = read_list text expected in
  let scale = rational ("1" ^ over) in
  let values = List.map (fun c -> Q.mul (rational c) scale) entries in
  let zero k = Q.sign (List.nth values k) = 0 and count = List.length values in
  require
    (count <= 1000 && not (zero 0) && not (zero (count - 1)))
    "a mask has 1 to 1000 coefficients, the first and the last not zero";
  let cleared = clear_denominators count [ values ] in
  { arity; first; coefficients = List.hd (List.hd cleared.matrices); common = cleared.denominator }

let read_arity text = size text 2 16

let show_exponent scheme lower upper exact =
  Printf.printf "the Hoelder exponent of the scheme of arity %d%s%s\n" scheme.arity
    (side lower (fun l -> ", at least " ^ l))
    (side upper (fun u -> ", at most " ^ u));
  List.iteri
    (fun k c ->
      Printf.printf "coefficient %s is %s\n" (Z.to_string (Z.add scheme.first (Z.of_int k)))
        (Q.to_string (Q.make c scheme.common)))
    scheme.coefficients;
  Option.iter show_exact exact

(* MASK;MASK;..., over one denominator *)
let read_masks text arity =
  let texts = String.split_on_char ';' text in
  require (List.length texts <= 64) "more masks than this checker allows";
  let masks_arity = read_arity arity in
  let schemes = List.map (fun mask -> read_mask mask masks_arity) texts in
  let common = List.fold_left (fun d s -> Z.lcm d s.common) Z.one schemes in
  require (Z.numbits common <= 10_000) "common denominator too large";
  let over_common s = (s.first, List.map (Z.mul (Z.divexact common s.common)) s.coefficients) in
  { masks_arity; masks_common = common; each = List.map over_common schemes }

type order = Sequences of sequences | Period of int * int list

(* any, follows=B-C,B-C,... or period=J,J,..., of so many masks *)
let read_order text count arity =
  let expected = "an order is any, period=0,1,... or follows=0-1,1-0,..." in
  let number text = size text 0 (count - 1) in
  let pair text = match String.split_on_char '-' text with [ b; c ] -> (number b, number c) | _ -> reject expected in
  match String.split_on_char '=' text with
  | [ "any" ] -> Sequences Any
  | [ "follows"; pairs ] ->
      let pairs = String.split_on_char ',' pairs in
      require (List.length pairs <= 4096) expected;
      Sequences (Follows (List.map pair pairs))
  | [ "period"; numbers ] ->
      let numbers = String.split_on_char ',' numbers in
      require (List.length numbers <= 6) "a longer period than this checker allows";
      let numbers = List.map number numbers in
      let classes = List.fold_left (fun product _ -> product * arity) 1 numbers in
      require (classes <= 64) "a longer period than this checker allows";
      Period (List.hd numbers, List.tl numbers)
  | _ -> reject expected

let read_order_of_masks text masks =
  let order = read_order text (List.length masks.each) masks.masks_arity in
  (match order with
  | Period (first, others) ->
      let longer points k = (masks.masks_arity * (points - 1)) + List.length (snd (List.nth masks.each k)) in
      require (List.fold_left longer 1 (first :: others) <= 1000) "the masks of a period have more than 1000 coefficients together"
  | Sequences _ -> ());
  order

let show_masks masks order =
  Printf.printf "the limits of arity %d, a mask for each level\n" masks.masks_arity;
  List.iteri
    (fun i (first, coefficients) ->
      let coefficient k c =
        Printf.printf "coefficient %s of mask %d is %s\n" (Z.to_string (Z.add first (Z.of_int k))) i
          (Q.to_string (Q.make c masks.masks_common))
      in
      List.iteri coefficient coefficients)
    masks.each;
  match order with
  | Sequences Any -> print_endline "all sequences of these masks"
  | Sequences (Follows pairs) -> List.iter (fun (b, c) -> Printf.printf "mask %d may be followed by mask %d\n" b c) pairs
  | Period (i, others) -> print_endline ("in turn the masks " ^ String.concat ", " (List.map string_of_int (i :: others)))

let stable_shifts scheme =
  match Stability_hint.make scheme with Some shifts -> shifts | None -> reject "stability: not shown for the integer shifts"

(* Whether the proved checker accepts what was read, what it says if not, and what --theorem prints *)
type proof = { holds : scheme -> bool; otherwise : string; statement : Theorem.statement }

(* Bounds of the radius have so many binary digits. *)
let digits = 128

(* arity^(order - lower), rounded down: the largest radius that proves a lower end *)
let most_radius arity order l =
  let top = Z.sub (Z.mul (Z.of_int order) l.qden) l.qnum in
  let power = power_below (Z.of_int arity) order top l.qden in
  Q.make (Z.fdiv (Z.shift_left power digits) unity) (Z.shift_left Z.one digits)

(* That an end is one that sum rules of this order may prove *)
let check_lower_end lower order =
  require (Q.sign lower > 0) "the lower end of an exponent must be positive";
  require (Q.leq lower (Q.of_int order)) "the order of the sum rules does not prove the claim"

(* Of bounds of the exponent. `full`: the upper end follows from the number of the sum rules. *)
let read_bounds_proof scheme order shifts full family lower upper r =
  let l = bound_of lower and base = Z.of_int scheme.arity in
  let bound = most_radius scheme.arity order l in
  (* arity^(order - upper), rounded up *)
  let least u =
    require (Q.sign u >= 0 && Q.leq u (Q.of_int 10_000)) "an exponent is negative or too large";
    let divisor = power_below base order (Q.num u) (Q.den u) in
    let whole = Z.shift_left (Z.mul (Z.pow base order) unity) digits in
    (* above 1, where stability needs it *)
    Q.make (Z.max (Z.cdiv whole divisor) (Z.succ (Z.shift_left Z.one digits))) (Z.shift_left Z.one digits)
  in
  let least = if full then None else Option.map least upper in
  let low = { order; bound = bound_of bound; of_radius = read_proof ~single:true family least (Some bound) r } in
  match (upper, least) with
  | Some u, Some g ->
      let both = { lower_end = low; radius_least = bound_of g; shifts = Lazy.force shifts } and u = bound_of u in
      { holds = (fun a -> check_exponent a l u both); otherwise = unproved; statement = Theorem.enclosure l u both }
  | Some u, None ->
      let shifts = Lazy.force shifts and u = bound_of u in
      { holds = (fun a -> check_full a l u low shifts); otherwise = unproved; statement = Theorem.full l u low shifts }
  | _ -> { holds = (fun a -> check_exponent_lower a l low); otherwise = unproved; statement = Theorem.exponent l low }

(* What the lines `logarithm` and `recurrence` are worth. *)
let modulus_proof scheme order certificate power (fields, recurrence) =
  require (fields <> []) "the logarithm of the claim is not proved";
  require (size (List.hd fields) 0 256 = power) "the logarithm of the claim is not proved";
  let place = certificate.number_place in
  let rec below j reached = if Z.gt (Z.mul reached place.bottom) place.high then j - 1 else below (j + 1) (Z.mul reached (Z.of_int scheme.arity)) in
  let below = below 0 Z.one in
  require (0 <= below && below < order) "the exact radius is not below a power of the arity";
  match fields with
  | [ _; "norm"; level ] when power = 0 ->
      let level = size level 1 64 in
      require (divides scheme (order - below)) "the mask has no sum rules of this order";
      Sections.spend_norm (difference_family scheme (order - below)) level;
      Whole (below, level)
  | [ _ ] when recurrence = [] && power = 0 && attains_alone certificate -> Between below
  | _ ->
      let undecided = Sections.Undecided "this modulus of continuity is not decided here, but by subcert-check" in
      match certificate.exact_blocks with
      | [ (_, Leading pole) ] when recurrence = [] ->
          require (pole.multiplicity = power + 1) "products grow with another power";
          raise undecided
      | [ (_, Leading pole) ] ->
          require (below mod 2 = 0) "the differences of this order need a norm";
          let scale = Single_hint.scale_above scheme below pole in
          let family = family_above scheme order below scale in
          require (family.size <= 256) "transition matrices larger than 256";
          let symbol = List.map (Z.mul scale) (symbol_above scheme order below) in
          Sections.spend_powers family symbol (8 * List.length recurrence);
          let above = Single_hint.pole_above scheme below pole recurrence scale family symbol in
          require (above.multiplicity = power + 1) "products grow with another power";
          if power = 1 && pole.multiplicity = 1 then Double (below, scale, above) else raise undecided
      | _ ->
          require (recurrence = []) "the differences of this order need a norm";
          raise undecided

(* Of what the exponent is, with bounds or without *)
let read_number_proof scheme order shifts family lower upper logarithm ({ number = e; _ } as exact, root) r =
  require (exact.order = Some order) "the exact exponent has another number before its logarithm";
  let certificate = read_exact_proof ~single:true family (e, root) r in
  let modulus = read_logarithm r and lower = Option.map bound_of lower and upper = Option.map bound_of upper in
  let shifts = Lazy.force shifts in
  match logarithm with
  | None ->
      { holds = (fun a -> check_exact_exponent a order e lower upper certificate shifts);
        otherwise = unproved;
        statement = Theorem.exact_exponent order e lower upper certificate shifts }
  | Some power ->
      let proof = modulus_proof scheme order certificate power modulus in
      { holds = (fun a -> check_logarithm a order e lower upper certificate shifts proof power);
        otherwise = "the modulus of continuity is not proved";
        statement = Theorem.logarithm order e lower upper certificate shifts proof power }

(* The difference matrices of a mask, and what is wrong if there are none *)
let differences scheme order =
  require (divides scheme order) "the mask has no sum rules of this order";
  let degree = List.length scheme.coefficients - 1 - (order * (scheme.arity - 1)) in
  require (degree <= 256 * (scheme.arity - 1)) "transition matrices larger than 256";
  difference_family scheme order

(* No limit in C^k, beside what is shown *)
let with_rough order shifts rough proof =
  match rough with
  | None -> proof
  | Some k ->
      let shifts = Lazy.force shifts in
      { proof with
        holds = (fun a -> proof.holds a && check_rough a order k shifts);
        statement = { proof.statement with rough = Some (order, k, shifts) } }

(* sum-rules M, perhaps full *)
let read_sum_rules r =
  let fields = take r "sum-rules" 1 2 in
  let order = size (List.hd fields) 1 500 and full = List.length fields = 2 in
  require (not full || List.nth fields 1 = "full") "expected 'sum-rules M' or 'sum-rules M full'";
  (order, full)

(* What is shown of a mask, from its sum rules on *)
let read_mask_proof scheme lower upper rough number logarithm r =
  let order, full = read_sum_rules r in
  require
    (Z.equal (List.fold_left Z.add Z.zero scheme.coefficients) (Z.mul (Z.of_int scheme.arity) scheme.common))
    "the coefficients of the mask do not sum to the arity";
  Option.iter (fun l -> check_lower_end l order) lower;
  if upper <> None || rough <> None || number <> None || at r "stability" then line r "stability";
  let family = differences scheme order and shifts = lazy (stable_shifts scheme) in
  let symbol = difference_symbol scheme order in
  let one_more t = Z.equal (class_sum scheme.arity symbol t) scheme.common in
  require (not (full && List.for_all one_more (List.init scheme.arity Fun.id))) "the mask has another sum rule";
  let enough k = full && k >= order in
  require
    (Option.fold ~none:true ~some:enough rough)
    "less smoothness than that needs the full number of sum rules, and no more of them";
  match (number, lower, rough) with
  | Some number, _, _ ->
      with_rough order shifts rough (read_number_proof scheme order shifts family lower upper logarithm number r)
  | None, Some lower, _ ->
      let full = full && Option.fold ~none:false ~some:(fun u -> Q.geq u (Q.of_int order)) upper in
      with_rough order shifts rough (read_bounds_proof scheme order shifts full family lower upper r)
  | None, None, Some k ->
      ignore (read_proof ~single:true family None None r);
      let shifts = Lazy.force shifts in
      { holds = (fun a -> check_rough a order k shifts); otherwise = unproved; statement = Theorem.rough order k shifts }
  | None, None, None -> assert false

(* The line `reduced`: the coefficients of the factor, and the other mask, to begin where that of the claim does *)
let read_factor scheme r =
  match List.map (fun text -> read_mask text scheme.arity) (take r "reduced" 2 2) with
  | [ { coefficients = factor; _ }; other ] ->
      let longest = List.length scheme.coefficients + List.length other.coefficients in
      let bits = Sections.widest (Array.of_list (scheme.common :: other.common :: (factor @ other.coefficients))) in
      spend (List.length factor * longest * width bits);
      let other = { other with first = scheme.first } in
      require (Z.sign (List.fold_left Z.add Z.zero factor) <> 0) "the factor of the reduced mask is 0 at 1";
      require (check_factor scheme other factor) "the reduced mask is not that of the mask and the factor";
      (factor, other)
  | _ -> assert false

(* The lines from the second `sum-rules` on: why the scheme of the mask converges. What is to be shown is that the radius
   is below the power of the arity; the bound is that, less a little. *)
let read_convergence scheme r =
  let own_order = size (List.hd (take r "sum-rules" 1 1)) 1 500 in
  let family = differences scheme own_order in
  let power = Z.pow (Z.of_int scheme.arity) own_order in
  let bound = Q.make (Z.pred (Z.shift_left power digits)) (Z.shift_left Z.one digits) in
  (own_order, bound_of bound, read_proof ~single:true family None (Some bound) r)

(* What a claim about a mask is about: its scheme, the line that says so, what is to hold of it, the words for it, and how it
   is written for Coq *)
type subject = { scheme : scheme; head : string; domain : unit -> unit; words : string; in_coq : string -> Theorem.subject }

let one_mask mask arity =
  let scheme = read_mask mask (read_arity arity) in
  { scheme; head = Printf.sprintf "exponent %s %s" mask arity; domain = ignore;
    words = Printf.sprintf "%s with arity %s" mask arity; in_coq = Theorem.scheme_of_mask scheme }

(* The product of masks in turn *)
let mask_of_period masks arity order m i others =
  { scheme = period_scheme m i others; head = Printf.sprintf "lists %s %s %s" masks arity order;
    domain = (fun () -> require (in_period m i others) "a mask of the list does not keep constant data");
    words = Printf.sprintf "%s with arity %s for levels with %s" masks arity order;
    in_coq = Theorem.scheme_of_period m i others }

(* A claim about the exponent of a mask, likewise. The lines `stability` and `full` say nothing that is not found here. *)
let exponent { scheme; head; domain; words; in_coq } lower upper rough exact logarithm file =
  let theorem =
    read file 1 (fun r ->
        let number = read_head ~domain ~exponent:true r head exact in
        let reduced = if at r "reduced" then Some (read_factor scheme r) else None in
        (* it must be shown that the other scheme has a limit *)
        require
          (reduced = None || lower <> None || number <> None)
          "a reduced mask tells the exponent of one mask, with a lower end";
        let subject = Option.fold ~none:scheme ~some:snd reduced in
        let proof = read_mask_proof subject lower upper rough number logarithm r in
        let reduction =
          Option.map
            (fun (shift_factor, other_scheme) ->
              let own_order, own_bound, own_radius = read_convergence scheme r in
              { shift_factor; other_scheme; own_order; own_bound; own_radius })
            reduced
        in
        read_end r;
        let accepted = match reduction with None -> proof.holds scheme | Some c -> check_reduced scheme c proof.holds in
        require accepted proof.otherwise;
        fun name -> Theorem.print_mask name reduction (in_coq name) proof.statement)
  in
  let subject = "Hoelder exponent" ^ number_text exact in
  let subject =
    match rough with
    | Some k -> Printf.sprintf "%sno C^%d limits" (if lower <> None || exact <> None then subject ^ " and " else "") k
    | None -> subject
  in
  ( Printf.sprintf "%s%s%s%s of %s"
      (side lower (fun l -> l ^ " <= "))
      subject
      (side upper (fun u -> " <= " ^ u))
      (match logarithm with Some p -> Printf.sprintf " with |log h|^%d" p | None -> "")
      words,
    theorem,
    fun () ->
      show_exponent scheme lower upper exact;
      Option.iter (Printf.printf "limits, if there are any, are not C^%d\n") rough;
      Option.iter (Printf.printf "the modulus of continuity of the last derivative has the power %d of the logarithm\n") logarithm )

(* The difference matrices of a list of masks *)
let levels_differences m sequences order =
  let has_rules mask = divides (scheme_of m mask) order in
  let scheme_sum (_, coefficients) = List.fold_left Z.add Z.zero coefficients in
  let sums mask = Z.equal (scheme_sum mask) (Z.mul (Z.of_int m.masks_arity) m.masks_common) in
  require (List.for_all sums m.each) "the coefficients of a mask do not sum to the arity";
  require (List.for_all has_rules m.each) "a mask of the list has no sum rules of this order";
  let longest = List.fold_left (fun most (_, c) -> max most (List.length c)) 0 m.each in
  require (longest - 1 - (order * (m.masks_arity - 1)) <= 256 * (m.masks_arity - 1)) "transition matrices larger than 256";
  let width = level_size m order in
  let count, width =
    match sequences with
    | Any -> (List.length m.each, width)
    | Follows pairs -> (List.length pairs, width * states pairs)
  in
  require (width <= 256) "transition matrices larger than 256";
  require (count * m.masks_arity * width * width <= 1 lsl 22) "more entries than 2^22";
  levels_family m sequences order

(* A claim about a mask for each level, of all sequences or along pairs *)
let levels masks arity order m sequences lower file =
  let theorem =
    read file 1 (fun r ->
        let number = read_head ~exponent:true r (Printf.sprintf "lists %s %s %s" masks arity order) None in
        require (number = None) "an exact number is that of one mask or family";
        let order = size (List.hd (take r "sum-rules" 1 1)) 1 500 in
        check_lower_end lower order;
        if at r "stability" then line r "stability";
        let family = levels_differences m sequences order and l = bound_of lower in
        let bound = most_radius m.masks_arity order l in
        let low = { order; bound = bound_of bound; of_radius = read_proof ~single:false family None (Some bound) r } in
        read_end r;
        require (check_levels m sequences l low) unproved;
        fun name -> Theorem.print_levels name m sequences l low)
  in
  ( Printf.sprintf "%s <= Hoelder exponent of %s with arity %s for all sequences of levels%s" (Q.to_string lower) masks arity
      (if order = "any" then "" else " with " ^ order),
    theorem,
    fun () ->
      Printf.printf "the Hoelder exponents are at least %s\n" (Q.to_string lower);
      show_masks m (Sequences sequences) )

(* The family of a claim about schemes of vectors: so much is looked at, and no more *)
let vector_lists_family m sequences c =
  let count, states = match sequences with Any -> (List.length m.each_vector, 1) | Follows pairs -> (List.length pairs, states pairs) in
  let width = states * List.length c.list_spanning in
  require (width <= 256) "transition matrices larger than 256";
  require (count * m.list_arity * width * width <= 1 lsl 22) "more entries than 2^22";
  lists_family m sequences c

(* What proves the radius that is needed, of a claim whose end is reached or, if `strict`, is not *)
let read_vector_radius m sequences c lower strict r =
  let family = vector_lists_family m sequences c in
  let most = most_radius m.list_arity c.list_order (bound_of lower) in
  let less = if strict then Q.make Z.one (Z.shift_left Z.one (digits + Z.numbits family.denominator)) else Q.zero in
  let bound = Q.sub most less in
  let list_radius = read_proof ~single:false family None (Some bound) r in
  read_end r;
  { c with list_bound = bound_of bound; list_radius }

(* Masks in turn are a list in which each is followed by the next one. *)
let vector_sequences m order =
  match read_order order (List.length m.each_vector) m.list_arity with
  | Sequences sequences -> (m, sequences)
  | Period (first, others) -> Vector_lists.in_turn m (first :: others)

(* A claim about a scheme of vectors with a mask for each level *)
let vector_lists masks arity order lower file =
  let m, sequences = vector_sequences (Vector_lists.read_list masks (read_arity arity)) order in
  let theorem =
    read file 1 (fun r ->
        let number = read_head ~exponent:true r (Printf.sprintf "lists %s %s %s vectors" masks arity order) None in
        require (number = None) "an exact number is that of one mask or family";
        require (Q.sign lower > 0) "the lower end of an exponent must be positive";
        let c = read_vector_radius m sequences (Vector_lists.read_space m lower r) lower false r and l = bound_of lower in
        require (check_vector_lists m sequences l c) unproved;
        fun name -> Theorem.print_vector_lists name m sequences l c)
  in
  ( Printf.sprintf "%s <= Hoelder exponent of the vector scheme of %s with arity %s for all sequences of levels%s" (Q.to_string lower) masks arity
      (if order = "any" then "" else " with " ^ order),
    theorem,
    fun () -> Vector_lists.show m sequences (Printf.sprintf "exponents of at least %s of limits of schemes of vectors" (Q.to_string lower)) )

(* A claim about a scheme of vectors with one mask *)
let vector_scheme mask arity lower file =
  if Vectors.has_root mask then raise (Sections.Undecided "masks with square roots are decided by subcert-check");
  let m = Vector_lists.of_texts [ mask ] (read_arity arity) in
  let a = vector_number m 0 and l = bound_of lower in
  let theorem =
    read file 1 (fun r ->
        let number = read_head ~exponent:true r (Printf.sprintf "vectors %s %s" mask arity) None in
        require (number = None) "an exact number is that of one mask or family";
        require (Q.sign lower >= 0) "the lower end of an exponent must be positive";
        let c = read_vector_radius m Any (Vector_lists.read_space m lower r) lower true r in
        require (check_vector_scheme a l c) unproved;
        fun name -> Theorem.print_vector_scheme name a l c)
  in
  ( Printf.sprintf "%s < Hoelder exponent of the vector scheme of %s with arity %s" (Q.to_string lower) mask arity,
    theorem,
    fun () -> Vector_lists.show m Any (Printf.sprintf "exponents above %s of limits of a scheme of vectors" (Q.to_string lower)) )

(* A claim about a Hermite scheme with one mask, or with one for each level *)
let hermite_lists masks arity order derivatives file =
  if order = None && Vectors.has_root masks then raise (Sections.Undecided "masks with square roots are decided by subcert-check");
  let base = read_arity arity in
  let m, sequences =
    match order with
    | None -> (Vector_lists.of_texts [ masks ] base, Any)
    | Some order -> vector_sequences (Vector_lists.read_list masks base) order
  in
  let k = size derivatives 0 500 in
  let head = match order with Some order -> Printf.sprintf "lists %s %s %s hermite" masks arity order | None -> Printf.sprintf "hermite %s %s" masks arity in
  let theorem =
    read file 1 (fun r ->
        let number = read_head ~exponent:true r head None in
        require (number = None) "an exact number is that of one mask or family";
        require (m.list_functions <= k + 1) "fewer derivatives than its data are";
        let lower = Q.of_int k in
        let c = Vector_lists.read_space ~hermite:true m lower r in
        require (k < c.list_order) "the end is not below the number of sum rules";
        let factors = Vector_lists.derivative_factors_of m c in
        let c = read_vector_radius m sequences c lower true r in
        require (check_hermite_lists m sequences k c factors) unproved;
        fun name -> Theorem.print_hermite_lists name m sequences k c factors)
  in
  let of_which = match order with None -> "" | Some "any" -> " for all sequences of levels" | Some order -> " for all sequences of levels with " ^ order in
  ( Printf.sprintf "HC^%d of the Hermite scheme of %s with arity %s%s" k masks arity of_which,
    theorem,
    fun () -> Vector_lists.show m sequences (Printf.sprintf "HC^%d, of Hermite schemes" k) )

(* The intervals that cover a range, one after another, and what is shown of each: the lines from the first `to` on. Bounds are
   below what is needed, as the ends of such claims are not reached, by less than what numbers over `common` may differ. *)
let read_intervals a order lower low high one r =
  let most = most_radius a.ranged_arity order (bound_of lower) in
  let rec intervals reached =
    let next = rational (List.hd (take r "to" 1 1)) in
    require (Q.lt reached next && Q.leq next high) "an interval ends outside of the rest of the range";
    require ((not one) || Q.equal next high) "a claim about sequences of values has one interval";
    let from = bound_of reached and till = bound_of next in
    let common = Ranges.control_common a from till in
    let family = Ranges.control_family a from till common order in
    let bound = Q.sub most (Q.make Z.one (Z.shift_left Z.one (digits + Z.numbits common))) in
    let radius = read_proof ~of_values:true ~single:false family None (Some bound) r in
    let interval = (till, (common, { order; bound = bound_of bound; of_radius = radius })) in
    if Q.equal next high then [ interval ] else interval :: intervals next
  in
  intervals low

(* A claim about the values of a parameter in a range, about all sequences of them, or about those that follow from each other:
   texts of the step, the first values and the first level. The lines `stability`, `full` and `product` say nothing. *)
let ranged mask arity range sequences follows lower file =
  let letter, low, high = Ranges.read_range range in
  let a = Ranges.read_mask letter mask (read_arity arity) in
  let l = bound_of lower and from = bound_of low and till = bound_of high in
  let recurrence = Option.map (fun (step, start, first) -> Ranges.read_recurrence letter step start first) follows in
  let named = Option.fold ~none:"" ~some:(fun (step, start, first) -> Printf.sprintf " recurrence=%s start=%s from=%s" step start first) follows in
  let theorem =
    read file 1 (fun r ->
        let kind = if sequences then "levels" else "exponent" in
        let number = read_head ~exponent:true r (Printf.sprintf "%s %s %s %s%s" kind mask arity range named) None in
        require (number = None) "exact numbers are those of one mask or family";
        let way = Option.map (fun (step, start, last, level) -> Ranges.read_way r step start last level low high) recurrence in
        let order, _ = read_sum_rules r in
        if at r "stability" then line r "stability";
        require (Q.sign lower >= 0) "the lower end of an exponent must be positive";
        require (Q.lt lower (Q.of_int order)) "the order of the sum rules does not prove the claim";
        let intervals = read_intervals a order lower low high sequences r in
        read_end r;
        match (intervals, recurrence, way) with
        | [ (_, (common, proof)) ], Some (step, start, last, level), Some way ->
            let start = bound_of start and last = Option.map bound_of last in
            require (check_follow a step start last level from till l common proof way) unproved;
            fun name -> Theorem.print_follow name a step start last level from till l common proof way
        | [ (_, (common, proof)) ], _, _ when sequences ->
            require (check_range_levels a from till l common proof) unproved;
            fun name -> Theorem.print_range_levels name a from till l common proof
        | _ ->
            require (check_range a from till l intervals) unproved;
            fun name -> Theorem.print_range name a from till l intervals)
  in
  let of_which =
    match follows with
    | Some (step, start, first) ->
        let level = if first = "some" then "some level" else "level " ^ first in
        Printf.sprintf " from %s on of %c -> %s with %c=%s at level 0, all in %s" level letter step letter start range
    | None -> Printf.sprintf " for all %s%s" (if sequences then "sequences of levels with " else "") range
  in
  ( Printf.sprintf "%s < Hoelder exponent of %s with arity %s%s" (Q.to_string lower) mask arity of_which,
    theorem,
    fun () ->
      Printf.printf "the Hoelder exponents are above %s for %sx from %s to %s\n" (Q.to_string lower)
        (if follows <> None then "levels that follow from each other and have "
         else if sequences then "all sequences of levels with " else "all ") (Q.to_string low) (Q.to_string high);
      Ranges.show a;
      Option.iter (fun (step, start, last, _) -> Ranges.show_recurrence step start last) recurrence )

(* arity^(-upper), rounded up, and above arity^(-order): a radius that proves an upper end of functions *)
let least_radius arity order upper =
  require (Q.sign upper >= 0 && Q.leq upper (Q.of_int 10_000)) "an exponent is negative or too large";
  let base = Z.of_int arity in
  let whole = Z.pow base order in
  let digits = digits + Z.numbits whole in
  let above = Z.cdiv (Z.shift_left unity digits) (power_below base order (Q.num upper) (Q.den upper)) in
  Q.make (Z.max above (Z.succ (Z.fdiv (Z.shift_left Z.one digits) whole))) (Z.shift_left Z.one digits)

(* arity^(-lower), rounded down: the largest radius that proves a lower end of functions *)
let most_vector_radius a order lower =
  Q.div (most_radius a.vector_arity order (bound_of lower)) (Q.of_bigint (Z.pow (Z.of_int a.vector_arity) order))

(* What is shown of a vector of functions: a lower end, or both; and what --theorem prints *)
let read_vector_bounds a space lower upper r =
  let order = space.difference_order and l = bound_of lower in
  let bound = most_vector_radius a order lower in
  let least = Option.map (least_radius a.vector_arity order) upper in
  let images = Option.map (fun _ -> Vectors.read_images a space) upper in
  let radius = read_proof ~single:false (vector_family a space) least (Some bound) r in
  let certificate = { space with space_bound = bound_of bound; space_radius = radius } in
  read_end r;
  match (upper, least, images) with
  | Some upper, Some least, Some images ->
      let above = Vectors.with_images certificate images (bound_of least) in
      let u = bound_of upper in
      require (check_vectors_between a l u above) unproved;
      fun name -> Theorem.print_vectors_between name a l u above
  | _ ->
      require (check_vectors a l certificate) unproved;
      fun name -> Theorem.print_vectors name a l certificate

(* The same where the certificate names the exponent *)
let read_vector_number a space lower upper ({ number = e; order; _ }, root) r =
  require (order = Some 0) "the exact exponent has another number before its logarithm";
  let above = Vectors.with_images space (Vectors.read_images a space) space.space_bound in
  let certificate = read_exact_proof ~single:false (vector_family a space) (e, root) r in
  read_end r;
  let lower = Option.map bound_of lower and upper = Option.map bound_of upper in
  require (check_exact_vectors a e lower upper above certificate) unproved;
  fun name -> Theorem.print_exact_vectors name a e lower upper above certificate

(* The line `unobservable`, the basis, and the first blocks, of a part of the space on which component k is 0: their radius is below
   1, by a little. Then the number of these blocks, and the others. *)
let read_hidden a k space lower r =
  let family = vector_family a space in
  let unseen = size (List.hd (take r "unobservable" 1 1)) 0 (family.size - 1) in
  require (unseen = 0 || at r "blocks") "expected 'blocks', those of what is unobservable first";
  let lines = read_basis family r in
  let rec split n = function
    | block :: others when n > 0 ->
        require (block.size <= n) "what is unobservable consists of no blocks";
        let hidden, seen = split (n - block.size) others in
        (block :: hidden, seen)
    | blocks -> ([], blocks)
  in
  let hidden, seen = split unseen lines.blocks in
  let first = List.length hidden in
  let chosen, eigenvector = read_product ~first lines lower r in
  let below = Q.make (Z.pred (Z.shift_left Z.one digits)) (Z.shift_left Z.one digits) in
  let sections = List.mapi (read_bound ~single:false (Some below) r) hidden in
  let observing = match lines.new_basis_of with Some basis -> basis | None -> Vectors.same_basis family.size in
  let unseen_radius = { new_basis = None; sections; sizes = []; chosen = 0; eigenvector = None } in
  let part = { unseen; observing; unseen_bound = bound_of below; unseen_radius } in
  let otherwise = "a component shows what is said to be unobservable" in
  require (component_space a k space part) otherwise;
  (part, first, seen, (chosen, eigenvector))

(* What is shown of one component *)
let read_component a k space lower upper number r =
  let order = space.difference_order in
  let images = if upper = None && number = None then None else Some (Vectors.read_images a space) in
  let least = if number = None then Option.map (least_radius a.vector_arity order) upper else None in
  let part, first, seen, (chosen, eigenvector) = read_hidden a k space least r in
  let observed space_least =
    (Vectors.with_images space (Option.get images) space_least, Vectors.observe a k space part)
  in
  match (number, lower) with
  | Some ({ number = e; order; _ }, root), _ ->
      require (order = Some 0) "the exact exponent has another number before its logarithm";
      let above, observation = observed space.space_bound in
      let certificate = read_exact_sections ~single:false (e, root) first seen r in
      read_end r;
      let lower = Option.map bound_of lower and upper = Option.map bound_of upper in
      require (check_exact_component a k e lower upper above part observation certificate) unproved;
      fun name -> Theorem.print_exact_component name a k e lower upper above part observation certificate
  | None, Some lower -> (
      let bound = most_vector_radius a order lower in
      let sections = List.mapi (fun i -> read_bound ~single:false (Some bound) r (first + i)) seen in
      read_end r;
      let space_radius = { new_basis = None; sections; sizes = List.map fst sections; chosen; eigenvector } in
      let certificate = { space with space_bound = bound_of bound; space_radius } and l = bound_of lower in
      match (upper, least) with
      | Some upper, Some least ->
          let above, observation = observed (bound_of least) and u = bound_of upper in
          let above = { above with space_proof = certificate } in
          require (check_component_between a k l u above part observation) unproved;
          fun name -> Theorem.print_component_between name a k l u above part observation
      | _ ->
          require (check_component a k l certificate part) unproved;
          fun name -> Theorem.print_component name a k l certificate part)
  | None, None -> assert false

(* A claim about a vector of functions: that there is one, and its lower end, or both, or what its exponent is; or that of one
   component *)
let refinable mask dilation component lower upper exact file =
  let a = Vectors.read_mask mask dilation in
  let component = Option.map (fun text -> (text, size text 0 (a.functions - 1))) component in
  let named words = Option.fold ~none:"" ~some:(fun (text, _) -> words text) component in
  let head = Printf.sprintf "refinable %s %s%s" mask dilation (named (fun k -> " component=" ^ k)) in
  let theorem =
    read file 1 (fun r ->
        let number = read_head ~exponent:true r head exact in
        let space = Vectors.read_space a lower r in
        match (component, number, lower) with
        | Some (_, k), _, _ -> read_component a k space lower upper number r
        | None, Some number, _ -> read_vector_number a space lower upper number r
        | None, None, Some lower -> read_vector_bounds a space lower upper r
        | None, None, None -> assert false)
  in
  ( Printf.sprintf "%sHoelder exponent%s%s of %sthe refinable functions of %s with dilation %s" (side lower (fun l -> l ^ " <= "))
      (number_text exact) (side upper (fun u -> " <= " ^ u)) (named (fun k -> "component " ^ k ^ " of ")) mask dilation,
    theorem,
    fun () ->
      Vectors.show a (Option.map snd component) lower upper;
      Option.iter show_exact exact )

let undecided =
  "of claims about exponents only those of one mask with a lower end, an exact number or no C^K limits are decided here, \
   those of lists of masks, lower ends for all values of a parameter or all sequences of them, of schemes of vectors and \
   lists of these, and bounds and exact numbers of refinable functions of one variable, the others by subcert-check"

let check arguments =
  if arguments = [ "--help" ] then raise (Rejected (usage, 0));
  let given = options [] arguments in
  let find name = List.assoc_opt name given in
  let has name = find name <> None and get name = Option.get (find name) in
  let only names = List.for_all (fun (name, _) -> List.mem name ([ "--lower"; "--theorem"; "--show"; "FILE" ] @ names)) given in
  require (has "FILE" && List.exists has [ "--matrices"; "--subradius"; "--mask"; "--masks"; "--surface"; "--refinable"; "--vectors"; "--hermite"; "--l1" ]) usage;
  let letter c = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') and digit c = c >= '0' && c <= '9' in
  let is_name name = name <> "" && letter name.[0] && String.for_all (fun c -> letter c || digit c) name in
  require (Option.fold ~none:true ~some:is_name (find "--theorem")) "--theorem needs a name of letters and digits";
  let bound name = Option.map rational (find name) in
  let after_c text =
    if String.starts_with ~prefix:"C" text then Some (String.sub text 1 (String.length text - 1)) else None
  in
  let rough = Option.bind (find "--upper") after_c in
  (* A claim about one mask, which is read only now *)
  let of_mask subject =
    if not (has "--lower" || has "--exact" || rough <> None) then raise (Sections.Undecided undecided);
    require (has "--exact" || not (has "--logarithm")) usage;
    let logarithm = Option.map (fun p -> size p 0 256) (find "--logarithm") in
    let exact = Option.map (read_exact true) (find "--exact") in
    let upper = if rough = None then bound "--upper" else None in
    let rough = Option.map (fun k -> size k 1 500) rough in
    exponent subject (bound "--lower") upper rough exact logarithm (get "FILE")
  in
  let text, theorem, shown =
    if has "--l1" then begin
      require (only [ "--l1"; "--contraction"; "--upper" ] && (has "--lower" || (has "--contraction" && not (has "--upper")))) usage;
      raise (Sections.Undecided "claims about fits of least absolute deviations are decided by subcert-check")
    end
    else if has "--matrices" || has "--subradius" then begin
      let option, prove = if has "--matrices" then ("--matrices", radius) else ("--subradius", subradius) in
      require (only [ option; "--upper"; "--exact" ] && (has "--lower" || has "--upper" || has "--exact")) usage;
      let exact = Option.map (read_exact false) (find "--exact") in
      prove (get option) (bound "--lower") (bound "--upper") exact (get "FILE")
    end
    else if
      has "--refinable" && has "--dilation" && (has "--lower" || has "--exact") && rough = None
      && only [ "--refinable"; "--dilation"; "--component"; "--upper"; "--exact" ]
    then
      refinable (get "--refinable") (get "--dilation") (find "--component") (bound "--lower") (bound "--upper")
        (Option.map (read_exact true) (find "--exact")) (get "FILE")
    else if has "--vectors" && has "--arity" && has "--lower" && only [ "--vectors"; "--arity"; "--order" ] then begin
      let masks = get "--vectors" and arity = get "--arity" and lower = Option.get (bound "--lower") in
      match find "--order" with
      | Some order -> vector_lists masks arity order lower (get "FILE")
      | None -> vector_scheme masks arity lower (get "FILE")
    end
    else if has "--hermite" && has "--arity" && has "--lower" && only [ "--hermite"; "--arity"; "--order" ] then
      hermite_lists (get "--hermite") (get "--arity") (find "--order") (get "--lower") (get "FILE")
    else if List.exists (fun range -> has range && only [ "--mask"; "--arity"; range ]) [ "--for"; "--levels" ] && has "--arity" && has "--lower" then
      ranged (get "--mask") (get "--arity") (get (if has "--for" then "--for" else "--levels")) (has "--levels") None
        (Option.get (bound "--lower")) (get "FILE")
    else if
      List.for_all has [ "--mask"; "--arity"; "--levels"; "--recurrence"; "--start"; "--from"; "--lower" ]
      && only [ "--mask"; "--arity"; "--levels"; "--recurrence"; "--start"; "--from" ]
    then
      ranged (get "--mask") (get "--arity") (get "--levels") true (Some (get "--recurrence", get "--start", get "--from"))
        (Option.get (bound "--lower")) (get "FILE")
    else if has "--masks" || (has "--order" && not (has "--vectors" || has "--hermite")) then begin
      require (has "--masks" && has "--order" && has "--arity") usage;
      require (only [ "--masks"; "--arity"; "--order"; "--upper"; "--exact"; "--logarithm" ]) usage;
      let masks = get "--masks" and arity = get "--arity" and order = get "--order" in
      let m = read_masks masks arity in
      match read_order_of_masks order m with
      | Sequences _ when has "--upper" && has "--lower" && rough = None && only [ "--masks"; "--arity"; "--order"; "--upper" ] ->
          raise (Sections.Undecided undecided)
      | Sequences sequences ->
          require (has "--lower" && only [ "--masks"; "--arity"; "--order" ]) usage;
          levels masks arity order m sequences (Option.get (bound "--lower")) (get "FILE")
      | Period (i, others) ->
          require (has "--lower" || has "--exact" || not (has "--upper") || rough <> None) usage;
          let text, theorem, shown = of_mask (mask_of_period masks arity order m i others) in
          (text, theorem, fun () -> show_masks m (Period (i, others)); shown ())
    end
    else if
      only [ "--mask"; "--arity"; "--upper"; "--exact"; "--logarithm" ]
      && (has "--lower" || has "--exact" || rough <> None || not (has "--arity"))
    then begin
      require (has "--mask" && has "--arity") usage;
      of_mask (one_mask (get "--mask") (get "--arity"))
    end
    else raise (Sections.Undecided undecided)
  in
  match find "--theorem" with
  | Some name -> theorem name
  | None ->
      print_endline ("VERIFIED " ^ text);
      if has "--show" then shown ()

let () =
  let finish code = exit code in
  match check (List.tl (Array.to_list Sys.argv)) with
  | () -> finish 0
  | exception Rejected (why, 0) -> print_endline why; finish 0
  | exception Rejected (why, 1) -> print_endline ("REJECTED " ^ why); finish 1
  | exception Rejected (why, code) -> prerr_endline ("subcert-check-verified: " ^ why); finish code
  | exception Sections.Undecided why -> print_endline ("UNDECIDED " ^ why); finish 2
