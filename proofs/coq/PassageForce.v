(** * Theorem B: contact from a state towards the G-spot, for all eps at once

    proofs/from_state.md, section 4. First for a motion of the contact equations ([Linear]). U = Z + I + m J, with m >
    0 and J that grows by itself, is a strict upper solution of (6) below z_max ([upper_grows]). By induction along
    the time L keeps its sign and F = (U p L)^2 - |x|^2 is positive ([below_upper]): L' is at most k|L| until then, so
    L is not 0 at a first time where this ends, and there F = 0 with F' > 0. m tends to 0. The force is mean + L (1 +
    w + w2) ([force_positive]). At last a motion with lift-off is one of the contact equations as long as y < z
    ([passage]). *)

From Coq Require Import Reals Psatz Lra List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus NonnegativeOrthant LogarithmicNorm StatementStep StatementPassage PassageEquations
  PassageNorm PassageBarrier.
Open Scope R_scope.

Section Checked.
Variables (M : model_system) (P : slow_part) (K : weights) (N : numbers) (source Z : monomials).
Hypothesis HN : passage_checked M P K N source Z.
Variables (eps : R) (x : motion) (t0 : R).
Hypothesis Heps : 0 < eps.
Hypothesis He0 : - alpha1 M * eps <= e0 N.
Hypothesis Hp0 : p x t0 = p1 N.
Hypothesis HL0 : L_at M x t0 = L1 N.
Hypothesis Hz0 : ratio M P K eps x t0 <= z0 N.
Let e := - alpha1 M * eps.
Let h := h_at M eps x.
Let r := r_at x.
Let share := c_W M K (h1 N) (r1 N).
Let W_star := share * z_max N.
Let w t := value_of (slow_w P) (h t) (r t).
Let w2 t := second (deviation_at M P eps x t) / (p x t * L_at M x t).
Let I t := layer (Gamma N) (theta N) (z0 N) (p1 N) e (p x t).

Lemma weights_of : weights_good M K.
Proof. destruct (of_model _ _ _ _ _ _ HN) as (HM & _ & _ & Hb & Hm & Hn). repeat split; try lra; apply HM. Qed.

Lemma a3_differs : alpha3 M <> alpha1 M.
Proof.
destruct (of_model _ _ _ _ _ _ HN) as (_ & H1 & _ & Hb & _). intros Q. unfold beta_of in Hb. rewrite Q in Hb.
unfold Rdiv in Hb. rewrite Rinv_r in Hb; lra.
Qed.

Lemma mean_positive : 0 < mean_of M.
Proof.
destruct (of_model _ _ _ _ _ _ HN) as (_ & H1 & H2 & Hb & _). unfold beta_of in Hb. unfold mean_of.
assert (H3 : alpha3 M < alpha1 M).
{ apply Ropp_lt_cancel. replace (- alpha3 M) with (alpha3 M / alpha1 M * - alpha1 M) by (field; lra).
  rewrite <- (Rmult_1_l (- alpha1 M)) at 1. apply Rmult_lt_compat_r; lra. }
replace (alpha2 M / (alpha3 M - alpha1 M)) with (- alpha2 M / (alpha1 M - alpha3 M)) by (field; lra).
apply Rdiv_lt_0_compat; lra.
Qed.

(** Where the motion is on the rectangle. *)
Lemma on_way t : 0 < p x t <= p1 N -> h t <= h1 N -> on_rectangle M K eps x (h1 N) (r1 N) t.
Proof.
intros Hp Hh. destruct (of_model _ _ _ _ _ _ HN) as (_ & H1 & _).
destruct (of_start _ _ _ _ _ _ HN) as (_ & _ & _ & Hr & _).
destruct (of_rectangle _ _ _ _ _ _ HN) as (_ & _ & Hd).
repeat split; try apply weights_of; auto; try lra. apply a3_differs.
apply Rle_trans with (2 := Hr). apply sqrt_le_1_alt, Hp.
Qed.

Lemma share_positive : 0 < share.
Proof. destruct (of_rectangle _ _ _ _ _ _ HN) as (_ & _ & Hd). apply Rinv_0_lt_compat, sqrt_lt_R0, Hd. Qed.

Lemma Z_nonnegative : nonnegative Z.
Proof.
destruct (of_rectangle _ _ _ _ _ _ HN) as (_ & Ht & _).
apply (barrier_pays (Gamma N) (theta N) 1 1 Ht Rlt_0_1 Rlt_0_1 source Z (barrier _ _ _ _ _ _ HN)).
Qed.

(** Z + I is below z_max, by the same gap everywhere. *)
Let gap := z_max N - (value_of Z (h1 N) (r1 N)
  + Rmax (z0 N) (layer (Gamma N) (theta N) (z0 N) (p1 N) (e0 N) (p_at_h (e0 N) (h1 N)))).

Lemma gap_positive : 0 < gap.
Proof. assert (B := below _ _ _ _ _ _ HN). unfold gap. lra. Qed.

Lemma e_positive : 0 < e.
Proof. destruct (of_model _ _ _ _ _ _ HN) as (_ & H1 & _). apply Rmult_lt_0_compat; lra. Qed.

Lemma barrier_low t : 0 < p x t <= p1 N -> h t <= h1 N ->
  0 <= value_of Z (h t) (r t) + I t <= z_max N - gap.
Proof.
intros Hp Hh. assert (Hon := on_way t Hp Hh). assert (Hh' := h_within _ _ _ _ _ _ _ Hon).
assert (Hr' := r_within _ _ _ _ _ _ _ Hon). cbv zeta in Hh', Hr'. fold h in Hh'. fold r in Hr'.
destruct (of_start _ _ _ _ _ _ HN) as (H1 & Hz & H0 & _ & HS). destruct (of_rectangle _ _ _ _ _ _ HN) as (Hh1 & Ht & _).
assert (A := value_nonneg Z (h t) (r t) Z_nonnegative ltac:(lra) ltac:(lra)).
assert (B := value_increases Z (h t) (r t) (h1 N) (r1 N) Z_nonnegative ltac:(lra) ltac:(lra)).
assert (I0 : 0 <= I t).
{ apply Rmult_le_pos; [apply Rmult_le_pos; [exact Hz|]|]; apply Rlt_le, exp_pos. }
assert (Q : e <= h1 N * (p x t * sqrt (p x t))).
{ assert (D : 0 < p x t * sqrt (p x t)) by (apply Rmult_lt_0_compat; [lra|apply sqrt_lt_R0; lra]).
  apply (Rmult_le_compat_r (p x t * sqrt (p x t))) in Hh; [|lra].
  apply Rle_trans with (2 := Hh). right. unfold h, h_at. fold e. field. split; [|lra].
  apply Rgt_not_eq, sqrt_lt_R0; lra. }
assert (LB := layer_below (Gamma N) (theta N) (z0 N) (p1 N) (e0 N) (h1 N) e (p x t) Hz Ht H1 Hh1
  (conj e_positive He0) HS (fading _ _ _ _ _ _ HN) Hp Q).
unfold gap. fold (I t) in LB. lra.
Qed.

(** The force. *)
Lemma force_is t : 0 < p x t -> L_at M x t <> 0 ->
  spring_force M eps x t = mean_of M + L_at M x t * (1 + (w t + w2 t)).
Proof.
intros Hp HL. assert (E : W_at M eps x t = p x t * L_at M x t * (w t + w2 t)).
{ unfold w2, deviation_at, w; simpl. fold h r. rewrite (p_is_square x t Hp). fold r.
  assert (R0 := r_positive x t Hp). fold r in R0. field. split; [exact HL|lra]. }
assert (E' : p x t * L_at M x t = - b x t - mean_of M * p x t) by (unfold L_at; field; lra).
apply Rmult_eq_reg_l with (p x t); [|lra].
replace (p x t * spring_force M eps x t) with (W_at M eps x t - b x t) by (unfold W_at; ring).
rewrite E. lra.
Qed.

(** w and w2 where z < z_max. *)
Lemma parts_small t : 0 < p x t <= p1 N -> h t <= h1 N -> L_at M x t <> 0 -> ratio M P K eps x t < z_max N ->
  - w_minus N <= w t <= w_plus N /\ Rabs (w2 t) <= W_star.
Proof.
intros Hp Hh HL Hz. assert (Hon := on_way t Hp Hh). split.
- apply (of_w _ _ _ _ _ _ HN). apply (h_within _ _ _ _ _ _ _ Hon). apply (r_within _ _ _ _ _ _ _ Hon).
- apply Rle_trans with (1 := w2_small M P K (h1 N) (r1 N) eps x t Hon HL). apply Rmult_le_compat_l.
  apply Rlt_le, share_positive. lra.
Qed.

Lemma force_positive t : 0 < p x t <= p1 N -> h t <= h1 N -> 0 < L1 N * L_at M x t ->
  (L1 N < 0 -> L1 N <= L_at M x t) -> ratio M P K eps x t < z_max N -> 0 < spring_force M eps x t.
Proof.
intros Hp Hh HL Hfall Hz. assert (HLn : L_at M x t <> 0) by (intros Q; rewrite Q in HL; lra).
destruct (parts_small t Hp Hh HLn Hz) as [[Wl Wh] W2]. apply Rabs_le_between in W2. rewrite force_is by tauto.
assert (Mp := mean_positive). destruct (of_model _ _ _ _ _ _ HN) as (_ & _ & _ & Hb & _).
destruct (of_sign _ _ _ _ _ _ HN) as [(Hs & Hw)|(Hs & Hw & Hf)]; fold share W_star in Hw.
- assert (HLp : 0 < L_at M x t) by (apply Rmult_lt_reg_l with (L1 N); lra).
  assert (0 < L_at M x t * (1 + (w t + w2 t))) by (apply Rmult_lt_0_compat; lra). lra.
- fold share W_star in Hf. specialize (Hfall Hs).
  assert (HLn' : L_at M x t < 0) by (apply Ropp_lt_cancel, Rmult_lt_reg_l with (- L1 N); lra).
  assert (Q1 : w_minus N + W_star < 1).
  { apply Rmult_lt_reg_l with (beta_of M). lra. lra. }
  assert (Q2 : L_at M x t * (1 + w_plus N + W_star) <= L_at M x t * (1 + (w t + w2 t))).
  { apply Rmult_le_compat_neg_l; lra. }
  assert (Q3 : L1 N * (1 + w_plus N + W_star) <= L_at M x t * (1 + w_plus N + W_star)).
  { apply Rmult_le_compat_r; lra. } lra.
Qed.

(** ** A motion of the contact equations *)

Section Linear.
Variable t1 : R.
Hypothesis Ht1 : t0 <= t1.
Hypothesis HX : forall t, t0 <= t <= t1 -> moves_by M eps spring_force x t.
Hypothesis Hp1 : 0 < p x t1.
Hypothesis Hh1 : h t1 <= h1 N.

Lemma p_falls s t : t0 <= s -> s <= t -> t <= t1 -> p x t <= p x s.
Proof.
intros Hs Hst Ht. destruct (of_model _ _ _ _ _ _ HN) as (_ & H1 & _).
apply (decr_of_derive (p x) (fun _ => alpha1 M) s t Hst).
- intros u Hu. exact (proj1 (HX u ltac:(lra))).
- intros u Hu. lra.
Qed.

Lemma p_within t : t0 <= t <= t1 -> 0 < p x t <= p1 N.
Proof.
intros Ht. rewrite <- Hp0. assert (A := p_falls t0 t). assert (B := p_falls t t1). lra.
Qed.

Lemma h_low t : t0 <= t <= t1 -> h t <= h1 N.
Proof.
intros Ht. apply Rle_trans with (2 := Hh1). unfold h, h_at. fold e. assert (E0 := e_positive).
assert (B := p_falls t t1 ltac:(lra) ltac:(lra) ltac:(lra)). assert (S := sqrt_lt_R0 _ Hp1).
apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar. apply Rmult_lt_0_compat; auto.
apply Rmult_le_compat; try lra. apply sqrt_le_1_alt, B.
Qed.

Lemma on_t t : t0 <= t <= t1 -> on_rectangle M K eps x (h1 N) (r1 N) t.
Proof. intros Ht. apply on_way. apply p_within, Ht. apply h_low, Ht. Qed.

(** hr is at most rho. *)
Let rho := e / p x t1.
Let hr t := h t * r t.

Lemma hr_within t : t0 <= t <= t1 -> 0 < hr t <= rho.
Proof.
intros Ht. assert (E0 := e_positive). assert (Hp := p_within t Ht). unfold hr, h, r.
rewrite (hr_value M eps x t (proj1 Hp)). fold e. split. apply Rdiv_lt_0_compat; lra.
apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; auto. apply p_falls; lra.
Qed.

Lemma p_rate t : t0 <= t <= t1 -> rate_in_T eps (p x) t (- hr t * p x t).
Proof.
intros Ht. assert (Hp := p_within t Ht). unfold rate_in_T. eapply is_derive_val. exact (proj1 (HX t Ht)).
unfold hr, h, r. rewrite (hr_value M eps x t (proj1 Hp)). field. lra.
Qed.

(** J grows faster than hr Gamma. *)
Let k := Rmax (Gamma N) 0 + 1.
Let J t := exp (k * rho * (t - t0) / eps).

Lemma J_rate t : rate_in_T eps J t (k * rho * J t).
Proof. unfold rate_in_T, J. auto_derive; auto. unfold Rdiv, Rminus. ring. Qed.

Let J_end := exp (k * rho * (t1 - t0) / eps).

Lemma J_within t : t0 <= t <= t1 -> 0 < J t <= J_end.
Proof.
intros Ht. split. apply exp_pos. apply exp_le.
assert (Q := hr_within t1 ltac:(lra)). assert (K0 := Rmax_r (Gamma N) 0).
apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, Heps. apply Rmult_le_compat_l; [|lra].
apply Rmult_le_pos; [unfold k|]; lra.
Qed.

Section Upper.
Variable m : R.
Hypothesis Hm : 0 < m.
Hypothesis Hmgap : m * J_end < gap.
Let U t := value_of Z (h t) (r t) + I t + m * J t.

Lemma U_within t : t0 <= t <= t1 -> 0 < U t < z_max N.
Proof.
intros Ht. assert (B := barrier_low t (p_within t Ht) (h_low t Ht)). assert (Q := J_within t Ht).
assert (0 < m * J t) by (apply Rmult_lt_0_compat; lra).
assert (m * J t <= m * J_end) by (apply Rmult_le_compat_l; lra). unfold U. lra.
Qed.

(** u is U' over hr. *)
Lemma upper_grows t : t0 <= t <= t1 -> exists u, rate_in_T eps U t (hr t * u) /\
  (Gamma N - theta N * r t / h t) * U t + value_of source (h t) (r t) < u.
Proof.
intros Ht. assert (Hp := p_within t Ht). assert (Hon := on_t t Ht).
assert (Hh' := h_within _ _ _ _ _ _ _ Hon). assert (Hr' := r_within _ _ _ _ _ _ _ Hon). cbv zeta in Hh', Hr'.
fold h in Hh'. fold r in Hr'. assert (Hhr := hr_within t Ht). assert (HJ := J_within t Ht). assert (E0 := e_positive).
destruct (of_rectangle _ _ _ _ _ _ HN) as (_ & Hth & _). destruct (of_start _ _ _ _ _ _ HN) as (P1 & _).
destruct (barrier_pays (Gamma N) (theta N) (h t) (r t) Hth ltac:(lra) ltac:(lra) source Z (barrier _ _ _ _ _ _ HN))
  as [_ HS].
set (G := Gamma N - theta N * r t / h t) in *.
exists (G * value_of Z (h t) (r t) + surplus (Gamma N) (theta N) Z (h t) (r t) + G * I t + m * (k * rho / hr t * J t)).
split.
- assert (DZ := value_rate M eps x t Heps (proj1 Hp) (proj1 (HX t Ht)) Z). fold h r in DZ. cbv zeta in DZ.
  fold (h t) (r t) in DZ. rewrite (change_is_surplus (Gamma N) (theta N)) in DZ by (fold h; lra).
  assert (DI := layer_rate (Gamma N) (theta N) (z0 N) (p1 N) e eps (p x) t (hr t) Heps P1 (proj1 Hp) ltac:(lra)
    (p_rate t Ht)).
  assert (EG : Gamma N - theta N * p x t ^ 2 / e = G).
  { unfold G, h. rewrite (h_value M eps x t (proj1 Hp)), (p_is_square x t (proj1 Hp)). fold e r. field. split; lra. }
  rewrite EG in DI. fold (I t) in DI.
  eapply rate_same.
  { apply (rate_plus eps (fun s => value_of Z (h s) (r s) + I s) (fun s => m * J s)); [exact Heps| |].
    apply rate_plus; [exact Heps|exact DZ|exact DI]. apply rate_scal; [exact Heps|]. apply J_rate. }
  fold (h t) (r t). unfold G, hr. unfold hr in Hhr. field. split; lra.
- assert (Gk : G < k).
  { assert (A := Rmax_l (Gamma N) 0). assert (0 < theta N * r t / h t).
    { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. } unfold G, k. lra. }
  assert (K0 : 0 < k) by (assert (A := Rmax_r (Gamma N) 0); unfold k; lra).
  assert (R1 : k <= k * rho / hr t).
  { apply Rmult_le_reg_r with (hr t). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    apply Rmult_le_compat_l; lra. }
  assert (R2 : m * (G * J t) < m * (k * rho / hr t * J t)).
  { apply Rmult_lt_compat_l; auto. apply Rmult_lt_compat_r; lra. }
  unfold U. lra.
Qed.

(** L cannot reach 0 while z < z_max. *)
Lemma L_stays t : t0 < t <= t1 ->
  (forall s, t0 <= s < t -> 0 < L1 N * L_at M x s /\ ratio M P K eps x s < z_max N) -> 0 < L1 N * L_at M x t.
Proof.
intros Ht H. set (c0 := beta_of M - 1 + beta_of M * (Rabs (w_plus N) + W_star)). set (c1 := rho * c0 / eps).
destruct (of_model _ _ _ _ _ _ HN) as (_ & _ & _ & Hb & _).
assert (DL : forall s, t0 <= s < t -> is_derive (L_at M x) s
  (- (hr s) * ((beta_of M - 1) + beta_of M * (w s + w2 s)) * L_at M x s / eps)).
{ intros s Hs. assert (Hn : L_at M x s <> 0) by (intros Q; destruct (H s Hs) as [HL _]; rewrite Q in HL; lra).
  apply (L_rate M P K (h1 N) (r1 N) eps x s (on_t s ltac:(lra)) (HX s ltac:(lra)) Hn). }
assert (HL1 : 0 < L1 N * L1 N) by (rewrite <- HL0 at 2; apply H; lra).
assert (D1 : ex_derive (L_at M x) t).
{ destruct (good_coordinates M eps x t) as (D & _); try (eexists; exact D).
  apply weights_of. exact Heps. destruct (of_model _ _ _ _ _ _ HN); lra. apply a3_differs.
  assert (Q := p_within t ltac:(lra)); lra. apply HX; lra. }
assert (Low : forall s, t0 <= s < t -> L1 N * L1 N * exp (- c1 * (t - t0)) <= L1 N * L_at M x s).
{ intros s Hs.
  assert (G : - (L1 N * L_at M x s * exp (c1 * (s - t0))) <= - (L1 N * L_at M x t0 * exp (c1 * (t0 - t0)))).
  { apply (decr_of_derive (fun s => - (L1 N * L_at M x s * exp (c1 * (s - t0)))) (fun s => - (exp (c1 * (s - t0)) *
      (L1 N * L_at M x s) * (c1 - hr s * ((beta_of M - 1) + beta_of M * (w s + w2 s)) / eps))) t0 s ltac:(lra)).
    - intros u Hu. eapply is_derive_val.
      + apply (is_derive_opp (fun s => L1 N * L_at M x s * exp (c1 * (s - t0)))).
        apply (is_derive_mult_R (fun s => L1 N * L_at M x s) (fun s => exp (c1 * (s - t0)))).
        apply (is_derive_scal (L_at M x)), DL; lra. auto_derive; [exact Logic.I|reflexivity].
      + unfold opp; simpl. unfold Rminus. field. lra.
    - intros u Hu. destruct (H u ltac:(lra)) as [HLu Hzu].
      destruct (parts_small u (p_within u ltac:(lra)) (h_low u ltac:(lra))) as [[_ Wh] W2]; auto.
      { intros Q; rewrite Q in HLu; lra. }
      assert (Hhr := hr_within u ltac:(lra)). apply Rabs_le_between in W2. assert (A := Rle_abs (w_plus N)).
      assert (B0 : beta_of M * (w u + w2 u) <= beta_of M * (Rabs (w_plus N) + W_star))
        by (apply Rmult_le_compat_l; lra).
      assert (C0 : 0 <= c0).
      { assert (0 <= Rabs (w_plus N) + W_star) by (assert (X := Rabs_pos (w_plus N)); lra).
        unfold c0. assert (0 <= beta_of M * (Rabs (w_plus N) + W_star)) by (apply Rmult_le_pos; lra). lra. }
      assert (B1 : hr u * ((beta_of M - 1) + beta_of M * (w u + w2 u)) <= rho * c0).
      { apply Rle_trans with (hr u * c0). apply Rmult_le_compat_l; unfold c0; lra. apply Rmult_le_compat_r; lra. }
      assert (B2 : hr u * ((beta_of M - 1) + beta_of M * (w u + w2 u)) / eps <= c1).
      { apply Rmult_le_compat_r; auto. apply Rlt_le, Rinv_0_lt_compat, Heps. }
      assert (0 <= exp (c1 * (u - t0)) * (L1 N * L_at M x u)
        * (c1 - hr u * ((beta_of M - 1) + beta_of M * (w u + w2 u)) / eps)).
      { apply Rmult_le_pos; [apply Rmult_le_pos|]; try lra. apply Rlt_le, exp_pos. } lra. }
  rewrite HL0, Rminus_eq_0, Rmult_0_r, exp_0 in G.
  assert (C1 : 0 <= c1).
  { assert (Hhr := hr_within t0 ltac:(lra)). apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat, Heps].
    apply Rmult_le_pos; [lra|]. unfold c0. assert (X := Rabs_pos (w_plus N)). assert (Y := share_positive).
    assert (Z0 : 0 < W_star) by (apply Rmult_lt_0_compat; [exact Y|assert (V0 := U_within t0 ltac:(lra)); lra]).
    assert (0 <= beta_of M * (Rabs (w_plus N) + W_star)) by (apply Rmult_le_pos; lra). lra. }
  assert (E1 := exp_pos (- c1 * (t - t0))). destruct (H s Hs) as [HLs _].
  assert (Q : L1 N * L_at M x s * exp (c1 * (s - t0)) * exp (- c1 * (t - t0)) <= L1 N * L_at M x s * 1).
  { rewrite Rmult_assoc, <- exp_plus. apply Rmult_le_compat_l; [lra|]. rewrite <- exp_0. apply exp_le.
    assert (0 <= c1 * (t - s)) by (apply Rmult_le_pos; lra). lra. }
  apply (Rmult_le_compat_r (exp (- c1 * (t - t0)))) in G; lra. }
apply Rlt_le_trans with (L1 N * L1 N * exp (- c1 * (t - t0))).
apply Rmult_lt_0_compat; [exact HL1|apply exp_pos].
apply (closed_ge (fun s => L1 N * L_at M x s) t0 t); [lra|auto_derive; auto|exact Low].
Qed.

(** |x|^2 and F. *)
Let sq t := product_M M K (h t) (r t) (deviation_at M P eps x t) (deviation_at M P eps x t).
Let F t := (U t * (p x t * L_at M x t)) ^ 2 - sq t.

Lemma sq_is s : t0 <= s <= t1 -> sq s = deviation_length M P K eps x s * deviation_length M P K eps x s.
Proof.
intros Hs. assert (Hon := on_t s Hs). assert (Hh' := h_within _ _ _ _ _ _ _ Hon).
assert (Hr' := r_within _ _ _ _ _ _ _ Hon). destruct Hon as (HK & Hd & _). symmetry.
apply (norm_square M K (h s) (r s) (h1 N) (r1 N) HK); [unfold h; lra|unfold r; lra|exact Hd].
Qed.

Lemma L_is_not_0 s : 0 < L1 N * L_at M x s -> L_at M x s <> 0.
Proof. intros H Q. rewrite Q, Rmult_0_r in H. lra. Qed.

Lemma below_is_ratio s : t0 <= s <= t1 -> 0 < L1 N * L_at M x s -> 0 < F s -> ratio M P K eps x s < U s.
Proof.
intros Hs HL HF. assert (HLn := L_is_not_0 s HL). assert (U0 := U_within s Hs). assert (Hp := p_within s Hs).
assert (D : 0 < p x s * Rabs (L_at M x s)) by (apply Rmult_lt_0_compat; [lra|apply Rabs_pos_lt, HLn]).
assert (Q : deviation_length M P K eps x s < U s * (p x s * Rabs (L_at M x s))).
{ apply Rsqr_incrst_0; [|apply sqrt_pos|apply Rmult_le_pos; lra]. unfold F in HF. rewrite sq_is in HF by exact Hs.
  unfold Rsqr. replace (U s * (p x s * Rabs (L_at M x s)) * (U s * (p x s * Rabs (L_at M x s))))
    with (U s * U s * p x s * p x s * (Rabs (L_at M x s) * Rabs (L_at M x s))) by ring.
  rewrite <- Rabs_mult, (Rabs_pos_eq (_ * _)) by apply Rle_0_sqr. lra. }
unfold ratio. apply Rmult_lt_reg_r with (p x s * Rabs (L_at M x s)); auto. unfold Rdiv.
rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. exact Q.
Qed.

Lemma F_zero_is_ratio s : t0 <= s <= t1 -> 0 < L1 N * L_at M x s -> F s = 0 ->
  deviation_length M P K eps x s = U s * (p x s * Rabs (L_at M x s)) /\ U s = ratio M P K eps x s.
Proof.
intros Hs HL HF. assert (HLn := L_is_not_0 s HL). assert (U0 := U_within s Hs). assert (Hp := p_within s Hs).
assert (A0 := Rabs_pos_lt _ HLn).
assert (D : 0 < p x s * Rabs (L_at M x s)) by (apply Rmult_lt_0_compat; lra).
assert (Q : deviation_length M P K eps x s = U s * (p x s * Rabs (L_at M x s))).
{ apply Rsqr_inj; [apply sqrt_pos|apply Rmult_le_pos; lra|]. unfold F in HF. rewrite sq_is in HF by exact Hs.
  unfold Rsqr. replace (U s * (p x s * Rabs (L_at M x s)) * (U s * (p x s * Rabs (L_at M x s))))
    with (U s * U s * p x s * p x s * (Rabs (L_at M x s) * Rabs (L_at M x s))) by ring.
  rewrite <- Rabs_mult, (Rabs_pos_eq (_ * _)) by apply Rle_0_sqr. lra. }
split; [exact Q|]. unfold ratio. rewrite Q. field. split; lra.
Qed.

(** F is differentiable. *)
Lemma F_rate s u : t0 <= s <= t1 -> 0 < L1 N * L_at M x s -> rate_in_T eps U s (hr s * u) ->
  exists rate, rate_in_T eps F s (2 * (U s * (p x s * L_at M x s)) * (hr s * (p x s * L_at M x s)
    * (u - U s * (beta_of M + beta_of M * (w s + w2 s)))) - rate) /\
  rate <= 2 * deviation_length M P K eps x s * ((h s * r s * Gamma_E N - theta N * r s ^ 2)
    * deviation_length M P K eps x s
    + Rabs (L_at M x s) * rest_length M P K (h s) (r s)).
Proof.
intros Hs HL Du. assert (HLn := L_is_not_0 s HL). assert (Hon := on_t s Hs).
destruct (square_grows M P K (h1 N) (r1 N) eps x s Hon (Gamma_E N) (theta N) (lemma_1 _ _ _ _ _ _ HN) (HX s Hs))
  as (rate & Dq & Hq).
exists rate. split; [|exact Hq].
assert (DL := L_rate M P K (h1 N) (r1 N) eps x s Hon (HX s Hs) HLn).
assert (Dp := p_rate s Hs).
unfold F. eapply rate_same.
- apply (rate_minus eps (fun s => (U s * (p x s * L_at M x s)) ^ 2) sq); [exact Heps| |exact Dq].
  eapply derive_same.
  + apply (rate_mult eps (fun s => U s * (p x s * L_at M x s)) (fun s => U s * (p x s * L_at M x s))); [exact Heps| |];
      (apply (rate_mult eps U (fun s => p x s * L_at M x s)); [exact Heps|exact Du|];
       apply (rate_mult eps (p x) (L_at M x)); [exact Heps|exact Dp|exact DL]).
  + intros v. simpl. ring.
  + reflexivity.
- unfold hr, w, w2, h, r. ring.
Qed.

Lemma F_grows s : t0 <= s <= t1 -> 0 < L1 N * L_at M x s -> F s = 0 ->
  exists rate, rate_in_T eps F s rate /\ 0 < rate.
Proof.
intros Hs HL HF. assert (HLn := L_is_not_0 s HL). assert (Hon := on_t s Hs). assert (U0 := U_within s Hs).
destruct (upper_grows s Hs) as (u & Du & Hu). destruct (F_rate s u Hs HL Du) as (rate & DF & Hrate).
destruct (F_zero_is_ratio s Hs HL HF) as [El Er]. eexists. split. exact DF.
set (lb := (h s * r s * Gamma_E N - theta N * r s ^ 2) * deviation_length M P K eps x s
  + Rabs (L_at M x s) * rest_length M P K (h s) (r s)) in *.
destruct (of_model _ _ _ _ _ _ HN) as (_ & _ & _ & Hb & _).
assert (RB := ratio_bound M P K (h1 N) (r1 N) eps x s Hon HLn (Gamma_E N) (theta N) source lb (U s)
  ltac:(lra) (of_source _ _ _ _ _ _ HN) Er ltac:(lra) (Rle_refl _)).
fold (h s) (r s) in RB. fold (w s) (w2 s) (hr s) share in RB.
destruct (parts_small s (p_within s Hs) (h_low s Hs) HLn ltac:(lra)) as [[_ Wh] _].
assert (Hhr := hr_within s Hs). assert (Hp := p_within s Hs). assert (A0 := Rabs_pos_lt _ HLn).
assert (G1 : (Gamma_E N + beta_of M + beta_of M * w s + beta_of M * share * U s - theta N * r s / h s) * U s
  <= (Gamma N - theta N * r s / h s) * U s).
{ apply Rmult_le_compat_r; [lra|]. assert (OR := of_rate _ _ _ _ _ _ HN). fold share in OR.
  assert (X1 : beta_of M * w s <= beta_of M * w_plus N) by (apply Rmult_le_compat_l; lra).
  assert (X2 : beta_of M * share * U s <= beta_of M * share * z_max N).
  { apply Rmult_le_compat_l; [|lra]. apply Rmult_le_pos; [lra|apply Rlt_le, share_positive]. } lra. }
set (den := p x s * Rabs (L_at M x s) * hr s) in *.
assert (D0 : 0 < den) by (unfold den; apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
assert (B : lb < den * (u - U s * (beta_of M + beta_of M * (w s + w2 s)))).
{ apply Rmult_lt_reg_r with (/ den). apply Rinv_0_lt_compat, D0.
  replace (den * (u - U s * (beta_of M + beta_of M * (w s + w2 s))) * / den)
    with (u - U s * (beta_of M + beta_of M * (w s + w2 s))) by (field; lra). unfold Rdiv in RB. lra. }
rewrite El in Hrate. set (v0 := u - U s * (beta_of M + beta_of M * (w s + w2 s))) in *.
assert (Q : 2 * (U s * (p x s * Rabs (L_at M x s))) * lb < 2 * (U s * (p x s * Rabs (L_at M x s))) * (den * v0)).
{ apply Rmult_lt_compat_l; auto. apply Rmult_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; [lra|].
  apply Rmult_lt_0_compat; lra. }
replace (2 * (U s * (p x s * L_at M x s)) * (hr s * (p x s * L_at M x s) * v0))
  with (2 * (U s * (p x s * Rabs (L_at M x s))) * (den * v0)); [lra|].
unfold den. transitivity (2 * U s * p x s * p x s * hr s * v0 * (Rabs (L_at M x s) * Rabs (L_at M x s))); [ring|].
rewrite <- Rabs_mult, (Rabs_pos_eq (_ * _)) by apply Rle_0_sqr. ring.
Qed.

Lemma L_differentiable s : t0 <= s <= t1 -> ex_derive (L_at M x) s.
Proof.
intros Hs. destruct (of_model _ _ _ _ _ _ HN) as (HM & H1 & _).
destruct (good_coordinates M eps x s HM Heps ltac:(lra) a3_differs) as (D & _).
assert (Q := p_within s Hs); lra. exact (HX s Hs). eexists; exact D.
Qed.

Lemma F_start : 0 < L1 N * L_at M x t0 /\ 0 < F t0.
Proof.
assert (Hs : t0 <= t0 <= t1) by lra.
assert (HLn : L1 N <> 0) by (destruct (of_sign _ _ _ _ _ _ HN) as [(Q & _)|(Q & _)]; lra).
assert (HL : 0 < L1 N * L_at M x t0).
{ rewrite HL0. apply Rsqr_pos_lt in HLn. exact HLn. }
split; [exact HL|]. assert (U0 := U_within t0 Hs). assert (Hp := p_within t0 Hs).
assert (A0 := Rabs_pos_lt _ (L_is_not_0 t0 HL)).
assert (D : 0 < p x t0 * Rabs (L_at M x t0)) by (apply Rmult_lt_0_compat; lra).
assert (B := barrier_low t0 Hp (h_low t0 Hs)).
assert (I0 : I t0 = z0 N).
{ unfold I, layer. rewrite Hp0. unfold Rdiv at 1, Rpower. rewrite Rinv_r by (rewrite <- Hp0; lra).
  rewrite ln_1, Rmult_0_r, Rminus_eq_0, Rmult_0_r. unfold Rdiv. rewrite Rmult_0_l, Ropp_0, exp_0. ring. }
assert (Zp : 0 <= value_of Z (h t0) (r t0)).
{ assert (Hon := on_t t0 Hs). apply value_nonneg. apply Z_nonnegative.
  apply Rlt_le, (h_within _ _ _ _ _ _ _ Hon). apply Rlt_le, (r_within _ _ _ _ _ _ _ Hon). }
assert (HJ := J_within t0 Hs). assert (0 < m * J t0) by (apply Rmult_lt_0_compat; lra).
assert (Q : deviation_length M P K eps x t0 < U t0 * (p x t0 * Rabs (L_at M x t0))).
{ replace (deviation_length M P K eps x t0) with (ratio M P K eps x t0 * (p x t0 * Rabs (L_at M x t0)))
    by (unfold ratio; field; split; lra).
  apply Rmult_lt_compat_r; auto. unfold U. lra. }
unfold F. rewrite sq_is by exact Hs. assert (S0 : 0 <= deviation_length M P K eps x t0) by apply sqrt_pos.
apply Rsqr_incrst_1 in Q; [|exact S0|apply Rmult_le_pos; lra]. unfold Rsqr in Q.
replace (U t0 * (p x t0 * Rabs (L_at M x t0)) * (U t0 * (p x t0 * Rabs (L_at M x t0))))
  with (U t0 * U t0 * p x t0 * p x t0 * (Rabs (L_at M x t0) * Rabs (L_at M x t0))) in Q by ring.
rewrite <- Rabs_mult, (Rabs_pos_eq (_ * _)) in Q by apply Rle_0_sqr. lra.
Qed.

Lemma below_upper s : t0 <= s -> s <= t1 -> 0 < L1 N * L_at M x s /\ 0 < F s.
Proof.
revert s. apply (real_induction (fun s => s <= t1 -> 0 < L1 N * L_at M x s /\ 0 < F s) t0).
- intros _. apply F_start.
- intros t Ht HP. destruct (Rlt_dec t t1) as [Hlt|Hlt].
  2: { exists 1. split. lra. intros s Hs Hs1. replace s with t by lra. apply HP; lra. }
  destruct (HP t ltac:(lra) ltac:(lra)) as [HL HF]. assert (Hs : t0 <= t <= t1) by lra.
  destruct (upper_grows t Hs) as (u & Du & _). destruct (F_rate t u Hs HL Du) as (rate & DF & _).
  assert (C1 : locally t (fun s => 0 < L1 N * L_at M x s)).
  { apply continuous_pos; [|exact HL]. auto_derive. apply L_differentiable, Hs. }
  assert (C2 : locally t (fun s => 0 < F s)) by (apply continuous_pos; [eexists; exact DF|exact HF]).
  destruct (filter_and _ _ C1 C2) as [d Hd]. exists d. split. apply cond_pos.
  intros s Hs' _. apply Hd. change (Rabs (s - t) < d). rewrite Rabs_pos_eq; lra.
- intros t Ht HP Ht1'. assert (Hs : t0 <= t <= t1) by lra.
  assert (HL : 0 < L1 N * L_at M x t).
  { apply L_stays; [lra|]. intros s Hs'. destruct (HP s Hs' ltac:(lra)) as [HLs HFs]. split; [exact HLs|].
    assert (Q := below_is_ratio s ltac:(lra) HLs HFs). assert (Q' := U_within s ltac:(lra)). lra. }
  split; [exact HL|]. destruct (upper_grows t Hs) as (u & Du & _). destruct (F_rate t u Hs HL Du) as (rate & DF & _).
  assert (F0 : 0 <= F t).
  { apply (closed_ge F t0 t); [lra|eexists; exact DF|]. intros s Hs'. apply Rlt_le, HP; lra. }
  destruct (Rle_lt_or_eq_dec _ _ F0) as [|E0]; auto. exfalso.
  destruct (F_grows t Hs HL (eq_sym E0)) as (rate' & DF' & Hpos).
  destruct (derive_pos_before F t (rate' / eps) DF' (eq_sym E0)) as (d & Hd & Neg).
  { apply Rdiv_lt_0_compat; auto. }
  set (s := Rmax t0 (t - d / 2)).
  assert (S1 : t0 <= s) by apply Rmax_l. assert (S2 : t - d / 2 <= s) by apply Rmax_r.
  assert (S3 : s < t) by (unfold s, Rmax; destruct Rle_dec; lra).
  destruct (HP s ltac:(lra) ltac:(lra)) as [_ HF]. specialize (Neg s ltac:(lra)). lra.
Qed.

Lemma ratio_below s : t0 <= s <= t1 -> ratio M P K eps x s < U s.
Proof. intros Hs. destruct (below_upper s ltac:(lra) ltac:(lra)) as [HL HF]. apply below_is_ratio; auto. Qed.

(** Where L < 0, |L| falls. *)
Lemma L_falls t : t0 <= t <= t1 -> L1 N < 0 -> L1 N <= L_at M x t.
Proof.
intros Ht Hneg. rewrite <- HL0. apply Ropp_le_cancel.
apply (decr_of_derive (fun s => - L_at M x s) (fun s => hr s * ((beta_of M - 1) + beta_of M * (w s + w2 s))
  * L_at M x s / eps)
  t0 t ltac:(lra)).
- intros s Hs. destruct (below_upper s ltac:(lra) ltac:(lra)) as [HL _].
  eapply derive_same. apply (is_derive_scal (L_at M x) s (-1)).
  apply (L_rate M P K (h1 N) (r1 N) eps x s (on_t s ltac:(lra)) (HX s ltac:(lra)) (L_is_not_0 s HL)).
  intros u; cbv beta; ring. unfold hr, w, w2, h, r, Rdiv. ring.
- intros s Hs. assert (Hs' : t0 <= s <= t1) by lra. destruct (below_upper s ltac:(lra) ltac:(lra)) as [HL _].
  assert (Q := ratio_below s Hs'). assert (U0 := U_within s Hs').
  destruct (parts_small s (p_within s Hs') (h_low s Hs') (L_is_not_0 s HL) ltac:(lra)) as [[Wl _] W2].
  apply Rabs_le_between in W2. destruct (of_model _ _ _ _ _ _ HN) as (_ & _ & _ & Hb & _).
  destruct (of_sign _ _ _ _ _ _ HN) as [(Hs0 & _)|(_ & Hw & _)]; [lra|]. fold share W_star in Hw.
  assert (B : beta_of M * - (w_minus N + W_star) <= beta_of M * (w s + w2 s)) by (apply Rmult_le_compat_l; lra).
  assert (HLn : L_at M x s < 0) by (apply Ropp_lt_cancel, Rmult_lt_reg_l with (- L1 N); lra).
  assert (Hhr := hr_within s Hs').
  assert (0 <= hr s * ((beta_of M - 1) + beta_of M * (w s + w2 s)) * - L_at M x s / eps).
  { apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat, Heps].
    apply Rmult_le_pos; [apply Rmult_le_pos|]; lra. } lra.
Qed.

End Upper.

Lemma linear_passage t : t0 <= t <= t1 -> 0 < spring_force M eps x t /\ 0 < L1 N * L_at M x t /\
  ratio M P K eps x t <= value_of Z (h t) (r t) + I t.
Proof.
intros Ht. assert (G0 := gap_positive). assert (J0 : 0 < J_end) by apply exp_pos.
assert (Small : forall m, 0 < m -> m <= gap / (2 * J_end) -> m * J_end < gap).
{ intros m Hm Hle. apply (Rmult_le_compat_r J_end) in Hle; [|lra].
  replace (gap / (2 * J_end) * J_end) with (gap / 2) in Hle by (field; lra). lra. }
assert (M0 : 0 < gap / (2 * J_end)) by (apply Rdiv_lt_0_compat; lra).
set (m := gap / (2 * J_end)) in *. assert (S := Small m M0 (Rle_refl _)).
destruct (below_upper m M0 S t ltac:(lra) ltac:(lra)) as [HL _].
assert (R1 := ratio_below m M0 S t Ht). assert (U1 := U_within m M0 S t Ht).
refine (conj _ (conj HL _)).
- apply force_positive; auto. apply p_within, Ht. apply h_low, Ht. apply (L_falls m M0 S t Ht). cbv zeta beta in *. lra.
- apply le_epsilon. intros eta Heta. assert (HJ := J_within t Ht).
  set (m' := Rmin m (eta / J_end)). assert (M1 : 0 < m') by (apply Rmin_pos; [exact M0|apply Rdiv_lt_0_compat; lra]).
  assert (Q := ratio_below m' M1 (Small m' M1 (Rmin_l _ _)) t Ht).
  assert (m' * J t <= eta); [|lra].
  apply Rle_trans with (m' * J_end). apply Rmult_le_compat_l; lra.
  assert (X := Rmin_r m (eta / J_end)). fold m' in X. apply (Rmult_le_compat_r J_end) in X; [|lra].
  replace (eta / J_end * J_end) with eta in X by (field; lra). exact X.
Qed.

End Linear.
End Checked.

(** ** A motion with lift-off *)

Lemma force_is_contact M eps x t : contact_positive M -> 0 < eps -> 0 < spring_force M eps x t -> y x t < z x t.
Proof.
intros (_ & H2 & _) He H. apply Rnot_le_lt. intros Hn. assert (He2 : 0 < / eps ^ 2)
  by (apply Rinv_0_lt_compat, pow_lt, He).
assert (0 <= k2 M * (y x t - z x t) * / eps ^ 2) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
unfold spring_force, Rdiv in H. lra.
Qed.

Lemma contact_is_spring M eps x t : y x t <= z x t -> force_with_lift_off M eps x t = spring_force M eps x t.
Proof.
intros H. unfold force_with_lift_off. destruct Rlt_dec as [|N]; auto. unfold spring_force.
replace (z x t - y x t) with 0 by lra.
unfold Rdiv. ring.
Qed.

Lemma moves_in_contact M eps x t : y x t <= z x t -> moves_by M eps force_with_lift_off x t ->
  moves_by M eps spring_force x t.
Proof. intros H HX. unfold moves_by in *. rewrite contact_is_spring in HX by exact H. exact HX. Qed.

Lemma gap_differentiable M eps x t : contact_positive M -> 0 < eps -> moves_by M eps force_with_lift_off x t ->
  ex_derive (fun s => z x s - y x s) t.
Proof.
intros (_ & _ & Hc) He (_ & _ & Dy & _ & Dz). eexists.
eapply derive_same; [|intros s; reflexivity|reflexivity].
apply (is_derive_minus (z x) (y x)); [|exact Dy].
eapply derive_same. apply (is_derive_scal (fun s => c M * eps * z x s) t (/ (c M * eps))), Dz.
intros s; cbv beta. field. lra. reflexivity.
Qed.

Theorem passage : StatementPassage.passage.
Proof.
intros M P K N source Z eps x t0 t1 HN (He & He0 & Ht1 & Hp0 & HL0 & Hz0 & HX & Hp1 & Hh1).
destruct (of_model _ _ _ _ _ _ HN) as (HM & H1 & _). destruct (of_start _ _ _ _ _ _ HN) as (P1 & Z0 & _ & Hr1 & _).
assert (E0 : 0 < - alpha1 M * eps) by (apply Rmult_lt_0_compat; lra).
assert (Fall : forall s t, t0 <= s -> s <= t -> t <= t1 -> p x t <= p x s).
{ intros s t Hs Hst Ht. apply (decr_of_derive (p x) (fun _ => alpha1 M) s t Hst).
  intros u Hu. exact (proj1 (HX u ltac:(lra))). intros u Hu. lra. }
assert (Hp : forall t, t0 <= t <= t1 -> 0 < p x t <= p1 N).
{ intros t Ht. rewrite <- Hp0. assert (A := Fall t0 t). assert (B' := Fall t t1). lra. }
assert (Hh : forall t, t0 <= t <= t1 -> h_at M eps x t <= h1 N).
{ intros t Ht. apply Rle_trans with (2 := Hh1). unfold h_at.
  assert (B' := Fall t t1 ltac:(lra) ltac:(lra) ltac:(lra)). assert (S1 := sqrt_lt_R0 _ Hp1).
  apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar. apply Rmult_lt_0_compat; auto.
  apply Rmult_le_compat; try lra. apply sqrt_le_1_alt, B'. }
assert (Linear : forall t, t0 <= t <= t1 -> (forall s, t0 <= s <= t -> y x s <= z x s) ->
  0 < spring_force M eps x t /\ 0 < L1 N * L_at M x t /\ ratio M P K eps x t <= value_of Z (h_at M eps x t) (r_at x t)
    + layer (Gamma N) (theta N) (z0 N) (p1 N) (- alpha1 M * eps) (p x t)).
{ intros t Ht Hc. apply (linear_passage M P K N source Z HN eps x t0 He He0 Hp0 HL0 Hz0 t); try lra.
  - intros s Hs. apply moves_in_contact. apply Hc, Hs. apply HX; lra.
  - apply Hp, Ht.
  - apply Hh, Ht. }
assert (Contact : forall t, t0 <= t -> t <= t1 -> y x t < z x t).
{ apply (real_induction (fun t => t <= t1 -> y x t < z x t) t0).
  - intros _. apply (force_is_contact M eps x t0 HM He). apply (force_positive M P K N source Z HN eps x He t0).
    + apply Hp; lra.
    + apply Hh; lra.
    + rewrite HL0. apply Rsqr_pos_lt. destruct (of_sign _ _ _ _ _ _ HN) as [(Q & _)|(Q & _)]; lra.
    + lra.
    + assert (B' := below _ _ _ _ _ _ HN). destruct (of_rectangle _ _ _ _ _ _ HN) as (Hh1' & _).
      assert (R1 := sqrt_pos (p1 N)).
      assert (V0 := value_nonneg Z (h1 N) (r1 N) (Z_nonnegative M P K N source Z HN) ltac:(lra) ltac:(lra)).
      assert (X := Rmax_l (z0 N) (layer (Gamma N) (theta N) (z0 N) (p1 N) (e0 N) (p_at_h (e0 N) (h1 N)))). lra.
  - intros t Ht HP. destruct (Rlt_dec t t1) as [Hlt|Hlt].
    2: { exists 1. split. lra. intros s Hs Hs1. replace s with t by lra. apply HP; lra. }
    assert (C0 : locally t (fun s => 0 < z x s - y x s)).
    { apply continuous_pos. apply (gap_differentiable M eps); auto. apply HX; lra.
      assert (Q := HP t ltac:(lra) ltac:(lra)). lra. }
    destruct C0 as [d Hd]. exists d. split. apply cond_pos. intros s Hs _.
    assert (Q : 0 < z x s - y x s) by (apply Hd; change (Rabs (s - t) < d); rewrite Rabs_pos_eq; lra). lra.
  - intros t Ht HP Hle. apply (force_is_contact M eps x t HM He). apply (Linear t ltac:(lra)).
    intros s Hs. destruct (Rlt_dec s t) as [Hlt|Hlt]. apply Rlt_le, HP; lra. replace s with t by lra.
    assert (Q : 0 <= z x t - y x t); [|lra].
    apply (closed_ge (fun s => z x s - y x s) t0 t); [lra| |].
    apply (gap_differentiable M eps); auto. apply HX; lra.
    intros u Hu. assert (Q := HP u Hu ltac:(lra)). lra. }
intros t Ht. split. apply Contact; lra. apply Linear; [exact Ht|]. intros s Hs. apply Rlt_le, Contact; lra.
Qed.
