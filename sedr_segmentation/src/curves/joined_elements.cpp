// SPDX-License-Identifier: BSD-3-Clause
#include "joined_elements.h"

#include "plan_curve.h"
#include "sedr_filters/src/base/exactness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Whether two elements follow one curve, or one of them is a step of no length
 * that is left between two lines that became one. */
bool
areOfOneCurve(const PlanElement& a, const PlanElement& b)
{
  if ((a.start - a.end).norm() < same_place || (b.start - b.end).norm() < same_place)
    return !a.isArc() && !b.isArc();
  if (a.isArc() != b.isArc())
    return false;
  if (a.isArc())
    return (a.centre - b.centre).norm() < same_line &&
           std::abs(a.radius - b.radius) < same_line &&
           a.counter_clockwise == b.counter_clockwise;
  const PlanCurve line = carrierOf(a);
  return line.distance(b.end) < same_line && line.direction.dot(b.end - b.start) > 0;
}

} // namespace

void
joinNeighbours(PlanLoop& loop)
{
  std::vector<PlanElement>& elements = loop.elements;
  for (std::size_t k = 0; k < elements.size() && elements.size() > 2;) {
    const std::size_t next = (k + 1) % elements.size();
    if (!areOfOneCurve(elements[k], elements[next])) {
      ++k;
      continue;
    }
    elements[k].end = elements[next].end;
    elements[k].inliers = std::max(elements[k].inliers, elements[next].inliers);
    elements[k].accuracy = worse(elements[k].accuracy, elements[next].accuracy);
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(next));
    k = next == 0 ? elements.size() : k;
  }
}

} // namespace pcl::sedr
