# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Arrays of any library, as NumPy arrays; without a copy where they are what is wanted already."""

import numpy as np


def as_numpy(array, name):
    """What NumPy makes of it: directly, or through DLPack. Errors name the array and the remedy."""
    if isinstance(array, np.ndarray):
        result = array
    elif hasattr(array, "__dlpack__"):
        if hasattr(array, "detach"):  # torch, where gradients are kept
            array = array.detach()
        try:
            result = np.from_dlpack(array)
        except (BufferError, RuntimeError, TypeError, ValueError) as error:
            where = str(getattr(array, "device", "another device"))
            remedy = "give float32 or float64" if "cpu" in where.lower() else "move it to the CPU first"
            raise TypeError(f"{name}: an array on {where} cannot be read ({error}); {remedy}") from None
    else:
        try:
            result = np.asarray(array)
        except ValueError as error:
            raise ValueError(f"{name}: {error}") from None
    if result.dtype.kind == "c":
        raise TypeError(f"{name}: complex numbers; give the real part")
    if result.dtype.kind not in "fiub":
        raise TypeError(f"{name}: numbers are wanted, not {result.dtype}")
    return result


def as_vectors(array, name, dtype=np.float32):
    """(..., 3) as rows of a (N, 3) array, and the shape in front. A copy only where the type or the
    strides are not as they are wanted: 3 numbers side by side."""
    result = as_numpy(array, name)
    if result.ndim == 0 or result.shape[-1] != 3:
        raise ValueError(f"{name}: the shape is {result.shape}; (..., 3) is wanted")
    with np.errstate(over="ignore"):  # too far away is as good as infinitely far
        result = result.astype(dtype, copy=False)
    shape = result.shape[:-1]
    rows = result.reshape(-1, 3)
    item = rows.itemsize
    if rows.strides[1] != item or (len(rows) > 1 and (rows.strides[0] < 3 * item or rows.strides[0] % item)):
        rows = np.ascontiguousarray(rows)
    return rows, shape


def as_numbers(array, name, dtype=np.float64):
    """Any shape, flat, and the shape."""
    result = as_numpy(array, name).astype(dtype, copy=False)
    return np.ascontiguousarray(result).reshape(-1), result.shape
