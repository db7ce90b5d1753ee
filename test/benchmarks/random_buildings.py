#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs pcl_sedr on random buildings and grades its rooms: random_buildings.py FIRST LAST [options]

For every seed from FIRST to LAST a building is made by random_building.py, scanned by pcl_simulate_indoor_scan, modelled by
pcl_sedr --no-mesh and graded against the truth. The table has a line a building; the summary comes last. A building is all
right if every room that counts is matched by one found room of 0.7 intersection over union or more, no other room of more
than 1.5 square metres is found, and the number of storeys is exact. Needs numpy, scipy and shapely, for pictures matplotlib.
Exit code 0: all buildings were graded, however well; 1: not all were.
"""
from buildings import runs

runs.require("numpy", "scipy", "shapely")
import opening_grades  # noqa: E402
from buildings import grades, pictures  # noqa: E402
from proving import pcd  # noqa: E402


def one_building(seed, folder, options):
    row = runs.building(seed, folder, options, options.measured)
    message = row.pop("message")  # the last column
    figures, graded = grades.grade(folder, folder / "out")
    row.update(figures)
    plan = folder / "out/floorplan.json"
    row.update(opening_grades.columns(opening_grades.grade(folder, plan if plan.exists() else None, False)))
    row["message"] = message
    kept = runs.keep(folder, row, options)
    if kept:
        shown = ("rooms", "matched_0.7", "missed", "merged", "split", "shape", "extra", "storeys", "storeys_found")
        title = f"{row['kind']} {seed}: " + ", ".join(f"{k} {row[k]}" for k in shown)
        pictures.draw(kept / "rooms.png", title, graded, pcd.read(folder / "scan.pcd"))
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
             "; " + ", ".join(f"{total(k)} {k}" for k in ("missed", "merged", "split", "shape", "extra")) +
             f"; floors of {total('floors_off')} more than 5 cm off",
             f"flights of stairs: {total('stairs')} true, {total('stairs_found')} found, {total('stairs_exact')} with all steps, "
             f"{total('stairs_invented')} invented",
             *opening_grades.summary(rows),
             f"seconds of pcl_sedr: {total('seconds') / len(rows):.1f} on average, {max(r['seconds'] for r in rows):.1f} at most"]
    codes = sorted({r["exit"] for r in rows})
    lines.append("exit codes: " + ", ".join(f"{c}: {sum(r['exit'] == c for r in rows)}" for c in codes))
    for kind in sorted({r["kind"] for r in rows}):
        mine = [r for r in rows if r["kind"] == kind]
        lines.append(f"{kind}: {sum(r['all_right'] for r in mine)} of {len(mine)}, rooms "
                     f"{sum(r['matched_0.7'] for r in mine)} of {sum(r['rooms'] for r in mine)}")
    return "\n".join(lines)


def main():
    parser = runs.parser(__doc__, "buildings")
    parser.add_argument("--measured", action="store_true",
                        help="points with the errors of real scans: registration, mixed pixels, lost grazing returns")
    runs.all_seeds(parser.parse_args(), [], one_building, summary)


if __name__ == "__main__":
    main()
