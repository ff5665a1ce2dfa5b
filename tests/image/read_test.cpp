#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

#include "host/base/error.h"
#include "host/image/image.h"
#include "tests/image/made_files.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

namespace fs = std::filesystem;

// The texels of a texture as numbers, whatever its format.
std::vector<float> values(const Texture& texture) {
  std::vector<float> result;
  if (texture.format == Texture::Format::rgba8) {
    for (const std::byte byte : texture.data) result.push_back(static_cast<float>(byte));
  } else {
    result.resize(texture.data.size() / sizeof(float));
    std::memcpy(result.data(), texture.data.data(), texture.data.size());
  }
  return result;
}

Texture read_png(const ScratchFolder& folder, const Png& png, bool flip = false) {
  write_bytes(folder / "made.png", encode(png));
  return read_texture(folder / "made.png", flip);
}

using Values = std::vector<float>;

// The line that reading `file` fails with; empty if it doesn't fail.
std::string failure(const fs::path& file) {
  testing::internal::CaptureStderr();
  std::string text;
  try {
    read_texture(file, true);
  } catch (const Error& error) {
    text = error.what();
    EXPECT_EQ(error.status(), ExitStatus::file) << text;
    EXPECT_EQ(text.rfind(file.string() + ": ", 0), 0u) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "a library wrote past us";
  return text;
}

TEST(ReadTexture, KeepsTheBytesOfAnRgbaPng) {
  const ScratchFolder folder;
  const Texture texture = read_png(
      folder, {2, 2, 8, png_rgba, {}, {}, {{1, 2, 3, 0, 5, 6, 7, 8}, {255, 10, 11, 12, 13, 14, 15, 255}}});
  EXPECT_EQ(texture.format, Texture::Format::rgba8);
  EXPECT_EQ(texture.width, 2);
  EXPECT_EQ(texture.height, 2);
  EXPECT_EQ(texture.depth, 1);
  EXPECT_EQ(texture.faces, 1);
  EXPECT_EQ(values(texture), (Values{1, 2, 3, 0, 5, 6, 7, 8, 255, 10, 11, 12, 13, 14, 15, 255}));
}

TEST(ReadTexture, FlipPutsTheBottomRowFirst) {
  const ScratchFolder folder;
  const Png png{1, 3, 8, png_grey, {}, {}, {{1}, {2}, {3}}};
  EXPECT_EQ(values(read_png(folder, png, false)), (Values{1, 1, 1, 255, 2, 2, 2, 255, 3, 3, 3, 255}));
  EXPECT_EQ(values(read_png(folder, png, true)), (Values{3, 3, 3, 255, 2, 2, 2, 255, 1, 1, 1, 255}));
}

TEST(ReadTexture, RgbGetsAnAlphaOfOne) {
  const ScratchFolder folder;
  EXPECT_EQ(values(read_png(folder, {1, 1, 8, png_rgb, {}, {}, {{9, 8, 7}}})), (Values{9, 8, 7, 255}));
}

TEST(ReadTexture, GreyWithAlphaIsSpreadAndKeepsItsAlpha) {
  const ScratchFolder folder;
  EXPECT_EQ(values(read_png(folder, {2, 1, 8, png_grey_alpha, {}, {}, {{200, 3, 7, 0}}})),
            (Values{200, 200, 200, 3, 7, 7, 7, 0}));
}

TEST(ReadTexture, APaletteIsLookedUp) {
  const ScratchFolder folder;
  const Bytes palette = {10, 20, 30, 40, 50, 60};
  EXPECT_EQ(values(read_png(folder, {2, 1, 8, png_palette, palette, {}, {{1, 0}}})),
            (Values{40, 50, 60, 255, 10, 20, 30, 255}));
  EXPECT_EQ(values(read_png(folder, {2, 1, 1, png_palette, palette, {}, {{0b10000000}}})),
            (Values{40, 50, 60, 255, 10, 20, 30, 255}));
  EXPECT_EQ(values(read_png(folder, {2, 1, 8, png_palette, palette, {128}, {{1, 0}}})),
            (Values{40, 50, 60, 255, 10, 20, 30, 128}));
}

TEST(ReadTexture, GreyOfFewBitsIsScaledToEight) {
  const ScratchFolder folder;
  EXPECT_EQ(values(read_png(folder, {2, 1, 1, png_grey, {}, {}, {{0b10000000}}})),
            (Values{255, 255, 255, 255, 0, 0, 0, 255}));
  EXPECT_EQ(values(read_png(folder, {2, 1, 4, png_grey, {}, {}, {{0x5f}}})),
            (Values{85, 85, 85, 255, 255, 255, 255, 255}));
}

TEST(ReadTexture, SixteenBitsBecomeTheNearestFloats) {
  const ScratchFolder folder;
  for (const unsigned value : {0u, 1u, 257u, 4660u, 32768u, 65534u, 65535u}) {
    const auto high = static_cast<std::uint8_t>(value >> 8), low = static_cast<std::uint8_t>(value & 255);
    const Texture texture = read_png(folder, {1, 1, 16, png_grey, {}, {}, {{high, low}}});
    EXPECT_EQ(texture.format, Texture::Format::rgba32f);
    const float expected = static_cast<float>(value / 65535.0);
    EXPECT_EQ(values(texture), (Values{expected, expected, expected, 1}));
  }
}

TEST(ReadTexture, HalfAndFloatExrKeepTheirValues) {
  const ScratchFolder folder;
  const Values texels = {-2, 64, 0.5f, 0, 1e-3f, 0, -0.0f, 0.25f};
  write_picture(folder / "float.exr", OIIO::ImageSpec(2, 1, 4, OIIO::TypeDesc::FLOAT), texels);
  const Texture texture = read_texture(folder / "float.exr", false);
  EXPECT_EQ(texture.format, Texture::Format::rgba32f);
  EXPECT_EQ(values(texture), texels);

  write_picture(folder / "half.exr", OIIO::ImageSpec(1, 1, 3, OIIO::TypeDesc::HALF), {-2, 64, 0.5f});
  EXPECT_EQ(values(read_texture(folder / "half.exr", false)), (Values{-2, 64, 0.5f, 1}));
}

TEST(ReadTexture, ExrOfOneOrTwoChannels) {
  const ScratchFolder folder;
  OIIO::ImageSpec grey(1, 1, 1, OIIO::TypeDesc::FLOAT);
  grey.channelnames = {"Y"};
  write_picture(folder / "y.exr", grey, {3});
  EXPECT_EQ(values(read_texture(folder / "y.exr", false)), (Values{3, 3, 3, 1}));

  OIIO::ImageSpec two(1, 1, 2, OIIO::TypeDesc::FLOAT);
  two.channelnames = {"R", "G"};
  write_picture(folder / "rg.exr", two, {3, 4});
  EXPECT_EQ(values(read_texture(folder / "rg.exr", false)), (Values{3, 4, 0, 1}));
}

TEST(ReadTexture, DepthIsNoColour) {
  const ScratchFolder folder;
  OIIO::ImageSpec spec(1, 1, 5, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"R", "G", "B", "A", "Z"};
  spec.alpha_channel = 3;
  spec.z_channel = 4;
  write_picture(folder / "z.exr", spec, {1, 2, 3, 0.5f, 100});
  EXPECT_EQ(values(read_texture(folder / "z.exr", false)), (Values{1, 2, 3, 0.5f}));
}

TEST(ReadTexture, RadianceHdrIsFloatAndUpright) {
  const ScratchFolder folder;
  write_picture(folder / "a.hdr", OIIO::ImageSpec(1, 2, 3, OIIO::TypeDesc::FLOAT),
                {2, 4, 8, 0.5f, 0.25f, 0.125f});
  const Texture texture = read_texture(folder / "a.hdr", false);
  EXPECT_EQ(texture.format, Texture::Format::rgba32f);
  const Values texels = values(texture);
  const Values expected = {2, 4, 8, 1, 0.5f, 0.25f, 0.125f, 1};
  ASSERT_EQ(texels.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(texels[i], expected[i], expected[i] / 64);
}

// A TGA of 2x2 pixels, b g r, numbered 1 to 4 in the order of the file.
Bytes make_tga(std::uint8_t descriptor) {
  return {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, descriptor, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4};
}

TEST(ReadTexture, TgaIsUprightWhicheverCornerItStartsIn) {
  const ScratchFolder folder;
  const auto reds = [&](std::uint8_t descriptor) {
    write_bytes(folder / "a.tga", make_tga(descriptor));
    const Values texels = values(read_texture(folder / "a.tga", false));
    return Values{texels[0], texels[4], texels[8], texels[12]};
  };
  EXPECT_EQ(reds(0x20), (Values{1, 2, 3, 4})) << "top left";
  EXPECT_EQ(reds(0x00), (Values{3, 4, 1, 2})) << "bottom left";
  EXPECT_EQ(reds(0x30), (Values{2, 1, 4, 3})) << "top right";
  EXPECT_EQ(reds(0x10), (Values{4, 3, 2, 1})) << "bottom right";
}

TEST(ReadTexture, TgaAlphaIsNotMultipliedIn) {
  const ScratchFolder folder;
  write_bytes(folder / "a.tga", {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 32, 0x28, 30, 20, 10, 128});
  EXPECT_EQ(values(read_texture(folder / "a.tga", false)), (Values{10, 20, 30, 128}));
}

TEST(ReadTexture, DdsWithoutCompression) {
  const ScratchFolder folder;
  Bytes dds(136);
  const auto put = [&](std::size_t at, std::uint32_t value) { std::memcpy(&dds[at], &value, 4); };
  std::memcpy(dds.data(), "DDS ", 4);
  put(4, 124);
  put(8, 0x100f);  // caps, height, width, pitch, pixel format
  put(12, 1);      // height
  put(16, 2);      // width
  put(20, 8);      // pitch
  put(76, 32);
  put(80, 0x41);  // RGB with alpha
  put(88, 32);
  put(92, 0x000000ff);
  put(96, 0x0000ff00);
  put(100, 0x00ff0000);
  put(104, 0xff000000);
  put(108, 0x1000);  // a texture
  std::iota(dds.begin() + 128, dds.end(), std::uint8_t{1});
  write_bytes(folder / "a.dds", dds);
  EXPECT_EQ(values(read_texture(folder / "a.dds", false)), (Values{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(ReadTexture, JpegIsCloseAndTurnedAsItsCameraWasHeld) {
  const ScratchFolder folder;
  OIIO::ImageSpec spec(16, 32, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("Compression", "jpeg:98");
  Values upper_half_white(16 * 32 * 3);
  std::fill(upper_half_white.begin(), upper_half_white.begin() + 16 * 16 * 3, 1.0f);
  write_picture(folder / "a.jpg", spec, upper_half_white);
  Texture texture = read_texture(folder / "a.jpg", false);
  EXPECT_EQ(texture.width, 16);
  EXPECT_NEAR(values(texture)[0], 255, 3);
  EXPECT_NEAR(values(texture).end()[-2], 0, 3);

  spec.attribute("Orientation", 6);  // to be turned a quarter clockwise: white comes to lie on the right
  write_picture(folder / "a.jpg", spec, upper_half_white);
  texture = read_texture(folder / "a.jpg", false);
  EXPECT_EQ(texture.width, 32);
  EXPECT_EQ(texture.height, 16);
  EXPECT_NEAR(values(texture)[0], 0, 3);
  EXPECT_NEAR(values(texture)[std::size_t{31} * 4], 255, 3);
}

TEST(ReadTexture, TheContentCountsWhateverTheName) {
  const ScratchFolder folder;
  write_bytes(folder / "a.jpg", encode({1, 1, 8, png_grey, {}, {}, {{9}}}));
  EXPECT_EQ(values(read_texture(folder / "a.jpg", false)), (Values{9, 9, 9, 255}));
}

TEST(ReadImage, IsFloatWithTheBottomRowFirst) {
  const ScratchFolder folder;
  write_bytes(folder / "a.png", encode({1, 2, 8, png_grey, {}, {}, {{255}, {51}}}));
  const Image image = read_image(folder / "a.png");
  EXPECT_EQ(image.width, 1);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.rgba, (Values{0.2f, 0.2f, 0.2f, 1, 1, 1, 1, 1}));
}

TEST(ReadTexture, FailsInOneLineOnWhatIsNoPicture) {
  const ScratchFolder folder;
  EXPECT_NE(failure(folder / "missing.png").find("No such file"), std::string::npos);
  EXPECT_NE(failure(folder.path()).find("folder"), std::string::npos);
  write_bytes(folder / "empty.png", {});
  EXPECT_NE(failure(folder / "empty.png"), "");
  const std::string text = "void mainImage(out vec4 c, in vec2 p) {}\n";
  for (const char* name : {"text.png", "text.jpg", "text.exr", "text.hdr", "text.tga", "text.dds", "text"}) {
    write_bytes(folder / name, Bytes(text.begin(), text.end()));
    EXPECT_NE(failure(folder / name), "") << name;
  }
}

TEST(ReadTexture, FailsOnTooLargeAPictureBeforeReadingIt) {
  const ScratchFolder folder;
  for (const auto& [width, height] : {std::pair(65536u, 1u), std::pair(1u, 65536u), std::pair(16385u, 1u)}) {
    write_bytes(folder / "wide.png", encode({width, height, 8, png_grey, {}, {}, {{0}}}));
    EXPECT_NE(failure(folder / "wide.png").find("16384"), std::string::npos);
  }
  write_bytes(folder / "widest.png", encode({16384, 1, 8, png_grey, {}, {}, {Bytes(16384)}}));
  EXPECT_EQ(failure(folder / "widest.png"), "");
}

TEST(ReadTexture, FailsOnAPictureWithoutPixels) {
  const ScratchFolder folder;
  write_bytes(folder / "a.png", encode({0, 0, 8, png_grey, {}, {}, {}}));
  EXPECT_NE(failure(folder / "a.png"), "");
  write_bytes(folder / "a.tga", {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 24, 0x20});
  EXPECT_NE(failure(folder / "a.tga"), "");
}

// A picture whose rows don't compress away, so that any cut takes pixels.
Values noise(int count) {
  Values result(count);
  std::uint32_t state = 1;
  for (float& value : result) {
    state = state * 1664525u + 1013904223u;
    value = static_cast<float>(state >> 8) / 16777216.0f;
  }
  return result;
}

TEST(ReadTexture, FailsOnAFileThatIsCutAnywhere) {
  const ScratchFolder folder;
  const int size = 24;
  for (const std::string extension : {".png", ".jpg", ".exr", ".hdr", ".tga", ".bmp", ".tif"}) {
    const bool deep = extension == ".exr" || extension == ".hdr";
    write_picture(folder / ("whole" + extension),
                  OIIO::ImageSpec(size, size, 3, deep ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8),
                  noise(size * size * 3));
    ASSERT_EQ(failure(folder / ("whole" + extension)), "");
    // What follows the pixels of a TGA is a thumbnail and remarks.
    const auto whole =
        extension == ".tga" ? 18 + size * size * 3 : fs::file_size(folder / ("whole" + extension));
    for (std::uintmax_t kept = 0; kept < whole; kept += 1 + whole / 40) {
      cut_file(folder / ("whole" + extension), folder / ("cut" + extension), kept);
      EXPECT_NE(failure(folder / ("cut" + extension)), "")
          << extension << " of " << whole << " bytes, cut to " << kept;
    }
  }
}

TEST(ReadTexture, FailsOnAPngWithoutItsLastByte) {
  const ScratchFolder folder;
  write_bytes(folder / "a.png", encode({2, 2, 8, png_palette, {1, 2, 3}, {}, {{0, 0}, {0, 0}}}));
  for (std::uintmax_t less = 1; less < 30; ++less) {
    cut_file(folder / "a.png", folder / "cut.png", fs::file_size(folder / "a.png") - less);
    EXPECT_NE(failure(folder / "cut.png"), "") << less;
  }
}

TEST(ReadTexture, TakesAPngAndAJpegWithSomethingBehindThem) {
  const ScratchFolder folder;
  for (const std::string name : {"a.png", "a.jpg"}) {
    write_picture(folder / name, OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::UINT8), noise(8 * 8 * 3));
    Bytes bytes = read_bytes(folder / name);
    bytes.resize(bytes.size() + 100);
    write_bytes(folder / name, bytes);
    EXPECT_EQ(failure(folder / name), "");
  }
}

TEST(ReadTexture, FailsOnAPictureThatIsDamagedInside) {
  const ScratchFolder folder;
  Bytes png = encode({4, 1, 8, png_grey, {}, {}, {{1, 2, 3, 4}}});
  png[png.size() - 20] ^= 0x55;  // in the compressed data, which its checksum shows
  write_bytes(folder / "a.png", png);
  EXPECT_NE(failure(folder / "a.png"), "");
}

std::vector<fs::path> write_faces(const ScratchFolder& folder, int count, int size) {
  std::vector<fs::path> faces;
  for (int i = 0; i < count; ++i) {
    faces.push_back(folder / ("face" + std::to_string(i) + ".png"));
    const auto grey = static_cast<std::uint8_t>(i + 1);
    std::vector<Bytes> rows(size, Bytes(size, grey));
    rows[0][0] = 100;
    const auto extent = static_cast<std::uint32_t>(size);
    write_bytes(faces.back(), encode({extent, extent, 8, png_grey, {}, {}, rows}));
  }
  return faces;
}

std::string cubemap_failure(const std::vector<fs::path>& faces) {
  try {
    read_cubemap(faces, false);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::file);
    return error.what();
  }
}

TEST(ReadCubemap, KeepsTheOrderAndTheTopRowOfItsFaces) {
  const ScratchFolder folder;
  const Texture cube = read_cubemap(write_faces(folder, 6, 2), false);
  EXPECT_EQ(cube.faces, 6);
  EXPECT_EQ(cube.width, 2);
  EXPECT_EQ(cube.height, 2);
  const Values texels = values(cube);
  ASSERT_EQ(texels.size(), 6u * 4 * 4);
  for (int face = 0; face < 6; ++face) {
    EXPECT_EQ(texels[face * 16], 100) << "top left of face " << face;
    EXPECT_EQ(texels[face * 16 + 8], face + 1) << "bottom left of face " << face;
  }
}

TEST(ReadCubemap, FlipTurnsEveryFaceOver) {
  const ScratchFolder folder;
  const Values texels = values(read_cubemap(write_faces(folder, 6, 2), true));
  for (int face = 0; face < 6; ++face) EXPECT_EQ(texels[face * 16 + 8], 100) << face;
}

TEST(ReadCubemap, OneDeepFaceMakesAllDeep) {
  const ScratchFolder folder;
  auto faces = write_faces(folder, 6, 1);
  faces[3] = folder / "deep.exr";
  write_picture(faces[3], OIIO::ImageSpec(1, 1, 3, OIIO::TypeDesc::FLOAT), {7, 8, 9});
  const Texture cube = read_cubemap(faces, false);
  EXPECT_EQ(cube.format, Texture::Format::rgba32f);
  const Values texels = values(cube);
  EXPECT_EQ(texels[0], 100 / 255.0f);
  EXPECT_EQ(texels[12], 7);
}

TEST(ReadCubemap, FailsOnFiveFacesAndOnFacesThatDoNotMatch) {
  const ScratchFolder folder;
  auto faces = write_faces(folder, 6, 2);
  EXPECT_NE(cubemap_failure({faces.begin(), faces.end() - 1}), "");
  EXPECT_NE(cubemap_failure({}), "");

  write_bytes(folder / "odd.png", encode({4, 4, 8, png_grey, {}, {}, std::vector<Bytes>(4, Bytes(4))}));
  faces[5] = folder / "odd.png";
  EXPECT_NE(cubemap_failure(faces).find("4x4"), std::string::npos);

  write_bytes(folder / "oblong.png", encode({4, 2, 8, png_grey, {}, {}, std::vector<Bytes>(2, Bytes(4))}));
  faces[5] = folder / "oblong.png";
  EXPECT_NE(cubemap_failure(faces).find("square"), std::string::npos);

  faces[5] = folder / "missing.png";
  EXPECT_NE(cubemap_failure(faces).find("missing.png"), std::string::npos);
}

}  // namespace
}  // namespace shadertwin
