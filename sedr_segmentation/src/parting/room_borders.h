// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"
#include "../air/height_counts.h"
#include "parting_parameters.h"
#include "room_labels.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace pcl::sedr {

/** @brief What is between two rooms, summed up along their border. */
struct RoomBorder {
  double links = 0;   ///< of the air of one room to that of the other
  double walls = 0;   ///< ends of air that face the other room's across a wall
  double drops = 0;   ///< links over the edge of a gallery
  double dip = 0;     ///< metres, of the ceiling at each link
  double stacked = 0; ///< pairs of gaps of both in one column
  double clear = 0;   ///< metres; the most that a link is away from rims and lintels
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< sum of the links' places, metres

  void add(const RoomBorder& other);
};

/** @brief What is known of a room while rooms are joined. */
struct RoomExtent {
  double area = 0;  ///< square metres
  double depth = 0; ///< of the place farthest from its rim, metres
  double ends = 0;  ///< where its air ends
  double links = 0; ///< to other rooms
  std::map<std::uint32_t, RoomBorder> beside; ///< borders with other rooms
};

/** @brief Logarithms of the odds that two rooms are one, not two, see BorderOdds. */
struct RoomOdds {
  double by_border = 0;                                     ///< by what is between them
  double by_all = -std::numeric_limits<double>::infinity(); ///< and by what they are
};

/** @brief The rooms of a building and the borders between them, which are joined. */
class RoomBorders {
public:
  /** @brief O(gaps).
   * @param dip of each gap, see dipOfCeiling()
   * @param labels of the gaps; must outlive this, as must the parameters */
  RoomBorders(const AirGaps& air,
              const std::vector<float>& dip,
              const PartingParameters& parameters,
              RoomLabels& labels);

  std::size_t size() const { return rooms_.size(); }
  const RoomExtent& room(std::uint32_t r) const { return rooms_[r]; }

  /** @brief The odds that two rooms between which there is a border are one. */
  RoomOdds oddsOfOne(std::uint32_t a, std::uint32_t b) const;

  /** @brief Joins the second of two rooms to the first, and its borders. */
  void join(std::uint32_t a, std::uint32_t b);

private:
  void measureRooms(const AirGaps& air);
  void measureBorders(const AirGaps& air, const std::vector<float>& dip);

  const PartingParameters& parameters_;
  RoomLabels& labels_;
  double cell_;
  std::vector<RoomExtent> rooms_;
};

} // namespace pcl::sedr
