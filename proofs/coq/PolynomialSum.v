(** * The closed sum of the polynomials P_n

    The sum of [Statement.Poly] and the recurrence of [Pn] have the same derivative, -n times the one before, and the
    same value at 0; so they agree, by induction. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus Family SignsAtZero IntegerPolynomials.
Open Scope R_scope.

Definition poly_term (n j : nat) (t : R) : R :=
  (-1) ^ (n + j) * INR (fact n) / (INR (fact (n - 3 * j)) * 3 ^ j * INR (fact j)) * t ^ (n - 3 * j).

Lemma poly_term_derive n j t : (3 * j <= n)%nat ->
  is_derive (poly_term (S n) j) t (- INR (S n) * poly_term n j t).
Proof.
intros Hj. unfold poly_term.
replace (S n - 3 * j)%nat with (S (n - 3 * j)) by lia. set (e := (n - 3 * j)%nat).
assert (H0 := INR_fact_neq_0 e). assert (H1 := INR_fact_neq_0 j).
assert (H2 : 3 ^ j <> 0) by (apply pow_nonzero; lra).
assert (H3 : INR (S e) <> 0) by (apply not_0_INR; lia).
change (fact (S n)) with (S n * fact n)%nat. change (fact (S e)) with (S e * fact e)%nat. rewrite !mult_INR.
set (c := (-1) ^ (S n + j) * (INR (S n) * INR (fact n)) / (INR (S e) * INR (fact e) * 3 ^ j * INR (fact j))).
eapply is_derive_val.
- apply (is_derive_scal (fun t => t ^ S e)). apply (is_derive_pow (fun t => t) (S e) t 1), (is_derive_id t).
- unfold c. simpl pred. change ((-1) ^ (S n + j)) with (-1 * (-1) ^ (n + j)). field. auto.
Qed.

Lemma sum_derive (f g : nat -> R -> R) N t : (forall j, (j <= N)%nat -> is_derive (f j) t (g j t)) ->
  is_derive (fun t => sum_f_R0 (fun j => f j t) N) t (sum_f_R0 (fun j => g j t) N).
Proof.
intros D. induction N as [|N IH].
- apply (D 0%nat). lia.
- simpl. apply (is_derive_plus (fun t => sum_f_R0 (fun j => f j t) N) (f (S N))).
  apply IH. intros j Hj. apply D. lia. apply D. lia.
Qed.

Lemma Poly_derive n t : is_derive (Poly (S n)) t (- INR (S n) * Poly n t).
Proof.
assert (Hd : (n = 3 * (n / 3) + n mod 3)%nat) by (apply Nat.div_mod; lia).
assert (Hm : (n mod 3 < 3)%nat) by (apply Nat.mod_upper_bound; lia).
assert (S0 : is_derive (fun t => sum_f_R0 (fun j => poly_term (S n) j t) (n / 3)) t (- INR (S n) * Poly n t)).
{ eapply is_derive_val.
  - apply (sum_derive (poly_term (S n)) (fun j t => - INR (S n) * poly_term n j t)).
    intros j Hj. apply poly_term_derive. lia.
  - unfold Poly. rewrite scal_sum. apply sum_eq. intros j _. unfold poly_term. ring. }
assert (EP : forall N, (S n / 3 = N)%nat -> forall u, sum_f_R0 (fun j => poly_term (S n) j u) N = Poly (S n) u).
{ intros N <- u. reflexivity. }
destruct (sp_cases n) as [(_ & _ & C & E)|[(_ & _ & C & E)|(_ & _ & C & E)]];
  apply (is_derive_ext _ _ _ _ (EP _ E)); [exact S0|exact S0|].
replace (- INR (S n) * Poly n t) with (- INR (S n) * Poly n t + 0) by ring.
apply (is_derive_plus (fun t => sum_f_R0 (fun j => poly_term (S n) j t) (n / 3)) (poly_term (S n) (S (n / 3)))
  t _ 0 S0).
assert (Hn : (S n - 3 * S (n / 3) = 0)%nat).
{ assert (H3 : (S n = 3 * (S n / 3) + S n mod 3)%nat) by (apply Nat.div_mod; lia). lia. }
apply (is_derive_ext (fun _ => poly_term (S n) (S (n / 3)) 0)).
{ intros s. unfold poly_term. rewrite Hn. reflexivity. }
apply (is_derive_const (poly_term (S n) (S (n / 3)) 0)).
Qed.

Lemma Poly_at_0 n : Poly n 0 = poly_term n (n / 3) 0.
Proof.
assert (Hd : (n = 3 * (n / 3) + n mod 3)%nat) by (apply Nat.div_mod; lia).
change (sum_f_R0 (fun j => poly_term n j 0) (n / 3) = poly_term n (n / 3) 0).
assert (Z : forall N, (3 * N < n)%nat -> sum_f_R0 (fun j => poly_term n j 0) N = 0).
{ induction N as [|N IH]; intros HN.
  - simpl. unfold poly_term. rewrite pow_ne_zero by lia. ring.
  - simpl sum_f_R0. rewrite IH by lia. unfold poly_term. rewrite pow_ne_zero by lia. ring. }
destruct (n / 3)%nat as [|q] eqn:E.
- reflexivity.
- simpl sum_f_R0. rewrite Z by lia. ring.
Qed.

Lemma Poly_0_eq n : Poly n 0 = Pn n 0.
Proof.
rewrite Poly_at_0.
assert (Hd : (n = 3 * (n / 3) + n mod 3)%nat) by (apply Nat.div_mod; lia).
destruct (Nat.eq_dec (n mod 3) 0) as [Hm|Hm].
2: { rewrite (Pn_0_zero n Hm). unfold poly_term. rewrite pow_ne_zero by lia. ring. }
rewrite Hm, Nat.add_0_r in Hd. set (q := (n / 3)%nat) in *. rewrite Hd. clearbody q. clear Hd Hm n.
induction q as [|q IH].
- unfold poly_term. simpl. field.
- assert (ER : Pn (3 * S q) 0 = (INR (3 * q) + 2) * (INR (3 * q) + 1) * Pn (3 * q) 0).
  { replace (3 * S q)%nat with (S (S (S (3 * q)))) by lia. rewrite Pn_rec. ring. }
  rewrite ER, <- IH. unfold poly_term.
  replace (3 * S q - 3 * S q)%nat with 0%nat by lia. replace (3 * q - 3 * q)%nat with 0%nat by lia.
  replace (3 * S q + S q)%nat with (2 * (2 * S q))%nat by lia. replace (3 * q + q)%nat with (2 * (2 * q))%nat by lia.
  rewrite !pow_1_even.
  replace (3 * S q)%nat with (S (S (S (3 * q)))) by lia.
  change (fact (S (S (S (3 * q))))) with (S (S (S (3 * q))) * (S (S (3 * q)) * (S (3 * q) * fact (3 * q))))%nat.
  change (fact (S q)) with (S q * fact q)%nat. rewrite !mult_INR, !S_INR, !mult_INR. simpl (INR 3). simpl (fact 0).
  simpl (INR 1).
  assert (H1 := INR_fact_neq_0 q). assert (H2 : 3 ^ q <> 0) by (apply pow_nonzero; lra). assert (H3 := pos_INR q).
  change (INR 0) with 0. simpl pow. field. repeat split; auto; lra.
Qed.

(** The closed sum. *)
Theorem Poly_Pn n : forall t, Poly n t = Pn n t.
Proof.
induction n as [|n IH]; intros t.
- unfold Poly. simpl. field.
- apply Rminus_diag_uniq.
  assert (D : forall s, is_derive (fun s => Poly (S n) s - Pn (S n) s) s 0).
  { intros s. replace 0 with (- INR (S n) * Poly n s - - INR (S n) * Pn n s) by (rewrite IH; ring).
    apply (is_derive_minus (Poly (S n)) (Pn (S n))). apply Poly_derive. apply Pn_derive. }
  assert (E0 : Poly (S n) 0 - Pn (S n) 0 = 0) by (rewrite Poly_0_eq; ring).
  destruct (Rtotal_order t 0) as [H|[->|H]]; auto.
  + destruct (mvt_open _ _ t 0 H (fun s _ => D s)) as (c & _ & E). lra.
  + destruct (mvt_open _ _ 0 t H (fun s _ => D s)) as (c & _ & E). lra.
Qed.
