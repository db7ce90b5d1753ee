// SPDX-License-Identifier: BSD-3-Clause
#include "loop_necks.h"

#include "sedr_filters/src/base/exactness.h"

#include "../curves/plan_segment.h"

#include "../curves/contour.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief A way beside a loop, from where an element starts to a place on another. */
struct Neck {
  std::size_t corner = 0;
  std::size_t element = 0;
  double along = 0; ///< distance from that element's start
  double length = 0;
};

/** @brief The part of a loop from the neck's corner to its other end, closed by it, or
 * the rest. */
PlanLoop
partOf(const PlanLoop& loop, const Neck& neck, bool is_rest)
{
  const std::size_t n = loop.elements.size();
  const PlanElement& touched = loop.elements[neck.element];
  const Eigen::Vector2d place = touched.pointAt(neck.along);
  PlanLoop part;
  const auto keep = [&](PlanElement e, const Eigen::Vector2d& start,
                        const Eigen::Vector2d& end) {
    e.start = start;
    e.end = end;
    if ((end - start).norm() > same_point)
      part.elements.push_back(e);
  };
  if (is_rest) {
    keep(touched, place, touched.end);
    for (std::size_t i = (neck.element + 1) % n; i != neck.corner; i = (i + 1) % n)
      part.elements.push_back(loop.elements[i]);
  }
  else {
    for (std::size_t i = neck.corner; i != neck.element; i = (i + 1) % n)
      part.elements.push_back(loop.elements[i]);
    keep(touched, touched.start, place);
  }
  if (!part.elements.empty())
    keep(segment({}, {}), part.elements.back().end, part.elements.front().start);
  return part;
}

/** @brief Whether a way lies on one side of a loop all along: inside, or outside. */
bool
runsOnSide(const PlanLoop& loop,
           bool is_inside,
           const Eigen::Vector2d& from,
           const Eigen::Vector2d& to)
{
  for (const double s : {0.1, 0.5, 0.9})
    if (loop.contains(from + s * (to - from)) != is_inside)
      return false;
  return true;
}

/** @brief What is left of a loop where a neck is cut, if that is one. */
std::optional<PlanLoop>
withoutPart(const PlanLoop& loop, bool is_inside, const Neck& neck, double max_area)
{
  constexpr double min_outline = 4; // times the neck's length
  const PlanLoop parts[2] = {partOf(loop, neck, false), partOf(loop, neck, true)};
  const bool is_first_small = std::abs(parts[0].area()) < std::abs(parts[1].area());
  const PlanLoop& small = parts[is_first_small ? 0 : 1];
  if (small.elements.size() < 3 || std::abs(small.area()) > max_area ||
      (small.area() > 0) != is_inside ||
      small.length() - neck.length < min_outline * neck.length)
    return std::nullopt;
  const PlanLoop& rest = parts[is_first_small ? 1 : 0];
  if (crossesItself(rest.polygon(chord)))
    return std::nullopt;
  return rest;
}

/** @brief The loop without what the narrowest neck on a side cuts off. */
std::optional<PlanLoop>
withoutNarrowest(const PlanLoop& loop, bool is_inside, double width, double max_area)
{
  const std::size_t n = loop.elements.size();
  std::vector<Neck> necks;
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t e = 0; e < n; ++e) {
      const Eigen::Vector2d& corner = loop.elements[c].start;
      if (e == c || (e + 1) % n == c)
        continue;
      const double along =
          std::clamp(loop.elements[e].project(corner), 0.0, loop.elements[e].length());
      const double length = (loop.elements[e].pointAt(along) - corner).norm();
      if (length < width && length > same_point)
        necks.push_back({c, e, along, length});
    }
  std::sort(necks.begin(), necks.end(), [](const Neck& a, const Neck& b) {
    return a.length != b.length ? a.length < b.length
                                : std::make_pair(a.corner, a.element) <
                                      std::make_pair(b.corner, b.element);
  });
  for (const Neck& neck : necks) {
    const PlanElement& e = loop.elements[neck.element];
    if (!runsOnSide(loop, is_inside, loop.elements[neck.corner].start,
                    e.pointAt(neck.along)))
      continue;
    if (auto rest = withoutPart(loop, is_inside, neck, max_area))
      return rest;
  }
  return std::nullopt;
}

} // namespace

std::size_t
cutNecks(PlanLoop& loop, const Priors& priors)
{
  std::size_t count = 0;
  for (const bool is_inside : {true, false}) {
    const double width = is_inside ? priors.wall_band : priors.min_wall;
    while (auto rest = withoutNarrowest(loop, is_inside, width, priors.small_area)) {
      loop = std::move(*rest);
      ++count;
    }
  }
  return count;
}

} // namespace pcl::sedr
