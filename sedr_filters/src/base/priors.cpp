// SPDX-License-Identifier: BSD-3-Clause
#include "number_text.h"

#include <pcl/sedr_filters/priors.h>

#include <algorithm>

namespace pcl::sedr {

namespace {

// Group, unit, range and source; a test compares the page with these.
const std::vector<Prior> table = {
    {"min_headroom", &Priors::min_headroom, "rooms", "m", 1.2, 3,
     "building codes ask 2.0 to 2.4 m; less for cellars and attics"},
    {"max_building_height", &Priors::max_building_height, "rooms", "m", 10, 2000,
     "building practice"},
    {"max_building_extent", &Priors::max_building_extent, "rooms", "m", 100, 100000,
     "building practice"},
    {"min_home_height", &Priors::min_home_height, "rooms", "m", 1.8, 3,
     "7 ft, the least that the International Residential Code allows"},
    {"max_home_height", &Priors::max_home_height, "rooms", "m", 2.5, 6,
     "12 ft, building practice"},
    {"max_home_area", &Priors::max_home_area, "rooms", "m2", 5, 200,
     "540 square feet, building practice"},
    {"max_door_height", &Priors::max_door_height, "rooms", "m", 1.8, 6,
     "8.5 ft, building practice"},
    {"min_wall", &Priors::min_wall, "walls", "m", 0.005, 0.2,
     "plates of glass and board, with their noise"},
    {"max_wall", &Priors::max_wall, "walls", "m", 0.1, 3,
     "walls of stone with facing; castles have more"},
    {"max_niche_depth", &Priors::max_niche_depth, "walls", "m", 0.2, 3,
     "building practice"},
    {"max_door_width", &Priors::max_door_width, "walls", "m", 0.6, 4, "double doors"},
    {"assumed_partition", &Priors::assumed_partition, "walls", "m", 0.001, 0.2,
     "two faces must not touch"},
    {"max_slab_tilt", &Priors::max_slab_tilt, "slabs", "degrees", 0, 45,
     "falls of floors and ceilings, up to 5 %"},
    {"min_ceiling_step", &Priors::min_ceiling_step, "slabs", "m", 0.005, 0.3,
     "chosen on the proving ground"},
    {"max_platform_height", &Priors::max_platform_height, "slabs", "m", 0.1, 1.5,
     "stages; tables are higher"},
    {"max_step_height", &Priors::max_step_height, "slabs", "m", 0.1, 0.6,
     "two steps of stairs"},
    {"min_platform_area", &Priors::min_platform_area, "slabs", "m2", 0.1, 20,
     "larger than a bed's half"},
    {"max_soffit_reach", &Priors::max_soffit_reach, "slabs", "m", 0.5, 50,
     "building practice"},
    {"min_floor_step", &Priors::min_floor_step, "slabs", "m", 0.01, 0.3,
     "rugs on floors, panels on ceilings"},
    {"min_slab_area", &Priors::min_slab_area, "slabs", "m2", 0.1, 20,
     "lamps and panels are smaller"},
    {"max_furniture_depth", &Priors::max_furniture_depth, "furniture", "m", 0.2, 3,
     "wardrobes with what stands before them"},
    {"max_furniture_area", &Priors::max_furniture_area, "furniture", "m2", 1, 20,
     "two beds side by side"},
    {"unevenness", &Priors::unevenness, "scanner", "m", 0.0001, 0.02,
     "chosen on the proving ground"},
    {"slab_noise", &Priors::slab_noise, "scanner", "m", 0.001, 0.1,
     "chosen on the proving ground"},
    {"min_tilt", &Priors::min_tilt, "scanner", "degrees", 0.05, 5,
     "chosen on tilted scenes of the simulator"},
};

std::string
rangeProblem(const Prior& prior, double value)
{
  if (value >= prior.low && value <= prior.high)
    return {};
  return formatText("the prior %s must be from %g to %g%s%s, not %g", prior.name,
                    prior.low, prior.high, *prior.unit ? " " : "", prior.unit, value);
}

} // namespace

const std::vector<Prior>&
priorTable()
{
  return table;
}

std::string
setPrior(const std::string& name, double value, Priors& priors)
{
  const auto prior = std::find_if(table.begin(), table.end(),
                                  [&](const Prior& one) { return one.name == name; });
  if (prior == table.end())
    return "there is no prior " + name;
  std::string problem = rangeProblem(*prior, value);
  if (problem.empty())
    priors.*prior->member = value;
  return problem;
}

std::string
problemOf(const Priors& priors)
{
  for (const Prior& prior : table)
    if (std::string problem = rangeProblem(prior, priors.*prior.member);
        !problem.empty())
      return problem;
  return {};
}

} // namespace pcl::sedr
