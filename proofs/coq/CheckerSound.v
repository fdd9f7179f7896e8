(** * What the checker accepts is true

    On each part of J there is an eta with b = (centre + radius eta)/unit, the start holds for some weights
    ([CheckerStart.v]) and so does all that follows along t ([CheckerEnclosure.v]); so each piece has what
    [piece_checked] asks. With the comparisons ([CheckerComparisons.v]) [sign_certificate] and [zeros_certificate]
    conclude. *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qabs Qround Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate SolutionSeries CertificatePieces CertificateText Checker
  CheckerCertificate
  CheckerModels CheckerEnclosure CheckerStart StatementChecker CheckerComparisons.
Import ListNotations.
Open Scope R_scope.

(** ** A part of J *)
Section Part.
Variable F : R -> R -> R.
Hypothesis HF : theta_family F.

Lemma signed_positive w s y : 0 < w -> 0 < signed s (w * y) -> 0 < signed s y.
Proof.
intros Hw H. destruct s; simpl in *; apply Rmult_lt_reg_l with w; auto; lra.
Qed.

(** What the walk finds of a piece at one b. *)
Definition found (m : nat) (signs : list (option bool)) (b : R) (p : entry) : Prop :=
  match p with
  | Sign t1 t2 s => forall t, Q2R t1 <= t <= Q2R t2 -> 0 < signed s (F b t)
  | Monotone t1 t2 d => forall t, Q2R t1 <= t <= Q2R t2 -> 0 < signed d (Derive (F b) t)
  | Hinge t1 t2 => let s := negb (Nat.eqb (m mod 3) 2) in
      forall t, Q2R t1 <= t <= Q2R t2 -> 0 < signed (if Qle_bool 0 t1 then s else negb s) (Derive (F b) t)
  | Right T _ => forall k s, nth k signs None = Some s -> 0 < signed s (Derive_n (F b) k (Q2R T))
  | Fold _ _ => False
  | _ => True
  end.

Section Walk.
Variables (g : setting) (b eta w : R) (rho : nat -> R).
Hypothesis Heta : Rabs eta <= 1.
Hypothesis Hunit : (0 < b_unit g)%Z.
Hypothesis Hb : IZR (b_unit g) * b = IZR (b_centre g) + IZR (b_radius g) * eta.
Hypothesis Hrho : weights rho.
Hypothesis Hrho0 : rho 0%nat = 1.
Hypothesis Hmost : Rabs b + 2 <= IZR (b_most g).
Hypothesis Hw : 0 < w.

Let f t := w * F b t.
Let f1 t := w * Derive (F b) t.
Let f2 t := w * Derive_n (F b) 2 t.
Let holds_at := state_holds eta rho f f1 f2.

Lemma nth_signs a s : forall k n l j, list_holds eta rho l a j -> nth k (map (sign_of 0) (firstn n l)) None = Some s ->
  0 < signed s (a (j + k)%nat).
Proof.
induction k as [|k IH]; intros [|n] [|m l] j Hl E; simpl in E; try discriminate; destruct Hl as [H0 H1].
- rewrite Nat.add_0_r. apply (sign_of_right eta Heta rho Hrho 0 m (a j)); auto.
  rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
- replace (j + S k)%nat with (S j + k)%nat by lia. apply (IH n l); auto.
Qed.

Lemma signs_at_right e T n st l : holds_at st -> signs_at g e T n st = Some l ->
  forall k s, nth k l None = Some s -> 0 < signed s (Derive_n (F b) k (Q2R T)).
Proof.
intros Hst E. unfold signs_at in E. destruct (is_positive (step_length e)) eqn:Hp; [|discriminate].
apply positive_R in Hp.
destruct (advance (most_steps e) g e T st) as [st'|] eqn:Ea; [|discriminate].
destruct (advance_right g b eta rho Heta Hunit Hb Hrho f f1 f2 (family_solves F HF b w) Hmost _ _ _ _ _ Hst Ea)
  as [Hst' Ep].
destruct (expand g e st' (step_length e)) as [c|] eqn:El; [|discriminate]. apply some_injective in E. subst l.
assert (Hl := expand_right g b eta rho Heta Hunit Hb Hrho f f1 f2 e st' _ c Hst' Hp El). rewrite Ep in Hl.
set (S := Q2R (step_length e)) in *. set (a := coefficients_at b f f1 f2 (Q2R T)) in *.
intros k s Hk. assert (P := nth_signs _ s k n c 0 Hl Hk). cbn [Nat.add] in P.
destruct (coefficients_at_start b f f1 f2 (Q2R T)) as (C0 & C1 & C2).
assert (D := Derive_n_coefficient k b (Q2R T) a f f1 f2 (family_solves F HF b w) (from_values_recurrence _ _ _ _ _)
  C0 C1 C2).
apply (signed_positive w); auto. rewrite <- Derive_n_scal_l. change (fun x => w * F b x) with f. rewrite D.
rewrite Rmult_comm in P. apply signed_positive in P; [|apply pow_lt, Hp].
assert (Hk0 := INR_fact_lt_0 k). destruct s; simpl in *.
- apply Rmult_lt_0_compat; auto.
- replace (- (INR (fact k) * a k)) with (INR (fact k) * - a k) by ring. apply Rmult_lt_0_compat; auto.
Qed.

Lemma walk_right e m : forall pieces st l, holds_at st -> walk g e m pieces st = Some l -> forall p, In p pieces ->
  found m l b p.
Proof.
assert (Sign_ok : forall order s t1 t2 st st', holds_at st -> has_sign (halvings e) g e order s t1 t2 st = Some st' ->
  holds_at st' /\ forall t, Q2R t1 <= t <= Q2R t2 -> 0 < signed s (of_order f f1 order t)).
{ intros order s t1 t2 st st' Hst E.
  exact (has_sign_right g b eta rho Heta Hunit Hb Hrho Hrho0 f f1 f2 (family_solves F HF b w)
    Hmost e order s _ _ _ _ _ Hst E). }
induction pieces as [|p rest IH]; intros st l Hst E q Iq; [destruct Iq|].
cbn [walk] in E.
destruct p as [| |X|t1 t2 s|t1 t2 d|t1 t2|t1 t2|T v].
- destruct Iq as [<-|Iq]; [exact I|apply (IH st l Hst E q Iq)].
- destruct Iq as [<-|Iq]; [exact I|apply (IH st l Hst E q Iq)].
- destruct Iq as [<-|Iq]; [exact I|apply (IH st l Hst E q Iq)].
- destruct (has_sign (halvings e) g e 0 s t1 t2 st) as [st'|] eqn:Es; [|discriminate].
  destruct (Sign_ok _ _ _ _ _ _ Hst Es) as [Hst' Ht]. destruct Iq as [<-|Iq]; [|apply (IH st' l Hst' E q Iq)].
  intros t H. apply (signed_positive w), Ht; auto.
- destruct (has_sign (halvings e) g e 1 d t1 t2 st) as [st'|] eqn:Es; [|discriminate].
  destruct (Sign_ok _ _ _ _ _ _ Hst Es) as [Hst' Ht]. destruct Iq as [<-|Iq]; [|apply (IH st' l Hst' E q Iq)].
  intros t H. apply (signed_positive w), Ht; auto.
- discriminate.
- destruct (has_sign (halvings e) g e 1 (if Qle_bool 0 t1 then negb (Nat.eqb (m mod 3) 2) else negb
    (negb (Nat.eqb (m mod 3) 2))) t1 t2 st) as [st'|] eqn:Es; [|discriminate].
  destruct (Sign_ok _ _ _ _ _ _ Hst Es) as [Hst' Ht]. destruct Iq as [<-|Iq]; [|apply (IH st' l Hst' E q Iq)].
  cbv zeta beta delta [found]. intros t H. apply (signed_positive w), Ht; auto.
- destruct rest as [|r rest]; [|discriminate]. destruct Iq as [<-|[]].
  exact (signs_at_right e T m st l Hst E).
Qed.

End Walk.

(** The eta of b. *)
Lemma eta_exists g low high b : setting_is_right g low high = true -> Q2R low <= b <= Q2R high ->
  (0 < b_unit g)%Z /\ Rabs b + 2 <= IZR (b_most g) /\
  exists eta, Rabs eta <= 1 /\ IZR (b_unit g) * b = IZR (b_centre g) + IZR (b_radius g) * eta.
Proof.
unfold setting_is_right. intros H Hb. repeat (apply andb_prop in H; destruct H as [H ?]).
apply Z.ltb_lt in H. apply Qle_bool_R in H0, H1, H4. apply Qeq_bool_eq, Qeq_eqR in H2. apply Qeq_bool_eq, Qeq_eqR in H3.
rewrite Q2R_plus, Q2R_Qabs, Q2R_whole in H0, H1. replace (Q2R 2) with 2 in H0, H1 by (unfold Q2R; simpl; field).
rewrite Q2R_mult, !Q2R_whole in H2, H3. rewrite plus_IZR in H2. rewrite minus_IZR in H3.
assert (U : 0 < IZR (b_unit g)) by (apply IZR_lt; auto).
split; auto. split.
- assert (A := Rle_abs (Q2R high)). assert (B := Rle_abs (- Q2R low)). rewrite Rabs_Ropp in B.
  assert (Rabs b <= Rmax (Rabs (Q2R low)) (Rabs (Q2R high))).
  { apply Rabs_le. generalize (Rmax_l (Rabs (Q2R low)) (Rabs (Q2R high))) (Rmax_r (Rabs (Q2R low)) (Rabs (Q2R high))).
    lra. }
  assert (Rmax (Rabs (Q2R low)) (Rabs (Q2R high)) <= IZR (b_most g) - 2) by (apply Rmax_lub; lra). lra.
- set (u := IZR (b_unit g)) in *. set (c := IZR (b_centre g)) in *. set (r := IZR (b_radius g)) in *.
  assert (Lo : u * Q2R low <= u * b) by (apply Rmult_le_compat_l; lra).
  assert (Hi : u * b <= u * Q2R high) by (apply Rmult_le_compat_l; lra).
  destruct (Req_dec r 0) as [E|E].
  + exists 0. split. rewrite Rabs_R0; lra. rewrite E in *. lra.
  + assert (R0 : 0 < r) by lra. exists ((u * b - c) / r). split; [|field; auto].
    unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ r)) by (apply Rlt_le, Rinv_0_lt_compat, R0).
    apply Rmult_le_reg_r with r; auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by auto. apply Rabs_le. lra.
Qed.

Lemma walk_part_right p m pieces low high l b : walk_part p m pieces low high = Some l -> Q2R low <= b <= Q2R high ->
  forall q, In q pieces -> found m l b q.
Proof.
unfold walk_part. intros E Hb. set (g := setting_for p low high) in *.
destruct (setting_is_right g low high) eqn:Eg; [|discriminate]. destruct (0 <? plan_x p)%Z eqn:Ex; [|discriminate].
destruct (0 <? plan_one p)%Z eqn:E1; [|discriminate].
destruct (less high (inject_Z (3 * Z.of_nat (plan_terms p)))) eqn:En; [|discriminate].
cbn [andb] in E. apply Z.ltb_lt in Ex. apply Z.ltb_lt in E1. apply less_R in En.
rewrite Q2R_whole, mult_IZR, <- INR_IZR_INZ in En.
destruct (eta_exists g low high b Eg Hb) as (Hu & Hm & eta & Heta & Eb).
destruct (start_right F HF g b eta Heta Hu Eb (plan_terms p) (plan_x p) (plan_one p) Ex E1 ltac:(lra))
  as (Hw & rho & Hrho & Hrho0 & Hst).
exact (walk_right g b eta _ rho Heta Hu Eb Hrho Hrho0 Hm Hw _ m pieces _ l Hst E).
Qed.

Lemma common_right one : forall two k s, nth k (common_signs one two) None = Some s -> nth k one None = Some s /\
  nth k two None = Some s.
Proof.
induction one as [|o one IH]; intros [|o' two] k s H.
- destruct k; discriminate.
- destruct k; discriminate.
- destruct o; destruct k; discriminate.
- destruct o as [a|], o' as [a'|]; destruct k as [|k]; simpl in H |- *; try discriminate; try (apply IH, H).
  destruct (Bool.eqb a a') eqn:E; [|discriminate]. apply Bool.eqb_prop in E. subst a'. auto.
Qed.

Lemma found_common m one two b q : (found m one b q \/ found m two b q) -> found m (common_signs one two) b q.
Proof.
destruct q; simpl; try tauto. intros [H|H] k s Hk; apply common_right in Hk; apply H; tauto.
Qed.

Lemma walk_parts_right p m pieces : forall n low high l b, walk_parts n p m pieces low high = Some l ->
  Q2R low <= b <= Q2R high ->
  forall q, In q pieces -> found m l b q.
Proof.
assert (Direct : forall low high l b halves,
  match walk_part p m pieces low high with
  | Some signs => if forallb (right_fits m signs) pieces then Some signs else halves
  | None => halves
  end = Some l -> Q2R low <= b <= Q2R high -> (halves = Some l -> forall q, In q pieces -> found m l b q) -> forall q,
    In q pieces -> found m l b q).
{ intros low high l b halves E Hb Halves. destruct (walk_part p m pieces low high) as [l'|] eqn:Ew; [|apply Halves, E].
  destruct (forallb (right_fits m l') pieces); [|apply Halves, E]. apply some_injective in E. subst l'.
  apply (walk_part_right p m pieces low high l b Ew Hb). }
induction n as [|n IH]; intros low high l b E Hb; cbn [walk_parts] in E; apply (Direct _ _ _ _ _ E Hb); clear E.
- discriminate.
- set (middle := Qred ((low + high) / 2)). intros E q Iq.
  destruct (walk_parts n p m pieces low middle) as [one|] eqn:Ea; [|discriminate].
  destruct (walk_parts n p m pieces middle high) as [two|] eqn:Ec; [|discriminate]. apply some_injective in E. subst l.
  apply found_common. destruct (Rle_lt_dec b (Q2R middle)) as [L|L].
  + left. apply (IH low middle one b Ea ltac:(lra) q Iq).
  + right. apply (IH middle high two b Ec ltac:(lra) q Iq).
Qed.

(** ** Columns *)
Lemma pieces_hold_right p c : pieces_hold p c = true ->
  in_cell (real_column c) /\ forall q, In q (entries c) -> piece_checked F (real_column c) (real_piece q).
Proof.
unfold pieces_hold. intros H2. destruct (block_in_cell c && forallb (entry_fits c) (entries c)) eqn:H; [|discriminate].
apply andb_prop in H. destruct H as [H0 H1]. split; [apply block_in_cell_R, H0|]. intros q Iq.
rewrite forallb_forall in H1. assert (Fits := H1 q Iq). clear H1.
unfold entry_fits in Fits. apply andb_prop in Fits. destruct Fits as [Lt Fits]. apply edge_lt_R in Lt.
split. { rewrite real_ends. exact Lt. }
assert (Numeric : is_numeric q = true -> exists l, (forall b, in_column (real_column c) b -> found (cell_of c) l b q) /\
  right_fits (cell_of c) l q = true).
{ intros Hn. assert (Ex : existsb is_numeric (entries c) = true) by (apply existsb_exists; exists q; auto).
  rewrite Ex in H2.
  destruct (beta_from c) as [|low|] eqn:El; try discriminate.
  destruct (walk_parts (plan_halvings p) p (cell_of c) (entries c) (low - 1) (beta_to c - 1)) as [l|] eqn:E;
    [|discriminate].
  rewrite forallb_forall in H2. exists l. split; [|apply H2, Iq]. intros b [B1 B2].
  cbn [real_column column_low column_high] in B1, B2. rewrite El in B1.
  cbn [real_edge Rbar_le] in B1. apply (walk_parts_right _ _ _ _ _ _ _ b E); auto. rewrite !Q2R_minus, Q2R_1. lra. }
destruct q as [| |X|t1 t2 s|t1 t2 d|t1 t2|t1 t2|T v]; cbn [real_piece]; cbn [is_numeric] in Numeric.
- apply Qle_bool_R in Fits. rewrite Q2R_1 in Fits. exact Fits.
- apply Qle_bool_R in Fits. rewrite Q2R_1 in Fits. exact Fits.
- apply far_left_R, Fits.
- destruct (Numeric eq_refl) as (l & Hl & _). intros t b Ht Hb. apply (Hl b Hb), Ht.
- destruct (Numeric eq_refl) as (l & Hl & _). intros t b Ht Hb. apply (Hl b Hb), Ht.
- discriminate.
- destruct (Numeric eq_refl) as (l & Hl & _). apply andb_prop in Fits. destruct Fits as [F1 F2]. apply Nat.leb_le in F1.
  cbn [real_column column_cell]. split; auto. split.
  + apply orb_prop in F2.
    destruct F2 as [F2|F2]; [left|right]; apply Qeq_bool_eq, Qeq_eqR in F2; rewrite F2; apply Q2R_0.
  + cbv zeta. intros t b Ht Hb. assert (A := Hl b Hb t Ht). cbv zeta in A.
    destruct (Qle_bool 0 t1) eqn:E; destruct (Rle_dec 0 (Q2R t1)) as [L|L]; auto; exfalso.
    * apply Qle_bool_R in E. rewrite Q2R_0 in E. auto.
    * rewrite <- Q2R_0 in L. apply Qle_bool_R in L. congruence.
- destruct (Numeric eq_refl) as (l & Hl & Hr). apply andb_prop in Fits. destruct Fits as [F1 F2].
  apply Nat.leb_le in F1. apply Nat.leb_le in F2.
  cbn [real_column column_cell]. split; auto. split; auto. unfold right_fits in Hr.
  destruct l as [|[s|] signs]; try discriminate. apply andb_prop in Hr. destruct Hr as [R1 R2]. apply Nat.eqb_eq in R1.
  destruct (changes s (signs ++ [Some (Nat.even (cell_of c))])) as [v'|] eqn:Ev; [|discriminate].
  apply Nat.eqb_eq in R2. subst v'.
  exists s, signs. split; auto. split; auto. split.
  + intros b Hb. apply (Hl b Hb 0%nat s eq_refl).
  + intros k s' b Hk Hb. apply (Hl b Hb (S k) s' Hk).
Qed.

Lemma sign_block_right tau beta s p c : sign_block tau s p c = true -> sign_column F (real_range tau) beta s
  (real_column c).
Proof.
unfold sign_block. intros H0. match type of H0 with (if ?x then _ else _) = _ => destruct x eqn:H; [|discriminate] end.
apply andb_prop in H. destruct H as [H1 H2].
destruct (pieces_hold_right p c H0) as [C P]. split; auto. split.
- cbn [real_column column_pieces]. rewrite real_ends_list. apply covers_R, H1.
- cbn [real_column column_pieces]. intros q' Iq. apply in_map_iff in Iq. destruct Iq as (q & <- & Iq).
  split; [apply P, Iq|].
  rewrite forallb_forall in H2. assert (G := H2 q Iq).
  destruct q as [| |X|t1 t2 s'|t1 t2 d|t1 t2|t1 t2|T v]; cbn [gives_sign real_piece piece_sign real_column column_cell]
    in *; try discriminate.
  + rewrite G. auto.
  + rewrite G. auto.
  + rewrite G. auto.
  + apply Bool.eqb_prop in G. rewrite G. auto.
  + apply andb_prop in G. destruct G as [G1 G2]. apply Bool.eqb_prop in G1. rewrite <- G1. split; auto. split; auto.
    intros [T0 _].
    rewrite <- Q2R_0 in T0. apply interval_holds_R in T0. rewrite T0 in G2. discriminate.
  + apply andb_prop in G. destruct G as [G1 G2]. apply Nat.eqb_eq in G1. apply Bool.eqb_prop in G2. subst v.
    rewrite Nat.add_0_r, <- G2. auto.
Qed.

(** The count does not depend on the numbers. *)
Lemma shape_count c c' : column_cell c = column_cell c' -> forall pieces before run,
  zeros_counted c before run (map shape pieces) = zeros_counted c' before run (map real_piece pieces).
Proof.
intros E. induction pieces as [|p rest IH]; intros before run; [reflexivity|].
destruct p; cbn [map shape real_piece zeros_counted piece_sign zeros_inside]; rewrite ?E, ?IH; try reflexivity.
Qed.

Lemma zeros_block_right counts p c : zeros_block counts p c = true ->
  exists n, In (cell_of c, n) counts /\ zeros_column F n (real_column c).
Proof.
unfold zeros_block. intros H0. match type of H0 with (if ?x then _ else _) = _ => destruct x eqn:H; [|discriminate] end.
apply andb_prop in H. destruct H as [H1 H2].
destruct (pieces_hold_right p c H0) as [C P].
destruct (find (fun e => Nat.eqb (fst e) (cell_of c)) counts) as [[m n]|] eqn:Ef; [|discriminate].
destruct (zeros_counted (Column m_infty 0 (cell_of c) []) None None (map shape (entries c))) as [n'|] eqn:Ez;
  [|discriminate].
apply find_some in Ef. destruct Ef as [I Em]. cbn [fst snd] in *. apply Nat.eqb_eq in Em. apply Nat.eqb_eq in H2.
subst m n'.
exists n. split; auto. split; auto. split; [|split].
- cbn [real_column column_pieces]. rewrite real_ends_list. apply (covers_R _ MinusInfinity PlusInfinity), H1.
- cbn [real_column column_pieces]. intros q' Iq. apply in_map_iff in Iq. destruct Iq as (q & <- & Iq). apply P, Iq.
- cbn [real_column column_pieces]. rewrite <- Ez. symmetry.
  apply (shape_count (Column m_infty 0 (cell_of c) []) (real_column c)). reflexivity.
Qed.

Lemma on_each_right check : forall plans l, on_each check plans l = true -> forall c, In c l -> exists p,
  check p c = true.
Proof.
induction plans as [|p plans IH]; intros [|c' l] H c Ic; try discriminate; [destruct Ic|].
cbn [on_each] in H. destruct (check p c') eqn:A; [|discriminate]. rename H into B.
destruct Ic as [<-|Ic]; [exists p; auto|apply (IH l); auto].
Qed.

Lemma columns_R l : map (fun c => (column_low c, Finite (column_high c))) (map real_column l)
  = real_parts (map (fun c => (beta_from c, At (beta_to c))) l).
Proof. unfold real_parts. rewrite !map_map. reflexivity. Qed.
End Part.

Theorem accepted_is_true F plans c : theta_family F -> accepts plans c = true -> true_claim F (claimed c).
Proof.
intros HF H. unfold accepts in H. destruct (claimed c) as [tau beta s|beta counts].
- destruct (covers (map (fun c => (beta_from c, At (beta_to c))) (blocks c)) (interval_from beta) (interval_to beta))
    eqn:Hc; [|discriminate].
  apply covers_R in Hc. rewrite <- columns_R in Hc. cbn [true_claim].
  apply (sign_certificate F (real_range tau) (real_range beta) (map real_column (blocks c)) s HF Hc).
  destruct (all_positive beta) eqn:E.
  + left. split. { intros x. apply all_positive_R, E. }
    intros c' Ic. apply in_map_iff in Ic. destruct Ic as (d & <- & Id). destruct (on_each_right _ _ _ H d Id) as [p Hp].
    apply (sign_block_right F HF tau (real_range beta) (negb s) p d Hp).
  + destruct (all_negative beta) eqn:E'; [|discriminate]. right. split. { intros x. apply all_negative_R, E'. }
    intros c' Ic. apply in_map_iff in Ic. destruct Ic as (d & <- & Id). destruct (on_each_right _ _ _ H d Id) as [p Hp].
    apply (sign_block_right F HF tau (real_range beta) s p d Hp).
- match type of H with (if ?x then _ else _) = _ => destruct x eqn:Hx; [|discriminate] end. rename H into Hz.
  apply andb_prop in Hx. destruct Hx as [H0 Hc]. apply covers_R in Hc. rewrite <- columns_R in Hc.
  cbn [true_claim]. intros b Hb Nb.
  assert (Each : forall c', In c' (map real_column (blocks c)) -> exists n, In (column_cell c', n) counts /\
    zeros_column F n c').
  { intros c' Ic. apply in_map_iff in Ic. destruct Ic as (d & <- & Id).
    destruct (on_each_right _ _ _ Hz d Id) as [p Hp].
    exact (zeros_block_right F HF counts p d Hp). }
  assert (B0 : 0 < b).
  { apply edge_le_R in H0. cbn [real_edge] in H0. rewrite Q2R_0 in H0. assert (Cl := proj1 (in_range_closure _ _ Hb)).
    assert (L := Rbar_le_trans _ _ _ H0 Cl). simpl in L. destruct (Rle_lt_or_eq_dec _ _ L) as [P|P]; auto.
    exfalso. apply (Nb 0%nat). simpl. auto. }
  destruct (column_of (map real_column (blocks c)) (real_range beta) b Hc Hb) as (c' & Ic & Hcol).
  destruct (Each c' Ic) as (n & In_ & Zc).
  destruct (nfloor_ex b (Rlt_le _ _ B0)) as (k & Hk1 & Hk2).
  assert (Hk : INR k < b < INR k + 1).
  { split; [|exact Hk2]. destruct (Rle_lt_or_eq_dec _ _ Hk1) as [L|E]; auto. exfalso. apply (Nb k). auto. }
  destruct Zc as (C & Hp & Hall & Hn). destruct (cell_of_column c' k b C Hcol Hk) as [Em Cb].
  destruct (zeros_on_line F HF c' C n (b - 1) Hp Hall Hn Hcol Cb) as (l & L & Z).
  destruct (zeros_of_slope F b l HF ltac:(lra) Z) as [A B].
  exists (column_cell c'), n, l. split; [exact In_|]. rewrite <- Em. split; [exact Hk|]. split; [exact A|].
  split; [exact L|exact B].
Qed.
