#!/usr/bin/env python3
"""Runs every fuzzer of a build, on its corpus and on the files in configs/.

    run_fuzzers.py FOLDER [--seconds S] [--runs N] [--only READER[,READER]]

FOLDER has the executables fuzz-READER. What they find stays in FOLDER/findings, inputs that reach new code in
FOLDER/found. The last line is the result: "N passed, N failed".
"""

import argparse
import base64
import os
import re
import subprocess
import sys
import zlib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
CONFIGS = {"material": ["materials"], "figure": ["figures"], "report": ["reports"], "scene": ["scenes"], "advice": ["scenes"],
           "csv": ["points"], "image": ["scenes"]}
LIMITS = ["-rss_limit_mb=2048", "-timeout=10", "-max_len=4096", "-print_final_stats=1", "-verbosity=1"]


# The scratch file of a fuzzer is written at every execution: in memory, where the system has a folder of it.
SHARED = Path("/dev/shm")
ENVIRONMENT = os.environ | {"ASAN_OPTIONS": "malloc_context_size=3"} | ({"TMPDIR": str(SHARED)} if os.access(SHARED, os.W_OK) else {})


def run(folder, reader, arguments):
    found = folder / "found" / reader
    findings = folder / "findings" / reader
    for path in (found, findings):
        path.mkdir(parents=True, exist_ok=True)
    before = set(findings.iterdir())
    corpora = [found, HERE / "corpus" / reader, *(SOURCE / "configs" / name for name in CONFIGS.get(reader, []))]
    # Many runs: as many again in the same time without the counts of how rare each feature is.
    limit = [f"-runs={arguments.runs}", "-entropic=0"] if arguments.runs else [f"-max_total_time={arguments.seconds}"]
    done = subprocess.run([folder / f"fuzz-{reader}", *LIMITS, *limit, f"-artifact_prefix={findings}/",
                           *(str(path) for path in corpora)], env=ENVIRONMENT, capture_output=True, text=True, errors="replace", check=False)
    count = re.search(r"stat::number_of_executed_units: *(\d+)", done.stderr)
    print(f"{reader}: {count.group(1) if count else '?'} executions, exit code {done.returncode}", flush=True)
    if done.returncode != 0:
        print(told(done.stderr, set(findings.iterdir()) - before), flush=True)
    return done.returncode == 0


def told(stderr, findings):
    """What is needed to see a finding again where only the end of this run's output is kept: the fault, where it was in
    our sources, and the input."""
    lines = stderr.splitlines()
    faults = [k for k, line in enumerate(lines) if re.search(r"ERROR: |runtime error: |==ERROR", line)]
    report = lines[faults[0]:] if faults else lines[-60:]
    frames = [line[:300] for line in report[1:] if "/src/" in line]
    text = report[:1] + frames[:20] if faults else report
    for path in sorted(findings):
        text += [f"{path.name}, through zlib and base64:", base64.b64encode(zlib.compress(path.read_bytes(), 9)).decode()]
    return "\n".join(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("--runs", type=int, default=0, help="executions each, instead of seconds")
    parser.add_argument("--only", help="readers, separated by commas")
    arguments = parser.parse_args()
    readers = arguments.only.split(",") if arguments.only else sorted(path.stem for path in HERE.glob("*.cpp"))
    with ThreadPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
        passed = sum(pool.map(lambda reader: run(arguments.folder.resolve(), reader, arguments), readers))
    print(f"{passed} passed, {len(readers) - passed} failed")
    sys.exit(0 if passed == len(readers) else 1)


if __name__ == "__main__":
    main()
