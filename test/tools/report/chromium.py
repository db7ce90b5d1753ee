# SPDX-License-Identifier: BSD-3-Clause
"""A headless Chromium, driven through a pipe: enough to open a page, run a script in it and look at it."""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

PROGRAMS = ("chromium", "chromium-browser", "google-chrome")


def program():
    """Path of the browser, None if there is none."""
    return next((path for path in map(shutil.which, PROGRAMS) if path), None)


class Browser:
    """One page. `messages` are the errors and warnings that it wrote to its console, `requests` the addresses that
    it asked for."""

    def __init__(self, width=1200, height=900, *flags):
        self.messages, self.requests, self.events = [], [], []
        self._last, self._rest = 0, b""
        self._profile = tempfile.mkdtemp(prefix="sedr_chromium_")
        down_read, self._down = os.pipe()
        self._up, up_write = os.pipe()

        def connect():  # the protocol's pipes are numbers 3 and 4
            os.dup2(down_read, 40)
            os.dup2(up_write, 41)
            os.dup2(40, 3)
            os.dup2(41, 4)
            for number in (3, 4):
                os.set_inheritable(number, True)

        self._process = subprocess.Popen(
            [program(), "--headless=new", "--remote-debugging-pipe", "--no-sandbox", "--disable-dev-shm-usage",
             "--no-first-run", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
             f"--user-data-dir={self._profile}", f"--window-size={width},{height}", *flags, "about:blank"],
            preexec_fn=connect, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(down_read)
        os.close(up_write)
        target = next(t for t in self._ask("Target.getTargets", {}, None)["targetInfos"] if t["type"] == "page")
        self._session = self._ask("Target.attachToTarget", {"targetId": target["targetId"], "flatten": True},
                                  None)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(domain + ".enable")
        self.resize(width, height)

    def close(self):
        self._process.terminate()
        self._process.wait(20)
        os.close(self._down)
        os.close(self._up)
        shutil.rmtree(self._profile, ignore_errors=True)

    def ask(self, method, **parameters):
        return self._ask(method, parameters, self._session)

    def resize(self, width, height):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def open(self, path):
        self.events.clear()
        self.ask("Page.navigate", url="file://" + os.path.abspath(path))
        self._until(lambda: any(e["method"] == "Page.loadEventFired" for e in self.events))

    def run(self, script):
        """The value of an expression in the page."""
        answer = self.ask("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(json.dumps(answer["exceptionDetails"]))
        return answer["result"].get("value")

    def screenshot(self, whole=False):
        """Bytes of a PNG of what is seen, or of the whole page."""
        return base64.b64decode(self.ask("Page.captureScreenshot", captureBeyondViewport=whole)["data"])

    def _ask(self, method, parameters, session):
        self._last += 1
        number = self._last
        message = {"id": number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        os.write(self._down, json.dumps(message).encode() + b"\0")
        answers = []
        self._until(lambda: any(a.get("id") == number for a in answers), answers)
        answer = next(a for a in answers if a.get("id") == number)
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']}")
        return answer["result"]

    def _until(self, done, answers=None, seconds=60):
        end = time.monotonic() + seconds
        while not done():
            ready, _, _ = select.select([self._up], [], [], max(0, end - time.monotonic()))
            if not ready:
                raise TimeoutError("the browser does not answer")
            self._rest += os.read(self._up, 1 << 20)
            *messages, self._rest = self._rest.split(b"\0")
            for message in map(json.loads, messages):
                self._note(message)
                if answers is not None:
                    answers.append(message)

    def _note(self, message):
        method, parameters = message.get("method"), message.get("params", {})
        if method is None:
            return
        self.events.append(message)
        if method == "Runtime.exceptionThrown":
            self.messages.append(json.dumps(parameters["exceptionDetails"])[:500])
        elif method == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
            self.messages.append(json.dumps(parameters["args"])[:500])
        elif method == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
            self.messages.append(parameters["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(parameters["request"]["url"])
