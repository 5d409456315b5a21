#include "tests/cli/killed_pair.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>
#include <utility>

#include "link/client.h"
#include "link/contents.h"
#include "link/server.h"
#include "session/session_file.h"
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"

namespace bodkin_test {

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

constexpr const char* recording = "session.bodkin";

template <typename Reached>
bool comes_about(std::chrono::milliseconds most, const Reached& reached) {
  for (const auto end = Steady::now() + most; Steady::now() < end; std::this_thread::sleep_for(1ms)) {
    if (reached()) return true;
  }
  return reached();
}

// A free port, below those that the system assigns to clients, so that it stays free between two servers.
std::uint16_t free_port() {
  bodkin::Random random(static_cast<std::uint64_t>(::getpid()));
  constexpr std::uint64_t lowest = 20000, count = 12000;
  while (true) {
    bodkin::link::ServerSettings settings;
    settings.port = static_cast<std::uint16_t>(lowest + random.next() % count);
    try {
      return bodkin::link::Server(settings).port();
    } catch (const bodkin::InputError&) {
      continue;
    }
  }
}

}  // namespace

void KillCounts::add(const KillCounts& other) {
  servers += other.servers;
  clients += other.clients;
  while_starting += other.while_starting;
  frozen += other.frozen;
  rows_compared += other.rows_compared;
  ticks_read += other.ticks_read;
  longest_loss = std::max(longest_loss, other.longest_loss);
  stuck += other.stuck;
  unreadable += other.unreadable;
  holes += other.holes;
  claimed_whole += other.claimed_whole;
  different += other.different;
  longer_than_a_second += other.longer_than_a_second;
  begun_again += other.begun_again;
}

std::string KillCounts::text() const {
  return fmt::format(
      "{} servers ({} of them while they started) and {} clients ({} of them frozen before) killed: {} times the "
      "other one did not go on, {} "
      "clients came back and heard the beginning again\n"
      "{} ticks in the recordings of killed servers, {} of them compared with what a client had heard: {} recordings "
      "cannot be read, {} have holes, {} claim to be whole, {} differ; the end that is missing is at most {:.3f} s "
      "long, {} times longer than 1 s\n",
      servers, while_starting, clients, frozen, stuck, begun_again, ticks_read, rows_compared, unreadable, holes,
      claimed_whole, different, longest_loss, longer_than_a_second);
}

KilledPair::KilledPair(fs::path folder, fs::path patient, std::uint64_t seed)
    : folder_(std::move(folder)), patient_(std::move(patient)), random_(seed), port_(free_port()) {
  void* const memory = ::mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw bodkin::SystemError("there is no memory for two processes");
  board_ = new (memory) Board{};
  start_server();
  start_client();
  if (!both_go_on()) ++counts_.stuck;
}

KilledPair::~KilledPair() {
  ::kill(client_, SIGKILL);
  ::waitpid(client_, nullptr, 0);
  server_.reset();
  ::munmap(board_, sizeof(Board));
}

void KilledPair::start_server() {
  server_ = std::make_unique<ServeProcess>(
      folder_,
      fmt::format("serve '{}' simulated --settings 'speed_mm_s=10 start_mm=2 depth_mm=40 wait_s=600' --port {} -o {}",
                  patient_.string(), port_, recording));
}

void KilledPair::start_client() {
  board_->is_connected = false;
  board_->rows = 0;
  const pid_t parent = ::getpid();
  client_ = ::fork();
  if (client_ != 0) return;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it ended before the line above
  listen_until_killed();
}

void KilledPair::listen_until_killed() const {
  Board& board = *board_;
  bodkin::link::ClientSettings settings;
  settings.host = "127.0.0.1";
  settings.port = port_;
  settings.retry = 20ms;
  const bodkin::link::Client client(
      settings, {.message =
                     [&board](const bodkin::link::Message& message) {
                       if (message.type != "NDARRAY" || message.device != "Force") return;
                       const bodkin::link::NumberArray rows = bodkin::link::read_array(message.content);
                       const std::size_t columns = rows.size.at(1);
                       std::uint64_t count = board.rows;
                       for (std::size_t at = 0; at < rows.values.size() && count < board.row.size(); at += columns)
                         board.row[count++] = {rows.values[at], rows.values[at + 1]};
                       board.rows = count;
                       ++board.batches;
                     },
                 .connected = [&board](bodkin::link::Client&) { board.rows = 0; }});
  while (true) {
    board.is_connected = client.status().state == bodkin::link::ClientState::connected;
    std::this_thread::sleep_for(1ms);
  }
}

// Waits until the client has received more than now.
bool KilledPair::both_go_on() const {
  const std::uint64_t before = board_->batches;
  return comes_about(30s, [&] { return board_->is_connected && board_->rows > 0 && board_->batches > before + 2; });
}

std::vector<KilledPair::Row> KilledPair::heard() const {
  return {board_->row.begin(), board_->row.begin() + static_cast<std::ptrdiff_t>(board_->rows.load())};
}

void KilledPair::kill_one() {
  constexpr std::uint64_t longest = 600;  // ms: more than passes between two commits of the recorder
  std::this_thread::sleep_for(std::chrono::milliseconds(random_.next() % longest));
  if (random_.next() % 2 == 0)
    kill_client();
  else
    kill_server();
  if (!both_go_on()) ++counts_.stuck;
}

void KilledPair::kill_client() {
  ++counts_.clients;
  if (random_.next() % 2 == 0) {
    constexpr std::uint64_t longest_freeze = 200;  // ms
    ++counts_.frozen;
    ::kill(client_, SIGSTOP);
    std::this_thread::sleep_for(std::chrono::milliseconds(random_.next() % longest_freeze));
  }
  ::kill(client_, SIGKILL);
  ::waitpid(client_, nullptr, 0);
  const std::vector<Row> before = heard();
  start_client();
  if (!comes_about(30s, [&] { return board_->rows > 0; })) return;  // both_go_on() counts it
  if (!before.empty() && heard().front().time <= before.back().time) ++counts_.begun_again;
}

// Kills the server, checks what it recorded, and starts another one.
void KilledPair::replace_server() {
  ++counts_.servers;
  server_->kill();
  // By then, data in transit to the client have arrived.
  comes_about(10s, [&] { return !board_->is_connected; });
  check_recording(heard());
  board_->rows = 0;
  start_server();
}

void KilledPair::kill_server() {
  replace_server();
  if (random_.next() % 4 != 0) return;
  constexpr std::uint64_t start_up = 200;  // ms
  std::this_thread::sleep_for(std::chrono::milliseconds(random_.next() % start_up));
  ++counts_.while_starting;
  replace_server();
}

void KilledPair::check_recording(const std::vector<Row>& heard) {
  const fs::path file = folder_ / recording;
  try {
    const bodkin::session::Session session = bodkin::session::read_session(file);
    const auto& ticks = session.ticks;
    counts_.ticks_read += ticks.size();
    bool has_holes = false, differs = false;
    for (std::size_t i = 0; i < ticks.size(); ++i) has_holes = has_holes || ticks[i].tick != i;
    counts_.claimed_whole += session.finished ? 1 : 0;
    for (const Row& row : heard) {
      const auto tick = static_cast<std::size_t>(std::llround(row.time / session.header.dt));
      if (tick >= ticks.size()) break;
      ++counts_.rows_compared;
      differs = differs || ticks[tick].output.depth != row.depth;
    }
    counts_.holes += has_holes ? 1 : 0;
    counts_.different += differs ? 1 : 0;
    if (!heard.empty()) {
      const double lost = heard.back().time - (static_cast<double>(ticks.size()) - 1.0) * session.header.dt;
      counts_.longest_loss = std::max(counts_.longest_loss, lost);
      counts_.longer_than_a_second += lost > 1.0 ? 1 : 0;
    }
  } catch (const bodkin::InputError&) {
    if (!heard.empty()) ++counts_.unreadable;  // otherwise it was killed before the session began
  }
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) fs::remove(file.string() + ending);
}

}  // namespace bodkin_test
