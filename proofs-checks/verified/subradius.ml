(* What certificates of joint spectral subradii say: section 4.15 of SPEC.md. Nothing here is proved. *)
module Z_of_zarith = Z
open Verified
module Z = Z_of_zarith
open Text
open Sections

(* A product that takes positive weights to at most RE times them. *)
let read_product r family upper =
  match take r "product" 4 (3 + 4096) with
  | block :: re :: im :: letters ->
      let re = rational re and n = family.size in
      require
        (block = "0" && Q.sign re >= 0 && Q.sign (rational im) = 0)
        "the product of a subradius has no block but 0, and a real number that is not negative";
      let slow_word = List.map (fun f -> size f 0 (List.length family.matrices - 1)) letters in
      let weight text =
        let x = integer text in
        require (Z.sign x > 0) "a weight is not positive";
        x
      in
      let slow_weights = List.map weight (take r "weights" n n) in
      let long = List.length slow_word and bits = bits_of_family family in
      spend (long * n * n * width bits * width (widest_of slow_weights + (long * (bits + 8))));
      let product = { slow_word; slow_factor = bound_of re; slow_weights } in
      require (check_product family product) "the product takes a weight to more than the given multiple";
      let proves u = factor_below (bound_of u) product in
      require (Option.fold ~none:true ~some:proves upper) "the product does not prove the upper end";
      product
  | _ -> assert false

(* Vertices that each matrix takes above a combination of vertices *)
let read_climb r family lower =
  match take r "block 0" 4 5 with
  | "polytope" :: vertices :: vertex_bits :: weight_bits :: properties ->
      let climb_transposed = properties <> [] and n = family.size in
      require (properties = [] || properties = [ "transposed" ]) "unknown property of the polytope of a subradius";
      let vertices = size vertices 1 max_bytes in
      ignore (size vertex_bits 0 4096);
      let climb_scale = Z.shift_left Z.one (size weight_bits 0 4096) in
      let family = if climb_transposed then transpose family else family in
      let read_vertex _ =
        let vertex = List.map integer (take r "vertex" n n) in
        require (List.for_all (fun x -> Z.sign x >= 0) vertex) "negative coordinate";
        require (List.exists (fun x -> Z.sign x > 0) vertex) "a vertex is 0";
        (vertex, [])
      in
      let climb_points = List.init vertices read_vertex in
      let points = number Z.one climb_points in
      let read_term text =
        match split_term text with
        | [ index; weight ] ->
            let index = size index 0 (vertices - 1) and weight = integer weight in
            require (Z.sign weight >= 0) "negative weight";
            (Z.of_int (index + 1), (weight, Z.zero))
        | _ -> reject "a term is INDEX:WEIGHT"
      in
      let least = ref None in
      let bits = List.fold_left (fun most (x, _) -> max most (widest_of x)) 0 climb_points in
      let wide = width bits * width (bits_of_family family) in
      let nothing = bound_of Q.zero in
      let read_image j vertex t matrix =
        let terms = List.map read_term (take r (Printf.sprintf "image %d %d" j t) 0 max_line) in
        let sum = Ascent_hint.sum_of terms in
        spend_times wide (n * (n + (List.length terms * width (Z.numbits sum))));
        require (image_above family points climb_scale nothing vertex matrix terms) "an image is not above the sum of its terms";
        least := Some (Option.fold ~none:sum ~some:(Z.min sum) !least);
        terms
      in
      let climb_terms = List.mapi (fun j (vertex, _) -> List.mapi (read_image j vertex) family.matrices) climb_points in
      let least = Q.make (Option.get !least) climb_scale in
      let proves l = Q.leq l least in
      require (Option.fold ~none:true ~some:proves lower) "the weights of an image do not prove the lower end";
      { climb_transposed; climb_scale; climb_points; climb_terms }
  | _ -> reject "expected 'polytope' and its numbers"

(* All that stands between the bounds and the end: what proves the claimed ends, and the number if one is claimed *)
let read r family lower upper number =
  let real (e, root) = Z.sign e.disc_im = 0 && Q.sign root.Attained_hint.im = 0 in
  require (Option.fold ~none:true ~some:real number) "a subradius needs a real zero";
  let upper_product = if upper <> None || at r "product" then Some (read_product r family upper) else None in
  let lower_climb = if lower <> None || number <> None || at r "block 0" then Some (read_climb r family lower) else None in
  let draft = Option.map (fun (e, root) -> Ascent_hint.read r family (Option.get lower_climb) e root) number in
  let needed bound proof = if bound = None then None else proof in
  ({ upper_product = needed upper upper_product; lower_climb = needed lower lower_climb }, draft)
