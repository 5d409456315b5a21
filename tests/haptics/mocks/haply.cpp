#include "tests/haptics/mocks/haply.h"

#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "tests/haptics/mocks/mechanism.h"
#include <Eigen/Geometry>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mock {

namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;
using Json = nlohmann::json;
using Socket = asio::ip::tcp::socket;

constexpr const char* the_device = "04BA";
constexpr const char* the_grip = "61576";
constexpr double peak = 10.0;   // N
constexpr int grip_every = 20;  // ticks: 50 Hz
constexpr int idle_after = 50;  // ms
constexpr std::size_t long_answer = 100'000;

Json xyz(const std::array<double, 3>& values) {
  return {{"x", values[0]}, {"y", values[1]}, {"z", values[2]}};
}

// A text frame as sent by a server, for frames that Beast cannot send.
std::string frame(const std::string& text) {
  std::string bytes = "\x81";
  bytes += '\x7e';
  bytes += static_cast<char>(text.size() >> 8 & 0xff);
  bytes += static_cast<char>(text.size() & 0xff);
  return bytes + text;
}

}  // namespace

struct HaplyService::Server {
  // The services of a port.
  enum class Door { both, http, sessions, events };

  Server(Board& its_board, Behaviour its_behaviour)
      : board(its_board),
        behaviour(std::move(its_behaviour)),
        listener(context, {asio::ip::address_v4::loopback(), 0}),
        session_listener(context, {asio::ip::address_v4::loopback(), 0}),
        event_listener(context, {asio::ip::address_v4::loopback(), 0}) {
    acceptors.emplace_back([this] { accept(listener, behaviour.apart ? Door::http : Door::both); });
    if (behaviour.apart) acceptors.emplace_back([this] { accept(session_listener, Door::sessions); });
    if (behaviour.events) acceptors.emplace_back([this] { accept(event_listener, Door::events); });
  }
  ~Server() {
    ended = true;
    for (auto* one : {&listener, &session_listener, &event_listener}) ::shutdown(one->native_handle(), SHUT_RDWR);
    for (std::thread& acceptor : acceptors) acceptor.join();
    {
      const std::lock_guard lock(mutex);
      for (const int handle : handles) ::shutdown(handle, SHUT_RDWR);
    }
    for (std::thread& session : sessions) session.join();
    for (const int handle : handles) ::close(handle);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  void accept(asio::ip::tcp::acceptor& at, Door door) {
    while (!ended) {
      auto socket = std::make_shared<Socket>(context);
      error_code error;
      at.accept(*socket, error);
      if (error) continue;
      socket->set_option(asio::ip::tcp::no_delay(true), error);
      const std::lock_guard lock(mutex);
      // A separate handle: the session's thread closes its socket at any time.
      const int handle = ::dup(socket->native_handle());
      handles.push_back(handle);
      sessions.emplace_back([this, socket, handle, door] {
        serve(*socket, door);
        ::shutdown(handle, SHUT_RDWR);
      });
    }
  }

  void serve(Socket& socket, Door door) {
    error_code error;
    boost::beast::flat_buffer buffer;
    http::request<http::string_body> request;
    http::read(socket, buffer, request, error);
    if (error) return;
    const bool upgrade = websocket::is_upgrade(request);
    if (upgrade && door == Door::events) {
      hold_listener(socket, request);
    } else if (upgrade && door != Door::http) {
      hold_session(socket, request);
    } else if (door == Door::sessions || door == Door::events) {
      http::response<http::string_body> refused{http::status::upgrade_required, request.version()};
      refused.prepare_payload();
      http::write(socket, refused, error);
    } else {
      http::write(socket, answer(request), error);
    }
  }

  void hold_listener(Socket& socket, const http::request<http::string_body>& request) {
    websocket::stream<Socket&> stream(socket);
    error_code error;
    stream.accept(request, error);
    stream.text(true);
    std::size_t told = 0;
    while (!error && !ended) {
      std::string text;
      {
        std::unique_lock lock(mutex);
        spoken.wait_for(lock, std::chrono::milliseconds(20), [&] { return told < events.size() || ended; });
        if (told == events.size()) continue;
        text = events[told++];
      }
      stream.write(asio::buffer(text), error);
    }
  }

  http::response<http::string_body> answer(const http::request<http::string_body>& request) const {
    const std::string path = behaviour.older_paths ? "/3.0/version" : "/version";
    const bool known = request.method() == http::verb::get && request.target() == path;
    http::response<http::string_body> made{known ? http::status::ok : http::status::not_found, request.version()};
    const std::string version = board.troubled_by(Trouble::wrong_version) ? "2.9.0" : behaviour.version;
    made.body() = known ? Json{{"project_version", version},
                               {"git_tag", "v" + version},
                               {"project_name", behaviour.project},
                               {"git_branch", "main"}}
                              .dump()
                        : R"({"ok":false,"error":"no such route"})";
    made.prepare_payload();
    return made;
  }

  struct Session {
    explicit Session(Socket& its_socket) : socket(its_socket) {}
    websocket::stream<Socket&> socket;
    bool introduced = false;
    bool left = false;  // it is no longer counted
  };

  void leave(Session& session) {
    if (std::exchange(session.left, true)) return;
    const std::lock_guard lock(mutex);
    rest();
    --board.open_devices;
  }

  void hold_session(Socket& socket, const http::request<http::string_body>& request) {
    Session session(socket);
    error_code error;
    session.socket.accept(request, error);
    if (error) return;
    // Removed from the count before the client receives the goodbye.
    session.socket.control_callback([&](websocket::frame_type kind, boost::beast::string_view) {
      if (kind == websocket::frame_type::close) leave(session);
    });
    session.socket.text(true);
    board.wait_while(Trouble::open_blocks);
    board.opened();
    session.socket.write(asio::buffer(inventory().dump()), error);
    while (!error && !ended) {
      pollfd one{socket.native_handle(), POLLIN, 0};
      if (poll(&one, 1, idle_after) == 0) {
        const std::lock_guard lock(mutex);
        rest();
        continue;
      }
      boost::beast::flat_buffer message;
      session.socket.read(message, error);
      if (!error)
        error = reply(session, std::string(static_cast<const char*>(message.data().data()), message.size()));
    }
    leave(session);
  }

  void rest() {
    board.motors_on = false;
    for (auto& component : board.force) component = 0.0;
    idle = true;
  }

  error_code reply(Session& session, const std::string& message) {
    board.wait_while(Trouble::freeze);
    if (board.troubled_by(Trouble::late)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const Json json = Json::parse(message, nullptr, false);
    if (json.is_discarded()) board.violation("a message was no JSON");
    if (!session.introduced) board.wait_while(Trouble::start_blocks);
    if (message.find("probe_position") != std::string::npos) board.wait_while(Trouble::stop_blocks);
    introduce(session, json);
    std::string text;
    {
      const std::lock_guard lock(mutex);
      obey(json);
      const bool full = behaviour.full_on_request && json.is_object() && json.contains("session") &&
                        json.at("session").contains("force_render_full_state");
      text = (full ? with_configuration(state()) : state()).dump();
    }
    return send(session, text);
  }

  void introduce(Session& session, const Json& json) {
    const auto name = Json::json_pointer("/session/configure/profile/name");
    const bool introduces = json.is_object() && json.contains(name);
    if (introduces == session.introduced) {
      board.violation(introduces ? "the profile was sent twice" : "the first message had no profile");
    }
    session.introduced = true;
    if (!introduces) return;
    const std::lock_guard lock(mutex);
    profile = json.at(name).get<std::string>();
    if (!behaviour.remembered_basis.empty()) basis = behaviour.remembered_basis;
  }

  void obey(const Json& json) {
    double force[3] = {0, 0, 0};
    bool commanded = false;
    for (const Json& device : json.is_object() ? json.value("inverse3", Json::array()) : Json::array()) {
      if (device.value("device_id", "") != the_device) board.violation("a message named a device that is not there");
      const Json commands = device.value("commands", Json::object());
      if (!commands.contains("set_cursor_force")) continue;
      const Json& command = commands.at("set_cursor_force");
      if (!command.contains(behaviour.vector)) continue;
      commanded = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const Json component = command.at(behaviour.vector).value(std::string(1, "xyz"[i]), Json());
        if (!component.is_number()) board.violation("a force was no number");
        force[i] = component.is_number() ? component.get<double>() : 0.0;
      }
    }
    const bool dead = board.troubled_by(Trouble::unplug) || board.troubled_by(Trouble::emergency_stop) ||
                      board.troubled_by(Trouble::unknown_code);
    idle = !commanded || dead;
    board.motors_on = !idle;
    if (idle) std::fill(std::begin(force), std::end(force), 0.0);
    mechanism.step(board, force, {0, 0, 0});
  }

  Json device_state() {
    const char* mode = behaviour.older_names ? "mode" : "control_mode";
    if (oddity == Oddity::no_position) return {{mode, "force"}};
    Json made = {{"cursor_position", xyz(mechanism.position())}};
    if (oddity == Oddity::fewer_fields) return made;
    made["cursor_velocity"] = xyz(mechanism.velocity());
    made["current_cursor_force"] = xyz({board.force[0], board.force[1], board.force[2]});
    made["angular_position"] = {{"a0", 12.5}, {"a1", -30.0}, {"a2", 75.25}};
    made["control_domain"] = "cartesian";
    made[mode] = idle ? "idle" : "force";
    const bool raised = behaviour.transform || oddity == Oddity::new_transform;
    made["transform"] = {{"position", xyz({0, 0, raised ? 0.1 : 0.0})}, {"scale", xyz({1, 1, 1})}};
    return made;
  }

  Json grip_state() {
    if (grip_age++ % grip_every == 0) {
      Eigen::Matrix3d turn;
      for (int i = 0; i < 9; ++i) turn(i / 3, i % 3) = board.turn[static_cast<std::size_t>(i)];
      const Eigen::Quaterniond q(turn);
      grip_orientation = {{"w", q.w()}, {"x", q.x()}, {"y", q.y()}, {"z", q.z()}};
      const unsigned buttons = board.buttons;
      grip_buttons = {
          {"a", (buttons & 1U) != 0}, {"b", (buttons & 2U) != 0}, {"c", !board.troubled_by(Trouble::hand_off)}};
    }
    if (behaviour.older_names) return {{"orientation", grip_orientation}, {"button", grip_buttons.at("a")}};
    return {{"orientation", grip_orientation}, {"buttons", grip_buttons}, {"battery_level", 0.75}};
  }

  // Of one tick.
  Json state() {
    const char* grips = behaviour.older_names ? "verse_grip" : "wireless_verse_grip";
    Json made = {{"inverse3", Json::array()}, {grips, Json::array()}};
    if (!board.troubled_by(Trouble::unplug) && !board.troubled_by(Trouble::no_device)) {
      Json device = {{"device_id", the_device}, {"state", device_state()}};
      if (oddity != Oddity::fewer_fields) {
        device["status"] = {{"calibrated", !board.troubled_by(Trouble::uncalibrated)},
                            {"power_supply", !board.troubled_by(Trouble::emergency_stop)},
                            {"in_use", true},
                            {"ready", true},
                            {"started", true}};
      }
      made["inverse3"].push_back(device);
    }
    if (behaviour.grip && oddity != Oddity::grip_gone && oddity != Oddity::fewer_fields) {
      made[grips].push_back(
          {{"device_id", the_grip},
           {"state", grip_state()},
           {"status", {{"connected", true}, {"awake", oddity != Oddity::grip_asleep}, {"ready", true}}}});
    }
    if (oddity == Oddity::more_fields) {
      made["weather"] = {{"inverse3", {1, 2, {{"state", nullptr}}}}, {"text", "\"}]\\ \u00e4"}};
      made["inverse3"].push_back({{"device_id", "FFFF"}, {"state", {{"cursor_position", xyz({9, 9, 9})}}}});
    }
    return made;
  }

  // The first message.
  Json inventory() {
    const std::lock_guard lock(mutex);
    Json made = with_configuration(state());
    made["session_id"] = 7;
    return made;
  }
  Json with_configuration(Json made) const {
    for (Json& device : made["inverse3"]) {
      Json config = {{"type", "inverse3"},
                     {"port", "/dev/ttyACM0"},
                     {"basis", {{"permutation", oddity == Oddity::new_basis ? "YXZ" : basis}}}};
      if (!behaviour.preset.empty()) config["preset"] = behaviour.preset;
      if (oddity == Oddity::new_preset) config["preset"] = "arm_front";
      if (!std::isnan(behaviour.mount_height)) {
        config["mount"] = {{"position", xyz({0, 0, oddity == Oddity::new_mount ? 0.1 : behaviour.mount_height})},
                           {"rotation", {{"w", 1}, {"x", 0}, {"y", 0}, {"z", 0}}},
                           {"scale", xyz({1, 1, 1})}};
      }
      device["config"] = config;
    }
    return made;
  }

  error_code send(Session& session, std::string text) {
    error_code error;
    Socket& raw = session.socket.next_layer();
    switch (oddity.load()) {
      case Oddity::fragments:
        session.socket.write_some(false, asio::buffer(text.data(), text.size() / 2), error);
        session.socket.write_some(true, asio::buffer(text.substr(text.size() / 2)), error);
        return error;
      case Oddity::ping:
        session.socket.ping("are you there", error);
        break;
      case Oddity::two_at_once:
        asio::write(raw, asio::buffer(frame(text) + frame(text)), error);
        return error;
      case Oddity::half_a_frame:
        asio::write(raw, asio::buffer(frame(text).substr(0, text.size() / 2)), error);
        return error;
      case Oddity::cut_in_a_frame:
        asio::write(raw, asio::buffer(frame(text).substr(0, text.size() / 2)), error);
        return asio::error::eof;
      case Oddity::hang_up:
        return asio::error::eof;
      case Oddity::no_answer:
        return error;
      case Oddity::no_json:
        text.resize(text.size() / 2);
        break;
      case Oddity::huge_number: {
        const std::size_t at = text.find("\"x\":", text.find("cursor_position")) + 4;
        text.replace(at, text.find(',', at) - at, "1e999");
        break;
      }
      case Oddity::too_long:
        text.insert(1, "\"words\":\"" + std::string(long_answer, 'a') + "\",");
        break;
      default:
        break;
    }
    session.socket.write(asio::buffer(text), error);
    return error;
  }

  Board& board;
  const Behaviour behaviour;
  asio::io_context context;
  asio::ip::tcp::acceptor listener, session_listener, event_listener;
  std::atomic<bool> ended{false};
  std::atomic<Oddity> oddity{Oddity::none};
  std::mutex mutex;
  std::vector<int> handles;
  std::vector<std::thread> sessions;
  Mechanism mechanism{1.0, peak};
  bool idle = true;
  long grip_age = 0;
  Json grip_orientation, grip_buttons;
  std::string profile;
  std::string basis = behaviour.basis;
  std::vector<std::string> events;
  std::condition_variable spoken;
  std::vector<std::thread> acceptors;
};

HaplyService::Behaviour HaplyService::of(const std::string& version) {
  Behaviour behaviour;
  behaviour.version = version + ".1";
  behaviour.vector = version == "3.5" ? "vector" : "values";
  behaviour.events = version == "3.4" || version == "3.5";
  if (version == "3.5") return behaviour;
  behaviour.preset.clear();
  behaviour.mount_height = std::numeric_limits<double>::quiet_NaN();
  behaviour.older_paths = behaviour.older_names = version == "3.0";
  behaviour.full_on_request = behaviour.apart = !behaviour.older_paths;
  return behaviour;
}

HaplyService::HaplyService(Board& board) : HaplyService(board, Behaviour{}) {}
HaplyService::HaplyService(Board& board, Behaviour behaviour)
    : server_(std::make_unique<Server>(board, std::move(behaviour))) {}
HaplyService::~HaplyService() = default;

int HaplyService::port() const noexcept {
  return server_->listener.local_endpoint().port();
}

int HaplyService::websocket_port() const noexcept {
  return server_->behaviour.apart ? server_->session_listener.local_endpoint().port() : port();
}

int HaplyService::events_port() const noexcept {
  return server_->behaviour.events ? server_->event_listener.local_endpoint().port() : 0;
}

void HaplyService::send_event(const std::string& event) {
  const std::lock_guard lock(server_->mutex);
  server_->events.push_back(event);
  server_->spoken.notify_all();
}

std::atomic<Oddity>& HaplyService::oddity() noexcept {
  return server_->oddity;
}

std::string HaplyService::profile() const {
  const std::lock_guard lock(server_->mutex);
  return server_->profile;
}

}  // namespace mock
