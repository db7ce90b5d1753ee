// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A vertical face below a ceiling, with histograms of the point distances below
 * the ceiling: on the face, and on the ceiling in front of it. */
class SlitFace {
public:
  /** @brief Upper end of the face. */
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

  /** @brief Counts a point if it is near the face. */
  void count(const Eigen::Vector3f& point, Counts& counts) const;

  void add(const Counts& counts) { counts_.add(counts); }

  /** @brief Returns the corners of the rectangle in plan of all points near the face.
   */
  const Eigen::Array2d& low() const { return low_; }
  const Eigen::Array2d& high() const { return high_; }

  /** @brief Returns the minimum height of points near the face, metres. */
  double lowest() const;

  double length() const { return element_.length(); }

  Top top() const;

private:
  /** @brief Returns the depth of the ceiling strip in front of the face, metres. */
  double farthestBefore() const { return 4 * priors_.evidence_cell; }

  PlanElement element_;
  const Priors& priors_;
  PlanSlab ceiling_;
  Eigen::Array2d low_; ///< of the bounding rectangle, in plan
  Eigen::Array2d high_;
  Counts counts_;
};

/** @brief Counts the points of a scan at each face. O(n) for n points; the result does
 * not depend on the number of threads.
 * @param indices the points to use; empty: all */
void countAtFaces(const std::vector<SlitFace*>& faces,
                  const PointView& raw,
                  const std::vector<int>& indices,
                  unsigned threads);

} // namespace pcl::sedr
