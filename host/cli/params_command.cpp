// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/params_command.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "host/cli/exit_code.h"
#include "host/cli/text.h"
#include "host/plugin_client/find_plugin.h"
#include "host/plugin_client/plugin.h"

namespace cagewright::host {
namespace {

using Json = nlohmann::ordered_json;

std::string type_text(const Parameter& parameter) {
  switch (parameter.type) {
    case CGW_PARAM_REAL:
      return "real";
    case CGW_PARAM_INTEGER:
      return "integer";
    case CGW_PARAM_BOOLEAN:
      return "boolean";
    case CGW_PARAM_CHOICE:
      return "choice";
    default:
      return "unknown";
  }
}

// As --set takes it.
std::string value_text(const Parameter& parameter, double value) {
  if (parameter.type == CGW_PARAM_BOOLEAN) return value != 0 ? "true" : "false";
  if (parameter.type == CGW_PARAM_CHOICE && value >= 0 && value < static_cast<double>(parameter.choices.size())) {
    return parameter.choices[static_cast<std::size_t>(value)];
  }
  return number_text(value);
}

std::string range_text(const Parameter& parameter) {
  if (parameter.type == CGW_PARAM_BOOLEAN) return "true, false";
  if (parameter.type != CGW_PARAM_CHOICE) {
    return number_text(parameter.minimum) + " to " + number_text(parameter.maximum);
  }
  std::string text;
  for (const std::string& choice : parameter.choices) text += (text.empty() ? "" : ", ") + choice;
  return text;
}

Json value_json(const Parameter& parameter, double value) {
  if (parameter.type == CGW_PARAM_BOOLEAN) return value != 0;
  if (parameter.type == CGW_PARAM_CHOICE) return value_text(parameter, value);
  if (parameter.type == CGW_PARAM_INTEGER && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;  // infinity, "no limit", is dumped as null
}

Json to_json(const Parameter& parameter) {
  Json json = {{"id", parameter.id},       {"type", type_text(parameter)},
               {"label", parameter.label}, {"doc", parameter.doc},
               {"unit", parameter.unit},   {"default", value_json(parameter, parameter.default_value)}};
  if (parameter.type == CGW_PARAM_CHOICE) {
    json["choices"] = parameter.choices;
  } else if (parameter.type != CGW_PARAM_BOOLEAN) {
    json["minimum"] = value_json(parameter, parameter.minimum);
    json["maximum"] = value_json(parameter, parameter.maximum);
  }
  return json;
}

void print_table(const std::vector<Parameter>& parameters) {
  std::vector<std::vector<std::string>> rows = {{"parameter", "type", "default", "range", "unit", "meaning"}};
  for (const Parameter& parameter : parameters) {
    rows.push_back({parameter.id, type_text(parameter), value_text(parameter, parameter.default_value),
                    range_text(parameter), parameter.unit, parameter.doc});
  }
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      std::size_t width = 0;
      for (const std::vector<std::string>& other : rows) width = std::max(width, other[column].size());
      if (column + 1 == row.size()) width = 0;
      std::cout << std::left << std::setw(static_cast<int>(width)) << row[column]
                << (column + 1 == row.size() ? "\n" : "  ");
    }
  }
}

}  // namespace

int run_params(const ParamsCommand& command) {
  const std::vector<Parameter> parameters = Plugin::load(find_plugin(command.plugin))->parameters();
  if (!command.as_json) {
    print_table(parameters);
    return exit_done;
  }
  Json json = Json::array();
  for (const Parameter& parameter : parameters) json.push_back(to_json(parameter));
  std::cout << json.dump(2) << "\n";
  return exit_done;
}

}  // namespace cagewright::host
