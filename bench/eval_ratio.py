"""The whole process `brdfplot eval -q lambda` beside eval_peer.py: seconds and their ratio.

    eval_ratio.py BRDFPLOT [ROWS [REPETITIONS]]     by default a million rows, five times

Both run in turn, and the fastest run of each counts: what else the machine does disturbs both alike. Wall time is what
one waits, with two threads; processor time is what all threads spend.
"""

import json
import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ALPHA = 0.3
PEER = Path(__file__).with_name("eval_peer.py")


def write_inputs(folder: Path, count: int) -> None:
    random.seed(1)
    with (folder / "rows.csv").open("w", encoding="ascii") as file:
        file.write("theta_o,phi_o\n")
        for _ in range(count):
            file.write(f"{random.uniform(0, 1.57)!r},{random.uniform(0, 6.28)!r}\n")
    material = {"distribution": {"type": "beckmann", "alpha": ALPHA}}
    (folder / "material.json").write_text(json.dumps(material), encoding="ascii")


def seconds_of(command: list[str], folder: Path) -> tuple[float, float]:
    """Wall and processor time of a process."""
    before, start = os.times(), time.perf_counter()
    subprocess.run(command, cwd=folder, check=True)
    wall, after = time.perf_counter() - start, os.times()
    return wall, after.children_user + after.children_system - before.children_user - before.children_system


def worst_difference(folder: Path) -> float:
    """Between the values of both: where Lambda is not small, the peer's are right to some digits."""
    worst = 0.0
    with (folder / "ours.csv").open() as ours, (folder / "peer.csv").open() as peer:
        assert ours.readline() == peer.readline()
        for x, y in zip(ours, peer, strict=True):
            worst = max(worst, abs(float(x.rsplit(",", 1)[1]) - float(y.rsplit(",", 1)[1])))
    return worst


def main() -> None:
    brdfplot = str(Path(sys.argv[1]).resolve())
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
    repetitions = int(sys.argv[3]) if len(sys.argv) > 3 else 5
    ours = [brdfplot, "eval", "material.json", "-q", "lambda", "-i", "rows.csv", "-o", "ours.csv", "--threads", "2"]
    peer = [sys.executable, str(PEER), "rows.csv", "peer.csv", str(ALPHA)]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_inputs(folder, count)
        runs = [(seconds_of(ours, folder), seconds_of(peer, folder)) for _ in range(repetitions)]
        difference = worst_difference(folder)
    print(f"{count} rows; largest difference of the values {difference:.1e}")
    for k, what in enumerate(["wall", "processor"]):
        fastest = [min(run[side][k] for run in runs) for side in (0, 1)]
        print(f"{what:10} brdfplot {fastest[0]:7.3f} s   numpy and scipy {fastest[1]:7.3f} s   "
              f"ratio {fastest[1] / fastest[0]:.1f}")


if __name__ == "__main__":
    main()
