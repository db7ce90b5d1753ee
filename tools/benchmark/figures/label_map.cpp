// SPDX-License-Identifier: BSD-3-Clause
#include "label_map.h"

#include "benchmark/runs/run_list.h"
#include "benchmark/table/cells.h"

#include "tool_error.h"

#include <pcl/sedr_filters/point_types.h>

#include <limits>
#include <stdexcept>

namespace pcl::sedr::benchmark {

namespace {

std::uint32_t
numberOf(const std::string& text, std::size_t most)
{
  std::size_t number = 0;
  readCell(text, number);
  if (number > most)
    throw std::invalid_argument("too large");
  return static_cast<std::uint32_t>(number);
}

} // namespace

LabelMap
labelMapOf(const std::string& text, const std::string& option)
{
  constexpr auto last_label = static_cast<std::size_t>(StructureLabel::Column);
  constexpr std::size_t last_value = std::numeric_limits<std::uint32_t>::max();
  LabelMap map;
  if (text.empty())
    return map;
  for (const std::string& pair : wordsOf(text, option))
    try {
      const std::size_t equals = pair.find('=');
      if (equals == std::string::npos)
        throw std::invalid_argument("no pair");
      const std::uint32_t meaning = numberOf(pair.substr(equals + 1), last_label);
      if (!map.emplace(numberOf(pair.substr(0, equals), last_value), meaning).second)
        throw std::invalid_argument("named twice");
    }
    catch (const std::invalid_argument&) {
      throw tools::ToolError("--" + option +
                             " takes pairs of a label of the scan and one from 0 to 5, "
                             "each label once, such as 7=3,8=3, not '" +
                             text + "'");
    }
  return map;
}

std::vector<std::uint32_t>
mapped(std::vector<std::uint32_t> labels, const LabelMap& map)
{
  for (std::uint32_t& label : labels) {
    const auto meaning = map.find(label);
    if (meaning != map.end())
      label = meaning->second;
  }
  return labels;
}

} // namespace pcl::sedr::benchmark
