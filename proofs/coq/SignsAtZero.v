(** * The signs at t = 0

    For b in (m - 1, m): Theta(0, b) = (b - 1)(b - 2) Theta(0, b - 3), and the factor is negative only for 1 < b < 2; so
    the sign [sg m] of Theta(0, b) has the period 3 in m: +, +, - (fact 3 of proofs/proofs/count_law.md). The
    derivatives follow from the family. No value of Gamma is used. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus LaplaceIntegral WellPosed Family.
Open Scope R_scope.

Lemma nat_ind3 (P : nat -> Prop) :
  P 0%nat -> P 1%nat -> P 2%nat -> (forall n, P n -> P (S (S (S n)))) -> forall n, P n.
Proof.
intros H0 H1 H2 HS n.
enough (P n /\ P (S n) /\ P (S (S n))) by tauto.
induction n as [|n (I0 & I1 & I2)]; auto.
Qed.

(** the sign of Theta(0, b) for b in (m - 1, m) *)
Fixpoint sg (m : nat) : R :=
  match m with
  | S (S (S k)) => sg k
  | S (S O) => -1
  | _ => 1
  end.

Lemma mod3_SSS k : ((S (S (S k))) mod 3 = k mod 3)%nat.
Proof.
replace (S (S (S k))) with (k + 1 * 3)%nat by lia. apply Nat.mod_add. lia.
Qed.

Lemma div3_SSS k : ((S (S (S k))) / 3 = S (k / 3))%nat.
Proof.
replace (S (S (S k))) with (k + 1 * 3)%nat by lia. rewrite Nat.div_add by lia. lia.
Qed.

Lemma sg_mod m : sg m = if Nat.eqb (m mod 3) 2 then -1 else 1.
Proof.
induction m as [| | |m IH] using nat_ind3; try reflexivity.
rewrite mod3_SSS. exact IH.
Qed.

Lemma sg_next m :
  (sg m = 1 /\ sg (S m) = 1) \/ (sg m = 1 /\ sg (S m) = -1) \/ (sg m = -1 /\ sg (S m) = 1).
Proof. induction m as [| | |m IH] using nat_ind3; simpl; auto. Qed.

(** no three consecutive values are equal: after -1 come 1, 1 *)
Lemma sg_prev2 m : sg (S (S m)) = -1 -> sg m = 1 /\ sg (S m) = 1.
Proof.
induction m as [| | |m IH] using nat_ind3; intros H; simpl in *; auto; lra.
Qed.

Theorem sign_0 m : forall b, cell m b -> 0 < sg m * Th b 0.
Proof.
induction m as [| | |m IH] using nat_ind3; intros b Hb; assert (Hn := cell_not_nat _ _ Hb);
unfold cell in Hb; rewrite ?S_INR in Hb; simpl INR in Hb; simpl sg.
- rewrite Rmult_1_l. apply Th_pos; lra.
- rewrite (Th_rec b 0 Hn).
  assert (H := Th_pos (b - 3) 0 ltac:(lra)).
  assert (H2 : 0 < (b - 1) * (b - 2)) by nra.
  assert (0 < (b - 1) * (b - 2) * Th (b - 3) 0) by (apply Rmult_lt_0_compat; auto). lra.
- rewrite (Th_rec b 0 Hn).
  assert (H := Th_pos (b - 3) 0 ltac:(lra)).
  assert (H2 : 0 < - ((b - 1) * (b - 2))) by nra.
  assert (0 < - ((b - 1) * (b - 2)) * Th (b - 3) 0) by (apply Rmult_lt_0_compat; auto). lra.
- rewrite (Th_rec b 0 Hn).
  assert (Hm := pos_INR m).
  assert (H : 0 < sg m * Th (b - 3) 0) by (apply IH; unfold cell; lra).
  assert (H2 : 0 < (b - 1) * (b - 2)) by nra.
  assert (0 < (b - 1) * (b - 2) * (sg m * Th (b - 3) 0)) by (apply Rmult_lt_0_compat; auto). lra.
Qed.

Lemma rising_sign_lo m b n : cell m b -> (n <= m)%nat -> 0 < (-1) ^ n * rising (- b) n.
Proof.
intros Hb; induction n as [|n IH]; intros Hn.
- simpl; lra.
- specialize (IH ltac:(lia)).
  assert (Hm : INR (S n) <= INR m) by (apply le_INR; lia). rewrite S_INR in Hm.
  destruct Hb as [Hb1 Hb2].
  change (0 < (-1) ^ S n * (rising (- b) n * (- b + INR n))).
  replace ((-1) ^ S n * (rising (- b) n * (- b + INR n)))
    with ((-1) ^ n * rising (- b) n * (b - INR n)) by (simpl; ring).
  apply Rmult_lt_0_compat; auto; lra.
Qed.

Lemma rising_sign_hi m b n : cell m b -> (m <= n)%nat -> 0 < (-1) ^ m * rising (- b) n.
Proof.
intros Hb; induction n as [|n IH]; intros Hn.
- apply (rising_sign_lo m b 0) in Hb; [|lia]. replace m with O by lia. exact Hb.
- destruct (Nat.eq_dec m (S n)) as [E|E].
  + rewrite <- E. apply (rising_sign_lo m b m Hb); lia.
  + specialize (IH ltac:(lia)).
    assert (Hm : INR m <= INR n) by (apply le_INR; lia).
    destruct Hb as [Hb1 Hb2].
    change (0 < (-1) ^ m * (rising (- b) n * (- b + INR n))).
    rewrite <- Rmult_assoc. apply Rmult_lt_0_compat; auto; lra.
Qed.

Lemma cell_sub m b n : cell m b -> (n <= m)%nat -> cell (m - n) (b - INR n).
Proof. intros Hb Hn. unfold cell in *. rewrite minus_INR by auto. lra. Qed.

(** The signs of Theta^(n)(0, b), b in (m - 1, m): for n <= m it is (-1)^n sg(m - n),
    for n >= m it is (-1)^m.  (b < 0: all are positive, [Theta_pos_b_neg].) *)
Theorem Theta_signs_0 (m n : nat) (b : R) (theta : R -> R) :
  cell m b -> is_Theta b theta ->
  ((n <= m)%nat -> 0 < (-1) ^ n * sg (m - n) * Derive_n theta n 0) /\
  ((m <= n)%nat -> 0 < (-1) ^ m * Derive_n theta n 0).
Proof.
intros Hb H. assert (Hn := cell_not_nat _ _ Hb).
rewrite (Theta_derive_n n b theta (Th (b - INR n)) Hn H (Th_correct _)).
split; intros Hnm.
- replace ((-1) ^ n * sg (m - n) * (rising (- b) n * Th (b - INR n) 0))
    with (((-1) ^ n * rising (- b) n) * (sg (m - n) * Th (b - INR n) 0)) by ring.
  apply Rmult_lt_0_compat.
  + apply (rising_sign_lo m); auto.
  + apply sign_0, cell_sub; auto.
- rewrite <- Rmult_assoc. apply Rmult_lt_0_compat.
  + apply rising_sign_hi; auto.
  + apply Th_pos. destruct Hb as [Hb1 Hb2]. assert (INR m <= INR n) by (apply le_INR, Hnm). lra.
Qed.

(** Theta, Theta', Theta'' at 0: + + + for m = 0 mod 3, + - - for 1, - - + for 2. *)
Theorem Theta_signs_012 (m : nat) (b : R) (theta : R -> R) :
  cell m b -> is_Theta b theta ->
  match (m mod 3)%nat with
  | 0%nat => 0 < theta 0 /\ 0 < Derive theta 0 /\ 0 < Derive_n theta 2 0
  | 1%nat => 0 < theta 0 /\ Derive theta 0 < 0 /\ Derive_n theta 2 0 < 0
  | _ => theta 0 < 0 /\ Derive theta 0 < 0 /\ 0 < Derive_n theta 2 0
  end.
Proof.
intros Hb H.
destruct (Theta_signs_0 m 0 b theta Hb H) as [S0 _]. specialize (S0 ltac:(lia)).
destruct (Theta_signs_0 m 1 b theta Hb H) as [S1 T1]. destruct (Theta_signs_0 m 2 b theta Hb H) as [S2 T2].
change (Derive_n theta 0 0) with (theta 0) in S0. change (Derive_n theta 1 0) with (Derive theta 0) in S1, T1.
destruct m as [|[|m]].
- specialize (T1 ltac:(lia)). specialize (T2 ltac:(lia)). simpl in *. lra.
- specialize (S1 ltac:(lia)). specialize (T2 ltac:(lia)). simpl in *. lra.
- specialize (S1 ltac:(lia)). specialize (S2 ltac:(lia)).
  replace (S (S m) - 1)%nat with (S m) in S1 by lia. replace (S (S m) - 2)%nat with m in S2 by lia.
  rewrite Nat.sub_0_r in S0. rewrite sg_mod in S0, S1, S2.
  assert (E1 : (S m mod 3 = (m mod 3 + 1) mod 3)%nat) by (rewrite Nat.add_mod_idemp_l by lia; f_equal; lia).
  assert (E2 : (S (S m) mod 3 = (m mod 3 + 2) mod 3)%nat) by (rewrite Nat.add_mod_idemp_l by lia; f_equal; lia).
  assert (H3 : (m mod 3 < 3)%nat) by (apply Nat.mod_upper_bound; lia).
  rewrite E1 in S1. rewrite E2 in S0 |- *.
  destruct (m mod 3)%nat as [|[|[|k]]]; [| | |lia]; simpl in *; lra.
Qed.
