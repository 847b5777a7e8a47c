"""The mechanics of any model over boxes: its generated functions, the balance of forces and the contact's border."""
