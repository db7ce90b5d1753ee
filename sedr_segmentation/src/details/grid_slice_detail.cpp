// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/grids/cell_mask.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/grid_slice_detail.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

std::string
problemOf(const SliceParameters& parameters)
{
  if (parameters.trials < 1 || parameters.trials > 3)
    return "the number of trials must be from 1 to 3, it is " +
           std::to_string(parameters.trials);
  const std::string problem =
      positiveProblem({{"the grid size", parameters.cell_size},
                       {"the distance threshold", parameters.tolerance},
                       {"the slice thickness", parameters.slice_thickness}});
  return problem.empty() ? problemOf(parameters.priors) : problem;
}

std::string
problemOf(const SliceInput& input)
{
  const std::size_t size = input.points.size();
  std::string problem = indicesProblem(input.indices, size);
  if (!problem.empty())
    return problem;
  if (!input.ceiling || input.ceiling->empty())
    return "no ceiling points were set";
  problem = indicesProblem("ceiling", input.ceiling, size);
  if (!problem.empty() || std::isfinite(input.floor_height))
    return problem;
  if (!input.floor || input.floor->empty())
    return "neither floor points nor a floor height were set";
  return indicesProblem("floor", input.floor, size);
}

pcl::Indices
finiteOf(const PointView& points, const pcl::Indices& indices)
{
  pcl::Indices kept;
  for (const auto i : indices)
    if (points.isFinite(static_cast<std::size_t>(i)))
      kept.push_back(i);
  return kept;
}

/** @brief The points of each cell of a box, by height. */
std::vector<std::vector<std::pair<float, int>>>
profilesOf(const SliceInput& input, const CellGrid& grid, const CellMask& frame)
{
  std::vector<std::vector<std::pair<float, int>>> profiles(frame.values().size());
  for (const int i : input.indices) {
    const Eigen::Vector3f p = input.points[static_cast<std::size_t>(i)];
    if (!std::isfinite(p.z()) || !grid.holds(p.x(), p.y()))
      continue;
    if (const Cell cell = grid.at(p.x(), p.y()); frame.isInside(cell))
      profiles[frame.indexOf(cell)].emplace_back(p.z(), i);
  }
  for (auto& profile : profiles)
    std::sort(profile.begin(), profile.end());
  return profiles;
}

/** @brief A room on the grid. */
struct SliceScene {
  const SliceParameters& parameters;
  const PlanSlab& slab;
  double floor_height;
  CellGrid grid;
  CellMask ceiling;
  std::vector<std::vector<std::pair<float, int>>> profiles; ///< height, index

  /** @brief Returns whether a point of the cell lies within [low, high]. */
  bool hasWithin(Cell cell, double low, double high) const
  {
    const auto& profile = profiles[ceiling.indexOf(cell)];
    return std::any_of(profile.begin(), profile.end(), [&](const auto& point) {
      return point.first >= low && point.first <= high;
    });
  }

  double ceilingAt(Cell cell) const { return slab.heightAt(grid.centre(cell)); }

  /** @brief Returns the height of a slice at `fraction` of the room height from the
   * top. */
  double sliceAt(Cell cell, double fraction) const
  {
    const double top = ceilingAt(cell);
    return top - fraction * (top - floor_height);
  }
};

/** @brief Returns the cells with points in the slice. */
CellMask
sliceMask(const SliceScene& scene, double fraction)
{
  CellMask slice(scene.ceiling.box());
  const double half = scene.parameters.slice_thickness / 2;
  for (std::size_t i = 0; i < slice.values().size(); ++i) {
    const Cell cell = slice.cellAt(i);
    const double z = scene.sliceAt(cell, fraction);
    slice.values()[i] = scene.hasWithin(cell, z - half, z + half) ? 1 : 0;
  }
  return slice;
}

/** @brief Returns the zero-valued regions of the minimum size with points between slice
 * and ceiling in at least half of their cells. */
std::vector<CellSet>
acceptedRegions(const SliceScene& scene,
                const CellMask& enclosed,
                double lowest_fraction)
{
  const MaskRegions regions = labelRegions(enclosed, true);
  std::vector<std::vector<CellKey>> cells(regions.sizes.size());
  std::vector<std::size_t> seen(regions.sizes.size(), 0);
  for (std::size_t i = 0; i < regions.label.size(); ++i) {
    if (regions.label[i] < 0)
      continue;
    const auto r = static_cast<std::size_t>(regions.label[i]);
    const Cell cell = enclosed.cellAt(i);
    cells[r].push_back(keyOf(cell));
    seen[r] += scene.hasWithin(cell, scene.sliceAt(cell, lowest_fraction),
                               scene.ceilingAt(cell) + scene.parameters.tolerance)
                   ? 1
                   : 0;
  }
  std::vector<CellSet> accepted;
  for (std::size_t r = 0; r < cells.size(); ++r)
    if (cells[r].size() >= scene.parameters.minimum_cells &&
        2 * seen[r] >= cells[r].size())
      accepted.push_back(CellSet::fromSorted(std::move(cells[r])));
  return accepted;
}

/** @brief Runs trials until the slices of one enclose a detail: zero-valued cells that
 * slices and ceiling enclose together, but not the ceiling alone.
 * @return the regions of the details */
std::vector<CellSet>
runTrials(const SliceScene& scene, int& trial)
{
  const std::vector<std::vector<double>> fractions{{1.0 / 4},
                                                   {1.0 / 2},
                                                   {1.0 / 8, 3.0 / 8}};
  const CellMask by_ceiling = enclosedCells(scene.ceiling);
  for (int number = 1; number <= scene.parameters.trials; ++number) {
    const std::vector<double>& of_trial =
        fractions[static_cast<std::size_t>(number - 1)];
    CellMask slices(scene.ceiling.box());
    for (const double fraction : of_trial)
      // Dilation by one cell closes the pinholes of a sparse wall.
      slices = unite(slices, dilated(sliceMask(scene, fraction), 1));
    const CellMask enclosed =
        subtract(enclosedCells(unite(scene.ceiling, slices)), by_ceiling);
    std::vector<CellSet> regions = acceptedRegions(scene, enclosed, of_trial.back());
    if (regions.empty())
      continue;
    trial = number;
    return regions;
  }
  return {};
}

/** @brief Collects the points of the details: the uppermost run of each profile if it
 * starts above half the room's height. This leaves out walls, which rise from below. */
void
collectPoints(const SliceScene& scene,
              std::vector<CellSet> regions,
              SliceDetails& details)
{
  std::stable_sort(regions.begin(), regions.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  std::vector<std::pair<int, std::size_t>> found;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < regions.size(); ++r) {
    details.sizes.push_back(regions[r].size());
    for (std::size_t k = 0; k < regions[r].size(); ++k) {
      const Cell cell = regions[r][k];
      const auto& profile = scene.profiles[scene.ceiling.indexOf(cell)];
      std::size_t first = profile.empty() ? 0 : profile.size() - 1;
      while (first > 0 && profile[first].first - profile[first - 1].first <=
                              scene.parameters.priors.run_gap)
        --first;
      if (profile.empty() || profile[first].first <= scene.sliceAt(cell, 0.5))
        continue;
      lowest = std::min<double>(lowest, profile[first].first);
      for (; first < profile.size(); ++first)
        found.emplace_back(profile[first].second, r);
    }
  }
  std::sort(found.begin(), found.end());
  for (const auto& [index, region] : found) {
    details.indices.push_back(index);
    details.region.push_back(region);
  }
  if (std::isfinite(lowest))
    details.slice_height = lowest - scene.parameters.cell_size;
}

} // namespace

std::string
analyseSlices(const SliceInput& input,
              const SliceParameters& parameters,
              SliceDetails& details)
{
  std::string problem = problemOf(parameters);
  if (problem.empty())
    problem = problemOf(input);
  if (!problem.empty())
    return problem;
  const bool has_height = std::isfinite(input.floor_height);
  const pcl::Indices ceiling = finiteOf(input.points, *input.ceiling);
  const pcl::Indices floor =
      has_height ? pcl::Indices() : finiteOf(input.points, *input.floor);
  if (ceiling.empty() || (floor.empty() && !has_height))
    return "of " + std::to_string(input.ceiling->size()) + " ceiling points " +
           std::to_string(ceiling.size()) + " are finite, of the floor's " +
           std::to_string(floor.size());
  const double maximum_tilt = radians(parameters.priors.max_slab_tilt);
  const PlanSlab slab =
      findSlab(positionsOf(input.points, ceiling), parameters.tolerance, maximum_tilt,
               input.seed, parameters.threads);
  double floor_height = input.floor_height;
  if (!has_height) {
    double sum = 0;
    for (const auto i : floor)
      sum += input.points[static_cast<std::size_t>(i)].z();
    floor_height = sum / static_cast<double>(floor.size());
  }
  const CellGrid grid(parameters.cell_size);
  const CellSet cells(grid, input.points, ceiling);
  const CellBox all = boxOf(CellSet(grid, input.points, input.indices));
  const int margin = cellsFor(parameters.priors.max_soffit_reach, grid.size());
  const CellBox box = grown(overlapOf(grown(boxOf(cells), margin), all), 3);
  problem = maskProblem(box);
  if (!problem.empty())
    return problem;
  const CellMask mask(cells, box);
  const SliceScene scene{parameters, slab, floor_height,
                         grid,       mask, profilesOf(input, grid, mask)};
  collectPoints(scene, runTrials(scene, details.trial), details);
  return {};
}

} // namespace pcl::sedr

PCL_INSTANTIATE(GridSliceDetail, SEDR_POINT_TYPES)
