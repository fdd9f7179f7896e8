"""What accuracy costs in time, and the hard cases."""
