
(** val negb : bool -> bool **)

let negb = function
| true -> false
| false -> true

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

  (** val to_nat : Number.t -> int **)

  let to_nat z0 =
    Number.case_integer
      (fun _ -> 0)
      (fun p -> Coq_Pos.to_nat p)
      (fun _ -> 0)
      z0
 end

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

(** val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list **)

let rec map f = function
| [] -> []
| a::t0 -> (f a)::(map f t0)

(** val fold_right : ('a2 -> 'a1 -> 'a1) -> 'a1 -> 'a2 list -> 'a1 **)

let rec fold_right f a0 = function
| [] -> a0
| b::t0 -> f b (fold_right f a0 t0)

(** val forallb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec forallb f = function
| [] -> true
| a::l0 -> (&&) (f a) (forallb f l0)

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

type family = { size : int; denominator : Number.t; matrices : zmat list }

(** val count : family -> int **)

let count f =
  length f.matrices

(** val well_formed : family -> bool **)

let well_formed f =
  (&&) (Number.less Number.zero f.denominator)
    (forallb (square f.size) f.matrices)

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
 end

type point = zvec*zvec

type term = Number.t*(Number.t*Number.t)

type points = point PositiveMap.t

(** val number : Number.t -> point list -> points **)

let rec number i = function
| [] -> PositiveMap.empty
| p::ps' -> PositiveMap.add i p (number (Number.successor i) ps')

(** val zmodulus : Number.t -> Number.t -> Number.t **)

let zmodulus a b =
  if Number.equal b Number.zero
  then Number.abs a
  else Number.square_root_up (Number.add (Number.mul a a) (Number.mul b b))

(** val combine : points -> term list -> (Number.t*point) option **)

let rec combine ps = function
| [] -> Some (Number.zero,([],[]))
| t0::ts' ->
  let i,p = t0 in
  let a,b = p in
  (match PositiveMap.find i ps with
   | Some p0 ->
     let x,y = p0 in
     (match combine ps ts' with
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

let line nonnegative ps scale0 divisor target ts =
  match combine ps ts with
  | Some p ->
    let w,p0 = p in
    let x,y = p0 in
    let u = addmul (Number.opposite divisor) x (addmul scale0 (fst target) [])
    in
    let v = addmul (Number.opposite divisor) y (addmul scale0 (snd target) [])
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

let rec images nonnegative ps scale0 one divisor s r u p ms lines =
  match ms with
  | [] -> true
  | m::ms' ->
    (match lines with
     | [] -> false
     | ts::lines' ->
       (match line nonnegative ps scale0 divisor
                ((mv m (fst p)),(mv m (snd p))) ts with
        | Some p0 ->
          let w,t0 = p0 in
          (&&)
            (Number.less_equal
              (Number.mul u.qden
                (Number.add
                  (Number.mul (Number.mul w divisor) (Number.sub one r))
                  (Number.mul t0 s)))
              (Number.mul (Number.mul (Number.mul u.qnum scale0) divisor)
                (Number.sub one r)))
            (images nonnegative ps scale0 one divisor s r u p ms' lines')
        | None -> false))

(** val all_images :
    bool -> points -> Number.t -> Number.t -> Number.t -> Number.t ->
    Number.t -> q -> zmat list -> point list -> term list list list -> bool **)

let rec all_images nonnegative ps scale0 one divisor s r u ms all lines =
  match all with
  | [] -> true
  | p::all' ->
    (match lines with
     | [] -> false
     | l::lines' ->
       (&&) (images nonnegative ps scale0 one divisor s r u p ms l)
         (all_images nonnegative ps scale0 one divisor s r u ms all' lines'))

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

let polytope f u nonnegative scale0 one all unit_lines image_lines =
  let ps = number Number.one all in
  (&&)
    ((&&)
      ((&&)
        ((&&) (Number.less Number.zero scale0)
          (Number.less_equal Number.zero u.qnum))
        (if nonnegative then all_nonnegative f all else true))
      (Nat.eqb (length unit_lines) f.size))
    (match units nonnegative ps one 0 unit_lines with
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
  let n = f.size in
  let transposes = map (columns n) f.matrices in
  (fun rows t0 -> map (mv (nth t0 transposes [])) rows)

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
    (let rec each k = function
     | [] -> true
     | c::l' ->
       (&&) (check_tree f u p (app w (k::[])) (extended f rows k) c)
         (each (Stdlib.succ k) l')
     in each 0 children)

(** val quadratic :
    family -> q -> zmat -> square_root -> word_tree -> bool **)

let quadratic f u p =
  let n = f.size in
  (fun definite words ->
  (&&)
    ((&&) ((&&) (Number.less_equal Number.zero u.qnum) (square n p))
      (positive_form n Number.one (entry p) definite))
    (check_tree f u p [] (table n (fun i j -> if_equal i j Number.one)) words))

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

(** val check_section : family -> q -> section -> bool **)

let check_section f u = function
| Norm level0 -> norm_section f u level0
| Polytope (nonnegative, transposed, scale0, one, all, ul, il) ->
  polytope (if transposed then transpose f else f) u nonnegative scale0 one
    all ul il
| Quadratic (form, definite, words) -> quadratic f u form definite words

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

(** val check_upper : family -> q -> (int*section) list -> bool **)

let rec check_upper f u = function
| [] -> false
| p::blocks' ->
  let d,s = p in
  (match blocks' with
   | [] -> (&&) (Nat.eqb d f.size) (check_section f u s)
   | _::_ ->
     (&&) ((&&) (triangular d f) (check_section (first_block d f) u s))
       (check_upper (other_blocks d f) u blocks'))

(** val check_lower : family -> q -> int list -> int -> eigen -> bool **)

let rec check_lower f l sizes0 block e =
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
    block

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

(** val same : Number.t list -> Number.t list -> bool **)

let rec same x y =
  match x with
  | [] -> (match y with
           | [] -> true
           | _::_ -> false)
  | a::x' ->
    (match y with
     | [] -> false
     | b::y' -> (&&) (Number.equal a b) (same x' y'))

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

let rec roots_below base k top bottom =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> unity)
    (fun k' ->
    Number.square_root
      (Number.mul unity
        (if Number.less_equal bottom
              (Number.mul (Number.twice Number.one) top)
         then Number.mul base
                (roots_below base k'
                  (Number.sub (Number.mul (Number.twice Number.one) top)
                    bottom) bottom)
         else roots_below base k' (Number.mul (Number.twice Number.one) top)
                bottom)))
    k

(** val power_below : Number.t -> int -> Number.t -> Number.t -> Number.t **)

let rec power_below base whole top bottom =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> roots_below base digits top bottom)
    (fun k ->
    if Number.less_equal bottom top
    then Number.mul base (power_below base k (Number.sub top bottom) bottom)
    else roots_below base digits top bottom)
    whole

type exponent_certificate = { order : int; bound : q; of_radius : certificate }

(** val below_power : scheme -> q -> int -> q -> bool **)

let below_power a l order0 u =
  let bottom = l.qden in
  let top = Number.sub (Number.mul (Number.of_natural order0) bottom) l.qnum
  in
  (&&)
    ((&&) (Number.less Number.zero l.qnum)
      (Number.less_equal Number.zero top))
    (Number.less_equal (Number.mul u.qnum unity)
      (Number.mul (power_below (Number.of_natural a.arity) order0 top bottom)
        u.qden))

(** val divides : scheme -> int -> bool **)

let divides a order0 =
  (&&)
    (same (iterate order0 (times_sigma a.arity) (quotient a order0))
      a.coefficients)
    (Nat.leb
      (add (sub (length (quotient a order0)) (Stdlib.succ 0))
        (mul order0 (sub a.arity (Stdlib.succ 0))))
      (sub (length a.coefficients) (Stdlib.succ 0)))

(** val reduces : scheme -> q -> int -> q -> bool **)

let reduces a l order0 u =
  (&&)
    ((&&)
      ((&&)
        ((&&) (Nat.leb (Stdlib.succ (Stdlib.succ 0)) a.arity)
          (Number.less Number.zero a.common)) (divides a order0))
      (Number.equal
        (fold_right Number.add Number.zero (difference_symbol a order0))
        (Number.mul (Number.of_natural a.arity) a.common)))
    (below_power a l order0 u)

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

let rec times_up step c u =
  match c with
  | [] -> []
  | x::c' -> addmul x u (app (repeat Number.zero step) (times_up step c' u))

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

let rec correlate fuel step omega u =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ -> [])
    (fun f -> (dot omega u)::(correlate f step omega (skipn step u)))
    fuel

(** val combined : scheme -> stability -> Number.t list **)

let combined a c =
  let u = fine a.arity a.coefficients c.level c.values in
  let step = Nat.pow a.arity c.level in
  let padded =
    app
      (repeat Number.zero
        (Z.to_nat
          (Number.sub (fine_start a.arity a.first c.level c.start)
            (Number.mul (Number.of_natural step) c.row)))) u
  in
  correlate (length padded) step c.weights padded

(** val check_stable : scheme -> stability -> bool **)

let check_stable a c =
  let w = Number.of_natural (length c.values) in
  let a0 = Number.of_natural a.arity in
  let s = fine_start a.arity a.first c.level c.start in
  let step = Number.of_natural (Nat.pow a.arity c.level) in
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
        (Number.less_equal (Number.mul step c.row) s))
      (Number.less_equal
        (Number.add (Number.of_natural (length c.weights))
          (Number.mul step (Number.sub c.row Number.one))) s))
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

let encloses a l u order0 most least c =
  (&&)
    ((&&) ((&&) (reduces a l order0 most) (above_power a u order0 least))
      (Nat.leb (Stdlib.succ 0) (length a.coefficients))) (check_stable a c)

(** val check_exponent : scheme -> q -> q -> enclosure -> bool **)

let check_exponent a l u cert =
  let low = cert.lower_end in
  (&&) (encloses a l u low.order low.bound cert.radius_least cert.shifts)
    (check_radius { matrices_of = (difference_family a low.order); lower =
      (Some cert.radius_least); upper = (Some low.bound) } low.of_radius)
