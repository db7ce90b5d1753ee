// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace programs {

/** An option in a program's help: its name without dashes, and its text. */
struct OptionHelp {
  std::string name;
  std::string text;

  bool takesValue() const { return text.compare(0, 4, "arg ") == 0; }

  /** Returns true for switches, and for options whose text gives the default. */
  bool tellsDefault() const
  {
    return !takesValue() || text.find("default ") != std::string::npos;
  }

  /** Returns true if the text gives a range of values. */
  bool hasRange() const
  {
    return text.find("(above ") != std::string::npos ||
           text.find("(at least ") != std::string::npos ||
           text.find("(from ") != std::string::npos;
  }
};

/** Returns the options in the help of a program, except -h and --version. */
inline std::vector<OptionHelp>
optionsIn(const std::string& help)
{
  std::vector<OptionHelp> options;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, 4, "  -h") == 0 || line.compare(0, 11, "  --version") == 0)
      continue;
    if (line.empty() && !options.empty())
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
