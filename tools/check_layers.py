#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Checks the rules by which the repository is laid out.

    tools/check_layers.py [ROOT]

1. A folder of openltc/ includes only itself and folders above it in k_layers; shade includes
   nothing, target only shade; light, scene and render do not include fit: fitting and rendering
   meet only through a table. Nothing in openltc/ includes cli, tests or bench. The headers of the
   public API, openltc/openltc.h and its like, include openltc/api alone, between the two files that put a
   program's own macros aside and back, and that of C headers of C alone;
   in openltc/ only the folders behind them include them.
2. Includes within the repository are written from its root.
3. Embree, glTF, mesh codec and image file headers appear in .cpp files only. Exceptions are private
   headers: render/embree.h and image/exr/exr_input.h, which hide the difference between Embree 3 and 4
   and between OpenEXR 2 and 3, and scene/gltf/file/tinygltf.h, which sets tinygltf up.
4. Every source file begins with the two licence lines.
5. The root CMakeLists.txt stays under 80 lines.
6. The library is silent: no file of openltc/ uses standard output or error, handles a signal, ends
   the process or does something at its end; that is cli/ alone. base/result.cpp ends a program
   that takes what a Result has not, as assert would.
7. Threads are started by base/parallel.cpp alone, which nothing passes by: no other file of openltc/
   or cli/ includes oneTBB or starts threads.
8. No folder of openltc/, cli/, python/, tests/, bench/ or tools/ holds more than 30 sources of its own: a
   wider one gets rooms.
9. No source has more than 400 lines: a longer one is split by its ideas. k_long_sources names those
   that may be longer, and why; shaders/ holds what `openltc shaders` makes.

Prints one line per breach, as file:line: what; exit code 1 if there is any.
"""

import collections
import os
import re
import sys

k_layers = ["shade", "target", "api", "base", "shaders", "kernel", "image", "draw", "brdf", "table", "fit", "light", "scene", "render", "plot", "c_api"]
k_source_endings = (".h", ".c", ".cpp", ".inc", ".glsl", ".frag", ".comp", ".py", ".sh", ".mjs", ".cmake")
k_source_names = ("CMakeLists.txt", "Makefile", "run")
k_skipped_folders = {".git", "build", "out", "node_modules", "__pycache__"}
k_root_list_lines = 80
# Headers of the public API in openltc/ itself, and the folders that are behind each and may include it.
k_umbrellas = {"openltc.h": set(), "batch.h": {"kernel", "c_api"}, "openltc_c.h": {"c_api"}}
k_c_header = "openltc_c.h"
k_around_the_api = ("openltc/target/own_names.inc", "openltc/target/names_back.inc")
k_folder_files = 30
k_narrow_trees = ("openltc/", "cli/", "python/", "tests/", "bench/", "tools/")
k_source_lines = 400
k_long_sources = {
    "openltc/api/ggx_table.inc": "generated, a line for each texel",
    "openltc/api/ggx_two_lobes.inc": "generated, a line for each texel",
    "openltc/openltc_c.h": "the C API, one header by design (decision 65), a comment for every name",
    "openltc/kernel/light_sampling.inc": "one walk down the tree of lights, and what decides its turns",
}

k_include = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
k_private_headers = re.compile(
    r"^(embree[34]?/|tiny_gltf|draco/|meshoptimizer|OpenEXR/|Imf|png\.h|jpeglib|stb_|stb/|librsvg/|webp/)")
k_private_headers_allowed = {"openltc/render/embree.h", "openltc/image/exr/exr_input.h",
                             "openltc/scene/gltf/file/tinygltf.h"}


# Words of rule 6, looked for outside of comments and strings.
k_loud_words = re.compile(
    r"\bstd::(cout|cerr|clog|wcout|wcerr|wclog)\b|\b(stdout|stderr|STD(OUT|ERR)_FILENO)\b"
    r"|(?<![\w.>])(std::)?(printf|vprintf|puts|putchar|perror)\s*\("
    r'|\bfmt::v?print(ln)?\s*\(\s*("|fmt::|\))'
    r"|\b(sigaction|sigprocmask|pthread_sigmask|SIG_IGN|SIG_DFL)\b|(<csignal>|<signal\.h>)"
    r"|\bstd::(signal|raise|exit|quick_exit|abort|terminate|atexit|at_quick_exit|set_terminate)\b"
    r"|(?<![\w.>])(::)?(_exit|exit|abort|atexit|on_exit|isatty)\s*\(")
# Includes and words of rule 7.
k_thread_words = re.compile(r"#\s*include\s*<(tbb/|oneapi/tbb|execution>|omp\.h>|pthread\.h>)"
                            r"|\btbb::|\bstd::(jthread|async)\b|\bstd::thread\b(?!::)|#\s*pragma\s+omp")
k_loud_file = "openltc/base/result.cpp"
k_thread_file = "openltc/base/parallel.cpp"
k_comment_or_string = re.compile(
    r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)


def code_of(text):
    """The text without comments and strings, line by line."""
    def blank(match):
        kept = '""' if match.group()[0] == '"' else " "
        return kept + "\n" * match.group().count("\n")
    return k_comment_or_string.sub(blank, text).splitlines()


def find_words(words, code, what):
    """The first of these words in each line, as (line, text)."""
    return [(number, "%s, but here: %s" % (what, word.group().strip()))
            for number, line in enumerate(code, 1) for word in [words.search(line)] if word]


def check_code(path, text):
    """Breaches of rules 6 and 7 as (line, text)."""
    code = code_of(text)
    breaches = []
    if path.startswith("openltc/") and path != k_loud_file:
        breaches += find_words(k_loud_words, code, "the library prints nothing and leaves the process alone")
    if path != k_thread_file:
        breaches += find_words(k_thread_words, code, "threads are for %s" % k_thread_file)
    return breaches


def allowed_folders(folder):
    """The folders of openltc/ that a file of `folder` may include."""
    if folder == "shade":
        return {"shade"}
    if folder == "target":
        return {"shade", "target"}
    above = set(k_layers[:k_layers.index(folder) + 1])
    return above - {"fit"} if folder in ("light", "scene", "render") else above


def find_sources(root):
    """Paths of all source files, relative to root, in a fixed order."""
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(f for f in folders if f not in k_skipped_folders)
        for name in sorted(names):
            if name.endswith(k_source_endings) or name in k_source_names:
                yield os.path.relpath(os.path.join(folder, name), root)


def check_licence(lines):
    start = 1 if lines and lines[0].startswith(("#!", "#version")) else 0
    head = lines[start:start + 2] + ["", ""]
    if (re.match(r"^(//|#) Copyright \(c\) \d{4} The OpenLTC authors$", head[0])
            and re.match(r"^(//|#) SPDX-License-Identifier: MIT$", head[1])):
        return []
    return [(start + 1, "the two licence lines are missing")]


def check_library_include(path, form, header):
    """Breaches by one #include of a file of openltc/; path is like openltc/render/renderer.cpp."""
    folder = path.split("/")[1]
    if folder == k_c_header:
        return [] if header in ("stddef.h", "stdint.h") else ["openltc_c.h includes headers of C alone, "
                                                              'but here "%s"' % header]
    if folder in k_umbrellas:
        if header.startswith("openltc/api/") or (form == "<" and folder != "openltc.h") or (
                header in k_around_the_api and folder != k_c_header):
            return []
        return ['%s includes openltc/api alone, but here "%s"' % (folder, header)]
    if k_private_headers.match(header):
        if not path.endswith(".cpp") and path not in k_private_headers_allowed:
            return ["<%s> belongs in a .cpp file" % header]
        return []
    if form == "<" and not header.startswith("openltc/"):
        return ["shade includes nothing, but here <%s>" % header] if folder == "shade" else []
    parts = header.split("/")
    if len(parts) == 2 and folder in k_umbrellas.get(parts[1], ()):
        return []
    if parts[0] != "openltc" or len(parts) < 3:
        return ['"%s": includes start at the root of the repository, with "openltc/"' % header]
    if parts[1] not in k_layers:
        return ['"%s": no such layer' % header]
    if folder == "shade":
        return ['shade includes nothing, but here "%s"' % header]
    if parts[1] not in allowed_folders(folder):
        return ['%s may not include %s ("%s")' % (folder, parts[1], header)]
    return []


def check_widths(paths):
    """Breaches of rule 8 as (folder, 1, text)."""
    counts = collections.Counter(os.path.dirname(path) for path in paths
                                 if path.startswith(k_narrow_trees))
    return [(folder, 1, "%d files; a folder of more than %d gets rooms" % (count, k_folder_files))
            for folder, count in sorted(counts.items()) if count > k_folder_files]


def check_length(path, lines):
    """Breaches of rule 9 as (line, text)."""
    if len(lines) <= k_source_lines or path in k_long_sources or path.startswith("shaders/"):
        return []
    return [(k_source_lines + 1, "%d lines; a source of more than %d is split by its ideas"
             % (len(lines), k_source_lines))]


def check(root):
    """All breaches as (path, line, text)."""
    paths = list(find_sources(root))
    breaches = check_widths(paths)
    for path in paths:
        with open(os.path.join(root, path), encoding="utf-8") as stream:
            lines = stream.read().splitlines()
        breaches += [(path, line, text) for line, text in check_licence(lines) + check_length(path, lines)]
        parts = path.split("/")
        if parts[0] in ("openltc", "cli") and path.endswith((".h", ".cpp", ".inc")):
            breaches += [(path, line, text) for line, text in check_code(path, "\n".join(lines))]
        if parts[0] == "openltc" and (len(parts) > 2 or parts[1] in k_umbrellas):
            if parts[1] not in k_layers and parts[1] not in k_umbrellas:
                breaches.append((path, 1, "openltc/%s is not in the list of layers" % parts[1]))
                continue
            for number, line in enumerate(lines, 1):
                include = k_include.match(line)
                if include:
                    breaches += [(path, number, text)
                                 for text in check_library_include(path, *include.groups())]
        if path == "CMakeLists.txt" and len(lines) >= k_root_list_lines:
            breaches.append((path, len(lines), "the root list file stays under %d lines"
                             % k_root_list_lines))
    return breaches


def main():
    default = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    root = sys.argv[1] if len(sys.argv) > 1 else default
    breaches = check(root)
    for path, line, text in breaches:
        print("%s:%d: %s" % (path, line, text))
    sys.exit(1 if breaches else 0)


if __name__ == "__main__":
    main()
