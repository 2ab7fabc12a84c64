# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Installs npm packages that a lock file pins."""

import os
import re
import shutil
import subprocess

k_oldest_node = 18


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def install(pinned, folder):
    """Installs what pinned/package-lock.json names into folder/node_modules, unless it is there. Returns why not,
    in words, or None."""
    node, npm = shutil.which("node"), shutil.which("npm")
    if not node or not npm:
        return "node and npm not found (packages nodejs, npm)"
    version = subprocess.run([node, "--version"], stdout=subprocess.PIPE, text=True).stdout.strip()
    if int(re.match(r"v(\d+)", version).group(1)) < k_oldest_node:
        return "Node %d or later is needed, this is %s" % (k_oldest_node, version)
    lock = os.path.join(folder, "package-lock.json")
    if (os.path.isdir(os.path.join(folder, "node_modules")) and os.path.exists(lock)
            and read(lock) == read(os.path.join(pinned, "package-lock.json"))):
        return None
    os.makedirs(folder, exist_ok=True)
    for name in ("package.json", "package-lock.json"):
        shutil.copyfile(os.path.join(pinned, name), os.path.join(folder, name))
    result = subprocess.run([npm, "ci", "--prefix", folder, "--ignore-scripts", "--no-audit", "--no-fund"], cwd=folder,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0:
        shutil.rmtree(folder, ignore_errors=True)
        return "npm could not fetch the packages of %s:\n%s" % (pinned, result.stdout)
    return None
