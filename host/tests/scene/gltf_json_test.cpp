// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_json.h"

#include <cmath>
#include <limits>
#include <random>

#include "host/tests/expect_file_error.h"

namespace cagewright::host::test {
namespace {

std::string round_trip(const std::string& text, int indent = -1) {
  return gltf_json_text(parse_gltf_json("a.gltf", text), indent);
}

// JSON text without white space, made from random choices; every choice that JSON allows is among them.
class RandomJson {
 public:
  explicit RandomJson(unsigned seed) : random_(seed) {}

  std::string value(int depth) {
    switch (below(depth > 0 ? 8 : 6)) {
      case 0:
        return pick({"null", "true", "false"});
      case 1:
      case 2:
      case 3:
        return number();
      case 4:
      case 5:
        return string();
      case 6:
        return items('[', ']', depth, [](std::size_t) { return std::string(); });
      default:
        return items('{', '}', depth, [this](std::size_t i) { return key(i).append(":"); });
    }
  }

 private:
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  std::string pick(const std::vector<std::string>& all) { return all[below(all.size())]; }

  std::string digits(std::size_t most) {
    std::string text;
    for (std::size_t i = below(most) + 1; i > 0; --i) text += static_cast<char>('0' + below(10));
    return text;
  }
  std::string number() {
    std::string text = pick({"", "-"}) + pick({"0", pick({"1", "9", "20", "4"}) + pick({"", digits(30)})});
    if (below(2) == 0) text.append(".").append(digits(25));
    if (below(3) == 0) text += pick({"e", "E"}) + pick({"", "+", "-"}) + digits(2);
    return text;
  }
  std::string characters() {
    std::string text;
    for (std::size_t i = below(6); i > 0; --i) {
      text += pick({"a", " ", "/", "~", "\\\"", "\\\\", "\\n", "\\t", "\\b", "\\f", "\\r", "\\u0000", "\\u001f", "\x7f",
                    "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\xa6\xb4"});
    }
    return text;
  }
  std::string string() { return quoted(characters()); }
  static std::string quoted(const std::string& text) { return std::string("\"").append(text).append("\""); }
  // No two of an object may be the same, and at times one is empty.
  std::string key(std::size_t i) { return i == 0 && below(2) == 0 ? "\"\"" : quoted(characters() + std::to_string(i)); }
  template <typename Before>
  std::string items(char open, char close, int depth, const Before& before) {
    std::string text(1, open);
    const std::size_t count = below(5);
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) text += ',';
      text += before(i);
      text += value(depth - 1);
    }
    return text + close;
  }

  std::mt19937 random_;
};

TEST(GltfJson, KeepsEveryLetterOfRandomValues) {
  for (unsigned seed = 0; seed < 5000; ++seed) {
    const std::string text = RandomJson(seed).value(5);
    ASSERT_EQ(round_trip(text), text) << seed;
    ASSERT_EQ(round_trip(round_trip(text, 2)), text) << seed;
  }
}

TEST(GltfJson, KeepsEveryLetterOfNumbers) {
  for (const char* number : {"0",
                             "-0",
                             "1",
                             "-1",
                             "1.0",
                             "-0.0",
                             "1e3",
                             "1E3",
                             "1e+3",
                             "1e-3",
                             "1.50",
                             "0.1",
                             "0.10",
                             "0.1000000000000000055",
                             "5e-324",
                             "1e-400",
                             "-1e-400",
                             "0e5",
                             "1.7976931348623157e308",
                             "9007199254740993",
                             "9223372036854775807",
                             "9223372036854775808",
                             "-9223372036854775808",
                             "-9223372036854775809",
                             "18446744073709551615",
                             "18446744073709551616",
                             "-18446744073709551616",
                             "123456789012345678901234567890",
                             "3.141592653589793238462643"}) {
    EXPECT_EQ(round_trip(number), number);
    const std::string nested = std::string("{\"a\":[").append(number).append("]}");
    EXPECT_EQ(round_trip(nested), nested);
  }
}

TEST(GltfJson, GivesTheNearestDoubleOfEveryNumber) {
  const auto value = [](const char* text) { return number_in(parse_gltf_json("a.gltf", text)); };
  EXPECT_EQ(value("1e3"), 1000.0);
  EXPECT_EQ(value("0.1000000000000000055"), 0.1);
  EXPECT_EQ(value("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(value("18446744073709551616"), 18446744073709551616.0);
  EXPECT_EQ(value("1e-400"), 0.0);
  EXPECT_EQ(value("-0"), 0.0);
  EXPECT_TRUE(std::signbit(*value("-0")));
  EXPECT_TRUE(std::signbit(*value("-1e-400")));
  EXPECT_EQ(value("\"1\""), std::nullopt);
  EXPECT_EQ(value("null"), std::nullopt);
}

TEST(GltfJson, RefusesNumbersThatNoDoubleCanHold) {
  for (const char* number : {"1e309", "-1e309", "1e999999999999"}) {
    expect_file_error([&] { parse_gltf_json("a.gltf", std::string("[1,\n ").append(number).append("]")); },
                      {"a.gltf, line 2, column 2: ", "range of doubles", number});
  }
}

TEST(GltfJson, KeepsTheOrderOfKeysAndWhatIsEmpty) {
  for (const char* text : {"{\"b\":1,\"a\":2,\"\":3,\"B\":4}", "{}", "[]", "null", "\"\"",
                           "[null,{},[],\"\",[[]],{\"a\":{}}]", "{\"a/b\":1,\"a~b\":2,\"a\\\"b\":3}"}) {
    EXPECT_EQ(round_trip(text), text);
  }
}

TEST(GltfJson, KeepsTheValueOfStringsHoweverTheyAreEscaped) {
  EXPECT_EQ(round_trip(R"("\u00e9\u20ac\ud83e\uddb4\/\u0041")"), "\"\xc3\xa9\xe2\x82\xac\xf0\x9f\xa6\xb4/A\"");
  EXPECT_EQ(round_trip(R"("\u0000\u001F")"), R"("\u0000\u001f")");
}

TEST(GltfJson, IsNestedUpTo256Levels) {
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  EXPECT_EQ(round_trip(nested(256)), nested(256));
  expect_file_error([&] { round_trip(nested(257)); }, {"a.gltf", "too deeply"});
}

TEST(GltfJson, BreaksLinesWhereItIsIndented) {
  EXPECT_EQ(round_trip("{\"a\":[1,{}],\"b\":[]}", 2), "{\n  \"a\": [\n    1,\n    {}\n  ],\n  \"b\": []\n}");
}

TEST(GltfJson, RefusesAKeyTwiceAndTextThatIsNotUtf8) {
  expect_file_error([] { round_trip("{\"a\":{\"k\":1,\"k\":1}}"); }, {"a.gltf", "\"k\" twice"});
  round_trip("{\"k\":{\"k\":1},\"l\":{\"k\":1}}");
  for (const char* bytes : {"\"\xff\"", "\"\xc0\x80\"", "\"\xed\xa0\x80\"", "\"\xf4\x90\x80\x80\"", "\"\xe2\x82\""}) {
    expect_file_error([&] { round_trip(bytes); }, {"a.gltf", "line 1", "export it again"});
  }
}

TEST(GltfJson, NamesTheByteOfTheFileWhereItIsPartOfOne) {
  expect_file_error([] { parse_gltf_json("a.glb", "{\"a\":x}", 20); }, {"a.glb, byte 25: "});
}

}  // namespace
}  // namespace cagewright::host::test
