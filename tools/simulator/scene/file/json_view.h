// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scan/vec.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A value of a scene file together with its place, as in "rooms[2].openings".
 *
 * Invalid values throw std::invalid_argument with a sentence that begins with the
 * place. The view refers to the document, which must outlive it.
 */
class JsonView {
public:
  explicit JsonView(const nlohmann::json& value, std::string place = {})
      : value_(value)
      , place_(std::move(place))
  {}

  /** @brief Returns the value of @p key, which must exist. */
  JsonView at(const std::string& key) const;

  /** @brief Returns the value of @p key, if it exists. */
  std::optional<JsonView> find(const std::string& key) const;

  /** @brief Returns the elements of a list of at least @p least. */
  std::vector<JsonView> items(std::size_t least = 0) const;

  /** @brief Returns the elements of the list @p key; none if the key is missing. */
  std::vector<JsonView> itemsOf(const std::string& key) const;

  /** @brief Returns the only key of an object and its value. */
  std::pair<std::string, JsonView> single() const;

  /** @brief Rejects an object with any other key. */
  void allowOnly(const std::vector<std::string>& keys) const;

  bool isList() const { return value_.is_array(); }
  bool isObject() const { return value_.is_object(); }

  /** @brief Returns a number from @p low to @p high; metres or degrees by default. */
  double number(double low = -kFarthest, double high = kFarthest) const;

  /** @brief Returns a length of at least 0.1 mm. */
  double size() const;

  /** @brief Returns a whole number from @p least to @p most. */
  std::size_t count(std::size_t least, std::size_t most) const;

  /** @brief Returns true or false. */
  bool boolean() const;

  /** @brief Returns a non-empty text. */
  std::string text() const;

  Vec2 point2() const; ///< [x, y]
  Vec3 point3() const; ///< [x, y, z]
  Vec3 size3() const;  ///< [x, y, z], each as size()

  /** @brief Returns the number at @p key, or @p otherwise if the key is missing. */
  double numberOr(const std::string& key, double otherwise) const;

  /** @brief Returns the place, or "the scene" for the whole document. */
  std::string place() const { return place_.empty() ? "the scene" : place_; }

  /** @brief Throws std::invalid_argument with the place and @p sentence. */
  [[noreturn]] void fail(const std::string& sentence) const;

private:
  static constexpr double kFarthest = 10000.0;

  std::vector<double> numbers(std::size_t count) const;

  const nlohmann::json& value_;
  std::string place_;
};

} // namespace pcl::sedr::sim
