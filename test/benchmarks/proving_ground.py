#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the proving ground (doc/proving_ground.md): proving_ground.py RUNS.csv [options]

Scans scenes in the simulator, reconstructs them with pcl_sedr and compares the results with the truth. Every run adds a line
to RUNS.csv when it ends and prints one; a run that fails is a row like any other. Needs numpy, scipy and shapely.
Exit code 0: all runs were made, however good; 1: bad options, nothing was run; 130: interrupted, call it again to go on.
"""
import argparse
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import shutil
import signal
import sys
import tempfile
import threading

import proving_ground_table
from buildings import runs
from proving import bars

runs.require("numpy", "scipy", "shapely")
from proving import figures, meshes, programs  # noqa: E402

COLUMNS = """scene noise seed with_mesh points failure rooms_true rooms_found rooms_matched area_error height_error volume_error
mesh_volume_error corners_true corners_found rooms_with_other_corners corner_distance_max arcs_true arcs_found radius_error
perimeter_error solid_components solid_closed_manifold solid_self_intersections solid_triangles truth_to_solid_mean
truth_to_solid_max solid_to_truth_mean solid_to_truth_max solid_volume_error solid_wall_area_error components closed
closed_manifold truth_to_mesh_mean truth_to_mesh_rms truth_to_mesh_p95 truth_to_mesh_max truth_within_1cm
truth_within_5cm mesh_to_truth_mean mesh_to_truth_p95 mesh_to_truth_max mesh_beyond_5cm detail_within_1cm detail_within_5cm
points_to_truth_mean points_to_truth_max points_beyond_5cm truth_covered ceiling_recall ceiling_precision floor_recall
floor_precision wall_recall wall_precision detail_recall detail_precision seconds stage_seconds warnings missed_bars
missed""".split()


class Run:
    """One scene at one noise and seed: where its files and the programs are."""

    def __init__(self, scene, noise, seed, options):
        self.scene, self.noise, self.seed, self.options = scene, noise, seed, options
        self.name = json.loads(pathlib.Path(scene).read_text(encoding="utf-8"))["name"] if scene.endswith(".json") else scene
        self.threads = options.threads

    def program(self, name):
        return self.options.bin / name

    def row(self):
        return {"scene": self.name, "noise": self.noise, "seed": self.seed, "with_mesh": not self.options.no_mesh}

    def kept(self):
        return self.options.keep / f"{self.name}_n{self.noise:g}_s{self.seed}"

    def key(self):
        return tuple(text(self.row()[column]) for column in ("scene", "noise", "seed", "with_mesh"))

    def simulate(self):
        command = [self.program("pcl_simulate_indoor_scan"), self.scene]
        scan = ["--seed", self.seed, "--noise", self.noise, "--threads", self.threads]
        scan += ["--rays", self.options.rays] if self.options.rays else []
        programs.output_of([*command, self.folder, *scan])

    def reconstruct(self):
        more = ["--prior", self.options.prior] if self.options.prior else []
        more += ["--no-mesh"] if self.options.no_mesh else []
        more += ["--positions", self.folder / "positions.txt"] if self.options.positions else []
        programs.output_of([self.program("pcl_sedr"), self.folder / "scan.pcd", self.out, "--partial", "--threads", self.threads, *more])

    def measured(self, folder):
        """The row of the run, whose files go to `folder`."""
        self.folder, self.out = folder, folder / "out"
        row = self.row()
        try:
            self.simulate()
            row["points"] = meshes.point_count(folder / "scan.pcd")
            row["rooms_true"] = len(json.loads((folder / "truth.json").read_text(encoding="utf-8"))["rooms"])
            row["rooms_found"] = row["rooms_matched"] = 0
            self.reconstruct()
            figures.measure(self, row)
        except Exception as error:  # whatever it is, the other runs go on
            row["failure"] = str(error) if isinstance(error, RuntimeError) else f"{type(error).__name__}: {error}"
        misses = bars.missed(row)
        row["missed_bars"] = ";".join(bar for bar, _ in misses)
        row["missed"] = "; ".join(words for _, words in misses)
        return row

    def done(self):
        """The row, of a run in a folder of its own that is kept if the options say so."""
        if self.options.keep:
            self.kept().mkdir(parents=True)
            row = self.measured(self.kept())
            if programs.STOPPED.is_set():
                shutil.rmtree(self.kept())
            return row
        with tempfile.TemporaryDirectory() as name:
            return self.measured(pathlib.Path(name))


def text(value):
    """A cell: seven significant digits; what is not known is empty."""
    if value is None or isinstance(value, float) and not math.isfinite(value):
        return ""
    if isinstance(value, float):
        return f"{value:.7g}"
    return str(int(value)) if not isinstance(value, str) else " ".join(value.splitlines())


def told(row):
    start = f"{row['scene']:<16} {100 * row['noise']:5.2f} cm  seed {row['seed']:<3} "
    if row.get("failure"):
        return f"{start}failed: {row['failure']}"
    mean, share, what = (("truth_to_mesh_mean", "truth_within_5cm", ", mean {:.3f} cm, within 5 cm {:.2f} %") if row["with_mesh"] else
                         ("points_to_truth_mean", "truth_covered", ", points: mean {:.3f} cm, covered {:.2f} %"))
    line = f"{start}{row['rooms_found']}/{row['rooms_true']} rooms" + what.format(100 * row[mean], 100 * row[share])
    return f"{line}, {row['seconds']:.1f} s" + (f"; {row['missed']}" if row["missed"] else "")


def rows_before(path):
    """The runs that a file has; a last line without line end, of an interrupted run, is cut off. Writes the columns' names."""
    with open(path, "a+b") as file:
        file.seek(0)
        content = file.read()
        content = content[:content.rfind(b"\n") + 1]
        names, *lines = csv.reader(content.decode().splitlines() or [",".join(COLUMNS)])
        if names != COLUMNS:
            raise ValueError(f"'{path}' has other columns than the rows that would be added to it")
        file.truncate(len(content))
        file.write(b"" if content else (",".join(COLUMNS) + "\n").encode())
    return {tuple(line[:4]) for line in lines}


class Parser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(1, f"{self.prog}: {message}\n")


def between(low, high):
    def parse(word):
        if not word.isdecimal() or not low <= int(word) <= high:
            raise argparse.ArgumentTypeError(f"takes a whole number from {low} to {high}, not '{word}'")
        return int(word)
    return parse


def listed(kind, what, low, high):
    def parse(words):
        try:
            values = [kind(word) for word in words.split(",")]
        except ValueError:
            values = []
        if not values or not all(low <= value <= high for value in values):
            raise argparse.ArgumentTypeError(f"takes {what} with commas between them, not '{words}'")
        return values
    return parse


def options_of():
    parser = Parser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", type=pathlib.Path, metavar="RUNS.csv", help="the table; runs that it has are not repeated")
    parser.add_argument("--scenes", default="all", help="built-in scenes and JSON files, with commas; all: the built-in ones")
    parser.add_argument("--noise", type=listed(float, "numbers from 0 to 1", 0, 1), default=[0.001, 0.005, 0.01, 0.02],
                        help="standard deviations in metres, with commas; 0.001,0.005,0.01,0.02")
    parser.add_argument("--seeds", type=listed(int, "whole numbers", 0, 2 ** 63), default=[1, 2, 3], help="of the simulator; 1,2,3")
    parser.add_argument("--no-mesh", action="store_true", help="stop at the structure's points and the solids")
    parser.add_argument("--positions", action="store_true", help="tell the positions of the scanner")
    parser.add_argument("--prior", metavar="NAME=VALUE,...", help="what is believed before a scan is looked at, for pcl_sedr")
    parser.add_argument("--rays", type=between(0, 10 ** 8), default=0, help="rays a scanner position; 0: the scene's own")
    parser.add_argument("--keep", type=pathlib.Path, metavar="DIR", help="where the files of every run stay")
    parser.add_argument("--table", type=pathlib.Path, metavar="FILE.md", help="writes the table of proving_ground_table.py at the end")
    parser.add_argument("--jobs", type=between(1, 256), default=1, help="runs at a time; each gets its share of the processors")
    parser.add_argument("--threads", type=between(0, 256), help="threads of a run, 0 for all processors")
    parser.add_argument("--bin", type=pathlib.Path, default=runs.ROOT / "build/release/bin", help="folder of the programs")
    options = parser.parse_args()
    options.bin = options.bin.resolve()
    if options.threads is None:
        options.threads = max(1, (os.cpu_count() or 1) // options.jobs)
    return options


def runs_of(options):
    """All runs. Whatever the programs refuse is said before the first one: a RuntimeError, OSError or ValueError."""
    for name in ("pcl_simulate_indoor_scan", "pcl_sedr", "pcl_mesh_evaluation"):
        if not (options.bin / name).exists():
            raise ValueError(f"there is no program {options.bin / name}; build it, or see --bin")
    simulator = options.bin / "pcl_simulate_indoor_scan"
    known = [line.split()[0] for line in programs.output_of([simulator, "--list"]).splitlines() if line[:1].strip()]
    scenes = known if options.scenes == "all" else options.scenes.split(",")
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            if scene not in known and not scene.endswith(".json"):
                raise ValueError(f"there is no scene '{scene}'; known are {', '.join(known)}, and files that end in .json")
            programs.output_of([simulator, scene, folder, "--rays", 1])
        if options.prior:  # the scan is too small for a result: exit code 2
            programs.output_of([options.bin / "pcl_sedr", f"{folder}/scan.pcd", f"{folder}/out", "--prior", options.prior], 2)
    asked = [Run(scene, noise, seed, options) for scene in scenes for noise in options.noise for seed in options.seeds]
    if len({run.key() for run in asked}) < len(asked):
        raise ValueError("a scene, noise or seed is there twice")
    if options.table:
        options.table.open("a", encoding="utf-8").close()
    return asked


def new_runs(options):
    """The runs that the table does not have."""
    asked = runs_of(options)
    present = rows_before(options.csv)
    new = [run for run in asked if run.key() not in present]
    if len(new) < len(asked):
        print(f"{len(asked) - len(new)} of {len(asked)} runs are in {options.csv} already, whatever their other options were", flush=True)
    for run in new:
        if options.keep and run.kept().exists():
            raise ValueError(f"'{run.kept()}' is there already and would be overwritten")
    return new


def make(new, options):
    lock = threading.Lock()

    def one(run):
        row = run.done()
        with lock, open(options.csv, "a", newline="", encoding="utf-8") as file:
            if not programs.STOPPED.is_set():
                csv.writer(file, lineterminator="\n").writerow([text(row.get(column)) for column in COLUMNS])
                print(told(row), flush=True)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        started = []
        try:
            started += [pool.submit(one, run) for run in new]
            for done in started:
                done.result()
        except BaseException:
            programs.stop()
            for waiting in started:
                waiting.cancel()
            raise
    if options.table:
        options.table.write_text(proving_ground_table.table(proving_ground_table.read(options.csv)), encoding="utf-8")


def main():
    options = options_of()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        make(new_runs(options), options)
    except (OSError, RuntimeError, ValueError, csv.Error) as error:
        sys.exit(f"proving_ground.py: {error}")
    except KeyboardInterrupt:
        print(f"proving_ground.py: interrupted; {options.csv} has the runs that were made", file=sys.stderr)
        sys.exit(130)


if __name__ == "__main__":
    main()
