// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

constexpr double steepest = 1000; ///< rise in metres per metre

/** @brief Returns a place along the axis of a curve, and to the left of it. */
Eigen::Vector2d
localPlace(const SlabCurve& curve, const Eigen::Vector2d& p)
{
  const Eigen::Vector2d off = p - curve.centre;
  return {curve.axis.dot(off), curve.axis.x() * off.y() - curve.axis.y() * off.x()};
}

/** @brief Returns the squared distance from the axis, scaled to 1 on the rim. */
double
squareOut(const SlabCurve& curve, const Eigen::Vector2d& local)
{
  const double v = local.y() / curve.across;
  const double u = curve.kind == CurveKind::Ellipsoid ? local.x() / curve.along : 0;
  return u * u + v * v;
}

/** @brief The cell of a relief around a place, and the position in it, 0 to 1. */
struct ReliefPlace {
  std::size_t column = 0;
  std::size_t row = 0;
  Eigen::Vector2d share = Eigen::Vector2d::Zero();
};

ReliefPlace
reliefPlace(const SlabCurve& curve, const Eigen::Vector2d& p)
{
  ReliefPlace place;
  const auto split = [](double at, std::size_t count, std::size_t& first) {
    const double last = static_cast<double>(count) - 1;
    const double inside = std::clamp(at, 0.0, last);
    first = static_cast<std::size_t>(std::min(std::floor(inside), last - 1));
    return inside - static_cast<double>(first);
  };
  const Eigen::Vector2d at = localPlace(curve, p) / curve.spacing;
  place.share.x() = split(at.x(), curve.columns, place.column);
  place.share.y() = split(at.y(), curve.rows(), place.row);
  return place;
}

/** @brief Returns the heights around a place by x: lower row, then upper row. */
Eigen::Vector4d
heightsAbout(const SlabCurve& curve, const ReliefPlace& place)
{
  const double* const low = &curve.heights[place.row * curve.columns + place.column];
  const double* const high = low + curve.columns;
  return {low[0], low[1], high[0], high[1]};
}

} // namespace

double
SlabCurve::distanceAbove(const Eigen::Vector3d& p) const
{
  if (kind == CurveKind::Relief)
    return (p.z() - heightAt(p.head<2>())) /
           std::sqrt(1 + gradientAt(p.head<2>()).squaredNorm());
  const Eigen::Vector2d local = localPlace(*this, p.head<2>());
  const Eigen::Vector3d q(kind == CurveKind::Ellipsoid ? local.x() / along : 0,
                          local.y() / across, (p.z() - base) / up);
  const double out = q.norm();
  if (out < 1e-9)
    return -std::min(across, up);
  const Eigen::Vector3d growth(kind == CurveKind::Ellipsoid ? q.x() / along : 0,
                               q.y() / across, q.z() / up);
  return (out - 1) * out / growth.norm();
}

double
SlabCurve::highest() const
{
  return kind == CurveKind::Relief ? *std::max_element(heights.begin(), heights.end())
                                   : base + up;
}

double
SlabCurve::heightAt(const Eigen::Vector2d& p) const
{
  if (kind == CurveKind::Relief) {
    const ReliefPlace place = reliefPlace(*this, p);
    const Eigen::Vector4d z = heightsAbout(*this, place);
    const double low = z[0] + place.share.x() * (z[1] - z[0]);
    const double high = z[2] + place.share.x() * (z[3] - z[2]);
    return low + place.share.y() * (high - low);
  }
  return base +
         up * std::sqrt(std::max(0.0, 1 - squareOut(*this, localPlace(*this, p))));
}

Eigen::Vector2d
SlabCurve::gradientAt(const Eigen::Vector2d& p) const
{
  if (kind == CurveKind::Relief) {
    const ReliefPlace place = reliefPlace(*this, p);
    const Eigen::Vector4d z = heightsAbout(*this, place);
    const double x =
        (1 - place.share.y()) * (z[1] - z[0]) + place.share.y() * (z[3] - z[2]);
    const double y =
        (1 - place.share.x()) * (z[2] - z[0]) + place.share.x() * (z[3] - z[1]);
    return (x * axis + y * Eigen::Vector2d(-axis.y(), axis.x())) / spacing;
  }
  const Eigen::Vector2d local = localPlace(*this, p);
  const double square = squareOut(*this, local);
  if (square >= 1)
    return Eigen::Vector2d::Zero();
  Eigen::Vector2d slope(0, -local.y() / (across * across));
  if (kind == CurveKind::Ellipsoid)
    slope.x() = -local.x() / (along * along);
  slope *= up / std::sqrt(1 - square);
  if (slope.norm() > steepest)
    slope *= steepest / slope.norm();
  return slope.x() * axis + slope.y() * Eigen::Vector2d(-axis.y(), axis.x());
}

bool
SlabCurve::isFinite() const
{
  const bool is_placed =
      centre.allFinite() && std::isfinite(base) && std::abs(axis.norm() - 1) < 1e-6;
  if (kind == CurveKind::Relief)
    return is_placed && spacing > 0 && columns > 1 && rows() > 1 &&
           heights.size() == columns * rows() &&
           std::all_of(heights.begin(), heights.end(),
                       [](double z) { return std::isfinite(z); });
  const auto isExtent = [](double extent) {
    return extent > 0 && std::isfinite(extent);
  };
  return is_placed && isExtent(across) && isExtent(up) &&
         (kind == CurveKind::Cylinder || isExtent(along));
}

SlabCurve
moved(SlabCurve curve, double angle, const Eigen::Vector3d& shift)
{
  curve.centre = Eigen::Rotation2Dd(angle) * curve.centre + shift.head<2>();
  curve.base += shift.z();
  curve.axis = Eigen::Rotation2Dd(angle) * curve.axis;
  for (double& z : curve.heights)
    z += shift.z();
  return curve;
}

Floorplan
moved(Floorplan plan, double angle, const Eigen::Vector3d& shift)
{
  const Eigen::Rotation2Dd turn(angle);
  const auto move = [&](Eigen::Vector2d& p) { p = turn * p + shift.head<2>(); };
  const auto lift = [&](auto&... heights) { ((heights += shift.z()), ...); };
  const auto moveLoop = [&](PlanLoop& loop) {
    for (PlanElement& element : loop.elements)
      for (Eigen::Vector2d* p : {&element.start, &element.end, &element.centre})
        move(*p);
  };
  const auto moveLoops = [&](std::vector<PlanLoop>& loops) {
    std::for_each(loops.begin(), loops.end(), moveLoop);
  };
  const auto moveSlab = [&](PlanSlab& slab) {
    slab.plane.head<2>() = turn * Eigen::Vector2d(slab.plane.head<2>());
    slab.plane[3] -= slab.plane.head<3>().dot(shift);
    if (slab.curve)
      slab.curve = std::make_shared<const SlabCurve>(moved(*slab.curve, angle, shift));
  };
  for (PlanRoom& room : plan.rooms) {
    moveLoop(room.boundary);
    moveLoops(room.columns);
    moveSlab(room.floor);
    moveSlab(room.ceiling);
    for (auto* const details : {&room.details, &room.floor_details})
      for (PlanDetail& detail : *details) {
        moveLoop(detail.boundary);
        moveLoops(detail.holes);
        moveSlab(detail.slab);
      }
    for (PlanNiche& niche : room.niches) {
      moveLoop(niche.boundary);
      moveSlab(niche.bottom);
      moveSlab(niche.top);
    }
  }
  for (PlanStorey& storey : plan.storeys)
    lift(storey.floor, storey.ceiling);
  for (PlanOpening& opening : plan.openings) {
    move(opening.start);
    move(opening.end);
    lift(opening.bottom, opening.top);
  }
  for (PlanStair& stair : plan.stairs) {
    move(stair.at);
    lift(stair.bottom, stair.top);
    for (PlanFlight& flight : stair.flights) {
      lift(flight.bottom);
      for (PlanFlight::Riser& riser : flight.risers)
        std::for_each(riser.begin(), riser.end(), move);
    }
  }
  return plan;
}

} // namespace pcl::sedr
