// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace pcl::sedr {

/** @brief Robust statistics of up to 25 values of a window. */
class ReliefWindow {
public:
  void add(double value)
  {
    if (!std::isnan(value))
      values_[size_++] = value;
  }

  std::size_t size() const { return size_; }

  /** @brief Returns whether the median is within `flat` of 0, by counting. */
  bool isWithin(double flat) const
  {
    std::size_t above = 0;
    std::size_t below = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      above += values_[i] > flat ? 1 : 0;
      below += values_[i] < -flat ? 1 : 0;
    }
    return above < size_ - size_ / 2 && below <= size_ / 2;
  }

  /** @brief Returns bounds of middleMean(): it deviates from the mean of all values by
   * at most half the deviation of the farthest value. There must be at least one value.
   */
  std::pair<double, double> middleRange() const
  {
    constexpr double rounding = 1e-9;
    const auto end = values_.begin() + static_cast<std::ptrdiff_t>(size_);
    const auto [low, high] = std::minmax_element(values_.begin(), end);
    const double mean =
        std::accumulate(values_.begin(), end, 0.0) / static_cast<double>(size_);
    return {mean - (*high - mean) / 2 - rounding, mean + (mean - *low) / 2 + rounding};
  }

  double median()
  {
    const auto middle = at(size_ / 2);
    std::nth_element(values_.begin(), middle, at(size_));
    return *middle;
  }

  /** @brief Returns the mean of the middle half of the values. Heights of voxels lie in
   * layers, between which a median may jump. */
  double middleMean()
  {
    std::sort(values_.begin(), at(size_));
    const std::size_t first = size_ / 4;
    const std::size_t last = size_ - first;
    return std::accumulate(at(first), at(last), 0.0) /
           static_cast<double>(last - first);
  }

private:
  std::array<double, 25>::iterator at(std::size_t i)
  {
    return values_.begin() + static_cast<std::ptrdiff_t>(i);
  }

  std::array<double, 25> values_{};
  std::size_t size_ = 0;
};

} // namespace pcl::sedr
