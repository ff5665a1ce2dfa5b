// Turns an equirectangular map into the six pictures of a cubemap: NAME_px.jpg, NAME_nx.jpg and so on.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "host/base/error.h"
#include "host/image/image.h"
#include "tools/cubemap.h"

namespace {

void write_faces(const std::string& map_file, const std::string& name, int size, int samples, double exposure,
                 const std::string& extension) {
  const shadertwin::Image map = shadertwin::read_image(map_file);
  for (int face = 0; face < 6; ++face) {
    shadertwin::Image image = shadertwin::cube_face(map, face, size, samples);
    shadertwin::encode_srgb(image, exposure);
    std::string file = name;
    file.append("_").append(shadertwin::face_names[face]).append(".").append(extension);
    shadertwin::write_image(image, file);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::string map_file, name, extension = "jpg";
  int size = 256, samples = 4;
  double exposure = 0;

  CLI::App app("Turns an equirectangular map of linear colours into six sRGB cube faces");
  app.add_option("map", map_file, "The map: .exr or .hdr")->required();
  app.add_option("name", name, "Faces are called NAME_px.jpg, _nx, _py, _ny, _pz, _nz")->required();
  app.add_option("--size", size, "Width of a face in texels")
      ->check(CLI::Range(1, 8192))
      ->capture_default_str();
  app.add_option("--samples", samples, "Lookups a texel, in each direction")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_option("--exposure", exposure, "Stops of brightening")->capture_default_str();
  app.add_option("--format", extension, "File format")
      ->check(CLI::IsMember({"jpg", "png"}))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  try {
    write_faces(map_file, name, size, samples, exposure, extension);
  } catch (const shadertwin::Error& error) {
    std::fprintf(stderr, "cubemap_faces: %s\n", error.what());
    return static_cast<int>(error.status());
  }
  return 0;
}
