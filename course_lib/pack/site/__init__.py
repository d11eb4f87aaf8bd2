"""The executed notebooks as a static site that opens from a folder with the network off."""
