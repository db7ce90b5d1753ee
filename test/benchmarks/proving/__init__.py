# SPDX-License-Identifier: BSD-3-Clause
"""The figures and bars of proving_ground.py."""
