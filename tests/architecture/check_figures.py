"""Every figure config is run by somebody: fails on one that no report manifest and no test names.

    check_figures.py ROOT         checks ROOT/configs/figures
    check_figures.py --self-test  checks the checker
"""

import re
import sys
import tempfile
from pathlib import Path


def unnamed_figures(root: Path) -> list[str]:
    figures = sorted((root / "configs/figures").rglob("*.json"))
    readers = [*(root / "configs/reports").rglob("*.json"), *(root / "tests").rglob("*.cpp"), *(root / "tests").rglob("*.py")]
    text = "\n".join(p.read_text(encoding="utf-8") for p in readers)
    return [
        str(figure.relative_to(root))
        for figure in figures
        if not re.search(rf"(?<![\w-]){re.escape(figure.stem)}(?:\.json)?(?![\w.-]*[\w-])", text)
    ]


def self_test() -> None:
    files = {
        "configs/figures/lobe.json": "{}",
        "configs/figures/lobe-2.json": "{}",
        "configs/figures/sub/polar.json": "{}",
        "configs/reports/paper.json": '{"figures": ["../figures/lobe-2.json"]}',
        "tests/plot/polar.cpp": 'read("configs/figures/sub/polar.json");',
    }
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for file, content in files.items():
            (root / file).parent.mkdir(parents=True, exist_ok=True)
            (root / file).write_text(content, encoding="utf-8")
        found = unnamed_figures(root)
        if found != ["configs/figures/lobe.json"]:
            sys.exit(f"self-test: {found}")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) == 2:
        missing = unnamed_figures(Path(sys.argv[1]))
        for figure in missing:
            print(f"{figure}: no manifest in configs/reports and no test names it")
        sys.exit(bool(missing))
    else:
        sys.exit(__doc__)
