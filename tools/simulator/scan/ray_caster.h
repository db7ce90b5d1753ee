// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A shape with the label and room of its points. */
struct Surface {
  Shape shape;
  Label label = Label::Other;
  std::uint32_t room = 0;                        ///< counts from 1; 0 none
  std::optional<Glazing> glazing = std::nullopt; ///< set for window panes
  Side front = Side::None; ///< the room's side; the other side is labelled Other
};

/** @brief The nearest surface along a ray. */
struct Hit {
  double distance = 0.0;
  const Surface* surface = nullptr;
};

/** @brief Finds the nearest surface along a ray with a tree of bounding boxes.
 *
 * Building costs O(n log^2 n), a ray O(log n) for scattered surfaces. Threads may share
 * it.
 */
class RayCaster {
public:
  explicit RayCaster(std::vector<Surface> surfaces);

  /** @brief Returns the first hit beyond @p from and at most @p to metres away. */
  std::optional<Hit> nearest(const Ray& ray, double from, double to) const;

private:
  /** @brief A box around surfaces: a leaf if count > 0, otherwise with two children. */
  struct Node {
    Bounds bounds;
    std::uint32_t first = 0; ///< leaf: first surface; otherwise: the second child
    std::uint32_t count = 0;
  };

  void build(std::uint32_t first, std::uint32_t count);

  std::vector<Surface> surfaces_;
  std::vector<Bounds> bounds_; ///< box of each surface, in the same order
  std::vector<Node> nodes_;    ///< the first child follows its parent
};

} // namespace pcl::sedr::sim
