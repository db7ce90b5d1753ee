// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A wall of a plan that leans: its element of the boundary is its foot, at the
 * height of the floor's main plane; what stands on it is a plane, on an arc a cone. */
struct WallTilt {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::size_t wall = 0;   ///< element of its boundary, from 0
  double tilt = 0;        ///< radians from the vertical, positive into the room
};

/** @brief The walls of a plan that lean; all others are vertical. */
using WallTilts = std::vector<WallTilt>;

/** @brief Of each wall of a room, how far it goes into the room for a metre up: the
 * tangent of its tilt, 0 if it is vertical. */
std::vector<double> wallRuns(const PlanRoom& room, const WallTilts& tilts);

/** @brief Whether some wall of a room leans. */
bool leans(const PlanRoom& room, const WallTilts& tilts);

/** @brief The boundary of a room at a height: of what leans, where it is there. Corners
 * are where two walls meet; walls that have no length there make the loop cross itself.
 */
PlanLoop boundaryAt(const PlanRoom& room, const WallTilts& tilts, double z);

/** @brief The height of the top of the highest wall of a room that leans. */
double headOf(const PlanRoom& room, const WallTilts& tilts);

/** @brief Ends of elements that were moved, and of those beside them, brought to where
 * they meet their neighbours. */
void rejoin(PlanLoop& loop, const std::vector<bool>& is_moved);

/** @brief floorplan.json with the tilts of its walls, in degrees, each as `tilt` of its
 * element: of version 2 where there are any, else as it was.
 * @param json as floorplanToJson() wrote it
 * @param volumes of rooms, by id: they replace those of vertical walls */
std::string withTilts(const std::string& json,
                      const WallTilts& tilts,
                      const std::map<std::uint32_t, double>& volumes = {});

/** @brief The tilts that a floorplan.json tells.
 * @param[out] problem a sentence where one is no number within 45 degrees, else empty
 */
WallTilts tiltsFromJson(const std::string& json, std::string& problem);

} // namespace sedr
} // namespace pcl
