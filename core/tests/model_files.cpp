// SPDX-License-Identifier: BSD-3-Clause
#include "core/tests/model_files.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/tests/off_file.h"

namespace cagewright {
namespace {

Vector3 vector(const nlohmann::json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

}  // namespace

std::optional<IndexedMesh> find_model(const std::string& name) {
  for (const std::string folder : {CAGEWRIGHT_MODEL_FOLDERS})
    for (const std::string inner : {"", "meshes/"}) {
      const std::string path = folder + "/" + inner + name + ".off";
      if (!folder.empty() && std::filesystem::exists(path)) return read_off(path);
    }
  return {};
}

std::vector<Slide> read_slides(const std::string& name) {
  std::ifstream file(CAGEWRIGHT_SLIDE_FILES "/" + name + ".slides.json");
  std::vector<Slide> slides;
  const nlohmann::json document = nlohmann::json::parse(file);
  for (const nlohmann::json& json : document.at("slides")) {
    Slide slide{json.at("name"), {}};
    if (json.contains("stroke")) {
      Points points(static_cast<Eigen::Index>(json["stroke"].size()), 3);
      for (std::size_t i = 0; i < json["stroke"].size(); ++i)
        points.row(static_cast<Eigen::Index>(i)) = vector(json["stroke"][i]).transpose();
      slide.definition = StrokeDefinition{points};
    } else if (json.contains("point")) {
      slide.definition = PointNormalDefinition{vector(json["point"]), vector(json["normal"])};
    } else {
      slide.definition = EllipseDefinition{vector(json["center"]), vector(json["u"]), vector(json["v"])};
    }
    slides.push_back(slide);
  }
  return slides;
}

}  // namespace cagewright
