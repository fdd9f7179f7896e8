"""Whether the contact on the slow manifold holds, and up to which epsilon."""
