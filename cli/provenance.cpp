#include "provenance.hpp"

namespace subcert::cli {

const char* commit() { return SUBCERT_COMMIT; }

facts::Json provenance() { return {{"version", SUBCERT_VERSION}, {"commit", commit()}, {"schema", json_schema}}; }

}  // namespace subcert::cli
