#pragma once

#include <map>
#include <optional>
#include <string>

#include "link/message.h"

namespace bodkin::link {

// What a client asks for: <Command Name="Freeze" ... />, as PLUS writes it, in a STRING of a device CMD_1 or in a
// COMMAND.
struct Command {
  std::string name;
  std::map<std::string, std::string> values;  // the other attributes, and those of Parameter elements
  std::string id;                             // that the answer repeats: "1" of CMD_1; a number of COMMAND
  bool is_command_message = false;            // COMMAND, not STRING

  // Throws InputError when the value is absent or not a finite number.
  double number(const std::string& value) const;
};

// The command of a message; nothing when the message is none. Throws InputError with one sentence when it is a
// command that cannot be read; the sender is to be told.
std::optional<Command> command_of(const Message& message);

// ACK_1 or RTS_COMMAND with <CommandReply Status="SUCCESS" Message="..." />. `request`: the message that it answers,
// also one that could not be read.
Message reply_to(const Message& request, bool success, const std::string& sentence, double time);

}  // namespace bodkin::link
