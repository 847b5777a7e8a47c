"""The derivation: what follows from any page, and in ``kang_nam`` the article's model.
``make derive`` runs it.
"""
