# SPDX-License-Identifier: BSD-3-Clause
"""Scans, models and grades scenes, one by one: what random_buildings.py, random_shapes.py and others share."""
import argparse
import concurrent.futures
import csv
import importlib.util
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

from .build import build
from .kinds import KINDS

ROOT = pathlib.Path(__file__).resolve().parents[3]
NAME = pathlib.Path(sys.argv[0]).name


def require(*packages):
    """Ends with a sentence where a Python package is missing."""
    for name in packages:
        if not importlib.util.find_spec(name):
            sys.exit(f"{NAME}: the Python package {name} is missing; on Debian: apt install python3-{name}, and use /usr/bin/python3")


def parser(description, things=None):
    """Options of all; with `things` those of scenes by their seeds."""
    options = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    if things:
        options.add_argument("first", type=int)
        options.add_argument("last", type=int)
        options.add_argument("--keep-failures", type=pathlib.Path, metavar="DIR",
                             help=f"where scene, scan, result and picture (needs matplotlib) of {things} go that are not all right")
    if things == "buildings":
        options.add_argument("--kind", choices=sorted(KINDS), help="all of this kind; else each seed chooses")
    options.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin", help="folder of the programs")
    options.add_argument("--sedr", type=pathlib.Path, help="another pcl_sedr than that of --bin")
    options.add_argument("--options", default="", help="options of pcl_sedr, in one argument (%(default)s)")
    options.add_argument("--csv", type=pathlib.Path, help="the table; else it goes to the standard output")
    options.add_argument("--folder", type=pathlib.Path, help="where scans go while they are needed")
    options.add_argument("--jobs", type=int, default=1, help="how many at a time (%(default)s)")
    options.add_argument("--timeout", type=float, default=600, help="seconds a run of pcl_sedr may take")
    return options


def run(command, timeout):
    """Exit code, seconds and the last line of the messages; 124 if the time was up."""
    start = time.monotonic()
    try:
        done = subprocess.run([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=timeout, check=False)
        code, text = done.returncode, done.stderr.decode(errors="replace").strip()
    except subprocess.TimeoutExpired:
        code, text = 124, f"no end after {timeout:g} s"
    return code, time.monotonic() - start, text.splitlines()[-1] if text else ""


def output_of(command):
    """What a program prints that must not fail, within ten minutes."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, errors="replace", timeout=600, check=False)
    if done.returncode != 0:
        raise RuntimeError((done.stderr.strip().splitlines() or [f"{command[0]} ended with {done.returncode}"])[-1])
    return done.stdout


def scan(scene, seed, folder, options, *more):
    """Scan and truth of a scene; the row of the table so far."""
    start = time.monotonic()
    (folder / "scene.json").write_text(json.dumps(scene), encoding="utf-8")
    output_of([options.bin / "pcl_simulate_indoor_scan", folder / "scene.json", folder, "--seed", seed, *more])
    return {"seed": seed, "kind": scene["name"].rsplit("_", 1)[0], "points": (folder / "scan.pcd").stat().st_size // 20,
            "seconds_scan": round(time.monotonic() - start, 1)}


def model(folder, options, *more, with_mesh=False):
    """What pcl_sedr made of the scan, as columns of the table; its results are in folder/out."""
    command = [options.sedr or options.bin / "pcl_sedr", folder / "scan.pcd", folder / "out", *more, *([] if with_mesh else ["--no-mesh"])]
    code, seconds, text = run(command + shlex.split(options.options), options.timeout)
    return {"exit": code, "seconds": round(seconds, 1)}, text if code != 0 else ""


def building(seed, folder, options, is_measured):
    """The row so far of a building that was scanned and modelled, with the errors of real scans if it was measured."""
    row = scan(build(seed, options.kind), seed, folder, options)
    if is_measured:
        from . import instrument  # needs numpy
        instrument.spoil(folder, seed)
    figures, message = model(folder, options)
    return {**row, **figures, "message": message}


def keep(folder, row, options):
    """Where a scene that is not all right stays, with its scan and result; None if it need not."""
    if not options.keep_failures or row["all_right"]:
        return None
    kept = options.keep_failures / f"{row['kind']}_{row['seed']}"
    shutil.rmtree(kept, ignore_errors=True)
    shutil.copytree(folder, kept)
    return kept


def all_seeds(options, programs, one, summary):
    """Grades the scenes of all seeds by one(seed, folder, options), writes the table and prints its summary."""
    if options.last < options.first:
        sys.exit(f"{NAME}: LAST is less than FIRST")
    if options.keep_failures:
        require("matplotlib")
    all_rows(options, ["pcl_simulate_indoor_scan", *programs], range(options.first, options.last + 1), lambda *a: [one(*a)], summary)


def all_rows(options, programs, things, rows_of, summary, before=()):
    """Writes the table of what rows_of(thing, folder, options) gives, as it comes, behind the rows that it has; prints its summary."""
    for program in [options.bin / p for p in programs] + [options.sedr or options.bin / "pcl_sedr"]:
        if not program.exists():
            sys.exit(f"{NAME}: there is no program {program}; build it, or see --bin and --sedr")
    rows, failed = list(before), 0
    table = open(options.csv, "a" if before else "w", newline="", encoding="utf-8") if options.csv else sys.stdout

    def of(thing):
        with tempfile.TemporaryDirectory(dir=options.folder) as folder:
            return list(rows_of(thing, pathlib.Path(folder), options))

    pool = concurrent.futures.ThreadPoolExecutor(options.jobs)
    try:
        for done in concurrent.futures.as_completed([pool.submit(of, thing) for thing in things]):
            try:
                for row in done.result():
                    writer = csv.DictWriter(table, row.keys(), lineterminator="\n")
                    if not rows:
                        writer.writeheader()
                    writer.writerow(row)
                    table.flush()
                    rows.append(row)
            except (OSError, RuntimeError, ValueError) as error:
                print(f"{NAME}: {error}", file=sys.stderr)
                failed += 1
    finally:
        pool.shutdown(cancel_futures=True)
    if rows:
        print(summary(rows))
    sys.exit(1 if failed else 0)
