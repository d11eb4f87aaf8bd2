"""Noise in the last bits of what numpy computes: another processor, on this one.

OpenBLAS chooses its kernels by the processor, numpy its loops and glibc its sines, so that sums of
products and elementary functions end in other last bits elsewhere. `begin` puts this difference
below Python, into numpy's own loops, where neither a notebook nor a check can see it: results are
multiplied by 1 + k 2^-53, with k = -2 ... 2. What is exact on every processor stays exact: sums,
products, quotients and square roots of single numbers, and results that are multiples of 1/4, such
as sin(0), and products of matrices of whole numbers.

    import rounding_noise
    rounding_noise.begin(seed=7)  # until the process ends
"""

import ctypes
import math
import re
import types

import numpy as np
from numpy._core import _multiarray_umath, einsumfunc
from numpy.linalg import _linalg, _umath_linalg

ELEMENTARY = (
    "sin cos tan arcsin arccos arctan arctan2 sinh cosh tanh arcsinh arccosh arctanh exp expm1 exp2 "
    "log log1p log2 log10 logaddexp power float_power cbrt hypot deg2rad rad2deg degrees radians"
)
PRODUCTS = "matmul vecdot matvec vecmat"
DECOMPOSITIONS = (
    "cholesky_lo cholesky_up det eigh_lo eigh_up eigvalsh_lo eigvalsh_up inv lstsq qr_complete "
    "qr_r_raw qr_reduced slogdet solve solve1 svd svd_f svd_s"
)

_REPLACE_LOOP = 30  # the place of PyUFunc_ReplaceLoopBySignature in numpy's table of functions
_DOUBLE, _INT = 12, 5  # numpy's numbers of these types
_POINTERS = ctypes.POINTER(ctypes.c_void_p)
_SIZES = ctypes.POINTER(ctypes.c_ssize_t)
_Loop = ctypes.CFUNCTYPE(None, _POINTERS, _SIZES, _SIZES, ctypes.c_void_p)

_FEW = 40  # numbers that are shaken faster one by one than as an array

_kept = []  # a loop that Python deleted would end the process when numpy calls it


class _Noise:
    """Factors 1 + k 2^-53 that follow from the number and the seed, so that the same computation
    gives the same number again, as it does on every processor."""

    def __init__(self, seed):
        self._odd = 0x9E3779B97F4A7C15 + 2 * seed

    def shake(self, values):
        """Multiply an array by factors, in place, wherever it is no multiple of 1/4."""
        bits = np.ascontiguousarray(values).view(np.uint64)
        k = (bits * np.uint64(self._odd) >> np.uint64(40)) % np.uint64(5)
        factors = 1 + (k.astype(float) - 2) * 2.0**-53
        fourfold = values * 4
        inexact = fourfold != np.rint(fourfold)
        np.multiply(values, factors, out=values, where=inexact & np.isfinite(values))

    def shake_few(self, address, count):
        """Multiply adjacent numbers at an address by the same factors as `shake` does."""
        numbers = (ctypes.c_double * count).from_address(address)
        every_bits = (ctypes.c_uint64 * count).from_address(address)[:]
        for place, value in enumerate(numbers[:]):
            if not (4 * value).is_integer():
                k = ((every_bits[place] * self._odd & 0xFFFFFFFFFFFFFFFF) >> 40) % 5
                numbers[place] = value * (1 + (k - 2) * 2.0**-53)

    def shaken(self, value):
        """Return a number or an array with noise, anything else as it is."""
        if isinstance(value, np.ndarray) and value.dtype == float and value.flags.writeable:
            self.shake(value)
        elif isinstance(value, float):
            number = ctypes.c_double(value)
            self.shake_few(ctypes.addressof(number), 1)
            value = type(value)(number.value)
        return value


class _At:
    """An array of numpy's at an address, which numpy reads through this attribute."""

    def __init__(self, address, shape, strides):
        self.__array_interface__ = {
            "data": (address, False),
            "shape": shape,
            "strides": strides,
            "typestr": "<f8",
            "version": 3,
        }


def begin(seed):
    """Add noise to all that numpy computes in this process from now on.

    Parameters
    ----------
    seed : int
        Of the noise.
    """
    noise = _Noise(seed)
    for name in f"{ELEMENTARY} {PRODUCTS}".split():
        if hasattr(np, name):
            _replace_loop(getattr(np, name), noise)
    for name in DECOMPOSITIONS.split():
        _replace_loop(getattr(_umath_linalg, name), noise)
    _replace_loop(np.add, noise, only_sums=True)
    # These compute by BLAS without a loop that could be replaced.
    einsumfunc.c_einsum = _with_noise(einsumfunc.c_einsum, noise)
    _linalg.sqrt = _with_noise(np.sqrt, noise)  # of a product by BLAS, in np.linalg.norm
    for name in ("dot", "inner", "vdot"):
        setattr(np, name, _with_noise(getattr(np, name), noise))


def _with_noise(function, noise):
    def shaken(*arguments, **options):
        return noise.shaken(function(*arguments, **options))

    # Checks refuse an answer that calls a file other than numpy's and the library's.
    code = shaken.__code__.replace(co_filename=np.__file__)
    return types.FunctionType(code, globals(), function.__name__, None, shaken.__closure__)


def _replace_loop(ufunc, noise, only_sums=False):
    """Let the loop of a ufunc for floats add noise to its results."""
    signature = ufunc.signature or ",".join(["()"] * ufunc.nin) + "->" + ",".join(
        ["()"] * ufunc.nout
    )
    operands = [re.findall(r"\w+", names) for names in re.findall(r"\(([^)]*)\)", signature)]
    lengths = list(dict.fromkeys(name for names in operands for name in names))
    first_stride = np.cumsum([len(operands), *map(len, operands)]).tolist()
    kinds = [_DOUBLE] * ufunc.nargs
    if ufunc is _umath_linalg.lstsq:
        kinds[5] = _INT  # the rank
    # Of each result in floats: its place, and those of its lengths and strides among numpy's.
    results = [
        (k, [1 + lengths.index(name) for name in operands[k]], first_stride[k])
        for k in range(ufunc.nin, ufunc.nargs)
        if kinds[k] == _DOUBLE
    ]
    old = ctypes.c_void_p()

    def loop(addresses, counts, strides, data):
        begins = addresses[: ufunc.nargs]  # linear algebra moves the addresses along
        is_sum = (
            only_sums and begins[0] == begins[2] and strides[0] == strides[2] == 0 != strides[1]
        )
        count = 1 if is_sum else counts[0]
        original(addresses, counts, strides, data)
        if only_sums and not is_sum:
            return
        for k, of_lengths, own in results:
            shape = [count, *(counts[place] for place in of_lengths)]
            steps = [strides[k], *strides[own : own + len(of_lengths)]]
            size = math.prod(shape)
            if 0 < size <= _FEW and _are_adjacent(shape, steps):
                noise.shake_few(begins[k], size)
            elif size:
                noise.shake(np.asarray(_At(begins[k], tuple(shape), tuple(steps))))

    replacement = _Loop(loop)
    numbers = (ctypes.c_int * ufunc.nargs)(*kinds)
    address = ctypes.cast(replacement, ctypes.c_void_p)
    if _replace()(ufunc, address, numbers, ctypes.byref(old)) != 0:
        raise RuntimeError(f"numpy has no loop of {ufunc.__name__} for floats")
    original = _Loop(old.value)
    _kept.append((replacement, original))


def _are_adjacent(shape, steps):
    """Return whether numbers with these lengths and strides (bytes) follow each other."""
    expected = 8
    for length, step in zip(reversed(shape), reversed(steps), strict=True):
        if length > 1 and step != expected:
            return False
        expected *= length
    return True


def _replace():
    """Return numpy's function that replaces a loop."""
    pointer_of = ctypes.pythonapi.PyCapsule_GetPointer
    pointer_of.restype, pointer_of.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
    table = ctypes.cast(pointer_of(_multiarray_umath._UFUNC_API, None), _POINTERS)
    function = ctypes.PYFUNCTYPE(
        ctypes.c_int,
        ctypes.py_object,
        ctypes.c_void_p,
        ctypes.POINTER(ctypes.c_int),
        ctypes.POINTER(ctypes.c_void_p),
    )
    return function(table[_REPLACE_LOOP])
