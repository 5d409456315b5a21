// How the ultrasound view is drawn.
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "views/language.h"
#include "views/paint_kit.h"
#include "views/slice_geometry.h"
#include "views/theme.h"
#include "views/ultrasound_view.h"

#include "imaging/ultrasound_screen/scan_field.h"

namespace bodkin::views {

namespace {

// In the order of use.
constexpr std::array<std::array<const char*, 2>, 19> scan_help = {
    {{"drag, I J K L", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "slide the probe over the skin")},
     {"wheel", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "press it in, lift it off")},
     {"left, right", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "rotate it on the spot")},
     {"up, down", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "tilt: the slice fans")},
     {"Shift left, right", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "rock within the slice")},
     {"D, Shift wheel", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "depth; Shift D less")},
     {"G", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "gain")},
     {"R", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "dynamic range")},
     {"O", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "focus")},
     {"Q", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "frequency")},
     {"T, 1 to 8, 0", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "gain by depth (TGC), all to the middle")},
     {"F", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "freeze")},
     {"C", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "calipers: two clicks each")},
     {"M", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "mark the place under the pointer")},
     {"X", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "clear calipers and marks")},
     {"S", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "keep the picture")},
     {"N", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "needle in or out; without an attempt")},
     {"PgDn, PgUp",
      QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "needle deeper, shallower; without an attempt")},
     {"H", QT_TRANSLATE_NOOP("bodkin::views::UltrasoundView", "these keys")}}};

}  // namespace

void UltrasoundView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (!scan_) {
    set_font(painter, text_size);
    draw_text(painter, QPointF(0.5 * width(), 0.5 * height()), tr("This session has no ultrasound"),
              Theme::dark().second, Anchor::middle);
  } else {
    draw_machine(painter);
    if (shows_ct()) draw_ct(painter);
    if (scan_->sliders_shown()) draw_sliders(painter);
  }
  draw_words(painter);
  if (scan_ && scan_->help()) draw_help(painter);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(QRectF(0.0, 0.0, width(), 3.0), along_colour);
  if (hasFocus()) {
    painter.setPen(QPen(along_colour, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void UltrasoundView::draw_machine(QPainter& painter) {
  if (scan_->screen().empty()) {
    set_font(painter, text_size);
    return draw_text(painter, machine_box().center(), tr("The first picture is being made"), Theme::dark().second,
                     Anchor::middle);
  }
  if (stale_) {
    const imaging::ImageRgb composed = scan_->screen().compose();
    machine_ = QImage(reinterpret_cast<const uchar*>(composed.pixels.data()), composed.width, composed.height,
                      3 * composed.width, QImage::Format_RGB888)
                   .convertToFormat(QImage::Format_RGB32);
    stale_ = false;
  }
  painter.drawImage(machine_box().topLeft(), machine_);
}

void UltrasoundView::draw_ct(QPainter& painter) {
  const QRectF box = ct_box();
  painter.setPen(QPen(Theme::dark().line, 1.0));
  painter.drawLine(QPointF(box.left() - 0.5, 3.0), QPointF(box.left() - 0.5, height()));
  if (scan_->screen().empty()) return;
  const imaging::ScanState& moment = scan_->screen().moment();
  if (!moment.pose.matrix().allFinite()) return;
  // The plane of the ultrasound's picture, in the pixels of the view.
  imaging::SlicePlane plane = imaging::plane_of(moment.frame, moment.pose, choice_->mark);
  const double wide = plane.pixel * plane.width, high = plane.pixel * plane.height;
  const Vec3 middle = plane.point(0.5 * (plane.width - 1), 0.5 * (plane.height - 1));
  plane.width = std::max(1, static_cast<int>(box.width()));
  plane.height = std::max(1, static_cast<int>(box.height()));
  plane.pixel = std::max(wide / plane.width, high / plane.height);
  plane.corner =
      middle - plane.pixel * (0.5 * (plane.width - 1) * plane.right + 0.5 * (plane.height - 1) * plane.down);
  painter.drawImage(box.topLeft(), ct_.picture(plane, SliceLook{}));
  const auto spot = [&](const Vec3& point) {
    const Eigen::Vector2d at = plane.place(point);
    return box.topLeft() + QPointF(at.x() + 0.5, at.y() + 0.5);
  };
  painter.save();
  painter.setClipRect(box);
  painter.setRenderHint(QPainter::Antialiasing);
  QPolygonF field;
  for (const Eigen::Vector2d& border : imaging::field_of_view(moment.probe, moment.settings.depth)) {
    field << spot(moment.pose * Vec3(border.x(), border.y(), 0.0));
  }
  painter.setPen(QPen(along_colour, 1.25));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolygon(field);
  if (plan_) {
    painter.setPen(QPen(Theme::dark().plan, 1.5, Qt::DashLine));
    painter.drawLine(spot(plan_->entry), spot(plan_->target));
  }
  if (has_needle_) {
    const Vec3 hub = needle_tip_ - patient_->description().needle.length * needle_axis_;
    constexpr double near_plane = 2.0;  // mm
    for (const NeedleOnSlice::Piece& piece : project_needle(plane, needle_tip_, hub, near_plane).pieces) {
      painter.setOpacity(piece.near ? 1.0 : 0.4);
      draw_line_on_picture(painter, box.topLeft() + QPointF(piece.from.x(), piece.from.y()),
                           box.topLeft() + QPointF(piece.to.x(), piece.to.y()), Qt::white, 2.0);
    }
    painter.setOpacity(1.0);
  }
  painter.restore();
  set_font(painter, text_size, true);
  const double half = box.center().y();
  const auto letters = [](const Vec3& direction) {
    return QString::fromStdString(imaging::direction_letters(direction));
  };
  draw_text_on_picture(painter, {box.left() + 8.0, half}, letters(-plane.right), Theme::dark().text);
  draw_text_on_picture(painter, {box.right() - 8.0, half}, letters(plane.right), Theme::dark().text, Anchor::right);
  draw_text_on_picture(painter, {box.center().x(), box.bottom() - 8.0}, letters(plane.down), Theme::dark().text,
                       Anchor::middle);
}

void UltrasoundView::draw_sliders(QPainter& painter) const {
  using station::LiveScan;
  constexpr double row = LiveScan::slider_row, knob = 8.0, aside = 84.0, above = 8.0;  // pixels
  const LiveScan::Place& place = scan_->place();
  const auto& sliders = scan_->settings().sliders;
  const double x = place.sliders_x, wide = place.sliders_width;
  const Theme& theme = Theme::dark();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme.line, 1.0));
  painter.setBrush(theme.panel);
  painter.drawRoundedRect(QRectF(x - aside, place.sliders_y - above, wide + 2.0 * aside - 8.0,
                                 row * static_cast<double>(sliders.size()) + 2.0 * above),
                          corner, corner);
  set_font(painter, label_size);
  painter.fillRect(QRectF(x + 0.5 * wide, place.sliders_y, 1.0, row * static_cast<double>(sliders.size())),
                   theme.second);
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    const double middle = place.sliders_y + row * (static_cast<double>(i) + 0.5);
    const double at = x + 0.5 * wide * (1.0 + sliders[i] / LiveScan::slider_most);
    const double from = scan_->settings().depth * static_cast<double>(i) / static_cast<double>(sliders.size() - 1);
    draw_text(painter, {x - 14.0, middle + 4.0}, tr("%1   %2 cm").arg(i + 1).arg(0.1 * from, 0, 'f', 1), theme.second,
              Anchor::right);
    painter.fillRect(QRectF(x, middle - 1.5, wide, 3.0), theme.line);
    painter.fillRect(QRectF(at - 0.5 * knob, middle - 6.0, knob, 12.0),
                     sliders[i] == 0.0 ? theme.second : theme.accent);
    draw_text(painter, {x + wide + 68.0, middle + 4.0}, tr("%1 dB").arg(sliders[i], 0, 'f', 1), theme.text,
              Anchor::right);
  }
}

void UltrasoundView::draw_help(QPainter& painter) const {
  constexpr double around = 22.0, words = 118.0, roomy = 16.0;
  const double row = std::clamp((height() - around - 6.0) / static_cast<double>(scan_help.size()), 13.0, 18.0);
  const int size = row < roomy ? label_size : 12;
  const Theme& theme = Theme::dark();
  QRectF box(0.0, 0.0, 380.0, row * static_cast<double>(scan_help.size()) + around);
  box.moveCenter(QRectF(rect()).center());
  box.moveTop(std::max(box.top(), 3.0));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme.line, 1.0));
  painter.setBrush(theme.raised);
  painter.drawRoundedRect(box, corner, corner);
  double y = box.top() + row + 4.0;
  for (const auto& [keys, what] : scan_help) {
    set_font(painter, size, true);
    draw_text(painter, {box.left() + 14.0, y}, QString::fromLatin1(keys), theme.text);
    set_font(painter, size);
    draw_text(painter, {box.left() + 14.0 + words, y}, tr(what), theme.second);
    y += row;
  }
}

void UltrasoundView::draw_words(QPainter& painter) const {
  const Theme& theme = Theme::dark();
  set_font(painter, text_size, true);
  draw_text(painter, {10.0, 22.0}, tr("Ultrasound"), along_colour);
  if (!scan_) return;
  if (shows_ct()) draw_text(painter, {ct_box().left() + 10.0, 22.0}, tr("CT, the same plane"), theme.text);
  // A recorded image has neither keys nor a rate.
  if (testAttribute(Qt::WA_TransparentForMouseEvents)) return;
  set_font(painter, text_size);
  if (!scan_->screen().frozen() && rate_ >= 0.5) {  // none are made while nothing moves
    draw_text(painter, {machine_box().right() - 10.0, 22.0}, tr("%1 pictures/s").arg(rate_, 0, 'f', 0), theme.second,
              Anchor::right);
  }
  constexpr double worth_reporting = 0.05;  // N
  QString words = tr("H: keys");
  bool warn = false;
  if (!scan_->message().empty()) {
    words = in_words(scan_->message());
    warn = true;
  } else if (scan_->measuring()) {
    words = tr("Calipers: click two places; C again to move the probe");
  } else if (left_out_ > worth_reporting) {
    words = tr("%1 N of the needle, off the path, are not shown").arg(left_out_, 0, 'f', 1);
    warn = true;
  }
  set_font(painter, 12);
  draw_text(painter, {10.0, height() - 9.0},
            painter.fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(machine_box().width()) - 20),
            warn ? theme.caution : theme.second);
}

}  // namespace bodkin::views
