# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The tool as it is installed and packaged: it runs, and its man pages and completions know every command
and option that its --help names.

    test_package.py BUILD   in which the tool lies
"""

import gzip
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_build = sys.argv.pop(1)
k_bash = """. "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($#-1)); _openltc; echo "${COMPREPLY[@]}"
"""


def run(command, **environment):
    """What it printed, warnings too; what fails says so with all of it."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
                            env={**os.environ, **environment})
    if result.returncode != 0:
        raise AssertionError("%s:\n%s" % (command, result.stdout))
    return result.stdout


def files_of(folder):
    return {os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names}


def options_of_all(tool, words=()):
    """Every command with its options, read out of --help independently of tools/manual."""
    text = run([tool, *words, "--help"])
    lists = text.split("Subcommands:\n")
    found = {" ".join(("openltc", *words)): re.findall(r"(?<![\w-])--?[a-z][a-z0-9-]*",
                                                       " ".join(re.findall(r"^  (-\S+)", lists[0], re.M)))}
    for name in re.findall(r"^  ([a-z]+) ", lists[1].split("\n\n")[0], re.M) if len(lists) > 1 else []:
        found.update(options_of_all(tool, (*words, name)))
    return found


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        cls.folder = cls.work.name
        cls.prefix = os.path.join(cls.folder, "installed")
        run(["cmake", "--install", k_build, "--prefix", cls.prefix, "--component", "tool"])
        cls.tool = os.path.join(cls.prefix, "bin", "openltc")
        cls.options = options_of_all(cls.tool)

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    def path(self, name):
        return os.path.join(self.prefix, "share", name)

    def read(self, name):
        with (gzip.open if name.endswith(".gz") else open)(self.path(name), "rt", encoding="utf-8") as stream:
            return stream.read()

    def test_help_was_understood(self):
        self.assertIn("openltc plot photometry", self.options)
        self.assertIn("--shadow-samples", self.options["openltc render"])
        self.assertIn("-o", self.options["openltc fit"])

    def test_what_is_installed(self):
        names = files_of(self.prefix)
        for name in ("bin/openltc", "share/doc/openltc/LICENSE", "share/doc/openltc/README.md",
                     "share/doc/openltc/docs/method.md"):
            self.assertIn(name, names)
        self.assertFalse([name for name in names if name.startswith(("include", "lib"))])

    def test_every_command_has_a_page_with_its_options(self):
        pages = {name[:-len(".1.gz")] for name in os.listdir(self.path("man/man1"))}
        self.assertEqual(pages, {name.replace(" ", "-") for name in self.options})
        for name, options in self.options.items():
            page = self.read("man/man1/%s.1.gz" % name.replace(" ", "-"))
            for option in options:
                self.assertIn("\\fB%s\\fR" % option.replace("-", "\\-"), page, name)

    @unittest.skipUnless(shutil.which("groff"), "no groff")
    def test_pages_are_typeset_without_warnings(self):
        for name, options in self.options.items():
            plain = os.path.join(self.folder, "page.1")
            with open(plain, "w", encoding="utf-8") as stream:
                stream.write(self.read("man/man1/%s.1.gz" % name.replace(" ", "-")))
            self.assertEqual(run(["groff", "-man", "-Kutf8", "-Tutf8", "-ww", "-z", plain]), "", name)
            # Bold is an escape sequence or each letter twice.
            shown = re.sub("\x1b\\[[0-9;]*m|.\x08", "", run(["groff", "-man", "-Kutf8", "-Tutf8", plain]))
            self.assertIn("SYNOPSIS\n       %s [OPTIONS]" % name, shown)
            # Each can be copied: its hyphens are those of the keyboard.
            for option in options:
                self.assertIn(option, shown, name)

    def bash(self, *words):
        return run(["bash", "-c", k_bash, "bash", self.path("bash-completion/completions/openltc"), *words]).split()

    def test_bash_completes_commands_options_and_words(self):
        for name, options in self.options.items():
            self.assertEqual(set(self.bash(*name.split(), "-")), set(options), name)
        self.assertEqual(self.bash("openltc", "co"), ["compare", "convert"])
        self.assertIn("fit", self.bash("openltc", "plot", ""))
        self.assertEqual(self.bash("openltc", "render", "a.glb", "--integrator", ""), ["ltc", "reference"])
        self.assertEqual(self.bash("openltc", "plot", "fit", "--background", "d"), ["dark"])
        self.assertEqual(self.bash("openltc", "render", ""), [])  # then bash completes files

    @unittest.skipUnless(shutil.which("fish"), "no fish")
    def test_fish_completes_commands_options_and_words(self):
        def complete(line):
            text = run(["fish", "-c", 'source "%s"; complete -C "%s"' % (
                self.path("fish/vendor_completions.d/openltc.fish"), line)], HOME=self.folder,
                       PATH=os.path.dirname(self.tool) + ":" + os.environ["PATH"])
            return [shown.split("\t")[0] for shown in text.splitlines()]
        self.assertEqual(complete("openltc co"), ["compare", "convert"])
        self.assertEqual(complete("openltc plot fit --background d"), ["dark"])
        for name, options in self.options.items():
            self.assertLessEqual({o for o in options if o.startswith("--")}, set(complete(name + " --")), name)

    @unittest.skipUnless(shutil.which("zsh"), "no zsh")
    def test_zsh_reads_its_completions(self):
        run(["zsh", "-n", self.path("zsh/site-functions/_openltc")])

    def test_zsh_and_fish_know_every_option(self):
        zsh, fish = self.read("zsh/site-functions/_openltc"), self.read("fish/vendor_completions.d/openltc.fish")
        for name, options in self.options.items():
            function = re.search(r"^%s\(\) \{\n(.*?)^\}" % ("_" + name.replace(" ", "_")), zsh, re.M | re.S).group(1)
            lines = " ".join(re.findall(r"^complete -c openltc -n '__openltc_at %s' (.*)$" % name, fish, re.M)) + " "
            for option in options:
                self.assertIn(option + "[", function, name)
                self.assertIn(("-l " if option.startswith("--") else "-s ") + option.lstrip("-") + " ", lines, name)

    def test_cpack_makes_an_archive(self):
        run(["cpack", "--config", os.path.join(k_build, "CPackConfig.cmake"), "-G", "TGZ", "-B", self.folder])
        name = next(n for n in os.listdir(self.folder) if n.endswith(".tar.gz"))
        with tarfile.open(os.path.join(self.folder, name)) as archive:
            files = {member.name for member in archive.getmembers() if member.isfile()}
        self.assertEqual({re.sub(r"^[^/]*openltc-[0-9][^/]*/", "", each) for each in files}, files_of(self.prefix))

    @unittest.skipUnless(shutil.which("dpkg-shlibdeps") and shutil.which("file"), "no dpkg-dev or file")
    def test_cpack_makes_a_debian_package(self):
        run(["cpack", "--config", os.path.join(k_build, "CPackConfig.cmake"), "-G", "DEB", "-B", self.folder])
        name = next(n for n in os.listdir(self.folder) if n.endswith(".deb"))
        self.assertRegex(name, r"^openltc_[0-9.]+_[a-z0-9]+\.deb$")
        package, unpacked = os.path.join(self.folder, name), os.path.join(self.folder, "unpacked")
        depends = run(["dpkg-deb", "-f", package, "Depends"])
        for library in ("libc6", "libembree", "libtbb", "libpng"):
            self.assertIn(library, depends)
        run(["dpkg-deb", "-x", package, unpacked])
        # Debian has its own places for what packages bring zsh, and for the licence.
        self.assertEqual({each.replace("vendor-completions", "site-functions")
                          for each in files_of(os.path.join(unpacked, "usr"))},
                         files_of(self.prefix) | {"share/doc/openltc/copyright"})
        self.assertEqual(run([os.path.join(unpacked, "usr", "bin", "openltc"), "--version"]),
                         run([self.tool, "--version"]))


if __name__ == "__main__":
    unittest.main()
