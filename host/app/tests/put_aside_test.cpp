// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/put_aside.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace cagewright::host {
namespace {

namespace fs = std::filesystem;

class PutAside : public testing::Test {
 protected:
  PutAside() : folder_(fs::temp_directory_path() / ("cagewright-put-aside-" + std::to_string(getpid()))) {
    fs::create_directory(folder_);
  }
  ~PutAside() override { fs::remove_all(folder_); }

  fs::path at(const std::string& name) const { return folder_ / name; }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(at(name)) << text;
    return at(name);
  }
  static std::string read(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_;
};

TEST_F(PutAside, TakesTheFirstNumberThatNothingHas) {
  const fs::path before = write("left_recovered_1.glb", "before");
  fs::create_symlink(at("of another disk"), at("left_recovered_2.glb"));  // it leads nowhere now
  fs::create_directory(at("left_recovered_3.glb"));
  const fs::path file = write("autosave", "changes");
  EXPECT_EQ(free_name_aside(at("left.glb")), at("left_recovered_4.glb"));
  EXPECT_EQ(put_aside(file, at("left.glb")), at("left_recovered_4.glb"));
  EXPECT_EQ(read(at("left_recovered_4.glb")), "changes");
  EXPECT_EQ(read(before), "before");
  EXPECT_TRUE(fs::is_symlink(at("left_recovered_2.glb")));
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(PutAside, SaysWhatKeepsItFromThat) {
  try {
    put_aside(at("none"), at("left.glb"));
    FAIL() << "there is nothing to put aside";
  } catch (const fs::filesystem_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
  }
  const fs::path file = write("autosave", "changes");
  EXPECT_THROW(put_aside(file, at(std::string(245, 'n') + ".glb")), fs::filesystem_error) << "too long for a name";
  EXPECT_EQ(read(file), "changes");
}

TEST_F(PutAside, LosesNoneOfWhatIsPutAsideAtTheSameTime) {
  constexpr int windows = 8, times = 50;
  std::vector<std::thread> threads;
  for (int window = 0; window < windows; ++window)
    threads.emplace_back([this, window] {
      for (int time = 0; time < times; ++time) {
        const std::string text = std::to_string(window) + "." + std::to_string(time);
        put_aside(write("autosave" + text, text), at("left.glb"));
      }
    });
  for (std::thread& thread : threads) thread.join();
  std::set<std::string> kept;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) kept.insert(read(entry.path()));
  EXPECT_EQ(kept.size(), windows * times);
}

}  // namespace
}  // namespace cagewright::host
