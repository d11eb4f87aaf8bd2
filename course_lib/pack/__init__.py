"""What ``make`` runs: the environment, the executed notebooks and the site."""
