#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Prints the points of an empty room of 4 m x 3 m x 2.4 m, one every 4 cm, its floor at 0.4 m.
awk 'BEGIN {
  for (i = 0; i <= 100; ++i)
    for (j = 0; j <= 75; ++j)
      for (k = 0; k <= 60; ++k)
        if (i % 100 == 0 || j % 75 == 0 || k % 60 == 0)
          print 0.04 * i, 0.04 * j, 0.4 + 0.04 * k
}'
