#include "libration/problem/problem.hpp"

#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"

namespace libration {

problem::problem(const std::string& text)
    : equations_(ode::parse(text.find('=') != std::string::npos ? text : std::string(problem_text(text)))) {}

problem& problem::set(const std::string& change) {
    equations_ = ode::changed(std::move(equations_), change);
    return *this;
}

}  // namespace libration
