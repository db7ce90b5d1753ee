// SPDX-License-Identifier: BSD-3-Clause
#include "facet_borders.h"

#include "border_steps.h"

#include "../curves/contour.h"

#include <limits>
#include <map>
#include <optional>

namespace pcl::sedr {

namespace {

using Place = Eigen::Vector2d;

/** @brief Where the borders of three pieces or more come together. */
using BorderJunctions = std::map<CrackVertex, Eigen::Vector2d>;

using Ends = std::vector<const BorderPart*>;

/** @brief Where parts cross that come together near a place, of all crossings the
 * nearest; where none do, on the first part there is. */
Place
meetingOf(const Ends& parts, const Place& near, double farthest)
{
  std::optional<Place> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto place = crossing(*parts[i], *parts[j], near, farthest);
      if (!place || (*place - near).norm() >= nearest)
        continue;
      nearest = (*place - near).norm();
      best = place;
    }
  if (best)
    return *best;
  for (const BorderPart* part : parts)
    if (const auto place = part->project(near, farthest))
      return *place;
  return near;
}

/** @brief The junctions in the room: where the parts that end at a vertex cross.
 * @param parts of each chain */
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
    junctions[vertex] =
        meetingOf(ending, cracks.placeOf(vertex), 2 * cracks.reachAt(vertex));
  return junctions;
}

/** @brief Where one part of a chain goes over into the next. */
Place
jointOf(const BorderPart& before, const BorderPart& after, const SheetCracks& cracks)
{
  return meetingOf({&after, &before},
                   (before.samples.back() + after.samples.front()) / 2,
                   2 * SheetCracks::reach * cracks.cellSize());
}

/** @brief Puts the parts of each chain together to one line. */
class BorderLines {
public:
  BorderLines(const SheetCracks& cracks,
              const std::vector<std::vector<BorderPart>>& parts)
      : cracks_(cracks)
      , parts_(parts)
      , junctions_(junctionsOf(cracks, parts))
  {}

  std::vector<Place> lineOf(std::size_t c) const
  {
    const auto& vertices = cracks_.cracks.chains[c].vertices;
    const std::vector<BorderPart>& parts = parts_[c];
    if (parts.empty())
      return rawLine(vertices);
    std::vector<Place> line;
    const bool is_closed = vertices.front() == vertices.back();
    if (!is_closed)
      line = endOf(vertices.front(), parts.front(), parts.front().samples.front());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (k > 0)
        line.push_back(jointOf(parts[k - 1], parts[k], cracks_));
      else if (is_closed)
        line.push_back(jointOf(parts.back(), parts.front(), cracks_));
      if (parts[k].meets())
        addSamples(parts[k], line);
    }
    if (is_closed)
      line.push_back(line.front());
    else {
      const auto end =
          endOf(vertices.back(), parts.back(), parts.back().samples.back());
      line.insert(line.end(), end.rbegin(), end.rend());
    }
    return simplifiedLine(line, border_tolerance);
  }

private:
  std::vector<Place> rawLine(const std::vector<CrackVertex>& vertices) const
  {
    std::vector<Place> line;
    for (const CrackVertex& v : vertices)
      line.push_back(cracks_.placeOf(v));
    return simplifiedLine(line, border_tolerance);
  }

  /** @brief The places from the end of a chain to where its last part begins: its
   * junction, or what leads there from beside the room.
   * @param sample of the part that is nearest to the end */
  std::vector<Place>
  endOf(const CrackVertex& vertex, const BorderPart& part, const Place& sample) const
  {
    const auto junction = junctions_.find(vertex);
    if (junction != junctions_.end())
      return {junction->second};
    const Place outside = cracks_.placeOf(vertex);
    return {outside, beyond(part, sample, outside)};
  }

  /** @brief A place on the line of a part, a little farther out than its sample. */
  Place beyond(const BorderPart& part, const Place& sample, const Place& outside) const
  {
    const double step = 2.2 * cracks_.cellSize();
    const Place on_line = part.project(sample, step).value_or(sample);
    const Place normal = part.sideOf(on_line).second;
    Place way(-normal.y(), normal.x());
    if (way.dot(outside - on_line) < 0)
      way = -way;
    const Place out = on_line + step * way;
    return part.project(out, step).value_or(out);
  }

  /** @brief Adds the samples of a part that do not lie beside its ends. */
  void addSamples(const BorderPart& part, std::vector<Place>& line) const
  {
    const double margin = 2 * cracks_.cellSize();
    const Place& first = part.samples.front();
    const Place& last = part.samples.back();
    const bool is_round = (first - last).norm() < margin && part.samples.size() > 8;
    for (const Place& sample : part.samples)
      if (is_round ||
          ((sample - first).norm() > margin && (sample - last).norm() > margin))
        line.push_back(sample);
  }

  const SheetCracks& cracks_;
  const std::vector<std::vector<BorderPart>>& parts_; ///< of each chain
  const BorderJunctions junctions_;
};

} // namespace

std::vector<std::vector<Eigen::Vector2d>>
bordersOf(const FacetSheet& sheet,
          const CellCracks& cracks,
          const std::vector<Eigen::Vector3d>& points,
          const std::vector<Eigen::Vector3d>& risers,
          const std::vector<double>& directions)
{
  const SheetCracks pieces{sheet, cracks};
  const CellPoints cells(sheet.grid, sheet.is_inside, points);
  const CellPoints vertical(sheet.grid, sheet.is_inside, risers);
  const BorderSteps steps(pieces, cells, vertical, directions);
  std::vector<std::vector<BorderPart>> parts;
  for (const CrackChain& chain : cracks.chains)
    parts.push_back(partsOf(chain, pieces, steps));
  const BorderLines lines(pieces, parts);
  std::vector<std::vector<Eigen::Vector2d>> borders;
  for (std::size_t c = 0; c < cracks.chains.size(); ++c)
    borders.push_back(lines.lineOf(c));
  return borders;
}

} // namespace pcl::sedr
