"""The exact side rule: the sign of K, and what it says later and over states."""
