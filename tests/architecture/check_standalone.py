#!/usr/bin/env python3
"""Compiles each source of a unity build by itself, without making code.

    check_standalone.py BUILD_DIR

In a unity build a source also sees what those before it include; a build without it, which is CMake's default, would be
the first to tell. BUILD_DIR holds the compilation database of a unity build.
"""

import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def commands(build):
    """The source and the command of each file that the database has as part of another."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        unity = Path(entry["directory"], entry["file"])
        for source in re.findall(r'^#include "(.*\.cpp)"$', unity.read_text(), re.M) if unity.suffix == ".cxx" else ():
            command = [source if part == entry["file"] else part for part in shlex.split(entry["command"])]
            at = command.index("-o")
            yield source, command[:at] + command[at + 2 :] + ["-fsyntax-only", "-w"], entry["directory"]


def failures(build):
    """What the compiler says of those that do not compile, and the number of all."""

    def run(one):
        source, command, directory = one
        done = subprocess.run(command, cwd=directory, capture_output=True, text=True)
        return f"{source}:\n{done.stderr}" if done.returncode else None

    every = list(commands(build))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return [text for text in pool.map(run, every) if text], len(every)


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        (root / "a.cpp").write_text("#include <string>\nstd::string a;\n")
        (root / "b.cpp").write_text("std::string b;\n")
        (root / "unity.cxx").write_text(f'#include "{root}/a.cpp"\n#include "{root}/b.cpp"\n')
        entry = {"directory": folder, "file": "unity.cxx", "command": "c++ -std=c++20 -o unity.o -c unity.cxx"}
        (root / "compile_commands.json").write_text(json.dumps([entry]))
        found, count = failures(root)
        assert count == 2 and len(found) == 1 and found[0].startswith(f"{root}/b.cpp:"), found
    print("self-test passed")


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    found, count = failures(Path(sys.argv[1]))
    print(*found, sep="\n", end="" if not found else "\n")
    if not count:
        sys.exit(f"{sys.argv[1]}: no unity build")
    if found:
        sys.exit(f"{len(found)} of {count} sources do not compile by themselves")
    print(f"{count} sources compile by themselves")


if __name__ == "__main__":
    main()
