// SPDX-License-Identifier: BSD-3-Clause
#include "triangle_tree.h"

#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr std::size_t max_in_leaf = 6;
constexpr std::size_t block = 4096; ///< triangles or boxes per block

/** @brief Returns the squared distance of the origin from a segment. */
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
    , origin_(mesh.bounds().center())
    , order_(mesh.triangles.size())
{
  while (order_.size() >> levels_ >= max_in_leaf)
    ++levels_;
  std::iota(order_.begin(), order_.end(), 0);
  std::vector<Eigen::Vector3f> centres(order_.size());
  parallelFor(centres.size(), block, threads, [&](std::size_t t) {
    const Eigen::Vector3d sum =
        mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2);
    centres[t] = (sum / 3 - origin_).cast<float>();
  });
  for (unsigned level = 0; level < levels_; ++level)
    parallelFor(std::size_t{1} << level, 1, threads,
                [&](std::size_t k) { split(level, k, centres); });
  const std::size_t leaves = std::size_t{1} << levels_;
  boxes_.resize(2 * leaves - 1);
  parallelFor(leaves, block, threads,
              [&](std::size_t k) { boxes_[leaves - 1 + k] = boxOfLeaf(k); });
  for (std::size_t i = leaves - 1; i-- > 0;)
    boxes_[i] = boxes_[2 * i + 1].merged(boxes_[2 * i + 2]);
}

/** @brief Sorts the triangles of a box into two halves, across its longest side. */
void
TriangleTree::split(unsigned level,
                    std::size_t k,
                    const std::vector<Eigen::Vector3f>& centres)
{
  const auto at = [&](std::size_t place) {
    return order_.begin() + static_cast<std::ptrdiff_t>(place);
  };
  const auto begin = at(first(level, k));
  const auto end = at(first(level, k + 1));
  Box box;
  for (auto t = begin; t != end; ++t)
    box.extend(centres[*t]);
  Eigen::Index longest = 0;
  box.sizes().maxCoeff(&longest);
  std::nth_element(begin, at(first(level + 1, 2 * k + 1)), end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return centres[a][longest] < centres[b][longest];
                   });
}

/** @brief Returns the box of a leaf's triangles, rounded outwards. */
TriangleTree::Box
TriangleTree::boxOfLeaf(std::size_t leaf) const
{
  Eigen::AlignedBox3d box;
  for (std::size_t i = first(levels_, leaf); i < first(levels_, leaf + 1); ++i)
    for (int c = 0; c < 3; ++c)
      box.extend(mesh_.corner(order_[i], c) - origin_);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Box outer(box.min().cast<float>(), box.max().cast<float>());
  for (int axis = 0; axis < 3; ++axis) {
    outer.min()[axis] = std::nextafter(outer.min()[axis], -infinity);
    outer.max()[axis] = std::nextafter(outer.max()[axis], infinity);
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
  const Eigen::Array3d p = point - origin_;
  const auto stepTo = [&](std::size_t i) -> Step {
    const Eigen::Array3d low = boxes_[i].min().cast<double>();
    const Eigen::Array3d high = boxes_[i].max().cast<double>();
    return {i, (low - p).max(p - high).max(0.0).square().sum()};
  };
  constexpr std::size_t deepest = 64;
  std::array<Step, deepest> steps; // at most one more per level
  const std::size_t first_leaf = (std::size_t{1} << levels_) - 1;
  double best = std::numeric_limits<double>::infinity();
  std::size_t count = 0;
  steps[count++] = stepTo(0);
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
    Step near = stepTo(2 * step.box + 1);
    Step far = stepTo(2 * step.box + 2);
    if (far.least < near.least)
      std::swap(near, far);
    for (const Step& next : {far, near})
      if (next.least < best)
        steps[count++] = next;
  }
  return std::sqrt(best);
}

} // namespace pcl::sedr
