// SPDX-License-Identifier: BSD-3-Clause
#include "refit_targets.h"

#include "sedr_filters/src/plan/plan_bounds.h"
#include <algorithm>
#include <map>

namespace pcl::sedr {

namespace {

/** @brief Distance from an element's ends beyond which points are unambiguous, metres.
 */
constexpr double corner_margin = 0.06;

/** @brief Distance from floor, ceiling and steps beyond which the points of a vertical
 * surface are unambiguous, metres. */
constexpr double height_margin = 0.08;

/** @brief Minimum edge of a patch of a short vertical surface, metres. */
constexpr double min_patch = 0.02;

/** @brief Returns the heights in use of a surface: the upper half of walls, as
 * furniture hides the lower half. Narrow surfaces, such as the side of a pilaster, have
 * few points and use all heights. */
VerticalSpan
heightsOf(const VerticalSurface& surface, VerticalSpan span)
{
  constexpr double narrow = 0.3;
  const double height = span.high - span.low;
  const double margin = std::min(height_margin, height / 4);
  const bool is_wall = (surface.kind == VerticalKind::Wall ||
                        surface.kind == VerticalKind::ColumnFace) &&
                       surface.element->length() > narrow;
  return {span.low + (is_wall ? std::max(margin, height / 2) : margin),
          span.high - margin, true};
}

bool
areAlike(const VerticalSpan& a, const VerticalSpan& b)
{
  constexpr double slack = 0.02;
  return std::abs(a.low - b.low) < slack && std::abs(a.high - b.high) < slack;
}

bool
isParallel(const PlanSlab& a, const PlanSlab& b)
{
  return (a.plane.head<3>() - b.plane.head<3>()).norm() < 1e-9;
}

} // namespace

RefitTargets::RefitTargets(Floorplan& plan,
                           const PlanCurves& curves,
                           double reach,
                           unsigned threads)
    : curves_(curves)
    , reach_(reach)
    , length_(curves.curves.size(), 0)
    , depth_(curves.curves.size(), 0)
    , gap_(curves.curves.size(), std::numeric_limits<double>::infinity())
{
  addVerticals(plan);
  findGaps();
  for (auto& room : plan.rooms)
    addSlabs(room, threads);
  numberPatches();
  problem_ = places_.tabulate(reach);
}

void
RefitTargets::addVerticals(Floorplan& plan)
{
  std::map<const PlanElement*, std::size_t> curve_of;
  for (const auto& loop : curves_.loops)
    for (std::size_t i = 0; i < loop.curves.size(); ++i)
      curve_of[&loop.loop->elements[i]] = loop.curves[i];
  for (const auto& room : plan.rooms)
    for (const auto& surface : verticalSurfaces(room)) {
      const auto it = curve_of.find(surface.element);
      if (it != curve_of.end())
        addStretches(surface, it->second);
    }
}

/** @brief Adds the parts of a surface of constant height. */
void
RefitTargets::addStretches(const VerticalSurface& surface, std::size_t curve)
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
  VerticalSpan span;
  for (std::size_t k = 0; k <= parts; ++k) {
    const VerticalSpan here =
        k < parts ? surface.spanAt((at(k) + at(k + 1)) / 2) : VerticalSpan{};
    if (k > 0 && k < parts && areAlike(here, span))
      continue;
    if (k > 0)
      addStretch(surface, curve, at(first), at(k), span);
    first = k;
    span = here;
  }
}

void
RefitTargets::addStretch(const VerticalSurface& surface,
                         std::size_t curve,
                         double from,
                         double to,
                         const VerticalSpan& span)
{
  constexpr double min_height = 0.04;
  const VerticalSpan heights = heightsOf(surface, span);
  if (heights.high - heights.low < min_height || to <= from)
    return;
  const PlanElement& e = *surface.element;
  const bool is_whole = from <= 0 && to >= e.length();
  places_.stretches.push_back(
      {curve, is_whole ? e : e.part(from, to), heights.low, heights.high});
  length_[curve] += to - from;
  depth_[curve] = std::max(depth_[curve], heights.high - heights.low);
}

/** @brief Finds the distances between parallel stretches at the same heights. */
void
RefitTargets::findGaps()
{
  constexpr double step = 0.1;
  constexpr double min_cosine = 0.9;
  const double farthest = 3 * reach_;
  const auto mayBeNear = [&](const PlanElement& a, const PlanElement& b) {
    return (a.pointAt(a.length() / 2) - b.pointAt(b.length() / 2)).norm() <
           (a.length() + b.length()) / 2 + farthest;
  };
  for (const RefitStretch& own : places_.stretches)
    for (const RefitStretch& other : places_.stretches) {
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
            std::abs(along.tangentAt(p).dot(beside.tangentAt(p))) > min_cosine)
          gap_[own.curve] = apart;
      }
    }
}

/** @brief Adds and numbers a slab; if parallel to `parallel_to`, it follows `parent`.
 */
std::size_t
RefitTargets::addSlab(PlanSlab& slab,
                      const PlanLoop& loop,
                      const PlanSlab* parallel_to,
                      std::size_t parent)
{
  const bool follows = parallel_to && isParallel(slab, *parallel_to);
  const Eigen::AlignedBox2d box = boundsOf(loop);
  RefitSlab added;
  added.slab = &slab;
  added.middle = box.center();
  added.parent = follows ? parent : places_.slabs.size();
  added.half = box.sizes() / 2;
  added.width = widthOf(loop);
  places_.slabs.push_back(added);
  return places_.slabs.size() - 1;
}

void
RefitTargets::addSlabs(PlanRoom& room, unsigned threads)
{
  const std::size_t ceiling = addSlab(room.ceiling, room.boundary, nullptr, 0);
  for (auto& detail : room.details)
    addSlab(detail.slab, detail.boundary, &room.ceiling, ceiling);
  const std::size_t floor = addSlab(room.floor, room.boundary, nullptr, 0);
  for (auto& detail : room.floor_details)
    addSlab(detail.slab, detail.boundary, &room.floor, floor);
  for (auto& niche : room.niches) {
    const std::size_t bottom =
        addSlab(niche.bottom, niche.boundary, &room.floor, floor);
    const std::size_t top = addSlab(niche.top, niche.boundary, &room.ceiling, ceiling);
    places_.niches.push_back({&niche, bottom, top});
  }

  places_.addRoom(room, ceiling, floor, threads);
}

void
RefitTargets::numberPatches()
{
  for (std::size_t c = 0; c < curves_.curves.size(); ++c) {
    const PlanCurve& curve = curves_.curves[c].curve;
    const double length =
        curve.isCircle() ? 2 * M_PI * curve.radius : 2 * curves_.reach(c);
    patch_.push_back(std::clamp(length_[c] / 4, min_patch, vertical_patch));
    along_.push_back(static_cast<std::size_t>(length / patch_[c]) + 2);
    const auto rows = static_cast<std::size_t>(depth_[c] / vertical_patch) + 1;
    patch_count_.push_back(along_.back() * rows);
  }
  for (RefitSlab& slab : places_.slabs) {
    slab.along = static_cast<std::size_t>(2 * slab.half.x() / slab_patch) + 2;
    slab.rows = static_cast<std::size_t>(2 * slab.half.y() / slab_patch) + 2;
    along_.push_back(slab.along);
    patch_count_.push_back(slab.along * slab.rows);
  }
}

} // namespace pcl::sedr
