#include "desktop/mouse_window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace bodkin::desktop {

namespace {

using Size = SdlScreen::Size;
using Align = SdlScreen::Align;

constexpr int width = 960, height = 600;  // pixels
constexpr int width_with_ultrasound = static_cast<int>(MouseWindow::ultrasound_x + UltrasoundPane::width);
constexpr std::chrono::microseconds frame{33000}, quick_frame{16667};
constexpr double curve_time = 10.0;                                              // s
constexpr std::array<double, 6> curve_tops = {1.0, 2.0, 5.0, 10.0, 20.0, 50.0};  // N

constexpr Colour background{15, 19, 26}, panel{24, 31, 42}, grid{45, 56, 72}, ink{232, 238, 245},
    faint{142, 156, 174};
constexpr Colour accent{76, 194, 255}, good{70, 200, 120}, warn{245, 185, 66}, bad{240, 84, 84}, dark{12, 15, 20};

struct Box {
  double x, y, width, height;
};
constexpr Box force_box{24, 84, 632, 152}, side_box{672, 84, 264, 492};
constexpr Box wide_curve_box{24, 252, 632, 324}, narrow_curve_box{24, 252, 292, 324},
    body_box_on_screen{332, 252, 324, 324};

// What the keys do, as the window says it.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> help = {{
    {"mouse, arrows", "sideways"},
    {"wheel, W S", "in and out"},
    {"page down, up", "in and out"},
    {"shift-drag, Q E", "tilt"},
    {"shift", "fine motion"},
    {"space", "hold, take again"},
    {"C", "clutch"},
    {"A  D", "arm, disarm"},
    {"Escape", "end"},
}};

void fill(SdlScreen& screen, const Box& box, Colour colour) {
  screen.fill(box.x, box.y, box.width, box.height, colour);
}

// The least of the curve's scales that holds `force`.
double top_for(double force) {
  const auto* const top = std::find_if(curve_tops.begin(), curve_tops.end(), [&](double t) { return t >= force; });
  return top == curve_tops.end() ? curve_tops.back() : *top;
}

Colour colour_of(double force) {
  return force < 4.0 ? accent : force < 8.0 ? warn : bad;
}

}  // namespace

MouseWindow::MouseWindow(std::string title, bool with_ultrasound, bool has_mouse)
    : title_(std::move(title)),
      screen_("Bodkin: " + title_, with_ultrasound ? width_with_ultrasound : width, height),
      has_mouse_(has_mouse) {
  connect_mouse(feed_);
  show({});
}

void MouseWindow::poll() {
  ScreenEvent event;
  while (screen_.next(event)) handle(event);
  feed_->write(input_.state());
}

void MouseWindow::handle(const ScreenEvent& event) {
  using Kind = ScreenEvent::Kind;
  if (pane_ && pane_->handle(event)) return;
  const bool turning = event.kind == Kind::motion && event.shift && event.button;
  input_.fine(event.shift && !turning);
  switch (event.kind) {
    case Kind::motion: {
      const Eigen::Vector2d now(event.x, event.y);
      const Eigen::Vector2d way = now - pointer_.value_or(now);
      pointer_ = now;
      input_.move(way.x(), -way.y(), turning);
      break;
    }
    case Kind::button:  // a motion says whether one is held
      break;
    case Kind::leave:
      pointer_.reset();
      break;
    case Kind::wheel:
      input_.wheel(event.steps);
      break;
    case Kind::key:
      press(event.key, event.down);
      break;
    case Kind::focus_lost:
      input_.release();
      break;
    case Kind::close:
      input_.end();
      keys_.push_back('q');
      break;
  }
}

void MouseWindow::press(ScreenKey key, bool down) {
  using Move = haptics::PointerInput::Key;
  const auto command = [&](char letter) {
    if (down) keys_.push_back(letter);
  };
  switch (key) {
    case ScreenKey::right:
      return input_.key(Move::right, down);
    case ScreenKey::left:
      return input_.key(Move::left, down);
    case ScreenKey::up:
      return input_.key(Move::away, down);
    case ScreenKey::down:
      return input_.key(Move::near, down);
    case ScreenKey::page_down:
    case ScreenKey::w:
      return input_.key(Move::inwards, down);
    case ScreenKey::page_up:
    case ScreenKey::s:
      return input_.key(Move::outwards, down);
    case ScreenKey::q:
      return input_.key(Move::tilt_away, down);
    case ScreenKey::e:
      return input_.key(Move::tilt_near, down);
    case ScreenKey::space:
      return command(' ');
    case ScreenKey::a:
      return command('a');
    case ScreenKey::c:
      return command('c');
    case ScreenKey::d:
      return command('d');
    case ScreenKey::escape:
      if (down) input_.end();
      return command('q');
    default:
      return;
  }
}

std::optional<char> MouseWindow::next_key() {
  if (keys_.empty()) return std::nullopt;
  const char key = keys_.front();
  keys_.pop_front();
  return key;
}

void MouseWindow::show(const WindowScene& scene) {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::microseconds interval = pane_ ? quick_frame : frame;
  if (now - shown_ < interval) return;
  // In step, unless a beat was missed altogether.
  shown_ = now - shown_ < 2 * interval ? shown_ + interval : now;
  if (pane_ && scene.ultrasound != nullptr) pane_->update(*scene.ultrasound, scene.probe_is_held);
  history_.push_back({scene.time, scene.force});
  while (history_.front().time < scene.time - curve_time) history_.pop_front();
  draw(scene);
}

void MouseWindow::draw(const WindowScene& scene) {
  screen_.clear(background);
  screen_.text(24, 18, title_, Size::large, ink);
  screen_.text(24, 54, scene.message, Size::small, scene.faulted ? bad : faint);
  const Colour state = scene.faulted ? bad : scene.armed ? good : faint;
  screen_.fill(796, 20, 140, 34, state);
  screen_.text(866, 28, scene.state, Size::normal, dark, Align::middle);
  if (!scene.hold.empty()) {
    screen_.fill(672, 20, 112, 34, warn);
    screen_.text(728, 28, scene.hold, Size::normal, dark, Align::middle);
  }
  draw_force(scene);
  draw_curve();
  if (body_) draw_body(scene);
  draw_side(scene);
  if (pane_) pane_->draw(screen_);
  screen_.present();
}

void MouseWindow::draw_force(const WindowScene& scene) {
  constexpr double full = 10.0, left = force_box.x + 20.0, length = force_box.width - 40.0;
  constexpr double top = force_box.y + 92.0, thick = 24.0;
  fill(screen_, force_box, panel);
  screen_.text(left, force_box.y + 14.0, "Force on the needle", Size::normal, faint);
  screen_.text(left + length, force_box.y + 14.0, fmt::format("{:.2f} N", scene.force), Size::huge, ink,
               Align::right);
  screen_.fill(left, top, length, thick, grid);
  screen_.fill(left, top, length * std::clamp(scene.force / full, 0.0, 1.0), thick, colour_of(scene.force));
  for (int newton = 0; newton <= static_cast<int>(full); newton += 2) {
    const double x = left + length * newton / full;
    screen_.text(x, top + thick + 6.0, fmt::format("{}", newton), Size::small, faint,
                 newton == 0      ? Align::left
                 : newton == full ? Align::right
                                  : Align::middle);
  }
}

void MouseWindow::draw_curve() {
  const Box& curve_box = body_ ? narrow_curve_box : wide_curve_box;
  const double left = curve_box.x + 56.0, right = curve_box.x + curve_box.width - 20.0;
  const double upper = curve_box.y + 44.0, lower = curve_box.y + curve_box.height - 34.0;
  fill(screen_, curve_box, panel);
  screen_.text(curve_box.x + 20.0, curve_box.y + 14.0, "The last ten seconds", Size::normal, faint);
  double most = 0.0;
  for (const Sample& sample : history_) most = std::max(most, sample.force);
  const double top = top_for(most);
  constexpr int rows = 4;
  for (int row = 0; row <= rows; ++row) {
    const double y = lower - (lower - upper) * row / rows;
    screen_.fill(left, y, right - left, 1.0, grid);
    screen_.text(left - 8.0, y - 8.0, fmt::format("{:g} N", top * row / rows), Size::small, faint, Align::right);
  }
  for (int second = -10; second <= 0; second += body_ ? 5 : 2) {
    const double x = right + (right - left) * second / curve_time;
    screen_.fill(x, lower, 1.0, 5.0, grid);
    screen_.text(x, lower + 8.0, fmt::format("{} s", second), Size::small, faint,
                 second == 0 ? Align::right : Align::middle);
  }
  std::vector<Eigen::Vector2f> points;
  points.reserve(history_.size());
  const double now = history_.back().time;
  for (const Sample& sample : history_) {
    const double x = right + (right - left) * (sample.time - now) / curve_time;
    const double y = lower - (lower - upper) * std::min(sample.force / top, 1.0);
    points.emplace_back(static_cast<float>(x), static_cast<float>(y));
  }
  screen_.line(points, accent);
}

void MouseWindow::draw_body(const WindowScene& scene) {
  constexpr double title = 40.0;  // pixels
  const Box& box = body_box_on_screen;
  fill(screen_, box, panel);
  screen_.text(box.x + 20.0, box.y + 14.0, "The body along the path", Size::normal, faint);
  body_->draw(screen_, box.x + 0.5 * title, box.y + title, box.width - title, scene.needle, scene.displacements);
}

void MouseWindow::draw_side(const WindowScene& scene) {
  constexpr double left = side_box.x + 20.0, right = side_box.x + side_box.width - 20.0;
  fill(screen_, side_box, panel);
  screen_.text(left, side_box.y + 14.0, "Depth", Size::normal, faint);
  screen_.text(right, side_box.y + 36.0, fmt::format("{:.1f} mm", scene.depth), Size::huge, ink, Align::right);
  screen_.text(left, side_box.y + 104.0, "Tissue at the tip", Size::normal, faint);
  screen_.text(left, side_box.y + 128.0, scene.tissue, Size::normal, ink);
  const auto row = [&](double y, const char* what, const std::string& value) {
    screen_.text(left, y, what, Size::normal, faint);
    screen_.text(right, y, value, Size::normal, ink, Align::right);
  };
  row(side_box.y + 166.0, "Beside the path", fmt::format("{:.1f} mm", scene.beside));
  row(side_box.y + 192.0, "Angle to it", fmt::format("{:.1f}°", scene.angle));
  row(side_box.y + 218.0, "Time", fmt::format("{:.0f} s", scene.time));
  double y = side_box.y + 264.0;
  screen_.fill(left, y - 12.0, right - left, 1.0, grid);
  constexpr std::size_t of_the_mouse = 5;  // of the help's rows, the first ones
  for (std::size_t i = has_mouse_ ? 0 : of_the_mouse; i < help.size(); ++i) {
    const auto& [keys, what] = help[i];
    screen_.text(left, y, std::string(keys), Size::small, ink);
    screen_.text(right, y, std::string(what), Size::small, faint, Align::right);
    y += 25.0;
  }
}

}  // namespace bodkin::desktop
