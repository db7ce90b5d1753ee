// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
 * A scanner sees the same voxel many times over before it turns away: what lies in one
 * voxel in a row is added up first, then what lies in those seen last, in a small table
 * of the thread's own. What that has to give up goes to the tables of all. */
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
      if (!std::isfinite(p.x() + p.y() + p.z()) && !p.allFinite())
        continue;
      for (int axis = 0; axis < 3; ++axis)
        batch_[static_cast<std::size_t>(axis)][batched_] = p[axis];
      if (++batched_ == batch_size)
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
  static constexpr std::size_t recent_count = 1024;
  static constexpr std::size_t batch_size = 256;

  /** @brief One of the voxels seen last. */
  struct Recent {
    VoxelSum voxel;
    DealtPoint first{}; ///< of its points
  };

  void dealBatch()
  {
    const std::size_t n = batched_;
    batched_ = 0;
    frame_.codes(batch_, codes_, n);
    for (std::size_t i = 0; i < n;) {
      std::size_t end = i + 1;
      while (end < n && codes_[0][end] == codes_[0][i] &&
             codes_[1][end] == codes_[1][i] && codes_[2][end] == codes_[2][i])
        ++end;
      dealRun(i, end);
      i = end;
    }
  }

  /** @brief Deals out the points of the batch from `begin` to `end`, all in one voxel.
   */
  void dealRun(std::size_t begin, std::size_t end)
  {
    const VoxelCode code{codes_[0][begin], codes_[1][begin], codes_[2][begin]};
    const std::uint32_t hash = hashOf(code);
    Recent& recent = recent_[hash % recent_count];
    if (recent.voxel.count == 0 || !isSame(recent.voxel.code, code)) {
      giveUp(recent);
      recent.voxel = VoxelSum();
      recent.voxel.code = code;
      recent.first = {{batch_[0][begin], batch_[1][begin], batch_[2][begin]}, hash};
    }
    recent.voxel.count += static_cast<std::uint32_t>(end - begin);
    for (std::size_t axis = 0; axis < 3; ++axis)
      recent.voxel.sum[axis] +=
          frame_.steps(&batch_[axis][begin], end - begin, axis, code[axis]);
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
  std::array<std::array<float, batch_size>, 3> batch_; ///< x, y and z of some points
  std::array<std::array<std::int32_t, batch_size>, 3> codes_;
  std::size_t batched_ = 0;
  Handfuls<DealtPoint, 4096> points_;
  Handfuls<DealtSum, 256> sums_;
};

} // namespace sedr
} // namespace pcl
