(** * Models of the coefficients

    Section 3 of proofs/box.md. A polynomial in eta with a bound of the error, for |eta| <= 1; (k - b0 - r eta) times it
    has one coefficient more, which is left out and counts as an error; so the models of a_0, a_1, a_2 give those of all
    a_k, by the recurrence. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementModels.
Open Scope R_scope.

Lemma polynomial_size m x : Rabs x <= 1 -> Rabs (polynomial m x) <= total_size m.
Proof.
intros Hx. induction m as [|a m IH]; simpl. rewrite Rabs_R0. lra.
eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l. rewrite Rabs_mult.
rewrite <- (Rmult_1_l (total_size m)). apply Rmult_le_compat; auto; apply Rabs_pos.
Qed.

Lemma polynomial_times g r x m : forall before,
  polynomial (times_linear g r before m) x = (g - r * x) * polynomial m x - r * before.
Proof. induction m as [|a m IH]; intros before; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma polynomial_divided N m x : polynomial (map (fun a => a / N) m) x = polynomial m x / N.
Proof. induction m as [|a m IH]; simpl. unfold Rdiv; ring. rewrite IH. unfold Rdiv; ring. Qed.

(** the last coefficient is left out *)
Lemma polynomial_cut m x : Rabs x <= 1 -> Rabs (polynomial m x - polynomial (removelast m) x) <= Rabs (last m 0).
Proof.
intros Hx. induction m as [|a m IH]; simpl. rewrite Rminus_0_r, Rabs_R0. lra.
destruct m as [|a' m]. simpl. replace (a + x * 0 - 0) with a by ring. lra.
change (polynomial (a :: removelast (a' :: m)) x) with (a + x * polynomial (removelast (a' :: m)) x).
replace (a + x * polynomial (a' :: m) x - (a + x * polynomial (removelast (a' :: m)) x))
  with (x * (polynomial (a' :: m) x - polynomial (removelast (a' :: m)) x)) by ring.
rewrite Rabs_mult. apply Rle_trans with (1 * Rabs (last (a' :: m) 0)); [|lra].
apply Rmult_le_compat; auto; apply Rabs_pos.
Qed.

Lemma next_model_right b0 r k model (f f3 : R -> R) : 0 <= r -> is_model model f ->
  (forall eta, (INR k + 1) * (INR k + 2) * (INR k + 3) * f3 eta = (INR k - (b0 + r * eta)) * f eta) ->
  is_model (next_model b0 r k model) f3.
Proof.
intros Hr Hm Hf eta He. specialize (Hm eta He). specialize (Hf eta). assert (Hk := pos_INR k).
unfold next_model. set (N := (INR k + 1) * (INR k + 2) * (INR k + 3)) in *.
assert (HN : 0 < N) by (unfold N; repeat apply Rmult_lt_0_compat; lra). cbn [fst snd].
set (Q := map (fun a => a / N) (times_linear (INR k - b0) r 0 (fst model))).
assert (C := polynomial_cut Q eta He).
assert (EQ : polynomial Q eta = (INR k - b0 - r * eta) * polynomial (fst model) eta / N).
{ unfold Q. rewrite polynomial_divided, polynomial_times. rewrite Rmult_0_r, Rminus_0_r. reflexivity. }
replace (f3 eta - polynomial (removelast Q) eta)
  with ((INR k - b0 - r * eta) * (f eta - polynomial (fst model) eta) / N
    + (polynomial Q eta - polynomial (removelast Q) eta)).
2: { rewrite EQ. replace (f3 eta) with ((INR k - (b0 + r * eta)) * f eta / N) by (rewrite <- Hf; field; lra). field.
     lra. }
eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; [|exact C].
unfold Rdiv. rewrite !Rabs_mult, (Rabs_pos_eq (/ N)) by (apply Rlt_le, Rinv_0_lt_compat, HN).
apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, HN.
apply Rmult_le_compat; auto; try apply Rabs_pos.
unfold Rminus at 1. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l.
rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq r) by exact Hr. rewrite <- (Rmult_1_r r) at 2. apply Rmult_le_compat_l; auto.
Qed.

Lemma series_models b0 r (a : nat -> R -> R) (model : nat -> list R * R) : 0 <= r ->
  (forall k eta, (INR k + 1) * (INR k + 2) * (INR k + 3) * a (k + 3)%nat eta = (INR k - (b0 + r * eta)) * a k eta) ->
  (forall k, (k < 3)%nat -> is_model (model k) (a k)) -> (forall k, model (k + 3)%nat = next_model b0 r k (model k)) ->
  forall k, is_model (model k) (a k).
Proof.
intros Hr Ha H0 Hn.
assert (A : forall k, is_model (model k) (a k) /\ is_model (model (k + 1)%nat) (a (k + 1)%nat) /\
  is_model (model (k + 2)%nat) (a (k + 2)%nat)).
{ induction k as [|k (I0 & I1 & I2)].
  - refine (conj _ (conj _ _)); apply H0; lia.
  - replace (S k) with (k + 1)%nat by lia. replace (k + 1 + 1)%nat with (k + 2)%nat by lia.
    replace (k + 1 + 2)%nat with (k + 3)%nat by lia.
    refine (conj I1 (conj I2 _)). rewrite Hn. apply (next_model_right b0 r k (model k) (a k)); auto. }
intros k. apply A.
Qed.
