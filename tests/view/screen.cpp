#include "tests/view/screen.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace shadertwin {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto patience = std::chrono::seconds(60);
constexpr auto pause = std::chrono::milliseconds(20);

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> found;
  for (std::string word; stream >> word;) found.push_back(word);
  return found;
}

// Starts a program with its output in files. Returns its process id.
pid_t start(std::vector<std::string> arguments, const std::filesystem::path& folder, const std::string& out,
            const std::string& err, const std::vector<std::string>& environment) {
  const pid_t pid = fork();
  if (pid != 0) return pid;
  for (const std::string& entry : environment) putenv(const_cast<char*>(entry.c_str()));
  const auto redirect = [](const std::string& file, int descriptor) {
    const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(opened, descriptor);
  };
  redirect(out, STDOUT_FILENO);
  redirect(err, STDERR_FILENO);
  if (chdir(folder.c_str()) != 0) _exit(126);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  execvp(pointers[0], pointers.data());
  _exit(127);
}

}  // namespace

bool eventually(const std::function<bool()>& done) {
  const auto end = Clock::now() + patience;
  while (!done()) {
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(pause);
  }
  return true;
}

Screen::Screen() {
  // The server picks a free number and writes it to a file.
  const std::string number = (folder_ / "number").string();
  server_ = start({"sh", "-c",
                   "exec Xvfb -displayfd 3 -screen 0 1280x1024x24 -noreset -nolisten tcp -fbdir " +
                       folder_.path().string() + " 3>" + number},
                  folder_.path(), (folder_ / "out").string(), (folder_ / "err").string(), {});
  if (eventually([&] { return contents(number).ends_with('\n') || kill(server_, 0) != 0; })) {
    const std::string text = contents(number);
    if (!text.empty()) name_ = ":" + text.substr(0, text.size() - 1);
  }
}

Screen::~Screen() {
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

glm::ivec3 Screen::pixel(int x, int y) const {
  // An X window dump: big-endian words; the header's size is word 0, bytes a line word 12, colours word 19,
  // each of 12 bytes; then pixels of 4 bytes, blue first.
  const std::string dump = contents(folder_ / "Xvfb_screen0");
  const auto word = [&](std::size_t i) {
    std::size_t value = 0;
    for (std::size_t b = 0; b < 4; ++b) value = value << 8 | static_cast<unsigned char>(dump.at(4 * i + b));
    return value;
  };
  const std::size_t at =
      word(0) + 12 * word(19) + static_cast<std::size_t>(y) * word(12) + static_cast<std::size_t>(x) * 4;
  const auto byte = [&](std::size_t i) {
    return static_cast<int>(static_cast<unsigned char>(dump.at(at + i)));
  };
  return {byte(2), byte(1), byte(0)};
}

std::string Screen::hand(const std::string& arguments) const {
  std::string text;
  FILE* pipe = popen(("DISPLAY=" + name_ + " xdotool " + arguments + " 2>&1").c_str(), "r");
  char buffer[256];
  while (fgets(buffer, sizeof buffer, pipe) != nullptr) text += buffer;
  pclose(pipe);
  return text;
}

RunningView::RunningView(const Screen& screen, const ScratchFolder& folder, const std::string& arguments,
                         const std::vector<std::string>& environment)
    : screen_(screen), folder_(folder) {
  std::vector<std::string> all = {SHADERTWIN_BINARY, "view"};
  for (const std::string& word : words(arguments)) all.push_back(word);
  std::vector<std::string> variables = {"DISPLAY=" + screen.name()};
  variables.insert(variables.end(), environment.begin(), environment.end());
  pid_ = start(all, folder.path(), (captured_ / "out").string(), (captured_ / "err").string(), variables);
  eventually([&] {
    if (!running()) return true;
    const auto found = words(screen_.hand("search --onlyvisible --pid " + std::to_string(pid_)));
    if (!found.empty() && found[0].find_first_not_of("0123456789") == std::string::npos) window_ = found[0];
    return !window_.empty();
  });
  if (window_.empty()) return;
  screen_.hand("windowmove " + window_ + " 0 0");
  // What a test writes before the shader is read would be no change of it.
  eventually(
      [&] { return !screen_.hand("getwindowname " + window_).ends_with(" - loading\n") || !running(); });
  // A window that is not drawn yet takes no focus, and there is no window manager that would give it later.
  eventually([&] {
    screen_.hand("windowfocus " + window_);
    return words(screen_.hand("getwindowfocus")) == std::vector{window_} || !running();
  });
}

RunningView::~RunningView() {
  if (!running()) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

bool RunningView::running() {
  if (pid_ < 0) return false;
  int raw = 0;
  if (waitpid(pid_, &raw, WNOHANG) == 0) return true;
  status_ = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
  pid_ = -1;
  return false;
}

std::string RunningView::err() const {
  return contents(captured_ / "err");
}

std::string RunningView::out() const {
  return contents(captured_ / "out");
}

bool RunningView::says(const std::string& text, std::size_t from) {
  return eventually([&] { return err().find(text, from) != std::string::npos || !running(); }) &&
         err().find(text, from) != std::string::npos;
}

void RunningView::key(const std::string& names) const {
  screen_.hand("key " + names);
}

RunningView::Shot RunningView::shoot() {
  const std::size_t before = err().size();
  key("F12");
  Shot shot;
  if (!says(".png and .exr: frame ", before)) throw std::runtime_error("no screenshot came: " + err());
  eventually([&] { return err().ends_with('\n'); });
  const std::string line = err().substr(before);
  const std::size_t end = line.rfind(".png and .exr");
  const std::size_t begin = line.rfind('\n', end);
  shot.name = line.substr(begin == std::string::npos ? 0 : begin + 1,
                          end - (begin == std::string::npos ? 0 : begin + 1));
  shot.frame = std::atoi(line.substr(line.rfind(' ')).c_str());
  shot.image = read_image(folder_ / (shot.name + ".exr"));
  return shot;
}

void RunningView::let_frames_pass() {
  const int first = shoot().frame;
  eventually([&] { return shoot().frame >= first + 2 || !running(); });
}

void RunningView::step(int frames) {
  for (int i = 0; i < frames; ++i) {
    const int before = shoot().frame;
    key("F7");
    eventually([&] { return shoot().frame > before || !running(); });
  }
}

int RunningView::quit() {
  key("ctrl+q");
  return wait_for_end();
}

int RunningView::wait_for_end() {
  return eventually([&] { return !running(); }) ? status_ : -1;
}

}  // namespace shadertwin
