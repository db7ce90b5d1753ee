#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what doc/performance.md tells, prints its tables and draws its plots: performance.py OUT_DIR [options]

Scans are made by pcl_simulate_indoor_scan or here. Seconds of stages are those that pcl_sedr reports, of what PCL has those of
benchmark_pcl (-DSEDR_BUILD_BENCHMARKS=ON). What OUT_DIR has is not measured again. Have nothing else run beside it: half an hour on
two cores, and 4.8 GB of the disk for 300 million points. Needs numpy and matplotlib.
"""
import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from buildings.runs import ROOT
from proving import meshes, pcd

SCENES = {"bls_room": 47_000, "hls_hall": 37_700, "syn_flat": 375_500}  # rays of a position for three million points
CLOUDS = {"3 M": (3, False), "30 M": (30, False), "50 M": (50, False), "30 M at random": (30, True), "50 M at random": (50, True)}
MORE_POINTS, MORE_ROOMS = ((4, 0.04), (4, 0.02), (4, 0.01)), ((1, 0.025), (4, 0.025), (16, 0.025), (64, 0.025))  # rooms, spacing
PLAN, SOLID, MESH = "StructureRefinement", "StructuralPoisson", "MeshEvaluation"  # the stages behind them


def run(command):
    """Output, seconds, processor seconds and peak memory (MiB) of a program that must not fail."""
    start = time.monotonic()
    process = subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{command[0]} failed")
    return output, time.monotonic() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def scan_of(millions, is_random):
    """Points of scans of adjacent rooms of 6 x 5 x 2.8 m, a million a room, column by column, with noise of 2 mm along the ray."""
    rng = np.random.default_rng(1)
    azimuth, height = np.meshgrid(2 * np.pi * np.arange(1250) / 1250, (np.arange(800) + 0.5) / 800 * (1.1 + np.pi / 2) - 1.1, indexing="ij")
    way = np.stack([np.cos(azimuth) * np.cos(height), np.sin(azimuth) * np.cos(height), np.sin(height)], -1).reshape(-1, 3)
    reach = (np.where(way > 0, (3.4, 2.2, 1.3), (2.6, 2.8, 1.5)) / np.maximum(np.abs(way), 1e-9)).min(1)
    points = np.empty((millions, len(way), 3), "f4")
    for room in range(millions):
        points[room] = way * (reach + rng.normal(0, 0.002, len(way)))[:, None] + (6.2 * (room % 8), 5.2 * (room // 8), 0)
    points = points.reshape(-1, 3)
    return rng.permutation(points) if is_random else points


def storey_of(rooms, spacing):
    """Points on adjacent rooms of 5 x 4 m with a soffit along a wall, and noise of 5 mm."""
    rng, parts = np.random.default_rng(1), []
    plates = (((0, 0, 0), (5, 4, 0)), ((0, 0.8, 2.6), (5, 4, 2.6)), ((0, 0, 2.3), (5, 0.8, 2.3)), ((0, 0.8, 2.3), (5, 0.8, 2.6)),
              ((0, 0, 0), (0, 4, 2.6)), ((5, 0, 0), (5, 4, 2.6)), ((0, 0, 0), (5, 0, 2.3)), ((0, 4, 0), (5, 4, 2.6)))
    for room in range(rooms):
        for low, high in plates:
            steps = [np.arange(a + spacing / 2, b, spacing) if b > a else np.array([a]) for a, b in zip(low, high)]
            plate = np.stack(np.meshgrid(*steps), -1).reshape(-1, 3)
            plate = plate[(plate[:, 1] >= 0.8) | (plate[:, 2] <= 2.3)]  # nothing above the soffit
            plate[:, np.equal(low, high)] += rng.normal(0, 0.005, (len(plate), 1))
            parts.append(plate + (5.12 * (room % 8), 4.12 * (room // 8), 0))
    return np.concatenate(parts)


def write_copies(path, points):
    """Makes a storey of a scan: copies side by side, some `points` in all."""
    rows, header = pcd.read(path), path.read_bytes()[:1000]
    header = header[:header.index(b"DATA binary\n") + 12]
    rows = rows[rows["room"] > 0]  # without what is outside
    pitch = [np.ptp(rows[axis]) + 0.3 for axis in "xy"]  # 30 cm of wall between
    copies = max(1, round(points / len(rows)))
    in_row = max(1, round((copies * pitch[1] / pitch[0]) ** 0.5))
    with path.open("wb") as file:
        file.write(re.sub(rb"(WIDTH|POINTS) \d+", rb"\1 %d" % (copies * len(rows)), header))
        for copy in range(copies):
            moved = rows.copy()
            for axis, step, place in zip("xy", pitch, (copy % in_row, copy // in_row)):
                moved[axis] += np.float32(step * place)
            moved["room"] += copy * rows["room"].max()
            file.write(moved.tobytes())


class Measurements:
    """Medians of figures, kept in a folder."""

    def __init__(self, options):
        self.out, self.options = options.out, options

    def program(self, name):
        return self.options.bin / name

    def of(self, name, make, measure, times):
        """The medians of what measure(scan) gives, of a scan that make(path) writes."""
        known, scan = self.out / f"{name}.json", self.out / "scan.pcd"
        if not known.exists():
            make(scan)
            runs = [measure(scan) for _ in range(times)]
            scan.unlink()
            known.write_text(json.dumps({key: statistics.median_low([r[key] for r in runs]) for key in runs[0]}), encoding="utf-8")
            print(f"{name}: measured", file=sys.stderr)
        return json.loads(known.read_text(encoding="utf-8"))

    def simulate(self, scene, *options):
        return lambda _: run([self.program("pcl_simulate_indoor_scan"), scene, self.out, *options])

    def pcl(self, scan, *options):
        """Seconds and memory of what PCL has, by name."""
        rows = re.findall(r"^measured (\S+) (\S+) (\S+)$", run([self.program("benchmark_pcl"), scan, *options])[0], re.M)
        return {key: float(value) for name, *values in rows for key, value in zip((name, name + "_MiB"), values)}

    def sedr(self, scan, *options):
        """What pcl_sedr takes: in all, each stage, and from the file to the plan, the solid and the mesh."""
        _, seconds, processor, memory = run([self.program("pcl_sedr"), scan, self.out / "model", *options])
        report = json.loads((self.out / "model/report.json").read_text(encoding="utf-8"))
        row = {"points": report["input"]["points"], "bytes": scan.stat().st_size, "rooms": len(report["rooms"]),
               "voxels": next(s["points_out"] for s in report["stages"] if s["stage"] == "ParallelVoxelGrid"),
               "seconds": seconds, "processor_seconds": processor, "peak_MiB": memory}
        names = [stage["stage"] for stage in report["stages"]]
        taken = [stage["seconds"] for stage in report["stages"]]
        row.update({end: sum(taken[:names.index(behind)]) for end, behind in (("to plan", PLAN), ("to solid", SOLID), ("to mesh", MESH))
                    if behind in names})
        return {**row, **dict(zip(names, taken))}

    def both(self, pcl_options=(), sedr_options=()):
        def measure(scan):
            start = time.monotonic()
            scan.read_bytes()
            return {"bytes read": time.monotonic() - start, **self.pcl(scan, *pcl_options), **self.sedr(scan, *sedr_options)}
        return measure


def table(header, rows):
    for cells in (header, ["---"] * len(header), *rows):
        print("| " + " | ".join(map(str, cells)) + " |")
    print()


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def thinning(m):
    rows = []
    for name, (millions, is_random) in CLOUDS.items():
        r = m.of(f"thinning_{name.replace(' ', '_')}", lambda scan: meshes.write_xyz(scan, scan_of(millions, is_random)), m.pcl, 5)
        seconds = [r[key] for key in ("VoxelGrid", "ParallelVoxelGrid_1", "ParallelVoxelGrid_2")]
        rows.append([name] + [f"{s:.3f}" for s in seconds] + [f"{seconds[0] / s:.1f}" for s in seconds[1:]]
                    + [f"{r['VoxelGrid_MiB']:.0f}, {r['ParallelVoxelGrid_1_MiB']:.0f}"])
    table(["points", "`pcl::VoxelGrid`, s", "1 thread", "2 threads", "ratio", "ratio", "MiB beside the input"], rows)


def chain(m):
    figure, axes = plt.subplots(figsize=(8, 3.2))
    rows, ends = [], ("to plan", "to solid", "to mesh", "ChainOfPclsParts")
    for k, scene in enumerate(SCENES):
        r = m.of(f"chain_{scene}", m.simulate(scene, "--noise", 0.01), m.both(["chain"]), 5)
        rows.append([f"`{scene}`"] + [f"{r[key]:.2f}" for key in ("bytes read", "VoxelGrid", *ends)]
                    + [f"{ratio:.1f}" for ratio in (r["to plan"] / r["VoxelGrid"], r[ends[3]] / r["to solid"], r[ends[3]] / r["to mesh"])])
        axes.barh([k + 0.25 * i - 0.25 for i in range(3)], [r[end] for end in ends[1:]], height=0.22, color=["#2a6f97", "#61a5c2", "#bb4430"])
    axes.set_yticks(range(len(SCENES)), SCENES)
    axes.set_xlabel("seconds: to the solid, to the mesh, and a chain of PCL's parts")
    save(figure, m.out / "performance_chain.png")
    table(["scene", "the file's bytes", "`pcl::VoxelGrid` alone", "file to plan", "file to solid", "file to mesh", "chain of PCL's parts",
           "plan: times `pcl::VoxelGrid`", "solid: times faster", "mesh: times faster"], rows)


def plans(m):
    rows = []
    for millions in (3, 30):
        for scene, rays in SCENES.items():
            r = m.of(f"plan_{scene}_{millions}", m.simulate(scene, "--noise", 0.01, "--rays", rays * millions // 3), m.both((), ["--no-mesh"]), 5)
            rows.append([f"`{scene}`, {millions} million points"] + [f"{r[key]:.3f}" for key in ("bytes read", "VoxelGrid", "to plan")]
                        + [f"{r['to plan'] / r['VoxelGrid']:.2f}", f"{r['to plan'] / r['bytes read']:.1f}"])
    table(["scene", "the file's bytes", "`pcl::VoxelGrid`", "file to plan", "times `pcl::VoxelGrid`", "times the bytes"], rows)


def log_plot(axis, x, y, title, **look):
    axis.loglog(x, y, marker="o", **look)
    axis.set_xlabel("points")
    axis.set_title(title)
    axis.grid(alpha=0.3)


def stages(m):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.6), sharey=True)
    shown = []
    for axis, title, sizes in ((axes[0], "four rooms, more points", MORE_POINTS), (axes[1], "more rooms, as dense", MORE_ROOMS)):
        rows = [m.of(f"stages_{rooms}_{1000 * spacing:.0f}", lambda scan: meshes.write_xyz(scan, storey_of(rooms, spacing)), m.sedr, 3)
                for rooms, spacing in sizes]
        names = [name for name in rows[0] if name[0].isupper() and name != MESH]
        for k, name in enumerate(names):
            log_plot(axis, [r["points"] for r in rows], [max(r[name], 1e-5) for r in rows], title, markersize=3,
                     color=plt.get_cmap("tab20")(k), label=name)
        shown += rows
    axes[0].set_ylabel("seconds")
    axes[1].legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
    save(figure, m.out / "performance_stages.png")
    table(["stage, s"] + [f"{r['points'] / 1e6:.2f} M, rooms: {r['rooms']}" for r in shown],
          [[name] + [f"{r[name]:.3f}" for r in shown] for name in names])


def buildings(m):
    rows = []
    for millions in m.options.millions:
        def make(scan):
            m.simulate("syn_flat")(scan)
            write_copies(scan, millions * 1e6)
        rows.append(m.of(f"building_{millions:g}", make, lambda scan: m.sedr(scan, "--no-mesh"), 1))
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4))
    points = [r["points"] for r in rows]
    for axis, key, title in ((axes[0], "seconds", "seconds"), (axes[1], "peak_MiB", "MiB at the most")):
        log_plot(axis, points, [r[key] for r in rows], title)
    save(figure, m.out / "performance_buildings.png")
    shown = ["points", "bytes", "rooms", "voxels", "seconds", "processor_seconds", "ParallelVoxelGrid", "peak_MiB"]
    table(shown, [[f"{r[key]:,.1f}" if isinstance(r[key], float) else f"{r[key]:,}" for key in shown] for r in rows])
    for key in ("seconds", "processor_seconds") if len(rows) > 1 else ():
        print(f"{key} grow with an exponent of {np.polyfit(np.log(points), np.log([r[key] for r in rows]), 1)[0]:.2f}")


def main():
    parts = {part.__name__: part for part in (thinning, chain, plans, stages, buildings)}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path, metavar="OUT_DIR")
    parser.add_argument("--millions", type=float, nargs="+", default=[10, 30, 100], help="points of the buildings, in millions")
    parser.add_argument("--parts", nargs="+", choices=parts, default=list(parts), help="these only")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/benchmarks/bin", help="folder of the programs")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    for name in options.parts:
        parts[name](Measurements(options))


if __name__ == "__main__":
    main()
