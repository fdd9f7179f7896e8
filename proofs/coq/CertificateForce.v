(** * What the pieces of a certificate about the contact force prove together

    proofs/certificate.md, [force] and [lift_off]. On every piece s F >= - c, s = (-1)^floor(beta); so C_1 dTheta/dtau =
    - beta C_1 F is at least - beta |C_1| c on the side C_1/Gamma(-beta) > 0. The comparison of powers with integer
    exponents says that the deviation at this level and at eps_0 is at most the mean force. The force at every eps lies
    above that at leading order ([CompliantThreshold.v]). *)

From Coq Require Import Reals Psatz Lra Lia ZArith List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant StatementCertificate Calculus GammaFunction Family Ends
  CompliantThreshold CertificateWalk CertificateFamily CertificatePieces.
Import ListNotations.
Open Scope R_scope.

(** (2 eps^2/(-a1))^((beta - 1)/3) = kappa^(1 - beta) eps^p, p = 2 (beta - 1)/3. *)
Lemma scale_power a1 eps beta : a1 < 0 -> 0 < eps ->
  Rpower (2 * eps ^ 2 / - a1) ((beta - 1) / 3)
    = Rpower (Rpower (- a1 / 2) (1 / 3)) (1 - beta) * Rpower eps ((2 * beta - 2) / 3).
Proof.
intros H1 He. rewrite Rpower_mult. unfold Rpower. rewrite <- exp_plus. f_equal.
assert (E : ln (2 * eps ^ 2 / - a1) = 2 * ln eps - ln (- a1 / 2)).
{ replace (2 * eps ^ 2 / - a1) with (eps * eps * / (- a1 / 2)) by (field; lra).
  rewrite ln_mult, ln_mult, ln_Rinv; try lra.
  - apply Rmult_lt_0_compat; lra.
  - apply Rinv_0_lt_compat; lra. }
rewrite E. field.
Qed.

(** The comparison of powers with integer exponents: beta - 1 = h/n. *)
Lemma compared_power x y (h n : nat) : 0 < x -> 0 < y -> (0 < n)%nat ->
  (x ^ (3 * n) * y ^ h <= 1 -> x * Rpower y (INR h / INR n / 3) <= 1) /\
  (1 <= x ^ (3 * n) * y ^ h -> 1 <= x * Rpower y (INR h / INR n / 3)).
Proof.
intros Hx Hy Hn. assert (Hn' : 0 < INR n) by (apply lt_0_INR, Hn).
set (z := x * Rpower y (INR h / INR n / 3)). assert (Hz : 0 < z) by (apply Rmult_lt_0_compat; auto; apply exp_pos).
assert (E : x ^ (3 * n) * y ^ h = z ^ (3 * n)).
{ unfold z. rewrite Rpow_mult_distr. f_equal.
  rewrite <- (Rpower_pow (3 * n)) by apply exp_pos. rewrite Rpower_mult, <- Rpower_pow by auto. f_equal.
  rewrite mult_INR. simpl. field. lra. }
rewrite E. split; intros H; apply Rnot_lt_le; intros L.
- assert (B : 1 < z ^ (3 * n)) by (apply Rlt_pow_R1; auto; lia). lra.
- assert (A := pow_lt_1_compat z (3 * n) (conj (Rlt_le _ _ Hz) L) ltac:(lia)). lra.
Qed.

Section Force.
Variables (F : R -> R -> R) (a1 a2 a3 C1 eps0 level : R) (h n m : nat).
Hypothesis HF : theta_family F.
Hypothesis H1 : a1 < 0.
Hypothesis H2 : a2 < 0.
Hypothesis H3 : a3 < 0.
Hypothesis Hn : (0 < n)%nat.
Hypothesis Hrational : a3 / a1 = 1 + INR h / INR n.
Hypothesis Hm : INR m < a3 / a1 < INR m + 1.
Hypothesis H15 : 1 < a3 / a1 < 5.
Hypothesis He0 : 0 < eps0.
Hypothesis Hlevel : 0 < level.
Hypothesis HC : C1 <> 0.

Let beta : R := a3 / a1.
Let q (eps : R) : R := / (- a3) * (Rpower (Rpower (- a1 / 2) (1 / 3)) (1 - beta) * Rpower eps ((2 * beta - 2) / 3)).
Let mean : R := a2 / (a3 - a1).

Lemma mean_positive : 0 < mean.
Proof.
assert (Ea : a3 = beta * a1) by (unfold beta; field; lra). assert (H31 : a3 - a1 < 0) by (unfold beta in Ea; nra).
unfold mean. replace (a2 / (a3 - a1)) with ((- a2) / (- (a3 - a1))) by (field; lra). apply Rdiv_lt_0_compat; lra.
Qed.

Lemma beta_not_nat : not_nat beta.
Proof. apply (cell_not_nat (S m)). unfold cell. rewrite S_INR. fold beta in Hm. lra. Qed.

Lemma q_positive eps : 0 < q eps.
Proof. apply Rmult_lt_0_compat. apply Rinv_0_lt_compat; lra. apply Rmult_lt_0_compat; apply exp_pos. Qed.

Lemma q_increases eps eps' : 0 < eps <= eps' -> q eps <= q eps'.
Proof.
intros H. apply Rmult_le_compat_l. apply Rlt_le, Rinv_0_lt_compat; lra. apply Rmult_le_compat_l. apply Rlt_le, exp_pos.
apply Rle_Rpower_l; [|exact H]. fold beta in H15. apply Rlt_le, Rdiv_lt_0_compat; lra.
Qed.

(** The deviation at this level and at eps_0 against the mean force. *)
Lemma compared_exactly : let x := compared a1 a2 a3 C1 eps0 level h n in
  (x <= 1 -> q eps0 * (Rabs C1 * (beta * level)) <= mean) /\ (1 <= x -> mean <= q eps0 * (Rabs C1 * (beta * level))).
Proof.
unfold compared. assert (M := mean_positive). assert (A := Rabs_pos_lt C1 HC). fold beta in H15. fold beta mean.
assert (EC : Rabs (C1 / a3) = Rabs C1 * / (- a3)).
{ unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_left a3) by auto. reflexivity. }
assert (HX : 0 < Rabs (C1 / a3) * beta * level / mean).
{ rewrite EC. apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; auto. apply Rmult_lt_0_compat; [|lra].
  apply Rmult_lt_0_compat; auto. apply Rinv_0_lt_compat; lra. }
assert (HY : 0 < 2 * eps0 ^ 2 / - a1).
{ apply Rdiv_lt_0_compat; [|lra]. assert (P := pow_lt eps0 2 He0). lra. }
destruct (compared_power _ _ h n HX HY Hn) as [L U].
replace (INR h / INR n / 3) with ((beta - 1) / 3) in L, U by (unfold beta; rewrite Hrational; field; apply not_0_INR;
  lia).
rewrite scale_power in L, U by auto.
set (P := Rpower (Rpower (- a1 / 2) (1 / 3)) (1 - beta) * Rpower eps0 ((2 * beta - 2) / 3)) in *.
assert (E : Rabs (C1 / a3) * beta * level / mean * P * mean = q eps0 * (Rabs C1 * (beta * level))).
{ rewrite EC. unfold q. fold P. field. split; lra. }
cbv zeta. split; intros H.
- assert (B := Rmult_le_compat_r mean _ _ (Rlt_le _ _ M) (L H)). rewrite E in B. lra.
- assert (B := Rmult_le_compat_r mean _ _ (Rlt_le _ _ M) (U H)). rewrite E in B. lra.
Qed.

(** The force at leading order through F = Theta(., beta - 1). *)
Lemma leading_force_family eps t : leading_force a1 a2 a3 eps C1 (F beta) t
  = mean - q eps * (beta * (C1 * F (beta - 1) (Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3)))).
Proof.
destruct (leading_force_factor a1 a2 a3 eps C1 (F beta) t H3) as (q' & _ & Eq & ->).
rewrite family_slope by auto. fold beta mean in Eq |- *. fold (q eps) in Eq. rewrite Eq. ring.
Qed.

(** The sign of C_1 on either side. *)
Lemma charge_sign s : 0 < s * (C1 * Gamma (- beta)) -> s * s = 1 -> forall x,
  C1 * x = - (s * (Rabs C1 * signed (Nat.even m) x)).
Proof.
intros H Hs x. assert (G := Ends.Gamma_sign m beta Hm). rewrite Nat.add_1_r, <- signed_even, even_S, signed_negb in G.
assert (Cases : s = 1 \/ s = -1) by nra.
destruct (Nat.even m); simpl in *; destruct Cases as [-> | ->]; unfold Rabs; destruct (Rcase_abs C1); nra.
Qed.

(** The slow motion at one eps; s F >= - c on one side, s F >= c on the other. *)
Lemma force_positive_at eps p b y v z t : 0 < eps <= eps0 -> slow_motion a1 a2 a3 eps (C1 * Rpower eps beta)
  p b y v z ->
  0 < C1 * Gamma (- beta) -> compared a1 a2 a3 C1 eps0 level h n <= 1 ->
  - level <= signed (Nat.even m) (F (beta - 1) (Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3))) ->
      0 < linear_force eps (y t) (z t).
Proof.
intros He HS HG Hx HF0. assert (Par : parameters a1 a3 eps) by (repeat split; try lra; exact beta_not_nat).
eapply Rle_lt_trans;
  [|apply (proj1 (force_above_leading_order a1 a2 a3 eps C1 (F beta) p b y v z Par (family_theta F HF beta beta_not_nat)
    HS t (proj2 H15)) HG)].
rewrite leading_force_family. set (f := F (beta - 1) _) in *.
rewrite (charge_sign 1 ltac:(lra) ltac:(ring)). assert (Q := q_increases eps eps0 He). assert (Qp := q_positive eps).
assert (B := proj1 compared_exactly Hx). assert (A := Rabs_pos_lt C1 HC). fold beta in H15.
assert (P : 0 < Rabs C1 * (beta * level)) by (apply Rmult_lt_0_compat; auto; apply Rmult_lt_0_compat; lra).
assert (C : q eps * (Rabs C1 * (beta * level)) <= q eps0 * (Rabs C1 * (beta * level)))
  by (apply Rmult_le_compat_r; lra).
assert (D : q eps * (Rabs C1 * (beta * - level)) <= q eps * (Rabs C1 * (beta * signed (Nat.even m) f))).
{ repeat apply Rmult_le_compat_l; lra. }
lra.
Qed.

Lemma force_negative_at eps p b y v z t : eps0 <= eps -> slow_motion a1 a2 a3 eps (C1 * Rpower eps beta) p b y v z ->
  C1 * Gamma (- beta) < 0 -> 1 <= compared a1 a2 a3 C1 eps0 level h n ->
  level <= signed (Nat.even m) (F (beta - 1) (Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3))) ->
    linear_force eps (y t) (z t) < 0.
Proof.
intros He HS HG Hx HF0. assert (Par : parameters a1 a3 eps) by (repeat split; try lra; exact beta_not_nat).
eapply Rlt_le_trans;
  [apply (proj2 (force_above_leading_order a1 a2 a3 eps C1 (F beta) p b y v z Par (family_theta F HF beta beta_not_nat)
    HS t (proj2 H15)) HG)|].
rewrite leading_force_family. set (f := F (beta - 1) _) in *.
rewrite (charge_sign (-1) ltac:(lra) ltac:(ring)). assert (Q := q_increases eps0 eps (conj He0 He)).
assert (Qp := q_positive eps).
assert (B := proj2 compared_exactly Hx). assert (A := Rabs_pos_lt C1 HC). fold beta in H15.
assert (P : 0 < Rabs C1 * (beta * level)) by (apply Rmult_lt_0_compat; auto; apply Rmult_lt_0_compat; lra).
assert (C : q eps0 * (Rabs C1 * (beta * level)) <= q eps * (Rabs C1 * (beta * level)))
  by (apply Rmult_le_compat_r; lra).
assert (D : q eps * (Rabs C1 * (beta * level)) <= q eps * (Rabs C1 * (beta * signed (Nat.even m) f))).
{ repeat apply Rmult_le_compat_l; lra. }
lra.
Qed.
End Force.

Theorem force_certificate F a1 a2 a3 C1 eps0 level h n tau c parts : theta_family F ->
  a1 < 0 -> a2 < 0 -> a3 < 0 -> (0 < n)%nat -> a3 / a1 = 1 + INR h / INR n -> not_nat (a3 / a1) -> 1 < a3 / a1 < 5 ->
  0 < eps0 -> 0 < level -> 0 < C1 * Gamma (- (a3 / a1)) -> compared a1 a2 a3 C1 eps0 level h n <= 1 ->
  force_column F (a3 / a1) level tau c parts ->
  forall eps p b y v z t, 0 < eps <= eps0 -> slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) p b y v z ->
    in_range tau (Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3)) -> 0 < linear_force eps (y t) (z t).
Proof.
intros HF H1 H2 H3 Hn Hr Hnat H15 He0 Hl HG Hx (Cc & Elow & Ehigh & Hcover & Hparts) eps p b y v z t He HS Ht.
set (beta := a3 / a1) in *. set (x := Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3)) in *.
assert (Hc : in_column c (beta - 1)).
{ unfold in_column. replace (beta - 1 + 1) with beta by ring. rewrite Elow, Ehigh. split; [apply Rle_refl|lra]. }
set (m := column_cell c) in *.
assert (Hm : INR m < beta < INR m + 1).
{ destruct Cc as [C1' C2]. fold m in C1', C2. rewrite Ehigh in C1'. rewrite Elow in C2. simpl in C2.
  assert (A := Hnat m). assert (B := Hnat (S m)). rewrite S_INR in B.
  destruct C2 as [C2|C2]; [rewrite C2 in *; simpl in *|]; lra. }
assert (HC : C1 <> 0) by (intros ->; lra).
apply (force_positive_at F a1 a2 a3 C1 eps0 level h n m HF H1 H2 H3 Hn Hr Hm H15 He0 Hl HC eps p b y v z t He HS HG Hx).
fold beta x. apply in_range_closure in Ht as Ht'.
destruct (cover_point _ _ _ x Hcover (proj1 Ht') (proj2 Ht')) as (ends & I & A & B).
apply in_map_iff in I. destruct I as (part & <- & I). assert (P := Hparts part I).
destruct part as [q|[t1 t2]].
- destruct P as (Hq & Es & Kind). apply Rle_trans with 0; [lra|apply Rlt_le].
  destruct q as [| |X|u1 u2 s|u1 u2 d|u1 u2|u1 u2|T w]; try contradiction; cbn [piece_sign] in Es; injection Es as Es;
    fold m in Es; simpl in A, B.
  + rewrite <- Es. apply (left_gives F HF c Cc X); auto.
  + rewrite <- Es. apply Hq; auto.
  + subst w. apply (right_none F HF c Cc T); auto.
- assert (Q := P x (conj A B)). assert (R := Rle_abs (F (beta - 1) x)). assert (R' := Rle_abs (- F (beta - 1) x)).
  rewrite Rabs_Ropp in R'.
  destruct (Nat.even m); simpl; lra.
Qed.

Theorem lift_off_certificate F a1 a2 a3 C1 eps1 level h n m tau1 : theta_family F ->
  a1 < 0 -> a2 < 0 -> a3 < 0 -> (0 < n)%nat -> a3 / a1 = 1 + INR h / INR n -> INR m < a3 / a1 < INR m + 1 ->
    1 < a3 / a1 < 5 ->
  0 < eps1 -> 0 < level -> C1 * Gamma (- (a3 / a1)) < 0 -> 1 <= compared a1 a2 a3 C1 eps1 level h n ->
  level <= signed (Nat.even m) (F (a3 / a1 - 1) tau1) ->
  forall eps p b y v z t, eps1 <= eps -> slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) p b y v z ->
    Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3) = tau1 -> linear_force eps (y t) (z t) < 0.
Proof.
intros HF H1 H2 H3 Hn Hr Hm H15 He1 Hl HG Hx HF0 eps p b y v z t He HS Et.
assert (HC : C1 <> 0) by (intros ->; lra).
apply (force_negative_at F a1 a2 a3 C1 eps1 level h n m HF H1 H2 H3 Hn Hr Hm H15 He1 Hl HC eps p b y v z t He HS HG Hx).
rewrite Et. exact HF0.
Qed.
