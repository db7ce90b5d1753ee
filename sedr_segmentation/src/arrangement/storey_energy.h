// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_cells.h"
#include "recess_cells.h"
#include "storey_lines.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief The energy of the labels of a storey's cells, nats: each cell is a room's, or
 * none. Weights are for a square metre of a cell, or a metre of border or surface.
 *
 *     E(labels) = sum over cells     area x (`seen` where air of another room was seen,
 *                       or of any room and the cell is none; `niche` where that air is
 *                       in a recess with an opaque back, 0 in one that is open;
 *                       `unseen` of a room where nobody saw air)
 *                     + surface x StoreyLine::height x (StoreyLines::certainty if the
 *                       cell before it is not of the room that saw it, or the cell
 *                       behind it is)
 *               + sum over borders and the rooms beside them
 *                     length x (`wall` + `off` x what was not explained of a surface
 *                       that the room saw; `partly`, `gap`, `ended` or `open` where it
 *                       saw none, see StoreyLine::Between; `open` + `ended` on
 *                       the face of another room, `open` off all lines in use)
 *               + sum over lines in use   parameters x `line` */
struct StoreyEnergy {
  double seen = 40;
  double niche = 10;
  double unseen = 6;
  double wall = 0.15;
  double off = 4;
  double partly = 0.15;
  double gap = 1;
  double ended = 3;
  double open = 10;
  double line = 2.5;
};

/** @brief What labels of cells and borders between them cost. Label 0 is none, label
 * k > 0 the k-th room of the storey. */
class StoreyCosts {
public:
  /** @param borders with the numbers of lines */
  StoreyCosts(const StoreyEvidence& evidence,
              const StoreyEnergy& energy,
              const StoreyLines& lines,
              const PlanCells& arrangement,
              const std::vector<CellBorder>& borders);

  std::size_t labels() const { return near_.size(); }
  std::size_t cells() const { return of_cell_.size(); }

  double ofCell(std::size_t cell, int label) const
  {
    return label == 0 ? of_cell_[cell].none : of_cell_[cell].ofRoom(label);
  }

  /** @brief Returns the cells that a label may have: those in the box of its room. */
  const std::vector<std::size_t>& cellsNear(int label) const
  {
    return near_[static_cast<std::size_t>(label)];
  }

  /** @brief Returns what a border between two labels costs.
   * @param in_use whether its line may be used */
  double ofBorder(std::size_t border, int left, int right, bool in_use) const;

private:
  /** @brief What a cell costs: as none, and how much more as a room's. */
  struct CellCost {
    double none = 0;
    double unseen = 0;                           ///< more, of any room
    std::vector<std::pair<int, double>> of_room; ///< and more, of those that saw it

    double ofRoom(int label) const;
    double& moreOf(int label);
  };

  /** @brief What a border costs by the rooms that saw its surface. */
  struct BorderCost {
    double open = 0;  ///< without its line
    double other = 0; ///< beside no room that saw it
    std::vector<std::pair<int, double>> of_room;
  };

  void addAreas(const StoreyEvidence& evidence, const PlanCells& arrangement);
  int sideOfAir(const StoreyEvidence& evidence,
                std::uint32_t room,
                const Eigen::Vector2d& p,
                const Eigen::Vector2d& left) const;
  void addFronts(const StoreyEvidence& evidence,
                 const StoreyLine& line,
                 const CellBorder& border);
  BorderCost costOf(const StoreyLine& line, const CellBorder& border) const;

  StoreyEnergy energy_;
  double certainty_;                  ///< of surfaces
  std::vector<RecessCells> recesses_; ///< by room
  std::vector<int> label_of_;         ///< of each room
  std::vector<CellCost> of_cell_;
  std::vector<std::vector<std::size_t>> near_; ///< cells, by label
  std::vector<BorderCost> of_border_;
};

} // namespace pcl::sedr
