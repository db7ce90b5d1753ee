// SPDX-License-Identifier: BSD-3-Clause
#include "step_file.h"

#include "sedr_filters/src/base/number_text.h"

#include <boost/locale/encoding_utf.hpp>

#include <cstdio>

namespace pcl::sedr::ifc {
namespace {

std::string
stepLetter(char32_t letter)
{
  if (letter == '\'' || letter == '\\')
    return std::string(2, static_cast<char>(letter));
  if (letter >= ' ' && letter <= '~')
    return std::string(1, static_cast<char>(letter));
  char text[20];
  std::snprintf(text, sizeof text,
                letter < 0x10000 ? "\\X2\\%04X\\X0\\" : "\\X4\\%08X\\X0\\",
                static_cast<unsigned>(letter));
  return text;
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
  for (const char32_t letter : boost::locale::conv::utf_to_utf<char32_t>(utf8))
    text += stepLetter(letter);
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
listOf(const std::vector<StepValue>& values)
{
  return StepValue::written(
      joined(values, [](const StepValue& value) { return value.text(); }));
}

StepRef
StepFile::add(const std::string& type, const std::vector<StepValue>& attributes)
{
  ++count_;
  data_ +=
      "#" + std::to_string(count_) + "=" + type + listOf(attributes).text() + ";\n";
  return {count_};
}

std::string
StepFile::text(const std::string& name,
               const std::string& author,
               const std::string& date) const
{
  return "ISO-10303-21;\nHEADER;\n"
         "FILE_DESCRIPTION(('ViewDefinition "
         "[ReferenceView_V1.2]'),'2;1');\nFILE_NAME(" +
         stepText(name) + ",'" + (isDate(date) ? date : "1970-01-01") + "T00:00:00',(" +
         stepText(author) +
         "),(''),'SEDR','SEDR','');\n"
         "FILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n" +
         data_ + "ENDSEC;\nEND-ISO-10303-21;\n";
}

} // namespace pcl::sedr::ifc
