// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_rule.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <iterator>

namespace pcl::sedr::tools {

namespace {

constexpr double thickness = 0.15; // of scanned ceilings, metres

/** @brief Returns the mean of the minimum and maximum of heights. */
template <typename Heights>
double
middleOfHeights(std::size_t count, const Heights& height)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < count; ++i) {
    low = std::min(low, height(i));
    high = std::max(high, height(i));
  }
  return (low + high) / 2;
}

} // namespace

CeilingRule::CeilingRule(const Floorplan& plan)
{
  for (const PlanStorey& storey : storeysOf(plan)) {
    storeys_.emplace_back();
    storeys_.back().floor = storey.floor;
    for (const PlanRoom& room : partOf(plan, storey).rooms)
      addRoom(room, storeys_.back());
  }
  std::stable_sort(storeys_.begin(), storeys_.end(),
                   [](const Storey& a, const Storey& b) { return a.floor < b.floor; });
}

void
CeilingRule::addRoom(const PlanRoom& room, Storey& storey)
{
  Eigen::AlignedBox2d box;
  for (const auto& corner : room.boundary.polygon(0.01))
    box.extend(corner);
  if (box.isEmpty())
    return;
  const Eigen::Vector2d middle = box.center();
  middle_of_room_[room.id] =
      (room.floor.heightAt(middle) + room.ceiling.heightAt(middle)) / 2;
  storey.highest = std::max(storey.highest, room.ceiling.heightAt(middle));
  const Cell low = grid_.at(box.min().x(), box.min().y());
  const Cell high = grid_.at(box.max().x(), box.max().y());
  for (std::int32_t y = low.y; y <= high.y; ++y)
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const Eigen::Vector2d place = grid_.centre({x, y});
      if (room.contains(place))
        storey.addCeiling(
            {x, y}, std::min(room.ceilingAt(place), room.ceiling.heightAt(place)));
    }
}

void
CeilingRule::Storey::addCeiling(Cell cell, double height)
{
  for (std::int32_t dy = -1; dy <= 1; ++dy)
    for (std::int32_t dx = -1; dx <= 1; ++dx) {
      const auto [at, is_new] =
          ceiling_at.emplace(keyOf({cell.x + dx, cell.y + dy}), height);
      if (!is_new)
        at->second = std::min(at->second, height);
    }
}

bool
CeilingRule::isAbove(const Eigen::Vector3d& p) const
{
  if (storeys_.empty())
    return false;
  // Uses the highest storey whose floors are below the place.
  auto storey = storeys_.rbegin();
  while (std::next(storey) != storeys_.rend() && p.z() < storey->floor - thickness)
    ++storey;
  double ceiling = storey->highest;
  if (grid_.holds(p.x(), p.y())) {
    const auto found = storey->ceiling_at.find(keyOf(grid_.at(p.x(), p.y())));
    if (found != storey->ceiling_at.end())
      ceiling = found->second;
  }
  return p.z() > ceiling - thickness;
}

double
CeilingRule::middleOf(std::uint32_t room, double otherwise) const
{
  const auto found = middle_of_room_.find(room);
  return found == middle_of_room_.end() ? otherwise : found->second;
}

std::vector<bool>
CeilingRule::ofCloud(const DisplayCloud& cloud) const
{
  std::vector<bool> goes(cloud.size(), false);
  const double middle = middleOfHeights(
      cloud.size(), [&](std::size_t i) { return double{cloud.points[i].z()}; });
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    const auto label = cloud.labels.empty()
                           ? StructureLabel::Other
                           : static_cast<StructureLabel>(cloud.labels[i]);
    if (label == StructureLabel::Ceiling)
      goes[i] = true;
    else if (label == StructureLabel::Detail)
      goes[i] = p.z() > middleOf(cloud.rooms.empty() ? 0 : cloud.rooms[i], middle);
    else if (label == StructureLabel::Other)
      goes[i] = isAbove(p);
  }
  return goes;
}

std::vector<bool>
CeilingRule::ofMesh(const TriangleMesh& mesh) const
{
  DisplayCloud centres;
  centres.labels = mesh.labels;
  centres.rooms = mesh.rooms;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    centres.points.push_back(
        ((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3)
            .cast<float>());
  return ofCloud(centres);
}

} // namespace pcl::sedr::tools
