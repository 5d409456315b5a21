#include "views/depth_ladder.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "views/language.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double bar_left = 10.0, bar_width = 22.0, bar_top = 32.0, below_bar = 34.0;  // pixels
constexpr double name_left = bar_left + bar_width + 10.0, beside_name = 10.0;
constexpr double label_gap = 13.0;
constexpr int least_width = 118, least_height = 160;  // pixels
constexpr double least_named = 0.25;                  // mm: thinner layers are voxels cut at their edge
constexpr double line_moved = 0.05, line_turned = 0.05 * degree;

}  // namespace

std::string short_title(const std::string& title) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> known = {
      {{"ligamentum flavum", "flavum"},
       {"interspinous ligament", "interspinous"},
       {"supraspinous ligament", "supraspinous"},
       {"cerebrospinal fluid", "CSF"},
       {"spinal cord", "cord"},
       {"epidural space", "epidural"},
       {"intervertebral disc", "disc"},
       {"other soft tissue", "soft tissue"},
       {"cancellous bone", "inner bone"}}};
  for (const auto& [whole, brief] : known) {
    if (title == whole) return std::string(brief);
  }
  return title;
}

DepthLadder::DepthLadder(QWidget* parent) : View(parent) {
  setMinimumSize(112, least_height);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAccessibleName(tr("Depth ladder"));
}

void DepthLadder::set_case(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  segments_.clear();
  wanted_width_ = least_width;
  direction_ = Vec3::Zero();
  update();
}

QSize DepthLadder::sizeHint() const {
  return {std::max(least_width, wanted_width_), least_height};
}

QString DepthLadder::name_of(const DepthSegment& segment) const {
  return in_words(short_title(patient_->patient.library.title(segment.tissue)));
}

// Bold, as for the layer at the tip.
void DepthLadder::make_room_for_names() {
  const QFontMetrics letters(views::font(label_size, true));
  for (const DepthSegment& segment : segments_) {
    if (segment.to - segment.from < least_named) continue;
    const double wide = name_left + letters.horizontalAdvance(name_of(segment)) + beside_name;
    wanted_width_ = std::max(wanted_width_, static_cast<int>(std::ceil(wide)));
  }
}

void DepthLadder::show_frame(const Frame& frame, const Changes& changes) {
  if (patient_ == nullptr) return;
  if (!changes.needle && !changes.plan && !changes.tissue && !changes.state && !changes.theme && !changes.attempt)
    return;
  depth_ = frame.has_needle ? frame.depth : 0.0;
  tissue_ = frame.tissue;
  touched_ = depth_ > 0.0 ? std::max(0.0, depth_ - frame.pushed) : depth_;
  reached_ = frame.target_reached;
  Vec3 entry = Vec3::Zero(), direction = Vec3::Zero();
  if (frame.has_needle) {
    direction = needle_axis(frame.needle);
    entry = frame.entry ? *frame.entry : Vec3(frame.needle.translation() - std::max(0.0, depth_) * direction);
  } else if (frame.plan && frame.plan->length() > 0.0) {
    direction = frame.plan->direction();
    entry = frame.plan->entry;
  }
  target_ = frame.plan && direction.norm() > 0.0 ? direction.dot(frame.plan->target - entry) : -1.0;
  const bool same = (entry - entry_).norm() < line_moved && direction.dot(direction_) > std::cos(line_turned);
  constexpr double beyond_target = 12.0, least = 40.0, decade = 10.0;  // mm
  const double wanted = std::max({least, target_ + beyond_target, depth_ + 0.5 * beyond_target});
  const double length = decade * std::ceil(wanted / decade);
  if (!same || length != length_) {
    segments_ = depth_segments(patient_->patient.tissues, entry, direction, length);
    entry_ = entry;
    direction_ = direction;
    length_ = length;
    make_room_for_names();
  }
  update();
}

// At a boundary the layer that contains the tip.
const DepthSegment* DepthLadder::touched_segment() const {
  constexpr double beside = 3.0;  // mm
  const auto distance = [this](const DepthSegment& segment) {
    return std::max({0.0, segment.from - touched_, touched_ - segment.to});
  };
  const DepthSegment* nearest = nullptr;
  for (const DepthSegment& segment : segments_) {
    if (segment.tissue != tissue_ || distance(segment) > beside) continue;
    if (nearest == nullptr || distance(segment) < distance(*nearest)) nearest = &segment;
  }
  return nearest != nullptr ? nearest : segment_at(segments_, touched_);
}

double DepthLadder::row(double depth) const {
  return bar_top + (height() - bar_top - below_bar) * depth / length_;
}

void DepthLadder::paintEvent(QPaintEvent* /*event*/) {
  const Theme& theme = Theme::dark();  // it lies on the picture of the patient
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = theme.ground;
  ground.setAlphaF(0.82);
  painter.setPen(QPen(theme.line, 1.0));
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), corner, corner);
  set_font(painter, label_size, true);
  draw_text(painter, {bar_left, 20.0}, tr("Depth"), theme.text);
  set_font(painter, label_size);
  draw_text(painter, {width() - 10.0, 20.0}, tr("mm"), theme.second, Anchor::right);
  if (patient_ == nullptr) return;
  draw_bar(painter);
  draw_names(painter);
  draw_tip_and_target(painter);
  const QString depth = QString::number(std::max(0.0, depth_), 'f', 1);
  set_font(painter, heading_size, true);
  draw_text(painter, {bar_left, height() - 11.0}, depth, theme.text);
  const double wide = painter.fontMetrics().horizontalAdvance(depth);
  set_font(painter, label_size);
  draw_text(painter, {bar_left + wide + 6.0, height() - 11.0}, tr("mm"), theme.second);
}

void DepthLadder::draw_bar(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(Qt::NoPen);
  for (const DepthSegment& segment : segments_) {
    const QColor colour = tissue_colour(segment.tissue, patient_->patient.library);
    const auto fill = [&](double from, double to, const QColor& with) {
      if (to > from)
        painter.fillRect(QRectF(QPointF(bar_left, row(from)), QPointF(bar_left + bar_width, row(to))), with);
    };
    const double met = std::clamp(touched_, segment.from, segment.to);
    fill(segment.from, met, colour);
    // Layers still ahead are darker.
    QColor ahead = colour.darker(depth_ > 0.0 ? 155 : 125);
    fill(met, segment.to, ahead);
  }
  for (double depth = 10.0; depth < length_; depth += 10.0) {
    const double y = std::round(row(depth));
    painter.fillRect(QRectF(bar_left, y, 5.0, 1.0), QColor(0, 0, 0, 150));
  }
  painter.setRenderHint(QPainter::Antialiasing);
}

void DepthLadder::draw_names(QPainter& painter) const {
  const Theme& theme = Theme::dark();
  std::vector<double> desired;
  std::vector<const DepthSegment*> named;
  for (const DepthSegment& segment : segments_) {
    if (segment.to - segment.from < least_named) continue;
    desired.push_back(0.5 * (row(segment.from) + row(segment.to)));
    named.push_back(&segment);
  }
  const std::vector<double> places = spread_labels(desired, label_gap, bar_top + 4.0, height() - below_bar);
  const DepthSegment* now = depth_ > 0.0 ? touched_segment() : nullptr;
  for (std::size_t i = 0; i < named.size(); ++i) {
    const bool here = named[i] == now;
    painter.setPen(QPen(theme.line, 1.0));
    if (std::abs(places[i] - desired[i]) > 3.0) {
      painter.drawLine(QPointF(bar_left + bar_width + 1.0, desired[i]), QPointF(name_left - 2.0, places[i]));
    }
    set_font(painter, label_size, here);
    const QString title = painter.fontMetrics().elidedText(name_of(*named[i]), Qt::ElideRight,
                                                           static_cast<int>(width() - name_left - 4.0));
    draw_text(painter, {name_left, places[i] + 4.0}, title, here ? theme.text : theme.second);
  }
}

void DepthLadder::draw_tip_and_target(QPainter& painter) const {
  const Theme& theme = Theme::dark();
  constexpr double middle = bar_left + 0.5 * bar_width;
  if (target_ > 0.0 && target_ < length_) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 190), 4.0));
    painter.drawEllipse(QPointF(middle, row(target_)), 5.5, 5.5);
    painter.setPen(QPen(theme.plan, 2.0));
    painter.drawEllipse(QPointF(middle, row(target_)), 5.5, 5.5);
    if (reached_) painter.drawEllipse(QPointF(middle, row(target_)), 9.0, 9.0);
  }
  const double y = std::clamp(row(std::max(0.0, touched_)), bar_top, height() - below_bar);
  painter.setPen(QPen(QColor(0, 0, 0, 200), 4.0));
  painter.drawLine(QPointF(bar_left - 2.0, y), QPointF(bar_left + bar_width + 2.0, y));
  painter.setPen(QPen(Qt::white, 2.0));
  painter.drawLine(QPointF(bar_left - 2.0, y), QPointF(bar_left + bar_width + 2.0, y));
  painter.setPen(QPen(QColor(0, 0, 0, 200), 1.0));
  painter.setBrush(Qt::white);
  const QPointF arrow[] = {{1.5, y - 5.5}, {bar_left - 1.0, y}, {1.5, y + 5.5}};
  painter.drawConvexPolygon(arrow, 3);
}

}  // namespace bodkin::views
