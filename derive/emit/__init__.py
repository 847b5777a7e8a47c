"""From derived expressions to committed code: what is generated, in which form, and how it is
written.
"""
