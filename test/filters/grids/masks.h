// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"

#include <random>
#include <string>
#include <vector>

constexpr pcl::sedr::CellBox box{{-7, 3}, {16, 20}}; // 24 x 18 cells

/** A mask of `where`, each cell set with the given probability. */
inline pcl::sedr::CellMask
randomMask(const pcl::sedr::CellBox& where, double chance, unsigned seed)
{
  std::mt19937 random(seed);
  pcl::sedr::CellMask mask(where);
  for (auto& value : mask.values())
    value = static_cast<double>(random()) < chance * 4294967296.0 ? 1 : 0;
  return mask;
}

/** A mask from rows of characters, the first row at the top; '#' is set. */
inline pcl::sedr::CellMask
drawn(const std::vector<std::string>& rows)
{
  const int height = static_cast<int>(rows.size());
  pcl::sedr::CellMask mask(
      pcl::sedr::CellBox{{0, 0}, {static_cast<int>(rows[0].size()) - 1, height - 1}});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < mask.width(); ++x)
      mask.set(
          {x, y},
          rows[static_cast<std::size_t>(height - 1 - y)][static_cast<std::size_t>(x)] ==
                  '#'
              ? 1
              : 0);
  return mask;
}
