#include "toml_fields.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace subcert {

void only_keys(const toml::table& table, const Keys& known) {
  for (const auto& [key, node] : table)
    if (std::find(known.begin(), known.end(), key.str()) == known.end())
      throw FileError(place_of(key.source()), fmt::format("unknown key '{}'; expected one of {}", printable(key.str()),
                                                          fmt::join(known, ", ")));
}

std::string text_of(const toml::node& node) {
  if (!node.is_string()) throw FileError(place_of(node), "expected a text in quotes");
  std::string result;
  bool broken = true;
  for (const char c : node.as_string()->get()) {
    if (c == '\n') broken = true;
    if (broken && (c == '\n' || c == ' ')) continue;
    if (broken) {
      while (!result.empty() && result.back() == ' ') result.pop_back();
      if (!result.empty()) result += ' ';
    }
    broken = false;
    result += c;
  }
  return result;
}

std::string optional_text(const toml::table& table, const std::string& key) {
  const toml::node* node = table.get(key);
  return node ? text_of(*node) : "";
}

std::string needed_text(const toml::table& table, const std::string& key) {
  if (!table.get(key)) throw FileError(place_of(table), "expected the key '" + key + "'");
  return text_of(*table.get(key));
}

std::vector<std::string> optional_texts(const toml::table& table, const std::string& key) {
  std::vector<std::string> result;
  const toml::node* node = table.get(key);
  if (!node) return result;
  if (!node->is_array()) throw FileError(place_of(*node), "'" + key + "' takes a list of texts");
  for (const toml::node& text : *node->as_array()) result.push_back(text_of(text));
  return result;
}

std::map<std::string, std::string> texts_in(const toml::table& table, const std::string& key) {
  std::map<std::string, std::string> result;
  const toml::node* node = table.get(key);
  if (!node) return result;
  if (!node->is_table()) throw FileError(place_of(*node), "expected the table [" + key + "]");
  for (const auto& [name, text] : *node->as_table()) result.emplace(name.str(), text_of(text));
  return result;
}

std::vector<const toml::table*> tables_of(const toml::table& table, const std::string& key) {
  std::vector<const toml::table*> result;
  const toml::node* node = table.get(key);
  if (!node) return result;
  if (!node->is_array()) throw FileError(place_of(*node), "'" + key + "' takes a list of tables");
  for (const toml::node& entry : *node->as_array()) {
    if (!entry.is_table()) throw FileError(place_of(entry), "'" + key + "' takes a list of tables");
    result.push_back(entry.as_table());
  }
  return result;
}

namespace {

std::string toml_value(const toml::node& value) {
  if (const auto* text = value.as_string()) {
    std::string quoted = "\"";
    for (const char c : text->get()) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte < 0x20 || byte == 0x7f)
        quoted += fmt::format("\\u{:04X}", byte);
      else
        quoted.append(c == '"' || c == '\\' ? "\\" : "") += c;
    }
    return quoted + '"';
  }
  if (const auto* integer = value.as_integer()) return std::to_string(integer->get());
  if (const auto* answer = value.as_boolean()) return answer->get() ? "true" : "false";
  if (!value.is_array()) throw FileError(place_of(value), "expected a text, an integer, true, false or a list");
  std::vector<std::string> parts;
  for (const toml::node& part : *value.as_array()) parts.push_back(toml_value(part));
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

}  // namespace

std::string toml_line(std::string_view key, const toml::node& value) {
  return fmt::format("{} = {}\n", key, toml_value(value));
}

std::string filled(std::string text, const std::map<std::string, std::string>& values) {
  for (const auto& [name, content] : values) {
    const std::string field = "{" + name + "}";
    for (std::size_t at = text.find(field); at != std::string::npos; at = text.find(field, at + content.size()))
      text.replace(at, field.size(), content);
  }
  return text;
}

}  // namespace subcert
