#!/usr/bin/env python3
"""bake and simulate on the ranks of mpirun.

    check_ranks.py BRDFPLOT_WITH_MPI BRDFPLOT CONFIGS

The bytes are those of one process for 1, 2 and 4 ranks; what is wrong is told in one line, with its exit code; a rank that
is killed ends the run with one line, leaves no file but what was finished, and the next run goes on from there, to the
same bytes.
"""

import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

MPIRUN = ["mpirun", "--oversubscribe", "--allow-run-as-root", "--quiet", "--bind-to", "none"]
LONGEST = 120

SCENE = {"surface": {"type": "gaussian", "alpha": 0.6, "samples": 128, "correlation_length": 8}, "realisations": 3,
         "measures": [{"type": "g1", "theta_o": ["45deg", "75deg"], "rays": 20000},
                      {"type": "bounces", "theta_o": "75deg", "bounces": 4, "rays": 5000}]}
RIDGES = {"surface": {"type": "v_cavity", "alpha": 0.5, "pairs": 100}, "realisations": 2,
          "measures": [{"type": "g1", "theta_o": "60deg", "rays": 10000}]}


class Check:
    def __init__(self, with_mpi, alone, folder):
        self.with_mpi, self.alone, self.folder = with_mpi, alone, folder
        self.environment = dict(os.environ, XDG_CACHE_HOME=str(folder / "cache"))
        self.faults = []

    def command(self, ranks, words):
        return ([self.alone] if ranks == 0 else [*MPIRUN, "-n", str(ranks), self.with_mpi]) + words

    def run(self, ranks, words, **options):
        return subprocess.run(self.command(ranks, words), cwd=self.folder, env=self.environment, capture_output=True,
                              text=True, timeout=LONGEST, stdin=subprocess.DEVNULL, **options)

    def expect(self, what, holds, seen=""):
        if not holds:
            self.faults.append(f"{what}: {seen}")

    def kept(self):
        return [path for path in (self.folder / "cache").rglob("*") if path.is_file()]

    def files(self, name):
        path = self.folder / name
        return {p.name: p.read_bytes() for p in ([path] if path.is_file() else sorted(path.iterdir()))}

    def same_bytes(self, words, output):
        """Of the command with `-o OUTPUT`, on no rank and on 1, 2 and 4."""
        found = []
        for ranks in (0, 1, 2, 4):
            outcome = self.run(ranks, [*words, "-o", f"{ranks}{output}"])
            self.expect(f"{words} on {ranks}", outcome.returncode == 0 and outcome.stderr == "", outcome)
            found.append((outcome.stdout, list(self.files(f"{ranks}{output}").values())))
        self.expect(f"bytes of {words}", all(one == found[0] for one in found), [len(one[0]) for one in found])
        self.expect(f"what is kept after {words}", self.kept() == [], self.kept())

    def one_line(self, ranks, words, code, text):
        outcome = self.run(ranks, words)
        self.expect(f"{words} on {ranks}",
                    outcome.returncode == code and outcome.stdout == "" and
                    re.fullmatch(r"brdfplot: error: [^\n]*\n", outcome.stderr) and text in outcome.stderr, outcome)
        return outcome.stderr

    def ranks_of(self, launcher):
        """The processes of a run, by rank."""
        ranks = {}
        for status in Path("/proc").glob("[0-9]*/stat"):
            try:
                if int(status.read_text().rsplit(")", 1)[1].split()[1]) != launcher.pid:
                    continue
                variables = (status.parent / "environ").read_bytes().split(b"\0")
            except (OSError, IndexError):
                continue  # it has ended
            for variable in variables:
                if variable.startswith(b"OMPI_COMM_WORLD_RANK="):
                    ranks[int(variable.split(b"=")[1])] = int(status.parent.name)
        return ranks

    def ended_by(self, words, output, number, victim):
        """A signal to a rank (None: to mpirun) as soon as something is kept; what is said. The next run ends it."""
        before = len(self.kept())
        with subprocess.Popen(self.command(3, [*words, "-o", output]), cwd=self.folder, env=self.environment,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True) as process:
            until, first = time.monotonic() + LONGEST, 0
            while time.monotonic() < until:
                size = sum(path.stat().st_size for path in self.kept())
                first = first or size  # the head, or little more
                if size > first + 200:
                    break
                time.sleep(0.01)
            os.kill(process.pid if victim is None else self.ranks_of(process)[victim], number)
            out, err = process.communicate(timeout=LONGEST)
        self.expect(f"{words} that is ended", process.returncode != 0 and out == "", (process.returncode, out))
        self.expect(f"what {words} leaves", not (self.folder / output).exists() or self.files(output) == {}, output)
        self.expect(f"temporary files of {words}", list(self.folder.rglob("*.tmp")) == [], "there are some")
        self.expect(f"what is kept of {words}", len(self.kept()) == before + 1, self.kept())
        return err


def check(with_mpi, alone, configs, folder):
    test = Check(with_mpi, alone, folder)
    material = str(configs / "materials/ggx.json")
    for name, scene in (("scene", SCENE), ("ridges", RIDGES),
                        ("long", {**SCENE, "measures": [{"type": "bounces", "theta_o": "75deg", "rays": 1e8}]})):
        (folder / f"{name}.json").write_text(json.dumps(scene))
    small = ["bake", material, "-q", "furnace", "--over", "cos_theta_o=0:1:5", "--over", "alpha=0.2:1:3"]
    test.same_bytes(small, ".npy")
    test.same_bytes(["simulate", "scene.json"], "scene")
    test.same_bytes(["simulate", "ridges.json"], "ridges")

    # Bad input is told once, as one process tells it.
    for words, code, text in ((["bake", material, "-o", "x.npy", "--over", "nothing=0:1"], 2, "nothing"),
                              (["bake", material, "--bogus"], 2, "--bogus"),
                              (["simulate", "gone.json"], 3, "gone.json"),
                              (["bake", material, "-o", "x.npy", "--error", "1e-7"], 2, "--error"),
                              (["bake", material, "-o", "none/x.npy", "--over", "cos_theta_o=0.5:1:2"], 3, "none/x.npy"),
                              ([*small, "-o", "x.npy", "--tolerance", "1e-18"], 4, "asked: 1e-18")):
        alone_says, ranks_say = (test.one_line(ranks, words, code, text) for ranks in (0, 3))
        test.expect(f"the error of {words}", alone_says == ranks_say, (alone_says, ranks_say))
    test.expect("files of what failed", not list(folder.glob("x.npy*")))
    # Of what failed at its end the pieces are kept too.
    test.expect("what is kept of what failed", len(test.kept()) == 1, test.kept())
    for path in test.kept():
        path.unlink()

    # What rank 1 alone cannot read, or reads otherwise.
    for name, code, script in (("cannot", 3, '[ $OMPI_COMM_WORLD_RANK = 1 ] && cd /; exec "$@"'),
                               ("differs", 2, '[ $OMPI_COMM_WORLD_RANK = 1 ] && cd other; exec "$@"')):
        (folder / "other").mkdir(exist_ok=True)
        for kind, where in (("ggx", folder), ("beckmann", folder / "other")):
            (where / "mine.json").write_text((Path(configs) / f"materials/{kind}.json").read_text())
        outcome = subprocess.run([*MPIRUN, "-n", "3", "sh", "-c", script, "sh", with_mpi, "bake", "mine.json", "-o", "x.npy"],
                                 cwd=folder, env=test.environment, capture_output=True, text=True, timeout=LONGEST)
        test.expect(f"rank 1 {name}", outcome.returncode == code and
                    re.fullmatch(r"brdfplot: error: rank 1: [^\n]*\n", outcome.stderr), outcome)

    # Without MPI nobody computes the same thing four times.
    if with_mpi != alone:
        outcome = subprocess.run([*MPIRUN, "-n", "2", alone, *small, "-o", "x.npy"], cwd=folder, env=test.environment,
                                 capture_output=True, text=True, timeout=LONGEST)
        test.expect("without MPI", outcome.returncode == 2 and outcome.stderr.count("\n") == 1, outcome)

    # Ranks that are killed: any, at work; then the run goes on.
    long = ["bake", material, "-q", "furnace", "--over", "cos_theta_o=0:1:60", "--over", "alpha=0.2:1:20"]
    for victim in (1, 0):
        err = test.ended_by(long, "long.npy", signal.SIGKILL, victim)
        test.expect(f"rank {victim} is killed",
                    re.fullmatch(rf"brdfplot: error: rank {victim}: it has died[^\n]*\n", err), repr(err))
        outcome = test.run(2, [*long, "-o", "long.npy"])
        test.expect("the run after", outcome.returncode == 0 and test.kept() == [], (outcome, test.kept()))
        if victim == 1:
            test.run(0, [*long, "-o", "alone.npy"])
        test.expect("its bytes", test.files("long.npy")["long.npy"] == test.files("alone.npy")["alone.npy"])
        (folder / "long.npy").unlink()
    err = test.ended_by(["simulate", "long.json"], "long", signal.SIGKILL, 2)
    test.expect("rank 2 of rays is killed", re.fullmatch(r"brdfplot: error: rank 2: it has died[^\n]*\n", err), repr(err))
    for path in test.kept():
        path.unlink()
    err = test.ended_by(["simulate", "long.json"], "long", signal.SIGINT, None)
    test.expect("Ctrl-C", err == "brdfplot: error: interrupted\n", repr(err))
    return test.faults


def main():
    with_mpi, alone, configs = (str(Path(path).resolve()) for path in sys.argv[1:4])
    with tempfile.TemporaryDirectory() as folder:
        faults = check(with_mpi, alone, Path(configs), Path(folder))
    for fault in faults:
        print(fault)
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
