"""The paper claim by claim: label, statement, checks, verdict."""
