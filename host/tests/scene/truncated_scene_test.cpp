// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/file_bytes.h"
#include "host/scene/scene_document.h"
#include "host/tests/expect_file_error.h"

namespace cagewright::host::test {
namespace {

constexpr char white_space[] = " \t\r\n";

// Every beginning of the file is refused, but for one that only white space follows.
void expect_every_cut_refused(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / name;
  const std::string file = read_bytes(path);
  const bool is_text = path.extension() == ".gltf";
  const std::size_t end = is_text ? file.find_last_not_of(white_space) + 1 : file.size();
  for (std::size_t length = 0; length < end; ++length) {
    // A copy of its own, so that a reader that looks beyond the end is caught by the sanitizers.
    const std::string cut(file.substr(0, length));
    expect_file_error([&] { SceneDocument(path, cut); }, {path.string(), "export it again"});
    if (testing::Test::HasFailure()) FAIL() << name << " cut to " << length;
  }
  for (std::size_t length = end; length <= file.size(); ++length) {
    EXPECT_EQ(SceneDocument(path, file.substr(0, length)).slides().size(), 2u) << length;
  }
}

TEST(TruncatedScene, GlbIsRefusedAtEveryByte) { expect_every_cut_refused("slides_plain.glb"); }

TEST(TruncatedScene, GltfIsRefusedAtEveryByte) { expect_every_cut_refused("slides_plain.gltf"); }

// The header of a .glb is not looked at alone: the same bytes with a header that agrees with the cut.
TEST(TruncatedScene, GlbWithAHeaderThatAgreesIsRefusedAtEveryByte) {
  const std::filesystem::path path = std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "slides_plain.glb";
  const std::string file = read_bytes(path);
  for (std::size_t length = 12; length < file.size(); ++length) {
    std::string cut = file.substr(0, length);
    for (std::size_t k = 0; k < 4; ++k) cut[8 + k] = static_cast<char>(length >> (8 * k) & 0xFF);
    expect_file_error([&] { SceneDocument(path, cut); }, {path.string(), "export it again"});
    if (testing::Test::HasFailure()) FAIL() << "cut to " << length;
  }
}

}  // namespace
}  // namespace cagewright::host::test
