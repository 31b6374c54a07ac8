#!/usr/bin/env python3
"""Makes calls of brdfplot fail, one at a time, and looks at what is left.

    check_faults.py BRDFPLOT FAULTS.so CONFIGS [--thorough] [--only COMMAND[,COMMAND]]

A command runs once without a fault, to count its calls of each kind, and then with the Nth of them failing: every N, or
with more than some hundreds of them N spread evenly. Whatever fails, the command ends with 0, where that does no harm, or
with 3 and one line on stderr; every file is either as it was or as it is without a fault; nothing else is left. At last
commands are killed at random moments: what stands under a final name is whole.
"""

import argparse
import json
import os
import random
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

CURVE = {
    "id": "curve", "kind": "lines", "title": "A curve", "caption": "One.",
    "x": {"variable": "theta_o", "from": 0.1, "to": 1.5, "samples": 9}, "y": {"label": "y"},
    "material": {"distribution": {"type": "ggx", "alpha": 0.5}},
    "panels": [{"series": [{"label": "GGX", "quantity": "g1"},
                           {"label": "walk", "quantity": "albedo",
                            "simulate": {"source": "smith_walk", "paths": 200, "samples": 3}}]}]}
HEATMAP = {
    "id": "map", "kind": "heatmap", "title": "A map", "caption": "One.", "cells": 8,
    "x": {"variable": "theta_o", "from": 0, "to": 1.5}, "y": {"variable": "alpha", "from": 0.1, "to": 1},
    "material": {"distribution": {"type": "beckmann", "alpha": 0.5}},
    "panels": [{"series": [{"quantity": "g1"}]}]}
SPHERES = {
    "id": "spheres", "kind": "spheres", "title": "Spheres", "caption": "Two.",
    "material": {"distribution": {"type": "ggx", "alpha": 0.5}},
    "sphere": {"pixels": 16, "lights": [{"type": "directional", "theta": 0.5, "irradiance": [1, 2, 3]}]},
    "panels": [{"sphere": {}}, {"sphere": {"lights": [{"type": "environment", "radiance": 0.5}]}}]}
REPORT = {
    "title": "Three things", "introduction": "They are small.",
    "entries": [
        {"section": "Curves", "figure": "curve.json"},
        {"section": "Tables", "table": {
            "id": "properties", "title": "Properties", "caption": "Few.", "maskings": ["smith"],
            "distributions": ["ggx"], "alpha": [0.5], "theta_o": ["60deg"]}},
        {"section": "Tables", "data": {"id": "measured", "title": "Measured", "caption": "Elsewhere.", "file": "data.csv"}}]}

ADVICE = {
    "materials": [{"material": {"name": "metal", "distribution": {"type": "ggx", "alpha": 0.5},
                                "fresnel": {"type": "schlick", "f0": 0.9}}}],
    "lights": [{"theta": "50deg", "irradiance": 1}], "view": {"theta_o": ["20deg", "40deg"]},
    "tolerance": {"delta_e": 20}}

# Each writes into `out`; the outcome is that of the whole folder.
COMMANDS = {
    "report": ["report", "report.json", "-o", "out", "--cache", "cache", "--threads", "1"],
    "eval": ["eval", "material.json", "-q", "g1,brdf", "-i", "points.csv", "-o", "out/values.csv", "--threads", "1"],
    "sample": ["sample", "material.json", "-n", "9", "-i", "viewers.csv", "-o", "out/samples.csv", "--threads", "2"],
    "plot": ["plot", "map.json", "spheres.json", "-o", "out", "--cache", "cache", "--threads", "1"],
    "check": ["check", "material.json", "--csv", "-o", "out/check.csv", "--threads", "1"],
    "stress": ["stress", "wall.json", "-o", "out", "--threads", "1"],
    "validate": ["validate", "report.json", "material.json"],
    "threads": ["report", "report.json", "-o", "out", "--cache", "cache", "--threads", "2"],
    "measured": ["eval", "measured.json", "-q", "brdf", "-i", "points.csv", "-o", "out/values.csv", "--threads", "1"],
    "convert": ["convert", "material.json", "-o", "out/table.binary", "--threads", "1"],
    "bake": ["bake", "material.json", "--over", "cos_theta_o=0:1:5", "-o", "out/table.npy", "--threads", "1"],
    "pieces": ["bake", "material.json", "--over", "cos_theta_o=0:1:3", "-o", "out/table.npy", "--cache", "cache", "--threads", "1"],
    "advise": ["advise", "advice.json", "-o", "out", "--threads", "1"],
    "stream": ["eval", "material.json", "-q", "g1,albedo", "-i", "points.csv", "-o", "out/values.csv", "--threads", "2"],
}

# What a kind of call may do when it fails. Writing tries again, or fails.
FAULTS = [("alloc", ""), ("alloc", "+"), ("open", ":EIO"), ("read", ":EIO"), ("read", ":EINTR"), ("write", ":ENOSPC"),
          ("write", "+:ENOSPC"), ("write", ":EINTR"), ("write", ":short"), ("fsync", ":EIO"), ("close", ":EIO"),
          ("rename", ":EIO"), ("mkdir", ":EIO"), ("thread", ""), ("thread", "+")]

ERROR = re.compile(rb"brdfplot: error: [^\n]+\n")


def write_inputs(folder, configs):
    for name, value in (("curve", CURVE), ("map", HEATMAP), ("spheres", SPHERES), ("report", REPORT), ("advice", ADVICE)):
        (folder / f"{name}.json").write_text(json.dumps(value))
    shutil.copy(Path(configs) / "materials/ggx.json", folder / "material.json")
    (folder / "measured.json").write_text(json.dumps({"terms": [{"type": "merl", "file": "table.binary"}]}))
    (folder / "table.binary").write_bytes(struct.pack("<3i", 4, 3, 5) + struct.pack("<180d", *range(180)))
    (folder / "wall.json").write_text(json.dumps({"terms": [{"type": "lambert", "albedo": 0.5}]}))
    (folder / "data.csv").write_text("function,error\nf,0.5\n")
    rows = [f"{0.05 + 0.0007 * k:.4f},{0.1 + 0.0005 * k:.4f},{0.003 * k:.3f}" for k in range(40)]
    (folder / "viewers.csv").write_text("theta_o\n" + "".join(f"{0.05 + 0.0007 * k:.4f}\n" for k in range(40)))
    (folder / "points.csv").write_text("theta_o,theta_i,phi_i\n" + "\n".join(rows) + "\n")


def content(folder):
    """The files below a folder, without what differs from run to run: seconds."""
    files = {}
    for path in sorted(folder.rglob("*")) if folder.exists() else []:
        if path.is_file():
            text = path.read_bytes()
            if path.name in ("report.json", "index.html"):
                text = re.sub(rb"\"seconds\": [0-9.e-]+|(less than )?[0-9.]+ s(?=[.<])", b"TIME", text)
            files[str(path.relative_to(folder))] = text
    return files


class Runner:
    def __init__(self, binary, library, inputs, work):
        self.binary, self.library, self.inputs, self.work = binary, library, inputs, work
        self.serial = 0

    def folder(self):
        self.serial += 1
        folder = self.work / f"run{self.serial}"
        folder.mkdir()
        for path in self.inputs.iterdir():
            (folder / path.name).symlink_to(path)
        (folder / "out").mkdir()
        return folder

    def environment(self, **more):
        # Without core dumps, and with messages of the C library's aborts where they are seen.
        return {**os.environ, "LD_PRELOAD": str(self.library), "XDG_CACHE_HOME": "/nonexistent", **more}

    def run(self, command, old, **environment):
        folder = self.folder()
        for name, text in old.items():
            (folder / "out" / name).parent.mkdir(exist_ok=True, parents=True)
            (folder / "out" / name).write_bytes(text)
        try:
            done = subprocess.run([self.binary, *COMMANDS[command]], cwd=folder, stdin=subprocess.DEVNULL,
                                  env=self.environment(**environment), capture_output=True, timeout=60, check=False)
            code, err = done.returncode, done.stderr
        except subprocess.TimeoutExpired:
            code, err = "timeout", b""
        kept = content(folder / "out")
        cached = content(folder / "cache")
        shutil.rmtree(folder)
        return code, err, kept, cached

    def counts(self, command):
        path = self.work / f"counts-{command}"
        code, err, kept, cached = self.run(command, {}, BRDFPLOT_FAULT_COUNTS=str(path))
        if code != 0 or err:
            sys.exit(f"{command} without a fault: exit code {code}, stderr {err!r}")
        return {kind: int(count) for kind, count in map(str.split, path.read_text().splitlines())}, kept, cached


def wrong_with(code, err, kept, cached, old, whole, whole_cache, kind):
    """What is wrong with an outcome, or nothing."""
    if code not in (0, 3):
        return f"exit code {code}: {err[-200:]!r}"
    if code == 0 and (err or kept != whole):
        return f"exit code 0, but {'stderr ' + repr(err) if err else 'the output differs'}"
    if code == 3 and not ERROR.fullmatch(err):
        return f"stderr is {err!r}"
    for name, text in kept.items():
        if text != whole.get(name) and text != old.get(name):
            return f"{name} is neither the old file nor the new one, whole"
    # A rename that fails has others before it, which the message tells.
    mixed = code == 3 and kept != old and any(old.get(name) != text for name, text in kept.items())
    if mixed and not (kind == "rename" and b" of the " in err) and kept != whole:
        return f"new files stand beside old ones: {[name for name, text in kept.items() if old.get(name) != text]}"
    # What a run that did not end keeps is appended to, each record with its hash.
    if any(text != whole_cache.get(name) for name, text in cached.items() if not name.startswith("pieces/")):
        return f"the cache holds {list(cached)}, which is not what it holds without a fault"
    return None


def sample(count, most, rng):
    if most is None or count <= most:
        return list(range(1, count + 1))
    # One in each of `most` equal parts, the first ones, where programs start, and the last ones, where records are made
    # and files written.
    inner = {1 + (k * count + rng.randrange(count)) // most for k in range(most)}
    return sorted(n for n in inner | set(range(1, 9)) | set(range(count - 5 * most + 1, count + 1)) if 1 <= n <= count)


def check_faults(runner, command, most, pool, rng):
    counts, whole, whole_cache = runner.counts(command)
    old = {name: b"as it was\n" for name in whole}
    jobs = [(kind, n, how) for kind, how in FAULTS for n in sample(counts[kind], most, rng)]

    def run(job):
        kind, n, how = job
        fault = f"{kind}:{n}{how}"
        return fault, wrong_with(*runner.run(command, old, BRDFPLOT_FAULT=fault), old, whole, whole_cache, kind)

    findings = [(fault, wrong) for fault, wrong in pool.map(run, jobs) if wrong]
    for fault, wrong in findings[:20]:
        print(f"BRDFPLOT_FAULT={fault} {command}: {wrong}")
    calls = ", ".join(f"{kind} {count}" for kind, count in counts.items())
    print(f"{command}: {len(jobs)} faults in {calls}: {len(findings)} findings", flush=True)
    return len(findings)


def check_kills(runner, command, times, rng):
    """Killed at random moments: every file under a final name is old or new, whole."""
    began = time.monotonic()
    _, whole, whole_cache = runner.counts(command)
    seconds = time.monotonic() - began
    findings = 0
    for _ in range(times):
        folder = runner.folder()
        old = {name: b"as it was\n" for name in whole}
        for name, text in old.items():
            (folder / "out" / name).parent.mkdir(exist_ok=True, parents=True)
            (folder / "out" / name).write_bytes(text)
        process = subprocess.Popen([runner.binary, *COMMANDS[command]], cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(rng.uniform(0, 1.2 * seconds))
        process.send_signal(signal.SIGKILL)
        process.wait()
        for known, kept in ((whole, content(folder / "out")), (whole_cache, content(folder / "cache"))):
            for name, text in kept.items():
                if not name.endswith(".tmp") and not name.startswith("pieces/") and text != known.get(name) and text != old.get(name):
                    print(f"{command}, killed: {name} is not whole")
                    findings += 1
        shutil.rmtree(folder)
    print(f"{command}: killed {times} times: {findings} findings", flush=True)
    return findings


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binary")
    parser.add_argument("library")
    parser.add_argument("configs")
    parser.add_argument("--thorough", action="store_true", help="every N")
    parser.add_argument("--only", help="commands, separated by commas")
    arguments = parser.parse_args()
    binary, library = (str(Path(path).resolve()) for path in (arguments.binary, arguments.library))
    commands = arguments.only.split(",") if arguments.only else list(COMMANDS)
    rng = random.Random(1)
    findings = 0
    with tempfile.TemporaryDirectory(prefix="brdfplot-faults-") as work, ThreadPoolExecutor(os.cpu_count()) as pool:
        inputs = Path(work) / "inputs"
        inputs.mkdir()
        write_inputs(inputs, arguments.configs)
        runner = Runner(binary, library, inputs, Path(work))
        for command in commands:
            most = None if arguments.thorough else 12 if command == "convert" else 60  # which writes 35 MB
            findings += check_faults(runner, command, most, pool, rng)
        for command in commands:
            if command in ("report", "eval", "plot"):
                findings += check_kills(runner, command, 100 if arguments.thorough else 34, rng)
    print(f"{findings} findings")
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
