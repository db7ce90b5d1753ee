// SPDX-License-Identifier: BSD-3-Clause
#include "plane_list.h"

#include <algorithm>
#include <cstdio>

namespace pcl::sedr {

const char*
nameOf(LevelKind kind)
{
  return kind == LevelKind::Ceiling ? "ceiling"
         : kind == LevelKind::Floor ? "floor"
                                    : "other";
}

double
areaOfRooms(const std::vector<pcl::HorizontalPlane>& planes)
{
  double ceilings = 0;
  double floors = 0;
  for (const auto& plane : planes) {
    ceilings += plane.kind == LevelKind::Ceiling ? plane.area : 0;
    floors += plane.kind == LevelKind::Floor ? plane.area : 0;
  }
  return std::min(ceilings, floors);
}

std::string
listOf(const std::vector<pcl::HorizontalPlane>& planes)
{
  std::vector<const pcl::HorizontalPlane*> largest;
  for (const auto& plane : planes)
    largest.push_back(&plane);
  std::stable_sort(largest.begin(), largest.end(),
                   [](const auto* a, const auto* b) { return a->area > b->area; });
  largest.resize(std::min<std::size_t>(largest.size(), 6));
  std::string list;
  for (const auto* plane : largest) {
    char text[96];
    std::snprintf(text, sizeof text, "%s%.2f m %s %.1f m2", list.empty() ? "" : ", ",
                  plane->height, nameOf(plane->kind), plane->area);
    list += text;
  }
  return list;
}

std::string
missingKind(const std::vector<pcl::HorizontalPlane>& planes, double room_height)
{
  const auto count = [&](LevelKind kind) {
    return std::count_if(planes.begin(), planes.end(),
                         [&](const auto& plane) { return plane.kind == kind; });
  };
  const auto ceilings = count(LevelKind::Ceiling);
  const auto floors = count(LevelKind::Floor);
  if (ceilings > 0 && floors > 0)
    return "";
  char text[200];
  std::snprintf(
      text, sizeof text,
      "of %zu horizontal planes %td are ceilings and %td floors; a ceiling needs a "
      "floor at least %.2f m below it; found: ",
      planes.size(), ceilings, floors, room_height);
  return text + listOf(planes);
}

} // namespace pcl::sedr
