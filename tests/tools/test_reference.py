# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Every public name of the headers has a comment, and the reference notices one that has not."""

import os
import re
import shutil
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(k_root, "tools", "reference"))
import filter as reference_filter  # noqa: E402
import make_reference  # noqa: E402

k_exit_skipped = 77
k_umbrellas = ("openltc/openltc.h", "openltc/batch.h", "openltc/openltc_c.h")
# Puts the dialect into its namespace, which the reference does by itself.
k_wrapper = "openltc/target/shade_f32.h"
k_licence = "// Copyright (c) 2026 The OpenLTC authors\n// SPDX-License-Identifier: MIT\n"


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def reached(path, seen):
    """Adds to `seen` the headers and files of the dialect that a header includes."""
    if path not in seen:
        seen.add(path)
        for name in re.findall(r'^#include "(openltc/[^"]+)"', read(os.path.join(k_root, path)), re.M):
            reached(name, seen)
    return seen


def insert(root, path, text, before):
    """Puts the text before the last line that is `before`; at the end if that is empty."""
    place = os.path.join(root, path)
    whole = read(place)
    at = whole.rindex(before) if before else len(whole)
    with open(place, "w", encoding="utf-8") as stream:
        stream.write(whole[:at] + text + whole[at:])


def copy_with_new_names(root):
    """The headers and the page in another place, with names that have no comment."""
    for path in ("docs/api.md", *k_umbrellas, "openltc/shade/edge.glsl",
                 "openltc/shade/by_lobe/triangle_slices.glsl", "openltc/shade/exact/cone.glsl",
                 "openltc/shade/one_lane/outline.glsl", "openltc/target/vec.h",
                 "openltc/target/resources.h"):
        os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
        shutil.copy(os.path.join(k_root, path), os.path.join(root, path))
    shutil.copytree(os.path.join(k_root, "openltc/api"), os.path.join(root, "openltc/api"))
    insert(root, "openltc/api/area_lights.h", """
struct NewStruct {};
/// Known.
struct KnownStruct {
  float new_field = 0;
  void new_method() const;
};
enum class NewEnum {
  known ///< one
};
/// Known.
enum class KnownEnum { new_value };
using NewAlias = float;
inline constexpr float k_new_constant = 1;
inline float new_function(float x) { return x; }
template <class T> T new_template(T x) { return x; }
namespace detail {
struct HiddenStruct {};
inline float hidden_function(float x) { return x; }
} // namespace detail
""", "\n/// @}")
    insert(root, "openltc/openltc_c.h", """
#define OPENLTC_NEW_MACRO 1
typedef int32_t openltc_new_type;
OPENLTC_EXPORT void openltc_new_function(void);
/// Known.
enum { OPENLTC_NEW_VALUE = 1 };
""", "\n/// @}")
    insert(root, "openltc/api/material.h", "inline float new_beside_the_groups() { return 1; }\n",
           "} // namespace openltc")
    insert(root, "openltc/shade/edge.glsl", "FN Real new_formula(Real x) { return x; }\n", "")
    with open(os.path.join(root, "openltc/api/new.h"), "w", encoding="utf-8") as stream:
        stream.write(k_licence + "\nnamespace openltc {\ninline float new_in_a_new_file() { return 1; }\n}\n")
    insert(root, "docs/api.md", "\n| | |\n|---|---|\n| `new_on_the_page(x)` | is not there |\n", "")


class Reference(unittest.TestCase):
    def test_everything_has_a_comment(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(make_reference.make(folder), [])
            pages = os.path.join(folder, "html")
            files = read(os.path.join(pages, "files.html"))
            names = {name for path in k_umbrellas for name in reached(path, set())
                     if name.endswith((".h", ".glsl")) and name != k_wrapper}
            self.assertIn("openltc/shade/cone.glsl", names)
            for name in sorted(names):
                self.assertIn(">%s<" % os.path.basename(name), files)

            # In its chapter, with its comment; the dialect as C++ has it; nothing of the inside.
            self.assertRegex(read(os.path.join(pages, "group__lights.html")), r">openltc::Ellipse<.*\n?.*A flat ellipse")
            self.assertIn(">openltc_lights_add_sphere<", read(os.path.join(pages, "group__c__api.html")))
            dialect = read(os.path.join(pages, "namespaceopenltc_1_1f32.html"))
            self.assertIn(">shade_sphere<", dialect)
            self.assertIn("constexpr float", dialect)
            self.assertNotRegex(dialect, r"\b(Real|Mask|FN|FN_INLINE|FN_CALL|CONSTANT)\b")
            self.assertFalse([name for name in os.listdir(pages) if "openltc_1_1detail" in name])
            # The names of the first page lead to theirs.
            self.assertRegex(read(os.path.join(pages, "index.html")), r'href="[^"]*">make_surface\(')

    def test_a_name_without_a_comment_is_reported(self):
        with tempfile.TemporaryDirectory() as root:
            copy_with_new_names(root)
            lines = make_reference.make(os.path.join(root, "out"), root)
            names = ("NewStruct", "new_field", "new_method", "NewEnum", "new_value", "NewAlias",
                     "k_new_constant", "new_function", "new_template", "OPENLTC_NEW_MACRO",
                     "openltc_new_type", "openltc_new_function", "OPENLTC_NEW_VALUE",
                     "new_beside_the_groups", "new_formula", "new_in_a_new_file", "new_on_the_page")
            for name in names:
                found = [line for line in lines if re.search(r"\b%s\b" % name, line)]
                self.assertEqual(len(found), 1, "%s in:\n%s" % (name, "\n".join(lines)))
            self.assertEqual(len(lines), len(names), "\n".join(lines))

    def test_lines_stay_where_they_are(self):
        for path in (*k_umbrellas, "openltc/shade/cone.glsl", "openltc/target/vec.h"):
            before = read(os.path.join(k_root, path)).split("\n")
            after = reference_filter.source(path, "\n".join(before)).split("\n")
            self.assertEqual(len(before), len(after) - path.endswith(".glsl"), path)
            at = before.index("") + 1 # behind the opening
            self.assertEqual(before[at:], after[at:len(before) - 1] + [""])

    def test_a_page_alone(self):
        self.assertEqual(reference_filter.page("see [lights](lights.md#a) or [below](#b)"),
                         "see lights or [below](#b)")
        self.assertEqual(reference_filter.page("| `disk(n)`, `openltc_x` | `y` |"),
                         "| [disk(n)](@ref openltc::disk), [openltc_x](@ref openltc_x) | `y` |")
        code = "```\n| `disk` | [a](b) |\n```"
        self.assertEqual(reference_filter.page(code), code)


if __name__ == "__main__":
    if shutil.which("doxygen") is None:
        print("skipped: doxygen is not there")
        sys.exit(k_exit_skipped)
    unittest.main()
