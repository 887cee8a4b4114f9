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

let polynomial p = String.concat " + " (List.mapi (fun k c -> Printf.sprintf "%s x^%d" (Z.to_string c) k) p)

let show a =
  let coefficient k p = Printf.printf "coefficient %s is (%s) / q\n" (Z.to_string (Z.add a.ranged_first (Z.of_int k))) (polynomial p) in
  List.iteri coefficient a.numerators;
  Printf.printf "q is %s\n" (polynomial a.ranged_divisor)

(* ---- a value that follows from the one before ---- *)

(* [P]/D, [P]/(Q) or sqrt before them; LOW..HIGH or LOW..inf; a number or `some` *)
let read_recurrence letter step start from =
  let of_root = String.starts_with ~prefix:"sqrt" step in
  let step = if of_root then String.sub step 4 (String.length step - 4) else step in
  let { numerators; ranged_divisor; _ } = read_mask letter step 2 in
  require (List.length numerators = 1) "a recurrence is [P]/D, [P]/(Q) or sqrt[P]/(Q)";
  let expected = "the first values are LOW..HIGH or LOW..inf" in
  let rec dots k = if k + 1 >= String.length start then reject expected else if start.[k] = '.' && start.[k + 1] = '.' then k else dots (k + 1) in
  let dots = dots 0 in
  let first = rational (String.sub start 0 dots) and last = String.sub start (dots + 2) (String.length start - dots - 2) in
  let last = if last = "inf" then None else Some (rational last) in
  require (Option.fold ~none:true ~some:(Q.leq first) last) expected;
  require ((last = None) = (from = "some")) "a start has a level if it is bounded, else 'some'";
  let from = if from = "some" then None else Some (size from 0 1000) in
  ({ above_bar = List.hd numerators; below_bar = ranged_divisor; of_root }, first, last, from)

let ratio_of q = { qnum = Q.num q; qden = Q.den q }
let pair_of (x, y) = (ratio_of x, ratio_of y)

(* The sign of a polynomial that is not 0 at a place *)
let sign_at p x =
  let value = List.fold_left (fun v c -> Q.add (Q.mul v x) (Q.of_bigint c)) Q.zero (List.rev p) in
  Z.of_int (if Q.sign value < 0 then -1 else 1)

let steps_of r = (List.length r.above_bar + List.length r.below_bar) * 100_000
let not_signed = "the denominator of the recurrence is not shown to be positive"
let beyond side = "what keeps the recurrence from being " ^ side ^ " the next values is not shown to be positive"

(* The sign of the denominator where all values of an interval lead to the next one *)
let step r (low, high) (next_low, next_high) =
  spend (steps_of r);
  let sign = sign_at r.below_bar low in
  let test strict p = signed_between strict (ratio_of low) (ratio_of high) p in
  require (denominator_signed r sign test) not_signed;
  require (next_at_least r sign test (ratio_of next_low)) (beyond "below");
  require (next_at_most r sign test (ratio_of next_high)) (beyond "above");
  sign

(* How far a start without an end is looked at in pieces *)
let descent_of r low high =
  require (Q.sign high > 0) "an unbounded start needs a range with a positive upper end";
  let sign = sign_at r.below_bar high in
  let rec far k =
    spend (steps_of r);
    let far_off = Q.add high (Q.of_bigint (Z.pred (Z.shift_left Z.one k))) in
    let test strict p = signed_beyond strict (ratio_of high) (ratio_of far_off) p in
    if descends r sign (ratio_of low) (ratio_of high) (ratio_of far_off) then (sign, ratio_of far_off)
    else if k < 24 then far (k + 1)
    else begin
      require (denominator_signed r sign test) not_signed;
      require (next_at_least r sign test (ratio_of low)) (beyond "below");
      reject (beyond "above nine tenths of")
    end
  in
  far 0

(* The lines `level`: intervals to which the first values lead, one after another, the last one in the range *)
let read_way r recurrence first last from low high =
  let range_sign = step recurrence (low, high) (low, high) in
  let descent = if last = None then begin
      require (Q.leq first high) "an unbounded start begins above the range";
      Some (descent_of recurrence low high)
    end else None
  in
  let rec levels count at_ =
    if not (at r "level") then begin
      require (Option.fold ~none:true ~some:(fun from -> count <= from) from) "the values come into the range at a later level";
      require (Q.leq low (fst at_) && Q.leq (snd at_) high) "the values do not come into the range";
      []
    end
    else
      match List.map rational (take r "level" 2 2) with
      | [ next_low; next_high ] ->
          require (count < 1000) "more levels than this checker allows";
          require (Q.leq next_low next_high) "the values of a level are an interval";
          let sign = step recurrence at_ (next_low, next_high) in
          (sign, pair_of (next_low, next_high)) :: levels (count + 1) (next_low, next_high)
      | _ -> assert false
  in
  { range_sign; way_levels = levels 0 (first, Option.value last ~default:high); descent }

let show_recurrence r first last =
  Printf.printf "each x is followed by the %s (%s) / (%s)\n" (if r.of_root then "root of" else "value") (polynomial r.above_bar)
    (polynomial r.below_bar);
  Printf.printf "the first x is from %s on%s\n" (Q.to_string first)
    (Option.fold ~none:"" ~some:(fun x -> ", at most " ^ Q.to_string x) last)
