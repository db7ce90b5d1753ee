// SPDX-License-Identifier: BSD-3-Clause
#include "step_file.h"

#include "../formats/decimal_text.h"

namespace pcl::sedr::ifc {
namespace {

constexpr std::uint32_t no_letter = 0xffffffff;

/** @brief Returns the character at `at`, and moves `at` behind it. */
std::uint32_t
nextLetter(const std::string& utf8, std::size_t& at)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(utf8[i]); };
  const unsigned char first = byte(at++);
  if (first < 0x80)
    return first;
  const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
  if (more == 0 || first >= 0xf8 || at + static_cast<std::size_t>(more) > utf8.size())
    return no_letter;
  std::uint32_t letter = first & (0x3fu >> more);
  for (int k = 0; k < more; ++k) {
    if ((byte(at) & 0xc0) != 0x80)
      return no_letter;
    letter = letter << 6 | (byte(at++) & 0x3fu);
  }
  return letter;
}

std::string
hexadecimal(std::uint32_t value, int digits)
{
  std::string text;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
    text += "0123456789ABCDEF"[value >> shift & 15];
  return text;
}

std::string
stepLetter(std::uint32_t letter)
{
  if (letter == '\'' || letter == '\\')
    return std::string(2, static_cast<char>(letter));
  if (letter >= ' ' && letter <= '~')
    return std::string(1, static_cast<char>(letter));
  if (letter == no_letter)
    return "?";
  return letter < 0x10000 ? "\\X2\\" + hexadecimal(letter, 4) + "\\X0\\"
                          : "\\X4\\" + hexadecimal(letter, 8) + "\\X0\\";
}

template <typename Values, typename Write>
std::string
joined(const Values& values, Write write)
{
  std::string text = "(";
  for (const auto& value : values)
    text += (text.size() > 1 ? "," : "") + write(value);
  return text + ")";
}

} // namespace

std::string
stepText(const std::string& utf8)
{
  std::string text = "'";
  for (std::size_t at = 0; at < utf8.size();)
    text += stepLetter(nextLetter(utf8, at));
  return text + "'";
}

std::string
stepReal(double value)
{
  const std::string text = shortDecimalText(value, 10);
  return text.find('.') == std::string::npos ? text + "." : text;
}

StepValue::StepValue(const std::vector<StepRef>& refs)
    : text_(joined(refs, [](StepRef ref) { return StepValue(ref).text(); }))
{}

StepValue::StepValue(const std::vector<double>& values)
    : text_(joined(values, stepReal))
{}

StepValue
StepValue::list(const std::vector<StepValue>& values)
{
  return StepValue(
      Written{joined(values, [](const StepValue& value) { return value.text(); })});
}

StepRef
StepFile::add(const std::string& type, const std::vector<StepValue>& attributes)
{
  ++count_;
  data_ += "#" + std::to_string(count_) + "=" + type +
           StepValue::list(attributes).text() + ";\n";
  return {count_};
}

std::string
StepFile::text(const std::string& description,
               const std::string& name,
               const std::string& schema) const
{
  // No time stamp, so that the same plan gives the same bytes.
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((" + stepText(description) +
         "),'2;1');\nFILE_NAME(" + stepText(name) +
         ",'1970-01-01T00:00:00',(''),(''),'SEDR','SEDR','');\nFILE_SCHEMA((" +
         stepText(schema) + "));\nENDSEC;\nDATA;\n" + data_ +
         "ENDSEC;\nEND-ISO-10303-21;\n";
}

} // namespace pcl::sedr::ifc
