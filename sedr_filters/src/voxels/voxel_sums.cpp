// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_sums.h"

#include "../base/parallel.h"
#include "../grids/digit_sort.h"
#include "voxel_batch.h"

#include <algorithm>
#include <bitset>

namespace pcl::sedr {

namespace {

/** @brief Number of points that stay in the processor cache after the first read. */
constexpr std::size_t points_at_once = std::size_t{1} << 14;

/** @brief A block, and its voxels that are kept: a bit for each. */
struct KeptBlock {
  VoxelCode corner;
  std::uint64_t kept;
  const VoxelBlock* block;

  const VoxelSum& sum(unsigned local) const
  {
    return block->sums[block->places[local] - 1u];
  }
};

bool
isInside(const VoxelBox& box, const VoxelCode& block)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t low = std::int64_t{block[axis]} * VoxelBlock::edge;
    if (low < box.low[axis] ||
        low + VoxelBlock::edge > std::int64_t{box.high[axis]} + 1)
      return false;
  }
  return true;
}

void
extend(VoxelBox& box, const VoxelCode& voxel)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(box.low[axis], voxel[axis]);
    box.high[axis] = std::max(box.high[axis], voxel[axis]);
  }
}

/** @brief Lists the kept voxels of the blocks of one layer in z, which are by y, then
 * x. */
void
listLayer(const KeptBlock* begin, const KeptBlock* end, const VoxelSum** order)
{
  constexpr unsigned edge = VoxelBlock::edge;
  constexpr std::ptrdiff_t ahead = 8;
  for (unsigned z = 0; z < edge; ++z)
    for (const KeptBlock *row = begin, *row_end = begin; row != end; row = row_end) {
      row_end = std::find_if(row, end, [&](const KeptBlock& block) {
        return block.corner[1] != row->corner[1];
      });
      for (unsigned y = 0; y < edge; ++y)
        for (const KeptBlock* block = row; block != row_end; ++block) {
          const unsigned line = edge * (y + edge * z);
          if ((block->kept >> line) % (1u << edge) == 0)
            continue;
          prefetch(block[std::min(ahead, end - block - 1)].block);
          for (unsigned local = line; local < line + edge; ++local)
            if (block->kept >> local & 1)
              *order++ = &block->sum(local);
        }
    }
}

} // namespace

VoxelSums::VoxelSums(const Eigen::Array3f& inverse_leaf)
    : frame_(inverse_leaf)
    , blocks_(new VoxelBlocks)
{}

VoxelSums::~VoxelSums() = default;

template <typename IndexOf>
void
VoxelSums::addRun(const PointView& points,
                  std::size_t begin,
                  std::size_t end,
                  const IndexOf& index_of)
{
  VoxelBatch batch;
  for (std::size_t k = begin; k < end; k += VoxelBatch::most) {
    batch.fill(points, k, std::min(k + VoxelBatch::most, end), index_of, frame_);
    batch.addTo(*blocks_);
  }
}

void
VoxelSums::add(const PointView& points,
               unsigned threads,
               const RowSource::SeeRun& beside)
{
  is_arranged_ = false;
  parallelBlocks(points.size(), points_at_once, threads,
                 [&](std::size_t begin, std::size_t end) {
                   if (beside)
                     beside(begin, end);
                   addRun(points, begin, end, [](std::size_t k) { return k; });
                 });
}

void
VoxelSums::add(const PointView& points, const pcl::Indices& indices, unsigned threads)
{
  is_arranged_ = false;
  parallelBlocks(
      indices.size(), points_at_once, threads, [&](std::size_t begin, std::size_t end) {
        addRun(points, begin, end,
               [&](std::size_t k) { return static_cast<std::size_t>(indices[k]); });
      });
}

void
VoxelSums::add(const std::vector<VoxelSum>& sums)
{
  is_arranged_ = false;
  for (const VoxelSum& sum : sums) {
    const VoxelCode corner = VoxelBlock::cornerOf(sum.code);
    if (sum.count > 0)
      blocks_->at(corner, hashOf(corner)).at(sum.code) += sum;
  }
}

std::size_t
VoxelSums::size() const
{
  std::size_t size = 0;
  blocks_->forEach([&](const VoxelBlock& block) { size += block.sums.size(); });
  return size;
}

VoxelCensus
VoxelSums::census() const
{
  VoxelCensus cubes;
  blocks_->forEach([&](const VoxelBlock& block) {
    cubes.addCube(block.corner, static_cast<std::uint32_t>(block.sums.size()));
  });
  VoxelCensus census;
  if (!cubes.hasStrays()) // usually the case: the sums need not be read
    return census;
  blocks_->forEach([&](const VoxelBlock& block) {
    for (const VoxelSum& voxel : block.sums)
      census.add(voxel.code, voxel.count);
  });
  return census;
}

std::size_t
VoxelSums::arrange(std::uint32_t min_points, unsigned threads)
{
  std::vector<KeptBlock> blocks;
  blocks_->forEach([&](const VoxelBlock& block) {
    if (blocks.empty())
      box_ = {block.sums[0].code, block.sums[0].code};
    if (!isInside(box_, block.corner))
      for (const VoxelSum& voxel : block.sums)
        extend(box_, voxel.code);
    blocks.push_back({block.corner, block.occupied, &block});
    if (min_points > 1)
      for (const VoxelSum& voxel : block.sums)
        if (voxel.count < min_points)
          blocks.back().kept &= ~(std::uint64_t{1} << VoxelBlock::localOf(voxel.code));
  });
  for (std::size_t axis = 0; axis < 3; ++axis)
    sortByDigits(blocks, [&](const KeptBlock& block) {
      return static_cast<std::uint32_t>(block.corner[axis]) -
             static_cast<std::uint32_t>(box_.low[axis] >> VoxelBlock::edge_bits);
    });
  std::vector<std::size_t> layers; // first block of each, then the end
  std::vector<std::size_t> places; // of its first voxel
  std::size_t size = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (b == 0 || blocks[b].corner[2] != blocks[b - 1].corner[2]) {
      layers.push_back(b);
      places.push_back(size);
    }
    size += std::bitset<VoxelBlock::volume>(blocks[b].kept).count();
  }
  layers.push_back(blocks.size());
  order_.resize(size);
  parallelBlocks(places.size(), 1, threads, [&](std::size_t layer, std::size_t) {
    listLayer(blocks.data() + layers[layer], blocks.data() + layers[layer + 1],
              order_.data() + places[layer]);
  });
  is_arranged_ = true;
  return order_.size();
}

void
VoxelSums::forEach(const See& see, unsigned threads) const
{
  constexpr std::size_t places_at_once = 4096;
  constexpr std::size_t ahead = 16;
  parallelBlocks(order_.size(), places_at_once, threads,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     prefetch(order_[std::min(i + ahead, end - 1)]);
                     see(*order_[i], i);
                   }
                 });
}

std::vector<VoxelSum>
VoxelSums::take(unsigned threads)
{
  if (!is_arranged_)
    arrange(0, threads);
  std::vector<VoxelSum> taken(order_.size());
  forEach([&](const VoxelSum& voxel, std::size_t place) { taken[place] = voxel; },
          threads);
  std::vector<const VoxelSum*>().swap(order_);
  blocks_.reset(new VoxelBlocks);
  is_arranged_ = false;
  return taken;
}

} // namespace pcl::sedr
