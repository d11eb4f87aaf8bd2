# `make` alone lists what there is. Every target first sets up .venv from environment.txt, if it is
# not there yet; what is written goes to build/. Works with GNU make 3.81 (macOS) and any POSIX sh.

SHELL := /bin/sh
.DEFAULT_GOAL := help
PY := .venv/bin/python

# The course's notebooks by their numbers, so that a student's Untitled.ipynb is not tested.
NOTEBOOKS := $(sort $(wildcard notebooks/[0-9][0-9]_*.ipynb))

# Robotics machines often have ROS on PYTHONPATH, and with it other packages and pytest plugins.
unexport PYTHONPATH PYTHONHOME
# Container images like to set this; each of a test run's hundred processes would then compile all
# packages again.
unexport PYTHONDONTWRITEBYTECODE

# Some containers give their user no home folder, or one in which nothing can be written, which Jupyter needs.
ifneq ($(shell [ -w "$$HOME" ] && echo yes),yes)
export HOME := $(CURDIR)/build/home
endif

# Settings of the person who runs make (IPython start-up files, a matplotlibrc) change outputs:
# where outputs are compared or written, they are left out.
WITHOUT_SETTINGS := test html pdf grade notebooks animations data bench
$(WITHOUT_SETTINGS): export IPYTHONDIR = $(CURDIR)/build/ipython
$(WITHOUT_SETTINGS): export MPLCONFIGDIR = $(CURDIR)/build/matplotlib
# Many small k-means, in parallel tests: threads of their own would only get in each other's way.
test html notebooks: export OMP_NUM_THREADS = 1

.PHONY: help environment lab update test html pdf student grade notebooks animations data lock \
	bench clean

# What stands behind ## is printed as it is, so it stays on the target's line, however long that is.
help:
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-10s %s\n", $$1, $$2 }' Makefile

# Compares what .venv was made from, and does nothing where that is unchanged.
environment: ## set up the packages in .venv, if environment.txt has changed; the other commands do this first
	@sh course_lib/pack/environment.sh

# Jupyter refuses to run as root unless told to. The settings of the folder named first keep it from
# asking about news and updates, from warning of plain-text connections to kernels, from listing the
# language servers that are not installed below the address, and from loading nbgrader, which only
# authors have.
JUPYTER_SETTINGS = $(CURDIR)/course_lib/jupyter
lab: environment ## open the exercises in JupyterLab, from exercises/; SOLUTIONS=yes opens the authors' notebooks
	@$(if $(filter yes,$(SOLUTIONS)),,$(PY) -m course_lib.pack.release.exercises)
	@JUPYTER_CONFIG_PATH="$(JUPYTER_SETTINGS)$${JUPYTER_CONFIG_PATH:+:$$JUPYTER_CONFIG_PATH}" \
		$(PY) -m jupyter lab $(if $(filter 0,$(shell id -u)),--allow-root) \
		$(if $(filter yes,$(SOLUTIONS)),notebooks,exercises)/01_rotations.ipynb

update: environment ## make newer notebooks in exercises/, with your answers in them
	@$(PY) -m course_lib.pack.release.exercises --update

# Formats and lints JavaScript: an author's tool, from npm, which no student needs.
BIOME = $(shell command -v biome || ls node_modules/.bin/biome 2>/dev/null)

BIOME_IS_MISSING = JavaScript is not checked, because Biome is not installed. To install it: \
	npm install --no-save @biomejs/biome@2.6 (npm comes with Node.js)

# The times hold for two processors (an AMD EPYC in 2026) with three test processes.
WHAT_TEST_DOES = $(if $(filter-out no,$(ALL)),$(WHAT_ALL_DOES),$(WHAT_THE_SHORT_RUN_DOES)) Tests \
	whose programs are not installed are skipped. To run only a part: make test ONLY=exp_so3
WHAT_THE_SHORT_RUN_DOES = Running the linters, all notebooks and the quick tests. This takes ten \
	minutes of processor time, which is six on two quiet processors. To run all tests: \
	make test ALL=yes.
WHAT_ALL_DOES = Running the linters, all notebooks and all tests. This takes about 40 minutes on two \
	processors, and longer on a busy machine.

# Tests that are marked as slow (pyproject.toml) run with ALL=yes, and with ONLY if they have that name.
WHICH_TESTS = $(if $(ONLY)$(filter-out no,$(ALL)),,-m "not slow")

# One pytest run, so that its summary comes last; with ONLY, one process, because few tests take
# seconds. Matplotlib builds its font list beforehand: it reports on stderr if that takes long, and
# nbval would compare that too. The cells of a notebook share a kernel, so it stays in one worker
# (loadfile); conftest.py says which files go first.
test: environment ## run the linters, every notebook against its stored outputs, and the tests that take no longer than seconds; ALL=yes runs all tests, ONLY=poe_kuka_iiwa runs what has that in its name, LAB=all runs all notebooks in JupyterLab
	@$(if $(ONLY),:,echo "$(WHAT_TEST_DOES)")
	$(PY) -m ruff check --no-cache course_lib tests $(NOTEBOOKS)
	$(PY) -m ruff format --no-cache --check --quiet course_lib tests
	.venv/bin/lint-imports --no-cache --no-logo
	$(if $(BIOME),"$(BIOME)" ci course_lib,@echo "$(BIOME_IS_MISSING)")
	@$(PY) -c 'import matplotlib.font_manager' 2>/dev/null || :
	@ONLY="$(ONLY)" LAB="$(LAB)" $(PY) -m pytest -o cache_dir=build/pytest $(WHICH_TESTS) \
		$(if $(ONLY),-k "$(ONLY)",-n logical --maxprocesses 8 --dist loadfile --no-loadscope-reorder) \
		--nbval --nbval-current-env --nbval-cell-timeout=600 --doctest-modules \
		$(if $(ONLY),$(wildcard course_lib/$(ONLY)*.py),course_lib) tests $(NOTEBOOKS)

html: environment ## export the notebooks as a static site, build/html/index.html; SOLUTIONS=no leaves the solutions out and writes build/html-students/, SOLUTIONS=model shows there the answers to the written questions; REPOSITORY=https://github.com/owner/name adds buttons that open the notebooks of its branch main on Binder and on Colab
	@$(PY) -m course_lib.pack.site $(if $(SOLUTIONS),--solutions "$(SOLUTIONS)") \
		$(if $(REPOSITORY),--repository "$(REPOSITORY)")

pdf: environment ## write the pages as one PDF, build/course.pdf; SOLUTIONS=no leaves the solutions out and writes build/course-students.pdf
	@$(PY) -m course_lib.pack.site $(if $(SOLUTIONS),--solutions "$(SOLUTIONS)") \
		--pdf build/course$(if $(filter no model,$(SOLUTIONS)),-students).pdf

student: environment ## write the release for students, without solutions, build/student.zip; MORE=no leaves More out
	@$(PY) -m course_lib.pack.release $(if $(MORE),--more "$(MORE)")

# Each setting is an option of the same name in small letters; --help explains them.
grade: environment ## grade what students handed in: make grade SUBMISSIONS=folder; without a folder it lists the settings
	@$(PY) -m course_lib.pack.grade \
		$(if $(JOBS),--jobs "$(JOBS)") \
		$(if $(OUTPUT),--output "$(OUTPUT)") \
		$(if $(SEED),--seed "$(SEED)") \
		$(if $(CLUSTER),--cluster "$(CLUSTER)") \
		$(if $(DEADLINE),--deadline "$(DEADLINE)") \
		$(if $(LATE),--late "$(LATE)") \
		$(if $(TIMES),--times "$(TIMES)") \
		$(if $(EXTENSIONS),--extensions "$(EXTENSIONS)") \
		$(if $(findstring command,$(origin NOTEBOOKS)),--notebooks "$(NOTEBOOKS)") \
		$(if $(EARLIER),--earlier "$(EARLIER)") \
		$(if $(MORE),--more "$(MORE)") \
		$(if $(LMS),--lms "$(LMS)") \
		$(if $(STUDENTS),--students '$(STUDENTS)') \
		$(if $(ROSTER),--roster "$(ROSTER)") \
		$(if $(GRADEBOOK),--gradebook "$(GRADEBOOK)") \
		$(if $(ISOLATION),--isolation "$(ISOLATION)") \
		-- "$(SUBMISSIONS)"

notebooks: environment ## run the notebooks and write their outputs into them; NOTEBOOKS=notebooks/04_poe_kuka_iiwa.ipynb runs one
	@$(PY) -m course_lib.pack.notebooks $(NOTEBOOKS)
	@$(PY) -m course_lib.pack.authors.pictures

animations: environment ## write the moving pictures as GIF (and MP4, with ffmpeg), build/animations/
	@$(PY) -m course_lib.pack.authors.animations $(NOTEBOOKS)
	@$(PY) -m course_lib.pack.authors.pictures

data: environment ## compute a trajectory of the iiwa with exact velocities, build/data/iiwa_trajectory.csv
	@$(PY) -m course_lib.pack.authors.data

lock: ## write environment.txt from pyproject.toml; UPGRADE=numpy takes a newer numpy, UPGRADE=yes takes newer versions of all packages
	@sh course_lib/pack/environment.sh lock

# One thread for all, so that what is compared is the work and not how it is spread.
bench: ## compare the speed of the library with others, in an environment of its own, and write README's table
	@sh course_lib/pack/environment.sh bench
	@OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 MKL_NUM_THREADS=1 VECLIB_MAXIMUM_THREADS=1 \
		.venv-bench/bin/python -m course_lib.pack.authors.bench

MARKS_STAY = build/grades/questions.csv and seed stay. If you do not need the marks any more, \
	delete these two files yourself.

clean: ## delete build/ and caches; .venv, .venv-bench and, in build/grades/, the marks and their seed stay
	@[ ! -f build/grades/questions.csv ] || echo "$(MARKS_STAY)"
	[ ! -d build ] || find build -depth ! -path build/grades/questions.csv ! -path build/grades/seed \
		\( ! -type d -o -empty \) -delete
	rm -rf .pytest_cache .ruff_cache .hypothesis .import_linter_cache
	find course_lib tests notebooks -name __pycache__ -type d -prune -exec rm -rf {} +
