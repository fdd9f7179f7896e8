(** * Growth block by block

    The components of a vector fall into blocks; each block has its Euclidean length. Let z' = B(t) z + D(t), and let
    w(t) be affine with w_j' >= sum_k M_jk w_k + d_j, where M_jk bounds block jk of B for j <> k, M_jj the symmetric
    part of block jj, and d_j the length of block j of D. If the length of each block is at most w at t = 0, then so it
    is up to t = 1 ([block_growth]): Theorem N1' of proofs/run_certificate.md on one part of a piece. Lengths after a
    change of basis, Theorem N2, are [within_total] and [within_gram].

    Plan of [block_growth]: the same for w + m e^(L t), m > 0 small, whose derivative is strictly larger than what the
    equation allows. Where a length would reach it first, the square of the bound less the square of the length would be
    0 with a positive derivative, so it was negative before. At last m tends to 0. *)

From Coq Require Import Reals Psatz Lra Lia List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus NonnegativeOrthant StatementStep LogarithmicNorm.
Import ListNotations.
Open Scope R_scope.

Lemma square_le x y : x ^ 2 <= y ^ 2 -> 0 <= y -> x <= y.
Proof. intros H Hy. apply Rsqr_incr_0_var; auto. unfold Rsqr. lra. Qed.

Section Blocks.
Context {I : Type}.
Variables (all : list I) (member : I -> I -> bool).
Hypothesis Hall : forall i, In i all.

(** Block k of a vector. *)
Definition part (k : I) (v : I -> R) (i : I) : R := if member k i then v i else 0.

Hypothesis Hpart : forall g, total all (fun k => total all (part k g)) = total all g.

Definition square (j : I) (v : I -> R) : R := total all (fun i => part j v i ^ 2).

(** The length of block j is at most r. *)
Definition within (j : I) (v : I -> R) (r : R) : Prop := 0 <= r /\ square j v <= r ^ 2.

Lemma total_nonneg (l : list I) g : (forall i, 0 <= g i) -> 0 <= total l g.
Proof. intros H. rewrite <- (total_zero l). apply total_le, H. Qed.

Lemma part_plus k v v' i : part k (fun i => v i + v' i) i = part k v i + part k v' i.
Proof. unfold part. destruct member; ring. Qed.

Lemma cauchy_schwarz (l : list I) (a b : I -> R) :
  total l (fun i => a i * b i) ^ 2 <= total l (fun i => a i ^ 2) * total l (fun i => b i ^ 2).
Proof.
induction l as [|i r IH]. simpl; lra.
assert (Cons : forall g, total (i :: r) g = g i + total r g) by reflexivity.
rewrite !Cons.
assert (PA : 0 <= total r (fun i => a i ^ 2)) by (apply total_nonneg; intros; apply pow2_ge_0).
assert (PB : 0 <= total r (fun i => b i ^ 2)) by (apply total_nonneg; intros; apply pow2_ge_0).
set (C := total r (fun i => a i * b i)) in *. set (A := total r (fun i => a i ^ 2)) in *.
set (B := total r (fun i => b i ^ 2)) in *. set (x := a i). set (y := b i).
assert (K : 2 * (C * (x * y)) <= A * y ^ 2 + B * x ^ 2).
{ apply square_le.
  - apply Rle_trans with (4 * (A * B) * (x * y) ^ 2).
    + replace ((2 * (C * (x * y))) ^ 2) with (4 * C ^ 2 * (x * y) ^ 2) by ring.
      apply Rmult_le_compat_r. apply pow2_ge_0. lra.
    + assert (Q := pow2_ge_0 (A * y ^ 2 - B * x ^ 2)). lra.
  - assert (0 <= A * y ^ 2) by (apply Rmult_le_pos; auto using pow2_ge_0).
    assert (0 <= B * x ^ 2) by (apply Rmult_le_pos; auto using pow2_ge_0). lra. }
replace ((x * y + C) ^ 2) with (C ^ 2 + 2 * (C * (x * y)) + x ^ 2 * y ^ 2) by ring.
replace ((x ^ 2 + A) * (y ^ 2 + B)) with (A * B + (A * y ^ 2 + B * x ^ 2) + x ^ 2 * y ^ 2) by ring. lra.
Qed.

Lemma square_nonneg j v : 0 <= square j v.
Proof. apply total_nonneg. intros. apply pow2_ge_0. Qed.

Lemma within_inner j v v' r r' : within j v r -> within j v' r' ->
  total all (fun i => part j v i * part j v' i) <= r * r'.
Proof.
intros [R0 H] [R0' H']. apply square_le; [|apply Rmult_le_pos; auto].
eapply Rle_trans. apply cauchy_schwarz. rewrite Rpow_mult_distr.
apply Rmult_le_compat; auto; apply square_nonneg.
Qed.

Lemma within_ext j v v' r : (forall i, v i = v' i) -> within j v r -> within j v' r.
Proof.
intros E [R0 H]. split; auto. unfold square.
rewrite (total_ext all _ (fun i => part j v i ^ 2)). exact H. intros i. unfold part. rewrite E. reflexivity.
Qed.

Lemma within_le j v r r' : r <= r' -> within j v r -> within j v r'.
Proof. intros Hr [R0 H]. split. lra. apply Rle_trans with (1 := H), pow_incr. lra. Qed.

Lemma within_plus j v v' r r' : within j v r -> within j v' r' -> within j (fun i => v i + v' i) (r + r').
Proof.
intros H H'. assert (C := within_inner j v v' r r' H H'). destruct H as [R0 H], H' as [R0' H']. split. lra.
unfold square in *.
rewrite (total_ext all _ (fun i => part j v i ^ 2 + part j v' i ^ 2 + 2 * (part j v i * part j v' i))).
- rewrite !total_plus, total_scal. lra.
- intros i. rewrite part_plus. ring.
Qed.

Lemma within_total j (l : list I) (f : I -> I -> R) r : (forall k, within j (f k) (r k)) ->
  within j (fun i => total l (fun k => f k i)) (total l r).
Proof.
intros H. induction l as [|k l IH]; simpl.
- split. lra. unfold square. rewrite (total_ext all _ (fun _ => 0)). rewrite total_zero. lra.
  intros i. unfold part. destruct member; ring.
- apply (within_plus j (f k) (fun i => total l (fun k => f k i))); auto.
Qed.

(** Bounds of all components bound the length. *)
Lemma within_sizes j v (s : I -> R) r : (forall i, member j i = true -> Rabs (v i) <= s i) -> 0 <= r ->
  total all (fun i => part j s i ^ 2) <= r ^ 2 -> within j v r.
Proof.
intros H R0 S. split; auto. apply Rle_trans with (2 := S), total_le. intros i. unfold part.
destruct (member j i) eqn:E; [|lra]. apply pow_maj_Rabs, H, E.
Qed.

Lemma within_component j v r i : In i all -> member j i = true -> within j v r -> Rabs (v i) <= r.
Proof.
intros Hi E [R0 H]. apply square_le; auto. rewrite pow2_abs. apply Rle_trans with (2 := H).
assert (T := total_le_but_one all (fun _ => 0) (fun l => part j v l ^ 2) i (v i ^ 2) Hi
  (fun l => pow2_ge_0 _)).
rewrite total_zero in T. enough (0 <= square j v - v i ^ 2) by lra. apply T. unfold part. rewrite E. lra.
Qed.

(** The blocks of a product with a matrix. *)
Lemma by_blocks (G : I -> I -> R) v i :
  total all (fun k => total all (fun l => G i l * part k v l)) = total all (fun l => G i l * v l).
Proof.
rewrite <- (Hpart (fun l => G i l * v l)). apply total_ext. intros k. apply total_ext. intros l. unfold part.
destruct member; ring.
Qed.

(** One block, by the sum of the squares of its entries. *)
Lemma within_entries j k (B C : I -> I -> R) v r M : within k v r -> 0 <= M ->
  (forall i l, Rabs (B i l) <= C i l) -> total all (fun i => part j (fun i => total all (fun l => part k (C i) l ^ 2))
    i)
    <= M ^ 2 ->
  within j (fun i => total all (fun l => B i l * part k v l)) (M * r).
Proof.
intros [R0 H] M0 HC HM. split. { apply Rmult_le_pos; auto. }
unfold square. rewrite Rpow_mult_distr.
apply Rle_trans with (total all (fun i => part j (fun i => total all (fun l => part k (C i) l ^ 2)) i) * r ^ 2).
2: { apply Rmult_le_compat_r; auto. apply pow2_ge_0. }
rewrite Rmult_comm, <- total_scal. apply total_le. intros i. unfold part at 1 3. destruct (member j i); [|lra].
rewrite (total_ext all (fun l => B i l * part k v l) (fun l => part k (B i) l * part k v l)).
2: { intros l. unfold part. destruct member; ring. }
eapply Rle_trans. apply cauchy_schwarz. rewrite Rmult_comm.
apply Rmult_le_compat; auto. apply square_nonneg. apply total_nonneg; intros; apply pow2_ge_0.
apply total_le. intros l. unfold part. destruct member; [|lra]. apply pow_maj_Rabs, HC.
Qed.

(** Twice a sum of products with a symmetric matrix is at most the sum of its row sums times squares. *)
Lemma symmetric_sum (H : I -> I -> R) (v : I -> R) : (forall a b, H a b = H b a) -> (forall a b, 0 <= H a b) ->
  total all (fun a => total all (fun b => H a b * ((v a ^ 2 + v b ^ 2) / 2)))
    = total all (fun a => v a ^ 2 * total all (H a)).
Proof.
intros S P. set (X := total all (fun a => v a ^ 2 * total all (H a))).
assert (E1 : total all (fun a => total all (fun b => H a b * v a ^ 2)) = X).
{ apply total_ext. intros a. rewrite <- total_scal. apply total_ext. intros; ring. }
assert (E2 : total all (fun a => total all (fun b => H a b * v b ^ 2)) = X).
{ rewrite (total_swap all all (fun a b => H a b * v b ^ 2)). rewrite <- E1. apply total_ext. intros a.
  apply total_ext. intros b. rewrite S. ring. }
transitivity (/ 2 * (total all (fun a => total all (fun b => H a b * v a ^ 2))
  + total all (fun a => total all (fun b => H a b * v b ^ 2)))).
- rewrite <- total_plus, <- total_scal. apply total_ext. intros a. rewrite <- total_plus, <- total_scal.
  apply total_ext. intros b. field.
- rewrite E1, E2. field.
Qed.

Lemma product_le h a b : h * (a * b) <= Rabs h * ((a ^ 2 + b ^ 2) / 2).
Proof.
eapply Rle_trans. apply Rle_abs. rewrite Rabs_mult. apply Rmult_le_compat_l. apply Rabs_pos.
assert (P := pow2_ge_0 (a - b)). assert (Q := pow2_ge_0 (a + b)). apply Rabs_le. lra.
Qed.

(** The block on the diagonal, by Gershgorin's discs of its symmetric part. *)
Lemma diagonal_block j (B : I -> I -> R) v m :
  (forall i, member j i = true -> B i i - Rabs (B i i) + total all (part j (fun l => Rabs (B i l + B l i))) / 2 <= m) ->
  total all (fun i => part j v i * total all (fun l => B i l * part j v l)) <= m * square j v.
Proof.
intros Hm. set (s := fun i l => if member j i then part j (fun l => B i l + B l i) l / 2 else 0).
assert (Sym : forall a b, s a b = s b a).
{ intros a b. unfold s, part. destruct (member j a), (member j b); lra. }
assert (E : total all (fun i => part j v i * total all (fun l => B i l * part j v l))
  = total all (fun i => total all (fun l => s i l * (part j v i * part j v l)))).
{ set (X := total all (fun i => part j v i * total all (fun l => B i l * part j v l))).
  assert (E1 : total all (fun i => total all (fun l => B i l * (part j v i * part j v l))) = X).
  { apply total_ext. intros i. rewrite <- total_scal. apply total_ext. intros; ring. }
  assert (E2 : total all (fun i => total all (fun l => B l i * (part j v i * part j v l))) = X).
  { rewrite (total_swap all all (fun i l => B l i * (part j v i * part j v l))). rewrite <- E1.
    apply total_ext. intros i. apply total_ext. intros l. ring. }
  transitivity (/ 2 * (total all (fun i => total all (fun l => B i l * (part j v i * part j v l)))
    + total all (fun i => total all (fun l => B l i * (part j v i * part j v l))))).
  - rewrite E1, E2. field.
  - rewrite <- total_plus, <- total_scal. apply total_ext. intros i. rewrite <- total_plus, <- total_scal.
    apply total_ext. intros l. unfold s, part. destruct (member j i), (member j l); field. }
rewrite E. clear E.
apply Rle_trans with (total all (fun i => total all (fun l => Rabs (s i l) * ((part j v i ^ 2 + part j v l ^ 2) / 2))
  - (Rabs (s i i) - s i i) * part j v i ^ 2)).
- apply total_le. intros i. apply (total_le_but_one all _ _ i); auto.
  + intros l. apply product_le.
  + right. field.
- rewrite total_minus, (symmetric_sum (fun a b => Rabs (s a b))).
  2: { intros. f_equal. apply Sym. }
  2: { intros. apply Rabs_pos. }
  rewrite <- total_minus. unfold square. rewrite <- total_scal. apply total_le. intros i.
  unfold part at 1 2 3. destruct (member j i) eqn:Ei; [|lra].
  replace (v i ^ 2 * total all (fun b => Rabs (s i b)) - (Rabs (s i i) - s i i) * v i ^ 2)
    with ((s i i - Rabs (s i i) + total all (fun b => Rabs (s i b))) * v i ^ 2) by ring.
  apply Rmult_le_compat_r. apply pow2_ge_0. apply Rle_trans with (2 := Hm i Ei).
  assert (D : s i i = B i i) by (unfold s, part; rewrite Ei; field). rewrite D.
  apply Rplus_le_compat_l. right. unfold Rdiv. rewrite Rmult_comm, <- total_scal. apply total_ext. intros l.
  unfold s, part. rewrite Ei. destruct (member j l).
  + unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra. ring.
  + unfold Rdiv. rewrite Rmult_0_l, Rabs_R0. ring.
Qed.

(** What z' = B z + D allows where the length of block j is its bound. *)
Lemma inner_rate (B C M : I -> I -> R) (d r z D : I -> R) j : (forall k, {j = k} + {j <> k}) ->
  (forall i l, Rabs (B i l) <= C i l) ->
  (forall i, member j i = true ->
    B i i - Rabs (B i i) + total all (part j (fun l => Rabs (B i l + B l i))) / 2 <= M j j) ->
  (forall k, j <> k -> 0 <= M j k /\
    total all (fun i => part j (fun i => total all (fun l => part k (C i) l ^ 2)) i) <= M j k ^ 2) ->
  within j D (d j) -> (forall k, within k z (r k)) -> square j z = r j ^ 2 ->
  total all (fun i => part j z i * part j (fun i => total all (fun l => B i l * z l) + D i) i)
    <= r j * (total all (fun k => M j k * r k) + d j).
Proof.
intros Dec HC Hdiag Hoff HD Hz Hj.
set (y := fun k i => total all (fun l => B i l * part k z l)).
assert (E : forall i, part j (fun i => total all (fun l => B i l * z l) + D i) i
  = total all (fun k => part j (y k) i) + part j D i).
{ intros i. rewrite part_plus. f_equal. unfold part at 1 2. destruct (member j i).
  - symmetry. apply (by_blocks B z i).
  - rewrite total_zero. reflexivity. }
rewrite (total_ext all _ (fun i => total all (fun k => part j z i * part j (y k) i) + part j z i * part j D i)).
2: { intros i. rewrite E, total_scal. ring. }
rewrite total_plus, total_swap, Rmult_plus_distr_l, <- total_scal.
apply Rplus_le_compat; [|apply within_inner; auto].
apply total_le. intros k. destruct (Dec k) as [<-|N].
- apply Rle_trans with (M j j * square j z).
  2: { rewrite Hj. right. ring. }
  rewrite (total_ext all _ (fun i => part j z i * y j i)). { apply diagonal_block, Hdiag. }
  intros i. unfold part. destruct (member j i); ring.
- apply (within_inner j z (y k) (r j) (M j k * r k)); auto. destruct (Hoff k N) as [M0 HM].
  apply (within_entries j k B C z (r k) (M j k)); auto.
Qed.

(** ** The comparison *)
Section Growth.
Variables (x x' : I -> R -> R) (M : I -> I -> R) (d u v : I -> R).
Hypothesis Hu : forall j, 0 < u j.
Hypothesis Hv : forall j, 0 < v j.
Hypothesis Hderive : forall i t, 0 <= t <= 1 -> is_derive (x i) t (x' i t).
(** What the equation allows where a length has reached its bound. *)
Hypothesis Hinner : forall t, 0 <= t <= 1 -> forall r, (forall k, within k (fun i => x i t) (r k)) -> forall j,
  square j (fun i => x i t) = r j ^ 2 ->
  total all (fun i => part j (fun i => x i t) i * part j (fun i => x' i t) i) <= r j * (total all (fun k => M j k * r k)
    + d j).
Hypothesis Hleft : forall j, total all (fun k => M j k * u k) + d j <= v j - u j.
Hypothesis Hright : forall j, total all (fun k => M j k * v k) + d j <= v j - u j.
Hypothesis Hstart : forall j, within j (fun i => x i 0) (u j).

Definition bound (j : I) (t : R) : R := u j + t * (v j - u j).

Lemma bound_pos j t : 0 <= t <= 1 -> 0 < bound j t.
Proof.
intros Ht. assert (P := Hu j). assert (Q := Hv j). unfold bound.
replace (u j + t * (v j - u j)) with ((1 - t) * u j + t * v j) by ring.
destruct (Req_dec t 0) as [->|N]. lra.
assert (0 < t * v j) by (apply Rmult_lt_0_compat; lra).
assert (0 <= (1 - t) * u j) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma bound_rises j t : 0 <= t <= 1 -> total all (fun k => M j k * bound k t) + d j <= v j - u j.
Proof.
intros Ht. assert (L := Hleft j). assert (R := Hright j).
rewrite (total_ext all _ (fun k => (1 - t) * (M j k * u k) + t * (M j k * v k))) by (intros; unfold bound; ring).
rewrite total_plus, !total_scal.
assert (A := Rmult_le_compat_l (1 - t) _ _ ltac:(lra) L). assert (B := Rmult_le_compat_l t _ _ ltac:(lra) R). lra.
Qed.

Section Above.
Variable m : R.
Hypothesis Hm : 0 < m.
Let L := total all (fun j => total all (fun k => Rabs (M j k))) + 1.
Let phi j t := bound j t + m * exp (L * t).
Definition room (j : I) (t : R) : R := phi j t ^ 2 - square j (fun i => x i t).
Let room' j t := 2 * phi j t * (v j - u j + m * (L * exp (L * t)))
  - 2 * total all (fun i => part j (fun i => x i t) i * part j (fun i => x' i t) i).

Lemma row_below j : total all (M j) < L.
Proof.
unfold L. apply Rle_lt_trans with (total all (fun j => total all (fun k => Rabs (M j k)))); [|lra].
apply Rle_trans with (total all (fun k => Rabs (M j k))). { apply total_le. intros k. apply Rle_abs. }
assert (T := total_le_but_one all (fun _ => 0) (fun j => total all (fun k => Rabs (M j k))) j
  (total all (fun k => Rabs (M j k))) (Hall j)). simpl in T. rewrite total_zero in T.
enough (0 <= total all (fun j => total all (fun k => Rabs (M j k))) - total all (fun k => Rabs (M j k))) by lra.
apply T. intros i. apply total_nonneg. intros. apply Rabs_pos. lra.
Qed.

Lemma phi_pos j t : 0 <= t <= 1 -> 0 < phi j t.
Proof.
intros Ht. unfold phi. assert (P := bound_pos j t Ht). assert (0 < m * exp (L * t)).
{ apply Rmult_lt_0_compat; auto. apply exp_pos. } lra.
Qed.

Lemma room_derive j t : 0 <= t <= 1 -> is_derive (room j) t (room' j t).
Proof.
intros Ht. unfold room, room', square.
apply (is_derive_minus (fun t => phi j t ^ 2) (fun t => total all (fun i => part j (fun i => x i t) i ^ 2))).
- unfold phi, bound. auto_derive; auto. ring.
- rewrite <- total_scal.
  apply (total_derive all (fun i t => part j (fun i => x i t) i ^ 2)
    (fun i t => 2 * (part j (fun i => x i t) i * part j (fun i => x' i t) i))).
  intros i. unfold part. destruct member.
  + eapply is_derive_val. apply (is_derive_pow (x i) 2 t), Hderive, Ht. simpl. ring.
  + eapply is_derive_val. apply (is_derive_const (0 ^ 2)). unfold zero; simpl. ring.
Qed.

Lemma room_inward j t : 0 <= t <= 1 -> (forall k, 0 <= room k t) -> room j t = 0 -> 0 < room' j t.
Proof.
intros Ht H E. assert (P := phi_pos j t Ht).
assert (W : forall k, within k (fun i => x i t) (phi k t)).
{ intros k. split. apply Rlt_le, phi_pos, Ht. specialize (H k). unfold room in H. lra. }
assert (N := Hinner t Ht (fun k => phi k t) W j ltac:(unfold room in E; lra)). simpl in N.
assert (B : total all (fun k => M j k * phi k t) + d j < v j - u j + m * (L * exp (L * t))).
{ unfold phi.
  rewrite (total_ext all _ (fun k => M j k * bound k t + m * exp (L * t) * M j k)) by (intros; ring).
  rewrite total_plus, total_scal. assert (Q := bound_rises j t Ht).
  assert (m * exp (L * t) * total all (M j) < m * exp (L * t) * L).
  { apply Rmult_lt_compat_l. apply Rmult_lt_0_compat; auto. apply exp_pos. apply row_below. } lra. }
apply (Rmult_lt_compat_l (phi j t)) in B; auto. unfold room'. lra.
Qed.

Lemma room_continues (l : list I) t : 0 <= t <= 1 -> (forall j, 0 < room j t) ->
  exists e, 0 < e /\ forall t', t <= t' < t + e -> forall j, In j l -> 0 < room j t'.
Proof.
intros Ht H.
assert (Q : locally t (fun t' => forall j, In j l -> 0 < room j t')).
{ induction l as [|j r IH]. { apply filter_forall. intros t' i []. }
  generalize (filter_and _ _ (continuous_pos (room j) t (ex_intro _ _ (room_derive j t Ht)) (H j)) IH).
  apply filter_imp. intros t' [O R] i [<-|Hi]; auto. }
destruct Q as [e He]. exists e. split. apply cond_pos.
intros t' Ht'. apply He. apply (Rabs_lt_between (t' - t) e). destruct Ht'. assert (D := cond_pos e). lra.
Qed.

Lemma stays_inside : forall t, 0 <= t -> t <= 1 -> forall j, 0 < room j t.
Proof.
apply (real_induction (fun t => t <= 1 -> forall j, 0 < room j t) 0).
- intros _ j. unfold room, phi, bound. rewrite !Rmult_0_l, Rmult_0_r, exp_0.
  destruct (Hstart j) as [_ S]. assert (P := Hu j).
  replace ((u j + 0 + m * 1) ^ 2) with (u j ^ 2 + (2 * (u j * m) + m * m)) by ring.
  assert (0 < u j * m) by (apply Rmult_lt_0_compat; auto).
  assert (0 < m * m) by (apply Rmult_lt_0_compat; auto). lra.
- intros t Ht H. destruct (Rlt_dec t 1) as [Hlt|Hlt].
  + destruct (room_continues all t ltac:(lra)) as (e & He & C). { intros j. apply H; lra. }
    exists e. split; auto.
  + exists 1. split. lra. intros t' Ht' Hle j. replace t' with t by lra. apply H; lra.
- intros t Ht H Hle.
  assert (G : forall j, 0 <= room j t).
  { intros j. apply (closed_ge (room j) 0 t 0 Ht). eexists. apply room_derive; lra.
    intros t' Ht'. apply Rlt_le, H; lra. }
  intros j. destruct (Rle_lt_or_eq_dec _ _ (G j)) as [|E]; auto. exfalso.
  destruct (derive_pos_before (room j) t _ (room_derive j t ltac:(lra)) (eq_sym E)) as (e & He & N).
  { apply room_inward; auto. lra. }
  set (t' := Rmax 0 (t - e / 2)).
  assert (T1 : 0 <= t') by apply Rmax_l. assert (T2 : t - e / 2 <= t') by apply Rmax_r.
  assert (T3 : t' < t) by (unfold t', Rmax; destruct Rle_dec; lra).
  specialize (H t' ltac:(lra) ltac:(lra) j). specialize (N t' ltac:(lra)). lra.
Qed.

Lemma below_the_larger t j : 0 <= t <= 1 -> within j (fun i => x i t) (bound j t + m * exp L).
Proof.
intros Ht. assert (H := stays_inside t ltac:(lra) ltac:(lra) j).
assert (L0 : 0 <= L). { unfold L. assert (Q := total_nonneg all (fun j => total all (fun k => Rabs (M j k)))).
  enough (0 <= total all (fun j => total all (fun k => Rabs (M j k)))) by lra. apply Q. intros i.
  apply total_nonneg. intros. apply Rabs_pos. }
apply within_le with (phi j t).
- unfold phi. apply Rplus_le_compat_l, Rmult_le_compat_l. lra. apply exp_le.
  rewrite <- (Rmult_1_r L) at 2. apply Rmult_le_compat_l; lra.
- split. apply Rlt_le, phi_pos, Ht. unfold room in H. lra.
Qed.

End Above.

Theorem block_growth t j : 0 <= t <= 1 -> within j (fun i => x i t) (bound j t).
Proof.
intros Ht. assert (P := bound_pos j t Ht). split. lra.
set (s := square j (fun i => x i t)). set (e := exp (total all (fun j => total all (fun k => Rabs (M j k))) + 1)).
assert (E : 0 < e) by apply exp_pos.
enough (sqrt s <= bound j t) as Hs.
{ rewrite <- (sqrt_sqrt s) by apply square_nonneg. simpl. rewrite Rmult_1_r.
  apply Rmult_le_compat; auto; apply sqrt_pos. }
apply le_epsilon. intros m Hm.
assert (B := below_the_larger (m / e) ltac:(apply Rdiv_lt_0_compat; auto) t j Ht). fold e in B.
replace (bound j t + m / e * e) with (bound j t + m) in B by (field; lra). destruct B as [B0 B].
apply square_le; auto. simpl. rewrite Rmult_1_r, sqrt_sqrt by apply square_nonneg. unfold s. lra.
Qed.

End Growth.
End Blocks.

(** One block of a matrix between two bases with their own blocks, by the row sums of G'G. *)
Lemma within_gram {I : Type} (all : list I) (member member' : I -> I -> bool) j k (G : I -> I -> R) v r N :
  within all member' k v r -> 0 <= N ->
  (forall a, member' k a = true -> total all (part member' k (fun b => Rabs (total all (part member j (fun i => G i a
    * G i b)))))
    <= N ^ 2) ->
  within all member j (fun i => total all (fun l => G i l * part member' k v l)) (N * r).
Proof.
intros [R0 Hr] N0 HN. split. { apply Rmult_le_pos; auto. }
set (H := fun a b => if member' k a then part member' k (fun b => total all (part member j (fun i => G i a * G i b)))
  b else 0).
assert (S : square all member j (fun i => total all (fun l => G i l * part member' k v l))
  = total all (fun a => total all (fun b => H a b * (part member' k v a * part member' k v b)))).
{ unfold square.
  rewrite (total_ext all _ (fun i => total all (fun a => total all (fun b =>
    part member j (fun i => G i a * G i b) i * (part member' k v a * part member' k v b))))).
  - rewrite total_swap. apply total_ext. intros a.
    rewrite (total_swap all all (fun i b => part member j (fun i => G i a * G i b) i * (part member' k v a * part
      member' k v b))).
    apply total_ext. intros b.
    rewrite (total_ext all _ (fun i => part member' k v a * part member' k v b * part member j (fun i => G i a * G i
      b) i))
      by (intros; ring).
    rewrite total_scal. unfold H, part. destruct (member' k a), (member' k b); ring.
  - intros i. unfold part at 1 3. destruct (member j i).
    + simpl pow. rewrite Rmult_1_r, <- total_scal. apply total_ext. intros a.
      rewrite Rmult_comm, <- total_scal. apply total_ext. intros b. ring.
    + rewrite (total_ext all _ (fun _ => 0)). rewrite total_zero. ring.
      intros a. rewrite (total_ext all _ (fun _ => 0)). apply total_zero. intros; ring. }
rewrite S. clear S.
apply Rle_trans with (total all (fun a => part member' k v a ^ 2 * total all (fun b => Rabs (H a b)))).
- rewrite <- (symmetric_sum all (fun a b => Rabs (H a b))).
  + apply total_le. intros a. apply total_le. intros b. apply product_le.
  + intros a b. f_equal. unfold H, part. destruct (member' k a), (member' k b); auto.
    apply total_ext. intros i. destruct member; ring.
  + intros. apply Rabs_pos.
- rewrite Rpow_mult_distr. apply Rle_trans with (N ^ 2 * square all member' k v).
  2: { apply Rmult_le_compat_l; auto. apply pow2_ge_0. }
  unfold square. rewrite <- total_scal. apply total_le. intros a. unfold part at 1 2. destruct (member' k a) eqn:Ea.
  + rewrite Rmult_comm. apply Rmult_le_compat_r. apply pow2_ge_0. apply Rle_trans with (2 := HN a Ea).
    right. apply total_ext. intros b. unfold H, part. rewrite Ea. destruct (member' k b); auto. apply Rabs_R0.
  + lra.
Qed.
