(* What proves one spectral radius: the lines of the section, and quotients of polynomials. Nothing here is proved. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith
open Text

let most_coefficients = 1000
let polynomial r head least = List.map integer (take r head least most_coefficients)
let last list = List.nth list (List.length list - 1)

(* a / p, if that has integer coefficients. *)
let quotient a p =
  let a = Array.of_list a and p = Array.of_list p in
  let degree = Array.length p - 1 in
  let count = Array.length a - degree in
  let result = Array.make (max count 0) Z.zero in
  try
    for k = count - 1 downto 0 do
      let q, rest = Z.div_rem a.(k + degree) p.(degree) in
      if Z.sign rest <> 0 then raise Exit;
      result.(k) <- q;
      Array.iteri (fun i x -> a.(k + i) <- Z.sub a.(k + i) (Z.mul q x)) p
    done;
    if count > 0 && Array.for_all (fun x -> Z.sign x = 0) a then Some (Array.to_list result) else None
  with Exit -> None

(* The coefficients of the symbol, times the denominator of the family. *)
let symbol_of family =
  let columns = List.map (fun m -> Array.of_list (List.map List.hd m)) family.matrices in
  let rows = List.init family.size (fun j -> List.map (fun column -> column.(j)) columns) in
  let rec strip = function x :: rest when Z.sign x = 0 -> strip rest | l -> l in
  let b = List.rev (strip (List.rev (List.concat rows))) in
  require
    (List.length b mod 2 = 1 && b = List.rev b)
    "one spectral radius needs a symmetric mask with an odd number of coefficients";
  b

(* The bound, the sum of squares and the recurrence *)
let read r family fields =
  require (List.length fields = 3) "expected 'single', a bound and the digits of a factor";
  let bound = rational (List.nth fields 1) in
  require (Q.sign bound >= 0) "the bound of a radius is negative";
  let bits = size (List.nth fields 2) 0 4096 in
  let symbol = symbol_of family in
  let content = List.fold_left Z.gcd family.denominator symbol in
  let divisor = polynomial r "square" 1 in
  require (Z.sign (List.hd divisor) <> 0 && Z.sign (last divisor) <> 0) "a polynomial of squares begins or ends with 0";
  let cosine =
    match quotient (List.map (fun x -> Z.divexact x content) symbol) (mirrored divisor) with
    | Some rest -> rest
    | None -> reject "the square does not divide the mask"
  in
  let squares = { symbol; content; divisor; cosine; factor = polynomial r "factor" 1; bits } in
  let long p = List.length p * List.fold_left (fun most x -> max most (width (Z.numbits x))) 1 p in
  spend (3 * ((long squares.factor * long squares.factor) + (long divisor * (long divisor + long cosine))));
  require (sum_of_squares family squares) "the cosine polynomial is not shown to be a sum of squares";
  let recurrence = polynomial r "recurrence" 2 in
  require (Z.sign (last recurrence) <> 0) "the last coefficient of a recurrence is 0";
  (bound, squares, recurrence)

let bounded_by bound recurrence = one_sign (snd (shifted_by (Q.num bound) (Q.den bound) recurrence))

(* Divides by p as often as that goes. *)
let rec divide_out times a p = match quotient a p with Some q -> divide_out (times + 1) q p | None -> (times, a)

(* The zero of p as the largest one of the recurrence: its order as a pole, and the other factors. *)
let make_pole family squares_of recurrence p =
  let arity = List.length family.matrices and b = squares_of.symbol in
  let r = reach_of arity b in
  let first = middles (central_matrix arity b) family.denominator r (unit_at Z.one r) (List.length recurrence) in
  let zeros, cofactor = divide_out 0 recurrence p and lost, _ = divide_out 0 (numerator recurrence first) p in
  require (zeros > lost) "the exact radius may not be the largest zero of the recurrence";
  { squares_of; recurrence; multiplicity = zeros - lost; cofactor }

(* For differences of `below` orders less: what their family is multiplied by, above and below, so that its squares are those
   of the section and powers of sigma; and the pole at 1. *)
let scale_above scheme below pole =
  let whole = Z.pow (Z.of_int scheme.arity) below in
  Z.divexact whole (Z.gcd pole.squares_of.content whole)

let pole_above scheme below pole recurrence scale family symbol =
  require (Z.sign (last recurrence) <> 0) "the last coefficient of a recurrence is 0";
  let squares = pole.squares_of in
  let content = Z.divexact (Z.mul scale squares.content) (Z.pow (Z.of_int scheme.arity) below) in
  let divisor = iterate (below / 2) (times_sigma scheme.arity) squares.divisor in
  make_pole family { squares with symbol; content; divisor } recurrence at_one
