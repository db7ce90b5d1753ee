#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the proving ground (doc/proving_ground.md): proving_ground.py RUNS.csv [options]

Scans scenes in the simulator, reconstructs them with pcl_sedr and compares the results with the truth. Every run adds a line
to RUNS.csv when it ends and prints one; a run that fails is a row like any other. Needs numpy, scipy and shapely.
Exit code 0: all runs were made, however good; 1: bad options.
"""
import argparse
import concurrent.futures
import csv
import io
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading

import proving_ground_table
from buildings.runs import ROOT
from proving import bars

try:
    from proving import figures, meshes
except ImportError as problem:
    sys.exit(f"proving_ground.py: the Python package {problem.name} is missing; on Debian: "
             "apt install python3-numpy python3-scipy python3-shapely, and use /usr/bin/python3")

COLUMNS = """scene noise seed with_mesh points failure rooms_true rooms_found rooms_matched area_error height_error volume_error
mesh_volume_error corners_true corners_found rooms_with_other_corners corner_distance_max arcs_true arcs_found radius_error
perimeter_error solid_components solid_closed_manifold solid_self_intersections solid_triangles truth_to_solid_mean
truth_to_solid_max solid_to_truth_mean solid_to_truth_max solid_volume_error solid_wall_area_error components closed edge_manifold
vertex_manifold closed_manifold truth_to_mesh_mean truth_to_mesh_rms truth_to_mesh_p95 truth_to_mesh_max truth_within_1cm
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

    def key(self):
        return tuple(text(self.row()[column]) for column in ("scene", "noise", "seed", "with_mesh"))

    def simulate(self):
        command = [self.program("pcl_simulate_indoor_scan"), self.scene]
        scan = ["--seed", self.seed, "--noise", self.noise, "--threads", self.threads]
        scan += ["--rays", self.options.rays] if self.options.rays else []
        figures.output_of([*command, self.folder, *scan])
        figures.output_of([*command, self.folder / "fine", "--chord-tolerance", "1e-5", "--rays", 1])

    def reconstruct(self):
        """Runs pcl_sedr; why there is no result, or nothing."""
        more = ["--prior", self.options.prior] if self.options.prior else []
        more += ["--no-mesh"] if self.options.no_mesh else []
        more += ["--positions", self.folder / "positions.txt"] if self.options.positions else []
        command = [self.program("pcl_sedr"), self.folder / "scan.pcd", self.out, "--partial", "--threads", self.threads, *more]
        done = subprocess.run([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
        if done.returncode < 0:
            return f"the run was ended by signal {-done.returncode} ({signal.strsignal(-done.returncode)})"
        lines = done.stderr.decode(errors="replace").strip().splitlines()
        return "" if done.returncode == 0 else lines[-1] if lines else f"pcl_sedr ended with {done.returncode}"

    def measured(self, folder):
        """The row of the run, whose files go to `folder`."""
        self.folder, self.out = folder, folder / "out"
        row = self.row()
        try:
            self.simulate()
            row["points"] = meshes.point_count(folder / "scan.pcd")
            row["rooms_true"] = len(json.loads((folder / "truth.json").read_text(encoding="utf-8"))["rooms"])
            row["rooms_found"] = row["rooms_matched"] = 0
            row["failure"] = self.reconstruct()
            if not row["failure"]:
                figures.measure(self, row)
        except RuntimeError as error:
            row["failure"] = str(error)
        misses = bars.missed(row)
        row["missed_bars"] = ";".join(bar for bar, _ in misses)
        row["missed"] = "; ".join(words for _, words in misses)
        return row

    def done(self):
        """The row, of a run in a folder of its own that is kept if the options say so."""
        if self.options.keep:
            folder = self.options.keep / f"{self.name}_n{self.noise:g}_s{self.seed}"
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir(parents=True)
            return self.measured(folder)
        with tempfile.TemporaryDirectory() as name:
            return self.measured(pathlib.Path(name))


def text(value):
    """A cell: seven significant digits; what is not known is empty."""
    if value is None:
        return ""
    if isinstance(value, float):
        return f"{value:.7g}"
    return str(int(value)) if not isinstance(value, str) else " ".join(value.splitlines())


def told(row):
    start = f"{row['scene']:<16} {100 * row['noise']:5.2f} cm  seed {row['seed']:<3} "
    if row["failure"]:
        return f"{start}failed: {row['failure']}"
    mean, share, what = (("truth_to_mesh_mean", "truth_within_5cm", ", mean {:.3f} cm, within 5 cm {:.2f} %") if row["with_mesh"] else
                         ("points_to_truth_mean", "truth_covered", ", points: mean {:.3f} cm, covered {:.2f} %"))
    line = f"{start}{row['rooms_found']}/{row['rooms_true']} rooms" + what.format(100 * row[mean], 100 * row[share])
    return f"{line}, {row['seconds']:.1f} s" + (f"; {row['missed']}" if row["missed"] else "")


def rows_before(path):
    """The runs that a file has; a last line without line end, of an interrupted run, is cut off. Writes the columns' names."""
    content = path.read_text(encoding="utf-8") if path.exists() else ""
    content = content[:content.rfind("\n") + 1] or ",".join(COLUMNS) + "\n"
    lines = list(csv.reader(io.StringIO(content, newline="")))
    if lines[0] != COLUMNS:
        sys.exit(f"proving_ground.py: '{path}' has other columns than the rows that would be added to it")
    path.write_text(content, encoding="utf-8")
    return {tuple(line[:4]) for line in lines[1:]}


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
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", type=pathlib.Path, metavar="RUNS.csv", help="the table; runs that it has are not repeated")
    parser.add_argument("--scenes", default="all", help="built-in scenes and JSON files, with commas; all: the built-in ones")
    parser.add_argument("--noise", type=listed(float, "numbers from 0 to 1", 0, 1), default=[0.001, 0.005, 0.01, 0.02],
                        help="standard deviations in metres, with commas; 0.001,0.005,0.01,0.02")
    parser.add_argument("--seeds", type=listed(int, "whole numbers", 0, 2 ** 63), default=[1, 2, 3], help="of the simulator; 1,2,3")
    parser.add_argument("--no-mesh", action="store_true", help="stop at the structure's points and the solids")
    parser.add_argument("--positions", action="store_true", help="tell the positions of the scanner")
    parser.add_argument("--prior", metavar="NAME=VALUE,...", help="what is believed before a scan is looked at, for pcl_sedr")
    parser.add_argument("--rays", type=int, default=0, help="rays a scanner position; 0: the scene's own")
    parser.add_argument("--keep", type=pathlib.Path, metavar="DIR", help="where the files of every run stay")
    parser.add_argument("--table", type=pathlib.Path, metavar="FILE.md", help="writes the table of proving_ground_table.py at the end")
    parser.add_argument("--jobs", type=int, default=1, help="runs at a time; each gets its share of the processors")
    parser.add_argument("--threads", type=int, help="threads of a run, 0 for all processors")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin", help="folder of the programs")
    options = parser.parse_args()
    if options.threads is None:
        options.threads = max(1, (os.cpu_count() or 1) // options.jobs)
    return options


def main():
    options = options_of()
    simulator = options.bin / "pcl_simulate_indoor_scan"
    for name in ("pcl_simulate_indoor_scan", "pcl_sedr", "pcl_mesh_evaluation", "pcl_label_evaluation"):
        if not (options.bin / name).exists():
            sys.exit(f"proving_ground.py: there is no program {options.bin / name}; build it, or see --bin")
    try:
        known = [line.split()[0] for line in figures.output_of([simulator, "--list"]).splitlines() if line[:1].strip()]
        scenes = known if options.scenes == "all" else options.scenes.split(",")
        for scene in scenes:
            if scene not in known and not (scene.endswith(".json") and pathlib.Path(scene).exists()):
                sys.exit(f"proving_ground.py: there is no scene '{scene}'; known are {', '.join(known)}, and files that end in .json")
        present = rows_before(options.csv)
    except (OSError, RuntimeError) as error:
        sys.exit(f"proving_ground.py: {error}")
    runs = [Run(scene, noise, seed, options) for scene in scenes for noise in options.noise for seed in options.seeds]
    lock = threading.Lock()

    def one(run):
        row = run.done()
        with lock, open(options.csv, "a", newline="", encoding="utf-8") as file:
            csv.writer(file, lineterminator="\n").writerow([text(row.get(column)) for column in COLUMNS])
            print(told(row), flush=True)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for done in [pool.submit(one, run) for run in runs if run.key() not in present]:
            done.result()
    if options.table:
        options.table.write_text(proving_ground_table.table(proving_ground_table.read(options.csv)), encoding="utf-8")


if __name__ == "__main__":
    main()
