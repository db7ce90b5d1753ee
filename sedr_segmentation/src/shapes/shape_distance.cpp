// SPDX-License-Identifier: BSD-3-Clause
#include "shape_fit.h"

#include "sedr_filters/src/plan/plan_geometry.h"

namespace pcl::sedr {

namespace {

constexpr double at_axis = 1e-9; // of the radius

} // namespace

const std::array<int, 7>&
numbersOf(ShapeKind kind)
{
  static constexpr std::array<int, 7> numbers[] = {
      {-1, -1, 0, -1, -1, -1, -1}, // ShapeKind::Level
      {0, 1, 2, -1, -1, -1, -1},   // Plane
      {-1, 0, 1, 2, -1, 3, 3},     // Cylinder
      {0, 1, 2, -1, 3, 3, 3},      // Sphere
      {-1, 0, 1, 2, -1, 3, 4},     // EllipticCylinder
      {0, 1, 2, 3, 4, 5, 6}};      // Ellipsoid
  return numbers[static_cast<std::size_t>(kind)];
}

std::vector<PointRow>
rowsOf(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<PointRow> rows;
  rows.reserve(points.size() / row_size + 1);
  for (std::size_t begin = 0; begin < points.size(); begin += row_size) {
    const auto size = static_cast<Eigen::Index>(
        std::min<std::size_t>(row_size, points.size() - begin));
    rows.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      rows.back().at[k].resize(size);
      for (Eigen::Index i = 0; i < size; ++i)
        rows.back().at[k][i] =
            points[begin + static_cast<std::size_t>(i)][static_cast<Eigen::Index>(k)];
    }
  }
  return rows;
}

void
distancesOf(const PlanSlab& slab, const PointRow& points, ShapeValues& distance)
{
  if (!isRelief(slab)) {
    const bool is_flat = !slab.curve;
    ShapeDistance(is_flat ? ShapeKind::Plane : ShapeKind::Ellipsoid, slab,
                  Eigen::Vector3d::Zero())
        .of(points, distance);
    return;
  }
  const auto& [x, y, z] = points.at;
  distance.resize(points.size());
  for (Eigen::Index i = 0; i < points.size(); ++i)
    distance[i] = slab.curve->distanceAbove({x[i], y[i], z[i]});
}

ShapeDistance::ShapeDistance(ShapeKind kind,
                             const PlanSlab& slab,
                             const Eigen::Vector3d& about)
    : kind_(kind)
    , about_(about)
    , plane_(slab.plane)
{
  if (isFlat(kind))
    return;
  const SlabCurve& c = *slab.curve;
  axis_ = c.axis;
  aside_ = Eigen::Vector2d(-c.axis.y(), c.axis.x());
  centre_ = Eigen::Vector3d(c.centre.x(), c.centre.y(), c.base);
  const double along = c.kind == CurveKind::Ellipsoid ? 1 / c.along : 0;
  inverse_ = Eigen::Vector3d(along, 1 / c.across, 1 / c.up);
}

void
ShapeDistance::of(const PointRow& points, ShapeValues& distance) const
{
  const auto& [x, y, z] = points.at;
  if (isFlat(kind_)) {
    distance = plane_[0] * x + plane_[1] * y + plane_[2] * z + plane_[3];
    return;
  }
  Places places;
  placesOf(points, places, distance);
}

void
ShapeDistance::placesOf(const PointRow& points,
                        Places& places,
                        ShapeValues& distance) const
{
  auto& [local, unit, slope, out, square] = places;
  const auto& [x, y, z] = points.at;
  local[0] = axis_.x() * (x - centre_.x()) + axis_.y() * (y - centre_.y());
  local[1] = aside_.x() * (x - centre_.x()) + aside_.y() * (y - centre_.y());
  local[2] = z - centre_.z();
  for (std::size_t k = 0; k < 3; ++k) {
    unit[k] = local[k] * inverse_[static_cast<Eigen::Index>(k)];
    slope[k] = unit[k] * inverse_[static_cast<Eigen::Index>(k)];
  }
  const auto squareOf = [](const std::array<ShapeValues, 3>& v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  };
  out = squareOf(unit).sqrt().max(at_axis);
  square = squareOf(slope);
  distance = (out - 1) * out / square.sqrt().max(at_axis);
}

void
ShapeDistance::of(const PointRow& points,
                  ShapeValues& distance,
                  std::array<ShapeValues, 7>& growth) const
{
  const auto& [x, y, z] = points.at;
  if (isFlat(kind_)) {
    of(points, distance);
    if (kind_ == ShapeKind::Level) {
      growth[0].setConstant(points.size(), -1);
      return;
    }
    growth[0] = -plane_[2] * (x - about_.x()) + distance * plane_[2] * plane_[0];
    growth[1] = -plane_[2] * (y - about_.y()) + distance * plane_[2] * plane_[1];
    growth[2].setConstant(points.size(), -plane_[2]);
    return;
  }
  Places places;
  placesOf(points, places, distance);
  const auto& [local, unit, slope, out, square] = places;
  // The distance is (out^2 - out) / |slope|, all of the unit sphere. How it grows with
  // x, y and z of the place, and with the three inverse extents.
  const ShapeValues outwards = (2 * out - 1) / (out * square.sqrt());
  const ShapeValues turning = distance / square;
  std::array<ShapeValues, 3> by_place;
  std::array<ShapeValues, 3> by_extent;
  for (std::size_t k = 0; k < 3; ++k) {
    const double inverse = inverse_[static_cast<Eigen::Index>(k)];
    by_place[k] = outwards * slope[k] - turning * (slope[k] * inverse * inverse);
    by_extent[k] = outwards * (unit[k] * local[k]) - 2 * turning * (slope[k] * unit[k]);
  }
  // The crown stays where it is.
  by_extent[2] -= by_place[2] / (inverse_.z() * inverse_.z());
  const std::array<ShapeValues, 7> all = {
      -by_place[0], -by_place[1],
      -by_place[2], by_place[0] * local[1] - by_place[1] * local[0],
      by_extent[0], by_extent[1],
      by_extent[2]};
  int known = 0;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (const int number = numbersOf(kind_)[k]; number == known) {
      growth[static_cast<std::size_t>(number)] = all[k];
      ++known;
    }
    else if (number >= 0)
      growth[static_cast<std::size_t>(number)] += all[k];
}

} // namespace pcl::sedr
