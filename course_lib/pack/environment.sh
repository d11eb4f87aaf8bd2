#!/bin/sh
# Sets up what make needs, and says in one plain sentence what to do when that fails.
#
#   environment.sh          makes or updates .venv, as environment.txt says
#   environment.sh lock     writes environment.txt anew from pyproject.toml
#
# PYTHON=... names the interpreter to use, UPGRADE=yes lets `lock` move to newer versions.
# POSIX sh only: a student's sh may be dash, bash or zsh.
set -u
unset CDPATH # else cd may go elsewhere, and print
cd -- "$(dirname -- "$0")/../.." || exit 1

# Robotics machines often put ROS on PYTHONPATH, which then shadows what is installed here. The other
# two would send the packages to another environment than .venv.
unset PYTHONPATH PYTHONHOME VIRTUAL_ENV
export PIP_USER=no PIP_DISABLE_PIP_VERSION_CHECK=1

here=$(pwd -P)
log=build/setup.log
made_from=.venv/made-from # written last, so an environment without it was interrupted
tested="3.14 3.13 3.12 3.11"
python=

stop() {
    echo "$*" >&2
    exit 1
}

logged() {
    echo "\$ $*" >>"$log"
    "$@" >>"$log" 2>&1
}

ends_with() { # whether the log's last lines match; earlier ones may tell of troubles that passed
    tail -n 25 "$log" 2>/dev/null | grep -q -i -E "$1"
}

explain() { # stop with the reason that the log gives
    free=$(df -Pk . 2>/dev/null | awk 'NR == 2 { print $4 }')
    if ends_with 'no space left|disk quota|errno 28|os error 28' || [ "${free:-100000}" -lt 10000 ]; then
        stop "The disk is full: make about 1 GB of room and run make again (log: $log)."
    elif ends_with 'permission denied|read-only file system|operation not permitted'; then
        stop "Something in .venv, or in the folder for temporary files, cannot be written: set the" \
            "rights or delete .venv, and run make again (log: $log)."
    elif ends_with 'ensurepip|no module named .?venv'; then
        stop "This Python ($version) cannot make environments: install its venv module (on Debian and" \
            "Ubuntu: sudo apt install python3-venv) and run make again (log: $log)."
    elif ends_with 'name resolution|name or service not known|nodename nor servname|dns error|are you offline' ||
        ends_with 'new ?connection|failed to fetch|unreachable|timed out|timeout|proxy ?error|ssl ?error' ||
        ends_with 'max retries|connection (refused|reset|aborted|broken)|remote end closed'; then
        stop "The packages could not be downloaded: check the network connection and run make again" \
            "(log: $log)."
    elif ends_with 'no matching distribution|no usable wheels|no wheels with a matching|requires-python'; then
        stop "Some packages are not made for this Python ($version): name another one, for instance" \
            "make PYTHON=python3.13 (log: $log)."
    fi
    stop "The set-up failed: the last lines of $log say why; run make again once that is mended."
}

new_enough() {
    "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1
}

find_python() {
    if [ -n "${PYTHON:-}" ]; then
        new_enough "$PYTHON" || stop "PYTHON=$PYTHON is no Python 3.11 or newer: name another one."
        python=$PYTHON
    else
        for candidate in python3 $(printf 'python%s ' $tested) python; do
            # Asked, not only looked for: a version manager's stand-in may be there with nothing behind it.
            if new_enough "$candidate"; then
                python=$candidate
                break
            fi
        done
    fi
    version=
    [ -z "$python" ] || version=$("$python" -c 'import platform; print(platform.python_version())')
}

need_python() {
    find_python
    [ -n "$python" ] && return
    found=$(python3 --version 2>&1) || found="no python3"
    stop "Python 3.11 or newer is needed and only $found was found: install a newer one, or name it with" \
        "make PYTHON=/path/to/python3."
}

start_log() {
    { mkdir -p build && : >"$log"; } 2>/dev/null && [ -w . ] && return
    # A full disk can still make an empty file, so what failed here is a matter of rights.
    stop "This folder cannot be written ($here): copy it to one of your own, or set its rights, and run make there."
}

install() { # into .venv, by uv or pip
    # Compiling these takes an hour and a Fortran compiler: better to hear at once that there is none for this Python.
    set -- --only-binary numpy --only-binary scipy --only-binary scikit-learn --only-binary matplotlib "$@"
    if [ -n "$uv" ]; then
        logged uv pip install --python .venv/bin/python "$@"
    else
        logged .venv/bin/python -m pip install "$@"
    fi
}

set_up() {
    # The folder is compared too: the scripts in .venv hold absolute paths, so a copied or moved one is
    # of no use. Contents are compared, not times, because a checkout changes every time.
    [ -x .venv/bin/python ] &&
        { echo "$here" && cat environment.txt pyproject.toml; } | cmp -s - "$made_from" && return

    start_log
    uv=$(command -v uv)
    begin=$(date +%s)
    if [ -x .venv/bin/python ] && [ "$(head -n 1 "$made_from" 2>/dev/null)" = "$here" ]; then
        echo "Bringing .venv up to date ..."
        version=$(.venv/bin/python -V 2>&1)
        rm -f "$made_from" 2>>"$log" || explain
        # uv makes environments without pip, and may be gone since.
        [ -n "$uv" ] || logged .venv/bin/python -m pip --version || logged .venv/bin/python -m ensurepip || explain
    else
        if [ -n "$uv" ]; then find_python; else need_python; fi
        echo "Setting up .venv ${version:+with Python $version }(about a minute, once) ..."
        logged rm -rf .venv || explain
        if [ -n "$uv" ]; then
            logged uv venv --python "${python:-3.13}" .venv || give_up
        else
            logged "$python" -m venv .venv || give_up
        fi
    fi
    install -r environment.txt || give_up
    # flit-core is in environment.txt, so this downloads nothing.
    install --no-deps --no-build-isolation -e . || give_up
    # Matplotlib lists the fonts at its first import and may say so, on stderr, in a student's first notebook.
    logged .venv/bin/python -c 'import matplotlib.font_manager'
    { echo "$here" && cat environment.txt pyproject.toml; } >"$made_from" 2>>"$log" || give_up
    echo "Set up in $(($(date +%s) - begin)) s."
}

give_up() {
    # Half an environment is worth nothing, and on a full disk it is what fills it.
    (explain)
    rm -rf .venv 2>/dev/null
    exit 1
}

lock() {
    start_log
    uv=$(command -v uv)
    if [ -z "$uv" ]; then
        uv=build/uv/bin/uv
        if [ ! -x "$uv" ]; then
            need_python
            echo "Fetching uv, which writes the lock, into build/uv ..."
            { logged rm -rf build/uv && logged "$python" -m venv build/uv &&
                logged build/uv/bin/python -m pip install uv; } || explain
        fi
    fi
    # uv keeps the versions it finds in the file it writes to. It works on a copy, so that an error leaves ours as it was.
    logged cp environment.txt build/environment.txt
    # The flags that say no: no address of an index, which differs from machine to machine, may get in.
    logged "$uv" pip compile --universal --fork-strategy fewest --python-version 3.11 \
        pyproject.toml --group test --group site --group build \
        ${UPGRADE:+--upgrade} --no-header --no-annotate --no-emit-index-url --no-emit-find-links \
        -o build/environment.txt || explain
    {
        # shellcheck disable=SC2016 # the backquotes are for the reader
        echo '# The full lock, written by `make lock` from pyproject.toml: edit that, not this.' &&
            grep -v '^#' build/environment.txt
    } >build/environment.new || explain
    if cmp -s build/environment.new environment.txt; then
        echo "environment.txt stays as it was."
    else
        diff environment.txt build/environment.new | sed -n 's/^[<>]/&/p'
        mv -f build/environment.new environment.txt || stop "environment.txt cannot be written."
    fi
}

case ${1:-} in
'') set_up ;;
lock) lock ;;
*) stop "usage: environment.sh [lock]" ;;
esac
