#include "views/view3d.h"

#include <QPaintEvent>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "views/language.h"
#include "views/look_panel.h"
#include "views/orientation_cube.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double most_pixels = 1920.0 * 1080.0;  // that are drawn; a larger widget scales the picture up
constexpr double settles_after = 0.12;           // s after the last movement of the camera full detail comes back
constexpr double settles_after_breath = 0.3;     // s, the same after the last motion of the patient
constexpr double flight_time = 0.35;             // s
// mm from the place of the skin's patch at which a new one is cut out. With a deformable body that is avoided, since
// displacements are available only for the requested points, and for others only some time later.
constexpr double other_entry = 0.05, other_entry_of_body = 15.0;
constexpr int margin_of_tip = 9;    // pixels about the tip that its mark takes
constexpr double cube_size = 76.0;  // pixels

// Frames are kept for painting, but not the data that they only refer to.
Frame without_spans(const Frame& frame) {
  Frame kept = frame;
  kept.displacements = {};
  kept.diagnostic_names = {};
  kept.samples = {};
  kept.events = {};
  kept.left_needles = {};
  kept.timings = nullptr;
  kept.ultrasound = nullptr;
  return kept;
}

scene::ViewSubject subject_of(const OpenCase& patient, const scene::SceneMesh& skin) {
  scene::ViewSubject subject;
  if (const auto& path = patient.description().procedure.path) {
    subject.middle = 0.75 * path->entry + 0.25 * path->target;  // room for the hub
    subject.direction = path->direction();
    return subject;
  }
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : skin.points) box.extend(point);
  subject.middle = box.center().cast<double>();
  subject.height = 1.2 * static_cast<double>(box.sizes().maxCoeff());
  return subject;
}

}  // namespace

View3d::View3d(const QString& place, QWidget* parent) : View(parent) {
  setObjectName(place + QStringLiteral(".view3d"));
  setAccessibleName(tr("Patient in 3-D"));
  setToolTip(
      tr("Drag to turn the patient, Ctrl and the wheel to zoom, 0 to 6 for standard views, P for what is shown"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(160, 120);
  const std::array<QString, 4> names = {tr("Skin"), tr("Cut-away"), tr("Bones"), tr("See-through")};
  const std::array<QString, 4> tips = {
      tr("What the patient looks like (P: next)"), tr("An opening in the skin over the path (P: next)"),
      tr("Bones and what lies between them (P: next)"), tr("Everything under a faint skin (P: next)")};
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const scene::Preset preset = scene::presets[i];
    buttons_[i] = new QPushButton(names[i], this);
    buttons_[i]->setObjectName(place + QStringLiteral(".preset.") + QString::fromLatin1(name_of(preset).data()));
    buttons_[i]->setAccessibleName(names[i]);
    buttons_[i]->setToolTip(tips[i]);
    buttons_[i]->setCheckable(true);
    buttons_[i]->setChecked(preset == look_.preset);
    buttons_[i]->setFocusPolicy(Qt::NoFocus);
    connect(buttons_[i], &QPushButton::clicked, this, [this, preset] { set_preset(preset); });
  }
  make_look_panel(place);
}

View3d::~View3d() = default;

void View3d::set_case(std::shared_ptr<const OpenCase> patient) {
  job_.reset();
  panel_->set_surfaces(nullptr);
  scene_.reset();
  right_scene_.reset();
  stereo_ = scene::Stereo::off;
  message_.clear();
  flight_.reset();
  has_needle_ = aimed_ = false;
  shown_percent_ = -1;
  patient_ = std::move(patient);
  if (patient_) {
    job_ = std::make_unique<scene::SurfaceJob>(std::shared_ptr<const anatomy::Case>(patient_, &patient_->patient),
                                               patient_->folder);
  }
  update();
}

void View3d::take_surfaces() {
  const scene::SurfaceJob::Status status = job_->status();
  if (!status.done) {
    const int percent = static_cast<int>(100.0 * status.fraction);
    if (percent != shown_percent_) update();
    shown_percent_ = percent;
    return;
  }
  const std::shared_ptr<const scene::PatientSurfaces> surfaces = job_->surfaces();
  if (!surfaces) {
    if (shown_percent_ != 100) update();  // paint_preparation() says why
    shown_percent_ = 100;
    return;
  }
  job_.reset();
  subject_ = subject_of(*patient_, surfaces->skin());
  camera_ = scene::standard_view(scene::StandardView::operator_side, subject_);
  scene_ = make_scene(surfaces);
  open_looks_of_case();
  needle_.shape = patient_->description().needle;
  fit_picture();
  emit ready();
  emit points_changed();
}

std::unique_ptr<scene::SoftwareView> View3d::make_scene(
    std::shared_ptr<const scene::PatientSurfaces> surfaces) const {
  auto scene = std::make_unique<scene::SoftwareView>(std::move(surfaces));
  scene->set_camera(camera_);
  scene->set_look(look_);
  scene::Opening opening;
  opening.centre = subject_.middle;
  if (const auto& path = patient_->description().procedure.path) opening.centre = 0.5 * (path->entry + path->target);
  scene->set_opening(opening);
  if (const auto& path = patient_->description().procedure.path) scene->set_entry(path->entry, path->direction());
  return scene;
}

void View3d::fit_picture() {
  if (!scene_) return;
  const double ratio = devicePixelRatioF();
  const double pixels = width() * ratio * height() * ratio;
  scale_ = pixels > most_pixels ? ratio * std::sqrt(most_pixels / pixels) : ratio;
  const int columns =
      static_cast<int>(std::lround(width() * scale_ * (stereo_ == scene::Stereo::side_by_side ? 0.5 : 1.0)));
  const int rows = static_cast<int>(std::lround(height() * scale_));
  for (scene::SoftwareView* scene : scenes()) scene->set_size(columns, rows);
  update();
}

void View3d::resizeEvent(QResizeEvent* event) {
  View::resizeEvent(event);
  place_buttons();
  fit_picture();
}

void View3d::place_buttons() {
  int x = width() - 12;
  place_look_panel();
  parts_button_->adjustSize();
  x -= parts_button_->width();
  parts_button_->move(x, 12);
  x -= 4;
  for (auto button = buttons_.rbegin(); button != buttons_.rend(); ++button) {
    (*button)->adjustSize();
    x -= (*button)->width();
    (*button)->move(x, 12);
    x -= 4;
  }
}

void View3d::choose_view(scene::StandardView view) {
  if (!scene_) return;
  flight_.emplace(camera_, scene::standard_view(view, subject_), flight_time);
  flight_began_ = clock_;
}

void View3d::set_camera(const scene::Camera& camera) {
  flight_.reset();
  camera_ = camera;
}

void View3d::set_skin_tint(const std::vector<std::uint32_t>& tint) {
  for (scene::SoftwareView* scene : scenes()) scene->set_skin_tint(tint);
}

std::vector<Vec3> View3d::deformable_points() const {
  return scene_ ? scene_->deformable_points() : std::vector<Vec3>{};
}

void View3d::show_frame(const Frame& frame, const Changes& changes) {
  clock_ = frame.clock;
  if (job_) take_surfaces();
  if (!scene_) return;
  if (pointer_moved_) aim();
  if (flight_) {
    camera_ = flight_->at(clock_ - flight_began_);
    if (flight_->ended(clock_ - flight_began_)) flight_.reset();
  }
  const std::array<scene::Camera, 2> cameras =
      stereo_ == scene::Stereo::off ? std::array<scene::Camera, 2>{camera_, camera_} : scene::eyes(camera_);
  if (!(cameras[0] == scene_->camera())) camera_moved_ = clock_;
  const bool moves = camera_moved_ >= 0.0 && clock_ - camera_moved_ < settles_after;
  scene_->set_camera(cameras[0]);
  if (right_scene_) right_scene_->set_camera(cameras[1]);
  if (frame.drawn_in != shown_.drawn_in) breath_moved_ = clock_;
  const bool breathes = breath_moved_ >= 0.0 && clock_ - breath_moved_ < settles_after_breath;
  for (scene::SoftwareView* scene : scenes()) scene->set_detail(moves || breathes ? 1 : 2);
  update_scene(frame);
  const scene::PixelBox drawn = draw_scenes();
  const bool spoke = !message_.isEmpty() && clock_ >= message_until_;
  if (spoke) message_.clear();
  const bool framed = spoke || shown_.warning.has_value() != frame.warning.has_value() ||
                      (shown_.state == State::reached) != (frame.state == State::reached);
  shown_ = without_spans(frame);
  const QRect tip = tip_mark();
  if (framed || changes.theme || workspace_) {
    update();
    return;
  }
  QRect region = on_screen(drawn);
  if (tip != shown_tip_ || changes.tissue || changes.needle) region = region.united(tip).united(shown_tip_);
  shown_tip_ = tip;
  if (!region.isEmpty()) update(region);
}

void View3d::update_scene(const Frame& frame) {
  has_needle_ = frame.has_needle;
  std::vector<scene::NeedleLook> needles;
  for (const LeftNeedle& left : frame.left_needles) {
    scene::NeedleLook look = needle_;
    look.pose = left.pose;
    look.ghost = 0.0;
    look.hub_colour = scene::NeedleLook{}.hub_colour;
    needles.push_back(look);
  }
  if (has_needle_) {
    needle_.pose = frame.needle;
    const double ahead = (frame.hand.translation() - frame.needle.translation()).dot(needle_axis(frame.needle));
    needle_.ghost = needle_is_down(frame.state) && ahead > 0.5 ? ahead : 0.0;
    needle_.ghost_on_bone = frame.warning && frame.warning->kind == Warning::Kind::bone;
    needle_.hub_colour = frame.depth > 0.0 ? Theme::dark().accent.rgb() & 0xFFFFFFU : scene::NeedleLook{}.hub_colour;
    needles.push_back(needle_);
  }
  for (scene::SoftwareView* scene : scenes()) scene->set_needles(needles);
  scene::SceneMarks marks;
  marks.path = frame.plan;
  marks.target_tolerance = frame.target_tolerance;
  marks.path_shown = true;
  marks.broken = frame.plan_broken;
  marks.trails = trails_;
  if (frame.plan && (frame.state == State::ready || frame.state == State::aiming)) {
    marks.insert_here = 0.5 + 0.5 * std::sin(2.0 * 3.14159265358979 * frame.clock);  // 1 Hz
    marks.entry_normal = -frame.plan->direction();
  } else if (frame.plan && frame.is_planning) {
    marks.insert_here = 1.0;
    marks.entry_normal = -frame.plan->direction();
  }
  for (scene::SoftwareView* scene : scenes()) scene->set_marks(marks);
  update_skin(frame);
}

void View3d::update_skin(const Frame& frame) {
  scene::BreathMotion breath;
  breath.drawn_in = frame.drawn_in;
  if (const auto& breathing = patient_->description().breathing) breath.field.emplace(*breathing);
  for (scene::SoftwareView* scene : scenes()) scene->set_breath(breath);
  SkinDimple dimple = frame.dimple;
  dimple.at = breath.at_rest(dimple.at);
  std::optional<scene::SkinDent> dent;
  if (dimple.depth != 0.0) dent = scene::SkinDent{dimple.at, dimple.inwards, dimple.depth};
  const Vec3 from = dimple.at - scene_->patch().entry();
  const double far = frame.displacements.empty() ? other_entry : other_entry_of_body;
  const bool elsewhere = dent && (scene_->patch().empty() || from.norm() > far);
  for (scene::SoftwareView* scene : scenes()) {
    if (elsewhere) scene->set_entry(dimple.at, dimple.inwards);
    scene->set_dent(dent, frame.displacements);
  }
  if (elsewhere && !frame.displacements.empty()) emit points_changed();
}

QPointF View3d::on_screen(const scene::Place& place) const {
  return QPointF(place.x, place.y) / scale_;
}

QRect View3d::on_screen(const scene::PixelBox& pixels) const {
  if (pixels.empty()) return {};
  const QRectF box(pixels.left / scale_, pixels.top / scale_, pixels.width() / scale_, pixels.height() / scale_);
  return box.toAlignedRect().adjusted(-1, -1, 1, 1);
}

QRect View3d::tip_mark() const {
  if (!has_needle_) return {};
  const auto place = scene_->projection().place(needle_.pose.translation());
  if (!place) return {};
  // Under a closed skin the tip is invisible.
  if (scene::skin_is_closed(look_, scene_->surfaces()) && shown_.depth > std::max(1.0, shown_.dimple.depth + 0.5))
    return {};
  const QPoint at = on_screen(*place).toPoint();
  return {at.x() - margin_of_tip, at.y() - margin_of_tip, 2 * margin_of_tip, 2 * margin_of_tip};
}

void View3d::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  if (!scene_) {
    paint_preparation(painter);
    return;
  }
  const scene::Picture& picture = stereo_ == scene::Stereo::off ? scene_->picture() : stereo_picture_;
  const QImage image(reinterpret_cast<const uchar*>(picture.pixels.data()), picture.width, picture.height,
                     4 * picture.width, QImage::Format_RGB32);
  if (scale_ == 1.0) {
    painter.drawImage(event->rect(), image, event->rect());
  } else {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(rect()), image, QRectF(0, 0, picture.width, picture.height));
  }
  if (!tip_mark().isEmpty() && stereo_ == scene::Stereo::off) {
    const auto place = scene_->projection().place(needle_.pose.translation());
    draw_tip(painter, on_screen(*place), tip_shape(shown_), tissue_colour(shown_.tissue, patient_->patient.library));
  }
  draw_orientation_cube(painter, cube_place(), camera_.axes());
  if (workspace_ && stereo_ == scene::Stereo::off) draw_workspace(painter);
  if (!message_.isEmpty()) {
    set_font(painter, text_size);
    draw_text_on_picture(painter, QPointF(0.5 * width(), height() - 24.0), message_, Theme::dark().text,
                         Anchor::middle);
  }
  if (shown_.warning || shown_.state == State::reached) {
    painter.setPen(QPen(shown_.warning ? Theme::dark().danger : Theme::dark().plan, 3.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5));
  }
}

void View3d::paint_preparation(QPainter& painter) {
  painter.fillRect(rect(), Theme::dark().ground);
  if (!patient_ || !job_) return;
  const scene::SurfaceJob::Status status = job_->status();
  const QString text = status.error.empty()
                           ? tr("Preparing the patient in 3-D: %1 %").arg(static_cast<int>(100.0 * status.fraction))
                           : tr("The patient cannot be shown in 3-D: %1").arg(in_words(status.error));
  set_font(painter, text_size);
  painter.setPen(Theme::dark().second);
  painter.drawText(rect().adjusted(24, 0, -24, 0), static_cast<int>(Qt::AlignCenter) | Qt::TextWordWrap, text);
}

QRectF View3d::cube_place() const {
  return {12.0, height() - cube_size - 12.0, cube_size, cube_size};
}

}  // namespace bodkin::views
