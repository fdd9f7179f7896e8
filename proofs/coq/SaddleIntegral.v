(** * The saddle: the integral of (1 + u)^c e^(-lambda s^2) with an explicit remainder

    E_1 to E_4 of proofs/positive.md. In the middle, |s| <= sigma, the series of (1 + u)^c du/ds is cut off after 2N
    terms; only even powers of s count, and each is completed to a value of Gamma. On the right the integrand is below
    an explicit derivative, on the left it is below a constant. All integrals are over segments, and the substitution s
    = s(u) is made in polynomials times e^(-lambda s^2) only. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit GammaFunction PowerSeriesNorm NormLimit
  BinomialSeries SaddleInverse.
Open Scope R_scope.

(** ** Integrals over segments *)

Lemma integral_below (l : R) (f F F' : R -> R) a b : l < a -> a <= b -> (forall x, l < x -> continuous f x) ->
  (forall x, a <= x <= b -> is_derive F x (F' x)) -> (forall x, a <= x <= b -> f x <= F' x) ->
  RInt f a b <= F b - F a.
Proof.
intros Hl Hab Hc HF Hf.
assert (H : RInt f a b - F b <= RInt f a a - F a).
{ apply (decr_of_derive (fun x => RInt f a x - F x) (fun x => f x - F' x) a b Hab).
  - intros x Hx. apply (is_derive_minus (fun x => RInt f a x) F); [|apply HF, Hx].
    apply (is_derive_RInt f (fun x => RInt f a x) a x); [|apply Hc; lra].
    exists (mkposreal (x - l) ltac:(lra)). intros y Hy.
    change (Rabs (y - x) < x - l) in Hy. apply Rabs_lt_between in Hy.
    apply (RInt_correct f), (ex_RInt_continuous f). intros z Hz. apply Hc.
    revert Hz. unfold Rmin, Rmax. destruct Rle_dec; lra.
  - intros x Hx. specialize (Hf x Hx). lra. }
rewrite RInt_point in H. unfold zero in H; simpl in H. lra.
Qed.

Lemma fold_integral (f : R -> R) d : 0 <= d -> (forall x, continuous f x) ->
  RInt f (- d) d = RInt (fun x => f x + f (- x)) 0 d.
Proof.
intros Hd Hc.
assert (Ex : forall a b, ex_RInt f a b) by (intros; apply (ex_RInt_continuous f); auto).
assert (L : is_RInt (fun x => - f (- x)) d 0 (RInt f (- d) 0)).
{ apply (is_RInt_comp_opp f). rewrite Ropp_0. apply (RInt_correct f), Ex. }
apply is_RInt_swap in L. apply is_RInt_opp in L. rewrite opp_opp in L.
assert (R := RInt_correct f 0 d (Ex 0 d)).
assert (S := is_RInt_plus _ _ _ _ _ _ R L).
rewrite <- (RInt_Chasles f (- d) 0 d) by apply Ex.
symmetry. apply is_RInt_unique. rewrite plus_comm.
eapply is_RInt_ext; [|exact S]. intros x _. unfold plus, opp; simpl. ring.
Qed.

(** ** s^n e^(-lambda s^2) *)

Section Gaussian.
Variable lambda : R.
Hypothesis Hl : 0 < lambda.

Definition gauss (n : nat) (s : R) : R := s ^ n * exp (- (lambda * s ^ 2)).

Lemma gauss_continuous n s : continuous (gauss n) s.
Proof. apply (ex_derive_continuous (gauss n) s). unfold gauss. auto_derive. auto. Qed.

Lemma gauss_ex n a b : ex_RInt (gauss n) a b.
Proof. apply (ex_RInt_continuous (gauss n)). intros; apply gauss_continuous. Qed.

Lemma gauss_even k s : gauss (2 * k) (- s) = gauss (2 * k) s.
Proof.
unfold gauss. replace ((- s) ^ 2) with (s ^ 2) by ring. f_equal. rewrite !pow_mult. f_equal. ring.
Qed.

Lemma gauss_nonneg k s : 0 <= gauss (2 * k) s.
Proof. apply Rmult_le_pos; [|apply Rlt_le, exp_pos]. rewrite pow_mult. apply pow_le, pow2_ge_0. Qed.

Lemma gauss_substitution k a d : 0 < a -> a <= d ->
  RInt (gamma_integrand (INR k + 1 / 2)) (lambda * a ^ 2) (lambda * d ^ 2)
    = Rpower lambda (INR k + 1 / 2) * (2 * RInt (gauss (2 * k)) a d).
Proof.
intros Ha Hd.
assert (H : is_RInt (fun s => scal (2 * lambda * s) (gamma_integrand (INR k + 1 / 2) (lambda * s ^ 2))) a d
  (RInt (gamma_integrand (INR k + 1 / 2)) (lambda * a ^ 2) (lambda * d ^ 2))).
{ apply (is_RInt_comp (gamma_integrand (INR k + 1 / 2)) (fun s => lambda * s ^ 2) (fun s => 2 * lambda * s)).
  - intros x Hx. rewrite Rmin_left in Hx by lra. apply continuous_gamma_integrand.
    apply Rmult_lt_0_compat; auto. apply pow_lt. lra.
  - intros x Hx. split. auto_derive; auto. ring. apply (ex_derive_continuous (fun s => 2 * lambda * s)).
    auto_derive; auto. }
apply (is_RInt_unique (V := R_CompleteNormedModule)) in H. rewrite <- H.
assert (G := is_RInt_scal _ _ _ (Rpower lambda (INR k + 1 / 2) * 2) _ (RInt_correct _ _ _ (gauss_ex (2 * k) a d))).
rewrite <- Rmult_assoc. apply (is_RInt_unique (V := R_CompleteNormedModule)). eapply is_RInt_ext; [|exact G].
- intros s Hs. rewrite Rmin_left in Hs by lra. assert (S : 0 < s) by lra. symmetry.
  change (2 * lambda * s * (Rpower (lambda * s ^ 2) (INR k + 1 / 2 - 1) * exp (- (lambda * s ^ 2)))
    = Rpower lambda (INR k + 1 / 2) * 2 * (s ^ (2 * k) * exp (- (lambda * s ^ 2)))).
  rewrite <- (Rpower_mult_distr lambda (s ^ 2)); [|lra|apply pow_lt, S].
  replace (INR k + 1 / 2 - 1) with (INR k + 1 / 2 + - (1)) by ring.
  rewrite (Rpower_plus _ _ lambda), Rpower_Ropp, Rpower_1 by lra.
  replace (Rpower (s ^ 2) (INR k + 1 / 2 + - (1))) with (s ^ (2 * k) * / s).
  + field. lra.
  + rewrite <- (Rpower_pow 2 s), <- (Rpower_pow (2 * k) s), Rpower_mult by lra.
    rewrite <- (Rpower_1 s) at 2 by lra. rewrite <- Rpower_Ropp, <- Rpower_plus. f_equal. rewrite mult_INR. simpl.
    field.
Qed.

Definition gauss_whole (k : nat) : R := Gamma (INR k + 1 / 2) * Rpower lambda (- (INR k + 1 / 2)).

Lemma gauss_near k eps s : 0 < eps -> 0 < s -> exists a d, 0 < a /\ a < eps /\ a < s /\ a < 1 /\ s < d /\
  Rabs (2 * RInt (gauss (2 * k)) a d - gauss_whole k) < eps.
Proof.
intros He Hs. set (L := Rpower lambda (INR k + 1 / 2)). assert (PL : 0 < L) by apply exp_pos.
assert (HG := Gamma_is (INR k + 1 / 2) ltac:(generalize (pos_INR k); lra)).
unfold is_GammaInt, is_RInt_gen in HG.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))) in HG.
assert (HeL : 0 < eps * L) by (apply Rmult_lt_0_compat; lra).
specialize (HG (mkposreal _ HeL)). destruct HG as [Q S [e HQ] [m HS] HQS].
assert (Pe := cond_pos e).
set (a := Rmin (Rmin (s / 2) (eps / 2)) (Rmin (1 / 2) (e / (2 * (lambda + 1))))).
set (d := Rmax (Rmax 1 (2 * s)) ((Rabs m + 1) / lambda)).
assert (A1 : a <= Rmin (s / 2) (eps / 2)) by apply Rmin_l.
assert (A2 : a <= Rmin (1 / 2) (e / (2 * (lambda + 1)))) by apply Rmin_r.
assert (A3 := Rmin_l (s / 2) (eps / 2)). assert (A4 := Rmin_r (s / 2) (eps / 2)).
assert (A5 := Rmin_l (1 / 2) (e / (2 * (lambda + 1)))). assert (A6 := Rmin_r (1 / 2) (e / (2 * (lambda + 1)))).
assert (Ha : 0 < a). { repeat apply Rmin_pos; try lra. apply Rdiv_lt_0_compat; lra. }
assert (D1 : Rmax 1 (2 * s) <= d) by apply Rmax_l. assert (D2 : (Rabs m + 1) / lambda <= d) by apply Rmax_r.
assert (D3 := Rmax_l 1 (2 * s)). assert (D4 := Rmax_r 1 (2 * s)).
exists a, d. repeat split; try lra.
destruct (HQS (lambda * a ^ 2) (lambda * d ^ 2)) as [z [Hz1 Hz2]].
- assert (P : 0 < lambda * a ^ 2) by (apply Rmult_lt_0_compat; auto; apply pow_lt, Ha).
  apply HQ; auto. change (Rabs (lambda * a ^ 2 - 0) < e). rewrite Rminus_0_r, Rabs_pos_eq by lra.
  assert (E : (2 * (lambda + 1)) * (e / (2 * (lambda + 1))) = e) by (field; lra).
  assert ((2 * (lambda + 1)) * a <= e) by (rewrite <- E; apply Rmult_le_compat_l; lra).
  assert (a ^ 2 <= a * 1) by (replace (a ^ 2) with (a * a) by ring; apply Rmult_le_compat_l; lra).
  assert (lambda * a ^ 2 <= lambda * (a * 1)) by (apply Rmult_le_compat_l; lra). nra.
- apply HS. apply Rlt_le_trans with (lambda * d).
  + apply (Rmult_le_compat_l lambda) in D2; [|lra].
    replace (lambda * ((Rabs m + 1) / lambda)) with (Rabs m + 1) in D2 by (field; lra). generalize (Rle_abs m). lra.
  + apply Rmult_le_compat_l; [lra|]. replace (d ^ 2) with (d * d) by ring. nra.
- cbn [fst snd] in Hz1. apply (is_RInt_unique (V := R_CompleteNormedModule)) in Hz1.
  rewrite gauss_substitution in Hz1 by lra. fold L in Hz1. subst z.
  change (Rabs (L * (2 * RInt (gauss (2 * k)) a d) - Gamma (INR k + 1 / 2)) < eps * L) in Hz2.
  unfold gauss_whole. rewrite Rpower_Ropp. fold L.
  apply Rmult_lt_reg_r with L; auto. rewrite <- (Rabs_pos_eq L) at 2 by lra. rewrite <- Rabs_mult.
  replace ((2 * RInt (gauss (2 * k)) a d - Gamma (INR k + 1 / 2) * / L) * L)
    with (L * (2 * RInt (gauss (2 * k)) a d) - Gamma (INR k + 1 / 2)) by (field; lra). exact Hz2.
Qed.

Lemma gauss_small k a : 0 <= a <= 1 -> RInt (gauss (2 * k)) 0 a <= a.
Proof.
intros Ha. replace a with (RInt (fun _ => 1) 0 a) at 2 by (rewrite RInt_const; unfold scal; simpl; unfold mult;
  simpl; ring).
apply RInt_le; [lra|apply gauss_ex|apply ex_RInt_const|]. intros s Hs. unfold gauss.
rewrite <- (Rmult_1_r 1). apply Rmult_le_compat. apply pow_le; lra. apply Rlt_le, exp_pos.
rewrite <- (pow1 (2 * k)). apply pow_incr; lra. rewrite <- exp_0. apply exp_le.
assert (0 <= lambda * s ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra.
Qed.

Lemma gauss_inside k s : 0 < s -> 2 * RInt (gauss (2 * k)) 0 s <= gauss_whole k.
Proof.
intros Hs. apply le_epsilon. intros eps He.
destruct (gauss_near k (eps / 4) s ltac:(lra) Hs) as (a & d & H1 & H2 & H3 & H4 & H5 & H6).
assert (B := gauss_small k a ltac:(lra)). apply Rabs_def2 in H6.
assert (E1 := RInt_Chasles (gauss (2 * k)) 0 a s (gauss_ex _ _ _) (gauss_ex _ _ _)).
assert (E2 := RInt_Chasles (gauss (2 * k)) a s d (gauss_ex _ _ _) (gauss_ex _ _ _)).
assert (P : 0 <= RInt (gauss (2 * k)) s d).
{ apply RInt_ge_0; [lra|apply gauss_ex|]. intros; apply gauss_nonneg. }
unfold plus in E1, E2; simpl in E1, E2. simpl in *. lra.
Qed.

Lemma gauss_beyond k s d : 0 < s -> s <= d -> INR (2 * k) - 1 <= lambda * s ^ 2 ->
  RInt (gauss (2 * k)) s d <= s ^ (2 * k) / s * exp (- (lambda * s ^ 2)) / lambda.
Proof.
intros Hs Hd Hk. set (F := fun x => - (x ^ (2 * k) / x * exp (- (lambda * x ^ 2)) / lambda)).
set (F' := fun x => (2 * x ^ (2 * k) - (INR (2 * k) - 1) * (x ^ (2 * k) / (x * x)) / lambda)
  * exp (- (lambda * x ^ 2))).
assert (H : RInt (gauss (2 * k)) s d <= F d - F s).
{ apply (integral_below 0 (gauss (2 * k)) F F'); auto.
  - intros; apply gauss_continuous.
  - intros x Hx. unfold F, F'. auto_derive. repeat split; lra.
    replace (x * (x * 1)) with (x ^ 2) by ring. simpl (INR 2).
    assert (E : INR (k + (k + 0)) * x ^ Init.Nat.pred (k + (k + 0)) = INR (2 * k) * x ^ (2 * k) / x).
    { change (k + (k + 0))%nat with (2 * k)%nat. destruct (2 * k)%nat as [|j]; simpl; [unfold Rdiv; ring|field; lra]. }
    change (k + (k + 0))%nat with (2 * k)%nat in *. rewrite <- !Rmult_assoc.
    set (ex := exp (- (lambda * x ^ 2))).
    match goal with |- ?l = ?r => replace l with (- (((INR (2 * k) * x ^ pred (2 * k)) / x - x ^ (2 * k) / (x * x)) * ex
      + x ^ (2 * k) / x * (- (2 * lambda * x) * ex)) / lambda) end.
    + rewrite E. field. lra.
    + field. lra.
  - intros x Hx. unfold gauss, F'. apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|].
    assert (P : 0 <= x ^ (2 * k)) by (apply pow_le; lra).
    assert (Q : (INR (2 * k) - 1) * (x ^ (2 * k) / (x * x)) / lambda <= x ^ (2 * k)); [|lra].
    apply Rmult_le_reg_r with (lambda * (x * x)); [repeat apply Rmult_lt_0_compat; lra|].
    replace ((INR (2 * k) - 1) * (x ^ (2 * k) / (x * x)) / lambda * (lambda * (x * x)))
      with (x ^ (2 * k) * (INR (2 * k) - 1)) by (field; lra).
    apply Rmult_le_compat_l; auto. eapply Rle_trans; [exact Hk|]. apply Rmult_le_compat_l; [lra|].
    replace (s ^ 2) with (s * s) by ring. nra. }
assert (P : F d <= 0).
{ unfold F. assert (0 <= d ^ (2 * k) / d * exp (- (lambda * d ^ 2)) / lambda); [|lra].
  apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat; lra]. apply Rmult_le_pos; [|apply Rlt_le, exp_pos].
  apply Rmult_le_pos; [apply pow_le; lra|apply Rlt_le, Rinv_0_lt_compat; lra]. }
unfold F at 2 in H. lra.
Qed.

Lemma gauss_outside k s : 0 < s -> INR (2 * k) - 1 <= lambda * s ^ 2 ->
  gauss_whole k <= 2 * RInt (gauss (2 * k)) 0 s + 2 * (s ^ (2 * k) / s * exp (- (lambda * s ^ 2)) / lambda).
Proof.
intros Hs Hk. apply le_epsilon. intros eps He.
destruct (gauss_near k eps s He Hs) as (a & d & H1 & H2 & H3 & H4 & H5 & H6). apply Rabs_def2 in H6.
assert (E1 := RInt_Chasles (gauss (2 * k)) 0 a s (gauss_ex _ _ _) (gauss_ex _ _ _)).
assert (E2 := RInt_Chasles (gauss (2 * k)) a s d (gauss_ex _ _ _) (gauss_ex _ _ _)).
assert (P : 0 <= RInt (gauss (2 * k)) 0 a).
{ apply RInt_ge_0; [lra|apply gauss_ex|]. intros; apply gauss_nonneg. }
assert (B := gauss_beyond k s d Hs ltac:(lra) Hk).
unfold plus in E1, E2; simpl in E1, E2. simpl in *. lra.
Qed.
End Gaussian.

(** ** Finite sums *)

Lemma sum_integral (b : nat -> R) (f : nat -> R -> R) x y N : (forall k, ex_RInt (f k) x y) ->
  is_RInt (fun s => sum_first (fun k => b k * f k s) N) x y (sum_first (fun k => b k * RInt (f k) x y) N).
Proof.
intros Hf. induction N as [|N IH]; simpl.
- assert (H := is_RInt_const (V := R_NormedModule) x y 0). change (scal (y - x) 0) with ((y - x) * 0) in H.
  rewrite Rmult_0_r in H. exact H.
- apply (is_RInt_plus (fun s => sum_first (fun k => b k * f k s) N) (fun s => b N * f N s)); auto.
  apply (is_RInt_scal (f N) x y (b N)). apply (RInt_correct (f N)), Hf.
Qed.

Lemma sum_continuous (b : nat -> R) (f : nat -> R -> R) s N : (forall k, continuous (f k) s) ->
  continuous (fun s => sum_first (fun k => b k * f k s) N) s.
Proof.
intros Hf. induction N as [|N IH]; simpl. apply continuous_const.
apply (continuous_plus (fun s => sum_first (fun k => b k * f k s) N) (fun s => b N * f N s)); auto.
apply (continuous_scal_r (b N) (f N)), Hf.
Qed.

Lemma even_part lambda (a : nat -> R) s N :
  sum_first (fun n => a n * gauss lambda n s) (2 * N) + sum_first (fun n => a n * gauss lambda n (- s)) (2 * N)
    = sum_first (fun k => 2 * a (2 * k)%nat * gauss lambda (2 * k) s) N.
Proof.
induction N as [|N IH]; [simpl; ring|].
replace (2 * S N)%nat with (S (S (2 * N))) by lia. cbn [sum_first]. rewrite <- IH, gauss_even.
assert (O : gauss lambda (S (2 * N)) (- s) = - gauss lambda (S (2 * N)) s).
{ assert (E := gauss_even lambda N s). unfold gauss in *. simpl pow in *.
  replace (- s * (- s * 1)) with (s * (s * 1)) in * by ring.
  rewrite Rmult_assoc, E. ring. }
rewrite O. ring.
Qed.

Lemma even_terms (a : nat -> R) r N : 0 <= r ->
  sum_first (fun k => Rabs (a (2 * k)%nat) * r ^ (2 * k)) N <= sum_first (fun n => Rabs (a n) * r ^ n) (2 * N).
Proof.
intros Hr. induction N as [|N IH]; [simpl; lra|].
replace (2 * S N)%nat with (S (S (2 * N))) by lia. cbn [sum_first].
assert (0 <= Rabs (a (S (2 * N))) * r ^ S (2 * N)) by (apply Rmult_le_pos; [apply Rabs_pos|apply pow_le, Hr]). lra.
Qed.

(** ** The integral *)

Section Integrand.
Variables lambda c : R.

Definition saddle_integrand (u : R) : R := Rpower (1 + u) c * exp (- (lambda * saddle u ^ 2)).

Lemma integrand_continuous u : -1 < u -> continuous saddle_integrand u.
Proof.
intros Hu. apply (ex_derive_continuous saddle_integrand u). unfold saddle_integrand, saddle, Rpower.
auto_derive. repeat split; lra || exact I.
Qed.

Lemma integrand_ex x y : -1 < x -> x <= y -> ex_RInt saddle_integrand x y.
Proof.
intros Hx Hy. apply (ex_RInt_continuous saddle_integrand). intros z Hz. rewrite Rmin_left in Hz by lra.
apply integrand_continuous. lra.
Qed.

Lemma integrand_pos u : 0 < saddle_integrand u.
Proof. apply Rmult_lt_0_compat; apply exp_pos. Qed.
End Integrand.

Section Integral.
Variables (eta cut lambda c M : R) (N : nat) (a : nat -> R).
Hypothesis Heta : 0 < eta < 1.
Hypothesis Hcut : 0 < cut <= 1 - eta.
Hypothesis Hlambda : 0 < lambda.
Let sigma := saddle_radius eta.
Let p := Rmax 0 c.
Hypothesis HN : INR (2 * N) <= lambda * sigma ^ 2.
Hypothesis Hp : p < 2 * lambda * sigma.
Hypothesis Ha : forall K, sum_first (fun n => Rabs (a n) * sigma ^ n) K <= M.
Hypothesis Hs : forall u, - eta <= u <= eta -> Rabs (saddle u) < sigma ->
  is_pseries a (saddle u) (Rpower (1 + u) c / saddle_slope u).

Let integrand := saddle_integrand lambda c.
Let sigma_pos : 0 < sigma := radius_pos eta Heta.

Lemma power_below u : 0 <= u -> Rpower (1 + u) c <= exp (p * u).
Proof.
intros Hu. unfold Rpower. apply exp_le. assert (L := ln_le_sub1 (1 + u) ltac:(lra)).
assert (L0 : 0 <= ln (1 + u)) by (rewrite <- ln_1; apply ln_le; lra).
assert (P0 : 0 <= p) by apply Rmax_l. assert (P1 : c <= p) by apply Rmax_r.
apply Rle_trans with (p * ln (1 + u)). apply Rmult_le_compat_r; lra. apply Rmult_le_compat_l; lra.
Qed.

(** E_3 *)
Lemma right_part v T : 0 <= v -> saddle v = sigma -> v <= T ->
  RInt integrand v T <= exp (p * sigma - lambda * sigma ^ 2) / (2 * lambda * sigma - p).
Proof.
intros Hv Ev HT. set (K := 2 * lambda * sigma - p). assert (PK : 0 < K) by (unfold K; lra).
set (h := fun s => - (exp (p * s - lambda * s ^ 2) / K)).
set (h' := fun s => (2 * lambda * s - p) * exp (p * s - lambda * s ^ 2) / K).
assert (D : forall u, v <= u -> is_derive (fun u => h (saddle u)) u (saddle_slope u * h' (saddle u))).
{ intros u Hu. apply (is_derive_comp h saddle u (h' (saddle u)) (saddle_slope u)); [|apply saddle_derive; lra].
  unfold h, h'. auto_derive. auto. simpl. unfold Rminus, Rdiv.
  replace (p * saddle u + - (lambda * (saddle u * (saddle u * 1)))) with
    (p * saddle u + - (lambda * (saddle u * (saddle u * 1)))) by ring. field. lra. }
assert (B : RInt integrand v T <= h (saddle T) - h (saddle v)).
{ apply (integral_below (-1) integrand (fun u => h (saddle u)) (fun u => saddle_slope u * h' (saddle u)) v T);
    try lra.
  - intros; apply (integrand_continuous lambda c); auto.
  - intros u Hu. apply D. lra.
  - intros u Hu. assert (S1 := slope_at_least_1 u ltac:(lra)). assert (S2 := saddle_above u ltac:(lra)).
    assert (S3 : sigma <= saddle u).
    { rewrite <- Ev. destruct (Rle_lt_or_eq_dec _ _ (proj1 Hu)) as [H|H]; [|rewrite H; lra].
      apply Rlt_le, saddle_increasing; lra. }
    assert (PW := power_below u ltac:(lra)). assert (P0 : 0 <= p) by apply Rmax_l.
    unfold integrand, saddle_integrand. set (s := saddle u) in *.
    assert (X : exp (p * u) <= exp (p * s)) by (apply exp_le, Rmult_le_compat_l; lra).
    assert (E : exp (p * s - lambda * s ^ 2) = exp (p * s) * exp (- (lambda * s ^ 2))).
    { rewrite <- exp_plus. f_equal. }
    assert (Q : 1 <= (2 * lambda * s - p) / K).
    { apply Rmult_le_reg_r with K; auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by lra.
      unfold K. assert (2 * lambda * sigma <= 2 * lambda * s) by (apply Rmult_le_compat_l; lra). lra. }
    assert (PE := exp_pos (- (lambda * s ^ 2))). assert (PX := exp_pos (p * s)).
    apply Rle_trans with (exp (p * s - lambda * s ^ 2)).
    + rewrite E. apply Rmult_le_compat_r; lra.
    + replace (saddle_slope u * h' s)
        with (saddle_slope u * ((2 * lambda * s - p) / K) * exp (p * s - lambda * s ^ 2)) by (unfold h'; field; lra).
      rewrite <- (Rmult_1_l (exp (p * s - lambda * s ^ 2))) at 1. apply Rmult_le_compat_r. apply Rlt_le, exp_pos.
      rewrite <- (Rmult_1_l 1). apply Rmult_le_compat; lra. }
rewrite Ev in B. unfold h in B.
assert (0 < exp (p * saddle T - lambda * saddle T ^ 2) / K) by (apply Rdiv_lt_0_compat; auto; apply exp_pos). lra.
Qed.

(** E_4 *)
Lemma left_part : RInt integrand (-1 + cut) (- eta) <= Rmax 1 (Rpower cut c) * exp (- (lambda * sigma ^ 2)).
Proof.
set (B := Rmax 1 (Rpower cut c) * exp (- (lambda * sigma ^ 2))).
assert (P1 : 1 <= Rmax 1 (Rpower cut c)) by apply Rmax_l.
assert (P2 : Rpower cut c <= Rmax 1 (Rpower cut c)) by apply Rmax_r.
assert (PB : 0 <= B) by (apply Rmult_le_pos; [lra|apply Rlt_le, exp_pos]).
apply Rle_trans with (RInt (fun _ => B) (-1 + cut) (- eta)).
- apply RInt_le; [lra|apply (integrand_ex lambda c); lra|apply ex_RInt_const|].
  intros u Hu. unfold integrand, saddle_integrand, B. apply Rmult_le_compat; try apply Rlt_le, exp_pos.
  + destruct (Rle_lt_dec 0 c) as [H|H].
    * apply Rle_trans with 1; auto. unfold Rpower. rewrite <- exp_0 at 2. apply exp_le.
      assert (L := ln_le_sub1 (1 + u) ltac:(lra)).
      assert (0 <= c * - ln (1 + u)) by (apply Rmult_le_pos; lra). lra.
    * eapply Rle_trans; [|exact P2]. unfold Rpower. apply exp_le.
      assert (L : ln cut <= ln (1 + u)) by (apply ln_le; lra). apply Rmult_le_compat_neg_l; lra.
  + apply exp_le. assert (L : saddle u < - sigma).
    { unfold sigma. rewrite <- saddle_left. apply saddle_increasing; lra. }
    assert (S : sigma ^ 2 <= saddle u ^ 2) by nra. nra.
- rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. nra.
Qed.

Lemma substitution v (g : R -> R) : 0 <= v <= eta -> saddle v = sigma -> (forall s, continuous g s) ->
  is_RInt (fun u => saddle_slope u * g (saddle u)) (- eta) v (RInt g (- sigma) sigma).
Proof.
intros Hv Ev Hg. unfold sigma in *. rewrite <- Ev at 2. rewrite <- saddle_left.
apply (is_RInt_comp g saddle saddle_slope).
- intros x _. apply Hg.
- intros u Hu. rewrite Rmin_left, Rmax_right in Hu by lra. split. apply saddle_derive; lra.
  apply (ex_derive_continuous saddle_slope u). unfold saddle_slope. assert (P := root_pos u ltac:(lra)).
  auto_derive. replace (1 + u * / 3) with (1 + u / 3) by (unfold Rdiv; ring). repeat split; lra || exact I.
Qed.

(** E_1, E_2. Plan: the integrand is slope(u) g(s(u)) up to C slope(u) s^(2N) e^(-lambda s^2), g = sum_(n < 2N) a_n s^n
    e^(-lambda s^2) (Near); so its integral is that of g over (-sigma, sigma) up to C times that of s^(2N) e^(-lambda
    s^2) (U, L), which is at most E_1. The integral of g is twice the sum of those of its even terms over (0, sigma)
    (G), and what these lack to values of Gamma sums up to E_2. *)
Lemma middle_part v : 0 <= v <= eta -> saddle v = sigma ->
  Rabs (RInt integrand (- eta) v - sum_first (fun k => a (2 * k)%nat * gauss_whole lambda k) N)
    <= M / sigma ^ (2 * N) * gauss_whole lambda N + 2 * M * exp (- (lambda * sigma ^ 2)) / (lambda * sigma).
Proof.
intros Hv Ev. assert (SP := sigma_pos).
set (g := fun s => sum_first (fun n => a n * gauss lambda n s) (2 * N)).
set (C := M / sigma ^ (2 * N)).
assert (PS : 0 < sigma ^ (2 * N)) by (apply pow_lt, SP).
assert (PM := norm_nonneg a sigma M Ha).
assert (Cg : forall s, continuous g s) by (intros s; apply sum_continuous; intros; apply gauss_continuous).
assert (Cgauss : forall s, continuous (gauss lambda (2 * N)) s) by (intros; apply gauss_continuous).
assert (Near : forall u, - eta < u < v -> Rabs (integrand u - saddle_slope u * g (saddle u))
  <= C * (saddle_slope u * gauss lambda (2 * N) (saddle u))).
{ intros u Hu. assert (S0 : 0 < saddle_slope u) by (apply slope_pos; lra).
  assert (S1 : Rabs (saddle u) < sigma).
  { apply Rabs_lt_between. split.
    - unfold sigma. rewrite <- saddle_left. apply saddle_increasing; lra.
    - rewrite <- Ev. apply saddle_increasing; lra. }
  assert (T := series_tail a sigma M SP Ha (saddle u) _ (2 * N) ltac:(lra) (Hs u ltac:(lra) S1)).
  set (s := saddle u) in *. set (ex := exp (- (lambda * s ^ 2))). assert (PE : 0 < ex) by apply exp_pos.
  assert (G : g s = sum_first (fun n => a n * s ^ n) (2 * N) * ex).
  { unfold g. rewrite Rmult_comm, <- sum_first_scal. apply sum_first_ext. intros n. unfold gauss. fold ex. ring. }
  replace (integrand u - saddle_slope u * g s) with
    (saddle_slope u * ex * (Rpower (1 + u) c / saddle_slope u - sum_first (fun n => a n * s ^ n) (2 * N))).
  2: { rewrite G. unfold integrand, saddle_integrand. fold s ex. field. lra. }
  assert (P : 0 <= saddle_slope u * ex) by (apply Rmult_le_pos; lra).
  rewrite Rabs_mult, Rabs_pos_eq by exact P.
  eapply Rle_trans; [apply Rmult_le_compat_l; [exact P|exact T]|]. right. unfold C, gauss. fold ex.
  rewrite pow_quotient, (pow_mult (Rabs s)). replace (Rabs s ^ 2) with (s ^ 2) by (rewrite pow2_abs; reflexivity).
  rewrite <- pow_mult. field. lra. }
assert (I1 := substitution v g Hv Ev Cg). assert (I2 := substitution v _ Hv Ev Cgauss).
assert (IW : is_RInt integrand (- eta) v (RInt integrand (- eta) v)).
{ apply (RInt_correct integrand), (integrand_ex lambda c); lra. }
assert (Hev : - eta <= v) by lra.
assert (IC := is_RInt_scal _ _ _ C _ I2).
assert (U : RInt integrand (- eta) v <= RInt g (- sigma) sigma + C * RInt (gauss lambda (2 * N)) (- sigma) sigma).
{ apply (is_RInt_le integrand _ (- eta) v _ _ Hev IW (is_RInt_plus _ _ _ _ _ _ I1 IC)).
  intros u Hu. specialize (Near u Hu). apply Rabs_le_between in Near.
  change (integrand u <= saddle_slope u * g (saddle u) + C * (saddle_slope u * gauss lambda (2 * N) (saddle u))).
  lra. }
assert (L : RInt g (- sigma) sigma - C * RInt (gauss lambda (2 * N)) (- sigma) sigma <= RInt integrand (- eta) v).
{ apply (is_RInt_le _ integrand (- eta) v _ _ Hev (is_RInt_minus _ _ _ _ _ _ I1 IC) IW).
  intros u Hu. specialize (Near u Hu). apply Rabs_le_between in Near.
  change (saddle_slope u * g (saddle u) - C * (saddle_slope u * gauss lambda (2 * N) (saddle u)) <= integrand u).
  lra. }
assert (Fold : RInt (gauss lambda (2 * N)) (- sigma) sigma = 2 * RInt (gauss lambda (2 * N)) 0 sigma).
{ rewrite fold_integral by (auto; lra). apply is_RInt_unique.
  apply (is_RInt_ext (fun s => scal 2 (gauss lambda (2 * N) s))).
  - intros s _. rewrite gauss_even. unfold scal; simpl; unfold mult; simpl. ring.
  - apply (is_RInt_scal (gauss lambda (2 * N)) 0 sigma 2), (RInt_correct (gauss lambda (2 * N))), gauss_ex. }
assert (E1 : C * RInt (gauss lambda (2 * N)) (- sigma) sigma <= C * gauss_whole lambda N).
{ apply Rmult_le_compat_l; [apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat, PS]|].
  rewrite Fold. apply gauss_inside; auto. }
set (tail := fun k => gauss_whole lambda k - 2 * RInt (gauss lambda (2 * k)) 0 sigma).
assert (G : RInt g (- sigma) sigma = sum_first (fun k => 2 * a (2 * k)%nat * RInt (gauss lambda (2 * k)) 0 sigma) N).
{ rewrite fold_integral by (auto; lra). apply is_RInt_unique.
  apply (is_RInt_ext (fun s => sum_first (fun k => 2 * a (2 * k)%nat * gauss lambda (2 * k) s) N)).
  - intros s _. symmetry. apply even_part.
  - apply (sum_integral (fun k => 2 * a (2 * k)%nat) (fun k => gauss lambda (2 * k))). intros; apply gauss_ex. }
assert (E2 : Rabs (RInt g (- sigma) sigma - sum_first (fun k => a (2 * k)%nat * gauss_whole lambda k) N)
  <= 2 * M * exp (- (lambda * sigma ^ 2)) / (lambda * sigma)).
{ rewrite Rabs_minus_sym.
  replace (sum_first (fun k => a (2 * k)%nat * gauss_whole lambda k) N - RInt g (- sigma) sigma)
    with (sum_first (fun k => a (2 * k)%nat * tail k) N).
  2: { rewrite (sum_first_ext (fun k => a (2 * k)%nat * gauss_whole lambda k) (fun k => a (2 * k)%nat * tail k
         + 2 * a (2 * k)%nat * RInt (gauss lambda (2 * k)) 0 sigma)) by (intros k; unfold tail; ring).
       rewrite sum_first_plus, G. ring. }
  eapply Rle_trans; [apply sum_first_abs|].
  set (q := 2 * exp (- (lambda * sigma ^ 2)) / (lambda * sigma)).
  assert (PQ : 0 <= q).
  { apply Rmult_le_pos. generalize (exp_pos (- (lambda * sigma ^ 2))); lra.
    apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; lra. }
  assert (B : forall K, (K <= N)%nat -> sum_first (fun k => Rabs (a (2 * k)%nat * tail k)) K
    <= q * sum_first (fun k => Rabs (a (2 * k)%nat) * sigma ^ (2 * k)) K).
  { induction K as [|K IH]; intros HK; cbn [sum_first]; [lra|]. rewrite Rmult_plus_distr_l.
    apply Rplus_le_compat; [apply IH; lia|].
    assert (HK' : INR (2 * K) - 1 <= lambda * sigma ^ 2).
    { assert (INR (2 * K) <= INR (2 * N)) by (apply le_INR; lia). lra. }
    assert (T1 := gauss_inside lambda Hlambda K sigma SP). assert (T2 := gauss_outside lambda Hlambda K sigma SP HK').
    rewrite Rabs_mult. replace (q * (Rabs (a (2 * K)%nat) * sigma ^ (2 * K)))
      with (Rabs (a (2 * K)%nat) * (2 * (sigma ^ (2 * K) / sigma * exp (- (lambda * sigma ^ 2)) / lambda)))
      by (unfold q; field; lra).
    apply Rmult_le_compat_l; [apply Rabs_pos|]. rewrite Rabs_pos_eq; unfold tail; lra. }
  eapply Rle_trans; [apply (B N); lia|].
  replace (2 * M * exp (- (lambda * sigma ^ 2)) / (lambda * sigma)) with (q * M) by (unfold q; field; lra).
  apply Rmult_le_compat_l; auto. eapply Rle_trans; [apply even_terms; lra|apply Ha]. }
apply Rabs_le_between in E2. apply Rabs_le. fold C. lra.
Qed.

(** The whole. *)
Theorem saddle_integral T : eta <= T ->
  Rabs (RInt integrand (-1 + cut) T - sum_first (fun k => a (2 * k)%nat * gauss_whole lambda k) N)
    <= M / sigma ^ (2 * N) * gauss_whole lambda N + 2 * M * exp (- (lambda * sigma ^ 2)) / (lambda * sigma)
      + exp (p * sigma - lambda * sigma ^ 2) / (2 * lambda * sigma - p)
      + Rmax 1 (Rpower cut c) * exp (- (lambda * sigma ^ 2)).
Proof.
intros HT. assert (SP := sigma_pos).
destruct (inverse_exists eta Heta sigma ltac:(unfold sigma in *; lra)) as (v & Hv & Ev).
assert (V0 : 0 <= v).
{ apply Rnot_lt_le. intros H. assert (L := saddle_increasing v 0 ltac:(lra) H). unfold saddle at 2 in L. lra. }
assert (M1 := middle_part v ltac:(lra) Ev). assert (R1 := right_part v T V0 Ev ltac:(lra)). assert (L1 := left_part).
assert (R0 : 0 <= RInt integrand v T).
{ apply RInt_ge_0; [lra|apply (integrand_ex lambda c); lra|]. intros; apply Rlt_le, (integrand_pos lambda c). }
assert (L0 : 0 <= RInt integrand (-1 + cut) (- eta)).
{ apply RInt_ge_0; [lra|apply (integrand_ex lambda c); lra|]. intros; apply Rlt_le, (integrand_pos lambda c). }
rewrite <- (RInt_Chasles integrand (-1 + cut) (- eta) T) by (apply (integrand_ex lambda c); lra).
rewrite <- (RInt_Chasles integrand (- eta) v T) by (apply (integrand_ex lambda c); lra).
change (plus ?x (plus ?y ?z)) with (x + (y + z)). apply Rabs_le_between in M1. apply Rabs_le. lra.
Qed.
End Integral.
