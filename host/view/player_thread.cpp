#include "host/view/player_thread.h"

#include <exception>
#include <utility>

namespace shadertwin::view {

PlayerThread::PlayerThread(const Project& project, const MakePlayer& make_player, std::function<void()> done)
    : done_(std::move(done)) {
  std::promise<void> made;
  auto future = made.get_future();
  thread_ = std::thread([this, &project, &make_player, &made] {
    std::unique_ptr<Player> player;
    try {
      player = make_player(project);
      description_ = player->description();
    } catch (...) {
      made.set_exception(std::current_exception());
      return;
    }
    made.set_value();
    work(*player);
  });
  try {
    future.get();
  } catch (...) {
    thread_.join();
    throw;
  }
}

PlayerThread::~PlayerThread() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

std::future<Image> PlayerThread::ask(std::function<Image(Player&)> job) {
  std::packaged_task<Image(Player&)> task(std::move(job));
  auto future = task.get_future();
  {
    const std::lock_guard lock(mutex_);
    job_ = std::move(task);
  }
  wake_.notify_all();
  return future;
}

void PlayerThread::work(Player& player) {
  for (;;) {
    std::packaged_task<Image(Player&)> job;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return stop_ || job_.has_value(); });
      if (stop_) return;
      job = std::move(*job_);
      job_.reset();
    }
    job(player);
    done_();
  }
}

}  // namespace shadertwin::view
