// SPDX-License-Identifier: BSD-3-Clause
#include "room_regions.h"

#include <algorithm>

namespace pcl::sedr::sim {

namespace {

double
heightOf(const Room& room, Vec2 point, Layer layer)
{
  const Region region = regionAt(room, point, layer);
  return heightAt(slabOf(room, std::max(region, kMain), layer), point);
}

} // namespace

const std::vector<SlabDetail>&
detailsOf(const Room& room, Layer layer)
{
  return layer == Layer::Floor ? room.floor_details : room.details;
}

Region
regionCount(const Room& room, Layer layer)
{
  return static_cast<Region>(detailsOf(room, layer).size()) + 1;
}

Region
regionAt(const Room& room, Vec2 point, Layer layer)
{
  if (!isInRoom(room, point))
    return kVoid;
  const auto& details = detailsOf(room, layer);
  for (std::size_t i = details.size(); i > 0; --i)
    if (contains(details[i - 1].loop, point))
      return static_cast<Region>(i);
  return kMain;
}

Vec2
pointInside(const Loop& loop)
{
  constexpr double step = 1e-3;
  const Element first = elementOf(loop, 0);
  const double middle = 0.5 * lengthOf(first);
  const Vec2 aside = step * rightNormalAt(first, middle);
  const Vec2 left = pointAt(first, middle) - aside;
  return contains(loop, left) ? left : pointAt(first, middle) + aside;
}

bool
isInRoom(const Room& room, Vec2 point)
{
  return contains(room.outline, point) &&
         std::none_of(room.columns.begin(), room.columns.end(),
                      [point](const Loop& column) { return contains(column, point); });
}

const Slab&
slabOf(const Room& room, Region region, Layer layer)
{
  if (region == kMain)
    return layer == Layer::Floor ? room.floor : room.ceiling;
  return detailsOf(room, layer)[region - 1].slab;
}

Label
labelOf(const Room& room, Region region, Layer layer)
{
  const Label whole = layer == Layer::Floor ? Label::Floor : Label::Ceiling;
  if (region == kMain)
    return whole;
  const SlabDetail& detail = detailsOf(room, layer)[region - 1];
  return detail.is_wall ? Label::Wall : detail.is_facet ? whole : Label::Detail;
}

double
floorBelow(const Room& room, Vec2 point)
{
  return heightOf(room, point, Layer::Floor);
}

double
ceilingAbove(const Room& room, Vec2 point)
{
  return heightOf(room, point, Layer::Ceiling);
}

} // namespace pcl::sedr::sim
