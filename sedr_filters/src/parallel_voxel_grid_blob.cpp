// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/field_access.h>
#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <array>
#include <map>
#include <numeric>

namespace pcl {

namespace {

constexpr std::size_t points_at_once = 4096;

/** @brief The points of one voxel, as the addresses of their bytes. */
class VoxelBytes {
public:
  VoxelBytes(const pcl::PCLPointCloud2& cloud,
             const pcl::index_t* first,
             const pcl::index_t* last)
      : cloud_(cloud)
      , first_(first)
      , last_(last)
  {}

  template <typename FunctionT>
  void forEach(FunctionT f) const
  {
    for (const auto* i = first_; i != last_; ++i)
      f(cloud_.data.data() + static_cast<std::size_t>(*i) * cloud_.point_step);
  }

  double size() const { return static_cast<double>(last_ - first_); }

private:
  const pcl::PCLPointCloud2& cloud_;
  const pcl::index_t* first_;
  const pcl::index_t* last_;
};

bool
isColour(const pcl::PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         sedr::fieldSize(field.datatype) == sizeof(std::uint32_t);
}

bool
isLabel(const pcl::PCLPointField& field)
{
  return field.name == "label" || field.name == "room";
}

/** @brief The mean by channel, truncated as pcl::CentroidPoint does. */
void
meanColour(const VoxelBytes& points, std::size_t offset, std::uint8_t* to)
{
  std::array<std::uint64_t, sizeof(std::uint32_t)> sums{};
  points.forEach([&](const std::uint8_t* point) {
    for (std::size_t c = 0; c < sums.size(); ++c)
      sums[c] += point[offset + c];
  });
  for (std::size_t c = 0; c < sums.size(); ++c)
    to[offset + c] =
        static_cast<std::uint8_t>(static_cast<double>(sums[c]) / points.size());
}

/** @brief The most frequent value, the smallest of equally frequent ones. */
void
majority(const VoxelBytes& points,
         std::size_t offset,
         std::uint8_t datatype,
         std::uint8_t* to)
{
  std::map<double, std::size_t> votes;
  points.forEach([&](const std::uint8_t* point) {
    const double value = sedr::readField(point + offset, datatype);
    ++votes[std::isnan(value) ? 0 : value];
  });
  const auto most =
      std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
        return a.second < b.second;
      });
  sedr::writeField(to + offset, datatype, most->first);
}

void
meanNumber(const VoxelBytes& points,
           std::size_t offset,
           std::uint8_t datatype,
           std::uint8_t* to)
{
  double sum = 0;
  points.forEach([&](const std::uint8_t* point) {
    sum += sedr::readField(point + offset, datatype);
  });
  sedr::writeField(to + offset, datatype, sum / points.size());
}

/** @brief Writes the means of all fields, or of x, y and z alone, to the point at `to`.
 */
void
meanPoint(const std::vector<pcl::PCLPointField>& fields,
          bool all_fields,
          const VoxelBytes& points,
          std::uint8_t* to)
{
  for (const auto& field : fields) {
    const bool is_coordinate =
        field.name == "x" || field.name == "y" || field.name == "z";
    if (field.name == "_" || (!all_fields && !is_coordinate))
      continue;
    const std::size_t size = sedr::fieldSize(field.datatype);
    for (std::size_t k = 0; k < std::max<std::size_t>(field.count, 1); ++k) {
      const std::size_t offset = field.offset + k * size;
      if (isColour(field))
        meanColour(points, offset, to);
      else if (isLabel(field))
        majority(points, offset, field.datatype, to);
      else
        meanNumber(points, offset, field.datatype, to);
    }
  }
}

const pcl::PCLPointField*
findField(const std::vector<pcl::PCLPointField>& fields, const std::string& name)
{
  const auto it = std::find_if(fields.begin(), fields.end(),
                               [&](const auto& f) { return f.name == name; });
  return it == fields.end() ? nullptr : &*it;
}

/** @brief Makes the normal at `point` unit length, if there is one and it is not null.
 */
void
normalise(const std::vector<pcl::PCLPointField>& fields, std::uint8_t* point)
{
  std::array<const pcl::PCLPointField*, 3> normal{findField(fields, "normal_x"),
                                                  findField(fields, "normal_y"),
                                                  findField(fields, "normal_z")};
  double square = 0;
  for (const auto* f : normal) {
    if (!f)
      return;
    const double value = sedr::readField(point + f->offset, f->datatype);
    square += value * value;
  }
  if (!(square > 0))
    return;
  for (const auto* f : normal)
    sedr::writeField(point + f->offset, f->datatype,
                     sedr::readField(point + f->offset, f->datatype) /
                         std::sqrt(square));
}

/** @brief What keeps `cloud` from being read, a sentence; empty if nothing does. */
std::string
layoutProblem(const pcl::PCLPointCloud2& cloud)
{
  const std::size_t size = std::size_t{cloud.width} * cloud.height;
  if (cloud.data.size() < size * cloud.point_step)
    return "the cloud holds " + std::to_string(cloud.data.size()) + " bytes, " +
           std::to_string(size) + " points of " + std::to_string(cloud.point_step) +
           " bytes need " + std::to_string(size * cloud.point_step);
  if (size > static_cast<std::size_t>(std::numeric_limits<pcl::index_t>::max()))
    return "the cloud has " + std::to_string(size) +
           " points, more than indices can count";
  for (const char* name : {"x", "y", "z"}) {
    const auto* field = findField(cloud.fields, name);
    if (!field)
      return std::string("the cloud has no field '") + name + "'";
  }
  for (const auto& field : cloud.fields) {
    const std::size_t bytes =
        sedr::fieldSize(field.datatype) * std::max<std::size_t>(field.count, 1);
    if (field.name != "_" && field.offset + bytes > cloud.point_step)
      return "field '" + field.name + "' ends at byte " +
             std::to_string(field.offset + bytes) + " of points of " +
             std::to_string(cloud.point_step) + " bytes";
  }
  return {};
}

std::vector<Eigen::Vector3f>
readCoordinates(const pcl::PCLPointCloud2& cloud, unsigned threads)
{
  const std::array<const pcl::PCLPointField*, 3> xyz{findField(cloud.fields, "x"),
                                                     findField(cloud.fields, "y"),
                                                     findField(cloud.fields, "z")};
  std::vector<Eigen::Vector3f> points(std::size_t{cloud.width} * cloud.height);
  sedr::parallelBlocks(
      points.size(), points_at_once, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          for (int axis = 0; axis < 3; ++axis) {
            const auto* field = xyz[static_cast<std::size_t>(axis)];
            points[i][axis] = static_cast<float>(sedr::readField(
                cloud.data.data() + i * cloud.point_step + field->offset,
                field->datatype));
          }
      });
  return points;
}

} // namespace

void
ParallelVoxelGrid<pcl::PCLPointCloud2>::filter(PCLPointCloud2& output)
{
  clearError();
  if (!input_) {
    fail("ParallelVoxelGrid", "no input cloud was set");
    clearLayout();
    removed_indices_->clear();
    output = PCLPointCloud2();
    return;
  }
  Filter<pcl::PCLPointCloud2>::filter(output);
}

void
ParallelVoxelGrid<pcl::PCLPointCloud2>::applyFilter(PCLPointCloud2& output)
{
  clearError();
  clearLayout();
  removed_indices_->clear();
  output = PCLPointCloud2();
  output.fields = input_->fields;
  output.point_step = input_->point_step;
  output.is_bigendian = input_->is_bigendian;
  output.height = 1;
  output.is_dense = true;

  const auto& cloud = *input_;
  std::string problem = parameterProblem();
  if (problem.empty())
    problem = layoutProblem(cloud);
  if (problem.empty())
    problem = sedr::indicesProblem(*indices_, std::size_t{cloud.width} * cloud.height);
  const auto* limited = findField(cloud.fields, getFilterFieldName());
  if (problem.empty() && !getFilterFieldName().empty() && !limited)
    problem = "the points have no field '" + getFilterFieldName() + "' to filter by";
  if (!problem.empty()) {
    fail("ParallelVoxelGrid", problem);
    if (extract_removed_indices_)
      *removed_indices_ =
          sedr::indicesInRange(*indices_, std::size_t{cloud.width} * cloud.height);
    return;
  }

  pcl::Indices selected = *indices_;
  if (limited)
    selected.erase(
        std::remove_if(selected.begin(), selected.end(),
                       [&](pcl::index_t i) {
                         const std::size_t at =
                             static_cast<std::size_t>(i) * cloud.point_step;
                         return !passesLimits(sedr::readField(
                             &cloud.data[at + limited->offset], limited->datatype));
                       }),
        selected.end());
  const auto coordinates = readCoordinates(cloud, getNumberOfThreads());
  const sedr::PointView points(coordinates.empty() ? nullptr : coordinates[0].data(),
                               sizeof(Eigen::Vector3f), coordinates.size());
  auto partition =
      sedr::partitionVoxels(points, selected, inverseLeaf(), getNumberOfThreads());
  finishPartition(points, partition);

  output.width = static_cast<std::uint32_t>(partition.size());
  output.row_step = output.width * output.point_step;
  output.data.assign(partition.size() * output.point_step, 0);
  sedr::parallelBlocks(partition.size(), points_at_once, getNumberOfThreads(),
                       [&](std::size_t begin, std::size_t end) {
                         for (std::size_t v = begin; v < end; ++v) {
                           const auto* order = partition.order.data();
                           auto* to = output.data.data() + v * output.point_step;
                           meanPoint(output.fields, getDownsampleAllData(),
                                     VoxelBytes(cloud, order + partition.begin[v],
                                                order + partition.begin[v + 1]),
                                     to);
                           if (getDownsampleAllData())
                             normalise(output.fields, to);
                         }
                       });
  if (extract_removed_indices_)
    *removed_indices_ = removedIndices(*indices_, partition, points.size());
}

} // namespace pcl
