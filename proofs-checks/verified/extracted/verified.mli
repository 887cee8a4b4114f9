
val implb : bool -> bool -> bool

val negb : bool -> bool

val option_map : ('a1 -> 'a2) -> 'a1 option -> 'a2 option

val fst : ('a1*'a2) -> 'a1

val snd : ('a1*'a2) -> 'a2

val length : 'a1 list -> int

val app : 'a1 list -> 'a1 list -> 'a1 list

type comparison =
| Eq
| Lt
| Gt

val compOpp : comparison -> comparison

val add : int -> int -> int

val mul : int -> int -> int

val sub : int -> int -> int

val eqb : bool -> bool -> bool

module Nat :
 sig
  val add : int -> int -> int

  val mul : int -> int -> int

  val eqb : int -> int -> bool

  val leb : int -> int -> bool

  val ltb : int -> int -> bool

  val max : int -> int -> int

  val pow : int -> int -> int

  val divmod : int -> int -> int -> int -> int*int

  val div : int -> int -> int
 end

module Pos :
 sig
  type mask =
  | IsNul
  | IsPos of Number.t
  | IsNeg
 end

module Coq_Pos :
 sig
  val add : Number.t -> Number.t -> Number.t

  val add_carry : Number.t -> Number.t -> Number.t

  val pred_double : Number.t -> Number.t

  type mask = Pos.mask =
  | IsNul
  | IsPos of Number.t
  | IsNeg

  val succ_double_mask : mask -> mask

  val double_mask : mask -> mask

  val double_pred_mask : Number.t -> mask

  val sub_mask : Number.t -> Number.t -> mask

  val sub_mask_carry : Number.t -> Number.t -> mask

  val mul : Number.t -> Number.t -> Number.t

  val iter : ('a1 -> 'a1) -> 'a1 -> Number.t -> 'a1

  val compare_cont : comparison -> Number.t -> Number.t -> comparison

  val compare : Number.t -> Number.t -> comparison

  val eqb : Number.t -> Number.t -> bool

  val leb : Number.t -> Number.t -> bool

  val sqrtrem_step :
    (Number.t -> Number.t) -> (Number.t -> Number.t) -> (Number.t*mask) ->
    Number.t*mask

  val sqrtrem : Number.t -> Number.t*mask

  val sqrt : Number.t -> Number.t

  val iter_op : ('a1 -> 'a1 -> 'a1) -> Number.t -> 'a1 -> 'a1

  val to_nat : Number.t -> int

  val of_succ_nat : int -> Number.t
 end

module Z :
 sig
  val double : Number.t -> Number.t

  val succ_double : Number.t -> Number.t

  val pred_double : Number.t -> Number.t

  val pos_sub : Number.t -> Number.t -> Number.t

  val succ : Number.t -> Number.t

  val pred : Number.t -> Number.t

  val pow_pos : Number.t -> Number.t -> Number.t

  val compare : Number.t -> Number.t -> comparison

  val sgn : Number.t -> Number.t

  val to_nat : Number.t -> int

  val to_pos : Number.t -> Number.t

  val pos_div_eucl : Number.t -> Number.t -> Number.t*Number.t

  val div_eucl : Number.t -> Number.t -> Number.t*Number.t
 end

val hd : 'a1 -> 'a1 list -> 'a1

val hd_error : 'a1 list -> 'a1 option

val nth : int -> 'a1 list -> 'a1 -> 'a1

val nth_error : 'a1 list -> int -> 'a1 option

val last : 'a1 list -> 'a1 -> 'a1

val rev : 'a1 list -> 'a1 list

val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list

val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list

val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1

val fold_right : ('a2 -> 'a1 -> 'a1) -> 'a1 -> 'a2 list -> 'a1

val existsb : ('a1 -> bool) -> 'a1 list -> bool

val forallb : ('a1 -> bool) -> 'a1 list -> bool

val combine : 'a1 list -> 'a2 list -> ('a1*'a2) list

val firstn : int -> 'a1 list -> 'a1 list

val skipn : int -> 'a1 list -> 'a1 list

val seq : int -> int -> int list

val repeat : 'a1 -> int -> 'a1 list

type q = { qnum : Number.t; qden : Number.t }

val qle_bool : q -> q -> bool

type zvec = Number.t list

type zmat = zvec list

val dot : zvec -> zvec -> Number.t

val addmul : Number.t -> zvec -> zvec -> zvec

val mv : zmat -> zvec -> zvec

val norm1 : zvec -> Number.t

val positive_part : zvec -> zvec

val unit_at : Number.t -> int -> zvec

val entry : zmat -> int -> int -> Number.t

val table : int -> (int -> int -> Number.t) -> zmat

val products : zmat -> zmat -> zmat

val zrun : zmat list -> int list -> zvec -> zvec

val square : int -> zmat -> bool

val same : zvec -> zvec -> bool

type family = { size : int; denominator : Number.t; matrices : zmat list }

val count : family -> int

val letter : family -> int -> zmat

val well_formed : family -> bool

val append : Number.t -> Number.t -> Number.t

module PositiveMap :
 sig
  type key = Number.t

  type 'a tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  val empty : 'a1 t

  val find : key -> 'a1 t -> 'a1 option

  val add : key -> 'a1 -> 'a1 t -> 'a1 t

  val xmapi : (key -> 'a1 -> 'a2) -> 'a1 t -> key -> 'a2 t

  val mapi : (key -> 'a1 -> 'a2) -> 'a1 t -> 'a2 t
 end

type point = zvec*zvec

type term = Number.t*(Number.t*Number.t)

type points = point PositiveMap.t

val number : Number.t -> 'a1 list -> 'a1 PositiveMap.t

val zmodulus : Number.t -> Number.t -> Number.t

val combine0 : points -> term list -> (Number.t*point) option

val line :
  bool -> points -> Number.t -> Number.t -> point -> term list ->
  (Number.t*Number.t) option

val units :
  bool -> points -> Number.t -> int -> term list list -> (Number.t*Number.t)
  option

val images :
  bool -> points -> Number.t -> Number.t -> Number.t -> Number.t -> Number.t
  -> q -> point -> zmat list -> term list list -> bool

val all_images :
  bool -> points -> Number.t -> Number.t -> Number.t -> Number.t -> Number.t
  -> q -> zmat list -> point list -> term list list list -> bool

val vector_nonnegative : zvec -> bool

val all_nonnegative : family -> point list -> bool

val polytope :
  family -> q -> bool -> Number.t -> Number.t -> point list -> term list list
  -> term list list list -> bool

val largest_of : Number.t list -> Number.t

val columns : int -> zmat -> zmat

val size_of : int -> zmat -> Number.t

val defect : int -> Number.t -> zmat -> Number.t

type eigen = { word : int list; multiplier : Number.t; xr : zvec; xi : 
               zvec; er : Number.t; ei : Number.t; pivot : int;
               pivot_scale : Number.t; inverse : zmat; over : Number.t;
               distance : Number.t }

val product_columns : family -> eigen -> zmat

val if_equal : int -> int -> Number.t -> Number.t

val derivative_entry : family -> eigen -> zmat -> int -> int -> Number.t

val value_entry : family -> eigen -> zvec -> zvec -> int -> Number.t

val contracts : family -> eigen -> zvec -> bool

val eigenvalue : family -> eigen -> q -> bool

type square_root = { root_rows : zmat; root_factor : Number.t;
                     root_scale : Number.t }

type word_tree =
| Word of square_root
| Words of word_tree list

val root_rest :
  (int -> int -> Number.t) -> square_root -> int -> int -> Number.t

val others : int -> int -> zmat -> Number.t

val positive_form :
  int -> Number.t -> (int -> int -> Number.t) -> square_root -> bool

val extended : family -> zmat -> int -> zmat

val below_bound :
  family -> q -> zmat -> int list -> zmat -> square_root -> bool

val check_tree : family -> q -> zmat -> int list -> zmat -> word_tree -> bool

val quadratic : family -> q -> zmat -> square_root -> word_tree -> bool

val add_rows : Number.t -> zmat -> zmat -> zmat

val less_square : zvec -> zmat -> zmat

val add_dot : Number.t -> zvec -> zvec -> Number.t

val gram : zvec list -> zmat

val diagonal : int -> Number.t -> zmat

val decomposed : int -> Number.t -> zmat -> bool

val semidefinite : int -> zmat -> bool

type element = { action : zmat; undone : zmat; reading : int list }

type turn = { turning : zmat; moved : int list }

type step = { target : int; turned_by : int; step_norm : Number.t;
              step_matrix : zmat }

type branch =
| Stop of int
| Further of branch list

type state = { coordinates : zmat; steps : step list list; trees : branch list }

val no_element : element

val no_turn : turn

val no_state : state

val action_of : element list -> int -> zmat

val coordinates_of : state list -> int -> zmat

val unit_matrix : family -> zmat

val multiple : family -> Number.t -> zmat -> zmat -> bool

val element_right : family -> int list -> element -> bool

val turn_right : family -> element list -> turn -> bool

val step_right :
  family -> q -> Number.t -> turn list -> state list -> zmat -> int -> step
  -> bool

val state_right :
  family -> q -> Number.t -> int list -> turn list -> state list -> state ->
  bool

val rounded_product : Number.t -> zmat -> zmat -> zmat

val quotient_up : Number.t -> Number.t -> Number.t

val with_columns : family -> step -> step

val branch_right :
  family -> Number.t -> step list list list -> zmat -> Number.t -> Number.t
  -> step list -> branch -> bool

val words_right :
  family -> Number.t -> int list -> state list -> step list list list -> (int
  -> int -> bool) -> int -> bool

val graph_but :
  (int -> int -> bool) -> family -> q -> Number.t -> int list -> element list
  -> turn list -> state list -> bool

val graph :
  family -> q -> q -> Number.t -> int list -> element list -> turn list ->
  state list -> bool

type squares = { symbol : zvec; content : Number.t; divisor : zvec;
                 cosine : zvec; factor : zvec; bits : int }

val zproduct_of : zvec -> zvec -> zvec

val mirrored : zvec -> zvec

val middle : zvec -> int

val difference_of : squares -> int*zvec

val is_transition : family -> zvec -> bool

val sum_of_squares : family -> squares -> bool

val reach_of : int -> zvec -> int

val central_matrix : int -> zvec -> zmat

val applied : zmat -> Number.t -> zvec -> Number.t list -> Number.t*zvec

val recurs : family -> zvec -> Number.t list -> bool

val shifted_by : Number.t -> Number.t -> Number.t list -> Number.t*zvec

val no_negative : zvec -> bool

val one_sign : zvec -> bool

val single_section : family -> q -> squares -> Number.t list -> bool

val largest_norm : zmat list -> int -> zvec -> Number.t

val norm_section : family -> q -> int -> bool

val transpose : family -> family

type section =
| Norm of int
| Polytope of bool * bool * Number.t * Number.t * point list * term list list
   * term list list list
| Quadratic of zmat * square_root * word_tree
| Graph of q * Number.t * int list * element list * turn list * state list
| Single of squares * Number.t list

val check_section : family -> q -> section -> bool

val first_block : int -> family -> family

val other_blocks : int -> family -> family

val triangular : int -> family -> bool

val all_blocks : (family -> 'a1 -> bool) -> family -> (int*'a1) list -> bool

val some_block : (family -> 'a1 -> bool) -> family -> (int*'a1) list -> bool

val check_upper : family -> q -> (int*section) list -> bool

val check_lower : family -> q -> int list -> int -> eigen -> bool

type basis = { basis_rows : zmat; inverse_rows : zmat; basis_scale : Number.t }

val zproduct : int -> zmat -> zmat -> zmat

val is_scaled_unit : int -> Number.t -> zmat -> bool

val basis_valid : int -> basis -> bool

val in_basis : family -> basis -> family

type claim = { matrices_of : family; lower : q option; upper : q option }

type certificate = { new_basis : basis option; sections : (int*section) list;
                     sizes : int list; chosen : int;
                     eigenvector : eigen option }

val check_bounds : family -> claim -> certificate -> bool

val check_radius : claim -> certificate -> bool

type slow_product = { slow_word : int list; slow_factor : q;
                      slow_weights : zvec }

type climb = { climb_transposed : bool; climb_scale : Number.t;
               climb_points : point list; climb_terms : term list list list }

type subradius_certificate = { upper_product : slow_product option;
                               lower_climb : climb option }

val check_product : family -> slow_product -> bool

val factor_below : q -> slow_product -> bool

val positive_terms : term list -> bool

val image_above :
  family -> points -> Number.t -> q -> zvec -> zmat -> term list -> bool

val paired : ('a1 -> 'a2 -> bool) -> 'a1 list -> 'a2 list -> bool

val check_climb : family -> q -> climb -> bool

val check_subradius : claim -> subradius_certificate -> bool

type scheme = { arity : int; first : Number.t; coefficients : Number.t list;
                common : Number.t }

val times_sigma : int -> Number.t list -> Number.t list

val quotients : int -> Number.t list -> Number.t list -> Number.t list

val over_sigma : int -> Number.t list -> Number.t list

val iterate :
  int -> (Number.t list -> Number.t list) -> Number.t list -> Number.t list

val transition : int -> int -> Number.t list -> zmat list

val matrix_size : int -> Number.t list -> int

val quotient : scheme -> int -> Number.t list

val difference_symbol : scheme -> int -> Number.t list

val difference_family : scheme -> int -> family

val unity : Number.t

val digits : int

val roots_below : Number.t -> int -> Number.t -> Number.t -> Number.t

val power_below : Number.t -> int -> Number.t -> Number.t -> Number.t

type exponent_certificate = { order : int; bound : q; of_radius : certificate }

val below_power : scheme -> q -> int -> q -> bool

val divides : scheme -> int -> bool

val reducible : scheme -> int -> bool

val reduces : scheme -> q -> int -> q -> bool

val check_exponent_lower : scheme -> q -> exponent_certificate -> bool

type stability = { start : Number.t; values : Number.t list;
                   scale : Number.t; inverse_matrix : zmat;
                   inverse_over : Number.t; level : int;
                   weights : Number.t list; row : Number.t; center : 
                   int }

val coefficient_at : scheme -> Number.t -> Number.t

val value_matrix : scheme -> Number.t -> int -> zmat

val values_right : scheme -> stability -> bool

val values_unique : scheme -> stability -> bool

val times_up : int -> Number.t list -> Number.t list -> Number.t list

val fine : int -> Number.t list -> int -> Number.t list -> Number.t list

val fine_start : int -> Number.t -> int -> Number.t -> Number.t

val correlate : int -> int -> Number.t list -> Number.t list -> Number.t list

val combined : scheme -> stability -> Number.t list

val check_stable : scheme -> stability -> bool

type enclosure = { lower_end : exponent_certificate; radius_least : q;
                   shifts : stability }

val above_power : scheme -> q -> int -> q -> bool

val encloses : scheme -> q -> q -> int -> q -> q -> stability -> bool

val check_exponent : scheme -> q -> q -> enclosure -> bool

type exact_number = { polynomial : Number.t list; disc_re : Number.t;
                      disc_im : Number.t; disc_radius : Number.t;
                      disc_scale : Number.t; root : int }

val ztimes : (Number.t*Number.t) -> (Number.t*Number.t) -> Number.t*Number.t

val zsquare : (Number.t*Number.t) -> Number.t

val taylor :
  Number.t -> (Number.t*Number.t) -> Number.t list ->
  Number.t*((Number.t*Number.t)*(Number.t*Number.t))

val majorants :
  Number.t -> Number.t -> Number.t list ->
  Number.t*(Number.t*(Number.t*Number.t))

type place = { near_re : Number.t; near_im : Number.t;
               near_radius : Number.t; near_scale : Number.t; low : Number.t;
               high : Number.t; bottom : Number.t }

val one_zero : exact_number -> bool

val zero_there : Number.t list -> place -> bool

val check_number : exact_number -> place -> bool

type base = { vectors : point list; conjugated : bool;
              previous : (int*(int list*point)) option }

type source =
| FromBase of int
| FromPoint of Number.t * int

type image =
| Link of Number.t * int * int
| Below of Number.t * int * int
| Inside of term list

type body = { cone : bool; bases : base list;
              given : (source*(point*image list)) list;
              weight_one : Number.t; unit_one : Number.t;
              unit_lines : term list list; first_base : int; full_turn : 
              int }

type vertex = { from : int; path : int list; shown : point; off : Number.t;
                image_list : image list }

val norm_pair : point -> Number.t

val difference : Number.t -> Number.t -> point -> point -> point

val vanishes : zvec -> bool

val run_pair : zmat list -> int list -> point -> point

val closes :
  Number.t -> Number.t list -> point -> point list -> point list -> bool

val over_up : Number.t -> Number.t -> Number.t

val cut_by : Number.t -> zvec -> zvec

val cut_error : int -> Number.t -> zvec -> Number.t

val evaluate :
  int -> Number.t -> Number.t -> Number.t -> Number.t -> point list ->
  point*Number.t

val column_sums : zmat -> zvec

val column_norm : zmat -> Number.t

val base_right : family -> Number.t list -> int -> base list -> base -> bool

val walk : base list -> int -> int -> (int*int list) option

val same_word : int list -> int list -> bool

val agree : Number.t -> point list -> point list -> bool

val linked :
  family -> base list -> int -> int list -> int -> int -> int list -> int ->
  bool

val led :
  family -> base list -> int -> int list -> int -> (int*zvec list) option

val agree_at : int -> zvec list -> zvec list -> bool

val equal_at :
  family -> base list -> int -> int list -> int -> int -> int list -> int ->
  int -> bool

val at_most_point :
  family -> place -> base list -> vertex -> int -> int -> vertex -> int ->
  bool

val base_positive : family -> place -> base -> bool

val make :
  family -> place -> base list -> vertex PositiveMap.t -> source -> point ->
  image list -> vertex option

val build :
  family -> place -> base list -> Number.t -> (source*(point*image list))
  list -> vertex PositiveMap.t -> vertex list -> (vertex PositiveMap.t*vertex
  list) option

val image_right :
  family -> place -> base list -> bool -> vertex PositiveMap.t -> points ->
  Number.t -> Number.t -> Number.t -> Number.t -> Number.t -> vertex -> int
  -> image -> bool

val images_right :
  family -> place -> base list -> bool -> vertex PositiveMap.t -> points ->
  Number.t -> Number.t -> Number.t -> Number.t -> Number.t -> vertex -> int
  -> int -> image list -> bool

val below : family -> Number.t list -> int -> place -> body -> bool

val reached :
  family -> Number.t list -> int -> place -> base list -> int -> int -> bool

type cycle = { carrier : int; part : q; weight : q; cut : Number.t;
               least : q; stops : (int*(int*point)) list }

type station = { state_at : int; class_at : int; row_at : vertex }

val distinct : int list -> bool

val pairs : station list -> (station*station) list

val stations :
  family -> place -> int list -> base list -> int -> int -> vertex ->
  (int*(int*point)) list -> station list option

val turns_round : int list -> base list -> int -> station list -> bool

val way :
  family -> place -> int list -> base list -> cycle -> station list option

val ways :
  family -> place -> int list -> base list -> cycle list ->
  (cycle*(station*station)) list option

val shortened : family -> cycle -> vertex -> point*Number.t

val row_square : family -> point -> zmat

val length_square : family -> state list -> int -> zmat

val station_right :
  family -> place -> q -> int list -> state list -> cycle -> station ->
  station -> bool

val keeps : (cycle*(station*station)) list -> int -> int -> bool

val graph_below :
  family -> Number.t list -> int -> place -> q -> Number.t -> int list ->
  element list -> turn list -> state list -> base list -> cycle list -> bool

val changes : Number.t -> Number.t list -> int

val low_zeros : Number.t list -> int

val sign_count : Number.t list -> int

val middles : zmat -> Number.t -> int -> zvec -> int -> Number.t list

val numerator : Number.t list -> Number.t list -> Number.t list

val zpower_times : int -> Number.t list -> Number.t list -> Number.t list

type pole = { squares_of : squares; recurrence : Number.t list;
              multiplicity : int; cofactor : Number.t list }

val reduced : Number.t list -> pole -> Number.t list

val middles_of : family -> Number.t list -> pole -> Number.t list

val satisfies : Number.t list -> Number.t list -> Number.t list -> bool

val pole_right : family -> Number.t list -> pole -> bool

val no_larger : family -> Number.t list -> place -> pole -> bool

val not_zero : Number.t list -> place -> bool

val is_pole : family -> Number.t list -> place -> pole -> bool

type exact_section =
| Bounded of section
| Attains of bool * body
| Cyclic of q * Number.t * int list * element list * turn list * state list
   * base list * cycle list
| Leading of pole

val positive_zero : exact_number -> place -> bool

val simple_number : exact_number -> place -> bool

val block_below : exact_number -> place -> family -> exact_section -> bool

val block_reaches : exact_number -> place -> family -> exact_section -> bool

type exact_certificate = { number_place : place; exact_basis : basis option;
                           exact_blocks : (int*exact_section) list }

val check_blocks : family -> exact_number -> exact_certificate -> bool

val check_number_and_blocks :
  family -> exact_number -> exact_certificate -> bool

val check_exact_radius :
  family -> exact_number -> q option -> q option -> exact_certificate -> bool

val check_exact_exponent :
  scheme -> int -> exact_number -> q option -> q option -> exact_certificate
  -> stability -> bool

val zvalue : Number.t list -> Number.t -> Number.t

type modulus_proof =
| Between of int
| Whole of int * int
| Double of int * Number.t * pole

val is_power : exact_number -> Number.t -> bool

val attains_alone : exact_certificate -> bool

val symbol_above : scheme -> int -> int -> Number.t list

val family_above : scheme -> int -> int -> Number.t -> family

val at_one : Number.t list

val check_modulus :
  scheme -> int -> exact_number -> exact_certificate -> modulus_proof -> bool

val power_of : modulus_proof -> int

val check_logarithm :
  scheme -> int -> exact_number -> q option -> q option -> exact_certificate
  -> stability -> modulus_proof -> int -> bool

type rise =
| Reaches of Number.t
| Closes
| Passes of Number.t * int * int
| Exceeds of term list

type peak = { peak_given : zvec; peak_factor : Number.t; peak_whole : 
              bool; peak_word : int list; peak_origin : Number.t;
              peak_rises : rise list }

type ascent = { ascent_transposed : bool; eigenvector_base : base;
                eigenvector_multiple : q; beside : zvec;
                ascent_scale : Number.t; factor_scale : Number.t;
                peaks : peak list }

val eigenvector_word : ascent -> int list

val at_eigenvector : family -> place -> ascent -> zvec -> Number.t -> bool

val beside_right : family -> exact_number -> place -> ascent -> zvec -> bool

val follows : family -> place -> peak -> peak -> int -> bool

val peak_right :
  family -> place -> ascent -> peak PositiveMap.t -> peak -> bool

val passes :
  family -> place -> ascent -> Number.t -> peak -> int -> int -> peak -> int
  -> bool

val rise_right :
  family -> place -> ascent -> peak PositiveMap.t -> points -> Number.t ->
  Number.t -> peak -> int -> rise -> bool

val all_right :
  family -> place -> ascent -> peak PositiveMap.t -> points -> Number.t ->
  Number.t -> peak list -> bool

val check_ascent : family -> exact_number -> place -> ascent -> bool

val check_exact_subradius :
  family -> exact_number -> q option -> q option -> place -> ascent ->
  subradius_certificate -> bool

val class_sum : int -> Number.t list -> int -> Number.t

val no_more_factors : scheme -> int -> stability -> bool

val check_rough : scheme -> int -> int -> stability -> bool

val check_full : scheme -> q -> q -> exponent_certificate -> stability -> bool

type reduction = { shift_factor : Number.t list; other_scheme : scheme;
                   own_order : int; own_bound : q; own_radius : certificate }

val converges : scheme -> reduction -> bool

val check_factor : scheme -> scheme -> Number.t list -> bool

val check_reduced : scheme -> reduction -> (scheme -> bool) -> bool

type sequences =
| Any
| Follows of (int*int) list

val any_of : int -> Number.t -> zmat list list -> family

val row_in_place : int -> int -> int -> Number.t list -> Number.t list

val in_place : int -> int -> int -> int -> zmat -> zmat

val states : (int*int) list -> int

val follows_of : int -> Number.t -> zmat list list -> (int*int) list -> family

val along : sequences -> int -> Number.t -> zmat list list -> family

val known : int -> sequences -> bool

type masks = { masks_arity : int; masks_common : Number.t;
               each : (Number.t*Number.t list) list }

val no_mask : Number.t*Number.t list

val scheme_of : masks -> (Number.t*Number.t list) -> scheme

val level_symbols : masks -> int -> Number.t list list

val level_size : masks -> int -> int

val level_matrices : masks -> int -> zmat list list

val levels_family : masks -> sequences -> int -> family

val levels_reduce : masks -> sequences -> q -> int -> q -> bool

val check_levels : masks -> sequences -> q -> exponent_certificate -> bool

type ranged = { ranged_arity : int; ranged_first : Number.t;
                numerators : Number.t list list;
                ranged_divisor : Number.t list }

val times_linear : Number.t -> Number.t -> Number.t list -> Number.t list

val powers_of : Number.t -> int -> Number.t list

val polynomial_form :
  Number.t -> Number.t -> Number.t -> Number.t list -> Number.t list

val form_between : q -> q -> Number.t list -> Number.t list

val control_masks : ranged -> q -> q -> Number.t -> masks

val has_control_masks : ranged -> q -> q -> Number.t -> bool

val range_family : masks -> int -> family

val below_power_strictly : int -> q -> int -> q -> bool

val check_interval :
  ranged -> q -> q -> q -> Number.t -> exponent_certificate -> bool

val check_range_levels :
  ranged -> q -> q -> q -> Number.t -> exponent_certificate -> bool

val check_range :
  ranged -> q -> q -> q -> (q*(Number.t*exponent_certificate)) list -> bool

type rule = { above_bar : Number.t list; below_bar : Number.t list;
              of_root : bool }

val fits : bool -> Number.t -> bool

val signed_on :
  int -> bool -> Number.t -> Number.t -> Number.t -> Number.t list -> bool

val signed_between : bool -> q -> q -> Number.t list -> bool

val shifted : Number.t -> Number.t -> Number.t list -> Number.t list

val signed_beyond : bool -> q -> q -> Number.t list -> bool

val bounded_below :
  Number.t -> q -> Number.t list -> Number.t list -> Number.t list

val bounded_above :
  Number.t -> q -> Number.t list -> Number.t list -> Number.t list

val squared : q -> q

val not_negative : q -> q

val denominator_signed :
  rule -> Number.t -> (bool -> Number.t list -> bool) -> bool

val next_at_least :
  rule -> Number.t -> (bool -> Number.t list -> bool) -> q -> bool

val next_at_most :
  rule -> Number.t -> (bool -> Number.t list -> bool) -> q -> bool

val next_smaller : rule -> Number.t -> (bool -> Number.t list -> bool) -> bool

val leads : rule -> Number.t -> (q*q) -> (q*q) -> bool

val descends : rule -> Number.t -> q -> q -> q -> bool

val less_or_equal : q -> q -> bool

val way0 : rule -> (q*q) -> (Number.t*(q*q)) list -> q -> q -> bool

type follow_certificate = { range_sign : Number.t;
                            way_levels : (Number.t*(q*q)) list;
                            descent : (Number.t*q) option }

val check_follow :
  ranged -> rule -> q -> q option -> int option -> q -> q -> q -> Number.t ->
  exponent_certificate -> follow_certificate -> bool

val spread_times : int -> Number.t list -> Number.t list -> Number.t list

val then_mask : masks -> scheme -> (Number.t*Number.t list) -> scheme

val period_scheme : masks -> int -> int list -> scheme

val keeps_constants : masks -> bool

val in_period : masks -> int -> int list -> bool

type vector_mask = { vector_arity : int; functions : int;
                     vector_first : Number.t; of_points : zmat list;
                     vector_common : Number.t }

type vector_certificate = { window_first : Number.t; window : int;
                            fixed : Number.t list; difference_order : 
                            int; spanning : Number.t list list;
                            places : int list; place_value : Number.t;
                            restricted : zmat list; entering : int;
                            inner_first : Number.t; inner : int;
                            nonzero : int; kernel : Number.t list list;
                            kernel_scale : Number.t; space_bound : q;
                            space_radius : certificate }

val block : int -> Number.t -> Number.t list -> Number.t -> Number.t list

val mix_rows :
  zmat list -> Number.t -> (Number.t -> Number.t list) -> int -> Number.t

val move :
  int -> int -> Number.t -> int -> Number.t -> zmat list -> int -> Number.t
  list -> Number.t list

val zero_list : Number.t list -> bool

val step_difference : int -> Number.t list -> Number.t list

val combine_lists : Number.t list -> Number.t list list -> Number.t list

val in_space :
  Number.t list list -> int list -> Number.t -> Number.t list -> bool

val enters :
  int -> int -> Number.t -> int -> Number.t -> zmat list -> Number.t list
  list -> int list -> Number.t -> int -> Number.t list -> bool

val vector_family : vector_mask -> vector_certificate -> family

val checks_space : vector_mask -> vector_certificate -> bool

val differences_of : vector_mask -> vector_certificate -> Number.t list

val checks_start : vector_mask -> vector_certificate -> bool

val unfixed :
  vector_mask -> vector_certificate -> Number.t list -> Number.t list

val checks_kernel : vector_mask -> vector_certificate -> bool

val vector_space : vector_mask -> vector_certificate -> bool

val vector_power : vector_mask -> q -> int -> q -> bool

val vector_reduces : vector_mask -> q -> vector_certificate -> bool

val check_vectors : vector_mask -> q -> vector_certificate -> bool

val start_differences : vector_mask -> vector_certificate -> Number.t list

type above_certificate = { space_proof : vector_certificate;
                           image_words : int list list;
                           combinations : Number.t list list;
                           combination_scale : Number.t; space_least : 
                           q }

val image_by : vector_mask -> vector_certificate -> int list -> Number.t list

val checks_images : vector_mask -> above_certificate -> bool

val checks_places : vector_mask -> vector_certificate -> bool

val above_powers : int -> q -> int -> q -> bool

val check_vectors_between : vector_mask -> q -> q -> above_certificate -> bool

val number_between : int -> int -> place -> bool

val exponent_within :
  vector_mask -> int -> q option -> q option -> place -> bool

val check_exact_vectors :
  vector_mask -> exact_number -> q option -> q option -> above_certificate ->
  exact_certificate -> bool

type hidden = { unseen : int; observing : basis; unseen_bound : q;
                unseen_radius : certificate }

val rebased : vector_mask -> vector_certificate -> hidden -> family

val seen_family : vector_mask -> vector_certificate -> hidden -> family

val rebased_vector : vector_certificate -> hidden -> int -> Number.t list

val component_zero : int -> int -> int -> Number.t list -> bool

val component_space :
  vector_mask -> int -> vector_certificate -> hidden -> bool

type observation = { seen_at : (int list*int) list;
                     seen_rows : Number.t list list; seen_scale : Number.t }

val seen_vectors : vector_certificate -> hidden -> Number.t list list

val seen_values :
  vector_mask -> int -> Number.t list list -> int -> Number.t list

val observes :
  vector_mask -> int -> vector_certificate -> hidden -> observation -> bool

val check_component :
  vector_mask -> int -> q -> vector_certificate -> hidden -> bool

val check_component_between :
  vector_mask -> int -> q -> q -> above_certificate -> hidden -> observation
  -> bool

val check_exact_component :
  vector_mask -> int -> exact_number -> q option -> q option ->
  above_certificate -> hidden -> observation -> exact_certificate -> bool

type vector_masks = { list_arity : int; list_functions : int;
                      list_common : Number.t;
                      each_vector : (Number.t*zmat list) list }

val vector_number : vector_masks -> int -> vector_mask

type list_certificate = { list_first : Number.t; list_window : int;
                          list_order : int;
                          list_spanning : Number.t list list;
                          list_places : int list;
                          list_place_value : Number.t;
                          list_restricted : zmat list list;
                          wide : Number.t list list; wide_places : int list;
                          wide_pivot : Number.t;
                          wide_rows : Number.t list list;
                          wide_scale : Number.t; list_entering : int;
                          functional : Number.t list;
                          constants : Number.t list;
                          list_weights : Number.t list list;
                          list_scale : Number.t; list_bound : q;
                          list_radius : certificate }

val space_of : list_certificate -> int -> vector_certificate

val lists_family : vector_masks -> sequences -> list_certificate -> family

val constants_total :
  int -> Number.t -> zmat list -> Number.t list -> Number.t -> int -> Number.t

val arrives :
  (Number.t list -> Number.t list) list -> (Number.t list -> bool) -> int ->
  Number.t list -> bool

val list_moves :
  vector_masks -> list_certificate -> (Number.t list -> Number.t list) list

val comes : vector_masks -> list_certificate -> Number.t list -> bool

val list_shifted : vector_masks -> list_certificate -> Number.t list list

val list_change :
  vector_masks -> list_certificate -> (Number.t*zmat list) -> Number.t list

val list_differences : vector_masks -> list_certificate -> Number.t list

val list_component : vector_masks -> list_certificate -> int -> Number.t list

val list_window_fits : vector_masks -> list_certificate -> bool

val list_spaces : vector_masks -> list_certificate -> bool

val list_constants : vector_masks -> list_certificate -> bool

val list_comes : vector_masks -> list_certificate -> bool

val lists_space : vector_masks -> sequences -> list_certificate -> bool

val check_vector_lists :
  vector_masks -> sequences -> q -> list_certificate -> bool

val check_vector_scheme : vector_mask -> q -> list_certificate -> bool

val times_differences : int -> Number.t list -> Number.t list

val derivative_factors : list_certificate -> int -> Number.t list list -> bool

val check_hermite_lists :
  vector_masks -> sequences -> int -> list_certificate -> Number.t list list
  -> bool
