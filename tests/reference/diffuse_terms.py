#!/usr/bin/env python3
"""The table of diffuse and cloth terms: what each reflects, and whether it is reciprocal, by measurement.

    diffuse_terms.py BRDFPLOT configs/reports/diffuse_terms.csv           compares: exit code 1 where they differ
    diffuse_terms.py --write BRDFPLOT configs/reports/diffuse_terms.csv   writes the table

Albedos are `eval -q albedo` of the term with an albedo of 1; reciprocity and energy are `check`'s largest residuals.
"""

import csv
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SHEEN = {"type": "mirror", "distribution": {"type": "sheen", "alpha": 0.5}}
GGX = {"type": "mirror", "distribution": {"type": "ggx", "alpha": 0.5}, "fresnel": {"type": "schlick", "f0": 0.04}}

# Equation, and the term.
TERMS = [
    ("9.61", {"type": "lambert"}),
    ("9.62", {"type": "fresnel_lambert", "f0": 0.04, "at": "normal"}),
    ("9.63", {"type": "fresnel_lambert", "f0": 0.04, "at": "half"}),
    ("9.64", {"type": "shirley", "f0": 0.04}),
    ("9.65", {"type": "complement", "of": GGX}),
    ("9.66", {"type": "disney_diffuse", "alpha": 1}),
    ("9.67", {"type": "disney_diffuse", "alpha": 1, "subsurface": 1}),
    ("9.68", {"type": "hammon_diffuse", "alpha": 1, "f0": 0.04}),
    ("", {"type": "oren_nayar", "sigma": 0.5}),
    ("", {"type": "oren_nayar", "sigma": 0.5, "form": "direct"}),
    ("", {"type": "oren_nayar", "sigma": 0.5, "form": "qualitative"}),
    ("", {"type": "fujii_oren_nayar", "roughness": 1}),
    ("", {"type": "eon", "roughness": 1}),
    ("9.26", {"type": "facet_diffuse", "distribution": {"type": "ggx", "alpha": 0.5}}),
    ("9.70", {"type": "uncharted2", "rim": 0.5, "rim_power": 2, "inner": 0.5, "inner_power": 2, "diffuse": 0.5}),
    ("9.71", {"type": "wrap", "w": 0.5}),
    ("9.71", {"type": "wrap", "w": 0.5, "form": "ratio"}),
    ("9.71", {"type": "wrap", "w": 0.5, "form": "conserving"}),
    ("9.72", {"type": "disney_sheen"}),
    ("9.74", {"type": "velvet_cloth", "alpha": 0.5, "amplitude": 4, "f0": 0.04}),
    ("9.74", {**SHEEN, "shadowing": {"type": "neubelt"}}),
    ("9.75", SHEEN),
    ("9.75", {**SHEEN, "masking": {"type": "sheen_fit"}}),
]
# Terms of `brdfplot list terms` that are not among them: mirrors, what bounces between them, measured ones and coats.
NOT_DIFFUSE = {"mirror", "kelemen", "multiple_bounce", "turquin", "merl", "rgl", "coated"}
# A quadrature: measuring it takes ten times what all others do, and comparing leaves it out.
SLOW = "facet_diffuse"
DEGREES = (0, 60, 89)
HEAD = ["term", "equation", *(f"albedo at {d}°" for d in DEGREES), "largest excess of energy", "at θ_o",
        "largest |ρ(o,i) - ρ(i,o)| / sum", "reciprocal", "conserving"]


def run(binary, *arguments, text=None):
    done = subprocess.run([binary, "--quiet", *arguments], input=text, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(done.stderr)
    return done.stdout


def name_of(term):
    """The term in words: "mirror (sheen, alpha 0.5; neubelt)"."""
    words = []
    for key, value in term.items():
        if key == "of":
            words.append("of " + name_of(value))
        elif key == "distribution":
            words.append(", ".join([value["type"], *(f"{k} {v}" for k, v in value.items() if k != "type")]))
        elif isinstance(value, dict):
            words.append(value["type"])
        elif key != "type":
            words.append(value if isinstance(value, str) else f"{key} {value}")
    return term["type"] + (f" ({'; '.join(words)})" if words else "")


def word(measured):
    return {"holds": "yes", "fails": "no"}.get(measured["verdict"], measured["verdict"])


def row(binary, equation, term):
    with tempfile.TemporaryDirectory() as folder:
        material = Path(folder) / "material.json"
        material.write_text(json.dumps({"terms": [term]}), encoding="utf-8")
        angles = "theta_o\n" + "".join(f"{d}deg\n" for d in DEGREES)
        albedos = run(binary, "eval", str(material), "-q", "albedo", "--tolerance", "1e-6", text=angles).splitlines()
        checked = json.loads(run(binary, "check", str(material), "--json"))["rows"][0]
    column = albedos[0].split(",").index("albedo")
    values = [f"{float(line.split(',')[column]):.4f}" for line in albedos[1:]]
    energy, swapped = checked["energy"], checked["reciprocity"]
    excess = max(energy["max_residual"], 0)
    where = f"{energy['theta_o'] * 57.29577951308232:.0f}°" if energy["verdict"] == "fails" else ""
    return [name_of(term), equation, *values, f"{excess:.3g}" if energy["verdict"] == "fails" else "0", where,
            f"{swapped['max_residual']:.3g}" if swapped["verdict"] == "fails" else "0", word(swapped), word(energy)]


def rows(binary, which):
    listed = set(re.findall(r"^  (\w+)$", run(binary, "list", "terms"), re.M))
    missing = listed - NOT_DIFFUSE - {term["type"] for _, term in TERMS}
    if missing:
        sys.exit(f"{__file__}: no row for {', '.join(sorted(missing))}")
    return [HEAD] + [row(binary, equation, term) for equation, term in TERMS if which(term)]


def main():
    write = sys.argv[1:2] == ["--write"]
    binary, path = sys.argv[-2:]
    if write:
        with open(path, "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(rows(binary, lambda term: True))
        return
    made = rows(binary, lambda term: term["type"] != SLOW)
    with open(path, encoding="utf-8", newline="") as file:
        found = [cells for cells in csv.reader(file) if not cells[0].startswith(SLOW)]
    for is_there, wanted in zip(found, made):
        if is_there != wanted:
            sys.exit(f"{path} is not what is measured (ninja diffuse-terms-table): {is_there} for {wanted}")
    if len(found) != len(made):
        sys.exit(f"{path} has {len(found)} rows for {len(made)}: ninja diffuse-terms-table")


if __name__ == "__main__":
    main()
