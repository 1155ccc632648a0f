"""The spaces between walls."""
