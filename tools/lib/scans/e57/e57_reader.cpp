// SPDX-License-Identifier: BSD-3-Clause
#include "e57_reader.h"

#include "e57_values.h"
#include "run_tool.h"
#include "tool_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t batch = 1024; // rows whose values fit into a fast cache
using Column = std::array<double, batch>;

using Names = std::array<const char*, 3>;
constexpr Names cartesian{"cartesianX", "cartesianY", "cartesianZ"};
constexpr Names spherical{"sphericalRange", "sphericalAzimuth", "sphericalElevation"};
constexpr Names colours{"colorBlue", "colorGreen", "colorRed"}; // low byte first

[[noreturn]] void
refuse(const std::string& path, const std::string& reason)
{
  throw ToolError("cannot read '" + path + "' as E57: " + reason);
}

std::uint8_t
colourByte(double value, const std::pair<double, double>& limits)
{
  constexpr double most = 255;
  const double share = limits.second > limits.first
                           ? (value - limits.first) / (limits.second - limits.first)
                           : value / most;
  const double scaled = std::round(share * most);
  return scaled >= most ? std::uint8_t{255}
         : scaled > 0   ? static_cast<std::uint8_t>(scaled)
                        : std::uint8_t{0};
}

} // namespace

/** @brief A scan of the file. */
class E57Reader::Scan {
public:
  /** @param first_row number of its first point in the whole file */
  Scan(const E57Pages& pages, const E57Scan& scan, std::size_t first_row)
      : scan_(scan)
      , first_row_(first_row)
      , turn_(scan.rotation.toRotationMatrix())
  {
    const bool has_cartesian = findAll(cartesian, xyz_);
    is_spherical_ = !has_cartesian;
    if (!has_cartesian && !findAll(spherical, xyz_))
      throw ToolError("its points have neither cartesian nor spherical coordinates");
    has_colour_ = findAll(colours, colour_);
    intensity_ = findReadable("intensity");
    invalid_ =
        findReadable(is_spherical_ ? "sphericalInvalidState" : "cartesianInvalidState");
    packets_ = std::make_unique<E57Packets>(pages, scan_, wanted_);
    for (const std::size_t field : wanted_)
      list_of_field_.emplace_back(field);
    std::sort(list_of_field_.begin(), list_of_field_.end());
  }

  const E57Scan& head() const { return scan_; }
  const E57Packets& packets() const { return *packets_; }
  std::size_t begin() const { return first_row_; }
  std::size_t end() const { return first_row_ + scan_.points; }
  bool hasIntensity() const { return intensity_ >= 0; }
  bool hasColour() const { return has_colour_; }

  /** @brief Decodes `size` points from `first` on into zeroed rows.
   * @param intensity,colour offsets in a row, 0 if rows have none */
  void read(std::size_t first,
            std::size_t size,
            std::size_t row_size,
            std::size_t intensity,
            std::size_t colour,
            std::uint8_t* rows) const
  {
    const std::vector<E57Bytes> lists = packets_->read(first, first + size);
    for (std::size_t done = 0; done < size; done += batch) {
      const std::size_t n = std::min(batch, size - done);
      std::uint8_t* const to = rows + done * row_size;
      placePoints(lists, done, n, row_size, to);
      if (hasIntensity() && intensity > 0)
        placeIntensity(lists, done, n, row_size, to + intensity);
      if (hasColour() && colour > 0)
        placeColour(lists, done, n, row_size, to + colour);
    }
  }

private:
  /** @brief Returns the number of the field called `name` and marks it as wanted; -1 if
   * it is missing or cannot be read. */
  int findReadable(const std::string& name)
  {
    const int field = scan_.find(name);
    if (field < 0 ||
        scan_.fields[static_cast<std::size_t>(field)].kind == E57Field::Kind::Other)
      return -1;
    wanted_.push_back(static_cast<std::size_t>(field));
    return field;
  }

  /** @brief As above for three fields, which are all required. */
  bool findAll(const Names& names, std::array<int, 3>& found)
  {
    const std::size_t before = wanted_.size();
    for (std::size_t k = 0; k < names.size(); ++k)
      found[k] = findReadable(names[k]);
    if (std::find(found.begin(), found.end(), -1) == found.end())
      return true;
    wanted_.resize(before);
    return false;
  }

  void values(const std::vector<E57Bytes>& lists,
              int field,
              std::size_t first,
              std::size_t n,
              Column& column) const
  {
    const auto number = static_cast<std::size_t>(field);
    const auto it =
        std::lower_bound(list_of_field_.begin(), list_of_field_.end(), number);
    readE57Values(scan_.fields[number],
                  lists[static_cast<std::size_t>(it - list_of_field_.begin())], first,
                  n, column.data());
  }

  void placePoints(const std::vector<E57Bytes>& lists,
                   std::size_t first,
                   std::size_t n,
                   std::size_t row_size,
                   std::uint8_t* rows) const
  {
    std::array<Column, 3> xyz;
    for (std::size_t axis = 0; axis < 3; ++axis)
      values(lists, xyz_[axis], first, n, xyz[axis]);
    Column invalid;
    if (invalid_ >= 0)
      values(lists, invalid_, first, n, invalid);
    for (std::size_t i = 0; i < n; ++i) {
      Eigen::Vector3d p(xyz[0][i], xyz[1][i], xyz[2][i]);
      if (is_spherical_) {
        const double in_plan = p[0] * std::cos(p[2]);
        p = {in_plan * std::cos(p[1]), in_plan * std::sin(p[1]), p[0] * std::sin(p[2])};
      }
      if (scan_.has_pose)
        p = turn_ * p + scan_.translation;
      if (invalid_ >= 0 && invalid[i] != 0)
        p.setConstant(std::numeric_limits<double>::quiet_NaN());
      std::memcpy(rows + i * row_size, p.data(), sizeof p);
    }
  }

  void placeIntensity(const std::vector<E57Bytes>& lists,
                      std::size_t first,
                      std::size_t n,
                      std::size_t row_size,
                      std::uint8_t* rows) const
  {
    Column intensity;
    values(lists, intensity_, first, n, intensity);
    for (std::size_t i = 0; i < n; ++i) {
      const auto value = static_cast<float>(intensity[i]);
      std::memcpy(rows + i * row_size, &value, sizeof value);
    }
  }

  void placeColour(const std::vector<E57Bytes>& lists,
                   std::size_t first,
                   std::size_t n,
                   std::size_t row_size,
                   std::uint8_t* rows) const
  {
    Column part;
    for (std::size_t k = 0; k < colour_.size(); ++k) {
      values(lists, colour_[k], first, n, part);
      const auto& limits = scan_.colour_limits[colour_.size() - 1 - k]; // red first
      for (std::size_t i = 0; i < n; ++i)
        rows[i * row_size + k] = colourByte(part[i], limits);
    }
    for (std::size_t i = 0; i < n; ++i)
      rows[i * row_size + 3] = 0xff;
  }

  E57Scan scan_;
  std::size_t first_row_;
  Eigen::Matrix3d turn_;
  bool is_spherical_ = false;
  bool has_colour_ = false;
  std::array<int, 3> xyz_{};    ///< fields; range, azimuth, elevation if spherical
  std::array<int, 3> colour_{}; ///< fields: blue, green, red
  int intensity_ = -1;
  int invalid_ = -1;
  std::vector<std::size_t> wanted_;
  std::vector<std::size_t> list_of_field_; ///< sorted: the order of the lists
  std::unique_ptr<E57Packets> packets_;
};

namespace {

E57Pages
openPages(const MappedFile& file, const std::string& path)
{
  try {
    return E57Pages(file);
  }
  catch (const ToolError& error) {
    refuse(path, error.what());
  }
}

std::vector<E57Entry>
entriesOf(const E57Pages& pages, const std::string& path)
{
  try {
    return readE57Scans(pages);
  }
  catch (const ToolError& error) {
    refuse(path, error.what());
  }
}

} // namespace

std::vector<E57Entry>
listE57Scans(const std::string& path)
{
  const MappedFile file(path);
  if (!looksLikeE57(file))
    throw ToolError("'" + path + "' is no E57 file");
  return entriesOf(openPages(file, path), path);
}

E57Reader::~E57Reader() = default;

E57Reader::E57Reader(const MappedFile& file,
                     const std::string& path,
                     const E57Choice& choice)
    : file_(file)
    , path_(path)
    , pages_(openPages(file, path))
{
  const std::vector<E57Entry> entries = entriesOf(pages_, path);
  if (entries.empty())
    refuse(path, "it holds no scan");
  if (choice.scan > entries.size())
    throw ToolError("'" + path + "' has no scan " + std::to_string(choice.scan) +
                    ", it holds " + std::to_string(entries.size()));
  for (const E57Entry& entry : entries)
    if (choice.scan == 0 || entry.scan.number == choice.scan)
      open(entry, choice.skip_broken);
  for (const E57Entry& entry : entries)
    if (choice.scan == 0 && !scans_.empty() && entry.problem.empty() &&
        entry.scan.points == 0)
      warnOnce(entry.scan.title() + " of '" + path + "' has 0 points");
  layFields();
}

void
E57Reader::open(const E57Entry& entry, bool skip_broken)
{
  try {
    if (!entry.problem.empty())
      throw ToolError(entry.problem);
    if (entry.scan.points == 0)
      return;
    constexpr std::uint64_t most = 0x7fffffff; // of an index
    if (entry.scan.points > most)
      throw ToolError("it is said to have " + std::to_string(entry.scan.points) +
                      " points, more than " + std::to_string(most) +
                      " cannot be indexed");
    auto scan = std::make_unique<Scan>(pages_, entry.scan, size());
    if (skip_broken)
      scan->packets().check();
    scans_.push_back(std::move(scan));
  }
  catch (const ToolError& error) {
    file_.checkWhole();
    const std::string title = entry.scan.title();
    if (!skip_broken)
      refuse(path_, title + ": " + error.what());
    warnOnce(title + " of '" + path_ + "' is left out: " + error.what());
  }
}

void
E57Reader::layFields()
{
  const auto any = [&](bool (Scan::*has)() const) {
    return std::any_of(scans_.begin(), scans_.end(),
                       [&](const auto& scan) { return ((*scan).*has)(); });
  };
  std::vector<std::string> more;
  if (any(&Scan::hasIntensity))
    more.emplace_back("intensity");
  if (any(&Scan::hasColour))
    more.emplace_back("rgb");
  fields_ = decodedFields(more);
}

std::size_t
E57Reader::size() const
{
  return scans_.empty() ? 0 : scans_.back()->end();
}

void
E57Reader::read(std::size_t first, std::size_t size, std::uint8_t* rows) const
{
  constexpr std::size_t coordinates = 3 * sizeof(double);
  const std::size_t row_size = coordinates + (fields_.size() - 3) * sizeof(float);
  std::size_t intensity = 0;
  std::size_t colour = 0;
  for (std::size_t f = 3; f < fields_.size(); ++f)
    (fields_[f].name == "rgb" ? colour : intensity) =
        coordinates + (f - 3) * sizeof(float);
  std::fill_n(rows, size * row_size, std::uint8_t{0});
  for (const auto& scan : scans_) {
    const std::size_t begin = std::max(first, scan->begin());
    const std::size_t end = std::min(first + size, scan->end());
    if (begin >= end)
      continue;
    try {
      scan->read(begin - scan->begin(), end - begin, row_size, intensity, colour,
                 rows + (begin - first) * row_size);
    }
    catch (const ToolError& error) {
      refuse(path_, scan->head().title() + ": " + error.what());
    }
  }
}

std::size_t
E57Reader::placeOf(std::size_t row) const
{
  for (const auto& scan : scans_)
    if (row < scan->end())
      return static_cast<std::size_t>(
          pages_.physical(scan->packets().placeOf(row - scan->begin())));
  return static_cast<std::size_t>(pages_.physical(pages_.size()));
}

std::vector<ScanStation>
E57Reader::stations() const
{
  std::vector<ScanStation> stations;
  for (const auto& scan : scans_) {
    const E57Scan& head = scan->head();
    if (!head.has_pose)
      return {};
    stations.push_back({scan->begin(), head.translation, head.rotation, head.name});
  }
  return stations;
}

} // namespace pcl::sedr::tools
