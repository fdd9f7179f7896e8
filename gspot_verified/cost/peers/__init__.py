"""What a user could take instead of this library."""
