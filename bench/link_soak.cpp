// What the OpenIGTLink server costs and stands. Run from a release build:
//   link_soak age SECONDS            age of poses at a client: 60 Hz, and 1 kHz of force in batches
//   link_soak late PAIRS SECONDS     late ticks of a 1 kHz servo without clients and with 8, one of them hostile
//   link_soak messages COUNT         as many messages as fast as a client takes them, and the memory they cost
//   link_soak fuzz COUNT             connections of mutated messages beside a client that must notice nothing
//   link_soak kills COUNT            server or client killed (SIGKILL) at random, and what the other makes of it
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "link/client.h"
#include "link/command.h"
#include "link/contents.h"
#include "link/server.h"
#include "session/session_file.h"
#include "tests/link/mutated_stream.h"
#include "tests/session/slab_case.h"
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "core/random.h"
#include "haptics/servo_thread.h"
#include "simulation/haptic_tick.h"

namespace {

using namespace bodkin;
using namespace bodkin::link;
using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

ServerSettings free_port() {
  ServerSettings settings;
  settings.port = 0;
  return settings;
}

ClientSettings client_of(std::uint16_t port) {
  ClientSettings settings;
  settings.host = "127.0.0.1";
  settings.port = port;
  settings.retry = 5ms;
  return settings;
}

// Sends what a session sends, 60 times a second, until it is destroyed.
class SessionTraffic {
 public:
  explicit SessionTraffic(Server& server)
      : thread_([&server](const std::stop_token& stop) {
          const std::vector<double> rows(17 * 6, 1.0);
          const std::vector<std::uint8_t> picture(300 * 300, 7);
          Pose pose = Pose::Identity();
          auto next = Steady::now();
          for (int round = 0; !stop.stop_requested(); ++round) {
            pose.translation().x() = round;
            const double now = time_now();
            server.publish({"TRANSFORM", "NeedleTipToReference", now, transform_content(pose)}, true);
            server.publish({"TRANSFORM", "ProbeToReference", now, transform_content(pose)}, true);
            server.publish({"NDARRAY", "Force", now, array_content(rows, 6)}, false);
            if (round % 2 == 0)
              server.publish({"IMAGE", "Image_Reference", now, image_content(picture, 300, 300, 0.2, pose)}, true);
            next += std::chrono::microseconds(16667);
            std::this_thread::sleep_until(next);
          }
        }) {}

 private:
  std::jthread thread_;
};

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

int measure_age(double seconds) {
  Server server(free_port());
  std::mutex mutex;
  std::vector<double> ages;
  std::uint64_t rows = 0;
  const Client client(client_of(server.port()), {.message = [&](const Message& message) {
                        const double now = time_now();
                        const std::lock_guard lock(mutex);
                        if (message.type == "TRANSFORM") ages.push_back(now - message.time);
                        if (message.type == "NDARRAY") rows += 17;
                      }});
  {
    const SessionTraffic traffic(server);
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  }
  const std::lock_guard lock(mutex);
  std::printf(
      "%zu poses and %llu rows of force in %.0f s; age of a pose: median %.3f ms, 99 %% %.3f ms, most %.3f ms\n",
      ages.size(), static_cast<unsigned long long>(rows), seconds, 1e3 * percentile(ages, 0.5),
      1e3 * percentile(ages, 0.99), 1e3 * percentile(ages, 1.0));
  return 0;
}

int connect_to(std::uint16_t port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return socket;
  ::close(socket);
  return -1;
}

// Floods, stalls, sends halves and garbage in turn, and connects again whenever it is dropped.
class HostileClient {
 public:
  explicit HostileClient(std::uint16_t port)
      : thread_([port](const std::stop_token& stop) {
          const Bytes good = pack({"STRING", "CMD_1", 0.0, string_content("<Command Name='Freeze'/>")});
          Bytes garbage(4096);
          Random random(7);
          for (std::uint8_t& byte : garbage) byte = static_cast<std::uint8_t>(random.next());
          for (int turn = 0; !stop.stop_requested(); ++turn) {
            const int socket = connect_to(port);
            if (socket < 0) {
              std::this_thread::sleep_for(5ms);
              continue;
            }
            const auto send = [&](const std::uint8_t* bytes, std::size_t size) {
              return ::send(socket, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT) > 0 || errno == EAGAIN;
            };
            switch (turn % 4) {
              case 0:
                for (int i = 0; i < 20000 && !stop.stop_requested() && send(good.data(), good.size()); ++i) {
                }
                break;
              case 1:
                std::this_thread::sleep_for(300ms);  // takes nothing of what it is sent
                break;
              case 2:
                send(good.data(), good.size() / 2);
                std::this_thread::sleep_for(100ms);
                break;
              default:
                send(garbage.data(), garbage.size());
                std::this_thread::sleep_for(20ms);
            }
            ::close(socket);
          }
        }) {}

 private:
  std::jthread thread_;
};

// Share of the ticks of a 1 kHz servo with a needle in tissue that woke up more than a period late.
double late_share(double seconds, bool with_clients) {
  Server server(free_port());
  const SessionTraffic traffic(server);
  std::vector<std::unique_ptr<Client>> clients;
  std::unique_ptr<HostileClient> hostile;
  if (with_clients) {
    for (int i = 0; i < 7; ++i)
      clients.push_back(std::make_unique<Client>(client_of(server.port()), Client::Events{}));
    hostile = std::make_unique<HostileClient>(server.port());
  }
  const anatomy::Case patient = slab_case(lumbar_slabs());
  const auto tick = std::make_shared<simulation::HapticTick>(patient);
  haptics::ServoThread servo(
      {}, [](const Wrench&, haptics::DeviceState&) {},
      [tick, ticks = 0](const haptics::DeviceState&, double, double) mutable {
        const double depth = 20.0 - 25.0 * std::cos(0.0005 * ++ticks);
        return tick->step({.needle = needle_pose(Vec3(0.0, -depth, 0.0), -Vec3::UnitY())}).applied;
      });
  servo.start();
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  servo.stop();
  return static_cast<double>(servo.missed()) / static_cast<double>(std::max<std::uint64_t>(servo.rounds(), 1));
}

int measure_late(int pairs, double seconds) {
  std::vector<double> without, with;
  for (int pair = 0; pair < pairs; ++pair) {
    without.push_back(100.0 * late_share(seconds, false));
    with.push_back(100.0 * late_share(seconds, true));
    std::printf("pair %d: %.3f %% late without clients, %.3f %% with 8, one hostile\n", pair + 1, without.back(),
                with.back());
    std::fflush(stdout);
  }
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  };
  std::printf("mean %.3f %% without, %.3f %% with: %+.3f percentage points; median %.3f %% and %.3f %%\n",
              mean(without), mean(with), mean(with) - mean(without), percentile(without, 0.5), percentile(with, 0.5));
  return 0;
}

// MiB that the process holds.
double memory_held() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1048576.0;
}

int measure_messages(std::uint64_t count) {
  Server server(free_port());
  std::atomic<std::uint64_t> taken{0};
  const Client client(client_of(server.port()), {.message = [&](const Message& message) {
                        if (message.type == "NDARRAY" || message.type == "TRANSFORM") ++taken;
                      }});
  while (server.counts().clients == 0) std::this_thread::sleep_for(1ms);
  const std::vector<double> rows(17 * 6, 1.0);
  const Message pose{"TRANSFORM", "NeedleTipToReference", 0.0, transform_content(Pose::Identity())};
  const Message force{"NDARRAY", "Force", 0.0, array_content(rows, 6)};
  const auto begin = Steady::now();
  double early = 0.0;
  for (std::uint64_t sent = 0; sent < count; ++sent) {
    constexpr std::uint64_t ahead = 4000;
    while (sent > taken + ahead) std::this_thread::yield();
    server.publish(sent % 3 == 2 ? force : pose, false);
    if (sent == count / 20) early = memory_held();
    if (sent % (count / 10) == count / 10 - 1) {
      std::printf("%llu messages, %.1f MiB\n", static_cast<unsigned long long>(sent + 1), memory_held());
      std::fflush(stdout);
    }
  }
  while (taken < count && Steady::now() - begin < 3600s) std::this_thread::sleep_for(1ms);
  const double seconds = std::chrono::duration<double>(Steady::now() - begin).count();
  std::printf(
      "%llu messages in %.1f s (%.0f hours of a session at 180 a second), %llu arrived; memory %.1f MiB after "
      "a twentieth, %.1f MiB at the end\n",
      static_cast<unsigned long long>(count), seconds, static_cast<double>(count) / 180.0 / 3600.0,
      static_cast<unsigned long long>(taken.load()), early, memory_held());
  return taken == count ? 0 : 1;
}

int measure_fuzz(int count) {
  ServerSettings settings = free_port();
  settings.patience = 200ms;
  Server server(settings);
  std::atomic<std::uint64_t> heard{0};
  const Client good(client_of(server.port()), {.message = [&](const Message&) { ++heard; }});
  while (server.counts().clients == 0) std::this_thread::sleep_for(1ms);
  Random random(static_cast<std::uint64_t>(count));
  std::uint64_t bytes = 0;
  const double before = memory_held();
  for (int i = 0; i < count; ++i) {
    const int socket = connect_to(server.port());
    if (socket < 0) return 1;
    const Bytes stream = mutated_stream(random);
    bytes += stream.size();
    (void)!::send(socket, stream.data(), stream.size(), MSG_NOSIGNAL);
    ::close(socket);
    for (const Received& received : server.take()) {
      try {
        if (const auto command = command_of(received.message))
          server.send(received.client, reply_to(received.message, true, command->name, 0.0));
      } catch (const InputError& error) {
        server.send(received.client, reply_to(received.message, false, error.what(), 0.0));
      }
    }
    server.take_notes();
    server.publish({"STRING", "Event", 0.0, string_content("x")}, false);
  }
  const auto end = Steady::now() + 30s;
  while (heard < static_cast<std::uint64_t>(count) && Steady::now() < end) std::this_thread::sleep_for(1ms);
  const ServerCounts counts = server.counts();
  std::printf(
      "%d hostile connections, %llu bytes: %llu let in, %llu dropped by the server, the good client heard %llu "
      "messages in %llu connection, memory %.1f MiB before and %.1f MiB after\n",
      count, static_cast<unsigned long long>(bytes), static_cast<unsigned long long>(counts.accepted),
      static_cast<unsigned long long>(counts.dropped), static_cast<unsigned long long>(heard.load()),
      static_cast<unsigned long long>(good.status().connections), before, memory_held());
  return good.status().connections == 1 ? 0 : 1;
}

// What the two processes of `kills` tell the one that kills them; in a file that all have mapped.
struct KillBoard {
  std::atomic<std::uint64_t> saved;    // ticks that the server has committed and announced
  std::atomic<std::uint64_t> clients;  // that the present server has let in
  std::atomic<std::uint64_t> heard;    // messages that the present client has had
  std::atomic<std::uint64_t> up;       // servers that listen
};

KillBoard& board_in(const std::string& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT, 0600);
  if (descriptor < 0 || ::ftruncate(descriptor, sizeof(KillBoard)) != 0) std::abort();
  void* const memory = ::mmap(nullptr, sizeof(KillBoard), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  ::close(descriptor);
  if (memory == MAP_FAILED) std::abort();
  return *static_cast<KillBoard*>(memory);
}

// Records ticks and sends them until it is killed.
int serve_until_killed(std::uint16_t port, const std::string& folder) {
  KillBoard& board = board_in(folder + "/board");
  ServerSettings settings;
  settings.port = port;
  Server server(settings);
  session::SessionHeader header;
  header.path = {Vec3(0.0, 0.0, 0.0), Vec3(0.0, -40.0, 0.0)};
  session::SessionWriter writer(folder + "/session.bodkin", header, true);
  board.saved = 0;
  ++board.up;
  for (std::uint64_t tick = 0;; ++tick) {
    simulation::TickRecord record;
    record.tick = tick;
    record.input.needle = needle_pose(Vec3(0.0, -0.01 * static_cast<double>(tick), 0.0), -Vec3::UnitY());
    writer.append(record);
    if (tick % 20 == 19) {
      writer.commit();
      board.saved = tick + 1;
      server.publish({"STRING", "Event", time_now(), string_content(std::to_string(tick + 1))}, false);
      board.clients = server.counts().accepted;
      std::this_thread::sleep_for(1ms);
    }
  }
}

int listen_until_killed(std::uint16_t port, const std::string& folder) {
  KillBoard& board = board_in(folder + "/board");
  const Client client(client_of(port), {.message = [&](const Message& message) {
                        if (message.type == "STRING") ++board.heard;
                      }});
  while (true) std::this_thread::sleep_for(1s);
}

pid_t spawn_self(const char* what, std::uint16_t port, const std::string& folder) {
  std::string number = std::to_string(port), program = "link_soak", mode = what, place = folder;
  char* const words[] = {program.data(), mode.data(), number.data(), place.data(), nullptr};
  pid_t process = 0;
  if (::posix_spawn(&process, "/proc/self/exe", nullptr, nullptr, words, environ) != 0) std::abort();
  return process;
}

void kill_process(pid_t process) {
  ::kill(process, SIGKILL);
  ::waitpid(process, nullptr, 0);
}

// Until the server has saved more, and the client heard more, than now.
bool both_go_on(const KillBoard& board) {
  const auto end = Steady::now() + 30s;
  const std::uint64_t heard = board.heard;
  while (Steady::now() < end) {
    if (board.heard > heard + 2 && board.clients > 0) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

int measure_kills(int count) {
  const std::string folder =
      (std::filesystem::temp_directory_path() / ("link_soak_" + std::to_string(::getpid()))).string();
  std::filesystem::create_directories(folder);
  KillBoard& board = board_in(folder + "/board");
  std::uint16_t port = 0;
  { port = Server(free_port()).port(); }
  pid_t server = spawn_self("server", port, folder), client = spawn_self("client", port, folder);
  Random random(20);
  int servers = 0, clients = 0, lost = 0, stuck = both_go_on(board) ? 0 : 1;
  std::uint64_t checked = 0;
  for (int i = 0; i < count && stuck == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(random.next() % 20));
    if (random.next() % 2 == 0) {
      ++clients;
      kill_process(client);
      client = spawn_self("client", port, folder);
    } else {
      ++servers;
      kill_process(server);
      const std::uint64_t saved = board.saved;
      const session::Session session = session::read_session(folder + "/session.bodkin");
      checked += session.ticks.size();
      if (session.ticks.size() < saved) ++lost;
      server = spawn_self("server", port, folder);
    }
    if (!both_go_on(board)) ++stuck;
  }
  kill_process(server);
  kill_process(client);
  std::filesystem::remove_all(folder);
  std::printf(
      "%d servers and %d clients killed: %d times the other did not recover; %llu recorded ticks read again, "
      "%d recordings lacked one that had been saved\n",
      servers, clients, stuck, static_cast<unsigned long long>(checked), lost);
  return stuck + lost == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string mode = argc > 1 ? argv[1] : "";
  const auto number = [&](int at, double otherwise) {
    return argc > at ? std::strtod(argv[at], nullptr) : otherwise;
  };
  if (mode == "server") return serve_until_killed(static_cast<std::uint16_t>(number(2, 0.0)), argv[3]);
  if (mode == "client") return listen_until_killed(static_cast<std::uint16_t>(number(2, 0.0)), argv[3]);
  if (mode == "age") return measure_age(number(2, 30.0));
  if (mode == "late") return measure_late(static_cast<int>(number(2, 10.0)), number(3, 5.0));
  if (mode == "messages") return measure_messages(static_cast<std::uint64_t>(number(2, 15'552'000.0)));
  if (mode == "fuzz") return measure_fuzz(static_cast<int>(number(2, 100000.0)));
  if (mode == "kills") return measure_kills(static_cast<int>(number(2, 1000.0)));
  std::fprintf(stderr, "link_soak age SECONDS | late PAIRS SECONDS | messages COUNT | fuzz COUNT | kills COUNT\n");
  return 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "link_soak: %s\n", error.what());
  return 1;
}
