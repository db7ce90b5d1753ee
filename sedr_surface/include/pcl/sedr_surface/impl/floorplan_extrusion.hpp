// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>

namespace pcl {
namespace sedr {

/** @brief Result of a run of FloorplanExtrusion. */
struct PlanSolids {
  TriangleMesh& mesh;
  std::vector<SolidElement>& elements;
  std::vector<RoomSolidReport>& reports;
  std::vector<PlanWarning>& warnings;
};

/** @brief Builds all rooms of a plan.
 * @param plan null if none was set
 * @return a sentence on invalid input or rooms that could not be built; empty
 * otherwise */
std::string extrudePlan(const Floorplan* plan,
                        const SolidParameters& parameters,
                        PlanSolids solids);

} // namespace sedr

template <typename PointT>
bool
FloorplanExtrusion<PointT>::run()
{
  this->clearError();
  mesh_ = sedr::TriangleMesh();
  elements_.clear();
  reports_.clear();
  warnings_.clear();
  const std::string problem = sedr::extrudePlan(
      plan_.get(), parameters_, {mesh_, elements_, reports_, warnings_});
  closed_ = problem.empty();
  return closed_ || fail("FloorplanExtrusion", problem);
}

} // namespace pcl

#define PCL_INSTANTIATE_FloorplanExtrusion(T)                                          \
  template class PCL_EXPORTS pcl::FloorplanExtrusion<T>;
