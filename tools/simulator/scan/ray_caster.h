// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/mesh/scene_mesh.h"

#include <memory>
#include <optional>
#include <vector>

struct RTCSceneTy; // of Embree

namespace pcl::sedr::sim {

/** @brief A half line; @p direction has unit length. */
struct Ray {
  Vec3 origin;
  Vec3 direction;

  /** @brief Returns the point at distance @p t. */
  Vec3 at(double t) const { return origin + t * direction; }
};

/** @brief The nearest triangle along a ray. */
struct Hit {
  double distance = 0.0;
  std::size_t triangle = 0; ///< of the scene's mesh
};

/** @brief Casts rays at a scene's mesh with Embree; gaps let them pass.
 *
 * Embree finds the triangle in single precision. The distance is computed in double
 * precision from the triangle's plane. Threads may share a caster; the same ray gives
 * the same hit in every run. */
class RayCaster {
public:
  /** @brief Keeps a reference to @p scene.
   * @throw std::runtime_error if Embree fails */
  explicit RayCaster(const SceneMesh& scene);

  /** @brief Returns the first hit beyond @p from and at most @p to metres away. */
  std::optional<Hit> nearest(const Ray& ray, double from, double to) const;

  /** @brief Returns the unit normal of a triangle. */
  Vec3 normalOf(std::size_t triangle) const;

private:
  const SceneMesh& scene_;
  Vec3 origin_; ///< of Embree's coordinates, which have single precision
  std::vector<std::size_t> triangles_; ///< of the scene, as Embree numbers them
  std::shared_ptr<RTCSceneTy> embree_;
};

} // namespace pcl::sedr::sim
