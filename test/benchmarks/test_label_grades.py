#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of label_grades.py."""
import pathlib
import tempfile
import unittest

from buildings import run_tests

try:
    import numpy as np

    from label_grades import Grades, meanings_of
    from proving import pcd
except ImportError:
    Grades = None  # numpy or scipy is missing


@unittest.skipUnless(Grades, "needs numpy and scipy")
class LabelGrades(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def cloud(self, name, rows, fields="x y z label", binary=False):
        names = fields.split()
        kinds = ["U" if field == "label" else "F" for field in names]
        head = (f"VERSION 0.7\nFIELDS {fields}\nSIZE {' '.join('4' for _ in names)}\nTYPE {' '.join(kinds)}\n"
                f"COUNT {' '.join('1' for _ in names)}\nWIDTH {len(rows)}\nHEIGHT 1\nPOINTS {len(rows)}\nDATA ")
        data = "ascii\n" + "\n".join(" ".join(map(str, row)) for row in rows) + "\n"
        if binary:
            types = np.dtype([(field, "u4" if field == "label" else "f4") for field in names])
            data = b"binary\n" + np.array([tuple(row) for row in rows], types).tobytes()
        (self.folder / name).write_bytes(head.encode() + (data if binary else data.encode()))
        return self.folder / name

    def test_labels_are_scored_by_the_nearest_point(self):
        structure = self.cloud("structure.pcd", [[0, 0, 0, 1], [1, 0, 0, 2], [2, 0, 0, 5]])
        scan = self.cloud("scan.pcd", [[0, 0, .01, 0], [1, 0, .01, 1], [1, 0, .06, 12], [2, 0, .01, 7]], binary=True)
        grades = Grades(structure, scan, meanings=meanings_of("0=1,1=2,7=3"))
        scores = {name: grades.score(grades.of_scan, name) for name in ("ceiling", "floor", "wall")}
        self.assertEqual(scores, {"ceiling": (1, 1, 1), "floor": (1, 2, 1), "wall": (1, 1, 1)})  # true, predicted, both
        self.assertEqual(grades.score(grades.of_structure, "floor")[1:], (1, 1))
        self.assertEqual(list(grades.of_given[12]), [0, 0, 1, 0, 0])
        self.assertEqual(grades.recall_and_precision("detail"), (None, None))

    def test_a_scan_is_thinned_and_points_that_are_not_finite_do_not_count(self):
        structure = self.cloud("structure.pcd", [[0, 0, 0, 1], ["nan", 0, 0, 2]])
        scan = self.cloud("scan.pcd", [[.001, 0, 0, 1], [.002, 0, 0, 1], [.5, 0, 0, 1], [0, 0, "nan", 2]])
        grades = Grades(structure, scan)
        self.assertEqual(grades.score(grades.of_scan, "ceiling"), (2, 1, 1))
        self.assertEqual(grades.score(grades.of_scan, "floor"), (0, 0, 0))

    def test_points_too_far_off_the_surface_are_other(self):
        structure = self.cloud("structure.pcd", [[0, 0, 0, 0, 0, 1, 1], [1, 0, 0, 0, 0, 1, 1]],
                               "x y z normal_x normal_y normal_z label")
        scan = self.cloud("scan.pcd", [[.03, 0, 0, 1], [1, 0, .03, 1]])
        self.assertEqual(Grades(structure, scan).recall_and_precision("ceiling")[0], 1)
        self.assertEqual(Grades(structure, scan, off_surface=.02).recall_and_precision("ceiling")[0], .5)
        with self.assertRaisesRegex(ValueError, "no field 'normal_x'"):
            Grades(scan, scan, off_surface=.02)

    def test_what_cannot_be_scored_is_refused(self):
        labelled = self.cloud("labelled.pcd", [[0, 0, 0, 9]])
        bare = self.cloud("bare.pcd", [[0, 0, 0]], "x y z")
        for structure, scan in ((bare, labelled), (labelled, bare), (labelled, labelled)):
            with self.assertRaises(ValueError):
                Grades(structure, scan)
        for wrong in ("9", "1=6", "1=", "1=1,1=2"):
            with self.assertRaises(ValueError):
                meanings_of(wrong)

    def test_lzf_is_unpacked(self):
        # "abcabcabcabc!": three new bytes, nine copied from three before, one new byte
        self.assertEqual(pcd.unpacked(b"\x02abc\xe0\x00\x02\x00!", 13), b"abcabcabcabc!")


if __name__ == "__main__":
    run_tests.main()
