# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""openltc render --frames ... --scheduler ADDRESS: each frame by a worker, which runs the tool for it."""

import os
import sys

from . import _many, _openltc, _tool


def take_option(arguments, name):
    """The value of an option that was given once, or None, and the arguments without it."""
    for i, argument in enumerate(arguments):
        if argument.startswith(name + "="):
            return argument[len(name) + 1:], arguments[:i] + arguments[i + 1:]
        if argument == name and i + 1 < len(arguments):
            return arguments[i + 1], arguments[:i] + arguments[i + 2:]
    return None, arguments


def main(arguments):
    """The exit code, as of the tool: 1 where a frame or all failed, 2 for wrong usage."""
    address, rest = take_option(arguments, "--scheduler")
    frames, shared = take_option(rest, "--frames")
    if not address or frames is None or "--list-missing" in rest or "--help" in rest:
        # Nothing for a cluster, or something to complain of, which the tool does.
        os.execv(_tool.path(), ["openltc", "render", *(arguments if frames is None or not address else rest)])
    if "--json" in rest:
        print("openltc render: --json: not with --scheduler", file=sys.stderr)
        return 2
    quiet = "--quiet" in rest
    shared = [argument for argument in shared if argument != "--quiet"]
    folder = os.getcwd()
    failures, made = {}, []
    try:
        made = _tool.render_missing(shared, frames, folder, address, not quiet)
    except _tool.Refused as error:
        print(error.words, file=sys.stderr)
        return error.code
    except _many.Unfinished as error:
        failures, made = error.failures, error.tasks
    except _openltc.Error as error:
        print(f"openltc render: --scheduler: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("openltc: interrupted; frames that are made stay", file=sys.stderr)
        return 130
    count = len(_tool.numbers(frames))
    if not quiet:
        print(f"{len(made) - len(failures)} of {count} frames made, {count - len(made)} were there", file=sys.stderr)
    for frame, error in sorted(failures.items()):
        print(f"frame {frame}: {error}", file=sys.stderr)
    if failures:
        print(f"openltc render: {len(failures)} of {count} frames failed: {_many.ranges(failures)}", file=sys.stderr)
    return 1 if failures else 0
