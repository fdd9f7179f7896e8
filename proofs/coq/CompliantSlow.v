(** * The compliant model: the slow solution of the deviation

    F_b = J_(-b-1)/Gamma(-b) ([Fe e b]) solves the equation of the deviation, F_b(-x) ~ x^b, Gamma(-b) F_b^(n) > 0 for n
    > b. For 0 < b < 1 all its derivatives are negative on the whole line, at every eps. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral.
Open Scope R_scope.

Section Slow.
Variable e : R.
Hypothesis He : 0 < e.

(** ** The slow solution *)
Definition Fe (b t : R) : R := Je e (- b - 1) t / Gamma (- b).

Theorem Fe_derive b t : not_nat b -> is_derive (Fe b) t (- b * Fe (b - 1) t).
Proof.
intros Hb. assert (Hg := not_nat_Gamma b Hb). assert (Hb0 := not_nat_neq0 b Hb).
unfold Fe.
replace (- b * (Je e (- (b - 1) - 1) t / Gamma (- (b - 1)))) with (/ Gamma (- b) * Je e (- b - 1 + 1) t).
2: { replace (- (b - 1)) with (- b + 1) by ring. rewrite Gamma_rec by lra.
     replace (- b + 1 - 1) with (- b - 1 + 1) by ring. field. auto. }
apply (is_derive_ext (fun t => / Gamma (- b) * Je e (- b - 1) t)).
{ intros u. change (/ Gamma (- b) * Je e (- b - 1) u = Je e (- b - 1) u / Gamma (- b)). unfold Rdiv; ring. }
apply (is_derive_scal (Je e (- b - 1))), (Je_derive e He), ok_not_nat, Hb.
Qed.

Lemma Fe_derive_n b n t : not_nat b -> Gamma (- b) * Derive_n (Fe b) n t = Je e (INR n - b - 1) t.
Proof.
intros Hb. assert (Hg := not_nat_Gamma b Hb).
rewrite (Derive_n_ext (Fe b) (fun t => / Gamma (- b) * Je e (- b - 1) t)).
2: { intros u. unfold Fe, Rdiv; ring. }
rewrite Derive_n_scal_l, (Je_derive_n e He) by (apply ok_not_nat, Hb).
replace (INR n - b - 1) with (- b - 1 + INR n) by ring. field; auto.
Qed.

Lemma Fe_ex_derive_n b n t : not_nat b -> ex_derive_n (Fe b) n t.
Proof.
intros Hb. destruct n as [|n]; [exact I|].
unfold ex_derive_n. assert (Hg := not_nat_Gamma b Hb).
exists (/ Gamma (- b) * Je e (- b - 1 + INR n + 1) t).
apply (is_derive_ext (fun t => / Gamma (- b) * Je e (- b - 1 + INR n) t)).
- intros u.
  apply (Rmult_eq_reg_l (Gamma (- b))); auto.
  change (Gamma (- b) * (/ Gamma (- b) * Je e (- b - 1 + INR n) u) = Gamma (- b) * Derive_n (Fe b) n u).
  rewrite Fe_derive_n by auto.
  replace (INR n - b - 1) with (- b - 1 + INR n) by ring. field; auto.
- apply (is_derive_scal (Je e (- b - 1 + INR n))), (Je_derive e He), ok_plus, ok_not_nat, Hb.
Qed.

(** The side rule at every eps: no derivative of order n > b ever vanishes. *)
Theorem Fe_sign b n : not_nat b -> b < INR n -> forall t, 0 < Gamma (- b) * Derive_n (Fe b) n t.
Proof. intros Hb Hn t. rewrite Fe_derive_n by auto. apply (Je_pos e He); lra. Qed.

Theorem Fe_representation b n : not_nat b -> b < INR n -> forall t,
  is_RInt_gen (fun r => Rpower r (INR n - b - 1) * exp (psi r / e + r * t))
    (at_right 0) (Rbar_locally p_infty) (Gamma (- b) * Derive_n (Fe b) n t).
Proof.
intros Hb Hn t. rewrite Fe_derive_n by auto. rewrite (Je_Ie e He) by lra. apply Ie_correct; auto; lra.
Qed.

(** t -> +oo: every derivative, of any order, is large with the sign of Gamma(-b). *)
Theorem Fe_right b n : not_nat b -> forall M, exists T, 0 <= T /\
  forall t, T <= t -> M <= Gamma (- b) * Derive_n (Fe b) n t.
Proof.
intros Hb M. destruct ((Je_right e He) (INR n - b - 1)) with (M := M) as (T & HT & H).
{ replace (INR n - b - 1) with (- b - 1 + INR n) by ring. apply ok_plus, ok_not_nat, Hb. }
exists T. split; auto. intros t Ht. rewrite Fe_derive_n by auto. auto.
Qed.

Theorem Fe_asymptotics b : not_nat b -> is_lim (fun x => Fe b (- x) / Rpower x b) p_infty 1.
Proof.
intros Hb. assert (Hg := not_nat_Gamma b Hb).
apply (is_lim_ext_loc (fun x => / Gamma (- b) * (Je e (- b - 1) (- x) * Rpower x (- b - 1 + 1)))).
{ exists 1. intros x Hx. replace (- b - 1 + 1) with (- b) by ring.
  rewrite Rpower_Ropp. unfold Fe. field. split; auto. apply Rgt_not_eq, exp_pos. }
assert (HH := is_lim_scal_l _ (/ Gamma (- b)) p_infty _ ((Je_left e He) _ (ok_not_nat b Hb))).
simpl in HH.
assert (E : / Gamma (- b) * Gamma (- b - 1 + 1) = 1).
{ replace (- b - 1 + 1) with (- b) by ring. field; auto. }
rewrite E in HH. exact HH.
Qed.

Theorem Fe_ode b : not_nat b -> deviation_equation e b (Fe b).
Proof.
intros Hb. split.
- intros k t _. apply Fe_ex_derive_n, Hb.
- intros t. assert (Hg := not_nat_Gamma b Hb).
  assert (HR := (Je_recurrence e He) (- b - 1) t (ok_not_nat b Hb)).
  assert (H := fun n => Fe_derive_n b n t Hb).
  assert (H0 := H 0%nat). assert (H1 := H 1%nat). assert (H2 := H 2%nat). assert (H3 := H 3%nat).
  assert (H4 := H 4%nat).
  change (Derive_n (Fe b) 0 t) with (Fe b t) in H0. change (Derive_n (Fe b) 1 t) with (Derive (Fe b) t) in H1.
  simpl INR in H0, H1, H2, H3, H4.
  replace (0 - b - 1) with (- b - 1) in H0 by ring.
  replace (1 - b - 1) with (- b - 1 + 1) in H1 by ring.
  replace (1 + 1 - b - 1) with (- b - 1 + 2) in H2 by ring.
  replace (1 + 1 + 1 - b - 1) with (- b - 1 + 3) in H3 by ring.
  replace (1 + 1 + 1 + 1 - b - 1) with (- b - 1 + 4) in H4 by ring.
  rewrite <- H0, <- H1, <- H2, <- H3, <- H4 in HR.
  apply (Rmult_eq_reg_l (Gamma (- b))); auto. rewrite Rmult_0_r, <- HR. ring.
Qed.

(** Impact without collision at every eps > 0: F_b' < 0 everywhere, with all higher derivatives. *)
Theorem IWC_eps b : 0 < b < 1 -> forall n t, (1 <= n)%nat -> Derive_n (Fe b) n t < 0.
Proof.
intros Hb n t Hn. apply neg_of_prod_pos with (Gamma (- b)). apply Gamma_neg, Hb.
apply Fe_sign. apply not_nat_01, Hb. apply (le_INR 1) in Hn. simpl in Hn. lra.
Qed.

End Slow.
