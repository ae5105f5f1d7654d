// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_PICTURE_H
#define CAGEWRIGHT_HOST_VIEW_PICTURE_H

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace cagewright::host {

// An ellipse: center + cos(t) u + sin(t) v, model units.
struct SlideMark {
  std::array<double, 3> center{};
  std::array<double, 3> u{};
  std::array<double, 3> v{};
  bool failed = false;  // drawn orange instead of red
};

// What is drawn. Points are packed rows n x 3, triangles packed rows m x 3 of indices from 0 into them. Any of it may
// be empty, but not all. Borrowed for the duration of the call.
struct PictureInput {
  std::span<const double> model_points;
  std::span<const std::uint32_t> model_triangles;
  std::span<const double> cage_points;
  std::span<const std::uint32_t> cage_triangles;
  std::vector<SlideMark> slides;
  std::vector<std::array<double, 12>> sections;  // four corners x 3, in order round the rectangle
};

// Where one looks from. Neither vector need be normalised.
struct View {
  std::array<double, 3> toward_viewer{0.6, 0.35, 1.0};  // from the model to the eye
  std::array<double, 3> up{0, 1, 0};                    // not parallel to toward_viewer
};

// The view of a default View for a model whose up is another: turned by the least turn that takes y there. So for z the
// viewer stands before -y. Precondition: `up` is finite and not zero.
View default_view(const std::array<double, 3>& up);

// Whether both directions are finite, neither is zero, and they are not along one line.
bool is_sound(const View& view);

constexpr int smallest_picture = 16;
constexpr int largest_picture = 4096;

struct PictureOptions {
  int width = 1280;  // pixels, of the whole picture, smallest_picture to largest_picture
  int height = 800;
  std::vector<View> views = {View{}};  // side by side, from the left, all with the same content
};

// Which of the reasons below a PictureError has.
enum class PictureFault {
  no_display,  // no X display to render with; the sentence says how to get one
  bad_input,   // nothing to draw, not finite, an index out of range, a size or view that makes no sense
  render,      // VTK could not render; the sentence quotes it
};

class PictureError : public std::runtime_error {
 public:
  PictureError(PictureFault fault, const std::string& sentence) : std::runtime_error(sentence), fault_(fault) {}
  PictureFault fault() const { return fault_; }

 private:
  PictureFault fault_;
};

// Throws PictureError (no_display) where pictures cannot be rendered, so that a program can say so before it works for
// long. Connects to the X server. Main thread only.
void require_display();

// The picture as the bytes of a PNG: white background, the model grey and translucent, the cage's edges dark blue and
// its faces a breath of blue, slides red, sections green. Parallel projection, framed to hold everything. Main thread
// only (VTK). O(triangles + pixels). Throws PictureError.
std::vector<std::uint8_t> render_picture(const PictureInput& input, const PictureOptions& options = {});

// render_picture into a file. `path` is replaced in one step or not touched at all. Throws PictureError, and FileError
// (host/file/file_error.h) where the file cannot be written.
void write_picture(const PictureInput& input, const PictureOptions& options, const std::filesystem::path& path);

}  // namespace cagewright::host

#endif
