#include "views/atlas_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "patient/acupuncture/collaterals.h"
#include "scene/camera_moves.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double body_height = 1860.0;  // mm that the picture is high
constexpr double near_height = 420.0;   // mm, about a point that is looked at
constexpr double touch = 9.0;           // pixels
constexpr double turn_rate = 0.008;     // rad for a pixel
constexpr double hidden_by = 6.0;       // mm of skin in front of a point that hide it
constexpr double needle_touch = 8.0;    // mm from a needle's tip to a point
constexpr double needle_share = 0.12;   // of the picture's height that a needle is long

scene::ViewSubject whole_body(const patient::Atlas& atlas) {
  scene::ViewSubject subject;
  const double height = 1000.0 * atlas.shape().parameters().height;
  subject.middle = Vec3(0.0, 0.0, 0.5 * height);
  subject.height = body_height * height / 1720.0;
  return subject;
}

QColor colour_of(std::uint32_t rgb) {
  return QColor::fromRgb(QRgb(rgb | 0xFF000000U));
}

}  // namespace

AtlasView::AtlasView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("atlas.view"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(240, 200);
}

void AtlasView::set_body(std::shared_ptr<const patient::Atlas> atlas,
                         std::shared_ptr<const scene::PatientSurfaces> surfaces) {
  atlas_ = std::move(atlas);
  scene_ = std::make_unique<scene::SoftwareView>(std::move(surfaces));
  scene_->set_preset(scene::Preset::skin);
  scene_->set_size(std::max(width(), 1), std::max(height(), 1));
  look_at_all();
}

void AtlasView::look_at_all() {
  if (scene_) move_camera(scene::standard_view(scene::StandardView::anterior, whole_body(*atlas_)));
}

void AtlasView::look_at(const Vec3& place, const Vec3& normal) {
  if (!scene_) return;
  scene::Camera camera = camera_;
  camera.focus = place;
  Vec3 from = normal;
  // Never vertically from above or below: the head stays up.
  from.z() = std::clamp(from.z(), -0.8, 0.8);
  camera.up = Vec3::UnitZ();
  camera.eye = place + 0.5 * near_height / std::tan(0.5 * camera.angle) * from.normalized();
  move_camera(camera);
}

void AtlasView::move_camera(const scene::Camera& camera) {
  camera_ = camera;
  scene_->set_camera(camera_);
  find_visible();
  update();
}

void AtlasView::choose(const patient::AtlasPoint* point) {
  chosen_ = point;
  update();
}

void AtlasView::show_needle(const std::optional<Pose>& hand, double reach) {
  if (!scene_) return;
  const patient::AtlasPoint* point = nullptr;
  tip_.reset();
  std::vector<scene::NeedleLook> needles;
  if (hand) {
    const double high = 2.0 * camera_.distance() * std::tan(0.5 * camera_.angle);  // mm
    const Mat3 seen = camera_.axes();
    Mat3 axes;
    axes << seen.col(0), seen.col(2), -seen.col(1);  // right, away, up
    tip_ = camera_.focus + axes * hand->translation() * (high / reach);
    scene::NeedleLook needle;
    needle.pose.translation() = *tip_;
    needle.pose.linear() = axes * hand->linear();
    needle.shape.length = needle_share * high;
    needle.shape.outer_diameter = 0.01 * needle.shape.length;
    needles.push_back(std::move(needle));
    const patient::Atlas::Near near = atlas_->nearest(*tip_);
    if (!hidden_ && near.distance <= needle_touch) point = near.point;
  }
  scene_->set_needles(std::move(needles));
  if (point != nullptr && point != touched_) emit touched(point);
  touched_ = point;
  if (hand) lit_ = point;
  update();
}

void AtlasView::hide_points(bool hidden) {
  hidden_ = hidden;
  lit_ = nullptr;
  update();
}

void AtlasView::show_answer(const std::optional<Vec3>& shown) {
  shown_ = shown;
  update();
}

void AtlasView::show_message(const QString& sentence) {
  if (message_ == sentence) return;
  message_ = sentence;
  update();
}

bool AtlasView::sees(const Vec3& p) const {
  const scene::Projection projection = scene_->projection();
  const auto place = projection.place(p);
  if (!place || place->x < 0.0 || place->y < 0.0 || place->x >= projection.width() || place->y >= projection.height())
    return false;
  const auto skin = scene_->skin_at(place->x, place->y);
  return !skin || (skin->point - camera_.eye).norm() > (p - camera_.eye).norm() - hidden_by;
}

void AtlasView::find_visible() {
  marks_.clear();
  if (!scene_ || !atlas_) return;
  const scene::Projection projection = scene_->projection();
  for (const patient::AtlasPoint& point : atlas_->points()) {
    for (const bool right : {false, true}) {
      if (right && !point.bilateral) continue;
      const Vec3 place = right ? point.mirrored() : point.place;
      Vec3 normal = point.normal;
      if (right) normal.x() = -normal.x();
      if (normal.dot(camera_.eye - place) <= 0.0 || !sees(place)) continue;
      marks_.push_back({&point, place,
                        projection.place(place)->pixel().x() >= 0.0
                            ? QPointF(projection.place(place)->x, projection.place(place)->y)
                            : QPointF()});
    }
  }
}

std::optional<QPointF> AtlasView::place_of(const Vec3& p) const {
  if (!scene_ || !sees(p)) return std::nullopt;
  const auto place = scene_->projection().place(p);
  return QPointF(place->x, place->y);
}

const AtlasView::Mark* AtlasView::mark_at(const QPointF& at) const {
  const Mark* best = nullptr;
  double least = touch;
  for (const Mark& mark : marks_) {
    const double off = std::hypot(mark.at.x() - at.x(), mark.at.y() - at.y());
    if (off < least) {
      least = off;
      best = &mark;
    }
  }
  return best;
}

void AtlasView::paint_meridians(QPainter& painter) const {
  const scene::Projection projection = scene_->projection();
  const patient::AtlasPoint* lit = lit_ != nullptr ? lit_ : chosen_;
  const patient::Collateral* const collateral = lit != nullptr ? patient::collateral_at(lit->code) : nullptr;
  for (const patient::Meridian& meridian : atlas_->meridians()) {
    const bool is_partner = collateral != nullptr && collateral->partner == meridian.code;
    const bool is_lit = lit != nullptr && (lit->meridian == meridian.name || is_partner);
    QColor colour = colour_of(meridian.colour);
    colour.setAlphaF(is_lit ? 1.0 : lit != nullptr ? 0.35 : 0.75);
    painter.setPen(QPen(colour, is_partner ? 2.0 : is_lit ? 3.0 : 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    for (const bool right : {false, true}) {
      if (right && !meridian.bilateral) continue;
      for (const std::vector<Vec3>& line : meridian.lines) {
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
          Vec3 a = line[i], b = line[i + 1];
          Vec3 normal = atlas_->shape().normal(0.5 * (a + b));
          if (right) {
            a.x() = -a.x();
            b.x() = -b.x();
            normal.x() = -normal.x();
          }
          if (normal.dot(camera_.eye - a) <= 0.05 * (camera_.eye - a).norm()) continue;
          const auto pixels = projection.line(a, b);
          if (!pixels) continue;
          painter.drawLine(QPointF((*pixels)[0].x, (*pixels)[0].y), QPointF((*pixels)[1].x, (*pixels)[1].y));
        }
      }
    }
  }
}

// A straight line from the lit luo-connecting point to the source point of the partner's meridian, as in schemes.
void AtlasView::paint_collateral(QPainter& painter) const {
  const patient::AtlasPoint* const luo = lit_ != nullptr ? lit_ : chosen_;
  const patient::Collateral* const collateral = luo != nullptr ? patient::collateral_at(luo->code) : nullptr;
  const patient::AtlasPoint* const source = collateral != nullptr ? atlas_->find(collateral->source) : nullptr;
  if (source == nullptr) return;
  const scene::Projection projection = scene_->projection();
  painter.setPen(QPen(QColor(255, 210, 70), 2.0, Qt::DashLine, Qt::RoundCap));
  for (const bool right : {false, true}) {
    const Vec3 from = right ? luo->mirrored() : luo->place, to = right ? source->mirrored() : source->place;
    const auto line = projection.line(from, to);
    if (!line || (!sees(from) && !sees(to))) continue;
    painter.drawLine(QPointF((*line)[0].x, (*line)[0].y), QPointF((*line)[1].x, (*line)[1].y));
  }
}

void AtlasView::paint_points(QPainter& painter) const {
  const double size = std::clamp(1.6 * scene_->projection().pixels_per_mm(camera_.focus), 2.0, 5.0);
  const patient::AtlasPoint* lit = lit_ != nullptr ? lit_ : chosen_;
  for (const Mark& mark : marks_) {
    const bool is_lit = mark.point == lit;
    painter.setPen(QPen(QColor(20, 24, 30), 1.0));
    painter.setBrush(is_lit ? QColor(255, 255, 255) : QColor(235, 90, 60));
    const double radius = is_lit ? size + 3.0 : size;
    painter.drawEllipse(mark.at, radius, radius);
    if (!is_lit) continue;
    const QString name = QStringLiteral("%1  %2").arg(QString::fromStdString(mark.point->code),
                                                      QString::fromStdString(mark.point->pinyin));
    painter.setFont(views::font(text_size, true));
    const QRectF box = painter.fontMetrics().boundingRect(name).adjusted(-6, -3, 6, 3);
    const QRectF at = box.translated(mark.at + QPointF(14.0, -10.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 24, 30, 215));
    painter.drawRoundedRect(at, 4.0, 4.0);
    painter.setPen(QColor(245, 247, 250));
    painter.drawText(at, Qt::AlignCenter, name);
  }
}

void AtlasView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!scene_) {
    painter.fillRect(rect(), Theme::dark().ground);
    painter.setPen(Theme::dark().second);
    painter.setFont(views::font(heading_size));
    painter.drawText(rect(), Qt::AlignCenter, message_);
    return;
  }
  scene_->draw();
  const scene::Picture& picture = scene_->picture();
  const QImage image(reinterpret_cast<const uchar*>(picture.pixels.data()), picture.width, picture.height,
                     4 * picture.width, QImage::Format_RGB32);
  painter.drawImage(0, 0, image);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!hidden_) {
    paint_meridians(painter);
    paint_collateral(painter);
    paint_points(painter);
  }
  if (shown_) {
    if (const auto at = place_of(*shown_)) {
      painter.setPen(QPen(QColor(20, 24, 30), 5.0));
      for (const QColor& colour : {QColor(20, 24, 30), QColor(255, 210, 70)}) {
        painter.setPen(QPen(colour, colour.red() > 100 ? 2.0 : 5.0));
        painter.drawLine(*at - QPointF(7, 7), *at + QPointF(7, 7));
        painter.drawLine(*at - QPointF(7, -7), *at + QPointF(7, -7));
      }
    }
  }
  if (!message_.isEmpty()) {
    painter.setFont(views::font(heading_size, true));
    const QRectF box = painter.fontMetrics().boundingRect(message_).adjusted(-14, -8, 14, 8);
    const QRectF at(QPointF(0.5 * (width() - box.width()), 14.0), box.size());
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 24, 30, 215));
    painter.drawRoundedRect(at, 6.0, 6.0);
    painter.setPen(QColor(245, 247, 250));
    painter.drawText(at, Qt::AlignCenter, message_);
  }
}

void AtlasView::resizeEvent(QResizeEvent*) {
  if (!scene_) return;
  scene_->set_size(std::max(width(), 1), std::max(height(), 1));
  find_visible();
}

void AtlasView::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->localPos();
  moved_ = false;
}

void AtlasView::mouseMoveEvent(QMouseEvent* event) {
  if (!scene_) return;
  const QPointF at = event->localPos(), step = at - last_;
  last_ = at;
  if ((event->buttons() & (Qt::LeftButton | Qt::RightButton | Qt::MiddleButton)) != 0) {
    if ((at - pressed_).manhattanLength() > 4.0) moved_ = true;
    if (!moved_) return;
    move_camera((event->buttons() & Qt::LeftButton) != 0
                    ? scene::turned(camera_, turn_rate * step.x(), turn_rate * step.y())
                    : scene::panned(camera_, step.x(), step.y(), height()));
    return;
  }
  if (hidden_) return;
  const Mark* mark = mark_at(at);
  const patient::AtlasPoint* const lit = mark != nullptr ? mark->point : nullptr;
  if (lit != lit_) {
    lit_ = lit;
    update();
  }
}

void AtlasView::mouseReleaseEvent(QMouseEvent* event) {
  if (!scene_ || moved_ || event->button() != Qt::LeftButton) return;
  const Mark* mark = hidden_ ? nullptr : mark_at(event->localPos());
  if (mark != nullptr) {
    emit clicked(mark->place, mark->point);
  } else if (const auto skin = scene_->skin_at(event->localPos().x(), event->localPos().y())) {
    emit clicked(skin->point, nullptr);
  }
}

void AtlasView::wheelEvent(QWheelEvent* event) {
  if (!scene_) return;
  const QPointF at = event->position();
  const auto skin = scene_->skin_at(at.x(), at.y());
  move_camera(
      scene::zoomed(camera_, std::pow(1.15, event->angleDelta().y() / 120.0), skin ? skin->point : camera_.focus));
}

}  // namespace bodkin::views
