(** * The compliant model: every motion in contact is K times the slow one, up to what grows slower than every
    exponential

    The slow solution f = Gamma(-beta) F outgrows every exponential with its derivatives, and comes into {Q > 0} of
    [CompliantDichotomy] for every rate. So each solution x of the equation of the deviation on a half-line has one
    number K, the same for all rates, with x^(i) - K f^(i) = O(e^(gT)), i <= 3, for every g > 0. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral CompliantSlow
  CompliantDominance CompliantDichotomy.
Open Scope R_scope.

Section Split.
Variables (e beta : R).
Hypothesis He : 0 < e.
Hypothesis Hb : not_nat beta.

(** the equation of the deviation in T, as a chain, for T >= T0 *)
Definition forward_chain (T0 : R) (x0 x1 x2 x3 : R -> R) : Prop := forall t, T0 <= t ->
  is_derive x0 t (x1 t) /\ is_derive x1 t (x2 t) /\ is_derive x2 t (x3 t) /\
  is_derive x3 t (e * (- beta * x0 t + (1 - beta + t) * x1 t + t * x2 t) - 2 * x3 t).

Definition slow_derivative (n : nat) (t : R) : R := Gamma (- beta) * Derive_n (Fe e beta) n t.

Lemma slow_derivative_derive n t : is_derive (slow_derivative n) t (slow_derivative (S n) t).
Proof.
apply (is_derive_scal (Derive_n (Fe e beta) n)). apply (Derive_correct (Derive_n (Fe e beta) n)).
exact (Fe_ex_derive_n e He beta (S n) t Hb).
Qed.

Lemma slow_chain T0 : forward_chain T0 (slow_derivative 0) (slow_derivative 1) (slow_derivative 2) (slow_derivative 3).
Proof.
intros t _. refine (conj (slow_derivative_derive 0 t) (conj (slow_derivative_derive 1 t)
  (conj (slow_derivative_derive 2 t) _))).
apply (is_derive_val _ _ _ _ (slow_derivative_derive 3 t)).
assert (H := proj2 (Fe_ode e He beta Hb) t). unfold slow_derivative.
change (Derive_n (Fe e beta) 0 t) with (Fe e beta t). change (Derive_n (Fe e beta) 1 t) with (Derive (Fe e beta) t).
set (F := Fe e beta) in *. set (D4 := Derive_n F 4 t) in *.
replace D4 with (e * (1 / e * D4)) by (field; lra).
replace (1 / e * D4) with (- beta * F t + t * Derive F t + (1 - beta) * Derive F t + t * Derive_n F 2 t
  - 2 / e * Derive_n F 3 t) by lra.
field. lra.
Qed.

(** f^(n) outgrows every exponential *)
Lemma slow_exponential n M : 0 <= M -> exists c T, 0 < c /\ 0 <= T /\ forall t, T <= t ->
  c * exp (M * t) <= slow_derivative n t.
Proof.
intros HM. destruct (Fe_right e He beta n Hb 1) as (T1 & HT1 & H1).
destruct (Fe_ratio e He beta n M Hb HM) as (T2 & HT2 & H2).
set (T := T1 + T2). exists (slow_derivative n T * exp (- M * T)), T.
assert (P : 1 <= slow_derivative n T) by (apply H1; unfold T; lra).
refine (conj _ (conj _ _)).
- apply Rmult_lt_0_compat; [lra|apply exp_pos].
- unfold T; lra.
- intros t Ht.
  assert (G : slow_derivative n T * exp (- M * T) <= slow_derivative n t * exp (- M * t)).
  { apply Ropp_le_cancel. apply (decr_of_derive (fun t => - (slow_derivative n t * exp (- M * t)))
      (fun t => - ((slow_derivative (S n) t - M * slow_derivative n t) * exp (- M * t))) T t Ht).
    - intros x Hx. apply (is_derive_opp (fun t => slow_derivative n t * exp (- M * t))).
      apply (weighted_derive M (slow_derivative n) (slow_derivative (S n))), slow_derivative_derive.
    - intros x Hx. assert (A := H2 x ltac:(unfold T in Hx; lra)).
      assert (0 <= (slow_derivative (S n) x - M * slow_derivative n x) * exp (- M * x)).
      { apply Rmult_le_pos; [unfold slow_derivative; lra|apply Rlt_le, exp_pos]. } lra. }
  apply (Rmult_le_compat_r (exp (M * t))) in G; [|apply Rlt_le, exp_pos].
  rewrite (Rmult_assoc (slow_derivative n t)), <- exp_plus in G. replace (- M * t + M * t) with 0 in G by ring.
  rewrite exp_0, Rmult_1_r in G. exact G.
Qed.

Let mu := 1 - e * (1 - beta).
Let nu := e * beta.

Lemma chain_motion T0 x0 x1 x2 x3 : forward_chain T0 x0 x1 x2 x3 ->
  motion_from e mu nu T0 x0 x1 (fun t => x1 t + x2 t) (fun t => x2 t + x3 t).
Proof.
intros H t Ht. destruct (H t Ht) as (D0 & D1 & D2 & D3). refine (conj D0 (conj _ (conj _ _))).
- apply (is_derive_val _ _ _ _ D1). ring.
- exact (is_derive_plus x1 x2 t _ _ D1 D2).
- apply (is_derive_val _ _ _ _ (is_derive_plus x2 x3 t _ _ D2 D3)). unfold plus, mu, nu; simpl. ring.
Qed.

(** f is in {Q > 0} for large T, for every rate *)
Lemma slow_in_form g : 0 < g -> exists T, late e mu nu g T /\ forall t, T <= t ->
  0 < form g (slow_derivative 0 t) (slow_derivative 1 t) (slow_derivative 1 t + slow_derivative 2 t)
    (slow_derivative 2 t + slow_derivative 3 t) /\
  0 < slow_derivative 1 t + slow_derivative 2 t.
Proof.
intros Hg. assert (Hi : 0 < / g) by (apply Rinv_0_lt_compat, Hg).
destruct (Fe_right e He beta 0 Hb 1) as (T0 & HT0 & H0).
destruct (Fe_ratio e He beta 0 1 Hb ltac:(lra)) as (T1 & HT1 & H1).
destruct (Fe_ratio e He beta 1 (1 + / g) Hb ltac:(lra)) as (T2 & HT2 & H2).
destruct (Fe_ratio e He beta 2 1 Hb ltac:(lra)) as (T3 & HT3 & H3).
set (q := (1 + 2 * g) ^ 2 + (mu + / g) ^ 2 + 2 * nu ^ 2 / g).
assert (Hq : 0 <= q).
{ unfold q, Rdiv. assert (0 <= 2 * nu ^ 2 * / g) by (apply Rmult_le_pos; [generalize (pow2_ge_0 nu); lra|lra]).
  generalize (pow2_ge_0 (1 + 2 * g)) (pow2_ge_0 (mu + / g)). lra. }
assert (Hqe : 0 <= q / e) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat, He]).
exists (T0 + T1 + T2 + T3 + q / e). split.
- split; [lra|]. fold q.
  assert (e * (q / e) <= e * (T0 + T1 + T2 + T3 + q / e)) by (apply Rmult_le_compat_l; lra).
  replace (e * (q / e)) with q in H by (field; lra). lra.
- intros t Ht. assert (A0 := H0 t ltac:(lra)). assert (A1 := H1 t ltac:(lra)). assert (A2 := H2 t ltac:(lra)).
  assert (A3 := H3 t ltac:(lra)).
  fold (slow_derivative 0 t) in A0, A1. fold (slow_derivative 1 t) in A1, A2. fold (slow_derivative 2 t) in A2, A3.
  fold (slow_derivative 3 t) in A3.
  set (f0 := slow_derivative 0 t) in *. set (f1 := slow_derivative 1 t) in *. set (f2 := slow_derivative 2 t) in *.
  set (f3 := slow_derivative 3 t) in *.
  assert (B1 : 0 < / g * f1) by (apply Rmult_lt_0_compat; lra). split; [|lra].
  unfold form, Rdiv.
  assert (C1 : f0 ^ 2 < f1 ^ 2) by nra.
  assert (C2 : (1 + / g) * f1 * f1 <= f2 * f1) by (apply Rmult_le_compat_r; lra).
  assert (C3 : f2 * f1 < (f2 + f3) * (f1 + f2)) by nra.
  assert (C4 : 0 < f1 ^ 2) by (apply pow_lt; lra). assert (C5 : 0 < / g * f1 ^ 2) by (apply Rmult_lt_0_compat; lra).
  lra.
Qed.

Lemma sq_le_abs x r : 0 <= r -> x ^ 2 <= r ^ 2 -> Rabs x <= r.
Proof. intros Hr H. rewrite <- (Rabs_pos_eq r) by auto. apply Rsqr_le_abs_0. unfold Rsqr. simpl in H. lra. Qed.

Definition remains (g K : R) (x0 x1 x2 x3 : R -> R) : Prop := exists A T, forall t, T <= t ->
  Rabs (x0 t - K * slow_derivative 0 t) <= A * exp (g * t) /\ Rabs (x1 t - K * slow_derivative 1 t) <= A * exp
    (g * t) /\
  Rabs (x2 t - K * slow_derivative 2 t) <= A * exp (g * t) /\ Rabs (x3 t - K * slow_derivative 3 t) <= A * exp (g * t).

Lemma split_rate g T0 x0 x1 x2 x3 : 0 < g -> forward_chain T0 x0 x1 x2 x3 -> exists K, remains (2 * g) K x0 x1 x2 x3.
Proof.
intros Hg Hx. destruct (slow_in_form g Hg) as (T1 & Hlate & HF).
set (T := Rmax T0 T1). assert (M0 := Rmax_l T0 T1). assert (M1 := Rmax_r T0 T1). fold T in M0, M1.
assert (HT : late e mu nu g T) by (apply (late_after e mu nu g He T1 Hlate T M1)).
assert (HMx : motion_from e mu nu T x0 x1 (fun t => x1 t + x2 t) (fun t => x2 t + x3 t)).
{ intros t Ht. apply (chain_motion T0 _ _ _ _ Hx). lra. }
assert (HMF := chain_motion T _ _ _ _ (slow_chain T)).
destruct (split_off e mu nu g He Hg T _ _ _ _ _ _ _ _ HT HMF HMx (fun t Ht => proj1 (HF t ltac:(lra))) (fun t Ht =>
  proj2 (HF t ltac:(lra)))) as (K & HK).
destruct (slow_if_never e mu nu g He Hg T _ _ _ _ HT (combination e mu nu T _ _ _ _ _ _ _ _ HMF HMx K) HK)
  as (A & HA & HN).
exists K, (3 * (A + 1)), T. intros t Ht. specialize (HN t Ht). unfold size in HN. cbv beta in HN.
set (E := exp (2 * g * t)) in *. assert (HE : 0 < E) by apply exp_pos.
assert (EE : exp (4 * g * t) = E ^ 2) by (unfold E; simpl; rewrite Rmult_1_r, <- exp_plus; f_equal; ring).
assert (HB : A * exp (4 * g * t) <= ((A + 1) * E) ^ 2).
{ rewrite EE, Rpow_mult_distr. apply Rmult_le_compat_r; [apply pow2_ge_0|]. nra. }
set (r := (A + 1) * E) in *. assert (Hr : 0 <= r) by (apply Rmult_le_pos; lra).
set (X0 := x0 t - K * slow_derivative 0 t) in *. set (X1 := x1 t - K * slow_derivative 1 t) in *.
set (X2 := x1 t + x2 t - K * (slow_derivative 1 t + slow_derivative 2 t)) in *.
set (X3 := x2 t + x3 t - K * (slow_derivative 2 t + slow_derivative 3 t)) in *.
assert (P0 := pow2_ge_0 X0). assert (P1 := pow2_ge_0 X1). assert (P2 := pow2_ge_0 X2). assert (P3 := pow2_ge_0 X3).
assert (B0 : Rabs X0 <= r) by (apply sq_le_abs; lra). assert (B1 : Rabs X1 <= r) by (apply sq_le_abs; lra).
assert (B2 : Rabs X2 <= r) by (apply sq_le_abs; lra). assert (B3 : Rabs X3 <= r) by (apply sq_le_abs; lra).
replace (3 * (A + 1) * E) with (3 * r) by (unfold r; ring).
replace (x2 t - K * slow_derivative 2 t) with (X2 - X1) by (unfold X1, X2; ring).
replace (x3 t - K * slow_derivative 3 t) with (X3 - X2 + X1) by (unfold X1, X2, X3; ring).
apply Rabs_le_between in B0, B1, B2, B3. repeat split; apply Rabs_le; lra.
Qed.

(** K is the same for every rate *)
Lemma rate_unique g h K L x0 x1 x2 x3 : 0 < g -> 0 < h -> remains g K x0 x1 x2 x3 -> remains h L x0 x1 x2 x3 -> K = L.
Proof.
intros Hg Hh (A & T1 & HA) (B & T2 & HB).
destruct (slow_exponential 1 (g + h + 1) ltac:(lra)) as (c & T3 & Hc & HT3 & HF).
destruct (Req_dec K L) as [|Hn]; auto. exfalso.
set (m := Rabs (K - L)). assert (Hm : 0 < m) by (apply Rabs_pos_lt; lra).
set (S := Rabs A + Rabs B + 1). assert (HS : 0 < S) by (unfold S; generalize (Rabs_pos A) (Rabs_pos B); lra).
set (t := Rmax (Rmax T1 T2) (Rmax T3 (S / (c * m)))).
assert (M1 := Rmax_l (Rmax T1 T2) (Rmax T3 (S / (c * m)))). assert (M2 := Rmax_r (Rmax T1 T2) (Rmax T3 (S / (c * m)))).
fold t in M1, M2.
assert (M3 := Rmax_l T1 T2). assert (M4 := Rmax_r T1 T2). assert (M5 := Rmax_l T3 (S / (c * m))).
assert (M6 := Rmax_r T3 (S / (c * m))).
destruct (HA t ltac:(lra)) as (_ & A1 & _). destruct (HB t ltac:(lra)) as (_ & B1 & _). assert (F1 := HF t ltac:(lra)).
assert (Ht : 0 <= t) by lra. set (f := slow_derivative 1 t) in *.
set (E := exp ((g + h) * t)). assert (HE : 0 < E) by apply exp_pos.
assert (Eg : exp (g * t) <= E) by (apply exp_le; assert (0 <= h * t) by (apply Rmult_le_pos; lra); lra).
assert (Eh : exp (h * t) <= E) by (apply exp_le; assert (0 <= g * t) by (apply Rmult_le_pos; lra); lra).
assert (Et : exp ((g + h + 1) * t) = E * exp t) by (unfold E; rewrite <- exp_plus; f_equal; ring). rewrite Et in F1.
assert (G1 : Rabs A * exp (g * t) <= Rabs A * E) by (apply Rmult_le_compat_l; [apply Rabs_pos|lra]).
assert (G2 : Rabs B * exp (h * t) <= Rabs B * E) by (apply Rmult_le_compat_l; [apply Rabs_pos|lra]).
assert (G3 : A * exp (g * t) <= Rabs A * exp (g * t))
  by (apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|apply Rle_abs]).
assert (G4 : B * exp (h * t) <= Rabs B * exp (h * t))
  by (apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|apply Rle_abs]).
assert (Hf : 0 < f) by (eapply Rlt_le_trans; [|exact F1]; apply Rmult_lt_0_compat; auto; apply Rmult_lt_0_compat; auto;
  apply exp_pos).
assert (G5 : m * f <= S * E).
{ unfold m. rewrite <- (Rabs_pos_eq f) by lra. rewrite <- Rabs_mult.
  replace ((K - L) * f) with ((x1 t - L * f) - (x1 t - K * f)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. unfold S. lra. }
assert (G6 : m * (c * (E * exp t)) <= m * f) by (apply Rmult_le_compat_l; lra).
assert (G7 : c * m * exp t <= S).
{ apply Rmult_le_reg_r with E; auto. lra. }
assert (G8 := exp_ineq1_le t).
assert (Hcm : 0 < c * m) by (apply Rmult_lt_0_compat; auto).
assert (G9 : c * m * (S / (c * m)) <= c * m * t) by (apply Rmult_le_compat_l; lra).
replace (c * m * (S / (c * m))) with S in G9 by (field; split; lra).
assert (G10 : c * m * (1 + t) <= c * m * exp t) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Theorem split_every_rate T0 x0 x1 x2 x3 : forward_chain T0 x0 x1 x2 x3 -> exists K, forall g, 0 < g ->
  remains g K x0 x1 x2 x3.
Proof.
intros Hx. destruct (split_rate (/ 2) T0 x0 x1 x2 x3 ltac:(lra) Hx) as (K & HK). exists K. intros g Hg.
destruct (split_rate (g / 2) T0 x0 x1 x2 x3 ltac:(lra) Hx) as (L & HL).
rewrite (rate_unique (2 * / 2) (2 * (g / 2)) K L x0 x1 x2 x3 ltac:(lra) ltac:(lra) HK HL).
replace g with (2 * (g / 2)) at 1 by field. exact HL.
Qed.

(** ** Solutions are determined by their state, and may be superposed *)
Lemma forward_combination T0 k k' x0 x1 x2 x3 y0 y1 y2 y3 z0 z1 z2 z3 : forward_chain T0 x0 x1 x2 x3 ->
  forward_chain T0 y0 y1 y2 y3 ->
  forward_chain T0 z0 z1 z2 z3 -> forward_chain T0 (fun t => z0 t - k * x0 t - k' * y0 t) (fun t =>
    z1 t - k * x1 t - k' * y1 t)
    (fun t => z2 t - k * x2 t - k' * y2 t) (fun t => z3 t - k * x3 t - k' * y3 t).
Proof.
intros Hx Hy Hz t Ht. destruct (Hx t Ht) as (A0 & A1 & A2 & A3). destruct (Hy t Ht) as (B0 & B1 & B2 & B3).
destruct (Hz t Ht) as (C0 & C1 & C2 & C3).
assert (L : forall (f g h : R -> R) lf lg lh, is_derive f t lf -> is_derive g t lg -> is_derive h t lh ->
  is_derive (fun t => h t - k * f t - k' * g t) t (lh - k * lf - k' * lg)).
{ intros f g h lf lg lh Df Dg Dh. apply (is_derive_minus (fun t => h t - k * f t) (fun t => k' * g t)).
  apply (is_derive_minus h (fun t => k * f t)); auto. apply (is_derive_scal f), Df. apply (is_derive_scal g), Dg. }
refine (conj (L _ _ _ _ _ _ A0 B0 C0) (conj (L _ _ _ _ _ _ A1 B1 C1) (conj (L _ _ _ _ _ _ A2 B2 C2) _))).
apply (is_derive_val _ _ _ _ (L _ _ _ _ _ _ A3 B3 C3)). ring.
Qed.

Lemma forward_zero T0 x0 x1 x2 x3 : forward_chain T0 x0 x1 x2 x3 -> x0 T0 = 0 -> x1 T0 = 0 -> x2 T0 = 0 -> x3 T0 = 0 ->
  forall t, T0 <= t -> x1 t = 0.
Proof.
intros H I0 I1 I2 I3 t Ht.
set (E := fun t => x0 t ^ 2 + x1 t ^ 2 + x2 t ^ 2 + x3 t ^ 2).
set (x4 := fun t => e * (- beta * x0 t + (1 - beta + t) * x1 t + t * x2 t) - 2 * x3 t).
set (E' := fun t => 2 * x0 t * x1 t + 2 * x1 t * x2 t + 2 * x2 t * x3 t + 2 * x3 t * x4 t).
set (b := Rabs T0 + Rabs t). set (c := e * (1 + Rabs beta + b)).
assert (Hb0 := Rabs_pos beta). assert (HT0 := Rabs_pos T0). assert (Htp := Rabs_pos t).
assert (Hc : 0 <= c) by (apply Rmult_le_pos; unfold b; lra).
assert (HE : E t = 0).
{ apply (one_step_zero E E' T0 t (7 + 3 * c)).
  - intros s Hs. rewrite Rmin_left, Rmax_right in Hs by lra. destruct (H s ltac:(lra)) as (D0 & D1 & D2 & D3).
    unfold E, E'. eapply is_derive_val.
    + apply (is_derive_plus (fun t => x0 t ^ 2 + x1 t ^ 2 + x2 t ^ 2) (fun t => x3 t ^ 2)).
      apply (is_derive_plus (fun t => x0 t ^ 2 + x1 t ^ 2) (fun t => x2 t ^ 2)).
      apply (is_derive_plus (fun t => x0 t ^ 2) (fun t => x1 t ^ 2)).
      apply is_derive_pow, D0. apply is_derive_pow, D1. apply is_derive_pow, D2. apply is_derive_pow, D3.
    + unfold plus, x4; simpl. ring.
  - intros s. unfold E. generalize (pow2_ge_0 (x0 s)) (pow2_ge_0 (x1 s)) (pow2_ge_0 (x2 s)) (pow2_ge_0 (x3 s)). lra.
  - unfold E. rewrite I0, I1, I2, I3. ring.
  - intros s Hs. rewrite Rmin_left, Rmax_right in Hs by lra. unfold E, E', x4.
    assert (Hsb : Rabs s <= b).
    { unfold b. apply Rabs_le. generalize (Rle_abs t) (Rle_abs (- T0)). rewrite Rabs_Ropp. lra. }
    assert (two : forall k x y, Rabs k <= c -> - (c * (x ^ 2 + y ^ 2)) <= k * (2 * x * y) <= c * (x ^ 2 + y ^ 2)).
    { intros k x y Hk. apply Rabs_le_between. rewrite Rabs_mult.
      apply Rmult_le_compat; try apply Rabs_pos; auto. apply Rabs_le.
      generalize (pow2_ge_0 (x + y)) (pow2_ge_0 (x - y)). lra. }
    assert (one : forall x y, - (x ^ 2 + y ^ 2) <= 2 * x * y <= x ^ 2 + y ^ 2).
    { intros x y. generalize (pow2_ge_0 (x + y)) (pow2_ge_0 (x - y)). lra. }
    assert (K0 : Rabs (- e * beta) <= c).
    { rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq e) by lra. apply Rmult_le_compat_l; unfold b; lra. }
    assert (K1 : Rabs (e * (1 - beta + s)) <= c).
    { rewrite Rabs_mult, (Rabs_pos_eq e) by lra. apply Rmult_le_compat_l; [lra|].
      eapply Rle_trans; [apply Rabs_triang|]. unfold Rminus. assert (A := Rabs_triang 1 (- beta)).
      rewrite Rabs_Ropp, Rabs_R1 in A. lra. }
    assert (K2 : Rabs (e * s) <= c) by (rewrite Rabs_mult, (Rabs_pos_eq e) by lra; apply Rmult_le_compat_l; lra).
    assert (U0 := two _ (x3 s) (x0 s) K0). assert (U1 := two _ (x3 s) (x1 s) K1). assert (U2 := two _ (x3 s) (x2 s) K2).
    assert (V0 := one (x0 s) (x1 s)). assert (V1 := one (x1 s) (x2 s)). assert (V2 := one (x2 s) (x3 s)).
    assert (P0 := pow2_ge_0 (x0 s)). assert (P1 := pow2_ge_0 (x1 s)). assert (P2 := pow2_ge_0 (x2 s)).
    assert (P3 := pow2_ge_0 (x3 s)).
    assert (Q0 : 0 <= c * x0 s ^ 2) by (apply Rmult_le_pos; lra).
    assert (Q1 : 0 <= c * x1 s ^ 2) by (apply Rmult_le_pos; lra).
    assert (Q2 : 0 <= c * x2 s ^ 2) by (apply Rmult_le_pos; lra).
    assert (Q3 : 0 <= c * x3 s ^ 2) by (apply Rmult_le_pos; lra).
    apply Rabs_le. lra. }
unfold E in HE. assert (P0 := pow2_ge_0 (x0 t)). assert (P1 := pow2_ge_0 (x1 t)). assert (P2 := pow2_ge_0 (x2 t)).
assert (P3 := pow2_ge_0 (x3 t)).
destruct (Req_dec (x1 t) 0) as [|Hn]; auto. exfalso. assert (A := pow2_gt_0 _ Hn). lra.
Qed.

End Split.
