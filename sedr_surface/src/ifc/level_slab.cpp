// SPDX-License-Identifier: BSD-3-Clause
#include "level_slab.h"

#include <algorithm>

namespace pcl {
namespace sedr {
namespace ifc {

namespace {

constexpr double level = 0.001; ///< heights that differ by less are one, metres

} // namespace

std::optional<double>
levelOf(const PlanSlab& slab, const Eigen::AlignedBox2d& box)
{
  constexpr int samples = 8;
  if (box.isEmpty())
    return std::nullopt;
  const double middle = slab.heightAt(box.center());
  for (int i = 0; i <= samples; ++i)
    for (int j = 0; j <= samples; ++j) {
      const Eigen::Vector2d share(static_cast<double>(i) / samples,
                                  static_cast<double>(j) / samples);
      const double height = slab.heightAt(box.min() + share.cwiseProduct(box.sizes()));
      if (!(std::abs(height - middle) < level / 2))
        return std::nullopt;
    }
  return middle;
}

Eigen::AlignedBox2d
boxOf(const PlanLoop& loop)
{
  constexpr double chord_tolerance = 0.001;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : loop.polygon(chord_tolerance))
    box.extend(corner);
  return box;
}

bool
hasSlopingCeiling(const PlanRoom& room)
{
  // Fits lean by some millimetres: that is no roof.
  constexpr double sloping = 0.03; // metres
  const Eigen::AlignedBox2d box = boxOf(room.boundary);
  const auto slopes = [&](const PlanSlab& slab, const Eigen::AlignedBox2d& of) {
    double low = slab.heightAt(of.center());
    double high = low;
    for (const double x : {of.min().x(), of.max().x()})
      for (const double y : {of.min().y(), of.max().y()}) {
        low = std::min(low, slab.heightAt({x, y}));
        high = std::max(high, slab.heightAt({x, y}));
      }
    return high - low > sloping;
  };
  return slopes(room.ceiling, box) ||
         std::any_of(room.details.begin(), room.details.end(),
                     [&](const PlanDetail& detail) {
                       return slopes(detail.slab, boxOf(detail.boundary));
                     });
}

int
sideOf(const PlanDetail& detail, const PlanSlab& slab)
{
  const Eigen::Vector2d middle = boxOf(detail.boundary).center();
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

} // namespace ifc
} // namespace sedr
} // namespace pcl
