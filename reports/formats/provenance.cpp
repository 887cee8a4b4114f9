#include "provenance.hpp"

namespace subcert::formats {

const char* version() { return SUBCERT_VERSION; }
const char* commit() { return SUBCERT_COMMIT; }
const char* date() { return SUBCERT_DATE; }

}  // namespace subcert::formats
