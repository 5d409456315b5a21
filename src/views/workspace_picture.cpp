#include "views/workspace_picture.h"

#include <QPainter>
#include <algorithm>

#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double foot_of_picture = 46.0, head_of_picture = 26.0, edge_of_picture = 14.0;  // pixels
constexpr double tool_length = 30.0;                                                      // mm

}  // namespace

struct WorkspacePicture::Side {
  QRectF box;     // pixels
  int right, up;  // axes of the operator's frame
  double scale = 1.0;
  Vec3 middle;

  QPointF place(const Vec3& point) const {
    return {box.center().x() + scale * (point[right] - middle[right]),
            box.center().y() - scale * (point[up] - middle[up])};
  }
};

WorkspacePicture::WorkspacePicture(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(180);
  setAccessibleName(tr("Workspace of the device"));
  setToolTip(tr("Position of the tool in the workspace; below, the force sent to the device"));
}

void WorkspacePicture::show_hand(const haptics::DeviceAbilities& abilities, const std::optional<Pose>& hand,
                                 double force) {
  box_is_known_ = abilities.workspace_low != abilities.workspace_high;
  low_ = box_is_known_ ? abilities.workspace_low : Vec3(Vec3::Constant(-100.0));
  high_ = box_is_known_ ? abilities.workspace_high : Vec3(Vec3::Constant(100.0));
  hand_ = hand;
  force_ = force;
  strongest_ = abilities.peak_force;
  update();
}

WorkspacePicture::Side WorkspacePicture::side(bool from_above) const {
  const double half = 0.5 * width();
  Side side;
  side.right = from_above ? 0 : 1;
  side.up = from_above ? 1 : 2;
  side.middle = 0.5 * (low_ + high_);
  const QRectF place(from_above ? edge_of_picture : half + 0.5 * edge_of_picture, head_of_picture,
                     half - 1.5 * edge_of_picture, std::max(20.0, height() - head_of_picture - foot_of_picture));
  constexpr double room = 1.15;
  side.scale = std::min(place.width() / (room * (high_ - low_)[side.right]),
                        place.height() / (room * (high_ - low_)[side.up]));
  side.box = place;
  return side;
}

void WorkspacePicture::draw_side(QPainter& painter, const Side& side, const QString& title) const {
  const Theme& theme = Theme::now();
  set_font(painter, label_size);
  draw_text(painter, {side.box.center().x(), 16.0}, title, theme.second, Anchor::middle);
  painter.setPen(QPen(theme.line, 1.0));
  painter.setBrush(theme.raised);
  painter.drawRoundedRect(side.box, 4.0, 4.0);
  painter.setPen(QPen(theme.second, 1.0, box_is_known_ ? Qt::SolidLine : Qt::DashLine));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(side.place(low_), side.place(high_)).normalized());
  if (!hand_) return;
  painter.setClipRect(side.box);
  const Vec3 tip = hand_->translation(), back = tip - tool_length * needle_axis(*hand_);
  draw_line_on_picture(painter, side.place(back), side.place(tip), theme.text, 2.0);
  painter.setPen(QPen(theme.panel, 1.5));
  painter.setBrush(theme.accent);
  painter.drawEllipse(side.place(tip), 5.5, 5.5);
  painter.setClipping(false);
}

void WorkspacePicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = Theme::now();
  draw_side(painter, side(true), tr("from above, away from you is up"));
  draw_side(painter, side(false), tr("from your right"));
  const double top = height() - foot_of_picture + 14.0;
  const QRectF bar(edge_of_picture, top, width() - 2.0 * edge_of_picture - 110.0, 10.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.raised);
  painter.drawRoundedRect(bar, 5.0, 5.0);
  QString words = tr("renders no force");
  if (strongest_ > 0.0) {
    const double share = std::clamp(force_ / strongest_, 0.0, 1.0);
    painter.setBrush(share > 0.8 ? theme.caution : theme.accent);
    painter.drawRoundedRect(QRectF(bar.left(), bar.top(), share * bar.width(), bar.height()), 5.0, 5.0);
    words = tr("%1 of %2 N").arg(force_, 0, 'f', 2).arg(strongest_, 0, 'f', 1);
  }
  set_font(painter, text_size);
  draw_text(painter, {width() - edge_of_picture, top + 10.0}, hand_ || strongest_ > 0.0 ? words : tr("not open"),
            theme.second, Anchor::right);
}

}  // namespace bodkin::views
