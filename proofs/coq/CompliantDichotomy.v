(** * The compliant model: a dichotomy at +oo

    In w, d = w', u = d + d', s = u' the equation of the deviation is s' = - s + (1 + eT) u - mu d - nu w. The form Q =
    2 s u - d^2/g - w^2 has Q' >= 2 g Q + m N for large T, N = w^2 + d^2 + u^2 + s^2, for any rate g > 0. So where Q > 0
    it stays > 0, and u keeps its sign; and a motion with Q <= 0 for ever has N <= A e^(4 g T), because N e^(-4 g T) - c
    Q e^(-2 g T) decreases. Given a motion F with Q > 0 and u > 0, each motion x has a number K such that x - K F has Q
    <= 0 for ever: the supremum of the c for which x - c F comes into {Q > 0, u > 0}. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus.
Open Scope R_scope.

Section Dichotomy.
Variables (e mu nu g : R).
Hypothesis He : 0 < e.
Hypothesis Hg : 0 < g.

Definition motion_from (T : R) (w d u s : R -> R) : Prop := forall t, T <= t ->
  is_derive w t (d t) /\ is_derive d t (u t - d t) /\ is_derive u t (s t) /\
  is_derive s t (- s t + (1 + e * t) * u t - mu * d t - nu * w t).

Definition form (w d u s : R) : R := 2 * s * u - d ^ 2 / g - w ^ 2.

Definition size (w d u s : R) : R := w ^ 2 + d ^ 2 + u ^ 2 + s ^ 2.

(** From this time on the form grows. *)
Definition late (t : R) : Prop := 0 <= t /\ (1 + 2 * g) ^ 2 + (mu + / g) ^ 2 + 2 * nu ^ 2 / g <= 1 + 2 * (e * t).

Definition least : R := Rmin 1 (g / 2).

Lemma least_pos : 0 < least.
Proof. apply Rmin_pos; lra. Qed.

Lemma form_rate (w d u s t : R) : late t ->
  2 * g * form w d u s + least * size w d u s <=
  2 * s ^ 2 + 2 * u * (- s + (1 + e * t) * u - mu * d - nu * w) - 2 / g * d * (u - d) - 2 * w * d.
Proof.
intros (_ & Hq). unfold form, size.
assert (L1 : least <= 1) by apply Rmin_l. assert (L2 : least <= g / 2) by apply Rmin_r. assert (L0 := least_pos).
set (i := / g) in *. assert (Hi : 0 < i) by (apply Rinv_0_lt_compat, Hg).
assert (Egi : g * i = 1) by (unfold i; field; lra).
unfold Rdiv in *. fold i in Hq |- *.
assert (C1 : 0 <= (s - (1 + 2 * g) * u) ^ 2) by apply pow2_ge_0.
assert (C2 : 0 <= (d - (mu + i) * u) ^ 2) by apply pow2_ge_0.
assert (C3 : 2 * (nu * u * w) <= g / 2 * w ^ 2 + 2 * i * (nu * u) ^ 2).
{ assert (A : 0 <= g / 2 * (w - 2 * i * (nu * u)) ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
  replace (g / 2 * (w - 2 * i * (nu * u)) ^ 2) with (g / 2 * w ^ 2 - 2 * (g * i) * (nu * u * w)
    + 2 * (g * i) * i * (nu * u) ^ 2) in A by field.
  rewrite Egi in A. lra. }
assert (C4 : 2 * (w * d) <= g * w ^ 2 + i * d ^ 2).
{ assert (A : 0 <= g * (w - i * d) ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
  replace (g * (w - i * d) ^ 2) with (g * w ^ 2 - 2 * (g * i) * (w * d) + (g * i) * i * d ^ 2) in A by ring.
  rewrite Egi in A. lra. }
assert (C5 : ((1 + 2 * g) ^ 2 + (mu + i) ^ 2 + 2 * nu ^ 2 * i) * u ^ 2 <= (1 + 2 * (e * t)) * u ^ 2).
{ apply Rmult_le_compat_r; [apply pow2_ge_0|exact Hq]. }
assert (P1 := pow2_ge_0 s). assert (P2 := pow2_ge_0 u). assert (P3 := pow2_ge_0 d). assert (P4 := pow2_ge_0 w).
assert (D1 : least * s ^ 2 <= 1 * s ^ 2) by (apply Rmult_le_compat_r; lra).
assert (D2 : least * u ^ 2 <= 1 * u ^ 2) by (apply Rmult_le_compat_r; lra).
assert (D3 : least * d ^ 2 <= 1 * d ^ 2) by (apply Rmult_le_compat_r; lra).
assert (D4 : least * w ^ 2 <= g * / 2 * w ^ 2) by (apply Rmult_le_compat_r; lra).
assert (D5 : 0 <= i * d ^ 2) by (apply Rmult_le_pos; lra).
replace (2 * g * (2 * s * u - d ^ 2 * i - w ^ 2)) with (4 * g * (s * u) - 2 * (g * i) * d ^ 2 - 2 * g * w ^ 2) by ring.
rewrite Egi.
assert (C3' : 2 * (nu * u * w) <= g * / 2 * w ^ 2 + 2 * i * (nu * u) ^ 2) by (unfold Rdiv in C3; exact C3).
lra.
Qed.

Section Motion.
Variables (T : R) (w d u s : R -> R).
Hypothesis HT : late T.
Hypothesis HM : motion_from T w d u s.
Let Q (t : R) : R := form (w t) (d t) (u t) (s t).
Let N (t : R) : R := size (w t) (d t) (u t) (s t).
Let Q' (t : R) : R := 2 * s t ^ 2 + 2 * u t * (- s t + (1 + e * t) * u t - mu * d t - nu * w t)
  - 2 / g * d t * (u t - d t) - 2 * w t * d t.

Lemma late_after t : T <= t -> late t.
Proof. intros Ht. destruct HT as (A & B). split; [lra|]. assert (e * T <= e * t) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma form_derive t : T <= t -> is_derive Q t (Q' t).
Proof.
intros Ht. destruct (HM t Ht) as (Dw & Dd & Du & Ds). unfold Q, Q', form. eapply is_derive_val.
- apply (is_derive_minus (fun t => 2 * s t * u t - d t ^ 2 / g) (fun t => w t ^ 2)).
  apply (is_derive_minus (fun t => 2 * s t * u t) (fun t => d t ^ 2 / g)).
  apply (is_derive_mult_R (fun t => 2 * s t) u). apply (is_derive_scal s), Ds. apply Du.
  apply (is_derive_ext (fun t => / g * d t ^ 2)).
  { intros x. match goal with |- ?a = ?b => change (@eq R a b) end. unfold Rdiv; ring. }
  apply (is_derive_scal (fun t => d t ^ 2)), is_derive_pow, Dd.
  apply is_derive_pow, Dw.
- unfold minus, plus, opp; simpl. field. lra.
Qed.

Lemma weighted_derive k (f f' : R -> R) t : is_derive f t (f' t) ->
  is_derive (fun t => f t * exp (- k * t)) t ((f' t - k * f t) * exp (- k * t)).
Proof.
intros D. eapply is_derive_val.
- apply (is_derive_mult_R f (fun t => exp (- k * t)) t _ (- k * exp (- k * t)) D). auto_derive; auto. ring.
- ring.
Qed.

Lemma size_pos t : 0 <= N t.
Proof. unfold N, size. generalize (pow2_ge_0 (w t)) (pow2_ge_0 (d t)) (pow2_ge_0 (u t)) (pow2_ge_0 (s t)). lra. Qed.

Lemma form_grows t1 t2 : T <= t1 -> t1 <= t2 -> Q t1 * exp (- (2 * g) * t1) <= Q t2 * exp (- (2 * g) * t2).
Proof.
intros H1 H2. apply Ropp_le_cancel.
apply (decr_of_derive (fun t => - (Q t * exp (- (2 * g) * t))) (fun t => - ((Q' t - 2 * g * Q t) * exp (- (2 * g) * t)))
  t1 t2 H2).
- intros x Hx. apply (is_derive_opp (fun t => Q t * exp (- (2 * g) * t))), weighted_derive, form_derive. lra.
- intros x Hx. assert (A := form_rate (w x) (d x) (u x) (s x) x (late_after x ltac:(lra))). fold (Q x) (N x) in A.
  assert (B : 0 <= least * N x) by (apply Rmult_le_pos; [apply Rlt_le, least_pos|apply size_pos]).
  assert (C : 0 <= (Q' x - 2 * g * Q x) * exp (- (2 * g) * x))
    by (apply Rmult_le_pos; [unfold Q'; lra|apply Rlt_le, exp_pos]). lra.
Qed.

Lemma form_stays t1 t2 : T <= t1 -> t1 <= t2 -> 0 < Q t1 -> 0 < Q t2.
Proof.
intros H1 H2 H3. assert (A := form_grows t1 t2 H1 H2).
assert (0 < Q t1 * exp (- (2 * g) * t1)) by (apply Rmult_lt_0_compat; [auto|apply exp_pos]).
apply Rmult_lt_reg_r with (exp (- (2 * g) * t2)). apply exp_pos. lra.
Qed.

Lemma form_product x1 x2 x3 x4 : 0 < form x1 x2 x3 x4 -> 0 < x4 * x3.
Proof.
unfold form. intros H. assert (A := pow2_ge_0 x1).
assert (B : 0 <= x2 ^ 2 / g) by (apply Rmult_le_pos; [apply pow2_ge_0|apply Rlt_le, Rinv_0_lt_compat, Hg]). lra.
Qed.

Lemma sign_stays t1 t2 : T <= t1 -> t1 <= t2 -> 0 < Q t1 -> 0 < u t1 -> 0 < u t2.
Proof.
intros H1 H2 H3 H4. revert t2 H2. apply real_induction; auto.
- intros t Ht HP. assert (HPt := HP t ltac:(lra)). destruct (HM t ltac:(lra)) as (_ & _ & Du & _).
  destruct (continuous_pos u t (ex_intro _ _ Du) HPt) as [r Hr]. exists r. split. apply cond_pos.
  intros x Hx. apply Hr. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl.
  rewrite Rabs_pos_eq; lra.
- intros t Ht HP. destruct (HM t ltac:(lra)) as (_ & _ & Du & _).
  apply Rlt_le_trans with (u t1); auto. apply (closed_ge u t1 t (u t1) Ht (ex_intro _ _ Du)).
  intros x Hx. apply Ropp_le_cancel.
  apply (decr_of_derive (fun t => - u t) (fun t => - s t) t1 x (proj1 Hx)).
  + intros c Hc. apply (is_derive_opp u), HM. lra.
  + intros c Hc. assert (A := form_product _ _ _ _ (form_stays t1 c H1 (proj1 Hc) H3)).
    assert (B := HP c ltac:(lra)). apply Rlt_le, Ropp_lt_gt_0_contravar, Rlt_gt. nra.
Qed.

Lemma form_le_size t : - Q t <= (1 + / g) * N t /\ Q t <= N t.
Proof.
unfold Q, N, form, size. assert (Hi : 0 < / g) by (apply Rinv_0_lt_compat, Hg).
assert (P1 := pow2_ge_0 (s t)). assert (P2 := pow2_ge_0 (u t)). assert (P3 := pow2_ge_0 (d t)).
assert (P4 := pow2_ge_0 (w t)).
assert (P5 := pow2_ge_0 (s t + u t)). assert (P6 := pow2_ge_0 (s t - u t)).
assert (D1 : 0 <= / g * s t ^ 2) by (apply Rmult_le_pos; lra).
assert (D2 : 0 <= / g * u t ^ 2) by (apply Rmult_le_pos; lra).
assert (D3 : 0 <= / g * d t ^ 2) by (apply Rmult_le_pos; lra).
assert (D4 : 0 <= / g * w t ^ 2) by (apply Rmult_le_pos; lra).
unfold Rdiv. split; lra.
Qed.

(** a motion that never comes into {Q > 0} *)
Lemma slow_if_never : (forall t, T <= t -> Q t <= 0) -> exists A, 0 < A /\ forall t, T <= t ->
  N t <= A * exp (4 * g * t).
Proof.
intros Hn. destruct HT as (HT0 & _).
set (c := 5 + Rabs mu + Rabs nu). assert (Hc : 0 < c) by (unfold c; generalize (Rabs_pos mu) (Rabs_pos nu); lra).
set (N' := fun t => 2 * w t * d t + 2 * d t * (u t - d t) + 2 * u t * s t + 2 * s t * (- s t + (1 + e * t) * u t
  - mu * d t - nu * w t)).
assert (DN : forall t, T <= t -> is_derive N t (N' t)).
{ intros t Ht. destruct (HM t Ht) as (Dw & Dd & Du & Ds). unfold N, N', size. eapply is_derive_val.
  - apply (is_derive_plus (fun t => w t ^ 2 + d t ^ 2 + u t ^ 2) (fun t => s t ^ 2)).
    apply (is_derive_plus (fun t => w t ^ 2 + d t ^ 2) (fun t => u t ^ 2)).
    apply (is_derive_plus (fun t => w t ^ 2) (fun t => d t ^ 2)).
    apply is_derive_pow, Dw. apply is_derive_pow, Dd. apply is_derive_pow, Du. apply is_derive_pow, Ds.
  - unfold plus; simpl. ring. }
assert (BN : forall t, T <= t -> N' t <= (c + e * t) * N t).
{ intros t Ht. unfold N', N, size, c.
  set (a1 := w t). set (a2 := d t). set (a3 := u t). set (a4 := s t).
  assert (two : forall k x y, k * (2 * x * y) <= Rabs k * (x ^ 2 + y ^ 2)).
  { intros k x y. eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|].
    apply Rabs_le. generalize (pow2_ge_0 (x + y)) (pow2_ge_0 (x - y)). lra. }
  assert (U1 := two 1 a1 a2). assert (U2 := two 1 a2 a3). assert (U3 := two 1 a3 a4).
  assert (U4 := two (1 + e * t) a4 a3).
  assert (U5 := two (- mu) a4 a2). assert (U6 := two (- nu) a4 a1). rewrite Rabs_Ropp in U5, U6.
  rewrite Rabs_R1 in U1, U2, U3.
  assert (Het : 0 <= e * t) by (apply Rmult_le_pos; lra). rewrite (Rabs_pos_eq (1 + e * t)) in U4 by lra.
  assert (P1 := pow2_ge_0 a1). assert (P2 := pow2_ge_0 a2). assert (P3 := pow2_ge_0 a3). assert (P4 := pow2_ge_0 a4).
  assert (V1 : 0 <= Rabs mu * (a1 ^ 2 + a3 ^ 2)) by (apply Rmult_le_pos; [apply Rabs_pos|lra]).
  assert (V2 : 0 <= Rabs nu * (a2 ^ 2 + a3 ^ 2)) by (apply Rmult_le_pos; [apply Rabs_pos|lra]).
  assert (V3 : 0 <= e * t * (a1 ^ 2 + a2 ^ 2)) by (apply Rmult_le_pos; lra). lra. }
set (k := (c + e / (2 * g)) / least). assert (HL := least_pos).
assert (Hk : 0 < k).
{ apply Rdiv_lt_0_compat; auto. assert (0 < e / (2 * g)) by (apply Rdiv_lt_0_compat; lra). lra. }
set (E := fun t => N t * exp (- (4 * g) * t) + k * (- (Q t * exp (- (2 * g) * t)))).
assert (HE : forall t, T <= t -> E t <= E T).
{ intros t Ht.
  apply (decr_of_derive E (fun t => (N' t - 4 * g * N t) * exp (- (4 * g) * t)
    + k * (- ((Q' t - 2 * g * Q t) * exp (- (2 * g) * t)))) T t Ht).
  - intros x Hx. apply (is_derive_plus (fun t => N t * exp (- (4 * g) * t)) (fun t =>
      k * (- (Q t * exp (- (2 * g) * t))))).
    + apply weighted_derive, DN. lra.
    + apply (is_derive_scal (fun t => - (Q t * exp (- (2 * g) * t)))),
        (is_derive_opp (fun t => Q t * exp (- (2 * g) * t))), weighted_derive, form_derive. lra.
  - intros x Hx. assert (A := form_rate (w x) (d x) (u x) (s x) x (late_after x ltac:(lra))). fold (Q x) (N x) in A.
    assert (A' : least * N x <= Q' x - 2 * g * Q x) by (unfold Q'; lra).
    assert (B := BN x ltac:(lra)). assert (N0 := size_pos x).
    set (X := exp (- (2 * g) * x)). assert (HX : 0 < X) by apply exp_pos.
    assert (EX : exp (- (4 * g) * x) = X * X) by (unfold X; rewrite <- exp_plus; f_equal; ring). rewrite EX.
    assert (HX1 : (1 + 2 * g * x) * X <= 1).
    { assert (A1 := exp_ineq1_le (2 * g * x)).
      assert (A2 : X * exp (2 * g * x) = 1) by (unfold X; rewrite <- exp_plus; replace (- (2 * g) * x + 2 * g * x)
        with 0 by ring; apply exp_0).
      rewrite <- A2, (Rmult_comm X). apply Rmult_le_compat_r; lra. }
    assert (Hgx : 0 <= g * x) by (apply Rmult_le_pos; lra).
    assert (HX2 : (c + e * x) * X <= c + e / (2 * g)).
    { assert (B1 : X <= 1) by nra. assert (B2 : x * X <= / (2 * g)).
      { apply Rmult_le_reg_l with (2 * g). lra. rewrite Rinv_r by lra. nra. }
      assert (c * X <= c * 1) by (apply Rmult_le_compat_l; lra).
      assert (e * (x * X) <= e * / (2 * g)) by (apply Rmult_le_compat_l; lra).
      unfold Rdiv. lra. }
    assert (F1 : (N' x - 4 * g * N x) * (X * X) <= ((c + e / (2 * g)) * N x) * X).
    { assert (G1 : (N' x - 4 * g * N x) * X <= (c + e / (2 * g)) * N x).
      { apply Rle_trans with ((c + e * x) * N x * X).
        - apply Rmult_le_compat_r; [lra|]. assert (0 <= 4 * g * N x) by (apply Rmult_le_pos; lra). lra.
        - replace ((c + e * x) * N x * X) with ((c + e * x) * X * N x) by ring. apply Rmult_le_compat_r; auto. }
      replace ((N' x - 4 * g * N x) * (X * X)) with ((N' x - 4 * g * N x) * X * X) by ring.
      apply Rmult_le_compat_r; lra. }
    assert (F2 : (c + e / (2 * g)) * N x * X <= k * ((Q' x - 2 * g * Q x) * X)).
    { replace ((c + e / (2 * g)) * N x * X) with (k * (least * N x * X)) by (unfold k; field; lra).
      apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; lra. }
    lra. }
exists (Rabs (E T) + 1). split; [generalize (Rabs_pos (E T)); lra|].
intros t Ht. assert (A := HE t Ht). assert (B := Rle_abs (E T)).
set (X := exp (4 * g * t)). assert (HX : 0 < X) by apply exp_pos.
assert (EX : exp (- (4 * g) * t) * X = 1) by (unfold X; rewrite <- exp_plus; replace (- (4 * g) * t + 4 * g * t) with 0
  by ring; apply exp_0).
assert (C : N t * exp (- (4 * g) * t) <= Rabs (E T) + 1).
{ assert (0 <= k * - (Q t * exp (- (2 * g) * t))).
  { apply Rmult_le_pos; [lra|]. assert (D := Hn t Ht). assert (D' := exp_pos (- (2 * g) * t)). nra. }
  unfold E in A at 1. lra. }
apply (Rmult_le_compat_r X) in C; [|lra]. rewrite Rmult_assoc, EX, Rmult_1_r in C. exact C.
Qed.

End Motion.

Section Split.
Variables (T : R) (F0 F1 F2 F3 x0 x1 x2 x3 : R -> R).
Hypothesis HT : late T.
Hypothesis HF : motion_from T F0 F1 F2 F3.
Hypothesis Hx : motion_from T x0 x1 x2 x3.
Hypothesis FQ : forall t, T <= t -> 0 < form (F0 t) (F1 t) (F2 t) (F3 t).
Hypothesis Fu : forall t, T <= t -> 0 < F2 t.

Let X0 (c t : R) : R := x0 t - c * F0 t.
Let X1 (c t : R) : R := x1 t - c * F1 t.
Let X2 (c t : R) : R := x2 t - c * F2 t.
Let X3 (c t : R) : R := x3 t - c * F3 t.
Let Q (c t : R) : R := form (X0 c t) (X1 c t) (X2 c t) (X3 c t).

Lemma combination c : motion_from T (X0 c) (X1 c) (X2 c) (X3 c).
Proof.
intros t Ht. destruct (HF t Ht) as (A0 & A1 & A2 & A3). destruct (Hx t Ht) as (B0 & B1 & B2 & B3).
assert (L : forall (f h : R -> R) lf lh, is_derive f t lf -> is_derive h t lh -> is_derive (fun t => f t - c * h t) t
  (lf - c * lh)).
{ intros f h lf lh Df Dh. apply (is_derive_minus f (fun t => c * h t)); auto. apply (is_derive_scal h), Dh. }
refine (conj (L _ _ _ _ B0 A0) (conj _ (conj (L _ _ _ _ B2 A2) _))).
- apply (is_derive_val _ _ _ _ (L _ _ _ _ B1 A1)). unfold X1, X2. ring.
- apply (is_derive_val _ _ _ _ (L _ _ _ _ B3 A3)). unfold X0, X1, X2, X3. ring.
Qed.

Lemma opposite c : motion_from T (fun t => - X0 c t) (fun t => - X1 c t) (fun t => - X2 c t) (fun t => - X3 c t).
Proof.
intros t Ht. destruct (combination c t Ht) as (A0 & A1 & A2 & A3).
refine (conj (is_derive_opp _ _ _ A0) (conj _ (conj (is_derive_opp _ _ _ A2) _))).
- apply (is_derive_val _ _ _ _ (is_derive_opp _ _ _ A1)). unfold opp; simpl. ring.
- apply (is_derive_val _ _ _ _ (is_derive_opp _ _ _ A3)). unfold opp; simpl. ring.
Qed.

Lemma form_opp a b c d : form (- a) (- b) (- c) (- d) = form a b c d.
Proof. unfold form, Rdiv. ring. Qed.

(** above and below *)
Let Up (c : R) : Prop := exists t, T <= t /\ 0 < Q c t /\ 0 < X2 c t.
Let Down (c : R) : Prop := exists t, T <= t /\ 0 < Q c t /\ X2 c t < 0.

Lemma up_stays c t1 t2 : T <= t1 -> t1 <= t2 -> 0 < Q c t1 -> 0 < X2 c t1 -> 0 < X2 c t2.
Proof. intros A B. exact (sign_stays T _ _ _ _ HT (combination c) t1 t2 A B). Qed.

Lemma down_stays c t1 t2 : T <= t1 -> t1 <= t2 -> 0 < Q c t1 -> X2 c t1 < 0 -> X2 c t2 < 0.
Proof.
intros A B C D.
assert (E := sign_stays T _ _ _ _ HT (opposite c) t1 t2 A B). cbv beta in E. rewrite form_opp in E.
assert (0 < - X2 c t2) by (apply E; [exact C|lra]). lra.
Qed.

Lemma up_below_down c c' : Up c -> Down c' -> c < c'.
Proof.
intros (t1 & A1 & A2 & A3) (t2 & B1 & B2 & B3). set (t := Rmax t1 t2).
assert (M1 := Rmax_l t1 t2). assert (M2 := Rmax_r t1 t2). fold t in M1, M2.
assert (U := up_stays c t1 t A1 M1 A2 A3). assert (D := down_stays c' t2 t B1 M2 B2 B3).
assert (F := Fu t ltac:(lra)). unfold X2 in U, D. nra.
Qed.

(** the form along the line x - c F: a parabola *)
Lemma form_shift c h t : Q (c - h) t = Q c t + h * (2 * (X3 c t * F2 t + F3 t * X2 c t) - 2 * X1 c t * F1 t / g
  - 2 * X0 c t * F0 t)
  + h ^ 2 * form (F0 t) (F1 t) (F2 t) (F3 t).
Proof. unfold Q, X0, X1, X2, X3, form. field. lra. Qed.

Lemma small_change a p r : 0 < a -> exists h, 0 < h /\ Rabs (h * p) < a /\ Rabs (h * r) < a.
Proof.
intros Ha. set (m := Rabs p + Rabs r + 1). assert (Hp := Rabs_pos p). assert (Hr := Rabs_pos r).
assert (Hm : 0 < m) by (unfold m; lra).
exists (a / m). assert (Hh : 0 < a / m) by (apply Rdiv_lt_0_compat; auto).
assert (E : a / m * m = a) by (field; lra). split; auto.
assert (P1 : 0 <= a / m * Rabs p) by (apply Rmult_le_pos; lra).
assert (P2 : 0 <= a / m * Rabs r) by (apply Rmult_le_pos; lra).
unfold m at 2 in E. rewrite !Rabs_mult, (Rabs_pos_eq (a / m)) by lra. split; lra.
Qed.

Lemma far_change a p r q : 0 < a -> 0 < r -> exists h, 0 < h /\ 0 < q + h * r /\ 0 < p + h * a.
Proof.
intros Ha Hr. assert (P := Rle_abs (- p)). assert (Q0 := Rle_abs (- q)). rewrite Rabs_Ropp in P, Q0.
assert (Hp := Rabs_pos p). assert (Hq := Rabs_pos q).
assert (Pa : 0 < / a) by (apply Rinv_0_lt_compat, Ha). assert (Pr : 0 < / r) by (apply Rinv_0_lt_compat, Hr).
exists (Rabs p * / a + Rabs q * / r + 1).
assert (N1 : 0 <= Rabs p * / a) by (apply Rmult_le_pos; lra).
assert (N2 : 0 <= Rabs q * / r) by (apply Rmult_le_pos; lra).
assert (E1 : Rabs p * / a * a = Rabs p) by (field; lra). assert (E2 : Rabs q * / r * r = Rabs q) by (field; lra).
assert (N3 : 0 <= Rabs q * / r * a) by (apply Rmult_le_pos; lra).
assert (N4 : 0 <= Rabs p * / a * r) by (apply Rmult_le_pos; lra).
repeat split; lra.
Qed.

Theorem split_off : exists K, forall t, T <= t -> form (X0 K t) (X1 K t) (X2 K t) (X3 K t) <= 0.
Proof.
assert (HFT := FQ T (Rle_refl _)). assert (HuT := Fu T (Rle_refl _)).
assert (Near : forall c t, T <= t -> 0 < Q c t -> 0 < X2 c t -> Up c) by (intros c t A B C; exists t; auto).
(* Up is not empty *)
destruct (completeness Up) as [K [Hub Hlub]].
- (* bounded above *)
  destruct (far_change (form (F0 T) (F1 T) (F2 T) (F3 T))
    (- (2 * (X3 0 T * F2 T + F3 T * X2 0 T) - 2 * X1 0 T * F1 T / g - 2 * X0 0 T * F0 T) - Rabs (Q 0 T)) 
    (F2 T) (- X2 0 T) HFT HuT) as (h0 & H0 & H1 & H2).
  set (h := Rmax h0 1). assert (M1 := Rmax_l h0 1). assert (M2 := Rmax_r h0 1). fold h in M1, M2.
  assert (D : Down h).
  { exists T. split; [lra|]. split.
    - replace h with (0 - (- h)) by ring. rewrite form_shift.
      set (B := 2 * (X3 0 T * F2 T + F3 T * X2 0 T) - 2 * X1 0 T * F1 T / g - 2 * X0 0 T * F0 T) in *.
      set (f := form (F0 T) (F1 T) (F2 T) (F3 T)) in *. assert (A := Rle_abs (- Q 0 T)). rewrite Rabs_Ropp in A.
      assert (A' := Rabs_pos (Q 0 T)).
      assert (G : 0 < h * (- B - Rabs (Q 0 T) + h * f)).
      { apply Rmult_lt_0_compat; [lra|]. assert (h0 * f <= h * f) by (apply Rmult_le_compat_r; lra). lra. }
      assert (G' : 1 * Rabs (Q 0 T) <= h * Rabs (Q 0 T)) by (apply Rmult_le_compat_r; lra). lra.
    - assert (h0 * F2 T <= h * F2 T) by (apply Rmult_le_compat_r; lra). unfold X2 in H1 |- *. lra. }
  exists h. intros c Hc. apply Rlt_le, up_below_down; auto.
- destruct (far_change (form (F0 T) (F1 T) (F2 T) (F3 T)) (2 * (X3 0 T * F2 T + F3 T * X2 0 T) - 2 * X1 0 T * F1 T / g
    - 2 * X0 0 T * F0 T - Rabs (Q 0 T)) 
    (F2 T) (X2 0 T) HFT HuT) as (h0 & H0 & H1 & H2).
  set (h := Rmax h0 1). assert (M1 := Rmax_l h0 1). assert (M2 := Rmax_r h0 1). fold h in M1, M2.
  exists (0 - h). apply (Near _ T); [lra| |].
  + rewrite form_shift.
    set (B := 2 * (X3 0 T * F2 T + F3 T * X2 0 T) - 2 * X1 0 T * F1 T / g - 2 * X0 0 T * F0 T) in *.
    set (f := form (F0 T) (F1 T) (F2 T) (F3 T)) in *. assert (A := Rle_abs (- Q 0 T)). rewrite Rabs_Ropp in A.
    assert (A' := Rabs_pos (Q 0 T)).
    assert (G : 0 < h * (B - Rabs (Q 0 T) + h * f)).
    { apply Rmult_lt_0_compat; [lra|]. assert (h0 * f <= h * f) by (apply Rmult_le_compat_r; lra). lra. }
    assert (G' : 1 * Rabs (Q 0 T) <= h * Rabs (Q 0 T)) by (apply Rmult_le_compat_r; lra). lra.
  + assert (h0 * F2 T <= h * F2 T) by (apply Rmult_le_compat_r; lra). unfold X2 in H1 |- *. lra.
- exists K. intros t Ht. apply Rnot_lt_le. intros HQ. change (0 < Q K t) in HQ.
  set (B := 2 * (X3 K t * F2 t + F3 t * X2 K t) - 2 * X1 K t * F1 t / g - 2 * X0 K t * F0 t).
  assert (HP := form_product _ _ _ _ HQ). assert (Hf := FQ t Ht).
  assert (HX : X2 K t <> 0) by (intros E; rewrite E in HP; lra).
  destruct (Rdichotomy _ _ HX) as [Hn|Hp].
  + destruct (small_change (Rmin (Q K t) (- X2 K t)) B (F2 t)) as (h & H0 & H1 & H2). { apply Rmin_pos; lra. }
    assert (M1 := Rmin_l (Q K t) (- X2 K t)). assert (M2 := Rmin_r (Q K t) (- X2 K t)).
    apply Rabs_def2 in H1, H2.
    assert (D : Down (K - h)).
    { exists t. split; auto. split.
      - rewrite form_shift. fold B.
        assert (0 <= h ^ 2 * form (F0 t) (F1 t) (F2 t) (F3 t)) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]). lra.
      - unfold X2 in *. lra. }
    assert (K <= K - h) by (apply Hlub; intros c Hc; apply Rlt_le, up_below_down; auto). lra.
  + destruct (small_change (Rmin (Q K t) (X2 K t)) B (F2 t)) as (h & H0 & H1 & H2). { apply Rmin_pos; lra. }
    assert (M1 := Rmin_l (Q K t) (X2 K t)). assert (M2 := Rmin_r (Q K t) (X2 K t)).
    apply Rabs_def2 in H1, H2.
    assert (U : Up (K - (- h))).
    { apply (Near _ t); auto.
      - rewrite form_shift. fold B.
        assert (0 <= (- h) ^ 2 * form (F0 t) (F1 t) (F2 t) (F3 t)) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]). lra.
      - unfold X2 in *. lra. }
    assert (K - (- h) <= K) by (apply Hub, U). lra.
Qed.

End Split.
End Dichotomy.
