#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# In the folder of SEDR, or with SOURCES set to that of all tutorials.
# [first]
pcl_simulate_indoor_scan bls_room noisy --rays 6000 --noise 0.04
pcl_sedr noisy/scan.pcd noisy/model --report
# [first]
python3 "${SOURCES:-doc/tutorials/sources}/reading_the_report/rooms.py" noisy/model
