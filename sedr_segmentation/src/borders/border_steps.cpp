// SPDX-License-Identifier: BSD-3-Clause
#include "border_steps.h"

#include "../shapes/shape_fit.h"
#include "../surface/cell_points.h"

#include "../curves/contour.h"
#include "sedr_filters/src/base/quantiles.h"
#include "sedr_filters/src/plan/plan_geometry.h"

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
        parts.back().normal.dot(part.normal) > 0.999 &&
        std::abs(part.normal.dot(parts.back().through - part.through)) <
            cracks_.cellSize()) {
      parts.back().samples.push_back(part.samples.back());
      continue;
    }
    parts.push_back(std::move(part));
  }
}

bool
BorderSteps::isLeftLower(const BorderPart& part, const CrackChain& chain) const
{
  return cracks_.facetOf(chain.left).heightAt(part.through) <
         cracks_.facetOf(chain.right).heightAt(part.through);
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
  constexpr double deviations = 5;
  const PlanSlab& left = cracks_.facetOf(chain.left);
  const PlanSlab& right = cracks_.facetOf(chain.right);
  const double margin =
      std::max(RiserBins::margin, deviations * std::max(left.residual, right.residual));
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
 * left: sums over what is on the right of each edge. */
struct BorderSteps::Profile {
  static constexpr double bin = 0.0025; ///< metres

  double rightmost;             ///< edge, metres to the left of the cells' border
  std::vector<double> votes{};  ///< for the left facet; a cell of points counts once
  std::vector<double> risers{}; ///< for a riser; a cell of its points counts once
  std::vector<double> points{}; ///< number of the points of risers
  std::vector<double> places{}; ///< sum of where they lie across
  std::vector<double> lower{};  ///< number of the points of the lower facet

  double placeAt(std::size_t k) const
  {
    return rightmost + bin * static_cast<double>(k);
  }

  double endOfLower(bool is_left) const;
};

BorderSteps::Profile
BorderSteps::profileAcross(const BorderPart& part,
                           double length,
                           const CrackChain& chain) const
{
  const SheetGrid& grid = cracks_.sheet.grid;
  Profile profile{-2 * SheetCracks::reach * grid.size};
  const auto bins = static_cast<std::size_t>(-2 * profile.rightmost / Profile::bin) + 1;
  const auto sums = {&profile.votes, &profile.risers, &profile.points, &profile.places,
                     &profile.lower};
  for (auto* sum : sums)
    sum->assign(bins + 1, 0);
  const std::size_t middle = grid.at(part.through);
  if (middle >= grid.count())
    return profile;
  const Place along(part.normal.y(), -part.normal.x());
  const std::int32_t lower = isLeftLower(part, chain) ? chain.left : chain.right;
  const auto cell_reach = static_cast<int>(length / grid.size) + 4;
  // At its ends are walls, or what goes round a corner.
  const double half = std::max(length / 2 - grid.size, length / 4);
  // Calls use(point, bin, weight): a cell of points for which `counts` counts once.
  const auto forAllNear = [&](const CellPoints& cells, auto counts, auto use) {
    for (const std::size_t cell : cells.window(middle, cell_reach)) {
      const auto size = std::count_if(cells.begin(cell), cells.end(cell), counts);
      for (const Eigen::Vector3d* p = cells.begin(cell); p != cells.end(cell); ++p) {
        const Place off = p->head<2>() - part.through;
        const double across = off.dot(part.normal) - profile.rightmost;
        if (std::abs(off.dot(along)) <= half && across > 0 &&
            across < -2 * profile.rightmost)
          use(*p, static_cast<std::size_t>(across / Profile::bin) + 1,
              1.0 / static_cast<double>(size));
      }
    }
  };
  const auto all = [](const Eigen::Vector3d&) { return true; };
  forAllNear(cells_, all, [&](const auto& p, std::size_t at, double weight) {
    profile.votes[at] += weight * (misfit(chain.right, p) - misfit(chain.left, p));
  });
  const auto isOfRiser = [&](const auto& p) { return isBetween(p, chain); };
  forAllNear(risers_, isOfRiser, [&](const auto& p, std::size_t at, double weight) {
    if (isOfRiser(p)) {
      profile.risers[at] += misfits * weight;
      profile.points[at] += 1;
      profile.places[at] += (p.template head<2>() - part.through).dot(part.normal);
    }
    else if (misfit(lower, p) < misfits)
      profile.lower[at] += 1;
  });
  for (auto* sum : sums)
    std::partial_sum(sum->begin(), sum->end(), sum->begin());
  return profile;
}

/** @brief Where the points of the lower facet get rare, which lies on the left of it or
 * on the right: the place of most likelihood if a point beyond it counts as a misfit.
 */
double
BorderSteps::Profile::endOfLower(bool is_left) const
{
  constexpr std::size_t width = 16; // bins
  std::vector<double> densities;    // points a bin
  for (std::size_t k = width; k < lower.size(); ++k)
    if (lower[k] > lower[k - width])
      densities.push_back((lower[k] - lower[k - width]) / width);
  if (densities.empty())
    return 0;
  const double missing =
      (1 - std::exp(-misfits / 2)) * middleValue(std::move(densities));
  const auto costAt = [&](std::size_t k) {
    const double cost = lower[k] * misfits / 2 - missing * static_cast<double>(k);
    return is_left ? cost : -cost;
  };
  std::size_t best = 0;
  for (std::size_t k = 1; k < lower.size(); ++k)
    if (costAt(k) < costAt(best))
      best = k;
  return placeAt(best);
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
  constexpr double min_points = 30; // of a riser: a few are noise of the higher facet
  const Profile profile = profileAcross(part, length, chain);
  const std::size_t bins = profile.votes.size() - 1;
  const auto width = static_cast<std::size_t>(2 * deviation_ / Profile::bin) + 1;
  const auto around = [&](const std::vector<double>& sums, std::size_t k) {
    return sums[std::min(bins, k + width)] - sums[k > width ? k - width : 0];
  };
  const auto hasRiser = [&](std::size_t k) {
    return around(profile.points, k) >= min_points;
  };
  const auto gainAt = [&](std::size_t k) {
    return (hasRiser(k) ? around(profile.risers, k) : 0) - 2 * profile.votes[k];
  };
  std::size_t first = 0; // of the best places, and the last of them
  for (std::size_t k = 1; k <= bins; ++k)
    if (gainAt(k) > gainAt(first) + 1e-9)
      first = k;
  std::size_t last = first;
  while (last < bins && gainAt(last + 1) > gainAt(first) - 1e-9)
    ++last;
  const std::size_t middle = (first + last) / 2;
  if (hasRiser(middle))
    return around(profile.places, middle) / around(profile.points, middle);
  const double low = profile.placeAt(first);
  const double high = profile.placeAt(last);
  const bool is_left_lower = isLeftLower(part, chain);
  if (high - low > cracks_.cellSize() && (is_left_lower ? last < bins : first > 0))
    return profile.endOfLower(is_left_lower);
  return first > 0 && last < bins ? (low + high) / 2 : 0; // else points of one side
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
