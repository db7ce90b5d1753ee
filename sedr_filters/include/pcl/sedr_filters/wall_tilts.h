// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A tilted wall of a plan. The boundary element is its foot, at the height of
 * the floor's main plane. The wall is a plane on a segment, a cone on an arc. */
struct WallTilt {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::size_t wall = 0;   ///< index of the boundary element
  double tilt = 0;        ///< radians from the vertical, positive into the room
};

/** @brief The tilted walls of a plan; all others are vertical. */
using WallTilts = std::vector<WallTilt>;

/** @brief Returns the run of each wall of a room: metres into the room for each metre
 * up, the tangent of its tilt; 0 if vertical. */
std::vector<double> wallRuns(const PlanRoom& room, const WallTilts& tilts);

/** @brief Checks whether any wall of a room is tilted. */
bool isTilted(const PlanRoom& room, const WallTilts& tilts);

/** @brief Returns the boundary of a room at height `z`, with tilted walls at their
 * position there. Corners lie where two walls meet. If a wall has no length at that
 * height, the loop crosses itself. */
PlanLoop boundaryAt(const PlanRoom& room, const WallTilts& tilts, double z);

/** @brief Returns the maximum height of the tops of a room's tilted walls. */
double headOf(const PlanRoom& room, const WallTilts& tilts);

/** @brief Moves the ends of moved elements and their neighbours to where they meet. */
void rejoin(PlanLoop& loop, const std::vector<bool>& is_moved);

/** @brief Returns floorplan.json with wall tilts in degrees, each as `tilt` of its
 * element. The version is 2 if there are any tilts, else the text is unchanged.
 * @param json output of floorplanToJson()
 * @param volumes room volumes by id, which replace those computed for vertical walls */
std::string withTilts(const std::string& json,
                      const WallTilts& tilts,
                      const std::map<std::uint32_t, double>& volumes = {});

/** @brief Reads the tilts from a floorplan.json.
 * @param[out] problem a sentence if a tilt is not a number within 45 degrees, else
 * empty */
WallTilts tiltsFromJson(const std::string& json, std::string& problem);

} // namespace pcl::sedr
