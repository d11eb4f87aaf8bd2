from hypothesis import settings

# The same examples on every run and every machine: a test that fails is one that will fail again.
settings.register_profile("course", derandomize=True, database=None, deadline=None, max_examples=100)
settings.load_profile("course")
