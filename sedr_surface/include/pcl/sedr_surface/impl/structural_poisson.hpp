// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>
#include <pcl/sedr_surface/impl/room_samples.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <cmath>

namespace pcl {
namespace sedr {

/** @brief Returns which parameter is out of range, a sentence; empty if none is. */
std::string problemOf(const RoomPoissonParameters& parameters);

/** @brief Appends the surfaces of rooms and their reports; consumes their samples. */
void makeSurfaces(std::map<std::uint32_t, RoomSamples>& rooms,
                  const RoomPoissonParameters& parameters,
                  const RoomSharing& sharing,
                  TriangleMesh& mesh,
                  std::vector<RoomPoissonReport>& reports);

/** @brief Returns a warning about points left out and rooms without a closed surface,
 * with reasons; empty if all are closed. */
std::string summaryOf(const std::vector<RoomPoissonReport>& reports);

} // namespace sedr

template <typename PointNT>
bool
StructuralPoisson<PointNT>::run()
{
  this->clearError();
  reports_.clear();
  mesh_ = sedr::TriangleMesh();
  closed_ = false;
  std::string problem = sedr::problemOf(parameters_);
  if (problem.empty())
    problem = makeSurfaces();
  if (!problem.empty())
    return fail("StructuralPoisson", problem);
  problem = sedr::summaryOf(reports_);
  if (!problem.empty())
    fail("StructuralPoisson", problem);
  closed_ = true;
  for (const sedr::RoomPoissonReport& report : reports_)
    closed_ = closed_ && report.closed;
  return !mesh_.empty();
}

/** @brief Makes the surfaces of the points' rooms.
 * @return why there is none, a sentence; empty otherwise */
template <typename PointNT>
std::string
StructuralPoisson<PointNT>::makeSurfaces()
{
  if (!input_)
    return "no input cloud is set";
  if (input_->empty())
    return "the input cloud is empty";
  if (!initCompute())
    return "PCL refuses the input cloud and its indices";
  std::string problem = sedr::indicesProblem(*indices_, input_->size());
  if (problem.empty() && indices_->empty())
    problem =
        "no indices are selected of " + std::to_string(input_->size()) + " points";
  if constexpr (!pcl::traits::has_normal<PointNT>::value) {
    if (problem.empty())
      problem = "the type of the points has no normals";
  }
  else if (problem.empty()) {
    std::map<std::uint32_t, sedr::RoomSamples> rooms;
    for (const auto index : *indices_) {
      const PointNT& point = (*input_)[index];
      std::uint32_t number = 0;
      if constexpr (pcl::traits::has_field<PointNT, pcl::fields::room>::value)
        number = point.room;
      sedr::RoomSamples& room = rooms[number];
      room.room = number;
      const Eigen::Vector3f normal = point.getNormalVector3fMap();
      const float length = normal.norm();
      if (!pcl::isXYZFinite(point) || !std::isfinite(length) || length < 1e-6f) {
        ++room.skipped;
        continue;
      }
      room.scaled += std::abs(length - 1) > 1e-3f;
      room.points.push_back({point.getVector3fMap(), normal / length});
      if constexpr (pcl::traits::has_field<PointNT, pcl::fields::label>::value)
        room.labels.push_back(point.label);
    }
    if (rooms.size() > 1)
      rooms.erase(0); // points outside all rooms
    sedr::makeSurfaces(rooms, parameters_, sharing_, mesh_, reports_);
  }
  deinitCompute();
  return problem;
}

} // namespace pcl

#define PCL_INSTANTIATE_StructuralPoisson(T)                                           \
  template class PCL_EXPORTS pcl::StructuralPoisson<T>;
