// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Checks a scan that is read in pieces, by a sample of at most 100,000 of its
 * finite points. */
class ScanSample {
public:
  /** @param size number of points of the whole scan
   * @param finite_before number of finite points before the added ones, if these are a
   * part of the scan */
  explicit ScanSample(std::size_t size, std::size_t finite_before = 0)
      : size_(size)
      , step_(size / max_points + 1)
      , finite_(finite_before)
  {}

  /** @brief Adds the next points of the scan, in order; `threads` 0: all processors. */
  void add(const PointView& points, unsigned threads = 0);

  /** @brief Function that reads points and calls `see_run` for each available range. */
  using Read = std::function<void(const RowSource::SeeRun& see_run)>;

  /** @brief Adds the next points during another pass `read` over them. */
  void add(const PointView& points, const Read& read);

  void add(const Eigen::Vector3f& point)
  {
    if (point.allFinite() && finite_++ % step_ == 0)
      sample_.push_back(point);
  }

  /** @brief Adds the sample of the next part of the scan, with `finite` finite points.
   */
  void join(const std::vector<Eigen::Vector3f>& points, std::size_t finite)
  {
    sample_.insert(sample_.end(), points.begin(), points.end());
    finite_ += finite;
  }

  /** @brief Returns the number of finite points so far, including those before the
   * first added one. */
  std::size_t finite() const { return finite_; }

  /** @brief Returns the sample. */
  const std::vector<Eigen::Vector3f>& points() const { return sample_; }

  /** @brief Returns the sentence of scanProblem(). */
  std::string problem(const Priors& priors = {}) const;

  /** @brief Returns whether the sample is too large for the unit to be the metre. */
  bool isTooLarge(const Priors& priors = {}) const;

private:
  static constexpr std::size_t max_points = 100000;

  std::size_t size_;
  std::size_t step_;
  std::size_t finite_;
  std::vector<Eigen::Vector3f> sample_;
};

/** @brief Returns the problem of a scan as a whole, a sentence with numbers; empty if
 * it may show rooms in metres. Problems are too few finite points, too small a scan, or
 * too large for the unit to be the metre. Uses at most 100,000 of the points. */
std::string scanProblem(const PointView& points,
                        const std::vector<int>& indices,
                        const Priors& priors = {});

} // namespace pcl::sedr
