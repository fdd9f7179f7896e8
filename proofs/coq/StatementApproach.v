(** * What is proved about slip that reaches a G-spot: definitions and statements

    This file holds no proof; it is read after [StatementStep.v], whose words it uses. Each statement is proved in
    [Theorems.v] under the same name. The pages are proofs/approach.md, sections 1 to
    3, and proofs/approach_certificate.md, section 3. *)

From Coq Require Import Reals List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementStep.
Open Scope R_scope.

(** On the box phi is differentiable; d holds its partial derivatives, which are bounded. *)
Definition smooth_on {I : Type} (all : list I) (phi : (I -> R) -> R) (d : I -> (I -> R) -> R)
    (low high : I -> R) : Prop :=
  (forall xi, in_box low high xi -> gradient_at all phi (fun j => d j xi) xi) /\
  exists M, forall xi, in_box low high xi -> forall j, Rabs (d j xi) <= M.

(** The flow xi' = p F - b G on a box, with the partial derivatives of its functions: p' = alpha1 p and b' = alpha2 p +
    alpha3 b along it. *)
Record slip_functions {I : Type} (all : list I) (F G : I -> (I -> R) -> R) (F' G' : I -> I -> (I -> R) -> R)
    (p b : (I -> R) -> R) (p' b' : I -> (I -> R) -> R) (alpha1 alpha2 alpha3 : (I -> R) -> R)
    (low high : I -> R) : Prop := SlipFunctions {
  F_smooth : forall i, smooth_on all (F i) (F' i) low high;
  G_smooth : forall i, smooth_on all (G i) (G' i) low high;
  p_smooth : smooth_on all p p' low high;
  b_smooth : smooth_on all b b' low high;
  alpha1_bounded : exists M, forall xi, in_box low high xi -> Rabs (alpha1 xi) <= M;
  p_along : forall xi, in_box low high xi -> p xi * along all p' F xi - b xi * along all p' G xi = alpha1 xi * p xi;
  b_along : forall xi, in_box low high xi ->
    p xi * along all b' F xi - b xi * along all b' G xi = alpha2 xi * p xi + alpha3 xi * b xi
}.

(** The functions of the paper, Section 2: L_F y = v, L_F v = b, L_F p = alpha1, L_F b = alpha2, L_G y = 0, L_G v = p,
    L_G p = 0, L_G b = - alpha3. (Of the slip functions the last three fields follow.) *)
Record contact_functions {I : Type} (all : list I) (F G : I -> (I -> R) -> R) (F' G' : I -> I -> (I -> R) -> R)
    (y v p b : (I -> R) -> R) (y' v' p' b' : I -> (I -> R) -> R) (alpha1 alpha2 alpha3 : (I -> R) -> R)
    (low high : I -> R) : Prop := ContactFunctions {
  with_slip : slip_functions all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high;
  y_smooth : smooth_on all y y' low high;
  v_smooth : smooth_on all v v' low high;
  along_F : forall xi, in_box low high xi -> along all y' F xi = v xi /\ along all v' F xi = b xi /\
    along all p' F xi = alpha1 xi /\ along all b' F xi = alpha2 xi;
  along_G : forall xi, in_box low high xi -> along all y' G xi = 0 /\ along all v' G xi = p xi /\
    along all p' G xi = 0 /\ along all b' G xi = - alpha3 xi
}.

(** Rigid slip, y = v = 0 and lambda = - b/p > 0, moves as dxi/dt = F + lambda G. With dt = p ds it is dxi/ds = X. *)
Definition slip_flow {I : Type} (F G : I -> (I -> R) -> R) (p b : (I -> R) -> R) (i : I) (xi : I -> R) : R :=
  p xi * F i xi - b xi * G i xi.

(** P bounds the time, B the integral of |b|, rho_i how far a state can move. *)
Definition reach (a1 a3 A2 p b f g : R) : R := f * (p / a1) + g * ((Rabs b + A2 * (p / a1)) / a3).

(** Theorem A1: what is checked. The start lies in a box, from [first] to [last], and N is the box from low to high;
    p1 and b1 bound p and |b| at the start. *)
Record neighbourhood_checked {I : Type} (F G : I -> (I -> R) -> R) (alpha1 alpha2 alpha3 : (I -> R) -> R)
    (first last low high : I -> R) (a1 a3 A2 p1 b1 : R) (f g : I -> R) : Prop := NeighbourhoodChecked {
  a_box : forall i, low i <= high i;
  a1_positive : 0 < a1;
  a3_positive : 0 < a3;
  on_the_box : forall xi, in_box low high xi -> alpha1 xi <= - a1 /\ alpha3 xi <= - a3 /\ Rabs (alpha2 xi) <= A2 /\
    forall i, Rabs (F i xi) <= f i /\ Rabs (G i xi) <= g i;
  room : forall i, low i < first i - reach a1 a3 A2 p1 b1 (f i) (g i) /\
    last i + reach a1 a3 A2 p1 b1 (f i) (g i) < high i
}.

(** lambda stays positive: alpha2 < 0 on N, or alpha3 - alpha1 >= d > 0 and d lambda > alpha2 with the lambda of the
    start. *)
Definition force_stays_positive {I : Type} (alpha1 alpha2 alpha3 : (I -> R) -> R) (low high : I -> R)
    (lambda : R) : Prop :=
  (forall xi, in_box low high xi -> alpha2 xi < 0) \/
  exists d, 0 < d /\ forall xi, in_box low high xi -> d <= alpha3 xi - alpha1 xi /\ alpha2 xi < d * lambda.

(** The solution xi from the start for all s >= 0, the only one. It stays in N with p > 0, and tends to a point of N
    with p = b = 0 that is within rho of the start and, from each s on, within the bound that p and b give there. The
    time that passes is at most P = p1/a1. *)
Record arrival {I : Type} (F G : I -> (I -> R) -> R) (p b : (I -> R) -> R) (low high : I -> R)
    (a1 a3 A2 p1 b1 : R) (f g start : I -> R) (xi : I -> R -> R) (spot : I -> R) (time : R -> R) : Prop := Arrival {
  starts : forall i, xi i 0 = start i;
  moves : forall T, solves (slip_flow F G p b) 1 xi T;
  no_other : forall T other, (forall i, other i 0 = start i) -> solves (slip_flow F G p b) 1 other T ->
    forall i s, 0 <= s <= T -> other i s = xi i s;
  on_the_way : forall s, 0 <= s -> in_box low high (state xi s) /\ 0 < p (state xi s);
  tends : forall i, is_lim (xi i) p_infty (spot i);
  at_the_spot : in_box low high spot /\ p spot = 0 /\ b spot = 0;
  spot_within : forall i, Rabs (spot i - start i) <= reach a1 a3 A2 p1 b1 (f i) (g i);
  nearer : forall s i, 0 <= s ->
    Rabs (xi i s - spot i) <= reach a1 a3 A2 (p (state xi s)) (b (state xi s)) (f i) (g i);
  time_starts : time 0 = 0;
  time_passes : forall s, 0 <= s -> is_derive time s (p (state xi s)) /\ time s <= p1 / a1
}.

(** Theorem A1: from each such start with p > 0 > b the flow arrives; with one more condition lambda > 0 on the whole
    way. With the functions y and v of the paper, 0 at the start, they are 0 on the way and at the end: the motion is
    rigid slip, and the end is a G-spot. *)
Definition capture : Prop := forall (I : Type) (all : list I) F G F' G' p b p' b' alpha1 alpha2 alpha3
  (first last low high : I -> R) a1 a3 A2 p1 b1 f g,
  (forall i, In i all) -> slip_functions all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high ->
  neighbourhood_checked F G alpha1 alpha2 alpha3 first last low high a1 a3 A2 p1 b1 f g ->
  forall start : I -> R, in_box first last start -> 0 < p start <= p1 -> - b1 <= b start < 0 ->
  exists (xi : I -> R -> R) (spot : I -> R) (time : R -> R),
    arrival F G p b low high a1 a3 A2 p1 b1 f g start xi spot time /\
    (force_stays_positive alpha1 alpha2 alpha3 low high (- b start / p start) ->
      forall s, 0 <= s -> 0 < - b (state xi s) / p (state xi s)) /\
    forall y v y' v', contact_functions all F G F' G' y v p b y' v' p' b' alpha1 alpha2 alpha3 low high ->
      y start = 0 -> v start = 0 ->
      (forall s, 0 <= s -> y (state xi s) = 0 /\ v (state xi s) = 0) /\ y spot = 0 /\ v spot = 0.

(** ** The sign of C1, Theorem A6 of proofs/approach_certificate.md *)

(** The value towards which lambda moves. *)
Definition mean_force {I : Type} (alpha1 alpha2 alpha3 : (I -> R) -> R) (xi : I -> R) : R :=
  alpha2 xi / (alpha3 xi - alpha1 xi).

(** Section 3 of approach.md: the distinguished trajectory of a G-spot, as functions xi_ and lambda_ of p on [0, p0].
    (It is analytic at p = 0; that it has a derivative there is what is used.) *)
Record distinguished {I : Type} (F G : I -> (I -> R) -> R) (alpha1 alpha2 alpha3 : (I -> R) -> R) (spot : I -> R)
    (p0 : R) (xi_ : I -> R -> R) (lambda_ : R -> R) : Prop := Distinguished {
  some_p : 0 < p0;
  from_the_spot : forall i, xi_ i 0 = spot i;
  state_in_p : forall p, 0 <= p <= p0 -> forall i,
    is_derive (xi_ i) p ((F i (state xi_ p) + lambda_ p * G i (state xi_ p)) / alpha1 (state xi_ p));
  force_in_p : forall p, 0 <= p <= p0 -> exists rate, is_derive lambda_ p rate /\
    p * rate = (alpha3 (state xi_ p) / alpha1 (state xi_ p) - 1) * lambda_ p
      - alpha2 (state xi_ p) / alpha1 (state xi_ p)
}.

(** C1 = - |alpha1|^beta lim (lambda - lambda_)/p^(beta - 1), both at the same p, with alpha1 and beta at the G-spot;
    p falls to 0 as s grows. *)
Definition C1_of_motion {I : Type} (alpha1 alpha3 : (I -> R) -> R) (p b : (I -> R) -> R) (xi : I -> R -> R)
    (spot : I -> R) (lambda_ : R -> R) (C1 : R) : Prop :=
  let beta := alpha3 spot / alpha1 spot in
  is_lim (fun s => - Rpower (- alpha1 spot) beta * ((- b (state xi s) / p (state xi s) - lambda_ (p (state xi s)))
    / Rpower (p (state xi s)) (beta - 1))) p_infty C1.

(** Theorem A6: what is checked on N and at the state from which Theorem A1 holds. Lambda is the interval from least to
    most; sigma = 1 or -1. *)
Record side_checked {I : Type} (all : list I) (F G : I -> (I -> R) -> R) (alpha1 alpha2 alpha3 : (I -> R) -> R)
    (d1 d3 dl : I -> (I -> R) -> R) (low high start : I -> R) (p b : (I -> R) -> R)
    (kappa least most m sigma : R) : Prop := SideChecked {
  alpha1_smooth : smooth_on all alpha1 d1 low high;
  alpha3_smooth : smooth_on all alpha3 d3 low high;
  mean_smooth : smooth_on all (mean_force alpha1 alpha2 alpha3) dl low high;
  kappa_positive : 0 < kappa;
  between : forall xi, in_box low high xi -> 0 < alpha1 xi - alpha3 xi /\ kappa <= alpha3 xi - 2 * alpha1 xi /\
    least <= mean_force alpha1 alpha2 alpha3 xi <= most;
  mean_moves : forall xi lambda, in_box low high xi -> least <= lambda <= most ->
    Rabs (along all dl F xi + lambda * along all dl G xi) <= m;
  force_between : least <= - b start / p start <= most;
  a_side : sigma = 1 \/ sigma = -1;
  far_enough : m * p start / kappa < sigma * (- b start / p start - mean_force alpha1 alpha2 alpha3 start)
}.

(** 1 < beta < 2: C1 exists, is not 0, and has the sign of - sigma, for the motion of [capture] and any distinguished
    trajectory of its G-spot. *)
Definition sign_of_C1 : Prop := forall (I : Type) (all : list I) F G F' G' p b p' b' alpha1 alpha2 alpha3 d1 d3
  dl (first last low high : I -> R) a1 a3 A2 p1 b1 f g start xi spot time p0 xi_ lambda_ kappa least most m sigma,
  (forall i, In i all) -> slip_functions all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high ->
  neighbourhood_checked F G alpha1 alpha2 alpha3 first last low high a1 a3 A2 p1 b1 f g ->
  arrival F G p b low high a1 a3 A2 p1 b1 f g start xi spot time ->
  side_checked all F G alpha1 alpha2 alpha3 d1 d3 dl low high start p b kappa least most m sigma ->
  distinguished F G alpha1 alpha2 alpha3 spot p0 xi_ lambda_ ->
  exists C1, C1_of_motion alpha1 alpha3 p b xi spot lambda_ C1 /\ sigma * C1 < 0.

(** Theorem A4 without the size, beta < 1: there C1 = |alpha1|^beta lim b/p^beta. *)
Definition C1_below_one {I : Type} (alpha1 alpha3 : (I -> R) -> R) (p b : (I -> R) -> R) (xi : I -> R -> R)
    (spot : I -> R) (C1 : R) : Prop :=
  let beta := alpha3 spot / alpha1 spot in
  is_lim (fun s => Rpower (- alpha1 spot) beta * (b (state xi s) / Rpower (p (state xi s)) beta)) p_infty C1.

(** alpha3 - alpha1 >= d and alpha2 <= A on N, A >= 0, and d lambda > A at the start, so d > 0: C1 exists and is
    negative. *)
Definition negative_C1 : Prop := forall (I : Type) (all : list I) F G F' G' p b p' b' alpha1 alpha2 alpha3 d1 d3
  (first last low high : I -> R) a1 a3 A2 p1 b1 f g start xi spot time d A,
  (forall i, In i all) -> slip_functions all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high ->
  neighbourhood_checked F G alpha1 alpha2 alpha3 first last low high a1 a3 A2 p1 b1 f g ->
  arrival F G p b low high a1 a3 A2 p1 b1 f g start xi spot time ->
  smooth_on all alpha1 d1 low high -> smooth_on all alpha3 d3 low high ->
  0 < p start <= p1 -> - b1 <= b start < 0 -> 0 <= A ->
  (forall xi, in_box low high xi -> d <= alpha3 xi - alpha1 xi /\ alpha2 xi <= A) -> A < d * (- b start / p start) ->
  exists C1, C1_below_one alpha1 alpha3 p b xi spot C1 /\ C1 < 0.
