"""The exercises, a folder for each notebook and a module for each exercise."""
