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
SETTLE = 1.0  # seconds after loading, for timers and lazy loading
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

    def wait_for(self, method: str) -> None:
        end = time.monotonic() + DEADLINE
        while not any(event.get("method") == method for event in self.events):
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


def check(browser: Browser, page: Path) -> list[str]:
    """Everything that is wrong with the page."""
    page = page.resolve()
    if not page.is_file():
        return ["no such file"]
    url = page.as_uri()
    proxy = CountingProxy()
    context = browser.call(
        "Target.createBrowserContext", proxyServer=f"127.0.0.1:{proxy.port}", proxyBypassList="<-loopback>"
    )["browserContextId"]
    target = browser.call("Target.createTarget", url="about:blank", browserContextId=context)["targetId"]
    session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
    for domain in ("Runtime", "Log", "Network", "Page"):
        browser.call(f"{domain}.enable", session)
    browser.events.clear()
    browser.call("Page.navigate", session, url=url)
    browser.wait_for("Page.loadEventFired")
    browser.collect(SETTLE)
    drawn, links = browser.call("Runtime.evaluate", session, expression=SUMMARY, returnByValue=True)["result"]["value"]
    browser.call("Target.disposeBrowserContext", browserContextId=context)
    proxy.close()

    faults = [fault for event in browser.events if (fault := fault_of(event, url))]
    faults += [f"network: {line}" for line in proxy.asked]
    faults += [f"<link> to {href}" for href in links if not href.startswith(OWN_SCHEMES)]
    expected = max(1, len(list(page.parent.glob("figures/*.svg"))))
    if drawn < expected:
        faults.append(f"{drawn} <svg> elements, expected at least {expected}")
    return list(dict.fromkeys(faults))


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
    wrong = []
    with Browser() as browser, tempfile.TemporaryDirectory() as folder:
        page = Path(folder, "page ü.html")
        for name, body in [*((f"good {i}", b) for i, b in enumerate(good)), *bad.items()]:
            page.write_text(f"<!doctype html><meta charset=utf-8><title>t</title><body>{body}", encoding="utf-8")
            faults = check(browser, page)
            print(f"{name}: {faults}")
            if bool(faults) != (name in bad):
                wrong.append(name)
        Path(folder, "figures").mkdir()
        for name in ("a", "b"):
            Path(folder, "figures", f"{name}.svg").write_text(svg, encoding="utf-8")
        page.write_text(f"<!doctype html><meta charset=utf-8><title>t</title>{svg}", encoding="utf-8")
        if not check(browser, page):
            wrong.append("one of two figures")
    if wrong:
        sys.exit(f"self-test: wrong about {', '.join(wrong)}")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        with Browser() as chromium:
            found = [f"{page}: {fault}" for page in sys.argv[1:] for fault in check(chromium, Path(page))]
        for fault in found:
            print(fault)
        sys.exit(bool(found))
    else:
        sys.exit(__doc__)
