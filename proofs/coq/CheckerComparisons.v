(** * The comparisons of the checker are right

    What [CheckerCertificate.v] decides of rationals, ranges, covers and far left points, said of real numbers. *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qabs Qround Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate CertificateText Checker CheckerCertificate CheckerEnclosure
  StatementChecker.
Import ListNotations.
Open Scope R_scope.

(** ** Rationals *)
Lemma Qle_bool_R p q : Qle_bool p q = true <-> Q2R p <= Q2R q.
Proof. rewrite Qle_bool_iff. split; [apply Qle_Rle|apply Rle_Qle]. Qed.

Lemma less_R p q : less p q = true <-> Q2R p < Q2R q.
Proof.
unfold less. split.
- intros H. apply Rnot_le_lt. intros L. apply Qle_bool_R in L. rewrite L in H. discriminate.
- intros H. destruct (Qle_bool q p) eqn:E; [|reflexivity]. apply Qle_bool_R in E. lra.
Qed.

Lemma Q2R_0 : Q2R 0 = 0. Proof. unfold Q2R; simpl; field. Qed.
Lemma Q2R_1 : Q2R 1 = 1. Proof. unfold Q2R; simpl; field. Qed.
Lemma Q2R_nat n : Q2R (inject_Z (Z.of_nat n)) = INR n.
Proof. rewrite Q2R_whole, <- INR_IZR_INZ. reflexivity. Qed.

Lemma edge_le_R e e' : edge_le e e' = true <-> Rbar_le (real_edge e) (real_edge e').
Proof.
destruct e as [|p|], e' as [|q|]; simpl; split; intros H; auto; try discriminate; try contradiction; apply Qle_bool_R;
  auto.
Qed.

Lemma edge_lt_R e e' : edge_lt e e' = true <-> Rbar_lt (real_edge e) (real_edge e').
Proof.
destruct e as [|p|], e' as [|q|]; simpl; split; intros H; auto; try discriminate; try contradiction; apply less_R; auto.
Qed.

Lemma edge_same_R e e' : edge_same e e' = true -> real_edge e = real_edge e'.
Proof.
unfold edge_same. intros H. apply andb_prop in H. destruct H as [A B]. apply edge_le_R in A. apply edge_le_R in B.
apply Rbar_le_antisym; auto.
Qed.

Definition real_parts (parts : list (edge * edge)) : list (Rbar * Rbar) := map (fun part =>
  (real_edge (fst part), real_edge (snd part))) parts.

Lemma covers_R parts : forall start stop, covers parts start stop = true -> cover (real_parts parts) (real_edge start)
  (real_edge stop).
Proof.
induction parts as [|[low high] rest IH]; intros start stop H; [discriminate|].
cbn [covers] in H. apply andb_prop in H. destruct H as [A B]. apply edge_le_R in A. cbn [real_parts map cover fst snd].
split; auto.
destruct rest as [|[next end_] rest'].
- simpl. apply edge_le_R, B.
- apply andb_prop in B. destruct B as [B C]. cbn [map fst snd]. split. apply edge_same_R, B. apply (IH high stop C).
Qed.

Lemma interval_holds_R r q : interval_holds r q = true <-> in_range (real_range r) (Q2R q).
Proof.
unfold interval_holds, in_range, real_range. cbn [range_from range_to closed_from closed_to].
change (Finite (Q2R q)) with (real_edge (At q)).
destruct (has_from r), (has_to r); rewrite andb_true_iff, ?edge_le_R, ?edge_lt_R; reflexivity.
Qed.

Lemma all_positive_R r x : all_positive r = true -> in_range (real_range r) x -> 0 < x.
Proof.
unfold all_positive, in_range, real_range. cbn [range_from range_to closed_from closed_to]. intros H [A _].
destruct (interval_from r) as [|q|]; try discriminate. destruct (has_from r); simpl in A.
- apply less_R in H. rewrite Q2R_0 in H. lra.
- apply Qle_bool_R in H. rewrite Q2R_0 in H. lra.
Qed.

Lemma all_negative_R r x : all_negative r = true -> in_range (real_range r) x -> x < 0.
Proof.
unfold all_negative, in_range, real_range. cbn [range_from range_to closed_from closed_to]. intros H [_ A].
destruct (interval_to r) as [|q|]; try discriminate. destruct (has_to r); simpl in A.
- apply less_R in H. rewrite Q2R_0 in H. lra.
- apply Qle_bool_R in H. rewrite Q2R_0 in H. lra.
Qed.

(** ** Pieces with real numbers *)
Definition real_piece (p : entry) : piece :=
  match p with
  | Laplace => laplace_piece | Taylor => taylor_piece | Left X => left_piece (Q2R X) | Sign t1 t2 s =>
    sign_piece (Q2R t1) (Q2R t2) s
  | Monotone t1 t2 d => monotone_piece (Q2R t1) (Q2R t2) d | Fold t1 t2 => fold_piece (Q2R t1) (Q2R t2)
  | Hinge t1 t2 => hinge_piece (Q2R t1) (Q2R t2) | Right T v => right_piece (Q2R T) v
  end.

Definition real_column (c : block) : column := Column (real_edge (beta_from c)) (Q2R (beta_to c)) (cell_of c)
  (map real_piece (entries c)).

Lemma real_ends p : piece_ends (real_piece p) = (real_edge (fst (ends_of p)), real_edge (snd (ends_of p))).
Proof. destruct p; simpl; rewrite ?Q2R_0; reflexivity. Qed.

Lemma real_ends_list l : map piece_ends (map real_piece l) = real_parts (map ends_of l).
Proof. unfold real_parts. rewrite !map_map. apply map_ext, real_ends. Qed.

Lemma block_in_cell_R c : block_in_cell c = true -> in_cell (real_column c).
Proof.
unfold block_in_cell, in_cell. cbn [real_column column_low column_high column_cell]. intros H. apply andb_prop in H.
destruct H as [A B].
apply Qle_bool_R in A. rewrite Q2R_plus, Q2R_nat, Q2R_1 in A. split; auto. apply orb_prop in B. destruct B as [B|B].
- left. apply Nat.eqb_eq, B.
- right. apply edge_le_R in B. cbn [real_edge] in B. rewrite Q2R_nat in B. exact B.
Qed.

Lemma larger_R p q : Q2R (larger p q) = Rmax (Q2R p) (Q2R q).
Proof.
unfold larger. destruct (Qle_bool p q) eqn:E.
- apply Qle_bool_R in E. rewrite Rmax_right; auto.
- rewrite Rmax_left; auto. apply Rnot_lt_le. intros L. apply Rlt_le, Qle_bool_R in L. congruence.
Qed.

Lemma factors_R low high n : Q2R (factors low high n)
  = fold_right Rmult 1 (map (fun i => Rmax (Rabs (Q2R low - 1 - INR i)) (Rabs (Q2R high - 1 - INR i))) (seq 0 n)).
Proof.
assert (E : forall l x, fold_right Rmult x l = fold_right Rmult 1 l * x).
{ induction l as [|a l IH]; intros x; simpl; [ring|]. rewrite IH. ring. }
induction n as [|n IH].
- simpl. apply Q2R_1.
- rewrite seq_S, map_app, fold_right_app. simpl map. simpl fold_right at 2. rewrite Rmult_1_r, E, <- IH.
  cbn [factors]. rewrite Q2R_red, Q2R_mult, larger_R, !Q2R_Qabs, !Q2R_minus, Q2R_nat, Q2R_1. reflexivity.
Qed.

Lemma natural_power_R q n : Q2R (natural_power q n) = Q2R q ^ n.
Proof. induction n as [|n IH]; cbn [natural_power pow]. apply Q2R_1. rewrite Q2R_red, Q2R_mult, IH. reflexivity. Qed.

Lemma far_left_R c X : far_left c X = true -> Q2R X < 0 /\ Rbar_le 0 (column_low (real_column c)) /\
  let N := S ((column_cell (real_column c) - 1) / 3) in
  let factor i := Rmax (Rabs (real (column_low (real_column c)) - 1 - INR i))
    (Rabs (column_high (real_column c) - 1 - INR i)) in
  fold_right Rmult 1 (map factor (seq 0 (3 * N))) < (- Q2R X) ^ (3 * N) * 3 ^ N * INR (fact N).
Proof.
unfold far_left, real_column. cbn [column_low column_high column_cell].
destruct (beta_from c) as [|low|]; try discriminate.
intros H. apply andb_prop in H. destruct H as [H H2]. apply andb_prop in H. destruct H as [H0 H1].
apply less_R in H0. apply Qle_bool_R in H1. apply less_R in H2. rewrite Q2R_0 in H0, H1. cbn [real_edge real].
set (N := S ((cell_of c - 1) / 3)) in *. split; auto. split; [exact H1|]. cbv zeta.
rewrite factors_R, !Q2R_mult, !natural_power_R, Q2R_opp, Q2R_nat in H2.
replace (Q2R 3) with 3 in H2 by (unfold Q2R; simpl; field). exact H2.
Qed.
