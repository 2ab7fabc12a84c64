# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Every option that a message, a help text or the docs name exists for the command that they speak of.

    test_messages.py OPENLTC_TOOL

An option belongs to the nearest "openltc COMMAND" before it in the same text; without one, to the
commands that the source file serves. Libraries serve any command, so there "openltc COMMAND" must
stand before the option; of some it is known which commands reach them.
"""

import os
import re
import subprocess
import sys

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_commands = ["render", "compare", "fit", "convert", "inspect", "plot", "shaders", "view"]
# Files of the tool that serve other commands than their name says.
k_served = {
    "picture_output": ["render"], "shape_options": ["render", "convert", "inspect"],
    "pose_options": ["render", "compare"], "main": k_commands,
}
k_option = re.compile(r"(?<![\w-])--[a-z][a-z-]*[a-z]")
k_named = re.compile(r"(?<![\w-])openltc (%s)\b" % "|".join(k_commands))
k_token = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|#[^\n]*', re.S)


# Libraries that not all commands reach, and what these have in common.
k_library_serves = {
    "openltc/scene": ["render", "compare", "convert", "inspect"],
    "openltc/base/memory_budget.cpp": ["render", "compare", "convert", "inspect"],
    "openltc/fit/fit_job.cpp": ["fit"],
    "openltc/plot": ["plot"],
    "openltc/shaders": ["shaders"],
}


def help_of(tool, *command):
    result = subprocess.run([tool, *command, "--help"], stdout=subprocess.PIPE, text=True)
    if result.returncode != 0:
        sys.exit("%s %s --help: exit code %d" % (tool, " ".join(command), result.returncode))
    return result.stdout


def options_of(tool):
    """The options of each command, those of plot's figures together."""
    options = {}
    for command in k_commands:
        text = help_of(tool, command)
        declared = re.findall(r"^ +(?:-\w,)?(--[a-z-]+)", text, re.M)
        if command == "plot":
            section = text[re.search(r"^[A-Za-z]*subcommands:", text, re.M | re.I).end():]
            for figure in re.findall(r"^  (\w+) ", section, re.M):
                declared += re.findall(r"^ +(?:-\w,)?(--[a-z-]+)", help_of(tool, command, figure), re.M)
        options[command] = set(declared) | {"--help"}
    return options


def literals(source):
    """Texts of string literals with the line where each begins, adjacent ones joined."""
    joined, end = [], None
    for match in k_token.finditer(source):
        token = match.group()
        if not token.startswith('"'):
            continue
        text = token[1:-1].replace("\\n", "\n").replace('\\"', '"')
        if end is not None and not re.sub(r"//[^\n]*", "", source[end:match.start()]).strip():
            joined[-1][1] += text
        else:
            joined.append([source.count("\n", 0, match.start()) + 1, text])
        end = match.end()
    return joined


def faults(text, served, options):
    """(option, commands) for every option in `text` that none of its commands has."""
    found = []
    for option in k_option.finditer(text):
        named = [m for m in k_named.finditer(text, 0, option.start())]
        # "openltc fit and openltc convert keep it with --x": all commands of the sentence.
        sentence = max(text.rfind(". ", 0, option.start()), text.rfind("; ", 0, option.start()),
                       text.rfind("\n", 0, option.start()))
        commands = [m.group(1) for m in named if m.start() > sentence]
        commands = commands or served
        if not commands or not all(option.group() in options[c] for c in commands):
            found.append((option.group(), commands))
    return found


def served_by(path):
    folders, name = path.split("/")[:-1], os.path.basename(path)
    stem = name.rsplit(".", 1)[0]
    if folders[0] == "cli":
        if stem in k_served:
            return k_served[stem]
        if len(folders) > 1 and folders[1] in k_commands:  # a command's own room
            return [folders[1]]
        return [c for c in k_commands if stem == c or stem.startswith(c + "_")]
    return k_library_serves.get("/".join(folders[:2])) or k_library_serves.get(path) or []


def sources():
    for top in ("cli", "openltc"):
        for folder, _, files in os.walk(os.path.join(k_root, top)):
            for name in sorted(files):
                if name.endswith((".cpp", ".h")) and name != "style.h":  # style sheets have --names too
                    yield os.path.relpath(os.path.join(folder, name), k_root)


def check_sources(options):
    wrong = []
    for path in sources():
        with open(os.path.join(k_root, path), encoding="utf-8") as stream:
            source = stream.read()
        for line, text in literals(source):
            # A text that is one option and no more declares or compares it.
            if k_option.fullmatch(text.split(",")[-1]) and path.startswith("cli/"):
                continue
            for option, commands in faults(text, served_by(path), options):
                wrong.append("%s:%d: %s is no option of %s" % (
                    path, line, option, " and ".join("openltc " + c for c in commands)
                    or "a command that the message names"))
    return wrong


def check_docs(options):
    """Commands in the documents, `openltc COMMAND ...` up to the end of the line or code."""
    wrong = []
    names = ["README.md", "README.zh-CN.md"] + ["docs/" + n for n in sorted(os.listdir(os.path.join(k_root, "docs")))
                                                if n.endswith(".md")]
    for name in names:
        with open(os.path.join(k_root, name), encoding="utf-8") as stream:
            for number, line in enumerate(stream, 1):
                for command in re.finditer(r"openltc (%s) ([^`&|;#]*)" % "|".join(k_commands), line):
                    for option in k_option.findall(command.group(2)):
                        if option not in options[command.group(1)]:
                            wrong.append("%s:%d: %s is no option of openltc %s" % (name, number, option, command.group(1)))
    return wrong


def check_itself(options):
    """Breaches are noticed."""
    assert faults("name it with --from-layout", ["render"], options)
    assert faults("name it with --from-layout", [], options)
    assert not faults("openltc convert --from-layout names it", [], options)
    assert faults("openltc fit and openltc convert take --from-layout", [], options)
    assert faults("openltc convert reads it; name it with --from-layout", ["render"], options)
    assert literals('f("a --b" // --c\n  "d") + "e"') == [[1, "a --bd"], [2, "e"]]


def main():
    options = options_of(sys.argv[1])
    for command, known in options.items():
        assert len(known) > 3, (command, known)
    check_itself(options)
    wrong = check_sources(options) + check_docs(options)
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


main()
