// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/console/print.h>
#include <pcl/types.h>

#include <cstddef>
#include <string>
#include <utility>

namespace pcl {
namespace sedr {

/** @brief Base of every stage: keeps the sentence that says why the last run failed.
 *
 * A stage clears it when a run starts and returns the value of fail() where it gives
 * up:
 * @code
 * if (leaf <= 0)
 *   return fail("ParallelVoxelGrid", "the leaf must be above 0 m, it is -1 m");
 * @endcode */
class StageError {
public:
  /** @brief Why the last run failed, a sentence with its numbers; empty after a good
   * run. */
  const std::string& getErrorMessage() const { return error_message_; }

protected:
  StageError() = default;
  StageError(const StageError&) = default;
  StageError(StageError&&) = default;
  StageError& operator=(const StageError&) = default;
  StageError& operator=(StageError&&) = default;
  ~StageError() = default;

  /** @brief Stores `reason` and prints it with PCL_ERROR as "[pcl::<class_name>]
   * <reason>".
   * @return false, always */
  bool fail(const char* class_name, std::string reason)
  {
    error_message_ = std::move(reason);
    PCL_ERROR("[pcl::%s] %s\n", class_name, error_message_.c_str());
    return false;
  }

  void clearError() { error_message_.clear(); }

private:
  std::string error_message_;
};

/** @brief What is wrong with `indices` into a cloud of `cloud_size` points: a sentence
 * such as "index 12 is out of range, the cloud has 10 points", empty if nothing is.
 * O(n). */
inline std::string
indicesProblem(const pcl::Indices& indices, std::size_t cloud_size)
{
  for (const auto index : indices)
    if (index < 0 || static_cast<std::size_t>(index) >= cloud_size)
      return "index " + std::to_string(index) + " is out of range, the cloud has " +
             std::to_string(cloud_size) + (cloud_size == 1 ? " point" : " points");
  return {};
}

/** @brief Those of `indices` that a cloud of `cloud_size` points has: what a filter
 * that failed has removed, so that nothing passes through unfiltered. O(n). */
inline pcl::Indices
indicesInRange(const pcl::Indices& indices, std::size_t cloud_size)
{
  pcl::Indices inside;
  for (const auto index : indices)
    if (index >= 0 && static_cast<std::size_t>(index) < cloud_size)
      inside.push_back(index);
  return inside;
}

} // namespace sedr
} // namespace pcl
