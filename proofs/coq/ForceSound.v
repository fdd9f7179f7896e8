(** * What the checker accepts about the contact force is true

    At the one b = h/n of a column the size of F on a box and at a point is compared with the level as n-th powers of
    integers, in units of x^b. The pieces of version 1 are those of [CheckerSound.v]. So [force_certificate] and
    [lift_off_certificate] conclude, once the numbers of the system are compared: the side by the sign of
    Gamma(-beta), the deviation with the mean force. *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qabs Qround Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant StatementCertificate SolutionSeries Family CertificateFamily Ends
  ThetaEntire CertificateText StatementChecker
  ForceText Checker CheckerCertificate ForceChecker StatementForce CertificateForce CheckerModels CheckerEnclosure
  CheckerStart CheckerComparisons CheckerSound.
Import ListNotations.
Open Scope R_scope.

(** ** Powers with rational exponents *)

Lemma power_order x y n : 0 <= x -> 0 <= y -> (0 < n)%nat -> (x ^ n <= y ^ n <-> x <= y).
Proof.
intros Hx Hy Hn. split; [|intros H; apply pow_incr; auto].
intros H. apply Rnot_lt_le. intros L. destruct n as [|n]; [lia|]. assert (X : 0 < x) by lra.
assert (P := pow_lt x n X). assert (Q := pow_incr y x n (conj Hy (Rlt_le _ _ L))). simpl in H.
assert (A := Rmult_le_compat_l y _ _ Hy Q). assert (B := Rmult_lt_compat_r _ _ _ P L). lra.
Qed.

Lemma whole_power z (p : positive) : IZR (z ^ Zpos p) = IZR z ^ Pos.to_nat p.
Proof. rewrite pow_IZR, positive_nat_Z. reflexivity. Qed.

Lemma natural_exponent z h : (0 <= h)%Z -> IZR (z ^ h) = IZR z ^ Z.to_nat h.
Proof. intros H. rewrite pow_IZR, Z2Nat.id by exact H. reflexivity. Qed.

Lemma fraction_parts q : Q2R q = IZR (Qnum q) / IZR (Zpos (Qden q)) /\ 0 < IZR (Zpos (Qden q)).
Proof. split; [reflexivity|apply IZR_lt; reflexivity]. Qed.

Lemma power_fraction x c : 0 < x -> (0 <= Qnum c)%Z -> Rpower x (Q2R c) ^ Pos.to_nat (Qden c) = x ^ Z.to_nat (Qnum c).
Proof.
intros Hx Hc. destruct (fraction_parts c) as [E D]. rewrite <- (Rpower_pow (Pos.to_nat _)) by apply exp_pos.
rewrite Rpower_mult, <- (Rpower_pow (Z.to_nat _)) by exact Hx. f_equal.
rewrite !INR_IZR_INZ, Z2Nat.id, positive_nat_Z, E by exact Hc. field. lra.
Qed.

(** v x^b/one against the level. *)
Lemma size_compared x one b level v : (0 < x)%Z -> (0 < one)%Z -> (0 <= Qnum b)%Z -> 0 < Q2R level -> (0 <= v)%Z ->
  (IZR (size_of x b level v) <= IZR (size_allowed one b level) <-> IZR v <= factor (Q2R b) one x * Q2R level) /\
  (IZR (size_allowed one b level) <= IZR (size_of x b level v) <-> factor (Q2R b) one x * Q2R level <= IZR v).
Proof.
intros Hx H1 Hb Hl Hv. destruct (fraction_parts level) as [E D].
assert (X : 0 < IZR x) by (apply IZR_lt; auto). assert (O : 0 < IZR one) by (apply IZR_lt; auto).
assert (V : 0 <= IZR v) by (apply IZR_le; auto). assert (P : 0 < Rpower (IZR x) (Q2R b)) by apply exp_pos.
unfold size_of, size_allowed. rewrite !mult_IZR, !whole_power, natural_exponent, <- power_fraction by auto.
rewrite <- Rpow_mult_distr, !mult_IZR. unfold factor. rewrite E. set (d := IZR (Zpos (Qden level))) in *.
set (u := IZR (Qnum level)) in *. set (r := Rpower (IZR x) (Q2R b)) in *. set (o := IZR one) in *.
assert (U : 0 < u).
{ rewrite E in Hl. apply Rmult_lt_reg_r with (/ d); [apply Rinv_0_lt_compat, D|]. rewrite Rmult_0_l. exact Hl. }
assert (N := Pos2Nat.is_pos (Qden b)). assert (Y : 0 <= u * o) by (apply Rlt_le, Rmult_lt_0_compat; auto).
assert (Z : 0 <= IZR v * d * r) by (repeat apply Rmult_le_pos; lra). assert (DR : 0 < d * r) by nra.
assert (Ev : IZR v = IZR v * d * r / (d * r)) by (field; lra).
assert (El : o / r * (u / d) = u * o / (d * r)) by (field; lra).
assert (I := Rinv_0_lt_compat _ DR).
split; (rewrite power_order by auto); split; intros H.
- rewrite Ev, El. apply Rmult_le_compat_r; lra.
- rewrite Ev, El in H. apply Rmult_le_reg_r with (/ (d * r)); auto.
- rewrite Ev, El. apply Rmult_le_compat_r; lra.
- rewrite Ev, El in H. apply Rmult_le_reg_r with (/ (d * r)); auto.
Qed.

(** ** Sizes along t *)
Lemma lower_end_right eta rho s m y : Rabs eta <= 1 -> weights rho -> rho 0%nat = 1 -> holds eta rho m y ->
  (0 <= lower_end s m)%Z -> IZR (lower_end s m) <= signed s y.
Proof.
intros Heta Hrho Hrho0 H L. unfold lower_end in *. unfold holds in H.
destruct (parts m) as [|[|z a] p]; try (simpl in L; lia). cbn [combined value] in H. rewrite Hrho0 in H.
assert (Va := times_at_most_one eta _ _ Heta (value_norm eta Heta a)).
assert (Vp := combined_norm eta Heta p _ (weights_tail _ Hrho)).
apply Rabs_le_between in H. apply Rabs_le_between in Va. apply Rabs_le_between in Vp.
rewrite minus_IZR, !plus_IZR. destruct s; simpl; rewrite ?opp_IZR; lra.
Qed.

Section Along.
Variables (g : setting) (b eta : R) (rho : nat -> R).
Hypothesis Heta : Rabs eta <= 1.
Hypothesis Hunit : (0 < b_unit g)%Z.
Hypothesis Hb : IZR (b_unit g) * b = IZR (b_centre g) + IZR (b_radius g) * eta.
Hypothesis Hrho : weights rho.
Variables f f1 f2 : R -> R.
Hypothesis Hf : solves b f f1 f2.
Hypothesis Hmost : Rabs b + 2 <= IZR (b_most g).
Let holds_at := state_holds eta rho f f1 f2.

Lemma largest_right w st half l most u : holds_at st -> 0 < Q2R half -> expand g w st half = Some l ->
  largest_on g (point st) half l = Some most -> Rabs u <= 1 -> Rabs (f (Q2R (point st) + u * Q2R half)) <= IZR most.
Proof.
intros Hst Hh El Em Hu. unfold largest_on in Em.
destruct (tail_is_small (b_most g) (point st) half (length l)) eqn:Es; [|discriminate].
apply some_injective in Em. subst most.
assert (Hl := expand_right g b eta rho Heta Hunit Hb Hrho f f1 f2 w st half l Hst Hh El).
set (T := Q2R (point st)) in *.
assert (R0 := from_values_recurrence b T (f T) (f1 T) (f2 T / 2)). fold (coefficients_at b f f1 f2 T) in R0.
assert (B := tail_bounded g eta rho Heta Hrho b (point st) half f f1 f2 _ l (most_0 g b Hmost) Hh Hf R0
  (coefficients_at_start b f f1 f2 T) Hl Es u Hu).
assert (N := list_holds_norms eta rho Heta Hrho _ u Hu l 0 Hl). cbn [Nat.add] in N. fold T in B.
rewrite plus_IZR. set (S := sum_first _ _) in *.
replace (f (T + u * Q2R half)) with (S + (f (T + u * Q2R half) - S)) by ring. apply Rabs_plus_le; auto.
Qed.

Lemma largest_on_point t t' s l : Q2R t = Q2R t' -> largest_on g t s l = largest_on g t' s l.
Proof.
intros E. unfold largest_on, tail_is_small. apply eqR_Qeq in E.
match goal with |- context [Qle_bool ?a ?d] => match goal with |- context [Qle_bool ?a' d] =>
  replace (Qle_bool a d) with (Qle_bool a' d); [reflexivity|] end end.
apply Qleb_comp; [|reflexivity]. rewrite E. reflexivity.
Qed.

Lemma stays_within_right w bound B : (forall v y, bound v = true -> Rabs y <= IZR v -> Rabs y <= B) ->
  forall cuts t1 t2 st st', holds_at st -> stays_within cuts g w bound t1 t2 st = Some st' ->
  holds_at st' /\ forall t, Q2R t1 <= t <= Q2R t2 -> Rabs (f t) <= B.
Proof.
intros HB.
assert (Direct : forall t1 t2 st st', holds_at st ->
  (let middle := Qred ((t1 + t2) / 2) in let half := Qred ((t2 - t1) / 2) in
   if is_positive half then
      match advance (most_steps w) g w middle st with
      | None => None
      | Some st' =>
          match expand g w st' half with
          | None => None
          | Some l =>
              match largest_on g middle half l with
              | Some most => if bound most then Some st' else None
              | None => None
              end
          end
      end
   else None) = Some st' ->
  holds_at st' /\ forall t, Q2R t1 <= t <= Q2R t2 -> Rabs (f t) <= B).
{ intros t1 t2 st st' Hst. cbv zeta. set (middle := Qred ((t1 + t2) / 2)). set (half := Qred ((t2 - t1) / 2)).
  assert (Em : Q2R middle = (Q2R t1 + Q2R t2) / 2) by (unfold middle; rewrite Q2R_red, Q2R_halved, Q2R_plus;
    reflexivity).
  assert (Eh : Q2R half = (Q2R t2 - Q2R t1) / 2) by (unfold half; rewrite Q2R_red, Q2R_halved, Q2R_minus; reflexivity).
  destruct (is_positive half) eqn:Hp; [|discriminate]. apply positive_R in Hp.
  destruct (advance (most_steps w) g w middle st) as [st1|] eqn:Ea; [|discriminate].
  destruct (advance_right g b eta rho Heta Hunit Hb Hrho f f1 f2 Hf Hmost _ _ _ _ _ Hst Ea) as [Hst1 Pm].
  destruct (expand g w st1 half) as [l|] eqn:El; [|discriminate].
  destruct (largest_on g middle half l) as [most|] eqn:Es; [|discriminate].
  destruct (bound most) eqn:Eb; [|discriminate]. intros E. injection E as <-.
  split; auto. intros t Ht. rewrite (largest_on_point middle (point st1)) in Es by auto. apply (HB most); auto.
  replace t with (Q2R (point st1) + (t - Q2R middle) / Q2R half * Q2R half) by (rewrite Pm; field; lra).
  apply (largest_right w st1 half l most); auto.
  unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ Q2R half)) by (apply Rlt_le, Rinv_0_lt_compat, Hp).
  apply Rmult_le_reg_r with (Q2R half); auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by lra.
  apply Rabs_le. lra. }
induction cuts as [|cuts IH]; intros t1 t2 st st' Hst E; cbn [stays_within] in E.
- match type of E with match ?d with Some _ => _ | None => _ end = _ => destruct d as [st1|] eqn:Ed;
    [|discriminate] end.
  injection E as <-. apply (Direct t1 t2 st st1); auto.
- match type of E with match ?d with Some _ => _ | None => _ end = _ => destruct d as [st1|] eqn:Ed end.
  + injection E as <-. apply (Direct t1 t2 st st1); auto.
  + clear Ed. set (middle := Qred ((t1 + t2) / 2)) in *.
    destruct (stays_within cuts g w bound t1 middle st) as [st1|] eqn:E1; [|discriminate].
    destruct (IH _ _ _ _ Hst E1) as [Hst1 H1]. destruct (IH _ _ _ _ Hst1 E) as [Hst2 H2]. split; auto.
    intros t Ht. destruct (Rle_lt_dec t (Q2R middle)) as [L|L]; [apply H1|apply H2]; lra.
Qed.

Lemma levels_walk_right w bound B : (forall v y, bound v = true -> Rabs y <= IZR v -> Rabs y <= B) ->
  forall parts st, holds_at st -> levels_walk g w bound parts st = true ->
  forall t1 t2, In (Level t1 t2) parts -> forall t, Q2R t1 <= t <= Q2R t2 -> Rabs (f t) <= B.
Proof.
intros HB. induction parts as [|[p|u1 u2|u1 u2] parts IH]; intros st Hst E t1 t2 I t Ht; [destruct I| | |];
  cbn [levels_walk] in E.
- destruct I as [I|I]; [discriminate|]. apply (IH st Hst E t1 t2 I t Ht).
- destruct (stays_within (halvings w) g w bound u1 u2 st) as [st'|] eqn:Es; [|discriminate].
  destruct (stays_within_right w bound B HB _ _ _ _ _ Hst Es) as [Hst' H].
  destruct I as [I|I]; [injection I as -> ->; apply H, Ht|apply (IH st' Hst' E t1 t2 I t Ht)].
- destruct I as [I|I]; [discriminate|]. apply (IH st Hst E t1 t2 I t Ht).
Qed.
End Along.

(** ** The start, and F at one b *)
Section Column.
Variable F : R -> R -> R.
Hypothesis HF : theta_family F.

Lemma begins_right p low high b : begins p low high = true -> Q2R low <= b <= Q2R high ->
  let g := setting_for p low high in
  (0 < plan_x p)%Z /\ (0 < plan_one p)%Z /\ (0 < b_unit g)%Z /\ Rabs b + 2 <= IZR (b_most g) /\
  0 < factor b (plan_one p) (plan_x p) /\
  exists eta rho, Rabs eta <= 1 /\ IZR (b_unit g) * b = IZR (b_centre g) + IZR (b_radius g) * eta /\ weights rho /\
    rho 0%nat = 1 /\
    state_holds eta rho (fun t => factor b (plan_one p) (plan_x p) * F b t)
      (fun t => factor b (plan_one p) (plan_x p) * Derive (F b) t)
      (fun t => factor b (plan_one p) (plan_x p) * Derive_n (F b) 2 t) (first_state p low high).
Proof.
unfold begins, first_state. intros H Hb. set (g := setting_for p low high) in *.
apply andb_prop in H. destruct H as [H En]. apply andb_prop in H. destruct H as [H E1].
apply andb_prop in H. destruct H as [Eg Ex]. apply Z.ltb_lt in Ex. apply Z.ltb_lt in E1. apply less_R in En.
rewrite Q2R_whole, mult_IZR, <- INR_IZR_INZ in En.
destruct (eta_exists g low high b Eg Hb) as (Hu & Hm & eta & Heta & Eb).
destruct (start_right F HF g b eta Heta Hu Eb (plan_terms p) (plan_x p) (plan_one p) Ex E1 ltac:(lra))
  as (Hw & rho & Hrho & Hrho0 & Hst).
cbv zeta. repeat split; auto. exists eta, rho. auto.
Qed.

Lemma levels_hold_right p b level parts : levels_hold p b level parts = true -> (0 <= Qnum b)%Z -> 0 < Q2R level ->
  forall t1 t2, In (Level t1 t2) parts -> forall t, Q2R t1 <= t <= Q2R t2 -> Rabs (F (Q2R b) t) <= Q2R level.
Proof.
unfold levels_hold. intros H Hb Hl t1 t2 I t Ht. destruct (begins p b b) eqn:Eb; [|discriminate].
destruct (begins_right p b b (Q2R b) Eb (conj (Rle_refl _) (Rle_refl _)))
  as (Hx & H1 & Hu & Hm & Hw & eta & rho & Heta & Ee & Hrho & Hrho0 & Hst).
set (w := factor (Q2R b) (plan_one p) (plan_x p)) in *.
assert (C : Rabs (w * F (Q2R b) t) <= w * Q2R level).
{ refine (levels_walk_right (setting_for p b b) (Q2R b) eta rho Heta Hu Ee Hrho _ _ _ (family_solves F HF (Q2R b) w)
    Hm (plan_effort p) _ (w * Q2R level) _ parts _ Hst H t1 t2 I t Ht).
  intros v y Ev Hy. apply Z.leb_le, IZR_le in Ev.
  assert (V : (0 <= v)%Z) by (apply le_IZR; generalize (Rabs_pos y); lra).
  apply (proj1 (size_compared _ _ b level v Hx H1 Hb Hl V)) in Ev. fold w in Ev. lra. }
rewrite Rabs_mult, (Rabs_pos_eq w) in C by lra. apply Rmult_le_reg_l with w; auto.
Qed.

Lemma goes_beyond_right p s b level tau : goes_beyond p s b level tau = true -> (0 <= Qnum b)%Z -> 0 < Q2R level ->
  Q2R level <= signed s (F (Q2R b) (Q2R tau)).
Proof.
unfold goes_beyond. intros H Hb Hl. destruct (begins p b b) eqn:Eb; [|discriminate].
destruct (begins_right p b b (Q2R b) Eb (conj (Rle_refl _) (Rle_refl _)))
  as (Hx & H1 & Hu & Hm & Hw & eta & rho & Heta & Ee & Hrho & Hrho0 & Hst).
set (w := factor (Q2R b) (plan_one p) (plan_x p)) in *.
destruct (advance (most_steps (plan_effort p)) (setting_for p b b) (plan_effort p) tau (first_state p b b))
  as [st|] eqn:Ea; [|discriminate].
destruct (advance_right (setting_for p b b) (Q2R b) eta rho Heta Hu Ee Hrho _ _ _ (family_solves F HF (Q2R b) w) Hm
  _ _ _ _ _ Hst Ea) as [(_ & H0 & _) Pt].
apply andb_prop in H. destruct H as [L H]. apply Z.leb_le in L. apply Z.leb_le, IZR_le in H. rewrite Pt in H0.
apply (proj2 (size_compared _ _ b level _ Hx H1 Hb Hl L)) in H. fold w in H.
assert (V := lower_end_right eta rho s _ _ Heta Hrho Hrho0 H0 L).
apply Rmult_le_reg_l with w; auto. destruct s; simpl in *; lra.
Qed.
End Column.

(** There is a family, with [PSeries] of coefficients that are entire in b. *)
Lemma family_exists : exists F, theta_family F.
Proof.
exists (fun b t => family_sum theta_coefficient t b). intros b. destruct (entire_exists b) as [theta H].
replace (fun t => family_sum theta_coefficient t b) with theta; [exact H|].
apply FunctionalExtensionality.functional_extensionality. intros t. apply entire_series, H.
Qed.

(** ** The numbers of the system *)
Lemma Q2R_small z : Q2R (z # 1) = IZR z.
Proof. apply Q2R_whole. Qed.

Lemma nonzero_Q q : Q2R q <> 0 -> ~ (q == 0)%Q.
Proof. intros H E. apply H. apply Qeq_eqR in E. rewrite E. apply Q2R_0. Qed.

Section System.
Variables (a1 a2 a3 c1 eps level : Q) (m : nat).
Hypothesis Hs : system_holds a1 a2 a3 eps level m = true.
Let beta : Q := Qred (a3 / a1).

Lemma system_right : Q2R a1 < 0 /\ Q2R a2 < 0 /\ Q2R a3 < 0 /\ 0 < Q2R eps /\ 0 < Q2R level /\
  Q2R beta = Q2R a3 / Q2R a1 /\ 1 < Q2R beta < 5 /\ INR m < Q2R beta < INR m + 1.
Proof.
assert (H := Hs). unfold system_holds in H. fold beta in H. repeat (apply andb_prop in H; destruct H as [H ?]).
repeat match goal with E : less _ _ = true |- _ => apply less_R in E end.
rewrite ?Q2R_0, ?Q2R_plus, ?Q2R_nat, ?Q2R_1 in *. rewrite (Q2R_small 5) in *.
assert (E : Q2R beta = Q2R a3 / Q2R a1).
{ unfold beta. rewrite Q2R_red. apply Q2R_div, nonzero_Q. lra. }
repeat split; auto.
Qed.

(** beta - 1 = h/n. *)
Let h : nat := Z.to_nat (Qnum beta - Zpos (Qden beta)).
Let n : nat := Pos.to_nat (Qden beta).

Lemma exponent_whole : (0 <= Qnum beta - Zpos (Qden beta))%Z.
Proof.
destruct system_right as (_ & _ & _ & _ & _ & _ & [B _] & _). destruct (fraction_parts beta) as [E D].
apply le_IZR. rewrite minus_IZR. rewrite E in B. apply Rmult_lt_compat_r with (r := IZR (Zpos (Qden beta))) in B; auto.
unfold Rdiv in B. rewrite Rmult_assoc, Rinv_l in B by lra. lra.
Qed.

Lemma exponent_right : Q2R a3 / Q2R a1 = 1 + INR h / INR n /\ (0 < n)%nat.
Proof.
destruct system_right as (_ & _ & _ & _ & _ & Eb & _). destruct (fraction_parts beta) as [E D].
split; [|apply Pos2Nat.is_pos]. rewrite <- Eb, E. unfold h, n.
rewrite !INR_IZR_INZ, Z2Nat.id, positive_nat_Z, minus_IZR by apply exponent_whole. field. lra.
Qed.

Lemma one_less : Q2R (beta - 1) = Q2R beta - 1 /\ (0 <= Qnum (beta - 1))%Z.
Proof.
split; [rewrite Q2R_minus, Q2R_1; reflexivity|]. assert (H := exponent_whole).
unfold Qminus, Qplus, Qopp. cbn [Qnum Qden]. lia.
Qed.

(** The powers of integers are those of [compared]. *)
Lemma deviation_right : let (above, below) := deviation a1 a2 a3 c1 eps level in
  let x := compared (Q2R a1) (Q2R a2) (Q2R a3) (Q2R c1) (Q2R eps) (Q2R level) h n in
  ((above <= below)%Z -> x <= 1) /\ ((below <= above)%Z -> 1 <= x).
Proof.
destruct system_right as (H1 & H2 & H3 & _ & _ & Eb & B & _). unfold deviation. fold beta.
set (one := Qred _). set (two := Qred _). cbv zeta.
assert (A31 : Q2R a3 - Q2R a1 < 0).
{ assert (E : Q2R a3 = Q2R beta * Q2R a1) by (rewrite Eb; field; lra). nra. }
assert (Ed : Q2R (a2 / (a3 - a1)) = Q2R a2 / (Q2R a3 - Q2R a1)).
{ rewrite Q2R_div, Q2R_minus; [reflexivity|]. apply nonzero_Q. rewrite Q2R_minus. lra. }
assert (M : Q2R (a2 / (a3 - a1)) <> 0).
{ rewrite Ed. unfold Rdiv. apply Rmult_integral_contrapositive. split; [lra|apply Rinv_neq_0_compat; lra]. }
assert (E1 : Q2R one = Rabs (Q2R c1 / Q2R a3) * (Q2R a3 / Q2R a1) * Q2R level / (Q2R a2 / (Q2R a3 - Q2R a1))).
{ unfold one. rewrite Q2R_red, Q2R_div by (apply nonzero_Q, M). rewrite !Q2R_mult, Q2R_Qabs, Q2R_div, Ed, Eb;
    [reflexivity|]. apply nonzero_Q. lra. }
assert (E2 : Q2R two = 2 * Q2R eps ^ 2 / - Q2R a1).
{ unfold two. rewrite Q2R_red, Q2R_div by (apply nonzero_Q; rewrite Q2R_opp; lra).
  rewrite !Q2R_mult, Q2R_opp, (Q2R_small 2). simpl. field. lra. }
unfold compared. rewrite <- E1, <- E2. destruct (fraction_parts one) as [-> D1].
destruct (fraction_parts two) as [-> D2].
assert (Hh := exponent_whole). fold n. set (d1 := IZR (Zpos (Qden one))) in *. set (d2 := IZR (Zpos (Qden two))) in *.
set (below := (Zpos (Qden one) ^ (3 * Zpos (Qden beta)) * Zpos (Qden two) ^ (Qnum beta - Zpos (Qden beta)))%Z).
set (above := (Qnum one ^ (3 * Zpos (Qden beta)) * Qnum two ^ (Qnum beta - Zpos (Qden beta)))%Z).
assert (Three : Z.to_nat (3 * Zpos (Qden beta)) = (3 * n)%nat) by (unfold n; lia).
assert (EB : IZR below = d1 ^ (3 * n) * d2 ^ h).
{ unfold below. rewrite mult_IZR, !natural_exponent, Three by lia. reflexivity. }
assert (EA : IZR above = IZR (Qnum one) ^ (3 * n) * IZR (Qnum two) ^ h).
{ unfold above. rewrite mult_IZR, !natural_exponent, Three by lia. reflexivity. }
assert (P1 := pow_lt d1 (3 * n) D1). assert (P2 := pow_lt d2 h D2).
assert (PB : 0 < IZR below) by (rewrite EB; apply Rmult_lt_0_compat; auto).
assert (EQ : (IZR (Qnum one) / d1) ^ (3 * n) * (IZR (Qnum two) / d2) ^ h = IZR above / IZR below).
{ unfold Rdiv. rewrite EA, EB, !Rpow_mult_distr, Rinv_mult, !pow_inv. ring. }
rewrite EQ. split; intros L; apply IZR_le in L; apply Rmult_le_reg_r with (IZR below); auto; unfold Rdiv;
  rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.

Lemma side_right positive : side_is positive m c1 = true ->
  0 < signed positive (Q2R c1 * Gamma (- (Q2R a3 / Q2R a1))).
Proof.
destruct system_right as (_ & _ & _ & _ & _ & Eb & _ & Hm). rewrite <- Eb.
assert (G := Ends.Gamma_sign m _ Hm). 
rewrite Nat.add_1_r, <- CertificateWalk.signed_even, Nat.even_succ, <- Nat.negb_even in G.
unfold side_is. intros H. destruct positive, (Nat.even m); cbn [Bool.eqb negb signed] in *; apply less_R in H;
  rewrite Q2R_0 in H; nra.
Qed.
End System.

(** ** The two claims *)
Definition real_part (p : part) : piece + R * R :=
  match p with Known p => inl (real_piece p) | Level t1 t2 | Dip t1 t2 => inr (Q2R t1, Q2R t2) end.

Lemma part_ends_right parts :
  map (fun part => match part with inl p => piece_ends p | inr (t1, t2) => (Finite t1, Finite t2) end)
    (map real_part parts) = real_parts (map part_ends parts).
Proof.
unfold real_parts. rewrite !map_map. apply map_ext. intros [p|t1 t2|t1 t2]; try reflexivity. apply real_ends.
Qed.

Theorem force_holds_right p a1 a2 a3 c1 eps level tau c : force_holds p a1 a2 a3 c1 eps level tau c = true ->
  true_force_claim (ForceClaim a1 a2 a3 c1 eps level tau).
Proof.
unfold force_holds. set (beta := Qred (a3 / a1)). set (known := Block (At beta) beta (known_of (strip_parts c))).
set (m := cell_of known). intros H0. assert (Dv := deviation_right a1 a2 a3 c1 eps level m).
destruct (deviation a1 a2 a3 c1 eps level) as [above below].
match type of H0 with (if ?x then _ else _) = _ => destruct x eqn:H; [|discriminate] end.
destruct (pieces_hold p known) eqn:Hp; [|discriminate]. rename H0 into Hlevels.
apply andb_prop in H. destruct H as [H Serves]. apply andb_prop in H. destruct H as [H Hcover].
apply andb_prop in H. destruct H as [H Hle]. apply andb_prop in H. destruct H as [Hs Side].
destruct family_exists as [F HF]. destruct (system_right a1 a2 a3 eps level m Hs)
  as (H1 & H2 & H3 & He & Hl & Eb & B15 & Hm). fold beta in Eb, B15, Hm.
destruct (exponent_right a1 a2 a3 eps level m Hs) as [Er Hn].
destruct (one_less a1 a2 a3 eps level m Hs) as [E1 Hnum]. fold beta in E1, Hnum.
destruct (pieces_hold_right F HF p known Hp) as [Cell Checked].
cbn [true_force_claim]. cbv zeta. intros e pp bb y v z t He' HS Ht.
apply (CertificateForce.force_certificate F (Q2R a1) (Q2R a2) (Q2R a3) (Q2R c1) (Q2R eps) (Q2R level) _ _
  (real_range tau) (real_column known) (map real_part (strip_parts c)) HF H1 H2 H3 Hn Er)
  with (eps := e) (p := pp) (b := bb) (v := v); auto; try (rewrite <- Eb; assumption).
- rewrite <- Eb. apply (cell_not_nat (S m)). unfold cell. rewrite S_INR. lra.
- apply (side_right a1 a2 a3 c1 eps level m Hs true Side).
- apply (proj1 (Dv Hs)), Z.leb_le, Hle.
- split; [exact Cell|]. split; [rewrite <- Eb; reflexivity|]. split; [exact Eb|]. split.
  { rewrite part_ends_right. apply covers_R, Hcover. }
  rewrite forallb_forall in Serves. intros part I. apply in_map_iff in I. destruct I as (q & <- & I).
  assert (S := Serves q I). destruct q as [q|t1 t2|t1 t2]; cbn [real_part part_serves] in *; [|clear S|discriminate].
  + assert (K : In q (known_of (strip_parts c)))
      by (apply in_flat_map; exists (Known q); split; [exact I|left; reflexivity]).
    split; [apply Checked, K|]. change (column_cell (real_column known)) with m.
    destruct q; try discriminate; cbn [real_piece piece_sign]; change (column_cell (real_column known)) with m.
    * rewrite S. auto.
    * apply Bool.eqb_prop in S. rewrite S. auto.
    * apply Nat.eqb_eq in S. subst. rewrite Nat.add_0_r. auto.
  + intros u Hu. rewrite <- Eb, <- E1. apply (levels_hold_right F HF p (beta - 1) level _ Hlevels Hnum Hl t1 t2 I u Hu).
Qed.

Theorem lift_off_holds_right p a1 a2 a3 c1 eps level tau c : lift_off_holds p a1 a2 a3 c1 eps level tau c = true ->
  true_force_claim (LiftOffClaim a1 a2 a3 c1 eps level tau).
Proof.
unfold lift_off_holds. set (beta := Qred (a3 / a1)). set (m := cell_of (Block (At beta) beta [])). intros H0.
assert (Dv := deviation_right a1 a2 a3 c1 eps level m). destruct (deviation a1 a2 a3 c1 eps level) as [above below].
match type of H0 with (if ?x then _ else _) = _ => destruct x eqn:H; [|discriminate] end.
apply andb_prop in H. destruct H as [H _]. apply andb_prop in H. destruct H as [H Hle].
apply andb_prop in H. destruct H as [Hs Side].
destruct family_exists as [F HF]. destruct (system_right a1 a2 a3 eps level m Hs)
  as (H1 & H2 & H3 & He & Hl & Eb & B15 & Hm). fold beta in Eb, B15, Hm.
destruct (exponent_right a1 a2 a3 eps level m Hs) as [Er Hn].
destruct (one_less a1 a2 a3 eps level m Hs) as [E1 Hnum]. fold beta in E1, Hnum.
assert (V := goes_beyond_right F HF p _ _ level tau H0 Hnum Hl). rewrite E1, Eb in V.
cbn [true_force_claim]. cbv zeta. intros e pp bb y v z t He' HS Ht.
apply (CertificateForce.lift_off_certificate F (Q2R a1) (Q2R a2) (Q2R a3) (Q2R c1) (Q2R eps) (Q2R level) _ _ m (Q2R tau)
  HF H1 H2 H3 Hn Er) with (eps := e) (p := pp) (b := bb) (v := v); auto; try (rewrite <- Eb; assumption).
- assert (S := side_right a1 a2 a3 c1 eps level m Hs false Side). simpl in S. lra.
- apply (proj2 (Dv Hs)), Z.leb_le, Hle.
Qed.
