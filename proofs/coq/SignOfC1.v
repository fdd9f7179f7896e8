(** * The sign of C1: Theorem A6 of proofs/approach_certificate.md

    u = sigma (lambda - l)/p solves u' = (alpha3 - 2 alpha1) u - sigma (L_F l + lambda L_G l): once above m/kappa it
    grows at least like e^(kappa s) ([grows]). So V = ln u + (2 - beta) ln p, whose rate is alpha3 - beta alpha1 -
    sigma (...)/u, has a rate below a multiple of e^(- q s), and a limit ([V_limit]): e^V = sigma (lambda - l)
    p^(1 - beta) has a positive one. lambda_ - l is at most a multiple of p, so its part tends to 0 like p^(2 - beta)
    ([sign_of_C1]). Theorem A2 and its Gronwall estimate are not needed. *)

From Coq Require Import Reals Psatz Lra Lia List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus NonnegativeOrthant LogarithmicNorm SmoothFunctions Capture StatementStep
  StatementApproach.
Import ListNotations.
Open Scope R_scope.

(** ** Limits *)

Lemma exp_decays A q eps : 0 <= A -> 0 < q -> 0 < eps ->
  exists S, 0 <= S /\ forall s, S <= s -> A * exp (- (q * s)) < eps.
Proof.
intros HA Hq He. exists (A / (q * eps)). assert (Hqe : 0 < q * eps) by (apply Rmult_lt_0_compat; auto). split.
{ apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat, Hqe]. }
intros s Hs. rewrite exp_Ropp. assert (E := exp_ineq1_le (q * s)). assert (Ep := exp_pos (q * s)).
apply Rmult_lt_reg_r with (exp (q * s)); auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
apply (Rmult_le_compat_r (q * eps)) in Hs; [|lra]. replace (A / (q * eps) * (q * eps)) with A in Hs
  by (field; split; lra).
assert (eps * (1 + q * s) <= eps * exp (q * s)) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma limit_of_decaying (x x' : R -> R) A q : 0 <= A -> 0 < q -> (forall s, 0 <= s -> is_derive x s (x' s)) ->
  (forall s, 0 <= s -> Rabs (x' s) <= A * exp (- (q * s))) -> exists l : R, is_lim x p_infty l.
Proof.
intros HA Hq D H. assert (HAq : 0 <= A / q) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat, Hq]).
assert (DE : forall sg s, 0 <= s -> is_derive (fun s => sg * x s + A / q * exp (- (q * s))) s
  (sg * x' s - A * exp (- (q * s)))).
{ intros sg s Hs. eapply is_derive_val.
  - apply (is_derive_plus (fun s => sg * x s) (fun s => A / q * exp (- (q * s)))).
    apply (is_derive_scal x s sg), D, Hs. auto_derive; auto.
  - unfold plus; simpl. field. lra. }
assert (C : forall s t, 0 <= s -> s <= t -> Rabs (x t - x s) <= A / q * exp (- (q * s))).
{ intros s t Hs Hst. assert (Ep := exp_pos (- (q * t))).
  assert (Q : forall sg, sg = 1 \/ sg = -1 -> sg * x t + A / q * exp (- (q * t)) <= sg * x s + A / q * exp (- (q * s))).
  { intros sg Hsg. apply (decr_of_derive (fun s => sg * x s + A / q * exp (- (q * s)))
      (fun s => sg * x' s - A * exp (- (q * s))) s t Hst).
    - intros r Hr. apply DE. lra.
    - intros r Hr. specialize (H r ltac:(lra)). apply Rabs_le_between in H. destruct Hsg as [-> | ->]; lra. }
  assert (Q1 := Q 1 (or_introl eq_refl)). assert (Q2 := Q (-1) (or_intror eq_refl)).
  assert (0 <= A / q * exp (- (q * t))) by (apply Rmult_le_pos; lra). apply Rabs_le. lra. }
eexists. apply (limit_of_tail x (fun s => A / q * exp (- (q * s))) C).
intros eps He. apply exp_decays; auto.
Qed.

Lemma u_derive (q z l : R -> R) (q' z' l' sg s : R) : is_derive q s q' -> is_derive z s z' -> is_derive l s l' ->
  q s <> 0 -> is_derive (fun s => sg * (- z s / q s - l s) / q s) s
    (sg * ((- z' * q s + z s * q') / (q s * q s) - l') / q s - sg * (- z s / q s - l s) * q' / (q s * q s)).
Proof.
intros D1 D2 D3 N. auto_derive. { repeat split; auto; eexists; eassumption. }
assert (E1 : Derive (fun s => q s) s = q') by exact (is_derive_unique _ _ _ D1).
assert (E2 : Derive (fun s => z s) s = z') by exact (is_derive_unique _ _ _ D2).
assert (E3 : Derive (fun s => l s) s = l') by exact (is_derive_unique _ _ _ D3). rewrite E1, E2, E3. field. auto.
Qed.

Lemma ln_derive (u q : R -> R) (u' q' k s : R) : is_derive u s u' -> is_derive q s q' -> 0 < u s -> 0 < q s ->
  is_derive (fun s => ln (u s) + k * ln (q s)) s (u' / u s + k * (q' / q s)).
Proof.
intros D1 D2 P1 P2. auto_derive. { repeat split; auto; eexists; eassumption. }
assert (E1 : Derive (fun s => u s) s = u') by exact (is_derive_unique _ _ _ D1).
assert (E2 : Derive (fun s => q s) s = q') by exact (is_derive_unique _ _ _ D2). rewrite E1, E2. field. lra.
Qed.

Section Side.
Variables (I : Type) (all : list I) (F G : I -> (I -> R) -> R) (F' G' : I -> I -> (I -> R) -> R).
Variables (p b : (I -> R) -> R) (p' b' : I -> (I -> R) -> R) (alpha1 alpha2 alpha3 : (I -> R) -> R).
Variables (d1 d3 dl : I -> (I -> R) -> R) (first last low high : I -> R) (a1 a3 A2 p1 b1 : R) (f g start : I -> R).
Variables (xi : I -> R -> R) (spot : I -> R) (time : R -> R) (p0 : R) (xi_ : I -> R -> R) (lambda_ : R -> R).
Variables (kappa least most m sigma : R).
Hypothesis Hall : forall i, In i all.
Hypothesis HC : slip_functions all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high.
Hypothesis HN : neighbourhood_checked F G alpha1 alpha2 alpha3 first last low high a1 a3 A2 p1 b1 f g.
Hypothesis HA : arrival F G p b low high a1 a3 A2 p1 b1 f g start xi spot time.
Hypothesis HS : side_checked all F G alpha1 alpha2 alpha3 d1 d3 dl low high start p b kappa least most m sigma.
Hypothesis HD : distinguished F G alpha1 alpha2 alpha3 spot p0 xi_ lambda_.

Let P s := p (state xi s).
Let B s := b (state xi s).
Let ell := mean_force alpha1 alpha2 alpha3.
Let L s := ell (state xi s).
Let lam s := - B s / P s.
Let al1 s := alpha1 (state xi s).
Let al3 s := alpha3 (state xi s).
Let moved s := along all dl F (state xi s) + lam s * along all dl G (state xi s).

Lemma inside_N s : 0 <= s -> in_box low high (state xi s).
Proof. intros Hs. apply (on_the_way _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA s Hs). Qed.

Lemma P_positive s : 0 <= s -> 0 < P s.
Proof. intros Hs. apply (on_the_way _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA s Hs). Qed.

Lemma motion i s : 0 <= s -> is_derive (xi i) s (slip_flow F G p b i (state xi s)).
Proof.
intros Hs. eapply is_derive_val; [apply (moves _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA s i s); lra|].
unfold state. ring.
Qed.

Lemma P_moves s : 0 <= s -> is_derive P s (al1 s * P s).
Proof.
intros Hs. apply (P_rate I all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high Hall HC s); try lra.
- intros i t Ht. apply motion, Ht.
- intros t Ht. apply inside_N, Ht.
Qed.

Lemma signs s : 0 <= s -> al1 s <= - a1 /\ al3 s <= - a3 /\ 0 < al1 s - al3 s /\ kappa <= al3 s - 2 * al1 s /\
  least <= L s <= most /\ alpha2 (state xi s) = L s * (al3 s - al1 s).
Proof.
intros Hs. assert (Hi := inside_N s Hs). destruct (on_the_box _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN _ Hi) as (H1 & H3 & _).
destruct (between _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HS _ Hi) as (H4 & H5 & H6).
repeat (split; [assumption|]). unfold L, ell, mean_force, al1, al3. field. lra.
Qed.

Lemma B_moves s : 0 <= s -> is_derive B s (L s * (al3 s - al1 s) * P s + al3 s * B s).
Proof.
intros Hs. destruct (signs s Hs) as (_ & _ & _ & _ & _ & <-).
apply (B_rate I all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high Hall HC s); try lra.
- intros i t Ht. apply motion, Ht.
- intros t Ht. apply inside_N, Ht.
Qed.

Lemma L_moves s : 0 <= s -> is_derive L s (P s * moved s).
Proof.
intros Hs. assert (Pp := P_positive s Hs). eapply is_derive_val.
- apply (rate_of I all F G p b low high Hall s xi) with (d := dl).
  + intros i t Ht. apply motion, Ht.
  + intros t Ht. apply inside_N, Ht.
  + destruct HS; assumption.
  + lra.
- unfold moved, lam, P, B in *. field. lra.
Qed.

(** lambda stays in the interval: most P + B and - B - least P stay >= 0. *)
Lemma force_in_between s : 0 <= s -> least <= lam s <= most.
Proof.
intros Hs. assert (Pp := P_positive s Hs). destruct HS as [_ _ _ _ _ _ [FL FM] _ _].
rewrite <- (state_0 I start xi (starts _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA)) in FL, FM.
assert (P0 := P_positive 0 (Rle_refl 0)). fold (P 0) (B 0) in FL, FM.
assert (K : forall c sg, (sg = 1 \/ sg = -1) -> 0 <= sg * (c * P 0 + B 0) ->
  (forall t, 0 <= t -> 0 <= sg * (c - L t)) -> 0 <= sg * (c * P s + B s)).
{ intros c sg Hsg H0 Hc.
  set (h t := sg * (c * P t + B t)).
  set (h' t := sg * (c * (al1 t * P t) + (L t * (al3 t - al1 t) * P t + al3 t * B t))).
  assert (Q := orthant_kept 1 0 0 s [(h, h')] ltac:(lra)). change (0 <= h s).
  apply Q with (x' := h'); clear Q; [| | |left; reflexivity|lra].
  - intros x x' t [E|[]] Ht. injection E as <- <-. unfold Rdiv. rewrite Rinv_1, Rmult_1_r.
    apply (is_derive_scal (fun t => c * P t + B t)), (is_derive_plus (fun t => c * P t) B).
    apply (is_derive_scal P), P_moves. lra. apply B_moves. lra.
  - intros x x' [E|[]]. injection E as <- <-. exact H0.
  - intros t n Ht Hn Hl x x' [E|[]] Hx. injection E as <- <-.
    destruct (signs t ltac:(lra)) as (_ & H3 & H13 & _). specialize (Hc t ltac:(lra)).
    assert (Pt := P_positive t ltac:(lra)). assert (A3 := a3_positive _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN).
    replace (h' t) with (P t * (al1 t - al3 t) * (sg * (c - L t)) + al3 t * h t) by (unfold h', h; ring).
    rewrite Hx. assert (0 <= P t * (al1 t - al3 t) * (sg * (c - L t))).
    { apply Rmult_le_pos; [apply Rmult_le_pos; lra|exact Hc]. }
    assert (0 <= - al3 t * n) by (apply Rmult_le_pos; lra). lra. }
split.
- assert (Q := K least (-1) (or_intror eq_refl)). unfold lam.
  assert (H : 0 <= -1 * (least * P s + B s)).
  { apply Q. apply (Rmult_le_compat_r (P 0)) in FL; [|lra].
    replace (- B 0 / P 0 * P 0) with (- B 0) in FL by (field; lra).
    lra. intros t Ht. destruct (signs t Ht) as (_ & _ & _ & _ & H & _). lra. }
  apply Rmult_le_reg_r with (P s); auto. replace (- B s / P s * P s) with (- B s) by (field; lra). lra.
- assert (Q := K most 1 (or_introl eq_refl)). unfold lam.
  assert (H : 0 <= 1 * (most * P s + B s)).
  { apply Q. apply (Rmult_le_compat_r (P 0)) in FM; [|lra].
    replace (- B 0 / P 0 * P 0) with (- B 0) in FM by (field; lra).
    lra. intros t Ht. destruct (signs t Ht) as (_ & _ & _ & _ & H & _). lra. }
  apply Rmult_le_reg_r with (P s); auto. replace (- B s / P s * P s) with (- B s) by (field; lra). lra.
Qed.

Lemma moved_small s : 0 <= s -> Rabs (moved s) <= m.
Proof.
intros Hs. apply (mean_moves _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HS). apply inside_N, Hs. apply force_in_between, Hs.
Qed.

(** ** (lambda - l)/p grows *)

Let u s := sigma * (lam s - L s) / P s.

Lemma u_moves s : 0 <= s -> is_derive u s ((al3 s - 2 * al1 s) * u s - sigma * moved s).
Proof.
intros Hs. assert (Pp := P_positive s Hs). eapply is_derive_val.
- apply (u_derive P B L). apply P_moves, Hs. apply B_moves, Hs. apply L_moves, Hs. lra.
- unfold u, lam. field. lra.
Qed.

Let z0 := u 0 - m / kappa.

Lemma start_far : 0 < z0 /\ 0 <= m /\ 0 < kappa.
Proof.
assert (Hm := moved_small 0 (Rle_refl 0)). assert (M := Rabs_pos (moved 0)). assert (P0 := P_positive 0 (Rle_refl 0)).
destruct HS as [_ _ _ K _ _ _ _ Far].
rewrite <- (state_0 I start xi (starts _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA)) in Far. fold (P 0) (B 0) in Far.
repeat split; try lra. unfold z0. fold ell (L 0) (lam 0) in Far.
assert (m / kappa < u 0); [|lra]. unfold u. apply Rmult_lt_reg_r with (P 0); auto.
replace (sigma * (lam 0 - L 0) / P 0 * P 0) with (sigma * (lam 0 - L 0)) by (field; lra).
replace (m / kappa * P 0) with (m * P 0 / kappa) by (field; lra). exact Far.
Qed.

Lemma rate_up s : 0 <= s -> 0 <= u s -> kappa * (u s - m / kappa) <= (al3 s - 2 * al1 s) * u s - sigma * moved s.
Proof.
intros Hs Hu. destruct start_far as (_ & Hm & Hk). destruct (signs s Hs) as (_ & _ & _ & H & _).
assert (M := moved_small s Hs). apply Rabs_le_between in M.
assert (sigma * moved s <= m) by (destruct (a_side _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HS) as [-> | ->]; lra).
replace (kappa * (u s - m / kappa)) with (kappa * u s - m) by (field; lra). nra.
Qed.

Lemma stays_far s : 0 <= s -> z0 <= u s - m / kappa.
Proof.
destruct start_far as (Hz & Hm & Hk).
assert (Mk : 0 <= m / kappa) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat, Hk]).
assert (Up : forall t, 0 <= t -> (forall s, 0 <= s <= t -> 0 <= u s - m / kappa) -> z0 <= u t - m / kappa).
{ intros t Ht H. unfold z0. cut (- u t <= - u 0). lra.
  apply (decr_of_derive (fun s => - u s) (fun s => - ((al3 s - 2 * al1 s) * u s - sigma * moved s)) 0 t Ht).
  - intros r Hr. apply (is_derive_opp u), u_moves. lra.
  - intros r Hr. specialize (H r Hr). assert (Q := rate_up r ltac:(lra) ltac:(lra)).
    assert (0 <= kappa * (u r - m / kappa)) by (apply Rmult_le_pos; lra). lra. }
revert s. apply (real_induction (fun s => z0 <= u s - m / kappa) 0).
- unfold z0. lra.
- intros t Ht H. destruct (continuous_pos (fun s => u s - m / kappa) t) as [d Hd].
  { eexists. apply (is_derive_minus u (fun _ => m / kappa)). apply u_moves, Ht. apply (is_derive_const (m / kappa)). }
  { specialize (H t ltac:(lra)). lra. }
  exists d. split; [apply cond_pos|]. intros s Hs. apply Up; [lra|]. intros r Hr. destruct (Rle_dec r t) as [Le|Le].
  + specialize (H r ltac:(lra)). lra.
  + apply Rlt_le, Hd. change (Rabs (r - t) < d). rewrite Rabs_pos_eq; lra.
- intros t Ht H. apply (closed_ge (fun s => u s - m / kappa) 0 t z0 Ht).
  + eexists. apply (is_derive_minus u (fun _ => m / kappa)). apply u_moves. lra. apply (is_derive_const (m / kappa)).
  + exact H.
Qed.

Lemma grows s : 0 <= s -> z0 * exp (kappa * s) <= u s.
Proof.
intros Hs. destruct start_far as (Hz & Hm & Hk).
assert (Mk : 0 <= m / kappa) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat, Hk]).
assert (D : - ((u s - m / kappa) * exp (- (kappa * s))) <= - ((u 0 - m / kappa) * exp (- (kappa * 0)))).
{ apply (decr_of_derive (fun s => - ((u s - m / kappa) * exp (- (kappa * s))))
    (fun s => - (((al3 s - 2 * al1 s) * u s - sigma * moved s - kappa * (u s - m / kappa)) * exp (- (kappa * s))))
    0 s Hs).
  - intros r Hr. eapply is_derive_val.
    + apply (is_derive_opp (fun s => (u s - m / kappa) * exp (- (kappa * s)))).
      apply (is_derive_mult_R (fun s => u s - m / kappa) (fun s => exp (- (kappa * s)))).
      * apply (is_derive_minus u (fun _ => m / kappa)). apply u_moves. lra. apply (is_derive_const (m / kappa)).
      * auto_derive; auto.
    + unfold minus, plus, opp, zero; simpl. ring.
  - intros r Hr. assert (S := stays_far r ltac:(lra)). assert (Q := rate_up r ltac:(lra) ltac:(lra)).
    assert (E := exp_pos (- (kappa * r))). nra. }
rewrite Rmult_0_r, Ropp_0, exp_0, Rmult_1_r in D. fold z0 in D.
rewrite exp_Ropp in D. assert (E := exp_pos (kappa * s)).
apply Rle_trans with (u s - m / kappa); [|lra]. apply Rmult_le_reg_r with (/ exp (kappa * s)).
apply Rinv_0_lt_compat, E. rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra. lra.
Qed.

Lemma P_falls s : 0 <= s -> P s <= P 0 * exp (- (a1 * s)).
Proof.
intros Hs.
assert (D : P s * exp (a1 * s) <= P 0 * exp (a1 * 0)).
{ apply (decr_of_derive (fun s => P s * exp (a1 * s)) (fun s => (al1 s + a1) * P s * exp (a1 * s)) 0 s Hs).
  - intros r Hr. eapply is_derive_val. apply (is_derive_mult_R P (fun s => exp (a1 * s))). apply P_moves. lra.
    auto_derive; auto. ring.
  - intros r Hr. destruct (signs r ltac:(lra)) as (H1 & _). assert (Pp := P_positive r ltac:(lra)).
    assert (E := exp_pos (a1 * r)). assert (0 <= P r * exp (a1 * r)) by (apply Rmult_le_pos; lra). nra. }
rewrite Rmult_0_r, exp_0, Rmult_1_r in D. rewrite exp_Ropp. assert (E := exp_pos (a1 * s)).
apply Rmult_le_reg_r with (exp (a1 * s)); auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r; lra.
Qed.

(** ** Near the G-spot *)

Let beta := alpha3 spot / alpha1 spot.

Lemma spot_in_N : in_box low high spot.
Proof. apply (at_the_spot _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA). Qed.

Lemma spot_signs : alpha1 spot < 0 /\ beta < 2 /\ alpha3 spot = beta * alpha1 spot /\ 0 < alpha1 spot - alpha3 spot.
Proof.
destruct (on_the_box _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN _ spot_in_N) as (H1 & _).
destruct (between _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HS _ spot_in_N) as (H4 & H5 & _).
assert (A1 := a1_positive _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN). destruct start_far as (_ & _ & Hk).
assert (E : alpha3 spot = beta * alpha1 spot) by (unfold beta; field; lra).
repeat split; auto; try lra. apply Rnot_le_lt. intros Hle.
assert ((beta - 2) * alpha1 spot <= 0) by nra. lra.
Qed.

(** All components are within c p of the G-spot. *)
Lemma within : exists c, 0 <= c /\ forall s i, 0 <= s -> Rabs (xi i s - spot i) <= c * P s.
Proof.
destruct (sizes I F G alpha1 alpha2 alpha3 first last low high a1 a3 A2 p1 b1 f g HN) as [A20 FG].
assert (A1 := a1_positive _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN).
assert (A3 := a3_positive _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN).
assert (I1 := Rinv_0_lt_compat _ A1). assert (I3 := Rinv_0_lt_compat _ A3).
set (k := Rabs least + Rabs most). assert (K0 : 0 <= k) by (unfold k; generalize (Rabs_pos least) (Rabs_pos most); lra).
set (each i := f i / a1 + g i * ((k + A2 / a1) / a3)).
assert (E0 : forall i, 0 <= each i).
{ intros i. destruct (FG i) as [Hf Hg]. unfold each, Rdiv. assert (0 <= A2 * / a1) by (apply Rmult_le_pos; lra).
  apply Rplus_le_le_0_compat; repeat apply Rmult_le_pos; lra. }
exists (total all each). split. { apply total_nonneg, E0. }
intros s i Hs. assert (Pp := P_positive s Hs). destruct (FG i) as [Hf Hg].
apply Rle_trans with (each i * P s).
- eapply Rle_trans; [apply (nearer _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA s i Hs)|]. fold (P s) (B s).
  assert (BP : Rabs (B s) <= k * P s).
  { assert (Q := force_in_between s Hs). assert (E : B s = - lam s * P s) by (unfold lam; field; lra).
    rewrite E, Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (P s)) by lra. apply Rmult_le_compat_r; [lra|].
    unfold k. generalize (Rle_abs most) (Rle_abs (- least)) (Rabs_pos most) (Rabs_pos least). rewrite Rabs_Ropp.
    intros. apply Rabs_le. lra. }
  unfold reach, each.
  replace ((f i / a1 + g i * ((k + A2 / a1) / a3)) * P s)
    with (f i * (P s / a1) + g i * ((k * P s + A2 * (P s / a1)) / a3)) by (field; lra).
  apply Rplus_le_compat_l, Rmult_le_compat_l; auto. unfold Rdiv. apply Rmult_le_compat_r; lra.
- apply Rmult_le_compat_r; [lra|]. apply total_term; auto.
Qed.

(** A smooth function is within a multiple of p of its value there. *)
Lemma near_spot phi d : smooth_on all phi d low high ->
  exists K, 0 <= K /\ forall s, 0 <= s -> Rabs (phi (state xi s) - phi spot) <= K * P s.
Proof.
intros Hd. destruct (smooth_lipschitz I all low high Hall phi d Hd) as (K & K0 & HK).
destruct within as (c & c0 & Hc). exists (K * c). split. apply Rmult_le_pos; auto.
intros s Hs. rewrite Rmult_assoc. apply HK. apply inside_N, Hs. apply spot_in_N. intros j. apply Hc, Hs.
Qed.

Let V s := ln (u s) + (2 - beta) * ln (P s).

Lemma V_limit : exists l : R, is_lim V p_infty l.
Proof.
destruct start_far as (Hz & Hm & Hk). destruct spot_signs as (S1 & S2 & S3 & _).
assert (A1 := a1_positive _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN).
destruct (near_spot alpha1 d1) as (K1 & K10 & H1). { destruct HS; assumption. }
destruct (near_spot alpha3 d3) as (K3 & K30 & H3). { destruct HS; assumption. }
set (K := K3 + Rabs beta * K1). assert (Bp := Rabs_pos beta).
assert (K0 : 0 <= K) by (unfold K; assert (0 <= Rabs beta * K1) by (apply Rmult_le_pos; auto); lra).
assert (P0 := P_positive 0 (Rle_refl 0)). set (q := Rmin a1 kappa).
assert (Hq : 0 < q) by (apply Rmin_pos; auto). assert (Q1 : q <= a1) by apply Rmin_l.
assert (Q2 : q <= kappa) by apply Rmin_r.
assert (Mz : 0 <= m / z0) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat, Hz]).
assert (KP : 0 <= K * P 0) by (apply Rmult_le_pos; lra).
apply (limit_of_decaying V (fun s => al3 s - beta * al1 s - sigma * moved s / u s) (K * P 0 + m / z0) q); auto;
  [lra| |].
- intros s Hs. assert (Pp := P_positive s Hs). assert (U := grows s Hs). assert (E := exp_pos (kappa * s)).
  assert (Up : 0 < u s). { eapply Rlt_le_trans; [|exact U]. apply Rmult_lt_0_compat; auto. }
  eapply is_derive_val. apply (ln_derive u P). apply u_moves, Hs. apply P_moves, Hs. exact Up. exact Pp. field. lra.
- intros s Hs. assert (Pp := P_positive s Hs). assert (U := grows s Hs). assert (E := exp_pos (kappa * s)).
  assert (Zp : 0 < z0 * exp (kappa * s)) by (apply Rmult_lt_0_compat; auto). assert (Up : 0 < u s) by lra.
  assert (Es : forall k, q <= k -> exp (- (k * s)) <= exp (- (q * s))).
  { intros k Hle. apply exp_le. assert (q * s <= k * s) by (apply Rmult_le_compat_r; lra). lra. }
  assert (T1 : Rabs (al3 s - beta * al1 s) <= K * P 0 * exp (- (q * s))).
  { replace (al3 s - beta * al1 s) with ((al3 s - alpha3 spot) + - (beta * (al1 s - alpha1 spot))) by lra.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, Rabs_mult.
    specialize (H1 s Hs). specialize (H3 s Hs). fold (al1 s) in H1. fold (al3 s) in H3.
    apply Rle_trans with (K * P s).
    - unfold K. assert (Rabs beta * Rabs (al1 s - alpha1 spot) <= Rabs beta * (K1 * P s))
        by (apply Rmult_le_compat_l; auto). lra.
    - rewrite Rmult_assoc. apply Rmult_le_compat_l; auto. eapply Rle_trans; [apply P_falls, Hs|].
      apply Rmult_le_compat_l; [lra|]. apply Es, Q1. }
  assert (T2 : Rabs (sigma * moved s / u s) <= m / z0 * exp (- (q * s))).
  { unfold Rdiv at 1. rewrite !Rabs_mult, Rabs_inv, (Rabs_pos_eq (u s)) by lra.
    replace (Rabs sigma) with 1 by (destruct (a_side _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HS) as [-> | ->];
      unfold Rabs; destruct Rcase_abs; lra).
    apply Rle_trans with (m * / (z0 * exp (kappa * s))).
    - rewrite Rmult_1_l.
      apply Rmult_le_compat; [apply Rabs_pos|apply Rlt_le, Rinv_0_lt_compat, Up|apply moved_small, Hs|].
      apply Rinv_le_contravar; auto.
    - replace (m * / (z0 * exp (kappa * s))) with (m / z0 * exp (- (kappa * s)))
        by (rewrite exp_Ropp; field; lra).
      apply Rmult_le_compat_l; [exact Mz|]. apply Es, Q2. }
  unfold Rminus at 1. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
Qed.

(** lambda_ begins at l of the G-spot, and is within a multiple of p of it. *)
Lemma distinguished_near : exists K d, 0 <= K /\ 0 < d /\
  forall x, 0 <= x < d -> Rabs (lambda_ x - ell spot) <= K * x.
Proof.
destruct HD as [Hp0 H0 _ HF]. destruct (HF 0 ltac:(lra)) as (r & Dr & E).
destruct spot_signs as (S1 & _ & _ & S4).
assert (X0 : state xi_ 0 = spot). { apply (state_0 I spot xi_ H0). }
rewrite X0 in E. assert (E0 : lambda_ 0 = ell spot).
{ rewrite Rmult_0_l in E. unfold ell, mean_force.
  assert (Q : (alpha3 spot - alpha1 spot) * lambda_ 0 = alpha2 spot).
  { apply (f_equal (fun t => t * alpha1 spot)) in E. rewrite Rmult_0_l in E.
    replace (((alpha3 spot / alpha1 spot - 1) * lambda_ 0 - alpha2 spot / alpha1 spot) * alpha1 spot)
      with ((alpha3 spot - alpha1 spot) * lambda_ 0 - alpha2 spot) in E by (field; lra). lra. }
  rewrite <- Q. field. lra. }
apply is_derive_Reals in Dr. destruct (Dr 1 ltac:(lra)) as (d & Hd).
exists (Rabs r + 1), d. split. { generalize (Rabs_pos r). lra. } split. apply cond_pos.
intros x Hx. destruct (Req_dec x 0) as [->|Hne].
{ rewrite E0. unfold Rminus. rewrite Rplus_opp_r, Rabs_R0. lra. }
specialize (Hd x Hne). rewrite Rabs_pos_eq in Hd by lra. specialize (Hd ltac:(lra)). rewrite Rplus_0_l, E0 in Hd.
assert (Q : Rabs ((lambda_ x - ell spot) / x) <= Rabs r + 1).
{ replace ((lambda_ x - ell spot) / x) with (((lambda_ x - ell spot) / x - r) + r) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. lra. }
replace (lambda_ x - ell spot) with ((lambda_ x - ell spot) / x * x) by (field; lra).
rewrite Rabs_mult, (Rabs_pos_eq x) by lra. apply Rmult_le_compat_r; lra.
Qed.

(** Its part of the quotient tends to 0, like p^(2 - beta). *)
Lemma distinguished_part : is_lim (fun s => (L s - lambda_ (P s)) / Rpower (P s) (beta - 1)) p_infty 0.
Proof.
destruct distinguished_near as (K & d & K0 & Hd & HK). destruct spot_signs as (_ & S2 & _ & _).
destruct (near_spot ell dl) as (KL & KL0 & HL). { destruct HS; assumption. }
assert (A1 := a1_positive _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN). assert (P0 := P_positive 0 (Rle_refl 0)).
set (c := (KL + K) * exp ((2 - beta) * ln (P 0))). assert (E0 := exp_pos ((2 - beta) * ln (P 0))).
assert (C0 : 0 <= c) by (apply Rmult_le_pos; lra).
apply is_lim_spec. intros eps.
destruct (exp_decays (P 0) a1 d ltac:(lra) A1 Hd) as (S & HS0 & Q).
destruct (exp_decays c ((2 - beta) * a1) eps C0 ltac:(apply Rmult_lt_0_compat; lra) (cond_pos eps)) as (S' & HS' & Q').
exists (S + S'). intros s Hs. assert (s0 : 0 <= s) by lra. assert (Pp := P_positive s s0).
assert (Pf := P_falls s s0). specialize (Q s ltac:(lra)). specialize (Q' s ltac:(lra)).
rewrite Rminus_0_r. eapply Rle_lt_trans; [|exact Q'].
assert (Rp : 0 < Rpower (P s) (beta - 1)) by apply exp_pos.
unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (Rpower (P s) (beta - 1))) by lra.
assert (N : Rabs (L s - lambda_ (P s)) <= (KL + K) * P s).
{ replace (L s - lambda_ (P s)) with ((L s - ell spot) + - (lambda_ (P s) - ell spot)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. specialize (HL s s0). specialize (HK (P s) ltac:(lra)).
  fold (L s) in HL. lra. }
apply Rle_trans with ((KL + K) * P s * / Rpower (P s) (beta - 1)).
{ apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, Rp|exact N]. }
rewrite Rmult_assoc.
replace (P s * / Rpower (P s) (beta - 1)) with (exp ((2 - beta) * ln (P s))).
2: { unfold Rpower. rewrite <- exp_Ropp. replace (P s) with (exp (ln (P s))) at 2 by (apply exp_ln, Pp).
     rewrite <- exp_plus. f_equal. ring. }
unfold c. rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. rewrite <- exp_plus. apply exp_le.
assert (Ln : ln (P s) <= ln (P 0) - a1 * s).
{ assert (Le : ln (P s) <= ln (P 0 * exp (- (a1 * s)))).
  { destruct Pf as [Lt|Eq]; [apply Rlt_le, ln_increasing; auto|rewrite Eq; lra]. }
  rewrite ln_mult, ln_exp in Le by (auto; apply exp_pos). lra. }
apply (Rmult_le_compat_l (2 - beta)) in Ln; [|lra]. lra.
Qed.

Theorem sign_of_the_limit : exists C1, C1_of_motion alpha1 alpha3 p b xi spot lambda_ C1 /\ sigma * C1 < 0.
Proof.
destruct V_limit as (l & Hl). destruct start_far as (Hz & _ & _).
set (A := Rpower (- alpha1 spot) beta). assert (Ap : 0 < A) by apply exp_pos.
assert (Sg := a_side _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HS).
exists (- A * (sigma * exp l + 0)). split.
- unfold C1_of_motion. fold beta A.
  apply (is_lim_ext_loc (fun s => - A * (sigma * exp (V s) + (L s - lambda_ (P s)) / Rpower (P s) (beta - 1)))).
  + exists 0. intros s Hs. assert (s0 : 0 <= s) by lra. assert (Pp := P_positive s s0). assert (U := grows s s0).
    assert (E := exp_pos (kappa * s)).
    assert (Up : 0 < u s). { eapply Rlt_le_trans; [|exact U]. apply Rmult_lt_0_compat; auto. }
    f_equal. fold (P s) (B s) (lam s).
    assert (X : exp (V s) = sigma * (lam s - L s) / Rpower (P s) (beta - 1)).
    { unfold V. rewrite exp_plus, exp_ln by auto.
      replace ((2 - beta) * ln (P s)) with (ln (P s) + - ((beta - 1) * ln (P s))) by ring.
      rewrite exp_plus, exp_ln, exp_Ropp by auto. fold (Rpower (P s) (beta - 1)). unfold u. field.
      split; [apply Rgt_not_eq, exp_pos|lra]. }
    rewrite X. assert (Rp : Rpower (P s) (beta - 1) <> 0) by apply Rgt_not_eq, exp_pos.
    destruct Sg as [-> | ->]; field; exact Rp.
  + apply (is_lim_scal_l (fun s => sigma * exp (V s) + (L s - lambda_ (P s)) / Rpower (P s) (beta - 1)) (- A) p_infty
      (sigma * exp l + 0)).
    apply (is_lim_plus' (fun s => sigma * exp (V s)) (fun s => (L s - lambda_ (P s)) / Rpower (P s) (beta - 1))).
    * apply (is_lim_scal_l (fun s => exp (V s)) sigma p_infty (exp l)).
      apply (is_lim_comp_continuous V exp p_infty l Hl). apply (ex_derive_continuous exp). auto_derive; auto.
    * exact distinguished_part.
- assert (E := exp_pos l). destruct Sg as [-> | ->]; nra.
Qed.

End Side.
