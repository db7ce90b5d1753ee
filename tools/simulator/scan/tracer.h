// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random.h"
#include "ray_caster.h"
#include "scan.h"
#include "simulator/scene/scene.h"

#include <optional>

namespace pcl::sedr::sim {

/** @brief Computes what a scanner records for a single ray. Threads may share it. */
class Tracer {
public:
  /** @brief Keeps a reference to @p scene, which must outlive the tracer.
   * @throw std::invalid_argument if the scene cannot be built: see surfacesOf()
   */
  explicit Tracer(const Scene& scene);

  /** @brief Returns the record of a ray in the frame of the files; empty without a hit.
   *
   * A window pane returns some of the rays, mirrors some and transmits the others. A
   * mirrored ray is recorded along its original direction, as a real scanner does.
   * @param ray in the scene's own frame, direction of unit length
   */
  std::optional<ScanPoint>
  measure(const Ray& ray, const Scanner& scanner, RayRandom& random) const;

private:
  /** @brief The surface point that ends a ray. */
  struct Echo {
    double range = 0.0; ///< along all legs of the ray
    Label label = Label::Other;
    std::uint32_t room = 0;
  };

  std::optional<Echo>
  findEcho(const Ray& ray, double max_range, RayRandom& random) const;

  static Echo echoOf(const Ray& leg, const Hit& hit);

  const Scene& scene_;
  const RayCaster caster_;
};

} // namespace pcl::sedr::sim
