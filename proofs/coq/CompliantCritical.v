(** * The compliant model: 4 < beta < 5

    Theorem D of proofs/finite_epsilon_zeros.md, section 4 (b), with b = beta - 1 in (3, 4). F_b has a valley
    ([CompliantLaw.v]). Theorem C: at every place Gamma(-b) G_b increases with eta; and by at most (eta' - eta)/8
    Gamma(-b) G_b^(4), since (d/deta) h <= r^4/8. So the eps for which F_b is negative somewhere are those below a
    number eps_c; they are some, since Theta is negative somewhere; at eps_c itself F_b is not negative, by this bound
    to the right, and not positive everywhere, by this bound to the left and because the places where G_b is negative
    lie in one interval. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted Classical.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral ImproperIntegral Family
  Ends SignPattern PositiveZeros CountLaw
  CompliantKernel CompliantIntegral CompliantSlow LeftExpansion CompliantMonotone CompliantThreshold CompliantPower
    CompliantLaw.
Import ListNotations.
Open Scope R_scope.

(** ** The weight grows by at most (eta' - eta) r^4/8 *)
Lemma psi_slope_upper x : 0 < x -> psi_slope x <= x ^ 4 / 4.
Proof.
intros Hx. apply Rlt_le. assert (H : 0 ^ 4 / 4 - psi_slope 0 < x ^ 4 / 4 - psi_slope x).
{ apply (incr_of_derive (fun u => u ^ 4 / 4 - psi_slope u) (fun u => u ^ 3 - u ^ 3 / (1 + u) ^ 2)); auto.
  - intros u Hu. unfold psi_slope, psi. auto_derive. repeat split; lra. field; lra.
  - intros u Hu. assert (0 < u ^ 3) by (apply pow_lt; lra). assert (1 < (1 + u) ^ 2) by nra.
    assert (u ^ 3 / (1 + u) ^ 2 < u ^ 3); [|lra]. apply Rmult_lt_reg_r with ((1 + u) ^ 2); [lra|].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra. }
replace (psi_slope 0) with 0 in H by (unfold psi_slope; rewrite psi_0; field). lra.
Qed.

Lemma weight_grows eta eta' r : 0 < eta < eta' -> 0 < r -> weight_exponent eta' r - weight_exponent eta r
  <= (eta' - eta) * r ^ 4 / 8.
Proof.
intros He Hr.
assert (D : forall u, 0 < u -> is_derive (fun u => weight_exponent u r) u
  (r ^ 4 / 2 * (psi_slope (u * r) / (u * r) ^ 4))).
{ intros u Hu. unfold weight_exponent, psi_slope, psi. assert (0 < u * r) by (apply Rmult_lt_0_compat; auto).
  assert (2 * u ^ 3 <> 0) by (assert (0 < u ^ 3) by (apply pow_lt, Hu); lra).
  auto_derive. repeat split; auto; lra. field. repeat split; lra. }
destruct (mvt_open (fun u => weight_exponent u r) (fun u => r ^ 4 / 2 * (psi_slope (u * r) / (u * r) ^ 4))
  eta eta' ltac:(lra)) as (c & Hc & E).
{ intros u Hu. apply D. lra. }
rewrite E. replace ((eta' - eta) * r ^ 4 / 8) with (r ^ 4 / 2 * / 4 * (eta' - eta)) by field.
apply Rmult_le_compat_r; [lra|]. assert (P := psi_slope_upper (c * r) ltac:(apply Rmult_lt_0_compat; lra)).
assert (Q : 0 < (c * r) ^ 4) by (apply pow_lt, Rmult_lt_0_compat; lra). assert (R4 : 0 < r ^ 4) by (apply pow_lt, Hr).
apply Rmult_le_compat_l; [lra|]. apply Rmult_le_reg_r with ((c * r) ^ 4); auto. unfold Rdiv.
rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

Theorem grows_at_most b n eta eta' t : not_nat b -> b < INR n + 4 -> 0 < eta < eta' ->
  scaled_J eta' (- b - 1) n t <= scaled_J eta (- b - 1) n t + (eta' - eta) / 8 * scaled_J eta' (- b - 1) (n + 4) t.
Proof.
intros Hb Hn He. set (s := - b - 1). assert (Hs : ok s) by (apply ok_not_nat, Hb).
apply (family_upper s eta eta' (scaled_J eta s) (scaled_J eta' s) Hs (scaled_J_family eta ltac:(lra) s Hs)
  (scaled_J_family eta' ltac:(lra) s Hs));
  [|unfold s; lra].
intros k u Hk.
assert (A4 : -1 < s + INR (k + 4)) by (rewrite plus_INR; simpl; lra).
assert (I4 := scaled_J_integral eta' ltac:(lra) s (k + 4) u A4). apply (is_RInt_gen_scal _ ((eta' - eta) / 8)) in I4.
assert (I0 := scaled_J_integral eta ltac:(lra) s k u Hk). assert (P := is_RInt_gen_plus _ _ _ _ I0 I4).
eapply improper_le; [|exact (scaled_J_integral eta' ltac:(lra) s k u Hk)|exact P].
intros r Hr.
change (Rpower r (s + INR k) * exp (weight_exponent eta' r + r * u) <= Rpower r (s + INR k) * exp
  (weight_exponent eta r + r * u)
  + (eta' - eta) / 8 * (Rpower r (s + INR (k + 4)) * exp (weight_exponent eta' r + r * u))).
rewrite (Rpower_split r (s + INR (k + 4)) 4 (s + INR k)) by (auto; rewrite plus_INR; simpl; ring). rewrite !exp_plus.
set (Q := Rpower r (s + INR k)). assert (HQ : 0 < Q) by apply exp_pos. set (X := exp (r * u)).
assert (HX : 0 < X) by apply exp_pos.
assert (W := weight_grows eta eta' r He Hr). set (g := weight_exponent eta r) in *.
set (g' := weight_exponent eta' r) in *.
assert (C : exp g' - exp g <= (eta' - eta) / 8 * r ^ 4 * exp g').
{ assert (H := exp_ineq1_le (- (g' - g))).
  assert (E : exp g' * exp (- (g' - g)) = exp g) by (rewrite <- exp_plus; f_equal; ring).
  assert (HA := exp_pos g').
  assert (exp g' * (1 + - (g' - g)) <= exp g' * exp (- (g' - g))) by (apply Rmult_le_compat_l; lra).
  assert ((g' - g) * exp g' <= (eta' - eta) * r ^ 4 / 8 * exp g') by (apply Rmult_le_compat_r; lra). lra. }
assert (HQX : 0 < Q * X) by (apply Rmult_lt_0_compat; auto). apply (Rmult_le_compat_l (Q * X)) in C; [|lra]. lra.
Qed.

(** ** The valley in the words of the statement *)
Section Slow.
Variables (b : R).
Hypothesis H34 : 3 < b < 4.
Let Hb : not_nat b := proj1 (Gamma_cell 3 b ltac:(simpl; lra)).

Lemma Gamma_positive : 0 < Gamma (- b).
Proof. assert (H := proj2 (Gamma_cell 3 b ltac:(simpl; lra))). simpl in H. lra. Qed.

(** The least value is 0: a zero of multiplicity two. *)
Lemma valley_touches e m : 0 < e -> valley (Fe e b) (slope e b) m -> Fe e b m = 0 ->
  zeros_of (Fe e b) [m] /\ Derive (Fe e b) m = 0 /\ Derive_n (Fe e b) 2 m <> 0.
Proof.
intros He V Em. assert (D := fun t => slow_derive e He b t Hb).
assert (Sm : slope e b m = 0).
{ destruct (zeros_2 e He (b - 1) ltac:(lra)) as (z & _ & P). cbn [line_pattern pattern] in P.
  destruct P as (Lz & Ez & _ & Uz).
  destruct V as (L & U & _). unfold slope. destruct (Rtotal_order m z) as [H|[->|H]].
  - exfalso. specialize (Lz ((m + z) / 2) ltac:(lra)). specialize (U ((m + z) / 2) ltac:(lra)). unfold slope in U. nra.
  - rewrite Ez. ring.
  - exfalso. specialize (Uz ((m + z) / 2) ltac:(lra)). specialize (L ((m + z) / 2) ltac:(lra)). unfold slope in L.
    nra. }
split; [split|split].
- constructor; constructor.
- intros t. split.
  + intros Et. left. destruct (Req_dec t m) as [|Hne]; auto. assert (L := valley_least _ _ D m t V Hne). lra.
  + intros [<-|[]]. exact Em.
- rewrite (is_derive_unique _ _ _ (D m)). exact Sm.
- destruct (zeros_2 e He (b - 1) ltac:(lra)) as (z & _ & P). assert (Hb1 := not_nat_pred b Hb).
  assert (Z := pattern_simple _ _ _ _ (fun t => slow_derive e He (b - 1) t Hb1) P). destruct Z as ((_ & Z) & N).
  assert (I : In m [z]). { apply Z. unfold slope in Sm. apply Rmult_integral in Sm.
  destruct Sm as [Sm|Sm]; [lra|exact Sm]. }
  change (Derive_n (Fe e b) 2 m) with (Derive (Derive (Fe e b)) m).
  rewrite (Derive_ext _ (fun t => - b * Fe e (b - 1) t)) by (intros t; apply is_derive_unique, D).
  rewrite Derive_scal. apply Rmult_integral_contrapositive_currified; [lra|]. apply N, I.
Qed.

Theorem slow_valley e : 0 < e -> exists m, 0 < m /\ (forall s t, s < t -> t <= m -> Fe e b t < Fe e b s) /\
  (forall s t, m <= s -> s < t -> Fe e b s < Fe e b t) /\ is_lim (Fe e b) m_infty p_infty /\
    is_lim (Fe e b) p_infty p_infty /\
  (Fe e b m < 0 -> exists s t, s < m < t /\ simple_zeros (Fe e b) [s; t]) /\
  (Fe e b m = 0 -> zeros_of (Fe e b) [m] /\ Derive_n (Fe e b) 2 m <> 0) /\ (0 < Fe e b m -> forall t, 0 < Fe e b t).
Proof.
intros He. assert (D := fun t => slow_derive e He b t Hb). assert (HG := Gamma_positive).
destruct (valley_3 e He b H34) as (m & Hm & V). assert (V' := V). destruct V' as (L & U & _).
exists m. split; [exact Hm|]. refine (conj _ (conj _ (conj _ (conj _ (conj _ (conj _ _)))))).
- intros s t Hst Ht. assert (F := falls _ _ D 1 s t Hst (fun u Hu => ltac:(specialize (L u ltac:(lra)); lra))). lra.
- intros s t Hs Hst. assert (F := falls _ _ D (-1) s t Hst (fun u Hu => ltac:(specialize (U u ltac:(lra)); lra))). lra.
- (* F(-x) >= x^b/2 *)
  assert (A := Fe_asymptotics e He b Hb). apply is_lim_spec in A. destruct (A (mkposreal (/ 2) ltac:(lra))) as [M HM].
  simpl in HM.
  apply is_lim_spec. intros K. exists (- (Rmax M (Rmax 1 (2 * Rabs K)))). intros t Ht.
  assert (X1 := Rmax_l M (Rmax 1 (2 * Rabs K))). assert (X2 := Rmax_r M (Rmax 1 (2 * Rabs K))).
  assert (X3 := Rmax_l 1 (2 * Rabs K)). assert (X4 := Rmax_r 1 (2 * Rabs K)).
  set (x := - t). assert (Hx : t = - x) by (unfold x; ring). rewrite Hx. specialize (HM x ltac:(unfold x; lra)).
  apply Rabs_def2 in HM.
  assert (P : x <= Rpower x b).
  { rewrite <- (Rpower_1 x) at 1 by (unfold x; lra). apply Rle_Rpower; unfold x; lra. }
  assert (Q : Fe e b (- x) = Fe e b (- x) / Rpower x b * Rpower x b) by (field; apply Rgt_not_eq, exp_pos).
  rewrite Q. apply Rlt_le_trans with (/ 2 * Rpower x b * 1 + 0); [|].
  + assert (K0 := Rle_abs K). assert (2 * Rabs K < x) by (unfold x; lra). lra.
  + assert (0 < Rpower x b) by apply exp_pos. nra.
- apply is_lim_spec. intros K. destruct (Fe_right e He b 0 Hb (Gamma (- b) * (K + 1))) as (T & _ & HT). exists T.
  intros t Ht.
  specialize (HT t ltac:(lra)). simpl in HT. apply Rmult_le_reg_l in HT; lra.
- intros N. destruct (valley_zeros _ _ D m V N) as (s & t & Hst & P). exists s, t. split; auto.
  exact (pattern_simple _ _ _ _ D P).
- intros E. destruct (valley_touches e m He V E) as (Z & _ & N). split; auto.
- intros P t. destruct (Req_dec t m) as [->|Hne]; auto. assert (Lt := valley_least _ _ D m t V Hne). lra.
Qed.

(** ** The number eps_c *)
Definition scale (e : R) : R := Rpower (e / 2) (1 / 3).
Definition value (eta t : R) : R := scaled_J eta (- b - 1) 0 t.
Definition negative (e : R) : Prop := 0 < e /\ exists t, value (scale e) t < 0.

Lemma scale_increases e e' : 0 < e < e' -> 0 < scale e < scale e'.
Proof.
intros He. split; [apply exp_pos|]. apply exp_increasing, Rmult_lt_compat_l; [lra|]. apply ln_increasing; lra.
Qed.

Lemma scale_of eta : 0 < eta -> scale (2 * eta ^ 3) = eta.
Proof.
intros He. unfold scale. replace (2 * eta ^ 3 / 2) with (eta ^ 3) by field. rewrite <- Rpower_pow, Rpower_mult by auto.
replace (INR 3 * (1 / 3)) with 1 by (simpl; field). apply Rpower_1, He.
Qed.

(** G in the unit of Gamma(-b) G is a multiple of F. *)
Definition unit (e : R) : R := Gamma (- b) / Rpower (scale e) (- b).

Lemma unit_positive e : 0 < unit e.
Proof. apply Rdiv_lt_0_compat; [exact Gamma_positive|apply exp_pos]. Qed.

Lemma value_slow e t : 0 < e -> value (scale e) t = unit e * Fe e b (t / scale e).
Proof.
intros He. assert (S := Fe_scaled e He b (t / scale e) Hb). fold (scale e) in S.
assert (HS : 0 < scale e) by apply exp_pos.
replace (scale e * (t / scale e)) with t in S by (field; lra). fold (value (scale e) t) in S.
assert (P : 0 < Rpower (scale e) (- b)) by apply exp_pos. unfold unit.
apply (Rmult_eq_reg_l (Rpower (scale e) (- b))); [|lra]. rewrite <- S. field. lra.
Qed.

Lemma negative_slow e : 0 < e -> (negative e <-> exists T, Fe e b T < 0).
Proof.
intros He. assert (HS : 0 < scale e) by apply exp_pos. split.
- intros (_ & t & Ht). exists (t / scale e). rewrite (value_slow e t He) in Ht. assert (U := unit_positive e). nra.
- intros (T & HT). split; auto. exists (scale e * T). rewrite (value_slow e (scale e * T) He).
  assert (U := unit_positive e).
  replace (scale e * T / scale e) with T by (field; lra). nra.
Qed.

Lemma value_increases eta eta' t : 0 < eta < eta' -> value eta t < value eta' t.
Proof. intros He. apply (monotone_in_eta b 0 eta eta' t Hb ltac:(simpl; lra) He). Qed.

Lemma negative_below e e' : 0 < e < e' -> negative e' -> negative e.
Proof.
intros He (_ & t & Ht). split; [lra|]. exists t.
assert (V := value_increases (scale e) (scale e') t (scale_increases e e' He)). lra.
Qed.

(** The fourth derivative, where the integral converges: it increases with t and eta. *)
Definition fourth (eta t : R) : R := scaled_J eta (- b - 1) 4 t.

Lemma fourth_increases eta eta' t t' : 0 < eta < eta' -> t < t' -> 0 < fourth eta t < fourth eta' t'.
Proof.
intros He Ht. assert (P : forall n eta t, 0 < eta -> (4 <= n)%nat -> 0 < scaled_J eta (- b - 1) n t).
{ intros n u v Hu Hn. apply Rmult_lt_0_compat; [apply exp_pos|]. apply Je_pos; [apply two_cube, Hu|].
  apply (le_INR 4) in Hn. simpl in Hn. lra. }
split; [apply P; lra || lia|]. apply Rlt_trans with (fourth eta t').
- assert (F := scaled_J_family eta ltac:(lra) (- b - 1) (ok_not_nat b Hb)).
  destruct (mvt_open (fourth eta) (scaled_J eta (- b - 1) 5) t t' Ht (fun u _ => proj1 F 4%nat u)) as (c & _ & E).
  assert (Q := P 5%nat eta c ltac:(lra) ltac:(lia)).
  assert (0 < scaled_J eta (- b - 1) 5 c * (t' - t)) by (apply Rmult_lt_0_compat; lra). lra.
- apply (monotone_in_eta b 4 eta eta' t' Hb ltac:(simpl; lra) He).
Qed.

Lemma value_grows eta eta' t : 0 < eta < eta' -> value eta' t <= value eta t + (eta' - eta) / 8 * fourth eta' t.
Proof. intros He. apply (grows_at_most b 0 eta eta' t Hb ltac:(simpl; lra) He). Qed.

(** Small eps: Theta is negative somewhere. *)
Lemma theta_negative : exists t, Th b t < 0.
Proof.
destruct (Th_zeros 4 b) as (ln & lp & Ln & Lp & _ & _ & P); [unfold cell; simpl; lra|].
unfold negative_count in Ln. simpl in Ln, Lp. destruct ln; [|discriminate].
destruct lp as [|x [|x' [|]]]; try discriminate.
cbn [app line_pattern pattern] in P. destruct P as (_ & _ & _ & Hx & Mid & _). exists ((x + x') / 2).
specialize (Mid ((x + x') / 2) ltac:(lra)). lra.
Qed.

Lemma negative_small : exists e, negative e.
Proof.
destruct theta_negative as (t & Ht). set (d := Gamma (- b) * Th b t).
assert (Hd : d < 0) by (unfold d; assert (HG := Gamma_positive); nra).
assert (F1 := fourth_increases 1 2 t (t + 1) ltac:(lra) ltac:(lra)). set (K := fourth 2 (t + 1)) in *.
assert (HK : 0 < K) by lra.
set (eta := Rmin 1 (- d / K)). assert (Hd' : 0 < - d / K) by (apply Rdiv_lt_0_compat; lra).
assert (E0 : 0 < eta) by (apply Rmin_glb_lt; lra). assert (E1 : eta <= 1) by apply Rmin_l.
assert (E2 : eta <= - d / K) by apply Rmin_r.
exists (2 * eta ^ 3). split; [apply two_cube, E0|]. exists t. rewrite scale_of by auto.
destruct (above_leading_order b 0 eta (Th b) t Hb ltac:(simpl; lra) E0 (Th_correct b)) as [_ A].
change (scaled_J eta (- b - 1) (0 + 4) t) with (fourth eta t) in A. change (scaled b (Th b) 0 t) with d in A.
fold (value eta t) in A.
assert (F : fourth eta t <= K).
{ assert (H := fourth_increases eta 2 t (t + 1) ltac:(lra) ltac:(lra)). unfold K. lra. }
assert (eta / 8 * fourth eta t <= eta / 8 * K) by (apply Rmult_le_compat_l; lra).
assert (eta * K <= - d).
{ apply (Rmult_le_compat_r K) in E2; [|lra]. replace (- d / K * K) with (- d) in E2 by (field; lra). exact E2. }
lra.
Qed.

(** No number is the last at which G is negative somewhere. *)
Lemma negative_open e : negative e -> exists e', e < e' /\ negative e'.
Proof.
intros (He & t & Ht). assert (HS : 0 < scale e) by apply exp_pos. set (eta := scale e) in *.
set (d := value eta t) in *.
assert (F1 := fourth_increases (eta + 1) (eta + 2) t (t + 1) ltac:(lra) ltac:(lra)).
set (K := fourth (eta + 2) (t + 1)) in *. assert (HK : 0 < K) by lra.
set (u := Rmin 1 (- d / K)). assert (Hd' : 0 < - d / K) by (apply Rdiv_lt_0_compat; lra).
assert (U0 : 0 < u) by (apply Rmin_glb_lt; lra). assert (U1 : u <= 1) by apply Rmin_l.
assert (U2 : u <= - d / K) by apply Rmin_r.
assert (V : value (eta + u) t < 0).
{ assert (A := value_grows eta (eta + u) t ltac:(lra)). fold d in A.
  assert (F := fourth_increases (eta + u) (eta + 2) t (t + 1) ltac:(lra) ltac:(lra)). fold K in F.
  assert (u * K <= - d).
  { apply (Rmult_le_compat_r K) in U2; [|lra]. replace (- d / K * K) with (- d) in U2 by (field; lra). exact U2. }
  assert (u / 8 * fourth (eta + u) t <= u / 8 * K) by (apply Rmult_le_compat_l; lra).
  replace (eta + u - eta) with u in A by ring. lra. }
exists (2 * (eta + u) ^ 3). split; [|split].
- assert (E := eta_cube e He). fold (scale e) in E. fold eta in E. assert (eta ^ 3 < (eta + u) ^ 3); [|lra].
  assert (0 < eta ^ 2) by (apply pow_lt, HS). simpl. nra.
- apply two_cube. lra.
- exists t. rewrite scale_of by lra. exact V.
Qed.

(** If every smaller one is, G is not positive everywhere: where they are negative is bounded from the right. *)
Lemma touches_limit e : 0 < e -> (forall e', 0 < e' < e -> negative e') -> exists T, Fe e b T <= 0.
Proof.
intros He Below. assert (HS : 0 < scale e) by apply exp_pos. set (eta := scale e) in *. assert (U := unit_positive e).
assert (E := eta_cube e He). fold (scale e) in E. fold eta in E. assert (D := fun t => slow_derive e He b t Hb).
destruct (valley_3 e He b H34) as (m & _ & V). exists m. apply Rnot_lt_le. intros Hm.
set (d := unit e * Fe e b m). assert (Hd : 0 < d) by (apply Rmult_lt_0_compat; auto).
assert (Least : forall t, d <= value eta t).
{ intros t. unfold eta. rewrite (value_slow e t He). apply Rmult_le_compat_l; [lra|].
  destruct (Req_dec (t / scale e) m) as [->|Hne]; [lra|]. assert (L := valley_least _ _ D m _ V Hne). lra. }
destruct (Fe_right (e / 2) ltac:(lra) b 0 Hb 1) as (T & _ & HT).
set (eta0 := scale (e / 2)). assert (H0 : 0 < eta0 < eta) by (apply scale_increases; lra).
set (X := eta0 * T).
assert (Right : forall t, value eta0 t < 0 -> t < X).
{ intros t Ht. unfold eta0 in Ht. rewrite (value_slow (e / 2)) in Ht by lra. fold eta0 in Ht.
  assert (U0 := unit_positive (e / 2)).
  apply Rnot_le_lt. intros Hl. assert (T <= t / eta0).
  { apply Rmult_le_reg_l with eta0; [lra|]. unfold X in Hl. replace (eta0 * (t / eta0)) with t by (field; lra).
    exact Hl. }
  specialize (HT (t / eta0) H). simpl in HT. assert (HG := Gamma_positive). nra. }
set (K := fourth (eta + 1) (X + 1)).
assert (HK : forall t, t < X -> 0 < fourth eta t < K) by (intros t Ht; apply fourth_increases; lra).
assert (HK0 : 0 < K) by (specialize (HK (X - 1) ltac:(lra)); lra).
set (u := Rmin ((eta - eta0) / 2) (4 * d / K)). assert (Hq : 0 < 4 * d / K) by (apply Rdiv_lt_0_compat; lra).
assert (U0 : 0 < u) by (apply Rmin_glb_lt; lra). assert (U1 : u <= (eta - eta0) / 2) by apply Rmin_l.
assert (U2 : u <= 4 * d / K) by apply Rmin_r.
destruct (Below (2 * (eta - u) ^ 3)) as (_ & t & Ht).
{ split; [apply two_cube; lra|]. rewrite <- E. assert ((eta - u) ^ 3 < eta ^ 3); [|lra].
  assert (0 < (eta - u) ^ 2) by (apply pow_lt; lra). assert (0 < eta - u) by lra. simpl in *. nra. }
rewrite scale_of in Ht by lra.
assert (Ht0 : value eta0 t < 0) by (assert (I := value_increases eta0 (eta - u) t ltac:(lra)); lra).
specialize (HK t (Right t Ht0)). specialize (Least t). assert (G := value_grows (eta - u) eta t ltac:(lra)).
replace (eta - (eta - u)) with u in G by ring.
assert (u * K <= 4 * d).
{ apply (Rmult_le_compat_r K) in U2; [|lra]. replace (4 * d / K * K) with (4 * d) in U2 by (field; lra). exact U2. }
assert (u / 8 * fourth eta t <= u / 8 * K) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Theorem critical_eps : exists ec : Rbar, Rbar_lt 0 ec /\ forall e, 0 < e ->
  (Rbar_lt e ec -> exists s t, s < t /\ simple_zeros (Fe e b) [s; t]) /\
  (Finite e = ec -> exists t, zeros_of (Fe e b) [t] /\ Derive (Fe e b) t = 0 /\ Derive_n (Fe e b) 2 t <> 0) /\
  (Rbar_lt ec e -> forall t, 0 < Fe e b t).
Proof.
destruct (ex_lub_Rbar negative) as (ec & Upper & Least). destruct negative_small as (e0 & N0).
assert (Below : forall e, 0 < e -> Rbar_lt e ec -> negative e).
{ intros e He Hlt. destruct (classic (exists e', e < e' /\ negative e')) as [(e' & Hl & N)|No].
  - apply (negative_below e e'); auto.
  - exfalso. apply (Rbar_lt_not_le _ _ Hlt). apply Least. intros x Nx. apply Rnot_lt_le. intros Hx. apply No. exists x.
    auto. }
assert (Above : forall e, negative e -> Rbar_lt e ec).
{ intros e N. destruct (negative_open e N) as (e' & Hl & N'). apply (Rbar_lt_le_trans _ e'); [exact Hl|].
  apply Upper, N'. }
exists ec. split. { apply (Rbar_lt_trans _ e0); [apply N0|apply Above, N0]. }
intros e He. destruct (valley_3 e He b H34) as (m & _ & V). assert (D := fun t => slow_derive e He b t Hb).
refine (conj _ (conj _ _)).
- intros Hlt. destruct (proj1 (negative_slow e He) (Below e He Hlt)) as (T & HT).
  exact (two_zeros_if_negative e b T He H34 HT).
- intros Eq. exists m. apply (valley_touches e m He V). apply Rle_antisym.
  + destruct (touches_limit e He) as (T & HT).
    { intros e' He'. apply Below; [lra|]. rewrite <- Eq. simpl. lra. }
    destruct (Req_dec T m) as [<-|Hne]; auto. assert (L := valley_least _ _ D m T V Hne). lra.
  + apply Rnot_lt_le. intros N. apply (Rbar_lt_not_eq e ec); [|exact Eq]. apply Above, negative_slow; auto. exists m.
    exact N.
- intros Hlt t.
  assert (Ex : exists e1, 0 < e1 < e /\ ~ negative e1).
  { destruct ec as [c| |]; simpl in Hlt.
    - assert (C0 : 0 < c). { specialize (Above e0 N0). simpl in Above. destruct N0. lra. }
      exists ((c + e) / 2). split; [lra|]. intros N. specialize (Above _ N). simpl in Above. lra.
    - contradiction.
    - specialize (Above e0 N0). contradiction. }
  destruct Ex as (e1 & H1 & N1). apply Rnot_le_lt. intros Hle.
  apply N1. split; [lra|]. exists (scale e * t). assert (P : 0 < scale e) by apply exp_pos.
  assert (U := unit_positive e).
  assert (I1 := value_increases (scale e1) (scale e) (scale e * t) (scale_increases e1 e ltac:(lra))).
  rewrite (value_slow e) in I1 by auto. replace (scale e * t / scale e) with t in I1 by (field; lra). nra.
Qed.
End Slow.

(** The force of a slow motion less its mean. *)
Theorem force_critical_eps beta : 4 < beta < 5 -> exists ec : Rbar, Rbar_lt 0 ec /\
  forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps -> a3 / a1 = beta -> slow_motion a1 a2 a3 eps C p b y v z ->
    C <> 0 ->
    let deviation t := linear_force eps (y t) (z t) - a2 / (a3 - a1) in
    (Rbar_lt (- a1 * eps) ec -> exists s t, s < t /\ simple_zeros deviation [s; t]) /\
    (Finite (- a1 * eps) = ec -> exists t, zeros_of deviation [t]) /\
    (Rbar_lt ec (- a1 * eps) -> forall t, deviation t <> 0).
Proof.
intros H45. destruct (critical_eps (beta - 1) ltac:(lra)) as (ec & Hec & H). exists ec. split; auto.
intros a1 a2 a3 eps C p b y v z Hpar <- HS HC deviation. assert (Hpar' := Hpar). destruct Hpar' as (H1 & H3 & He & Hb).
destruct (H (- a1 * eps) ltac:(nra)) as (Two & One & None).
destruct (force_is_multiple a1 a2 a3 eps C p b y v z Hpar HS HC) as (c & Hc & E).
refine (conj _ (conj _ _)).
- intros Hlt. destruct (Two Hlt) as (s & t & Hst & Z). exists (eps * s), (eps * t).
  split; [apply Rmult_lt_compat_l; auto|].
  exact (force_zeros_from a1 a2 a3 eps C p b y v z Hpar HS HC [s; t] Z).
- intros Eq. destruct (One Eq) as (t & (_ & Z) & _). exists (eps * t). split; [constructor; constructor|].
  intros u. unfold deviation. rewrite E. assert (Zu := Z (u / eps)). simpl in Zu |- *. split.
  + intros Eu. apply Rmult_integral in Eu. destruct Eu as [Eu|Eu]; [contradiction|]. apply Zu in Eu.
    destruct Eu as [Eu|[]]. left. rewrite Eu. field; lra.
  + intros [Eu|[]]. rewrite (proj2 Zu); [ring|]. left. rewrite <- Eu. field; lra.
- intros Hlt t. unfold deviation. rewrite E. assert (P := None Hlt (t / eps)).
  apply Rmult_integral_contrapositive_currified; [exact Hc|lra].
Qed.
