# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Many tasks, here or on a Dask cluster: all that can be done is done, what fails is named at the end."""

import contextlib
import os
import time
import uuid

from . import _openltc
from ._progress import reporter


class Unfinished(_openltc.Error):
    """Some tasks failed; all others are done.

    failures    what each raised, by the name of the task
    tasks       the names of all, also of those that are done
    """

    def __init__(self, message, failures=(), tasks=()):
        super().__init__(message)
        self.failures, self.tasks = dict(failures), list(tasks)


def ranges(frames):
    """Ascending numbers as text: 1-3,7."""
    parts, frames = [], sorted(frames)
    while frames:
        last = next((i for i in range(len(frames)) if frames[i] != frames[0] + i), len(frames)) - 1
        parts.append(f"{frames[0]}-{frames[last]}" if last else f"{frames[0]}")
        frames = frames[last + 1:]
    return ",".join(parts)


@contextlib.contextmanager
def connected(client):
    """A distributed.Client: the caller's own, or one of this address for as long as it takes."""
    if not isinstance(client, str):
        yield client
        return
    try:
        from distributed import Client
    except ImportError as error:
        raise _openltc.Error(f"a cluster wants Dask ({error}): pip install \"openltc[cluster]\"") from None
    try:
        made = Client(client, timeout=20)
    except (OSError, ValueError) as error:
        raise _openltc.Error(f"there is no scheduler at {client}: {error}") from None
    with made:
        yield made


def threads_here(slots):
    """Threads for one task of this machine, where `slots` are the tasks that run at once on each host:
    the cores divided by them."""
    cores = len(os.sched_getaffinity(0))
    try:
        from distributed import get_worker

        worker = get_worker()
    except (ImportError, ValueError):
        return cores
    at_once = max(slots.get(worker.address.rpartition(":")[0], 0), worker.state.nthreads)
    return max(1, cores // at_once)


def _slots(client):
    slots = {}
    for address, threads in client.nthreads().items():
        host = address.rpartition(":")[0]
        slots[host] = slots.get(host, 0) + threads
    return slots


def _one(task, function, common, slots, version):
    if version != _openltc.__version__:
        raise _openltc.Error(f"this worker has openltc {_openltc.__version__}, the caller {version}; "
                             "install the same on both")
    return function(task, threads=threads_here(slots), **common)


def run(tasks, function, common, client, progress, what, kind="task"):
    """{name: function(task, threads=..., **common)} of {name: task}. `client` None: here, one after the
    other; a Client or an address: by its workers. A worker that is lost costs its tasks' time. Raises
    Unfinished when the others are done."""
    done, failures = {}, {}
    arguments = (function, common)
    with reporter(progress if tasks else False, what) as report, connected(client) as at:
        outcomes = _here(tasks, *arguments) if at is None else _there(at, tasks, *arguments)
        for name, result, error in outcomes:
            (done if error is None else failures)[name] = result if error is None else error
            if report:
                report((len(done) + len(failures)) / len(tasks))
    if failures:
        numbers = all(isinstance(name, int) for name in failures)
        listed = ranges(failures) if numbers else ", ".join(map(str, failures))
        lines = [f"{kind} {name}: {error}" for name, error in sorted(failures.items())]
        raise Unfinished("\n".join([f"{len(failures)} of {len(tasks)} {kind}s failed: {listed}", *lines]), failures, tasks)
    return done


def _here(tasks, function, common):
    for name, task in tasks.items():
        try:
            yield name, _one(task, function, common, {}, _openltc.__version__), None
        except Exception as error:
            yield name, None, error


def _there(client, tasks, function, common):
    from distributed import CancelledError, as_completed

    # The wave of this call: a key that the scheduler knew already would not be run again.
    wave = uuid.uuid4().hex[:12]
    keys = [f"openltc-{wave}-{i}" for i in range(len(tasks))]
    futures = client.map(_one, list(tasks.values()), key=keys, pure=False, function=function, common=common,
                         slots=_slots(client), version=_openltc.__version__)
    names = dict(zip(futures, tasks))
    try:
        for future in as_completed(futures, loop=client.loop):  # not that of the latest client
            try:
                result, error = future.result(), None
            except CancelledError:
                result, error = None, _openltc.Error("the scheduler was lost, or gave it up")
            except Exception as raised:
                result, error = None, raised
            yield names[future], result, error
            future.release()
    finally:
        client.cancel([future for future in futures if not future.done()])
