// SPDX-License-Identifier: BSD-3-Clause
#include "walked_floors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double highest_tread = 0.25; // metres, of what one walks up
constexpr double min_going = 0.25;     // from tread to tread
constexpr double min_over_air = 0.1;   // of a floor that is not on solid ground

/** @brief Surfaces on each of which one could walk about. */
class WalkedFloors {
public:
  WalkedFloors(const AirGaps& air, double thickest_wall)
      : air_(air)
      , thickest_wall_(thickest_wall)
      , tall_(air.voxels(air.parameters().headroom))
      , tread_(air.voxels(highest_tread *
                          std::max(1.0, air.columns().cellSize() / min_going)))
      , surface_of_(air.size(), AirGaps::none)
  {
    for (std::uint32_t g = 0; g < air.size(); ++g)
      if (isTall(g) && surface_of_[g] == AirGaps::none)
        collect(g);
  }

  std::vector<std::uint8_t> floors() const
  {
    std::vector<std::uint8_t> is_on_floor(air_.size(), 0);
    for (const Surface& surface : surfaces_)
      if (isFloor(surface))
        for (const std::uint32_t g : surface.gaps)
          is_on_floor[g] = 1;
    return is_on_floor;
  }

private:
  struct Surface {
    std::vector<std::uint32_t> gaps; ///< above it
    std::size_t rim = 0;             ///< sides of columns at which it ends
  };

  bool isTall(std::uint32_t g) const { return air_[g].high - air_[g].low >= tall_; }

  /** @brief Returns whether below a gap there is air in which one can stand and that
   * reaches above a height: the air of the storey below does not. */
  bool isOverAir(std::uint32_t g, std::int32_t height) const
  {
    for (std::size_t o = air_.first(air_[g].column); o < g; ++o)
      if (isTall(static_cast<std::uint32_t>(o)) && air_[o].high > height)
        return true;
    return false;
  }

  void collect(std::uint32_t start)
  {
    const auto number = static_cast<std::uint32_t>(surfaces_.size());
    Surface surface;
    surface.gaps.push_back(start);
    surface_of_[start] = number;
    for (std::size_t k = 0; k < surface.gaps.size(); ++k) {
      const std::uint32_t g = surface.gaps[k];
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = air_.link(g, d);
        if (o == AirGaps::none || !isTall(o) ||
            std::abs(air_[o].low - air_[g].low) > tread_)
          ++surface.rim;
        else if (surface_of_[o] == AirGaps::none) {
          surface_of_[o] = number;
          surface.gaps.push_back(o);
        }
      }
    }
    surfaces_.push_back(std::move(surface));
  }

  bool isFloor(const Surface& surface) const
  {
    const auto n = static_cast<double>(surface.gaps.size());
    const bool is_wide = 2 * n * air_.columns().cellSize() >
                         thickest_wall_ * static_cast<double>(surface.rim);
    if (!is_wide)
      return false;
    const std::optional<std::int32_t> larger = largerBelow(surface);
    if (!larger)
      return true;
    const auto over_air =
        std::count_if(surface.gaps.begin(), surface.gaps.end(),
                      [&](std::uint32_t g) { return isOverAir(g, *larger); });
    return static_cast<double>(over_air) > min_over_air * n;
  }

  /** @brief The height of the lowest place of larger surfaces to which one drops. */
  std::optional<std::int32_t> largerBelow(const Surface& surface) const
  {
    std::optional<std::int32_t> lowest;
    for (const std::uint32_t g : surface.gaps)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = air_.link(g, d);
        if (air_.isDrop(g, d) && air_[o].low < air_[g].low &&
            surfaces_[surface_of_[o]].gaps.size() > surface.gaps.size())
          lowest = std::min(lowest.value_or(air_[o].low), air_[o].low);
      }
    return lowest;
  }

  const AirGaps& air_;
  double thickest_wall_;
  std::int32_t tall_;                     ///< voxels of headroom
  std::int32_t tread_;                    ///< voxels
  std::vector<std::uint32_t> surface_of_; ///< of each tall gap
  std::vector<Surface> surfaces_;
};

} // namespace

std::vector<std::uint8_t>
standOnFloor(const AirGaps& air, double thickest_wall)
{
  return WalkedFloors(air, thickest_wall).floors();
}

} // namespace pcl::sedr
