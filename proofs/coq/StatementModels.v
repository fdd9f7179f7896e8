(** * What boxes and the steps of the checker rest on: definitions and statements

    This file holds no proof; it is read after [Statement.v], whose words it uses. Each statement is proved in
    [Theorems.v] under the same name. The pages are proofs/check.md, sections 2 to 4, proofs/box.md and
    proofs/majorant.md. *)

From Coq Require Import Reals List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement.
Import ListNotations.
Open Scope R_scope.

(** ** Tails of Taylor series *)

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
Definition derivative_tail : Prop := forall b X B (c : nat -> R) (d K N : nat), 0 <= X -> 1 <= B -> Rabs b <= B ->
  (d <= K)%nat ->
  (forall k, (INR k + 1) * (INR k + 2) * (INR k + 3) * c (k + 3)%nat = (INR k - b) * c k) ->
  let v k := INR (fact k) / INR (fact (k - d)) * Rabs (c k) * X ^ (k - d) in
  let y := INR (K - d) in
  let q := (y + INR d + B) * X ^ 3 / ((y + 1) * (y + 2) * (y + 3)) in
  q < 1 -> sum_first (fun i => v (K + i)%nat) N <= (v K + v (K + 1)%nat + v (K + 2)%nat) / (1 - q).

(** A bound on a whole interval of t and of b, by one value of Theta(., -B) (proofs/majorant.md, real t). M bounds three
    quotients at 0. *)
Definition majorant : Prop := forall b B M X t theta large, is_Theta_entire b theta -> is_Theta_entire (- B) large ->
  Rabs b <= B -> (forall k, (k < 3)%nat -> Rabs (Derive_n theta k 0) <= M * Derive_n large k 0) -> Rabs t <= X ->
  Rabs (theta t) <= M * large X.

(** ** Taylor models on boxes: b = b0 + r eta, t = t0 + s u, |eta| <= 1, |u| <= 1 (proofs/box.md) *)

(** The polynomial with the coefficients m, the sum of their sizes, and a polynomial with an error as a model of
    f(eta). *)
Fixpoint polynomial (m : list R) (x : R) : R :=
  match m with
  | [] => 0
  | a :: rest => a + x * polynomial rest x
  end.

Definition total_size (m : list R) : R := fold_right (fun a sum => Rabs a + sum) 0 m.

Definition is_model (model : list R * R) (f : R -> R) : Prop :=
  forall eta, Rabs eta <= 1 -> Rabs (f eta - polynomial (fst model) eta) <= snd model.

(** The coefficients of (g - r eta)(m_0 + m_1 eta + ...); [before] is 0. *)
Fixpoint times_linear (g r before : R) (m : list R) : list R :=
  match m with
  | [] => [- (r * before)]
  | a :: rest => (g * a - r * before) :: times_linear g r a rest
  end.

(** From a model of a_k to one of a_(k+3) = (k - b) a_k/((k + 1)(k + 2)(k + 3)); the last coefficient goes into the
    error. *)
Definition next_model (b0 r : R) (k : nat) (model : list R * R) : list R * R :=
  let divisor := (INR k + 1) * (INR k + 2) * (INR k + 3) in
  let product := map (fun a => a / divisor) (times_linear (INR k - b0) r 0 (fst model)) in
  (removelast product, (Rabs (INR k - b0) + r) * snd model / divisor + Rabs (last product 0)).

(** Section 4: the sum of i!/(i-d)! f_i u^(i-d), d <= i < I, is s^d Theta^(d)(t0 + s u) up to s^d (W_d + E_d + V_d),
    where W is s^d W_d, if q < 1; at u = 0 without W_d. p_k, e_k, S_k are the P_k, e_k, S_k of the page at one eta. *)
Definition falling (d i : nat) : R := INR (fact i) / INR (fact (i - d)).

Definition shifted (t0 s : R) (c : nat -> R) (K i : nat) : R :=
  sum_first (fun j => Binomial.C (i + j) i * t0 ^ j * s ^ i * c (i + j)%nat) (K - i).

Definition box_estimate (B t0 s : R) (p e S : nat -> R) (d I K : nat) (u value : R) : Prop :=
  let X := Rabs t0 + s in
  let W := sum_first (fun j => falling d (I + j) * shifted (Rabs t0) s S K (I + j)) (K - I) in
  let E := sum_first (fun j => falling d (d + j) * X ^ j * e (d + j)%nat) (K - d) in
  let y := INR (K - d) in
  let q := (INR K + B) * X ^ 3 / ((y + 1) * (y + 2) * (y + 3)) in
  let v k := falling d k * S k * X ^ (k - d) in
  let V := (v K + v (K + 1)%nat + v (K + 2)%nat) / (1 - q) in
  let difference := s ^ d * value - sum_first (fun j => falling d (d + j) * shifted t0 s p K (d + j) * u ^ j) (I - d) in
  q < 1 -> Rabs difference <= W + s ^ d * (E + V) /\ (u = 0 -> (d < I)%nat -> Rabs difference <= s ^ d * (E + V)).

(** At one b: a_k = Theta^(k)(0)/k! is p_k up to e_k for k < K; S bounds |p_k|, and |a_k| for three more. *)
Definition box_remainder : Prop := forall b theta t0 s B (p e S : nat -> R) (d I K : nat) u, is_Theta_entire b theta ->
  0 <= s -> 1 <= B -> Rabs b <= B -> (d <= I)%nat -> (d <= K)%nat -> Rabs u <= 1 ->
  let a k := Derive_n theta k 0 / INR (fact k) in
  (forall k, (k < K)%nat -> Rabs (a k - p k) <= e k /\ Rabs (p k) <= S k) ->
  (forall k, (K <= k < K + 3)%nat -> Rabs (a k) <= S k) ->
  box_estimate B t0 s p e S d I K u (Derive_n theta d (t0 + s * u)).

(** Sections 3 and 4 together, real b: models of Theta, Theta', Theta''/2 at t = 0 give those on the box, S_k = (total
    size of P_k) + e_k. *)
Definition box_model : Prop := forall b0 r (Theta : R -> R -> R) (model : nat -> list R * R) t0 s B (d I K : nat) u eta,
  (forall eta, is_Theta_entire (b0 + r * eta) (Theta eta)) ->
  (forall k, (k < 3)%nat -> is_model (model k) (fun eta => Derive_n (Theta eta) k 0 / INR (fact k))) ->
  (forall k, model (k + 3)%nat = next_model b0 r k (model k)) ->
  0 <= r -> 0 <= s -> 1 <= B -> Rabs b0 + r <= B -> (d <= I)%nat -> (d <= K)%nat -> Rabs u <= 1 -> Rabs eta <= 1 ->
  box_estimate B t0 s (fun k => polynomial (fst (model k)) eta) (fun k => snd (model k))
    (fun k => total_size (fst (model k)) + snd (model k)) d I K u (Derive_n (Theta eta) d (t0 + s * u)).

(** ** Models carried from one point to the next, real b (proofs/check.md, sections 2 to 4) *)

(** The solutions of the equation of Theta; there is exactly one with given values at a point. *)
Definition solution (b : R) (f : R -> R) : Prop :=
  (forall k t, (k <= 3)%nat -> ex_derive_n f k t) /\ forall t, Derive_n f 3 t - t * Derive f t + b * f t = 0.

Definition solution_with_values : Prop := forall b t0 y0 y1 y2, exists f,
  solution b f /\ f t0 = y0 /\ Derive f t0 = y1 /\ Derive_n f 2 t0 = y2 /\
  forall g, solution b g -> g t0 = y0 -> Derive g t0 = y1 -> Derive_n g 2 t0 = y2 -> forall t, g t = f t.

(** a_k = |c_k| s^k for the coefficients c at t0. The last three before n bound what is left out from n on, in F, F' and
    F''/2 (d = 0, 1, 2). *)
Definition three_tails : Prop := forall b t0 s B (c : nat -> R) (n d N : nat), 0 < s -> 1 <= B -> Rabs b + 2 <= B ->
  (d <= 2)%nat -> (5 <= n)%nat ->
  (forall k, (INR k + 1) * (INR k + 2) * (INR k + 3) * c (k + 3)%nat
     = t0 * (INR k + 1) * c (k + 1)%nat + (INR k - b) * c k) ->
  let q := Rabs t0 * s ^ 2 / ((INR (n - 5) + 2) * (INR (n - 5) + 3))
    + (INR (n - 5) + B) * s ^ 3 / ((INR (n - 5) + 1) * (INR (n - 5) + 2) * (INR (n - 5) + 3)) in
  q <= 1 / 2 ->
  let a k := Rabs (c k) * s ^ k in
  sum_first (fun i => Binomial.C (n + i) d * a (n + i)%nat) N
    <= Binomial.C (n - 1) d * (3 * Rmax (a (n - 3)%nat) (Rmax (a (n - 2)%nat) (a (n - 1)%nat))).

(** A step of the recurrence, a_(k+3) = alpha a_(k+1) + (g - r eta) a_k, from models with as many coefficients: each new
    coefficient is rounded by at most one unit, that of the next power of eta is left out. *)
Definition rounded_step : Prop := forall unit alpha g r (x y m : list R) ex ey (f f1 : R -> R), 0 <= r ->
  (0 < length x)%nat -> length y = length x -> length m = length x -> is_model (x, ex) f -> is_model (y, ey) f1 ->
  (forall j, (j < length x)%nat ->
     Rabs (nth j m 0 - (alpha * nth j y 0 + g * nth j x 0 - r * match j with O => 0 | S i => nth i x 0 end)) <= unit) ->
  is_model (m, Rabs alpha * ey + (Rabs g + r) * ex + r * Rabs (last x 0) + INR (length x) * unit)
    (fun eta => alpha * f1 eta + (g - r * eta) * f eta).

(** The series at t0 evaluated at t0 + s u, |u| <= 1: p_k is the k-th coefficient a_k up to e_k, n of them, e_(n-1)
    holds the rest too, S_k is at least |p_k| + e_k; w_j is u^j, rounded by at most j delta. *)
Definition moved_series : Prop := forall b t0 s B f (n d : nat) (p e S w : nat -> R) u delta, solution b f ->
  0 < s -> 1 <= B -> Rabs b + 2 <= B -> (d <= 2)%nat -> (5 <= n)%nat ->
  let q := Rabs t0 * s ^ 2 / ((INR (n - 5) + 2) * (INR (n - 5) + 3))
    + (INR (n - 5) + B) * s ^ 3 / ((INR (n - 5) + 1) * (INR (n - 5) + 2) * (INR (n - 5) + 3)) in
  q <= 1 / 2 -> Rabs u <= 1 ->
  let a k := Derive_n f k t0 / INR (fact k) * s ^ k in
  let rest := 3 * Rmax (Rabs (a (n - 3)%nat)) (Rmax (Rabs (a (n - 2)%nat)) (Rabs (a (n - 1)%nat))) in
  (forall k, (k < n - 1)%nat -> Rabs (a k - p k) <= e k) ->
  Rabs (a (n - 1)%nat - p (n - 1)%nat) + rest <= e (n - 1)%nat ->
  (forall k, (k < n)%nat -> Rabs (p k) + e k <= S k) ->
  0 <= delta -> (forall j, (j < n)%nat -> Rabs (w j - u ^ j) <= INR j * delta) ->
  Rabs (s ^ d * Derive_n f d (t0 + s * u) / INR (fact d)
      - sum_first (fun j => Binomial.C (d + j) d * p (d + j)%nat * w j) (n - d))
    <= sum_first (fun j => Binomial.C (d + j) d * (Rabs (w j) * e (d + j)%nat + INR (d + j) * delta * S (d + j)%nat))
      (n - d).

(** The errors of the values of F at t0, taken as those of G, are multiplied by the sizes of the three solutions E_j
    with unit values. *)
Definition carried_errors : Prop := forall b t0 s (F G : R -> R) (E : nat -> R -> R) (e : nat -> R) (d : nat) t,
  0 < s -> (d <= 2)%nat ->
  solution b F -> solution b G -> (forall j, (j < 3)%nat -> solution b (E j)) ->
  let a f k := Derive_n f k t0 / INR (fact k) * s ^ k in
  (forall i j, (i < 3)%nat -> (j < 3)%nat -> a (E j) i = if Nat.eqb i j then 1 else 0) ->
  (forall j, (j < 3)%nat -> Rabs (a F j - a G j) <= e j) ->
  Rabs (Derive_n F d t - Derive_n G d t) <= sum_first (fun j => e j * Rabs (Derive_n (E j) d t)) 3.

(** On the box |u| <= 1, |eta| <= 1/2: F^(d) is the first coefficient of its first model up to the rest of that one, the
    other terms and the errors; so it has the sign of that coefficient if that is greater. *)
Definition half_size (m : list R) : R := fold_right (fun a sum => Rabs a + sum / 2) 0 m.

Definition box_value : Prop := forall b t0 s B f (n d : nat) (m : nat -> list R) (e : nat -> R) u eta, solution b f ->
  0 < s -> 1 <= B -> Rabs b + 2 <= B -> (d <= 2)%nat -> (5 <= n)%nat ->
  let q := Rabs t0 * s ^ 2 / ((INR (n - 5) + 2) * (INR (n - 5) + 3))
    + (INR (n - 5) + B) * s ^ 3 / ((INR (n - 5) + 1) * (INR (n - 5) + 2) * (INR (n - 5) + 3)) in
  q <= 1 / 2 -> Rabs u <= 1 -> Rabs eta <= 1 / 2 ->
  let a k := Derive_n f k t0 / INR (fact k) * s ^ k in
  let rest := 3 * Rmax (Rabs (a (n - 3)%nat)) (Rmax (Rabs (a (n - 2)%nat)) (Rabs (a (n - 1)%nat))) in
  (forall k, (k < n - 1)%nat -> Rabs (a k - polynomial (m k) eta) <= e k) ->
  Rabs (a (n - 1)%nat - polynomial (m (n - 1)%nat) eta) + rest <= e (n - 1)%nat ->
  Rabs (s ^ d * Derive_n f d (t0 + s * u) / INR (fact d) - hd 0 (m d)) <=
    half_size (tl (m d)) / 2 + sum_first (fun j => Binomial.C (d + 1 + j) d * half_size (m (d + 1 + j)%nat)) (n - d - 1)
    + sum_first (fun j => Binomial.C (d + j) d * e (d + j)%nat) (n - d).
