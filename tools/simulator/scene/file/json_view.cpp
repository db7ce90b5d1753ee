// SPDX-License-Identifier: BSD-3-Clause
#include "json_view.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

using nlohmann::json;

constexpr std::size_t kShownLength = 40;
constexpr double kSmallest = 1e-4;

/** @brief Returns a value or key as it is in the file, shortened if long. */
std::string
shown(const json& value)
{
  if (value.is_structured())
    return value.is_array() ? "a list" : "an object";
  std::string text = value.dump(-1, ' ', true);
  if (text.size() > kShownLength)
    text = text.substr(0, kShownLength) + "...";
  return text;
}

std::string
listed(const std::vector<std::string>& keys)
{
  std::string text;
  for (const std::string& key : keys)
    text += (text.empty() ? "\"" : ", \"") + key + '"';
  return text;
}

std::string
rangeText(double low, double high)
{
  std::ostringstream text;
  text << low << " to " << high;
  return text.str();
}

} // namespace

JsonView
JsonView::at(const std::string& key) const
{
  auto found = find(key);
  if (!found)
    fail("lacks \"" + key + '"');
  return *found;
}

std::optional<JsonView>
JsonView::find(const std::string& key) const
{
  if (!value_.is_object())
    fail("must be an object, not " + shown(value_));
  const auto entry = value_.find(key);
  if (entry == value_.end())
    return std::nullopt;
  return JsonView(*entry, place_.empty() ? key : place_ + '.' + key);
}

std::vector<JsonView>
JsonView::items(std::size_t least) const
{
  if (!value_.is_array())
    fail("must be a list, not " + shown(value_));
  if (value_.size() < least)
    fail("must have at least " + std::to_string(least) + " elements, not " +
         std::to_string(value_.size()));
  std::vector<JsonView> elements;
  for (std::size_t i = 0; i < value_.size(); ++i)
    elements.emplace_back(value_[i], place_ + '[' + std::to_string(i) + ']');
  return elements;
}

std::vector<JsonView>
JsonView::itemsOf(const std::string& key) const
{
  const auto list = find(key);
  return list ? list->items() : std::vector<JsonView>{};
}

std::pair<std::string, JsonView>
JsonView::single() const
{
  if (!value_.is_object() || value_.size() != 1)
    fail("must be an object with one key, the kind of thing it is");
  const std::string key = value_.begin().key();
  return {key, at(key)};
}

void
JsonView::allowOnly(const std::vector<std::string>& keys) const
{
  if (!value_.is_object())
    fail("must be an object, not " + shown(value_));
  for (const auto& entry : value_.items())
    if (std::find(keys.begin(), keys.end(), entry.key()) == keys.end())
      fail("has an unknown key " + shown(entry.key()) + "; known are " + listed(keys));
}

double
JsonView::number(double low, double high) const
{
  const double value = value_.is_number() ? value_.get<double>() : std::nan("");
  if (!(value >= low && value <= high))
    fail("must be a number from " + rangeText(low, high) + ", not " + shown(value_));
  return value;
}

double
JsonView::size() const
{
  return number(kSmallest);
}

std::size_t
JsonView::count(std::size_t least, std::size_t most) const
{
  const bool fits = value_.is_number_unsigned() && value_.get<std::size_t>() >= least &&
                    value_.get<std::size_t>() <= most;
  if (!fits)
    fail("must be a whole number from " + std::to_string(least) + " to " +
         std::to_string(most) + ", not " + shown(value_));
  return value_.get<std::size_t>();
}

bool
JsonView::boolean() const
{
  if (!value_.is_boolean())
    fail("must be true or false, not " + shown(value_));
  return value_.get<bool>();
}

std::string
JsonView::text() const
{
  if (!value_.is_string() || value_.get_ref<const std::string&>().empty())
    fail("must be a text, not " + shown(value_));
  return value_.get<std::string>();
}

std::vector<double>
JsonView::numbers(std::size_t count) const
{
  if (!value_.is_array() || value_.size() != count)
    fail("must be a list of " + std::to_string(count) + " numbers");
  std::vector<double> values;
  for (const JsonView& element : items())
    values.push_back(element.number());
  return values;
}

Vec2
JsonView::point2() const
{
  const auto values = numbers(2);
  return {values[0], values[1]};
}

Vec3
JsonView::point3() const
{
  const auto values = numbers(3);
  return {values[0], values[1], values[2]};
}

Vec3
JsonView::size3() const
{
  const auto values = numbers(3);
  for (const JsonView& element : items())
    element.size();
  return {values[0], values[1], values[2]};
}

double
JsonView::numberOr(const std::string& key, double otherwise) const
{
  const auto value = find(key);
  return value ? value->number() : otherwise;
}

void
JsonView::fail(const std::string& sentence) const
{
  throw std::invalid_argument(place() + ' ' + sentence);
}

} // namespace pcl::sedr::sim
