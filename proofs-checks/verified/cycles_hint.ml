(* Graphs that attain the radius: what the lines `cycle` and `seed` of a graph say, written out for the checker. Nothing here
   is proved: what is wrong is not accepted. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith
open Text
open Sections
open Attained_hint

(* The states with the classes of the letters of their kept words *)
type round = { way : (int * int) list; coordinate : int; kept_part : Q.t; scale : Q.t; of_powers : vector array; seed_of : vector }

let zero_coordinate = "the eigenvector of a cycle may be zero at its coordinate"
let coarse_place = coarse

let read_rounds r rows (e : exact_number) root bound firsts kept =
  let n = rows.size and states = Array.length kept in
  let used = Array.make states false and rounds = ref [] in
  let moved = moving_by 1 rows in
  let read_round = function
    | [ first; coordinate; kept_part; scale ] ->
        require (Q.leq bound root.low_bound) "the bound of a graph with cycles is above the exact radius";
        let first = size first 0 (states - 1) and coordinate = size coordinate 0 (n - 1) in
        let kept_part = rational kept_part and scale = rational scale in
        require (Q.sign kept_part >= 0 && Q.lt kept_part Q.one) "the kept part of a norm is not from 0 to 1";
        require (Q.sign scale > 0) "the scale of a cycle is not positive";
        let rec follow state length =
          match kept.(state) with
          | None -> reject "a cycle leads to a state without a kept word"
          | Some (letter, target) ->
              require ((not used.(state)) && length < e.root) "a cycle is too long, or meets one that came before";
              used.(state) <- true;
              (state, letter) :: (if target = first then [] else follow target (length + 1))
        in
        let way = follow first 0 in
        require (List.length way = e.root) "a cycle is too short";
        let around x = List.fold_left (fun x (_, c) -> moved x (List.nth firsts c)) x way in
        let of_powers, seed_of = read_seed r rows e zero_coordinate around in
        { way; coordinate; kept_part; scale; of_powers; seed_of }
    | _ -> assert false
  in
  while at r "cycle" do rounds := read_round (take r "cycle" 4 4) :: !rounds done;
  Array.iteri (fun j k -> require (used.(j) || k = None) "a kept word is on no cycle") kept;
  List.rev !rounds

let norm_of = Array.fold_left (fun s x -> Z.add s (Z.abs x)) Z.zero

(* What to multiply coefficients by, and the binary digits of the zero, to know eigenvectors that well, or exactly if the
   number is rational and short *)
let digits rows (e : exact_number) root margin round =
  let n = rows.size and degree = Array.length round.of_powers and bits = 640 in
  let place = place_of e root bits in
  let whole = Z.mul (Z.pow place.near_scale (degree - 1)) (Z.pow (Z.mul rows.denominator place.low) (e.root - 1)) in
  if Z.sign place.near_radius = 0 && Z.equal place.low place.high && Z.numbits whole <= 1024 then (whole, true, least_bits)
  else begin
    let modulus = Z.succ (Z.fdiv (Z.add (Z.abs place.near_re) (Z.abs place.near_im)) place.near_scale) in
    let rounding = (degree * Z.numbits modulus) + Z.numbits (Z.of_int (n * degree)) + 16 in
    let start = 512 + rounding in
    let u, error = evaluated n place false (Array.map (Array.map (fun x -> Z.shift_left x start)) round.of_powers) in
    let largest = Array.fold_left (fun m x -> Z.max m (Z.abs x)) Z.zero u in
    require (Z.gt largest error) zero_coordinate;
    let slope = ref Z.zero and power = ref Z.one in
    Array.iteri
      (fun k y ->
        if k > 0 then begin
          slope := Z.add !slope (Z.mul (Z.mul (Z.of_int k) (norm_of y)) !power);
          power := Z.mul !power modulus
        end)
      round.of_powers;
    let length = Z.numbits largest - start in
    let extra = max 0 (bound_bits + margin + rounding - length) in
    (Z.shift_left Z.one extra, false, bound_bits + max 0 (Z.numbits !slope - length))
  end

(* What is said of a graph, and how many digits of the number it needs *)
type graph_draft = { bits : int; more : int; write : place -> exact_section }

let read r family (e : exact_number) root place section kept =
  match section with
  | Graph (bound, unity, firsts, group, turns, states) ->
      let n = family.size and rows = transpose family in
      let rounds = read_rounds r rows e root (Q.make bound.qnum bound.qden) firsts kept in
      let margin = margin_of rows place (e.root - 1) in
      let needed = List.map (digits rows e root margin) rounds in
      let matrices = Array.of_list (List.map array_of rows.matrices) in
      let letter c = List.nth firsts c in
      let coordinate_bits =
        let most = List.fold_left (List.fold_left (fun m x -> max m (Z.numbits x))) 0 in
        List.fold_left (fun m s -> max m (most s.coordinates)) 0 states
      in
      let write place =
        let write_round number round (factor, exact, _) =
          let coefficients = Array.map (scaled factor) round.of_powers and seed = scaled factor round.seed_of in
          let u, _ = evaluated n place false coefficients in
          (* each row is the one before times the matrix, over the radius *)
          let rec rows_from u = function
            | [] -> []
            | (_, c) :: rest ->
                let below = Z.mul rows.denominator place.low in
                let next = Array.map (fun x -> Z.fdiv (Z.mul place.bottom x) below) (apply matrices.(letter c) 2 u) in
                u :: (if rest = [] then [] else rows_from next rest)
          in
          let shown = rows_from u round.way in
          let shortest = List.fold_left (fun m u -> min m (widest u)) max_int shown in
          let cut = if exact then Z.one else Z.shift_left Z.one (max 0 (shortest - bound_bits - 32)) in
          let modulus u = zsquare (u.(round.coordinate), u.(n + round.coordinate)) in
          let known, error = evaluated n (coarse_place root place) false coefficients in
          let a = Z.add (Z.abs known.(round.coordinate)) (Z.abs known.(n + round.coordinate)) in
          require (Z.gt (modulus known) (Z.mul (Z.of_int 2) (Z.mul a error))) zero_coordinate;
          let weight = Q.div (square (Q.mul round.scale (Q.of_bigint cut))) (Q.of_bigint (modulus u)) in
          let more = max 0 (bound_bits + Z.numbits (Q.den weight) - Z.numbits (Q.num weight)) in
          let weight =
            if exact then bound_of weight
            else { qnum = Z.fdiv (Z.shift_left (Q.num weight) more) (Q.den weight); qden = Z.shift_left Z.one more }
          in
          let least =
            let shift = bound_bits + max 0 (Z.numbits place.bottom - Z.numbits place.low) in
            if exact then Q.make place.low place.bottom
            else Q.make (Z.fdiv (Z.shift_left place.low shift) place.bottom) (Z.shift_left Z.one shift)
          in
          let rows_of = 2 * (bits_of (Array.of_list shown) - Z.numbits cut + 1) + Z.numbits weight.qnum in
          let factors = 2 * max (Z.numbits (Q.num least) + Z.numbits bound.qden) (Z.numbits (Q.den least) + Z.numbits bound.qnum) in
          let images = (2 * (coordinate_bits + Z.numbits rows.denominator)) + Z.numbits weight.qden in
          let wide = width (max rows_of images + factors + Z.numbits (Q.den round.kept_part) + 256) in
          spend_times e.root (20_000 + (n * n * n * wide * wide));
          let word = List.rev_map (fun (_, c) -> letter c) round.way in
          ( { vectors = Array.to_list (Array.map (pair_of n) coefficients); conjugated = false;
              previous = Some (number, (word, pair_of n seed)) },
            { carrier = number; part = bound_of round.kept_part; weight; cut; least = bound_of least;
              stops = List.map2 (fun (state, c) u -> (state, (c, pair_of n u))) round.way shown } )
        in
        let carriers, cycles = List.split (List.mapi (fun k (round, d) -> write_round k round d) (List.combine rounds needed)) in
        Cyclic (bound, unity, firsts, group, turns, states, carriers, cycles)
      in
      { bits = List.fold_left (fun m (_, _, bits) -> max m bits) least_bits needed; more = margin; write }
  | _ -> assert false
