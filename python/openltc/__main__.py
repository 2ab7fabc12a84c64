# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The command `openltc`: the tool itself, which the wheel holds; with --scheduler many of them."""

import os
import sys


def main():
    tool = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "openltc")
    if not os.path.exists(tool):
        sys.exit(f"openltc: {tool} is not there; install the wheel again")
    if sys.argv[1:2] == ["render"] and any(a.split("=")[0] == "--scheduler" for a in sys.argv):
        from ._render_command import main as render_on_cluster

        sys.exit(render_on_cluster(sys.argv[2:]))
    os.execv(tool, ["openltc", *sys.argv[1:]])


if __name__ == "__main__":
    main()
