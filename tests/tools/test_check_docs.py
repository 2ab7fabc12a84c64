# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Pages and comments name what exists and write numbers in one way, and the checker notices each
kind of breach."""

import os
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(k_root, "tools"))
import check_docs  # noqa: E402  the folder is on the path only now


def check_tree(files):
    """Breaches of a made-up tree, path -> text, as texts."""
    with tempfile.TemporaryDirectory() as root:
        for path, text in files.items():
            os.makedirs(os.path.join(root, os.path.dirname(path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as stream:
                stream.write(text)
        return [text for _, _, text in check_docs.check(root)]


class Docs(unittest.TestCase):
    def assert_breach(self, path, text, expected):
        breaches = check_tree({path: text, "openltc/shade/real.glsl": ""})
        self.assertEqual(len(breaches), 1, breaches)
        self.assertIn(expected, breaches[0])

    def assert_clean(self, path, text):
        self.assertEqual(check_tree({path: text, "openltc/shade/real.glsl": ""}), [])

    def test_repository_keeps_its_rules(self):
        breaches = check_docs.check(k_root)
        self.assertEqual(breaches, [], "\n" + "\n".join("%s:%d: %s" % b for b in breaches))

    def test_files_that_comments_name_exist(self):
        for path, text in (("openltc/a.h", "int a; // as lost.glsl has it\n"),
                           ("openltc/a.h", "/// See shade/lost.glsl.\n"),
                           ("tools/a.py", '"""Makes tools/lost."""\n'),
                           ("tools/a.py", 'def f():\n    """Makes lost.glsl."""\n'),
                           ("tools/a.sh", "# from openltc/lost/\n"),
                           ("docs/a.md", "In `shade/lost.glsl`.\n")):
            self.assert_breach(path, text, "lost")
            self.assert_clean(path, text.replace("tools/lost", "openltc/shade").replace(
                "openltc/lost/", "openltc/shade/").replace("lost", "real"))

    def test_what_is_no_name_of_a_file_passes(self):
        self.assert_clean("openltc/a.h", '#include "lost.h"\nint a; // NAME.cpp, X.cpp, *.glsl, build/lost.h\n')
        self.assert_clean("tools/a.py", 'TEXT = "tools/lost.py"\n')
        self.assert_clean("docs/a.md", "```\nopenltc fit -o lost.glsl\n```\n")

    def test_history_may_name_what_is_gone(self):
        self.assert_clean("docs/decisions.md", "`shade/lost.glsl`, .5, 8 x 8\n")

    def test_links_lead_somewhere(self):
        self.assert_breach("docs/a.md", "[lost](lost)\n", "leads nowhere")
        self.assert_breach("docs/decisions.md", "[lost](lost)\n", "leads nowhere")
        self.assert_breach("docs/a.md", "# Part\n\n[lost](a.md#lost)\n", "leads nowhere")
        self.assert_breach("docs/a.md", "# Part\n\n[lost](#lost)\n", "leads nowhere")
        self.assert_clean("docs/a.md", "## 1. The `part`, so\n\n[a](a.md#1-the-part-so), [a](#1-the-part-so)\n")
        self.assert_clean("docs/a.md", "# Part\n\n[a](a.md#part), [b](../openltc/shade), [c](https://x.y/z)\n")

    def test_pages_stay_in_the_repository(self):
        self.assert_breach("docs/a.md", "```\nopenltc inspect ../shared/a.dds\n```\n", "../shared")

    def test_numbers_are_written_in_one_way(self):
        self.assert_breach("docs/a.md", "an error of .5\n", "0.5")
        self.assert_breach("docs/a.md", "from 0–.5 on\n", "0.5")
        self.assert_breach("docs/a.md", "8 x 8 nodes\n", "×")
        self.assert_breach("docs/a.md", "1280x720\n", "×")
        self.assert_clean("docs/a.md", "0.5, 8 × 8, `.5`, `8x8`, $.5$, v1.5, x.5\n\n    8 x 8\n")


if __name__ == "__main__":
    unittest.main()
