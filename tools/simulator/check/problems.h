// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/queries.h"

#include <sstream>
#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Sentences about faults, each beginning with the place in the scene. */
struct Problems {
  std::vector<std::string> sentences;

  /** @brief Adds the sentence that the parts make up; returns false. */
  template <typename... Parts>
  bool report(const Parts&... parts)
  {
    std::ostringstream text;
    (text << ... << parts);
    sentences.push_back(text.str());
    return false;
  }
};

/** @brief Returns a point as " at (x, y)". */
inline std::string
at(const Vec2& point)
{
  std::ostringstream text;
  text << " at (" << point.x() << ", " << point.y() << ")";
  return text.str();
}

constexpr double kContact = 1e-6; ///< metres of overlap that count as contact

/** @brief Checks furniture and scanners; rooms must have no faults. */
void checkObjects(const Scene& scene, Problems& problems);

} // namespace pcl::sedr::sim
