// SPDX-License-Identifier: BSD-3-Clause
#include "surface_fit.h"

#include "../scan/scan_excerpt.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pcl::sedr {

namespace {

/** @brief Depth below a ceiling to which the top of a wall reaches, metres. */
constexpr double top_of_wall = 0.5;

/** @brief Minimum edge of a patch, metres: below it a patch has no points. */
constexpr double min_patch = 0.02;

/** @brief Number of equal parts of at most `most` metres that make up `length`. */
std::size_t
partsOf(double length, double most)
{
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length / most)));
}

} // namespace

PatchPoints::PatchPoints(const Floorplan& plan,
                         const PlanUnknowns& unknowns,
                         const PointView& raw,
                         const std::vector<int>& indices,
                         const AdjustmentParameters& parameters)
    : unknowns_(unknowns)
    , parameters_(parameters)
    , farthest_(parameters.reach + 2 * parameters.coarse)
    , near_(parameters.patch)
{
  addWalls(plan);
  addSlabs(plan, parameters.threads);
  number();
  problem_ = tabulate();
  if (problem_.empty())
    gather(raw, indices);
  if (problem_.empty() && points_.empty())
    problem_ = "none of the " +
               std::to_string(indices.empty() ? raw.size() : indices.size()) +
               " points of the scan lies at a surface of the plan";
}

void
PatchPoints::addWalls(const Floorplan& plan)
{
  std::map<const PlanElement*, std::size_t> unknown_of;
  for (const UnknownLoop& loop : unknowns_.loops)
    for (std::size_t i = 0; i < loop.of_element.size(); ++i)
      unknown_of[&loop.loop->elements[i]] = loop.of_element[i];
  for (const PlanRoom& room : plan.rooms)
    for (const VerticalSurface& surface : verticalSurfaces(room))
      addWall(surface, unknown_of.at(surface.element));
}

/** @brief Adds columns along an element. A column has the heights that are the
 * surface's all along it. */
void
PatchPoints::addWall(const VerticalSurface& surface, std::size_t unknown)
{
  const PlanElement& e = *surface.element;
  const double length = e.length();
  const bool is_round = e.isArc() && (e.start - e.end).norm() < 1e-9;
  const double margin = is_round ? 0 : std::min(parameters_.margin, length / 4);
  const double inner = length - 2 * margin;
  if (!(inner > 0))
    return;
  const double most = std::max(
      min_patch, std::min(parameters_.patch, e.isArc() ? e.radius / 3 : inner / 2));
  const std::size_t columns = partsOf(inner, most);
  const double width = inner / static_cast<double>(columns);
  for (std::size_t k = 0; k < columns; ++k) {
    const double from = margin + width * static_cast<double>(k);
    PatchSite site;
    site.low = -std::numeric_limits<double>::infinity();
    site.high = -site.low;
    for (const double share : {0.05, 0.5, 0.95}) {
      const VerticalSpan span = surface.spanAt(from + share * width);
      site.low = std::max(site.low, span.low);
      site.high = std::min(site.high, span.high);
    }
    const double height = site.high - site.low;
    const double border = std::min(parameters_.margin, height / 4);
    site.low += border;
    site.high -= border;
    if (site.high - site.low < min_patch)
      continue;
    site.unknown = unknown;
    site.centre = e.pointAt(from + width / 2);
    if (unknowns_.all[unknown].run != 0)
      site.centre = unknowns_.all[unknown].curve().project(site.centre);
    site.direction = -leftOf(e.normalAt(from + width / 2));
    site.half = width / 2;
    site.is_wall =
        surface.kind == VerticalKind::Wall || surface.kind == VerticalKind::ColumnFace;
    site.patches =
        static_cast<std::uint32_t>(partsOf(site.high - site.low, parameters_.patch));
    sites_.push_back(site);
  }
}

/** @brief Adds the cells of a slab that are wholly its own. */
void
PatchPoints::addSlabs(const Floorplan& plan, unsigned threads)
{
  struct Area {
    std::size_t unknown;
    const PlanLoop* loop;
    const RoomLookup* room;
    int part; ///< detail or niche; -1: main
    bool is_floor;
    bool is_niche;
  };
  std::vector<Area> areas;
  std::vector<std::unique_ptr<RoomLookup>> rooms;
  std::size_t k = 0;
  for (const PlanRoom& room : plan.rooms) {
    rooms.push_back(std::make_unique<RoomLookup>(room));
    const auto add = [&](const PlanLoop& loop, int part, bool is_floor, bool is_niche) {
      const UnknownSlab& slab = unknowns_.slabs[k++];
      if (!slab.slab->curve)
        areas.push_back(
            {slab.unknown, &loop, rooms.back().get(), part, is_floor, is_niche});
    };
    for (const bool is_floor : {false, true}) {
      add(room.boundary, -1, is_floor, false);
      const auto& details = is_floor ? room.floor_details : room.details;
      for (std::size_t d = 0; d < details.size(); ++d)
        add(details[d].boundary, static_cast<int>(d), is_floor, false);
    }
    for (std::size_t n = 0; n < room.niches.size(); ++n)
      for (const bool is_floor : {true, false})
        add(room.niches[n].boundary, static_cast<int>(n), is_floor, true);
  }
  std::vector<std::vector<PatchSite>> found(areas.size());
  parallelBlocks(areas.size(), 1, threads, [&](std::size_t a, std::size_t) {
    const Area& area = areas[a];
    const auto isOwn = [&](const Eigen::Vector2d& p) {
      if (area.is_niche)
        return area.loop->contains(p);
      return area.room->contains(p) &&
             area.part ==
                 (area.is_floor ? area.room->floorDetailAt(p) : area.room->detailAt(p));
    };
    const double width =
        std::abs(area.loop->area()) / std::max(1e-9, area.loop->length());
    const double step = std::clamp(width, min_patch, parameters_.patch);
    const Eigen::AlignedBox2d box = boundsOf(*area.loop);
    if (box.isEmpty() || !box.sizes().allFinite())
      return;
    const Eigen::Vector2d low = (box.min() / step).array().floor() * step;
    const std::size_t columns = partsOf(box.max().x() - low.x(), step) + 1;
    const std::size_t lines = partsOf(box.max().y() - low.y(), step) + 1;
    std::vector<bool> before(columns, false); // the corners of the row below
    for (std::size_t y = 0; y < lines; ++y) {
      std::vector<bool> corners;
      for (std::size_t x = 0; x < columns; ++x)
        corners.push_back(isOwn(low + step * Eigen::Vector2d(static_cast<double>(x),
                                                             static_cast<double>(y))));
      for (std::size_t x = 1; x < columns; ++x)
        if (corners[x] && corners[x - 1] && before[x] && before[x - 1]) {
          PatchSite site;
          site.unknown = area.unknown;
          site.centre = low + step * Eigen::Vector2d(static_cast<double>(x) - 0.5,
                                                     static_cast<double>(y) - 0.5);
          site.half = step / 2;
          site.is_slab = true;
          found[a].push_back(site);
        }
      before = std::move(corners);
    }
  });
  for (const auto& sites : found)
    sites_.insert(sites_.end(), sites.begin(), sites.end());
}

void
PatchPoints::number()
{
  std::stable_sort(
      sites_.begin(), sites_.end(),
      [](const PatchSite& a, const PatchSite& b) { return a.unknown < b.unknown; });
  std::size_t s = 0;
  for (std::size_t u = 0; u <= unknowns_.all.size(); ++u) {
    first_patch_.push_back(is_top_.size());
    for (; s < sites_.size() && sites_[s].unknown == u; ++s) {
      PatchSite& site = sites_[s];
      site.first = static_cast<std::uint32_t>(is_top_.size());
      const double height = (site.high - site.low) / site.patches;
      for (std::uint32_t k = 0; k < site.patches; ++k)
        is_top_.push_back(site.is_wall &&
                          site.high - site.low - (k + 0.5) * height < top_of_wall);
    }
  }
}

std::string
PatchPoints::tabulate()
{
  for (std::size_t s = 0; s < sites_.size(); ++s) {
    const PatchSite& site = sites_[s];
    constexpr double inside = 1e-6; // of a cell, whose edges may be those of the table
    const Eigen::Vector2d along = site.half * site.direction.cwiseAbs();
    const Eigen::Vector2d extent = site.is_slab
                                       ? Eigen::Vector2d::Constant(site.half - inside)
                                       : Eigen::Vector2d(along.array() + farthest_);
    Eigen::AlignedBox2d box(site.centre - extent, site.centre + extent);
    if (const Unknown& u = unknowns_.all[site.unknown]; u.run != 0)
      for (const double z : {site.low, site.high}) {
        const Eigen::Vector2d off = u.run * (z - u.height) * leftOf(u.direction);
        box.extend(site.centre - extent + off);
        box.extend(site.centre + extent + off);
      }
    near_.addIn(box, static_cast<std::uint32_t>(s));
  }
  return near_.finish();
}

bool
PatchPoints::isBeside(const PatchSite& site,
                      const Eigen::Vector3d& p,
                      double& distance) const
{
  const Eigen::Vector2d to = p.head<2>() - site.centre;
  if (site.is_slab ? to.cwiseAbs().maxCoeff() > site.half
                   : p.z() < site.low || p.z() > site.high ||
                         std::abs(to.dot(site.direction)) > site.half)
    return false;
  distance = std::abs(unknowns_.all[site.unknown].distance(p));
  return distance <= farthest_;
}

/** @brief Adds a point to the patch of the nearest wall and of the nearest slab. */
void
PatchPoints::see(const Eigen::Vector3f& point, std::vector<Hit>& hits) const
{
  const Eigen::Vector3d p = point.cast<double>();
  if (!p.allFinite())
    return;
  const PatchSite* nearest[2] = {nullptr, nullptr};
  double least[2] = {HUGE_VAL, HUGE_VAL};
  for (const std::uint32_t s : near_.at(p.head<2>())) {
    const PatchSite& site = sites_[s];
    double distance = 0;
    const std::size_t kind = site.is_slab ? 1 : 0;
    if (!isBeside(site, p, distance) || distance >= least[kind])
      continue;
    least[kind] = distance;
    nearest[kind] = &site;
  }
  for (const PatchSite* site : nearest) {
    if (!site)
      continue;
    std::uint32_t row = 0;
    if (!site->is_slab)
      row = std::min(site->patches - 1, static_cast<std::uint32_t>(
                                            (p.z() - site->low) /
                                            (site->high - site->low) * site->patches));
    hits.push_back({site->first + row, point});
  }
}

void
PatchPoints::gather(const PointView& raw, const std::vector<int>& indices)
{
  constexpr std::size_t block = std::size_t{1} << 16;
  const std::size_t all = indices.empty() ? raw.size() : indices.size();
  const std::size_t step = rawStep(all, parameters_.max_points);
  const std::size_t size = (all + step - 1) / step;
  std::vector<std::vector<Hit>> hits((size + block - 1) / block);
  parallelBlocks(
      size, block, parameters_.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<Hit>& found = hits[begin / block];
        for (std::size_t k = begin * step; k < end * step && k < all; k += step)
          see(raw[indices.empty() ? k : static_cast<std::size_t>(indices[k])], found);
      });
  starts_.assign(patches() + 1, 0);
  for (const auto& found : hits)
    for (const Hit& hit : found)
      ++starts_[hit.patch + 1];
  for (std::size_t p = 0; p < patches(); ++p)
    starts_[p + 1] += starts_[p];
  points_.resize(starts_.back());
  std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
  for (auto& found : hits) {
    for (const Hit& hit : found)
      points_[next[hit.patch]++] = hit.point;
    found = {};
  }
}

} // namespace pcl::sedr
