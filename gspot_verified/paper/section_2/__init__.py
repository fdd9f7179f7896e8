"""Section 2: mechanisms, the contact and restitution, the extended system."""
