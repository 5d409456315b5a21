#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/cli/serve_process.h"

#include "core/random.h"

namespace bodkin_test {

// Findings during the kills of servers and clients. The faults are 0 if all is well.
struct KillCounts {
  int servers = 0, clients = 0;     // that were killed
  int while_starting = 0;           // of these servers
  int frozen = 0;                   // of these clients: before, for a while
  std::uint64_t rows_compared = 0;  // ticks that a client had been told of, and that the recording has
  std::uint64_t ticks_read = 0;     // in the recordings of killed servers
  double longest_loss = 0.0;        // s missing at the end of a recording that a client had received
  int stuck = 0;                    // faults: the other side did not go on within half a minute
  int unreadable = 0;               // the recording of a killed server cannot be read
  int holes = 0;                    // recordings in which a tick before the last is missing
  int claimed_whole = 0;            // recordings that say that the session ended on purpose
  int different = 0;                // recordings with another depth than the client was told
  int longer_than_a_second = 0;     // recordings that lack more than the session format allows
  int begun_again = 0;              // clients that came back and were not told how it went on

  int faults() const {
    return stuck + unreadable + holes + claimed_whole + different + longer_than_a_second + begun_again;
  }
  void add(const KillCounts& other);
  // Two lines for people.
  std::string text() const;
};

// `bodkin serve` and a client of the kind that the window has (link::Client), each a process of its own that is
// killed (SIGKILL) at random moments and started again. After each kill: does the other one go on by itself, and is
// all there that had been saved?
//
// A client is a copy of this process, which must not have other threads when it makes one.
class KilledPair {
 public:
  // `patient`: a case for a simulated hand. Files go into `folder`, which must exist.
  KilledPair(std::filesystem::path folder, std::filesystem::path patient, std::uint64_t seed);
  ~KilledPair();
  KilledPair(const KilledPair&) = delete;
  KilledPair& operator=(const KilledPair&) = delete;

  // After a random time; returns when both continue, or have not for half a minute. Occasionally a server is killed
  // again during its start.
  void kill_one();
  const KillCounts& counts() const noexcept { return counts_; }

 private:
  // A tick as sent by the server.
  struct Row {
    double time = 0.0, depth = 0.0;  // s, mm
  };
  // Data written by a client and read by this process, in shared memory.
  struct Board {
    std::atomic<bool> is_connected;
    std::atomic<std::uint64_t> batches;  // of ticks, heard by any client so far
    std::atomic<std::uint64_t> rows;     // that the present connection has brought
    std::array<Row, 60000> row;          // the first of them: a minute
  };

  void start_server();
  void start_client();
  void replace_server();
  void kill_server();
  void kill_client();
  std::vector<Row> heard() const;
  void check_recording(const std::vector<Row>& heard);
  bool both_go_on() const;
  [[noreturn]] void listen_until_killed() const;

  std::filesystem::path folder_, patient_;
  bodkin::Random random_;
  std::uint16_t port_ = 0;
  Board* board_ = nullptr;
  std::unique_ptr<ServeProcess> server_;
  pid_t client_ = 0;
  KillCounts counts_;
};

}  // namespace bodkin_test
