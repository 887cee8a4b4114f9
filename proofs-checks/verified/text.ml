(* Text: numbers, and files line by line; and how much work they make. Nothing here is proved. *)

(* The reason, and the exit code: 1 the certificate does not prove the claim, 64 wrong arguments,
   65 malformed matrices, 66 a missing file. *)
exception Rejected of string * int

let reject why = raise (Rejected (why, 64))
let require condition why = if not condition then reject why
let max_work = 1_000_000_000 (* multiplications: about a minute *)
let spent = ref 0

let spend work =
  spent := !spent + work;
  require (work >= 0 && !spent <= max_work) "more work than this checker allows"

(* So many times *)
let spend_times copies work =
  require (work >= 0 && work <= max_work / copies) "more work than this checker allows";
  spend (copies * work)

(* How much longer it takes to multiply by one of these numbers than by a short one *)
let width bits = 1 + (bits / 640)

let max_bytes = 1 lsl 28
let max_line = 1 lsl 24

let integer text =
  let start = if String.length text > 0 && text.[0] = '-' then 1 else 0 in
  let digits = String.sub text start (String.length text - start) in
  require
    (digits <> "" && String.for_all (fun c -> c >= '0' && c <= '9') digits && (digits.[0] <> '0' || text = "0"))
    "not an integer";
  require (String.length digits <= 5000) "number too long";
  Z.of_string text

let size text low high =
  let value = integer text in
  require
    (Z.leq (Z.of_int low) value && Z.leq value (Z.of_int high))
    (Printf.sprintf "number outside %d..%d" low high);
  Z.to_int value

let rational text =
  match String.split_on_char '/' text with
  | [ top ] -> Q.of_bigint (integer top)
  | [ top; bottom ] ->
      let below = integer bottom in
      require (Z.sign below > 0) "a denominator must be positive";
      Q.make (integer top) below
  | _ -> reject "not a rational"

(* ...TAIL of a mask: /D or nothing, then @first or nothing, as "/D" or "" and the first index *)
let read_tail tail expected =
  let over, first =
    match String.split_on_char '@' tail with
    | [ over ] -> (over, Z.zero)
    | [ over; first ] -> (over, integer first)
    | _ -> reject expected
  in
  require (over = "" || over.[0] = '/') expected;
  (over, first)

(* [c0,c1,...]TAIL: the coefficients, and the tail *)
let read_list text expected =
  let stop = match String.rindex_opt text ']' with Some stop when text.[0] = '[' -> stop | _ -> reject expected in
  let over, first = read_tail (String.sub text (stop + 1) (String.length text - stop - 1)) expected in
  (String.split_on_char ',' (String.sub text 1 (stop - 1)), over, first)

let power base k = Q.make (Z.pow (Q.num base) k) (Z.pow (Q.den base) k)

type reader = { text : string; mutable position : int; mutable line : int; mutable current : string option; mutable taken : bool }

(* Moves on if the line was taken. *)
let at_end r =
  if r.taken then begin
    r.taken <- false;
    r.line <- r.line + 1;
    if r.position >= String.length r.text then r.current <- None
    else
      match String.index_from_opt r.text r.position '\n' with
      | None -> reject "last line without line feed"
      | Some stop ->
          require (stop - r.position <= max_line) "line too long";
          r.current <- Some (String.sub r.text r.position (stop - r.position));
          r.position <- stop + 1
  end;
  r.current = None

let at r head =
  (not (at_end r))
  && match r.current with Some line -> line = head || String.starts_with ~prefix:(head ^ " ") line | None -> false

(* Takes the next line, which must have the head and `low` to `high` fields after it. *)
let take r head low high =
  require (at r head) ("expected '" ^ head ^ "'");
  r.taken <- true;
  let line = Option.get r.current and skip = String.length head in
  let rest = String.sub line skip (String.length line - skip) in
  let fields = List.tl (String.split_on_char ' ' rest) in
  let count = List.length fields in
  require (low <= count && count <= high) "wrong number of fields";
  fields

(* use reader of a file; what is rejected gets the code and the number of the line. *)
let read file code use =
  let text =
    try
      if Sys.is_directory file then raise (Sys_error "");
      let channel = open_in_bin file in
      let length = in_channel_length channel in
      let text = if length > max_bytes then None else Some (really_input_string channel length) in
      close_in channel;
      text
    with Sys_error _ | End_of_file -> raise (Rejected ("cannot read " ^ file, 66))
  in
  let r = { text = Option.value text ~default:""; position = 0; line = 0; current = None; taken = true } in
  let at_line why code = raise (Rejected (Printf.sprintf "%s, line %d" why r.line, code)) in
  try
    require (text <> None) "file too long";
    use r
  with
  | Rejected (why, 64) -> at_line why code
  | Stack_overflow | Out_of_memory -> at_line "too large for this checker" code
