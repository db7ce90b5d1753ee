// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A value of a scene file with its place, as in "rooms[2].openings".
 *
 * Invalid values throw std::invalid_argument with a sentence that begins with the
 * place. The view refers to the document and to the set of the values that were asked
 * for, which must outlive it. */
class JsonView {
public:
  using Seen = std::set<const nlohmann::json*>;

  static constexpr double kSmallest = 1e-4; ///< of a length, metres

  JsonView(const nlohmann::json& value, Seen& seen, std::string place = {})
      : value_(value)
      , seen_(seen)
      , place_(std::move(place))
  {}

  /** @brief Returns the value of @p key, which must exist. */
  JsonView at(const std::string& key) const;

  /** @brief Returns the value of @p key, if it exists. */
  std::optional<JsonView> find(const std::string& key) const;

  /** @brief Returns the elements of a list of at least @p least. */
  std::vector<JsonView> items(std::size_t least = 0) const;

  /** @brief Returns the elements of the list @p key; none if the key is missing. */
  std::vector<JsonView> itemsOf(const std::string& key) const
  {
    const auto list = find(key);
    return list ? list->items() : std::vector<JsonView>{};
  }

  /** @brief Returns the only key of an object and its value. */
  std::pair<std::string, JsonView> single() const;

  /** @brief Rejects keys, here and below, that nobody asked for. */
  void rejectUnknownKeys() const;

  bool isList() const { return value_.is_array(); }
  bool isObject() const { return value_.is_object(); }

  /** @brief Returns a number from @p low to @p high; metres or degrees by default. */
  double number(double low = -kFarthest, double high = kFarthest) const;

  /** @brief Returns the number at @p key, or @p otherwise if the key is missing. */
  double numberOr(const std::string& key,
                  double otherwise,
                  double low = -kFarthest,
                  double high = kFarthest) const
  {
    const auto value = find(key);
    return value ? value->number(low, high) : otherwise;
  }

  /** @brief Returns an angle given in degrees, radians. */
  double angle(double low = -kFarthest, double high = kFarthest) const
  {
    return number(low, high) * pi / 180.0;
  }

  /** @brief Returns a length of at least kSmallest. */
  double size() const { return number(kSmallest); }

  /** @brief Returns a whole number from @p least to @p most. */
  std::size_t count(std::size_t least, std::size_t most) const;

  bool boolean() const
  {
    if (!value_.is_boolean())
      failToBe("true or false");
    return value_.get<bool>();
  }

  std::string text() const;                               ///< not empty
  Vec2 point2() const { return Vec2(numbers(2).data()); } ///< [x, y]
  Vec3 point3() const { return Vec3(numbers(3).data()); } ///< [x, y, z]
  Vec3 size3() const;                                     ///< [x, y, z], each as size()

  /** @brief Returns the place, or "the scene" for the whole document. */
  std::string place() const { return place_.empty() ? "the scene" : place_; }

  /** @brief Throws std::invalid_argument with the place and @p sentence. */
  [[noreturn]] void fail(const std::string& sentence) const;

private:
  static constexpr double kFarthest = 10000.0;

  [[noreturn]] void failToBe(const std::string& what) const;
  JsonView below(const nlohmann::json& value, const std::string& step) const;
  std::vector<double> numbers(std::size_t count) const;

  const nlohmann::json& value_;
  Seen& seen_;
  std::string place_;
};

} // namespace pcl::sedr::sim
