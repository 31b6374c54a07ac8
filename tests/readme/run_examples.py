"""Runs what the documentation shows and compares what it prints.

    run_examples.py ROOT BRDFPLOT  README.md, and the example of every command's --help
    run_examples.py --self-test

In README.md, in every ```sh and ```console block:
- a line that starts with "$ " is a command (a trailing backslash continues it); the lines up to the next command are its
  output, both streams, exactly, except that a line "..." stands for any number of lines,
  and that numbers may differ by 1e-9 (last digits change with the processor's instruction set);
- a block without "$ " is a script, one command a line, whose output is not compared;
- commands run in order, in one scratch folder that has configs/ and reports/, and must exit with 0 (`; echo $?` shows
  another code); what SKIPPED names is for the reader's machine and is not run.
Every ```json block has to be JSON; one with a "distribution" is a material, which `brdfplot validate` must accept.

In `brdfplot COMMAND --help` and `brdfplot --help`, the commands after the line "Example:" have to exit with 0.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

# Set-up: they build, or run all of this again.
SKIPPED = ("scripts/report", "scripts/test", ".ci/run", "git ", "cd ", "cmake ", "ctest ", "sudo ", "apt")
TIMEOUT = 600  # seconds for one command
FENCE = re.compile(r"^([ \t]*)```[ \t]*(\w*)[^\n`]*\n(.*?)^[ \t]*```[ \t]*$", re.M | re.S)


@dataclass
class Example:
    where: str
    command: str
    expected: list[str] | None  # None: not compared


def blocks(text: str) -> list[tuple[int, str, str]]:
    """(line, language, content) of every fenced block."""
    return [
        (text.count("\n", 0, m.start()) + 2, m[2], re.sub(rf"^{m[1]}", "", m[3], flags=re.M) if m[1] else m[3])
        for m in FENCE.finditer(text)
    ]


def join_continuations(lines: list[str]) -> list[tuple[int, str]]:
    """(index of the first line, command) with backslash-newline kept, as bash reads it."""
    joined, current, start = [], "", 0
    for index, line in enumerate(lines):
        if not current:
            start = index
        current += line
        if line.endswith("\\"):
            current += "\n"
            continue
        joined.append((start, current))
        current = ""
    return joined


def examples_of_block(file: str, first_line: int, content: str) -> list[Example]:
    lines = content.splitlines()
    examples: list[Example] = []
    if not any(line.startswith("$ ") for line in lines):
        commands = join_continuations(lines)
        return [Example(f"{file}:{first_line + i}", c, None) for i, c in commands if c.strip() and not c.lstrip().startswith("#")]
    continued = False
    for index, line in enumerate(lines):
        if continued:
            examples[-1].command += "\n" + line
        elif line.startswith("$ "):
            examples.append(Example(f"{file}:{first_line + index}", line[2:], []))
        elif examples:
            examples[-1].expected.append(line)
            continue
        else:
            examples.append(Example(f"{file}:{first_line + index}", "false # output before the first command", None))
        continued = examples[-1].command.endswith("\\")
    return examples


NUMBER = re.compile(r"-?\d+\.\d+(?:e[-+]?\d+)?|-?\d+e[-+]?\d+")


def same_line(expected: str, actual: str) -> bool:
    if NUMBER.sub("#", expected) != NUMBER.sub("#", actual):
        return expected == actual
    pairs = zip(NUMBER.findall(expected), NUMBER.findall(actual), strict=True)
    return all(abs(float(a) - float(b)) <= 1e-9 * max(1, abs(float(a))) for a, b in pairs)


def matches(expected: list[str], actual: list[str]) -> bool:
    """Whether the lines are the same, "..." among the expected ones standing for any number of lines."""
    if not expected:
        return not actual
    if expected[0].strip() == "...":
        return any(matches(expected[1:], actual[k:]) for k in range(len(actual) + 1))
    return bool(actual) and same_line(expected[0], actual[0]) and matches(expected[1:], actual[1:])


def run(command: str, folder: Path, brdfplot: Path) -> tuple[int, str]:
    environment = {**os.environ, "PATH": f"{brdfplot.parent}:{os.environ['PATH']}", "NO_COLOR": "1"}
    try:
        done = subprocess.run(
            ["bash", "-c", command], cwd=folder, env=environment, timeout=TIMEOUT, text=True, encoding="utf-8",
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return -1, f"no end within {TIMEOUT} s"
    return done.returncode, done.stdout


def indented(text: str) -> str:
    return "".join(f"    {line}\n" for line in text.splitlines()) or "    (nothing)\n"


def run_example(example: Example, folder: Path, brdfplot: Path) -> str | None:
    """What is wrong with it, or nothing."""
    code, output = run(example.command, folder, brdfplot)
    fault = f"{example.where}: {example.command}\n"
    if code != 0:
        return f"{fault}  exited with {code}:\n{indented(output)}"
    if example.expected is None:
        return None
    expected = "\n".join(example.expected).rstrip().splitlines()
    actual = [line.rstrip() for line in output.rstrip().splitlines()]
    if matches([line.rstrip() for line in expected], actual):
        return None
    shown = indented("\n".join(expected))
    return f"{fault}  expected\n{shown}  printed\n{indented(output)}"


def check_readme(readme: Path, folder: Path, brdfplot: Path) -> tuple[int, list[str]]:
    """The number of examples, and what is wrong."""
    if not readme.is_file():
        return 0, [f"{readme}: no such file"]
    count, faults = 0, []
    for line, language, content in blocks(readme.read_text(encoding="utf-8")):
        if language in ("sh", "console", "bash", "shell"):
            for example in examples_of_block(readme.name, line, content):
                if not example.command.startswith(SKIPPED):
                    count += 1
                    faults.append(run_example(example, folder, brdfplot))
        elif language == "json":
            count += 1
            faults.append(check_json(f"{readme.name}:{line}", content, folder, brdfplot))
    return count, [fault for fault in faults if fault]


def check_json(where: str, content: str, folder: Path, brdfplot: Path) -> str | None:
    try:
        value = json.loads(content)
    except json.JSONDecodeError as error:
        return f"{where}: not JSON: {error}"
    if not (isinstance(value, dict) and "distribution" in value):
        return None
    (folder / "readme-material.json").write_text(content, encoding="utf-8")
    return run_example(Example(where, "brdfplot validate readme-material.json", None), folder, brdfplot)


def command_names(help_text: str) -> list[str]:
    section = re.search(r"^(?:Subcommands|Commands):[ \t]*\n((?:[ \t]+\S.*\n?|[ \t]*\n)+)", help_text, re.M)
    if not section:
        return []
    lines = [line for line in section[1].splitlines() if line.strip()]
    indent = min(len(line) - len(line.lstrip()) for line in lines)
    # A deeper line is the rest of a description.
    return [line.split()[0] for line in lines if len(line) - len(line.lstrip()) == indent]


def help_examples(name: str, help_text: str) -> list[Example]:
    parts = re.split(r"^[ \t]*Examples?:", help_text, flags=re.M)
    lines = [line.strip() for line in parts[-1].splitlines()] if len(parts) > 1 else []
    where = f"brdfplot {name} --help"
    return [Example(where, c, None) for _, c in join_continuations(lines) if re.search(r"(^|[|;&] *)brdfplot ", c)]


def check_help(folder: Path, brdfplot: Path) -> tuple[int, list[str]]:
    code, text = run("brdfplot --help", folder, brdfplot)
    names = command_names(text)
    if code != 0 or not names:
        return 1, [f"brdfplot --help: exited with {code}, lists no command:\n{indented(text)}"]
    count, faults = 0, []
    for name in ["", *names]:
        code, text = run(f"brdfplot {name} --help", folder, brdfplot)
        examples = help_examples(name, text)
        if code != 0 or (name and not examples):
            faults.append(f"brdfplot {name} --help: exited with {code}, shows no example:\n{indented(text)}")
        for example in examples:
            count += 1
            faults.append(run_example(example, folder, brdfplot))
    return count, [fault for fault in faults if fault]


def self_test() -> None:
    program = """#!/bin/bash
case "$*" in
  --help) printf 'Usage\\n\\nSubcommands:\\n  eval    Evaluates\\n            and more\\n  validate Checks\\n\\nOptions:\\n  -x\\n' ;;
  'eval --help') printf 'Evaluates\\n\\nExample:\\n  echo 1 | brdfplot eval - \\\\\\n    -q d\\n' ;;
  'validate --help') printf 'Example: brdfplot validate a.json\\n' ;;
  'validate readme-material.json') grep -q good readme-material.json ;;
  'validate a.json' | 'eval - -q d') ;;
  *) printf 'a\\nb\\nc\\n'; echo 'warning' >&2; exit 3 ;;
esac
"""
    readme = """
```sh
git clone x
brdfplot --help
# a comment
brdfplot eval \\
  --help
```
```console
$ brdfplot x; echo $?
a
...
warning
3
$ ls
configs
reports
...
```
  ```console
  $ printf '%s\\n' \\
      one
  one
  ```
```json
{"distribution": "good"}
```
```json
[1]
```
```cpp
$ false
```
"""
    bad = {
        "exit code": "```sh\nbrdfplot x\n```\n",
        "output": "```console\n$ echo a\nb\n```\n",
        "missing line": "```console\n$ printf 'a\\nb\\n'\na\n```\n",
        "no output shown": "```console\n$ echo a\n```\n",
        "ellipsis in order": "```console\n$ printf 'a\\nb\\n'\nb\n...\n```\n",
        "not JSON": "```json\n{,}\n```\n",
        "invalid material": '```json\n{"distribution": "wrong"}\n```\n',
        "output first": "```console\nb\n$ echo a\na\n```\n",
    }
    with tempfile.TemporaryDirectory() as folder:
        root, brdfplot = Path(folder, "work"), Path(folder, "bin/brdfplot")
        for made in (root / "configs", root / "reports", brdfplot.parent):
            made.mkdir(parents=True)
        brdfplot.write_text(program)
        brdfplot.chmod(0o755)
        file = Path(folder, "README.md")
        for name, text in {"": readme, **bad}.items():
            file.write_text(text, encoding="utf-8")
            count, faults = check_readme(file, root, brdfplot)
            if len(faults) != (1 if name else 0) or (not name and count != 7):
                sys.exit(f"self-test {name!r}: {count} examples, {faults}")
        if check_help(root, brdfplot) != (2, []):
            sys.exit(f"self-test of --help: {check_help(root, brdfplot)}")
        brdfplot.write_text(program.replace("'validate a.json'", "nothing").replace("Evaluates\\n\\nExample:", "Evaluates"))
        if len(check_help(root, brdfplot)[1]) != 2:
            sys.exit(f"self-test of a faulty --help: {check_help(root, brdfplot)}")


def main(root: Path, brdfplot: Path) -> int:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for part in ("configs", "reports"):
            if (root / part).is_dir():
                shutil.copytree(root / part, folder / part)
        results = [check_readme(root / "README.md", folder, brdfplot), check_help(folder, brdfplot)]
    faults = [fault for _, faults in results for fault in faults]
    for fault in faults:
        print(fault)
    print(f"{sum(count for count, _ in results)} examples, {len(faults)} wrong")
    return bool(faults)


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) == 3:
        sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()))
    else:
        sys.exit(__doc__)
