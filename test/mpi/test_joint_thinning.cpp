// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/joint_step.h"
#include "mpi/joint_thinning.h"
#include "scan_file.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include "sedr_segmentation/src/refit/plan_refit.h"
#include "sedr_segmentation/src/scan/scan_excerpt.h"
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <random>

namespace {

using namespace pcl::sedr;
using namespace pcl::sedr::tools;
using programs::pcdBytes;
using programs::TemporaryFolder;
using programs::writeFile;
using Points = std::vector<std::vector<float>>;

constexpr std::size_t excerpt_step = 7;

/** A room of 6 x 6 x 2 m; one in `nans` points is not finite, none if 0. */
Points
roomPoints(std::size_t n, unsigned seed, std::size_t nans = 0)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(-3, 3);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const float x = coordinate(random);
    const float y = coordinate(random);
    points.push_back({x, y, coordinate(random) / 3});
    if (nans > 0 && i % nans == 7)
      points.back()[i % 3] = std::numeric_limits<float>::quiet_NaN();
  }
  return points;
}

std::string
asciiPcd(const Points& points)
{
  const std::string n = std::to_string(points.size());
  std::string text = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                     "WIDTH " +
                     n + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + n +
                     "\nDATA ascii\n";
  for (const auto& p : points) {
    char line[80];
    std::snprintf(line, sizeof line, "%.9g %.9g %.9g\n", static_cast<double>(p[0]),
                  static_cast<double>(p[1]), static_cast<double>(p[2]));
    text += line;
  }
  return text;
}

/** A folder that rank 0 fills with scans, which all ranks thin. */
class JointThinningTest : public ::testing::Test {
protected:
  JointThinningTest()
      : mail_{boost::mpi::communicator()}
      , path_(mail_.fromFirst(folder_.path().string()))
  {}

  ~JointThinningTest() override
  {
    mail_.fromFirst(""); // the folder is kept until all are done
    mail_.gather("");
  }

  std::string in(const std::string& name) const { return path_ + "/" + name; }

  void write(const std::string& name, const std::string& bytes) const
  {
    if (mail_.isFirst())
      writeFile(in(name), bytes);
  }

  ThinnedScan thin(const std::vector<std::string>& names, bool removes_strays = false)
  {
    mail_.fromFirst("written");
    std::vector<std::string> paths;
    for (const auto& name : names)
      paths.push_back(in(name));
    const auto inputs = findInputs(paths);
    ThinOrder order;
    order.ranges = dealRows(
        inputs,
        static_cast<std::size_t>(mail_.size()))[static_cast<std::size_t>(mail_.rank())];
    order.rows = rowsOf(inputs);
    order.excerpt_step = excerpt_step;
    order.inverse_leaf.setConstant(20);
    order.removes_strays = removes_strays;
    return thinTogether(mail_, order, 1);
  }

  /** The result of one process for a whole file. */
  struct Whole {
    pcl::PointCloud<pcl::PointXYZ> points;
    std::shared_ptr<const std::vector<Eigen::Vector3f>> excerpt;
    std::string problem;
    unsigned stray_limit = 0;
  };

  Whole thinAlone(const std::string& name, bool removes_strays = false) const
  {
    const ScanFile file(in(name));
    const std::size_t most = (file.size() + excerpt_step - 1) / excerpt_step;
    EXPECT_EQ(rawStep(file.size(), most), excerpt_step);
    const ScanExcerpt scan(file, most, 1);
    pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
    grid.setDownsampleAllData(false);
    grid.setRemoveStrays(removes_strays);
    Whole whole;
    grid.filter(scan, whole.points);
    whole.stray_limit = grid.getStrayLimit();
    whole.excerpt = scan.points();
    whole.problem = scan.problem();
    return whole;
  }

  static void expectSame(const pcl::PointCloud<pcl::PointXYZ>& a,
                         const pcl::PointCloud<pcl::PointXYZ>& b)
  {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      ASSERT_EQ(std::memcmp(a[i].data, b[i].data, 3 * sizeof(float)), 0) << i;
  }

  const TemporaryFolder folder_;
  RankMail mail_;
  std::string path_;
};

TEST_F(JointThinningTest, OfSeveralFilesGivesTheBytesOfOneProcess)
{
  // More points than are sampled for the check, in files of all kinds.
  const Points first = roomPoints(90000, 1, 50);
  const Points second = roomPoints(40000, 2);
  const Points third = roomPoints(120001, 3, 11);
  Points all = first;
  all.insert(all.end(), second.begin(), second.end());
  all.insert(all.end(), third.begin(), third.end());
  write("first.pcd", pcdBytes(first));
  write("second.pcd", asciiPcd(second));
  write("third.pcd", pcdBytes(third));
  write("all.pcd", pcdBytes(all));
  const ThinnedScan scan = thin({"first.pcd", "second.pcd", "third.pcd"});
  if (!mail_.isFirst())
    return;
  EXPECT_EQ(scan.problem, "");
  EXPECT_EQ(scan.size, all.size());
  const Whole whole = thinAlone("all.pcd");
  expectSame(*scan.points, whole.points);
  ASSERT_EQ(scan.excerpt->size(), whole.excerpt->size());
  EXPECT_EQ(std::memcmp(scan.excerpt->data(), whole.excerpt->data(),
                        scan.excerpt->size() * sizeof(Eigen::Vector3f)),
            0);
}

TEST_F(JointThinningTest, StraysAreThoseOfTheWholeScan)
{
  Points points = roomPoints(20000, 5); // in the air of a dense floor and ceiling
  for (auto& p : roomPoints(800000, 6)) {
    p[2] = p[2] < 0 ? -1.01f : 1.01f;
    points.push_back(p);
  }
  write("air.pcd", pcdBytes(points));
  const ThinnedScan scan = thin({"air.pcd"}, true);
  if (!mail_.isFirst())
    return;
  const Whole whole = thinAlone("air.pcd", true);
  EXPECT_GT(whole.stray_limit, 0u);
  EXPECT_EQ(scan.stray_limit, whole.stray_limit);
  expectSame(*scan.points, whole.points);
}

TEST_F(JointThinningTest, RefusesAScanInAnotherUnitWithTheSentenceOfOneProcess)
{
  Points points = roomPoints(150000, 4, 13);
  for (auto& p : points)
    for (float& coordinate : p)
      coordinate *= 1000;
  write("scan.pcd", pcdBytes(points));
  const ThinnedScan scan = thin({"scan.pcd"});
  EXPECT_NE(scan.problem.find("if its unit is"), std::string::npos);
  if (mail_.isFirst()) {
    EXPECT_EQ(scan.problem, thinAlone("scan.pcd").problem);
  }
}

TEST_F(JointThinningTest, APartThatIsLargeIsNoReasonIfTheWholeIsNot)
{
  Points points = roomPoints(100000, 5);
  for (std::size_t i = 0; i < 900; ++i)
    points[i][2] = 500 + static_cast<float>(i);
  write("scan.pcd", pcdBytes(points));
  const ThinnedScan scan = thin({"scan.pcd"});
  EXPECT_EQ(scan.problem, "");
  if (mail_.isFirst())
    expectSame(*scan.points, thinAlone("scan.pcd").points);
}

TEST_F(JointThinningTest, AFileThatCannotBeReadIsToldWithTheRankThatHeldIt)
{
  std::string damaged = asciiPcd(roomPoints(5000, 7));
  damaged.replace(damaged.size() - 20, 12, "no numbers !");
  write("a.pcd", pcdBytes(roomPoints(5000, 6)));
  write("b.pcd", damaged);
  try {
    thin({"a.pcd", "b.pcd"});
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const ToolError& error) {
    EXPECT_TRUE(mail_.isFirst());
    const std::string sentence = error.what();
    const int holder = mail_.size() * 3 / 4; // of the middle of the second half
    EXPECT_EQ(sentence.find("rank " + std::to_string(holder) + " on '"), 0u)
        << sentence;
    EXPECT_NE(sentence.find("rows 0 to 4999 of '" + in("b.pcd") + "'"),
              std::string::npos)
        << sentence;
  }
  catch (const StepFailed&) {
    EXPECT_FALSE(mail_.isFirst());
  }
}

} // namespace
