(* Theorem 26 of SPEC.md: a polytope whose vertices are eigenvectors and their images, known up to small errors, attains the
   radius. Checked with integers. *)
Require Import Reals List ZArith QArith FMapPositive Lia Lra Bool.
From Coq Require Import FunctionalExtensionality.
From Subcert Require Import Radius Upper Lower Integers Sections Eigenvalue Complex Number.
Import ListNotations.
Open Scope Z_scope.

(* ---- the checker ------------------------------------------------------------------------------------------------- *)

(* A vector that depends on the zero z: vectors_0 + vectors_1 z + vectors_2 z^2 + ..., or that of the conjugate of z. With
   previous = (k, word, seed) the word leads base number k to z times this one, as the differences of both are multiples of
   the polynomial. *)
Record base := Base { vectors : list point; conjugated : bool; previous : option (nat * (list nat * point)) }.

(* A true point: the base, or the image of an earlier point under a matrix, over the radius. *)
Inductive source := FromBase (k : nat) | FromPoint (i : positive) (t : nat).

(* Why an image lies inside: it is the radius times another point, up to a factor of modulus 1, as both stem from one base
   by words made longer by so many turns; with a cone it lies below that, each coordinate being equal so, or clearly less;
   or it is a combination of points. *)
Inductive image := Link (i : positive) (turns turns' : nat) | Below (i : positive) (turns turns' : nat) | Inside (ts : list term).

Record body := Body {
  cone : bool; bases : list base; given : list (source * (point * list image)); weight_one : Z; unit_one : Z; unit_lines : list (list term);
  first_base : nat; full_turn : nat }.

Record vertex := Vertex { from : nat; path : list nat; shown : point; off : Z; image_list : list image }.

Definition norm_pair (x : point) : Z := norm1 (fst x) + norm1 (snd x).
Definition difference (a b : Z) (x y : point) : point := (addmul a (fst x) (addmul b (fst y) []), addmul a (snd x) (addmul b (snd y) [])).
Definition vanishes : zvec -> bool := forallb (Z.eqb 0).
Definition run_pair (Ms : list zmat) (w : list nat) (x : point) : point := (zrun Ms w (fst x), zrun Ms w (snd x)).

(* q (second - polynomial * seed) = first, coefficient by coefficient *)
Fixpoint closes (q : Z) (p : list Z) (seed : point) (first second : list point) : bool :=
  match p, first, second with
  | [], [], [] => true
  | c :: p', x :: first', y :: second' =>
      vanishes (addmul (- q) (fst y) (addmul (q * c) (fst seed) (fst x))) &&
      vanishes (addmul (- q) (snd y) (addmul (q * c) (snd seed) (snd x))) && closes q p' seed first' second'
  | _, _, _ => false
  end.

(* Rounded up *)
Definition over_up (a s : Z) : Z := - (- a / s).

(* A vector over s, each number rounded down, and a bound of what that changes *)
Definition cut_by (s : Z) (x : zvec) : zvec := map (fun a => a / s) x.
Definition cut_error (n : nat) (s : Z) (x : zvec) : Z := if forallb (fun a => s * (a / s) =? a) x then 0 else Z.of_nat n.

(* The value at (c1 + i c2) / s, known up to rad / s in both parts, and a bound of its error *)
Fixpoint evaluate (n : nat) (s c1 c2 rad : Z) (ys : list point) : point * Z :=
  match ys with
  | [] => (([], []), 0)
  | y :: ys' =>
      match ys' with
      | [] => (y, 0)
      | _ =>
          let '((u, v), e) := evaluate n s c1 c2 rad ys' in
          let re := addmul c1 u (addmul (- c2) v []) in let im := addmul c1 v (addmul c2 u []) in
          ((addmul 1 (fst y) (cut_by s re), addmul 1 (snd y) (cut_by s im)),
           over_up ((Z.abs c1 + Z.abs c2 + 2 * rad) * e + 2 * rad * (norm1 u + norm1 v)) s + (cut_error n s re + cut_error n s im))
      end
  end.

(* The largest sum of moduli in a column *)
Definition column_sums (M : zmat) : zvec := fold_right (fun row sums => addmul 1 (map Z.abs row) sums) [] M.
Definition column_norm (M : zmat) : Z := largest_of (column_sums M).

Section Checker.
Variables (F : family) (p : list Z) (L : nat) (h : place).
Let n := size F.
Let D := denominator F.
Let Ms := matrices F.
Let in_alphabet (w : list nat) : bool := forallb (fun t => Nat.ltb t (count F)) w.

Section Bases.
Variable bs : list base.

Definition base_right (b : base) : bool :=
  match previous b with
  | None => true
  | Some (k, (w, seed)) =>
      match nth_error bs k with
      | None => false
      | Some b' =>
          in_alphabet w && Nat.eqb (length w) L && Bool.eqb (conjugated b) (conjugated b') &&
          closes (D ^ Z.of_nat L) p seed (map (run_pair Ms w) (vectors b') ++ [([], [])]) (([], []) :: vectors b)
      end
  end.

(* The base from which so many words lead to this one, and these words *)
Fixpoint walk (m k : nat) : option (nat * list nat) :=
  match m with
  | O => Some (k, [])
  | S m' =>
      match walk m' k with
      | None => None
      | Some (k', w) =>
          match nth_error bs k' with
          | Some b => match previous b with Some (k'', (w', _)) => Some (k'', w ++ w') | None => None end
          | None => None
          end
      end
  end.

Fixpoint same_word (v w : list nat) : bool :=
  match v, w with [], [] => true | a :: v', b :: w' => Nat.eqb a b && same_word v' w' | _, _ => false end.

Fixpoint agree (sign : Z) (xs ys : list point) : bool :=
  match xs, ys with
  | [], [] => true
  | x :: xs', y :: ys' =>
      vanishes (addmul sign (fst y) (fst x)) && vanishes (addmul sign (snd y) (snd x)) && agree sign xs' ys'
  | _, _ => false
  end.

Definition linked (k : nat) (v : list nat) (turns k' : nat) (w : list nat) (turns' : nat) : bool :=
  match walk turns k, walk turns' k' with
  | Some (j, v'), Some (j', w') =>
      let v := v ++ v' in let w := w ++ w' in
      Nat.eqb (length v) (length w) &&
      ((Nat.eqb j j' && same_word v w) ||
       match nth_error bs j, nth_error bs j' with
       | Some b, Some b' =>
           let xs := map (run_pair Ms v) (vectors b) in let ys := map (run_pair Ms w) (vectors b') in
           Bool.eqb (conjugated b) (conjugated b') && (agree (-1) xs ys || agree 1 xs ys)
       | _, _ => false
       end)
  | _, _ => false
  end.

(* The coefficients of a vector that a word, made longer by so many turns, leads to; the length of the word *)
Definition led (k : nat) (v : list nat) (turns : nat) : option (nat * list zvec) :=
  match walk turns k with
  | None => None
  | Some (j, v') =>
      match nth_error bs j with
      | None => None
      | Some b => let v := v ++ v' in Some (length v, map (fun x => zrun Ms v (fst x)) (vectors b))
      end
  end.

Fixpoint agree_at (i : nat) (xs ys : list zvec) : bool :=
  match xs, ys with
  | [], [] => true
  | x :: xs', y :: ys' => (nth i x 0 =? nth i y 0) && agree_at i xs' ys'
  | _, _ => false
  end.

(* Where the images of two bases by words, made longer by so many turns, are equal *)
Definition equal_at (k : nat) (v : list nat) (turns k' : nat) (w : list nat) (turns' : nat) : nat -> bool :=
  match led k v turns, led k' w turns' with
  | Some (l, xs), Some (l', ys) => if Nat.eqb l l' then fun i => agree_at i xs ys else fun _ => false
  | _, _ => fun _ => false
  end.

(* Image t of x is at most the radius times y, in each coordinate. *)
Definition at_most_point (x : vertex) (t turns : nat) (y : vertex) (turns' : nat) : bool :=
  let M := letter F t in
  let moved := mv M (fst (shown x)) in
  let equal := equal_at (from x) (t :: path x) turns (from y) (path y) turns' in
  let error := column_norm M * off x in
  forallb (fun i => equal i ||
    (bottom h * (nth i moved 0 + error) <=? low h * D * (nth i (fst (shown y)) 0 - off y))) (seq 0 n).

(* The base is real, and has no negative coordinate. *)
Definition base_positive (b : base) : bool :=
  let '((u, _), e) := evaluate n (near_scale h) (near_re h) (if conjugated b then - near_im h else near_im h) (near_radius h) (vectors b) in
  forallb (fun y => vanishes (snd y)) (vectors b) &&
  forallb (fun i => (e <? nth i u 0) || forallb (fun y => nth i (fst y) 0 =? 0) (vectors b)) (seq 0 n).

Definition make (known : PositiveMap.t vertex) (s : source) (v : point) (images : list image) : option vertex :=
  match s with
  | FromBase k =>
      match nth_error bs k with
      | None => None
      | Some b =>
          let '(x, e) := evaluate n (near_scale h) (near_re h) (if conjugated b then - near_im h else near_im h) (near_radius h) (vectors b) in
          Some (Vertex k [] v (e + norm_pair (difference 1 (-1) x v)) images)
      end
  | FromPoint i t =>
      match PositiveMap.find i known with
      | None => None
      | Some parent =>
          let M := letter F t in
          let moved := (mv M (fst (shown parent)), mv M (snd (shown parent))) in
          let whole := bottom h * column_norm M * off parent + norm_pair (difference (bottom h) (- (D * low h)) moved v) +
                       D * (high h - low h) * norm_pair v in
          if Nat.ltb t (count F) then Some (Vertex (from parent) (t :: path parent) v (over_up whole (D * low h)) images) else None
      end
  end.

Fixpoint build (i : positive) (given : list (source * (point * list image))) (known : PositiveMap.t vertex) (all : list vertex)
    : option (PositiveMap.t vertex * list vertex) :=
  match given with
  | [] => Some (known, all)
  | (s, (v, images)) :: rest =>
      match make known s v images with
      | None => None
      | Some x => build (Pos.succ i) rest (PositiveMap.add i x known) (x :: all)
      end
  end.

Section Images.
Variables (cone : bool) (known : PositiveMap.t vertex) (ps : points) (weight one s r eps : Z).

Definition image_right (x : vertex) (t : nat) (i : image) : bool :=
  match i with
  | Link j turns turns' =>
      match PositiveMap.find j known with
      | Some y => linked (from x) (t :: path x) turns (from y) (path y) turns'
      | None => false
      end
  | Below j turns turns' =>
      match PositiveMap.find j known with
      | Some y => cone && at_most_point x t turns y turns'
      | None => false
      end
  | Inside ts =>
      let M := letter F t in
      match line cone ps weight D (mv M (fst (shown x)), mv M (snd (shown x))) ts with
      | None => false
      | Some (w, rest) =>
          let rest := rest + D * w * eps + weight * column_norm M * eps in
          bottom h * (w * D * (one - r) + rest * s) <=? low h * weight * D * (one - r)
      end
  end.

Fixpoint images_right (x : vertex) (t : nat) (left : nat) (l : list image) : bool :=
  match left with
  | O => true
  | S left' => match l with [] => false | i :: l' => image_right x t i && images_right x (S t) left' l' end
  end.
End Images.
End Bases.

(* The radius is that of the claim at most. *)
Definition below (b : body) : bool :=
  (0 <? weight_one b) && Nat.eqb (length (unit_lines b)) n && forallb (base_right (bases b)) (bases b) &&
  (if cone b then all_nonnegative F [] && forallb base_positive (bases b) else true) &&
  match build (bases b) 1 (given b) (PositiveMap.empty _) [] with
  | None => false
  | Some (known, all) =>
      let ps := PositiveMap.mapi (fun _ => shown) known in
      let eps := largest_of (map off all) in
      match units (cone b) ps (unit_one b) 0 (unit_lines b) with
      | None => false
      | Some (s, r) =>
          let r := r + s * eps in
          (r <? unit_one b) &&
          forallb (fun x => images_right (bases b) (cone b) known ps (weight_one b) (unit_one b) s r eps x 0 (count F) (image_list x)) all
      end
  end.

(* An eigenvalue of a product has the modulus of the claim: so many turns lead from a base to itself. *)
Definition reached (bs : list base) (turns first : nat) : bool :=
  forallb (base_right bs) bs && (0 <? turns)%nat &&
  match walk bs turns first, nth_error bs first with
  | Some (k, _), Some x =>
      let '((u, v), e) := evaluate n (near_scale h) (near_re h) (if conjugated x then - near_im h else near_im h) (near_radius h) (vectors x) in
      Nat.eqb k first && existsb (fun i => (e <? Z.abs (nth i u 0)) || (e <? Z.abs (nth i v 0))) (seq 0 n)
  | _, _ => false
  end.
End Checker.

(* ---- vectors of complex numbers ---------------------------------------------------------------------------------- *)

Open Scope R_scope.

Definition turn_re (z : complex) (x y : vec) : vec := plus (scal (fst z) x) (scal (- snd z) y).
Definition turn_im (z : complex) (x y : vec) : vec := plus (scal (fst z) y) (scal (snd z) x).

Fixpoint horner (z : complex) (ys : list point) : vec * vec :=
  match ys with
  | [] => (zero, zero)
  | y :: ys' => let h := horner z ys' in (plus (vr (fst y)) (turn_re z (fst h) (snd h)), plus (vr (snd y)) (turn_im z (fst h) (snd h)))
  end.

Ltac vectors := extensionality i_; unfold turn_re, turn_im, plus, scal, sub, zero in *.

Lemma vanishes_spec x : vanishes x = true -> vr x = zero.
Proof.
  intros H. unfold vanishes in H. rewrite forallb_forall in H. extensionality i. unfold vr, zero.
  destruct (nth_in_or_default i x 0%Z) as [I | ->]; auto. apply H, Z.eqb_eq in I. rewrite <- I. auto.
Qed.

Lemma horner_snoc z ys : horner z (ys ++ [([], [])]) = horner z ys.
Proof.
  induction ys; simpl; [|rewrite IHys; auto]. rewrite vr_nil. f_equal; vectors; ring.
Qed.

Lemma horner_shift z ys : horner z (([], []) :: ys) = (turn_re z (fst (horner z ys)) (snd (horner z ys)), turn_im z (fst (horner z ys)) (snd (horner z ys))).
Proof. simpl. rewrite vr_nil. f_equal; vectors; ring. Qed.

Lemma closes_sound z q p seed : forall xs ys, closes q p seed xs ys = true ->
  fst (horner z xs) = plus (scal (IZR q) (fst (horner z ys))) (scal (- IZR q) (turn_re (value p z) (vr (fst seed)) (vr (snd seed)))) /\
  snd (horner z xs) = plus (scal (IZR q) (snd (horner z ys))) (scal (- IZR q) (turn_im (value p z) (vr (fst seed)) (vr (snd seed)))).
Proof.
  induction p as [|c p IH]; intros [|x xs] [|y ys] H; try discriminate; cbn [closes] in H.
  - simpl. unfold real_number. split; vectors; simpl; ring.
  - apply andb_prop in H. destruct H as [H H3]. apply andb_prop in H. destruct H as [H1 H2].
    apply vanishes_spec in H1, H2. rewrite !vr_addmul, opp_IZR, mult_IZR in H1, H2.
    destruct (IH _ _ H3) as [E1 E2]. cbn [horner fst snd value]. rewrite E1, E2.
    unfold cplus, ctimes, real_number. cbn [fst snd].
    split; extensionality i; [apply (f_equal (fun f => f i)) in H1 | apply (f_equal (fun f => f i)) in H2];
      unfold turn_re, turn_im, plus, scal, zero in *; cbn [fst snd] in *; cbv beta in *; lra || nra || idtac.
Qed.

(* ---- why that proves it ------------------------------------------------------------------------------------------ *)

Lemma column_sums_bound M : forall n j, sum n (fun i => Rabs (mr M i j)) <= vr (column_sums M) j.
Proof.
  assert (P : forall M j, 0 <= vr (column_sums M) j).
  { clear. induction M as [|row M IH]; intros j. simpl. rewrite vr_nil. unfold zero. lra.
    unfold column_sums in *. cbn [fold_right]. rewrite vr_addmul. unfold plus, scal. apply Rplus_le_le_0_compat; [|apply IH].
    rewrite Rmult_1_l. unfold vr. replace (nth j (map Z.abs row) 0%Z) with (Z.abs (nth j row 0%Z)) by (symmetry; apply (map_nth Z.abs row 0%Z j)).
    apply IZR_le. lia. }
  induction M as [|row M IH]; intros n j.
  - rewrite sum_zero. apply P. intros i Hi. unfold mr, entry. rewrite !nth_nil, Rabs_R0. auto.
  - destruct n. apply (P (row :: M)). change (S n) with (1 + n)%nat. rewrite sum_add. unfold column_sums in *. cbn [fold_right sum]. rewrite vr_addmul. unfold plus, scal.
    rewrite Rplus_0_l, Rmult_1_l. apply Rplus_le_compat; [|apply IH].
    unfold vr, mr, entry. cbn [nth]. replace (nth j (map Z.abs row) 0%Z) with (Z.abs (nth j row 0%Z)) by (symmetry; apply (map_nth Z.abs row 0%Z j)).
    rewrite abs_IZR. lra.
Qed.

Lemma column_norm_sound n M x : norm n (apply n (mr M) x) <= IZR (column_norm M) * norm n x.
Proof.
  unfold norm at 1. apply Rle_trans with (sum n (fun i => sum n (fun j => Rabs (mr M i j) * Rabs (x j)))).
  - apply sum_le; intros i Hi. unfold apply. eapply Rle_trans. apply sum_abs. right. apply sum_ext; intros. apply Rabs_mult.
  - rewrite sum_swap. unfold norm. rewrite <- sum_scal. apply sum_le; intros j Hj.
    rewrite (sum_ext n _ (fun i => Rabs (x j) * Rabs (mr M i j))) by (intros; ring). rewrite sum_scal, Rmult_comm.
    apply Rmult_le_compat_r. apply Rabs_pos. eapply Rle_trans. apply column_sums_bound.
    unfold vr. apply IZR_le. unfold column_norm. destruct (nth_in_or_default j (column_sums M) 0%Z) as [I | ->].
    + rewrite <- (map_id (column_sums M)) at 2. apply (largest_of_bound (fun a => a)); auto.
    + apply largest_of_nonneg.
Qed.

Lemma column_norm_nonneg M : (0 <= column_norm M)%Z.
Proof. apply largest_of_nonneg. Qed.

Definition distance_pair (n : nat) (x y : vec) (v : point) : R := norm n (sub x (vr (fst v))) + norm n (sub y (vr (snd v))).

Lemma norm_sub n x y : norm n (sub x y) <= norm n x + norm n y.
Proof.
  replace (sub x y) with (plus x (scal (-1) y)) by (vectors; ring). eapply Rle_trans. apply norm_plus.
  rewrite norm_scal. replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra). lra.
Qed.

Lemma norm_pair_sound n (a b : Z) (x y : point) :
  norm n (plus (scal (IZR a) (vr (fst x))) (scal (IZR b) (vr (fst y)))) + norm n (plus (scal (IZR a) (vr (snd x))) (scal (IZR b) (vr (snd y))))
  <= IZR (norm_pair (difference a b x y)).
Proof.
  unfold norm_pair, difference. cbn [fst snd]. rewrite plus_IZR.
  assert (A := norm_norm1 n (addmul a (fst x) (addmul b (fst y) []))). assert (B := norm_norm1 n (addmul a (snd x) (addmul b (snd y) []))).
  rewrite !vr_addmul, vr_nil in A, B.
  replace (plus (scal (IZR b) (vr (fst y))) zero) with (scal (IZR b) (vr (fst y))) in A by (vectors; ring).
  replace (plus (scal (IZR b) (vr (snd y))) zero) with (scal (IZR b) (vr (snd y))) in B by (vectors; ring). lra.
Qed.

Lemma norm_pair_nonneg x : (0 <= norm_pair x)%Z.
Proof. unfold norm_pair. assert (A := norm1_nonneg (fst x)). assert (B := norm1_nonneg (snd x)). lia. Qed.

Lemma cut_nth s x i : nth i (cut_by s x) 0%Z = (nth i x 0 / s)%Z.
Proof. replace 0%Z with (0 / s)%Z at 1 by apply Zdiv_0_l. apply (map_nth (fun a => (a / s)%Z)). Qed.

Lemma cut_sound n s x : (0 < s)%Z -> norm n (sub (scal (/ IZR s) (vr x)) (vr (cut_by s x))) <= IZR (cut_error n s x).
Proof.
  intros Hs. assert (S : 0 < IZR s) by (apply IZR_lt; auto). unfold cut_error. destruct (forallb _ x) eqn:E.
  { right. rewrite <- (norm_zero n). apply norm_ext. intros i Hi. unfold sub, scal, vr, zero. rewrite cut_nth.
    destruct (nth_in_or_default i x 0%Z) as [I | ->]; [|rewrite Zdiv_0_l; field; lra].
    rewrite forallb_forall in E. apply E, Z.eqb_eq in I. apply (f_equal IZR) in I. rewrite mult_IZR in I. rewrite <- I at 1. field. lra. }
  rewrite <- INR_IZR_INZ, <- (Rmult_1_r (INR n)). apply sum_bound. intros i Hi. unfold sub, scal, vr.
  rewrite cut_nth.
  - assert (D := Z.div_mod (nth i x 0%Z) s ltac:(lia)). assert (B := Z.mod_pos_bound (nth i x 0%Z) s Hs).
    set (a := nth i x 0%Z) in *. set (q := (a / s)%Z) in *. set (m := (a mod s)%Z) in *. rewrite D, plus_IZR, mult_IZR.
    replace (/ IZR s * (IZR s * IZR q + IZR m) - IZR q) with (IZR m / IZR s) by (field; lra).
    destruct B as [B1 B2]. apply IZR_le in B1. apply IZR_lt in B2. rewrite Rabs_pos_eq.
    + apply (Rmult_le_reg_r (IZR s)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
    + apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto.
Qed.

Lemma over_up_sound a b : (0 < b)%Z -> IZR a / IZR b <= IZR (over_up a b).
Proof.
  intros H. assert (P : 0 < IZR b) by (apply IZR_lt; auto). apply (Rmult_le_reg_r (IZR b)); auto.
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r, <- mult_IZR by lra. apply IZR_le. unfold over_up.
  assert (D := Z.mul_div_le (- a) b H). lia.
Qed.

Lemma over_up_nonneg a b : (0 <= a)%Z -> (0 < b)%Z -> (0 <= over_up a b)%Z.
Proof. intros A B. unfold over_up. assert (- a / b <= 0)%Z; [|lia]. apply Z.div_le_upper_bound; lia. Qed.

Lemma cut_error_nonneg n s x : (0 <= cut_error n s x)%Z.
Proof. unfold cut_error. destruct (forallb _ x); lia. Qed.

Lemma evaluate_sound n s c1 c2 rad z : (0 < s)%Z -> (0 <= rad)%Z ->
  Rabs (fst z - IZR c1 / IZR s) <= IZR rad / IZR s -> Rabs (snd z - IZR c2 / IZR s) <= IZR rad / IZR s ->
  forall ys v e, evaluate n s c1 c2 rad ys = (v, e) -> (0 <= e)%Z /\ distance_pair n (fst (horner z ys)) (snd (horner z ys)) v <= IZR e.
Proof.
  intros Hs Hr Z1 Z2. assert (P : 0 < IZR s) by (apply IZR_lt; auto). assert (R0 : 0 <= IZR rad) by (apply IZR_le; auto).
  induction ys as [|y ys IH]; intros v e H.
  - simpl in H. inversion H; subst. split. lia. unfold distance_pair. simpl. rewrite vr_nil.
    replace (sub zero zero) with zero by (vectors; ring). rewrite norm_zero. lra.
  - destruct ys as [|y' ys].
    + simpl in H. inversion H; subst. split. lia. unfold distance_pair. simpl.
      replace (sub (plus (vr (fst v)) (turn_re z zero zero)) (vr (fst v))) with zero by (vectors; ring).
      replace (sub (plus (vr (snd v)) (turn_im z zero zero)) (vr (snd v))) with zero by (vectors; ring). rewrite norm_zero. lra.
    + assert (H' : (let '((u, w), e) := evaluate n s c1 c2 rad (y' :: ys) in
          let re := addmul c1 u (addmul (- c2) w []) in let im := addmul c1 w (addmul c2 u []) in
          ((addmul 1 (fst y) (cut_by s re), addmul 1 (snd y) (cut_by s im)),
           (over_up ((Z.abs c1 + Z.abs c2 + 2 * rad) * e + 2 * rad * (norm1 u + norm1 w)) s + (cut_error n s re + cut_error n s im))%Z)) = (v, e)) by exact H.
      clear H. destruct (evaluate n s c1 c2 rad (y' :: ys)) as [[u w] e0]. destruct (IH _ _ eq_refl) as [E0 IHd]. clear IH.
      assert (Hv := f_equal fst H'). assert (He := f_equal snd H'). clear H'. cbn [fst snd] in Hv, He. subst v e.
      unfold distance_pair in *. cbn [fst snd] in *.
      change (horner z (y :: y' :: ys)) with (plus (vr (fst y)) (turn_re z (fst (horner z (y' :: ys))) (snd (horner z (y' :: ys)))),
        plus (vr (snd y)) (turn_im z (fst (horner z (y' :: ys))) (snd (horner z (y' :: ys))))). cbn [fst snd].
      set (U := fst (horner z (y' :: ys))) in *. set (W := snd (horner z (y' :: ys))) in *.
      assert (N1 := norm1_nonneg u). assert (N2 := norm1_nonneg w).
      split. { repeat apply Z.add_nonneg_nonneg; try apply cut_error_nonneg. apply over_up_nonneg; auto. nia. }
      set (a := fst z) in *. set (b := snd z) in *. set (da := a - IZR c1 / IZR s) in *. set (db := b - IZR c2 / IZR s) in *.
      assert (Part : forall (k1 k2 : Z) (x x' : zvec) (y0 : vec) (X X' : vec) (a1 a2 : R),
        Rabs (a1 - IZR k1 / IZR s) <= IZR rad / IZR s -> Rabs (a2 - IZR k2 / IZR s) <= IZR rad / IZR s ->
        norm n (sub (plus y0 (plus (scal a1 X) (scal a2 X'))) (plus (scal 1 y0) (vr (cut_by s (addmul k1 x (addmul k2 x' []))))))
        <= Rabs a1 * norm n (sub X (vr x)) + Rabs a2 * norm n (sub X' (vr x')) + IZR rad / IZR s * (IZR (norm1 x) + IZR (norm1 x')) +
           IZR (cut_error n s (addmul k1 x (addmul k2 x' [])))).
      { intros k1 k2 x x' y0 X X' a1 a2 H1 H2.
        set (c := addmul k1 x (addmul k2 x' [])).
        replace (sub (plus y0 (plus (scal a1 X) (scal a2 X'))) (plus (scal 1 y0) (vr (cut_by s c))))
          with (plus (plus (scal a1 (sub X (vr x))) (scal a2 (sub X' (vr x'))))
                     (plus (plus (scal (a1 - IZR k1 / IZR s) (vr x)) (scal (a2 - IZR k2 / IZR s) (vr x')))
                           (sub (scal (/ IZR s) (vr c)) (vr (cut_by s c))))).
        - eapply Rle_trans. apply norm_plus. assert (T1 := norm_plus n (scal a1 (sub X (vr x))) (scal a2 (sub X' (vr x')))). rewrite !norm_scal in T1.
          assert (T2 := norm_plus n (plus (scal (a1 - IZR k1 / IZR s) (vr x)) (scal (a2 - IZR k2 / IZR s) (vr x'))) (sub (scal (/ IZR s) (vr c)) (vr (cut_by s c)))).
          assert (T3 := norm_plus n (scal (a1 - IZR k1 / IZR s) (vr x)) (scal (a2 - IZR k2 / IZR s) (vr x'))). rewrite !norm_scal in T3.
          assert (T4 := cut_sound n s c Hs). assert (B1 := norm_norm1 n x). assert (B2 := norm_norm1 n x').
          assert (C1 : Rabs (a1 - IZR k1 / IZR s) * norm n (vr x) <= IZR rad / IZR s * IZR (norm1 x)) by (apply Rmult_le_compat; auto; [apply Rabs_pos|apply norm_nonneg]).
          assert (C2 : Rabs (a2 - IZR k2 / IZR s) * norm n (vr x') <= IZR rad / IZR s * IZR (norm1 x')) by (apply Rmult_le_compat; auto; [apply Rabs_pos|apply norm_nonneg]).
          lra.
        - unfold c. rewrite !vr_addmul, vr_nil. vectors. field. lra. }
      assert (A1 : Rabs a <= (IZR (Z.abs c1) + IZR rad) / IZR s).
      { replace a with (da + IZR c1 / IZR s) by (unfold da; ring). eapply Rle_trans. apply Rabs_triang. unfold Rdiv at 1. rewrite Rabs_mult, (Rabs_pos_eq (/ IZR s)), <- abs_IZR by (left; apply Rinv_0_lt_compat; auto).
        unfold Rdiv in *. lra. }
      assert (A2 : Rabs b <= (IZR (Z.abs c2) + IZR rad) / IZR s).
      { replace b with (db + IZR c2 / IZR s) by (unfold db; ring). eapply Rle_trans. apply Rabs_triang. unfold Rdiv at 1. rewrite Rabs_mult, (Rabs_pos_eq (/ IZR s)), <- abs_IZR by (left; apply Rinv_0_lt_compat; auto).
        unfold Rdiv in *. lra. }
      assert (Re := Part c1 (- c2)%Z u w (vr (fst y)) U W a (- b) Z1).
      assert (Im := Part c1 c2 w u (vr (snd y)) W U a b Z1 Z2).
      rewrite opp_IZR in Re. assert (Z2' : Rabs (- b - - IZR c2 / IZR s) <= IZR rad / IZR s).
      { replace (- b - - IZR c2 / IZR s) with (- db) by (unfold db; field; lra). rewrite Rabs_Ropp. auto. }
      specialize (Re Z2'). rewrite Rabs_Ropp in Re. rewrite !vr_addmul.
      change (turn_re z U W) with (plus (scal a U) (scal (- b) W)). change (turn_im z U W) with (plus (scal a W) (scal b U)).
      rewrite !plus_IZR.
      assert (Q := over_up_sound ((Z.abs c1 + Z.abs c2 + 2 * rad) * e0 + 2 * rad * (norm1 u + norm1 w)) s Hs).
      rewrite !plus_IZR, !mult_IZR, !plus_IZR, !mult_IZR in Q.
      set (q := IZR (over_up _ s)) in *.
      set (nu := norm n (sub U (vr u))) in *. set (nw := norm n (sub W (vr w))) in *.
      assert (Nu : 0 <= nu) by apply norm_nonneg. assert (Nw : 0 <= nw) by apply norm_nonneg.
      assert (Q' : (Rabs a + Rabs b) * (nu + nw) + 2 * (IZR rad / IZR s * (IZR (norm1 u) + IZR (norm1 w))) <= q).
      { eapply Rle_trans; [|apply Q].
        replace (((IZR (Z.abs c1) + IZR (Z.abs c2) + 2 * IZR rad) * IZR e0 + 2 * IZR rad * (IZR (norm1 u) + IZR (norm1 w))) / IZR s)
          with ((IZR (Z.abs c1) + IZR (Z.abs c2) + 2 * IZR rad) / IZR s * IZR e0 + 2 * (IZR rad / IZR s * (IZR (norm1 u) + IZR (norm1 w)))) by (field; lra).
        apply Rplus_le_compat_r. apply Rmult_le_compat. assert (X1 := Rabs_pos a); assert (X2 := Rabs_pos b); lra. lra. unfold Rdiv in *; lra. auto. }
      change (IZR 1) with 1. lra.
Qed.

Section Sound.
Variables (F : family) (p : list Z) (L : nat) (h : place) (z : complex) (r : R).
Let n := size F.
Let D := IZR (denominator F).
Let T := real F.
Hypothesis WF : well_formed F = true.
Hypothesis Zero : value p z = real_number 0.
Hypothesis Scale : (0 < near_scale h)%Z.
Hypothesis Small : (0 <= near_radius h)%Z.
Hypothesis Near_re : Rabs (fst z - IZR (near_re h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h).
Hypothesis Near_im : Rabs (snd z - IZR (near_im h) / IZR (near_scale h)) <= IZR (near_radius h) / IZR (near_scale h).
Hypothesis Radius : 0 < r.
Hypothesis Power : r ^ L = cabs z.
Hypothesis Length : (0 < L)%nat.
Hypothesis Low : (0 < low h)%Z.
Hypothesis Common : (0 < bottom h)%Z.
Hypothesis Between : IZR (low h) / IZR (bottom h) <= r <= IZR (high h) / IZR (bottom h).

Lemma alphabet_letters w : forallb (fun t => Nat.ltb t (count F)) w = true -> letters (count F) w.
Proof. unfold letters. rewrite Forall_forall, forallb_forall. intros H t Ht. apply Nat.ltb_lt, H; auto. Qed.

Lemma turn_run w lambda x y : run n T w (turn_re lambda x y) = turn_re lambda (run n T w x) (run n T w y) /\
  run n T w (turn_im lambda x y) = turn_im lambda (run n T w x) (run n T w y).
Proof. unfold turn_re, turn_im. rewrite !run_plus, !run_scal. auto. Qed.

Lemma turn_turn a b x y : turn_re a (turn_re b x y) (turn_im b x y) = turn_re (ctimes a b) x y /\
  turn_im a (turn_re b x y) (turn_im b x y) = turn_im (ctimes a b) x y.
Proof. unfold ctimes. split; vectors; cbn [fst snd]; ring. Qed.

Lemma reach_turn w lambda x y : reach n T w (turn_re lambda x y) (turn_im lambda x y) = cabs lambda * reach n T w x y.
Proof. apply reach_mult. Qed.

Lemma horner_run u w ys : letters (count F) w ->
  fst (horner u (map (run_pair (matrices F) w) ys)) = scal (D ^ length w) (run n T w (fst (horner u ys))) /\
  snd (horner u (map (run_pair (matrices F) w) ys)) = scal (D ^ length w) (run n T w (snd (horner u ys))).
Proof.
  intros Hw. induction ys as [|y ys IH]; simpl.
  - rewrite run_zero. split; vectors; ring.
  - destruct IH as [E1 E2]. rewrite E1, E2, !(vr_zrun F WF) by auto. fold D n T. rewrite !run_plus.
    destruct (turn_run w u (fst (horner u ys)) (snd (horner u ys))) as [R1 R2]. rewrite R1, R2. split; vectors; ring.
Qed.

Lemma power_cancel k x y : scal (D ^ k) x = scal (D ^ k) y -> x = y.
Proof.
  intros H. assert (P : 0 < D ^ k) by (apply pow_lt, denominator_positive; auto). extensionality i.
  apply (f_equal (fun f => f i)) in H. unfold scal in H. apply (Rmult_eq_reg_l (D ^ k)); lra.
Qed.

Section Bases.
Variable bs : list base.
Hypothesis Right : forallb (base_right F p L bs) bs = true.

Definition zero_for (b : base) : complex := if conjugated b then conjugate z else z.
Definition true_base (k : nat) : vec * vec :=
  match nth_error bs k with Some b => horner (zero_for b) (vectors b) | None => (zero, zero) end.

Lemma zero_for_right b : value p (zero_for b) = real_number 0 /\ cabs (zero_for b) = cabs z.
Proof.
  unfold zero_for. destruct (conjugated b); auto. rewrite value_conjugate, Zero. split.
  unfold conjugate, real_number; simpl. f_equal; ring. unfold cabs, conjugate, modulus; simpl. f_equal. ring.
Qed.

Lemma zero_for_real b : z = real_number (cabs z) -> zero_for b = real_number (cabs z).
Proof.
  intros Hz. unfold zero_for. destruct (conjugated b); auto. rewrite Hz at 1. unfold conjugate, real_number. simpl. f_equal. ring.
Qed.

Lemma base_step k b k' w seed : nth_error bs k = Some b -> previous b = Some (k', (w, seed)) ->
  letters (count F) w /\ length w = L /\
  run n T w (fst (true_base k')) = turn_re (zero_for b) (fst (true_base k)) (snd (true_base k)) /\
  run n T w (snd (true_base k')) = turn_im (zero_for b) (fst (true_base k)) (snd (true_base k)).
Proof.
  intros E H. assert (R := Right). rewrite forallb_forall in R. specialize (R b (nth_error_In _ _ E)). unfold base_right in R. rewrite H in R.
  destruct (nth_error bs k') as [b'|] eqn:E'; [|discriminate]. repeat rewrite andb_true_iff in R. destruct R as [[[R1 R2] R3] R4].
  apply alphabet_letters in R1. apply Nat.eqb_eq in R2. apply eqb_prop in R3. split; auto. split; auto.
  apply (closes_sound (zero_for b)) in R4. destruct (zero_for_right b) as [Zb _]. rewrite Zb in R4.
  rewrite horner_shift, horner_snoc in R4. destruct (horner_run (zero_for b) w (vectors b') R1) as [H1 H2]. rewrite H1, H2 in R4. cbn [fst snd] in R4.
  unfold true_base. rewrite E, E'. assert (EZ : zero_for b' = zero_for b) by (unfold zero_for; rewrite R3; auto). rewrite EZ.
  rewrite R2, <- pow_IZR in R4. fold D in R4. destruct R4 as [R4 R5].
  split; apply (power_cancel L); [rewrite R4 | rewrite R5]; unfold real_number; vectors; cbn [fst snd]; ring.
Qed.

Lemma walk_sound k : forall m j w, walk bs m k = Some (j, w) -> letters (count F) w /\ length w = (m * L)%nat /\
  exists lambda, cabs lambda = cabs z ^ m /\ (z = real_number (cabs z) -> lambda = real_number (cabs z ^ m)) /\
  run n T w (fst (true_base j)) = turn_re lambda (fst (true_base k)) (snd (true_base k)) /\
  run n T w (snd (true_base j)) = turn_im lambda (fst (true_base k)) (snd (true_base k)).
Proof.
  induction m; intros j w H; cbn [walk] in H.
  - inversion H; subst. split. constructor. split; auto. exists (real_number 1). split. rewrite cabs_real, Rabs_R1. reflexivity. split. reflexivity.
    unfold real_number. split; simpl; vectors; simpl; ring.
  - destruct (walk bs m k) as [[k' v]|]; [|discriminate]. destruct (nth_error bs k') as [b|] eqn:E; [|discriminate].
    destruct (previous b) as [[k'' [w' seed]]|] eqn:EP; [|discriminate]. inversion H; subst. clear H.
    destruct (IHm _ _ eq_refl) as [L1 [L2 [lambda [La [Lr [R1 R2]]]]]]. destruct (base_step _ _ _ _ _ E EP) as [S1 [S2 [S3 S4]]].
    split. apply letters_app; auto. split. rewrite app_length, L2, S2. lia.
    exists (ctimes (zero_for b) lambda). rewrite cabs_times, La, (proj2 (zero_for_right b)). split. reflexivity. split.
    { intros Hz. rewrite (Lr Hz), (zero_for_real b Hz). unfold ctimes, real_number. simpl. f_equal; ring. }
    rewrite !run_app, S3, S4. destruct (turn_run v (zero_for b) (fst (true_base k')) (snd (true_base k'))) as [X1 X2].
    rewrite X1, X2, R1, R2. apply turn_turn.
Qed.

Lemma same_word_spec v : forall w, same_word v w = true -> v = w.
Proof.
  induction v; intros [|b w] H; simpl in H; try discriminate; auto. apply andb_prop in H. destruct H as [H1 H2].
  apply Nat.eqb_eq in H1. f_equal; auto.
Qed.

Lemma agree_sound u sign : forall xs ys, agree sign xs ys = true ->
  fst (horner u xs) = scal (- IZR sign) (fst (horner u ys)) /\ snd (horner u xs) = scal (- IZR sign) (snd (horner u ys)).
Proof.
  induction xs as [|x xs IH]; intros [|y ys] H; try discriminate; simpl in H.
  - simpl. split; vectors; ring.
  - repeat rewrite andb_true_iff in H. destruct H as [[H1 H2] H3]. apply vanishes_spec in H1, H2. rewrite vr_addmul in H1, H2.
    destruct (IH _ H3) as [E1 E2]. simpl. rewrite E1, E2.
    split; extensionality i; [apply (f_equal (fun f => f i)) in H1 | apply (f_equal (fun f => f i)) in H2];
      unfold turn_re, turn_im, plus, scal, zero in *; lra.
Qed.

Lemma linked_sound k v t k' w t' : linked F bs k v t k' w t' = true -> letters (count F) v -> letters (count F) w ->
  (length v + t * L = length w + t' * L)%nat /\
  forall x, cabs z ^ t * reach n T x (run n T v (fst (true_base k))) (run n T v (snd (true_base k))) =
            cabs z ^ t' * reach n T x (run n T w (fst (true_base k'))) (run n T w (snd (true_base k'))).
Proof.
  intros H Lv Lw. unfold linked in H. destruct (walk bs t k) as [[j v']|] eqn:E; [|discriminate].
  destruct (walk bs t' k') as [[j' w']|] eqn:E'; [|discriminate]. cbv zeta in H.
  apply walk_sound in E, E'. destruct E as [A1 [A2 [a [Aa [_ [A3 A4]]]]]]. destruct E' as [B1 [B2 [b [Bb [_ [B3 B4]]]]]].
  apply andb_prop in H. destruct H as [HL H]. apply Nat.eqb_eq in HL. rewrite !app_length in HL. split. lia. intros x.
  assert (EA : reach n T x (run n T (v ++ v') (fst (true_base j))) (run n T (v ++ v') (snd (true_base j))) =
    cabs z ^ t * reach n T x (run n T v (fst (true_base k))) (run n T v (snd (true_base k)))).
  { rewrite !run_app, A3, A4. destruct (turn_run v a (fst (true_base k)) (snd (true_base k))) as [X1 X2]. rewrite X1, X2, reach_turn, Aa. auto. }
  assert (EB : reach n T x (run n T (w ++ w') (fst (true_base j'))) (run n T (w ++ w') (snd (true_base j'))) =
    cabs z ^ t' * reach n T x (run n T w (fst (true_base k'))) (run n T w (snd (true_base k')))).
  { rewrite !run_app, B3, B4. destruct (turn_run w b (fst (true_base k')) (snd (true_base k'))) as [X1 X2]. rewrite X1, X2, reach_turn, Bb. auto. }
  rewrite <- EA, <- EB. apply orb_prop in H. destruct H as [H|H].
  - apply andb_prop in H. destruct H as [H1 H2]. apply Nat.eqb_eq in H1. apply same_word_spec in H2. rewrite H1, H2. auto.
  - unfold true_base. destruct (nth_error bs j) as [c|]; [|discriminate]. destruct (nth_error bs j') as [c'|]; [|discriminate].
    apply andb_prop in H. destruct H as [H1 H]. apply eqb_prop in H1.
    assert (EZ : zero_for c' = zero_for c) by (unfold zero_for; rewrite H1; auto). rewrite EZ.
    assert (Lvv : letters (count F) (v ++ v')) by (apply letters_app; auto). assert (Lww : letters (count F) (w ++ w')) by (apply letters_app; auto).
    destruct (horner_run (zero_for c) (v ++ v') (vectors c) Lvv) as [H2 H3]. destruct (horner_run (zero_for c) (w ++ w') (vectors c') Lww) as [H4 H5].
    assert (HLa : length (v ++ v') = length (w ++ w')) by (rewrite !app_length; lia).
    assert (S : exists sign, Rabs (- IZR sign) = 1 /\ agree sign (map (run_pair (matrices F) (v ++ v')) (vectors c)) (map (run_pair (matrices F) (w ++ w')) (vectors c')) = true).
    { apply orb_prop in H. destruct H as [H|H]; [exists (-1)%Z | exists 1%Z]; split; auto. rewrite <- opp_IZR, <- abs_IZR. reflexivity. rewrite <- opp_IZR, <- abs_IZR. reflexivity. }
    destruct S as [sign [S1 S]]. apply (agree_sound (zero_for c)) in S. rewrite H2, H3, H4, H5, HLa in S. destruct S as [S2 S3].
    assert (C : forall x y, scal (D ^ length (w ++ w')) x = scal (- IZR sign) (scal (D ^ length (w ++ w')) y) -> x = scal (- IZR sign) y).
    { intros x0 y0 E. apply (power_cancel (length (w ++ w'))). rewrite E. vectors. ring. }
    apply C in S2, S3. rewrite S2, S3, reach_scal, S1. lra.
Qed.

(* Powers of the number *)
Lemma powers_equal t k a t' m c : (S k + t * L = m + t' * L)%nat -> cabs z ^ t * a = cabs z ^ t' * c -> / r ^ k * a = r * (/ r ^ m * c).
Proof.
  intros HL H. rewrite <- Power, <- !pow_mult in H.
  assert (K0 : forall q, r ^ q <> 0) by (intros; apply pow_nonzero; lra).
  apply (Rmult_eq_reg_l (r ^ (L * t) * r ^ k * r ^ m)). 2:{ repeat apply Rmult_integral_contrapositive_currified; auto. }
  replace (r ^ (L * t) * r ^ k * r ^ m * (/ r ^ k * a)) with (r ^ (L * t) * a * r ^ m) by (field; auto).
  replace (r ^ (L * t) * r ^ k * r ^ m * (r * (/ r ^ m * c))) with (r ^ (L * t) * r ^ k * r * c) by (field; auto).
  rewrite H. replace (r ^ (L * t') * c * r ^ m) with (r ^ (L * t' + m) * c) by (rewrite pow_add; ring).
  replace (r ^ (L * t) * r ^ k * r) with (r ^ (L * t + k + 1)) by (rewrite !pow_add; simpl; ring).
  f_equal. f_equal. lia.
Qed.

(* ---- true points ------------------------------------------------------------------------------------------------- *)

Definition true_re (x : vertex) : vec := scal (/ r ^ length (path x)) (run n T (path x) (fst (true_base (from x)))).
Definition true_im (x : vertex) : vec := scal (/ r ^ length (path x)) (run n T (path x) (snd (true_base (from x)))).
Definition good_vertex (x : vertex) : Prop :=
  letters (count F) (path x) /\ (0 <= off x)%Z /\ distance_pair n (true_re x) (true_im x) (shown x) <= IZR (off x).

Lemma true_step x y t : from y = from x -> path y = t :: path x ->
  true_re y = scal (/ r) (apply n (T t) (true_re x)) /\ true_im y = scal (/ r) (apply n (T t) (true_im x)).
Proof.
  intros E1 E2. unfold true_re, true_im. rewrite E1, E2. cbn [length run]. rewrite !apply_scal.
  split; extensionality j; unfold scal; simpl pow; field; (split; [apply pow_nonzero|]; lra).
Qed.

Lemma evaluate_base k b v e : nth_error bs k = Some b ->
  evaluate n (near_scale h) (near_re h) (if conjugated b then - near_im h else near_im h) (near_radius h) (vectors b) = (v, e) ->
  (0 <= e)%Z /\ distance_pair n (fst (true_base k)) (snd (true_base k)) v <= IZR e.
Proof.
  intros E H. unfold true_base. rewrite E. assert (P : 0 < IZR (near_scale h)) by (apply IZR_lt; auto).
  refine (evaluate_sound n _ _ _ _ (zero_for b) Scale Small _ _ _ _ _ H); unfold zero_for; destruct (conjugated b); simpl; auto.
  rewrite opp_IZR. replace (- snd z - - IZR (near_im h) / IZR (near_scale h)) with (- (snd z - IZR (near_im h) / IZR (near_scale h))) by (field; lra).
  rewrite Rabs_Ropp. auto.
Qed.

Lemma distance_more x y v w : distance_pair n x y w <= distance_pair n x y v + IZR (norm_pair (difference 1 (-1) v w)).
Proof.
  assert (B := norm_pair_sound n 1 (-1) v w). unfold distance_pair.
  assert (A1 := norm_plus n (sub x (vr (fst v))) (plus (scal 1 (vr (fst v))) (scal (-1) (vr (fst w))))).
  assert (A2 := norm_plus n (sub y (vr (snd v))) (plus (scal 1 (vr (snd v))) (scal (-1) (vr (snd w))))).
  replace (plus (sub x (vr (fst v))) (plus (scal 1 (vr (fst v))) (scal (-1) (vr (fst w))))) with (sub x (vr (fst w))) in A1 by (vectors; ring).
  replace (plus (sub y (vr (snd v))) (plus (scal 1 (vr (snd v))) (scal (-1) (vr (snd w))))) with (sub y (vr (snd w))) in A2 by (vectors; ring).
  change (IZR 1) with 1 in B. lra.
Qed.

Lemma vr_image t x : (t < count F)%nat -> vr (mv (letter F t) x) = scal D (apply n (T t) (vr x)).
Proof. intros H. apply (vr_letter F WF); auto. Qed.

Lemma column_norm_image t x : (t < count F)%nat -> D * norm n (apply n (T t) x) <= IZR (column_norm (letter F t)) * norm n x.
Proof.
  intros Ht. eapply Rle_trans; [|apply column_norm_sound]. right. assert (P := denominator_positive F WF). fold D in P.
  rewrite <- (Rabs_pos_eq D) by lra. rewrite <- norm_scal. apply norm_ext. intros i Hi. unfold scal, apply. rewrite <- sum_scal.
  apply sum_ext; intros j Hj. unfold T, real. fold D. field. lra.
Qed.

Lemma make_sound known s v images x : (forall i y, PositiveMap.find i known = Some y -> good_vertex y) ->
  make F h bs known s v images = Some x -> good_vertex x.
Proof.
  intros Known H. destruct s as [k|i t]; unfold make in H.
  - destruct (nth_error bs k) as [b|] eqn:E; [|discriminate]. fold n in H.
    destruct (evaluate n _ _ _ _ (vectors b)) as [y e] eqn:EV. inversion H; subst x. clear H.
    destruct (evaluate_base k b y e E EV) as [E0 Ed]. unfold good_vertex. cbn [path off shown].
    split. constructor. assert (N := norm_pair_nonneg (difference 1 (-1) y v)). split. lia.
    assert (M := distance_more (fst (true_base k)) (snd (true_base k)) y v). rewrite plus_IZR.
    unfold true_re, true_im. cbn [path from length run].
    replace (scal (/ r ^ 0) (fst (true_base k))) with (fst (true_base k)) by (vectors; simpl; field).
    replace (scal (/ r ^ 0) (snd (true_base k))) with (snd (true_base k)) by (vectors; simpl; field). lra.
  - destruct (PositiveMap.find i known) as [y|] eqn:E; [|discriminate]. destruct (Known _ _ E) as [Ly [Oy Dy]]. clear E.
    fold n in H. set (M := letter F t) in *. cbv zeta in H.
    set (moved := (mv M (fst (shown y)), mv M (snd (shown y)))) in *.
    set (whole := (bottom h * column_norm M * off y + norm_pair (difference (bottom h) (- (denominator F * low h)) moved v) +
                   denominator F * (high h - low h) * norm_pair v)%Z) in *.
    destruct (Nat.ltb_spec t (count F)) as [Ht|]; [|discriminate]. inversion H; subst x. clear H.
    assert (Dp := denominator_positive F WF). fold D in Dp. assert (Dz : (0 < denominator F)%Z) by (apply lt_IZR; auto).
    assert (Lp : 0 < IZR (low h)) by (apply IZR_lt; auto). assert (Cp : 0 < IZR (bottom h)) by (apply IZR_lt; auto).
    assert (CN := column_norm_nonneg M). assert (N1 := norm_pair_nonneg (difference (bottom h) (- (denominator F * low h)) moved v)).
    assert (N2 := norm_pair_nonneg v).
    assert (HL : (low h <= high h)%Z).
    { apply le_IZR. apply (Rmult_le_reg_r (/ IZR (bottom h))). apply Rinv_0_lt_compat; auto. unfold Rdiv in Between. lra. }
    assert (Wp : (0 <= whole)%Z). { unfold whole. assert (0 <= high h - low h)%Z by lia. apply Z.add_nonneg_nonneg; [apply Z.add_nonneg_nonneg|]; auto; repeat apply Z.mul_nonneg_nonneg; auto; lia. }
    unfold good_vertex. cbn [path off shown]. split. constructor; auto.
    split. apply over_up_nonneg; auto; nia.
    set (X := true_re y) in *. set (Y := true_im y) in *.
    destruct (true_step y (Vertex (from y) (t :: path y) v (over_up whole (denominator F * low h)) images) t eq_refl eq_refl) as [EX EY].
    fold X in EX. fold Y in EY.
    rewrite EX, EY. clear EX EY.
    (* one part, real or imaginary *)
    set (q := IZR (bottom h)) in *. set (lo := IZR (low h)) in *. set (hi := IZR (high h)) in *. set (cn := IZR (column_norm M)) in *.
    assert (Part : forall (U : vec) (u x : zvec), D * lo * norm n (sub (scal (/ r) (apply n (T t) U)) (vr x)) <=
      q * cn * norm n (sub U (vr u)) + norm n (plus (scal q (vr (mv M u))) (scal (- (D * lo)) (vr x))) + D * (hi - lo) * norm n (vr x)).
    { intros U u x.
      set (d := norm n (sub (scal (/ r) (apply n (T t) U)) (vr x))). assert (d0 : 0 <= d) by apply norm_nonneg.
      assert (E : (D * q * r) * d <= q * cn * norm n (sub U (vr u)) + norm n (plus (scal q (vr (mv M u))) (scal (- (D * lo)) (vr x))) + D * (hi - lo) * norm n (vr x)).
      { unfold d. rewrite <- (Rabs_pos_eq (D * q * r)) by (left; repeat apply Rmult_lt_0_compat; auto). rewrite <- norm_scal.
        replace (scal (D * q * r) (sub (scal (/ r) (apply n (T t) U)) (vr x)))
          with (plus (plus (scal q (scal D (apply n (T t) (sub U (vr u))))) (plus (scal q (vr (mv M u))) (scal (- (D * lo)) (vr x)))) (scal (- (D * (q * r - lo))) (vr x))).
        - eapply Rle_trans. apply norm_plus. assert (B := norm_plus n (scal q (scal D (apply n (T t) (sub U (vr u))))) (plus (scal q (vr (mv M u))) (scal (- (D * lo)) (vr x)))).
          rewrite !norm_scal in B. rewrite norm_scal, Rabs_Ropp, (Rabs_pos_eq q), (Rabs_pos_eq D) in * by lra.
          assert (C := column_norm_image t (sub U (vr u)) Ht). fold M cn in C.
          assert (C' : q * (D * norm n (apply n (T t) (sub U (vr u)))) <= q * (cn * norm n (sub U (vr u)))) by (apply Rmult_le_compat_l; lra).
          assert (R1 : 0 <= q * r - lo <= hi - lo).
          { destruct Between as [B1 B2]. fold lo hi q in B1, B2. apply (Rmult_le_compat_r q) in B1, B2; try lra. unfold Rdiv in B1, B2. rewrite !Rmult_assoc, !Rinv_l in B1, B2 by lra. lra. }
          assert (R2 : Rabs (D * (q * r - lo)) <= D * (hi - lo)) by (rewrite Rabs_pos_eq by (apply Rmult_le_pos; lra); apply Rmult_le_compat_l; lra).
          assert (R3 : Rabs (D * (q * r - lo)) * norm n (vr x) <= D * (hi - lo) * norm n (vr x)) by (apply Rmult_le_compat_r; auto; apply norm_nonneg). lra.
        - unfold M. rewrite vr_image, apply_sub by auto. vectors. field. lra. }
      assert (E' : D * lo * d <= D * q * r * d); [|lra]. apply Rmult_le_compat_r; auto. rewrite Rmult_assoc. apply Rmult_le_compat_l. lra.
      destruct Between as [B1 _]. fold lo q in B1. apply (Rmult_le_compat_r q) in B1; [|lra]. unfold Rdiv in B1. rewrite Rmult_assoc, Rinv_l in B1 by lra. lra. }
    assert (P1 := Part X (fst (shown y)) (fst v)). assert (P2 := Part Y (snd (shown y)) (snd v)). clear Part.
    assert (PN := norm_pair_sound n (bottom h) (- (denominator F * low h)) moved v). unfold moved in PN. cbn [fst snd] in PN.
    rewrite opp_IZR, mult_IZR in PN. fold q lo D in PN.
    unfold distance_pair in *.
    assert (Q := over_up_sound whole (denominator F * low h) ltac:(nia)).
    eapply Rle_trans; [|apply Q]. rewrite mult_IZR. fold D lo.
    apply (Rmult_le_reg_r (D * lo)). apply Rmult_lt_0_compat; auto. unfold Rdiv. rewrite (Rmult_assoc (IZR whole)), Rinv_l, Rmult_1_r by (apply Rgt_not_eq, Rmult_lt_0_compat; auto).
    unfold whole. rewrite !plus_IZR, !mult_IZR, minus_IZR. fold q lo hi cn D. fold moved in PN.
    assert (Nv : norm n (vr (fst v)) + norm n (vr (snd v)) <= IZR (norm_pair v)).
    { unfold norm_pair. rewrite plus_IZR. apply Rplus_le_compat; apply norm_norm1. }
    assert (HLr : lo <= hi) by (apply IZR_le; auto).
    assert (Nv' : D * (hi - lo) * (norm n (vr (fst v)) + norm n (vr (snd v))) <= D * (hi - lo) * IZR (norm_pair v)) by (apply Rmult_le_compat_l; auto; apply Rmult_le_pos; lra).
    assert (Cn0 : 0 <= cn) by (apply IZR_le; auto).
    assert (Oy' : q * cn * (norm n (sub X (vr (fst (shown y)))) + norm n (sub Y (vr (snd (shown y))))) <= q * cn * IZR (off y)) by (apply Rmult_le_compat_l; auto; apply Rmult_le_pos; lra).
    unfold moved in *. lra.
Qed.

(* ---- cones ------------------------------------------------------------------------------------------------------- *)

Section Cone.
Hypothesis Real : z = real_number (cabs z).
Hypothesis Matrices : forall t, (t < count F)%nat -> forall i j, 0 <= T t i j.
Hypothesis Positive : forallb (base_positive F h) bs = true.

Fixpoint real_horner (a : R) (xs : list zvec) : vec :=
  match xs with [] => zero | x :: xs' => plus (vr x) (scal a (real_horner a xs')) end.

Lemma horner_first a ys : fst (horner (real_number a) ys) = real_horner a (map fst ys).
Proof. induction ys as [|y ys IH]; simpl; auto. rewrite <- IH. unfold real_number. vectors. cbn [fst snd]. ring. Qed.

Lemma agree_at_sound a i xs : forall ys, agree_at i xs ys = true -> real_horner a xs i = real_horner a ys i.
Proof.
  induction xs as [|x xs IH]; intros [|y ys] H; try discriminate; auto. simpl in H. apply andb_prop in H. destruct H as [H1 H2].
  apply Z.eqb_eq in H1. simpl. unfold plus, scal, vr. rewrite H1, (IH _ H2). auto.
Qed.

Lemma led_sound k v t l xs : led F bs k v t = Some (l, xs) -> letters (count F) v -> l = (length v + t * L)%nat /\
  forall i, real_horner (cabs z) xs i = D ^ l * (cabs z ^ t * run n T v (fst (true_base k)) i).
Proof.
  intros H Lv. unfold led in H. destruct (walk bs t k) as [[j v']|] eqn:E; [|discriminate].
  destruct (nth_error bs j) as [b|] eqn:EB; [|discriminate]. inversion H; subst. clear H.
  apply walk_sound in E. destruct E as [A1 [A2 [a [_ [Ar [A3 _]]]]]]. split. rewrite app_length, A2. auto. intros i.
  assert (Lw : letters (count F) (v ++ v')) by (apply letters_app; auto).
  destruct (horner_run (zero_for b) (v ++ v') (vectors b) Lw) as [H1 _]. rewrite (zero_for_real b Real) in H1 at 1.
  rewrite horner_first, map_map in H1. cbn [run_pair fst] in H1. eapply eq_trans. apply (f_equal (fun f : vec => f i) H1). unfold scal. f_equal.
  replace (fst (horner (zero_for b) (vectors b))) with (fst (true_base j)) by (unfold true_base; rewrite EB; auto).
  rewrite run_app, A3. destruct (turn_run v a (fst (true_base k)) (snd (true_base k))) as [X1 _]. rewrite X1, (Ar Real).
  unfold turn_re, plus, scal, real_number. cbn [fst snd]. ring.
Qed.

Lemma equal_at_sound k v a k' w b i : equal_at F bs k v a k' w b i = true -> letters (count F) v -> letters (count F) w ->
  (length v + a * L = length w + b * L)%nat /\
  cabs z ^ a * run n T v (fst (true_base k)) i = cabs z ^ b * run n T w (fst (true_base k')) i.
Proof.
  intros H Lv Lw. unfold equal_at in H.
  destruct (led F bs k v a) as [[l xs]|] eqn:E1; [|discriminate]. destruct (led F bs k' w b) as [[l' ys]|] eqn:E2; [|discriminate].
  destruct (Nat.eqb_spec l l') as [El|]; [|discriminate].
  apply led_sound in E1; auto. apply led_sound in E2; auto. destruct E1 as [L1 E1]. destruct E2 as [L2 E2]. split. lia.
  apply (agree_at_sound (cabs z)) in H. rewrite E1, E2, El in H.
  apply Rmult_eq_reg_l in H; auto. apply pow_nonzero. assert (P := denominator_positive F WF). unfold D. lra.
Qed.

Lemma base_real k : snd (true_base k) = zero /\ forall i, (i < n)%nat -> 0 <= fst (true_base k) i.
Proof.
  unfold true_base. destruct (nth_error bs k) as [b|] eqn:E. 2:{ split. auto. intros; simpl; unfold zero; lra. }
  assert (P := Positive). rewrite forallb_forall in P. specialize (P b (nth_error_In _ _ E)). unfold base_positive in P. fold n in P.
  destruct (evaluate n _ _ _ _ (vectors b)) as [[u v] e] eqn:EV. apply (evaluate_base k b (u, v) e E) in EV. unfold true_base in EV. rewrite E in EV.
  destruct EV as [E0 Ed]. apply andb_prop in P. destruct P as [P1 P2]. rewrite forallb_forall in P1, P2.
  rewrite (zero_for_real b Real) in *. split.
  - clear - P1. induction (vectors b) as [|y ys IH]; simpl; auto. rewrite IH by (intros; apply P1; right; auto).
    rewrite (vanishes_spec (snd y)) by (apply P1; left; auto). unfold real_number. vectors. cbn [fst snd]. ring.
  - intros i Hi. specialize (P2 i ltac:(apply in_seq; lia)). apply orb_prop in P2. destruct P2 as [P2|P2].
    + apply Z.ltb_lt, IZR_lt in P2. unfold distance_pair in Ed. cbn [fst snd] in Ed.
      assert (T1 := norm_term n (sub (fst (horner (real_number (cabs z)) (vectors b))) (vr u)) i Hi).
      assert (N2 := norm_nonneg n (sub (snd (horner (real_number (cabs z)) (vectors b))) (vr v))).
      set (w := fst (horner (real_number (cabs z)) (vectors b))) in *. unfold sub in T1 at 1. unfold vr in T1 at 1. rewrite abs_le in T1. lra.
    + rewrite forallb_forall in P2. rewrite horner_first. right. clear - P2. induction (vectors b) as [|y ys IH]; simpl; auto.
      unfold plus, scal. rewrite <- IH by (intros; apply P2; right; auto). assert (Q := P2 y (or_introl eq_refl)). apply Z.eqb_eq in Q.
      replace (vr (fst y) i) with 0 by (symmetry; exact (f_equal IZR Q)). ring.
Qed.

Lemma vertex_real x : letters (count F) (path x) -> true_im x = zero /\ forall i, (i < n)%nat -> 0 <= true_re x i.
Proof.
  intros Lx. destruct (base_real (from x)) as [B1 B2]. unfold true_im, true_re. split.
  - rewrite B1, run_zero. vectors. ring.
  - intros i Hi. unfold scal. apply Rmult_le_pos. left. apply Rinv_0_lt_compat, pow_lt; auto.
    apply (run_nonnegative n (count F) T Matrices); auto.
Qed.

Lemma at_most_sound x t a y b : at_most_point F h bs x t a y b = true -> (t < count F)%nat -> good_vertex x -> good_vertex y ->
  forall i, (i < n)%nat -> apply n (T t) (true_re x) i <= r * true_re y i.
Proof.
  intros H Ht [Lx [Ox Dx]] [Ly [Oy Dy]] i Hi. unfold at_most_point in H. cbv zeta in H. rewrite forallb_forall in H.
  specialize (H i ltac:(apply in_seq; fold n; lia)). apply orb_prop in H. destruct H as [H|H].
  - apply equal_at_sound in H; [|constructor; auto|auto]. destruct H as [HL H].
    cbn [length run] in HL, H. apply Req_le. unfold true_re. rewrite apply_scal. unfold scal. apply (powers_equal a _ _ b); auto.
  - apply Z.leb_le, IZR_le in H. set (cn := column_norm (letter F t)) in *.
    rewrite !mult_IZR, plus_IZR, minus_IZR, mult_IZR in H. fold D in H.
    set (q := IZR (bottom h)) in *. set (lo := IZR (low h)) in *.
    assert (Dp : 0 < D) by (apply denominator_positive; auto). assert (Qp : 0 < q) by (apply IZR_lt; auto). assert (Lp : 0 < lo) by (apply IZR_lt; auto).
    destruct (vertex_real y Ly) as [_ Yp]. specialize (Yp i Hi). set (Y := true_re y i) in *.
    assert (Y1 : IZR (nth i (fst (shown y)) 0%Z) - IZR (off y) <= Y).
    { unfold distance_pair in Dy. assert (T1 := norm_term n (sub (true_re y) (vr (fst (shown y)))) i Hi). assert (N2 := norm_nonneg n (sub (true_im y) (vr (snd (shown y))))).
      unfold sub in T1 at 1. unfold vr in T1 at 1. fold Y in T1. rewrite abs_le in T1. lra. }
    assert (X1 : D * apply n (T t) (true_re x) i <= IZR (nth i (mv (letter F t) (fst (shown x))) 0%Z) + IZR cn * IZR (off x)).
    { assert (B := column_norm_image t (sub (true_re x) (vr (fst (shown x)))) Ht). fold cn in B.
      assert (T1 := norm_term n (apply n (T t) (sub (true_re x) (vr (fst (shown x))))) i Hi).
      assert (V := f_equal (fun f => f i) (vr_image t (fst (shown x)) Ht)). cbv beta in V. unfold vr at 1 in V. rewrite V. unfold scal.
      rewrite apply_sub in T1, B. unfold sub in T1 at 1. apply (Rmult_le_compat_l D) in T1; [|lra].
      assert (A : D * (apply n (T t) (true_re x) i - apply n (T t) (vr (fst (shown x))) i) <= D * Rabs (apply n (T t) (true_re x) i - apply n (T t) (vr (fst (shown x))) i))
        by (apply Rmult_le_compat_l; [lra|apply RRle_abs]).
      unfold distance_pair in Dx. assert (N2 := norm_nonneg n (sub (true_im x) (vr (snd (shown x))))).
      assert (CN : 0 <= IZR cn) by (apply IZR_le, column_norm_nonneg).
      assert (M : IZR cn * norm n (sub (true_re x) (vr (fst (shown x)))) <= IZR cn * IZR (off x)) by (apply Rmult_le_compat_l; lra). lra. }
    destruct Between as [B1 _]. fold lo q in B1. apply (Rmult_le_reg_l (q * D)). apply Rmult_lt_0_compat; auto.
    apply Rle_trans with (lo * D * Y).
    + apply Rle_trans with (lo * D * (IZR (nth i (fst (shown y)) 0%Z) - IZR (off y))).
      * eapply Rle_trans; [|apply H]. rewrite Rmult_assoc. apply Rmult_le_compat_l; lra.
      * apply Rmult_le_compat_l; auto. left. apply Rmult_lt_0_compat; auto.
    + apply (Rmult_le_compat_r q) in B1; [|lra]. unfold Rdiv in B1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in B1 by lra.
      replace (q * D * (r * Y)) with (r * q * (D * Y)) by ring. rewrite Rmult_assoc. apply Rmult_le_compat_r; auto. apply Rmult_le_pos; lra.
Qed.
End Cone.

Lemma build_sound given : forall i known all known' all', build F h bs i given known all = Some (known', all') ->
  (forall j y, PositiveMap.find j known = Some y -> In y all) -> (forall y, In y all -> good_vertex y) ->
  (forall j y, PositiveMap.find j known' = Some y -> In y all') /\ (forall y, In y all' -> good_vertex y).
Proof.
  induction given as [|[s [v images]] rest IH]; intros i known all known' all' H HK HG; cbn [build] in H.
  - inversion H; subst. auto.
  - destruct (make F h bs known s v images) as [x|] eqn:E; [|discriminate].
    apply IH in H; auto.
    + intros j y Hj. destruct (Pos.eq_dec j i) as [->|N].
      * rewrite PositiveMap.gss in Hj. inversion Hj. left; auto.
      * rewrite PositiveMap.gso in Hj by auto. right. eapply HK; eauto.
    + intros y [<-|Hy]; auto. eapply make_sound; [|apply E]. eauto.
Qed.
End Bases.

Lemma gmapped (known : PositiveMap.t vertex) i v : PositiveMap.find i (PositiveMap.mapi (fun _ => shown) known) = Some v ->
  exists x, PositiveMap.find i known = Some x /\ v = shown x.
Proof. rewrite PositiveMap.gmapi. destruct (PositiveMap.find i known); simpl; intros H; inversion H; eauto. Qed.

Theorem below_sound b : (cone b = true -> z = real_number (cabs z)) -> below F p L h b = true -> grows_at_most n (count F) T r.
Proof.
  intros HC H. unfold below in H. repeat rewrite andb_true_iff in H. destruct H as [[[[H1 H2] H3] H0] H4].
  apply Z.ltb_lt in H1. apply Nat.eqb_eq in H2. set (bs := bases b) in *.
  destruct (build F h bs 1 (given b) (PositiveMap.empty vertex) []) as [[known all]|] eqn:EB; [|discriminate].
  apply (build_sound bs) in EB.
  2:{ intros j y E. rewrite PositiveMap.gempty in E. discriminate. }
  2:{ intros y []. }
  destruct EB as [Known Good].
  assert (Cone : cone b = true -> (forall t, (t < count F)%nat -> forall i j, 0 <= T t i j) /\
    forall v, In v all -> true_im bs v = zero /\ forall i, (i < n)%nat -> 0 <= true_re bs v i).
  { intros EC. rewrite EC in H0. apply andb_prop in H0. destruct H0 as [HM HP].
    assert (M : forall t, (t < count F)%nat -> forall i j, 0 <= T t i j).
    { apply (all_nonnegative_matrices F WF []). exact HM. }
    split; auto. intros v Hv. apply (vertex_real bs (HC EC) M HP). apply (Good v Hv). }
  cbv zeta in H4. set (ps := PositiveMap.mapi (fun _ => shown) known) in *. set (eps := largest_of (map off all)) in *.
  destruct (units (cone b) ps (unit_one b) 0 (unit_lines b)) as [[s rest]|] eqn:EU; [|discriminate].
  set (ru := (rest + s * eps)%Z) in *. apply andb_prop in H4. destruct H4 as [H4 H5]. apply Z.ltb_lt in H4. rewrite forallb_forall in H5.
  assert (Eps : (0 <= eps)%Z) by apply largest_of_nonneg. assert (Eps' : 0 <= IZR eps) by (apply IZR_le; auto).
  set (P := fun x y => exists v, In v all /\ x = true_re bs v /\ y = true_im bs v).
  set (comb := combination n (count F) T P).
  assert (Off : forall v, In v all -> (off v <= eps)%Z) by (intros; apply (largest_of_bound off); auto).
  assert (Alone : forall v, In v all -> comb (true_re bs v) (true_im bs v) 1 0).
  { intros v Hv. apply combination_alone. exists v. auto. }
  assert (Shown : forall v, In v all -> comb (vr (fst (shown v))) (vr (snd (shown v))) 1 (IZR eps)).
  { intros v Hv. destruct (Good v Hv) as [_ [_ Dv]]. specialize (Off v Hv). apply IZR_le in Off.
    assert (C := combination_rest n (count F) T P _ _ (sub (vr (fst (shown v))) (true_re bs v)) (sub (vr (snd (shown v))) (true_im bs v)) _ _ (Alone v Hv)).
    replace (plus (true_re bs v) (sub (vr (fst (shown v))) (true_re bs v))) with (vr (fst (shown v))) in C by (vectors; ring).
    replace (plus (true_im bs v) (sub (vr (snd (shown v))) (true_im bs v))) with (vr (snd (shown v))) in C by (vectors; ring).
    eapply combination_le. exact C. apply Rle_refl. unfold distance_pair in Dv.
    assert (N : forall x y, norm n (sub x y) = norm n (sub y x)) by (intros; apply sum_ext; intros; unfold sub; apply Rabs_minus_sym).
    rewrite (N (vr (fst (shown v)))), (N (vr (snd (shown v)))). lra. }
  assert (Listed : forall i v, PositiveMap.find i ps = Some v -> comb (vr (fst v)) (vr (snd v)) 1 (IZR eps)).
  { intros i v E. apply gmapped in E. destruct E as [x [E ->]]. apply Shown. eapply Known; eauto. }
  assert (Hs : (0 <= s)%Z /\ (0 <= rest)%Z).
  { clear - EU. revert s rest EU. generalize 0%nat. induction (unit_lines b) as [|ts l IH]; intros k s r E; cbn [units] in E.
    inversion E; lia.
    destruct (line _ _ _ _ _ _) as [[w t]|]; [|discriminate].
    destruct (units (cone b) ps (unit_one b) (S k) l) as [[s' r']|] eqn:E2; [|discriminate].
    destruct (IH _ _ _ E2). inversion E. lia. }
  assert (Hr : (0 <= ru)%Z) by (unfold ru; nia). assert (Ho : (0 < unit_one b)%Z) by lia.
  destruct (units_near n (count F) T P ps (IZR eps) Eps' (cone b) (unit_one b) (unit_lines b) Ho) with (k := 0%nat) (s := s) (r := rest) as [_ [_ HU]]; auto.
  { intros k ts w t HL. destruct (cone b) eqn:EC.
    - destruct (Cone eq_refl) as [M _]. apply (line_cone n (count F) T P ps (IZR eps) Eps' Listed) in HL; [|lia].
      destruct HL as [_ [Hw [Ht [y [C Hy]]]]]. split; [|split; auto]. rewrite vr_nil. replace (scal (IZR (unit_one b)) zero) with zero by (vectors; ring).
      apply (combination_below n (count F) T P _ y _ _ M); [|exact C]. intros i Hi. split; [|apply Hy]. rewrite vr_unit. apply IZR_lt in Ho.
      unfold scal, unit, identity. destruct (Nat.eqb i k); lra.
    - apply (line_near n (count F) T P ps (IZR eps) Eps' Listed) in HL; [|lia]. exact HL. }
  set (one := IZR (unit_one b)) in *. assert (O1 : 0 < one) by (apply IZR_lt; auto).
  assert (Ru : (IZR rest + IZR s * IZR eps) / one = IZR ru / one) by (unfold ru; rewrite plus_IZR, mult_IZR; auto).
  assert (R1 : 0 <= IZR ru / one < 1).
  { split. apply Rmult_le_pos. apply IZR_le; auto. left; apply Rinv_0_lt_compat; auto.
    apply (Rmult_lt_reg_r one); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_l, Rmult_1_r by lra. apply IZR_lt; auto. }
  assert (S0 : 0 <= IZR s / one). { apply Rmult_le_pos. apply IZR_le; tauto. left; apply Rinv_0_lt_compat; auto. }
  assert (Dp := denominator_positive F WF). fold D in Dp. assert (Dz : (0 < denominator F)%Z) by (apply lt_IZR; auto).
  assert (Large : exists A0, 0 <= A0 /\ forall v, In v all -> cnorm n (true_re bs v) (true_im bs v) <= A0).
  { clear. induction all as [|v l IH]. exists 0. split. lra. intros v [].
    destruct IH as [A [A0 HA]]. exists (Rmax A (cnorm n (true_re bs v) (true_im bs v))). split. eapply Rle_trans. apply A0. apply Rmax_l.
    intros w [<-|Hw]. apply Rmax_r. eapply Rle_trans. apply HA; auto. apply Rmax_l. }
  destruct Large as [A0 [HA0 Large]].
  apply (polytope_bound n (count F) T P A0 (IZR s / one) (IZR ru / one) r); auto; try lra.
  - intros x y [v [Hv [-> ->]]]. auto.
  - intros k Hk. rewrite <- Ru. apply HU. lia.
  - intros x y t [v [Hv [-> ->]]] Ht.
    assert (Right : exists i, image_right F h bs (cone b) known ps (weight_one b) (unit_one b) s ru eps v t i = true).
    { specialize (H5 v Hv). assert (G : forall left t0 l, images_right F h bs (cone b) known ps (weight_one b) (unit_one b) s ru eps v t0 left l = true ->
        (t0 <= t < t0 + left)%nat -> exists i, image_right F h bs (cone b) known ps (weight_one b) (unit_one b) s ru eps v t i = true).
      { induction left; intros t0 l HI Hb. lia. cbn [images_right] in HI. destruct l as [|i l]; [discriminate|]. apply andb_prop in HI. destruct HI as [HI1 HI2].
        destruct (Nat.eq_dec t t0) as [->|N]. eauto. apply (IHleft (S t0) l HI2). lia. }
      apply (G _ _ _ H5). lia. }
    destruct Right as [i HR]. destruct (Good v Hv) as [Lv [Ov Dv]].
    destruct i as [j turns turns'|j turns turns'|ts]; unfold image_right in HR.
    + destruct (PositiveMap.find j known) as [y|] eqn:E; [|discriminate]. assert (Hy := Known _ _ E). destruct (Good y Hy) as [Ly _].
      apply (linked_sound bs H3) in HR; auto. 2:{ constructor; auto. }
      destruct HR as [HL HR]. cbn [length] in HL. exists r, 0. split; [|lra].
      intros w A B Hw HA HB HP _. rewrite Rmult_0_l, Rplus_0_r.
      eapply Rle_trans; [|apply Rmult_le_compat_l; [lra|]; apply (HP (true_re bs y) (true_im bs y)); exists y; auto].
      right. specialize (HR w). cbn [run] in HR. fold n T in HR.
      unfold true_re, true_im. rewrite !apply_scal, !reach_scal.
      rewrite !Rabs_pos_eq by (left; apply Rinv_0_lt_compat, pow_lt; auto).
      apply (powers_equal turns _ _ turns'); auto.
    + destruct (PositiveMap.find j known) as [y|] eqn:E; [|discriminate]. assert (Hy := Known _ _ E).
      apply andb_prop in HR. destruct HR as [EC HR]. destruct (Cone EC) as [M CP]. destruct (CP v Hv) as [V1 V2]. destruct (CP y Hy) as [Y1 Y2].
      rewrite EC in H0. apply andb_prop in H0. destruct H0 as [_ HP].
      exists r, 0. split; [|lra]. rewrite V1, apply_zero. apply (combination_below n (count F) T P _ (scal r (true_re bs y)) _ _ M).
      * intros i Hi. split. apply sum_nonneg; intros; apply Rmult_le_pos; auto.
        apply (at_most_sound bs H3 (HC EC) M HP v t turns y turns'); auto.
      * assert (C := combination_scal n (count F) T P r _ _ _ _ (Alone y Hy)). rewrite Rabs_pos_eq in C by lra. rewrite Y1 in C.
        replace (scal r zero) with zero in C by (vectors; ring). eapply combination_le. exact C. lra. lra.
    + cbv zeta in HR. destruct (line _ _ _ _ _ _) as [[w rest']|] eqn:EL in HR; [|discriminate]. apply Z.leb_le in HR. fold n in HR.
      set (cn := column_norm (letter F t)) in *. assert (CN : (0 <= cn)%Z) by apply column_norm_nonneg.
      set (sc := IZR (weight_one b)) in *. assert (Sc : 0 < sc) by (apply IZR_lt; auto).
      assert (Id : 0 < / (sc * D)) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; auto).
      set (dx := apply n (T t) (sub (true_re bs v) (vr (fst (shown v))))). set (dy := apply n (T t) (sub (true_im bs v) (vr (snd (shown v))))).
      assert (C : (comb (apply n (T t) (true_re bs v)) (apply n (T t) (true_im bs v)) (/ (sc * D) * IZR (denominator F * w))
        (/ (sc * D) * (IZR rest' + IZR (denominator F * w) * IZR eps) + (norm n dx + norm n dy))) /\ (0 <= w)%Z /\ (0 <= rest')%Z).
      { destruct (cone b) eqn:EC.
        - destruct (Cone eq_refl) as [M CP]. destruct (CP v Hv) as [V1 V2].
          apply (line_cone n (count F) T P ps (IZR eps) Eps' Listed) in EL; [|lia]. destruct EL as [_ [W0 [R0 [y [C Hy]]]]]. split; auto.
          apply (combination_scal n (count F) T P (/ (sc * D))) in C. rewrite Rabs_pos_eq in C by lra.
          apply (combination_rest n (count F) T P _ _ (fun i => Rabs (dx i)) zero) in C.
          replace (plus (scal (/ (sc * D)) zero) zero) with zero in C by (vectors; ring). rewrite norm_zero in C.
          rewrite V1, apply_zero. apply (combination_below n (count F) T P _ (plus (scal (/ (sc * D)) y) (fun i => Rabs (dx i))) _ _ M).
          + intros i Hi. split. apply sum_nonneg; intros; apply Rmult_le_pos; auto.
            specialize (Hy i). fold sc in Hy. rewrite vr_image in Hy by auto. unfold plus, scal in *.
            assert (A := RRle_abs (dx i)). assert (E : apply n (T t) (true_re bs v) i = apply n (T t) (vr (fst (shown v))) i + dx i).
            { unfold dx. rewrite apply_sub. unfold sub. ring. }
            rewrite E. apply Rplus_le_compat; auto. apply (Rmult_le_reg_l (sc * D)). apply Rmult_lt_0_compat; auto.
            rewrite <- Rmult_assoc, (Rmult_assoc sc D). replace (sc * D * / (sc * D) * y i) with (y i) by (field; lra). auto.
          + eapply combination_le. exact C. lra. assert (N : norm n (fun i => Rabs (dx i)) = norm n dx) by (apply sum_ext; intros; apply Rabs_Rabsolu).
            rewrite N. assert (N2 := norm_nonneg n dy). lra.
        - apply (line_near n (count F) T P ps (IZR eps) Eps' Listed) in EL; [|lia]. destruct EL as [C [W0 R0]]. split; auto.
          fold sc in C. rewrite !vr_image in C by auto.
          apply (combination_scal n (count F) T P (/ (sc * D))) in C. rewrite Rabs_pos_eq in C by lra.
          replace (scal (/ (sc * D)) (scal sc (scal D (apply n (T t) (vr (fst (shown v))))))) with (apply n (T t) (vr (fst (shown v)))) in C by (vectors; field; lra).
          replace (scal (/ (sc * D)) (scal sc (scal D (apply n (T t) (vr (snd (shown v))))))) with (apply n (T t) (vr (snd (shown v)))) in C by (vectors; field; lra).
          apply (combination_rest n (count F) T P _ _ dx dy) in C.
          replace (plus (apply n (T t) (vr (fst (shown v)))) dx) with (apply n (T t) (true_re bs v)) in C by (unfold dx; rewrite apply_sub; vectors; ring).
          replace (plus (apply n (T t) (vr (snd (shown v)))) dy) with (apply n (T t) (true_im bs v)) in C by (unfold dy; rewrite apply_sub; vectors; ring).
          exact C. }
      destruct C as [C [W0 R0]].
      assert (B1 := column_norm_image t (sub (true_re bs v) (vr (fst (shown v)))) Ht). assert (B2 := column_norm_image t (sub (true_im bs v) (vr (snd (shown v)))) Ht).
      fold cn dx in B1. fold cn dy in B2. set (n1 := norm n dx) in *. set (n2 := norm n dy) in *.
      unfold distance_pair in Dv. specialize (Off v Hv). apply IZR_le in Off. assert (CN' : 0 <= IZR cn) by (apply IZR_le; auto).
      assert (B : D * (n1 + n2) <= IZR cn * IZR eps).
      { apply Rle_trans with (IZR cn * (norm n (sub (true_re bs v) (vr (fst (shown v)))) + norm n (sub (true_im bs v) (vr (snd (shown v)))))). lra.
        apply Rmult_le_compat_l; auto. lra. }
      set (rt := (rest' + denominator F * w * eps + weight_one b * cn * eps)%Z) in *.
      exists (IZR w / sc), (IZR rt / (sc * D)). split; [|split].
      * eapply combination_le. exact C. rewrite mult_IZR. fold D. right. field. lra.
        unfold rt. rewrite !plus_IZR, !mult_IZR. fold D sc. apply (Rmult_le_reg_r (sc * D)). apply Rmult_lt_0_compat; auto.
        replace ((/ (sc * D) * (IZR rest' + D * IZR w * IZR eps) + (n1 + n2)) * (sc * D)) with (IZR rest' + D * IZR w * IZR eps + sc * (D * (n1 + n2))) by (field; lra).
        replace ((IZR rest' + D * IZR w * IZR eps + sc * IZR cn * IZR eps) / (sc * D) * (sc * D)) with (IZR rest' + D * IZR w * IZR eps + sc * (IZR cn * IZR eps)) by (field; lra).
        apply Rplus_le_compat_l. apply Rmult_le_compat_l; lra.
      * apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat, Rmult_lt_0_compat; auto]. apply IZR_le. unfold rt.
        assert (0 <= denominator F * w * eps)%Z by (repeat apply Z.mul_nonneg_nonneg; lia). assert (0 <= weight_one b * cn * eps)%Z by (repeat apply Z.mul_nonneg_nonneg; lia). lia.
      * apply Rle_trans with (IZR (low h) / IZR (bottom h)); [|tauto].
        apply IZR_le in HR. rewrite !mult_IZR, plus_IZR, !mult_IZR, minus_IZR in HR. fold D sc one in HR.
        assert (Cp : 0 < IZR (bottom h)) by (apply IZR_lt; auto). assert (Orr : 0 < one - IZR ru) by (unfold one; rewrite <- minus_IZR; apply IZR_lt; lia).
        set (q := IZR (bottom h)) in *. set (rr := IZR ru) in *.
        apply (Rmult_le_reg_r (q * (sc * D * (one - rr)))). repeat apply Rmult_lt_0_compat; auto.
        replace (IZR (low h) / q * (q * (sc * D * (one - rr)))) with (IZR (low h) * sc * D * (one - rr)) by (field; lra).
        eapply Rle_trans; [|apply HR]. right. field. repeat split; lra.
Qed.

Theorem reached_sound bs turns k : reached F p L h bs turns k = true -> radius_at_least n (count F) T r.
Proof.
  intros H g Hg G. unfold reached in H. repeat rewrite andb_true_iff in H. destruct H as [[H1 H2] H3]. apply Nat.ltb_lt in H2.
  destruct (walk bs turns k) as [[k' w]|] eqn:EW; [|discriminate]. destruct (nth_error bs k) as [x|] eqn:E; [|discriminate].
  fold n in H3. destruct (evaluate n _ _ _ _ (vectors x)) as [[u v] e] eqn:EV. apply andb_prop in H3. destruct H3 as [H3 H4]. apply Nat.eqb_eq in H3. subst k'.
  destruct (evaluate_base bs k x (u, v) e E EV) as [E0 Ed]. apply (walk_sound bs H1) in EW. destruct EW as [Lw [Ll [lambda [La [_ [R1 R2]]]]]].
  apply existsb_exists in H4. destruct H4 as [i [Hi H4]]. apply in_seq in Hi.
  set (X := fst (true_base bs k)) in *. set (Y := snd (true_base bs k)) in *. unfold distance_pair in Ed. cbn [fst snd] in Ed.
  assert (N1 := norm_nonneg n (sub X (vr u))). assert (N2 := norm_nonneg n (sub Y (vr v))).
  assert (T1 := norm_term n (sub X (vr u)) i ltac:(lia)). assert (T2 := norm_term n (sub Y (vr v)) i ltac:(lia)).
  assert (NZ : X i <> 0 \/ Y i <> 0).
  { apply orb_prop in H4. destruct H4 as [H4|H4]; [left|right]; apply Z.ltb_lt, IZR_lt in H4; rewrite abs_IZR in H4; intros Z0.
    - unfold sub in T1 at 1. rewrite Z0 in T1. replace (0 - vr u i) with (- vr u i) in T1 by ring. rewrite Rabs_Ropp in T1. unfold vr in T1 at 1. lra.
    - unfold sub in T2 at 1. rewrite Z0 in T2. replace (0 - vr v i) with (- vr v i) in T2 by ring. rewrite Rabs_Ropp in T2. unfold vr in T2 at 1. lra. }
  assert (B := eigenvalue_at_least n (count F) T w g X Y (fst lambda) (snd lambda) i Hg G Lw).
  assert (B' : modulus (fst lambda) (snd lambda) <= g ^ length w).
  { apply B; auto; try lia; intros j Hj; [rewrite R1 | rewrite R2]; unfold turn_re, turn_im, plus, scal; ring. }
  change (modulus (fst lambda) (snd lambda)) with (cabs lambda) in B'. rewrite La, <- Power, <- pow_mult, Ll, (Nat.mul_comm turns) in B'.
  apply (pow_le_reg r g (L * turns)); auto; try lra. apply Nat.mul_pos_pos; auto.
Qed.
End Sound.
