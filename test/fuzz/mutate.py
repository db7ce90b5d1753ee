#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs every program on mutated inputs: mutate.py BIN SECONDS [SEED]

A simulated scan is modelled once; plans, reports, clouds and meshes of the result are mutated (bytes, numbers, lines, ends) and
given to each program that reads such a file. A run is wrong if it ends by a signal, with another code than 0, 1 or 2, after
more than 60 seconds, with a word of a sanitizer, or with code 1 or 2 and not a word. BIN is the bin folder of a build, best of the
preset asan-ubsan. Prints a line a program; what broke one stays in the folder that the last line names. Exit code 1 if there is anything.
"""
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

LONGEST = 60  # seconds
NUMBERS = (b"0", b"-1", b"1e308", b"-1e9", b"1e-320", b"4294967296", b"null", b"\"x\"", b"[]", b"{}", b"true", b"0.5")


def mutated(data, rng):
    """The bytes of a file with one to four changes."""
    data = bytearray(data)
    for _ in range(rng.choice((1, 1, 1, 2, 4))):
        kind, at = rng.randrange(10), rng.randrange(max(1, len(data)))
        numbers = list(re.finditer(rb"-?\d+(\.\d+)?", data[:200_000])) if kind < 2 or kind > 5 else []
        if numbers:
            found = rng.choice(numbers)
            near = b"%.6g" % (float(found.group()) * rng.choice((-1, 0.5, 1.001, 2)) + rng.choice((0, 0.01, 1)))
            data[found.start():found.end()] = rng.choice(NUMBERS) if kind < 2 else near
        elif kind == 2:
            data[at:at + 1] = bytes([rng.randrange(256)])
        elif kind == 3:
            del data[at:at + rng.choice((1, 2, 8, 64, 1000))]
        elif kind == 4:
            data[at:at] = data[rng.randrange(max(1, len(data))):][:rng.choice((1, 8, 64))]
        elif kind == 5:
            head = data[:rng.choice((64, 400, 2000, len(data)))]
            where = rng.randrange(max(1, len(head)))
            data[where:where + 4] = bytes(rng.randrange(256) for _ in range(4))
    if rng.random() < 0.1:
        del data[rng.randrange(max(1, len(data))):]
    return bytes(data)


def runs_of(b, files, out):
    """Program, mutated input, command."""
    plan, scan, rooms, mesh = files["floorplan.json"], files["structure.pcd"], files["rooms.pcd"], files["solid.ply"]
    yield "floorplan_drawing", plan, [plan, out / "x.svg"]
    yield "floorplan_drawing", plan, [plan, out / "x.dxf"]
    yield "floorplan_extrusion", plan, [plan, out / "x.ply"]
    yield "floorplan_ifc", plan, [plan, out / "x.ifc"]
    yield "floorplan_edit", plan, [plan, out / "x.json", "--square", "1", "--merge", "1,2",
                                  "--opening", "D1,width=0.8"]
    yield "opening_detection", plan, [scan, plan, out / "x.json"]
    yield "structure_refinement", plan, [scan, plan, out / "x.pcd"]
    yield "vertical_hole_repair", plan, [scan, plan, out / "x.pcd"]
    yield "structure_compare", plan, [files["model"], files["other"]]
    yield "sedr_report", files["report.json"], [files["model"]]
    yield "mesh_evaluation", mesh, [mesh, "--cloud", scan]
    yield "mesh_evaluation", mesh, [files["mesh.obj"], "--truth", mesh]
    for program in ("parallel_voxel_grid", "grid_region_outlier_removal", "horizontal_plane_detection", "grid_slice_detail",
                    "floor_projection_recovery", "ceiling_boundary_wall_growing", "structural_poisson"):
        yield program, scan, [scan, out / ("x.ply" if "poisson" in program else "x.pcd")]
    yield "room_segmentation", rooms, [rooms, out / "x.pcd", "--building", out / "b.json"]
    yield "floorplan_fitting", scan, [scan, out / "x.json"]
    yield "sedr", rooms, [rooms, out / "model", "--no-mesh", "--partial"]


def main():
    b, seconds = pathlib.Path(sys.argv[1]).resolve(), float(sys.argv[2])
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    known = pathlib.Path(__file__).resolve().parent / "leaks.txt"  # of other libraries
    os.environ.setdefault("LSAN_OPTIONS", f"suppressions={known}:print_suppressions=0")
    root = pathlib.Path(tempfile.mkdtemp(prefix="mutated_"))
    seeds, found = root / "seeds", root / "found"
    found.mkdir()
    subprocess.run([b / "pcl_simulate_indoor_scan", "closet", seeds, "--rays", "6000"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([b / "pcl_sedr", seeds / "scan.pcd", seeds / "model", "--partial"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    subprocess.run([b / "pcl_floorplan_extrusion", seeds / "model/floorplan.json", seeds / "model/mesh.obj"], check=True)
    shutil.copy(seeds / "scan.pcd", seeds / "model/rooms.pcd")
    counts, end, wrong = {}, time.monotonic() + seconds, 0
    while time.monotonic() < end:
        work = root / "work"
        shutil.rmtree(work, ignore_errors=True)
        shutil.copytree(seeds / "model", work)
        (root / "out").mkdir(exist_ok=True)
        files = {name: work / name for name in ("floorplan.json", "structure.pcd", "rooms.pcd", "solid.ply", "report.json", "mesh.obj")}
        files.update({"model": work, "other": seeds / "model"})
        program, target, arguments = rng.choice(list(runs_of(b, files, root / "out")))
        if not (b / f"pcl_{program}").exists():
            continue
        target.write_bytes(mutated(target.read_bytes(), rng))
        command = [str(b / f"pcl_{program}")] + [str(a) for a in arguments]
        try:
            done = subprocess.run(command, capture_output=True, timeout=LONGEST, check=False)
            code, text = done.returncode, done.stderr.decode(errors="replace")
        except subprocess.TimeoutExpired:
            code, text = 124, f"no end after {LONGEST} s"
        of = counts.setdefault(program, {"runs": 0, "refused": 0, "wrong": 0})
        of["runs"] += 1
        of["refused"] += code in (1, 2)
        if code not in (0, 1, 2) or "Sanitizer" in text or "runtime error" in text or (code != 0 and not text.strip()) or "exception" in text:
            of["wrong"] += 1
            kept = found / f"{wrong}_{program}"
            shutil.copytree(work, kept)
            (kept / "run.txt").write_text(" ".join(command) + f"\n{code}\n{text}", encoding="utf-8")
            wrong += 1
    for program, of in sorted(counts.items()):
        print(f"{program}: {json.dumps(of)}")
    print(f"{sum(of['runs'] for of in counts.values())} runs, {wrong} wrong: {found}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
