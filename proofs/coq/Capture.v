(** * Slip reaches a G-spot: Theorem A1 of proofs/approach.md

    Along a motion in N, P = p and B = b solve P' = alpha1 P and B' = alpha2 P + alpha3 B. So P stays positive, and what
    moves at a rate of at most c P + e |B| moves by no more than [reach] of (P, B) falls ([travel]; |B| is replaced by
    sqrt(B^2 + d^2), and d tends to 0). So the states stay within rho of the start ([near_start]), and in N ([stays]).
    B^2 + (K + 1) P^2 falls exponentially ([both_fall]), so the states have a limit, and there p = b = 0 ([captured]).
    The functions y and v of the paper stay 0 ([contact_kept]). *)

From Coq Require Import Reals Psatz Lra Lia List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus NonnegativeOrthant LogarithmicNorm SmoothFunctions StatementStep StatementApproach.
Open Scope R_scope.

Lemma reach_nonneg a1 a3 A2 p b c e : 0 < a1 -> 0 < a3 -> 0 <= A2 -> 0 <= p -> 0 <= c -> 0 <= e ->
  0 <= reach a1 a3 A2 p b c e.
Proof.
intros H1 H3 HA Hp Hc He. unfold reach, Rdiv. assert (I1 := Rinv_0_lt_compat _ H1).
assert (I3 := Rinv_0_lt_compat _ H3).
assert (Q : 0 <= p * / a1) by (apply Rmult_le_pos; lra). assert (B := Rabs_pos b).
assert (0 <= A2 * (p * / a1)) by (apply Rmult_le_pos; auto).
apply Rplus_le_le_0_compat; repeat apply Rmult_le_pos; lra.
Qed.

Lemma reach_le a1 a3 A2 p b p' b' c e : 0 < a1 -> 0 < a3 -> 0 <= A2 -> 0 <= c -> 0 <= e -> p <= p' ->
  Rabs b <= Rabs b' -> reach a1 a3 A2 p b c e <= reach a1 a3 A2 p' b' c e.
Proof.
intros H1 H3 HA Hc He Hp Hb. unfold reach, Rdiv. assert (I1 := Rinv_0_lt_compat _ H1).
assert (I3 := Rinv_0_lt_compat _ H3).
assert (Q : p * / a1 <= p' * / a1) by (apply Rmult_le_compat_r; lra).
assert (A2 * (p * / a1) <= A2 * (p' * / a1)) by (apply Rmult_le_compat_l; auto).
apply Rplus_le_compat; apply Rmult_le_compat_l; auto. apply Rmult_le_compat_r; lra.
Qed.

Lemma derive_pos_after (f : R -> R) t l : is_derive f t l -> f t = 0 -> 0 < l -> exists d, 0 < d /\ forall s,
  t < s < t + d -> 0 < f s.
Proof.
intros D E Hl. destruct (derive_pos_before (fun s => - f (2 * t - s)) t l) as (d & Hd & N); [| |exact Hl|].
- eapply is_derive_val. { apply (is_derive_opp (fun s => f (2 * t - s))), (is_derive_comp f (fun s => 2 * t - s)).
    assert (E2 : 2 * t - t = t) by lra. rewrite E2. exact D. auto_derive; auto. }
  unfold opp, scal; simpl; unfold mult; simpl. lra.
- cbv beta. assert (E2 : 2 * t - t = t) by lra. rewrite E2, E. lra.
- exists d. split; auto. intros s Hs. specialize (N (2 * t - s) ltac:(lra)).
  replace (2 * t - (2 * t - s)) with s in N by ring. lra.
Qed.

Lemma falling_bound_derive (x n q : R -> R) (x' n' q' sg c e a1 a3 A2 k u : R) : is_derive x u x' -> is_derive n u n' ->
  is_derive q u q' -> a1 <> 0 -> a3 <> 0 ->
  is_derive (fun u => sg * x u + (c * (q u / a1) + e * ((n u + A2 * (q u / a1)) / a3)) - k * u) u
    (sg * x' + (c * (q' / a1) + e * ((n' + A2 * (q' / a1)) / a3)) - k).
Proof.
intros D1 D2 D3 N1 N3. auto_derive. { repeat split; eexists; eassumption. }
assert (E1 : Derive (fun u => x u) u = x') by exact (is_derive_unique _ _ _ D1).
assert (E2 : Derive (fun u => n u) u = n') by exact (is_derive_unique _ _ _ D2).
assert (E3 : Derive (fun u => q u) u = q') by exact (is_derive_unique _ _ _ D3). rewrite E1, E2, E3. field. auto.
Qed.

Lemma squares_derive (q z : R -> R) (q' z' k m u : R) : is_derive q u q' -> is_derive z u z' ->
  is_derive (fun u => (z u ^ 2 + k * q u ^ 2) * exp (m * u)) u
    ((2 * z u * z' + 2 * k * q' * q u + m * (z u ^ 2 + k * q u ^ 2)) * exp (m * u)).
Proof.
intros D1 D2. auto_derive. { repeat split; eexists; eassumption. }
assert (E1 : Derive (fun u => q u) u = q') by exact (is_derive_unique _ _ _ D1).
assert (E2 : Derive (fun u => z u) u = z') by exact (is_derive_unique _ _ _ D2). rewrite E1, E2. ring.
Qed.

Section Capture.
Variables (I : Type) (all : list I) (F G : I -> (I -> R) -> R) (F' G' : I -> I -> (I -> R) -> R).
Variables (p b : (I -> R) -> R) (p' b' : I -> (I -> R) -> R) (alpha1 alpha2 alpha3 : (I -> R) -> R).
Variables (first last low high : I -> R) (a1 a3 A2 p1 b1 : R) (f g : I -> R).
Hypothesis Hall : forall i, In i all.
Hypothesis HC : slip_functions all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high.
Hypothesis HN : neighbourhood_checked F G alpha1 alpha2 alpha3 first last low high a1 a3 A2 p1 b1 f g.
Variable start : I -> R.
Hypothesis Hstart : in_box first last start.
Hypothesis Hp0 : 0 < p start <= p1.
Hypothesis Hb0 : - b1 <= b start < 0.

Let X := slip_flow F G p b.
Let rho i := reach a1 a3 A2 p1 b1 (f i) (g i).

Lemma a1_pos : 0 < a1. Proof. destruct HN; auto. Qed.
Lemma a3_pos : 0 < a3. Proof. destruct HN; auto. Qed.

Lemma bounds xi : in_box low high xi -> alpha1 xi <= - a1 /\ alpha3 xi <= - a3 /\ Rabs (alpha2 xi) <= A2 /\
  forall i, Rabs (F i xi) <= f i /\ Rabs (G i xi) <= g i.
Proof. destruct HN; auto. Qed.

Lemma box_order i : low i <= high i. Proof. destruct HN; auto. Qed.

Lemma sizes : 0 <= A2 /\ forall i, 0 <= f i /\ 0 <= g i.
Proof.
destruct (bounds low) as (_ & _ & B & FG). { intros i. split; [apply Rle_refl|apply box_order]. }
split. { eapply Rle_trans; [apply Rabs_pos|exact B]. }
intros i. destruct (FG i). split; (eapply Rle_trans; [apply Rabs_pos|eassumption]).
Qed.

Lemma rho_nonneg i : 0 <= rho i.
Proof. destruct sizes as [HA S]. destruct (S i). apply reach_nonneg; auto using a1_pos, a3_pos; lra. Qed.

(** A state within rho of the start is in the interior of N. *)
Lemma near_is_inside xi : (forall i, Rabs (xi i - start i) <= rho i) -> forall i, low i < xi i < high i.
Proof.
intros H i. destruct HN as [_ _ _ _ R]. specialize (R i). assert (S := Hstart i). specialize (H i).
apply Rabs_le_between in H. unfold rho in H. lra.
Qed.

(** ** Along a motion in N *)

Section Motion.
Variables (T : R) (xi : I -> R -> R).
Hypothesis H0 : forall i, xi i 0 = start i.
Hypothesis Hmove : forall i s, 0 <= s <= T -> is_derive (xi i) s (X i (state xi s)).
Hypothesis Hin : forall s, 0 <= s <= T -> in_box low high (state xi s).

Let P s := p (state xi s).
Let B s := b (state xi s).

Lemma state_0 : state xi 0 = start.
Proof. apply functional_extensionality, H0. Qed.

Lemma rate_of phi d s : smooth_on all phi d low high -> 0 <= s <= T ->
  is_derive (fun s => phi (state xi s)) s (P s * along all d F (state xi s) - B s * along all d G (state xi s)).
Proof.
intros [D _] Hs.
assert (C := gradient_chain I all Hall phi (fun j => d j (state xi s)) xi (fun i => X i (state xi s)) s
  (D _ (Hin s Hs)) (fun i => Hmove i s Hs)).
eapply is_derive_val; [exact C|]. unfold along. rewrite <- !total_scal, <- total_minus. apply total_ext.
intros j. unfold X, slip_flow, P, B. ring.
Qed.

Lemma P_rate s : 0 <= s <= T -> is_derive P s (alpha1 (state xi s) * P s).
Proof.
intros Hs. destruct HC as [_ _ D _ _ E _]. unfold P at 2. rewrite <- (E _ (Hin s Hs)). apply rate_of; auto.
Qed.

Lemma B_rate s : 0 <= s <= T -> is_derive B s (alpha2 (state xi s) * P s + alpha3 (state xi s) * B s).
Proof.
intros Hs. destruct HC as [_ _ _ D _ _ E]. unfold P, B at 2. rewrite <- (E _ (Hin s Hs)). apply rate_of; auto.
Qed.

Lemma P_pos s : 0 <= s -> s <= T -> 0 < P s.
Proof.
destruct (alpha1_bounded _ _ _ _ _ _ _ _ _ _ _ _ _ _ HC) as (M & HM).
revert s. apply (real_induction (fun s => s <= T -> 0 < P s) 0).
- intros _. unfold P. rewrite state_0. apply Hp0.
- intros t Ht H. destruct (Rle_dec t T) as [L|L].
  2: { exists 1. split; [lra|]. intros s Hs Hs'. lra. }
  destruct (continuous_pos P t) as [d Hd]. { eexists. apply P_rate. lra. } { apply H; lra. }
  exists d. split; [apply cond_pos|]. intros s Hs _. apply Hd. change (Rabs (s - t) < d). rewrite Rabs_pos_eq; lra.
- intros t Ht H Hle.
  assert (Q : 0 <= P t).
  { apply (closed_ge P 0 t 0 Ht). eexists; apply P_rate; lra. intros s Hs. apply Rlt_le, H; lra. }
  destruct Q as [|E]; auto. exfalso.
  assert (Z := one_step_zero (fun s => P s ^ 2) (fun s => 2 * alpha1 (state xi s) * P s ^ 2) t 0 (2 * M)).
  cbv beta in Z.
  rewrite Rmin_right, Rmax_left in Z by lra. assert (P0 : 0 < P 0) by (apply H; lra).
  assert (P 0 ^ 2 = 0); [|nra]. apply Z.
  + intros s Hs. evar_last. apply (is_derive_pow P 2 s). apply P_rate. lra. simpl. ring.
  + intros s. apply pow2_ge_0.
  + rewrite <- E. ring.
  + intros s Hs. rewrite !Rabs_mult, (Rabs_pos_eq 2), (Rabs_pos_eq (P s ^ 2)) by (try apply pow2_ge_0; lra).
    apply Rmult_le_compat_r. apply pow2_ge_0. apply Rmult_le_compat_l. lra.
    apply HM, Hin. lra.
Qed.

(** sqrt(B^2 + d^2) in place of |B|: its derivative is at most A2 P - a3 (sqrt(B^2 + d^2) - d). *)
Let size d s := sqrt (B s ^ 2 + d ^ 2).
Let slope d s := (alpha2 (state xi s) * P s + alpha3 (state xi s) * B s) * (B s / size d s).

Lemma size_near d s : 0 < d -> d <= size d s /\ Rabs (B s) <= size d s <= Rabs (B s) + d /\
  size d s * size d s = B s ^ 2 + d ^ 2.
Proof.
intros Hd. assert (N2 : size d s * size d s = B s ^ 2 + d ^ 2) by (apply sqrt_sqrt; nra).
assert (Np : 0 < size d s) by (apply sqrt_lt_R0; nra). assert (A := Rabs_pos (B s)).
assert (A2' : Rabs (B s) * Rabs (B s) = B s ^ 2) by (rewrite <- Rabs_mult, Rabs_pos_eq; nra).
repeat split; auto; apply Rsqr_incr_0_var; unfold Rsqr; nra.
Qed.

Lemma size_rate d s : 0 < d -> 0 <= s <= T -> is_derive (size d) s (slope d s) /\
  slope d s <= A2 * P s - a3 * (size d s - d).
Proof.
intros Hd Hs. unfold slope. set (r := alpha2 (state xi s) * P s + alpha3 (state xi s) * B s).
destruct (size_near d s Hd) as (dN & [BN _] & N2).
assert (Np : 0 < size d s) by lra. set (N := size d s) in *. split.
- eapply is_derive_val. { apply (is_derive_comp (fun u => sqrt (u ^ 2 + d ^ 2)) B s). auto_derive. nra. reflexivity.
    apply B_rate, Hs. }
  unfold scal; simpl; unfold mult; simpl. fold r.
  replace (B s * (B s * 1) + d * (d * 1)) with (B s ^ 2 + d ^ 2) by ring. fold (size d s). fold N. field. lra.
- destruct (bounds _ (Hin s Hs)) as (_ & L3 & L2 & _). assert (Pp := P_pos s ltac:(lra) ltac:(lra)).
  assert (Q : r * B s <= (A2 * P s - a3 * (N - d)) * N).
  { unfold r. assert (T1 : alpha2 (state xi s) * P s * B s <= A2 * P s * N).
    { eapply Rle_trans; [apply Rle_abs|]. rewrite !Rabs_mult, (Rabs_pos_eq (P s)) by lra.
      apply Rmult_le_compat; auto using Rabs_pos. apply Rmult_le_pos; [apply Rabs_pos|lra].
      apply Rmult_le_compat_r; lra. }
    assert (T2 : alpha3 (state xi s) * B s * B s <= - a3 * (B s ^ 2)).
    { assert (0 <= B s ^ 2) by apply pow2_ge_0. nra. }
    assert (T3 : a3 * (N - d) * N <= a3 * B s ^ 2).
    { assert (A := a3_pos). rewrite Rmult_assoc. apply Rmult_le_compat_l; nra. }
    nra. }
  replace (r * (B s / N)) with (r * B s * / N) by (field; lra).
  apply Rmult_le_reg_r with N; auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. exact Q.
Qed.

(** What moves at a rate of at most c P + e |B| moves by no more than [reach] falls. *)
Lemma travel (x x' : R -> R) c e s t : 0 <= c -> 0 <= e -> (forall s, 0 <= s <= T -> is_derive x s (x' s)) ->
  (forall s, 0 <= s <= T -> Rabs (x' s) <= c * P s + e * Rabs (B s)) -> 0 <= s -> s <= t -> t <= T ->
  Rabs (x t - x s) <= reach a1 a3 A2 (P s) (B s) c e - reach a1 a3 A2 (P t) (B t) c e.
Proof.
intros Hc He D Hx Hs Hst Ht. assert (A1 := a1_pos). assert (A3 := a3_pos). destruct sizes as [HA _].
assert (Side : forall sg d, sg = 1 \/ sg = -1 -> 0 < d ->
  sg * (x t - x s) <= reach a1 a3 A2 (P s) (B s) c e - reach a1 a3 A2 (P t) (B t) c e + d * (e / a3 + e * (t - s))).
{ intros sg d Hsg Hd. set (Phi u := c * (P u / a1) + e * ((size d u + A2 * (P u / a1)) / a3)).
  set (slow u := alpha1 (state xi u) * P u / a1).
  assert (M : sg * x t + Phi t - e * d * t <= sg * x s + Phi s - e * d * s).
  { apply (decr_of_derive (fun u => sg * x u + Phi u - e * d * u) (fun u => sg * x' u
      + (c * slow u + e * ((slope d u + A2 * slow u) / a3)) - e * d) s t Hst).
    - intros u Hu. apply falling_bound_derive; [apply D|apply size_rate|apply P_rate| |]; lra.
    - intros u Hu. destruct (size_rate d u Hd ltac:(lra)) as [_ Sl]. specialize (Hx u ltac:(lra)).
      destruct (bounds _ (Hin u ltac:(lra))) as (L1 & _). assert (Pp := P_pos u ltac:(lra) ltac:(lra)).
      destruct (size_near d u Hd) as (_ & [BN _] & _).
      assert (S1 : slow u <= - P u).
      { unfold slow. apply Rmult_le_reg_r with a1; auto. replace (alpha1 (state xi u) * P u / a1 * a1)
          with (alpha1 (state xi u) * P u) by (field; lra). nra. }
      assert (S2 : (slope d u + A2 * slow u) / a3 <= - (size d u - d)).
      { apply Rmult_le_reg_r with a3; auto. replace ((slope d u + A2 * slow u) / a3 * a3)
          with (slope d u + A2 * slow u) by (field; lra). nra. }
      assert (S3 : sg * x' u <= Rabs (x' u)).
      { destruct Hsg as [-> | ->]; generalize (Rle_abs (x' u)) (Rle_abs (- x' u)); rewrite Rabs_Ropp; lra. }
      nra. }
  assert (Q1 : Phi s <= reach a1 a3 A2 (P s) (B s) c e + d * (e / a3)).
  { destruct (size_near d s Hd) as (_ & [_ BN] & _). unfold Phi, reach.
    assert ((size d s + A2 * (P s / a1)) / a3 <= (Rabs (B s) + A2 * (P s / a1)) / a3 + d / a3).
    { unfold Rdiv. rewrite <- Rmult_plus_distr_r. apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; auto|lra]. }
    replace (d * (e / a3)) with (e * (d / a3)) by (field; lra). nra. }
  assert (Q2 : reach a1 a3 A2 (P t) (B t) c e <= Phi t).
  { destruct (size_near d t Hd) as (_ & [BN _] & _). unfold Phi, reach.
    apply Rplus_le_compat_l, Rmult_le_compat_l; auto. unfold Rdiv.
    apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; auto|]. apply Rplus_le_compat_r, BN. }
  lra. }
assert (K : 0 <= e / a3 + e * (t - s)).
{ assert (I3 := Rinv_0_lt_compat _ A3). apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra. }
set (k := e / a3 + e * (t - s)) in *.
assert (Q : forall sg, sg = 1 \/ sg = -1 ->
  sg * (x t - x s) <= reach a1 a3 A2 (P s) (B s) c e - reach a1 a3 A2 (P t) (B t) c e).
{ intros sg Hsg. apply le_epsilon. intros eta Heta.
  eapply Rle_trans; [apply (Side sg (eta / (k + 1)) Hsg); apply Rdiv_lt_0_compat; lra|]. apply Rplus_le_compat_l.
  apply Rmult_le_reg_r with (k + 1); [lra|]. replace (eta / (k + 1) * k * (k + 1)) with (eta * k) by (field; lra).
  nra. }
assert (Q1 := Q 1 (or_introl eq_refl)). assert (Q2 := Q (-1) (or_intror eq_refl)). apply Rabs_le. lra.
Qed.

Lemma near_start i s : 0 <= s <= T -> Rabs (xi i s - start i) <= rho i.
Proof.
intros Hs. destruct sizes as [HA FG]. destruct (FG i) as [Hf Hg]. assert (P0 := P_pos s ltac:(lra) ltac:(lra)).
assert (Q := travel (xi i) (fun s => X i (state xi s)) (f i) (g i) 0 s Hf Hg (Hmove i)).
rewrite H0 in Q. eapply Rle_trans; [apply Q; try lra; clear Q|].
- intros u Hu. destruct (bounds _ (Hin u Hu)) as (_ & _ & _ & FGi). destruct (FGi i) as [Fi Gi].
  assert (Pp := P_pos u ltac:(lra) ltac:(lra)). unfold X, slip_flow, Rminus.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, !Rabs_mult. fold (P u) (B u).
  rewrite (Rabs_pos_eq (P u)) by lra. generalize (Rabs_pos (B u)). nra.
- assert (N := reach_nonneg a1 a3 A2 (P s) (B s) (f i) (g i) a1_pos a3_pos HA (Rlt_le _ _ P0) Hf Hg).
  assert (L : reach a1 a3 A2 (P 0) (B 0) (f i) (g i) <= rho i); [|lra].
  unfold P, B. rewrite state_0. apply reach_le; auto using a1_pos, a3_pos. lra.
  rewrite Rabs_left1, Rabs_pos_eq; lra.
Qed.

(** B^2 + (K + 1) P^2 with K = A2^2/(a1 a3) falls at least like e^(- m s), m = min(a1, a3). *)
Let m := Rmin a1 a3.
Let K := A2 ^ 2 / (a1 * a3).

Lemma both_fall s : 0 <= s <= T -> (P s ^ 2 + B s ^ 2) * exp (m * s) <= B 0 ^ 2 + (K + 1) * P 0 ^ 2.
Proof.
intros Hs. assert (A1 := a1_pos). assert (A3 := a3_pos).
assert (K0 : 0 <= K). { apply Rmult_le_pos; [apply pow2_ge_0|apply Rlt_le, Rinv_0_lt_compat; nra]. }
set (W u := B u ^ 2 + (K + 1) * P u ^ 2).
assert (D : W s * exp (m * s) <= W 0 * exp (m * 0)).
{ set (r u := alpha2 (state xi u) * P u + alpha3 (state xi u) * B u).
  apply (decr_of_derive (fun u => W u * exp (m * u)) (fun u => (2 * B u * r u
    + 2 * (K + 1) * (alpha1 (state xi u) * P u) * P u + m * W u) * exp (m * u)) 0 s ltac:(lra)).
  - intros u Hu. apply squares_derive; [apply P_rate|apply B_rate]; lra.
  - intros u Hu. destruct (bounds _ (Hin u ltac:(lra))) as (L1 & L3 & L2 & _).
    assert (M1 : m <= a1) by apply Rmin_l. assert (M3 : m <= a3) by apply Rmin_r.
    assert (KE : K * (a1 * a3) = A2 ^ 2) by (unfold K; field; lra).
    assert (E := exp_pos (m * u)). set (q := P u) in *. set (z := B u) in *.
    assert (q2 : 0 <= q ^ 2) by apply pow2_ge_0. assert (z2 : 0 <= z ^ 2) by apply pow2_ge_0.
    assert (T1 : 2 * z * (alpha2 (state xi u) * q) <= a3 * z ^ 2 + K * a1 * q ^ 2).
    { set (al := alpha2 (state xi u)) in *.
      assert (A : al ^ 2 <= A2 ^ 2). { apply Rabs_le_between in L2. nra. }
      apply Rmult_le_reg_r with a3; auto.
      assert (0 <= (a3 * z - al * q) ^ 2) by apply pow2_ge_0. nra. }
    assert (T2 : 2 * z * (alpha3 (state xi u) * z) <= - 2 * a3 * z ^ 2) by nra.
    assert (T3 : 2 * (K + 1) * (alpha1 (state xi u) * q) * q <= - 2 * (K + 1) * a1 * q ^ 2).
    { assert (0 <= (K + 1) * q ^ 2) by (apply Rmult_le_pos; lra). nra. }
    assert (T4 : m * W u <= a3 * z ^ 2 + a1 * ((K + 1) * q ^ 2)).
    { unfold W. fold z q. assert (0 <= (K + 1) * q ^ 2) by (apply Rmult_le_pos; lra). nra. }
    assert (T5 : 0 <= a1 * q ^ 2) by (apply Rmult_le_pos; lra).
    assert (2 * z * r u + 2 * (K + 1) * (alpha1 (state xi u) * q) * q + m * W u <= 0) by (unfold r; fold z q; nra).
    nra. }
rewrite Rmult_0_r, exp_0, Rmult_1_r in D. eapply Rle_trans; [|exact D].
apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|]. unfold W. assert (0 <= P s ^ 2) by apply pow2_ge_0. nra.
Qed.

(** h = - B - k P with k >= 0: where h = 0, h' = P (k (alpha3 - alpha1) - alpha2) > 0. *)
Lemma force_positive k : 0 <= k -> k * p start <= - b start ->
  (forall xi, in_box low high xi -> alpha2 xi < k * (alpha3 xi - alpha1 xi)) ->
  forall s, 0 <= s -> s <= T -> B s < 0 /\ k * P s <= - B s.
Proof.
intros Hk Hk0 Ha. set (h s := - B s - k * P s).
assert (D : forall s, 0 <= s <= T -> is_derive h s (- (alpha2 (state xi s) * P s + alpha3 (state xi s) * B s)
  - k * (alpha1 (state xi s) * P s))).
{ intros s Hs. apply (is_derive_minus (fun s => - B s) (fun s => k * P s)).
  apply (is_derive_opp B), B_rate, Hs. apply (is_derive_scal P), P_rate, Hs. }
assert (Up : forall s, 0 <= s <= T -> h s = 0 -> 0 < - (alpha2 (state xi s) * P s + alpha3 (state xi s) * B s)
  - k * (alpha1 (state xi s) * P s)).
{ intros s Hs E. assert (Bk : B s = - k * P s) by (unfold h in E; lra). rewrite Bk.
  specialize (Ha _ (Hin s Hs)). assert (Pp := P_pos s ltac:(lra) ltac:(lra)). nra. }
assert (H : forall s, 0 <= s -> s <= T -> 0 <= h s).
{ apply (real_induction (fun s => s <= T -> 0 <= h s) 0).
  - intros _. unfold h, B, P. rewrite state_0. lra.
  - intros t Ht H. destruct (Rle_dec t T) as [L|L].
    2: { exists 1. split; [lra|]. intros s Hs Hs'. lra. }
    destruct (H t ltac:(lra) L) as [Hpos|E].
    + destruct (continuous_pos h t) as [d Hd]; auto. { eexists. apply D. lra. }
      exists d. split; [apply cond_pos|]. intros s Hs _. apply Rlt_le, Hd. change (Rabs (s - t) < d).
      rewrite Rabs_pos_eq; lra.
    + destruct (derive_pos_after h t _ (D t ltac:(lra)) (eq_sym E) (Up t ltac:(lra) (eq_sym E))) as (d & Hd & N).
      exists d. split; auto. intros s Hs _. destruct (Req_dec s t) as [->|Hne]; [lra|]. apply Rlt_le, N. lra.
  - intros t Ht H Hle. apply (closed_ge h 0 t 0 Ht). eexists; apply D; lra. intros s Hs. apply H; lra. }
intros s Hs Hle. assert (Q := H s Hs Hle). unfold h in Q. split; [|lra].
destruct (Req_dec s 0) as [->|Hne]. { unfold B. rewrite state_0. lra. }
assert (Pp := P_pos s Hs Hle). assert (0 <= k * P s) by (apply Rmult_le_pos; lra).
destruct (H s Hs Hle) as [Hpos|E]. { unfold h in Hpos. lra. }
exfalso. destruct (derive_pos_before h s _ (D s ltac:(lra)) (eq_sym E) (Up s ltac:(lra) (eq_sym E))) as (d & Hd & N).
set (u := Rmax 0 (s - d / 2)). assert (U1 : 0 <= u) by apply Rmax_l. assert (U2 : s - d / 2 <= u) by apply Rmax_r.
assert (U3 : u < s) by (unfold u, Rmax; destruct Rle_dec; lra).
specialize (N u ltac:(lra)). specialize (H u U1 ltac:(lra)). lra.
Qed.

(** A square whose derivative is 0 and that is 0 at the start. *)
Lemma stays_zero (h h' : R -> R) t : 0 <= t -> (forall s, 0 <= s <= t -> is_derive h s (h' s)) -> h 0 = 0 ->
  (forall s, 0 <= s <= t -> h' s = 0) -> h t = 0.
Proof.
intros Ht D E Z. assert (Q := one_step_zero (fun s => h s ^ 2) (fun s => 0) 0 t 0). cbv beta in Q.
rewrite Rmin_left, Rmax_right in Q by lra. assert (h t ^ 2 = 0); [|nra]. apply Q.
- intros s Hs. evar_last. apply (is_derive_pow h 2 s (h' s)). apply D, Hs. rewrite Z by auto. simpl. ring.
- intros s. apply pow2_ge_0.
- rewrite E. ring.
- intros s _. rewrite Rabs_R0. lra.
Qed.

(** With y and v: v' = p b - b p = 0, and y' = p v. *)
Lemma contact_kept y v y' v' s :
  contact_functions all F G F' G' y v p b y' v' p' b' alpha1 alpha2 alpha3 low high -> y start = 0 -> v start = 0 ->
  0 <= s <= T -> y (state xi s) = 0 /\ v (state xi s) = 0.
Proof.
intros [_ Dy Dv HF HG] Hy Hv.
assert (V : forall s, 0 <= s <= T -> v (state xi s) = 0).
{ intros t Ht. apply (stays_zero (fun s => v (state xi s)) (fun s => P s * along all v' F (state xi s)
    - B s * along all v' G (state xi s)) t).
  - lra.
  - intros r Hr. apply rate_of. exact Dv. lra.
  - rewrite state_0. exact Hv.
  - intros r Hr. assert (Hi := Hin r ltac:(lra)). destruct (HF _ Hi) as (_ & -> & _).
    destruct (HG _ Hi) as (_ & -> & _). unfold P, B. ring. }
intros Hs. split; [|apply V, Hs].
apply (stays_zero (fun s => y (state xi s)) (fun s => P s * along all y' F (state xi s)
  - B s * along all y' G (state xi s)) s).
- lra.
- intros r Hr. apply rate_of. exact Dy. lra.
- rewrite state_0. exact Hy.
- intros r Hr. assert (Hi := Hin r ltac:(lra)). destruct (HF _ Hi) as (-> & _). destruct (HG _ Hi) as (-> & _).
  rewrite V by lra. ring.
Qed.

End Motion.

(** Whatever moves as X says within N stays within rho of the start: as long as it is in N, so a little longer. *)
Lemma stays T xi rate : (forall i, xi i 0 = start i) ->
  (forall i s, 0 <= s <= T -> is_derive (xi i) s (rate i s)) ->
  (forall i s, 0 <= s <= T -> in_box low high (state xi s) -> rate i s = X i (state xi s)) ->
  forall s, 0 <= s -> s <= T -> forall i, Rabs (xi i s - start i) <= rho i.
Proof.
intros H0 D E.
assert (Near : forall u, 0 <= u <= T -> (forall s, 0 <= s <= u -> in_box low high (state xi s)) ->
  forall i, Rabs (xi i u - start i) <= rho i).
{ intros u Hu Hin i. apply (near_start u xi H0); auto; [|lra]. intros j s Hs.
  rewrite <- E; auto; [|lra]. apply D. lra. }
assert (Box : forall s, (forall i, Rabs (xi i s - start i) <= rho i) -> in_box low high (state xi s)).
{ intros s H i. assert (Q := near_is_inside _ H i). unfold state. simpl in Q. lra. }
apply (real_induction (fun s => s <= T -> forall i, Rabs (xi i s - start i) <= rho i) 0).
- intros _ i. rewrite H0. unfold Rminus. rewrite Rplus_opp_r, Rabs_R0. apply rho_nonneg.
- intros t Ht H. destruct (Rle_dec t T) as [L|L].
  2: { exists 1. split; [lra|]. intros s Hs Hs'. lra. }
  assert (Q : locally t (fun s => forall i, In i all -> low i < xi i s < high i)).
  { apply (locally_all all t (fun i s => low i < xi i s < high i)). intros i.
    assert (N := near_is_inside _ (H t ltac:(lra) L) i). simpl in N.
    assert (X1 : ex_derive (xi i) t) by (eexists; apply D; lra).
    assert (Lo : locally t (fun s => 0 < xi i s - low i)).
    { apply (continuous_pos (fun s => xi i s - low i)); [auto_derive; auto|lra]. }
    assert (Hi : locally t (fun s => 0 < high i - xi i s)).
    { apply (continuous_pos (fun s => high i - xi i s)); [auto_derive; auto|lra]. }
    generalize (filter_and _ _ Lo Hi).
    apply filter_imp. intros s Hs. lra. }
  destruct Q as [d Hd]. exists d. split; [apply cond_pos|]. intros s Hs Hle. apply Near; [lra|]. intros u Hu.
  destruct (Rle_dec u t) as [Lu|Lu]. { apply Box. apply H; lra. }
  intros i. assert (Q : low i < xi i u < high i); [|unfold state; lra].
  apply Hd; [|apply Hall]. change (Rabs (u - t) < d). rewrite Rabs_pos_eq; lra.
- intros t Ht H Hle i. assert (X1 : ex_derive (xi i) t) by (eexists; apply D; lra).
  assert (S : forall s, 0 <= s < t -> - rho i <= xi i s - start i <= rho i).
  { intros s Hs. specialize (H s ltac:(lra) ltac:(lra) i). apply Rabs_le_between in H. exact H. }
  assert (Lo : - rho i <= xi i t - start i).
  { apply (closed_ge (fun s => xi i s - start i) 0 t); auto. auto_derive; auto. intros s Hs. apply S, Hs. }
  assert (Hi : - rho i <= start i - xi i t).
  { apply (closed_ge (fun s => start i - xi i s) 0 t); auto. auto_derive; auto. intros s Hs. specialize (S s Hs). lra. }
  apply Rabs_le. lra.
Qed.

Lemma flow_lipschitz : exists L, forall i, lipschitz_on I low high (X i) L.
Proof.
apply (lipschitz_all I all low high Hall). intros i.
destruct (smooth_lipschitz I all low high Hall (F i) (F' i)) as (L1 & Q1). { destruct HC; auto. }
destruct (smooth_lipschitz I all low high Hall (G i) (G' i)) as (L2 & Q2). { destruct HC; auto. }
destruct (smooth_lipschitz I all low high Hall p p') as (L3 & Q3). { destruct HC; auto. }
destruct (smooth_lipschitz I all low high Hall b b') as (L4 & Q4). { destruct HC; auto. }
destruct (lipschitz_mult I all low high Hall box_order p (F i) L3 L1 Q3 Q1) as (M1 & N1).
destruct (lipschitz_mult I all low high Hall box_order b (G i) L4 L2 Q4 Q2) as (M2 & N2).
exists (M1 + M2). apply (lipschitz_minus I low high (fun v => p v * F i v) (fun v => b v * G i v)); auto.
Qed.

(** ** The whole way *)

Section Way.
Variable xi : I -> R -> R.
Hypothesis H0 : forall i, xi i 0 = start i.
Hypothesis Hclamp : forall i s, is_derive (xi i) s (X i (clamp I low high (state xi s))).

Let P s := p (state xi s).
Let B s := b (state xi s).

Lemma way_near s i : 0 <= s -> Rabs (xi i s - start i) <= rho i.
Proof.
intros Hs. apply (stays s xi (fun i s => X i (clamp I low high (state xi s)))); auto; try lra.
intros j u _ Hu. rewrite clamp_inside; auto.
Qed.

Lemma way_inside s : 0 <= s -> in_box low high (state xi s).
Proof.
intros Hs i. assert (Q := near_is_inside (state xi s)). unfold state in *. specialize (Q (fun i => way_near s i Hs) i).
simpl in Q. lra.
Qed.

Lemma way_moves i s : 0 <= s -> is_derive (xi i) s (X i (state xi s)).
Proof. intros Hs. rewrite <- (clamp_inside I low high (state xi s)) at 1. apply Hclamp. apply way_inside, Hs. Qed.

Lemma way_pos s : 0 <= s -> 0 < P s.
Proof. intros Hs. apply (P_pos s xi H0); try lra; intros; [apply way_moves|apply way_inside]; lra. Qed.

Lemma both_small eps : 0 < eps -> exists S, 0 <= S /\ forall s, S <= s -> P s <= eps /\ Rabs (B s) <= eps.
Proof.
intros He. set (m := Rmin a1 a3). assert (A1 := a1_pos). assert (A3 := a3_pos).
assert (Hm : 0 < m) by (apply Rmin_pos; auto).
set (C := B 0 ^ 2 + (A2 ^ 2 / (a1 * a3) + 1) * P 0 ^ 2).
assert (e2 : 0 < eps ^ 2) by (apply pow_lt; auto).
exists (Rmax 0 (C / (m * eps ^ 2))). split. apply Rmax_l. intros s Hs.
assert (S0 : 0 <= s) by (eapply Rle_trans; [apply Rmax_l|exact Hs]).
assert (S1 : C <= m * s * eps ^ 2).
{ assert (Q : C / (m * eps ^ 2) <= s) by (eapply Rle_trans; [apply Rmax_r|exact Hs]).
  assert (0 < m * eps ^ 2) by (apply Rmult_lt_0_compat; auto).
  apply (Rmult_le_compat_r (m * eps ^ 2)) in Q; [|lra]. replace (C / (m * eps ^ 2) * (m * eps ^ 2)) with C in Q
    by (field; split; [apply Rgt_not_eq, He|lra]). lra. }
assert (F0 := both_fall s xi (fun i u H => way_moves i u (proj1 H)) (fun u H => way_inside u (proj1 H)) s ltac:(lra)).
cbv beta in F0. fold (P s) (B s) (P 0) (B 0) m C in F0. assert (E := exp_ineq1_le (m * s)).
assert (Pp := way_pos s S0). assert (Bp := Rabs_pos (B s)).
assert (Small : P s ^ 2 + B s ^ 2 <= eps ^ 2).
{ apply Rnot_lt_le. intros Hlt. assert (0 <= m * s) by (apply Rmult_le_pos; lra).
  set (W := P s ^ 2 + B s ^ 2) in *.
  assert (W * (1 + m * s) <= W * exp (m * s)) by (apply Rmult_le_compat_l; lra).
  assert (eps ^ 2 * (m * s) <= W * (m * s)) by (apply Rmult_le_compat_r; lra). lra. }
assert (BB : Rabs (B s) * Rabs (B s) = B s ^ 2).
{ rewrite <- Rabs_mult, Rabs_pos_eq; [ring|apply Rle_0_sqr]. }
assert (0 <= P s ^ 2) by apply pow2_ge_0. assert (0 <= B s ^ 2) by apply pow2_ge_0.
split; apply Rsqr_incr_0_var; unfold Rsqr; lra.
Qed.

Lemma reach_small c e eps : 0 <= c -> 0 <= e -> 0 < eps -> exists S, 0 <= S /\ forall s, S <= s ->
  reach a1 a3 A2 (P s) (B s) c e < eps.
Proof.
intros Hc He Heps. assert (A1 := a1_pos). assert (A3 := a3_pos). destruct sizes as [HA _].
set (k := c / a1 + e * ((1 + A2 / a1) / a3)).
assert (Hk : 0 <= k).
{ assert (I1 := Rinv_0_lt_compat _ A1). assert (I3 := Rinv_0_lt_compat _ A3). unfold k, Rdiv.
  assert (0 <= A2 * / a1) by (apply Rmult_le_pos; lra).
  apply Rplus_le_le_0_compat; repeat apply Rmult_le_pos; lra. }
assert (He2 : 0 < eps / (k + 1)) by (apply Rdiv_lt_0_compat; lra).
destruct (both_small _ He2) as (S & HS & Q). exists S. split; auto. intros s Hs. destruct (Q s Hs) as [Q1 Q2].
apply Rle_lt_trans with (reach a1 a3 A2 (eps / (k + 1)) (eps / (k + 1)) c e).
- apply reach_le; auto. rewrite (Rabs_pos_eq (eps / (k + 1))); lra.
- unfold reach. rewrite Rabs_pos_eq by lra.
  assert (Q3 : forall q, c * (q / a1) + e * ((q + A2 * (q / a1)) / a3) = q * k) by (intros q; unfold k; field; lra).
  rewrite Q3.
  apply Rmult_lt_reg_r with (k + 1); [lra|]. replace (eps / (k + 1) * k * (k + 1)) with (eps * k) by (field; lra). nra.
Qed.

Lemma way_cauchy i s t : 0 <= s -> s <= t -> Rabs (xi i t - xi i s) <= reach a1 a3 A2 (P s) (B s) (f i) (g i).
Proof.
intros Hs Hst. destruct sizes as [HA FG]. destruct (FG i) as [Hf Hg].
assert (Q := travel t xi H0 (fun i u H => way_moves i u (proj1 H)) (fun u H => way_inside u (proj1 H)) (xi i)
  (fun u => X i (state xi u)) (f i) (g i) s t Hf Hg).
eapply Rle_trans; [apply Q; try lra; clear Q|].
- intros u Hu. apply way_moves, Hu.
- intros u Hu. destruct (bounds _ (way_inside u (proj1 Hu))) as (_ & _ & _ & FGi). destruct (FGi i) as [Fi Gi].
  assert (Pp := way_pos u (proj1 Hu)). unfold X, slip_flow, Rminus.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, !Rabs_mult. fold (P u) (B u).
  rewrite (Rabs_pos_eq (P u)) by lra. generalize (Rabs_pos (B u)). nra.
- fold (P s) (B s) (P t) (B t). assert (Pt := way_pos t ltac:(lra)).
  assert (N := reach_nonneg a1 a3 A2 (P t) (B t) (f i) (g i) a1_pos a3_pos HA (Rlt_le _ _ Pt) Hf Hg). lra.
Qed.

Definition spot (i : I) : R := real (Lim_seq (fun n => xi i (INR n))).

Lemma spot_near i s : 0 <= s -> Rabs (xi i s - spot i) <= reach a1 a3 A2 (P s) (B s) (f i) (g i).
Proof.
destruct sizes as [HA FG]. destruct (FG i) as [Hf Hg].
apply (limit_near (xi i) (fun s => reach a1 a3 A2 (P s) (B s) (f i) (g i))).
- intros t u. apply way_cauchy.
- intros eps He. apply reach_small; auto.
Qed.

Lemma spot_limit i : is_lim (xi i) p_infty (spot i).
Proof.
destruct sizes as [HA FG]. destruct (FG i) as [Hf Hg].
apply (limit_of_tail (xi i) (fun s => reach a1 a3 A2 (P s) (B s) (f i) (g i))).
- intros t u. apply way_cauchy.
- intros eps He. apply reach_small; auto.
Qed.

(** All components at once. *)
Lemma spot_near_all eps : 0 < eps -> exists S, 0 <= S /\ forall s, S <= s -> forall i, Rabs (xi i s - spot i) <= eps.
Proof.
intros He. destruct sizes as [HA FG].
assert (Q : forall l, exists S, 0 <= S /\ forall s, S <= s -> forall i, In i l -> Rabs (xi i s - spot i) <= eps).
{ induction l as [|j r (S & HS & Q)]. { exists 0. split; [lra|intros s _ i []]. }
  destruct (FG j) as [Hf Hg]. destruct (reach_small (f j) (g j) eps Hf Hg He) as (S' & HS' & Q').
  exists (S + S'). split; [lra|]. intros s Hs i [<-|Hi].
  - eapply Rle_trans; [apply spot_near; lra|]. apply Rlt_le, Q'. lra.
  - apply Q; auto. lra. }
destruct (Q all) as (S & HS & Q'). exists S. split; auto.
Qed.

Lemma spot_inside : in_box low high spot.
Proof.
assert (A : forall eps, 0 < eps -> forall i, low i - eps <= spot i <= high i + eps).
{ intros eps He i. destruct (spot_near_all eps He) as (S & HS & Q). specialize (Q S ltac:(lra) i).
  assert (W := way_inside S HS i). unfold state in W. apply Rabs_le_between in Q. lra. }
intros i. split; apply le_epsilon; intros eps He; specialize (A eps He i); lra.
Qed.

(** A function that tends to 0 along the way is 0 at the spot. *)
Lemma zero_at_spot phi d : smooth_on all phi d low high ->
  (forall eps, 0 < eps -> exists S, 0 <= S /\ forall s, S <= s -> Rabs (phi (state xi s)) <= eps) -> phi spot = 0.
Proof.
intros D Z. destruct (smooth_lipschitz I all low high Hall phi d D) as (L & L0 & HL).
apply Rabs_eq_0, Rle_antisym; [|apply Rabs_pos]. apply le_epsilon. intros eps He.
destruct (Z (eps / 2) ltac:(lra)) as (S & HS & Q).
assert (He2 : 0 < eps / 2 / (L + 1)) by (repeat apply Rdiv_lt_0_compat; lra).
destruct (spot_near_all _ He2) as (S' & HS' & Q').
specialize (Q (S + S') ltac:(lra)). specialize (Q' (S + S') ltac:(lra)).
specialize (HL (state xi (S + S')) spot _ (way_inside (S + S') ltac:(lra)) spot_inside Q').
assert (L * (eps / 2 / (L + 1)) <= eps / 2).
{ apply Rmult_le_reg_r with (L + 1); [lra|]. replace (L * (eps / 2 / (L + 1)) * (L + 1)) with (L * (eps / 2))
    by (field; lra). nra. }
replace (phi spot) with (phi (state xi (S + S')) - (phi (state xi (S + S')) - phi spot)) by ring.
eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
Qed.

Definition time (s : R) : R := RInt (fun u => p (clamp I low high (state xi u))) 0 s.

Lemma time_rate s : 0 <= s -> is_derive time s (P s).
Proof.
intros Hs. destruct (smooth_lipschitz I all low high Hall p p') as (L & HL). { destruct HC; auto. }
assert (Cont : forall u, continuous (fun u => p (clamp I low high (state xi u))) u).
{ apply (clamp_continuous I all low high Hall box_order p L xi HL). intros i t. apply (ex_derive_continuous (xi i)).
  eexists. apply Hclamp. }
unfold P. rewrite <- (clamp_inside I low high (state xi s)) by (apply way_inside, Hs).
apply (is_derive_RInt (fun u => p (clamp I low high (state xi u))) time 0 s); [|apply Cont].
apply filter_forall. intros u. apply (RInt_correct (V := R_CompleteNormedModule)),
  (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t _. apply Cont.
Qed.

Lemma time_bound s : 0 <= s -> time s <= p1 / a1.
Proof.
intros Hs. assert (A1 := a1_pos). destruct sizes as [HA _].
assert (Q := travel s xi H0 (fun i u H => way_moves i u (proj1 H)) (fun u H => way_inside u (proj1 H)) time P 1 0 0 s
  ltac:(lra) (Rle_refl 0)).
assert (T0 : time 0 = 0) by (unfold time; rewrite RInt_point; reflexivity).
rewrite T0, Rminus_0_r in Q.
eapply Rle_trans; [apply Rle_abs|]. eapply Rle_trans; [apply Q; try lra; clear Q|].
- intros u Hu. apply time_rate, Hu.
- intros u Hu. fold (P u). rewrite Rabs_pos_eq by (apply Rlt_le, way_pos, Hu). lra.
- unfold reach. fold (P 0) (P s). assert (Pp := way_pos s Hs). assert (I1 := Rinv_0_lt_compat _ A1).
  assert (P0 : P 0 <= p1). { unfold P. rewrite (state_0 xi H0). lra. }
  assert (0 <= P s * / a1) by (apply Rmult_le_pos; lra).
  assert (P 0 * / a1 <= p1 * / a1) by (apply Rmult_le_compat_r; lra). unfold Rdiv. lra.
Qed.

Lemma way_force : force_stays_positive alpha1 alpha2 alpha3 low high (- b start / p start) ->
  forall s, 0 <= s -> 0 < - B s / P s.
Proof.
intros H s Hs. assert (Pp := way_pos s Hs). apply Rdiv_lt_0_compat; auto.
assert (FP := force_positive s xi H0 (fun i u H => way_moves i u (proj1 H)) (fun u H => way_inside u (proj1 H))).
fold P B in FP. assert (N : B s < 0); [|lra]. destruct H as [H|(d & Hd & H)].
- apply (fun k A B C => proj1 (FP k A B C s Hs (Rle_refl s))) with (k := 0); try lra.
  intros v0 Hv. rewrite Rmult_0_l. apply H, Hv.
- assert (L0 : 0 < - b start / p start) by (apply Rdiv_lt_0_compat; lra).
  apply (fun k A B C => proj1 (FP k A B C s Hs (Rle_refl s))) with (k := - b start / p start); try lra.
  + right. field. lra.
  + intros v0 Hv. destruct (H v0 Hv) as [H1 H2]. nra.
Qed.

End Way.

Theorem captured : exists (xi : I -> R -> R) (spot : I -> R) (time : R -> R),
  arrival F G p b low high a1 a3 A2 p1 b1 f g start xi spot time /\
  (force_stays_positive alpha1 alpha2 alpha3 low high (- b start / p start) ->
    forall s, 0 <= s -> 0 < - b (state xi s) / p (state xi s)) /\
  forall y v y' v', contact_functions all F G F' G' y v p b y' v' p' b' alpha1 alpha2 alpha3 low high ->
    y start = 0 -> v start = 0 ->
    (forall s, 0 <= s -> y (state xi s) = 0 /\ v (state xi s) = 0) /\ y spot = 0 /\ v spot = 0.
Proof.
destruct flow_lipschitz as (L & HL).
destruct (clamped_solution I all low high Hall box_order X L HL start) as (xi & H0 & D).
assert (M := way_moves xi H0 D). assert (In := way_inside xi H0 D).
assert (Zero : forall phi : (I -> R) -> R, (forall s, 0 <= s -> phi (state xi s) = 0) -> forall eps, 0 < eps ->
  exists S, 0 <= S /\ forall s, S <= s -> Rabs (phi (state xi s)) <= eps).
{ intros phi H eps He. exists 0. split; [lra|]. intros s Hs. rewrite H, Rabs_R0; lra. }
exists xi, (spot xi), (time xi). split; [constructor|split].
- exact H0.
- intros T i s Hs. eapply is_derive_val; [apply M, Hs|]. unfold X, state. ring.
- intros T other O0 OD i s Hs.
  assert (OM : forall i u, 0 <= u <= T -> is_derive (other i) u (X i (state other u))).
  { intros j u Hu. eapply is_derive_val; [apply OD, Hu|]. unfold X, state. ring. }
  assert (ON := stays T other (fun i u => X i (state other u)) O0 OM (fun _ _ _ _ => eq_refl)).
  apply (clamped_unique I all low high Hall box_order X L HL xi other s); try lra.
  + intros u Hu. split; [apply In, Hu|]. intros j. assert (Q := near_is_inside _ (ON u ltac:(lra) ltac:(lra)) j).
    unfold state. simpl in Q. lra.
  + intros j u Hu. apply M, Hu.
  + intros j u Hu. apply OM. lra.
  + intros j. rewrite O0, H0. reflexivity.
- intros s Hs. exact (conj (In s Hs) (way_pos xi H0 D s Hs)).
- exact (spot_limit xi H0 D).
- repeat apply conj.
  + exact (spot_inside xi H0 D).
  + apply (zero_at_spot xi H0 D p p'); [destruct HC; auto|]. intros eps He.
    destruct (both_small xi H0 D eps He) as (S & HS & Q). exists S. split; auto. intros s Hs.
    assert (Pp := way_pos xi H0 D s ltac:(lra)). rewrite Rabs_pos_eq by lra. apply Q, Hs.
  + apply (zero_at_spot xi H0 D b b'); [destruct HC; auto|]. intros eps He.
    destruct (both_small xi H0 D eps He) as (S & HS & Q). exists S. split; auto. intros s Hs. apply Q, Hs.
- intros i. assert (Q := spot_near xi H0 D i 0 (Rle_refl 0)). rewrite H0, Rabs_minus_sym in Q.
  eapply Rle_trans; [exact Q|]. destruct sizes as [HA FG]. destruct (FG i) as [Hf Hg]. rewrite (state_0 xi H0).
  apply reach_le; auto using a1_pos, a3_pos. lra. rewrite Rabs_left1, Rabs_pos_eq; lra.
- intros s i Hs. apply (spot_near xi H0 D i s Hs).
- unfold time. rewrite RInt_point. reflexivity.
- intros s Hs. split; [apply (time_rate xi H0 D s Hs)|apply (time_bound xi H0 D s Hs)].
- intros Hf s Hs. apply (way_force xi H0 D Hf s Hs).
- intros y v y' v' Hyv Hy Hv.
  assert (K : forall s, 0 <= s -> y (state xi s) = 0 /\ v (state xi s) = 0).
  { intros s Hs. apply (contact_kept s xi H0 (fun i u H => M i u (proj1 H)) (fun u H => In u (proj1 H)) y v y' v' s);
      auto. lra. }
  destruct Hyv as [_ Dy Dv _ _]. split; [exact K|split].
  + apply (zero_at_spot xi H0 D y y' Dy), Zero. intros s Hs. apply K, Hs.
  + apply (zero_at_spot xi H0 D v v' Dv), Zero. intros s Hs. apply K, Hs.
Qed.

End Capture.
