"""Grades for a folder of submissions, each run apart from the grader. ``make grade SUBMISSIONS=folder``."""
