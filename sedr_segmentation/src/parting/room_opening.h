// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"
#include "parting_parameters.h"
#include "room_labels.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief An opening between two rooms. */
struct RoomOpening {
  std::uint32_t a = 0; ///< rooms, by index; a < b
  std::uint32_t b = 0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();     ///< in plan
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< along the wall
  double width = 0;
  double bottom = 0; ///< z of the floor in it
  double top = 0;    ///< z of its lintel
  double dip = 0;    ///< mean, of the ceiling below that beside it
};

/** @brief A link from the air of one room to that of another. */
struct Crossing {
  std::uint32_t from = 0; ///< gap of the room with the lower number
  std::uint32_t to = 0;
};

/** @brief The crossings of a border by openings: those with no more than a pier or a
 * column between them together. O(n) look-ups of all cells around.
 * @param widest_pier metres */
std::vector<std::vector<Crossing>> openingsOf(const AirGaps& air,
                                              const std::vector<Crossing>& crossings,
                                              double widest_pier);

/** @brief An opening with what is needed to judge it; lengths in metres. */
struct MeasuredOpening : RoomOpening {
  double floor_a = 0;     ///< z of the floor near it, of its first room
  double floor_b = 0;     ///< the same of the second
  double open_height = 0; ///< of the opening over that of the air beside it
  bool has_ends = false;  ///< whether walls stand at both of its ends
  double jamb_a = 0;      ///< how far the first room goes on beside one of its ends
  double jamb_b = 0;      ///< the same of the second
  double beside = 0;      ///< beside both ends together, of the room with more
};

/** @brief Measures openings between rooms. */
class OpeningMeasures {
public:
  /** @param dip of each gap, see dipOfCeiling(); must outlive this, as must the air */
  OpeningMeasures(const AirGaps& air,
                  const std::vector<float>& dip,
                  const PartingParameters& parameters);

  /** @brief Measures one; its jambs only where walls stand at its ends. Crossings must
   * not be empty. O(gaps within floor_reach of it). */
  MeasuredOpening measure(const std::vector<Crossing>& crossings,
                          RoomLabels& rooms) const;

private:
  using Ends = std::array<Crossing, 2>;

  Eigen::Vector2d directionOf(const std::vector<Crossing>& crossings,
                              const Eigen::Vector2d& through) const;
  Ends endsOf(const std::vector<Crossing>& crossings,
              const Eigen::Vector2d& direction) const;
  double floorBeside(const std::vector<Crossing>& crossings,
                     bool of_first,
                     RoomLabels& rooms) const;
  bool endsAtWalls(const Ends& ends, const Eigen::Vector2d& direction) const;
  std::array<double, 2> besideOf(const Ends& ends,
                                 const Eigen::Vector2d& direction,
                                 const Eigen::Vector2d& into,
                                 bool of_first,
                                 RoomLabels& rooms) const;

  const AirGaps& air_;
  const std::vector<float>& dip_;
  const PartingParameters& parameters_;
  double cell_;
};

/** @brief Whether an opening is a door or a passage, with walls at both ends: as wide
 * as a leaf with jambs on both sides, or no wider than a door or a passage with a
 * lintel and a jamb on one. */
bool isDoor(const MeasuredOpening& opening, const PartingParameters& parameters);

} // namespace pcl::sedr
