"""Runs the tour of the README in a system into which the package was installed.

    run_tour.py ROOT    ROOT: the root folder of that system; as root, since it is entered by chroot

The commands and what is compared are those of tests/readme/run_examples.py: every example of README.md and of every --help.
The configs are the installed ones.
"""

import shutil
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "tests/readme"))
import run_examples  # noqa: E402


def main(root: Path) -> int:
    folder = root / "root/tour"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(root / "usr/share/brdfplot/configs", folder / "configs")

    def run(command: str, where: Path, _brdfplot: Path) -> tuple[int, str]:
        environment = {"PATH": "/usr/bin:/bin", "HOME": "/root", "NO_COLOR": "1"}
        try:
            done = subprocess.run(
                ["/usr/sbin/chroot", root, "bash", "-c", f"cd /{where.relative_to(root)}\n{command}"], env=environment, text=True, encoding="utf-8",
                timeout=run_examples.TIMEOUT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return -1, f"no end within {run_examples.TIMEOUT} s"
        print(f"{done.returncode}  {command.splitlines()[0]}", flush=True)
        return done.returncode, done.stdout

    run_examples.run = run
    results = [run_examples.check_readme(PROJECT / "README.md", folder, Path()), run_examples.check_help(folder, Path())]
    faults = [fault for _, faults in results for fault in faults]
    for fault in faults:
        print(fault)
    print(f"{sum(count for count, _ in results)} examples, {len(faults)} wrong")
    return bool(faults)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve()))
