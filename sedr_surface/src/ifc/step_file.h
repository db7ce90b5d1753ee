// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::ifc {

/** @brief The number of an instance in a STEP file: #1, #2, ...; 0 is none. */
struct StepRef {
  std::size_t id = 0;

  bool isNone() const { return id == 0; }
};

/** @brief Returns a text as a STEP string (ISO 10303-21): in quotes, with quotes and
 * backslashes doubled and characters beyond ASCII as \\X2\\00FC\\X0\\.
 * @param utf8 bytes that are no valid UTF-8 are left out */
std::string stepText(const std::string& utf8);

/** @brief Returns a number as in STEP, with a point and up to ten decimals: "1.",
 * "0.25". */
std::string stepReal(double value);

/** @brief The value of an attribute, as written to the file. */
class StepValue {
public:
  StepValue(StepRef ref)
      : text_(ref.isNone() ? "$" : "#" + std::to_string(ref.id))
  {}
  StepValue(double value)
      : text_(stepReal(value))
  {}
  StepValue(const char* text)
      : text_(stepText(text))
  {}
  StepValue(const std::string& text)
      : text_(stepText(text))
  {}
  StepValue(const std::vector<StepRef>& refs);
  StepValue(const std::vector<double>& values);
  StepValue(bool) = delete; ///< use logical()

  /** @brief Returns a value that is written as it is. */
  static StepValue written(std::string text)
  {
    StepValue value;
    value.text_ = std::move(text);
    return value;
  }

  const std::string& text() const { return text_; }

private:
  StepValue() = default;

  std::string text_;
};

/** @brief The value of an optional attribute without one; derived, of an attribute that
 * a subtype derives. */
inline const StepValue none = StepValue::written("$");
inline const StepValue derived = StepValue::written("*");

inline StepValue
symbol(const std::string& name)
{
  return StepValue::written("." + name + ".");
}

inline StepValue
logical(bool value)
{
  return symbol(value ? "T" : "F");
}

inline StepValue
integer(std::size_t value)
{
  return StepValue::written(std::to_string(value));
}

/** @brief Returns a value with its type: IFCLENGTHMEASURE(0.2). */
inline StepValue
typed(const std::string& type, const StepValue& value)
{
  return StepValue::written(type + "(" + value.text() + ")");
}

StepValue listOf(const std::vector<StepValue>& values);

/** @brief The instances of a STEP file, in the order of addition. */
class StepFile {
public:
  /** @param type such as "IFCWALL" */
  StepRef add(const std::string& type, const std::vector<StepValue>& attributes);

  /** @brief Returns the complete file.
   * @param name of the file, for the header, as are the next ones
   * @param date such as 2024-05-31; any other text is a fixed date, so that the same
   * plan gives the same bytes */
  std::string text(const std::string& name,
                   const std::string& author,
                   const std::string& date) const;

private:
  std::size_t count_ = 0;
  std::string data_;
};

} // namespace pcl::sedr::ifc
