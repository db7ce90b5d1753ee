// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop.h"
#include "scene.h"
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

/** @brief A level surface inside an outline and outside its holes. */
struct LevelPatch {
  double z = 0.0;
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

/** @brief A vertical plane above a segment, with rectangular holes. */
struct PlanePatch {
  Vec2 start;
  Vec2 direction; ///< unit length
  WallRectangle extent;
  std::vector<WallRectangle> holes;
};

/** @brief A part of a vertical cylinder above an arc, with rectangular holes. */
struct ArcPatch {
  Arc arc;
  WallRectangle extent;
  std::vector<WallRectangle> holes;
};

/** @brief Any closed-form shape. */
using Shape = std::variant<LevelPatch, PlanePatch, ArcPatch, Box, Cylinder>;

/** @brief The vertical patch above @p element between two heights. */
Shape verticalPatch(const Element& element,
                    double low,
                    double high,
                    std::vector<WallRectangle> holes = {});

std::optional<double> intersect(const LevelPatch& patch, const Ray& ray, double from);

std::optional<double> intersect(const PlanePatch& patch, const Ray& ray, double from);

std::optional<double> intersect(const ArcPatch& patch, const Ray& ray, double from);

std::optional<double> intersect(const Box& box, const Ray& ray, double from);

std::optional<double> intersect(const Cylinder& cylinder, const Ray& ray, double from);

/** @brief First hit of any shape beyond @p from. */
std::optional<double> intersect(const Shape& shape, const Ray& ray, double from);

/** @brief Box around the shape. */
Bounds boundsOf(const Shape& shape);

} // namespace pcl::sedr::sim
