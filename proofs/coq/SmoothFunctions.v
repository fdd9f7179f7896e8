(** * Functions of a state along a motion, and fields on a box

    A function with a gradient changes along a motion at the rate that the gradient gives ([gradient_chain]). With
    bounded partial derivatives on a box it is Lipschitz there ([smooth_lipschitz]), and so are sums and products of
    such functions. A field whose components are Lipschitz on a box, read off at the nearest point of the box, has a
    solution from each start on the whole line, and no other one ([clamped_solution], [clamped_unique]). *)

From Coq Require Import Reals Psatz Lra Lia List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus InitialValueProblem LogarithmicNorm ValidatedStep StatementStep StatementApproach.
Import ListNotations.
Open Scope R_scope.

Lemma locally_all {I : Type} (l : list I) (t : R) (P : I -> R -> Prop) : (forall i, locally t (P i)) ->
  locally t (fun s => forall i, In i l -> P i s).
Proof.
intros H. induction l as [|i r IH]. { apply filter_forall. intros s i []. }
generalize (filter_and _ _ (H i) IH). apply filter_imp. intros s [A B] j [<-|Hj]; auto.
Qed.

Lemma total_term {I : Type} (l : list I) (g : I -> R) i : In i l -> (forall j, 0 <= g j) -> g i <= total l g.
Proof.
assert (N : forall r, (forall j, 0 <= g j) -> 0 <= total r g).
{ intros r H. induction r as [|j r IH]; simpl; [lra|]. specialize (H j). lra. }
intros Hi H. induction l as [|j r IH]; [destruct Hi|]. simpl. specialize (N r H).
destruct Hi as [<-|Hi]; [lra|]. specialize (IH Hi). specialize (H j). lra.
Qed.

Lemma total_nonneg {I : Type} (l : list I) (g : I -> R) : (forall j, 0 <= g j) -> 0 <= total l g.
Proof. intros H. rewrite <- (total_zero l). apply total_le, H. Qed.

(** ** Limits *)

(** What moves after s by no more than r s, and r tends to 0. *)
Lemma limit_near (x r : R -> R) : (forall s t, 0 <= s -> s <= t -> Rabs (x t - x s) <= r s) ->
  (forall eps, 0 < eps -> exists S, 0 <= S /\ forall s, S <= s -> r s < eps) ->
  forall s, 0 <= s -> Rabs (x s - real (Lim_seq (fun n => x (INR n)))) <= r s.
Proof.
intros C Z s Hs.
assert (L : is_lim_seq (fun n => x (INR n)) (real (Lim_seq (fun n => x (INR n))))).
{ apply Lim_seq_correct'. apply ex_lim_seq_cauchy_corr. intros eps. destruct (Z eps (cond_pos eps)) as (S & HS & Q).
  destruct (nfloor_ex S HS) as (N & _ & N2). exists (Datatypes.S N). intros n m Hn Hm. apply le_INR in Hn, Hm.
  rewrite S_INR in Hn, Hm. destruct (Rle_dec (INR n) (INR m)) as [Le|Le].
  - rewrite Rabs_minus_sym. eapply Rle_lt_trans; [apply C; lra|apply Q; lra].
  - eapply Rle_lt_trans; [apply C; lra|apply Q; lra]. }
set (l := real (Lim_seq (fun n => x (INR n)))) in *.
apply le_epsilon. intros eta Heta. apply is_lim_seq_spec in L. destruct (L (mkposreal eta Heta)) as [N N1].
destruct (nfloor_ex s Hs) as (k & _ & Hk). set (n := max N (Datatypes.S k)).
specialize (N1 n (Nat.le_max_l _ _)). simpl in N1. assert (Hn : s <= INR n).
{ apply Rle_trans with (INR (Datatypes.S k)). rewrite S_INR. lra. apply le_INR, Nat.le_max_r. }
replace (x s - l) with ((x (INR n) - l) - (x (INR n) - x s)) by ring.
eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. specialize (C s (INR n) Hs Hn). lra.
Qed.

Lemma limit_of_tail (x r : R -> R) : (forall s t, 0 <= s -> s <= t -> Rabs (x t - x s) <= r s) ->
  (forall eps, 0 < eps -> exists S, 0 <= S /\ forall s, S <= s -> r s < eps) ->
  is_lim x p_infty (real (Lim_seq (fun n => x (INR n)))).
Proof.
intros C Z. apply is_lim_spec. intros eps. destruct (Z eps (cond_pos eps)) as (S & HS & Q). exists S. intros s Hs.
eapply Rle_lt_trans; [apply (limit_near x r C Z); lra|apply Q; lra].
Qed.

Section Along.
Variables (I : Type) (all : list I).
Hypothesis Hall : forall i, In i all.

(** The rest of phi is at most e K |h|, that of its linear part e' |h| sum |d_j|, with K = sum (|rate_j| + 1). *)
Lemma gradient_chain (phi : (I -> R) -> R) (d : I -> R) (xi : I -> R -> R) (rate : I -> R) t :
  gradient_at all phi d (state xi t) -> (forall i, is_derive (xi i) t (rate i)) ->
  is_derive (fun s => phi (state xi s)) t (total all (fun j => d j * rate j)).
Proof.
intros G D. apply is_derive_Reals. intros eps Heps.
set (K := total all (fun j => Rabs (rate j) + 1)). set (S := total all (fun j => Rabs (d j))).
assert (HK : 0 <= K) by (apply total_nonneg; intros j; generalize (Rabs_pos (rate j)); lra).
assert (HS : 0 <= S) by (apply total_nonneg; intros j; apply Rabs_pos).
destruct (G (eps / (3 * (K + 1))) ltac:(apply Rdiv_lt_0_compat; lra)) as (near & Hnear & HG).
set (e := Rmin 1 (eps / (3 * (S + 1)))).
assert (He : 0 < e) by (apply Rmin_pos; [lra|apply Rdiv_lt_0_compat; lra]).
assert (L : locally t (fun s => forall j, In j all -> Rabs (xi j s - xi j t - (s - t) * rate j) <= e * Rabs (s - t))).
{ apply (locally_all all t (fun j s => Rabs (xi j s - xi j t - (s - t) * rate j) <= e * Rabs (s - t))). intros j.
  destruct (D j) as [_ Dj]. specialize (Dj t (fun P HP => HP) (mkposreal e He)). revert Dj. apply filter_imp.
  intros s Hs. revert Hs. unfold norm, minus, plus, opp, scal; simpl. unfold abs, mult; simpl.
  replace (xi j s - xi j t - (s - t) * rate j) with (xi j s + - xi j t + - ((s + - t) * rate j)) by ring.
  unfold Rminus. exact (fun H => H). }
destruct L as [u Hu].
assert (Hm : 0 < Rmin u (near / (K + 1))) by (apply Rmin_pos; [apply cond_pos|apply Rdiv_lt_0_compat; lra]).
exists (mkposreal _ Hm). intros h Hh Hsmall. simpl in Hsmall.
assert (H1 : Rabs h < u) by (eapply Rlt_le_trans; [exact Hsmall|apply Rmin_l]).
assert (H2 : Rabs h < near / (K + 1)) by (eapply Rlt_le_trans; [exact Hsmall|apply Rmin_r]).
assert (Hp : 0 < Rabs h) by (apply Rabs_pos_lt; auto).
assert (B : forall j, Rabs (xi j (t + h) - xi j t - h * rate j) <= e * Rabs h).
{ intros j. assert (Q := Hu (t + h)). replace (t + h - t) with h in Q by ring. apply Q; [|apply Hall].
  change (Rabs (t + h - t) < u). replace (t + h - t) with h by ring. exact H1. }
assert (C : forall j, Rabs (xi j (t + h) - xi j t) <= (Rabs (rate j) + 1) * Rabs h).
{ intros j. replace (xi j (t + h) - xi j t) with (h * rate j + (xi j (t + h) - xi j t - h * rate j)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult. specialize (B j).
  assert (e <= 1) by apply Rmin_l. nra. }
assert (CK : total all (fun j => Rabs (xi j (t + h) - xi j t)) <= K * Rabs h).
{ unfold K. rewrite Rmult_comm, <- total_scal. apply total_le. intros j. specialize (C j). lra. }
assert (Near : forall j, Rabs (state xi (t + h) j - state xi t j) <= near).
{ intros j. unfold state.
  eapply Rle_trans.
  { apply (total_term all (fun j => Rabs (xi j (t + h) - xi j t)) j (Hall j)). intros. apply Rabs_pos. }
  eapply Rle_trans; [exact CK|]. apply Rlt_le in H2.
  apply (Rmult_le_compat_l (K + 1)) in H2; [|lra]. replace ((K + 1) * (near / (K + 1))) with near in H2 by (field; lra).
  nra. }
specialize (HG (state xi (t + h)) Near). unfold state in HG at 3 4 5 6.
set (lin := total all (fun j => d j * (xi j (t + h) - xi j t))) in *.
assert (Lin : Rabs (lin - h * total all (fun j => d j * rate j)) <= S * (e * Rabs h)).
{ unfold lin, S. rewrite <- total_scal, <- total_minus, Rmult_comm, <- total_scal.
  eapply Rle_trans; [apply total_abs|]. apply total_le. intros j.
  replace (d j * (xi j (t + h) - xi j t) - h * (d j * rate j))
    with (d j * (xi j (t + h) - xi j t - h * rate j)) by ring.
  rewrite Rabs_mult. specialize (B j). generalize (Rabs_pos (d j)). intros. nra. }
assert (E1 : eps / (3 * (K + 1)) * (K * Rabs h) <= eps / 3 * Rabs h).
{ replace (eps / (3 * (K + 1)) * (K * Rabs h)) with (eps / 3 * Rabs h * (K / (K + 1))) by (field; lra).
  rewrite <- (Rmult_1_r (eps / 3 * Rabs h)) at 2. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|].
  apply Rmult_le_reg_r with (K + 1); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
assert (E2 : S * (e * Rabs h) <= eps / 3 * Rabs h).
{ assert (Q : e <= eps / (3 * (S + 1))) by apply Rmin_r.
  apply (Rmult_le_compat_l (S + 1)) in Q; [|lra]. replace ((S + 1) * (eps / (3 * (S + 1)))) with (eps / 3) in Q
    by (field; lra). nra. }
assert (E3 : eps / (3 * (K + 1)) * total all (fun j => Rabs (xi j (t + h) - xi j t)) <= eps / 3 * Rabs h).
{ eapply Rle_trans; [|exact E1]. apply Rmult_le_compat_l; [apply Rlt_le, Rdiv_lt_0_compat; lra|exact CK]. }
replace ((phi (state xi (t + h)) - phi (state xi t)) / h - total all (fun j => d j * rate j)) with
  ((phi (state xi (t + h)) - phi (state xi t) - lin + (lin - h * total all (fun j => d j * rate j))) * / h)
  by (field; auto).
rewrite Rabs_mult, Rabs_inv. apply Rmult_lt_reg_r with (Rabs h); auto.
rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
eapply Rle_lt_trans; [apply Rabs_triang|]. nra.
Qed.

End Along.

(** ** Lipschitz functions on a box *)

Section Box.
Variables (I : Type) (all : list I) (low high : I -> R).
Hypothesis Hall : forall i, In i all.
Hypothesis Hbox : forall i, low i <= high i.

Definition lipschitz_on (phi : (I -> R) -> R) (L : R) : Prop := 0 <= L /\ forall v v' c, in_box low high v ->
  in_box low high v' -> (forall j, Rabs (v j - v' j) <= c) -> Rabs (phi v - phi v') <= L * c.

(** The mean value theorem on the segment between two points. *)
Lemma smooth_lipschitz phi d : smooth_on all phi d low high -> exists L, lipschitz_on phi L.
Proof.
intros (D & M & HM). exists (INR (length all) * Rabs M). split.
{ apply Rmult_le_pos; [apply pos_INR|apply Rabs_pos]. }
intros v v' c Hv Hv' Hc.
set (p := fun (j : I) s => v' j + s * (v j - v' j)).
assert (Inside : forall s, 0 <= s <= 1 -> in_box low high (state p s)).
{ intros s Hs j. specialize (Hv j). specialize (Hv' j). unfold state, p. split; nra. }
destruct (mvt_open (fun s => phi (state p s)) (fun s => total all (fun j => d j (state p s) * (v j - v' j))) 0 1)
  as (s & Hs & E). { lra. }
{ intros s Hs. apply (gradient_chain I all Hall phi (fun j => d j (state p s)) p). apply D, Inside, Hs.
  intros j. unfold p. auto_derive; auto. ring. }
replace (state p 1) with v in E by (apply functional_extensionality; intros j; unfold state, p; ring).
replace (state p 0) with v' in E by (apply functional_extensionality; intros j; unfold state, p; ring).
rewrite E. replace (1 - 0) with 1 by ring. rewrite Rmult_1_r.
eapply Rle_trans; [apply total_abs|]. rewrite Rmult_assoc, <- total_const. apply total_le. intros j.
rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; auto.
eapply Rle_trans; [apply HM, Inside; lra|apply Rle_abs].
Qed.

Lemma lipschitz_bounded phi L : lipschitz_on phi L ->
  exists M, 0 <= M /\ forall v, in_box low high v -> Rabs (phi v) <= M.
Proof.
intros [HL H]. set (W := total all (fun j => high j - low j)).
assert (HW : forall j, high j - low j <= W).
{ intros j. apply (total_term all (fun j => high j - low j) j (Hall j)). intros k. specialize (Hbox k). lra. }
assert (W0 : 0 <= W) by (apply total_nonneg; intros k; specialize (Hbox k); lra).
exists (Rabs (phi low) + L * W). split. { apply Rplus_le_le_0_compat; [apply Rabs_pos|apply Rmult_le_pos; auto]. }
intros v Hv. assert (Q : Rabs (phi v - phi low) <= L * W).
{ apply H; auto. { intros j. specialize (Hbox j). lra. }
  intros j. specialize (Hv j). specialize (HW j). rewrite Rabs_pos_eq; lra. }
replace (phi v) with (phi low + (phi v - phi low)) by ring. eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

Lemma lipschitz_mult phi psi L K : lipschitz_on phi L -> lipschitz_on psi K ->
  exists M, lipschitz_on (fun v => phi v * psi v) M.
Proof.
intros HL HK. destruct (lipschitz_bounded phi L HL) as (A & A0 & HA).
destruct (lipschitz_bounded psi K HK) as (B & B0 & HB). destruct HL as [L0 HL]. destruct HK as [K0 HK].
exists (L * B + A * K). split. { apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto. }
intros v v' c Hv Hv' Hc.
replace (phi v * psi v - phi v' * psi v') with ((phi v - phi v') * psi v + phi v' * (psi v - psi v')) by ring.
eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
assert (X : Rabs (phi v - phi v') * Rabs (psi v) <= L * c * B) by (apply Rmult_le_compat; auto using Rabs_pos).
assert (Y : Rabs (phi v') * Rabs (psi v - psi v') <= A * (K * c)) by (apply Rmult_le_compat; auto using Rabs_pos).
lra.
Qed.

Lemma lipschitz_minus phi psi L K : lipschitz_on phi L -> lipschitz_on psi K ->
  lipschitz_on (fun v => phi v - psi v) (L + K).
Proof.
intros [L0 HL] [K0 HK]. split. lra. intros v v' c Hv Hv' Hc.
replace (phi v - psi v - (phi v' - psi v')) with ((phi v - phi v') + - (psi v - psi v')) by ring.
eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. specialize (HL v v' c Hv Hv' Hc).
specialize (HK v v' c Hv Hv' Hc). lra.
Qed.

(** One constant for all components. *)
Lemma lipschitz_all (f : I -> (I -> R) -> R) : (forall i, exists L, lipschitz_on (f i) L) ->
  exists L, forall i, lipschitz_on (f i) L.
Proof.
intros H. assert (Q : exists L, 0 <= L /\ forall i, In i all -> lipschitz_on (f i) L).
{ clear Hall. induction all as [|i r (K & K0 & IH)]. { exists 0. split; [lra|intros i []]. }
  destruct (H i) as (L & L0 & HL). exists (L + K). split. lra. intros j [<-|Hj].
  - split. lra. intros v v' c Hv Hv' Hc. specialize (HL v v' c Hv Hv' Hc).
    assert (0 <= c) by (eapply Rle_trans; [apply Rabs_pos|apply (Hc i)]). nra.
  - split. lra. destruct (IH j Hj) as [_ Q]. intros v v' c Hv Hv' Hc. specialize (Q v v' c Hv Hv' Hc).
    assert (0 <= c) by (eapply Rle_trans; [apply Rabs_pos|apply (Hc i)]). nra. }
destruct Q as (L & _ & HL). exists L. intros i. apply HL, Hall.
Qed.

Definition clamp (v : I -> R) : I -> R := nearest I low high v.

Lemma clamp_in_box v : in_box low high (clamp v).
Proof. intros j. assert (B := Hbox j). unfold clamp, nearest, Rmax, Rmin. repeat destruct Rle_dec; lra. Qed.

Lemma clamp_inside v : in_box low high v -> clamp v = v.
Proof. apply nearest_inside. Qed.

Lemma clamp_moves_less v v' j c : Rabs (v j - v' j) <= c -> Rabs (clamp v j - clamp v' j) <= c.
Proof.
assert (B := Hbox j). unfold clamp, nearest. set (a := v j). set (a' := v' j).
unfold Rmax, Rmin. repeat destruct Rle_dec; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

Lemma clamp_continuous phi L (y : I -> R -> R) : lipschitz_on phi L -> (forall i t, continuous (y i) t) ->
  forall t, continuous (fun s => phi (clamp (state y s))) t.
Proof.
intros [L0 HL] Hy t. apply filterlim_locally. intros eta.
assert (Hd : 0 < eta / (L + 1)) by (apply Rdiv_lt_0_compat; [apply cond_pos|lra]).
assert (Near : locally t (fun s => forall j, In j all -> Rabs (y j s - y j t) < eta / (L + 1))).
{ apply (locally_all all t (fun j s => Rabs (y j s - y j t) < eta / (L + 1))). intros j.
  exact (proj1 (filterlim_locally (y j) (y j t)) (Hy j t) (mkposreal _ Hd)). }
revert Near. apply filter_imp. intros s Hs.
change (Rabs (phi (clamp (state y s)) - phi (clamp (state y t))) < eta).
eapply Rle_lt_trans. { apply (HL _ _ (eta / (L + 1))); try apply clamp_in_box.
  intros j. apply clamp_moves_less, Rlt_le, Hs, Hall. }
apply Rmult_lt_reg_r with (L + 1). lra.
replace (L * (eta / (L + 1)) * (L + 1)) with (L * eta) by (field; lra). assert (P := cond_pos eta). lra.
Qed.

Section Field.
Variable X : I -> (I -> R) -> R.
Variable L : R.
Hypothesis HX : forall i, lipschitz_on (X i) L.
Variable start : I -> R.

Let f (i : I) (_ : R) (v : I -> R) : R := X i (clamp v).

Lemma clamped_lipschitz r : exists L, 0 <= L /\ forall s, Rabs (s - 0) <= r -> forall v v' c,
  (forall j, Rabs (v j - v' j) <= c) -> forall i, Rabs (f i s v - f i s v') <= L * c.
Proof.
exists (Rabs L). split. apply Rabs_pos. intros s _ v v' c Hc i. destruct (HX i) as [L0 H].
rewrite (Rabs_pos_eq L) by auto.
apply H; try apply clamp_in_box. intros j. apply clamp_moves_less, Hc.
Qed.

Lemma clamped_solution : exists xi : I -> R -> R, (forall i, xi i 0 = start i) /\
  forall i s, is_derive (xi i) s (X i (clamp (state xi s))).
Proof.
apply (solution_exists I all Hall f).
- intros y Hy i t. apply (clamp_continuous (X i) L y (HX i) Hy).
- exact clamped_lipschitz.
Qed.

(** Two motions that stay in the box. *)
Lemma clamped_unique (xi other : I -> R -> R) T : 0 <= T ->
  (forall s, 0 <= s <= T -> in_box low high (state xi s) /\ in_box low high (state other s)) ->
  (forall i s, 0 <= s <= T -> is_derive (xi i) s (X i (state xi s))) ->
  (forall i s, 0 <= s <= T -> is_derive (other i) s (X i (state other s))) ->
  (forall i, other i 0 = xi i 0) -> forall i, other i T = xi i T.
Proof.
intros HT B D D' E.
assert (S : forall s, segment 0 T s -> 0 <= s <= T) by (intros s; unfold segment; rewrite Rmin_left, Rmax_right; auto).
apply (solution_unique I all Hall f 0 clamped_lipschitz); auto; intros i s Hs; apply S in Hs;
  destruct (B s Hs) as [B1 B2]; unfold f.
- change (fun j => other j s) with (state other s). rewrite (clamp_inside _ B2). auto.
- change (fun j => xi j s) with (state xi s). rewrite (clamp_inside _ B1). auto.
Qed.

End Field.
End Box.
