"""Names that a page can't give away, since results, sets, commands and files of models have them.

Those of generated code are no matter of a list: its own begin with an underscore, as no name of a page does, and in other languages
than Python a page's names end with one.
"""

#: What results of models and columns of their files are called; for coordinates and parameters alike.
RESULTS = frozenset((
    "after", "amplitude", "angles", "as_table", "between", "columns", "complete", "contact", "contact_lost", "coordinates", "count",
    "criticality", "crossing", "crossing_error", "cycle", "damped", "damped_eigenvalues", "cycle_mean", "cycle_rms", "data", "decided",
    "distance", "eigenvalues", "endless", "ends", "equilibrium", "error", "event", "event_t", "given", "growth", "growth_sign", "held_in", "jumps", "kind", "largest",
    "lyapunov", "lyapunov_error", "marginal", "mean", "measured", "model", "mu", "normal_forms", "offered", "omega", "parameters", "period", "places", "plot",
    "pushing", "rate", "reason", "regime", "region", "remarks", "require_decided", "rms", "save", "select", "side", "slip_reversed", "spread", "stability", "state",
    "stable", "states", "table_angles", "table_codes", "table_columns", "table_model", "table_values", "table_varied",
    "to_dataframe", "to_xarray", "told", "undecided", "values", "vary", "when", "whole", "why",
))  # fmt: skip

#: What else a motion and its sweep are asked for; a coordinate would hide it.
OF_MOTIONS = frozenset((
    "after", "backend", "components", "contact_force", "converged", "course", "decay_rate", "energy", "events", "explained", "friction", "friction_power", "how", "implicit", "inputs", "integral", "max_steps",
    "outcome", "p", "plot", "power", "rtol", "samples", "save", "spectrum", "spring_force", "state", "sticking", "t", "t_end", "to_dataset", "transient", "weights",
))  # fmt: skip

#: What generated Python calls by its own name.
OF_CODE = frozenset(("abs", "xp"))

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
