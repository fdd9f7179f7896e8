(** * Events of a run: Theorems V5 and V6 of proofs/validated_step.md

    g has no zero on a negative piece and increases on a rising one. So where g >= 0 at the beginning of a piece that is
    negative or rising, it is rising, and g > 0 at its end: once g >= 0, ever after ([never_back]). Hence g < 0 at m
    gives g < 0 up to m ([no_event]); and on a stretch with g < 0 at its beginning and g > 0 at its end there is one
    zero ([one_event]). *)

From Coq Require Import Reals Psatz Lra List Ranalysis5.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus SmoothFunctions StatementStep.
Import ListNotations.
Open Scope R_scope.

Section Events.
Variables (I : Type) (all : list I) (f : I -> (I -> R) -> R) (g : (I -> R) -> R) (d : I -> (I -> R) -> R).
Variables (xi : I -> R -> R) (t0 m : R).
Hypothesis Hall : forall i, In i all.
Hypothesis Hmove : moves_with all f g d xi t0 m.

Let value s := g (state xi s).
Let rate := along all d f.

Lemma value_rate s : t0 <= s <= m -> is_derive value s (rate (state xi s)).
Proof. intros Hs. destruct (Hmove s Hs) as [D G]. apply (gradient_chain I all Hall g); auto. Qed.

(** Between two times with g' > 0. *)
Lemma increases s t : t0 <= s -> s < t -> t <= m -> (forall u, s <= u <= t -> 0 < rate (state xi u)) ->
  value s < value t.
Proof.
intros Hs Hst Ht H. destruct (mvt_open value (fun u => rate (state xi u)) s t Hst) as (c & Hc & E).
- intros u Hu. apply value_rate. lra.
- specialize (H c ltac:(lra)). assert (0 < rate (state xi c) * (t - s)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma covers_order run : forall t last, covers xi t run last -> t <= last.
Proof.
induction run as [|one rest IH]; simpl. intros t last ->. lra.
intros t last (next & Hn & _ & C). apply IH in C. lra.
Qed.

(** A run cut where a piece holds everywhere. *)
Lemma covers_all (Q : (I -> R) -> Prop) run : every run (fun one => forall v, on_piece one v -> Q v) ->
  forall t last, covers xi t run last -> t < last -> forall s, t <= s <= last -> Q (state xi s).
Proof.
induction run as [|one rest IH]; simpl. { intros _ t last ->. lra. }
intros K t last (next & Hn & B & C) Hlt s Hs. assert (H := K one (or_introl eq_refl)).
destruct (Rle_dec s next) as [L|L]. { apply H, B. lra. }
assert (O := covers_order rest next last C). apply (IH (fun other Ho => K other (or_intror Ho)) next last C); lra.
Qed.

Let kinds run := every run (fun one => negative g one \/ rising rate one).

Lemma every_tail one rest (Q : piece I -> Prop) : every (one :: rest) Q -> Q one /\ every rest Q.
Proof. intros H. split. apply H. left. reflexivity. intros other Hother. apply H. right. exact Hother. Qed.

Lemma never_back run : kinds run -> forall t last, t0 <= t -> last <= m -> covers xi t run last -> 0 <= value t ->
  0 <= value last.
Proof.
induction run as [|one rest IH]; simpl. { intros _ t last _ _ ->. auto. }
intros K t last Ht Hl (next & Hn & B & C) V. assert (O := covers_order rest next last C).
apply every_tail in K. destruct K as [H K].
destruct H as [N|U]. { specialize (N _ (B t ltac:(lra))). unfold value in V. lra. }
apply (IH K next last ltac:(lra) Hl C). apply Rle_trans with (1 := V), Rlt_le, increases; try lra.
intros u Hu. apply U, B. lra.
Qed.

Lemma stays_below run : kinds run -> forall t last, t0 <= t -> last <= m -> covers xi t run last -> value t < 0 ->
  value last < 0 -> forall s, t <= s <= last -> value s < 0.
Proof.
induction run as [|one rest IH]; simpl. { intros _ t last _ _ -> Ht _ s Hs. replace s with last by lra. exact Ht. }
intros K t last Ht Hl (next & Hn & B & C) Vt Vl s Hs. apply every_tail in K. destruct K as [H K].
assert (O := covers_order rest next last C).
assert (Vn : value next < 0).
{ apply Rnot_le_lt. intros Hle. assert (Q := never_back rest K next last ltac:(lra) Hl C Hle). lra. }
destruct (Rle_dec s next) as [L|L]. 2: { apply (IH K next last); auto; lra. }
destruct H as [N|U]. { apply N, B. lra. }
destruct (Req_dec s next) as [->|Hne]; auto. apply Rlt_trans with (2 := Vn), increases; try lra.
intros u Hu. apply U, B. lra.
Qed.

End Events.

Theorem no_event : StatementStep.no_event.
Proof.
intros I all f g d xi t0 m run Hall Hmove (C & K & V0) Vm s Hs.
exact (stays_below I all f g d xi t0 m Hall Hmove run K t0 m (Rle_refl t0) (Rle_refl m) C V0 Vm s Hs).
Qed.

Theorem one_event : StatementStep.one_event.
Proof.
intros I all f g d xi t0 before m0 stretch m Hall Hmove ((C & K & V0) & V1 & C' & U & V2).
assert (O := covers_order I xi before t0 m0 C). assert (O' := covers_order I xi stretch m0 m C').
assert (Hlt : m0 < m). { destruct O' as [|E]; auto. rewrite E in V1. lra. }
assert (Up : forall s, m0 <= s <= m -> 0 < along all d f (state xi s)).
{ apply (covers_all I xi (fun v => 0 < along all d f v) stretch U m0 m C' Hlt). }
assert (Inc : forall s t, m0 <= s -> s < t -> t <= m -> g (state xi s) < g (state xi t)).
{ intros s t Hs Hst Ht. apply (increases I all f g d xi t0 m Hall Hmove); try lra. intros u Hu. apply Up. lra. }
destruct (IVT_interv (fun s => g (state xi s)) m0 m) as (zero & Hz & E); auto.
{ intros s Hs. apply continuity_pt_filterlim, (ex_derive_continuous (fun s => g (state xi s))). eexists.
  apply (value_rate I all f g d xi t0 m Hall Hmove). lra. }
assert (Z1 : m0 <> zero) by (intros H; rewrite <- H in E; lra).
assert (Z2 : zero <> m) by (intros H; rewrite H in E; lra).
exists zero. repeat apply conj; try lra.
- apply Up. lra.
- intros s Hs. destruct (Rle_dec s m0) as [L|L].
  + assert (Hmove0 : moves_with all f g d xi t0 m0) by (intros u Hu; apply Hmove; lra).
    apply (no_event I all f g d xi t0 m0 before Hall Hmove0 (conj C (conj K V0)) V1). lra.
  + rewrite <- E. apply Inc; lra.
- intros s Hs. rewrite <- E. apply Inc; lra.
- intros low high H. apply (covers_all I xi (in_box low high) stretch H m0 m C' Hlt).
- intros low high H. apply (covers_all I xi (fun v => low <= along all d f v <= high) stretch H m0 m C' Hlt).
Qed.

Theorem first_event : StatementStep.first_event.
Proof.
intros I K all f g d xi t0 before m0 stretch m one run Hall Hmove Hone Hothers.
destruct (one_event I all f (g one) (d one) xi t0 before m0 stretch m Hall (Hmove one) Hone)
  as (zero & Hz & E & _ & Below & _).
exists zero. repeat apply conj; auto; try lra. intros k Hk s Hs. destruct (Hothers k Hk) as [F V].
apply (no_event I all f (g k) (d k) xi t0 m (run k) Hall (Hmove k) F V s Hs).
Qed.
