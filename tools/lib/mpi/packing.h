// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_parts.h"

#include <pcl/sedr_surface/room_jobs.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/binary_object.hpp>
#include <boost/serialization/split_free.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <cstdint>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

// Serialisation of messages between ranks: member by member, long lists of numbers as
// in memory. All ranks must run the same build on machines of the same kind.

namespace pcl::sedr::tools {

/** @brief Serialises a list whose members consist only of numbers. */
template <typename Archive, typename T>
void
packNumbers(Archive& archive, std::vector<T>& list)
{
  std::uint64_t size = list.size();
  archive& size;
  list.resize(size);
  if (size > 0)
    archive& boost::serialization::make_binary_object(list.data(), size * sizeof(T));
}

template <typename T>
std::string
pack(const T& value)
{
  std::ostringstream stream;
  boost::archive::binary_oarchive archive(stream, boost::archive::no_header);
  archive << value;
  return stream.str();
}

template <typename T>
T
unpack(const std::string& bytes)
{
  std::istringstream stream(bytes);
  boost::archive::binary_iarchive archive(stream, boost::archive::no_header);
  T value;
  archive >> value;
  return value;
}

} // namespace pcl::sedr::tools

namespace boost::serialization {

template <typename Archive, typename Scalar, int rows>
void
serialize(Archive& archive, Eigen::Matrix<Scalar, rows, 1>& vector, unsigned)
{
  archive& make_array(vector.data(), static_cast<std::size_t>(rows));
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::tools::RowRange& range, unsigned)
{
  archive& range.path& range.begin& range.end& range.first;
}

// Floor plans.

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::PlanElement& element, unsigned)
{
  archive& element.start& element.end& element.centre& element.radius;
  archive& element.counter_clockwise& element.inliers& element.residual;
  archive& element.evidence.seen& element.evidence.hidden& element.evidence.opening;
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::PlanLoop& loop, unsigned)
{
  archive& loop.elements;
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::PlanSlab& slab, unsigned)
{
  archive& slab.plane& slab.inliers& slab.residual& slab.inferred;
  pcl::sedr::SlabCurve curve = slab.curve ? *slab.curve : pcl::sedr::SlabCurve();
  bool is_curved = slab.curve != nullptr;
  archive& is_curved;
  if (!is_curved)
    return;
  archive& curve.kind& curve.centre& curve.base& curve.axis;
  archive& curve.along& curve.across& curve.up;
  archive& curve.spacing& curve.columns& curve.heights;
  if (Archive::is_loading::value)
    slab.curve = std::make_shared<const pcl::sedr::SlabCurve>(std::move(curve));
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::PlanDetail& detail, unsigned)
{
  archive& detail.boundary& detail.holes& detail.slab& detail.is_facet;
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::PlanNiche& niche, unsigned)
{
  archive& niche.boundary& niche.bottom& niche.top;
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::PlanRoom& room, unsigned)
{
  archive& room.id& room.boundary& room.columns& room.floor& room.ceiling;
  archive& room.details& room.floor_details& room.niches;
}

// Jobs and results of rooms.

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::WallJob& job, unsigned)
{
  using pcl::sedr::tools::packNumbers;
  archive& job.room;
  packNumbers(archive, job.points);
  for (auto* indices : {&job.candidates, &job.ceiling, &job.floor, &job.details})
    packNumbers(archive, *indices);
  archive& job.boundary.neighbours& job.boundary.angle;
  archive& job.growing.distance& job.growing.slice_height;
  archive& job.growing.floor_height& job.growing.minimum_support;
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::FoundWalls& found, unsigned)
{
  pcl::sedr::tools::packNumbers(archive, found.walls);
  archive& found.problem;
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::RepairJob& job, unsigned)
{
  archive& job.plan& job.maximum_distance& job.grid_size;
  pcl::sedr::tools::packNumbers(archive, job.points);
  pcl::sedr::tools::packNumbers(archive, job.labels);
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::RepairedRoom& room, unsigned)
{
  pcl::sedr::tools::packNumbers(archive, room.points);
  pcl::sedr::tools::packNumbers(archive, room.labels);
  archive& room.refined& room.filled& room.problem;
  archive& room.unseen.surface& room.unseen.walls;
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::RoomSamples& samples, unsigned)
{
  archive& samples.room& samples.skipped& samples.scaled& samples.problem;
  pcl::sedr::tools::packNumbers(archive, samples.points);
  pcl::sedr::tools::packNumbers(archive, samples.labels);
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::RoomPoissonParameters& parameters, unsigned)
{
  static_assert(std::is_trivially_copyable<pcl::sedr::RoomPoissonParameters>::value,
                "goes as it stands");
  archive& make_binary_object(&parameters, sizeof parameters);
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::SurfaceJob& job, unsigned)
{
  archive& job.samples& job.parameters;
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::TriangleMesh& mesh, unsigned)
{
  pcl::sedr::tools::packNumbers(archive, mesh.vertices);
  pcl::sedr::tools::packNumbers(archive, mesh.triangles);
  for (auto* numbers : mesh.attributes())
    pcl::sedr::tools::packNumbers(archive, *numbers);
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::MeshTopology& topology, unsigned)
{
  archive& topology.vertices& topology.unused_vertices& topology.edges;
  archive& topology.triangles& topology.degenerate_triangles;
  archive& topology.zero_area_triangles& topology.duplicate_triangles;
  archive& topology.boundary_edges& topology.non_manifold_edges;
  archive& topology.inconsistent_edges& topology.non_manifold_vertices;
  archive& topology.euler_characteristic;
  pcl::sedr::tools::packNumbers(archive, topology.components);
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::RoomPoissonReport& report, unsigned)
{
  static_assert(std::is_trivially_copyable<pcl::sedr::ScreenedPoissonReport>::value,
                "goes as it stands");
  archive& report.room& report.points& report.skipped_points;
  archive& report.scaled_normals& report.spacing& report.depth& report.cell;
  archive& make_binary_object(&report.screened, sizeof report.screened);
  archive& report.parted_vertices& report.removed_components;
  archive& report.removed_triangles;
  archive& report.topology& report.closed& report.area& report.volume;
  archive& report.unsupported_share& report.problem& report.warning;
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::RoomSurface& surface, unsigned)
{
  archive& surface.mesh& surface.report;
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::LostRoom& lost, unsigned)
{
  archive& lost.reason;
}

/** @brief Serialises a variant: its index, then its value. */
template <typename Archive, typename... Kinds>
void
save(Archive& archive, const std::variant<Kinds...>& choice, unsigned)
{
  const std::uint64_t kind = choice.index();
  archive << kind;
  std::visit([&](const auto& one) { archive << one; }, choice);
}

template <typename Archive, typename... Kinds>
void
load(Archive& archive, std::variant<Kinds...>& choice, unsigned)
{
  std::uint64_t wanted = 0;
  archive >> wanted;
  std::uint64_t kind = 0;
  const auto loadAs = [&](auto one) {
    if (kind++ != wanted)
      return;
    archive >> one;
    choice = std::move(one);
  };
  (loadAs(Kinds()), ...);
}

template <typename Archive, typename... Kinds>
void
serialize(Archive& archive, std::variant<Kinds...>& choice, unsigned version)
{
  split_free(archive, choice, version);
}

} // namespace boost::serialization
