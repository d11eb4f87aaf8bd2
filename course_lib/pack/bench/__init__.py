"""`make bench`: compare the library with other libraries on this machine."""
