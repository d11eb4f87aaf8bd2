"""Toys: interactive figures, in a live notebook and on an exported page.

course_lib.figures names them.
"""
