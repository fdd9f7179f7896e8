(** * What the pieces of a certificate about the zeros at every eps prove together

    proofs/certificate.md, [slow_zeros]. Of the column that holds beta the piece dip says that the bound of
    [CompliantUpper.v] is negative at t1, with mu = t1/t2, for every eta <= eta0: so G_b is negative there, and F_b has
    two zeros, both simple ([CompliantLaw.v]), for b = beta - 1 in (3, 4). *)

From Coq Require Import Reals Psatz Lra Lia ZArith List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant StatementCertificate Calculus Family Ends CompliantSlow
  CompliantMonotone CompliantPower
  CompliantLaw CompliantUpper CertificateWalk CertificateFamily CertificatePieces.
Import ListNotations.
Open Scope R_scope.

Lemma dip_negative F eta0 low high t1 t2 e b : theta_family F -> dip_checked F eta0 low high t1 t2 ->
  low <= b + 1 <= high -> 3 < b < 4 ->
  0 < e <= 2 * eta0 ^ 3 -> 0 < eta0 -> exists T, Fe e b T < 0.
Proof.
intros HF ((H1 & H12) & H3 & Dip) Hb H34 He He0. assert (H2 : 0 < t2) by lra.
destruct (Gamma_cell 3 b ltac:(simpl; lra)) as [Hn HG]. simpl in HG. specialize (Dip b Hb).
set (mu := t1 / t2) in *. assert (Hmu : 0 < mu) by (apply Rdiv_lt_0_compat; auto).
assert (Hmu3 : 2 * mu ^ 3 <= 1).
{ apply Rmult_le_reg_r with (t2 ^ 3); [apply pow_lt, H2|].
  replace (2 * mu ^ 3 * t2 ^ 3) with (2 * t1 ^ 3) by (unfold mu; field; lra). lra. }
set (eta := Rpower (e / 2) (1 / 3)). assert (Heta : 0 < eta) by apply exp_pos. assert (E3 := eta_cube e (proj1 He)).
fold eta in E3.
assert (Hle : eta <= eta0).
{ apply Rnot_lt_le. intros L. assert (eta0 ^ 3 < eta ^ 3); [|lra].
  assert (0 < eta0 ^ 2) by (apply pow_lt; auto). assert (eta0 * eta0 < eta * eta) by nra. simpl. nra. }
assert (B := slow_upper_bound eta0 mu Hmu Hmu3 b (F b) Hn (family_theta F HF b Hn) eta 0 t1 (conj Heta Hle) ltac:(simpl;
  lra)).
assert (S := Fe_scaled e (proj1 He) b (t1 / eta) Hn). fold eta in S.
replace (eta * (t1 / eta)) with t1 in S by (field; lra).
exists (t1 / eta). unfold stretched, scaled, slope_weight in B.
replace (t1 / mu) with t2 in B by (unfold mu; field; lra).
replace (- (- b - 1 + INR 0 + 2)) with (b - 1) in B by (simpl; ring). simpl Derive_n in B.
change (Derive (fun x => F b x)) with (Derive (F b)) in B.
set (J := scaled_J eta (- b - 1) 0 t1) in *. set (G := Gamma (- b)) in *.
set (value := F b t1 + 3 * eta0 / (8 * (1 - mu ^ 3)) * (Rpower mu (b - 1) * Derive (F b) t2 - Derive (F b) t1)) in *.
assert (B' : J <= G * value) by (unfold value; lra).
assert (HJ : J < 0) by nra. assert (P : 0 < Rpower eta (- b)) by apply exp_pos. nra.
Qed.

Theorem slow_zeros_certificate F beta columns eps0 eta0 : theta_family F ->
  (forall x, in_range beta x -> 4 <= x <= 5) -> 0 < eta0 -> eps0 <= 2 * eta0 ^ 3 ->
  cover (map (fun c => match c with (low, high, _, _) => (Finite low, Finite high) end) columns) (range_from beta)
    (range_to beta) ->
  (forall low high t1 t2, In (low, high, t1, t2) columns -> dip_checked F eta0 low high t1 t2) ->
  forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps -> in_range beta (a3 / a1) -> - a1 * eps <= eps0 -> C <> 0 ->
    slow_motion a1 a2 a3 eps C p b y v z ->
    exists s t, s < t /\ simple_zeros (fun t => linear_force eps (y t) (z t) - a2 / (a3 - a1)) [s; t].
Proof.
intros HF H45 He0 Heps Hcover Hdip a1 a2 a3 eps C p b y v z Hpar Hbeta He HC HS. assert (Hpar' := Hpar).
destruct Hpar' as (H1 & H3 & Hpos & Hn).
set (x := a3 / a1) in *. destruct (in_range_closure _ _ Hbeta) as [L U].
destruct (cover_point _ _ _ x Hcover L U) as (ends & I & A & B). apply in_map_iff in I.
destruct I as ([[[low high] t1] t2] & <- & I). simpl in A, B.
assert (Hx : 4 < x < 5).
{ assert (H := H45 x Hbeta). assert (N4 := Hn 4%nat). assert (N5 := Hn 5%nat). simpl in N4, N5. lra. }
assert (Hea : 0 < - a1 * eps) by nra.
destruct (dip_negative F eta0 low high t1 t2 (- a1 * eps) (x - 1) HF (Hdip _ _ _ _ I)) as (T & HT); try lra.
destruct (two_zeros_if_negative (- a1 * eps) (x - 1) T Hea ltac:(lra) HT) as (s & t & Hst & Z).
exists (eps * s), (eps * t). split; [apply Rmult_lt_compat_l; auto|].
exact (force_zeros_from a1 a2 a3 eps C p b y v z Hpar HS HC [s; t] Z).
Qed.
