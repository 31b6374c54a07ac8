"""Man pages, completions and schemas, made from what `brdfplot --help`, `brdfplot COMMAND --help` and `brdfplot schema` print.

    from_help.py BRDFPLOT FOLDER

FOLDER gets man/brdfplot.1 and man/brdfplot-COMMAND.1, compressed as Debian wants them, and completions/brdfplot.bash,
completions/_brdfplot (zsh), completions/brdfplot.fish, and schemas/KIND.json, which the "$schema" of the configs names. Commands, flags and the words that a flag accepts stand in them;
the names of models and quantities are asked of `brdfplot list` when they are completed.

A help that this does not understand is an error: nothing is left out without a word.
"""

import gzip
import re
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

COLUMN = 30  # where the help's descriptions begin
MENU = 90  # characters of a line of a menu, about
MADE = "Made by packaging/from_help.py from the help of brdfplot."


@dataclass
class Entry:
    """A flag with all its names, an argument without a flag, or a command."""

    names: list[str]
    value: str  # what its value is called in the help; empty: it takes none
    doc: str
    complete: list[str] = field(default_factory=lambda: ["none"])  # how its value is completed

    @property
    def brief(self) -> str:
        """The first part of the description, or the words that it tells of, for a line of a menu."""
        if self.complete[:1] == ["word"] and self.doc.startswith(self.complete[1]):
            return ", ".join(self.complete[1:])
        first = re.split(r"; |\. ", re.sub(r" \([^)]*\)", "", self.doc))[0]
        while len(first) > MENU and re.search(r"[,:] ", first):
            first = re.sub(r"[,:] (?:(?![,:] ).)*$", "", first)
        return first


@dataclass
class Help:
    summary: str
    usage: str
    arguments: list[Entry]
    flags: list[Entry]
    commands: list[Entry]
    notes: list[str]  # paragraphs
    example: str


def parse_entries(lines: list[str]) -> list[Entry]:
    entries: list[Entry] = []
    for line in lines:
        if line.startswith(" " * COLUMN) and entries:
            entries[-1].doc = f"{entries[-1].doc} {line.strip()}".strip()
            continue
        # A description follows in the same line, or all of it is in the next ones.
        beside = len(line) > COLUMN and line[COLUMN - 1] == " "
        spec, doc = (line[:COLUMN], line[COLUMN:]) if beside else (line, "")
        parts = re.fullmatch(r"  (\S+)(?: (\S.*?))? *", spec)
        if not parts:
            raise SystemExit(f"not understood: {line!r}")
        entries.append(Entry(parts[1].split(","), parts[2] or "", doc.strip()))
    return entries


def parse(text: str) -> Help:
    paragraphs = [p for p in re.split(r"\n{2,}", text.strip("\n")) if p]
    summary, _, usage = paragraphs[0].partition("\nUsage: ")
    found = Help(summary, usage, [], [], [], [], "")
    for paragraph in paragraphs[1:]:
        title, *lines = paragraph.split("\n")
        if title == "Positionals:":
            found.arguments = parse_entries(lines)
        elif title == "Options:":
            found.flags = parse_entries(lines)
        elif title == "Commands:":
            found.commands = parse_entries(lines)
        elif title == "Example:":
            found.example = "\n".join(line.strip() for line in lines)
        else:
            found.notes.append(paragraph)
    if not (usage and found.flags and found.example):
        raise SystemExit(f"not understood: {text}")
    return found


# --- how a value is completed: a kind, and words ---

WORD = r"[a-z][a-z0-9_]*"


def words_of(doc: str) -> list[str]:
    """The words that a description enumerates: "a, b, c" or "a: what it is; b: what it is"."""
    doc = re.sub(r" ?\([^)]*\)", "", doc)
    parts = [part for part in doc.split("; ") if not part.startswith("default:")]
    named = [re.match(rf"({WORD})(?::|$)", part) for part in parts]
    if len(parts) > 1 and all(named):
        return [match[1] for match in named]
    items = parts[0].split(": ")[-1].split(", ")
    return items if len(items) > 1 and all(re.fullmatch(WORD, item) for item in items) else []


def completion(entry: Entry, command: str, helps: dict[str, Help]) -> list[str]:
    value = entry.value.removesuffix(" ...")
    if not value:
        return []
    if section := re.search(rf"brdfplot list ({WORD})", entry.doc):
        return ["listed" if "," in value else "name", section[1], *(["json"] if ".json" in value else [])]
    if other := re.search(rf"brdfplot ({WORD}) --help", entry.doc):
        there = next(e for e in helps[other[1]].flags if set(e.names) & set(entry.names))
        return completion(there, other[1], helps)
    if command == "list":  # the sections, which its description names, and every name in them
        sections = re.search(r"all of (.*?);", entry.doc)
        return ["any_name", *re.split(r", | or ", sections[1])]
    if value == "COMMAND":
        return ["command"]
    literal = value.split("|")
    if len(literal) > 1 and all(re.fullmatch(WORD, word) for word in literal):
        return ["word", *literal]
    if words := words_of(entry.doc):
        return ["word", *words]
    if len(literal) > 1 and re.fullmatch(WORD, literal[-1]):  # KIND|any: the kinds are a list below
        kinds = [re.findall(rf"^  ({WORD})  ", note, re.M) for note in helps[command].notes if note.startswith("Kinds")]
        return ["word", *kinds[0], literal[-1]]
    if "NAME=TYPE" in value:
        return ["model"]
    if ".json" in value:
        return ["json"]
    if literal == ["DIR"]:
        return ["folder"]
    if "FILE" in value or value == "TABLE":
        return ["file"]
    return ["none"]


def read_helps(brdfplot: str) -> dict[str, Help]:
    """The help of the program by "", and of each command by its name."""

    def text(*command: str) -> str:
        return subprocess.run([brdfplot, *command, "--help"], check=True, capture_output=True, text=True, encoding="utf-8").stdout

    helps = {"": parse(text())}
    helps |= {name: parse(text(name)) for entry in helps[""].commands for name in entry.names}
    for command, of in helps.items():
        for entry in of.flags + of.arguments:
            entry.complete = completion(entry, command, helps)
    return helps


# --- man pages ---


def roff(text: str) -> str:
    escapes = {"\\": r"\e", "-": r"\-", "^": r"\(ha", "~": r"\(ti", "`": r"\(ga", "'": r"\(aq"}
    return "".join(escapes.get(c, c) for c in text)


def man_entries(title: str, entries: list[Entry]) -> list[str]:
    lines = [f".SH {title}"] if entries else []
    for entry in entries:
        value = re.sub(r" ?\.\.\.$", " ...", entry.value)
        names = ", ".join(rf"\fB{roff(name)}\fR" for name in entry.names)
        lines += [".TP", f"{names} {roff(value)}".rstrip(), roff(entry.doc)]
    return lines


def man_page(command: str, of: Help, version: str, pages: list[str]) -> str:
    name = f"brdfplot-{command}" if command else "brdfplot"
    usages = [line.strip().removeprefix("brdfplot").strip().removeprefix(command).strip() for line in of.usage.splitlines()]
    synopsis = "\n.br\n".join(rf"\fB{roff(name.replace('-', ' '))}\fR {roff(usage)}" for usage in usages)
    lines = [rf'.\" {MADE}', f'.TH {roff(name.upper())} 1 "" "{version}" "brdfplot"',
             ".SH NAME", rf"{roff(name)} \- {roff(of.summary)}",
             ".SH SYNOPSIS", synopsis]
    lines += man_entries("ARGUMENTS", of.arguments) + man_entries("OPTIONS", of.flags) + man_entries("COMMANDS", of.commands)
    lines.append(".SH NOTES")
    for k, note in enumerate(of.notes):
        lines += [".PP"] * (k > 0)
        lines += [".nf", roff(note), ".fi"] if "\n " in note else [roff(note)]
    lines += [".SH EXAMPLES", ".nf", roff(of.example), ".fi", ".SH SEE ALSO", ".ad l", ".nh"]
    others = [page for page in pages if page != name]
    lines += [rf"\fB{roff(page)}\fR(1)" + "," * (page != others[-1]) for page in others]
    # A line that begins with a dot would be a request.
    return "\n".join(lines[:1] + [re.sub(r"(?m)^\.(?![A-Z]|nf|fi|ad|nh|br)", r"\&.", line) for line in lines[1:]]) + "\n"


# --- bash ---

BASH = r"""# bash completion for brdfplot. @MADE@

# The names that `brdfplot list`, with a section or without, prints.
_brdfplot_listed() {
  "$@" 2>/dev/null | sed -n 's/^  \([a-z][a-z0-9_]*\)\( .*\)\{0,1\}$/\1/p'
}

_brdfplot_flags() {
  case $1 in
@FLAGS@
  esac
}

# How the value of a flag of a command, or its argument, is completed; nothing of a flag without a value.
_brdfplot_value() {
  case $1\ $2 in
@VALUES@
  esac
}

_brdfplot() {
  local program=$1 word glued='' parts=() command='' flag='' value stem='' kind='' all=() k
  # bash takes "--over alpha=0.1:1" for five words.
  for word in "${COMP_WORDS[@]:1:COMP_CWORD}"; do
    if [[ $word == [=:] && ${#parts[@]} -gt 0 ]]; then
      parts[-1]+=$word glued=1
    elif [[ $glued ]]; then
      parts[-1]+=$word glued=''
    else
      parts+=("$word")
    fi
  done
  local current=${parts[-1]} commands=(@COMMANDS@)
  for ((k = 0; k < ${#parts[@]} - 1 && ! ${#command}; ++k)); do
    word=${parts[k]}
    if [[ " ${commands[*]} " == *" $word "* ]]; then
      command=$word
    elif [[ -n $(_brdfplot_value '' "$word") ]]; then
      ((++k)) # its value
    fi
  done
  if [[ $current == --*=* ]]; then
    flag=${current%%=*} value=${current#*=} stem=$flag=
  else
    ((${#parts[@]} > 1)) && flag=${parts[-2]}
    value=$current
  fi
  [[ $flag == -* ]] && kind=$(_brdfplot_value "$command" "$flag")
  if [[ -z $kind && $current == -* ]]; then
    all=($(_brdfplot_flags "$command"))
    kind=flags
  elif [[ -z $kind && -z $command ]]; then
    all=("${commands[@]}")
  elif [[ -z $kind ]]; then
    kind=$(_brdfplot_value "$command" argument)
  fi

  local list=${value%"${value##*,}"}
  set -- $kind
  case $1 in
  word) all=("${@:2}") ;;
  command) all=("${commands[@]}") ;;
  name) all=($(_brdfplot_listed "$program" list "$2")) ;;
  any_name) all=("${@:2}" $(_brdfplot_listed "$program" list)) ;;
  listed)
    all=($(_brdfplot_listed "$program" list "$2"))
    all=("${all[@]/#/$list}")
    compopt -o nospace
    ;;
  model)
    case $value in
    distribution=*) all=($(_brdfplot_listed "$program" list distributions)) ;;
    masking=* | shadowing=* | fresnel=*) all=($(_brdfplot_listed "$program" list "${value%%=*}")) ;;
    esac
    all=("${all[@]/#/${value%%=*}=}")
    if [[ $value != *=* ]]; then
      all=(distribution= masking= shadowing= fresnel=)
      compopt -o nospace
    fi
    ;;
  esac
  local IFS=$'\n'
  COMPREPLY=($(compgen -W "${all[*]}" -- "$value"))
  if [[ " $kind " == *\ json\ * || $kind == model ]] && ((${#COMPREPLY[@]} == 0)); then
    compopt -o filenames
    COMPREPLY=($(compgen -f -X '!*.json' -- "$value") $(compgen -d -- "$value"))
  elif [[ $kind == file ]]; then
    compopt -o filenames
    COMPREPLY=($(compgen -f -- "$value"))
  elif [[ $kind == folder ]]; then
    compopt -o filenames
    COMPREPLY=($(compgen -d -- "$value"))
  fi
  # What is put in place of the last of bash's words alone.
  COMPREPLY=("${COMPREPLY[@]/#/$stem}")
  if [[ $COMP_WORDBREAKS == *=* ]]; then
    local head=${current%"${current##*[=:]}"}
    COMPREPLY=("${COMPREPLY[@]#"$head"}")
  fi
}

complete -F _brdfplot brdfplot
"""


def flag_names(of: Help) -> list[str]:
    return [name for entry in of.flags for name in entry.names]


def bash(helps: dict[str, Help]) -> str:
    globals_ = [name for name in flag_names(helps[""]) if name not in ("-h", "--help")]
    flags, values = [], []
    for command, of in helps.items():
        own = flag_names(of) + (globals_ if command else [])
        flags.append(f"  '{command}') echo '{' '.join(own)}' ;;")
        for entry in of.flags:
            if entry.value and command:
                patterns = " | ".join(f"'{command} {name}'" for name in entry.names)
                values.append(f"  {patterns}) echo '{' '.join(entry.complete)}' ;;")
        for entry in of.arguments:
            values.append(f"  '{command} argument') echo '{' '.join(entry.complete)}' ;;")
    for entry in helps[""].flags:
        if entry.value:
            patterns = " | ".join(f"*' {name}'" for name in entry.names)
            values.append(f"  {patterns}) echo '{' '.join(entry.complete)}' ;;")
    return (BASH.replace("@MADE@", MADE).replace("@FLAGS@", "\n".join(flags)).replace("@VALUES@", "\n".join(values))
            .replace("@COMMANDS@", " ".join(name for name in helps if name)))


# --- zsh ---

ZSH = r"""#compdef brdfplot
# @MADE@

# The names that `brdfplot list`, with a section or without, prints.
_brdfplot_listed() {
  reply=(${(f)"$(_call_program names $program list $@ | sed -n 's/^  \([a-z][a-z0-9_]*\)\( .*\)\{0,1\}$/\1/p')"})
}

_brdfplot_one() {
  local -a reply
  _brdfplot_listed $1
  shift
  compadd -a reply
  (( $# )) && compadd -- $@
}

_brdfplot_list() {
  local -a reply
  _brdfplot_listed $1
  _sequence compadd - $reply
}

_brdfplot_json() {
  _files -g '*.json(-.)'
}

_brdfplot_name_or_json() {
  _alternative "names:name: _brdfplot_one $1" 'files:file:_brdfplot_json'
}

_brdfplot_model() {
  local -a reply
  if compset -P '*='; then
    case ${IPREFIX##*[[:space:]]} in
      distribution=) _brdfplot_listed distributions ;;
      *) _brdfplot_listed ${${IPREFIX##*[[:space:]]}%=} ;;
    esac
    compadd -a reply
  else
    compadd -S '' -- distribution= masking= shadowing= fresnel=
    _brdfplot_json
  fi
}

_brdfplot_commands() {
  local -a commands=(
@COMMANDS@
  )
  _describe -t commands command commands
}

_brdfplot() {
  local curcontext=$curcontext state program=$words[1] ret=1
  local -a line global=(
@GLOBAL@
  )
  _arguments -C -S $global '(-h --help)'{-h,--help}'[@HELP@]' '1:command:_brdfplot_commands' '*::argument:->argument' && ret=0
  [[ $state == argument ]] || return ret
  case $line[1] in
@CASES@
  esac
}

_brdfplot "$@"
"""


def quoted(text: str) -> str:
    return "'" + text.replace("'", r"'\''") + "'"


def zsh_action(complete: list[str]) -> str:
    # A blank in front: _arguments would put options of its own before a function's arguments.
    kind, *words = complete
    actions = {"none": " ", "file": "_files", "folder": "_files -/", "json": "_brdfplot_json", "command": "_brdfplot_commands",
               "model": "_brdfplot_model", "word": f"({' '.join(words)})"}
    if kind in actions:
        return actions[kind]
    if kind == "listed":
        return f" _brdfplot_list {words[0]}"
    if kind == "any_name":
        return f' _brdfplot_one "" {" ".join(words)}'
    return f" _brdfplot_name_or_json {words[0]}" if "json" in words else f" _brdfplot_one {words[0]}"


def zsh_spec(entry: Entry) -> str:
    message = re.match(r"[\w|.]*", entry.value)[0].strip("|.")
    value = f":{message}:{zsh_action(entry.complete)}" if entry.value else ""
    brief = entry.brief.replace("\\", r"\\").replace("[", r"\[").replace("]", r"\]").replace(":", r"\:")
    star = "*" if entry.value.endswith("...") else ""
    names = [name + ("=" if entry.value and name.startswith("--") else "+" if entry.value else "") for name in entry.names]
    if len(names) == 1:
        return quoted(f"{star}{names[0]}[{brief}]{value}")
    before = quoted(star or f"({' '.join(entry.names)})")
    return f"{before}{{{','.join(names)}}}{quoted(f'[{brief}]{value}')}"


def zsh(helps: dict[str, Help]) -> str:
    flags_of_all = [e for e in helps[""].flags if "--help" not in e.names]
    cases = []
    for command, of in helps.items():
        if not command:
            continue
        specs = [zsh_spec(entry) for entry in of.flags]
        for entry in of.arguments:
            place = "*" if entry.value.endswith("...") else "1"
            specs.append(quoted(f"{place}:{entry.names[0]}:{zsh_action(entry.complete)}"))
        cases.append(f"    {command}) _arguments -S $global \\\n      " + " \\\n      ".join(specs) + " && ret=0 ;;")
    commands = "\n".join("    " + quoted(f"{e.names[0]}:{e.doc}".replace(":", r"\:").replace(r"\:", ":", 1)) for e in helps[""].commands)
    help_ = next(e for e in helps[""].flags if "--help" in e.names)
    return (ZSH.replace("@MADE@", MADE).replace("@COMMANDS@", commands).replace("@HELP@", help_.brief)
            .replace("@GLOBAL@", "\n".join(f"    {zsh_spec(entry)}" for entry in flags_of_all))
            .replace("@CASES@", "\n".join(cases)))


# --- fish ---

FISH = r"""# fish completion for brdfplot. @MADE@

# The names that `brdfplot list`, with a section or without, prints.
function __brdfplot_listed
    brdfplot list $argv 2>/dev/null | string match -rg '^  ([a-z][a-z0-9_]*)(?: .*)?$'
end

# Names behind those that are there, with commas between.
function __brdfplot_list
    set -l before (commandline -ct | string replace -rf '^((?:--[a-z-]+=)?)(.*,)?[^,]*$' '$2')
    printf '%s\n' $before(__brdfplot_listed $argv)
end

function __brdfplot_model
    set -l key (commandline -ct | string replace -rf '^(?:--vs=)?(distribution|masking|shadowing|fresnel)=.*' '$1')
    if test -n "$key"
        printf "$key=%s\n" (__brdfplot_listed (string replace distribution distributions $key))
    else
        printf '%s\n' distribution= masking= shadowing= fresnel=
        __fish_complete_suffix .json
    end
end

complete -c brdfplot -f
"""


def fish_value(complete: list[str]) -> str:
    kind, *words = complete
    json = "(__fish_complete_suffix .json)"
    actions = {"none": "-x", "file": "-r -F", "folder": "-x -a '(__fish_complete_directories)'", "json": f"-x -a '{json}'",
               "model": "-x -a '(__brdfplot_model)'", "word": f"-x -a '{' '.join(words)}'"}
    if kind in actions:
        return actions[kind]
    if kind == "listed":
        return f"-x -a '(__brdfplot_list {words[0]})'"
    if kind == "any_name":
        return f"-x -a '{' '.join(words)} (__brdfplot_listed)'"
    return f"-x -a '(__brdfplot_listed {words[0]}){' ' + json if 'json' in words else ''}'"


def fish_flag(entry: Entry, condition: str) -> str:
    names = " ".join(f"-l {n[2:]}" if n.startswith("--") else f"-s {n[1:]}" for n in entry.names)
    value = " " + fish_value(entry.complete) if entry.value else ""
    return f"complete -c brdfplot{condition} {names}{value} -d {fish_quoted(entry.brief)}"


def fish_quoted(text: str) -> str:
    return "'" + text.replace("\\", "\\\\").replace("'", r"\'") + "'"


def fish(helps: dict[str, Help]) -> str:
    commands = [name for name in helps if name]
    lines = [fish_flag(entry, "") for entry in helps[""].flags]
    lines += [f"complete -c brdfplot -n __fish_use_subcommand -a {e.names[0]} -d {fish_quoted(e.doc)}" for e in helps[""].commands]
    for command, of in helps.items():
        if not command:
            continue
        condition = f" -n '__fish_seen_subcommand_from {command}'"
        lines += [fish_flag(entry, condition) for entry in of.flags if "--help" not in entry.names]
        for entry in of.arguments:
            if entry.complete == ["command"]:
                lines.append(f"complete -c brdfplot{condition} -a '{' '.join(commands)}'")
            elif entry.complete != ["none"]:
                lines.append(f"complete -c brdfplot{condition} {fish_value(entry.complete).removeprefix('-x ').removeprefix('-r ')}")
    return FISH.replace("@MADE@", MADE) + "\n".join(lines) + "\n"


def main(brdfplot: str, folder: Path) -> None:
    helps = read_helps(brdfplot)
    version = subprocess.run([brdfplot, "--version"], check=True, capture_output=True, text=True).stdout.strip()
    pages = {command: f"brdfplot-{command}" if command else "brdfplot" for command in helps}
    man = {f"{page}.1.gz": gzip.compress(man_page(command, helps[command], version, list(pages.values())).encode(), 9, mtime=0)
           for command, page in pages.items()}
    completions = {"brdfplot.bash": bash(helps).encode(), "_brdfplot": zsh(helps).encode(), "brdfplot.fish": fish(helps).encode()}
    kinds = helps["schema"].arguments[0].complete[1:]
    schemas = {f"{kind}.json": subprocess.run([brdfplot, "schema", kind], check=True, capture_output=True).stdout for kind in kinds}
    for made, files in (("man", man), ("completions", completions), ("schemas", schemas)):
        (folder / made).mkdir(parents=True, exist_ok=True)
        for old in (folder / made).iterdir():
            old.unlink()  # of a command that is no more
        for name, content in files.items():
            (folder / made / name).write_bytes(content)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], Path(sys.argv[2]))
