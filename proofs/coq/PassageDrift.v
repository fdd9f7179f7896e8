(** * How far C1 can move on the way to the G-spot

    proofs/from_state.md, (11) and (12). By (7) log|C| moves no faster than beta (|w| + c_W (Z + I)), which is at most
    the rate of a function that is known: monomials over their E, and z0 (1 - e^(-fall q))/fall with q = log(p1/p) for
    I ([layer_falls]). At the end each monomial is at most its value for e = e0 and h = h1 ([monomial_end]). *)

From Coq Require Import Reals Psatz Lra Lia List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus LogarithmicNorm StatementStep StatementPassage PassageEquations PassageNorm
  PassageBarrier PassageForce.
Open Scope R_scope.

(** ** The layer *)

(** I is at most an exponential, for all e at once. *)
Lemma layer_falls Gamma theta z0 p1 e0 h1 e p fall : 0 <= z0 -> 0 < theta -> 0 < p1 -> 0 < h1 -> 0 < e <= e0 ->
  p_at_h e0 h1 < p1 -> 0 < p <= p1 -> e <= h1 * (p * sqrt p) ->
  fall = theta * (p1 ^ 2 - p_at_h e0 h1 ^ 2) / (2 * e0) / Rmax (ln (p1 / p_at_h e0 h1)) (2 / 3) - Gamma ->
  layer Gamma theta z0 p1 e p <= z0 * exp (- (fall * (ln p1 - ln p))).
Proof.
intros Hz Ht H1 Hh1 He HS Hp Hh Hfall.
assert (P0 : 0 < p_at_h e0 h1) by apply exp_pos. rewrite layer_is by lra. apply Rmult_le_compat_l; [exact Hz|].
apply exp_le. set (q := ln p1 - ln p). rewrite ln_div in Hfall by lra.
set (Q0 := ln p1 - ln (p_at_h e0 h1)) in *. set (sigma := ln e0 - ln e). set (Q := Q0 + 2 / 3 * sigma).
set (A0 := theta * p1 ^ 2 / (2 * e0)). set (U0 := Rmax Q0 (2 / 3)) in *.
assert (HA : 0 < A0) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [|apply pow_lt]|]; lra).
assert (Hs : 0 <= sigma) by (assert (X := ln_le e e0 ltac:(lra) ltac:(lra)); unfold sigma; lra).
assert (HQ0 : 0 < Q0) by (assert (X := ln_increasing _ _ P0 HS); unfold Q0; lra).
assert (HQ : 0 < Q) by (unfold Q; lra).
assert (Hq : 0 <= q <= Q).
{ split; [assert (X := ln_le p p1 ltac:(lra) ltac:(lra)); unfold q; lra|]. apply q_within; assumption || lra. }
assert (EA : theta * p1 ^ 2 / (2 * e) = A0 * exp sigma).
{ unfold A0, sigma. replace (ln e0 - ln e) with (ln e0 + - ln e) by ring.
  rewrite exp_plus, exp_Ropp, !exp_ln by lra. field. lra. }
rewrite EA. assert (U1 : Q0 <= U0) by apply Rmax_l. assert (U2 : 2 / 3 <= U0) by apply Rmax_r.
set (D0 := A0 * (1 - exp (- (2 * Q0)))).
assert (ED : fall = D0 / U0 - Gamma).
{ rewrite Hfall. f_equal. f_equal. unfold D0, A0.
  replace (exp (- (2 * Q0))) with (p_at_h e0 h1 ^ 2 / p1 ^ 2).
  - field. lra.
  - unfold Q0. replace (- (2 * (ln p1 - ln (p_at_h e0 h1))))
      with (ln (p_at_h e0 h1) + ln (p_at_h e0 h1) + - (ln p1 + ln p1)) by ring.
    rewrite exp_plus, exp_Ropp, !exp_plus, !exp_ln by lra. field. lra. }
assert (D1 : 0 <= D0).
{ apply Rmult_le_pos; [lra|]. assert (X : exp (- (2 * Q0)) <= exp 0) by (apply exp_le; lra). rewrite exp_0 in X. lra. }
assert (C := chord q Q Hq HQ). assert (Ep := exp_pos sigma).
(* A (1 - e^(-2Q)) >= D0 e^sigma, Q <= U0 e^sigma *)
assert (X1 : D0 * exp sigma <= A0 * exp sigma * (1 - exp (- (2 * Q)))).
{ unfold D0. replace (A0 * (1 - exp (- (2 * Q0))) * exp sigma) with (A0 * exp sigma * (1 - exp (- (2 * Q0)))) by ring.
  apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. assert (exp (- (2 * Q)) <= exp (- (2 * Q0))); [|lra].
  apply exp_le. unfold Q. lra. }
assert (X2 : Q <= U0 * exp sigma).
{ apply Rle_trans with (U0 * (1 + sigma)). assert (2 / 3 * sigma <= U0 * sigma) by (apply Rmult_le_compat_r; lra).
  unfold Q; lra. apply Rmult_le_compat_l; [lra|apply exp_ineq1_le]. }
assert (X3 : D0 / U0 <= A0 * exp sigma * (1 - exp (- (2 * Q))) / Q).
{ apply Rle_trans with (D0 * exp sigma / Q).
  - apply Rmult_le_reg_r with (Q * U0). apply Rmult_lt_0_compat; lra.
    replace (D0 / U0 * (Q * U0)) with (D0 * Q) by (field; lra).
    replace (D0 * exp sigma / Q * (Q * U0)) with (D0 * (U0 * exp sigma)) by (field; lra). apply Rmult_le_compat_l; lra.
  - apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra|exact X1]. }
apply (Rmult_le_compat_l (A0 * exp sigma)) in C; [|apply Rmult_le_pos; lra].
apply (Rmult_le_compat_l q) in X3; [|lra]. unfold exponent. rewrite ED.
replace (A0 * exp sigma * (q / Q * (1 - exp (- (2 * Q)))))
  with (q * (A0 * exp sigma * (1 - exp (- (2 * Q))) / Q)) in C by (field; lra). lra.
Qed.

(** ** Monomials *)

Lemma total_le_in (F : monomials) f f' : (forall a, In a F -> f a <= f' a) -> total F f <= total F f'.
Proof.
intros H. induction F as [|a F IH]; simpl. lra. assert (A := H a (or_introl eq_refl)).
assert (B' := IH (fun b Hb => H b (or_intror Hb))). lra.
Qed.

(** At the end, for e <= e0 and h <= h1. *)
Lemma monomial_end a e0 h1 e h r : 0 < E_of a -> 0 < e <= e0 -> 0 < h <= h1 -> 0 < r -> h * r ^ 3 = e ->
  monomial a h r <= monomial a h1 (sqrt (p_at_h e0 h1)).
Proof.
intros HE He Hh Hr Ee. assert (P0 : 0 < p_at_h e0 h1) by apply exp_pos. assert (S0 := sqrt_lt_R0 _ P0).
assert (LS : ln (sqrt (p_at_h e0 h1)) = / 3 * (ln e0 - ln h1)).
{ assert (X : ln (p_at_h e0 h1) = ln (sqrt (p_at_h e0 h1)) + ln (sqrt (p_at_h e0 h1))).
  { rewrite <- ln_mult, sqrt_sqrt by lra. reflexivity. }
  unfold p_at_h at 1 in X. unfold Rpower in X. rewrite ln_exp, ln_div in X by lra. lra. }
assert (LN : forall u w, 0 < u -> 0 < w -> ln (monomial a u w) = INR (by_h a) * ln u + INR (by_r a) * ln w).
{ intros u w Hu Hw. unfold monomial. rewrite ln_mult, !ln_pow by (try apply pow_lt; assumption). reflexivity. }
assert (LE : ln e = ln h + 3 * ln r).
{ rewrite <- Ee, ln_mult, ln_pow by (try apply pow_lt; lra). simpl. ring. }
assert (L1 := ln_le e e0 ltac:(lra) ltac:(lra)). assert (L2 := ln_le h h1 ltac:(lra) ltac:(lra)).
apply Rnot_lt_le. intros Hn. apply ln_increasing in Hn; [|apply Rmult_lt_0_compat; apply pow_lt; lra].
rewrite !LN in Hn by lra. rewrite LS in Hn. unfold E_of in HE. assert (N0 := pos_INR (by_r a)).
assert (M1 := Rmult_le_compat_l (INR (by_r a)) _ _ N0 L1).
assert (M2 := Rmult_le_compat_l (3 * INR (by_h a) - INR (by_r a)) _ _ ltac:(lra) L2).
replace (ln r) with ((ln e - ln h) / 3) in Hn by lra. lra.
Qed.

Lemma kept_grows r1 a : (1 <= by_h a)%nat -> 0 < E_of (kept r1 a).
Proof.
intros H. unfold E_of, kept. cbv zeta. cbn [by_h by_r]. set (n := Nat.min (by_r a) (3 * by_h a - 1)).
assert (Hn : (n + 1 <= 3 * by_h a)%nat) by (unfold n; lia). apply le_INR in Hn.
rewrite plus_INR, mult_INR in Hn. replace (INR 3) with 3 in Hn by (simpl; ring). change (INR 1) with 1 in Hn. lra.
Qed.

Lemma kept_above r1 a h r : 0 <= coefficient a -> 0 <= h -> 0 <= r <= r1 ->
  coefficient a * monomial a h r <= coefficient (kept r1 a) * monomial (kept r1 a) h r.
Proof.
intros Ha Hh Hr. unfold kept, monomial. cbv zeta. cbn [by_h by_r coefficient].
set (n := Nat.min (by_r a) (3 * by_h a - 1)). set (k := (by_r a - n)%nat).
replace (r ^ by_r a) with (r ^ k * r ^ n) by (rewrite <- pow_add; f_equal; unfold k, n; lia).
assert (P1 : 0 <= h ^ by_h a) by (apply pow_le, Hh). assert (P2 : 0 <= r ^ n) by (apply pow_le; lra).
assert (P3 := pow_incr r r1 k Hr). apply (Rmult_le_compat_r (h ^ by_h a * r ^ n)) in P3; 
  [|apply Rmult_le_pos; assumption].
apply (Rmult_le_compat_l (coefficient a)) in P3; [lra|exact Ha].
Qed.

(** The function whose rate is known, as a polynomial. *)
Definition over_E (a : one_term) : one_term := Term (Rabs (coefficient a) / E_of a) (by_h a) (by_r a).

Lemma over_E_value F h r : value_of (map over_E F) h r = integral_at F h r.
Proof. unfold value_of, integral_at. induction F as [|a F IH]; simpl; [reflexivity|]. rewrite IH. reflexivity. Qed.

Lemma over_E_change F h r : (forall a, In a F -> 0 < E_of a) -> change (map over_E F) h r = h * r * size F h r.
Proof.
intros H. unfold change, size. f_equal. induction F as [|a F IH]; simpl; [reflexivity|].
rewrite IH by (intros b Hb; apply H; right; exact Hb). f_equal.
change (E_of (over_E a)) with (E_of a). change (monomial (over_E a) h r) with (monomial a h r).
assert (HE := H a (or_introl eq_refl)). field. lra.
Qed.

Lemma integral_nonneg F h r : (forall a, In a F -> 0 < E_of a) -> 0 <= h -> 0 <= r -> 0 <= integral_at F h r.
Proof.
intros H Hh Hr. rewrite <- over_E_value. apply value_nonneg; auto. intros b Hb. apply in_map_iff in Hb.
destruct Hb as (a & <- & Ha). simpl. apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, H, Ha.
Qed.

Lemma integral_end F e0 h1 e h r : (forall a, In a F -> 0 < E_of a) -> 0 < e <= e0 -> 0 < h <= h1 -> 0 < r ->
  h * r ^ 3 = e -> integral_at F h r <= integral_at F h1 (sqrt (p_at_h e0 h1)).
Proof.
intros H He Hh Hr Ee. apply total_le_in. intros a Ha. apply Rmult_le_compat_l.
- apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, H, Ha.
- apply (monomial_end a e0 h1 e h r (H a Ha) He Hh Hr Ee).
Qed.

Lemma value_below_kept Z h r r1 : nonnegative Z -> 0 <= h -> 0 <= r <= r1 ->
  value_of Z h r <= size (map (kept r1) Z) h r.
Proof.
intros N Hh Hr. unfold value_of, size. induction Z as [|a Z IH]; [simpl; lra|].
cbn [map total fold_right]. assert (A0 := N a (or_introl eq_refl)).
assert (A := kept_above r1 a h r A0 Hh Hr). assert (B' := IH (fun b Hb => N b (or_intror Hb))).
assert (Q := monomial_le (kept r1 a) h r h r ltac:(lra) ltac:(lra)).
assert (R' := Rmult_le_compat_r _ _ _ (proj1 Q) (Rle_abs (coefficient (kept r1 a)))). unfold total in B'. lra.
Qed.

(** ** The drift *)

(** Plan: the motion is one of the contact equations ([HX']); G is the function with a known rate g' ([DG]); log|C|
    moves no faster ([DC]); so log|C| - G and - log|C| - G fall ([Mono]); G is at least 0 at the start ([G0]) and at
    most the bound at the end ([G1]). *)
Theorem passage_drift : StatementPassage.passage_drift.
Proof.
intros M P K N source Z eps x t0 t1 fall HN HP Hw HZ p_S Hfall Hf t Ht.
assert (Pass := passage M P K N source Z eps x t0 t1 HN HP).
destruct HP as (He & He0 & Ht1 & Hp0 & HL0 & Hz0 & HX & Hp1 & Hh1).
destruct (of_model _ _ _ _ _ _ HN) as (_ & H1 & _ & Hb & _).
destruct (of_start _ _ _ _ _ _ HN) as (P1 & Z0 & _ & Hr1 & HS).
destruct (of_rectangle _ _ _ _ _ _ HN) as (Hh1' & Hth & Hd).
assert (HX' : forall s, t0 <= s <= t1 -> moves_by M eps spring_force x s).
{ intros s Hs. apply moves_in_contact; [apply Rlt_le, Pass, Hs|apply HX, Hs]. }
set (e := - alpha1 M * eps) in *. assert (E0 : 0 < e) by (apply Rmult_lt_0_compat; lra).
set (h := h_at M eps x). set (r := r_at x). set (share := c_W M K (h1 N) (r1 N)) in *.
set (kZ := map (kept (r1 N)) Z). set (q := fun s => ln (p1 N) - ln (p x s)).
assert (HkZ : forall a, In a kZ -> 0 < E_of a).
{ intros a Ha. apply in_map_iff in Ha. destruct Ha as (b & <- & Hb'). apply kept_grows, HZ, Hb'. }
assert (Hp : forall s, t0 <= s <= t1 -> 0 < p x s <= p1 N).
{ intros s Hs. apply (p_within M P K N source Z HN eps x t0 Hp0 t1 HX' Hp1 s Hs). }
assert (Hon : forall s, t0 <= s <= t1 -> on_rectangle M K eps x (h1 N) (r1 N) s).
{ intros s Hs. apply (on_t M P K N source Z HN eps x t0 He Hp0 t1 HX' Hp1 Hh1 s Hs). }
assert (Hhr : forall s, t0 <= s <= t1 -> 0 < h s <= h1 N /\ 0 < r s <= r1 N).
{ intros s Hs. assert (O := Hon s Hs). split; [apply (h_within _ _ _ _ _ _ _ O)|apply (r_within _ _ _ _ _ _ _ O)]. }
assert (Sp : 0 < share) by apply (share_positive M P K N source Z HN).
set (G := fun s => beta_of M * (value_of (map over_E (slow_w P)) (h s) (r s)
  + share * (z0 N / fall * (1 - exp (- (fall * q s))) + value_of (map over_E kZ) (h s) (r s)))).
set (g' := fun s => h s * r s * (beta_of M * (size (slow_w P) (h s) (r s)
  + share * (z0 N * exp (- (fall * q s)) + size kZ (h s) (r s))))).
assert (DG : forall s, t0 <= s <= t1 -> rate_in_T eps G s (g' s)).
{ intros s Hs. assert (Hps := Hp s Hs). assert (Dp := proj1 (HX' s Hs)).
  assert (Dw := value_rate M eps x s He (proj1 Hps) Dp (map over_E (slow_w P))).
  assert (DZ := value_rate M eps x s He (proj1 Hps) Dp (map over_E kZ)). cbv zeta in Dw, DZ.
  rewrite over_E_change in Dw, DZ by assumption. fold h r in Dw, DZ.
  assert (DE : rate_in_T eps (fun s => z0 N / fall * (1 - exp (- (fall * q s)))) s
    (h s * r s * (z0 N * exp (- (fall * q s))))).
  { assert (DQ : is_derive (fun u => z0 N / fall * (1 - exp (- (fall * (ln (p1 N) - ln u))))) (p x s)
      (- (z0 N * exp (- (fall * q s)) / p x s))).
    { auto_derive. lra. unfold q. change (ln (p1 N) + - ln (p x s)) with (ln (p1 N) - ln (p x s)). field. lra. }
    unfold rate_in_T. eapply is_derive_val.
    apply (is_derive_comp (fun u => z0 N / fall * (1 - exp (- (fall * (ln (p1 N) - ln u))))) (p x));
      [exact DQ|exact Dp].
    unfold scal; simpl. unfold mult; simpl. unfold h, r. rewrite (hr_value M eps x s (proj1 Hps)). field. lra. }
  unfold G, g'. eapply rate_same. apply rate_scal; [exact He|].
  apply rate_plus; [exact He|exact Dw|]. apply rate_scal; [exact He|].
  apply rate_plus; [exact He|exact DE|exact DZ]. cbv beta. ring. }
set (lc := fun s => ln (Rabs (C_at M x s))).
assert (DC : forall s, t0 <= s <= t1 -> exists c', rate_in_T eps lc s c' /\ Rabs c' <= g' s).
{ intros s Hs. destruct (Pass s Hs) as (_ & HL & Hz). destruct (Hhr s Hs) as [Hh Hr].
  assert (HLn : L_at M x s <> 0) by (intros Q; rewrite Q, Rmult_0_r in HL; lra).
  assert (D' := log_C_rate M P K (h1 N) (r1 N) eps x s (Hon s Hs) (HX' s Hs) HLn).
  assert (W2 := w2_small M P K (h1 N) (r1 N) eps x s (Hon s Hs) HLn).
  eexists. split; [exact D'|]. fold (h s) (r s). fold share in W2. unfold g'.
  assert (B1 := value_below_size (slow_w P) (h s) (r s) (h s) (r s) ltac:(lra) ltac:(lra)).
  assert (B2 := value_below_kept Z (h s) (r s) (r1 N) (Z_nonnegative M P K N source Z HN) ltac:(lra) ltac:(lra)).
  assert (Q : e <= h1 N * (p x s * sqrt (p x s))).
  { assert (D1 := proj1 (Hp s Hs)). assert (D2 := sqrt_lt_R0 _ D1).
    assert (D0 : 0 < p x s * sqrt (p x s)) by (apply Rmult_lt_0_compat; assumption).
    replace e with (h s * (p x s * sqrt (p x s))) by (unfold h, h_at; fold e; field; lra).
    apply Rmult_le_compat_r; lra. }
  assert (B3 := layer_falls (Gamma N) (theta N) (z0 N) (p1 N) (e0 N) (h1 N) e (p x s) fall Z0 Hth P1 Hh1'
    (conj E0 He0) HS (Hp s Hs) Q Hfall).
  fold (q s) in B3. fold (h s) (r s) in Hz. rewrite !Rabs_mult, Rabs_Ropp.
  rewrite (Rabs_pos_eq (h s)), (Rabs_pos_eq (r s)), (Rabs_pos_eq (beta_of M)) by lra.
  apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. apply Rmult_le_compat_l; [lra|].
  apply Rle_trans with (1 := Rabs_triang _ _). apply Rplus_le_compat; [exact B1|].
  apply Rle_trans with (1 := W2). apply Rmult_le_compat_l; [lra|]. unfold kZ. lra. }
assert (Mono : forall sg, sg = 1 \/ sg = -1 -> sg * lc t - G t <= sg * lc t0 - G t0).
{ intros sg Hsg.
  apply (decr_of_derive (fun s => sg * lc s - G s) (Derive (fun s => sg * lc s - G s)) t0 t ltac:(lra));
    intros s Hs; destruct (DC s ltac:(lra)) as (c' & Dc & Bc);
    assert (DM := rate_minus eps _ _ _ _ s He (rate_scal eps lc c' sg s He Dc) (DG s ltac:(lra))).
  - apply Derive_correct. eexists; exact DM.
  - apply is_derive_unique in DM. rewrite DM. apply Rabs_le_between in Bc.
    assert (0 <= - (sg * c' - g' s) * / eps).
    { apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat, He]. destruct Hsg as [-> | ->]; lra. }
    unfold Rdiv. lra. }
assert (M1 := Mono 1 (or_introl eq_refl)). assert (M2 := Mono (-1) (or_intror eq_refl)).
assert (F0 : 0 < / fall) by (apply Rinv_0_lt_compat, Hf).
assert (G0 : 0 <= G t0).
{ unfold G, q. rewrite Hp0, Rminus_eq_0, Rmult_0_r, Ropp_0, exp_0, !over_E_value.
  destruct (Hhr t0 ltac:(lra)) as [A A'].
  apply Rmult_le_pos; [lra|]. assert (I1 := integral_nonneg (slow_w P) (h t0) (r t0) Hw ltac:(lra) ltac:(lra)).
  assert (I2 := integral_nonneg kZ (h t0) (r t0) HkZ ltac:(lra) ltac:(lra)).
  assert (0 <= share * integral_at kZ (h t0) (r t0)) by (apply Rmult_le_pos; lra). lra. }
assert (G1 : G t <= beta_of M * (integral_at (slow_w P) (h1 N) (sqrt p_S)
  + share * (z0 N / fall + integral_at kZ (h1 N) (sqrt p_S)))).
{ unfold G. rewrite !over_E_value. destruct (Hhr t Ht) as [A A'].
  assert (Ee : h t * r t ^ 3 = e) by (unfold h, r; rewrite (h_value M eps x t (proj1 (Hp t Ht)));
    unfold e; field; unfold r in A'; lra).
  assert (I1 := integral_end (slow_w P) (e0 N) (h1 N) e (h t) (r t) Hw (conj E0 He0) A (proj1 A') Ee).
  assert (I2 := integral_end kZ (e0 N) (h1 N) e (h t) (r t) HkZ (conj E0 He0) A (proj1 A') Ee).
  assert (X : 0 <= z0 N / fall * exp (- (fall * q t))).
  { apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply Rlt_le, exp_pos]. }
  apply Rmult_le_compat_l; [lra|]. apply Rplus_le_compat; [exact I1|]. apply Rmult_le_compat_l; [lra|].
  apply Rplus_le_compat; [lra|exact I2]. }
fold (lc t) (lc t0). apply Rabs_le. lra.
Qed.
