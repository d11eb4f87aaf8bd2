"""How answers reach a newer release: what `python carry_over.py` runs."""
