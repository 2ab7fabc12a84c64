# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""What a file was made of, written down beside it, so that only what is missing or changed is made again.

In the folder .openltc of the file's own folder lies NAME.made: JSON with the fingerprint of all inputs,
the files that were written with their sizes, and what there is to say of them."""

import enum
import hashlib
import json
import os
import tempfile

_seen = {}


def digest_of_file(path):
    """Of its bytes; that it is not there, or cannot be read, is told from any other."""
    try:
        facts = os.stat(path)
        key = (os.path.realpath(path), facts.st_mtime_ns, facts.st_size, facts.st_ino)
        if key not in _seen:
            digest = hashlib.blake2b(digest_size=16)
            with open(path, "rb") as file:
                while part := file.read(1 << 20):
                    digest.update(part)
            _seen[key] = digest.hexdigest()
        return _seen[key]
    except OSError as error:
        return type(error).__name__


def digest_of_files(paths, folder):
    """Of the bytes and the names relative to `folder`, so that all may move together."""
    return sorted((os.path.relpath(path, folder), digest_of_file(path)) for path in paths)


def state_of(value):
    """What a value consists of, as text that is the same for the same value in any process: numbers,
    texts, arrays, containers, and objects by their public fields."""
    if value is None or isinstance(value, (bool, int, float, str, bytes)):
        return repr(value)
    if isinstance(value, enum.Enum):
        return value.name
    if isinstance(value, dict):
        return "{" + ",".join(sorted(f"{state_of(k)}:{state_of(v)}" for k, v in value.items())) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ",".join(map(state_of, value)) + "]"
    if hasattr(value, "tobytes"):
        return f"{value.dtype}{value.shape}{hashlib.blake2b(value.tobytes(), digest_size=16).hexdigest()}"
    fields = {name: getattr(value, name) for name in dir(value) if not name.startswith("_")}
    fields = {name: field for name, field in fields.items() if not callable(field)}
    return type(value).__name__ + state_of(fields)


def fingerprint(*inputs):
    """One text for all that something is made of."""
    return hashlib.blake2b(state_of(inputs).encode(), digest_size=16).hexdigest()


def _record_of(output):
    folder, name = os.path.split(os.path.abspath(output))
    return os.path.join(folder, ".openltc", name + ".made")


def look_up(output, inputs):
    """What record() wrote of `output`, if it was made of these inputs and its files are as long as they
    were; else None."""
    try:
        with open(_record_of(output), encoding="utf-8") as file:
            record = json.load(file)
        folder = os.path.dirname(os.path.abspath(output))
        same = record["inputs"] == inputs and all(
            os.path.getsize(os.path.join(folder, name)) == size for name, size in record["files"].items())
        return record if same else None
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


def record(output, inputs, files, about=None):
    """Writes down what `output`, which is these files, was made of. Returns the record."""
    folder = os.path.dirname(os.path.abspath(output))
    made = {"inputs": inputs, "about": about or {},
            "files": {os.path.relpath(path, folder): os.path.getsize(path) for path in files}}
    path = _record_of(output)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with tempfile.NamedTemporaryFile("w", dir=os.path.dirname(path), delete=False, encoding="utf-8") as file:
        json.dump(made, file)
    os.replace(file.name, path)
    return made
