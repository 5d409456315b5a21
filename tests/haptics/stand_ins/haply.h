#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "tests/haptics/stand_ins/board.h"

namespace stand_in {

// What else a service may do, one at a time and from the next answer on.
enum class Oddity : int {
  none,
  more_fields,     // that nobody has heard of
  fewer_fields,    // a position alone
  fragments,       // every answer in two frames
  ping,            // before every answer
  two_at_once,     // every answer twice, in one segment
  no_position,     // the device is listed without one
  half_a_frame,    // and then nothing more
  cut_in_a_frame,  // the connection ends in an answer
  hang_up,         // instead of an answer
  no_json,         // an answer that ends in the middle
  huge_number,     // 1e999
  too_long,        // an answer of 100 000 bytes
  no_answer,
  grip_asleep,
  grip_gone
};

// Haply's Inverse service on a port of its own of the loopback interface: one Inverse3, a grip, one answer for every
// message. It counts a violation for what the vendor forbids or does not define: a first message without a profile, a
// profile afterwards, a device that does not exist, bytes that are no JSON, a force that is no number. A session that
// says nothing for 50 ms goes idle.
class HaplyService {
 public:
  struct Ways {
    std::string version = "3.5.1";
    std::string project = "haply-inverse-service";
    bool older_paths = false;       // HTTP below /3.0/ alone
    std::string vector = "vector";  // the key of a force that is obeyed; another is ignored
    std::string basis = "XYZ";
    bool transform = false;  // another program's
    bool grip = true;
  };

  // `board`: outlives the service.
  explicit HaplyService(Board& board);
  HaplyService(Board& board, Ways ways);
  ~HaplyService();
  HaplyService(const HaplyService&) = delete;
  HaplyService& operator=(const HaplyService&) = delete;

  int port() const noexcept;
  std::atomic<Oddity>& oddity() noexcept;
  // Of the program that has introduced itself last.
  std::string profile() const;

 private:
  struct Server;
  std::unique_ptr<Server> server_;
};

}  // namespace stand_in
