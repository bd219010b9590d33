// The command `libration`.
#include "program.hpp"

int main(int argc, char** argv) { return libration::run_program(argc, argv); }
