#include "names.hpp"

namespace libration::import {

namespace {

const std::set<std::string>& reserved_words() {
    static const std::set<std::string> words{"t",         "T",
                                             "e",         "i",
                                             "n",         "pi",
                                             "inf",       "deg",
                                             "time",      "digits",
                                             "rigour",    "when",
                                             "stop",      "up",
                                             "down",      "exact",
                                             "variable",  "invariant",
                                             "and",       "or",
                                             "not",       "true",
                                             "false",     "if",
                                             "abs",       "sign",
                                             "max",       "min",
                                             "heaviside", "floor",
                                             "square",    "sawtooth",
                                             "exp",       "log",
                                             "sqrt",      "sin",
                                             "cos",       "tan",
                                             "asin",      "acos",
                                             "atan",      "sinh",
                                             "cosh",      "tanh",
                                             "asinh",     "acosh",
                                             "atanh",     "log10",
                                             "log2",      "exp2",
                                             "cbrt",      "sinc",
                                             "expm1",     "log1p",
                                             "erf",       "erfc",
                                             "bessel_j",  "bessel_y",
                                             "bessel_i",  "bessel_k",
                                             "airy_ai",   "airy_ai_prime",
                                             "airy_bi",   "airy_bi_prime",
                                             "lambertw",  "exprel",
                                             "cosrel"};
    return words;
}

}  // namespace

std::string problem_names::free(const std::string& wish) {
    std::string name = wish.starts_with("_") ? "x" + wish : wish;
    while (reserved_words().contains(name) || taken_.contains(name)) {
        name += "_";
    }
    taken_.insert(name);
    return name;
}

const std::string& problem_names::of(const std::string& id) {
    const auto found = names_.find(id);
    return found != names_.end() ? found->second : names_.emplace(id, free(id)).first->second;
}

}  // namespace libration::import
