"""Bound what this process and all that it starts may use: the first thing that the sandbox's script
does.

No student's code has run yet. Limits of the kernel hold for each process; a filter refuses the
system calls that reserve memory outside those limits (anonymous files, message queues, large pipes,
file systems in namespaces of one's own, properties of files, watches of files, asynchronous
requests, pages that a pipe keeps after they were given back), leave something for another sandbox
to see (locks on files that both see, properties of other processes), reach another machine or open
large parts of the kernel that numerical work has no use for. Calls of Linux up to 5.1 are permitted
unless they are listed here; of the newer ones only those listed are.

The filter is assembled here, from numbers, because nothing else does it better. `pyseccomp` is a
binding of the C library libseccomp, which is not installed everywhere and which pip cannot install,
and the students' Python in the sandbox would need it. bubblewrap's --seccomp reads a file of the
same instructions, which libseccomp would write, or this module. Such a filter would also hold for
bubblewrap's own last steps and for the change of the user below, whose calls it would have to
permit to the student as well.
"""

import contextlib
import ctypes
import errno
import os
import platform
import resource
import signal
import struct
import sys

LIBC = ctypes.CDLL(None, use_errno=True)
DIE_WITH_PARENT, SET_SECCOMP, DROP_BOUND, NO_NEW_PRIVILEGES, SECCOMP_FILTER = 1, 22, 24, 38, 2
AMBIENT, CLEAR_ALL = 47, 4  # linux/prctl.h: PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL
CAPABILITIES_VERSION_3 = 0x20080522  # linux/capability.h

# Linux: arch/x86/entry/syscalls/syscall_64.tbl, include/uapi/asm-generic/unistd.h
ARCHITECTURES = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}  # AUDIT_ARCH_*
REFUSED = {  # name: its number on x86_64, and on aarch64; None if that has no such call
    "memfd_create": (319, 279),
    "unshare": (272, 97),
    "setns": (308, 268),
    "mount": (165, 40),
    "umount2": (166, 39),
    "pivot_root": (155, 41),
    "userfaultfd": (323, 282),
    "bpf": (321, 280),
    "perf_event_open": (298, 241),
    "keyctl": (250, 219),
    "add_key": (248, 217),
    "request_key": (249, 218),
    "ptrace": (101, 117),
    "process_vm_readv": (310, 270),
    "process_vm_writev": (311, 271),
    "shmget": (29, 194),
    "msgget": (68, 186),
    "semget": (64, 190),
    "mq_open": (240, 180),
    "flock": (73, 32),
    "io_setup": (206, 0),
    "inotify_init": (253, None),
    "inotify_init1": (294, 26),
    "fanotify_init": (300, 262),
    "vmsplice": (278, 75),
    "setxattr": (188, 5),
    "lsetxattr": (189, 6),
    "fsetxattr": (190, 7),
    "timer_create": (222, 107),
}
# from here on all processors share the numbers; the C library does without any of these calls
FIRST_NEW = 424
NEW_PERMITTED = {
    "close_range": 436,
    "faccessat2": 439,
    "epoll_pwait2": 441,
    "futex_waitv": 449,
    "fchmodat2": 452,
}
# linux/sched.h: all CLONE_NEW... flags. linux/fcntl.h: F_SETPIPE_SZ, F_SETLK, F_SETLKW,
# F_OFD_SETLK, F_OFD_SETLKW, F_SETLEASE, F_NOTIFY. linux/socket.h: AF_UNIX, AF_INET, AF_INET6,
# AF_NETLINK.
# name: its numbers, the argument that is looked at, values of it, whether these are permitted
CHECKED = {
    "clone": ((56, 220), 0, (0x7E020000,), False),
    "fcntl": ((72, 25), 1, (1031, 6, 7, 37, 38, 1024, 1026), False),
    "prlimit64": ((302, 261), 0, (0,), True),
    "setpriority": ((141, 140), 1, (0,), True),
    "socket": ((41, 198), 0, (1, 2, 10, 16), True),
}
X32 = 0x40000000  # the second set of numbers on x86_64

MAX_PENDING = 256  # signals that wait: each takes memory of the kernel

LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
NUMBER, ARCHITECTURE, ARGUMENTS = 0, 4, 16  # where in seccomp_data; an argument has 8 bytes
ALLOW, KILL, ERRNO = 0x7FFF0000, 0x80000000, 0x00050000


def confine(limits: dict, uid: int = 0) -> None:
    """Bound this process.

    limits: a dict of the Limits in sandbox.py; uid: the user to become, 0 to stay.
    """
    for kind, most in (
        ("RLIMIT_AS", limits["memory"]),
        ("RLIMIT_FSIZE", limits["file"]),
        ("RLIMIT_NOFILE", limits["files"]),
        ("RLIMIT_NPROC", limits["processes"]),
        ("RLIMIT_SIGPENDING", MAX_PENDING),
        ("RLIMIT_MEMLOCK", 0),
        ("RLIMIT_MSGQUEUE", 0),
        ("RLIMIT_CORE", 0),
        ("RLIMIT_CPU", resource.RLIM_INFINITY),  # the grader's own bound is for the grader only
    ):
        if most is not None:
            with contextlib.suppress(ValueError, OSError, AttributeError):  # macOS lacks some
                resource.setrlimit(getattr(resource, kind), (most, most))
    if uid:
        for right in range(64):
            with contextlib.suppress(OSError):  # beyond the last capability of this kernel
                control(DROP_BOUND, right)
        os.setgroups([])
        os.setresgid(uid, uid, uid)
        os.setresuid(uid, uid, uid)
    if sys.platform == "linux":
        give_up_rights()
        die_with_parent()  # the setting is lost when the user changes
        control(NO_NEW_PRIVILEGES, 1)
        filter_calls(program(platform.machine()))


def control(option: int, *values: int) -> None:
    """Set a property of this process by prctl; raise OSError if that fails."""
    if LIBC.prctl(option, *map(ctypes.c_ulong, [*values, 0, 0, 0, 0][:4])) != 0:
        number = ctypes.get_errno()
        raise OSError(number, f"prctl: {os.strerror(number)}")


def give_up_rights() -> None:
    """Give up all capabilities, which the process that this one was forked from has needed."""

    class Header(ctypes.Structure):
        _fields_ = (("version", ctypes.c_uint32), ("process", ctypes.c_int))

    class Rights(ctypes.Structure):  # effective, permitted and inheritable ones, twice 32 of them
        _fields_ = (("bits", ctypes.c_uint32 * 6),)

    control(AMBIENT, CLEAR_ALL)
    header, none = Header(CAPABILITIES_VERSION_3, 0), Rights()
    if LIBC.capset(ctypes.byref(header), ctypes.byref(none)) != 0:
        number = ctypes.get_errno()
        raise OSError(number, f"capset: {os.strerror(number)}")


def die_with_parent() -> None:
    """Let the kernel kill this process when its parent ends; only Linux offers that."""
    if sys.platform == "linux":
        control(DIE_WITH_PARENT, signal.SIGKILL)


def filter_calls(code: bytes) -> None:
    """Let the kernel refuse some system calls of this process and of all that it starts."""

    class Program(ctypes.Structure):
        _fields_ = (("length", ctypes.c_ushort), ("filter", ctypes.c_char_p))

    program = Program(len(code) // 8, code)
    control(SET_SECCOMP, SECCOMP_FILTER, ctypes.addressof(program))


def program(machine: str) -> bytes:
    """Return the filter for a kind of processor as the kernel takes it, 8 bytes an instruction."""
    if machine not in ARCHITECTURES:
        raise OSError(errno.ENOSYS, f"there is no filter of system calls for {machine}")
    column = list(ARCHITECTURES).index(machine)
    no, unknown, yes = (
        (RETURN, 0, 0, value) for value in (ERRNO | errno.EPERM, ERRNO | errno.ENOSYS, ALLOW)
    )  # the C library does without a call that is unknown
    steps = [
        (LOAD, 0, 0, ARCHITECTURE),
        (EQUAL, 1, 0, ARCHITECTURES[machine]),
        (RETURN, 0, 0, KILL),
    ]
    steps += [(LOAD, 0, 0, NUMBER)]
    if machine == "x86_64":
        steps += [(AT_LEAST, 0, 1, X32), no]
    for number in NEW_PERMITTED.values():
        steps += [(EQUAL, 0, 1, number), yes]
    steps += [(AT_LEAST, 0, 1, FIRST_NEW), unknown]
    for numbers in REFUSED.values():
        if numbers[column] is not None:
            steps += [(EQUAL, 0, 1, numbers[column]), no]
    for name, (numbers, argument, values, permitted) in CHECKED.items():
        test, (hit, miss) = (
            ANY_BIT if name == "clone" else EQUAL,
            (yes, no) if permitted else (no, yes),
        )
        tests = [(test, len(values) - i, 0, value) for i, value in enumerate(values)]
        body = [(LOAD, 0, 0, ARGUMENTS + 8 * argument), *tests, miss, hit]
        steps += [(EQUAL, 0, len(body), numbers[column]), *body]
    steps.append(yes)
    return b"".join(struct.pack("=HBBI", *step) for step in steps)
