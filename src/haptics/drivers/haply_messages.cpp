#include "haptics/drivers/haply_messages.h"

#include <charconv>
#include <cmath>
#include <cstring>

#include <simdjson.h>

namespace bodkin::haptics {

namespace {

namespace json = simdjson::ondemand;

constexpr std::size_t longest_number = 32;
constexpr std::size_t closing = 64;  // rest of a command after its beginning, numbers aside
constexpr double unmoved = 1e-6;     // of a transform's numbers

// Runs `use(key, value)` for every member of an object; false when the object or a member is damaged.
template <typename Value, typename Use>
bool members(Value value, Use use) noexcept {
  json::object object;
  if (value.get_object().get(object) != simdjson::SUCCESS) return false;
  for (auto member : object) {
    json::raw_json_string key;
    json::value inner;
    if (member.key().get(key) != simdjson::SUCCESS || member.value().get(inner) != simdjson::SUCCESS) return false;
    if (!use(key, inner)) return false;
  }
  return true;
}

// The same check for the elements of a list.
template <typename Use>
bool elements(json::value value, Use use) noexcept {
  json::array array;
  if (value.get_array().get(array) != simdjson::SUCCESS) return false;
  for (auto element : array) {
    json::value inner;
    if (element.get(inner) != simdjson::SUCCESS || !use(inner)) return false;
  }
  return true;
}

// An object of numbers, all required, named by single letters.
template <std::size_t Count>
bool numbers(json::value value, const char (&letters)[Count], double* to) noexcept {
  constexpr unsigned all = (1U << (Count - 1)) - 1;
  unsigned found = 0;
  const bool whole = members(value, [&](json::raw_json_string key, json::value inner) {
    for (std::size_t i = 0; i + 1 < Count; ++i) {
      const char name[2] = {letters[i], '\0'};
      if (!(key == name)) continue;
      found |= 1U << i;
      return inner.get_double().get(to[i]) == simdjson::SUCCESS && std::isfinite(to[i]);
    }
    return true;
  });
  return whole && found == all;
}

bool truth(json::value value, bool& to) noexcept {
  return value.get_bool().get(to) == simdjson::SUCCESS;
}

bool text(json::value value, std::string_view& to) noexcept {
  return value.get_string().get(to) == simdjson::SUCCESS;
}

bool read_status(json::value value, HaplyReading& to) noexcept {
  return members(value, [&](json::raw_json_string key, json::value inner) {
    if (key == "calibrated") return truth(inner, to.calibrated);
    if (key == "power_supply") return truth(inner, to.powered);
    return true;
  });
}

// Whether every number of an object, except its `w`, is `expected`.
bool are_all(json::value value, double expected, bool& so) noexcept {
  return members(value, [&](json::raw_json_string key, json::value inner) {
    if (key == "w") return true;
    double number = 0.0;
    if (inner.get_double().get(number) != simdjson::SUCCESS) return false;
    so = so && std::abs(number - expected) < unmoved;
    return true;
  });
}

// The service omits unchanged values.
bool read_transform(json::value value, HaplyReading& to) noexcept {
  bool same = true;
  const bool whole = members(value, [&](json::raw_json_string key, json::value inner) {
    if (key == "position" || key == "rotation") return are_all(inner, 0.0, same);
    if (key == "scale") return are_all(inner, 1.0, same);
    return true;
  });
  to.moved = !same;
  return whole;
}

// A word that the vendor's pages give alone or within an object of the same name, under `inner`. `usual`: whether it
// is one that leaves the axes unchanged.
template <typename Usual>
bool read_word(json::value value, const char* inner, Usual usual, bool& so) noexcept {
  const auto take = [&](json::value word) {
    std::string_view stated;
    if (!text(word, stated)) return false;
    so = so && (stated.empty() || usual(stated));
    return true;
  };
  json::json_type type{};
  if (value.type().get(type) != simdjson::SUCCESS) return false;
  if (type == json::json_type::null) return true;
  if (type != json::json_type::object) return take(value);
  return members(value, [&](json::raw_json_string key, json::value word) { return !(key == inner) || take(word); });
}

bool read_mount(json::value value, bool& so) noexcept {
  json::json_type type{};
  if (value.type().get(type) != simdjson::SUCCESS) return false;
  if (type == json::json_type::null) return true;
  return members(value, [&](json::raw_json_string key, json::value inner) {
    if (key == "position" || key == "rotation") return are_all(inner, 0.0, so);
    if (key == "scale") return are_all(inner, 1.0, so);
    return !(key == "transform") || read_mount(inner, so);
  });
}

bool read_config(json::value value, HaplyReading& to) noexcept {
  bool same = true;
  const bool whole = members(value, [&](json::raw_json_string key, json::value inner) {
    if (key == "basis") {
      return read_word(
          inner, "permutation", [](std::string_view stated) { return stated == "XYZ" || stated == "xyz"; }, same);
    }
    if (key == "preset")
      return read_word(
          inner, "preset", [](std::string_view stated) { return stated == "defaults"; }, same);
    return !(key == "mount") || read_mount(inner, same);
  });
  to.has_config = true;
  to.config_moved = !same;
  return whole;
}

bool no_config(json::value, HaplyReading&) noexcept {
  return true;
}

bool read_device_state(json::value value, HaplyReading& to) noexcept {
  return members(value, [&](json::raw_json_string key, json::value inner) {
    if (key == "cursor_position") return to.has_position = numbers(inner, "xyz", to.position.data());
    if (key == "cursor_velocity") return to.has_velocity = numbers(inner, "xyz", to.velocity.data());
    if (key == "transform") return read_transform(inner, to);
    if (key == "control_mode" || key == "mode") {  // the vendor's pages have both
      std::string_view mode;
      if (!text(inner, mode)) return false;
      to.idle = mode == "idle";
    }
    return true;
  });
}

bool read_buttons(json::value value, HaplyReading& to) noexcept {
  static constexpr const char* names[] = {"a", "b", "c", "button_0", "button_1", "button_2", "button_3"};
  static constexpr std::uint32_t bits[] = {1, 2, 4, 1, 2, 4, 8};
  to.has_buttons = true;
  return members(value, [&](json::raw_json_string key, json::value inner) {
    for (std::size_t i = 0; i < std::size(names); ++i) {
      if (!(key == names[i])) continue;
      bool pressed = false;
      if (!truth(inner, pressed)) return false;
      if (pressed) to.buttons |= bits[i];
    }
    return true;
  });
}

// The button of a wired grip: a nameless one, or in the format of several.
bool read_button(json::value value, HaplyReading& to) noexcept {
  bool pressed = false;
  if (!truth(value, pressed)) return read_buttons(value, to);
  to.has_buttons = true;
  if (pressed) to.buttons |= 1U;
  return true;
}

bool read_grip_status(json::value value, HaplyReading& to) noexcept {
  return members(value, [&](json::raw_json_string key, json::value inner) {
    if (!(key == "connected") && !(key == "awake")) return true;
    bool well = true;
    if (!truth(inner, well)) return false;
    to.grip_awake = to.grip_awake && well;
    return true;
  });
}

bool read_grip_state(json::value value, HaplyReading& to) noexcept {
  return members(value, [&](json::raw_json_string key, json::value inner) {
    if (key == "orientation") return to.has_rotation = numbers(inner, "wxyz", to.rotation.data());
    if (key == "buttons") return read_buttons(inner, to);
    if (key == "button") return read_button(inner, to);
    return true;
  });
}

// One entry of a list; its name may come last, so it is identified at the end.
template <typename State, typename Status, typename Config>
bool read_entry(json::value value, State state, Status status, Config config, HaplyReading& to,
                std::string_view& name) noexcept {
  return members(value, [&](json::raw_json_string key, json::value inner) {
    if (key == "device_id") return text(inner, name);
    if (key == "state") return state(inner, to);
    if (key == "status") return status(inner, to);
    if (key == "config") return config(inner, to);
    return true;
  });
}

void put_device(const HaplyReading& from, HaplyReading& to) noexcept {
  to.device_listed = true;
  to.has_position = from.has_position;
  to.has_velocity = from.has_velocity;
  to.position = from.position;
  to.velocity = from.velocity;
  to.calibrated = from.calibrated;
  to.powered = from.powered;
  to.idle = from.idle;
  to.moved = from.moved;
  to.has_config = from.has_config;
  to.config_moved = from.config_moved;
}

void put_grip(const HaplyReading& from, HaplyReading& to) noexcept {
  to.grip_listed = true;
  to.grip_awake = from.grip_awake;
  to.has_rotation = from.has_rotation;
  to.has_buttons = from.has_buttons;
  to.rotation = from.rotation;
  to.buttons = from.buttons;
}

bool is_grips(json::raw_json_string key) noexcept {
  return key == "wireless_verse_grip" || key == "verse_grip" || key == "custom_verse_grip";
}

}  // namespace

struct HaplyStateReader::Parser {
  Parser(std::string its_device, std::string its_grip) : device(std::move(its_device)), grip(std::move(its_grip)) {}

  bool read(std::size_t size, HaplyReading& to) noexcept {
    json::document document;
    const simdjson::padded_string_view message(bytes.data(), size, bytes.size());
    if (parser.iterate(message).get(document) != simdjson::SUCCESS) return false;
    const bool whole = members(json::document_reference(document), [&](json::raw_json_string key, json::value value) {
      if (key == "inverse3") {
        to.lists_devices = true;
        return elements(value, [&](json::value entry) { return read_device(entry, to); });
      }
      if (is_grips(key)) return elements(value, [&](json::value entry) { return read_grip(entry, to); });
      return true;
    });
    return whole && document.current_location().error() == simdjson::OUT_OF_BOUNDS;  // nothing follows it
  }

  bool read_device(json::value entry, HaplyReading& to) const noexcept {
    HaplyReading one;
    std::string_view name;
    if (!read_entry(entry, read_device_state, read_status, read_config, one, name)) return false;
    if (name == device) put_device(one, to);
    return true;
  }

  bool read_grip(json::value entry, HaplyReading& to) const noexcept {
    HaplyReading one;
    std::string_view name;
    if (!read_entry(entry, read_grip_state, read_grip_status, no_config, one, name)) return false;
    if (!grip.empty() && name == grip) put_grip(one, to);
    return true;
  }

  std::string device, grip;
  json::parser parser{longest_haply_message};
  std::array<char, longest_haply_message + simdjson::SIMDJSON_PADDING> bytes{};
};

HaplyStateReader::HaplyStateReader(const std::string& device, const std::string& grip)
    : parser_(std::make_unique<Parser>(device, grip)) {
  if (parser_->parser.allocate(longest_haply_message) != simdjson::SUCCESS) throw std::bad_alloc();
}

HaplyStateReader::~HaplyStateReader() = default;

std::span<char> HaplyStateReader::buffer() noexcept {
  return {parser_->bytes.data(), longest_haply_message};
}

bool HaplyStateReader::read(std::size_t size, HaplyReading& reading) noexcept {
  reading = HaplyReading{};
  return size <= longest_haply_message && parser_->read(size, reading);
}

HaplyCommandWriter::HaplyCommandWriter(const std::string& device, HaplyForceKey key) {
  const std::string of_device = R"("inverse3":[{"device_id":")" + device + R"(","commands":{)";
  const std::string name = key == HaplyForceKey::vector ? "vector" : "values";
  const std::string force = of_device + R"("set_cursor_force":{")" + name + R"(":{"x":)";
  force_ = "{" + force;
  introduction_ = R"({"session":{"configure":{"profile":{"name":"org.bodkin.trainer"}}},)" + force;
  inspection_ = R"({"session":{"force_render_full_state":{}},)" + force;
  probe_ = "{" + of_device + R"("probe_position":{}}}]})";
  text_.resize(introduction_.size() + 3 * longest_number + closing);
}

std::string_view HaplyCommandWriter::write(const std::string& beginning, const Vec3& force) noexcept {
  static constexpr std::string_view after[] = {R"(,"y":)", R"(,"z":)", "}}}}]}"};
  char* const begin = text_.data();
  char* to = begin + beginning.copy(begin, beginning.size());
  const bool finite = force.allFinite();
  for (std::size_t i = 0; i < 3; ++i) {
    const double component = finite ? force[static_cast<Eigen::Index>(i)] : 0.0;
    to = std::to_chars(to, to + longest_number, component).ptr;
    to += after[i].copy(to, after[i].size());
  }
  return {begin, static_cast<std::size_t>(to - begin)};
}

}  // namespace bodkin::haptics
