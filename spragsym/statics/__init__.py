"""Equilibria of any model: all of them by search, each proved, and their types."""
