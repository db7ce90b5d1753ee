// SPDX-License-Identifier: BSD-3-Clause
#include "prior_values.h"

#include "tool_error.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace pcl::sedr::tools {

namespace {

std::string
trimmed(const std::string& text)
{
  const char* const blank = " \t\r";
  const std::size_t first = text.find_first_not_of(blank);
  return first == std::string::npos
             ? std::string()
             : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

/** @brief Sets one prior from "name = value"; throws if it is invalid. */
void
readPrior(const std::string& line, Priors& priors)
{
  const std::size_t equals = line.find('=');
  const std::string name = trimmed(line.substr(0, equals));
  const std::string number =
      equals == std::string::npos ? "" : trimmed(line.substr(equals + 1));
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  if (number.empty() || *end != '\0' || !std::isfinite(value))
    throw ToolError("a prior is given as name=value, not '" + line + "'");
  const std::string problem = setPrior(name, value, priors);
  if (!problem.empty())
    throw ToolError(problem + "; --explain lists all");
}

} // namespace

Priors
priorsOf(const std::string& list, const std::string& path)
{
  Priors priors;
  if (!path.empty()) {
    std::ifstream file(path);
    if (!file)
      throw ToolError("cannot read the priors in '" + path + "'");
    for (std::string line; std::getline(file, line);) {
      line = trimmed(line.substr(0, line.find('#')));
      if (!line.empty())
        readPrior(line, priors);
    }
  }
  std::istringstream given(list);
  for (std::string one; std::getline(given, one, ',');)
    readPrior(one, priors);
  return priors;
}

std::string
explained(const Priors& priors)
{
  std::string text;
  for (const Prior& prior : priorTable()) {
    char line[400];
    std::snprintf(line, sizeof line, "%-10s %-22s %-8g %-8s %g to %g; %s; %s\n",
                  prior.group, prior.name, priors.*prior.member, prior.unit, prior.low,
                  prior.high, prior.source, prior.where);
    text += line;
  }
  return text;
}

} // namespace pcl::sedr::tools
