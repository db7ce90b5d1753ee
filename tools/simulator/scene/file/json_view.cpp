// SPDX-License-Identifier: BSD-3-Clause
#include "json_view.h"

#include "sedr_filters/src/base/number_text.h"

namespace pcl::sedr::sim {

using nlohmann::json;

JsonView
JsonView::below(const json& value, const std::string& step) const
{
  seen_.insert(&value);
  return {value, seen_, place_.empty() ? step.substr(1) : place_ + step};
}

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
  if (!isObject())
    failToBe("an object");
  const auto entry = value_.find(key);
  if (entry == value_.end())
    return std::nullopt;
  return below(*entry, '.' + key);
}

std::vector<JsonView>
JsonView::items(std::size_t least) const
{
  if (!isList())
    failToBe("a list");
  if (value_.size() < least)
    fail("must have at least " + std::to_string(least) + " elements, not " +
         std::to_string(value_.size()));
  std::vector<JsonView> elements;
  for (std::size_t i = 0; i < value_.size(); ++i)
    elements.push_back(below(value_[i], '[' + std::to_string(i) + ']'));
  return elements;
}

std::pair<std::string, JsonView>
JsonView::single() const
{
  if (!isObject() || value_.size() != 1)
    fail("must be an object with one key, the kind of thing it is");
  const std::string key = value_.begin().key();
  return {key, at(key)};
}

void
JsonView::rejectUnknownKeys() const
{
  for (const auto& entry : value_.items()) {
    const bool is_known = seen_.count(&entry.value()) > 0;
    if (isObject() && !is_known)
      fail("has a key that is unknown here: " + json(entry.key()).dump(-1, ' ', true));
    const std::string step = isObject() ? '.' + entry.key() : '[' + entry.key() + ']';
    if (entry.value().is_structured())
      below(entry.value(), step).rejectUnknownKeys();
  }
}

double
JsonView::number(double low, double high) const
{
  const double value = value_.is_number() ? value_.get<double>() : std::nan("");
  if (!(value >= low && value <= high))
    failToBe("a number from " + numberText(low) + " to " + numberText(high));
  return value;
}

std::size_t
JsonView::count(std::size_t least, std::size_t most) const
{
  if (!value_.is_number_unsigned() || value_.get<std::size_t>() < least ||
      value_.get<std::size_t>() > most)
    failToBe("a whole number from " + std::to_string(least) + " to " +
             std::to_string(most));
  return value_.get<std::size_t>();
}

std::string
JsonView::text() const
{
  if (!value_.is_string() || value_.get_ref<const std::string&>().empty())
    failToBe("a text");
  return value_.get<std::string>();
}

std::vector<double>
JsonView::numbers(std::size_t count) const
{
  if (!isList() || value_.size() != count)
    failToBe("a list of " + std::to_string(count) + " numbers");
  std::vector<double> values;
  for (const JsonView& element : items())
    values.push_back(element.number());
  return values;
}

Vec3
JsonView::size3() const
{
  const Vec3 values = point3();
  for (const JsonView& element : items())
    element.size();
  return values;
}

void
JsonView::fail(const std::string& sentence) const
{
  sim::fail(place(), ' ', sentence);
}

void
JsonView::failToBe(const std::string& what) const
{
  constexpr std::size_t longest = 40;
  std::string text = isObject() ? "an object"
                     : isList() ? "a list"
                                : value_.dump(-1, ' ', true);
  if (text.size() > longest)
    text = text.substr(0, longest) + "...";
  fail("must be " + what + ", not " + text);
}

} // namespace pcl::sedr::sim
