#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the table of the proving ground."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from proving import bars

SCRIPT = pathlib.Path(__file__).with_name("proving_ground_table.py")
GOOD = {"scene": "hall", "noise": "0.01", "seed": "1", "with_mesh": "1", "points": "1234567", "failure": "", "rooms_true": "4",
        "rooms_found": "4", "area_error": "0.001", "height_error": "0.002", "volume_error": "0.003", "mesh_volume_error": "0.004",
        "corners_true": "18", "corners_found": "18", "corner_distance_max": "0.0011", "radius_error": "", "perimeter_error": "0.0031",
        "solid_triangles": "120", "truth_to_solid_mean": "0.0001", "truth_to_solid_max": "0.001", "solid_to_truth_max": "0.0015",
        "solid_volume_error": "0.0012", "solid_wall_area_error": "0.0013", "truth_to_mesh_mean": "0.001", "truth_to_mesh_max": "0.031",
        "truth_within_1cm": "0.98", "truth_within_5cm": "0.999", "mesh_to_truth_mean": "0.0011", "mesh_to_truth_max": "0.032",
        "mesh_beyond_5cm": "0.001", "detail_within_5cm": "0.99", "points_to_truth_mean": "0.0005", "points_to_truth_max": "0.02",
        "points_beyond_5cm": "0", "truth_covered": "0.999", "ceiling_recall": "0.99", "ceiling_precision": "0.98", "floor_recall": "1",
        "floor_precision": "", "wall_recall": "", "wall_precision": "", "detail_recall": "", "detail_precision": "", "seconds": "12.5",
        "stage_seconds": "ParallelVoxelGrid=0.25;StructuralPoisson=12.25", "missed_bars": "", "missed": ""}
FAILED = {**dict.fromkeys(GOOD, ""), "scene": "hall", "noise": "0.01", "seed": "2", "with_mesh": "1", "rooms_true": "4",
          "rooms_found": "0", "failure": "no floor", "missed_bars": "failed"}


def run(*texts):
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for text in texts:
            files.append(pathlib.Path(folder) / f"{len(files)}.csv")
            files[-1].write_bytes(text if isinstance(text, bytes) else text.encode())
        return run_with(*files)


def run_with(*arguments):
    return subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, encoding="utf-8", check=False)


def text_of(*rows):
    lines = [",".join(GOOD)]
    lines += [",".join(f'"{row[k]}"' if "," in row[k] else row[k] for k in GOOD) for row in rows]
    return "\n".join(lines) + "\n"


def table(*rows):
    return run(text_of(*rows)).stdout


def cell(text, column, row="| hall"):
    lines = text.splitlines()
    titles = next(line for line in lines if line.startswith("| scene | noise")).strip("| ").split(" | ")
    values = [v.strip() for v in next(line for line in lines if line.startswith(row))[1:-1].split("|")]
    return dict(zip(titles, values))[column]


class Table(unittest.TestCase):
    def test_has_a_row_a_scene_and_noise_in_order(self):
        text = table({**GOOD, "noise": "0.02"}, {**GOOD, "scene": "attic", "noise": "0.001"}, {**GOOD, "noise": "0.001"},
                     {**GOOD, "noise": "0.001", "seed": "2"})
        places = [text.index(f"| {row} |") for row in ("hall | 0.1", "hall | 2", "attic | 0.1")]
        self.assertEqual(places, sorted(places))
        self.assertIn("Scenes: 2. Seeds: 1, 2. Runs: 4. Runs that reach every bar: 4.\n", text)

    def test_shows_the_worst_seed_and_the_median(self):
        text = table({**GOOD, "truth_to_mesh_mean": "0.0012", "truth_within_1cm": "0.97"},
                     {**GOOD, "truth_to_mesh_mean": "0.0025", "seed": "2"}, {**GOOD, "truth_to_mesh_mean": "0.0015", "seed": "3"})
        self.assertEqual([cell(text, c) for c in ("mean, cm", "≤ 1 cm", "max, cm", "rooms", "closed", "volume", "ceiling", "floor", "missed")],
                         ["0.250 (0.150)", "97.00 (98.00)", "3.1", "4/4", "yes", "0.40", "99.0 / 98.0", "100.0 / -", ""])

    def test_marks_what_misses_its_bar(self):
        text = table(GOOD, {**GOOD, "seed": "2", "truth_to_mesh_mean": "0.005", "rooms_found": "3",
                                   "missed_bars": "rooms;closed;mean;corners"})
        self.assertEqual([cell(text, c) for c in ("mean, cm", "rooms", "closed", "≤ 5 cm", "missed")],
                         ["**0.500 (0.100)**", "**3-4/4**", "**no 1**", "99.90", "rooms 1/2, closed 1/2, mean 1/2"])
        self.assertIn("Runs that reach every bar: 1. Missed: rooms 1/2", text)
        self.assertEqual(cell(text[text.index("## Plans"):], "missed"), "corners 1/2")

    def test_tells_which_runs_failed_and_why(self):
        text = table(FAILED)
        self.assertEqual([cell(text, c) for c in ("rooms", "mean, cm", "closed", "missed")], ["**0/4**", "-", "-", "failed 1/1"])
        self.assertIn("- hall, noise 1 cm, seed 2: no floor\n", text)
        self.assertEqual(cell(table(GOOD, FAILED), "mean, cm"), "0.100")

    def test_counts_the_latest_of_equal_runs(self):
        text = run(text_of({**GOOD, "truth_to_mesh_mean": "0.1"}), text_of(GOOD)).stdout
        self.assertEqual(cell(text, "mean, cm"), "0.100")
        self.assertIn("Runs: 1.", text)

    def test_gives_runs_without_mesh_a_table_of_their_own(self):
        text = table({**GOOD, "with_mesh": "0"})
        self.assertNotIn("## Models", text)
        self.assertEqual([cell(text, c) for c in ("mean, cm", "covered", "volume")], ["0.050", "99.90", "0.30"])

    def test_has_the_seconds_of_each_stage(self):
        text = table(GOOD, {**GOOD, "seed": "2", "stage_seconds": "ParallelVoxelGrid=0.75;StructuralPoisson=12.25"},
                     {**GOOD, "noise": "0.02", "stage_seconds": "ParallelVoxelGrid=0.5"})
        self.assertIn("| scene | points, M | ParallelVoxelGrid | StructuralPoisson | all |", text)
        self.assertIn("| hall | 1.23 | 0.50 | 12.25 | 12.50 |", text)

    def test_refuses_what_is_no_table(self):
        for text in ("", "x y z\n1 2 3\n", "scene,seed\nattic,1\n", text_of(GOOD) + "hall,1\n"):
            result = run(text)
            self.assertEqual((result.returncode, result.stdout), (1, ""), text)
            self.assertIn("is no table of runs", result.stderr)

    def test_refuses_wrong_cells_with_their_line(self):
        wrong = {"seed": ("one", "1.5", ""), "noise": ("loud", ""), "truth_to_mesh_mean": ("abc", "nan"), "rooms_found": ("3.5", "inf"),
                 "stage_seconds": ("ParallelVoxelGrid", "ParallelVoxelGrid=x"), "missed_bars": ("mean distance", "mean;radii")}
        for column, cells in wrong.items():
            for text in cells:
                result = run(text_of(GOOD, {**GOOD, column: text}))
                self.assertEqual((result.returncode, result.stdout), (1, ""), (column, text))
                self.assertRegex(result.stderr, r"^proving_ground_table.py: '.*0\.csv', line 3, is no table of runs: [^\n]*\n$",
                                 (column, text))

    def test_refuses_lines_of_more_cells_and_other_encodings(self):
        for text in (text_of(GOOD)[:-1] + ",7\n", text_of({**GOOD, "scene": "Küche"}).encode("latin-1"),
                     "\n".join(line.split(",", 2)[0] + "," + line.split(",", 2)[2] for line in text_of(GOOD).splitlines()) + "\n"):
            result = run(text)
            self.assertEqual((result.returncode, result.stdout), (1, ""), text)
            self.assertRegex(result.stderr, r"^proving_ground_table.py: .*no table of runs: [^\n]*\n$")

    def test_keeps_the_message_of_a_failure_whole(self):
        for mark in ("\f", "\x1c", "\u2028"):
            text = run(text_of({**FAILED, "failure": f"no{mark}floor"})).stdout
            self.assertIn(f"- hall, noise 1 cm, seed 2: no{mark}floor\n", text)

    def test_knows_the_bars_of_the_benchmark(self):
        for name in bars.NAMES:
            text = table({**GOOD, "missed_bars": name})
            self.assertIn(f"Missed: {name} 1/1.", text)
            self.assertIn("Runs that reach every bar: 0.", text)
        self.assertEqual(run(text_of({**GOOD, "missed_bars": ";".join(bars.NAMES)})).returncode, 0)

    def test_has_help(self):
        for option, code in (("-h", 0), ("--help", 0), ("--wrong", 1)):
            result = run_with(option)
            self.assertEqual(result.returncode, code)
            self.assertIn("RUNS.csv", result.stderr if code else result.stdout)

    def test_leaves_out_the_line_that_was_interrupted(self):
        self.assertIn("Runs: 1.", run(text_of(GOOD) + "hall,0.01,2").stdout)


if __name__ == "__main__":
    unittest.main()
