#!/bin/sh
# Sets up what make needs; if that fails, says in one plain sentence what to do.
#
#   environment.sh          makes or updates .venv, as environment.txt says
#   environment.sh lock     writes environment.txt from pyproject.toml
#   environment.sh bench    makes or updates .venv-bench, in which `make bench` measures other libraries too
#
# PYTHON=... names the interpreter to use, UPGRADE=yes lets `lock` move to newer versions.
# POSIX sh only: a student's sh may be dash, bash or zsh.
set -u
unset CDPATH # else cd may go elsewhere, and print
cd -- "$(dirname -- "$0")/../.." || exit 1

# Robotics machines often have ROS on PYTHONPATH, which would shadow what is installed here. The rest
# would send the packages to another place than .venv.
unset PYTHONPATH PYTHONHOME VIRTUAL_ENV
export PIP_USER=no PIP_DISABLE_PIP_VERSION_CHECK=1

here=$(pwd -P)
log=build/setup.log
venv=.venv
[ "${1:-}" != bench ] || venv=.venv-bench
made_from=$venv/made-from # written last, so a $venv without it was interrupted
python=
version=

# The libraries of the benchmark besides scipy, at versions that work with the numpy of environment.txt, tried on
# Python 3.11. Wheels only: compiling some of these takes an hour.
peers='pin==4.1.0 roboticstoolbox-python==1.5.0 modern-robotics==1.1.1 pytransform3d==3.17.0'
left_out=$venv/left-out # a line for each peer that could not be installed

stop() {
    echo "$*" >&2
    exit 1
}

logged() {
    echo "\$ $*" >>"$log"
    "$@" >>"$log" 2>&1
}

# ---- what is going on ----

with_progress() { # run an installer: all its output goes to the log, and the name of each package to the terminal
    echo "\$ $*" >>"$log"
    rm -f build/status
    {
        "$@" 2>&1
        echo "$?" >build/status
    } | progress
    return "$(cat build/status 2>/dev/null || echo 1)"
}

progress() { # count the packages in the output of pip or uv; by the shell's read, because awk may wait for more input
    total=$(grep -c '^[a-zA-Z0-9]' environment.txt)
    count=0
    while IFS= read -r line; do
        printf '%s\n' "$line" >>"$log"
        case $line in
        Collecting\ *) # pip, one package after the other
            count=$((count + 1))
            name=${line#Collecting }
            tell "  $count of $total: ${name%%[ =<>!~;(]*}"
            ;;
        'Installing collected packages'*) tell "  All are downloaded. Unpacking them, which is the slower half ..." ;;
        Downloading\ * | ' Downloaded '*) [ -z "$uv" ] || tell "  ${line# }" ;;
        Resolved\ * | Prepared\ * | Installed\ * | Bytecode\ *) tell "  $line" ;;
        esac
    done
    [ ! -t 1 ] || printf '\r\033[K'
}

tell() { # on a terminal one line that changes, elsewhere a line each
    if [ -t 1 ]; then printf '\r\033[K%.78s' "$1"; else echo "$1"; fi
}

# ---- what went wrong ----

log_ends_with() { # the last lines only: earlier ones may report problems that were overcome
    tail -n 25 "$log" 2>/dev/null | grep -q -i -E "$1"
}

disk_is_full() { # the log itself may not have fitted, so the free space is checked too
    log_ends_with 'no space left|disk quota|errno 28|os error 28' && return
    free=$(df -Pk . 2>/dev/null | awk 'NR == 2 { print $4 }')
    [ "${free:-100000}" -lt 10000 ]
}

explain() { # stop with the reason that the log gives
    if disk_is_full; then
        stop "The disk is full: make 2 GB of room and run make again (log: $log)."
    elif log_ends_with 'permission denied|read-only file system|operation not permitted'; then
        stop "Something in $venv or in the folder for temporary files cannot be written: change its permissions" \
            "or delete $venv, and run make again (log: $log)."
    elif log_ends_with 'ensurepip|no module named .?venv'; then
        stop "This Python ($version) cannot make environments: install its venv module (on Debian and" \
            "Ubuntu: sudo apt install python${version%.*}-venv) and run make again (log: $log)."
    elif log_ends_with 'name resolution|name or service not known|nodename nor servname|dns error' ||
        log_ends_with 'new ?connection|failed to fetch|unreachable|timed out|timeout|proxy ?error|ssl ?error' ||
        log_ends_with 'max retries|connection (refused|reset|aborted|broken)|remote end closed'; then
        stop "The packages could not be downloaded: check the network connection and run make again" \
            "(log: $log)."
    elif log_ends_with 'no matching distribution|no usable wheels|no wheels with a matching'; then
        stop "Some packages are not made for this Python ($version) or this system: name another Python," \
            "for instance make PYTHON=python3.13 (log: $log)."
    fi
    stop "The set-up failed: the last lines of $log say why. Correct it and run make again."
}

start_log() {
    # in parentheses, because a redirection that fails for `:` ends the shell
    (mkdir -p build && : >"$log") 2>/dev/null && [ -w . ] && return
    disk_is_full && explain
    stop "This folder ($here) cannot be written: change its permissions, or copy it to a folder of yours" \
        "and run make there."
}

# ---- Python ----

new_enough() {
    "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1
}

find_python() {
    if [ -n "${PYTHON:-}" ]; then
        new_enough "$PYTHON" || stop "PYTHON=$PYTHON is not Python 3.11 or newer: name another one."
        python=$PYTHON
    else
        for candidate in python3 python3.14 python3.13 python3.12 python3.11 python; do
            # Run it: a version manager may leave a name without an interpreter.
            if new_enough "$candidate"; then
                python=$candidate
                break
            fi
        done
    fi
    [ -z "$python" ] || version=$("$python" -c 'import platform; print(platform.python_version())')
}

need_python() {
    find_python
    [ -n "$python" ] && return
    found=$(python3 --version 2>/dev/null) && found="only $found" || found=none
    stop "Python 3.11 or newer is needed and there is $found: install one, or name it with" \
        "make PYTHON=/path/to/python3."
}

# ---- the environment ----

contents() { # what it is made from; contents, not times, which a checkout changes
    # The folder too: its scripts contain absolute paths, so a copied or moved environment does not work.
    echo "$here" && cat environment.txt pyproject.toml
    [ "$venv" = .venv ] || echo "$peers"
}

install() {
    # Compiling one of these takes a Fortran compiler and an hour: fail at once if there is no wheel for this Python.
    set -- --only-binary numpy --only-binary scipy --only-binary scikit-learn --only-binary matplotlib "$@"
    if [ -n "$uv" ]; then
        # Compile bytecode now, as pip does: in grading nothing may be written, so each process would compile it again.
        with_progress uv pip install --compile-bytecode --python "$venv/bin/python" "$@"
    else
        with_progress "$venv/bin/python" -m pip install --progress-bar off "$@"
    fi
}

install_all() {
    if [ "$venv" = .venv ]; then
        install -r environment.txt &&
            # flit-core is in environment.txt, so this one downloads nothing
            install --no-deps --no-build-isolation -e .
    else
        install -c environment.txt numpy scipy sympy matplotlib scikit-learn
    fi || return
    # Matplotlib lists the fonts once, and may report that on stderr: do it now, not in a student's first notebook.
    logged "$venv/bin/python" -c 'import matplotlib.font_manager'
    contents >"$made_from" 2>>"$log"
}

update() {
    echo "Bringing $venv up to date (log: $log) ..."
    version=$("$venv/bin/python" -c 'import platform; print(platform.python_version())')
    logged rm -f "$made_from" "$left_out" || explain
    # uv makes environments without pip, and may be gone by now
    [ -n "$uv" ] || logged "$venv/bin/python" -m pip --version || logged "$venv/bin/python" -m ensurepip || explain
    install_all && return
    echo "$here" >"$made_from" # it was not interrupted, so it can be updated once the cause is gone
    explain
}

make_afresh() {
    if [ -n "$uv" ]; then
        find_python # without one, uv downloads it
        version=${version:-3.13}
    else
        need_python
    fi
    echo "Setting up $venv with Python $version, once: $(grep -c '^[a-zA-Z0-9]' environment.txt) packages. It takes" \
        "seconds to a minute with uv and one to ten minutes with pip, by network and machine (log: $log)."
    logged rm -rf "$venv" || explain
    if [ -n "$uv" ]; then
        logged uv venv --python "${python:-$version}" "$venv"
    else
        logged "$python" -m venv "$venv"
    fi && install_all && return
    (explain)
    rm -rf "$venv" # an incomplete environment is useless, and may be what fills the disk
    exit 1
}

set_up() {
    [ -x "$venv/bin/python" ] && contents | cmp -s - "$made_from" && return
    start_log
    uv=$(command -v uv)
    begin=$(date +%s)
    if [ -x "$venv/bin/python" ] && [ "$(head -n 1 "$made_from" 2>/dev/null)" = "$here" ]; then
        update
    else
        make_afresh
    fi
    echo "Set up in $(($(date +%s) - begin)) s."
}

# ---- the libraries of the benchmark ----

install_peers() { # one by one, so that the failure of one does not affect the others
    [ -f "$left_out" ] || for peer in $peers; do echo "$peer"; done >"$left_out" || explain
    [ -s "$left_out" ] || return 0 # what was left out is tried again
    start_log
    uv=$(command -v uv)
    version=$("$venv/bin/python" -c 'import platform; print(platform.python_version())')
    grep '^numpy==' environment.txt >build/numpy.txt
    still=
    while IFS=: read -r peer _; do
        echo "Installing $peer ..."
        : >"$log"
        install --only-binary :all: -c build/numpy.txt "$peer" </dev/null ||
            still="$still$peer: $( (explain) 2>&1)
"
    done <"$left_out"
    printf %s "$still" >"$left_out"
}

# ---- environment.txt ----

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
    # uv keeps the versions that it finds in the file it writes: it gets a copy, so that an error changes nothing.
    rm -f build/environment.txt
    [ ! -f environment.txt ] || logged cp environment.txt build/environment.txt || explain
    # The --no-... options leave out what differs between machines, such as the address of a package index.
    logged "$uv" pip compile --universal --fork-strategy fewest --python-version 3.11 \
        pyproject.toml --group test --group site --group grade --group build ${UPGRADE:+--upgrade} \
        --no-header --no-annotate --no-emit-index-url --no-emit-find-links \
        -o build/environment.txt || explain
    {
        # shellcheck disable=SC2016 # the backquotes are for the reader
        echo '# The full lock, written by `make lock` from pyproject.toml: edit that, not this.'
        grep -v '^#' build/environment.txt
    } >build/environment.new || explain
    if cmp -s build/environment.new environment.txt; then
        echo "environment.txt stays as it is."
    else
        diff environment.txt build/environment.new 2>/dev/null | grep '^[<>]'
        mv -f build/environment.new environment.txt || stop "environment.txt cannot be written: change its permissions."
        echo "environment.txt has been rewritten; the next make updates .venv."
    fi
}

case ${1:-} in
'') set_up ;;
lock) lock ;;
bench) set_up && install_peers ;;
*) stop "usage: environment.sh [lock | bench]" ;;
esac
