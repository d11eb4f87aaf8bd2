#!/bin/sh
# Makes or updates .venv, as environment.txt says; says in one plain sentence what to do where that
# fails. `environment.sh bench` does the same for .venv-bench, in which `make bench` measures other
# libraries too, and `environment.sh lock` writes environment.txt from pyproject.toml. PYTHON=...
# names the interpreter. POSIX sh only.
set -u
unset CDPATH # else cd may go elsewhere, and print
cd -- "$(dirname -- "$0")/../.." || exit 1
# ROS on PYTHONPATH would shadow what is installed here; the rest would send the packages to another
# place.
unset PYTHONPATH PYTHONHOME VIRTUAL_ENV
export PIP_USER=no PIP_DISABLE_PIP_VERSION_CHECK=1
# Compiling one of these takes an hour: fail at once if there is no wheel for this Python.
export PIP_ONLY_BINARY=numpy,scipy,scikit-learn,matplotlib
export UV_NO_BUILD_PACKAGE='numpy scipy scikit-learn matplotlib'
here=$(pwd -P)
log=build/setup.log
# Run it: a version manager may leave a name without a program.
uv=$(command -v uv) && "$uv" --version >/dev/null 2>&1 || uv=
# The libraries of the benchmark besides scipy, at versions that work with the numpy of
# environment.txt.
peers='pin==4.1.0 roboticstoolbox-python==1.5.0'

stop() { echo "$*" >&2; exit 1; }

because() { # because PATTERN SENTENCE: stop with the sentence if the end of the log has the pattern
    if tail -n 25 "$log" | grep -q -i -E "$1"; then stop "$2 (log: $log)."; fi
}

explain() {
    network='name or service|nodename|name ?resolution|failed to fetch|connection|unreachable'
    network="$network|timed out|proxy ?error"
    because 'no space left|disk quota' \
        "The disk is full: the set-up needs 1.3 GB, and another 0.3 GB while it works"
    because 'ensurepip|no module named .?venv' \
        "This Python cannot make environments: install its venv module (on Debian and Ubuntu \
apt install python3-venv)"
    because 'certificate' \
        "The server's certificate was not accepted: check the clock of this machine, and behind a \
proxy that opens encrypted connections name the file of its certificate, SSL_CERT_FILE=file (and \
PIP_CERT=file)"
    because "$network" \
        "The packages could not be downloaded: check the network connection and run make again"
    because 'no matching distribution|no usable wheels|no wheels with a matching' \
        "Some packages are not made for this Python or this system: name another Python, \
make PYTHON=python3.13"
    stop "The set-up failed: $(grep . "$log" | tail -n 1) (log: $log)."
}

# Runs a command whose output goes to the log; lines that say how far it is go to the terminal too.
run() {
    { "$@" 2>&1 </dev/null; echo $? >build/status; } | while IFS= read -r line; do
        printf '%s\n' "$line" >>"$log"
        case $line in
        Collecting\ * | \ Downloaded\ * | Resolved\ * | Prepared\ *) printf '  %.76s\n' "$line" ;;
        Installed\ *) echo "  $line, compiling them, which takes longest ..." ;;
        esac
    done
    return "$(cat build/status)"
}

# Compiles now: in grading nothing may be written, so each process would compile again.
install() {
    run "$uv" pip install --compile-bytecode --python "$venv/bin/python" "$@"
}

# Where the machine has no uv, pip brings the one of the lock: it takes a fifth of pip's time.
bring_uv() {
    [ -n "$uv" ] && return
    locked=$(grep -h '^uv==' environment.txt lock.txt 2>/dev/null | head -n 1)
    run "$venv/bin/python" -m pip install --progress-bar off "${locked:-uv}" && uv=$venv/bin/uv
}

find_python() {
    for python in ${PYTHON:-python3 python3.14 python3.13 python3.12 python3.11 python}; do
        # Run it: a version manager may leave a name without an interpreter.
        "$python" -c 'import sys; sys.exit(not (3, 11) <= sys.version_info < (3, 15))' \
            >/dev/null 2>&1 && return
    done
    stop "Python 3.11 to 3.14 is needed: install one, or name it with make PYTHON=/path/to/python3."
}

# What it is made from: not times, which a checkout changes; the folder too, because scripts name
# it.
contents() { echo "$here" && cat environment.txt pyproject.toml; }

set_up() { # set_up ENVIRONMENT WHAT...
    venv=$1
    shift
    # cmp may end first; where SIGPIPE is ignored, as on some CI machines, cat would report that.
    [ -x "$venv/bin/python" ] && contents 2>/dev/null | cmp -s - "$venv/made-from" && return
    : >"$log"
    echo "Setting up $venv, once: a minute or two, by network and machine (log: $log)."
    # One that was moved, interrupted or left without pip is made afresh.
    if [ "$(head -n 1 "$venv/made-from" 2>/dev/null)" != "$here" ] ||
        ! { [ -n "$uv" ] || "$venv/bin/python" -m pip --version; } >>"$log" 2>&1; then
        find_python
        run rm -rf "$venv" || explain
        if [ -n "$uv" ]; then
            run "$uv" venv --python "$python" "$venv" || explain
        else
            run "$python" -m venv "$venv" || explain
        fi
    fi
    rm -f "$venv/made-from" # written last, so that one without it was interrupted
    bring_uv || explain
    install "$@" || explain
    [ "$venv" != .venv ] || install --no-deps --no-build-isolation -e . || explain
    # Matplotlib lists the fonts once, and may report that on stderr: now, not in a student's first
    # notebook.
    run "$venv/bin/python" -c 'import matplotlib.font_manager'
    contents >"$venv/made-from"
}

bench() {
    set_up .venv-bench -c environment.txt numpy scipy
    for peer in $peers; do # one by one, so that the failure of one does not affect the others
        grep -q -x -s "$peer" "$venv/peers" && continue
        install --only-binary :all: -c environment.txt "$peer" && echo "$peer" >>"$venv/peers" ||
            echo "$peer is left out. $( (explain) 2>&1)"
    done
}

# Writes the options of uv for UPGRADE=yes, which is all packages, or for the names of packages.
upgrade_options() {
    case ${UPGRADE:-} in
    '' | no) ;;
    yes | all) printf '%s' --upgrade ;;
    *) printf -- '--upgrade-package %s ' $UPGRADE ;; # not quoted: one option for each name
    esac
}

# uv keeps the versions of the file that it writes, a copy here, so that an error changes nothing.
lock() {
    cp environment.txt build/lock.txt
    # The --no-... leave out what differs between machines, such as the address of a package index.
    run "${uv:-.venv/bin/uv}" pip compile --universal --fork-strategy fewest --python-version 3.11 \
        pyproject.toml --group test --group site --group grade --group cluster --group build \
        $(upgrade_options) --no-header --no-annotate --resolution "${RESOLUTION:-highest}" \
        --no-emit-index-url --no-emit-find-links -o build/lock.txt || explain
    { grep '^#' environment.txt; grep -v '^#' build/lock.txt; } >build/lock.new
    if diff environment.txt build/lock.new; then echo "environment.txt stays as it is."; else
        mv -f build/lock.new environment.txt &&
            echo "environment.txt is rewritten; the next make updates .venv."
    fi
}

mkdir -p build ||
    stop "This folder ($here) cannot be written: change its permissions, or copy it to a folder of \
yours."
case ${1:-} in
'') set_up .venv -r environment.txt ;;
bench) bench ;;
lock) lock ;;
esac
