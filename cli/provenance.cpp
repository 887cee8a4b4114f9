#include "provenance.hpp"

#include <subcert/reports/provenance.hpp>

namespace subcert::cli {

facts::Json provenance() {
  return {{"version", reports::version()}, {"commit", reports::commit()}, {"schema", json_schema}};
}

}  // namespace subcert::cli
