// SPDX-License-Identifier: BSD-3-Clause
#include "room_lookup.h"

#include "../walls/plan_walls.h"
#include "plan_geometry.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

LoopLookup::LoopLookup(const PlanLoop& loop)
    : loop_(&loop)
{
  constexpr double usual_band = 0.25; // metres
  constexpr double max_bands = 4096;
  std::vector<Eigen::AlignedBox2d> boxes;
  Eigen::AlignedBox2d all;
  for (const auto& e : loop.elements) {
    boxes.push_back(boxAround(e));
    all.extend(boxes.back());
  }
  low_ = all.min().y();
  high_ = all.max().y();
  if (!std::isfinite(high_ - low_))
    return;
  const double count =
      std::clamp(std::ceil((high_ - low_) / usual_band), 1.0, max_bands);
  band_ = std::max(1e-9, (high_ - low_) / count);
  bands_.resize(static_cast<std::size_t>(count) + 1);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto first = static_cast<std::size_t>((boxes[i].min().y() - low_) / band_);
    const auto last = static_cast<std::size_t>((boxes[i].max().y() - low_) / band_);
    for (std::size_t b = first; b <= std::min(last, bands_.size() - 1); ++b)
      bands_[b].push_back(static_cast<std::uint32_t>(i));
  }
}

bool
LoopLookup::contains(const Eigen::Vector2d& p) const
{
  if (!(p.y() >= low_ && p.y() <= high_) || bands_.empty())
    return false;
  int winding = 0;
  for (const std::uint32_t i : bands_[std::min(
           bands_.size() - 1, static_cast<std::size_t>((p.y() - low_) / band_))])
    winding += windingOf(loop_->elements[i], p);
  return winding != 0;
}

namespace {

/** @brief Fills a table with the places of things that have a boundary or are loops. */
template <typename Things, typename LoopOf>
void
fill(PlaceTable& places, const Things& things, LoopOf loopOf)
{
  for (std::size_t i = 0; i < things.size(); ++i) {
    const Eigen::AlignedBox2d box = boundsOf(loopOf(things[i]));
    if (!box.isEmpty())
      places.addIn(box, static_cast<std::uint32_t>(i));
  }
  places.finish();
}

int
lastAround(const std::vector<PlanDetail>& details,
           const PlaceTable& places,
           const Eigen::Vector2d& p)
{
  const PlaceTable::Numbers& near = places.at(p);
  for (auto i = near.rbegin(); i != near.rend(); ++i)
    if (details[*i].contains(p))
      return static_cast<int>(*i);
  return -1;
}

} // namespace

RoomLookup::RoomLookup(const PlanRoom& room)
    : room_(&room)
    , is_tilted_(sedr::isTilted(room))
    , boundary_(room.boundary)
{
  const auto boundaryOf = [](const auto& part) -> const PlanLoop& {
    return part.boundary;
  };
  fill(columns_, room.columns, [](const PlanLoop& c) -> const PlanLoop& { return c; });
  fill(details_, room.details, boundaryOf);
  fill(floor_details_, room.floor_details, boundaryOf);
  fill(niches_, room.niches, boundaryOf);
}

bool
RoomLookup::isInColumn(const Eigen::Vector2d& p) const
{
  const PlaceTable::Numbers& near = columns_.at(p);
  return std::any_of(near.begin(), near.end(),
                     [&](std::uint32_t c) { return room_->columns[c].contains(p); });
}

bool
RoomLookup::contains(const Eigen::Vector2d& p) const
{
  return boundary_.contains(p) && !isInColumn(p);
}

bool
RoomLookup::holds(const Eigen::Vector3d& p) const
{
  const Eigen::Vector2d place = p.head<2>();
  return is_tilted_ ? boundaryAt(*room_, p.z()).contains(place) && !isInColumn(place)
                    : contains(place);
}

int
RoomLookup::detailAt(const Eigen::Vector2d& p) const
{
  return lastAround(room_->details, details_, p);
}

int
RoomLookup::floorDetailAt(const Eigen::Vector2d& p) const
{
  return lastAround(room_->floor_details, floor_details_, p);
}

int
RoomLookup::nicheAt(const Eigen::Vector2d& p) const
{
  for (const std::uint32_t n : niches_.at(p))
    if (room_->niches[n].boundary.contains(p))
      return static_cast<int>(n);
  return -1;
}

} // namespace pcl::sedr
