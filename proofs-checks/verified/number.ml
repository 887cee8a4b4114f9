(* What the extracted checker takes of zarith: the integers of Coq, its positive numbers among them. *)
type t = Z.t

let zero = Z.zero
let one = Z.one
let add = Z.add
let sub = Z.sub
let mul = Z.mul
let divide x y = if Z.equal y Z.zero then y else Z.fdiv x y
let opposite = Z.neg
let abs = Z.abs
let max = Z.max
let equal = Z.equal
let less_equal = Z.leq
let less = Z.lt
let successor = Z.succ
let twice x = Z.shift_left x 1
let twice_plus_one x = Z.succ (Z.shift_left x 1)
let of_natural = Z.of_int
let power x k = if Z.sign k < 0 then Z.zero else Z.pow x (Z.to_int k)
let square_root x = if Z.sign x < 0 then Z.zero else Z.sqrt x
let square_root_up x = if Z.sign x <= 0 then Z.zero else Z.succ (Z.sqrt (Z.pred x))

let case_positive odd even last p =
  if Z.equal p Z.one then last () else if Z.testbit p 0 then odd (Z.shift_right p 1) else even (Z.shift_right p 1)

let case_integer none above below z =
  let sign = Z.sign z in
  if sign = 0 then none () else if sign > 0 then above z else below (Z.neg z)
