// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/row_source.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Looks at no more than 100,000 of the finite points of a scan that comes piece
 * by piece, and says what is wrong with it. */
class ScanSample {
public:
  /** @param size of the whole scan, points
   * @param finite_before how many finite points of the scan come before those that will
   * be added, where they are a part of it */
  explicit ScanSample(std::size_t size, std::size_t finite_before = 0)
      : size_(size)
      , step_(size / most_points + 1)
      , finite_(finite_before)
  {}

  /** @brief Takes the next points of the scan, in their order; `threads` 0: all. */
  void add(const PointView& points, unsigned threads = 0);

  /** @brief Reads points, and calls `see_run` for all of them as they are at hand. */
  using Read = std::function<void(const RowSource::SeeRun& see_run)>;

  /** @brief The same, while another purpose makes `read` go through them. */
  void add(const PointView& points, const Read& read);

  void add(const Eigen::Vector3f& point)
  {
    if (point.allFinite() && finite_++ % step_ == 0)
      sample_.push_back(point);
  }

  /** @brief Adds what was looked at of the part of the scan that comes next, of which
   * `finite` points are finite. */
  void join(const std::vector<Eigen::Vector3f>& points, std::size_t finite)
  {
    sample_.insert(sample_.end(), points.begin(), points.end());
    finite_ += finite;
  }

  /** @brief Finite points so far, those before the first one added among them. */
  std::size_t finite() const { return finite_; }

  /** @brief The points looked at. */
  const std::vector<Eigen::Vector3f>& points() const { return sample_; }

  /** @brief The sentence of scanProblem(). */
  std::string problem(const Priors& priors = {}) const;

  /** @brief Whether what was seen so far is so large that the metre cannot be the unit.
   */
  bool isTooLarge(const Priors& priors = {}) const;

private:
  static constexpr std::size_t most_points = 100000;

  std::size_t size_;
  std::size_t step_;
  std::size_t finite_;
  std::vector<Eigen::Vector3f> sample_;
};

/** @brief What is wrong with a scan as a whole, a sentence with its numbers; empty if
 * it may be one of rooms in metres: too few finite points, too small, or so large that
 * its unit cannot be the metre. Looks at no more than 100,000 of the points. */
std::string scanProblem(const PointView& points,
                        const std::vector<int>& indices,
                        const Priors& priors = {});

/** @brief What is known of rooms along z when upProblem() is asked. */
enum class RoomsAlongZ {
  NotLookedFor,
  None, ///< there is no floor with a ceiling above it
  Found
};

/** @brief Whether the scan looks as if another axis than z were up: a sentence with the
 * turn that mends it, else empty. Then across another axis there are two planes at the
 * distance of a floor and a ceiling that are half as large again as across z, where z
 * gives rooms higher than 4.5 m or none; where there are rooms, they are four times as
 * large as across z, and half as large again as any level of z. For thinned points.
 * @param found_area of the rooms that were found along z, the smaller one of all floors
 * and all ceilings, square metres: these may lean
 * @param threads    0: as many as there are processors; any number gives the same */
std::string upProblem(const PointView& points,
                      const std::vector<int>& indices,
                      RoomsAlongZ rooms = RoomsAlongZ::NotLookedFor,
                      double found_area = 0,
                      unsigned threads = 1,
                      const Priors& priors = {});

/** @brief Whether a plan looks as if its unit were the foot: a sentence, else empty.
 * Then rooms with four fifths of the area are 7 to 12 high, and half of them or more
 * have an area below 300: halls of that height are larger. Two rooms alone may be halls
 * all the same, unless the doors between them are 5.9 to 8.5 high. O(rooms). */
std::string footProblem(const Floorplan& plan, const Priors& priors = {});

} // namespace sedr
} // namespace pcl
