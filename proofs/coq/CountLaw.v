(** * The number of real zeros of dTheta/dtau

    The two sides together: the theorem of proofs/proofs/count_law.md with signs, and the interlacing of its section
    5. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus LaplaceIntegral WellPosed Family SignsAtZero MonotoneQuantity SignPattern
  NegativeZeros PositiveZeros.
Import ListNotations.
Open Scope R_scope.

(** one negative zero if m = 2 mod 3 *)
Definition negative_count (m : nat) : nat := if Nat.eqb (m mod 3) 2 then 1 else 0.

Lemma negative_count_sg m : (sg m = 1 /\ negative_count m = 0%nat) \/ (sg m = -1 /\ negative_count m = 1%nat).
Proof. rewrite sg_mod. unfold negative_count. destruct (Nat.eqb (m mod 3) 2); auto. Qed.

Lemma negative_positive_count m : (negative_count m + positive_count m = m mod 3 + m / 3)%nat.
Proof.
induction m as [| | |m IH] using nat_ind3; try reflexivity.
unfold negative_count in *. rewrite mod3_SSS, div3_SSS.
change (positive_count (S (S (S m)))) with (S (positive_count m)). lia.
Qed.

(** The zeros of Theta(., b), b in (m - 1, m). *)
Theorem Th_zeros (m : nat) (b : R) : cell m b ->
  exists ln lp, length ln = negative_count m /\ length lp = positive_count m /\
    (forall c, In c ln -> c < 0) /\ (forall c, In c lp -> 0 < c) /\
    line_pattern (Th b) (fun t => - b * Th (b - 1) t) 1 (ln ++ lp).
Proof.
intros Hb.
destruct (positive_zeros m b Hb) as (lp & Ep & Hp).
assert (Hpos := pattern_lt _ _ _ _ _ Hp).
destruct (left_side m b Hb) as [L0 L1].
destruct (negative_count_sg m) as [[A B]|[A B]]; rewrite A in Hp; rewrite B.
- specialize (L0 A). exists [], lp. repeat split; auto.
  + simpl; tauto.
  + simpl app. destruct lp as [|c lp]; simpl in *.
    * intros t. destruct (Rle_lt_dec t 0) as [Ht|Ht]; [rewrite Rmult_1_l; apply L0|apply Hp]; auto.
    * destruct Hp as (H1 & H2 & H3). refine (conj _ H3).
      intros t Ht. destruct (Rle_lt_dec t 0) as [Ht0|Ht0]; [rewrite Rmult_1_l; apply L0|apply H2]; auto.
- destruct (L1 A) as (c & Hc & H1 & H2 & H3 & H4). exists [c], lp. repeat split; auto.
  + simpl. intros x [<-|[]]; auto.
  + intros t Ht; rewrite Rmult_1_l; auto.
  + rewrite Rmult_1_l; exact H3.
  + change ([] ++ lp) with lp. replace (- (1)) with (-1) by ring.
    apply (pattern_glue _ _ (-1) c 0); auto.
    intros t Ht. specialize (H4 t Ht). lra.
Qed.

(** ** The theorem, with all details.
    For m < b < m + 1: Theta' has the zeros ln ++ lp and no others, in increasing order; ln are the
    negative ones (one if m = 2 mod 3, otherwise none), lp the positive ones (their number is ceil(m/3));
    Theta' < 0 before the first one; Theta'' has the sign (-1)^i at the i-th (i = 0, 1, ...). *)
Theorem count_law_full (m : nat) (b : R) (theta : R -> R) :
  INR m < b < INR m + 1 -> is_Theta b theta ->
  exists ln lp : list R,
    length ln = (if Nat.eqb (m mod 3) 2 then 1 else 0)%nat /\
    length lp = ((m + 2) / 3)%nat /\
    length (ln ++ lp) = (m mod 3 + m / 3)%nat /\
    (forall t, In t ln -> t < 0) /\ (forall t, In t lp -> 0 < t) /\
    StronglySorted Rlt (ln ++ lp) /\
    (forall t, Derive theta t = 0 <-> In t (ln ++ lp)) /\
    (forall i, (i < length (ln ++ lp))%nat -> 0 < (-1) ^ i * Derive_n theta 2 (nth i (ln ++ lp) 0)) /\
    (forall t, (forall c, In c (ln ++ lp) -> t < c) -> Derive theta t < 0) /\
    line_pattern (Derive theta) (Derive_n theta 2) (-1) (ln ++ lp).
Proof.
intros Hb H.
assert (Hc : cell (S m) b) by (unfold cell; rewrite S_INR; lra).
assert (Hn := cell_not_nat _ _ Hc).
destruct (cell_S _ _ Hc) as [Hc1 Hb0].
assert (Hn1 := cell_not_nat _ _ Hc1).
destruct (Th_zeros m (b - 1) Hc1) as (ln & lp & En & Ep & Hln & Hlp & HA).
assert (HA' : line_pattern (Derive theta) (Derive_n theta 2) (-1) (ln ++ lp)).
{ apply (line_pattern_scal (Th (b - 1)) (fun t => - (b - 1) * Th (b - 1 - 1) t) _ _ (- b) 1); auto.
  - lra.
  - apply (Theta_derive b theta (Th (b - 1)) Hn H (Th_correct _)).
  - intros t. rewrite (Theta_derive_n 2 b theta (Th (b - INR 2)) Hn H (Th_correct _)).
    replace (b - INR 2) with (b - 1 - 1) by (simpl; ring). simpl. ring. }
exists ln, lp.
refine (conj En (conj _ (conj _ (conj Hln (conj Hlp (conj _ (conj _ (conj _ (conj _ HA'))))))))).
- rewrite Ep. apply positive_count_ceil.
- rewrite app_length, En, Ep. apply negative_positive_count.
- apply (line_pattern_sorted _ _ _ _ HA').
- apply (line_pattern_zeros _ _ _ _ HA').
- intros i Hi. assert (Hs := line_pattern_simple _ _ _ _ HA' i Hi). lra.
- intros t Ht. assert (Hs := line_pattern_before _ _ _ _ HA' t Ht). lra.
Qed.

(** ** The count law, in the short form. *)
Theorem count_law (m : nat) (b : R) (theta : R -> R) :
  INR m < b < INR m + 1 -> is_Theta b theta ->
  exists l : list R,
    length l = (m mod 3 + m / 3)%nat /\
    StronglySorted Rlt l /\
    (forall t, Derive theta t = 0 <-> In t l) /\
    (forall t, In t l -> Derive_n theta 2 t <> 0).
Proof.
intros Hb H.
destruct (count_law_full m b theta Hb H) as (ln & lp & _ & _ & E & _ & _ & Hs & Hz & Hd & _).
exists (ln ++ lp). refine (conj E (conj Hs (conj Hz _))).
intros t Ht E0.
destruct (In_nth (ln ++ lp) t 0 Ht) as (i & Hi & Ei).
specialize (Hd i Hi). rewrite Ei, E0 in Hd. lra.
Qed.

(** ** Interlacing (section 5 of proofs/count_law.md), in a sharper form: which of the two patterns it is. *)
Lemma sg_out m : (sg m = 1 /\ sg (S m) = 1) <-> (S m mod 3 = 1)%nat.
Proof.
induction m as [| | |m IH] using nat_ind3.
- simpl; tauto.
- simpl. split; [lra|discriminate].
- simpl. split; [lra|discriminate].
- rewrite mod3_SSS. exact IH.
Qed.

Theorem interlacing (m : nat) (b : R) (theta theta1 : R -> R) :
  INR (S m) < b < INR (S m) + 1 -> is_Theta b theta -> is_Theta (b - 1) theta1 ->
  exists c z : list R, StronglySorted Rlt c /\ StronglySorted Rlt z /\
    (forall t, 0 < t /\ Derive theta1 t = 0 <-> In t c) /\
    (forall t, 0 < t /\ Derive theta t = 0 <-> In t z) /\
    if Nat.eqb (S m mod 3) 1 then around c z else after_each c z.
Proof.
intros Hb H H1.
assert (Hc : cell (S (S m)) b) by (unfold cell; rewrite (S_INR (S m)); lra).
assert (Hn := cell_not_nat _ _ Hc).
destruct (cell_S _ _ Hc) as [Hc1 Hb0].
assert (Hn1 := cell_not_nat _ _ Hc1).
destruct (cell_S _ _ Hc1) as [Hc2 Hb1].
destruct (positive_zeros m (b - 1 - 1) Hc2) as (c & Ec & Hac).
destruct (positive_step m (b - 1) c Hc1 Hac) as (z & Haz & Hi).
exists c, z.
refine (conj (pattern_sorted _ _ _ _ _ Hac) (conj (pattern_sorted _ _ _ _ _ Haz) (conj _ (conj _ _)))).
- intros t. rewrite (Theta_derive (b - 1) theta1 (Th (b - 1 - 1)) Hn1 H1 (Th_correct _)).
  split.
  + intros [Ht E]. apply (pattern_zeros _ _ _ _ _ Hac t Ht).
    apply Rmult_integral in E. destruct E; [lra|auto].
  + intros Ht. assert (Ht0 := pattern_lt _ _ _ _ _ Hac t Ht). split; auto.
    rewrite (proj2 (pattern_zeros _ _ _ _ _ Hac t Ht0) Ht). ring.
- intros t. rewrite (Theta_derive b theta (Th (b - 1)) Hn H (Th_correct _)).
  split.
  + intros [Ht E]. apply (pattern_zeros _ _ _ _ _ Haz t Ht).
    apply Rmult_integral in E. destruct E; [lra|auto].
  + intros Ht. assert (Ht0 := pattern_lt _ _ _ _ _ Haz t Ht). split; auto.
    rewrite (proj2 (pattern_zeros _ _ _ _ _ Haz t Ht0) Ht). ring.
- assert (Hso := sg_out m).
  destruct (Nat.eqb_spec (S m mod 3) 1) as [E|E]; destruct Hi as [(A & B & Hi)|(A & Hi)]; auto; exfalso.
  + apply Hso in E. destruct E as [E1 E2]. rewrite E1, E2 in A. lra.
  + apply E, Hso. auto.
Qed.
