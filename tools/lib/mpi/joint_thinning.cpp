// SPDX-License-Identifier: BSD-3-Clause
#include "joint_thinning.h"

#include "joint_step.h"
#include "voxel_shares.h"

#include <cstring>
#include <numeric>

namespace pcl::sedr::tools {

namespace {

template <typename T>
std::string
bytesOf(const std::vector<T>& list)
{
  return {reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T)};
}

template <typename T>
std::vector<T>
listOf(const std::string& bytes)
{
  std::vector<T> list(bytes.size() / sizeof(T));
  std::memcpy(static_cast<void*>(list.data()), bytes.data(), list.size() * sizeof(T));
  return list;
}

/** @brief Shares a number of every rank with all ranks. */
std::vector<std::size_t>
numbersOfAll(RankMail& mail, std::size_t mine)
{
  std::string all;
  for (const std::string& one : mail.gather(bytesOf(std::vector<std::size_t>{mine})))
    all += one;
  return listOf<std::size_t>(mail.fromFirst(all));
}

/** @brief A run of thinTogether(). */
class JointThinning {
public:
  JointThinning(RankMail& mail, const ThinOrder& order, unsigned threads)
      : mail_(mail)
      , order_(order)
      , threads_(threads)
      , part_(order, threads)
      , held_(textOf(order.ranges))
  {}

  ThinnedScan run()
  {
    ThinnedScan scan;
    scan.size = order_.rows;
    together(mail_, held_, [this] { part_.thin(true); });
    scan.problem = checkScan();
    if (!scan.problem.empty())
      return scan;
    together(mail_, held_, [this] {
      if (part_.hasStopped()) // a part of the scan may be large, but not the whole
        part_.thin(false);
      voxels_ = part_.takeVoxels();
    });
    addUpShare();
    scan.stray_limit = order_.removes_strays ? strayLimit() : 0;
    collect(meansOfShare(scan.stray_limit), *scan.points);
    collect(coordinatesOf(part_.excerpt()), *scan.excerpt);
    return scan;
  }

private:
  /** @brief Returns the problem that ScanSample finds in the whole scan, on every
   * rank. */
  std::string checkScan()
  {
    const auto sum = [](const std::vector<std::size_t>& numbers, std::size_t n) {
      return std::accumulate(numbers.begin(),
                             numbers.begin() + static_cast<std::ptrdiff_t>(n),
                             std::size_t{0});
    };
    const auto n = static_cast<std::size_t>(mail_.size());
    const bool has_stopped =
        sum(numbersOfAll(mail_, part_.hasStopped() ? 1 : 0), n) > 0;
    if (has_stopped)
      together(mail_, held_, [this] { part_.count(); });
    const std::vector<std::size_t> finite = numbersOfAll(mail_, part_.finite());
    std::vector<Eigen::Vector3f> sample = part_.sample();
    if (has_stopped || sum(finite, n) < order_.rows)
      together(mail_, held_, [&] {
        const auto rank = static_cast<std::size_t>(mail_.rank());
        sample = part_.sampleAfter(sum(finite, rank));
      });
    ScanSample whole(order_.rows);
    const std::vector<std::string> samples = mail_.gather(bytesOf(sample));
    for (std::size_t r = 0; r < samples.size(); ++r)
      whole.join(listOf<Eigen::Vector3f>(samples[r]), finite[r]);
    return mail_.fromFirst(mail_.isFirst() ? whole.problem() : std::string());
  }

  std::vector<VoxelKey> borders()
  {
    std::vector<VoxelKey> keys;
    for (const std::string& some : mail_.gather(bytesOf(keysOf(voxels_)))) {
      const auto list = listOf<VoxelKey>(some);
      keys.insert(keys.end(), list.begin(), list.end());
    }
    const auto ranks = static_cast<std::size_t>(mail_.size());
    return listOf<VoxelKey>(mail_.fromFirst(bytesOf(bordersOf(keys, ranks))));
  }

  /** @brief Sums the voxels of this rank's share. */
  void addUpShare()
  {
    std::vector<std::size_t> begins = sharesOf(voxels_, borders());
    begins.resize(static_cast<std::size_t>(mail_.size()) + 1, voxels_.size());
    std::vector<RankMail::Parcel> parcels;
    for (std::size_t r = 0; r + 1 < begins.size(); ++r)
      parcels.push_back(
          {voxels_.data() + begins[r], (begins[r + 1] - begins[r]) * sizeof(VoxelSum)});
    std::vector<std::string> received = mail_.exchange(parcels);
    const auto rank = static_cast<std::size_t>(mail_.rank());
    voxels_.resize(begins[rank + 1]);
    voxels_.erase(voxels_.begin(),
                  voxels_.begin() + static_cast<std::ptrdiff_t>(begins[rank]));
    together(mail_, held_, [&] {
      VoxelSums sums(order_.inverse_leaf.array());
      sums.add(voxels_);
      std::vector<VoxelSum>().swap(voxels_);
      for (std::string& some : received) {
        sums.add(listOf<VoxelSum>(some));
        std::string().swap(some);
      }
      voxels_ = sums.take(threads_);
    });
  }

  /** @brief Returns the stray limit of VoxelCensus over all ranks, on every rank. */
  std::uint32_t strayLimit()
  {
    VoxelCensus mine;
    for (const VoxelSum& voxel : voxels_)
      mine.add(voxel.code, voxel.count);
    const std::vector<std::string> cubes = mail_.gather(bytesOf(mine.cubes()));
    const std::vector<std::string> points = mail_.gather(bytesOf(mine.pointsByCount()));
    VoxelCensus all;
    for (std::size_t r = 0; r < cubes.size(); ++r)
      all.join({listOf<VoxelCensus::Cube>(cubes[r]), listOf<std::uint64_t>(points[r])});
    const std::vector<std::uint32_t> least{all.minPoints()};
    return listOf<std::uint32_t>(mail_.fromFirst(bytesOf(least))).front();
  }

  /** @brief Returns the means of this rank's voxels with at least that many points,
   * three floats each. */
  std::vector<float> meansOfShare(std::uint32_t min_points)
  {
    const VoxelFrame frame(order_.inverse_leaf.array());
    std::vector<float> means;
    means.reserve(3 * voxels_.size());
    for (const VoxelSum& voxel : voxels_) {
      if (voxel.count < min_points)
        continue;
      const Eigen::Vector3f mean = frame.mean(voxel);
      means.insert(means.end(), mean.data(), mean.data() + 3);
    }
    std::vector<VoxelSum>().swap(voxels_);
    return means;
  }

  static std::vector<float> coordinatesOf(const std::vector<Eigen::Vector3f>& points)
  {
    std::vector<float> coordinates;
    coordinates.reserve(3 * points.size());
    for (const auto& p : points)
      coordinates.insert(coordinates.end(), p.data(), p.data() + 3);
    return coordinates;
  }

  /** @brief Appends the points of all ranks, in order, on rank 0. Each rank sends only
   * after the previous one is done. */
  template <typename Points>
  void collect(const std::vector<float>& mine, Points& points)
  {
    if (!mail_.isFirst()) {
      mail_.send(0, Subject::Step, mine.data(), mine.size() * sizeof(float));
      return;
    }
    append(mine, points);
    for (int r = 1; r < mail_.size(); ++r)
      append(listOf<float>(mail_.receive(r, Subject::Step)), points);
  }

  template <typename Points>
  static void append(const std::vector<float>& coordinates, Points& points)
  {
    points.reserve(points.size() + coordinates.size() / 3);
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
      points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }

  RankMail& mail_;
  const ThinOrder& order_;
  unsigned threads_;
  PartOfScan part_;
  std::string held_; ///< description for messages
  std::vector<VoxelSum> voxels_;
};

} // namespace

ThinnedScan
thinTogether(RankMail& mail, const ThinOrder& order, unsigned threads)
{
  return JointThinning(mail, order, threads).run();
}

} // namespace pcl::sedr::tools
