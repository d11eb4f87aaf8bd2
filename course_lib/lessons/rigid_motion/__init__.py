"""What only notebook 2 needs: rigid motion."""
