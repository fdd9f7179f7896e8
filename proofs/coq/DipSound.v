(** * What the checker accepts about the zeros at every eps is true

    On each part of a column F(t1), F'(t1) and F'(t2) have models with the same eta and the same weights; so has their
    sum with the lower power, which another power between the two changes by no more than the difference of the powers
    times the bound of F'(t2). The powers of mu = t1/t2 are compared as n-th powers of integers at two exponents
    beyond the ends of the column. [slow_zeros_certificate] concludes. *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qround Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant StatementCertificate CertificateText StatementChecker ForceText
  Checker CheckerCertificate ForceChecker StatementForce CertificateSlow CheckerModels CheckerEnclosure CheckerStart
  CheckerComparisons ForceSound.
Import ListNotations.
Open Scope R_scope.

(** ** Powers *)
Lemma power_decreases mu x y : 0 < mu < 1 -> x <= y -> Rpower mu y <= Rpower mu x.
Proof.
intros H L. assert (N : ln mu < 0) by (rewrite <- ln_1; apply ln_increasing; lra). unfold Rpower.
destruct (Rle_lt_or_eq_dec _ _ L) as [L'| ->]; [|lra]. apply Rlt_le, exp_increasing. nra.
Qed.

(** r^n against mu^h, without denominators. *)
Lemma power_compared r mu c : 0 < Q2R r -> 0 < Q2R mu -> (0 <= Qnum c)%Z ->
  let n := Zpos (Qden c) in let h := Qnum c in
  ((Qnum r ^ n * Zpos (Qden mu) ^ h <= Zpos (Qden r) ^ n * Qnum mu ^ h)%Z -> Q2R r <= Rpower (Q2R mu) (Q2R c)) /\
  ((Zpos (Qden r) ^ n * Qnum mu ^ h <= Qnum r ^ n * Zpos (Qden mu) ^ h)%Z -> Rpower (Q2R mu) (Q2R c) <= Q2R r).
Proof.
intros Hr Hmu Hc n h. destruct (fraction_parts r) as [Er Dr]. destruct (fraction_parts mu) as [Em Dm].
assert (P : 0 <= Rpower (Q2R mu) (Q2R c)) by apply Rlt_le, exp_pos.
assert (N := Pos2Nat.is_pos (Qden c)). set (k := Pos.to_nat (Qden c)) in *. set (j := Z.to_nat (Qnum c)).
assert (D1 := pow_lt _ k Dr). assert (D2 := pow_lt _ j Dm).
assert (One : IZR (Qnum r ^ n * Zpos (Qden mu) ^ h) = Q2R r ^ k * (IZR (Zpos (Qden r)) ^ k * IZR (Zpos (Qden mu)) ^ j)).
{ unfold n, h. rewrite mult_IZR, whole_power, natural_exponent by auto. fold k j. rewrite Er. unfold Rdiv.
  rewrite Rpow_mult_distr, pow_inv. field. lra. }
assert (Two : IZR (Zpos (Qden r) ^ n * Qnum mu ^ h) =
  Rpower (Q2R mu) (Q2R c) ^ k * (IZR (Zpos (Qden r)) ^ k * IZR (Zpos (Qden mu)) ^ j)).
{ unfold n, h. rewrite mult_IZR, whole_power, natural_exponent by auto. unfold k. rewrite power_fraction by auto.
  fold k j. rewrite Em. unfold Rdiv. rewrite Rpow_mult_distr, pow_inv. field. lra. }
assert (D : 0 < IZR (Zpos (Qden r)) ^ k * IZR (Zpos (Qden mu)) ^ j) by (apply Rmult_lt_0_compat; auto).
assert (R0 := Rlt_le _ _ Hr).
split; intros H; apply IZR_le in H; rewrite One, Two in H; apply Rmult_le_reg_r in H; auto;
  [exact (proj1 (power_order _ _ k R0 P N) H)|exact (proj1 (power_order _ _ k P R0 N) H)].
Qed.

(** ** A dip *)
Section Dips.
Variable F : R -> R -> R.
Hypothesis HF : theta_family F.
Variables (p : force_plan) (weight t1 t2 : Q).
Hypothesis Hweight : 0 <= Q2R weight.

Definition dip_at (b power : R) : Prop :=
  F b (Q2R t1) + Q2R weight * (power * Derive (F b) (Q2R t2) - Derive (F b) (Q2R t1)) < 0.

Lemma dips_at_right low high b power : dips_at p weight t1 t2 low high = true -> Q2R low <= b <= Q2R high ->
  Q2R (power_below p) <= power <= Q2R (power_above p) -> dip_at b power.
Proof.
unfold dips_at. set (q := walk_plan p). set (g := setting_for q low high). intros H Hb Hp.
destruct (begins q low high) eqn:Eb; [|discriminate].
destruct (begins_right F HF q low high b Eb Hb) 
  as (Hx & H1 & Hu & Hm & Hw & eta & rho & Heta & Ee & Hrho & Hrho0 & Hst).
set (w := factor b (plan_one q) (plan_x q)) in *. fold g in Hu, Hm, Ee.
assert (Right := advance_right g b eta rho Heta Hu Ee Hrho _ _ _ (family_solves F HF b w) Hm).
destruct (advance (most_steps (plan_effort q)) g (plan_effort q) t1 (first_state q low high)) as [st1|] eqn:E1;
  [|discriminate].
destruct (Right _ _ _ _ _ Hst E1) as [Hst1 P1].
destruct (advance (most_steps (plan_effort q)) g (plan_effort q) t2 st1) as [st2|] eqn:E2; [|discriminate].
destruct (Right _ _ _ _ _ Hst1 E2) as [Hst2 P2]. clear Right Hst E1 E2.
destruct Hst1 as (S1 & V0 & V1 & _). destruct Hst2 as (S2 & _ & V2 & _). rewrite P1 in V0, V1. rewrite P2 in V2.
cbv zeta in H. set (one := Qred (- (weight / scale st1))) in *.
set (two := Qred (weight / scale st2 * power_below p)) in *.
set (other := Qred (weight / scale st2 * (power_above p - power_below p))) in *.
assert (Q1 : Q2R one = - (Q2R weight / Q2R (scale st1))).
{ unfold one. rewrite Q2R_red, Q2R_opp, Q2R_div by (apply nonzero_Q; lra). reflexivity. }
assert (Q2 : Q2R two = Q2R weight / Q2R (scale st2) * Q2R (power_below p)).
{ unfold two. rewrite Q2R_red, Q2R_mult, Q2R_div by (apply nonzero_Q; lra). reflexivity. }
assert (Q3 : Q2R other = Q2R weight / Q2R (scale st2) * (Q2R (power_above p) - Q2R (power_below p))).
{ unfold other. rewrite Q2R_red, Q2R_mult, Q2R_minus, Q2R_div by (apply nonzero_Q; lra). reflexivity. }
set (sum := model_plus _ _) in H. set (rest := Qceiling _) in H.
destruct (sign_of rest sum) as [[|]|] eqn:Es; try discriminate. clear H.
set (f0 := F b (Q2R t1)) in *. set (d1 := Derive (F b) (Q2R t1)) in *. set (d2 := Derive (F b) (Q2R t2)) in *.
assert (Sum := holds_plus eta rho _ _ _ _
  (holds_plus eta rho _ _ _ _ V0 (holds_multiple g eta rho Heta Hrho one _ _ V1))
  (holds_multiple g eta rho Heta Hrho two _ _ V2)). fold sum in Sum.
assert (B2 := holds_norm eta Heta rho Hrho _ _ V2). cbv beta in B2. fold d2 in B2.
set (N := IZR (model_norm (value1 st2))) in *.
assert (Rest : Q2R other * N <= IZR rest).
{ assert (C := Qle_Rle _ _ (Qle_ceiling (other * inject_Z (model_norm (value1 st2))))).
  rewrite Q2R_mult, !Q2R_whole in C. exact C. }
assert (Sign := sign_of_right eta Heta rho Hrho rest sum _
  (w * (f0 + Q2R weight * (power * d2 - d1))) false Hrho0 Sum).
assert (A : 0 < signed false (w * (f0 + Q2R weight * (power * d2 - d1)))).
{ apply Sign; auto. cbv beta. fold f0 d1 d2. rewrite Q1, Q2.
  assert (W : 0 <= Q2R weight / Q2R (scale st2)) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat, S2]).
  match goal with |- Rabs ?x <= _ =>
    replace x with (Q2R weight / Q2R (scale st2) * (power - Q2R (power_below p)) * (Q2R (scale st2) * (w * d2)))
      by (field; lra) end.
  rewrite Rabs_mult, (Rabs_pos_eq (Q2R weight / Q2R (scale st2) * (power - Q2R (power_below p))))
    by (apply Rmult_le_pos; lra).
  eapply Rle_trans; [|exact Rest]. rewrite Q3. apply Rmult_le_compat; auto using Rabs_pos.
  - apply Rmult_le_pos; lra.
  - apply Rmult_le_compat_l; lra. }
simpl in A. unfold dip_at. fold f0 d1 d2. apply Rmult_lt_reg_l with w; auto. lra.
Qed.

Lemma dips_right n : forall low high b power, dips n p weight t1 t2 low high = true -> Q2R low <= b <= Q2R high ->
  Q2R (power_below p) <= power <= Q2R (power_above p) -> dip_at b power.
Proof.
induction n as [|n IH]; intros low high b power H Hb Hp; cbn [dips] in H;
  destruct (dips_at p weight t1 t2 low high) eqn:E; try (apply (dips_at_right low high b power E Hb Hp)).
- discriminate.
- set (middle := Qred ((low + high) / 2)) in *.
  destruct (dips n p weight t1 t2 low middle) eqn:El; [|discriminate].
  destruct (Rle_lt_dec b (Q2R middle)) as [L|L]; [apply (IH low middle b power El)|apply (IH middle high b power H)];
    auto; lra.
Qed.
End Dips.

Lemma dip_holds_right F p eta c : theta_family F -> dip_holds p eta c = true -> 0 < Q2R eta ->
  exists t1 t2, strip_parts c = [Dip t1 t2] /\
  dip_checked F (Q2R eta) (Q2R (strip_from c)) (Q2R (strip_to c)) (Q2R t1) (Q2R t2).
Proof.
unfold dip_holds. intros HF H He. destruct (strip_parts c) as [|[|t1 t2|t1 t2] [|]]; try discriminate.
exists t1, t2. split; [reflexivity|]. set (mu := Qred (t1 / t2)) in *.
set (low := Qred (strip_from c - 1)) in *. set (high := Qred (strip_to c - 1)) in *.
match type of H with (if ?x then _ else _) = _ => destruct x eqn:Hx; [|discriminate] end. rename H into Hd.
repeat (apply andb_prop in Hx; destruct Hx as [Hx ?]). rename H into Above, H0 into Below, H1 into Short, H2 into Long,
  H3 into Cube, H4 into Lt12.
apply Qle_bool_R in Short. apply Qle_bool_R in Long. rewrite Q2R_plus, Q2R_1 in Short, Long.
apply less_R in Hx. apply less_R in Lt12. rewrite Q2R_0 in Hx. apply Qle_bool_R in Cube.
rewrite !Q2R_mult, (Q2R_small 2) in Cube.
assert (Em : Q2R mu = Q2R t1 / Q2R t2).
{ unfold mu. rewrite Q2R_red. apply Q2R_div, nonzero_Q. lra. }
assert (Mu : 0 < Q2R mu < 1).
{ rewrite Em. split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with (Q2R t2); [lra|]. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l; lra. }
assert (M3 : Q2R mu ^ 3 < 1) by (simpl; assert (Q2R mu * Q2R mu < 1) by nra; nra).
assert (El : Q2R low = Q2R (strip_from c) - 1) by (unfold low; rewrite Q2R_red, Q2R_minus, Q2R_1; reflexivity).
assert (Eh : Q2R high = Q2R (strip_to c) - 1) by (unfold high; rewrite Q2R_red, Q2R_minus, Q2R_1; reflexivity).
unfold below_power in Below. unfold above_power in Above.
repeat (apply andb_prop in Below; destruct Below as [Below ?]). rename H into LB, H0 into NB.
repeat (apply andb_prop in Above; destruct Above as [Above ?]). rename H into LA, H0 into NA.
apply less_R in Below. apply less_R in Above. rewrite Q2R_0 in Below, Above.
apply Z.leb_le in LB. apply Z.leb_le in NB. apply Z.leb_le in LA. apply Z.leb_le in NA.
apply (proj1 (power_compared _ _ _ Below (proj1 Mu) NB)) in LB.
apply (proj2 (power_compared _ _ _ Above (proj1 Mu) NA)) in LA.
set (weight := Qred (3 * eta / (8 * (1 - mu * mu * mu)))) in *.
assert (Ew : Q2R weight = 3 * Q2R eta / (8 * (1 - Q2R mu ^ 3))).
{ unfold weight. rewrite Q2R_red, Q2R_div.
  - rewrite !Q2R_mult, Q2R_minus, !Q2R_mult, (Q2R_small 3), (Q2R_small 8), Q2R_1. simpl. field. simpl in M3. lra.
  - apply nonzero_Q. rewrite Q2R_mult, Q2R_minus, !Q2R_mult, (Q2R_small 8), Q2R_1. simpl in M3. lra. }
assert (W : 0 <= Q2R weight) by (rewrite Ew; apply Rlt_le, Rdiv_lt_0_compat; lra).
split; [lra|]. split; [simpl; lra|]. cbv zeta. rewrite <- Em, <- Ew. intros b Hb.
apply (dips_right F HF p weight t1 t2 W _ low high b _ Hd); [lra|]. split.
- eapply Rle_trans; [exact LB|]. apply power_decreases; [exact Mu|lra].
- eapply Rle_trans; [|exact LA]. apply power_decreases; [exact Mu|lra].
Qed.

Lemma each_strip_right F eta : theta_family F -> 0 < Q2R eta -> forall plans l, each_strip eta plans l = true ->
  forall c, In c l -> exists t1 t2, strip_parts c = [Dip t1 t2] /\
  dip_checked F (Q2R eta) (Q2R (strip_from c)) (Q2R (strip_to c)) (Q2R t1) (Q2R t2).
Proof.
intros HF He. induction plans as [|p plans IH]; intros [|d l] H c I; try discriminate; [destruct I|].
cbn [each_strip] in H. destruct (dip_holds p eta d) eqn:E; [|discriminate].
destruct I as [<-|I]; [exact (dip_holds_right F p eta d HF E He)|exact (IH l H c I)].
Qed.

(** ** All claims *)
Theorem slow_zeros_right plans l beta eps eta :
  force_accepts plans (ForceData (SlowZerosClaim beta eps eta) l) = true ->
  true_force_claim (SlowZerosClaim beta eps eta).
Proof.
unfold force_accepts. cbn [force_claimed strips]. intros H0.
match type of H0 with (if ?x then _ else _) = _ => destruct x eqn:H; [|discriminate] end.
repeat (apply andb_prop in H; destruct H as [H ?]). rename H1 into Cover, H2 into Eps, H3 into Eta, H4 into Hi.
apply edge_le_R in H. apply edge_le_R in Hi. apply less_R in Eta. rewrite Q2R_0 in Eta. apply Qle_bool_R in Eps.
rewrite !Q2R_mult, (Q2R_small 2) in Eps. apply covers_R in Cover.
destruct family_exists as [F HF]. assert (Each := each_strip_right F eta HF Eta plans l H0).
set (ends := fun c => match strip_parts c with [Dip t1 t2] => (Q2R t1, Q2R t2) | _ => (0, 0) end).
set (columns := map (fun c => (Q2R (strip_from c), Q2R (strip_to c), fst (ends c), snd (ends c))) l).
refine (CertificateSlow.slow_zeros_certificate F (real_range beta) columns (Q2R eps) (Q2R eta) HF _ Eta _ _ _).
- intros x [A B]. assert (C := CertificatePieces.in_range_closure (real_range beta) x (conj A B)).
  cbn [real_range range_from range_to] in C. destruct C as [C1 C2].
  cbn [real_edge] in H, Hi. rewrite (Q2R_small 4) in H. rewrite (Q2R_small 5) in Hi.
  assert (D1 := Rbar_le_trans _ _ _ H C1). assert (D2 := Rbar_le_trans _ _ _ C2 Hi). simpl in D1, D2. lra.
- simpl. lra.
- unfold columns. rewrite map_map. unfold real_parts in Cover. rewrite map_map in Cover. exact Cover.
- intros low high t1 t2 I. unfold columns in I. apply in_map_iff in I. destruct I as (c & E & I).
  destruct (Each c I) as (u1 & u2 & Ec & D). unfold ends in E. rewrite Ec in E. injection E as <- <- <- <-. exact D.
Qed.

Theorem force_accepted_is_true plans c : force_accepts plans c = true -> true_force_claim (force_claimed c).
Proof.
destruct c as [claim l]. cbn [force_claimed]. intros H. destruct claim as [a1 a2 a3 c1 eps level tau|
  a1 a2 a3 c1 eps level tau|beta eps eta]; [| |exact (slow_zeros_right plans l beta eps eta H)];
  unfold force_accepts in H; cbn [force_claimed strips] in H; destruct plans as [|p [|]]; try discriminate;
  destruct (one_strip (Qred (a3 / a1)) l) as [c|]; try discriminate.
- exact (force_holds_right (walk_plan p) a1 a2 a3 c1 eps level tau c H).
- exact (lift_off_holds_right (walk_plan p) a1 a2 a3 c1 eps level tau c H).
Qed.
