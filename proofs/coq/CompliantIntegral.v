(** * The compliant model: the integral for every s

    J_s ([Je e s]) continues I_s to all s but -1, -2, ... by the moment recurrence downwards. J_s' = J_(s+1); J_s -> +oo
    as T -> +oo; J_s(-x) x^(s+1) -> Gamma(s + 1) as x -> +oo (Watson's lemma, with remainder). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit GammaFunction LaplaceIntegral
  ImproperIntegral Family CompliantKernel.
Open Scope R_scope.

Definition ok (s : R) : Prop := forall k : nat, s + INR k <> -1.

Lemma ok_S s : ok s -> ok (s + 1).
Proof. intros H k Hk. apply (H (S k)). rewrite S_INR; lra. Qed.

Lemma ok_plus s n : ok s -> ok (s + INR n).
Proof. intros H k Hk. apply (H (n + k)%nat). rewrite plus_INR; lra. Qed.

Lemma ok_pos s : -1 < s -> ok s.
Proof. intros H k Hk. generalize (pos_INR k); lra. Qed.

Lemma ok_neq s : ok s -> s + 1 <> 0.
Proof. intros H. specialize (H 0%nat). simpl in H. lra. Qed.

Lemma ok_not_nat b : not_nat b -> ok (- b - 1).
Proof. intros H k Hk. apply (H k). lra. Qed.

(** The moment recurrence solved for the lowest index: continues I_s to s < -1. *)
Fixpoint Jn (n : nat) (e s t : R) : R :=
  match n with
  | O => Ie e s t
  | S n => - ((s + 2 + t) * Jn n e (s + 1) t + t * Jn n e (s + 2) t
              - 2 / e * Jn n e (s + 3) t - 1 / e * Jn n e (s + 4) t) / (s + 1)
  end.

Definition Je (e s t : R) : R := Jn (Z.to_nat (up (- s - 1))) e s t.

Section Slow.
Variable e : R.
Hypothesis He : 0 < e.

Lemma ok2 s : ok s -> ok (s + 2).
Proof. intros H. apply (ok_plus s 2) in H. simpl in H. exact H. Qed.

Lemma ok3 s : ok s -> ok (s + 3).
Proof. intros H. replace (s + 3) with (s + 2 + 1) by ring. apply ok_S, ok2, H. Qed.

Lemma ok4 s : ok s -> ok (s + 4).
Proof. intros H. replace (s + 4) with (s + 3 + 1) by ring. apply ok_S, ok3, H. Qed.

Lemma Jn_S n : forall s t, ok s -> -1 < s + INR n -> Jn (S n) e s t = Jn n e s t.
Proof.
induction n as [|n IH]; intros s t Hs Hn.
- simpl in Hn. simpl. assert (H := Ie_recurrence e s t He ltac:(lra)).
  assert (H1 := ok_neq s Hs).
  apply (Rmult_eq_reg_l (s + 1)); auto.
  match goal with |- _ * (- ?X / _) = _ => replace ((s + 1) * (- X / (s + 1))) with (- X)
    by (field; split; lra || (repeat split; lra)) end.
  lra.
- rewrite S_INR in Hn.
  change (- ((s + 2 + t) * Jn (S n) e (s + 1) t + t * Jn (S n) e (s + 2) t
              - 2 / e * Jn (S n) e (s + 3) t - 1 / e * Jn (S n) e (s + 4) t) / (s + 1)
   = - ((s + 2 + t) * Jn n e (s + 1) t + t * Jn n e (s + 2) t
              - 2 / e * Jn n e (s + 3) t - 1 / e * Jn n e (s + 4) t) / (s + 1)).
  rewrite (IH (s + 1)), (IH (s + 2)), (IH (s + 3)), (IH (s + 4));
    first [reflexivity | apply ok_S; exact Hs | apply ok2; exact Hs | apply ok3; exact Hs | apply ok4; exact Hs | lra].
Qed.

Lemma Jn_le n m s t : ok s -> -1 < s + INR n -> (n <= m)%nat -> Jn m e s t = Jn n e s t.
Proof.
intros Hs Hn Hm. induction Hm as [|m Hm IH]; auto.
rewrite Jn_S; auto. apply le_INR in Hm. lra.
Qed.

Lemma Je_n n s t : ok s -> -1 < s + INR n -> Je e s t = Jn n e s t.
Proof.
intros Hs Hn. unfold Je. set (N := Z.to_nat (up (- s - 1))).
assert (HN : -1 < s + INR N).
{ destruct (archimed (- s - 1)) as [H1 H2].
  assert (H3 : (up (- s - 1) <= Z.of_nat N)%Z) by (unfold N; lia).
  apply IZR_le in H3. rewrite <- INR_IZR_INZ in H3. lra. }
destruct (Nat.le_ge_cases n N) as [H|H].
- apply Jn_le; auto.
- symmetry; apply Jn_le; auto.
Qed.

Lemma ex_valid s : exists n : nat, -1 < s + INR n.
Proof.
destruct (archimed (- s - 1)) as [H1 _].
exists (Z.to_nat (up (- s - 1))).
assert (H3 : (up (- s - 1) <= Z.of_nat (Z.to_nat (up (- s - 1))))%Z) by lia.
apply IZR_le in H3. rewrite <- INR_IZR_INZ in H3. lra.
Qed.

Theorem Je_Ie s t : -1 < s -> Je e s t = Ie e s t.
Proof. intros Hs. rewrite (Je_n 0); auto. apply ok_pos, Hs. simpl; lra. Qed.

Lemma Je_solved s t : ok s ->
  Je e s t = - ((s + 2 + t) * Je e (s + 1) t + t * Je e (s + 2) t
              - 2 / e * Je e (s + 3) t - 1 / e * Je e (s + 4) t) / (s + 1).
Proof.
intros Hs. destruct (ex_valid s) as [n Hn].
rewrite (Je_n (S n) s) by (auto; rewrite S_INR; lra).
rewrite (Je_n n (s + 1)), (Je_n n (s + 2)), (Je_n n (s + 3)), (Je_n n (s + 4));
  first [reflexivity | apply ok_S; exact Hs | apply ok2; exact Hs | apply ok3; exact Hs | apply ok4; exact Hs | lra].
Qed.

Theorem Je_recurrence s t : ok s ->
  (s + 1) * Je e s t + (s + 2 + t) * Je e (s + 1) t + t * Je e (s + 2) t
   - 2 / e * Je e (s + 3) t - 1 / e * Je e (s + 4) t = 0.
Proof.
intros Hs. rewrite (Je_solved s t Hs). assert (H := ok_neq s Hs). field; lra.
Qed.

Lemma Je_derive_aux n : forall s t, ok s -> -1 < s + INR n -> is_derive (Je e s) t (Je e (s + 1) t).
Proof.
induction n as [|n IH]; intros s t Hs Hn.
- simpl in Hn. rewrite Je_Ie by lra.
  apply (is_derive_ext_loc (Ie e s)).
  { exists (mkposreal 1 Rlt_0_1). intros y _. symmetry. apply Je_Ie. lra. }
  apply Ie_derive; auto; lra.
- rewrite S_INR in Hn.
  apply (is_derive_ext (fun t => / (s + 1) * - ((s + 2 + t) * Je e (s + 1) t + t * Je e (s + 2) t
              - 2 / e * Je e (s + 3) t - 1 / e * Je e (s + 4) t))).
  { intros u. rewrite (Je_solved s u Hs). unfold Rdiv.
    match goal with |- ?a = ?b => change (@eq R a b) end. apply Rmult_comm. }
  assert (H1 := IH (s + 1) t (ok_S s Hs) ltac:(lra)).
  assert (H2 := IH (s + 2) t (ok2 s Hs) ltac:(lra)).
  assert (H3 := IH (s + 3) t (ok3 s Hs) ltac:(lra)).
  assert (H4 := IH (s + 4) t (ok4 s Hs) ltac:(lra)).
  replace (s + 1 + 1) with (s + 2) in H1 by ring.
  replace (s + 2 + 1) with (s + 3) in H2 by ring.
  replace (s + 3 + 1) with (s + 4) in H3 by ring.
  replace (s + 4 + 1) with (s + 5) in H4 by ring.
  assert (HR := Je_recurrence (s + 1) t (ok_S s Hs)).
  replace (s + 1 + 1) with (s + 2) in HR by ring.
  replace (s + 1 + 2) with (s + 3) in HR by ring.
  replace (s + 1 + 3) with (s + 4) in HR by ring.
  replace (s + 1 + 4) with (s + 5) in HR by ring.
  assert (Hn1 := ok_neq s Hs).
  evar_last.
  + apply (is_derive_scal (fun t => - ((s + 2 + t) * Je e (s + 1) t + t * Je e (s + 2) t
              - 2 / e * Je e (s + 3) t - 1 / e * Je e (s + 4) t))).
    apply (is_derive_opp (fun t => (s + 2 + t) * Je e (s + 1) t + t * Je e (s + 2) t
              - 2 / e * Je e (s + 3) t - 1 / e * Je e (s + 4) t)).
    apply (is_derive_minus (fun t => (s + 2 + t) * Je e (s + 1) t + t * Je e (s + 2) t
              - 2 / e * Je e (s + 3) t) (fun t => 1 / e * Je e (s + 4) t)).
    apply (is_derive_minus (fun t => (s + 2 + t) * Je e (s + 1) t + t * Je e (s + 2) t)
              (fun t => 2 / e * Je e (s + 3) t)).
    apply (is_derive_plus (fun t => (s + 2 + t) * Je e (s + 1) t) (fun t => t * Je e (s + 2) t)).
    apply (is_derive_mult_R (fun t => s + 2 + t) (Je e (s + 1)) t 1). auto_derive; auto. exact H1.
    apply (is_derive_mult_R (fun t => t) (Je e (s + 2)) t 1). auto_derive; auto. exact H2.
    apply (is_derive_scal (Je e (s + 3))). exact H3.
    apply (is_derive_scal (Je e (s + 4))). exact H4.
  + unfold minus, plus, opp; simpl.
    apply (Rmult_eq_reg_l (s + 1)); auto.
    rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by auto. lra.
Qed.

Theorem Je_derive s t : ok s -> is_derive (Je e s) t (Je e (s + 1) t).
Proof. intros Hs. destruct (ex_valid s) as [n Hn]. apply (Je_derive_aux n); auto. Qed.

Theorem Je_derive_n s n t : ok s -> Derive_n (Je e s) n t = Je e (s + INR n) t.
Proof.
intros Hs. revert t. induction n as [|n IH]; intros t.
- simpl. rewrite Rplus_0_r; reflexivity.
- change (Derive (Derive_n (Je e s) n) t = Je e (s + INR (S n)) t).
  rewrite (Derive_ext _ (Je e (s + INR n))) by exact IH.
  rewrite S_INR, <- Rplus_assoc. apply is_derive_unique, Je_derive, ok_plus, Hs.
Qed.

Theorem Je_pos s t : -1 < s -> 0 < Je e s t.
Proof. intros Hs. rewrite Je_Ie by auto. apply Ie_pos; auto. Qed.

(** ** t -> +oo: every J_s tends to +oo *)
Lemma Je_right_aux n : forall s, ok s -> -1 < s + INR n ->
  forall M, exists T, 0 <= T /\ forall t, T <= t -> M <= Je e s t.
Proof.
assert (B : forall s, -1 < s -> exists c T, 0 < c /\ 0 <= T /\ forall t, T <= t -> c <= Je e s t).
{ intros s Hs. exists (Je e s 0), 0. split; [apply Je_pos, Hs|split; [lra|]].
  intros t Ht. destruct (Rle_lt_or_eq_dec 0 t Ht) as [H|<-]; [|lra].
  destruct (mvt_open (Je e s) (Je e (s + 1)) 0 t H
    (fun u _ => Je_derive s u (ok_pos s Hs))) as (d & Hd & E).
  assert (Hp := Je_pos (s + 1) d ltac:(lra)).
  assert (0 < Je e (s + 1) d * (t - 0)) by (apply Rmult_lt_0_compat; lra). lra. }
assert (G : forall s, ok s -> (exists c T, 0 < c /\ 0 <= T /\ forall t, T <= t -> c <= Je e (s + 1) t) ->
  forall M, exists T, 0 <= T /\ forall t, T <= t -> M <= Je e s t).
{ intros s Hs (c & T & Hc & HT & H) M.
  destruct (grow (Je e s) (Je e (s + 1)) c T (fun t => Je_derive s t Hs) Hc H M) as (T' & H1 & H2).
  exists T'. split; [lra|auto]. }
induction n as [|n IH]; intros s Hs Hn.
- simpl in Hn. apply G; auto. apply B; lra.
- rewrite S_INR in Hn. apply G; auto.
  destruct (IH (s + 1) (ok_S s Hs) ltac:(lra) 1) as (T & HT & H).
  exists 1, T. split; [lra|auto].
Qed.

Theorem Je_right s : ok s -> forall M, exists T, 0 <= T /\ forall t, T <= t -> M <= Je e s t.
Proof. intros Hs. destruct (ex_valid s) as [n Hn]. apply (Je_right_aux n); auto. Qed.

(** ** t -> -oo: Watson's lemma *)

Lemma Ie_watson s x : -1 < s -> 0 < x ->
  0 <= Rpower x (- (s + 1)) * Gamma (s + 1) - Ie e s (- x)
    <= 2 / (3 * e) * (Rpower x (- (s + 4)) * Gamma (s + 4)).
Proof.
intros Hs Hx.
assert (G0 := Gamma_scaled (s + 1) x ltac:(lra) Hx).
assert (G3 := Gamma_scaled (s + 4) x ltac:(lra) Hx).
replace (s + 1 - 1) with s in G0 by ring. replace (s + 4 - 1) with (s + 3) in G3 by ring.
assert (A := proj1 (Ie_aux e s (- x) He Hs)).
assert (B := is_RInt_gen_minus _ _ _ _ G0 A).
assert (B2 := is_RInt_gen_minus _ _ _ _ (is_RInt_gen_scal _ (2 / (3 * e)) _ G3) B).
assert (Hk : forall r, 0 < r ->
  0 <= Rpower r s * exp (- (x * r)) - ke e s (- x) r
   <= 2 / (3 * e) * (Rpower r (s + 3) * exp (- (x * r)))).
{ intros r Hr. unfold ke.
  replace (s + 3) with (s + 1 + 1 + 1) by ring. rewrite !Rpower_S by auto.
  replace (psi r / e + r * - x) with (psi r / e + - (x * r)) by ring.
  rewrite exp_plus.
  set (P := Rpower r s). assert (HP : 0 < P) by apply exp_pos.
  set (X := exp (- (x * r))). assert (HX : 0 < X) by apply exp_pos.
  assert (HPX : 0 < P * X) by (apply Rmult_lt_0_compat; auto).
  destruct (psi_bounds r ltac:(lra)) as [Q1 Q2].
  assert (Hi : 0 < / e) by (apply Rinv_0_lt_compat; auto).
  assert (E1 : exp (psi r / e) <= 1).
  { rewrite <- exp_0. apply exp_le. unfold Rdiv. nra. }
  assert (E2 : 1 - 2 * r ^ 3 / (3 * e) <= exp (psi r / e)).
  { apply Rle_trans with (1 + psi r / e); [|apply exp_ineq1_le].
    replace (2 * r ^ 3 / (3 * e)) with (2 * r ^ 3 / 3 * / e) by (field; lra). unfold Rdiv at 2. nra. }
  replace (P * X - P * (exp (psi r / e) * X)) with (P * X * (1 - exp (psi r / e))) by ring.
  replace (2 / (3 * e) * (r * (r * (r * P)) * X)) with (P * X * (2 * r ^ 3 / (3 * e))) by (field; lra).
  split.
  - apply Rmult_le_pos; lra.
  - apply Rmult_le_compat_l; lra. }
apply improper_pos in B.
2: { intros r Hr. exact (proj1 (Hk r Hr)). }
apply improper_pos in B2.
2: { intros r Hr. assert (H := proj2 (Hk r Hr)).
     unfold scal, minus, plus, opp; simpl; unfold mult; simpl. lra. }
unfold scal, minus, plus, opp in B, B2; simpl in B, B2; unfold mult in B, B2; simpl in B, B2.
lra.
Qed.

Lemma lim_inv_pow n : (0 < n)%nat -> is_lim (fun x => / x ^ n) p_infty 0.
Proof.
intros Hn. apply is_lim_spec. intros eps. assert (H := cond_pos eps).
exists (Rmax 1 (/ eps)). intros x Hx.
assert (Hx1 : 1 < x) by (eapply Rle_lt_trans; [apply Rmax_l|exact Hx]).
assert (Hx2 : / eps < x) by (eapply Rle_lt_trans; [apply Rmax_r|exact Hx]).
assert (Hx3 : 0 < x ^ n) by (apply pow_lt; lra).
rewrite Rminus_0_r, Rabs_pos_eq by (apply Rlt_le, Rinv_0_lt_compat; auto).
rewrite <- (Rinv_inv eps) by lra.
apply Rinv_lt_contravar.
- apply Rmult_lt_0_compat; auto. apply Rinv_0_lt_compat; auto.
- apply Rlt_le_trans with x; auto. destruct n as [|n]; [lia|].
  simpl. rewrite <- (Rmult_1_r x) at 1. apply Rmult_le_compat_l. lra. apply pow_R1_Rle; lra.
Qed.

Lemma Je_left_aux n : forall s, ok s -> -1 < s + INR n ->
  is_lim (fun x => Je e s (- x) * Rpower x (s + 1)) p_infty (Gamma (s + 1)).
Proof.
induction n as [|n IH]; intros s Hs Hn.
- simpl in Hn. assert (Hs1 : -1 < s) by lra. clear Hn.
  set (K := 2 / (3 * e) * Gamma (s + 4)).
  assert (HK : 0 < K).
  { apply Rmult_lt_0_compat. apply Rdiv_lt_0_compat; lra. apply Gamma_pos; lra. }
  apply (is_lim_le_le_loc (fun x => Gamma (s + 1) - K * / x ^ 3) (fun _ => Gamma (s + 1))).
  + exists 1. intros x Hx. rewrite Je_Ie by auto.
    destruct (Ie_watson s x Hs1 ltac:(lra)) as [W1 W2].
    set (X := Rpower x (s + 1)). assert (HX : 0 < X) by apply exp_pos.
    assert (E0 : Rpower x (- (s + 1)) * X = 1).
    { unfold X. rewrite <- Rpower_plus. replace (- (s + 1) + (s + 1)) with 0 by ring.
      apply Rpower_O; lra. }
    assert (E3 : Rpower x (- (s + 4)) * X = / x ^ 3).
    { unfold X. rewrite <- Rpower_plus. replace (- (s + 4) + (s + 1)) with (- INR 3) by (simpl; ring).
      rewrite Rpower_Ropp, Rpower_pow by lra. reflexivity. }
    apply (Rmult_le_compat_r X) in W1; [|lra].
    apply (Rmult_le_compat_r X) in W2; [|lra].
    rewrite Rmult_0_l in W1.
    replace ((Rpower x (- (s + 1)) * Gamma (s + 1) - Ie e s (- x)) * X)
      with (Gamma (s + 1) * (Rpower x (- (s + 1)) * X) - Ie e s (- x) * X) in W1, W2 by ring.
    replace (2 / (3 * e) * (Rpower x (- (s + 4)) * Gamma (s + 4)) * X)
      with (K * (Rpower x (- (s + 4)) * X)) in W2 by (unfold K; ring).
    rewrite E0 in W1, W2. rewrite E3 in W2. lra.
  + replace (Finite (Gamma (s + 1))) with (Finite (Gamma (s + 1) - K * 0)) by (f_equal; ring).
    apply is_lim_minus'. apply is_lim_const.
    apply (is_lim_scal_l _ K p_infty 0), lim_inv_pow. lia.
  + apply is_lim_const.
- rewrite S_INR in Hn.
  assert (L1 := IH (s + 1) (ok_S s Hs) ltac:(lra)).
  assert (L2 := IH (s + 2) (ok2 s Hs) ltac:(lra)).
  assert (L3 := IH (s + 3) (ok3 s Hs) ltac:(lra)).
  assert (L4 := IH (s + 4) (ok4 s Hs) ltac:(lra)).
  assert (N := ok_neq s Hs).
  set (f := fun k x => Je e (s + k) (- x) * Rpower x (s + k + 1)) in *.
  apply (is_lim_ext_loc (fun x => / (s + 1) *
     (f 1 x - (s + 2) * (f 1 x * / x ^ 1) + f 2 x * / x ^ 1 + 2 / e * (f 3 x * / x ^ 3) + 1 / e * (f 4 x * / x ^ 4)))).
  { exists 1. intros x Hx. rewrite (Je_solved s (- x) Hs). unfold f.
    replace (s + 4 + 1) with (s + 1 + 1 + 1 + 1 + 1) by ring.
    replace (s + 3 + 1) with (s + 1 + 1 + 1 + 1) by ring.
    replace (s + 2 + 1) with (s + 1 + 1 + 1) by ring.
    rewrite !(Rpower_S _ x) by lra. field. repeat split; lra. }
  replace (Gamma (s + 1)) with (/ (s + 1) *
    (Gamma (s + 1 + 1) - (s + 2) * (Gamma (s + 1 + 1) * 0) + Gamma (s + 2 + 1) * 0
     + 2 / e * (Gamma (s + 3 + 1) * 0) + 1 / e * (Gamma (s + 4 + 1) * 0))).
  2: { rewrite (Gamma_rec (s + 1)) by auto. field. lra. }
  assert (M : forall k m l, (0 < m)%nat -> is_lim (f k) p_infty (Finite l) -> is_lim (fun x => f k x * / x ^ m) p_infty
    (l * 0)).
  { intros k m l Hm Hl. apply (is_lim_mult _ (fun x => / x ^ m) p_infty l 0); [exact Hl| |exact I].
    apply lim_inv_pow, Hm. }
  apply (is_lim_scal_l _ (/ (s + 1)) p_infty (Finite (Gamma (s + 1 + 1) - (s + 2) * (Gamma (s + 1 + 1) * 0)
     + Gamma (s + 2 + 1) * 0 + 2 / e * (Gamma (s + 3 + 1) * 0) + 1 / e * (Gamma (s + 4 + 1) * 0)))).
  apply is_lim_plus'. apply is_lim_plus'. apply is_lim_plus'. apply is_lim_minus'.
  + exact L1.
  + apply (is_lim_scal_l _ (s + 2) p_infty (Finite (Gamma (s + 1 + 1) * 0))), M; auto.
  + apply M; auto.
  + apply (is_lim_scal_l _ (2 / e) p_infty (Finite (Gamma (s + 3 + 1) * 0))), M; auto.
  + apply (is_lim_scal_l _ (1 / e) p_infty (Finite (Gamma (s + 4 + 1) * 0))), M; auto.
Qed.

Theorem Je_left s : ok s ->
  is_lim (fun x => Je e s (- x) * Rpower x (s + 1)) p_infty (Gamma (s + 1)).
Proof. intros Hs. destruct (ex_valid s) as [n Hn]. apply (Je_left_aux n); auto. Qed.

End Slow.
