"""The arrows of the architecture point one way: fails on any #include that points the other way, and on a folder of src
with more files than one finds one's way in.

    check_includes.py ROOT         checks ROOT/src and ROOT/cli
    check_includes.py --self-test  checks the checker on trees with a known fault each
"""

import re
import sys
import tempfile
from pathlib import Path

# A file may include from its own layer and from those before it. What draws knows no BRDF: only base.
LAYERS = ["base", "math", "models", "microfacet", "integrate", "brdf", "sampling", "analysis", "bake", "stream", "simulation", "choice", "draw",
          "figure", "config", "cli"]
MOST_FILES = 22
# The number type of exact values, which only the sources of problems include.
HEAVY_HEADERS = {"src/choice/methods/exact.hpp"}
KNOWS_ONLY = {"draw": {"base", "draw"}}
GENERATED = {"version.hpp", "config_directories.hpp"}
# A third-party header: who may include it. None stands for every source file, but no header.
THIRD_PARTY = {"CLI": {"cli"}, "nlohmann": {"config"}, "Eigen": None, "boost": None, "muParser.h": None,
               "embree3": None, "embree4": None, "tbb": None, "fftw3.h": None, "png.h": None, "mpi.h": {"cli"}}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]')


def layer_of(path: Path, root: Path) -> str:
    parts = path.relative_to(root).parts
    return parts[1] if parts[0] == "src" and len(parts) > 2 else parts[0]


def resolve(name: str, source: Path, root: Path) -> Path | None:
    candidates = [source.parent / name, root / "src" / name, root / "cli" / name]
    return next((c.resolve() for c in candidates if c.is_file()), None)


def check_include(name: str, quoted: bool, source: Path, root: Path) -> str | None:
    """What is wrong with this include, or nothing."""
    layer = layer_of(source, root)
    package = name.split("/")[0]
    if package in THIRD_PARTY:
        layers = THIRD_PARTY[package]
        if layers is None:
            is_heavy = source.relative_to(root).as_posix() in HEAVY_HEADERS
            return f"a header includes <{name}>; only .cpp files may" if source.suffix == ".hpp" and not is_heavy else None
        return None if layer in layers else f"{layer} includes <{name}>; only {', '.join(sorted(layers))} may"
    if name in GENERATED:
        return None
    target = resolve(name, source, root)
    if target is None:
        return f'"{name}" is no file of src or cli' if quoted else None
    if not quoted:
        return f"own header included as <{name}>"
    target_layer = layer_of(target, root)
    if LAYERS.index(target_layer) > LAYERS.index(layer):
        return f'{layer} includes "{name}", but {target_layer} stands above it'
    if target_layer not in KNOWS_ONLY.get(layer, LAYERS):
        return f'{layer} includes "{name}"; it may only include from {", ".join(sorted(KNOWS_ONLY[layer]))}'
    return None


def check(root: Path) -> list[str]:
    root = root.resolve()
    faults = []
    for source in sorted(p for top in ("src", "cli") for p in (root / top).rglob("*") if p.suffix in {".hpp", ".cpp"}):
        where = source.relative_to(root)
        if layer_of(source, root) not in LAYERS:
            faults.append(f"{where}: its folder has no place in the order {' <- '.join(LAYERS)}")
            continue
        for number, line in enumerate(source.read_text(encoding="utf-8").splitlines(), 1):
            if match := INCLUDE.match(line):
                if fault := check_include(match[2], match[1] == '"', source, root):
                    faults.append(f"{where}:{number}: {fault}")
    for folder in sorted(p for p in (root / "src").rglob("*") if p.is_dir()):
        files = sum(p.is_file() for p in folder.iterdir())
        if files > MOST_FILES:
            faults.append(f"{folder.relative_to(root)}: {files} files; at most {MOST_FILES}")
    return faults


def self_test() -> None:
    good = {
        "src/math/a.hpp": "#include <vector>\n",
        "src/math/a.cpp": '#include "math/a.hpp"\n#include <boost/math/quadrature/gauss.hpp>\n',
        "src/brdf/b.hpp": '#include "math/a.hpp"\n#include "brdf/c.hpp"\n#include "version.hpp"\n',
        "src/brdf/c.hpp": "// #include <Eigen/Core>\n",
        "src/config/d.cpp": "#include <nlohmann/json.hpp>\n",
        "cli/main.cpp": '#include "command.hpp"\n#include "config/e.hpp"\n#include <CLI/CLI.hpp>\n',
        "cli/command.hpp": "",
        "src/config/e.hpp": "",
    }
    bad = {
        "upwards": ("src/math/a.hpp", '#include "brdf/b.hpp"\n'),
        "library from cli": ("src/config/e.hpp", '#include "command.hpp"\n'),
        "CLI11 in the library": ("src/config/e.cpp", "#include <CLI/CLI.hpp>\n"),
        "JSON outside config": ("src/figure/p.cpp", "# include <nlohmann/json.hpp>\n"),
        "JSON in cli": ("cli/main.cpp", "#include <nlohmann/json.hpp>\n"),
        "Eigen in a header": ("src/math/a.hpp", "#include <Eigen/Core>\n"),
        "Boost in a header": ("src/config/e.hpp", "#include <boost/version.hpp>\n"),
        "unknown layer": ("src/extra/x.hpp", ""),
        "drawing that knows a BRDF": ("src/draw/svg.cpp", '#include "brdf/c.hpp"\n'),
        "missing file": ("src/math/a.hpp", '#include "math/gone.hpp"\n'),
        "own header in angle brackets": ("src/brdf/c.hpp", "#include <math/a.hpp>\n"),
    }
    crowd = {f"src/crowd/{k}.txt": "" for k in range(MOST_FILES + 1)}
    trees = {"nothing": {}, "a crowd": crowd} | {name: {path: text} for name, (path, text) in bad.items()}
    for name, tree in trees.items():
        with tempfile.TemporaryDirectory() as folder:
            for file, content in {**good, **tree}.items():
                (Path(folder) / file).parent.mkdir(parents=True, exist_ok=True)
                (Path(folder) / file).write_text(content, encoding="utf-8")
            faults = check(Path(folder))
            expected = 0 if name == "nothing" else 1
            if len(faults) != expected:
                sys.exit(f"self-test '{name}': expected {expected} fault, found {faults}")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) == 2:
        found = check(Path(sys.argv[1]))
        for fault in found:
            print(fault)
        sys.exit(bool(found))
    else:
        sys.exit(__doc__)
