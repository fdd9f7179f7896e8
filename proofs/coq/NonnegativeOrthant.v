(** * A linear system that keeps the orthant

    x' = B(t) x + g(t) with off-diagonal entries of B and entries of g that are >= 0 keeps x >= 0 ([orthant_kept]). What
    is used of it: where all components are >= -m and one is -m, its derivative is >= -K m. For each delta > 0 then x >
    - delta e^((K+1)(t - t0)): at a first time of equality the derivative of the sum would be positive. *)

From Coq Require Import Reals Psatz Lra Lia List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus.
Import ListNotations.
Open Scope R_scope.

(** A component and eps times its derivative. *)
Definition component : Type := ((R -> R) * (R -> R))%type.

Lemma derive_pos_before (f : R -> R) t l : is_derive f t l -> f t = 0 -> 0 < l -> exists d, 0 < d /\ forall s,
  t - d < s < t -> f s < 0.
Proof.
intros D E Hl. apply is_derive_Reals in D. destruct (D l Hl) as (d & Hd).
exists d. split. apply cond_pos. intros s Hs.
specialize (Hd (s - t) ltac:(lra)). rewrite Rabs_left1 in Hd by lra. specialize (Hd ltac:(lra)).
replace (t + (s - t)) with s in Hd by ring. rewrite E, Rminus_0_r in Hd.
apply Rabs_def2 in Hd. destruct Hd as [_ Hd].
assert (Hq : 0 < f s / (s - t)) by lra.
replace (f s) with (- (f s / (s - t) * (t - s))) by (field; lra).
assert (0 < f s / (s - t) * (t - s)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Section Orthant.
Variables (eps K t0 t1 : R) (l : list component).
Hypothesis Heps : 0 < eps.
Hypothesis Hderive : forall x x' t, In (x, x') l -> t0 <= t <= t1 -> is_derive x t (x' t / eps).
Hypothesis Hstart : forall x x', In (x, x') l -> 0 <= x t0.
Hypothesis Hinward : forall t m, t0 <= t <= t1 -> 0 < m -> (forall x x', In (x, x') l -> - m <= x t) ->
  forall x x', In (x, x') l -> x t = - m -> - (K * m) <= x' t.

Lemma above_barrier delta : 0 < delta -> forall t, t0 <= t -> t <= t1 ->
  forall x x', In (x, x') l -> 0 < x t + delta * exp ((K + 1) / eps * (t - t0)).
Proof.
intros Hdelta.
set (m := fun t => delta * exp ((K + 1) / eps * (t - t0))).
assert (M0 : forall t, 0 < m t) by (intros t; apply Rmult_lt_0_compat; [auto|apply exp_pos]).
assert (Dm : forall t, is_derive m t ((K + 1) / eps * m t)) by (intros t; unfold m; auto_derive; auto; unfold Rminus,
  Rdiv; ring).
assert (Dg : forall x x' t, In (x, x') l -> t0 <= t <= t1 -> is_derive (fun s => x s + m s) t
  (x' t / eps + (K + 1) / eps * m t)).
{ intros x x' t Hx Ht. apply (is_derive_plus x m); auto. }
apply (real_induction (fun t => t <= t1 -> forall x x', In (x, x') l -> 0 < x t + m t) t0).
- intros _ x x' Hx. specialize (Hstart x x' Hx). specialize (M0 t0). lra.
- intros t Ht HP. destruct (Rlt_dec t t1) as [Hlt|Hlt].
  2: { exists 1. split. lra. intros s Hs Hs1 x x' Hx. replace s with t by lra.
       apply (HP t ltac:(lra) ltac:(lra) x x' Hx). }
  assert (Q : exists d, 0 < d /\ forall s, t <= s < t + d -> forall x x', In (x, x') l -> 0 < x s + m s).
  { assert (HPt : forall x x', In (x, x') l -> 0 < x t + m t) by (intros; eapply HP; eauto; lra).
    assert (Xt : forall x x', In (x, x') l -> ex_derive (fun s => x s + m s) t)
      by (intros; eexists; apply Dg with (x' := x'); auto; lra).
    clear - HPt Xt. induction l as [|[x x'] r IH].
    - exists 1. split. lra. intros s _ x x' [].
    - destruct IH as (d & Hd & H). { intros; eapply HPt; right; eauto. } { intros; eapply Xt; right; eauto. }
      destruct (continuous_pos (fun s => x s + m s) t) as [e He].
      { eapply Xt; left; eauto. } { eapply HPt; left; eauto. }
      exists (Rmin d e). split. apply Rmin_pos; [exact Hd|apply cond_pos].
      assert (M1 := Rmin_l d e). assert (M2 := Rmin_r d e).
      intros s Hs w w' [E|Hw].
      + injection E as <- <-. apply He. change (Rabs (s - t) < e). rewrite Rabs_pos_eq; lra.
      + apply (H s ltac:(lra) w w' Hw). }
  destruct Q as (d & Hd & H). exists d. split; auto. intros s Hs _. apply (H s Hs).
- intros t Ht HP Ht1.
  assert (G : forall x x', In (x, x') l -> 0 <= x t + m t).
  { intros x x' Hx. apply (closed_ge (fun s => x s + m s) t0 t 0 Ht). eexists. apply (Dg x x'); auto; lra.
    intros s Hs. apply Rlt_le, (HP s Hs ltac:(lra) x x' Hx). }
  intros x x' Hx. destruct (Rle_lt_or_eq_dec _ _ (G x x' Hx)) as [H|E]; auto. exfalso.
  assert (I : - (K * m t) <= x' t).
  { apply (Hinward t (m t)) with (x := x); auto; try lra. intros w w' Hw. specialize (G w w' Hw). lra. }
  assert (Hi : 0 < / eps) by (apply Rinv_0_lt_compat, Heps).
  destruct (derive_pos_before (fun s => x s + m s) t (x' t / eps + (K + 1) / eps * m t)) as (d & Hd & N); auto.
  { apply Dg; auto; lra. }
  { replace (x' t / eps + (K + 1) / eps * m t) with ((x' t + K * m t + m t) * / eps) by (field; lra).
    apply Rmult_lt_0_compat; auto. specialize (M0 t). lra. }
  set (s := Rmax t0 (t - d / 2)).
  assert (S1 : t0 <= s) by apply Rmax_l. assert (S2 : t - d / 2 <= s) by apply Rmax_r.
  assert (S3 : s < t) by (unfold s, Rmax; destruct Rle_dec; lra).
  specialize (HP s ltac:(lra) ltac:(lra) x x' Hx). specialize (N s ltac:(lra)). lra.
Qed.

Theorem orthant_kept : forall x x' t, In (x, x') l -> t0 <= t <= t1 -> 0 <= x t.
Proof.
intros x x' t Hx Ht. apply Rnot_lt_le. intros Hn.
set (E := exp ((K + 1) / eps * (t - t0))). assert (HE : 0 < E) by apply exp_pos.
assert (Hd : 0 < - x t / E) by (apply Rdiv_lt_0_compat; lra).
assert (B := above_barrier (- x t / E) Hd t ltac:(lra) ltac:(lra) x x' Hx). fold E in B.
replace (- x t / E * E) with (- x t) in B by (field; lra). lra.
Qed.

End Orthant.
