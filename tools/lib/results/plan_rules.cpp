// SPDX-License-Identifier: BSD-3-Clause
#include "plan_rules.h"

#include "sedr_filters/src/plan/missing_things.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <algorithm>

namespace pcl::sedr::tools {

namespace {

constexpr double thickness = 0.15; // of scanned floors and ceilings, metres

} // namespace

PlanRules::PlanRules(const Floorplan& plan)
    : storeys_(storeysOf(plan))
    , ceilings_(storeys_.size())
    , storey_of_(storeyOfRooms(plan))
{
  for (std::size_t k = 0; k < storeys_.size(); ++k)
    for (const PlanRoom& room : partOf(plan, storeys_[k]).rooms)
      addRoom(room, ceilings_[k]);
}

void
PlanRules::addRoom(const PlanRoom& room, Ceilings& ceilings)
{
  const Eigen::AlignedBox2d box = boundsOf(room.boundary);
  if (box.isEmpty())
    return;
  const RoomHeights heights = heightsOf(room);
  box_of_[room.id] = {Eigen::Vector3d(box.min().x(), box.min().y(), heights.low),
                      Eigen::Vector3d(box.max().x(), box.max().y(), heights.high)};
  const Cell low = grid_.at(box.min().x(), box.min().y());
  const Cell high = grid_.at(box.max().x(), box.max().y());
  for (std::int32_t y = low.y; y <= high.y; ++y)
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const Eigen::Vector2d place = grid_.centre({x, y});
      if (!room.contains(place))
        continue;
      const double height =
          std::min(room.ceilingAt(place), room.ceiling.heightAt(place));
      // Also for the cells beside it, as risers and tops of walls lie on their borders.
      for (std::int32_t dy = -1; dy <= 1; ++dy)
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
          const auto [at, is_new] = ceilings.emplace(keyOf({x + dx, y + dy}), height);
          at->second = is_new ? height : std::min(at->second, height);
        }
    }
}

bool
PlanRules::isCeiling(StructureLabel label,
                     std::uint32_t room,
                     const Eigen::Vector3d& place) const
{
  if (label == StructureLabel::Detail) {
    const auto box = box_of_.find(room);
    return box == box_of_.end() || place.z() > box->second.center().z();
  }
  if (label != StructureLabel::Other || storeys_.empty())
    return label == StructureLabel::Ceiling;
  std::size_t k = storeys_.size() - 1; // the highest storey whose floors are below it
  while (k > 0 && place.z() < storeys_[k].floor - thickness)
    --k;
  double ceiling = storeys_[k].ceiling;
  if (grid_.holds(place.x(), place.y())) {
    const auto found = ceilings_[k].find(keyOf(grid_.at(place.x(), place.y())));
    if (found != ceilings_[k].end())
      ceiling = found->second;
  }
  return place.z() > ceiling - thickness;
}

bool
PlanRules::isInStorey(std::uint32_t storey, std::uint32_t room, double z) const
{
  const PlanStorey* const wanted = findStorey(storeys_, storey);
  if (!wanted)
    return true;
  const auto known = storey_of_.find(room);
  if (known != storey_of_.end())
    return known->second == storey;
  return z >= wanted->floor - thickness && z <= wanted->ceiling + thickness;
}

bool
PlanRules::isInRoom(std::uint32_t wanted,
                    std::uint32_t room,
                    const Eigen::Vector3d& place) const
{
  const auto box = box_of_.find(wanted);
  return wanted == 0 || wanted == room ||
         (room == 0 && box != box_of_.end() &&
          box->second.exteriorDistance(place) <= thickness);
}

Eigen::AlignedBox3d
PlanRules::boxOf(std::uint32_t room) const
{
  const auto box = box_of_.find(room);
  return box == box_of_.end() ? Eigen::AlignedBox3d() : box->second;
}

} // namespace pcl::sedr::tools
