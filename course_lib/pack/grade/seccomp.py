"""A filter of system calls for the sandbox, set through prctl: a dozen lines instead of a package that must be built.

The calls here hold memory that no limit of a process counts (memfd_create, a tmpfs in namespaces of one's own, message
queues, large pipes), or open large parts of the kernel that numerical work has no use for. All fail with "operation not
permitted". Numbers: Linux's arch/x86/entry/syscalls/syscall_64.tbl and include/uapi/asm-generic/unistd.h.
"""

import errno
import platform
import struct

X86_64, AARCH64 = "x86_64", "aarch64"
ARCHITECTURES = {X86_64: 0xC000003E, AARCH64: 0xC00000B7}  # AUDIT_ARCH_*
DENIED = {  # name: its number on x86_64, and on aarch64
    "memfd_create": (319, 279),
    "memfd_secret": (447, 447),
    "unshare": (272, 97),
    "setns": (308, 268),
    "mount": (165, 40),
    "umount2": (166, 39),
    "pivot_root": (155, 41),
    "open_tree": (428, 428),
    "move_mount": (429, 429),
    "fsopen": (430, 430),
    "fsconfig": (431, 431),
    "fsmount": (432, 432),
    "fspick": (433, 433),
    "mount_setattr": (442, 442),
    "userfaultfd": (323, 282),
    "io_uring_setup": (425, 425),
    "io_uring_enter": (426, 426),
    "io_uring_register": (427, 427),
    "bpf": (321, 280),
    "perf_event_open": (298, 241),
    "keyctl": (250, 219),
    "add_key": (248, 217),
    "request_key": (249, 218),
    "ptrace": (101, 117),
    "process_vm_readv": (310, 270),
    "process_vm_writev": (311, 271),
    "pidfd_getfd": (438, 438),
    "shmget": (29, 194),
    "msgget": (68, 186),
    "semget": (64, 190),
    "mq_open": (240, 180),
}
CLONE, CLONE3, FCNTL = (56, 220), (435, 435), (72, 25)
NEW_NAMESPACES = 0x7E020000  # all CLONE_NEW... flags
SET_PIPE_SIZE = 1031
X32 = 0x40000000  # the second set of numbers on x86_64

LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
NUMBER, ARCHITECTURE, FIRST, SECOND = 0, 4, 16, 24  # where in seccomp_data
ALLOW, KILL, ERRNO = 0x7FFF0000, 0x80000000, 0x00050000


def program(machine=None):
    """Return the filter for a kind of processor as the kernel takes it, 8 bytes an instruction; b"" if there is none.

    Examples
    --------
    >>> len(program("x86_64")) % 8, program("riscv64")
    (0, b'')
    """
    machine = machine or (platform.machine() if platform.system() == "Linux" else "")
    if machine not in ARCHITECTURES:
        return b""
    column = 0 if machine == X86_64 else 1
    denied = sorted(numbers[column] for numbers in DENIED.values())
    steps = [(LOAD, 0, 0, ARCHITECTURE), (EQUAL, 1, 0, ARCHITECTURES[machine]), (RETURN, 0, 0, KILL)]
    steps += [(LOAD, 0, 0, NUMBER)]
    no, unknown = (RETURN, 0, 0, ERRNO | errno.EPERM), (RETURN, 0, 0, ERRNO | errno.ENOSYS)
    if machine == X86_64:
        steps += [(AT_LEAST, 0, 1, X32), no]
    for number in denied:
        steps += [(EQUAL, 0, 1, number), no]
    steps += [
        (EQUAL, 0, 1, CLONE3[column]),
        unknown,
    ]  # its flags are in memory, out of reach; the C library then uses clone
    steps += [(EQUAL, 0, 4, CLONE[column]), (LOAD, 0, 0, FIRST), (ANY_BIT, 0, 1, NEW_NAMESPACES), no]
    steps += [(RETURN, 0, 0, ALLOW)]
    steps += [(EQUAL, 0, 3, FCNTL[column]), (LOAD, 0, 0, SECOND), (EQUAL, 0, 1, SET_PIPE_SIZE), no]
    steps += [(RETURN, 0, 0, ALLOW)]
    return b"".join(struct.pack("=HBBI", *step) for step in steps)
