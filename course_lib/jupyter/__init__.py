"""Settings of JupyterLab for the course, and what its server calls when it saves."""
