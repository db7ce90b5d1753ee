// SPDX-License-Identifier: BSD-3-Clause
#include "scan_up.h"
#include "air_ends.h"
#include "unit_check.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Returns how likely an axis is vertical, nats. */
double
likelihoodOfAxis(const AirAlongAxis& air)
{
  constexpr double usual_height = 2.8; // metres
  constexpr double scale = 0.25;       // of the logarithm of heights
  constexpr double most = 2;           // nats: there are halls
  constexpr double rare = 0.02;        // share
  const auto logOdds = [](double share) {
    return std::log((share + rare) / (1 - share + rare));
  };
  return logOdds(air.low.large) + logOdds(air.high.large) - air.low.levels -
         air.high.levels -
         std::min(most, std::abs(std::log(air.height / usual_height)) / scale);
}

/** @brief Returns whether the air of a scan taken for one in feet is the likelier one,
 * as high as rooms, and not only what is left of it. */
bool
isInFeet(const AirAlongAxis& in_feet,
         const AirAlongAxis& in_metres,
         const Priors& priors)
{
  return in_feet.height > priors.min_home_height &&
         in_feet.area > priors.share_most * foot * foot * in_metres.area &&
         likelihoodOfAxis(in_feet) > likelihoodOfAxis(in_metres);
}

/** @brief Returns the log-likelihood of the high end of the air as ceiling and the low
 * one as floor, nats; that of the opposite is its negative. Weights fitted on
 * buildings, real and simulated. */
double
evidenceOfCeiling(const AirAlongAxis& air)
{
  constexpr double rare = 0.04;       // share of things
  constexpr double clear = 0.05;      // share of relief
  constexpr double most_pieces = 1.5; // nats
  const auto relief = [](const EndSurface& end) {
    return std::clamp((end.relief - (1 - end.large)) / clear, 0.0, 1.0);
  };
  return std::log((air.low.things + rare) / (air.high.things + rare)) +
         2 * (relief(air.high) - relief(air.low)) +
         2.2 * std::clamp(std::log(air.high.pieces / air.low.pieces), -most_pieces,
                          most_pieces);
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

std::string
nameOf(const Eigen::Vector3d& up, const Priors& priors)
{
  Eigen::Index axis = 0;
  if (up.cwiseAbs().maxCoeff(&axis) < std::cos(priors.same_axis))
    return formatText("the direction %.2f, %.2f, %.2f", up.x(), up.y(), up.z());
  return std::string(up[axis] < 0 ? "-" : "") + "xyz"[axis];
}

/** @brief A direction along an axis of the scan, or of its inclination. */
struct Direction {
  std::size_t axis = 2;
  int sign = 1;
  std::size_t rival = 2; ///< another axis than z that is about as likely; 2 for none
};

/** @brief What the scan shows along three axes. */
class AirAlongAxes {
public:
  AirAlongAxes(const PointView& points,
               const std::vector<int>& indices,
               const Eigen::Matrix3d& turn,
               unsigned threads)
  {
    parallelFor(3, 1, threads, [&](std::size_t axis) {
      Eigen::Matrix3d axes;
      for (std::size_t k = 0; k < 3; ++k)
        axes.row(static_cast<Eigen::Index>(k)) =
            turn.row(static_cast<Eigen::Index>((axis + 1 + k) % 3));
      air_[axis] = airAlong(points, indices, axes);
    });
  }

  /** @brief Returns the air along the likeliest axis. */
  const AirAlongAxis& likeliest() const
  {
    return *std::max_element(air_.begin(), air_.end(),
                             [](const auto& a, const auto& b) {
                               return likelihoodOfAxis(a) < likelihoodOfAxis(b);
                             });
  }

  /** @brief Returns which end of an axis is more likely up: 1 or -1. */
  int signOf(std::size_t axis) const
  {
    return evidenceOfCeiling(air_[axis]) < 0 ? -1 : 1;
  }

  /** @brief Returns how much more likely up than the other end that is, nats. */
  double signNats(std::size_t axis) const
  {
    return 2 * std::abs(evidenceOfCeiling(air_[axis]));
  }

  /** @brief Returns the direction that is by far the most likely, else z: first the
   * axis, then its end. While another axis may be up, its end is not certain. */
  Direction best(UpDoubt& doubt, double least_area) const
  {
    Direction best;
    std::array<double, 3> nats{}; // that an axis is more likely than z
    for (std::size_t axis = 0; axis < 2; ++axis) {
      nats[axis] = std::min(air_[axis].area, air_[2].area) < least_area
                       ? -std::numeric_limits<double>::infinity()
                       : likelihoodOfAxis(air_[axis]) - likelihoodOfAxis(air_[2]);
      if (nats[axis] > std::max(nats[best.axis], UpDoubt::doubtful))
        best.axis = axis;
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (axis != best.axis && nats[axis] > nats[best.axis] - UpDoubt::doubtful / 2)
        best.rival = axis;
    doubt.nats = nats[best.axis];
    if (best.axis != 2)
      best.sign = signOf(best.axis);
    else if (air_[2].area >= least_area && signOf(2) < 0) {
      doubt.nats =
          best.rival == 2 ? signNats(2) : std::min(signNats(2), UpDoubt::certain);
      best.sign = doubt.isDoubtful() ? -1 : 1;
    }
    return best;
  }

  /** @brief Returns a clause that another direction than z is up. */
  std::string clauseOf(const Direction& up,
                       const std::string& name,
                       const std::string& name_of_z) const
  {
    const AirAlongAxis& z = air_[2];
    if (up.axis == 2)
      return formatText(
          "the scan seems to be upside down: things cover %.0f %% of what are "
          "its floors then and %.0f %% of its ceilings, which are in %.0f and "
          "%.0f pieces",
          100 * z.high.things, 100 * z.low.things, z.high.pieces, z.low.pieces);
    const auto described = [](const AirAlongAxis& air) {
      return formatText(
          "the air is %.1f m high between surfaces at %.0f and %.0f heights",
          air.height, std::exp(air.low.levels), std::exp(air.high.levels));
    };
    return name + " seems to be up, not z: along it " + described(air_[up.axis]) +
           ", along " + name_of_z + " " + described(z);
  }

private:
  std::array<AirAlongAxis, 3> air_;
};

} // namespace

UpDoubt
doubtOfUp(const PointView& points,
          const std::vector<int>& indices,
          unsigned threads,
          const Priors& priors,
          bool unit_is_known)
{
  UpDoubt doubt;
  doubt.tilt = tiltOf(points, indices, threads, priors);
  const bool is_inclined = doubt.tilt.angle > UpDoubt::max_tilt;
  const Eigen::Vector3d z = is_inclined ? doubt.tilt.up : Eigen::Vector3d::UnitZ();
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(z, Eigen::Vector3d::UnitZ())
          .toRotationMatrix();
  AirAlongAxes air(points, indices, turn, threads);
  if (!unit_is_known && foot * air.likeliest().height > priors.min_home_height / 2) {
    const AirAlongAxes in_feet(points, indices, foot * turn, threads);
    doubt.is_in_feet = isInFeet(in_feet.likeliest(), air.likeliest(), priors);
    if (doubt.is_in_feet)
      air = in_feet;
  }
  const auto upOf = [&](std::size_t axis, int sign) -> Eigen::Vector3d {
    return sign * turn.row(static_cast<Eigen::Index>(axis));
  };
  const Direction best = air.best(doubt, 4 * priors.min_slab_area);
  const Eigen::Vector3d up = upOf(best.axis, best.sign);
  if (doubt.isDoubtful())
    doubt.reason = air.clauseOf(best, nameOf(up, priors), nameOf(z, priors));
  else if (is_inclined)
    doubt.reason = formatText(
        "the scan is inclined: its floors and ceilings, %.0f square metres of "
        "planes, stand at %.1f degrees to z, and its walls with them",
        doubt.tilt.area, doubt.tilt.angle * 180 / M_PI);
  else
    return doubt;
  doubt.reason +=
      "; turn it, for instance by pcl_transform_point_cloud IN OUT " + rotationFrom(up);
  if (best.axis != 2 && air.signNats(best.axis) < UpDoubt::doubtful)
    doubt.reason += formatText(" (or by %.5g if it is upside down then)",
                               std::acos(std::clamp(up.z(), -1.0, 1.0)) - M_PI);
  if (best.rival != 2) {
    const Eigen::Vector3d rival = upOf(best.rival, air.signOf(best.rival));
    doubt.reason += " (or, as likely, by " + rotationFrom(rival) + " if " +
                    nameOf(rival, priors) + " is up)";
  }
  doubt.reason += ", or say --z-up if it is right as it is";
  if (is_inclined)
    doubt.nats = std::numeric_limits<double>::infinity();
  return doubt;
}

} // namespace pcl::sedr
