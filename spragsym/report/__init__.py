"""A brake in, a verdict out: data with units and tolerances, answered in newtons, millimetres and
hertz.
"""

#: Modules that other rooms ask; each is loaded when it is imported, so that a refusal is quick.
__all__ = ["data", "example", "over", "reports", "study"]
