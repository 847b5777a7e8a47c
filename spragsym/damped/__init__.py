"""The closed forms of the model damped: at rest dampers push nothing, so its states, and where they
end, are those of the article's model.

``python -m derive`` proves that the two pages are one where the dampers are 0, and no damper stands
in the balance of forces.
"""

#: Question → module of its closed form.
CLOSED_FORMS = dict.fromkeys(
    (
        "bifurcation_set",
        "claims",
        "count",
        "critical_friction",
        "cusps",
        "equilibria",
        "first_limit_points",
        "folds",
        "limit_point_passed",
        "linked",
        "border_ends",
    ),
    "spragsym.damped.statics",
)
