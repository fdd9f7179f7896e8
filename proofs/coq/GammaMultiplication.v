(** * Gauss's multiplication formula, for three factors

    Gamma(x) Gamma(x + 1/3) Gamma(x + 2/3) = 2 pi 3^(1/2 - 3x) Gamma(3x), x > 0. The quotient Q(x) = 3^(3x) Gamma(x)
    Gamma(x + 1/3) Gamma(x + 2/3)/Gamma(3x) has the period 1/3; from k^a Gamma(k) k/(k + a) <= Gamma(k + a) <= k^a
    Gamma(k), 0 <= a <= 1 (convexity of u -> r^u), it is constant. Its value 3 Gamma(1/3) Gamma(2/3) = 2 pi sqrt 3: with
    A(x) = int_0^x e^(-r^3/3) dr, B(x) = int_0^x r e^(-r^3/3) dr and H(x) = int_0^1 e^(-x^3 (1 + u^3)/3)/(1 - u + u^2)
    du the sum AB + H is constant; it is int_0^1 du/(1 - u + u^2) = 2 pi/(3 sqrt 3) at x = 0, and at +oo 3^(-2/3)
    Gamma(1/3) 3^(-1/3) Gamma(2/3). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit GammaFunction ImproperIntegral.
Open Scope R_scope.

(** ** Gamma(k + a) *)

Lemma Gamma_upper k a : 0 < k -> 0 <= a <= 1 -> Gamma (k + a) <= Rpower k a * Gamma k.
Proof.
intros Hk Ha.
assert (G0 := Gamma_correct (k + a) ltac:(lra)). assert (G1 := Gamma_correct k Hk).
assert (G2 := Gamma_correct (k + 1) ltac:(lra)).
assert (P := is_RInt_gen_plus _ _ _ _ (is_RInt_gen_scal _ (Rpower k a * (1 - a)) _ G1)
  (is_RInt_gen_scal _ (Rpower k a * (a / k)) _ G2)).
enough (L : forall r, 0 < r -> Rpower r (k + a - 1) * exp (- r)
  <= plus (scal (Rpower k a * (1 - a)) (Rpower r (k - 1) * exp (- r)))
    (scal (Rpower k a * (a / k)) (Rpower r (k + 1 - 1) * exp (- r)))).
{ assert (E : Gamma (k + a) <= Rpower k a * (1 - a) * Gamma k + Rpower k a * (a / k) * Gamma (k + 1))
    by exact (improper_le _ _ _ _ L G0 P).
  rewrite (Gamma_rec k) in E by lra.
  replace (Rpower k a * (1 - a) * Gamma k + Rpower k a * (a / k) * (k * Gamma k)) with (Rpower k a * Gamma k) in E
    by (field; lra). exact E. }
intros r Hr. unfold plus, scal; simpl; unfold mult; simpl.
replace (k + a - 1) with (k - 1 + a) by ring. replace (k + 1 - 1) with (k - 1 + 1) by ring.
rewrite !Rpower_plus, Rpower_1 by auto.
set (U := Rpower r (k - 1)). assert (HU : 0 < U) by apply exp_pos. set (X := exp (- r)).
assert (HX : 0 < X) by apply exp_pos.
set (K := Rpower k a). assert (HK : 0 < K) by apply exp_pos.
(* (r/k)^a <= a r/k + (1 - a) *)
assert (C : Rpower r a <= K * (a * (r / k) + (1 - a))).
{ assert (E := exp_convex a (ln r - ln k) 0 Ha). rewrite exp_0 in E.
  replace (exp (ln r - ln k)) with (r / k) in E.
  2: { unfold Rminus. rewrite exp_plus, exp_Ropp, !exp_ln by auto. reflexivity. }
  unfold K, Rpower. replace (a * ln r) with (a * ln k + (a * (ln r - ln k) + (1 - a) * 0)) by ring. rewrite exp_plus.
  apply Rmult_le_compat_l. apply Rlt_le, exp_pos. lra. }
assert (0 < U * X) by (apply Rmult_lt_0_compat; auto).
replace (K * (1 - a) * (U * X) + K * (a / k) * (U * r * X)) with (U * X * (K * (a * (r / k) + (1 - a))))
  by (field; lra).
replace (U * Rpower r a * X) with (U * X * Rpower r a) by ring. apply Rmult_le_compat_l; lra.
Qed.

Lemma Gamma_lower k a : 0 < k -> 0 <= a <= 1 -> Rpower k a * Gamma k * (k / (k + a)) <= Gamma (k + a).
Proof.
intros Hk Ha.
assert (H := Gamma_upper (k + a) (1 - a) ltac:(lra) ltac:(lra)). replace (k + a + (1 - a)) with (k + 1) in H by ring.
rewrite Gamma_rec in H by lra.
assert (G := Gamma_pos k Hk). assert (Ga := Gamma_pos (k + a) ltac:(lra)).
assert (HK : 0 < Rpower k a) by apply exp_pos.
(* (k + a)^(1-a) k^a <= k + a *)
assert (C : Rpower (k + a) (1 - a) * Rpower k a <= k + a).
{ apply Rle_trans with (Rpower (k + a) (1 - a) * Rpower (k + a) a).
  - apply Rmult_le_compat_l. apply Rlt_le, exp_pos. apply Rle_Rpower_l; lra.
  - rewrite <- Rpower_plus. replace (1 - a + a) with 1 by ring. rewrite Rpower_1; lra. }
apply Rmult_le_reg_r with (k + a). lra.
replace (Rpower k a * Gamma k * (k / (k + a)) * (k + a)) with (Rpower k a * (k * Gamma k)) by (field; lra).
apply Rle_trans with (Rpower k a * (Rpower (k + a) (1 - a) * Gamma (k + a))).
- apply Rmult_le_compat_l; lra.
- replace (Rpower k a * (Rpower (k + a) (1 - a) * Gamma (k + a)))
    with (Gamma (k + a) * (Rpower (k + a) (1 - a) * Rpower k a)) by ring.
  apply Rmult_le_compat_l; lra.
Qed.

(** ** The quotient is constant *)

Definition quotient3 (x : R) : R := Rpower 3 (3 * x) * (Gamma x * Gamma (x + 1 / 3) * Gamma (x + 2 / 3)) / Gamma
  (3 * x).

Lemma quotient3_period x : 0 < x -> quotient3 (x + 1 / 3) = quotient3 x.
Proof.
intros Hx. unfold quotient3.
replace (x + 1 / 3 + 1 / 3) with (x + 2 / 3) by field. replace (x + 1 / 3 + 2 / 3) with (x + 1) by field.
replace (3 * (x + 1 / 3)) with (3 * x + 1) by field.
rewrite !Gamma_rec, Rpower_plus, Rpower_1 by lra. field. split. apply Rgt_not_eq, Gamma_pos; lra. lra.
Qed.

Lemma quotient3_shift x n : 0 < x -> quotient3 (x + INR n / 3) = quotient3 x.
Proof.
intros Hx. induction n as [|n IH].
- simpl. f_equal. field.
- rewrite S_INR. replace (x + (INR n + 1) / 3) with (x + INR n / 3 + 1 / 3) by field.
  rewrite quotient3_period; auto. assert (H := pos_INR n). lra.
Qed.

(** Plan: the quotient does not change when x grows by k ([quotient3_shift]). At x + k each of the four values of Gamma
    lies between n^a Gamma(n) n/(n + a) and n^a Gamma(n) ([Gamma_lower], [Gamma_upper]), n = k or 3k; the powers of n
    cancel (EX, EL), and of the factors n/(n + a) each is at least c = n/(n + 1). *)
Lemma quotient3_bounds x k : 0 < x <= 1 / 3 -> (1 <= k)%nat ->
  let L := Rpower 3 (3 * INR k) * Gamma (INR k) ^ 3 * INR k / Gamma (3 * INR k) in
  0 < L /\ L * (INR k / (INR k + 1)) ^ 3 <= quotient3 x <= L * ((INR k + 1) / INR k).
Proof.
intros Hx Hk L. apply (le_INR 1) in Hk. simpl in Hk. set (n := INR k) in *.
assert (Gk := Gamma_pos n ltac:(lra)). assert (G3 := Gamma_pos (3 * n) ltac:(lra)).
assert (HL : 0 < L).
{ unfold L. apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat. apply exp_pos.
  apply pow_lt, Gk. }
split; auto.
assert (E : quotient3 x = quotient3 (x + n)).
{ replace n with (INR (3 * k) / 3) by (rewrite mult_INR; simpl INR; unfold n; field). symmetry.
  apply quotient3_shift; lra. }
rewrite E. unfold quotient3.
replace (x + n + 1 / 3) with (n + (x + 1 / 3)) by ring. replace (x + n + 2 / 3) with (n + (x + 2 / 3)) by ring.
replace (x + n) with (n + x) by ring. replace (3 * (n + x)) with (3 * n + 3 * x) by ring.
assert (U1 := Gamma_upper n x ltac:(lra) ltac:(lra)). assert (L1 := Gamma_lower n x ltac:(lra) ltac:(lra)).
assert (U2 := Gamma_upper n (x + 1 / 3) ltac:(lra) ltac:(lra)).
assert (L2 := Gamma_lower n (x + 1 / 3) ltac:(lra) ltac:(lra)).
assert (U3 := Gamma_upper n (x + 2 / 3) ltac:(lra) ltac:(lra)).
assert (L3 := Gamma_lower n (x + 2 / 3) ltac:(lra) ltac:(lra)).
assert (U4 := Gamma_upper (3 * n) (3 * x) ltac:(lra) ltac:(lra)).
assert (L4 := Gamma_lower (3 * n) (3 * x) ltac:(lra) ltac:(lra)).
set (g1 := Gamma (n + x)) in *. set (g2 := Gamma (n + (x + 1 / 3))) in *. set (g3 := Gamma (n + (x + 2 / 3))) in *.
set (g4 := Gamma (3 * n + 3 * x)) in *.
assert (P1 : 0 < g1) by (apply Gamma_pos; lra). assert (P2 : 0 < g2) by (apply Gamma_pos; lra).
assert (P3 : 0 < g3) by (apply Gamma_pos; lra). assert (P4 : 0 < g4) by (apply Gamma_pos; lra).
set (c := n / (n + 1)). assert (Hc : 0 < c <= 1).
{ unfold c. split. apply Rdiv_lt_0_compat; lra. apply Rmult_le_reg_r with (n + 1). lra. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l by lra. lra. }
assert (Hlow : forall a, 0 <= a <= 1 -> c <= n / (n + a)).
{ intros a Ha. unfold c. apply Rmult_le_compat_l. lra. apply Rinv_le_contravar; lra. }
set (X1 := Rpower n x) in *. set (X2 := Rpower n (x + 1 / 3)) in *. set (X3 := Rpower n (x + 2 / 3)) in *.
set (X4 := Rpower (3 * n) (3 * x)) in *. set (G := Gamma n) in *. set (H3 := Gamma (3 * n)) in *.
assert (HX1 : 0 < X1) by apply exp_pos. assert (HX2 : 0 < X2) by apply exp_pos.
assert (HX3 : 0 < X3) by apply exp_pos. assert (HX4 : 0 < X4) by apply exp_pos.
assert (EX : X1 * X2 * X3 * Rpower 3 (3 * n + 3 * x) = Rpower 3 (3 * n) * n * X4).
{ unfold X1, X2, X3, X4. rewrite <- Rpower_mult_distr by lra. rewrite <- !Rpower_plus.
  replace (x + (x + 1 / 3) + (x + 2 / 3)) with (3 * x + 1) by field. rewrite !Rpower_plus, Rpower_1 by lra. ring. }
set (T := Rpower 3 (3 * n + 3 * x)) in *. assert (HT : 0 < T) by apply exp_pos.
assert (EL : L = T * (X1 * G * (X2 * G) * (X3 * G)) / (X4 * H3)).
{ unfold L. apply Rmult_eq_reg_r with (X4 * H3).
  2: { apply Rgt_not_eq, Rmult_lt_0_compat; auto. }
  replace (T * (X1 * G * (X2 * G) * (X3 * G)) / (X4 * H3) * (X4 * H3)) with (X1 * X2 * X3 * T * G ^ 3)
    by (field; split; lra).
  rewrite EX. field. lra. }
assert (Q1 : X1 * G * c <= g1).
{ eapply Rle_trans; [|exact L1]. apply Rmult_le_compat_l; [apply Rlt_le, Rmult_lt_0_compat; auto|apply Hlow; lra]. }
assert (Q2 : X2 * G * c <= g2).
{ eapply Rle_trans; [|exact L2]. apply Rmult_le_compat_l; [apply Rlt_le, Rmult_lt_0_compat; auto|apply Hlow; lra]. }
assert (Q3 : X3 * G * c <= g3).
{ eapply Rle_trans; [|exact L3]. apply Rmult_le_compat_l; [apply Rlt_le, Rmult_lt_0_compat; auto|apply Hlow; lra]. }
assert (Q4 : X4 * H3 * c <= g4).
{ eapply Rle_trans; [|exact L4]. apply Rmult_le_compat_l; [apply Rlt_le, Rmult_lt_0_compat; auto|].
  unfold c. apply Rmult_le_reg_r with ((n + 1) * (3 * n + 3 * x)). apply Rmult_lt_0_compat; lra.
  replace (n / (n + 1) * ((n + 1) * (3 * n + 3 * x))) with (n * (3 * n + 3 * x)) by (field; lra).
  replace (3 * n / (3 * n + 3 * x) * ((n + 1) * (3 * n + 3 * x))) with (n * (3 * n + 3)) by (field; lra).
  apply Rmult_le_compat_l; lra. }
assert (W1 : 0 < X1 * G) by (apply Rmult_lt_0_compat; auto).
assert (W2 : 0 < X2 * G) by (apply Rmult_lt_0_compat; auto).
assert (W3 : 0 < X3 * G) by (apply Rmult_lt_0_compat; auto).
assert (W4 : 0 < X4 * H3) by (apply Rmult_lt_0_compat; auto).
set (Y1 := X1 * G) in *. set (Y2 := X2 * G) in *. set (Y3 := X3 * G) in *. set (Y4 := X4 * H3) in *.
assert (B : Y1 * Y2 * Y3 * c ^ 3 <= g1 * g2 * g3 <= Y1 * Y2 * Y3).
{ assert (0 < Y1 * c) by (apply Rmult_lt_0_compat; lra). assert (0 < Y2 * c) by (apply Rmult_lt_0_compat; lra).
  assert (0 < Y3 * c) by (apply Rmult_lt_0_compat; lra).
  split.
  - replace (Y1 * Y2 * Y3 * c ^ 3) with (Y1 * c * (Y2 * c) * (Y3 * c)) by ring.
    apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra. apply Rmult_le_compat; lra.
  - apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra. apply Rmult_le_compat; lra. }
rewrite EL. split.
- apply Rmult_le_reg_r with (Y4 * g4). apply Rmult_lt_0_compat; auto.
  replace (T * (Y1 * Y2 * Y3) / Y4 * c ^ 3 * (Y4 * g4)) with (T * g4 * (Y1 * Y2 * Y3 * c ^ 3)) by (field; lra).
  replace (T * (g1 * g2 * g3) / g4 * (Y4 * g4)) with (T * Y4 * (g1 * g2 * g3)) by (field; lra).
  apply Rmult_le_compat; try lra.
  + apply Rlt_le, Rmult_lt_0_compat; auto.
  + apply Rmult_le_pos. apply Rlt_le. repeat apply Rmult_lt_0_compat; auto. apply pow_le; lra.
  + apply Rmult_le_compat_l; lra.
- replace ((n + 1) / n) with (/ c) by (unfold c; field; lra).
  apply Rmult_le_reg_r with (Y4 * c * g4).
  { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [exact W4|apply Hc]|exact P4]. }
  replace (T * (Y1 * Y2 * Y3) / Y4 * / c * (Y4 * c * g4)) with (T * g4 * (Y1 * Y2 * Y3)) by (field; lra).
  replace (T * (g1 * g2 * g3) / g4 * (Y4 * c * g4)) with (T * (Y4 * c) * (g1 * g2 * g3)) by (field; lra).
  apply Rmult_le_compat; try lra.
  + apply Rmult_le_pos. lra. apply Rmult_le_pos; lra.
  + apply Rlt_le. repeat apply Rmult_lt_0_compat; auto.
  + apply Rmult_le_compat_l; lra.
Qed.

Lemma quotient3_le x y : 0 < x <= 1 / 3 -> 0 < y <= 1 / 3 -> quotient3 x <= quotient3 y.
Proof.
intros Hx Hy. apply Rnot_lt_le. intros Hlt.
assert (Qy : 0 < quotient3 y).
{ unfold quotient3. apply Rdiv_lt_0_compat; [|apply Gamma_pos; lra]. apply Rmult_lt_0_compat. apply exp_pos.
  repeat apply Rmult_lt_0_compat; apply Gamma_pos; lra. }
set (d := quotient3 x - quotient3 y). assert (Hd : 0 < d) by (unfold d; lra).
destruct (nfloor_ex (15 * quotient3 y / d)) as [k [_ Hk]].
{ apply Rlt_le, Rdiv_lt_0_compat; lra. }
destruct (quotient3_bounds x (S k) Hx ltac:(lia)) as (HL & _ & Ux).
destruct (quotient3_bounds y (S k) Hy ltac:(lia)) as (_ & Ly & _).
rewrite <- S_INR in Hk. set (n := INR (S k)) in *. set (L := _ / Gamma (3 * n)) in *.
assert (Hn : 1 <= n) by (unfold n; rewrite S_INR; generalize (pos_INR k); lra).
set (u := / n). assert (Hu : 0 < u <= 1).
{ unfold u. split. apply Rinv_0_lt_compat; lra. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
assert (E1 : (n + 1) / n = 1 + u) by (unfold u; field; lra).
assert (E2 : n / (n + 1) = / (1 + u)) by (unfold u; field; lra).
rewrite E1 in Ux. rewrite E2 in Ly.
assert (A : L <= quotient3 y * (1 + u) ^ 3).
{ replace L with (L * (/ (1 + u)) ^ 3 * (1 + u) ^ 3) by (field; lra). apply Rmult_le_compat_r; auto.
  apply pow_le; lra. }
assert (B : quotient3 x <= quotient3 y * (1 + u) ^ 4).
{ eapply Rle_trans; [exact Ux|]. replace (quotient3 y * (1 + u) ^ 4) with (quotient3 y * (1 + u) ^ 3 * (1 + u)) by ring.
  apply Rmult_le_compat_r; lra. }
assert (C : (1 + u) ^ 4 <= 1 + 15 * u).
{ assert (P : forall v, 0 <= v <= u -> 0 <= u * v <= u).
  { intros v Hv. split. apply Rmult_le_pos; lra. rewrite <- (Rmult_1_r u) at 2. apply Rmult_le_compat_l; lra. }
  assert (P2 := P u ltac:(lra)). assert (P3 := P _ P2). assert (P4 := P _ P3).
  replace ((1 + u) ^ 4) with (1 + 4 * u + 6 * (u * u) + 4 * (u * (u * u)) + u * (u * (u * u))) by ring. lra. }
assert (D : quotient3 x <= quotient3 y * (1 + 15 * u)).
{ eapply Rle_trans; [exact B|]. apply Rmult_le_compat_l; lra. }
assert (F : 15 * quotient3 y * u < d).
{ apply Rmult_lt_reg_r with (n / d). apply Rdiv_lt_0_compat; lra.
  replace (15 * quotient3 y * u * (n / d)) with (15 * quotient3 y / d) by (unfold u; field; lra).
  replace (d * (n / d)) with n by (field; lra). exact Hk. }
unfold d in F. lra.
Qed.

Lemma quotient3_constant x : 0 < x -> quotient3 x = 3 * (Gamma (1 / 3) * Gamma (2 / 3)).
Proof.
intros Hx.
assert (B : quotient3 (1 / 3) = 3 * (Gamma (1 / 3) * Gamma (2 / 3))).
{ unfold quotient3. replace (3 * (1 / 3)) with 1 by field. replace (1 / 3 + 1 / 3) with (2 / 3) by field.
  replace (1 / 3 + 2 / 3) with 1 by field. rewrite Gamma_1, Rpower_1 by lra. field. }
assert (S : forall y, 0 < y <= 1 / 3 -> quotient3 y = quotient3 (1 / 3)).
{ intros y Hy. apply Rle_antisym; apply quotient3_le; lra. }
rewrite <- B.
destruct (archimed (- (3 * x))) as [H1 H2].
(* n with x - n/3 in (0, 1/3] *)
set (z := (- up (- (3 * x)))%Z).
assert (Ez : IZR z = - IZR (up (- (3 * x)))) by (unfold z; apply opp_IZR).
assert (Hz : (0 <= z)%Z).
{ assert ((-1 < z)%Z). { apply lt_IZR. lra. } lia. }
assert (En : INR (Z.to_nat z) = IZR z) by (rewrite INR_IZR_INZ, Z2Nat.id; auto).
rewrite <- (S (x - INR (Z.to_nat z) / 3)) by (rewrite En, Ez; lra).
rewrite <- (quotient3_shift (x - INR (Z.to_nat z) / 3) (Z.to_nat z)) by (rewrite En, Ez; lra).
f_equal. field.
Qed.

(** ** Gamma(1/3) Gamma(2/3) *)

Definition cube_integral (n : nat) (x : R) : R := RInt (fun r => r ^ n * exp (- (r ^ 3 / 3))) 0 x.

Lemma continuous_cube n r : continuous (fun r => r ^ n * exp (- (r ^ 3 / 3))) r.
Proof. apply (ex_derive_continuous (fun r => r ^ n * exp (- (r ^ 3 / 3))) r). auto_derive; auto. Qed.

Lemma ex_RInt_cube n a d : ex_RInt (fun r => r ^ n * exp (- (r ^ 3 / 3))) a d.
Proof. apply (ex_RInt_continuous (fun r => r ^ n * exp (- (r ^ 3 / 3)))). intros z _. apply continuous_cube. Qed.

Lemma cube_integral_derive n x : is_derive (cube_integral n) x (x ^ n * exp (- (x ^ 3 / 3))).
Proof.
apply (is_derive_RInt (fun r => r ^ n * exp (- (r ^ 3 / 3))) (cube_integral n) 0 x).
- exists (mkposreal 1 Rlt_0_1). intros y _. apply (RInt_correct (fun r => r ^ n * exp (- (r ^ 3 / 3)))), ex_RInt_cube.
- apply continuous_cube.
Qed.

Lemma cube_integral_lim n : is_lim (cube_integral n) p_infty (Rpower 3 ((INR n - 2) / 3) * Gamma ((INR n + 1) / 3)).
Proof.
set (C := Rpower 3 ((INR n - 2) / 3) * Gamma ((INR n + 1) / 3)).
apply is_lim_spec. intros eps. assert (He := cond_pos eps).
assert (Hn := pos_INR n).
assert (H := M0_lim (INR n) (Gamma ((INR n + 1) / 3)) (Gamma_is ((INR n + 1) / 3) ltac:(lra)) (pos_div_2 eps)).
destruct H as [Q S [d0 HQ] [m HS] H]. fold C in H.
set (a := Rmin 1 (Rmin (d0 / 2) (eps / 2)) / 2).
assert (Hd0 := cond_pos d0).
assert (Ha : 0 < a) by (unfold a; apply Rdiv_lt_0_compat; [|lra]; repeat apply Rmin_pos; lra).
assert (Ha1 : a < 1). { unfold a. assert (A := Rmin_l 1 (Rmin (d0 / 2) (eps / 2))). lra. }
assert (Ha2 : a < d0 /\ a < eps / 2).
{ unfold a. assert (A := Rmin_r 1 (Rmin (d0 / 2) (eps / 2))). assert (B1 := Rmin_l (d0 / 2) (eps / 2)).
  assert (B2 := Rmin_r (d0 / 2) (eps / 2)).
  assert (0 < Rmin 1 (Rmin (d0 / 2) (eps / 2))) by (repeat apply Rmin_pos; lra). lra. }
exists (Rmax m 1). intros x Hx.
assert (Hx1 : m < x) by (eapply Rle_lt_trans; [apply Rmax_l|exact Hx]).
assert (Hx2 : 1 < x) by (eapply Rle_lt_trans; [apply Rmax_r|exact Hx]).
assert (K : Rabs (M (INR n) a x 0 - C) < eps / 2).
{ apply (H a x). apply HQ; auto. apply Rabs_def1; unfold minus, plus, opp; simpl; lra. apply HS, Hx1. }
assert (EM : M (INR n) a x 0 = RInt (fun r => r ^ n * exp (- (r ^ 3 / 3))) a x).
{ unfold M. apply RInt_ext. intros r Hr. rewrite Rmin_left in Hr by lra.
  unfold kernel. rewrite Rpower_pow by lra. f_equal. f_equal. ring. }
assert (EC : cube_integral n x = RInt (fun r => r ^ n * exp (- (r ^ 3 / 3))) 0 a + M (INR n) a x 0).
{ rewrite EM. symmetry. apply (RInt_Chasles (fun r => r ^ n * exp (- (r ^ 3 / 3)))); apply ex_RInt_cube. }
assert (B : forall r, 0 < r < a -> 0 <= r ^ n * exp (- (r ^ 3 / 3)) <= 1).
{ intros r Hr. assert (0 < r ^ 3) by (apply pow_lt; lra).
  assert (P1 : 0 <= r ^ n <= 1). { split. apply pow_le; lra. rewrite <- (pow1 n). apply pow_incr. lra. }
  assert (P2 : 0 < exp (- (r ^ 3 / 3)) <= 1). { split. apply exp_pos. rewrite <- exp_0. apply exp_le. lra. }
  split. apply Rmult_le_pos; lra. rewrite <- (Rmult_1_l 1). apply Rmult_le_compat; lra. }
assert (B0 : 0 <= RInt (fun r => r ^ n * exp (- (r ^ 3 / 3))) 0 a).
{ apply RInt_ge_0. lra. apply ex_RInt_cube. intros; apply B; lra. }
assert (B1 : RInt (fun r => r ^ n * exp (- (r ^ 3 / 3))) 0 a <= a).
{ apply Rle_trans with (RInt (fun _ => 1) 0 a).
  - apply RInt_le. lra. apply ex_RInt_cube. apply ex_RInt_const. intros; apply B; lra.
  - rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. lra. }
rewrite EC. apply Rabs_def2 in K. apply Rabs_def1; lra.
Qed.

Definition tail_integrand (x u : R) : R := exp (- (x ^ 3 * (1 + u ^ 3) / 3)) / (1 - u + u ^ 2).

Lemma quadratic_pos u : 3 / 4 <= 1 - u + u ^ 2.
Proof. assert (0 <= (u - 1 / 2) ^ 2) by apply pow2_ge_0. lra. Qed.

Lemma tail_integrand_derive x u : is_derive (fun x => tail_integrand x u) x
  (- (x ^ 2 * ((1 + u) * exp (- (x ^ 3 * (1 + u ^ 3) / 3))))).
Proof.
assert (Q := quadratic_pos u). unfold tail_integrand. auto_derive. lra.
change (x * (x * (x * 1))) with (x ^ 3). change (u * (u * (u * 1))) with (u ^ 3). change (u * (u * 1)) with (u ^ 2).
replace (x ^ 3 * (1 + u ^ 3) * / 3) with (x ^ 3 * (1 + u ^ 3) / 3) by (unfold Rdiv; ring).
set (E := exp _). field_simplify_eq; [|lra]. simpl. ring.
Qed.

Lemma tail_derivative_continuous x u :
  continuity_2d_pt (fun x u => - (x ^ 2 * ((1 + u) * exp (- (x ^ 3 * (1 + u ^ 3) / 3))))) x u.
Proof.
apply continuity_2d_pt_filterlim.
change (continuous (fun z : R * R => - (fst z ^ 2 * ((1 + snd z) * exp (- (fst z ^ 3 * (1 + snd z ^ 3) / 3))))) (x, u)).
assert (F : forall f : R -> R, (forall y, ex_derive f y) -> continuous (fun z : R * R => f (fst z)) (x, u)).
{ intros f Hf. apply (continuous_comp fst f). apply continuous_fst. apply (ex_derive_continuous f), Hf. }
assert (S : forall f : R -> R, (forall y, ex_derive f y) -> continuous (fun z : R * R => f (snd z)) (x, u)).
{ intros f Hf. apply (continuous_comp snd f). apply continuous_snd. apply (ex_derive_continuous f), Hf. }
assert (P : forall f g : R * R -> R, continuous f (x, u) -> continuous g (x, u) -> continuous (fun z => f z * g z) (x,
  u)).
{ intros f g Hf Hg. apply (continuous_mult f g); auto. }
assert (G : forall (h : R -> R) (f : R * R -> R), (forall y, ex_derive h y) -> continuous f (x, u) ->
  continuous (fun z => h (f z)) (x, u)).
{ intros h f Hh Hf. apply (continuous_comp f h). exact Hf. apply (ex_derive_continuous h), Hh. }
apply (G (fun y => - y) (fun z => fst z ^ 2 * ((1 + snd z) * exp (- (fst z ^ 3 * (1 + snd z ^ 3) / 3))))).
{ intros y. auto_derive; auto. }
apply (P (fun z => fst z ^ 2) (fun z => (1 + snd z) * exp (- (fst z ^ 3 * (1 + snd z ^ 3) / 3)))).
{ apply (F (fun y => y ^ 2)). intros y. auto_derive; auto. }
apply (P (fun z => 1 + snd z) (fun z => exp (- (fst z ^ 3 * (1 + snd z ^ 3) / 3)))).
{ apply (S (fun y => 1 + y)). intros y. auto_derive; auto. }
apply (G (fun y => exp (- (y / 3))) (fun z => fst z ^ 3 * (1 + snd z ^ 3))).
{ intros y. auto_derive; auto. }
apply (P (fun z => fst z ^ 3) (fun z => 1 + snd z ^ 3)).
- apply (F (fun y => y ^ 3)). intros y. auto_derive; auto.
- apply (S (fun y => 1 + y ^ 3)). intros y. auto_derive; auto.
Qed.

Lemma ex_RInt_tail x : ex_RInt (tail_integrand x) 0 1.
Proof.
apply (ex_RInt_continuous (tail_integrand x)). intros u _.
apply (ex_derive_continuous (tail_integrand x) u). assert (Q := quadratic_pos u). unfold tail_integrand. auto_derive.
lra.
Qed.

(** The substitution r = x u. *)
Lemma cube_integral_scaled n x : 0 < x ->
  is_RInt (fun u => u ^ n * exp (- (x ^ 3 * u ^ 3 / 3))) 0 1 (cube_integral n x / x ^ S n).
Proof.
intros Hx.
assert (H := RInt_correct _ _ _ (ex_RInt_cube n 0 x)). fold (cube_integral n x) in H.
replace 0 with (x * 0 + 0) in H at 1 by ring. replace x with (x * 1 + 0) in H at 2 by ring.
apply (is_RInt_comp_lin _ x 0 0 1) in H.
apply (is_RInt_scal _ _ _ (/ x ^ S n)) in H.
replace (cube_integral n x / x ^ S n) with (scal (/ x ^ S n) (cube_integral n x)).
2: { unfold scal; simpl; unfold mult; simpl. unfold Rdiv. ring. }
eapply is_RInt_ext; [|exact H].
intros u _. unfold scal; simpl; unfold mult; simpl. rewrite Rplus_0_r. rewrite Rpow_mult_distr.
change (x * u * (x * u * (x * u * 1))) with ((x * u) ^ 3). rewrite Rpow_mult_distr.
change (x * (x * (x * 1))) with (x ^ 3). change (u * (u * (u * 1))) with (u ^ 3). field. split; [|lra].
apply pow_nonzero. lra.
Qed.

Lemma tail_derive x : 0 < x -> is_derive (fun x => RInt (tail_integrand x) 0 1) x
  (- (exp (- (x ^ 3 / 3)) * (x * cube_integral 0 x + cube_integral 1 x))).
Proof.
intros Hx.
assert (D : forall x u, Derive (fun x => tail_integrand x u) x =
  - (x ^ 2 * ((1 + u) * exp (- (x ^ 3 * (1 + u ^ 3) / 3))))).
{ intros. apply is_derive_unique, tail_integrand_derive. }
assert (H : is_derive (fun x => RInt (tail_integrand x) 0 1) x (RInt (fun u => Derive (fun x => tail_integrand x u) x)
  0 1)).
{ apply (is_derive_RInt_param tail_integrand 0 1 x).
  - exists (mkposreal 1 Rlt_0_1). intros y _ u _. eexists. apply tail_integrand_derive.
  - intros u _. eapply continuity_2d_pt_ext; [|apply (tail_derivative_continuous x u)]. intros. simpl. symmetry.
    apply D.
  - exists (mkposreal 1 Rlt_0_1). intros y _. apply ex_RInt_tail. }
replace (- (exp (- (x ^ 3 / 3)) * (x * cube_integral 0 x + cube_integral 1 x)))
  with (RInt (fun u => Derive (fun x => tail_integrand x u) x) 0 1); auto.
apply is_RInt_unique.
assert (I0 := cube_integral_scaled 0 x Hx). assert (I1 := cube_integral_scaled 1 x Hx).
assert (I := is_RInt_scal _ _ _ (- (x ^ 2 * exp (- (x ^ 3 / 3)))) _ (is_RInt_plus _ _ _ _ _ _ I0 I1)).
replace (- (exp (- (x ^ 3 / 3)) * (x * cube_integral 0 x + cube_integral 1 x)))
  with (scal (- (x ^ 2 * exp (- (x ^ 3 / 3)))) (plus (cube_integral 0 x / x ^ 1) (cube_integral 1 x / x ^ 2))).
2: { unfold scal, plus; simpl; unfold mult; simpl. field. lra. }
eapply is_RInt_ext; [|exact I]. intros u _. rewrite D.
unfold scal, plus; simpl; unfold mult; simpl.
change (x * (x * (x * 1))) with (x ^ 3). change (u * (u * (u * 1))) with (u ^ 3).
replace (- (x ^ 3 * (1 + u ^ 3) / 3)) with (- (x ^ 3 / 3) + - (x ^ 3 * u ^ 3 / 3)) by field. rewrite exp_plus. ring.
Qed.

Lemma sum_constant x : 0 < x -> cube_integral 0 x * cube_integral 1 x + RInt (tail_integrand x) 0 1 = RInt
  (tail_integrand 0) 0 1.
Proof.
intros Hx.
set (f := fun x => cube_integral 0 x * cube_integral 1 x + RInt (tail_integrand x) 0 1).
assert (D : forall y, 0 < y -> is_derive f y 0).
{ intros y Hy. unfold f.
  apply (is_derive_val _ _
    ((y ^ 0 * exp (- (y ^ 3 / 3)) * cube_integral 1 y + cube_integral 0 y * (y ^ 1 * exp (- (y ^ 3 / 3))))
    + (- (exp (- (y ^ 3 / 3)) * (y * cube_integral 0 y + cube_integral 1 y))))).
  - apply (is_derive_plus (fun x => cube_integral 0 x * cube_integral 1 x) (fun x => RInt (tail_integrand x) 0 1)).
    + apply is_derive_mult_R; apply cube_integral_derive.
    + apply tail_derive, Hy.
  - simpl. ring. }
assert (C : continuous f 0).
{ apply (continuous_plus (fun x => cube_integral 0 x * cube_integral 1 x) (fun x => RInt (tail_integrand x) 0 1)).
  - apply (ex_derive_continuous (fun x => cube_integral 0 x * cube_integral 1 x)). eexists.
    apply is_derive_mult_R; apply cube_integral_derive.
  - apply (ex_derive_continuous (fun x => RInt (tail_integrand x) 0 1)).
    eexists. apply (is_derive_RInt_param tail_integrand 0 1 0).
    + exists (mkposreal 1 Rlt_0_1). intros y _ u _. eexists. apply tail_integrand_derive.
    + intros u _. eapply continuity_2d_pt_ext; [|apply (tail_derivative_continuous 0 u)]. intros. simpl. symmetry.
      apply is_derive_unique, tail_integrand_derive.
    + exists (mkposreal 1 Rlt_0_1). intros y _. apply ex_RInt_tail. }
assert (E : f x = f 0).
{ destruct (MVT_gen f 0 x (fun _ => 0)) as (c & _ & E).
  - intros y Hy. rewrite Rmin_left in Hy by lra. apply D. lra.
  - intros y Hy. rewrite Rmin_left, Rmax_right in Hy by lra. apply continuity_pt_filterlim.
    destruct (Rle_lt_or_eq_dec 0 y (proj1 Hy)) as [H|<-]; [|exact C].
    apply (ex_derive_continuous f). exists 0. apply D, H.
  - lra. }
unfold f in E. rewrite E. unfold cube_integral at 1. rewrite RInt_point. unfold zero; simpl. ring.
Qed.

Lemma tail_at_0 : RInt (tail_integrand 0) 0 1 = 2 * PI / (3 * sqrt 3).
Proof.
assert (S3 : 0 < sqrt 3) by (apply sqrt_lt_R0; lra). assert (Q3 : sqrt 3 * sqrt 3 = 3) by (apply sqrt_sqrt; lra).
apply is_RInt_unique.
set (F := fun u => 2 / sqrt 3 * atan ((2 * u - 1) / sqrt 3)).
assert (D : forall u, is_derive F u (tail_integrand 0 u)).
{ intros u. assert (Q := quadratic_pos u). unfold F.
  assert (Z : 1 + ((2 * u - 1) / sqrt 3) ^ 2 = 4 / 3 * (1 - u + u ^ 2)).
  { replace (((2 * u - 1) / sqrt 3) ^ 2) with ((2 * u - 1) ^ 2 * / (sqrt 3 * sqrt 3)) by (field; lra). rewrite Q3.
    field. }
  apply (is_derive_val _ _ (2 / sqrt 3 * (2 / sqrt 3 * / (1 + ((2 * u - 1) / sqrt 3) ^ 2)))).
  - apply (is_derive_scal (fun u => atan ((2 * u - 1) / sqrt 3))).
    apply (is_derive_comp atan (fun u => (2 * u - 1) / sqrt 3) u (/ (1 + ((2 * u - 1) / sqrt 3) ^ 2)) (2 / sqrt 3)).
    + apply is_derive_Reals. exact (derivable_pt_lim_atan ((2 * u - 1) / sqrt 3)).
    + auto_derive; auto. field. lra.
  - rewrite Z. unfold tail_integrand. replace (- (0 ^ 3 * (1 + u ^ 3) / 3)) with 0 by (simpl; field). rewrite exp_0.
    replace (2 / sqrt 3 * (2 / sqrt 3 * / (4 / 3 * (1 - u + u ^ 2))))
      with (4 / (sqrt 3 * sqrt 3) * (3 / 4) * / (1 - u + u ^ 2)) by (field; split; lra).
    rewrite Q3. field. lra. }
replace (2 * PI / (3 * sqrt 3)) with (minus (F 1) (F 0)).
- apply (is_RInt_derive F (tail_integrand 0)). intros; apply D.
  intros u _. apply (ex_derive_continuous (tail_integrand 0) u). assert (Q := quadratic_pos u). unfold tail_integrand.
  auto_derive. lra.
- unfold minus, plus, opp; simpl. unfold F.
  replace ((2 * 1 - 1) / sqrt 3) with (tan (PI / 6)).
  2: { rewrite tan_PI6. field. lra. }
  replace ((2 * 0 - 1) / sqrt 3) with (tan (- (PI / 6))).
  2: { rewrite tan_neg, tan_PI6. field. lra. }
  assert (P := PI_RGT_0). rewrite !atan_tan by lra. field. lra.
Qed.

Lemma tail_lim : is_lim (fun x => RInt (tail_integrand x) 0 1) p_infty 0.
Proof.
apply (is_lim_le_le_loc (fun _ => 0) (fun x => 4 * / x ^ 3)).
- exists 1. intros x Hx. assert (H3 : 0 < x ^ 3) by (apply pow_lt; lra).
  assert (B : forall u, 0 < u < 1 -> 0 <= tail_integrand x u <= 4 * / x ^ 3).
  { intros u Hu. assert (Q := quadratic_pos u). unfold tail_integrand. split.
    - apply Rlt_le, Rdiv_lt_0_compat. apply exp_pos. lra.
    - assert (E : exp (- (x ^ 3 * (1 + u ^ 3) / 3)) <= 3 * / x ^ 3).
      { apply Rle_trans with (exp (- (x ^ 3 / 3))).
        - apply exp_le. assert (0 <= x ^ 3 * u ^ 3) by (apply Rmult_le_pos; [lra|apply pow_le; lra]). lra.
        - rewrite exp_Ropp. replace (3 * / x ^ 3) with (/ (x ^ 3 / 3)) by (field; lra). apply Rinv_le_contravar. lra.
          assert (A := exp_ineq1_le (x ^ 3 / 3)). lra. }
      unfold Rdiv. replace (4 * / x ^ 3) with (3 * / x ^ 3 * (4 / 3)) by (field; lra).
      apply Rmult_le_compat; [apply Rlt_le, exp_pos|apply Rlt_le, Rinv_0_lt_compat; lra|exact E|].
      replace (4 / 3) with (/ (3 / 4)) by field. apply Rinv_le_contravar; lra. }
  split.
  + apply RInt_ge_0. lra. apply ex_RInt_tail. intros; apply B; lra.
  + apply Rle_trans with (RInt (fun _ => 4 * / x ^ 3) 0 1).
    * apply RInt_le. lra. apply ex_RInt_tail. apply ex_RInt_const. intros; apply B; lra.
    * rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. lra.
- apply is_lim_const.
- replace (Finite 0) with (Rbar_mult 4 (Rbar_inv p_infty)) by (simpl; f_equal; ring).
  apply (is_lim_scal_l (fun x => / x ^ 3) 4 p_infty (Rbar_inv p_infty)). apply is_lim_inv; [|discriminate].
  apply (is_lim_ext (fun x => x * (x * (x * 1)))). reflexivity.
  replace p_infty with (Rbar_mult p_infty (Rbar_mult p_infty (Rbar_mult p_infty 1))) at 2.
  2: { simpl. destruct Rle_dec; [|lra]. destruct Rle_lt_or_eq_dec; [|lra]. reflexivity. }
  apply is_lim_mult. apply is_lim_id. apply is_lim_mult. apply is_lim_id. apply is_lim_mult. apply is_lim_id.
  apply is_lim_const.
  + simpl. lra.
  + simpl. destruct Rle_dec; [|lra]. destruct Rle_lt_or_eq_dec; [|lra]. exact I.
  + simpl. destruct Rle_dec; [|lra]. destruct Rle_lt_or_eq_dec; [|lra]. exact I.
Qed.

Theorem Gamma_thirds : Gamma (1 / 3) * Gamma (2 / 3) = 2 * PI / sqrt 3.
Proof.
assert (S3 : 0 < sqrt 3) by (apply sqrt_lt_R0; lra).
assert (L0 := cube_integral_lim 0). assert (L1 := cube_integral_lim 1). simpl INR in L0, L1.
replace ((0 + 1) / 3) with (1 / 3) in L0 by field. replace ((1 + 1) / 3) with (2 / 3) in L1 by field.
assert (L := is_lim_plus' _ _ _ _ _ (is_lim_mult _ _ _ _ _ L0 L1 I) tail_lim).
apply (is_lim_ext_loc _ (fun _ => RInt (tail_integrand 0) 0 1)) in L.
2: { exists 0. intros x Hx. apply sum_constant, Hx. }
assert (E := is_lim_unique _ _ _ L). rewrite Lim_const in E. simpl in E. injection E as E.
rewrite tail_at_0, Rplus_0_r in E.
replace (Rpower 3 ((0 - 2) / 3) * Gamma (1 / 3) * (Rpower 3 ((1 - 2) / 3) * Gamma (2 / 3)))
  with (Rpower 3 ((0 - 2) / 3) * Rpower 3 ((1 - 2) / 3) * (Gamma (1 / 3) * Gamma (2 / 3))) in E by ring.
rewrite <- Rpower_plus in E. replace ((0 - 2) / 3 + (1 - 2) / 3) with (- (1)) in E by field.
rewrite Rpower_Ropp, Rpower_1 in E by lra.
apply (Rmult_eq_compat_l 3) in E.
replace (3 * (/ 3 * (Gamma (1 / 3) * Gamma (2 / 3)))) with (Gamma (1 / 3) * Gamma (2 / 3)) in E by field.
rewrite <- E. field. lra.
Qed.

Theorem Gauss3 x : 0 < x -> Gamma x * Gamma (x + 1 / 3) * Gamma (x + 2 / 3) = 2 * PI * Rpower 3 (1 / 2 - 3 * x) * Gamma
  (3 * x).
Proof.
intros Hx. assert (Q := quotient3_constant x Hx). rewrite Gamma_thirds in Q. unfold quotient3 in Q.
assert (S3 : 0 < sqrt 3) by (apply sqrt_lt_R0; lra). assert (Q3 : sqrt 3 * sqrt 3 = 3) by (apply sqrt_sqrt; lra).
assert (E3 : Rpower 3 (1 / 2) = sqrt 3). { rewrite <- Rpower_sqrt by lra. f_equal. field. }
assert (G := Gamma_pos (3 * x) ltac:(lra)).
unfold Rminus. rewrite Rpower_plus, Rpower_Ropp, E3.
set (T := Rpower 3 (3 * x)) in *. assert (HT : 0 < T) by apply exp_pos.
set (g := Gamma (3 * x)) in *. set (w := Gamma x * _ * _) in *.
replace w with (T * w / g * (g / T)) by (field; lra). rewrite Q.
replace (3 * (2 * PI / sqrt 3) * (g / T)) with (sqrt 3 * sqrt 3 * (2 * PI / sqrt 3) * (g / T)) by (rewrite Q3; ring).
field. lra.
Qed.
