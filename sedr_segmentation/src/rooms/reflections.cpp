// SPDX-License-Identifier: BSD-3-Clause
#include "reflections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::sedr {

namespace {

/** @brief How much of each part of the air is of some kind. */
class Shares {
public:
  Shares(const PartedAir& parted)
      : some_(parted.rooms, 0)
      , all_(parted.rooms, 0)
  {}

  void add(std::int32_t part, bool is_some)
  {
    if (part == PartedAir::no_room)
      return;
    ++all_[static_cast<std::size_t>(part)];
    some_[static_cast<std::size_t>(part)] += is_some ? 1 : 0;
  }

  /** @brief Returns 1 for each part of which a share is more than `most`. */
  std::vector<std::uint8_t> above(double most) const
  {
    std::vector<std::uint8_t> is_above(all_.size());
    for (std::size_t p = 0; p < all_.size(); ++p)
      is_above[p] = static_cast<double>(some_[p]) > most * static_cast<double>(all_[p]);
    return is_above;
  }

private:
  std::vector<std::size_t> some_;
  std::vector<std::size_t> all_;
};

} // namespace

std::vector<std::uint8_t>
mirrorImages(const AirGaps& air,
             const PartedAir& parted,
             const std::vector<double>& floors)
{
  constexpr double surface =
      0.08; // metres, of one that noise thickens; slabs are thicker
  constexpr double same_height = 0.1;
  constexpr double most = 0.8; // of its columns
  Shares shares(parted);
  for (std::size_t g = 0; g < air.size(); ++g) {
    const std::size_t above = g + 1;
    const auto isMirrored = [&] {
      const double plane = air.columns().heightOf(air[g].high + air[above].low) / 2;
      return std::abs(floors[static_cast<std::size_t>(parted.room[above])] - plane) <=
                 surface / 2 &&
             std::abs(air.height(above) - air.height(g)) <= same_height;
    };
    shares.add(parted.room[g],
               above < air.size() && air[above].column == air[g].column &&
                   parted.room[above] != PartedAir::no_room &&
                   parted.room[above] != parted.room[g] && isMirrored());
  }
  return shares.above(most);
}

std::vector<std::uint8_t>
viewsThroughPanes(const AirGaps& air,
                  const PartedAir& parted,
                  const PointView& points,
                  const std::vector<std::uint8_t>& behind)
{
  constexpr double beside = 0.1; // metres, of floor and ceiling
  constexpr double most = 0.9;   // of the points
  Shares shares(parted);
  const VoxelColumns& columns = air.columns();
  for (std::size_t i = 0; i < std::min(points.size(), behind.size()); ++i) {
    const Eigen::Vector3f p = points[i];
    if (!p.allFinite() || !columns.grid().holds(p.x(), p.y()))
      continue;
    const std::uint32_t column = columns.columnAt(columns.grid().at(p.x(), p.y()));
    if (column == VoxelColumns::none)
      continue;
    for (std::size_t g = air.first(column); g < air.first(column + 1); ++g)
      if (p.z() > columns.heightOf(air[g].low) - beside &&
          p.z() < columns.heightOf(air[g].high) + beside)
        shares.add(parted.room[g], behind[i] != 0);
  }
  return shares.above(most);
}

} // namespace pcl::sedr
