// What a microphone hears now.
#pragma once

#include <memory>
#include <span>
#include <string>

namespace shadertwin::media {

class Microphone {
 public:
  // The system's default one, at `rate` samples a second in one channel. Null, and `why`, if there is none.
  static std::unique_ptr<Microphone> open(int rate, std::string& why);
  ~Microphone();

  // The last newest.size() samples that it heard, oldest first; silence before the first. Does not wait.
  void listen(std::span<float> newest);

 private:
  struct State;
  explicit Microphone(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace shadertwin::media
