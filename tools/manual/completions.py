# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Completions for bash, zsh and fish from what help_text read: commands, options, their words, files."""

import re

k_head = "# Made by tools/manual/make_manual.py from openltc --help\n"

# The command, "openltc plot error", from the words before the one that is completed.
k_bash = """_openltc() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=openltc word words=
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case "$command $word" in
      %(commands)s) command+=" $word" ;;
    esac
  done
  case "$command $before" in
    %(choices)s
    *)
      case "$command:$current" in
        %(options)s
        %(below)s
      esac ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}
complete -o bashdefault -o default -F _openltc openltc
"""

k_zsh_below = """%(function)s() {
  local context state state_descr line
  typeset -A opt_args
  _arguments -C %(options)s '1: :->command' '*:: :->argument'
  case $state in
    command)
      local -a commands=(%(commands)s)
      _describe command commands ;;
    argument)
      case $words[1] in
        %(cases)s
      esac ;;
  esac
}
"""

k_fish = """function __openltc_command
  set -l command openltc
  for word in (commandline -opc)[2..-1]
    switch "$command $word"
      case %s
        set command "$command $word"
    end
  end
  echo $command
end
function __openltc_at
  test (__openltc_command) = "$argv"
end
complete -c openltc -n "string match -q -- '-*' (commandline -ct)" -f
"""


def quoted(text):
    """A word of sh, bash and zsh."""
    return "'" + text.replace("'", "'\\''") + "'"


def bash(root):
    each = root.all()
    choices = ['"%s "%s) words="%s" ;;' % (command.name(), name, " ".join(option.choices()))
               for command in each for option in command.options if option.choices() for name in option.names]
    options = ['"%s:-"*) words="%s" ;;' % (command.name(), " ".join(n for o in command.options for n in o.names))
               for command in each]
    below = ['"%s:"*) words="%s" ;;' % (command.name(), " ".join(b.words[-1] for b in command.commands))
             for command in each if command.commands]
    return k_head + k_bash % {
        "commands": "|".join('"%s"' % command.name() for command in each[1:]),
        "choices": "\n    ".join(choices), "options": "\n        ".join(options),
        "below": "\n        ".join(below)}


def zsh_option(option):
    """The specification of an option for _arguments, once for each of its names."""
    text = re.sub(r"([\[\]:\\])", r"\\\1", option.summary())
    action = ""
    if option.argument:
        action = ":%s:" % re.sub(r"[^A-Za-z0-9_-].*", "", option.argument).lower()
        if option.choices() and not option.takes_file():
            action += "(%s)" % " ".join(option.choices())
        elif option.choices():
            action += "{compadd %s; _files}" % " ".join(option.choices())
        elif option.takes_file():
            action += "_files"
    once = "*" if option.is_repeatable() else "(%s)" % " ".join(option.names)
    return [quoted("%s%s[%s]%s" % (once, name, text, action)) for name in option.names]


def zsh(root):
    functions = []
    for command in root.all():
        function = "_" + "_".join(command.words)
        options = " ".join(spec for option in command.options for spec in zsh_option(option))
        if command.commands:
            described = [quoted("%s:%s" % (b.words[-1], b.description.split("\n")[0].replace(":", "\\:")))
                         for b in command.commands]
            cases = ["%s) _%s ;;" % (b.words[-1], "_".join(b.words)) for b in command.commands]
            functions.append(k_zsh_below % {"function": function, "options": options,
                                            "commands": " ".join(described), "cases": "\n        ".join(cases)})
        else:
            functions.append("%s() {\n  _arguments %s '*:file:_files'\n}\n" % (function, options))
    return "#compdef openltc\n" + k_head + "".join(functions) + '_openltc "$@"\n'


def fish_quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish(root):
    each = root.all()
    lines = []
    for command in each:
        at = "complete -c openltc -n '__openltc_at %s'" % command.name()
        for below in command.commands:
            lines.append("%s -f -a %s -d %s" % (at, below.words[-1], fish_quoted(below.description.split("\n")[0])))
        for option in command.options:
            flags = " ".join("-l " + n[2:] if n.startswith("--") else "-s " + n[1:] for n in option.names)
            if option.argument:
                flags += " -r" if option.takes_file() else " -x"
            if option.choices():
                flags += " -a " + fish_quoted(" ".join(option.choices()))
            lines.append("%s %s -d %s" % (at, flags, fish_quoted(option.summary())))
    return k_head + k_fish % " ".join('"%s"' % command.name() for command in each[1:]) + "\n".join(lines) + "\n"
