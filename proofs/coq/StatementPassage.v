(** * What is proved about the way from a state to a G-spot, for all eps at once: definitions and statements

    This file holds no proof; it is read after [StatementStep.v], of which it uses the sums. Each statement is proved in
    [Theorems.v] under its name. The page is proofs/from_state.md, sections 1 to 4, whose letters are used: T = t/eps,
    e = - alpha1 eps, r = sqrt p, h = e/p^(3/2), so e/p = h r. *)

From Coq Require Import Reals List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementStep.
Open Scope R_scope.

(** ** The model system with any springs and damper *)

(** p' = alpha1, b' = alpha2 - alpha3 lambda; the contact has stiffnesses k1, k2 and the damping c, to be divided by
    eps^2, eps^2 and eps. *)
Record model_system : Type := Model { alpha1 : R; alpha2 : R; alpha3 : R; k1 : R; k2 : R; c : R }.

Definition beta_of (M : model_system) : R := alpha3 M / alpha1 M.
(** The mean of the force, the one on the distinguished trajectory. *)
Definition mean_of (M : model_system) : R := alpha2 M / (alpha3 M - alpha1 M).
Definition kappa_of (M : model_system) : R := k1 M * k2 M / (k1 M + k2 M).
Definition g_of (M : model_system) : R := (k1 M + k2 M) / c M.
Definition l_of (M : model_system) : R := k2 M - kappa_of M.

Record motion : Type := Motion { p : R -> R; b : R -> R; y : R -> R; v : R -> R; z : R -> R }.

(** The force in contact, and the same with lift-off: 0 unless y < z. *)
Definition spring_force (M : model_system) (eps : R) (x : motion) (t : R) : R := k2 M * (z x t - y x t) / eps ^ 2.
Definition force_with_lift_off (M : model_system) (eps : R) (x : motion) (t : R) : R :=
  if Rlt_dec (y x t) (z x t) then spring_force M eps x t else 0.

Definition moves_by (M : model_system) (eps : R) (force : model_system -> R -> motion -> R -> R) (x : motion)
    (t : R) : Prop :=
  is_derive (p x) t (alpha1 M) /\
  is_derive (b x) t (alpha2 M - alpha3 M * force M eps x t) /\
  is_derive (y x) t (v x t) /\
  is_derive (v x) t (b x t + p x t * force M eps x t) /\
  is_derive (fun s => c M * eps * z x s) t (- (k1 M * z x t) - eps ^ 2 * force M eps x t).

Definition contact_positive (M : model_system) : Prop := 0 < k1 M /\ 0 < k2 M /\ 0 < c M.

(** ** Good coordinates (section 1) *)

(** L = Lambda - mean with the force Lambda = - b/p of rigid slip; W = V'; Y = y/eps^2. *)
Definition L_at (M : model_system) (x : motion) (t : R) : R := - b x t / p x t - mean_of M.
Definition V_at (eps : R) (x : motion) (t : R) : R := v x t / eps.
Definition W_at (M : model_system) (eps : R) (x : motion) (t : R) : R := b x t + p x t * spring_force M eps x t.
Definition phi_at (M : model_system) (eps : R) (x : motion) (t : R) : R :=
  spring_force M eps x t - mean_of M + kappa_of M * (y x t / eps ^ 2 - - mean_of M / kappa_of M)
    + l_of M / g_of M * V_at eps x t.

(** The derivative of f in T = t/eps. *)
Definition rate_in_T (eps : R) (f : R -> R) (t f' : R) : Prop := is_derive f t (f' / eps).

(** The Proposition: the exact equations (2). *)
Definition good_coordinates : Prop := forall M eps x t, contact_positive M -> 0 < eps ->
  alpha1 M <> 0 -> alpha3 M <> alpha1 M -> p x t <> 0 -> moves_by M eps spring_force x t ->
  let hr := - alpha1 M * eps / p x t in
  rate_in_T eps (L_at M x) t (- hr * ((beta_of M - 1) * L_at M x t + beta_of M * W_at M eps x t / p x t)) /\
  rate_in_T eps (V_at eps x) t (W_at M eps x t) /\
  rate_in_T eps (W_at M eps x) t (- kappa_of M * p x t * V_at eps x t - g_of M * p x t * phi_at M eps x t
    + hr * (beta_of M - 1) * (W_at M eps x t + p x t * L_at M x t)) /\
  rate_in_T eps (phi_at M eps x) t (- g_of M * phi_at M eps x t + l_of M / g_of M * W_at M eps x t).

(** L, V, W, phi and p determine the state. *)
Definition coordinates_determine : Prop := forall M eps x x' t, contact_positive M -> 0 < eps -> p x t <> 0 ->
  p x t = p x' t -> L_at M x t = L_at M x' t -> V_at eps x t = V_at eps x' t -> W_at M eps x t = W_at M eps x' t ->
  phi_at M eps x t = phi_at M eps x' t ->
  b x t = b x' t /\ y x t = y x' t /\ v x t = v x' t /\ z x t = z x' t.

(** ** Polynomials in h and r (section 2) *)

(** coefficient * h^by_h * r^by_r. *)
Record one_term : Type := Term { coefficient : R; by_h : nat; by_r : nat }.
Definition monomials : Type := list one_term.

Definition monomial (a : one_term) (h r : R) : R := h ^ by_h a * r ^ by_r a.
Definition value_of (F : monomials) (h r : R) : R := total F (fun a => coefficient a * monomial a h r).
(** The absolute values, coefficient by coefficient. *)
Definition size (F : monomials) (h r : R) : R := total F (fun a => Rabs (coefficient a) * monomial a h r).
(** - p d/dp of h^i r^n is E h^i r^n. *)
Definition E_of (a : one_term) : R := (3 * INR (by_h a) - INR (by_r a)) / 2.
(** F' = dF/dT, from r' = - h r^2/2 and h' = 3 h^2 r/2. *)
Definition change (F : monomials) (h r : R) : R :=
  h * r * total F (fun a => coefficient a * E_of a * monomial a h r).

(** The slow part: V = L v, W = L r^2 w, phi = L r^2 f up to the deviation. *)
Record slow_part : Type := SlowPart { slow_v : monomials; slow_w : monomials; slow_f : monomials }.

(** D F = F' - hr((beta - 1) + beta w) F. *)
Definition D_along (M : model_system) (P : slow_part) (F : monomials) (h r : R) : R :=
  change F h r - h * r * ((beta_of M - 1) + beta_of M * value_of (slow_w P) h r) * value_of F h r.

(** The residuals (3). *)
Definition r_V (M : model_system) (P : slow_part) (h r : R) : R :=
  r ^ 2 * value_of (slow_w P) h r - D_along M P (slow_v P) h r.
Definition r_W (M : model_system) (P : slow_part) (h r : R) : R :=
  r ^ 2 * (h * r * (beta_of M - 1) * (1 + value_of (slow_w P) h r) - g_of M * r ^ 2 * value_of (slow_f P) h r
    - (D_along M P (slow_w P) h r - h * r * value_of (slow_w P) h r) - kappa_of M * value_of (slow_v P) h r).
Definition r_phi (M : model_system) (P : slow_part) (h r : R) : R :=
  r ^ 2 * (l_of M / g_of M * value_of (slow_w P) h r - g_of M * value_of (slow_f P) h r
    - (D_along M P (slow_f P) h r - h * r * value_of (slow_f P) h r)).

(** ** The fast deviation and its norm (section 3) *)

Record vector : Type := Vector { first : R; second : R; third : R }.

Definition r_at (x : motion) (t : R) : R := sqrt (p x t).
Definition h_at (M : model_system) (eps : R) (x : motion) (t : R) : R := - alpha1 M * eps / (p x t * sqrt (p x t)).

Definition deviation_at (M : model_system) (P : slow_part) (eps : R) (x : motion) (t : R) : vector :=
  let h := h_at M eps x t in let r := r_at x t in
  Vector (r * (V_at eps x t - L_at M x t * value_of (slow_v P) h r))
    (W_at M eps x t - L_at M x t * r ^ 2 * value_of (slow_w P) h r)
    (r * (phi_at M eps x t - L_at M x t * r ^ 2 * value_of (slow_f P) h r)).

Definition rest_at (M : model_system) (P : slow_part) (h r : R) : vector :=
  Vector (r * r_V M P h r) (r_W M P h r) (r * r_phi M P h r).

(** B x. *)
Definition B_times (M : model_system) (P : slow_part) (h r : R) (x : vector) : vector :=
  Vector (- (h * r / 2) * first x + (r + beta_of M * h * value_of (slow_v P) h r) * second x)
    (- (kappa_of M * r) * first x + h * r * (beta_of M - 1 + beta_of M * value_of (slow_w P) h r) * second x
      - g_of M * r * third x)
    ((l_of M / g_of M * r + beta_of M * h * r ^ 2 * value_of (slow_f P) h r) * second x
      + (- g_of M - h * r / 2) * third x).

(** (4): x' = B x + L R. *)
Definition deviation_moves : Prop := forall M P eps x t, contact_positive M -> 0 < eps ->
  alpha1 M <> 0 -> alpha3 M <> alpha1 M -> 0 < p x t -> moves_by M eps spring_force x t ->
  let h := h_at M eps x t in let r := r_at x t in let X := deviation_at M P eps x in
  rate_in_T eps (fun s => first (X s)) t (first (B_times M P h r (X t)) + L_at M x t * first (rest_at M P h r)) /\
  rate_in_T eps (fun s => second (X s)) t (second (B_times M P h r (X t)) + L_at M x t * second (rest_at M P h r)) /\
  rate_in_T eps (fun s => third (X s)) t (third (B_times M P h r (X t)) + L_at M x t * third (rest_at M P h r)).

(** The matrix [[kappa, m, 0], [m, 1, n], [0, n, g^2/l]] has entries m and n with two numbers, and h, r. *)
Record weights : Type := Weights { at_m : R; at_n : R }.
Definition m_entry (M : model_system) (K : weights) (h r : R) : R :=
  at_m K * (l_of M / g_of M) * r - (beta_of M - 1 / 2) / 2 * h.
Definition n_entry (K : weights) (r : R) : R := - at_n K * r.

(** x^T M y. *)
Definition product_M (M : model_system) (K : weights) (h r : R) (x y : vector) : R :=
  kappa_of M * first x * first y + m_entry M K h r * (first x * second y + second x * first y) + second x * second y
    + n_entry K r * (second x * third y + third x * second y) + g_of M ^ 2 / l_of M * third x * third y.

(** |x|. *)
Definition norm (M : model_system) (K : weights) (h r : R) (x : vector) : R := sqrt (product_M M K h r x x).

(** Bounds of |m| and |n| for h <= h1, r <= r1, and the number d of (5). *)
Definition d_of (M : model_system) (K : weights) (h1 r1 : R) : R :=
  1 - Rmax (at_m K * (l_of M / g_of M) * r1) ((beta_of M - 1 / 2) / 2 * h1) ^ 2 / kappa_of M
    - (at_n K * r1) ^ 2 * l_of M / g_of M ^ 2.

Definition weights_good (M : model_system) (K : weights) : Prop :=
  contact_positive M /\ 1 / 2 <= beta_of M /\ 0 <= at_m K /\ 0 <= at_n K.

(** (5): the shares. *)
Definition shares : Prop := forall M K h r h1 r1 x, weights_good M K -> 0 <= h <= h1 -> 0 <= r <= r1 ->
  0 < d_of M K h1 r1 ->
  0 <= product_M M K h r x x /\
  Rabs (first x) <= norm M K h r x / sqrt (kappa_of M * d_of M K h1 r1) /\
  Rabs (second x) <= norm M K h r x / sqrt (d_of M K h1 r1) /\
  Rabs (third x) <= sqrt (l_of M / d_of M K h1 r1) * norm M K h r x / g_of M.

(** x^T (M B + B^T M + M') x. *)
Definition growth_form (M : model_system) (P : slow_part) (K : weights) (h r : R) (x : vector) : R :=
  2 * product_M M K h r x (B_times M P h r x)
    + 2 * (at_m K * (l_of M / g_of M) * (- (h * r ^ 2) / 2) - (beta_of M - 1 / 2) / 2 * (3 / 2 * h ^ 2 * r))
      * (first x * second x)
    + 2 * (- at_n K * (- (h * r ^ 2) / 2)) * (second x * third x).

(** What Lemma 1 supposes, x^T N x >= 0: the rate of growth is Gamma_E hr less theta r^2. *)
Definition growth_checked (M : model_system) (P : slow_part) (K : weights) (Gamma_E theta h1 r1 : R) : Prop :=
  forall h r x, 0 < h <= h1 -> 0 < r <= r1 ->
    growth_form M P K h r x <= 2 * (h * r * Gamma_E - theta * r ^ 2) * product_M M K h r x x.

(** The motion is on the rectangle at t, and the norm is one there. *)
Definition on_rectangle (M : model_system) (K : weights) (eps : R) (x : motion) (h1 r1 t : R) : Prop :=
  weights_good M K /\ 0 < d_of M K h1 r1 /\ alpha1 M < 0 /\ alpha3 M <> alpha1 M /\ 0 < eps /\ 0 < p x t /\
  h_at M eps x t <= h1 /\ r_at x t <= r1.

(** |x| along a motion, and |R|. *)
Definition deviation_length (M : model_system) (P : slow_part) (K : weights) (eps : R) (x : motion) (t : R) : R :=
  norm M K (h_at M eps x t) (r_at x t) (deviation_at M P eps x t).
Definition rest_length (M : model_system) (P : slow_part) (K : weights) (h r : R) : R := norm M K h r (rest_at M P h r).

(** Lemma 1, where |x| is not 0. *)
Definition deviation_grows : Prop := forall M P K Gamma_E theta h1 r1 eps x t,
  growth_checked M P K Gamma_E theta h1 r1 -> on_rectangle M K eps x h1 r1 t -> moves_by M eps spring_force x t ->
  0 < deviation_length M P K eps x t ->
  let h := h_at M eps x t in let r := r_at x t in
  exists rate, rate_in_T eps (deviation_length M P K eps x) t rate /\
    rate <= (h * r * Gamma_E - theta * r ^ 2) * deviation_length M P K eps x t
      + Rabs (L_at M x t) * rest_length M P K h r.

(** ** The inequality (6) *)

(** z = |x|/(p|L|). *)
Definition ratio (M : model_system) (P : slow_part) (K : weights) (eps : R) (x : motion) (t : R) : R :=
  deviation_length M P K eps x t / (p x t * Rabs (L_at M x t)).

Definition c_W (M : model_system) (K : weights) (h1 r1 : R) : R := / sqrt (d_of M K h1 r1).

(** The source bounds |R|/e, by the residuals. *)
Definition source_of (M : model_system) (P : slow_part) (source : monomials) (h1 r1 : R) : Prop :=
  forall h r, 0 < h <= h1 -> 0 < r <= r1 ->
    sqrt (kappa_of M) * Rabs (r_V M P h r) / (h * r ^ 2) + Rabs (r_W M P h r) / (h * r ^ 3)
      + g_of M / sqrt (l_of M) * Rabs (r_phi M P h r) / (h * r ^ 2) <= value_of source h r.

(** - p dz/dp is d/dT over hr. *)
Definition rate_in_p (M : model_system) (eps : R) (x : motion) (f : R -> R) (t f' : R) : Prop :=
  rate_in_T eps f t (h_at M eps x t * r_at x t * f').

Definition ratio_grows : Prop := forall M P K Gamma_E theta source h1 r1 eps x t,
  growth_checked M P K Gamma_E theta h1 r1 -> source_of M P source h1 r1 ->
  on_rectangle M K eps x h1 r1 t -> moves_by M eps spring_force x t ->
  L_at M x t <> 0 -> 0 < ratio M P K eps x t ->
  let h := h_at M eps x t in let r := r_at x t in let z := ratio M P K eps x t in
  exists rate, rate_in_p M eps x (ratio M P K eps x) t rate /\
    rate <= (Gamma_E + beta_of M + beta_of M * value_of (slow_w P) h r + beta_of M * c_W M K h1 r1 * z - theta * r / h)
      * z + value_of source h r.

(** (7): C = - L p^(1 - beta), the paper's C1 of rigid slip, moves by what w and z allow; the sign of d/dp is turned. *)
Definition C_at (M : model_system) (x : motion) (t : R) : R := - L_at M x t * Rpower (p x t) (1 - beta_of M).

Definition drift_of_C1 : Prop := forall M P K h1 r1 eps x t,
  on_rectangle M K eps x h1 r1 t -> moves_by M eps spring_force x t -> L_at M x t <> 0 ->
  exists rate, rate_in_p M eps x (fun s => ln (Rabs (C_at M x s))) t rate /\
    Rabs (rate + beta_of M * value_of (slow_w P) (h_at M eps x t) (r_at x t))
      <= beta_of M * c_W M K h1 r1 * ratio M P K eps x t.

(** ** Theorem B (section 4) *)

(** (9): monomials that pay for c h^i r^n, each no less than needed. *)
Inductive pays (Gamma theta : R) : one_term -> monomials -> Prop :=
  | at_once a A : Gamma < E_of a -> coefficient a / (E_of a - Gamma) <= A ->
      pays Gamma theta a (Term A (by_h a) (by_r a) :: nil)
  | by_damping c i n A : c / theta <= A -> Gamma <= E_of (Term A (S i) n) ->
      pays Gamma theta (Term c i (S n)) (Term A (S i) n :: nil)
  | by_both c i n A deficit Z : c / theta <= A -> E_of (Term A (S i) n) < Gamma ->
      (Gamma - E_of (Term A (S i) n)) * A <= deficit -> pays Gamma theta (Term deficit (S i) n) Z ->
      pays Gamma theta (Term c i (S n)) (Term A (S i) n :: Z).

Inductive all_paid (Gamma theta : R) : monomials -> monomials -> Prop :=
  | nothing : all_paid Gamma theta nil nil
  | one_more a source Z Z' : 0 <= coefficient a -> pays Gamma theta a Z -> all_paid Gamma theta source Z' ->
      all_paid Gamma theta (a :: source) (Z ++ Z').

(** I, and where p is when h = h1. *)
Definition layer (Gamma theta z0 p1 e p : R) : R :=
  z0 * Rpower (p1 / p) Gamma * exp (- (theta * (p1 ^ 2 - p ^ 2) / (2 * e))).
Definition p_at_h (e h : R) : R := Rpower (e / h) (2 / 3).

(** The numbers of a certificate, beside model and slow part: starts at p1 with L = L1 and z <= z0, e <= e0. *)
Record numbers : Type := Numbers { p1 : R; L1 : R; z0 : R; e0 : R; h1 : R; r1 : R; Gamma_E : R; theta : R;
  Gamma : R; z_max : R; w_plus : R; w_minus : R }.

(** What Theorem B supposes. W_star = c_W z_max. *)
Record passage_checked (M : model_system) (P : slow_part) (K : weights) (N : numbers) (source Z : monomials) : Prop :=
  PassageChecked {
  of_model : contact_positive M /\ alpha1 M < 0 /\ alpha2 M < 0 /\ 1 < beta_of M /\ 0 <= at_m K /\ 0 <= at_n K;
  of_start : 0 < p1 N /\ 0 <= z0 N /\ 0 < e0 N /\ sqrt (p1 N) <= r1 N /\ p_at_h (e0 N) (h1 N) < p1 N;
  of_rectangle : 0 < h1 N /\ 0 < theta N /\ 0 < d_of M K (h1 N) (r1 N);
  lemma_1 : growth_checked M P K (Gamma_E N) (theta N) (h1 N) (r1 N);
  of_source : source_of M P source (h1 N) (r1 N);
  of_w : forall h r, 0 < h <= h1 N -> 0 < r <= r1 N -> - w_minus N <= value_of (slow_w P) h r <= w_plus N;
  of_rate : Gamma_E N + beta_of M + beta_of M * w_plus N + beta_of M * c_W M K (h1 N) (r1 N) * z_max N <= Gamma N;
  barrier : all_paid (Gamma N) (theta N) source Z;
  below : value_of Z (h1 N) (r1 N)
    + Rmax (z0 N) (layer (Gamma N) (theta N) (z0 N) (p1 N) (e0 N) (p_at_h (e0 N) (h1 N))) < z_max N;
  fading : 2 * Gamma N / 3 < theta N * p1 N ^ 2 / (2 * e0 N);
  of_sign : let W_star := c_W M K (h1 N) (r1 N) * z_max N in
    (0 < L1 N /\ w_minus N + W_star < 1) \/
    (L1 N < 0 /\ beta_of M * (w_minus N + W_star) < beta_of M - 1 /\ - L1 N * (1 + w_plus N + W_star) < mean_of M)
}.

(** A motion of the mechanism from such a start at t0, up to a time t1 at which h <= h1; e <= e0. *)
Definition passes (M : model_system) (P : slow_part) (K : weights) (N : numbers) (eps : R) (x : motion)
    (t0 t1 : R) : Prop :=
  0 < eps /\ - alpha1 M * eps <= e0 N /\ t0 <= t1 /\
  p x t0 = p1 N /\ L_at M x t0 = L1 N /\ ratio M P K eps x t0 <= z0 N /\
  (forall t, t0 <= t <= t1 -> moves_by M eps force_with_lift_off x t) /\ 0 < p x t1 /\ h_at M eps x t1 <= h1 N.

(** Theorem B, for every such eps: contact lasts, L has kept its sign, and z is below the barrier. *)
Definition passage : Prop := forall M P K N source Z eps x t0 t1,
  passage_checked M P K N source Z -> passes M P K N eps x t0 t1 ->
  forall t, t0 <= t <= t1 -> y x t < z x t /\ 0 < L1 N * L_at M x t /\
    ratio M P K eps x t <= value_of Z (h_at M eps x t) (r_at x t)
      + layer (Gamma N) (theta N) (z0 N) (p1 N) (- alpha1 M * eps) (p x t).

(** The integrals of |c| h^i r^n dp/p, E > 0, from their end; and A h^i r^n without the powers of r that make E <= 0. *)
Definition integral_at (F : monomials) (h r : R) : R :=
  total F (fun a => Rabs (coefficient a) / E_of a * monomial a h r).
Definition kept (r1 : R) (a : one_term) : one_term := let n := Nat.min (by_r a) (3 * by_h a - 1) in
  Term (coefficient a * r1 ^ (by_r a - n)) (by_h a) n.

(** (11) and (12): what C can have changed by, up to h = h1; p_S is p there for e = e0. *)
Definition passage_drift : Prop := forall M P K N source Z eps x t0 t1 fall,
  passage_checked M P K N source Z -> passes M P K N eps x t0 t1 ->
  (forall a, In a (slow_w P) -> 0 < E_of a) -> (forall a, In a Z -> (1 <= by_h a)%nat) ->
  let p_S := p_at_h (e0 N) (h1 N) in
  fall = theta N * (p1 N ^ 2 - p_S ^ 2) / (2 * e0 N) / Rmax (ln (p1 N / p_S)) (2 / 3) - Gamma N -> 0 < fall ->
  forall t, t0 <= t <= t1 -> Rabs (ln (Rabs (C_at M x t)) - ln (Rabs (C_at M x t0)))
    <= beta_of M * (integral_at (slow_w P) (h1 N) (sqrt p_S)
      + c_W M K (h1 N) (r1 N) * (z0 N / fall + integral_at (map (kept (r1 N)) Z) (h1 N) (sqrt p_S))).

(** (8): a bound of z at a start. *)
Definition start_bound (M : model_system) (P : slow_part) (eta e0 p1 : R) : R :=
  let r := sqrt p1 in let h := e0 / (p1 * sqrt p1) in
  3 * eta + sqrt (kappa_of M) * size (slow_v P) h r / r + size (slow_w P) h r
    + g_of M / sqrt (l_of M) * r * size (slow_f P) h r.

(** Starts near the slow part have z <= z0, for every e <= e0. *)
Definition start_ratio : Prop := forall M P K h1 r1 eta e0 eps x t,
  weights_good M K -> 0 < d_of M K h1 r1 -> alpha1 M < 0 -> 0 < eps -> 0 < p x t ->
  e0 / (p x t * sqrt (p x t)) <= h1 -> sqrt (p x t) <= r1 -> - alpha1 M * eps <= e0 -> L_at M x t <> 0 ->
  sqrt (kappa_of M) * Rabs (V_at eps x t) <= eta * sqrt (p x t) * Rabs (L_at M x t) ->
  Rabs (W_at M eps x t) <= eta * p x t * Rabs (L_at M x t) ->
  g_of M / sqrt (l_of M) * Rabs (phi_at M eps x t) <= eta * sqrt (p x t) * Rabs (L_at M x t) ->
  ratio M P K eps x t <= start_bound M P eta e0 (p x t).
