(** * The tail of a Taylor series at any point

    The tail lemma of proofs/check.md: the coefficients of a solution at t0 satisfy a recurrence of three terms; with
    a_k = |c_k| s^k each is at most q times the greater of two before it, q decreasing in k, so blocks of three decrease
    like q^m. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement.
Open Scope R_scope.

Section Tail.
Variables (b t0 s B : R) (c : nat -> R) (I : nat).
Hypothesis Hs : 0 < s.
Hypothesis HB : 1 <= B.
Hypothesis Hb : Rabs b <= B.
Hypothesis Hc : forall k, (INR k + 1) * (INR k + 2) * (INR k + 3) * c (k + 3)%nat
  = t0 * (INR k + 1) * c (k + 1)%nat + (INR k - b) * c k.

Definition size (k : nat) : R := Rabs (c k) * s ^ k.
Definition ratio (i : nat) : R := Rabs t0 * s ^ 2 / ((INR i + 2) * (INR i + 3))
  + (INR i + B) * s ^ 3 / ((INR i + 1) * (INR i + 2) * (INR i + 3)).

Lemma size_pos k : 0 <= size k.
Proof. apply Rmult_le_pos. apply Rabs_pos. apply pow_le; lra. Qed.

Lemma size_step k : size (k + 3) <= ratio k * Rmax (size (k + 1)) (size k).
Proof.
assert (Hk := pos_INR k).
set (D := (INR k + 1) * (INR k + 2) * (INR k + 3)).
assert (HD : 0 < D) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
assert (M1 := Rmax_l (size (k + 1)) (size k)). assert (M2 := Rmax_r (size (k + 1)) (size k)).
set (mu := Rmax (size (k + 1)) (size k)) in *.
assert (Hs2 : 0 < s ^ 2) by (apply pow_lt, Hs). assert (Hs3 : 0 < s ^ 3) by (apply pow_lt, Hs).
assert (E : D * size (k + 3) = Rabs (t0 * (INR k + 1) * c (k + 1)%nat + (INR k - b) * c k) * s ^ (k + 3)).
{ unfold size. rewrite <- Hc. fold D. rewrite Rabs_mult, (Rabs_pos_eq D) by lra. ring. }
assert (T1 : Rabs (t0 * (INR k + 1) * c (k + 1)%nat) * s ^ (k + 3) = Rabs t0 * s ^ 2 * (INR k + 1) * size (k + 1)).
{ unfold size. rewrite !Rabs_mult, (Rabs_pos_eq (INR k + 1)) by lra. rewrite !pow_add. ring. }
assert (T2 : Rabs ((INR k - b) * c k) * s ^ (k + 3) <= (INR k + B) * s ^ 3 * size k).
{ rewrite Rabs_mult. unfold size. rewrite pow_add.
  assert (Hkb : Rabs (INR k - b) <= INR k + B).
  { eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp, (Rabs_pos_eq (INR k)) by lra. lra. }
  replace (Rabs (INR k - b) * Rabs (c k) * (s ^ k * s ^ 3)) with (Rabs (INR k - b) * (s ^ 3 * (Rabs (c k) * s ^ k)))
    by ring.
  replace ((INR k + B) * s ^ 3 * (Rabs (c k) * s ^ k)) with ((INR k + B) * (s ^ 3 * (Rabs (c k) * s ^ k))) by ring.
  apply Rmult_le_compat_r; auto. apply Rmult_le_pos. lra. apply (size_pos k). }
assert (Hsum : D * size (k + 3) <= (Rabs t0 * s ^ 2 * (INR k + 1) + (INR k + B) * s ^ 3) * mu).
{ rewrite E. eapply Rle_trans. apply Rmult_le_compat_r. apply pow_le; lra. apply Rabs_triang.
  rewrite Rmult_plus_distr_r, T1, Rmult_plus_distr_r. apply Rplus_le_compat.
  - apply Rmult_le_compat_l; auto. apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; [apply Rabs_pos|lra].
  - eapply Rle_trans; [exact T2|]. apply Rmult_le_compat_l; auto. apply Rmult_le_pos; lra. }
apply Rmult_le_reg_l with D; auto. eapply Rle_trans; [exact Hsum|].
right. unfold ratio, D. field. lra.
Qed.

Lemma ratio_pos i : 0 <= ratio i.
Proof.
assert (Hi := pos_INR i). unfold ratio. apply Rplus_le_le_0_compat; apply Rmult_le_pos.
- apply Rmult_le_pos; [apply Rabs_pos|apply pow_le; lra].
- apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; lra.
- apply Rmult_le_pos; [lra|apply pow_le; lra].
- apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra.
Qed.

Lemma ratio_decreases i k : (i <= k)%nat -> ratio k <= ratio i.
Proof.
intros Hik. apply le_INR in Hik. assert (Hi := pos_INR i). unfold ratio.
set (x := INR i) in *. set (y := INR k) in *.
assert (Hs2 : 0 < s ^ 2) by (apply pow_lt, Hs). assert (Hs3 : 0 < s ^ 3) by (apply pow_lt, Hs).
assert (I23 : / ((y + 2) * (y + 3)) <= / ((x + 2) * (x + 3))).
{ apply Rinv_le_contravar. apply Rmult_lt_0_compat; lra. apply Rmult_le_compat; lra. }
assert (P23 : 0 < / ((y + 2) * (y + 3))) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra).
apply Rplus_le_compat.
- apply Rmult_le_compat_l; auto. apply Rmult_le_pos; [apply Rabs_pos|lra].
- replace ((y + B) * s ^ 3 / ((y + 1) * (y + 2) * (y + 3)))
    with (s ^ 3 * ((1 + (B - 1) * / (y + 1)) * / ((y + 2) * (y + 3))))
    by (field; lra).
  replace ((x + B) * s ^ 3 / ((x + 1) * (x + 2) * (x + 3)))
    with (s ^ 3 * ((1 + (B - 1) * / (x + 1)) * / ((x + 2) * (x + 3))))
    by (field; lra).
  assert (I1 : / (y + 1) <= / (x + 1)) by (apply Rinv_le_contravar; lra).
  assert (P1 : 0 < / (y + 1)) by (apply Rinv_0_lt_compat; lra).
  assert (Q1 : 0 <= (B - 1) * / (y + 1)) by (apply Rmult_le_pos; lra).
  assert (Q2 : (B - 1) * / (y + 1) <= (B - 1) * / (x + 1)) by (apply Rmult_le_compat_l; lra).
  apply Rmult_le_compat_l. lra. apply Rmult_le_compat; lra.
Qed.

Hypothesis Hq : ratio I < 1.
Let q := ratio I.
Let mu := Rmax (size I) (Rmax (size (I + 1)) (size (I + 2))).

(** blocks of three *)
Lemma blocks m : size (I + 3 * m) <= q ^ m * mu /\ size (I + 3 * m + 1) <= q ^ m * mu /\
  size (I + 3 * m + 2) <= q ^ m * mu.
Proof.
assert (Q0 : 0 <= q) by apply ratio_pos. assert (Q1 : q < 1) by exact Hq.
induction m as [|m (H0 & H1 & H2)].
- rewrite Nat.mul_0_r, Nat.add_0_r. simpl. rewrite Rmult_1_l. unfold mu.
  assert (A := Rmax_l (size I) (Rmax (size (I + 1)) (size (I + 2)))).
  assert (A' := Rmax_r (size I) (Rmax (size (I + 1)) (size (I + 2)))).
  assert (C := Rmax_l (size (I + 1)) (size (I + 2))). assert (C' := Rmax_r (size (I + 1)) (size (I + 2))). lra.
- set (X := q ^ m * mu) in *.
  assert (X0 : 0 <= X) by (eapply Rle_trans; [apply size_pos|exact H0]).
  assert (ST : forall k, (I <= k)%nat -> size (k + 1) <= X -> size k <= X -> size (k + 3) <= q * X).
  { intros k Hk A0 A1. eapply Rle_trans; [apply size_step|].
    apply Rmult_le_compat. apply ratio_pos. eapply Rle_trans; [apply (size_pos k)|apply Rmax_r].
    apply ratio_decreases, Hk. apply Rmax_lub; auto. }
  assert (QX : q * X <= X) by (rewrite <- (Rmult_1_l X) at 2; apply Rmult_le_compat_r; lra).
  assert (G0 := ST (I + 3 * m)%nat ltac:(lia) H1 H0).
  assert (G1 := ST (I + 3 * m + 1)%nat ltac:(lia)).
  replace (I + 3 * m + 1 + 1)%nat with (I + 3 * m + 2)%nat in G1 by lia.
  specialize (G1 H2 H1).
  assert (G2 := ST (I + 3 * m + 2)%nat ltac:(lia)).
  replace (I + 3 * m + 2 + 1)%nat with (I + 3 * m + 3)%nat in G2 by lia.
  specialize (G2 (Rle_trans _ _ _ G0 QX) H2).
  change (q ^ S m) with (q * q ^ m). rewrite Rmult_assoc. fold X.
  replace (I + 3 * S m)%nat with (I + 3 * m + 3)%nat by lia.
  replace (I + 3 * m + 3 + 1)%nat with (I + 3 * m + 1 + 3)%nat by lia.
  replace (I + 3 * m + 3 + 2)%nat with (I + 3 * m + 2 + 3)%nat by lia. auto.
Qed.

Lemma sum_mono n m : (n <= m)%nat -> sum_first (fun i => size (I + 3 + i)) n <= sum_first (fun i => size (I + 3 + i)) m.
Proof.
induction 1 as [|m _ IH]. apply Rle_refl. simpl. assert (H := size_pos (I + 3 + m)). lra.
Qed.

Lemma sum_blocks M : sum_first (fun i => size (I + 3 + i)) (3 * M) <= 3 * mu * q * (1 - q ^ M) / (1 - q).
Proof.
assert (Q1 : q < 1) by exact Hq.
induction M as [|M IH].
- simpl. right. field. lra.
- destruct (blocks (S M)) as (B0 & B1 & B2).
  replace (I + 3 * S M)%nat with (I + 3 + 3 * M)%nat in B0, B1, B2 by lia.
  replace (3 * S M)%nat with (S (S (S (3 * M)))) by lia. set (K := (3 * M)%nat) in *.
  replace (I + 3 + K + 1)%nat with (I + 3 + S K)%nat in B1 by lia.
  replace (I + 3 + K + 2)%nat with (I + 3 + S (S K))%nat in B2 by lia.
  change (sum_first (fun i => size (I + 3 + i)) K + size (I + 3 + K) + size (I + 3 + S K) + size (I + 3 + S (S K))
    <= 3 * mu * q * (1 - q ^ S M) / (1 - q)).
  replace (3 * mu * q * (1 - q ^ S M) / (1 - q)) with (3 * mu * q * (1 - q ^ M) / (1 - q) + 3 * (q ^ S M * mu))
    by (simpl; field; lra).
  lra.
Qed.

Theorem recurrence_tail N : sum_first (fun i => size (I + 3 + i)) N <= 3 * mu * q / (1 - q).
Proof.
assert (Q1 : q < 1) by exact Hq. assert (Q0 : 0 <= q) by apply ratio_pos.
eapply Rle_trans; [apply (sum_mono N (3 * N)); lia|]. eapply Rle_trans; [apply sum_blocks|].
unfold Rdiv. apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat; lra.
assert (Hmu : 0 <= mu) by (eapply Rle_trans; [apply (size_pos I)|apply Rmax_l]).
rewrite <- (Rmult_1_r (3 * mu * q)) at 2. apply Rmult_le_compat_l.
- apply Rmult_le_pos; auto. lra.
- assert (0 <= q ^ N) by (apply pow_le, Q0). lra.
Qed.

End Tail.
