#include "views/volume_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "views/language.h"
#include "views/orientation_cube.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

// During motion (as coarse as MovingDetail requires), full, and at the view's resolution: pixels, and voxels per
// step.
struct Level {
  double pixels, voxels;
};
constexpr std::array<Level, 3> levels = {
    {{MovingDetail::most_rays, MovingDetail::finest_step}, {512.0 * 512.0, 1.0}, {1280.0 * 800.0, 0.7}}};
// A graphics card draws the whole view at once, with somewhat longer steps during motion.
constexpr double moving_step_of_card = 1.0;    // voxels
constexpr double volume_settles_after = 0.12;  // s after the last change
constexpr double volume_flight_time = 0.35;    // s
constexpr double volume_cube_size = 76.0;      // pixels
constexpr double volume_turn_per_pixel = 0.4 * degree, volume_turn_per_key = 7.5 * degree;
constexpr double volume_zoom_per_notch = 1.12, volume_zoom_per_key = 1.25;
constexpr double volume_wheel_notch = 120.0;  // a notch of the wheel, as Qt counts

}  // namespace

VolumeView::VolumeView(const QString& place, QWidget* parent) : View(parent) {
  setObjectName(place + QStringLiteral(".view"));
  setAccessibleName(tr("Inside of the patient"));
  setToolTip(tr("Drag to turn, wheel to zoom, right drag for the window; M for the mode, 0 to 6 for standard views"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(160, 120);
}

VolumeView::~VolumeView() = default;

void VolumeView::set_case(std::shared_ptr<const OpenCase> patient) {
  job_.reset();
  picture_.set_base(nullptr);
  has_volume_ = false;
  requested_.reset();
  flight_.reset();
  shown_percent_ = -1;
  by_card_ = false;
  moving_detail_ = {};
  patient_ = std::move(patient);
  if (patient_) {
    for (std::size_t id = 0; id < look_.tissues.size(); ++id) {
      look_.tissues[id] =
          tissue_colour(static_cast<anatomy::TissueId>(id), patient_->patient.library).rgb() & 0xFFFFFFU;
    }
  }
  update();
}

std::shared_ptr<const imaging::PreparedVolume> VolumeView::volume() const {
  return job_ ? job_->volume() : nullptr;
}

void VolumeView::take_volume() {
  const std::shared_ptr<const imaging::PreparedVolume> volume = job_->volume();
  if (!volume) {
    const int percent = static_cast<int>(100.0 * job_->status().fraction);
    if (percent != shown_percent_) update();
    shown_percent_ = percent;
    return;
  }
  has_volume_ = true;
  const anatomy::Grid& lattice = volume->grid;
  const Vec3 last(lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1);
  subject_ = {};
  subject_.middle = lattice.to_patient(0.5 * last);
  const Vec3 sides = (lattice.direction * lattice.spacing.cwiseProduct(last)).cwiseAbs();
  subject_.height = 1.05 * std::max({sides.z(), 0.6 * sides.x(), 0.6 * sides.y()});
  if (const auto& path = patient_->description().procedure.path) subject_.direction = path->direction();
  camera_ = scene::standard_view(scene::StandardView::operator_side, subject_);
  moved_ = true;
  emit ready();
}

scene::VolumeRequest VolumeView::request_for(int level) const {
  Level wanted = levels[static_cast<std::size_t>(level)];
  if (level == 0 && !by_card_) {
    wanted = {moving_detail_.rays(), moving_detail_.step()};
  } else if (level == 0) {
    wanted.pixels = levels.back().pixels * moving_detail_.rays() / MovingDetail::most_rays;
    wanted.voxels = moving_step_of_card * moving_detail_.step() / MovingDetail::finest_step;
  }
  const double all = std::max(1.0, scale_ * scale_ * width() * height());
  const double share = std::min(1.0, std::sqrt(wanted.pixels / all)) * scale_;
  scene::VolumeRequest request;
  request.camera = camera_;
  request.look = look_;
  request.width = std::max(1, static_cast<int>(std::lround(share * width())));
  request.height = std::max(1, static_cast<int>(std::lround(share * height())));
  request.voxels = wanted.voxels;
  request.may_be_cut_short = level > 0;
  request.drawer = drawer_;
  return request;
}

void VolumeView::order_what_is_missing() {
  const auto same = [&](const scene::VolumeRequest& request) { return requested_ && *requested_ == request; };
  if (moved_) {
    changed_at_ = clock_;
    moved_ = false;
  }
  if (clock_ - changed_at_ < volume_settles_after) {
    if (same(request_for(0))) return;
    requested_ = request_for(0);
    job_->request(*requested_);
    return;
  }
  if (job_->status().busy) return;
  // One finer than the last image, if that shows the present request.
  for (int level = static_cast<int>(levels.size()) - 1; level >= 0; --level) {
    if (!same(request_for(level))) continue;
    if (level + 1 == static_cast<int>(levels.size())) return;
    requested_ = request_for(level + 1);
    job_->request(*requested_);
    return;
  }
  requested_ = request_for(1);
  job_->request(*requested_);
}

bool VolumeView::is_settled() const {
  const auto finest = static_cast<int>(levels.size()) - 1;
  return has_volume_ && !moved_ && picture_.base() && picture_.base()->request == request_for(finest);
}

void VolumeView::show_frame(const Frame& frame, const Changes& changes) {
  clock_ = frame.clock;
  if (!patient_ || width() < 1 || height() < 1) return;
  if (!job_) {
    job_ = std::make_unique<scene::VolumeJob>(std::shared_ptr<const anatomy::Case>(patient_, &patient_->patient));
    update();
  }
  if (!has_volume_) take_volume();
  if (!has_volume_) return;
  if (flight_) {
    camera_ = flight_->at(clock_ - flight_began_);
    if (flight_->ended(clock_ - flight_began_)) flight_.reset();
    moved_ = true;
  }
  order_what_is_missing();
  const std::shared_ptr<const scene::VolumeResult> newest = job_->newest();
  const bool another = newest != picture_.base();
  if (another) {
    picture_.set_base(newest);
    const bool was_by_card = std::exchange(by_card_, newest->by_card);
    if (was_by_card != by_card_) {
      moving_detail_ = {};
      moved_ = true;
    } else if (!newest->request.may_be_cut_short) {
      moving_detail_.took(newest->seconds);
    }
    take_drawer();
  }
  if (!another && !changes.needle && !changes.plan && !changes.theme) return;
  show_needle(frame);
  picture_.draw(needles_, marks_);
  update();
}

void VolumeView::set_drawer(scene::VolumeDrawer drawer) {
  if (drawer == drawer_) return;
  drawer_ = drawer;
  moved_ = true;
}

void VolumeView::take_drawer() {
  const scene::VolumeJob::Status status = job_->status();
  if (status.card == card_ && status.refusal == refusal_) return;
  card_ = status.card;
  refusal_ = status.refusal;
  emit drawer_changed();
}

void VolumeView::show_needle(const Frame& frame) {
  needles_.clear();
  if (frame.has_needle) {
    scene::NeedleLook needle;
    needle.shape = patient_->description().needle;
    needle.pose = frame.needle;
    needles_.push_back(needle);
  }
  marks_ = {};
  marks_.path = frame.plan ? frame.plan : patient_->description().procedure.path;
  marks_.target_tolerance = frame.target_tolerance;
}

void VolumeView::set_look(const imaging::VolumeLook& look) {
  if (look == look_) return;
  look_ = look;
  moved_ = true;
  emit look_changed();
}

void VolumeView::set_mode(imaging::VolumeMode mode) {
  imaging::VolumeLook look = look_;
  look.mode = mode;
  set_look(look);
}

void VolumeView::choose_preset(imaging::TransferPreset preset) {
  preset_ = preset;
  imaging::VolumeLook look = look_;
  look.transfer = imaging::preset_function(preset);
  set_look(look);
  emit preset_chosen(preset);
}

void VolumeView::set_camera(const scene::Camera& camera) {
  flight_.reset();
  camera_ = camera;
  moved_ = true;
}

void VolumeView::choose_view(scene::StandardView view) {
  if (!has_volume_) return;
  flight_.emplace(camera_, scene::standard_view(view, subject_), volume_flight_time);
  flight_began_ = clock_;
}

void VolumeView::resizeEvent(QResizeEvent* event) {
  View::resizeEvent(event);
  const double ratio = devicePixelRatioF(), all = ratio * width() * ratio * height();
  scale_ = all > levels.back().pixels ? ratio * std::sqrt(levels.back().pixels / all) : ratio;
  picture_.set_size(std::max(1, static_cast<int>(std::lround(scale_ * width()))),
                    std::max(1, static_cast<int>(std::lround(scale_ * height()))));
  picture_.draw(needles_, marks_);
  moved_ = true;
}

// The needle has moved while hidden.
void VolumeView::showEvent(QShowEvent* event) {
  View::showEvent(event);
  moved_ = true;
}

void VolumeView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!picture_.base()) {
    painter.fillRect(rect(), Theme::dark().ground);
    if (!patient_) return;
    const scene::VolumeJob::Status status = job_ ? job_->status() : scene::VolumeJob::Status{};
    const QString text = status.error.empty()
                             ? tr("Preparing the volume: %1 %").arg(static_cast<int>(100.0 * status.fraction))
                             : tr("The inside of the patient cannot be shown: %1").arg(in_words(status.error));
    set_font(painter, text_size);
    painter.setPen(Theme::dark().second);
    painter.drawText(rect().adjusted(24, 0, -24, 0), static_cast<int>(Qt::AlignCenter) | Qt::TextWordWrap, text);
    return;
  }
  const scene::Picture& picture = picture_.picture();
  const QImage image(reinterpret_cast<const uchar*>(picture.pixels.data()), picture.width, picture.height,
                     4 * picture.width, QImage::Format_RGB32);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRectF(rect()), image, QRectF(0, 0, picture.width, picture.height));
  const QRectF cube(12.0, height() - volume_cube_size - 12.0, volume_cube_size, volume_cube_size);
  draw_orientation_cube(painter, cube, camera_.axes());
  set_font(painter, label_size);
  QString words;
  switch (look_.mode) {
    case imaging::VolumeMode::colour:
      words = look_.tissue_colours ? tr("Colour by tissue") : tr("Colour by HU");
      break;
    case imaging::VolumeMode::grey:
      words = tr("Grey   W %1  L %2").arg(look_.window, 0, 'f', 0).arg(look_.level, 0, 'f', 0);
      break;
    case imaging::VolumeMode::maximum:
      words = tr("Largest HU (MIP)   W %1  L %2").arg(look_.window, 0, 'f', 0).arg(look_.level, 0, 'f', 0);
      break;
    case imaging::VolumeMode::sum:
      words = tr("Summed voxels, like an X-ray   brightness %1").arg(look_.brightness, 0, 'f', 2);
      break;
  }
  draw_text_on_picture(painter, QPointF(14.0, 24.0), words, Theme::dark().text);
}

void VolumeView::mousePressEvent(QMouseEvent* event) {
  dragged_ = event->button();
  pointer_ = event->localPos();
}

void VolumeView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF moved = event->localPos() - pointer_;
  pointer_ = event->localPos();
  if (dragged_ == Qt::LeftButton) {
    set_camera(scene::turned(camera_, volume_turn_per_pixel * moved.x(), volume_turn_per_pixel * moved.y()));
  } else if (dragged_ == Qt::MiddleButton) {
    set_camera(scene::panned(camera_, moved.x(), moved.y(), height()));
  } else if (dragged_ == Qt::RightButton) {
    imaging::VolumeLook look = look_;
    if (look.mode == imaging::VolumeMode::sum) {
      look.brightness = std::clamp(look.brightness * std::exp(-0.006 * moved.y()), 0.1, 10.0);
    } else {
      look.window = std::clamp(look.window + 4.0 * moved.x(), 20.0, 4000.0);
      look.level = std::clamp(look.level - 4.0 * moved.y(), -1000.0, 3000.0);
    }
    set_look(look);
  }
}

void VolumeView::mouseReleaseEvent(QMouseEvent* event) {
  const Qt::MouseButton was = std::exchange(dragged_, Qt::NoButton);
  if (was != Qt::LeftButton || !has_volume_) return;
  const QRectF cube(12.0, height() - volume_cube_size - 12.0, volume_cube_size, volume_cube_size);
  if (const auto face = orientation_cube_face(cube, camera_.axes(), event->localPos())) choose_view(*face);
}

void VolumeView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit fill_requested();
}

void VolumeView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / volume_wheel_notch;
  if (notches != 0.0 && has_volume_) {
    set_camera(scene::zoomed(camera_, std::pow(volume_zoom_per_notch, notches), camera_.focus));
  }
}

bool VolumeView::press(int key) {
  if (key >= Qt::Key_0 && key < Qt::Key_0 + scene::standard_view_count) {
    choose_view(static_cast<scene::StandardView>(key - Qt::Key_0));
    return true;
  }
  switch (key) {
    case Qt::Key_M:
      set_mode(static_cast<imaging::VolumeMode>((static_cast<int>(look_.mode) + 1) % 4));
      return true;
    case Qt::Key_P:
      choose_preset(
          imaging::transfer_presets[(static_cast<std::size_t>(preset_) + 1) % imaging::transfer_presets.size()]);
      return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
      set_camera(scene::turned(camera_, key == Qt::Key_Left ? -volume_turn_per_key : volume_turn_per_key, 0.0));
      return true;
    case Qt::Key_Up:
    case Qt::Key_Down:
      set_camera(scene::turned(camera_, 0.0, key == Qt::Key_Up ? -volume_turn_per_key : volume_turn_per_key));
      return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
      set_camera(scene::zoomed(camera_, key == Qt::Key_Minus ? 1.0 / volume_zoom_per_key : volume_zoom_per_key,
                               camera_.focus));
      return true;
    default:
      return false;
  }
}

void VolumeView::keyPressEvent(QKeyEvent* event) {
  if (!press(event->key())) View::keyPressEvent(event);
}

}  // namespace bodkin::views
