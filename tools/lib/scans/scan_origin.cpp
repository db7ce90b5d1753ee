// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/input_file.h"
#include "run_tool.h"
#include "scan_file.h"
#include "sedr_filters/src/base/quantiles.h"
#include "tool_error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace pcl::sedr::tools {

namespace {

constexpr double float_step = 1.0 / (1 << 23); // between floats, relative
constexpr double coarsest = 0.001;             // metres, resolution of floats
constexpr double far_away = 1000;              // metres, where floats are 0.1 mm apart
constexpr double farthest_grid = 1e8;          // metres, beyond all map grids
constexpr std::size_t sample_size = 20000;

/** @brief Returns a length with six significant digits at most, which PCL's writers
 * keep of VIEWPOINT, but no finer than whole metres. */
double
inSixDigits(double length)
{
  double step = 1;
  while (std::abs(length) >= 1e6 * step)
    step *= 10;
  return std::round(length / step) * step;
}

/** @brief Returns the median of the largest coordinate of each point, relative to
 * `shift`. */
double
farthestFrom(const Eigen::Vector3d& shift, const ScanPlaces& places)
{
  std::vector<double> sizes;
  for (std::size_t i = 0; i < places[0].size(); ++i)
    sizes.push_back(std::max({std::abs(places[0][i] - shift.x()),
                              std::abs(places[1][i] - shift.y()),
                              std::abs(places[2][i] - shift.z())}));
  return middleValue(sizes);
}

/** @brief Returns the median of the points, rounded, on axes where it is far away. */
Eigen::Vector3d
roundPlaceNear(const ScanPlaces& places)
{
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double middle = middleValue(places[axis]);
    if (std::abs(middle) > far_away && std::abs(middle) < farthest_grid)
      shift[static_cast<Eigen::Index>(axis)] = inSixDigits(middle);
  }
  return shift;
}

[[noreturn]] void
refuseTooLarge(const std::string& path, double farthest, const ScanPlaces& places)
{
  std::ostringstream sentence;
  sentence.precision(15);
  sentence << "the coordinates of '" << path << "' are too large: at "
           << std::floor(farthest) << " m a float resolves no finer than "
           << std::ceil(farthest * float_step * 1000)
           << " mm; if the unit is another, such as the millimetre, scale them (--unit "
              "0.001), else subtract an origin first, say (";
  for (std::size_t axis = 0; axis < 3; ++axis)
    sentence << (axis > 0 ? ", " : "")
             << std::round(middleValue(places[axis]) / 1000) * 1000;
  throw ToolError(sentence.str() + ") m");
}

/** @brief A line of a file of positions. */
struct PositionLine {
  Eigen::Vector3d place;
  std::optional<std::size_t> points;
};

std::optional<PositionLine>
positionIn(const std::vector<std::string_view>& words)
{
  PositionLine line;
  if (words.size() != 3 && words.size() != 4)
    return {};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!isNumber(words[axis], line.place[static_cast<Eigen::Index>(axis)]))
      return {};
  if (!line.place.cast<float>().allFinite())
    return {};
  if (words.size() == 4 && !isNumber(words[3], line.points.emplace()))
    return {};
  return line;
}

/** @brief Reads a file of positions. A position without a number of points must be the
 * only one. */
std::vector<PositionLine>
readPositionLines(const std::string& path)
{
  const InputFile file(path);
  LineReader reader(file);
  std::vector<PositionLine> lines;
  std::string_view text;
  for (std::size_t number = 1; reader.next(text); ++number) {
    const std::vector<std::string_view> words = wordsOf(text);
    if (words.empty() || words.front().front() == '#')
      continue;
    const std::optional<PositionLine> line = positionIn(words);
    if (!line)
      throw ToolError("line " + std::to_string(number) + " of '" + path +
                      "' is not x y z and a number of points");
    lines.push_back(*line);
  }
  if (lines.empty())
    throw ToolError("'" + path + "' has no positions");
  for (const PositionLine& line : lines)
    if (lines.size() > 1 && !line.points)
      throw ToolError("of " + std::to_string(lines.size()) + " positions in '" + path +
                      "' each must tell its number of points");
  return lines;
}

} // namespace

bool
isKeptByPcl(const Eigen::Vector3d& place)
{
  return place == place.unaryExpr(&inSixDigits);
}

void
ScanFile::addPlaces(std::size_t first, std::size_t size, ScanPlaces& places) const
{
  const std::array<const StoredField*, 3> xyz{row_.find("x"), row_.find("y"),
                                              row_.find("z")};
  Chunk chunk;
  chunk.first = first;
  for (std::size_t done = 0; done < size; done += chunk.size) {
    content_.points->next(chunk, size - done);
    for (std::size_t i = 0; i < chunk.size; ++i) {
      Eigen::Vector3d p;
      for (std::size_t axis = 0; axis < 3; ++axis)
        p[static_cast<Eigen::Index>(axis)] =
            unit_ * xyz[axis]->valueIn(&chunk.rows[i * row_.size]);
      for (std::size_t axis = 0; axis < 3 && p.allFinite(); ++axis)
        places[axis].push_back(p[static_cast<Eigen::Index>(axis)]);
    }
  }
}

ScanPlaces
ScanFile::samplePlaces() const
{
  constexpr std::size_t run = 100; // adjacent rows are read at once
  ScanPlaces places;
  const std::size_t step = std::max<std::size_t>(1, size() / (sample_size / run));
  if (size() > sample_size)
    for (std::size_t first = 0; first + run <= size(); first += step)
      addPlaces(first, run, places);
  // Reads all of a small scan, and enough of one with hardly any finite points.
  const bool is_enough = places[0].size() >= run;
  if (!is_enough)
    places = ScanPlaces();
  for (std::size_t first = 0;
       !is_enough && first < size() && places[0].size() < sample_size;
       first += sample_size)
    addPlaces(first, std::min(sample_size, size() - first), places);
  if (places[0].empty())
    throw ToolError("'" + path_ + "' has no finite point among its " +
                    std::to_string(size()));
  return places;
}

bool
ScanFile::takeOriginFromViewpoint(const ScanPlaces& places)
{
  if (!content_.may_be_local || !content_.viewpoint)
    return false;
  const Eigen::Vector3d place = turn_ * *content_.viewpoint;
  const double size = place.lpNorm<Eigen::Infinity>();
  const bool is_origin = size < farthest_grid &&
                         size * std::min(1.0, unit_) > far_away && isKeptByPcl(place) &&
                         farthestFrom(Eigen::Vector3d::Zero(), places) < far_away;
  if (is_origin) {
    content_.counted_from.place = place;
    content_.viewpoint.reset();
  }
  return is_origin;
}

void
ScanFile::settleOrigin(const ScanSettings& settings)
{
  const ScanPlaces places = samplePlaces();
  const auto isFloat = [&](const char* name) {
    return row_.find(name)->datatype == pcl::PCLPointField::FLOAT32;
  };
  const bool are_floats = isFloat("x") && isFloat("y") && isFloat("z");
  const bool takes_viewpoint = takeOriginFromViewpoint(places);
  const double given = farthestFrom(Eigen::Vector3d::Zero(), places);
  const bool finds_shift = settings.shifts && !settings.origin && !are_floats;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  if (settings.origin)
    shift = settings.origin->place - content_.counted_from.place;
  else if (finds_shift)
    shift = roundPlaceNear(places);
  // An origin cannot restore the precision that floats have lost.
  const double farthest = are_floats ? std::max(given, farthestFrom(shift, places))
                                     : farthestFrom(shift, places);
  if (farthest * float_step > coarsest)
    refuseTooLarge(path_, farthest, places);
  shift_ = shift;
  origin_ = {content_.counted_from.place + shift};
  if ((finds_shift && !shift.isZero(0)) || (takes_viewpoint && !settings.origin))
    tellOnce("'" + path_ + "' lies far from 0: its coordinates are counted from (" +
             origin_.text(", ") + ") m, which every result tells as its origin");
}

ScanPositions
ScanFile::positions() const
{
  if (!positions_.empty())
    return positionsIn(positions_, size());
  ScanPositions positions;
  for (const ScanStation& station : content_.points->stations())
    positions.push_back({station.first_row, inMetres(station.position)});
  if (positions.empty() && content_.viewpoint)
    positions.push_back({0, inMetres(*content_.viewpoint)});
  return positions;
}

ScanPositions
ScanFile::positionsIn(const std::string& path, std::size_t rows) const
{
  ScanPositions positions;
  std::size_t row = 0;
  for (const PositionLine& line : readPositionLines(path)) {
    positions.push_back({row, inMetres(line.place)});
    row += line.points.value_or(rows);
  }
  if (row != rows)
    throw ToolError("the positions in '" + path + "' are of " + std::to_string(row) +
                    " points, the scan has " + std::to_string(rows));
  return positions;
}

} // namespace pcl::sedr::tools
