// What OpenImageIO does for this folder. It stands in a library of its own that is loaded when it is first
// needed: some 250 libraries come with it, which take longer to load than most shaders take to start.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>

#include "host/image/image.h"

namespace shadertwin {

// A name and a value, as OpenImageIO has them for what its writers can be told.
using WriterSetting = std::pair<const char*, const char*>;

struct PictureToWrite {
  bool is_float = false;  // else a byte a channel
  int width = 0;
  int height = 0;
  int channels = 4;            // that are written; there are always four
  const void* rgba = nullptr;  // row 0 is the bottom row
  std::span<const WriterSetting> settings = {};
};

struct Formats {
  // Row 0 is the top row. Throws Error(file).
  Texture (*read)(const std::filesystem::path& file);
  // Why the file could not be written; empty if it was.
  std::string (*write)(const PictureToWrite& picture, const std::filesystem::path& file);
};

// Throws Error(device) if the library can't be loaded.
const Formats& formats();

// Throws Error(file): "FILE: REASON", in one line.
[[noreturn]] void fail_to_read(const std::filesystem::path& file, std::string reason);

constexpr int max_extent = 16384;  // what today's GPUs sample

}  // namespace shadertwin

// The one function of the library.
extern "C" const shadertwin::Formats* shadertwin_formats();
