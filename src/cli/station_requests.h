#pragma once

#include <optional>
#include <string>

#include "link/message.h"

namespace bodkin::cli {

// A client's request to a waiting station.
struct StartRequest {
  std::string folder;   // of the case
  std::string trainee;  // a label; empty: from the command line
  std::string file;     // name of the session in the station's folder; empty: from the command line
  bool begins = true;   // false: only choose the case
};

// Reads the requests of clients. Cases and session files must be inside a folder; no request can lead outside.
class StationRequests {
 public:
  // `folder`: of a case, or of cases.
  explicit StationRequests(std::string folder) : folder_(std::move(folder)) {}

  // Empty: the message is no command. Throws InputError, one sentence, if it cannot be executed. A case chosen by
  // LoadCase remains in use for all starts that name none.
  std::optional<StartRequest> read_request(const link::Message& message);

 private:
  std::string folder_;
  std::string chosen_;  // by LoadCase; empty: none
};

}  // namespace bodkin::cli
