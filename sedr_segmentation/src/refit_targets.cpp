// SPDX-License-Identifier: BSD-3-Clause
#include "refit_targets.h"

#include <algorithm>
#include <limits>
#include <map>

namespace pcl {
namespace sedr {

namespace {

/** @brief How far from the ends of an element its points are its own only, metres. */
constexpr double corner_margin = 0.06;

/** @brief How far from floor, ceiling and steps the points of an upright are its own
 * only, metres. */
constexpr double height_margin = 0.08;

/** @brief Edge of a patch of an upright and of a slab, metres. */
constexpr double upright_patch = 0.1;
constexpr double least_patch = 0.02;
constexpr double slab_patch = 0.25;

/** @brief The heights at which a surface shows its own points: of walls the upper half,
 * as furniture hides the lower. Of a narrow one, such as the side of a pilaster, so
 * little is seen that all of it counts. */
UprightSpan
heightsOf(const UprightSurface& surface, UprightSpan span)
{
  constexpr double narrow = 0.3;
  const double height = span.high - span.low;
  const double margin = std::min(height_margin, height / 4);
  const bool is_wall =
      (surface.kind == UprightKind::Wall || surface.kind == UprightKind::ColumnFace) &&
      surface.element->length() > narrow;
  return {span.low + (is_wall ? std::max(margin, height / 2) : margin),
          span.high - margin, true};
}

bool
areAlike(const UprightSpan& a, const UprightSpan& b)
{
  constexpr double slack = 0.02;
  return std::abs(a.low - b.low) < slack && std::abs(a.high - b.high) < slack;
}

/** @brief Smallest box around a loop. */
std::pair<Eigen::Vector2d, Eigen::Vector2d>
boundsOf(const PlanLoop& loop)
{
  Eigen::Vector2d low = loop.elements[0].start;
  Eigen::Vector2d high = low;
  for (const auto& p : loop.polygon(0.01)) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {low, high};
}

/** @brief Sets to -1 what has a neighbour of another value. */
std::vector<std::int32_t>
withoutEdges(const std::vector<std::int32_t>& values,
             std::int32_t width,
             std::int32_t height)
{
  std::vector<std::int32_t> result(values.size(), -1);
  for (std::int32_t y = 1; y + 1 < height; ++y)
    for (std::int32_t x = 1; x + 1 < width; ++x) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x);
      bool is_inner = true;
      for (std::int32_t dy = -1; dy <= 1; ++dy)
        for (std::int32_t dx = -1; dx <= 1; ++dx)
          is_inner = is_inner && values[static_cast<std::size_t>(y + dy) *
                                            static_cast<std::size_t>(width) +
                                        static_cast<std::size_t>(x + dx)] == values[at];
      if (is_inner)
        result[at] = values[at];
    }
  return result;
}

bool
isParallel(const PlanSlab& a, const PlanSlab& b)
{
  return (a.plane.head<3>() - b.plane.head<3>()).norm() < 1e-9;
}

} // namespace

RefitTargets::RefitTargets(Floorplan& plan, const PlanCurves& curves, double reach)
    : curves_(curves)
    , reach_(reach)
    , length_(curves.curves.size(), 0)
    , depth_(curves.curves.size(), 0)
    , gap_(curves.curves.size(), std::numeric_limits<double>::infinity())
{
  addUprights(plan);
  findGaps();
  for (auto& room : plan.rooms)
    addSlabs(room);
  numberPatches();
  tabulate();
}

double
RefitTargets::farthestMove(const std::vector<PlanSlab>& before) const
{
  double farthest = 0;
  for (std::size_t k = 0; k < slabs_.size(); ++k)
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) {
        const Eigen::Vector2d corner =
            slabs_[k].middle + slabs_[k].half.cwiseProduct(Eigen::Vector2d(x, y));
        farthest = std::max(farthest, std::abs(slabs_[k].slab->heightAt(corner) -
                                               before[k].heightAt(corner)));
      }
  return farthest;
}

bool
RefitTargets::isIn(const NicheSlabs& niche, const Eigen::Vector2d& p)
{
  constexpr double margin = 0.03;
  const PlanLoop& boundary = niche.niche->boundary;
  return boundary.contains(p) && boundary.distance(p) > margin;
}

void
RefitTargets::addUprights(Floorplan& plan)
{
  std::map<const PlanElement*, std::size_t> curve_of;
  for (const auto& loop : curves_.loops)
    for (std::size_t i = 0; i < loop.curves.size(); ++i)
      curve_of[&loop.loop->elements[i]] = loop.curves[i];
  for (const auto& room : plan.rooms)
    for (const auto& surface : uprightSurfaces(room)) {
      const auto it = curve_of.find(surface.element);
      if (it != curve_of.end())
        addStretches(surface, it->second);
    }
}

/** @brief Adds the parts of a surface between which its heights change. */
void
RefitTargets::addStretches(const UprightSurface& surface, std::size_t curve)
{
  constexpr double step = 0.05;
  const PlanElement& e = *surface.element;
  const double length = e.length();
  if (length <= 0)
    return;
  const bool is_round = e.isArc() && (e.start - e.end).norm() < 1e-9;
  const double margin = is_round ? 0 : std::min(corner_margin, length / 4);
  const double inner = length - 2 * margin;
  const auto parts = static_cast<std::size_t>(std::ceil(inner / step));
  const auto at = [&](std::size_t k) {
    return margin + inner * static_cast<double>(k) / static_cast<double>(parts);
  };
  std::size_t first = 0;
  UprightSpan span;
  for (std::size_t k = 0; k <= parts; ++k) {
    const UprightSpan here =
        k < parts ? surface.spanAt((at(k) + at(k + 1)) / 2) : UprightSpan{};
    if (k > 0 && k < parts && areAlike(here, span))
      continue;
    if (k > 0)
      addStretch(surface, curve, at(first), at(k), span);
    first = k;
    span = here;
  }
}

void
RefitTargets::addStretch(const UprightSurface& surface,
                         std::size_t curve,
                         double from,
                         double to,
                         const UprightSpan& span)
{
  constexpr double least_height = 0.04;
  const UprightSpan heights = heightsOf(surface, span);
  if (heights.high - heights.low < least_height || to <= from)
    return;
  const PlanElement& e = *surface.element;
  const bool is_whole = from <= 0 && to >= e.length();
  stretches_.push_back(
      {curve, is_whole ? e : e.part(from, to), heights.low, heights.high});
  length_[curve] += to - from;
  depth_[curve] = std::max(depth_[curve], heights.high - heights.low);
}

/** @brief Looks for stretches that run along each other at the same heights. */
void
RefitTargets::findGaps()
{
  constexpr double step = 0.1;
  constexpr double least_cosine = 0.9;
  const double farthest = 3 * reach_;
  const auto mayBeNear = [&](const PlanElement& a, const PlanElement& b) {
    return (a.pointAt(a.length() / 2) - b.pointAt(b.length() / 2)).norm() <
           (a.length() + b.length()) / 2 + farthest;
  };
  for (const Stretch& own : stretches_)
    for (const Stretch& other : stretches_) {
      if (own.curve == other.curve || own.low > other.high || other.low > own.high ||
          !mayBeNear(own.part, other.part))
        continue;
      const PlanCurve& along = curves_.curves[own.curve].curve;
      const PlanCurve& beside = curves_.curves[other.curve].curve;
      const double length = own.part.length();
      const auto parts = static_cast<std::size_t>(length / step) + 1;
      for (std::size_t k = 0; k <= parts; ++k) {
        const Eigen::Vector2d p = own.part.pointAt(length * static_cast<double>(k) /
                                                   static_cast<double>(parts));
        const double apart = beside.distance(p);
        if (apart < std::min(farthest, gap_[own.curve]) && other.part.isBeside(p) &&
            std::abs(along.tangentAt(p).dot(beside.tangentAt(p))) > least_cosine)
          gap_[own.curve] = apart;
      }
    }
}

/** @brief Numbers a slab; one that is parallel to `parallel_to` follows `parent`. */
std::size_t
RefitTargets::addSlab(PlanSlab& slab,
                      const Eigen::Vector2d& middle,
                      const Eigen::Vector2d& half,
                      const PlanSlab* parallel_to,
                      std::size_t parent)
{
  const bool follows = parallel_to && isParallel(slab, *parallel_to);
  slabs_.push_back({&slab, middle, follows ? parent : slabs_.size(), half});
  return slabs_.size() - 1;
}

void
RefitTargets::addSlabs(PlanRoom& room)
{
  constexpr double most_cells = 100000;
  const auto [low, high] = boundsOf(room.boundary);
  const Eigen::Vector2d extent = high - low;
  const auto add = [&](PlanSlab& slab, const PlanLoop& loop,
                       const PlanSlab* parallel_to, std::size_t parent) {
    const auto [from, to] = boundsOf(loop);
    return addSlab(slab, (from + to) / 2, (to - from) / 2, parallel_to, parent);
  };
  const std::size_t ceiling = add(room.ceiling, room.boundary, nullptr, 0);
  for (auto& detail : room.details)
    add(detail.slab, detail.boundary, &room.ceiling, ceiling);
  const std::size_t floor = add(room.floor, room.boundary, nullptr, 0);
  for (auto& detail : room.floor_details)
    add(detail.slab, detail.boundary, &room.floor, floor);
  for (auto& niche : room.niches) {
    const std::size_t bottom = add(niche.bottom, niche.boundary, &room.floor, floor);
    const std::size_t top = add(niche.top, niche.boundary, &room.ceiling, ceiling);
    niches_.push_back({&niche, bottom, top});
  }

  RoomMap map;
  map.cell = std::max(0.05, std::sqrt(extent.x() * extent.y() / most_cells));
  map.low = low;
  map.width = static_cast<std::int32_t>(extent.x() / map.cell) + 1;
  map.height = static_cast<std::int32_t>(extent.y() / map.cell) + 1;
  for (std::int32_t y = 0; y < map.height; ++y)
    for (std::int32_t x = 0; x < map.width; ++x) {
      const Eigen::Vector2d p = low + map.cell * Eigen::Vector2d(x + 0.5, y + 0.5);
      const bool is_inside = room.contains(p);
      map.ceiling.push_back(
          is_inside ? static_cast<std::int32_t>(ceiling) + 1 + room.detailAt(p) : -1);
      map.floor.push_back(is_inside ? static_cast<std::int32_t>(floor) + 1 +
                                          room.floorDetailAt(p)
                                    : -1);
    }
  map.ceiling = withoutEdges(map.ceiling, map.width, map.height);
  map.floor = withoutEdges(map.floor, map.width, map.height);
  rooms_.push_back(std::move(map));
}

void
RefitTargets::numberPatches()
{
  first_patch_.push_back(0);
  for (std::size_t c = 0; c < curves_.curves.size(); ++c) {
    const PlanCurve& curve = curves_.curves[c].curve;
    const double length =
        curve.isCircle() ? 2 * M_PI * curve.radius : 2 * curves_.reach(c);
    patch_.push_back(std::clamp(length_[c] / 4, least_patch, upright_patch));
    along_.push_back(static_cast<std::size_t>(length / patch_[c]) + 2);
    const auto rows = static_cast<std::size_t>(depth_[c] / upright_patch) + 1;
    shown_patches_ += rows * (static_cast<std::size_t>(length_[c] / patch_[c]) + 1);
    first_patch_.push_back(first_patch_.back() + along_.back() * rows);
  }
  for (const auto& slab : slabs_) {
    along_.push_back(static_cast<std::size_t>(2 * slab.half.x() / slab_patch) + 2);
    const auto rows = static_cast<std::size_t>(2 * slab.half.y() / slab_patch) + 2;
    shown_patches_ += rows * along_.back();
    first_patch_.push_back(first_patch_.back() + along_.back() * rows);
  }
}

/** @brief The row of patches at a height of a stretch, from the top down. */
std::size_t
RefitTargets::rowOf(const Stretch& stretch, double z)
{
  return static_cast<std::size_t>((stretch.high - z) / upright_patch);
}

/** @brief The patch of a slab at a place, from its first. */
std::size_t
RefitTargets::patchOf(std::size_t slab, const Eigen::Vector2d& p) const
{
  const std::size_t number = curves_.curves.size() + slab;
  const Eigen::Vector2d at =
      ((p - slabs_[slab].middle + slabs_[slab].half) / slab_patch).cwiseMax(0.0);
  const auto x = std::min(along_[number] - 1, static_cast<std::size_t>(at.x()));
  const std::size_t rows =
      (first_patch_[number + 1] - first_patch_[number]) / along_[number];
  const auto y = std::min(rows - 1, static_cast<std::size_t>(at.y()));
  return y * along_[number] + x;
}

/** @brief Sorts stretches, rooms and niches by the cells that they may be seen in. */
void
RefitTargets::tabulate()
{
  constexpr double step = 0.05;
  const auto around = [&](const CellTable& table, const Eigen::Vector2d& low,
                          const Eigen::Vector2d& high, double margin, std::size_t k) {
    const Eigen::Vector2d far = Eigen::Vector2d::Constant(margin);
    return CellTable::Entry{table.boxAround(low - far, high + far),
                            static_cast<std::uint32_t>(k)};
  };
  std::vector<CellTable::Entry> stretches;
  for (std::size_t k = 0; k < stretches_.size(); ++k) {
    const PlanElement& e = stretches_[k].part;
    const auto parts = static_cast<std::size_t>(std::ceil(e.length() / step)) + 1;
    for (std::size_t i = 0; i <= parts; ++i) {
      const Eigen::Vector2d p =
          e.pointAt(e.length() * static_cast<double>(i) / static_cast<double>(parts));
      stretches.push_back(around(stretches_near_, p, p, reach_ + step, k));
    }
  }
  std::vector<CellTable::Entry> rooms;
  for (std::size_t r = 0; r < rooms_.size(); ++r) {
    const RoomMap& map = rooms_[r];
    const Eigen::Vector2d extent(map.width * map.cell, map.height * map.cell);
    rooms.push_back(around(rooms_near_, map.low, map.low + extent, 0, r));
  }
  std::vector<CellTable::Entry> niches;
  for (std::size_t n = 0; n < niches_.size(); ++n) {
    const auto [low, high] = boundsOf(niches_[n].niche->boundary);
    niches.push_back(around(niches_near_, low, high, step, n));
  }
  for (const std::string& problem :
       {stretches_near_.fill(stretches), rooms_near_.fill(rooms),
        niches_near_.fill(niches)})
    if (problem_.empty())
      problem_ = problem;
}

} // namespace sedr
} // namespace pcl
