#include "found_eigenvalues.hpp"

#include "libration/problem/find.hpp"
#include "libration/problem/known_facts.hpp"
#include "problem/event_options.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"
#include "text/input_error.hpp"

namespace libration {

found_solutions found_eigenvalues(const eigenvalue_request& typed, const problem_options& problem) {
    constexpr int most_eigenvalues = 1000;
    for (const std::string& each : typed.conditions) {
        if (!is_at_infinity(each)) {
            throw input_error("--such-that", each, "is not at infinity",
                              "write conditions at points, as psi(0) = 0, in --problem");
        }
    }
    const libration::problem of(problem.equations_with_open_starts({{"--eigenvalue", typed.energy + " = 1"}}));
    const long count = typed.count ? positive_count("--count", *typed.count, most_eigenvalues, "eigenvalues") : 1;
    progress shown("find", 1);
    const request how{
        .scalar = {scalar_kind::proved, typed.digits}, .check = typed.check, .reached = [&](double time, long bits) {
            shown.reached(time, bits);
            check_time();
        }};
    found_solutions found;
    found.add({}, [&] { return find_eigenvalues(of, typed.energy, typed.conditions, count, how); });
    return found;
}

}  // namespace libration
