// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A shape and what its points are called. */
struct Surface {
  Shape shape;
  Label label = Label::Other;
  std::uint32_t room = 0;                        ///< counts from 1; 0 none
  std::optional<Glazing> glazing = std::nullopt; ///< set for window panes
  Side front = Side::None; ///< the room's side; seen from the other it is no structure
};

/** @brief The nearest surface along a ray. */
struct Hit {
  double distance = 0.0;
  const Surface* surface = nullptr;
};

/** @brief Finds the nearest surface along a ray by a tree of bounding boxes.
 *
 * Building costs O(n log^2 n), a ray O(log n) for scattered surfaces. Safe to share
 * among threads.
 */
class RayCaster {
public:
  explicit RayCaster(std::vector<Surface> surfaces);

  /** @brief First hit farther than @p from and not farther than @p to, in metres. */
  std::optional<Hit> nearest(const Ray& ray, double from, double to) const;

  const std::vector<Surface>& getSurfaces() const { return surfaces_; }

private:
  /** @brief A box around surfaces: a leaf if count > 0, else the children follow. */
  struct Node {
    Bounds bounds;
    std::uint32_t first = 0; ///< leaf: first surface; else: the second child
    std::uint32_t count = 0;
  };

  void build(std::uint32_t first, std::uint32_t count);

  std::vector<Surface> surfaces_;
  std::vector<Bounds> bounds_; ///< of the surfaces, in their order
  std::vector<Node> nodes_;    ///< the first child follows its parent
};

} // namespace pcl::sedr::sim
