// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random.h"
#include "ray_caster.h"
#include "scan_point.h"
#include "simulator/scene/scene.h"

#include <optional>

namespace pcl::sedr::sim {

/** @brief Tells what a scanner records for a single ray. Safe to share among threads.
 */
class Tracer {
public:
  /** @brief Keeps a reference to @p scene, which must live longer.
   * @throw std::invalid_argument if the scene cannot be built: see surfacesOf()
   */
  explicit Tracer(const Scene& scene);

  /** @brief The record of a ray in the frame of the files; empty if nothing is hit.
   *
   * A window pane returns some of the rays, mirrors some, and lets the others pass. A
   * mirrored ray is recorded straight ahead, where the scanner believes it to be.
   * @param ray in the scene's own frame, direction of unit length
   */
  std::optional<ScanPoint>
  measure(const Ray& ray, const Scanner& scanner, RayRandom& random) const;

private:
  /** @brief What ends a ray. */
  struct Echo {
    double range = 0.0; ///< along the whole way
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
