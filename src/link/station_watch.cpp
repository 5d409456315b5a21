#include "link/station_watch.h"

#include <algorithm>
#include <mutex>

#include "link/contents.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/xml_writer.h"

namespace bodkin::link {

namespace {

constexpr double kept_time = 20.0, kept_interval = 0.1;  // s

std::string text_in(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::size_t count_in(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number_unsigned() ? found->get<std::size_t>() : 0;
}

constexpr std::size_t most_layers = 200;

bool is_colour(const std::string& text) {
  return text.size() == 7 && text.front() == '#' &&
         text.find_first_not_of("0123456789abcdef", 1) == std::string::npos;
}

std::vector<StationLayer> layers_in(const nlohmann::json& json) {
  std::vector<StationLayer> layers;
  const auto found = json.find("layers");
  if (found == json.end() || !found->is_array()) return layers;
  for (const nlohmann::json& layer : *found) {
    if (layers.size() == most_layers || !layer.is_array() || layer.size() != 3 || !layer[0].is_string() ||
        !layer[1].is_string() || !layer[2].is_number() || !is_colour(layer[1].get<std::string>()))
      return {};
    layers.push_back({layer[0].get<std::string>(), layer[1].get<std::string>(), layer[2].get<double>()});
  }
  return layers;
}

// The attribute of an element written by another instance of this program: enough for <CommandReply Status="..." />.
std::string attribute_in(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(name + "=\"");
  if (at == std::string::npos) return {};
  const std::size_t begin = at + name.size() + 2;
  return text.substr(begin, text.find('"', begin) - begin);
}

void take_force(StationView& view, const NumberArray& rows) {
  if (rows.size.size() != 2 || rows.size[1] < 3) return;
  const std::size_t columns = rows.size[1];
  for (std::size_t at = 0; at + columns <= rows.values.size(); at += columns) {
    const StationState moment{rows.values[at], rows.values[at + 1], rows.values[at + 2]};
    std::vector<StationState>& moments = view.moments;
    if (!moments.empty() && moment.time < moments.back().time) moments.clear();  // a new session
    if (moments.empty() || moment.time - moments.back().time >= kept_interval) moments.push_back(moment);
  }
  std::erase_if(view.moments, [last = view.moments.empty() ? 0.0 : view.moments.back().time](const auto& moment) {
    return moment.time < last - kept_time;
  });
}

void take_text(StationView& view, const std::string& device, const std::string& text) {
  if (device.starts_with("ACK_")) {
    const std::string status = attribute_in(text, "Status");
    view.reply = status == "SUCCESS" ? status : attribute_in(text, "Message");
    return;
  }
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return;
  if (device == "Case") {
    view.patient = text_in(json, "case");
    view.procedure = text_in(json, "procedure");
    view.tissues_digest = text_in(json, "tissues_digest");
    view.layers = layers_in(json);
    const auto path = json.find("path_mm");
    view.path = path != json.end() && path->is_number() ? path->get<double>() : 0.0;
  } else if (device == "State") {
    view.runs = text_in(json, "guard") != "waiting";
    if (const std::string name = text_in(json, "case"); !name.empty()) view.patient = name;
    view.guard = text_in(json, "guard");
    view.tissue = text_in(json, "tissue");
    view.step = text_in(json, "step");
    view.step_number = count_in(json, "step_number");
    view.steps = count_in(json, "steps");
  } else if (device == "Event") {
    view.event = text_in(json, "event");
    if (const std::string tissue = text_in(json, "tissue"); !tissue.empty()) view.event += " (" + tissue + ")";
  }
}

}  // namespace

struct StationWatch::Shared {
  explicit Shared(const ClientSettings& settings)
      : client(settings, {.message = [this](const Message& message) { take(message); },
                          .connected =
                              [this](Client&) {
                                const std::lock_guard lock(mutex);
                                view = {};
                              }}) {}

  void take(const Message& message) noexcept {
    try {
      const std::lock_guard lock(mutex);
      if (message.type == "STRING") take_text(view, message.device, read_string(message.content));
      if (message.type == "NDARRAY" && message.device == "Force") take_force(view, read_array(message.content));
      if (message.type == "IMAGE") {
        GreyImage image = read_image(message.content);
        view.picture_width = image.width;
        view.picture_height = image.height;
        view.picture = std::move(image.pixels);
      }
    } catch (const std::exception&) {
      return;  // a message of a foreign kind is ignored
    }
  }

  mutable std::mutex mutex;
  StationView view;
  std::uint64_t commands = 0;
  Client client;  // last: its thread ends first
};

StationWatch::StationWatch(const ClientSettings& settings) : shared_(std::make_unique<Shared>(settings)) {}

StationWatch::~StationWatch() = default;

StationView StationWatch::view() const {
  StationView view;
  {
    const std::lock_guard lock(shared_->mutex);
    view = shared_->view;
  }
  view.place = shared_->client.place();
  view.status = shared_->client.status();
  return view;
}

void StationWatch::command(const std::string& name, const std::vector<std::pair<std::string, std::string>>& values) {
  io::XmlWriter xml;
  xml.open("Command");
  xml.attribute("Name", name);
  for (const auto& [key, value] : values) xml.attribute(key, value);
  xml.close();
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(shared_->mutex);
    number = ++shared_->commands;
    shared_->view.reply.clear();
  }
  shared_->client.send({"STRING", fmt::format("CMD_{}", number), time_now(), string_content(xml.finish())});
}

}  // namespace bodkin::link
