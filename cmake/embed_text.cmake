# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# Writes text files as C++: cmake -DOUTPUT=FILE.cpp -DROOT=FOLDER -DFILES=A,B,... -P embed_text.cmake
# The names in FILES are relative to ROOT. See openltc/shaders/sources.h.

string(REPLACE "," ";" names "${FILES}")
set(code "// Made by cmake/embed_text.cmake.\n#include \"openltc/shaders/sources.h\"\n\n")
string(APPEND code "namespace openltc::shaders {\n\nconst std::vector<EmbeddedFile>& embedded_files() {\n")
string(APPEND code "  static const std::vector<EmbeddedFile> files = {\n")
foreach(name IN LISTS names)
  file(READ "${ROOT}/${name}" text)
  string(APPEND code "      {\"${name}\", R\"dialect(${text})dialect\"},\n")
endforeach()
string(APPEND code "  };\n  return files;\n}\n\n} // namespace openltc::shaders\n")
file(WRITE "${OUTPUT}" "${code}")
