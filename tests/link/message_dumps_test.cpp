// Messages that Debian's OpenIGTLink library does not speak (COMMAND, RTS_COMMAND, header version 2), against dumps
// that were written down from the protocol's description. Their check sums are from a program of its own, bit by bit.
#include <sstream>
#include <string>

#include "link/command.h"
#include "link/contents.h"
#include "link/message.h"
#include <gtest/gtest.h>

namespace bodkin::link {
namespace {

constexpr double dump_time = 1700000000.5;  // s: 6553F100, and half of 2^32

// "00 2A": two bytes; "x125": so many zeros.
Bytes bytes_of(const std::string& dump) {
  Bytes bytes;
  std::istringstream words(dump);
  for (std::string word; words >> word;) {
    if (word.front() == 'x')
      bytes.insert(bytes.end(), std::stoul(word.substr(1)), 0);
    else
      bytes.push_back(static_cast<std::uint8_t>(std::stoul(word, nullptr, 16)));
  }
  return bytes;
}

// Number 258, the name "Arm", US-ASCII, 21 bytes: <Command Name="Arm"/>
const std::string command_content =
    "00 00 01 02  41 72 6D x125  00 03  00 00 00 15 "
    "3C 43 6F 6D 6D 61 6E 64 20 4E 61 6D 65 3D 22 41 72 6D 22 2F 3E ";
const std::string of_slicer_then = "53 6C 69 63 65 72 x14  65 53 F1 00 80 00 00 00 ";

Message message_in(const Bytes& bytes) {
  return unpack(read_header(std::span(bytes).first(header_size)), std::span(bytes).subspan(header_size));
}

void expect_command(const Message& message) {
  EXPECT_EQ(message.type, "COMMAND");
  EXPECT_EQ(message.device, "Slicer");
  EXPECT_EQ(message.time, dump_time);
  EXPECT_EQ(message.content, bytes_of(command_content));
  const std::optional<Command> command = command_of(message);
  ASSERT_TRUE(command);
  EXPECT_EQ(command->name, "Arm");
  EXPECT_EQ(command->id, "258");
  EXPECT_TRUE(command->values.empty());
}

TEST(MessageDump, of_a_command_is_read_and_written) {
  const Bytes dump = bytes_of("00 01  43 4F 4D 4D 41 4E 44 x5 " + of_slicer_then +
                              "00 00 00 00 00 00 00 9F  2C FA 78 94 59 82 52 7E " + command_content);
  expect_command(message_in(dump));
  EXPECT_EQ(pack({"COMMAND", "Slicer", dump_time, bytes_of(command_content)}), dump);
}

// Before the content: 12 bytes of extended header, 10 of the metadata's header, 8 of metadata, message number 77.
// Behind it: one pair, a key of 6 bytes, US-ASCII, a value of 2: Status OK.
TEST(MessageDump, of_a_command_with_header_version_two_and_metadata_is_read) {
  expect_command(message_in(bytes_of("00 02  43 4F 4D 4D 41 4E 44 x5 " + of_slicer_then +
                                     "00 00 00 00 00 00 00 BD  0D C0 47 EC C4 18 18 E0 "
                                     "00 0C 00 0A 00 00 00 08 00 00 00 4D " +
                                     command_content + "00 01  00 06 00 03 00 00 00 02  53 74 61 74 75 73 4F 4B")));
}

// <CommandReply Status="SUCCESS" Message="armed"/>
TEST(MessageDump, of_the_answer_to_a_command_is_written) {
  const Message request{"COMMAND", "Slicer", 0.0, bytes_of(command_content)};
  EXPECT_EQ(pack(reply_to(request, true, "armed", dump_time)),
            bytes_of("00 01  52 54 53 5F 43 4F 4D 4D 41 4E 44 00 " + of_slicer_then +
                     "00 00 00 00 00 00 00 BA  29 88 04 66 E9 1E DD B8 "
                     "00 00 01 02  41 72 6D x125  00 03  00 00 00 30 "
                     "3C 43 6F 6D 6D 61 6E 64 52 65 70 6C 79 20 53 74 61 74 75 73 3D 22 53 55 43 43 45 53 53 22 20 "
                     "4D 65 73 73 61 67 65 3D 22 61 72 6D 65 64 22 2F 3E"));
}

}  // namespace
}  // namespace bodkin::link
