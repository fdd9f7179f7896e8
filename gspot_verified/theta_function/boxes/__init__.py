"""Taylor models of Θ over ranges of τ and β."""
