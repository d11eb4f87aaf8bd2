"""Marks, tables for gradebooks, and the pages that students and instructors read."""
