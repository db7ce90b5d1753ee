// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace contract {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** The result of a run of a class. */
struct Outcome {
  std::size_t size = 0; ///< points kept, regions found, faces ...; 0 without result
  std::string error;    ///< getErrorMessage()
  std::string geometry; ///< the result without indices into the input, as bytes
  std::string all;      ///< the whole result with indices and parameters, as bytes
  std::optional<pcl::Indices> kept;    ///< if the class keeps or removes each point
  std::optional<pcl::Indices> removed; ///< likewise
};

template <typename T>
void
append(std::string& bytes, const T& value)
{
  static_assert(std::is_arithmetic<T>::value, "numbers only: structures have padding");
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <typename T>
void
append(std::string& bytes, const std::vector<T>& values)
{
  append(bytes, values.size());
  for (const auto& value : values)
    append(bytes, value);
}

template <typename PointT>
void
append(std::string& bytes, const pcl::PointCloud<PointT>& cloud)
{
  append(bytes, cloud.size());
  for (const auto& p : cloud)
    for (const float value : {p.x, p.y, p.z})
      append(bytes, value);
}

/** A room of 4 x 3 x 2.5 m about the origin, floor at z = 0. Ceiling, floor and four
 * walls are lattices of 5 cm; points deviate by up to 2 mm and are in random order. */
inline Cloud::Ptr
sampleRoom(unsigned seed = 1, double length = 4)
{
  const double width = 3;
  const double height = 2.5;
  const double step = 0.05;
  std::mt19937 random(seed);
  const auto jitter = [&] {
    return static_cast<float>(static_cast<double>(random()) / 4294967296.0 * 0.004 -
                              0.002);
  };
  auto cloud = std::make_shared<Cloud>();
  const auto add = [&](double x, double y, double z) {
    cloud->emplace_back(static_cast<float>(x - length / 2) + jitter(),
                        static_cast<float>(y - width / 2) + jitter(),
                        static_cast<float>(z) + jitter());
  };
  for (double x = step / 2; x < length; x += step)
    for (double y = step / 2; y < width; y += step) {
      add(x, y, 0);
      add(x, y, height);
    }
  for (double z = step / 2; z < height; z += step) {
    for (double x = step / 2; x < length; x += step) {
      add(x, 0, z);
      add(x, width, z);
    }
    for (double y = step / 2; y < width; y += step) {
      add(0, y, z);
      add(length, y, z);
    }
  }
  for (std::size_t i = cloud->size() - 1; i > 0; --i)
    std::swap((*cloud)[i], (*cloud)[random() % (i + 1)]);
  return cloud;
}

/** Returns `cloud` with a non-finite point before every seventh point. */
inline Cloud::Ptr
withHoles(const Cloud& cloud)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  auto result = std::make_shared<Cloud>();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i % 21 == 0)
      result->emplace_back(nan, 0.f, 0.f);
    else if (i % 21 == 7)
      result->emplace_back(0.f, inf, 0.f);
    else if (i % 21 == 14)
      result->emplace_back(0.f, 0.f, -inf);
    result->push_back(cloud[i]);
  }
  result->is_dense = false;
  return result;
}

inline bool
isFinite(const pcl::PointXYZ& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/** Returns the points of `cloud` between two heights, which adaptors use as ceiling or
 * floor. */
inline pcl::IndicesPtr
between(const Cloud& cloud, float low, float high)
{
  auto indices = std::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud[i].z >= low && cloud[i].z <= high)
      indices->push_back(static_cast<pcl::index_t>(i));
  return indices;
}

/** Sets the points at 2.5 m as ceiling and those at 0 m as floor of a stage, restricted
 * to the given indices. */
template <typename Stage>
void
setSlabs(const pcl::Indices& indices, Stage& stage)
{
  const Cloud& cloud = *stage.getInputCloud();
  const auto ceiling = std::make_shared<pcl::Indices>();
  const auto floor = std::make_shared<pcl::Indices>();
  for (const auto i : indices) {
    if (i < 0 || static_cast<std::size_t>(i) >= cloud.size())
      continue;
    const float z = cloud[static_cast<std::size_t>(i)].z;
    if (std::abs(z - 2.5f) < 0.01f)
      ceiling->push_back(i);
    else if (std::abs(z) < 0.01f)
      floor->push_back(i);
  }
  stage.setCeilingIndices(ceiling);
  stage.setFloorIndices(floor);
}

/** Defaults that adaptors inherit. An adaptor overrides them where necessary, and has
 *
 *     void setInput(const Cloud::ConstPtr&); // and other inputs made from it
 *     void setIndices(const pcl::IndicesPtr&);
 *     Outcome run();                         // into an output that is not empty
 *     void spoil(int which);                 // sets the bad parameter of this number
 *     void mend();                           // sets good parameters again
 *     static constexpr int spoils;           // number of bad parameters
 */
struct AdaptorDefaults {
  static constexpr bool uses_indices = true;       ///< respects setIndices()
  static constexpr bool has_negative = false;      ///< has setNegative(bool)
  static constexpr bool works_in_place = false;    ///< has runInPlace(Cloud::Ptr)
  static constexpr bool finds_in_one_point = true; ///< a single point gives a result
  static constexpr bool far_rooms_add_up =
      true; ///< two rooms 10 km apart double the result
  static constexpr bool takes_one_room =
      false; ///< works on one room; two are invalid input

  void setThreads(unsigned) {}
};

} // namespace contract
