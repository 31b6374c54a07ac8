"""The accuracy table: what the accuracy tests measured, one line a function.

    accuracy_table.py --write RUN.csv TABLE.csv PAGE.md  makes the committed table of a run
    accuracy_table.py --check RUN.csv TABLE.csv          whether a run, of however few inputs, agrees with it
    accuracy_table.py --self-test

RUN.csv is what the tests write where BRDFPLOT_ACCURACY_TABLE says: a line for each function, instruction set and domain.
A run agrees with the table when both have the same functions and bounds, and no error of the run is beyond the table's
by more than a twentieth, which is left for other versions of the mathematics library and other instruction sets.
"""

import csv
import io
import math
import sys
import tempfile
from pathlib import Path

HEADER = ["function", "type", "inputs", "bound (ulp)", "max (ulp)", "RMS (ulp)", "domain of the max", "worst input"]
SLACK = 1.05
INTRODUCTION = """# Accuracy

The largest and the root-mean-square error of every closed form against its definition in 113 bits and more, over the
domains of `tests/accuracy`, in units in the last place of the exact result. Made of a run of those tests by the target
`accuracy-table`; the bounds are the constants of `tests/accuracy/bounds.hpp`, which every run of the tests enforces on
each instruction set.

`scalar` is what one row costs the library's own models, `double` and `float` are the batch kernels and what `evaluate`
makes of them. Where a bound has a term in E, the squared norm of the slope (for the direction factor of Ashikhmin et al.,
7.3 φ²), the result contains exp(-E): a relative change of 2^-53 of the input, such as its own rounding, already changes
it by up to 4 E units of 2^-53. Errors are then divided by (1 + E / 2), so that the bound is that of E = 0.

Not in the table, since no closed form: Λ of exponential_power, ward, gaussian, custom and of gtr with γ other than 1, 2, 3
or 4, which are interpolated in a table of the integral of their own slopes. a Λ(a) has a relative error of at most 1e-10
down to 1e-290, as `tests/microfacet/lambda_ends.cpp` holds it to; below, and for custom from 1e-200 down, where formulas
underflow, an absolute error of at most 1e-200, of which G1 = 1 / (1 + Λ) shows nothing.

The bounds of `float` rows are for directions that are floats. `eval --precision single` first rounds the directions that
it reads to such, which moves the slope of the half vector by about 2^-24 / cos θ, where a lobe is α wide. Out to a slope of
2 α from the middle of the lobe the BRDF of Beckmann and GGX is within 2^-22 (1 + 1 / (α cos θ)) of the double one, cos θ the
smaller of the two cosines, while that is below 0.1 (`tests/brdf/evaluate_single.cpp`). As measured up to 89.9 degrees, for
α = 0.1 that is up to 5e-5, for α = 8e-4 3 % (GGX) and 6 % (Beckmann); for α = 2e-6 the two differ more than tenfold.

"""


def bound_text(row: dict) -> str:
    slope = float(row["bound_ulp_per_exponent"])
    return f"{float(row['bound_ulp']):g}" + (f" + {slope:g} E" if slope else "")


def type_of(row: dict) -> str:
    return "scalar" if row["isa"] == "scalar" else row["type"]


def condense(rows: list[dict]) -> list[list[str]]:
    groups: dict[tuple[str, str], list[dict]] = {}
    for row in rows:
        groups.setdefault((row["function"], type_of(row)), []).append(row)
    table = []
    for (function, kind), group in groups.items():
        worst = max(group, key=lambda row: float(row["max_ulp"]))
        bounds = {bound_text(row) for row in group}
        if len(bounds) > 1:
            raise SystemExit(f"{function}, {kind}: bounds {sorted(bounds)}; one constant a function is meant")
        checked = sum(int(row["inputs"]) for row in group)
        squares = sum(float(row["rms_ulp"]) ** 2 * int(row["inputs"]) for row in group)
        sets = len({row["isa"] for row in group})
        table.append([function, kind, str(checked // sets), bounds.pop(), f"{float(worst['max_ulp']):.3g}",
                      f"{math.sqrt(squares / max(checked, 1)):.2g}", worst["domain"], worst["worst_input"]])
    return table


def as_csv(table: list[list[str]]) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([HEADER, *table])
    return out.getvalue()


def as_page(table: list[list[str]]) -> str:
    lines = [HEADER, ["---"] * len(HEADER), *table]
    return INTRODUCTION + "".join("| " + " | ".join(line) + " |\n" for line in lines)


def read(path: Path) -> list[dict]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def problems(run: list[dict], table: list[dict]) -> list[str]:
    fresh = {(row[0], row[1]): row for row in condense(run)}
    known = {(row["function"], row["type"]): row for row in table}
    found = [f"{', '.join(key)}: only in the table" for key in sorted(known.keys() - fresh.keys())]
    found += [f"{', '.join(key)}: not in the table" for key in sorted(fresh.keys() - known.keys())]
    for key in sorted(known.keys() & fresh.keys()):
        name, row, old = ", ".join(key), fresh[key], known[key]
        if row[3] != old["bound (ulp)"]:
            found.append(f"{name}: the bound is {row[3]}, in the table {old['bound (ulp)']}")
        if float(row[4]) > SLACK * float(old["max (ulp)"]) + 0.01:
            found.append(f"{name}: {row[4]} ulp at {row[7]}, in the table {old['max (ulp)']}")
        if float(old["max (ulp)"]) > float(old["bound (ulp)"].split()[0]):
            found.append(f"{name}: {old['max (ulp)']} ulp in the table is beyond the bound")
    return found


def self_test() -> list[str]:
    def row(**changes: str) -> dict:
        return {"function": "f", "type": "double", "isa": "avx2", "domain": "d", "inputs": "10", "bound_ulp": "4",
                "bound_ulp_per_exponent": "0", "max_ulp": "2", "rms_ulp": "1", "worst_input": "x = 1", **changes}

    run = [row(), row(isa="baseline", max_ulp="3", rms_ulp="2")]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "table.csv"
        path.write_text(as_csv(condense(run)), encoding="utf-8")
        table = read(path)
    assert [table[0][name] for name in HEADER] == ["f", "double", "10", "4", "3", "1.6", "d", "x = 1"], table
    faults = {"as it is": ([], run), "a larger error": (["3.3 ulp"], [row(max_ulp="3.3")]),
              "another bound": (["the bound is 5"], [row(bound_ulp="5")]),
              "another function": (["only in", "not in"], [row(function="g")]),
              "a term in E": (["4 + 8 E"], [row(bound_ulp_per_exponent="8")])}
    failures = []
    for name, (expected, changed) in faults.items():
        found = problems(changed, table)
        if len(found) != len(expected) or any(part not in text for part, text in zip(expected, found)):
            failures.append(f"{name}: {found}")
    return failures


def main(arguments: list[str]) -> int:
    if arguments == ["--self-test"]:
        found = self_test()
    elif len(arguments) == 4 and arguments[0] == "--write":
        table = condense(read(Path(arguments[1])))
        Path(arguments[2]).write_text(as_csv(table), encoding="utf-8")
        Path(arguments[3]).write_text(as_page(table), encoding="utf-8")
        found = []
    elif len(arguments) == 3 and arguments[0] == "--check":
        found = problems(read(Path(arguments[1])), read(Path(arguments[2])))
    else:
        print(__doc__)
        return 2
    for problem in found:
        print(problem)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
