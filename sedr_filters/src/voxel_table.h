// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/voxel_hash.h>

#include <pcl/sedr_filters/voxel_frame.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A point on its way to the table of its voxel. */
struct DealtPoint {
  float xyz[3];
  std::uint32_t hash; ///< of its voxel
};

/** @brief The same of the sum of some points. */
struct DealtSum {
  VoxelSum voxel;
  std::uint32_t hash;
};

/** @brief The sums of the voxels whose hashes begin with the same `table_bits`: open
 * addressing, linear probing, at most 4/5 full. Points may be added by several threads
 * at once. */
class VoxelTable {
public:
  static constexpr unsigned table_bits = 8;
  static constexpr std::size_t table_count = std::size_t{1} << table_bits;

  /** @brief Which table a voxel belongs to. */
  static std::size_t tableOf(std::uint32_t hash) { return hash >> place_bits; }

  std::size_t size() const { return size_; }

  template <typename See>
  void forEach(const See& see) const
  {
    for (const VoxelSum& voxel : slots_)
      if (voxel.count > 0)
        see(voxel);
  }

  /** @brief Forgets all voxels and gives their memory back. */
  void release()
  {
    std::vector<VoxelSum>().swap(slots_);
    size_ = 0;
  }

  /** @brief Adds points. */
  void add(const VoxelFrame& frame, const DealtPoint* points, std::size_t n)
  {
    addAll(points, n, [&](const DealtPoint& point) {
      const VoxelCode code = frame.codes(point.xyz);
      VoxelSum& voxel = slotOf(code, point.hash);
      ++voxel.count;
      for (std::size_t axis = 0; axis < 3; ++axis)
        voxel.sum[axis] += frame.steps(point.xyz[axis], axis, code[axis]);
    });
  }

  /** @brief Adds sums of points. */
  void add(const VoxelFrame&, const DealtSum* sums, std::size_t n)
  {
    addAll(sums, n,
           [&](const DealtSum& sum) { slotOf(sum.voxel.code, sum.hash) += sum.voxel; });
  }

private:
  static constexpr unsigned place_bits = 32 - table_bits;
  static constexpr std::size_t ahead = 16; ///< points whose slots are on their way

  template <typename RecordT, typename Add>
  void addAll(const RecordT* records, std::size_t n, const Add& add_one)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (slots_.empty())
      grow();
    for (std::size_t i = 0; i < n; ++i) {
      if (i + ahead < n)
        prefetch(&slots_[placeOf(records[i + ahead].hash)]);
      add_one(records[i]);
    }
  }

  static void prefetch(const void* where)
  {
#ifdef __GNUC__
    __builtin_prefetch(where, 1);
#else
    static_cast<void>(where);
#endif
  }

  std::size_t placeOf(std::uint32_t hash) const
  {
    constexpr std::uint32_t mask = (1u << place_bits) - 1;
    return static_cast<std::size_t>(
        (static_cast<std::uint64_t>(hash & mask) * slots_.size()) >> place_bits);
  }

  std::size_t after(std::size_t place) const
  {
    return place + 1 == slots_.size() ? 0 : place + 1;
  }

  /** @brief The slot of a voxel, made if it is new: its count is then 0. */
  VoxelSum& slotOf(const VoxelCode& code, std::uint32_t hash)
  {
    std::size_t i = placeOf(hash);
    while (slots_[i].count > 0) {
      if (isSame(slots_[i].code, code))
        return slots_[i];
      i = after(i);
    }
    if (5 * (size_ + 1) > 4 * slots_.size()) {
      grow();
      return slotOf(code, hash);
    }
    ++size_;
    slots_[i].code = code;
    return slots_[i];
  }

  void grow()
  {
    std::vector<VoxelSum> old(std::max<std::size_t>(32, slots_.size() * 3 / 2));
    old.swap(slots_);
    for (const VoxelSum& voxel : old) {
      if (voxel.count == 0)
        continue;
      std::size_t i = placeOf(hashOf(voxel.code));
      while (slots_[i].count > 0)
        i = after(i);
      slots_[i] = voxel;
    }
  }

  std::mutex mutex_;
  std::vector<VoxelSum> slots_;
  std::size_t size_ = 0;
};

} // namespace sedr
} // namespace pcl
