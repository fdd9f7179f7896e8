(** * The compliant model: Theorem C with a polynomial part

    proofs/monotone.md, section 3, M = 1 and K_1 = 2: P = (eta/8) Theta^(4) - (eta^2/10) Theta^(5), for b < 6. With h = g + r^3/3, g the exponent of the weight, and
    p = eta r^4/8 - eta^2 r^5/10, h - p and e^h - 1 - h are positive and increase with eta, hence so does e^h - 1 - p = O(r^6). Where the
    integrals converge Gamma(-b) (G - Theta - P)^(n) is that integral; it is O(x^-(n-b+6)) at t = -x. The recurrence carries this to every n (what it leaves
    over is of this order), so the inequality goes down to n > b - 6 as in [LeftExpansion.v]. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus GammaFunction LaplaceIntegral ImproperIntegral Family Ends CompliantKernel CompliantIntegral
  CompliantSlow LeftExpansion CompliantMonotone.
Open Scope R_scope.

(** ** psi beyond its first two terms *)
Definition psi_rest (x : R) : R := psi x + 2 * x ^ 3 / 3 - x ^ 4 / 4 + x ^ 5 / 5.

Lemma psi_rest_0 : psi_rest 0 = 0.
Proof. unfold psi_rest. rewrite psi_0. field. Qed.

Lemma psi_rest_derive x : 0 <= x -> is_derive psi_rest x (x ^ 5 / (1 + x)).
Proof. intros Hx. unfold psi_rest, psi. auto_derive. repeat split; lra. field; lra. Qed.

Lemma psi_rest_bounds x : 0 < x -> 0 < psi_rest x <= x ^ 6 / 6.
Proof.
intros Hx. split.
- rewrite <- psi_rest_0. apply (incr_of_derive psi_rest (fun u => u ^ 5 / (1 + u))); auto.
  + intros u Hu. apply psi_rest_derive. lra.
  + intros u Hu. apply Rdiv_lt_0_compat; [apply pow_lt|]; lra.
- apply Rlt_le. assert (H : 0 ^ 6 / 6 - psi_rest 0 < x ^ 6 / 6 - psi_rest x).
  { apply (incr_of_derive (fun u => u ^ 6 / 6 - psi_rest u) (fun u => u ^ 6 / (1 + u))); auto.
    - intros u Hu. apply (is_derive_val _ _ (u ^ 5 - u ^ 5 / (1 + u))); [|field; lra].
      apply (is_derive_minus (fun u => u ^ 6 / 6) psi_rest); [auto_derive; auto; field|apply psi_rest_derive; lra].
    - intros u Hu. apply Rdiv_lt_0_compat; [apply pow_lt|]; lra. }
  rewrite psi_rest_0 in H. simpl in H |- *. lra.
Qed.

Lemma psi_rest_cube_increasing x y : 0 < x < y -> psi_rest x / x ^ 3 < psi_rest y / y ^ 3.
Proof.
intros Hx.
assert (Slope : forall u, 0 < u -> 0 < u * (u ^ 5 / (1 + u)) - 3 * psi_rest u).
{ intros u Hu. replace 0 with (0 * (0 ^ 5 / (1 + 0)) - 3 * psi_rest 0) by (rewrite psi_rest_0; field).
  apply (incr_of_derive (fun u => u * (u ^ 5 / (1 + u)) - 3 * psi_rest u) (fun u => u ^ 5 * (3 + 2 * u) / (1 + u) ^ 2)); auto.
  - intros v Hv. apply (is_derive_val _ _ ((6 * v ^ 5 * (1 + v) - v ^ 6) / (1 + v) ^ 2 - 3 * (v ^ 5 / (1 + v)))); [|field; lra].
    apply (is_derive_minus (fun u => u * (u ^ 5 / (1 + u))) (fun u => 3 * psi_rest u)).
    + auto_derive; [lra|field; lra].
    + apply (is_derive_scal psi_rest), psi_rest_derive. lra.
  - intros v Hv. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt|]; lra|apply pow_lt; lra]. }
apply (incr_of_derive (fun u => psi_rest u / u ^ 3) (fun u => (u * (u ^ 5 / (1 + u)) - 3 * psi_rest u) / u ^ 4)); [lra| |].
- intros u Hu. assert (D := psi_rest_derive u ltac:(lra)).
  apply (is_derive_val _ _ ((u ^ 5 / (1 + u) * u ^ 3 - psi_rest u * (3 * u ^ 2)) / (u ^ 3) ^ 2)); [|field; lra].
  apply (is_derive_div psi_rest (fun u => u ^ 3) u (u ^ 5 / (1 + u)) (3 * u ^ 2)); auto.
  + auto_derive; auto. ring.
  + apply Rgt_not_eq, pow_lt. lra.
- intros u Hu. apply Rdiv_lt_0_compat; [apply Slope; lra|apply pow_lt; lra].
Qed.

(** ** The weight beyond its polynomial part *)
Definition polynomial_part (eta r : R) : R := eta * r ^ 4 / 8 - eta ^ 2 * r ^ 5 / 10.
Definition excess_weight (eta r : R) : R := exp (weight_exponent eta r) - exp (- (r ^ 3 / 3)) * (1 + polynomial_part eta r).

Lemma exponent_rest eta r : 0 < eta -> 0 < r ->
  weight_exponent eta r + r ^ 3 / 3 - polynomial_part eta r = r ^ 3 / 2 * (psi_rest (eta * r) / (eta * r) ^ 3).
Proof. intros He Hr. unfold weight_exponent, polynomial_part, psi_rest. field. split; lra. Qed.

Lemma exponent_rest_bounds eta r : 0 < eta -> 0 < r ->
  0 < weight_exponent eta r + r ^ 3 / 3 - polynomial_part eta r <= eta ^ 3 * r ^ 6 / 12.
Proof.
intros He Hr. rewrite exponent_rest by auto. assert (Hx : 0 < eta * r) by (apply Rmult_lt_0_compat; auto).
destruct (psi_rest_bounds _ Hx) as [L U]. assert (X3 : 0 < (eta * r) ^ 3) by (apply pow_lt; auto). assert (R3 : 0 < r ^ 3) by (apply pow_lt; auto).
split.
- apply Rmult_lt_0_compat; [lra|]. apply Rdiv_lt_0_compat; auto.
- replace (eta ^ 3 * r ^ 6 / 12) with (r ^ 3 / 2 * ((eta * r) ^ 6 / 6 / (eta * r) ^ 3)) by (field; split; lra).
  apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, X3|exact U].
Qed.

Lemma excess_weight_factor eta r : excess_weight eta r
  = exp (- (r ^ 3 / 3)) * (exp (weight_exponent eta r + r ^ 3 / 3) - 1 - polynomial_part eta r).
Proof.
unfold excess_weight. replace (exp (weight_exponent eta r)) with (exp (- (r ^ 3 / 3)) * exp (weight_exponent eta r + r ^ 3 / 3)).
ring. rewrite <- exp_plus. f_equal. ring.
Qed.

Lemma excess_weight_increasing eta eta' r : 0 < eta < eta' -> 0 < r -> excess_weight eta r < excess_weight eta' r.
Proof.
intros He Hr. rewrite !excess_weight_factor. apply Rmult_lt_compat_l; [apply exp_pos|].
assert (W := weight_increasing eta eta' r He Hr). destruct (weight_bounds eta r ltac:(lra) Hr) as (B & _).
assert (Q : weight_exponent eta r + r ^ 3 / 3 - polynomial_part eta r < weight_exponent eta' r + r ^ 3 / 3 - polynomial_part eta' r).
{ rewrite !exponent_rest by lra. apply Rmult_lt_compat_l. apply Rdiv_lt_0_compat; [apply pow_lt|]; lra.
  apply psi_rest_cube_increasing. split; [apply Rmult_lt_0_compat; lra|apply Rmult_lt_compat_r; lra]. }
set (h := weight_exponent eta r + r ^ 3 / 3) in *. set (h' := weight_exponent eta' r + r ^ 3 / 3) in *.
assert (H : h < h') by (unfold h, h'; lra). assert (H0 : 0 < h) by (unfold h; lra).
assert (E : h' - h <= exp h' - exp h).
{ replace (exp h') with (exp h * exp (h' - h)) by (rewrite <- exp_plus; f_equal; ring).
  assert (A := exp_ineq1_le (h' - h)). assert (A' := exp_ineq1_le h).
  assert ((1 + h) * (1 + (h' - h)) <= exp h * exp (h' - h)) by (apply Rmult_le_compat; lra).
  assert (exp h * (1 + (h' - h)) <= exp h * exp (h' - h)) by (apply Rmult_le_compat_l; [apply Rlt_le, exp_pos|lra]).
  assert (0 <= (exp h - 1) * (h' - h)) by (apply Rmult_le_pos; lra). lra. }
lra.
Qed.

Lemma excess_weight_bounds eta r : 0 < eta -> 0 < r -> 0 < excess_weight eta r <= eta ^ 2 / 64 * r ^ 8 + eta ^ 3 / 12 * r ^ 6.
Proof.
intros He Hr. destruct (weight_bounds eta r He Hr) as (B1 & B2 & B3). destruct (exponent_rest_bounds eta r He Hr) as [L U].
rewrite excess_weight_factor. set (g := weight_exponent eta r) in *. set (h := g + r ^ 3 / 3) in *. set (p := polynomial_part eta r) in *.
assert (X := exp_pos (- (r ^ 3 / 3))). assert (R3 : 0 < r ^ 3) by (apply pow_lt, Hr).
assert (H0 : 0 < h) by (unfold h; lra).
assert (E1 := exp_ineq1_le h). assert (E2 := exp_ineq1_le (- h)).
assert (EE : exp h * exp (- h) = 1) by (rewrite <- exp_plus; replace (h + - h) with 0 by ring; apply exp_0).
assert (E3 : exp h - 1 <= h * exp h).
{ assert (exp h * (1 + - h) <= exp h * exp (- h)) by (apply Rmult_le_compat_l; [apply Rlt_le, exp_pos|lra]). lra. }
assert (E4 : exp h - 1 - h <= h ^ 2 * exp h).
{ assert (h * (exp h - 1) <= h * (h * exp h)) by (apply Rmult_le_compat_l; lra). simpl. lra. }
split; [apply Rmult_lt_0_compat; lra|].
assert (G : exp (- (r ^ 3 / 3)) * exp h = exp g) by (rewrite <- exp_plus; f_equal; unfold h; ring).
assert (G1 : exp g <= 1) by (rewrite <- exp_0; apply exp_le; lra).
assert (X1 : exp (- (r ^ 3 / 3)) <= 1) by (rewrite <- exp_0; apply exp_le; lra).
assert (H2 : h ^ 2 <= eta ^ 2 / 64 * r ^ 8).
{ replace (eta ^ 2 / 64 * r ^ 8) with ((eta * r ^ 4 / 8) ^ 2) by field. apply pow_incr. lra. }
assert (P2 : 0 <= h ^ 2) by apply pow2_ge_0.
apply Rle_trans with (h ^ 2 * exp g + exp (- (r ^ 3 / 3)) * (h - p)).
- rewrite <- G. assert (A := Rmult_le_compat_l _ _ _ (Rlt_le _ _ X) E4). lra.
- assert (A1 : h ^ 2 * exp g <= h ^ 2 * 1) by (apply Rmult_le_compat_l; auto).
  assert (A2 : exp (- (r ^ 3 / 3)) * (h - p) <= 1 * (h - p)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(** ** The excess of one family over the other *)
Definition excess (eta : R) (f g : nat -> R -> R) (k : nat) (t : R) : R :=
  g k t - f k t - eta / 8 * f (k + 4)%nat t + eta ^ 2 / 10 * f (k + 5)%nat t.

Section Excess.
Variables (s eta : R) (f g : nat -> R -> R).
Hypothesis Hs : ok s.
Hypothesis Hf : family 0 s f.
Hypothesis Hg : family eta s g.
Let E := excess eta f g.

Lemma excess_derive k t : is_derive (E k) t (E (S k) t).
Proof.
unfold E, excess. apply (is_derive_plus (fun t => g k t - f k t - eta / 8 * f (k + 4)%nat t) (fun t => eta ^ 2 / 10 * f (k + 5)%nat t)).
- apply (is_derive_minus (fun t => g k t - f k t) (fun t => eta / 8 * f (k + 4)%nat t)).
  + apply (is_derive_minus (g k) (f k)). apply Hg. apply Hf.
  + apply (is_derive_scal (f (k + 4)%nat)). apply Hf.
- apply (is_derive_scal (f (k + 5)%nat)). apply Hf.
Qed.

(** The recurrence, and what it leaves over. *)
Lemma excess_recurrence k t : let q := s + INR k in
  (q + 1) * E k t = - ((q + 2) * eta + t) * E (k + 1)%nat t - t * eta * E (k + 2)%nat t + E (k + 3)%nat t + eta / 2 * E (k + 4)%nat t
    - eta ^ 2 / 16 * f (k + 8)%nat t - eta ^ 3 / 2 * f (k + 6)%nat t + eta ^ 3 / 20 * f (k + 9)%nat t.
Proof.
intros q. destruct Hf as (_ & Rf & _). destruct Hg as (_ & Rg & _).
assert (G := Rg k t). cbv zeta in G. fold q in G.
assert (F : forall j i2 i3 : nat, i2 = (k + j + 1)%nat -> i3 = (k + j + 3)%nat -> (q + INR j + 1) * f (k + j)%nat t + t * f i2 t - f i3 t = 0).
{ intros j i2 i3 -> ->. assert (H := Rf (k + j)%nat t). cbv zeta in H. rewrite plus_INR in H. replace (s + (INR k + INR j)) with (q + INR j) in H by (unfold q; ring). lra. }
assert (F0 := F 0%nat (k + 1)%nat (k + 3)%nat ltac:(lia) ltac:(lia)). assert (F1 := F 1%nat (k + 2)%nat (k + 4)%nat ltac:(lia) ltac:(lia)).
assert (F4 := F 4%nat (k + 5)%nat (k + 7)%nat ltac:(lia) ltac:(lia)). assert (F5 := F 5%nat (k + 6)%nat (k + 8)%nat ltac:(lia) ltac:(lia)).
assert (F6 := F 6%nat (k + 7)%nat (k + 9)%nat ltac:(lia) ltac:(lia)). clear F.
rewrite Nat.add_0_r in F0. simpl INR in F0, F1, F4, F5, F6.
unfold E, excess.
replace (k + 1 + 4)%nat with (k + 5)%nat by lia. replace (k + 1 + 5)%nat with (k + 6)%nat by lia.
replace (k + 2 + 4)%nat with (k + 6)%nat by lia. replace (k + 2 + 5)%nat with (k + 7)%nat by lia.
replace (k + 3 + 4)%nat with (k + 7)%nat by lia. replace (k + 3 + 5)%nat with (k + 8)%nat by lia.
replace (k + 4 + 4)%nat with (k + 8)%nat by lia. replace (k + 4 + 5)%nat with (k + 9)%nat by lia.
set (f0 := f k t) in *. set (f1 := f (k + 1)%nat t) in *. set (f2 := f (k + 2)%nat t) in *. set (f3 := f (k + 3)%nat t) in *.
set (f4 := f (k + 4)%nat t) in *. set (f5 := f (k + 5)%nat t) in *. set (f6 := f (k + 6)%nat t) in *. set (f7 := f (k + 7)%nat t) in *.
set (f8 := f (k + 8)%nat t) in *. set (f9 := f (k + 9)%nat t) in *.
set (g0 := g k t) in *. set (g1 := g (k + 1)%nat t) in *. set (g2 := g (k + 2)%nat t) in *. set (g3 := g (k + 3)%nat t) in *. set (g4 := g (k + 4)%nat t) in *.
clearbody f0 f1 f2 f3 f4 f5 f6 f7 f8 f9 g0 g1 g2 g3 g4 q.
apply (Rmult_eq_compat_l eta) in F1. apply (Rmult_eq_compat_l eta) in F4.
apply (Rmult_eq_compat_l (eta ^ 2)) in F5. apply (Rmult_eq_compat_l (eta ^ 3)) in F6. lra.
Qed.

(** It is O(x^-(s+k+7)) for every k if it is where the integrals converge. *)
Hypothesis Hbase : forall k, -1 < s + INR k -> small (s + INR k + 7) (fun x => E k (- x)).

Lemma excess_small k : small (s + INR k + 7) (fun x => E k (- x)).
Proof.
assert (H : forall n k, -1 < s + INR k + INR n -> small (s + INR k + 7) (fun x => E k (- x))).
{ induction n as [|n IH]; intros j Hj.
  - apply Hbase. simpl in Hj. lra.
  - rewrite S_INR in Hj.
    assert (L : forall i, (1 <= i)%nat -> small (s + INR j + 7 + INR i) (fun x => E (j + i)%nat (- x))).
    { intros i Hi. replace (s + INR j + 7 + INR i) with (s + INR (j + i) + 7) by (rewrite plus_INR; ring).
      apply IH. rewrite plus_INR. apply (le_INR 1) in Hi. simpl in Hi. lra. }
    assert (Lf : forall i, (6 <= i)%nat -> small (s + INR j + 7) (fun x => f (j + i)%nat (- x))).
    { intros i Hi. apply (small_weaken _ (i - 6)). replace (s + INR j + 7 + INR (i - 6)) with (s + INR (j + i) + 1).
      apply (left_small s 0 f Hs Hf). rewrite minus_INR, plus_INR by auto. simpl. ring. }
    assert (E1 := L 1%nat (le_n _)). assert (E2 := L 2%nat ltac:(lia)). assert (E3 := small_weaken _ _ _ (L 3%nat ltac:(lia))).
    assert (E4 := small_weaken _ _ _ (L 4%nat ltac:(lia))).
    assert (X1 := small_mult _ 1 _ E1). assert (W1 := small_weaken _ _ _ E1).
    assert (X2 : small (s + INR j + 7) (fun x => x ^ 1 * E (j + 2)%nat (- x))).
    { apply small_mult. apply (small_weaken _ 1). replace (s + INR j + 7 + INR 1 + INR 1) with (s + INR j + 7 + INR 2) by (simpl; ring). exact E2. }
    set (q := s + INR j) in *. assert (Nq : q + 1 <> 0) by (intros Z; apply (ok_plus s j Hs 0%nat); simpl; fold q; lra).
    assert (S := small_scal _ (/ (q + 1)) _ (small_plus _ _ _
      (small_plus _ _ _ (small_plus _ _ _ (small_scal _ (- ((q + 2) * eta)) _ W1) X1) (small_plus _ _ _ (small_scal _ eta _ X2)
        (small_plus _ _ _ E3 (small_scal _ (eta / 2) _ E4))))
      (small_plus _ _ _ (small_scal _ (- (eta ^ 2 / 16)) _ (Lf 8%nat ltac:(lia)))
        (small_plus _ _ _ (small_scal _ (- (eta ^ 3 / 2)) _ (Lf 6%nat ltac:(lia))) (small_scal _ (eta ^ 3 / 20) _ (Lf 9%nat ltac:(lia))))))).
    eapply small_ext; [|exact S]. intros x Hx. cbv beta.
    assert (R := excess_recurrence j (- x)). cbv zeta in R. fold q in R.
    apply (Rmult_eq_reg_l (q + 1)); auto. rewrite R, <- Rmult_assoc, Rinv_r by auto. simpl pow. ring. }
destruct (ex_valid (s + INR k)) as [n Hn]. apply (H n k Hn).
Qed.

Theorem excess_positive : (forall k t, -1 < s + INR k -> 0 < E k t) -> forall k t, -7 < s + INR k -> 0 < E k t.
Proof.
intros H. apply (chain_positive s (-7) E excess_derive); auto.
intros k _. replace (s + INR k - -7) with (s + INR k + 7) by ring. apply excess_small.
Qed.
End Excess.

(** ** Theorem C, b < 6 *)
Section Next.
Variables (b : R) (theta : R -> R).
Hypothesis Hb : not_nat b.
Hypothesis HT : is_Theta b theta.
Let s : R := - b - 1.

Lemma theta_integral k t : -1 < s + INR k ->
  is_RInt_gen (fun r => Rpower r (s + INR k) * exp (- (r ^ 3 / 3) + r * t)) (at_right 0) (Rbar_locally p_infty) (scaled b theta k t).
Proof.
intros Hk. unfold s in Hk. assert (H := Theta_representation b theta k Hb ltac:(lra) HT t).
eapply improper_ext; [|exact H]. intros r Hr. simpl.
replace (INR k - b - 1) with (s + INR k) by (unfold s; ring). f_equal. f_equal. unfold Rminus; ring.
Qed.

Lemma excess_integral eta k t : 0 < eta -> -1 < s + INR k ->
  is_RInt_gen (fun r => Rpower r (s + INR k) * (excess_weight eta r * exp (r * t))) (at_right 0) (Rbar_locally p_infty)
    (excess eta (scaled b theta) (scaled_J eta s) k t).
Proof.
intros He Hk.
assert (K4 : -1 < s + INR (k + 4)) by (rewrite plus_INR; simpl; lra). assert (K5 : -1 < s + INR (k + 5)) by (rewrite plus_INR; simpl; lra).
assert (P := is_RInt_gen_plus _ _ _ _ (is_RInt_gen_minus _ _ _ _ (is_RInt_gen_minus _ _ _ _ (scaled_J_integral eta He s k t Hk) (theta_integral k t Hk))
  (is_RInt_gen_scal _ (eta / 8) _ (theta_integral (k + 4) t K4))) (is_RInt_gen_scal _ (eta ^ 2 / 10) _ (theta_integral (k + 5) t K5))).
eapply improper_ext; [|exact P]. intros r Hr. unfold plus, minus, plus, opp, scal; simpl; unfold mult; simpl.
rewrite (Rpower_split r (s + INR (k + 4)) 4 (s + INR k)), (Rpower_split r (s + INR (k + 5)) 5 (s + INR k)) by (auto; rewrite plus_INR; simpl; ring).
rewrite !exp_plus. unfold excess_weight, polynomial_part. simpl. field.
Qed.

Lemma excess_continuous eta q t r : 0 < eta -> 0 < r -> continuous (fun r => Rpower r q * (excess_weight eta r * exp (r * t))) r.
Proof.
intros He Hr. apply (ex_derive_continuous (fun r => Rpower r q * (excess_weight eta r * exp (r * t))) r).
unfold excess_weight, polynomial_part, weight_exponent, psi, Rpower. assert (0 < eta * r) by (apply Rmult_lt_0_compat; auto). auto_derive.
repeat split; lra.
Qed.

Lemma excess_base eta : 0 < eta -> forall k, -1 < s + INR k -> small (s + INR k + 7) (fun x => excess eta (scaled b theta) (scaled_J eta s) k (- x)).
Proof.
intros He k Hk. set (q := s + INR k) in *. exists (eta ^ 2 / 64 * Gamma (q + 9) + eta ^ 3 / 12 * Gamma (q + 7)). intros x Hx.
assert (Hx0 : 0 < x) by lra. assert (I := excess_integral eta k (- x) He Hk). fold q in I.
assert (G9 := Gamma_scaled (q + 9) x ltac:(lra) Hx0). assert (G7 := Gamma_scaled (q + 7) x ltac:(lra) Hx0).
replace (q + 9 - 1) with (q + 8) in G9 by ring. replace (q + 7 - 1) with (q + 6) in G7 by ring.
assert (P := is_RInt_gen_minus _ _ _ _ (is_RInt_gen_plus _ _ _ _ (is_RInt_gen_scal _ (eta ^ 2 / 64) _ G9) (is_RInt_gen_scal _ (eta ^ 3 / 12) _ G7)) I).
apply improper_pos in P.
2: { intros r Hr. unfold scal, minus, plus, opp; simpl; unfold mult; simpl. destruct (excess_weight_bounds eta r He Hr) as [_ U].
  rewrite (Rpower_split r (q + 8) 8 q), (Rpower_split r (q + 6) 6 q) by (auto; simpl; ring).
  replace (r * - x) with (- (x * r)) by ring. set (X := exp (- (x * r))). assert (HX : 0 < X) by apply exp_pos.
  set (Q := Rpower r q). assert (HQ : 0 < Q) by apply exp_pos. assert (HQX : 0 < Q * X) by (apply Rmult_lt_0_compat; auto).
  assert (A := Rmult_le_compat_l _ _ _ (Rlt_le _ _ HQX) U). simpl in A |- *. lra. }
apply improper_pos in I.
2: { intros r Hr. destruct (excess_weight_bounds eta r He Hr) as [L _].
  apply Rlt_le, Rmult_lt_0_compat; [apply exp_pos|]. apply Rmult_lt_0_compat; auto. apply exp_pos. }
unfold scal, minus, plus, opp in P; simpl in P; unfold mult in P; simpl in P.
rewrite Rabs_pos_eq by auto.
assert (E7 : Rpower x (- (q + 7)) = x ^ 2 * Rpower x (- (q + 9))) by (apply Rpower_split; [auto|simpl; ring]).
assert (P9 : Rpower x (- (q + 9)) <= Rpower x (- (q + 7))).
{ rewrite E7. rewrite <- (Rmult_1_l (Rpower x (- (q + 9)))) at 1. apply Rmult_le_compat_r. apply Rlt_le, exp_pos. nra. }
assert (G : 0 < Gamma (q + 9)) by (apply Gamma_pos; lra). assert (C : 0 < eta ^ 2 / 64) by (apply Rdiv_lt_0_compat; [apply pow_lt|]; lra).
assert (A : eta ^ 2 / 64 * (Rpower x (- (q + 9)) * Gamma (q + 9)) <= eta ^ 2 / 64 * (Rpower x (- (q + 7)) * Gamma (q + 9))).
{ apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; lra. }
simpl in A. lra.
Qed.

Lemma excess_small_all eta : 0 < eta -> forall k, small (s + INR k + 7) (fun x => excess eta (scaled b theta) (scaled_J eta s) k (- x)).
Proof.
intros He. apply (excess_small s eta (scaled b theta) (scaled_J eta s) (ok_not_nat b Hb) (scaled_family b theta Hb HT)
  (scaled_J_family eta He s (ok_not_nat b Hb)) (excess_base eta He)).
Qed.

Theorem excess_above eta n t : b < INR n + 6 -> 0 < eta -> 0 < excess eta (scaled b theta) (scaled_J eta s) n t.
Proof.
intros Hn He. apply (excess_positive s eta (scaled b theta) (scaled_J eta s) (ok_not_nat b Hb) (scaled_family b theta Hb HT)
  (scaled_J_family eta He s (ok_not_nat b Hb)) (excess_base eta He)); [|unfold s; lra].
intros k u Hk. eapply improper_positive; [| |exact (excess_integral eta k u He Hk)].
- intros r Hr. destruct (excess_weight_bounds eta r He Hr) as [L _].
  apply Rmult_lt_0_compat; [apply exp_pos|]. apply Rmult_lt_0_compat; auto. apply exp_pos.
- intros r Hr. apply excess_continuous; auto.
Qed.

Theorem excess_increases eta eta' n t : b < INR n + 6 -> 0 < eta < eta' ->
  excess eta (scaled b theta) (scaled_J eta s) n t < excess eta' (scaled b theta) (scaled_J eta' s) n t.
Proof.
intros Hn He. set (D := fun k t => excess eta' (scaled b theta) (scaled_J eta' s) k t - excess eta (scaled b theta) (scaled_J eta s) k t).
enough (0 < D n t) by (unfold D in *; lra).
apply (chain_positive s (-7) D); [| | |unfold s; lra].
- intros k u. apply (is_derive_minus (excess eta' (scaled b theta) (scaled_J eta' s) k) (excess eta (scaled b theta) (scaled_J eta s) k)).
  + apply (excess_derive s eta'); [apply scaled_family; auto|apply scaled_J_family; [lra|apply ok_not_nat, Hb]].
  + apply (excess_derive s eta); [apply scaled_family; auto|apply scaled_J_family; [lra|apply ok_not_nat, Hb]].
- intros k _. replace (s + INR k - -7) with (s + INR k + 7) by ring. apply small_minus; apply excess_small_all; lra.
- intros k u Hk. enough (excess eta (scaled b theta) (scaled_J eta s) k u < excess eta' (scaled b theta) (scaled_J eta' s) k u) by (unfold D; lra).
  eapply improper_lt; [| | |apply excess_integral; [lra|exact Hk]|apply excess_integral; [lra|exact Hk]].
  + intros r Hr. apply Rmult_lt_compat_l; [apply exp_pos|]. apply Rmult_lt_compat_r; [apply exp_pos|]. apply excess_weight_increasing; auto.
  + intros r Hr. apply excess_continuous; lra.
  + intros r Hr. apply excess_continuous; lra.
Qed.
End Next.
