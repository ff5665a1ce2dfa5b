// The system's loudspeaker.
#pragma once

#include <memory>
#include <span>
#include <string>

namespace shadertwin::media {

class Loudspeaker {
 public:
  // The default device, for stereo floats at `rate` samples a second. Null if there is none: `why` says so in
  // words.
  static std::unique_ptr<Loudspeaker> open(int rate, std::string& why);
  ~Loudspeaker();

  // Hands over samples, left and right in turn, to be heard after those before; waits while the device holds
  // all that it can. What it holds it plays by itself. False if it had run dry since the last call, or takes
  // nothing any more: where the sound is heard is then open.
  bool play(std::span<const float> stereo);
  // Falls silent at once: what was not heard yet will not be.
  void stop();

 private:
  struct State;

  explicit Loudspeaker(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace shadertwin::media
