(** * The compliant model: the number of zeros for 1 < beta < 4

    Theorem D of proofs/finite_epsilon_zeros.md, section 4 (a). F_b' = - b F_(b-1), F_b > 0 far to the left, Gamma(-b)
    F_b -> +oo to the right, and Gamma(-b) F_b(0) < 0 ([CompliantPower.v]). So the zeros of F_b follow from those of
    F_(b-1): b in (0, 1): F_b decreases, one zero; (1, 2): it decreases and then increases, one zero on each side of 0;
    (2, 3): it is positive left of 0 and up to the second zero of F_(b-1), decreases after it, one zero. For b in (3, 4)
    it decreases up to the zero of F_(b-1) and increases from there. The force of a slow motion less its mean is a
    multiple of F_(beta-1). *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family Ends SignPattern
  CompliantKernel
  CompliantIntegral CompliantSlow CompliantMechanism CompliantSlowMotion CompliantPower.
Import ListNotations.
Open Scope R_scope.

(** ** One crossing on a half-line, two around a minimum *)
Section Crossing.
Variables (h h' : R -> R).
Hypothesis D : forall t, is_derive h t (h' t).

Lemma falls s u v : u < v -> (forall t, u < t < v -> s * h' t < 0) -> s * h v < s * h u.
Proof.
intros Huv H. destruct (mvt_open h h' u v Huv (fun t _ => D t)) as (c & Hc & E). specialize (H c Hc).
assert (0 < - (s * h' c) * (v - u)) by (apply Rmult_lt_0_compat; lra).
assert (s * (h v - h u) = s * h' c * (v - u)) by (rewrite E; ring). lra.
Qed.

Lemma cross_right s c : (forall t, c < t -> s * h' t < 0) -> 0 < s * h c -> (exists T, c < T /\ s * h T < 0) ->
  exists z, c < z /\ h z = 0 /\ (forall t, c <= t < z -> 0 < s * h t) /\ (forall t, z < t -> s * h t < 0).
Proof.
intros H Hc (T & HT & HhT).
destruct (cross h h' s c T D HT (fun t Ht => H t (proj1 Ht)) Hc HhT) as (z & Hz & E & P & N).
exists z. refine (conj (proj1 Hz) (conj E (conj P _))). intros t Ht.
destruct (Rle_lt_dec t T) as [Hl|Hl]; [apply N; lra|].
assert (F := falls s T t Hl (fun u Hu => H u ltac:(lra))). lra.
Qed.

Lemma cross_left s c : (forall t, t < c -> s * h' t < 0) -> s * h c < 0 -> (exists T, T < c /\ 0 < s * h T) ->
  exists z, z < c /\ h z = 0 /\ (forall t, t < z -> 0 < s * h t) /\ (forall t, z < t <= c -> s * h t < 0).
Proof.
intros H Hc (T & HT & HhT).
destruct (cross h h' s T c D HT (fun t Ht => H t (proj2 Ht)) HhT Hc) as (z & Hz & E & P & N).
exists z. refine (conj (proj2 Hz) (conj E (conj _ N))). intros t Ht.
destruct (Rle_lt_dec T t) as [Hl|Hl]; [apply P; lra|].
assert (F := falls s t T Hl (fun u Hu => H u ltac:(lra))). lra.
Qed.

(** A valley: h falls to m and rises from there, and is positive far out on both sides. *)
Definition valley (m : R) : Prop := (forall t, t < m -> h' t < 0) /\ (forall t, m < t -> 0 < h' t) /\
  (exists T, T < m /\ 0 < h T) /\ (exists T, m < T /\ 0 < h T).

Lemma valley_least m t : valley m -> t <> m -> h m < h t.
Proof.
intros (L & U & _) Ht. destruct (Rdichotomy _ _ Ht) as [H|H].
- assert (F := falls 1 t m H (fun u Hu => ltac:(specialize (L u (proj2 Hu)); lra))). lra.
- assert (F := falls (-1) m t H (fun u Hu => ltac:(specialize (U u (proj1 Hu)); lra))). lra.
Qed.

Lemma valley_zeros m : valley m -> h m < 0 -> exists x x', x < m < x' /\ line_pattern h h' 1 [x; x'].
Proof.
intros (L & U & (T & HT & PT) & (T' & HT' & PT')) Hm.
destruct (cross_left 1 m) as (x & Hx & Ex & Px & Nx); try lra.
{ intros t Ht. specialize (L t Ht). lra. } { exists T. lra. }
destruct (cross_right (-1) m) as (x' & Hx' & Ex' & Px' & Nx'); try lra.
{ intros t Ht. specialize (U t Ht). lra. } { exists T'. lra. }
exists x, x'. split; [lra|]. specialize (L x Hx) as Lx. specialize (U x' Hx') as Ux.
cbn [line_pattern pattern]. refine (conj Px (conj Ex (conj _ (conj _ (conj _ (conj Ex' (conj _ _))))))); try lra.
- intros t Ht. destruct (Rle_lt_dec t m) as [H|H].
  + specialize (Nx t ltac:(lra)). lra.
  + specialize (Px' t ltac:(lra)). lra.
- intros t Ht. specialize (Nx' t Ht). lra.
Qed.
End Crossing.

(** ** The slow solution *)
Section Slow.
Variable e : R.
Hypothesis He : 0 < e.

Lemma slow_left_end b : not_nat b -> forall m, exists T, T < m /\ 0 < Fe e b T.
Proof.
intros Hb m. assert (L := Fe_asymptotics e He b Hb). apply is_lim_spec in L.
destruct (L (mkposreal 1 Rlt_0_1)) as [M HM]. simpl in HM.
set (x := Rmax (M + 1) (1 - m)). assert (X1 : M + 1 <= x) by apply Rmax_l. assert (X2 : 1 - m <= x) by apply Rmax_r.
exists (- x). split; [lra|]. specialize (HM x ltac:(lra)). apply Rabs_def2 in HM.
set (P := Rpower x b) in *. assert (HP : 0 < P) by apply exp_pos.
replace (Fe e b (- x)) with (Fe e b (- x) / P * P) by (field; lra). apply Rmult_lt_0_compat; lra.
Qed.

Lemma slow_right_end b : not_nat b -> forall m, exists T, m < T /\ 0 < Gamma (- b) * Fe e b T.
Proof.
intros Hb m. destruct (Fe_right e He b 0 Hb 1) as (T & _ & HT). exists (Rmax T (m + 1)).
assert (X1 := Rmax_l T (m + 1)). assert (X2 := Rmax_r T (m + 1)). split; [lra|].
specialize (HT _ X1). simpl in HT. lra.
Qed.

Definition slope (b t : R) : R := - b * Fe e (b - 1) t.

Lemma slow_derive b t : not_nat b -> is_derive (Fe e b) t (slope b t).
Proof. intros Hb. apply Fe_derive; auto. Qed.

Lemma slope_sign b t s : 0 < b -> 0 < s * Fe e (b - 1) t -> s * slope b t < 0.
Proof. intros Hb H. unfold slope. assert (0 < b * (s * Fe e (b - 1) t)) by (apply Rmult_lt_0_compat; auto). lra. Qed.

(** Signs of Gamma(-b) on the first four cells. *)
Lemma Gamma_cell (m : nat) b : INR m < b < INR m + 1 -> not_nat b /\ 0 < (-1) ^ (m + 1) * Gamma (- b).
Proof.
intros H. split; [|apply Gamma_sign, H]. apply (cell_not_nat (S m)). unfold cell. rewrite S_INR. lra.
Qed.

Theorem zeros_0 b : 0 < b < 1 -> exists z, 0 < z /\ line_pattern (Fe e b) (slope b) 1 [z].
Proof.
intros H. destruct (Gamma_cell 0 b ltac:(simpl; lra)) as [Hb HG]. simpl in HG.
assert (Down : forall t, 1 * slope b t < 0).
{ intros t. apply slope_sign; [lra|]. assert (P := Fe_sign e He (b - 1) 0 (not_nat_pred b Hb) ltac:(simpl; lra) t).
  simpl in P.
  assert (0 < Gamma (- (b - 1))) by (apply Gamma_pos; lra). rewrite Rmult_1_l.
  apply (pos_of_prod_pos (Gamma (- (b - 1)))); auto. }
assert (P0 : 0 < 1 * Fe e b 0) by (assert (A := slow_at_0 e He b Hb ltac:(lra)); nra).
destruct (cross_right (Fe e b) (slope b) (fun t => slow_derive b t Hb) 1 0 (fun t _ => Down t) P0)
  as (z & Hz & E & P & N).
{ destruct (slow_right_end b Hb 0) as (T & HT & G). exists T. split; [auto|nra]. }
exists z. split; auto. cbn [line_pattern pattern]. refine (conj _ (conj E (conj (Down z) _))).
- intros t Ht. destruct (Rle_lt_dec 0 t) as [L|L]; [apply P; lra|].
  assert (F := falls (Fe e b) (slope b) (fun t => slow_derive b t Hb) 1 t 0 L (fun u _ => Down u)). lra.
- intros t Ht. specialize (N t Ht). lra.
Qed.

Theorem zeros_1 b : 1 < b < 2 -> exists x x', x < 0 < x' /\ line_pattern (Fe e b) (slope b) 1 [x; x'].
Proof.
intros H. destruct (Gamma_cell 1 b ltac:(simpl; lra)) as [Hb HG]. simpl in HG.
destruct (zeros_0 (b - 1) ltac:(lra)) as (m & Hm & Pm). cbn [line_pattern pattern] in Pm.
destruct Pm as (Lm & Em & Sm & Um).
assert (V : valley (Fe e b) (slope b) m).
{ refine (conj _ (conj _ (conj (slow_left_end b Hb m) _))).
  - intros t Ht. rewrite <- (Rmult_1_l (slope b t)). apply slope_sign; [lra|auto].
  - intros t Ht. enough (-1 * slope b t < 0) by lra. apply slope_sign; [lra|]. specialize (Um t Ht). lra.
  - destruct (slow_right_end b Hb m) as (T & HT & G). exists T. split; [auto|nra]. }
assert (N0 : Fe e b 0 < 0) by (assert (A := slow_at_0 e He b Hb ltac:(lra)); nra).
assert (Nm := valley_least (Fe e b) (slope b) (fun t => slow_derive b t Hb) m 0 V ltac:(lra)).
destruct (valley_zeros (Fe e b) (slope b) (fun t => slow_derive b t Hb) m V ltac:(lra)) as (x & x' & Hx & Px).
exists x, x'. split; auto. split; [|lra].
apply Rnot_le_lt. intros Hx0. cbn [line_pattern] in Px. destruct Px as (Px & Ex & _).
destruct Hx0 as [Hx0|Hx0]; [specialize (Px 0 Hx0)|rewrite <- Hx0 in Ex]; lra.
Qed.

Theorem zeros_2 b : 2 < b < 3 -> exists z, 0 < z /\ line_pattern (Fe e b) (slope b) 1 [z].
Proof.
intros H. destruct (Gamma_cell 2 b ltac:(simpl; lra)) as [Hb HG]. simpl in HG.
destruct (zeros_1 (b - 1) ltac:(lra)) as (x & x' & Hx & Px). cbn [line_pattern pattern] in Px.
destruct Px as (_ & _ & _ & _ & Mid & _ & _ & Far).
assert (D := fun t => slow_derive b t Hb).
assert (Left : forall t, t <= 0 -> 0 < 1 * Fe e b t).
{ intros t [Ht| ->].
  - assert (B := slow_below_power e He b (- t) Hb ltac:(lra) ltac:(lra)). rewrite Ropp_involutive in B.
    assert (P : 0 < Rpower (- t) b) by apply exp_pos. nra.
  - assert (A := slow_at_0 e He b Hb ltac:(lra)). nra. }
assert (Up : forall t, 0 < t <= x' -> 0 < 1 * Fe e b t).
{ intros t Ht. assert (F := falls (Fe e b) (slope b) D (-1) 0 t (proj1 Ht)). specialize (Left 0 ltac:(lra)).
  enough (-1 * Fe e b t < -1 * Fe e b 0) by lra. apply F. intros u Hu. apply slope_sign; [lra|].
  specialize (Mid u ltac:(lra)). lra. }
destruct (cross_right (Fe e b) (slope b) D 1 x') as (z & Hz & E & P & N).
{ intros t Ht. apply slope_sign; [lra|]. specialize (Far t Ht). lra. }
{ apply Up. lra. }
{ destruct (slow_right_end b Hb x') as (T & HT & G). exists T. split; [auto|nra]. }
exists z. split; [lra|]. cbn [line_pattern pattern]. refine (conj _ (conj E (conj _ _))).
- intros t Ht. destruct (Rle_lt_dec t 0) as [L|L]; [apply Left, L|].
  destruct (Rle_lt_dec t x') as [L'|L']; [apply Up; lra|apply P; lra].
- apply slope_sign; [lra|]. specialize (Far z Hz). lra.
- intros t Ht. specialize (N t Ht). lra.
Qed.

Theorem valley_3 b : 3 < b < 4 -> exists m, 0 < m /\ valley (Fe e b) (slope b) m.
Proof.
intros H. destruct (Gamma_cell 3 b ltac:(simpl; lra)) as [Hb HG]. simpl in HG.
destruct (zeros_2 (b - 1) ltac:(lra)) as (m & Hm & Pm). cbn [line_pattern pattern] in Pm.
destruct Pm as (Lm & Em & Sm & Um).
exists m. split; auto. refine (conj _ (conj _ (conj (slow_left_end b Hb m) _))).
- intros t Ht. rewrite <- (Rmult_1_l (slope b t)). apply slope_sign; [lra|auto].
- intros t Ht. enough (-1 * slope b t < 0) by lra. apply slope_sign; [lra|]. specialize (Um t Ht). lra.
- destruct (slow_right_end b Hb m) as (T & HT & G). exists T. split; [auto|nra].
Qed.
End Slow.

(** ** The zeros as a list; of the force *)
Lemma pattern_simple (f f' : R -> R) s l : (forall t, is_derive f t (f' t)) -> line_pattern f f' s l ->
  simple_zeros f l.
Proof.
intros D P. split; [split|].
- exact (line_pattern_sorted f f' s l P).
- exact (line_pattern_zeros f f' s l P).
- intros t Ht. destruct (In_nth l t 0 Ht) as (i & Hi & <-). assert (N := line_pattern_simple f f' s l P i Hi).
  rewrite (is_derive_unique _ _ _ (D (nth i l 0))). intros E. rewrite E, Rmult_0_r in N. lra.
Qed.

(** 3 < b < 4: a negative value is enough for two zeros. *)
Theorem two_zeros_if_negative e b T : 0 < e -> 3 < b < 4 -> Fe e b T < 0 -> exists s t, s < t /\
  simple_zeros (Fe e b) [s; t].
Proof.
intros He H HT. destruct (valley_3 e He b H) as (m & _ & V). assert (Hb := proj1 (Gamma_cell 3 b ltac:(simpl; lra))).
assert (D := fun t => slow_derive e He b t Hb).
assert (Hm : Fe e b m < 0).
{ destruct (Req_dec T m) as [<-|Hne]; auto. assert (L := valley_least _ _ D m T V Hne). lra. }
destruct (valley_zeros _ _ D m V Hm) as (s & t & Hst & P). exists s, t. split; [lra|].
exact (pattern_simple _ _ _ _ D P).
Qed.

(** A multiple of f in another unit of time. *)
Lemma simple_zeros_scale (f g : R -> R) c eps l : c <> 0 -> 0 < eps -> (forall t, ex_derive f t) ->
  (forall t, g t = c * f (t / eps)) ->
  simple_zeros f l -> simple_zeros g (map (Rmult eps) l).
Proof.
intros Hc He D E ((S & Z) & N). split; [split|].
- clear Z N. induction S as [|a l S IH H]; [constructor|]. simpl. constructor; auto. apply Forall_map.
  eapply Forall_impl; [|exact H]. intros x Hx. apply Rmult_lt_compat_l; auto.
- intros t. rewrite E, in_map_iff. split.
  + intros H. exists (t / eps). split; [field; lra|]. apply Z. apply Rmult_integral in H. tauto.
  + intros (x & <- & Hx). replace (eps * x / eps) with x by (field; lra). apply Z in Hx. rewrite Hx. ring.
- intros t Ht. apply in_map_iff in Ht. destruct Ht as (x & <- & Hx).
  rewrite (Derive_ext g (fun t => c * f (t / eps))) by exact E. rewrite Derive_scal.
  assert (H : is_derive (fun t => f (t / eps)) (eps * x) (/ eps * Derive f x)).
  { apply (is_derive_comp f (fun t => t / eps) (eps * x) (Derive f x) (/ eps)).
    - replace (eps * x / eps) with x by (field; lra). apply Derive_correct, D.
    - auto_derive; auto. field. lra. }
  replace (Derive (fun t => f (t / eps)) (eps * x)) with (/ eps * Derive f x) by (symmetry; apply is_derive_unique, H).
  apply Rmult_integral_contrapositive_currified; auto.
  apply Rmult_integral_contrapositive_currified; auto. apply Rinv_neq_0_compat. lra.
Qed.

Section Force.
Variables (a1 a2 a3 eps C : R) (P B Y V Z : R -> R).
Hypothesis Hpar : parameters a1 a3 eps.
Hypothesis HS : slow_motion a1 a2 a3 eps C P B Y V Z.
Hypothesis HC : C <> 0.

Lemma force_is_multiple : exists c, c <> 0 /\
  forall t, linear_force eps (Y t) (Z t) - a2 / (a3 - a1) = c * Fe (- a1 * eps) (a3 / a1 - 1) (t / eps).
Proof.
destruct Hpar as (H1 & H3 & He & Hb). exists (C * (a3 / a1) / (a3 * eps)). split.
- assert (a3 / a1 <> 0) by (apply not_nat_neq0, Hb). apply Rmult_integral_contrapositive_currified.
  + apply Rmult_integral_contrapositive_currified; auto.
  + apply Rinv_neq_0_compat, Rmult_integral_contrapositive_currified; lra.
- intros t. rewrite (slow_force a1 a2 a3 eps Hpar C P B Y V Z HS t). unfold sol_l.
  rewrite (is_derive_unique _ _ _ (Fe_derive (- a1 * eps) ltac:(nra) (a3 / a1) (t / eps) Hb)).
  set (mean := a2 / (a3 - a1)). field. repeat split; lra.
Qed.

Lemma force_zeros_from (l : list R) : simple_zeros (Fe (- a1 * eps) (a3 / a1 - 1)) l ->
  simple_zeros (fun t => linear_force eps (Y t) (Z t) - a2 / (a3 - a1)) (map (Rmult eps) l).
Proof.
destruct force_is_multiple as (c & Hc & E). destruct Hpar as (H1 & H3 & He & Hb). intros Z0.
apply (simple_zeros_scale (Fe (- a1 * eps) (a3 / a1 - 1)) _ c); auto.
intros t. eexists. apply Fe_derive. nra. apply not_nat_pred, Hb.
Qed.

Theorem force_law : let deviation t := linear_force eps (Y t) (Z t) - a2 / (a3 - a1) in
  (1 < a3 / a1 < 2 -> exists t, 0 < t /\ simple_zeros deviation [t]) /\
  (2 < a3 / a1 < 3 -> exists s t, s < 0 < t /\ simple_zeros deviation [s; t]) /\
  (3 < a3 / a1 < 4 -> exists t, 0 < t /\ simple_zeros deviation [t]).
Proof.
intros deviation. assert (Hpar' := Hpar). destruct Hpar' as (H1 & H3 & He & Hb). assert (He' : 0 < - a1 * eps) by nra.
assert (D : forall t, is_derive (Fe (- a1 * eps) (a3 / a1 - 1)) t (slope (- a1 * eps) (a3 / a1 - 1) t)).
{ intros t. apply slow_derive; auto. apply not_nat_pred, Hb. }
refine (conj _ (conj _ _)); intros H.
- destruct (zeros_0 _ He' (a3 / a1 - 1) ltac:(lra)) as (t & Ht & Hl). exists (eps * t).
  split; [apply Rmult_lt_0_compat; auto|]. exact (force_zeros_from [t] (pattern_simple _ _ _ _ D Hl)).
- destruct (zeros_1 _ He' (a3 / a1 - 1) ltac:(lra)) as (s & t & Ht & Hl). exists (eps * s), (eps * t).
  split; [nra|]. exact (force_zeros_from [s; t] (pattern_simple _ _ _ _ D Hl)).
- destruct (zeros_2 _ He' (a3 / a1 - 1) ltac:(lra)) as (t & Ht & Hl). exists (eps * t).
  split; [apply Rmult_lt_0_compat; auto|]. exact (force_zeros_from [t] (pattern_simple _ _ _ _ D Hl)).
Qed.
End Force.
