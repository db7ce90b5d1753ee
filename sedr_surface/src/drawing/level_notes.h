// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_drawing.h"

namespace pcl::sedr {

/** @brief A note of a level at its place: the height above the room's floor, such as
 * "2.20", with a sign for levels of the floor. */
struct LevelNote {
  TextSpot spot;
  std::string text;
  DrawnLayer layer = DrawnLayer::Detail;
};

/** @brief Returns the levels of a room's ceiling and floor. Facets without a line
 * between them have one note, at the largest of them; none if the main ceiling, of
 * which the room's text tells, is one of them.
 * @param room_text circle around the room's text, which notes avoid
 * @param ceiling lines of the room's ceiling, and the parts between them */
std::vector<LevelNote> levelNotes(const PlanRoom& room,
                                  const CeilingLines& ceiling,
                                  const TextSpot& room_text);

} // namespace pcl::sedr
