(** * What is proved about Theta: definitions and statements

    This file holds no proof. It defines the words and states the theorems; [Theorems.v] proves each statement under the
    same name. Who wants to know what is proved about Theta reads this file alone; [StatementModels.v],
    [StatementCompliant.v], [StatementFlight.v], [StatementCertificate.v] and [StatementChecker.v] go on from here. It
    stands on Coq's real numbers and on Coquelicot: [RInt_gen] (improper Riemann integral), [is_derive], [Derive_n] and
    [ex_derive_n] (derivatives), [is_lim] and [filterlim] (limits), [PSeries] (power series).

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

(** The signs at t = 0 for b in (m - 1, m): the one of Theta(0, b) has the period 3 in m, and is - only if m = 2 mod
    3. *)
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

(** An explicit point, n < b < n + 1: Theta > 0 on (-oo, -x] if x^(3N) 3^N N! > |b (b - 1) ... (b - 3N + 1)|, N =
    floor(n/3) + 1. *)
Definition left_end_explicit : Prop := forall (n : nat) b theta x, INR n < b < INR n + 1 -> is_Theta b theta -> 0 < x ->
  let N := S (n / 3) in
  Rabs (rising (- b) (3 * N)) < x ^ (3 * N) * 3 ^ N * INR (fact N) -> forall t, t <= - x -> 0 < theta t.

(** n < beta < n + 1 and a point T, with s k = Gamma(-b) Theta^(k)(T) for k <= n. If none is negative, Theta has no zero
    on [T, oo); if they change sign once, from <= 0 to >= 0, it has exactly one there, and that is simple. *)
Definition tail_without_zero : Prop := forall (n : nat) b theta T, INR n < b < INR n + 1 -> is_Theta b theta ->
  let s k := Gamma (- b) * Derive_n theta k T in
  (forall k, (k <= n)%nat -> 0 <= s k) -> s 0%nat <> 0 -> forall t, T <= t -> 0 < Gamma (- b) * theta t.

Definition tail_with_one_zero : Prop := forall (n j : nat) b theta T, INR n < b < INR n + 1 -> is_Theta b theta ->
  let s k := Gamma (- b) * Derive_n theta k T in
  (1 <= j <= n + 1)%nat -> (forall k, (k < j)%nat -> s k <= 0) -> (forall k, (j <= k <= n)%nat -> 0 <= s k) ->
    s 0%nat <> 0 ->
  exists z, T < z /\ theta z = 0 /\ Derive theta z <> 0 /\
    (forall t, T <= t < z -> Gamma (- b) * theta t < 0) /\ (forall t, z < t -> 0 < Gamma (- b) * theta t).

(** ** Zeros with multiplicity *)

(** How often the sign changes in a list, zeros left out. *)
Fixpoint first_nonzero (l : list R) : R :=
  match l with
  | [] => 0
  | x :: rest => if Req_EM_T x 0 then first_nonzero rest else x
  end.

Fixpoint variations (l : list R) : nat :=
  match l with
  | [] => 0
  | x :: rest => (if Rlt_dec (x * first_nonzero rest) 0 then 1 else 0) + variations rest
  end.

(** f(t), f'(t), ..., f^(n)(t). *)
Definition derivatives (f : R -> R) (n : nat) (t : R) : list R := map (fun k => Derive_n f k t) (seq 0 (S n)).

(** f has the order m at z: the derivatives of order < m vanish there, the m-th does not (m = 0: no zero). *)
Definition zero_order (f : R -> R) (z : R) (m : nat) : Prop :=
  (forall k, (k < m)%nat -> Derive_n f k z = 0) /\ Derive_n f m z <> 0.

(** l lists the zeros of f at a place, in increasing order, each as often as its order says. *)
Definition zeros_with_multiplicity (f : R -> R) (place : R -> Prop) (l : list R) : Prop :=
  StronglySorted Rle l /\ (forall z, In z l -> place z) /\
  forall z, place z -> zero_order f z (count_occ Req_EM_T l z).

(** There is at most one such list. It holds every zero, it is at least as long as a list of different zeros, and if all
    zeros are simple it is the list of the zeros. *)
Definition list_with_multiplicity : Prop := forall f place l, zeros_with_multiplicity f place l ->
  (forall l', zeros_with_multiplicity f place l' -> l' = l) /\
  (forall z, In z l <-> place z /\ f z = 0) /\
  forall zeros, StronglySorted Rlt zeros ->
    ((forall z, In z zeros -> place z /\ f z = 0) -> (length zeros <= length l)%nat) /\
    ((forall z, In z zeros <-> place z /\ f z = 0) -> (forall z, In z zeros -> Derive f z <> 0) -> l = zeros).

(** The theorem of Budan and Fourier, for a function whose n-th derivative has one sign (that of s) on [T, T']: with
    multiplicity it has in (T, T'] as many zeros as the derivatives lose changes of sign from T to T', less an even
    number. *)
Definition budan_fourier : Prop := forall f n s T T', T <= T' ->
  (forall k t, (k <= n)%nat -> T <= t <= T' -> ex_derive_n f k t) ->
    (forall t, T <= t <= T' -> 0 < s * Derive_n f n t) ->
  exists l j, zeros_with_multiplicity f (fun t => T < t <= T') l /\
    variations (derivatives f n T) = (variations (derivatives f n T') + length l + 2 * j)%nat.

(** n < beta < n + 1, v the changes of sign in s_0, ..., s_n, +, where s_k = Gamma(-b) Theta^(k)(T): with multiplicity
    Theta has v zeros in (T, oo) less an even number, and n + 1 - v in (-oo, T] less an even number. *)
Definition tail_zeros : Prop := forall (n : nat) b theta T, INR n < b < INR n + 1 -> is_Theta b theta ->
  let v := variations (map (fun k => Gamma (- b) * Derive_n theta k T) (seq 0 (S n)) ++ [1]) in
  (exists l j, zeros_with_multiplicity theta (fun t => T < t) l /\ v = (length l + 2 * j)%nat) /\
  (exists l j, zeros_with_multiplicity theta (fun t => t <= T) l /\ (n + 1 = v + length l + 2 * j)%nat).

(** So v = 0 means no zero beyond T, v = 1 exactly one, which is simple; and there are at most v different ones. *)
Definition tail_few_zeros : Prop := forall (n : nat) b theta T, INR n < b < INR n + 1 -> is_Theta b theta ->
  let v := variations (map (fun k => Gamma (- b) * Derive_n theta k T) (seq 0 (S n)) ++ [1]) in
  (v = 0%nat -> forall t, T < t -> theta t <> 0) /\
  (v = 1%nat -> exists z, T < z /\ theta z = 0 /\ Derive theta z <> 0 /\ forall t, T < t -> theta t = 0 -> t = z) /\
  forall zeros, StronglySorted Rlt zeros -> (forall t, In t zeros -> T < t /\ theta t = 0) -> (length zeros <= v)%nat.

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
    forall i, (i < length (negative ++ positive))%nat -> 0 < (-1) ^ i * Derive_n theta 2
      (nth i (negative ++ positive) 0).

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

(** So inside a cell the i-th zero z(beta) has a continuous derivative, - (d/dbeta dTheta/dtau)/(d^2 Theta/dtau^2) at
    the zero. *)
Definition zeros_differentiable : Prop := forall (m i : nat) (Theta : R -> R -> R) (l : R -> list R),
  (i < m mod 3 + m / 3)%nat ->
  (forall b, INR m < b < INR m + 1 -> is_Theta b (Theta b) /\ zeros_of (Derive (Theta b)) (l b)) ->
  let z b := nth i (l b) 0 in
  forall b, INR m < b < INR m + 1 ->
    is_derive z b (- Derive (fun b' => Derive (Theta b') (z b)) b / Derive_n (Theta b) 2 (z b)) /\
      continuous (Derive z) b.

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
  Derive_n theta 2 0 = 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 2 / 3)
    * recip_Gamma (- b / 3) * recip_Gamma ((1 - b) / 3).

(** They single out Theta(., b) off the integers, and P_n at b = n. *)
Definition entire_initial_values : Prop := forall b theta,
  (not_nat b -> (is_Theta b theta <-> is_Theta_entire b theta)) /\
  (forall n : nat, b = INR n -> ((forall t, theta t = Poly n t) <-> is_Theta_entire b theta)).

(** It is the limit of Theta(t, b) as b -> n: "Theta(., n)". At b = n itself t01-t03 divide by a pole. *)
Definition integer_limit : Prop := forall (n : nat) (Theta : R -> R -> R),
  (forall b, not_nat b -> is_Theta b (Theta b)) ->
  forall t, is_lim (fun b => Theta b t) (INR n) (Poly n t).

(** Off the integers Theta is continuous in b. *)
Definition continuity_in_beta : Prop := forall b (Theta : R -> R -> R), not_nat b ->
  (forall b, not_nat b -> is_Theta b (Theta b)) -> forall t, is_lim (fun b => Theta b t) b (Theta b t).

(** dP_n/dt (n >= 1) has floor((n-1)/3) positive zeros, all simple; a zero at 0 of multiplicity (n-1) mod 3; no
    others. *)
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

(** A fold, n = 2 mod 3: on a box that holds (0, n), where F = Theta is convex in t, increases with b and is positive at
    both ends, F has two zeros, both simple, below n, the one zero 0 at n, and none above. *)
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

(** ** Hadamard's finite part; t -> +oo: the saddle point r = sqrt t with an explicit remainder *)

(** Hadamard's finite part, where the Laplace integral diverges at 0: for every x > 0 and every derivative, the sum of
    the terms over (0, x) and the integral over (x, oo). e^(rt - r^3/3) is the sum of (-1)^n P_n(t)/n! r^n. *)
Definition finite_part_integral : Prop := forall b theta k t x, not_nat b -> is_Theta b theta -> 0 < x ->
  let term := fun n => (-1) ^ n * Poly n t / INR (fact n) / (INR n + (INR k - b)) in
  ex_pseries term x /\
  is_lim (fun T => RInt (fun r => Rpower r (INR k - b - 1) * exp (r * t - r ^ 3 / 3)) x T) p_infty
    (Gamma (- b) * Derive_n theta k t - Rpower x (INR k - b) * PSeries term x).

(** g_k = (1/2)_k [u^(2k)] (1 + u)^(-b-1) (1 + u/3)^(-k-1/2). *)
Definition saddle_coefficient (b : R) (k : nat) : R :=
  rising (1 / 2) k * sum_first (fun j => rising (b + 1) (2 * k - j) / INR (fact (2 * k - j))
    * (rising (INR k + 1 / 2) j / (3 ^ j * INR (fact j)))) (S (2 * k)).

(** E_1 + ... + E_4 of proofs/positive.md, lambda = t^(3/2): m is any integer >= - b - 1, and 0 < eta < 1. *)
Definition saddle_error (b lambda eta rho : R) (N m : nat) : R :=
  let sigma := eta * sqrt (1 - eta / 3) in
  let M := (1 + eta) ^ m * Rpower (1 - eta) (- b - 1 - INR m) * (2 - sqrt (1 - eta / 3)) / (1 - eta / 2) in
  let p := Rmax 0 (- b - 1) in
  M * Gamma (INR N + 1 / 2) / (lambda * sigma ^ 2) ^ N / sqrt lambda
    + 2 * M * exp (- (lambda * sigma ^ 2)) / (lambda * sigma)
    + exp (p * sigma - lambda * sigma ^ 2) / (2 * lambda * sigma - p)
    + Rmax 1 (Rpower rho (- b - 1)) * exp (- (lambda * sigma ^ 2)).

(** The integers n next to b stand apart: A holds all with |n - b| < 1/2, so it may be empty if there are none. Their
    coefficients are those of e^(rt - r^3/3), (-1)^n P_n(t)/n! with the polynomials P_n above. *)
Definition saddle_remainder : Prop := forall b theta t eta rho (N m : nat) (A : list nat),
  not_nat b -> is_Theta b theta -> 0 < t -> 0 < eta < 1 -> 0 < rho <= 1 - eta -> - b - 1 <= INR m ->
  NoDup A -> (forall n, ~ In n A -> 1 / 2 <= Rabs (INR n - b)) ->
  let lambda := t * sqrt t in
  let sigma := eta * sqrt (1 - eta / 3) in
  INR (2 * N) <= lambda * sigma ^ 2 -> Rmax 0 (- b - 1) < 2 * lambda * sigma ->
  let near := fun n => (-1) ^ n * Poly n t / INR (fact n) / (INR n - b) * Rpower (rho * sqrt t) (INR n - b) in
  let K := Rpower t (- b / 2) * exp (2 * lambda / 3) in
  Rabs (Gamma (- b) * theta t - fold_right Rplus 0 (map near A)
      - K * (sqrt PI / sqrt lambda * sum_first (fun k => saddle_coefficient b k / lambda ^ k) N))
    <= K * saddle_error b lambda eta rho N m + 2 * Rpower (rho * sqrt t) (- b) * exp (lambda * (rho + rho ^ 3 / 3)).

(** So the series sum g_k lambda^(-k) is asymptotic to Theta, to every order. *)
Definition positive_series : Prop := forall b theta (N : nat), not_nat b -> is_Theta b theta -> exists C T,
  forall t, T <= t -> let lambda := t * sqrt t in
    Rabs (Gamma (- b) * theta t / (Rpower t (- b / 2) * exp (2 * lambda / 3) * (sqrt PI / sqrt lambda))
      - sum_first (fun k => saddle_coefficient b k / lambda ^ k) N) <= C / lambda ^ N.

(** ** Power series in beta *)

(** 1/Gamma is an entire function: one power series, for all x. *)
Definition recip_gamma_entire : Prop := exists a : nat -> R, forall x, is_pseries a x (recip_Gamma x).

(** So is Theta(t, .) for every t, integers included. *)
Definition entire_in_beta : Prop := forall t, exists a : nat -> R, forall b theta, is_Theta_entire b theta ->
  is_pseries a b (theta t).

(** And Theta is an entire function of both: the sum over j of (sum over k of a_jk b^k) t^j, where |a_jk| r^(j+k) is
    bounded for every r. *)
Definition entire_in_both : Prop := exists a : nat -> nat -> R,
  (forall r, exists M, forall j k, Rabs (a j k) * r ^ (j + k) <= M) /\
  forall b theta t, is_Theta_entire b theta -> is_pseries (fun j => PSeries (a j) b) t (theta t).

(** f is the sum of a power series around x0. *)
Definition analytic_at (f : R -> R) (x0 : R) : Prop := exists (a : nat -> R) r, 0 < r /\
  forall x, Rabs (x - x0) < r -> is_pseries a (x - x0) (f x).

(** The Theta of t01-t03 is analytic in b off the integers. *)
Definition analytic_in_beta : Prop := forall b t (Theta : R -> R -> R), not_nat b ->
  (forall b, not_nat b -> is_Theta b (Theta b)) -> analytic_at (fun b => Theta b t) b.

(** Through every simple zero of dTheta/dtau, at an integer b0 too, passes one curve t = z(b) of zeros; it is
    analytic. *)
Definition zero_curve : Prop := forall (Theta : R -> R -> R) t0 b0, (forall b, is_Theta_entire b (Theta b)) ->
  Derive (Theta b0) t0 = 0 -> Derive_n (Theta b0) 2 t0 <> 0 ->
  exists z eps, 0 < eps /\ analytic_at z b0 /\ z b0 = t0 /\
    forall b t, Rabs (b - b0) < eps -> Rabs (t - t0) < eps -> (Derive (Theta b) t = 0 <-> t = z b).

(** Inside a cell the i-th zero is an analytic function of beta. *)
Definition zeros_analytic : Prop := forall (m i : nat) (Theta : R -> R -> R) (l : R -> list R),
  (i < m mod 3 + m / 3)%nat ->
  (forall b, INR m < b < INR m + 1 -> is_Theta b (Theta b) /\ zeros_of (Derive (Theta b)) (l b)) ->
  forall b, INR m < b < INR m + 1 -> analytic_at (fun b => nth i (l b) 0) b.
