#pragma once

#include <map>
#include <optional>
#include <string>

#include "link/message.h"

namespace bodkin::link {

// A client's request: <Command Name="Freeze" ... />, in the format of PLUS, in a STRING of a device CMD_1 or in a
// COMMAND.
struct Command {
  std::string name;
  std::map<std::string, std::string> values;  // the other attributes, and those of Parameter elements
  std::string id;                             // repeated in the reply: "1" of CMD_1; a number of COMMAND
  bool is_command_message = false;            // COMMAND, not STRING

  // Throws InputError when the value is absent or not a finite number.
  double number(const std::string& value) const;
};

// The command in a message; empty if there is none. Throws InputError with one sentence, to be sent to the client,
// for an unreadable command.
std::optional<Command> command_of(const Message& message);

// ACK_1 or RTS_COMMAND with <CommandReply Status="SUCCESS" Message="..." />. `request`: the message to which it
// replies, possibly an unreadable one.
Message reply_to(const Message& request, bool success, const std::string& sentence, double time);

}  // namespace bodkin::link
