"""What an entry is and what its checks are made of."""
