#include "provenance.hpp"

namespace subcert::reports {

const char* version() { return SUBCERT_VERSION; }
const char* commit() { return SUBCERT_COMMIT; }

}  // namespace subcert::reports
