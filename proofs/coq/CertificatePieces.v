(** * What each piece of a certificate gives

    proofs/certificate.md, the table of pieces and the statements. From what is checked of a piece on a column follows,
    at each b of the column, the sign of Theta(., b) or the number of its zeros on the piece; the walk
    ([CertificateWalk.v]) puts them together. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate Calculus LaplaceIntegral WellPosed Family SignsAtZero
  IntegerPolynomials PolynomialSum Ends
  FoldAndHinge ZeroCurves EnvelopingLow CertificateWalk CertificateFamily.
Import ListNotations.
Open Scope R_scope.

(** ** Sequences of signs *)
Lemma changes_none l : forall s last, changes s (l ++ [Some last]) = Some 0%nat ->
  s = last /\ forall k, (k < length l)%nat -> nth k l None = Some last.
Proof.
induction l as [|[a|] l IH]; intros s last H.
- simpl in H. destruct (Bool.eqb s last) eqn:E; [|discriminate]. apply Bool.eqb_prop in E. split; auto. simpl; lia.
- cbn [app changes] in H. destruct (changes a (l ++ [Some last])) as [v|] eqn:E; [|discriminate].
  cbn [option_map] in H. destruct (Bool.eqb s a) eqn:Ea; [|discriminate]. apply Bool.eqb_prop in Ea. injection H as ->.
  destruct (IH a last E) as [-> H]. split; auto. intros [|k] Hk; simpl; auto. apply H. simpl in Hk. lia.
- exfalso. destruct l as [|[a|] l]; simpl in H.
  + destruct (Bool.eqb s last); discriminate.
  + destruct (Bool.eqb s a); [discriminate|]. destruct (changes a (l ++ [Some last])); discriminate.
  + discriminate.
Qed.

(** One change: the sign -last up to a place j, then last; at j the sign may be open. *)
Lemma changes_one l : forall s last, changes s (l ++ [Some last]) = Some 1%nat ->
  s = negb last /\ exists j, (j <= length l)%nat /\ (forall k, (k < j)%nat -> nth k l None = Some (negb last)) /\
    ((forall k, (j <= k < length l)%nat -> nth k l None = Some last) \/
     ((j < length l)%nat /\ nth j l None = None /\ forall k, (j < k < length l)%nat -> nth k l None = Some last)).
Proof.
induction l as [|[a|] l IH]; intros s last H.
- simpl in H. destruct (Bool.eqb s last) eqn:E; [discriminate|]. split.
  + destruct s, last; auto; discriminate.
  + exists 0%nat. simpl. repeat split; intros; try lia. left. intros; lia.
- cbn [app changes] in H. destruct (changes a (l ++ [Some last])) as [v|] eqn:E; [|discriminate].
  cbn [option_map] in H. destruct (Bool.eqb s a) eqn:Ea.
  + apply Bool.eqb_prop in Ea. subst a. injection H as ->. destruct (IH s last E) as (-> & j & Hj & A & B).
    split; auto. exists (S j). simpl. split; [lia|]. split.
    * intros [|k] Hk; simpl; auto. apply A. lia.
    * destruct B as [B|(B1 & B2 & B)]; [left|right].
      -- intros [|k] Hk; [lia|]. simpl. apply B. lia.
      -- split; [lia|]. split; auto. intros [|k] Hk; [lia|]. simpl. apply B. lia.
  + injection H as ->. destruct (changes_none l a last E) as [-> A]. split.
    * destruct s, last; auto; discriminate.
    * exists 0%nat. simpl. split; [lia|]. split; [intros; lia|]. left. intros [|k] Hk; simpl; auto. apply A. lia.
- destruct l as [|[a|] l].
  + simpl in H. destruct (Bool.eqb s last) eqn:E; [discriminate|]. split.
    * destruct s, last; auto; discriminate.
    * exists 0%nat. simpl. split; [lia|]. split; [intros; lia|]. right. split; [lia|]. split; auto. intros; lia.
  + cbn [app changes] in H. destruct (Bool.eqb s a) eqn:Ea; [discriminate|].
    destruct (changes a (l ++ [Some last])) as [v|] eqn:E; [|discriminate]. injection H as ->.
    destruct (changes_none l a last E) as [-> A]. split.
    * destruct s, last; auto; discriminate.
    * exists 0%nat. simpl. split; [lia|]. split; [intros; lia|]. right. split; [lia|]. split; auto.
      intros [|[|k]] Hk; [lia|auto|]. simpl. apply A. lia.
  + simpl in H. discriminate.
Qed.

(** ** A function whose derivatives all have one sign at T *)
Lemma derivatives_positive (g : nat -> R -> R) N T : (forall k t, (k < N)%nat -> is_derive (g k) t (g (S k) t)) ->
  (forall t, T <= t -> 0 < g N t) -> (forall k, (k < N)%nat -> 0 < g k T) -> forall t, T <= t -> 0 < g 0%nat t.
Proof.
intros D HN H.
assert (A : forall j k, (k + j = N)%nat -> forall t, T <= t -> 0 < g k t).
{ induction j as [|j IH]; intros k Hk t Ht.
  - replace k with N by lia. apply HN, Ht.
  - assert (H0 := H k ltac:(lia)). destruct (Rle_lt_or_eq_dec _ _ Ht) as [L|<-]; [|exact H0].
    destruct (mvt_open (g k) (g (S k)) T t L) as (c & Hc & E).
    + intros s _. apply D. lia.
    + assert (P := IH (S k) ltac:(lia) c ltac:(lra)).
      assert (0 < g (S k) c * (t - T)) by (apply Rmult_lt_0_compat; lra). lra. }
intros t Ht. apply (A N 0%nat); auto.
Qed.

(** ** A product of larger factors *)
Lemma product_bound (b : R) (h : nat -> R) n : (forall i, Rabs (b - INR i) <= h i) ->
  Rabs (rising (- b) n) <= fold_right Rmult 1 (map h (seq 0 n)).
Proof.
intros H.
assert (E : forall l x, fold_right Rmult x l = fold_right Rmult 1 l * x).
{ induction l as [|a l IH]; intros x; simpl; [ring|]. rewrite IH. ring. }
induction n as [|n IH].
- simpl. rewrite Rabs_R1. lra.
- rewrite seq_S, map_app, fold_right_app. simpl map. simpl fold_right at 2. rewrite Rmult_1_r, E.
  change (rising (- b) (S n)) with (rising (- b) n * (- b + INR n)). rewrite Rabs_mult.
  apply Rmult_le_compat; auto using Rabs_pos.
  replace (- b + INR n) with (- (b - INR n)) by ring. rewrite Rabs_Ropp. apply H.
Qed.

Section Pieces.
Variable F : R -> R -> R.
Hypothesis HF : theta_family F.
Variable c : column.
Hypothesis Hc : in_cell c.
Let m : nat := column_cell c.

(** Where b lies. *)
Lemma column_bounds b : in_column c b -> b <= INR m /\ (m = 0%nat \/ INR m - 1 <= b).
Proof.
intros [H1 H2]. destruct Hc as [C1 C2]. fold m in C1, C2. split; [lra|].
destruct C2 as [C|C]; auto. right. assert (A := Rbar_le_trans _ _ _ C H1). simpl in A. lra.
Qed.

Lemma column_cases b : in_column c b -> (1 <= m)%nat -> b = INR (m - 1) \/ cell m b \/ b = INR m.
Proof.
intros Hb Hm. destruct (column_bounds b Hb) as [A [B|B]]; [lia|].
destruct (Rle_lt_or_eq_dec _ _ A) as [A'|E]; auto. destruct (Rle_lt_or_eq_dec _ _ B) as [B'|E].
- right. left. split; auto.
- left. rewrite minus_INR by lia. simpl. lra.
Qed.

Lemma low_finite b x : in_column c b -> Rbar_le (Finite x) (column_low c) ->
  column_low c = Finite (real (column_low c)).
Proof. intros [H _] H0. destruct (column_low c); simpl in *; auto; contradiction. Qed.

(** ** [left] *)
Lemma left_gives X b t : piece_checked F c (left_piece X) -> in_column c b -> t <= X -> 0 < F b t.
Proof.
intros (_ & HX & Hlow & H) Hb Ht. fold m in H.
destruct (Nat.eq_dec m 0) as [Em|Em].
- apply family_positive; auto. destruct (column_bounds b Hb) as [A _]. rewrite Em in A. exact A.
- destruct (column_cases b Hb ltac:(lia)) as [E|[C|E]].
  + rewrite E, family_Pn by auto. apply Pn_left. lra.
  + assert (Hb' : INR (m - 1) < b < INR (m - 1) + 1) by (rewrite minus_INR by lia; destruct C; simpl; lra).
    assert (NB : not_nat b) by apply (cell_not_nat m b C).
    apply (EnvelopingLow.left_end_explicit (m - 1) b (F b) (- X) Hb' (family_theta F HF b NB)); [lra| |lra].
    eapply Rle_lt_trans; [|exact H]. apply product_bound. intros i.
    destruct Hb as [B1 B2]. rewrite (low_finite b 0 (conj B1 B2) Hlow) in B1. simpl in B1.
    set (x := real (column_low c)) in *. destruct (Rle_lt_dec 0 (b - INR i)) as [L|L].
    * eapply Rle_trans; [|apply Rmax_r]. rewrite !Rabs_pos_eq; lra.
    * eapply Rle_trans; [|apply Rmax_l]. rewrite !Rabs_left; lra.
  + rewrite E, family_Pn by auto. apply Pn_left. lra.
Qed.

(** ** [right] *)
Lemma right_first T v : piece_checked F c (right_piece T v) -> exists s signs, length signs = (m - 1)%nat /\
  (1 <= m)%nat /\ (v <= 1)%nat /\
  s = Nat.even (m + v) /\ changes s (signs ++ [Some (Nat.even m)]) = Some v /\
  forall k s' b, (k < m)%nat -> nth k (Some s :: signs) None = Some s' -> in_column c b ->
    0 < signed s' (Derive_n (F b) k T).
Proof.
intros (_ & Hm & Hv & s & signs & L & C & H0 & Hk). fold m in Hm, L, C. exists s, signs. repeat split; auto.
- destruct v as [|[|v]]; [| |lia].
  + rewrite Nat.add_0_r. apply (changes_none _ _ _ C).
  + rewrite (proj1 (changes_one _ _ _ C)), Nat.add_1_r, even_S. reflexivity.
- intros [|k] s' b Hkm E Hb; simpl in E.
  + injection E as <-. apply H0, Hb.
  + apply Hk; auto.
Qed.

Lemma right_none T b t : piece_checked F c (right_piece T 0) -> in_column c b -> T <= t ->
  0 < signed (Nat.even m) (F b t).
Proof.
intros H Hb Ht. destruct (right_first T 0 H) as (s & signs & L & Hm & _ & -> & C & Hs).
rewrite Nat.add_0_r in *. destruct (changes_none _ _ _ C) as [_ A].
assert (Sk : forall k, (k < m)%nat -> 0 < signed (Nat.even m) (Derive_n (F b) k T)).
{ intros k Hk. apply Hs; auto. destruct k as [|k]; simpl; auto. apply A. lia. }
destruct (column_cases b Hb Hm) as [E|[Cb|E]].
- exfalso. assert (B := Sk (m - 1)%nat ltac:(lia)). rewrite E, family_Derive_n_Pn, Pn_top in B by auto.
  replace m with (S (m - 1)) in B at 1 by lia.
  rewrite even_S, signed_negb, signed_even, <- Rmult_assoc, <- Rpow_mult_distr in B.
  replace (-1 * -1) with 1 in B by ring. rewrite pow1 in B. assert (P := INR_fact_lt_0 (m - 1)). lra.
- assert (Hb' : INR (m - 1) < b < INR (m - 1) + 1) by (rewrite minus_INR by lia; destruct Cb; simpl; lra).
  assert (NB : not_nat b) by apply (cell_not_nat m b Cb).
  assert (G := Ends.Gamma_sign (m - 1) b Hb'). replace (m - 1 + 1)%nat with m in G by lia. rewrite <- signed_even in G.
  assert (GG : forall x, 0 < Gamma (- b) * x <-> 0 < signed (Nat.even m) x).
  { intros x. destruct (Nat.even m); simpl in G |- *; split; intros P; nra. }
  apply GG. apply (Ends.tail_without_zero (m - 1) b (F b) T Hb' (family_theta F HF b NB)); auto.
  + intros k Hk. apply Rlt_le, GG, Sk. lia.
  + apply Rgt_not_eq, GG, (Sk 0%nat). lia.
- rewrite E in *. apply (derivatives_positive (fun k t => signed (Nat.even m) (Derive_n (F (INR m)) k t)) m T); auto.
  + intros k u Hk. apply (is_derive_ext (fun t => (-1) ^ m * Derive_n (Pn m) k t)).
    * intros x. rewrite family_Derive_n_Pn, signed_even; auto.
    * rewrite family_Derive_n_Pn, signed_even by auto. apply (is_derive_scal (Derive_n (Pn m) k)), Pn_Derive_n_derive.
      lia.
  + intros u _. rewrite family_Derive_n_Pn, Pn_top, signed_even, <- Rmult_assoc, <- Rpow_mult_distr by auto.
    replace (-1 * -1) with 1 by ring. rewrite pow1. assert (P := INR_fact_lt_0 m). lra.
Qed.

Lemma right_zeros T v b : piece_checked F c (right_piece T v) -> in_column c b -> cell m b ->
  exists l, length l = v /\ zeros_in (F b) (Derive (F b)) (between (right_piece T v)) l.
Proof.
intros H Hb Cb. destruct (right_first T v H) as (s & signs & L & Hm & Hv & Es & C & Hs).
destruct v as [|[|v]]; [| |lia].
- exists []. split; auto. apply zeros_in_none. intros t [Ht _]. simpl in Ht.
  apply (signed_ne0 (Nat.even m)), (right_none T); auto.
- assert (Hb' : INR (m - 1) < b < INR (m - 1) + 1) by (rewrite minus_INR by lia; destruct Cb; simpl; lra).
  assert (NB : not_nat b) by apply (cell_not_nat m b Cb).
  assert (G := Ends.Gamma_sign (m - 1) b Hb'). replace (m - 1 + 1)%nat with m in G by lia. rewrite <- signed_even in G.
  assert (GP : forall x, 0 < signed (Nat.even m) x -> 0 <= Gamma (- b) * x).
  { intros x. destruct (Nat.even m); simpl in G |- *; intros P; nra. }
  assert (GN : forall x, 0 < signed (negb (Nat.even m)) x -> Gamma (- b) * x < 0).
  { intros x. destruct (Nat.even m); simpl in G |- *; intros P; nra. }
  destruct (changes_one _ _ _ C) as (_ & j & Hj & A & B).
  assert (Hs0 : 0 < signed s (F b T)) by (apply (Hs 0%nat); auto; lia).
  assert (Hlow : forall k, (k <= j)%nat -> Gamma (- b) * Derive_n (F b) k T <= 0).
  { intros k Hk. apply Rlt_le, GN, Hs; auto; [lia|].
    destruct k as [|k]; simpl; [rewrite Es, Nat.add_1_r, even_S; reflexivity|apply A; lia]. }
  assert (Hhigh : forall k, (j < k < m)%nat -> nth k (Some s :: signs) None = Some (Nat.even m) ->
    0 <= Gamma (- b) * Derive_n (F b) k T).
  { intros k Hk E. apply GP, Hs; auto. lia. }
  assert (Hj' : exists i, (1 <= i <= m)%nat /\ (forall k, (k < i)%nat -> Gamma (- b) * Derive_n (F b) k T <= 0) /\
    forall k, (i <= k <= m - 1)%nat -> 0 <= Gamma (- b) * Derive_n (F b) k T).
  { destruct B as [B|(B1 & B2 & B)].
    - exists (S j). split; [lia|]. split; [intros; apply Hlow; lia|]. intros [|k] Hk; [lia|]. apply Hhigh; [lia|].
      simpl. apply B. lia.
    - destruct (Rle_lt_dec 0 (Gamma (- b) * Derive_n (F b) (S j) T)) as [P|P].
      + exists (S j). split; [lia|]. split; [intros; apply Hlow; lia|]. intros [|k] Hk; [lia|].
        destruct (Nat.eq_dec k j) as [->|Hne]; [exact P|]. apply Hhigh; [lia|]. simpl. apply B. lia.
      + exists (S (S j)). split; [lia|]. split.
        * intros k Hk. destruct (Nat.eq_dec k (S j)) as [->|Hne]; [lra|apply Hlow; lia].
        * intros [|k] Hk; [lia|]. apply Hhigh; [lia|]. simpl. apply B. lia. }
  destruct Hj' as (i & Hi & I1 & I2).
  destruct (Ends.tail_with_one_zero (m - 1) i b (F b) T Hb' (family_theta F HF b NB) ltac:(lia) I1 I2)
    as (z & Hz & Ez & Dz & Before & After).
  { change (Derive_n (F b) 0 T) with (F b T). apply Rlt_not_eq, GN. rewrite <- even_S, <- Nat.add_1_r, <- Es.
    exact Hs0. }
  exists [z]. split; auto. split; [repeat constructor|split].
  + intros t. unfold between. simpl. split.
    * intros [[Ht _] Et]. left. destruct (Rtotal_order t z) as [P|[P|P]]; auto; exfalso.
      -- assert (Q := Before t ltac:(lra)). rewrite Et in Q. lra.
      -- assert (Q := After t P). rewrite Et in Q. lra.
    * intros [<-|[]]. repeat split; auto. lra.
  + intros t [<-|[]]. exact Dz.
Qed.

(** ** [fold] *)
Lemma fold_point (n : nat) t1 t2 t : (n mod 3 = 2)%nat -> t1 < 0 < t2 ->
  (forall t, t1 <= t <= t2 -> 0 < Derive_n (F (INR n)) 2 t) ->
  t1 <= t <= t2 -> t <> 0 -> 0 < F (INR n) t.
Proof.
intros Hn H12 Hconvex Ht Hne. rewrite family_Pn by auto.
assert (Z := Pn_mult_0 n). rewrite Hn in Z. destruct Z as (Z0 & Z1 & _).
apply (convex_double_zero (Pn n) (Pn1 n) (Pn2 n) t1 t2 (Pn_derive' n) (Pn_chain1 n) H12); auto.
intros u Hu. rewrite <- Pn_Derive2, <- (family_Derive_n_Pn F HF). apply Hconvex, Hu.
Qed.

Lemma pred_mod_3 k : (k mod 3 = 0 -> 3 <= k -> (k - 1) mod 3 = 2)%nat.
Proof.
intros H Hk. assert (E := Nat.div_mod k 3 ltac:(lia)). rewrite H in E.
replace (k - 1)%nat with (2 + (k / 3 - 1) * 3)%nat by lia.
rewrite Nat.mod_add by lia. reflexivity.
Qed.

(** Above its number n a fold holds no zero. *)
Lemma fold_above_number t1 t2 b t : piece_checked F c (fold_piece t1 t2) -> fold_below c -> in_column c b ->
  INR m - 1 < b -> t1 <= t <= t2 ->
  0 < F b t.
Proof.
intros (_ & H12 & _ & He & Hconvex & boxes & Hcover & Hboxes) ((Hm & Hm3) & Hlow) Hb Hbm Ht. fold m in Hm, Hm3, Hlow.
assert (En : INR (m - 1) = INR m - 1) by (rewrite minus_INR by lia; reflexivity).
assert (B0 := proj1 (column_bounds b Hb)). destruct Hb as [B1 B2].
assert (Jn : forall b', INR m - 1 <= b' <= b -> in_column c b').
{ intros b' Hb'. split; [rewrite Hlow; simpl|]; lra. }
assert (G0 : 0 <= F (INR m - 1) t).
{ rewrite <- En. destruct (Req_dec t 0) as [->|Hne].
  - rewrite family_Pn by auto. apply Pn_0_ge.
  - apply Rlt_le, (fold_point (m - 1) t1 t2); auto using pred_mod_3. intros u Hu. rewrite En. apply Hconvex; auto.
    apply Jn. lra. }
apply (weighted_increase _ (fun (box : (R * R) * (R * R) * R) b => let '((s1, s2), (b1, b2), _) := box
  in s1 <= t <= s2 /\ b1 <= b <= b2)
  snd boxes (fun b => F b t) (fun b => Derive (fun b => F b t) b) (INR m - 1) b).
- intros [[[s1 s2] [x1 x2]] w] x y z Hx Hz Hy. lra.
- intros b' Hb'. apply Hcover; auto.
- intros b'. apply family_continuous, HF.
- intros b' Hb'. apply family_derive_in_b; auto. apply (cell_not_nat m). split; lra.
- intros b' box I Q Hb'. apply Hboxes; auto; [rewrite Hlow; simpl|]; lra.
- exact G0.
- lra.
Qed.

(** Below it there are two, both simple. *)
Lemma fold_two_zeros t1 t2 b : piece_checked F c (fold_piece t1 t2) -> fold_above c -> in_column c b -> cell m b ->
  exists l, length l = 2%nat /\ zeros_in (F b) (Derive (F b)) (between (fold_piece t1 t2)) l.
Proof.
intros (_ & H12 & _ & He & Hconvex & _) (Hm & _) Hb Cb. fold m in Hm.
assert (N0 : F b 0 < 0).
{ assert (P := sign_0 m b Cb). rewrite sg_mod, Hm in P. simpl in P.
  rewrite (family_Th F HF) by apply (cell_not_nat m b Cb). lra. }
destruct (convex_two_zeros (F b) (Derive (F b)) (Derive_n (F b) 2) t1 t2 (family_derive F HF b) (family_derive2 F HF b)
  H12
  (fun t Ht => Hconvex t b Ht Hb) N0 (proj1 (He b Hb)) (proj2 (He b Hb))) as (x & y & Hx & Hy & Ex & Ey & Dx & Dy &
    Hall).
exists [x; y]. split; auto. split; [|split].
- constructor; [repeat constructor|]. constructor; [lra|constructor].
- intros t. unfold between. simpl. split.
  + intros [Ht Et]. destruct (Hall t Ht Et) as [->| ->]; auto.
  + intros [<-|[<-|[]]]; repeat split; auto; lra.
- intros t [<-|[<-|[]]]; lra.
Qed.

(** ** What each piece says, for b in the open cell *)
Lemma zeros_of_sign p b s : (forall t, between p t -> 0 < signed s (F b t)) -> exists l, length l = 0%nat /\
  zeros_in (F b) (Derive (F b)) (between p) l.
Proof. intros H. exists []. split; auto. apply zeros_in_none. intros t Ht. apply (signed_ne0 s), H, Ht. Qed.

Lemma piece_says_checked p b : in_column c b -> (m = 0%nat \/ cell m b) -> piece_checked F c p ->
  piece_says (F b) (Derive (F b)) c p.
Proof.
intros Hb Cb Hp. split; [apply Hp|].
assert (Constant : forall s, piece_sign c p = Some s -> zeros_inside c p = 0%nat ->
  (forall t, between p t -> 0 < signed s (F b t)) ->
  exists s, piece_sign c p = Some s /\ (forall x, fst (piece_ends p) = Finite x -> 0 < signed s (F b x)) /\
    (forall x, snd (piece_ends p) = Finite x -> 0 < signed s (F b x)) /\
    exists l, length l = zeros_inside c p /\ zeros_in (F b) (Derive (F b)) (between p) l).
{ intros s Es Ez H. exists s. assert (Hlt := Rbar_lt_le _ _ (proj1 Hp)). split; [exact Es|]. split; [|split].
  - intros x Ex. apply H. split; rewrite Ex in *; [apply Rbar_le_refl|exact Hlt].
  - intros x Ex. apply H. split; rewrite Ex in *; [exact Hlt|apply Rbar_le_refl].
  - rewrite Ez. apply (zeros_of_sign p b s H). }
destruct p as [| |X|t1 t2 s|t1 t2 d|t1 t2|t1 t2|T v].
- apply (Constant true); auto. intros t _. apply family_positive; auto. destruct Hp as [_ Hp]. destruct Hb as [_ Hb].
  simpl in Hp. lra.
- apply (Constant true); auto. intros t _. apply family_positive; auto. destruct Hp as [_ Hp]. destruct Hb as [_ Hb].
  simpl in Hp. lra.
- apply (Constant true); auto. intros t [_ Ht]. apply (left_gives X); auto.
- apply (Constant s); auto. intros t Ht. apply Hp; auto.
- intros t Ht. apply Hp; auto.
- assert (P := Hp). destruct Hp as (Hlt & H12 & Hn & He & Hconvex & Hw).
  exists true. split; [reflexivity|]. split; [|split].
  + intros x E. injection E as <-. apply He, Hb.
  + intros x E. injection E as <-. apply He, Hb.
  + cbn [zeros_inside]. fold m. destruct Hn as [Hn|Hn].
    * assert (Em := proj1 (proj1 Hn)). fold m in Em. rewrite Em. simpl Nat.eqb.
      apply (zeros_of_sign (fold_piece t1 t2) b true). intros t Ht. simpl.
      apply (fold_above_number t1 t2); auto. destruct Cb as [Cb|Cb]; [destruct Hn as [[_ Hn] _]; fold m in Hn; lia|].
      apply Cb.
    * assert (Em := proj1 Hn). fold m in Em. rewrite Em. simpl Nat.eqb. apply fold_two_zeros; auto.
      destruct Cb as [Cb|Cb]; [rewrite Cb in Em; discriminate|exact Cb].
- exact I.
- destruct (right_first T v Hp) as (s & signs & L & Hm & Hv & Es & C & Hs).
  exists s. split; [cbn [piece_sign]; rewrite Es; reflexivity|]. split; [|split].
  + intros x E. injection E as <-. apply (Hs 0%nat); auto; lia.
  + intros x E. discriminate.
  + destruct Cb as [Cb|Cb]; [lia|]. apply right_zeros; auto.
Qed.

(** ** Signs *)
Lemma sign_on_piece tau beta s p b t : sign_column F tau beta s c -> In p (column_pieces c) -> between p t ->
  in_range tau t -> in_column c b ->
  in_range beta (b + 1) -> 0 < signed s (F b t).
Proof.
intros (_ & _ & H) Ip Ht Htau Hb Hbeta. destruct (H p Ip) as (Hp & Es & Hx). clear H.
destruct p as [| |X|t1 t2 s'|t1 t2 d|t1 t2|t1 t2|T v]; cbn [piece_sign] in Es; try (injection Es as Es).
- rewrite <- Es. simpl. apply family_positive; auto. destruct Hp as [_ Hp]. destruct Hb as [_ Hb]. simpl in Hp. lra.
- rewrite <- Es. simpl. apply family_positive; auto. destruct Hp as [_ Hp]. destruct Hb as [_ Hb]. simpl in Hp. lra.
- rewrite <- Es. simpl. apply (left_gives X); auto. apply Ht.
- rewrite <- Es. apply Hp; auto.
- discriminate.
- rewrite <- Es. simpl. destruct Hx as [(n & Hn & Hlow) Hzero].
  assert (Hp' := Hp). destruct Hp' as (Hlt & H12 & Hf & He & Hconvex & Hw).
  assert (T12 : t1 <= t <= t2) by (destruct Ht; auto).
  assert (Low := proj1 Hb). rewrite Hlow in Low. simpl in Low.
  assert (Cases : (fold_below c /\ INR m - 1 < b) \/ exists k : nat, (k mod 3 = 2)%nat /\ b = INR k).
  { destruct Hf as [Hf|Hf].
    - destruct (Rle_lt_dec b (INR m - 1)) as [L|L]; [right|left; auto].
      destruct Hf as [[Hm Hm3] El]. fold m in Hm, Hm3, El. rewrite El in Hlow. injection Hlow as Em.
      rewrite <- Em in Low.
      exists (m - 1)%nat. split; [apply pred_mod_3; auto|]. rewrite minus_INR by lia. simpl. lra.
    - right. destruct Hf as [Hm Hhigh]. fold m in Hm, Hhigh. exists m. split; auto.
      assert (B2 := proj2 Hb). rewrite Hhigh in B2.
      assert (Hnm : (m + 1 <= n)%nat).
      { destruct Hc as [_ [C|C]]; fold m in C; [rewrite C in Hm; discriminate|]. rewrite Hlow in C. simpl in C.
        apply INR_le in C.
        assert (n <> m) by (intros ->; rewrite Hm in Hn; discriminate). lia. }
      apply le_INR in Hnm. rewrite plus_INR in Hnm. simpl in Hnm. lra. }
  destruct Cases as [[Hf' L]|(k & Hk & Eb)].
  + apply (fold_above_number t1 t2); auto.
  + rewrite Eb in *. apply (fold_point k t1 t2); auto.
    intros ->. apply Hzero. split; auto. exists (S k). rewrite S_INR. split; [|split].
    * replace (S k) with (k + 1)%nat by lia. rewrite <- Nat.add_mod_idemp_l, Hk by lia. discriminate.
    * replace (INR k + 1 - 1) with (INR k) by ring. exact Hb.
    * exact Hbeta.
- destruct Hx as [_ Hzero]. destruct Hp as (Hlt & Hm & H0 & Hd). fold m in Hm, Es, Hd.
  set (s0 := negb (Nat.eqb (m mod 3) 2)) in *. rewrite <- Es.
  assert (Bb : INR m - 1 <= b <= INR m) by (destruct (column_bounds b Hb) as [A [B|B]]; [lia|lra]).
  destruct (family_sign_0 F HF m b Hm Bb) as [Z Zs]. fold s0 in Z, Zs.
  assert (T12 : t1 <= t <= t2) by (destruct Ht; auto). simpl in Hlt.
  destruct (Req_dec t 0) as [->|Hne].
  { apply Zs. intros n Eb. assert (Ln := Nat.mod_upper_bound n 3 ltac:(lia)).
    destruct (n mod 3)%nat as [|k] eqn:E; auto. exfalso. apply Hzero. split; auto. exists (S n). rewrite S_INR, <- Eb.
    split; [|split].
    - replace (S n) with (n + 1)%nat by lia. rewrite <- Nat.add_mod_idemp_l, E by lia.
      destruct k as [|[|k]]; [discriminate|discriminate|lia].
    - replace (b + 1 - 1) with b by ring. exact Hb.
    - exact Hbeta. }
  set (e := if s0 then 1 else -1).
  assert (Se : forall u, e * u = signed s0 u) by (intros u; unfold e; destruct s0; simpl; ring).
  destruct (FoldAndHinge.hinge (F b) e t1 t2 ltac:(destruct H0; lra) (fun u => ex_intro _ _ (family_derive F HF b u))
    ltac:(rewrite Se; exact Z)) as [Left Right].
  rewrite <- Se. destruct (Rle_dec 0 t1) as [L|L].
  + apply Right; [|lra]. intros u Hu. rewrite Se. apply Hd; auto. lra.
  + assert (t2 = 0) by (destruct H0; lra). apply Left; [|lra]. intros u Hu. rewrite Se, <- signed_negb. apply Hd; auto.
    lra.
- subst v. rewrite Nat.add_0_r in Es. rewrite <- Es. fold m. apply (right_none T); auto. apply Ht.
Qed.

(** ** The number of zeros *)
Lemma zeros_on_line count b : cover (map piece_ends (column_pieces c)) m_infty p_infty ->
  (forall p, In p (column_pieces c) -> piece_checked F c p) ->
  zeros_counted c None None (column_pieces c) = Some count -> in_column c b -> (m = 0%nat \/ cell m b) ->
  exists l, length l = count /\ zeros_in (F b) (Derive (F b)) (fun _ => True) l.
Proof.
intros Hcover Hp Hz Hb Cb.
destruct (walk_line (F b) (Derive (F b)) (family_derive F HF b) c (column_pieces c) count Hcover) as (l & Z & L); auto.
- intros p Ip. apply piece_says_checked; auto.
- exists l. auto.
Qed.

End Pieces.

(** ** The statements *)
Lemma in_range_closure r x : in_range r x -> Rbar_le (range_from r) x /\ Rbar_le x (range_to r).
Proof. intros [A B]. destruct (closed_from r), (closed_to r); auto using Rbar_lt_le. Qed.

Lemma column_of columns beta x : cover (map (fun c => (column_low c, Finite (column_high c))) columns) (range_from beta)
  (range_to beta) ->
  in_range beta x -> exists c, In c columns /\ in_column c (x - 1).
Proof.
intros H Hx. apply in_range_closure in Hx. destruct (cover_point _ _ _ x H (proj1 Hx) (proj2 Hx)) as (part & I & A & B).
apply in_map_iff in I. destruct I as (c & <- & I). exists c. split; auto. simpl in A, B.
unfold in_column. replace (x - 1 + 1) with x by ring. auto.
Qed.

Theorem sign_certificate F tau beta columns s : theta_family F ->
  cover (map (fun c => (column_low c, Finite (column_high c))) columns) (range_from beta) (range_to beta) ->
  ((forall x, in_range beta x -> 0 < x) /\ (forall c, In c columns -> sign_column F tau beta (negb s) c) \/
   (forall x, in_range beta x -> x < 0) /\ (forall c, In c columns -> sign_column F tau beta s c)) ->
  forall t b, in_range tau t -> in_range beta b -> 0 < signed s (Derive (F b) t).
Proof.
intros HF Hcover H t b Ht Hb. rewrite family_slope, signed_scal by auto.
destruct (column_of columns beta b Hcover Hb) as (c & Ic & Hc).
assert (S' : forall s', sign_column F tau beta s' c -> 0 < signed s' (F (b - 1) t)).
{ intros s' Hcol. assert (Hcol' := Hcol). destruct Hcol' as (C & Hp & _). apply in_range_closure in Ht as Ht'.
  destruct (cover_point _ _ _ t Hp (proj1 Ht') (proj2 Ht')) as (part & I & A).
  apply in_map_iff in I. destruct I as (p & <- & I).
  apply (sign_on_piece F HF c C tau beta s' p); auto. replace (b - 1 + 1) with b by ring. exact Hb. }
destruct H as [[Hpos H]|[Hneg H]].
- assert (A := S' _ (H c Ic)). rewrite signed_negb in A. specialize (Hpos b Hb).
  assert (0 < b * - signed s (F (b - 1) t)) by (apply Rmult_lt_0_compat; auto). lra.
- assert (A := S' _ (H c Ic)). specialize (Hneg b Hb). apply Rmult_lt_0_compat; lra.
Qed.

(** dTheta/dtau at beta and its slope are those of Theta(., beta - 1) up to the factor - beta. *)
Lemma zeros_of_slope F b l : theta_family F -> b <> 0 -> zeros_in (F (b - 1)) (Derive (F (b - 1))) (fun _ => True) l ->
  zeros_of (Derive (F b)) l /\ forall t, In t l -> Derive_n (F b) 2 t <> 0.
Proof.
intros HF Hb (S & Z & N). split; [split; auto|].
- intros t. rewrite family_slope, <- Z by auto. split.
  + intros E. split; auto. apply Rmult_integral in E. destruct E as [E|E]; auto. lra.
  + intros [_ ->]. ring.
- intros t Ht. rewrite family_second by auto. apply Rmult_integral_contrapositive_currified; [lra|auto].
Qed.

Lemma cell_of_column c (k : nat) b : in_cell c -> in_column c (b - 1) -> INR k < b < INR k + 1 ->
  k = column_cell c /\ (column_cell c = 0%nat \/ cell (column_cell c) (b - 1)).
Proof.
intros [C1 C2] [H1 H2] Hb. replace (b - 1 + 1) with b in * by ring.
assert (Hk : (k <= column_cell c)%nat).
{ apply Nat.lt_succ_r, INR_lt. rewrite S_INR. lra. }
assert (Hk' : (column_cell c <= k)%nat).
{ destruct C2 as [C2|C2]; [lia|]. assert (A := Rbar_le_trans _ _ _ C2 H1). simpl in A. apply Nat.lt_succ_r, INR_lt.
  rewrite S_INR. lra. }
assert (E : k = column_cell c) by lia. split; auto. right. rewrite <- E. split; lra.
Qed.

Theorem zeros_certificate F beta columns (count : nat -> nat) : theta_family F ->
  cover (map (fun c => (column_low c, Finite (column_high c))) columns) (range_from beta) (range_to beta) ->
  (forall c, In c columns -> zeros_column F (count (column_cell c)) c) ->
  forall (m : nat) b, in_range beta b -> INR m < b < INR m + 1 ->
    exists l, zeros_of (Derive (F b)) l /\ length l = count m /\ forall t, In t l -> Derive_n (F b) 2 t <> 0.
Proof.
intros HF Hcover H m b Hb Hm. destruct (column_of columns beta b Hcover Hb) as (c & Ic & Hc).
destruct (H c Ic) as (C & Hp & Hall & Hz). destruct (cell_of_column c m b C Hc Hm) as [Em Cb]. rewrite <- Em in Hz.
destruct (zeros_on_line F HF c C (count m) (b - 1) Hp Hall Hz Hc Cb) as (l & L & Z).
assert (Hb0 : b <> 0) by (generalize (pos_INR m); lra).
destruct (zeros_of_slope F b l HF Hb0 Z) as [A B]. exists l. auto.
Qed.

(** A continuous function with a change of sign in each of k disjoint brackets, and k zeros in all. *)
Lemma one_in_each (f f' : R -> R) (brackets : list (R * R)) l : (forall t, is_derive f t (f' t)) ->
  StronglySorted (fun one two => snd one <= fst two) brackets -> (forall lo hi, In (lo, hi) brackets -> lo < hi /\
    f lo * f hi < 0) ->
  StronglySorted Rlt l -> (forall t, f t = 0 -> In t l) -> length l = length brackets ->
  forall i, (i < length l)%nat -> fst (nth i brackets (0, 0)) < nth i l 0 < snd (nth i brackets (0, 0)).
Proof.
intros D Sb Hb Sl Hl L.
assert (Z : exists z, length z = length brackets /\ StronglySorted Rlt z /\ (forall t, In t z -> f t = 0) /\
  (forall t, In t z -> exists one, In one brackets /\ fst one < t) /\
  forall i, (i < length z)%nat -> fst (nth i brackets (0, 0)) < nth i z 0 < snd (nth i brackets (0, 0))).
{ clear L Hl. induction brackets as [|[lo hi] brackets IH].
  - exists []. repeat split; auto; [constructor|intros t []|intros t []|simpl in *; lia|simpl in *; lia].
  - inversion Sb as [|? ? Sb' Fb]; subst. destruct IH as (z & Lz & Sz & Ez & Bz & Iz); auto.
    { intros lo' hi' I. apply Hb. right. exact I. }
    destruct (Hb lo hi (or_introl eq_refl)) as [Hlt Hs].
    destruct (IVT_cor f lo hi (derive_continuity f f' D) ltac:(lra) ltac:(lra)) as (x & Hx & Ex).
    assert (X : lo < x < hi).
    { split; [destruct (Rle_lt_or_eq_dec _ _ (proj1 Hx)) as [P|P]|destruct (Rle_lt_or_eq_dec _ _ (proj2 Hx)) as [P|P]];
        auto; exfalso.
      - rewrite <- P in Ex. rewrite Ex in Hs. lra.
      - rewrite P in Ex. rewrite Ex in Hs. lra. }
    exists (x :: z). rewrite Forall_forall in Fb. repeat split.
    + simpl. congruence.
    + constructor; auto. apply Forall_forall. intros u Hu. destruct (Bz u Hu) as (one & I & P). specialize (Fb one I).
      simpl in Fb. lra.
    + intros t [<-|I]; auto.
    + intros t [<-|I].
      * exists (lo, hi). split; [left; reflexivity|simpl; lra].
      * destruct (Bz t I) as (one & J & P). exists one. split; [right|]; auto.
    + destruct i as [|i]; simpl; [lra|]. apply Iz. simpl in H. lia.
    + destruct i as [|i]; simpl; [lra|]. apply Iz. simpl in H. lia. }
destruct Z as (z & Lz & Sz & Ez & _ & Iz).
assert (E : z = l). { apply sorted_incl_eq; auto; [congruence|]. intros t I. apply Hl, Ez, I. }
rewrite <- E. exact Iz.
Qed.

Theorem brackets_certificate F b c (brackets : list (R * R)) : theta_family F -> 0 < b -> not_nat b ->
  in_column c (b - 1) -> zeros_column F (length brackets) c ->
  StronglySorted (fun one two => snd one <= fst two) brackets ->
  (forall lo hi, In (lo, hi) brackets -> lo < hi /\ F (b - 1) lo * F (b - 1) hi < 0) ->
  exists l, zeros_of (Derive (F b)) l /\ length l = length brackets /\ (forall t, In t l -> Derive_n (F b) 2 t <> 0) /\
    forall i, (i < length l)%nat -> fst (nth i brackets (0, 0)) < nth i l 0 < snd (nth i brackets (0, 0)).
Proof.
intros HF Hb Hn Hc (C & Hp & Hall & Hz) Hsort Hsigns.
destruct (nfloor_ex b (Rlt_le _ _ Hb)) as (k & Hk1 & Hk2).
assert (Hk : INR k < b < INR k + 1).
{ split; [|exact Hk2]. destruct (Rle_lt_or_eq_dec _ _ Hk1) as [L|E]; auto. exfalso. apply (Hn k). auto. }
destruct (cell_of_column c k b C Hc Hk) as [Em Cb].
destruct (zeros_on_line F HF c C (length brackets) (b - 1) Hp Hall Hz Hc Cb) as (l & L & Z).
destruct (zeros_of_slope F b l HF (Rgt_not_eq _ _ Hb) Z) as [A B].
assert (Each := one_in_each (F (b - 1)) (Derive (F (b - 1))) brackets l (family_derive F HF (b - 1)) Hsort Hsigns
  (proj1 Z)
  (fun t E => proj1 (proj1 (proj2 Z) t) (conj I E)) L).
exists l. auto.
Qed.
