(** * The zeros as b passes an integer

    Section 5 of proofs/count_law.md, "At an integer": brackets as in [ZeroCurves.v], signs of Theta(., b) at 0
    and near +oo. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus Family SignsAtZero SignPattern PositiveZeros CountLaw IntegerPolynomials
  ContinuityInBeta ZeroCurves.
Import ListNotations.
Open Scope R_scope.

Lemma sign_open_nat (k : nat) t s : 0 < s * Pn k t -> Rbar_locally' (INR k) (fun b => 0 < s * Th b t).
Proof.
intros Hs.
assert (HL := is_lim_scal_l (fun b => Th b t) s (INR k) (Pn k t) (Th_lim_integer k t)).
simpl in HL. apply is_lim_spec in HL. destruct (HL (mkposreal _ Hs)) as [d Hd].
exists d. intros y Hy Hne.
specialize (Hd y Hy Hne). simpl in Hd. apply Rabs_def2 in Hd. lra.
Qed.

Lemma brackets_open_nat (k : nat) eps l : forall s a br, brackets (Pn k) s a eps l br ->
  Rbar_locally' (INR k) (fun b => brackets (Th b) s a eps l br).
Proof.
induction l as [|c l IH]; intros s a [|[x y] br] H; simpl in H; try tauto.
- exists (mkposreal _ Rlt_0_1). intros; exact I.
- destruct H as (H1 & H3 & H4 & H5 & H6 & H7 & H8).
  generalize (filter_and _ _ (sign_open_nat k x s H6)
    (filter_and _ _ (sign_open_nat k y (- s) H7) (IH (- s) y br H8))).
  apply filter_imp. intros b (K1 & K2 & K3). simpl. repeat split; auto; lra.
Qed.

Lemma pattern_shrink f f' s a a' l : a <= a' -> (forall c, In c l -> a' < c) -> pattern f f' s a l ->
  pattern f f' s a' l.
Proof.
destruct l as [|c l]; simpl; intros Ha Hc.
- intros H t Ht. apply H; lra.
- intros (H1 & H2 & H3). refine (conj (Hc c (or_introl eq_refl)) (conj _ H3)). intros t Ht; apply H2; lra.
Qed.

(** a zero between two points with opposite signs *)
Lemma zero_between b s x y : not_nat b -> x < y -> 0 < s * Th b x -> 0 < - s * Th b y ->
  exists z, x < z < y /\ Th b z = 0.
Proof.
intros Hn Hxy Hx Hy.
assert (DS : forall t, is_derive (fun t => - s * Th b t) t (- s * (- b * Th (b - 1) t))).
{ intros t. apply (is_derive_scal (Th b)), Th_derive, Hn. }
destruct (IVT (fun t => - s * Th b t) x y) as [z [Hz Ez]].
- apply (derive_continuity _ _ DS).
- exact Hxy.
- lra.
- exact Hy.
- assert (Hs0 : s <> 0) by (intros ->; lra).
  assert (Ef : Th b z = 0).
  { apply Rmult_integral in Ez. destruct Ez as [Ez|Ez]; auto. exfalso; apply Hs0; lra. }
  exists z. split; auto. split.
  + destruct (Rle_lt_or_eq_dec x z (proj1 Hz)) as [K|K]; auto. rewrite K, Ef in Hx. lra.
  + destruct (Rle_lt_or_eq_dec z y (proj2 Hz)) as [K|K]; auto. rewrite <- K, Ef in Hy. lra.
Qed.

(** the zeros of Theta(., b) *)
Definition Th_zero_list (b : R) (l : list R) : Prop :=
  StronglySorted Rlt l /\ forall t, Th b t = 0 <-> In t l.

Lemma Th_zero_list_length (m : nat) b l : cell m b -> Th_zero_list b l ->
  length l = (negative_count m + positive_count m)%nat.
Proof.
intros Hb [Hs Hz].
destruct (Th_zeros m b Hb) as (ln & lp & En & Ep & _ & _ & HA).
replace l with (ln ++ lp). rewrite app_length; lia.
apply sorted_unique; auto. apply (line_pattern_sorted _ _ _ _ HA).
intros x. rewrite <- Hz. symmetry. apply (line_pattern_zeros _ _ _ _ HA).
Qed.

Lemma sorted_app (l1 l2 : list R) a : StronglySorted Rlt l1 -> StronglySorted Rlt l2 ->
  (forall x, In x l1 -> x < a) -> (forall x, In x l2 -> a < x) -> StronglySorted Rlt (l1 ++ l2).
Proof.
intros H1 H2 Ha Hb. induction H1 as [|x l Hs IH Hf]; simpl; auto.
constructor.
- apply IH. intros y Hy; apply Ha; right; auto.
- apply Forall_forall. intros y Hy. apply in_app_or in Hy. destruct Hy as [Hy|Hy].
  + rewrite Forall_forall in Hf. auto.
  + specialize (Ha x (or_introl eq_refl)). specialize (Hb y Hy). lra.
Qed.

(** pointwise distance < eps *)
Definition near_lists (eps : R) (xs c : list R) : Prop :=
  length xs = length c /\ forall i, (i < length c)%nat -> Rabs (nth i xs 0 - nth i c 0) < eps.

Lemma list_upper (l : list R) : exists M, forall c, In c l -> c < M.
Proof.
induction l as [|c l (M & H)].
- exists 0. simpl; tauto.
- exists (Rmax M (c + 1)). assert (H1 := Rmax_l M (c + 1)). assert (H2 := Rmax_r M (c + 1)).
  intros x [<-|Hx]. lra. specialize (H x Hx); lra.
Qed.

Lemma close_bound eps xs c M : near_lists eps xs c -> (forall x, In x c -> x < M) -> forall x, In x xs -> x < M + eps.
Proof.
intros [E H] HM x Hx.
destruct (In_nth xs x 0 Hx) as (i & Hi & Ei).
specialize (H i ltac:(lia)). rewrite Ei in H.
assert (Hc : nth i c 0 < M) by (apply HM, nth_In; lia).
apply Rabs_def2 in H. lra.
Qed.

Lemma sp_mod k : sp k = if Nat.eqb (k mod 3) 1 then -1 else 1.
Proof.
induction k as [| | |k IH] using nat_ind3; try reflexivity. rewrite mod3_SSS. exact IH.
Qed.

Lemma counts_at k :
  match (k mod 3)%nat with
  | 0%nat => sg k = 1 /\ sg (S k) = 1 /\ negative_count k = 0%nat /\ negative_count (S k) = 0%nat /\
    positive_count k = (k / 3)%nat /\ positive_count (S k) = S (k / 3)
  | 1%nat => sg k = 1 /\ sg (S k) = -1 /\ negative_count k = 0%nat /\ negative_count (S k) = 1%nat /\
    positive_count k = S (k / 3) /\ positive_count (S k) = S (k / 3)
  | _ => sg k = -1 /\ sg (S k) = 1 /\ negative_count k = 1%nat /\ negative_count (S k) = 0%nat /\
    positive_count k = S (k / 3) /\ positive_count (S k) = S (k / 3)
  end.
Proof.
induction k as [| | |k IH] using nat_ind3; try (simpl; repeat split; reflexivity).
unfold negative_count in *. rewrite (mod3_SSS k), (mod3_SSS (S k)), div3_SSS.
change (sg (S (S (S k)))) with (sg k). change (sg (S (S (S (S k))))) with (sg (S k)).
change (positive_count (S (S (S k)))) with (S (positive_count k)).
change (positive_count (S (S (S (S k))))) with (S (positive_count (S k))).
destruct (k mod 3)%nat as [|[|j]]; destruct IH as (A & B & C & D & E & F); rewrite A, B, C, D, E, F;
repeat split; reflexivity.
Qed.

Lemma list_lower_pos (c : list R) eps : 0 < eps -> (forall x, In x c -> 0 < x) ->
  exists a, 0 < a < eps /\ forall x, In x c -> a < x.
Proof.
intros He. induction c as [|x c IH]; intros Hc.
- exists (eps / 2). split; [lra|]. simpl; tauto.
- destruct IH as (a & Ha & H). { intros y Hy; apply Hc; right; auto. }
  assert (Hx := Hc x (or_introl eq_refl)).
  exists (Rmin a (x / 2)). assert (H1 := Rmin_l a (x / 2)). assert (H2 := Rmin_r a (x / 2)).
  split. split; [apply Rmin_pos; lra|lra].
  intros y [<-|Hy]. lra. specialize (H y Hy); lra.
Qed.

Lemma pattern_first f f' s a t c : pattern f f' s a c -> a < t -> (forall x, In x c -> t < x) -> 0 < s * f t.
Proof.
destruct c as [|x c]; simpl.
- intros H Ht _. auto.
- intros (_ & H & _) Ht Hc. apply H. split; auto.
Qed.

(** Plan: brackets around the zeros c of P_k, and the signs of P_k at a0, - a0 and T1, hold for Theta(., b) with b near
    k, b <> k (Hnear). Each bracket then holds a zero xs of Theta(., b) (Hxs). [Th_zero_list_length] counts all zeros on
    either side of k; those that are missing lie, by the signs at 0 and at infinity, between - a0 and a0 or beyond T1.
    For each of k mod 3 the list xs with these is sorted and as long as l, so it is l. *)
Theorem at_integer (k : nat) (c : list R) (eps T : R) :
  StronglySorted Rlt c -> (forall t, 0 < t /\ Pn k t = 0 <-> In t c) -> 0 < eps ->
  exists delta, 0 < delta /\ forall b l, Th_zero_list b l ->
    (INR k - delta < b < INR k -> exists lo xs, l = lo ++ xs /\ near_lists eps xs c /\
       match (k mod 3)%nat with
       | 0%nat => lo = []
       | 1%nat => exists x, lo = [x] /\ 0 < x < eps
       | _ => exists x y, lo = [x; y] /\ - eps < x < 0 /\ 0 < y < eps
       end) /\
    (INR k < b < INR k + delta -> exists lo xs z, l = lo ++ xs ++ [z] /\ near_lists eps xs c /\ T < z /\
       match (k mod 3)%nat with
       | 1%nat => exists x, lo = [x] /\ - eps < x < 0
       | _ => lo = []
       end).
Proof.
intros Sc Hc He.
destruct (Pn_positive k) as (c' & Ec & Hal).
assert (c = c').
{ apply sorted_unique; auto. apply (pattern_sorted _ _ _ _ _ Hal).
  intros x. rewrite <- Hc. split.
  - intros [Hx E]. apply (pattern_zeros _ _ _ _ _ Hal x Hx), E.
  - intros Hx. assert (Hx0 := pattern_lt _ _ _ _ _ Hal x Hx). split; auto.
    apply (pattern_zeros _ _ _ _ _ Hal x Hx0), Hx. }
subst c'.
destruct (list_lower_pos c eps He (pattern_lt _ _ _ _ _ Hal)) as (a0 & [Ha0 Hae] & Hac).
assert (Sa : 0 < sp k * Pn k a0) by (apply (pattern_first _ _ _ _ _ _ Hal); auto).
assert (Sna : 0 < 1 * Pn k (- a0)) by (rewrite Rmult_1_l; apply Pn_left; lra).
destruct (Pn_right k) as (cc & T2 & Hcc & HT2 & HR).
destruct (list_upper c) as (M & HM).
set (T1 := Rmax (Rmax T T2) (Rmax (M + eps) eps)).
assert (A1 : T <= T1) by (eapply Rle_trans; apply Rmax_l).
assert (A2 : T2 <= T1) by (eapply Rle_trans; [apply Rmax_r|apply Rmax_l]).
assert (A3 : M + eps <= T1) by (eapply Rle_trans; [apply Rmax_l|apply Rmax_r]).
assert (A4 : eps <= T1) by (eapply Rle_trans; [apply Rmax_r|apply Rmax_r]).
assert (ST : 0 < (-1) ^ k * Pn k T1) by (specialize (HR T1 A2); lra).
destruct (brackets_exists _ _ eps c He (sp k) a0 (pattern_shrink _ _ _ 0 a0 c (Rlt_le _ _ Ha0) Hac Hal)) as [br Hbr].
destruct (filter_and _ _ (brackets_open_nat k eps c (sp k) a0 br Hbr)
  (filter_and _ _ (sign_open_nat k a0 (sp k) Sa)
  (filter_and _ _ (sign_open_nat k (- a0) 1 Sna) (sign_open_nat k T1 ((-1) ^ k) ST)))) as [d Hd].
exists (Rmin d 1). split. { apply Rmin_pos; [apply cond_pos|lra]. }
assert (M1 := Rmin_l d 1). assert (M2 := Rmin_r d 1).
intros b l Hl.
assert (Hnear : INR k - Rmin d 1 < b < INR k + Rmin d 1 -> b <> INR k -> 
  brackets (Th b) (sp k) a0 eps c br /\ 0 < sp k * Th b a0 /\ 0 < 1 * Th b (- a0) /\ 0 < (-1) ^ k * Th b T1).
{ intros Hb Hne. apply (Hd b); auto.
  unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. apply Rabs_def1; lra. }
(* what both sides have in common *)
assert (Hxs : not_nat b -> brackets (Th b) (sp k) a0 eps c br -> exists xs, near_lists eps xs c /\
  StronglySorted Rlt xs /\
  (forall x, In x xs -> a0 < x) /\ (forall x, In x xs -> x < T1) /\ (forall x, In x xs -> Th b x = 0)).
{ intros Hn Hb.
  destruct (brackets_zeros (Th b) _ eps c (fun t => Th_derive b t Hn) (sp k) a0 br Hb) as (xs & Ex & Sx & Zx & Nx).
  exists xs. assert (HC : near_lists eps xs c) by (split; auto).
  refine (conj HC (conj Sx (conj _ (conj _ _)))).
  - intros x Hx; apply Zx, Hx.
  - intros x Hx. assert (H := close_bound eps xs c M HC HM x Hx). lra.
  - intros x Hx; apply Zx, Hx. }
assert (HQ := counts_at k). assert (Hsp := sp_mod k).
split; intros Hb.
- assert (Hcell : cell k b) by (unfold cell; lra).
  assert (Hn := cell_not_nat _ _ Hcell).
  destruct (Hnear ltac:(lra) ltac:(lra)) as (N1 & N2 & N3 & _).
  destruct (Hxs Hn N1) as (xs & HC & Sx & Lx & Ux & Zx).
  assert (EL := Th_zero_list_length k b l Hcell Hl).
  assert (S0 := sign_0 k b Hcell).
  assert (Exs : length xs = (k / 3)%nat) by (destruct HC; congruence).
  destruct Hl as [Sl Zl].
  destruct (k mod 3)%nat as [|[|j]]; destruct HQ as (Q1 & _ & Q2 & _ & Q3 & _); simpl in Hsp;
  rewrite Q1 in S0; rewrite Hsp in N2; rewrite Q2, Q3 in EL.
  + exists [], xs. refine (conj _ (conj HC eq_refl)). simpl. symmetry. apply sorted_incl_eq; auto.
    * lia.
    * intros x Hx. apply Zl, Zx, Hx.
  + destruct (zero_between b 1 0 a0 Hn Ha0 S0 ltac:(lra)) as (x & Hx & Ex).
    exists [x], xs. refine (conj _ (conj HC _)).
    * symmetry. apply sorted_incl_eq; auto.
      -- apply (sorted_app [x] xs a0); auto. repeat constructor. intros u [<-|[]]; lra.
      -- simpl. lia.
      -- intros u Hu. apply Zl. apply in_app_or in Hu. destruct Hu as [[<-|[]]|Hu]; auto.
    * exists x. split; auto. lra.
  + destruct (zero_between b (-1) 0 a0 Hn Ha0 S0 ltac:(lra)) as (y & Hy & Ey).
    destruct (zero_between b 1 (- a0) 0 Hn ltac:(lra) N3 ltac:(lra)) as (x & Hx & Ex).
    exists [x; y], xs. refine (conj _ (conj HC _)).
    * symmetry. apply sorted_incl_eq; auto.
      -- apply (sorted_app [x; y] xs a0); auto.
         ++ repeat constructor. lra.
         ++ intros u [<-|[<-|[]]]; lra.
      -- simpl. lia.
      -- intros u Hu. apply Zl. apply in_app_or in Hu. destruct Hu as [[<-|[<-|[]]]|Hu]; auto.
    * exists x, y. repeat split; auto; lra.
- assert (Hcell : cell (S k) b) by (unfold cell; rewrite S_INR; lra).
  assert (Hn := cell_not_nat _ _ Hcell).
  destruct (Hnear ltac:(lra) ltac:(lra)) as (N1 & N2 & N3 & N4).
  destruct (Hxs Hn N1) as (xs & HC & Sx & Lx & Ux & Zx).
  assert (EL := Th_zero_list_length (S k) b l Hcell Hl).
  assert (S0 := sign_0 (S k) b Hcell).
  assert (Exs : length xs = (k / 3)%nat) by (destruct HC; congruence).
  assert (Hfar : exists z, T1 < z /\ Th b z = 0).
  { destruct (proj1 (Th_right (S k) b Hcell)) as (c3 & T3 & Hc3 & HT3 & H3).
    assert (R1 := Rmax_l T3 (T1 + 1)). assert (R2 := Rmax_r T3 (T1 + 1)).
    specialize (H3 (Rmax T3 (T1 + 1)) R1). change ((-1) ^ S k) with (-1 * (-1) ^ k) in H3.
    destruct (zero_between b ((-1) ^ k) T1 (Rmax T3 (T1 + 1)) Hn ltac:(lra) N4 ltac:(lra)) as (z & Hz & Ez).
    exists z. split; auto. lra. }
  destruct Hfar as (z & Hz & Ez).
  assert (Sxz : StronglySorted Rlt (xs ++ [z])).
  { apply (sorted_app xs [z] T1); auto. repeat constructor. intros u [<-|[]]; lra. }
  destruct Hl as [Sl Zl].
  assert (Zxz : forall u, In u (xs ++ [z]) -> Th b u = 0).
  { intros u Hu. apply in_app_or in Hu. destruct Hu as [Hu|[<-|[]]]; auto. }
  destruct (k mod 3)%nat as [|[|j]]; destruct HQ as (_ & Q1 & _ & Q2 & _ & Q3);
  rewrite Q1 in S0; rewrite Q2, Q3 in EL.
  + exists [], xs, z. refine (conj _ (conj HC (conj _ eq_refl))); [|lra]. simpl. symmetry. apply sorted_incl_eq; auto.
    * rewrite app_length. simpl. lia.
    * intros u Hu. apply Zl, Zxz, Hu.
  + destruct (zero_between b 1 (- a0) 0 Hn ltac:(lra) N3 ltac:(lra)) as (x & Hx & Ex).
    exists [x], xs, z. refine (conj _ (conj HC (conj _ _))); [|lra|].
    * symmetry. apply sorted_incl_eq; auto.
      -- apply (sorted_app [x] (xs ++ [z]) a0); auto. repeat constructor. intros u [<-|[]]; lra.
         intros u Hu. apply in_app_or in Hu. destruct Hu as [Hu|[<-|[]]]; auto. lra.
      -- simpl. rewrite app_length. simpl. lia.
      -- intros u Hu. apply Zl. apply in_app_or in Hu. destruct Hu as [[<-|[]]|Hu]; auto.
    * exists x. split; auto. lra.
  + exists [], xs, z. refine (conj _ (conj HC (conj _ eq_refl))); [|lra]. simpl. symmetry. apply sorted_incl_eq; auto.
    * rewrite app_length. simpl. lia.
    * intros u Hu. apply Zl, Zxz, Hu.
Qed.

(** The same for Theta'(., b), b near n = k + 1 (proofs/count_law.md, "At an integer"). *)
Corollary at_integer_derive (k : nat) (c : list R) (eps T : R) :
  StronglySorted Rlt c -> (forall t, 0 < t /\ Derive (Pn (S k)) t = 0 <-> In t c) -> 0 < eps ->
  exists delta, 0 < delta /\ forall b l, zero_list b l ->
    (INR (S k) - delta < b < INR (S k) -> exists lo xs, l = lo ++ xs /\ near_lists eps xs c /\
       match (k mod 3)%nat with
       | 0%nat => lo = []
       | 1%nat => exists x, lo = [x] /\ 0 < x < eps
       | _ => exists x y, lo = [x; y] /\ - eps < x < 0 /\ 0 < y < eps
       end) /\
    (INR (S k) < b < INR (S k) + delta -> exists lo xs z, l = lo ++ xs ++ [z] /\ near_lists eps xs c /\ T < z /\
       match (k mod 3)%nat with
       | 1%nat => exists x, lo = [x] /\ - eps < x < 0
       | _ => lo = []
       end).
Proof.
intros Sc Hc He.
assert (HS : 0 < INR (S k)) by (apply lt_0_INR; lia).
destruct (at_integer k c eps T Sc) as (delta & Hd & H); auto.
{ intros t. rewrite <- Hc, (is_derive_unique _ _ _ (Pn_derive k t)).
  split; intros [Ht E]; split; auto.
  - rewrite E; ring.
  - apply Rmult_integral in E. destruct E; [lra|auto]. }
exists (Rmin delta 1). split; [apply Rmin_pos; lra|].
assert (M1 := Rmin_l delta 1). assert (M2 := Rmin_r delta 1).
intros b l [Sl Zl]. rewrite S_INR in *. assert (Hk := pos_INR k).
assert (HZ : not_nat b -> Th_zero_list (b - 1) l).
{ intros Hn. split; auto. intros t. rewrite <- Zl, (is_derive_unique _ _ _ (Th_derive b t Hn)).
  assert (Hb0 := not_nat_neq0 b Hn). split; intros E.
  - rewrite E; ring.
  - apply Rmult_integral in E. destruct E as [E|E]; auto. exfalso; apply Hb0; lra. }
split; intros Hb.
- assert (Hn : not_nat b) by (apply (cell_not_nat (S k)); unfold cell; rewrite S_INR; lra).
  apply (H (b - 1) l (HZ Hn)); lra.
- assert (Hn : not_nat b) by (apply (cell_not_nat (S (S k))); unfold cell; rewrite !S_INR; lra).
  apply (H (b - 1) l (HZ Hn)); lra.
Qed.
