// SPDX-License-Identifier: BSD-3-Clause
#include "unlikely_places.h"
#include "verdict.h"

#include "../sheet/text_places.h"
#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/plan_review.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double sure = 0.9;             // probability of what is not doubted
constexpr std::size_t measured_sign = 1; // see wallSigns()
constexpr std::size_t error_sign = 3;
constexpr double same_place = 1; // metres

std::string
subjectOf(const PlanOpening& opening)
{
  return (opening.kind == OpeningKind::Unknown ? "opening" : nameOf(opening.kind)) +
         (" " + markOf(opening));
}

/** @brief Returns why a wall without a warning is not sure. */
std::string
reasonOf(const PlanElement& wall, const std::vector<double>& signs)
{
  const SurfaceAccuracy& accuracy = wall.accuracy;
  return "it is " + decimalText(wall.length(), 2) + " m long, " +
         percentText(signs[measured_sign]) + " of it was measured" +
         (accuracy.isKnown()
              ? ", with a standard error of " +
                    decimalText(1000 * accuracy.standard_error, 1) + " mm"
              : ", its standard error is not known") +
         (std::exp(signs[error_sign]) > 2 ? ", more than twice the usual" : "");
}

/** @brief Returns why an opening is not sure. */
std::string
reasonOf(const PlanOpening& opening)
{
  const double error = opening.widthError(); // of plans written before there is none
  std::string reason = error > 0 ? "it is " + decimalText(opening.width(), 2) +
                                       " m wide with a standard error of " +
                                       decimalText(100 * error, 1) + " cm"
                                 : "its edges are known to " +
                                       decimalText(100 * opening.residual, 1) + " cm";
  if (error > 0 && opening.jambsSeen() == EdgeSeen::Nothing)
    reason += ", a jamb was not seen";
  else if (error > 0 && opening.jambsSeen() != EdgeSeen::Reveal)
    reason += ", of a jamb only the end of wall or leaf was seen";
  if (opening.kind != OpeningKind::Window && opening.leadsOutside())
    reason += ", no room was seen beyond";
  if (opening.kind == OpeningKind::Unknown)
    reason += ", its kind is not known";
  else if (opening.confidence < sure)
    reason += ", its kind is doubtful";
  return reason;
}

/** @brief Checks whether the values of a warning are metres long or wide, and high, in
 * place of square metres. */
bool
isLengthAndHeight(const PlanWarning& warning)
{
  return warning.values.size() > 1 && warning.kind == WarningKind::NoOpening;
}

/** @brief Checks whether somebody confirmed the wall that a warning is about. */
bool
isConfirmed(const Floorplan& plan, const PlanWarning& warning)
{
  const PlanRoom* const room = findRoom(plan, warning.room);
  return room && warning.wall > 0 && warning.wall <= room->boundary.elements.size() &&
         room->boundary.elements[warning.wall - 1].is_confirmed;
}

/** @brief Gathers the doubts of a plan, one a place. */
class Doubts {
public:
  explicit Doubts(const Floorplan& plan)
      : plan_(plan)
  {}

  void add(const PlanWarning& warning)
  {
    const PlanOpening* const opening =
        warning.kind == WarningKind::NarrowDoor ? doorAt(warning.at) : nullptr;
    if (isConfirmed(plan_, warning) || (opening && opening->is_confirmed))
      return;
    Draft& draft = opening
                       ? draftOf(subjectOf(*opening), warning.room, warning.at, true)
                       : draftOf(sedr::subjectOf(warning), warning.room,
                                 placeOf(warning), warning.wall > 0);
    const WarningAdvice advice = adviceOn(warning.kind);
    const double stake = advice.odds * areaAtStake(advice.stake, warning);
    if (draft.claims.empty() || stake > draft.doubt.stake) {
      draft.act = advice.act;
      draft.doubt.extent = advice.stake;
    }
    draft.doubt.stake = std::max(draft.doubt.stake, stake);
    draft.doubt.kinds.push_back(warning.kind);
    draft.claims.push_back(claimOf(warning));
  }

  /** @brief Adds walls and openings that are not sure, and tells of those that are
   * doubted how sure they are. */
  void add(const PlanReview& review)
  {
    for (const Certainty& of : review.walls) {
      const PlanRoom* const room = findRoom(plan_, of.room);
      const PlanElement& wall = room->boundary.elements[of.index];
      add(of, "wall " + of.element, wall.pointAt(wall.length() / 2),
          [&] { return reasonOf(wall, of.signs); });
    }
    for (const Certainty& of : review.openings) {
      const PlanOpening& opening = plan_.openings[of.index];
      add(of, subjectOf(opening), (opening.start + opening.end) / 2,
          [&] { return reasonOf(opening); });
    }
  }

  /** @brief Moves the doubts into a review, each with the lesser ones beside it, and
   * what puts nothing at stake in particular into its remarks. */
  void moveTo(PlanReview& review)
  {
    const auto isLess = [](const PlanDoubt& a, const PlanDoubt& b) {
      return a.stake > b.stake;
    };
    std::stable_sort(
        drafts_.begin(), drafts_.end(),
        [&](const Draft& a, const Draft& b) { return isLess(a.doubt, b.doubt); });
    std::vector<PlanDoubt>& doubts = review.doubts;
    for (const Draft& draft : drafts_) {
      const PlanDoubt& doubt = draft.doubt;
      const auto place =
          std::find_if(doubts.begin(), doubts.end(), [&](const PlanDoubt& known) {
            return isOfAPart(known) && isOfAPart(doubt) &&
                   (known.at - doubt.at).norm() < same_place &&
                   isOnOneStorey(known.room, doubt.room);
          });
      if (doubt.subject.empty() && doubt.extent == Stake::None)
        review.remarks.push_back(textOf(draft, draft.act));
      else if (place == doubts.end()) {
        doubts.push_back(doubt);
        doubts.back().text = textOf(draft, draft.act);
      }
      else {
        place->stake += doubt.stake;
        place->kinds.insert(place->kinds.end(), doubt.kinds.begin(), doubt.kinds.end());
        place->beside.push_back(doubt.subject);
        place->text += textOf(draft, "; beside it");
      }
    }
    std::stable_sort(doubts.begin(), doubts.end(), isLess);
  }

private:
  struct Draft {
    PlanDoubt doubt{};
    std::string act = "look at";
    std::vector<std::string> claims{};
    const Certainty* certainty = nullptr;
  };

  /** @brief Returns the draft on a subject; unless that has one place, as a wall has,
   * the one at the same place. */
  Draft& draftOf(const std::string& subject,
                 std::uint32_t room,
                 const Eigen::Vector2d& at,
                 bool has_one_place)
  {
    std::vector<std::size_t>& known = of_subject_[subject];
    for (const std::size_t k : known) {
      if (has_one_place || (at - drafts_[k].doubt.at).norm() < same_place)
        return drafts_[k];
    }
    known.push_back(drafts_.size());
    Draft& draft = drafts_.emplace_back();
    draft.doubt.subject = subject;
    draft.doubt.room = room;
    draft.doubt.at = at;
    return draft;
  }

  template <typename Reason>
  void add(const Certainty& certainty,
           const std::string& subject,
           const Eigen::Vector2d& middle,
           const Reason& reason)
  {
    if (of_subject_.count(subject) == 0 && certainty.right() >= sure)
      return;
    Draft& draft = draftOf(subject, certainty.room, middle, true);
    draft.certainty = &certainty;
    draft.doubt.stake = certainty.area * (1 - certainty.right());
    draft.doubt.extent = Stake::Value;
    if (draft.claims.empty())
      draft.claims.push_back(reason());
  }

  /** @brief Returns the place of a warning, the middle of its wall or its room. */
  Eigen::Vector2d placeOf(const PlanWarning& warning) const
  {
    const PlanRoom* const room = findRoom(plan_, warning.room);
    if (warning.at.allFinite() || !room)
      return warning.at;
    const std::vector<PlanElement>& walls = room->boundary.elements;
    return warning.wall > 0 && warning.wall <= walls.size()
               ? walls[warning.wall - 1].pointAt(walls[warning.wall - 1].length() / 2)
               : textSpotIn(room->boundary, room->columns).place;
  }

  double areaAtStake(Stake stake, const PlanWarning& warning) const
  {
    const PlanRoom* const room = findRoom(plan_, warning.room);
    switch (stake) {
    case Stake::Value:
      if (warning.values.empty())
        return 0;
      return std::abs(warning.values[0]) *
             (isLengthAndHeight(warning) ? warning.values[1] : 1);
    case Stake::Room:
      return room ? room->area() : 0;
    case Stake::Plan:
      return areaOf(plan_);
    case Stake::None:
      break;
    }
    return 0;
  }

  const PlanOpening* doorAt(const Eigen::Vector2d& at) const
  {
    for (const PlanOpening& opening : plan_.openings)
      if (opening.kind == OpeningKind::Door && (opening.start + opening.end) / 2 == at)
        return &opening;
    return nullptr;
  }

  bool isOnOneStorey(std::uint32_t a, std::uint32_t b) const
  {
    const PlanRoom* const first = findRoom(plan_, a);
    const PlanRoom* const second = findRoom(plan_, b);
    return !first || !second || shareHeights(*first, *second);
  }

  static bool isOfAPart(const PlanDoubt& doubt)
  {
    return !doubt.subject.empty() && doubt.extent != Stake::Room &&
           doubt.extent != Stake::Plan;
  }

  static std::string textOf(const Draft& draft, std::string text)
  {
    const std::string& subject = draft.doubt.subject;
    text += (text.empty() || subject.empty() ? "" : " ") + subject;
    if (draft.certainty)
      text += ", " + percentText(draft.certainty->right()) + " sure";
    for (std::size_t k = 0; k < draft.claims.size(); ++k)
      text += (k > 0 ? "; " : text.empty() ? "" : ": ") + draft.claims[k];
    return text;
  }

  const Floorplan& plan_;
  std::vector<Draft> drafts_;
  std::map<std::string, std::vector<std::size_t>> of_subject_; ///< drafts
};

} // namespace

PlanReview
reviewOf(const Floorplan& plan, const std::vector<PlanWarning>& warnings)
{
  PlanReview review;
  std::vector<PlanWarning> all = unlikelyPlaces(plan);
  all.insert(all.begin(), warnings.begin(), warnings.end());
  review.walls = certaintyOfWalls(plan, all);
  review.openings = certaintyOfOpenings(plan);
  Doubts doubts(plan);
  for (const PlanWarning& warning : all)
    doubts.add(warning);
  doubts.add(review);
  doubts.moveTo(review);
  setVerdict(plan, review);
  return review;
}

std::set<std::string>
leadingSubjects(const std::vector<PlanDoubt>& doubts, std::size_t most)
{
  std::set<std::string> subjects;
  for (std::size_t k = 0; k < std::min(most, doubts.size()); ++k)
    for (const auto& names : {std::vector{doubts[k].subject}, doubts[k].beside})
      subjects.insert(names.begin(), names.end());
  return subjects;
}

std::function<bool(std::uint32_t, std::size_t)>
wallsAmong(std::set<std::string> subjects)
{
  return [subjects = std::move(subjects)](std::uint32_t room, std::size_t e) {
    PlanWarning wall;
    wall.room = room;
    wall.wall = e + 1;
    return subjects.count(subjectOf(wall)) > 0;
  };
}

std::vector<std::string>
firstOf(const std::vector<PlanDoubt>& doubts, std::size_t most)
{
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < std::min(most, doubts.size()); ++k)
    lines.push_back(doubts[k].text);
  if (doubts.size() > most)
    lines.push_back("and " + std::to_string(doubts.size() - most) +
                    (doubts.size() == most + 1 ? " more place" : " more places") +
                    " where less is at stake, see the report");
  return lines;
}

} // namespace pcl::sedr
