#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tables and plots of doc/performance.md from what performance.sh measured.

    test/benchmarks/performance_tables.py OUT_DIR

prints the tables as Markdown and writes performance_stages.png, performance_chain.png and
performance_buildings.png into OUT_DIR. Needs matplotlib.
"""
import csv
import json
import math
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SCENES = ["bls_room", "hls_hall", "syn_flat"]
CHAINS = {
    "Reading": "the file's bytes",
    "VoxelGrid": "`pcl::VoxelGrid` alone",
    "SedrToThePlan": "file to plan",
    "SedrToTheSolid": "file to solid",
    "SedrToTheMesh": "file to mesh",
    "ChainOfPclsParts": "chain of PCL's parts",
}
STAGES = [
    "ParallelVoxelGrid", "HorizontalPlaneDetection", "GridRegionOutlierRemoval",
    "RoomSegmentation", "GridSliceDetail", "FloorProjectionRecovery",
    "CeilingBoundaryWallGrowing", "FloorplanFitting", "StructureRefinement",
    "VerticalHoleRepair", "FloorplanExtrusion", "StructuralPoisson",
]


def medians(path):
    """The median of each benchmark, by its name and arguments."""
    runs = json.loads(path.read_text())["benchmarks"]
    return {run["run_name"].split("/iterations")[0]: run
            for run in runs if run.get("aggregate_name") == "median"}


def table(header, rows):
    print("| " + " | ".join(header) + " |")
    print("|" + "---|" * len(header))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print()


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def thinning(out):
    rows = []
    runs = {}
    for cloud in ("3_0", "30_0", "50_0", "30_1", "50_1"):  # million points, whether shuffled
        runs.update(medians(out / f"thinning_{cloud}.json"))
    for name, run in runs.items():
        if not name.startswith("VoxelGrid"):
            continue
        where = name.split("/", 1)[1]
        ours = [runs[f"ParallelVoxelGrid/{where}/threads:{k}"] for k in (1, 2)]
        rows.append([where.split("/")[0].split(":")[1] + " M", run["label"]]
                    + [f"{r['real_time'] / 1000:.3f}" for r in [run] + ours]
                    + [f"{run['real_time'] / r['real_time']:.1f}" for r in ours]
                    + [f"{run['MiB']:.0f}, {ours[0]['MiB']:.0f}"])
    table(["points", "order", "`pcl::VoxelGrid`, s", "1 thread", "2 threads", "ratio", "ratio",
           "MiB beside the input"], rows)


def chain(out):
    figure, axes = plt.subplots(figsize=(8, 3.2))
    rows = []
    for k, scene in enumerate(SCENES):
        runs = medians(out / f"chain_{scene}.json")
        seconds = [runs[name]["real_time"] / 1000 for name in CHAINS]
        read, voxels, plan, solid, mesh, by_hand = seconds
        rows.append([f"`{scene}`", f"{read:.3f}"] + [f"{s:.2f}" for s in seconds[1:]]
                    + [f"{ratio:.1f}" for ratio in (plan / voxels, plan / read, by_hand / solid,
                                                    by_hand / mesh)])
        axes.barh([k + 0.25 * i - 0.25 for i in range(3)], seconds[3:], height=0.22,
                  color=["#2a6f97", "#61a5c2", "#bb4430"])
    axes.set_yticks(range(len(SCENES)), SCENES)
    axes.set_xlabel("seconds: to the solid, to the mesh, and a chain of PCL's parts")
    save(figure, out / "performance_chain.png")
    table(["scene"] + list(CHAINS.values()) + ["plan: times `pcl::VoxelGrid`", "plan: times the bytes",
                                                  "solid: times faster", "mesh: times faster"], rows)


def plans(out):
    rows = []
    for millions in (3, 30):
        for scene in SCENES:
            runs = medians(out / f"plan_{scene}_{millions}.json")
            read, voxels, plan = (runs[name]["real_time"] / 1000 for name in list(CHAINS)[:3])
            rows.append([f"`{scene}`, {millions} million points", f"{read:.3f}", f"{voxels:.3f}", f"{plan:.3f}",
                         f"{plan / voxels:.2f}", f"{plan / read:.1f}"])
    table(["scene"] + list(CHAINS.values())[:3] + ["times `pcl::VoxelGrid`", "times the bytes"], rows)


def stages(out):
    runs = [run for run in medians(out / "stages.json").values()]
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.6), sharey=True)
    by_rooms = sorted((r for r in runs if "/mm:25" in r["run_name"]), key=lambda r: r["points"])
    by_points = sorted((r for r in runs if "/rooms:4/" in r["run_name"]), key=lambda r: r["points"])
    for which, axis, title in ((by_points, axes[0], "four rooms, more points"),
                               (by_rooms, axes[1], "more rooms, as dense")):
        for k, stage in enumerate(STAGES):
            axis.loglog([r["points"] for r in which], [max(r[stage], 1e-5) for r in which],
                        marker="o", markersize=3, color=plt.get_cmap("tab20")(k), label=stage)
        axis.set_xlabel("points")
        axis.set_title(title)
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("seconds")
    axes[1].legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
    save(figure, out / "performance_stages.png")
    shown = by_points + [r for r in by_rooms if r not in by_points]
    rooms = [r["run_name"].split(":")[1].split("/")[0] for r in shown]
    table(["stage, s"] + [f"{r['points'] / 1e6:.2f} M, rooms: {n}" for r, n in zip(shown, rooms)],
          [[stage] + [f"{r[stage]:.3f}" for r in shown] for stage in STAGES])


def buildings(out):
    with (out / "buildings.csv").open() as file:
        rows = list(csv.DictReader(file))
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4))
    points = [float(r["points"]) for r in rows]
    for axis, column, title in ((axes[0], "seconds", "seconds"), (axes[1], "peak_mib", "MiB at the most")):
        axis.loglog(points, [float(r[column]) for r in rows], marker="o")
        axis.set_xlabel("points")
        axis.set_title(title)
        axis.grid(alpha=0.3)
    save(figure, out / "performance_buildings.png")
    shown = ["points", "bytes", "rooms", "voxels", "seconds", "processor_seconds", "ParallelVoxelGrid",
             "peak_mib"]
    table(shown, [[row[column] for column in shown] for row in rows])
    for column in ("seconds", "processor_seconds"):
        print(f"{column} grow with an exponent of {slope(points, [float(r[column]) for r in rows]):.2f}")


def slope(x, y):
    """That of the line through the logarithms."""
    xs, ys = ([math.log(value) for value in values] for values in (x, y))
    mean_x, mean_y = (sum(values) / len(values) for values in (xs, ys))
    return (sum((a - mean_x) * (b - mean_y) for a, b in zip(xs, ys))
            / sum((a - mean_x) ** 2 for a in xs))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    out = pathlib.Path(sys.argv[1])
    for part in (thinning, chain, plans, stages, buildings):
        part(out)


if __name__ == "__main__":
    main()
