#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/measure_lobes.sh [NAME=FILE]...   what the form and objective of the lobes do to pictures
#
# Renders the demo scene unshadowed, through the middle of each pixel, with the built-in lobes and
# with lobes fitted here in other ways, and compares each with one reference. Prints the mean
# relative error, in per cent, by surface as a Markdown table (docs/fitting-pictures.md). NAME=FILE
# adds lobes of one's own, the name beginning with "polynomial" for those. Environment, with
# defaults:
#   OPENLTC=build/release/bin/openltc
#   OUT=out/lobes                    pictures, differences, lobes; the reference is kept there
#   SCENE=scenes/demo.glb   SIZE=640x360
#   REFERENCE_SAMPLES=4096
#   PUBLISHED=../shared/tables/ltc_code_1.dds   the published table, left out where it is missing
#   OLD_BUILTIN=                     commit whose built-in table is measured too; empty: none
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tool="${OPENLTC:-build/release/bin/openltc}"
out="${OUT:-out/lobes}"
scene="${SCENE:-scenes/demo.glb}"
size="${SIZE:-640x360}"
reference_samples="${REFERENCE_SAMPLES:-4096}"
published="${PUBLISHED-../shared/tables/ltc_code_1.dds}"
old_builtin="${OLD_BUILTIN-}"

if [[ ! -x "$tool" ]]; then
  echo "measure_lobes: $tool is not there; run 'make build'" >&2
  exit 1
fi
mkdir -p "$out"
same=(--size "$size" --filter none --shadow-samples 0 --quiet)

# Its name says all that it depends on but the scene and the tool.
reference="$out/reference_${size}_$reference_samples.exr"
if [[ ! -f "$reference" ]]; then
  echo "measure_lobes: the reference, $reference_samples samples per pixel" >&2
  "$tool" render "$scene" "${same[@]}" --integrator reference --samples "$reference_samples" \
    --seed 99 -o "$out/reference_new.exr" -o "$out/reference.png"
  mv "$out/reference_new.exr" "$reference"
fi

# Runs openltc fit with the other arguments and says where the lobes are.
fitted() { # file fit_argument...
  local file="$out/$1.json"
  "$tool" fit --brdf ggx "${@:2}" --quiet -o "$file" >/dev/null
  echo "$file"
}

# The numbers of an earlier built-in table, once C++, as a table file.
old_table() { # commit
  git show "$1:openltc/table/builtin_ggx.cpp" | /usr/bin/python3 -c 'import json, re, sys
text = sys.stdin.read()
numbers = re.search(r"k_numbers\[\d+\] = \{(.*?)\};", text, re.S).group(1)
texels = [float(x) for x in numbers.split(",") if x.strip()]
json.dump({"format": "openltc-lobe-table", "version": 1, "size": round((len(texels) / 6) ** 0.5),
           "metadata": {"brdf": "ggx", "command": "built-in of " + sys.argv[1]},
           "texels": texels}, sys.stdout)' "$1" >"$out/old_builtin.json"
  echo "$out/old_builtin.json"
}

labels=() forms=() files=()
add() { # label form file; no file: the built-in
  labels+=("$1") forms+=("$2") files+=("${3:-}")
}

add "table 64, balanced (built-in)" table
add "polynomial degree 4, balanced (built-in)" polynomial
for objective in tv l2 l3; do
  add "table 64, $objective" table "$(fitted "table_$objective" --objective "$objective")"
done
for weights in 1,0.1,0.1 1,0.2,0.2; do # of tv, l2 and l3, between tv and balanced
  add "table 64, weights $weights" table "$(fitted "table_$weights" --objective "$weights")"
done
for objective in balanced tv; do
  add "table 64, $objective, refined" table \
    "$(fitted "table_${objective}_refined" --objective "$objective" --refine on)"
done
for n in 8 16 32 128; do
  add "table $n, balanced" table "$(fitted "table_$n" --size "$n")"
done
for n in 8 16; do
  add "table $n, tv" table "$(fitted "table_${n}_tv" --size "$n" --objective tv)"
done
for objective in tv l3; do
  add "polynomial degree 4, $objective" polynomial \
    "$(fitted "polynomial_$objective" --form polynomial --objective "$objective")"
done
for degree in 3 5 6; do
  add "polynomial degree $degree, balanced" polynomial \
    "$(fitted "polynomial_$degree" --form polynomial --degree "$degree")"
done
if [[ -n "$published" && -f "$published" ]]; then
  "$tool" convert "$published" "$out/published.json" --from-layout ltc_code --brdf ggx \
    --layout native --quiet >&2
  add "the published table" table "$out/published.json"
fi
if [[ -n "$old_builtin" ]] && git cat-file -e "$old_builtin^{commit}" 2>/dev/null; then
  add "table 64, built-in of $old_builtin" table "$(old_table "$old_builtin")"
fi
for argument in "$@"; do
  form=table
  [[ "$argument" == polynomial* ]] && form=polynomial
  add "${argument%%=*}" "$form" "${argument#*=}"
done

# A row of the table, from a comparison's JSON. Metals and dielectrics are means over their pixels.
row() { # label json
  /usr/bin/python3 -c 'import json, sys
result = json.load(open(sys.argv[2]))
surfaces = {e["surface"]: e for e in result["by_surface"]}
def mean(*wanted):
    found = [e for name, e in surfaces.items() if all(w in name for w in wanted)]
    pixels = sum(e["pixels"] for e in found)
    if not pixels: return "–"
    return "%.2f" % (100 * sum(e["mean_relative_error"] * e["pixels"] for e in found) / pixels)
cells = [mean(""), mean("dielectric"), mean("metal")]
for place in "front", "grazing":
    cells += [mean("metal", "roughness " + r, place) for r in ("0.0-0.2", "0.2-0.4", "0.4-0.6",
                                                              "0.6-0.8", "0.8-1.0")]
cells += ["%.4f" % result["relative_mse"], "%.4f" % result["flip"]["mean"]]
print("| %s | %s |" % (sys.argv[1], " | ".join(cells)))' "$@"
}

echo "| lobes | all | dielectrics | metals | 0–.2 | .2–.4 | .4–.6 | .6–.8 | .8–1 | 0–.2 | .2–.4 | .4–.6 | .6–.8 | .8–1 | relative MSE | FLIP |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
for i in "${!labels[@]}"; do
  name="$(tr -cs 'a-z0-9' _ <<<"${labels[$i],,}")"
  name="$out/${name%_}"
  # Of the lobes alone: the BRDF's ratio to them, which only lobes that name GGX get, hides what they are.
  lobes=(--lobes "${forms[$i]}" --specular lobe)
  [[ -n "${files[$i]}" ]] && lobes+=(--table "${files[$i]}")
  "$tool" render "$scene" "${same[@]}" --samples 1 "${lobes[@]}" -o "$name.exr" -o "$name.png"
  "$tool" compare "$name.exr" "$reference" --scene "$scene" --json \
    --diff "${name}_difference.png" >"$name.compare.json"
  row "${labels[$i]}" "$name.compare.json"
done
