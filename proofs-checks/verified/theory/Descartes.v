(* Descartes' rule of signs, with zeros counted as often as they occur: a polynomial whose coefficients around `low` change
   their sign no more often than it vanishes at z >= low has coefficients of one sign around z. *)
Require Import Reals List ZArith Lia Lra Bool.
From Subcert Require Import Radius Subdivision Growth Squares.
Import ListNotations.
Open Scope R_scope.

(* ---- shifts of polynomials --------------------------------------------------------------------------------------- *)

Lemma pshift_padd s p : forall q i, nth i (pshift s (padd p q)) 0 = nth i (pshift s p) 0 + nth i (pshift s q) 0.
Proof.
  induction p; intros q i; cbn [padd]. destruct i; simpl; ring. destruct q; [destruct i; simpl; ring|].
  rewrite !nth_pshift, !IHp. destruct i; rewrite ?IHp; ring.
Qed.

Lemma pshift_pscal s c p : forall i, nth i (pshift s (pscal c p)) 0 = c * nth i (pshift s p) 0.
Proof.
  induction p; intros i. destruct i; simpl; ring. change (pscal c (a :: p)) with (c * a :: pscal c p). rewrite !nth_pshift, !IHp. destruct i; rewrite ?IHp; ring.
Qed.

Lemma pshift_pshift s t p : pshift s (pshift t p) = pshift (s + t) p.
Proof.
  apply (nth_ext _ _ 0 0). rewrite !length_pshift; auto. intros i _. revert i. induction p; intros i. auto.
  cbn [pshift]. change (nth i (pshift s (padd (a :: pshift t p) (pscal t (pshift t p)))) 0 = nth i (pshift (s + t) (a :: p)) 0).
  rewrite pshift_padd, pshift_pscal, !nth_pshift, !IHp. destruct i; rewrite ?IHp; ring.
Qed.

Lemma pshift_none p : pshift 0 p = p.
Proof.
  apply (nth_ext _ _ 0 0). apply length_pshift. intros i _. revert i. induction p; intros i; auto.
  rewrite nth_pshift, IHp. destruct i; rewrite ?IHp; simpl; ring.
Qed.

Lemma nth_product c p q i : nth i (product_of (c :: p) q) 0 = c * nth i q 0 + match i with O => 0 | S k => nth k (product_of p q) 0 end.
Proof. cbn [product_of]. rewrite nth_padd, nth_pscal. destruct i; auto. Qed.

Lemma product_padd x : forall y q i, nth i (product_of (padd x y) q) 0 = nth i (product_of x q) 0 + nth i (product_of y q) 0.
Proof.
  induction x; intros y q i. destruct i; simpl; ring. destruct y. simpl padd. destruct i; simpl; ring.
  cbn [padd]. rewrite !nth_product. destruct i; rewrite ?IHx; ring.
Qed.

Lemma product_pscal c x : forall q i, nth i (product_of (pscal c x) q) 0 = c * nth i (product_of x q) 0.
Proof.
  induction x; intros q i. destruct i; simpl; ring. change (pscal c (a :: x)) with (c * a :: pscal c x). rewrite !nth_product. destruct i; rewrite ?IHx; ring.
Qed.

Lemma pshift_product s p q : forall i, nth i (pshift s (product_of p q)) 0 = nth i (product_of (pshift s p) (pshift s q)) 0.
Proof.
  induction p; intros i. auto. cbn [product_of]. rewrite pshift_padd, pshift_pscal, nth_pshift.
  cbn [pshift]. rewrite product_padd, product_pscal, nth_product, <- !IHp. destruct i; rewrite <- ?IHp; ring.
Qed.

Lemma product_low p q k : (forall i, (i < k)%nat -> nth i q 0 = 0) -> forall i, (i < k)%nat -> nth i (product_of p q) 0 = 0.
Proof.
  intros H. induction p; intros i Hi. destruct i; auto. rewrite nth_product, H by auto. destruct i. ring. rewrite IHp by lia. ring.
Qed.

Fixpoint power_times (l : nat) (p q : list R) : list R := match l with O => q | S k => product_of p (power_times k p q) end.

Lemma zero_order z p q : nth 0 (pshift z p) 0 = 0 -> forall l i, (i < l)%nat -> nth i (pshift z (power_times l p q)) 0 = 0.
Proof.
  intros H. induction l; intros i Hi. lia. cbn [power_times]. rewrite pshift_product.
  destruct (pshift z p) as [|c p']. destruct i; auto. simpl in H. subst c. rewrite nth_product.
  destruct i. ring. rewrite (product_low p' _ l) by (auto; lia). ring.
Qed.

(* ---- changes of sign --------------------------------------------------------------------------------------------- *)

Definition sign_of (x : R) : Z := if Rlt_dec 0 x then 1%Z else if Rlt_dec x 0 then (-1)%Z else 0%Z.

Fixpoint changes (last : Z) (l : list Z) : nat :=
  match l with
  | [] => O
  | x :: l' => if Z.eqb x 0 then changes last l' else ((if Z.ltb (x * last) 0 then 1 else 0) + changes x l')%nat
  end.
Fixpoint low_zeros (l : list Z) : nat := match l with [] => O | x :: l' => if Z.eqb x 0 then S (low_zeros l') else O end.
Definition sign_count (l : list Z) : nat := (low_zeros l + changes 0 l)%nat.

Lemma sign_cases x : (x = 0 /\ sign_of x = 0%Z) \/ (0 < x /\ sign_of x = 1%Z) \/ (x < 0 /\ sign_of x = (-1)%Z).
Proof. unfold sign_of. destruct (Rlt_dec 0 x); auto. destruct (Rlt_dec x 0); auto. left. split; auto. lra. Qed.

Lemma sign_positive x : 0 < x -> sign_of x = 1%Z.
Proof. intros H. destruct (sign_cases x) as [[A B]|[[A B]|[A B]]]; auto; lra. Qed.
Lemma sign_negative x : x < 0 -> sign_of x = (-1)%Z.
Proof. intros H. destruct (sign_cases x) as [[A B]|[[A B]|[A B]]]; auto; lra. Qed.
Lemma sign_zero : sign_of 0 = 0%Z.
Proof. destruct (sign_cases 0) as [[A B]|[[A B]|[A B]]]; auto; lra. Qed.

Fixpoint with_root (a before : R) (g : list R) : list R :=
  match g with [] => [before] | x :: g' => (before + - a * x) :: with_root a x g' end.

Lemma with_root_spec a g : forall before, padd (before :: g) (pscal (- a) g) = with_root a before g.
Proof. induction g; intros before; auto. cbn [with_root]. rewrite <- IHg. reflexivity. Qed.

Definition signs (l : list R) : list Z := map sign_of l.

Lemma changes_root a g : 0 < a -> forall before (s : Z), (s = 1 \/ s = -1)%Z ->
  (sign_of before = s -> (1 + changes s (signs g) <= changes (- s) (signs (with_root a before g)))%nat) /\
  (sign_of before = s \/ before = 0 -> (changes s (signs g) <= changes s (signs (with_root a before g)))%nat).
Proof.
  intros Ha. induction g as [|x g IH]; intros before s Hs.
  - cbn [with_root signs map changes]. split; [|lia]. intros ->. destruct Hs as [-> | ->]; simpl; lia.
  - cbn [with_root signs map]. fold (signs g). set (y := before + - a * x). fold (signs (with_root a x g)).
    destruct (IH x s Hs) as [A B]. destruct (IH x (- s)%Z ltac:(lia)) as [A' B']. rewrite Z.opp_involutive in A'.
    assert (Zx : x = 0 -> sign_of before = sign_of y). { intros ->. unfold y. f_equal. ring. }
    assert (Opp : sign_of x = (- s)%Z -> sign_of before = s \/ before = 0 -> sign_of y = s).
    { intros Hx Hb. destruct Hs as [-> | ->].
      - apply sign_positive. destruct (sign_cases x) as [[P Q]|[[P Q]|[P Q]]]; try lia. assert (0 < a * - x) by (apply Rmult_lt_0_compat; lra).
        assert (0 <= before). { destruct Hb as [Hb|Hb]; [|lra]. destruct (sign_cases before) as [[P' Q']|[[P' Q']|[P' Q']]]; try lia; lra. } unfold y. lra.
      - apply sign_negative. destruct (sign_cases x) as [[P Q]|[[P Q]|[P Q]]]; try lia. assert (0 < a * x) by (apply Rmult_lt_0_compat; lra).
        assert (before <= 0). { destruct Hb as [Hb|Hb]; [|lra]. destruct (sign_cases before) as [[P' Q']|[[P' Q']|[P' Q']]]; try lia; lra. } unfold y. lra. }
    assert (Cx : sign_of x = 0%Z \/ sign_of x = s \/ sign_of x = (- s)%Z) by (destruct (sign_cases x) as [[_ Q]|[[_ Q]|[_ Q]]]; lia).
    assert (Cy : sign_of y = 0%Z \/ sign_of y = s \/ sign_of y = (- s)%Z) by (destruct (sign_cases y) as [[_ Q]|[[_ Q]|[_ Q]]]; lia).
    assert (X0 : sign_of x = 0%Z -> x = 0) by (destruct (sign_cases x) as [[P Q]|[[P Q]|[P Q]]]; auto; lia).
    assert (Same : forall l, changes s (s :: l) = changes s l). { intros l. destruct Hs as [-> | ->]; reflexivity. }
    assert (Flip : forall l, changes (- s) (s :: l) = S (changes s l)). { intros l. destruct Hs as [-> | ->]; reflexivity. }
    assert (Flip' : forall l, changes s ((- s)%Z :: l) = S (changes (- s) l)). { intros l. destruct Hs as [-> | ->]; reflexivity. }
    assert (Same' : forall l, changes (- s) ((- s)%Z :: l) = changes (- s) l). { intros l. destruct Hs as [-> | ->]; reflexivity. }
    assert (None : forall t l, changes t (0%Z :: l) = changes t l) by reflexivity.
    destruct Cx as [Cx|[Cx|Cx]].
    + specialize (X0 Cx). specialize (Zx X0). specialize (B (or_intror X0)). rewrite Cx, None. split.
      * intros Hb. rewrite <- Zx, Hb, Flip. lia.
      * intros [Hb|Hb]. rewrite <- Zx, Hb, Same. lia. rewrite <- Zx, Hb, sign_zero, None. lia.
    + rewrite Cx, Same. specialize (A Cx). specialize (B (or_introl Cx)). destruct Cy as [-> | [-> | ->]]; rewrite ?None, ?Same, ?Flip, ?Flip', ?Same'; split; intros; lia.
    + specialize (A' Cx). rewrite Cx, Flip'. split; intros Hb; rewrite (Opp Cx) by auto; rewrite ?Flip, ?Same; lia.
Qed.

Theorem count_root a g : 0 <= a -> (S (sign_count (signs g)) <= sign_count (signs (with_root a 0 g)))%nat.
Proof.
  intros [Ha|Ha].
  - induction g as [|x g IH]; cbn [with_root signs map]. rewrite sign_zero. unfold sign_count; simpl; lia.
    fold (signs g) (signs (with_root a x g)). destruct (sign_cases x) as [[-> Q]|Q].
    + rewrite Q. replace (0 + - a * 0) with 0 by ring. rewrite sign_zero. unfold sign_count in *. simpl. lia.
    + assert (S : exists s, (s = 1 \/ s = -1)%Z /\ sign_of x = s /\ sign_of (0 + - a * x) = (- s)%Z).
      { destruct Q as [[P Q]|[P Q]].
        - exists 1%Z. split; auto. split; auto. apply sign_negative. assert (0 < a * x) by (apply Rmult_lt_0_compat; auto). lra.
        - exists (-1)%Z. split; auto. split; auto. apply sign_positive. assert (0 < a * - x) by (apply Rmult_lt_0_compat; lra). lra. }
      destruct S as [s [Hs [Sx Sy]]]. rewrite Sx, Sy. destruct (changes_root a g Ha x s Hs) as [A _]. specialize (A Sx).
      unfold sign_count. destruct Hs as [-> | ->]; simpl in *; lia.
  - subst a. assert (E : forall b, signs (with_root 0 b g) = signs (b :: g)).
    { induction g as [|x g IH]; intros b; auto. cbn [with_root signs map]. f_equal. f_equal. ring. apply IH. }
    rewrite E. change (signs (0 :: g)) with (sign_of 0 :: signs g). rewrite sign_zero. unfold sign_count. cbn [low_zeros changes Z.eqb]. lia.
Qed.

Lemma changes_none l : forall s, (s = 1 \/ s = -1)%Z -> changes s (signs l) = O -> forall i, 0 <= IZR s * nth i l 0.
Proof.
  induction l as [|x l IH]; intros s Hs H i. destruct i; simpl; lra.
  cbn [signs map changes] in H. fold (signs l) in H. destruct (sign_cases x) as [[P Q]|[[P Q]|[P Q]]]; rewrite Q in H; simpl in H.
  - destruct i; simpl nth. rewrite P. lra. apply IH; auto.
  - destruct Hs as [-> | ->]; simpl in H; [|lia]. destruct i; simpl nth. lra. apply IH; auto.
  - destruct Hs as [-> | ->]; simpl in H; [lia|]. destruct i; simpl nth. lra. apply (IH (-1)%Z); auto.
Qed.

Lemma count_none l : l <> [] -> sign_count (signs l) = O -> exists s, (s = 1 \/ s = -1)%Z /\ 0 < IZR s * nth 0 l 0 /\ forall i, 0 <= IZR s * nth i l 0.
Proof.
  destruct l as [|x l]. congruence. intros _ H. unfold sign_count in H. cbn [signs map low_zeros changes] in H. fold (signs l) in H.
  destruct (sign_cases x) as [[P Q]|[[P Q]|[P Q]]]; rewrite Q in H; simpl in H; [lia| |].
  - exists 1%Z. split; auto. split. simpl. lra. intros i. destruct i; simpl nth. lra. apply (changes_none l 1); auto.
  - exists (-1)%Z. split; auto. split. simpl. lra. intros i. destruct i; simpl nth. lra. apply (changes_none l (-1)); auto.
Qed.

Theorem largest_zero low z l q : low <= z -> (forall i, (i < l)%nat -> nth i (pshift z q) 0 = 0) -> (l < length q)%nat ->
  (sign_count (signs (pshift low q)) <= l)%nat ->
  exists s, (s = 1 \/ s = -1)%Z /\ nonnegative (pshift z (pscal (IZR s) q)) /\ exists i, 0 < nth i (pshift z (pscal (IZR s) q)) 0.
Proof.
  intros Hz Order Hl Count. set (a := z - low). set (d := pshift z q) in *.
  assert (Ld : length d = length q) by apply length_pshift. set (e := skipn l d).
  assert (Ed : d = repeat 0 l ++ e).
  { rewrite <- (firstn_skipn l d) at 1. fold e. f_equal. assert (LF : length (firstn l d) = l) by (rewrite firstn_length; lia).
    apply (nth_ext _ _ 0 0). rewrite repeat_length; auto. intros i Hi. rewrite LF in Hi.
    rewrite nth_repeat. assert (N : nth i (firstn l d ++ skipn l d) 0 = 0) by (rewrite firstn_skipn; auto).
    rewrite app_nth1 in N by (rewrite LF; auto). auto. }
  assert (Back : pshift (- a) d = pshift low q) by (unfold d; rewrite pshift_pshift; f_equal; unfold a; lra).
  assert (More : (l + sign_count (signs (pshift (- a) e)) <= sign_count (signs (pshift (- a) d)))%nat).
  { rewrite Ed. assert (Ha : 0 <= a) by (unfold a; lra). revert Ha. clearbody a e. clear. intros Ha. induction l; cbn [repeat app]. lia.
    change (pshift (- a) (0 :: repeat 0 l ++ e)) with (padd (0 :: pshift (- a) (repeat 0 l ++ e)) (pscal (- a) (pshift (- a) (repeat 0 l ++ e)))).
    rewrite with_root_spec. eapply Nat.le_trans; [|apply count_root; auto]. lia. }
  rewrite Back in More. set (g := pshift (- a) e) in *.
  assert (Lg : g <> []).
  { intros E. apply (f_equal (@length R)) in E. unfold g, e in E. rewrite length_pshift, skipn_length in E. simpl in E. lia. }
  destruct (count_none g Lg ltac:(lia)) as [s [Hs [S0 S]]]. exists s. split; auto.
  assert (Ee : e = pshift a g). { unfold g. rewrite pshift_pshift. replace (a + - a) with 0 by ring. symmetry. apply pshift_none. }
  assert (Ng : nonnegative (pscal (IZR s) g)). { intros i. rewrite nth_pscal. auto. }
  assert (Ha : 0 <= a) by (unfold a; lra).
  assert (Ne := pshift_nonnegative a _ Ha Ng).
  assert (At : forall i, nth i (pshift z (pscal (IZR s) q)) 0 = IZR s * nth i d 0) by (intros; apply pshift_pscal). split.
  - intros i. rewrite At, Ed. destruct (lt_dec i l).
    + rewrite app_nth1 by (rewrite repeat_length; auto). rewrite nth_repeat. lra.
    + rewrite app_nth2; rewrite repeat_length; [|lia]. rewrite Ee, <- pshift_pscal. apply Ne.
  - destruct (Req_dec a 0) as [A|A].
    + exists l. rewrite At, Ed, app_nth2, repeat_length, Nat.sub_diag by (rewrite repeat_length; lia). rewrite Ee, A, pshift_none. auto.
    + exists l. rewrite At, Ed, app_nth2, repeat_length, Nat.sub_diag by (rewrite repeat_length; lia). rewrite Ee, <- pshift_pscal.
      apply pshift_first; auto. lra. exists O. rewrite nth_pscal. auto.
Qed.
