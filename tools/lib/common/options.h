// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace boost::program_options {
class options_description;
}

namespace pcl::sedr::tools {

/** @brief The valid values of a numeric option. */
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false; ///< whether `low` itself is excluded

  static Range above(double low)
  {
    return {low, std::numeric_limits<double>::infinity(), true};
  }

  static Range atLeast(double low)
  {
    return {low, std::numeric_limits<double>::infinity(), false};
  }

  static Range between(double low, double high) { return {low, high, false}; }

  bool holds(double value) const
  {
    return (open ? value > low : value >= low) && value <= high;
  }

  /** @brief Returns "above 0", "at least 1", "from 0 to 1"; empty without limits. */
  std::string text(const std::string& unit = "") const;
};

/** @brief The command line of a tool. Every option is declared once, with its unit; the
 * variable's value is the default.
 * @code
 * pcl::ParallelVoxelGrid<pcl::PCLPointCloud2> grid;
 * std::string input, output;
 * double leaf = grid.getLeafSize().x();
 * Options options("pcl_parallel_voxel_grid", "Thins a cloud to one point a voxel.");
 * options.file("INPUT.pcd", input, "cloud to thin");
 * options.file("OUTPUT.pcd", output, "thinned cloud");
 * options.number("leaf", leaf, "m", "edge of a voxel", Range::above(0));
 * return runTool(options, argc, argv, [&] { ... return Done; });
 * @endcode
 * An option may begin with one dash, as in PCL's programs. Errors in a command line are
 * thrown as ToolError with one sentence. */
class Options {
public:
  Options(std::string tool, std::string purpose);

  /** @brief Declares a required file or folder; the order of calls is that of the
   * arguments. */
  void file(const std::string& name, std::string& value, const std::string& help)
  {
    files_.push_back({name, help, &value, nullptr, true});
  }

  /** @brief Declares an optional last file; excludes files(). */
  void
  optionalFile(const std::string& name, std::string& value, const std::string& help)
  {
    files_.push_back({name, help, &value, nullptr, false});
  }

  /** @brief Declares a list of one or more files or folders at this position among
   * those of file(). At most one list is allowed. */
  void files(const std::string& name,
             std::vector<std::string>& values,
             const std::string& help)
  {
    files_.push_back({name, help, nullptr, &values, true});
  }

  /** @brief Declares a number, `--name 0.05`, of the type of `value`; `unit` may be
   * empty. */
  template <typename NumberT>
  void number(const std::string& name,
              NumberT& value,
              const std::string& unit,
              const std::string& help,
              Range range = Range())
  {
    addNumber<NumberT>(name, unit, help, range, textOf(static_cast<double>(value)),
                       [&value](double v) { value = static_cast<NumberT>(v); });
  }

  /** @brief Declares a number that a stage holds: `get` returns the default, `set`
   * takes what is given, in units of `scale`. Both are members of the stage. */
  template <typename StageT, typename GetT, typename SetT>
  void parameter(const std::string& name,
                 StageT& stage,
                 GetT get,
                 SetT set,
                 const std::string& unit,
                 const std::string& help,
                 Range range = Range(),
                 double scale = 1)
  {
    using NumberT = std::decay_t<decltype((stage.*get)())>;
    addNumber<NumberT>(name, unit, help, range,
                       textOf(static_cast<double>((stage.*get)()) / scale),
                       [&stage, set, scale](double v) {
                         (stage.*set)(static_cast<NumberT>(v * scale));
                       });
  }

  /** @brief Declares a number without a default; `otherwise` describes its absence in
   * the help. */
  template <typename NumberT>
  void optionalNumber(const std::string& name,
                      std::optional<NumberT>& value,
                      const std::string& unit,
                      const std::string& help,
                      const std::string& otherwise,
                      Range range = Range())
  {
    addNumber<NumberT>(name, unit, help, range, otherwise,
                       [&value](double v) { value = static_cast<NumberT>(v); });
  }

  /** @brief Declares a text, `--name text`; one of `choices` unless that is empty. */
  void text(const std::string& name,
            std::string& value,
            const std::string& help,
            const std::vector<std::string>& choices = {});

  /** @brief Declares a text that is printed, in UTF-8. */
  void words(const std::string& name, std::string& value, const std::string& help);

  /** @brief Declares a day, such as 2024-05-31. */
  void date(const std::string& name, std::string& value, const std::string& help);

  /** @brief Declares a switch, `--name`, which sets `value`. */
  void flag(const std::string& name, bool& value, const std::string& help);

  /** @brief Reads the command line into the variables.
   * @return false if -h, --help or --version was given; answer() then returns the
   * text */
  bool parse(int argc, const char* const* argv);

  /** @brief Returns the help, or name and version. */
  std::string answer() const;

  const std::string& tool() const { return tool_; }

private:
  struct File {
    std::string name;
    std::string help;
    std::string* value;               ///< null for a list
    std::vector<std::string>* values; ///< null unless a list
    bool is_needed = true;
  };
  static std::string textOf(double value);

  template <typename NumberT>
  void addNumber(const std::string& name,
                 const std::string& unit,
                 const std::string& help,
                 Range range,
                 const std::string& default_text,
                 const std::function<void(double)>& store)
  {
    if (std::is_integral<NumberT>::value) { // up to 2^53, doubles represent all
                                            // integers
      constexpr double most = 9007199254740992.0;
      using Limits = std::numeric_limits<NumberT>;
      range.low = std::max({range.low, -most, double(Limits::lowest())});
      range.high = std::min({range.high, most, double(Limits::max())});
    }
    addNumber(name, unit, help, range, std::is_integral<NumberT>::value, default_text,
              store);
  }

  void addNumber(const std::string& name,
                 const std::string& unit,
                 const std::string& help,
                 const Range& range,
                 bool is_whole,
                 const std::string& default_text,
                 const std::function<void(double)>& store);

  /** @brief Declares an option with a value, which `read` takes. */
  void add(const std::string& name,
           const std::string& help,
           const std::string& allowed,
           const std::string& default_text,
           const std::function<void(const std::string&)>& read);

  std::string usage() const;

  /** @brief Returns purpose, usage, files and options with units and defaults. */
  std::string help() const;

  /** @brief Assigns the file names of the command line. */
  void readFiles(const std::vector<std::string>& names) const;

  std::string tool_;
  std::string purpose_;
  std::vector<File> files_;
  std::shared_ptr<boost::program_options::options_description> options_;
  bool wants_version_ = false;
};

} // namespace pcl::sedr::tools
