#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Looks at the viewer as a person does: presses keys in its window, in an X server of its own.

    test_viewer_keys.py pcl_sedr_viewer

Exit code 77: skipped, for want of Xvfb or of the library of X's test extension.
"""

import contextlib
import ctypes
import ctypes.util
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time

PATIENCE = 60  # seconds
SKIPPED = 77


class Hands:
    """Keyboard and mouse of the X server at DISPLAY."""

    def __init__(self):
        self.x = ctypes.CDLL(ctypes.util.find_library("X11"))
        self.test = ctypes.CDLL(ctypes.util.find_library("Xtst"))
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XStringToKeysym.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(None))
        self.x.XSetInputFocus(self.display, ctypes.c_ulong(1), 1, ctypes.c_ulong(0))  # keys go where the mouse is

    def move(self, x, y):
        self.test.XTestFakeMotionEvent(self.display, -1, x, y, ctypes.c_ulong(0))
        self.x.XFlush(self.display)

    def _turn(self, key, down):
        code = self.x.XKeysymToKeycode(self.display, ctypes.c_ulong(self.x.XStringToKeysym(key.encode())))
        self.test.XTestFakeKeyEvent(self.display, code, down, ctypes.c_ulong(0))

    def press(self, key):
        self._turn(key, 1)
        self._turn(key, 0)
        self.x.XFlush(self.display)


def write_cloud(path):
    """A floor of 2 by 2 m and a ceiling over it, both of room 7."""
    points = [(0.02 * i, 0.02 * j, z, label, 7) for z, label in ((0, 2), (2.5, 1)) for i in range(100) for j in range(100)]
    with open(path, "wb") as file:
        file.write(b"VERSION 0.7\nFIELDS x y z label room\nSIZE 4 4 4 4 4\nTYPE F F F U U\nCOUNT 1 1 1 1 1\nWIDTH %d\n"
                   b"HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS %d\nDATA binary\n" % (len(points), len(points)))
        for point in points:
            file.write(struct.pack("<3f2I", *point))


def until(what, done, again=lambda: None):
    """Waits until `done` gives something, which it returns; meanwhile does `again` every second."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        again()
        for _ in range(10):
            result = done()
            if result:
                return result
            time.sleep(0.1)
    sys.exit(f"FAILED: {what}")


def main(viewer):
    folder = tempfile.mkdtemp()
    viewer = os.path.abspath(viewer)
    os.chdir(folder)
    write_cloud("stage.pcd")
    with open("out", "w") as out:
        process = subprocess.Popen([viewer, "stage.pcd", "--size", "600x400", "--view", "top"],
                                   stdout=out, stderr=subprocess.STDOUT)
    said = lambda: open("out").read()
    hands = Hands()
    hands.move(300, 200)

    def whole_picture():
        """The bytes of sedr_view.png, once its end is there."""
        if not os.path.exists("sedr_view.png"):
            return None
        with open("sedr_view.png", "rb") as file:
            data = file.read()
        return data if b"IEND" in data[-12:] else None

    def picture():
        """What is seen, as key j writes it."""
        if os.path.exists("sedr_view.png"):
            os.remove("sedr_view.png")
        hands.press("j")
        return until("j writes sedr_view.png", whole_picture)

    until("the window opens and h prints the keys", lambda: "ceilings on and off" in said(), lambda: hands.press("h"))
    first = picture()
    hands.press("c")
    until("c shows another picture", lambda: picture() != first)
    os.remove("sedr_view.png")
    os.mkdir("sedr_view.png")
    hands.press("j")
    until("j tells that nothing can be written", lambda: "cannot write" in said())
    hands.press("q")
    until("q quits", lambda: process.poll() is not None)
    shutil.rmtree(folder)
    if process.returncode != 0:
        sys.exit(f"FAILED: q ends the program with {process.returncode}")
    print("keys and quit work")


@contextlib.contextmanager
def virtual_screen():
    """An X server without a screen at a display that it finds free, which DISPLAY names meanwhile."""
    server = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", "800x600x24", "-nolisten", "tcp", "-noreset"],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        display = server.stdout.readline().strip()
        if not display:
            sys.exit("FAILED: Xvfb did not start")
        os.environ["DISPLAY"] = ":" + display
        yield
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    if not shutil.which("Xvfb") or not ctypes.util.find_library("Xtst"):
        print("skipped: Xvfb (Debian's xvfb) or libXtst (libxtst6) is missing")
        sys.exit(SKIPPED)
    with virtual_screen():
        main(sys.argv[1])
