# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""tools/setup.sh explains itself, and its list is well formed. Installs nothing."""

import os
import re
import subprocess
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_setup = os.path.join(k_root, "tools/setup.sh")
k_list = os.path.join(k_root, "tools/packages.txt")


def run(*arguments, **environment):
    # Whoever runs the tests may have left the setup out.
    inherited = {k: v for k, v in os.environ.items() if not k.startswith("OPENLTC_")}
    result = subprocess.run([k_setup, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            text=True, env={**inherited, **environment})
    return result.returncode, result.stdout, result.stderr


class Setup(unittest.TestCase):
    def test_list_is_the_file(self):
        with open(k_list, encoding="utf-8") as stream:
            self.assertEqual(run("--list"), (0, stream.read(), ""))

    def test_every_package_says_what_for(self):
        with open(k_list, encoding="utf-8") as stream:
            lines = [l for l in stream.read().splitlines() if l and not l.startswith("#")]
        self.assertGreater(len(lines), 20)
        for line in lines:
            self.assertRegex(line, r"^\??[a-z0-9][a-z0-9+.-]+(=[a-z0-9-]+)? +# \S")
        names = [re.match(r"\??([^ =]+)", l).group(1) for l in lines]
        self.assertEqual(len(names), len(set(names)))

    def test_unknown_option_is_wrong_usage(self):
        code, _, error = run("--instal")
        self.assertEqual(code, 2)
        self.assertIn("--instal", error)

    def test_can_be_left_out(self):
        code, output, _ = run(OPENLTC_SKIP_SETUP="1")
        self.assertEqual(code, 0)
        self.assertIn("left out", output)

    def test_other_systems_are_told_what_is_needed(self):
        code, output, _ = run(OPENLTC_OS_RELEASE=os.devnull)
        self.assertEqual(code, 1)
        self.assertIn("libembree-dev", output)
        self.assertIn("OPENLTC_SKIP_SETUP", output)


if __name__ == "__main__":
    unittest.main()
