// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PointIndices.h>
#include <pcl/console/print.h>
#include <pcl/memory.h>
#include <pcl/types.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

namespace pcl::sedr {

/** @brief Base of every stage: stores why the last run failed, as a sentence.
 *
 * A stage clears it when a run starts and returns the value of fail() on failure:
 * @code
 * if (leaf <= 0)
 *   return fail("ParallelVoxelGrid", "the leaf must be above 0 m, it is -1 m");
 * @endcode */
class StageError {
public:
  /** @brief Returns why the last run failed, a sentence with numbers; empty after a
   * good run. */
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

/** @brief Parameter type for setters that take indices. Converts from pcl::PointIndices
 * or pcl::Indices, by value or by pointer, and from null for none. Pointers are shared,
 * not copied.
 * @code
 * pcl::PointIndices walls;
 * growing.segment(walls);
 * fitting.setWallIndices(walls);
 * @endcode */
class StageIndices {
public:
  using ConstPtr = pcl::shared_ptr<const pcl::Indices>;

  StageIndices(std::nullptr_t) {}

  StageIndices(ConstPtr indices)
      : indices_(std::move(indices))
  {}

  StageIndices(const pcl::shared_ptr<pcl::Indices>& indices)
      : indices_(indices)
  {}

  StageIndices(const pcl::PointIndices::ConstPtr& indices)
      : indices_(indices ? ConstPtr(indices, &indices->indices) : nullptr)
  {}

  StageIndices(const pcl::PointIndices::Ptr& indices)
      : StageIndices(pcl::PointIndices::ConstPtr(indices))
  {}

  StageIndices(pcl::Indices indices)
      : indices_(pcl::make_shared<const pcl::Indices>(std::move(indices)))
  {}

  StageIndices(const pcl::PointIndices& indices)
      : StageIndices(indices.indices)
  {}

  const ConstPtr& get() const { return indices_; }

private:
  ConstPtr indices_;
};

/** @brief Returns what is wrong with the first of some values that is not above 0, or
 * not finite, as a sentence; empty if all are.
 * @param values {{"the grid size", 0.1}} */
inline std::string
positiveProblem(std::initializer_list<std::pair<const char*, double>> values,
                const char* unit = "m")
{
  for (const auto& [what, value] : values)
    if (!(value > 0) || !std::isfinite(value))
      return std::string(what) + " must be above 0 " + unit + ", it is " +
             std::to_string(value);
  return {};
}

/** @brief Returns what is wrong with `indices` into a cloud of `cloud_size` points,
 * such as "index 12 is out of range, the cloud has 10 points"; empty if nothing is.
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

/** @brief Checks indices that may be null; `name` starts the sentence: "floor index 12
 * is out of range, ...". */
inline std::string
indicesProblem(const char* name,
               const StageIndices::ConstPtr& indices,
               std::size_t size)
{
  const std::string problem = indices ? indicesProblem(*indices, size) : std::string();
  return problem.empty() ? problem : name + (" " + problem);
}

/** @brief Returns the `indices` within a cloud of `cloud_size` points. A failed filter
 * reports them as removed, so that nothing passes unfiltered. O(n). */
inline pcl::Indices
indicesInRange(const pcl::Indices& indices, std::size_t cloud_size)
{
  pcl::Indices inside;
  for (const auto index : indices)
    if (index >= 0 && static_cast<std::size_t>(index) < cloud_size)
      inside.push_back(index);
  return inside;
}

} // namespace pcl::sedr
