(** * The compliant model: a cone at -oo

    With u = w' + w'', s = u', d = w', p = -eT the form Q = s^2 + p u^2 + u s + ka d^2 - K w^2 satisfies Q' <= -Q/2 for
    T near -oo. So a solution with w(t0) = 0 that grows less than e^(|T|/8) vanishes. The growth of w alone bounds that
    of w', w'', w''' (three mean values and the equation). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus Gronwall Family.
Open Scope R_scope.

Lemma Rbar_lt_le (s t : R) (tm : Rbar) : s <= t -> Rbar_lt t tm -> Rbar_lt s tm.
Proof. destruct tm; simpl; intros; auto; lra. Qed.

(** the inequality behind the cone *)
Lemma cone_ineq (s u d w p e mu nu K ka : R) :
  0 < e -> 26 * nu ^ 2 <= K -> 7 * mu ^ 2 + 4 * K <= ka -> 11 + 4 * ka <= p ->
  (- s ^ 2 - u * s - (p + e) * u ^ 2 + (2 * s + u) * (u - mu * d - nu * w)
   + 2 * ka * d * u - 2 * ka * d ^ 2 - 2 * K * w * d)
  + / 2 * (s ^ 2 + p * u ^ 2 + u * s + ka * d ^ 2 - K * w ^ 2) <= 0.
Proof.
intros He HK Hka Hp.
assert (HK0 : 0 <= K) by (generalize (pow2_ge_0 nu); lra).
assert (Hka0 : 0 <= ka) by (generalize (pow2_ge_0 mu); lra).
set (m := mu * d). set (n := nu * w).
assert (S1 : 0 <= (s - (3 / 2 * u - 2 * m - 2 * n)) ^ 2) by apply pow2_ge_0.
assert (S2 : (3 / 2 * u - 2 * m - 2 * n) ^ 2 <= 3 * (9 / 4 * u ^ 2 + 4 * m ^ 2 + 4 * n ^ 2)).
{ assert (0 <= (3 / 2 * u + 2 * m) ^ 2) by apply pow2_ge_0.
  assert (0 <= (3 / 2 * u + 2 * n) ^ 2) by apply pow2_ge_0.
  assert (0 <= (2 * m - 2 * n) ^ 2) by apply pow2_ge_0. lra. }
assert (S3 : 0 <= (u + m) ^ 2) by apply pow2_ge_0.
assert (S4 : 0 <= (u + n) ^ 2) by apply pow2_ge_0.
assert (S5 : 2 * ka * d * u <= / 2 * (ka * d ^ 2) + 2 * (ka * u ^ 2)).
{ assert (0 <= ka * (d - 2 * u) ^ 2) by (apply Rmult_le_pos; [auto|apply pow2_ge_0]). lra. }
assert (S6 : - 2 * K * w * d <= / 4 * (K * w ^ 2) + 4 * (K * d ^ 2)).
{ assert (0 <= K * (w + 4 * d) ^ 2) by (apply Rmult_le_pos; [auto|apply pow2_ge_0]). lra. }
assert (S7 : 26 * n ^ 2 <= K * w ^ 2).
{ unfold n. replace (26 * (nu * w) ^ 2) with (26 * nu ^ 2 * w ^ 2) by ring.
  apply Rmult_le_compat_r; auto. apply pow2_ge_0. }
assert (S8 : 7 * m ^ 2 + 4 * (K * d ^ 2) <= ka * d ^ 2).
{ unfold m. replace (7 * (mu * d) ^ 2 + 4 * (K * d ^ 2)) with ((7 * mu ^ 2 + 4 * K) * d ^ 2) by ring.
  apply Rmult_le_compat_r; auto. apply pow2_ge_0. }
assert (S9 : 11 * u ^ 2 + 4 * (ka * u ^ 2) <= p * u ^ 2).
{ replace (11 * u ^ 2 + 4 * (ka * u ^ 2)) with ((11 + 4 * ka) * u ^ 2) by ring.
  apply Rmult_le_compat_r; auto. apply pow2_ge_0. }
assert (S10 : 0 <= e * u ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
assert (Hm2 := pow2_ge_0 m). assert (Hn2 := pow2_ge_0 n). assert (Hu2 := pow2_ge_0 u).
lra.
Qed.

(** interpolation: bounds on w0 and w4 over an interval bound w1, w2, w3 *)
Lemma mvt_bound (f f' : R -> R) (x y B d : R) : 0 < d -> d <= y - x ->
  (forall t, x <= t <= y -> is_derive f t (f' t)) -> Rabs (f x) <= B -> Rabs (f y) <= B ->
  exists c, x < c < y /\ Rabs (f' c) <= 2 * B / d.
Proof.
intros Hd Hxy D Hx Hy.
destruct (mvt_open f f' x y ltac:(lra) D) as (c & Hc & E).
exists c. split; auto.
assert (HB : Rabs (f' c * (y - x)) <= 2 * B).
{ rewrite <- E. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp. lra. }
rewrite Rabs_mult, (Rabs_pos_eq (y - x)) in HB by lra.
apply Rmult_le_reg_r with d; auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
eapply Rle_trans; [|exact HB]. apply Rmult_le_compat_l; auto using Rabs_pos.
Qed.

Lemma lip_bound (f f' : R -> R) (a h B c t : R) : (forall s, a <= s <= a + h -> is_derive f s (f' s)) ->
  (forall s, a <= s <= a + h -> Rabs (f' s) <= B) -> a <= c <= a + h -> a <= t <= a + h ->
  Rabs (f t) <= Rabs (f c) + h * B.
Proof.
intros D HB Hc Ht.
assert (B0 : 0 <= B) by (generalize (Rabs_pos (f' c)) (HB c Hc); lra).
destruct (MVT_gen f c t f') as [x [Hx E]].
- intros x Hx. apply D. assert (Rmin_l := Rmin_glb c t a (proj1 Hc) (proj1 Ht)).
  assert (Rmax_l := Rmax_lub c t (a + h) (proj2 Hc) (proj2 Ht)). lra.
- intros x Hx. apply continuity_pt_filterlim, (ex_derive_continuous f x). exists (f' x). apply D.
  assert (Rmin_l := Rmin_glb c t a (proj1 Hc) (proj1 Ht)).
  assert (Rmax_l := Rmax_lub c t (a + h) (proj2 Hc) (proj2 Ht)). lra.
- assert (Rmin_l := Rmin_glb c t a (proj1 Hc) (proj1 Ht)).
  assert (Rmax_l := Rmax_lub c t (a + h) (proj2 Hc) (proj2 Ht)).
  specialize (HB x ltac:(lra)).
  replace (f t) with (f c + (f t - f c)) by ring. rewrite E.
  eapply Rle_trans. apply Rabs_triang. apply Rplus_le_compat_l.
  rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat; auto using Rabs_pos.
  unfold Rabs; destruct Rcase_abs; lra.
Qed.

Lemma interpolation (w0 w1 w2 w3 w4 : R -> R) (a h M0 M4 : R) : 0 < h ->
  (forall t, a <= t <= a + h -> is_derive w0 t (w1 t)) -> (forall t, a <= t <= a + h -> is_derive w1 t (w2 t)) ->
  (forall t, a <= t <= a + h -> is_derive w2 t (w3 t)) -> (forall t, a <= t <= a + h -> is_derive w3 t (w4 t)) ->
  (forall t, a <= t <= a + h -> Rabs (w0 t) <= M0) -> (forall t, a <= t <= a + h -> Rabs (w4 t) <= M4) ->
  forall t, a <= t <= a + h ->
   Rabs (w3 t) <= 4096 * (M0 / h ^ 3) + h * M4 /\
   Rabs (w2 t) <= 4352 * (M0 / h ^ 2) + h ^ 2 * M4 /\
   Rabs (w1 t) <= 4368 * (M0 / h) + h ^ 3 * M4.
Proof.
intros Hh D0 D1 D2 D3 B0 B4.
assert (X : forall i : R, 0 <= i <= 7 -> exists c, a + i * (h / 8) < c < a + (i + 1) * (h / 8) /\
  Rabs (w1 c) <= 16 * (M0 / h)).
{ intros i Hi.
  assert (0 <= i * (h / 8) <= 7 * (h / 8)) by (split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_r; lra]).
  destruct (mvt_bound w0 w1 (a + i * (h / 8)) (a + (i + 1) * (h / 8)) M0 (h / 8)) as (c & Hc & E); try lra.
  - intros t Ht. apply D0. lra.
  - apply B0; lra.
  - apply B0; lra.
  - exists c. split; auto. replace (16 * (M0 / h)) with (2 * M0 / (h / 8)) by (field; lra). exact E. }
destruct (X 0 ltac:(lra)) as (c0 & C0 & E0). destruct (X 2 ltac:(lra)) as (c1 & C1 & E1).
destruct (X 4 ltac:(lra)) as (c2 & C2 & E2). destruct (X 6 ltac:(lra)) as (c3 & C3 & E3).
destruct (mvt_bound w1 w2 c0 c1 (16 * (M0 / h)) (h / 8)) as (d0 & D0' & F0); try lra.
{ intros t Ht. apply D1. lra. }
destruct (mvt_bound w1 w2 c2 c3 (16 * (M0 / h)) (h / 8)) as (d1 & D1' & F1); try lra.
{ intros t Ht. apply D1. lra. }
destruct (mvt_bound w2 w3 d0 d1 (2 * (16 * (M0 / h)) / (h / 8)) (h / 8)) as (x & Dx & Fx); try lra.
{ intros t Ht. apply D2. lra. }
assert (G3 : forall t, a <= t <= a + h -> Rabs (w3 t) <= 4096 * (M0 / h ^ 3) + h * M4).
{ intros t Ht. eapply Rle_trans. apply (lip_bound w3 w4 a h M4 x t); auto; lra.
  apply Rplus_le_compat_r. eapply Rle_trans; [exact Fx|]. right. field. lra. }
assert (G2 : forall t, a <= t <= a + h -> Rabs (w2 t) <= 4352 * (M0 / h ^ 2) + h ^ 2 * M4).
{ intros t Ht. eapply Rle_trans. apply (lip_bound w2 w3 a h _ d0 t D2 G3); auto; lra.
  apply Rle_trans with (2 * (16 * (M0 / h)) / (h / 8) + h * (4096 * (M0 / h ^ 3) + h * M4)).
  apply Rplus_le_compat_r. exact F0. right. field. lra. }
intros t Ht. refine (conj (G3 t Ht) (conj (G2 t Ht) _)).
eapply Rle_trans. apply (lip_bound w1 w2 a h _ c0 t D1 G2); auto; lra.
apply Rle_trans with (16 * (M0 / h) + h * (4352 * (M0 / h ^ 2) + h ^ 2 * M4)).
apply Rplus_le_compat_r. exact E0. right. field. lra.
Qed.

Section Uniq.
Variables (e beta : R).
Hypothesis He : 0 < e.

(** chain form of the equation in T, for T < tm (tm = +oo allowed) *)
Definition T_chain (tm : Rbar) (w0 w1 w2 w3 : R -> R) : Prop :=
  (forall t : R, Rbar_lt t tm -> is_derive w0 t (w1 t)) /\ (forall t : R, Rbar_lt t tm -> is_derive w1 t (w2 t)) /\
  (forall t : R, Rbar_lt t tm -> is_derive w2 t (w3 t)) /\
  (forall t : R, Rbar_lt t tm -> is_derive w3 t (e * (- beta * w0 t + (1 - beta + t) * w1 t + t * w2 t) - 2 * w3 t)).

Definition small_at_left (w : R -> R) : Prop :=
  exists A T1, forall t, t <= T1 -> Rabs (w t) <= A * exp (- t / 8).

(** Zero data at one time stay zero. Plan: E = w0^2 + w1^2 + w2^2 + w3^2 has |E'| <= L E between t0 and t, where L
    bounds the coefficients of the equation there; E(t0) = 0, so E = 0 by [one_step_zero]. *)
Lemma T_chain_zero tm w0 w1 w2 w3 (t0 : R) : T_chain tm w0 w1 w2 w3 -> Rbar_lt t0 tm ->
  w0 t0 = 0 -> w1 t0 = 0 -> w2 t0 = 0 -> w3 t0 = 0 -> forall t : R, Rbar_lt t tm -> w0 t = 0.
Proof.
intros (D0 & D1 & D2 & D3) Htm H0 H1 H2 H3 t Ht.
assert (Hm : forall s, Rmin t0 t <= s <= Rmax t0 t -> Rbar_lt s tm /\ Rabs (s - t0) <= Rabs (t - t0)).
{ intros s [Hs1 Hs2]. destruct (Rle_lt_dec t0 t) as [H|H].
  - rewrite Rmin_left in Hs1 by lra. rewrite Rmax_right in Hs2 by lra. split.
    + apply (Rbar_lt_le s t); auto.
    + rewrite !Rabs_pos_eq by lra. lra.
  - rewrite Rmin_right in Hs1 by lra. rewrite Rmax_left in Hs2 by lra. split.
    + apply (Rbar_lt_le s t0); auto.
    + rewrite !Rabs_left1 by lra. lra. }
set (E := fun t => w0 t ^ 2 + w1 t ^ 2 + w2 t ^ 2 + w3 t ^ 2).
set (w4 := fun t => e * (- beta * w0 t + (1 - beta + t) * w1 t + t * w2 t) - 2 * w3 t).
set (E' := fun t => 2 * w0 t * w1 t + 2 * w1 t * w2 t + 2 * w2 t * w3 t + 2 * w3 t * w4 t).
set (B := Rabs t0 + Rabs (t - t0)).
set (L0 := e * (Rabs beta + 1 + Rabs beta + B)).
assert (HE : E t = 0).
{ apply (one_step_zero E E' t0 t (5 + 3 * L0 + 4)).
  - intros s Hs. destruct (Hm s Hs) as [Hs' _]. unfold E, E'. evar_last.
    + apply (is_derive_plus (fun t => w0 t ^ 2 + w1 t ^ 2 + w2 t ^ 2) (fun t => w3 t ^ 2)).
      apply (is_derive_plus (fun t => w0 t ^ 2 + w1 t ^ 2) (fun t => w2 t ^ 2)).
      apply (is_derive_plus (fun t => w0 t ^ 2) (fun t => w1 t ^ 2)).
      apply is_derive_pow, D0, Hs'. apply is_derive_pow, D1, Hs'. apply is_derive_pow, D2, Hs'.
      apply is_derive_pow, D3, Hs'.
    + unfold plus, w4; simpl; ring.
  - intros s. unfold E. generalize (pow2_ge_0 (w0 s)) (pow2_ge_0 (w1 s)) (pow2_ge_0 (w2 s)) (pow2_ge_0 (w3 s)). lra.
  - unfold E. rewrite H0, H1, H2, H3. ring.
  - intros s Hsm. destruct (Hm s Hsm) as [_ Hs]. unfold E, E', w4.
    assert (Hs0 : Rabs s <= B).
    { unfold B. replace s with (t0 + (s - t0)) at 1 by ring. eapply Rle_trans. apply Rabs_triang. lra. }
    assert (HB : 0 <= B) by (generalize (Rabs_pos s); lra).
    assert (Hb := Rabs_pos beta).
    assert (C0 : Rabs (- e * beta) <= L0).
    { rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq e) by lra. unfold L0. apply Rmult_le_compat_l; lra. }
    assert (C1 : Rabs (e * (1 - beta + s)) <= L0).
    { rewrite Rabs_mult, (Rabs_pos_eq e) by lra. unfold L0. apply Rmult_le_compat_l. lra.
      eapply Rle_trans. apply Rabs_triang. unfold Rminus.
      generalize (Rabs_triang 1 (- beta)). rewrite Rabs_Ropp, Rabs_R1. lra. }
    assert (C2 : Rabs (e * s) <= L0).
    { rewrite Rabs_mult, (Rabs_pos_eq e) by lra. unfold L0. apply Rmult_le_compat_l; lra. }
    generalize (two_ab (w0 s) (w1 s)) (two_ab (w1 s) (w2 s)) (two_ab (w2 s) (w3 s))
      (prod_ab (w3 s) (w0 s) _ _ C0) (prod_ab (w3 s) (w1 s) _ _ C1) (prod_ab (w3 s) (w2 s) _ _ C2).
    replace (2 * w0 s * w1 s + 2 * w1 s * w2 s + 2 * w2 s * w3 s +
      2 * w3 s * (e * (- beta * w0 s + (1 - beta + s) * w1 s + s * w2 s) - 2 * w3 s)) with
     (2 * w0 s * w1 s + 2 * w1 s * w2 s + 2 * w2 s * w3 s + - e * beta * (2 * w3 s * w0 s)
      + e * (1 - beta + s) * (2 * w3 s * w1 s) + e * s * (2 * w3 s * w2 s) + - (4 * w3 s ^ 2)) by ring.
    intros P1 P2 P3 P4 P5 P6.
    assert (HL : 0 <= L0) by (generalize (Rabs_pos (e * s)); lra).
    eapply Rle_trans. apply Rabs_triang.
    eapply Rle_trans. apply Rplus_le_compat_r. apply Rabs_triang.
    eapply Rle_trans. do 2 apply Rplus_le_compat_r. apply Rabs_triang.
    eapply Rle_trans. do 3 apply Rplus_le_compat_r. apply Rabs_triang.
    eapply Rle_trans. do 4 apply Rplus_le_compat_r. apply Rabs_triang.
    eapply Rle_trans. do 5 apply Rplus_le_compat_r. apply Rabs_triang.
    assert (P7 : Rabs (- (4 * w3 s ^ 2)) = 4 * w3 s ^ 2).
    { rewrite Rabs_Ropp, Rabs_pos_eq; auto. generalize (pow2_ge_0 (w3 s)); lra. }
    rewrite P7.
    generalize (pow2_ge_0 (w0 s)) (pow2_ge_0 (w1 s)) (pow2_ge_0 (w2 s)) (pow2_ge_0 (w3 s)).
    revert P1 P2 P3 P4 P5 P6. generalize (w0 s ^ 2) (w1 s ^ 2) (w2 s ^ 2) (w3 s ^ 2).
    intros q0 q1 q2 q3 P1 P2 P3 P4 P5 P6 N0 N1 N2 N3.
    assert (0 <= L0 * q0) by (apply Rmult_le_pos; auto).
    assert (0 <= L0 * q1) by (apply Rmult_le_pos; auto).
    assert (0 <= L0 * q2) by (apply Rmult_le_pos; auto).
    assert (0 <= L0 * q3) by (apply Rmult_le_pos; auto).
    lra. }
unfold E in HE.
assert (H : w0 t ^ 2 = 0) by (generalize (pow2_ge_0 (w0 t)) (pow2_ge_0 (w1 t)) (pow2_ge_0 (w2 t)) (pow2_ge_0 (w3 t));
  lra).
destruct (Req_dec (w0 t) 0) as [|Hn]; auto. exfalso. apply (pow_nonzero _ 2 Hn). exact H.
Qed.

(** growth of w0 alone bounds the growth of w1, w2, w3 *)
Lemma growth_of_w0 tm w0 w1 w2 w3 : T_chain tm w0 w1 w2 w3 -> (exists r : R, Rbar_lt r tm) ->
  (exists A T1, forall t, t <= T1 -> Rabs (w0 t) <= A * exp (- t / 16)) ->
  small_at_left w0 /\ small_at_left w1 /\ small_at_left w2 /\ small_at_left w3.
Proof.
intros (D0 & D1 & D2 & D3) (r & Hr) (A0 & T0 & H0).
set (A := Rabs A0). set (T1 := Rmin (Rmin r T0) 0).
assert (HA : 0 <= A) by apply Rabs_pos.
assert (HT : forall t, t <= T1 -> t <= 0 /\ Rbar_lt t tm /\ Rabs (w0 t) <= A * exp (- t / 16)).
{ intros t Ht. assert (M1 := Rmin_l (Rmin r T0) 0). assert (M2 := Rmin_r (Rmin r T0) 0).
  assert (M3 := Rmin_l r T0). assert (M4 := Rmin_r r T0). unfold T1 in Ht.
  split; [lra|split].
  - apply (Rbar_lt_le t r); auto; lra.
  - eapply Rle_trans. apply H0; lra. apply Rmult_le_compat_r. apply Rlt_le, exp_pos. apply Rle_abs. }
set (c := 2 + e * (2 + Rabs beta)).
assert (Hbp := Rabs_pos beta).
assert (Hc : 2 <= c) by (unfold c; assert (0 <= e * (2 + Rabs beta)) by (apply Rmult_le_pos; lra); lra).
set (K := 3 * 4368 * 216 * c ^ 3 * 48 ^ 3 * (A * exp (/ 16))).
assert (HK : 0 <= K).
{ unfold K. apply Rmult_le_pos. 2: apply Rmult_le_pos; [auto|apply Rlt_le, exp_pos].
  apply Rmult_le_pos. 2: lra. apply Rmult_le_pos. lra. apply pow_le; lra. }
assert (Main : forall t, t <= T1 -> Rabs (w1 t) <= K * exp (- t / 8) /\ Rabs (w2 t) <= K * exp (- t / 8) /\
  Rabs (w3 t) <= K * exp (- t / 8)).
{ intros t Ht. destruct (HT t Ht) as (Ht0 & _).
  set (x := - t). assert (Hx : 0 <= x) by (unfold x; lra).
  set (P := c * (1 + x)).
  assert (HP : 2 <= P) by (unfold P; assert (2 * 1 <= c * (1 + x)) by (apply Rmult_le_compat; lra); lra).
  set (h := / (6 * P)).
  assert (Hh : 0 < h) by (apply Rinv_0_lt_compat; lra).
  assert (HPh : P * h = / 6) by (unfold h; field; lra).
  assert (Hh1 : h <= 1).
  { apply Rmult_le_reg_l with P. lra. rewrite HPh. lra. }
  set (a := t - h).
  set (M0 := A * exp (/ 16) * exp (x / 16)).
  assert (HM0 : 0 <= M0).
  { apply Rmult_le_pos; [apply Rmult_le_pos; auto|]; apply Rlt_le, exp_pos. }
  assert (HI : forall s, a <= s <= a + h -> s <= T1 /\ x - 0 <= - s <= x + 1).
  { unfold a, x. intros s Hs. split; lra. }
  assert (B0 : forall s, a <= s <= a + h -> Rabs (w0 s) <= M0).
  { intros s Hs. destruct (HI s Hs) as [I1 I2]. destruct (HT s I1) as (_ & _ & Hw).
    eapply Rle_trans; [exact Hw|]. unfold M0. rewrite Rmult_assoc. apply Rmult_le_compat_l; auto.
    rewrite <- exp_plus. apply exp_le. lra. }
  assert (Dl : forall s, a <= s <= a + h -> Rbar_lt s tm) by (intros s Hs; apply HT, HI, Hs).
  set (w4 := fun t => e * (- beta * w0 t + (1 - beta + t) * w1 t + t * w2 t) - 2 * w3 t) in *.
  destruct (continuity_ab_maj (fun s => Rabs (w4 s)) a (a + h)) as (m & Hm & Hm1).
  { lra. }
  { intros s Hs. apply (continuity_pt_comp w4 Rabs).
    - apply continuity_pt_filterlim, (ex_derive_continuous w4 s). unfold w4.
      assert (ex_derive w0 s) by (eexists; apply D0, Dl, Hs). assert (ex_derive w1 s) by (eexists; apply D1, Dl, Hs).
      assert (ex_derive w2 s) by (eexists; apply D2, Dl, Hs). assert (ex_derive w3 s) by (eexists; apply D3, Dl, Hs).
      auto_derive. repeat split; auto.
    - apply Rcontinuity_abs. }
  set (M4 := Rabs (w4 m)) in *.
  assert (HM4 : 0 <= M4) by apply Rabs_pos.
  assert (IP := interpolation w0 w1 w2 w3 w4 a h M0 M4 Hh (fun s Hs => D0 s (Dl s Hs)) (fun s Hs => D1 s (Dl s Hs))
    (fun s Hs => D2 s (Dl s Hs)) (fun s Hs => D3 s (Dl s Hs)) B0 Hm).
  assert (HM4e : M4 = Rabs (w4 m)) by reflexivity. clearbody M4.
  set (N := M0 / h ^ 3).
  assert (Hh2 : 0 < h ^ 2) by (apply pow_lt; auto). assert (Hh3 : 0 < h ^ 3) by (apply pow_lt; auto).
  assert (h2 : h ^ 2 <= h) by nra.
  assert (h3 : h ^ 3 <= h ^ 2) by (replace (h ^ 3) with (h * h ^ 2) by ring; nra).
  assert (HN0 : 0 <= N) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat; auto]).
  assert (HMN : M0 <= N).
  { unfold N. apply Rmult_le_reg_r with (h ^ 3); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    nra. }
  assert (HN2 : M0 / h ^ 2 <= N).
  { replace (M0 / h ^ 2) with (h * N) by (unfold N; field; lra). nra. }
  assert (HN1 : M0 / h <= N).
  { replace (M0 / h) with (h ^ 2 * N) by (unfold N; field; lra).
    assert (h ^ 2 * N <= 1 * N) by (apply Rmult_le_compat_r; lra). lra. }
  assert (h2M : h ^ 2 * M4 <= h * M4) by (apply Rmult_le_compat_r; lra).
  assert (h3M : h ^ 3 * M4 <= h * M4) by (apply Rmult_le_compat_r; lra).
  assert (IQ : forall s, a <= s <= a + h -> Rabs (w1 s) <= 4368 * N + h * M4 /\ Rabs (w2 s) <= 4368 * N + h * M4 /\
     Rabs (w3 s) <= 4368 * N + h * M4).
  { intros s Hs. destruct (IP s Hs) as (Q3 & Q2 & Q1). fold N in Q3. lra. }
  (* the equation bounds w4 *)
  assert (E4 : M4 <= P * (M0 + 3 * (4368 * N + h * M4))).
  { destruct (IQ m Hm1) as (Q1 & Q2 & Q3). assert (Q0 := B0 m Hm1). destruct (HI m Hm1) as [_ I2].
    rewrite HM4e at 1. unfold w4.
    assert (Hm0 : Rabs m <= x + 1) by (rewrite Rabs_left1; lra).
    assert (C0 : Rabs (e * - beta) <= P).
    { rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq e) by lra. unfold P, c.
      assert (e * Rabs beta <= e * (2 + Rabs beta)) by (apply Rmult_le_compat_l; lra).
      assert (0 <= (2 + e * (2 + Rabs beta)) * x) by (apply Rmult_le_pos; auto; fold c; lra). lra. }
    assert (C1 : Rabs (e * (1 - beta + m)) <= P).
    { rewrite Rabs_mult, (Rabs_pos_eq e) by lra.
      assert (Rabs (1 - beta + m) <= 2 + Rabs beta + x).
      { eapply Rle_trans. apply Rabs_triang. generalize (Rabs_triang 1 (- beta)). rewrite Rabs_Ropp, Rabs_R1.
        unfold Rminus. lra. }
      assert (e * Rabs (1 - beta + m) <= e * (2 + Rabs beta + x)) by (apply Rmult_le_compat_l; lra).
      assert (e * (2 + Rabs beta + x) <= P).
      { unfold P, c. assert (0 <= e * Rabs beta * x) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
        assert (0 <= e * x) by (apply Rmult_le_pos; lra). lra. }
      lra. }
    assert (C2 : Rabs (e * m) <= P).
    { rewrite Rabs_mult, (Rabs_pos_eq e) by lra.
      assert (e * Rabs m <= e * (x + 1)) by (apply Rmult_le_compat_l; lra).
      unfold P, c. assert (0 <= e * Rabs beta * x) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
      assert (0 <= e * Rabs beta) by (apply Rmult_le_pos; lra).
      assert (0 <= e * x) by (apply Rmult_le_pos; lra). lra. }
    replace (e * (- beta * w0 m + (1 - beta + m) * w1 m + m * w2 m) - 2 * w3 m) with
      (e * - beta * w0 m + e * (1 - beta + m) * w1 m + e * m * w2 m + - (2) * w3 m) by ring.
    assert (PP : forall k w B, Rabs k <= P -> Rabs w <= B -> Rabs (k * w) <= P * B).
    { intros k w B Hk Hw. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. }
    assert (C3 : Rabs (- (2)) <= P) by (rewrite Rabs_left; lra).
    eapply Rle_trans. apply Rabs_triang.
    eapply Rle_trans. apply Rplus_le_compat_r. apply Rabs_triang.
    eapply Rle_trans. do 2 apply Rplus_le_compat_r. apply Rabs_triang.
    generalize (PP _ _ _ C0 Q0) (PP _ _ _ C1 Q1) (PP _ _ _ C2 Q2) (PP _ _ _ C3 Q3). lra. }
  assert (E5 : h * M4 <= N * 4370).
  { assert (P * (M0 + 3 * (4368 * N + h * M4)) <= P * (13105 * N) + / 2 * M4).
    { replace (/ 2 * M4) with (P * (3 * (h * M4))) by (replace (P * (3 * (h * M4))) with (3 * (P * h) * M4) by ring;
        rewrite HPh; field).
      rewrite <- Rmult_plus_distr_l. apply Rmult_le_compat_l; lra. }
    assert (M4 <= 2 * (P * (13105 * N))) by lra.
    assert (h * M4 <= h * (2 * (P * (13105 * N)))) by (apply Rmult_le_compat_l; lra).
    replace (h * (2 * (P * (13105 * N)))) with (P * h * (26210 * N)) in * by ring. rewrite HPh in *. lra. }
  assert (EN : N = 216 * P ^ 3 * M0) by (unfold N, h; field; lra).
  assert (E8 : (1 + x) ^ 3 <= 48 ^ 3 * exp (x / 16)).
  { assert (H1 : 1 + x / 48 <= exp (x / 48)) by apply exp_ineq1_le.
    replace (exp (x / 16)) with (exp (x / 48) ^ 3).
    2: { simpl. rewrite Rmult_1_r, <- !exp_plus. f_equal. field. }
    rewrite <- Rpow_mult_distr. apply pow_incr. split; lra. }
  assert (Fin : 3 * 4368 * N <= K * exp (x / 8)).
  { rewrite EN. unfold K, P, M0.
    replace (exp (x / 8)) with (exp (x / 16) * exp (x / 16)).
    2: { rewrite <- exp_plus. f_equal. field. }
    rewrite Rpow_mult_distr.
    replace (3 * 4368 * (216 * (c ^ 3 * (1 + x) ^ 3) * (A * exp (/ 16) * exp (x / 16)))) with
      (3 * 4368 * 216 * c ^ 3 * (A * exp (/ 16)) * exp (x / 16) * (1 + x) ^ 3) by ring.
    replace (3 * 4368 * 216 * c ^ 3 * 48 ^ 3 * (A * exp (/ 16)) * (exp (x / 16) * exp (x / 16))) with
      (3 * 4368 * 216 * c ^ 3 * (A * exp (/ 16)) * exp (x / 16) * (48 ^ 3 * exp (x / 16))) by ring.
    apply Rmult_le_compat_l; auto.
    apply Rmult_le_pos; [|apply Rlt_le, exp_pos].
    apply Rmult_le_pos. apply Rmult_le_pos. lra. apply pow_le; lra.
    apply Rmult_le_pos; [auto|apply Rlt_le, exp_pos]. }
  destruct (IQ t ltac:(unfold a; lra)) as (Q1 & Q2 & Q3). clear - Q1 Q2 Q3 E5 Fin HN0.
  refine (conj _ (conj _ _)); eapply Rle_trans; [exact Q1| |exact Q2| |exact Q3| ]; lra. }
refine (conj _ (conj _ (conj _ _))).
- exists A, T1. intros t Ht. destruct (HT t Ht) as (Ht0 & _ & Hw).
  eapply Rle_trans; [exact Hw|]. apply Rmult_le_compat_l; auto. apply exp_le. lra.
- exists K, T1. intros t Ht. apply Main, Ht.
- exists K, T1. intros t Ht. apply Main, Ht.
- exists K, T1. intros t Ht. apply Main, Ht.
Qed.

Let nu := e * beta.
Let mu := 1 - e * (1 - beta).
Let K := 26 * nu ^ 2 + 1.
Let ka := 7 * mu ^ 2 + 4 * K + 1.

Definition cone_time : R := - (11 + 4 * ka) / e.

Lemma small_common4 w0 w1 w2 w3 : small_at_left w0 -> small_at_left w1 -> small_at_left w2 -> small_at_left w3 ->
  exists A T1, 0 < A /\ forall t, t <= T1 -> Rabs (w0 t) <= A * exp (- t / 8) /\ Rabs (w1 t) <= A * exp (- t / 8) /\
    Rabs (w2 t) <= A * exp (- t / 8) /\ Rabs (w3 t) <= A * exp (- t / 8).
Proof.
intros (A0 & T0 & H0) (A1 & T1 & H1) (A2 & T2 & H2) (A3 & T3 & H3).
exists (Rabs A0 + Rabs A1 + Rabs A2 + Rabs A3 + 1), (Rmin (Rmin T0 T1) (Rmin T2 T3)).
generalize (Rabs_pos A0) (Rabs_pos A1) (Rabs_pos A2) (Rabs_pos A3)
  (Rle_abs A0) (Rle_abs A1) (Rle_abs A2) (Rle_abs A3). intros.
split. lra. intros t Ht.
assert (M1 := Rmin_l (Rmin T0 T1) (Rmin T2 T3)). assert (M2 := Rmin_r (Rmin T0 T1) (Rmin T2 T3)).
assert (M3 := Rmin_l T0 T1). assert (M4 := Rmin_r T0 T1). assert (M5 := Rmin_l T2 T3). assert (M6 := Rmin_r T2 T3).
assert (Hx := exp_pos (- t / 8)).
repeat split.
- eapply Rle_trans. apply H0; lra. apply Rmult_le_compat_r; lra.
- eapply Rle_trans. apply H1; lra. apply Rmult_le_compat_r; lra.
- eapply Rle_trans. apply H2; lra. apply Rmult_le_compat_r; lra.
- eapply Rle_trans. apply H3; lra. apply Rmult_le_compat_r; lra.
Qed.

Lemma sq_bound x B : Rabs x <= B -> x ^ 2 <= B ^ 2.
Proof.
intros H. rewrite <- (Rabs_pos_eq (x ^ 2)) by apply pow2_ge_0.
rewrite <- RPow_abs. apply pow_incr; split; auto using Rabs_pos.
Qed.

(** w0 = 0 at one early time, and no exponential growth at t -> -oo: then w0 = 0. Plan: the quadratic form Q of s = w2 +
    w3, u = w1 + w2, w1 and w0 satisfies Q' <= - Q/2 up to t0, so Q e^(t/2) is at least its value at t0, backwards in
    time; but it tends to 0 at t -> -oo by the bounds. So Q(t0) <= 0. With w0(t0) = 0 it is at least a sum of squares:
    all data are 0 at t0, and [T_chain_zero] ends the proof. *)
Lemma cone_zero tm w0 w1 w2 w3 (t0 : R) : T_chain tm w0 w1 w2 w3 -> Rbar_lt t0 tm ->
  small_at_left w0 -> small_at_left w1 -> small_at_left w2 -> small_at_left w3 ->
  t0 <= cone_time -> w0 t0 = 0 -> forall t : R, Rbar_lt t tm -> w0 t = 0.
Proof.
intros HT Htm S0 S1 S2 S3 Ht0 Hz.
destruct HT as (D0 & D1 & D2 & D3).
destruct (small_common4 _ _ _ _ S0 S1 S2 S3) as (A & T1 & HA & HS). clear S0 S1 S2 S3.
set (u := fun t => w1 t + w2 t).
set (s := fun t => w2 t + w3 t).
set (g := fun t => u t - mu * w1 t - nu * w0 t).
assert (Du : forall t : R, Rbar_lt t tm -> is_derive u t (s t)).
{ intros t Htt. apply (is_derive_plus w1 w2); auto. }
assert (Ds : forall t : R, Rbar_lt t tm -> is_derive s t (- s t + e * t * u t + g t)).
{ intros t Htt. replace (- s t + e * t * u t + g t) with
    (w3 t + (e * (- beta * w0 t + (1 - beta + t) * w1 t + t * w2 t) - 2 * w3 t))
    by (unfold g, s, u, mu, nu; ring).
  apply (is_derive_plus w2 w3); auto. }
set (Q := fun t => s t ^ 2 + (- e * t) * u t ^ 2 + u t * s t + ka * w1 t ^ 2 - K * w0 t ^ 2).
set (Q' := fun t => - s t ^ 2 - u t * s t - (- e * t + e) * u t ^ 2 + (2 * s t + u t) * g t
    + 2 * ka * w1 t * u t - 2 * ka * w1 t ^ 2 - 2 * K * w0 t * w1 t).
assert (DQ : forall t : R, Rbar_lt t tm -> is_derive Q t (Q' t)).
{ intros t Htt. unfold Q, Q'. eapply is_derive_val.
  - apply (is_derive_minus (fun t => s t ^ 2 + (- e * t) * u t ^ 2 + u t * s t + ka * w1 t ^ 2) (fun t =>
      K * w0 t ^ 2)).
    apply (is_derive_plus (fun t => s t ^ 2 + (- e * t) * u t ^ 2 + u t * s t) (fun t => ka * w1 t ^ 2)).
    apply (is_derive_plus (fun t => s t ^ 2 + (- e * t) * u t ^ 2) (fun t => u t * s t)).
    apply (is_derive_plus (fun t => s t ^ 2) (fun t => (- e * t) * u t ^ 2)).
    apply is_derive_pow, Ds, Htt.
    apply (is_derive_mult_R (fun t => - e * t) (fun t => u t ^ 2) t (- e)). auto_derive; auto; ring.
    apply is_derive_pow, Du, Htt.
    apply (is_derive_mult_R u s); [apply Du, Htt|apply Ds, Htt].
    apply (is_derive_scal (fun t => w1 t ^ 2)), is_derive_pow, D1, Htt.
    apply (is_derive_scal (fun t => w0 t ^ 2)), is_derive_pow, D0, Htt.
  - unfold minus, plus, opp; simpl. unfold g, u, s. ring. }
assert (Hnu2 := pow2_ge_0 nu). assert (Hmu2 := pow2_ge_0 mu).
assert (HK : 0 < K) by (unfold K; lra).
assert (Hka : 0 < ka) by (unfold ka; lra).
assert (Hct : forall t, t <= t0 -> 11 + 4 * ka <= - e * t).
{ intros t Ht. unfold cone_time in Ht0.
  assert (H : e * t <= e * (- (11 + 4 * ka) / e)) by (apply Rmult_le_compat_l; lra).
  replace (e * (- (11 + 4 * ka) / e)) with (- (11 + 4 * ka)) in H by (field; lra). lra. }
assert (HQ' : forall t, t <= t0 -> Q' t + / 2 * Q t <= 0).
{ intros t Ht. unfold Q, Q', g.
  apply (cone_ineq (s t) (u t) (w1 t) (w0 t) (- e * t) e mu nu K ka); auto.
  - unfold K; lra.
  - unfold ka; lra. }
(* Q(t0) is a sum of squares *)
assert (HP := Hct t0 (Rle_refl _)).
assert (HQ0 : / 2 * s t0 ^ 2 + u t0 ^ 2 + ka * w1 t0 ^ 2 <= Q t0).
{ unfold Q. rewrite Hz.
  assert (0 <= (s t0 + u t0) ^ 2) by apply pow2_ge_0.
  assert (11 * u t0 ^ 2 <= - e * t0 * u t0 ^ 2) by (apply Rmult_le_compat_r; [apply pow2_ge_0|lra]).
  generalize (pow2_ge_0 (u t0)). lra. }
(* backward growth *)
assert (Hgrow : forall t, t <= t0 -> Q t0 * exp (t0 / 2) <= Q t * exp (t / 2)).
{ intros t Ht.
  apply (decr_of_derive (fun t => Q t * exp (t / 2)) (fun t => (Q' t + / 2 * Q t) * exp (t / 2)) t t0 Ht).
  - intros x Hx. evar_last.
    apply (is_derive_mult_R Q (fun t => exp (t / 2)) x (Q' x) (/ 2 * exp (x / 2))). apply DQ.
    apply (Rbar_lt_le x t0); auto; lra.
    auto_derive; auto; unfold Rdiv; ring. ring.
  - intros x Hx. assert (H := HQ' x ltac:(lra)). generalize (exp_pos (x / 2)). intros. nra. }
(* upper bound *)
assert (Hup : forall t, t <= T1 -> t <= t0 -> Q t * exp (t / 2) <= (8 + ka + 4 * e * (- t)) * A ^ 2 * exp (t / 4)).
{ intros t Ht Ht'. destruct (HS t Ht) as (B0 & B1 & B2 & B3).
  set (X := exp (- t / 8)) in *.
  assert (HX : 0 < X) by apply exp_pos.
  assert (EX : X ^ 2 * exp (t / 2) = exp (t / 4)).
  { unfold X. simpl. rewrite Rmult_1_r, <- !exp_plus. f_equal. field. }
  assert (Bu : Rabs (u t) <= 2 * (A * X)).
  { unfold u. eapply Rle_trans. apply Rabs_triang. lra. }
  assert (Bs : Rabs (s t) <= 2 * (A * X)).
  { unfold s. eapply Rle_trans. apply Rabs_triang. lra. }
  apply sq_bound in Bu. apply sq_bound in Bs. apply sq_bound in B1.
  assert (Hp := Hct t Ht').
  assert (HQ : Q t <= (8 + ka + 4 * e * (- t)) * A ^ 2 * X ^ 2).
  { unfold Q.
    assert (0 <= K * w0 t ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
    assert (0 <= (s t - u t) ^ 2) by apply pow2_ge_0.
    assert (- e * t * u t ^ 2 <= - e * t * (2 * (A * X)) ^ 2) by (apply Rmult_le_compat_l; lra).
    assert (ka * w1 t ^ 2 <= ka * (A * X) ^ 2) by (apply Rmult_le_compat_l; lra).
    lra. }
  rewrite <- EX, <- Rmult_assoc. apply Rmult_le_compat_r; auto. apply Rlt_le, exp_pos. }
(* Q t0 <= 0 *)
assert (HQn : Q t0 <= 0).
{ apply Rnot_lt_le. intros Hq.
  set (de := Q t0 * exp (t0 / 2)) in *.
  assert (Hde : 0 < de) by (apply Rmult_lt_0_compat; auto; apply exp_pos).
  set (M := 64 * (8 + ka + 4 * e) * A ^ 2).
  assert (HM : 0 < M).
  { unfold M. apply Rmult_lt_0_compat. lra. apply pow_lt, HA. }
  set (x := Rmax (Rmax 1 (M / de + 1)) (Rmax (- T1) (- t0))).
  assert (X1 : 1 <= x) by (eapply Rle_trans; [apply Rmax_l|]; eapply Rle_trans; [apply Rmax_l|apply Rle_refl]).
  assert (X2 : M / de + 1 <= x) by (eapply Rle_trans; [apply Rmax_r|]; eapply Rle_trans; [apply Rmax_l|apply Rle_refl]).
  assert (X3 : - T1 <= x) by (eapply Rle_trans; [apply Rmax_l|]; eapply Rle_trans; [apply Rmax_r|apply Rle_refl]).
  assert (X4 : - t0 <= x) by (eapply Rle_trans; [apply Rmax_r|]; eapply Rle_trans; [apply Rmax_r|apply Rle_refl]).
  clearbody x.
  assert (H1 := Hgrow (- x) ltac:(lra)).
  assert (H2 := Hup (- x) ltac:(lra) ltac:(lra)).
  rewrite Ropp_involutive in H2.
  assert (Hex : exp (- x / 4) * x ^ 2 <= 64).
  { assert (E8 : 1 + x / 8 <= exp (x / 8)) by apply exp_ineq1_le.
    assert (E4 : exp (x / 4) = exp (x / 8) ^ 2).
    { simpl. rewrite Rmult_1_r, <- exp_plus. f_equal. field. }
    assert (x ^ 2 / 64 <= exp (x / 4)).
    { rewrite E4. replace (x ^ 2 / 64) with ((x / 8) ^ 2) by field. apply pow_incr; lra. }
    assert (E0 : exp (- x / 4) * exp (x / 4) = 1).
    { rewrite <- exp_plus. replace (- x / 4 + x / 4) with 0 by field. apply exp_0. }
    assert (Hxp := exp_pos (- x / 4)).
    assert (exp (- x / 4) * (x ^ 2 / 64) <= exp (- x / 4) * exp (x / 4)) by (apply Rmult_le_compat_l; lra).
    lra. }
  assert (Hc : (8 + ka + 4 * e * x) * A ^ 2 * exp (- x / 4) * x <= M).
  { unfold M. replace (64 * (8 + ka + 4 * e) * A ^ 2) with ((8 + ka + 4 * e) * A ^ 2 * 64) by ring.
    apply Rle_trans with ((8 + ka + 4 * e) * A ^ 2 * (exp (- x / 4) * x ^ 2)).
    - replace ((8 + ka + 4 * e * x) * A ^ 2 * exp (- x / 4) * x) with
        ((8 + ka + 4 * e * x) * (A ^ 2 * exp (- x / 4) * x)) by ring.
      replace ((8 + ka + 4 * e) * A ^ 2 * (exp (- x / 4) * x ^ 2)) with
        ((8 + ka + 4 * e) * x * (A ^ 2 * exp (- x / 4) * x)) by ring.
      apply Rmult_le_compat_r.
      + apply Rmult_le_pos; [|lra]. apply Rmult_le_pos. apply pow2_ge_0. apply Rlt_le, exp_pos.
      + assert (8 + ka <= (8 + ka) * x) by nra. lra.
    - apply Rmult_le_compat_l; auto. apply Rmult_le_pos. lra. apply pow2_ge_0. }
  assert (H3 : de * x <= M).
  { eapply Rle_trans; [|exact Hc]. apply Rmult_le_compat_r; lra. }
  assert (H4 : M + de <= de * x).
  { replace (M + de) with (de * (M / de + 1)) by (field; lra). apply Rmult_le_compat_l; lra. }
  lra. }
(* so all data vanish at t0 *)
assert (N1 := pow2_ge_0 (s t0)). assert (N2 := pow2_ge_0 (u t0)). assert (N3 := pow2_ge_0 (w1 t0)).
assert (N4 : 0 <= ka * w1 t0 ^ 2) by (apply Rmult_le_pos; lra).
assert (sq0 : forall x, x ^ 2 = 0 -> x = 0).
{ intros x Hx. destruct (Req_dec x 0) as [|Hn]; auto. exfalso. exact (pow_nonzero _ 2 Hn Hx). }
assert (Z1 : w1 t0 = 0).
{ apply sq0. apply Rmult_eq_reg_l with ka; lra. }
assert (Zu : u t0 = 0) by (apply sq0; lra).
assert (Zs : s t0 = 0) by (apply sq0; lra).
unfold u in Zu. unfold s in Zs.
apply (T_chain_zero tm w0 w1 w2 w3 t0); auto; try lra.
exact (conj D0 (conj D1 (conj D2 D3))).
Qed.

End Uniq.
