#!/usr/bin/env python3
"""The table of equations: where an equation of a text is in brdfplot, made of the sources that the models name.

    equations.py BRDFPLOT docs/equations.md           compares: exit code 1 where the page is not what it should be
    equations.py --write BRDFPLOT docs/equations.md   writes the page

Every number of a text has a line: what names it as its source, or what equations_stated.py says of it. A number that
neither has, or both, is an error.
"""

import re
import subprocess
import sys
from pathlib import Path

from equations_stated import STATED, TEXTS

HEAD = """# Where equations are

Every numbered equation of three texts: what `brdfplot list` names as source, and of the others what they are. A
definition, a step on the way or another way to write what stands elsewhere has no key of its own. `ninja equations`
writes this page; a test compares it, and fails where a number is missing.
"""
# A group of `brdfplot list`, and how what is in it is asked for.
GROUPS = {"distributions": "distribution", "masking": "masking", "shadowing": "shadowing", "fresnel": "fresnel",
          "terms": "term", "quantities": "quantity", "properties": "property", "measures": "measure"}
# What tells of itself in a line, with its source at the end, and of quantities with Heitz's number in the text.
IN_A_LINE = ("quantity", "property", "measure")
# What equations_stated.py may name besides: variables of figures, and a source of simulated series.
NOT_LISTED = {"a", "theta_h", "smith_walk"}


def lines_of(listing):
    """[(key, [lines])] of a group: its heading is not indented, a key is by two."""
    found = []
    for line in listing.splitlines()[1:]:
        name = re.match(r"  (\S+)(.*)", line)
        if name:
            found.append((name[1], [name[2].strip()]))
        elif line.strip():
            found[-1][1].append(line)
    return found


def parts_of(lines):
    """The doc, the source, and [(key, doc)] of the parameters of a model."""
    doc, source, parameters, into = [], [], [], None
    for line in lines[1:]:
        parameter = re.match(r" {6}(\w+)  +(\S.*)", line)
        text = line.strip()
        if source and source[-1].endswith("]") and parameter:
            parameters.append((parameter[1], [parameter[2]]))
            into = parameters[-1][1]
        elif source and source[-1].endswith("]"):
            if line.startswith(" " * 7) and into is not None:
                into.append(text)
        elif source or text.startswith("["):
            source.append(text)
        else:
            doc.append(text)
    return " ".join(doc), " ".join(source), [(key, " ".join(words)) for key, words in parameters]


def equations(source):
    """The equations that a source names of each text: [(text, label, first, last)]."""
    for part in re.split(r"[;\[\]()]", source):
        for text, (aliases, _, _) in TEXTS.items():
            if not part.strip().startswith(aliases):
                continue
            for numbers in re.findall(r"Eqs?\. ([0-9][0-9., -]*)", part):
                for first, last in re.findall(r"([0-9]+(?:\.[0-9]+)?)(?:-([0-9]+(?:\.[0-9]+)?))?", numbers):
                    yield text, first, last or first


def number(label):
    return int(label.split(".")[-1])


def shortened(doc):
    doc = re.sub(r" \([^()]*Eqs?\. [^()]*\)", "", doc)
    doc = re.sub(r"[;,]? (needs omega|takes |Eqs?\. ).*", "", re.sub(r"\[.*?\]", "", doc)).strip(" ;,")
    return (doc.split(":")[0] if len(doc) > 120 else doc).replace("|", "\\|")


class Page:
    """Lines of each text, and which of its numbers have one."""

    def __init__(self):
        self.rows = {text: {} for text in TEXTS}
        self.named = {text: set() for text in TEXTS}
        self.keys = set()

    def add(self, source, what, kind, key):
        self.keys.add(key)
        for text, first, last in equations(source):
            self.rows[text].setdefault((number(first), number(last), first, what, kind), []).append(key)
            self.named[text] |= set(range(number(first), number(last) + 1))

    def read(self, kind, listing):
        for key, lines in lines_of(listing):
            self.keys.add(key)
            if kind in IN_A_LINE:
                text = " ".join(line.strip() for line in lines)
                own = "; ".join(f"Heitz 2014, {e}" for e in re.findall(r"Eqs?\. [0-9][0-9, -]*", text))
                source = re.search(r"\[([^\]]*[0-9]{4}[^\]]*)\]", text)
                self.add(source[1] if source else own if kind == "quantity" else "", shortened(text), kind, key)
                continue
            doc, source, parameters = parts_of(lines)
            self.add(source, shortened(doc), kind, key)
            for parameter, about in parameters:
                self.add(about, shortened(re.sub(r" \([^()]*[0-9]{4}[^()]*\).*|;.*", "", about)), f"parameter `{parameter}` of {kind}", key)

    def faults(self):
        """What is missing, said twice, or said of what there is not."""
        for text, (_, heading, numbers) in TEXTS.items():
            stated = [n for first, last, _, _ in STATED[text] for n in range(first, last + 1)]
            for n in numbers:
                lines = (n in self.named[text]) + stated.count(n)
                if lines == 0:
                    yield f"{heading}: no model names equation {n}, and equations_stated.py says nothing of it"
                elif lines > 1:
                    yield f"{heading}: equation {n} has a model or a line already: leave it out of equations_stated.py"
            for _, _, _, where in STATED[text]:
                for name in re.findall(r"`(\w+)`", where):
                    if name not in self.keys | NOT_LISTED:
                        yield f"{heading}: equations_stated.py names `{name}`, which brdfplot list has not"

    def text(self):
        lines = [HEAD]
        for text, (_, heading, _) in TEXTS.items():
            prefix = "9." if text.startswith("Akenine") else ""
            lines += [f"## {heading}\n", "| equation | what it is | where |", "| --- | --- | --- |"]
            rows = [(first, last, what, f"{kind} " + ", ".join(f"`{k}`" for k in keys))
                    for (first, last, _, what, kind), keys in self.rows[text].items()]
            rows += STATED[text]
            for first, last, what, where in sorted(rows):
                label = f"{prefix}{first}" + (f"–{prefix}{last}" if last > first else "")
                lines.append(f"| {label} | {what} | {where} |")
            lines.append("")
        return "\n".join(lines)


def main():
    write = sys.argv[1:2] == ["--write"]
    binary, path = sys.argv[-2:]
    page = Page()
    for group, kind in GROUPS.items():
        page.read(kind, subprocess.run([binary, "list", group], capture_output=True, text=True, check=True).stdout)
    faults = list(page.faults())
    if faults:
        sys.exit("\n".join(faults))
    if write:
        Path(path).write_text(page.text(), encoding="utf-8")
    elif Path(path).read_text(encoding="utf-8") != page.text():
        sys.exit(f"{path} is not what `brdfplot list` says: ninja equations")


if __name__ == "__main__":
    main()
