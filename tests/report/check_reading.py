"""Uses the page of a report as a reader does, in headless Chromium: a pointer on curves, lobes, cells and profiles, whose
values are compared with the CSV beside the page; a legend that hides; a figure that opens large; files that are saved; a
narrow screen; and no scripts at all. A page of `brdfplot compare` has spheres: a pointer reads these too.

    check_reading.py PAGE.html BRDFPLOT
"""

import csv
import json
import math
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from check_page import Browser, Visit, fault_of

LARGEST = 2_000_000  # bytes of a page
NARROW = 400  # CSS pixels

# Every element that can be scrolled sideways, with all that unfolds unfolded.
SIDEWAYS = """(() => {
  for (const part of document.querySelectorAll('details')) part.open = true;
  const wide = [...document.querySelectorAll('body *')].filter(part => part.scrollWidth > part.clientWidth + 1 &&
    ['auto', 'scroll'].includes(getComputedStyle(part).overflowX));
  const names = wide.map(part => part.closest('figure')?.id + ' ' + part.tagName + '.' + part.className);
  if (document.documentElement.scrollWidth > innerWidth) names.push('the page: ' + document.documentElement.scrollWidth);
  return names;
})()"""

PANELS = """(id => [...document.querySelectorAll(`#${id} .bp-panel[data-plot], dialog[open] .bp-panel[data-plot]`)].map(
  panel => ({...panel.dataset})))"""

# Scrolls a place of a drawing into view, and says where that is on the screen.
ON_SCREEN = """((id, x, y) => {
  const svg = document.querySelector(`dialog[open] svg`) || document.querySelector(`#${id} .plot svg`);
  if (!svg.closest('dialog')) svg.scrollIntoView({block: 'center', behavior: 'instant'});
  const p = new DOMPoint(x, y).matrixTransform(svg.getScreenCTM());
  return [p.x, p.y];
})"""

TIP = "(document.querySelector('.tip:not([hidden])')?.innerText || '')"


class Page:
    def __init__(self, browser: Browser, path: Path, width: int, scripts: bool = True) -> None:
        self.browser, self.path = browser, path
        self.visit = Visit(browser, path)
        self.session = self.visit.session
        browser.wait_for("Page.loadEventFired", self.session)
        browser.call("Emulation.setDeviceMetricsOverride", self.session, width=width, height=900, deviceScaleFactor=1, mobile=False)
        if not scripts:
            browser.events = [e for e in browser.events if e.get("method") != "Page.loadEventFired"]
            browser.call("Emulation.setScriptExecutionDisabled", self.session, value=True)
            browser.call("Page.reload", self.session)
            browser.wait_for("Page.loadEventFired", self.session)

    def ask(self, expression: str):
        answer = self.browser.call("Runtime.evaluate", self.session, expression=expression, returnByValue=True)
        if "exceptionDetails" in answer:
            sys.exit(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def wait(self, expression: str, seconds: float = 10):
        end = time.monotonic() + seconds
        while not (value := self.ask(expression)) and time.monotonic() < end:
            time.sleep(0.05)
        return value

    def mouse(self, kind: str, x: float, y: float, **more) -> None:
        self.browser.call("Input.dispatchMouseEvent", self.session, type=kind, x=x, y=y, **more)

    def click(self, x: float, y: float) -> None:
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, x, y, button="left", clickCount=1)

    def centre(self, selector: str) -> list[float]:
        return self.ask(f"""(() => {{
          const part = document.querySelector({json.dumps(selector)});
          part.scrollIntoView({{block: 'center', behavior: 'instant'}});
          const box = part.getBoundingClientRect();
          return [box.x + box.width / 2, box.y + box.height / 2];
        }})()""")

    def read_at(self, figure: str, x: float, y: float) -> str:
        """What a pointer at a place of a drawing is told."""
        at = self.ask(f"{ON_SCREEN}({json.dumps(figure)}, {x}, {y})")
        self.mouse("mouseMoved", at[0] + 40, at[1])
        self.mouse("mouseMoved", *at)
        self.wait(f"{TIP} !== ''")
        time.sleep(0.1)  # what was asked for first may still come
        return self.ask(TIP)

    def rows(self, figure: str) -> list[dict[str, str]]:
        (name,) = self.path.parent.rglob(f"{figure}.csv")
        with name.open(encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def faults(self) -> list[str]:
        own = [event for event in self.browser.events if event.get("sessionId") == self.session]
        return [fault for event in own if (fault := fault_of(event, self.visit.url)) and not fault.startswith("request: blob:")]


class Axis:
    def __init__(self, text: str) -> None:
        start, end, self.unit, scale = text.split(" ")
        self.start, self.end, self.log = float(start), float(end), scale == "log"

    def place(self, value: float) -> float:
        if self.log:
            return math.log(value / self.start) / math.log(self.end / self.start)
        return (value - self.start) / (self.end - self.start)

    def close(self, told: float, value: float) -> bool:
        told /= 180 / math.pi if self.unit == "degrees" else 1
        return abs(self.place(told) - self.place(value)) < 0.004


def numbers(tip: str) -> list[float]:
    text = tip.replace("−", "-").replace("·10\n", "·10")
    return [float(re.sub(r"·10\^?(-?\d+)", r"e\1", line.rsplit(" = ", 1)[1]).strip("° rad")) for line in text.split("\n") if " = " in line]


def place_of(panel: dict, x: float, y: float) -> tuple[float, float]:
    left, top, width, height = map(float, panel["plot"].split())
    ax, ay = Axis(panel["x"]), Axis(panel["y"])
    if panel["kind"] == "polar":
        radius = ay.place(y) * width / 2
        return left + width / 2 + radius * math.sin(x), top + width / 2 - radius * math.cos(x)
    return left + ax.place(x) * width, top + height - ay.place(y) * height


def check_values(page: Page, figure: str, columns: tuple[str, str], panel_index: int = 0) -> list[str]:
    """Points of the curves of a figure's first panel."""
    panel = page.ask(f"{PANELS}({json.dumps(figure)})")[panel_index]
    rows = page.rows(figure)
    of_panel = [row for row in rows if row["panel"] == rows[0]["panel"] and row[columns[0]] != ""]
    faults = []
    for row in of_panel[len(of_panel) // 3 :: max(len(of_panel) // 4, 1)]:
        x, y = float(row[columns[0]]), float(row[columns[1]])
        tip = page.read_at(figure, *place_of(panel, x, y))
        told = numbers(tip)[-2:]  # a series may be called "α = 0.3"
        if len(told) != 2 or not Axis(panel["x"]).close(told[0], x) or not Axis(panel["y"]).close(told[1], y):
            faults.append(f"{figure}: a pointer at {x}, {y} is told {tip!r}")
        if panel["kind"] != "profile" and "°" not in tip:
            faults.append(f"{figure}: {tip!r} has no unit")
    return faults


def check_cells(page: Page, figure: str) -> list[str]:
    panels = page.ask(f"{PANELS}({json.dumps(figure)})")
    faults = []
    for panel in (panels[0], panels[-1]):
        x, y = panel["columns"].split(",")
        own = [row for row in page.rows(figure) if row["panel"] == panel["panel"]]
        for row in own[len(own) // 5 :: max(len(own) // 3, 1)]:
            tip = page.read_at(figure, *place_of(panel, float(row[x]), float(row[y])))
            value = float(list(row.values())[-1])
            told = numbers(tip)
            if len(told) != 3 or abs(told[2] - value) > 1e-4 * abs(value) or not Axis(panel["x"]).close(told[0], float(row[x])):
                faults.append(f"{figure}: the cell {row} is told as {tip!r}")
    return faults


def check_spheres(page: Page, figure: str) -> list[str]:
    """The angle at places of a sphere, and what its middle shows (the exposure is 1)."""
    panel = page.ask(f"{PANELS}({json.dumps(figure)})")[0]
    left, top, width, height = map(float, panel["plot"].split())
    start, end = map(float, panel["x"].split()[:2])
    rows = page.rows(figure)
    rows = [row for row in rows if row["panel"] == rows[0]["panel"] and row["position"] != ""]
    middle = [float(row["radiance"]) for row in rows if abs(float(row["position"])) < 0.02]
    faults = []
    for degrees in (0, 30, 60):
        away = math.sin(math.radians(degrees)) / (end - start)
        tip = page.read_at(figure, left + (0.5 + away) * width, top + 0.5 * height)
        told = re.fullmatch(r"θo = ([\d.]+)°\n.*: (\S+)", tip.replace("θ\no", "θo"))
        if not told or abs(float(told[1]) - degrees) > 1.5:
            faults.append(f"{figure}: at {degrees} degrees a pointer is told {tip!r}")
        elif degrees == 0 and not 0.9 * min(middle) <= float(told[2]) <= 1.1 * max(middle):
            faults.append(f"{figure}: the middle has {middle}, and is told as {tip!r}")
    return faults


def check_legend(page: Page, figure: str) -> list[str]:
    key = page.ask(f"document.querySelector('#{figure} .bp-entry[data-key]').dataset.key")
    shown = f"""[...document.querySelectorAll('#{figure} path[data-key="{key}"]')].filter(
      part => !part.closest('.bp-entry') && getComputedStyle(part).display !== 'none').length"""
    before, faults = page.ask(shown), []
    for expected in (0, before):
        page.click(*page.centre(f"#{figure} .bp-entry[data-key] text"))
        if before == 0 or page.ask(shown) != expected:
            faults.append(f"{figure}: {page.ask(shown)} of {before} parts are shown after a click, expected {expected}")
    page.ask(f"document.querySelector('#{figure} .bp-entry[data-key]').focus()")
    for kind in ("keyDown", "keyUp"):
        page.browser.call("Input.dispatchKeyEvent", page.session, type=kind, key="Enter", code="Enter")
    if page.ask(shown) != 0:
        faults.append(f"{figure}: the key Enter does not hide")
    return faults


def check_large(page: Page, figure: str, columns: tuple[str, str]) -> list[str]:
    width = "document.querySelector('dialog[open] svg')?.getBoundingClientRect().width || 0"
    before = page.ask(f"document.querySelector('#{figure} svg').getBoundingClientRect().width")
    page.click(*page.centre(f"#{figure} button[data-enlarge]"))
    faults = []
    if page.ask(width) < 1.2 * before:
        faults.append(f"{figure}: {before} pixels wide, enlarged {page.ask(width)}")
    else:
        faults += check_values(page, figure, columns)
    for kind in ("keyDown", "keyUp"):
        page.browser.call("Input.dispatchKeyEvent", page.session, type=kind, key="Escape", code="Escape", windowsVirtualKeyCode=27)
    if not page.wait(f"document.querySelector('#{figure} > .plot > svg') !== null"):
        faults.append(f"{figure}: it does not come back")
    return faults


def check_files(page: Page, figure: str) -> list[str]:
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        page.browser.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=folder, browserContextId=page.visit.context)
        for kind in ("csv", "json", "svg"):
            page.click(*page.centre(f"#{figure} a[data-file={kind}]"))
            saved, end = Path(folder, f"{figure}.{kind}"), time.monotonic() + 20
            while not saved.is_file() and time.monotonic() < end:
                page.browser.collect(0.1)
            if not saved.is_file():
                faults.append(f"{saved.name} was not saved")
            elif kind == "svg":
                text = saved.read_text(encoding="utf-8")
                if "<style" not in text or "bp-halo" not in text or "tabindex" in text or "bp-off" in text:
                    faults.append(f"{saved.name}: {text[:500]}")
            elif saved.read_bytes() != (page.path.parent / "figures" / saved.name).read_bytes():
                faults.append(f"{saved.name} is not what stands beside the page")
    return faults


def check_without_scripts(page: Page) -> list[str]:
    links = page.ask("[...document.querySelectorAll('a[data-file]')].map(link => link.getAttribute('href'))")
    faults = [f"no scripts: no file {link}" for link in links if not (page.path.parent / link).is_file()]
    if not links or page.ask("[...document.querySelectorAll('button')].some(button => button.checkVisibility())"):
        faults.append("no scripts: buttons without a use, or no links")
    return faults


def check_comparison(brdfplot: str) -> list[str]:
    materials = [str(Path(__file__).parents[2] / "configs/materials" / f"{name}.json") for name in ("ggx", "beckmann")]
    with tempfile.TemporaryDirectory() as folder, Browser() as browser:
        subprocess.run([brdfplot, "compare", *materials, "-o", folder, "--quiet"], check=True, stdout=subprocess.DEVNULL)
        page = Page(browser, Path(folder, "index.html"), 1200)
        return check_spheres(page, "spheres") + page.faults()


def check(path: Path, brdfplot: str) -> list[str]:
    faults = check_comparison(brdfplot)
    if path.stat().st_size > LARGEST:
        faults.append(f"{path.stat().st_size} bytes, more than {LARGEST}")
    with Browser() as browser:
        page = Page(browser, path, 1200)
        faults += check_values(page, "fig06_first_bounce", ("theta_o", "value"))
        faults += check_values(page, "fig05_visible_normals", ("theta_m", "value"))
        faults += check_values(page, "fig02_microsurface", ("x", "height"))
        faults += check_cells(page, "fig09_v_cavity")
        faults += check_large(page, "fig06_first_bounce", ("theta_o", "value"))
        faults += check_files(page, "fig06_first_bounce")
        for figure in ("fig06_first_bounce", "fig05_visible_normals", "fig09_v_cavity", "fig01_visible_area"):
            faults += check_legend(page, figure)
        faults += page.faults()
        narrow = Page(browser, path, NARROW)
        faults += [f"at {NARROW} pixels: {name} scrolls sideways" for name in narrow.ask(SIDEWAYS)]
        faults += check_values(narrow, "fig06_first_bounce", ("theta_o", "value"))
        faults += narrow.faults()
        faults += check_without_scripts(Page(browser, path, 1200, scripts=False))
    return faults


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    found = check(Path(sys.argv[1]), sys.argv[2])
    for fault in found:
        print(fault)
    sys.exit(bool(found))
