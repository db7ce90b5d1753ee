// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_dealer.h"
#include "voxel_order.h"

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/voxel_sums.h>

namespace pcl {
namespace sedr {

namespace {

constexpr std::size_t points_per_block = std::size_t{1} << 16;

} // namespace

/** @brief The tables, and the dealers that wait for a thread. */
class VoxelSums::State {
public:
  explicit State(const Eigen::Array3f& inverse_leaf)
      : frame(inverse_leaf)
      , tables(new VoxelTable[VoxelTable::table_count])
  {}

  template <typename PointAt>
  void add(std::size_t n, const PointAt& point_at, unsigned threads)
  {
    parallelBlocks(n, points_per_block, threads,
                   [&](std::size_t begin, std::size_t end) {
                     const auto dealer = takeDealer();
                     dealer->deal(begin, end, point_at);
                     giveBack(dealer);
                   });
    parallelBlocks(dealers_.size(), 1, threads,
                   [&](std::size_t i, std::size_t) { dealers_[i]->finish(); });
  }

  VoxelFrame frame;
  std::unique_ptr<VoxelTable[]> tables;

private:
  using DealerPtr = std::shared_ptr<VoxelDealer>;

  DealerPtr takeDealer()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (dealers_.empty())
      return std::make_shared<VoxelDealer>(frame, tables.get());
    const DealerPtr dealer = dealers_.back();
    dealers_.pop_back();
    return dealer;
  }

  void giveBack(const DealerPtr& dealer)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    dealers_.push_back(dealer);
  }

  std::mutex mutex_;
  std::vector<DealerPtr> dealers_;
};

VoxelSums::VoxelSums(const Eigen::Array3f& inverse_leaf)
    : state_(new State(inverse_leaf))
{}

VoxelSums::~VoxelSums() = default;

const VoxelFrame&
VoxelSums::frame() const
{
  return state_->frame;
}

void
VoxelSums::add(const PointView& points, unsigned threads)
{
  state_->add(
      points.size(), [&](std::size_t i) { return points[i]; }, threads);
}

void
VoxelSums::add(const PointView& points, const pcl::Indices& indices, unsigned threads)
{
  state_->add(
      indices.size(),
      [&](std::size_t i) { return points[static_cast<std::size_t>(indices[i])]; },
      threads);
}

void
VoxelSums::add(const std::vector<VoxelSum>& sums)
{
  for (const VoxelSum& sum : sums)
    if (sum.count > 0) {
      const std::uint32_t hash = hashOf(sum.code);
      const DealtSum dealt{sum, hash};
      state_->tables[VoxelTable::tableOf(hash)].add(state_->frame, &dealt, 1);
    }
}

std::size_t
VoxelSums::size() const
{
  std::size_t size = 0;
  for (std::size_t t = 0; t < VoxelTable::table_count; ++t)
    size += state_->tables[t].size();
  return size;
}

std::vector<VoxelSum>
VoxelSums::take(unsigned threads)
{
  return takeSorted(state_->tables.get(), threads);
}

} // namespace sedr
} // namespace pcl
