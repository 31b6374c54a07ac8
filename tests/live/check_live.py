"""Opens the live page in headless Chromium, from file://, and holds it to the program: values within 1e-12 of the CLI's,
its errors word by word, no request and no message of the console, and closed forms redrawn within 50 ms.

    check_live.py PAGE.html BRDFPLOT CONFIGS
"""

import csv
import io
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "report"))
from check_page import Browser, Visit  # noqa: E402

TOLERANCE = 1e-12  # relative, of closed forms
INTEGRAL = 1e-9  # what both are asked for
REDRAW = 50  # milliseconds
QUANTITIES = {"lambda": "o", "d": "m", "g1": "om", "g2": "oi", "d_visible": "om", "brdf": "oi", "brdf_cos": "oi"}
INLINE = {
    "anisotropic": {"distribution": {"type": "ggx", "alpha_x": 0.2, "alpha_y": 0.6, "correlation": 0.4}},
    "dielectric": {"distribution": {"type": "beckmann", "alpha": 0.3}, "fresnel": {"type": "dielectric", "eta": 1.5}},
    "separable": {"distribution": {"type": "ggx", "alpha": 0.05}, "shadowing": {"type": "separable"}},
}
WRONG = [
    '{\n  "distribution": {"type": "ggx" "alpha": 0.5}\n}',
    '{"distribution": {"type": "ggxx", "alpha": 0.5}}',
    '{"distribution": {"type": "ggx", "alpha": -1}}',
    '{"distribution": {"type": "ggx", "alpha": 0.5, "alpha": 0.5}}',
    "[1, 2",
]


def rows() -> list[list[float]]:
    """theta_o, phi_o, theta_i, phi_i, theta_m, phi_m."""
    out = []
    for k in range(60):
        part = [math.modf(k * step + 0.5)[0] for step in (0.618034, 0.754878, 0.569840, 0.819173, 0.671044, 0.549700)]
        out.append([v * (1.55 if j % 2 == 0 else 6.28) for j, v in enumerate(part)])
    return out + [[1.5, 0, 1.5, math.pi, 0.1, 0], [0, 0, 0, 0, 0, 0]]


def run_cli(program: str, material: Path, quantity: str) -> list[list[float]] | str:
    text = "theta_o,phi_o,theta_i,phi_i,theta_m,phi_m\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows())
    # h serves as m where i is given: only what the quantity takes is.
    used = QUANTITIES.get(quantity, "o")
    table = list(csv.reader(io.StringIO(text)))
    keep = [k for k, name in enumerate(table[0]) if name[-1] in used]
    text = "".join(",".join(row[k] for k in keep) + "\n" for row in table)
    done = subprocess.run([program, "eval", str(material), "-q", quantity, "-i", "-", "--quiet"], input=text, capture_output=True, text=True)
    if done.returncode:
        return done.stderr.strip()
    values = list(csv.reader(io.StringIO(done.stdout)))[1:]
    return [[float(v) for v in row[len(keep):]] for row in values]


def difference(a: float, b: float) -> float:
    if a == b or (math.isnan(a) and math.isnan(b)):
        return 0.0
    return abs(a - b) / max(abs(a), abs(b)) if math.isfinite(a - b) else math.inf


def main(page: Path, program: str, configs: Path) -> list[str]:
    faults, compared, worst = [], 0, (0.0, "")
    with Browser() as browser, tempfile.TemporaryDirectory() as folder:
        materials = sorted((configs / "materials").glob("*.json"))
        for name, content in INLINE.items():
            materials.append(Path(folder, name + ".json"))
            materials[-1].write_text(json.dumps(content))
        visit = Visit(browser, page)
        browser.wait_for("Page.loadEventFired", visit.session)

        def ask(expression: str):
            answer = browser.call("Runtime.evaluate", visit.session, expression=expression, returnByValue=True, awaitPromise=True)
            if "exceptionDetails" in answer:
                return str(answer["exceptionDetails"]["exception"].get("description", "")).split("\n")[0].removeprefix("Error: ")
            return answer["result"].get("value")

        ask("brdfplot.shown")
        directions = {d: [row[2 * k : 2 * k + 2] for row in rows()] for k, d in enumerate("oim")}
        for material in materials:
            answer = ask(f"brdfplot.setMaterial({json.dumps(material.read_text(encoding='utf-8'))})")
            if answer:
                # Its formulas and files the page has not, and says so.
                if "the live page" not in answer:
                    faults.append(f"{material.name}: {answer}")
                continue
            for quantity, used in QUANTITIES.items():
                given = json.dumps({d: directions[d] for d in used})
                there = ask(f"brdfplot.evaluate('{quantity}', {given}).map((c) => Array.from(c, (v) => Number.isFinite(v) ? v : String(v)))")
                here = run_cli(program, material, quantity)
                if isinstance(here, str) or isinstance(there, str):
                    if not (isinstance(here, str) and isinstance(there, str)):
                        faults.append(f"{material.name} {quantity}: the program says {str(here)[:200]}, the page {str(there)[:200]}")
                    continue
                for k, row in enumerate(here):
                    for c, value in enumerate(row):
                        got = float(there[c][k]) if c < len(there) else math.nan
                        far = difference(value, got)
                        compared += 1
                        worst = max(worst, (far, f"{material.name} {quantity} row {k}"))
                        if far > TOLERANCE:
                            faults.append(f"{material.name} {quantity} row {k}: {value!r} of the program, {got!r} of the page")
        material = configs / "materials" / "ggx.json"
        ask(f"brdfplot.setMaterial({json.dumps(material.read_text())})")
        there = ask(f"brdfplot.integrate('albedo', {json.dumps({'o': directions['o'][:4]})}).map((c) => [...c])")
        for k, row in enumerate(run_cli(program, material, "albedo")[:4]):
            if not abs(row[0] - there[0][k]) <= INTEGRAL:
                faults.append(f"albedo row {k}: {row[0]!r} of the program, {there[0][k]!r} of the page")

        for text in WRONG:
            file = Path(folder, "material")
            file.write_text(text)
            theirs = subprocess.run([program, "eval", "material", "-q", "d", "--grid", "theta_m=0"], capture_output=True, text=True, cwd=folder)
            theirs = theirs.stderr.strip().removeprefix("brdfplot: error: ")
            typed = f"byId('json').value = {json.dumps(text)}; byId('json').dispatchEvent(new Event('input'));"
            shown = ask(typed + "byId('error').hidden ? '' : byId('error').textContent")
            if not shown or shown != theirs:
                faults.append(f"an error: {theirs!r} of the program, {shown!r} of the page")

        # A permalink is what it was, and a wrong one is told.
        link = {"distribution": {"type": "beckmann", "alpha": 0.25}}
        ask(f"location.hash = '#' + encodeURIComponent({json.dumps(json.dumps(link))})")
        browser.collect(0.5)
        if ask("byId('error').hidden") is not True or ask("JSON.parse(byId('json').value)") != link:
            faults.append("the material of the address is not shown")
        milliseconds = ask("(() => { const all = []; for (let k = 0; k < 9; ++k) { redraw(); all.push(brdfplot.milliseconds); } return all.sort((a, b) => a - b)[4]; })()")
        # Every distribution has its controls.
        by_sliders = 0
        for kind in ask("about.distribution.map((d) => d.type)"):
            chosen = f"byId('distribution').value = '{kind}'; byId('distribution').onchange();"
            answer = ask(chosen + "[current.distribution.type, byId('error').hidden ? '' : byId('error').textContent, document.querySelectorAll('#controls .parameter').length]")
            # What cannot be set by sliders alone is told by the program.
            if not isinstance(answer, list) or answer[0] != kind or (answer[1] and not answer[1].startswith("material: /")):
                faults.append(f"controls of {kind}: {answer}")
            elif not answer[1]:
                by_sliders += 1
            ask(f"current = {json.dumps(link)}; changed(); controls()")
        if by_sliders < 8:
            faults.append(f"sliders set {by_sliders} distributions; there were 8 at least")
        faults += visit.faults()
    print(f"{compared} values compared, the farthest {worst[0]:.1e} ({worst[1]}); redrawn in {milliseconds:.0f} ms; {by_sliders} distributions by sliders")
    if compared < 1000:
        faults.append("too few values were compared")
    if not milliseconds <= REDRAW:
        faults.append(f"redrawn in {milliseconds:.0f} ms; accepted: {REDRAW}")
    return faults


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    found = main(Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3]))
    print("\n".join(found))
    sys.exit(bool(found))
