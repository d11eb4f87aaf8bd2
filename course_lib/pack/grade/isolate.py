"""Enter a sandbox and run a command there: a script of its own, started with a JSON object as its only argument.

    {"apart": bool,       whether to take namespaces of its own: processes, mounts, network, messages, host name
     "root": path,        an empty folder in which the sandbox's view of the file system is built (if apart)
     "visible": [[path, bool]],  paths that are shown there read-only (True) or hidden; outer folders first
     "course": path,      shown as /course, read-only
     "scratch": path,     the one writable folder; if not apart, the caller empties it
     "uid": number,       the user to become, 0 to stay
     "limits": {...},     memory, file, files, processes, scratch, everything: see sandbox.py
     "filter": text,      a filter of system calls, in hexadecimal digits: see seccomp.py
     "command": [...]}

Messages on stderr are for the grader: why the sandbox could not be entered, or why it was ended.
"""

import contextlib
import ctypes
import json
import os
import resource
import signal
import sys
import time

LIBC = ctypes.CDLL(None, use_errno=True)
NEW_MOUNTS, NEW_NAME, NEW_MESSAGES, NEW_USER, NEW_PROCESSES, NEW_NETWORK = (
    0x00020000,
    0x04000000,
    0x08000000,
    0x10000000,
    0x20000000,
    0x40000000,
)
READ_ONLY, NO_SETUID, NO_DEVICES, NO_PROGRAMS, REMOUNT, BIND, RECURSIVE, PRIVATE = 1, 2, 4, 8, 32, 4096, 16384, 1 << 18
DETACH = 2
DIE_WITH_PARENT, NOT_DUMPABLE, SET_SECCOMP, DROP_BOUND, SUBREAPER, NO_NEW_PRIVILEGES = 1, 4, 22, 24, 36, 38
SECCOMP_FILTER = 2
DEVICES = ("null", "zero", "full", "random", "urandom")
ENDED = 111  # exit code if this script ended the sandbox


def main():
    """Enter the sandbox and run the command; see the top of this file."""
    wanted = json.loads(sys.argv[1])
    die_with_parent()
    try:
        if wanted["apart"]:
            unshare(wanted["uid"] == 0)
        else:
            control(SUBREAPER, 1)
        child = os.fork()  # with namespaces this is their first process: when it ends, all others end
        if child:
            os._exit(watch(child, wanted["limits"], every=not wanted["apart"]))
        if wanted["apart"]:
            die_with_parent()
            build(wanted)
            os.chdir("/")
            control(NOT_DUMPABLE, 0)
            child = os.fork()
            if child:
                os._exit(watch(child, wanted["limits"], every=True))
        start(wanted)
    except OSError as problem:
        print(f"{problem}", file=sys.stderr)
        os._exit(ENDED)


def start(wanted):
    """Replace this process by the command, without the privileges that it does not need."""
    os.setsid()
    take_away(wanted)
    home = wanted["scratch"]
    os.chdir(home)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    environment = {"HOME": home, "PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "PYTHONHASHSEED": "0", "TMPDIR": home}
    environment |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MPLBACKEND": "Agg", "MPLCONFIGDIR": home}
    os.execve(wanted["command"][0], wanted["command"], environment)


# ---- namespaces ----


def call(name, *arguments):
    """Call a function of the C library; raise OSError if it fails."""
    if getattr(LIBC, name)(*arguments) != 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{name}: {os.strerror(number)}")


def control(option, value):
    """Set a property of this process by prctl."""
    call("prctl", option, ctypes.c_ulong(value), 0, 0, 0)


def die_with_parent():
    """Let the kernel kill this process when its parent ends; only Linux offers that."""
    if sys.platform == "linux":
        control(DIE_WITH_PARENT, signal.SIGKILL)


def unshare(as_user):
    """Enter new namespaces. Without root, a user namespace is needed too; its map holds only this user."""
    user, group = os.getuid(), os.getgid()
    apart = NEW_MOUNTS | NEW_NAME | NEW_MESSAGES | NEW_PROCESSES | NEW_NETWORK
    call("unshare", apart | (NEW_USER if as_user else 0))
    if as_user:
        write("/proc/self/setgroups", "deny")
        write("/proc/self/uid_map", f"0 {user} 1")
        write("/proc/self/gid_map", f"0 {group} 1")
    die_with_parent()  # the setting is lost when the user changes


def write(path, text):
    """Write a text to a file of the kernel's."""
    with open(path, "w") as file:
        file.write(text)


def mount(source, target, kind, flags, options=""):
    """Mount a file system or a folder; None for what the kernel ignores."""
    call(
        "mount",
        source.encode() if source else None,
        target.encode(),
        kind.encode() if kind else None,
        ctypes.c_ulong(flags),
        options.encode() if options else None,
    )


def build(wanted):
    """Build a root folder from the visible paths, and leave the machine's root."""
    root, room = wanted["root"], wanted["limits"]["scratch"]
    mount(None, "/", None, RECURSIVE | PRIVATE)
    mount("root", root, "tmpfs", NO_SETUID | NO_DEVICES, "size=4m,mode=755")
    # First, because the environment itself may be below /tmp, and is then mounted inside it.
    for folder, size in ((wanted["scratch"], room), ("/tmp", room // 4)):
        os.makedirs(root + folder)
        mount("scratch", root + folder, "tmpfs", NO_SETUID | NO_DEVICES, f"size={size},mode=777")
    covered = []
    for path, is_shown in wanted["visible"]:
        if is_shown:
            show(path, root + path)
        else:
            mount("hidden", root + path, "tmpfs", NO_SETUID | NO_DEVICES | NO_PROGRAMS, "size=64k,mode=755")
            covered.append(root + path)
    for path in covered:  # only now: mounts inside the hidden folders needed mount points there
        mount(None, path, None, REMOUNT | BIND | READ_ONLY | NO_SETUID | NO_DEVICES | NO_PROGRAMS)
    show(wanted["course"], root + "/course")
    for device in DEVICES:
        touch(f"{root}/dev/{device}")
        mount(f"/dev/{device}", f"{root}/dev/{device}", None, BIND)
    os.makedirs(root + "/proc")
    with contextlib.suppress(OSError):  # many containers do not allow it, and it is not needed
        mount("proc", root + "/proc", "proc", NO_SETUID | NO_DEVICES | NO_PROGRAMS)
        write(root + "/proc/sys/kernel/shmall", "16384")
    os.chdir(root)
    call("pivot_root", b".", b".")
    call("umount2", b".", DETACH)
    mount(None, "/", None, REMOUNT | BIND | READ_ONLY | NO_SETUID | NO_DEVICES)


def show(path, target):
    """Show a file, folder or link of the system at `target`, read-only."""
    if os.path.islink(path) and not os.path.lexists(target):
        os.makedirs(os.path.dirname(target), exist_ok=True)
        os.symlink(os.readlink(path), target)
        return
    if os.path.isdir(path):
        os.makedirs(target, exist_ok=True)
    else:
        touch(target)
    mount(path, target, None, BIND)
    kept = os.statvfs(target).f_flag & (NO_SETUID | NO_DEVICES | NO_PROGRAMS)
    mount(None, target, None, REMOUNT | BIND | READ_ONLY | NO_SETUID | kept)


def touch(path):
    """Make an empty file, and the folders above it."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w"):
        pass


# ---- limits ----


def take_away(wanted):
    """Set the limits, and drop all privileges beyond those of a normal user."""
    limits, uid = wanted["limits"], wanted["uid"]
    if sys.platform == "linux" and os.getuid() == 0:
        for right in range(64):
            with contextlib.suppress(OSError):  # beyond the last capability of this kernel
                control(DROP_BOUND, right)
    for kind, most in (
        ("RLIMIT_AS", limits["memory"]),
        ("RLIMIT_FSIZE", limits["file"]),
        ("RLIMIT_NOFILE", limits["files"]),
        ("RLIMIT_NPROC", limits["processes"] if limits["count_processes"] else resource.RLIM_INFINITY),
        ("RLIMIT_CORE", 0),
        ("RLIMIT_CPU", resource.RLIM_INFINITY),  # the grader's own bound is for the grader only
    ):
        with contextlib.suppress(ValueError, OSError):  # macOS refuses some
            resource.setrlimit(getattr(resource, kind), (most, most))
    if uid:
        os.setgroups([])
        os.setresgid(uid, uid, uid)
        os.setresuid(uid, uid, uid)
    if sys.platform == "linux":
        control(NO_NEW_PRIVILEGES, 1)
        die_with_parent()
        filter_calls(bytes.fromhex(wanted["filter"]))


def filter_calls(code):
    """Let the kernel refuse some system calls of this process and of all that it starts. code: see seccomp.py."""
    if not code:
        return

    class Program(ctypes.Structure):
        _fields_ = (("length", ctypes.c_ushort), ("filter", ctypes.c_char_p))

    call("prctl", SET_SECCOMP, SECCOMP_FILTER, ctypes.byref(Program(len(code) // 8, code)), 0, 0)


def watch(child, limits, every):
    """Wait for the child; end everything if it exceeds a limit or SIGTERM comes. Return an exit code."""
    awaited = [signal.SIGCHLD, signal.SIGTERM]
    signal.pthread_sigmask(signal.SIG_BLOCK, awaited)
    code, came = None, None
    while code is None and came != signal.SIGTERM:
        if every and (reason := too_much(limits)):
            print(reason, file=sys.stderr, flush=True)
            code = ENDED
        elif hasattr(signal, "sigtimedwait"):
            received = signal.sigtimedwait(awaited, 0.2)
            came = received.si_signo if received else None
        else:
            came = signal.sigwait(awaited)
        code = code if code is not None else reaped(child)
    end_all(child)
    return ENDED if code is None else code


def reaped(child):
    """Reap all processes that have ended; return the child's exit code if it is among them, else None."""
    while True:
        try:
            pid, status = os.waitpid(-1, os.WNOHANG)
        except ChildProcessError:
            return ENDED
        if pid == 0:
            return None
        if pid == child:
            return os.waitstatus_to_exitcode(status) & 0xFF


def below(root=None):
    """Return {pid: Usage} of all descendants of the process `root`; None is this process."""
    root, parents, found = root or os.getpid(), {}, {}
    with contextlib.suppress(OSError):
        for name in filter(str.isdigit, os.listdir("/proc")):
            with contextlib.suppress(OSError, IndexError, ValueError), open(f"/proc/{name}/stat") as file:
                fields = file.read().rpartition(")")[2].split()
                parents.setdefault(int(fields[1]), []).append(int(name))
                own, ended = int(fields[11]) + int(fields[12]), int(fields[13]) + int(fields[14])
                found[int(name)] = (int(fields[21]), own, ended)
    usages, level, depth = {}, parents.get(root, []), 1
    while level:
        usages |= {pid: Usage(depth, *found[pid]) for pid in level}
        level, depth = [child for pid in level for child in parents.get(pid, [])], depth + 1
    return usages


class Usage:
    """Pages of memory and ticks of processor time of a process, and the ticks of its children that have ended.

    depth: 1 for a child, 2 for a child's child, and so on.
    """

    def __init__(self, depth, pages, ticks, ticks_of_ended):
        self.depth, self.pages, self.ticks, self.ticks_of_ended = depth, pages, ticks, ticks_of_ended


def too_much(limits):
    """Return which bound the descendants of this process exceed, or ""."""
    running = below()
    if len(running) > limits["processes"] + 5:
        return f"more than {limits['processes']} processes"
    if sum(usage.pages for usage in running.values()) * resource.getpagesize() > limits["everything"]:
        return f"more than {limits['everything'] // 10**9} GB of memory"
    return ""


def end_all(child):
    """Kill all descendants of this process; the next round catches those that start in the meantime."""
    with contextlib.suppress(OSError):
        os.killpg(child, signal.SIGKILL)
    for _ in range(100):
        left = below()
        if not left:
            return
        for pid in left:
            with contextlib.suppress(OSError):
                os.kill(pid, signal.SIGKILL)
        with contextlib.suppress(ChildProcessError):
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        time.sleep(0.01)


if __name__ == "__main__":
    main()
