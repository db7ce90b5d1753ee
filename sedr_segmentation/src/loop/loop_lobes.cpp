// SPDX-License-Identifier: BSD-3-Clause
#include "loop_lobes.h"

#include "sedr_filters/src/base/exactness.h"

#include "../curves/contour.h"
#include "../curves/plan_curve.h"

#include <optional>

namespace pcl::sedr {

namespace {

/** @brief Where a loop crosses itself. */
struct Crossing {
  std::size_t first = 0; ///< element
  std::size_t second = 0;
  double on_first = 0; ///< distance along it
  double on_second = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double lobe = 0;        ///< length of what is cut off
  bool is_between = true; ///< whether that is what lies between the two
};

bool
areNeighboursAt(const PlanLoop& loop, const Crossing& c)
{
  const std::size_t n = loop.elements.size();
  const auto isCorner = [&](std::size_t a, std::size_t b) {
    return (a + 1) % n == b && (loop.elements[a].end - c.at).norm() < same_point;
  };
  return isCorner(c.first, c.second) || isCorner(c.second, c.first);
}

/** @brief The crossing with the smallest lobe. */
std::optional<Crossing>
smallestLobe(const PlanLoop& loop)
{
  const auto& elements = loop.elements;
  std::vector<double> from(elements.size() + 1, 0);
  for (std::size_t i = 0; i < elements.size(); ++i)
    from[i + 1] = from[i] + elements[i].length();
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const auto& e : elements)
    boxes.push_back(boxAround(e));
  std::optional<Crossing> smallest;
  for (std::size_t a = 0; a < elements.size(); ++a)
    for (std::size_t b = a + 1; b < elements.size(); ++b) {
      if (boxes[a].exteriorDistance(boxes[b]) > 2 * same_point)
        continue;
      for (const auto& at :
           intersections(carrierOf(elements[a]), carrierOf(elements[b]))) {
        Crossing c{a, b, elements[a].project(at), elements[b].project(at), at, 0, true};
        if (elements[a].distance(at) > same_point ||
            elements[b].distance(at) > same_point || areNeighboursAt(loop, c))
          continue;
        const double between = from[b] + c.on_second - from[a] - c.on_first;
        c.is_between = between < from.back() - between;
        c.lobe = c.is_between ? between : from.back() - between;
        if (!smallest || c.lobe < smallest->lobe)
          smallest = c;
      }
    }
  return smallest;
}

void
cut(PlanLoop& loop, const Crossing& c)
{
  std::vector<PlanElement> kept;
  const auto keep = [&](PlanElement e, const Eigen::Vector2d& start,
                        const Eigen::Vector2d& end) {
    e.start = start;
    e.end = end;
    if ((start - end).norm() > same_point)
      kept.push_back(e);
  };
  const auto& elements = loop.elements;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const PlanElement& e = elements[i];
    const bool is_inside = i > c.first && i < c.second;
    if (i == c.first)
      c.is_between ? keep(e, e.start, c.at) : keep(e, c.at, e.end);
    else if (i == c.second)
      c.is_between ? keep(e, c.at, e.end) : keep(e, e.start, c.at);
    else if (is_inside != c.is_between)
      kept.push_back(e);
  }
  loop.elements = std::move(kept);
}

} // namespace

bool
cutLobes(PlanLoop& loop, const Priors& priors)
{
  const PlanLoop was = loop;
  const double longest = priors.share_half / 2 * loop.length();
  for (std::size_t n = loop.elements.size(); n > 0; --n) {
    const std::optional<Crossing> crossing = smallestLobe(loop);
    if (!crossing)
      break;
    if (crossing->lobe > longest)
      break;
    cut(loop, *crossing);
  }
  if (loop.elements.size() >= 2 && !smallestLobe(loop))
    return true;
  loop = was;
  return false;
}

void
dropPoints(PlanLoop& loop)
{
  auto& elements = loop.elements;
  for (std::size_t i = 0; i < elements.size() && elements.size() > 2;) {
    PlanElement& e = elements[i];
    if (e.isArc() || e.length() > 1e-6) {
      ++i;
      continue;
    }
    elements[(i + 1) % elements.size()].start = e.start;
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

} // namespace pcl::sedr
