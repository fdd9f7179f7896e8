"""The series and integrals of Θ, each with the bound on what it leaves out."""
