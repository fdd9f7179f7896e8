(** * The compliant model: at +oo each derivative of the slow solution outgrows the one before

    J_s >= c e^((M+1)T) from a window of the integral. X = J_(s+1) - M J_s has X' >= M X, since (r - M)^2 >= 0; were it
    never positive, e^(-MT) J_s would be bounded. So X >= c > 0 for large T when s > -1; integrated downwards it tends
    to +oo for every s. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus TruncatedIntegral TruncationLimit GammaFunction
  LaplaceIntegral ImproperIntegral Family CompliantKernel
  CompliantIntegral CompliantSlow.
Open Scope R_scope.

Section Dominance.
Variable e : R.
Hypothesis He : 0 < e.

Lemma Ie_window s t a d : -1 < s -> 0 < a -> a <= d -> RInt (ke e s t) a d <= Ie e s t.
Proof.
intros Hs Ha Hd.
set (B := exp (Kb e t) * (exp ((s + 1 + 1) * ln (s + 1 + 1) - (s + 1)) / (s + 1))).
destruct (ex_RInt_gen_bounded (ke e s t) B) as [l [Hl Hle]].
- intros; apply Rlt_le, ke_pos.
- intros; apply continuous_ke; auto.
- intros x y Hx Hy.
  apply Rle_trans with (RInt (fun r => exp (Kb e t) * gamma_integrand (s + 1) r) x y).
  + apply RInt_le; auto. apply ex_RInt_ke; auto.
    apply (ex_RInt_scal (gamma_integrand (s + 1))), ex_RInt_gamma_integrand; auto.
    intros r Hr. apply ke_le; lra.
  + rewrite (RInt_scal (gamma_integrand (s + 1))) by (apply ex_RInt_gamma_integrand; auto).
    unfold B. apply Rmult_le_compat_l. apply Rlt_le, exp_pos.
    apply RInt_gamma_integrand_bound; auto; lra.
- replace (Ie e s t) with l; [apply Hle; auto|].
  symmetry. apply (is_RInt_gen_unique (V := R_CompleteNormedModule) _ l). exact Hl.
Qed.

(** J_s grows faster than every exponential *)
Lemma Je_exponential s M : -1 < s -> 0 <= M -> exists c, 0 < c /\ forall t, 0 <= t -> c * exp ((M + 1) * t) <= Je e s t.
Proof.
intros Hs HM. exists (RInt (ke e s 0) (M + 1) (M + 2)). split.
- apply RInt_gt_0; try lra. intros; apply ke_pos. intros; apply continuous_ke; lra.
- intros t Ht. rewrite (Je_Ie e He) by auto.
  eapply Rle_trans; [|apply (Ie_window s t (M + 1) (M + 2)); lra].
  rewrite Rmult_comm, <- (RInt_scal (ke e s 0)) by (apply ex_RInt_ke; lra).
  apply RInt_le; [lra|apply (ex_RInt_scal (ke e s 0)), ex_RInt_ke; lra|apply ex_RInt_ke; lra|].
  intros r Hr. unfold scal; simpl; unfold mult; simpl. unfold ke.
  rewrite Rmult_0_r, Rplus_0_r, exp_plus.
  assert (H1 : exp ((M + 1) * t) <= exp (r * t)) by (apply exp_le; apply Rmult_le_compat_r; lra).
  assert (H2 : 0 < Rpower r s * exp (psi r / e)) by (apply Rmult_lt_0_compat; apply exp_pos).
  nra.
Qed.

Lemma Je_square s M t : -1 < s -> M * (Je e (s + 1) t - M * Je e s t) <= Je e (s + 1 + 1) t - M * Je e (s + 1) t.
Proof.
intros Hs. rewrite !(Je_Ie e He) by lra.
assert (I0 := Ie_correct e s t He Hs). assert (I1 := Ie_correct e (s + 1) t He ltac:(lra)).
assert (I2 := Ie_correct e (s + 1 + 1) t He ltac:(lra)).
assert (B := is_RInt_gen_plus _ _ _ _ (is_RInt_gen_minus _ _ _ _ I2 (is_RInt_gen_scal _ (2 * M) _ I1))
  (is_RInt_gen_scal _ (M ^ 2) _ I0)).
apply improper_pos in B.
- unfold scal, minus, plus, opp in B; simpl in B; unfold mult in B; simpl in B. lra.
- intros r Hr. unfold scal, minus, plus, opp; simpl; unfold mult; simpl. rewrite !Rpower_S by auto.
  assert (H2 : 0 < Rpower r s * exp (psi r / e + r * t)) by (apply Rmult_lt_0_compat; apply exp_pos).
  assert (H3 := pow2_ge_0 (r - M)).
  match goal with |- 0 <= ?x => replace x with ((r - M) ^ 2 * (Rpower r s * exp (psi r / e + r * t))) by ring end.
  apply Rmult_le_pos; [auto|apply Rlt_le; exact H2].
Qed.

Lemma Je_ratio_aux n : forall s, ok s -> -1 < s + INR n -> forall M, 0 <= M ->
  exists c T, 0 < c /\ 0 <= T /\ forall t, T <= t -> c <= Je e (s + 1) t - M * Je e s t.
Proof.
assert (DX : forall s M t, ok s -> is_derive (fun t => Je e (s + 1) t - M * Je e s t) t (Je e (s + 1 + 1) t - M * Je e
  (s + 1) t)).
{ intros s M t Hs. apply (is_derive_minus (Je e (s + 1)) (fun t => M * Je e s t)).
  - apply (Je_derive e He), ok_S, Hs.
  - apply (is_derive_scal (Je e s)), (Je_derive e He), Hs. }
induction n as [|n IH]; intros s Hs Hn M HM.
- simpl in Hn. assert (Hs1 : -1 < s) by lra.
  destruct (Classical_Prop.classic (exists T, 0 <= T /\ 0 < Je e (s + 1) T - M * Je e s T)) as [(T & HT & HX)|HN].
  + exists (Je e (s + 1) T - M * Je e s T), T. refine (conj HX (conj HT _)). intros t Ht.
    set (X := fun t => Je e (s + 1) t - M * Je e s t). change (X T <= X t). change (0 < X T) in HX.
    assert (G : X T * exp (- M * (T - T)) <= X t * exp (- M * (t - T))).
    { apply Ropp_le_cancel.
      apply (decr_of_derive (fun t => - (X t * exp (- M * (t - T))))
        (fun t => - ((Je e (s + 1 + 1) t - M * Je e (s + 1) t - M * X t) * exp (- M * (t - T)))) T t Ht).
      - intros x Hx. apply (is_derive_opp (fun t => X t * exp (- M * (t - T)))). eapply is_derive_val.
        + apply (is_derive_mult_R X (fun t => exp (- M * (t - T))) x _ (- M * exp (- M * (x - T))) (DX s M x Hs)).
          auto_derive; auto. unfold Rminus; ring.
        + ring.
      - intros x Hx. assert (A := Je_square s M x Hs1). fold (X x) in A.
        assert (0 <= (Je e (s + 1 + 1) x - M * Je e (s + 1) x - M * X x) * exp (- M * (x - T))).
        { apply Rmult_le_pos; [lra|apply Rlt_le, exp_pos]. } lra. }
    replace (- M * (T - T)) with 0 in G by ring. rewrite exp_0, Rmult_1_r in G.
    assert (E1 : exp (- M * (t - T)) <= 1).
    { rewrite <- exp_0. apply exp_le. assert (0 <= M * (t - T)) by (apply Rmult_le_pos; lra). lra. }
    assert (E0 := exp_pos (- M * (t - T))).
    assert (0 < X t) by (apply Rnot_le_lt; intros HXt; nra). nra.
  + exfalso.
    assert (HB : forall t, 0 <= t -> Je e s t * exp (- M * t) <= Je e s 0 * exp (- M * 0)).
    { intros t Ht.
      apply (decr_of_derive (fun t => Je e s t * exp (- M * t)) (fun t => (Je e (s + 1) t - M * Je e s t) * exp
        (- M * t)) 0 t Ht).
      - intros x Hx. eapply is_derive_val.
        + apply (is_derive_mult_R (Je e s) (fun t => exp (- M * t)) x _ (- M * exp (- M * x)) (Je_derive e He s x Hs)).
          auto_derive; auto. ring.
        + ring.
      - intros x Hx. assert (Je e (s + 1) x - M * Je e s x <= 0).
        { apply Rnot_lt_le. intros H. apply HN. exists x. split; [apply Hx|exact H]. }
        assert (A := exp_pos (- M * x)). nra. }
    destruct (Je_exponential s M Hs1 HM) as (c & Hc & Hexp).
    set (t := Je e s 0 / c). assert (P0 := Je_pos e He s 0 Hs1).
    assert (Ht : 0 < t) by (apply Rdiv_lt_0_compat; auto).
    specialize (HB t (Rlt_le _ _ Ht)). specialize (Hexp t (Rlt_le _ _ Ht)).
    rewrite Rmult_0_r, exp_0, Rmult_1_r in HB.
    assert (A : c * exp t <= Je e s t * exp (- M * t)).
    { apply Rle_trans with (c * exp ((M + 1) * t) * exp (- M * t)).
      - rewrite Rmult_assoc, <- exp_plus. right. do 2 f_equal. ring.
      - apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|exact Hexp]. }
    assert (A2 := exp_ineq1 t ltac:(lra)).
    assert (A3 : c * (1 + t) < c * exp t) by (apply Rmult_lt_compat_l; auto).
    replace (c * (1 + t)) with (c + Je e s 0) in A3 by (unfold t; field; lra). lra.
- rewrite S_INR in Hn.
  destruct (IH (s + 1) (ok_S s Hs) ltac:(lra) M HM) as (c & T & Hc & HT & H).
  destruct (grow (fun t => Je e (s + 1) t - M * Je e s t) (fun t => Je e (s + 1 + 1) t - M * Je e (s + 1) t) c T
    (fun t => DX s M t Hs) Hc H 1) as (T' & HT' & H').
  exists 1, T'. refine (conj Rlt_0_1 (conj _ H')). lra.
Qed.

(** Every n and M: |F^(n+1)| > M |F^(n)| for large T. *)
Theorem Fe_ratio b n M : not_nat b -> 0 <= M -> exists T, 0 <= T /\
  forall t, T <= t -> M * (Gamma (- b) * Derive_n (Fe e b) n t) < Gamma (- b) * Derive_n (Fe e b) (S n) t.
Proof.
intros Hb HM. set (s := INR n - b - 1).
assert (Hs : ok s).
{ unfold s. replace (INR n - b - 1) with (- b - 1 + INR n) by ring. apply ok_plus, ok_not_nat, Hb. }
destruct (ex_valid s) as [m Hm].
destruct (Je_ratio_aux m s Hs Hm M HM) as (c & T & Hc & HT & H).
exists T. split; auto. intros t Ht. specialize (H t Ht).
rewrite !(Fe_derive_n e He) by auto. rewrite S_INR.
replace (INR n + 1 - b - 1) with (s + 1) by (unfold s; ring). fold s. lra.
Qed.

End Dominance.
