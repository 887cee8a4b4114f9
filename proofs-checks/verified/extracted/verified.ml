
(** val implb : bool -> bool -> bool **)

let implb b1 b2 =
  if b1 then b2 else true

(** val negb : bool -> bool **)

let negb = function
| true -> false
| false -> true

(** val option_map : ('a1 -> 'a2) -> 'a1 option -> 'a2 option **)

let option_map f = function
| Some a -> Some (f a)
| None -> None

(** val fst : ('a1*'a2) -> 'a1 **)

let fst = function
| x,_ -> x

(** val snd : ('a1*'a2) -> 'a2 **)

let snd = function
| _,y -> y

(** val length : 'a1 list -> int **)

let rec length = function
| [] -> 0
| _::l' -> Stdlib.succ (length l')

(** val app : 'a1 list -> 'a1 list -> 'a1 list **)

let rec app l m =
  match l with
  | [] -> m
  | a::l1 -> a::(app l1 m)

type comparison =
| Eq
| Lt
| Gt

(** val compOpp : comparison -> comparison **)

let compOpp = function
| Eq -> Eq
| Lt -> Gt
| Gt -> Lt

module Coq__1 = struct
 (** val add : int -> int -> int **)
 let rec add n m =
   (fun zero next n -> if n = 0 then zero () else next (n - 1))
     (fun _ -> m)
     (fun p -> Stdlib.succ (add p m))
     n
end
include Coq__1

(** val mul : int -> int -> int **)

let rec mul n m =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> 0)
    (fun p -> add m (mul p m))
    n

(** val sub : int -> int -> int **)

let rec sub n m =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> n)
    (fun k ->
    (fun zero next n -> if n = 0 then zero () else next (n - 1))
      (fun _ -> n)
      (fun l -> sub k l)
      m)
    n

(** val eqb : bool -> bool -> bool **)

let eqb b1 b2 =
  if b1 then b2 else if b2 then false else true

module Nat =
 struct
  (** val add : int -> int -> int **)

  let rec add n m =
    (fun zero next n -> if n = 0 then zero () else next (n - 1))
      (fun _ -> m)
      (fun p -> Stdlib.succ (add p m))
      n

  (** val mul : int -> int -> int **)

  let rec mul n m =
    (fun zero next n -> if n = 0 then zero () else next (n - 1))
      (fun _ -> 0)
      (fun p -> add m (mul p m))
      n

  (** val eqb : int -> int -> bool **)

  let rec eqb n m =
    (fun zero next n -> if n = 0 then zero () else next (n - 1))
      (fun _ ->
      (fun zero next n -> if n = 0 then zero () else next (n - 1))
        (fun _ -> true)
        (fun _ -> false)
        m)
      (fun n' ->
      (fun zero next n -> if n = 0 then zero () else next (n - 1))
        (fun _ -> false)
        (fun m' -> eqb n' m')
        m)
      n

  (** val leb : int -> int -> bool **)

  let rec leb n m =
    (fun zero next n -> if n = 0 then zero () else next (n - 1))
      (fun _ -> true)
      (fun n' ->
      (fun zero next n -> if n = 0 then zero () else next (n - 1))
        (fun _ -> false)
        (fun m' -> leb n' m')
        m)
      n

  (** val ltb : int -> int -> bool **)

  let ltb n m =
    leb (Stdlib.succ n) m

  (** val max : int -> int -> int **)

  let rec max n m =
    (fun zero next n -> if n = 0 then zero () else next (n - 1))
      (fun _ -> m)
      (fun n' ->
      (fun zero next n -> if n = 0 then zero () else next (n - 1))
        (fun _ -> n)
        (fun m' -> Stdlib.succ (max n' m'))
        m)
      n

  (** val pow : int -> int -> int **)

  let rec pow n m =
    (fun zero next n -> if n = 0 then zero () else next (n - 1))
      (fun _ -> Stdlib.succ 0)
      (fun m0 -> mul n (pow n m0))
      m

  (** val divmod : int -> int -> int -> int -> int*int **)

  let rec divmod x y q0 u =
    (fun zero next n -> if n = 0 then zero () else next (n - 1))
      (fun _ -> q0,u)
      (fun x' ->
      (fun zero next n -> if n = 0 then zero () else next (n - 1))
        (fun _ -> divmod x' y (Stdlib.succ q0) y)
        (fun u' -> divmod x' y q0 u')
        u)
      x

  (** val div : int -> int -> int **)

  let div x y =
    (fun zero next n -> if n = 0 then zero () else next (n - 1))
      (fun _ -> y)
      (fun y' -> fst (divmod x y' 0 y'))
      y
 end

module Pos =
 struct
  type mask =
  | IsNul
  | IsPos of Number.t
  | IsNeg
 end

module Coq_Pos =
 struct
  (** val add : Number.t -> Number.t -> Number.t **)

  let rec add x y =
    Number.case_positive
      (fun p ->
      Number.case_positive
        (fun q0 -> Number.twice (add_carry p q0))
        (fun q0 -> Number.twice_plus_one (add p q0))
        (fun _ -> Number.twice (Number.successor p))
        y)
      (fun p ->
      Number.case_positive
        (fun q0 -> Number.twice_plus_one (add p q0))
        (fun q0 -> Number.twice (add p q0))
        (fun _ -> Number.twice_plus_one p)
        y)
      (fun _ ->
      Number.case_positive
        (fun q0 -> Number.twice (Number.successor q0))
        (fun q0 -> Number.twice_plus_one q0)
        (fun _ -> Number.twice Number.one)
        y)
      x

  (** val add_carry : Number.t -> Number.t -> Number.t **)

  and add_carry x y =
    Number.case_positive
      (fun p ->
      Number.case_positive
        (fun q0 -> Number.twice_plus_one (add_carry p q0))
        (fun q0 -> Number.twice (add_carry p q0))
        (fun _ -> Number.twice_plus_one (Number.successor p))
        y)
      (fun p ->
      Number.case_positive
        (fun q0 -> Number.twice (add_carry p q0))
        (fun q0 -> Number.twice_plus_one (add p q0))
        (fun _ -> Number.twice (Number.successor p))
        y)
      (fun _ ->
      Number.case_positive
        (fun q0 -> Number.twice_plus_one (Number.successor q0))
        (fun q0 -> Number.twice (Number.successor q0))
        (fun _ -> Number.twice_plus_one Number.one)
        y)
      x

  (** val pred_double : Number.t -> Number.t **)

  let rec pred_double x =
    Number.case_positive
      (fun p -> Number.twice_plus_one (Number.twice p))
      (fun p -> Number.twice_plus_one (pred_double p))
      (fun _ -> Number.one)
      x

  type mask = Pos.mask =
  | IsNul
  | IsPos of Number.t
  | IsNeg

  (** val succ_double_mask : mask -> mask **)

  let succ_double_mask = function
  | IsNul -> IsPos Number.one
  | IsPos p -> IsPos (Number.twice_plus_one p)
  | IsNeg -> IsNeg

  (** val double_mask : mask -> mask **)

  let double_mask = function
  | IsPos p -> IsPos (Number.twice p)
  | x0 -> x0

  (** val double_pred_mask : Number.t -> mask **)

  let double_pred_mask x =
    Number.case_positive
      (fun p -> IsPos (Number.twice (Number.twice p)))
      (fun p -> IsPos (Number.twice (pred_double p)))
      (fun _ -> IsNul)
      x

  (** val sub_mask : Number.t -> Number.t -> mask **)

  let rec sub_mask x y =
    Number.case_positive
      (fun p ->
      Number.case_positive
        (fun q0 -> double_mask (sub_mask p q0))
        (fun q0 -> succ_double_mask (sub_mask p q0))
        (fun _ -> IsPos (Number.twice p))
        y)
      (fun p ->
      Number.case_positive
        (fun q0 -> succ_double_mask (sub_mask_carry p q0))
        (fun q0 -> double_mask (sub_mask p q0))
        (fun _ -> IsPos (pred_double p))
        y)
      (fun _ ->
      Number.case_positive
        (fun _ -> IsNeg)
        (fun _ -> IsNeg)
        (fun _ -> IsNul)
        y)
      x

  (** val sub_mask_carry : Number.t -> Number.t -> mask **)

  and sub_mask_carry x y =
    Number.case_positive
      (fun p ->
      Number.case_positive
        (fun q0 -> succ_double_mask (sub_mask_carry p q0))
        (fun q0 -> double_mask (sub_mask p q0))
        (fun _ -> IsPos (pred_double p))
        y)
      (fun p ->
      Number.case_positive
        (fun q0 -> double_mask (sub_mask_carry p q0))
        (fun q0 -> succ_double_mask (sub_mask_carry p q0))
        (fun _ -> double_pred_mask p)
        y)
      (fun _ -> IsNeg)
      x

  (** val mul : Number.t -> Number.t -> Number.t **)

  let rec mul x y =
    Number.case_positive
      (fun p -> add y (Number.twice (mul p y)))
      (fun p -> Number.twice (mul p y))
      (fun _ -> y)
      x

  (** val iter : ('a1 -> 'a1) -> 'a1 -> Number.t -> 'a1 **)

  let rec iter f x n =
    Number.case_positive
      (fun n' -> f (iter f (iter f x n') n'))
      (fun n' -> iter f (iter f x n') n')
      (fun _ -> f x)
      n

  (** val compare_cont : comparison -> Number.t -> Number.t -> comparison **)

  let rec compare_cont r x y =
    Number.case_positive
      (fun p ->
      Number.case_positive
        (fun q0 -> compare_cont r p q0)
        (fun q0 -> compare_cont Gt p q0)
        (fun _ -> Gt)
        y)
      (fun p ->
      Number.case_positive
        (fun q0 -> compare_cont Lt p q0)
        (fun q0 -> compare_cont r p q0)
        (fun _ -> Gt)
        y)
      (fun _ -> Number.case_positive
                  (fun _ -> Lt)
                  (fun _ -> Lt)
                  (fun _ -> r)
                  y)
      x

  (** val compare : Number.t -> Number.t -> comparison **)

  let compare =
    compare_cont Eq

  (** val eqb : Number.t -> Number.t -> bool **)

  let rec eqb p q0 =
    Number.case_positive
      (fun p0 ->
      Number.case_positive
        (fun q1 -> eqb p0 q1)
        (fun _ -> false)
        (fun _ -> false)
        q0)
      (fun p0 ->
      Number.case_positive
        (fun _ -> false)
        (fun q1 -> eqb p0 q1)
        (fun _ -> false)
        q0)
      (fun _ ->
      Number.case_positive
        (fun _ -> false)
        (fun _ -> false)
        (fun _ -> true)
        q0)
      p

  (** val leb : Number.t -> Number.t -> bool **)

  let leb x y =
    match compare x y with
    | Gt -> false
    | _ -> true

  (** val sqrtrem_step :
      (Number.t -> Number.t) -> (Number.t -> Number.t) -> (Number.t*mask) ->
      Number.t*mask **)

  let sqrtrem_step f g = function
  | s,y ->
    (match y with
     | IsPos r ->
       let s' = Number.twice_plus_one (Number.twice s) in
       let r' = g (f r) in
       if leb s' r'
       then (Number.twice_plus_one s),(sub_mask r' s')
       else (Number.twice s),(IsPos r')
     | _ ->
       (Number.twice
         s),(sub_mask (g (f Number.one)) (Number.twice (Number.twice
              Number.one))))

  (** val sqrtrem : Number.t -> Number.t*mask **)

  let rec sqrtrem p =
    Number.case_positive
      (fun p0 ->
      Number.case_positive
        (fun p1 ->
        sqrtrem_step (fun x -> Number.twice_plus_one x) (fun x ->
          Number.twice_plus_one x) (sqrtrem p1))
        (fun p1 ->
        sqrtrem_step (fun x -> Number.twice x) (fun x ->
          Number.twice_plus_one x) (sqrtrem p1))
        (fun _ -> Number.one,(IsPos (Number.twice Number.one)))
        p0)
      (fun p0 ->
      Number.case_positive
        (fun p1 ->
        sqrtrem_step (fun x -> Number.twice_plus_one x) (fun x ->
          Number.twice x) (sqrtrem p1))
        (fun p1 ->
        sqrtrem_step (fun x -> Number.twice x) (fun x -> Number.twice x)
          (sqrtrem p1))
        (fun _ -> Number.one,(IsPos Number.one))
        p0)
      (fun _ -> Number.one,IsNul)
      p

  (** val sqrt : Number.t -> Number.t **)

  let sqrt p =
    fst (sqrtrem p)

  (** val iter_op : ('a1 -> 'a1 -> 'a1) -> Number.t -> 'a1 -> 'a1 **)

  let rec iter_op op p a =
    Number.case_positive
      (fun p0 -> op a (iter_op op p0 (op a a)))
      (fun p0 -> iter_op op p0 (op a a))
      (fun _ -> a)
      p

  (** val to_nat : Number.t -> int **)

  let to_nat x =
    iter_op Coq__1.add x (Stdlib.succ 0)

  (** val of_succ_nat : int -> Number.t **)

  let rec of_succ_nat n =
    (fun zero next n -> if n = 0 then zero () else next (n - 1))
      (fun _ -> Number.one)
      (fun x -> Number.successor (of_succ_nat x))
      n
 end

module Z =
 struct
  (** val double : Number.t -> Number.t **)

  let double x =
    Number.case_integer
      (fun _ -> Number.zero)
      (fun p -> (Number.twice p))
      (fun p -> Number.opposite (Number.twice p))
      x

  (** val succ_double : Number.t -> Number.t **)

  let succ_double x =
    Number.case_integer
      (fun _ -> Number.one)
      (fun p -> (Number.twice_plus_one p))
      (fun p -> Number.opposite (Coq_Pos.pred_double p))
      x

  (** val pred_double : Number.t -> Number.t **)

  let pred_double x =
    Number.case_integer
      (fun _ -> Number.opposite Number.one)
      (fun p -> (Coq_Pos.pred_double p))
      (fun p -> Number.opposite (Number.twice_plus_one p))
      x

  (** val pos_sub : Number.t -> Number.t -> Number.t **)

  let rec pos_sub x y =
    Number.case_positive
      (fun p ->
      Number.case_positive
        (fun q0 -> double (pos_sub p q0))
        (fun q0 -> succ_double (pos_sub p q0))
        (fun _ -> (Number.twice p))
        y)
      (fun p ->
      Number.case_positive
        (fun q0 -> pred_double (pos_sub p q0))
        (fun q0 -> double (pos_sub p q0))
        (fun _ -> (Coq_Pos.pred_double p))
        y)
      (fun _ ->
      Number.case_positive
        (fun q0 -> Number.opposite (Number.twice q0))
        (fun q0 -> Number.opposite (Coq_Pos.pred_double q0))
        (fun _ -> Number.zero)
        y)
      x

  (** val succ : Number.t -> Number.t **)

  let succ x =
    Number.add x Number.one

  (** val pred : Number.t -> Number.t **)

  let pred x =
    Number.add x (Number.opposite Number.one)

  (** val pow_pos : Number.t -> Number.t -> Number.t **)

  let pow_pos z0 =
    Coq_Pos.iter (Number.mul z0) Number.one

  (** val compare : Number.t -> Number.t -> comparison **)

  let compare x y =
    Number.case_integer
      (fun _ ->
      Number.case_integer
        (fun _ -> Eq)
        (fun _ -> Lt)
        (fun _ -> Gt)
        y)
      (fun x' ->
      Number.case_integer
        (fun _ -> Gt)
        (fun y' -> Coq_Pos.compare x' y')
        (fun _ -> Gt)
        y)
      (fun x' ->
      Number.case_integer
        (fun _ -> Lt)
        (fun _ -> Lt)
        (fun y' -> compOpp (Coq_Pos.compare x' y'))
        y)
      x

  (** val sgn : Number.t -> Number.t **)

  let sgn z0 =
    Number.case_integer
      (fun _ -> Number.zero)
      (fun _ -> Number.one)
      (fun _ -> Number.opposite Number.one)
      z0

  (** val to_nat : Number.t -> int **)

  let to_nat z0 =
    Number.case_integer
      (fun _ -> 0)
      (fun p -> Coq_Pos.to_nat p)
      (fun _ -> 0)
      z0

  (** val to_pos : Number.t -> Number.t **)

  let to_pos z0 =
    Number.case_integer
      (fun _ -> Number.one)
      (fun p -> p)
      (fun _ -> Number.one)
      z0

  (** val pos_div_eucl : Number.t -> Number.t -> Number.t*Number.t **)

  let rec pos_div_eucl a b =
    Number.case_positive
      (fun a' ->
      let q0,r = pos_div_eucl a' b in
      let r' = Number.add (Number.mul (Number.twice Number.one) r) Number.one
      in
      if Number.less r' b
      then (Number.mul (Number.twice Number.one) q0),r'
      else (Number.add (Number.mul (Number.twice Number.one) q0) Number.one),
             (Number.sub r' b))
      (fun a' ->
      let q0,r = pos_div_eucl a' b in
      let r' = Number.mul (Number.twice Number.one) r in
      if Number.less r' b
      then (Number.mul (Number.twice Number.one) q0),r'
      else (Number.add (Number.mul (Number.twice Number.one) q0) Number.one),
             (Number.sub r' b))
      (fun _ ->
      if Number.less_equal (Number.twice Number.one) b
      then Number.zero,Number.one
      else Number.one,Number.zero)
      a

  (** val div_eucl : Number.t -> Number.t -> Number.t*Number.t **)

  let div_eucl a b =
    Number.case_integer
      (fun _ -> Number.zero,Number.zero)
      (fun a' ->
      Number.case_integer
        (fun _ -> Number.zero,a)
        (fun _ -> pos_div_eucl a' b)
        (fun b' ->
        let q0,r = pos_div_eucl a' b' in
        (Number.case_integer
           (fun _ -> (Number.opposite q0),Number.zero)
           (fun _ ->
           (Number.opposite (Number.add q0 Number.one)),(Number.add b r))
           (fun _ ->
           (Number.opposite (Number.add q0 Number.one)),(Number.add b r))
           r))
        b)
      (fun a' ->
      Number.case_integer
        (fun _ -> Number.zero,a)
        (fun _ ->
        let q0,r = pos_div_eucl a' b in
        (Number.case_integer
           (fun _ -> (Number.opposite q0),Number.zero)
           (fun _ ->
           (Number.opposite (Number.add q0 Number.one)),(Number.sub b r))
           (fun _ ->
           (Number.opposite (Number.add q0 Number.one)),(Number.sub b r))
           r))
        (fun b' -> let q0,r = pos_div_eucl a' b' in q0,(Number.opposite r))
        b)
      a
 end

(** val hd : 'a1 -> 'a1 list -> 'a1 **)

let hd default = function
| [] -> default
| x::_ -> x

(** val hd_error : 'a1 list -> 'a1 option **)

let hd_error = function
| [] -> None
| x::_ -> Some x

(** val nth : int -> 'a1 list -> 'a1 -> 'a1 **)

let rec nth n l default =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> match l with
              | [] -> default
              | x::_ -> x)
    (fun m -> match l with
              | [] -> default
              | _::t0 -> nth m t0 default)
    n

(** val nth_error : 'a1 list -> int -> 'a1 option **)

let rec nth_error l n =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> match l with
              | [] -> None
              | x::_ -> Some x)
    (fun n0 -> match l with
               | [] -> None
               | _::l0 -> nth_error l0 n0)
    n

(** val last : 'a1 list -> 'a1 -> 'a1 **)

let rec last l d =
  match l with
  | [] -> d
  | a::l0 -> (match l0 with
              | [] -> a
              | _::_ -> last l0 d)

(** val rev : 'a1 list -> 'a1 list **)

let rec rev = function
| [] -> []
| x::l' -> app (rev l') (x::[])

(** val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list **)

let rec map f = function
| [] -> []
| a::t0 -> (f a)::(map f t0)

(** val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list **)

let rec flat_map f = function
| [] -> []
| x::t0 -> app (f x) (flat_map f t0)

(** val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1 **)

let rec fold_left f l a0 =
  match l with
  | [] -> a0
  | b::t0 -> fold_left f t0 (f a0 b)

(** val fold_right : ('a2 -> 'a1 -> 'a1) -> 'a1 -> 'a2 list -> 'a1 **)

let rec fold_right f a0 = function
| [] -> a0
| b::t0 -> f b (fold_right f a0 t0)

(** val existsb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec existsb f = function
| [] -> false
| a::l0 -> (||) (f a) (existsb f l0)

(** val forallb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec forallb f = function
| [] -> true
| a::l0 -> (&&) (f a) (forallb f l0)

(** val combine : 'a1 list -> 'a2 list -> ('a1*'a2) list **)

let rec combine l l' =
  match l with
  | [] -> []
  | x::tl -> (match l' with
              | [] -> []
              | y::tl' -> (x,y)::(combine tl tl'))

(** val firstn : int -> 'a1 list -> 'a1 list **)

let rec firstn n l =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> [])
    (fun n0 -> match l with
               | [] -> []
               | a::l0 -> a::(firstn n0 l0))
    n

(** val skipn : int -> 'a1 list -> 'a1 list **)

let rec skipn n l =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> l)
    (fun n0 -> match l with
               | [] -> []
               | _::l0 -> skipn n0 l0)
    n

(** val seq : int -> int -> int list **)

let rec seq start0 len =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> [])
    (fun len0 -> start0::(seq (Stdlib.succ start0) len0))
    len

(** val repeat : 'a1 -> int -> 'a1 list **)

let rec repeat x n =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> [])
    (fun k -> x::(repeat x k))
    n

type q = { qnum : Number.t; qden : Number.t }

(** val qle_bool : q -> q -> bool **)

let qle_bool x y =
  Number.less_equal (Number.mul x.qnum y.qden) (Number.mul y.qnum x.qden)

type zvec = Number.t list

type zmat = zvec list

(** val dot : zvec -> zvec -> Number.t **)

let rec dot x y =
  match x with
  | [] -> Number.zero
  | a::x' ->
    (match y with
     | [] -> Number.zero
     | b::y' -> Number.add (Number.mul a b) (dot x' y'))

(** val addmul : Number.t -> zvec -> zvec -> zvec **)

let rec addmul c x y =
  match x with
  | [] -> y
  | a::x' ->
    (match y with
     | [] -> (Number.mul c a)::(addmul c x' [])
     | b::y' -> (Number.add (Number.mul c a) b)::(addmul c x' y'))

(** val mv : zmat -> zvec -> zvec **)

let mv m x = match x with
| [] -> []
| _::_ -> map (fun row0 -> dot row0 x) m

(** val norm1 : zvec -> Number.t **)

let norm1 x =
  fold_right (fun a s -> Number.add (Number.abs a) s) Number.zero x

(** val positive_part : zvec -> zvec **)

let positive_part x =
  map (Number.max Number.zero) x

(** val unit_at : Number.t -> int -> zvec **)

let unit_at a k =
  app (repeat Number.zero k) (a::[])

(** val entry : zmat -> int -> int -> Number.t **)

let entry m i j =
  nth j (nth i m []) Number.zero

(** val table : int -> (int -> int -> Number.t) -> zmat **)

let table n f =
  map (fun i -> map (f i) (seq 0 n)) (seq 0 n)

(** val products : zmat -> zmat -> zmat **)

let products rows columns0 =
  map (fun r -> map (dot r) columns0) rows

(** val zrun : zmat list -> int list -> zvec -> zvec **)

let rec zrun ms w x =
  match w with
  | [] -> x
  | t0::w' -> mv (nth t0 ms []) (zrun ms w' x)

(** val square : int -> zmat -> bool **)

let square n m =
  (&&) (Nat.eqb (length m) n)
    (forallb (fun row0 -> Nat.eqb (length row0) n) m)

(** val same : zvec -> zvec -> bool **)

let rec same x y =
  match x with
  | [] -> (match y with
           | [] -> true
           | _::_ -> false)
  | a::x' ->
    (match y with
     | [] -> false
     | b::y' -> (&&) (Number.equal a b) (same x' y'))

type family = { size : int; denominator : Number.t; matrices : zmat list }

(** val count : family -> int **)

let count f =
  length f.matrices

(** val letter : family -> int -> zmat **)

let letter f t0 =
  nth t0 f.matrices []

(** val well_formed : family -> bool **)

let well_formed f =
  (&&) (Number.less Number.zero f.denominator)
    (forallb (square f.size) f.matrices)

(** val append : Number.t -> Number.t -> Number.t **)

let rec append i j =
  Number.case_positive
    (fun ii -> Number.twice_plus_one (append ii j))
    (fun ii -> Number.twice (append ii j))
    (fun _ -> j)
    i

module PositiveMap =
 struct
  type key = Number.t

  type 'a tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  (** val empty : 'a1 t **)

  let empty =
    Leaf

  (** val find : key -> 'a1 t -> 'a1 option **)

  let rec find i = function
  | Leaf -> None
  | Node (l, o, r) ->
    (Number.case_positive
       (fun ii -> find ii r)
       (fun ii -> find ii l)
       (fun _ -> o)
       i)

  (** val add : key -> 'a1 -> 'a1 t -> 'a1 t **)

  let rec add i v = function
  | Leaf ->
    (Number.case_positive
       (fun ii -> Node (Leaf, None, (add ii v Leaf)))
       (fun ii -> Node ((add ii v Leaf), None, Leaf))
       (fun _ -> Node (Leaf, (Some v), Leaf))
       i)
  | Node (l, o, r) ->
    (Number.case_positive
       (fun ii -> Node (l, o, (add ii v r)))
       (fun ii -> Node ((add ii v l), o, r))
       (fun _ -> Node (l, (Some v), r))
       i)

  (** val xmapi : (key -> 'a1 -> 'a2) -> 'a1 t -> key -> 'a2 t **)

  let rec xmapi f m i =
    match m with
    | Leaf -> Leaf
    | Node (l, o, r) ->
      Node ((xmapi f l (append i (Number.twice Number.one))),
        (option_map (f i) o),
        (xmapi f r (append i (Number.twice_plus_one Number.one))))

  (** val mapi : (key -> 'a1 -> 'a2) -> 'a1 t -> 'a2 t **)

  let mapi f m =
    xmapi f m Number.one
 end

type point = zvec*zvec

type term = Number.t*(Number.t*Number.t)

type points = point PositiveMap.t

(** val number : Number.t -> 'a1 list -> 'a1 PositiveMap.t **)

let rec number i = function
| [] -> PositiveMap.empty
| p::ps' -> PositiveMap.add i p (number (Number.successor i) ps')

(** val zmodulus : Number.t -> Number.t -> Number.t **)

let zmodulus a b =
  if Number.equal b Number.zero
  then Number.abs a
  else Number.square_root_up (Number.add (Number.mul a a) (Number.mul b b))

(** val combine0 : points -> term list -> (Number.t*point) option **)

let rec combine0 ps = function
| [] -> Some (Number.zero,([],[]))
| t0::ts' ->
  let i,p = t0 in
  let a,b = p in
  (match PositiveMap.find i ps with
   | Some p0 ->
     let x,y = p0 in
     (match combine0 ps ts' with
      | Some p1 ->
        let w,p2 = p1 in
        let u,v = p2 in
        Some
        ((Number.add (zmodulus a b) w),(if Number.equal b Number.zero
                                        then (addmul a x u),(addmul a y v)
                                        else (addmul a x
                                               (addmul (Number.opposite b) y
                                                 u)),(addmul a y
                                                       (addmul b x v))))
      | None -> None)
   | None -> None)

(** val line :
    bool -> points -> Number.t -> Number.t -> point -> term list ->
    (Number.t*Number.t) option **)

let line nonnegative ps scale0 divisor0 target0 ts =
  match combine0 ps ts with
  | Some p ->
    let w,p0 = p in
    let x,y = p0 in
    let u =
      addmul (Number.opposite divisor0) x (addmul scale0 (fst target0) [])
    in
    let v =
      addmul (Number.opposite divisor0) y (addmul scale0 (snd target0) [])
    in
    if nonnegative
    then (match v with
          | [] -> Some (w,(norm1 (positive_part u)))
          | _::_ -> None)
    else Some (w,(Number.add (norm1 u) (norm1 v)))
  | None -> None

(** val units :
    bool -> points -> Number.t -> int -> term list list ->
    (Number.t*Number.t) option **)

let rec units nonnegative ps one k = function
| [] -> Some (Number.zero,Number.zero)
| ts::lines' ->
  (match line nonnegative ps one Number.one ((unit_at Number.one k),[]) ts with
   | Some p ->
     let w,r = p in
     (match units nonnegative ps one (Stdlib.succ k) lines' with
      | Some p0 -> let s,t0 = p0 in Some ((Number.max w s),(Number.max r t0))
      | None -> None)
   | None -> None)

(** val images :
    bool -> points -> Number.t -> Number.t -> Number.t -> Number.t ->
    Number.t -> q -> point -> zmat list -> term list list -> bool **)

let rec images nonnegative ps scale0 one divisor0 s r u p ms lines =
  match ms with
  | [] -> true
  | m::ms' ->
    (match lines with
     | [] -> false
     | ts::lines' ->
       (match line nonnegative ps scale0 divisor0
                ((mv m (fst p)),(mv m (snd p))) ts with
        | Some p0 ->
          let w,t0 = p0 in
          (&&)
            (Number.less_equal
              (Number.mul u.qden
                (Number.add
                  (Number.mul (Number.mul w divisor0) (Number.sub one r))
                  (Number.mul t0 s)))
              (Number.mul (Number.mul (Number.mul u.qnum scale0) divisor0)
                (Number.sub one r)))
            (images nonnegative ps scale0 one divisor0 s r u p ms' lines')
        | None -> false))

(** val all_images :
    bool -> points -> Number.t -> Number.t -> Number.t -> Number.t ->
    Number.t -> q -> zmat list -> point list -> term list list list -> bool **)

let rec all_images nonnegative ps scale0 one divisor0 s r u ms all lines =
  match all with
  | [] -> true
  | p::all' ->
    (match lines with
     | [] -> false
     | l::lines' ->
       (&&) (images nonnegative ps scale0 one divisor0 s r u p ms l)
         (all_images nonnegative ps scale0 one divisor0 s r u ms all' lines'))

(** val vector_nonnegative : zvec -> bool **)

let vector_nonnegative =
  forallb (Number.less_equal Number.zero)

(** val all_nonnegative : family -> point list -> bool **)

let all_nonnegative f all =
  (&&) (forallb (forallb vector_nonnegative) f.matrices)
    (forallb (fun p ->
      (&&) (vector_nonnegative (fst p))
        (match snd p with
         | [] -> true
         | _::_ -> false)) all)

(** val polytope :
    family -> q -> bool -> Number.t -> Number.t -> point list -> term list
    list -> term list list list -> bool **)

let polytope f u nonnegative scale0 one all unit_lines0 image_lines =
  let ps = number Number.one all in
  (&&)
    ((&&)
      ((&&)
        ((&&) (Number.less Number.zero scale0)
          (Number.less_equal Number.zero u.qnum))
        (if nonnegative then all_nonnegative f all else true))
      (Nat.eqb (length unit_lines0) f.size))
    (match units nonnegative ps one 0 unit_lines0 with
     | Some p ->
       let s,r = p in
       (&&) (Number.less r one)
         (all_images nonnegative ps scale0 one f.denominator s r u f.matrices
           all image_lines)
     | None -> false)

(** val largest_of : Number.t list -> Number.t **)

let largest_of xs =
  fold_right Number.max Number.zero xs

(** val columns : int -> zmat -> zmat **)

let columns n m =
  table n (fun i j -> entry m j i)

(** val size_of : int -> zmat -> Number.t **)

let size_of n m =
  largest_of (map (fun i -> norm1 (nth i m [])) (seq 0 n))

(** val defect : int -> Number.t -> zmat -> Number.t **)

let defect n a m =
  largest_of
    (map (fun i ->
      norm1 (addmul (Number.opposite Number.one) (nth i m []) (unit_at a i)))
      (seq 0 n))

type eigen = { word : int list; multiplier : Number.t; xr : zvec; xi : 
               zvec; er : Number.t; ei : Number.t; pivot : int;
               pivot_scale : Number.t; inverse : zmat; over : Number.t;
               distance : Number.t }

(** val product_columns : family -> eigen -> zmat **)

let product_columns f e =
  let n = f.size in
  let s = e.multiplier in
  map (fun j -> addmul s (zrun f.matrices e.word (unit_at Number.one j)) [])
    (seq 0 n)

(** val if_equal : int -> int -> Number.t -> Number.t **)

let if_equal i j a =
  if Nat.eqb i j then a else Number.zero

(** val derivative_entry :
    family -> eigen -> zmat -> int -> int -> Number.t **)

let derivative_entry f e =
  let n = f.size in
  (fun cols i j ->
  if Nat.ltb i n
  then if Nat.ltb j n
       then Number.sub (entry cols j i) (if_equal i j e.er)
       else if Nat.ltb j (add n n)
            then if_equal i (sub j n) e.ei
            else if Nat.eqb j (add n n)
                 then Number.opposite (nth i e.xr Number.zero)
                 else nth i e.xi Number.zero
  else if Nat.ltb i (add n n)
       then if Nat.ltb j n
            then Number.opposite (if_equal (sub i n) j e.ei)
            else if Nat.ltb j (add n n)
                 then Number.sub (entry cols (sub j n) (sub i n))
                        (if_equal (sub i n) (sub j n) e.er)
                 else if Nat.eqb j (add n n)
                      then Number.opposite (nth (sub i n) e.xi Number.zero)
                      else Number.opposite (nth (sub i n) e.xr Number.zero)
       else if Nat.eqb i (add n n)
            then if_equal j e.pivot e.pivot_scale
            else if_equal j (add n e.pivot) e.pivot_scale)

(** val value_entry : family -> eigen -> zvec -> zvec -> int -> Number.t **)

let value_entry f e =
  let n = f.size in
  (fun px py i ->
  if Nat.ltb i n
  then Number.add
         (Number.sub (nth i px Number.zero)
           (Number.mul e.er (nth i e.xr Number.zero)))
         (Number.mul e.ei (nth i e.xi Number.zero))
  else if Nat.ltb i (add n n)
       then Number.sub
              (Number.sub (nth (sub i n) py Number.zero)
                (Number.mul e.er (nth (sub i n) e.xi Number.zero)))
              (Number.mul e.ei (nth (sub i n) e.xr Number.zero))
       else Number.zero)

(** val contracts : family -> eigen -> zvec -> bool **)

let contracts f e =
  let n = f.size in
  let m = add (add n n) (Stdlib.succ (Stdlib.succ 0)) in
  (fun value ->
  let derivative = table m (derivative_entry f e (product_columns f e)) in
  let e1 = defect m e.over (products e.inverse (columns m derivative)) in
  let e2 = defect m e.over (products derivative (columns m e.inverse)) in
  let e3 = size_of m e.inverse in
  let eta = largest_of (map Number.abs (mv e.inverse value)) in
  let rest =
    Number.sub (Number.sub e.over e1)
      (Number.mul
        (Number.mul (Number.twice (Number.twice Number.one)) e.distance) e3)
  in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&) (Number.less Number.zero e.over)
            (negb (Number.equal e.pivot_scale Number.zero)))
          (square m e.inverse)) (Number.less Number.zero rest))
      (Number.less e2 e.over))
    (Number.less_equal eta (Number.mul rest e.distance)))

(** val eigenvalue : family -> eigen -> q -> bool **)

let eigenvalue f e =
  let n = f.size in
  let m = add (add n n) (Stdlib.succ (Stdlib.succ 0)) in
  let s = e.multiplier in
  (fun l ->
  let value =
    map
      (value_entry f e (addmul s (zrun f.matrices e.word e.xr) [])
        (addmul s (zrun f.matrices e.word e.xi) [])) (seq 0 m)
  in
  let a = Number.max Number.zero (Number.sub (Number.abs e.er) e.distance) in
  let b = Number.max Number.zero (Number.sub (Number.abs e.ei) e.distance) in
  let k = Number.of_natural (length e.word) in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&)
                ((&&) (Number.less Number.zero s)
                  (Number.less_equal Number.zero e.distance))
                (Nat.ltb e.pivot n))
              (forallb (fun t0 -> Nat.ltb t0 (count f)) e.word))
            (Number.less Number.zero k))
          (negb
            ((&&) (Number.equal (nth e.pivot e.xr Number.zero) Number.zero)
              (Number.equal (nth e.pivot e.xi Number.zero) Number.zero))))
        ((||) (forallb (Number.equal Number.zero) value)
          (contracts f e value))) (Number.less_equal Number.zero l.qnum))
    (Number.less_equal
      (Number.mul
        (Number.power (Number.mul l.qnum f.denominator)
          (Number.mul (Number.twice Number.one) k)) (Number.mul s s))
      (Number.mul
        (Number.power l.qden (Number.mul (Number.twice Number.one) k))
        (Number.add (Number.mul a a) (Number.mul b b)))))

type square_root = { root_rows : zmat; root_factor : Number.t;
                     root_scale : Number.t }

type word_tree =
| Word of square_root
| Words of word_tree list

(** val root_rest :
    (int -> int -> Number.t) -> square_root -> int -> int -> Number.t **)

let root_rest s h i j =
  Number.sub (Number.mul h.root_factor (s i j))
    (Number.mul h.root_scale
      (dot (nth i h.root_rows []) (nth j h.root_rows [])))

(** val others : int -> int -> zmat -> Number.t **)

let others n i e =
  fold_right Number.add Number.zero
    (map (fun j ->
      if Nat.eqb i j
      then Number.zero
      else Number.add (Number.abs (entry e i j)) (Number.abs (entry e j i)))
      (seq 0 n))

(** val positive_form :
    int -> Number.t -> (int -> int -> Number.t) -> square_root -> bool **)

let positive_form n margin s h =
  let e = table n (root_rest s h) in
  (&&)
    ((&&)
      ((&&) (Number.less Number.zero h.root_factor)
        (Number.less_equal Number.zero h.root_scale))
      (forallb (fun row0 -> Nat.leb (length row0) n) h.root_rows))
    (forallb (fun i ->
      Number.less_equal
        (Number.add (Number.mul (Number.twice Number.one) margin)
          (others n i e)) (Number.mul (Number.twice Number.one) (entry e i i)))
      (seq 0 n))

(** val extended : family -> zmat -> int -> zmat **)

let extended f =
  let n = f.size in (fun rows t0 -> map (mv (columns n (letter f t0))) rows)

(** val below_bound :
    family -> q -> zmat -> int list -> zmat -> square_root -> bool **)

let below_bound f u p =
  let n = f.size in
  (fun w rows h ->
  let k = Number.mul (Number.twice Number.one) (Number.of_natural (length w))
  in
  let cs = columns n rows in
  let pcs = map (mv p) cs in
  let a = Number.power (Number.mul u.qnum f.denominator) k in
  let b = Number.power u.qden k in
  (match w with
   | [] -> false
   | _::_ ->
     positive_form n Number.zero (fun i j ->
       Number.sub (Number.mul a (entry p i j))
         (Number.mul b (dot (nth i cs []) (nth j pcs [])))) h))

(** val check_tree :
    family -> q -> zmat -> int list -> zmat -> word_tree -> bool **)

let rec check_tree f u p w rows = function
| Word h -> below_bound f u p w rows h
| Words children ->
  (&&) (Nat.eqb (length children) (count f))
    (let rec each0 k = function
     | [] -> true
     | c::l' ->
       (&&) (check_tree f u p (app w (k::[])) (extended f rows k) c)
         (each0 (Stdlib.succ k) l')
     in each0 0 children)

(** val quadratic :
    family -> q -> zmat -> square_root -> word_tree -> bool **)

let quadratic f u p =
  let n = f.size in
  (fun definite words ->
  (&&)
    ((&&) ((&&) (Number.less_equal Number.zero u.qnum) (square n p))
      (positive_form n Number.one (entry p) definite))
    (check_tree f u p [] (table n (fun i j -> if_equal i j Number.one)) words))

(** val add_rows : Number.t -> zmat -> zmat -> zmat **)

let rec add_rows c a b =
  match a with
  | [] -> b
  | a0::a' ->
    (match b with
     | [] -> (addmul c a0 [])::(add_rows c a' [])
     | b0::b' -> (addmul c a0 b0)::(add_rows c a' b'))

(** val less_square : zvec -> zmat -> zmat **)

let rec less_square q0 rows =
  match q0 with
  | [] -> rows
  | a::q' ->
    (match rows with
     | [] -> (addmul (Number.opposite a) q0 [])::(less_square q' [])
     | row0::rows' ->
       (addmul (Number.opposite a) q0 row0)::(less_square q' rows'))

(** val add_dot : Number.t -> zvec -> zvec -> Number.t **)

let rec add_dot s x y =
  match x with
  | [] -> s
  | a::x' ->
    (match y with
     | [] -> s
     | b::y' -> add_dot (Number.add s (Number.mul a b)) x' y')

(** val gram : zvec list -> zmat **)

let rec gram vectors0 = match vectors0 with
| [] -> []
| x::vectors' -> (map (add_dot Number.zero x) vectors0)::(gram vectors')

(** val diagonal : int -> Number.t -> zmat **)

let diagonal n a =
  repeat (a::[]) n

(** val decomposed : int -> Number.t -> zmat -> bool **)

let rec decomposed n most = function
| [] -> true
| z0::rows' ->
  (match z0 with
   | [] -> false
   | x::row0 ->
     ((fun zero next n -> if n = 0 then zero () else next (n - 1))
        (fun _ -> false)
        (fun n' ->
        let root0 = Number.square_root x in
        (&&)
          ((&&)
            ((&&) (Number.less Number.zero x) (Number.less_equal root0 most))
            (Nat.leb (length row0) n'))
          (decomposed n' most
            (less_square (map (fun a -> Number.divide a root0) row0) rows')))
        n))

(** val semidefinite : int -> zmat -> bool **)

let semidefinite n rows =
  (||) (forallb (forallb (Number.equal Number.zero)) rows)
    (let largest =
       fold_right (fun row0 most -> Number.max (hd Number.zero row0) most)
         Number.zero rows
     in
     let most =
       Number.mul
         (Number.power (Number.twice Number.one) (Number.twice (Number.twice
           (Number.twice (Number.twice (Number.twice (Number.twice
           (Number.twice Number.one))))))))
         (Number.add Number.one (Number.square_root_up largest))
     in
     decomposed n most
       (add_rows
         (Number.power (Number.twice Number.one) (Number.twice (Number.twice
           (Number.twice (Number.twice (Number.twice (Number.twice
           (Number.twice (Number.twice Number.one))))))))) rows
         (diagonal n
           (Number.opposite (Number.mul (Number.of_natural n) most)))))

type element = { action : zmat; undone : zmat; reading : int list }

type turn = { turning : zmat; moved : int list }

type step = { target : int; turned_by : int; step_norm : Number.t;
              step_matrix : zmat }

type branch =
| Stop of int
| Further of branch list

type state = { coordinates : zmat; steps : step list list; trees : branch list }

(** val no_element : element **)

let no_element =
  { action = []; undone = []; reading = [] }

(** val no_turn : turn **)

let no_turn =
  { turning = []; moved = [] }

(** val no_state : state **)

let no_state =
  { coordinates = []; steps = []; trees = [] }

(** val action_of : element list -> int -> zmat **)

let action_of group u =
  (nth u group no_element).action

(** val coordinates_of : state list -> int -> zmat **)

let coordinates_of states0 j =
  (nth j states0 no_state).coordinates

(** val unit_matrix : family -> zmat **)

let unit_matrix f =
  let n = f.size in table n (fun i j -> if_equal i j Number.one)

(** val multiple : family -> Number.t -> zmat -> zmat -> bool **)

let multiple f =
  let n = f.size in
  (fun s a b ->
  forallb (fun i ->
    forallb (fun j ->
      Number.equal (entry a i j) (Number.mul s (entry b i j))) (seq 0 n))
    (seq 0 n))

(** val element_right : family -> int list -> element -> bool **)

let element_right f firsts =
  let n = f.size in
  (fun u ->
  (&&)
    ((&&) ((&&) (square n u.action) (square n u.undone))
      (multiple f Number.one (products u.action (columns n u.undone))
        (unit_matrix f)))
    (forallb (fun t0 ->
      let class0 = nth t0 u.reading 0 in
      let first0 = nth class0 firsts 0 in
      (&&) ((&&) (Nat.ltb class0 (length firsts)) (Nat.ltb first0 (count f)))
        (multiple f Number.one
          (products (letter f first0) (columns n u.action))
          (products u.action (columns n (letter f t0))))) (seq 0 (count f))))

(** val turn_right : family -> element list -> turn -> bool **)

let turn_right f group =
  let n = f.size in
  (fun h ->
  (&&) (square n h.turning)
    (forallb (fun u ->
      let v = nth u h.moved 0 in
      let image0 = products h.turning (columns n (action_of group u)) in
      (&&) (Nat.ltb v (length group))
        ((||) (multiple f Number.one (action_of group v) image0)
          (multiple f (Number.opposite Number.one) (action_of group v) image0)))
      (seq 0 (length group))))

(** val step_right :
    family -> q -> Number.t -> turn list -> state list -> zmat -> int -> step
    -> bool **)

let step_right f g unity0 turns states0 =
  let n = f.size in
  let d = Number.of_natural n in
  (fun l t0 s ->
  let h = nth s.turned_by turns no_turn in
  let k = map (mv (coordinates_of states0 s.target)) (columns n h.turning) in
  let a = map (mv l) (columns n (letter f t0)) in
  let b = map (mv s.step_matrix) k in
  let a0 = Number.mul unity0 g.qden in
  let b0 = Number.mul f.denominator g.qnum in
  let w =
    map (fun j ->
      addmul a0 (nth j a []) (addmul (Number.opposite b0) (nth j b []) []))
      (seq 0 n)
  in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&) (Nat.ltb s.target (length states0))
            (Nat.ltb s.turned_by (length turns)))
          (Number.less_equal Number.zero s.step_norm))
        (square n s.step_matrix))
      (semidefinite n
        (add_rows (Number.opposite Number.one) (gram w)
          (add_rows (Number.mul (Number.mul d b0) (Number.mul d b0)) 
            (gram k) []))))
    (semidefinite n
      (add_rows (Number.opposite Number.one) (gram (columns n s.step_matrix))
        (diagonal n (Number.mul s.step_norm s.step_norm)))))

(** val state_right :
    family -> q -> Number.t -> int list -> turn list -> state list -> state
    -> bool **)

let state_right f g unity0 firsts turns states0 =
  let n = f.size in
  (fun s ->
  let l = s.coordinates in
  (&&)
    ((&&)
      ((&&)
        ((&&) (square n l)
          (forallb (fun i ->
            (&&) (negb (Number.equal (entry l i i) Number.zero))
              (forallb (fun j ->
                (||) (Nat.leb j i) (Number.equal (entry l i j) Number.zero))
                (seq 0 n))) (seq 0 n)))
        (Nat.eqb (length s.steps) (length firsts)))
      (Nat.eqb (length s.trees) (length firsts)))
    (forallb (fun c ->
      forallb (step_right f g unity0 turns states0 l (nth c firsts 0))
        (nth c s.steps [])) (seq 0 (length firsts))))

(** val rounded_product : Number.t -> zmat -> zmat -> zmat **)

let rounded_product unity0 rows columns0 =
  map (fun row0 ->
    map (fun column ->
      Number.divide (add_dot Number.zero row0 column) unity0) columns0) rows

(** val quotient_up : Number.t -> Number.t -> Number.t **)

let quotient_up unity0 a =
  Number.opposite (Number.divide (Number.opposite a) unity0)

(** val with_columns : family -> step -> step **)

let with_columns f =
  let n = f.size in
  (fun s -> { target = s.target; turned_by = s.turned_by; step_norm =
  s.step_norm; step_matrix = (columns n s.step_matrix) })

(** val branch_right :
    family -> Number.t -> step list list list -> zmat -> Number.t -> Number.t
    -> step list -> branch -> bool **)

let branch_right f unity0 =
  let n = f.size in
  let d = Number.of_natural n in
  (fun by_state ->
  let rec branch_right0 m p e here b =
    match match b with
          | Stop k -> nth_error here k
          | Further _ -> hd_error here with
    | Some s ->
      let p' = quotient_up unity0 (Number.mul p (Number.add s.step_norm d)) in
      let e' =
        Number.add
          (quotient_up unity0
            (Number.add (Number.mul e s.step_norm) (Number.mul p d))) d
      in
      (match b with
       | Stop _ ->
         let c = Number.sub unity0 e' in
         (&&) (Number.less Number.zero c)
           (decomposed n unity0
             (add_rows (Number.opposite Number.one)
               (gram (rounded_product unity0 s.step_matrix m))
               (diagonal n
                 (Number.sub (Number.mul c c) (Number.mul d unity0)))))
       | Further branches ->
         let m' = rounded_product unity0 m s.step_matrix in
         (&&)
           (Number.less_equal (Number.add p' e')
             (Number.mul (Number.twice (Number.twice Number.one)) unity0))
           (let rec each0 classes l =
              match classes with
              | [] -> (match l with
                       | [] -> true
                       | _::_ -> false)
              | class0::classes' ->
                (match l with
                 | [] -> false
                 | b'::l' ->
                   (&&) (branch_right0 m' p' e' class0 b') (each0 classes' l'))
            in each0 (nth s.target by_state []) branches))
    | None -> false
  in branch_right0)

(** val words_right :
    family -> Number.t -> int list -> state list -> step list list list ->
    (int -> int -> bool) -> int -> bool **)

let words_right f unity0 firsts states0 =
  let n = f.size in
  (fun by_state kept j ->
  forallb (fun c ->
    if kept j c
    then true
    else (match nth_error (nth j states0 no_state).trees c with
          | Some b ->
            branch_right f unity0 by_state
              (table n (fun i j0 -> if_equal i j0 unity0)) unity0 Number.zero
              (nth c (nth j by_state []) []) b
          | None -> false)) (seq 0 (length firsts)))

(** val graph_but :
    (int -> int -> bool) -> family -> q -> Number.t -> int list -> element
    list -> turn list -> state list -> bool **)

let graph_but kept f g unity0 firsts group turns states0 =
  let by_state = map (fun s -> map (map (with_columns f)) s.steps) states0 in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&)
                ((&&) (Number.less Number.zero g.qnum)
                  (Number.less Number.zero unity0))
                (Nat.ltb 0 (length states0))) (Nat.ltb 0 (length group)))
            (multiple f Number.one (action_of group 0) (unit_matrix f)))
          (forallb (element_right f firsts) group))
        (forallb (turn_right f group) turns))
      (forallb (state_right f g unity0 firsts turns states0) states0))
    (forallb (words_right f unity0 firsts states0 by_state kept)
      (seq 0 (length states0)))

(** val graph :
    family -> q -> q -> Number.t -> int list -> element list -> turn list ->
    state list -> bool **)

let graph f u g unity0 firsts group turns states0 =
  (&&) (qle_bool g u)
    (graph_but (fun _ _ -> false) f g unity0 firsts group turns states0)

type squares = { symbol : zvec; content : Number.t; divisor : zvec;
                 cosine : zvec; factor : zvec; bits : int }

(** val zproduct_of : zvec -> zvec -> zvec **)

let rec zproduct_of p q0 =
  match p with
  | [] -> []
  | c::p' -> addmul c q0 (Number.zero::(zproduct_of p' q0))

(** val mirrored : zvec -> zvec **)

let mirrored p =
  zproduct_of p (rev p)

(** val middle : zvec -> int **)

let middle p =
  Nat.div (length p) (Stdlib.succ (Stdlib.succ 0))

(** val difference_of : squares -> int*zvec **)

let difference_of s =
  let m = middle s.cosine in
  let d = sub (length s.factor) (Stdlib.succ 0) in
  let mid = Nat.max m d in
  mid,(addmul
        (Number.power (Number.twice (Number.twice Number.one))
          (Number.of_natural s.bits))
        (app (repeat Number.zero (sub mid m)) s.cosine)
        (map (Number.mul (Number.opposite Number.one))
          (app (repeat Number.zero (sub mid d)) (mirrored s.factor))))

(** val is_transition : family -> zvec -> bool **)

let is_transition f b =
  forallb (fun t0 ->
    forallb (fun j ->
      let at_ = add (mul (count f) j) t0 in
      forallb (fun k ->
        Number.equal (entry (letter f t0) j k)
          (if Nat.leb k at_
           then nth (sub at_ k) b Number.zero
           else Number.zero)) (seq 0 f.size)) (seq 0 f.size))
    (seq 0 (count f))

(** val sum_of_squares : family -> squares -> bool **)

let sum_of_squares f s =
  let b = s.symbol in
  let mid,e = difference_of s in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&)
                ((&&)
                  ((&&)
                    ((&&) (Nat.leb (Stdlib.succ (Stdlib.succ 0)) (count f))
                      (Nat.leb (Stdlib.succ 0) f.size)) (same b (rev b)))
                  (Nat.eqb (length b)
                    (add (mul (Stdlib.succ (Stdlib.succ 0)) (middle b))
                      (Stdlib.succ 0))))
                (Nat.leb (sub (length b) (Stdlib.succ 0))
                  (mul f.size (sub (count f) (Stdlib.succ 0)))))
              (is_transition f b)) (Number.less Number.zero s.content))
          (same b
            (map (Number.mul s.content)
              (zproduct_of (mirrored s.divisor) s.cosine))))
        (Nat.eqb (add (middle b) (Stdlib.succ 0))
          (add (length s.divisor) (middle s.cosine))))
      (Nat.leb (Stdlib.succ 0) (length s.factor)))
    (Number.less_equal (norm1 e)
      (Number.mul (Number.twice Number.one) (nth mid e Number.zero)))

(** val reach_of : int -> zvec -> int **)

let reach_of a b =
  Nat.div (middle b) (sub a (Stdlib.succ 0))

(** val central_matrix : int -> zvec -> zmat **)

let central_matrix a b =
  let r = reach_of a b in
  table (add (mul (Stdlib.succ (Stdlib.succ 0)) r) (Stdlib.succ 0))
    (fun j i ->
    let high0 = add (add (middle b) i) (mul (sub a (Stdlib.succ 0)) r) in
    if Nat.leb (mul a j) high0
    then nth (sub high0 (mul a j)) b Number.zero
    else Number.zero)

(** val applied :
    zmat -> Number.t -> zvec -> Number.t list -> Number.t*zvec **)

let rec applied m d x = function
| [] -> Number.one,[]
| c::p' ->
  let k,v = applied m d x p' in
  (Number.mul k d),(addmul (Number.mul c (Number.mul k d)) x (mv m v))

(** val recurs : family -> zvec -> Number.t list -> bool **)

let recurs f b p =
  let _,v =
    applied (central_matrix (count f) b) f.denominator
      (unit_at Number.one (reach_of (count f) b)) p
  in
  forallb (Number.equal Number.zero) v

(** val shifted_by :
    Number.t -> Number.t -> Number.t list -> Number.t*zvec **)

let rec shifted_by a q0 = function
| [] -> Number.one,[]
| c::p' ->
  let k,s = shifted_by a q0 p' in
  (Number.mul k q0),(addmul a s ((Number.mul c (Number.mul k q0))::s))

(** val no_negative : zvec -> bool **)

let no_negative p =
  (&&) (forallb (Number.less_equal Number.zero) p)
    (existsb (Number.less Number.zero) p)

(** val one_sign : zvec -> bool **)

let one_sign p =
  (||) (no_negative p)
    (no_negative (map (Number.mul (Number.opposite Number.one)) p))

(** val single_section : family -> q -> squares -> Number.t list -> bool **)

let single_section f u s p =
  (&&)
    ((&&) ((&&) (sum_of_squares f s) (recurs f s.symbol p))
      (Number.less_equal Number.zero u.qnum))
    (one_sign (snd (shifted_by u.qnum u.qden p)))

(** val largest_norm : zmat list -> int -> zvec -> Number.t **)

let rec largest_norm ms level0 x =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> norm1 x)
    (fun k -> largest_of (map (fun m -> largest_norm ms k (mv m x)) ms))
    level0

(** val norm_section : family -> q -> int -> bool **)

let norm_section f u level0 =
  (&&) ((&&) (Number.less_equal Number.zero u.qnum) (Nat.ltb 0 level0))
    (forallb (fun k ->
      Number.less_equal
        (Number.mul (largest_norm f.matrices level0 (unit_at Number.one k))
          (Number.power u.qden (Number.of_natural level0)))
        (Number.power (Number.mul u.qnum f.denominator)
          (Number.of_natural level0))) (seq 0 f.size))

(** val transpose : family -> family **)

let transpose f =
  { size = f.size; denominator = f.denominator; matrices =
    (map (columns f.size) f.matrices) }

type section =
| Norm of int
| Polytope of bool * bool * Number.t * Number.t * point list * term list list
   * term list list list
| Quadratic of zmat * square_root * word_tree
| Graph of q * Number.t * int list * element list * turn list * state list
| Single of squares * Number.t list

(** val check_section : family -> q -> section -> bool **)

let check_section f u = function
| Norm level0 -> norm_section f u level0
| Polytope (nonnegative, transposed, scale0, one, all, ul, il) ->
  polytope (if transposed then transpose f else f) u nonnegative scale0 one
    all ul il
| Quadratic (form, definite, words) -> quadratic f u form definite words
| Graph (bound0, unity0, firsts, group, turns, states0) ->
  graph f u bound0 unity0 firsts group turns states0
| Single (sum, recurrence0) -> single_section f u sum recurrence0

(** val first_block : int -> family -> family **)

let first_block d f =
  { size = d; denominator = f.denominator; matrices =
    (map (fun m -> map (firstn d) (firstn d m)) f.matrices) }

(** val other_blocks : int -> family -> family **)

let other_blocks d f =
  { size = (sub f.size d); denominator = f.denominator; matrices =
    (map (fun m -> map (skipn d) (skipn d m)) f.matrices) }

(** val triangular : int -> family -> bool **)

let triangular d f =
  (&&) (Nat.leb d f.size)
    (forallb (fun m ->
      forallb (fun row0 ->
        forallb (Number.equal Number.zero) (firstn d row0)) (skipn d m))
      f.matrices)

(** val all_blocks :
    (family -> 'a1 -> bool) -> family -> (int*'a1) list -> bool **)

let rec all_blocks check f = function
| [] -> false
| p::blocks' ->
  let d,s = p in
  (match blocks' with
   | [] -> (&&) (Nat.eqb d f.size) (check f s)
   | _::_ ->
     (&&) ((&&) (triangular d f) (check (first_block d f) s))
       (all_blocks check (other_blocks d f) blocks'))

(** val some_block :
    (family -> 'a1 -> bool) -> family -> (int*'a1) list -> bool **)

let rec some_block check f = function
| [] -> false
| p::blocks' ->
  let d,s = p in
  (match blocks' with
   | [] -> (&&) (Nat.eqb d f.size) (check f s)
   | _::_ ->
     (&&) (triangular d f)
       ((||) (check (first_block d f) s)
         (some_block check (other_blocks d f) blocks')))

(** val check_upper : family -> q -> (int*section) list -> bool **)

let check_upper f u =
  all_blocks (fun f0 -> check_section f0 u) f

(** val check_lower : family -> q -> int list -> int -> eigen -> bool **)

let rec check_lower f l sizes0 block0 e =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ ->
    match sizes0 with
    | [] -> eigenvalue f e l
    | d::_ -> (&&) (triangular d f) (eigenvalue (first_block d f) e l))
    (fun k ->
    match sizes0 with
    | [] -> false
    | d::sizes' ->
      (&&) (triangular d f) (check_lower (other_blocks d f) l sizes' k e))
    block0

type basis = { basis_rows : zmat; inverse_rows : zmat; basis_scale : Number.t }

(** val zproduct : int -> zmat -> zmat -> zmat **)

let zproduct n a b =
  products a (columns n b)

(** val is_scaled_unit : int -> Number.t -> zmat -> bool **)

let is_scaled_unit n a m =
  forallb (fun i ->
    forallb (fun j -> Number.equal (entry m i j) (if_equal i j a)) (seq 0 n))
    (seq 0 n)

(** val basis_valid : int -> basis -> bool **)

let basis_valid n b =
  (&&)
    ((&&)
      ((&&)
        ((&&) (Number.less Number.zero b.basis_scale) (square n b.basis_rows))
        (square n b.inverse_rows))
      (is_scaled_unit n b.basis_scale
        (zproduct n b.basis_rows b.inverse_rows)))
    (is_scaled_unit n b.basis_scale (zproduct n b.inverse_rows b.basis_rows))

(** val in_basis : family -> basis -> family **)

let in_basis f b =
  { size = f.size; denominator = (Number.mul f.denominator b.basis_scale);
    matrices =
    (map (fun m ->
      zproduct f.size (zproduct f.size b.inverse_rows m) b.basis_rows)
      f.matrices) }

type claim = { matrices_of : family; lower : q option; upper : q option }

type certificate = { new_basis : basis option; sections : (int*section) list;
                     sizes : int list; chosen : int;
                     eigenvector : eigen option }

(** val check_bounds : family -> claim -> certificate -> bool **)

let check_bounds f c cert =
  (&&)
    (match c.upper with
     | Some u ->
       (&&) (Number.less_equal Number.zero u.qnum)
         (check_upper f u cert.sections)
     | None -> true)
    (match c.lower with
     | Some l ->
       (||) (Number.less_equal l.qnum Number.zero)
         (match cert.eigenvector with
          | Some e -> check_lower f l cert.sizes cert.chosen e
          | None -> false)
     | None -> true)

(** val check_radius : claim -> certificate -> bool **)

let check_radius c cert =
  let f = c.matrices_of in
  (&&) (well_formed f)
    (match cert.new_basis with
     | Some b ->
       (&&) (basis_valid f.size b) (check_bounds (in_basis f b) c cert)
     | None -> check_bounds f c cert)

type slow_product = { slow_word : int list; slow_factor : q;
                      slow_weights : zvec }

type climb = { climb_transposed : bool; climb_scale : Number.t;
               climb_points : point list; climb_terms : term list list list }

type subradius_certificate = { upper_product : slow_product option;
                               lower_climb : climb option }

(** val check_product : family -> slow_product -> bool **)

let check_product f p =
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&) (forallb (fun t0 -> Nat.ltb t0 (count f)) p.slow_word)
            (Nat.ltb 0 (length p.slow_word)))
          (Nat.eqb (length p.slow_weights) f.size))
        (forallb (Number.less_equal Number.one) p.slow_weights))
      (Number.less_equal Number.zero p.slow_factor.qnum))
    (vector_nonnegative
      (addmul (Number.opposite p.slow_factor.qden)
        (zrun f.matrices p.slow_word p.slow_weights)
        (addmul
          (Number.mul p.slow_factor.qnum
            (Number.power f.denominator
              (Number.of_natural (length p.slow_word)))) p.slow_weights [])))

(** val factor_below : q -> slow_product -> bool **)

let factor_below u p =
  let l = Number.of_natural (length p.slow_word) in
  (&&) (Number.less_equal Number.zero u.qnum)
    (Number.less_equal
      (Number.mul p.slow_factor.qnum (Number.power u.qden l))
      (Number.mul (Number.power u.qnum l) p.slow_factor.qden))

(** val positive_terms : term list -> bool **)

let positive_terms =
  forallb (fun t0 ->
    (&&) (Number.less_equal Number.zero (fst (snd t0)))
      (Number.equal (snd (snd t0)) Number.zero))

(** val image_above :
    family -> points -> Number.t -> q -> zvec -> zmat -> term list -> bool **)

let image_above f ps scale0 l x m ts =
  match combine0 ps ts with
  | Some p ->
    let w,p0 = p in
    let y,_ = p0 in
    (&&)
      ((&&) (positive_terms ts)
        (vector_nonnegative
          (addmul (Number.opposite f.denominator) y
            (addmul scale0 (mv m x) []))))
      (Number.less_equal (Number.mul l.qnum scale0) (Number.mul w l.qden))
  | None -> false

(** val paired : ('a1 -> 'a2 -> bool) -> 'a1 list -> 'a2 list -> bool **)

let rec paired check xs ys =
  match xs with
  | [] -> true
  | x::xs' ->
    (match ys with
     | [] -> false
     | y::ys' -> (&&) (check x y) (paired check xs' ys'))

(** val check_climb : family -> q -> climb -> bool **)

let check_climb f l c =
  let all = c.climb_points in
  let ps = number Number.one all in
  (&&)
    ((&&)
      ((&&)
        ((&&) (Number.less Number.zero c.climb_scale) (all_nonnegative f all))
        (Nat.ltb 0 (length all)))
      (forallb (fun p ->
        (&&) (Nat.leb (length (fst p)) f.size)
          (Number.less Number.zero (norm1 (fst p)))) all))
    (paired (fun p ->
      paired (image_above f ps c.climb_scale l (fst p)) f.matrices) all
      c.climb_terms)

(** val check_subradius : claim -> subradius_certificate -> bool **)

let check_subradius c cert =
  let f = c.matrices_of in
  (&&)
    ((&&) ((&&) (well_formed f) (all_nonnegative f []))
      (match c.upper with
       | Some u ->
         (match cert.upper_product with
          | Some p -> (&&) (check_product f p) (factor_below u p)
          | None -> false)
       | None -> true))
    (match c.lower with
     | Some l ->
       (||) (Number.less_equal l.qnum Number.zero)
         (match cert.lower_climb with
          | Some d ->
            check_climb (if d.climb_transposed then transpose f else f) l d
          | None -> false)
     | None -> true)

type scheme = { arity : int; first : Number.t; coefficients : Number.t list;
                common : Number.t }

(** val times_sigma : int -> Number.t list -> Number.t list **)

let rec times_sigma arity0 l =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> [])
    (fun k -> addmul Number.one l (Number.zero::(times_sigma k l)))
    arity0

(** val quotients : int -> Number.t list -> Number.t list -> Number.t list **)

let rec quotients degree recent = function
| [] -> []
| x::rest ->
  let q0 = Number.sub x (fold_right Number.add Number.zero recent) in
  q0::(quotients degree (firstn degree (q0::recent)) rest)

(** val over_sigma : int -> Number.t list -> Number.t list **)

let over_sigma arity0 l =
  firstn (sub (length l) (sub arity0 (Stdlib.succ 0)))
    (quotients (sub arity0 (Stdlib.succ 0)) [] l)

(** val iterate :
    int -> (Number.t list -> Number.t list) -> Number.t list -> Number.t list **)

let rec iterate m f l =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> l)
    (fun k -> f (iterate k f l))
    m

(** val transition : int -> int -> Number.t list -> zmat list **)

let transition arity0 size0 b =
  map (fun t0 ->
    map (fun j ->
      let s = add (mul arity0 j) t0 in
      map (fun k ->
        if Nat.leb k s then nth (sub s k) b Number.zero else Number.zero)
        (seq 0 size0)) (seq 0 size0)) (seq 0 arity0)

(** val matrix_size : int -> Number.t list -> int **)

let matrix_size arity0 b =
  Nat.max (Stdlib.succ 0)
    (Nat.div
      (add (sub (length b) (Stdlib.succ 0))
        (sub arity0 (Stdlib.succ (Stdlib.succ 0))))
      (sub arity0 (Stdlib.succ 0)))

(** val quotient : scheme -> int -> Number.t list **)

let quotient a order0 =
  iterate order0 (over_sigma a.arity) a.coefficients

(** val difference_symbol : scheme -> int -> Number.t list **)

let difference_symbol a order0 =
  map
    (Number.mul
      (Number.power (Number.of_natural a.arity) (Number.of_natural order0)))
    (quotient a order0)

(** val difference_family : scheme -> int -> family **)

let difference_family a order0 =
  let b = difference_symbol a order0 in
  let size0 = matrix_size a.arity b in
  { size = size0; denominator = a.common; matrices =
  (transition a.arity size0 b) }

(** val unity : Number.t **)

let unity =
  Number.power (Number.twice Number.one) (Number.twice (Number.twice
    (Number.twice (Number.twice (Number.twice (Number.twice
    (Number.twice_plus_one (Number.twice Number.one))))))))

(** val digits : int **)

let digits =
  mul (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
    (Stdlib.succ (Stdlib.succ (Stdlib.succ 0)))))))) (Stdlib.succ
    (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
    (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
    (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
    0))))))))))))))))

(** val roots_below : Number.t -> int -> Number.t -> Number.t -> Number.t **)

let rec roots_below base0 k top bottom0 =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> unity)
    (fun k' ->
    Number.square_root
      (Number.mul unity
        (if Number.less_equal bottom0
              (Number.mul (Number.twice Number.one) top)
         then Number.mul base0
                (roots_below base0 k'
                  (Number.sub (Number.mul (Number.twice Number.one) top)
                    bottom0) bottom0)
         else roots_below base0 k' (Number.mul (Number.twice Number.one) top)
                bottom0)))
    k

(** val power_below : Number.t -> int -> Number.t -> Number.t -> Number.t **)

let rec power_below base0 whole top bottom0 =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> roots_below base0 digits top bottom0)
    (fun k ->
    if Number.less_equal bottom0 top
    then Number.mul base0
           (power_below base0 k (Number.sub top bottom0) bottom0)
    else roots_below base0 digits top bottom0)
    whole

type exponent_certificate = { order : int; bound : q; of_radius : certificate }

(** val below_power : scheme -> q -> int -> q -> bool **)

let below_power a l order0 u =
  let bottom0 = l.qden in
  let top = Number.sub (Number.mul (Number.of_natural order0) bottom0) l.qnum
  in
  (&&)
    ((&&) (Number.less Number.zero l.qnum)
      (Number.less_equal Number.zero top))
    (Number.less_equal (Number.mul u.qnum unity)
      (Number.mul
        (power_below (Number.of_natural a.arity) order0 top bottom0) u.qden))

(** val divides : scheme -> int -> bool **)

let divides a order0 =
  (&&)
    (same (iterate order0 (times_sigma a.arity) (quotient a order0))
      a.coefficients)
    (Nat.leb
      (add (sub (length (quotient a order0)) (Stdlib.succ 0))
        (mul order0 (sub a.arity (Stdlib.succ 0))))
      (sub (length a.coefficients) (Stdlib.succ 0)))

(** val reducible : scheme -> int -> bool **)

let reducible a order0 =
  (&&)
    ((&&)
      ((&&) (Nat.leb (Stdlib.succ (Stdlib.succ 0)) a.arity)
        (Number.less Number.zero a.common)) (divides a order0))
    (Number.equal
      (fold_right Number.add Number.zero (difference_symbol a order0))
      (Number.mul (Number.of_natural a.arity) a.common))

(** val reduces : scheme -> q -> int -> q -> bool **)

let reduces a l order0 u =
  (&&) (reducible a order0) (below_power a l order0 u)

(** val check_exponent_lower : scheme -> q -> exponent_certificate -> bool **)

let check_exponent_lower a l cert =
  (&&) (reduces a l cert.order cert.bound)
    (check_radius { matrices_of = (difference_family a cert.order); lower =
      None; upper = (Some cert.bound) } cert.of_radius)

type stability = { start : Number.t; values : Number.t list;
                   scale : Number.t; inverse_matrix : zmat;
                   inverse_over : Number.t; level : int;
                   weights : Number.t list; row : Number.t; center : 
                   int }

(** val coefficient_at : scheme -> Number.t -> Number.t **)

let coefficient_at a k =
  if Number.less k a.first
  then Number.zero
  else nth (Z.to_nat (Number.sub k a.first)) a.coefficients Number.zero

(** val value_matrix : scheme -> Number.t -> int -> zmat **)

let value_matrix a start0 w =
  table w (fun i j ->
    Number.add
      (Number.sub
        (coefficient_at a
          (Number.sub
            (Number.mul (Number.of_natural a.arity)
              (Number.add start0 (Number.of_natural i)))
            (Number.add start0 (Number.of_natural j))))
        (if Nat.eqb i j then a.common else Number.zero)) a.common)

(** val values_right : scheme -> stability -> bool **)

let values_right a c =
  let w = length c.values in
  let e = value_matrix a c.start w in
  forallb (fun r ->
    Number.equal (dot r c.values) (Number.mul a.common c.scale)) e

(** val values_unique : scheme -> stability -> bool **)

let values_unique a c =
  let w = length c.values in
  let p = zproduct w c.inverse_matrix (value_matrix a c.start w) in
  (&&) (square w c.inverse_matrix)
    (forallb (fun j ->
      Number.less
        (norm1
          (map (fun i ->
            Number.sub (if Nat.eqb i j then c.inverse_over else Number.zero)
              (entry p i j)) (seq 0 w))) c.inverse_over) (seq 0 w))

(** val times_up : int -> Number.t list -> Number.t list -> Number.t list **)

let rec times_up step0 c u =
  match c with
  | [] -> []
  | x::c' -> addmul x u (app (repeat Number.zero step0) (times_up step0 c' u))

(** val fine :
    int -> Number.t list -> int -> Number.t list -> Number.t list **)

let rec fine a c m u =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> u)
    (fun k -> times_up (Nat.pow a k) c (fine a c k u))
    m

(** val fine_start : int -> Number.t -> int -> Number.t -> Number.t **)

let rec fine_start a f m s =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> s)
    (fun k ->
    Number.add (fine_start a f k s)
      (Number.mul (Number.of_natural (Nat.pow a k)) f))
    m

(** val correlate :
    int -> int -> Number.t list -> Number.t list -> Number.t list **)

let rec correlate fuel step0 omega u =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> [])
    (fun f -> (dot omega u)::(correlate f step0 omega (skipn step0 u)))
    fuel

(** val combined : scheme -> stability -> Number.t list **)

let combined a c =
  let u = fine a.arity a.coefficients c.level c.values in
  let step0 = Nat.pow a.arity c.level in
  let padded =
    app
      (repeat Number.zero
        (Z.to_nat
          (Number.sub (fine_start a.arity a.first c.level c.start)
            (Number.mul (Number.of_natural step0) c.row)))) u
  in
  correlate (length padded) step0 c.weights padded

(** val check_stable : scheme -> stability -> bool **)

let check_stable a c =
  let w = Number.of_natural (length c.values) in
  let a0 = Number.of_natural a.arity in
  let s = fine_start a.arity a.first c.level c.start in
  let step0 = Number.of_natural (Nat.pow a.arity c.level) in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&) (Number.less Number.zero c.scale)
                (Number.less_equal
                  (Number.mul (Number.sub a0 Number.one) c.start) a.first))
              (Number.less_equal
                (Number.add a.first
                  (Number.of_natural
                    (sub (length a.coefficients) (Stdlib.succ 0))))
                (Number.mul (Number.sub a0 Number.one)
                  (Number.sub (Number.add c.start w) Number.one))))
            (values_right a c)) (values_unique a c))
        (Number.less_equal (Number.mul step0 c.row) s))
      (Number.less_equal
        (Number.add (Number.of_natural (length c.weights))
          (Number.mul step0 (Number.sub c.row Number.one))) s))
    (Number.less (norm1 (combined a c))
      (Number.mul (Number.twice Number.one)
        (Number.abs (nth c.center (combined a c) Number.zero))))

type enclosure = { lower_end : exponent_certificate; radius_least : q;
                   shifts : stability }

(** val above_power : scheme -> q -> int -> q -> bool **)

let above_power a u order0 g =
  (&&)
    ((&&) (Number.less_equal Number.zero u.qnum) (Number.less g.qden g.qnum))
    (Number.less_equal
      (Number.mul
        (Number.mul
          (Number.power (Number.of_natural a.arity)
            (Number.of_natural order0)) unity) g.qden)
      (Number.mul g.qnum
        (power_below (Number.of_natural a.arity) order0 u.qnum u.qden)))

(** val encloses : scheme -> q -> q -> int -> q -> q -> stability -> bool **)

let encloses a l u order0 most least0 c =
  (&&)
    ((&&) ((&&) (reduces a l order0 most) (above_power a u order0 least0))
      (Nat.leb (Stdlib.succ 0) (length a.coefficients))) (check_stable a c)

(** val check_exponent : scheme -> q -> q -> enclosure -> bool **)

let check_exponent a l u cert =
  let low0 = cert.lower_end in
  (&&) (encloses a l u low0.order low0.bound cert.radius_least cert.shifts)
    (check_radius { matrices_of = (difference_family a low0.order); lower =
      (Some cert.radius_least); upper = (Some low0.bound) } low0.of_radius)

type exact_number = { polynomial : Number.t list; disc_re : Number.t;
                      disc_im : Number.t; disc_radius : Number.t;
                      disc_scale : Number.t; root : int }

(** val ztimes :
    (Number.t*Number.t) -> (Number.t*Number.t) -> Number.t*Number.t **)

let ztimes x y =
  (Number.sub (Number.mul (fst x) (fst y)) (Number.mul (snd x) (snd y))),
    (Number.add (Number.mul (fst x) (snd y)) (Number.mul (snd x) (fst y)))

(** val zsquare : (Number.t*Number.t) -> Number.t **)

let zsquare x =
  Number.add (Number.mul (fst x) (fst x)) (Number.mul (snd x) (snd x))

(** val taylor :
    Number.t -> (Number.t*Number.t) -> Number.t list ->
    Number.t*((Number.t*Number.t)*(Number.t*Number.t)) **)

let rec taylor s x = function
| [] -> Number.one,((Number.zero,Number.zero),(Number.zero,Number.zero))
| c::p' ->
  let k,p0 = taylor s x p' in
  let v,d = p0 in
  let xv = ztimes x v in
  let xd = ztimes x d in
  (Number.mul s k),(((Number.add (Number.mul c (Number.mul s k)) (fst xv)),
  (snd xv)),((Number.add (Number.mul s (fst v)) (fst xd)),(Number.add
                                                            (Number.mul s
                                                              (snd v))
                                                            (snd xd))))

(** val majorants :
    Number.t -> Number.t -> Number.t list ->
    Number.t*(Number.t*(Number.t*Number.t)) **)

let rec majorants s m = function
| [] -> Number.one,(Number.zero,(Number.zero,Number.zero))
| c::p' ->
  let k,p0 = majorants s m p' in
  let v,p1 = p0 in
  let d,w = p1 in
  (Number.mul s k),((Number.add (Number.mul (Number.abs c) (Number.mul s k))
                      (Number.mul m v)),((Number.add (Number.mul s v)
                                           (Number.mul m d)),(Number.add
                                                               (Number.mul
                                                                 (Number.mul
                                                                   (Number.twice
                                                                   Number.one)
                                                                   s) d)
                                                               (Number.mul m
                                                                 w))))

type place = { near_re : Number.t; near_im : Number.t;
               near_radius : Number.t; near_scale : Number.t; low : Number.t;
               high : Number.t; bottom : Number.t }

(** val one_zero : exact_number -> bool **)

let one_zero e =
  let s = e.disc_scale in
  let x = e.disc_re,e.disc_im in
  let m =
    Number.add (Number.add (Number.abs e.disc_re) (Number.abs e.disc_im))
      e.disc_radius
  in
  let d = snd (snd (taylor s x e.polynomial)) in
  let w = snd (snd (snd (majorants s m e.polynomial))) in
  (&&)
    ((&&) (Number.less Number.zero s)
      (Number.less_equal Number.zero e.disc_radius))
    (Number.less
      (Number.mul (Number.mul e.disc_radius w) (Number.mul e.disc_radius w))
      (Number.mul (Number.mul s s) (zsquare d)))

(** val zero_there : Number.t list -> place -> bool **)

let zero_there p h =
  let s = h.near_scale in
  let x = h.near_re,h.near_im in
  let m =
    Number.add (Number.add (Number.abs h.near_re) (Number.abs h.near_im))
      (Number.mul (Number.twice Number.one) h.near_radius)
  in
  let _,p0 = taylor s x p in
  let v,d = p0 in
  let w = snd (snd (snd (majorants s m p))) in
  (&&)
    ((&&)
      ((&&)
        ((&&) (Number.less Number.zero s)
          (Number.less_equal Number.zero h.near_radius))
        (Number.less Number.zero (zsquare d)))
      (Number.less_equal
        (Number.mul
          (Number.mul (Number.twice (Number.twice Number.one))
            (Number.mul s s)) (zsquare v))
        (Number.mul (Number.mul h.near_radius h.near_radius) (zsquare d))))
    (Number.less_equal
      (Number.mul
        (Number.mul
          (Number.mul (Number.twice (Number.twice (Number.twice (Number.twice
            Number.one)))) h.near_radius) w)
        (Number.mul
          (Number.mul (Number.twice (Number.twice (Number.twice (Number.twice
            Number.one)))) h.near_radius) w))
      (Number.mul (Number.mul s s) (zsquare d)))

(** val check_number : exact_number -> place -> bool **)

let check_number e h =
  let s = e.disc_scale in
  let n = h.near_scale in
  let k = Number.of_natural e.root in
  let dx = Number.sub (Number.mul h.near_re s) (Number.mul e.disc_re n) in
  let dy = Number.sub (Number.mul h.near_im s) (Number.mul e.disc_im n) in
  let slack =
    Number.sub (Number.mul e.disc_radius n)
      (Number.mul (Number.mul (Number.twice Number.one) h.near_radius) s)
  in
  let c = Number.power h.bottom k in
  let size0 = Number.mul (Number.mul c c) (zsquare (h.near_re,h.near_im)) in
  let lower0 =
    Number.add (Number.mul (Number.power h.low k) n)
      (Number.mul (Number.mul (Number.twice Number.one) h.near_radius) c)
  in
  let upper0 =
    Number.sub (Number.mul (Number.power h.high k) n)
      (Number.mul (Number.mul (Number.twice Number.one) h.near_radius) c)
  in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&)
                ((&&)
                  ((&&) ((&&) (one_zero e) (zero_there e.polynomial h))
                    (Number.less Number.zero k))
                  (Number.less Number.zero h.low))
                (Number.less Number.zero h.high))
              (Number.less Number.zero h.bottom))
            (Number.less_equal Number.zero slack))
          (Number.less_equal
            (Number.add (Number.mul dx dx) (Number.mul dy dy))
            (Number.mul slack slack)))
        (Number.less_equal (Number.mul lower0 lower0) size0))
      (Number.less_equal Number.zero upper0))
    (Number.less_equal size0 (Number.mul upper0 upper0))

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

(** val norm_pair : point -> Number.t **)

let norm_pair x =
  Number.add (norm1 (fst x)) (norm1 (snd x))

(** val difference : Number.t -> Number.t -> point -> point -> point **)

let difference a b x y =
  (addmul a (fst x) (addmul b (fst y) [])),(addmul a (snd x)
                                             (addmul b (snd y) []))

(** val vanishes : zvec -> bool **)

let vanishes =
  forallb (Number.equal Number.zero)

(** val run_pair : zmat list -> int list -> point -> point **)

let run_pair ms w x =
  (zrun ms w (fst x)),(zrun ms w (snd x))

(** val closes :
    Number.t -> Number.t list -> point -> point list -> point list -> bool **)

let rec closes q0 p seed first0 second =
  match p with
  | [] ->
    (match first0 with
     | [] -> (match second with
              | [] -> true
              | _::_ -> false)
     | _::_ -> false)
  | c::p' ->
    (match first0 with
     | [] -> false
     | x::first' ->
       (match second with
        | [] -> false
        | y::second' ->
          (&&)
            ((&&)
              (vanishes
                (addmul (Number.opposite q0) (fst y)
                  (addmul (Number.mul q0 c) (fst seed) (fst x))))
              (vanishes
                (addmul (Number.opposite q0) (snd y)
                  (addmul (Number.mul q0 c) (snd seed) (snd x)))))
            (closes q0 p' seed first' second')))

(** val over_up : Number.t -> Number.t -> Number.t **)

let over_up a s =
  Number.opposite (Number.divide (Number.opposite a) s)

(** val cut_by : Number.t -> zvec -> zvec **)

let cut_by s x =
  map (fun a -> Number.divide a s) x

(** val cut_error : int -> Number.t -> zvec -> Number.t **)

let cut_error n s x =
  if forallb (fun a -> Number.equal (Number.mul s (Number.divide a s)) a) x
  then Number.zero
  else Number.of_natural n

(** val evaluate :
    int -> Number.t -> Number.t -> Number.t -> Number.t -> point list ->
    point*Number.t **)

let rec evaluate n s c1 c2 rad = function
| [] -> ([],[]),Number.zero
| y::ys' ->
  (match ys' with
   | [] -> y,Number.zero
   | _::_ ->
     let p,e = evaluate n s c1 c2 rad ys' in
     let u,v = p in
     let re = addmul c1 u (addmul (Number.opposite c2) v []) in
     let im = addmul c1 v (addmul c2 u []) in
     ((addmul Number.one (fst y) (cut_by s re)),(addmul Number.one (snd y)
                                                  (cut_by s im))),(Number.add
                                                                    (over_up
                                                                    (Number.add
                                                                    (Number.mul
                                                                    (Number.add
                                                                    (Number.add
                                                                    (Number.abs
                                                                    c1)
                                                                    (Number.abs
                                                                    c2))
                                                                    (Number.mul
                                                                    (Number.twice
                                                                    Number.one)
                                                                    rad)) e)
                                                                    (Number.mul
                                                                    (Number.mul
                                                                    (Number.twice
                                                                    Number.one)
                                                                    rad)
                                                                    (Number.add
                                                                    (norm1 u)
                                                                    (norm1 v))))
                                                                    s)
                                                                    (Number.add
                                                                    (cut_error
                                                                    n s re)
                                                                    (cut_error
                                                                    n s im))))

(** val column_sums : zmat -> zvec **)

let column_sums m =
  fold_right (fun row0 sums -> addmul Number.one (map Number.abs row0) sums)
    [] m

(** val column_norm : zmat -> Number.t **)

let column_norm m =
  largest_of (column_sums m)

(** val base_right :
    family -> Number.t list -> int -> base list -> base -> bool **)

let base_right f p l =
  let d = f.denominator in
  let ms = f.matrices in
  let in_alphabet = fun w -> forallb (fun t0 -> Nat.ltb t0 (count f)) w in
  (fun bs b ->
  match b.previous with
  | Some p0 ->
    let k,p1 = p0 in
    let w,seed = p1 in
    (match nth_error bs k with
     | Some b' ->
       (&&)
         ((&&) ((&&) (in_alphabet w) (Nat.eqb (length w) l))
           (eqb b.conjugated b'.conjugated))
         (closes (Number.power d (Number.of_natural l)) p seed
           (app (map (run_pair ms w) b'.vectors) (([],[])::[]))
           (([],[])::b.vectors))
     | None -> false)
  | None -> true)

(** val walk : base list -> int -> int -> (int*int list) option **)

let rec walk bs m k =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> Some (k,[]))
    (fun m' ->
    match walk bs m' k with
    | Some p0 ->
      let k',w = p0 in
      (match nth_error bs k' with
       | Some b ->
         (match b.previous with
          | Some p1 ->
            let k'',p2 = p1 in let w',_ = p2 in Some (k'',(app w w'))
          | None -> None)
       | None -> None)
    | None -> None)
    m

(** val same_word : int list -> int list -> bool **)

let rec same_word v w =
  match v with
  | [] -> (match w with
           | [] -> true
           | _::_ -> false)
  | a::v' ->
    (match w with
     | [] -> false
     | b::w' -> (&&) (Nat.eqb a b) (same_word v' w'))

(** val agree : Number.t -> point list -> point list -> bool **)

let rec agree sign xs ys =
  match xs with
  | [] -> (match ys with
           | [] -> true
           | _::_ -> false)
  | x::xs' ->
    (match ys with
     | [] -> false
     | y::ys' ->
       (&&)
         ((&&) (vanishes (addmul sign (fst y) (fst x)))
           (vanishes (addmul sign (snd y) (snd x)))) (agree sign xs' ys'))

(** val linked :
    family -> base list -> int -> int list -> int -> int -> int list -> int
    -> bool **)

let linked f =
  let ms = f.matrices in
  (fun bs k v turns k' w turns' ->
  match walk bs turns k with
  | Some p0 ->
    let j,v' = p0 in
    (match walk bs turns' k' with
     | Some p1 ->
       let j',w' = p1 in
       let v0 = app v v' in
       let w0 = app w w' in
       (&&) (Nat.eqb (length v0) (length w0))
         ((||) ((&&) (Nat.eqb j j') (same_word v0 w0))
           (match nth_error bs j with
            | Some b ->
              (match nth_error bs j' with
               | Some b' ->
                 let xs = map (run_pair ms v0) b.vectors in
                 let ys = map (run_pair ms w0) b'.vectors in
                 (&&) (eqb b.conjugated b'.conjugated)
                   ((||) (agree (Number.opposite Number.one) xs ys)
                     (agree Number.one xs ys))
               | None -> false)
            | None -> false))
     | None -> false)
  | None -> false)

(** val led :
    family -> base list -> int -> int list -> int -> (int*zvec list) option **)

let led f =
  let ms = f.matrices in
  (fun bs k v turns ->
  match walk bs turns k with
  | Some p0 ->
    let j,v' = p0 in
    (match nth_error bs j with
     | Some b ->
       let v0 = app v v' in
       Some ((length v0),(map (fun x -> zrun ms v0 (fst x)) b.vectors))
     | None -> None)
  | None -> None)

(** val agree_at : int -> zvec list -> zvec list -> bool **)

let rec agree_at i xs ys =
  match xs with
  | [] -> (match ys with
           | [] -> true
           | _::_ -> false)
  | x::xs' ->
    (match ys with
     | [] -> false
     | y::ys' ->
       (&&) (Number.equal (nth i x Number.zero) (nth i y Number.zero))
         (agree_at i xs' ys'))

(** val equal_at :
    family -> base list -> int -> int list -> int -> int -> int list -> int
    -> int -> bool **)

let equal_at f bs k v turns k' w turns' i =
  match led f bs k v turns with
  | Some p0 ->
    let l,xs = p0 in
    (match led f bs k' w turns' with
     | Some p1 ->
       let l',ys = p1 in if Nat.eqb l l' then agree_at i xs ys else false
     | None -> false)
  | None -> false

(** val at_most_point :
    family -> place -> base list -> vertex -> int -> int -> vertex -> int ->
    bool **)

let at_most_point f h =
  let n = f.size in
  let d = f.denominator in
  (fun bs x t0 turns y turns' ->
  let m = letter f t0 in
  let moved0 = mv m (fst x.shown) in
  let equal = equal_at f bs x.from (t0::x.path) turns y.from y.path turns' in
  let error = Number.mul (column_norm m) x.off in
  forallb (fun i ->
    (||) (equal i)
      (Number.less_equal
        (Number.mul h.bottom (Number.add (nth i moved0 Number.zero) error))
        (Number.mul (Number.mul h.low d)
          (Number.sub (nth i (fst y.shown) Number.zero) y.off)))) (seq 0 n))

(** val base_positive : family -> place -> base -> bool **)

let base_positive f h =
  let n = f.size in
  (fun b ->
  let p0,e =
    evaluate n h.near_scale h.near_re
      (if b.conjugated then Number.opposite h.near_im else h.near_im)
      h.near_radius b.vectors
  in
  let u,_ = p0 in
  (&&) (forallb (fun y -> vanishes (snd y)) b.vectors)
    (forallb (fun i ->
      (||) (Number.less e (nth i u Number.zero))
        (forallb (fun y ->
          Number.equal (nth i (fst y) Number.zero) Number.zero) b.vectors))
      (seq 0 n)))

(** val make :
    family -> place -> base list -> vertex PositiveMap.t -> source -> point
    -> image list -> vertex option **)

let make f h =
  let n = f.size in
  let d = f.denominator in
  (fun bs known0 s v images0 ->
  match s with
  | FromBase k ->
    (match nth_error bs k with
     | Some b ->
       let x,e =
         evaluate n h.near_scale h.near_re
           (if b.conjugated then Number.opposite h.near_im else h.near_im)
           h.near_radius b.vectors
       in
       Some { from = k; path = []; shown = v; off =
       (Number.add e
         (norm_pair (difference Number.one (Number.opposite Number.one) x v)));
       image_list = images0 }
     | None -> None)
  | FromPoint (i, t0) ->
    (match PositiveMap.find i known0 with
     | Some parent ->
       let m = letter f t0 in
       let moved0 = (mv m (fst parent.shown)),(mv m (snd parent.shown)) in
       let whole =
         Number.add
           (Number.add
             (Number.mul (Number.mul h.bottom (column_norm m)) parent.off)
             (norm_pair
               (difference h.bottom (Number.opposite (Number.mul d h.low))
                 moved0 v)))
           (Number.mul (Number.mul d (Number.sub h.high h.low)) (norm_pair v))
       in
       if Nat.ltb t0 (count f)
       then Some { from = parent.from; path = (t0::parent.path); shown = v;
              off = (over_up whole (Number.mul d h.low)); image_list =
              images0 }
       else None
     | None -> None))

(** val build :
    family -> place -> base list -> Number.t -> (source*(point*image list))
    list -> vertex PositiveMap.t -> vertex list -> (vertex
    PositiveMap.t*vertex list) option **)

let rec build f h bs i given0 known0 all =
  match given0 with
  | [] -> Some (known0,all)
  | p0::rest ->
    let s,p1 = p0 in
    let v,images0 = p1 in
    (match make f h bs known0 s v images0 with
     | Some x ->
       build f h bs (Number.successor i) rest (PositiveMap.add i x known0)
         (x::all)
     | None -> None)

(** val image_right :
    family -> place -> base list -> bool -> vertex PositiveMap.t -> points ->
    Number.t -> Number.t -> Number.t -> Number.t -> Number.t -> vertex -> int
    -> image -> bool **)

let image_right f h =
  let d = f.denominator in
  (fun bs cone0 known0 ps weight0 one s r eps x t0 i ->
  match i with
  | Link (j, turns, turns') ->
    (match PositiveMap.find j known0 with
     | Some y -> linked f bs x.from (t0::x.path) turns y.from y.path turns'
     | None -> false)
  | Below (j, turns, turns') ->
    (match PositiveMap.find j known0 with
     | Some y -> (&&) cone0 (at_most_point f h bs x t0 turns y turns')
     | None -> false)
  | Inside ts ->
    let m = letter f t0 in
    (match line cone0 ps weight0 d
             ((mv m (fst x.shown)),(mv m (snd x.shown))) ts with
     | Some p0 ->
       let w,rest = p0 in
       let rest0 =
         Number.add (Number.add rest (Number.mul (Number.mul d w) eps))
           (Number.mul (Number.mul weight0 (column_norm m)) eps)
       in
       Number.less_equal
         (Number.mul h.bottom
           (Number.add (Number.mul (Number.mul w d) (Number.sub one r))
             (Number.mul rest0 s)))
         (Number.mul (Number.mul (Number.mul h.low weight0) d)
           (Number.sub one r))
     | None -> false))

(** val images_right :
    family -> place -> base list -> bool -> vertex PositiveMap.t -> points ->
    Number.t -> Number.t -> Number.t -> Number.t -> Number.t -> vertex -> int
    -> int -> image list -> bool **)

let rec images_right f h bs cone0 known0 ps weight0 one s r eps x t0 left l =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> true)
    (fun left' ->
    match l with
    | [] -> false
    | i::l' ->
      (&&) (image_right f h bs cone0 known0 ps weight0 one s r eps x t0 i)
        (images_right f h bs cone0 known0 ps weight0 one s r eps x
          (Stdlib.succ t0) left' l'))
    left

(** val below : family -> Number.t list -> int -> place -> body -> bool **)

let below f p l h =
  let n = f.size in
  (fun b ->
  (&&)
    ((&&)
      ((&&)
        ((&&) (Number.less Number.zero b.weight_one)
          (Nat.eqb (length b.unit_lines) n))
        (forallb (base_right f p l b.bases) b.bases))
      (if b.cone
       then (&&) (all_nonnegative f []) (forallb (base_positive f h) b.bases)
       else true))
    (match build f h b.bases Number.one b.given PositiveMap.empty [] with
     | Some p0 ->
       let known0,all = p0 in
       let ps = PositiveMap.mapi (fun _ v -> v.shown) known0 in
       let eps = largest_of (map (fun v -> v.off) all) in
       (match units b.cone ps b.unit_one 0 b.unit_lines with
        | Some p1 ->
          let s,r = p1 in
          let r0 = Number.add r (Number.mul s eps) in
          (&&) (Number.less r0 b.unit_one)
            (forallb (fun x ->
              images_right f h b.bases b.cone known0 ps b.weight_one
                b.unit_one s r0 eps x 0 (count f) x.image_list) all)
        | None -> false)
     | None -> false))

(** val reached :
    family -> Number.t list -> int -> place -> base list -> int -> int -> bool **)

let reached f p l h =
  let n = f.size in
  (fun bs turns first0 ->
  (&&) ((&&) (forallb (base_right f p l bs) bs) (Nat.ltb 0 turns))
    (match walk bs turns first0 with
     | Some p0 ->
       let k,_ = p0 in
       (match nth_error bs first0 with
        | Some x ->
          let p1,e =
            evaluate n h.near_scale h.near_re
              (if x.conjugated then Number.opposite h.near_im else h.near_im)
              h.near_radius x.vectors
          in
          let u,v = p1 in
          (&&) (Nat.eqb k first0)
            (existsb (fun i ->
              (||) (Number.less e (Number.abs (nth i u Number.zero)))
                (Number.less e (Number.abs (nth i v Number.zero)))) (seq 0 n))
        | None -> false)
     | None -> false))

type cycle = { carrier : int; part : q; weight : q; cut : Number.t;
               least : q; stops : (int*(int*point)) list }

type station = { state_at : int; class_at : int; row_at : vertex }

(** val distinct : int list -> bool **)

let rec distinct = function
| [] -> true
| a::l' -> (&&) (negb (existsb (Nat.eqb a) l')) (distinct l')

(** val pairs : station list -> (station*station) list **)

let pairs ss = match ss with
| [] -> []
| s::rest -> combine ss (app rest (s::[]))

(** val stations :
    family -> place -> int list -> base list -> int -> int -> vertex ->
    (int*(int*point)) list -> station list option **)

let rec stations g h firsts bs j c x = function
| [] -> Some ({ state_at = j; class_at = c; row_at = x }::[])
| p0::l' ->
  let j',p1 = p0 in
  let c',v = p1 in
  (match make g h bs (PositiveMap.add Number.one x PositiveMap.empty)
           (FromPoint (Number.one, (nth c firsts 0))) v [] with
   | Some y ->
     (match stations g h firsts bs j' c' y l' with
      | Some ss -> Some ({ state_at = j; class_at = c; row_at = x }::ss)
      | None -> None)
   | None -> None)

(** val turns_round : int list -> base list -> int -> station list -> bool **)

let turns_round firsts bs =
  let letter_at = fun s -> nth s.class_at firsts 0 in
  (fun k ss ->
  match nth_error bs k with
  | Some b ->
    (match b.previous with
     | Some p0 ->
       let k',p1 = p0 in
       let w,_ = p1 in
       (&&) (Nat.eqb k' k) (same_word w (rev (map letter_at ss)))
     | None -> false)
  | None -> false)

(** val way :
    family -> place -> int list -> base list -> cycle -> station list option **)

let way g h firsts bs c =
  match c.stops with
  | [] -> None
  | p0::l ->
    let j,p1 = p0 in
    let k,v = p1 in
    (match make g h bs PositiveMap.empty (FromBase c.carrier) v [] with
     | Some x ->
       (match stations g h firsts bs j k x l with
        | Some ss ->
          if turns_round firsts bs c.carrier ss then Some ss else None
        | None -> None)
     | None -> None)

(** val ways :
    family -> place -> int list -> base list -> cycle list ->
    (cycle*(station*station)) list option **)

let rec ways g h firsts bs = function
| [] -> Some []
| c::l' ->
  (match way g h firsts bs c with
   | Some ss ->
     (match ways g h firsts bs l' with
      | Some all -> Some (app (map (fun q0 -> c,q0) (pairs ss)) all)
      | None -> None)
   | None -> None)

(** val shortened : family -> cycle -> vertex -> point*Number.t **)

let shortened f =
  let n = f.size in
  (fun c x ->
  let s = c.cut in
  let v = x.shown in
  ((cut_by s (fst v)),(cut_by s (snd v))),(Number.add (over_up x.off s)
                                            (Number.add
                                              (cut_error n s (fst v))
                                              (cut_error n s (snd v)))))

(** val row_square : family -> point -> zmat **)

let row_square f =
  let n = f.size in
  (fun v ->
  gram
    (map (fun k ->
      (nth k (fst v) Number.zero)::((nth k (snd v) Number.zero)::[]))
      (seq 0 n)))

(** val length_square : family -> state list -> int -> zmat **)

let length_square f states0 =
  let n = f.size in (fun j -> gram (columns n (coordinates_of states0 j)))

(** val station_right :
    family -> place -> q -> int list -> state list -> cycle -> station ->
    station -> bool **)

let station_right f h g firsts states0 =
  let n = f.size in
  let letter_at = fun s -> nth s.class_at firsts 0 in
  (fun c s s' ->
  let t0 = letter_at s in
  let x,off_x = shortened f c s.row_at in
  let y,off_y = shortened f c s'.row_at in
  let l1 = c.least.qnum in
  let l2 = c.least.qden in
  let lo = Number.mul l1 l1 in
  let bo = Number.mul l2 l2 in
  let k1 = c.part.qnum in
  let k2 = c.part.qden in
  let c1 = c.weight.qnum in
  let c2 = c.weight.qden in
  let a = Number.mul (Number.mul f.denominator f.denominator) lo in
  let b = Number.mul (Number.mul a (Number.sub k2 k1)) c1 in
  let d = Number.mul (Number.mul bo (Number.mul g.qnum g.qnum)) c1 in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&)
                ((&&)
                  ((&&)
                    ((&&) (Nat.ltb s.state_at (length states0))
                      (Nat.ltb s'.state_at (length states0)))
                    (Nat.ltb t0 (count f)))
                  (Number.less_equal Number.zero k1))
                (Number.less_equal k1 k2)) (Number.less_equal Number.zero c1))
            (Number.less Number.zero c.cut)) (Number.less Number.zero l1))
        (Number.less_equal (Number.mul l1 h.bottom) (Number.mul h.low l2)))
      (semidefinite n
        (add_rows (Number.opposite (Number.mul (Number.mul bo k2) c2))
          (gram
            (map (mv (coordinates_of states0 s.state_at))
              (columns n (letter f t0))))
          (add_rows (Number.mul (Number.mul a k1) c2)
            (length_square f states0 s'.state_at)
            (add_rows b (row_square f y)
              (diagonal n
                (Number.opposite
                  (Number.mul b
                    (Number.mul
                      (Number.mul (Number.twice Number.one) (norm_pair y))
                      off_y)))))))))
    (semidefinite n
      (add_rows (Number.mul (Number.mul lo (Number.mul g.qden g.qden)) c2)
        (length_square f states0 s.state_at)
        (add_rows (Number.opposite d) (row_square f x)
          (diagonal n
            (Number.opposite
              (Number.mul d
                (Number.add
                  (Number.mul
                    (Number.mul (Number.twice Number.one) (norm_pair x))
                    off_x) (Number.mul off_x off_x)))))))))

(** val keeps : (cycle*(station*station)) list -> int -> int -> bool **)

let keeps l j c =
  existsb (fun q0 ->
    let s = fst (snd q0) in (&&) (Nat.eqb s.state_at j) (Nat.eqb s.class_at c))
    l

(** val graph_below :
    family -> Number.t list -> int -> place -> q -> Number.t -> int list ->
    element list -> turn list -> state list -> base list -> cycle list -> bool **)

let graph_below f p l h g unity0 firsts group turns states0 bs cycles =
  let g0 = transpose f in
  (&&)
    ((&&) (forallb (base_right g0 p l bs) bs)
      (Number.less_equal (Number.mul g.qnum h.bottom)
        (Number.mul h.low g.qden)))
    (match ways g0 h firsts bs cycles with
     | Some l0 ->
       (&&)
         ((&&) (distinct (map (fun q0 -> (fst (snd q0)).state_at) l0))
           (forallb (fun q0 ->
             station_right f h g firsts states0 (fst q0) (fst (snd q0))
               (snd (snd q0))) l0))
         (graph_but (keeps l0) f g unity0 firsts group turns states0)
     | None -> false)

(** val changes : Number.t -> Number.t list -> int **)

let rec changes last0 = function
| [] -> 0
| x::l' ->
  if Number.equal x Number.zero
  then changes last0 l'
  else add
         (if Number.less (Number.mul x last0) Number.zero
          then Stdlib.succ 0
          else 0) (changes x l')

(** val low_zeros : Number.t list -> int **)

let rec low_zeros = function
| [] -> 0
| x::l' ->
  if Number.equal x Number.zero then Stdlib.succ (low_zeros l') else 0

(** val sign_count : Number.t list -> int **)

let sign_count l =
  add (low_zeros l) (changes Number.zero l)

(** val middles : zmat -> Number.t -> int -> zvec -> int -> Number.t list **)

let rec middles m d r x n =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> [])
    (fun k ->
    (Number.mul (nth r x Number.zero) (Number.power d (Number.of_natural k)))::
    (middles m d r (mv m x) k))
    n

(** val numerator : Number.t list -> Number.t list -> Number.t list **)

let rec numerator q0 middles0 =
  match q0 with
  | [] -> []
  | _::q' -> (dot q' middles0)::(numerator q' middles0)

(** val zpower_times :
    int -> Number.t list -> Number.t list -> Number.t list **)

let rec zpower_times l p q0 =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> q0)
    (fun k -> zproduct_of p (zpower_times k p q0))
    l

type pole = { squares_of : squares; recurrence : Number.t list;
              multiplicity : int; cofactor : Number.t list }

(** val reduced : Number.t list -> pole -> Number.t list **)

let reduced p c =
  zpower_times c.multiplicity p c.cofactor

(** val middles_of : family -> Number.t list -> pole -> Number.t list **)

let middles_of f p c =
  let b = c.squares_of.symbol in
  let r = reach_of (count f) b in
  middles (central_matrix (count f) b) f.denominator r (unit_at Number.one r)
    (add (length c.recurrence) (length (reduced p c)))

(** val satisfies :
    Number.t list -> Number.t list -> Number.t list -> bool **)

let satisfies p q0 middles0 =
  (&&) (negb (Number.equal (last p Number.zero) Number.zero))
    (forallb (fun n -> Number.equal (dot q0 (skipn n middles0)) Number.zero)
      (seq 0 (sub (length p) (Stdlib.succ 0))))

(** val pole_right : family -> Number.t list -> pole -> bool **)

let pole_right f p c =
  (&&)
    ((&&) (sum_of_squares f c.squares_of)
      (recurs f c.squares_of.symbol c.recurrence))
    (satisfies c.recurrence (reduced p c) (middles_of f p c))

(** val no_larger : family -> Number.t list -> place -> pole -> bool **)

let no_larger f p h c =
  let q0 = reduced p c in
  (&&) ((&&) (pole_right f p c) (Nat.ltb c.multiplicity (length q0)))
    (Nat.leb (sign_count (map Z.sgn (snd (shifted_by h.low h.bottom q0))))
      c.multiplicity)

(** val not_zero : Number.t list -> place -> bool **)

let not_zero p h =
  let s = h.near_scale in
  let x = h.near_re,h.near_im in
  let m =
    Number.add (Number.add (Number.abs h.near_re) (Number.abs h.near_im))
      (Number.mul (Number.twice Number.one) h.near_radius)
  in
  let v = fst (snd (taylor s x p)) in
  let d = fst (snd (snd (majorants s m p))) in
  Number.less
    (Number.mul
      (Number.mul (Number.mul (Number.twice Number.one) h.near_radius) d)
      (Number.mul (Number.mul (Number.twice Number.one) h.near_radius) d))
    (Number.mul (Number.mul s s) (zsquare v))

(** val is_pole : family -> Number.t list -> place -> pole -> bool **)

let is_pole f p h c =
  (&&) ((&&) (pole_right f p c) (Nat.leb (Stdlib.succ 0) c.multiplicity))
    (not_zero (numerator (reduced p c) (middles_of f p c)) h)

type exact_section =
| Bounded of section
| Attains of bool * body
| Cyclic of q * Number.t * int list * element list * turn list * state list
   * base list * cycle list
| Leading of pole

(** val positive_zero : exact_number -> place -> bool **)

let positive_zero e h =
  (&&) (Number.equal e.disc_im Number.zero)
    (Number.less h.near_radius h.near_re)

(** val simple_number : exact_number -> place -> bool **)

let simple_number e h =
  (&&) (positive_zero e h) (Nat.eqb e.root (Stdlib.succ 0))

(** val block_below :
    exact_number -> place -> family -> exact_section -> bool **)

let block_below e h f = function
| Bounded s0 ->
  check_section f { qnum = h.low; qden = (Z.to_pos h.bottom) } s0
| Attains (transposed, b) ->
  (&&) (if b.cone then positive_zero e h else true)
    (below (if transposed then transpose f else f) e.polynomial e.root h b)
| Cyclic (g, unity0, firsts, group, turns, states0, bs, cycles) ->
  graph_below f e.polynomial e.root h g unity0 firsts group turns states0 bs
    cycles
| Leading c -> (&&) (simple_number e h) (no_larger f e.polynomial h c)

(** val block_reaches :
    exact_number -> place -> family -> exact_section -> bool **)

let block_reaches e h f = function
| Bounded _ -> false
| Attains (transposed, b) ->
  reached (if transposed then transpose f else f) e.polynomial e.root h
    b.bases b.full_turn b.first_base
| Cyclic (_, _, _, _, _, _, bs, _) ->
  reached (transpose f) e.polynomial e.root h bs (Stdlib.succ 0) 0
| Leading c -> (&&) (simple_number e h) (is_pole f e.polynomial h c)

type exact_certificate = { number_place : place; exact_basis : basis option;
                           exact_blocks : (int*exact_section) list }

(** val check_blocks : family -> exact_number -> exact_certificate -> bool **)

let check_blocks f e c =
  let h = c.number_place in
  (&&) (all_blocks (block_below e h) f c.exact_blocks)
    (some_block (block_reaches e h) f c.exact_blocks)

(** val check_number_and_blocks :
    family -> exact_number -> exact_certificate -> bool **)

let check_number_and_blocks f e c =
  (&&) ((&&) (well_formed f) (check_number e c.number_place))
    (match c.exact_basis with
     | Some b -> (&&) (basis_valid f.size b) (check_blocks (in_basis f b) e c)
     | None -> check_blocks f e c)

(** val check_exact_radius :
    family -> exact_number -> q option -> q option -> exact_certificate ->
    bool **)

let check_exact_radius f e lower0 upper0 c =
  let h = c.number_place in
  (&&)
    ((&&) (check_number_and_blocks f e c)
      (match lower0 with
       | Some l ->
         Number.less_equal (Number.mul l.qnum h.bottom)
           (Number.mul h.low l.qden)
       | None -> true))
    (match upper0 with
     | Some u ->
       Number.less_equal (Number.mul h.high u.qden)
         (Number.mul u.qnum h.bottom)
     | None -> true)

(** val check_exact_exponent :
    scheme -> int -> exact_number -> q option -> q option ->
    exact_certificate -> stability -> bool **)

let check_exact_exponent a order0 e lower0 upper0 c shifts0 =
  let h = c.number_place in
  let q0 = Z.to_pos h.bottom in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&) (reducible a order0)
                (Nat.leb (Stdlib.succ 0) (length a.coefficients)))
              (check_stable a shifts0)) (Number.less h.bottom h.low))
          (Number.less h.high
            (Number.mul
              (Number.power (Number.of_natural a.arity)
                (Number.of_natural order0)) h.bottom)))
        (check_number_and_blocks (difference_family a order0) e c))
      (match lower0 with
       | Some l ->
         (||) (Number.less_equal l.qnum Number.zero)
           (below_power a l order0 { qnum = h.high; qden = q0 })
       | None -> true))
    (match upper0 with
     | Some u -> above_power a u order0 { qnum = h.low; qden = q0 }
     | None -> true)

(** val zvalue : Number.t list -> Number.t -> Number.t **)

let rec zvalue p x =
  match p with
  | [] -> Number.zero
  | c::p' -> Number.add c (Number.mul x (zvalue p' x))

type modulus_proof =
| Between of int
| Whole of int * int
| Double of int * Number.t * pole

(** val is_power : exact_number -> Number.t -> bool **)

let is_power e x =
  let t0 = Number.power x (Number.of_natural e.root) in
  let d = Number.sub (Number.mul t0 e.disc_scale) e.disc_re in
  (&&)
    ((&&) (Number.equal (zvalue e.polynomial t0) Number.zero)
      (Number.less Number.zero x))
    (Number.less_equal
      (Number.add (Number.mul d d) (Number.mul e.disc_im e.disc_im))
      (Number.mul e.disc_radius e.disc_radius))

(** val attains_alone : exact_certificate -> bool **)

let attains_alone c =
  match c.exact_basis with
  | Some _ -> false
  | None ->
    (match c.exact_blocks with
     | [] -> false
     | p0::l ->
       let _,e = p0 in
       (match e with
        | Bounded _ -> false
        | Leading p ->
          (match l with
           | [] -> Nat.eqb p.multiplicity (Stdlib.succ 0)
           | _::_ -> false)
        | _ -> (match l with
                | [] -> true
                | _::_ -> false)))

(** val symbol_above : scheme -> int -> int -> Number.t list **)

let symbol_above a order0 below0 =
  map
    (Number.mul
      (Number.power (Number.of_natural a.arity)
        (Number.of_natural (sub order0 below0))))
    (iterate below0 (times_sigma a.arity) (quotient a order0))

(** val family_above : scheme -> int -> int -> Number.t -> family **)

let family_above a order0 below0 scale0 =
  let b = map (Number.mul scale0) (symbol_above a order0 below0) in
  let size0 = matrix_size a.arity b in
  { size = size0; denominator = (Number.mul scale0 a.common); matrices =
  (transition a.arity size0 b) }

(** val at_one : Number.t list **)

let at_one =
  (Number.opposite Number.one)::(Number.one::[])

(** val check_modulus :
    scheme -> int -> exact_number -> exact_certificate -> modulus_proof ->
    bool **)

let check_modulus a order0 e exact m =
  let h = exact.number_place in
  let a0 = Number.of_natural a.arity in
  (match m with
   | Between below0 ->
     (&&)
       ((&&) ((&&) (attains_alone exact) (Nat.ltb below0 order0))
         (Number.less
           (Number.mul (Number.power a0 (Number.of_natural below0)) h.bottom)
           h.low))
       (Number.less h.high
         (Number.mul
           (Number.power a0 (Number.of_natural (add below0 (Stdlib.succ 0))))
           h.bottom))
   | Whole (below0, level0) ->
     let k = sub order0 below0 in
     let t0 = difference_family a k in
     (&&)
       ((&&)
         ((&&)
           ((&&) (Nat.ltb below0 order0)
             (is_power e (Number.power a0 (Number.of_natural below0))))
           (reducible a k)) (well_formed t0))
       (norm_section t0 { qnum = Number.one; qden = Number.one } level0)
   | Double (below0, scale0, c) ->
     let t0 = family_above a order0 below0 scale0 in
     (&&)
       ((&&)
         ((&&)
           ((&&)
             ((&&)
               ((&&)
                 ((&&)
                   ((&&)
                     ((&&)
                       ((&&) (Nat.ltb below0 order0)
                         (Nat.leb (Stdlib.succ 0) below0))
                       (is_power e
                         (Number.power a0 (Number.of_natural below0))))
                     (attains_alone exact)) (Number.less Number.zero scale0))
                 (well_formed t0))
               (same c.squares_of.symbol
                 (map (Number.mul scale0) (symbol_above a order0 below0))))
             (Nat.leb (length c.squares_of.symbol) (length a.coefficients)))
           (pole_right t0 at_one c))
         (Nat.eqb c.multiplicity (Stdlib.succ (Stdlib.succ 0))))
       (negb
         (Number.equal
           (zvalue (numerator (reduced at_one c) (middles_of t0 at_one c))
             Number.one) Number.zero)))

(** val power_of : modulus_proof -> int **)

let power_of = function
| Double (_, _, _) -> Stdlib.succ 0
| _ -> 0

(** val check_logarithm :
    scheme -> int -> exact_number -> q option -> q option ->
    exact_certificate -> stability -> modulus_proof -> int -> bool **)

let check_logarithm a order0 e lower0 upper0 c shifts0 m p =
  (&&)
    ((&&) (check_exact_exponent a order0 e lower0 upper0 c shifts0)
      (check_modulus a order0 e c m)) (Nat.eqb p (power_of m))

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

(** val eigenvector_word : ascent -> int list **)

let eigenvector_word a =
  match a.eigenvector_base.previous with
  | Some p -> let _,p0 = p in let w,_ = p0 in w
  | None -> []

(** val at_eigenvector :
    family -> place -> ascent -> zvec -> Number.t -> bool **)

let at_eigenvector f h a =
  let n = f.size in
  let ys = a.eigenvector_base.vectors in
  (fun v d ->
  let p,off0 = evaluate n h.near_scale h.near_re h.near_im h.near_radius ys in
  let u,_ = p in
  forallb (fun i ->
    let x = Number.mul a.eigenvector_multiple.qden (nth i v Number.zero) in
    if Number.equal x Number.zero
    then forallb (fun y ->
           Number.equal (nth i (fst y) Number.zero) Number.zero) ys
    else (&&)
           (Number.less_equal x
             (Number.mul a.eigenvector_multiple.qnum
               (Number.sub (nth i u Number.zero) off0)))
           (Number.less_equal
             (Number.mul
               (Number.mul a.factor_scale a.eigenvector_multiple.qnum)
               (Number.add (nth i u Number.zero) off0)) (Number.mul d x)))
    (seq 0 n))

(** val beside_right :
    family -> exact_number -> place -> ascent -> zvec -> bool **)

let beside_right f e h a =
  let n = f.size in
  let d = f.denominator in
  (fun v ->
  let moved0 = zrun f.matrices (eigenvector_word a) a.beside in
  let low_power = Number.power (Number.mul h.low d) (Number.of_natural e.root)
  in
  let bottom_power = Number.power h.bottom (Number.of_natural e.root) in
  forallb (fun i ->
    let x = nth i a.beside Number.zero in
    if Number.equal (nth i v Number.zero) Number.zero
    then (&&) (Number.less Number.zero x)
           (Number.less_equal
             (Number.mul bottom_power (nth i moved0 Number.zero))
             (Number.mul low_power x))
    else Number.equal x Number.zero) (seq 0 n))

(** val follows : family -> place -> peak -> peak -> int -> bool **)

let follows f h =
  let n = f.size in
  let d = f.denominator in
  (fun x y t0 ->
  let moved0 = mv (letter f t0) y.peak_given in
  forallb (fun i ->
    let v = nth i x.peak_given Number.zero in
    let above = Number.mul h.bottom (nth i moved0 Number.zero) in
    if Number.equal v Number.zero
    then (||) (negb x.peak_whole)
           (Number.equal (nth i moved0 Number.zero) Number.zero)
    else (&&) (Number.less_equal (Number.mul (Number.mul h.high d) v) above)
           (Number.less_equal (Number.mul y.peak_factor above)
             (Number.mul x.peak_factor (Number.mul (Number.mul h.low d) v))))
    (seq 0 n))

(** val peak_right :
    family -> place -> ascent -> peak PositiveMap.t -> peak -> bool **)

let peak_right f h a =
  let n = f.size in
  (fun known0 x ->
  (&&)
    ((&&)
      ((&&) (vector_nonnegative x.peak_given)
        (Nat.leb (length x.peak_given) n))
      (Number.less Number.zero (norm1 x.peak_given)))
    (match x.peak_word with
     | [] -> at_eigenvector f h a x.peak_given x.peak_factor
     | t0::w ->
       (match PositiveMap.find x.peak_origin known0 with
        | Some y ->
          (&&)
            ((&&) ((&&) (Nat.ltb t0 (count f)) (same_word w y.peak_word))
              (implb x.peak_whole y.peak_whole)) (follows f h x y t0)
        | None -> false)))

(** val passes :
    family -> place -> ascent -> Number.t -> peak -> int -> int -> peak ->
    int -> bool **)

let passes f h a =
  let n = f.size in
  let d = f.denominator in
  (fun most x t0 turns y turns' ->
  let moved0 = mv (letter f t0) x.peak_given in
  let equal =
    if (&&) x.peak_whole y.peak_whole
    then equal_at f (a.eigenvector_base::[]) 0 (t0::x.peak_word) turns 0
           y.peak_word turns'
    else (fun _ -> false)
  in
  forallb (fun i ->
    (||) (equal i)
      (Number.less_equal
        (Number.mul (Number.mul (Number.mul h.high d) most)
          (nth i y.peak_given Number.zero))
        (Number.mul (Number.mul h.bottom a.factor_scale)
          (nth i moved0 Number.zero)))) (seq 0 n))

(** val rise_right :
    family -> place -> ascent -> peak PositiveMap.t -> points -> Number.t ->
    Number.t -> peak -> int -> rise -> bool **)

let rise_right f h a known0 ps most k x t0 = function
| Reaches j ->
  (match PositiveMap.find j known0 with
   | Some y ->
     (&&) (Coq_Pos.eqb y.peak_origin k)
       (match y.peak_word with
        | [] -> false
        | s::_ -> Nat.eqb s t0)
   | None -> false)
| Closes ->
  (&&) x.peak_whole (same_word (t0::x.peak_word) (eigenvector_word a))
| Passes (j, turns, turns') ->
  (match PositiveMap.find j known0 with
   | Some y -> passes f h a most x t0 turns y turns'
   | None -> false)
| Exceeds ts ->
  image_above f ps a.ascent_scale { qnum = (Number.mul h.high most); qden =
    (Z.to_pos (Number.mul h.bottom a.factor_scale)) } x.peak_given
    (letter f t0) ts

(** val all_right :
    family -> place -> ascent -> peak PositiveMap.t -> points -> Number.t ->
    Number.t -> peak list -> bool **)

let rec all_right f h a known0 ps most k = function
| [] -> true
| x::xs' ->
  (&&)
    ((&&) (peak_right f h a known0 x)
      (paired (rise_right f h a known0 ps most k x) (seq 0 (count f))
        x.peak_rises))
    (all_right f h a known0 ps most (Number.successor k) xs')

(** val check_ascent : family -> exact_number -> place -> ascent -> bool **)

let check_ascent f e h a =
  let most = largest_of (map (fun p -> p.peak_factor) a.peaks) in
  let known0 = number Number.one a.peaks in
  let ps = number Number.one (map (fun x -> x.peak_given,[]) a.peaks) in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&)
                ((&&) (all_nonnegative f [])
                  (Number.less Number.zero a.ascent_scale))
                (Number.less Number.zero a.factor_scale))
              (Number.less Number.zero most))
            (Number.less Number.zero a.eigenvector_multiple.qnum))
          (negb a.eigenvector_base.conjugated))
        (base_right f e.polynomial e.root (a.eigenvector_base::[])
          a.eigenvector_base))
      (match a.eigenvector_base.previous with
       | Some _ ->
         (match a.peaks with
          | [] -> false
          | x::_ ->
            (&&) (same_word [] x.peak_word)
              (beside_right f e h a x.peak_given))
       | None -> false)) (all_right f h a known0 ps most Number.one a.peaks)

(** val check_exact_subradius :
    family -> exact_number -> q option -> q option -> place -> ascent ->
    subradius_certificate -> bool **)

let check_exact_subradius f e lower0 upper0 h a bounds =
  (&&)
    ((&&)
      ((&&) ((&&) (well_formed f) (check_number e h)) (positive_zero e h))
      (check_ascent (if a.ascent_transposed then transpose f else f) e h a))
    (check_subradius { matrices_of = f; lower = lower0; upper = upper0 }
      bounds)

(** val class_sum : int -> Number.t list -> int -> Number.t **)

let class_sum a b r =
  fold_right Number.add Number.zero
    (map (fun k -> nth (add r (mul a k)) b Number.zero) (seq 0 (length b)))

(** val no_more_factors : scheme -> int -> stability -> bool **)

let no_more_factors a order0 c =
  (&&)
    ((&&)
      ((&&) ((&&) (reducible a order0) (Nat.leb (Stdlib.succ 0) order0))
        (Nat.leb (Stdlib.succ 0) (length a.coefficients))) (check_stable a c))
    (existsb (fun r ->
      negb
        (Number.equal (class_sum a.arity (difference_symbol a order0) r)
          a.common)) (seq 0 a.arity))

(** val check_rough : scheme -> int -> int -> stability -> bool **)

let check_rough a order0 k c =
  (&&) (no_more_factors a order0 c) (Nat.leb order0 k)

(** val check_full :
    scheme -> q -> q -> exponent_certificate -> stability -> bool **)

let check_full a l u low0 c =
  (&&)
    ((&&) (check_exponent_lower a l low0) (no_more_factors a low0.order c))
    (Number.less_equal (Number.mul (Number.of_natural low0.order) u.qden)
      u.qnum)

type reduction = { shift_factor : Number.t list; other_scheme : scheme;
                   own_order : int; own_bound : q; own_radius : certificate }

(** val converges : scheme -> reduction -> bool **)

let converges a c =
  let m = c.own_order in
  let u = c.own_bound in
  (&&)
    ((&&) ((&&) (Nat.leb (Stdlib.succ 0) m) (reducible a m))
      (Number.less u.qnum
        (Number.mul
          (Number.power (Number.of_natural a.arity) (Number.of_natural m))
          u.qden)))
    (check_radius { matrices_of = (difference_family a m); lower = None;
      upper = (Some u) } c.own_radius)

(** val check_factor : scheme -> scheme -> Number.t list -> bool **)

let check_factor a b p =
  (&&)
    ((&&)
      ((&&)
        ((&&) ((&&) (Nat.eqb b.arity a.arity) (Number.equal b.first a.first))
          (Number.less Number.zero b.common))
        (negb (Number.equal (nth 0 p Number.zero) Number.zero)))
      (negb (Number.equal (fold_right Number.add Number.zero p) Number.zero)))
    (same
      (map (Number.mul b.common) (times_up (Stdlib.succ 0) p a.coefficients))
      (map (Number.mul a.common) (times_up a.arity p b.coefficients)))

(** val check_reduced : scheme -> reduction -> (scheme -> bool) -> bool **)

let check_reduced a c check =
  (&&) ((&&) (check_factor a c.other_scheme c.shift_factor) (converges a c))
    (check c.other_scheme)

type sequences =
| Any
| Follows of (int*int) list

(** val any_of : int -> Number.t -> zmat list list -> family **)

let any_of size0 denominator0 each0 =
  { size = size0; denominator = denominator0; matrices =
    (flat_map (fun ms -> ms) each0) }

(** val row_in_place : int -> int -> int -> Number.t list -> Number.t list **)

let row_in_place k size0 j row0 =
  app (repeat Number.zero (mul j size0))
    (app row0
      (repeat Number.zero (mul (sub (sub k (Stdlib.succ 0)) j) size0)))

(** val in_place : int -> int -> int -> int -> zmat -> zmat **)

let in_place k size0 i j m =
  app (repeat (repeat Number.zero (mul k size0)) (mul i size0))
    (app (map (row_in_place k size0 j) m)
      (repeat (repeat Number.zero (mul k size0))
        (mul (sub (sub k (Stdlib.succ 0)) i) size0)))

(** val states : (int*int) list -> int **)

let states pairs0 =
  Stdlib.succ
    (fold_right (fun e most -> Nat.max (fst e) (Nat.max (snd e) most)) 0
      pairs0)

(** val follows_of :
    int -> Number.t -> zmat list list -> (int*int) list -> family **)

let follows_of size0 denominator0 each0 pairs0 =
  let k = states pairs0 in
  { size = (mul k size0); denominator = denominator0; matrices =
  (flat_map (fun e ->
    map (in_place k size0 (fst e) (snd e)) (nth (snd e) each0 [])) pairs0) }

(** val along : sequences -> int -> Number.t -> zmat list list -> family **)

let along s size0 denominator0 each0 =
  match s with
  | Any -> any_of size0 denominator0 each0
  | Follows pairs0 -> follows_of size0 denominator0 each0 pairs0

(** val known : int -> sequences -> bool **)

let known n = function
| Any -> true
| Follows pairs0 ->
  forallb (fun e -> (&&) (Nat.ltb (fst e) n) (Nat.ltb (snd e) n)) pairs0

type masks = { masks_arity : int; masks_common : Number.t;
               each : (Number.t*Number.t list) list }

(** val no_mask : Number.t*Number.t list **)

let no_mask =
  Number.zero,[]

(** val scheme_of : masks -> (Number.t*Number.t list) -> scheme **)

let scheme_of m p =
  { arity = m.masks_arity; first = (fst p); coefficients = (snd p); common =
    m.masks_common }

(** val level_symbols : masks -> int -> Number.t list list **)

let level_symbols m order0 =
  map (fun p -> difference_symbol (scheme_of m p) order0) m.each

(** val level_size : masks -> int -> int **)

let level_size m order0 =
  fold_right (fun b most -> Nat.max (matrix_size m.masks_arity b) most)
    (Stdlib.succ 0) (level_symbols m order0)

(** val level_matrices : masks -> int -> zmat list list **)

let level_matrices m order0 =
  map (transition m.masks_arity (level_size m order0))
    (level_symbols m order0)

(** val levels_family : masks -> sequences -> int -> family **)

let levels_family m s order0 =
  along s (level_size m order0) m.masks_common (level_matrices m order0)

(** val levels_reduce : masks -> sequences -> q -> int -> q -> bool **)

let levels_reduce m s l order0 u =
  (&&)
    ((&&)
      ((&&) (Nat.leb (Stdlib.succ (Stdlib.succ 0)) m.masks_arity)
        (forallb (fun p -> reducible (scheme_of m p) order0) m.each))
      (below_power (scheme_of m no_mask) l order0 u))
    (known (length m.each) s)

(** val check_levels :
    masks -> sequences -> q -> exponent_certificate -> bool **)

let check_levels m s l cert =
  (&&) (levels_reduce m s l cert.order cert.bound)
    (check_radius { matrices_of = (levels_family m s cert.order); lower =
      None; upper = (Some cert.bound) } cert.of_radius)

type ranged = { ranged_arity : int; ranged_first : Number.t;
                numerators : Number.t list list;
                ranged_divisor : Number.t list }

(** val times_linear :
    Number.t -> Number.t -> Number.t list -> Number.t list **)

let times_linear c d f =
  addmul c (app f (Number.zero::[])) (Number.zero::(map (Number.mul d) f))

(** val powers_of : Number.t -> int -> Number.t list **)

let rec powers_of e n =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> Number.one::[])
    (fun k -> times_linear e e (powers_of e k))
    n

(** val polynomial_form :
    Number.t -> Number.t -> Number.t -> Number.t list -> Number.t list **)

let rec polynomial_form a b e = function
| [] -> []
| c::rest ->
  addmul c (powers_of e (length rest))
    (times_linear a b (polynomial_form a b e rest))

(** val form_between : q -> q -> Number.t list -> Number.t list **)

let form_between low0 high0 =
  polynomial_form (Number.mul low0.qnum high0.qden)
    (Number.mul high0.qnum low0.qden) (Number.mul low0.qden high0.qden)

(** val control_masks : ranged -> q -> q -> Number.t -> masks **)

let control_masks a low0 high0 common0 =
  let q0 = form_between low0 high0 a.ranged_divisor in
  let forms = map (form_between low0 high0) a.numerators in
  { masks_arity = a.ranged_arity; masks_common = common0; each =
  (map (fun j ->
    let factor0 = Number.divide common0 (nth j q0 Number.zero) in
    a.ranged_first,(map (fun f -> Number.mul factor0 (nth j f Number.zero))
                     forms)) (seq 0 (length a.ranged_divisor))) }

(** val has_control_masks : ranged -> q -> q -> Number.t -> bool **)

let has_control_masks a low0 high0 common0 =
  let q0 = form_between low0 high0 a.ranged_divisor in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&) (Number.less Number.zero common0)
              (Number.less (Number.mul low0.qnum high0.qden)
                (Number.mul high0.qnum low0.qden)))
            (Nat.leb (Stdlib.succ 0) (length a.ranged_divisor)))
          (Nat.leb (Stdlib.succ 0) (length a.numerators)))
        (forallb (fun l -> Nat.eqb (length l) (length a.ranged_divisor))
          a.numerators))
      ((||) (forallb (Number.less Number.zero) q0)
        (forallb (fun c -> Number.less c Number.zero) q0)))
    (forallb (fun c ->
      Number.equal (Number.mul (Number.divide common0 c) c) common0) q0)

(** val range_family : masks -> int -> family **)

let range_family m order0 =
  let all = levels_family m Any order0 in
  let n = length m.each in
  { size = all.size; denominator = m.masks_common; matrices =
  (flat_map (fun t0 ->
    map (fun j -> letter all (add (mul j m.masks_arity) t0)) (seq 0 n))
    (seq 0 m.masks_arity)) }

(** val below_power_strictly : int -> q -> int -> q -> bool **)

let below_power_strictly arity0 l order0 u =
  let bottom0 = l.qden in
  let top = Number.sub (Number.mul (Number.of_natural order0) bottom0) l.qnum
  in
  (&&)
    ((&&) (Number.less_equal Number.zero l.qnum)
      (Number.less Number.zero top))
    (Number.less (Number.mul u.qnum unity)
      (Number.mul (power_below (Number.of_natural arity0) order0 top bottom0)
        u.qden))

(** val check_interval :
    ranged -> q -> q -> q -> Number.t -> exponent_certificate -> bool **)

let check_interval a low0 high0 l common0 cert =
  let m = control_masks a low0 high0 common0 in
  (&&)
    ((&&)
      ((&&)
        ((&&) (Nat.leb (Stdlib.succ (Stdlib.succ 0)) a.ranged_arity)
          (has_control_masks a low0 high0 common0))
        (forallb (fun p -> reducible (scheme_of m p) cert.order) m.each))
      (below_power_strictly a.ranged_arity l cert.order cert.bound))
    (check_radius { matrices_of = (range_family m cert.order); lower = None;
      upper = (Some cert.bound) } cert.of_radius)

(** val check_range_levels :
    ranged -> q -> q -> q -> Number.t -> exponent_certificate -> bool **)

let check_range_levels =
  check_interval

(** val check_range :
    ranged -> q -> q -> q -> (q*(Number.t*exponent_certificate)) list -> bool **)

let rec check_range a low0 high0 l = function
| [] -> false
| p::pieces' ->
  let next,p0 = p in
  let common0,cert = p0 in
  (match pieces' with
   | [] -> check_interval a low0 high0 l common0 cert
   | _::_ ->
     (&&) (check_interval a low0 next l common0 cert)
       (check_range a next high0 l pieces'))

type rule = { above_bar : Number.t list; below_bar : Number.t list;
              of_root : bool }

(** val fits : bool -> Number.t -> bool **)

let fits strict c =
  if strict
  then Number.less Number.zero c
  else Number.less_equal Number.zero c

(** val signed_on :
    int -> bool -> Number.t -> Number.t -> Number.t -> Number.t list -> bool **)

let rec signed_on fuel strict a b e l =
  let f = polynomial_form a b e l in
  if negb
       ((&&) (fits strict (hd Number.zero f))
         (fits strict (last f Number.zero)))
  then false
  else if forallb (fits strict) f
       then true
       else ((fun zero next n -> if n = 0 then zero () else next (n - 1))
               (fun _ -> false)
               (fun k ->
               if signed_on k strict (Number.mul (Number.twice Number.one) a)
                    (Number.add a b) (Number.mul (Number.twice Number.one) e)
                    l
               then signed_on k strict (Number.add a b)
                      (Number.mul (Number.twice Number.one) b)
                      (Number.mul (Number.twice Number.one) e) l
               else false)
               fuel)

(** val signed_between : bool -> q -> q -> Number.t list -> bool **)

let signed_between strict low0 high0 l =
  (&&) (Nat.leb (Stdlib.succ 0) (length l))
    (signed_on (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ (Stdlib.succ
      (Stdlib.succ
      0)))))))))))))))))))))))))))))))))))))))))))))))))))))))))))) strict
      (Number.mul low0.qnum high0.qden) (Number.mul high0.qnum low0.qden)
      (Number.mul low0.qden high0.qden) l)

(** val shifted : Number.t -> Number.t -> Number.t list -> Number.t list **)

let rec shifted a e = function
| [] -> []
| c::rest ->
  let s = shifted a e rest in
  addmul (Number.mul c (Number.power e (Number.of_natural (length rest))))
    (Number.one::[]) (addmul a s (Number.zero::(map (Number.mul e) s)))

(** val signed_beyond : bool -> q -> q -> Number.t list -> bool **)

let signed_beyond strict low0 far l =
  let s = shifted far.qnum far.qden l in
  (&&)
    ((&&)
      ((&&)
        (Number.less_equal (Number.mul low0.qnum far.qden)
          (Number.mul far.qnum low0.qden)) (signed_between strict low0 far l))
      (fits strict (hd Number.zero s)))
    (forallb (Number.less_equal Number.zero) s)

(** val bounded_below :
    Number.t -> q -> Number.t list -> Number.t list -> Number.t list **)

let bounded_below sign c p q0 =
  addmul (Number.opposite (Number.mul sign c.qnum)) q0
    (map (Number.mul (Number.mul sign c.qden)) p)

(** val bounded_above :
    Number.t -> q -> Number.t list -> Number.t list -> Number.t list **)

let bounded_above sign d p q0 =
  addmul (Number.opposite (Number.mul sign d.qden)) p
    (map (Number.mul (Number.mul sign d.qnum)) q0)

(** val squared : q -> q **)

let squared c =
  { qnum = (Number.mul c.qnum c.qnum); qden = (Coq_Pos.mul c.qden c.qden) }

(** val not_negative : q -> q **)

let not_negative c =
  if Number.less c.qnum Number.zero
  then { qnum = Number.zero; qden = Number.one }
  else c

(** val denominator_signed :
    rule -> Number.t -> (bool -> Number.t list -> bool) -> bool **)

let denominator_signed r sign test =
  let q0 = r.below_bar in
  (&&)
    ((||) (Number.equal sign Number.one)
      (Number.equal sign (Number.opposite Number.one)))
    (test true (map (Number.mul sign) q0))

(** val next_at_least :
    rule -> Number.t -> (bool -> Number.t list -> bool) -> q -> bool **)

let next_at_least r sign test =
  let p = r.above_bar in
  let q0 = r.below_bar in
  (fun c ->
  test false
    (bounded_below sign (if r.of_root then squared (not_negative c) else c) p
      q0))

(** val next_at_most :
    rule -> Number.t -> (bool -> Number.t list -> bool) -> q -> bool **)

let next_at_most r sign test =
  let p = r.above_bar in
  let q0 = r.below_bar in
  (fun d ->
  if r.of_root
  then (&&) (Number.less_equal Number.zero d.qnum)
         (test false (bounded_above sign (squared d) p q0))
  else test false (bounded_above sign d p q0))

(** val next_smaller :
    rule -> Number.t -> (bool -> Number.t list -> bool) -> bool **)

let next_smaller r sign test =
  let p = r.above_bar in
  let q0 = r.below_bar in
  if r.of_root
  then test false
         (addmul
           (Number.opposite
             (Number.mul sign (Number.twice (Number.twice
               (Number.twice_plus_one (Number.twice (Number.twice
               (Number.twice_plus_one Number.one)))))))) p
           (Number.zero::(Number.zero::(map
                                         (Number.mul
                                           (Number.mul sign
                                             (Number.twice_plus_one
                                             (Number.twice (Number.twice
                                             (Number.twice
                                             (Number.twice_plus_one
                                             (Number.twice Number.one))))))))
                                         q0))))
  else test false
         (addmul
           (Number.opposite
             (Number.mul sign (Number.twice (Number.twice_plus_one
               (Number.twice Number.one))))) p
           (Number.zero::(map
                           (Number.mul
                             (Number.mul sign (Number.twice_plus_one
                               (Number.twice (Number.twice Number.one))))) q0)))

(** val leads : rule -> Number.t -> (q*q) -> (q*q) -> bool **)

let leads r sign from0 to0 =
  let test = fun strict l -> signed_between strict (fst from0) (snd from0) l
  in
  (&&)
    ((&&) (denominator_signed r sign test)
      (next_at_least r sign test (fst to0)))
    (next_at_most r sign test (snd to0))

(** val descends : rule -> Number.t -> q -> q -> q -> bool **)

let descends r sign low0 high0 far =
  let test = fun strict l -> signed_beyond strict high0 far l in
  (&&)
    ((&&)
      ((&&) (Number.less Number.zero high0.qnum)
        (denominator_signed r sign test)) (next_at_least r sign test low0))
    (next_smaller r sign test)

(** val less_or_equal : q -> q -> bool **)

let less_or_equal x y =
  Number.less_equal (Number.mul x.qnum y.qden) (Number.mul y.qnum x.qden)

(** val way0 : rule -> (q*q) -> (Number.t*(q*q)) list -> q -> q -> bool **)

let rec way0 r at_ levels low0 high0 =
  match levels with
  | [] -> (&&) (less_or_equal low0 (fst at_)) (less_or_equal (snd at_) high0)
  | p::rest ->
    let sign,next = p in
    (&&) (leads r sign at_ next) (way0 r next rest low0 high0)

type follow_certificate = { range_sign : Number.t;
                            way_levels : (Number.t*(q*q)) list;
                            descent : (Number.t*q) option }

(** val check_follow :
    ranged -> rule -> q -> q option -> int option -> q -> q -> q -> Number.t
    -> exponent_certificate -> follow_certificate -> bool **)

let check_follow a r first0 last0 from0 low0 high0 l common0 cert c =
  (&&)
    ((&&)
      ((&&) (check_range_levels a low0 high0 l common0 cert)
        (leads r c.range_sign (low0,high0) (low0,high0)))
      (way0 r (first0,(match last0 with
                       | Some u -> u
                       | None -> high0)) c.way_levels low0 high0))
    (match last0 with
     | Some _ ->
       (match from0 with
        | Some n -> Nat.leb (length c.way_levels) n
        | None -> true)
     | None ->
       (match from0 with
        | Some _ -> false
        | None ->
          (match c.descent with
           | Some p -> let sign,far = p in descends r sign low0 high0 far
           | None -> false)))

(** val spread_times :
    int -> Number.t list -> Number.t list -> Number.t list **)

let rec spread_times step0 symbol0 = function
| [] -> []
| c::rest ->
  (match rest with
   | [] -> map (Number.mul c) symbol0
   | _::_ ->
     addmul c symbol0
       (app (repeat Number.zero step0) (spread_times step0 symbol0 rest)))

(** val then_mask : masks -> scheme -> (Number.t*Number.t list) -> scheme **)

let then_mask m a p =
  { arity = (mul m.masks_arity a.arity); first =
    (Number.add (fst p)
      (Number.mul (Number.of_natural m.masks_arity) a.first)); coefficients =
    (spread_times m.masks_arity (snd p) a.coefficients); common =
    (Number.mul m.masks_common a.common) }

(** val period_scheme : masks -> int -> int list -> scheme **)

let period_scheme m i others0 =
  fold_left (fun a j -> then_mask m a (nth j m.each no_mask)) others0
    (scheme_of m (nth i m.each no_mask))

(** val keeps_constants : masks -> bool **)

let keeps_constants m =
  (&&)
    ((&&) (Nat.leb (Stdlib.succ (Stdlib.succ 0)) m.masks_arity)
      (Number.less Number.zero m.masks_common))
    (forallb (fun p ->
      forallb (fun r ->
        Number.equal (class_sum m.masks_arity (snd p) r) m.masks_common)
        (seq 0 m.masks_arity)) m.each)

(** val in_period : masks -> int -> int list -> bool **)

let in_period m i others0 =
  (&&) (keeps_constants m)
    (forallb (fun j -> Nat.ltb j (length m.each)) (i::others0))

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

(** val block :
    int -> Number.t -> Number.t list -> Number.t -> Number.t list **)

let block r lo u i =
  if Number.less i lo
  then []
  else skipn (mul (Z.to_nat (Number.sub i lo)) r) u

(** val mix_rows :
    zmat list -> Number.t -> (Number.t -> Number.t list) -> int -> Number.t **)

let rec mix_rows ms k u c =
  match ms with
  | [] -> Number.zero
  | m::rest ->
    Number.add (dot (nth c m []) (u k))
      (mix_rows rest (Number.add k Number.one) u c)

(** val move :
    int -> int -> Number.t -> int -> Number.t -> zmat list -> int -> Number.t
    list -> Number.t list **)

let move a r lo len first0 matrices0 t0 u =
  flat_map (fun j ->
    map
      (mix_rows matrices0 first0 (fun k ->
        block r lo u
          (Number.sub
            (Number.add
              (Number.mul (Number.of_natural a)
                (Number.add lo (Number.of_natural j))) (Number.of_natural t0))
            k))) (seq 0 r)) (seq 0 len)

(** val zero_list : Number.t list -> bool **)

let zero_list l =
  forallb (Number.equal Number.zero) l

(** val step_difference : int -> Number.t list -> Number.t list **)

let step_difference r u =
  addmul (Number.opposite Number.one) (app (repeat Number.zero r) u) u

(** val combine_lists :
    Number.t list -> Number.t list list -> Number.t list **)

let rec combine_lists y b =
  match y with
  | [] -> []
  | c::y' ->
    (match b with
     | [] -> []
     | x::b' -> addmul c x (combine_lists y' b'))

(** val in_space :
    Number.t list list -> int list -> Number.t -> Number.t list -> bool **)

let in_space b places0 place_value0 u =
  zero_list
    (addmul (Number.opposite place_value0) u
      (combine_lists (map (fun p -> nth p u Number.zero) places0) b))

(** val enters :
    int -> int -> Number.t -> int -> Number.t -> zmat list -> Number.t list
    list -> int list -> Number.t -> int -> Number.t list -> bool **)

let rec enters a r lo len first0 matrices0 b places0 place_value0 n u =
  (||) (in_space b places0 place_value0 u)
    ((fun zero next n -> if n = 0 then zero () else next (n - 1))
       (fun _ -> false)
       (fun m ->
       forallb (fun t0 ->
         enters a r lo len first0 matrices0 b places0 place_value0 m
           (move a r lo len first0 matrices0 t0 u)) (seq 0 a))
       n)

(** val vector_family : vector_mask -> vector_certificate -> family **)

let vector_family a c =
  { size = (length c.spanning); denominator =
    (Number.mul a.vector_common c.place_value); matrices = c.restricted }

(** val checks_space : vector_mask -> vector_certificate -> bool **)

let checks_space a c =
  let move0 =
    move a.vector_arity a.functions c.window_first c.window a.vector_first
      a.of_points
  in
  (&&)
    ((&&) (Number.less Number.zero c.place_value)
      (Nat.eqb (length c.restricted) a.vector_arity))
    (forallb (fun t0 ->
      forallb (fun k ->
        zero_list
          (addmul (Number.opposite c.place_value)
            (move0 t0 (nth k c.spanning []))
            (combine_lists
              (map (fun row0 -> nth k row0 Number.zero)
                (nth t0 c.restricted [])) c.spanning)))
        (seq 0 (length c.spanning))) (seq 0 a.vector_arity))

(** val differences_of :
    vector_mask -> vector_certificate -> Number.t list **)

let differences_of a c =
  iterate c.difference_order (step_difference a.functions) c.fixed

(** val checks_start : vector_mask -> vector_certificate -> bool **)

let checks_start a c =
  let size0 = mul c.window a.functions in
  (&&)
    ((&&) (forallb (fun b -> Nat.leb (length b) size0) (c.fixed::c.spanning))
      (zero_list (skipn size0 (differences_of a c))))
    (enters a.vector_arity a.functions c.window_first c.window a.vector_first
      a.of_points c.spanning c.places c.place_value c.entering
      (firstn size0 (differences_of a c)))

(** val unfixed :
    vector_mask -> vector_certificate -> Number.t list -> Number.t list **)

let unfixed a c u =
  addmul (Number.opposite a.vector_common) u
    (move a.vector_arity a.functions c.window_first c.window a.vector_first
      a.of_points 0 u)

(** val checks_kernel : vector_mask -> vector_certificate -> bool **)

let checks_kernel a c =
  let n = mul c.inner a.functions in
  let base0 =
    mul (Z.to_nat (Number.sub c.inner_first c.window_first)) a.functions
  in
  let value = fun q0 -> nth (add base0 q0) c.fixed Number.zero in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&) (Number.less_equal c.window_first c.inner_first)
                (Number.less_equal
                  (Number.mul (Number.sub c.inner_first Number.one)
                    (Number.sub (Number.of_natural a.vector_arity) Number.one))
                  a.vector_first))
              (Number.less_equal
                (Number.add a.vector_first
                  (Number.of_natural
                    (sub (length a.of_points) (Stdlib.succ 0))))
                (Number.mul
                  (Number.add c.inner_first (Number.of_natural c.inner))
                  (Number.sub (Number.of_natural a.vector_arity) Number.one))))
            (Number.less_equal
              (Number.add c.inner_first (Number.of_natural c.inner))
              (Number.add c.window_first (Number.of_natural c.window))))
          (Nat.ltb c.nonzero n))
        (negb (Number.equal (value c.nonzero) Number.zero)))
      (negb (Number.equal c.kernel_scale Number.zero)))
    (forallb (fun q0 ->
      let column = unfixed a c (unit_at Number.one (add base0 q0)) in
      forallb (fun i ->
        Number.equal
          (dot (firstn (mul c.window a.functions) (nth i c.kernel [])) column)
          (Number.mul c.kernel_scale
            (Number.sub
              (if Nat.eqb i q0 then value c.nonzero else Number.zero)
              (if Nat.eqb q0 c.nonzero then value i else Number.zero))))
        (seq 0 n)) (seq 0 n))

(** val vector_space : vector_mask -> vector_certificate -> bool **)

let vector_space a c =
  let a0 = Number.of_natural a.vector_arity in
  let high0 =
    Number.sub (Number.add c.window_first (Number.of_natural c.window))
      Number.one
  in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&)
                ((&&)
                  ((&&)
                    ((&&)
                      (Nat.leb (Stdlib.succ (Stdlib.succ 0)) a.vector_arity)
                      (Number.less Number.zero a.vector_common))
                    (Nat.leb (Stdlib.succ 0) (length a.of_points)))
                  (Nat.leb (Stdlib.succ 0) a.functions))
                (forallb (square a.functions) a.of_points))
              (Number.less_equal
                (Number.mul (Number.sub a0 Number.one) c.window_first)
                a.vector_first))
            (Number.less_equal
              (Number.add a.vector_first
                (Number.of_natural (sub (length a.of_points) (Stdlib.succ 0))))
              (Number.mul (Number.sub a0 Number.one) high0)))
          (zero_list (unfixed a c c.fixed))) (checks_space a c))
      (checks_start a c)) (checks_kernel a c)

(** val vector_power : vector_mask -> q -> int -> q -> bool **)

let vector_power a l order0 bound0 =
  below_power { arity = a.vector_arity; first = Number.zero; coefficients =
    []; common = Number.one } l order0 { qnum =
    (Number.mul
      (Number.power (Number.of_natural a.vector_arity)
        (Number.of_natural order0)) bound0.qnum); qden = bound0.qden }

(** val vector_reduces : vector_mask -> q -> vector_certificate -> bool **)

let vector_reduces a l c =
  (&&) (vector_space a c) (vector_power a l c.difference_order c.space_bound)

(** val check_vectors : vector_mask -> q -> vector_certificate -> bool **)

let check_vectors a l c =
  (&&) (vector_reduces a l c)
    (check_radius { matrices_of = (vector_family a c); lower = None; upper =
      (Some c.space_bound) } c.space_radius)

(** val start_differences :
    vector_mask -> vector_certificate -> Number.t list **)

let start_differences a c =
  firstn (mul c.window a.functions) (differences_of a c)

type above_certificate = { space_proof : vector_certificate;
                           image_words : int list list;
                           combinations : Number.t list list;
                           combination_scale : Number.t; space_least : 
                           q }

(** val image_by :
    vector_mask -> vector_certificate -> int list -> Number.t list **)

let image_by a c w =
  fold_right
    (move a.vector_arity a.functions c.window_first c.window a.vector_first
      a.of_points) (start_differences a c) w

(** val checks_images : vector_mask -> above_certificate -> bool **)

let checks_images a d =
  let c = d.space_proof in
  let images0 = map (image_by a c) d.image_words in
  (&&)
    ((&&) (Number.less Number.zero d.combination_scale)
      (forallb (forallb (fun t0 -> Nat.ltb t0 a.vector_arity)) d.image_words))
    (forallb (fun k ->
      zero_list
        (addmul (Number.opposite d.combination_scale) (nth k c.spanning [])
          (combine_lists (nth k d.combinations []) images0)))
      (seq 0 (length c.spanning)))

(** val checks_places : vector_mask -> vector_certificate -> bool **)

let checks_places _ c =
  forallb (fun l ->
    forallb (fun k ->
      Number.equal (nth (nth l c.places 0) (nth k c.spanning []) Number.zero)
        (if_equal k l c.place_value)) (seq 0 (length c.spanning)))
    (seq 0 (length c.spanning))

(** val above_powers : int -> q -> int -> q -> bool **)

let above_powers arity0 u order0 g =
  (&&)
    ((&&) (Number.less_equal Number.zero u.qnum)
      (Number.less_equal (Number.mul unity g.qden)
        (Number.mul g.qnum
          (power_below (Number.of_natural arity0) order0 u.qnum u.qden))))
    (Number.less g.qden
      (Number.mul g.qnum
        (Number.power (Number.of_natural arity0) (Number.of_natural order0))))

(** val check_vectors_between :
    vector_mask -> q -> q -> above_certificate -> bool **)

let check_vectors_between a l u d =
  let c = d.space_proof in
  (&&)
    ((&&)
      ((&&)
        ((&&) ((&&) (vector_space a c) (checks_images a d))
          (checks_places a c))
        (vector_power a l c.difference_order c.space_bound))
      (above_powers a.vector_arity u c.difference_order d.space_least))
    (check_radius { matrices_of = (vector_family a c); lower = (Some
      d.space_least); upper = (Some c.space_bound) } c.space_radius)

(** val number_between : int -> int -> place -> bool **)

let number_between arity0 order0 h =
  (&&) (Number.less h.high h.bottom)
    (Number.less h.bottom
      (Number.mul h.low
        (Number.power (Number.of_natural arity0) (Number.of_natural order0))))

(** val exponent_within :
    vector_mask -> int -> q option -> q option -> place -> bool **)

let exponent_within a order0 lower0 upper0 h =
  let q0 = Z.to_pos h.bottom in
  (&&)
    (match lower0 with
     | Some l ->
       (||) (Number.less_equal l.qnum Number.zero)
         (vector_power a l order0 { qnum = h.high; qden = q0 })
     | None -> true)
    (match upper0 with
     | Some u ->
       above_powers a.vector_arity u order0 { qnum = h.low; qden = q0 }
     | None -> true)

(** val check_exact_vectors :
    vector_mask -> exact_number -> q option -> q option -> above_certificate
    -> exact_certificate -> bool **)

let check_exact_vectors a e lower0 upper0 d x =
  let c = d.space_proof in
  let m = c.difference_order in
  let h = x.number_place in
  (&&)
    ((&&)
      ((&&)
        ((&&) ((&&) (vector_space a c) (checks_images a d))
          (checks_places a c)) (number_between a.vector_arity m h))
      (check_number_and_blocks (vector_family a c) e x))
    (exponent_within a m lower0 upper0 h)

type hidden = { unseen : int; observing : basis; unseen_bound : q;
                unseen_radius : certificate }

(** val rebased : vector_mask -> vector_certificate -> hidden -> family **)

let rebased a c p =
  in_basis (vector_family a c) p.observing

(** val seen_family :
    vector_mask -> vector_certificate -> hidden -> family **)

let seen_family a c p =
  other_blocks p.unseen (rebased a c p)

(** val rebased_vector :
    vector_certificate -> hidden -> int -> Number.t list **)

let rebased_vector c p i =
  combine_lists
    (map (fun row0 -> nth i row0 Number.zero) p.observing.basis_rows)
    c.spanning

(** val component_zero : int -> int -> int -> Number.t list -> bool **)

let rec component_zero r k q0 = function
| [] -> true
| x::l' ->
  (&&) ((||) (negb (Nat.eqb q0 k)) (Number.equal x Number.zero))
    (component_zero r k
      (if Nat.eqb (Stdlib.succ q0) r then 0 else Stdlib.succ q0) l')

(** val component_space :
    vector_mask -> int -> vector_certificate -> hidden -> bool **)

let component_space a k c p =
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&) ((&&) (vector_space a c) (Nat.ltb k a.functions))
            (well_formed (vector_family a c)))
          (basis_valid (length c.spanning) p.observing))
        (triangular p.unseen (rebased a c p)))
      (forallb (fun i ->
        component_zero a.functions k 0 (rebased_vector c p i))
        (seq 0 p.unseen)))
    ((||) (Nat.eqb p.unseen 0)
      ((&&) (Number.less p.unseen_bound.qnum p.unseen_bound.qden)
        (check_radius { matrices_of = (first_block p.unseen (rebased a c p));
          lower = None; upper = (Some p.unseen_bound) } p.unseen_radius)))

type observation = { seen_at : (int list*int) list;
                     seen_rows : Number.t list list; seen_scale : Number.t }

(** val seen_vectors : vector_certificate -> hidden -> Number.t list list **)

let seen_vectors c p =
  map (fun i -> rebased_vector c p (add p.unseen i))
    (seq 0 (sub (length c.spanning) p.unseen))

(** val seen_values :
    vector_mask -> int -> Number.t list list -> int -> Number.t list **)

let seen_values a k us x =
  map (fun u -> nth (add (mul x a.functions) k) u Number.zero) us

(** val observes :
    vector_mask -> int -> vector_certificate -> hidden -> observation -> bool **)

let observes a k c p o =
  let turned = (transpose (seen_family a c p)).matrices in
  let us = seen_vectors c p in
  let rows =
    map (fun at_ ->
      zrun turned (rev (fst at_)) (seen_values a k us (snd at_))) o.seen_at
  in
  (&&)
    ((&&) (negb (Number.equal o.seen_scale Number.zero))
      (forallb (fun at_ ->
        forallb (fun t0 -> Nat.ltb t0 a.vector_arity) (fst at_)) o.seen_at))
    (forallb (fun l ->
      zero_list
        (addmul (Number.opposite Number.one) (unit_at o.seen_scale l)
          (combine_lists (nth l o.seen_rows []) rows)))
      (seq 0 (sub (length c.spanning) p.unseen)))

(** val check_component :
    vector_mask -> int -> q -> vector_certificate -> hidden -> bool **)

let check_component a k l c p =
  (&&)
    ((&&) (component_space a k c p)
      (vector_power a l c.difference_order c.space_bound))
    (check_radius { matrices_of = (seen_family a c p); lower = None; upper =
      (Some c.space_bound) } c.space_radius)

(** val check_component_between :
    vector_mask -> int -> q -> q -> above_certificate -> hidden ->
    observation -> bool **)

let check_component_between a k l u d p o =
  let c = d.space_proof in
  (&&)
    ((&&)
      ((&&)
        ((&&) ((&&) (component_space a k c p) (checks_images a d))
          (observes a k c p o))
        (vector_power a l c.difference_order c.space_bound))
      (above_powers a.vector_arity u c.difference_order d.space_least))
    (check_radius { matrices_of = (seen_family a c p); lower = (Some
      d.space_least); upper = (Some c.space_bound) } c.space_radius)

(** val check_exact_component :
    vector_mask -> int -> exact_number -> q option -> q option ->
    above_certificate -> hidden -> observation -> exact_certificate -> bool **)

let check_exact_component a k e lower0 upper0 d p o x =
  let c = d.space_proof in
  let m = c.difference_order in
  let h = x.number_place in
  (&&)
    ((&&)
      ((&&)
        ((&&) ((&&) (component_space a k c p) (checks_images a d))
          (observes a k c p o)) (number_between a.vector_arity m h))
      (check_number_and_blocks (seen_family a c p) e x))
    (exponent_within a m lower0 upper0 h)

type vector_masks = { list_arity : int; list_functions : int;
                      list_common : Number.t;
                      each_vector : (Number.t*zmat list) list }

(** val vector_number : vector_masks -> int -> vector_mask **)

let vector_number m i =
  { vector_arity = m.list_arity; functions = m.list_functions; vector_first =
    (fst (nth i m.each_vector (Number.zero,[]))); of_points =
    (snd (nth i m.each_vector (Number.zero,[]))); vector_common =
    m.list_common }

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

(** val space_of : list_certificate -> int -> vector_certificate **)

let space_of c i =
  { window_first = c.list_first; window = c.list_window; fixed = [];
    difference_order = c.list_order; spanning = c.list_spanning; places =
    c.list_places; place_value = c.list_place_value; restricted =
    (nth i c.list_restricted []); entering = c.list_entering; inner_first =
    Number.zero; inner = 0; nonzero = 0; kernel = []; kernel_scale =
    Number.zero; space_bound = c.list_bound; space_radius = c.list_radius }

(** val lists_family :
    vector_masks -> sequences -> list_certificate -> family **)

let lists_family m s c =
  along s (length c.list_spanning)
    (Number.mul m.list_common c.list_place_value)
    (map
      (map
        (map
          (map
            (Number.mul
              (Number.power (Number.of_natural m.list_arity)
                (Number.of_natural c.list_order)))))) c.list_restricted)

(** val constants_total :
    int -> Number.t -> zmat list -> Number.t list -> Number.t -> int ->
    Number.t **)

let rec constants_total a k ms y t0 d =
  match ms with
  | [] -> Number.zero
  | m::rest ->
    Number.add
      (if Number.equal
            (Number.mul (Number.of_natural a)
              (Number.divide (Number.sub t0 k) (Number.of_natural a)))
            (Number.sub t0 k)
       then dot (map (fun row0 -> nth d row0 Number.zero) m) y
       else Number.zero)
      (constants_total a (Number.add k Number.one) rest y t0 d)

(** val arrives :
    (Number.t list -> Number.t list) list -> (Number.t list -> bool) -> int
    -> Number.t list -> bool **)

let rec arrives moves inside n u =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> inside u)
    (fun k -> forallb (fun move0 -> arrives moves inside k (move0 u)) moves)
    n

(** val list_moves :
    vector_masks -> list_certificate -> (Number.t list -> Number.t list) list **)

let list_moves m c =
  let a = m.list_arity in
  let r = m.list_functions in
  let lo = c.list_first in
  let len = c.list_window in
  flat_map (fun p -> map (move a r lo len (fst p) (snd p)) (seq 0 a))
    m.each_vector

(** val comes : vector_masks -> list_certificate -> Number.t list -> bool **)

let comes m c =
  let r = m.list_functions in
  let len = c.list_window in
  let size0 = mul len r in
  (fun u ->
  (&&) (zero_list (skipn size0 u))
    (arrives (list_moves m c) (in_space c.wide c.wide_places c.wide_pivot)
      c.list_entering (firstn size0 u)))

(** val list_shifted :
    vector_masks -> list_certificate -> Number.t list list **)

let list_shifted m c =
  let r = m.list_functions in
  app (map (skipn r) c.list_spanning)
    (app c.list_spanning (map (app (repeat Number.zero r)) c.list_spanning))

(** val list_change :
    vector_masks -> list_certificate -> (Number.t*zmat list) -> Number.t list **)

let list_change m c =
  let a = m.list_arity in
  let r = m.list_functions in
  let lo = c.list_first in
  let len = c.list_window in
  (fun p ->
  addmul (Number.opposite m.list_common) c.functional
    (move a r lo len (fst p) (snd p) 0 c.functional))

(** val list_differences :
    vector_masks -> list_certificate -> Number.t list **)

let list_differences m c =
  let r = m.list_functions in
  iterate c.list_order (step_difference r) c.functional

(** val list_component :
    vector_masks -> list_certificate -> int -> Number.t list **)

let list_component m c =
  let r = m.list_functions in
  let lo = c.list_first in
  (fun d ->
  addmul c.list_scale
    (unit_at Number.one (add (mul (Z.to_nat (Number.opposite lo)) r) d))
    (combine_lists (map Number.opposite (nth d c.list_weights []))
      (map (fun j -> app (repeat Number.zero (mul j r)) c.functional)
        (seq 0 (Stdlib.succ c.list_order)))))

(** val list_window_fits : vector_masks -> list_certificate -> bool **)

let list_window_fits m c =
  let a = m.list_arity in
  let r = m.list_functions in
  let lo = c.list_first in
  let len = c.list_window in
  let size0 = mul len r in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&)
                ((&&) (Nat.leb (Stdlib.succ (Stdlib.succ 0)) a)
                  (Number.less Number.zero m.list_common))
                (Nat.leb (Stdlib.succ 0) r))
              (Number.less_equal lo Number.zero))
            (Number.less Number.zero (Number.add lo (Number.of_natural len))))
          (Nat.leb c.list_order len))
        (forallb (fun b ->
          (&&) (Nat.leb (add r (length b)) size0) (zero_list (firstn r b)))
          c.list_spanning))
      (Nat.leb (length c.functional) (mul (sub len c.list_order) r)))
    (forallb (fun p ->
      (&&)
        ((&&)
          ((&&) (Nat.leb (Stdlib.succ 0) (length (snd p)))
            (forallb (square r) (snd p)))
          (Number.less_equal
            (Number.mul (Number.sub (Number.of_natural a) Number.one) lo)
            (fst p)))
        (Number.less_equal
          (Number.add (fst p)
            (Number.of_natural (sub (length (snd p)) (Stdlib.succ 0))))
          (Number.mul (Number.sub (Number.of_natural a) Number.one)
            (Number.sub (Number.add lo (Number.of_natural len)) Number.one))))
      m.each_vector)

(** val list_spaces : vector_masks -> list_certificate -> bool **)

let list_spaces m c =
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&) (Nat.eqb (length c.list_restricted) (length m.each_vector))
            (forallb (forallb (square (length c.list_spanning)))
              c.list_restricted))
          (forallb (fun i -> checks_space (vector_number m i) (space_of c i))
            (seq 0 (length m.each_vector))))
        (negb (Number.equal c.wide_pivot Number.zero)))
      (negb (Number.equal c.wide_scale Number.zero)))
    (forallb (fun k ->
      zero_list
        (addmul (Number.opposite c.wide_scale) (nth k c.wide [])
          (combine_lists (nth k c.wide_rows []) (list_shifted m c))))
      (seq 0 (length c.wide)))

(** val list_constants : vector_masks -> list_certificate -> bool **)

let list_constants m c =
  let a = m.list_arity in
  let r = m.list_functions in
  (&&)
    ((&&)
      (existsb (fun d ->
        negb (Number.equal (nth d c.constants Number.zero) Number.zero))
        (seq 0 r)) (Nat.eqb (length c.constants) r))
    (forallb (fun p ->
      forallb (fun t0 ->
        forallb (fun d ->
          Number.equal
            (constants_total a (fst p) (snd p) c.constants
              (Number.of_natural t0) d)
            (Number.mul m.list_common (nth d c.constants Number.zero)))
          (seq 0 r)) (seq 0 a)) m.each_vector)

(** val list_comes : vector_masks -> list_certificate -> bool **)

let list_comes m c =
  let r = m.list_functions in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          (forallb (fun p -> comes m c (list_change m c p)) m.each_vector)
          (comes m c (list_differences m c)))
        (forallb (fun d -> comes m c (list_component m c d)) (seq 0 r)))
      (negb (Number.equal c.list_scale Number.zero)))
    (existsb (fun d ->
      negb
        (Number.equal
          (fold_right Number.add Number.zero
            (firstn (Stdlib.succ c.list_order) (nth d c.list_weights [])))
          Number.zero)) (seq 0 r))

(** val lists_space :
    vector_masks -> sequences -> list_certificate -> bool **)

let lists_space m s c =
  (&&)
    ((&&)
      ((&&) ((&&) (list_window_fits m c) (list_spaces m c))
        (list_constants m c)) (list_comes m c))
    (known (length m.each_vector) s)

(** val check_vector_lists :
    vector_masks -> sequences -> q -> list_certificate -> bool **)

let check_vector_lists m s l c =
  (&&)
    ((&&) (lists_space m s c)
      (below_power { arity = m.list_arity; first = Number.zero;
        coefficients = []; common = Number.one } l c.list_order c.list_bound))
    (check_radius { matrices_of = (lists_family m s c); lower = None; upper =
      (Some c.list_bound) } c.list_radius)

(** val check_vector_scheme : vector_mask -> q -> list_certificate -> bool **)

let check_vector_scheme a l c =
  let m = { list_arity = a.vector_arity; list_functions = a.functions;
    list_common = a.vector_common; each_vector =
    ((a.vector_first,a.of_points)::[]) }
  in
  (&&)
    ((&&) (lists_space m Any c)
      (below_power_strictly m.list_arity l c.list_order c.list_bound))
    (check_radius { matrices_of = (lists_family m Any c); lower = None;
      upper = (Some c.list_bound) } c.list_radius)

(** val times_differences : int -> Number.t list -> Number.t list **)

let rec times_differences s l =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> l)
    (fun s' ->
    times_differences s'
      (addmul (Number.opposite Number.one) (Number.zero::l) l))
    s

(** val derivative_factors :
    list_certificate -> int -> Number.t list list -> bool **)

let derivative_factors c r factors =
  forallb (fun s ->
    let q0 = nth s factors [] in
    let w = nth s c.list_weights [] in
    (&&)
      ((&&)
        ((&&)
          (zero_list
            (addmul (Number.opposite Number.one) (times_differences s q0) w))
          (Nat.leb (length w) (Stdlib.succ c.list_order)))
        (Nat.leb (length q0) (Stdlib.succ c.list_order)))
      (Number.equal (fold_right Number.add Number.zero q0) c.list_scale))
    (seq 0 r)

(** val check_hermite_lists :
    vector_masks -> sequences -> int -> list_certificate -> Number.t list
    list -> bool **)

let check_hermite_lists m s k c factors =
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&) (lists_space m s c)
            (Nat.leb m.list_functions (Stdlib.succ k)))
          (below_power_strictly m.list_arity { qnum = (Number.of_natural k);
            qden = Number.one } c.list_order c.list_bound))
        (derivative_factors c m.list_functions factors))
      (negb (Number.equal (nth 0 c.constants Number.zero) Number.zero)))
    (check_radius { matrices_of = (lists_family m s c); lower = None; upper =
      (Some c.list_bound) } c.list_radius)
