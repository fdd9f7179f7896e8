(** * The theorem of Budan and Fourier

    f has N derivatives on [T, T'] and the N-th has one sign. V(t) is the number of changes of sign in f(t), f'(t), ...,
    f^(N)(t), zeros left out. Near a point c all derivatives are nonzero. On the right of c each has the sign of the
    next one that is not 0 at c, so V does not change; on the left one that vanishes at c has the sign opposite to that
    of its derivative, so V is greater there by the order of f at c and an even number. Both go down from the N-th
    derivative. Going from T to T' the zeros are collected, by induction along the line. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus.
Import ListNotations.
Open Scope R_scope.

(** ** Lists of reals *)
Lemma first_cons x l : x <> 0 -> first_nonzero (x :: l) = x.
Proof. intros H. simpl. destruct (Req_EM_T x 0); [contradiction|reflexivity]. Qed.

Lemma first_zero l : first_nonzero (0 :: l) = first_nonzero l.
Proof. simpl. destruct (Req_EM_T 0 0); [reflexivity|lra]. Qed.

Lemma variations_more x l : x * first_nonzero l < 0 -> variations (x :: l) = S (variations l).
Proof. intros H. simpl. destruct (Rlt_dec (x * first_nonzero l) 0); [reflexivity|contradiction]. Qed.

Lemma variations_same x l : 0 <= x * first_nonzero l -> variations (x :: l) = variations l.
Proof. intros H. simpl. destruct (Rlt_dec (x * first_nonzero l) 0); [lra|reflexivity]. Qed.

Lemma variations_zero l : variations (0 :: l) = variations l.
Proof. apply variations_same. rewrite Rmult_0_l. apply Rle_refl. Qed.

(** ** Signs near a point *)
Section Near.
Variables (g : nat -> R -> R) (N : nat) (T T' s : R).
Hypothesis D : forall k t, (k < N)%nat -> T <= t <= T' -> is_derive (g k) t (g (S k) t).
Hypothesis Htop : forall t, T <= t <= T' -> 0 < s * g N t.

(** g_k(t), ..., g_(k+j)(t) *)
Definition from (k j : nat) (t : R) : list R := map (fun i => g i t) (seq k (S j)).

Lemma from_S k j t : from k (S j) t = g k t :: from (S k) j t.
Proof. reflexivity. Qed.

Lemma first_from k j t : g k t <> 0 -> first_nonzero (from k j t) = g k t.
Proof. intros H. change (from k j t) with (g k t :: map (fun i => g i t) (seq (S k) j)). apply first_cons, H. Qed.

Lemma factors_nonzero x y : 0 < x * y -> x <> 0 /\ y <> 0.
Proof. intros H. split; intros ->; lra. Qed.

Lemma same_sign x y z : 0 < x * y -> 0 < y * z -> 0 < x * z.
Proof.
intros H1 H2. assert (Hy : y <> 0) by (intros ->; lra).
assert (0 < y ^ 2) by (apply pow2_gt_0, Hy).
apply Rmult_lt_reg_r with (y ^ 2); auto. rewrite Rmult_0_l.
replace (x * z * y ^ 2) with ((x * y) * (y * z)) by ring. apply Rmult_lt_0_compat; auto.
Qed.

Lemma keeps_sign k c : (k < N)%nat -> T <= c <= T' -> g k c <> 0 ->
  exists d, 0 < d /\ forall t, c - d < t < c + d -> 0 < g k t * g k c.
Proof.
intros Hk Hc H.
assert (L : locally c (fun t => 0 < g k t * g k c)).
{ apply (continuous_pos (fun t => g k t * g k c)).
  - exists (g (S k) c * g k c). apply (is_derive_ext (fun t => g k c * g k t)). intros; apply Rmult_comm.
    rewrite Rmult_comm. apply (is_derive_scal (g k)), D; auto.
  - generalize (pow2_gt_0 (g k c) H). simpl. lra. }
destruct L as [d Hd]. exists d. split. apply cond_pos.
intros t Ht. apply Hd. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. apply Rabs_def1; lra.
Qed.

Lemma mean_value k x y : (k < N)%nat -> T <= x -> x < y -> y <= T' -> exists z, x < z < y /\
  g k y - g k x = g (S k) z * (y - x).
Proof. intros Hk Hx Hxy Hy. apply (mvt_open (g k) (g (S k)) x y Hxy). intros t Ht. apply D; auto; lra. Qed.

Lemma right_of c : T <= c <= T' -> forall j k, (k + j = N)%nat -> exists d, 0 < d /\ forall t, c < t < c + d ->
  t <= T' ->
  0 < g k t * first_nonzero (from k j c) /\ variations (from k j t) = variations (from k j c).
Proof.
intros Hc. induction j as [|j IH]; intros k Hk.
- replace k with N by lia. exists 1. split. lra. intros t Ht1 Ht2.
  assert (A := Htop c Hc). assert (B := Htop t ltac:(lra)).
  rewrite first_from by (apply (factors_nonzero _ _ A)). split.
  + apply same_sign with s; lra.
  + simpl. rewrite !Rmult_0_r. destruct (Rlt_dec 0 0); reflexivity.
- destruct (IH (S k) ltac:(lia)) as (d & Hd & H). rewrite (from_S k j c).
  destruct (Req_EM_T (g k c) 0) as [E|E].
  + exists d. split; auto. intros t Ht1 Ht2. destruct (H t Ht1 Ht2) as (P & V).
    destruct (mean_value k c t ltac:(lia) (proj1 Hc) (proj1 Ht1) Ht2) as (z & Hz & Ez).
    destruct (H z ltac:(lra) ltac:(lra)) as (Pz & _).
    rewrite E, first_zero, variations_zero, from_S.
    assert (Q : 0 < g k t * first_nonzero (from (S k) j c)).
    { replace (g k t) with (g (S k) z * (t - c)) by lra.
      replace (g (S k) z * (t - c) * first_nonzero (from (S k) j c)) with (g (S k) z * first_nonzero (from (S k) j c)
        * (t - c)) by ring.
      apply Rmult_lt_0_compat; lra. }
    split; auto. rewrite variations_same; auto.
    rewrite first_from by (apply (factors_nonzero _ _ P)). apply Rlt_le.
    apply same_sign with (first_nonzero (from (S k) j c)); lra.
  + destruct (keeps_sign k c ltac:(lia) Hc E) as (d' & Hd' & K).
    exists (Rmin d d'). split. apply Rmin_pos; auto. intros t Ht1 Ht2.
    assert (M1 := Rmin_l d d'). assert (M2 := Rmin_r d d').
    destruct (H t ltac:(lra) Ht2) as (P & V). assert (Kt := K t ltac:(lra)).
    rewrite first_cons by auto. split; auto. rewrite from_S.
    destruct (factors_nonzero _ _ P) as (P1 & P2).
    destruct (Rlt_le_dec (g k c * first_nonzero (from (S k) j c)) 0) as [L|L].
    * rewrite !variations_more; auto. rewrite first_from by auto.
      assert (0 < g k t * - g (S k) t); [|lra].
      apply same_sign with (g k c); auto. apply same_sign with (- first_nonzero (from (S k) j c)); lra.
    * rewrite !variations_same; auto. rewrite first_from by auto. apply Rlt_le.
      apply same_sign with (g k c); auto. apply same_sign with (first_nonzero (from (S k) j c)); try lra.
      destruct (Rle_lt_or_eq_dec _ _ L) as [L'|L']; auto. symmetry in L'. apply Rmult_integral in L'. tauto.
Qed.

(** m zeros stand first in g_k(c), ..., g_(k+j)(c) *)
Definition order_from (k : nat) (c : R) (m : nat) : Prop := (forall i, (i < m)%nat -> g (k + i) c = 0) /\
  g (k + m) c <> 0.

Lemma left_of c : T <= c <= T' -> forall j k, (k + j = N)%nat -> exists m d, (m <= j)%nat /\ order_from k c m /\
  0 < d /\
  forall t, c - d < t < c -> T <= t -> 0 < (-1) ^ m * (g k t * first_nonzero (from k j c)) /\
    exists i, variations (from k j t) = (variations (from k j c) + m + 2 * i)%nat.
Proof.
intros Hc. induction j as [|j IH]; intros k Hk.
- replace k with N by lia. assert (A := Htop c Hc). destruct (factors_nonzero _ _ A) as (_ & An).
  exists 0%nat, 1. split; [lia|]. split; [split; [lia|rewrite Nat.add_0_r; auto]|]. split; [lra|]. intros t Ht1 Ht2.
  assert (B := Htop t ltac:(lra)). rewrite first_from by auto. split.
  + simpl. rewrite Rmult_1_l. apply same_sign with s; lra.
  + exists 0%nat. simpl. rewrite !Rmult_0_r. destruct (Rlt_dec 0 0); reflexivity.
- destruct (IH (S k) ltac:(lia)) as (m & d & Hm & (O1 & O2) & Hd & H). rewrite (from_S k j c).
  set (F := first_nonzero (from (S k) j c)) in *.
  destruct (Req_EM_T (g k c) 0) as [E|E].
  + exists (S m), d. split; [lia|]. split; [split|split; auto].
    { intros [|i] Hi. rewrite Nat.add_0_r; auto. replace (k + S i)%nat with (S k + i)%nat by lia. apply O1. lia. }
    { replace (k + S m)%nat with (S k + m)%nat by lia. auto. }
    intros t Ht1 Ht2. destruct (H t Ht1 Ht2) as (P & i & V).
    destruct (mean_value k t c ltac:(lia) Ht2 (proj2 Ht1) (proj2 Hc)) as (z & Hz & Ez).
    destruct (H z ltac:(lra) ltac:(lra)) as (Pz & _).
    rewrite E, first_zero, variations_zero, from_S. fold F.
    assert (Q : 0 < (-1) ^ S m * (g k t * F)).
    { replace (g k t) with (- (g (S k) z * (c - t))) by lra.
      replace ((-1) ^ S m * (- (g (S k) z * (c - t)) * F)) with ((-1) ^ m * (g (S k) z * F) * (c - t)) by (simpl; ring).
      apply Rmult_lt_0_compat; lra. }
    split; auto. exists i. rewrite variations_more. lia.
    assert (P' : g (S k) t <> 0) by (intros Z; rewrite Z in P; lra).
    rewrite first_from by auto.
    assert (0 < g k t * - g (S k) t); [|lra].
    apply same_sign with ((-1) ^ S m * F).
    * lra.
    * simpl. lra.
  + destruct (keeps_sign k c ltac:(lia) Hc E) as (d' & Hd' & K).
    exists 0%nat, (Rmin d d'). split; [lia|]. split; [split; [lia|rewrite Nat.add_0_r; auto]|].
    split. apply Rmin_pos; auto. intros t Ht1 Ht2.
    assert (M1 := Rmin_l d d'). assert (M2 := Rmin_r d d').
    destruct (H t ltac:(lra) Ht2) as (P & i & V). assert (Kt := K t ltac:(lra)).
    rewrite first_cons by auto. split; [simpl; lra|]. rewrite from_S.
    assert (P1 : g (S k) t <> 0) by (intros Z; rewrite Z in P; lra).
    assert (P2 : F <> 0) by (intros Z; rewrite Z in P; lra).
    destruct (Nat.Even_or_Odd m) as [[h ->]|[h ->]].
    * rewrite pow_1_even in P. exists (h + i)%nat.
      destruct (Rlt_le_dec (g k c * F) 0) as [L|L].
      -- rewrite !variations_more; fold F; auto. lia. rewrite first_from by auto.
         assert (0 < g k t * - g (S k) t); [|lra].
         apply same_sign with (g k c); auto. apply same_sign with (- F); lra.
      -- rewrite !variations_same; fold F; auto. lia. rewrite first_from by auto. apply Rlt_le.
         apply same_sign with (g k c); auto. apply same_sign with F; try lra.
         destruct (Rle_lt_or_eq_dec _ _ L) as [L'|L']; auto. symmetry in L'. apply Rmult_integral in L'. tauto.
    * rewrite Nat.add_1_r, pow_1_odd in P.
      destruct (Rlt_le_dec (g k c * F) 0) as [L|L].
      -- exists (h + i)%nat. rewrite (variations_more (g k c)), (variations_same (g k t)); fold F; auto. lia.
         rewrite first_from by auto. apply Rlt_le.
         apply same_sign with (g k c); auto. apply same_sign with (- F); lra.
      -- exists (h + i + 1)%nat. rewrite (variations_same (g k c)), (variations_more (g k t)); fold F; auto. lia.
         rewrite first_from by auto.
         assert (0 < g k t * - g (S k) t); [|lra].
         apply same_sign with (g k c); auto. apply same_sign with F; try lra.
         destruct (Rle_lt_or_eq_dec _ _ L) as [L'|L']; try lra. symmetry in L'. apply Rmult_integral in L'. tauto.
Qed.

(** ** From T to T' *)

(** l lists the zeros of g_0 in (T, t], each as often as its order says, and V falls by their number and an even one. *)
Definition collected (t : R) : Prop := exists l i, StronglySorted Rle l /\ (forall z, In z l -> T < z <= t) /\
  (forall z, T < z <= t -> order_from 0 z (count_occ Req_EM_T l z)) /\
  variations (from 0 N T) = (variations (from 0 N t) + length l + 2 * i)%nat.

Lemma sorted_app (l1 l2 : list R) : StronglySorted Rle l1 -> StronglySorted Rle l2 -> (forall x y, In x l1 -> In y l2 ->
  x <= y) ->
  StronglySorted Rle (l1 ++ l2).
Proof.
induction l1 as [|x l1 IH]; intros H1 H2 H; simpl; auto.
inversion H1; subst. constructor.
- apply IH; auto. intros y z Hy Hz. apply H; simpl; auto.
- apply Forall_app. split; auto. apply Forall_forall. intros y Hy. apply H; simpl; auto.
Qed.

Lemma sorted_repeat x n : StronglySorted Rle (repeat x n).
Proof.
induction n as [|n IH]; simpl; constructor; auto. apply Forall_forall. intros y Hy. apply repeat_spec in Hy. lra.
Qed.

Lemma count_repeat x n : count_occ Req_EM_T (repeat x n) x = n.
Proof. induction n as [|n IH]; simpl; auto. destruct (Req_EM_T x x); [lia|contradiction]. Qed.

Lemma count_repeat_other x y n : x <> y -> count_occ Req_EM_T (repeat x n) y = 0%nat.
Proof. intros H. apply count_occ_not_In. intros Hy. apply repeat_spec in Hy. auto. Qed.

Theorem collected_at : forall t, T <= t -> t <= T' -> collected t.
Proof.
apply (real_induction (fun t => t <= T' -> collected t) T).
- intros _. exists [], 0%nat. split; [constructor|]. split; [intros z []|]. split; [intros z Hz; lra|simpl; lia].
- intros t Ht H. destruct (Rle_lt_dec t T') as [HT|HT].
  2:{ exists 1. split. lra. intros u Hu Hu'. exfalso. lra. }
  destruct (right_of t (conj Ht HT) N 0 (Nat.add_0_l N)) as (d & Hd & R).
  destruct (H t (conj Ht (Rle_refl t)) HT) as (l & i & S & I & O & V).
  exists d. split; auto. intros u Hu Hu'. destruct (Rle_lt_or_eq_dec t u (proj1 Hu)) as [L|<-].
  2:{ exists l, i. auto. }
  exists l, i. split; [auto|]. split; [intros z Hz; specialize (I z Hz); lra|]. split.
  + intros z Hz. destruct (Rle_lt_dec z t) as [Lz|Lz]. apply O; lra.
    destruct (R z ltac:(lra) ltac:(lra)) as (P & _).
    rewrite (proj1 (count_occ_not_In Req_EM_T l z)) by (intros Hin; specialize (I z Hin); lra).
    split; [lia|]. simpl. apply (factors_nonzero _ _ P).
  + rewrite V. destruct (R u ltac:(lra) Hu') as (_ & ->). reflexivity.
- intros t Ht H HT.
  destruct (left_of t ltac:(lra) N 0 (Nat.add_0_l N)) as (m & d & _ & (O1 & O2) & Hd & L).
  set (u := Rmax T (t - d / 2)). assert (U1 : T <= u) by apply Rmax_l. assert (U2 : t - d / 2 <= u) by apply Rmax_r.
  assert (U3 : u < t) by (unfold u, Rmax; destruct Rle_dec; lra).
  destruct (H u (conj U1 U3) ltac:(lra)) as (l & i & S & I & O & V).
  destruct (L u ltac:(lra) U1) as (_ & i' & V').
  exists (l ++ repeat t m), (i + i')%nat. split; [|split; [|split]].
  + apply sorted_app; auto. apply sorted_repeat. intros x y Hx Hy. apply repeat_spec in Hy. specialize (I x Hx). lra.
  + intros z Hz. apply in_app_or in Hz. destruct Hz as [Hz|Hz]. specialize (I z Hz). lra. apply repeat_spec in Hz. lra.
  + intros z Hz. rewrite count_occ_app. destruct (Req_EM_T z t) as [->|Nz].
    * rewrite (proj1 (count_occ_not_In Req_EM_T l t)) by (intros Hin; specialize (I t Hin); lra).
      rewrite count_repeat. split; auto.
    * rewrite count_repeat_other by auto. rewrite Nat.add_0_r.
      destruct (Rle_lt_dec z u) as [Lz|Lz]. apply O; lra.
      rewrite (proj1 (count_occ_not_In Req_EM_T l z)) by (intros Hin; specialize (I z Hin); lra).
      destruct (L z ltac:(lra) ltac:(lra)) as (P & _). split; [lia|]. simpl. intros Z. rewrite Z in P. lra.
  + rewrite app_length, repeat_length, V, V'. lia.
Qed.
End Near.

Theorem budan_fourier (f : R -> R) (n : nat) s T T' : T <= T' ->
  (forall k t, (k <= n)%nat -> T <= t <= T' -> ex_derive_n f k t) ->
    (forall t, T <= t <= T' -> 0 < s * Derive_n f n t) ->
  exists l j, zeros_with_multiplicity f (fun t => T < t <= T') l /\
    variations (derivatives f n T) = (variations (derivatives f n T') + length l + 2 * j)%nat.
Proof.
intros HT D H.
destruct (collected_at (fun k t => Derive_n f k t) n T T' s) with (t := T') as (l & j & S & I & O & V); auto; try lra.
- intros k t Hk Ht. apply Derive_correct. exact (D (S k) t ltac:(lia) Ht).
- exists l, j. exact (conj (conj S (conj I O)) V).
Qed.
