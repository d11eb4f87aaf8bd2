"""The engine that judges the answers to exercises, and shows verdicts, hints and predictions in a
notebook.

The exercises themselves are in `course_lib.lessons`.
"""
