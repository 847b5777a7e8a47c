"""Equilibria: what is known of them, and how they are found for one point and for millions."""
