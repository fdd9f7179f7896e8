(** * The barrier of Theorem B

    proofs/from_state.md, (9) and (10). Monomials pay for the source ([barrier_pays]); the layer I stays below its
    values at both ends, the second of which increases with e ([layer_below]): with q = log(p1/p) the exponent of I is
    psi(q) = Gamma q - A (1 - e^(-2q)), A = theta p1^2/(2e). It is convex with psi(0) = 0, so psi(q) <= (q/Q) psi(Q);
    and with sigma = log(e0/e) psi at h = h1 is Gamma Q0 + 2 Gamma sigma/3 - A0 e^sigma + A0 e^(-2 Q0) e^(-sigma/3).
    *)

From Coq Require Import Reals Psatz Lra List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus LogarithmicNorm StatementStep StatementPassage PassageEquations PassageNorm.
Open Scope R_scope.

(** ** Monomials that pay *)

Definition nonnegative (F : monomials) : Prop := forall a, In a F -> 0 <= coefficient a.

(** What is left of - p d/dp less Gamma - theta r/h. *)
Definition surplus (Gamma theta : R) (F : monomials) (h r : R) : R :=
  total F (fun a => coefficient a * (E_of a - Gamma + theta * r / h) * monomial a h r).

Section Pays.
Variables (Gamma theta h r : R).
Hypothesis Htheta : 0 < theta.
Hypothesis Hh : 0 < h.
Hypothesis Hr : 0 < r.

Lemma monomial_pos a : 0 < monomial a h r.
Proof. apply Rmult_lt_0_compat; apply pow_lt; assumption. Qed.

(** By the damping alone. *)
Lemma damping_pays c i n A : c / theta <= A ->
  c * monomial (Term c i (S n)) h r <= A * (theta * r / h) * monomial (Term A (S i) n) h r.
Proof.
intros HA. assert (Q := monomial_pos (Term c i (S n))).
replace (A * (theta * r / h) * monomial (Term A (S i) n) h r) with (A * theta * monomial (Term c i (S n)) h r)
  by (unfold monomial; simpl; field; lra).
apply Rmult_le_compat_r; [lra|]. apply (Rmult_le_compat_r theta) in HA; [|lra].
unfold Rdiv in HA. rewrite Rmult_assoc, Rinv_l in HA by lra. lra.
Qed.

Lemma pays_enough a Z : pays Gamma theta a Z -> 0 <= coefficient a ->
  nonnegative Z /\ coefficient a * monomial a h r <= surplus Gamma theta Z h r.
Proof.
assert (T0 : 0 < theta * r / h) by (apply Rdiv_lt_0_compat; auto; apply Rmult_lt_0_compat; auto).
assert (Down : forall c A, 0 <= c -> c / theta <= A -> 0 <= A).
{ intros c A Hc HA. apply Rle_trans with (2 := HA). apply Rmult_le_pos; auto. apply Rlt_le, Rinv_0_lt_compat; auto. }
induction 1 as [a A HE HA|c i n A HA HE|c i n A deficit Z HA HE HD HZ IH]; intros Hc; unfold surplus; simpl.
- assert (A0 : 0 <= A).
  { apply Rle_trans with (2 := HA). apply Rmult_le_pos; auto. apply Rlt_le, Rinv_0_lt_compat. lra. }
  split. intros b [<-|[]]; exact A0. rewrite Rplus_0_r.
  change (monomial (Term A (by_h a) (by_r a)) h r) with (monomial a h r).
  change (E_of (Term A (by_h a) (by_r a))) with (E_of a).
  apply Rmult_le_compat_r. apply Rlt_le, monomial_pos.
  apply Rle_trans with (A * (E_of a - Gamma)); [|apply Rmult_le_compat_l; lra].
  apply (Rmult_le_compat_r (E_of a - Gamma)) in HA; [|lra]. unfold Rdiv in HA.
  rewrite Rmult_assoc, Rinv_l in HA by lra. lra.
- simpl in Hc. assert (A0 := Down c A Hc HA). split. intros b [<-|[]]; exact A0. rewrite Rplus_0_r.
  apply Rle_trans with (1 := damping_pays c i n A HA). apply Rmult_le_compat_r. apply Rlt_le, monomial_pos.
  apply Rmult_le_compat_l; lra.
- simpl in Hc. assert (A0 := Down c A Hc HA).
  assert (D0 : 0 <= deficit) by (apply Rle_trans with (2 := HD); apply Rmult_le_pos; lra).
  destruct (IH D0) as [N HS]. split. intros b [<-|Hb]; [exact A0|apply N, Hb].
  simpl coefficient in HS. unfold surplus in HS. assert (Q := damping_pays c i n A HA).
  assert (Q' := Rmult_le_compat_r _ _ _ (Rlt_le _ _ (monomial_pos (Term A (S i) n))) HD).
  change (monomial (Term deficit (S i) n) h r) with (monomial (Term A (S i) n) h r) in HS. lra.
Qed.

Lemma total_app (F F' : monomials) f : total (F ++ F') f = total F f + total F' f.
Proof. induction F as [|a F IH]; simpl. ring. rewrite IH. ring. Qed.

Lemma barrier_pays source Z : all_paid Gamma theta source Z ->
  nonnegative Z /\ value_of source h r <= surplus Gamma theta Z h r.
Proof.
induction 1 as [|a source Z Z' Ha HZ HZ' [N' S']].
- split. intros b []. unfold value_of, surplus; simpl. lra.
- destruct (pays_enough a Z HZ Ha) as [N S]. split.
  + intros b Hb. apply in_app_or in Hb. destruct Hb; auto.
  + unfold value_of, surplus in *. simpl. rewrite total_app. lra.
Qed.

End Pays.

Lemma value_nonneg F h r : nonnegative F -> 0 <= h -> 0 <= r -> 0 <= value_of F h r.
Proof.
intros N Hh Hr. unfold value_of. induction F as [|a F IH]; simpl. lra.
assert (Q := monomial_le a h r h r ltac:(lra) ltac:(lra)).
assert (0 <= coefficient a * monomial a h r) by (apply Rmult_le_pos; [apply N; left; auto|lra]).
assert (0 <= total F (fun a => coefficient a * monomial a h r)) by (apply IH; intros b Hb; apply N; right; auto). lra.
Qed.

Lemma value_increases F h r h' r' : nonnegative F -> 0 <= h <= h' -> 0 <= r <= r' -> value_of F h r <= value_of F h' r'.
Proof.
intros N Hh Hr. unfold value_of. induction F as [|a F IH]; simpl. lra.
assert (Q := monomial_le a h r h' r' Hh Hr).
assert (coefficient a * monomial a h r <= coefficient a * monomial a h' r').
{ apply Rmult_le_compat_l; [apply N; left; auto|lra]. }
assert (total F (fun a => coefficient a * monomial a h r) <= total F (fun a => coefficient a * monomial a h' r'))
  by (apply IH; intros b Hb; apply N; right; auto). lra.
Qed.

(** In T, with F' = change F: hr times (Gamma - theta r/h) F and the surplus. *)
Lemma change_is_surplus Gamma theta F h r : 0 < h ->
  change F h r = h * r * ((Gamma - theta * r / h) * value_of F h r + surplus Gamma theta F h r).
Proof.
intros Hh. unfold change, value_of, surplus. f_equal. rewrite <- total_scal, <- total_plus. apply total_ext. intros a.
field. lra.
Qed.

(** ** The layer *)

Lemma chord q Q : 0 <= q <= Q -> 0 < Q -> q / Q * (1 - exp (- (2 * Q))) <= 1 - exp (- (2 * q)).
Proof.
intros Hq HQ. set (u := q / Q). assert (Hu : 0 <= u <= 1).
{ unfold u. split. apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat, HQ].
  apply Rmult_le_reg_r with Q; auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
assert (Eq : q = u * Q) by (unfold u; field; lra).
set (m := exp (- (2 * q))). assert (M0 : 0 < m) by apply exp_pos.
(* the two ends lie above the tangent at q *)
assert (T1 : m * (1 + (- (2 * Q) + 2 * q)) <= exp (- (2 * Q))).
{ replace (- (2 * Q)) with (- (2 * q) + (- (2 * Q) + 2 * q)) at 2 by ring. rewrite exp_plus. fold m.
  apply Rmult_le_compat_l; [lra|apply exp_ineq1_le]. }
assert (T0 : m * (1 + 2 * q) <= 1).
{ apply Rle_trans with (m * exp (2 * q)). apply Rmult_le_compat_l; [lra|apply exp_ineq1_le].
  unfold m. rewrite <- exp_plus, Rplus_opp_l, exp_0. lra. }
assert (U1 := Rmult_le_compat_l u _ _ (proj1 Hu) T1). assert (U0 := Rmult_le_compat_l (1 - u) _ _ ltac:(lra) T0).
assert (Es : u * (m * (1 + (- (2 * Q) + 2 * q))) + (1 - u) * (m * (1 + 2 * q)) = m) by (rewrite Eq; ring). lra.
Qed.

(** psi. *)
Definition exponent (Gamma A q : R) : R := Gamma * q - A * (1 - exp (- (2 * q))).

Lemma layer_is Gamma theta z0 p1 e p : 0 < p1 -> 0 < p -> 0 < e ->
  layer Gamma theta z0 p1 e p = z0 * exp (exponent Gamma (theta * p1 ^ 2 / (2 * e)) (ln p1 - ln p)).
Proof.
intros H1 Hp He. unfold layer, Rpower, exponent. rewrite Rmult_assoc, <- exp_plus, ln_div by assumption. f_equal.
f_equal.
replace (exp (- (2 * (ln p1 - ln p)))) with (p ^ 2 / p1 ^ 2).
- field. lra.
- replace (- (2 * (ln p1 - ln p))) with (ln p + ln p + - (ln p1 + ln p1)) by ring.
  rewrite exp_plus, exp_Ropp, !exp_plus, !exp_ln by assumption. field. lra.
Qed.

Lemma exponent_increases Gamma A0 Q0 sigma : 0 <= sigma -> 0 <= A0 -> 2 * Gamma / 3 <= A0 ->
  exponent Gamma (A0 * exp sigma) (Q0 + 2 / 3 * sigma) <= exponent Gamma A0 Q0.
Proof.
intros Hs HA HG. unfold exponent.
replace (A0 * exp sigma * (1 - exp (- (2 * (Q0 + 2 / 3 * sigma)))))
  with (A0 * exp sigma - A0 * exp (- (2 * Q0)) * exp (- (sigma / 3))).
- assert (X1 := exp_ineq1_le sigma). assert (X2 : exp (- (sigma / 3)) <= 1) by (rewrite <- exp_0; apply exp_le; lra).
  assert (Y1 := Rmult_le_compat_l A0 _ _ HA X1).
  assert (Y2 : A0 * exp (- (2 * Q0)) * exp (- (sigma / 3)) <= A0 * exp (- (2 * Q0)) * 1).
  { apply Rmult_le_compat_l; [|exact X2]. apply Rmult_le_pos; [exact HA|apply Rlt_le, exp_pos]. }
  assert (Y3 := Rmult_le_compat_r sigma _ _ Hs HG). lra.
- replace (- (2 * (Q0 + 2 / 3 * sigma))) with (- (2 * Q0) + (- sigma + - (sigma / 3))) by field.
  rewrite !exp_plus, (exp_Ropp sigma). assert (X := exp_pos sigma). field. lra.
Qed.

Lemma q_within p1 e0 h1 e p : 0 < p1 -> 0 < h1 -> 0 < e <= e0 -> 0 < p -> e <= h1 * (p * sqrt p) ->
  ln p1 - ln p <= ln p1 - ln (p_at_h e0 h1) + 2 / 3 * (ln e0 - ln e).
Proof.
intros H1 Hh1 He Hp Hh. unfold p_at_h, Rpower. rewrite ln_exp, ln_div by lra.
assert (Sp := sqrt_lt_R0 p Hp). assert (Ls : ln p = ln (sqrt p) + ln (sqrt p)).
{ rewrite <- ln_mult, sqrt_sqrt by lra. reflexivity. }
assert (X := ln_le e _ ltac:(lra) Hh). rewrite !ln_mult in X by (try apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma layer_below Gamma theta z0 p1 e0 h1 e p : 0 <= z0 -> 0 < theta -> 0 < p1 -> 0 < h1 -> 0 < e <= e0 ->
  p_at_h e0 h1 < p1 -> 2 * Gamma / 3 < theta * p1 ^ 2 / (2 * e0) -> 0 < p <= p1 -> e <= h1 * (p * sqrt p) ->
  layer Gamma theta z0 p1 e p <= Rmax z0 (layer Gamma theta z0 p1 e0 (p_at_h e0 h1)).
Proof.
intros Hz Ht H1 Hh1 He HS HG Hp Hh.
assert (P0 : 0 < p_at_h e0 h1) by apply exp_pos. rewrite !layer_is by lra.
set (A0 := theta * p1 ^ 2 / (2 * e0)) in *. set (q := ln p1 - ln p).
set (Q0 := ln p1 - ln (p_at_h e0 h1)). set (sigma := ln e0 - ln e). set (Q := Q0 + 2 / 3 * sigma).
assert (HA : 0 < A0) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [|apply pow_lt]|]; lra).
assert (Hs : 0 <= sigma) by (assert (X := ln_le e e0 ltac:(lra) ltac:(lra)); unfold sigma; lra).
assert (HQ0 : 0 < Q0) by (assert (X := ln_increasing _ _ P0 HS); unfold Q0; lra).
assert (Hq : 0 <= q) by (assert (X := ln_le p p1 ltac:(lra) ltac:(lra)); unfold q; lra).
assert (HqQ : q <= Q) by (apply q_within; assumption || lra).
assert (HQ : 0 < Q) by (unfold Q; lra).
assert (EA : theta * p1 ^ 2 / (2 * e) = A0 * exp sigma).
{ unfold A0, sigma. replace (ln e0 - ln e) with (ln e0 + - ln e) by ring.
  rewrite exp_plus, exp_Ropp, !exp_ln by lra. field. lra. }
rewrite EA. assert (I := exponent_increases Gamma A0 Q0 sigma Hs ltac:(lra) ltac:(lra)). fold Q in I.
assert (Ch : exponent Gamma (A0 * exp sigma) q <= q / Q * exponent Gamma (A0 * exp sigma) Q).
{ assert (C := chord q Q (conj Hq HqQ) HQ). assert (X := exp_pos sigma).
  apply (Rmult_le_compat_l (A0 * exp sigma)) in C; [|apply Rlt_le, Rmult_lt_0_compat; lra].
  unfold exponent. replace (q / Q * (Gamma * Q - A0 * exp sigma * (1 - exp (- (2 * Q)))))
    with (Gamma * q - A0 * exp sigma * (q / Q * (1 - exp (- (2 * Q))))) by (field; lra). lra. }
set (psi := exponent Gamma (A0 * exp sigma) Q) in *.
assert (Hu : 0 <= q / Q <= 1).
{ split. apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra].
  apply Rmult_le_reg_r with Q; [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
destruct (Rle_dec psi 0) as [N|N].
- apply Rle_trans with (2 := Rmax_l _ _). rewrite <- (Rmult_1_r z0) at 2. apply Rmult_le_compat_l; auto.
  rewrite <- exp_0. apply exp_le. apply Rle_trans with (1 := Ch).
  assert (0 <= q / Q * - psi) by (apply Rmult_le_pos; lra). lra.
- apply Rle_trans with (2 := Rmax_r _ _). apply Rmult_le_compat_l; auto. apply exp_le.
  apply Rle_trans with (1 := Ch). apply Rle_trans with (2 := I).
  assert (0 <= (1 - q / Q) * psi) by (apply Rmult_le_pos; lra). lra.
Qed.

(** Along p' = - hr p with r/h = p^2/e. *)
Lemma layer_rate Gamma theta z0 p1 e eps (p : R -> R) t hr : 0 < eps -> 0 < p1 -> 0 < p t -> e <> 0 ->
  rate_in_T eps p t (- hr * p t) ->
  rate_in_T eps (fun s => layer Gamma theta z0 p1 e (p s)) t
    (hr * ((Gamma - theta * p t ^ 2 / e) * layer Gamma theta z0 p1 e (p t))).
Proof.
intros He H1 Hp Hn Dp. unfold rate_in_T, layer, Rpower.
assert (Q : 0 < p1 / p t) by (apply Rdiv_lt_0_compat; auto).
assert (DG : is_derive (fun u => z0 * exp (Gamma * ln (p1 / u)) * exp (- (theta * (p1 ^ 2 - u ^ 2) / (2 * e)))) (p t)
  (- / p t * ((Gamma - theta * p t ^ 2 / e) * (z0 * exp (Gamma * ln (p1 / p t))
    * exp (- (theta * (p1 ^ 2 - p t ^ 2) / (2 * e))))))).
{ auto_derive. split; [lra|]. split; [exact Q|auto].
  change (p1 * / p t) with (p1 / p t). set (X := exp (Gamma * ln (p1 / p t))).
  set (Y := exp (- (theta * (p1 ^ 2 - p t ^ 2) / (2 * e)))).
  change (exp (- (theta * (p1 * (p1 * 1) + - (p t * (p t * 1))) * / (2 * e)))) with Y.
  field. repeat split; lra. }
eapply is_derive_val.
- apply (is_derive_comp (fun u => z0 * exp (Gamma * ln (p1 / u)) * exp (- (theta * (p1 ^ 2 - u ^ 2) / (2 * e)))) p);
  [exact DG|exact Dp].
- unfold scal; simpl. unfold mult; simpl. field. repeat split; lra.
Qed.
