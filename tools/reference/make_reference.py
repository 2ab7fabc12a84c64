#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes the reference pages of the public headers from their comments.

    tools/reference/make_reference.py [FOLDER]

FOLDER is out/reference if nothing is said. Prints where the first page is. Where a public name has no
comment, or Doxygen warns of something, prints that as file:line: text and ends with 1; with 77 where Doxygen
is missing."""

import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as tree

k_here = os.path.dirname(os.path.abspath(__file__))
k_root = os.path.dirname(os.path.dirname(k_here))
k_exit_skipped = 77


def version_of(root):
    with open(os.path.join(root, "openltc/openltc_c.h"), encoding="utf-8") as stream:
        return re.search(r'OPENLTC_C_VERSION "([^"]+)"', stream.read()).group(1)


def says_nothing(element):
    """Whether what XML has of a name is without a description."""
    return not any("".join(description.itertext()).strip()
                   for description in (element.find("briefdescription"), element.find("detaileddescription"))
                   if description is not None)


def explains_itself(member):
    """Destructors, and what the compiler makes of constructors and assignments."""
    arguments = member.findtext("argsstring") or ""
    return member.findtext("name").startswith("~") or arguments.replace(" ", "").endswith(("=default", "=delete"))


def find_uncommented(folder):
    """Public names in Doxygen's XML that have no comment: file:line: text."""
    found = set()

    def add(name, place):
        location = place.find("location")
        found.add((location.get("file"), int(location.get("line")),
                   "%s has no comment" % (name if name and "@" not in name else "an enum without a name")))

    for entry in sorted(os.listdir(folder)):
        if not entry.endswith(".xml"):
            continue
        for compound in tree.parse(os.path.join(folder, entry)).getroot().iter("compounddef"):
            if compound.get("kind") in ("struct", "class", "union", "namespace") and says_nothing(compound):
                add(compound.findtext("compoundname"), compound)
            for member in compound.iter("memberdef"):
                if member.get("prot") != "public" or member.get("kind") == "friend":
                    continue
                if says_nothing(member) and not explains_itself(member):
                    add(member.findtext("name"), member)
                for value in member.iter("enumvalue"):
                    if says_nothing(value):
                        add(value.findtext("name"), member)
    return ["%s:%d: %s" % line for line in sorted(found)]


def make(folder, root=k_root):
    """Writes the pages to folder/html; returns what is wrong, a line for each."""
    with open(os.path.join(k_here, "Doxyfile"), encoding="utf-8") as stream:
        settings = stream.read()
    run_filter = '"%s -I -S -B %s"' % (sys.executable, os.path.join(k_here, "filter.py"))
    settings += "\n".join((
        "", 'OUTPUT_DIRECTORY = "%s"' % folder,
        "PROJECT_NUMBER = " + version_of(root),
        'STRIP_FROM_PATH = "%s"' % root,
        'STRIP_FROM_INC_PATH = "%s"' % root,
        'INPUT += "%s"' % os.path.join(k_here, "groups.dox"),
        "INPUT_FILTER = " + run_filter, ""))
    os.makedirs(folder, exist_ok=True)
    result = subprocess.run(["doxygen", "-"], cwd=root, input=settings, text=True, encoding="utf-8",
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    # Once, also where pages and XML both ask for it.
    lines = list(dict.fromkeys(line.replace(root + os.sep, "")
                               for line in result.stdout.splitlines() if line.strip()))
    if result.returncode != 0:
        return lines + ["doxygen ended with %d" % result.returncode]
    return lines + find_uncommented(os.path.join(folder, "xml"))


def main(arguments):
    if shutil.which("doxygen") is None:
        print("make_reference: doxygen is missing (tools/setup.sh installs it)", file=sys.stderr)
        return k_exit_skipped
    folder = os.path.abspath(arguments[0]) if arguments else os.path.join(k_root, "out", "reference")
    lines = make(folder)
    if lines:
        print("\n".join(lines), file=sys.stderr)
        return 1
    print("reference: %s" % os.path.relpath(os.path.join(folder, "html", "index.html")))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
