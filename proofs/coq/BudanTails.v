(** * The number of zeros on a half-line, with multiplicity

    The theorem of Budan and Fourier for Theta and for the slow solution at every eps: f^(n+1) has one sign on the line,
    at the far right f, ..., f^(n+1) have one sign (V = 0), at the far left they alternate (V = n + 1). Hence the zeros
    beyond T are V(T) less an even number, and those up to T are n + 1 - V(T) less an even number. The list of zeros
    with multiplicity is unique and holds every zero; so V = 0 means no zero, V = 1 exactly one, a simple one, and there
    are at most V different zeros. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus GammaFunction LaplaceIntegral WellPosed EnvelopingSeries Family
  IntegerPolynomials Ends
  CompliantKernel CompliantIntegral CompliantSlow BudanFourier.
Import ListNotations.
Open Scope R_scope.

(** ** The list of zeros *)
Lemma order_unique f z m m' : zero_order f z m -> zero_order f z m' -> m = m'.
Proof.
intros [A B] [A' B']. destruct (lt_eq_lt_dec m m') as [[H|H]|H]; auto; exfalso.
- exact (B (A' m H)).
- exact (B' (A m' H)).
Qed.

Lemma sorted_by_count (l l' : list R) : StronglySorted Rle l -> StronglySorted Rle l' ->
  (forall z, count_occ Req_EM_T l z = count_occ Req_EM_T l' z) -> l = l'.
Proof.
revert l'. induction l as [|x l IH]; intros [|y l'] H H' C; auto.
- exfalso. specialize (C y). simpl in C. destruct (Req_EM_T y y); [lia|auto].
- exfalso. specialize (C x). simpl in C. destruct (Req_EM_T x x); [lia|auto].
- inversion H as [|? ? S F]; inversion H' as [|? ? S' F']; subst. rewrite Forall_forall in F, F'.
  assert (E : x = y).
  { destruct (Req_EM_T x y) as [E|E]; auto. exfalso.
    assert (Ix : In x l').
    { apply (count_occ_In Req_EM_T). assert (Cx := C x). simpl in Cx.
      destruct (Req_EM_T x x); [|contradiction]. destruct (Req_EM_T y x); [congruence|lia]. }
    assert (Iy : In y l).
    { apply (count_occ_In Req_EM_T). assert (Cy := C y). simpl in Cy.
      destruct (Req_EM_T y y); [|contradiction]. destruct (Req_EM_T x y); [contradiction|lia]. }
    specialize (F y Iy). specialize (F' x Ix). lra. }
  subst y. f_equal. apply IH; auto. intros z. specialize (C z). simpl in C. destruct (Req_EM_T x z); lia.
Qed.

Theorem zeros_unique f place l l' : zeros_with_multiplicity f place l -> zeros_with_multiplicity f place l' -> l = l'.
Proof.
intros (S & I & O) (S' & I' & O'). apply sorted_by_count; auto. intros z.
destruct (Classical_Prop.classic (place z)) as [P|P].
- exact (order_unique f z _ _ (O z P) (O' z P)).
- rewrite !(proj1 (count_occ_not_In Req_EM_T _ z)); auto.
Qed.

Lemma zeros_listed f place l : zeros_with_multiplicity f place l -> forall z, In z l <-> place z /\ f z = 0.
Proof.
intros (S & I & O) z. split.
- intros H. split. exact (I z H). destruct (O z (I z H)) as [A _]. apply (A 0%nat). apply count_occ_In, H.
- intros [P E]. destruct (O z P) as [_ B]. apply (count_occ_In Req_EM_T).
  destruct (count_occ Req_EM_T l z) as [|m]; [contradiction|lia].
Qed.

Theorem distinct_zeros f place l zeros : zeros_with_multiplicity f place l -> StronglySorted Rlt zeros ->
  (forall z, In z zeros -> place z /\ f z = 0) -> (length zeros <= length l)%nat.
Proof.
intros H S Z. apply NoDup_incl_length.
- clear Z. induction S as [|x r S IH F]; constructor; auto. intros Hx. rewrite Forall_forall in F. specialize (F x Hx).
  lra.
- intros z Hz. apply (zeros_listed f place l H), Z, Hz.
Qed.

Lemma zero_count_one f z m : f z = 0 -> Derive f z <> 0 -> zero_order f z m -> m = 1%nat.
Proof.
intros E H O. apply (order_unique f z _ _ O). split; [|exact H]. intros k Hk. replace k with 0%nat by lia. exact E.
Qed.

Lemma simple_zeros f place l zeros : zeros_with_multiplicity f place l -> StronglySorted Rlt zeros ->
  (forall z, In z zeros <-> place z /\ f z = 0) -> (forall z, In z zeros -> Derive f z <> 0) -> l = zeros.
Proof.
intros H S Z Hs. assert (L := zeros_listed f place l H). destruct H as (S' & I & O).
apply sorted_by_count; auto.
- clear Z Hs. induction S as [|x r S IH F]; constructor; auto. rewrite Forall_forall in *. intros y Hy.
  specialize (F y Hy). lra.
- intros z. destruct (in_dec Req_EM_T z zeros) as [Hz|Hz].
  + destruct (proj1 (Z z) Hz) as [P E]. rewrite (zero_count_one f z _ E (Hs z Hz) (O z P)).
    symmetry. apply NoDup_count_occ'; auto. clear - S.
    induction S as [|x r S IH F]; constructor; auto. intros Hx. rewrite Forall_forall in F. specialize (F x Hx). lra.
  + rewrite !(proj1 (count_occ_not_In Req_EM_T _ z)); auto. rewrite (L z), <- (Z z). exact Hz.
Qed.

Theorem list_with_multiplicity f place l : zeros_with_multiplicity f place l ->
  (forall l', zeros_with_multiplicity f place l' -> l' = l) /\
  (forall z, In z l <-> place z /\ f z = 0) /\
  forall zeros, StronglySorted Rlt zeros ->
    ((forall z, In z zeros -> place z /\ f z = 0) -> (length zeros <= length l)%nat) /\
    ((forall z, In z zeros <-> place z /\ f z = 0) -> (forall z, In z zeros -> Derive f z <> 0) -> l = zeros).
Proof.
intros H. split; [|split].
- intros l' H'. exact (zeros_unique f place l' l H' H).
- exact (zeros_listed f place l H).
- intros zeros S. split. exact (distinct_zeros f place l zeros H S). exact (simple_zeros f place l zeros H S).
Qed.

Lemma no_zero f place : zeros_with_multiplicity f place [] -> forall z, place z -> f z <> 0.
Proof. intros H z P E. exact (proj2 (zeros_listed f place [] H z) (conj P E)). Qed.

Lemma one_zero f place z : zeros_with_multiplicity f place [z] ->
  place z /\ f z = 0 /\ Derive f z <> 0 /\ forall t, place t -> f t = 0 -> t = z.
Proof.
intros H. destruct (proj1 (zeros_listed f place [z] H z) (or_introl eq_refl)) as [P E].
refine (conj P (conj E (conj _ _))).
- destruct H as (_ & _ & O). specialize (O z P). simpl in O. destruct (Req_EM_T z z); [|contradiction]. apply O.
- intros t Pt Et. destruct (proj2 (zeros_listed f place [z] H t) (conj Pt Et)) as [<-|[]]. reflexivity.
Qed.

(** ** The signs at the two ends *)
Lemma first_last_positive l x y : 0 < x -> 0 < y ->
  (0 < first_nonzero (l ++ [x]) /\ 0 < first_nonzero (l ++ [y])) \/ first_nonzero (l ++ [x]) = first_nonzero (l ++ [y]).
Proof.
intros Hx Hy. induction l as [|a l IH]; simpl.
- left. destruct (Req_EM_T x 0), (Req_EM_T y 0); lra.
- destruct (Req_EM_T a 0); auto.
Qed.

Lemma variations_last l x y : 0 < x -> 0 < y -> variations (l ++ [x]) = variations (l ++ [y]).
Proof.
intros Hx Hy. induction l as [|a l IH].
- simpl. rewrite !Rmult_0_r. destruct (Rlt_dec 0 0); reflexivity.
- simpl app. destruct (first_last_positive l x y Hx Hy) as [[F F']|F].
  + destruct (Rlt_le_dec a 0) as [A|A].
    * rewrite !variations_more; auto; nra.
    * rewrite !variations_same; auto; nra.
  + simpl. rewrite F, IH. reflexivity.
Qed.

Lemma variations_positive l : (forall x, In x l -> 0 < x) -> variations l = 0%nat.
Proof.
induction l as [|a l IH]; intros H; auto. assert (A := H a (or_introl eq_refl)).
assert (IH' := IH (fun x Hx => H x (or_intror Hx))).
rewrite variations_same; auto. destruct l as [|x l]; [simpl; lra|].
assert (X := H x (or_intror (or_introl eq_refl))). rewrite first_cons by lra. nra.
Qed.

Lemma variations_alternating s (g : nat -> R) : forall n k, (forall i, (k <= i <= k + n)%nat ->
  0 < s * ((-1) ^ i * g i)) ->
  variations (map g (seq k (S n))) = n.
Proof.
induction n as [|n IH]; intros k H.
- simpl. rewrite Rmult_0_r. destruct (Rlt_dec 0 0); auto; lra.
- change (map g (seq k (S (S n)))) with (g k :: map g (seq (S k) (S n))).
  assert (A := H k ltac:(lia)). assert (B := H (S k) ltac:(lia)).
  rewrite variations_more. f_equal. apply IH. intros i Hi. apply H. lia.
  change (map g (seq (S k) (S n))) with (g (S k) :: map g (seq (S (S k)) n)).
  rewrite first_cons by (intros E; rewrite E, !Rmult_0_r in B; lra).
  assert (0 < g k * - g (S k)); [|lra]. apply same_sign with (s * (-1) ^ k). lra. simpl in B. lra.
Qed.

Section Tails.
Variables (f : R -> R) (c : R) (N : nat).
Hypothesis D : forall k t, ex_derive_n f k t.
Hypothesis Htop : forall t, 0 < c * Derive_n f N t.
Hypothesis Hright : forall k, exists X, forall t, X <= t -> 0 < c * Derive_n f k t.
Hypothesis Hleft : forall k, (k <= N)%nat -> exists X, forall t, t <= X -> 0 < (-1) ^ k * Derive_n f k t.

Definition tail_variations (T : R) : nat := variations (map (fun k => c * Derive_n f k T) (seq 0 N) ++ [1]).

Lemma tail_variations_from T : variations (from (fun k t => c * Derive_n f k t) 0 N T) = tail_variations T.
Proof.
unfold tail_variations, from. rewrite seq_S, map_app. apply variations_last; [|lra]. apply Htop.
Qed.

Lemma between T T' : T <= T' -> exists l j, zeros_with_multiplicity f (fun t => T < t <= T') l /\
  tail_variations T = (tail_variations T' + length l + 2 * j)%nat.
Proof.
intros HT.
destruct (collected_at (fun k t => c * Derive_n f k t) N T T' 1) with (t := T') as (l & j & S & I & O & V); try lra.
- intros k t _ _. apply (is_derive_scal (Derive_n f k)). apply Derive_correct. exact (D (S k) t).
- intros t _. rewrite Rmult_1_l. apply Htop.
- exists l, j. split.
  + split; [auto|split; auto]. intros z Hz. destruct (O z Hz) as [A B].
    assert (Hc : c <> 0) by (intros E; specialize (Htop T); rewrite E in Htop; lra). split.
    * intros k Hk. destruct (Rmult_integral _ _ (A k Hk)); [contradiction|auto].
    * intros E. apply B. simpl. rewrite E. ring.
  + rewrite <- !tail_variations_from. exact V.
Qed.

Lemma far (P : nat -> R -> Prop) (before : R -> R -> Prop) : (forall x y z, before x y -> before y z -> before x z) ->
  (forall x y, exists z, before x z /\ before y z) -> forall n, (forall k, (k <= n)%nat -> exists X, forall t,
    before X t -> P k t) ->
  exists X, forall k t, (k <= n)%nat -> before X t -> P k t.
Proof.
intros Tr Up. induction n as [|n IH]; intros H.
- destruct (H 0%nat ltac:(lia)) as [X HX]. exists X. intros k t Hk Ht. replace k with 0%nat by lia. auto.
- destruct IH as [X HX]. { intros k Hk. apply H. lia. }
  destruct (H (S n) ltac:(lia)) as [Y HY]. destruct (Up X Y) as (Z & HXZ & HYZ). exists Z. intros k t Hk Ht.
  destruct (Nat.eq_dec k (S n)) as [->|E].
  + apply HY. exact (Tr _ _ _ HYZ Ht).
  + apply HX. lia. exact (Tr _ _ _ HXZ Ht).
Qed.

Theorem zeros_beyond T : exists l j, zeros_with_multiplicity f (fun t => T < t) l /\
  tail_variations T = (length l + 2 * j)%nat.
Proof.
destruct (far (fun k t => 0 < c * Derive_n f k t) Rle Rle_trans) with (n := N) as [X HX].
{ intros x y. exists (Rmax x y). split; [apply Rmax_l|apply Rmax_r]. }
{ intros k _. apply Hright. }
set (T' := Rmax T X). assert (M1 : T <= T') by apply Rmax_l. assert (M2 : X <= T') by apply Rmax_r.
destruct (between T T' M1) as (l & j & Z & V). exists l, j. split.
- destruct Z as (S & I & O). split; [auto|split]. { intros z Hz. apply I, Hz. }
  intros z Hz. destruct (Rle_lt_dec z T') as [L|L]. apply O; lra.
  rewrite (proj1 (count_occ_not_In Req_EM_T l z)) by (intros Hin; specialize (I z Hin); lra).
  split; [lia|]. assert (A := HX 0%nat z ltac:(lia) ltac:(lra)). intros E. rewrite E in A. lra.
- rewrite V. replace (tail_variations T') with 0%nat; auto. symmetry. apply variations_positive.
  intros x Hx. apply in_app_or in Hx. destruct Hx as [Hx|[<-|[]]]; [|lra].
  apply in_map_iff in Hx. destruct Hx as (k & <- & Hk). apply in_seq in Hk. apply HX; auto. lia.
Qed.

Theorem zeros_up_to T : exists l j, zeros_with_multiplicity f (fun t => t <= T) l /\
  N = (tail_variations T + length l + 2 * j)%nat.
Proof.
destruct (far (fun k t => 0 < (-1) ^ k * Derive_n f k t) Rge Rge_trans) with (n := N) as [X HX].
{ intros x y. exists (Rmin x y). split; apply Rle_ge; [apply Rmin_l|apply Rmin_r]. }
{ intros k Hk. destruct (Hleft k Hk) as [X HX]. exists X. intros t Ht. apply HX. lra. }
set (T0 := Rmin T X). assert (M1 : T0 <= T) by apply Rmin_l. assert (M2 : T0 <= X) by apply Rmin_r.
destruct (between T0 T M1) as (l & j & Z & V). exists l, j. split.
- destruct Z as (S & I & O). split; [auto|split]. { intros z Hz. apply I, Hz. }
  intros z Hz. destruct (Rle_lt_dec z T0) as [L|L]; [|apply O; lra].
  rewrite (proj1 (count_occ_not_In Req_EM_T l z)) by (intros Hin; specialize (I z Hin); lra).
  split; [lia|]. assert (A := HX 0%nat z ltac:(lia) ltac:(lra)). intros E. rewrite E in A. lra.
- rewrite <- V, <- tail_variations_from. unfold from.
  symmetry. apply (variations_alternating c). intros i Hi. assert (A := HX i T0 ltac:(lia) ltac:(lra)).
  assert (Hc : c <> 0) by (intros E; specialize (Htop T); rewrite E in Htop; lra).
  replace (c * ((-1) ^ i * (c * Derive_n f i T0))) with (c ^ 2 * ((-1) ^ i * Derive_n f i T0)) by ring.
  apply Rmult_lt_0_compat; auto. apply pow2_gt_0, Hc.
Qed.
End Tails.

(** ** A family F_b with F_b' = - b F_(b-1) and F_b(-x) ~ x^b *)
Section Left.
Variable F : R -> R -> R.
Hypothesis HD : forall b t, not_nat b -> is_derive (F b) t (- b * F (b - 1) t).
Hypothesis HL : forall b, not_nat b -> is_lim (fun x => F b (- x) / Rpower x b) p_infty 1.

Lemma family_derive_n n : forall b t, not_nat b -> Derive_n (F b) n t = rising (- b) n * F (b - INR n) t.
Proof.
induction n as [|n IH]; intros b t Hb.
- simpl. rewrite Rminus_0_r. ring.
- change (Derive (Derive_n (F b) n) t = rising (- b) n * (- b + INR n) * F (b - INR (S n)) t).
  rewrite (Derive_ext _ (fun t => rising (- b) n * F (b - INR n) t)) by (intros; apply IH; auto).
  rewrite Derive_scal, (is_derive_unique _ _ _ (HD (b - INR n) t (not_nat_sub b n Hb))).
  replace (b - INR (S n)) with (b - INR n - 1) by (rewrite S_INR; ring). ring.
Qed.

Lemma family_left b : not_nat b -> exists X, forall t, t <= X -> 0 < F b t.
Proof.
intros Hb. assert (H := HL b Hb). apply is_lim_spec in H. destruct (H (mkposreal (1 / 2) ltac:(lra))) as [M HM].
simpl in HM.
exists (- (M + 1)). intros t Ht. specialize (HM (- t) ltac:(lra)). rewrite Ropp_involutive in HM.
assert (HR : 0 < Rpower (- t) b) by apply exp_pos. apply Rabs_def2 in HM.
replace (F b t) with (F b t / Rpower (- t) b * Rpower (- t) b) by (field; lra).
apply Rmult_lt_0_compat; lra.
Qed.

Lemma rising_alternates b k : INR k < b + 1 -> 0 < (-1) ^ k * rising (- b) k.
Proof.
induction k as [|k IH]; intros Hk; [simpl; lra|]. rewrite S_INR in Hk. assert (A := IH ltac:(lra)).
replace ((-1) ^ S k * rising (- b) (S k)) with ((-1) ^ k * rising (- b) k * (b - INR k)) by (simpl; ring).
apply Rmult_lt_0_compat; lra.
Qed.

Lemma family_alternates b k : not_nat b -> INR k < b + 1 -> exists X, forall t, t <= X ->
  0 < (-1) ^ k * Derive_n (F b) k t.
Proof.
intros Hb Hk. destruct (family_left (b - INR k) (not_nat_sub b k Hb)) as [X HX]. exists X. intros t Ht.
rewrite family_derive_n by auto. rewrite <- Rmult_assoc. apply Rmult_lt_0_compat; auto. apply rising_alternates, Hk.
Qed.
End Left.

(** ** Theta, and the slow solution *)
Lemma cell_le (n : nat) b k : INR n < b < INR n + 1 -> (k <= S n)%nat -> INR k < b + 1.
Proof. intros Hb Hk. apply le_INR in Hk. rewrite S_INR in Hk. lra. Qed.

Lemma interval_not_nat (n : nat) b : INR n < b < INR n + 1 -> not_nat b.
Proof. intros Hb. apply (cell_not_nat (S n)). unfold cell. rewrite S_INR. lra. Qed.

Theorem tail_zeros (n : nat) b theta T : INR n < b < INR n + 1 -> is_Theta b theta ->
  let v := variations (map (fun k => Gamma (- b) * Derive_n theta k T) (seq 0 (S n)) ++ [1]) in
  (exists l j, zeros_with_multiplicity theta (fun t => T < t) l /\ v = (length l + 2 * j)%nat) /\
  (exists l j, zeros_with_multiplicity theta (fun t => t <= T) l /\ (n + 1 = v + length l + 2 * j)%nat).
Proof.
intros Hbn H v. rewrite Nat.add_1_r. assert (Hb := interval_not_nat n b Hbn).
assert (D : forall k t, ex_derive_n theta k t).
{ intros [|k] t; [exact I|]. exists (/ Gamma (- b) * scaled b theta (S k) t).
  apply (is_derive_ext (fun t => / Gamma (- b) * scaled b theta k t)).
  - intros u. change (/ Gamma (- b) * (Gamma (- b) * Derive_n theta k u) = Derive_n theta k u). field.
    apply not_nat_Gamma, Hb.
  - apply (is_derive_scal (scaled b theta k)), scaled_derive; auto. }
assert (Htop : forall t, 0 < Gamma (- b) * Derive_n theta (S n) t).
{ intros t. apply (Theta_sign b theta (S n) Hb); auto. rewrite S_INR. lra. }
split.
- apply (zeros_beyond theta (Gamma (- b)) (S n) D Htop).
  intros k. destruct (scaled_right b theta Hb H k 1) as [X HX]. exists X. intros t Ht. specialize (HX t Ht).
  unfold scaled in HX. lra.
- apply (zeros_up_to theta (Gamma (- b)) (S n) D Htop).
  intros k Hk. destruct (family_alternates Th) with (b := b) (k := k) as [X HX]; auto.
  + exact Th_derive.
  + intros a Ha. apply (Theta_asymptotics a (Th a) Ha), Th_correct.
  + apply (cell_le n); auto.
  + exists X. intros t Ht. rewrite (Derive_n_ext theta (Th b)) by (apply Th_is, H). auto.
Qed.

Theorem tail_few_zeros (n : nat) b theta T : INR n < b < INR n + 1 -> is_Theta b theta ->
  let v := variations (map (fun k => Gamma (- b) * Derive_n theta k T) (seq 0 (S n)) ++ [1]) in
  (v = 0%nat -> forall t, T < t -> theta t <> 0) /\
  (v = 1%nat -> exists z, T < z /\ theta z = 0 /\ Derive theta z <> 0 /\ forall t, T < t -> theta t = 0 -> t = z) /\
  forall zeros, StronglySorted Rlt zeros -> (forall t, In t zeros -> T < t /\ theta t = 0) -> (length zeros <= v)%nat.
Proof.
intros Hbn H v. destruct (tail_zeros n b theta T Hbn H) as ((l & j & Z & V) & _). fold v in V. split; [|split].
- intros E. destruct l as [|z l]; [|simpl in V; lia]. exact (no_zero _ _ Z).
- intros E. destruct l as [|z [|z' l]]; [simpl in V; lia| |simpl in V; lia]. exists z. exact (one_zero _ _ z Z).
- intros zeros S I. assert (L := distinct_zeros _ _ l zeros Z S I). lia.
Qed.

Theorem slow_tail_zeros e (n : nat) b F T : 0 < e -> INR n < b < INR n + 1 -> (forall t, F t = Fe e b t) ->
  let v := variations (map (fun k => Gamma (- b) * Derive_n F k T) (seq 0 (S n)) ++ [1]) in
  (exists l j, zeros_with_multiplicity F (fun t => T < t) l /\ v = (length l + 2 * j)%nat) /\
  (exists l j, zeros_with_multiplicity F (fun t => t <= T) l /\ (n + 1 = v + length l + 2 * j)%nat).
Proof.
intros He Hbn H v. rewrite Nat.add_1_r. assert (Hb := interval_not_nat n b Hbn).
assert (D : forall k t, ex_derive_n F k t).
{ intros k t. apply (ex_derive_n_ext (Fe e b)). intros u; symmetry; apply H. apply Fe_ex_derive_n; auto. }
assert (Htop : forall t, 0 < Gamma (- b) * Derive_n F (S n) t).
{ intros t. rewrite (Derive_n_ext F (Fe e b)) by exact H. apply Fe_sign; auto. rewrite S_INR. lra. }
split.
- apply (zeros_beyond F (Gamma (- b)) (S n) D Htop).
  intros k. destruct (Fe_right e He b k Hb 1) as (X & _ & HX). exists X. intros t Ht. specialize (HX t Ht).
  rewrite (Derive_n_ext F (Fe e b)) by exact H. lra.
- apply (zeros_up_to F (Gamma (- b)) (S n) D Htop).
  intros k Hk. destruct (family_alternates (Fe e)) with (b := b) (k := k) as [X HX]; auto.
  + intros a t Ha. apply Fe_derive; auto.
  + intros a Ha. apply Fe_asymptotics; auto.
  + apply (cell_le n); auto.
  + exists X. intros t Ht. rewrite (Derive_n_ext F (Fe e b)) by exact H. auto.
Qed.
