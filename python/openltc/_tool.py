# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The tool as a process: how a frame of an animation is made by a worker."""

import operator
import os
import re
import subprocess
import sys

from . import _openltc
from ._many import Unfinished, ranges, run

# The tool goes with the worker: a frame of a worker that was killed is another's already.
_with_parent = "import ctypes, os, sys; ctypes.CDLL(None).prctl(1, 9); os.execv(sys.argv[1], sys.argv[1:])"


class Refused(_openltc.Error):
    """What the tool said before it began, in its own words, and its exit code."""

    def __init__(self, words, code):
        super().__init__(words.removeprefix("openltc render: "))
        self.words, self.code = words, code


def path():
    """Where the tool of this package lies."""
    return os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "openltc")


def render_frame(frame, *, arguments, folder, threads):
    """openltc render ARGUMENTS for one frame, in that folder. Made already: nothing happens."""
    command = [path(), "render", *arguments, "--frames", str(frame), "--quiet"]
    if not any(a == "--threads" or a.startswith("--threads=") for a in arguments):
        command += ["--threads", str(threads)]
    done = subprocess.run([sys.executable, "-ISc", _with_parent, *command], cwd=folder, stdin=subprocess.DEVNULL,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace")
    if done.returncode < 0:
        raise _openltc.Error(f"the tool was ended by signal {-done.returncode}")
    if done.returncode:
        lines = done.stderr.strip().splitlines() or [f"the tool ended with exit code {done.returncode}"]
        raise _openltc.Error(lines[0].removeprefix(f"frame {frame}: ").removeprefix("openltc render: "))


def missing_frames(arguments, frames, folder):
    """Which of these frames are still to be made; `frames` as text. Its errors are the tool's."""
    done = subprocess.run([path(), "render", *arguments, "--frames", frames, "--list-missing", "--quiet"], cwd=folder,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace")
    if done.returncode:
        raise Refused(done.stderr.strip(), done.returncode)
    return numbers(done.stdout.strip())


def path_of_frame(output, frame):
    """A frame's file: its number in place of the last ####."""
    folder, name = os.path.split(output)
    head, _, tail = name.rpartition("#")
    start = head.rstrip("#")
    return os.path.join(folder, f"{start}{frame:0{len(head) - len(start) + 1}}{tail}")


def _are_here(arguments, frames, folder):
    """Whether all files of these frames can be seen: False also where the arguments do not say plainly which."""
    outputs = [value for option, value in zip(arguments, arguments[1:]) if option in ("-o", "--output")]
    plain = outputs and sum(a.startswith(("-o", "--o")) for a in arguments) == len(outputs)
    return plain and all(os.path.exists(os.path.join(folder, path_of_frame(output, n)))
                         for output in outputs for n in frames)


def render_missing(arguments, frames, folder, client, progress):
    """Has those of the frames made that are missing, and returns which that were. Raises Unfinished."""
    missing = missing_frames(arguments, frames, folder)
    if missing:
        run({n: n for n in missing}, render_frame, {"arguments": arguments, "folder": folder}, client, progress,
            f"rendering {len(missing)} frames", "frame")
        # The tool reads the scene to say what is missing: it is asked where that is not plain.
        unseen = () if _are_here(arguments, missing, folder) else missing_frames(arguments, ranges(missing), folder)
        if unseen:
            raise Unfinished(f"{len(unseen)} frames were made, but are not to be seen in {folder}: the workers must see "
                             "the same folders", {n: _openltc.Error("not to be seen here") for n in unseen}, missing)
    return missing


def numbers(frames):
    """Frames as the tool takes them, 1-240x10,300, or any whole numbers, as an ascending list."""
    if not isinstance(frames, str):
        all_ = sorted({operator.index(frame) for frame in frames})
        if all_ and all_[0] < 0:
            raise _openltc.Error(f"frame {all_[0]}: numbers of frames go from 0")
        return all_
    all_ = set()
    for part in frames.split(",") if frames else ():
        found = re.fullmatch(r"(\d+)(?:-(\d+)(?:x([1-9]\d*))?)?", part)
        if not found:
            raise _openltc.Error(f"frames {frames!r}: write them as 1-240, 1-240x10 or 1-24,48")
        first, last, step = (int(n) if n else None for n in found.groups())
        part = range(first, (first if last is None else last) + 1, step or 1)
        if not 0 < len(part) <= 1000000:
            raise _openltc.Error(f"frames {frames!r}: " + ("more than 1000000" if part else "has no frame"))
        all_.update(part)
    return sorted(all_)
