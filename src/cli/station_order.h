#pragma once

#include <optional>
#include <string>

#include "link/message.h"

namespace bodkin::cli {

// What a client asked a waiting station for.
struct StartOrder {
  std::string folder;   // of the case
  std::string trainee;  // a label; empty: that of the command line
  std::string file;     // name of the session in the station's folder; empty: that of the command line
  bool begins = true;   // else the case is chosen only
};

// Reads the orders of clients. A case is one inside a folder, and a session a file in one: nothing a client says
// leads out of them.
class StationOrders {
 public:
  // `folder`: of a case, or of cases.
  explicit StationOrders(std::string folder) : folder_(std::move(folder)) {}

  // Nothing: the message is no command. Throws InputError, one sentence, when it cannot be done. A case that LoadCase
  // chooses stays for all starts that name none.
  std::optional<StartOrder> order_in(const link::Message& message);

 private:
  std::string folder_;
  std::string chosen_;  // by LoadCase; empty: none
};

}  // namespace bodkin::cli
