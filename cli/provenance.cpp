#include "provenance.hpp"

#include <subcert/proofs-checks/certificates/identity.hpp>
#include <subcert/reports/formats/provenance.hpp>
#include <subcert/schemes/data/runtime/input.hpp>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <set>

namespace subcert::cli {
namespace {

using facts::Json;

std::mutex reading;
Json recorded = Json::array();
std::set<std::string> files;  ///< the names of `recorded`, as they were given

Json input_json(const std::string& name, std::string_view content) {
  return {{"name", name}, {"sha256", content_id(content)}};
}

/// A scheme that is a file of rules is that file.
void add_scheme(Json& inputs, const Json& of) {
  for (const char* key : {"scheme", "family"})
    if (const auto text = of.find(key);
        text != of.end() && text->is_string() && !files.contains(text->get<std::string>()))
      inputs.push_back(input_json(text->get<std::string>(), text->get<std::string>() + "\n"));
}

}  // namespace

void record_inputs() {
  runtime::set_input_listener([](const std::string& name, std::string_view content) {
    Json file = input_json(std::filesystem::path(name).filename().string(), content);
    const std::scoped_lock lock(reading);
    recorded.push_back(std::move(file));
    files.insert(name);
  });
}

Json provenance(const Json& answer) {
  Json inputs = Json::array();
  const std::scoped_lock lock(reading);
  add_scheme(inputs, answer);
  if (const auto schemes = answer.find("schemes"); schemes != answer.end())
    for (const Json& one : *schemes) add_scheme(inputs, one);
  for (const Json& file : recorded) inputs.push_back(file);
  return {{"version", formats::version()},
          {"commit", formats::commit()},
          {"date", formats::date()},
          {"schema", json_schema},
          {"inputs", std::move(inputs)}};
}

}  // namespace subcert::cli
