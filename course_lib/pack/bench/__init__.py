"""`make bench`: the library beside other libraries, on this machine, and what it promises to be at most."""
