(** * Growth by the logarithmic norm

    u' = A(t) u + d(t) as long as |u|_w <= R, where mu_w(A) <= k, k >= 0, and |d|_w <= delta. Then |u|_w <= e^(k t) (e0
    + delta t) if this bound is below R at the end ([logarithmic_growth]).

    Plan: with the larger bound phi(t) = e^(k t) (e0 + m + (delta + m) t), m > 0 small, |u|_w < phi holds at 0, and on a
    little further from wherever it holds. At the first time where it fails some |u_i| = phi w_i; there w_i phi - |u_i|
    would be 0 with a positive derivative, so it was negative before. At last m tends to 0. *)

From Coq Require Import Reals Psatz Lra Lia List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus NonnegativeOrthant StatementStep.
Import ListNotations.
Open Scope R_scope.

Section Totals.
Context {I : Type}.

Lemma total_le (l : list I) g g' : (forall i, g i <= g' i) -> total l g <= total l g'.
Proof. intros H. induction l as [|i r IH]; simpl. lra. specialize (H i). lra. Qed.

Lemma total_scal (l : list I) c g : total l (fun i => c * g i) = c * total l g.
Proof. induction l as [|i r IH]; simpl. ring. rewrite IH. ring. Qed.

Lemma total_plus (l : list I) g g' : total l (fun i => g i + g' i) = total l g + total l g'.
Proof. induction l as [|i r IH]; simpl. ring. rewrite IH. ring. Qed.

Lemma total_minus (l : list I) g g' : total l (fun i => g i - g' i) = total l g - total l g'.
Proof. induction l as [|i r IH]; simpl. ring. rewrite IH. ring. Qed.

Lemma total_zero (l : list I) : total l (fun _ => 0) = 0.
Proof. induction l as [|i r IH]; simpl. reflexivity. rewrite IH. ring. Qed.

Lemma total_ext (l : list I) g g' : (forall i, g i = g' i) -> total l g = total l g'.
Proof. intros H. induction l as [|i r IH]; simpl; auto. rewrite H, IH. reflexivity. Qed.

Lemma total_abs (l : list I) g : Rabs (total l g) <= total l (fun i => Rabs (g i)).
Proof.
induction l as [|i r IH]; simpl. rewrite Rabs_R0. lra.
eapply Rle_trans. apply Rabs_triang. lra.
Qed.

Lemma total_const (l : list I) c : total l (fun _ => c) = INR (length l) * c.
Proof.
induction l as [|i r IH]. simpl; ring.
change (length (i :: r)) with (S (length r)). rewrite S_INR. simpl total. rewrite IH. ring.
Qed.

Lemma total_swap (l l' : list I) (g : I -> I -> R) :
  total l (fun i => total l' (fun j => g i j)) = total l' (fun j => total l (fun i => g i j)).
Proof. induction l as [|i r IH]; simpl. symmetry; apply total_zero. rewrite IH, total_plus. reflexivity. Qed.

Lemma total_derive (l : list I) (g g' : I -> R -> R) t : (forall i, is_derive (g i) t (g' i t)) ->
  is_derive (fun t => total l (fun i => g i t)) t (total l (fun i => g' i t)).
Proof.
intros H. induction l as [|i r IH]; simpl. apply (is_derive_const 0).
apply (is_derive_plus (g i) (fun t => total r (fun i => g i t))); auto.
Qed.

(** A term that is smaller by a known amount. *)
Lemma total_le_but_one (l : list I) g g' i c : In i l -> (forall j, g j <= g' j) -> g i <= g' i - c ->
  total l g <= total l g' - c.
Proof.
intros Hi H Hc. induction l as [|j r IH]; [destruct Hi|]. simpl.
destruct Hi as [->|Hi].
- assert (T := total_le r g g' H). lra.
- specialize (IH Hi). specialize (H j). lra.
Qed.

End Totals.

Section Growth.
Variables (I : Type) (all : list I).
Hypothesis Hall : forall i, In i all.
Variables (w : I -> R) (u u' : I -> R -> R) (k delta e0 R0 T : R).
Hypothesis Hw : forall i, 0 < w i.
Hypothesis Hk : 0 <= k.
Hypothesis Hdelta : 0 <= delta.
Hypothesis Hderive : forall i t, 0 <= t <= T -> is_derive (u i) t (u' i t).
(** A row a of the matrix and an entry d of the rest, for each component by itself. *)
Hypothesis Hlinear : forall t, 0 <= t <= T -> norm_at_most w (fun i => u i t) R0 -> forall i, exists a d,
  u' i t = total all (fun j => a j * u j t) + d /\
  a i - Rabs (a i) + total all (fun j => Rabs (a j) * (w j / w i)) <= k /\ Rabs d <= delta * w i.
Hypothesis Hstart : norm_at_most w (fun i => u i 0) e0.
Hypothesis Hend : exp (k * T) * (e0 + delta * T) < R0.

Section Above.
Variable m : R.
Hypothesis Hm : 0 < m.
Hypothesis He0 : 0 <= e0.
Let phi t := exp (k * t) * (e0 + m + (delta + m) * t).
Hypothesis Hsmall : phi T <= R0.

Lemma phi_derive t : is_derive phi t (k * phi t + exp (k * t) * (delta + m)).
Proof. unfold phi. auto_derive; auto. ring. Qed.

Lemma phi_pos t : 0 <= t -> 0 < phi t.
Proof. intros Ht. apply Rmult_lt_0_compat. apply exp_pos. assert (0 <= (delta + m) * t) by (apply Rmult_le_pos; lra).
lra. Qed.

Lemma phi_le t : 0 <= t <= T -> phi t <= phi T.
Proof.
intros Ht. apply Rmult_le_compat.
- apply Rlt_le, exp_pos.
- assert (0 <= (delta + m) * t) by (apply Rmult_le_pos; lra). lra.
- apply exp_le, Rmult_le_compat_l; lra.
- apply Rplus_le_compat_l, Rmult_le_compat_l; lra.
Qed.

(** The two sides of the bound, with s = 1 and s = -1. *)
Definition margin (s : R) (i : I) (t : R) : R := w i * phi t - s * u i t.

Lemma margin_derive s i t : 0 <= t <= T ->
  is_derive (margin s i) t (w i * (k * phi t + exp (k * t) * (delta + m)) - s * u' i t).
Proof.
intros Ht. apply (is_derive_minus (fun t => w i * phi t) (fun t => s * u i t)).
- apply (is_derive_scal phi t (w i)), phi_derive.
- apply (is_derive_scal (u i) t s), Hderive, Ht.
Qed.

(** Where the bound is reached it grows faster. *)
Lemma margin_inward s i t : s = 1 \/ s = -1 -> 0 <= t <= T -> norm_at_most w (fun i => u i t) (phi t) ->
  margin s i t = 0 ->
  0 < w i * (k * phi t + exp (k * t) * (delta + m)) - s * u' i t.
Proof.
intros Hs Ht B E.
assert (P := phi_pos t ltac:(lra)). assert (W := Hw i).
assert (R : norm_at_most w (fun i => u i t) R0).
{ intros j. specialize (B j). apply Rle_trans with (1 := B). apply Rmult_le_compat_r. apply Rlt_le, Hw.
  apply Rle_trans with (2 := Hsmall). apply phi_le, Ht. }
destruct (Hlinear t Ht R i) as (a & d & EQ & N & HD).
assert (Q : total all (fun j => s * (a j * u j t)) <= total all (fun j => Rabs (a j) * (w j / w i) * (w i * phi t))
  - (Rabs (a i) - a i) * (w i * phi t)).
{ apply (total_le_but_one all _ _ i); auto.
  - intros j. replace (Rabs (a j) * (w j / w i) * (w i * phi t)) with (Rabs (a j) * (phi t * w j)) by (field; lra).
    apply Rle_trans with (Rabs (s * (a j * u j t))). apply Rle_abs.
    rewrite Rabs_mult. replace (Rabs s) with 1 by (destruct Hs as [-> | ->]; unfold Rabs; destruct Rcase_abs; lra).
    rewrite Rmult_1_l, Rabs_mult. apply Rmult_le_compat_l. apply Rabs_pos. apply B.
  - unfold margin in E. replace (s * (a i * u i t)) with (a i * (s * u i t)) by ring.
    replace (s * u i t) with (w i * phi t) by lra. right. field. lra. }
rewrite total_scal in Q.
rewrite (total_ext all (fun j => Rabs (a j) * (w j / w i) * (w i * phi t))
  (fun j => w i * phi t * (Rabs (a j) * (w j / w i)))), total_scal in Q by (intros; ring).
assert (Dle : s * d <= delta * w i).
{ apply Rabs_le_between in HD. destruct Hs as [-> | ->]; lra. }
rewrite EQ.
assert (N' : (a i - Rabs (a i) + total all (fun j => Rabs (a j) * (w j / w i))) * (w i * phi t) <= k * (w i * phi t)).
{ apply Rmult_le_compat_r; [|exact N]. apply Rlt_le, Rmult_lt_0_compat; auto. }
assert (X : 1 <= exp (k * t)).
{ rewrite <- exp_0. apply exp_le, Rmult_le_pos; lra. }
assert (Y : w i * (delta + m) <= w i * (exp (k * t) * (delta + m))).
{ apply Rmult_le_compat_l. lra. rewrite <- (Rmult_1_l (delta + m)) at 1. apply Rmult_le_compat_r; lra. }
assert (Z : 0 < w i * m) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma continues (l : list I) t : 0 <= t <= T -> (forall s i, s = 1 \/ s = -1 -> 0 < margin s i t) ->
  exists d, 0 < d /\ forall t', t <= t' < t + d -> forall s i, In i l -> s = 1 \/ s = -1 -> 0 < margin s i t'.
Proof.
intros Ht H.
assert (L : locally t (fun t' => forall i, In i l -> 0 < margin 1 i t' /\ 0 < margin (-1) i t')).
{ induction l as [|j r IH].
  - apply filter_forall. intros t' i [].
  - assert (One : forall s, s = 1 \/ s = -1 -> locally t (fun t' => 0 < margin s j t')).
    { intros s Hs. apply continuous_pos. eexists. apply margin_derive, Ht. apply H, Hs. }
    generalize (filter_and _ _ (filter_and _ _ (One 1 (or_introl eq_refl)) (One (-1) (or_intror eq_refl))) IH).
    apply filter_imp. intros t' [O R] i [<-|Hi]; auto. }
destruct L as [d Hd]. exists d. split. apply cond_pos.
intros t' Ht' s i Hi Hs.
assert (Q : Rabs (t' - t) < d) by (rewrite Rabs_pos_eq; lra).
destruct (Hd t' Q i Hi) as [H1 H2]. destruct Hs as [-> | ->]; assumption.
Qed.

Lemma stays_below : forall t, 0 <= t -> t <= T -> forall s i, s = 1 \/ s = -1 -> 0 < margin s i t.
Proof.
apply (real_induction (fun t => t <= T -> forall s i, s = 1 \/ s = -1 -> 0 < margin s i t) 0).
- intros _ s i Hs. unfold margin, phi. rewrite !Rmult_0_r, exp_0. specialize (Hstart i). simpl in Hstart.
  apply Rabs_le_between in Hstart. assert (W := Rmult_lt_0_compat _ _ (Hw i) Hm). destruct Hs as [-> | ->]; lra.
- intros t Ht H. destruct (Rlt_dec t T) as [Hlt|Hlt].
  + destruct (continues all t ltac:(lra)) as (d & Hd & C). { intros s i Hs. apply H; auto; lra. }
    exists d. exact (conj Hd (fun t' Ht' _ s i => C t' Ht' s i (Hall i))).
  + exists 1. split. lra. intros t' Ht' Hle s i. replace t' with t by lra. apply H; lra.
- intros t Ht H Hle.
  assert (G : forall s i, s = 1 \/ s = -1 -> 0 <= margin s i t).
  { intros s i Hs. apply (closed_ge (margin s i) 0 t 0 Ht). eexists. apply margin_derive; lra.
    intros t' Ht'. apply Rlt_le, H; auto; lra. }
  intros s i Hs. destruct (Rle_lt_or_eq_dec _ _ (G s i Hs)) as [|E]; auto. exfalso.
  assert (B : norm_at_most w (fun i => u i t) (phi t)).
  { intros j. assert (G1 := G 1 j (or_introl eq_refl)). assert (G2 := G (-1) j (or_intror eq_refl)).
    unfold margin in G1, G2.
    apply Rabs_le. lra. }
  destruct (derive_pos_before (margin s i) t _ (margin_derive s i t ltac:(lra)) (eq_sym E)) as (d & Hd & N).
  { apply margin_inward; auto. lra. }
  set (t' := Rmax 0 (t - d / 2)).
  assert (T1 : 0 <= t') by apply Rmax_l. assert (T2 : t - d / 2 <= t') by apply Rmax_r.
  assert (T3 : t' < t) by (unfold t', Rmax; destruct Rle_dec; lra).
  specialize (H t' ltac:(lra) ltac:(lra) s i Hs). specialize (N t' ltac:(lra)). lra.
Qed.

End Above.

Theorem logarithmic_growth t : 0 <= t <= T -> norm_at_most w (fun i => u i t) (exp (k * t) * (e0 + delta * t)).
Proof.
intros Ht i. assert (W := Hw i).
assert (He0 : 0 <= e0).
{ apply Rmult_le_reg_r with (w i); auto. rewrite Rmult_0_l. apply Rle_trans with (2 := Hstart i). apply Rabs_pos. }
set (G := exp (k * T) * (1 + T)).
assert (HG : 0 < G) by (apply Rmult_lt_0_compat; [apply exp_pos|lra]).
assert (Hg : exp (k * t) * (1 + t) <= G).
{ apply Rmult_le_compat; [apply Rlt_le, exp_pos|lra|apply exp_le, Rmult_le_compat_l; lra|lra]. }
apply le_epsilon. intros eta Heta.
set (m := Rmin ((R0 - exp (k * T) * (e0 + delta * T)) / G) (eta / w i / G)).
assert (Hm : 0 < m) by (apply Rmin_pos; repeat apply Rdiv_lt_0_compat; lra).
assert (M1 : m * G <= R0 - exp (k * T) * (e0 + delta * T)).
{ apply Rmult_le_reg_r with (/ G). apply Rinv_0_lt_compat, HG. rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra.
  apply Rmin_l. }
assert (M2 : m * G * w i <= eta).
{ apply Rmult_le_reg_r with (/ w i). apply Rinv_0_lt_compat, W. rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra.
  apply Rmult_le_reg_r with (/ G). apply Rinv_0_lt_compat, HG. rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra.
  apply Rmin_r. }
assert (S : exp (k * T) * (e0 + m + (delta + m) * T) <= R0) by (unfold G in M1; lra).
assert (B1 := stays_below m Hm He0 S t ltac:(lra) ltac:(lra) 1 i (or_introl eq_refl)).
assert (B2 := stays_below m Hm He0 S t ltac:(lra) ltac:(lra) (-1) i (or_intror eq_refl)).
unfold margin in B1, B2.
assert (L : m * (exp (k * t) * (1 + t)) * w i <= m * G * w i).
{ apply Rmult_le_compat_r. lra. apply Rmult_le_compat_l; lra. }
apply Rabs_le. lra.
Qed.

End Growth.
