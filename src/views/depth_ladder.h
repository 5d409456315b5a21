#pragma once

#include <memory>
#include <string>
#include <vector>

#include "views/depth_segments.h"
#include "views/view.h"

namespace bodkin::views {

// The tissues along the needle's own line from the skin down, with the tip and the target: the strongest cue of depth
// and the strongest aid. Before insertion, the line is the one that the needle would take.
class DepthLadder : public View {
  Q_OBJECT
 public:
  explicit DepthLadder(QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  // As wide as the names of the tissues; it does not shrink for the same patient.
  QSize sizeHint() const override;

  const std::vector<DepthSegment>& segments() const { return segments_; }
  // Pixels from the upper edge at which a depth (mm) is drawn.
  double row(double depth) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString name_of(const DepthSegment& segment) const;
  void make_room_for_names();
  const DepthSegment* touched_segment() const;
  void draw_bar(QPainter& painter) const;
  void draw_names(QPainter& painter) const;
  void draw_tip_and_target(QPainter& painter) const;

  std::shared_ptr<const OpenCase> patient_;
  std::vector<DepthSegment> segments_;
  int wanted_width_ = 0;                             // pixels
  double length_ = 60.0;                             // mm, length of the bar
  double depth_ = 0.0;                               // mm; not more than 0 outside
  double touched_ = 0.0;                             // mm at rest, of the tissue at the tip
  anatomy::TissueId tissue_ = anatomy::tissue::air;  // at the tip
  double target_ = -1.0;                             // mm; negative: none
  bool reached_ = false;
  Vec3 entry_ = Vec3::Zero(), direction_ = Vec3::Zero();  // of the segments
};

// A tissue's name where there is little room: "ligamentum flavum" is "flavum", "interspinous ligament"
// "interspinous".
std::string short_title(const std::string& title);

}  // namespace bodkin::views
