// SPDX-License-Identifier: BSD-3-Clause
#include "contract/sample_structure.h"
#include "contract_suite.h"

#include <pcl/sedr_filters/floor_projection_recovery.h>
#include <pcl/sedr_filters/grid_region_outlier_removal.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>

namespace contract {

/** Voxels of 10 cm, some of which contain several points. */
class VoxelGridAdaptor
    : public FilterAdaptor<VoxelGridAdaptor, pcl::ParallelVoxelGrid<pcl::PointXYZ>> {
public:
  VoxelGridAdaptor()
      : FilterAdaptor(true)
  {
    parameter(
        [this](double size) {
          stage_.setLeafSize(0.1f, static_cast<float>(size), 0.1f);
        },
        0.1, {0, -1, nan, inf, 1e-45});
  }

  Outcome outcomeOf(const Cloud& output) const
  {
    const pcl::Indices& removed = *stage_.getRemovedIndices();
    Outcome result = outcome(output.size(), bytesOf(output), bytesOf(removed));
    result.removed = removed;
    return result;
  }
};

class RegionRemovalAdaptor
    : public Adaptor<pcl::GridRegionOutlierRemoval<pcl::PointXYZ>> {
public:
  static constexpr bool has_negative = true;
  static constexpr bool works_in_place = true;

  RegionRemovalAdaptor()
      : Adaptor(true)
  {
    parameter([this](double v) { stage_.setGridSize(v); }, 0.05, {0, -0.05, inf});
  }

  void setNegative(bool negative) { stage_.setNegative(negative); }

  Outcome run()
  {
    pcl::Indices kept{7, 7, 7};
    stage_.filter(kept);
    Outcome result = outcomeOf(pointsOf(kept), bytesOf(kept));
    result.size = kept.size();
    result.kept = kept;
    return result;
  }

  Outcome runInPlace(const Cloud::Ptr& cloud)
  {
    setInput(cloud);
    stage_.filter(*cloud);
    return outcomeOf(*cloud, "");
  }

private:
  Outcome outcomeOf(const Cloud& output, const std::string& kept) const
  {
    const pcl::Indices& removed = *stage_.getRemovedIndices();
    Outcome result = outcome(output.size(),
                             bytesOf(stage_.getRegionSizes(), stage_.getThreshold(),
                                     stage_.getNumberOfRegions(), output),
                             kept + bytesOf(removed, stage_.getRegionLabels()));
    result.removed = removed;
    return result;
  }
};

/** Only low points among the indices are floor; the ceiling is that of the sample room.
 */
class FloorRecoveryAdaptor
    : public FilterAdaptor<FloorRecoveryAdaptor,
                           pcl::FloorProjectionRecovery<pcl::PointXYZ>> {
public:
  FloorRecoveryAdaptor()
      : FilterAdaptor(true)
  {
    parameter([this](double v) { stage_.setGridSize(v); }, 0.05, {0, -1, nan, inf});
    parameter(
        [this](double v) {
          auto plane = std::make_shared<pcl::ModelCoefficients>();
          plane->values.assign(3, static_cast<float>(v)); // one is missing
          stage_.setFloorCoefficients(v > 0 ? plane : nullptr);
        },
        0, {1});
  }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    stage_.setInputCloud(cloud);
    stage_.setCeilingIndices(between(*cloud, 2.4f, 2.6f));
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    stage_.setIndices(indices);
    stage_.setCeilingIndices(among(*stage_.getInputCloud(), *indices, 2.4f, 10.f));
  }

  Outcome outcomeOf(const Cloud& output) const
  {
    const pcl::Indices& removed = *stage_.getRemovedIndices();
    pcl::Indices kept = stage_.getProjectedIndices();
    Outcome result =
        outcome(output.size(), bytesOf(output, stage_.getNumberOfProjected()),
                bytesOf(removed, kept));
    kept.resize(kept.size() - stage_.getNumberOfProjected());
    result.kept = kept;
    result.removed = removed;
    return result;
  }
};

/** A stage that takes the plan of the sample room, labels and rooms. */
template <typename DerivedT, typename StageT>
class StructureAdaptor : public FilterAdaptor<DerivedT, StageT> {
public:
  StructureAdaptor()
      : FilterAdaptor<DerivedT, StageT>(true)
  {
    this->parameter(
        [this](double v) {
          stage_.setLabels(v > 0 ? std::vector<std::uint32_t>{1, 2, 3}
                                 : structure_.labels);
        },
        0, {1});
    this->parameter(
        [this](double v) { // empty: the point type has none
          stage_.setRooms(v > 1   ? std::vector<std::uint32_t>{1, 1}
                          : v > 0 ? std::vector<std::uint32_t>{}
                                  : structure_.rooms);
        },
        0, {1, 2});
  }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    stage_.setInputCloud(cloud);
    setStructure(*between(*cloud, -10.f, 10.f));
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    stage_.setIndices(indices);
    setStructure(*indices);
  }

protected:
  using FilterAdaptor<DerivedT, StageT>::stage_;

private:
  void setStructure(const pcl::Indices& indices)
  {
    structure_ = SampleStructure(*stage_.getInputCloud(), indices);
    stage_.setFloorplan(structure_.plan);
    this->mend();
  }

  SampleStructure structure_;
};

class RefinementAdaptor
    : public StructureAdaptor<RefinementAdaptor,
                              pcl::StructureRefinement<pcl::PointXYZ>> {
public:
  RefinementAdaptor()
  {
    parameter([this](double v) { stage_.setMaximumDistance(v); }, 0.15,
              {0, -0.15, nan, inf});
  }

  Outcome outcomeOf(const Cloud& output) const
  {
    Outcome result = this->outcome(
        output.size(), bytesOf(output) + bytesOf(stage_.getSurfacePoints()),
        bytesOf(stage_.getSourceIndices(), *stage_.getRemovedIndices()));
    result.kept = stage_.getSourceIndices();
    result.removed = *stage_.getRemovedIndices();
    return result;
  }
};

/** The size is the number of retained scan points. Points that fill holes depend only
 * on the plan, and exist even without scan points. */
class HoleRepairAdaptor
    : public StructureAdaptor<HoleRepairAdaptor,
                              pcl::VerticalHoleRepair<pcl::PointXYZ>> {
public:
  HoleRepairAdaptor()
  {
    parameter([this](double v) { stage_.setGridSize(v); }, 0.05, {0, -0.05, nan, inf});
  }

  Outcome outcomeOf(const Cloud& output) const
  {
    pcl::Indices kept;
    for (const auto i : stage_.getSourceIndices())
      if (i >= 0)
        kept.push_back(i);
    Outcome result =
        this->outcome(stage_.getErrorMessage().empty() ? kept.size() : output.size(),
                      bytesOf(output, stage_.getRepairedIndices()) +
                          bytesOf(stage_.getSurfacePoints()),
                      bytesOf(stage_.getSourceIndices(), *stage_.getRemovedIndices()));
    result.kept = kept;
    result.removed = *stage_.getRemovedIndices();
    return result;
  }
};

using FilterAdaptors = ::testing::Types<VoxelGridAdaptor,
                                        RegionRemovalAdaptor,
                                        FloorRecoveryAdaptor,
                                        RefinementAdaptor,
                                        HoleRepairAdaptor>;
INSTANTIATE_TYPED_TEST_SUITE_P(Filters, Contract, FilterAdaptors);

} // namespace contract
