// SPDX-License-Identifier: BSD-3-Clause
#include "most_alike.h"

#include <Eigen/Core>

#include <algorithm>

namespace pcl::sedr {

namespace {

/** @brief Returns the highest number of a room. */
Eigen::Index
lastRoom(const std::vector<std::uint32_t>& room_of)
{
  return room_of.empty() ? 0 : *std::max_element(room_of.begin(), room_of.end());
}

} // namespace

double
likeness(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b)
{
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(lastRoom(a) + 1, lastRoom(b) + 1);
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    ++both(a[i], b[i]);
  const Eigen::VectorXd of_a = both.rowwise().sum();
  const Eigen::VectorXd of_b = both.colwise().sum();
  Eigen::Index matched = 0;
  for (Eigen::Index m = 1; m < both.rows(); ++m)
    for (Eigen::Index n = 1; n < both.cols(); ++n)
      if (2 * both(m, n) > of_a(m) + of_b(n) - both(m, n))
        ++matched;
  const auto rooms = (of_a.array() > 0).count() - (of_a(0) > 0) +
                     (of_b.array() > 0).count() - (of_b(0) > 0);
  return rooms == 0 ? 0 : 2 * static_cast<double>(matched) / static_cast<double>(rooms);
}

std::size_t
mostAlike(const std::vector<Building>& buildings)
{
  Eigen::VectorXd sums =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(buildings.size()));
  for (std::size_t a = 0; a < buildings.size(); ++a)
    for (std::size_t b = a; b < buildings.size(); ++b) {
      const double alike = likeness(buildings[a].room_of, buildings[b].room_of);
      sums(static_cast<Eigen::Index>(a)) += alike;
      if (a != b)
        sums(static_cast<Eigen::Index>(b)) += alike;
    }
  Eigen::Index best = 0;
  if (sums.size() > 0)
    sums.maxCoeff(&best);
  return static_cast<std::size_t>(best);
}

} // namespace pcl::sedr
