// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract.h"

#include <gtest/gtest.h>

#include <cctype>

// Tests of the requirements for every stage, through adaptors as described in
// contract.h. A test program instantiates the suite:
//
//     using Adaptors = ::testing::Types<MyStageAdaptor, ...>;
//     INSTANTIATE_TYPED_TEST_SUITE_P(Segmentation, Contract, Adaptors);

namespace contract {

template <typename AdaptorT>
class Contract : public ::testing::Test {
protected:
  static Outcome runOn(const Cloud::ConstPtr& cloud, unsigned threads = 0)
  {
    AdaptorT stage;
    stage.setThreads(threads);
    stage.setInput(cloud);
    return stage.run();
  }

  static bool hasNumber(const std::string& sentence)
  {
    return std::any_of(sentence.begin(), sentence.end(),
                       [](unsigned char c) { return std::isdigit(c) != 0; });
  }
};

TYPED_TEST_SUITE_P(Contract);

TYPED_TEST_P(Contract, ASampleRoomGivesAResult)
{
  const Outcome outcome = this->runOn(sampleRoom());
  EXPECT_EQ(outcome.error, "");
  EXPECT_GT(outcome.size, 0u);
}

TYPED_TEST_P(Contract, WithoutInputItFailsWithAReason)
{
  TypeParam stage;
  const Outcome outcome = stage.run();
  EXPECT_NE(outcome.error, "");
  EXPECT_EQ(outcome.size, 0u);
}

TYPED_TEST_P(Contract, OnePointDoesNoHarm)
{
  auto cloud = std::make_shared<Cloud>();
  cloud->emplace_back(1.f, 2.f, 2.5f);
  const Outcome outcome = this->runOn(cloud);
  EXPECT_LE(outcome.size, 1u);
  EXPECT_EQ(outcome.size > 0, TypeParam::finds_in_one_point);
}

TYPED_TEST_P(Contract, NoPointsOrNothingButNaNGiveNothing)
{
  EXPECT_EQ(this->runOn(std::make_shared<Cloud>()).size, 0u);
  if (TypeParam::uses_indices) {
    TypeParam stage;
    stage.setInput(sampleRoom());
    stage.setIndices(std::make_shared<pcl::Indices>());
    EXPECT_EQ(stage.run().size, 0u);
  }
  auto cloud = std::make_shared<Cloud>();
  const float none = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 100; ++i)
    cloud->emplace_back(none, none, none);
  cloud->is_dense = false;
  const Outcome outcome = this->runOn(cloud);
  EXPECT_EQ(outcome.size, 0u);
  if (outcome.removed) {
    EXPECT_EQ(outcome.removed->size(), 100u);
  }
}

TYPED_TEST_P(Contract, PointsThatAreNotFiniteChangeNothing)
{
  const auto clean = sampleRoom();
  const auto holed = withHoles(*clean);
  const Outcome without = this->runOn(clean);
  const Outcome with = this->runOn(holed);
  EXPECT_EQ(with.error, "");
  EXPECT_EQ(with.size, without.size);
  EXPECT_EQ(with.geometry, without.geometry);
  for (const auto i : with.kept.value_or(pcl::Indices())) {
    EXPECT_TRUE(isFinite((*holed)[static_cast<std::size_t>(i)]));
  }
  holed->is_dense = true; // a cloud may call itself dense and still hold NaN
  EXPECT_EQ(this->runOn(holed).all, with.all);
}

TYPED_TEST_P(Contract, SparseIndicesWorkAsACloudOfThosePoints)
{
  if (!TypeParam::uses_indices)
    GTEST_SKIP() << "takes no indices";
  const auto room = sampleRoom();
  auto mixed = std::make_shared<Cloud>();
  auto indices = std::make_shared<pcl::Indices>();
  for (const auto& p : *room) {
    mixed->emplace_back(p.y * 3.f, p.x * 0.3f, p.z * 1.7f); // decoys
    indices->push_back(static_cast<pcl::index_t>(mixed->size()));
    mixed->push_back(p);
    mixed->emplace_back(p.y, p.x - 1.f, 2.5f);
  }
  TypeParam stage;
  stage.setInput(mixed);
  stage.setIndices(indices);
  const Outcome sparse = stage.run();
  const Outcome whole = this->runOn(room);
  EXPECT_EQ(sparse.error, "");
  EXPECT_EQ(sparse.size, whole.size);
  EXPECT_EQ(sparse.geometry, whole.geometry);
}

TYPED_TEST_P(Contract, IndicesOutOfRangeAreRefused)
{
  if (!TypeParam::uses_indices)
    GTEST_SKIP() << "takes no indices";
  const auto room = sampleRoom();
  for (const pcl::index_t bad : {static_cast<pcl::index_t>(room->size()), -1}) {
    TypeParam stage;
    stage.setInput(room);
    stage.setIndices(std::make_shared<pcl::Indices>(pcl::Indices{0, 1, bad}));
    const Outcome outcome = stage.run();
    EXPECT_NE(outcome.error.find(std::to_string(bad)), std::string::npos)
        << outcome.error;
    EXPECT_EQ(outcome.size, 0u);
  }
}

TYPED_TEST_P(Contract, BadParametersAreRefusedWithTheirNumbers)
{
  const auto room = sampleRoom();
  for (int which = 0; which < TypeParam().spoils(); ++which) {
    TypeParam stage;
    stage.setInput(room);
    stage.spoil(which);
    const Outcome outcome = stage.run();
    EXPECT_TRUE(this->hasNumber(outcome.error))
        << "bad parameter " << which << ": '" << outcome.error << "'";
    EXPECT_EQ(outcome.size, 0u) << "bad parameter " << which;
  }
}

TYPED_TEST_P(Contract, AGoodRunAfterABadOneIsAsIfThereHadBeenNone)
{
  const auto room = sampleRoom();
  TypeParam stage;
  stage.setInput(room);
  stage.spoil(0);
  EXPECT_NE(stage.run().error, "");
  stage.mend();
  const Outcome outcome = stage.run();
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.all, this->runOn(room).all);
}

TYPED_TEST_P(Contract, KeptAndRemovedMakeUpTheIndices)
{
  const auto cloud = withHoles(*sampleRoom());
  auto indices = std::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < cloud->size(); i += 2)
    indices->push_back(static_cast<pcl::index_t>(i));
  TypeParam stage;
  stage.setInput(cloud);
  stage.setIndices(indices);
  const Outcome outcome = stage.run();
  if (!outcome.kept || !outcome.removed)
    GTEST_SKIP() << "keeps no account of single points";
  pcl::Indices both = *outcome.kept;
  both.insert(both.end(), outcome.removed->begin(), outcome.removed->end());
  std::sort(both.begin(), both.end());
  EXPECT_EQ(both, *indices);
}

TYPED_TEST_P(Contract, NegativeKeepsTheFinitePointsThatWereRemoved)
{
  if constexpr (!TypeParam::has_negative)
    GTEST_SKIP() << "has no negative";
  else {
    const auto cloud = withHoles(*sampleRoom());
    TypeParam stage;
    stage.setInput(cloud);
    const Outcome positive = stage.run();
    stage.setNegative(true);
    const Outcome negative = stage.run();
    pcl::Indices finite_removed;
    std::copy_if(positive.removed->begin(), positive.removed->end(),
                 std::back_inserter(finite_removed), [&](pcl::index_t i) {
                   return isFinite((*cloud)[static_cast<std::size_t>(i)]);
                 });
    EXPECT_EQ(*negative.kept, finite_removed);
    EXPECT_EQ(negative.kept->size() + negative.removed->size(), cloud->size());
  }
}

TYPED_TEST_P(Contract, InPlaceGivesTheSame)
{
  if constexpr (!TypeParam::works_in_place)
    GTEST_SKIP() << "does not write clouds";
  else {
    const auto cloud = withHoles(*sampleRoom());
    const Outcome apart = this->runOn(cloud);
    TypeParam stage;
    EXPECT_EQ(stage.runInPlace(std::make_shared<Cloud>(*cloud)).geometry,
              apart.geometry);
  }
}

TYPED_TEST_P(Contract, AnotherCloudInTheSameObjectIsAsInAFreshOne)
{
  const std::vector<Cloud::Ptr> clouds{sampleRoom(1, 4), sampleRoom(2, 3),
                                       std::make_shared<Cloud>(), sampleRoom(3, 5)};
  TypeParam stage;
  for (const auto& cloud : clouds) {
    stage.setInput(cloud);
    const Outcome again = stage.run();
    const Outcome fresh = this->runOn(cloud);
    EXPECT_EQ(again.all, fresh.all) << cloud->size() << " points";
    EXPECT_EQ(again.error, fresh.error);
  }
}

TYPED_TEST_P(Contract, RoomsTenKilometresApartAreNoBurden)
{
  if (TypeParam::takes_one_room)
    GTEST_SKIP() << "works on one room";
  const auto room = sampleRoom();
  auto two = std::make_shared<Cloud>(*room);
  for (const auto& p : *room)
    two->emplace_back(p.x + 8192.f, p.y - 8192.f,
                      p.z); // a float still resolves 1 mm there
  const Outcome outcome = this->runOn(two);
  EXPECT_EQ(outcome.error, "");
  EXPECT_GT(outcome.size, 0u);
  if (TypeParam::far_rooms_add_up) {
    EXPECT_NEAR(static_cast<double>(outcome.size),
                2.0 * static_cast<double>(this->runOn(room).size),
                0.1 * static_cast<double>(outcome.size));
  }
}

TYPED_TEST_P(Contract, AnyNumberOfThreadsGivesTheSameBytes)
{
  const auto cloud = withHoles(*sampleRoom(5, 14)); // several blocks of points
  const Outcome one = this->runOn(cloud, 1);
  for (const unsigned threads : {1u, 3u, 0u})
    EXPECT_EQ(this->runOn(cloud, threads).all, one.all) << threads << " threads";
}

REGISTER_TYPED_TEST_SUITE_P(Contract,
                            ASampleRoomGivesAResult,
                            WithoutInputItFailsWithAReason,
                            OnePointDoesNoHarm,
                            NoPointsOrNothingButNaNGiveNothing,
                            PointsThatAreNotFiniteChangeNothing,
                            SparseIndicesWorkAsACloudOfThosePoints,
                            IndicesOutOfRangeAreRefused,
                            BadParametersAreRefusedWithTheirNumbers,
                            AGoodRunAfterABadOneIsAsIfThereHadBeenNone,
                            KeptAndRemovedMakeUpTheIndices,
                            NegativeKeepsTheFinitePointsThatWereRemoved,
                            InPlaceGivesTheSame,
                            AnotherCloudInTheSameObjectIsAsInAFreshOne,
                            RoomsTenKilometresApartAreNoBurden,
                            AnyNumberOfThreadsGivesTheSameBytes);

} // namespace contract
