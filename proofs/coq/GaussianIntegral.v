(** * Gamma(1/2) = sqrt pi

    The square of int_0^x e^(-s^2) ds plus int_0^1 e^(-x^2 (1 + u^2))/(1 + u^2) du has the derivative 0: it is pi/4, the
    value of the second integral at x = 0. The second integral tends to 0, and the first to Gamma(1/2)/2. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus GammaFunction SaddleIntegral.
Open Scope R_scope.

Definition bell (s : R) : R := exp (- s ^ 2).

Lemma bell_ex a b : ex_RInt bell a b.
Proof. apply (ex_RInt_continuous bell). intros s _. apply (ex_derive_continuous bell). unfold bell. auto_derive.
auto. Qed.

Lemma bell_derive x : is_derive (fun x => RInt bell 0 x) x (bell x).
Proof.
apply (is_derive_RInt bell (fun x => RInt bell 0 x) 0 x).
- apply filter_forall. intros y. apply (RInt_correct bell), bell_ex.
- apply (ex_derive_continuous bell). unfold bell. auto_derive. auto.
Qed.

Definition square_tail (x u : R) : R := exp (- (x ^ 2 * (1 + u ^ 2))) / (1 + u ^ 2).

Definition square_slope (x u : R) : R := - (2 * x * exp (- (x ^ 2 * (1 + u ^ 2)))).

Lemma square_above_1 u : 1 <= 1 + u ^ 2.
Proof. assert (H := pow2_ge_0 u). lra. Qed.

Lemma square_tail_derive x u : is_derive (fun x => square_tail x u) x (square_slope x u).
Proof.
assert (Q := square_above_1 u). unfold square_tail, square_slope. auto_derive. simpl in *; lra.
change (x * (x * 1)) with (x ^ 2). change (u * (u * 1)) with (u ^ 2). field. lra.
Qed.

Lemma square_slope_continuous x u : continuity_2d_pt square_slope x u.
Proof.
apply continuity_2d_pt_filterlim. unfold square_slope.
change (continuous (fun z : R * R => - (2 * fst z * exp (- (fst z ^ 2 * (1 + snd z ^ 2))))) (x, u)).
assert (P : forall f g : R * R -> R, continuous f (x, u) -> continuous g (x, u) -> continuous (fun z => f z * g z)
  (x, u)) by (intros f g Hf Hg; apply (continuous_mult f g); auto).
assert (G : forall (h : R -> R) (f : R * R -> R), (forall y, ex_derive h y) -> continuous f (x, u) ->
  continuous (fun z => h (f z)) (x, u)).
{ intros h f Hh Hf. apply (continuous_comp f h). exact Hf. apply (ex_derive_continuous h), Hh. }
assert (F := continuous_fst (U := R_UniformSpace) (V := R_UniformSpace) x u).
assert (S := continuous_snd (U := R_UniformSpace) (V := R_UniformSpace) x u).
apply (G (fun y => - y)). { intros y. auto_derive; auto. }
apply (P (fun z => 2 * fst z)). { apply (G (fun y => 2 * y)); auto. intros y. auto_derive; auto. }
apply (G (fun y => exp (- y)) (fun z => fst z ^ 2 * (1 + snd z ^ 2))). { intros y. auto_derive; auto. }
apply (P (fun z => fst z ^ 2) (fun z => 1 + snd z ^ 2)).
- apply (G (fun y => y ^ 2)); auto. intros y. auto_derive; auto.
- apply (G (fun y => 1 + y ^ 2)); auto. intros y. auto_derive; auto.
Qed.

Lemma square_tail_ex x : ex_RInt (square_tail x) 0 1.
Proof.
apply (ex_RInt_continuous (square_tail x)). intros u _. apply (ex_derive_continuous (square_tail x)).
assert (Q := square_above_1 u). unfold square_tail. auto_derive. simpl in *; lra.
Qed.

Lemma square_tail_integral x :
  is_derive (fun x => RInt (square_tail x) 0 1) x (- (2 * bell x * RInt bell 0 x)).
Proof.
assert (D : forall x u, Derive (fun x => square_tail x u) x = square_slope x u)
  by (intros; apply is_derive_unique, square_tail_derive).
assert (H : is_derive (fun x => RInt (square_tail x) 0 1) x (RInt (fun u => Derive (fun x => square_tail x u) x) 0 1)).
{ apply (is_derive_RInt_param square_tail 0 1 x).
  - exists (mkposreal 1 Rlt_0_1). intros y _ u _. eexists. apply square_tail_derive.
  - intros u _. eapply continuity_2d_pt_ext; [|apply (square_slope_continuous x u)]. intros. simpl. symmetry. apply D.
  - exists (mkposreal 1 Rlt_0_1). intros y _. apply square_tail_ex. }
replace (- (2 * bell x * RInt bell 0 x)) with (RInt (fun u => Derive (fun x => square_tail x u) x) 0 1); auto.
apply is_RInt_unique.
assert (I : is_RInt bell (x * 0 + 0) (x * 1 + 0) (RInt bell 0 x)).
{ rewrite Rmult_0_r, Rmult_1_r, !Rplus_0_r. apply (RInt_correct bell), bell_ex. }
apply (is_RInt_comp_lin bell x 0 0 1) in I. apply (is_RInt_scal _ _ _ (- (2 * bell x))) in I.
replace (- (2 * bell x * RInt bell 0 x)) with (scal (- (2 * bell x)) (RInt bell 0 x))
  by (unfold scal; simpl; unfold mult; simpl; ring).
eapply is_RInt_ext; [|exact I]. intros u _. rewrite D.
change (- (2 * bell x) * (x * bell (x * u + 0)) = square_slope x u). unfold bell, square_slope.
replace (- (x ^ 2 * (1 + u ^ 2))) with (- x ^ 2 + - (x * u + 0) ^ 2) by ring. rewrite exp_plus. ring.
Qed.

Lemma square_tail_at_0 : RInt (square_tail 0) 0 1 = PI / 4.
Proof.
rewrite (RInt_ext _ (fun u => / (1 + u ^ 2))).
- apply is_RInt_unique. replace (PI / 4) with (minus (atan 1) (atan 0)).
  2: { rewrite atan_0, atan_1. unfold minus, plus, opp; simpl. lra. }
  apply (is_RInt_derive atan (fun u => / (1 + u ^ 2))).
  + intros u _. apply is_derive_Reals, derivable_pt_lim_atan.
  + intros u _. apply (ex_derive_continuous (fun u => / (1 + u ^ 2))). assert (Q := square_above_1 u).
    auto_derive. simpl in *; lra.
- intros u _. unfold square_tail. replace (- (0 ^ 2 * (1 + u ^ 2))) with 0 by ring. rewrite exp_0. apply Rmult_1_l.
Qed.

Lemma squares_constant x : 0 <= x -> RInt bell 0 x ^ 2 + RInt (square_tail x) 0 1 = PI / 4.
Proof.
intros Hx. set (f := fun x => RInt bell 0 x * RInt bell 0 x + RInt (square_tail x) 0 1).
assert (D : forall y, is_derive f y 0).
{ intros y. apply (is_derive_val _ _ ((bell y * RInt bell 0 y + RInt bell 0 y * bell y)
    + - (2 * bell y * RInt bell 0 y))); [|ring].
  apply (is_derive_plus (fun x => RInt bell 0 x * RInt bell 0 x) (fun x => RInt (square_tail x) 0 1)).
  apply is_derive_mult_R; apply bell_derive. apply square_tail_integral. }
assert (E : f x = f 0).
{ destruct (Rle_lt_or_eq_dec _ _ Hx) as [H|H]; [|rewrite H; reflexivity].
  destruct (mvt_open f (fun _ => 0) 0 x H (fun y _ => D y)) as (c & _ & E). lra. }
unfold f in E. rewrite RInt_point, square_tail_at_0 in E. unfold zero in E; simpl in E. simpl. lra.
Qed.

Lemma square_tail_bounds x : 1 <= x -> 0 <= RInt (square_tail x) 0 1 <= / x.
Proof.
intros Hx.
assert (B : forall u, 0 < u < 1 -> 0 <= square_tail x u <= / x).
{ intros u Hu. assert (Q := square_above_1 u). unfold square_tail. split.
  - apply Rlt_le, Rdiv_lt_0_compat. apply exp_pos. lra.
  - apply Rle_trans with (/ x * 1); [|lra]. apply Rmult_le_compat.
    + apply Rlt_le, exp_pos.
    + apply Rlt_le, Rinv_0_lt_compat; lra.
    + rewrite exp_Ropp. apply Rinv_le_contravar; [lra|]. assert (E := exp_ineq1_le (x ^ 2 * (1 + u ^ 2))).
      assert (x * x <= x ^ 2 * (1 + u ^ 2)) by (simpl in *; nra). nra.
    + rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
split.
- apply RInt_ge_0; [lra|apply square_tail_ex|]. intros u Hu. apply B, Hu.
- replace (/ x) with (RInt (fun _ => / x) 0 1).
  + apply RInt_le; [lra|apply square_tail_ex|apply ex_RInt_const|]. intros u Hu. apply B, Hu.
  + rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. ring.
Qed.

Theorem Gamma_half : Gamma (1 / 2) = sqrt PI.
Proof.
assert (P := PI_RGT_0).
assert (W : gauss_whole 1 0 = Gamma (1 / 2)).
{ unfold gauss_whole. simpl INR. rewrite Rplus_0_l. unfold Rpower. rewrite ln_1, Rmult_0_r, exp_0. ring. }
assert (E : forall x, RInt (gauss 1 (2 * 0)) 0 x = RInt bell 0 x).
{ intros x. apply RInt_ext. intros s _. unfold gauss, bell. simpl. rewrite !Rmult_1_l. reflexivity. }
assert (G : 0 < Gamma (1 / 2)) by (apply Gamma_pos; lra).
assert (B : forall x, 1 <= x -> 0 <= 2 * RInt bell 0 x <= Gamma (1 / 2) /\ Gamma (1 / 2) <= 2 * RInt bell 0 x + 2 / x).
{ intros x Hx.
  assert (I := gauss_inside 1 Rlt_0_1 0 x ltac:(lra)).
  assert (O := gauss_outside 1 Rlt_0_1 0 x ltac:(lra) ltac:(simpl; nra)). rewrite W, E in *.
  assert (N : 0 <= RInt bell 0 x) by (apply RInt_ge_0; [lra|apply bell_ex|]; intros; apply Rlt_le, exp_pos).
  assert (X : exp (- (1 * x ^ 2)) <= 1) by (rewrite <- exp_0 at 2; apply exp_le; simpl; nra).
  replace (x ^ (2 * 0)) with 1 in O by reflexivity.
  assert (1 / x * exp (- (1 * x ^ 2)) / 1 <= 1 / x).
  { rewrite Rdiv_1. rewrite <- (Rmult_1_r (1 / x)) at 2. apply Rmult_le_compat_l; auto.
    apply Rlt_le, Rdiv_lt_0_compat; lra. }
  unfold Rdiv in *. split; lra. }
assert (Sq : forall x, 1 <= x -> Rabs (Gamma (1 / 2) ^ 2 - PI) <= (4 + 4 * Gamma (1 / 2)) / x).
{ intros x Hx. assert (C := squares_constant x ltac:(lra)). assert (T := square_tail_bounds x Hx).
  destruct (B x Hx) as [B1 B2]. set (i := RInt bell 0 x) in *. assert (Q : 0 < / x) by (apply Rinv_0_lt_compat; lra).
  unfold Rdiv in *. assert (D : 0 <= Gamma (1 * / 2) - 2 * i <= 2 * / x) by lra.
  set (g := Gamma (1 * / 2)) in *.
  replace (g ^ 2 - PI) with ((g - 2 * i) * (g + 2 * i) - 4 * RInt (square_tail x) 0 1) by (simpl in *; lra).
  assert (Y : 0 <= (g - 2 * i) * (g + 2 * i) <= 2 * / x * (2 * g)).
  { split. apply Rmult_le_pos; lra. apply Rmult_le_compat; lra. }
  apply Rabs_le. lra. }
assert (Eq : Gamma (1 / 2) ^ 2 = PI).
{ apply Rminus_diag_uniq, Rabs_eq_0, Rle_antisym; [|apply Rabs_pos]. apply le_epsilon. intros eps He.
  rewrite Rplus_0_l. set (x := Rmax 1 ((4 + 4 * Gamma (1 / 2)) / eps)).
  assert (X1 : 1 <= x) by apply Rmax_l. assert (X2 : (4 + 4 * Gamma (1 / 2)) / eps <= x) by apply Rmax_r.
  eapply Rle_trans; [apply (Sq x X1)|]. apply Rmult_le_reg_r with x; [lra|]. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  apply (Rmult_le_compat_l eps) in X2; [|lra].
  replace (eps * ((4 + 4 * Gamma (1 / 2)) / eps)) with (4 + 4 * Gamma (1 / 2)) in X2 by (field; lra).
  exact X2. }
rewrite <- Eq. symmetry. apply sqrt_pow2. lra.
Qed.
