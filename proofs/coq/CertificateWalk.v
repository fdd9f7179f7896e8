(** * From the pieces of a column to the zeros on the line

    proofs/certificate.md, the walk. f is one differentiable function. A piece that fixes a sign holds a known number of
    zeros, all simple, and none at its ends; between two of them a run of pieces on which f is monotone in one direction
    holds one simple zero if the signs differ, and none if they agree. Put together from -oo to +oo these are all zeros
    of f. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate Calculus SignPattern ZerosAtInteger.
Import ListNotations.
Open Scope R_scope.

(** ** Signs *)
Lemma signed_negb s x : signed (negb s) x = - signed s x.
Proof. destruct s; simpl; ring. Qed.

Lemma signed_neg s x : signed s (- x) = - signed s x.
Proof. destruct s; simpl; ring. Qed.

Lemma signed_scal s k x : signed s (k * x) = k * signed s x.
Proof. destruct s; simpl; ring. Qed.

Lemma even_S m : Nat.even (S m) = negb (Nat.even m).
Proof. rewrite Nat.even_succ, Nat.negb_even. reflexivity. Qed.

Lemma signed_even m x : signed (Nat.even m) x = (-1) ^ m * x.
Proof.
induction m as [|m IH]; [simpl; ring|].
rewrite even_S, signed_negb, IH. simpl; ring.
Qed.

Lemma signed_ne0 s x : 0 < signed s x -> x <> 0.
Proof. destruct s; simpl; intros H ->; lra. Qed.

Lemma signed_unique s s' x : 0 < signed s x -> 0 < signed s' x -> s = s'.
Proof. destruct s, s'; simpl; intros; auto; lra. Qed.

Section Walk.
Variables (f f' : R -> R).
Hypothesis D : forall t, is_derive f t (f' t).

(** l lists the zeros of f in S, each once, and all are simple. *)
Definition zeros_in (S : R -> Prop) (l : list R) : Prop :=
  StronglySorted Rlt l /\ (forall t, S t /\ f t = 0 <-> In t l) /\ forall t, In t l -> f' t <> 0.

Lemma zeros_in_none (S : R -> Prop) : (forall t, S t -> f t <> 0) -> zeros_in S [].
Proof.
intros H. split; [constructor|split; [|intros t []]].
intros t. split; [intros [A B]; apply (H t A B)|intros []].
Qed.

Lemma zeros_in_ext (S S' : R -> Prop) l : (forall t, S t <-> S' t) -> zeros_in S l -> zeros_in S' l.
Proof. intros E (A & B & C). split; auto. split; auto. intros t. rewrite <- B, E. reflexivity. Qed.

(** Two sets on either side of a point where f is not 0. *)
Lemma zeros_in_union (S1 S2 : R -> Prop) l1 l2 x : zeros_in S1 l1 -> zeros_in S2 l2 -> f x <> 0 ->
  (forall t, S1 t -> t <= x) -> (forall t, S2 t -> x <= t) -> zeros_in (fun t => S1 t \/ S2 t) (l1 ++ l2).
Proof.
intros (A1 & B1 & C1) (A2 & B2 & C2) Hx H1 H2. split; [|split].
- apply (sorted_app l1 l2 x); auto; intros t Ht.
  + apply B1 in Ht. destruct Ht as [St Et]. destruct (Rle_lt_or_eq_dec _ _ (H1 t St)) as [L| ->]; auto. contradiction.
  + apply B2 in Ht. destruct Ht as [St Et]. destruct (Rle_lt_or_eq_dec _ _ (H2 t St)) as [L|E]; auto. rewrite E in Hx.
    contradiction.
- intros t. rewrite in_app_iff, <- B1, <- B2. tauto.
- intros t Ht. apply in_app_iff in Ht. destruct Ht as [Ht|Ht]; auto.
Qed.

(** f is monotone on [x, y] with direction d. *)
Lemma monotone_between d x y t : (forall u, x <= u <= y -> 0 < signed d (f' u)) -> x <= t <= y ->
  signed d (f x) <= signed d (f t) <= signed d (f y).
Proof.
intros H Ht.
assert (Up : forall u v, x <= u <= v -> v <= y -> signed d (f u) <= signed d (f v)).
{ intros u v Hu Hv. destruct (Rle_lt_or_eq_dec _ _ (proj2 Hu)) as [L| ->]; [|lra].
  destruct (mvt_open f f' u v L (fun s _ => D s)) as (c & Hc & E).
  assert (P := H c ltac:(lra)). assert (0 < signed d (f' c) * (v - u)) by (apply Rmult_lt_0_compat; lra).
  assert (signed d (f v) = signed d (f u) + signed d (f' c) * (v - u)) by (destruct d; simpl; lra). lra. }
split; apply Up; lra.
Qed.

Lemma monotone_no_zero s d x y : x <= y -> (forall u, x <= u <= y -> 0 < signed d (f' u)) -> 0 < signed s (f x) ->
  0 < signed s (f y) ->
  zeros_in (fun t => x <= t <= y) [].
Proof.
intros Hxy H Hx Hy. apply zeros_in_none. intros t Ht.
assert (A := monotone_between d x y t H Ht). destruct s, d; simpl in *; lra.
Qed.

Lemma monotone_one_zero d x y : x <= y -> (forall u, x <= u <= y -> 0 < signed d (f' u)) -> 0 < signed (negb d) (f x) ->
  0 < signed d (f y) ->
  exists z, zeros_in (fun t => x <= t <= y) [z].
Proof.
intros Hxy H Hx Hy. rewrite signed_negb in Hx.
assert (L : x < y) by (destruct (Rle_lt_or_eq_dec _ _ Hxy) as [L|E]; [exact L|rewrite E in Hx; lra]).
set (e := if d then -1 else 1).
assert (Se : forall u, e * u = - signed d u) by (intros u; unfold e; destruct d; simpl; ring).
destruct (cross f f' e x y D L) as (z & Hz & Ez & Before & After).
- intros t Ht. rewrite Se. assert (A := H t ltac:(lra)). lra.
- rewrite Se. lra.
- rewrite Se. lra.
- exists z. split; [repeat constructor|split].
  + intros t. split.
    * intros [Ht Et]. left. destruct (Rtotal_order t z) as [A|[A|A]]; auto; exfalso.
      -- assert (B := Before t ltac:(lra)). rewrite Et in B. lra.
      -- assert (B := After t ltac:(lra)). rewrite Et in B. lra.
    * intros [<-|[]]. split; [lra|exact Ez].
  + intros t [<-|[]]. apply (signed_ne0 d), H. lra.
Qed.

(** ** The chain of pieces *)
Definition between (p : piece) (t : R) : Prop := Rbar_le (fst (piece_ends p)) t /\ Rbar_le t (snd (piece_ends p)).

(** What a piece of the column c says of f. *)
Definition piece_says (c : column) (p : piece) : Prop :=
  Rbar_lt (fst (piece_ends p)) (snd (piece_ends p)) /\
  match p with
  | monotone_piece t1 t2 d => forall t, t1 <= t <= t2 -> 0 < signed d (f' t)
  | hinge_piece _ _ => True
  | _ => exists s, piece_sign c p = Some s /\
      (forall x, fst (piece_ends p) = Finite x -> 0 < signed s (f x)) /\
      (forall x, snd (piece_ends p) = Finite x -> 0 < signed s (f x)) /\
      exists l, length l = zeros_inside c p /\ zeros_in (between p) l
  end.

Fixpoint chain (x : Rbar) (pieces : list piece) : Prop :=
  match pieces with
  | [] => x = p_infty
  | p :: rest => fst (piece_ends p) = x /\ chain (snd (piece_ends p)) rest
  end.

Lemma cover_chain_from pieces : forall x, (forall p rest, pieces = p :: rest -> fst (piece_ends p) = x) ->
  cover (map piece_ends pieces) x p_infty -> chain x pieces.
Proof.
induction pieces as [|p rest IH]; intros x Hx H; [destruct H|].
cbn [map cover] in H. assert (Ex := Hx p rest eq_refl). cbn [chain]. split; [exact Ex|].
destruct (piece_ends p) as [low high] eqn:Ep. simpl fst in *. simpl snd in *. destruct H as [_ H].
destruct rest as [|q rest].
- cbn [map] in H. destruct high; simpl in *; auto; contradiction.
- cbn [map] in H. destruct (piece_ends q) as [next e] eqn:Eq. destruct H as [En H].
  apply IH.
  + intros p' rest' E. injection E as <- _. rewrite Eq. exact En.
  + cbn [map]. rewrite Eq. exact H.
Qed.

Lemma cover_chain pieces : cover (map piece_ends pieces) m_infty p_infty -> chain m_infty pieces.
Proof.
intros H. apply cover_chain_from; auto. intros p rest ->. cbn [map cover] in H.
destruct (piece_ends p) as [low high]. simpl in *. destruct H as [H _]. destruct low; simpl in H; auto; contradiction.
Qed.

(** What is known at the point x that the walk has come to, with k zeros before. *)
Definition known (before run : option bool) (x : Rbar) (k : nat) : Prop :=
  match before, run with
  | None, None => x = m_infty /\ k = 0%nat
  | Some s, None => exists l, zeros_in (fun t => Rbar_le t x) l /\ length l = k /\ forall y, x = Finite y ->
    0 < signed s (f y)
  | Some s, Some d => exists x0 y l, x = Finite y /\ x0 <= y /\ zeros_in (fun t => t <= x0) l /\ length l = k /\
      0 < signed s (f x0) /\ forall t, x0 <= t <= y -> 0 < signed d (f' t)
  | None, Some _ => False
  end.

(** A piece that fixes the sign s' comes next. *)
Lemma known_next c before run x k p s' n : known before run x k -> fst (piece_ends p) = x ->
  Rbar_lt (fst (piece_ends p)) (snd (piece_ends p)) ->
  (forall y, fst (piece_ends p) = Finite y -> 0 < signed s' (f y)) ->
  (forall y, snd (piece_ends p) = Finite y -> 0 < signed s' (f y)) ->
  (exists l, length l = zeros_inside c p /\ zeros_in (between p) l) ->
  crossings before run s' = Some n -> known (Some s') None (snd (piece_ends p)) (k + (n + zeros_inside c p)).
Proof.
intros K Ex Hlt Sl Sr (l2 & L2 & Z2) Hn. unfold between in Z2. rewrite Ex in *.
assert (Glue : forall y l, x = Finite y -> zeros_in (fun t => t <= y) l -> length l = (k + n)%nat ->
  known (Some s') None (snd (piece_ends p)) (k + (n + zeros_inside c p))).
{ intros y l Hy Z L. exists (l ++ l2). rewrite app_length, L, L2. split; [|split; [lia|exact Sr]].
  rewrite Hy in *. eapply zeros_in_ext; [|apply (zeros_in_union _ _ l l2 y Z Z2)].
  - intros t. simpl. split.
    + intros [A|[_ A]]; [|exact A]. destruct (snd (piece_ends p)); simpl in *; auto; lra.
    + intros A. destruct (Rle_lt_dec t y); [left; auto|right; split; auto; lra].
  - apply (signed_ne0 s'), Sl. reflexivity.
  - intros t Ht. exact Ht.
  - intros t [Ht _]. exact Ht. }
destruct before as [s|], run as [d|]; simpl in K, Hn.
- destruct K as (x0 & y & l & Hy & H0 & Z & L & S0 & M). rewrite Hy in *.
  assert (Sy := Sl y eq_refl).
  assert (C : exists l', zeros_in (fun t => x0 <= t <= y) l' /\ length l' = n).
  { destruct (Bool.eqb s s') eqn:E.
    - apply Bool.eqb_prop in E. subst s'. injection Hn as <-. exists []. split; auto.
      apply (monotone_no_zero s d); auto.
    - destruct (Bool.eqb d s') eqn:E'; [|discriminate]. apply Bool.eqb_prop in E'. subst s'. injection Hn as <-.
      assert (Es : s = negb d) by (destruct s, d; auto; discriminate). rewrite Es in S0.
      destruct (monotone_one_zero d x0 y H0 M S0 Sy) as (z & Zz). exists [z]. auto. }
  destruct C as (l' & Z' & L'). apply (Glue y (l ++ l') eq_refl).
  + eapply zeros_in_ext; [|apply (zeros_in_union _ _ l l' x0 Z Z')].
    * intros t. simpl. split; [intros [A|A]; lra|]. intros A. destruct (Rle_lt_dec t x0); [left|right]; lra.
    * apply (signed_ne0 s), S0.
    * auto.
    * intros t Ht. apply Ht.
  + rewrite app_length. lia.
- destruct K as (l & Z & L & Sx).
  assert (n = 0%nat) as ->.
  { destruct (Bool.eqb s s'); [congruence|discriminate]. }
  destruct x as [y| |]; [|destruct (snd (piece_ends p)); destruct Hlt|].
  + apply (Glue y l eq_refl); [exact Z|lia].
  + exists l2. rewrite L2. split; [|split; [|exact Sr]].
    * eapply zeros_in_ext; [|exact Z2]. intros t. simpl. tauto.
    * destruct Z as (_ & Z & _). destruct l as [|u l]; [simpl in L; lia|]. exfalso. apply (Z u). left. reflexivity.
- destruct K.
- destruct K as [-> ->]. injection Hn as <-. exists l2. rewrite L2. split; [|split; [lia|exact Sr]].
  eapply zeros_in_ext; [|exact Z2]. intros t. simpl. tauto.
Qed.

Lemma walk c pieces : forall before run x k n, chain x pieces -> (forall p, In p pieces -> piece_says c p) ->
  known before run x k -> zeros_counted c before run pieces = Some n -> exists l, zeros_in (fun _ => True) l /\
    length l = (k + n)%nat.
Proof.
induction pieces as [|p rest IH]; intros before run x k n Hc Hp K Hz.
- simpl in Hc, Hz. subst x. destruct run; [discriminate|]. injection Hz as <-.
  destruct before as [s|]; [|destruct K as [K _]; discriminate].
  destruct K as (l & Z & L & _). exists l. split; [|lia]. eapply zeros_in_ext; [|exact Z]. intros t. simpl. tauto.
- destruct Hc as [Ex Hc].
  assert (Hq : forall q, In q rest -> piece_says c q) by (intros q Hq; apply Hp; right; exact Hq).
  assert (P := Hp p (or_introl eq_refl)). clear Hp.
  assert (Fixed : forall s', piece_sign c p = Some s' ->
    (forall y, fst (piece_ends p) = Finite y -> 0 < signed s' (f y)) -> (forall y, snd (piece_ends p) = Finite y ->
      0 < signed s' (f y)) ->
    (exists l, length l = zeros_inside c p /\ zeros_in (between p) l) ->
      Rbar_lt (fst (piece_ends p)) (snd (piece_ends p)) ->
    match crossings before run s', zeros_counted c (Some s') None rest with
    | Some i, Some j => Some (i + zeros_inside c p + j)%nat | _, _ => None end = Some n ->
    exists l, zeros_in (fun _ => True) l /\ length l = (k + n)%nat).
  { intros s' Es Sl Sr Hl Hlt E. destruct (crossings before run s') as [i|] eqn:Ei; [|discriminate].
    destruct (zeros_counted c (Some s') None rest) as [j|] eqn:Ej; [|discriminate]. injection E as <-.
    destruct (IH (Some s') None (snd (piece_ends p)) (k + (i + zeros_inside c p))%nat j Hc Hq) as (l & Z & L); auto.
    - apply (known_next c before run x k p s' i); auto.
    - exists l. split; auto. lia. }
  destruct P as [Hlt P].
  destruct p as [| |X|t1 t2 s|t1 t2 d|t1 t2|t1 t2|T v];
    try (destruct P as (s' & Es & Sl & Sr & Hl); apply (Fixed s' Es Sl Sr Hl Hlt); cbn [zeros_counted] in Hz;
      rewrite Es in Hz; exact Hz).
  + cbn [zeros_counted] in Hz. simpl in Ex, Hc, Hlt. subst x.
    destruct before as [s|]; [|discriminate]. destruct run as [d'|].
    * destruct (Bool.eqb d d') eqn:E; [|discriminate]. apply Bool.eqb_prop in E. subst d'.
      destruct K as (x0 & y & l & Hy & H0 & Z & L & S0 & M). injection Hy as <-.
      apply (IH (Some s) (Some d) (Finite t2) k n Hc Hq); auto.
      exists x0, t2, l. refine (conj eq_refl (conj _ (conj Z (conj L (conj S0 _))))); [lra|].
      intros t Ht. destruct (Rle_lt_dec t t1); [apply M|apply P]; lra.
    * destruct K as (l & Z & L & S0). apply (IH (Some s) (Some d) (Finite t2) k n Hc Hq); auto.
      exists t1, t2, l. refine (conj eq_refl (conj _ (conj Z (conj L (conj (S0 t1 eq_refl) P))))). lra.
  + discriminate.
Qed.

Theorem walk_line c pieces n : cover (map piece_ends pieces) m_infty p_infty ->
  (forall p, In p pieces -> piece_says c p) ->
  zeros_counted c None None pieces = Some n -> exists l, zeros_in (fun _ => True) l /\ length l = n.
Proof. intros H Hp Hz. apply (walk c pieces None None m_infty 0 n); auto using cover_chain. split; reflexivity. Qed.

End Walk.

(** A cover: every point lies in a part. *)
Lemma cover_point parts : forall start stop x, cover parts start stop -> Rbar_le start x -> Rbar_le x stop ->
  exists part, In part parts /\ Rbar_le (fst part) x /\ Rbar_le x (snd part).
Proof.
induction parts as [|[low high] rest IH]; intros start stop x H H1 H2; [destruct H|].
destruct H as [Hl H]. destruct (Rbar_le_lt_dec x high) as [Hx|Hx].
- exists (low, high). split; [left; reflexivity|]. split; [apply (Rbar_le_trans _ start)|]; auto.
- destruct rest as [|[next e] rest].
  + exfalso. apply (Rbar_lt_not_le _ _ Hx). apply (Rbar_le_trans _ stop); auto.
  + destruct H as [_ H]. destruct (IH high stop x H (Rbar_lt_le _ _ Hx) H2) as (part & I & P).
    exists part. split; [right; exact I|exact P].
Qed.
