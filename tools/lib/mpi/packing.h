// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_parts.h"

#include <pcl/sedr_surface/room_jobs.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/fusion/include/adapt_struct.hpp>
#include <boost/fusion/include/for_each.hpp>
#include <boost/fusion/include/is_sequence.hpp>
#include <boost/serialization/binary_object.hpp>
#include <boost/serialization/split_free.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <cstdint>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

// Serialisation of messages between ranks: member by member, numbers as they lie in
// memory. All ranks must run the same build on machines of the same kind.

BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::tools::RowRange, path, begin, end, first)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::PlanElement,
                          start,
                          end,
                          centre,
                          radius,
                          counter_clockwise,
                          inliers,
                          residual,
                          evidence)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::PlanLoop, elements)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::SlabCurve,
                          kind,
                          centre,
                          base,
                          axis,
                          along,
                          across,
                          up,
                          spacing,
                          columns,
                          heights)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::PlanDetail, boundary, holes, slab, is_facet)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::PlanNiche, boundary, bottom, top)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::PlanRoom,
                          id,
                          boundary,
                          columns,
                          floor,
                          ceiling,
                          details,
                          floor_details,
                          niches)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::WallJob,
                          room,
                          points,
                          candidates,
                          ceiling,
                          floor,
                          details,
                          boundary,
                          growing)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::FoundWalls, walls, problem)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::RepairJob,
                          plan,
                          points,
                          labels,
                          maximum_distance,
                          grid_size)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::RepairedRoom,
                          points,
                          labels,
                          refined,
                          filled,
                          unseen,
                          problem)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::RoomSamples,
                          room,
                          points,
                          labels,
                          skipped,
                          scaled,
                          problem)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::SurfaceJob, samples, parameters)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::TriangleMesh,
                          vertices,
                          triangles,
                          labels,
                          rooms,
                          elements)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::MeshTopology,
                          vertices,
                          unused_vertices,
                          edges,
                          triangles,
                          degenerate_triangles,
                          zero_area_triangles,
                          duplicate_triangles,
                          boundary_edges,
                          non_manifold_edges,
                          inconsistent_edges,
                          non_manifold_vertices,
                          euler_characteristic,
                          components)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::RoomPoissonReport,
                          room,
                          points,
                          skipped_points,
                          scaled_normals,
                          spacing,
                          depth,
                          cell,
                          screened,
                          parted_vertices,
                          removed_components,
                          removed_triangles,
                          topology,
                          closed,
                          area,
                          volume,
                          unsupported_share,
                          problem,
                          warning)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::RoomSurface, mesh, report)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::LostRoom, reason)

namespace pcl::sedr::tools {

/** @brief Whether a type consists only of numbers, so that its bytes are its value. */
template <typename T>
constexpr bool is_flat = std::is_trivially_copyable<T>::value;
template <typename Scalar, int rows, int columns>
constexpr bool is_flat<Eigen::Matrix<Scalar, rows, columns>> = rows* columns > 0;
template <>
inline constexpr bool is_flat<OrientedPoint> = true;

template <typename Archive, typename T>
void
packMember(Archive& archive, T& member)
{
  if constexpr (is_flat<T>)
    archive& boost::serialization::make_binary_object(&member, sizeof member);
  else
    archive& member;
}

template <typename Archive, typename T>
void
packMember(Archive& archive, std::vector<T>& list)
{
  if constexpr (is_flat<T>) {
    std::uint64_t size = list.size();
    archive& size;
    list.resize(size);
    if (size > 0)
      archive& boost::serialization::make_binary_object(list.data(), size * sizeof(T));
  }
  else
    archive& list;
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

/** @brief Serialises a struct member by member. */
template <typename Archive, typename T>
std::enable_if_t<boost::fusion::traits::is_sequence<T>::value>
serialize(Archive& archive, T& value, version_type)
{
  boost::fusion::for_each(
      value, [&](auto& member) { pcl::sedr::tools::packMember(archive, member); });
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::PlanSlab& slab, unsigned)
{
  using pcl::sedr::tools::packMember;
  packMember(archive, slab.plane);
  archive& slab.inliers& slab.residual& slab.inferred;
  pcl::sedr::SlabCurve curve = slab.curve ? *slab.curve : pcl::sedr::SlabCurve();
  bool is_curved = slab.curve != nullptr;
  archive& is_curved;
  if (!is_curved)
    return;
  archive& curve;
  if (Archive::is_loading::value)
    slab.curve = std::make_shared<const pcl::sedr::SlabCurve>(std::move(curve));
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
