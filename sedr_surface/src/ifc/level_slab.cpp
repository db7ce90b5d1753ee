// SPDX-License-Identifier: BSD-3-Clause
#include "level_slab.h"

#include <algorithm>

namespace pcl::sedr::ifc {

namespace {

constexpr double level = 0.001; ///< smaller height differences are ignored, metres

/** @brief Returns the range of a slab's heights over a box, from samples. */
double
spreadOf(const PlanSlab& slab, const Eigen::AlignedBox2d& box)
{
  constexpr int samples = 8;
  double low = slab.heightAt(box.center());
  double high = low;
  for (int i = 0; i <= samples; ++i)
    for (int j = 0; j <= samples; ++j) {
      const Eigen::Vector2d share(static_cast<double>(i) / samples,
                                  static_cast<double>(j) / samples);
      const double height = slab.heightAt(box.min() + share.cwiseProduct(box.sizes()));
      low = std::min(low, height);
      high = std::max(high, height);
    }
  return high - low;
}

} // namespace

std::optional<double>
levelOf(const PlanSlab& slab, const Eigen::AlignedBox2d& box)
{
  if (box.isEmpty() || !(spreadOf(slab, box) < level))
    return std::nullopt;
  return slab.heightAt(box.center());
}

bool
hasSlopingCeiling(const PlanRoom& room)
{
  // Fitted planes may tilt by some millimetres without being a roof.
  constexpr double sloping = 0.03; // metres
  const auto slopes = [](const PlanSlab& slab, const PlanLoop& loop) {
    const Eigen::AlignedBox2d box = boundsOf(loop);
    return !box.isEmpty() && spreadOf(slab, box) > sloping;
  };
  return slopes(room.ceiling, room.boundary) ||
         std::any_of(room.details.begin(), room.details.end(),
                     [&](const PlanDetail& detail) {
                       return slopes(detail.slab, detail.boundary);
                     });
}

int
sideOf(const PlanDetail& detail, const PlanSlab& slab)
{
  const Eigen::Vector2d middle = boundsOf(detail.boundary).center();
  const double above = detail.slab.heightAt(middle) - slab.heightAt(middle);
  return above > level ? 1 : above < -level ? -1 : 0;
}

bool
hasRaisedDetails(const PlanRoom& room)
{
  return std::any_of(
      room.details.begin(), room.details.end(),
      [&](const PlanDetail& detail) { return sideOf(detail, room.ceiling) > 0; });
}

bool
hasSunkenDetails(const PlanRoom& room)
{
  return std::any_of(
      room.floor_details.begin(), room.floor_details.end(),
      [&](const PlanDetail& detail) { return sideOf(detail, room.floor) < 0; });
}

} // namespace pcl::sedr::ifc
