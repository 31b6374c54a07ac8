#!/usr/bin/env python3
"""brdfplot against the equations of two texts as they are printed, and whether every one of them is among these.

    printed_equations.py BRDFPLOT docs/equations.md printed_equations.csv   compares: exit code 1 where a value is off, or
                                                                           an equation has none
    printed_equations.py --values printed_equations.csv                    compares the file with mpmath's values
    printed_equations.py --write printed_equations.csv                     writes it

A line of the file is a material, a quantity, directions, and the value that mpmath gives with 50 digits (printed.py).
"""

import csv
import io
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HEAD = ["text", "equations", "material", "quantity", "strategy", "theta_o", "phi_o", "theta_i", "phi_i", "theta_m",
        "phi_m", "value", "bound"]
ANGLES = HEAD[5:11]


def as_written():
    from printed import CASES
    from mpmath import nstr

    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(HEAD)
    for text, equations, material, quantity, strategy, inputs, value, bound in CASES:
        for at in inputs:
            angles = [repr(angle) for name in "oim" for angle in at.get(name, ())]
            cells = [angles.pop(0) if name[-1] in at else "" for name in ANGLES]
            writer.writerow([text, " ".join(map(str, equations)), json.dumps(material), quantity, strategy, *cells,
                             nstr(value(at), 20), repr(bound)])
    return out.getvalue()


def groups(rows):
    """The rows of each call of brdfplot."""
    together = {}
    for row in rows:
        given = tuple(name for name in ANGLES if row[name])
        together.setdefault((row["material"], row["quantity"], row["strategy"], row["bound"], given), []).append(row)
    return together.items()


def run(binary, *arguments, text=None):
    done = subprocess.run([binary, "--quiet", *arguments], input=text, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(f"{' '.join(arguments)}: {done.stderr}")
    return done.stdout


def ends_of_curve(binary, material, quantity, rows):
    """rho at the ends of a curve over theta_h, which are the normals of the rows."""
    _, variable, *fixed = quantity.split()
    at = {"phi_h": float(rows[0]["phi_m"]), **{name: float(value) for name, value in (one.split("=") for one in fixed)}}
    axis = {"variable": variable, "label": "x", "from": float(rows[0]["theta_m"]), "to": float(rows[-1]["theta_m"])}
    figure = {"id": "curve", "kind": "lines", "title": "a curve", "caption": "its ends", "x": axis, "y": {"label": "y"},
              "panels": [{"series": [{"quantity": "brdf", "material": {"$ref": Path(material).name}, "at": at}]}]}
    path = Path(material).with_name("figure.json")
    path.write_text(json.dumps(figure), encoding="utf-8")
    table = path.with_suffix(".csv")
    run(binary, "plot", str(path), "-o", str(table))
    lines = table.read_text(encoding="utf-8").splitlines()
    return [float(line.split(",")[-1]) for line in (lines[1], lines[-1])]


def computed(binary, material, quantity, strategy, given, rows):
    """What brdfplot says of the rows."""
    if quantity.startswith("check "):
        found = json.loads(run(binary, "check", material, "--json"))["rows"][0][quantity.split()[1]]
        if any(abs(float(row["theta_o"]) - found["theta_o"]) > 1e-9 for row in rows):
            return [float("nan")] * len(rows)
        return [found["max_residual"]] * len(rows)
    if quantity.startswith("plot "):
        return ends_of_curve(binary, material, quantity, rows)
    text = "\n".join([",".join(given), *(",".join(row[name] for name in given) for row in rows)]) + "\n"
    options = ["--strategy", strategy] if strategy else []
    lines = run(binary, "eval", material, "-q", quantity, *options, text=text).splitlines()
    return [float(line.split(",")[-1]) for line in lines[1:]]


def faults_of_values(binary, rows):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "material.json"
        for (material, quantity, strategy, bound, given), of in groups(rows):
            path.write_text(material, encoding="utf-8")
            least = 1e-3 * max(abs(float(row["value"])) for row in of)
            for row, value in zip(of, computed(binary, str(path), quantity, strategy, given, of), strict=True):
                wanted = float(row["value"])
                # The last is for what is exactly 0 throughout.
                if not abs(value - wanted) <= float(bound) * max(abs(wanted), least, 1e-300):
                    yield (f"{row['text']}, Eq. {row['equations']}: {quantity} of {material} at "
                           f"{', '.join(row[name] for name in given)} is {value!r} for {wanted!r}")


def equations_with_keys(page):
    """{(text, number): keys} of the lines of the page that name a key."""
    found, text = {}, ""
    for line in page.splitlines():
        if line.startswith("## "):
            text = line[3:].split(",")[0]
        cells = [cell.strip() for cell in line.split(" | ")]
        numbers = re.match(r"\| (?:9\.)?([0-9]+)(?:–(?:9\.)?([0-9]+))?$", cells[0])
        if not numbers or cells[-1].startswith("–"):
            continue
        keys = re.findall(r"`(\w+)`", cells[-1])
        for number in range(int(numbers[1]), int(numbers[2] or numbers[1]) + 1):
            found.setdefault((text, number), []).append(keys)
    return found


def faults_of_coverage(page, rows):
    """Equations that no line of the file is of, or none that names a key with which the page has them."""
    tried = {}
    for row in rows:
        for number in row["equations"].split():
            tried.setdefault((row["text"], int(number)), set()).update(
                re.findall(r"\w+", row["material"] + " " + row["quantity"]))
    texts = {text for text, _ in tried}
    wanted = equations_with_keys(page)
    for text in texts:
        if not any(of == text for of, _ in wanted):
            yield f"the page has no text {text}"
    for (text, number), lines in wanted.items():
        if text not in texts:
            continue
        if (text, number) not in tried:
            yield f"{text}: equation {number} has no value in the file"
            continue
        for keys in lines:
            if not tried[text, number] & set(keys):
                yield f"{text}: equation {number} has no value that is of {' or '.join(keys)}"


def main():
    path = Path(sys.argv[-1])
    if sys.argv[1] == "--write":
        path.write_text(as_written(), encoding="utf-8")
        return
    found = path.read_text(encoding="utf-8")
    if sys.argv[1] == "--values":
        if found != as_written():
            sys.exit(f"{path} is not what printed.py gives: ninja printed-equations")
        return
    binary, page = sys.argv[1:3]
    rows = list(csv.DictReader(io.StringIO(found)))
    faults = [*faults_of_coverage(Path(page).read_text(encoding="utf-8"), rows), *faults_of_values(binary, rows)]
    if faults:
        sys.exit("\n".join(faults))
    print(f"{len(rows)} values of {len({(r['text'], n) for r in rows for n in r['equations'].split()})} equations")


if __name__ == "__main__":
    main()
