// A player and the one thread that ever touches it.
#pragma once

#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "host/image/image.h"
#include "host/player/player.h"
#include "host/project/project.h"

namespace shadertwin::view {

// Makes the player of a project. Called in the thread that will play.
using MakePlayer = std::function<std::unique_ptr<Player>(const Project&)>;

class PlayerThread {
 public:
  // Returns when the player is made. Throws what making it threw. `done` is called, in the thread, after
  // every job.
  PlayerThread(
      const Project& project, const MakePlayer& make_player, std::function<void()> done = [] {});
  ~PlayerThread();
  PlayerThread(const PlayerThread&) = delete;
  PlayerThread& operator=(const PlayerThread&) = delete;

  const std::string& description() const { return description_; }
  // Only when the job before is done.
  std::future<Image> ask(std::function<Image(Player&)> job);

 private:
  void work(Player& player);

  std::function<void()> done_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stop_ = false;
  std::optional<std::packaged_task<Image(Player&)>> job_;
  std::string description_;
  std::thread thread_;
};

}  // namespace shadertwin::view
