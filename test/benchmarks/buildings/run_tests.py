# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests of a script for ctest."""
import sys
import unittest

SKIPPED = 77  # as in the tests' CMakeLists.txt


def main():
    """Exit code 77 if tests were skipped and no other one failed."""
    result = unittest.main(exit=False).result
    sys.exit(1 if not result.wasSuccessful() else SKIPPED if result.skipped else 0)
