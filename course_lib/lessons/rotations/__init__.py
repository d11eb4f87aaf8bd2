"""What only notebook 1 needs: rotations."""
