"""Equilibria of any model: all of them by search, each proved, with its type of stability."""
