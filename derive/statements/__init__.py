"""Printed equations of any paper, held against a page."""
