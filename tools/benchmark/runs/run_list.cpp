// SPDX-License-Identifier: BSD-3-Clause
#include "run_list.h"

#include "benchmark/table/cells.h"

#include "tool_error.h"

#include <sstream>
#include <stdexcept>

namespace pcl::sedr::benchmark {

namespace {

using tools::ToolError;

[[noreturn]] void
refuse(const std::string& option, const std::string& takes, const std::string& given)
{
  throw ToolError("--" + option + " takes " + takes + ", not '" + given + "'");
}

} // namespace

std::vector<std::string>
wordsOf(const std::string& list, const std::string& option)
{
  std::vector<std::string> words;
  std::istringstream text(list + ",");
  for (std::string word; std::getline(text, word, ',');) {
    if (word.empty())
      refuse(option, "a list with commas between its parts", list);
    words.push_back(word);
  }
  return words;
}

std::vector<double>
noisesOf(const std::string& list, const std::string& option)
{
  std::vector<double> noises;
  for (const std::string& word : wordsOf(list, option))
    try {
      readCell(word, noises.emplace_back());
      if (!(noises.back() >= 0 && noises.back() <= 1))
        throw std::invalid_argument(word);
    }
    catch (const std::invalid_argument&) {
      refuse(option, "numbers from 0 to 1 such as 0.001,0.01", list);
    }
  return noises;
}

std::vector<std::uint64_t>
seedsOf(const std::string& list, const std::string& option)
{
  std::vector<std::uint64_t> seeds;
  for (const std::string& word : wordsOf(list, option))
    try {
      std::size_t seed = 0;
      readCell(word, seed);
      seeds.push_back(seed);
    }
    catch (const std::invalid_argument&) {
      refuse(option, "whole numbers such as 1,2,3", list);
    }
  return seeds;
}

Part
partOf(const std::string& text, const std::string& option)
{
  Part part;
  try {
    const std::size_t slash = text.find('/');
    readCell(text.substr(0, slash), part.number);
    readCell(slash == std::string::npos ? "" : text.substr(slash + 1), part.of);
    if (part.number < 1 || part.number > part.of)
      throw std::invalid_argument(text);
  }
  catch (const std::invalid_argument&) {
    refuse(option, "a part such as 1/2", text);
  }
  return part;
}

} // namespace pcl::sedr::benchmark
