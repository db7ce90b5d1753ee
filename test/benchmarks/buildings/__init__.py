# SPDX-License-Identifier: BSD-3-Clause
"""Random buildings for the scan simulator: see ../random_building.py."""
