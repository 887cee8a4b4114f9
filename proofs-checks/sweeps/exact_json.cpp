#include "exact_json.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <nlohmann/json.hpp>

namespace subcert::sweeps {

nlohmann::ordered_json exact_json(const Enclosure& enclosure) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (enclosure.lower) json["lower"] = to_text(*enclosure.lower);
  if (enclosure.upper) json["upper"] = to_text(*enclosure.upper);
  return json;
}

Enclosure enclosure_from(const nlohmann::ordered_json& json) {
  Enclosure enclosure;
  if (!json.is_object()) fail(ErrorKind::domain, "not an enclosure: {}", json.dump().substr(0, 60));
  for (const auto& [key, end] : json.items()) {
    const auto value = end.is_string() ? parse_rational(end.get<std::string>()) : std::nullopt;
    if (!value || (key != "lower" && key != "upper"))
      fail(ErrorKind::domain, "not an enclosure: {}", json.dump().substr(0, 60));
    (key == "lower" ? enclosure.lower : enclosure.upper) = *value;
  }
  require(enclosure.is_canonical(), "not an enclosure: the lower end is above the upper one");
  return enclosure;
}

}  // namespace subcert::sweeps
