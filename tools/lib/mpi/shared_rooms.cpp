// SPDX-License-Identifier: BSD-3-Clause
#include "shared_rooms.h"

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/binary_object.hpp>
#include <boost/serialization/string.hpp>

#include <sstream>
#include <utility>
#include <vector>

namespace boost::serialization {

/** @brief Writes or reads a list of plain values, as they lie in memory. */
template <typename Archive, typename Value>
void
passList(Archive& archive, std::vector<Value>& list)
{
  std::uint64_t size = list.size();
  archive& size;
  list.resize(size);
  archive& make_binary_object(list.data(), size * sizeof(Value));
}

template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::RoomSurface& surface, unsigned)
{
  passList(archive, surface.mesh.vertices);
  passList(archive, surface.mesh.triangles);
  passList(archive, surface.mesh.labels);
  passList(archive, surface.mesh.rooms);
  passList(archive, surface.mesh.elements);
  pcl::sedr::RoomPoissonReport& r = surface.report;
  archive& r.room& r.points& r.skipped_points& r.scaled_normals& r.spacing& r.depth;
  archive& r.cell& r.parted_vertices& r.removed_components& r.removed_triangles;
  archive& r.closed& r.area& r.volume& r.unsupported_share& r.problem& r.warning;
  pcl::sedr::MeshTopology& t = r.topology;
  archive& t.vertices& t.edges& t.triangles& t.degenerate_triangles;
  archive& t.duplicate_triangles& t.boundary_edges;
  archive& t.non_manifold_edges& t.inconsistent_edges& t.non_manifold_vertices;
  archive& t.euler_characteristic;
  passList(archive, t.components);
}

} // namespace boost::serialization

namespace pcl::sedr::tools {

RoomSharing
sharedRooms(const Ranks& ranks)
{
  const auto ownerOf = [ranks](std::size_t i) {
    return static_cast<int>(i % static_cast<std::size_t>(ranks.size()));
  };
  RoomSharing sharing;
  sharing.is_mine = [ranks, ownerOf](std::size_t i) {
    return ownerOf(i) == ranks.rank();
  };
  sharing.complete = [ranks, ownerOf](std::vector<RoomSurface>& rooms) {
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      const int owner = ownerOf(i);
      if (owner == 0 || (ranks.rank() > 0 && owner != ranks.rank()))
        continue;
      if (ranks.rank() > 0) {
        std::ostringstream stream;
        boost::archive::binary_oarchive archive(stream, boost::archive::no_header);
        archive << std::as_const(rooms[i]);
        std::string bytes = stream.str();
        sendList(ranks, 0, bytes);
        continue;
      }
      std::istringstream stream(receiveList<std::string>(ranks, owner));
      boost::archive::binary_iarchive archive(stream, boost::archive::no_header);
      archive >> rooms[i];
    }
  };
  return sharing;
}

} // namespace pcl::sedr::tools
