#include "views/force_chart.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "views/language.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr anatomy::TissueId not_met = 255;
constexpr double least_depth = 60.0, least_time = 30.0;  // mm, s of an empty chart
constexpr double least_force = 4.0;                      // N
constexpr double real_turn = 0.3;                        // mm: less is the tremor of a hand
constexpr double worth_zooming = 6.0;                    // pixels

}  // namespace

void CrossedTissues::add(double depth, anatomy::TissueId tissue) {
  constexpr double deepest = 1000.0;  // mm
  if (!(depth > 0.0 && depth < deepest) || tissue == anatomy::tissue::air) return;
  const auto piece = static_cast<std::size_t>(depth / step);
  if (piece >= by_depth_.size()) by_depth_.resize(piece + 1, tissue);
  by_depth_[piece] = tissue;
}

std::vector<TissueBand> CrossedTissues::bands() const {
  std::vector<TissueBand> bands;
  for (std::size_t i = 0; i < by_depth_.size(); ++i) {
    if (by_depth_[i] == not_met) continue;
    const double from = step * static_cast<double>(i), to = step * static_cast<double>(i + 1);
    if (!bands.empty() && bands.back().tissue == by_depth_[i] && bands.back().to > from - 0.5 * step) {
      bands.back().to = to;
    } else {
      bands.push_back({from, to, by_depth_[i]});
    }
  }
  return bands;
}

void ForceChart::Trace::add(double time, double depth, bool out, double value) {
  in_time.add(time, value);
  if (depth > 0.0) {
    (out ? outwards : inwards).add(depth, value);
    (out ? inwards : outwards).lift();
  } else {
    inwards.lift();
    outwards.lift();
  }
}

void ForceChart::Trace::lift() {
  inwards.lift();
  outwards.lift();
  in_time.lift();
}

void ForceChart::Trace::clear() {
  lift();
  inwards.clear();
  outwards.clear();
  in_time.clear();
}

ForceChart::ForceChart(QWidget* parent) : View(parent) {
  setMouseTracking(true);
  setMinimumSize(200, 90);
  setAccessibleName(tr("Force chart"));
  setToolTip(tr("Force on the needle. Drag to zoom in, double click to see all, right click for more."));
}

void ForceChart::set_case(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  clear();
}

void ForceChart::clear() {
  for (Trace* trace : {&force_, &along_, &across_, &number_}) trace->clear();
  met_.clear();
  flags_.clear();
  depth_ = time_ = now_ = turning_ = 0.0;
  in_body_ = out_ = false;
  zoom_.reset();
  update();
}

void ForceChart::set_axis(Axis axis) {
  axis_ = axis;
  zoom_.reset();
  update();
}

void ForceChart::set_cursor(const std::optional<Cursor>& cursor) {
  cursor_ = cursor;
  update();
}

void ForceChart::compare_with(std::span<const station::HandSample> samples) {
  other_.clear();
  double turning = 0.0;
  bool out = false;
  for (const station::HandSample& sample : samples) {
    turning = sample.depth <= 0.0 ? 0.0 : out ? std::min(turning, sample.depth) : std::max(turning, sample.depth);
    if (sample.depth <= 0.0) {
      out = false;
    } else if (std::abs(sample.depth - turning) > real_turn) {
      out = !out;
      turning = sample.depth;
    }
    other_.add(sample.time, sample.depth, out, sample.force);
  }
  update();
}

void ForceChart::show_tissues(bool shown) {
  tissues_shown_ = shown;
  update();
}

void ForceChart::set_end_of_time(std::optional<double> end) {
  end_of_time_ = end;
  update();
}

void ForceChart::show_components(bool shown) {
  components_ = shown;
  update();
}

void ForceChart::show_diagnostic(std::optional<std::size_t> index) {
  diagnostic_ = index;
  number_.clear();
  update();
}

void ForceChart::show_frame(const Frame& frame, const Changes& changes) {
  if (changes.attempt) clear();
  planned_ = frame.plan ? frame.plan->length() : 0.0;
  if (diagnostic_titles_.size() != frame.diagnostic_names.size()) {
    diagnostic_titles_.clear();
    for (const forces::DiagnosticName& name : frame.diagnostic_names) {
      if (!name.name.empty()) {
        diagnostic_titles_.push_back(in_words(std::string(name.title)));
      }
    }
  }
  take(frame);
  stale_ = stale_ || changes.force || changes.needle || changes.tissue || changes.attempt || changes.theme ||
           !frame.events.empty();
  // A curve cannot be read faster, and it is the most expensive view to paint.
  constexpr double interval = 1.0 / 30.0;  // s
  if (!stale_ || (frame.clock >= drawn_ && frame.clock - drawn_ < interval)) return;
  drawn_ = frame.clock;
  stale_ = false;
  update();
}

void ForceChart::take(const Frame& frame) {
  for (const station::HandSample& sample : frame.samples) {
    in_body_ = sample.depth > 0.0;
    turning_ = !in_body_ ? 0.0 : out_ ? std::min(turning_, sample.depth) : std::max(turning_, sample.depth);
    if (!in_body_) {
      out_ = false;
    } else if (std::abs(sample.depth - turning_) > real_turn) {
      out_ = !out_;
      turning_ = sample.depth;
    }
    force_.add(sample.time, sample.depth, out_, sample.force);
    along_.add(sample.time, sample.depth, out_, sample.resistance);
    across_.add(sample.time, sample.depth, out_, sample.constraint);
    met_.add(sample.depth, sample.tissue);
    depth_ = sample.depth;
    time_ = sample.time;
    now_ = sample.force;
  }
  if (diagnostic_ && *diagnostic_ < frame.diagnostics.size() && !frame.samples.empty()) {
    number_.add(time_, depth_, out_, frame.diagnostics[*diagnostic_]);
  }
  for (const session::SessionEvent& event : frame.events) flag(frame, event);
}

void ForceChart::flag(const Frame& frame, const session::SessionEvent& event) {
  using forces::EventKind;
  QString words;
  bool bad = false;
  switch (event.event.kind) {
    case EventKind::puncture:
      words = patient_ == nullptr || !tissues_shown_ ? tr("give")
                                                     : in_words(patient_->patient.library.title(event.event.tissue));
      break;
    case EventKind::loss_of_resistance:
      words = tr("loss of resistance");
      break;
    case EventKind::bone_contact:
      words = tr("bone");
      bad = true;
      break;
    case EventKind::fluid_returned:
      words = tr("fluid");
      break;
    case EventKind::pressure_read:
      words = tr("%1 cm of fluid").arg(0.1 * event.event.value, 0, 'f', 1);
      break;
    case EventKind::pressure_lost:
      words = tr("plunger gives way");
      break;
    case EventKind::hub_contact:
      words = tr("hub on the skin");
      break;
    case EventKind::fault:
      words = tr("fault");
      bad = true;
      break;
    default:
      return;
  }
  flags_.push_back({event.event.depth, static_cast<double>(event.tick) / frame.rate, words, bad});
}

QRectF ForceChart::plot() const {
  constexpr double left = 40.0, over = 26.0, right = 14.0, under = 24.0;  // pixels
  return {left, over, std::max(10.0, width() - left - right), std::max(10.0, height() - over - under)};
}

double ForceChart::from() const {
  return zoom_ ? zoom_->from : 0.0;
}

double ForceChart::to() const {
  if (zoom_) return zoom_->to;
  if (axis_ == Axis::time && end_of_time_) return std::max(*end_of_time_, 1.0);
  if (axis_ == Axis::time) return axis_end(force_.in_time.reach(), least_time);
  constexpr double beyond = 1.1, decade = 10.0;
  const double reach = std::max({least_depth, beyond * planned_, force_.inwards.reach()});
  return decade * std::ceil(reach / decade);
}

double ForceChart::top() const {
  double most = force_.inwards.usual_most();
  if (axis_ == Axis::time) most = std::max(most, force_.in_time.usual_most());
  if (components_) most = std::max(most, along_.inwards.usual_most());
  constexpr double room = 1.08;
  return axis_end(room * most, least_force);
}

double ForceChart::bottom() const {
  const double least = components_ ? std::min(0.0, static_cast<double>(along_.in_time.range().least)) : 0.0;
  return least < -0.05 ? -axis_end(-least, 0.5) : 0.0;  // friction on the way out
}

QPointF ForceChart::place(double along, double force) const {
  const QRectF box = plot();
  return {box.left() + box.width() * (along - from()) / (to() - from()),
          box.bottom() - box.height() * (force - bottom()) / (top() - bottom())};
}

double ForceChart::along_at(double x) const {
  const QRectF box = plot();
  return from() + (to() - from()) * std::clamp((x - box.left()) / box.width(), 0.0, 1.0);
}

void ForceChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) pressed_ = event->pos();
  if (event->button() == Qt::RightButton) open_menu(event->pos());
}

void ForceChart::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->pos();
  update();
}

void ForceChart::mouseReleaseEvent(QMouseEvent* event) {
  const std::optional<QPoint> begun = std::exchange(pressed_, std::nullopt);
  if (!begun || event->button() != Qt::LeftButton) return;
  if (std::abs(event->pos().x() - begun->x()) > worth_zooming) {
    const double one = along_at(begun->x()), other = along_at(event->pos().x());
    zoom_ = Zoom{std::min(one, other), std::max(one, other)};
  } else if (cursor_) {
    emit place_chosen(along_at(event->pos().x()));
  }
  update();
}

void ForceChart::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
  zoom_.reset();
  pressed_.reset();
  update();
}

void ForceChart::leaveEvent(QEvent* /*event*/) {
  pointer_.reset();
  update();
}

}  // namespace bodkin::views
