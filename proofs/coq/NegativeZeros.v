(** * t <= 0

    Section 1 of proofs/proofs/count_law.md: on t <= 0 Theta(., b), b in (m - 1, m), is positive if m = 0 or 1 mod 3,
    and has exactly one zero, simple, if m = 2 mod 3. Induction on m with Theta' = -b Theta(., b - 1). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus LaplaceIntegral Family SignsAtZero SignPattern.
Open Scope R_scope.

(** ** t <= 0 *)
Definition left_0 (b : R) : Prop := forall t, t <= 0 -> 0 < Th b t.

Definition left_1 (b : R) : Prop := exists c, c < 0 /\ (forall t, t < c -> 0 < Th b t) /\ Th b c = 0 /\
  - b * Th (b - 1) c < 0 /\ forall t, c < t <= 0 -> Th b t < 0.

Lemma step_0 b : not_nat b -> 0 < b -> left_0 (b - 1) -> 0 < Th b 0 -> left_0 b.
Proof.
intros Hn Hb H H0 t Ht.
destruct (Rle_lt_or_eq_dec t 0 Ht) as [Ht0| ->]; auto.
destruct (mvt_open (Th b) (fun t => - b * Th (b - 1) t) t 0 Ht0 (fun s _ => Th_derive b s Hn))
  as (d & Hd & E).
specialize (H d ltac:(lra)).
assert (0 < b * Th (b - 1) d * (0 - t)).
{ apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; auto. }
lra.
Qed.

(** F_b is convex and decreasing on t <= 0, so it is positive far to the left: no asymptotics needed. *)
Lemma step_1 b : not_nat b -> 1 < b -> left_0 (b - 2) -> left_0 (b - 1) -> Th b 0 < 0 -> left_1 b.
Proof.
intros Hn Hb HL2 H H0.
assert (Hn1 := not_nat_pred b Hn).
assert (Hdn : forall t, t <= 0 -> - b * Th (b - 1) t < 0).
{ intros t Ht. specialize (H t Ht).
  assert (0 < b * Th (b - 1) t) by (apply Rmult_lt_0_compat; lra). lra. }
assert (Hcv : forall t, t < 0 -> Th (b - 1) 0 <= Th (b - 1) t).
{ intros t Ht.
  destruct (mvt_open (Th (b - 1)) (fun t => - (b - 1) * Th (b - 1 - 1) t) t 0 Ht
    (fun s _ => Th_derive (b - 1) s Hn1)) as (d & Hd & E).
  assert (Hp := HL2 d ltac:(lra)). replace (b - 1 - 1) with (b - 2) in E by ring.
  assert (0 < (b - 1) * Th (b - 2) d * (0 - t)).
  { apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; lra. }
  lra. }
set (k := b * Th (b - 1) 0).
assert (Hk : 0 < k) by (apply Rmult_lt_0_compat; [lra|apply H; lra]).
set (T := - ((1 - Th b 0) / k)).
assert (HT : T < 0).
{ unfold T. assert (0 < (1 - Th b 0) / k) by (apply Rdiv_lt_0_compat; lra). lra. }
assert (HTm : 0 < Th b T).
{ destruct (mvt_open (Th b) (fun t => - b * Th (b - 1) t) T 0 HT (fun s _ => Th_derive b s Hn))
    as (d & Hd & E).
  assert (Hp := Hcv d ltac:(lra)).
  assert (k * (0 - T) <= b * Th (b - 1) d * (0 - T)).
  { apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; lra. }
  replace (k * (0 - T)) with (1 - Th b 0) in H1 by (unfold T; field; lra).
  lra. }
destruct (cross (Th b) (fun t => - b * Th (b - 1) t) 1 T 0) as (z & Hz & Ez & Hz1 & Hz2).
- intros t. apply Th_derive, Hn.
- lra.
- intros t Ht. rewrite Rmult_1_l. apply Hdn; lra.
- lra.
- lra.
- exists z. refine (conj (proj2 Hz) (conj _ (conj Ez (conj _ _)))).
  + intros t Ht.
    destruct (mvt_open (Th b) (fun t => - b * Th (b - 1) t) t z Ht (fun s _ => Th_derive b s Hn))
      as (d & Hd & E).
    specialize (Hdn d ltac:(lra)). rewrite Ez in E.
    assert (0 < - (- b * Th (b - 1) d) * (z - t)) by (apply Rmult_lt_0_compat; lra). lra.
  + apply Hdn; lra.
  + intros t Ht. specialize (Hz2 t Ht). lra.
Qed.

Lemma step_2 b : not_nat b -> 2 < b -> left_1 (b - 1) -> left_0 (b - 3) -> left_0 b.
Proof.
intros Hn Hb (c & Hc & H1 & H2 & _ & H4) H3.
assert (Hv : 0 < Th b c).
{ rewrite (Th_rec b c Hn), H2. specialize (H3 c ltac:(lra)).
  assert (0 < (b - 1) * (b - 2) * Th (b - 3) c) by (apply Rmult_lt_0_compat; auto; nra). lra. }
assert (D := fun s => Th_derive b s Hn).
intros t Ht.
destruct (Rtotal_order t c) as [Htc|[->|Htc]]; auto.
- destruct (mvt_open (Th b) (fun t => - b * Th (b - 1) t) t c Htc (fun s _ => D s)) as (d & Hd & E).
  specialize (H1 d ltac:(lra)).
  assert (0 < b * Th (b - 1) d * (c - t)).
  { apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; lra. }
  lra.
- destruct (mvt_open (Th b) (fun t => - b * Th (b - 1) t) c t Htc (fun s _ => D s)) as (d & Hd & E).
  specialize (H4 d ltac:(lra)).
  assert (0 < b * - Th (b - 1) d * (t - c)).
  { apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; lra. }
  lra.
Qed.

Theorem left_side (m : nat) : forall b, cell m b ->
  (sg m = 1 -> left_0 b) /\ (sg m = -1 -> left_1 b).
Proof.
induction m as [m IH] using lt_wf_ind; intros b Hb.
destruct m as [|m].
- split; [|simpl; lra]. intros _ t _. apply Th_pos, cell_0, Hb.
- assert (Hn := cell_not_nat _ _ Hb).
  destruct (cell_S _ _ Hb) as [Hb1 Hb0].
  assert (S0 := sign_0 (S m) b Hb).
  destruct (IH m ltac:(lia) (b - 1) Hb1) as [I0 I1].
  destruct (sg_next m) as [[A B]|[[A B]|[A B]]]; rewrite B in S0 |- *;
    [split; [intros _|lra]|split; [lra|intros _]|split; [intros _|lra]].
  + apply step_0; auto. lra.
  + destruct m as [|m]; [simpl in B; lra|].
    assert (Hb2 : cell m (b - 2)) by (unfold cell in *; rewrite !S_INR in Hb; lra).
    destruct (IH m ltac:(lia) (b - 2) Hb2) as [J0 _].
    apply step_1; auto.
    * unfold cell in Hb; rewrite !S_INR in Hb. generalize (pos_INR m); lra.
    * apply J0. apply (sg_prev2 m), B.
    * lra.
  + destruct m as [|[|m]]; [simpl in A; lra|simpl in A; lra|].
    destruct (sg_prev2 m A) as [A0 _].
    assert (Hb3 : cell m (b - 3)) by (unfold cell in *; rewrite !S_INR in Hb; lra).
    destruct (IH m ltac:(lia) (b - 3) Hb3) as [J0 _].
    apply step_2; auto.
    unfold cell in Hb; rewrite !S_INR in Hb. generalize (pos_INR m); lra.
Qed.
