(** * What the checker computes about one solution is right

    b = (centre + radius eta)/unit and weights rho are fixed. From models of f, f', f'' at a point follow models of the
    Taylor coefficients there; by the tail lemma their sum is a model of f at the next point, and the sign of the first
    one, if it exceeds all others, is that of f on the box. *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qabs Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate RecurrenceTail SolutionSeries Checker CheckerModels.
Import ListNotations.
Open Scope R_scope.

Lemma Q2R_fraction (z : Z) (d : positive) : Q2R (z # d) = IZR z / IZR (Zpos d).
Proof. reflexivity. Qed.

Lemma Q2R_whole z : Q2R (inject_Z z) = IZR z.
Proof. unfold inject_Z. rewrite Q2R_fraction. field. Qed.

Lemma Q2R_red q : Q2R (Qred q) = Q2R q.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma Q2R_halved q : Q2R (q / 2) = Q2R q / 2.
Proof. rewrite Q2R_div; [|discriminate]. replace (Q2R 2) with 2; [reflexivity|]. unfold Q2R; simpl; field. Qed.

Lemma Q2R_Qabs q : Q2R (Qabs q) = Rabs (Q2R q).
Proof.
destruct (Qlt_le_dec q 0) as [H|H].
- rewrite (Qeq_eqR _ _ (Qabs_neg q (Qlt_le_weak _ _ H))), Q2R_opp. apply Qlt_Rlt in H.
  rewrite Rabs_left; [reflexivity|].
  replace (Q2R 0) with 0 in H by (unfold Q2R; simpl; field). lra.
- rewrite (Qeq_eqR _ _ (Qabs_pos q H)). apply Qle_Rle in H. rewrite Rabs_pos_eq; [reflexivity|].
  replace (Q2R 0) with 0 in H by (unfold Q2R; simpl; field). lra.
Qed.

Lemma positive_R q : is_positive q = true -> 0 < Q2R q.
Proof.
unfold is_positive. intros H. apply Z.ltb_lt in H. unfold Q2R. apply Rmult_lt_0_compat. apply IZR_lt; auto.
apply Rinv_0_lt_compat. apply IZR_lt. reflexivity.
Qed.

Lemma sum_first_head (v : nat -> R) n : sum_first v (S n) = v 0%nat + sum_first (fun i => v (S i)) n.
Proof. induction n as [|n IH]. simpl. ring. change (sum_first v (S (S n))) with (sum_first v (S n) + v (S n)).
rewrite IH. simpl. ring. Qed.

Lemma sum_first_mono (v v' : nat -> R) n : (forall k, v k <= v' k) -> sum_first v n <= sum_first v' n.
Proof. intros H. induction n as [|n IH]; simpl. lra. assert (A := H n). lra. Qed.

Lemma some_injective {A : Type} (x y : A) : Some x = Some y -> x = y.
Proof. intros H. injection H. auto. Qed.

Section Enclosure.
Variables (g : setting) (b eta : R) (rho : nat -> R).
Hypothesis Heta : Rabs eta <= 1.
Hypothesis Hunit : (0 < b_unit g)%Z.
Hypothesis Hb : IZR (b_unit g) * b = IZR (b_centre g) + IZR (b_radius g) * eta.
Hypothesis Hrho : weights rho.
Hypothesis Hrho0 : rho 0%nat = 1.

Let holds := CheckerModels.holds eta rho.

Lemma unit_pos : 0 < IZR (b_unit g).
Proof. apply IZR_lt; auto. Qed.

Lemma holds_minus_b i factor m y : holds m y ->
  holds (minus_b g i factor m) (IZR factor * IZR (b_unit g) * (IZR i - b) * y).
Proof.
intros H. unfold minus_b.
replace (IZR factor * IZR (b_unit g) * (IZR i - b) * y)
  with ((IZR (factor * (i * b_unit g - b_centre g)) + IZR (- (factor * b_radius g)) * eta) * y).
- apply holds_linear; auto.
- rewrite opp_IZR, !mult_IZR, minus_IZR, mult_IZR.
  replace (IZR factor * IZR (b_unit g) * (IZR i - b) * y)
    with (IZR factor * (IZR i * IZR (b_unit g) - IZR (b_unit g) * b) * y) by ring.
  rewrite Hb. ring.
Qed.

Lemma holds_multiple q m y : holds m y -> holds (multiple g q m) (Q2R q * y).
Proof.
intros H. unfold multiple. replace (Q2R q * y) with (IZR (Qnum q) * y / IZR (Zpos (Qden q))).
- apply holds_shrink; auto. reflexivity. apply holds_times, H.
- unfold Q2R. field. apply IZR_neq. discriminate.
Qed.

(** ** The coefficients *)
Fixpoint list_holds (l : list model) (a : nat -> R) (k : nat) : Prop :=
  match l with
  | [] => True
  | m :: l => holds m (a k) /\ list_holds l a (S k)
  end.

Lemma list_holds_skipn a j : forall l k, list_holds l a k -> list_holds (skipn j l) a (k + j).
Proof.
induction j as [|j IH]; intros [|m l] k H; simpl; auto.
- rewrite Nat.add_0_r. exact H.
- replace (k + S j)%nat with (S k + j)%nat by lia. apply IH, H.
Qed.

Lemma list_holds_sum a : forall l k, list_holds l a k ->
  holds (fold_right model_plus zero_model l) (sum_first (fun i => a (k + i)%nat) (length l)).
Proof.
induction l as [|m l IH]; intros k H.
- apply holds_zero.
- cbn [fold_right length]. rewrite sum_first_head, Nat.add_0_r. apply holds_plus; [apply H|].
  assert (E : sum_first (fun i => a (k + S i)%nat) (length l) = sum_first (fun i => a (S k + i)%nat) (length l)).
  { clear. induction (length l) as [|n IH]; simpl; [reflexivity|]. rewrite IH. repeat f_equal. lia. }
  rewrite E. apply IH, H.
Qed.

Lemma list_holds_norms a u : Rabs u <= 1 -> forall l k, list_holds l a k ->
  Rabs (sum_first (fun i => a (k + i)%nat * u ^ (k + i)) (length l)) <= IZR
    (fold_right (fun a s => model_norm a + s)%Z 0%Z l).
Proof.
intros Hu. assert (P : forall n, Rabs (u ^ n) <= 1).
{ intros n. rewrite <- RPow_abs. rewrite <- (pow1 n). apply pow_incr. split; auto using Rabs_pos. }
induction l as [|m l IH]; intros k H.
- simpl. rewrite Rabs_R0. lra.
- cbn [fold_right length]. rewrite sum_first_head, Nat.add_0_r, plus_IZR. apply Rabs_plus_le.
  + rewrite Rmult_comm. apply times_at_most_one; auto. apply (holds_norm eta Heta rho Hrho), H.
  + assert (E : sum_first (fun i => a (k + S i)%nat * u ^ (k + S i)) (length l) = sum_first (fun i =>
      a (S k + i)%nat * u ^ (S k + i)) (length l)).
    { clear. induction (length l) as [|n IH]; simpl sum_first; [reflexivity|]. rewrite IH.
      replace (k + S n)%nat with (S k + n)%nat by lia. reflexivity. }
    rewrite E. apply IH, H.
Qed.

Lemma list_holds_slopes a : forall l j, list_holds l a (S j) ->
  list_holds (slopes_from (Z.of_nat (S j)) l) (fun n => (INR n + 1) * a (S n)) j.
Proof.
induction l as [|m l IH]; intros j H; [exact I|]. cbn [slopes_from list_holds]. split.
- replace (INR j + 1) with (IZR (Z.of_nat (S j))) by (rewrite <- INR_IZR_INZ, S_INR; reflexivity). apply holds_times, H.
- replace (Z.of_nat (S j) + 1)%Z with (Z.of_nat (S (S j))) by lia. apply IH, H.
Qed.

Lemma slopes_hold a l : list_holds l a 0 -> list_holds (slopes l) (fun n => (INR n + 1) * a (S n)) 0.
Proof.
destruct l as [|m l]; intros H; [exact I|]. unfold slopes. cbn [tl]. apply (list_holds_slopes a l 0), H.
Qed.

Section AtPoint.
Variables (t s : Q) (e : step) (c : nat -> R).
Hypothesis He : step_is_right g t s e = true.
Hypothesis Hc : recurrence b (Q2R t) c.

Lemma step_right : (0 < common e)%Z /\ IZR (square e) = IZR (common e) * (Q2R t * Q2R s ^ 2) /\
  IZR (cube e) * IZR (b_unit g) = IZR (common e) * Q2R s ^ 3.
Proof.
unfold step_is_right in He. destruct (common e) as [|d|d]; try discriminate. apply andb_prop in He.
destruct He as [E1 E2].
apply Qeq_bool_eq, Qeq_eqR in E1. apply Qeq_bool_eq, Qeq_eqR in E2. assert (U := unit_pos).
assert (D : 0 < IZR (Zpos d)) by (apply IZR_lt; reflexivity).
rewrite Q2R_fraction, !Q2R_mult in E1.
rewrite Q2R_fraction, Q2R_div, !Q2R_mult, Q2R_whole in E2.
2: { intros Z. apply Qeq_eqR in Z. rewrite Q2R_whole in Z. replace (Q2R 0) with 0 in Z by (unfold Q2R; simpl; field).
     lra. }
split; [reflexivity|]. split.
- replace (IZR (square e)) with (IZR (square e) / IZR (Zpos d) * IZR (Zpos d)) by (field; lra). rewrite E1. ring.
- replace (IZR (cube e) * IZR (b_unit g)) with (IZR (cube e) / IZR (Zpos d) * IZR (Zpos d) * IZR (b_unit g))
    by (field; lra). rewrite E2. field. lra.
Qed.

Let a k := c k * Q2R s ^ k.

Lemma holds_next k m0 m1 : holds m0 (a k) -> holds m1 (a (S k)) -> holds (next_coefficient g e (Z.of_nat k) m0 m1)
  (a (S (S (S k)))).
Proof.
intros H0 H1. destruct step_right as (D & E1 & E2). assert (Dr : 0 < IZR (common e)) by (apply IZR_lt; auto).
unfold next_coefficient. set (z := Z.of_nat k) in *.
assert (Ez : IZR z = INR k) by (unfold z; symmetry; apply INR_IZR_INZ).
assert (Hk := pos_INR k).
replace (a (S (S (S k)))) with ((IZR (square e * (z + 1)) * a (S k) + IZR (cube e) * IZR (b_unit g) * (IZR z - b) * a k)
  / IZR (common e * ((z + 1) * (z + 2) * (z + 3)))).
- apply holds_shrink; auto.
  + assert (0 <= z)%Z by (unfold z; lia). apply Z.mul_pos_pos; auto. apply Z.mul_pos_pos; [apply Z.mul_pos_pos|]; lia.
  + apply holds_plus. apply holds_times, H1. apply holds_minus_b, H0.
- rewrite !mult_IZR, !plus_IZR, Ez, E1, E2. unfold a.
  assert (R := Hc k). replace (k + 3)%nat with (S (S (S k))) in R by lia. replace (k + 1)%nat with (S k) in R by lia.
  apply Rmult_eq_reg_r with (IZR (common e) * ((INR k + 1) * (INR k + 2) * (INR k + 3))).
  2: { apply Rgt_not_eq. apply Rmult_lt_0_compat; auto. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. }
  transitivity (IZR (common e) * Q2R s ^ 3 * Q2R s ^ k * (Q2R t * (INR k + 1) * c (S k) + (INR k - b) * c k)).
  + simpl. field. lra.
  + rewrite <- R. simpl. ring.
Qed.

Lemma coefficients_hold fuel small : forall k m0 m1 m2, holds m0 (a k) -> holds m1 (a (S k)) ->
  holds m2 (a (S (S k))) ->
  list_holds (coefficients fuel g e small (Z.of_nat k) m0 m1 m2) a k.
Proof.
induction fuel as [|fuel IH]; intros k m0 m1 m2 H0 H1 H2; cbn [coefficients].
- repeat split; auto.
- destruct ((model_norm m0 <=? small) && (model_norm m1 <=? small) && (model_norm m2 <=? small))%Z;
    [repeat split; auto|].
  split; auto. replace (Z.of_nat k + 1)%Z with (Z.of_nat (S k)) by lia. apply IH; auto. apply holds_next; auto.
Qed.
End AtPoint.

(** ** The sum, on the whole box *)
Section Sum.
Variables (beta : R) (t s : Q) (f f1 f2 : R -> R) (c : nat -> R) (l : list model).
Hypothesis Hbeta : 1 <= IZR (b_most g) /\ Rabs beta <= IZR (b_most g).
Hypothesis Hs : 0 < Q2R s.
Hypothesis Hf : solves beta f f1 f2.
Hypothesis Hc : recurrence beta (Q2R t) c.
Hypothesis Hstart : c 0%nat = f (Q2R t) /\ c 1%nat = f1 (Q2R t) /\ 2 * c 2%nat = f2 (Q2R t).
Hypothesis Hl : list_holds l (fun k => c k * Q2R s ^ k) 0.
Hypothesis Hsmall : tail_is_small (b_most g) t s (length l) = true.

Lemma tail_bounded u : Rabs u <= 1 ->
  Rabs (f (Q2R t + u * Q2R s) - sum_first (fun k => c k * Q2R s ^ k * u ^ k) (length l)) <= IZR (tail_bound l).
Proof.
intros Hu. unfold tail_is_small in Hsmall. apply andb_prop in Hsmall. destruct Hsmall as [H3 Hq]. apply Z.leb_le in H3.
set (n := length l) in *. set (I := (n - 3)%nat). assert (En : n = (I + 3)%nat) by (unfold I; lia).
apply Qle_bool_iff, Qle_Rle in Hq. replace (Z.of_nat n - 3)%Z with (Z.of_nat I) in Hq by lia.
rewrite !Q2R_mult, !Q2R_plus, !Q2R_mult, !Q2R_plus, !Q2R_whole, Q2R_Qabs, <- INR_IZR_INZ in Hq.
replace (Q2R 1) with 1 in Hq by (unfold Q2R; simpl; field). replace (Q2R 2) with 2 in Hq by (unfold Q2R; simpl; field).
replace (Q2R 3) with 3 in Hq by (unfold Q2R; simpl; field).
set (B := IZR (b_most g)) in *. set (T := Q2R t) in *. set (S := Q2R s) in *. assert (HI := pos_INR I).
set (q := ratio T S B I).
assert (D : 0 < (INR I + 1) * (INR I + 2) * (INR I + 3)) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
assert (Q2 : q <= 1 / 2).
{ unfold q, ratio. apply Rmult_le_reg_r with (2 * ((INR I + 1) * (INR I + 2) * (INR I + 3))); [lra|].
  eapply Rle_trans; [|eapply Rle_trans; [exact Hq|]]; right; field; lra. }
assert (Q0 : 0 <= q) by (apply ratio_pos; auto; apply Hbeta).
assert (Tail := recurrence_tail beta T S B c I Hs (proj1 Hbeta) (proj2 Hbeta) Hc ltac:(fold q; lra)).
fold q in Tail. set (mu := Rmax (size S c I) (Rmax (size S c (I + 1)) (size S c (I + 2)))) in Tail.
assert (Mu : mu <= IZR (fold_right (fun a m => Z.max (model_norm a) m) 0%Z (skipn I l))).
{ assert (Hk := list_holds_skipn _ I l 0 Hl). cbn [Nat.add] in Hk. assert (L := skipn_length I l). fold n in L.
  destruct (skipn I l) as [|m0 [|m1 [|m2 [|]]]]; simpl in L; try lia. destruct Hk as (K0 & K1 & K2 & _).
  assert (Sz : forall k m, holds m (c k * S ^ k) -> size S c k <= IZR (model_norm m)).
  { intros k m K. apply (holds_norm eta Heta rho Hrho) in K. unfold size.
    rewrite Rabs_mult, (Rabs_pos_eq (S ^ k)) in K by (apply pow_le; lra). exact K. }
  cbn [fold_right]. unfold mu. replace (I + 1)%nat with (Datatypes.S I) by lia.
  replace (I + 2)%nat with (Datatypes.S (Datatypes.S I)) by lia.
  assert (M : forall x y z, x <= IZR y -> x <= IZR (Z.max y z)).
  { intros x y z H. eapply Rle_trans; [exact H|]. apply IZR_le. lia. }
  assert (M' : forall x y z, x <= IZR z -> x <= IZR (Z.max y z)).
  { intros x y z H. eapply Rle_trans; [exact H|]. apply IZR_le. lia. }
  apply Rmax_lub; [apply M, Sz, K0|]. apply M'. apply Rmax_lub; [apply M, Sz, K1|apply M', M, Sz, K2]. }
assert (Mu0 : 0 <= mu) by (eapply Rle_trans; [apply (size_pos S c Hs I)|apply Rmax_l]).
assert (Ser := solution_series beta T c Hc f f1 f2 Hf (proj1 Hstart) (proj1 (proj2 Hstart)) (proj2 (proj2 Hstart))
  (T + u * S)).
replace (T + u * S - T) with (u * S) in Ser by ring.
assert (Eq : sum_first (fun k => c k * S ^ k * u ^ k) n = sum_first (fun k => c k * (u * S) ^ k) n).
{ clear. induction n as [|n IH]; simpl sum_first; [reflexivity|]. rewrite IH, Rpow_mult_distr. ring. }
rewrite Eq. apply (rest_of_series c (u * S)); auto. intros N.
apply Rle_trans with (3 * mu).
- apply Rle_trans with (3 * mu * q / (1 - q)).
  + eapply Rle_trans; [|apply (Tail N)]. rewrite En. apply sum_first_mono. intros k. unfold size.
    rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|]. rewrite <- RPow_abs. apply pow_incr.
    split; [apply Rabs_pos|].
    rewrite Rabs_mult, (Rabs_pos_eq S) by lra. rewrite <- (Rmult_1_l S) at 2. apply Rmult_le_compat_r; auto. lra.
  + apply Rmult_le_reg_r with (1 - q); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. rewrite Rmult_1_r.
    apply Rmult_le_compat_l; lra.
- unfold tail_bound. fold n. replace (n - 3)%nat with I by reflexivity. rewrite mult_IZR. lra.
Qed.

Lemma total_right m : total g t s l = Some m -> holds m (f (Q2R t + Q2R s)).
Proof.
unfold total. rewrite Hsmall. intros E. injection E as <-.
assert (T := tail_bounded 1 ltac:(rewrite Rabs_R1; lra)). rewrite Rmult_1_l in T.
assert (Sum := list_holds_sum _ l 0 Hl). cbn [Nat.add] in Sum.
apply (holds_wider eta rho _ _ _ _ Sum).
replace (sum_first (fun i => c i * Q2R s ^ i) (length l)) with (sum_first (fun k => c k * Q2R s ^ k * 1 ^ k)
  (length l)); [exact T|].
clear. induction (length l) as [|n IH]; simpl sum_first; [reflexivity|]. rewrite IH, pow1. ring.
Qed.

Lemma sign_on_right s0 u : sign_on g t s l = Some s0 -> Rabs u <= 1 -> 0 < signed s0 (f (Q2R t + u * Q2R s)).
Proof.
unfold sign_on. rewrite Hsmall. intros E Hu. assert (T := tail_bounded u Hu). destruct l as [|m l']; [discriminate|].
refine (sign_of_right eta Heta rho Hrho _ m (c 0%nat * Q2R s ^ 0) _ s0 Hrho0 (proj1 Hl) _ E).
cbn [length] in T. rewrite sum_first_head in T.
assert (N := list_holds_norms _ u Hu l' 1 (proj2 Hl)).
replace (sum_first (fun i => c (1 + i)%nat * Q2R s ^ (1 + i) * u ^ (1 + i)) (length l'))
  with (sum_first (fun i => c (S i) * Q2R s ^ S i * u ^ S i) (length l')) in N by reflexivity.
set (X := sum_first (fun i => c (S i) * Q2R s ^ S i * u ^ S i) (length l')) in *.
rewrite plus_IZR. replace (f (Q2R t + u * Q2R s) - c 0%nat * Q2R s ^ 0)
  with (X + (f (Q2R t + u * Q2R s) - (c 0%nat * Q2R s ^ 0 * u ^ 0 + X))) by (simpl; ring).
apply Rabs_plus_le; auto.
Qed.
End Sum.

(** ** Along t *)
Variables f f1 f2 : R -> R.
Hypothesis Hf : solves b f f1 f2.
Hypothesis Hmost : Rabs b + 2 <= IZR (b_most g).

Lemma most_0 : 1 <= IZR (b_most g) /\ Rabs b <= IZR (b_most g).
Proof. generalize (Rabs_pos b). lra. Qed.

Lemma most_1 : 1 <= IZR (b_most g) /\ Rabs (b - 1) <= IZR (b_most g).
Proof.
replace (b - 1) with (b + -1) by ring. generalize (Rabs_pos b) (Rabs_triang b (-1)).
replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra). lra.
Qed.

Lemma most_2 : 1 <= IZR (b_most g) /\ Rabs (b - 1 - 1) <= IZR (b_most g).
Proof.
replace (b - 1 - 1) with (b + -2) by ring. generalize (Rabs_pos b) (Rabs_triang b (-2)).
replace (Rabs (-2)) with 2 by (rewrite Rabs_left; lra). lra.
Qed.

Definition state_holds (st : state) : Prop := 0 < Q2R (scale st) /\ holds (value0 st) (f (Q2R (point st))) /\
  holds (value1 st) (Q2R (scale st) * f1 (Q2R (point st))) /\
    holds (value2 st) (Q2R (scale st) ^ 2 * f2 (Q2R (point st))).

(** The coefficients at a point. *)
Definition coefficients_at (T : R) : nat -> R := from_values b T (f T) (f1 T) (f2 T / 2).

Lemma coefficients_at_start T : coefficients_at T 0%nat = f T /\ coefficients_at T 1%nat = f1 T /\
  2 * coefficients_at T 2%nat = f2 T.
Proof. unfold coefficients_at, from_values. simpl. repeat split. field. Qed.

Lemma expand_right w st s l : state_holds st -> 0 < Q2R s -> expand g w st s = Some l ->
  list_holds l (fun k => coefficients_at (Q2R (point st)) k * Q2R s ^ k) 0.
Proof.
intros (Hsc & H0 & H1 & H2) Hs E. unfold expand in E.
destruct (step_is_right g (point st) s (step_of g (point st) s)) eqn:Er; [|discriminate]. cbn [andb] in E.
set (r := Qred (s / scale st)) in *.
destruct (Qle_bool (scale st * r) s) eqn:E1; [|discriminate].
destruct (Qle_bool s (scale st * r)) eqn:E2; [|discriminate].
cbn [andb] in E. injection E as <-.
apply Qle_bool_iff, Qle_Rle in E1. apply Qle_bool_iff, Qle_Rle in E2. rewrite Q2R_mult in E1, E2.
assert (Es : Q2R s = Q2R (scale st) * Q2R r) by lra.
destruct (coefficients_at_start (Q2R (point st))) as (C0 & C1 & C2).
apply (coefficients_hold (point st) s (step_of g (point st) s) (coefficients_at (Q2R (point st))) Er
  (from_values_recurrence _ _ _ _ _) (longest w) (small_enough w) 0).
- rewrite C0. simpl. rewrite Rmult_1_r. exact H0.
- rewrite C1. replace (f1 (Q2R (point st)) * Q2R s ^ 1) with (Q2R r * (Q2R (scale st) * f1 (Q2R (point st))))
    by (rewrite Es; ring).
  apply holds_multiple, H1.
- replace (coefficients_at (Q2R (point st)) 2 * Q2R s ^ 2)
    with (Q2R (Qred (r * r / 2)) * (Q2R (scale st) ^ 2 * f2 (Q2R (point st)))).
  + apply holds_multiple, H2.
  + rewrite Q2R_red, Q2R_halved, Q2R_mult, <- C2, Es. field.
Qed.

(** The slope of the expansion: s f' with b - 1, s^2 f'' with b - 2. *)
Lemma slope_expansion beta T s c y y1 y2 l : solves beta y y1 y2 -> recurrence beta T c -> c 0%nat = y T /\
  c 1%nat = y1 T /\ 2 * c 2%nat = y2 T ->
  list_holds l (fun k => c k * s ^ k) 0 ->
  let y3 t := t * y1 t - beta * y t in let c' k := s * ((INR k + 1) * c (S k)) in
  solves (beta - 1) (fun t => s * y1 t) (fun t => s * y2 t) (fun t => s * y3 t) /\ recurrence (beta - 1) T c' /\
  (c' 0%nat = s * y1 T /\ c' 1%nat = s * y2 T /\ 2 * c' 2%nat = s * y3 T) /\ list_holds (slopes l) (fun k =>
    c' k * s ^ k) 0.
Proof.
intros Hy R (C0 & C1 & C2) Hl y3 c'. split; [|split; [|split]].
- apply (solves_scal _ y1 y2 y3), solves_slope, Hy.
- intros k. assert (R' := recurrence_slope beta T c R k). cbv beta in R'. unfold c'.
  replace ((INR k + 1) * (INR k + 2) * (INR k + 3) * (s * ((INR (k + 3) + 1) * c (S (k + 3)))))
    with (s * ((INR k + 1) * (INR k + 2) * (INR k + 3) * ((INR (k + 3) + 1) * c (S (k + 3))))) by ring.
  rewrite R'. ring.
- unfold c', y3. assert (R0 := R 0%nat). simpl in R0. simpl. repeat split.
  + rewrite <- C1. ring.
  + rewrite <- C2. ring.
  + rewrite <- C0, <- C1. apply (f_equal (Rmult s)) in R0. lra.
- assert (S' := slopes_hold _ l Hl).
  assert (Ext : forall l a a' k, (forall n, a n = a' n) -> list_holds l a k -> list_holds l a' k).
  { clear. induction l as [|m l IH]; intros a a' k H Hl; [exact I|]. destruct Hl as [H1 H2].
    split; [rewrite <- H; exact H1|]. apply (IH a); auto. }
  apply (Ext (slopes l) (fun n => (INR n + 1) * (c (S n) * s ^ S n)) _ 0%nat); auto. intros n. unfold c'. cbn [pow].
  ring.
Qed.

Lemma total_small t s l m : total g t s l = Some m -> tail_is_small (b_most g) t s (length l) = true.
Proof. unfold total. destruct (tail_is_small (b_most g) t s (length l)); [reflexivity|discriminate]. Qed.

Lemma sign_on_small t s l s0 : sign_on g t s l = Some s0 -> tail_is_small (b_most g) t s (length l) = true.
Proof. unfold sign_on. destruct (tail_is_small (b_most g) t s (length l)); [reflexivity|discriminate]. Qed.

Lemma holds_rounded m y : holds m y -> holds (shrink (kept_degrees g) 1 m) y.
Proof. intros H. replace y with (y / IZR 1) by field. apply holds_shrink; auto. reflexivity. Qed.

Lemma carry_right w st s st' : state_holds st -> carry g w st s = Some st' ->
  state_holds st' /\ Q2R (point st') = Q2R (point st) + Q2R s.
Proof.
intros Hst E. unfold carry in E. destruct (is_positive s) eqn:Hp; [|discriminate]. apply positive_R in Hp.
destruct (expand g w st s) as [l|] eqn:El; [|discriminate].
assert (Hl := expand_right w st s l Hst Hp El).
destruct (total g (point st) s l) as [v0|] eqn:E0; [|discriminate].
destruct (total g (point st) s (slopes l)) as [v1|] eqn:E1; [|discriminate].
destruct (total g (point st) s (slopes (slopes l))) as [v2|] eqn:E2; [|discriminate].
apply some_injective in E. rewrite <- E. clear E. set (T := Q2R (point st)) in *.
assert (R0 := from_values_recurrence b T (f T) (f1 T) (f2 T / 2)). fold (coefficients_at T) in R0.
assert (C0 := coefficients_at_start T).
destruct (slope_expansion b T (Q2R s) _ f f1 f2 l Hf R0 C0 Hl) as (F1 & R1 & C1 & L1).
destruct (slope_expansion (b - 1) T (Q2R s) _ _ _ _ (slopes l) F1 R1 C1 L1) as (F2 & R2 & C2 & L2).
assert (Ep : Q2R (Qred (point st + s)) = T + Q2R s) by (rewrite Q2R_red, Q2R_plus; reflexivity).
split; [|exact Ep]. unfold state_holds. cbn [point scale value0 value1 value2]. rewrite Ep. split; auto.
split; [|split]; apply holds_rounded.
- apply (total_right b (point st) s f f1 f2 (coefficients_at T) l most_0 Hp Hf R0 C0 Hl (total_small _ _ _ _ E0) v0 E0).
- apply (total_right (b - 1) (point st) s _ _ _ _ (slopes l) most_1 Hp F1 R1 C1 L1 (total_small _ _ _ _ E1) v1 E1).
- assert (H := total_right (b - 1 - 1) (point st) s _ _ _ _ (slopes (slopes l)) most_2 Hp F2 R2 C2 L2
    (total_small _ _ _ _ E2) v2 E2).
  cbv beta in H. replace (Q2R s ^ 2 * f2 (T + Q2R s)) with (Q2R s * (Q2R s * f2 (T + Q2R s))) by ring. exact H.
Qed.

Lemma advance_right fuel w target : forall st st', state_holds st -> advance fuel g w target st = Some st' ->
  state_holds st' /\ Q2R (point st') = Q2R target.
Proof.
induction fuel as [|fuel IH]; intros st st' Hst E; cbn [advance] in E.
- destruct (Qeq_bool target (point st)) eqn:Eq; [|discriminate]. injection E as <-. split; auto.
  apply Qeq_bool_eq, Qeq_eqR in Eq. auto.
- destruct (Qeq_bool target (point st)) eqn:Eq.
  + injection E as <-. split; auto. apply Qeq_bool_eq, Qeq_eqR in Eq. auto.
  + match type of E with context [carry g w st ?d] => destruct (carry g w st d) as [st1|] eqn:Ec; [|discriminate] end.
    apply (IH st1); auto. apply (carry_right w st _ st1 Hst Ec).
Qed.

(** The function or its slope. *)
Definition of_order (order : nat) : R -> R := if Nat.eqb order 0 then f else f1.

Lemma box_right w st half l s0 order u : state_holds st -> 0 < Q2R half -> expand g w st half = Some l ->
  sign_on g (point st) half (if Nat.eqb order 0 then l else slopes l) = Some s0 -> Rabs u <= 1 ->
  0 < signed s0 (of_order order (Q2R (point st) + u * Q2R half)).
Proof.
intros Hst Hh El Es Hu. assert (Hl := expand_right w st half l Hst Hh El). set (T := Q2R (point st)) in *.
assert (R0 := from_values_recurrence b T (f T) (f1 T) (f2 T / 2)). fold (coefficients_at T) in R0.
assert (C0 := coefficients_at_start T). unfold of_order. destruct (Nat.eqb order 0).
- apply (sign_on_right b (point st) half f f1 f2 _ l most_0 Hh Hf R0 C0 Hl (sign_on_small _ _ _ _ Es) s0 u Es Hu).
- destruct (slope_expansion b T (Q2R half) _ f f1 f2 l Hf R0 C0 Hl) as (F1 & R1 & C1 & L1).
  assert (H := sign_on_right (b - 1) (point st) half _ _ _ _ (slopes l) most_1 Hh F1 R1 C1 L1 (sign_on_small _ _ _ _ Es)
    s0 u Es Hu).
  cbv beta in H. fold T in H. destruct s0; simpl in *.
  + apply Rmult_lt_reg_l with (Q2R half); auto. lra.
  + apply Rmult_lt_reg_l with (Q2R half); auto. lra.
Qed.

Lemma sign_on_point t t' s l : Q2R t = Q2R t' -> sign_on g t s l = sign_on g t' s l.
Proof.
intros E. unfold sign_on, tail_is_small. apply eqR_Qeq in E.
replace (Qle_bool (2 * (Qabs t * s * s * (inject_Z (Z.of_nat (length l) - 3) + 1)
      + (inject_Z (Z.of_nat (length l) - 3) + inject_Z (b_most g)) * s * s * s))
    ((inject_Z (Z.of_nat (length l) - 3) + 1) * (inject_Z (Z.of_nat (length l) - 3) + 2)
      * (inject_Z (Z.of_nat (length l) - 3) + 3)))
  with (Qle_bool (2 * (Qabs t' * s * s * (inject_Z (Z.of_nat (length l) - 3) + 1)
      + (inject_Z (Z.of_nat (length l) - 3) + inject_Z (b_most g)) * s * s * s))
    ((inject_Z (Z.of_nat (length l) - 3) + 1) * (inject_Z (Z.of_nat (length l) - 3) + 2)
      * (inject_Z (Z.of_nat (length l) - 3) + 3))); [reflexivity|].
apply Qleb_comp; [|reflexivity]. rewrite E. reflexivity.
Qed.

Lemma has_sign_right w order s0 : forall cuts t1 t2 st st', state_holds st -> has_sign cuts g w order s0 t1 t2 st
  = Some st' ->
  state_holds st' /\ forall t, Q2R t1 <= t <= Q2R t2 -> 0 < signed s0 (of_order order t).
Proof.
assert (Direct : forall t1 t2 st st', state_holds st ->
  (let middle := Qred ((t1 + t2) / 2) in let half := Qred ((t2 - t1) / 2) in
   if is_positive half then
      match advance (most_steps w) g w middle st with
      | None => None
      | Some st' =>
          match expand g w st' half with
          | None => None
          | Some l =>
              match sign_on g middle half (if Nat.eqb order 0 then l else slopes l) with
              | Some s' => if Bool.eqb s0 s' then Some st' else None
              | None => None
              end
          end
      end
   else None) = Some st' ->
  state_holds st' /\ forall t, Q2R t1 <= t <= Q2R t2 -> 0 < signed s0 (of_order order t)).
{ intros t1 t2 st st' Hst. cbv zeta. set (middle := Qred ((t1 + t2) / 2)). set (half := Qred ((t2 - t1) / 2)).
  assert (Em : Q2R middle = (Q2R t1 + Q2R t2) / 2) by (unfold middle; rewrite Q2R_red, Q2R_halved, Q2R_plus;
    reflexivity).
  assert (Eh : Q2R half = (Q2R t2 - Q2R t1) / 2) by (unfold half; rewrite Q2R_red, Q2R_halved, Q2R_minus; reflexivity).
  destruct (is_positive half) eqn:Hp; [|discriminate]. apply positive_R in Hp.
  destruct (advance (most_steps w) g w middle st) as [st1|] eqn:Ea; [|discriminate].
  destruct (advance_right _ _ _ _ _ Hst Ea) as [Hst1 Pm].
  destruct (expand g w st1 half) as [l|] eqn:El; [|discriminate].
  destruct (sign_on g middle half (if Nat.eqb order 0 then l else slopes l)) as [s'|] eqn:Es; [|discriminate].
  destruct (Bool.eqb s0 s') eqn:Eb; [|discriminate]. apply Bool.eqb_prop in Eb. subst s'. intros E. injection E as <-.
  split; auto. intros t Ht. rewrite (sign_on_point middle (point st1)) in Es by auto.
  replace t with (Q2R (point st1) + (t - Q2R middle) / Q2R half * Q2R half) by (rewrite Pm; field; lra).
  apply (box_right w st1 half l s0 order); auto.
  unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ Q2R half)) by (apply Rlt_le, Rinv_0_lt_compat, Hp).
  apply Rmult_le_reg_r with (Q2R half); auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by lra.
  apply Rabs_le. lra. }
induction cuts as [|cuts IH]; intros t1 t2 st st' Hst E; cbn [has_sign] in E.
- match type of E with match ?d with Some _ => _ | None => _ end = _ => destruct d as [st1|] eqn:Ed;
    [|discriminate] end.
  injection E as <-. apply (Direct t1 t2 st st1); auto.
- match type of E with match ?d with Some _ => _ | None => _ end = _ => destruct d as [st1|] eqn:Ed end.
  + injection E as <-. apply (Direct t1 t2 st st1); auto.
  + clear Ed. set (middle := Qred ((t1 + t2) / 2)) in *.
    destruct (has_sign cuts g w order s0 t1 middle st) as [st1|] eqn:E1; [|discriminate].
    destruct (IH _ _ _ _ Hst E1) as [Hst1 H1]. destruct (IH _ _ _ _ Hst1 E) as [Hst2 H2]. split; auto.
    intros t Ht. destruct (Rle_lt_dec t (Q2R middle)) as [L|L]; [apply H1|apply H2]; lra.
Qed.

End Enclosure.
