// The command `libration`.
#include "program.hpp"

namespace {

// Before all other objects are initialised, which takes memory.
struct preparation {
    preparation() { libration::prepare_for_failures(); }
};
[[gnu::init_priority(101)]] const preparation prepared;

}  // namespace

int main(int argc, char** argv) { return libration::run_program(argc, argv); }
