// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/impl/mesh_reconstruction.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

struct RoomSamples;

/** @brief Parameters of a room's surface; see StructuralPoisson. */
struct RoomPoissonParameters {
  int depth = 9;        ///< maximum: cells are at least the room's extent / 2^depth
  unsigned threads = 1; ///< 0: all processors
};

/** @brief Report on the surface of a room. */
struct RoomPoissonReport {
  std::uint32_t room = 0;
  std::size_t points = 0;             ///< points used
  std::size_t skipped_points = 0;     ///< not finite, or without a normal
  std::size_t scaled_normals = 0;     ///< normals rescaled to unit length
  double spacing = 0;                 ///< of the points, metres
  int depth = 0;                      ///< 2^depth cells are as long as the room
  double cell = 0;                    ///< edge of the finest cells, metres
  std::size_t parted_vertices = 0;    ///< vertices moved off the position of another
  std::size_t removed_components = 0; ///< all but the largest
  std::size_t removed_triangles = 0;  ///< with these components
  MeshTopology topology;              ///< of the result
  bool closed = false;                ///< closed, manifold, oriented, one component
  double area = 0;                    ///< square metres
  double volume = 0;                  ///< cubic metres, above zero
  double unsupported_share = 0;       ///< share of the area far from all points
  std::string problem; ///< why there is no surface or why it is not closed, or empty
  std::string warning; ///< caveat of a surface that is closed, or empty
};

/** @brief The surface of a room, with room and label of every triangle, and its
 * report. */
struct RoomSurface {
  TriangleMesh mesh; ///< empty without a surface
  RoomPoissonReport report;
};

/** @brief How processes that have the same input share the rooms of a
 * StructuralPoisson. */
struct RoomSharing {
  /** @brief Returns whether this process makes the surface of the i-th room. */
  std::function<bool(std::size_t i)> is_mine;

  /** @brief Called once, with the surfaces of all rooms in order, those of the other
   * processes empty; to fill in these. */
  std::function<void(std::vector<RoomSurface>& rooms)> complete;
};

} // namespace sedr

/** @brief Screened Poisson reconstruction of rooms: one closed, manifold surface per
 * room (section 2.4 of the paper).
 *
 * Input are points of the structure with normals into the room, evenly spaced and
 * without large holes, as from StructureRefinement and VerticalHoleRepair; metres.
 * Rooms are distinguished by the points' field `room`; without it, all points are one
 * room. Points of room 0 are ignored if there is any other room.
 *
 * Each room is solved separately, near the origin, so that large coordinates lose no
 * precision. The cells are a fixed share of the points' spacing. Only the largest
 * component of the surface is kept. getReports() describes each room; getErrorMessage()
 * names the rooms with a problem. Rooms that failed are missing from the output. Rooms
 * with these problems are included: not closed, over 5 % of the surface far from all
 * points, or a third or more removed with other components.
 *
 * The equation is solved on cells along the surface. Edges stay sharp; the surface is
 * closed by construction.
 *
 * Normals of the output point into the room, like those of the input. If the points
 * have a `label`, each triangle of getMesh() gets that of the nearest point.
 *
 * The same input gives the same output, byte for byte, for any setNumberOfThreads().
 *
 * A null or empty cloud, indices out of range, too few points, missing normals or a
 * parameter out of range give an empty mesh and a reason. Points that are not finite or
 * have no normal are skipped and counted; normals of other lengths are rescaled. About
 * 0.4 s on one processor for a room of 6 m x 5 m x 3 m with points 5 cm apart. */
template <typename PointNT>
class StructuralPoisson : public sedr::MeshReconstruction<PointNT> {
public:
  using Ptr = pcl::shared_ptr<StructuralPoisson<PointNT>>;
  using ConstPtr = pcl::shared_ptr<const StructuralPoisson<PointNT>>;

  /** @brief Runs reconstruct() for getMesh() alone, without PCL's form of the mesh,
   * which is several times as large.
   * @return false if there is no surface */
  bool makeMesh() { return run(); }

  /** @brief Sets the maximum depth, 3 to 14 (default 9, as in the paper). The finest
   * cells are at least 1.1 times the room's extent / 2^depth. Sparse points lead to a
   * smaller depth; rooms too large for the maximum get coarser cells. */
  void setDepth(int depth) { parameters_.depth = depth; }
  int getDepth() const { return parameters_.depth; }

  /** @brief Sets the number of threads (default 1; 0: all processors). */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }
  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Sets what other processes do; both functions or none (default): this
   * object makes all rooms. */
  void setRoomSharing(const sedr::RoomSharing& sharing) { sharing_ = sharing; }

  /** @brief Returns the report of each room, ordered by room number. */
  const std::vector<sedr::RoomPoissonReport>& getReports() const { return reports_; }

  /** @brief Returns true if the last run made a closed, manifold surface with one
   * component for every room. */
  bool isClosed() const { return closed_; }

protected:
  using pcl::PCLBase<PointNT>::input_;
  using pcl::PCLBase<PointNT>::indices_;
  using pcl::PCLBase<PointNT>::initCompute;
  using pcl::PCLBase<PointNT>::deinitCompute;

  std::string getClassName() const override { return "StructuralPoisson"; }

  using sedr::MeshReconstruction<PointNT>::mesh_;
  using sedr::MeshReconstruction<PointNT>::fail;

  /** @brief Reconstructs into mesh_. */
  bool run() override;

private:
  std::string makeSurfaces();

  sedr::RoomPoissonParameters parameters_;
  sedr::RoomSharing sharing_;
  std::vector<sedr::RoomPoissonReport> reports_;
  bool closed_ = false;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_surface/impl/structural_poisson.hpp>
#endif
