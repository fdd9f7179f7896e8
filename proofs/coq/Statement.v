(** * What is proved: definitions and statements

    This file holds no proof. It defines the words and states the theorems; [Theorems.v] proves each statement under
    the same name. Who wants to know what is proved reads this file alone. It stands on Coq's real numbers and on
    Coquelicot: [RInt_gen] (improper Riemann integral), [is_derive], [Derive_n] and [ex_derive_n] (derivatives),
    [is_lim] and [filterlim] (limits), [PSeries] (power series).

    The paper writes tau for t and beta for b; ' is d/dtau. Labels such as t01 are those of the paper. *)

From Coq Require Import Reals List Sorted.
From Coquelicot Require Import Coquelicot.
Import ListNotations.
Open Scope R_scope.

(** ** The function Theta *)

(** Gamma: Euler's integral for x > 0, and Gamma(x) = Gamma(x + 1)/x for x <= 0.
    At the poles 0, -1, -2, ... the value is a division by 0 and means nothing. *)
Definition GammaInt (x : R) : R :=
  RInt_gen (fun t => Rpower t (x - 1) * exp (- t)) (at_right 0) (Rbar_locally p_infty).

Fixpoint Gamma_aux (n : nat) (x : R) : R :=
  match n with
  | O => GammaInt x
  | S n => Gamma_aux n (x + 1) / x
  end.

Definition Gamma (x : R) : R := Gamma_aux (Z.to_nat (up (- x))) x.

(** 1/Gamma without poles: 1/Gamma(x) = x (1/Gamma(x + 1)) for x <= 0. *)
Fixpoint recip_Gamma_aux (n : nat) (x : R) : R :=
  match n with
  | O => / GammaInt x
  | S n => x * recip_Gamma_aux n (x + 1)
  end.

Definition recip_Gamma (x : R) : R := recip_Gamma_aux (Z.to_nat (up (- x))) x.

(** b is none of 0, 1, 2, ..., the poles of Gamma(-b). *)
Definition not_nat (b : R) : Prop := forall n : nat, b <> INR n.

(** theta is Theta(., b): it is three times differentiable on R, solves theta''' - t theta' + b theta = 0, and has the
    initial values t01, t02, t03. (In Coquelicot [ex_derive_n theta k] says that the (k-1)-st derivative, as a total
    function, can be differentiated: hence all k <= 3.) *)
Definition is_Theta (b : R) (theta : R -> R) : Prop :=
  (forall k t, (k <= 3)%nat -> ex_derive_n theta k t) /\
  (forall t, Derive_n theta 3 t - t * Derive theta t + b * theta t = 0) /\
  theta 0 = Gamma (- b / 3) / (Rpower 3 ((3 + b) / 3) * Gamma (- b)) /\
  Derive theta 0 = Gamma ((1 - b) / 3) / (Rpower 3 ((2 + b) / 3) * Gamma (- b)) /\
  Derive_n theta 2 0 = Gamma ((2 - b) / 3) / (Rpower 3 ((1 + b) / 3) * Gamma (- b)).

(** The rising factorial x (x + 1) ... (x + n - 1). *)
Fixpoint rising (x : R) (n : nat) : R :=
  match n with
  | O => 1
  | S n => rising x n * (x + INR n)
  end.

(** a 0 + ... + a (n - 1). *)
Fixpoint sum_first (a : nat -> R) (n : nat) : R :=
  match n with
  | O => 0
  | S n => sum_first a n + a n
  end.

(** l is the list of all real zeros of f, in increasing order, each once. *)
Definition zeros_of (f : R -> R) (l : list R) : Prop :=
  StronglySorted Rlt l /\ forall t, f t = 0 <-> In t l.

(** ** The definitions are right *)

Definition gamma_is_euler : Prop := forall x, 0 < x ->
  is_RInt_gen (fun t => Rpower t (x - 1) * exp (- t)) (at_right 0) (Rbar_locally p_infty) (Gamma x).

Definition gamma_equation : Prop := forall x, x <> 0 -> Gamma (x + 1) = x * Gamma x.

(** Off the poles no other function has these two properties. *)
Definition gamma_unique : Prop := forall G : R -> R,
  (forall x, 0 < x ->
     is_RInt_gen (fun t => Rpower t (x - 1) * exp (- t)) (at_right 0) (Rbar_locally p_infty) (G x)) ->
  (forall x, (forall n : nat, x <> - INR n) -> G (x + 1) = x * G x) ->
  forall x, (forall n : nat, x <> - INR n) -> G x = Gamma x.

Definition recip_gamma : Prop := forall x,
  ((forall n : nat, x <> - INR n) -> recip_Gamma x = / Gamma x) /\ ((exists n : nat, x = - INR n) -> recip_Gamma x = 0).

(** Gauss's multiplication formula for three factors. *)
Definition gauss_multiplication : Prop := forall x, (forall n : nat, 3 * x <> - INR n) ->
  Gamma x * Gamma (x + 1 / 3) * Gamma (x + 2 / 3) = 2 * PI * Rpower 3 (1 / 2 - 3 * x) * Gamma (3 * x).

Definition theta_exists : Prop := forall b, exists theta, is_Theta b theta.

Definition theta_unique : Prop := forall b theta phi, is_Theta b theta -> is_Theta b phi -> forall t, theta t = phi t.

(** The property by which the paper singles Theta out: Theta(t, b) ~ (-t)^b as t -> -oo. *)
Definition theta_asymptotics : Prop := forall b theta, not_nat b -> is_Theta b theta ->
  is_lim (fun x => theta (- x) / Rpower x b) p_infty 1.

(** ** Theta: integral, identities, series *)

(** Gamma(-b) Theta^(n) = int_0^oo r^(n-b-1) e^(rt - r^3/3) dr for n > b; hence it is positive everywhere. *)
Definition laplace_integral : Prop := forall b theta n, not_nat b -> b < INR n -> is_Theta b theta -> forall t,
  is_RInt_gen (fun r => Rpower r (INR n - b - 1) * exp (r * t - r ^ 3 / 3))
    (at_right 0) (Rbar_locally p_infty) (Gamma (- b) * Derive_n theta n t).

Definition sign_of_derivatives : Prop := forall b theta n, not_nat b -> b < INR n -> is_Theta b theta ->
  forall t, 0 < Gamma (- b) * Derive_n theta n t.

Definition derivative_identity : Prop := forall b theta theta1, not_nat b ->
  is_Theta b theta -> is_Theta (b - 1) theta1 -> forall t, Derive theta t = - b * theta1 t.

Definition three_term_recurrence : Prop := forall b theta theta1 theta3, not_nat b ->
  is_Theta b theta -> is_Theta (b - 1) theta1 -> is_Theta (b - 3) theta3 ->
  forall t, theta t = - t * theta1 t + (b - 1) * (b - 2) * theta3 t.

(** Theta is its Taylor series c_0 + c_1 t + ..., (k + 1)(k + 2)(k + 3) c_(k+3) = (k - b) c_k. *)
Definition taylor_series : Prop := forall b theta, is_Theta b theta -> exists c : nat -> R,
  c 0%nat = theta 0 /\ c 1%nat = Derive theta 0 /\ 2 * c 2%nat = Derive_n theta 2 0 /\
  (forall k, (INR k + 1) * (INR k + 2) * (INR k + 3) * c (k + 3)%nat = (INR k - b) * c k) /\
  forall t, is_pseries c t (theta t).

(** The signs at t = 0 for b in (m - 1, m): the one of Theta(0, b) has the period 3 in m, and is - only if m = 2 mod 3. *)
Definition signs_at_zero : Prop := forall (m n : nat) b theta, INR m - 1 < b < INR m -> is_Theta b theta ->
  ((n <= m)%nat -> 0 < (-1) ^ n * (if Nat.eqb ((m - n) mod 3) 2 then -1 else 1) * Derive_n theta n 0) /\
  ((m <= n)%nat -> 0 < (-1) ^ m * Derive_n theta n 0).

(** t -> -oo, n > b: Theta^(n)(-x) / ((-b)_n x^(b-n)) lies between consecutive partial sums of
    sum (-1)^k (n-b)_(3k) / (3^k k! x^(3k)): after N terms the rest has the sign of the next one and is at most it. *)
Definition enveloping_series : Prop := forall b theta n N x, not_nat b -> b < INR n -> is_Theta b theta -> 0 < x ->
  let term k := rising (INR n - b) (3 * k) / (3 ^ k * INR (fact k) * x ^ (3 * k)) in
  let quotient := Derive_n theta n (- x) / (rising (- b) n * Rpower x (b - INR n)) in
  0 <= (-1) ^ N * (quotient - sum_first (fun k => (-1) ^ k * term k) N) <= term N.

(** The same for every n (Theta itself is n = 0), as soon as b < n + 3N. (For n < b the terms need not be positive.) *)
Definition enveloping_series_low : Prop := forall b theta n N x, not_nat b -> is_Theta b theta -> 0 < x ->
  b < INR n + 3 * INR N ->
  let term k := rising (INR n - b) (3 * k) / (3 ^ k * INR (fact k) * x ^ (3 * k)) in
  let quotient := Derive_n theta n (- x) / (rising (- b) n * Rpower x (b - INR n)) in
  0 <= (-1) ^ N * (quotient - sum_first (fun k => (-1) ^ k * term k) N) / term N <= 1.

(** The sign of Gamma(-beta) on the cell (m, m + 1): it changes at every integer. *)
Definition gamma_sign : Prop := forall (m : nat) b, INR m < b < INR m + 1 -> 0 < (-1) ^ (m + 1) * Gamma (- b).

(** dTheta/dtau for t -> -oo, and, with every other derivative, for t -> +oo: the side rule at leading order. *)
Definition left_end : Prop := forall b theta, 0 < b -> not_nat b -> is_Theta b theta ->
  exists T, forall t, t <= T -> Derive theta t < 0.

Definition right_end : Prop := forall b theta n, not_nat b -> is_Theta b theta ->
  forall M, exists T, forall t, T <= t -> M <= Gamma (- b) * Derive_n theta n t.

(** An explicit point, n < b < n + 1: Theta > 0 on (-oo, -x] if x^(3N) 3^N N! > |b (b - 1) ... (b - 3N + 1)|, N = floor(n/3) + 1. *)
Definition left_end_explicit : Prop := forall (n : nat) b theta x, INR n < b < INR n + 1 -> is_Theta b theta -> 0 < x ->
  let N := S (n / 3) in
  Rabs (rising (- b) (3 * N)) < x ^ (3 * N) * 3 ^ N * INR (fact N) -> forall t, t <= - x -> 0 < theta t.

(** n < beta < n + 1 and a point T, with s k = Gamma(-b) Theta^(k)(T) for k <= n. If none is negative, Theta has no zero on [T, oo);
    if they change sign once, from <= 0 to >= 0, it has exactly one there, and that is simple. *)
Definition tail_without_zero : Prop := forall (n : nat) b theta T, INR n < b < INR n + 1 -> is_Theta b theta ->
  let s k := Gamma (- b) * Derive_n theta k T in
  (forall k, (k <= n)%nat -> 0 <= s k) -> s 0%nat <> 0 -> forall t, T <= t -> 0 < Gamma (- b) * theta t.

Definition tail_with_one_zero : Prop := forall (n j : nat) b theta T, INR n < b < INR n + 1 -> is_Theta b theta ->
  let s k := Gamma (- b) * Derive_n theta k T in
  (1 <= j <= n + 1)%nat -> (forall k, (k < j)%nat -> s k <= 0) -> (forall k, (j <= k <= n)%nat -> 0 <= s k) -> s 0%nat <> 0 ->
  exists z, T < z /\ theta z = 0 /\ Derive theta z <> 0 /\
    (forall t, T <= t < z -> Gamma (- b) * theta t < 0) /\ (forall t, z < t -> 0 < Gamma (- b) * theta t).

(** The coefficients c of any solution at any point t0: a_k = |c_k| s^k is small from I + 3 on. *)
Definition recurrence_tail : Prop := forall b t0 s B (c : nat -> R) (I N : nat), 0 < s -> 1 <= B -> Rabs b <= B ->
  (forall k, (INR k + 1) * (INR k + 2) * (INR k + 3) * c (k + 3)%nat
     = t0 * (INR k + 1) * c (k + 1)%nat + (INR k - b) * c k) ->
  let a k := Rabs (c k) * s ^ k in
  let q := Rabs t0 * s ^ 2 / ((INR I + 2) * (INR I + 3))
    + (INR I + B) * s ^ 3 / ((INR I + 1) * (INR I + 2) * (INR I + 3)) in
  q < 1 -> sum_first (fun i => a (I + 3 + i)%nat) N
    <= 3 * Rmax (a I) (Rmax (a (I + 1)%nat) (a (I + 2)%nat)) * q / (1 - q).

(** At t0 = 0, for the derivative of order d: v_k = k!/(k-d)! |c_k| X^(k-d) is small from K on. *)
Definition derivative_tail : Prop := forall b X B (c : nat -> R) (d K N : nat), 0 <= X -> 1 <= B -> Rabs b <= B -> (d <= K)%nat ->
  (forall k, (INR k + 1) * (INR k + 2) * (INR k + 3) * c (k + 3)%nat = (INR k - b) * c k) ->
  let v k := INR (fact k) / INR (fact (k - d)) * Rabs (c k) * X ^ (k - d) in
  let y := INR (K - d) in
  let q := (y + INR d + B) * X ^ 3 / ((y + 1) * (y + 2) * (y + 3)) in
  q < 1 -> sum_first (fun i => v (K + i)%nat) N <= (v K + v (K + 1)%nat + v (K + 2)%nat) / (1 - q).

(** ** Impact without collision at leading order: 0 < beta < 1 *)

(** The conjecture of the paper (Sec. 4.5 and conclusion): dTheta/dtau < 0 on the whole line. *)
Definition IWC : Prop := forall b theta, 0 < b < 1 -> is_Theta b theta -> forall t, Derive theta t < 0.

(** The same for every derivative. *)
Definition IWC_all_derivatives : Prop := forall b theta, 0 < b < 1 -> is_Theta b theta ->
  forall n t, (1 <= n)%nat -> Derive_n theta n t < 0.

(** ** The number of zeros of dTheta/dtau *)

(** m < beta < m + 1: dTheta/dtau has (m mod 3) + floor(m/3) real zeros, all simple. *)
Definition count_law : Prop := forall (m : nat) b theta, INR m < b < INR m + 1 -> is_Theta b theta ->
  exists l, zeros_of (Derive theta) l /\ length l = (m mod 3 + m / 3)%nat /\
    forall t, In t l -> Derive_n theta 2 t <> 0.

(** Where they are: one negative zero if m = 2 mod 3 and none otherwise, ceil(m/3) positive ones; and the signs: of
    dTheta/dtau before the first zero, and of its slope at the i-th, i = 0, 1, ... *)
Definition count_law_with_signs : Prop := forall (m : nat) b theta, INR m < b < INR m + 1 -> is_Theta b theta ->
  exists negative positive,
    zeros_of (Derive theta) (negative ++ positive) /\
    length negative = (if Nat.eqb (m mod 3) 2 then 1 else 0)%nat /\ (forall t, In t negative -> t < 0) /\
    length positive = ((m + 2) / 3)%nat /\ (forall t, In t positive -> 0 < t) /\
    (forall t, (forall c, In c (negative ++ positive) -> t < c) -> Derive theta t < 0) /\
    forall i, (i < length (negative ++ positive))%nat -> 0 < (-1) ^ i * Derive_n theta 2 (nth i (negative ++ positive) 0).

(** z0 < c0 < z1 < ... < c_(k-1) < z_k,  and  c0 < z0 < c1 < ... < z_(k-1). *)
Definition around (c z : list R) : Prop :=
  length z = S (length c) /\ forall i, (i < length c)%nat -> nth i z 0 < nth i c 0 < nth (S i) z 0.

Definition after_each (c z : list R) : Prop :=
  length z = length c /\
  forall i, (i < length c)%nat -> nth i c 0 < nth i z 0 /\ ((S i < length c)%nat -> nth i z 0 < nth (S i) c 0).

(** The positive zeros z for beta and c for beta - 1 interlace; n = floor(beta) >= 1. *)
Definition interlacing : Prop := forall (n : nat) b theta theta1, (1 <= n)%nat -> INR n < b < INR n + 1 ->
  is_Theta b theta -> is_Theta (b - 1) theta1 ->
  exists c z, StronglySorted Rlt c /\ StronglySorted Rlt z /\
    (forall t, 0 < t /\ Derive theta1 t = 0 <-> In t c) /\ (forall t, 0 < t /\ Derive theta t = 0 <-> In t z) /\
    if Nat.eqb (n mod 3) 1 then around c z else after_each c z.

(** Inside a cell m < beta < m + 1 the i-th zero is a continuous function of beta. *)
Definition zeros_continuous : Prop := forall (m : nat) b0 theta0 l0 eps, INR m < b0 < INR m + 1 ->
  is_Theta b0 theta0 -> zeros_of (Derive theta0) l0 -> 0 < eps ->
  exists delta, 0 < delta /\ forall b theta l, Rabs (b - b0) < delta ->
    is_Theta b theta -> zeros_of (Derive theta) l ->
    length l = length l0 /\ forall i, (i < length l0)%nat -> Rabs (nth i l 0 - nth i l0 0) < eps.

(** Off the integers Theta has a derivative in b, and that is continuous in (t, b). *)
Definition differentiable_in_beta : Prop := forall b t (Theta : R -> R -> R), not_nat b ->
  (forall b, not_nat b -> is_Theta b (Theta b)) ->
  ex_derive (fun b => Theta b t) b /\ continuous (fun p : R * R => Derive (fun b => Theta b (fst p)) (snd p)) (t, b).

(** So inside a cell the i-th zero z(beta) has a continuous derivative, - (d/dbeta dTheta/dtau)/(d^2 Theta/dtau^2) at the zero. *)
Definition zeros_differentiable : Prop := forall (m i : nat) (Theta : R -> R -> R) (l : R -> list R), (i < m mod 3 + m / 3)%nat ->
  (forall b, INR m < b < INR m + 1 -> is_Theta b (Theta b) /\ zeros_of (Derive (Theta b)) (l b)) ->
  let z b := nth i (l b) 0 in
  forall b, INR m < b < INR m + 1 ->
    is_derive z b (- Derive (fun b' => Derive (Theta b') (z b)) b / Derive_n (Theta b) 2 (z b)) /\ continuous (Derive z) b.

(** ** Integer beta *)

(** The polynomial P_n = sum_(j <= n/3) (-1)^(n+j) n! / ((n-3j)! 3^j j!) t^(n-3j). *)
Definition Poly (n : nat) (t : R) : R :=
  sum_f_R0 (fun j => (-1) ^ (n + j) * INR (fact n) / (INR (fact (n - 3 * j)) * 3 ^ j * INR (fact j)) * t ^ (n - 3 * j))
    (n / 3).

(** The initial values for every b, integers too: t01-t03 without a quotient of poles, by Gauss's formula. *)
Definition is_Theta_entire (b : R) (theta : R -> R) : Prop :=
  (forall k t, (k <= 3)%nat -> ex_derive_n theta k t) /\
  (forall t, Derive_n theta 3 t - t * Derive theta t + b * theta t = 0) /\
  theta 0 = 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2) * recip_Gamma ((1 - b) / 3) * recip_Gamma ((2 - b) / 3) /\
  Derive theta 0 = 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 1 / 3) * recip_Gamma (- b / 3) * recip_Gamma ((2 - b) / 3) /\
  Derive_n theta 2 0 = 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 2 / 3) * recip_Gamma (- b / 3) * recip_Gamma ((1 - b) / 3).

(** They single out Theta(., b) off the integers, and P_n at b = n. *)
Definition entire_initial_values : Prop := forall b theta,
  (not_nat b -> (is_Theta b theta <-> is_Theta_entire b theta)) /\
  (forall n : nat, b = INR n -> ((forall t, theta t = Poly n t) <-> is_Theta_entire b theta)).

(** It is the limit of Theta(t, b) as b -> n: "Theta(., n)". At b = n itself t01-t03 divide by a pole. *)
Definition integer_limit : Prop := forall (n : nat) (Theta : R -> R -> R), (forall b, not_nat b -> is_Theta b (Theta b)) ->
  forall t, is_lim (fun b => Theta b t) (INR n) (Poly n t).

(** Off the integers Theta is continuous in b. *)
Definition continuity_in_beta : Prop := forall b (Theta : R -> R -> R), not_nat b ->
  (forall b, not_nat b -> is_Theta b (Theta b)) -> forall t, is_lim (fun b => Theta b t) b (Theta b t).

(** dP_n/dt (n >= 1) has floor((n-1)/3) positive zeros, all simple; a zero at 0 of multiplicity (n-1) mod 3; no others. *)
Definition count_law_integer : Prop := forall n, (1 <= n)%nat -> exists l,
  length l = ((n - 1) / 3)%nat /\ StronglySorted Rlt l /\ (forall t, In t l -> 0 < t) /\
  (forall t, Derive (Poly n) t = 0 <-> In t l \/ (t = 0 /\ ((n - 1) mod 3 <> 0)%nat)) /\
  (forall t, In t l -> Derive_n (Poly n) 2 t <> 0) /\
  match ((n - 1) mod 3)%nat with
  | 0%nat => Derive (Poly n) 0 <> 0
  | 1%nat => Derive (Poly n) 0 = 0 /\ Derive_n (Poly n) 2 0 <> 0
  | _ => Derive (Poly n) 0 = 0 /\ Derive_n (Poly n) 2 0 = 0 /\ Derive_n (Poly n) 3 0 <> 0
  end.

(** What the zeros l of dTheta/dtau do as beta passes n = k + 1; c are the positive zeros at n. On either side the
    zeros near c are as many as c and eps-close to it (xs). Below n: besides them none if k = 0 mod 3, one in (0, eps)
    if k = 1, one in (-eps, 0) and one in (0, eps) if k = 2. Above n: one in (-eps, 0) if k = 1 mod 3, none if not,
    and exactly one more, z, beyond any T given: it comes from +oo. *)
Definition zeros_at_integer : Prop := forall (k : nat) c eps T, StronglySorted Rlt c ->
  (forall t, 0 < t /\ Derive (Poly (S k)) t = 0 <-> In t c) -> 0 < eps ->
  exists delta, 0 < delta /\ forall b theta l, is_Theta b theta -> zeros_of (Derive theta) l ->
    (INR (S k) - delta < b < INR (S k) -> exists near_0 xs, l = near_0 ++ xs /\
       length xs = length c /\ (forall i, (i < length c)%nat -> Rabs (nth i xs 0 - nth i c 0) < eps) /\
       match (k mod 3)%nat with
       | 0%nat => near_0 = []
       | 1%nat => exists x, near_0 = [x] /\ 0 < x < eps
       | _ => exists x y, near_0 = [x; y] /\ - eps < x < 0 /\ 0 < y < eps
       end) /\
    (INR (S k) < b < INR (S k) + delta -> exists near_0 xs z, l = near_0 ++ xs ++ [z] /\ T < z /\
       length xs = length c /\ (forall i, (i < length c)%nat -> Rabs (nth i xs 0 - nth i c 0) < eps) /\
       match (k mod 3)%nat with
       | 1%nat => exists x, near_0 = [x] /\ - eps < x < 0
       | _ => near_0 = []
       end).

(** Left of 0 dP_n/dt is negative. *)
Definition left_end_integer : Prop := forall n t, (1 <= n)%nat -> t < 0 -> Derive (Poly n) t < 0.

(** A fold, n = 2 mod 3: on a box that holds (0, n), where F = Theta is convex in t, increases with b and is positive at both ends,
    F has two zeros, both simple, below n, the one zero 0 at n, and none above. *)
Definition fold : Prop := forall (n : nat) t1 t2 lo hi (F : R -> R -> R), (n mod 3 = 2)%nat -> t1 < 0 < t2 ->
  lo <= INR n <= hi ->
  (forall b, lo <= b <= hi -> b <> INR n -> is_Theta b (F b)) -> (forall t, F (INR n) t = Poly n t) ->
  (forall t b, t1 <= t <= t2 -> lo <= b <= hi -> 0 < Derive_n (F b) 2 t) ->
  (forall t b b', t1 <= t <= t2 -> lo <= b -> b < b' -> b' <= hi -> F b t < F b' t) ->
  (forall b, lo <= b <= hi -> 0 < F b t1 /\ 0 < F b t2) ->
  forall b, lo <= b <= hi ->
    (b < INR n -> exists x y, t1 < x < 0 /\ 0 < y < t2 /\ F b x = 0 /\ F b y = 0 /\ Derive (F b) x < 0 /\
       0 < Derive (F b) y /\ forall t, t1 <= t <= t2 -> F b t = 0 -> t = x \/ t = y) /\
    (b = INR n -> forall t, t1 <= t <= t2 -> (F b t = 0 <-> t = 0)) /\
    (INR n < b -> forall t, t1 <= t <= t2 -> 0 < F b t).

(** A hinge: a sign at 0 (which may be 0) and the sign of the slope on one side give the sign on that side. *)
Definition hinge : Prop := forall (f : R -> R) s t1 t2, t1 <= 0 <= t2 -> (forall t, ex_derive f t) -> 0 <= s * f 0 ->
  ((forall t, t1 <= t <= 0 -> 0 < - (s * Derive f t)) -> forall t, t1 <= t < 0 -> 0 < s * f t) /\
  ((forall t, 0 <= t <= t2 -> 0 < s * Derive f t) -> forall t, 0 < t <= t2 -> 0 < s * f t).

(** ** The compliant model at every eps > 0 *)

(** The contact force compl2: lambda = (z - y)/eps^2 while y < z, otherwise 0; and the same without the condition. *)
Definition contact_force (eps y z : R) : R := if Rlt_dec y z then (z - y) / eps ^ 2 else 0.
Definition linear_force (eps y z : R) : R := (z - y) / eps ^ 2.

(** The equations modelsys1-modelsys5 at time t, for a law of force. *)
Definition model_at (a1 a2 a3 eps : R) (force : R -> R -> R -> R) (p b y v z : R -> R) (t : R) : Prop :=
  is_derive p t a1 /\
  is_derive b t (a2 - a3 * force eps (y t) (z t)) /\
  is_derive y t (v t) /\
  is_derive v t (b t + p t * force eps (y t) (z t)) /\
  is_derive (fun s => eps * z s) t (- z t - eps ^ 2 * force eps (y t) (z t)).

(** What all statements below suppose. beta = a3/a1; the G-spot is passed at t = 0. *)
Definition parameters (a1 a3 eps : R) : Prop := a1 < 0 /\ a3 < 0 /\ 0 < eps /\ not_nat (a3 / a1).

(** A motion on the slow manifold with coefficient C: it solves the contact equations for all t, p = a1 t, and
    b - (its trivial part) ~ C (-t/eps)^beta as t -> -oo. *)
Definition slow_motion (a1 a2 a3 eps C : R) (p b y v z : R -> R) : Prop :=
  (forall t, p t = a1 * t) /\
  (forall t, model_at a1 a2 a3 eps linear_force p b y v z t) /\
  is_lim (fun x => (b (- x) - a2 / (a1 - a3) * a1 * - x) / Rpower (x / eps) (a3 / a1)) p_infty C.

(** For each C there is exactly one. *)
Definition slow_motion_exists : Prop := forall a1 a2 a3 eps C, parameters a1 a3 eps ->
  exists p b y v z, slow_motion a1 a2 a3 eps C p b y v z.

Definition slow_motion_unique : Prop := forall a1 a2 a3 eps C p b y v z p' b' y' v' z', parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z -> slow_motion a1 a2 a3 eps C p' b' y' v' z' ->
  forall t, p t = p' t /\ b t = b' t /\ y t = y' t /\ v t = v' t /\ z t = z' t.

(** Growth below that of the fast modes, for instance polynomial growth. *)
Definition slow_at_left (eps : R) (f : R -> R) : Prop :=
  exists A T, forall t, t <= T -> Rabs (f t) <= A * exp (- t / (16 * eps)).

(** They are the motions in contact whose b does not grow exponentially at t -> -oo. *)
Definition slow_motions_are_all : Prop := forall a1 a2 a3 eps p b y v z, parameters a1 a3 eps ->
  (forall t, p t = a1 * t) -> (forall t, model_at a1 a2 a3 eps linear_force p b y v z t) ->
  (slow_at_left eps b <-> exists C, slow_motion a1 a2 a3 eps C p b y v z).

(** modelSysDev for the deviation of b from its trivial part, and modelSysDevRecoverY, V, Z, LN for the other deviations. *)
Definition deviation_form (a1 a2 a3 eps : R) (b y v z : R -> R) : Prop :=
  let h t := b t - a2 / (a1 - a3) * a1 * t in
  (forall k t, (k <= 4)%nat -> ex_derive_n h k t) /\
  forall t,
    a3 * h t - a1 * t * Derive h t + eps * ((a3 - a1) * Derive h t - a1 * t * Derive_n h 2 t)
      - 2 * eps ^ 2 * Derive_n h 3 t - eps ^ 3 * Derive_n h 4 t = 0 /\
    a3 * (y t - 2 * (eps ^ 2 * a2 / (a1 - a3)))
      = eps ^ 2 * (a3 * h t - a1 * t * Derive h t + 2 * Derive h t) - eps ^ 3 * Derive_n h 2 t - eps ^ 4 * Derive_n h 3 t /\
    a3 * v t = - eps * (a3 * h t - a1 * t * Derive h t) + 2 * eps ^ 2 * Derive_n h 2 t + eps ^ 3 * Derive_n h 3 t /\
    a3 * (z t - eps ^ 2 * a2 / (a1 - a3))
      = eps ^ 2 * (a3 * h t - a1 * t * Derive h t + Derive h t) - eps ^ 3 * Derive_n h 2 t - eps ^ 4 * Derive_n h 3 t /\
    a3 * (linear_force eps (y t) (z t) - a2 / (a3 - a1)) = - Derive h t.

(** With p = a1 t they say the same as the equations in contact. *)
Definition deviation_recover : Prop := forall a1 a2 a3 eps p b y v z, a3 <> 0 -> a1 <> a3 -> 0 < eps ->
  (forall t, p t = a1 * t) ->
  ((forall t, model_at a1 a2 a3 eps linear_force p b y v z t) <-> deviation_form a1 a2 a3 eps b y v z).

(** The side rule at every eps, for every non-integer beta: on the slow manifold the force tends to +oo or to -oo
    with the sign of C Gamma(-beta). *)
Definition side_rule : Prop := forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z ->
  (0 < C * Gamma (- (a3 / a1)) -> forall M, exists T, forall t, T <= t -> M <= linear_force eps (y t) (z t)) /\
  (C * Gamma (- (a3 / a1)) < 0 -> forall M, exists T, forall t, T <= t -> linear_force eps (y t) (z t) <= M).

(** 0 < beta < 1 and C < 0: the force less its mean is positive, and increases from 0 to +oo. *)
Definition force_deviation : Prop := forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z -> a3 / a1 < 1 -> C < 0 ->
  let deviation t := linear_force eps (y t) (z t) - a2 / (a3 - a1) in
  (forall t, 0 < deviation t) /\ (forall s t, s < t -> deviation s < deviation t) /\
  (forall d, 0 < d -> exists T, forall t, t <= T -> deviation t < d) /\
  (forall M, exists T, forall t, T <= t -> M <= deviation t).

(** Impact without collision: the side of C for which the force increases; 0 < beta < 2. *)
Definition IWC_side (beta C : R) : Prop := (beta < 1 /\ C < 0) \/ (1 < beta < 2 /\ 0 < C).

(** Any motion of the mechanism (with compl2) from a state of a slow motion with y <= z keeps contact for ever after;
    the force increases strictly and tends to +oo, and y to -oo. *)
Definition IWC_compliant : Prop := forall a1 a2 a3 eps C t0 P B Y V Z p b y v z, parameters a1 a3 eps ->
  IWC_side (a3 / a1) C -> slow_motion a1 a2 a3 eps C P B Y V Z ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 -> y t0 <= z t0 ->
  (forall t, t0 < t -> y t < z t) /\
  (forall s t, t0 <= s -> s < t -> contact_force eps (y s) (z s) < contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).

(** On the other side the force of a slow motion decreases strictly and vanishes exactly once: lift-off. *)
Definition lift_off_compliant : Prop := forall a1 a2 a3 eps C t0 p b y v z, parameters a1 a3 eps ->
  IWC_side (a3 / a1) (- C) -> slow_motion a1 a2 a3 eps C p b y v z -> y t0 < z t0 ->
  (forall s t, s < t -> linear_force eps (y t) (z t) < linear_force eps (y s) (z s)) /\
  exists t1, t0 < t1 /\ y t1 = z t1 /\ (forall t, t < t1 -> y t < z t) /\ (forall t, t1 < t -> z t < y t).

(** Case I (0 < beta < 1, a2 < 0), C < 0: the force of the slow motion is negative up to one instant and positive after;
    from that instant on it is a motion of the mechanism. *)
Definition case_I : Prop := forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps ->
  a3 / a1 < 1 -> a2 < 0 -> C < 0 -> slow_motion a1 a2 a3 eps C p b y v z ->
  exists t0, (forall t, t < t0 -> z t < y t) /\ (forall t, t0 < t -> y t < z t) /\
    forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t.

(** Case II (0 < beta < 1, a2 > 0), any motion of the mechanism on R that is in contact for t < t1 and whose b does not
    grow exponentially at t -> -oo: the trivial one; or impact without collision; or lift-off. *)
Definition case_II : Prop := forall a1 a2 a3 eps t1 p b y v z, parameters a1 a3 eps ->
  a3 / a1 < 1 -> 0 < a2 -> (forall t, p t = a1 * t) ->
  (forall t, model_at a1 a2 a3 eps contact_force p b y v z t) -> (forall t, t < t1 -> y t < z t) ->
  slow_at_left eps b ->
  let lambda t := contact_force eps (y t) (z t) in
  let mean := a2 / (a3 - a1) in
  ((forall t, y t < z t) /\ forall t, lambda t = mean) \/
  ((forall t, y t < z t) /\ (forall t, mean < lambda t) /\ (forall s t, s < t -> lambda s < lambda t) /\
     (forall M, exists T, forall t, T <= t -> M <= lambda t) /\ (forall M, exists T, forall t, T <= t -> y t <= M)) \/
  (exists t2, (forall t, t < t2 -> y t < z t) /\ y t2 = z t2 /\ (forall t, t < t2 -> lambda t < mean) /\
     forall s t, s < t -> t <= t2 -> lambda t < lambda s).

(** The force at leading order, for b - (its trivial part) ~ C_1 (-t)^beta at t -> -oo. *)
Definition leading_force (a1 a2 a3 eps C1 : R) (theta : R -> R) (t : R) : R :=
  let beta := a3 / a1 in
  let kappa := Rpower (- a1 / 2) (1 / 3) in
  a2 / (a3 - a1)
    - C1 / a3 * Rpower kappa (1 - beta) * Rpower eps ((2 * beta - 2) / 3) * Derive theta (kappa * t * Rpower eps (- 2 / 3)).

(** The side rule at leading order: the force tends to +oo or to -oo with the sign of C_1 Gamma(-beta). *)
Definition leading_side_rule : Prop := forall a1 a2 a3 eps C1 theta, parameters a1 a3 eps -> is_Theta (a3 / a1) theta ->
  (0 < C1 * Gamma (- (a3 / a1)) -> forall M, exists T, forall t, T <= t -> M <= leading_force a1 a2 a3 eps C1 theta t) /\
  (C1 * Gamma (- (a3 / a1)) < 0 -> forall M, exists T, forall t, T <= t -> leading_force a1 a2 a3 eps C1 theta t <= M).

(** 0 < beta < 5: at every time and every eps the force of the slow motion is above the one at leading order if
    C_1 Gamma(-beta) > 0, and below it if C_1 Gamma(-beta) < 0. *)
Definition force_above_leading_order : Prop := forall a1 a2 a3 eps C1 theta p b y v z t, parameters a1 a3 eps ->
  a3 / a1 < 5 -> is_Theta (a3 / a1) theta -> slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) p b y v z ->
  (0 < C1 * Gamma (- (a3 / a1)) -> leading_force a1 a2 a3 eps C1 theta t < linear_force eps (y t) (z t)) /\
  (C1 * Gamma (- (a3 / a1)) < 0 -> linear_force eps (y t) (z t) < leading_force a1 a2 a3 eps C1 theta t).

(** eps_0 = ((mean force) |a3| kappa^(beta-1) / m)^(3/(2 beta - 2)), -m a lower bound of C_1 dTheta/dtau. *)
Definition threshold (a1 a2 a3 m : R) : R :=
  let beta := a3 / a1 in
  let kappa := Rpower (- a1 / 2) (1 / 3) in
  Rpower (- a3 * (a2 / (a3 - a1)) * Rpower kappa (beta - 1) / m) (3 / (2 * beta - 2)).

(** At leading order, beta > 1, a2 < 0: for every eps < eps_0 the force is positive at all times from that of tau0 on. *)
Definition leading_force_positive : Prop := forall a1 a2 a3 eps C1 theta m tau0 t, a1 < 0 -> a3 < 0 -> 0 < eps ->
  1 < a3 / a1 -> a2 < 0 -> 0 < m -> (forall tau, tau0 <= tau -> - m <= C1 * Derive theta tau) ->
  eps < threshold a1 a2 a3 m -> tau0 <= Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3) ->
  0 < leading_force a1 a2 a3 eps C1 theta t.

(** Case III (a2 < 0), 1 < beta < 5, C_1 on the side of impact without collision, eps <= eps_0: any motion of the mechanism (with
    compl2) from a state of the slow motion at a time t0 >= (that of tau0) keeps contact for ever; the force tends to +oo, y to -oo. *)
Definition IWC_below_threshold : Prop := forall a1 a2 a3 eps C1 theta m tau0 t0 P B Y V Z p b y v z, parameters a1 a3 eps ->
  1 < a3 / a1 < 5 -> a2 < 0 -> 0 < C1 * Gamma (- (a3 / a1)) -> is_Theta (a3 / a1) theta ->
  0 < m -> (forall tau, tau0 <= tau -> - m <= C1 * Derive theta tau) -> eps <= threshold a1 a2 a3 m ->
  slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) P B Y V Z ->
  tau0 <= Rpower (- a1 / 2) (1 / 3) * t0 * Rpower eps (- 2 / 3) ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).

(** Such a bound exists on every half-line [tau0, oo), and for C_1 < 0 on the whole line. *)
Definition least_value_exists : Prop := forall b theta C1, 0 < b -> not_nat b -> is_Theta b theta -> 0 < C1 * Gamma (- b) ->
  (forall tau0, exists m, 0 < m /\ forall tau, tau0 <= tau -> - m <= C1 * Derive theta tau) /\
  (C1 < 0 -> exists m, 0 < m /\ forall tau, - m <= C1 * Derive theta tau).

(** The force less its mean, and its first three derivatives in contact, as functions of the state. *)
Definition force_excess (a1 a2 a3 eps : R) (y z : R) : R := (z - y) / eps ^ 2 - a2 / (a3 - a1).
Definition force_excess1 (eps : R) (y v z : R) : R := ((y - 2 * z) / eps - v) / eps ^ 2.
Definition force_excess2 (eps : R) (p b y v z : R) : R :=
  ((v - 2 * ((y - 2 * z) / eps)) / eps - (b + p * ((z - y) / eps ^ 2))) / eps ^ 2.
Definition force_excess3 (a1 a2 a3 eps : R) (p b y v z : R) : R :=
  ((b + p * ((z - y) / eps ^ 2) - 2 * ((v - 2 * ((y - 2 * z) / eps)) / eps)) / eps
   - (a2 - a3 * ((z - y) / eps ^ 2) + a1 * ((z - y) / eps ^ 2) + p * force_excess1 eps y v z)) / eps ^ 2.

(** beta < 1, after the G-spot: an open set of states, off the slow manifold too, from which contact is never
    lost and the force increases for ever. *)
Definition IWC_open : Prop := forall a1 a2 a3 eps t0 p b y v z, a1 < 0 -> a1 < a3 -> 0 < eps -> 0 <= t0 ->
  (forall t, t0 <= t -> p t = a1 * t) ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  y t0 < z t0 -> 0 < force_excess a1 a2 a3 eps (y t0) (z t0) -> 0 < force_excess1 eps (y t0) (v t0) (z t0) ->
  0 < force_excess2 eps (p t0) (b t0) (y t0) (v t0) (z t0) -> 0 < force_excess3 a1 a2 a3 eps (p t0) (b t0) (y t0) (v t0) (z t0) ->
  (forall t, t0 <= t -> y t < z t) /\
  forall s t, t0 <= s -> s < t -> contact_force eps (y s) (z s) < contact_force eps (y t) (z t).

(** It is not empty: for 0 < beta < 1 it holds every slow motion with C < 0, while that is in contact. *)
Definition open_set_holds_slow_motions : Prop := forall a1 a2 a3 eps C t p b y v z, parameters a1 a3 eps ->
  a1 < a3 -> C < 0 -> slow_motion a1 a2 a3 eps C p b y v z -> y t < z t ->
  0 < force_excess a1 a2 a3 eps (y t) (z t) /\ 0 < force_excess1 eps (y t) (v t) (z t) /\
  0 < force_excess2 eps (p t) (b t) (y t) (v t) (z t) /\ 0 < force_excess3 a1 a2 a3 eps (p t) (b t) (y t) (v t) (z t).

(** Every non-integer beta < n + 2, C on the side of impact without collision: once the force of a slow motion and its first n
    derivatives are >= 0 at one time, contact is kept ever after. On either side the force vanishes at most n + 1 times. *)
Definition contact_tail : Prop := forall a1 a2 a3 eps C n t0 p b y v z, parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z -> a3 / a1 < INR (n + 2) -> 0 < C * Gamma (- (a3 / a1)) ->
  (forall k, (k <= n)%nat -> 0 <= Derive_n (fun t => linear_force eps (y t) (z t)) k t0) ->
  forall t, t0 < t -> y t < z t.

Definition force_zeros : Prop := forall a1 a2 a3 eps C n l p b y v z, parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z -> a3 / a1 < INR (n + 2) -> C <> 0 ->
  StronglySorted Rlt l -> (forall t, In t l -> y t = z t) -> (length l <= n + 1)%nat.

(** The trivial solution as printed, modelSysDistZY with z = y/2 = - eps^2 a2/(a1 - a3), solves the contact equations at
    no time; with + in place of - it solves them (it is the slow motion with C = 0). *)
Definition printed_trivial_is_wrong : Prop := forall a1 a2 a3 eps t, 0 < eps -> a1 <> a3 -> a2 <> 0 -> a3 <> 0 ->
  ~ model_at a1 a2 a3 eps linear_force (fun t => a1 * t) (fun t => a2 / (a1 - a3) * a1 * t)
      (fun _ => 2 * (- eps ^ 2 * a2 / (a1 - a3))) (fun _ => 0) (fun _ => - eps ^ 2 * a2 / (a1 - a3)) t.

Definition corrected_trivial : Prop := forall a1 a2 a3 eps t, 0 < eps -> a1 <> a3 ->
  model_at a1 a2 a3 eps linear_force (fun t => a1 * t) (fun t => a2 / (a1 - a3) * a1 * t)
    (fun _ => 2 * (eps ^ 2 * a2 / (a1 - a3))) (fun _ => 0) (fun _ => eps ^ 2 * a2 / (a1 - a3)) t.

(** ** The deviation in the time T = t/eps, and the limit eps -> 0 *)

(** The equation modelSysDev of b in T, normalized to a1 = -1 (e is then -a1 eps), and its slow solution F. *)
Definition deviation_equation (e b : R) (f : R -> R) : Prop :=
  (forall k t, (k <= 4)%nat -> ex_derive_n f k t) /\
  forall t, - b * f t + t * Derive f t + (1 - b) * Derive f t + t * Derive_n f 2 t
    - 2 / e * Derive_n f 3 t - 1 / e * Derive_n f 4 t = 0.

Definition is_slow (e b : R) (F : R -> R) : Prop :=
  deviation_equation e b F /\ is_lim (fun x => F (- x) / Rpower x b) p_infty 1.

Definition slow_exists : Prop := forall e b, 0 < e -> not_nat b -> exists F, is_slow e b F.

Definition slow_unique : Prop := forall e b F G, 0 < e -> not_nat b -> is_slow e b F -> is_slow e b G ->
  forall t, F t = G t.

(** Gamma(-b) F^(n) = int_0^oo r^(n-b-1) e^(psi(r)/e + rT) dr, n > b, with psi = r - r^2/2 - r^3/3 - ln(1 + r). *)
Definition slow_integral : Prop := forall e b n F, 0 < e -> not_nat b -> b < INR n -> is_slow e b F -> forall t,
  is_RInt_gen (fun r => Rpower r (INR n - b - 1) * exp ((r - r ^ 2 / 2 - r ^ 3 / 3 - ln (1 + r)) / e + r * t))
    (at_right 0) (Rbar_locally p_infty) (Gamma (- b) * Derive_n F n t).

(** 0 < beta < 1, every eps: all derivatives of the slow solution are negative on the whole line. *)
Definition IWC_every_eps : Prop := forall e b F, 0 < e -> 0 < b < 1 -> is_slow e b F ->
  forall n t, (1 <= n)%nat -> Derive_n F n t < 0.

(** F has at most n real zeros if b < n. *)
Definition slow_zeros : Prop := forall e b n F l, 0 < e -> not_nat b -> b < INR n -> is_slow e b F ->
  StronglySorted Rlt l -> (forall t, In t l -> F t = 0) -> (length l <= n)%nat.

(** eps -> 0 (e = 2 eta^3, T = t/eta): eta^(b-n) F^(n)(t/eta) -> Theta^(n)(t), with an error of known sign. *)
Definition leading_order_limit : Prop := forall b n eta theta F t w, not_nat b -> b < INR n -> 0 < eta ->
  is_Theta b theta -> is_slow (2 * eta ^ 3) b F ->
  is_RInt_gen (fun r => Rpower r (INR n - b + 3) * exp (r * t - r ^ 3 / 6)) (at_right 0) (Rbar_locally p_infty) w ->
  0 <= Gamma (- b) * (Rpower eta (b - INR n) * Derive_n F n (t / eta) - Derive_n theta n t) <= eta / 8 * w.

(** Every eps at once: with G(t; eta) = eta^b F(t/eta) the number Gamma(-b) G^(n)(t; eta) increases strictly with eta, at every t, if n > b - 4. *)
Definition monotone_in_eta : Prop := forall b n eta eta' F F' t, not_nat b -> b < INR n + 4 -> 0 < eta < eta' ->
  is_slow (2 * eta ^ 3) b F -> is_slow (2 * eta' ^ 3) b F' ->
  Gamma (- b) * (Rpower eta (b - INR n) * Derive_n F n (t / eta))
    < Gamma (- b) * (Rpower eta' (b - INR n) * Derive_n F' n (t / eta')).

(** It lies above Gamma(-b) Theta^(n)(t), by at most (eta/8) Gamma(-b) G^(n+4)(t; eta). *)
Definition above_leading_order : Prop := forall b n eta theta F t, not_nat b -> b < INR n + 4 -> 0 < eta ->
  is_Theta b theta -> is_slow (2 * eta ^ 3) b F ->
  let G k := Rpower eta (b - INR k) * Derive_n F k (t / eta) in
  0 < Gamma (- b) * (G n - Derive_n theta n t) <= eta / 8 * (Gamma (- b) * G (n + 4)%nat).

(** Theorem C with a polynomial part: what is left of Gamma(-b) G^(n) beyond Theta and two terms increases with eta from 0, if n > b - 6. *)
Definition monotone_next_order : Prop := forall b n eta eta' theta F F' t, not_nat b -> b < INR n + 6 -> 0 < eta < eta' ->
  is_Theta b theta -> is_slow (2 * eta ^ 3) b F -> is_slow (2 * eta' ^ 3) b F' ->
  let excess eta F := Gamma (- b) * (Rpower eta (b - INR n) * Derive_n F n (t / eta) - Derive_n theta n t
    - eta / 8 * Derive_n theta (n + 4) t + eta ^ 2 / 10 * Derive_n theta (n + 5) t) in
  0 < excess eta F < excess eta' F'.

(** ** What the pieces of a certificate prove together (proofs/certificate.md, version 1) *)

(** F b is Theta(., b), for integers b too. *)
Definition theta_family (F : R -> R -> R) : Prop := forall b, is_Theta_entire b (F b).

(** A range of tau or of beta, closed or open at each end. *)
Record range := Range { range_from : Rbar; range_to : Rbar; closed_from : bool; closed_to : bool }.

Definition in_range (r : range) (x : R) : Prop :=
  (if closed_from r then Rbar_le (range_from r) x else Rbar_lt (range_from r) x) /\
  (if closed_to r then Rbar_le x (range_to r) else Rbar_lt x (range_to r)).

(** Closed intervals, each beginning where the one before it ends, cover [start, stop]. *)
Fixpoint cover (parts : list (Rbar * Rbar)) (start stop : Rbar) : Prop :=
  match parts with
  | [] => False
  | (low, high) :: rest => Rbar_le low start /\
      match rest with
      | [] => Rbar_le stop high
      | (next, _) :: _ => next = high /\ cover rest high stop
      end
  end.

(** Signs: [true] is +. *)
Definition signed (s : bool) (x : R) : R := if s then x else - x.

(** A piece as it stands in the file; [right_piece T v] has v changes of sign. *)
Inductive piece :=
| laplace_piece | taylor_piece | left_piece (X : R) | sign_piece (t1 t2 : R) (s : bool)
| monotone_piece (t1 t2 : R) (d : bool) | fold_piece (t1 t2 : R) | hinge_piece (t1 t2 : R) | right_piece (T : R) (v : nat).

Definition piece_ends (p : piece) : Rbar * Rbar :=
  match p with
  | laplace_piece => (m_infty, p_infty)
  | taylor_piece => (Finite 0, p_infty)
  | left_piece X => (m_infty, Finite X)
  | right_piece T _ => (Finite T, p_infty)
  | sign_piece t1 t2 _ | monotone_piece t1 t2 _ | fold_piece t1 t2 | hinge_piece t1 t2 => (Finite t1, Finite t2)
  end.

(** A column: beta in [low, high], inside the closed cell [m, m + 1]; for m = 0 all beta <= 1. Below b = beta - 1. *)
Record column := Column { column_low : Rbar; column_high : R; column_cell : nat; column_pieces : list piece }.

Definition in_cell (c : column) : Prop :=
  column_high c <= INR (column_cell c) + 1 /\ (column_cell c = 0%nat \/ Rbar_le (INR (column_cell c)) (column_low c)).

Definition in_column (c : column) (b : R) : Prop := Rbar_le (column_low c) (b + 1) /\ b + 1 <= column_high c.

(** The changes in a sequence of signs that begins with s; an open one ([None]) must stand between opposite ones. *)
Fixpoint changes (s : bool) (signs : list (option bool)) : option nat :=
  match signs with
  | [] => Some 0%nat
  | Some s' :: rest => option_map (fun v => if Bool.eqb s s' then v else S v) (changes s' rest)
  | None :: Some s' :: rest => if Bool.eqb s s' then None else option_map S (changes s' rest)
  | None :: _ => None
  end.

(** A finite cover of [t1, t2] x J by boxes on each of which dF/db + w F > 0, with a constant w; at the b inside J. *)
Definition increases_in_b (F : R -> R -> R) (c : column) (t1 t2 : R) : Prop := exists boxes : list ((R * R) * (R * R) * R),
  let inside t b box := let '((s1, s2), (b1, b2), _) := box in s1 <= t <= s2 /\ b1 <= b <= b2 in
  (forall t b, t1 <= t <= t2 -> in_column c b -> exists box, In box boxes /\ inside t b box) /\
  (forall t b box, In box boxes -> inside t b box -> Rbar_lt (column_low c) (b + 1) -> b + 1 < column_high c ->
     0 < Derive (fun b => F b t) b + snd box * F b t).

(** The number at which J has its fold: the end of J that is 2 mod 3. Below it there are two zeros, above it none. *)
Definition fold_above (c : column) : Prop :=
  (column_cell c mod 3 = 2)%nat /\ column_high c = INR (column_cell c) + 1.
Definition fold_below (c : column) : Prop :=
  (column_cell c mod 3 = 0 /\ 3 <= column_cell c)%nat /\ column_low c = INR (column_cell c).

(** What is checked of a piece. *)
Definition piece_checked (F : R -> R -> R) (c : column) (p : piece) : Prop :=
  let m := column_cell c in
  Rbar_lt (fst (piece_ends p)) (snd (piece_ends p)) /\
  match p with
  | laplace_piece | taylor_piece => column_high c <= 1
  | left_piece X => X < 0 /\ Rbar_le 0 (column_low c) /\
      let N := S ((m - 1) / 3) in
      let factor i := Rmax (Rabs (real (column_low c) - 1 - INR i)) (Rabs (column_high c - 1 - INR i)) in
      fold_right Rmult 1 (map factor (seq 0 (3 * N))) < (- X) ^ (3 * N) * 3 ^ N * INR (fact N)
  | sign_piece t1 t2 s => forall t b, t1 <= t <= t2 -> in_column c b -> 0 < signed s (F b t)
  | monotone_piece t1 t2 d => forall t b, t1 <= t <= t2 -> in_column c b -> 0 < signed d (Derive (F b) t)
  | fold_piece t1 t2 => t1 < 0 < t2 /\ (fold_below c \/ fold_above c) /\
      (forall b, in_column c b -> 0 < F b t1 /\ 0 < F b t2) /\
      (forall t b, t1 <= t <= t2 -> in_column c b -> 0 < Derive_n (F b) 2 t) /\ increases_in_b F c t1 t2
  | hinge_piece t1 t2 => (1 <= m)%nat /\ (t1 = 0 \/ t2 = 0) /\
      let s := negb (Nat.eqb (m mod 3) 2) in
      forall t b, t1 <= t <= t2 -> in_column c b -> 0 < signed (if Rle_dec 0 t1 then s else negb s) (Derive (F b) t)
  | right_piece T v => (1 <= m)%nat /\ (v <= 1)%nat /\ exists s signs, length signs = (m - 1)%nat /\
      changes s (signs ++ [Some (Nat.even m)]) = Some v /\
      (forall b, in_column c b -> 0 < signed s (F b T)) /\
      (forall k s' b, nth k signs None = Some s' -> in_column c b -> 0 < signed s' (Derive_n (F b) (S k) T))
  end.

(** The sign of F that a piece gives: at its ends (at T for [right_piece]), and between them if it holds no zero. *)
Definition piece_sign (c : column) (p : piece) : option bool :=
  match p with
  | laplace_piece | taylor_piece | left_piece _ | fold_piece _ _ => Some true
  | sign_piece _ _ s => Some s
  | monotone_piece _ _ _ => None
  | hinge_piece _ _ => Some (negb (Nat.eqb (column_cell c mod 3) 2))
  | right_piece _ v => Some (Nat.even (column_cell c + v))
  end.

(** The pieces of a column that is accepted for dTheta/dtau of sign s on a range of tau: F has the sign s' = s or - s. *)
Definition sign_column (F : R -> R -> R) (tau beta : range) (s' : bool) (c : column) : Prop :=
  in_cell c /\ cover (map piece_ends (column_pieces c)) (range_from tau) (range_to tau) /\
  forall p, In p (column_pieces c) -> piece_checked F c p /\ piece_sign c p = Some s' /\
    match p with
    | right_piece _ v => v = 0%nat
    | fold_piece _ _ | hinge_piece _ _ =>
        (match p with fold_piece _ _ => exists n : nat, (n mod 3 = 0)%nat /\ column_low c = INR n | _ => True end) /\
        ~ (in_range tau 0 /\ exists n : nat, (n mod 3 <> 1)%nat /\ in_column c (INR n - 1) /\ in_range beta (INR n))
    | _ => True
    end.

(** A certificate of a sign: dTheta/dtau = - beta F has the sign s at every tau and beta of two ranges. *)
Definition sign_certificate : Prop := forall F tau beta columns s, theta_family F ->
  cover (map (fun c => (column_low c, Finite (column_high c))) columns) (range_from beta) (range_to beta) ->
  ((forall x, in_range beta x -> 0 < x) /\ (forall c, In c columns -> sign_column F tau beta (negb s) c) \/
   (forall x, in_range beta x -> x < 0) /\ (forall c, In c columns -> sign_column F tau beta s c)) ->
  forall t b, in_range tau t -> in_range beta b -> 0 < signed s (Derive (F b) t).

(** The walk through the pieces of a column: [before] is the sign of F at the end of the last piece that fixes one, and
    [run] the direction of the pieces [monotone] since then; a fold at the upper end of J holds two zeros, [right] holds v. *)
Definition crossings (before run : option bool) (s : bool) : option nat :=
  match before with
  | None => Some 0%nat
  | Some s' =>
      if Bool.eqb s' s then Some 0%nat
      else match run with Some d => if Bool.eqb d s then Some 1%nat else None | None => None end
  end.

Definition zeros_inside (c : column) (p : piece) : nat :=
  match p with
  | fold_piece _ _ => if Nat.eqb (column_cell c mod 3) 2 then 2 else 0
  | right_piece _ v => v
  | _ => 0
  end.

Fixpoint zeros_counted (c : column) (before run : option bool) (pieces : list piece) : option nat :=
  match pieces with
  | [] => match run with None => Some 0%nat | Some _ => None end
  | hinge_piece _ _ :: _ => None
  | monotone_piece _ _ d :: rest =>
      match before, run with
      | None, _ => None
      | Some _, Some d' => if Bool.eqb d d' then zeros_counted c before run rest else None
      | Some _, None => zeros_counted c before (Some d) rest
      end
  | p :: rest =>
      match piece_sign c p with
      | None => None
      | Some s =>
          match crossings before run s, zeros_counted c (Some s) None rest with
          | Some k, Some l => Some (k + zeros_inside c p + l)%nat
          | _, _ => None
          end
      end
  end.

Definition zeros_column (F : R -> R -> R) (count : nat) (c : column) : Prop :=
  in_cell c /\ cover (map piece_ends (column_pieces c)) m_infty p_infty /\
  (forall p, In p (column_pieces c) -> piece_checked F c p) /\ zeros_counted c None None (column_pieces c) = Some count.

(** A certificate of the number of zeros: exactly [count m] real zeros of dTheta/dtau for every beta of the range in (m, m + 1), all simple. *)
Definition zeros_certificate : Prop := forall F beta columns (count : nat -> nat), theta_family F ->
  cover (map (fun c => (column_low c, Finite (column_high c))) columns) (range_from beta) (range_to beta) ->
  (forall c, In c columns -> zeros_column F (count (column_cell c)) c) ->
  forall (m : nat) b, in_range beta b -> INR m < b < INR m + 1 ->
    exists l, zeros_of (Derive (F b)) l /\ length l = count m /\ forall t, In t l -> Derive_n (F b) 2 t <> 0.

(** A certificate of brackets: as many zeros as brackets, and one in each. *)
Definition brackets_certificate : Prop := forall F b c (brackets : list (R * R)), theta_family F -> 0 < b -> not_nat b ->
  in_column c (b - 1) -> zeros_column F (length brackets) c ->
  StronglySorted (fun one two => snd one <= fst two) brackets ->
  (forall lo hi, In (lo, hi) brackets -> lo < hi /\ F (b - 1) lo * F (b - 1) hi < 0) ->
  exists l, zeros_of (Derive (F b)) l /\ length l = length brackets /\ (forall t, In t l -> Derive_n (F b) 2 t <> 0) /\
    forall i, (i < length l)%nat -> fst (nth i brackets (0, 0)) < nth i l 0 < snd (nth i brackets (0, 0)).

(** Version 2, the contact force of the compliant model at one beta: the column is that point, and beside the pieces that give F the sign
    (-1)^floor(beta) there are [level] pieces (t1, t2), on which |F| is at most the level. *)
Definition force_column (F : R -> R -> R) (beta level : R) (tau : range) (c : column) (parts : list (piece + R * R)) : Prop :=
  in_cell c /\ column_low c = Finite beta /\ column_high c = beta /\
  cover (map (fun part => match part with inl p => piece_ends p | inr (t1, t2) => (Finite t1, Finite t2) end) parts)
    (range_from tau) (range_to tau) /\
  forall part, In part parts ->
    match part with
    | inl p => piece_checked F c p /\ piece_sign c p = Some (Nat.even (column_cell c)) /\
        match p with left_piece _ | sign_piece _ _ _ => True | right_piece _ v => v = 0%nat | _ => False end
    | inr (t1, t2) => forall t, t1 <= t <= t2 -> Rabs (F (beta - 1) t) <= level
    end.

(** What is compared with 1: the 3n-th power of (the deviation of the force at this level)/(its mean), beta - 1 = h/n. *)
Definition compared (a1 a2 a3 C1 eps level : R) (h n : nat) : R :=
  (Rabs (C1 / a3) * (a3 / a1) * level / (a2 / (a3 - a1))) ^ (3 * n) * (2 * eps ^ 2 / - a1) ^ h.

(** On the slow manifold the force is positive at every tau of a range and every eps up to eps_0. *)
Definition force_certificate : Prop := forall F a1 a2 a3 C1 eps0 level h n tau c parts, theta_family F ->
  a1 < 0 -> a2 < 0 -> a3 < 0 -> (0 < n)%nat -> a3 / a1 = 1 + INR h / INR n -> not_nat (a3 / a1) -> 1 < a3 / a1 < 5 ->
  0 < eps0 -> 0 < level -> 0 < C1 * Gamma (- (a3 / a1)) -> compared a1 a2 a3 C1 eps0 level h n <= 1 ->
  force_column F (a3 / a1) level tau c parts ->
  forall eps p b y v z t, 0 < eps <= eps0 -> slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) p b y v z ->
    in_range tau (Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3)) -> 0 < linear_force eps (y t) (z t).

(** On the other side it is negative at one tau, for every eps from eps_1 on. *)
Definition lift_off_certificate : Prop := forall F a1 a2 a3 C1 eps1 level h n m tau1, theta_family F ->
  a1 < 0 -> a2 < 0 -> a3 < 0 -> (0 < n)%nat -> a3 / a1 = 1 + INR h / INR n -> INR m < a3 / a1 < INR m + 1 -> 1 < a3 / a1 < 5 ->
  0 < eps1 -> 0 < level -> C1 * Gamma (- (a3 / a1)) < 0 -> 1 <= compared a1 a2 a3 C1 eps1 level h n ->
  level <= signed (Nat.even m) (F (a3 / a1 - 1) tau1) ->
  forall eps p b y v z t, eps1 <= eps -> slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) p b y v z ->
    Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3) = tau1 -> linear_force eps (y t) (z t) < 0.
