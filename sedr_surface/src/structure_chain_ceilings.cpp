// SPDX-License-Identifier: BSD-3-Clause
#include "all_indices.h"
#include "label_values.h"

#include <pcl/sedr_surface/structure_chain.h>

#include <pcl/sedr_filters/cell_mask.h>
#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/region_selection.h>
#include <pcl/sedr_segmentation/cell_count.h>
#include <pcl/sedr_segmentation/enclosed_regions.h>
#include <pcl/sedr_segmentation/plane_list.h>
#include <pcl/sedr_segmentation/room_territory.h>
#include <pcl/sedr_segmentation/sweep_gaps.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl {
namespace sedr {

namespace {

/** @brief The regions of a ceiling that are not kept but no specks. */
std::vector<std::size_t>
largerRest(const RegionMap& map)
{
  constexpr double least_area = 0.25; // square metres
  std::vector<std::size_t> rest;
  for (std::size_t r = 0; r < map.number.size(); ++r)
    if (map.number[r] == 0 &&
        static_cast<double>(map.regions.sizes[r]) * map.cell_size * map.cell_size >=
            least_area)
      rest.push_back(r);
  return rest;
}

/** @brief Those of some regions of a ceiling that lie along one that is kept: a duct
 * below the ceiling hides what joins them. Beside the strips of a vault there are
 * others.
 * @param others cells of other ceilings */
std::vector<CellSet>
alongKept(const RegionMap& map,
          const std::vector<std::size_t>& asked,
          const CellSet& others)
{
  constexpr double farthest = 1;      // metres from what is kept
  constexpr double least_near = 0.8;  // share of the region
  constexpr double rim = 0.15;        // metres around it
  constexpr double most_others = 0.1; // share of the rim
  const std::vector<CellSet> regions = map.regionCells();
  const CellSet kept = map.keptCells();
  const int reach = cellsFor(farthest, map.cell_size);
  const auto share = [](const CellMask& of, const CellMask& in) {
    return static_cast<double>(intersect(of, in).count()) /
           static_cast<double>(std::max<std::size_t>(1, of.count()));
  };
  std::vector<CellSet> strips;
  for (const std::size_t r : asked) {
    const CellBox box = grown(boxOf(regions[r]), reach);
    if (!maskProblem(box).empty())
      continue;
    const CellMask region(regions[r], box);
    const CellMask around =
        subtract(dilated(region, cellsFor(rim, map.cell_size)), region);
    if (share(region, dilated(CellMask(kept, box), reach)) >= least_near &&
        share(around, CellMask(others, box)) <= most_others)
      strips.push_back(regions[r]);
  }
  return strips;
}

} // namespace

bool
StructureChain::keepRegions(std::size_t ceiling,
                            const pcl::IndicesConstPtr& floors,
                            const pcl::Indices& all)
{
  const pcl::IndicesConstPtr seen(new pcl::Indices(levels_[ceiling].inliers));
  const auto filter = [&](const pcl::IndicesConstPtr& support) {
    outlier_removal.setIndices(seen);
    outlier_removal.setSupportIndices(support);
    outlier_removal.filter(levels_[ceiling].inliers);
    return outlier_removal.getErrorMessage().empty() ||
           fail(outlier_removal.getErrorMessage());
  };
  if (!filter(floors))
    return false;
  const PointView points(*cloud);
  const CellSet enclosed = enclosedRegions(outlier_removal.getRegionMap(), levels_,
                                           ceiling, points, all, room_segmentation);
  if (enclosed.empty())
    return true;
  const CellGrid grid(outlier_removal.getGridSize());
  pcl::IndicesPtr support(new pcl::Indices(*floors));
  for (const int i : *seen) { // walls around say as much as a floor below
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (enclosed.contains(grid.at(p.x(), p.y())))
      support->push_back(i);
  }
  return filter(support);
}

void
StructureChain::keepStrips(std::size_t ceiling,
                           const std::vector<int>& seen,
                           const pcl::Indices& floors)
{
  const RegionMap& map = outlier_removal.getRegionMap();
  std::vector<std::size_t> asked = largerRest(map);
  if (asked.empty())
    return;
  const CellGrid grid(outlier_removal.getGridSize());
  const PointView points(*cloud);
  const std::vector<std::size_t> supported =
      supportedCells(map.cells, map.regions, CellSet(grid, points, floors));
  asked.erase(std::remove_if(asked.begin(), asked.end(),
                             [&](std::size_t r) {
                               return static_cast<double>(supported[r]) <
                                      outlier_removal.getMinimumSupport() *
                                          static_cast<double>(map.regions.sizes[r]);
                             }),
              asked.end());
  CellSet others;
  for (std::size_t l = 0; l < levels_.size(); ++l)
    if (l != ceiling && levels_[l].kind == LevelKind::Ceiling)
      others = unite(others, levels_[l].cells);
  CellSet strips;
  for (const CellSet& strip : alongKept(map, asked, others))
    strips = unite(strips, strip);
  if (strips.empty())
    return;
  Level& level = levels_[ceiling];
  level.cells = unite(level.cells, strips);
  for (const int i : seen) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (strips.contains(grid.at(p.x(), p.y())))
      level.inliers.push_back(i);
  }
  std::sort(level.inliers.begin(), level.inliers.end());
}

void
StructureChain::fillSweepGaps(const pcl::Indices& all)
{
  constexpr double one_storey = 1;   // metres between ceilings, at most
  constexpr double worth_a_word = 1; // square metres
  const double size = outlier_removal.getGridSize();
  const CellGrid grid(size);
  std::vector<CellSet> gaps(levels_.size());
  parallelBlocks(
      levels_.size(), 1, room_segmentation.threads, [&](std::size_t l, std::size_t) {
        if (levels_[l].kind != LevelKind::Ceiling)
          return;
        CellSet others;
        for (std::size_t k = 0; k < levels_.size(); ++k)
          if (k != l && levels_[k].kind == LevelKind::Ceiling &&
              std::abs(levels_[k].height - levels_[l].height) < one_storey)
            others = unite(others, levels_[k].cells);
        gaps[l] = sweepGaps(levels_[l], others, size, PointView(*cloud), all);
      });
  std::size_t filled = 0;
  for (std::size_t l = 0; l < levels_.size(); ++l)
    for (std::size_t i = 0; i < gaps[l].size(); ++i, ++filled) {
      levels_[l].inliers.push_back(static_cast<int>(cloud->size()));
      const Eigen::Vector2d place = grid.centre(gaps[l][i]);
      cloud->push_back({static_cast<float>(place.x()), static_cast<float>(place.y()),
                        static_cast<float>(levels_[l].slab.heightAt(place))});
    }
  labels.resize(cloud->size(), 0);
  rooms.resize(cloud->size(), 0);
  const double area = static_cast<double>(filled) * size * size;
  if (area < worth_a_word)
    return;
  char text[160];
  std::snprintf(
      text, sizeof text,
      "%.1f square metres of ceilings were seen in lines of a scanner's sweep "
      "only: what is between these was filled in",
      area);
  warnings.push_back(text);
}

bool
StructureChain::removeOutliers(StageReport& report)
{
  pcl::IndicesPtr floors(new pcl::Indices);
  for (const auto& plane : planes)
    if (plane.kind == LevelKind::Floor)
      floors->insert(floors->end(), plane.inliers.indices.begin(),
                     plane.inliers.indices.end());
  outlier_removal.setInputCloud(cloud);
  levels_ = levelsOfPlanes(outlier_removal.getGridSize());
  fillSweepGaps(*allIndices(cloud->size()));
  const pcl::IndicesPtr all = allIndices(cloud->size());
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    if (level.kind == LevelKind::Ceiling) {
      const std::vector<int> seen = level.inliers;
      if (!keepRegions(l, floors, *all))
        return false;
      level.cells = outlier_removal.getRegionMap().keptCells();
      keepStrips(l, seen, *floors);
      tellResult("GridRegionOutlierRemoval");
    }
    if (level.kind != LevelKind::Other)
      report.points_out += level.inliers.size();
  }
  return true;
}

bool
StructureChain::partRooms(StageReport& report)
{
  const RoomParameters& parameters = room_segmentation;
  const PointView points(*cloud);
  std::string reason;
  regions_ =
      segmentRooms(points, *allIndices(cloud->size()), levels_, parameters, reason);
  if (!reason.empty())
    return fail(reason);
  if (regions_.empty()) {
    char text[240];
    std::snprintf(
        text, sizeof text,
        "no room of at least %.1f square metres with a floor below %.0f %% of its "
        "ceiling and walls around it, along %.0f %% more of its outline than is open; "
        "planes: ",
        parameters.minimum_area, 100 * parameters.minimum_floor_share,
        100 * parameters.minimum_enclosure);
    return fail(text + listOf(planes));
  }
  for (std::size_t l = 0; l < levels_.size(); ++l)
    report.points_out += labelCeilings(l);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    report.points_out += addHiddenCeiling(r);
  territory_ = territories();
  tellResult("RoomSegmentation");
  return true;
}

std::size_t
StructureChain::labelCeilings(std::size_t level)
{
  std::vector<CellKey> keys;
  for (const RoomRegion& region : regions_)
    if (region.ceiling_level == level)
      keys.insert(keys.end(), region.ceiling.keys().begin(),
                  region.ceiling.keys().end());
  const CellSet cells(std::move(keys));
  if (cells.empty())
    return 0;
  std::vector<std::uint32_t> room_of(cells.size(), 0);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    if (regions_[r].ceiling_level == level)
      for (const CellKey key : regions_[r].ceiling.keys())
        room_of[cells.find(cellOf(key))] = static_cast<std::uint32_t>(r + 1);
  const CellGrid grid(room_segmentation.cell_size);
  const PointView points(*cloud);
  std::size_t labelled = 0;
  for (const int i : levels_[level].inliers) {
    const auto at = static_cast<std::size_t>(i);
    const std::size_t cell = cells.find(grid.at(points[at].x(), points[at].y()));
    if (cell == CellSet::npos)
      continue;
    labels[at] = valueOf(StructureLabel::Ceiling);
    rooms[at] = room_of[cell];
    ++labelled;
  }
  return labelled;
}

std::size_t
StructureChain::addHiddenCeiling(std::size_t region)
{
  const CellGrid grid(room_segmentation.cell_size);
  const CellSet& hidden = regions_[region].hidden;
  const PlanSlab& slab = levels_[regions_[region].ceiling_level].slab;
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    const Eigen::Vector2d place = grid.centre(hidden[i]);
    cloud->push_back({static_cast<float>(place.x()), static_cast<float>(place.y()),
                      static_cast<float>(slab.heightAt(place))});
    labels.push_back(valueOf(StructureLabel::Ceiling));
    rooms.push_back(static_cast<std::uint32_t>(region + 1));
  }
  return hidden.size();
}

std::vector<CellSet>
StructureChain::scopes() const
{
  std::vector<CellSet> scopes;
  for (const auto& region : regions_)
    scopes.push_back(region.scope);
  return scopes;
}

std::vector<pcl::IndicesPtr>
StructureChain::territories() const
{
  const RoomTerritory territory(CellGrid(outlier_removal.getGridSize()), scopes());
  std::vector<pcl::IndicesPtr> result;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    result.emplace_back(new pcl::Indices);
  const PointView points(*cloud);
  const std::vector<std::int32_t> room =
      territory.roomsAt(points, room_segmentation.threads);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (room[i] >= 0)
      result[static_cast<std::size_t>(room[i])]->push_back(static_cast<int>(i));
  return result;
}

} // namespace sedr
} // namespace pcl
