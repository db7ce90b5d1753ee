// SPDX-License-Identifier: BSD-3-Clause
#include "cells.h"

#include "formatted.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace pcl::sedr::benchmark {

namespace {

[[noreturn]] void
refuse(const std::string& cell, const char* what)
{
  throw std::invalid_argument("'" + cell + "' is no " + what);
}

} // namespace

std::string
cellOf(double value)
{
  return std::isnan(value) ? "" : formatted("%.7g", value);
}

std::string
cellOf(std::size_t value)
{
  return std::to_string(value);
}

std::string
cellOf(const std::optional<std::size_t>& value)
{
  return value ? cellOf(*value) : "";
}

std::string
cellOf(bool value)
{
  return value ? "1" : "0";
}

std::string
cellOf(const std::optional<bool>& value)
{
  return value ? cellOf(*value) : "";
}

std::string
cellOf(const std::string& value)
{
  return value;
}

std::string
cellOf(const StageSeconds& value)
{
  std::string text;
  for (const auto& [stage, seconds] : value)
    text += (text.empty() ? "" : ";") + stage + "=" + cellOf(seconds);
  return text;
}

void
readCell(const std::string& cell, double& value)
{
  value = not_known;
  if (cell.empty())
    return;
  char* end = nullptr;
  value = std::strtod(cell.c_str(), &end);
  if (end != cell.c_str() + cell.size())
    refuse(cell, "number");
}

void
readCell(const std::string& cell, std::size_t& value)
{
  if (cell.empty() || cell.size() > 18 ||
      cell.find_first_not_of("0123456789") != std::string::npos)
    refuse(cell, "whole number");
  value = std::stoull(cell);
}

} // namespace pcl::sedr::benchmark
