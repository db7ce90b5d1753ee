// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/plane_fit.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/horizontal_plane_detection.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace pcl::sedr {

namespace {

std::string
problemOf(const LevelParameters& p)
{
  if (!(p.maximum_tilt >= 0 && p.maximum_tilt <= M_PI / 4))
    return "the maximum tilt must be within 0 and pi/4 radians, it is " +
           std::to_string(p.maximum_tilt);
  std::string problem =
      positiveProblem({{"the distance threshold", p.tolerance},
                       {"the grid size", p.cell_size},
                       {"the minimum room height", p.minimum_room_height}});
  if (problem.empty())
    problem = positiveProblem({{"the minimum area", p.minimum_area}}, "square metres");
  return problem.empty() ? problemOf(p.priors) : problem;
}

/** @brief A point that may be of a plane, with the number of its cell. */
struct Candidate {
  float z;
  std::size_t cell;
  int index;
};

/** @brief A plane and its cells. */
struct Level {
  PlanSlab slab;
  double height = 0;
  std::vector<std::size_t> cells; ///< increasing
  std::vector<int> inliers;
  LevelKind kind = LevelKind::Other;
};

/** @brief Finds the levels of some points, the largest first. */
class LevelSearch {
public:
  LevelSearch(const PointView& points,
              const pcl::Indices& indices,
              const LevelParameters& parameters)
      : points_(points)
      , p_(parameters)
      , grid_(parameters.cell_size)
  {
    std::vector<Candidate> all;
    std::map<CellKey, std::size_t> numbers;
    for (const int i : indices) {
      const auto at = static_cast<std::size_t>(i);
      if (!points.isFinite(at) || !grid_.holds(points[at].x(), points[at].y()))
        continue;
      const Cell cell = grid_.at(points[at].x(), points[at].y());
      const auto known = numbers.emplace(keyOf(cell), cells_.size());
      if (known.second)
        cells_.push_back(cell);
      all.push_back({points[at].z(), known.first->second, i});
    }
    leaveOutWalls(all);
  }

  std::vector<Level> run()
  {
    const double cell_area = grid_.size() * grid_.size();
    const auto least =
        static_cast<std::size_t>(std::max(1.0, p_.minimum_area / cell_area - 1e-9));
    std::vector<Level> levels;
    std::vector<Candidate> rest = candidates_;
    for (;;) {
      const auto [first, last] = densestWindow(rest, least);
      if (first == last)
        break;
      Level level;
      level.slab = slabOf(rest, first, last, p_.seed + levels.size());
      std::vector<std::uint8_t> is_own(cells_.size(), 0);
      for (const Candidate& c : rest)
        if (isNear(level.slab, c, p_.tolerance))
          is_own[c.cell] = 1;
      for (std::size_t cell = 0; cell < is_own.size(); ++cell)
        if (is_own[cell])
          level.cells.push_back(cell);
      const bool is_level = level.cells.size() >= least;
      // The tails of its noise would look like further levels just above and below.
      const double reach =
          std::clamp(6 * level.slab.residual, p_.tolerance, 2 * p_.tolerance);
      const float low = rest[first].z;
      const float high = rest[last - 1].z;
      rest.erase(std::remove_if(rest.begin(), rest.end(),
                                [&](const Candidate& c) {
                                  return is_level
                                             ? isNear(level.slab, c,
                                                      is_own[c.cell] ? reach
                                                                     : p_.tolerance)
                                             : c.z >= low && c.z <= high;
                                }),
                 rest.end());
      if (!is_level)
        continue;
      for (const Candidate& c : candidates_)
        if (isNear(level.slab, c, p_.tolerance))
          level.inliers.push_back(c.index);
      std::sort(level.inliers.begin(), level.inliers.end());
      level.height = heightOver(level);
      levels.push_back(std::move(level));
    }
    std::sort(levels.begin(), levels.end(),
              [](const Level& a, const Level& b) { return a.height < b.height; });
    classify(levels);
    return levels;
  }

private:
  /** @brief Keeps the points that are of no vertical face: whose profile has no run of
   * points through them. */
  void leaveOutWalls(std::vector<Candidate>& all)
  {
    const double thickest = 4 * p_.tolerance; // a slab with its noise
    std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
      return std::tie(a.cell, a.z, a.index) < std::tie(b.cell, b.z, b.index);
    });
    for (std::size_t first = 0; first < all.size();) {
      std::size_t last = first + 1;
      while (last < all.size() && all[last].cell == all[first].cell &&
             all[last].z - all[last - 1].z <= p_.priors.run_gap)
        ++last;
      if (all[last - 1].z - all[first].z <= thickest)
        candidates_.insert(candidates_.end(),
                           all.begin() + static_cast<std::ptrdiff_t>(first),
                           all.begin() + static_cast<std::ptrdiff_t>(last));
      first = last;
    }
    std::sort(candidates_.begin(), candidates_.end(),
              [](const Candidate& a, const Candidate& b) {
                return std::tie(a.z, a.index) < std::tie(b.z, b.index);
              });
  }

  /** @brief Returns the window of two tolerances with most cells; empty if there are
   * fewer than `least`. */
  std::pair<std::size_t, std::size_t>
  densestWindow(const std::vector<Candidate>& sorted, std::size_t least) const
  {
    std::vector<std::uint32_t> count(cells_.size(), 0);
    std::size_t cells = 0;
    std::size_t most = least - 1;
    std::pair<std::size_t, std::size_t> best(0, 0);
    for (std::size_t low = 0, high = 0; high < sorted.size(); ++high) {
      cells += count[sorted[high].cell]++ == 0 ? 1 : 0;
      for (; sorted[high].z - sorted[low].z > 2 * p_.tolerance; ++low)
        cells -= --count[sorted[low].cell] == 0 ? 1 : 0;
      if (cells <= most)
        continue;
      most = cells;
      best = {low, high + 1};
    }
    return best;
  }

  /** @brief Fits a plane to a point of each cell in and just beside a window. */
  PlanSlab slabOf(const std::vector<Candidate>& sorted,
                  std::size_t first,
                  std::size_t last,
                  std::uint64_t seed) const
  {
    const double low = sorted[first].z - 2 * p_.tolerance;
    const double high = sorted[last - 1].z + 2 * p_.tolerance;
    const double middle = (low + high) / 2;
    std::vector<const Candidate*> nearest(cells_.size(), nullptr);
    for (const Candidate& c : sorted)
      if (c.z >= low && c.z <= high &&
          (!nearest[c.cell] ||
           std::abs(c.z - middle) < std::abs(nearest[c.cell]->z - middle)))
        nearest[c.cell] = &c;
    Positions places;
    for (const Candidate* c : nearest)
      if (c)
        places.push_back(points_[static_cast<std::size_t>(c->index)]);
    const PlanSlab core = findSlab(places, std::min(p_.priors.slab_noise, p_.tolerance),
                                   p_.maximum_tilt, seed, p_.threads);
    const PlanSlab whole = fitSlabRobustly(places, core, p_.tolerance);
    const bool is_noise = whole.residual < 0.45 * p_.tolerance; // not several surfaces
    return is_noise && whole.plane[2] >= std::cos(p_.maximum_tilt) ? whole : core;
  }

  bool isNear(const PlanSlab& slab, const Candidate& c, double band) const
  {
    return std::abs(distanceAbove(slab, points_[static_cast<std::size_t>(c.index)])) <=
           band;
  }

  double heightOver(const Level& level) const
  {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const std::size_t cell : level.cells)
      middle += grid_.centre(cells_[cell]) / static_cast<double>(level.cells.size());
    return level.slab.heightAt(middle);
  }

  /** @brief A ceiling is the top level over most of its cells and has a level at least
   * a room's height below it; the lowest one below a tenth of it is its floor. */
  void classify(std::vector<Level>& levels) const
  {
    constexpr double seen_below = 0.1;
    std::vector<std::size_t> top(cells_.size(), 0);
    for (std::size_t l = 0; l < levels.size(); ++l)
      for (const std::size_t cell : levels[l].cells)
        top[cell] = l;
    std::vector<std::uint8_t> is_below(cells_.size(), 0);
    for (std::size_t l = levels.size(); l-- > 0;) {
      const std::vector<std::size_t>& own = levels[l].cells;
      const auto highest =
          std::count_if(own.begin(), own.end(), [&](auto c) { return top[c] == l; });
      if (levels[l].kind == LevelKind::Floor ||
          2 * highest < static_cast<std::ptrdiff_t>(own.size()))
        continue;
      std::fill(is_below.begin(), is_below.end(), 0);
      for (const std::size_t cell : own)
        is_below[cell] = 1;
      const auto floor = std::find_if(
          levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(l),
          [&](const Level& lower) {
            const auto shared = std::count_if(lower.cells.begin(), lower.cells.end(),
                                              [&](auto c) { return is_below[c] != 0; });
            return levels[l].height - lower.height >= p_.minimum_room_height &&
                   lower.kind != LevelKind::Ceiling &&
                   static_cast<double>(shared) >=
                       seen_below * static_cast<double>(own.size());
          });
      if (floor == levels.begin() + static_cast<std::ptrdiff_t>(l))
        continue;
      floor->kind = LevelKind::Floor;
      levels[l].kind = LevelKind::Ceiling;
    }
  }

  const PointView& points_;
  const LevelParameters& p_;
  CellGrid grid_;
  std::vector<Cell> cells_;
  std::vector<Candidate> candidates_; ///< by height
};

} // namespace

std::string
detectHorizontalPlanes(const PointView& points,
                       const pcl::Indices& indices,
                       const LevelParameters& parameters,
                       std::vector<pcl::HorizontalPlane>& planes)
{
  std::string problem = indicesProblem(indices, points.size());
  if (problem.empty())
    problem = problemOf(parameters);
  if (!problem.empty())
    return problem;
  LevelSearch search(points, indices, parameters);
  for (Level& level : search.run()) {
    pcl::HorizontalPlane plane;
    plane.inliers.indices = std::move(level.inliers);
    for (int k = 0; k < 4; ++k)
      plane.coefficients.values.push_back(static_cast<float>(level.slab.plane[k]));
    plane.kind = level.kind;
    plane.height = level.height;
    plane.cells = level.cells.size();
    plane.area =
        static_cast<double>(plane.cells) * parameters.cell_size * parameters.cell_size;
    plane.residual = level.slab.residual;
    plane.slab = level.slab;
    planes.push_back(std::move(plane));
  }
  if (!planes.empty())
    return {};
  return "no horizontal plane of at least " + std::to_string(parameters.minimum_area) +
         " square metres in " + std::to_string(indices.size()) + " points";
}

} // namespace pcl::sedr

PCL_INSTANTIATE(HorizontalPlaneDetection, SEDR_POINT_TYPES)
