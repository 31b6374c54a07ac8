"""Checks docs/figures.md: every figure in docs/figures/ is made by its file, stands in the text as it is, and is shown.

    check_docs.py DOCS BRDFPLOT [--write]
    check_docs.py --self-test

Numbers of a drawing may differ by 0.02 of a unit, which no eye sees; all else is the same text. `--write` makes the
drawings anew, and brings the text up to date with the files.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

TOLERANCE = 0.02
MOST_BYTES = 500_000
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
LINK = r"\[`figures/{name}\.json`\]\(figures/{name}\.json\)\n\n```json\n(.*?)```"


def same_drawing(a: str, b: str) -> bool:
    if NUMBER.sub("#", a) != NUMBER.sub("#", b):
        return False
    pairs = zip(NUMBER.findall(a), NUMBER.findall(b))
    return all(abs(float(x) - float(y)) <= TOLERANCE for x, y in pairs)


def check_text(text: str, name: str, json: str) -> list[str]:
    problems = []
    found = re.search(LINK.format(name=re.escape(name)), text, re.DOTALL)
    if not found:
        problems.append(f"figures.md: {name}.json is not there")
    elif found.group(1) != json:
        problems.append(f"figures.md: {name}.json stands there differently")
    if f"(figures/{name}.svg)" not in text:
        problems.append(f"figures.md: {name}.svg is not shown")
    return problems


def drawn(brdfplot: str, files: list[Path]) -> dict[str, str]:
    with tempfile.TemporaryDirectory() as folder:
        call = [brdfplot, "plot", *map(str, files), "-o", folder, "--quiet"]
        subprocess.run(call, check=True)
        return {file.stem: file.read_text(encoding="utf-8") for file in Path(folder).glob("*.svg")}


def rewritten(text: str, name: str, json: str) -> str:
    def block(found: re.Match) -> str:
        return found.group(0).replace(found.group(1), json)

    return re.sub(LINK.format(name=re.escape(name)), block, text, flags=re.DOTALL)


def check(docs: Path, brdfplot: str, write: bool) -> list[str]:
    files = sorted((docs / "figures").glob("*.json"))
    text = (docs / "figures.md").read_text(encoding="utf-8")
    svgs = drawn(brdfplot, files)
    problems = [] if files else [f"{docs}: no figures"]
    for file in files:
        json = file.read_text(encoding="utf-8")
        committed = file.with_suffix(".svg")
        if write:
            committed.write_text(svgs[file.stem], encoding="utf-8")
            text = rewritten(text, file.stem, json)
        problems += check_text(text, file.stem, json)
        if not committed.exists() or not same_drawing(committed.read_text(encoding="utf-8"), svgs[file.stem]):
            problems.append(f"figures/{committed.name} is not what its file makes; run check_docs.py --write")
    for svg in (docs / "figures").glob("*.svg"):
        if not svg.with_suffix(".json").exists():
            problems.append(f"figures/{svg.name} has no file that makes it")
    size = sum(file.stat().st_size for file in (docs / "figures").iterdir())
    if size > MOST_BYTES:
        problems.append(f"figures: {size} bytes; accepted: at most {MOST_BYTES}")
    if write:
        (docs / "figures.md").write_text(text, encoding="utf-8")
    return problems


def self_test() -> None:
    assert same_drawing("<path d='M1.50 2'/>", "<path d='M1.51 2'/>")
    assert not same_drawing("<path d='M1.50 2'/>", "<path d='M1.60 2'/>")
    assert not same_drawing("<text>G</text>", "<text>H</text>")
    text = "[`figures/a.json`](figures/a.json)\n\n```json\n{}\n```\n\n![A](figures/a.svg)\n"
    assert check_text(text, "a", "{}\n") == []
    assert check_text(text, "a", "[]\n") == ["figures.md: a.json stands there differently"]
    assert len(check_text(text, "b", "{}\n")) == 2
    assert "[]\n```" in rewritten(text, "a", "[]\n")


def main() -> int:
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        return 0
    problems = check(Path(sys.argv[1]), sys.argv[2], "--write" in sys.argv[3:])
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
