(** * The scene of a run that is checked in Coq: numbers of the model system with k_1 = k_2 = damping = 1

    eps, alpha1, alpha2, beta = alpha3/alpha1; the state at t = 0; the bracket of the time of the first lift-off. *)

From Coq Require Import QArith.

Record scene := Scene { eps : Q; alpha1 : Q; alpha2 : Q; beta : Q; b0 : Q; p0 : Q; v0 : Q; y0 : Q; z0 : Q;
  low : Q; high : Q }.
