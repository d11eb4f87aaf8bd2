"""What only notebook 5 needs: DH parameters and inverse kinematics on a Franka Panda."""
