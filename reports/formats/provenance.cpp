#include "provenance.hpp"

namespace subcert::formats {

const char* version() { return SUBCERT_VERSION; }
const char* commit() { return SUBCERT_COMMIT; }

}  // namespace subcert::formats
