// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <sstream>
#include <string>
#include <utility>
#include <vector>

/** @file The checks that problemsOf() consists of: see scene_check.h. */

namespace pcl::sedr::sim {

/** @brief Sentences about faults, each beginning with the place in the scene. */
class Problems {
public:
  template <typename... Parts>
  void report(const Parts&... parts)
  {
    std::ostringstream text;
    (text << ... << parts);
    sentences_.push_back(text.str());
  }

  bool empty() const { return sentences_.empty(); }

  std::vector<std::string> take() { return std::move(sentences_); }

private:
  std::vector<std::string> sentences_;
};

/** @brief Returns the place of an element of a list, as in "rooms[2]". */
inline std::string
placeOf(const std::string& list, std::size_t index)
{
  return list + '[' + std::to_string(index) + ']';
}

constexpr double kContact = 1e-6; ///< metres of overlap that count as contact
constexpr double kInside = 1e-3;  ///< metres inside a loop, clear of its edge

/** @brief Checks outlines, heights, details and columns, and that no rooms overlap. */
void checkRooms(const Scene& scene, Problems& problems);

/** @brief Checks holes in ceilings; rooms must have no faults. */
void checkVoids(const Scene& scene, Problems& problems);

/** @brief Checks openings and niches; rooms must have no faults. */
void checkOpenings(const Scene& scene, Problems& problems);

/** @brief Checks furniture and scanners; rooms must have no faults. */
void checkObjects(const Scene& scene, Problems& problems);

} // namespace pcl::sedr::sim
