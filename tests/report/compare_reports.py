"""Compares two report folders: the same files in figures/ and tables/, the same text and, to 1e-9, the same numbers in
every CSV, and SVG that is well-formed.

    compare_reports.py COMMITTED FRESH
    compare_reports.py --self-test

A number may differ by 1e-9 absolutely or relative to the larger of the two; the rest of a report (index.html,
report.json) holds timings and is not compared.
"""

import csv
import math
import sys
import tempfile
from pathlib import Path
from xml.dom import minidom
from xml.parsers.expat import ExpatError

TOLERANCE = 1e-9
DIFFERENCES_SHOWN = 20


def number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def same_cell(a: str, b: str) -> bool:
    if a == b:
        return True
    x, y = number(a), number(b)
    if x is None or y is None:
        return False
    if not (math.isfinite(x) and math.isfinite(y)):
        return x == y or (math.isnan(x) and math.isnan(y))
    return abs(x - y) <= TOLERANCE * max(1.0, abs(x), abs(y))


def read_rows(path: Path) -> list[list[str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))


def compare_csv(name: str, a: Path, b: Path) -> list[str]:
    rows_a, rows_b = read_rows(a), read_rows(b)
    if len(rows_a) != len(rows_b):
        return [f"{name}: {len(rows_a)} lines, now {len(rows_b)}"]
    for line, (row_a, row_b) in enumerate(zip(rows_a, rows_b), 1):
        if len(row_a) != len(row_b):
            return [f"{name}:{line}: {len(row_a)} columns, now {len(row_b)}"]
        for column, (cell_a, cell_b) in enumerate(zip(row_a, row_b)):
            if not same_cell(cell_a, cell_b):
                return [f"{name}:{line}: column {rows_a[0][column]!r} was {cell_a!r}, now {cell_b!r}"]
    return []


def check_svg(name: str, path: Path) -> list[str]:
    try:
        root = minidom.parse(str(path)).documentElement
    except ExpatError as error:
        return [f"{name}: not well-formed: {error}"]
    return [] if root.localName == "svg" else [f"{name}: its root is <{root.tagName}>, not <svg>"]


def files_of(folder: Path) -> dict[str, Path]:
    return {str(p.relative_to(folder)): p for part in ("figures", "tables") for p in (folder / part).rglob("*") if p.is_file()}


def compare(a: Path, b: Path) -> list[str]:
    files_a, files_b = files_of(a), files_of(b)
    differences = []
    if not any(name.startswith("figures") for name in files_a):
        differences.append(f"{a}: no figures")
    differences += [f"{name}: only in {a}" for name in sorted(files_a.keys() - files_b.keys())]
    differences += [f"{name}: only in {b}" for name in sorted(files_b.keys() - files_a.keys())]
    for name in sorted(files_a.keys() & files_b.keys()):
        if name.endswith(".csv"):
            differences += compare_csv(name, files_a[name], files_b[name])
        elif name.endswith(".svg"):
            differences += check_svg(f"{a}/{name}", files_a[name]) + check_svg(f"{b}/{name}", files_b[name])
    return differences


def self_test() -> None:
    svg = '<svg xmlns="http://www.w3.org/2000/svg"><text>G₁</text></svg>'
    good = {
        "figures/a.csv": "panel,x,y\nleft,0.1,1e-12\n\"a, b\",1e6,nan\n",
        "figures/a.svg": svg,
        "tables/t.csv": "name,value\nσ,inf\n",
        "tables/t.md": "| name |\n",
        "index.html": "<p>1 second</p>",
    }
    equal = [
        {"index.html": "<p>2 seconds</p>"},
        {"figures/a.csv": "panel,x,y\nleft,0.10000000000001,-2e-12\n\"a, b\",1000000.0005,nan\n"},
        {"figures/a.csv": "panel,x,y\r\nleft,0.10,0\r\n\"a, b\",1000000,nan\r\n"},
    ]
    unequal = [
        {"figures/a.csv": "panel,x,y\nleft,0.100000002,1e-12\n\"a, b\",1e6,nan\n"},
        {"figures/a.csv": "panel,x,y\nleft,0.1,nan\n\"a, b\",1e6,nan\n"},
        {"figures/a.csv": "panel,x,y\nright,0.1,1e-12\n\"a, b\",1e6,nan\n"},
        {"figures/a.csv": "panel,x,y\nleft,0.1,1e-12\n"},
        {"figures/a.csv": "panel,x,y\nleft,0.1,1e-12\n\"a, b\",1e6\n"},
        {"figures/a.csv": None},
        {"figures/b.csv": "x\n"},
        {"figures/a.svg": svg[:-3]},
        {"figures/a.svg": "<html/>"},
        {"tables/t.csv": "name,value\nσ,-inf\n"},
        {"tables/t.csv": "name,value\nσ,1e300\n"},
    ]

    def write(folder: Path, files: dict) -> None:
        for name, content in files.items():
            if content is not None:
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (folder / name).write_text(content, encoding="utf-8", newline="")

    for change, expected in [(c, 0) for c in equal] + [(c, 1) for c in unequal]:
        with tempfile.TemporaryDirectory() as folder:
            a, b = Path(folder, "a"), Path(folder, "b")
            write(a, good)
            write(b, {**good, **change})
            found = compare(a, b)
            if len(found) != expected:
                sys.exit(f"self-test: {change}: expected {expected} differences, found {found}")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) == 3:
        found = compare(Path(sys.argv[1]), Path(sys.argv[2]))
        for difference in found[:DIFFERENCES_SHOWN]:
            print(difference)
        if len(found) > DIFFERENCES_SHOWN:
            print(f"... and {len(found) - DIFFERENCES_SHOWN} more")
        sys.exit(bool(found))
    else:
        sys.exit(__doc__)
