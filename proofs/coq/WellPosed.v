(** * Theta exists and is unique

    Uniqueness is the energy estimate with g = 0. Existence is the power series: its coefficients times r^n are bounded
    for every r. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus Gronwall GammaFunction.
Open Scope R_scope.

(** Chain form of the definition. *)
Lemma is_Theta_intro (b : R) (th th1 th2 : R -> R) :
  (forall t, is_derive th t (th1 t)) ->
  (forall t, is_derive th1 t (th2 t)) ->
  (forall t, is_derive th2 t (t * th1 t - b * th t)) ->
  th 0 = Gamma (- b / 3) / (Rpower 3 ((3 + b) / 3) * Gamma (- b)) ->
  th1 0 = Gamma ((1 - b) / 3) / (Rpower 3 ((2 + b) / 3) * Gamma (- b)) ->
  th2 0 = Gamma ((2 - b) / 3) / (Rpower 3 ((1 + b) / 3) * Gamma (- b)) ->
  is_Theta b th.
Proof.
intros D0 D1 D2 H0 H1 H2.
assert (E1 : forall t, Derive th t = th1 t) by (intros t; apply is_derive_unique, D0).
assert (E2 : forall t, Derive_n th 2 t = th2 t).
{ intros t; simpl. rewrite (Derive_ext _ th1) by (intros; apply E1).
  apply is_derive_unique, D1. }
assert (E3 : forall t, Derive_n th 3 t = t * th1 t - b * th t).
{ intros t. change (Derive (Derive_n th 2) t = t * th1 t - b * th t).
  rewrite (Derive_ext _ th2) by (intros; apply E2).
  apply is_derive_unique, D2. }
refine (conj _ (conj _ (conj H0 (conj _ _)))).
- intros [|[|[|[|k]]]] t Hk; [exact I | | | |lia].
  + unfold ex_derive_n. exists (th1 t). apply (is_derive_ext th); auto.
  + unfold ex_derive_n. exists (th2 t). apply (is_derive_ext th1); auto.
    intros s; symmetry; apply E1.
  + unfold ex_derive_n. exists (t * th1 t - b * th t). apply (is_derive_ext th2); auto.
- intros t. rewrite E3, E1. ring.
- rewrite E1; auto.
- rewrite E2; auto.
Qed.

Lemma is_Theta_elim (b : R) (th : R -> R) : is_Theta b th ->
  (forall t, is_derive th t (Derive th t)) /\
  (forall t, is_derive (Derive th) t (Derive_n th 2 t)) /\
  (forall t, is_derive (Derive_n th 2) t (t * Derive th t - b * th t)).
Proof.
intros (Hex & Hode & _).
assert (D : forall n t, (n < 3)%nat -> is_derive (Derive_n th n) t (Derive_n th (S n) t)).
{ intros n t Hn. apply (Derive_correct (Derive_n th n)). exact (Hex (S n) t Hn). }
refine (conj _ (conj _ _)); intros t.
- apply (D 0%nat t); lia.
- apply (D 1%nat t); lia.
- replace (t * Derive th t - b * th t) with (Derive_n th 3 t) by (generalize (Hode t); lra).
  apply (D 2%nat t); lia.
Qed.

(** Uniqueness. *)
Theorem Theta_unique (b : R) (th ph : R -> R) :
  is_Theta b th -> is_Theta b ph -> forall t, th t = ph t.
Proof.
intros Ht Hp t.
destruct (is_Theta_elim b th Ht) as (D0 & D1 & D2).
destruct (is_Theta_elim b ph Hp) as (F0 & F1 & F2).
destruct Ht as (_ & _ & I0 & I1 & I2).
destruct Hp as (_ & _ & J0 & J1 & J2).
assert (H := gronwall_u0 (fun t => th t - ph t) (fun t => Derive th t - Derive ph t)
  (fun t => Derive_n th 2 t - Derive_n ph 2 t) (fun _ => 0) (- b) (Rabs t) 0 (Rabs_pos t)).
assert (H' : (th t - ph t) ^ 2 <= 0).
{ eapply Rle_trans. apply H.
  - intros s. apply (is_derive_minus th ph); auto.
  - intros s. apply (is_derive_minus (Derive th) (Derive ph)); auto.
  - intros s.
    replace (s * (Derive th s - Derive ph s) + - b * (th s - ph s) + 0) with
      ((s * Derive th s - b * th s) - (s * Derive ph s - b * ph s)) by ring.
    apply (is_derive_minus (Derive_n th 2) (Derive_n ph 2)); auto.
  - intros; rewrite Rabs_R0; apply Rle_refl.
  - apply Rle_refl.
  - rewrite I0, I1, I2, J0, J1, J2.
    right. unfold Rminus. rewrite !Rplus_opp_r. ring. }
nra.
Qed.

(** Existence: the power series. *)
Section Exist.
Variables (b A0 A1 A2 : R).

Fixpoint coef (n : nat) : R :=
  match n with
  | O => A0
  | S O => A1
  | S (S O) => A2 / 2
  | S (S (S m)) => (INR m - b) / ((INR m + 1) * (INR m + 2) * (INR m + 3)) * coef m
  end.

Lemma coef_rec m :
  coef (S (S (S m))) = (INR m - b) / ((INR m + 1) * (INR m + 2) * (INR m + 3)) * coef m.
Proof. reflexivity. Qed.

Lemma coef_bounded r : exists B, forall n, Rabs (coef n * r ^ n) <= B.
Proof.
set (w := fun n => Rabs (coef n * r ^ n)).
set (Q := (1 + Rabs b) * Rabs r ^ 3).
assert (HQ : 0 <= Q).
{ apply Rmult_le_pos. generalize (Rabs_pos b); lra. apply pow_le, Rabs_pos. }
destruct (nfloor_ex Q HQ) as [N [_ HN]].
assert (Hstep : forall n, (N <= n)%nat -> w (S (S (S n))) <= w n).
{ intros n Hn. unfold w. rewrite coef_rec.
  replace ((INR n - b) / ((INR n + 1) * (INR n + 2) * (INR n + 3)) * coef n * r ^ S (S (S n)))
    with ((INR n - b) / ((INR n + 1) * (INR n + 2) * (INR n + 3)) * r ^ 3 * (coef n * r ^ n))
    by (simpl; ring).
  rewrite Rabs_mult.
  rewrite <- (Rmult_1_l (Rabs (coef n * r ^ n))) at 2.
  apply Rmult_le_compat_r; [apply Rabs_pos|].
  assert (Hi := pos_INR n).
  assert (HNn : INR N <= INR n) by (apply le_INR, Hn).
  unfold Rdiv. rewrite !Rabs_mult, Rabs_inv.
  rewrite (Rabs_pos_eq ((INR n + 1) * (INR n + 2) * (INR n + 3)))
    by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
  rewrite <- RPow_abs.
  assert (Hb : Rabs (INR n - b) <= (INR n + 1) * (1 + Rabs b)).
  { eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp, (Rabs_pos_eq (INR n)) by lra.
    generalize (Rabs_pos b). intros.
    assert (0 <= INR n * Rabs b) by (apply Rmult_le_pos; lra). lra. }
  set (D := (INR n + 1) * (INR n + 2) * (INR n + 3)).
  assert (HD : 0 < D) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  apply Rmult_le_reg_r with D; auto.
  replace (Rabs (INR n - b) * / D * Rabs r ^ 3 * D) with (Rabs (INR n - b) * Rabs r ^ 3)
    by (field; lra).
  rewrite Rmult_1_l.
  apply Rle_trans with ((INR n + 1) * Q).
  - unfold Q. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; auto. apply pow_le, Rabs_pos.
  - unfold D. rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
    nra. }
exists (sum_f_R0 w (N + 2)).
assert (Hsum : forall n, (n <= N + 2)%nat -> w n <= sum_f_R0 w (N + 2)).
{ intros n Hn.
  assert (Hw : forall k, 0 <= w k) by (intros; apply Rabs_pos).
  induction (N + 2)%nat as [|k IH].
  - replace n with O by lia. simpl; lra.
  - simpl. destruct (Nat.eq_dec n (S k)) as [->|Hne].
    + assert (0 <= sum_f_R0 w k) by (apply cond_pos_sum; auto). lra.
    + assert (H := IH ltac:(lia)). specialize (Hw (S k)). lra. }
assert (H3 : forall n, w n <= sum_f_R0 w (N + 2) /\ w (S n) <= sum_f_R0 w (N + 2)
   /\ w (S (S n)) <= sum_f_R0 w (N + 2)).
{ induction n as [|n (IH0 & IH1 & IH2)].
  - repeat split; apply Hsum; lia.
  - refine (conj IH1 (conj IH2 _)).
    destruct (le_lt_dec N n) as [H|H].
    + eapply Rle_trans. apply Hstep, H. exact IH0.
    + apply Hsum; lia. }
intros n; apply (H3 n).
Qed.

Lemma coef_radius : CV_radius coef = p_infty.
Proof.
destruct (CV_radius_bounded coef) as [Hub _].
destruct (CV_radius coef) as [x| |]; auto; exfalso.
- assert (H := Hub (x + 1) (coef_bounded (x + 1))). simpl in H. lra.
- exact (Hub 0 (coef_bounded 0)).
Qed.

Let s0 := PSeries coef.
Let s1 := PSeries (PS_derive coef).
Let s2 := PSeries (PS_derive (PS_derive coef)).

Lemma s_derive0 t : is_derive s0 t (s1 t).
Proof. apply is_derive_PSeries. rewrite coef_radius; exact I. Qed.

Lemma s_derive1 t : is_derive s1 t (s2 t).
Proof. apply is_derive_PSeries. rewrite CV_radius_derive, coef_radius; exact I. Qed.

Lemma s_derive2 t : is_derive s2 t (t * s1 t - b * s0 t).
Proof.
evar_last.
- apply is_derive_PSeries. rewrite !CV_radius_derive, coef_radius; exact I.
- rewrite (PSeries_ext _ (PS_minus (PS_incr_1 (PS_derive coef)) (PS_scal b coef))).
  + rewrite PSeries_minus, PSeries_incr_1, PSeries_scal. exact eq_refl.
    * apply ex_pseries_incr_1. apply CV_radius_inside.
      rewrite CV_radius_derive, coef_radius; exact I.
    * apply ex_pseries_scal. apply Rmult_comm. apply CV_radius_inside.
      rewrite coef_radius; exact I.
  + intros n. unfold PS_derive at 1 2 3. rewrite coef_rec.
    unfold PS_minus, PS_scal, PS_incr_1.
    unfold plus, opp, scal; simpl; unfold mult; simpl.
    assert (Hi := pos_INR n).
    destruct n as [|n].
    * simpl. unfold zero; simpl. field.
    * unfold PS_derive. fold (INR (S n)).
      rewrite !S_INR in *. simpl coef. field. repeat split; generalize (pos_INR n); lra.
Qed.

Lemma s_init : s0 0 = A0 /\ s1 0 = A1 /\ s2 0 = A2.
Proof.
unfold s0, s1, s2. rewrite !PSeries_0. unfold PS_derive; simpl.
repeat split; field.
Qed.

End Exist.

Theorem Theta_exists (b : R) : exists theta, is_Theta b theta.
Proof.
set (A0 := Gamma (- b / 3) / (Rpower 3 ((3 + b) / 3) * Gamma (- b))).
set (A1 := Gamma ((1 - b) / 3) / (Rpower 3 ((2 + b) / 3) * Gamma (- b))).
set (A2 := Gamma ((2 - b) / 3) / (Rpower 3 ((1 + b) / 3) * Gamma (- b))).
destruct (s_init b A0 A1 A2) as (H0 & H1 & H2).
exists (PSeries (coef b A0 A1 A2)).
apply is_Theta_intro with (PSeries (PS_derive (coef b A0 A1 A2)))
  (PSeries (PS_derive (PS_derive (coef b A0 A1 A2)))); auto.
- apply s_derive0.
- apply s_derive1.
- apply s_derive2.
Qed.

(** Theta is its Taylor series, c_{k+3} = (k-b) c_k / ((k+1)(k+2)(k+3))
    (that is, the paper's combination of three 1F2's). *)
Theorem Theta_series (b : R) (theta : R -> R) : is_Theta b theta ->
  forall t, theta t =
  PSeries (coef b (theta 0) (Derive theta 0) (Derive_n theta 2 0)) t.
Proof.
intros H.
assert (H' := H). destruct H' as (_ & _ & I0 & I1 & I2).
set (A0 := theta 0) in *. set (A1 := Derive theta 0) in *. set (A2 := Derive_n theta 2 0) in *.
destruct (s_init b A0 A1 A2) as (H0 & H1 & H2).
apply (Theta_unique b _ _ H).
apply is_Theta_intro with (PSeries (PS_derive (coef b A0 A1 A2)))
  (PSeries (PS_derive (PS_derive (coef b A0 A1 A2)))).
- apply s_derive0.
- apply s_derive1.
- apply s_derive2.
- rewrite H0; exact I0.
- rewrite H1; exact I1.
- rewrite H2; exact I2.
Qed.
