#!/usr/bin/env python3
"""The table of equations: where an equation of a text is in brdfplot, made of the sources that the models name.

    equations.py BRDFPLOT docs/equations.md           compares: exit code 1 where the page is not what it should be
    equations.py --write BRDFPLOT docs/equations.md   writes the page
"""

import re
import subprocess
import sys
from pathlib import Path

# How `brdfplot list` names a text, and its heading on the page.
TEXTS = {
    "Heitz 2014": "Heitz 2014",
    "Kelemen and Szirmay-Kalos 2001": "Kelemen and Szirmay-Kalos 2001",
    "Akenine-Moller et al. 2018": "Real-Time Rendering, 4th edition, chapter 9 (Akenine-Möller et al. 2018)",
}
HEAD = """# Where equations are

What `brdfplot list` names as source, by equation: `ninja equations` writes this page, and a test compares it. Angles,
means and other steps on the way have no key of their own; Heitz's Table 3 is `brdfplot check`.
"""
# A heading of `brdfplot list`, and how what stands below it is asked for.
SECTIONS = [("Distributions", "distribution"), ("Masking functions", "masking"), ("Masking with shadowing", "shadowing"),
            ("Fresnel", "fresnel"), ("Terms", "term"), ("Quantities", "quantity"), ("Surfaces (", "surface"),
            ("Measures", "measure"), ("Surfaces in profile", "profile")]


def entries(listing):
    """(kind, key, doc with its source) of every model, quantity, surface and measure."""
    kind = key = None
    text = []
    for line in listing.splitlines() + ["end"]:
        heading = not line.startswith(" ")
        name = re.match(r"  (\S+)(.*)", line)
        if heading or name:
            if key:
                yield kind, key, " ".join(text)
            key, text = None, []
        if heading:
            kind = next((k for start, k in SECTIONS if line.startswith(start)), kind)
        elif name:
            key, text = name[1], [name[2].strip()]
        else:
            text.append(line.strip())


def equations(source):
    """The equations that a source names of each text: [(text, "27", 27.0)]."""
    for part in source.split(";"):
        for text in TEXTS:
            if not part.strip().startswith(text):
                continue
            for numbers in re.findall(r"Eqs?\. ([0-9][0-9., -]*)", part):
                for first, last in re.findall(r"([0-9]+(?:\.[0-9]+)?)(?:-([0-9]+(?:\.[0-9]+)?))?", numbers):
                    yield text, f"{first}–{last}" if last else first, [int(n) for n in first.split(".")]


def page(listing):
    rows = {text: [] for text in TEXTS}
    for kind, key, doc in entries(listing):
        found = re.search(r"\[([^\]]*[0-9]{4}[^\]]*)\]", doc)
        source = found[1] if found else ""
        if kind == "quantity" and not found:  # Heitz's, in the text itself
            source = "; ".join("Heitz 2014, " + e for e in re.findall(r"Eqs?\. [0-9][0-9, -]*", doc))
        for text, label, order in equations(source):
            what = re.sub(r";? (needs omega|takes ).*", "", doc[:found.start()] if found else doc).strip(" ;")
            what = what.split(":")[0] if len(what) > 120 else what
            rows[text].append((order, label, f"{kind} `{key}`", what.replace("|", "\\|")))
    lines = [HEAD]
    for text, heading in TEXTS.items():
        lines += [f"## {heading}\n", "| equation | what it is | where |", "| --- | --- | --- |"]
        lines += [f"| {label} | {what} | {where} |" for _, label, where, what in sorted(rows[text])]
        lines.append("")
    return "\n".join(lines)


def main():
    write = sys.argv[1:2] == ["--write"]
    binary, path = sys.argv[-2:]
    made = page(subprocess.run([binary, "list"], capture_output=True, text=True, check=True).stdout)
    if write:
        Path(path).write_text(made, encoding="utf-8")
    elif Path(path).read_text(encoding="utf-8") != made:
        sys.exit(f"{path} is not what `brdfplot list` says: ninja equations")


if __name__ == "__main__":
    main()
