// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/furniture.h"

#include <string>
#include <utility>

namespace pcl::sedr::sim {

/** @brief An object under construction; its boxes are relative to its spot. */
class Assembly {
public:
  Assembly(std::string name, const Spot& spot)
      : spot_(spot)
  {
    object_.name = std::move(name);
  }

  /** @brief Adds a box by its lower and upper corner relative to the spot. */
  void add(Vec3 low, Vec3 high)
  {
    const Vec3 middle = 0.5 * (low + high);
    const Vec2 center = spot_.center + rotated(plan(middle), spot_.yaw);
    object_.boxes.push_back(
        {lifted(center, spot_.floor + middle.z), high - low, spot_.yaw});
  }

  Object take() { return std::move(object_); }

private:
  Spot spot_;
  Object object_;
};

} // namespace pcl::sedr::sim
