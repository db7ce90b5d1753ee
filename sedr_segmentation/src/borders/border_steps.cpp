// SPDX-License-Identifier: BSD-3-Clause
#include "border_steps.h"

#include "../shapes/shape_fit.h"

#include "../curves/contour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

using Place = Eigen::Vector2d;

/** @brief The place that has most votes on its left, those on its right taken away: 0
 * where all are alike. In the middle of a gap without votes, but where a lower part of
 * a ceiling hides what is in it, at the end of that part.
 * @param lower -1: it lies on the right, 1: on the left
 * @param wide metres: narrower gaps hide nothing */
double
placeOfBest(const std::vector<std::pair<double, double>>& votes, int lower, double wide)
{
  constexpr double to_edge = 0.0125; // metres: of a voxel that an edge cuts
  std::vector<double> sums{0};
  for (const auto& vote : votes)
    sums.front() += vote.second;
  for (const auto& vote : votes)
    sums.push_back(sums.back() - 2 * vote.second);
  const double best = *std::max_element(sums.begin(), sums.end()) - 1e-9;
  std::size_t first = 0;
  while (sums[first] < best)
    ++first;
  std::size_t last = first;
  while (last + 1 < sums.size() && sums[last + 1] >= best)
    ++last;
  const double endless = std::numeric_limits<double>::infinity();
  const double right = first == 0 ? -endless : votes[first - 1].first;
  const double left = last + 1 == sums.size() ? endless : votes[last].first;
  if (lower != 0 && left - right > wide) {
    const double end = lower > 0 ? left - to_edge : right + to_edge;
    return std::isfinite(end) ? end : 0;
  }
  return std::isfinite(left - right) ? (right + left) / 2 : 0; // points on both sides
}

} // namespace

void
BorderSteps::append(const std::vector<Place>& vertices,
                    const CrackChain& chain,
                    std::vector<BorderPart>& parts) const
{
  const std::vector<Place> corners = simplifiedLine(vertices, 1.2 * cracks_.cellSize());
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const Place way = corners[k + 1] - corners[k];
    if (way.norm() < 1e-9)
      continue;
    BorderPart part;
    part.samples = {corners[k], corners[k + 1]};
    const Place along = alongWalls(way.normalized());
    part.normal = Place(-along.y(), along.x()); // to the left
    part.through = (corners[k] + corners[k + 1]) / 2;
    const Place shift = bestShift(part, way.norm(), chain) * part.normal;
    part.through += shift;
    for (Place& sample : part.samples)
      sample += shift;
    // What runs on along the same line is one step.
    if (!parts.empty() && !parts.back().meets() &&
        std::abs(parts.back().normal.dot(part.normal)) > 0.999 &&
        std::abs(part.normal.dot(parts.back().through - part.through)) <
            cracks_.cellSize()) {
      parts.back().samples.push_back(part.samples.back());
      continue;
    }
    parts.push_back(std::move(part));
  }
}

std::vector<bool>
BorderSteps::risersAlong(const std::vector<Place>& places,
                         const CrackChain& chain) const
{
  constexpr int reach = 2; // cells
  constexpr std::size_t min_points = 10;
  const SheetGrid& grid = cracks_.sheet.grid;
  std::map<std::size_t, std::vector<std::size_t>> near; // places about a cell
  for (std::size_t k = 0; k < places.size(); ++k)
    if (const std::size_t cell = grid.at(places[k]); cell < grid.count())
      for (const std::size_t about : risers_.window(cell, reach))
        near[about].push_back(k);
  std::vector<std::size_t> counts(places.size(), 0);
  for (const auto& [cell, about] : near)
    for (const Eigen::Vector3d* p = risers_.begin(cell); p != risers_.end(cell); ++p) {
      if (!isBetween(*p, chain))
        continue;
      ++counts[*std::min_element(about.begin(), about.end(),
                                 [&](std::size_t a, std::size_t b) {
                                   return (p->head<2>() - places[a]).squaredNorm() <
                                          (p->head<2>() - places[b]).squaredNorm();
                                 })];
    }
  std::vector<bool> has_riser;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    std::size_t sum = counts[k];
    sum += k > 0 ? counts[k - 1] : 0;
    sum += k + 1 < counts.size() ? counts[k + 1] : 0;
    has_riser.push_back(sum >= min_points);
  }
  return has_riser;
}

/** @brief Whether a point lies above one facet and below another, farther than the
 * noise of either explains. */
bool
BorderSteps::isBetween(const Eigen::Vector3d& p, const CrackChain& chain) const
{
  constexpr double least = 0.03; // metres
  constexpr double deviations = 5;
  const PlanSlab& left = cracks_.facetOf(chain.left);
  const PlanSlab& right = cracks_.facetOf(chain.right);
  const double margin =
      std::max(least, deviations * std::max(left.residual, right.residual));
  const double above_left = distanceOf(left, p);
  const double above_right = distanceOf(right, p);
  return std::min(above_left, above_right) < -margin &&
         std::max(above_left, above_right) > margin;
}

/** @brief The way of the wall that runs nearly as `way` does, else `way`. */
Place
BorderSteps::alongWalls(const Place& way) const
{
  constexpr double nearly = 0.26; // radians: a line of cells tells no more
  for (const double direction : directions_)
    for (const double turn : {0.0, M_PI / 2}) {
      const Place wall(std::cos(direction + turn), std::sin(direction + turn));
      if (std::abs(wall.dot(way)) > std::cos(nearly))
        return wall.dot(way) > 0 ? wall : Place(-wall);
    }
  return way;
}

/** @brief Calls `use(point, across)` for the points beside a part, as far as its line
 * may be off. */
template <typename Use>
void
BorderSteps::forAllNear(const CellPoints& cells,
                        const BorderPart& part,
                        double length,
                        double reach,
                        Use use) const
{
  const SheetGrid& grid = cracks_.sheet.grid;
  const Place along(part.normal.y(), -part.normal.x());
  const std::size_t middle = grid.at(part.through);
  if (middle >= grid.count())
    return;
  const auto cell_reach = static_cast<int>(length / grid.size) + 4;
  for (const std::size_t cell : cells.window(middle, cell_reach))
    for (const Eigen::Vector3d* p = cells.begin(cell); p != cells.end(cell); ++p) {
      const Place off = p->head<2>() - part.through;
      const double across = off.dot(part.normal);
      if (std::abs(off.dot(along)) <= length / 2 &&
          std::abs(across) <= reach * grid.size)
        use(*p, across);
    }
}

/** @brief How far a step lies to the left of where its cells say: where its riser was
 * seen, else such that most points lie on the side of their facet. */
double
BorderSteps::bestShift(const BorderPart& part,
                       double length,
                       const CrackChain& chain) const
{
  if (const auto shift = shiftToRiser(part, length, chain))
    return *shift;
  const double deviation = std::max(0.003, 2 * cracks_.sheet.noise);
  std::vector<std::pair<double, double>> votes; // place across, for the left facet
  forAllNear(cells_, part, length, SheetCracks::reach,
             [&](const Eigen::Vector3d& p, double across) {
               const auto misfit = [&](std::int32_t piece) {
                 const double share = distanceOf(cracks_.facetOf(piece), p) / deviation;
                 return std::min(share * share, 4.0);
               };
               votes.emplace_back(across, misfit(chain.right) - misfit(chain.left));
             });
  std::sort(votes.begin(), votes.end());
  const double left = cracks_.facetOf(chain.left).heightAt(part.through);
  const double right = cracks_.facetOf(chain.right).heightAt(part.through);
  return placeOfBest(votes, left < right ? 1 : -1, cracks_.cellSize());
}

/** @brief How far to the left the vertical face between the two facets lies, if one was
 * seen: where most of what lies between their heights is. */
std::optional<double>
BorderSteps::shiftToRiser(const BorderPart& part,
                          double length,
                          const CrackChain& chain) const
{
  constexpr std::size_t min_points = 30;
  constexpr double min_share = 0.4; // else it is no one face
  const double deviation = std::max(0.003, 2 * cracks_.sheet.noise);
  std::vector<double> places;
  forAllNear(risers_, part, length, SheetCracks::riser_reach,
             [&](const Eigen::Vector3d& p, double across) {
               if (isBetween(p, chain))
                 places.push_back(across);
             });
  if (places.size() < min_points)
    return std::nullopt;
  std::sort(places.begin(), places.end());
  const double width = 4 * deviation;
  std::vector<std::size_t> counts; // of the places within a width before each
  for (std::size_t low = 0, high = 0; high < places.size(); ++high) {
    while (places[high] - places[low] > width)
      ++low;
    counts.push_back(high - low + 1);
  }
  // Of several faces the nearest: that of the other side of a beam may be as large.
  const std::size_t enough = *std::max_element(counts.begin(), counts.end()) / 2;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < places.size(); ++k)
    if (counts[k] >= enough && std::abs(places[k] - width / 2) < std::abs(nearest))
      nearest = places[k] - width / 2;
  std::size_t first = 0;
  std::size_t most = 0;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (counts[k] > most && std::abs(places[k] - width / 2 - nearest) < 1.5 * width) {
      most = counts[k];
      first = k + 1 - counts[k];
    }
  if (static_cast<double>(most) < min_share * static_cast<double>(places.size()))
    return std::nullopt;
  double sum = 0;
  for (std::size_t k = first; k < first + most; ++k)
    sum += places[k];
  return sum / static_cast<double>(most);
}

namespace {

/** @brief Whether most around a vertex of a chain meet. */
std::vector<bool>
smoothed(const std::vector<std::optional<Place>>& met)
{
  constexpr std::ptrdiff_t around = 4; // vertices to each side
  std::vector<bool> meets;
  const auto count = static_cast<std::ptrdiff_t>(met.size());
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    int votes = 0;
    for (std::ptrdiff_t n = std::max<std::ptrdiff_t>(0, k - around);
         n <= std::min(count - 1, k + around); ++n)
      votes += met[static_cast<std::size_t>(n)] ? 1 : -1;
    meets.push_back(votes > 0);
  }
  return meets;
}

} // namespace

std::vector<BorderPart>
partsOf(const CrackChain& chain, const SheetCracks& cracks, const BorderSteps& steps)
{
  if (chain.left < 0 || chain.right < 0)
    return {};
  std::vector<Place> raw;
  std::vector<double> reach;
  for (const CrackVertex& v : chain.vertices)
    if (cracks.isInside(v)) {
      raw.push_back(cracks.placeOf(v));
      reach.push_back(cracks.reachAt(v));
    }
  const std::vector<bool> has_riser = steps.risersAlong(raw, chain);
  BorderPart meeting;
  meeting.one = &cracks.facetOf(chain.left);
  meeting.other = &cracks.facetOf(chain.right);
  std::vector<std::optional<Place>> met;
  for (std::size_t k = 0; k < raw.size(); ++k)
    met.push_back(has_riser[k] ? std::nullopt : meeting.project(raw[k], reach[k]));
  const std::vector<bool> meets = smoothed(met);
  std::vector<BorderPart> parts;
  for (std::size_t first = 0; first < raw.size();) {
    std::size_t last = first + 1;
    while (last < raw.size() && meets[last] == meets[first])
      ++last;
    if (meets[first]) {
      parts.push_back(meeting);
      for (std::size_t k = first; k < last; ++k)
        if (met[k])
          parts.back().samples.push_back(*met[k]);
    }
    else
      steps.append({raw.begin() + static_cast<std::ptrdiff_t>(first),
                    raw.begin() + static_cast<std::ptrdiff_t>(last)},
                   chain, parts);
    first = last;
  }
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                             [](const BorderPart& p) { return p.samples.empty(); }),
              parts.end());
  return parts;
}

} // namespace pcl::sedr
