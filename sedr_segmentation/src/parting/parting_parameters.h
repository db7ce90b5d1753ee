// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl::sedr {

/** @brief What is believed of what parts rooms; lengths in metres. */
struct PartingParameters {
  double lintel = 0.12; ///< least dip of the ceiling below what is beside it, where
                        ///< rooms may part, and in the mean over a door's width
  double lintel_reach = 0.45; ///< half of the longest way below a lintel: of a wall
  double same_basin = 0.75;   ///< a neck this much as wide as the narrower side is none
  double thickest_wall = 0.6; ///< around a door without a lintel; also the widest pier
                              ///< or column that stands in one opening
  double min_way = 0.5;       ///< what is not half as deep is a ledge, no place
  double widest_door = 1.6;
  double widest_leaf = 0.8; ///< of that: a door without a lintel, which one leaf closes
  double widest_passage = 4; ///< of one below a deep lintel
  double deep_lintel = 0.2;
  double jamb = 0.25;     ///< least length of a room's wall beside a door; also how far
                          ///< from the end of an opening its wall may begin
  double jamb_reach = 2;  ///< as far as it is followed there
  double floor_reach = 1; ///< the floor near an opening is that within
  double same_floor = 1.0;   ///< floors of one room differ by less at an opening
  double min_over_air = 0.1; ///< share of a gallery; less is on furniture
  double smallest_level = 5; ///< square metres; less on another height is a landing;
                             ///< also the least in which a scanner is thought to stand
  double widest_share = 0.8; ///< of the width of the wider room that is open, but for
                             ///< doors with a lintel
  double min_open = 0.5;     ///< share of the wall between that joins two rooms
  double min_open_of_part = 0.3; ///< the same if one is too small or too open to be a
                                 ///< room
  double max_open = 0.4;         ///< share of a room's outline that doors may be
  double smallest_room = 1.0;    ///< square metres
};

} // namespace pcl::sedr
