"""What only notebook 6 needs: inverse kinematics by decomposition and approximation."""
