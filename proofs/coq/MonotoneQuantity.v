(** * The monotone quantity Q = g' g'' + (b/2) g^2

    Section 2 of proofs/proofs/count_law.md: for a solution g of g''' = t g' - b g, Q' = g''^2 + t g'^2. So Q does not
    decrease on t >= 0, and at every zero c > 0 of Theta(., b), b > 0, Theta'(c) Theta''(c) > 0: it is enough to have Q
    > 0 at one point of [0, c]. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus Gronwall WellPosed Family SignsAtZero.
Open Scope R_scope.

Section Quantity.
Variables (b : R) (g g1 g2 : R -> R).
Hypothesis D0 : forall t, is_derive g t (g1 t).
Hypothesis D1 : forall t, is_derive g1 t (g2 t).
Hypothesis D2 : forall t, is_derive g2 t (t * g1 t - b * g t).

Definition Qf (t : R) : R := g1 t * g2 t + b / 2 * g t ^ 2.

Lemma Q_derive t : is_derive Qf t (g2 t ^ 2 + t * g1 t ^ 2).
Proof.
unfold Qf. evar_last.
- apply (is_derive_plus (fun t => g1 t * g2 t) (fun t => b / 2 * g t ^ 2)).
  + apply (is_derive_mult_R g1 g2); auto.
  + apply (is_derive_scal (fun t => g t ^ 2)). apply is_derive_pow, D0.
- unfold plus; simpl. field.
Qed.

Theorem Q_mono x y : 0 <= x -> x <= y -> Qf x <= Qf y.
Proof.
intros Hx Hxy.
apply Ropp_le_cancel.
apply (decr_of_derive (fun t => - Qf t) (fun t => - (g2 t ^ 2 + t * g1 t ^ 2)) x y Hxy).
- intros t _. apply (is_derive_opp Qf), Q_derive.
- intros t Ht.
  assert (0 <= t * g1 t ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
  generalize (pow2_ge_0 (g2 t)); lra.
Qed.

Lemma Q_zero c : g c = 0 -> Qf c = g1 c * g2 c.
Proof. intros E. unfold Qf. rewrite E. ring. Qed.

(** At a zero c > 0 it is enough to have Q > 0 at one point of [0, c]. *)
Lemma Q_at_zero p c : 0 <= p <= c -> 0 < Qf p -> g c = 0 -> 0 < g1 c * g2 c.
Proof.
intros Hp HQ E. rewrite <- (Q_zero c E).
eapply Rlt_le_trans; [exact HQ|apply Q_mono; lra].
Qed.

(** first way: g'(0) g''(0) > 0 *)
Lemma Q_case_1 c : 0 <= b -> 0 < g1 0 * g2 0 -> 0 <= c -> g c = 0 -> 0 < g1 c * g2 c.
Proof.
intros Hb H0 Hc E. apply (Q_at_zero 0 c); auto; try lra.
unfold Qf. assert (0 <= b / 2 * g 0 ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra.
Qed.

(** second way: g(0) < 0 and g'(0) < 0: g has an inner minimum between 0 and the zero *)
Lemma Q_case_2 c : 0 < b -> g 0 < 0 -> g1 0 < 0 -> 0 < c -> g c = 0 -> 0 < g1 c * g2 c.
Proof.
intros Hb H0 H1 Hc E.
destruct (continuity_ab_min g 0 c (Rlt_le _ _ Hc)) as (p & Hmin & Hp).
{ intros x _. apply (derive_continuity g g1 D0). }
assert (Hgp : g p <= g 0) by (apply Hmin; lra).
assert (Hpc : p < c).
{ destruct (Rle_lt_or_eq_dec p c (proj2 Hp)) as [H|H]; auto. rewrite H, E in Hgp. lra. }
assert (Hp0 : 0 < p).
{ destruct (Rle_lt_or_eq_dec 0 p (proj1 Hp)) as [H|H]; auto. exfalso.
  assert (DL := proj1 (is_derive_Reals g 0 (g1 0)) (D0 0)).
  destruct (DL (- g1 0) ltac:(lra)) as [delta Hd].
  set (h := Rmin (delta / 2) c).
  assert (Hdp := cond_pos delta).
  assert (Hh : 0 < h) by (apply Rmin_pos; lra).
  assert (Hhd : h <= delta / 2) by apply Rmin_l.
  assert (Hhc : h <= c) by apply Rmin_r.
  specialize (Hd h ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)).
  rewrite Rplus_0_l in Hd. apply Rabs_def2 in Hd.
  assert (Hq : (g h - g 0) / h < 0) by lra.
  assert (Hgh : g h - g 0 < 0).
  { replace (g h - g 0) with ((g h - g 0) / h * h) by (field; lra). nra. }
  specialize (Hmin h ltac:(lra)). rewrite <- H in Hmin. lra. }
assert (Hcrit : g1 p = 0).
{ assert (pr : derivable_pt g p) by (exists (g1 p); apply is_derive_Reals, D0).
  rewrite <- (deriv_minimum g 0 c p pr Hp0 Hpc ltac:(intros x Hx1 Hx2; apply Hmin; lra)).
  symmetry. apply (derive_pt_eq_0 g p (g1 p) pr). apply is_derive_Reals, D0. }
apply (Q_at_zero p c); auto; try lra.
unfold Qf. rewrite Hcrit.
assert (0 < b / 2 * g p ^ 2).
{ apply Rmult_lt_0_compat; [lra|]. simpl. nra. }
lra.
Qed.

(** The lemma in full: Q is strictly increasing on t >= 0 unless g vanishes identically. *)
Lemma all_zero_at p : g p = 0 -> g1 p = 0 -> g2 p = 0 -> forall t, g t = 0.
Proof.
intros E0 E1 E2 t.
assert (D2' : forall s, is_derive g2 s (s * g1 s + - b * g s + 0)).
{ intros s. replace (s * g1 s + - b * g s + 0) with (s * g1 s - b * g s) by ring. apply D2. }
assert (H00 : forall T s : R, Rabs s <= T -> Rabs 0 <= 0) by (intros; rewrite Rabs_R0; apply Rle_refl).
set (K := 3 + Rabs p + Rabs (- b)).
set (E := fun s => g s ^ 2 + g1 s ^ 2 + g2 s ^ 2).
set (E' := fun s => 2 * g s * g1 s + 2 * g1 s * g2 s + 2 * g2 s * (s * g1 s + - b * g s + 0)).
assert (DE : forall s, is_derive E s (E' s)) by exact (E_derive g g1 g2 (fun _ => 0) (- b) D0 D1 D2').
assert (HB : forall s, Rabs s <= Rabs p -> - (K * E s) <= E' s <= K * E s).
{ intros s Hs.
  assert (HB := E'_bound g g1 g2 (fun _ => 0) (- b) (Rabs p) 0 (Rabs_pos p) (H00 (Rabs p)) s Hs).
  fold K in HB. change (Rabs (E' s) <= K * (E s + 0 ^ 2)) in HB.
  assert (H1 := Rle_abs (E' s)). assert (H2 := Rle_abs (- E' s)). rewrite Rabs_Ropp in H2. lra. }
assert (Ep : E p = 0) by (unfold E; rewrite E0, E1, E2; ring).
assert (DX : forall k s, is_derive (fun s => E s * exp (k * s)) s ((E' s + k * E s) * exp (k * s))).
{ intros k s. evar_last.
  - apply (is_derive_mult_R E (fun s => exp (k * s)) s (E' s) (k * exp (k * s))). apply DE.
    auto_derive; auto; ring.
  - ring. }
assert (HE : E 0 <= 0).
{ destruct (Rle_lt_dec 0 p) as [Hp|Hp].
  - assert (H : - (E p * exp (K * p)) <= - (E 0 * exp (K * 0))).
    { apply (decr_of_derive (fun s => - (E s * exp (K * s))) (fun s => - ((E' s + K * E s) * exp (K * s))) 0 p Hp).
      + intros s _. apply (is_derive_opp (fun s => E s * exp (K * s))), DX.
      + intros s Hs.
        assert (HBs := HB s ltac:(rewrite !Rabs_pos_eq; lra)).
        assert (0 <= (E' s + K * E s) * exp (K * s)).
        { apply Rmult_le_pos; [lra|apply Rlt_le, exp_pos]. }
        lra. }
    rewrite Rmult_0_r, exp_0, Ep in H. lra.
  - assert (H : E 0 * exp (- K * 0) <= E p * exp (- K * p)).
    { apply (decr_of_derive (fun s => E s * exp (- K * s)) (fun s => (E' s + - K * E s) * exp (- K * s)) p 0).
      + lra.
      + intros s _. apply DX.
      + intros s Hs.
        assert (HBs := HB s ltac:(rewrite !Rabs_left1; lra)).
        assert (0 <= (K * E s - E' s) * exp (- K * s)).
        { apply Rmult_le_pos; [lra|apply Rlt_le, exp_pos]. }
        lra. }
    rewrite Rmult_0_r, exp_0, Ep in H. lra. }
assert (H := gronwall_u0 g g1 g2 (fun _ => 0) (- b) (Rabs t) 0 (Rabs_pos t) D0 D1 D2' (H00 (Rabs t)) t (Rle_refl _)).
unfold E in HE.
replace (g 0 ^ 2 + g1 0 ^ 2 + g2 0 ^ 2 + 0 ^ 2) with 0 in H.
- nra.
- generalize (pow2_ge_0 (g 0)) (pow2_ge_0 (g1 0)) (pow2_ge_0 (g2 0)). simpl in *. lra.
Qed.

Theorem Q_strict x y : b <> 0 -> (exists t, g t <> 0) -> 0 <= x -> x < y -> Qf x < Qf y.
Proof.
intros Hb [t0 Ht0] Hx Hxy.
apply Rnot_le_lt. intros Hle. apply Ht0.
assert (EQ : forall t, x < t < y -> Qf t = Qf x).
{ intros t Ht. assert (H1 := Q_mono x t Hx ltac:(lra)). assert (H2 := Q_mono t y ltac:(lra) ltac:(lra)). lra. }
assert (Z : forall p, x < p < y -> g1 p = 0 /\ g2 p = 0).
{ intros p Hp. assert (H := derive_zero_of_const Qf _ x y (Qf x) p Q_derive Hp EQ). simpl in H.
  assert (H1 := pow2_ge_0 (g2 p)). assert (H2 := pow2_ge_0 (g1 p)).
  assert (0 <= p * g1 p ^ 2) by (apply Rmult_le_pos; lra).
  assert (Z2 : g2 p ^ 2 = 0) by (simpl in *; lra).
  assert (Z1 : p * g1 p ^ 2 = 0) by (simpl in *; lra).
  apply Rmult_integral in Z1. split; [destruct Z1; [lra|]|]; nra. }
set (p := (x + y) / 2). assert (Hp : x < p < y) by (unfold p; lra).
destruct (Z p Hp) as [Z1 Z2].
assert (Z3 := derive_zero_of_const g2 _ x y 0 p D2 Hp (fun t Ht => proj2 (Z t Ht))).
simpl in Z3. rewrite Z1 in Z3.
apply (all_zero_at p); auto.
apply Rmult_eq_reg_l with b; auto. lra.
Qed.

End Quantity.

(** Corollary: b in (m - 1, m), m >= 1; at every zero c > 0 of Theta(., b): Theta'(c) Theta''(c) > 0. *)
Theorem Theta_zero_QQ (m : nat) (b : R) (theta : R -> R) (c : R) :
  cell (S m) b -> is_Theta b theta -> 0 < c -> theta c = 0 ->
  0 < Derive theta c * Derive_n theta 2 c.
Proof.
intros Hb H Hc E.
destruct (is_Theta_elim b theta H) as (D0 & D1 & D2).
assert (S012 := Theta_signs_012 _ _ _ Hb H).
assert (Hb0 := proj2 (cell_S _ _ Hb)).
assert (Hm3 : (S m mod 3 < 3)%nat) by (apply Nat.mod_upper_bound; lia).
destruct (S m mod 3)%nat as [|[|[|k]]]; [| | |lia]; destruct S012 as (S0 & S1 & S2).
- apply (Q_case_1 b theta (Derive theta) (Derive_n theta 2)); auto; try lra.
  apply Rmult_lt_0_compat; auto.
- apply (Q_case_1 b theta (Derive theta) (Derive_n theta 2)); auto; try lra. nra.
- apply (Q_case_2 b theta (Derive theta) (Derive_n theta 2)); auto; try lra.
Qed.

(** The same in terms of the family: the next function at the zeros of this one. *)
Theorem Th_next_at_zero (m : nat) (b c : R) :
  cell (S (S m)) b -> 0 < c -> Th (b - 1) c = 0 ->
  0 < (- (b - 1) * Th (b - 2) c) * Th b c.
Proof.
intros Hb Hc E.
assert (Hn := cell_not_nat _ _ Hb).
destruct (cell_S _ _ Hb) as [Hb1 _].
assert (Hn1 := cell_not_nat _ _ Hb1).
assert (H := Theta_zero_QQ m (b - 1) (Th (b - 1)) c Hb1 (Th_correct _) Hc E).
rewrite (Theta_derive (b - 1) _ (Th (b - 1 - 1)) Hn1 (Th_correct _) (Th_correct _)) in H.
rewrite (Theta_derive_n 2 (b - 1) _ (Th (b - 1 - INR 2)) Hn1 (Th_correct _) (Th_correct _)) in H.
replace (b - 1 - 1) with (b - 2) in H by ring.
replace (b - 1 - INR 2) with (b - 3) in H by (simpl; ring).
rewrite (Th_rec b c Hn), E. simpl in H.
replace (- c * 0 + (b - 1) * (b - 2) * Th (b - 3) c)
  with (1 * (- (b - 1) + 0) * (- (b - 1) + 1) * Th (b - 3) c) by ring.
exact H.
Qed.
