"""Where submissions run: a sandbox that sees as little of the machine as possible."""
