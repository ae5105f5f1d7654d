// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "host/file/file_error.h"
#include "host/workspace/script_command.h"

namespace cagewright::host {
namespace {

using Kind = ScriptArgument::Kind;

template <class Is>
bool all_of(const ScriptJson& json, const Is& is) {
  return json.is_array() && std::all_of(json.begin(), json.end(), is);
}

bool is_number(const ScriptJson& json) { return json.is_number(); }
bool is_whole(const ScriptJson& json) { return json.is_number_integer() && json >= 0; }
bool is_text(const ScriptJson& json) { return json.is_string(); }
bool is_object(const ScriptJson& json) { return json.is_object(); }
bool is_point(const ScriptJson& json) { return all_of(json, is_number) && json.size() == 3; }

bool is_of(Kind kind, const ScriptJson& json) {
  switch (kind) {
    case Kind::text:
      return is_text(json);
    case Kind::name_or_number:
      return is_text(json) || json.is_number_integer();
    case Kind::names:
      return is_text(json) || all_of(json, is_text);
    case Kind::number:
      return is_number(json);
    case Kind::whole:
      return is_whole(json);
    case Kind::boolean:
      return json.is_boolean();
    case Kind::value:
      return is_number(json) || json.is_boolean() || is_text(json);
    case Kind::point:
      return is_point(json);
    case Kind::points:
      return all_of(json, is_point);
    case Kind::factors:
      return is_number(json) || (all_of(json, is_number) && json.size() == 2);
    case Kind::axis:
      return is_text(json) || is_point(json);
    case Kind::size:
      return json.is_array() && json.size() == 2 && is_whole(json[0]) && is_whole(json[1]);
    case Kind::object:
      return is_object(json);
    case Kind::objects:
      return all_of(json, is_object);
  }
  return false;
}

}  // namespace

std::string script_kind_text(Kind kind) {
  switch (kind) {
    case Kind::text:
      return "text";
    case Kind::name_or_number:
      return "a name or a number";
    case Kind::names:
      return "a name or a list of names";
    case Kind::number:
      return "a number";
    case Kind::whole:
      return "a whole number";
    case Kind::boolean:
      return "true or false";
    case Kind::value:
      return "a number, true, false or a name";
    case Kind::point:
      return "[x, y, z]";
    case Kind::points:
      return "[[x, y, z], ...]";
    case Kind::factors:
      return "a number or [along u, along v]";
    case Kind::axis:
      return "\"u\", \"v\", \"normal\" or [x, y, z]";
    case Kind::size:
      return "[width, height]";
    case Kind::object:
      return "an object";
    case Kind::objects:
      return "a list of objects";
  }
  return "";
}

ScriptArguments::ScriptArguments(const ScriptJson& command, const std::string& name,
                                 const std::vector<ScriptArgument>& known)
    : command_(command), name_(name) {
  for (const auto& [key, value] : command.items()) {
    if (key == "command") continue;
    const auto found = std::ranges::find(known, key, [](const ScriptArgument& it) { return std::string(it.name); });
    if (found == known.end()) fail("there is no argument " + in_quotes(key));
    if (!is_of(found->kind, value)) fail(in_quotes(key) + " has to be " + script_kind_text(found->kind));
  }
  for (const ScriptArgument& argument : known) {
    if (argument.is_needed && !has(argument.name)) {
      fail("needs " + in_quotes(argument.name) + ", " + script_kind_text(argument.kind));
    }
  }
}

void ScriptArguments::fail(const std::string& what) const { throw ScriptError(name_ + ": " + what); }

std::string ScriptArguments::text(const char* name, const std::string& otherwise) const {
  return has(name) ? command_.at(name).get<std::string>() : otherwise;
}
double ScriptArguments::number(const char* name, double otherwise) const {
  return has(name) ? command_.at(name).get<double>() : otherwise;
}
bool ScriptArguments::flag(const char* name, bool otherwise) const {
  return has(name) ? command_.at(name).get<bool>() : otherwise;
}
Point3 ScriptArguments::point(const char* name) const { return command_.at(name).get<Point3>(); }
std::vector<Point3> ScriptArguments::points(const char* name) const {
  return command_.at(name).get<std::vector<Point3>>();
}
std::vector<std::string> ScriptArguments::names(const char* name) const {
  const ScriptJson& value = command_.at(name);
  if (value.is_string()) return {value.get<std::string>()};
  return value.get<std::vector<std::string>>();
}

std::string ScriptArguments::choice(const char* name, const std::vector<std::string>& choices,
                                    const std::string& otherwise) const {
  const std::string value = text(name, otherwise);
  if (std::ranges::find(choices, value) != choices.end()) return value;
  std::string list;
  for (const std::string& it : choices) list += (list.empty() ? "" : ", ") + it;
  fail(in_quotes(name) + " is one of " + list + ", not " + in_quotes(value));
}

}  // namespace cagewright::host
