// bodkin serve: a whole session without clients, and refusals before a device opens.
#include "link/server.h"
#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
using ServeCommand = PatientCommand;

TEST_F(ServeCommand, records_a_session_with_an_ultrasound_that_nobody_looks_at) {
  const Outcome served = bodkin(
      "--json serve patient simulated --settings depth_mm=10 --port 0 --max-time 3 --ultrasound C5-2 -o s.bodkin");
  ASSERT_EQ(served.exit_code, 0) << served.text();
  const auto json = nlohmann::json::parse(served.output);
  EXPECT_EQ(json.at("clients"), 0);
  EXPECT_EQ(json.at("clients_dropped"), 0);
  EXPECT_THAT(served.errors, HasSubstr("OpenIGTLink at 127.0.0.1, port "));
  EXPECT_TRUE(::bodkin::session::read_session(folder_ / "s.bodkin").finished);
}

TEST_F(ServeCommand, refuses_an_address_that_is_none_before_it_records_anything) {
  const Outcome served = bodkin("serve patient simulated --listen nowhere -o never.bodkin");
  EXPECT_EQ(served.exit_code, 2);
  EXPECT_THAT(served.errors, HasSubstr("'nowhere' is not an address"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "never.bodkin"));
}

TEST_F(ServeCommand, refuses_a_port_that_another_program_has_before_it_records_anything) {
  ::bodkin::link::ServerSettings any;
  any.port = 0;
  const ::bodkin::link::Server first(any);
  const Outcome served =
      bodkin("serve patient simulated --port " + std::to_string(first.port()) + " -o never.bodkin");
  EXPECT_EQ(served.exit_code, 2);
  EXPECT_THAT(served.errors, HasSubstr("port " + std::to_string(first.port()) + " of 127.0.0.1 is in use"));
  EXPECT_EQ(lines_of(served.errors), 1) << served.errors;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "never.bodkin"));
}

}  // namespace
}  // namespace bodkin_test
