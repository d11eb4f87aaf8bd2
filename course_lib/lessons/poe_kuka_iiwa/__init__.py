"""What only notebook 4 needs: product of exponentials on a KUKA iiwa 14."""
