(** * The ends of the line, and half-lines

    The sign of Gamma on its cells. Every Gamma(-b) Theta^(n) tends to +oo as t -> +oo: for n > b it is positive and
    increasing, and going down from n + 1 to n a slope that stays above a constant gives +oo. dTheta/dtau < 0 far to the
    left, from Theta(., b - 1) ~ (-t)^(b-1). The tail lemma of proofs/tails.md: one change of sign in the derivatives at
    T gives exactly one zero beyond T, down from the highest derivative, each having the pattern "negative, one zero,
    positive" or "positive". *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus GammaFunction LaplaceIntegral WellPosed EnvelopingSeries Family
  IntegerPolynomials PolynomialSum.
Open Scope R_scope.

Theorem Gamma_sign m : forall b, INR m < b < INR m + 1 -> 0 < (-1) ^ (m + 1) * Gamma (- b).
Proof.
induction m as [|m IH]; intros b Hb.
- assert (H := Gamma_neg b ltac:(simpl in Hb; lra)). simpl. lra.
- rewrite S_INR in Hb. assert (H := IH (b - 1) ltac:(lra)).
  replace (- (b - 1)) with (- b + 1) in H by ring. assert (Hm := pos_INR m).
  rewrite Gamma_rec in H by lra. rewrite Nat.add_1_r in *.
  replace ((-1) ^ S (S m) * Gamma (- b)) with (/ b * ((-1) ^ S m * (- b * Gamma (- b)))) by (simpl; field; lra).
  apply Rmult_lt_0_compat; auto. apply Rinv_0_lt_compat; lra.
Qed.

Section Ends.
Variables (b : R) (theta : R -> R).
Hypothesis Hb : not_nat b.
Hypothesis HT : is_Theta b theta.

(** Gamma(-b) Theta^(n) *)
Definition scaled (n : nat) (t : R) : R := Gamma (- b) * Derive_n theta n t.

Lemma scaled_derive n t : is_derive (scaled n) t (scaled (S n) t).
Proof.
destruct (Theta_Laplace_n b theta n Hb HT) as (y1 & _ & D & _).
replace (scaled (S n) t) with (Derive (scaled n) t).
- apply Derive_correct. exists (y1 t). exact (D t).
- unfold scaled. rewrite Derive_scal. reflexivity.
Qed.

Lemma scaled_pos n t : b < INR n -> 0 < scaled n t.
Proof. intros Hn. exact (Theta_sign b theta n Hb Hn HT t). Qed.

Lemma scaled_right_high n : b < INR n -> forall M, exists T, forall t, T <= t -> M <= scaled n t.
Proof.
intros Hn M.
assert (Hn1 : b < INR (S n)) by (rewrite S_INR; lra). assert (Hn2 : b < INR (S (S n))) by (rewrite !S_INR; lra).
destruct (grow (scaled n) (scaled (S n)) (scaled (S n) 0) 0 (scaled_derive n) (scaled_pos (S n) 0 Hn1)) with (M := M)
  as (T & _ & H).
- intros t Ht. destruct (Rle_lt_or_eq_dec 0 t Ht) as [H|<-]; [|lra].
  destruct (mvt_open _ _ 0 t H (fun s _ => scaled_derive (S n) s)) as (c & _ & E).
  assert (Hp := scaled_pos (S (S n)) c Hn2).
  assert (0 < scaled (S (S n)) c * (t - 0)) by (apply Rmult_lt_0_compat; lra). lra.
- exists T. exact H.
Qed.

Theorem scaled_right n : forall M, exists T, forall t, T <= t -> M <= scaled n t.
Proof.
assert (Hex : exists k : nat, b < INR (n + k)).
{ destruct (Rle_lt_dec 0 b) as [H|H].
  - destruct (nfloor_ex b H) as [k [_ Hk]]. exists (S k). rewrite plus_INR, S_INR. generalize (pos_INR n); lra.
  - exists 0%nat. rewrite Nat.add_0_r. generalize (pos_INR n); lra. }
destruct Hex as [k Hk]. revert n Hk. induction k as [|k IH]; intros n Hk M.
- apply scaled_right_high. rewrite Nat.add_0_r in Hk. exact Hk.
- replace (n + S k)%nat with (S n + k)%nat in Hk by lia.
  destruct (IH (S n) Hk 1) as (T & H).
  destruct (grow (scaled n) (scaled (S n)) 1 T (scaled_derive n) Rlt_0_1 H M) as (T' & _ & H'). exists T'. exact H'.
Qed.

(** ** The tail lemma *)
Lemma scaled_up k x y : x < y -> (forall t, x < t < y -> 0 < scaled (S k) t) -> scaled k x < scaled k y.
Proof.
intros Hxy H. destruct (mvt_open _ _ x y Hxy (fun s _ => scaled_derive k s)) as (c & Hc & E).
specialize (H c Hc). assert (0 < scaled (S k) c * (y - x)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma scaled_down k x y : x < y -> (forall t, x < t < y -> scaled (S k) t < 0) -> scaled k y < scaled k x.
Proof.
intros Hxy H. destruct (mvt_open _ _ x y Hxy (fun s _ => scaled_derive k s)) as (c & Hc & E).
specialize (H c Hc). assert (0 < - scaled (S k) c * (y - x)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Definition positive_beyond (T : R) (k : nat) : Prop := forall t, T < t -> 0 < scaled k t.
Definition one_zero_beyond (T : R) (k : nat) : Prop := exists z, T < z /\ scaled k z = 0 /\ 0 < scaled (S k) z /\
  (forall t, T < t < z -> scaled k t < 0) /\ (forall t, z < t -> 0 < scaled k t).

Lemma positive_step_down T k : positive_beyond T (S k) -> 0 <= scaled k T -> positive_beyond T k.
Proof.
intros H H0 t Ht. assert (A := scaled_up k T t Ht ltac:(intros u Hu; apply H; lra)). lra.
Qed.

(** from a point x with a value < 0 (or <= 0 and a slope < 0), the slope being positive beyond z >= x *)
Lemma crossing k x : scaled k x < 0 -> (forall t, x < t -> 0 < scaled (S k) t) ->
  exists z, x < z /\ scaled k z = 0 /\ (forall t, x < t < z -> scaled k t < 0) /\ (forall t, z < t -> 0 < scaled k t).
Proof.
intros Hx Hup.
destruct (scaled_right k 1) as (T' & HT'). set (y := Rmax (x + 1) T').
assert (Y1 : x + 1 <= y) by apply Rmax_l. assert (Hy := HT' y (Rmax_r _ _)).
destruct (IVT (scaled k) x y) as (z & Hz & Ez).
- exact (derive_continuity _ _ (scaled_derive k)).
- lra.
- exact Hx.
- lra.
- assert (Hxz : x < z).
  { destruct (Rle_lt_or_eq_dec x z (proj1 Hz)) as [H|H]; auto. rewrite H in Hx. lra. }
  exists z. refine (conj Hxz (conj Ez (conj _ _))); intros t Ht.
  + rewrite <- Ez. apply scaled_up. lra. intros u Hu; apply Hup; lra.
  + rewrite <- Ez. apply scaled_up. lra. intros u Hu; apply Hup; lra.
Qed.

Lemma one_zero_step_down T k : positive_beyond T (S k) \/ one_zero_beyond T (S k) -> scaled k T <= 0 ->
  positive_beyond T k \/ one_zero_beyond T k.
Proof.
intros [H|(z & Hz & Ez & Dz & Hn & Hp)] H0.
- destruct (Rle_lt_or_eq_dec _ _ H0) as [Hlt|E].
  + right. destruct (crossing k T Hlt (fun t Ht => H t Ht)) as (z & Hz & Ez & A & B).
    exists z. exact (conj Hz (conj Ez (conj (H z Hz) (conj A B)))).
  + left. apply positive_step_down; auto. lra.
- right. assert (Hzn : scaled k z < 0).
  { assert (A := scaled_down k T z Hz Hn). lra. }
  destruct (crossing k z Hzn Hp) as (w & Hw & Ew & A & B).
  exists w. refine (conj _ (conj Ew (conj (Hp w Hw) (conj _ B)))). lra.
  intros t Ht. destruct (Rtotal_order t z) as [C|[->|C]]; auto.
  + assert (D := scaled_down k T t ltac:(lra) ltac:(intros u Hu; apply Hn; lra)). lra.
  + apply A. lra.
Qed.

Theorem tail_positive n T : INR n < b < INR n + 1 -> (forall k, (k <= n)%nat -> 0 <= scaled k T) ->
  forall k, (k <= n)%nat -> positive_beyond T k.
Proof.
intros Hbn H0.
assert (A : forall j k, (k + j = S n)%nat -> positive_beyond T k).
{ induction j as [|j IH]; intros k Hk.
  - intros t _. apply scaled_pos. replace k with (S n) by lia. rewrite S_INR. lra.
  - apply positive_step_down. apply IH; lia. apply H0. lia. }
intros k Hk. apply (A (S n - k)%nat). lia.
Qed.

Theorem tail_one_zero n j T : INR n < b < INR n + 1 -> (j <= S n)%nat ->
  (forall k, (k < j)%nat -> scaled k T <= 0) -> (forall k, (j <= k <= n)%nat -> 0 <= scaled k T) ->
  positive_beyond T 0 \/ one_zero_beyond T 0.
Proof.
intros Hbn Hj Hlo Hhi.
assert (A : forall i k, (k + i = S n)%nat -> (j <= k)%nat -> positive_beyond T k).
{ induction i as [|i IH]; intros k Hk Hjk.
  - intros t _. apply scaled_pos. replace k with (S n) by lia. rewrite S_INR. lra.
  - apply positive_step_down. apply IH; lia. apply Hhi. lia. }
assert (Aj : positive_beyond T j) by (apply (A (S n - j)%nat); lia).
assert (B : forall i k, (k + i = j)%nat -> positive_beyond T k \/ one_zero_beyond T k).
{ induction i as [|i IH]; intros k Hk.
  - left. replace k with j by lia. exact Aj.
  - apply one_zero_step_down. apply IH; lia. apply Hlo. lia. }
apply (B j 0%nat). lia.
Qed.

End Ends.

Theorem tail_without_zero (n : nat) b theta T : INR n < b < INR n + 1 -> is_Theta b theta ->
  let s k := Gamma (- b) * Derive_n theta k T in
  (forall k, (k <= n)%nat -> 0 <= s k) -> s 0%nat <> 0 -> forall t, T <= t -> 0 < Gamma (- b) * theta t.
Proof.
intros Hbn H s Hs H0 t Ht.
assert (Hb : not_nat b) by (apply (cell_not_nat (S n)); unfold cell; rewrite S_INR; lra).
destruct (Rle_lt_or_eq_dec T t Ht) as [Hlt|<-].
- exact (tail_positive b theta Hb H n T Hbn Hs 0%nat ltac:(lia) t Hlt).
- assert (A := Hs 0%nat ltac:(lia)). destruct (Rle_lt_or_eq_dec _ _ A) as [B|B]; [exact B|]. exfalso. apply H0. auto.
Qed.

Theorem tail_with_one_zero (n j : nat) b theta T : INR n < b < INR n + 1 -> is_Theta b theta ->
  let s k := Gamma (- b) * Derive_n theta k T in
  (1 <= j <= n + 1)%nat -> (forall k, (k < j)%nat -> s k <= 0) -> (forall k, (j <= k <= n)%nat -> 0 <= s k) ->
    s 0%nat <> 0 ->
  exists z, T < z /\ theta z = 0 /\ Derive theta z <> 0 /\
    (forall t, T <= t < z -> Gamma (- b) * theta t < 0) /\ (forall t, z < t -> 0 < Gamma (- b) * theta t).
Proof.
intros Hbn H s Hj Hlo Hhi H0.
assert (Hb : not_nat b) by (apply (cell_not_nat (S n)); unfold cell; rewrite S_INR; lra).
assert (Hg := not_nat_Gamma b Hb).
assert (S0 : s 0%nat < 0).
{ assert (A := Hlo 0%nat ltac:(lia)). destruct (Rle_lt_or_eq_dec _ _ A) as [B|B]; [exact B|]. contradiction. }
destruct (tail_one_zero b theta Hb H n j T Hbn ltac:(lia) Hlo Hhi) as [P|(z & Hz & Ez & Dz & Hn & Hp)].
- exfalso. assert (C : locally T (fun t => 0 < - scaled b theta 0 t)).
  { apply (continuous_pos (fun t => - scaled b theta 0 t)).
    - exists (- scaled b theta 1 T). apply (is_derive_opp (scaled b theta 0)), (scaled_derive b theta Hb H 0).
    - unfold s in S0. unfold scaled. lra. }
  destruct C as [d Hd]. assert (Hdp := cond_pos d).
  assert (A := P (T + d / 2) ltac:(lra)).
  assert (B : 0 < - scaled b theta 0 (T + d / 2)).
  { apply Hd. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Rabs_pos_eq; lra. }
  lra.
- exists z. refine (conj Hz (conj _ (conj _ (conj _ Hp)))).
  + apply Rmult_integral in Ez. destruct Ez as [E|E]; [contradiction|exact E].
  + intros E. unfold scaled in Dz. change (Derive_n theta 1 z) with (Derive theta z) in Dz. rewrite E in Dz. lra.
  + intros t [Ht1 Ht2]. destruct (Rle_lt_or_eq_dec T t Ht1) as [A|<-]; [exact (Hn t (conj A Ht2))|exact S0].
Qed.

(** dTheta/dtau < 0 far to the left *)
Theorem left_end b theta : 0 < b -> not_nat b -> is_Theta b theta -> exists T, forall t, t <= T -> Derive theta t < 0.
Proof.
intros Hb Hn H.
assert (HL := Theta_asymptotics (b - 1) (Th (b - 1)) (not_nat_pred b Hn) (Th_correct _)).
apply is_lim_spec in HL. destruct (HL (mkposreal (1 / 2) ltac:(lra))) as [M HM]. simpl in HM.
exists (- (M + 1)). intros t Ht.
rewrite (Theta_derive b theta (Th (b - 1)) Hn H (Th_correct _)).
specialize (HM (- t) ltac:(lra)). rewrite Ropp_involutive in HM.
assert (HR : 0 < Rpower (- t) (b - 1)) by apply exp_pos. apply Rabs_def2 in HM.
assert (Hp : 0 < Th (b - 1) t).
{ replace (Th (b - 1) t) with (Th (b - 1) t / Rpower (- t) (b - 1) * Rpower (- t) (b - 1)) by (field; lra).
  apply Rmult_lt_0_compat; lra. }
assert (0 < b * Th (b - 1) t) by (apply Rmult_lt_0_compat; auto). lra.
Qed.

Theorem left_end_integer n t : (1 <= n)%nat -> t < 0 -> Derive (Poly n) t < 0.
Proof.
intros Hn Ht. destruct n as [|n]; [lia|].
rewrite (is_derive_unique _ _ _ (Poly_derive n t)), Poly_Pn.
assert (H := Pn_left n t Ht). assert (HS : 0 < INR (S n)) by (apply lt_0_INR; lia).
assert (0 < INR (S n) * Pn n t) by (apply Rmult_lt_0_compat; auto). lra.
Qed.
