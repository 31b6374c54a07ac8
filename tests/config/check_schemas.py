"""The published JSON Schemas accept what the reader accepts and refuse what it refuses.

    check_schemas.py BINARY CONFIGS    runs `BINARY schema KIND` and `BINARY validate FILE`
    check_schemas.py --write CONFIGS   gives a "$schema" to the files that have none

Every file in CONFIGS, and every document below, is put both to the schema (python3-jsonschema, draft 2020-12) and to
the reader. Faults that a schema cannot express are tested with the reader. Every file in CONFIGS names its schema by
"$schema", where an installation has it.
"""

import copy
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import jsonschema

MATERIAL = {"distribution": {"type": "ggx", "alpha": 0.5}}
FIGURE = {
    "id": "f",
    "kind": "lines",
    "title": "T",
    "caption": "C",
    "material": MATERIAL,
    "x": {"variable": "theta_m", "from": 0, "to": "60deg"},
    "panels": [{"series": [{"quantity": "d"}]}],
}
TABLE = {
    "id": "t",
    "title": "T",
    "caption": "C",
    "maskings": ["smith"],
    "distributions": ["ggx"],
    "alpha": [0.5],
    "theta_o": ["45deg", 1],
}
REPORT = {"title": "T", "entries": [{"section": "s", "table": TABLE}]}
SCENE = {
    "surface": {"type": "gaussian", "alpha": 0.5, "samples": 64, "correlation_length": 4},
    "measures": [{"type": "g2", "theta_o": ["60deg", 1], "delta_phi": "20deg"}],
}
ADVICE = {
    "materials": [{"material": MATERIAL, "ranges": {"alpha": [0.2, 0.3]}}],
    "lights": [{"theta": "45deg", "irradiance": 1}],
    "tolerance": {"delta_e": 2},
}
BASES = {"material": MATERIAL, "figure": FIGURE, "report": REPORT, "scene": SCENE, "advice": ADVICE}
PROFILE = {
    "id": "f",
    "kind": "profile",
    "title": "T",
    "caption": "C",
    "profile": {"surface": {"type": "gaussian", "alpha": 0.5, "samples": 64, "correlation_length": 4}, "omega_o": "60deg"},
    "panels": [{"profile": {"rays": 3}}],
}
SPHERES = {
    "id": "f",
    "kind": "spheres",
    "title": "T",
    "caption": "C",
    "material": MATERIAL,
    "sphere": {"lights": [{"type": "environment", "radiance": 0.5},
                          {"type": "directional", "theta": "50deg", "phi": 2, "irradiance": [1, 2, 3]}], "exposure": 0.5},
    "panels": [{"sphere": {}, "for_each": {"variable": "alpha", "values": [0.1, 1]}},
               {"sphere": {"pixels": 64, "lights": [{"type": "sphere", "theta": 0, "radius": "10deg", "radiance": 1}]}}],
}
GONE = object()

# Kind, where, what is put there (GONE: taken away).
GOOD = [
    *((kind, "/$schema", "https://example.org/material.json") for kind in BASES),
    ("material", "/name", "α"),
    ("material", "/facet", "specular"),
    ("material", "/facet", "diffuse"),
    ("material", "", {"terms": [{"type": "lambert"}]}),
    ("material", "", {"terms": [
        {"type": "fresnel_lambert", "albedo": [0.1, 0.2, 0.3], "f0": 0.04, "at": "half"}, {"type": "shirley"},
        {"type": "disney_diffuse", "roughness": 0.5, "subsurface": 0.5, "printed": True}, {"type": "disney_sheen", "color": [1, 0.5, 0]},
        {"type": "hammon_diffuse", "alpha": 0.5, "f0": [0.04, 0.05, 0.06]}, {"type": "eon", "roughness": 1},
        {"type": "fujii_oren_nayar", "roughness": 0}, {"type": "velvet_cloth", "alpha": 0.5, "amplitude": 2},
        {"type": "uncharted2", "rim": 1, "rim_power": 2, "inner": 1, "inner_power": 2, "diffuse": 1}]}),
    ("material", "", {"name": "m", "terms": [{"type": "lambert", "weight": [1, 0.5, 0], "albedo": [0.1, 1, 0]},
                                             {"type": "mirror", "name": "coat", "weight": 2, **MATERIAL}]}),
    ("material", "", {"terms": [{"type": "facet_diffuse", "albedo": 0.5, **MATERIAL}, {"type": "oren_nayar", "sigma": 0.5}]}),
    ("material", "/distribution", {"type": "beckmann", "alpha_x": 1, "alpha_y": 2, "correlation": -0.5, "mean_slope": [0, 1]}),
    ("material", "/distribution", {"type": "phong", "exponent": 0}),
    ("material", "/distribution", {"type": "phong", "gloss": 1}),
    ("material", "/distribution", {"type": "gtr", "alpha": 0.1, "gamma": 2}),
    ("material", "/masking", {"type": "v_cavity"}),
    ("material", "/shadowing", {"type": "direction_correlated", "lambda": "ginneken"}),
    ("material", "/shadowing", {"type": "height_direction_correlated", "lambda": "fitted"}),
    ("material", "/fresnel", {"type": "conductor", "eta": [0.1, 0.4, 1.4], "k": 2}),
    ("material", "/fresnel", {"type": "f82", "f0": [0.9, 0.5, 0], "f82": [0.9, 0.8, 1]}),
    ("material", "/masking", {"type": "karis"}),
    ("material", "/shadowing", {"type": "hammon"}),
    ("material", "/shadowing", {"type": "neubelt"}),
    ("figure", "/panels/0/title", "T"),
    ("figure", "/x/from", "-90deg"),
    ("figure", "/x/from", " -.5e-1 rad "),
    ("figure", "/x/samples", 12.0),
    ("figure", "/columns", 8),
    ("figure", "/id", "fig04_a-b.c"),
    ("figure", "/at", {"theta_o": "60deg", "phi_o": 1, "masking": "v_cavity"}),
    ("figure", "/materials", {"any name": MATERIAL}),
    ("figure", "/panels/0/series/0", {"absolute": {"difference": [{"quantity": "d"}, {"quantity": "d_cos"}]}}),
    ("figure", "/panels/0/for_each", {"variable": "alpha", "values": [0.1, 1], "labels": ["a", "b"]}),
    ("figure", "/panels/0/for_each", [{"variable": "distribution", "values": ["ggx"]}]),
    ("figure", "", PROFILE),
    ("figure", "", SPHERES),
    ("figure", "/profile", {"seed": 3, "cells": 12}),
    ("report", "/introduction", "I"),
    ("report", "/entries/0/table/tolerance", 1e-3),
    ("advice", "/name", "S"),
    ("advice", "/lights/0", {"theta": 1, "phi": "30deg", "radius": "5deg", "irradiance": [1, 2, 3]}),
    ("advice", "/view", {"theta_o": [0, "30deg", "60deg"], "shares": [1, 2]}),
    ("advice", "/exposure", 2),
    ("advice", "/tolerance", {"relative": 0.1}),
    ("advice", "/budget", 100),
    ("advice", "/target", "shader"),
    ("advice", "/target", "float_simd"),
    ("scene", "/name", "S"),
    ("scene", "/seed", 0),
    ("scene", "/realisations", 3),
    ("scene", "/surface/autocorrelation", "exponential"),
    ("scene", "/surface", {"type": "v_cavity", "alpha": 1, "pairs": 16}),
    ("scene", "/measures/0/rays", 1e7),
    ("scene", "/measures/0", {"type": "lobe", "id": "fig11", "theta_o": 1.5, "bins": 60, "bounces": 4}),
]

BAD = [
    # Spheres: one or more lights, each with what its type takes
    ("figure", "/sphere", {"lights": []}),
    ("figure", "/sphere", {"lights": [{"type": "spot", "radiance": 1}]}),
    ("figure", "/sphere", {"lights": [{"type": "environment", "radiance": -1}]}),
    ("figure", "/sphere", {"lights": [{"type": "environment", "radiance": [1, 1]}]}),
    ("figure", "/sphere", {"lights": [{"type": "directional", "theta": 1, "radiance": 1}]}),
    ("figure", "/sphere", {"lights": [{"type": "sphere", "theta": 1, "radiance": 1}]}),
    ("figure", "/sphere", {"pixels": 4096}),
    ("figure", "/sphere", {"exposure": 0}),
    ("figure", "/panels/0/sphere", {}),
    # Terms: one or more, each with what its type takes
    ("material", "", {"terms": []}),
    ("material", "", {"terms": [{"type": "lambert"}], **MATERIAL}),
    ("material", "", {"terms": [{"type": "lambert", **MATERIAL}]}),
    ("material", "", {"terms": [{"type": "mirror"}]}),
    ("material", "", {"terms": [{"type": "miror", **MATERIAL}]}),
    ("material", "", {"terms": [{"type": "lambert", "albedo": 1.5}]}),
    ("material", "", {"terms": [{"type": "fresnel_lambert", "at": "facet"}]}),
    ("material", "", {"terms": [{"type": "disney_diffuse", "alpha": 0.5, "roughness": 0.5}]}),
    ("material", "", {"terms": [{"type": "disney_diffuse"}]}),
    ("material", "", {"terms": [{"type": "disney_diffuse", "alpha": 0.5, "printed": 1}]}),
    ("material", "", {"terms": [{"type": "disney_diffuse", "alpha": 0.5, "printed": "true"}]}),
    ("material", "", {"terms": [{"type": "disney_diffuse", "alpha": True}]}),
    ("material", "", {"terms": [{"type": "velvet_cloth", "alpha": 2}]}),
    ("material", "/fresnel", {"type": "f82", "f0": 0.9}),
    ("material", "/fresnel", {"type": "f82", "f0": 0.9, "f82": 1.5}),
    ("material", "", {"terms": [{"type": "eon", "roughness": 1.5}]}),
    ("material", "", {"terms": [{"type": "lambert", "weight": -1}]}),
    ("material", "", {"terms": [{"type": "lambert", "weight": [1, 1]}]}),
    ("material", "", {"terms": [{"type": "facet_diffuse", **MATERIAL, "fresnel": {"type": "none"}}]}),
    ("material", "", {"terms": [{"type": "oren_nayar"}]}),
    # Unknown and missing keys
    ("material", "/colour", 1),
    ("material", "/distribution/alhpa", 1),
    ("material", "/distribution/$schema", "x"),
    ("material", "/distribution", GONE),
    ("material", "/distribution/type", GONE),
    ("material", "/shadowing", {"type": "direction_correlated"}),
    ("material", "/fresnel", {"type": "schlick"}),
    ("figure", "/colums", 2),
    ("figure", "/id", GONE),
    ("figure", "/panels", GONE),
    ("figure", "/panels/0/series/0/label_", "x"),
    ("advice", "/materials", []),
    ("advice", "/materials/0/material", GONE),
    ("advice", "/materials/0/ranges", {"alpha": []}),
    ("advice", "/lights", GONE),
    ("advice", "/lights/0/theta", GONE),
    ("advice", "/lights/0/irradiance", -1),
    ("advice", "/lights/0/type", "directional"),
    ("advice", "/tolerance", {}),
    ("advice", "/tolerance", {"delta_e": 1, "relative": 1}),
    ("advice", "/tolerance/delta_e", 0),
    ("advice", "/view", {"theta_o": [1]}),
    ("advice", "/budget", 0),
    ("advice", "/target", "gpu"),
    ("scene", "/surface", GONE),
    ("scene", "/measures", GONE),
    ("scene", "/measures/0/theta_o", GONE),
    ("scene", "/measures/0/delta_phi", GONE),
    ("scene", "/measures/0/bins", 10),
    ("scene", "/surface/pairs", 16),
    ("scene", "/surface/type", "gausian"),
    ("scene", "/measures/0/type", "g3"),
    ("scene", "/measures/0/theta_o", []),
    ("scene", "/measures/0/id", "../x"),
    ("scene", "/seed", -1),
    ("scene", "/realisations", 0),
    ("scene", "/measures/0/rays", 0),
    ("scene", "/surface/alpha", 0),
    ("report", "/title", GONE),
    ("report", "/entries/0/section", GONE),
    ("report", "/entries/0/table/alpha", GONE),
    # Types
    *((kind, "/$schema", 1) for kind in BASES),
    ("material", "", []),
    ("material", "", 3),
    ("material", "/name", 1),
    ("material", "/distribution", "ggx"),
    ("material", "/distribution/type", 1),
    ("material", "/distribution/alpha", "0.5"),
    ("material", "/distribution/alpha", None),
    ("material", "/distribution/alpha", True),
    ("material", "/distribution/mean_slope", [1]),
    ("material", "/distribution/mean_slope", [1, "2"]),
    ("material", "/fresnel", {"type": "schlick", "f0": [0.1, 0.2]}),
    ("figure", "/columns", 1.5),
    ("figure", "/panels", {}),
    ("figure", "/panels", []),
    ("figure", "/panels/0/series", []),
    ("figure", "/panels/0/series/0/quantity", 1),
    ("figure", "/panels/0/for_each", {"variable": "alpha", "values": []}),
    ("figure", "/panels/0/for_each", {"variable": "alpha", "values": [[1]]}),
    ("figure", "/at", {"theta_o": [1]}),
    ("figure", "/x/from", "60"),
    ("figure", "/x/from", "1.2.3deg"),
    ("figure", "/x/from", "sixty deg"),
    ("figure", "/material", 3),
    ("report", "/entries", []),
    ("report", "/entries/0", "figure.json"),
    # Names
    ("material", "/distribution/type", "gxx"),
    ("material", "/facet", "difuse"),
    ("material", "/masking", {"type": "smiht"}),
    ("material", "/shadowing", {"type": "direction_correlated", "lambda": "heitz2013"}),
    ("figure", "/kind", "pie"),
    ("figure", "/id", "../x"),
    ("figure", "/id", ""),
    ("figure", "/id", "a/b"),
    ("figure", "/id", ".hidden"),
    ("figure", "/x/unit", "degree"),
    ("report", "/entries/0/table/id", "../x"),
    ("report", "/entries/0/table/maskings", ["smiht"]),
    # Bounds
    ("material", "/distribution/alpha", 0),
    ("material", "/distribution/alpha", -1),
    ("material", "/distribution/correlation", 1),
    ("material", "/distribution", {"type": "phong", "exponent": -1}),
    ("material", "/fresnel", {"type": "dielectric", "eta": 0}),
    ("material", "/fresnel", {"type": "dielectric", "eta": [1.5, 1.5, 0]}),
    ("material", "/fresnel", {"type": "schlick", "f0": 1.1}),
    ("figure", "/columns", 0),
    ("figure", "/tolerance", 0),
    ("figure", "/cells", 1),
    ("figure", "/x/samples", 1),
    ("report", "/entries/0/table/alpha", [0]),
    # Alternatives
    ("material", "/distribution/alpha", GONE),
    ("material", "/distribution/alpha_x", 1),
    ("material", "/distribution", {"type": "ggx", "alpha_x": 1}),
    ("material", "/distribution", {"type": "ggx", "alpha": 1, "alpha_x": 1, "alpha_y": 1}),
    ("material", "/distribution", {"type": "phong", "exponent": 1, "alpha": 1}),
    ("material", "/distribution", {"type": "phong", "exponent": 1, "gloss": 1}),
    ("material", "/distribution", {"type": "phong", "gloss": 1.5}),
    ("figure", "/panels/0/series/0", {}),
    ("figure", "/panels/0/series", GONE),
    ("figure", "/panels/0/profile", {}),
    ("figure", "", {**PROFILE, "profile": {"surface": {"type": "height_map", "file": "a.png", "height": 1}}}),
    ("figure", "", {**PROFILE, "panels": [{"profile": {"ray": 3}}]}),
    ("figure", "", {**PROFILE, "panels": [{"profile": {"stretch": 0}}]}),
    ("figure", "", {**PROFILE, "panels": [{"profile": {"arrows": ["mirror"]}}]}),
    ("figure", "/panels/0/series/0/absolute", {"quantity": "d"}),
    ("figure", "/panels/0/series/0", {"ratio": [{"quantity": "d"}]}),
    ("report", "/entries/0/figure", "f.json"),
    # References that are none
    ("material", "/distribution", {"$ref": 1}),
    ("material", "/distribution", {"$ref": "#distribution"}),
    ("material", "/name", {"$ref": "other.json", "extra": 1}),
]

# A reference may stand for any value: in objects, in arrays and in maps.
REFERENCES = [
    ("material", "/distribution", MATERIAL["distribution"]),
    ("material", "/distribution/alpha", 0.5),
    ("material", "/distribution/mean_slope", [0, 0]),
    ("figure", "/panels", FIGURE["panels"]),
    ("figure", "/panels/0", FIGURE["panels"][0]),
    ("figure", "/panels/0/series/0", {"quantity": "d"}),
    ("figure", "/x/from", 0),
    ("figure", "/materials", {"one": MATERIAL}),
    ("figure", "/materials/one", MATERIAL),
    ("figure", "/at/theta_o", 1),
    ("report", "/entries/0", REPORT["entries"][0]),
    ("report", "/entries/0/table", TABLE),
    ("report", "/entries/0/table/theta_o/1", 1),
]


def changed(document, pointer, value):
    """A copy of a document with one value replaced; objects on the way are made."""
    if not pointer:
        return copy.deepcopy(value)
    out = copy.deepcopy(document)
    *steps, last = pointer.split("/")[1:]
    at = out
    for step in steps:
        at = at[int(step)] if isinstance(at, list) else at.setdefault(step, {})
    last = int(last) if isinstance(at, list) else last
    if value is GONE:
        del at[last]
    else:
        at[last] = copy.deepcopy(value)
    return out


class Checker:
    def __init__(self, binary: Path, folder: Path):
        self.binary = binary
        self.folder = folder
        self.faults = []
        self.validators = {}
        for kind in BASES:
            text = subprocess.run([binary, "schema", kind], check=True, capture_output=True, text=True).stdout
            schema = json.loads(text)
            jsonschema.Draft202012Validator.check_schema(schema)
            if schema.get("$id") != f"https://brdfplot.example/schemas/{kind}.json":
                self.faults.append(f"the schema of {kind} is called {schema.get('$id')}")
            self.validators[kind] = jsonschema.Draft202012Validator(schema)

    def reader_accepts(self, path: Path) -> bool:
        run = subprocess.run([self.binary, "validate", path], capture_output=True, text=True)
        if run.returncode not in (0, 2) or run.stderr.count("\n") > 1:
            self.faults.append(f"{path}: exit code {run.returncode}: {run.stderr}")
        return run.returncode == 0

    def check(self, name: str, kind: str, document, expected: bool, path: Path | None = None):
        if path is None:
            path = self.folder / "document.json"
            path.write_text(json.dumps(document), encoding="utf-8")
        for who, accepts in [("schema", self.validators[kind].is_valid(document)), ("reader", self.reader_accepts(path))]:
            if accepts != expected:
                self.faults.append(f"{name}: the {who} {'accepts' if accepts else 'refuses'} it")


def without_description(part, place: str = "") -> list[str]:
    """The models of a schema that say nothing of themselves: a "type" that is one word, without a description."""
    if isinstance(part, list):
        return [found for k, item in enumerate(part) for found in without_description(item, f"{place}/{k}")]
    if not isinstance(part, dict):
        return []
    found = [name for key, item in part.items() for name in without_description(item, f"{place}/{key}")]
    properties = part.get("properties")
    kind = properties.get("type") if isinstance(properties, dict) else None
    if isinstance(kind, dict) and "const" in kind and not (kind.get("description") and part.get("description")):
        found.append(f"{place}: {kind['const']}")
    return found


def files_of(kind: str, configs: Path) -> list[Path]:
    """Scenes are of two kinds: of those with materials and lights `advise` answers."""
    folder = "scenes" if kind == "advice" else f"{kind}s"
    files = sorted((configs / folder).glob("*.json"))
    if folder != "scenes":
        return files
    return [file for file in files if ("materials" in json.loads(file.read_text(encoding="utf-8"))) == (kind == "advice")]


def schema_beside(kind: str) -> str:
    return f"../schemas/{kind}.json"


def write(configs: Path) -> int:
    for kind in BASES:
        for file in files_of(kind, configs):
            text = file.read_text(encoding="utf-8")
            if "$schema" not in json.loads(text):
                space, rest = re.fullmatch(r"\s*{(\s*)(.*)", text, re.S).groups()
                file.write_text(f'{{{space}"$schema": "{schema_beside(kind)}",{space or " "}{rest}', encoding="utf-8")
    return 0


def main(binary: Path, configs: Path) -> int:
    with tempfile.TemporaryDirectory() as folder:
        checker = Checker(binary, Path(folder))
        count = 0
        for kind in BASES:
            files = files_of(kind, configs)
            if not files:
                checker.faults.append(f"no {kind} in {configs}")
            for file in files:
                document = json.loads(file.read_text(encoding="utf-8"))
                if document.get("$schema") != schema_beside(kind):
                    checker.faults.append(f"{file}: its \"$schema\" is not {schema_beside(kind)}; check_schemas.py --write adds it")
                checker.check(str(file), kind, document, True, file)
                count += 1
        for kind, document in BASES.items():
            checker.check(kind, kind, document, True)
            checker.faults += [f"schema {kind}{name} has no description" for name in without_description(checker.validators[kind].schema)]
        for cases, expected in [(GOOD, True), (BAD, False)]:
            for kind, pointer, value in cases:
                shown = "gone" if value is GONE else json.dumps(value)
                checker.check(f"{kind} {pointer} = {shown}", kind, changed(BASES[kind], pointer, value), expected)
                count += 1
        for kind, pointer, value in REFERENCES:
            (Path(folder) / "other.json").write_text(json.dumps({"value": value}), encoding="utf-8")
            document = changed(changed(BASES[kind], pointer, value), pointer, {"$ref": "other.json#/value"})
            checker.check(f"reference at {kind} {pointer}", kind, document, True)
            count += 1
    for fault in checker.faults:
        print(fault)
    print(f"{count} documents, {len(checker.faults)} faults")
    return 1 if checker.faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(write(Path(sys.argv[2])) if sys.argv[1] == "--write" else main(Path(sys.argv[1]), Path(sys.argv[2])))
