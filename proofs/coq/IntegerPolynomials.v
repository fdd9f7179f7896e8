(** * Integer b: the polynomials

    Section 4 of proofs/proofs/count_law.md. [Pn n] is defined by the three-term recurrence; Pn' = -n P_(n-1), the
    equation, the values at 0, and the zeros by the same two steps as for non-integer b. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus Family SignsAtZero MonotoneQuantity SignPattern.
Import ListNotations.
Open Scope R_scope.

Fixpoint Pn (n : nat) (t : R) : R :=
  match n with
  | O => 1
  | S n1 =>
    match n1 with
    | O => - t
    | S n2 =>
      match n2 with
      | O => t * t
      | S n3 => - t * Pn n1 t + (INR n3 + 2) * (INR n3 + 1) * Pn n3 t
      end
    end
  end.

Lemma Pn_rec n t : Pn (S (S (S n))) t = - t * Pn (S (S n)) t + (INR n + 2) * (INR n + 1) * Pn n t.
Proof. reflexivity. Qed.

(** P_n' = - n P_{n-1} *)
Lemma Pn_derive n : forall t, is_derive (Pn (S n)) t (- INR (S n) * Pn n t).
Proof.
enough (H : (forall t, is_derive (Pn (S n)) t (- INR (S n) * Pn n t)) /\
            (forall t, is_derive (Pn (S (S n))) t (- INR (S (S n)) * Pn (S n) t)) /\
            (forall t, is_derive (Pn (S (S (S n)))) t (- INR (S (S (S n))) * Pn (S (S n)) t)))
  by apply H.
induction n as [|n (I1 & I2 & I3)].
- refine (conj _ (conj _ _)); intros t.
  + apply (is_derive_ext (fun t => - t)). reflexivity.
    auto_derive; auto. simpl; ring.
  + apply (is_derive_ext (fun t => t * t)). reflexivity.
    auto_derive; auto. simpl; ring.
  + apply (is_derive_ext (fun t => - t * (t * t) + (0 + 2) * (0 + 1) * 1)). reflexivity.
    auto_derive; auto. simpl; ring.
- refine (conj I2 (conj I3 _)). intros t.
  apply (is_derive_ext (fun t => - t * Pn (S (S (S n))) t + (INR (S n) + 2) * (INR (S n) + 1) * Pn (S n) t)).
  { intros u. symmetry. apply Pn_rec. }
  evar_last.
  + apply (is_derive_plus (fun t => - t * Pn (S (S (S n))) t) (fun t => (INR (S n) + 2) * (INR (S n) + 1) * Pn (S n)
      t)).
    * apply (is_derive_mult_R (fun t => - t) (Pn (S (S (S n)))) t (-1)).
      auto_derive; auto; ring. apply I3.
    * apply (is_derive_scal (Pn (S n))). apply I1.
  + rewrite (Pn_rec n t). rewrite !S_INR. unfold plus; simpl. ring.
Qed.

Lemma Pn_derive' n t : is_derive (Pn n) t (- INR n * Pn (n - 1) t).
Proof.
destruct n as [|n].
- apply (is_derive_ext (fun _ => 1)). reflexivity.
  replace (- INR 0 * Pn (0 - 1) t) with 0 by (simpl; ring). apply (is_derive_const 1).
- replace (S n - 1)%nat with n by lia. apply Pn_derive.
Qed.

Lemma Pn_rec' n t : Pn (S n) t = - t * Pn n t + INR n * (INR n - 1) * Pn (n - 2) t.
Proof.
destruct n as [|[|n]].
- simpl; ring.
- simpl; ring.
- rewrite Pn_rec. replace (S (S n) - 2)%nat with n by lia. rewrite !S_INR. ring.
Qed.

(** first, second and third derivative *)
Definition Pn1 (n : nat) (t : R) : R := - INR n * Pn (n - 1) t.

Definition Pn2 (n : nat) (t : R) : R := INR n * (INR n - 1) * Pn (n - 2) t.

Lemma Pn_chain1 n t : is_derive (Pn1 n) t (Pn2 n t).
Proof.
unfold Pn1, Pn2.
replace (INR n * (INR n - 1) * Pn (n - 2) t) with (- INR n * (- INR (n - 1) * Pn (n - 1 - 1) t)).
- apply (is_derive_scal (Pn (n - 1))), Pn_derive'.
- destruct n as [|n]. simpl; ring.
  replace (S n - 1)%nat with n by lia. replace (S n - 2)%nat with (n - 1)%nat by lia.
  rewrite S_INR. ring.
Qed.

(** the equation *)
Lemma Pn_chain2 n t : is_derive (Pn2 n) t (t * Pn1 n t - INR n * Pn n t).
Proof.
unfold Pn1, Pn2.
replace (t * (- INR n * Pn (n - 1) t) - INR n * Pn n t)
  with (INR n * (INR n - 1) * (- INR (n - 2) * Pn (n - 2 - 1) t)).
- apply (is_derive_scal (Pn (n - 2))), Pn_derive'.
- destruct n as [|n]. simpl; ring.
  rewrite (Pn_rec' n t). replace (S n - 1)%nat with n by lia.
  destruct n as [|n]. simpl; ring.
  replace (S (S n) - 2)%nat with n by lia. replace (S n - 2)%nat with (n - 1)%nat by lia.
  rewrite !S_INR. ring.
Qed.

(** values at 0 *)
Lemma Pn_0 n : match (n mod 3)%nat with O => 0 < Pn n 0 | _ => Pn n 0 = 0 end.
Proof.
induction n as [| | |n IH] using nat_ind3; try (simpl; lra).
rewrite mod3_SSS, Pn_rec. assert (Hn := pos_INR n).
destruct (n mod 3)%nat.
- assert (0 < (INR n + 2) * (INR n + 1) * Pn n 0).
  { apply Rmult_lt_0_compat; auto. nra. }
  lra.
- rewrite IH. ring.
Qed.

Lemma Pn_0_ge n : 0 <= Pn n 0.
Proof. assert (H := Pn_0 n). destruct (n mod 3)%nat; lra. Qed.

Lemma Pn_0_zero n : (n mod 3 <> 0)%nat -> Pn n 0 = 0.
Proof. intros Hn. assert (H := Pn_0 n). destruct (n mod 3)%nat; [lia|auto]. Qed.

Lemma Pn_left n : forall t, t < 0 -> 0 < Pn n t.
Proof.
induction n as [|n IH]; intros t Ht.
- simpl; lra.
- destruct (mvt_open (Pn (S n)) (fun t => - INR (S n) * Pn n t) t 0 Ht (fun s _ => Pn_derive n s))
    as (d & Hd & E).
  assert (H0 := Pn_0_ge (S n)).
  assert (HS : 0 < INR (S n)) by (apply lt_0_INR; lia).
  assert (0 < INR (S n) * Pn n d * (0 - t)).
  { apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; auto. apply IH; lra. }
  lra.
Qed.

Lemma Pn_right n : exists c T, 0 < c /\ 0 <= T /\ forall t, T <= t -> c <= (-1) ^ n * Pn n t.
Proof.
induction n as [|n (c & T & Hc & HT & H)].
- exists 1, 0. simpl. repeat split; intros; lra.
- assert (HS : 0 < INR (S n)) by (apply lt_0_INR; lia).
  destruct (grow (fun t => (-1) ^ S n * Pn (S n) t) (fun t => (-1) ^ S n * (- INR (S n) * Pn n t))
    (INR (S n) * c) T) with (M := 1) as (T' & HT1 & HT2).
  + intros t. apply (is_derive_scal (Pn (S n))), Pn_derive.
  + apply Rmult_lt_0_compat; auto.
  + intros t Ht. replace ((-1) ^ S n * (- INR (S n) * Pn n t)) with (INR (S n) * ((-1) ^ n * Pn n t))
      by (change ((-1) ^ S n) with (-1 * (-1) ^ n); ring).
    apply Rmult_le_compat_l; [lra|]. apply H, Ht.
  + exists 1, T'. repeat split; auto; lra.
Qed.

Lemma Pn_opposite_at_infinity n T : exists t, T < t /\ Pn (S n) t * Pn n t < 0.
Proof.
destruct (Pn_right (S n)) as (c1 & T1 & Hc1 & HT1 & H1).
destruct (Pn_right n) as (c & T2 & Hc & HT2 & H2).
set (t := Rmax (T + 1) (Rmax T1 T2)).
assert (Ht : T + 1 <= t) by apply Rmax_l.
assert (Ht1 : T1 <= t) by (eapply Rle_trans; [apply Rmax_l|apply Rmax_r]).
assert (Ht2 : T2 <= t) by (eapply Rle_trans; [apply Rmax_r|apply Rmax_r]).
exists t. split; [lra|].
specialize (H1 t Ht1). specialize (H2 t Ht2).
change ((-1) ^ S n) with (-1 * (-1) ^ n) in H1.
set (e := (-1) ^ n) in *.
assert (He : e * e = 1).
{ unfold e. rewrite <- Rpow_mult_distr. replace (-1 * -1) with 1 by ring. apply pow1. }
assert (H : 0 < (-1 * e * Pn (S n) t) * (e * Pn n t)) by (apply Rmult_lt_0_compat; lra).
replace ((-1 * e * Pn (S n) t) * (e * Pn n t)) with (- ((e * e) * (Pn (S n) t * Pn n t))) in H by ring.
rewrite He in H. lra.
Qed.

(** section 2 of proofs/count_law.md for the polynomials; here Q(0) >= 0 only, so strictness is used *)
Lemma Pn_zero_QQ n c : 0 < c -> Pn (S n) c = 0 -> 0 < Pn1 (S n) c * Pn2 (S n) c.
Proof.
intros Hc E.
assert (HS : 0 < INR (S n)) by (apply lt_0_INR; lia).
assert (Hq := Q_strict (INR (S n)) (Pn (S n)) (Pn1 (S n)) (Pn2 (S n))
  (Pn_derive' (S n)) (Pn_chain1 (S n)) (Pn_chain2 (S n)) 0 c ltac:(lra)
  (ex_intro _ (-1) (Rgt_not_eq _ _ (Pn_left (S n) (-1) ltac:(lra)))) (Rle_refl 0) Hc).
rewrite (Q_zero (INR (S n)) (Pn (S n)) (Pn1 (S n)) (Pn2 (S n)) c E) in Hq.
eapply Rle_lt_trans; [|exact Hq].
unfold Qf.
assert (H12 : Pn1 (S n) 0 * Pn2 (S n) 0 = 0).
{ unfold Pn1, Pn2. replace (S n - 1)%nat with n by lia.
  destruct n as [|n]; [simpl; ring|]. replace (S (S n) - 2)%nat with n by lia.
  assert (Hz : Pn (S n) 0 = 0 \/ Pn n 0 = 0).
  { destruct (Nat.eq_dec (n mod 3) 0) as [Hn|Hn].
    - left. apply Pn_0_zero.
      replace (S n) with (n + 1)%nat by lia. rewrite <- Nat.add_mod_idemp_l, Hn by lia. discriminate.
    - right. apply Pn_0_zero, Hn. }
  destruct Hz as [Hz|Hz]; rewrite Hz; ring. }
rewrite H12. assert (H2 := pow2_ge_0 (Pn (S n) 0)). 
assert (0 <= INR (S n) / 2 * Pn (S n) 0 ^ 2) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma Pn_next_at_zero n c : 0 < c -> Pn n c = 0 -> 0 < Pn1 n c * Pn (S n) c.
Proof.
intros Hc E. destruct n as [|n]. simpl in E; lra.
assert (H := Pn_zero_QQ n c Hc E). rewrite (Pn_rec' (S n)), E.
replace (- c * 0 + INR (S n) * (INR (S n) - 1) * Pn (S n - 2) c) with (Pn2 (S n) c) by (unfold Pn2; ring).
exact H.
Qed.

(** the sign just right of 0 *)
Fixpoint sp (n : nat) : R :=
  match n with
  | S (S (S k)) => sp k
  | S O => -1
  | _ => 1
  end.

Lemma sp_cases n :
  (sp n = 1 /\ sp (S n) = -1 /\ (S n mod 3 <> 0)%nat /\ (S n / 3 = n / 3)%nat) \/
  (sp n = -1 /\ sp (S n) = 1 /\ (S n mod 3 <> 0)%nat /\ (S n / 3 = n / 3)%nat) \/
  (sp n = 1 /\ sp (S n) = 1 /\ (S n mod 3 = 0)%nat /\ (S n / 3 = S (n / 3))%nat).
Proof.
induction n as [| | |n IH] using nat_ind3.
- left. repeat split; auto; discriminate.
- right; left. repeat split; auto; discriminate.
- right; right. repeat split; auto.
- rewrite mod3_SSS, !div3_SSS.
  change (sp (S (S (S n)))) with (sp n). change (sp (S (S (S (S n))))) with (sp (S n)).
  destruct IH as [(A & B & C & D)|[(A & B & C & D)|(A & B & C & D)]]; rewrite D.
  + left. repeat split; auto.
  + right; left. repeat split; auto.
  + right; right. repeat split; auto.
Qed.

Theorem Pn_positive (n : nat) : exists l, length l = (n / 3)%nat /\ pattern (Pn n) (Pn1 n) (sp n) 0 l.
Proof.
induction n as [|n (l & El & Hl)].
- exists []. split; auto. simpl. intros; lra.
- assert (HS : 0 < INR (S n)) by (apply lt_0_INR; lia).
  assert (E1 : forall t, Pn1 (S n) t = - INR (S n) * Pn n t).
  { intros t. unfold Pn1. replace (S n - 1)%nat with n by lia. reflexivity. }
  assert (Dh := Pn_derive n). assert (Hval := Pn_next_at_zero n). assert (Hinf := Pn_opposite_at_infinity n).
  destruct (sp_cases n) as [(A & B & C & D)|[(A & B & C & D)|(A & B & C & D)]]; rewrite A in Hl; rewrite B, D.
  + destruct (step_head (INR (S n)) (Pn n) (Pn1 n) (Pn (S n)) HS Dh Hval Hinf l 1 Hl) as (l' & [El' _] & Hl').
    { rewrite (Pn_0_zero (S n) C). lra. }
    exists l'. split; [congruence|]. replace (-1) with (- (1)) by ring.
    apply (pattern_ext _ _ _ _ _ _ _ (fun t => eq_refl) E1 Hl').
  + destruct (step_head (INR (S n)) (Pn n) (Pn1 n) (Pn (S n)) HS Dh Hval Hinf l (-1) Hl) as (l' & [El' _] & Hl').
    { rewrite (Pn_0_zero (S n) C). lra. }
    exists l'. split; [congruence|]. replace (- -1) with 1 in Hl' by ring.
    apply (pattern_ext _ _ _ _ _ _ _ (fun t => eq_refl) E1 Hl').
  + assert (H0 := Pn_0 (S n)). rewrite C in H0.
    destruct (step_tail (INR (S n)) (Pn n) (Pn1 n) (Pn (S n)) HS Dh Hval Hinf l 1 0 (Rle_refl 0) Hl ltac:(lra))
      as (l' & [El' _] & Hl').
    exists l'. split; [congruence|].
    apply (pattern_ext _ _ _ _ _ _ _ (fun t => eq_refl) E1 Hl').
Qed.

(** multiplicity at 0 *)
Lemma Pn_mult_0 n :
  match (n mod 3)%nat with
  | 0%nat => Pn n 0 <> 0
  | 1%nat => Pn n 0 = 0 /\ Pn1 n 0 <> 0
  | _ => Pn n 0 = 0 /\ Pn1 n 0 = 0 /\ Pn2 n 0 <> 0
  end.
Proof.
assert (H := Pn_0 n).
assert (Hm3 : (n mod 3 < 3)%nat) by (apply Nat.mod_upper_bound; lia).
unfold Pn1, Pn2.
destruct n as [|n]. simpl. lra.
replace (S n - 1)%nat with n by lia.
assert (HS : 0 < INR (S n)) by (apply lt_0_INR; lia).
assert (E1 : (S n mod 3 = (n mod 3 + 1) mod 3)%nat).
{ rewrite Nat.add_mod_idemp_l by lia. f_equal; lia. }
assert (Hn := Pn_0 n).
assert (Hn3 : (n mod 3 < 3)%nat) by (apply Nat.mod_upper_bound; lia).
destruct (S n mod 3)%nat as [|[|[|k]]]; [| | |lia].
- lra.
- destruct (n mod 3)%nat as [|[|[|k]]]; try discriminate; try lia.
  split; auto. apply Rmult_integral_contrapositive_currified; lra.
- destruct (n mod 3)%nat as [|[|[|k]]] eqn:En; try discriminate; try lia.
  destruct n as [|n]; [discriminate|].
  assert (E2 : (S n mod 3 = (n mod 3 + 1) mod 3)%nat).
  { rewrite Nat.add_mod_idemp_l by lia. f_equal; lia. }
  assert (Hn2 := Pn_0 n).
  assert (Hn4 : (n mod 3 < 3)%nat) by (apply Nat.mod_upper_bound; lia).
  rewrite En in E2.
  destruct (n mod 3)%nat as [|[|[|k]]]; try discriminate; try lia.
  replace (S (S n) - 2)%nat with n by lia.
  rewrite Hn. repeat split; auto. ring.
  assert (Hp := pos_INR n). rewrite !S_INR.
  apply Rmult_integral_contrapositive_currified; [|lra].
  apply Rmult_integral_contrapositive_currified; lra.
Qed.

Lemma Pn_Derive n t : Derive (Pn n) t = Pn1 n t.
Proof. apply is_derive_unique, Pn_derive'. Qed.

Lemma Pn_Derive2 n t : Derive_n (Pn n) 2 t = Pn2 n t.
Proof.
simpl. rewrite (Derive_ext _ (Pn1 n)) by (intros; apply Pn_Derive).
apply is_derive_unique, Pn_chain1.
Qed.

(** The zeros of P_n: n/3 positive ones, all simple; 0, of multiplicity n mod 3; no others. *)
Theorem Pn_zeros (n : nat) : exists l, length l = (n / 3)%nat /\ StronglySorted Rlt l /\
  (forall t, In t l -> 0 < t) /\
  (forall t, Pn n t = 0 <-> In t l \/ (t = 0 /\ (n mod 3 <> 0)%nat)) /\
  (forall t, In t l -> Derive (Pn n) t <> 0) /\
  match (n mod 3)%nat with
  | 0%nat => Pn n 0 <> 0
  | 1%nat => Pn n 0 = 0 /\ Derive (Pn n) 0 <> 0
  | _ => Pn n 0 = 0 /\ Derive (Pn n) 0 = 0 /\ Derive_n (Pn n) 2 0 <> 0
  end.
Proof.
destruct (Pn_positive n) as (l & El & Hl).
exists l.
refine (conj El (conj (pattern_sorted _ _ _ _ _ Hl) (conj (pattern_lt _ _ _ _ _ Hl) (conj _ (conj _ _))))).
- intros t. destruct (Rtotal_order t 0) as [Ht|[->|Ht]].
  + assert (H := Pn_left n t Ht). split; [lra|].
    intros [Hi|[-> _]]; [|lra]. assert (H1 := pattern_lt _ _ _ _ _ Hl t Hi). lra.
  + assert (H := Pn_0 n). split.
    * intros E. right. split; auto. intros Hn. rewrite Hn in H. lra.
    * intros [Hi|[_ Hn]]; [|apply Pn_0_zero, Hn]. assert (H1 := pattern_lt _ _ _ _ _ Hl 0 Hi). lra.
  + rewrite (pattern_zeros _ _ _ _ _ Hl t Ht). split; [auto|]. intros [Hi|[-> _]]; [auto|lra].
- intros t Hi E. destruct (In_nth l t 0 Hi) as (i & Hil & Ei).
  assert (Hs := pattern_simple _ _ _ _ _ Hl i Hil). rewrite Ei, <- Pn_Derive, E in Hs. lra.
- rewrite !Pn_Derive, !Pn_Derive2. apply Pn_mult_0.
Qed.
