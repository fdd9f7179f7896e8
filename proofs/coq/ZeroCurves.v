(** * The zeros move continuously with b

    Section 5 of proofs/proofs/count_law.md: signs at the ends of small brackets around the zeros stay what they are for
    b nearby; so each bracket still holds a zero, and by the count there are no others. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus Family SignsAtZero SignPattern PositiveZeros CountLaw IntegerPolynomials
  ContinuityInBeta.
Import ListNotations.
Open Scope R_scope.

(** ** Sorted lists *)
Lemma sorted_NoDup (l : list R) : StronglySorted Rlt l -> NoDup l.
Proof.
induction 1 as [|a l Hs IH Hf]; constructor; auto.
intros Hin. rewrite Forall_forall in Hf. specialize (Hf a Hin). lra.
Qed.

Lemma sorted_unique (l1 : list R) : forall l2, StronglySorted Rlt l1 -> StronglySorted Rlt l2 ->
  (forall x, In x l1 <-> In x l2) -> l1 = l2.
Proof.
induction l1 as [|a l1 IH]; intros [|c l2] H1 H2 E; auto.
- exfalso. apply (E c). left; auto.
- exfalso. apply (E a). left; auto.
- inversion H1 as [|? ? S1 F1]; subst. inversion H2 as [|? ? S2 F2]; subst.
  rewrite Forall_forall in F1, F2.
  assert (Eac : a = c).
  { assert (Ha : In a (c :: l2)) by (apply E; left; auto).
    assert (Hc : In c (a :: l1)) by (apply E; left; auto).
    destruct Ha as [Ha|Ha]; auto. destruct Hc as [Hc|Hc]; auto.
    specialize (F1 c Hc). specialize (F2 a Ha). lra. }
  subst c. f_equal. apply IH; auto.
  intros x. split; intros Hx.
  + assert (H : In x (a :: l2)) by (apply E; right; auto).
    destruct H as [H|H]; auto. specialize (F1 x Hx). lra.
  + assert (H : In x (a :: l1)) by (apply E; right; auto).
    destruct H as [H|H]; auto. specialize (F2 x Hx). lra.
Qed.

Lemma sorted_incl_eq (l1 l2 : list R) : StronglySorted Rlt l1 -> StronglySorted Rlt l2 ->
  length l1 = length l2 -> incl l1 l2 -> l1 = l2.
Proof.
intros H1 H2 E Hi. apply sorted_unique; auto.
intros x. split; [apply Hi|].
apply (NoDup_length_incl (sorted_NoDup _ H1)); auto. rewrite E. apply le_n.
Qed.

(** ** Brackets around the zeros *)
Fixpoint brackets (f : R -> R) (s a eps : R) (l : list R) (br : list (R * R)) : Prop :=
  match l, br with
  | [], [] => True
  | c :: l', (x, y) :: br' =>
      a < x < c /\ c < y /\ c - x < eps /\ y - c < eps /\ 0 < s * f x /\ 0 < - s * f y
      /\ brackets f (- s) y eps l' br'
  | _, _ => False
  end.

Lemma brackets_exists f f' eps l : 0 < eps -> forall s a, pattern f f' s a l -> exists br, brackets f s a eps l br.
Proof.
intros He. induction l as [|c l IH]; intros s a H; simpl in H.
- exists []. exact I.
- destruct H as (H1 & H2 & H3 & H4 & H5).
  set (x := Rmax ((a + c) / 2) (c - eps / 2)).
  assert (X1 := Rmax_l ((a + c) / 2) (c - eps / 2)). assert (X2 := Rmax_r ((a + c) / 2) (c - eps / 2)).
  assert (X3 : x < c) by (apply Rmax_lub_lt; lra). fold x in X1, X2.
  assert (Hy : exists y, c < y /\ y - c < eps /\ 0 < - s * f y /\ pattern f f' (- s) y l).
  { destruct l as [|c2 l]; simpl in H5.
    - exists (c + eps / 2). repeat split; try lra. apply H5; lra.
      simpl. intros t Ht; apply H5; lra.
    - destruct H5 as (K1 & K2 & K3 & K4 & K5).
      set (y := Rmin ((c + c2) / 2) (c + eps / 2)).
      assert (Y1 := Rmin_l ((c + c2) / 2) (c + eps / 2)). assert (Y2 := Rmin_r ((c + c2) / 2) (c + eps / 2)).
      assert (Y3 : c < y) by (apply Rmin_glb_lt; lra). fold y in Y1, Y2.
      exists y. repeat split; try lra; auto. apply K2; lra.
      intros t Ht; apply K2; lra. }
  destruct Hy as (y & Y1 & Y2 & Y3 & Y4).
  destruct (IH (- s) y Y4) as [br Hbr].
  exists ((x, y) :: br). simpl. repeat split; auto; try lra. apply H2; lra.
Qed.

(** each bracket holds a zero *)
Lemma brackets_zeros f df eps l : (forall t, is_derive f t (df t)) ->
  forall s a br, brackets f s a eps l br ->
  exists xs, length xs = length l /\ StronglySorted Rlt xs /\ (forall x, In x xs -> a < x /\ f x = 0) /\
    forall i, (i < length l)%nat -> Rabs (nth i xs 0 - nth i l 0) < eps.
Proof.
intros D. induction l as [|c l IH]; intros s a [|[x y] br] H; simpl in H; try tauto.
- exists []. repeat split; simpl in *; try tauto. constructor. intros; lia.
- destruct H as ((H1 & H2) & H3 & H4 & H5 & H6 & H7 & H8).
  destruct (IH (- s) y br H8) as (xs & E & Hs & Hz & Hn).
  assert (DS : forall t, is_derive (fun t => - s * f t) t (- s * df t)).
  { intros t. apply (is_derive_scal f), D. }
  destruct (IVT (fun t => - s * f t) x y) as [z [Hxy Ez]].
  + apply (derive_continuity _ _ DS).
  + lra.
  + lra.
  + exact H7.
  + assert (Hs0 : s <> 0) by (intros ->; lra).
    assert (Ef : f z = 0).
    { apply Rmult_integral in Ez. destruct Ez as [Ez|Ez]; auto. exfalso; apply Hs0; lra. }
    assert (Hzx : x < z).
    { destruct (Rle_lt_or_eq_dec x z (proj1 Hxy)) as [K|K]; auto. rewrite K, Ef in H6. lra. }
    exists (z :: xs). repeat split.
    * simpl; congruence.
    * constructor; auto. apply Forall_forall. intros u Hu. destruct (Hz u Hu). lra.
    * destruct H as [<-|H]; [lra|]. destruct (Hz _ H). lra.
    * destruct H as [<-|H]; auto. apply Hz, H.
    * intros [|i] Hi; simpl in *.
      -- apply Rabs_def1; lra.
      -- apply Hn. lia.
Qed.

(** brackets stay brackets for b near b0 *)
Lemma sign_open b0 t s : not_nat b0 -> 0 < s * Th b0 t -> locally b0 (fun b => 0 < s * Th b t).
Proof.
intros Hb Hs.
assert (HL := is_lim_scal_l (fun b => Th b t) s b0 (Th b0 t) (Th_lim_not_nat b0 t Hb)).
simpl in HL. apply is_lim_spec in HL. destruct (HL (mkposreal _ Hs)) as [d Hd].
exists d. intros y Hy.
destruct (Req_dec y b0) as [->|Hne]; auto.
specialize (Hd y Hy Hne). simpl in Hd. apply Rabs_def2 in Hd. lra.
Qed.

Lemma brackets_open b0 eps l : not_nat b0 -> forall s a br, brackets (Th b0) s a eps l br ->
  locally b0 (fun b => brackets (Th b) s a eps l br).
Proof.
intros Hb. induction l as [|c l IH]; intros s a [|[x y] br] H; simpl in H; try tauto.
- exists (mkposreal _ Rlt_0_1). intros; exact I.
- destruct H as (H1 & H3 & H4 & H5 & H6 & H7 & H8).
  generalize (filter_and _ _ (sign_open b0 x s Hb H6)
    (filter_and _ _ (sign_open b0 y (- s) Hb H7) (IH (- s) y br H8))).
  apply filter_imp. intros b (K1 & K2 & K3). simpl. repeat split; auto; lra.
Qed.

(** The list of the zeros of Theta'(., b), in increasing order. *)
Definition zero_list (b : R) (l : list R) : Prop :=
  StronglySorted Rlt l /\ forall t, Derive (Th b) t = 0 <-> In t l.

Lemma zero_list_unique b l1 l2 : zero_list b l1 -> zero_list b l2 -> l1 = l2.
Proof.
intros [S1 Z1] [S2 Z2]. apply sorted_unique; auto. intros x. rewrite <- Z1, <- Z2. tauto.
Qed.

Theorem zero_list_exists (m : nat) (b : R) : INR m < b < INR m + 1 ->
  exists l, zero_list b l /\ length l = (m mod 3 + m / 3)%nat.
Proof.
intros Hb. destruct (count_law m b (Th b) Hb (Th_correct b)) as (l & E & S & Z & _).
exists l. split; [split; auto|exact E].
Qed.

Theorem zeros_continuous (m : nat) (b0 : R) (l0 : list R) (eps : R) :
  INR m < b0 < INR m + 1 -> zero_list b0 l0 -> 0 < eps ->
  exists delta, 0 < delta /\ forall b l, Rabs (b - b0) < delta -> zero_list b l ->
    length l = length l0 /\
    forall i, (i < length l0)%nat -> Rabs (nth i l 0 - nth i l0 0) < eps.
Proof.
intros Hb0 H0 He.
assert (Hc0 : cell m (b0 - 1)) by (unfold cell; lra).
assert (Hn0 := cell_not_nat _ _ Hc0).
destruct (Th_zeros m (b0 - 1) Hc0) as (ln & lp & En & Ep & _ & _ & HA).
set (N := ln ++ lp) in *.
assert (Hm0 : 0 <= INR m) by apply pos_INR.
(* the zeros of Theta' and of Theta(., b - 1) are the same *)
assert (Hsame : forall b, INR m < b < INR m + 1 -> forall t, Derive (Th b) t = 0 <-> Th (b - 1) t = 0).
{ intros b Hb t.
  assert (Hn : not_nat b) by (apply (cell_not_nat (S m)); unfold cell; rewrite S_INR; lra).
  rewrite (is_derive_unique _ _ _ (Th_derive b t Hn)). split.
  - intros E. apply Rmult_integral in E. destruct E; auto; lra.
  - intros ->. ring. }
assert (E0 : l0 = N).
{ destruct H0 as [S0 Z0]. apply sorted_unique; auto.
  - apply (line_pattern_sorted _ _ _ _ HA).
  - intros x. rewrite <- Z0, (Hsame b0 Hb0). apply (line_pattern_zeros _ _ _ _ HA). }
destruct (list_lower N 0) as (a & _ & Ha).
destruct (brackets_exists _ _ eps N He 1 a (line_pattern_alt _ _ _ _ _ Ha HA)) as [br Hbr].
destruct (brackets_open (b0 - 1) eps N Hn0 1 a br Hbr) as [d Hd].
set (delta := Rmin d (Rmin (b0 - INR m) (INR m + 1 - b0))).
assert (Hdl : 0 < delta).
{ apply Rmin_pos; [apply cond_pos|apply Rmin_pos; lra]. }
exists delta. split; auto. intros b l Hbb Hl.
assert (D1 := Rlt_le_trans _ _ _ Hbb (Rmin_l _ _)).
assert (D2 := Rlt_le_trans _ _ _ Hbb (Rle_trans _ _ _ (Rmin_r _ _) (Rmin_l _ _))).
assert (D3 := Rlt_le_trans _ _ _ Hbb (Rle_trans _ _ _ (Rmin_r _ _) (Rmin_r _ _))).
apply Rabs_def2 in D2. apply Rabs_def2 in D3.
assert (Hb : INR m < b < INR m + 1) by lra.
assert (Hbk : brackets (Th (b - 1)) 1 a eps N br).
{ apply Hd. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl.
  replace (b - 1 + - (b0 - 1)) with (b - b0) by ring. exact D1. }
assert (Hn1 : not_nat (b - 1)) by (apply (cell_not_nat m); unfold cell; lra).
destruct (brackets_zeros (Th (b - 1)) _ eps N (fun t => Th_derive (b - 1) t Hn1) 1 a br Hbk)
  as (xs & Ex & Sx & Zx & Nx).
assert (EN : length N = (m mod 3 + m / 3)%nat).
{ unfold N. rewrite app_length, En, Ep. apply negative_positive_count. }
destruct (zero_list_exists m b Hb) as (l' & Hl' & El').
assert (l = l') by (apply (zero_list_unique b); auto). subst l'.
assert (Exl : xs = l).
{ apply sorted_incl_eq; auto. apply Hl. congruence.
  intros x Hx. apply Hl, (Hsame b Hb), Zx, Hx. }
subst xs. rewrite E0. split; auto.
Qed.
