"""The article's model: its argument from assumptions to proofs, step by step, and the article as
printed.
"""
