// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/loop.h"
#include "simulator/scene/scene.h"
#include "vec.h"

#include <optional>
#include <variant>
#include <vector>

/** @file The closed-form surfaces that a ray can hit. intersect() returns the distance
 * in metres along the ray to the first hit beyond @p from; empty if there is none. */

namespace pcl::sedr::sim {

/** @brief A half line; @p direction has unit length. */
struct Ray {
  Vec3 origin;
  Vec3 direction;

  /** @brief Returns the point at distance @p t. */
  Vec3 at(double t) const { return origin + t * direction; }
};

/** @brief An axis-parallel box around a surface. */
struct Bounds {
  Vec3 min;
  Vec3 max;
};

/** @brief The part of a plane inside an outline and outside its holes. */
struct SlabPatch {
  Slab slab;
  Loop outline;
  std::vector<Loop> holes;
};

/** @brief A rectangle on a wall: ranges along the wall and of height, in metres. */
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

/** @brief Returns the vertical patch above @p element between two planes. */
Shape verticalPatch(const Element& element,
                    const Slab& low,
                    const Slab& high,
                    std::vector<WallRectangle> holes = {});

std::optional<double> intersect(const SlabPatch& patch, const Ray& ray, double from);

std::optional<double> intersect(const PlanePatch& patch, const Ray& ray, double from);

std::optional<double> intersect(const ArcPatch& patch, const Ray& ray, double from);

std::optional<double> intersect(const Box& box, const Ray& ray, double from);

std::optional<double> intersect(const Cylinder& cylinder, const Ray& ray, double from);

/** @brief Returns the distance to the first hit of any shape beyond @p from. */
std::optional<double> intersect(const Shape& shape, const Ray& ray, double from);

/** @brief A side of a surface: above or below for slabs, left or right for walls. */
enum class Side { None, AboveOrLeft, BelowOrRight };

/** @brief Returns the side of @p shape that a ray hits at @p distance; None for bodies.
 */
Side sideSeenFrom(const Shape& shape, const Ray& ray, double distance);

/** @brief Returns the bounding box of the shape. */
Bounds boundsOf(const Shape& shape);

} // namespace pcl::sedr::sim
