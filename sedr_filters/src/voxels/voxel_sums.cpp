// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_adder.h"
#include "voxel_order.h"

#include "../base/parallel.h"
#include "voxel_sums.h"

namespace pcl::sedr {

namespace {

/** @brief Number of points that stay in the processor cache after the first read. */
constexpr std::size_t points_at_once = std::size_t{1} << 14;

} // namespace

/** @brief The blocks, and the adders of the threads, which own their memory. */
class VoxelSums::State {
public:
  explicit State(const Eigen::Array3f& inverse_leaf)
      : frame(inverse_leaf)
      , blocks(new BlockDirectory)
  {}

  template <typename IndexOf>
  void add(const PointView& points,
           std::size_t n,
           const IndexOf& index_of,
           unsigned threads,
           const RowSource::SeeRun& beside = {})
  {
    parallelBlocks(n, points_at_once, threads, [&](std::size_t begin, std::size_t end) {
      if (beside)
        beside(begin, end);
      withAdder([&](VoxelAdder& adder) { adder.add(points, begin, end, index_of); });
    });
  }

  void add(const std::vector<VoxelSum>& sums)
  {
    withAdder([&](VoxelAdder& adder) {
      for (const VoxelSum& sum : sums)
        if (sum.count > 0)
          adder.add(sum);
    });
  }

  void arrange(std::uint32_t min_points, unsigned threads)
  {
    order.reset(new VoxelOrder(*blocks, min_points, threads));
  }

  void forget()
  {
    order.reset();
    idle_.clear();
    adders_.clear();
    blocks.reset(new BlockDirectory);
  }

  VoxelFrame frame;
  std::unique_ptr<BlockDirectory> blocks;
  std::unique_ptr<VoxelOrder> order; ///< null if points were added since

private:
  template <typename Use>
  void withAdder(const Use& use)
  {
    VoxelAdder& adder = takeAdder();
    use(adder);
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(&adder);
  }

  VoxelAdder& takeAdder()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    order.reset();
    if (idle_.empty()) {
      adders_.emplace_back(new VoxelAdder(frame, *blocks));
      return *adders_.back();
    }
    VoxelAdder& adder = *idle_.back();
    idle_.pop_back();
    return adder;
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<VoxelAdder>> adders_;
  std::vector<VoxelAdder*> idle_;
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
VoxelSums::add(const PointView& points,
               unsigned threads,
               const RowSource::SeeRun& beside)
{
  state_->add(
      points, points.size(), [](std::size_t k) { return k; }, threads, beside);
}

void
VoxelSums::add(const PointView& points, const pcl::Indices& indices, unsigned threads)
{
  state_->add(
      points, indices.size(),
      [&](std::size_t k) { return static_cast<std::size_t>(indices[k]); }, threads);
}

void
VoxelSums::add(const std::vector<VoxelSum>& sums)
{
  state_->add(sums);
}

std::size_t
VoxelSums::size() const
{
  std::size_t size = 0;
  state_->blocks->forEach([&](const VoxelBlock& block) { size += block.size; });
  return size;
}

VoxelCensus
VoxelSums::census() const
{
  VoxelCensus cubes;
  state_->blocks->forEach(
      [&](const VoxelBlock& block) { cubes.addCube(block.corner, block.size); });
  VoxelCensus census;
  if (!cubes.hasStrays()) // usually the case: the sums need not be read
    return census;
  state_->blocks->forEach([&](const VoxelBlock& block) {
    const BlockSum* const sums = block.sums.load(std::memory_order_relaxed);
    for (std::size_t s = 0; s < block.size; ++s)
      census.add(block.codeOf(sums[s].local), sums[s].count);
  });
  return census;
}

std::size_t
VoxelSums::arrange(std::uint32_t min_points, unsigned threads)
{
  state_->arrange(min_points, threads);
  return state_->order->size();
}

VoxelBox
VoxelSums::box() const
{
  return state_->order->box();
}

void
VoxelSums::forEach(const See& see, unsigned threads) const
{
  state_->order->forEach(threads, see);
}

std::vector<VoxelSum>
VoxelSums::take(unsigned threads)
{
  if (!state_->order)
    arrange(0, threads);
  std::vector<VoxelSum> taken(state_->order->size());
  forEach(
      [&](const VoxelSum* voxels, const std::size_t* places, std::size_t n) {
        for (std::size_t i = 0; i < n; ++i)
          taken[places[i]] = voxels[i];
      },
      threads);
  state_->forget();
  return taken;
}

} // namespace pcl::sedr
