(** * The compliant model: a touch-down that is late enough is the last event

    The state at the end of a flight of the length u (in the time t/eps), with d = A u - 3 b, n = y (1 - e^(-u))/u, y =
    - z/eps^2 at lift-off: lambda = 0, G = (2 A u + d)/3, W = (A u^2 + d u)/6 - n, and V = d u/6 + n > y at lift-off; so
    d > 0, y < d u/3, n < d/3 for u >= 2. With a = 2/(u + 2), c = 1/4 it lies in the set of [entrance] (Theorem F5 of
    flight.md), for beta <= 1 in that of [below_one]. *)

From Coq Require Import Reals Psatz Lra Lia.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCompliant StatementFlight Calculus CompliantMotion CompliantFlight CompliantGrowth
  CompliantGrowthSet.
Open Scope R_scope.

(** The numbers at touch-down. *)
Section Numbers.
Variables A b V y u X : R.
Hypothesis HA : 0 < A.
Hypothesis Hu : 2 <= u.
Hypothesis Hy : 0 <= y < V.
Hypothesis HX : 0 < X /\ X * (1 + u) <= 1.
Hypothesis Hend : V * u + b * u ^ 2 / 2 - A * u ^ 3 / 6 - y * (1 - X) = 0.

Let d : R := A * u - 3 * b.
Let n : R := y * (1 - X) / u.
Let G : R := A * u - b.
Let W : R := - V - b * u + A * u ^ 2 / 2.

Lemma number_V : V = d * u / 6 + n.
Proof.
apply Rmult_eq_reg_r with u; [|lra]. unfold d, n.
replace (((A * u - 3 * b) * u / 6 + y * (1 - X) / u) * u) with (A * u ^ 3 / 6 - b * u ^ 2 / 2 + y * (1 - X))
  by (field; lra). lra.
Qed.

Lemma number_n : 0 <= n /\ n * 2 <= y /\ n * u <= y.
Proof.
assert (X0 : 0 < 1 - X).
{ assert (0 < X * u) by (apply Rmult_lt_0_compat; lra). lra. }
assert (E : n * u = y * (1 - X)) by (unfold n; field; lra).
assert (n0 : 0 <= n).
{ apply Rmult_le_pos. apply Rmult_le_pos; lra. apply Rlt_le, Rinv_0_lt_compat; lra. }
assert (0 <= y * X) by (apply Rmult_le_pos; lra).
assert (0 <= n * (u - 2)) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma number_d : y < d * u / 3 /\ 0 < d /\ n < d / 3.
Proof.
assert (EV := number_V). assert (Hn := number_n).
assert (D1 : y < d * u / 3) by lra.
assert (D2 : 0 < d) by (apply Rmult_lt_reg_r with u; lra).
refine (conj D1 (conj D2 _)). apply Rmult_lt_reg_r with u. lra.
replace (d / 3 * u) with (d * u / 3) by field. lra.
Qed.

Lemma number_G : G = (2 * (A * u) + d) / 3.
Proof. unfold G, d. field. Qed.

Lemma number_W : W = u * (A * u + d) / 6 - n.
Proof. unfold W. rewrite number_V. unfold d. field. Qed.

Lemma Au_pos : 0 < A * u /\ 0 <= A * u * (u - 2) /\ 0 <= d * (u - 2).
Proof. generalize number_d; intros.
repeat split; [apply Rmult_lt_0_compat|apply Rmult_le_pos; [apply Rmult_le_pos|]|apply Rmult_le_pos]; lra. Qed.

Lemma numbers_two : 0 < G /\ 0 < W.
Proof. rewrite number_G, number_W. generalize number_d Au_pos. lra. Qed.

Lemma numbers_four : 4 <= u -> u * G / 4 <= W /\ 2 * W <= u * G /\ y * u * X <= G * u /\ y * X * 3 <= G * 3 /\
  2 * (A * u) <= 3 * G.
Proof.
intros H4. rewrite number_G, number_W. assert (D := number_d). assert (Hn := number_n).
assert (0 <= d * (u - 4)) by (apply Rmult_le_pos; lra). assert (AU := Au_pos).
assert (0 <= A * u * u) by (apply Rmult_le_pos; lra).
assert (X1 : 0 <= (1 - X * u) * d) by (apply Rmult_le_pos; lra).
assert (X2 : 0 <= (d * u / 3 - y) * X) by (apply Rmult_le_pos; lra).
assert (X3 : 0 <= y * X) by (apply Rmult_le_pos; lra).
assert (X4 : 0 <= (d / 3 - y * X) * u) by (apply Rmult_le_pos; lra).
repeat split; lra.
Qed.
End Numbers.

Section TouchDown.
Variables (a1 a2 a3 eps t0 t1 : R) (p b y v z : R -> R).
Hypothesis Ha1 : a1 < 0.
Hypothesis Ha2 : a2 < 0.
Hypothesis Heps : 0 < eps.
Hypothesis Hm : mechanism_from a1 a2 a3 eps t0 p b y v z.
Hypothesis Hlift : lift_off_at eps y v z t0.
Hypothesis Hz : z t0 <= 0.
Hypothesis Hflight : flight_from_to y z t0 t1.

Let u : R := (t1 - t0) / eps.
Let X : R := exp (- u).

Lemma touches : b t1 = flight_b a2 b t0 t1 /\ y t1 = flight_y a2 b y v t0 t1 /\ v t1 = flight_v a2 b v t0 t1 /\
  z t1 = flight_z eps z t0 t1 /\
  v t1 + z t1 / eps < 0.
Proof.
destruct Hlift as (E0 & Hup). destruct Hflight as (H01 & Hfly & E1).
destruct (flight_ends a1 a2 a3 eps Heps p b y v z t0 Hm E0 Hup Hz (or_introl Ha2))
  as (t2 & d & H02 & Hd & Hfly2 & E2 & Hdown & Hafter & F).
assert (E : t2 = t1).
{ destruct (Rtotal_order t1 t2) as [H|[H|H]]; auto.
  - specialize (Hfly2 t1 ltac:(lra)). lra.
  - set (s := t2 + Rmin d (t1 - t2) / 2). assert (M1 := Rmin_l d (t1 - t2)). assert (M2 := Rmin_r d (t1 - t2)).
    assert (M0 : 0 < Rmin d (t1 - t2)) by (apply Rmin_pos; lra).
    specialize (Hafter s ltac:(unfold s; lra)). specialize (Hfly s ltac:(unfold s; lra)). lra. }
subst t2. destruct (F t1 ltac:(lra)) as (F1 & F2 & F3 & F4). auto.
Qed.

Variables P B Y V Z : R -> R.
Hypothesis Hlin : forall t, model_at a1 a2 a3 eps linear_force P B Y V Z t.
Hypothesis HP : P t1 = p t1.
Hypothesis HB : B t1 = b t1.
Hypothesis HY : Y t1 = y t1.
Hypothesis HV : V t1 = v t1.
Hypothesis HZ : Z t1 = z t1.

Let L1 : CompliantGrowth.L eps Y Z t1 = 0.
Proof. destruct Hflight as (_ & _ & E). unfold CompliantGrowth.L, linear_force. rewrite HY, HZ, E. field. lra. Qed.

Let TU : t1 - t0 = eps * u.
Proof. unfold u. field. lra. Qed.

Let EX : flight_z eps z t0 t1 = z t0 * X.
Proof. unfold flight_z, X, u. f_equal. f_equal. field. lra. Qed.

Let EG : CompliantGrowth.G eps P B Y Z t1 = A a2 eps * u - b t0.
Proof.
unfold CompliantGrowth.G, deceleration. fold (CompliantGrowth.L eps Y Z t1). rewrite L1, HB, (proj1 touches).
unfold flight_b, A. rewrite TU. ring.
Qed.

Let EW : CompliantGrowth.W eps V t1 = - (v t0 / eps) - b t0 * u + A a2 eps * u ^ 2 / 2.
Proof.
unfold CompliantGrowth.W. rewrite HV. destruct touches as (_ & _ & -> & _). unfold flight_v, A. rewrite TU. field. lra.
Qed.

Let ED : CompliantGrowth.D eps Y V Z t1 = CompliantGrowth.W eps V t1 + - (z t0) / eps ^ 2 * X /\
  0 < CompliantGrowth.D eps Y V Z t1.
Proof.
destruct Hflight as (_ & _ & E). destruct touches as (_ & _ & _ & Ez & Hdown).
assert (E1 : CompliantGrowth.D eps Y V Z t1 = / eps * - (v t1 + z t1 / eps)).
{ unfold CompliantGrowth.D, force_rate. rewrite HY, HZ, HV, E. field. lra. }
split.
- rewrite E1, Ez, EX. unfold CompliantGrowth.W. rewrite HV. field. lra.
- rewrite E1. apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat|]; lra.
Qed.

Let Start : 0 < A a2 eps /\ 0 <= - (z t0) / eps ^ 2 < v t0 / eps.
Proof.
destruct Hlift as (_ & Hup). unfold separation_rate in Hup. split.
- unfold A. assert (0 < eps * - a2) by (apply Rmult_lt_0_compat; lra). lra.
- split. apply Rmult_le_pos. lra. apply Rlt_le, Rinv_0_lt_compat, pow_lt, Heps.
  assert (0 < / eps * (v t0 + z t0 / eps)) by (apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat|]; lra).
  replace (- z t0 / eps ^ 2) with (- (/ eps * (z t0 / eps))) by (field; lra). unfold Rdiv in *. lra.
Qed.

Let HX : 0 < u -> 0 < X /\ X * (1 + u) <= 1.
Proof.
intros Hu. split. apply exp_pos. assert (H := exp_ineq1_le u). assert (E : X * exp u = 1).
{ unfold X. rewrite <- exp_plus, Rplus_opp_l. apply exp_0. }
apply Rle_trans with (X * exp u); [|lra]. apply Rmult_le_compat_l; auto. apply Rlt_le, exp_pos.
Qed.

Let End : v t0 / eps * u + b t0 * u ^ 2 / 2 - A a2 eps * u ^ 3 / 6 - - (z t0) / eps ^ 2 * (1 - X) = 0.
Proof.
destruct Hlift as (E0 & _). destruct Hflight as (_ & _ & E1). destruct touches as (_ & Ey & _ & Ez & _).
rewrite EX in Ez. unfold flight_y in Ey. rewrite E1, Ez, E0, TU in Ey.
apply Rmult_eq_reg_r with (eps ^ 2); [|apply pow_nonzero; lra]. rewrite Rmult_0_l.
replace ((v t0 / eps * u + b t0 * u ^ 2 / 2 - A a2 eps * u ^ 3 / 6 - - z t0 / eps ^ 2 * (1 - X)) * eps ^ 2)
  with (z t0 + v t0 * (eps * u) + b t0 * (eps * u) ^ 2 / 2 + a2 * (eps * u) ^ 3 / 6 - z t0 * X)
    by (unfold A; field; lra). lra.
Qed.

Lemma late_below_one : a1 <= a3 -> 2 <= u -> p t1 <= 0 -> grows_from eps Y V Z t1.
Proof.
intros H13 Hu Hp. destruct Start as (HA & Hy).
destruct (numbers_two (A a2 eps) (b t0) (v t0 / eps) (- z t0 / eps ^ 2) u X HA Hu Hy (HX ltac:(lra)) End) as (HG & HW).
assert (HD := proj2 ED). apply (below_one a1 a2 a3 eps Heps P B Y V Z Hlin Ha1); try lra. unfold q. rewrite HP. lra.
Qed.

Lemma late_above_one : a3 < a1 -> 4 <= u ->
  eps * (a1 - a3) * (u + 2) / 2 + 16 / (u * (u + 2)) <= - p t1 ->
  eps * (a1 - a3) * (u + 2) / 2 + 4 / (u + 2) + 4 / (u + 2) ^ 2 + 24 / (u * (u + 4)) <= 4 -> grows_from eps Y V Z t1.
Proof.
intros H13 Hu Hp Hq. destruct Start as (HA & Hy). destruct (HX ltac:(lra)) as (X0 & X1). destruct ED as (ED1 & ED2).
destruct (numbers_two (A a2 eps) (b t0) (v t0 / eps) (- z t0 / eps ^ 2) u X HA ltac:(lra) Hy (conj X0 X1) End)
  as (HG & HW).
destruct (numbers_four (A a2 eps) (b t0) (v t0 / eps) (- z t0 / eps ^ 2) u X HA ltac:(lra) Hy (conj X0 X1) End Hu)
  as (N1 & N2 & _ & N3 & N4).
rewrite <- EG in *. rewrite <- EW in *.
set (G := CompliantGrowth.G eps P B Y Z t1) in *. set (W := CompliantGrowth.W eps V t1) in *.
set (D := CompliantGrowth.D eps Y V Z t1) in *.
set (yX := - z t0 / eps ^ 2 * X) in *.
assert (HyX : 0 <= yX) by (apply Rmult_le_pos; lra).
assert (ES : CompliantGrowth.S eps P B Y V Z t1 = W + G) by reflexivity.
set (a := 2 / (u + 2)).
assert (Ha : 0 < a) by (apply Rdiv_lt_0_compat; lra).
assert (Ha1' : a * (u + 2) = 2) by (unfold a; field; lra).
assert (Ha' : a < 1) by (apply Rmult_lt_reg_r with (u + 2); lra).
set (kap := eps * (a1 - a3)) in *.
assert (Hkap : 0 < kap) by (apply Rmult_lt_0_compat; lra).
assert (Eka : kap / a = kap * (u + 2) / 2) by (unfold a; field; lra).
assert (uG : 0 <= (u - 4) * G) by (apply Rmult_le_pos; lra).
apply (entrance a1 a2 a3 eps Heps P B Y V Z Hlin Ha1 ltac:(lra) ltac:(unfold kappa; fold kap; lra) a Ha t1 (1 / 4)
  Ha' ltac:(lra)).
- rewrite ES, L1. fold W G D. rewrite ED1 in *.
  assert (aW : 0 <= (1 - a) * W) by (apply Rmult_le_pos; lra).
  assert (ay : 0 <= (1 - a) * yX) by (apply Rmult_le_pos; lra).
  assert (aS : a * (W + G) <= G).
  { apply Rmult_le_reg_r with (u + 2). lra. replace (a * (W + G) * (u + 2)) with (a * (u + 2) * (W + G)) by ring.
    rewrite Ha1'. lra. }
  repeat split; lra.
- unfold kappa, q. fold kap. rewrite HP, Eka.
  apply Rle_trans with ((1 - a) * (1 / 4) * (16 / (u * (u + 2)))).
  + right. unfold a. field. lra.
  + apply Rmult_le_compat_l. lra. lra.
- rewrite ES. fold W G. unfold enough, kappa. fold kap. rewrite Eka.
  replace (2 * a) with (4 / (u + 2)) by (unfold a; field; lra).
  replace (a ^ 2) with (4 / (u + 2) ^ 2) by (unfold a; field; lra).
  set (q1 := kap * (u + 2) / 2 + 4 / (u + 2) + 4 / (u + 2) ^ 2) in *.
  assert (S0 : A a2 eps * u * (u + 4) / 6 <= W + G).
  { assert (0 <= (u + 4) * (3 * G - 2 * (A a2 eps * u))) by (apply Rmult_le_pos; lra). lra. }
  assert (K0 : 0 < 24 / (u * (u + 4))) by (apply Rdiv_lt_0_compat; [lra|apply Rmult_lt_0_compat; lra]).
  assert (K1 : 24 / (u * (u + 4)) * (A a2 eps * u * (u + 4) / 6) <= (4 - q1) * (W + G)).
  { apply Rmult_le_compat; try lra. apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; [apply Rmult_le_pos|]; lra. }
  replace (24 / (u * (u + 4)) * (A a2 eps * u * (u + 4) / 6)) with (4 * A a2 eps) in K1 by (field; lra). lra.
Qed.

End TouchDown.
