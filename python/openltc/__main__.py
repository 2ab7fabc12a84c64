# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The command `openltc`: the tool itself, which the wheel holds."""

import os
import sys


def main():
    tool = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "openltc")
    if not os.path.exists(tool):
        sys.exit(f"openltc: {tool} is not there; install the wheel again")
    os.execv(tool, ["openltc", *sys.argv[1:]])


if __name__ == "__main__":
    main()
