// SPDX-License-Identifier: BSD-3-Clause
#include "border_steps.h"

#include "../shapes/shape_fit.h"

#include "../curves/contour.h"
#include "sedr_filters/src/plan/level_planes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl::sedr {

namespace {

using Place = Eigen::Vector2d;

constexpr double misfits = 4; // of a point that is of the other facet

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

/** @brief What a point counts against a facet. */
double
BorderSteps::misfit(std::int32_t piece, const Eigen::Vector3d& p) const
{
  const double share = distanceOf(cracks_.facetOf(piece), p) / deviation_;
  return std::min(share * share, misfits);
}

bool
BorderSteps::mayMeet(const Place& place, const CrackChain& chain) const
{
  const SheetGrid& grid = cracks_.sheet.grid;
  const std::size_t middle = grid.at(place);
  if (middle >= grid.count())
    return true;
  const PlanSlab& left = cracks_.facetOf(chain.left);
  const PlanSlab& right = cracks_.facetOf(chain.right);
  if (isRelief(left) || isRelief(right))
    return false;    // a free form meets nothing in a line
  double own = 0;    // of points against the facets of their cells,
  double lower = 0;  // against the lower one of both,
  double higher = 0; // and against the higher one
  for (const std::size_t cell : cells_.window(middle, 1)) {
    const std::int32_t piece = cracks_.cracks.piece[cell];
    if (piece != chain.left && piece != chain.right)
      continue;
    const double weight =
        1.0 / static_cast<double>(cells_.end(cell) - cells_.begin(cell));
    for (const Eigen::Vector3d* p = cells_.begin(cell); p != cells_.end(cell); ++p) {
      const double of_left = weight * misfit(chain.left, *p);
      const double of_right = weight * misfit(chain.right, *p);
      const auto at = p->head<2>();
      const bool is_left_lower = left.heightAt(at) < right.heightAt(at);
      own += piece == chain.left ? of_left : of_right;
      lower += is_left_lower ? of_left : of_right;
      higher += is_left_lower ? of_right : of_left;
    }
  }
  return std::min(lower, higher) < own + misfits;
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

/** @brief What speaks for a step at the edges of bins across it, from the right to the
 * left: each cell of points counts once. */
struct BorderSteps::Profile {
  static constexpr double bin = 0.0025; ///< metres

  double rightmost;             ///< edge, metres to the left of the cells' border
  std::vector<double> votes{};  ///< for the left facet, of what is on the right
  std::vector<double> risers{}; ///< of what is on the right
  std::vector<double> places{}; ///< across, of the points of risers

  double placeAt(std::size_t k) const
  {
    return rightmost + bin * static_cast<double>(k);
  }
};

BorderSteps::Profile
BorderSteps::profileAcross(const BorderPart& part,
                           double length,
                           const CrackChain& chain) const
{
  const SheetGrid& grid = cracks_.sheet.grid;
  Profile profile{-SheetCracks::riser_reach * grid.size};
  const auto bins = static_cast<std::size_t>(-2 * profile.rightmost / Profile::bin) + 1;
  profile.votes.assign(bins + 1, 0);
  profile.risers.assign(bins + 1, 0);
  const std::size_t middle = grid.at(part.through);
  if (middle >= grid.count())
    return profile;
  const Place along(part.normal.y(), -part.normal.x());
  const auto cell_reach = static_cast<int>(length / grid.size) + 4;
  const auto forAllNear = [&](const CellPoints& cells, double reach, auto use) {
    for (const std::size_t cell : cells.window(middle, cell_reach))
      for (const Eigen::Vector3d* p = cells.begin(cell); p != cells.end(cell); ++p) {
        const Place off = p->head<2>() - part.through;
        const double across = off.dot(part.normal);
        if (std::abs(off.dot(along)) <= length / 2 &&
            std::abs(across) < reach * grid.size)
          use(*p, across,
              static_cast<std::size_t>((across - profile.rightmost) / Profile::bin) + 1,
              1.0 / static_cast<double>(cells.end(cell) - cells.begin(cell)));
      }
  };
  forAllNear(cells_, SheetCracks::riser_reach,
             [&](const Eigen::Vector3d& p, double, std::size_t at, double weight) {
               profile.votes[at] +=
                   weight * (misfit(chain.right, p) - misfit(chain.left, p));
             });
  forAllNear(
      risers_, SheetCracks::riser_reach,
      [&](const Eigen::Vector3d& p, double across, std::size_t at, double weight) {
        if (!isBetween(p, chain))
          return;
        profile.risers[at] += misfits * weight;
        profile.places.push_back(across);
      });
  for (auto* sums : {&profile.votes, &profile.risers})
    std::partial_sum(sums->begin(), sums->end(), sums->begin());
  return profile;
}

/** @brief How far to the left of where its cells say a step lies: where most of its
 * riser is seen and most of both facets is on its own side. In the middle of what
 * nobody saw; but there a lower part of a ceiling hides the higher one, and ends where
 * it does. */
double
BorderSteps::bestShift(const BorderPart& part,
                       double length,
                       const CrackChain& chain) const
{
  constexpr double to_edge = 0.0125; // metres: of a voxel that an edge cuts
  constexpr std::ptrdiff_t min_points = 30;
  Profile profile = profileAcross(part, length, chain);
  const std::size_t bins = profile.votes.size() - 1;
  const auto width = static_cast<std::size_t>(2 * deviation_ / Profile::bin) + 1;
  const auto gainAt = [&](std::size_t k) {
    return profile.risers[std::min(bins, k + width)] -
           profile.risers[k > width ? k - width : 0] - 2 * profile.votes[k];
  };
  std::size_t first = 0; // of the best places, and the last of them
  for (std::size_t k = 1; k <= bins; ++k)
    if (gainAt(k) > gainAt(first) + 1e-9)
      first = k;
  std::size_t last = first;
  while (last < bins && gainAt(last + 1) > gainAt(first) - 1e-9)
    ++last;
  const double low = profile.placeAt(first);
  const double high = profile.placeAt(last);
  const double middle = (low + high) / 2;
  const auto begin = profile.places.begin();
  const auto end = std::partition(begin, profile.places.end(), [&](double across) {
    return std::abs(across - middle) < 2 * deviation_;
  });
  if (end - begin >= min_points)
    return std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin);
  const bool is_left_lower = cracks_.facetOf(chain.left).heightAt(part.through) <
                             cracks_.facetOf(chain.right).heightAt(part.through);
  if (high - low > cracks_.cellSize() && (is_left_lower ? last < bins : first > 0))
    return is_left_lower ? high - to_edge : low + to_edge;
  return first > 0 && last < bins ? middle : 0; // else points of one side only
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
  BorderPart meeting;
  meeting.one = &cracks.facetOf(chain.left);
  meeting.other = &cracks.facetOf(chain.right);
  std::vector<std::optional<Place>> met;
  for (std::size_t k = 0; k < raw.size(); ++k)
    met.push_back(steps.mayMeet(raw[k], chain) ? meeting.project(raw[k], reach[k])
                                               : std::nullopt);
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
