// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_batch.h"
#include "voxel_table.h"

#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Records on their way to the tables of all threads, gathered by table: so many
 * go to one at once that it need not come from memory for each. */
template <typename RecordT, std::size_t handful>
class Handfuls {
public:
  Handfuls()
      : records_(new RecordT[VoxelTable::table_count * handful])
  {}

  void push(const RecordT& record, const VoxelFrame& frame, VoxelTable* tables)
  {
    const std::size_t table = VoxelTable::tableOf(record.hash);
    records_[table * handful + held_[table]++] = record;
    if (held_[table] == handful)
      handOver(table, frame, tables);
  }

  void handOverAll(const VoxelFrame& frame, VoxelTable* tables)
  {
    for (std::size_t table = 0; table < VoxelTable::table_count; ++table)
      handOver(table, frame, tables);
  }

private:
  void handOver(std::size_t table, const VoxelFrame& frame, VoxelTable* tables)
  {
    if (held_[table] > 0)
      tables[table].add(frame, &records_[table * handful], held_[table]);
    held_[table] = 0;
  }

  std::unique_ptr<RecordT[]> records_; ///< not worth zeroing
  std::array<std::size_t, VoxelTable::table_count> held_{};
};

/** @brief Brings the points of one thread to their tables.
 *
 * A scanner sees the same voxel many times over before it turns away: the voxels seen
 * last are added up in a small table of the thread's own. What that has to give up goes
 * to the tables of all. */
class VoxelDealer {
public:
  VoxelDealer(const VoxelFrame& frame, VoxelTable* tables)
      : frame_(frame)
      , tables_(tables)
      , recent_(recent_count)
  {}

  /** @brief Deals out point_at(i) for i from `begin` to `end`. */
  template <typename PointAt>
  void deal(std::size_t begin, std::size_t end, const PointAt& point_at)
  {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f p = point_at(i);
      // Most sums are finite, and then all of them are; large ones may overflow.
      if (!std::isfinite(p.x() + p.y() + p.z()) && !p.allFinite())
        continue;
      batch_.push(p);
      if (batch_.isFull())
        dealBatch();
    }
    dealBatch();
  }

  /** @brief Brings what is still on its way. */
  void finish()
  {
    for (Recent& recent : recent_) {
      giveUp(recent);
      recent.voxel.count = 0;
    }
    points_.handOverAll(frame_, tables_);
    sums_.handOverAll(frame_, tables_);
  }

private:
  static constexpr std::size_t recent_count = 2048;

  /** @brief One of the voxels seen last. */
  struct Recent {
    VoxelSum voxel;
    DealtPoint first{}; ///< of its points
  };

  void dealBatch()
  {
    batch_.find(frame_);
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      const VoxelCode code = batch_.code(i);
      Recent& recent = recent_[batch_.hash(i) % recent_count];
      if (recent.voxel.count == 0 || !isSame(recent.voxel.code, code)) {
        giveUp(recent);
        recent.voxel = VoxelSum();
        recent.voxel.code = code;
        recent.first = {
            {batch_.coordinate(0, i), batch_.coordinate(1, i), batch_.coordinate(2, i)},
            batch_.hash(i)};
      }
      ++recent.voxel.count;
      for (std::size_t axis = 0; axis < 3; ++axis)
        recent.voxel.sum[axis] += batch_.steps(axis, i);
    }
    batch_.clear();
  }

  void giveUp(const Recent& recent)
  {
    if (recent.voxel.count == 1)
      points_.push(recent.first, frame_, tables_);
    else if (recent.voxel.count > 1)
      sums_.push({recent.voxel, recent.first.hash}, frame_, tables_);
  }

  const VoxelFrame& frame_;
  VoxelTable* tables_;
  std::vector<Recent> recent_;
  VoxelBatch batch_;
  Handfuls<DealtPoint, 4096> points_;
  Handfuls<DealtSum, 1024> sums_;
};

} // namespace sedr
} // namespace pcl
