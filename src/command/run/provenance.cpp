#include "run/provenance.hpp"

#include <fmt/format.h>
#include <gmp.h>
#include <mpfr.h>

#include <boost/version.hpp>

#include "libration/scalar/ball/product_self_test.hpp"
#include "libration/scalar/quad.hpp"
#include "libration/scalar/vector_instructions.hpp"
#include "version.hpp"

namespace libration {

std::vector<std::pair<std::string, std::string>> provenance() {
    return {{"libration", std::string(build::version)},
            {"commit", std::string(build::commit)},
            {"compiler", std::string(build::compiler)},
            {"Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
            {"MPFR", mpfr_get_version()},
            {"MPFR thread-safe", mpfr_buildopt_tls_p() != 0 ? "yes" : "no"},
            {"GMP", gmp_version},
            {"quad", LIBRATION_HAS_FLOAT128 != 0 ? "__float128 (libquadmath)" : "cpp_bin_float_quad"},
            {"ball arithmetic", flint_versions()},
            {"long products", describe_flint_products()},
            {"vectors", vector_instructions().front()}};
}

std::string version_text() {
    std::string text;
    for (const auto& [name, value] : provenance()) {
        text += fmt::format("{}{} {}", text.empty() ? "" : "\n", name, value);
    }
    return text;
}

std::string program_identity() {
    const std::string changes = build::changes.empty() ? "" : fmt::format(", changed {}", build::changes);
    return fmt::format("{} ({}{})", build::version, build::commit, changes);
}

}  // namespace libration
