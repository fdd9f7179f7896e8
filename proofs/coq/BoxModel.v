(** * Taylor models on boxes: the shift of the centre

    Section 4 of proofs/box.md, and with [CoefficientModels.v] its sections 3 and 4 together. The d-th derivative of
    Theta is the d-th derivative of its Taylor series at 0. What is left out from K on is bounded by [DerivativeTail.v];
    an error of a coefficient enters with the size of its term; the polynomial that is left is written in powers of u, t
    = t0 + s u, by the binomial theorem, and the powers from I on are bounded one by one. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementModels Calculus Gronwall WellPosed EntireForm DerivativeTail
  CoefficientModels.
Open Scope R_scope.

(** ** Finite sums *)
Lemma sum_ext (v w : nat -> R) n : (forall k, (k < n)%nat -> v k = w k) -> sum_first v n = sum_first w n.
Proof. induction n as [|n IH]; intros H; simpl; auto. rewrite IH by (intros; apply H; lia). rewrite H by lia.
reflexivity. Qed.

Lemma sum_plus (v w : nat -> R) n : sum_first (fun k => v k + w k) n = sum_first v n + sum_first w n.
Proof. induction n as [|n IH]; simpl. ring. rewrite IH. ring. Qed.

Lemma sum_split (v : nat -> R) n m : sum_first v (n + m) = sum_first v n + sum_first (fun k => v (n + k)%nat) m.
Proof. induction m as [|m IH]. rewrite Nat.add_0_r. simpl. ring. rewrite Nat.add_succ_r. simpl. rewrite IH. ring. Qed.

Lemma sum_bound (v w : nat -> R) n : (forall k, (k < n)%nat -> Rabs (v k) <= w k) ->
  Rabs (sum_first v n) <= sum_first w n.
Proof.
induction n as [|n IH]; intros H; simpl. rewrite Rabs_R0. lra.
eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat. apply IH. intros; apply H; lia. apply H. lia.
Qed.

Lemma sum_triangle (g : nat -> nat -> R) n :
  sum_first (fun m => sum_first (fun l => g l (m - l)%nat) (S m)) n = sum_first (fun l => sum_first (g l) (n - l)) n.
Proof.
induction n as [|n IH]; auto. cbn [sum_first] in IH |- *. rewrite IH. clear IH.
rewrite Nat.sub_diag. replace (S n - n)%nat with 1%nat by lia.
rewrite (sum_ext (fun l => sum_first (g l) (S n - l)) (fun l => sum_first (g l) (n - l) + g l (n - l)%nat)).
2: { intros k Hk. replace (S n - k)%nat with (S (n - k)) by lia. reflexivity. }
rewrite sum_plus. simpl. ring.
Qed.

Lemma sum_f_first (v : nat -> R) n : sum_f_R0 v n = sum_first v (S n).
Proof. induction n as [|n IH]; simpl; [ring|]. rewrite IH. reflexivity. Qed.

Lemma falling_pos d i : 0 < falling d i.
Proof. apply Rdiv_lt_0_compat; apply INR_fact_lt_0. Qed.

Lemma falling_binomial d m l : (l <= m)%nat -> falling d (d + m) * Binomial.C m l = falling d (d + l) * Binomial.C
  (d + m) (d + l).
Proof.
intros H. unfold falling, Binomial.C. replace (d + m - d)%nat with m by lia. replace (d + l - d)%nat with l by lia.
replace (d + m - (d + l))%nat with (m - l)%nat by lia.
field. repeat split; apply INR_fact_neq_0.
Qed.

(** sum p_k (t0 + s u)^k in powers of u, d times differentiated *)
Lemma recentre (p : nat -> R) (t0 s u : R) d M :
  s ^ d * sum_first (fun j => falling d (d + j) * p (d + j)%nat * (t0 + s * u) ^ j) M =
  sum_first (fun l => falling d (d + l) *
    sum_first (fun j => Binomial.C (d + l + j) (d + l) * t0 ^ j * s ^ (d + l) * p (d + l + j)%nat) (M - l) * u ^ l) M.
Proof.
rewrite <- sum_first_factor.
set (g := fun l j => falling d (d + l) * (Binomial.C (d + l + j) (d + l) * t0 ^ j * s ^ (d + l) * p (d + l + j)%nat)
  * u ^ l).
transitivity (sum_first (fun l => sum_first (g l) (M - l)) M).
- rewrite <- sum_triangle. apply sum_ext. intros m _. cbv beta.
  rewrite (Rplus_comm t0 (s * u)), Binomial.binomial, sum_f_first.
  rewrite <- !sum_first_factor. apply sum_ext. intros l Hl. unfold g.
  replace (d + l + (m - l))%nat with (d + m)%nat by lia. rewrite pow_add, Rpow_mult_distr.
  assert (F := falling_binomial d m l ltac:(lia)).
  replace (s ^ d * (falling d (d + m) * p (d + m)%nat * (Binomial.C m l * (s ^ l * u ^ l) * t0 ^ (m - l))))
    with (falling d (d + m) * Binomial.C m l * (s ^ d * s ^ l * p (d + m)%nat * u ^ l * t0 ^ (m - l))) by ring.
  rewrite F. ring.
- apply sum_ext. intros l _.
  rewrite (Rmult_comm (falling d (d + l))), Rmult_assoc, (Rmult_comm _ (falling d (d + l) * u ^ l)),
    <- sum_first_factor.
  apply sum_ext. intros j _. unfold g. ring.
Qed.

(** ** The derivatives as series *)
Section Box.
Variables (b : R) (theta : R -> R).
Hypothesis H : is_Theta_entire b theta.

Let a (k : nat) : R := Derive_n theta k 0 / INR (fact k).

Lemma entire_series t : theta t = PSeries (coef b (theta 0) (Derive theta 0) (Derive_n theta 2 0)) t.
Proof.
set (A0 := theta 0). set (A1 := Derive theta 0). set (A2 := Derive_n theta 2 0).
destruct (entire_chain b theta H) as (D0 & D1 & D2 & _).
destruct (s_init b A0 A1 A2) as (I0 & I1 & I2).
set (f := PSeries (coef b A0 A1 A2)) in *. set (f1 := PSeries (PS_derive (coef b A0 A1 A2))) in *.
set (f2 := PSeries (PS_derive (PS_derive (coef b A0 A1 A2)))) in *.
assert (G := gronwall_u0 (fun t => theta t - f t) (fun t => Derive theta t - f1 t) (fun t => Derive_n theta 2 t - f2 t)
  (fun _ => 0) (- b) (Rabs t) 0 (Rabs_pos t)).
assert (G' : (theta t - f t) ^ 2 <= 0).
{ eapply Rle_trans. apply G.
  - intros s. apply (is_derive_minus theta f); auto. apply s_derive0.
  - intros s. apply (is_derive_minus (Derive theta) f1); auto. apply s_derive1.
  - intros s.
    replace (s * (Derive theta s - f1 s) + - b * (theta s - f s) + 0)
      with ((s * Derive theta s - b * theta s) - (s * f1 s - b * f s)) by ring.
    apply (is_derive_minus (Derive_n theta 2) f2); auto. apply s_derive2.
  - intros; rewrite Rabs_R0; apply Rle_refl.
  - apply Rle_refl.
  - rewrite I0, I1, I2. fold A0 A1 A2. right. unfold Rminus. rewrite !Rplus_opp_r. ring. }
nra.
Qed.

Lemma coefficient k : coef b (theta 0) (Derive theta 0) (Derive_n theta 2 0) k = a k.
Proof.
unfold a. rewrite (Derive_n_ext theta _ k 0 entire_series), Derive_n_coef by (rewrite coef_radius; exact I).
field. apply INR_fact_neq_0.
Qed.

Lemma coefficient_recurrence k : (INR k + 1) * (INR k + 2) * (INR k + 3) * a (k + 3)%nat = (INR k - b) * a k.
Proof.
rewrite <- !coefficient. replace (k + 3)%nat with (S (S (S k))) by lia. rewrite coef_rec. assert (Hk := pos_INR k).
field. lra.
Qed.

Lemma derivative_series d t : is_lim_seq (sum_first (fun j => falling d (d + j) * a (d + j)%nat * t ^ j))
  (Derive_n theta d t).
Proof.
assert (Hr : CV_radius (PS_derive_n d (coef b (theta 0) (Derive theta 0) (Derive_n theta 2 0))) = p_infty).
{ rewrite CV_radius_derive_n. apply coef_radius. }
rewrite (Derive_n_ext theta _ d t entire_series), Derive_n_PSeries by (rewrite coef_radius; exact I).
assert (P := PSeries_correct _ t (CV_radius_inside _ t ltac:(rewrite Hr; exact I))).
set (y := PSeries _ t) in *.
assert (L : is_lim_seq
  (sum_n (fun k => scal (pow_n t k) (PS_derive_n d (coef b (theta 0) (Derive theta 0) (Derive_n theta 2 0)) k))) y)
    by exact P.
apply is_lim_seq_incr_1. eapply is_lim_seq_ext; [|exact L]. intros n. rewrite sum_n_Reals, sum_f_first.
apply sum_ext. intros k _. rewrite pow_n_pow. unfold PS_derive_n, falling. rewrite coefficient.
replace (d + k - d)%nat with k by lia. rewrite (Nat.add_comm d k). unfold scal; simpl; unfold mult; simpl. ring.
Qed.

Lemma left_out (w : nat -> R) (y : R) (n : nat) V : is_lim_seq (sum_first w) y ->
  (forall N, sum_first (fun i => Rabs (w (n + i)%nat)) N <= V) ->
  Rabs (y - sum_first w n) <= V.
Proof.
intros L HV.
apply (is_lim_seq_le (fun N => Rabs (sum_first w (n + N) - sum_first w n)) (fun _ => V) (Rabs (y - sum_first w n)) V).
- intros N. rewrite sum_split. replace (sum_first w n + sum_first (fun k => w (n + k)%nat) N - sum_first w n)
    with (sum_first (fun k => w (n + k)%nat) N) by ring.
  eapply Rle_trans; [|apply (HV N)]. apply sum_bound. intros; apply Rle_refl.
- apply (is_lim_seq_abs (fun N => sum_first w (n + N) - sum_first w n) (y - sum_first w n)).
  apply is_lim_seq_minus'; [|apply is_lim_seq_const].
  apply (is_lim_seq_ext (fun N => sum_first w (N + n))). intros N; f_equal; lia.
  apply (is_lim_seq_incr_n (sum_first w) n). exact L.
- apply is_lim_seq_const.
Qed.

(** ** The remainder *)
Variables (t0 s B : R) (p e S : nat -> R) (d I K : nat) (u : R).
Hypothesis Hs : 0 <= s.
Hypothesis HB : 1 <= B.
Hypothesis Hb : Rabs b <= B.
Hypothesis HdI : (d <= I)%nat.
Hypothesis HdK : (d <= K)%nat.
Hypothesis Hu : Rabs u <= 1.
Hypothesis Hp : forall k, (k < K)%nat -> Rabs (a k - p k) <= e k /\ Rabs (p k) <= S k.
Hypothesis HS : forall k, (K <= k < K + 3)%nat -> Rabs (a k) <= S k.

Let X : R := Rabs t0 + s.
Let part (x : R) (c : nat -> R) (i : nat) : R := shifted x s c K i.
Let W : R := sum_first (fun l => falling d (I + l) * part (Rabs t0) S (I + l)) (K - I).
Let E : R := sum_first (fun j => falling d (d + j) * X ^ j * e (d + j)%nat) (K - d).
Let y : R := INR (K - d).
Let q : R := (INR K + B) * X ^ 3 / ((y + 1) * (y + 2) * (y + 3)).
Let v (k : nat) : R := falling d k * S k * X ^ (k - d).
Let V : R := (v K + v (K + 1)%nat + v (K + 2)%nat) / (1 - q).
Hypothesis Hq : q < 1.

Lemma X_pos : 0 <= X.
Proof. unfold X. assert (A := Rabs_pos t0). lra. Qed.

Lemma inside : Rabs (t0 + s * u) <= X.
Proof.
unfold X. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult, (Rabs_pos_eq s) by exact Hs.
assert (s * Rabs u <= s * 1) by (apply Rmult_le_compat_l; auto). lra.
Qed.

Lemma powers_inside j : Rabs ((t0 + s * u) ^ j) <= X ^ j.
Proof. rewrite <- RPow_abs. apply pow_incr. split. apply Rabs_pos. apply inside. Qed.

Lemma tail_part : Rabs (Derive_n theta d (t0 + s * u) - sum_first (fun j =>
  falling d (d + j) * a (d + j)%nat * (t0 + s * u) ^ j) (K - d)) <= V.
Proof.
apply left_out. apply derivative_series. intros N.
assert (Eq : INR K + B = y + INR d + B) by (unfold y; rewrite minus_INR by auto; ring).
assert (T := derivative_tail b X B a d X_pos HB Hb coefficient_recurrence K N HdK).
unfold tail_factor in T. fold y in T. rewrite <- Eq in T. fold q in T. specialize (T Hq).
eapply Rle_trans; [|eapply Rle_trans; [exact T|]].
- apply sum_first_le. intros k.
  change (derivative_term X a d (K + k)) with (falling d (K + k) * Rabs (a (K + k)%nat) * X ^ (K + k - d)).
  replace (d + (K - d + k))%nat with (K + k)%nat by lia. replace (K - d + k)%nat with (K + k - d)%nat by lia.
  assert (F := falling_pos d (K + k)). rewrite !Rabs_mult, (Rabs_pos_eq (falling d (K + k))) by lra.
  apply Rmult_le_compat_l; [|apply powers_inside]. apply Rmult_le_pos; [lra|apply Rabs_pos].
- unfold V, Rdiv. apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat; lra.
  assert (P : forall k, (K <= k < K + 3)%nat -> derivative_term X a d k <= v k).
  { intros k Hk. change (derivative_term X a d k) with (falling d k * Rabs (a k) * X ^ (k - d)). unfold v.
    apply Rmult_le_compat_r. apply pow_le, X_pos.
    apply Rmult_le_compat_l. apply Rlt_le, (falling_pos d k). apply HS, Hk. }
  assert (P0 := P K ltac:(lia)). assert (P1 := P (K + 1)%nat ltac:(lia)). assert (P2 := P (K + 2)%nat ltac:(lia)). lra.
Qed.

Lemma error_part : Rabs (sum_first (fun j => falling d (d + j) * a (d + j)%nat * (t0 + s * u) ^ j) (K - d)
  - sum_first (fun j => falling d (d + j) * p (d + j)%nat * (t0 + s * u) ^ j) (K - d)) <= E.
Proof.
replace (sum_first (fun j => falling d (d + j) * a (d + j)%nat * (t0 + s * u) ^ j) (K - d)
  - sum_first (fun j => falling d (d + j) * p (d + j)%nat * (t0 + s * u) ^ j) (K - d))
  with (sum_first (fun j => falling d (d + j) * (t0 + s * u) ^ j * (a (d + j)%nat - p (d + j)%nat)) (K - d)).
- apply sum_bound. intros j Hj. rewrite !Rabs_mult, (Rabs_pos_eq (falling d (d + j))) by (apply Rlt_le, falling_pos).
  apply Rmult_le_compat; [|apply Rabs_pos| |apply Hp; lia].
  + apply Rmult_le_pos; [apply Rlt_le, falling_pos|apply Rabs_pos].
  + apply Rmult_le_compat_l; [apply Rlt_le, falling_pos|apply powers_inside].
- apply (Rplus_eq_reg_r (sum_first (fun j => falling d (d + j) * p (d + j)%nat * (t0 + s * u) ^ j) (K - d))).
  rewrite <- sum_plus. unfold Rminus. rewrite Rplus_assoc, Rplus_opp_l, Rplus_0_r. apply sum_ext. intros j _. ring.
Qed.

Lemma part_bound i : Rabs (part t0 p i) <= part (Rabs t0) S i.
Proof.
unfold part, shifted. apply sum_bound. intros j Hj.
assert (HC : 0 <= Binomial.C (i + j) i).
{ unfold Binomial.C. apply Rlt_le, Rdiv_lt_0_compat. apply INR_fact_lt_0.
  apply Rmult_lt_0_compat; apply INR_fact_lt_0. }
rewrite !Rabs_mult, (Rabs_pos_eq (Binomial.C (i + j) i)) by exact HC.
rewrite (Rabs_pos_eq (s ^ i)) by (apply pow_le, Hs). rewrite <- RPow_abs.
apply Rmult_le_compat_l. apply Rmult_le_pos; [apply Rmult_le_pos; [exact HC|apply pow_le, Rabs_pos]|apply pow_le, Hs].
apply Hp. lia.
Qed.

Lemma part_empty x c i : (K <= i)%nat -> part x c i = 0.
Proof. intros Hi. unfold part, shifted. replace (K - i)%nat with 0%nat by lia. reflexivity. Qed.

(** the powers of u up to K - d are those below I, and others *)
Lemma kept_powers : s ^ d * sum_first (fun j => falling d (d + j) * p (d + j)%nat * (t0 + s * u) ^ j) (K - d)
  - sum_first (fun j => falling d (d + j) * part t0 p (d + j) * u ^ j) (I - d)
  = sum_first (fun l => falling d (I + l) * part t0 p (I + l) * u ^ (I + l - d)) (K - I).
Proof.
rewrite recentre.
rewrite (sum_ext _ (fun l => falling d (d + l) * part t0 p (d + l) * u ^ l)).
2: { intros l _. unfold part, shifted. replace (K - d - l)%nat with (K - (d + l))%nat by lia. reflexivity. }
destruct (le_lt_dec I K) as [HI|HI].
- replace (K - d)%nat with (I - d + (K - I))%nat by lia. rewrite sum_split.
  match goal with |- ?x + ?z - ?x = _ => replace (x + z - x) with z by ring end.
  apply sum_ext. intros k _. replace (d + (I - d + k))%nat with (I + k)%nat by lia.
  replace (I - d + k)%nat with (I + k - d)%nat by lia. reflexivity.
- replace (K - I)%nat with 0%nat by lia. replace (I - d)%nat with (K - d + (I - K))%nat by lia. rewrite sum_split.
  rewrite (sum_ext (fun k => falling d (d + (K - d + k)) * part t0 p (d + (K - d + k)) * u ^ (K - d + k)) (fun _ => 0)).
  2: { intros k _. rewrite part_empty by lia. ring. }
  replace (sum_first (fun _ : nat => 0) (I - K)) with 0. simpl. ring.
  induction (I - K)%nat as [|n IH]; simpl; auto. rewrite <- IH. ring.
Qed.

Lemma omitted_powers : Rabs (sum_first (fun l => falling d (I + l) * part t0 p (I + l) * u ^ (I + l - d)) (K - I)) <= W.
Proof.
apply sum_bound. intros l _. rewrite !Rabs_mult, (Rabs_pos_eq (falling d (I + l))) by (apply Rlt_le, falling_pos).
assert (Hpow : Rabs (u ^ (I + l - d)) <= 1).
{ rewrite <- RPow_abs, <- (pow1 (I + l - d)). apply pow_incr. split; [apply Rabs_pos|exact Hu]. }
rewrite <- (Rmult_1_r (falling d (I + l) * part (Rabs t0) S (I + l))).
apply Rmult_le_compat; [|apply Rabs_pos| |exact Hpow].
- apply Rmult_le_pos; [apply Rlt_le, falling_pos|apply Rabs_pos].
- apply Rmult_le_compat_l; [apply Rlt_le, falling_pos|apply part_bound].
Qed.

Lemma no_omitted_powers : u = 0 -> (d < I)%nat ->
  sum_first (fun l => falling d (I + l) * part t0 p (I + l) * u ^ (I + l - d)) (K - I) = 0.
Proof.
intros -> HI. induction (K - I)%nat as [|n IH]; simpl; auto. rewrite IH.
replace (I + n - d)%nat with (Datatypes.S (I + n - d - 1)) by lia. simpl. ring.
Qed.

Lemma remainder : let difference := s ^ d * Derive_n theta d (t0 + s * u)
    - sum_first (fun j => falling d (d + j) * part t0 p (d + j) * u ^ j) (I - d) in
  Rabs difference <= W + s ^ d * (E + V) /\ (u = 0 -> (d < I)%nat -> Rabs difference <= s ^ d * (E + V)).
Proof.
intros difference.
set (P := sum_first (fun j => falling d (d + j) * p (d + j)%nat * (t0 + s * u) ^ j) (K - d)).
set (A := sum_first (fun j => falling d (d + j) * a (d + j)%nat * (t0 + s * u) ^ j) (K - d)).
set (Z := sum_first (fun l => falling d (I + l) * part t0 p (I + l) * u ^ (I + l - d)) (K - I)).
assert (T := tail_part). fold A in T. assert (Er := error_part). fold A P in Er. assert (Kp := kept_powers).
fold P Z in Kp.
assert (D : difference = Z + s ^ d * ((A - P) + (Derive_n theta d (t0 + s * u) - A))).
{ unfold difference. rewrite <- Kp. ring. }
assert (R : Rabs (s ^ d * ((A - P) + (Derive_n theta d (t0 + s * u) - A))) <= s ^ d * (E + V)).
{ rewrite Rabs_mult, (Rabs_pos_eq (s ^ d)) by (apply pow_le, Hs). apply Rmult_le_compat_l. apply pow_le, Hs.
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; auto. }
split.
- rewrite D. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; auto. apply omitted_powers.
- intros U HI. rewrite D. unfold Z. rewrite (no_omitted_powers U HI), Rplus_0_l. exact R.
Qed.
End Box.

Theorem box_remainder b theta t0 s B (p e S : nat -> R) (d I K : nat) u : is_Theta_entire b theta ->
  0 <= s -> 1 <= B -> Rabs b <= B -> (d <= I)%nat -> (d <= K)%nat -> Rabs u <= 1 ->
  let a k := Derive_n theta k 0 / INR (fact k) in
  (forall k, (k < K)%nat -> Rabs (a k - p k) <= e k /\ Rabs (p k) <= S k) ->
  (forall k, (K <= k < K + 3)%nat -> Rabs (a k) <= S k) ->
  box_estimate B t0 s p e S d I K u (Derive_n theta d (t0 + s * u)).
Proof. intros H Hs HB Hb HdI HdK Hu a Hp HS Hq.
exact (remainder b theta H t0 s B p e S d I K u Hs HB Hb HdI HdK Hu Hp HS Hq). Qed.

Theorem box_model b0 r (Theta : R -> R -> R) (model : nat -> list R * R) t0 s B (d I K : nat) u eta :
  (forall eta, is_Theta_entire (b0 + r * eta) (Theta eta)) ->
  (forall k, (k < 3)%nat -> is_model (model k) (fun eta => Derive_n (Theta eta) k 0 / INR (fact k))) ->
  (forall k, model (k + 3)%nat = next_model b0 r k (model k)) ->
  0 <= r -> 0 <= s -> 1 <= B -> Rabs b0 + r <= B -> (d <= I)%nat -> (d <= K)%nat -> Rabs u <= 1 -> Rabs eta <= 1 ->
  box_estimate B t0 s (fun k => polynomial (fst (model k)) eta) (fun k => snd (model k))
    (fun k => total_size (fst (model k)) + snd (model k)) d I K u (Derive_n (Theta eta) d (t0 + s * u)).
Proof.
intros HT H0 Hn Hr Hs HB Hb HdI HdK Hu He.
assert (M := series_models b0 r (fun k eta => Derive_n (Theta eta) k 0 / INR (fact k)) model Hr
  (fun k eta => coefficient_recurrence (b0 + r * eta) (Theta eta) (HT eta) k) H0 Hn).
assert (Hbe : Rabs (b0 + r * eta) <= B).
{ eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult, (Rabs_pos_eq r) by exact Hr.
  assert (r * Rabs eta <= r * 1) by (apply Rmult_le_compat_l; auto). lra. }
assert (G : forall k, let a := Derive_n (Theta eta) k 0 / INR (fact k) in let p := polynomial (fst (model k)) eta in
  Rabs (a - p) <= snd (model k) /\ Rabs p <= total_size (fst (model k)) /\ 0 <= snd (model k)).
{ intros k a p. assert (A := M k eta He). refine (conj A (conj (polynomial_size _ _ He) _)).
  eapply Rle_trans; [apply Rabs_pos|exact A]. }
apply (box_remainder (b0 + r * eta)); auto.
- intros k _. destruct (G k) as (A & P & E). split; [exact A|lra].
- intros k _. destruct (G k) as (A & P & E).
  replace (Derive_n (Theta eta) k 0 / INR (fact k))
    with (polynomial (fst (model k)) eta + (Derive_n (Theta eta) k 0 / INR (fact k) - polynomial (fst (model k)) eta))
      by ring.
  eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.
