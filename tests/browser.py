"""A real browser for tests: Chromium without a screen, driven through chromedriver's own HTTP interface."""

from __future__ import annotations

import base64
import json
import shutil
import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any
from urllib.error import URLError
from urllib.request import Request, urlopen

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
DRIVER = shutil.which("chromedriver")
PATIENCE = 180


class Browser:
    """One window; what it runs is JavaScript of the test's, never of the page's."""

    def __init__(self, address: str, session: str) -> None:
        self._root = f"{address}/session/{session}"

    def _post(self, path: str, value: object) -> Any:
        return _asked(f"{self._root}/{path}", value)

    def devtools(self, command: str, **parameters: object) -> Any:
        """The answer to a command of the DevTools protocol."""
        return self._post("goog/cdp/execute", {"cmd": command, "params": parameters})

    def open(self, address: str, width: int, dark: bool = False) -> None:
        """The page at this width of the window, in the light or in the dark."""
        self.devtools(
            "Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=width < 600
        )
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.devtools("Emulation.setEmulatedMedia", features=[scheme])
        self._post("url", {"url": address})

    def as_on_paper(self, width: int) -> None:
        """The page as it is printed, on paper that is this wide."""
        self.devtools("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)
        self.devtools("Emulation.setEmulatedMedia", media="print")

    def run(self, script: str, *values: object) -> Any:
        """What a script returns."""
        return self._post("execute/sync", {"script": script, "args": list(values)})

    def console(self) -> list[dict[str, Any]]:
        """What the console has said, warnings and errors among it."""
        return _asked(f"{self._root}/se/log", {"type": "browser"})

    def picture(self, to: Path) -> None:
        """A picture of the window as PNG."""
        to.write_bytes(base64.b64decode(self.devtools("Page.captureScreenshot")["data"]))

    def printed(self, to: Path) -> None:
        """The page as PDF, on A4."""
        paper = {"paperWidth": 8.27, "paperHeight": 11.69, "preferCSSPageSize": True}
        to.write_bytes(base64.b64decode(self.devtools("Page.printToPDF", **paper)["data"]))


@contextmanager
def browser() -> Iterator[Browser]:
    """A browser, closed at the end."""
    assert CHROMIUM
    assert DRIVER
    port = _free_port()
    driver = subprocess.Popen([DRIVER, f"--port={port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    address = f"http://127.0.0.1:{port}"
    try:
        _wait_for(address)
        arguments = ["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--disable-dev-shm-usage"]
        options = {
            "goog:chromeOptions": {"binary": CHROMIUM, "args": arguments},
            "goog:loggingPrefs": {"browser": "ALL"},
        }
        session = _asked(f"{address}/session", {"capabilities": {"alwaysMatch": options}})["sessionId"]
        try:
            yield Browser(address, session)
        finally:
            with suppress(OSError):
                urlopen(Request(f"{address}/session/{session}", method="DELETE"), timeout=PATIENCE).close()
    finally:
        driver.terminate()
        driver.wait()


def _asked(address: str, value: object) -> Any:
    request = Request(address, json.dumps(value).encode(), {"Content-Type": "application/json"})
    with urlopen(request, timeout=PATIENCE) as answer:
        return json.load(answer)["value"]


def _free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


def _wait_for(address: str) -> None:
    end = time.monotonic() + PATIENCE
    while True:
        try:
            urlopen(f"{address}/status", timeout=1).close()
            return
        except (URLError, OSError):
            if time.monotonic() > end:
                raise
            time.sleep(0.05)
