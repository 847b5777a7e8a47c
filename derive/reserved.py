"""Names that a page can't give away: results of models have them, or a language in which its functions are written."""

from __future__ import annotations

#: What results of models and columns of their files are called; for coordinates and parameters alike.
RESULTS = frozenset((
    "after", "amplitude", "angles", "as_table", "between", "columns", "complete", "contact", "contact_lost", "coordinates", "count",
    "criticality", "crossing", "crossing_error", "cycle", "damped_eigenvalues", "cycle_mean", "cycle_rms", "data", "decided",
    "distance", "eigenvalues", "endless", "ends", "equilibrium", "error", "event", "event_t", "growth", "held_in", "jumps", "kind", "largest",
    "lyapunov", "lyapunov_error", "marginal", "mean", "measured", "model", "mu", "normal_forms", "offered", "omega", "parameters", "period", "places", "plot",
    "pushing", "rate", "reason", "regime", "region", "remarks", "require_decided", "rms", "select", "side", "slip_reversed", "spread", "stability",
    "stable", "states", "table_angles", "table_codes", "table_columns", "table_model", "table_values", "table_varied",
    "to_dataframe", "to_xarray", "told", "undecided", "values", "vary", "when", "whole", "why", "xp",
))  # fmt: skip

#: What else a motion and its sweep are asked for; a coordinate would hide it.
OF_MOTIONS = frozenset((
    "after", "backend", "components", "contact_force", "converged", "course", "decay_rate", "energy", "events", "explained", "friction_power", "how", "inputs", "integral", "max_steps",
    "outcome", "p", "plot", "power", "rtol", "samples", "save", "spectrum", "spring_force", "state", "t", "t_end", "to_dataset", "transient", "weights",
))  # fmt: skip

#: Words of C99, JavaScript and MATLAB, and functions that generated code calls.
WORDS = frozenset((
    "HUGE_VAL", "INFINITY", "M_PI", "NAN", "NULL",
    "abs", "arguments", "auto", "await", "break", "case", "catch", "char", "classdef", "const", "continue", "debugger", "default", "delete",
    "do", "double", "else", "elseif", "end", "enum", "eval", "exp", "export", "extends", "extern", "fabs", "float", "for", "function", "global",
    "goto", "if", "implements", "inline", "instanceof", "int", "interface", "let", "log", "long", "new", "numpy", "otherwise", "package", "parfor",
    "persistent", "private", "protected", "public", "register", "restrict", "return", "short", "sign", "signed", "sizeof", "spmd", "sqrt",
    "square", "static", "struct", "super", "switch", "this", "throw", "typedef", "typeof", "union", "unsigned", "var", "void", "volatile", "while",
))  # fmt: skip

#: What the commands of a model call their options, and the values of these: `spragsym folds --vary`. A test holds this list against them.
OF_COMMANDS = frozenset((
    "backend", "data", "diagram", "digits", "error", "estimate_error", "force", "help", "json", "json_output", "method",
    "model", "n", "near", "output", "plot", "points", "prove", "quiet", "rtol", "state", "t_end", "transient", "undamped", "vary", "whole", "within", "workers",
))  # fmt: skip

#: What sets of parameters have besides their values.
OF_SETS = frozenset((
    "broadcast", "followed", "following", "given", "model", "origin", "ranges", "replace", "require", "scalars", "self", "shape", "spanned", "table_angles",
    "table_codes", "table_model", "table_values", "table_varied", "where",
))  # fmt: skip

#: Keys of a file with a user's own data, where quantities stand by their names on the page.
OF_FILES = frozenset(("begin", "correlation", "friction", "model", "state", "vary"))

#: What generated functions call what they are made of.
OF_CODE = frozenset((
    "Number", "ModuleType", "below", "broadcasting", "depth", "determinant", "one", "overlap", "result", "slip",
    *(f"inverse_{row}{column}" for row in range(1, 5) for column in range(row, 5)),
))  # fmt: skip
