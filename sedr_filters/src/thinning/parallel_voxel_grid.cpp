// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include "../base/field_access.h"
#include "../base/number_text.h"
#include "../voxels/voxel_sums.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/impl/parallel_voxel_grid.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace pcl::sedr {
namespace {

constexpr std::size_t channels = 4;

bool
isColour(const pcl::PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         fieldSize(field.datatype) == channels;
}

bool
isLabel(const pcl::PCLPointField& field)
{
  return field.name == "label" || field.name == "room" || field.name == "owner";
}

/** @brief Averages fields of any type over the rows of each voxel: numbers in double,
 * `rgb` and `rgba` by channel, `label`, `room` and `owner` by majority; normals have
 * unit length.
 */
class FieldMeans {
public:
  /** @param fields the fields to average; the others of a row are not changed */
  FieldMeans(const std::vector<pcl::PCLPointField>& fields, std::size_t voxels)
  {
    for (const char* name : {"normal_x", "normal_y", "normal_z"})
      if (const auto* field = findField(fields, name))
        normal_.push_back(*field);
    for (const auto& field : fields)
      for (std::size_t k = 0; k < std::max<std::size_t>(field.count, 1); ++k) {
        const Kind kind = isColour(field)  ? Kind::Colour
                          : isLabel(field) ? Kind::Label
                                           : Kind::Number;
        std::size_t& used = kind == Kind::Label ? votes_a_voxel_ : sums_a_voxel_;
        values_.push_back(
            {kind, field.offset + k * fieldSize(field.datatype), field.datatype, used});
        used += kind == Kind::Colour ? channels : 1;
      }
    sums_.resize(voxels * sums_a_voxel_, 0);
    votes_.resize(voxels * votes_a_voxel_);
  }

  void add(std::size_t voxel, const std::uint8_t* row)
  {
    double* sums = sums_.data() + voxel * sums_a_voxel_;
    for (const Value& value : values_) {
      const std::uint8_t* where = row + value.offset;
      if (value.kind == Kind::Colour)
        for (std::size_t c = 0; c < channels; ++c)
          sums[value.place + c] += where[c];
      else {
        const double number = readField(where, value.datatype);
        if (value.kind == Kind::Number)
          sums[value.place] += number;
        else
          ++votes_[voxel * votes_a_voxel_ + value.place]
                  [std::isnan(number) ? 0 : number];
      }
    }
  }

  /** @brief Writes the means of the `count` rows added to a voxel. */
  void write(std::size_t voxel, std::size_t count, std::uint8_t* row) const
  {
    const double* sums = sums_.data() + voxel * sums_a_voxel_;
    const auto size = static_cast<double>(count);
    for (const Value& value : values_) {
      std::uint8_t* where = row + value.offset;
      if (value.kind == Kind::Number)
        writeField(where, value.datatype, sums[value.place] / size);
      else if (value.kind == Kind::Colour) // truncated, as pcl::CentroidPoint does
        for (std::size_t c = 0; c < channels; ++c)
          where[c] = static_cast<std::uint8_t>(sums[value.place + c] / size);
      else { // the most frequent, the smallest of equally frequent ones
        const auto& votes = votes_[voxel * votes_a_voxel_ + value.place];
        const auto most = std::max_element(
            votes.begin(), votes.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
        writeField(where, value.datatype, most->first);
      }
    }
    normalise(row);
  }

private:
  /** @brief Normalises the normal, if there is one and it is not zero. */
  void normalise(std::uint8_t* row) const
  {
    double square = 0;
    for (const auto& field : normal_)
      square += std::pow(readField(row + field.offset, field.datatype), 2);
    if (normal_.size() != 3 || !(square > 0))
      return;
    for (const auto& field : normal_)
      writeField(row + field.offset, field.datatype,
                 readField(row + field.offset, field.datatype) / std::sqrt(square));
  }

  enum class Kind { Number, Colour, Label };

  /** @brief One value of a row. */
  struct Value {
    Kind kind;
    std::size_t offset; ///< offset in the row, bytes
    std::uint8_t datatype;
    std::size_t place; ///< position among the sums or votes of a voxel
  };

  std::vector<Value> values_;
  std::vector<pcl::PCLPointField> normal_;
  std::size_t sums_a_voxel_ = 0;
  std::size_t votes_a_voxel_ = 0;
  std::vector<double> sums_;
  std::vector<std::map<double, std::size_t>> votes_;
};

constexpr std::array<const char*, 3> axes{"x", "y", "z"};

bool
isCoordinate(const pcl::PCLPointField& field)
{
  return field.name == "x" || field.name == "y" || field.name == "z";
}

/** @brief Checks whether the voxel sums contain the mean of a field. */
bool
isSummed(const pcl::PCLPointField& field)
{
  return isCoordinate(field) && field.datatype == pcl::PCLPointField::FLOAT32 &&
         field.count <= 1;
}

/** @brief Returns what is wrong with the fields of the rows; empty if nothing is. */
std::string
fieldsProblem(const RowSource& source)
{
  for (const char* name : axes)
    if (!findField(source.fields(), name))
      return std::string("the cloud has no field '") + name + "'";
  for (const auto& field : source.fields()) {
    const std::size_t end = field.offset + fieldSize(field.datatype) *
                                               std::max<std::size_t>(field.count, 1);
    if (field.name != "_" && end > source.rowSize())
      return "field '" + field.name + "' ends at byte " + std::to_string(end) +
             " of points of " + std::to_string(source.rowSize()) + " bytes";
  }
  return {};
}

/** @brief Writes the means of those of x, y and z that are FLOAT32. */
void
writePlaces(const VoxelSums& sums,
            const std::vector<pcl::PCLPointField>& fields,
            std::size_t row_size,
            std::uint8_t* rows,
            unsigned threads)
{
  std::array<const pcl::PCLPointField*, 3> summed{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    summed[axis] = findField(fields, axes[axis]);
  sums.forEach(
      [&](const VoxelSum& voxel, std::size_t place) {
        const Eigen::Vector3f mean = sums.frame().mean(voxel);
        for (std::size_t axis = 0; axis < 3; ++axis)
          if (isSummed(*summed[axis]))
            std::memcpy(rows + place * row_size + summed[axis]->offset,
                        &mean[static_cast<Eigen::Index>(axis)], sizeof(float));
      },
      threads);
}

} // namespace

/** @brief Returns why the rows cannot be thinned, as a sentence; empty if they can. */
std::string
VoxelGridSettings::problemOf(const RowSource& source, const pcl::Indices* indices) const
{
  std::string problem = positiveProblem({{"the leaf along x", leaf_size_.x()},
                                         {"the leaf along y", leaf_size_.y()},
                                         {"the leaf along z", leaf_size_.z()}});
  if (problem.empty() && !inverseLeaf().allFinite())
    problem = "the leaf of " + numberText(leaf_size_.minCoeff()) +
              " m is too small for floats";
  if (problem.empty())
    problem = source.problem();
  if (!problem.empty())
    return problem;
  if (source.size() >
      static_cast<std::size_t>(std::numeric_limits<pcl::index_t>::max()))
    return "the cloud has " + std::to_string(source.size()) +
           " points, more than indices can count";
  problem = fieldsProblem(source);
  if (!problem.empty())
    return problem;
  return indices ? indicesProblem(*indices, source.size()) : std::string();
}

std::string
VoxelGridSettings::thin(const RowSource& source,
                        const pcl::Indices* indices,
                        const ThinnedRows& output,
                        pcl::Indices* removed)
{
  using Piece = RowSource::Piece;
  strays_ = 0;
  const std::string problem = problemOf(source, indices);
  if (!problem.empty())
    return problem;
  VoxelSums sums(inverseLeaf());
  RowCoordinates coordinates(source.fields(), source.rowSize());
  source.forEachPiece([&](const Piece& piece) {
    sums.add(coordinates.of(piece.rows, piece.size, threads_), threads_, indices);
    return true;
  });
  if (removes_strays_)
    strays_ = sums.dropStrays(threads_);
  const std::size_t size = sums.arrange(min_points_per_voxel_);
  std::uint8_t* const rows = output.make(size);
  writePlaces(sums, output.fields, output.row_size, rows, threads_);

  std::vector<pcl::PCLPointField> others;
  if (!output.only_places)
    for (const auto& field : source.fields())
      if (field.name != "_" && !isSummed(field) &&
          (downsample_all_data_ || isCoordinate(field)))
        others.push_back(field);
  if (others.empty() && !removed)
    return {};
  sums.index();
  FieldMeans means(others, size);
  std::vector<bool> stays(removed ? source.size() : 0, false);
  source.forEachPiece([&](const Piece& piece) {
    const PointView points = coordinates.of(piece.rows, piece.size, threads_);
    if (!others.empty())
      sums.visit(points, indices, threads_, [&](std::size_t voxel, std::size_t i) {
        means.add(voxel, piece.rows + i * source.rowSize());
      });
    for (std::size_t i = 0; removed && i < piece.size; ++i)
      stays[piece.first + i] = sums.find(points[i]) >= 0;
    return true;
  });
  sums.forEach(
      [&](const VoxelSum& voxel, std::size_t place) {
        means.write(place, voxel.count, rows + place * output.row_size);
      },
      threads_);
  for (std::size_t k = 0; removed && k < (indices ? indices->size() : stays.size());
       ++k)
    if (const auto i = indices ? (*indices)[k] : static_cast<pcl::index_t>(k);
        !stays[static_cast<std::size_t>(i)])
      removed->push_back(i);
  return {};
}

} // namespace pcl::sedr

void
pcl::ParallelVoxelGrid<pcl::PCLPointCloud2>::filter(const sedr::RowSource& source,
                                                    PCLPointCloud2& output)
{
  clearError();
  PCLPointCloud2 thinned;
  thinned.fields = source.fields();
  thinned.point_step = static_cast<pcl::uindex_t>(source.rowSize());
  thinned.height = 1;
  thinned.is_dense = true;
  const auto make = [&](std::size_t n) {
    thinned.width = static_cast<std::uint32_t>(n);
    thinned.row_step = thinned.width * thinned.point_step;
    thinned.data.resize(n * thinned.point_step);
    return thinned.data.data();
  };
  const std::string problem =
      thin(source, nullptr, {thinned.fields, source.rowSize(), make});
  output = std::move(thinned);
  if (!problem.empty())
    fail("ParallelVoxelGrid", problem);
}

PCL_INSTANTIATE(ParallelVoxelGrid, SEDR_POINT_TYPES)
