"""Campaigns: what the package says, held against other witnesses at thousands of points; see
``python -m validation``.
"""
