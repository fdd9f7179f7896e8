(** * The second order at t -> -oo

    A family f_0, f_1, ... with f_k' = f_(k+1) and the moment recurrence of the integrals int r^(s+k) e^(rt - r^3/3 + h)
    dr at the scale eta (eta = 0: those of Theta). For s + k > -1, where the integrals converge, f_k(-x) = Gamma(s+k+1)
    x^-(s+k+1) - Gamma(s+k+4)/3 x^-(s+k+4) up to O(x^-(s+k+5)); the recurrence carries this to every index. The two
    terms do not depend on eta. So two families with the same s, at two scales, differ by O(x^-(s+k+5)), and an
    inequality between them for s + k > -1 goes down to s + k > -5: the difference has a positive derivative, and tends
    to 0 as t -> -oo. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus GammaFunction ImproperIntegral CompliantKernel CompliantIntegral.
Open Scope R_scope.

(** g = O(x^-q) on x >= 1 *)
Definition small (q : R) (g : R -> R) : Prop := exists C, forall x, 1 <= x -> Rabs (g x) <= C * Rpower x (- q).

Lemma small_ext q g h : (forall x, 1 <= x -> g x = h x) -> small q g -> small q h.
Proof. intros E [C H]. exists C. intros x Hx. rewrite <- E; auto. Qed.

Lemma small_plus q g h : small q g -> small q h -> small q (fun x => g x + h x).
Proof.
intros [C H] [D K]. exists (C + D). intros x Hx. eapply Rle_trans; [apply Rabs_triang|].
specialize (H x Hx). specialize (K x Hx). lra.
Qed.

Lemma small_scal q c g : small q g -> small q (fun x => c * g x).
Proof.
intros [C H]. exists (Rabs c * C). intros x Hx. rewrite Rabs_mult, Rmult_assoc.
apply Rmult_le_compat_l; auto using Rabs_pos.
Qed.

Lemma small_minus q g h : small q g -> small q h -> small q (fun x => g x - h x).
Proof.
intros H K. apply (small_ext q (fun x => g x + -1 * h x)). intros; ring.
apply small_plus; auto. apply small_scal, K.
Qed.

Lemma small_power q : small q (fun x => Rpower x (- q)).
Proof. exists 1. intros x Hx. rewrite Rabs_pos_eq; [lra|apply Rlt_le, exp_pos]. Qed.

Lemma Rpower_split x u (n : nat) v : 0 < x -> u = INR n + v -> Rpower x u = x ^ n * Rpower x v.
Proof. intros Hx ->. rewrite Rpower_plus, Rpower_pow by auto. reflexivity. Qed.

Lemma small_weaken q (n : nat) g : small (q + INR n) g -> small q g.
Proof.
intros [C H]. exists (Rabs C). intros x Hx. specialize (H x Hx).
eapply Rle_trans; [exact H|].
rewrite (Rpower_split x (- q) n (- (q + INR n))) by (lra || ring).
assert (P : 0 < Rpower x (- (q + INR n))) by apply exp_pos.
assert (1 <= x ^ n) by (apply pow_R1_Rle, Hx).
assert (HC := Rle_abs C). assert (HC0 := Rabs_pos C).
apply Rle_trans with (Rabs C * (1 * Rpower x (- (q + INR n)))).
- rewrite Rmult_1_l. apply Rmult_le_compat_r; lra.
- apply Rmult_le_compat_l; auto. apply Rmult_le_compat_r; lra.
Qed.

Lemma small_mult q (n : nat) g : small (q + INR n) g -> small q (fun x => x ^ n * g x).
Proof.
intros [C H]. exists C. intros x Hx. specialize (H x Hx).
rewrite (Rpower_split x (- q) n (- (q + INR n))) by (lra || ring).
assert (P : 0 <= x ^ n) by (apply pow_le; lra).
rewrite Rabs_mult, (Rabs_pos_eq _ P).
apply (Rmult_le_compat_l (x ^ n)) in H; auto. lra.
Qed.

(** What tends to 0 at -oo and has a positive slope is positive. *)
Lemma small_lim q g : 0 < q -> small q g -> forall d, 0 < d -> exists M, 1 <= M /\ forall x, M <= x -> Rabs (g x) < d.
Proof.
intros Hq [C H] d Hd.
set (A := Rabs C + 1). assert (HA : 0 < A) by (unfold A; generalize (Rabs_pos C); lra).
set (M := exp (Rabs (ln (A / d)) / q + 1)).
assert (HM0 : 0 <= Rabs (ln (A / d)) / q).
{ apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, Hq. }
assert (HM : 1 <= M).
{ rewrite <- exp_0 at 1. apply exp_le. lra. }
exists M. split; auto. intros x Hx. eapply Rle_lt_trans; [apply H; lra|].
assert (HP : 0 < Rpower x (- q)) by apply exp_pos.
apply Rle_lt_trans with (Rabs C * Rpower x (- q)).
{ apply Rmult_le_compat_r. lra. apply Rle_abs. }
apply Rlt_le_trans with (A * Rpower x (- q)).
{ apply Rmult_lt_compat_r; auto. unfold A; lra. }
assert (Hln : Rabs (ln (A / d)) / q + 1 <= ln x).
{ replace (Rabs (ln (A / d)) / q + 1) with (ln M) by apply ln_exp.
  destruct (Rle_lt_or_eq_dec _ _ Hx) as [Hl|<-]; [|apply Rle_refl]. apply Rlt_le, ln_increasing; lra. }
assert (Hk : ln (A / d) <= q * ln x).
{ apply Rle_trans with (q * (Rabs (ln (A / d)) / q)).
  - replace (q * (Rabs (ln (A / d)) / q)) with (Rabs (ln (A / d))) by (field; lra). apply Rle_abs.
  - apply Rmult_le_compat_l; lra. }
assert (HAd : 0 < A / d) by (apply Rdiv_lt_0_compat; auto).
unfold Rpower. replace (- q * ln x) with (- (q * ln x)) by ring.
rewrite exp_Ropp.
apply Rmult_le_reg_r with (exp (q * ln x)). apply exp_pos.
rewrite Rmult_assoc, Rinv_l, Rmult_1_r by (apply Rgt_not_eq, exp_pos).
apply exp_le in Hk. rewrite exp_ln in Hk by auto.
apply (Rmult_le_compat_l d) in Hk; [|lra]. replace (d * (A / d)) with A in Hk by (field; lra). exact Hk.
Qed.

Lemma positive_from_left (f df : R -> R) q : (forall t, is_derive f t (df t)) -> (forall t, 0 < df t) ->
  0 < q -> small q (fun x => f (- x)) -> forall t, 0 < f t.
Proof.
intros D Hp Hq Hs t. apply Rnot_le_lt. intros Hle.
assert (Inc : forall u v, u < v -> f u < f v).
{ intros u v Huv. destruct (mvt_open f df u v Huv (fun s _ => D s)) as (c & _ & E).
  assert (0 < df c * (v - u)) by (apply Rmult_lt_0_compat; auto; lra). lra. }
assert (H1 := Inc (t - 1) t ltac:(lra)).
destruct (small_lim q _ Hq Hs (- f (t - 1)) ltac:(lra)) as (M & HM & H).
set (x := Rmax M (2 - t)). assert (X1 : M <= x) by apply Rmax_l. assert (X2 : 2 - t <= x) by apply Rmax_r.
specialize (H x X1). assert (H2 := Inc (- x) (t - 1) ltac:(lra)).
apply Rabs_def2 in H. lra.
Qed.

Lemma nonnegative_from_left (f df : R -> R) q : (forall t, is_derive f t (df t)) -> (forall t, 0 <= df t) ->
  0 < q -> small q (fun x => f (- x)) -> forall t, 0 <= f t.
Proof.
intros D Hp Hq Hs t. apply Rnot_lt_le. intros Hlt.
destruct (small_lim q _ Hq Hs (- f t) ltac:(lra)) as (M & HM & H).
set (x := Rmax M (1 - t)). assert (X1 : M <= x) by apply Rmax_l. assert (X2 : 1 - t <= x) by apply Rmax_r.
specialize (H x X1).
destruct (mvt_open f df (- x) t ltac:(lra) (fun s _ => D s)) as (c & _ & E).
assert (0 <= df c * (t - - x)) by (apply Rmult_le_pos; auto; lra).
apply Rabs_def2 in H. lra.
Qed.

(** ** The expansion *)

Definition left_rest (s : R) (f : R -> R) : Prop :=
  small (s + 5) (fun x => f (- x) - (Gamma (s + 1) * Rpower x (- (s + 1)) - Gamma (s + 4) / 3 * Rpower x (- (s + 4)))).

(** It holds for an integral with the weight e^g, if e^g = 1 - r^3/3 up to A r^4 + B r^6. *)
Lemma left_rest_integral s (f g : R -> R) A B : -1 < s ->
  (forall x, 0 < x -> is_RInt_gen (fun r => Rpower r s * exp (g r + r * - x)) (at_right 0) (Rbar_locally p_infty)
    (f (- x))) ->
  (forall r, 0 < r -> 0 <= exp (g r) - 1 + r ^ 3 / 3 <= A * r ^ 4 + B * r ^ 6) -> left_rest s f.
Proof.
intros Hs Hf Hg.
apply (small_ext (s + 5) (fun x => f (- x) - (Gamma (s + 1) * Rpower x (- (s + 1)) - Gamma (s + 4) / 3 * Rpower x
  (- (s + 4))))).
{ reflexivity. }
exists (Rabs A * Gamma (s + 5) + Rabs B * Gamma (s + 7)). intros x Hx.
assert (Hx0 : 0 < x) by lra.
assert (G1 := Gamma_scaled (s + 1) x ltac:(lra) Hx0). assert (G4 := Gamma_scaled (s + 4) x ltac:(lra) Hx0).
assert (G5 := Gamma_scaled (s + 5) x ltac:(lra) Hx0). assert (G7 := Gamma_scaled (s + 7) x ltac:(lra) Hx0).
replace (s + 1 - 1) with s in G1 by ring. replace (s + 4 - 1) with (s + 3) in G4 by ring.
replace (s + 5 - 1) with (s + 4) in G5 by ring. replace (s + 7 - 1) with (s + 6) in G7 by ring.
assert (F := Hf x Hx0).
assert (P1 := is_RInt_gen_plus _ _ _ _ (is_RInt_gen_minus _ _ _ _ F G1) (is_RInt_gen_scal _ (/ 3) _ G4)).
assert (P2 := is_RInt_gen_minus _ _ _ _
  (is_RInt_gen_plus _ _ _ _ (is_RInt_gen_scal _ (Rabs A) _ G5) (is_RInt_gen_scal _ (Rabs B) _ G7)) P1).
assert (K : forall r, 0 < r ->
  0 <= Rpower r s * exp (g r + r * - x) - Rpower r s * exp (- (x * r)) + / 3 * (Rpower r (s + 3) * exp (- (x * r)))
    <= Rabs A * (Rpower r (s + 4) * exp (- (x * r))) + Rabs B * (Rpower r (s + 6) * exp (- (x * r)))).
{ intros r Hr. specialize (Hg r Hr).
  rewrite (Rpower_split r (s + 3) 3 s), (Rpower_split r (s + 4) 4 s), (Rpower_split r (s + 6) 6 s)
    by (auto; simpl; ring).
  replace (g r + r * - x) with (g r + - (x * r)) by ring. rewrite exp_plus.
  set (P := Rpower r s). assert (HP : 0 < P) by apply exp_pos.
  set (X := exp (- (x * r))). assert (HX : 0 < X) by apply exp_pos.
  replace (P * (exp (g r) * X) - P * X + / 3 * (r ^ 3 * P * X)) with (P * X * (exp (g r) - 1 + r ^ 3 / 3)) by field.
  replace (Rabs A * (r ^ 4 * P * X) + Rabs B * (r ^ 6 * P * X)) with (P * X * (Rabs A * r ^ 4 + Rabs B * r ^ 6))
    by ring.
  assert (HPX : 0 < P * X) by (apply Rmult_lt_0_compat; auto).
  assert (A * r ^ 4 <= Rabs A * r ^ 4) by (apply Rmult_le_compat_r; [apply pow_le; lra|apply Rle_abs]).
  assert (B * r ^ 6 <= Rabs B * r ^ 6) by (apply Rmult_le_compat_r; [apply pow_le; lra|apply Rle_abs]).
  split. apply Rmult_le_pos; lra. apply Rmult_le_compat_l; lra. }
apply improper_pos in P1.
2: { intros r Hr. exact (proj1 (K r Hr)). }
apply improper_pos in P2.
2: { intros r Hr. assert (H := proj2 (K r Hr)).
     unfold scal, minus, plus, opp; simpl; unfold mult; simpl. simpl in H. lra. }
unfold scal, minus, plus, opp in P1, P2; simpl in P1, P2; unfold mult in P1, P2; simpl in P1, P2.
assert (E7 : Rpower x (- (s + 5)) = x ^ 2 * Rpower x (- (s + 7))) by (apply Rpower_split; [auto|simpl; ring]).
assert (P7 : Rpower x (- (s + 7)) <= Rpower x (- (s + 5))).
{ rewrite E7. rewrite <- (Rmult_1_l (Rpower x (- (s + 7)))) at 1. apply Rmult_le_compat_r. apply Rlt_le, exp_pos. nra. }
assert (H7 : Rabs B * (Rpower x (- (s + 7)) * Gamma (s + 7)) <= Rabs B * (Rpower x (- (s + 5)) * Gamma (s + 7))).
{ apply Rmult_le_compat_l. apply Rabs_pos. apply Rmult_le_compat_r; auto. apply Rlt_le, Gamma_pos; lra. }
rewrite Rabs_pos_eq; lra.
Qed.

Lemma Gamma_step x y : y = x + 1 -> x <> 0 -> Gamma y = x * Gamma x.
Proof. intros -> Hx. apply Gamma_rec, Hx. Qed.

(** One step down by the recurrence. *)
Lemma left_rest_step s eta (f0 f1 f2 f3 f4 : R -> R) : ok s ->
  (forall t, (s + 1) * f0 t + ((s + 2) * eta + t) * f1 t + t * eta * f2 t - f3 t - eta / 2 * f4 t = 0) ->
  left_rest (s + 1) f1 -> left_rest (s + 2) f2 -> left_rest (s + 3) f3 -> left_rest (s + 4) f4 -> left_rest s f0.
Proof.
intros Hs Hrec H1 H2 H3 H4.
assert (N1 := Hs 0%nat). assert (N2 := Hs 1%nat). assert (N3 := Hs 2%nat). assert (N4 := Hs 3%nat).
assert (N5 := Hs 4%nat).
simpl in N1, N2, N3, N4, N5.
unfold left_rest in *.
set (r1 := fun x => f1 (- x) - _) in H1. set (r2 := fun x => f2 (- x) - _) in H2.
set (r3 := fun x => f3 (- x) - _) in H3. set (r4 := fun x => f4 (- x) - _) in H4.
assert (S1 : small (s + 5) (fun x => x ^ 1 * r1 x)).
{ apply small_mult. replace (s + 5 + INR 1) with (s + 1 + 5) by (simpl; ring). exact H1. }
assert (S1' : small (s + 5) r1).
{ apply (small_weaken _ 1). replace (s + 5 + INR 1) with (s + 1 + 5) by (simpl; ring). exact H1. }
assert (S2 : small (s + 5) (fun x => x ^ 1 * r2 x)).
{ apply small_mult. apply (small_weaken _ 1). replace (s + 5 + INR 1 + INR 1) with (s + 2 + 5) by (simpl; ring).
  exact H2. }
assert (S3 : small (s + 5) r3).
{ apply (small_weaken _ 3). replace (s + 5 + INR 3) with (s + 3 + 5) by (simpl; ring). exact H3. }
assert (S4 : small (s + 5) r4).
{ apply (small_weaken _ 4). replace (s + 5 + INR 4) with (s + 4 + 5) by (simpl; ring). exact H4. }
assert (Q5 := small_power (s + 5)).
assert (Q7 : small (s + 5) (fun x => Rpower x (- (s + 7)))).
{ apply (small_weaken _ 2). replace (s + 5 + INR 2) with (s + 7) by (simpl; ring). apply small_power. }
assert (Q8 : small (s + 5) (fun x => Rpower x (- (s + 8)))).
{ apply (small_weaken _ 3). replace (s + 5 + INR 3) with (s + 8) by (simpl; ring). apply small_power. }
set (c5 := (s + 2) * eta * (Gamma (s + 5) / 3) - eta * (Gamma (s + 6) / 3) + eta / 2 * Gamma (s + 5)).
assert (S := small_scal _ (/ (s + 1)) _
  (small_plus _ _ _ (small_plus _ _ _ (small_plus _ _ _ S1 (small_scal _ (- ((s + 2) * eta)) _ S1'))
  (small_plus _ _ _ (small_scal _ eta _ S2) (small_plus _ _ _ S3 (small_scal _ (eta / 2) _ S4))))
  (small_plus _ _ _ (small_scal _ c5 _ Q5)
    (small_plus _ _ _ (small_scal _ (- (Gamma (s + 7) / 3)) _ Q7) (small_scal _ (- (eta / 2 * (Gamma (s + 8) / 3)))
      _ Q8))))).
eapply small_ext; [|exact S]. clear S S1 S1' S2 S3 S4 Q5 Q7 Q8 H1 H2 H3 H4.
intros x Hx. simpl. unfold r1, r2, r3, r4, c5.
assert (R := Hrec (- x)).
replace (s + 1 + 1) with (s + 2) by ring. replace (s + 1 + 4) with (s + 5) by ring.
replace (s + 2 + 1) with (s + 3) by ring. replace (s + 2 + 4) with (s + 6) by ring.
replace (s + 3 + 1) with (s + 4) by ring. replace (s + 3 + 4) with (s + 7) by ring.
replace (s + 4 + 1) with (s + 5) by ring. replace (s + 4 + 4) with (s + 8) by ring.
rewrite (Gamma_step (s + 1) (s + 2)) by lra.
rewrite (Gamma_step (s + 2) (s + 3)) by lra. rewrite (Gamma_step (s + 1) (s + 2)) by lra.
rewrite (Gamma_step (s + 5) (s + 6)) by lra. rewrite (Gamma_step (s + 4) (s + 5)) by lra.
rewrite (Rpower_split x (- (s + 1)) 7 (- (s + 8))) by (lra || (simpl; ring)).
rewrite (Rpower_split x (- (s + 2)) 6 (- (s + 8))) by (lra || (simpl; ring)).
rewrite (Rpower_split x (- (s + 3)) 5 (- (s + 8))) by (lra || (simpl; ring)).
rewrite (Rpower_split x (- (s + 4)) 4 (- (s + 8))) by (lra || (simpl; ring)).
rewrite (Rpower_split x (- (s + 5)) 3 (- (s + 8))) by (lra || (simpl; ring)).
rewrite (Rpower_split x (- (s + 6)) 2 (- (s + 8))) by (lra || (simpl; ring)).
rewrite (Rpower_split x (- (s + 7)) 1 (- (s + 8))) by (lra || (simpl; ring)).
set (Y := Rpower x (- (s + 8))). clearbody Y.
assert (F : f0 (- x) = / (s + 1) * (- ((s + 2) * eta + - x) * f1 (- x) + x * eta * f2 (- x) + f3 (- x) + eta / 2 * f4
  (- x))).
{ apply (Rmult_eq_reg_l (s + 1)); [|lra]. rewrite <- Rmult_assoc, Rinv_r by lra. lra. }
rewrite F. field. lra.
Qed.

(** ** Families *)

Definition family (eta s : R) (f : nat -> R -> R) : Prop :=
  (forall k t, is_derive (f k) t (f (S k) t)) /\
  (forall k t, let q := s + INR k in
     (q + 1) * f k t + ((q + 2) * eta + t) * f (k + 1)%nat t + t * eta * f (k + 2)%nat t - f (k + 3)%nat t - eta / 2 * f
       (k + 4)%nat t = 0) /\
  (forall k, -1 < s + INR k -> left_rest (s + INR k) (f k)).

Lemma family_left eta s f : ok s -> family eta s f -> forall k, left_rest (s + INR k) (f k).
Proof.
intros Hs (_ & Hrec & Hbase).
assert (H : forall n k, -1 < s + INR k + INR n -> left_rest (s + INR k) (f k)).
{ induction n as [|n IH]; intros k Hk.
  - apply Hbase. simpl in Hk. lra.
  - rewrite S_INR in Hk.
    assert (L : forall j, (1 <= j)%nat -> left_rest (s + INR k + INR j) (f (k + j)%nat)).
    { intros j Hj. replace (s + INR k + INR j) with (s + INR (k + j)) by (rewrite plus_INR; ring).
      apply IH. rewrite plus_INR. apply (le_INR 1) in Hj. simpl in Hj. lra. }
    assert (L1 := L 1%nat (le_n _)). assert (L2 := L 2%nat ltac:(lia)). assert (L3 := L 3%nat ltac:(lia)).
    assert (L4 := L 4%nat ltac:(lia)).
    apply (left_rest_step (s + INR k) eta (f k) (f (k + 1)%nat) (f (k + 2)%nat) (f (k + 3)%nat) (f (k + 4)%nat)).
    + apply ok_plus, Hs.
    + apply Hrec.
    + exact L1.
    + replace (s + INR k + 2) with (s + INR k + INR 2) by (simpl; ring). exact L2.
    + replace (s + INR k + 3) with (s + INR k + INR 3) by (simpl; ring). exact L3.
    + replace (s + INR k + 4) with (s + INR k + INR 4) by (simpl; ring). exact L4. }
intros k. destruct (ex_valid (s + INR k)) as [n Hn]. apply (H n k Hn).
Qed.

(** A chain of derivatives, positive from some index on and each tending to 0, is positive. *)
Lemma chain_positive (s lo : R) (f : nat -> R -> R) : (forall k t, is_derive (f k) t (f (S k) t)) ->
  (forall k, lo < s + INR k -> small (s + INR k - lo) (fun x => f k (- x))) ->
  (forall k t, -1 < s + INR k -> 0 < f k t) -> forall k t, lo < s + INR k -> 0 < f k t.
Proof.
intros D Hs Hp.
assert (H : forall n k t, lo < s + INR k -> -1 < s + INR k + INR n -> 0 < f k t).
{ induction n as [|n IH]; intros k t Hk Hn.
  - apply Hp. simpl in Hn. lra.
  - rewrite S_INR in Hn. apply (positive_from_left (f k) (f (S k)) (s + INR k - lo)); auto; [|lra].
    intros u. apply IH; rewrite S_INR; lra. }
intros k t Hk. destruct (ex_valid (s + INR k)) as [n Hn]. apply (H n k t Hk Hn).
Qed.

Lemma chain_nonnegative (s lo : R) (f : nat -> R -> R) : (forall k t, is_derive (f k) t (f (S k) t)) ->
  (forall k, lo < s + INR k -> small (s + INR k - lo) (fun x => f k (- x))) ->
  (forall k t, -1 < s + INR k -> 0 <= f k t) -> forall k t, lo < s + INR k -> 0 <= f k t.
Proof.
intros D Hs Hp.
assert (H : forall n k t, lo < s + INR k -> -1 < s + INR k + INR n -> 0 <= f k t).
{ induction n as [|n IH]; intros k t Hk Hn.
  - apply Hp. simpl in Hn. lra.
  - rewrite S_INR in Hn. apply (nonnegative_from_left (f k) (f (S k)) (s + INR k - lo)); auto; [|lra].
    intros u. apply IH; rewrite S_INR; lra. }
intros k t Hk. destruct (ex_valid (s + INR k)) as [n Hn]. apply (H n k t Hk Hn).
Qed.

Section Two.
Variables (s eta eta' : R) (f g : nat -> R -> R).
Hypothesis Hs : ok s.
Hypothesis Hf : family eta s f.
Hypothesis Hg : family eta' s g.

Lemma difference_small k : small (s + INR k + 5) (fun x => g k (- x) - f k (- x)).
Proof.
assert (F := family_left eta s f Hs Hf k). assert (G := family_left eta' s g Hs Hg k).
unfold left_rest in F, G. eapply small_ext; [|exact (small_minus _ _ _ G F)]. intros x _. simpl. ring.
Qed.

Lemma left_small k : small (s + INR k + 1) (fun x => g k (- x)).
Proof.
assert (G := family_left eta' s g Hs Hg k). unfold left_rest in G.
assert (G' : small (s + INR k + 1) (fun x => g k (- x) -
  (Gamma (s + INR k + 1) * Rpower x (- (s + INR k + 1)) - Gamma (s + INR k + 4) / 3 * Rpower x (- (s + INR k + 4))))).
{ apply (small_weaken _ 4). replace (s + INR k + 1 + INR 4) with (s + INR k + 5) by (simpl; ring). exact G. }
assert (P1 := small_scal _ (Gamma (s + INR k + 1)) _ (small_power (s + INR k + 1))).
assert (P4 : small (s + INR k + 1) (fun x => - (Gamma (s + INR k + 4) / 3) * Rpower x (- (s + INR k + 4)))).
{ apply small_scal, (small_weaken _ 3). replace (s + INR k + 1 + INR 3) with (s + INR k + 4) by (simpl; ring).
  apply small_power. }
eapply small_ext; [|exact (small_plus _ _ _ G' (small_plus _ _ _ P1 P4))]. intros x _. simpl. ring.
Qed.

Theorem family_order : (forall k t, -1 < s + INR k -> f k t < g k t) -> forall k t, -5 < s + INR k -> f k t < g k t.
Proof.
intros H k t Hk.
enough (0 < g k t - f k t) by lra.
apply (chain_positive s (-5) (fun k t => g k t - f k t)); auto.
- intros j u. apply (is_derive_minus (g j) (f j)). apply Hg. apply Hf.
- intros j Hj. replace (s + INR j - -5) with (s + INR j + 5) by ring. apply difference_small.
- intros j u Hj. specialize (H j u Hj). lra.
Qed.

Theorem family_upper c : (forall k t, -1 < s + INR k -> g k t <= f k t + c * g (k + 4)%nat t) ->
  forall k t, -5 < s + INR k -> g k t <= f k t + c * g (k + 4)%nat t.
Proof.
intros H k t Hk.
enough (0 <= c * g (k + 4)%nat t - (g k t - f k t)) by lra.
apply (chain_nonnegative s (-5) (fun k t => c * g (k + 4)%nat t - (g k t - f k t))); auto.
- intros j u. apply (is_derive_minus (fun t => c * g (j + 4)%nat t) (fun t => g j t - f j t)).
  + apply (is_derive_scal (g (j + 4)%nat)). apply Hg.
  + apply (is_derive_minus (g j) (f j)). apply Hg. apply Hf.
- intros j Hj. replace (s + INR j - -5) with (s + INR j + 5) by ring.
  apply (small_minus _ (fun x => c * g (j + 4)%nat (- x))); [|apply difference_small].
  apply small_scal. replace (s + INR j + 5) with (s + INR (j + 4) + 1) by (rewrite plus_INR; simpl; ring).
  apply left_small.
- intros j u Hj. specialize (H j u Hj). lra.
Qed.

End Two.
