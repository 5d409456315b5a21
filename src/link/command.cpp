#include "link/command.h"

#include <charconv>
#include <cmath>

#include "link/contents.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/xml_document.h"
#include "io/xml_writer.h"

namespace bodkin::link {

namespace {

constexpr std::string_view prefix = "CMD_";
constexpr std::size_t longest_command = 4096;  // bytes
constexpr std::size_t command_name = 128;      // of the field in COMMAND

// The fields of a COMMAND: number, name, character set, length, text.
struct CommandMessage {
  std::uint32_t id = 0;
  std::string name;
  std::string text;
};

CommandMessage read_command_message(std::span<const std::uint8_t> content) {
  ByteReader reader(content);
  CommandMessage message;
  message.id = reader.u32();
  message.name = reader.field(command_name);
  reader.u16();
  const std::span<const std::uint8_t> text = reader.raw(reader.u32());
  message.text.assign(text.begin(), text.end());
  return message;
}

}  // namespace

double Command::number(const std::string& value) const {
  const auto found = values.find(value);
  if (found == values.end()) throw InputError(fmt::format("the command {} needs {}=\"a number\"", name, value));
  double result = 0.0;
  const char* const end = found->second.data() + found->second.size();
  const auto [last, error] = std::from_chars(found->second.data(), end, result);
  if (error != std::errc() || last != end || !std::isfinite(result)) {
    throw InputError(
        fmt::format("{} of the command {} is {}, expected a number", value, name, io::in_quotes(found->second)));
  }
  return result;
}

std::optional<Command> command_of(const Message& message) {
  Command command;
  std::string text;
  if (message.type == "STRING" && message.device.starts_with(prefix)) {
    command.id = message.device.substr(prefix.size());
    text = read_string(message.content);
  } else if (message.type == "COMMAND") {
    const CommandMessage found = read_command_message(message.content);
    command.id = std::to_string(found.id);
    command.is_command_message = true;
    text = found.text;
  } else {
    return std::nullopt;
  }
  if (text.size() > longest_command)
    throw InputError(fmt::format("a command has {} bytes, expected at most {}", text.size(), longest_command));
  static const io::XmlSchema schema("link_command.xsd");
  const io::XmlElement root = schema.read(text, "the command", {.root = "Command", .lines = false});
  for (const auto& [name, value] : root.attributes) {
    if (name == "Name")
      command.name = value;
    else
      command.values.emplace(name, value);
  }
  for (const io::XmlElement& parameter : root.children)
    command.values.insert_or_assign(parameter.string("Name"), parameter.string("Value"));
  return command;
}

Message reply_to(const Message& request, bool success, const std::string& sentence, double time) {
  io::XmlWriter xml;
  xml.open("CommandReply");
  xml.attribute("Status", success ? "SUCCESS" : "FAIL");
  xml.attribute("Message", sentence);
  xml.close();
  std::string text = xml.finish();
  if (text.starts_with("<?xml")) text.erase(0, text.find("?>") + 2);  // clients look for the element itself
  while (!text.empty() && (text.front() == '\n' || text.front() == ' ')) text.erase(0, 1);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (request.type != "COMMAND") {
    const std::string id = request.device.starts_with(prefix) ? request.device.substr(prefix.size()) : request.device;
    return {"STRING", "ACK_" + id.substr(0, 16), time, string_content(text)};
  }
  std::uint32_t id = 0;
  std::string name;
  if (request.content.size() >= sizeof(id) + command_name) {
    ByteReader reader(request.content);
    id = reader.u32();
    name = reader.field(command_name);
  }
  ByteWriter writer;
  writer.u32(id);
  writer.field(name, command_name);
  writer.u16(3);
  writer.u32(static_cast<std::uint32_t>(text.size()));
  writer.field(text, text.size());
  return {"RTS_COMMAND", request.device, time, writer.take()};
}

}  // namespace bodkin::link
