(** * The compliant model: motions that come from t = -oo in contact

    A motion in contact on t < tm (tm = +oo allowed) whose b does not grow exponentially as t -> -oo is "trivial + C
    slow". *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral
  CompliantSlow CompliantMechanism CompliantCone CompliantUnique.
Open Scope R_scope.

(** for instance polynomial growth *)
Lemma slow_of_poly eps (f : R -> R) (A T1 : R) (n : nat) : 0 < eps ->
  (forall t, t <= T1 -> Rabs (f t) <= A * (- t) ^ n) -> slow_at_left eps f.
Proof.
intros He H.
destruct (Rpower_le_exp (INR n)) as (B & HB & HP).
exists (Rabs A * ((2 * eps) ^ n * B)), (Rmin T1 (- (2 * eps))).
intros t Ht.
assert (M1 := Rmin_l T1 (- (2 * eps))). assert (M2 := Rmin_r T1 (- (2 * eps))).
specialize (H t ltac:(lra)).
set (x := - t / (2 * eps)).
assert (Hx : 1 <= x).
{ unfold x. apply Rmult_le_reg_r with (2 * eps). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
specialize (HP x Hx). rewrite Rpower_pow in HP by lra.
replace (x / 8) with (- t / (16 * eps)) in HP by (unfold x; field; lra).
assert (E : (- t) ^ n = (2 * eps) ^ n * x ^ n).
{ rewrite <- Rpow_mult_distr. f_equal. unfold x. field. lra. }
rewrite E in H.
assert (P1 : 0 < (2 * eps) ^ n) by (apply pow_lt; lra).
assert (P2 : 0 < x ^ n) by (apply pow_lt; lra).
eapply Rle_trans; [exact H|].
apply Rle_trans with (Rabs A * ((2 * eps) ^ n * x ^ n)).
- apply Rmult_le_compat_r. apply Rlt_le, Rmult_lt_0_compat; auto. apply Rle_abs.
- rewrite !Rmult_assoc. apply Rmult_le_compat_l. apply Rabs_pos. apply Rmult_le_compat_l; lra.
Qed.

Lemma slow_lin (eps k : R) (b : R -> R) : 0 < eps -> slow_at_left eps b ->
  exists A T1, forall T, T <= T1 -> Rabs (b (eps * T) - k * (eps * T)) <= A * exp (- T / 16).
Proof.
intros He (Ab & Tb & Hb).
exists (Ab + Rabs (k * eps) * 16), (Rmin 0 (Tb / eps)).
intros T HT.
assert (HT0 : T <= 0) by (eapply Rle_trans; [exact HT|apply Rmin_l]).
assert (HT1 : eps * T <= Tb).
{ replace Tb with (eps * (Tb / eps)) by (field; lra).
  apply Rmult_le_compat_l. lra. eapply Rle_trans; [exact HT|apply Rmin_r]. }
specialize (Hb _ HT1). replace (- (eps * T) / (16 * eps)) with (- T / 16) in Hb by (field; lra).
assert (HX1 : 1 + - T / 16 <= exp (- T / 16)) by apply exp_ineq1_le.
assert (HTX : Rabs T <= 16 * exp (- T / 16)) by (rewrite Rabs_left1 by auto; lra).
eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp, <- Rmult_assoc, (Rabs_mult (k * eps)).
assert (Rabs (k * eps) * Rabs T <= Rabs (k * eps) * (16 * exp (- T / 16)))
  by (apply Rmult_le_compat_l; auto using Rabs_pos).
lra.
Qed.

Section MechUniq.
Variables (a1 a2 a3 eps : R).
Hypothesis Ha1 : a1 < 0.
Hypothesis Ha3 : a3 < 0.
Hypothesis Heps : 0 < eps.
Hypothesis Hbeta : not_nat (a3 / a1).

(** t < tm in terms of T = t/eps *)
Definition tmT (tm : Rbar) : Rbar := match tm with Finite r => Finite (r / eps) | x => x end.

Lemma tmT_lt (tm : Rbar) (T : R) : Rbar_lt T (tmT tm) <-> Rbar_lt (eps * T) tm.
Proof.
destruct tm as [r| |]; simpl; try tauto.
split; intros H.
- replace r with (eps * (r / eps)) by (field; lra). apply Rmult_lt_compat_l; auto.
- apply Rmult_lt_reg_l with eps; auto. replace (eps * (r / eps)) with r by (field; lra). auto.
Qed.

Lemma scale_derive (f : R -> R) (l k T : R) : is_derive f (eps * T) l ->
  is_derive (fun T => k * f (eps * T)) T (k * eps * l).
Proof.
intros D. rewrite Rmult_assoc.
apply (is_derive_scal (fun T => f (eps * T))).
apply (is_derive_comp f (fun T => eps * T) T l eps). apply D.
auto_derive; auto; ring.
Qed.

Lemma chain_scale tm b0 b1 b2 b3 : dev_chain tm a1 a3 eps b0 b1 b2 b3 ->
  T_chain (- a1 * eps) (a3 / a1) (tmT tm) (fun T => b0 (eps * T)) (fun T => eps * b1 (eps * T))
    (fun T => eps ^ 2 * b2 (eps * T)) (fun T => eps ^ 3 * b3 (eps * T)).
Proof.
intros (D0 & D1 & D2 & D3).
refine (conj _ (conj _ (conj _ _))); intros T HT; apply tmT_lt in HT.
- apply (is_derive_ext (fun T => 1 * b0 (eps * T))).
  { intros s. match goal with |- ?x = ?y => change (@eq R x y) end. ring. }
  eapply is_derive_val. apply (scale_derive b0 _ 1 T (D0 _ HT)). ring.
- eapply is_derive_val. apply (scale_derive b1 _ eps T (D1 _ HT)). ring.
- eapply is_derive_val. apply (scale_derive b2 _ (eps ^ 2) T (D2 _ HT)). ring.
- eapply is_derive_val.
  apply (scale_derive b3 _ (eps ^ 3) T (D3 _ HT)). field. split; lra.
Qed.

(** Every contact trajectory on t < tm (tm = +oo allowed), with p = a1 t and slow growth of b at t -> -oo,
    is a slow solution. *)
Theorem contact_unique (tm : Rbar) (p b y v z : R -> R) : (forall t : R, Rbar_lt t tm -> p t = a1 * t) ->
  (forall t : R, Rbar_lt t tm -> model_at a1 a2 a3 eps linear_force p b y v z t) ->
  slow_at_left eps b ->
  exists C, forall t : R, Rbar_lt t tm -> p t = sol_p a1 t /\ b t = sol_b a1 a2 a3 eps C t /\
    y t = sol_y a1 a2 a3 eps C t /\
    v t = sol_v a1 a3 eps C t /\ z t = sol_z a1 a2 a3 eps C t /\ linear_force eps (y t) (z t) = sol_l a1 a2 a3 eps C t.
Proof.
intros Hp H Gb.
assert (Ha13 := a13 a1 a3 Ha1 Hbeta).
destruct (recover_converse a1 a2 a3 eps ltac:(lra) Ha13 Heps tm p b y v z Hp H)
  as (b0 & b1 & b2 & b3 & HC & HR & HE).
assert (HS := chain_scale _ _ _ _ _ HC).
destruct (slow_unique_chain0 (- a1 * eps) (a3 / a1) (He' a1 eps Ha1 Heps) Hbeta _ _ _ _ _ HS) as (C & HCC).
- destruct (slow_lin eps (a2 / (a1 - a3) * a1) b Heps Gb) as (A & T1 & HA).
  exists A, T1. intros T HT. destruct (HE (eps * T)) as (E & _). rewrite E. apply HA, HT.
- exists C.
  destruct HC as (D0 & D1 & D2 & D3).
  assert (F0 : forall t : R, Rbar_lt t tm -> b0 t = hb a1 a3 eps C 0 t).
  { intros t Ht. assert (Et : eps * (t / eps) = t) by (field; lra).
    assert (HX := HCC (t / eps)). rewrite Et in HX. rewrite HX.
    unfold hb. simpl. field. apply tmT_lt. rewrite Et. exact Ht. }
  assert (DH : forall n t, is_derive (hb a1 a3 eps C n) t (hb a1 a3 eps C (S n) t)).
  { intros n t. apply hb_derive; auto. }
  assert (ST : forall (f f' : R -> R) n, (forall t : R, Rbar_lt t tm -> f t = hb a1 a3 eps C n t) ->
     (forall t : R, Rbar_lt t tm -> is_derive f t (f' t)) ->
     forall t : R, Rbar_lt t tm -> f' t = hb a1 a3 eps C (S n) t).
  { intros f f' n E D t Ht. rewrite <- (is_derive_unique _ _ _ (D t Ht)), <- (is_derive_unique _ _ _ (DH n t)).
    apply Derive_ext_loc.
    destruct tm as [r| |]; [|exists (mkposreal 1 Rlt_0_1); intros u _; apply E; exact I|destruct Ht].
    simpl in Ht. assert (Hr : 0 < r - t) by lra.
    exists (mkposreal _ Hr). intros u Hu. apply E. simpl.
    apply Rabs_def2 in Hu. unfold minus, plus, opp in Hu; simpl in Hu. lra. }
  assert (F1 := ST b0 b1 0%nat F0 D0). assert (F2 := ST b1 b2 1%nat F1 D1). assert (F3 := ST b2 b3 2%nat F2 D2).
  intros t Ht. destruct (HR t Ht) as (R1 & R2 & R3 & R4 & R5).
  assert (Ry : y t = sol_y a1 a2 a3 eps C t).
  { rewrite R3. unfold sol_y, rec_y. rewrite <- F0, <- F1, <- F2, <- F3 by exact Ht. reflexivity. }
  assert (Rz : z t = sol_z a1 a2 a3 eps C t).
  { rewrite R5. unfold sol_z, rec_z. rewrite <- F0, <- F1, <- F2, <- F3 by exact Ht. reflexivity. }
  refine (conj _ (conj _ (conj Ry (conj _ (conj Rz _))))).
  + exact R1.
  + rewrite R2. unfold sol_b, rec_b. rewrite <- F0 by exact Ht. reflexivity.
  + rewrite R4. unfold sol_v, rec_v. rewrite <- F0, <- F1, <- F2, <- F3 by exact Ht. reflexivity.
  + rewrite Ry, Rz. apply sol_force; auto.
Qed.

End MechUniq.
