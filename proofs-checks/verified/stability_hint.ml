(* The hint for stable shifts: the values of the limit at the integers, an approximate inverse of the system that they
   solve, and weights for which a combination of values is nearly 1 for the limit and nearly 0 for its shifts. Nothing
   here is proved: what is wrong is not accepted. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith

(* The solution of matrix * x = right as numerators over one denominator, without rounding [Bareiss 1968]. *)
let solve_exactly matrix right =
  let n = Array.length matrix in
  let rows = Array.mapi (fun i row -> Array.append row [| right.(i) |]) matrix in
  let previous = ref Z.one in
  try
    for k = 0 to n - 1 do
      let rec search i = if i = n then raise Exit else if Z.sign rows.(i).(k) <> 0 then i else search (i + 1) in
      let best = search k in
      let row = rows.(best) in
      rows.(best) <- rows.(k);
      rows.(k) <- row;
      for i = 0 to n - 1 do
        if i <> k then begin
          let other = rows.(i) in
          let factor = other.(k) in
          for j = 0 to n do
            other.(j) <- Z.divexact (Z.sub (Z.mul row.(k) other.(j)) (Z.mul factor row.(j))) !previous
          done
        end
      done;
      previous := row.(k)
    done;
    let sign = if Z.sign !previous < 0 then Z.minus_one else Z.one in
    Some (Array.map (fun row -> Z.mul sign row.(n)) rows, Z.abs !previous)
  with Exit -> None

let unit_matrix n one = Array.init n (fun i -> Array.init n (fun j -> if i = j then one else Z.zero))
let arrays = fun rows -> Array.of_list (List.map Array.of_list rows)
let lists rows = Array.to_list (Array.map Array.to_list rows)
let rec int_power base k = if k = 0 then 1 else base * int_power base (k - 1)

(* Weights at the distance arity^-level, more of them than needed for `extra` > 0, the first row and the one where the sum
   is 1. *)
let find_weights scheme precision values scale start level extra =
  let one = Z.shift_left Z.one precision in
  let step = int_power scheme.arity level in
  let fine_values = Array.of_list (fine scheme.arity scheme.coefficients level values) in
  let s = Z.to_int (fine_start scheme.arity scheme.first level start) in
  let last = Array.length fine_values - 1 in
  let rec low k = if k < last && Z.sign fine_values.(k) = 0 then low (k + 1) else k in
  let rec high k = if k > 0 && Z.sign fine_values.(k) = 0 then high (k - 1) else k in
  let from = s + low 0 and until = s + high last in
  let floor_div a b = if a >= 0 then a / b else -((b - 1 - a) / b) in
  let rows count = (floor_div (from - count) step + 1, floor_div until step) in
  let rec fit count = match rows count with a, b when 3 * (b - a + 1) > 2 * count -> fit (count + 1) | a, b -> (count, a, b) in
  let count, _, _ = fit 1 in
  let count = count + (extra * step) in
  let first_row, last_row = rows count in
  let equations = last_row - first_row + 1 in
  if count > 400 then None
  else begin
    let whole = Z.mul scale (Z.pow scheme.common level) in
    let value q = if q < s || q > s + last then Z.zero else Z.fdiv (Z.mul fine_values.(q - s) one) whole in
    let matrix = Array.init equations (fun i -> Array.init count (fun k -> value (k + (step * (first_row + i))))) in
    let middle = equations / 2 in
    let right = Array.init equations (fun i -> [| (if i = middle then one else Z.zero) |]) in
    let product x y =
      let sum = ref Z.zero in
      Array.iteri (fun k a -> sum := Z.add !sum (Z.mul a y.(k))) x;
      Z.shift_right !sum precision
    in
    Text.spend (equations * equations * (count + equations));
    (* the smallest weights for which the equations hold *)
    match Eigenvalue_hint.solve precision (Array.map (fun x -> Array.map (product x) matrix) matrix) right with
    | None -> None
    | Some solution ->
        let factors = Array.map (fun x -> x.(0)) solution in
        let weight k = Z.shift_right (product factors (Array.map (fun row -> row.(k)) matrix)) (precision - 128) in
        let weights = List.init count weight in
        (* the checker counts rows from one on before which there is nothing *)
        let row = min (floor_div s step) (floor_div (s - count) step + 1) in
        Some (weights, row, first_row + middle - row)
  end

let search scheme =
  let arity = Z.of_int scheme.arity in
  let less = Z.pred arity and last = Z.add scheme.first (Z.of_int (List.length scheme.coefficients - 1)) in
  let start = Z.fdiv scheme.first less in
  let size = Z.to_int (Z.sub (Z.cdiv last less) start) + 1 in
  let bits = List.fold_left (fun m x -> max m (Z.numbits x)) (Z.numbits scheme.common) scheme.coefficients in
  Text.spend (size * size * size * (2 + (size * bits / 640)));
  let system = arrays (value_matrix scheme start size) and precision = 512 + (8 * bits) in
  match
    ( solve_exactly (Array.map Array.copy system) (Array.make size scheme.common),
      Eigenvalue_hint.solve precision
        (Array.map (Array.map (fun x -> Z.shift_left x precision)) system)
        (unit_matrix size (Z.shift_left Z.one precision)) )
  with
  | Some (solution, scale), Some inverse ->
      let common = Array.fold_left Z.gcd scale solution in
      let values = List.map (fun x -> Z.divexact x common) (Array.to_list solution) and scale = Z.divexact scale common in
      let most = Array.fold_left (Array.fold_left (fun m x -> Z.max m (Z.abs x))) Z.one system in
      let bits = 32 + Z.numbits most in
      let inverse_matrix = lists (Array.map (Array.map (fun x -> Z.shift_right x (precision - bits))) inverse) in
      let attempt (level, extra) =
        match find_weights scheme precision values scale start level extra with
        | None -> None
        | Some (weights, row, center) ->
            let row = Z.of_int row and inverse_over = Z.shift_left Z.one bits in
            let hint = { start; values; scale; inverse_matrix; inverse_over; level; weights; row; center } in
            if center >= 0 && check_stable scheme hint then Some hint else None
      in
      let levels = List.filter (fun level -> int_power scheme.arity level <= 256) [ 1; 2; 3; 4 ] in
      List.find_map attempt (List.concat_map (fun level -> [ (level, 0); (level, 8) ]) levels)
  | _ -> None

(* A first index that differs by arity - 1 shifts the limit by 1. *)
let make scheme =
  let less = Z.of_int (scheme.arity - 1) in
  let shift = Z.fdiv scheme.first less in
  let moved hint = { hint with start = Z.add hint.start shift; row = Z.add hint.row shift } in
  Option.map moved (search { scheme with first = Z.sub scheme.first (Z.mul shift less) })
