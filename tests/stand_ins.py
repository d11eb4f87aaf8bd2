"""Stand-ins for Python and uv, for tests that would otherwise download, and what the real ones say.

They note every call in $CALLS. The texts are those of pip 23, uv 0.13 and Debian 12.
"""

PYTHON = """#!/bin/sh
echo "python $*" >>"$CALLS"
case "$*" in
*"version_info < (3, 11)"*) [ "$MINOR" -ge 11 ] ;;
*python_version*) echo "3.$MINOR.2" ;;
--version) echo "Python 3.$MINOR.2" ;;
"-m venv "*)
    [ -z "${VENV_SAYS:-}" ] || { echo "$VENV_SAYS"; exit 1; }
    mkdir -p "$3/bin" && cp "$0" "$3/bin/python" ;;
"-m pip install"*)
    [ -z "${DIES:-}" ] || { read -r _ _ _ script _ <"/proc/$PPID/stat"; kill -9 "$script" "$PPID"; }
    case "$*" in *"-r environment.txt"*)
        echo "Collecting numpy==2.4.6 (from -r environment.txt (line 2))"
        echo "  Downloading numpy-2.4.6.whl (16 MB)"
        echo "Collecting scipy<2,>=1.15 (from -r environment.txt (line 3))"
        echo "Installing collected packages: numpy, scipy" ;;
    esac
    case "$*" in *"${ONLY:-}"*) [ -z "${PIP_SAYS:-}" ] || { echo "$PIP_SAYS" >&2; exit 1; } ;; esac ;;
"-m ensurepip") exit "${NO_ENSUREPIP:-0}" ;;
esac
"""

UV = """#!/bin/sh
echo "uv $*" >>"$CALLS"
case "$1 $2" in
"venv --python") mkdir -p "$4/bin" && cp "$PYTHON_STAND_IN" "$4/bin/python" ;;
"pip install")
    [ -z "${UV_SAYS:-}" ] || { echo "$UV_SAYS" >&2; exit 2; }
    printf 'Resolved 2 packages in 12ms\nDownloading numpy (15.8MiB)\n Downloaded numpy\n' >&2
    printf 'Installed 2 packages in 40ms\n + numpy==2.4.6\n' >&2 ;;
"pip compile")
    [ -z "${UV_SAYS:-}" ] || { echo "$UV_SAYS" >&2; exit 2; }
    for last; do :; done
    grep -v '^#' "$last" >"$last.kept"
    { cat "$last.kept"; [ -z "${ADDS:-}" ] || echo "$ADDS"; } >"$last" ;;
esac
"""

# ---- what goes wrong ----

DEBIAN = """The virtual environment was not created successfully because ensurepip is not
available.  On Debian/Ubuntu systems, you need to install the python3-venv
package using the following command.

    apt install python3.12-venv
"""
OFFLINE = """WARNING: Retrying (Retry(total=0, connect=None, read=None, redirect=None, status=None)) after connection \
broken by 'NewConnectionError('<HTTPSConnection>: Failed to establish a new connection: [Errno -2] Name or service \
not known')': /simple/numpy/
ERROR: Could not find a version that satisfies the requirement numpy==2.4.6 (from versions: none)
ERROR: No matching distribution found for numpy==2.4.6"""
NOT_MADE = """ERROR: Could not find a version that satisfies the requirement numpy==2.4.6 (from versions: 1.3.0, 2.0.0)
ERROR: No matching distribution found for numpy==2.4.6"""
FULL = "ERROR: Could not install packages due to an OSError: [Errno 28] No space left on device"
DENIED = "ERROR: Could not install packages due to an OSError: [Errno 13] Permission denied: '.venv/lib/numpy'"
BUG = 'Traceback (most recent call last):\n  File "pip.py", line 1, in <module>\nKeyError: 1'

UV_OFFLINE = """error: Failed to fetch: numpy
  cause: client error (Connect)
  cause: dns error
  cause: failed to lookup address information: Temporary failure in name resolution"""
UV_FULL = "error: Failed to install: numpy\n  cause: failed to copy file: No space left on device (os error 28)"
UV_NOT_MADE = "  cause: Because numpy==2.4.6 has no wheels with a matching Python ABI tag, we can conclude ..."
