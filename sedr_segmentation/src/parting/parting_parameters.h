// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl::sedr {

/** @brief Logarithms of the odds that two parts of the air are one room, by what is
 * measured along their border, see RoomBorders::oddsOfOne(). Fitted by maximum
 * likelihood to random buildings (test/benchmarks/border_odds.py); behind each
 * its standard error. `stacked` was fitted again later, to more of them, with others
 * that are near these. */
struct BorderOdds {
  double any = -3.42;  ///< 0.25
  double dip = -5.58;  ///< 0.56; a metre that the ceiling dips, one at most
  double open = 2.79;  ///< 0.18; ln of the open length of the border over its walls'
  double neck = 2.57;  ///< 0.45; square of half of the widest way between them that no
                       ///< lintel is above, of the shallower part's depth
  double drop = -2.22; ///< 0.57; share of the border at edges of galleries
  double stacked = -1.19; ///< 0.89; square metres of one that lie above the other
  double depth = -1.64;   ///< 0.28; ln of the shallower part's depth, a metre at most
  double outline = 22.33; ///< 1.60; square of the share of the outline that is open, of
                          ///< the part of which less is
  double share = 11.75;   ///< 4.57; what the border is of the shorter outline, above a
                          ///< fifth
  double unseen_border = 0.4;  ///< metres; open ones and walls, presumed beside those
                               ///< that were seen
  double unseen_outline = 2.0; ///< the same of walls of outlines
};

/** @brief What is believed of what parts rooms; lengths in metres. */
struct PartingParameters {
  double lintel = 0.12; ///< least dip of the ceiling below what is beside it, where
                        ///< rooms may part
  double lintel_reach = 0.45; ///< half of the longest way below a lintel: of a wall
  double same_basin = 0.75;   ///< a neck this much as wide as the narrower side is none
  double thickest_wall = 0.6; ///< around a door without a lintel
  double min_way = 0.5; ///< what is narrower is no way; what is not half as deep is a
                        ///< ledge, no room
  double widest_door = 1.6;  ///< without a lintel
  double smallest_level = 5; ///< square metres; less on another height is a landing;
                             ///< also the least in which a scanner is thought to stand
  BorderOdds odds;
};

} // namespace pcl::sedr
