"""The sign of dΘ/dτ on ranges of τ and β: pieces that cover them."""
