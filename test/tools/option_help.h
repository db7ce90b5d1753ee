// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace programs {

/** What a program's help says of an option: its name without dashes, and all words
 * after it. */
struct OptionHelp {
  std::string name;
  std::string text;

  bool takesValue() const { return text.compare(0, 4, "arg ") == 0; }

  /** A switch has none, whatever takes a value must tell it. */
  bool tellsDefault() const
  {
    return !takesValue() || text.find("default ") != std::string::npos;
  }

  /** Whether it takes a number that may not be just any. */
  bool hasRange() const
  {
    return text.find("(above ") != std::string::npos ||
           text.find("(at least ") != std::string::npos ||
           text.find("(from ") != std::string::npos;
  }
};

/** The options in the help of a program, but for -h. */
inline std::vector<OptionHelp>
optionsIn(const std::string& help)
{
  std::vector<OptionHelp> options;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, 4, "  -h") == 0)
      break;
    std::istringstream words(line);
    std::string word;
    if (line.compare(0, 4, "  --") == 0) {
      words >> word;
      options.push_back({word.substr(2), ""});
    }
    while (!options.empty() && words >> word)
      options.back().text += word + " ";
  }
  return options;
}

} // namespace programs
