(** * The norm of the fast deviation, and the inequality for z = |x|/(p|L|)

    proofs/from_state.md, (5) to (8) and Lemma 1. The shares are squares completed ([form_first]); the bilinear form
    obeys the inequality of Cauchy and Schwarz ([schwarz]). |x|^2 has the derivative x^T (M B + B^T M + M') x + 2 L
    x^T M R ([square_rate]): Lemma 1 follows where |x| > 0, and (6) by the quotient rule. *)

From Coq Require Import Reals Psatz Lra List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus LogarithmicNorm StatementStep StatementPassage PassageEquations.
Open Scope R_scope.

(** ** The form *)

Section Form.
Variables (k m n G d : R).
Hypothesis Hk : 0 < k.
Hypothesis HG : 0 < G.
Hypothesis Hd : 0 < d.
Hypothesis Hroom : d <= 1 - m ^ 2 / k - n ^ 2 / G.

Definition form (x y : vector) : R :=
  k * first x * first y + m * (first x * second y + second x * first y) + second x * second y
    + n * (second x * third y + third x * second y) + G * third x * third y.

Lemma quotients : 0 <= m ^ 2 / k /\ 0 <= n ^ 2 / G.
Proof. split; apply Rmult_le_pos; try apply pow2_ge_0; apply Rlt_le, Rinv_0_lt_compat; auto. Qed.

Lemma form_second x : d * second x ^ 2 <= form x x.
Proof.
assert (S1 := pow2_ge_0 (first x + m * second x / k)). assert (S3 := pow2_ge_0 (third x + n * second x / G)).
assert (Q1 := Rmult_le_pos _ _ (Rlt_le _ _ Hk) S1). assert (Q3 := Rmult_le_pos _ _ (Rlt_le _ _ HG) S3).
assert (Q2 := Rmult_le_pos _ _ (proj1 (Rminus_le_0 _ _) Hroom) (pow2_ge_0 (second x))).
assert (E : form x x = k * (first x + m * second x / k) ^ 2 + G * (third x + n * second x / G) ^ 2
  + (1 - m ^ 2 / k - n ^ 2 / G - d) * second x ^ 2 + d * second x ^ 2) by (unfold form; field; lra).
lra.
Qed.

Lemma form_nonneg x : 0 <= form x x.
Proof.
apply Rle_trans with (2 := form_second x). apply Rmult_le_pos. lra. apply pow2_ge_0.
Qed.

Lemma form_first x : k * d * first x ^ 2 <= form x x.
Proof.
destruct quotients as [Q1 Q2]. set (s := 1 - n ^ 2 / G).
assert (E : s * form x x = s * (G * (third x + n * second x / G) ^ 2) + (s * second x + m * first x) ^ 2
  + k * (s - m ^ 2 / k - d) * first x ^ 2 + k * d * first x ^ 2) by (unfold form, s; field; lra).
assert (S0 : 0 < s) by (unfold s; lra).
assert (P1 := Rmult_le_pos _ _ (Rlt_le _ _ S0) (Rmult_le_pos _ _ (Rlt_le _ _ HG)
  (pow2_ge_0 (third x + n * second x / G)))).
assert (P2 := pow2_ge_0 (s * second x + m * first x)).
assert (P3 : 0 <= k * (s - m ^ 2 / k - d) * first x ^ 2).
{ apply Rmult_le_pos. apply Rmult_le_pos. lra. unfold s; lra. apply pow2_ge_0. }
assert (P4 : s * form x x <= 1 * form x x) by (apply Rmult_le_compat_r; [apply form_nonneg|unfold s; lra]). lra.
Qed.

Lemma form_third x : G * d * third x ^ 2 <= form x x.
Proof.
destruct quotients as [Q1 Q2]. set (s := 1 - m ^ 2 / k).
assert (E : s * form x x = s * (k * (first x + m * second x / k) ^ 2) + (s * second x + n * third x) ^ 2
  + G * (s - n ^ 2 / G - d) * third x ^ 2 + G * d * third x ^ 2) by (unfold form, s; field; lra).
assert (S0 : 0 < s) by (unfold s; lra).
assert (P1 := Rmult_le_pos _ _ (Rlt_le _ _ S0) (Rmult_le_pos _ _ (Rlt_le _ _ Hk)
  (pow2_ge_0 (first x + m * second x / k)))).
assert (P2 := pow2_ge_0 (s * second x + n * third x)).
assert (P3 : 0 <= G * (s - n ^ 2 / G - d) * third x ^ 2).
{ apply Rmult_le_pos. apply Rmult_le_pos. lra. unfold s; lra. apply pow2_ge_0. }
assert (P4 : s * form x x <= 1 * form x x) by (apply Rmult_le_compat_r; [apply form_nonneg|unfold s; lra]). lra.
Qed.

Lemma schwarz x y : Rabs (form x y) <= sqrt (form x x) * sqrt (form y y).
Proof.
rewrite <- sqrt_mult by apply form_nonneg. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr.
assert (Q : forall s, 0 <= form x x + 2 * s * form x y + s ^ 2 * form y y).
{ intros s. replace (form x x + 2 * s * form x y + s ^ 2 * form y y) with (form
    (Vector (first x + s * first y) (second x + s * second y) (third x + s * third y))
    (Vector (first x + s * first y) (second x + s * second y) (third x + s * third y))) by (unfold form; simpl; ring).
  apply form_nonneg. }
destruct (Rle_lt_or_eq_dec _ _ (form_nonneg y)) as [Hy|Hy].
- specialize (Q (- form x y / form y y)). apply Rmult_le_reg_r with (/ form y y). apply Rinv_0_lt_compat, Hy.
  replace (form x x * form y y * / form y y) with (form x x) by (field; lra).
  replace (form x x + 2 * (- form x y / form y y) * form x y + (- form x y / form y y) ^ 2 * form y y)
    with (form x x - form x y * form x y * / form y y) in Q by (field; lra). lra.
- rewrite <- Hy, Rmult_0_r. rewrite <- Hy in Q.
  assert (Z : form x y = 0); [|rewrite Z; lra].
  specialize (Q (- (form x x + 1) / (2 * form x y))) as Q'.
  destruct (Req_dec (form x y) 0) as [|Hn]; auto. exfalso.
  replace (2 * (- (form x x + 1) / (2 * form x y)) * form x y) with (- (form x x + 1)) in Q' by (field; auto). lra.
Qed.

(** The square root of the form, above by the diagonal. *)
Lemma form_above x : sqrt (form x x) <= sqrt k * Rabs (first x) + Rabs (second x) + sqrt G * Rabs (third x).
Proof.
destruct quotients as [Q1 Q2].
assert (A1 := Rabs_pos (first x)). assert (A2 := Rabs_pos (second x)). assert (A3 := Rabs_pos (third x)).
assert (R1 := sqrt_pos k). assert (R3 := sqrt_pos G).
assert (P1 := Rmult_le_pos _ _ R1 A1). assert (P3 := Rmult_le_pos _ _ R3 A3).
assert (Hm : Rabs m <= sqrt k).
{ rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr. apply Rmult_le_reg_r with (/ k).
  apply Rinv_0_lt_compat, Hk. rewrite Rinv_r by lra. replace (m * m * / k) with (m ^ 2 / k) by (field; lra). lra. }
assert (Hn : Rabs n <= sqrt G).
{ rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr. apply Rmult_le_reg_r with (/ G).
  apply Rinv_0_lt_compat, HG. rewrite Rinv_r by lra. replace (n * n * / G) with (n ^ 2 / G) by (field; lra). lra. }
assert (X12 : m * (first x * second x) <= sqrt k * Rabs (first x) * Rabs (second x)).
{ apply Rle_trans with (1 := Rle_abs _). rewrite !Rabs_mult, Rmult_assoc. apply Rmult_le_compat_r; auto.
  apply Rmult_le_pos; auto. }
assert (X23 : n * (second x * third x) <= sqrt G * Rabs (third x) * Rabs (second x)).
{ apply Rle_trans with (1 := Rle_abs _). rewrite !Rabs_mult, (Rmult_comm (Rabs (second x))), Rmult_assoc.
  apply Rmult_le_compat_r; auto. apply Rmult_le_pos; auto. }
apply Rsqr_incr_0; [|apply sqrt_pos|lra]. rewrite Rsqr_sqrt by apply form_nonneg.
assert (Sk : sqrt k * sqrt k = k) by (apply sqrt_sqrt; lra).
assert (SG : sqrt G * sqrt G = G) by (apply sqrt_sqrt; lra).
assert (B1 : Rabs (first x) * Rabs (first x) = first x * first x) by (rewrite <- Rabs_mult, Rabs_pos_eq; nra).
assert (B2 : Rabs (second x) * Rabs (second x) = second x * second x) by (rewrite <- Rabs_mult, Rabs_pos_eq; nra).
assert (B3 : Rabs (third x) * Rabs (third x) = third x * third x) by (rewrite <- Rabs_mult, Rabs_pos_eq; nra).
assert (X13 := Rmult_le_pos _ _ P1 P3).
unfold Rsqr, form.
replace (k * first x * first x) with (sqrt k * sqrt k * (Rabs (first x) * Rabs (first x))) by (rewrite Sk, B1; ring).
replace (G * third x * third x) with (sqrt G * sqrt G * (Rabs (third x) * Rabs (third x))) by (rewrite SG, B3; ring).
rewrite <- B2. nra.
Qed.

End Form.

(** ** The norm on the rectangle *)

Section Norm.
Variables (M : model_system) (K : weights) (h r h1 r1 : R).
Hypothesis HK : weights_good M K.
Hypothesis Hh : 0 <= h <= h1.
Hypothesis Hr : 0 <= r <= r1.
Hypothesis Hd : 0 < d_of M K h1 r1.
Let G := g_of M ^ 2 / l_of M.

Lemma k_positive : 0 < kappa_of M.
Proof. apply kappa_positive, HK. Qed.

Lemma G_positive : 0 < G.
Proof. apply Rdiv_lt_0_compat. apply pow_lt, g_positive, HK. apply l_positive, HK. Qed.

Lemma product_is_form x y : product_M M K h r x y = form (kappa_of M) (m_entry M K h r) (n_entry K r) G x y.
Proof. reflexivity. Qed.

Lemma room : d_of M K h1 r1 <= 1 - m_entry M K h r ^ 2 / kappa_of M - n_entry K r ^ 2 / G.
Proof.
destruct HK as (HM & Hb & Hm & Hn). assert (Kp := kappa_positive M HM). assert (Gp := g_positive M HM).
assert (Lp := l_positive M HM). unfold d_of.
set (lo := (beta_of M - 1 / 2) / 2 * h1). set (hi := at_m K * (l_of M / g_of M) * r1).
assert (Lg : 0 <= at_m K * (l_of M / g_of M)) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rdiv_lt_0_compat; lra]).
assert (E1 : 0 <= at_m K * (l_of M / g_of M) * r <= hi).
{ split. apply Rmult_le_pos; lra. apply Rmult_le_compat_l; lra. }
assert (E2 : 0 <= (beta_of M - 1 / 2) / 2 * h <= lo).
{ split. apply Rmult_le_pos; lra. apply Rmult_le_compat_l; lra. }
assert (Qm : m_entry M K h r ^ 2 <= Rmax hi lo ^ 2).
{ assert (X1 := Rmax_l hi lo). assert (X2 := Rmax_r hi lo). unfold m_entry.
  assert (0 <= (Rmax hi lo - (at_m K * (l_of M / g_of M) * r - (beta_of M - 1 / 2) / 2 * h))
    * (Rmax hi lo + (at_m K * (l_of M / g_of M) * r - (beta_of M - 1 / 2) / 2 * h))) by (apply Rmult_le_pos; lra).
      lra. }
assert (Qn : n_entry K r ^ 2 <= (at_n K * r1) ^ 2).
{ unfold n_entry. replace ((- at_n K * r) ^ 2) with ((at_n K * r) ^ 2) by ring. apply pow_incr. split.
  apply Rmult_le_pos; lra. apply Rmult_le_compat_l; lra. }
assert (A1 : m_entry M K h r ^ 2 / kappa_of M <= Rmax hi lo ^ 2 / kappa_of M).
{ apply Rmult_le_compat_r; auto. apply Rlt_le, Rinv_0_lt_compat, Kp. }
assert (A2 : n_entry K r ^ 2 / G <= (at_n K * r1) ^ 2 * l_of M / g_of M ^ 2).
{ replace ((at_n K * r1) ^ 2 * l_of M / g_of M ^ 2) with ((at_n K * r1) ^ 2 / G) by (unfold G; field; lra).
  apply Rmult_le_compat_r; auto. apply Rlt_le, Rinv_0_lt_compat, G_positive. }
lra.
Qed.

Lemma product_nonneg x : 0 <= product_M M K h r x x.
Proof. apply (form_nonneg _ _ _ _ _ k_positive G_positive Hd room). Qed.

Lemma norm_square x : norm M K h r x * norm M K h r x = product_M M K h r x x.
Proof. apply sqrt_sqrt, product_nonneg. Qed.

Lemma product_schwarz x u : Rabs (product_M M K h r x u) <= norm M K h r x * norm M K h r u.
Proof. apply (schwarz _ _ _ _ _ k_positive G_positive Hd room). Qed.

Lemma norm_above x : norm M K h r x
  <= sqrt (kappa_of M) * Rabs (first x) + Rabs (second x) + g_of M / sqrt (l_of M) * Rabs (third x).
Proof.
replace (g_of M / sqrt (l_of M)) with (sqrt G).
apply (form_above _ _ _ _ _ k_positive G_positive Hd room).
assert (Lp := l_positive M (proj1 HK)). assert (Gp := g_positive M (proj1 HK)).
unfold G. rewrite sqrt_div_alt by exact Lp. rewrite sqrt_pow2 by lra. reflexivity.
Qed.

(** An entry whose square has a share in the form. *)
Lemma share_of a q x : 0 < a -> a * q ^ 2 <= product_M M K h r x x -> Rabs q <= norm M K h r x / sqrt a.
Proof.
intros Ha H. assert (Sa := sqrt_lt_R0 a Ha). apply Rmult_le_reg_r with (sqrt a); auto.
replace (norm M K h r x / sqrt a * sqrt a) with (norm M K h r x) by (field; lra).
rewrite <- sqrt_Rsqr_abs, <- sqrt_mult by (try apply Rle_0_sqr; lra). apply sqrt_le_1_alt. unfold Rsqr. lra.
Qed.

Lemma second_share x : Rabs (second x) <= norm M K h r x / sqrt (d_of M K h1 r1).
Proof. apply share_of; auto. apply (form_second _ _ _ _ _ k_positive G_positive room). Qed.

End Norm.

Theorem shares : StatementPassage.shares.
Proof.
intros M K h r h1 r1 x HK Hh Hr Hd. assert (Kp := k_positive M K HK). assert (Gp := G_positive M K HK).
assert (Rm := room M K h r h1 r1 HK Hh Hr).
refine (conj (product_nonneg M K h r h1 r1 HK Hh Hr Hd x) (conj _ (conj (second_share M K h r h1 r1 HK Hh Hr Hd x) _))).
- apply share_of. apply Rmult_lt_0_compat; auto. apply (form_first _ _ _ _ _ Kp Gp Hd Rm).
- assert (Lp := l_positive M (proj1 HK)). assert (gp := g_positive M (proj1 HK)).
  assert (T := form_third _ _ _ _ _ Kp Gp Hd Rm x).
  eapply Rle_trans. apply (share_of M K h r _ (third x) x (Rmult_lt_0_compat _ _ Gp Hd)), T.
  right. rewrite sqrt_mult, sqrt_div_alt, sqrt_pow2, (sqrt_div_alt (l_of M)) by lra.
  assert (S1 := sqrt_lt_R0 _ Lp). assert (S2 := sqrt_lt_R0 _ Hd).
  field. repeat split; lra.
Qed.

(** ** Lemma 1 *)

(** A motion on the rectangle at t. *)
Section Growth.
Variables (M : model_system) (P : slow_part) (K : weights) (h1 r1 eps : R) (x : motion) (t : R).
Hypothesis Hon : on_rectangle M K eps x h1 r1 t.
Let h := h_at M eps x.
Let r := r_at x.
Let X := deviation_at M P eps x.
Let R0 := rest_at M P (h t) (r t).

Lemma h_within : 0 < h t <= h1.
Proof.
destruct Hon as (_ & _ & H1 & _ & He & Hp & Hh & _). split; [|exact Hh].
unfold h. rewrite (h_value M eps x t Hp). assert (Q := r_positive x t Hp).
apply Rdiv_lt_0_compat. apply Rmult_lt_0_compat; lra. apply pow_lt, Q.
Qed.

Lemma r_within : 0 < r t <= r1.
Proof. destruct Hon as (_ & _ & _ & _ & _ & Hp & _ & Hr). split; [|exact Hr]. apply r_positive, Hp. Qed.

Lemma square_rate : moves_by M eps spring_force x t ->
  rate_in_T eps (fun s => product_M M K (h s) (r s) (X s) (X s)) t
    (growth_form M P K (h t) (r t) (X t) + 2 * L_at M x t * product_M M K (h t) (r t) (X t) R0).
Proof.
intros HX. destruct Hon as (HK & _ & H1 & H13 & He & Hp & _). assert (HM := proj1 HK).
destruct (deviation_moves M P eps x t HM He ltac:(lra) H13 Hp HX) as (D1 & D2 & D3).
assert (Dp := proj1 HX). assert (Dr := r_rate M eps x t He Hp Dp). assert (Dh := h_rate M eps x t He Hp Dp).
fold h r X in D1, D2, D3. fold h r in Dr, Dh. fold (h t) (r t) in *. fold R0 in D1, D2, D3.
assert (Dm : rate_in_T eps (fun s => m_entry M K (h s) (r s)) t
  (at_m K * (l_of M / g_of M) * (- (h t * r t ^ 2) / 2) - (beta_of M - 1 / 2) / 2 * (3 / 2 * h t ^ 2 * r t))).
{ apply rate_minus; [exact He| |]; apply rate_scal; assumption. }
assert (Dn : rate_in_T eps (fun s => n_entry K (r s)) t (- at_n K * (- (h t * r t ^ 2) / 2))).
{ apply rate_scal; assumption. }
assert (P2 : forall f f0 f' f0', rate_in_T eps f t f' -> rate_in_T eps f0 t f0' ->
  rate_in_T eps (fun s => f s * f0 s) t (f' * f0 t + f t * f0')) by (intros; apply rate_mult; assumption).
unfold product_M. eapply rate_same.
- apply rate_plus; [exact He| |]; [apply rate_plus; [exact He| |]; [apply rate_plus; [exact He| |];
    [apply rate_plus; [exact He| |]|]|]|].
  + apply (P2 (fun s => kappa_of M * first (X s))); [|exact D1]. apply rate_scal; [exact He|exact D1].
  + apply P2; [exact Dm|]. apply rate_plus; [exact He| |]; apply P2; eassumption.
  + apply P2; exact D2.
  + apply P2; [exact Dn|]. apply rate_plus; [exact He| |]; apply P2; eassumption.
  + apply (P2 (fun s => g_of M ^ 2 / l_of M * third (X s))); [|exact D3]. apply rate_scal; [exact He|exact D3].
- unfold growth_form, product_M. ring.
Qed.

(** |x|^2 grows no faster than Lemma 1 says of |x|. *)
Lemma square_grows Gamma_E theta : growth_checked M P K Gamma_E theta h1 r1 -> moves_by M eps spring_force x t ->
  exists rate, rate_in_T eps (fun s => product_M M K (h s) (r s) (X s) (X s)) t rate /\
  rate <= 2 * deviation_length M P K eps x t * ((h t * r t * Gamma_E - theta * r t ^ 2) * deviation_length M P K eps x t
    + Rabs (L_at M x t) * rest_length M P K (h t) (r t)).
Proof.
intros HG HX. eexists. split. apply square_rate, HX.
assert (Hh := h_within). assert (Hr := r_within). destruct Hon as (HK & Hd & _).
assert (G1 := HG (h t) (r t) (X t) Hh Hr).
assert (N := norm_square M K (h t) (r t) h1 r1 HK ltac:(lra) ltac:(lra) Hd (X t)).
assert (S := product_schwarz M K (h t) (r t) h1 r1 HK ltac:(lra) ltac:(lra) Hd (X t) R0).
unfold deviation_length, rest_length. fold h r X. fold (h t) (r t). fold R0. rewrite <- N in G1.
assert (Q : L_at M x t * product_M M K (h t) (r t) (X t) R0
  <= Rabs (L_at M x t) * (norm M K (h t) (r t) (X t) * norm M K (h t) (r t) R0)).
{ apply Rle_trans with (1 := Rle_abs _). rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|exact S]. }
fold (h_at M eps x t) (r_at x t) in *. unfold h, r, X, R0 in *. lra.
Qed.

End Growth.

Theorem deviation_grows : StatementPassage.deviation_grows.
Proof.
intros M P K Gamma_E theta h1 r1 eps x t HG Hon HX Hpos h r.
destruct (square_grows M P K h1 r1 eps x t Hon Gamma_E theta HG HX) as (rate & Dq & Hq).
assert (He : 0 < eps) by apply Hon.
set (q := fun s => product_M M K (h_at M eps x s) (r_at x s) (deviation_at M P eps x s) (deviation_at M P eps x s)) in
  *.
assert (Lq : forall s, deviation_length M P K eps x s = sqrt (q s)) by reflexivity. rewrite Lq in *.
assert (Q0 : 0 < q t).
{ apply Rnot_le_lt. intros Hn. rewrite sqrt_neg_0 in Hpos by exact Hn. lra. }
exists (rate / (2 * sqrt (q t))). split.
- eapply derive_same. apply (is_derive_sqrt q t (rate / eps)); [exact Dq|exact Q0]. symmetry. apply Lq.
  field. split; lra.
- apply Rmult_le_reg_l with (2 * sqrt (q t)). lra.
  replace (2 * sqrt (q t) * (rate / (2 * sqrt (q t)))) with rate by (field; lra). exact Hq.
Qed.

(** ** The inequality (6) and the drift (7) *)

Lemma sign_quotient (u : R) : u <> 0 -> sign u = Rabs u / u.
Proof.
intros Hu. destruct (Rdichotomy _ _ Hu) as [H|H].
- rewrite sign_eq_m1, Rabs_left by exact H. field. exact Hu.
- rewrite sign_eq_1, Rabs_pos_eq by lra. field. exact Hu.
Qed.

Section Ratio.
Variables (M : model_system) (P : slow_part) (K : weights) (h1 r1 eps : R) (x : motion) (t : R).
Hypothesis Hon : on_rectangle M K eps x h1 r1 t.
Hypothesis HX : moves_by M eps spring_force x t.
Hypothesis HL : L_at M x t <> 0.
Let h := h_at M eps x t.
Let r := r_at x t.
(** W/(pL) less w. *)
Let w2 := second (deviation_at M P eps x t) / (p x t * L_at M x t).

Lemma L_rate : rate_in_T eps (L_at M x) t (- (h * r) * ((beta_of M - 1) + beta_of M * (value_of (slow_w P) h r + w2))
  * L_at M x t).
Proof.
destruct Hon as (HK & _ & H1 & H13 & He & Hp & _).
destruct (good_coordinates M eps x t (proj1 HK) He ltac:(lra) H13 ltac:(lra) HX) as (DL & _).
rewrite <- (hr_value M eps x t Hp) in DL. fold h r in DL.
eapply rate_same. exact DL. unfold w2, deviation_at; simpl. rewrite (p_is_square x t Hp). fold h r.
assert (R0 := r_positive x t Hp). fold r in R0. field. split; lra.
Qed.

Lemma w2_small : Rabs w2 <= c_W M K h1 r1 * ratio M P K eps x t.
Proof.
assert (Hh := h_within M K h1 r1 eps x t Hon). assert (Hr := r_within M K h1 r1 eps x t Hon).
destruct Hon as (HK & Hd & H1 & H13 & He & Hp & _).
assert (S := second_share M K h r h1 r1 HK ltac:(unfold h; lra) ltac:(unfold r; lra) Hd (deviation_at M P eps x t)).
unfold w2, ratio, c_W, Rdiv. rewrite Rabs_mult, Rabs_inv, Rabs_mult, (Rabs_pos_eq (p x t)) by lra.
rewrite <- Rmult_assoc. apply Rmult_le_compat_r.
- apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; auto. apply Rabs_pos_lt, HL.
- rewrite Rmult_comm. exact S.
Qed.

Lemma ratio_rate len : rate_in_T eps (deviation_length M P K eps x) t len ->
  rate_in_p M eps x (ratio M P K eps x) t (len / (p x t * Rabs (L_at M x t) * (h * r))
    + ratio M P K eps x t * (beta_of M + beta_of M * (value_of (slow_w P) h r + w2))).
Proof.
intros Dlen. destruct Hon as (_ & _ & H1 & _ & He & Hp & _). assert (Dp := proj1 HX).
assert (E := hr_value M eps x t Hp). fold h r in E.
assert (Hhr : 0 < h * r) by (rewrite E; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|exact Hp]).
assert (DL := L_rate). apply is_derive_Rabs in DL; [|exact HL].
assert (A0 := Rabs_pos_lt _ HL).
unfold rate_in_p, rate_in_T. fold h r. eapply is_derive_val.
- apply (is_derive_div (deviation_length M P K eps x) (fun s => p x s * Rabs (L_at M x s))); [exact Dlen| |].
  + apply (is_derive_mult_R (p x) (fun s => Rabs (L_at M x s))); [exact Dp|exact DL].
  + apply Rgt_not_eq, Rmult_lt_0_compat; assumption.
- rewrite sign_quotient by exact HL. unfold ratio.
  replace (alpha1 M) with (- (h * r) * p x t / eps) by (rewrite E; field; lra).
  field. repeat split; try lra. intros Q; rewrite Q in Hhr; lra. intros Q; rewrite Q in Hhr; lra.
Qed.

Lemma rest_above source : source_of M P source h1 r1 ->
  rest_length M P K h r / (p x t * (h * r)) <= value_of source h r.
Proof.
intros HS. assert (Hh := h_within M K h1 r1 eps x t Hon). assert (Hr := r_within M K h1 r1 eps x t Hon).
destruct Hon as (HK & Hd & _ & _ & _ & Hp & _). fold h in Hh. fold r in Hr.
assert (Hhr : 0 < h * r ^ 3) by (apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]).
apply Rle_trans with (2 := HS h r Hh Hr). rewrite (p_is_square x t Hp). fold r.
replace (r ^ 2 * (h * r)) with (h * r ^ 3) by ring.
apply Rmult_le_reg_r with (h * r ^ 3); [exact Hhr|].
unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
eapply Rle_trans. apply (norm_above M K h r h1 r1 HK ltac:(lra) ltac:(lra) Hd). simpl.
rewrite !Rabs_mult, (Rabs_pos_eq r) by lra. right.
assert (sqrt (l_of M) <> 0) by (apply Rgt_not_eq, sqrt_lt_R0, l_positive, HK).
field. repeat split; lra.
Qed.

(** The right side of (6), times |x| > 0. *)
Lemma ratio_bound Gamma_E theta source len z : 0 <= beta_of M -> source_of M P source h1 r1 ->
  z = ratio M P K eps x t -> 0 <= z ->
  len <= (h * r * Gamma_E - theta * r ^ 2) * deviation_length M P K eps x t + Rabs (L_at M x t) * rest_length M P K h r
    ->
  len / (p x t * Rabs (L_at M x t) * (h * r)) + z * (beta_of M + beta_of M * (value_of (slow_w P) h r + w2))
    <= (Gamma_E + beta_of M + beta_of M * value_of (slow_w P) h r + beta_of M * c_W M K h1 r1 * z - theta * r / h) * z
      + value_of source h r.
Proof.
intros Hb HS Ez Hz Hlen. assert (Hh := h_within M K h1 r1 eps x t Hon). assert (Hr := r_within M K h1 r1 eps x t Hon).
assert (RA := rest_above source HS). assert (W2 := w2_small). assert (A0 := Rabs_pos_lt _ HL). rewrite <- Ez in W2.
destruct Hon as (_ & _ & _ & _ & _ & Hp & _). fold h in Hh. fold r in Hr.
assert (Hhr : 0 < h * r) by (apply Rmult_lt_0_compat; lra).
assert (Hden : 0 < p x t * Rabs (L_at M x t) * (h * r)) by (apply Rmult_lt_0_compat;
  [apply Rmult_lt_0_compat|]; assumption).
assert (Q1 : len / (p x t * Rabs (L_at M x t) * (h * r)) <= (Gamma_E - theta * r / h) * z + value_of source h r).
{ apply Rle_trans with ((Gamma_E - theta * r / h) * z + rest_length M P K h r / (p x t * (h * r))); [|lra].
  apply Rmult_le_reg_r with (p x t * Rabs (L_at M x t) * (h * r)); auto.
  replace (len / (p x t * Rabs (L_at M x t) * (h * r)) * (p x t * Rabs (L_at M x t) * (h * r))) with len
    by (field; repeat split; lra).
  apply Rle_trans with (1 := Hlen). right. rewrite Ez. unfold ratio. field. repeat split; lra. }
assert (Q2 : z * (beta_of M * w2) <= z * (beta_of M * (c_W M K h1 r1 * z))).
{ apply Rmult_le_compat_l; auto. apply Rmult_le_compat_l; auto. apply Rle_trans with (2 := W2). apply Rle_abs. }
lra.
Qed.

Lemma log_C_rate : rate_in_p M eps x (fun s => ln (Rabs (C_at M x s))) t
  (- beta_of M * (value_of (slow_w P) h r + w2)).
Proof.
destruct Hon as (_ & _ & H1 & _ & He & Hp & _). assert (Dp := proj1 HX).
assert (E := hr_value M eps x t Hp). fold h r in E.
assert (A0 := Rabs_pos_lt _ HL).
assert (DL := L_rate). apply is_derive_Rabs in DL; [|exact HL].
assert (Dln : is_derive (fun s => ln (Rabs (L_at M x s)) + (1 - beta_of M) * ln (p x s)) t
  (h * r * (- beta_of M * (value_of (slow_w P) h r + w2)) / eps)).
{ eapply is_derive_val.
  - apply (is_derive_plus (fun s => ln (Rabs (L_at M x s)))).
    + apply (is_derive_comp ln (fun s => Rabs (L_at M x s))); [apply is_derive_ln, A0|exact DL].
    + apply (is_derive_scal (fun s => ln (p x s))).
      apply (is_derive_comp ln (p x)); [apply is_derive_ln, Hp|exact Dp].
  - unfold plus, scal; simpl. unfold mult; simpl. rewrite sign_quotient by exact HL.
    replace (alpha1 M) with (- (h * r) * p x t / eps) by (rewrite E; field; lra).
    field. repeat split; lra. }
unfold rate_in_p, rate_in_T. fold h r.
apply (is_derive_ext_loc (fun s => ln (Rabs (L_at M x s)) + (1 - beta_of M) * ln (p x s))); [|exact Dln].
assert (N1 : locally t (fun s => 0 < p x s)) by (apply continuous_pos; [eexists; exact Dp|exact Hp]).
assert (N2 : locally t (fun s => 0 < Rabs (L_at M x s))) by (apply continuous_pos; [eexists; exact DL|exact A0]).
generalize (filter_and _ _ N1 N2). apply filter_imp. intros s [P1 P2].
unfold C_at, Rpower. rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (exp _)) by (apply Rlt_le, exp_pos).
rewrite ln_mult, ln_exp; auto. apply exp_pos.
Qed.

End Ratio.

Theorem ratio_grows : StatementPassage.ratio_grows.
Proof.
intros M P K Gamma_E theta source h1 r1 eps x t HG HS Hon HX HL Hz h r z.
assert (HK : weights_good M K) by apply Hon. assert (Hp : 0 < p x t) by apply Hon.
assert (Hden : 0 < p x t * Rabs (L_at M x t)) by (apply Rmult_lt_0_compat; [exact Hp|apply Rabs_pos_lt, HL]).
assert (Hlen : 0 < deviation_length M P K eps x t).
{ replace (deviation_length M P K eps x t) with (ratio M P K eps x t * (p x t * Rabs (L_at M x t))).
  apply Rmult_lt_0_compat; auto. unfold ratio. field. split; [apply Rabs_no_R0, HL|lra]. }
destruct (deviation_grows M P K Gamma_E theta h1 r1 eps x t HG Hon HX Hlen) as (len & Dl & Hl).
eexists. split. apply (ratio_rate M P K h1 r1 eps x t Hon HX HL len Dl).
apply ratio_bound; auto. destruct HK as (_ & Hb & _). lra. apply Rlt_le, Hz.
Qed.

Theorem drift_of_C1 : StatementPassage.drift_of_C1.
Proof.
intros M P K h1 r1 eps x t Hon HX HL. eexists. split. apply (log_C_rate M P K h1 r1 eps x t Hon HX HL).
assert (W2 := w2_small M P K h1 r1 eps x t Hon HL). destruct Hon as ((_ & Hb & _) & _).
set (w2 := second (deviation_at M P eps x t) / (p x t * L_at M x t)) in *.
set (w := value_of (slow_w P) (h_at M eps x t) (r_at x t)).
replace (- beta_of M * (w + w2) + beta_of M * w) with (- (beta_of M * w2)) by ring.
rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (beta_of M)), Rmult_assoc by lra. apply Rmult_le_compat_l; lra.
Qed.

(** ** Starts (8) *)

Lemma monomial_le a h r h' r' : 0 <= h <= h' -> 0 <= r <= r' -> 0 <= monomial a h r <= monomial a h' r'.
Proof.
intros Hh Hr. unfold monomial.
assert (Ph : 0 <= h ^ by_h a <= h' ^ by_h a) by (split; [apply pow_le; lra|apply pow_incr; lra]).
assert (Pr : 0 <= r ^ by_r a <= r' ^ by_r a) by (split; [apply pow_le; lra|apply pow_incr; lra]).
split; [apply Rmult_le_pos|apply Rmult_le_compat]; lra.
Qed.

Lemma value_below_size F h r h' r' : 0 <= h <= h' -> 0 <= r <= r' -> Rabs (value_of F h r) <= size F h' r'.
Proof.
intros Hh Hr. unfold value_of, size. eapply Rle_trans. apply total_abs. apply total_le. intros a.
assert (Q := monomial_le a h r h' r' Hh Hr).
rewrite Rabs_mult, (Rabs_pos_eq (monomial a h r)) by lra. apply Rmult_le_compat_l. apply Rabs_pos. lra.
Qed.

Theorem start_ratio : StatementPassage.start_ratio.
Proof.
intros M P K h1 r1 eta e0 eps x t HK Hd H1 He Hp Hh1 Hr1 Hle HL HV HW Hphi.
assert (Kp := sqrt_lt_R0 _ (kappa_positive M (proj1 HK))).
assert (Lp := sqrt_lt_R0 _ (l_positive M (proj1 HK))). assert (gp := g_positive M (proj1 HK)).
assert (R0 := sqrt_lt_R0 _ Hp). assert (A0 := Rabs_pos_lt _ HL).
set (r := sqrt (p x t)) in *. set (h0 := e0 / (p x t * r)) in *. set (h := h_at M eps x t).
assert (Epr : p x t = r ^ 2) by (unfold r; simpl; rewrite Rmult_1_r, sqrt_sqrt; lra).
assert (Hh : 0 < h <= h0).
{ assert (0 < p x t * r) by (apply Rmult_lt_0_compat; auto). unfold h, h_at, h0. fold r. split.
  apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; lra.
  apply Rmult_le_compat_r; auto. apply Rlt_le, Rinv_0_lt_compat; auto. }
assert (N := norm_above M K h r h1 r1 HK ltac:(lra) ltac:(lra) Hd (deviation_at M P eps x t)).
change (norm M K h r (deviation_at M P eps x t)) with (deviation_length M P K eps x t) in N.
unfold deviation_at in N; simpl in N. fold h in N. fold (r_at x t) in *. change (r_at x t) with r in N.
set (l0 := L_at M x t) in *. destruct P as [Pv Pw Pf]; simpl in N.
assert (Bv := value_below_size Pv h r h0 r ltac:(lra) ltac:(lra)).
assert (Bw := value_below_size Pw h r h0 r ltac:(lra) ltac:(lra)).
assert (Bf := value_below_size Pf h r h0 r ltac:(lra) ltac:(lra)).
set (sv := size Pv h0 r) in *. set (sw := size Pw h0 r) in *. set (sf := size Pf h0 r) in *.
assert (T : forall a k f s, Rabs f <= s -> 0 <= k -> Rabs (a - l0 * k * f) <= Rabs a + Rabs l0 * k * s).
{ intros a k f s Hs Hk. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp.
  apply Rplus_le_compat_l. rewrite !Rabs_mult, (Rabs_pos_eq k) by exact Hk. apply Rmult_le_compat_l; auto.
  apply Rmult_le_pos; lra. }
assert (P2 : 0 < r * (r * 1)) by (rewrite Rmult_1_r; apply Rmult_lt_0_compat; auto).
assert (T1 := T (V_at eps x t) 1 _ _ Bv ltac:(lra)). assert (T2 := T (W_at M eps x t) _ _ _ Bw (Rlt_le _ _ P2)).
assert (T3 := T (phi_at M eps x t) _ _ _ Bf (Rlt_le _ _ P2)). rewrite !Rmult_1_r in *.
assert (U1 : sqrt (kappa_of M) * Rabs (r * (V_at eps x t - l0 * value_of Pv h r))
  <= r * (eta * r * Rabs l0 + sqrt (kappa_of M) * (Rabs l0 * sv))).
{ rewrite Rabs_mult, (Rabs_pos_eq r) by lra. apply (Rmult_le_compat_l (r * sqrt (kappa_of M))) in T1.
  2: apply Rlt_le, Rmult_lt_0_compat; auto. apply (Rmult_le_compat_l r) in HV; lra. }
assert (U3 : g_of M / sqrt (l_of M) * Rabs (r * (phi_at M eps x t - l0 * (r * r) * value_of Pf h r))
  <= r * (eta * r * Rabs l0 + g_of M / sqrt (l_of M) * (Rabs l0 * (r * r) * sf))).
{ rewrite Rabs_mult, (Rabs_pos_eq r) by lra.
  assert (G0 : 0 < g_of M / sqrt (l_of M)) by (apply Rdiv_lt_0_compat; auto).
  apply (Rmult_le_compat_l (r * (g_of M / sqrt (l_of M)))) in T3.
  2: apply Rlt_le, Rmult_lt_0_compat; auto. apply (Rmult_le_compat_l r) in Hphi; lra. }
assert (Hden : 0 < p x t * Rabs l0) by (apply Rmult_lt_0_compat; auto).
change (start_bound M (SlowPart Pv Pw Pf) eta e0 (p x t))
  with (3 * eta + sqrt (kappa_of M) * sv / r + sw + g_of M / sqrt (l_of M) * r * sf).
unfold ratio. fold l0.
apply Rmult_le_reg_r with (p x t * Rabs l0); auto.
unfold Rdiv at 1. rewrite (Rmult_assoc (deviation_length _ _ _ _ _ _)), Rinv_l, Rmult_1_r by lra.
apply Rle_trans with (1 := N). rewrite Epr in *.
apply Rle_trans with (r * (eta * r * Rabs l0 + sqrt (kappa_of M) * (Rabs l0 * sv))
  + (eta * r ^ 2 * Rabs l0 + Rabs l0 * (r * r) * sw) + r * (eta * r * Rabs l0 + g_of M / sqrt (l_of M) * (Rabs l0 * (r
    * r) * sf))).
{ lra. }
right. field. split; lra.
Qed.
