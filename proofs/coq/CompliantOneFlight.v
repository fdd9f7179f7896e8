(** * The compliant model: one flight, then contact for ever, from inequalities at lift-off

    The second half of Theorem F6 of flight.md. In the time u = t/eps since lift-off, with A = - eps a2 = kappa m, V =
    v/eps and y = - z/eps^2 at lift-off, the flight ends where V u + b u^2/2 - A u^3/6 = y (1 - e^(-u)). From y < V and
    1 - e^(-u) <= u: A u > 3 b, so u >= 4 ([long_flight]); from y >= 0: kappa u is at most the larger root of
    s^2 = (27/2) q s + 18 kappa sqrt q, so kappa (u + 2) <= 4 ([short_flight]). Then the touch-down is late enough
    ([late_touch_down]). *)

From Coq Require Import Reals Psatz Lra Lia.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCompliant StatementFlight Calculus CompliantMotion.
Open Scope R_scope.

Section Numbers.
Variables kappa m q b V y u X : R.
Hypothesis Hkappa : 0 < kappa <= 27 / 64.
Hypothesis Hm : 0 < m.
Hypothesis Hq : 0 < q.
Hypothesis Hcube : 64 * kappa ^ 2 <= q ^ 3.
Hypothesis Hroot : 27 / 2 * q + sqrt (18 * kappa * sqrt q) + 2 * kappa <= 4.
Hypothesis Hb : q * m / 4 <= b <= 9 / 2 * q * m.
Hypothesis HV : V <= 3 * sqrt q * m.
Hypothesis Hy : 0 <= y < V.
Hypothesis Hu : 0 < u.
Hypothesis HX : 1 - u <= X <= 1.
Hypothesis Hend : V * u + b * u ^ 2 / 2 - kappa * m * u ^ 3 / 6 - y * (1 - X) = 0.

(** kappa is small beside q: the cube of 16 kappa is at most that of 3 q. *)
Lemma kappa_small : 16 * kappa <= 3 * q.
Proof.
apply Rnot_lt_le. intros H. assert (K2 : 0 < kappa ^ 2) by (apply pow_lt; lra).
assert (C : (3 * q) ^ 3 < (16 * kappa) ^ 3).
{ apply Rlt_le_trans with (16 * kappa * (3 * q) ^ 2).
  - assert (0 < (16 * kappa - 3 * q) * (3 * q) ^ 2) by (apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]). lra.
  - assert ((3 * q) ^ 2 <= (16 * kappa) ^ 2) by (apply pow_incr; lra).
    replace ((16 * kappa) ^ 3) with (16 * kappa * (16 * kappa) ^ 2) by ring. apply Rmult_le_compat_l; lra. }
assert (0 <= (27 / 64 - kappa) * kappa ^ 2) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma long_flight : 3 * q < 4 * (kappa * u).
Proof.
assert (Y : y * (1 - X) < V * u).
{ apply Rle_lt_trans with (y * u). apply Rmult_le_compat_l; lra. apply Rmult_lt_compat_r; lra. }
assert (U : 0 < u ^ 2) by (apply pow_lt, Hu).
assert (P : 0 < u ^ 2 * (kappa * m * u - 3 * b)) by lra.
assert (Q : 0 < kappa * m * u - 3 * b).
{ apply Rmult_lt_reg_l with (u ^ 2); auto. lra. }
apply Rmult_lt_reg_r with m; auto. lra.
Qed.

Lemma at_least_four : 4 <= u.
Proof.
assert (K := kappa_small). assert (L := long_flight). apply Rmult_le_reg_l with kappa; lra.
Qed.

Lemma short_flight : kappa * (u + 2) <= 4.
Proof.
set (s := kappa * u). assert (s0 : 0 < s) by (apply Rmult_lt_0_compat; lra).
assert (R0 : 0 <= sqrt (18 * kappa * sqrt q)) by apply sqrt_pos.
assert (RR : sqrt (18 * kappa * sqrt q) * sqrt (18 * kappa * sqrt q) = 18 * kappa * sqrt q).
{ apply sqrt_sqrt. apply Rmult_le_pos; [lra|apply sqrt_pos]. }
set (R := sqrt (18 * kappa * sqrt q)) in *. set (r := sqrt q) in *.
assert (Y0 : 0 <= y * (1 - X)) by (apply Rmult_le_pos; lra).
assert (E : kappa * m * u ^ 2 / 6 <= V + b * u / 2).
{ apply Rmult_le_reg_r with u; auto. lra. }
assert (B : b * u <= 9 / 2 * q * m * u) by (apply Rmult_le_compat_r; lra).
assert (F : kappa * u ^ 2 <= 18 * r + 27 / 2 * q * u).
{ apply Rmult_le_reg_r with m; auto. lra. }
assert (S : s * s <= R * R + 27 / 2 * q * s).
{ apply Rmult_le_compat_l with (r := kappa) in F; [|lra]. unfold s. lra. }
assert (Most : s <= 27 / 2 * q + R).
{ apply Rnot_lt_le. intros H.
  assert (0 < (s - 27 / 2 * q - R) * s) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= (s - R) * R) by (apply Rmult_le_pos; lra). lra. }
unfold s in Most. lra.
Qed.

Lemma late_by_q : kappa + 16 / (u * (u + 2)) <= q.
Proof.
assert (K := kappa_small). assert (L := long_flight). assert (F := at_least_four).
assert (Q2 : 0 < q ^ 2) by (apply pow_lt, Hq).
assert (U : 9 * q ^ 2 <= 16 * kappa ^ 2 * u ^ 2).
{ replace (9 * q ^ 2) with ((3 * q) ^ 2) by ring. replace (16 * kappa ^ 2 * u ^ 2) with ((4 * (kappa * u)) ^ 2) by ring.
  apply pow_incr. lra. }
assert (U2 : 0 < u ^ 2) by (apply pow_lt, Hu).
assert (C : 64 * kappa ^ 2 * u ^ 2 <= q ^ 3 * u ^ 2) by (apply Rmult_le_compat_r; lra).
assert (D : 36 <= q * u ^ 2).
{ apply Rmult_le_reg_l with (q ^ 2); auto. lra. }
assert (W : 16 / (u * (u + 2)) <= 4 / 9 * q).
{ apply Rmult_le_reg_r with (u * (u + 2)). apply Rmult_lt_0_compat; lra.
  replace (16 / (u * (u + 2)) * (u * (u + 2))) with 16 by (field; lra).
  assert (0 < q * u) by (apply Rmult_lt_0_compat; lra). lra. }
lra.
Qed.

Lemma late_by_four : kappa * (u + 2) / 2 + 4 / (u + 2) + 4 / (u + 2) ^ 2 + 24 / (u * (u + 4)) <= 4.
Proof.
assert (S := short_flight). assert (F := at_least_four).
assert (D : 4 / (u + 2) <= 2 / 3).
{ apply Rmult_le_reg_r with (u + 2). lra. replace (4 / (u + 2) * (u + 2)) with 4 by (field; lra). lra. }
assert (D0 : 0 < 4 / (u + 2)) by (apply Rdiv_lt_0_compat; lra).
assert (D2 : 4 / (u + 2) ^ 2 <= 1 / 6).
{ replace (4 / (u + 2) ^ 2) with (4 / (u + 2) * (4 / (u + 2)) / 4) by (field; lra).
  assert (4 / (u + 2) * (4 / (u + 2)) <= 2 / 3 * (2 / 3)) by (apply Rmult_le_compat; lra). lra. }
assert (D3 : 24 / (u * (u + 4)) <= 3 / 4).
{ apply Rmult_le_reg_r with (u * (u + 4)). apply Rmult_lt_0_compat; lra.
  replace (24 / (u * (u + 4)) * (u * (u + 4))) with 24 by (field; lra).
  assert (0 <= (u - 4) * u) by (apply Rmult_le_pos; lra). lra. }
lra.
Qed.
End Numbers.

(** Plan: the flight ends by [flight_ends], with the state in closed form; its length satisfies the equation above, so
    [late_touch_down] holds, where p has fallen by a1 eps u. *)
Theorem one_flight_of : flight_ends -> late_touch_down -> one_flight_from_state.
Proof.
intros Ends Late a1 a2 a3 eps t0 p b y v z H1 H3 H31 H2 He Hm Hl Hz kappa q mean Hq Hcube Hk Hroot Hb1 Hb2 HV.
destruct (Ends a1 a2 a3 eps t0 p b y v z He Hm Hl Hz (or_introl H2)) as (t1 & H01 & Fly & In & Down).
exists t1. split; [exact H01|]. split; [exact Fly|]. split; [exact Down|].
set (u := (t1 - t0) / eps). assert (TU : t1 - t0 = eps * u) by (unfold u; field; lra).
assert (Hu : 0 < u) by (apply Rdiv_lt_0_compat; lra).
assert (K0 : 0 < kappa) by (apply Rmult_lt_0_compat; lra).
assert (M0 : 0 < mean).
{ unfold mean. replace (a2 / (a3 - a1)) with (- a2 / (a1 - a3)) by (field; lra). apply Rdiv_lt_0_compat; lra. }
assert (KM : kappa * mean = - (eps * a2)) by (unfold kappa, mean; field; lra).
set (Y := - z t0 / eps ^ 2). set (X := exp (- u)).
assert (HX : 1 - u <= X <= 1).
{ unfold X. split. assert (G := exp_ineq1_le (- u)). lra. rewrite <- exp_0. left. apply exp_increasing. lra. }
destruct Hl as (E0 & Hup). unfold separation_rate in Hup.
assert (HY : 0 <= Y < v t0 / eps).
{ unfold Y. split. apply Rmult_le_pos. lra. apply Rlt_le, Rinv_0_lt_compat, pow_lt, He.
  apply Rmult_lt_reg_r with eps; auto. replace (- z t0 / eps ^ 2 * eps) with (- (z t0 / eps)) by (field; lra).
  replace (v t0 / eps * eps) with (v t0) by (field; lra). lra. }
assert (End : v t0 / eps * u + b t0 * u ^ 2 / 2 - kappa * mean * u ^ 3 / 6 - Y * (1 - X) = 0).
{ destruct (In t1 ltac:(lra)) as (_ & _ & Ey & Ez). destruct Down as (E1 & _). rewrite E1, Ez, E0, TU in Ey.
  replace (- (eps * u) / eps) with (- u) in Ey by (field; lra). fold X in Ey.
  apply Rmult_eq_reg_r with (eps ^ 2); [|apply pow_nonzero; lra]. rewrite KM, Rmult_0_l. unfold Y.
  replace ((v t0 / eps * u + b t0 * u ^ 2 / 2 - - (eps * a2) * u ^ 3 / 6 - - z t0 / eps ^ 2 * (1 - X)) * eps ^ 2)
    with (z t0 + v t0 * (eps * u) + b t0 * (eps * u) ^ 2 / 2 + a2 * (eps * u) ^ 3 / 6 - z t0 * X)
    by (field; lra). lra. }
assert (P : - p t1 = q + - a1 * (eps * u)).
{ rewrite (affine a1 p t0 t1). rewrite TU. unfold q. ring. intros s Hs. apply (Hm s).
  unfold InitialValueProblem.segment in Hs. rewrite Rmin_left, Rmax_right in Hs by lra. lra. }
apply (Late a1 a2 a3 eps t0 t1 p b y v z H1 H31 H2 He Hm (conj E0 Hup) Hz).
- split; [exact H01|]. split; [exact Fly|apply Down].
- fold u. apply (at_least_four kappa mean q (b t0) (v t0 / eps) Y u X); auto.
- fold u. fold kappa. rewrite P. assert (Q := late_by_q kappa mean q (b t0) (v t0 / eps) Y u X
    (conj K0 Hk) M0 Hq Hcube (conj Hb1 Hb2) HY Hu HX End).
  assert (0 <= (a3 - 3 * a1) * (eps * u)) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rmult_lt_0_compat; lra]).
  assert (kappa * u = (a1 - a3) * (eps * u)) by (unfold kappa; ring). lra.
- fold u. fold kappa. apply (late_by_four kappa mean q (b t0) (v t0 / eps) Y u X); auto.
Qed.
