// The overlays of a slice, and its menu.
#include <QMenu>
#include <QPainter>
#include <array>
#include <cmath>
#include <string>

#include "views/language.h"
#include "views/paint_kit.h"
#include "views/slice_view.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double near_the_plane = 3.0;  // mm: what is farther is drawn faintly
constexpr double colour_strip = 3.0;    // pixels, of the plane's colour along the upper edge
const QColor slice_ink(0xE9, 0xEE, 0xF4), slice_second(0xB4, 0xBE, 0xCA);

QString letters_of(const Vec3& direction) {
  return QString::fromStdString(imaging::direction_letters(direction));
}

// The end of the cord, the upper limit for a lumbar puncture, in the planes that pass near it.
void draw_conus(QPainter& painter, const SliceView& view, const OpenCase& patient) {
  constexpr double near_the_end = 6.0;                  // mm
  constexpr double gap = 5.0, stroke = 22.0, up = 4.0;  // pixels
  const imaging::SlicePlane now = view.plane();
  for (const anatomy::Landmark& landmark : patient.description().landmarks) {
    if (landmark.name != "conus" || std::abs(now.distance(landmark.position)) > near_the_end) continue;
    const QPointF at = view.to_widget(landmark.position);
    if (!view.rect().adjusted(20, 30, -60, -30).contains(at.toPoint())) continue;
    const QColor ink = Theme::dark().caution;
    draw_line_on_picture(painter, at + QPointF(gap, 0.0), at + QPointF(stroke, 0.0), ink, 1.5, 1.0);
    set_font(painter, label_size, true);
    draw_text_on_picture(painter, at + QPointF(stroke + up, up), SliceView::tr("conus"), ink);
  }
}

}  // namespace

QColor SliceView::colour() const {
  switch (kind_) {
    case SliceKind::axial:
      return axial_colour;
    case SliceKind::coronal:
      return coronal_colour;
    case SliceKind::sagittal:
      return sagittal_colour;
    case SliceKind::along_needle:
      break;
  }
  return along_colour;
}

QString SliceView::title() const {
  switch (kind_) {
    case SliceKind::axial:
      return tr("Axial");
    case SliceKind::coronal:
      return tr("Coronal");
    case SliceKind::sagittal:
      return tr("Sagittal");
    case SliceKind::along_needle:
      break;
  }
  return tr("Along the needle");
}

void SliceView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (patient_ != nullptr) {
    QImage picture = image_.picture(plane(), look_, shown_.drawn_in, shown_.moved_tissue);
    picture.setDevicePixelRatio(devicePixelRatioF());
    painter.drawImage(QPointF(0.0, 0.0), picture);
    painter.setRenderHint(QPainter::Antialiasing);
    draw_crosshair(painter);
    draw_plan(painter);
    draw_trails(painter);
    draw_left_needles(painter);
    draw_needle(painter);
    if (look_.tints) draw_conus(painter, *this, *patient_);
    draw_measures(painter);
  }
  draw_words(painter);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(QRectF(0.0, 0.0, width(), colour_strip), colour());
  if (hasFocus()) {
    painter.setPen(QPen(colour(), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

// Each line has the colour of its plane, and leaves the tip free.
void SliceView::draw_crosshair(QPainter& painter) const {
  constexpr double open = 14.0;  // pixels
  const QPointF at = to_widget(shown_.follows && shown_.has_needle ? shown_.tip : shown_.crosshair);
  const auto line = [&](bool across, QColor ink) {
    ink.setAlphaF(0.45);
    painter.setPen(QPen(ink, 1.0));
    const QPointF step = across ? QPointF(1.0, 0.0) : QPointF(0.0, 1.0);
    const double before = across ? at.x() : at.y(), after = across ? width() - at.x() : height() - at.y();
    painter.drawLine(at - before * step, at - open * step);
    painter.drawLine(at + open * step, at + after * step);
  };
  painter.setRenderHint(QPainter::Antialiasing, false);
  line(true, kind_ == SliceKind::axial ? coronal_colour : axial_colour);
  line(false, kind_ == SliceKind::axial || kind_ == SliceKind::coronal ? sagittal_colour : coronal_colour);
  painter.setRenderHint(QPainter::Antialiasing);
}

void SliceView::draw_plan(QPainter& painter) const {
  if (!shown_.plan) return;
  constexpr double least_radius = 5.0;  // pixels
  const QColor teal = Theme::dark().plan;
  const QPointF entry = to_widget(shown_.plan->entry), target = to_widget(shown_.plan->target);
  const double radius = std::max(least_radius, shown_.tolerance / (plane().pixel * devicePixelRatioF()));
  const QPointF way = target - entry;
  const double length = std::hypot(way.x(), way.y());
  const double whole = shown_.plan->length();
  const auto at_depth = [&](double depth) { return entry + (whole > 0.0 ? depth / whole : 0.0) * way; };
  const double to = length > radius ? whole * (1.0 - radius / length) : 0.0;
  const auto pass = [&](const QColor& ink, double wide) {
    QPen pen(ink, wide);
    pen.setCapStyle(Qt::FlatCap);
    if (length > radius) {
      pen.setDashPattern({6.0 / wide, 4.0 / wide});
      painter.setPen(pen);
      double from = 0.0;
      for (const auto& [begin, end] : shown_.broken) {
        if (begin > from) painter.drawLine(at_depth(from), at_depth(begin));
        from = end;
      }
      if (from < to) painter.drawLine(at_depth(from), at_depth(to));
    }
    pen.setStyle(Qt::SolidLine);
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(target, radius, radius);
  };
  pass(QColor(0, 0, 0, 170), 3.5);
  pass(teal, 1.5);
  if (shown_.is_planning) {
    painter.setPen(QPen(QColor(0, 0, 0, 170), 1.0));
    painter.setBrush(teal);
    painter.drawEllipse(entry, least_radius, least_radius);
  }
  // Forbidden stretches: a red bar across each end, nothing between.
  constexpr double half_bar = 5.0;  // pixels
  if (length <= 0.0) return;
  const QPointF across = half_bar / length * QPointF(-way.y(), way.x());
  for (const auto& [begin, end] : shown_.broken) {
    for (const double depth : {begin, end})
      draw_line_on_picture(painter, at_depth(depth) - across, at_depth(depth) + across, Theme::dark().danger, 2.0);
  }
}

void SliceView::draw_trails(QPainter& painter) const {
  if (trails_ == nullptr) return;
  const imaging::SlicePlane now = plane();
  const double thickness = near_the_plane + 0.5 * look_.slab.thickness;
  constexpr double faint = 0.45;
  for (const scene::Trail& trail : *trails_) {
    const QColor ink(static_cast<QRgb>(trail.colour));
    for (std::size_t i = 0; i + 1 < trail.points.size(); ++i) {
      const Vec3 middle = 0.5 * (trail.points[i] + trail.points[i + 1]);
      painter.setOpacity(std::abs(now.distance(middle)) <= thickness ? 1.0 : faint);
      draw_line_on_picture(painter, to_widget(trail.points[i]), to_widget(trail.points[i + 1]), ink, trail.width,
                           1.0);
    }
  }
  painter.setOpacity(1.0);
}

// Without ticks: only the needle in the hand is to be read.
void SliceView::draw_left_needles(QPainter& painter) const {
  const imaging::SlicePlane now = plane();
  const double ratio = devicePixelRatioF(), thickness = near_the_plane + 0.5 * look_.slab.thickness;
  const auto place = [&](const Eigen::Vector2d& at) {
    return QPointF((at.x() + 0.5) / ratio, (at.y() + 0.5) / ratio);
  };
  for (const Pose& left : shown_.left) {
    const Vec3 tip = left.translation(), hub = tip - patient_->description().needle.length * needle_axis(left);
    for (const NeedleOnSlice::Piece& piece : project_needle(now, tip, hub, thickness).pieces) {
      painter.setOpacity(piece.near ? 0.8 : 0.3);
      draw_line_on_picture(painter, place(piece.from), place(piece.to), steel, 1.5, 1.0);
    }
  }
  painter.setOpacity(1.0);
}

void SliceView::draw_needle(QPainter& painter) const {
  if (!shown_.has_needle) return;
  const imaging::SlicePlane now = plane();
  const double ratio = devicePixelRatioF(), thickness = near_the_plane + 0.5 * look_.slab.thickness;
  const Vec3 hub = shown_.tip - patient_->description().needle.length * shown_.axis;
  const NeedleOnSlice needle = project_needle(now, shown_.tip, hub, thickness);
  const auto place = [&](const Eigen::Vector2d& at) {
    return QPointF((at.x() + 0.5) / ratio, (at.y() + 0.5) / ratio);
  };
  constexpr double faint = 0.45;
  for (const NeedleOnSlice::Piece& piece : needle.pieces) {
    painter.setOpacity(piece.near ? 1.0 : faint);
    draw_line_on_picture(painter, place(piece.from), place(piece.to), Qt::white, 2.0);
  }
  // Ticks run across the needle; seen nearly end on they would overlap.
  constexpr double least_between = 4.0, half = 4.0, half_of_fifty = 6.0;  // pixels
  const double between = 10.0 * needle.foreshortening / (now.pixel * ratio);
  const QPointF across(-needle.along.y(), needle.along.x());
  for (const NeedleOnSlice::Tick& tick : needle.ticks) {
    if (between < least_between) break;
    const bool fifty = tick.millimetres % 50 == 0;
    painter.setOpacity(tick.near ? 1.0 : faint);
    const QPointF at = place(tick.at), arm = (fifty ? half_of_fifty : half) * across;
    draw_line_on_picture(painter, at - arm, at + arm, fifty ? fiftieth_mark : QColor(Qt::white), 1.5, 1.0);
  }
  painter.setOpacity(std::abs(needle.distance) <= thickness ? 1.0 : faint);
  draw_tip(painter, place(needle.tip), shown_.shape, tissue_colour(shown_.tissue, patient_->patient.library));
  painter.setOpacity(1.0);
}

void SliceView::draw_measures(QPainter& painter) const {
  const imaging::SlicePlane now = plane();
  const QColor ink(0xFF, 0xE0, 0x66);
  set_font(painter, 12, true);
  const auto chain = [&](const std::vector<Vec3>& places) {
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      draw_line_on_picture(painter, to_widget(places[i]), to_widget(places[i + 1]), ink, 1.5);
    }
    for (const Vec3& place : places) {
      painter.setPen(QPen(Qt::black, 1.0));
      painter.setBrush(ink);
      painter.drawEllipse(to_widget(place), 3.0, 3.0);
    }
  };
  const auto write = [&](const Measure& measure) {
    const QPointF at = measure.kind == Measure::Kind::angle
                           ? to_widget(measure.places[1])
                           : 0.5 * (to_widget(measure.places[0]) + to_widget(measure.places[1]));
    draw_text_on_picture(painter, at + QPointF(8.0, -8.0), QString::fromStdString(text_of(measure)), ink);
  };
  for (const Measure& measure : measures_->all()) {
    // A measure belongs to the slice in which it was made.
    bool here = true;
    for (std::size_t i = 0; i < measure.count(); ++i)
      here = here && std::abs(now.distance(measure.places[i])) < near_the_plane;
    if (!here) continue;
    chain({measure.places.begin(), measure.places.begin() + static_cast<std::ptrdiff_t>(measure.count())});
    write(measure);
  }
  if (!pointer_) return;
  if (const auto places = measures_->preview(to_patient(*pointer_))) {
    chain(*places);
    if (const auto finished = measures_->with_next(to_patient(*pointer_))) write(*finished);
  }
}

QString SliceView::words_under_pointer() const {
  const Vec3 point = image_.at_rest(to_patient(*pointer_));
  const anatomy::Case& patient = patient_->patient;
  QString words;
  if (!patient.ct.empty()) {
    const double hounsfield = anatomy::linear(patient.ct, point, std::nan(""));
    words = std::isnan(hounsfield) ? tr("outside the CT") : tr("%1 HU").arg(std::lround(hounsfield));
  }
  const std::string name = place_name(patient, point);
  if (!name.empty()) words += (words.isEmpty() ? QString() : QStringLiteral(" · ")) + in_words(name);
  return words;
}

void SliceView::draw_words(QPainter& painter) const {
  constexpr double aside = 10.0;
  set_font(painter, text_size, true);
  draw_text_on_picture(painter, {aside, 22.0}, title(), colour());
  if (patient_ == nullptr) {
    set_font(painter, text_size);
    return draw_text(painter, QPointF(0.5 * width(), 0.5 * height()), tr("No patient is open"), slice_second,
                     Anchor::middle);
  }
  const imaging::SlicePlane now = plane();
  set_font(painter, text_size);
  if (kind_ != SliceKind::along_needle) {
    draw_text_on_picture(painter, {width() - aside, 22.0}, QString::fromStdString(position_text(now, middle_)),
                         slice_second, Anchor::right);
  }
  set_font(painter, text_size, true);
  const double half = 0.5 * height() + 5.0;
  draw_text_on_picture(painter, {aside, half}, letters_of(-now.right), slice_ink);
  draw_text_on_picture(painter, {width() - aside, half}, letters_of(now.right), slice_ink, Anchor::right);
  draw_text_on_picture(painter, {0.5 * width(), height() - 10.0}, letters_of(now.down), slice_ink, Anchor::middle);

  // A scale bar with its length above it.
  const double pixel = now.pixel * devicePixelRatioF();
  const double bar = scale_bar(pixel, 0.22 * width()), long_pixels = bar / pixel;
  const double right = width() - aside, foot = height() - 10.0;
  draw_line_on_picture(painter, {right - long_pixels, foot}, {right, foot}, slice_ink, 1.5, 1.0);
  for (const double x : {right - long_pixels, right}) {
    draw_line_on_picture(painter, {x, foot - 4.0}, {x, foot}, slice_ink, 1.5, 1.0);
  }
  set_font(painter, label_size);
  draw_text_on_picture(painter, {right - 0.5 * long_pixels, foot - 8.0}, tr("%1 mm").arg(bar), slice_ink,
                       Anchor::middle);

  QString words = tr("W %1  L %2").arg(std::lround(look_.window)).arg(std::lround(look_.level));
  if (look_.slab.thickness > 0.0) {
    words += QStringLiteral("  ") + (look_.slab.kind == SlabKind::mean ? tr("%1 mm").arg(look_.slab.thickness)
                                                                       : tr("MIP %1 mm").arg(look_.slab.thickness));
  }
  if (measures_->waiting()) {
    words = tr("Click the places, right click cancels");
  } else if (pointer_ && drag_ != Drag::window) {
    words = words_under_pointer();
  }
  const double room = 0.5 * width() - 2.0 * aside - (pointer_ ? 0.0 : 6.0);
  const double most = width() - 3.0 * aside - std::max(long_pixels, 34.0);
  const QString shown = painter.fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(most));
  // Above the letter in the middle if they would overlap it.
  const bool high = painter.fontMetrics().horizontalAdvance(shown) > room;
  draw_text_on_picture(painter, {aside, foot - (high ? 18.0 : 0.0)}, shown, pointer_ ? slice_ink : slice_second);
}

void SliceView::open_menu(const QPoint& at) {
  QMenu menu(this);
  const auto add = [&](const QString& text, auto&& act) {
    connect(menu.addAction(text), &QAction::triggered, this, act);
  };
  for (const WindowPreset& preset : window_presets) {
    add(tr("%1 (W %2, L %3)").arg(tr(preset.name)).arg(preset.window).arg(preset.level), [this, preset] {
      SliceLook look = look_;
      look.window = preset.window;
      look.level = preset.level;
      set_look(look);
    });
  }
  menu.addSeparator();
  add(tr("Measure a distance (M)"), [this] { press(Qt::Key_M); });
  add(tr("Measure an angle (Q)"), [this] { press(Qt::Key_Q); });
  add(tr("Delete all measures"), [this] {
    measures_->clear();
    emit measures_changed();
    update();
  });
  menu.addSeparator();
  add(look_.tints ? tr("Hide tissue colours") : tr("Show tissue colours"), [this] {
    SliceLook look = look_;
    look.tints = !look.tints;
    look.hatched = look.tints;
    set_look(look);
  });
  const bool is_along = kind_ == SliceKind::along_needle;
  add(is_along ? tr("Not along the needle (N)") : tr("Along the needle (N)"), [this] { press(Qt::Key_N); });
  add(tr("Next slab thickness (T)"), [this] { next_slab(); });
  add(cine_ ? tr("Stop (C)") : tr("Run through the slices (C)"), [this] { press(Qt::Key_C); });
  add(shown_.follows ? tr("Stay here (F)") : tr("Follow the tip (F)"), [this] { emit follow_tip_toggled(); });
  add(tr("Whole procedure (Home)"), [this] { show_whole_procedure(); });
  add(tr("Enlarge this view (Enter)"), [this] { emit fill_requested(); });
  menu.exec(mapToGlobal(at));
}

}  // namespace bodkin::views
