"""Who handed in what: the files, their students and their notebooks."""
