"""What only notebook 3 needs: subproblems and damped least squares."""
