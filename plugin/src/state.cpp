// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/state.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "plugin/src/abi_struct.h"
#include "plugin/src/bytes.h"

namespace cagewright::plugin {

namespace {

// The header's layout never changes, so that every version can tell a newer state from a broken one.
constexpr std::array<unsigned char, 8> magic = {'C', 'G', 'W', 'S', 'T', 'A', 'T', 'E'};
constexpr std::uint32_t version = 1;
constexpr std::size_t header_size = 48;
constexpr std::size_t checked_header_size = header_size - sizeof(std::uint64_t);

constexpr std::size_t read_chunk = 1u << 16;
constexpr std::uint64_t id_limit = std::uint64_t{1} << 48;  // far from CGW_NO_ID, however many slides follow

struct Header {
  std::uint32_t version = 0;
  std::uint64_t fingerprint = 0, payload_size = 0, payload_checksum = 0;
};

// What a payload holds, before it becomes the session's.
struct State {
  Parameters parameters;
  SlideList slides;
};

[[noreturn]] void corrupt(const std::string& why) {
  throw AbiError(CGW_ERROR_STATE_CORRUPT, "the saved state is damaged: " + why + "; take an undamaged copy");
}

[[noreturn]] void from_newer(const std::string& why) {
  throw AbiError(CGW_ERROR_STATE_VERSION, "the saved state was made by a newer plug-in: " + why + "; update this one");
}

std::string hexadecimal(std::uint64_t value) {
  char text[24];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

// ---- writing

void write_definition(ByteWriter& out, const SlideDefinition& definition) {
  const auto vector = [&](const Vector3& v) {
    for (const double x : v) out.real(x);
  };
  if (const auto* stroke = std::get_if<StrokeDefinition>(&definition)) {
    out.number(std::uint32_t{CGW_SLIDE_STROKE});
    out.number(static_cast<std::uint64_t>(stroke->points.rows()));
    std::for_each_n(stroke->points.data(), stroke->points.size(), [&](double x) { out.real(x); });
  } else if (const auto* plane = std::get_if<PointNormalDefinition>(&definition)) {
    out.number(std::uint32_t{CGW_SLIDE_POINT_NORMAL});
    vector(plane->point);
    vector(plane->normal);
  } else if (const auto* click = std::get_if<PointDefinition>(&definition)) {
    out.number(std::uint32_t{CGW_SLIDE_POINT});
    vector(click->point);
  } else {
    const auto& ellipse = std::get<EllipseDefinition>(definition);
    out.number(std::uint32_t{CGW_SLIDE_ELLIPSE});
    vector(ellipse.center);
    vector(ellipse.u);
    vector(ellipse.v);
  }
}

Bytes payload_of(const cgw_session& session) {
  ByteWriter out;
  out.number(static_cast<std::uint32_t>(Parameters::count));
  for (const cgw_parameter& parameter : Parameters::list()) {
    out.text(parameter.id);
    out.real(session.parameters.get(parameter.id));
  }
  out.number(session.slides.next_id());
  out.number(static_cast<std::uint64_t>(session.slides.size()));
  for (std::size_t k = 0; k < session.slides.size(); ++k) {
    const SlideEntry& entry = session.slides.at(k);
    out.number(entry.id);
    out.text(entry.slide.name);
    write_definition(out, entry.slide.definition);
  }
  return out.bytes();
}

Bytes header_of(const Bytes& payload, std::uint64_t fingerprint) {
  ByteWriter out;
  out.append({magic.begin(), magic.end()});
  out.number(version);
  out.number(std::uint32_t{0});
  out.number(fingerprint);
  out.number(static_cast<std::uint64_t>(payload.size()));
  out.number(checksum(payload));
  out.number(checksum(out.bytes()));
  return out.bytes();
}

// ---- reading

// Grows with what arrives, so that a length that lies costs nothing.
Bytes read_exactly(const cgw_stream& stream, std::uint64_t count, const char* what) {
  Bytes bytes;
  while (bytes.size() < count) {
    const std::size_t had = bytes.size();
    const std::size_t wanted = static_cast<std::size_t>(std::min<std::uint64_t>(count - had, read_chunk));
    bytes.resize(had + wanted);
    const std::uint64_t got = stream.read(stream.user, bytes.data() + had, wanted);
    if (got != wanted) {
      throw AbiError(CGW_ERROR_STREAM, "the stream ended or failed in the " + std::string(what) + " of the state, " +
                                           std::to_string(had + std::min<std::uint64_t>(got, wanted)) + " of " +
                                           std::to_string(count) + " bytes read; look at the file");
    }
  }
  return bytes;
}

Header read_header(const cgw_stream& stream) {
  Bytes bytes = read_exactly(stream, magic.size(), "first bytes");
  if (!std::equal(magic.begin(), magic.end(), bytes.begin())) {
    throw AbiError(CGW_ERROR_STATE_MAGIC, "this is no saved state: it does not begin with CGWSTATE");
  }
  const Bytes rest = read_exactly(stream, header_size - magic.size(), "header");
  bytes.insert(bytes.end(), rest.begin(), rest.end());

  ByteReader in{std::span<const unsigned char>(bytes).subspan(magic.size())};
  Header header;
  header.version = in.number<std::uint32_t>();
  in.number<std::uint32_t>();
  header.fingerprint = in.number<std::uint64_t>();
  header.payload_size = in.number<std::uint64_t>();
  header.payload_checksum = in.number<std::uint64_t>();
  if (in.number<std::uint64_t>() != checksum(std::span<const unsigned char>(bytes).first(checked_header_size))) {
    corrupt("the checksum of its header does not agree");
  }
  if (header.version > version) {
    from_newer("its version is " + std::to_string(header.version) + ", this plug-in knows up to " +
               std::to_string(version));
  }
  if (header.version == 0) corrupt("its version is 0");
  return header;
}

Parameters read_parameters(ByteReader& in) {
  Parameters parameters;
  for (auto left = in.number<std::uint32_t>(); left > 0; --left) {
    const std::string id = in.text();
    const double value = in.real();
    try {
      parameters.set(id, value);
    } catch (const AbiError& error) {
      from_newer(error.what());  // the checksums agree, so that somebody did write it
    }
  }
  return parameters;
}

SlideDefinition read_definition(ByteReader& in) {
  const auto vector = [&] {
    Vector3 v;
    for (double& x : v) x = in.real();
    return v;
  };
  const auto kind = in.number<std::uint32_t>();
  if (kind == CGW_SLIDE_STROKE) {
    const auto count = in.number<std::uint64_t>();
    if (count > in.left() / (3 * sizeof(double))) throw OutOfBytes{};
    Points points(static_cast<Eigen::Index>(count), 3);
    std::for_each_n(points.data(), points.size(), [&](double& x) { x = in.real(); });
    return StrokeDefinition{std::move(points)};
  }
  if (kind == CGW_SLIDE_POINT_NORMAL) {
    const Vector3 point = vector(), normal = vector();
    return PointNormalDefinition{point, normal};
  }
  if (kind == CGW_SLIDE_ELLIPSE) {
    const Vector3 center = vector(), u = vector(), v = vector();
    return EllipseDefinition{center, u, v};
  }
  if (kind == CGW_SLIDE_POINT) return PointDefinition{vector()};
  from_newer("it has a slide of the kind " + std::to_string(kind));
}

void read_slides(ByteReader& in, SlideList& slides) {
  const auto next_id = in.number<std::uint64_t>();
  if (next_id == 0 || next_id > id_limit) corrupt("its next slide would have the id " + std::to_string(next_id));
  for (auto left = in.number<std::uint64_t>(); left > 0; --left) {
    const auto id = in.number<std::uint64_t>();
    std::string name = in.text();
    SlideDefinition definition = read_definition(in);
    if (id == 0 || id >= next_id) corrupt("slide '" + name + "' has the id " + std::to_string(id));
    try {
      slides.add_as(id, {std::move(name), std::move(definition)});
    } catch (const AbiError& error) {
      corrupt(error.what());
    }
  }
  slides.reserve_ids_below(next_id);
}

State parse(const Bytes& payload) {
  ByteReader in(payload);
  State state;
  try {
    state.parameters = read_parameters(in);
    read_slides(in, state.slides);
  } catch (const OutOfBytes&) {
    corrupt("it ends inside a parameter or a slide");
  }
  if (in.left() > 0) corrupt(std::to_string(in.left()) + " bytes follow its last slide");
  return state;
}

cgw_stream stream_of(const cgw_stream* given) { return read_struct<cgw_stream>(given, CGW_STREAM_INIT, "cgw_stream"); }

}  // namespace

void save_state(const cgw_session& session, const cgw_stream* given) {
  const cgw_stream stream = stream_of(given);
  if (!stream.write) throw AbiError(CGW_ERROR_INVALID_ARGUMENT, "save_state needs a stream with a write function");
  const Bytes payload = payload_of(session);
  ByteWriter out;
  out.append(header_of(payload, model_of(session).fingerprint));
  out.append(payload);
  const std::uint64_t written = stream.write(stream.user, out.bytes().data(), out.bytes().size());
  if (written != out.bytes().size()) {
    throw AbiError(CGW_ERROR_STREAM, "the stream took " + std::to_string(written) + " of the " +
                                         std::to_string(out.bytes().size()) +
                                         " bytes of the state; is there room where it writes to?");
  }
}

void load_state(cgw_session& session, const cgw_stream* given) {
  const cgw_stream stream = stream_of(given);
  if (!stream.read) throw AbiError(CGW_ERROR_INVALID_ARGUMENT, "load_state needs a stream with a read function");
  const std::uint64_t fingerprint = model_of(session).fingerprint;
  const Header header = read_header(stream);
  if (header.fingerprint != fingerprint) {
    throw AbiError(CGW_ERROR_STATE_FINGERPRINT, "the saved state belongs to the model " +
                                                    hexadecimal(header.fingerprint) + ", the session's is " +
                                                    hexadecimal(fingerprint) + "; set the model it was saved with");
  }
  const Bytes payload = read_exactly(stream, header.payload_size, "contents");
  if (checksum(payload) != header.payload_checksum) corrupt("the checksum of its contents does not agree");
  State state = parse(payload);
  state.slides.reserve_ids_below(session.slides.next_id());
  session.parameters = state.parameters;
  session.slides = std::move(state.slides);
  session.results.reset();  // their ids may name other slides now
}

}  // namespace cagewright::plugin
