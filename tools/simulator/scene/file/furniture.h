// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/scene.h"

#include <functional>
#include <map>
#include <string>

namespace pcl::sedr::sim {

/** @brief Position and direction of an object: the middle of its footprint. At yaw 0
 * the width runs along x, the depth along y, and the front faces -y. */
struct Spot {
  Vec2 center = Vec2::Zero();
  double yaw = 0.0; ///< radians, counter-clockwise
  double z = 0.0;   ///< of its feet; of what hangs, of the ceiling above it
};

/** @brief An object under construction; its parts are relative to its spot. */
class Assembly {
public:
  Assembly(std::string name, const Spot& spot);

  /** @brief Adds a box by its lower and upper corner. */
  void addBox(const Vec3& low, const Vec3& high);

  /** @brief Adds a box by its centre, turned about z. */
  void addBox(const Vec3& center, const Vec3& size, double yaw);

  /** @brief Adds a cylinder in facets within kCurveTolerance. */
  void addCylinder(const Vec3& base, double radius, double height);

  /** @brief Returns the width and depth of all parts. */
  Vec2 footprint() const;

  Object object;

private:
  Vec3 moved(const Vec3& point) const;

  Spot spot_;
};

/** @brief Where an object of a kind stands or hangs. */
enum class Standing { OnFloor, BelowCeiling, Hinged };

/** @brief A kind of furniture. */
struct Kind {
  std::string name; ///< of its objects, unless the file gives another
  Standing standing = Standing::OnFloor;
  bool is_indoors = false; ///< in rooms only
  std::function<void(const JsonView&, Assembly&)> build;
};

/** @brief Returns the kinds by their key in scene files. */
const std::map<std::string, Kind>& furnitureKinds();

/** @brief The name of every flight of stairs. */
constexpr const char* kStairs = "stairs";

} // namespace pcl::sedr::sim
