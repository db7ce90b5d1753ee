// SPDX-License-Identifier: BSD-3-Clause
#include "border_junctions.h"

#include <limits>
#include <optional>

namespace pcl::sedr {

namespace {

using Place = Eigen::Vector2d;
using Ends = std::vector<const BorderPart*>;

/** @brief The crossing nearest to a place of two parts, `steps` of which are steps. */
std::optional<Place>
nearestCrossing(const Ends& parts, int steps, const Place& near, double farthest)
{
  std::optional<Place> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if ((parts[i]->meets() ? 0 : 1) + (parts[j]->meets() ? 0 : 1) != steps)
        continue;
      const auto place = crossing(*parts[i], *parts[j], near, farthest);
      if (!place || (*place - near).norm() >= nearest)
        continue;
      nearest = (*place - near).norm();
      best = place;
    }
  return best;
}

Place
junctionOf(const CrackVertex& vertex, const Ends& parts, const SheetCracks& cracks)
{
  const Place raw = cracks.placeOf(vertex);
  const double farthest = 2 * cracks.reachAt(vertex);
  // Where facets meet counts more than where they step.
  for (const int steps : {0, 1, 2})
    if (const auto place = nearestCrossing(parts, steps, raw, farthest))
      return *place;
  for (const BorderPart* part : parts)
    if (const auto place = part->project(raw, farthest))
      return *place;
  return raw;
}

} // namespace

BorderJunctions
junctionsOf(const SheetCracks& cracks,
            const std::vector<std::vector<BorderPart>>& parts)
{
  std::map<CrackVertex, Ends> ends;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    const auto& vertices = cracks.cracks.chains[c].vertices;
    if (parts[c].empty() || vertices.front() == vertices.back())
      continue;
    if (cracks.isInside(vertices.front()))
      ends[vertices.front()].push_back(&parts[c].front());
    if (cracks.isInside(vertices.back()))
      ends[vertices.back()].push_back(&parts[c].back());
  }
  BorderJunctions junctions;
  for (const auto& [vertex, ending] : ends)
    junctions[vertex] = junctionOf(vertex, ending, cracks);
  return junctions;
}

Place
jointOf(const BorderPart& before, const BorderPart& after, const SheetCracks& cracks)
{
  const Place raw = (before.samples.back() + after.samples.front()) / 2;
  const double farthest = 2 * SheetCracks::reach * cracks.cellSize();
  if (const auto place = crossing(before, after, raw, farthest))
    return *place;
  return after.project(raw, farthest).value_or(raw);
}

} // namespace pcl::sedr
