// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/scene_document.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <map>
#include <utility>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/gltf_container.h"
#include "host/file/gltf_geometry.h"
#include "host/file/gltf_loader.h"
#include "host/file/gltf_own_nodes.h"
#include "host/file/gltf_uri.h"
#include "host/file/mesh_writer.h"
#include "host/scene/base64.h"
#include "host/scene/node_tree.h"
#include "host/scene/outline.h"
#include "host/scene/own_extension.h"
#include "host/scene/scene_parts.h"

namespace cagewright::host {

struct SceneDocument::State {
  std::filesystem::path path;
  std::string file;         // as it was read
  GltfContainer container;  // views of `file`
  tinygltf::Model model;    // the typed view of `file`
  SceneBase base;
  SceneContent content;
  std::string text_as_read;  // what put_together makes of what was read
  std::vector<std::string> notes;
  std::vector<SceneMeshNode> mesh_nodes;
  std::vector<std::weak_ptr<Listener>> listeners;
  std::map<int, std::vector<std::pair<std::string, double>>> parameters;  // by mesh node
  SlideIds ids;                                                           // that any slide has had, or a cage names

  int indent() const { return !container.is_binary && container.json.find('\n') != std::string_view::npos ? 2 : -1; }
  std::string text() const { return gltf_json_text(put_together(path, base, content), indent()); }
  auto slide(std::int64_t id) {
    return std::find_if(content.slides.begin(), content.slides.end(), [&](const SceneSlide& s) { return s.id == id; });
  }
  auto cage(int mesh_node) {
    return std::find_if(content.cages.begin(), content.cages.end(),
                        [&](const SceneCage& c) { return c.mesh_node == mesh_node; });
  }
};

namespace {

constexpr std::size_t chunk_header_size = 8;

std::vector<SceneMeshNode> mesh_nodes_of(const tinygltf::Model& model) {
  std::vector<SceneMeshNode> nodes;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const tinygltf::Node& node = model.nodes[i];
    if (!shows_model(node)) continue;
    nodes.push_back({static_cast<int>(i), shown_name(model, node)});
  }
  return nodes;
}

}  // namespace

SceneDocument::SceneDocument(const std::filesystem::path& path, Unreadable unreadable)
    : SceneDocument(path, read_bytes(path), unreadable) {}

SceneDocument::SceneDocument(const std::filesystem::path& path, std::string bytes, Unreadable unreadable)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.path = path;
  s.file = std::move(bytes);
  s.container = split_gltf(path, s.file);
  GltfJson json = parse_container_json(path, s.container);
  load_gltf(path, s.container, json, s.model);
  TakenApart parts = take_apart(path, std::move(json), s.model, unreadable);
  s.base = std::move(parts.base);
  s.content = std::move(parts.content);
  s.notes = std::move(parts.notes);
  s.mesh_nodes = mesh_nodes_of(s.model);
  s.ids = ids_in(s.content);
  for (const SceneCage& cage : s.content.cages) s.parameters[cage.mesh_node] = cage.parameters;
  s.text_as_read = s.text();
}

// A .gltf is the .glb with its binary chunk in the text.
SceneDocument SceneDocument::of_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                                     const std::string& name) {
  std::string glb = glb_bytes(mesh, name, path);
  if (lower_ending(path) != ".gltf") return SceneDocument(path, std::move(glb));
  const GltfContainer container = split_gltf(path, glb);
  GltfJson json = parse_gltf_json(path, container.json);
  json["buffers"][0]["uri"] =
      "data:application/octet-stream;base64," + base64(container.chunks.substr(chunk_header_size));
  json["buffers"][0]["byteLength"] = container.chunks.size() - chunk_header_size;
  return SceneDocument(path, gltf_json_text(json, 2));
}

SceneDocument SceneDocument::copy_as(bool is_binary) const {
  const State& s = *state_;
  if (s.container.is_binary == is_binary) return SceneDocument(path(), bytes(), Unreadable::stray);
  GltfJson json = put_together(s.path, s.base, s.content);
  GltfJson* buffers = find_key(json, "buffers");
  const GltfJson* others = find_key(s.base.json, "buffers");
  const bool is_ours =
      std::any_of(s.base.blocks.begin(), s.base.blocks.end(), [](const CageBlock& block) { return block.buffer == 0; });
  const bool has_buffer = others && !others->empty() && !is_ours;
  std::string chunk;
  if (has_buffer && is_binary && find_key((*buffers)[0], "uri")) {
    const std::vector<unsigned char>& data = s.model.buffers[0].data;
    chunk.assign(data.begin(), data.end());
    (*buffers)[0].erase("uri");
  } else if (has_buffer && !is_binary && !find_key((*buffers)[0], "uri")) {
    const std::vector<unsigned char>& data = s.model.buffers[0].data;
    const std::string_view view(reinterpret_cast<const char*>(data.data()), data.size());
    (*buffers)[0]["uri"] = "data:application/octet-stream;base64," + base64(view);
  }
  if (is_binary) {
    return SceneDocument(path(), join_gltf(path(), {true, {}, binary_chunk(chunk), {}, {}}, gltf_json_text(json)),
                         Unreadable::stray);
  }
  return SceneDocument(path(), gltf_json_text(json, 2), Unreadable::stray);
}

std::vector<std::string> SceneDocument::lost_as(bool is_binary) const {
  const GltfContainer& from = state_->container;
  const std::size_t known = from.binary.data() ? from.binary.size() + chunk_header_size : 0;
  if (is_binary || from.chunks.size() <= known) return {};
  return {path().string() +
          ": it has chunks that glTF does not know; a .gltf has no place for them, so they are left out"};
}

SceneDocument::~SceneDocument() = default;
SceneDocument::SceneDocument(SceneDocument&&) noexcept = default;
SceneDocument& SceneDocument::operator=(SceneDocument&&) noexcept = default;

const std::filesystem::path& SceneDocument::path() const { return state_->path; }
const std::vector<std::string>& SceneDocument::notes() const { return state_->notes; }
const std::vector<SceneMeshNode>& SceneDocument::mesh_nodes() const { return state_->mesh_nodes; }
const std::vector<SceneSlide>& SceneDocument::slides() const { return state_->content.slides; }
const std::vector<SceneCage>& SceneDocument::cages() const { return state_->content.cages; }
const std::vector<SceneStray>& SceneDocument::strays() const { return state_->content.strays; }

std::vector<SceneNode> SceneDocument::nodes() const { return outline(path(), state_->model, state_->content); }

std::array<double, 16> SceneDocument::to_scene(int node) const {
  const State& s = *state_;
  if (node < 0 || static_cast<std::size_t>(node) >= s.model.nodes.size()) {
    throw FileError(path(), {}, "there is no node " + std::to_string(node));
  }
  const NodeTree tree(s.path, s.base.json, s.model);
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = tree.shown(node).matrix();
  std::array<double, 16> matrix{};
  std::copy(rows.data(), rows.data() + rows.size(), matrix.begin());
  return matrix;
}

const std::vector<std::pair<std::string, double>>& SceneDocument::parameters(int mesh_node) const {
  static const std::vector<std::pair<std::string, double>> none;
  const auto found = state_->parameters.find(mesh_node);
  return found == state_->parameters.end() ? none : found->second;
}

MeshFile SceneDocument::mesh(int node) const {
  const tinygltf::Model& model = state_->model;
  const bool is_there = node >= 0 && static_cast<std::size_t>(node) < model.nodes.size();
  const int mesh = is_there ? model.nodes[static_cast<std::size_t>(node)].mesh : -1;
  if (mesh < 0 || static_cast<std::size_t>(mesh) >= model.meshes.size()) {
    throw FileError(path(), {}, "node " + std::to_string(node) + " shows no mesh");
  }
  MeshFile file = read_gltf_mesh(path(), model, mesh);
  if (file.mesh.triangles.empty()) {
    throw FileError(path(), {}, "node " + std::to_string(node) + " has no triangles; a closed surface is needed");
  }
  return file;
}

const SceneSlide* SceneDocument::find_slide(std::int64_t id) const {
  const auto found = state_->slide(id);
  return found == state_->content.slides.end() ? nullptr : &*found;
}

const SceneCage* SceneDocument::find_cage(int mesh_node) const {
  const auto found = state_->cage(mesh_node);
  return found == state_->content.cages.end() ? nullptr : &*found;
}

std::int64_t SceneDocument::new_slide_id() { return state_->ids.take_next(); }

void SceneDocument::insert_slide(std::size_t row, SceneSlide slide) {
  auto& slides = state_->content.slides;
  const SceneEvent event{SceneEvent::Kind::slide_added, slide.id, slide.mesh_node};
  slides.insert(slides.begin() + static_cast<std::ptrdiff_t>(row), std::move(slide));
  tell(event);
}

void SceneDocument::replace_slide(SceneSlide slide) {
  const SceneEvent event{SceneEvent::Kind::slide_changed, slide.id, slide.mesh_node};
  *state_->slide(slide.id) = std::move(slide);
  tell(event);
}

void SceneDocument::remove_slide(std::int64_t id) {
  const auto found = state_->slide(id);
  const SceneEvent event{SceneEvent::Kind::slide_removed, id, found->mesh_node};
  state_->content.slides.erase(found);
  tell(event);
}

void SceneDocument::set_cage(int mesh_node, const SceneCage* cage) {
  auto& cages = state_->content.cages;
  const auto found = state_->cage(mesh_node);
  if (cage == nullptr) {
    if (found != cages.end()) cages.erase(found);
  } else if (found != cages.end()) {
    *found = *cage;
  } else {
    // By node, so that the order of commands does not matter to the file.
    const auto after =
        std::find_if(cages.begin(), cages.end(), [&](const SceneCage& other) { return other.mesh_node > mesh_node; });
    cages.insert(after, *cage);
  }
  tell({cage ? SceneEvent::Kind::cage_set : SceneEvent::Kind::cage_removed, 0, mesh_node});
}

void SceneDocument::set_parameters(int mesh_node, std::vector<std::pair<std::string, double>> parameters) {
  state_->parameters[mesh_node] = std::move(parameters);
  tell({SceneEvent::Kind::parameters_set, 0, mesh_node});
}

void SceneDocument::insert_stray(std::size_t row, SceneStray stray) {
  auto& strays = state_->content.strays;
  strays.insert(strays.begin() + static_cast<std::ptrdiff_t>(row), std::move(stray));
}

void SceneDocument::remove_stray(std::size_t row) {
  auto& strays = state_->content.strays;
  strays.erase(strays.begin() + static_cast<std::ptrdiff_t>(row));
}

std::unique_ptr<SceneDocument::Subscription> SceneDocument::listen(Listener listener) {
  auto shared = std::make_shared<Listener>(std::move(listener));
  state_->listeners.push_back(shared);
  return std::make_unique<Subscription>(std::move(shared));
}

void SceneDocument::tell(const SceneEvent& event) const {
  auto& listeners = state_->listeners;
  listeners.erase(std::remove_if(listeners.begin(), listeners.end(), [](const auto& l) { return l.expired(); }),
                  listeners.end());
  const auto told = listeners;  // a listener may subscribe others
  for (const auto& listener : told) {
    if (const auto alive = listener.lock()) (*alive)(event);
  }
}

std::string SceneDocument::bytes() const {
  std::string text = state_->text();
  if (text == state_->text_as_read) return state_->file;
  return join_gltf(path(), state_->container, std::move(text));
}

bool SceneDocument::is_changed() const { return state_->text() != state_->text_as_read; }

std::vector<std::string> SceneDocument::external_files() const {
  std::vector<std::string> names;
  const auto add = [&](const char* array) {
    const GltfJson* items = find_key(state_->base.json, array);
    if (items == nullptr || !items->is_array()) return;
    for (const GltfJson& item : *items) {
      const GltfJson* uri = find_key(item, "uri");
      if (uri && uri->is_string() && !is_data_uri(uri->get_ref<const std::string&>())) {
        names.push_back(uri->get<std::string>());
      }
    }
  };
  add("buffers");
  add("images");
  return names;
}

}  // namespace cagewright::host
