// SPDX-License-Identifier: BSD-3-Clause
#include "prior_values.h"

#include "tool_error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace pcl::sedr::tools {

Priors
priorsOf(const std::string& list)
{
  Priors priors;
  std::istringstream given(list);
  for (std::string one; std::getline(given, one, ',');) {
    one.erase(0, std::min(one.find_first_not_of(' '), one.size()));
    const std::size_t equals = std::min(one.find('='), one.size());
    const std::string number = one.substr(std::min(equals + 1, one.size()));
    char* end = nullptr;
    const double value = std::strtod(number.c_str(), &end);
    if (number.empty() || *end != '\0' || !std::isfinite(value))
      throw ToolError("a prior is given as name=value, not '" + one + "'");
    const std::string problem = setPrior(one.substr(0, equals), value, priors);
    if (!problem.empty())
      throw ToolError(problem + "; --explain lists all");
  }
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
