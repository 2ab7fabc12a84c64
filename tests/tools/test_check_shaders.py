# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The shading source compiles in the shader language named, and the check notices when it does not.

    test_check_shaders.py glsl|wgsl WORK_DIR
"""

import os
import shutil
import subprocess
import sys
import tempfile

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_exit_skipped = 77


def check(language, work, root):
    """Returns (exit code, output)."""
    result = subprocess.run(
        [sys.executable, "-B", os.path.join(k_root, "tools/shaders/check_shaders.py"), language,
         work, "--root", root], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return result.returncode, result.stdout


def check_broken(language, work, path, text, expected):
    """Spoils one file of a copy of the tree; the check must fail and name `expected`."""
    with tempfile.TemporaryDirectory() as copy:
        for folder in ("openltc/shade", "openltc/target", "tests/shaders"):
            shutil.copytree(os.path.join(k_root, folder), os.path.join(copy, folder))
        with open(os.path.join(copy, path), "a", encoding="utf-8") as stream:
            stream.write(text)
        code, output = check(language, work, copy)
    if code != 1 or expected not in output:
        sys.exit("%s with %r: exit code %d instead of 1, or no %r in\n%s"
                 % (path, text, code, expected, output))
    print("breach in %s: noticed" % path)


def main():
    language, work = sys.argv[1], sys.argv[2]
    code, output = check(language, work, k_root)
    print(output, end="", flush=True)
    if code != 0:
        sys.exit(code)
    with tempfile.TemporaryDirectory() as other:
        if language == "glsl":
            # C++ that GLSL does not have; a name that ES 3.00 reserves; a file nobody lists.
            check_broken("glsl", other, "openltc/shade/constants.glsl",
                         "FN Real broken(const Real& x) { return x; }\n",
                         "openltc/shade/constants.glsl:")
            check_broken("glsl", other, "openltc/shade/lambert.glsl",
                         "FN Real broken(Real sample) { return sample; }\n", "shade_es300.frag:")
            check_broken("glsl", other, "openltc/shade/forgotten.glsl", "// new\n",
                         "forgotten.glsl is not in")
        else:
            # Vulkan GLSL that WGSL has no word for. The copy shares the installed naga.
            os.symlink(os.path.abspath(os.path.join(work, "naga")), os.path.join(other, "naga"))
            check_broken("wgsl", other, "tests/shaders/broken.frag",
                         "#version 450\nlayout(location = 0) out vec4 color;\n"
                         "void main() { color = vec4(gl_HelperInvocation ? 1.0 : 0.0); }\n",
                         "refused by naga")


if __name__ == "__main__":
    main()
