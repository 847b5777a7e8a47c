"""Bifurcations of the article's model in closed form: surface, folds, cusps and onsets, all complete."""
