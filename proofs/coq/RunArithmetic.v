(** * The integers and polynomials of the checker of runs

    What [RunChecker.v] computes of sums, quotients and polynomials, in reals; [RunSound.v] goes on from here. *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import CompliantMotion Checker CheckerModels Calculus StatementStep LogarithmicNorm BlockGrowth
  RunChecker.
Import ListNotations.
Open Scope R_scope.

(** ** Integers and reals *)
Lemma stored_same {A} (f : vector A) i : stored f i = f i.
Proof. destruct i; reflexivity. Qed.

Lemma sum_real f : IZR (sum f) = total coordinates (fun i => IZR (f i)).
Proof. unfold sum, total, coordinates. cbn [fold_right]. rewrite !plus_IZR. reflexivity. Qed.

Lemma every_true f : every f = true -> forall i, f i = true.
Proof. unfold every. rewrite !andb_true_iff. intros (((A & B) & C) & D) [ | | | ]; auto. Qed.

Lemma same_iff i j : same i j = true <-> i = j.
Proof. destruct i, j; simpl; split; auto; discriminate. Qed.

Lemma same_not i j : i <> j -> same i j = false.
Proof. destruct i, j; simpl; auto; intros H; destruct H; auto. Qed.

Lemma decide (j k : coordinate) : {j = k} + {j <> k}.
Proof. decide equality. Qed.

Lemma lies_parts (bl : vector coordinate) g : total coordinates (fun k => total coordinates (part (lies bl) k g)) =
  total coordinates g.
Proof.
unfold part, lies, total, coordinates. cbn [fold_right].
destruct (bl of_b), (bl of_y), (bl of_v), (bl of_z); cbn [same]; ring.
Qed.

Lemma sum_over_real bl k f : IZR (sum_over bl k f) = total coordinates (part (lies bl) k (fun i => IZR (f i))).
Proof. unfold sum_over. rewrite sum_real. apply total_ext. intros i. unfold part. destruct lies; reflexivity. Qed.

Lemma up_le a d : (0 < d)%Z -> IZR a <= IZR d * IZR (up a d).
Proof.
intros Hd. rewrite <- mult_IZR. apply IZR_le. unfold up.
assert (E := Z.div_mod (- a) d ltac:(lia)). assert (M := Z.mod_pos_bound (- a) d Hd). lia.
Qed.

Lemma up_quotient a d : (0 < d)%Z -> IZR a / IZR d <= IZR (up a d).
Proof.
intros Hd. assert (D : 0 < IZR d) by (apply IZR_lt; auto). apply Rmult_le_reg_l with (IZR d); auto.
replace (IZR d * (IZR a / IZR d)) with (IZR a) by (field; lra). apply up_le, Hd.
Qed.

Lemma quotient_le a b d : 0 < d -> a <= b * d -> a / d <= b.
Proof. intros Hd H. apply Rmult_le_reg_r with d; auto. replace (a / d * d) with a by (field; lra). exact H. Qed.

Lemma quotient_abs a d : 0 < d -> Rabs (a / d) = Rabs a / d.
Proof. intros H. unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq d); lra. Qed.

(** ** Polynomials *)
Lemma value_minus t p q : value t (minus p q) = value t p - value t q.
Proof. unfold minus. rewrite value_plus, value_times. ring. Qed.

Lemma value_less t p c : value t (less p c) = value t p - IZR c.
Proof. unfold less. rewrite value_plus. simpl. rewrite opp_IZR. ring. Qed.

Lemma value_derive p t : is_derive (fun t => value t p) t (value t (derivative p)).
Proof.
induction p as [|a p IH]; [apply (is_derive_const 0)|].
cbn [derivative]. rewrite value_plus. cbn [value].
apply (is_derive_val (fun t => IZR a + t * value t p) t (0 + (1 * value t p + t * value t (derivative p)))).
- apply (is_derive_plus (fun _ => IZR a) (fun t => t * value t p)). apply (is_derive_const (IZR a)).
  apply (is_derive_mult_R (fun t => t) (fun t => value t p) t 1). apply (is_derive_id t). exact IH.
- ring.
Qed.

Lemma value_halved t p : 2 * value t (halved p) = 2 ^ length p * value (t / 2) p.
Proof.
induction p as [|a p IH]; simpl. ring.
rewrite mult_IZR, <- pow_IZR.
replace (2 * (IZR a * 2 ^ length p + t * value t (halved p)))
  with (2 * 2 ^ length p * IZR a + t * (2 * value t (halved p))) by ring.
rewrite IH. field.
Qed.

Lemma length_halved p : length (halved p) = length p.
Proof. induction p; simpl; auto. Qed.

Lemma halved_pos t p : 0 < value t (halved p) -> 0 < value (t / 2) p.
Proof.
intros H. apply Rmult_lt_reg_l with (2 ^ length p). apply pow_lt; lra. rewrite Rmult_0_r, <- value_halved. lra.
Qed.

Lemma value_shifted t p : value t (shifted p) = value (t + 1) p.
Proof.
induction p as [|a p IH]. reflexivity.
cbn [shifted value]. rewrite value_plus, value_linear, IH. simpl. ring.
Qed.

Lemma least_le t p : 0 <= t <= 1 -> IZR (least p) <= value t p.
Proof.
intros Ht. destruct p as [|a p]; simpl. lra. rewrite plus_IZR. apply Rplus_le_compat_l.
assert (H : forall p, IZR (fold_right (fun c s => (Z.min c 0 + s)%Z) 0%Z p) <= value t p
  /\ IZR (fold_right (fun c s => (Z.min c 0 + s)%Z) 0%Z p) <= 0).
{ clear p. induction p as [|c p [IH1 IH2]]; simpl. lra. rewrite plus_IZR.
  assert (C1 : IZR (Z.min c 0) <= IZR c) by (apply IZR_le; lia).
  assert (C2 : IZR (Z.min c 0) <= 0) by (apply IZR_le; lia).
  set (s := IZR (fold_right (fun c s => (Z.min c 0 + s)%Z) 0%Z p)) in *. split; [|lra].
  assert (t * s <= t * value t p) by (apply Rmult_le_compat_l; lra).
  assert (0 <= (1 - t) * - s) by (apply Rmult_le_pos; lra). lra. }
destruct (H p) as [H1 H2]. set (s := IZR (fold_right _ _ p)) in *.
assert (t * s <= t * value t p) by (apply Rmult_le_compat_l; lra).
assert (0 <= (1 - t) * - s) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma positive_right n : forall p t, positive n p = true -> 0 <= t <= 1 -> 0 < value t p.
Proof.
assert (L : forall p t, (0 <? least p)%Z = true -> 0 <= t <= 1 -> 0 < value t p).
{ intros p t H Ht. apply Z.ltb_lt in H. apply IZR_lt in H. assert (L := least_le t p Ht). lra. }
induction n as [|n IH]; intros p t H Ht; simpl in H; destruct (0 <? least p)%Z eqn:E; auto; try discriminate.
destruct (positive n (halved p)) eqn:H1; [|discriminate]. destruct (Rle_dec t (1 / 2)).
- replace t with (2 * t / 2) by field. apply halved_pos. apply IH; auto. lra.
- replace t with ((2 * t - 1 + 1) / 2) by field. apply halved_pos. rewrite <- value_shifted. apply IH; auto. lra.
Qed.

Lemma halved_many n p t : 0 < value t (Nat.iter n halved p) -> 0 < value (t / 2 ^ n) p.
Proof.
revert t. induction n as [|n IH]; intros t H.
- simpl in *. replace (t / 1) with t by field. exact H.
- simpl in H. apply halved_pos, IH in H. replace (t / 2 ^ S n) with (t / 2 / 2 ^ n); auto. simpl. field.
  apply pow_nonzero. lra.
Qed.

Lemma rounded_near ticks at_tick p : (0 < ticks)%Z -> (0 <= at_tick <= ticks)%Z ->
  Rabs (value (IZR at_tick / IZR ticks) p - IZR (rounded_value ticks at_tick p)) <= IZR (Z.of_nat (length p)).
Proof.
intros Hd Ht. assert (D : 0 < IZR ticks) by (apply IZR_lt; auto).
set (t := IZR at_tick / IZR ticks).
assert (T : Rabs t <= 1).
{ unfold t. rewrite quotient_abs, Rabs_pos_eq by (auto; apply IZR_le; lia). apply quotient_le; auto.
  rewrite Rmult_1_l. apply IZR_le. lia. }
induction p as [|a p IH]; simpl value; simpl rounded_value. { rewrite Rminus_0_r, Rabs_R0. apply IZR_le. simpl; lia. }
change (length (a :: p)) with (S (length p)). rewrite Nat2Z.inj_succ, succ_IZR, plus_IZR.
set (w := rounded_value ticks at_tick p) in *.
replace (IZR a + t * value t p - (IZR a + IZR (at_tick * w / ticks)))
  with (t * (value t p - IZR w) + (IZR (at_tick * w) / IZR ticks - IZR (at_tick * w / ticks)))
  by (rewrite mult_IZR; unfold t; field; lra).
apply Rabs_plus_le. apply times_at_most_one; auto. apply div_between, Hd.
Qed.

(** ** Sums of four terms *)
Lemma double_sum (b : coordinate -> R) (c : coordinate -> coordinate -> R) z :
  total coordinates (fun n => b n * total coordinates (fun q => c n q * z q))
    = total coordinates (fun q => total coordinates (fun n => b n * c n q) * z q).
Proof. unfold total, coordinates. cbn [fold_right]. ring. Qed.

Lemma delta_sum i x (g : coordinate -> R) :
  total coordinates (fun m => IZR (if same i m then x else 0%Z) * g m) = IZR x * g i.
Proof. destruct i; unfold total, coordinates; cbn [fold_right same]; ring. Qed.

Lemma part_scal bl k a (g : coordinate -> R) i : part (lies bl) k (fun i => a * g i) i = a * part (lies bl) k g i.
Proof. unfold part. destruct lies; ring. Qed.

Lemma part_le bl k (g g' : coordinate -> R) i : (lies bl k i = true -> g i <= g' i) ->
  part (lies bl) k g i <= part (lies bl) k g' i.
Proof. unfold part. destruct lies; auto; lra. Qed.
