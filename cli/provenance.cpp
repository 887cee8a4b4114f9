#include "provenance.hpp"

#include <subcert/reports/formats/provenance.hpp>

namespace subcert::cli {

facts::Json provenance() {
  return {{"version", formats::version()}, {"commit", formats::commit()}, {"schema", json_schema}};
}

}  // namespace subcert::cli
