(** * The compliant model: contacts that last for ever, beta > 1

    The variables of [CompliantGrowth.v]. [growth_set]: for a > 0 and q >= kappa/a + 2a + a^2 the set L, W, G >= 0, D >=
    a L, S >= a (2 + a) L is kept, and lambda grows like e^(aT) (Theorem F3 of flight.md). [entrance]: before q has this
    size a set with two more inequalities is kept, which lies in the first one when q has grown so far (Theorem F4).
    Both by [orthant_kept]. *)

From Coq Require Import Reals Psatz Lra Lia List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCompliant StatementFlight Calculus NonnegativeOrthant CompliantGrowth.
Import ListNotations.
Open Scope R_scope.

Section GrowthSet.
Variables (a1 a2 a3 eps : R).
Hypothesis Heps : 0 < eps.
Variables P B Y V Z : R -> R.
Hypothesis Hlin : forall t, model_at a1 a2 a3 eps linear_force P B Y V Z t.
Hypothesis Ha1 : a1 < 0.
Hypothesis Ha2 : a2 <= 0.
Hypothesis Hkappa : 0 <= kappa a1 a3 eps.
Variable a : R.
Hypothesis Ha : 0 < a.

Notation L := (L eps Y Z).
Notation D := (D eps Y V Z).
Notation W := (W eps V).
Notation G := (G eps P B Y Z).
Notation S := (S eps P B Y V Z).
Notation q := (q P).
Notation A := (A a2 eps).
Notation kappa := (kappa a1 a3 eps).
Notation G' := (G' a1 a2 a3 eps P Y V Z).

Definition enough : R := kappa / a + 2 * a + a ^ 2.

Lemma A_nonnegative : 0 <= A.
Proof. unfold CompliantGrowth.A. assert (0 <= eps * - a2) by (apply Rmult_le_pos; lra). lra. Qed.

Lemma kappa_a : 0 <= kappa / a /\ kappa = kappa / a * a.
Proof. split. apply Rmult_le_pos; auto. apply Rlt_le, Rinv_0_lt_compat, Ha. field. lra. Qed.

Lemma q_monotone s t : s <= t -> q s <= q t.
Proof.
intros H. rewrite (q_affine a1 a2 a3 eps P B Y V Z Hlin s t). assert (0 <= - a1 * (t - s)) by (apply Rmult_le_pos; lra).
lra.
Qed.

Definition f (t : R) : R := D t - a * L t.
Definition f' (t : R) : R := - 2 * D t + S t - a * D t.

Lemma f_derive t : is_derive f t (f' t / eps).
Proof.
eapply is_derive_val. apply (is_derive_minus D (fun t => a * L t)). apply (D_derive a1 a2 a3 eps Heps P B Y V Z Hlin).
apply (is_derive_scal L), (L_derive a1 a2 a3 eps Heps P B Y V Z Hlin). unfold minus, plus, opp; simpl. unfold f'. field.
lra.
Qed.

Section Kept.
Variable t0 : R.
Hypothesis Hq : enough <= q t0.
Hypothesis H0 : 0 <= L t0 /\ 0 <= W t0 /\ 0 <= G t0 /\ a * L t0 <= D t0 /\ a * (2 + a) * L t0 <= S t0 /\ 0 < D t0.

Definition g (t : R) : R := S t - a * (2 + a) * L t.
Definition g' (t : R) : R := G t + G' t - a * (2 + a) * D t.

Lemma g_derive t : is_derive g t (g' t / eps).
Proof.
eapply is_derive_val. apply (is_derive_minus S (fun t => a * (2 + a) * L t)).
apply (S_derive a1 a2 a3 eps Heps P B Y V Z Hlin).
apply (is_derive_scal L), (L_derive a1 a2 a3 eps Heps P B Y V Z Hlin). unfold minus, plus, opp; simpl. unfold g'. field.
lra.
Qed.

Lemma set_kept t : t0 <= t -> 0 <= L t /\ 0 <= W t /\ 0 <= f t /\ 0 <= g t /\ 0 <= G t.
Proof.
intros Ht. destruct kappa_a as (K0 & Ka). assert (HA := A_nonnegative).
set (comps := [(L, D); (W, G); (f, f'); (g, g'); (G, G')] : list component).
assert (O : forall x x', In (x, x') comps -> 0 <= x t).
{ intros x x' Hx. apply (orthant_kept eps (2 + 2 * a + q t + a * q t) t0 t comps Heps) with (x' := x'); auto; try lra.
  - intros w w' s Hw _. unfold comps in Hw. simpl in Hw.
    destruct Hw as [E|[E|[E|[E|[E|[]]]]]]; injection E as <- <-;
      [apply (L_derive a1 a2 a3 eps Heps P B Y V Z Hlin)|apply (W_derive a1 a2 a3 eps Heps P B Y V Z Hlin)|apply
        f_derive|apply g_derive|
       apply (G_derive a1 a2 a3 eps Heps P B Y V Z Hlin)].
  - intros w w' Hw. unfold comps in Hw. simpl in Hw. unfold f, g in Hw.
    destruct Hw as [E|[E|[E|[E|[E|[]]]]]]; injection E as <- _; lra.
  - intros s m Hs Hm Hall.
    assert (ML : - m <= L s) by (apply (Hall L D); simpl; auto).
    assert (MW : - m <= W s) by (apply (Hall W G); simpl; auto).
    assert (Mf : - m <= f s) by (apply (Hall f f'); simpl; auto).
    assert (Mg : - m <= g s) by (apply (Hall g g'); simpl; auto 6).
    assert (MG : - m <= G s) by (apply (Hall G G'); simpl; auto 8).
    assert (Q0 := q_monotone t0 s (proj1 Hs)). assert (Q1 := q_monotone s t (proj2 Hs)).
    assert (a2p : 0 < a ^ 2) by (apply pow_lt, Ha).
    set (r := q s - 2 * a - a ^ 2). assert (Hr : kappa / a <= r) by (unfold r, enough in *; lra).
    assert (Har : 0 <= (r - kappa / a) * a) by (apply Rmult_le_pos; lra).
    assert (P1 : 0 <= a * m) by (apply Rmult_le_pos; lra).
    assert (P2 : 0 <= (q t - q s) * m) by (apply Rmult_le_pos; lra).
    assert (P3 : 0 <= q s * m) by (apply Rmult_le_pos; unfold r in *; lra).
    assert (P4 : 0 <= a * (q t - q s) * m) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
    assert (P5 : 0 <= kappa * m) by (apply Rmult_le_pos; lra).
    assert (P6 : 0 <= a * q s * m) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; unfold r in *; lra).
    assert (P7 : 0 <= a ^ 2 * m) by (apply Rmult_le_pos; lra).
    intros w w' Hw Ew. simpl in Hw.
    destruct Hw as [E|[E|[E|[E|[E|[]]]]]]; injection E as <- <-.
    + unfold f in Mf. rewrite Ew in Mf. lra.
    + lra.
    + assert (E1 : f' s = g s - (2 + a) * f s) by (unfold f', f, g; ring). rewrite E1, Ew. lra.
    + assert (E1 : g' s = G s + r * f s + (r * a - kappa) * L s + A) by (unfold g', CompliantGrowth.G', f, r; ring).
      rewrite E1.
      assert (0 <= r * (f s + m)) by (apply Rmult_le_pos; lra).
      assert (0 <= (r * a - kappa) * (L s + m)) by (apply Rmult_le_pos; lra).
      assert (0 <= a * a ^ 2 * m) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
      assert (E2 : r * m = q s * m - 2 * (a * m) - a ^ 2 * m) by (unfold r; ring).
      assert (E3 : r * a * m = a * q s * m - 2 * (a ^ 2 * m) - a * a ^ 2 * m) by (unfold r; ring). lra.
    + assert (E1 : G' s = q s * f s + (q s * a - kappa) * L s + A) by (unfold CompliantGrowth.G', f; ring). rewrite E1.
      assert (0 <= q s * (f s + m)) by (apply Rmult_le_pos; unfold r in *; lra).
      assert (E2 : r * a = q s * a - 2 * a ^ 2 - a * a ^ 2) by (unfold r; ring).
      assert (0 <= a * a ^ 2) by (apply Rmult_le_pos; lra).
      assert (0 <= (q s * a - kappa) * (L s + m)) by (apply Rmult_le_pos; lra). lra. }
refine (conj (O L D _) (conj (O W G _) (conj (O f f' _) (conj (O g g' _) (O G G' _))))); simpl; auto 8.
Qed.

Theorem growth_set : grows_from eps Y V Z t0.
Proof.
assert (a2p : 0 < a * (2 + a)) by (apply Rmult_lt_0_compat; lra).
assert (HS : forall t, t0 <= t -> a * (2 + a) * L t <= S t)
  by (intros t Ht; destruct (set_kept t Ht) as (_ & _ & _ & H & _); unfold g in H; lra).
assert (HL : forall t, t0 <= t -> 0 <= L t) by (intros t Ht; apply (set_kept t Ht)).
assert (Pos : forall t, t0 <= t -> 0 < D t).
{ apply (D_positive a1 a2 a3 eps Heps P B Y V Z Hlin). 2: apply H0.
  intros t Ht. assert (0 <= a * (2 + a) * L t) by (apply Rmult_le_pos; auto; lra). generalize (HS t Ht). lra. }
refine (conj HL (conj Pos _)).
assert (Up : forall s t, t0 <= s -> s < t -> L s < L t).
{ intros s t Hs Hst.
  destruct (mvt_open L (fun t => D t / eps) s t Hst (fun r _ => L_derive a1 a2 a3 eps Heps P B Y V Z Hlin r))
    as (c & Hc & E).
  assert (0 < D c / eps * (t - s)); [|lra]. apply Rmult_lt_0_compat; [|lra]. apply Rdiv_lt_0_compat; auto. apply Pos.
  lra. }
apply (force_to_infinity a1 a2 a3 eps Heps P B Y V Z Hlin t0).
- intros t Ht. apply Rlt_le, Pos, Ht.
- exists (a * (2 + a) * L (t0 + 1)), (t0 + 1). split.
  + apply Rmult_lt_0_compat; auto. generalize (HL t0 (Rle_refl _)) (Up t0 (t0 + 1) (Rle_refl _) ltac:(lra)). lra.
  + intros t Ht. eapply Rle_trans; [|apply HS; lra]. apply Rmult_le_compat_l. lra.
    destruct (Rle_lt_or_eq_dec _ _ Ht) as [Hl|<-]; [apply Rlt_le, Up|]; lra.
Qed.

End Kept.

(** ** The way into this set (Theorem F4) *)
Section Entrance.
Variables (t0 c : R).
Hypothesis Ha' : a < 1.
Hypothesis Hc : 0 < c.
Hypothesis H0 : 0 <= L t0 /\ 0 <= W t0 /\ 0 < S t0 /\ a * L t0 <= D t0 /\ a * (D t0 + 2 * L t0) <= S t0 /\
  a * S t0 <= G t0 /\ c * S t0 <= D t0.
Hypothesis Hk : a ^ 2 <= (1 - a) * c * (q t0 - kappa / a).
Hypothesis Hm : c * A <= (1 - 3 * c - c ^ 2 * enough) * S t0.

Definition late_g (t : R) : R := S t - a * (D t + 2 * L t).
Definition late_s (t : R) : R := S t - S t0.
Definition late_k (t : R) : R := G t - a * S t.
Definition late_m (t : R) : R := D t - c * S t.
Definition S' (t : R) : R := G t + G' t.

Lemma late_derives t : is_derive late_g t ((S' t - a * S t) / eps) /\ is_derive late_s t (S' t / eps) /\
  is_derive late_k t ((G' t - a * S' t) / eps) /\ is_derive late_m t ((- 2 * D t + S t - c * S' t) / eps).
Proof.
assert (DL := L_derive a1 a2 a3 eps Heps P B Y V Z Hlin t). assert (DD := D_derive a1 a2 a3 eps Heps P B Y V Z Hlin t).
assert (DS := S_derive a1 a2 a3 eps Heps P B Y V Z Hlin t). assert (DG := G_derive a1 a2 a3 eps Heps P B Y V Z Hlin t).
fold (S' t) in DS. refine (conj _ (conj _ (conj _ _))).
- eapply is_derive_val. apply (is_derive_minus S (fun t => a * (D t + 2 * L t))). exact DS.
  apply (is_derive_scal (fun t => D t + 2 * L t)). apply (is_derive_plus D (fun t => 2 * L t)). exact DD.
  apply (is_derive_scal L), DL.
  unfold minus, plus, opp; simpl. field. lra.
- eapply is_derive_val. apply (is_derive_minus S (fun _ => S t0)). exact DS. apply (is_derive_const (S t0)).
  unfold minus, plus, opp, zero; simpl. ring.
- eapply is_derive_val. apply (is_derive_minus G (fun t => a * S t)). exact DG. apply (is_derive_scal S), DS.
  unfold minus, plus, opp; simpl. field. lra.
- eapply is_derive_val. apply (is_derive_minus D (fun t => c * S t)). exact DD. apply (is_derive_scal S), DS.
  unfold minus, plus, opp; simpl. field. lra.
Qed.

(** Plan: [orthant_kept] for the seven components L, W, f, late_g, late_s, late_k, late_m. What it asks is shown one
    component after the other: its derivative, written by the components (E1), has coefficients >= 0 off the diagonal
    while q <= enough (R1 to R8 are the products of such bounds with m). *)
Lemma late_kept t1 t : q t1 <= enough -> t0 <= t <= t1 ->
  0 <= L t /\ 0 <= W t /\ 0 <= f t /\ 0 <= late_g t /\ 0 <= late_s t /\ 0 <= late_k t /\ 0 <= late_m t.
Proof.
intros Hq1 Ht. destruct kappa_a as (K0 & Ka). assert (HA := A_nonnegative).
destruct H0 as (H0L & H0W & H0S & H0f & H0g & H0k & H0m).
set (comps := [(L, D); (W, G); (f, f'); (late_g, fun t => S' t - a * S t); (late_s, S');
  (late_k, fun t => G' t - a * S' t);
  (late_m, fun t => - 2 * D t + S t - c * S' t)] : list component).
assert (O : forall x x', In (x, x') comps -> 0 <= x t).
{ intros x x' Hx.
  apply (orthant_kept eps (2 + a + c + enough * (1 + c) + kappa / a + c * kappa) t0 t1 comps Heps) with (x' := x');
    auto.
  - intros w w' s Hw _. unfold comps in Hw. simpl in Hw. destruct (late_derives s) as (D1 & D2 & D3 & D4).
    destruct Hw as [E|[E|[E|[E|[E|[E|[E|[]]]]]]]]; injection E as <- <-; auto;
      [apply (L_derive a1 a2 a3 eps Heps P B Y V Z Hlin)|apply (W_derive a1 a2 a3 eps Heps P B Y V Z Hlin)|apply
        f_derive].
  - intros w w' Hw. unfold comps in Hw. simpl in Hw.
    destruct Hw as [E|[E|[E|[E|[E|[E|[E|[]]]]]]]]; injection E as <- _; unfold f, late_g, late_s, late_k, late_m; lra.
  - intros s m Hs Hmm Hall.
    assert (ML : - m <= L s) by (apply (Hall L D); simpl; auto).
    assert (MW : - m <= W s) by (apply (Hall W G); simpl; auto).
    assert (Mf : - m <= f s) by (apply (Hall f f'); simpl; auto).
    assert (Mg : - m <= late_g s) by (apply (Hall late_g (fun t => S' t - a * S t)); simpl; auto 6).
    assert (Ms : - m <= late_s s) by (apply (Hall late_s S'); simpl; auto 8).
    assert (Mk : - m <= late_k s) by (apply (Hall late_k (fun t => G' t - a * S' t)); simpl; auto 8).
    assert (Mm : - m <= late_m s) by (apply (Hall late_m (fun t => - 2 * D t + S t - c * S' t)); simpl; auto 10).
    assert (Q0 := q_monotone t0 s (proj1 Hs)). assert (Q1 := q_monotone s t1 (proj2 Hs)).
    set (r := q s - kappa / a). set (r0 := q t0 - kappa / a).
    assert (r00 : 0 <= r0).
    { apply Rnot_lt_le. intros Hn. assert (0 < (1 - a) * c) by (apply Rmult_lt_0_compat; lra).
      assert (0 <= (1 - a) * c * - r0) by (apply Rmult_le_pos; lra). assert (0 < a ^ 2) by (apply pow_lt, Ha).
      unfold r0 in *. lra. }
    assert (Hr : r0 <= r <= enough) by (unfold r, r0; lra).
    assert (R1 : 0 <= (enough - r) * m) by (apply Rmult_le_pos; lra).
    assert (R2 : 0 <= (enough - r) * (c * m)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]).
    assert (R3 : 0 <= r * m) by (apply Rmult_le_pos; lra).
    assert (R4 : 0 <= r * (c * m)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]).
    assert (R5 : 0 <= a * m) by (apply Rmult_le_pos; lra). assert (R6 : 0 <= c * m) by (apply Rmult_le_pos; lra).
    assert (R7 : 0 <= kappa / a * m) by (apply Rmult_le_pos; lra).
    assert (R8 : 0 <= c * kappa * m) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
    assert (Es : S s = S t0 + late_s s) by (unfold late_s; ring).
    assert (HS : - m <= S s) by lra.
    assert (EG : G' s = r * (late_m s + c * S s) + kappa / a * f s + A).
    { unfold CompliantGrowth.G', late_m, f, r. rewrite Ka at 1. ring. }
    assert (G1 : 0 <= r * (late_m s + m)) by (apply Rmult_le_pos; lra).
    assert (G2 : 0 <= r * (c * (S s + m))) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]).
    assert (G3 : 0 <= kappa / a * (f s + m)) by (apply Rmult_le_pos; lra).
    assert (G4 : 0 <= a * (S s + m)) by (apply Rmult_le_pos; lra).
    intros w w' Hw Ew. simpl in Hw.
    destruct Hw as [E|[E|[E|[E|[E|[E|[E|[]]]]]]]]; injection E as <- <-.
    + unfold f in Mf. rewrite Ew in Mf. lra.
    + unfold late_k in Mk. lra.
    + assert (E1 : f' s = late_g s - 2 * f s) by (unfold f', late_g, f; ring). rewrite E1, Ew. lra.
    + assert (E1 : S' s - a * S s = late_k s + G' s) by (unfold S', late_k; ring). rewrite E1, EG. lra.
    + assert (E1 : S' s = late_k s + a * S s + G' s) by (unfold S', late_k; ring). rewrite E1, EG. lra.
    + assert (E1 : G' s - a * S' s = - a * late_k s + (1 - a) * (r * late_m s + kappa / a * f s + A)
        + ((1 - a) * c * r - a ^ 2) * S s).
      { unfold S'. replace (G' s - a * (G s + G' s)) with ((1 - a) * G' s - a * G s) by ring. rewrite EG. unfold late_k.
        ring. }
      rewrite E1, Ew.
      assert (B1 : 0 <= (1 - a) * (r * (late_m s + m) + kappa / a * (f s + m) + A)) by (apply Rmult_le_pos; lra).
      assert (B2 : 0 <= a * (r * m)) by (apply Rmult_le_pos; lra).
      assert (B3 : 0 <= a * (kappa / a * m)) by (apply Rmult_le_pos; lra).
      assert (B4 : 0 <= (1 - a) * c * r - a ^ 2).
      { assert (0 <= (1 - a) * c * (r - r0)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). unfold r0 in *. lra. }
      assert (B5 : 0 <= ((1 - a) * c * r - a ^ 2) * (S s + m)) by (apply Rmult_le_pos; lra).
      assert (B6 : 0 <= a * (r * (c * m))) by (apply Rmult_le_pos; lra).
      assert (B7 : 0 <= a ^ 2 * m) by (apply Rmult_le_pos; [apply pow_le|]; lra). lra.
    + assert (E1 : - 2 * D s + S s - c * S' s
        = - (2 + c * q s) * late_m s + (1 - 3 * c - c ^ 2 * q s) * S s + c * W s + c * kappa * L s - c * A).
      { assert (EW : G s = S s - W s) by (unfold CompliantGrowth.S; ring).
        unfold S', CompliantGrowth.G', late_m. rewrite EW. ring. }
      rewrite E1, Ew.
      assert (c2 : 0 <= c ^ 2) by (apply pow_le; lra).
      assert (C1 : 0 <= c ^ 2 * (enough - q s)) by (apply Rmult_le_pos; lra).
      assert (C0 : 0 <= 1 - 3 * c - c ^ 2 * enough).
      { apply Rnot_lt_le. intros Hn.
        assert (0 < - (1 - 3 * c - c ^ 2 * enough) * S t0) by (apply Rmult_lt_0_compat; lra).
        assert (0 <= c * A) by (apply Rmult_le_pos; lra). lra. }
      assert (C2 : 0 <= c ^ 2 * (enough - q s) * S t0) by (apply Rmult_le_pos; lra).
      assert (C3 : 0 <= (1 - 3 * c - c ^ 2 * q s) * (late_s s + m)) by (apply Rmult_le_pos; lra).
      assert (C4 : 0 <= c * (W s + m)) by (apply Rmult_le_pos; lra).
      assert (C5 : 0 <= c * kappa * (L s + m)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
      assert (qs : 0 <= q s) by (unfold r in *; lra).
      assert (C6 : 0 <= c * q s * m) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
      assert (C7 : 0 <= c ^ 2 * q s * m) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
      assert (C8 : 0 <= enough * m) by lra.
      rewrite Es. lra. }
refine (conj (O L D _) (conj (O W G _) (conj (O f f' _) (conj (O late_g (fun t => S' t - a * S t) _)
  (conj (O late_s S' _) (conj (O late_k (fun t => G' t - a * S' t) _) (O late_m (fun t => - 2 * D t + S t - c * S' t)
    _))))))); simpl; auto 10.
Qed.

Theorem entrance : grows_from eps Y V Z t0.
Proof.
assert (Into : forall t, enough <= q t -> 0 <= L t -> 0 <= W t -> 0 < S t -> 0 <= f t -> 0 <= late_g t ->
  0 <= late_k t -> 0 <= late_m t ->
  grows_from eps Y V Z t).
{ intros t Hq HL HW HS Hf Hg HG HD. unfold f, late_g, late_k, late_m in *.
  assert (0 < a * S t) by (apply Rmult_lt_0_compat; auto). assert (0 < c * S t) by (apply Rmult_lt_0_compat; auto).
  assert (0 <= a * (D t - a * L t)) by (apply Rmult_le_pos; lra).
  apply growth_set; auto. repeat split; lra. }
destruct (Rle_dec enough (q t0)) as [Hq|Hq].
{ unfold f, late_g, late_k, late_m in Into. apply Into; lra. }
set (t1 := t0 + (enough - q t0) / - a1).
assert (H01 : t0 < t1) by (assert (0 < (enough - q t0) / - a1) by (apply Rdiv_lt_0_compat; lra); unfold t1; lra).
assert (E1 : q t1 = enough).
{ rewrite (q_affine a1 a2 a3 eps P B Y V Z Hlin t0 t1). unfold t1. field. lra. }
assert (Kept := fun t => late_kept t1 t (Req_le _ _ E1)).
assert (Sp : forall t, t0 <= t <= t1 -> 0 < S t).
{ intros t Ht. destruct (Kept t Ht) as (_ & _ & _ & _ & H & _). unfold late_s in H. lra. }
destruct (Into t1) as (HL & HD & Hinf); try (apply (Kept t1); lra).
{ lra. } { apply Sp. lra. }
refine (conj _ (conj _ Hinf)); intros t Ht; destruct (Rle_dec t1 t) as [Hl|Hl]; auto.
- apply (Kept t). lra.
- destruct (Kept t ltac:(lra)) as (_ & _ & _ & _ & _ & _ & H). specialize (Sp t ltac:(lra)). unfold late_m in H.
  assert (0 < c * S t) by (apply Rmult_lt_0_compat; auto). lra.
Qed.

End Entrance.
End GrowthSet.
