// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include "tool_error.h"

#include "sedr_filters/src/base/number_text.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

namespace pcl::sedr::tools {

namespace po = boost::program_options;

namespace {

constexpr double vast = 1e9; // larger limits are those of types and not printed

} // namespace

std::string
Range::text(const std::string& unit) const
{
  const auto number = [&](double value) {
    std::ostringstream text;
    text << value << (unit.empty() ? "" : " ") << unit;
    return text.str();
  };
  const bool has_low = low > -vast;
  const bool has_high = high < vast;
  if (has_low && has_high)
    return "from " + number(low) + " to " + number(high);
  if (has_low)
    return (open ? "above " : "at least ") + number(low);
  return has_high ? "at most " + number(high) : "";
}

Options::Options(std::string tool, std::string purpose)
    : tool_(std::move(tool))
    , purpose_(std::move(purpose))
    , options_(
          std::make_shared<po::options_description>("Options", 90)) // letters a line
{
  options_->add_options()("help,h", "prints this")("version", "prints the version");
}

std::string
Options::textOf(double value)
{
  std::ostringstream text;
  text << value; // six digits, so that the float 0.05 is printed as 0.05
  return text.str();
}

void
Options::add(const std::string& name,
             const std::string& help,
             const std::string& allowed,
             const std::string& default_text,
             const std::function<void(const std::string&)>& read)
{
  const std::string text = help + " (" + allowed + (allowed.empty() ? "" : "; ") +
                           "default " + default_text + ")";
  options_->add_options()(name.c_str(), po::value<std::string>()->notifier(read),
                          text.c_str());
}

void
Options::addNumber(const std::string& name,
                   const std::string& unit,
                   const std::string& help,
                   const Range& range,
                   bool is_whole,
                   const std::string& default_text,
                   const std::function<void(double)>& store)
{
  const std::string allowed = range.text();
  const auto read = [=](const std::string& given) {
    char* end = nullptr;
    const double value = std::strtod(given.c_str(), &end);
    if (given.empty() || *end != '\0' || !std::isfinite(value) ||
        (is_whole && value != std::floor(value)))
      throw ToolError("--" + name + " takes a " + (is_whole ? "whole " : "") +
                      "number" + (unit.empty() ? "" : " of " + unit) + ", not '" +
                      given + "'");
    if (!range.holds(value))
      throw ToolError("--" + name + " must be " +
                      (allowed.empty() ? "smaller" : range.text(unit)) + ", not " +
                      given);
    store(value);
  };
  add(name, help + (unit.empty() ? "" : " [" + unit + "]"), allowed, default_text,
      read);
}

void
Options::text(const std::string& name,
              std::string& value,
              const std::string& help,
              const std::vector<std::string>& choices)
{
  const std::string allowed = boost::join(choices, ", ");
  const auto read = [name, allowed, &value, choices](const std::string& given) {
    if (!choices.empty() &&
        std::find(choices.begin(), choices.end(), given) == choices.end())
      throw ToolError("--" + name + " is one of " + allowed + ", not '" + given + "'");
    value = given;
  };
  add(name, help, allowed, value.empty() ? "none" : value, read);
}

void
Options::words(const std::string& name, std::string& value, const std::string& help)
{
  add(name, help, "", value.empty() ? "none" : value,
      [name, &value](const auto& given) {
        if (plainText(given) != given)
          throw ToolError("--" + name + " takes printable text in UTF-8, not " +
                          quotedWord(given));
        value = given;
      });
}

void
Options::date(const std::string& name, std::string& value, const std::string& help)
{
  add(name, help, "such as 2024-05-31", "none", [name, &value](const auto& given) {
    if (!given.empty() && !isDate(given))
      throw ToolError("--" + name + " takes a day such as 2024-05-31, not " +
                      quotedWord(given));
    value = given;
  });
}

void
Options::flag(const std::string& name, bool& value, const std::string& help)
{
  options_->add_options()(name.c_str(), po::bool_switch(&value), help.c_str());
}

bool
Options::parse(int argc, const char* const* argv)
{
  po::options_description description;
  description.add(*options_).add_options()("file",
                                           po::value<std::vector<std::string>>());
  po::positional_options_description positions;
  positions.add("file", -1);
  po::variables_map given;
  try {
    // Accepts -leaf for --leaf, like PCL's own programs.
    const int style = (po::command_line_style::default_style |
                       po::command_line_style::allow_long_disguise) &
                      ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(argc, argv)
                  .options(description)
                  .positional(positions)
                  .style(style)
                  .run(),
              given);
  }
  catch (const po::error& error) {
    throw ToolError(std::string(error.what()) + "; " + tool_ + " -h tells all");
  }
  wants_version_ = given.count("version") != 0;
  if (given.count("help") != 0 || wants_version_)
    return false;
  readFiles(given.count("file") != 0 ? given["file"].as<std::vector<std::string>>()
                                     : std::vector<std::string>());
  po::notify(given);
  return true;
}

void
Options::readFiles(const std::vector<std::string>& names) const
{
  if (names.size() < files_.size() && files_[names.size()].is_needed)
    throw ToolError(files_[names.size()].name + " is missing; usage: " + usage());
  std::size_t in_list = names.size() + 1 - std::min(names.size() + 1, files_.size());
  const bool has_list = std::any_of(files_.begin(), files_.end(),
                                    [](const File& file) { return file.values; });
  if (in_list > 1 && !has_list)
    throw ToolError("'" + names[files_.size()] +
                    "' is one argument too many; usage: " + usage());
  auto name = names.begin();
  for (const File& file : files_)
    if (file.value && name != names.end())
      *file.value = *name++;
    else if (file.values)
      for (; in_list > 0; --in_list)
        file.values->push_back(*name++);
}

std::string
Options::usage() const
{
  std::string usage = tool_;
  for (const auto& file : files_)
    usage += file.is_needed ? " " + file.name + (file.values ? "..." : "")
                            : " [" + file.name + "]";
  return usage + " [options]";
}

std::string
Options::answer() const
{
  return wants_version_ ? tool_ + " (SEDR) " SEDR_VERSION "\n" : help();
}

std::string
Options::help() const
{
  std::ostringstream help;
  help << purpose_ << "\n\nUsage: " << usage() << "\n\n";
  for (const auto& file : files_)
    help << "  " << file.name << ": " << file.help << "\n";
  help << "\n"
       << *options_
       << "\nExit code: 0 done; 1 bad use or unreadable input; 2 read, but nothing "
          "found.\n";
  return help.str();
}

} // namespace pcl::sedr::tools
