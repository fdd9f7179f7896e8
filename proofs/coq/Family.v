(** * The family b |-> Theta(., b)

    -Theta'(., b)/b has all the properties that define Theta(., b - 1): so Theta' = -b Theta(., b - 1), and by the
    equation Theta(t, b) = -t Theta(t, b - 1) + (b - 1)(b - 2) Theta(t, b - 3) (proofs/identities.md). [Th b] is a name
    for the function. In the cell b in (m - 1, m), m >= 1, (-1)^m Theta -> +oo as t -> +oo, by induction on m
    (fact 2 of proofs/proofs/count_law.md). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus GammaFunction LaplaceIntegral WellPosed.
Open Scope R_scope.

Lemma not_nat_pred b : not_nat b -> not_nat (b - 1).
Proof. intros H n Hn. apply (H (S n)). rewrite S_INR; lra. Qed.

Lemma not_nat_sub b n : not_nat b -> not_nat (b - INR n).
Proof. intros H k Hk. apply (H (k + n)%nat). rewrite plus_INR; lra. Qed.

Lemma not_nat_neq0 b : not_nat b -> b <> 0.
Proof. intros H. exact (H 0%nat). Qed.

Lemma not_nat_Gamma b : not_nat b -> Gamma (- b) <> 0.
Proof. intros H. apply Gamma_neq0. intros n Hn. apply (H n). lra. Qed.

(** -Theta'/b has all the properties that define Theta(., b - 1). *)
Theorem Theta_shift (b : R) (th : R -> R) : not_nat b -> is_Theta b th ->
  is_Theta (b - 1) (fun t => - / b * Derive th t).
Proof.
intros Hb H.
assert (Hb0 := not_nat_neq0 b Hb). assert (Hg := not_nat_Gamma b Hb).
destruct (is_Theta_elim b th H) as (D0 & D1 & D2).
destruct H as (_ & _ & I0 & I1 & I2).
assert (HG : Gamma (- (b - 1)) = - b * Gamma (- b)).
{ replace (- (b - 1)) with (- b + 1) by ring. apply Gamma_rec; lra. }
assert (HG3 : Gamma ((2 - (b - 1)) / 3) = - b / 3 * Gamma (- b / 3)).
{ replace ((2 - (b - 1)) / 3) with (- b / 3 + 1) by field. apply Gamma_rec; lra. }
assert (Hnz : forall x, Rpower 3 x <> 0) by (intros x; apply Rgt_not_eq, exp_pos).
apply is_Theta_intro with (fun t => - / b * Derive_n th 2 t)
  (fun t => - / b * (t * Derive th t - b * th t)).
- intros t. apply (is_derive_scal (Derive th)), D1.
- intros t. apply (is_derive_scal (Derive_n th 2)), D2.
- intros t.
  replace (t * (- / b * Derive_n th 2 t) - (b - 1) * (- / b * Derive th t))
    with (- / b * ((1 * Derive th t + t * Derive_n th 2 t) - b * Derive th t)) by ring.
  apply (is_derive_scal (fun t => t * Derive th t - b * th t)).
  apply (is_derive_minus (fun t => t * Derive th t) (fun t => b * th t)).
  + apply (is_derive_mult_R (fun t => t) (Derive th)). apply (is_derive_id t). apply D1.
  + apply (is_derive_scal th), D0.
- rewrite I1, HG.
  replace (- (b - 1) / 3) with ((1 - b) / 3) by field.
  replace ((3 + (b - 1)) / 3) with ((2 + b) / 3) by field.
  field. auto.
- rewrite I2, HG.
  replace ((1 - (b - 1)) / 3) with ((2 - b) / 3) by field.
  replace ((2 + (b - 1)) / 3) with ((1 + b) / 3) by field.
  field. auto.
- rewrite I0, HG, HG3.
  replace ((1 + (b - 1)) / 3) with (b / 3) by field.
  replace ((3 + b) / 3) with (1 + b / 3) by field.
  rewrite Rpower_plus, Rpower_1 by lra.
  field. auto.
Qed.

(** (1) Theta' = - b Theta(., b - 1) *)
Theorem Theta_derive (b : R) (th p1 : R -> R) :
  not_nat b -> is_Theta b th -> is_Theta (b - 1) p1 ->
  forall t, Derive th t = - b * p1 t.
Proof.
intros Hb H H1 t.
assert (Hb0 := not_nat_neq0 b Hb).
rewrite (Theta_unique (b - 1) p1 _ H1 (Theta_shift b th Hb H)).
field; auto.
Qed.

(** all derivatives: Theta^(n) = (-b)(1-b)...(n-1-b) Theta(., b - n) *)
Theorem Theta_derive_n (n : nat) : forall (b : R) (th pn : R -> R),
  not_nat b -> is_Theta b th -> is_Theta (b - INR n) pn ->
  forall t, Derive_n th n t = rising (- b) n * pn t.
Proof.
induction n as [|n IH]; intros b th pn Hb H Hn t.
- simpl in *. rewrite Rminus_0_r in Hn. rewrite (Theta_unique b th pn H Hn). ring.
- destruct (Theta_exists (b - INR n)) as [q Hq].
  change (Derive (Derive_n th n) t = rising (- b) n * (- b + INR n) * pn t).
  rewrite (Derive_ext _ (fun t => rising (- b) n * q t)) by (intros; apply IH; auto).
  rewrite Derive_scal.
  rewrite (Theta_derive (b - INR n) q pn).
  + ring.
  + apply not_nat_sub, Hb.
  + exact Hq.
  + replace (b - INR n - 1) with (b - INR (S n)) by (rewrite S_INR; ring). exact Hn.
Qed.

(** (2) the three-term recurrence *)
Theorem Theta_recurrence (b : R) (th p1 p3 : R -> R) :
  not_nat b -> is_Theta b th -> is_Theta (b - 1) p1 -> is_Theta (b - 3) p3 ->
  forall t, th t = - t * p1 t + (b - 1) * (b - 2) * p3 t.
Proof.
intros Hb H H1 H3 t.
assert (Hb0 := not_nat_neq0 b Hb).
assert (E1 := Theta_derive b th p1 Hb H H1 t).
assert (E3 := Theta_derive_n 3 b th p3 Hb H).
replace (b - INR 3) with (b - 3) in E3 by (simpl; ring).
specialize (E3 H3 t).
destruct H as (_ & Hode & _). specialize (Hode t).
rewrite E3, E1 in Hode. simpl in Hode.
apply Rmult_eq_reg_l with b; auto. lra.
Qed.

(** A name for the function: [Th b] is the Theta of parameter b. *)
Definition Th (b : R) : R -> R :=
  PSeries (coef b (Gamma (- b / 3) / (Rpower 3 ((3 + b) / 3) * Gamma (- b)))
                  (Gamma ((1 - b) / 3) / (Rpower 3 ((2 + b) / 3) * Gamma (- b)))
                  (Gamma ((2 - b) / 3) / (Rpower 3 ((1 + b) / 3) * Gamma (- b)))).

Theorem Th_correct (b : R) : is_Theta b (Th b).
Proof.
unfold Th.
set (A0 := Gamma (- b / 3) / (Rpower 3 ((3 + b) / 3) * Gamma (- b))).
set (A1 := Gamma ((1 - b) / 3) / (Rpower 3 ((2 + b) / 3) * Gamma (- b))).
set (A2 := Gamma ((2 - b) / 3) / (Rpower 3 ((1 + b) / 3) * Gamma (- b))).
destruct (s_init b A0 A1 A2) as (H0 & H1 & H2).
apply is_Theta_intro with (PSeries (PS_derive (coef b A0 A1 A2)))
  (PSeries (PS_derive (PS_derive (coef b A0 A1 A2)))); auto.
- apply s_derive0.
- apply s_derive1.
- apply s_derive2.
Qed.

(* From here on only [Th_correct] is used. *)
Global Opaque Th.

Lemma Th_is (b : R) (th : R -> R) : is_Theta b th -> forall t, th t = Th b t.
Proof. intros H. apply (Theta_unique b th (Th b) H (Th_correct b)). Qed.

Lemma Th_derive b t : not_nat b -> is_derive (Th b) t (- b * Th (b - 1) t).
Proof.
intros Hb. rewrite <- (Theta_derive b (Th b) (Th (b - 1)) Hb (Th_correct b) (Th_correct (b - 1))).
destruct (is_Theta_elim b (Th b) (Th_correct b)) as (D0 & _). exact (D0 t).
Qed.

Lemma Th_rec b t : not_nat b -> Th b t = - t * Th (b - 1) t + (b - 1) * (b - 2) * Th (b - 3) t.
Proof. intros Hb. apply (Theta_recurrence b); auto using Th_correct. Qed.

Lemma Th_pos b t : b < 0 -> 0 < Th b t.
Proof. intros Hb. exact (Theta_pos_b_neg b (Th b) Hb (Th_correct b) 0%nat t). Qed.

(** ** t -> +oo *)

Definition cell (m : nat) (b : R) : Prop := INR m - 1 < b < INR m.

Lemma cell_not_nat m b : cell m b -> not_nat b.
Proof.
intros [H1 H2] n ->.
apply INR_lt in H2.
assert (H3 : INR m < INR (S n)) by (rewrite S_INR; lra).
apply INR_lt in H3. lia.
Qed.

Lemma cell_S m b : cell (S m) b -> cell m (b - 1) /\ 0 < b.
Proof.
unfold cell. rewrite S_INR. generalize (pos_INR m). lra.
Qed.

Lemma cell_0 b : cell 0 b -> b < 0.
Proof. unfold cell; simpl; lra. Qed.

Lemma not_nat_cell b : -1 < b -> not_nat b -> exists m, cell m b.
Proof.
intros H0 Hb.
destruct (nfloor_ex (b + 1) ltac:(lra)) as [n [H1 H2]].
exists n. split; [|lra].
assert (H := not_nat_pred (b + 1)).
destruct n as [|n].
- simpl in *; lra.
- rewrite S_INR in *. specialize (Hb n). lra.
Qed.

Theorem Th_right m : forall b, cell m b ->
  (exists c T, 0 < c /\ 0 <= T /\ forall t, T <= t -> c <= (-1) ^ m * Th b t) /\
  ((1 <= m)%nat -> forall M, exists T, 0 <= T /\ forall t, T <= t -> M <= (-1) ^ m * Th b t).
Proof.
induction m as [|m IH]; intros b Hb.
- split; [|lia].
  apply cell_0 in Hb.
  exists (Th b 0), 0. repeat split; try lra. apply Th_pos, Hb.
  intros t Ht. simpl. rewrite Rmult_1_l.
  destruct (Rle_lt_or_eq_dec 0 t Ht) as [H|<-]; [|lra].
  destruct (mvt_open (Th b) (fun t => - b * Th (b - 1) t) 0 t H
    (fun s _ => Th_derive b s (not_nat_neg b Hb))) as (d & Hd & E).
  assert (Hp := Th_pos (b - 1) d ltac:(lra)).
  assert (0 < - b * Th (b - 1) d * (t - 0)).
  { apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; lra. }
  lra.
- assert (Hn := cell_not_nat _ _ Hb).
  destruct (cell_S _ _ Hb) as [Hc Hb0].
  destruct (proj1 (IH (b - 1) Hc)) as (c & T & Hcp & HT & H).
  assert (G : forall M, exists T, 0 <= T /\ forall t, T <= t -> M <= (-1) ^ S m * Th b t).
  { intros M.
    destruct (grow (fun t => (-1) ^ S m * Th b t) (fun t => (-1) ^ S m * (- b * Th (b - 1) t))
      (b * c) T) with (M := M) as (T' & HT1 & HT2).
    - intros t. apply (is_derive_scal (Th b)), Th_derive, Hn.
    - apply Rmult_lt_0_compat; auto.
    - intros t Ht. replace ((-1) ^ S m * (- b * Th (b - 1) t)) with (b * ((-1) ^ m * Th (b - 1) t))
        by (simpl; ring).
      apply Rmult_le_compat_l; [lra|]. apply H, Ht.
    - exists T'. split; [lra|auto]. }
  split; auto.
  destruct (G 1) as (T' & HT1 & HT2).
  exists 1, T'. repeat split; auto; lra.
Qed.
