// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a slides file: they are refused with a FileError, or they are read, and come back the same from what is
// written.
#include "host/file/file_error.h"
#include "host/file/slides_file.h"
#include "host/tests/fuzz/fuzz_target.h"

namespace cagewright::host {
namespace {

void check(std::string_view bytes) {
  const std::vector<Slide> slides = parse_slides("fuzz.json", bytes);
  require_no_throw("writing and reading", [&] {
    const std::string text = slides_text("fuzz.json", slides);
    const std::vector<Slide> again = parse_slides("fuzz.json", text);
    require(slides.size() == again.size(), "a slide is gone or new");
    for (std::size_t i = 0; i < slides.size(); ++i) require(slides[i] == again[i], "a slide is another one");
    require(slides_text("fuzz.json", again) == text, "what was written and read is written as other bytes");
  });
}

}  // namespace
}  // namespace cagewright::host

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cagewright::host;
  try {
    check({reinterpret_cast<const char*>(data), size});
  } catch (const FileError&) {
  }
  return 0;
}
