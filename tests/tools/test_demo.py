# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""tools/demo.sh says how far it is, what it made, and what to try next; all of it is true."""

import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_tool = sys.argv.pop(1)


class Demo(unittest.TestCase):
    def test_small_demo(self):
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "out")
            environment = dict(os.environ, OPENLTC=k_tool, OUT=out, SIZE="64x36", SAMPLES="1",
                               SHADOW_SAMPLES="1", COMPARE_SIZE="32x18", COMPARE_SAMPLES="1",
                               COMPARE_SHADOW_SAMPLES="1", REFERENCE_SAMPLES="2",
                               UNSHADOWED_SAMPLES="2")
            result = subprocess.run([os.path.join(k_root, "tools", "demo.sh")], env=environment,
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.assertEqual(result.returncode, 0, result.stderr)

            steps = re.findall(r"^\[(\d)/(\d)\] .* [0-9.]+ s$", result.stderr, re.M)
            self.assertEqual(steps, [(str(i), "5") for i in range(1, 6)], result.stderr)

            body, heading, end = result.stdout.partition("what to try next:\n")
            self.assertTrue(heading, result.stdout)
            named = {os.path.abspath(path) for path in re.findall(r"\S+\.(?:png|exr)\b", body)}
            made = {os.path.join(out, name) for name in os.listdir(out)}
            self.assertTrue(named and named <= made, named - made)
            self.assertEqual({path for path in made if path.endswith(".png")} - named,
                             {os.path.join(out, "demo_unshadowed.png")})

            commands = [shlex.split(line, comments=True) for line in end.strip().splitlines()]
            self.assertEqual(len(commands), 3)
            for command in commands:
                if "render" in command:
                    command += ["--size", "32x18", "--quiet"]
                ran = subprocess.run(command, cwd=k_root, stdout=subprocess.PIPE,
                                     stderr=subprocess.STDOUT, text=True)
                self.assertEqual(ran.returncode, 0, "%s:\n%s" % (command, ran.stdout))
                if "-o" in command:
                    self.assertTrue(os.path.getsize(command[command.index("-o") + 1]) > 0)


if __name__ == "__main__":
    unittest.main()
