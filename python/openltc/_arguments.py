# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Arguments that are no arrays: what they must be, told by their names."""

import operator
import os


def whole(value, name, least=-2**31, most=2**31 - 1):
    """A whole number, as int."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}={value!r}: a whole number is wanted") from None
    if not least <= number <= most:
        raise ValueError(f"{name}={number}: a number from {least} to {most} is wanted")
    return number


def real(value, name):
    """A number, as float."""
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name}={value!r}: a number is wanted") from None


def parts(values, name, of):
    """What a scene has many of, as a list; `of` says of what."""
    if isinstance(values, (str, bytes)) or not hasattr(values, "__iter__"):
        raise TypeError(f"{name}={values!r}: a list of {of} is wanted")
    return list(values)


def text(value, name):
    """A word."""
    if not isinstance(value, str):
        raise TypeError(f"{name}={value!r}: a text is wanted")
    return value


def path(value, name="path"):
    """The path of a file, as text."""
    try:
        found = os.fsdecode(value)
    except TypeError:
        raise TypeError(f"{name}={value!r}: the path of a file is wanted") from None
    if any(c == "\0" or "\ud800" <= c <= "\udfff" for c in found):
        raise ValueError(f"{name}={found!r}: the name of a file is wanted whose characters are UTF-8")
    return found
