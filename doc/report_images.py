# SPDX-License-Identifier: BSD-3-Clause
"""Takes the pictures of doc/report.md: parts of report.html as a browser shows them; doc/make_images.sh prepares
the data.

   python3 doc/report_images.py DATA OUTPUT

DATA holds a folder a scene with model/report.html. Needs Chromium.
"""
import base64
import io
import sys
from pathlib import Path

from PIL import Image

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "test/tools/report"))
import chromium

# name, scene, first and last element of the part, what is done before
PARTS = [
    ("top", "syn_flat", "header", "#rooms", ""),
    ("advice", "noisy_room", "#check", "#check", ""),
    ("model", "hls_hall", "#model h2", "#model .key", ""),
]


def box_of(browser, first, last):
    return browser.run(f"""(() => {{
      const a = document.querySelector('{first}').getBoundingClientRect();
      const b = document.querySelector('{last}').getBoundingClientRect();
      const main = document.querySelector('main').getBoundingClientRect();
      return {{x: main.left - 12, y: a.top + window.scrollY - 12, width: main.width + 24,
               height: b.bottom - a.top + 24, scale: 1}}; }})()""")


def main(data, output):
    for name, scene, first, last, before in PARTS:
        browser = chromium.Browser(900, 1000)
        browser.open(Path(data) / scene / "model/report.html")
        if browser.messages:
            sys.exit(f"{scene}: {browser.messages}")
        if before:
            browser.run(f"(() => {{ {before} }})()")
        png = base64.b64decode(browser.ask("Page.captureScreenshot", clip=box_of(browser, first, last),
                                           captureBeyondViewport=True)["data"])
        browser.close()
        image = Image.open(io.BytesIO(png)).convert("RGB")
        image = image.quantize(256, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
        path = Path(output) / f"report_{name}.png"
        image.save(path, optimize=True)
        print(f"{path.name}: {image.width} x {image.height}, {path.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
