// SPDX-License-Identifier: BSD-3-Clause
#include "scan_up.h"
#include "air_ends.h"
#include "scan_check.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel.h"

#include <pcl/sedr_segmentation/building.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Returns how likely an axis is vertical, nats.
 * @param share of the air that certainly exists, seen along it */
double
likelihoodOfAxis(const AirAlongAxis& air, double share, const Priors& priors)
{
  constexpr double usual_height = 2.8; // metres
  constexpr double scale = 0.3;        // of the logarithm of heights
  constexpr double most = 2;           // nats: there are halls
  constexpr double rare = 0.02;        // share
  const auto logOdds = [](double part) {
    return std::log((part + rare) / (1 - part + rare));
  };
  return logOdds(air.low.large) + logOdds(air.high.large) - air.low.levels -
         air.high.levels + std::log(share) -
         (air.height > usual_height
              ? std::min(most, std::log(air.height / usual_height) / scale)
              : costOfHeight(air.height, priors));
}

/** @brief Returns the log-odds of the high end of the air as ceiling and the low one as
 * floor, nats. Weights are four fifths of those of a logistic regression on 390
 * buildings and rooms, 11 of them real, the others simulated, two thirds of these with
 * odd things, and on noisy, thinned and cut variants of them: real ceilings vary more.
 */
double
evidenceOfCeiling(const AirAlongAxis& air)
{
  constexpr double few = 0.4;    // things, bars
  constexpr double small = 0.04; // share of relief
  const auto relief = [](const EndSurface& end) {
    return std::clamp((end.relief - (1 - end.large)) / small, 0.0, 1.0);
  };
  return 1.6 * std::log((air.low.things + few) / (air.high.things + few)) +
         2.0 * std::log((air.high.bars + few) / (air.low.bars + few)) +
         2.2 * (relief(air.high) - relief(air.low));
}

/** @brief Returns the argument of pcl_transform_point_cloud that turns a direction to
 * z: axis and angle. */
std::string
rotationFrom(const Eigen::Vector3d& up)
{
  Eigen::Vector3d axis = up.cross(Eigen::Vector3d::UnitZ());
  axis = axis.norm() > 0.01 ? axis.normalized() : Eigen::Vector3d::UnitX().eval();
  const auto rounded = [](double v) { return std::round(v * 1e5) / 1e5 + 0.0; };
  return formatText("-axisangle %.5g,%.5g,%.5g,%.5g", rounded(axis.x()),
                    rounded(axis.y()), rounded(axis.z()),
                    std::acos(std::clamp(up.z(), -1.0, 1.0)));
}

bool
isAlongAxis(const Eigen::Vector3d& direction, const Priors& priors)
{
  return direction.cwiseAbs().maxCoeff() >= std::cos(priors.same_axis);
}

std::string
nameOf(const Eigen::Vector3d& up, const Priors& priors)
{
  Eigen::Index axis = 0;
  up.cwiseAbs().maxCoeff(&axis);
  if (!isAlongAxis(up, priors))
    return formatText("the direction %.2f, %.2f, %.2f", up.x(), up.y(), up.z());
  return std::string(up[axis] < 0 ? "-" : "") + "xyz"[axis];
}

/** @brief Returns how a direction becomes z. */
std::string
wayOf(const Eigen::Vector3d& up, const Priors& priors)
{
  return isAlongAxis(up, priors)
             ? "say --up " + nameOf(up, priors)
             : "turn it, for instance by pcl_transform_point_cloud IN OUT " +
                   rotationFrom(up);
}

/** @brief A direction along an axis of the scan, or of its inclination, in a unit. */
struct Direction {
  std::size_t axis = 2;
  int sign = 1;
  bool is_in_feet = false;
  double nats = -std::numeric_limits<double>::infinity(); ///< log-likelihood

  bool operator<(const Direction& other) const { return nats < other.nats; }
};

/** @brief What the scan shows along three axes, in metres and, if that may be the unit,
 * in feet. */
class AirAlongAxes {
public:
  AirAlongAxes(const PointView& points,
               const std::vector<int>& indices,
               const std::vector<Eigen::Vector3d>& stations,
               const Eigen::Matrix3d& turn,
               const Eigen::Matrix3d& to_building,
               bool may_be_in_feet,
               const Priors& priors,
               unsigned threads)
  {
    parallelFor(may_be_in_feet ? 6 : 3, 1, threads, [&](std::size_t i) {
      Eigen::Matrix3d axes;
      for (std::size_t k = 0; k < 3; ++k)
        axes.row(static_cast<Eigen::Index>(k)) =
            (i < 3 ? 1 : foot) *
            (i % 3 == 2 ? to_building : turn)
                .row(static_cast<Eigen::Index>((i % 3 + 1 + k) % 3));
      air_[i / 3][i % 3] = airAlong(points, indices, axes, stations, priors);
    });
  }

  /** @brief Returns the likelier of some ends of an axis, in the likelier unit; none if
   * there is little air along it. */
  Direction along(std::size_t axis,
                  std::initializer_list<int> signs,
                  const Priors& priors,
                  std::initializer_list<bool> units = {false, true}) const
  {
    Direction best;
    best.axis = axis;
    for (const bool in_feet : units) {
      const AirAlongAxis& air = air_[in_feet ? 1 : 0][axis];
      if (air.area < 4 * priors.min_slab_area)
        continue;
      const double unit = in_feet ? foot * foot : 1;
      // Prior odds: metres 3 to feet 1; z 2 to x 1 to y 1; both ends alike.
      const double rarity = (in_feet ? 3 : 1) * (axis == 2 ? 1 : 2);
      const double share = air.area / unit / mostAir() / priors.share_most;
      const double nats =
          likelihoodOfAxis(air, std::min(1.0, share), priors) - std::log(rarity);
      const double ceiling = evidenceOfCeiling(air);
      for (const int sign : signs)
        best = std::max(best, {axis, sign, in_feet,
                               nats - std::log1p(std::exp(-sign * ceiling)) +
                                   (sign > 0 ? air.low : air.high).stations});
    }
    return best;
  }

  /** @brief Returns how much more likely a direction is up than its opposite, nats. */
  double signNats(const Direction& up) const
  {
    const AirAlongAxis& air = air_[up.is_in_feet ? 1 : 0][up.axis];
    return up.sign * (evidenceOfCeiling(air) + air.low.stations - air.high.stations);
  }

  /** @brief Returns a clause that another direction than z is up. */
  std::string clauseOf(const Direction& up,
                       const std::string& name,
                       const std::string& name_of_z) const
  {
    const AirAlongAxis& air_along_up = air_[up.is_in_feet ? 1 : 0][up.axis];
    const AirAlongAxis& z = air_[up.is_in_feet ? 1 : 0][2];
    if (up.axis == 2)
      return formatText(
          "the scan seems to be upside down: on what are its floors then %.0f things "
          "stand free, as furniture does, on its ceilings %.0f; %.0f and %.0f reach "
          "from wall to wall, as beams and lintels do; %.0f %% and %.0f %% slope or "
          "have ribs",
          z.high.things, z.low.things, z.high.bars, z.low.bars, 100 * z.high.relief,
          100 * z.low.relief);
    const auto described = [](const AirAlongAxis& air) {
      return formatText(
          "the air is %.1f m high between surfaces at %.0f and %.0f heights",
          air.height, std::exp(air.low.levels), std::exp(air.high.levels));
    };
    return name + " seems to be up, not z: along it " + described(air_along_up) +
           ", along " + name_of_z + " " + described(z);
  }

  /** @brief Returns how much more likely feet are than metres, whatever is up, nats; 0
   * if only one of both has air. */
  double natsOfFeet(const Priors& priors) const
  {
    std::array<double, 2> most{};
    for (const bool in_feet : {false, true}) {
      most[in_feet] = -std::numeric_limits<double>::infinity();
      for (std::size_t axis = 0; axis < 3; ++axis)
        most[in_feet] =
            std::max(most[in_feet], along(axis, {1, -1}, priors, {in_feet}).nats);
    }
    const double nats = most[1] - most[0];
    return std::isfinite(nats) ? nats : 0;
  }

  /** @brief Returns a clause that the unit seems to be the foot. */
  std::string clauseOfUnit(const Direction& up) const
  {
    const AirAlongAxis& air = air_[1][up.axis];
    return formatText("between floors and ceilings are %.1f m in metres, %.1f m in "
                      "feet, which is far likelier: ",
                      air.height / foot, air.height);
  }

private:
  /** @brief Returns the largest area of air along an axis, in the unit of the scan. */
  double mostAir() const
  {
    double most = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      most = std::max({most, air_[0][axis].area, air_[1][axis].area / (foot * foot)});
    return most;
  }

  std::array<std::array<AirAlongAxis, 3>, 2> air_; ///< in metres, in feet
};

} // namespace

UpDoubt
doubtOfUp(const PointView& points,
          const std::vector<int>& indices,
          const std::vector<Eigen::Vector3d>& stations,
          unsigned threads,
          const Priors& priors,
          const KnownOfScan& known)
{
  UpDoubt doubt;
  doubt.tilt = tiltOf(points, indices, threads, priors);
  const Eigen::Vector3d z =
      doubt.isInclined() ? doubt.tilt.up : Eigen::Vector3d::UnitZ();
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(z, Eigen::Vector3d::UnitZ())
          .toRotationMatrix();
  // In the frame of the building the answer does not depend on how the scan lies.
  const Eigen::Matrix3d to_building =
      findBuildingFrame(points, indices, threads, turn).rotation;
  const AirAlongAxes air(points, indices, stations, turn, to_building, !known.unit,
                         priors, threads);
  const auto upOf = [&](const Direction& up) -> Eigen::Vector3d {
    return up.sign * turn.row(static_cast<Eigen::Index>(up.axis));
  };
  std::array<Direction, 3> ends; // the likelier ones
  for (std::size_t axis = 0; axis < 3; ++axis)
    ends[axis] = air.along(axis, {1, -1}, priors);
  const Direction upright = air.along(2, {1}, priors);
  std::stable_sort(ends.rbegin(), ends.rend());
  Direction best = ends[0];
  if (std::isfinite(upright.nats) && !known.up)
    doubt.nats = best.nats - upright.nats;
  if (!doubt.isDoubtful())
    best = upright;
  doubt.is_in_feet = best.is_in_feet;
  doubt.feet_nats = air.natsOfFeet(priors);
  doubt.unit_reason = air.clauseOfUnit(best) + if_in_feet;
  const Eigen::Vector3d up = upOf(best);
  if (doubt.isDoubtful())
    doubt.reason = air.clauseOf(best, nameOf(up, priors), nameOf(z, priors)) + "; " +
                   wayOf(up, priors);
  else if (doubt.isInclined())
    doubt.reason = formatText(
        "the scan is inclined: its floors and ceilings, %.0f square metres of "
        "planes, stand at %.1f degrees to z, and its walls with them; %s",
        doubt.tilt.area, doubt.tilt.angle * 180 / M_PI, wayOf(up, priors).c_str());
  else
    return doubt;
  if (best.axis != 2 && air.signNats(best) < UpDoubt::doubtful)
    doubt.reason += " (or " + wayOf(-up, priors) + ", if it is upside down then)";
  for (const Direction& rival : ends)
    if (doubt.isDoubtful() && rival.axis != best.axis && rival.axis != 2 &&
        rival.nats > best.nats - UpDoubt::doubtful)
      doubt.reason += " (or, about as likely, " + wayOf(upOf(rival), priors) + ")";
  if (best.is_in_feet)
    doubt.reason += formatText(", and --unit %g, as it seems to be in feet", foot);
  doubt.reason += doubt.isInclined() ? ", or say --z-up if it is right as it is"
                                     : ", or say --up z if it is right as it is";
  if (doubt.isInclined())
    doubt.nats = std::numeric_limits<double>::infinity();
  return doubt;
}

} // namespace pcl::sedr
