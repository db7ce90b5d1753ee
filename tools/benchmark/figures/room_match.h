// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model_figures.h"

#include "simulator/truth/room_truth.h"

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace pcl::sedr::benchmark {

/** @brief A found room and the corresponding true one. */
struct RoomPair {
  std::size_t found = 0; ///< index in the plan
  std::size_t truth = 0; ///< index in the truths
  double overlap = 0;    ///< square metres in plan
};

/** @brief Accuracy of the rooms. Errors are relative to the truth; each is the maximum
 * of all paired rooms, NaN if there is none. */
struct RoomFigures {
  std::size_t rooms_true = 0;
  std::size_t rooms_found = 0;
  std::size_t rooms_matched = 0; ///< whose overlap is at least half the union
  double area_error = not_known;
  double height_error = not_known; ///< of the mean height
  double volume_error = not_known; ///< of mean height times area, plus niches
  double mesh_volume_error = not_known;
};

/** @brief Pairs found and true rooms one to one in order of decreasing overlap, which
 * must not be zero. Overlap is counted on a grid of 5 cm. */
std::vector<RoomPair> matchRooms(const Floorplan& plan,
                                 const std::vector<sim::RoomTruth>& truths);

/** @brief Compares the rooms of a plan with the truth. A pair counts as matched if its
 * overlap is at least half of the union of both rooms.
 * @param mesh_volumes cubic metres of the mesh of each room, by its id; may be empty */
RoomFigures measureRooms(const Floorplan& plan,
                         const std::vector<sim::RoomTruth>& truths,
                         const std::map<std::uint32_t, double>& mesh_volumes = {});

} // namespace pcl::sedr::benchmark
