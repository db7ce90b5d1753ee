// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief An upright face below a ceiling, and how many points of a scan are how far
 * below it: on the face, and on the ceiling before it. */
class SlitFace {
public:
  /** @brief What the face ends at. */
  enum class Top { Unknown, Ceiling, Slit };

  /** @param priors must outlive this */
  SlitFace(const PlanRoom& room, const PlanElement& element, const Priors& priors);

  /** @brief Counts of points by their distance below the ceiling. */
  struct Counts {
    static constexpr double step = 0.005;   ///< metres
    static constexpr double highest = -0.1; ///< above the ceiling
    static constexpr std::size_t bins = 80; ///< down to 0.3 m below it
    std::array<std::size_t, bins> face{};
    std::array<std::size_t, bins> ceiling{};

    void add(const Counts& other);
  };

  /** @brief Counts a point, if it is near the face. */
  void count(const Eigen::Vector3f& point, Counts& counts) const;

  void add(const Counts& counts) { counts_.add(counts); }

  /** @brief The corners of the rectangle in plan that holds all points near the face.
   */
  const Eigen::Array2d& low() const { return low_; }
  const Eigen::Array2d& high() const { return high_; }

  /** @brief No point below it is near the face, metres. */
  double lowest() const;

  double length() const { return element_.length(); }

  Top top() const;

private:
  /** @brief How far before the face the ceiling is looked at, metres. */
  double farthestBefore() const { return 4 * priors_.evidence_cell; }

  PlanElement element_;
  const Priors& priors_;
  PlanSlab ceiling_;
  Eigen::Array2d low_; ///< of what is near the face, in plan
  Eigen::Array2d high_;
  Counts counts_;
};

/** @brief Counts the points of a scan at each face. O(n) for n points, each of which is
 * shown to the faces near it only; the same for any number of threads.
 * @param indices those of the points that count; empty: all */
void countAtFaces(const std::vector<SlitFace*>& faces,
                  const PointView& raw,
                  const std::vector<int>& indices,
                  unsigned threads);

} // namespace sedr
} // namespace pcl
