// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Numbers places; those within a hundredth of a millimetre are one. */
class PlaceNumbers {
public:
  std::size_t numberOf(const Eigen::Vector2d& p);

  const Eigen::Vector2d& at(std::size_t number) const { return places_[number]; }

private:
  static constexpr double size = 1e-5; // metres
  std::multimap<std::pair<std::int64_t, std::int64_t>, std::size_t> numbers_;
  std::vector<Eigen::Vector2d> places_;
};

/** @brief A straight piece of a label's border, the label to its left. */
struct Piece {
  std::size_t from; ///< number of its place, see PlaceNumbers
  std::size_t to;
  std::uint32_t line; ///< the curve that it is of
};

/** @brief Returns the area of a loop of pieces, below 0 if it is clockwise. */
double areaOf(const std::vector<Piece>& loop, const PlaceNumbers& places);

/** @brief Follows pieces to closed loops; where several go on, the first to the left,
 * so that a loop touches itself at no corner from inside. O(n log n). */
std::vector<std::vector<Piece>> loopsOf(const std::vector<Piece>& pieces,
                                        const PlaceNumbers& places);

} // namespace pcl::sedr
