"""Facade details from coloured scans (Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal 2014)."""
