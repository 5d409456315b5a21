#include "views/path_picture.h"

#include <QPainter>
#include <algorithm>

#include "views/paint_kit.h"
#include "views/theme.h"
#include <Eigen/Geometry>

namespace bodkin::views {

namespace {

constexpr double path_margin = 40.0;  // pixels
constexpr double shown_shaft = 40.0;  // mm of the needle

}  // namespace

PathPicture::PathPicture(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Path without anatomy"));
  setToolTip(tr("Path of the tip; the patient of this session is not available"));
}

void PathPicture::set_trails(std::shared_ptr<const std::vector<scene::Trail>> trails) {
  trails_ = std::move(trails);
  update();
}

void PathPicture::show_frame(const Frame& frame) {
  plan_ = frame.plan;
  needle_.reset();
  if (frame.has_needle) needle_ = frame.needle;
  update();
}

void PathPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = Theme::dark();
  painter.fillRect(rect(), theme.ground);
  Eigen::AlignedBox3d box;
  if (plan_) box.extend(plan_->entry).extend(plan_->target);
  if (trails_ != nullptr) {
    for (const scene::Trail& trail : *trails_) {
      for (const Vec3& point : trail.points) box.extend(point);
    }
  }
  if (box.isEmpty()) return;
  box.extend((box.min() - Vec3::Constant(5.0)).eval()).extend((box.max() + Vec3::Constant(5.0)).eval());
  const double half = 0.5 * width();
  const Vec3 size = box.sizes(), middle = box.center();
  const double scale = std::min(
      {(half - 2.0 * path_margin) / std::max(size.x(), size.y()), (height() - 2.0 * path_margin) / size.z()});
  struct Side {
    QString title;
    int axis;  // that goes to the right
    double sign, at;
  };
  const Side sides[] = {{tr("From the patient's left"), 1, 1.0, 0.5 * half},
                        {tr("From behind"), 0, -1.0, 1.5 * half}};
  for (const Side& side : sides) {
    const auto place = [&](const Vec3& point) {
      return QPointF(side.at + side.sign * scale * (point[side.axis] - middle[side.axis]),
                     0.5 * height() - scale * (point.z() - middle.z()));
    };
    set_font(painter, text_size, true);
    draw_text(painter, {side.at, 24.0}, side.title, theme.second, Anchor::middle);
    if (plan_) {
      painter.setPen(QPen(theme.plan, 1.5, Qt::DashLine));
      painter.drawLine(place(plan_->entry), place(plan_->target));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(place(plan_->target), 6.0, 6.0);
    }
    if (trails_ != nullptr) {
      for (const scene::Trail& trail : *trails_) {
        painter.setPen(QPen(QColor(static_cast<QRgb>(trail.colour)), trail.width));
        for (std::size_t i = 0; i + 1 < trail.points.size(); ++i)
          painter.drawLine(place(trail.points[i]), place(trail.points[i + 1]));
      }
    }
    if (needle_) {
      const Vec3 tip = needle_->translation();
      draw_line_on_picture(painter, place(tip), place(tip - shown_shaft * needle_axis(*needle_)), steel, 2.0);
      painter.setPen(QPen(theme.ground, 1.5));
      painter.setBrush(steel);
      painter.drawEllipse(place(tip), 4.5, 4.5);
    }
  }
}

}  // namespace bodkin::views
