(** * The values at -x, for every b

    The enveloping series ([EnvelopingLow.v]) after N terms: for b < 3N what is left lies between 0 and the next term.
    In the limit this holds at the integers too, since both sides are continuous in b. With Theta' = - b Theta(., b - 1)
    it gives the values of Theta, Theta' and Theta'' at -x (proofs/check.md, section 1). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate Calculus GammaFunction Family ContinuityInBeta EnvelopingLow
  CertificateFamily.
Open Scope R_scope.

(** (-1)^k (-b)_(3k)/(3^k k! x^(3k)) *)
Definition start_term (b x : R) (k : nat) : R := (-1) ^ k
  * (rising (- b) (3 * k) / (3 ^ k * INR (fact k) * x ^ (3 * k))).

Lemma start_denominator x k : 0 < x -> 0 < 3 ^ k * INR (fact k) * x ^ (3 * k).
Proof.
intros Hx. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]. apply pow_lt; lra. apply INR_fact_lt_0.
apply pow_lt; lra.
Qed.

Lemma start_term_step b x k : 0 < x -> start_term b x (S k)
  = - (start_term b x k * (3 * INR k - b) * (3 * INR k + 1 - b) * (3 * INR k + 2 - b)) / (3 * (INR k + 1) * x ^ 3).
Proof.
intros Hx. unfold start_term. replace (3 * S k)%nat with (S (S (S (3 * k)))) by lia.
cbn [rising]. rewrite fact_simpl, (S_INR (S (3 * k))), (S_INR (3 * k)), !mult_INR, (S_INR k).
replace (INR 3) with 3 by (simpl; ring).
replace (x ^ S (S (S (3 * k)))) with (x ^ 3 * x ^ (3 * k)) by (simpl; ring). cbn [pow].
assert (P := pos_INR k). field. repeat split; try lra. apply pow_nonzero; lra. apply INR_fact_neq_0.
apply pow_nonzero; lra.
Qed.

(** A step of b: -b (1 - b)_n = (-b)_n (n - b). *)
Lemma rising_shift a n : a * rising (a + 1) n = rising a n * (a + INR n).
Proof. induction n as [|n IH]. simpl. ring. cbn [rising]. rewrite <- Rmult_assoc, IH, S_INR. ring. Qed.

Lemma start_term_slope b x k : - b * start_term (b - 1) x k = start_term b x k * (3 * INR k - b).
Proof.
unfold start_term. assert (H := rising_shift (- b) (3 * k)). rewrite mult_INR in H. simpl (INR 3) in H.
replace (- (b - 1)) with (- b + 1) by ring. set (D := 3 ^ k * INR (fact k) * x ^ (3 * k)).
transitivity ((-1) ^ k * (- b * rising (- b + 1) (3 * k)) / D); [unfold Rdiv; ring|]. rewrite H. unfold Rdiv. ring.
Qed.

Lemma sum_first_scal_l q (v : nat -> R) n : q * sum_first v n = sum_first (fun k => q * v k) n.
Proof. induction n as [|n IH]; simpl. ring. rewrite <- IH. ring. Qed.

Lemma sum_first_eq (v v' : nat -> R) n : (forall k, v k = v' k) -> sum_first v n = sum_first v' n.
Proof. intros H. induction n as [|n IH]; simpl; congruence. Qed.

Section Start.
Variable F : R -> R -> R.
Hypothesis HF : theta_family F.
Variables (x : R) (N : nat).
Hypothesis Hx : 0 < x.

Definition left_out (b : R) : R := F b (- x) / Rpower x b - sum_first (start_term b x) N.

Lemma left_out_off_integers b : not_nat b -> b < 3 * INR N -> left_out b * (left_out b - start_term b x N) <= 0.
Proof.
intros Hb HN.
assert (E := EnvelopingLow.enveloping_series_low b (F b) Hb (family_theta F HF b Hb) 0 N x Hx ltac:(simpl (INR 0);
  lra)).
cbv zeta in E. cbn [rising] in E. rewrite Rmult_1_l in E. simpl (INR 0) in E. replace (0 - b) with (- b) in E by ring.
replace (b - 0) with b in E by ring.
change (Derive_n (F b) 0 (- x)) with (F b (- x)) in E.
set (term := fun k => rising (- b) (3 * k) / (3 ^ k * INR (fact k) * x ^ (3 * k))) in *.
change (0 <= (-1) ^ N * left_out b / term N <= 1) in E.
change (start_term b x N) with ((-1) ^ N * term N).
assert (T : term N <> 0).
{ unfold term. apply Rmult_integral_contrapositive_currified.
  - apply rising_neq0. intros k Hk. apply (Hb k). lra.
  - apply Rinv_neq_0_compat, Rgt_not_eq, start_denominator, Hx. }
set (r := (-1) ^ N * left_out b / term N) in E.
assert (S2 : (-1) ^ N * (-1) ^ N = 1).
{ rewrite <- Rpow_mult_distr. replace (-1 * -1) with 1 by ring. apply pow1. }
assert (El : left_out b = (-1) ^ N * term N * r).
{ unfold r. transitivity ((-1) ^ N * (-1) ^ N * left_out b); [rewrite S2; ring|]. field. exact T. }
rewrite El. replace ((-1) ^ N * term N * r * ((-1) ^ N * term N * r - (-1) ^ N * term N))
  with (((-1) ^ N * (-1) ^ N) * (term N ^ 2 * (r * (r - 1)))) by ring.
rewrite S2, Rmult_1_l. assert (A : 0 <= term N ^ 2) by apply pow2_ge_0.
assert (B : 0 <= r * (1 - r)) by (apply Rmult_le_pos; lra).
assert (C := Rmult_le_pos _ _ A B). lra.
Qed.

Lemma rising_continuous n b : continuity_pt (fun b => rising (- b) n) b.
Proof.
induction n as [|n IH]; cbn [rising].
- apply continuity_pt_const. intros u v. reflexivity.
- apply (continuity_pt_mult (fun b => rising (- b) n) (fun b => - b + INR n)); auto.
  apply derivable_continuous_pt. apply ex_derive_Reals_0. auto_derive; auto.
Qed.

Lemma start_term_continuous k b : continuity_pt (fun b => start_term b x k) b.
Proof.
unfold start_term. apply (continuity_pt_scal (fun b => rising (- b) (3 * k) / (3 ^ k * INR (fact k) * x ^ (3 * k)))).
apply (continuity_pt_mult (fun b => rising (- b) (3 * k)) (fun _ => / (3 ^ k * INR (fact k) * x ^ (3 * k)))).
apply rising_continuous. apply continuity_pt_const. intros u v. reflexivity.
Qed.

Lemma left_out_continuous b : continuity_pt left_out b.
Proof.
unfold left_out. apply (continuity_pt_minus (fun b => F b (- x) / Rpower x b) (fun b => sum_first (start_term b x) N)).
- apply (continuity_pt_div (fun b => F b (- x)) (fun b => Rpower x b)).
  + apply family_continuous, HF.
  + apply derivable_continuous_pt. apply ex_derive_Reals_0. unfold Rpower. auto_derive; auto.
  + apply Rgt_not_eq, exp_pos.
- induction N as [|n IH]; cbn [sum_first].
  + apply continuity_pt_const. intros u v. reflexivity.
  + apply (continuity_pt_plus (fun b => sum_first (start_term b x) n) (fun b => start_term b x n)); auto.
    apply start_term_continuous.
Qed.

Lemma left_out_between b : b < 3 * INR N -> left_out b * (left_out b - start_term b x N) <= 0.
Proof.
intros HN. set (h := fun b => left_out b * (left_out b - start_term b x N)). change (h b <= 0).
assert (L : Rbar_le (Finite (h b)) (Finite 0)); [|exact L].
apply (is_lim_le_loc h (fun _ => 0) b).
- assert (A : Rbar_locally' b (fun c => c < 3 * INR N)).
  { exists (mkposreal (3 * INR N - b) ltac:(lra)). intros y Hy _. apply Rabs_def2 in Hy.
    unfold minus, plus, opp in Hy; simpl in Hy. lra. }
  generalize (filter_and _ _ A (near_not_nat b)). apply filter_imp. intros c [H1 H2]. apply left_out_off_integers; auto.
- apply (is_lim_continuity h b). unfold h. apply (continuity_pt_mult left_out (fun b => left_out b - start_term b x N)).
  + apply left_out_continuous.
  + apply (continuity_pt_minus left_out (fun b => start_term b x N)). apply left_out_continuous.
    apply start_term_continuous.
- apply is_lim_const.
Qed.

Theorem value_at_start b : b < 3 * INR N -> exists theta, 0 <= theta <= 1 /\
  F b (- x) / Rpower x b = sum_first (start_term b x) N + theta * start_term b x N.
Proof.
intros HN. assert (H := left_out_between b HN). set (q := left_out b) in *. set (e := start_term b x N) in *.
assert (Eq : F b (- x) / Rpower x b = sum_first (start_term b x) N + q) by (unfold q, left_out; ring). rewrite Eq.
destruct (Req_dec e 0) as [E|E].
- exists 0. split; [lra|]. assert (q = 0) by (rewrite E in H; nra). lra.
- exists (q / e). assert (E2 : 0 < e ^ 2) by (apply pow2_gt_0, E). split; [|field; auto].
  assert (Q : q / e * (q / e - 1) <= 0).
  { apply Rmult_le_reg_r with (e ^ 2); auto. replace (q / e * (q / e - 1) * e ^ 2) with (q * (q - e)) by (field; auto).
    lra. }
  nra.
Qed.

Lemma Rpower_minus_1 b : Rpower x (b - 1) = Rpower x b / x.
Proof. unfold Rminus. rewrite Rpower_plus, Rpower_Ropp, Rpower_1 by auto. reflexivity. Qed.

Theorem slope_at_start b : b < 3 * INR N -> exists theta, 0 <= theta <= 1 /\
  x * Derive (F b) (- x) / Rpower x b
    = sum_first (fun k => start_term b x k * (3 * INR k - b)) N + theta * (start_term b x N * (3 * INR N - b)).
Proof.
intros HN. destruct (value_at_start (b - 1) ltac:(lra)) as (theta & Ht & E). exists theta. split; auto.
rewrite Rpower_minus_1 in E. rewrite family_slope by auto. assert (X : 0 < Rpower x b) by apply exp_pos.
replace (x * (- b * F (b - 1) (- x)) / Rpower x b) with (- b * (F (b - 1) (- x) / (Rpower x b / x))) by (field; lra).
rewrite E, Rmult_plus_distr_l, sum_first_scal_l. f_equal.
- apply sum_first_eq. intros k. apply start_term_slope.
- rewrite <- (start_term_slope b x N). ring.
Qed.

Theorem second_at_start b : b < 3 * INR N -> exists theta, 0 <= theta <= 1 /\
  x ^ 2 * Derive_n (F b) 2 (- x) / Rpower x b = sum_first (fun k =>
    start_term b x k * (3 * INR k - b) * (3 * INR k + 1 - b)) N
    + theta * (start_term b x N * (3 * INR N - b) * (3 * INR N + 1 - b)).
Proof.
intros HN. destruct (value_at_start (b - 1 - 1) ltac:(lra)) as (theta & Ht & E). exists theta. split; auto.
rewrite !Rpower_minus_1 in E. rewrite family_second, family_slope by auto. assert (X : 0 < Rpower x b) by apply exp_pos.
replace (x ^ 2 * (- b * (- (b - 1) * F (b - 1 - 1) (- x))) / Rpower x b)
  with (- b * (- (b - 1) * (F (b - 1 - 1) (- x) / (Rpower x b / x / x)))) by (field; lra).
assert (T : forall k, - b * (- (b - 1) * start_term (b - 1 - 1) x k) = start_term b x k * (3 * INR k - b) * (3 * INR k
  + 1 - b)).
{ intros k. rewrite start_term_slope, <- Rmult_assoc, start_term_slope. ring. }
rewrite E, !Rmult_plus_distr_l, !sum_first_scal_l. f_equal.
- apply sum_first_eq. intros k. rewrite <- T. ring.
- rewrite <- T. ring.
Qed.

End Start.
