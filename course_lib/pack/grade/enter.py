"""Enter namespaces of its own and run a command there: the script that isolates where bubblewrap is not installed.

Started with a JSON object as its only argument: "mounts", [[source, target], ...], shown read-only; "covered",
[[target, whether a folder], ...] in them; "rooms", [[path, bytes], ...], empty and writable; "root", an empty folder in
which this view of the file system is built; "command". Messages on stderr are for the grader: why the sandbox could not
be entered.
"""

import ctypes
import json
import os
import socket
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from confine import call, die_with_parent

MOUNTS, HOST_NAME, MESSAGES, USERS, PROCESSES, NETWORK = (
    0x00020000, 0x04000000, 0x08000000, 0x10000000, 0x20000000, 0x40000000,
)  # fmt: skip
READ_ONLY, NO_SETUID, NO_DEVICES, NO_PROGRAMS, REMOUNT, BIND, RECURSIVE, PRIVATE = 1, 2, 4, 8, 32, 4096, 16384, 1 << 18
DETACH = 2


def main():
    """Enter the namespaces and run the command; see the top of this file."""
    wanted = json.loads(sys.argv[1])
    os.umask(0o022)
    try:
        die_with_parent()
        unshare()
        first = os.fork()  # the namespaces' first process: when it ends, all others end
        if first:
            os._exit(status_of(first))
        die_with_parent()
        socket.sethostname("sandbox")
        build(wanted)
        child = os.fork()
        if child:
            os._exit(status_of(child))
        os.setsid()
        os.chdir("/scratch")
        os.execv(wanted["command"][0], wanted["command"])
    except OSError as problem:
        print(problem, file=sys.stderr, flush=True)
        os._exit(1)


def status_of(child):
    """Reap processes until this child ends; return its exit code."""
    while True:
        pid, status = os.wait()
        if pid == child:
            return os.waitstatus_to_exitcode(status) & 0xFF


def unshare():
    """Enter new namespaces. Without root, a user namespace is needed too; its map holds only this user."""
    user, group = os.getuid(), os.getgid()
    call("unshare", MOUNTS | HOST_NAME | MESSAGES | PROCESSES | NETWORK | (USERS if user else 0))
    if user:
        for name, text in (("setgroups", "deny"), ("uid_map", f"{user} {user} 1"), ("gid_map", f"{group} {group} 1")):
            with open(f"/proc/self/{name}", "w") as file:
                file.write(text)
        die_with_parent()  # the setting is lost when the user changes


def build(wanted):
    """Build a root folder in which only the wanted paths are, and leave the machine's root."""
    root = wanted["root"]
    mount(None, "/", None, RECURSIVE | PRIVATE)
    mount("root", root, "tmpfs", NO_SETUID | NO_DEVICES, "size=4m,mode=755")
    for path, size in wanted["rooms"]:
        os.makedirs(root + path)
        mount("room", root + path, "tmpfs", NO_SETUID | NO_DEVICES, f"size={size},mode=1777")
    for source, target in wanted["mounts"]:
        show(source, root + target)
    for target, is_folder in wanted["covered"]:
        if is_folder:
            mount("hidden", root + target, "tmpfs", READ_ONLY | NO_SETUID | NO_DEVICES, "size=4k,mode=755")
        else:
            mount("/dev/null", root + target, None, BIND)
    os.chdir(root)
    call("pivot_root", b".", b".")
    call("umount2", b".", DETACH)
    mount(None, "/", None, REMOUNT | BIND | READ_ONLY | NO_SETUID | NO_DEVICES)


def show(source, target):
    """Show a file or folder of the system at `target`, read-only."""
    folder = target if os.path.isdir(source) else os.path.dirname(target)
    os.makedirs(folder, exist_ok=True)
    if folder != target:
        with open(target, "w"):
            pass
    mount(source, target, None, BIND)
    kept = os.statvfs(target).f_flag & (NO_SETUID | NO_DEVICES | NO_PROGRAMS)
    mount(None, target, None, REMOUNT | BIND | READ_ONLY | NO_SETUID | kept)


def mount(source, target, kind, flags, options=""):
    """Mount a file system or a folder; None for what the kernel ignores."""
    encoded = (None if text is None else text.encode() for text in (source, target, kind))
    call("mount", *encoded, ctypes.c_ulong(flags), options.encode())


if __name__ == "__main__":
    main()
