"""What only the authors of the course run: films, pictures of README, data and speeds."""
