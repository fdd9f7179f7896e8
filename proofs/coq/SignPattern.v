(** * Sign patterns of a function with simple zeros

    [pattern f f' s a l]: on (a, oo) the zeros of f are exactly the members of l, in increasing order; f has the sign s
    before the first, changes sign at each, and f' is not 0 there. [line_pattern] is the same on the whole line.
    [step_tail] and [step_head] carry a pattern of g over to h, h' = -b g, when h has the sign of g' at the positive
    zeros of g and h, g have opposite signs near +oo: one zero of h after each zero of g, and one before the first zero
    of g or none (section 3 of proofs/proofs/count_law.md). *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus.
Import ListNotations.
Open Scope R_scope.

(** ** Sign patterns.  [pattern f f' s a l]: on (a, oo) the zeros of f are exactly the members of l,
    in increasing order; f has the sign s before the first, changes sign at each, and f' <> 0 there. *)
Fixpoint pattern (f f' : R -> R) (s a : R) (l : list R) : Prop :=
  match l with
  | [] => forall t, a < t -> 0 < s * f t
  | c :: l' => a < c /\ (forall t, a < t < c -> 0 < s * f t) /\ f c = 0 /\ s * f' c < 0
               /\ pattern f f' (- s) c l'
  end.

Lemma pattern_glue f f' s a c l :
  a < c -> (forall t, a < t <= c -> 0 < s * f t) -> pattern f f' s c l -> pattern f f' s a l.
Proof.
intros Hac Hs. destruct l as [|z l]; simpl.
- intros H t Ht. destruct (Rle_lt_dec t c) as [H1|H1]; [apply Hs|apply H]; lra.
- intros (H1 & H2 & H3). refine (conj _ (conj _ H3)). lra.
  intros t Ht. destruct (Rle_lt_dec t c) as [H4|H4]; [apply Hs|apply H2]; lra.
Qed.

Lemma pattern_scal f f' F F' k s : k < 0 -> (forall t, F t = k * f t) -> (forall t, F' t = k * f' t) ->
  forall l a, pattern f f' s a l -> pattern F F' (- s) a l.
Proof.
intros Hk E E' l. revert s. induction l as [|c l IH]; intros s a; simpl.
- intros H t Ht. rewrite E. replace (- s * (k * f t)) with (- k * (s * f t)) by ring.
  apply Rmult_lt_0_compat; [lra|auto].
- intros (H1 & H2 & H3 & H4 & H5).
  refine (conj H1 (conj _ (conj _ (conj _ _)))).
  + intros t Ht. rewrite E. replace (- s * (k * f t)) with (- k * (s * f t)) by ring.
    apply Rmult_lt_0_compat; [lra|auto].
  + rewrite E, H3. ring.
  + rewrite E'. assert (0 < (- k) * (- (s * f' c))) by (apply Rmult_lt_0_compat; lra). lra.
  + apply IH, H5.
Qed.

Lemma pattern_ext f f' F F' s l a : (forall t, F t = f t) -> (forall t, F' t = f' t) ->
  pattern f f' s a l -> pattern F F' s a l.
Proof.
intros E E'. revert s a. induction l as [|c l IH]; intros s a; simpl.
- intros H t Ht. rewrite E; auto.
- intros (H1 & H2 & H3 & H4 & H5). rewrite E, E'.
  refine (conj H1 (conj _ (conj H3 (conj H4 _)))); auto.
  intros t Ht; rewrite E; auto.
Qed.

Lemma pattern_lt f f' l : forall s a, pattern f f' s a l -> forall c, In c l -> a < c.
Proof.
induction l as [|z l IH]; intros s a; simpl. tauto.
intros (H1 & _ & _ & _ & H5) c [<-|Hc]; auto.
apply Rlt_trans with z; auto. apply (IH _ _ H5 c Hc).
Qed.

Lemma pattern_sorted f f' l : forall s a, pattern f f' s a l -> StronglySorted Rlt l.
Proof.
induction l as [|z l IH]; intros s a; simpl. constructor.
intros (H1 & _ & _ & _ & H5). constructor.
- apply (IH _ _ H5).
- apply Forall_forall. intros x Hx. apply (pattern_lt _ _ _ _ _ H5 x Hx).
Qed.

Lemma pattern_zeros f f' l : forall s a, pattern f f' s a l ->
  forall t, a < t -> (f t = 0 <-> In t l).
Proof.
induction l as [|z l IH]; intros s a; simpl.
- intros H t Ht. split; [|tauto]. intros E. specialize (H t Ht). rewrite E in H. lra.
- intros (H1 & H2 & H3 & H4 & H5) t Ht.
  destruct (Rtotal_order t z) as [Hz|[Hz|Hz]].
  + specialize (H2 t ltac:(lra)). split.
    * intros E. rewrite E in H2. lra.
    * intros [E|E]; [lra|]. assert (Hl := pattern_lt _ _ _ _ _ H5 t E). lra.
  + subst t. tauto.
  + rewrite (IH _ _ H5 t Hz). split; [tauto|]. intros [E|E]; [lra|auto].
Qed.

Lemma pattern_simple f f' l : forall s a, pattern f f' s a l ->
  forall i, (i < length l)%nat -> s * (-1) ^ i * f' (nth i l 0) < 0.
Proof.
induction l as [|z l IH]; intros s a; simpl.
- intros _ i Hi; lia.
- intros (_ & _ & _ & H4 & H5) i Hi.
  destruct i as [|i]; simpl. lra.
  assert (H := IH _ _ H5 i ltac:(lia)). lra.
Qed.

(** ** One crossing of a monotone function *)
Lemma cross (h h' : R -> R) (s c T : R) :
  (forall t, is_derive h t (h' t)) -> c < T -> (forall t, c < t < T -> s * h' t < 0) ->
  0 < s * h c -> s * h T < 0 ->
  exists z, c < z < T /\ h z = 0 /\ (forall t, c <= t < z -> 0 < s * h t)
            /\ (forall t, z < t <= T -> s * h t < 0).
Proof.
intros D HcT Hneg Hc HT.
assert (DS : forall t, is_derive (fun t => - (s * h t)) t (- (s * h' t))).
{ intros t. apply (is_derive_opp (fun t => s * h t)). apply (is_derive_scal h), D. }
destruct (IVT (fun t => - (s * h t)) c T) as [z [Hz Ez]].
- apply (derive_continuity _ _ DS).
- exact HcT.
- simpl; lra.
- simpl; lra.
- assert (Es : s * h z = 0) by lra.
  assert (s <> 0) by (intros ->; lra).
  assert (E : h z = 0) by (apply Rmult_integral in Es; tauto).
  assert (Hz1 : c < z).
  { destruct (Rle_lt_or_eq_dec c z (proj1 Hz)) as [H1|H1]; auto. rewrite <- H1 in Es; lra. }
  assert (Hz2 : z < T).
  { destruct (Rle_lt_or_eq_dec z T (proj2 Hz)) as [H1|H1]; auto. rewrite H1 in Es; lra. }
  exists z. refine (conj (conj Hz1 Hz2) (conj E (conj _ _))).
  + intros t Ht.
    destruct (mvt_open _ _ t z (proj2 Ht) (fun u _ => DS u)) as (d & Hd & Ed). simpl in Ed.
    specialize (Hneg d ltac:(lra)).
    assert (0 < - (s * h' d) * (z - t)) by (apply Rmult_lt_0_compat; lra). lra.
  + intros t Ht.
    destruct (mvt_open _ _ z t (proj1 Ht) (fun u _ => DS u)) as (d & Hd & Ed). simpl in Ed.
    specialize (Hneg d ltac:(lra)).
    assert (0 < - (s * h' d) * (t - z)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(** ** The induction step on t > 0: from g = Theta(., b - 1) to h = Theta(., b), h' = - b g *)
Section Step.
Variables (b : R) (g g' h : R -> R).
Hypothesis Hb : 0 < b.
Hypothesis Dh : forall t, is_derive h t (- b * g t).

(** section 2 of proofs/count_law.md: at a positive zero of g, h = g'' has the sign of g' *)
Hypothesis Hval : forall c, 0 < c -> g c = 0 -> 0 < g' c * h c.

(** h and g have opposite signs near +oo *)
Hypothesis Hinf : forall T, exists t, T < t /\ h t * g t < 0.
Let h' (t : R) : R := - b * g t.

Lemma value_sign s c : 0 < c -> g c = 0 -> s * g' c < 0 -> 0 < - s * h c.
Proof.
intros Hc E Hs. assert (H := Hval c Hc E).
apply Rnot_le_lt. intros Hn. nra.
Qed.

(** from a point c with s h(c) > 0, s g > 0 just after c: one zero of h before the next zero of g,
    one after each zero of g *)
Lemma step_tail l : forall s c, 0 <= c -> pattern g g' s c l -> 0 < s * h c ->
  exists l', around l l' /\ pattern h h' s c l'.
Proof.
induction l as [|c1 l IH]; intros s c Hc Hg Hs; simpl in Hg.
- destruct (Hinf c) as (T & HT & HhT).
  assert (HsT : s * h T < 0).
  { specialize (Hg T HT). apply Rnot_le_lt. intros Hn.
    assert (0 <= (s * h T) * (s * g T)) by (apply Rmult_le_pos; lra).
    assert (s <> 0) by (intros ->; lra).
    assert (0 < s * s) by nra.
    assert (0 < s * s * - (h T * g T)) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (Hdn : forall t, c < t -> s * h' t < 0).
  { intros t Ht. unfold h'. specialize (Hg t Ht). nra. }
  destruct (cross h h' s c T Dh HT (fun t Ht => Hdn t (proj1 Ht)) Hs HsT) as (z & Hz & Ez & Hz1 & Hz2).
  exists [z]. split. { split; auto. simpl; intros; lia. } simpl.
  refine (conj (proj1 Hz) (conj _ (conj Ez (conj _ _)))).
  + intros t Ht. apply Hz1; lra.
  + apply Hdn; lra.
  + intros t Ht.
    destruct (mvt_open h h' z t Ht (fun u _ => Dh u)) as (d & Hd & Ed).
    rewrite Ez in Ed. specialize (Hdn d ltac:(lra)).
    assert (0 < - (s * h' d) * (t - z)) by (apply Rmult_lt_0_compat; lra).
    replace (h t) with (h' d * (t - z)) by lra. lra.
- destruct Hg as (H1 & H2 & H3 & H4 & H5).
  assert (Hv : 0 < - s * h c1) by (apply value_sign; auto; lra).
  assert (Hdn : forall t, c < t < c1 -> s * h' t < 0).
  { intros t Ht. unfold h'. specialize (H2 t Ht). nra. }
  destruct (cross h h' s c c1 Dh H1 Hdn Hs ltac:(lra)) as (z & Hz & Ez & Hz1 & Hz2).
  destruct (IH (- s) c1 ltac:(lra) H5 Hv) as (l' & [El Hi] & Hl).
  exists (z :: l'). split.
  { split; [simpl; congruence|]. intros [|i] Hil; simpl in Hil |- *.
    - split; [lra|]. apply (pattern_lt _ _ _ _ _ Hl). apply nth_In. lia.
    - apply Hi. lia. }
  simpl.
  refine (conj (proj1 Hz) (conj _ (conj Ez (conj _ _)))).
  + intros t Ht. apply Hz1; lra.
  + apply Hdn; lra.
  + apply (pattern_glue h h' (- s) z c1 l'); auto. lra.
    intros t Ht. specialize (Hz2 t Ht). lra.
Qed.

(** the first interval without a zero: h(0) is 0 or has the sign opposite to g(0+) *)
Lemma step_head l s : pattern g g' s 0 l -> 0 <= - s * h 0 ->
  exists l', after_each l l' /\ pattern h h' (- s) 0 l'.
Proof.
intros Hg Hs.
assert (Hup : forall c, (forall t, 0 < t < c -> 0 < s * g t) -> forall t, 0 < t <= c -> 0 < - s * h t).
{ intros c Hgc t Ht.
  destruct (mvt_open h h' 0 t (proj1 Ht) (fun u _ => Dh u)) as (d & Hd & Ed).
  unfold h' in Ed. specialize (Hgc d ltac:(lra)).
  assert (0 < b * (s * g d) * (t - 0)).
  { apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; auto. }
  replace (h t) with (h 0 + - b * g d * (t - 0)) by lra. lra. }
destruct l as [|c l]; simpl in Hg.
- exists []. split. { split; auto. simpl; intros; lia. } simpl. intros t Ht.
  apply (Hup t); [|lra]. intros u Hu; apply Hg; lra.
- destruct Hg as (H1 & H2 & H3 & H4 & H5).
  assert (Hv : 0 < - s * h c) by (apply value_sign; auto).
  destruct (step_tail l (- s) c ltac:(lra) H5 Hv) as (l' & [El Hi] & Hl).
  exists l'. split.
  { split; [simpl; congruence|]. intros i Hil. split.
    - destruct i as [|i]; simpl in *.
      + apply (pattern_lt _ _ _ _ _ Hl). apply nth_In. lia.
      + apply Hi. lia.
    - intros HSi. simpl in HSi |- *. apply Hi. lia. }
  apply (pattern_glue h h' (- s) 0 c l'); auto.
  apply (Hup c H2).
Qed.

End Step.

(** ** The whole line *)
Definition line_pattern (f f' : R -> R) (s : R) (l : list R) : Prop :=
  match l with
  | [] => forall t, 0 < s * f t
  | c :: l' => (forall t, t < c -> 0 < s * f t) /\ f c = 0 /\ s * f' c < 0 /\ pattern f f' (- s) c l'
  end.

Lemma line_pattern_alt f f' s l a : (forall c, In c l -> a < c) -> line_pattern f f' s l -> pattern f f' s a l.
Proof.
destruct l as [|c l]; simpl.
- auto.
- intros Ha (H1 & H2). refine (conj _ (conj _ H2)). apply Ha; auto.
  intros t Ht; apply H1; lra.
Qed.

Lemma line_pattern_before f f' s l : line_pattern f f' s l ->
  forall t, (forall c, In c l -> t < c) -> 0 < s * f t.
Proof.
destruct l as [|c l]; simpl; auto. intros (H1 & _) t Ht. apply H1, Ht; auto.
Qed.

Lemma list_lower (l : list R) (t : R) : exists a, a < t /\ forall c, In c l -> a < c.
Proof.
induction l as [|c l (a & H1 & H2)].
- exists (t - 1). split. lra. simpl; tauto.
- exists (Rmin a (c - 1)). assert (Ha := Rmin_l a (c - 1)). assert (Hc := Rmin_r a (c - 1)).
  split. lra. intros x [<-|Hx]. lra. specialize (H2 x Hx); lra.
Qed.

Lemma line_pattern_sorted f f' s l : line_pattern f f' s l -> StronglySorted Rlt l.
Proof.
intros H. destruct (list_lower l 0) as (a & _ & Ha).
apply (pattern_sorted f f' l s a), line_pattern_alt; auto.
Qed.

Lemma line_pattern_zeros f f' s l : line_pattern f f' s l -> forall t, f t = 0 <-> In t l.
Proof.
intros H t. destruct (list_lower l t) as (a & Hat & Ha).
apply (pattern_zeros f f' l s a); auto. apply line_pattern_alt; auto.
Qed.

Lemma line_pattern_simple f f' s l : line_pattern f f' s l ->
  forall i, (i < length l)%nat -> s * (-1) ^ i * f' (nth i l 0) < 0.
Proof.
intros H. destruct (list_lower l 0) as (a & _ & Ha).
apply (pattern_simple f f' l s a), line_pattern_alt; auto.
Qed.

Lemma line_pattern_scal f f' F F' k s l : k < 0 -> (forall t, F t = k * f t) -> (forall t, F' t = k * f' t) ->
  line_pattern f f' s l -> line_pattern F F' (- s) l.
Proof.
intros Hk E E'. destruct l as [|c l]; simpl.
- intros H t. rewrite E. replace (- s * (k * f t)) with (- k * (s * f t)) by ring.
  apply Rmult_lt_0_compat; [lra|auto].
- intros (H2 & H3 & H4 & H5).
  refine (conj _ (conj _ (conj _ _))).
  + intros t Ht. rewrite E. replace (- s * (k * f t)) with (- k * (s * f t)) by ring.
    apply Rmult_lt_0_compat; [lra|auto].
  + rewrite E, H3. ring.
  + rewrite E'. assert (0 < (- k) * (- (s * f' c))) by (apply Rmult_lt_0_compat; lra). lra.
  + apply (pattern_scal f f' F F' k (- s)); auto.
Qed.
