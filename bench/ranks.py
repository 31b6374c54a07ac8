#!/usr/bin/env python3
"""Scaling of bake and simulate over ranks of this machine, one thread each: strong (the same work) and weak (work in
proportion to the ranks), beside one process with as many threads.

    bench/ranks.py BRDFPLOT_WITH_MPI [--times N]

Seconds are the least of N runs, with what starting takes: mpirun, MPI, and the read of the input, which the first line
says by itself.
"""

import argparse
import json
import os
import subprocess
import tempfile
import time
from pathlib import Path

CONFIGS = Path(__file__).resolve().parent.parent / "configs"
RANKS = (1, 2, 4)
NODES = 48
RAYS = 4e5


def bake(folder, times):
    return ["bake", str(CONFIGS / "materials/ggx.json"), "-q", "furnace", "--over", "cos_theta_o=0:1:40",
            "--over", f"alpha=0.1:1:{NODES * times}", "-o", str(folder / "table.npy")]


def simulate(folder, times):
    scene = folder / f"scene{times}.json"
    scene.write_text(json.dumps({
        "surface": {"type": "gaussian", "alpha": 0.5, "samples": 512, "correlation_length": 8}, "realisations": 8,
        "measures": [{"type": "g1", "theta_o": ["45deg", "60deg", "75deg"], "rays": 10 * RAYS * times},
                     {"type": "bounces", "theta_o": "75deg", "rays": RAYS * times}]}))
    return ["simulate", str(scene), "-o", str(folder / "out")]


def start(folder, times):
    return ["bake", str(CONFIGS / "materials/ggx.json"), "-q", "furnace", "--over", "cos_theta_o=0.5:1:2",
            "-o", str(folder / "table.npy")]


def seconds(command, environment, times):
    took = []
    for _ in range(times):
        began = time.perf_counter()
        subprocess.run(command, check=True, env=environment, stdout=subprocess.DEVNULL)
        took.append(time.perf_counter() - began)
    return min(took)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("brdfplot")
    parser.add_argument("--times", type=int, default=3)
    arguments = parser.parse_args()
    print(f"{os.cpu_count()} processors")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        environment = dict(os.environ, XDG_CACHE_HOME=name)

        def on_ranks(ranks, words):
            return seconds(["mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none", "-n", str(ranks),
                            arguments.brdfplot, *words, "--threads", "1"], environment, arguments.times)

        def on_threads(threads, words):
            return seconds([arguments.brdfplot, *words, "--threads", str(threads)], environment, arguments.times)

        print("| work | ranks | strong, s | speed-up | weak, s | efficiency | threads instead, s |")
        print("| --- | --- | --- | --- | --- | --- | --- |")
        for what, words in (("start alone", start), ("bake", bake), ("simulate", simulate)):
            one = None
            for ranks in RANKS:
                strong = on_ranks(ranks, words(folder, 1))
                weak = strong if ranks == 1 else on_ranks(ranks, words(folder, ranks))
                one = one or strong
                threads = on_threads(ranks, words(folder, 1))
                print(f"| {what} | {ranks} | {strong:.2f} | {one / strong:.2f} | {weak:.2f} | {one / weak:.2f} | {threads:.2f} |",
                      flush=True)


if __name__ == "__main__":
    main()
