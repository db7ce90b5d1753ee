// SPDX-License-Identifier: BSD-3-Clause
#include "mirror_images.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace pcl::sedr {

namespace {

struct ColumnOfPart {
  const RoomColumn* column = nullptr;
  std::size_t part = 0;
};

/** @brief The columns of all parts, those above each other together, from below. */
std::vector<ColumnOfPart>
stackedColumns(const std::vector<BuildingRoom>& parts)
{
  std::vector<ColumnOfPart> all;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const RoomColumn& column : parts[p].columns)
      all.push_back({&column, p});
  std::sort(all.begin(), all.end(), [](const ColumnOfPart& a, const ColumnOfPart& b) {
    return std::tuple(keyOf(a.column->cell), a.column->floor, a.part) <
           std::tuple(keyOf(b.column->cell), b.column->floor, b.part);
  });
  return all;
}

} // namespace

std::vector<std::uint8_t>
mirrorImages(const std::vector<BuildingRoom>& parts, double surface)
{
  constexpr double same_height = 0.1; // metres
  constexpr double most = 0.8;        // of its columns
  std::vector<std::size_t> mirrored(parts.size(), 0);
  const std::vector<ColumnOfPart> all = stackedColumns(parts);
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    const RoomColumn& image = *all[k].column;
    const RoomColumn& above = *all[k + 1].column;
    const double floor = parts[all[k + 1].part].floor;
    const bool is_mirrored =
        keyOf(image.cell) == keyOf(above.cell) && all[k].part != all[k + 1].part &&
        std::abs(floor - (image.ceiling + above.floor) / 2) <= surface / 2 &&
        std::abs((above.ceiling - above.floor) - (image.ceiling - image.floor)) <=
            same_height;
    mirrored[all[k].part] += is_mirrored ? 1 : 0;
  }
  std::vector<std::uint8_t> is_image(parts.size(), 0);
  for (std::size_t p = 0; p < parts.size(); ++p)
    is_image[p] = static_cast<double>(mirrored[p]) >
                          most * static_cast<double>(parts[p].columns.size())
                      ? 1
                      : 0;
  return is_image;
}

} // namespace pcl::sedr
