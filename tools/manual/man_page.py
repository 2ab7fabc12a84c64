# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Man pages, in the macros of man(7), from what help_text read."""

import re

k_heading = re.compile(r"(Examples|What the numbers mean):?$")


def escaped(text):
    """Text that roff prints as it is: no hyphens for minus signs, no requests."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("^", "\\(ha").replace("~", "\\(ti")
    text = text.replace("`", "\\(ga").replace("'", "\\(aq").replace('"', "\\(dq")
    return "\\&" + text if text.startswith(".") else text


def verbatim(lines):
    return [".PP", ".nf", ".RS 4"] + [escaped(line) for line in lines] + [".RE", ".fi"]


def notes(lines):
    """Paragraphs, and what is indented as it stands; a line of k_heading begins a section."""
    page, indented = [], []
    for line in lines + [""]:
        if line.startswith("  "):
            indented.append(line)
            continue
        if indented:
            page += verbatim([text[2:] for text in indented])
            indented = []
        if k_heading.match(line):
            page.append(".SH " + line.rstrip(":").upper())
        elif line:
            page += ([".PP"] if not page or page[-1] == "" or page[-1] == ".fi" else []) + [escaped(line)]
        else:
            page.append("")
    return [line for line in page if line]


def entry(option):
    names = ", ".join("\\fB%s\\fR" % escaped(name) for name in option.names)
    argument = " \\fI%s\\fR" % escaped(option.argument) if option.argument else ""
    return [".TP", names + argument, escaped(option.description)]


def sentences(description):
    """The description's lines below the first, which the section NAME has."""
    return "\n".join(description.split("\n")[1:])


def man_page(command, version, parent):
    """The page's text; `parent` is the command above, or None."""
    first = command.description.split("\n")[0].replace("OpenLTC: ", "").rstrip(".")
    page = ['.\\" Made by tools/manual/make_manual.py from %s --help' % command.name(),
            '.TH "%s" 1 "" "OpenLTC %s" "OpenLTC"' % (escaped("-".join(command.words).upper()), version),
            ".SH NAME", "%s \\- %s" % (escaped("-".join(command.words)), escaped(first)),
            ".SH SYNOPSIS", "\\fB%s\\fR %s" % (command.name(), escaped(command.usage[len(command.name()) + 1:]))]
    # The notes up to the first heading describe; what follows comes behind the options.
    split = next((n for n, line in enumerate(command.notes) if k_heading.match(line)), len(command.notes))
    about = [line for line in [sentences(command.description)] if line]
    if about or command.notes[:split]:
        page += [".SH DESCRIPTION"] + notes(about + command.notes[:split])
    if command.positionals:
        page += [".SH ARGUMENTS"] + sum(map(entry, command.positionals), [])
    page += [".SH OPTIONS"] + sum(map(entry, command.options), [])
    if command.commands:
        page.append(".SH COMMANDS")
        for below in command.commands:
            page += [".TP", "\\fB%s\\fR(1)" % escaped("-".join(below.words)), escaped(below.description.split("\n")[0])]
    page += notes(command.notes[split:])
    others = ([parent] if parent else []) + (parent.commands if parent else command.commands)
    page += [".SH SEE ALSO", ",\n".join("\\fB%s\\fR(1)" % escaped("-".join(other.words))
                                        for other in others if other is not command)]
    return "\n".join(page) + "\n"
