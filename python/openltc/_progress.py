# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""How long work says how far it is."""

import contextlib
import sys


@contextlib.contextmanager
def reporter(progress, what):
    """A function of the share done, or None. True: a bar of tqdm, or a plain line on a terminal."""
    if not progress:
        yield None
    elif callable(progress):
        yield progress
    else:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            yield from _plain(what)
        else:
            with tqdm(total=100, desc=what, unit="%", bar_format="{l_bar}{bar}| {elapsed}") as bar:
                yield lambda share: bar.update(round(100 * share) - bar.n)


def _plain(what):
    try:
        yield lambda share: sys.stderr.write(f"\r{what}: {share:4.0%} ")
    finally:
        sys.stderr.write("\n")
