#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs pcl_sedr on random buildings and grades its rooms: random_buildings.py FIRST LAST [options]

For every seed from FIRST to LAST a building is made by random_building.py, scanned by pcl_simulate_indoor_scan, modelled by
pcl_sedr --no-mesh and graded against the truth. The table has a line a building; the summary comes last. A building is all
right if every room that counts is matched by one found room of 0.7 intersection over union or more, no other room of more
than 1.5 square metres is found, and the number of storeys is exact. Needs numpy, scipy and shapely, for pictures matplotlib.
Exit code 0: all buildings were graded, however well; 1: not all were.
"""
import argparse
import csv
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

from buildings.build import build
from buildings.kinds import KINDS

try:
    from buildings import grades, pictures
except ImportError as error:
    sys.exit(f"random_buildings.py: the Python package {error.name} is missing; on Debian: "
             "apt install python3-numpy python3-scipy python3-shapely python3-matplotlib, and use /usr/bin/python3")

ROOT = pathlib.Path(__file__).resolve().parents[2]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("first", type=int)
    parser.add_argument("last", type=int)
    parser.add_argument("--kind", choices=sorted(KINDS), help="all of this kind; else each seed chooses")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin", help="folder of the programs")
    parser.add_argument("--sedr", type=pathlib.Path, help="another pcl_sedr than that of --bin")
    parser.add_argument("--options", default="", help="options of pcl_sedr beside --no-mesh, in one argument")
    parser.add_argument("--csv", type=pathlib.Path, help="the table; else it goes to the standard output")
    parser.add_argument("--keep-failures", type=pathlib.Path, metavar="DIR",
                        help="where scene, scan, result and picture of buildings go that are not all right")
    parser.add_argument("--folder", type=pathlib.Path, help="where scans go while they are needed")
    parser.add_argument("--timeout", type=float, default=600, help="seconds a run of pcl_sedr may take")
    return parser.parse_args()


def run(command, timeout):
    """Exit code, seconds and the last line of the messages; 124 if the time was up."""
    start = time.monotonic()
    try:
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=timeout, check=False)
        code, text = done.returncode, done.stderr.decode(errors="replace").strip()
    except subprocess.TimeoutExpired:
        code, text = 124, f"no end after {timeout:g} s"
    return code, time.monotonic() - start, text.splitlines()[-1] if text else ""


def make(seed, folder, options):
    """Scene and scan of a seed; its row of the table so far."""
    start = time.monotonic()
    scene = build(seed, options.kind)
    (folder / "scene.json").write_text(json.dumps(scene), encoding="utf-8")
    kind = scene["name"].rsplit("_", 1)[0]
    code, _, text = run([options.bin / "pcl_simulate_indoor_scan", folder / "scene.json", folder, "--seed", str(seed)], 600)
    if code != 0:
        raise RuntimeError(f"seed {seed}: {text}")
    return {"seed": seed, "kind": kind, "points": (folder / "scan.pcd").stat().st_size // 20,
            "seconds_scan": round(time.monotonic() - start, 1)}


def one_building(seed, folder, options):
    row = make(seed, folder, options)
    sedr = options.sedr or options.bin / "pcl_sedr"
    output = folder / "out"
    command = [sedr, folder / "scan.pcd", output, "--no-mesh"] + shlex.split(options.options)
    row["exit"], seconds, text = run(command, options.timeout)
    row["seconds"] = round(seconds, 1)
    figures, graded = grades.grade(folder, output)
    row.update(figures)
    row["message"] = text if row["exit"] != 0 else ""
    if options.keep_failures and not row["all_right"]:
        kept = options.keep_failures / f"{row['kind']}_{seed}"
        shutil.rmtree(kept, ignore_errors=True)
        shutil.copytree(folder, kept)
        shown = ("rooms", "matched_0.7", "missed", "merged", "split", "shape", "extra", "storeys", "storeys_found")
        title = f"{row['kind']} {seed}: " + ", ".join(f"{k} {row[k]}" for k in shown)
        pictures.draw(kept / "rooms.png", title, graded, grades.read_points(folder / "scan.pcd"))
    return row


def summary(rows):
    """Shares and sums over all buildings, and of each kind those that are all right."""
    def total(key):
        return sum(r[key] for r in rows)
    share = 100 * total("all_right") / len(rows)
    lines = [f"{len(rows)} buildings, all rooms right in {total('all_right')} ({share:.0f} %)",
             f"storeys right in {sum(r['storeys'] == r['storeys_found'] for r in rows)}",
             "rooms: " + f"{total('rooms')} true, {total('rooms_found')} found, matched " +
             ", ".join(f"{total(f'matched_{s}')} at {s}" for s in grades.STEPS) +
             "; " + ", ".join(f"{total(k)} {k}" for k in ("missed", "merged", "split", "shape", "extra")),
             f"seconds of pcl_sedr: {total('seconds') / len(rows):.1f} on average, {max(r['seconds'] for r in rows):.1f} at most"]
    codes = sorted({r["exit"] for r in rows})
    lines.append("exit codes: " + ", ".join(f"{c}: {sum(r['exit'] == c for r in rows)}" for c in codes))
    for kind in sorted({r["kind"] for r in rows}):
        mine = [r for r in rows if r["kind"] == kind]
        lines.append(f"{kind}: {sum(r['all_right'] for r in mine)} of {len(mine)}, rooms "
                     f"{sum(r['matched_0.7'] for r in mine)} of {sum(r['rooms'] for r in mine)}")
    return "\n".join(lines)


def check(options):
    if options.last < options.first:
        sys.exit("random_buildings.py: LAST is less than FIRST")
    for program in (options.bin / "pcl_simulate_indoor_scan", options.sedr or options.bin / "pcl_sedr"):
        if not program.exists():
            sys.exit(f"random_buildings.py: there is no program {program}; build it, or see --bin and --sedr")


def main():
    options = arguments()
    check(options)
    rows, failed = [], 0
    table = open(options.csv, "w", newline="", encoding="utf-8") if options.csv else sys.stdout
    for seed in range(options.first, options.last + 1):
        with tempfile.TemporaryDirectory(dir=options.folder) as folder:
            try:
                row = one_building(seed, pathlib.Path(folder), options)
            except RuntimeError as error:
                print(f"random_buildings.py: {error}", file=sys.stderr)
                failed += 1
                continue
        writer = csv.DictWriter(table, row.keys())
        if not rows:
            writer.writeheader()
        writer.writerow(row)
        table.flush()
        rows.append(row)
    if rows:
        print(summary(rows))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
