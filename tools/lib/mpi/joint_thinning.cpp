// SPDX-License-Identifier: BSD-3-Clause
#include "joint_thinning.h"

#include "sedr_filters/src/voxels/voxel_sums.h"
#include "sedr_segmentation/src/adjust/plan_adjustment.h"
#include "sedr_segmentation/src/scan/scan_excerpt.h"

namespace pcl::sedr::tools {

namespace {

using Excerpt = std::vector<Eigen::Vector3f>;

/** @brief The rows of one rank. */
class PartOfScan {
public:
  PartOfScan(const Ranks& ranks, const JointScan& scan, unsigned threads)
      : scan_(scan)
      , threads_(threads)
      , begin_(borderOf(ranks.rank(), ranks.size()))
      , end_(borderOf(ranks.rank() + 1, ranks.size()))
  {}

  /** @brief Adds its points to the sums, and collects every k-th of the scan.
   * @param may_stop stop adding if the part seems so large that the unit cannot be the
   * metre, when thinning would not reduce it
   * @return whether all points were added */
  bool read(bool may_stop, VoxelSums& sums, Excerpt& excerpt) const
  {
    excerpt.clear();
    const std::size_t step = rawStep(scan_.size(), AdjustmentParameters().max_points);
    ScanSample sample(end_ - begin_);
    RowCoordinates coordinates(scan_.fields(), scan_.rowSize());
    bool adds = true;
    std::size_t looked_at = 0;
    scan_.forEachPiece(begin_, end_, [&](const RowSource::Piece& piece) {
      const PointView points = coordinates.of(piece.rows, piece.size, threads_);
      addToExcerpt(points, piece.first, step, sample, excerpt,
                   [&](const RowSource::SeeRun& see_run) {
                     if (adds)
                       sums.add(points, threads_, nullptr, see_run);
                     else
                       see_run(0, points.size());
                   });
      const std::size_t seen = piece.first + piece.size - begin_;
      if (may_stop && adds && seen >= 2 * looked_at) { // which costs next to nothing
        looked_at = seen;
        adds = !sample.isTooLarge();
      }
      return true;
    });
    return adds;
  }

private:
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

std::string
problemOf(const Excerpt& excerpt, unsigned threads)
{
  ScanSample sample(excerpt.size());
  sample.add(PointView(excerpt.data(), sizeof(Eigen::Vector3f), excerpt.size()),
             threads);
  return sample.problem();
}

void
writeMeans(VoxelSums& sums, unsigned threads, StructureChain::Cloud& means)
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
             const ParallelVoxelGrid<pcl::PointXYZ>& grid)
{
  const unsigned threads = grid.getNumberOfThreads();
  const PartOfScan part(ranks, scan, threads);
  const Eigen::Array3f inverse_leaf =
      Eigen::Array3f::Ones() / grid.getLeafSize().array();
  auto sums = std::make_unique<VoxelSums>(inverse_leaf);
  bool is_whole = false;
  Excerpt excerpt;
  together(ranks, [&] { is_whole = part.read(true, *sums, excerpt); });
  ThinnedScan thinned;
  thinned.size = scan.size();
  join(ranks, excerpt, *thinned.excerpt);
  thinned.problem = problemOf(*thinned.excerpt, threads);
  if (!thinned.problem.empty())
    return thinned;
  together(ranks, [&] {
    if (is_whole)
      return;
    sums = std::make_unique<VoxelSums>(inverse_leaf); // the whole scan is not too large
    part.read(false, *sums, excerpt);
  });
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

} // namespace pcl::sedr::tools
