(* Masks with a parameter: the mask and its range, and the control masks of an interval. Of this only the mask and the range
   that are read are trusted. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith
open Text

let max_degree = 12

(* Where one of the characters is, from a place on, or the end *)
let rec next_of characters text at =
  if at >= String.length text || String.contains characters text.[at] then min at (String.length text) else next_of characters text (at + 1)

(* A term c, w, c*w, w^k or c*w^k: its power and its coefficient *)
let read_term letter text =
  match String.index_opt text letter with
  | None -> (0, rational text)
  | Some at ->
      let rest = String.sub text (at + 1) (String.length text - at - 1) and before = String.sub text 0 at in
      require (rest = "" || rest.[0] = '^') "not a term c*w^k";
      let power = if rest = "" then 1 else size (String.sub rest 1 (String.length rest - 1)) 1 max_degree in
      let factor =
        match before with
        | "" -> Q.one
        | "-" -> Q.minus_one
        | _ ->
            require (before.[at - 1] = '*') "not a term c*w^k";
            rational (String.sub before 0 (at - 1))
      in
      (power, factor)

(* A sum of terms: its coefficients, that of w^0 first *)
let read_polynomial letter text =
  require (text <> "") "a coefficient is empty";
  let rec terms begin_ =
    if begin_ = String.length text then []
    else
      let stop = next_of "+-" text (begin_ + 1) in
      let skipped = if begin_ > 0 && text.[begin_] = '+' then begin_ + 1 else begin_ in
      let term = read_term letter (String.sub text skipped (stop - skipped)) in
      term :: terms stop
  in
  let terms = terms 0 in
  let degree = List.fold_left (fun most (power, _) -> max most power) 0 terms in
  List.init (degree + 1) (fun k -> List.fold_left (fun sum (power, c) -> if power = k then Q.add sum c else sum) Q.zero terms)

(* w=LOW..HIGH: the letter and the ends *)
let read_range text =
  let expected = "a range is w=LOW..HIGH with rationals LOW < HIGH" in
  let rec dots k = if k + 1 >= String.length text then reject expected else if text.[k] = '.' && text.[k + 1] = '.' then k else dots (k + 1) in
  let dots = dots 0 in
  require (dots >= 2 && text.[1] = '=') expected;
  let letter = text.[0] in
  require ((letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z')) expected;
  let low = rational (String.sub text 2 (dots - 2)) and high = rational (String.sub text (dots + 2) (String.length text - dots - 2)) in
  require (Q.lt low high) expected;
  (letter, low, high)

let least_common = List.fold_left (fun d x ->
    let d = Z.lcm d (Q.den x) in
    require (Z.numbits d <= 10_000) "common denominator too large";
    d)

(* [c0,c1,...], perhaps with /D or /(Q) and @first after it, the ci polynomials in the letter: all of them, and Q, of one length *)
let read_mask letter text arity =
  let expected = "a mask is [c0,c1,...]/D@first" in
  let entries, over, first = read_list text expected in
  let length = String.length over in
  let divided = length > 3 && over.[1] = '(' && over.[length - 1] = ')' in
  let below = if divided then read_polynomial letter (String.sub over 2 (length - 3)) else [ Q.inv (rational ("1" ^ over)) ] in
  let above = List.map (read_polynomial letter) entries in
  require (List.length above <= 1000) "a mask has 1 to 1000 coefficients";
  let longest = List.fold_left (fun most p -> max most (List.length p)) (List.length below) above in
  let below_common = least_common Z.one below in
  let scaled = List.map (List.map (Q.mul (Q.of_bigint below_common))) above in
  let common = List.fold_left least_common Z.one scaled in
  let whole factor p =
    let terms = Array.of_list p in
    List.init longest (fun k -> if k < Array.length terms then Z.mul (Q.num terms.(k)) (Z.divexact factor (Q.den terms.(k))) else Z.zero)
  in
  let divisor = List.map (Z.mul common) (whole below_common below) in
  { ranged_arity = arity; ranged_first = first; numerators = List.map (whole common) scaled; ranged_divisor = divisor }

(* The least common multiple of the coefficients of the divisor's form on an interval *)
let control_common a low high =
  let weights = form_between low high a.ranged_divisor in
  let sign c = Z.sign c * Z.sign (List.hd weights) in
  require (List.for_all (fun c -> sign c > 0) weights) "the denominator of the mask changes its sign, or may do so";
  List.fold_left Z.lcm Z.one weights

(* The difference matrices of the control masks of an interval *)
let control_family a low high common order =
  let m = control_masks a low high common in
  let sums (_, c) = Z.equal (List.fold_left Z.add Z.zero c) (Z.mul (Z.of_int a.ranged_arity) common) in
  require (List.for_all sums m.each) "the coefficients of the mask do not sum to the arity for all values";
  require (List.for_all (fun p -> divides (scheme_of m p) order) m.each) "the mask has no sum rules of this order for all values";
  let degree = List.length a.numerators - 1 - (order * (a.ranged_arity - 1)) in
  require (degree <= 256 * (a.ranged_arity - 1)) "transition matrices larger than 256";
  let size = level_size m order in
  require (List.length m.each * a.ranged_arity * size * size <= 1 lsl 22) "more entries than 2^22";
  let family = range_family m order in
  let entries = List.concat_map List.concat family.matrices in
  let least = Z.divexact common (List.fold_left Z.gcd common entries) in
  require (Z.numbits least <= 10_000) "common denominator too large";
  require (List.length entries * Z.numbits least <= 1 lsl 32) "matrices too large";
  family

let show a =
  let polynomial p = String.concat " + " (List.mapi (fun k c -> Printf.sprintf "%s x^%d" (Z.to_string c) k) p) in
  let coefficient k p = Printf.printf "coefficient %s is (%s) / q\n" (Z.to_string (Z.add a.ranged_first (Z.of_int k))) (polynomial p) in
  List.iteri coefficient a.numerators;
  Printf.printf "q is %s\n" (polynomial a.ranged_divisor)
