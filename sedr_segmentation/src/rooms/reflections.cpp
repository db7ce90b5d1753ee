// SPDX-License-Identifier: BSD-3-Clause
#include "reflections.h"

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

/** @brief Calls `visit(g, point, index)` for each gap of the column of each point. */
template <typename Visitor>
void
forEachGap(const AirGaps& air, const PointView& points, Visitor visit)
{
  const VoxelColumns& columns = air.columns();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = points[i];
    if (!p.allFinite() || !columns.grid().holds(p.x(), p.y()))
      continue;
    const std::uint32_t column = columns.columnAt(columns.grid().at(p.x(), p.y()));
    if (column == VoxelColumns::none)
      continue;
    for (std::size_t g = air.first(column); g < air.first(column + 1); ++g)
      visit(g, p, i);
  }
}

/** @brief Mean height of some points, NaN of none. */
struct MeanHeight {
  double sum = 0;
  double count = 0;

  void add(double height)
  {
    sum += height;
    ++count;
  }
  double mean() const { return sum / count; }
};

} // namespace

std::vector<std::uint8_t>
mirrorImages(const AirGaps& air,
             const PartedAir& parted,
             const PointView& points,
             const std::vector<double>& floors)
{
  constexpr double thinnest = 0.08; // metres, of slabs; a floor has no thickness
  constexpr double same_height = 0.1;
  constexpr double most = 0.8; // of its columns
  const VoxelColumns& columns = air.columns();
  std::vector<MeanHeight> lows(air.size());
  std::vector<MeanHeight> highs(air.size());
  std::vector<MeanHeight> main_floors(floors.size());
  forEachGap(air, points, [&](std::size_t g, const Eigen::Vector3f& p, std::size_t) {
    const std::int32_t voxel = columns.voxelAt(p.z());
    if (voxel == air[g].high)
      highs[g].add(p.z());
    if (voxel + 1 != air[g].low)
      return;
    lows[g].add(p.z());
    const std::int32_t part = parted.room[g];
    if (part != PartedAir::no_room &&
        std::abs(columns.heightOf(air[g].low) -
                 floors[static_cast<std::size_t>(part)]) <= columns.voxelHeight())
      main_floors[static_cast<std::size_t>(part)].add(p.z());
  });
  Shares shares(parted);
  for (std::size_t g = 0; g < air.size(); ++g) {
    const std::size_t above = g + 1;
    const auto isMirrored = [&] {
      const double plane = (highs[g].mean() + lows[above].mean()) / 2;
      const double floor =
          main_floors[static_cast<std::size_t>(parted.room[above])].mean();
      return std::abs(floor - plane) <= thinnest / 4 &&
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
  if (!behind.empty())
    forEachGap(
        air, points, [&](std::size_t g, const Eigen::Vector3f& p, std::size_t i) {
          if (i < behind.size() && p.z() > columns.heightOf(air[g].low) - beside &&
              p.z() < columns.heightOf(air[g].high) + beside)
            shares.add(parted.room[g], behind[i] != 0);
        });
  return shares.above(most);
}

} // namespace pcl::sedr
