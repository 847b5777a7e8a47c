"""Equilibria in closed form: the roots of the quartic, for one point and for millions."""
