(** * A solution is its Taylor series at any point

    f''' = t f' - b f. The coefficients at t0 satisfy the recurrence of proofs/check.md, section 2; by the tail lemma
    ([RecurrenceTail.v]) they are small, so the series has radius oo. It solves the equation with the values of f at t0,
    and there is one solution only. f' solves the equation with b - 1 and has the coefficients (k + 1) c_(k+1). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus Gronwall RecurrenceTail.
Open Scope R_scope.

Definition solves (b : R) (f f1 f2 : R -> R) : Prop :=
  (forall t, is_derive f t (f1 t)) /\ (forall t, is_derive f1 t (f2 t)) /\
    (forall t, is_derive f2 t (t * f1 t - b * f t)).

Lemma solves_slope b f f1 f2 : solves b f f1 f2 -> solves (b - 1) f1 f2 (fun t => t * f1 t - b * f t).
Proof.
intros (D0 & D1 & D2). split; [|split]; auto. intros t.
eapply is_derive_val. apply (is_derive_minus (fun t => t * f1 t) (fun t => b * f t)).
- apply (is_derive_mult_R (fun t => t) f1); [apply is_derive_id|apply D1].
- apply (is_derive_scal f), D0.
- unfold minus, plus, opp, scal, one; simpl; unfold mult; simpl. ring.
Qed.

Lemma solves_scal b f f1 f2 w : solves b f f1 f2 -> solves b (fun t => w * f t) (fun t => w * f1 t) (fun t => w * f2 t).
Proof.
intros (D0 & D1 & D2).
split; [|split]; intros t; try (apply (is_derive_scal f), D0); try (apply (is_derive_scal f1), D1).
eapply is_derive_val. apply (is_derive_scal f2), D2. ring.
Qed.

Lemma solves_unique b t0 f f1 f2 : solves b f f1 f2 -> f t0 = 0 -> f1 t0 = 0 -> f2 t0 = 0 -> forall t, f t = 0.
Proof.
intros (D0 & D1 & D2) H0 H1 H2 t.
set (T := Rmax (Rabs t0) (Rabs t)).
assert (D2' : forall t, is_derive f2 t (t * f1 t + - b * f t + 0)).
{ intros s. eapply is_derive_val; [apply D2|]. ring. }
assert (E : f t ^ 2 + f1 t ^ 2 + f2 t ^ 2 = 0).
{ apply (one_step_zero (fun t => f t ^ 2 + f1 t ^ 2 + f2 t ^ 2)
    (fun t => 2 * f t * f1 t + 2 * f1 t * f2 t + 2 * f2 t * (t * f1 t + - b * f t + 0)) t0 t (3 + T + Rabs (- b))).
  - intros s _. apply (E_derive f f1 f2 (fun _ => 0) (- b)); auto.
  - intros s. generalize (pow2_ge_0 (f s)) (pow2_ge_0 (f1 s)) (pow2_ge_0 (f2 s)). lra.
  - rewrite H0, H1, H2. ring.
  - intros s Hs. assert (Hb : Rabs s <= T).
    { unfold T. apply Rabs_le_between. generalize (Rmax_l (Rabs t0) (Rabs t)) (Rmax_r (Rabs t0) (Rabs t)).
      generalize (Rle_abs t0) (Rle_abs t) (Rle_abs (- t0)) (Rle_abs (- t)). rewrite !Rabs_Ropp.
      revert Hs. unfold Rmin, Rmax at 1. destruct (Rle_dec t0 t); intros; lra. }
    assert (Z : forall u, Rabs u <= T -> Rabs 0 <= 0) by (intros; rewrite Rabs_R0; apply Rle_refl).
    assert (B := E'_bound f f1 f2 (fun _ => 0) (- b) T 0 (Rle_trans _ _ _ (Rabs_pos t0) (Rmax_l _ _)) Z s Hb).
    cbv beta in B.
    replace (f s ^ 2 + f1 s ^ 2 + f2 s ^ 2 + 0 ^ 2) with (f s ^ 2 + f1 s ^ 2 + f2 s ^ 2) in B by ring. exact B. }
generalize (pow2_ge_0 (f t)) (pow2_ge_0 (f1 t)) (pow2_ge_0 (f2 t)). intros. apply Rsqr_0_uniq. unfold Rsqr. lra.
Qed.

Definition recurrence (b t0 : R) (c : nat -> R) : Prop := forall k,
  (INR k + 1) * (INR k + 2) * (INR k + 3) * c (k + 3)%nat = t0 * (INR k + 1) * c (k + 1)%nat + (INR k - b) * c k.

Lemma recurrence_slope b t0 c : recurrence b t0 c -> recurrence (b - 1) t0 (fun k => (INR k + 1) * c (S k)).
Proof.
intros H k. assert (R := H (S k)). rewrite S_INR in R. rewrite !plus_INR. simpl (INR 3). simpl (INR 1).
replace (S (k + 3)) with (S k + 3)%nat by lia. replace (S (k + 1)) with (S k + 1)%nat by lia.
replace ((INR k + 1) * (INR k + 2) * (INR k + 3) * ((INR k + (1 + 1 + 1) + 1) * c (S k + 3)%nat))
  with ((INR k + 1) * ((INR k + 1 + 1) * (INR k + 1 + 2) * (INR k + 1 + 3) * c (S k + 3)%nat)) by ring.
rewrite R. ring.
Qed.

(** The recurrence from given values. *)
Fixpoint three (b t0 y0 y1 y2 : R) (n : nat) : R * R * R :=
  match n with
  | O => (y0, y1, y2)
  | S n => let '(x0, x1, x2) := three b t0 y0 y1 y2 n in
      (x1, x2, (t0 * (INR n + 1) * x1 + (INR n - b) * x0) / ((INR n + 1) * (INR n + 2) * (INR n + 3)))
  end.

Definition from_values (b t0 y0 y1 y2 : R) (n : nat) : R := fst (fst (three b t0 y0 y1 y2 n)).

Lemma from_values_recurrence b t0 y0 y1 y2 : recurrence b t0 (from_values b t0 y0 y1 y2).
Proof.
intros k. assert (Hk := pos_INR k). unfold from_values.
replace (k + 3)%nat with (S (S (S k))) by lia. replace (k + 1)%nat with (S k) by lia. cbn [three].
destruct (three b t0 y0 y1 y2 k) as [[x0 x1] x2]. cbn [fst]. field. lra.
Qed.

Section Radius.
Variables (b t0 : R) (c : nat -> R).
Hypothesis Hc : recurrence b t0 c.

Lemma coefficients_bounded s : 0 < s -> exists M, forall n, Rabs (c n * s ^ n) <= M.
Proof.
intros Hs. set (B := Rmax 1 (Rabs b)). assert (B1 : 1 <= B) by apply Rmax_l. assert (Bb : Rabs b <= B) by apply Rmax_r.
set (Q := Rabs t0 * s ^ 2 + B * s ^ 3).
assert (S2 : 0 < s ^ 2) by (apply pow_lt, Hs). assert (S3 : 0 < s ^ 3) by (apply pow_lt, Hs).
assert (T0 : 0 <= Rabs t0 * s ^ 2) by (apply Rmult_le_pos; [apply Rabs_pos|lra]).
assert (HQ : 0 <= Q). { unfold Q. assert (0 <= B * s ^ 3) by (apply Rmult_le_pos; lra). lra. }
destruct (nfloor_ex Q HQ) as [I [_ HI]].
assert (Hr : ratio t0 s B I < 1).
{ unfold ratio. set (x := INR I) in *. assert (Hx : 0 <= x) by apply pos_INR.
  apply Rle_lt_trans with (Q / (x + 2)).
  - unfold Q. replace ((Rabs t0 * s ^ 2 + B * s ^ 3) / (x + 2)) with (Rabs t0 * s ^ 2 / (x + 2) + B * s ^ 3 / (x + 2))
      by (field; lra).
    apply Rplus_le_compat.
    + unfold Rdiv. apply Rmult_le_compat_l; auto. apply Rinv_le_contravar. lra. nra.
    + apply Rmult_le_reg_r with ((x + 1) * (x + 2) * (x + 3)). apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra.
      replace ((x + B) * s ^ 3 / ((x + 1) * (x + 2) * (x + 3)) * ((x + 1) * (x + 2) * (x + 3))) with (s ^ 3 * (x + B))
        by (field; lra).
      replace (B * s ^ 3 / (x + 2) * ((x + 1) * (x + 2) * (x + 3))) with (s ^ 3 * (B * ((x + 1) * (x + 3))))
        by (field; lra).
      apply Rmult_le_compat_l. lra. nra.
  - apply Rmult_lt_reg_r with (x + 2). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
set (mu := Rmax (size s c I) (Rmax (size s c (I + 1)) (size s c (I + 2)))).
exists (sum_f_R0 (fun n => size s c n) I + mu).
assert (P : forall n, 0 <= size s c n) by (intros n; apply size_pos, Hs).
assert (Mu : 0 <= mu) by (eapply Rle_trans; [apply (P I)|apply Rmax_l]).
intros n. rewrite Rabs_mult, (Rabs_pos_eq (s ^ n)) by (apply pow_le; lra). fold (size s c n).
destruct (le_lt_dec n I) as [H|H].
- assert (A : size s c n <= sum_f_R0 (fun n => size s c n) I).
  { clear - H P. induction I as [|k IH].
    - replace n with 0%nat by lia. simpl. lra.
    - simpl. destruct (Nat.eq_dec n (S k)) as [->|Hne].
      + assert (0 <= sum_f_R0 (fun n => size s c n) k) by (apply cond_pos_sum; auto). lra.
      + assert (A := IH ltac:(lia)). assert (B := P (S k)). lra. }
  lra.
- assert (Sum : 0 <= sum_f_R0 (fun n => size s c n) I) by (apply cond_pos_sum; auto).
  assert (Q0 : 0 <= ratio t0 s B I) by (apply ratio_pos; auto).
  assert (Pow : forall m, ratio t0 s B I ^ m * mu <= mu).
  { intros m. rewrite <- (Rmult_1_l mu) at 2. apply Rmult_le_compat_r; auto.
    rewrite <- (pow1 m). apply pow_incr. lra. }
  assert (D := Nat.div_mod (n - I) 3 ltac:(lia)). assert (L := Nat.mod_upper_bound (n - I) 3 ltac:(lia)).
  destruct (blocks b t0 s B c I Hs B1 Bb Hc Hr ((n - I) / 3)) as (B0' & B1' & B2'). fold mu in B0', B1', B2'.
  assert (Pm := Pow ((n - I) / 3)%nat).
  destruct ((n - I) mod 3)%nat as [|[|[|j]]] eqn:E; try lia.
  + replace n with (I + 3 * ((n - I) / 3))%nat by lia. lra.
  + replace n with (I + 3 * ((n - I) / 3) + 1)%nat by lia. lra.
  + replace n with (I + 3 * ((n - I) / 3) + 2)%nat by lia. lra.
Qed.

Lemma coefficients_radius : CV_radius c = p_infty.
Proof.
destruct (CV_radius_bounded c) as [Hub _].
assert (H : forall x, 0 < x -> Rbar_le (Finite x) (CV_radius c)).
{ intros x Hx. apply Hub. apply (coefficients_bounded x Hx). }
destruct (CV_radius c) as [x| |]; auto; exfalso.
- assert (A := H (Rmax 1 (x + 1)) ltac:(eapply Rlt_le_trans; [apply Rlt_0_1|apply Rmax_l])). simpl in A.
  assert (B := Rmax_r 1 (x + 1)). lra.
- exact (H 1 Rlt_0_1).
Qed.

Lemma radius_slope : CV_radius (PS_derive c) = p_infty.
Proof. rewrite CV_radius_derive. apply coefficients_radius. Qed.

Lemma series_solves : solves b (fun t => PSeries c (t - t0)) (fun t => PSeries (PS_derive c) (t - t0))
  (fun t => PSeries (PS_derive (PS_derive c)) (t - t0)).
Proof.
assert (Shift : forall (g g' : R -> R), (forall u, is_derive g u (g' u)) -> forall t, is_derive (fun t => g (t - t0)) t
  (g' (t - t0))).
{ intros g g' D t. eapply is_derive_val. apply (is_derive_comp g (fun t => t - t0)). apply D.
  instantiate (1 := 1). auto_derive; auto. apply Rmult_1_l. }
split; [|split].
- apply Shift. intros u. apply is_derive_PSeries. rewrite coefficients_radius. exact I.
- apply Shift. intros u. apply is_derive_PSeries. rewrite radius_slope. exact I.
- intros t. eapply is_derive_val.
  + apply (Shift (PSeries (PS_derive (PS_derive c))) (PSeries (PS_derive (PS_derive (PS_derive c))))).
    intros u. apply is_derive_PSeries. rewrite CV_radius_derive, radius_slope. exact I.
  + set (u := t - t0). replace t with (t0 + u) by (unfold u; ring).
    rewrite (PSeries_ext _ (PS_minus (PS_plus (PS_scal t0 (PS_derive c)) (PS_incr_1 (PS_derive c))) (PS_scal b c))).
    * assert (In : forall a x, CV_radius a = p_infty -> ex_pseries a x) by (intros a x E; apply CV_radius_inside;
        rewrite E; exact I).
      rewrite PSeries_minus, PSeries_plus, !PSeries_scal, PSeries_incr_1.
      -- simpl. ring.
      -- apply ex_pseries_scal. apply Rmult_comm. apply In, radius_slope.
      -- apply ex_pseries_incr_1, In, radius_slope.
      -- apply ex_pseries_plus. apply ex_pseries_scal. apply Rmult_comm. apply In, radius_slope.
         apply ex_pseries_incr_1, In, radius_slope.
      -- apply ex_pseries_scal. apply Rmult_comm. apply In, coefficients_radius.
    * intros n. unfold PS_derive, PS_minus, PS_plus, PS_scal, PS_incr_1, plus, opp, scal, zero; simpl; unfold mult;
        simpl.
      assert (H := Hc n). replace (n + 3)%nat with (S (S (S n))) in H by lia.
      replace (n + 1)%nat with (S n) in H by lia.
      fold (INR (S n)) (INR (S (S n))) (INR (S (S (S n)))).
      destruct n as [|n].
      -- simpl in *. lra.
      -- fold (INR (S n)) (INR (S (S n))) (INR (S (S (S n)))) (INR (S (S (S (S n))))). rewrite !S_INR in *.
         change (match n with 0%nat => 1 | S _ => INR n + 1 end) with (INR (S n)). rewrite S_INR. lra.
Qed.

Theorem solution_series f f1 f2 : solves b f f1 f2 -> c 0%nat = f t0 -> c 1%nat = f1 t0 -> 2 * c 2%nat = f2 t0 ->
  forall t, is_pseries c (t - t0) (f t).
Proof.
intros S C0 C1 C2 t. destruct S as (D0 & D1 & D2). destruct series_solves as (G0 & G1 & G2).
assert (E : f t - PSeries c (t - t0) = 0).
{ apply (solves_unique b t0 (fun t => f t - PSeries c (t - t0)) (fun t => f1 t - PSeries (PS_derive c) (t - t0))
    (fun t => f2 t - PSeries (PS_derive (PS_derive c)) (t - t0))).
  - split; [|split]; intros s.
    + apply (is_derive_minus f); auto.
    + apply (is_derive_minus f1); auto.
    + eapply is_derive_val. apply (is_derive_minus f2); auto. unfold minus, plus, opp; simpl. ring.
  - replace (t0 - t0) with 0 by ring. rewrite PSeries_0, C0. ring.
  - replace (t0 - t0) with 0 by ring. rewrite PSeries_0. unfold PS_derive. simpl. rewrite C1. ring.
  - replace (t0 - t0) with 0 by ring. rewrite PSeries_0. unfold PS_derive. simpl. rewrite <- C2. ring. }
replace (f t) with (PSeries c (t - t0)) by lra. apply PSeries_correct, CV_radius_inside. rewrite coefficients_radius.
exact I.
Qed.

End Radius.

(** What is left out of the sum. *)
Lemma rest_of_series (c : nat -> R) x y n M : is_pseries c x y ->
  (forall N, sum_first (fun i => Rabs (c (n + i)%nat * x ^ (n + i))) N <= M) ->
    Rabs (y - sum_first (fun k => c k * x ^ k) n) <= M.
Proof.
intros H HM.
assert (Sum : forall u w : R, plus u w = u + w) by reflexivity.
assert (Eq : forall k, sum_n (fun k => scal (pow_n x k) (c k)) k = sum_first (fun k => c k * x ^ k) (S k)).
{ induction k as [|k IH].
  - rewrite sum_O. simpl. unfold scal; simpl; unfold mult, one; simpl. ring.
  - rewrite sum_Sn, IH.
    change (sum_first (fun k => c k * x ^ k) (S (S k))) with (sum_first (fun k => c k * x ^ k) (S k)
      + c (S k) * x ^ S k).
    rewrite Sum, pow_n_pow. unfold scal; simpl; unfold mult; simpl. ring. }
assert (Part : forall N, Rabs (sum_first (fun k => c k * x ^ k) (n + N) - sum_first (fun k => c k * x ^ k) n) <= M).
{ intros N. eapply Rle_trans; [|apply (HM N)]. induction N as [|N IH].
  - rewrite Nat.add_0_r, Rminus_diag_eq, Rabs_R0 by reflexivity. simpl. lra.
  - replace (n + S N)%nat with (S (n + N)) by lia. simpl.
    replace (sum_first (fun k => c k * x ^ k) (n + N) + c (n + N)%nat * x ^ (n + N) - sum_first (fun k => c k * x ^ k)
      n)
      with ((sum_first (fun k => c k * x ^ k) (n + N) - sum_first (fun k => c k * x ^ k) n)
        + c (n + N)%nat * x ^ (n + N)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; [exact IH|lra]. }
apply Rnot_lt_le. intros Hlt.
set (A := sum_first (fun k => c k * x ^ k) n) in *.
assert (He : 0 < Rabs (y - A) - M) by lra.
assert (L : is_lim_seq (sum_n (fun k => scal (pow_n x k) (c k))) y) by exact H.
apply is_lim_seq_spec in L. destruct (L (mkposreal _ He)) as [K HK]. simpl in HK.
assert (HK' := HK (n + K)%nat ltac:(lia)). rewrite Eq in HK'.
assert (P := Part (S K)). replace (n + S K)%nat with (S (n + K)) in P by lia.
set (S' := sum_first (fun k => c k * x ^ k) (S (n + K))) in *.
assert (Tr : Rabs (y - A) <= Rabs (S' - A) + Rabs (S' - y)).
{ replace (y - A) with ((S' - A) + - (S' - y)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp.
  lra. }
lra.
Qed.

(** All derivatives at t0. *)
Lemma Derive_n_coefficient : forall k b t0 c f f1 f2, solves b f f1 f2 -> recurrence b t0 c ->
  c 0%nat = f t0 -> c 1%nat = f1 t0 -> 2 * c 2%nat = f2 t0 -> Derive_n f k t0 = INR (fact k) * c k.
Proof.
induction k as [|k IH]; intros b t0 c f f1 f2 H R C0 C1 C2.
- simpl. rewrite C0. ring.
- replace (Derive_n f (S k) t0) with (Derive_n f1 k t0).
  + rewrite (IH (b - 1) t0 (fun k => (INR k + 1) * c (S k)) f1 f2 (fun t => t * f1 t - b * f t)).
    * rewrite fact_simpl, mult_INR, S_INR. ring.
    * apply (solves_slope b f f1 f2), H.
    * apply recurrence_slope, R.
    * simpl. rewrite C1. ring.
    * simpl. rewrite <- C2. ring.
    * assert (R0 := R 0%nat). simpl in *. rewrite <- C0, <- C1. lra.
  + rewrite <- (Nat.add_1_r k), <- Derive_n_comp. apply Derive_n_ext. intros t. symmetry. apply is_derive_unique, H.
Qed.
