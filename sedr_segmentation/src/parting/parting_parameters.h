// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl::sedr {

/** @brief What is believed of what parts rooms; lengths in metres. */
struct PartingParameters {
  double lintel = 0.12;       ///< a ceiling that dips by more may part what is beside,
                              ///< and is, in the mean, that of a door
  double lintel_reach = 0.45; ///< half of the longest way below a lintel: of a wall
  double same_basin = 0.75;   ///< a neck this much as wide as the narrower side is none
  double thickest_wall = 0.6; ///< of a door without a lintel; openings with a pier or
                              ///< column between them that is no wider are one
  double min_way = 0.5;       ///< what is not half as deep is a ledge, no place
  double widest_door = 1.6;
  double widest_leaf = 0.8; ///< of that: a door without a lintel, which one leaf closes
  double widest_passage = 4; ///< of one below a deep lintel
  double deep_lintel = 0.2;
  double jamb = 0.25; ///< a room goes on beside a door by so much, and there is a wall
                      ///< this far from the end of an opening
  double jamb_reach = 2;     ///< as far as it is followed there
  double floor_reach = 1;    ///< the floor near an opening is that within
  double same_floor = 1.0;   ///< floors of one room differ by less at an opening
  double min_over_air = 0.1; ///< share of a gallery; less is on furniture
  double smallest_level = 5; ///< square metres; less on another height is a landing
  double widest_share = 0.8; ///< of the width of the wider room that is open, but for
                             ///< doors with a lintel
  double min_open = 0.5;     ///< share of the wall between that joins two rooms
  double min_open_of_part = 0.3; ///< the same if one is too small or too open to be a
                                 ///< room
  double max_open = 0.4;         ///< share of a room's outline that doors may be
  double smallest_room = 1.0;    ///< square metres
};

} // namespace pcl::sedr
