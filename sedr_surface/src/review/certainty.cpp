// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/quantiles.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_surface/plan_review.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Log-odds of being right. */
struct Weights {
  std::array<double, 3> within;                         ///< without signs
  std::vector<std::pair<const char*, double>> of_signs; ///< by name
};

constexpr double usual_width = 0.8; // metres; narrower openings are less likely
const double max_wall = Priors().max_wall;

/** @brief What test/benchmarks/certainty_grades.py fits; the only place for it. */
const Weights&
wallWeights()
{
  static const Weights weights{{-2.21, -1.77, -1.70},
                               {{"log_length", 0.60},
                                {"measured", 2.14},
                                {"placed", 2.01},
                                {"log_error", -1.14},
                                {"two_faces", 0.94},
                                {"off", -0.73}}};
  return weights;
}

const Weights&
openingWeights()
{
  static const Weights weights{{0.22, 1.58, 2.44},
                               {{"log_confidence", 0.06},
                                {"log_error", -1.89},
                                {"error_above", 0.49},
                                {"two_faces", 0.52},
                                {"unknown_kind", -3.30},
                                {"passage", -0.42},
                                {"closed", -1.52},
                                {"narrow", 2.34}}};
  return weights;
}

std::vector<std::string>
namesOf(const Weights& weights)
{
  std::vector<std::string> names;
  for (const auto& sign : weights.of_signs)
    names.emplace_back(sign.first);
  return names;
}

/** @param error standard error of its place, metres; 0: not known */
Certainty
certaintyBy(const Weights& weights, Certainty certainty, double error = 0)
{
  double odds = 0;
  for (std::size_t k = 0; k < weights.of_signs.size(); ++k)
    odds += weights.of_signs[k].second * certainty.signs[k];
  for (std::size_t k = 0; k < weights.within.size(); ++k)
    certainty.within[k] =
        (error > 0 ? std::erf(certainty_steps[k] / (error * std::sqrt(2))) : 1) /
        (1 + std::exp(-odds - weights.within[k]));
  return certainty;
}

/** @brief Returns the median of the errors that are known, metres. */
double
usualError(std::vector<double> errors)
{
  errors.erase(std::remove(errors.begin(), errors.end(), 0.0), errors.end());
  return errors.empty() ? 0 : middleValue(errors);
}

/** @brief Returns the logarithm of an error that is known as a multiple of the usual
 * one, so that the noise of a scan cancels out. */
double
logError(double error, double usual)
{
  return std::log(error / usual);
}

} // namespace

std::vector<std::string>
wallSigns()
{
  return namesOf(wallWeights());
}

std::vector<std::string>
openingSigns()
{
  return namesOf(openingWeights());
}

std::vector<Certainty>
certaintyOfWalls(const Floorplan& plan, const std::vector<PlanWarning>& warnings)
{
  std::map<std::pair<std::uint32_t, std::size_t>, double> off; // square metres
  for (const PlanWarning& warning : warnings)
    if (warning.kind == WarningKind::WallOff)
      off[{warning.room, warning.wall}] +=
          warning.values.empty() ? 0 : warning.values[0];
  std::vector<double> errors;
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& wall : room.boundary.elements)
      errors.push_back(wall.accuracy.standard_error);
  const double usual = usualError(std::move(errors));
  const auto thicknesses = wallThicknesses(plan, max_wall);
  std::vector<Certainty> walls;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    for (std::size_t e = 0; e < plan.rooms[r].boundary.elements.size(); ++e) {
      const PlanRoom& room = plan.rooms[r];
      const WallShares shares = wallShares(plan, room, e);
      if (!(shares.area > 0))
        continue;
      const PlanElement& wall = room.boundary.elements[e];
      const Eigen::Vector2d middle = wall.pointAt(wall.length() / 2);
      const double error = wall.accuracy.standard_error;
      walls.push_back(
          certaintyBy(wallWeights(),
                      {std::to_string(room.id) + "." + std::to_string(e + 1),
                       room.id,
                       e,
                       wall.length() * (room.ceilingAt(middle) - room.floorAt(middle)),
                       {std::log(std::max(wall.length(), 0.01)), shares.measured,
                        error > 0 ? 1.0 : 0.0, error > 0 ? logError(error, usual) : 0,
                        thicknesses[r][e] > 0 ? 1.0 : 0.0,
                        std::min(off[{room.id, e + 1}] / shares.area, 1.0)}},
                      error));
    }
  return walls;
}

std::vector<Certainty>
certaintyOfOpenings(const Floorplan& plan)
{
  std::vector<double> errors;
  for (const PlanOpening& opening : plan.openings)
    errors.push_back(opening.residual);
  const double usual = usualError(std::move(errors));
  std::vector<Certainty> openings;
  for (std::size_t k = 0; k < plan.openings.size(); ++k) {
    const PlanOpening& opening = plan.openings[k];
    const double sure = std::clamp(opening.confidence, 0.01, 0.999);
    const double error = logError(std::max(opening.residual, 1e-9), usual);
    if (opening.residual > 0 && opening.confidence > 0)
      openings.push_back(
          certaintyBy(openingWeights(),
                      {markOf(opening),
                       std::max(opening.rooms[0], opening.rooms[1]),
                       k,
                       opening.width() * opening.height(),
                       {std::log(sure / (1 - sure)), error, std::max(error, 0.0),
                        opening.walls.size() > 1 ? 1.0 : 0.0,
                        opening.kind == OpeningKind::Unknown ? 1.0 : 0.0,
                        opening.kind == OpeningKind::Passage ? 1.0 : 0.0,
                        opening.state == OpeningState::Closed ? 1.0 : 0.0,
                        std::min(std::log(opening.width() / usual_width), 0.0)}}));
  }
  return openings;
}

} // namespace pcl::sedr
