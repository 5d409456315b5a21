#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "tests/haptics/mocks/board.h"

namespace mock {

// Other possible behaviour of a service, one at a time and from the next answer on.
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
  grip_gone,
  new_transform,  // another program's, while the session runs
  new_basis,      // the same, by HTTP
  new_preset,
  new_mount
};

// Haply's Inverse service on a port of its own of the loopback interface: one Inverse3, a grip, one answer for every
// message. It counts a violation for everything that the vendor forbids or does not define: a first message without a
// profile, a profile afterwards, an unknown device, invalid JSON, a non-numeric force. A session silent for 50 ms
// goes idle.
class HaplyService {
 public:
  struct Behaviour {
    std::string version = "3.5.1";
    std::string project = "haply-inverse-service";
    bool older_paths = false;       // HTTP below /3.0/ alone
    std::string vector = "vector";  // the key of a force that is obeyed; another is ignored
    std::string basis = "XYZ";
    bool transform = false;  // another program's
    bool grip = true;
    bool apart = false;               // WebSocket on a port of its own, where HTTP is refused, and the reverse
    bool older_names = false;         // `mode`, and a wired grip with one `button`
    bool full_on_request = true;      // session.force_render_full_state is known
    std::string preset = "defaults";  // "" = none is told
    double mount_height = 0.0;        // m; NaN = no mount is told
    std::string remembered_basis;     // what Haply Hub sets as soon as the profile's name has come
    bool events = false;
  };

  // The service as described by the vendor's pages for a version from "3.0" to "3.5".
  static Behaviour of(const std::string& version);

  // `board`: outlives the service.
  explicit HaplyService(Board& board);
  HaplyService(Board& board, Behaviour behaviour);
  ~HaplyService();
  HaplyService(const HaplyService&) = delete;
  HaplyService& operator=(const HaplyService&) = delete;

  int port() const noexcept;            // of HTTP, and of the WebSocket unless they are apart
  int websocket_port() const noexcept;  // of the WebSocket
  int events_port() const noexcept;     // 0 = no event channel
  // Sends a text to all listeners to the events, once there is one.
  void send_event(const std::string& event);
  std::atomic<Oddity>& oddity() noexcept;
  // Of the program that introduced itself last.
  std::string profile() const;

 private:
  struct Server;
  std::unique_ptr<Server> server_;
};

}  // namespace mock
