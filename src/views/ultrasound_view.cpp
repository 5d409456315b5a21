#include "views/ultrasound_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "views/language.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double machine_head = 30.0, machine_foot = 26.0;  // pixels above and below the machine's picture
constexpr double wide_for_ct = 1.45;                        // width to height from which the CT stands beside,
constexpr int least_for_ct = 680;                           // and pixels of width
constexpr double counting_span = 1.0;                       // s

using Kind = station::ScreenEvent::Kind;

}  // namespace

UltrasoundView::UltrasoundView(QWidget* parent) : View(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(200, 160);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Ultrasound"));
  setToolTip(
      tr("Ultrasound. Drag slides the probe, the wheel presses it, Shift and wheel set the depth. H shows all "
         "keys."));
}

void UltrasoundView::set_case(std::shared_ptr<const OpenCase> patient) {
  scan_.reset();
  choice_.reset();
  patient_ = std::move(patient);
  ct_.set_case(patient_);
  has_needle_ = false;
  plan_.reset();
  update();
}

void UltrasoundView::set_scan(const std::optional<station::UltrasoundChoice>& choice,
                              const std::optional<imaging::NeedleInUltrasound>& needle) {
  scan_.reset();
  choice_ = choice;
  made_ = counted_ = 0;
  clock_ = counting_since_ = -1.0;
  rate_ = 0.0;
  if (choice_ && patient_ != nullptr) {
    scan_.emplace(patient_->patient, *choice_, station::hold_probe(*choice_, patient_->patient), needle,
                  station::LiveScan::Place{});
    scan_->screen().translate_by([](const std::string& words) { return in_words(words).toStdString(); });
    reported_ = {scan_->pose(), scan_->settings()};
    resizeEvent(nullptr);
  }
  stale_ = true;
  update();
}

void UltrasoundView::show_message(const std::string& sentence) {
  if (scan_) scan_->set_message(sentence);
  update();
}

bool UltrasoundView::close_help() {
  if (!scan_ || !scan_->help()) return false;
  station::ScreenEvent event;
  event.kind = Kind::key;
  event.key = station::ScreenKey::escape;
  event.down = true;
  pass_on(event);
  return true;
}

bool UltrasoundView::shows_ct() const {
  return ct_allowed_ && width() >= least_for_ct && width() > wide_for_ct * height();
}

void UltrasoundView::allow_ct(bool allowed) {
  if (allowed == ct_allowed_) return;
  ct_allowed_ = allowed;
  resizeEvent(nullptr);
}

QRectF UltrasoundView::machine_box() const {
  constexpr double share = 0.58;
  return {0.0, machine_head, shows_ct() ? share * width() : width(),
          std::max(10.0, height() - machine_head - machine_foot)};
}

QRectF UltrasoundView::ct_box() const {
  const QRectF machine = machine_box();
  return {machine.right() + 1.0, machine_head, width() - machine.right() - 1.0, machine.height()};
}

void UltrasoundView::resizeEvent(QResizeEvent* /*event*/) {
  if (scan_) {
    constexpr double sliders = 8.0 * station::LiveScan::slider_row;
    const QRectF box = machine_box();
    station::LiveScan::Place place;
    place.x = box.x();
    place.y = box.y();
    place.width = static_cast<int>(box.width());
    place.height = static_cast<int>(box.height());
    place.sliders_width = std::clamp(box.width() - 240.0, 60.0, 220.0);
    place.sliders_x = box.x() + 92.0;
    place.sliders_y = box.bottom() - sliders - 12.0;
    scan_->set_place(place);
  }
  stale_ = true;
  update();
}

void UltrasoundView::show_frame(const Frame& frame, const Changes& changes) {
  if (!scan_) return;
  in_attempt_ = is_attempt(frame.state);
  if (clock_ >= 0.0) scan_->advance(frame.clock - clock_);
  clock_ = frame.clock;
  if (changes.attempt) {
    // A new station, which begins with the probe at the chosen place.
    made_ = counted_ = 0;
    emit scan_setup_changed(reported_);
  }
  report_setup();
  if (changes.needle || changes.plan) {
    has_needle_ = frame.has_needle;
    needle_tip_ = frame.needle.translation();
    needle_axis_ = needle_axis(frame.needle);
    plan_ = frame.plan;
    if (shows_ct()) update();
  }
  if (frame.ultrasound == nullptr) return;
  const station::LiveImage& picture = *frame.ultrasound;
  count(picture, frame.clock);
  if (picture.number == made_) return;
  made_ = picture.number;
  left_out_ = picture.left_out;
  const std::string words = !in_attempt_     ? scan_->needle_words()
                            : picture.needle ? std::to_string(patient_->description().needle.gauge) + " G"
                                             : std::string();
  scan_->screen().take({picture.frame, picture.setup.probe, choice_->probe, picture.setup.settings, words});
  stale_ = true;
  update();
}

void UltrasoundView::count(const station::LiveImage& picture, double clock) {
  if (counting_since_ < 0.0) counting_since_ = clock;
  if (clock - counting_since_ < counting_span) return;
  rate_ = static_cast<double>(picture.number - std::min(picture.number, counted_)) / (clock - counting_since_);
  counted_ = picture.number;
  counting_since_ = clock;
  update();
}

void UltrasoundView::report_setup() {
  const station::ScanSetup next{scan_->pose(), scan_->settings()};
  if (next.probe.matrix() == reported_.probe.matrix() && next.settings == reported_.settings) return;
  reported_ = next;
  stale_ = true;
  emit scan_setup_changed(next);
  update();
}

void UltrasoundView::pass_on(const station::ScreenEvent& event) {
  if (!scan_) return;
  scan_->take(event);
  if (scan_->take_save() && !scan_->screen().empty()) {
    stale_ = true;
    emit save_requested(grab().toImage());
  }
  stale_ = true;
  report_setup();
  update();
}

std::optional<station::ScreenKey> UltrasoundView::key_of(int key) const {
  using Key = station::ScreenKey;
  constexpr std::array<std::pair<int, Key>, 35> keys = {{{Qt::Key_Up, Key::up},
                                                         {Qt::Key_Down, Key::down},
                                                         {Qt::Key_Left, Key::left},
                                                         {Qt::Key_Right, Key::right},
                                                         {Qt::Key_C, Key::c},
                                                         {Qt::Key_D, Key::d},
                                                         {Qt::Key_F, Key::f},
                                                         {Qt::Key_G, Key::g},
                                                         {Qt::Key_H, Key::h},
                                                         {Qt::Key_I, Key::i},
                                                         {Qt::Key_J, Key::j},
                                                         {Qt::Key_K, Key::k},
                                                         {Qt::Key_L, Key::l},
                                                         {Qt::Key_M, Key::m},
                                                         {Qt::Key_O, Key::o},
                                                         {Qt::Key_Q, Key::q},
                                                         {Qt::Key_R, Key::r},
                                                         {Qt::Key_S, Key::s},
                                                         {Qt::Key_T, Key::t},
                                                         {Qt::Key_X, Key::x},
                                                         {Qt::Key_0, Key::zero},
                                                         {Qt::Key_1, Key::one},
                                                         {Qt::Key_2, Key::two},
                                                         {Qt::Key_3, Key::three},
                                                         {Qt::Key_4, Key::four},
                                                         {Qt::Key_5, Key::five},
                                                         {Qt::Key_6, Key::six},
                                                         {Qt::Key_7, Key::seven},
                                                         {Qt::Key_8, Key::eight},
                                                         {Qt::Key_Space, Key::space},
                                                         {Qt::Key_N, Key::n},
                                                         {Qt::Key_PageUp, Key::page_up},
                                                         {Qt::Key_PageDown, Key::page_down},
                                                         {Qt::Key_Question, Key::question},
                                                         {Qt::Key_Escape, Key::escape}}};
  const auto* const found =
      std::find_if(keys.begin(), keys.end(), [key](const auto& pair) { return pair.first == key; });
  if (found == keys.end()) return std::nullopt;
  const Key which = found->second;
  const bool of_the_needle =
      which == Key::space || which == Key::n || which == Key::page_up || which == Key::page_down;
  if (of_the_needle && in_attempt_) return std::nullopt;
  // Escape closes the list of keys; on the page it has further effects.
  if (which == Key::escape && !(scan_ && scan_->help())) return std::nullopt;
  if (which == Key::question && in_attempt_) return std::nullopt;
  return which;
}

bool UltrasoundView::press(QKeyEvent* event, bool down) {
  if (!scan_ || (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != 0) return false;
  const std::optional<station::ScreenKey> key = key_of(event->key());
  if (!key) return false;
  if (event->isAutoRepeat() && !down) return true;  // it is still held
  station::ScreenEvent pressed;
  pressed.kind = Kind::key;
  pressed.key = *key;
  pressed.down = down;
  pressed.shift = (event->modifiers() & Qt::ShiftModifier) != 0;
  pass_on(pressed);
  return true;
}

void UltrasoundView::keyPressEvent(QKeyEvent* event) {
  if (!press(event, true)) View::keyPressEvent(event);
}

void UltrasoundView::keyReleaseEvent(QKeyEvent* event) {
  if (!press(event, false)) View::keyReleaseEvent(event);
}

void UltrasoundView::mousePressEvent(QMouseEvent* event) {
  station::ScreenEvent pressed;
  pressed.kind = Kind::button;
  pressed.x = event->localPos().x();
  pressed.y = event->localPos().y();
  pressed.down = event->button() == Qt::LeftButton;
  pass_on(pressed);
}

void UltrasoundView::mouseReleaseEvent(QMouseEvent* event) {
  station::ScreenEvent released;
  released.kind = Kind::button;
  released.x = event->localPos().x();
  released.y = event->localPos().y();
  pass_on(released);
}

void UltrasoundView::mouseMoveEvent(QMouseEvent* event) {
  station::ScreenEvent moved;
  moved.kind = Kind::motion;
  moved.x = event->localPos().x();
  moved.y = event->localPos().y();
  moved.button = (event->buttons() & Qt::LeftButton) != 0;
  moved.shift = (event->modifiers() & Qt::ShiftModifier) != 0;
  pass_on(moved);
}

void UltrasoundView::wheelEvent(QWheelEvent* event) {
  constexpr double notch = 120.0;
  station::ScreenEvent turned;
  turned.kind = Kind::wheel;
  turned.steps = event->angleDelta().y() / notch;
  turned.shift = (event->modifiers() & Qt::ShiftModifier) != 0;
  event->accept();
  pass_on(turned);
}

void UltrasoundView::leaveEvent(QEvent* /*event*/) {
  station::ScreenEvent left;
  left.kind = Kind::leave;
  pass_on(left);
}

void UltrasoundView::focusOutEvent(QFocusEvent* /*event*/) {
  station::ScreenEvent lost;
  lost.kind = Kind::focus_lost;
  pass_on(lost);
}

}  // namespace bodkin::views
