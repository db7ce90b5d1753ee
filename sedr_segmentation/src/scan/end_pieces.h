// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Columns of the air that ends at floors and ceilings. */
namespace air_columns {
constexpr double size = 0.1; // metres
constexpr int bits = 21;     // of a cell's coordinate in a key
} // namespace air_columns

/** @brief Air between two occupied cells of a column; heights are means of points. */
struct ColumnGap {
  std::uint64_t column;
  float low;
  float high;
};

/** @brief Indices of gaps side by side. */
using GapBorders = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/** @brief Returns the key of the column of a place, or of its cell. */
template <typename Place>
std::uint64_t
columnKey(const Place& place)
{
  constexpr double origin = 1 << (air_columns::bits - 1);
  std::uint64_t key = 0;
  for (Eigen::Index k = 0; k < place.size(); ++k)
    key = key << air_columns::bits |
          static_cast<std::uint64_t>(std::floor(place[k] / air_columns::size) + origin);
  return key;
}

/** @brief Returns whether a gap is in a column of a lower key. */
inline bool
isBefore(const ColumnGap& gap, std::uint64_t column)
{
  return gap.column < column;
}

/** @brief The pieces of an end surface, which are connected without steps of 0.2 m,
 * each with the index of its first gap. */
struct EndPieces {
  std::vector<std::uint32_t> of;    ///< piece of each gap
  std::vector<double> areas;        ///< square metres
  std::vector<double> rises;        ///< sum of steps into the air from what is beside
  std::vector<double> borders;      ///< number of these steps
  std::vector<double> even_borders; ///< where the other end of the air has no step
  double large = 0;                 ///< area of large ones, square metres

  bool isLarge(std::uint32_t piece) const { return areas[piece] >= large; }
};

EndPieces piecesOf(const std::vector<ColumnGap>& gaps,
                   const GapBorders& borders,
                   float ColumnGap::*end,
                   const Priors& priors);

/** @brief What stands out of an end of the air. */
struct ThingCounts {
  double things = 0; ///< see EndSurface
  double bars = 0;
};

/** @brief Counts the pieces that may be furniture or beams; no gap, no piece. */
ThingCounts thingsOf(const std::vector<ColumnGap>& gaps,
                     const EndPieces& pieces,
                     float ColumnGap::*end,
                     const Priors& priors);

} // namespace pcl::sedr
