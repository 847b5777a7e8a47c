"""Names that a page can't give away: results of models have them, or a language in which its functions are written."""

from __future__ import annotations

#: What results of models and columns of their files are called; for coordinates and parameters alike.
RESULTS = frozenset((
    "amplitude", "angles", "complete", "contact", "contact_lost", "coordinates", "count", "criticality", "crossing", "crossing_error", "cycle",
    "cycle_mean", "cycle_rms", "cycle_vy", "cycle_x", "cycle_y", "decided", "distance", "eigenvalues", "equilibrium", "error", "event", "event_t",
    "growth", "held_in", "jumps", "kind", "lyapunov", "lyapunov_error", "marginal", "mean", "mean_y", "model", "mu", "normal_forms", "omega",
    "parameters", "period", "pushing", "rate", "reason", "regime", "region", "remarks", "rms", "side", "slip_reversed", "spread", "stability",
    "undecided", "values", "vary", "whole", "why", "xp",
))  # fmt: skip

#: What else a motion and its sweep are asked for; a coordinate would hide it.
OF_MOTIONS = frozenset((
    "after", "backend", "components", "converged", "course", "energy", "events", "explained", "how", "inputs", "integral", "max_steps",
    "outcome", "p", "power", "rtol", "samples", "save", "state", "t", "t_end", "to_dataset", "transient", "weights",
))  # fmt: skip

#: Words of C99, JavaScript and MATLAB, and functions that generated code calls.
WORDS = frozenset((
    "abs", "arguments", "auto", "await", "break", "case", "catch", "char", "classdef", "const", "continue", "debugger", "default", "delete",
    "do", "double", "else", "elseif", "end", "enum", "eval", "exp", "export", "extends", "extern", "fabs", "float", "for", "function", "global",
    "goto", "if", "implements", "inline", "instanceof", "int", "interface", "let", "log", "long", "new", "numpy", "otherwise", "package", "parfor",
    "persistent", "private", "protected", "public", "register", "restrict", "return", "short", "sign", "signed", "sizeof", "spmd", "sqrt",
    "square", "static", "struct", "super", "switch", "this", "throw", "typedef", "typeof", "union", "unsigned", "var", "void", "volatile", "while",
))  # fmt: skip
