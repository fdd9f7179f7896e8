(** * The compliant model: how often the force vanishes

    F_b has at most n real zeros if b < n, by Rolle's theorem and the sign of F_b^(n); the force of a slow motion at
    most n + 1 if beta < n + 2. If the force and its first n derivatives are >= 0 at one time, contact is kept from then
    on. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral
  CompliantSlow CompliantMechanism.
Import ListNotations.
Open Scope R_scope.

Section Tail.
Variables (a1 a2 a3 eps C : R).
Hypothesis Ha1 : a1 < 0.
Hypothesis Ha3 : a3 < 0.
Hypothesis Heps : 0 < eps.
Hypothesis Hbeta : not_nat (a3 / a1).

(** *** Every non-integer beta: the tail lemma. k-th derivative of the force, k >= 1 *)
Definition dl (k : nat) (t : R) : R :=
  match k with O => sol_l a1 a2 a3 eps C t | S _ => - / a3 * hb a1 a3 eps C (S k) t end.

Lemma dl_derive k t : is_derive (dl k) t (dl (S k) t).
Proof.
destruct k as [|k].
- simpl. eapply is_derive_val. apply sol_l_derive; auto. unfold hb. field. split; lra.
- apply (is_derive_scal (hb a1 a3 eps C (S (S k)))), hb_derive; auto.
Qed.

Lemma dl_top n t : a3 / a1 < INR (S (S n)) -> 0 < C * Gamma (- (a3 / a1)) -> 0 < dl (S n) t.
Proof.
intros Hn HC. unfold dl, hb.
assert (Hg := not_nat_Gamma (a3 / a1) Hbeta).
assert (HS := Fe_sign (- a1 * eps) (He' a1 eps Ha1 Heps) (a3 / a1) (S (S n)) Hbeta Hn (t / eps)).
set (G := Gamma (- (a3 / a1))) in *. set (F := Derive_n (Fe (- a1 * eps) (a3 / a1)) (S (S n)) (t / eps)) in *.
assert (He : 0 < eps ^ S (S n)) by (apply pow_lt, Heps).
set (E := eps ^ S (S n)) in *.
replace (- / a3 * (C * F / E)) with (/ - a3 * / E * ((C * G) * (G * F) * (/ G) ^ 2))
  by (field; repeat split; auto; lra).
apply Rmult_lt_0_compat. apply Rmult_lt_0_compat; apply Rinv_0_lt_compat; lra.
apply Rmult_lt_0_compat. apply Rmult_lt_0_compat; auto. apply pow2_gt_0, Rinv_neq_0_compat, Hg.
Qed.

(** If the force and its first n derivatives are >= 0 at t0, beta < n + 2, C of the side-rule sign: contact is never
    lost after t0. (n = 0 for beta < 2.) *)
Theorem tail_IWC n t0 : a3 / a1 < INR (S (S n)) -> 0 < C * Gamma (- (a3 / a1)) ->
  (forall k, (k <= n)%nat -> 0 <= dl k t0) ->
  forall t, t0 < t -> 0 < sol_l a1 a2 a3 eps C t.
Proof.
intros Hn HC H0.
assert (A : forall j k, (k + j = S n)%nat -> forall t, t0 < t -> 0 < dl k t).
{ induction j as [|j IH]; intros k Hk t Ht.
  - replace k with (S n) by lia. apply dl_top; auto.
  - destruct (mvt_open (dl k) (dl (S k)) t0 t Ht (fun s _ => dl_derive k s)) as (c & Hc & E).
    assert (H1 := IH (S k) ltac:(lia) c (proj1 Hc)).
    assert (H2 := H0 k ltac:(lia)).
    assert (0 < dl (S k) c * (t - t0)) by (apply Rmult_lt_0_compat; lra). lra. }
intros t Ht. exact (A (S n) 0%nat ltac:(lia) t Ht).
Qed.

End Tail.

(** *** Rolle *)
Lemma rolle_list (g g' : R -> R) : (forall t, is_derive g t (g' t)) ->
  forall l a, StronglySorted Rlt (a :: l) -> (forall t, In t (a :: l) -> g t = 0) ->
  exists l', length l' = length l /\ StronglySorted Rlt l' /\ (forall t, In t l' -> g' t = 0) /\
    (forall t, In t l' -> a < t).
Proof.
intros D l. induction l as [|c l IH]; intros a HS H0.
- exists nil. repeat split; auto. constructor. intros t []. intros t [].
- assert (Hac : a < c).
  { inversion HS as [|? ? _ HF]; subst. inversion HF; auto. }
  assert (HS' : StronglySorted Rlt (c :: l)) by (inversion HS; auto).
  destruct (IH c HS' (fun t Ht => H0 t (or_intror Ht))) as (l' & L1 & L2 & L3 & L4).
  destruct (mvt_open g g' a c Hac (fun s _ => D s)) as (d & Hd & E).
  rewrite (H0 c), (H0 a) in E by (simpl; auto).
  assert (Z : g' d = 0).
  { destruct (Rmult_integral (g' d) (c - a)) as [H|H]; auto; lra. }
  exists (d :: l'). repeat split.
  + simpl; auto.
  + constructor; auto. apply Forall_forall. intros t Ht. specialize (L4 t Ht). lra.
  + intros t [<-|Ht]; auto.
  + intros t [<-|Ht]. lra. specialize (L4 t Ht). lra.
Qed.

Lemma rolle_count n : forall (g : nat -> R -> R), (forall k t, is_derive (g k) t (g (S k) t)) ->
  (forall t, g n t <> 0) -> forall l, StronglySorted Rlt l -> (forall t, In t l -> g 0%nat t = 0) ->
    (length l <= n)%nat.
Proof.
induction n as [|n IH]; intros g D Hn l HS H0.
- destruct l as [|a l]; auto. exfalso. apply (Hn a), H0. simpl; auto.
- destruct l as [|a l]. simpl; lia.
  destruct (rolle_list (g 0%nat) (g 1%nat) (D 0%nat) l a HS H0) as (l' & L1 & L2 & L3 & _).
  simpl. apply le_n_S. rewrite <- L1.
  apply (IH (fun k => g (S k))); auto.
Qed.

(** F_b has at most n real zeros if b < n (n = ceil b), at every eps. *)
Theorem Fe_zeros e b n l : 0 < e -> not_nat b -> b < INR n -> StronglySorted Rlt l ->
  (forall t, In t l -> Fe e b t = 0) -> (length l <= n)%nat.
Proof.
intros He Hb Hn HS H0.
apply (rolle_count n (fun k => Derive_n (Fe e b) k)); auto.
- intros k t. apply (Derive_correct (Derive_n (Fe e b) k)). exact (Fe_ex_derive_n e He b (S k) t Hb).
- intros t E. assert (H := Fe_sign e He b n Hb Hn t). rewrite E in H. lra.
Qed.

(** The total force of a slow solution vanishes at most n + 1 times if beta < n + 2. *)
Theorem force_zeros a1 a2 a3 eps C n l : a1 < 0 -> a3 < 0 -> 0 < eps -> not_nat (a3 / a1) -> C <> 0 ->
  a3 / a1 < INR (S (S n)) -> StronglySorted Rlt l ->
  (forall t, In t l -> sol_l a1 a2 a3 eps C t = 0) -> (length l <= S n)%nat.
Proof.
intros Ha1 Ha3 He Hb HC Hn HS H0.
apply (rolle_count (S n) (dl a1 a2 a3 eps C)); auto.
- intros k t. apply dl_derive; auto.
- intros t. unfold dl, hb.
  assert (HF := Fe_sign (- a1 * eps) (He' a1 eps Ha1 He) (a3 / a1) (S (S n)) Hb Hn (t / eps)).
  intros E. set (F := Derive_n (Fe (- a1 * eps) (a3 / a1)) (S (S n)) (t / eps)) in *.
  assert (HE : eps ^ S (S n) <> 0) by (apply pow_nonzero; lra).
  assert (EF : F = - a3 * eps ^ S (S n) / C * (- / a3 * (C * F / eps ^ S (S n)))) by (field; repeat split; auto; lra).
  rewrite E, Rmult_0_r in EF. rewrite EF, Rmult_0_r in HF. lra.
Qed.
