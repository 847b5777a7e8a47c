"""Tubes: boxes around curves of states, proved, each of which holds one state for each value of what moves."""
