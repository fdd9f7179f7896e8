(** * The powers of h and the partial sums of their series: lower bounds that increase with eta

    proofs/monotone.md, section 3, the lemma. At the scale eta = 1 let rest(m, L) = h^m/m! - (the L terms k < L of its
    series). By h' = x^3/(2 (1 + x)) and the recurrence of the coefficients x (1 + x) rest(m + 1, l + 1)' = (x^4/2)
    rest(m, l) - (l + 3m + 3) c_(l,m+1) x^(l+3m+4), and U = x rest' - 3m rest has a derivative of the same kind. So by
    induction on m (-1)^(L-m) rest(m, L) >= 0 and (-1)^(L-m) rest(m, L)/x^(3m) does not decrease. At the scale eta
    h^m/m! less its partial sum is r^(3m) times that at x = eta r. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus EnvelopingSeries CompliantKernel CompliantMonotone
  EtaSeries.
Open Scope R_scope.

Definition partial_power (m L : nat) (x : nat -> R) : R := sum_first (fun k =>
  series_coefficient k m * x (k + 3 * m)%nat) L.

Lemma partial_power_operator m l x :
  partial_power (S m) (S l) (fun i => INR i * (x i + x (i + 1)%nat))
    = / 2 * partial_power m l (fun i => x (i + 4)%nat)
      + INR (l + 3 * S m) * series_coefficient l (S m) * x (l + 3 * S m + 1)%nat.
Proof.
unfold partial_power. induction l as [|l IH].
- cbn [sum_first]. rewrite (coefficient_beyond 0 (S m)) by lia. ring.
- change (sum_first ?a (S (S l))) with (sum_first a (S l) + a (S l)). rewrite IH.
  change (sum_first ?a (S l)) with (sum_first a l + a l). cbv beta.
  assert (C := coefficient_next l m).
  replace (INR (S l + 3 * S m)) with (INR (S l) + 3 * INR (S m)) by (rewrite plus_INR, mult_INR; simpl (INR 3); ring).
  replace (INR (l + 3 * S m)) with (INR l + 3 * INR (S m)) by (rewrite plus_INR, mult_INR; simpl (INR 3); ring).
  replace (l + 3 * S m + 1)%nat with (S l + 3 * S m)%nat by lia.
  replace (l + 3 * m + 4)%nat with (S l + 3 * S m)%nat by lia.
  apply (Rmult_eq_compat_r (x (S l + 3 * S m)%nat)) in C. 
  transitivity (/ 2 * sum_first (fun k => series_coefficient k m * x (k + 3 * m + 4)%nat) l
    + (INR l + 3 * INR (S m)) * series_coefficient l (S m) * x (S l + 3 * S m)%nat
    + (INR (S l) + 3 * INR (S m)) * series_coefficient (S l) (S m) * x (S l + 3 * S m)%nat
    + (INR (S l) + 3 * INR (S m)) * series_coefficient (S l) (S m) * x (S l + 3 * S m + 1)%nat); [ring|].
  rewrite C. field.
Qed.

Lemma partial_power_scal m L q x : partial_power m L (fun i => q * x i) = q * partial_power m L x.
Proof. unfold partial_power. rewrite <- sum_first_scal. apply sum_first_ext. intros; ring. Qed.

Lemma partial_power_ext m L x y : (forall i, x i = y i) -> partial_power m L x = partial_power m L y.
Proof. intros H. apply sum_first_ext. intros k. rewrite H. reflexivity. Qed.

(** The exponent at the scale 1, and the rest *)
Definition unit_exponent (x : R) : R := exponent 1 x.

Lemma unit_exponent_derive x : 0 <= x -> is_derive unit_exponent x (x ^ 3 / (2 * (1 + x))).
Proof. intros Hx. eapply is_derive_val; [apply exponent_derive; lra|]. field. lra. Qed.

Lemma unit_exponent_0 : unit_exponent 0 = 0.
Proof. apply exponent_0. lra. Qed.

Lemma unit_exponent_nonnegative x : 0 <= x -> 0 <= unit_exponent x.
Proof. intros [Hx|<-]; [apply Rlt_le, exponent_bounds; lra|rewrite unit_exponent_0; lra]. Qed.

Definition power_rest (m L : nat) (x : R) : R := unit_exponent x ^ m / INR (fact m) - partial_power m L (fun i =>
  x ^ i).

Definition power_rest_derivative (m L : nat) (x : R) : R :=
  match m with O => 0 | S j => unit_exponent x ^ j / INR (fact j) * (x ^ 3 / (2 * (1 + x))) end - partial_power m L
    (power_derive x).

Lemma power_rest_derive m L x : 0 <= x -> is_derive (power_rest m L) x (power_rest_derivative m L x).
Proof.
intros Hx. unfold power_rest, power_rest_derivative.
apply (is_derive_minus (fun x => unit_exponent x ^ m / INR (fact m)) (fun x => partial_power m L (fun i => x ^ i))).
- destruct m as [|j].
  + simpl. apply (is_derive_const (1 / 1)).
  + assert (D := unit_exponent_derive x Hx). set (d := x ^ 3 / (2 * (1 + x))) in *.
    assert (P := is_derive_pow unit_exponent (S j) x d D). apply (is_derive_scal _ _ (/ INR (fact (S j)))) in P.
    eapply is_derive_ext; [|eapply is_derive_val; [exact P|]].
    * intros u. unfold scal; simpl; unfold mult; simpl. unfold Rdiv. ring.
    * change (fact (S j)) with (S j * fact j)%nat. rewrite mult_INR. simpl pred. field.
      split; [apply INR_fact_neq_0|apply not_0_INR; lia].
- apply (sum_first_derive (fun k x => series_coefficient k m * x ^ (k + 3 * m)) (fun k =>
    series_coefficient k m * power_derive x (k + 3 * m))).
  intros k. apply (is_derive_scal (fun x => x ^ (k + 3 * m))), power_is_derive.
Qed.

Lemma power_rest_equation m l x : 0 < x ->
  power_rest_derivative (S m) (S l) x = (x ^ 3 / 2 * power_rest m l x - INR (l + 3 * S m) * series_coefficient l
    (S m) * x ^ (l + 3 * S m)) / (1 + x).
Proof.
intros Hx. assert (O := partial_power_operator m l (fun i => x ^ i)). cbv beta in O.
rewrite (partial_power_ext (S m) _ _ (fun i => x * (1 + x) * power_derive x i)) in O.
2: { intros i. rewrite Rmult_assoc, (Rmult_comm (1 + x)), <- Rmult_assoc, times_power_derive, pow_add. simpl. ring. }
rewrite (partial_power_ext m _ (fun i => x ^ (i + 4)) (fun i => x ^ 4 * x ^ i)) in O by (intros; rewrite pow_add; ring).
rewrite !partial_power_scal, pow_add in O. unfold power_rest_derivative, power_rest.
set (P := partial_power (S m) (S l) (power_derive x)) in *. set (p := partial_power m l (fun i => x ^ i)) in *.
set (H := unit_exponent x ^ m / INR (fact m)). set (C := INR (l + 3 * S m) * series_coefficient l (S m)) in *.
set (Y := x ^ (l + 3 * S m)) in *.
apply (Rmult_eq_reg_l (x * (1 + x))). 2: { apply Rgt_not_eq, Rmult_lt_0_compat; lra. }
replace (x * (1 + x) * (H * (x ^ 3 / (2 * (1 + x))) - P)) with (x ^ 4 / 2 * H - x * (1 + x) * P) by (field; lra).
rewrite O. field. lra.
Qed.

Lemma power_rest_at_0 m L : power_rest (S m) L 0 = 0.
Proof.
unfold power_rest, partial_power.
rewrite unit_exponent_0, (sum_first_zero (fun k => series_coefficient k (S m) * 0 ^ (k + 3 * S m))).
- simpl. unfold Rdiv. ring.
- intros k. rewrite pow_i by lia. ring.
Qed.

Lemma power_rest_0 l x : power_rest 0 (S l) x = 0.
Proof.
unfold power_rest, partial_power. rewrite sum_first_head, (sum_first_zero (fun k => series_coefficient (S k) 0 * _)).
- unfold series_coefficient. simpl. field.
- intros k. rewrite coefficient_0. ring.
Qed.

Lemma power_rest_derivative_0 L x : power_rest_derivative 0 L x = 0.
Proof.
unfold power_rest_derivative, partial_power. rewrite sum_first_zero; [ring|]. intros [|k].
- unfold power_derive. simpl. ring.
- rewrite coefficient_0. ring.
Qed.

(** The last coefficient has the sign that both inductions need. *)
Lemma last_coefficient_sign m i : (-1) ^ i * series_coefficient (m + i) (S m) <= 0.
Proof.
assert (A := coefficient_sign (m + i) (S m)).
replace ((-1) ^ (m + i + S m)) with (- (-1) ^ i) in A; [lra|].
replace (m + i + S m)%nat with (2 * m + (i + 1))%nat by lia. rewrite !pow_add, pow_mult.
replace ((-1) ^ 2) with 1 by ring. rewrite pow1. ring.
Qed.

Theorem power_rest_sign m : forall i x, 0 <= x -> 0 <= (-1) ^ i * power_rest m (m + i) x.
Proof.
induction m as [|m IH]; intros i x Hx.
- destruct i as [|i].
  + unfold power_rest, partial_power. simpl. lra.
  + simpl (0 + S i)%nat. rewrite power_rest_0. lra.
- replace (S m + i)%nat with (S (m + i)) by lia.
  apply (nonnegative_of_derive (fun x => (-1) ^ i * power_rest (S m) (S (m + i)) x) (fun x =>
    (-1) ^ i * power_rest_derivative (S m) (S (m + i)) x) 0 x Hx).
  + intros u Hu. apply (is_derive_scal (power_rest (S m) (S (m + i)))), power_rest_derive. lra.
  + intros u Hu. rewrite power_rest_equation by lra. assert (A := IH i u ltac:(lra)).
    assert (C := last_coefficient_sign m i).
    set (p := (m + i + 3 * S m)%nat). assert (Q := pos_INR p). assert (Y : 0 < u ^ p) by (apply pow_lt; lra).
    assert (U3 : 0 < u ^ 3) by (apply pow_lt; lra).
    replace ((-1) ^ i * ((u ^ 3 / 2 * power_rest m (m + i) u - INR p * series_coefficient (m + i) (S m) * u ^ p)
      / (1 + u)))
      with ((u ^ 3 / 2 * ((-1) ^ i * power_rest m (m + i) u) + INR p * - ((-1) ^ i * series_coefficient (m + i) (S m))
        * u ^ p) * / (1 + u)) by (field; lra).
    apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat; lra]. apply Rplus_le_le_0_compat; [apply Rmult_le_pos; lra|].
    apply Rmult_le_pos; [apply Rmult_le_pos|]; lra.
  + rewrite power_rest_at_0. lra.
Qed.

(** x rest' - 3m rest *)
Definition power_slope (m L : nat) (x : R) : R := x * power_rest_derivative m L x - 3 * INR m * power_rest m L x.

Theorem power_slope_sign m : forall i x, 0 < x -> 0 <= (-1) ^ i * power_slope m (m + i) x.
Proof.
induction m as [|m IH]; intros i x Hx.
- unfold power_slope. rewrite power_rest_derivative_0. simpl (INR 0). lra.
- replace (S m + i)%nat with (S (m + i)) by lia. set (l := (m + i)%nat).
  set (p := (l + 3 * S m)%nat). set (c := INR p * series_coefficient l (S m)).
  set (U := fun x => (x ^ 4 / 2 * power_rest m l x - c * x ^ S p) * / (1 + x) - 3 * INR (S m) * power_rest (S m) (S l)
    x).
  assert (EU : power_slope (S m) (S l) x = U x).
  { unfold power_slope, U. rewrite power_rest_equation by auto. fold p. fold c. change (x ^ S p) with (x * x ^ p).
    field. lra. }
  rewrite EU.
  set (U' := fun x =>
    ((4 * x ^ 3 / 2 * power_rest m l x + x ^ 4 / 2 * power_rest_derivative m l x - c * (INR (S p) * x ^ p)) * / (1 + x)
    + (x ^ 4 / 2 * power_rest m l x - c * x ^ S p) * (- 1 / (1 + x) ^ 2)) - 3 * INR (S m) * power_rest_derivative (S m)
        (S l) x).
  apply (nonnegative_of_derive (fun x => (-1) ^ i * U x) (fun x => (-1) ^ i * U' x) 0 x); [lra| | |].
  + intros u Hu. apply (is_derive_scal U). unfold U, U'.
    apply (is_derive_minus (fun x => (x ^ 4 / 2 * power_rest m l x - c * x ^ S p) * / (1 + x)) (fun x =>
      3 * INR (S m) * power_rest (S m) (S l) x)).
    * apply (is_derive_mult_R (fun x => x ^ 4 / 2 * power_rest m l x - c * x ^ S p) (fun x => / (1 + x))).
      -- apply (is_derive_minus (fun x => x ^ 4 / 2 * power_rest m l x) (fun x => c * x ^ S p)).
         ++ apply (is_derive_mult_R (fun x => x ^ 4 / 2) (power_rest m l));
              [auto_derive; auto; field|apply power_rest_derive; lra].
         ++ apply (is_derive_scal (fun x => x ^ S p)). eapply is_derive_val; [apply power_is_derive|]. reflexivity.
      -- auto_derive; [lra|]. field. lra.
    * apply (is_derive_scal (power_rest (S m) (S l))), power_rest_derive. lra.
  + intros u Hu. unfold U'. rewrite power_rest_equation by lra. fold p. fold c.
    assert (S1 : 0 <= (-1) ^ i * power_slope m l u) by (apply IH; lra).
    assert (S0 : 0 <= (-1) ^ i * power_rest m l u) by (apply power_rest_sign; lra).
    assert (C : 0 <= - ((-1) ^ i * c)).
    { unfold c. assert (C := last_coefficient_sign m i). fold l in C.
      replace (- ((-1) ^ i * (INR p * series_coefficient l (S m))))
        with (INR p * - ((-1) ^ i * series_coefficient l (S m))) by ring.
      apply Rmult_le_pos; [apply pos_INR|lra]. }
    assert (Y : 0 < u ^ p) by (apply pow_lt; lra). assert (U3 : 0 < u ^ 3) by (apply pow_lt; lra).
    assert (Ql := pos_INR l).
    set (Up := ((4 * u ^ 3 / 2 * power_rest m l u + u ^ 4 / 2 * power_rest_derivative m l u - c * (INR (S p) * u ^ p))
      * / (1 + u)
      + (u ^ 4 / 2 * power_rest m l u - c * u ^ S p) * (- 1 / (1 + u) ^ 2)) - 3 * INR
          (S m) * ((u ^ 3 / 2 * power_rest m l u - c * u ^ p) / (1 + u))).
    assert (EP : Up = u ^ 3 / 2 * / (1 + u) * power_slope m l u + u ^ 3 / 2 * (/ (1 + u)) ^ 2 * power_rest m l u
      - c * (u ^ p * (/ (1 + u)) ^ 2 * (INR l + 1 + INR l * u))).
    { unfold Up, power_slope. rewrite (S_INR p), (S_INR m). replace (INR p) with (INR l + 3 * INR m + 3).
      2: { unfold p. rewrite plus_INR, mult_INR, (S_INR m). simpl (INR 3). ring. }
      change (u ^ S p) with (u * u ^ p). field. lra. }
    rewrite EP.
    replace ((-1) ^ i * (u ^ 3 / 2 * / (1 + u) * power_slope m l u + u ^ 3 / 2 * (/ (1 + u)) ^ 2 * power_rest m l u
        - c * (u ^ p * (/ (1 + u)) ^ 2 * (INR l + 1 + INR l * u))))
      with (u ^ 3 / 2 * / (1 + u) * ((-1) ^ i * power_slope m l u) + u ^ 3 / 2 * (/ (1 + u)) ^ 2
        * ((-1) ^ i * power_rest m l u)
        + - ((-1) ^ i * c) * (u ^ p * (/ (1 + u)) ^ 2 * (INR l + 1 + INR l * u))) by ring.
    assert (I1 : 0 < / (1 + u)) by (apply Rinv_0_lt_compat; lra).
    assert (I2 : 0 < (/ (1 + u)) ^ 2) by (apply pow_lt; auto).
    assert (V1 : 0 <= u ^ 3 / 2 * / (1 + u)) by (apply Rmult_le_pos; lra).
    assert (V2 : 0 <= u ^ 3 / 2 * (/ (1 + u)) ^ 2) by (apply Rmult_le_pos; lra).
    assert (V3 : 0 <= INR l + 1 + INR l * u) by (assert (0 <= INR l * u) by (apply Rmult_le_pos; lra); lra).
    assert (V4 : 0 <= u ^ p * (/ (1 + u)) ^ 2 * (INR l + 1 + INR l * u)) by (apply Rmult_le_pos; [apply Rmult_le_pos|];
      lra).
    apply Rplus_le_le_0_compat; [apply Rplus_le_le_0_compat|]; apply Rmult_le_pos; auto.
  + unfold U. rewrite power_rest_at_0. simpl. lra.
Qed.

Theorem power_rest_increases m i x y : 0 < x < y -> (-1) ^ i * (power_rest m (m + i) x / x ^ (3 * m))
  <= (-1) ^ i * (power_rest m (m + i) y / y ^ (3 * m)).
Proof.
intros Hxy.
set (F := fun x => (-1) ^ i * (power_rest m (m + i) x * / x ^ (3 * m))).
enough (0 <= F y - F x) by (unfold F, Rdiv in *; lra).
apply (nonnegative_of_derive (fun z => F z - F x) (fun z => (-1) ^ i * (power_slope m (m + i) z * / (z * z ^ (3 * m)))
  - 0) x y); [lra| | |lra].
- intros u Hu. apply (is_derive_minus F (fun _ => F x)); [|apply (is_derive_const (F x))].
  apply (is_derive_scal (fun x => power_rest m (m + i) x * / x ^ (3 * m))).
  assert (P : u ^ (3 * m) <> 0) by (apply pow_nonzero; lra).
  eapply is_derive_val.
  + apply (is_derive_mult_R (power_rest m (m + i)) (fun x => / x ^ (3 * m))). apply power_rest_derive; lra.
    apply (is_derive_inv (fun x => x ^ (3 * m)) u (power_derive u (3 * m))); auto. apply power_is_derive.
  + unfold power_slope. assert (T := times_power_derive u (3 * m)).
    replace (INR (3 * m)) with (3 * INR m) in T by (rewrite mult_INR; simpl (INR 3); ring).
    apply (Rmult_eq_reg_l u); [|lra].
    transitivity ((u * power_rest_derivative m (m + i) u - power_rest m (m + i) u * (u * power_derive u (3 * m))
      / u ^ (3 * m)) / u ^ (3 * m)); [field; auto|].
    rewrite T. field. repeat split; auto; lra.
- intros u Hu. assert (A := power_slope_sign m i u ltac:(lra)).
  assert (P : 0 < u * u ^ (3 * m)) by (apply Rmult_lt_0_compat; [|apply pow_lt]; lra).
  apply Rinv_0_lt_compat in P. rewrite <- Rmult_assoc, Rminus_0_r. apply Rmult_le_pos; lra.
Qed.

(** ** e^u less the first n terms of its series *)
Definition exp_beyond (n : nat) (u : R) : R := exp u - sum_first (fun m => u ^ m / INR (fact m)) n.

Lemma exp_beyond_derive n u : is_derive (exp_beyond (S n)) u (exp_beyond n u).
Proof.
unfold exp_beyond. apply (is_derive_minus exp (fun u => sum_first (fun m => u ^ m / INR (fact m)) (S n))).
apply is_derive_exp.
apply (is_derive_ext (fun u => 1 + sum_first (fun m => u ^ S m / INR (fact (S m))) n)).
{ intros v. rewrite sum_first_head. simpl. field. }
eapply is_derive_val; [apply (is_derive_plus (fun _ => 1) (fun u => sum_first (fun m => u ^ S m / INR (fact (S m))) n));
  [apply (is_derive_const 1)|]|].
- apply (sum_first_derive (fun m u => u ^ S m / INR (fact (S m))) (fun m => u ^ m / INR (fact m))). intros m.
  eapply is_derive_val; [apply (is_derive_scal_l (fun u => u ^ S m) u (power_derive u (S m)) (/ INR (fact (S m)))),
    power_is_derive|].
  unfold power_derive, scal; simpl; unfold mult; simpl. change (fact m + m * fact m)%nat with (S m * fact m)%nat.
  rewrite mult_INR.
  change (match m with 0%nat => 1 | S _ => INR m + 1 end) with (INR (S m)).
  field. split; [apply INR_fact_neq_0|apply not_0_INR; lia].
- unfold plus, zero; simpl. ring.
Qed.

Lemma exp_beyond_0 n : exp_beyond (S n) 0 = 0.
Proof.
unfold exp_beyond. rewrite exp_0, sum_first_head, (sum_first_zero (fun k => 0 ^ S k / _)).
- simpl. field.
- intros k. simpl. unfold Rdiv. ring.
Qed.

Lemma exp_beyond_positive n : forall u, 0 < u -> 0 < exp_beyond n u.
Proof.
induction n as [|n IH]; intros u Hu.
- unfold exp_beyond. simpl. assert (A := exp_pos u). lra.
- rewrite <- (exp_beyond_0 n). apply (incr_of_derive (exp_beyond (S n)) (exp_beyond n)); auto.
  + intros; apply exp_beyond_derive.
  + intros v Hv. apply IH. lra.
Qed.

Lemma exp_beyond_increases n u v : 0 <= u < v -> exp_beyond (S n) u < exp_beyond (S n) v.
Proof.
intros Huv. apply (incr_of_derive (exp_beyond (S n)) (exp_beyond n)); [lra| |].
- intros; apply exp_beyond_derive.
- intros w Hw. apply exp_beyond_positive. lra.
Qed.
