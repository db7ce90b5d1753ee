// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include <pcl/pcl_base.h>

#include <cstring>
#include <limits>
#include <optional>
#include <string>

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

template <typename... T>
std::string
bytesOf(const T&... values)
{
  std::string bytes;
  (append(bytes, values), ...);
  return bytes;
}

/** A room of 4 x 3 x 2.5 m about the origin, floor at z = 0. Ceiling, floor and four
 * walls are lattices of 5 cm; points deviate by up to 2 mm and are in random order. */
inline Cloud::Ptr
sampleRoom(unsigned seed = 1, double length = 4)
{
  sedr_test::RoomPoints points;
  points.room(sedr_test::rectangle(-length / 2, -1.5, length / 2, 1.5), 0, 2.5);
  const Cloud::Ptr cloud = points.cloud();
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> jitter(-0.002F, 0.002F);
  for (auto& p : *cloud)
    p.getVector3fMap() +=
        Eigen::Vector3f(jitter(random), jitter(random), jitter(random));
  std::shuffle(cloud->begin(), cloud->end(), random);
  return cloud;
}

/** Returns `cloud` with a non-finite point before every seventh point. */
inline Cloud::Ptr
withHoles(const Cloud& cloud)
{
  const float none = std::numeric_limits<float>::quiet_NaN();
  const float far = std::numeric_limits<float>::infinity();
  auto result = std::make_shared<Cloud>();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i % 21 == 0)
      result->emplace_back(none, 0.f, 0.f);
    else if (i % 21 == 7)
      result->emplace_back(0.f, far, 0.f);
    else if (i % 21 == 14)
      result->emplace_back(0.f, 0.f, -far);
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

/** Returns those of the points whose height lies between two, which adaptors use as
 * ceiling or floor; indices out of range are ignored. */
inline pcl::IndicesPtr
among(const Cloud& cloud, const pcl::Indices& indices, float low, float high)
{
  auto found = std::make_shared<pcl::Indices>();
  for (const auto i : indices)
    if (i >= 0 && static_cast<std::size_t>(i) < cloud.size() &&
        cloud[static_cast<std::size_t>(i)].z >= low &&
        cloud[static_cast<std::size_t>(i)].z <= high)
      found->push_back(i);
  return found;
}

inline pcl::IndicesPtr
between(const Cloud& cloud, float low, float high)
{
  pcl::Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  return among(cloud, all, low, high);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/** What adaptors of a stage share. A derived class has
 *
 *     Outcome run();                 // into an output that is not empty
 *     Outcome runInPlace(Cloud::Ptr) // if works_in_place
 *     void setNegative(bool)         // if has_negative
 *
 * and declares the stage's parameters in its constructor. */
template <typename StageT>
class Adaptor {
public:
  static constexpr bool uses_indices = true;       ///< respects setIndices()
  static constexpr bool has_negative = false;      ///< keeps what it else removes
  static constexpr bool works_in_place = false;    ///< writes clouds
  static constexpr bool finds_in_one_point = true; ///< a single point gives a result
  static constexpr bool far_rooms_add_up = true;   ///< two rooms give twice as much
  static constexpr bool takes_one_room = false;    ///< two rooms are invalid input

  /** @param arguments of the stage's constructor */
  template <typename... Arguments>
  explicit Adaptor(Arguments... arguments)
      : stage_(arguments...)
  {}

  Adaptor(const Adaptor&) = delete;

  void setInput(const Cloud::ConstPtr& cloud) { stage_.setInputCloud(cloud); }
  void setIndices(const pcl::IndicesPtr& indices) { stage_.setIndices(indices); }
  void setThreads(unsigned threads) { setThreads(stage_, threads, 0); }

  /** Returns the number of bad values of all parameters. */
  int spoils() const { return static_cast<int>(bad_.size()); }

  void spoil(int which) { bad_[static_cast<std::size_t>(which)](); }

  void mend()
  {
    for (const auto& set : good_)
      set();
  }

protected:
  /** Declares a parameter, and sets its good value. */
  void parameter(const std::function<void(double)>& set,
                 double good,
                 const std::vector<double>& bad)
  {
    good_.push_back([=] { set(good); });
    for (const double value : bad)
      bad_.push_back([=] { set(value); });
    set(good);
  }

  /** Returns an outcome with the stage's error.
   * @param geometry see Outcome
   * @param rest of the whole result */
  Outcome outcome(std::size_t size,
                  const std::string& geometry,
                  const std::string& rest = {}) const
  {
    return {size, stage_.getErrorMessage(), geometry, geometry + rest, {}, {}};
  }

  /** Returns some points of the input; none without it. */
  Cloud pointsOf(const pcl::Indices& indices) const
  {
    return stage_.getInputCloud() ? Cloud(*stage_.getInputCloud(), indices) : Cloud();
  }

  StageT stage_;

private:
  template <typename T>
  static auto setThreads(T& stage, unsigned threads, int)
      -> decltype(stage.setNumberOfThreads(threads))
  {
    stage.setNumberOfThreads(threads);
  }
  template <typename T>
  static void setThreads(T&, unsigned, long) // a stage without threads
  {}

  std::vector<std::function<void()>> good_;
  std::vector<std::function<void()>> bad_;
};

/** An adaptor of a stage that writes clouds. */
template <typename DerivedT, typename StageT>
class FilterAdaptor : public Adaptor<StageT> {
public:
  static constexpr bool works_in_place = true;
  using Adaptor<StageT>::Adaptor;

  Outcome run()
  {
    Cloud output;
    output.emplace_back(7.f, 7.f, 7.f);
    this->stage_.filter(output);
    return static_cast<DerivedT&>(*this).outcomeOf(output);
  }

  Outcome runInPlace(const Cloud::Ptr& cloud)
  {
    static_cast<DerivedT&>(*this).setInput(cloud);
    this->stage_.filter(*cloud);
    return static_cast<DerivedT&>(*this).outcomeOf(*cloud);
  }
};

} // namespace contract
