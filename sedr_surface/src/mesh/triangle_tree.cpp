// SPDX-License-Identifier: BSD-3-Clause
#include "triangle_tree.h"

#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr std::size_t max_in_leaf = 6;
constexpr std::size_t block = 4096; ///< triangles or boxes per block

/** @brief Returns the squared distance of the origin from the segment between two
 * points. */
double
squaredToSegment(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d way = b - a;
  const double length = way.squaredNorm();
  const double t = length > 0 ? std::clamp(-a.dot(way) / length, 0.0, 1.0) : 0.0;
  return (a + t * way).squaredNorm();
}

} // namespace

double
squaredToTriangle(const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b,
                  const Eigen::Vector3d& c)
{
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double length = normal.squaredNorm();
  if (length > 0 && normal.dot(a.cross(b)) >= 0 && normal.dot(b.cross(c)) >= 0 &&
      normal.dot(c.cross(a)) >= 0) {
    const double height = normal.dot(a);
    return height * height / length;
  }
  return std::min(
      {squaredToSegment(a, b), squaredToSegment(b, c), squaredToSegment(c, a)});
}

TriangleTree::TriangleTree(const TriangleMesh& mesh, unsigned threads)
    : mesh_(mesh)
    , bounds_(mesh.bounds())
    , origin_(bounds_.center())
    , order_(mesh.triangles.size())
{
  while (order_.size() >> levels_ >= max_in_leaf)
    ++levels_;
  std::iota(order_.begin(), order_.end(), 0);
  {
    const std::vector<Centre> all = centres(threads);
    for (unsigned level = 0; level < levels_; ++level)
      parallelBlocks(std::size_t{1} << level, 1, threads,
                     [&](std::size_t k, std::size_t) { split(level, k, all); });
  }
  const std::size_t leaves = std::size_t{1} << levels_;
  boxes_.resize(2 * leaves - 1);
  parallelFor(leaves, block, threads,
              [&](std::size_t k) { boxes_[leaves - 1 + k] = boxOfLeaf(k); });
  for (std::size_t i = leaves - 1; i-- > 0;) {
    const Box& a = boxes_[2 * i + 1];
    const Box& b = boxes_[2 * i + 2];
    boxes_[i] = {a.low.min(b.low), a.high.max(b.high)};
  }
}

std::vector<TriangleTree::Centre>
TriangleTree::centres(unsigned threads) const
{
  const double most = std::numeric_limits<std::uint16_t>::max();
  const Eigen::Array3d scale = most / bounds_.sizes().array().max(1e-9);
  std::vector<Centre> result(mesh_.triangles.size());
  parallelFor(result.size(), block, threads, [&](std::size_t t) {
    const Eigen::Array3d sum =
        mesh_.corner(t, 0) + mesh_.corner(t, 1) + mesh_.corner(t, 2);
    const Eigen::Array3d at =
        ((sum / 3 - bounds_.min().array()) * scale).max(0.0).min(most);
    for (int axis = 0; axis < 3; ++axis)
      result[t][static_cast<std::size_t>(axis)] = static_cast<std::uint16_t>(at[axis]);
  });
  return result;
}

/** @brief Sorts the triangles of a box into two halves, across its longest side. */
void
TriangleTree::split(unsigned level, std::size_t k, const std::vector<Centre>& centres)
{
  const auto at = [&](std::size_t place) {
    return order_.begin() + static_cast<std::ptrdiff_t>(place);
  };
  const auto begin = at(first(level, k));
  const auto end = at(first(level, k + 1));
  Centre low = centres[*begin];
  Centre high = low;
  for (auto t = begin; t != end; ++t)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], centres[*t][axis]);
      high[axis] = std::max(high[axis], centres[*t][axis]);
    }
  const Eigen::Vector3d sizes = bounds_.sizes();
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double size = (high[axis] - low[axis]) * sizes[static_cast<int>(axis)];
    if (size <= most)
      continue;
    most = size;
    longest = axis;
  }
  std::nth_element(begin, at(first(level + 1, 2 * k + 1)), end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return centres[a][longest] < centres[b][longest];
                   });
}

TriangleTree::Box
TriangleTree::boxOfLeaf(std::size_t leaf) const
{
  Eigen::AlignedBox3d box;
  for (std::size_t i = first(levels_, leaf); i < first(levels_, leaf + 1); ++i)
    for (int c = 0; c < 3; ++c)
      box.extend(mesh_.corner(order_[i], c) - origin_);
  Box outer;
  for (int axis = 0; axis < 3; ++axis) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    outer.low[axis] = std::nextafter(static_cast<float>(box.min()[axis]), -infinity);
    outer.high[axis] = std::nextafter(static_cast<float>(box.max()[axis]), infinity);
  }
  return outer;
}

double
TriangleTree::distance(const Eigen::Vector3d& point) const
{
  struct Step {
    std::size_t box;
    double least; ///< minimum squared distance of its content
  };
  constexpr std::size_t deepest = 64;
  std::array<Step, deepest> steps; // at most one more per level
  const Eigen::Array3d p = point - origin_;
  const std::size_t first_leaf = (std::size_t{1} << levels_) - 1;
  double best = std::numeric_limits<double>::infinity();
  std::size_t count = 0;
  steps[count++] = {0, boxes_[0].squaredDistance(p)};
  while (count > 0) {
    const Step step = steps[--count];
    if (step.least >= best)
      continue;
    if (step.box >= first_leaf) {
      const std::size_t leaf = step.box - first_leaf;
      for (std::size_t i = first(levels_, leaf); i < first(levels_, leaf + 1); ++i)
        best = std::min(best, squaredToTriangle(mesh_.corner(order_[i], 0) - point,
                                                mesh_.corner(order_[i], 1) - point,
                                                mesh_.corner(order_[i], 2) - point));
      continue;
    }
    Step near{2 * step.box + 1, boxes_[2 * step.box + 1].squaredDistance(p)};
    Step far{2 * step.box + 2, boxes_[2 * step.box + 2].squaredDistance(p)};
    if (far.least < near.least)
      std::swap(near, far);
    if (far.least < best)
      steps[count++] = far;
    if (near.least < best)
      steps[count++] = near;
  }
  return std::sqrt(best);
}

} // namespace pcl::sedr
