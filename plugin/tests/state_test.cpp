// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "plugin/tests/loaded_plugin.h"

namespace {

using namespace cagewright::plugin::test;
using Bytes = std::vector<unsigned char>;

constexpr std::size_t header_size = 48, version_at = 8, payload_size_at = 24, payload_sum_at = 32, header_sum_at = 40;

struct Memory {
  Bytes bytes;
  std::size_t at = 0;
  std::uint64_t largest_read = 0, room = UINT64_MAX;
};

cgw_stream stream_on(Memory& memory) {
  cgw_stream stream = CGW_STREAM_INIT;
  stream.user = &memory;
  stream.read = [](void* user, void* bytes, std::uint64_t count) -> std::uint64_t {
    auto& m = *static_cast<Memory*>(user);
    m.largest_read = std::max(m.largest_read, count);
    const std::size_t got = std::min<std::size_t>(count, m.bytes.size() - m.at);
    if (got > 0) std::memcpy(bytes, m.bytes.data() + m.at, got);
    m.at += got;
    return got;
  };
  stream.write = [](void* user, const void* bytes, std::uint64_t count) -> std::uint64_t {
    auto& m = *static_cast<Memory*>(user);
    const auto* from = static_cast<const unsigned char*>(bytes);
    const std::uint64_t taken = std::min<std::uint64_t>(count, m.room - m.bytes.size());
    m.bytes.insert(m.bytes.end(), from, from + taken);
    return taken;
  };
  return stream;
}

Bytes saved(const Session& session) {
  Memory memory;
  const cgw_stream stream = stream_on(memory);
  EXPECT_EQ(api().save_state(session, &stream), CGW_OK) << session.error();
  return memory.bytes;
}

cgw_status load(const Session& session, const Bytes& bytes) {
  Memory memory{bytes};
  const cgw_stream stream = stream_on(memory);
  const cgw_status status = api().load_state(session, &stream);
  EXPECT_LE(memory.largest_read, 1u << 16) << "no length is believed before the bytes are there";
  return status;
}

void put(Bytes& bytes, std::size_t at, std::uint64_t value, std::size_t size = 8) {
  for (std::size_t k = 0; k < size; ++k) bytes[at + k] = static_cast<unsigned char>(value >> (8 * k));
}

std::uint64_t fnv1a(const unsigned char* bytes, std::size_t count) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (std::size_t k = 0; k < count; ++k) hash = (hash ^ bytes[k]) * 0x100000001b3u;
  return hash;
}

// What somebody with bad intent would do: damage, then checksums that agree.
Bytes resealed(Bytes bytes) {
  put(bytes, payload_sum_at, fnv1a(bytes.data() + header_size, bytes.size() - header_size));
  put(bytes, header_sum_at, fnv1a(bytes.data(), header_sum_at));
  return bytes;
}

// A session with a slide of every kind.
struct Rich {
  Rich() : session(capsule()) {
    const std::vector<double> points = {1, 1, 0, 1, 0, 1, 1, -1, 0, 1, 0, -1, 1, 0.8, 0.6, 1, 0.6, -0.8};
    cgw_slide_input stroke = CGW_SLIDE_INPUT_INIT;
    stroke.name = "stroke";
    stroke.stroke = points.data();
    stroke.stroke_count = points.size() / 3;
    add(session, plane("goes", 6));
    add(session, stroke);
    add(session, plane("plane", 3.02, 1, 0.1));
    add(session, ellipse("ellipse", 5, 1));
    add(session, point_alone("point", 4));
    EXPECT_EQ(api().slide_remove(session, 1), CGW_OK);
    EXPECT_EQ(api().set_parameter(session, "refine.delta", 0.125), CGW_OK);
    EXPECT_EQ(api().set_parameter_text(session, "refine.scope", "part"), CGW_OK);
  }
  Session session;
};

TEST(AbiState, BringsBackSlidesWithTheirIdsAndParameters) {
  const Rich rich;
  const Session other(capsule());
  add(other, plane("is replaced", 2));
  ASSERT_EQ(load(other, saved(rich.session)), CGW_OK) << other.error();
  ASSERT_EQ(api().slide_count(other), 4u);
  for (std::uint64_t k = 0; k < 4; ++k) {
    EXPECT_EQ(info(other, k).id, info(rich.session, k).id);
    EXPECT_STREQ(info(other, k).name, info(rich.session, k).name);
    EXPECT_EQ(info(other, k).kind, info(rich.session, k).kind);
    EXPECT_EQ(info(other, k).has_ellipse, info(rich.session, k).has_ellipse);
  }
  double value = 0;
  EXPECT_EQ(api().get_parameter(other, "refine.delta", &value), CGW_OK);
  EXPECT_EQ(value, 0.125);
  EXPECT_EQ(saved(other), saved(rich.session));
  EXPECT_EQ(add(other, plane("new", 2)), 6u) << "ids that the saved session gave are not given again";
}

TEST(AbiState, BringsBackTheSameCage) {
  const SolvedCapsule solved;
  const Session other(capsule());
  ASSERT_EQ(load(other, saved(solved.session)), CGW_OK) << other.error();
  ASSERT_EQ(api().solve(other, nullptr), CGW_OK) << other.error();
  EXPECT_EQ(cage_of(other), cage_of(solved.session));
}

TEST(AbiState, DropsResultsWhereItIsLoadedAndOnlyThere) {
  const Rich rich;
  const SolvedCapsule solved;
  Bytes damaged = saved(rich.session);
  damaged.back() ^= 1;
  ASSERT_EQ(load(solved.session, damaged), CGW_ERROR_STATE_CORRUPT);
  EXPECT_EQ(api().section_count(solved.session), 3u);
  ASSERT_EQ(load(solved.session, saved(rich.session)), CGW_OK) << solved.session.error();
  EXPECT_EQ(info(solved.session, 0).id, solved.middle) << "what made the results useless: an id that changed its slide";
  EXPECT_STREQ(info(solved.session, 0).name, "stroke");
  EXPECT_EQ(info(solved.session, 0).status, CGW_SLIDE_UNSOLVED);
  EXPECT_EQ(api().section_count(solved.session), 0u);
  EXPECT_EQ(api().iteration_count(solved.session), 0u);
  cgw_section section = CGW_SECTION_INIT;
  EXPECT_EQ(api().get_section(solved.session, 0, &section), CGW_ERROR_NOT_READY);
  cgw_cage cage = CGW_CAGE_INIT;
  EXPECT_EQ(api().get_cage(solved.session, &cage), CGW_ERROR_NOT_READY);
}

TEST(AbiState, NeedsTheModelItWasMadeFor) {
  const Rich rich;
  const Session without;
  Memory memory;
  const cgw_stream stream = stream_on(memory);
  EXPECT_EQ(api().save_state(without, &stream), CGW_ERROR_NOT_READY);
  EXPECT_TRUE(memory.bytes.empty());
  EXPECT_EQ(load(without, saved(rich.session)), CGW_ERROR_NOT_READY);
  const Session other(torus());
  EXPECT_EQ(load(other, saved(rich.session)), CGW_ERROR_STATE_FINGERPRINT);
  EXPECT_NE(other.error().find("model"), std::string::npos) << other.error();
}

TEST(AbiState, TruncatedAtAnyByteIsToldAndChangesNothing) {
  const Rich rich;
  const Bytes whole = saved(rich.session);
  const Session session(capsule());
  add(session, plane("stays", 2));
  const Bytes before = saved(session);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    ASSERT_EQ(load(session, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))), CGW_ERROR_STREAM)
        << size;
    ASSERT_NE(session.error().find("ended"), std::string::npos) << session.error();
  }
  EXPECT_EQ(saved(session), before);
}

TEST(AbiState, WithAnyBitFlippedIsToldAndChangesNothing) {
  const Rich rich;
  const Bytes whole = saved(rich.session);
  const Session session(capsule());
  add(session, plane("stays", 2));
  const Bytes before = saved(session);
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    Bytes damaged = whole;
    damaged[bit / 8] ^= static_cast<unsigned char>(1u << (bit % 8));
    ASSERT_EQ(load(session, damaged), bit < 64 ? CGW_ERROR_STATE_MAGIC : CGW_ERROR_STATE_CORRUPT) << "bit " << bit;
  }
  EXPECT_NE(session.error().find("damaged"), std::string::npos) << session.error();
  EXPECT_EQ(saved(session), before);
}

TEST(AbiState, ForgedWithGoodChecksumsNeverCrashesNorHalfLoads) {
  const Rich rich;
  const Bytes whole = saved(rich.session);
  const Session session(capsule());
  add(session, plane("stays", 2));
  Bytes before = saved(session);
  const std::set<cgw_status> expected = {CGW_OK, CGW_ERROR_STATE_CORRUPT, CGW_ERROR_STATE_VERSION};
  std::mt19937 random(1);
  for (int k = 0; k < 20000; ++k) {
    Bytes forged = whole;
    for (int changes = 1 + static_cast<int>(random() % 3); changes > 0; --changes) {
      const std::size_t at = header_size + random() % (forged.size() - header_size);
      forged[at] = static_cast<unsigned char>(random() % 3 == 0 ? 0xFF : random());
    }
    if (random() % 4 == 0) {
      forged.resize(header_size + random() % (forged.size() - header_size));
      put(forged, payload_size_at, forged.size() - header_size);
    }
    const cgw_status status = load(session, resealed(forged));
    ASSERT_TRUE(expected.contains(status)) << api().status_name(status) << ": " << session.error();
    if (status == CGW_OK) before = saved(session);
    ASSERT_EQ(saved(session), before);
  }
}

TEST(AbiState, ThatLiesAboutItsLengthCostsNothing) {
  const Rich rich;
  Bytes forged = saved(rich.session);
  put(forged, payload_size_at, std::uint64_t{1} << 60);
  EXPECT_EQ(load(rich.session, resealed(forged)), CGW_ERROR_STREAM);
}

TEST(AbiState, ThatWouldRunOutOfIdsIsRefused) {
  const Session session(capsule());
  Bytes forged = saved(session);
  put(forged, forged.size() - 16, CGW_NO_ID);  // the next id, before the number of slides
  EXPECT_EQ(load(session, resealed(forged)), CGW_ERROR_STATE_CORRUPT);
  EXPECT_NE(session.error().find("18446744073709551615"), std::string::npos) << session.error();
}

TEST(AbiState, OfANewerVersionIsTold) {
  const Rich rich;
  Bytes newer = saved(rich.session);
  put(newer, version_at, 2, 4);
  EXPECT_EQ(load(rich.session, resealed(newer)), CGW_ERROR_STATE_VERSION);
  EXPECT_NE(rich.session.error().find("version is 2"), std::string::npos) << rich.session.error();
  Bytes other_parameter = saved(rich.session);
  const std::string id = "orient.lambda";
  const auto at = std::search(other_parameter.begin(), other_parameter.end(), id.begin(), id.end());
  ASSERT_NE(at, other_parameter.end());
  *at = 'x';
  EXPECT_EQ(load(rich.session, resealed(other_parameter)), CGW_ERROR_STATE_VERSION);
  EXPECT_NE(rich.session.error().find("xrient.lambda"), std::string::npos) << rich.session.error();
}

TEST(AbiState, ThatIsSomethingElseIsTold) {
  const Session session(capsule());
  const std::string text = "{\"version\": 1, \"slides\": []}";
  EXPECT_EQ(load(session, Bytes(text.begin(), text.end())), CGW_ERROR_STATE_MAGIC);
  EXPECT_NE(session.error().find("no saved state"), std::string::npos) << session.error();
}

TEST(AbiState, ReadsNoByteBeyondItsEnd) {
  const Rich rich;
  Memory memory{saved(rich.session)};
  const std::size_t size = memory.bytes.size();
  memory.bytes.insert(memory.bytes.end(), 100, 0xEE);
  const cgw_stream stream = stream_on(memory);
  EXPECT_EQ(api().load_state(rich.session, &stream), CGW_OK) << rich.session.error();
  EXPECT_EQ(memory.at, size);
}

TEST(AbiState, ThatTheStreamDoesNotTakeIsTold) {
  const Rich rich;
  Memory memory;
  memory.room = 100;
  const cgw_stream stream = stream_on(memory);
  EXPECT_EQ(api().save_state(rich.session, &stream), CGW_ERROR_STREAM);
  EXPECT_NE(rich.session.error().find("took 100 of"), std::string::npos) << rich.session.error();
}

}  // namespace
