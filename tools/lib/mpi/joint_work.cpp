// SPDX-License-Identifier: BSD-3-Clause
#include "joint_work.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/voxels/voxel_sums.h"
#include "sedr_segmentation/src/adjust/plan_adjustment.h"
#include "sedr_segmentation/src/scan/scan_check.h"
#include "sedr_segmentation/src/scan/scan_excerpt.h"
#include "tool_error.h"

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/mpi/collectives/all_gather.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/binary_object.hpp>
#include <boost/serialization/string.hpp>

#include <exception>
#include <sstream>
#include <unistd.h>
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

namespace {

using Excerpt = std::vector<Eigen::Vector3f>;

PointView
viewOf(const Excerpt& points)
{
  return {points.data(), sizeof(Eigen::Vector3f), points.size()};
}

/** @brief The rows of one rank. */
class PartOfScan {
public:
  PartOfScan(const Ranks& ranks, const JointScan& scan, unsigned threads)
      : scan_(scan)
      , threads_(threads)
      , begin_(borderOf(ranks.rank(), ranks.size()))
      , end_(borderOf(ranks.rank() + 1, ranks.size()))
  {}

  /** @brief Collects every k-th point of the scan. */
  void read(Excerpt& excerpt) const
  {
    const std::size_t step = rawStep(scan_.size(), AdjustmentParameters().max_points);
    forEachPiece([&](const PointView& points, std::size_t first) {
      addToExcerpt(points, first, step, excerpt);
    });
  }

  /** @brief Adds its points, moved to a frame, to the sums. */
  void addTo(const BuildingFrame& frame, VoxelSums& sums) const
  {
    Excerpt moved;
    forEachPiece([&](const PointView& points, std::size_t) {
      moved.resize(points.size());
      movePoints(frame, points, threads_, moved.data());
      sums.add(viewOf(moved), threads_);
    });
  }

private:
  template <typename See>
  void forEachPiece(See see) const
  {
    RowCoordinates coordinates(scan_.fields(), scan_.rowSize());
    scan_.forEachPiece(begin_, end_, [&](const RowSource::Piece& piece) {
      see(coordinates.of(piece.rows, piece.size, threads_), piece.first);
      return true;
    });
  }

  std::size_t borderOf(int rank, int ranks) const
  {
    return scan_.size() * static_cast<std::size_t>(rank) /
           static_cast<std::size_t>(ranks);
  }

  const JointScan& scan_;
  unsigned threads_;
  std::size_t begin_;
  std::size_t end_;
};

/** @brief Adds up the sums of all ranks at rank 0, two and two. */
void
addUp(const Ranks& ranks, VoxelSums& sums)
{
  for (int step = 1; step < ranks.size(); step *= 2) {
    if (ranks.rank() % (2 * step) != 0) {
      std::vector<VoxelSum> mine = sums.take();
      sendList(ranks, ranks.rank() - step, mine);
      return;
    }
    if (ranks.rank() + step < ranks.size())
      sums.add(receiveList<std::vector<VoxelSum>>(ranks, ranks.rank() + step));
  }
}

/** @brief Gives every rank the parts of all ranks, one after the other. */
void
join(const Ranks& ranks, const Excerpt& mine, Excerpt& all)
{
  for (int rank = 0; rank < ranks.size(); ++rank) {
    Excerpt part = rank == ranks.rank() ? mine : Excerpt();
    shareList(ranks, part, rank);
    all.insert(all.end(), part.begin(), part.end());
  }
}

void
writeMeans(VoxelSums& sums, unsigned threads, StructureModel::Cloud& means)
{
  means.resize(sums.arrange());
  sums.forEach(
      [&](const VoxelSum& voxel, std::size_t place) {
        means[place].getVector3fMap() = sums.frame().mean(voxel);
      },
      threads);
}

} // namespace

ThinnedScan
thinTogether(const Ranks& ranks,
             const JointScan& scan,
             const ParallelVoxelGrid<pcl::PointXYZ>& grid,
             const FindFrame& find_frame)
{
  const unsigned threads = grid.getNumberOfThreads();
  const PartOfScan part(ranks, scan, threads);
  Excerpt excerpt;
  together(ranks, [&] { part.read(excerpt); });
  ThinnedScan thinned;
  thinned.size = scan.size();
  join(ranks, excerpt, *thinned.excerpt);
  thinned.problem = scanProblem(viewOf(*thinned.excerpt));
  if (!thinned.problem.empty())
    return thinned;
  const auto frame = find_frame(*thinned.excerpt);
  if (!frame)
    return thinned;
  const Eigen::Array3f inverse_leaf =
      Eigen::Array3f::Ones() / grid.getLeafSize().array();
  auto sums = std::make_unique<VoxelSums>(inverse_leaf);
  together(ranks, [&] { part.addTo(*frame, *sums); });
  addUp(ranks, *sums);
  if (ranks.rank() == 0) {
    if (grid.getRemoveStrays())
      thinned.strays = sums->dropStrays(threads);
    writeMeans(*sums, threads, *thinned.points);
  }
  sums.reset();
  boost::mpi::broadcast(ranks, thinned.strays, 0);
  shareList(ranks, thinned.points->points, 0);
  thinned.points->width = static_cast<std::uint32_t>(thinned.points->points.size());
  thinned.points->height = 1;
  return thinned;
}

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

void
together(const Ranks& ranks, const std::function<void()>& step)
{
  std::string problem;
  try {
    step();
  }
  catch (const std::exception& error) {
    problem = "rank " + std::to_string(ranks.rank()) + " on '" +
              boost::mpi::environment::processor_name() + "': " + error.what();
  }
  std::vector<std::string> problems;
  boost::mpi::all_gather(ranks, problem, problems);
  problems.erase(std::remove(problems.begin(), problems.end(), ""), problems.end());
  if (problems.empty())
    return;
  const std::size_t more = problems.size() - 1;
  throw ToolError(problems.front() +
                  (more > 0 ? "; " + std::to_string(more) + " more failed" : ""));
}

unsigned
fairThreads(const Ranks& ranks)
{
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(ranks, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  int ranks_here = 1;
  MPI_Comm_size(here, &ranks_here);
  MPI_Comm_free(&here);
  const long processors = std::max(1L, sysconf(_SC_NPROCESSORS_ONLN));
  // mpirun may have bound this rank to a few processors.
  return std::min(resolveThreads(0),
                  static_cast<unsigned>(std::max(1L, processors / ranks_here)));
}

} // namespace pcl::sedr::tools
