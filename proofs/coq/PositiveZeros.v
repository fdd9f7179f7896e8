(** * t > 0

    Section 3 of proofs/proofs/count_law.md: the pattern of Theta(., b) on t > 0, b in (m - 1, m), by induction on m:
    ceil(m/3) zeros, all simple, interlacing with those of Theta(., b - 1). *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus LaplaceIntegral WellPosed Family SignsAtZero MonotoneQuantity
  SignPattern.
Import ListNotations.
Open Scope R_scope.

(** ** Positive zeros of Theta(., b) *)

(** ceil(m/3) *)
Fixpoint positive_count (m : nat) : nat :=
  match m with
  | O => 0
  | S O => 1
  | S (S O) => 1
  | S (S (S k)) => S (positive_count k)
  end.

Lemma positive_count_ceil m : positive_count m = ((m + 2) / 3)%nat.
Proof.
induction m as [| | |m IH] using nat_ind3; try reflexivity.
change (S (S (S m)) + 2)%nat with (S (S (S (m + 2)))). rewrite div3_SSS, <- IH. reflexivity.
Qed.

Lemma sg_positive_count m :
  (sg m = 1 /\ sg (S m) = 1 /\ positive_count (S m) = S (positive_count m)) \/
  (sg m = 1 /\ sg (S m) = -1 /\ positive_count (S m) = positive_count m) \/
  (sg m = -1 /\ sg (S m) = 1 /\ positive_count (S m) = positive_count m).
Proof.
induction m as [| | |m IH] using nat_ind3; simpl; auto.
destruct IH as [(A & B & C)|[(A & B & C)|(A & B & C)]]; simpl in *; rewrite ?A, ?B, ?C; auto.
Qed.

Lemma opposite_at_infinity m b : cell (S m) b -> forall T, exists t, T < t /\ Th b t * Th (b - 1) t < 0.
Proof.
intros Hb T.
destruct (cell_S _ _ Hb) as [Hb1 _].
destruct (proj2 (Th_right (S m) b Hb) ltac:(lia) 1) as (T1 & HT1 & H1).
destruct (proj1 (Th_right m (b - 1) Hb1)) as (c & T2 & Hc & HT2 & H2).
set (t := Rmax (T + 1) (Rmax T1 T2)).
assert (Ht : T + 1 <= t) by apply Rmax_l.
assert (Ht1 : T1 <= t) by (eapply Rle_trans; [apply Rmax_l|apply Rmax_r]).
assert (Ht2 : T2 <= t) by (eapply Rle_trans; [apply Rmax_r|apply Rmax_r]).
exists t. split; [lra|].
specialize (H1 t Ht1). specialize (H2 t Ht2). simpl in H1.
set (e := (-1) ^ m) in *.
assert (He : e * e = 1).
{ unfold e. rewrite <- Rpow_mult_distr. replace (-1 * -1) with 1 by ring. apply pow1. }
assert (H : 0 < (-1 * e * Th b t) * (e * Th (b - 1) t)) by (apply Rmult_lt_0_compat; lra).
replace ((-1 * e * Th b t) * (e * Th (b - 1) t)) with (- ((e * e) * (Th b t * Th (b - 1) t))) in H by ring.
rewrite He in H. lra.
Qed.

(** The step with its interlacing: a new zero before the first old one iff m + 1 = 1 mod 3. *)
Theorem positive_step (m : nat) (b : R) (l : list R) : cell (S m) b ->
  pattern (Th (b - 1)) (fun t => - (b - 1) * Th (b - 1 - 1) t) (sg m) 0 l ->
  exists l', pattern (Th b) (fun t => - b * Th (b - 1) t) (sg (S m)) 0 l' /\
    ((sg m = 1 /\ sg (S m) = 1 /\ around l l') \/ (sg m * sg (S m) = -1 /\ after_each l l')).
Proof.
intros Hb Hl.
assert (Hn := cell_not_nat _ _ Hb).
destruct (cell_S _ _ Hb) as [Hb1 Hb0].
assert (S0 := sign_0 (S m) b Hb).
assert (Hval : forall c, 0 < c -> Th (b - 1) c = 0 ->
  0 < (- (b - 1) * Th (b - 1 - 1) c) * Th b c).
{ intros c Hc E. destruct m as [|m].
  - exfalso. assert (H := Th_pos (b - 1) c (cell_0 _ Hb1)). lra.
  - replace (b - 1 - 1) with (b - 2) by ring. apply (Th_next_at_zero m); auto. }
assert (Hinf := opposite_at_infinity m b Hb).
assert (Dh := fun t => Th_derive b t Hn).
destruct (sg_next m) as [[A B]|[[A B]|[A B]]]; rewrite A in Hl; rewrite B in S0 |- *.
+ destruct (step_tail b (Th (b - 1)) _ (Th b) Hb0 Dh Hval Hinf l 1 0 (Rle_refl 0) Hl S0) as (l' & El' & Hl').
  exists l'. split; auto.
+ destruct (step_head b (Th (b - 1)) _ (Th b) Hb0 Dh Hval Hinf l 1 Hl) as (l' & El' & Hl').
  { replace (- (1)) with (-1) by ring. lra. }
  exists l'. split; auto. right. split; auto. rewrite A; ring.
+ destruct (step_head b (Th (b - 1)) _ (Th b) Hb0 Dh Hval Hinf l (-1) Hl) as (l' & El' & Hl').
  { replace (- -1) with 1 by ring. lra. }
  exists l'. replace (- -1) with 1 in Hl' by ring. split; auto. right. split; auto. rewrite A; ring.
Qed.

Theorem positive_zeros (m : nat) : forall b, cell m b ->
  exists l, length l = positive_count m /\ pattern (Th b) (fun t => - b * Th (b - 1) t) (sg m) 0 l.
Proof.
induction m as [|m IH]; intros b Hb.
- exists []. split; auto. simpl. intros t _. rewrite Rmult_1_l. apply Th_pos, cell_0, Hb.
- destruct (IH (b - 1) (proj1 (cell_S _ _ Hb))) as (l & El & Hl).
  destruct (positive_step m b l Hb Hl) as (l' & Hl' & Hi).
  exists l'. split; auto.
  destruct (sg_positive_count m) as [(A & B & C)|[(A & B & C)|(A & B & C)]]; rewrite A, B in Hi; rewrite C;
  destruct Hi as [(A' & B' & [E _])|(A' & [E _])]; try lra; congruence.
Qed.
