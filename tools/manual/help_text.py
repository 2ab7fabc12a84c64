# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""What `openltc COMMAND --help` says, taken apart: the one source of man pages and completions."""

import re
import subprocess

k_column = 30  # where descriptions begin


class Option:
    """One line of a list, an option or a positional argument."""

    def __init__(self, names, argument, description):
        self.names = names              # ["-o", "--output"], or ["scene"]
        self.argument = argument        # "FILE ...", as it is written; "" where there is none
        self.description = description

    def choices(self):
        """The words that its argument can be; others may be possible too."""
        braces = re.search(r"\{([^}]*)\}", self.argument)
        if braces:
            return braces.group(1).split(",")
        if "|" not in self.argument:
            return []
        words = re.split(r"[|:]", self.argument.split(" ")[0].split("=")[0])
        return [word for word in words if re.fullmatch(r"[a-z][a-z0-9_-]*", word)]

    def takes_file(self):
        return bool(re.search(r"\bFILE\b|^TEXT(?!:)|\bOUT\b", self.argument))

    def is_repeatable(self):
        return self.argument.endswith("...") or " ... " in self.argument

    def summary(self):
        """The beginning of the description, for a line of completions."""
        text = re.split(r"; |\. | \[", self.description)[0]
        return text if len(text) <= 72 else text[:71].rsplit(" ", 1)[0] + " ..."


class Command:
    def __init__(self, words):
        self.words = words              # ["openltc", "plot", "error"]
        self.usage = ""
        self.description = ""
        self.positionals, self.options = [], []
        self.commands = []              # Command, in their order
        self.notes = []                 # lines below the lists

    def name(self):
        return " ".join(self.words)

    def all(self):
        """This one and all below it."""
        return [self] + [each for command in self.commands for each in command.all()]


def split_entry(lines):
    """(name, description) of an entry: its line, and those that go on with it."""
    first = re.sub(r",\s+(?=-)", ",", lines[0].rstrip())
    rest = [line.strip() for line in lines[1:]]
    gap = re.match(r"  (\S.*?)\s{2,}(\S.*)$", first)
    if gap:
        return gap.group(1), " ".join([gap.group(2)] + rest)
    if rest:
        return first.strip(), " ".join(rest)
    return first[2:k_column].rstrip(), first[k_column:].strip()


def read_option(lines):
    head, description = split_entry(lines)
    names, _, argument = head.partition(" ")
    return Option(names.split(","), argument, description)


def parse(words, text):
    """The Command of a help text, those below it by name alone (as words)."""
    command = Command(words)
    below = []
    lists = {"Positionals:": command.positionals, "Options:": command.options, "Subcommands:": below}
    lines = text.rstrip("\n").split("\n")
    usage = next(number for number, line in enumerate(lines) if line.startswith("Usage: "))
    command.description = "\n".join(lines[:usage]).strip()
    command.usage = lines[usage][len("Usage: "):]
    at = usage + 1
    while at < len(lines):
        if lines[at] not in lists:
            if lines[at]:
                break
            at += 1
            continue
        entries = lists[lines[at]]
        at += 1
        while at < len(lines) and lines[at].startswith("  "):
            end = at + 1
            while end < len(lines) and lines[end].startswith(" " * k_column):
                end += 1
            entries.append(read_option(lines[at:end]))
            at = end
    command.notes = lines[at:]
    return command, [entry.names[0] for entry in below]


def read_command(tool, words=("openltc",)):
    """Asks the tool: this command, and all below it."""
    text = subprocess.run([tool, *words[1:], "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
    command, below = parse(list(words), text)
    command.commands = [read_command(tool, (*words, name)) for name in below]
    return command
