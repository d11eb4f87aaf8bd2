"""Questions to a submission, and the verdicts on its answers."""
