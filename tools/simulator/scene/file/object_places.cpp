// SPDX-License-Identifier: BSD-3-Clause
#include "object_places.h"

#include "simulator/truth/room_regions.h"

namespace pcl::sedr::sim {

namespace {

constexpr double kGap = 0.02; ///< metres between furniture and the wall behind it
constexpr std::size_t kLongestRow = 1000;

/** @brief The number of objects side by side and the gap between them, in metres. */
struct Row {
  std::size_t count = 1;
  double gap = 0.0;
};

Row
readRow(const JsonView& view)
{
  const auto row = view.find("row");
  if (!row)
    return {};
  row->allowOnly({"count", "gap"});
  return {row->at("count").count(1, kLongestRow), row->at("gap").number(0.0, 100.0)};
}

} // namespace

ObjectPlaces
ObjectPlaces::within(const ObjectFrame& place) const
{
  ObjectPlaces places(room_);
  places.frame_ = {frame_(place.origin), frame_.yaw + place.yaw};
  places.is_group_ = true;
  return places;
}

std::vector<std::string>
ObjectPlaces::keysOfSpots() const
{
  if (room_ == nullptr)
    return {"at", "yaw", "floor"};
  if (is_group_)
    return {"at", "yaw", "raise"};
  return {"at", "yaw", "raise", "wall", "s", "gap", "row"};
}

std::vector<Spot>
ObjectPlaces::spotsOf(const JsonView& view, double width, double depth) const
{
  if (view.find("wall"))
    return spotsAtWall(view, width, depth);
  for (const char* key : {"s", "gap", "row"})
    if (view.find(key))
      view.fail(std::string("has \"") + key + "\" but no \"wall\"");
  const Vec2 center = pointOf(view.at("at"));
  return {{center, yawOf(view), floorAt(view, center)}};
}

std::vector<Spot>
ObjectPlaces::spotsAtWall(const JsonView& view, double width, double depth) const
{
  for (const char* key : {"at", "yaw"})
    if (view.find(key))
      view.fail(std::string("has both \"wall\" and \"") + key + '"');
  const Loop& outline = room_->outline;
  const std::size_t wall = view.at("wall").count(0, outline.size() - 1);
  const double gap = view.find("gap") ? view.at("gap").number(0.0, 100.0) : kGap;
  const double first = view.at("s").number();
  const Row row = readRow(view);
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < row.count; ++i) {
    const double s = first + static_cast<double>(i) * (width + row.gap);
    Spot spot = spotAtWall(elementOf(outline, wall), s, depth, gap, width);
    spot.floor = floorAt(view, spot.center);
    spots.push_back(spot);
  }
  return spots;
}

double
ObjectPlaces::floorAt(const JsonView& view, Vec2 point) const
{
  if (room_ == nullptr)
    return view.numberOr("floor", 0.0);
  requireWithin(view, point);
  return floorBelow(*room_, point) + view.numberOr("raise", 0.0);
}

double
ObjectPlaces::ceilingAt(const JsonView& view, Vec2 point) const
{
  requireWithin(view, point);
  return ceilingAbove(*room_, point);
}

void
ObjectPlaces::requireWithin(const JsonView& view, Vec2 point) const
{
  if (!isInRoom(*room_, point))
    view.fail("is not within its room");
}

double
ObjectPlaces::yawOf(const JsonView& view, const std::string& key) const
{
  return frame_.yaw + view.numberOr(key, 0.0) * pi / 180.0;
}

} // namespace pcl::sedr::sim
