"""The completions know what the help knows, and the shells take them.

    check_completions.py BRDFPLOT COMPLETIONS   COMPLETIONS: the folder that packaging/from_help.py made

Every command and every flag of `brdfplot --help` and of every `brdfplot COMMAND --help` has to be offered by bash, which is
run for it, and has to stand in the files of zsh and fish. Then bash, and zsh where there is one, complete command lines
that are typed at a terminal, with names that `brdfplot list` tells; fish, where there is one, is asked for its candidates.
"""

import os
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

# What is typed before the tab key, and the words of the command line after it.
TYPED = [
    ("brdfplot ev", ["eval"]),
    ("brdfplot --threads 2 sch", ["--threads", "2", "schema"]),
    ("brdfplot eval --prec", ["eval", "--precision"]),
    ("brdfplot eval --precision si", ["eval", "--precision", "single"]),
    ("brdfplot eval -q lambda,p2", ["eval", "-q", "lambda,p22"]),
    ("brdfplot eval onl", ["eval", "only.json"]),
    ("brdfplot plot --vs masking=v_", ["plot", "--vs", "masking=v_cavity"]),
    ("brdfplot list exponential_", ["list", "exponential_power"]),
    ("brdfplot list quant", ["list", "quantities"]),
    ("brdfplot pareto fresnel_c", ["pareto", "fresnel_conductor"]),
    ("brdfplot stress --fail-on peak", ["stress", "--fail-on", "peak_missed"]),
    ("brdfplot bake --type ha", ["bake", "--type", "half"]),
    ("brdfplot bake -q mean_f", ["bake", "-q", "mean_f"]),  # two of them: mean_furnace, mean_fresnel
    ("brdfplot schema rep", ["schema", "report"]),
    ("brdfplot --color al", ["--color", "always"]),
]
FISH = [("brdfplot eval -q lambda,p2", "lambda,p22"), ("brdfplot plot --vs masking=v_", "masking=v_cavity"),
        ("brdfplot list exponential_", "exponential_power"), ("brdfplot stress --fail-on peak", "peak_missed")]


def help_of(brdfplot: Path, *command: str) -> str:
    return subprocess.run([brdfplot, *command, "--help"], check=True, capture_output=True, text=True).stdout


def commands_of(text: str) -> list[str]:
    return re.findall(r"^  ([a-z]+)", text.split("\nCommands:\n")[1].split("\n\n")[0], re.M)


def flags_of(text: str) -> set[str]:
    options = text.split("\nOptions:\n")[1].split("\n\n")[0]
    return {flag for names in re.findall(r"^  (-\S+)", options, re.M) for flag in names.split(",")}


def offered_by_bash(completion: Path, words: list[str]) -> set[str]:
    """What the function of the completion answers where the last of the words is being typed."""
    script = (f'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _brdfplot brdfplot "${{!#}}"\n'
              'printf "%s\\n" "${COMPREPLY[@]}"')
    done = subprocess.run(["bash", "--norc", "-c", script, "bash", completion, *words], capture_output=True, text=True, check=True)
    if done.stderr:
        raise SystemExit(f"bash says: {done.stderr}")
    return set(done.stdout.split())


def missing(brdfplot: Path, completions: Path, *of: str) -> list[str]:
    """Commands and flags that the help has and a completion does not; flags of these commands, or of all."""
    top = help_of(brdfplot)
    commands, every = commands_of(top), flags_of(top)
    bash, zsh, fish = (completions / name for name in ("brdfplot.bash", "_brdfplot", "brdfplot.fish"))
    zsh_text, fish_text = zsh.read_text(encoding="utf-8"), fish.read_text(encoding="utf-8")
    faults = []

    def expect(what: set[str], found: set[str], where: str):
        faults.extend(f"{where}: no {name}" for name in sorted(what - found))

    def fish_flags(condition: str) -> set[str]:
        lines = re.findall(rf"^complete -c brdfplot{condition} -[sl] .*$", fish_text, re.M)
        return {("-" if kind == "s" else "--") + name for line in lines for kind, name in re.findall(r" -([sl]) (\S+)", line.split(" -d ")[0])}

    expect(set(commands), offered_by_bash(bash, ["brdfplot", ""]), "bash")
    expect(every, offered_by_bash(bash, ["brdfplot", "-"]), "bash")
    expect(set(commands), set(re.findall(r"^    '([a-z]+):", zsh_text, re.M)), "zsh")
    expect(set(commands), set(re.findall(r"__fish_use_subcommand -a (\S+)", fish_text)), "fish")
    expect(every, fish_flags(""), "fish")
    of_all = set(re.findall(r"(?<=['{,])--?\w[\w-]*", zsh_text.split("global=(")[1].split("  case ")[0]))
    expect(every, of_all, "zsh")
    for command in of or commands:
        flags = flags_of(help_of(brdfplot, command))
        expect(flags | every, offered_by_bash(bash, ["brdfplot", command, "-"]), f"bash, {command}")
        section = zsh_text.split(f"\n    {command}) ")[1].split(";;")[0]
        expect(flags, set(re.findall(r"(?<=['{,*])--?\w[\w-]*", section)), f"zsh, {command}")
        expect(flags, fish_flags(f" -n '__fish_seen_subcommand_from {command}'") | fish_flags(""), f"fish, {command}")
    return faults


class Terminal:
    """A shell that is typed at."""

    def __init__(self, command: list[str], folder: Path, environment: dict[str, str]):
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.execvpe(command[0], command, environment)

    def until(self, mark: str, seconds: float = 20) -> str:
        out, end = "", time.monotonic() + seconds
        while mark not in out:
            if not select.select([self.terminal], [], [], max(0, end - time.monotonic()))[0]:
                raise SystemExit(f"no {mark!r} within {seconds} s, but: {out!r}")
            out += os.read(self.terminal, 4096).decode(errors="replace")
        return out

    def type(self, keys: str):
        os.write(self.terminal, keys.encode())

    def close(self):
        self.type("\x03exit\n")
        os.close(self.terminal)
        os.waitpid(self.process, 0)


def check_typed(shell: str, completions: Path, folder: Path) -> list[str]:
    """What the tab key makes of a line; it is printed, a word in each pair of brackets, in place of being run."""
    setup = {"bash": ["bash", "--norc", "--noprofile", "-i"], "zsh": ["zsh", "-f", "-i"]}[shell]
    environment = {**os.environ, "TERM": "dumb", "PS1": "READY", "INPUTRC": "/dev/null", "HOME": str(folder)}
    terminal = Terminal(setup, folder, environment)
    load = {"bash": f"bind 'set enable-bracketed-paste off'; source '{completions}/brdfplot.bash'",
            "zsh": f"bindkey -e; unset zle_bracketed_paste; fpath=('{completions}' $fpath); autoload -Uz compinit; compinit -u -D"}
    terminal.type(f"{load[shell]}; show() {{ printf '[%s]' \"$@\"; echo E''ND; }}; echo LOAD''ED\n")
    terminal.until("LOADED")
    faults = []
    for typed, expected in TYPED:
        terminal.type(typed + "\t")
        terminal.type("\x01show \n")  # to the line's beginning
        words = re.findall(r"\[([^\[\]]*)\]", terminal.until("END").rsplit("show brdfplot", 1)[-1])
        if words != ["brdfplot", *expected]:
            faults.append(f"{shell}: {typed!r} becomes {words}, not {expected}")
    terminal.close()
    return faults


def check_fish(completions: Path, folder: Path) -> list[str]:
    faults = []
    for typed, expected in FISH:
        script = f"source {completions}/brdfplot.fish; complete -C '{typed}'"
        done = subprocess.run(["fish", "--no-config", "-c", script], cwd=folder, capture_output=True, text=True)
        found = [line.split("\t")[0] for line in done.stdout.splitlines()]
        if found != [expected] or done.stderr:
            faults.append(f"fish: {typed!r} becomes {found}, not {expected}; {done.stderr}")
    return faults


def main(brdfplot: Path, completions: Path) -> int:
    os.environ["PATH"] = f"{brdfplot.parent}:{os.environ['PATH']}"
    faults = missing(brdfplot, completions)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "only.json").touch()
        (folder / "only.txt").touch()
        shells = [shell for shell in ("bash", "zsh") if shutil.which(shell)]
        for shell in shells:
            faults += check_typed(shell, completions, folder)
        if shutil.which("fish"):
            faults += check_fish(completions, folder)
            shells.append("fish")
        # The check itself: a flag that is left out is missed in all three.
        for file in completions.iterdir():
            text = file.read_text(encoding="utf-8").replace("--grid", "--gird").replace("-l grid", "-l gird")
            (folder / file.name).write_text(text, encoding="utf-8")
        missed = missing(brdfplot, folder, "eval")
        if missed != [f"{shell}, eval: no --grid" for shell in ("bash", "zsh", "fish")]:
            faults.append(f"a flag that is left out is not missed: {missed}")
    for fault in faults:
        print(fault)
    print(f"{', '.join(shells)}: {len(faults)} faults")
    return bool(faults)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()))
