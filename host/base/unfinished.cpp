#include "host/base/unfinished.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>
#include <utility>

namespace shadertwin {

namespace {

// A signal handler may neither lock nor allocate: names stand in memory that is always there. A slot is taken
// while its name is being written, and named when the handler may read it.
enum class State { empty, taken, named };
struct Slot {
  std::atomic<State> state = State::empty;
  std::array<char, PATH_MAX> name;
};
static_assert(std::atomic<State>::is_always_lock_free);
std::array<Slot, 256> slots;

extern "C" void remove_unfinished(int signal) {
  const auto for_each_name = [](int (*remove)(const char*)) {
    for (const Slot& slot : slots)
      if (slot.state.load(std::memory_order_acquire) == State::named) remove(slot.name.data());
  };
  for_each_name(unlink);
  for_each_name(rmdir);  // the folders are empty now
  std::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

Unfinished::Unfinished(const std::filesystem::path& path) {
  // Absolute, so that it stays right in another working folder.
  std::error_code failed;
  const std::string name = std::filesystem::absolute(path, failed).string();
  if (failed || name.size() >= PATH_MAX) return;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    State expected = State::empty;
    if (!slots[i].state.compare_exchange_strong(expected, State::taken)) continue;
    std::memcpy(slots[i].name.data(), name.c_str(), name.size() + 1);
    slots[i].state.store(State::named, std::memory_order_release);
    slot_ = static_cast<int>(i);
    return;
  }
}

Unfinished::~Unfinished() {
  if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].state.store(State::empty, std::memory_order_release);
}

Unfinished::Unfinished(Unfinished&& other) noexcept : slot_(std::exchange(other.slot_, -1)) {}

Unfinished& Unfinished::operator=(Unfinished&& other) noexcept {
  std::swap(slot_, other.slot_);
  return *this;
}

void remove_unfinished_when_interrupted() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action = {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action.sa_handler = remove_unfinished;
    sigfillset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace shadertwin
