// SPDX-License-Identifier: BSD-3-Clause
#include "short_elements.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief Returns the corner of two straight elements that are joined by a short one.
 */
std::optional<Eigen::Vector2d>
cornerOf(const PlanElement& before,
         const PlanElement& between,
         const PlanElement& after,
         double reach)
{
  const Eigen::Vector2d middle = (between.start + between.end) / 2;
  const Eigen::Vector2d u = before.end - before.start;
  const Eigen::Vector2d v = after.end - after.start;
  const double across = u.x() * v.y() - u.y() * v.x();
  if (std::abs(across) > 1e-9) {
    const Eigen::Vector2d w = after.start - before.start;
    const double share = (w.x() * v.y() - w.y() * v.x()) / across;
    const Eigen::Vector2d corner = before.start + share * u;
    if ((corner - middle).norm() < reach && (corner - before.start).dot(u) > 0 &&
        (after.end - corner).dot(v) > 0)
      return corner;
  }
  if (between.length() < reach / 10) // far below the noise
    return middle;
  return std::nullopt;
}

void
removeShortElements(PlanLoop& loop, double shortest)
{
  std::vector<PlanElement>& elements = loop.elements;
  for (std::size_t k = 0; k < elements.size() && elements.size() > 3;) {
    const std::size_t n = elements.size();
    PlanElement& before = elements[(k + n - 1) % n];
    PlanElement& after = elements[(k + 1) % n];
    std::optional<Eigen::Vector2d> corner;
    if (elements[k].length() < shortest && !elements[k].isArc() && !before.isArc() &&
        !after.isArc())
      corner = cornerOf(before, elements[k], after, shortest);
    if (!corner) {
      ++k;
      continue;
    }
    before.end = *corner;
    after.start = *corner;
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(k));
    k = 0; // its neighbours may be short by now
  }
}

} // namespace

void
removeShortElements(Floorplan& plan, const Priors& priors)
{
  for (PlanRoom& room : plan.rooms) {
    removeShortElements(room.boundary, priors.wall_noise);
    for (PlanLoop& column : room.columns)
      removeShortElements(column, priors.wall_noise);
  }
}

} // namespace pcl::sedr
