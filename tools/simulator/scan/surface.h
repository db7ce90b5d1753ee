// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/loop.h"
#include "simulator/scene/scene.h"
#include "vec.h"

#include <optional>
#include <variant>
#include <vector>

/** @file
 * The closed-form surfaces that a ray can hit. intersect() gives the distance along the
 * ray of the first hit beyond @p from, in units of the (unit) direction.
 */

namespace pcl::sedr::sim {

/** @brief A half line; @p direction has unit length. */
struct Ray {
  Vec3 origin;
  Vec3 direction;

  /** @brief The point at distance @p t. */
  Vec3 at(double t) const { return origin + t * direction; }
};

/** @brief An axis-parallel box around a surface. */
struct Bounds {
  Vec3 min;
  Vec3 max;
};

/** @brief A plane inside an outline and outside its holes. */
struct SlabPatch {
  Slab slab;
  Loop outline;
  std::vector<Loop> holes;
};

/** @brief A rectangle on a wall: metres along the wall and heights. */
struct WallRectangle {
  double from = 0.0;
  double to = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/** @brief The part of a vertical surface between two planes. */
struct WallExtent {
  double from = 0.0;
  double to = 0.0;
  Slab low;
  Slab high;
};

/** @brief A vertical plane above a segment, with rectangular holes. */
struct PlanePatch {
  Vec2 start;
  Vec2 direction; ///< unit length
  WallExtent extent;
  std::vector<WallRectangle> holes;
};

/** @brief A part of a vertical cylinder above an arc, with rectangular holes. */
struct ArcPatch {
  Arc arc;
  WallExtent extent;
  std::vector<WallRectangle> holes;
};

/** @brief Any closed-form shape. */
using Shape = std::variant<SlabPatch, PlanePatch, ArcPatch, Box, Cylinder>;

/** @brief The vertical patch above @p element between two planes. */
Shape verticalPatch(const Element& element,
                    const Slab& low,
                    const Slab& high,
                    std::vector<WallRectangle> holes = {});

std::optional<double> intersect(const SlabPatch& patch, const Ray& ray, double from);

std::optional<double> intersect(const PlanePatch& patch, const Ray& ray, double from);

std::optional<double> intersect(const ArcPatch& patch, const Ray& ray, double from);

std::optional<double> intersect(const Box& box, const Ray& ray, double from);

std::optional<double> intersect(const Cylinder& cylinder, const Ray& ray, double from);

/** @brief First hit of any shape beyond @p from. */
std::optional<double> intersect(const Shape& shape, const Ray& ray, double from);

/** @brief The side of a surface: a slab has one above, a wall one to its left. */
enum class Side { None, AboveOrLeft, BelowOrRight };

/** @brief From which side a ray comes that hits @p shape at @p distance; bodies have
 * none. */
Side sideSeenFrom(const Shape& shape, const Ray& ray, double distance);

/** @brief Box around the shape. */
Bounds boundsOf(const Shape& shape);

} // namespace pcl::sedr::sim
