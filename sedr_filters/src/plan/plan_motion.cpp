// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

namespace pcl::sedr {

namespace {

/** @brief A rotation about z, then a shift. */
class PlanMotion {
public:
  PlanMotion(double angle, const Eigen::Vector3d& shift)
      : angle_(angle)
      , turn_(angle)
      , shift_(shift)
  {}

  void move(Eigen::Vector2d& place) const { place = turn_ * place + shift_.head<2>(); }

  void move(double& height) const { height += shift_.z(); }

  void move(PlanLoop& loop) const
  {
    for (PlanElement& element : loop.elements)
      for (Eigen::Vector2d* place : {&element.start, &element.end, &element.centre})
        move(*place);
  }

  void move(PlanSlab& slab) const
  {
    slab.plane.head<2>() = turn_ * Eigen::Vector2d(slab.plane.head<2>());
    slab.plane[3] -= slab.plane.head<3>().dot(shift_);
    if (slab.curve)
      slab.curve =
          std::make_shared<const SlabCurve>(moved(*slab.curve, angle_, shift_));
  }

  void move(PlanDetail& detail) const
  {
    move(detail.boundary);
    moveAll(detail.holes);
    move(detail.slab);
  }

  void move(PlanNiche& niche) const
  {
    move(niche.boundary);
    move(niche.bottom);
    move(niche.top);
  }

  void move(PlanRoom& room) const
  {
    move(room.boundary);
    moveAll(room.columns);
    move(room.floor);
    move(room.ceiling);
    moveAll(room.details);
    moveAll(room.floor_details);
    moveAll(room.niches);
  }

  void move(PlanStorey& storey) const
  {
    move(storey.floor);
    move(storey.ceiling);
  }

  void move(PlanOpening& opening) const
  {
    move(opening.start);
    move(opening.end);
    move(opening.bottom);
    move(opening.top);
  }

  void move(PlanFlight& flight) const
  {
    for (PlanFlight::Riser& riser : flight.risers)
      for (Eigen::Vector2d& end : riser)
        move(end);
    move(flight.bottom);
  }

  void move(PlanStair& stair) const
  {
    move(stair.at);
    move(stair.bottom);
    move(stair.top);
    moveAll(stair.flights);
  }

  template <typename Part>
  void moveAll(std::vector<Part>& parts) const
  {
    for (Part& part : parts)
      move(part);
  }

private:
  double angle_;
  Eigen::Rotation2Dd turn_;
  Eigen::Vector3d shift_;
};

} // namespace

Floorplan
moved(Floorplan plan, double angle, const Eigen::Vector3d& shift)
{
  const PlanMotion motion(angle, shift);
  motion.moveAll(plan.rooms);
  motion.moveAll(plan.storeys);
  motion.moveAll(plan.stairs);
  motion.moveAll(plan.openings);
  return plan;
}

} // namespace pcl::sedr
