"""Opens pages in headless Chromium, from file://, and fails on anything that a self-contained page has no business doing:
a console message, an exception, a request for any other file or host, or a page without its figures.

    check_page.py PAGE.html...
    check_page.py --self-test

A page has to hold at least one inline <svg>, and one for every file in figures/*.svg beside it.

Chromium is driven by its debugging protocol over a pipe, which reports requests and messages as they are. The page is
also given a proxy that only counts, for what asks for a host from where the protocol does not look (a frame, a worker);
Chromium's own errands go to a port that nothing listens to. Hints (<link rel=preconnect>) are read from the document:
in a context with a proxy of its own Chromium ignores them.
"""

import fcntl
import json
import os
import select
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

DEADLINE = 120  # seconds for a page to load
SETTLE = 2.0  # seconds after all have loaded, for timers and lazy loading
OWN_SCHEMES = ("data:", "blob:", "about:")
SUMMARY = "[document.querySelectorAll('svg').length, [...document.querySelectorAll('link')].map(link => link.href)]"


class CountingProxy:
    """Accepts connections, remembers the first line of each and answers none."""

    def __init__(self) -> None:
        self.asked: list[str] = []
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self) -> None:
        while True:
            try:
                connection, _ = self.listener.accept()
            except OSError:
                return
            with connection:
                connection.settimeout(5)
                try:
                    first = connection.recv(4096).split(b"\r\n")[0].decode("latin-1")
                except OSError:
                    first = ""
                self.asked.append(first or "a connection that sent nothing")

    def close(self) -> None:
        self.listener.close()


class Browser:
    """Headless Chromium with a fresh profile, spoken to over its debugging pipe (descriptors 3 and 4 of its process)."""

    def __init__(self) -> None:
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        program = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
        if program is None:
            sys.exit("No Chromium found")
        command = [
            program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
            "--disable-background-networking", "--disable-component-update", "--disable-default-apps",
            "--disable-domain-reliability", "--disable-extensions", "--disable-sync", "--disable-dev-shm-usage",
            "--metrics-recording-only", "--no-default-browser-check", "--no-pings", f"--user-data-dir={self.profile.name}",
            "--proxy-server=127.0.0.1:1", "--remote-debugging-pipe", "about:blank",
        ]  # fmt: skip
        their_input, self.input = os.pipe()
        self.output, their_output = os.pipe()
        # High numbers, so that making them 3 and 4 closes neither.
        theirs = [fcntl.fcntl(fd, fcntl.F_DUPFD, 10) for fd in (their_input, their_output)]
        shell = 'exec 3<&"$1" 4>&"$2"; shift 2; exec "$@"'
        self.process = subprocess.Popen(
            ["bash", "-c", shell, "bash", *map(str, theirs), *command],
            pass_fds=theirs, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        for fd in (their_input, their_output, *theirs):
            os.close(fd)
        self.buffer = b""
        self.last_id = 0
        self.events: list[dict] = []

    def read(self, timeout: float) -> dict | None:
        """The next message, or nothing when none comes in time."""
        end = time.monotonic() + timeout
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.output], [], [], max(0.0, end - time.monotonic()))
            if not ready:
                return None
            chunk = os.read(self.output, 1 << 16)
            if not chunk:
                sys.exit("Chromium ended unexpectedly")
            self.buffer += chunk
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method: str, session: str | None = None, **params) -> dict:
        self.last_id += 1
        message = {"id": self.last_id, "method": method, "params": params}
        if session:
            message["sessionId"] = session
        os.write(self.input, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.read(DEADLINE)
            if answer is None:
                sys.exit(f"Chromium did not answer {method} within {DEADLINE} s")
            if answer.get("id") == self.last_id:
                if "error" in answer:
                    sys.exit(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def wait_for(self, method: str, session: str) -> None:
        end = time.monotonic() + DEADLINE
        while not any(event.get("method") == method and event.get("sessionId") == session for event in self.events):
            message = self.read(end - time.monotonic())
            if message is None:
                sys.exit(f"No {method} within {DEADLINE} s")
            self.events.append(message)

    def collect(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            if message := self.read(left):
                self.events.append(message)

    def close(self) -> None:
        os.close(self.input)  # Chromium ends with its pipe
        try:
            self.process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.output)
        self.profile.cleanup()

    def __enter__(self) -> "Browser":
        return self

    def __exit__(self, *_) -> None:
        self.close()


def fault_of(event: dict, page_url: str) -> str | None:
    """What a message of the protocol says against the page, or nothing."""
    method, params = event.get("method", ""), event.get("params", {})
    if method == "Runtime.consoleAPICalled":
        words = (str(a.get("value", a.get("description", ""))) for a in params["args"])
        return f"console.{params['type']}: {' '.join(words)}"
    if method == "Runtime.exceptionThrown":
        details = params["exceptionDetails"]
        return f"exception: {details.get('exception', {}).get('description', details['text'])}"
    if method == "Log.entryAdded" and params["entry"]["level"] != "verbose":
        entry = params["entry"]
        return f"{entry['level']}: {entry['text']} {entry.get('url', '')}".rstrip()
    if method == "Network.requestWillBeSent":
        url = params["request"]["url"]
        return None if url == page_url or url.startswith(OWN_SCHEMES) else f"request: {url}"
    if method == "Network.webSocketCreated":
        return f"request: {params['url']}"
    return None


class Visit:
    """A page that is open, in a context of its own."""

    def __init__(self, browser: Browser, page: Path) -> None:
        self.browser = browser
        self.page = page.resolve()
        self.url = self.page.as_uri()
        self.proxy = CountingProxy()
        self.context = browser.call(
            "Target.createBrowserContext", proxyServer=f"127.0.0.1:{self.proxy.port}", proxyBypassList="<-loopback>"
        )["browserContextId"]
        target = browser.call("Target.createTarget", url="about:blank", browserContextId=self.context)["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Runtime", "Log", "Network", "Page"):
            browser.call(f"{domain}.enable", self.session)
        # Of about:blank.
        browser.events = [event for event in browser.events if event.get("sessionId") != self.session]
        browser.call("Page.navigate", self.session, url=self.url)

    def faults(self) -> list[str]:
        """Everything that was wrong with the page until now. Closes it."""
        summary = self.browser.call("Runtime.evaluate", self.session, expression=SUMMARY, returnByValue=True)
        drawn, links = summary["result"]["value"]
        self.browser.call("Target.disposeBrowserContext", browserContextId=self.context)
        self.proxy.close()
        own = [event for event in self.browser.events if event.get("sessionId") == self.session]
        faults = [fault for event in own if (fault := fault_of(event, self.url))]
        faults += [f"network: {line}" for line in self.proxy.asked]
        faults += [f"<link> to {href}" for href in links if not href.startswith(OWN_SCHEMES)]
        expected = max(1, len(list(self.page.parent.glob("figures/*.svg"))))
        if drawn < expected:
            faults.append(f"{drawn} <svg> elements, expected at least {expected}")
        return list(dict.fromkeys(faults))


def check(browser: Browser, pages: list[Path]) -> list[list[str]]:
    """Everything that is wrong with each page. All are open at once, so that they settle together."""
    visits = [Visit(browser, page) if page.is_file() else None for page in pages]
    for visit in filter(None, visits):
        browser.wait_for("Page.loadEventFired", visit.session)
    browser.collect(SETTLE)
    return [visit.faults() if visit else ["no such file"] for visit in visits]


def self_test() -> None:
    svg = '<svg width="9" height="9"><path d="M0 0h9"/></svg>'
    good = [
        svg,
        svg + "<script>document.title = 'x'</script><a href='https://example.org/'>a link is not a request</a>",
        svg + "<img src='data:image/gif;base64,R0lGODlhAQABAAAAACH5BAEKAAEALAAAAAABAAEAAAICTAEAOw=='>",
        svg + "<a download='a.csv' href='data:text/csv,x'>data</a><details><summary>s</summary>text</details>",
    ]
    bad = {
        "exception": svg + "<script>undefined_function()</script>",
        "late exception": svg + "<script>setTimeout(() => undefined_function(), 300)</script>",
        "rejected promise": svg + "<script>Promise.reject(new Error('no'))</script>",
        "console.error": svg + "<script>console.error('no')</script>",
        "console.warn": svg + "<script>console.warn('no')</script>",
        "syntax error": svg + "<script>let = </script>",
        "external image": svg + "<img src='http://example.invalid/a.png'>",
        "external script": svg + "<script src='https://example.invalid/a.js'></script>",
        "external style": "<link rel=stylesheet href='https://example.invalid/a.css'>" + svg,
        "external font": "<style>@font-face{font-family:F;src:url(https://example.invalid/f)}p{font-family:F}</style><p>x" + svg,
        "preconnect": "<link rel=preconnect href='https://example.invalid'>" + svg,
        "frame": svg + "<iframe srcdoc='<img src=https://example.invalid/a.png>'></iframe>",
        "worker": svg + "<script>new Worker(URL.createObjectURL(new Blob([\"fetch('https://example.invalid/')\"])))</script>",
        "fetch": svg + "<script>fetch('https://example.invalid/x').catch(() => 0)</script>",
        "web socket": svg + "<script>new WebSocket('wss://example.invalid/')</script>",
        "a file beside it": svg + "<img src='figures/a.svg'>",
        "SVG that fetches": "<svg><image href='https://example.invalid/i.png' width='9' height='9'/></svg>",
        "no figure": "<p>nothing</p>",
    }
    texts = {**{f"good {i}": body for i, body in enumerate(good)}, **bad, "one of two figures": svg}
    wrong = []
    with Browser() as browser, tempfile.TemporaryDirectory() as folder:
        pages = []
        for i, (name, body) in enumerate(texts.items()):
            pages.append(Path(folder, str(i), "page ü.html"))
            pages[-1].parent.mkdir()
            text = f"<!doctype html><meta charset=utf-8><title>t</title><body>{body}"
            pages[-1].write_text(text, encoding="utf-8")
        figures = pages[-1].parent / "figures"
        figures.mkdir()
        for figure in ("a.svg", "b.svg"):
            (figures / figure).write_text(svg, encoding="utf-8")
        for name, faults in zip(texts, check(browser, pages)):
            print(f"{name}: {faults}")
            if bool(faults) == name.startswith("good"):
                wrong.append(name)
        if check(browser, [Path(folder, "gone.html")]) != [["no such file"]]:
            wrong.append("no such file")
    if wrong:
        sys.exit(f"self-test: wrong about {', '.join(wrong)}")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        with Browser() as chromium:
            faults = check(chromium, [Path(page) for page in sys.argv[1:]])
        found = [f"{page}: {fault}" for page, of_page in zip(sys.argv[1:], faults) for fault in of_page]
        for fault in found:
            print(fault)
        sys.exit(bool(found))
    else:
        sys.exit(__doc__)
