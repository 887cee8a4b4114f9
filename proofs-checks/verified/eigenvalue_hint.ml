(* The hint for the lower end: an approximate eigenvector of a product, and an approximate inverse of the derivative of
   Newton's iteration. Nothing here is proved: what is wrong is not accepted. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith

let divide_floor = Z.fdiv
let bits x = Z.numbits x

(* Solves matrix * X = right in fixed point with so many bits, by elimination with pivots; None if it is singular. *)
let solve precision matrix right =
  let n = Array.length matrix in
  let rows = Array.mapi (fun i row -> Array.append row right.(i)) (Array.map Array.copy matrix) in
  let times x y = Z.shift_right (Z.mul x y) precision in
  let width = Array.length rows.(0) in
  try
    for k = 0 to n - 1 do
      let best = ref k in
      for i = k + 1 to n - 1 do
        if Z.gt (Z.abs rows.(i).(k)) (Z.abs rows.(!best).(k)) then best := i
      done;
      let row = rows.(!best) in
      rows.(!best) <- rows.(k);
      rows.(k) <- row;
      let pivot = row.(k) in
      if Z.equal pivot Z.zero then raise Exit;
      for j = k to width - 1 do
        row.(j) <- divide_floor (Z.shift_left row.(j) precision) pivot
      done;
      for i = 0 to n - 1 do
        if i <> k then begin
          let other = rows.(i) in
          let factor = other.(k) in
          if not (Z.equal factor Z.zero) then
            for j = k to width - 1 do
              if not (Z.equal row.(j) Z.zero) then other.(j) <- Z.sub other.(j) (times factor row.(j))
            done
        end
      done
    done;
    Some (Array.map (fun row -> Array.sub row n (width - n)) rows)
  with Exit -> None

(* The product of a word times `scale`, row by row. *)
let product_of family word scale =
  let n = family.size in
  let column j = Array.of_list (addmul scale (zrun family.matrices word (unit_at Z.one j)) []) in
  let columns = Array.init n column in
  Array.init n (fun i -> Array.init n (fun j -> if i < Array.length columns.(j) then columns.(j).(i) else Z.zero))

let rounds = 6 (* in which a rough eigenvalue is made a better one *)
let rough = 20 (* binary digits that it has at least, not to be improved *)

let make family word re im =
  let n = family.size in
  let size = (2 * n) + 2 in
  let length = List.length word in
  let whole = Z.pow family.denominator length in
  (* integers of at least so many bits, and a multiple of the denominators if these are small *)
  let small = Z.lcm (Q.den re) (Q.den im) in
  let exact = bits small <= 64 in
  let shift = max 0 (256 - bits whole) in
  let multiplier = Z.shift_left (if exact then small else Z.one) shift in
  let scale = Q.of_bigint (Z.mul whole multiplier) in
  let rounded x = divide_floor (Q.num (Q.mul x scale)) (Q.den (Q.mul x scale)) in
  let re_given = rounded re and im_given = rounded im in
  let level = max (bits re_given) (max (bits im_given) (bits (Z.mul whole multiplier))) + 1 in
  let matrix = product_of family word multiplier in
  let precision = 448 in
  let fixed x = if level <= precision then Z.shift_left x (precision - level) else Z.shift_right x (level - precision) in
  let one = Z.shift_left Z.one precision in
  let rec near left er ei =
  (* the complex system with borders: columns -b and rows of a functional *)
  let bordered b_re b_im functional =
    let rows = Array.make_matrix size size Z.zero in
    for i = 0 to n - 1 do
      for j = 0 to n - 1 do
        let entry = if i = j then Z.sub matrix.(i).(j) er else matrix.(i).(j) in
        rows.(i).(j) <- fixed entry;
        rows.(n + i).(n + j) <- fixed entry
      done;
      rows.(i).(n + i) <- fixed ei;
      rows.(n + i).(i) <- Z.neg (fixed ei);
      rows.(i).(2 * n) <- Z.neg b_re.(i);
      rows.(i).((2 * n) + 1) <- b_im.(i);
      rows.(n + i).(2 * n) <- Z.neg b_im.(i);
      rows.(n + i).((2 * n) + 1) <- Z.neg b_re.(i);
      rows.(2 * n).(i) <- functional.(i);
      rows.((2 * n) + 1).(n + i) <- functional.(i)
    done;
    rows
  in
  let nothing = Array.make n Z.zero in
  let some k = Array.init n (fun i -> Z.shift_left (Z.of_int ((((i * 37) + (k * 61)) mod 29) + 3)) (precision - 5)) in
  let right = Array.init size (fun i -> [| (if i = 2 * n then one else Z.zero) |]) in
  match solve precision (bordered (some 1) nothing (some 2)) right with
  | None -> None
  | Some solution ->
      let re_of i = solution.(i).(0) and im_of i = solution.(n + i).(0) in
      let square i = Z.add (Z.mul (re_of i) (re_of i)) (Z.mul (im_of i) (im_of i)) in
      let pivot = ref 0 in
      for i = 1 to n - 1 do
        if Z.gt (square i) (square !pivot) then pivot := i
      done;
      let pivot = !pivot in
      let below = square pivot in
      if Z.equal below Z.zero then None
      else begin
        (* x_i / x_pivot, in fixed point *)
        let nearest x = divide_floor (Z.add (Z.shift_left x (precision + 1)) below) (Z.shift_left below 1) in
        let quotient i =
          ( nearest (Z.add (Z.mul (re_of i) (re_of pivot)) (Z.mul (im_of i) (im_of pivot))),
            nearest (Z.sub (Z.mul (im_of i) (re_of pivot)) (Z.mul (re_of i) (im_of pivot))) )
        in
        let vector = Array.init n quotient in
        (* as integers of `level` bits, but of not more than can be known *)
        let digits = min level (precision - 64) in
        let cut x =
          let shift = precision - digits in
          Z.shift_left (Z.shift_right (Z.add x (Z.shift_left Z.one (shift - 1))) shift) (level - digits)
        in
        let xr = Array.map (fun (x, _) -> cut x) vector and xi = Array.map (fun (_, y) -> cut y) vector in
        let functional = Array.init n (fun i -> if i = pivot then one else Z.zero) in
        let inverse_bits = 64 in
        let over = Z.shift_left Z.one (level + inverse_bits) in
        let unit = Array.init size (fun i -> Array.init size (fun j -> if i = j then one else Z.zero)) in
        let inverse =
          match solve precision (bordered (Array.map fixed xr) (Array.map fixed xi) functional) unit with
          | None -> []
          | Some inverse ->
              Array.to_list
                (Array.map
                   (fun row -> Array.to_list (Array.map (fun x -> Z.shift_right x (precision - inverse_bits)) row))
                   inverse)
        in
        let hint distance =
          { word; multiplier; xr = Array.to_list xr; xi = Array.to_list xi; er; ei; pivot;
            pivot_scale = Z.shift_left Z.one level; inverse; over; distance }
        in
        let e = hint Z.zero in
        let moved x = addmul multiplier (zrun family.matrices word x) [] in
        let px = moved e.xr and py = moved e.xi in
        let value = List.init size (value_entry family e px py) in
        let step = List.fold_left (fun most x -> Z.max most (Z.abs x)) Z.zero (mv inverse value) in
        let distance = Z.mul (Z.of_int 2) (Z.cdiv step over) in
        let at_pivot x = Z.shift_right (Z.add (List.nth x pivot) (Z.shift_left Z.one (level - 1))) level in
        if left > 0 && Z.gt (Z.shift_left distance rough) (Z.add (Z.abs er) (Z.abs ei)) then
          near (left - 1) (at_pivot px) (at_pivot py)
        else Some (hint distance)
      end
  in
  near rounds re_given im_given
