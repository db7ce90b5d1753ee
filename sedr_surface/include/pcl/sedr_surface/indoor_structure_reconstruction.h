// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/mesh_reconstruction.h>
#include <pcl/sedr_surface/structure_chain.h>

#include <memory>

namespace pcl {

/** @brief Reconstructs the closed model of ceilings, floors and walls from an indoor
 * scan: all stages of the paper (section 2.1) as one SurfaceReconstruction. Frame: z
 * up, metres. Neither trajectory nor scanner positions are required, see
 * setScanPositions(). Non-finite points are skipped.
 *
 * This class is a thin composition. getStages() gives access to every stage, whose own
 * setters apply. Setters with names of the paper's Table 1 pass on the parameters that
 * several stages share.
 *
 * After reconstruct() the mesh has one closed component per room, and getModel() holds
 * labelled points, the floor plan, warnings and reports of the stages. If a stage finds
 * nothing, the mesh is empty and getErrorMessage() names the stage and what it looked
 * for. */
template <typename PointT>
class IndoorStructureReconstruction : public sedr::MeshReconstruction<PointT>,
                                      public sedr::StructureChain {
public:
  using Ptr = shared_ptr<IndoorStructureReconstruction<PointT>>;
  using ConstPtr = shared_ptr<const IndoorStructureReconstruction<PointT>>;
  using PointCloud = pcl::PointCloud<PointT>;

  IndoorStructureReconstruction();
  ~IndoorStructureReconstruction()
      override; // here it would be compiled with every user

  /** @brief Sets a scan that is read in pieces, in place of an input cloud and its
   * indices. The result is the same; memory grows with the thinned scan, not with the
   * scan. Null (default): the input cloud. */
  void setInputSource(const std::shared_ptr<const sedr::RowSource>& source)
  {
    source_ = source;
  }

  /** @brief Finds the structure without making the mesh.
   * @return false if a stage found nothing, with the reason in getErrorMessage() */
  bool findStructure();
  using StructureChain::findStructure;

  /** @brief Makes only the mesh of the structural Poisson, see getStages(), without the
   * copy of getMesh() and PCL's form, which is several times as large.
   * @return false if there is none, with the reason in getErrorMessage() */
  bool makeMesh();

  /** @brief Returns the refined and repaired points with normal, label and room. */
  StructureCloud::ConstPtr getStructure() const { return model_.structure; }
  std::shared_ptr<const sedr::Floorplan> getFloorplan() const { return model_.plan; }

protected:
  bool run() override;

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using sedr::MeshReconstruction<PointT>::mesh_;

  /** @brief Tells why the run failed. */
  bool fail();

  std::shared_ptr<const sedr::RowSource> source_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_surface/impl/indoor_structure_reconstruction.hpp>
#endif
