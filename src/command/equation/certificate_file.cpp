#include "equation/certificate_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>

#include "libration/ode/rigorous/certificate/certificate.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* certificate_option = "--certificate";

std::string compressed(const std::string& text) {
    uLongf size = compressBound(text.size());
    std::string result(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                  text.size(), Z_BEST_COMPRESSION) != Z_OK) {
        throw std::runtime_error("zlib does not compress a text in memory");
    }
    result.resize(size);
    return result;
}

rational fraction_of(const std::string& path, const exact& time) {
    const auto q = time.has_periods() ? std::nullopt : as_expression(time).fraction();
    if (!q) {
        throw input_error(certificate_option, path, "is for times that are fractions, and " + time.text + " is not one",
                          "choose fractions as times");
    }
    return *q;
}

std::size_t column_named(const table& states, const std::string& name) {
    const auto found = std::ranges::find(states.columns(), name, &column::name);
    return static_cast<std::size_t>(found - states.columns().begin());
}

std::vector<ode::claimed_value> claims_of(const std::string& path, const ode::explicit_system& system,
                                          const std::vector<exact>& times, const table& states, long digits) {
    std::vector<ode::claimed_value> claims;
    const auto names = ode::names_of_state(system);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const rational time = fraction_of(path, times[i]);
        for (std::size_t place = 0; place < names.size(); ++place) {
            const std::string decimal = states.rows()[i][column_named(states, names[place])].text();
            claims.push_back({time, place, ode::within_one_unit(decimal, digits)});
        }
    }
    return claims;
}

// The progress of the run that is going on.
void report(const request& how, const ball& reached, long bits, double farthest) {
    const double time = midpoint_of(reached).convert_to<double>();
    if (how.reached) {
        how.reached(time, bits);
    }
    if (how.progress) {
        how.progress(farthest == 0 ? 0 : std::clamp(time / farthest, 0.0, 1.0));
    }
}

}  // namespace

std::string certificate_of_states(const std::string& path, const ode::explicit_system& system,
                                  const std::vector<exact>& times, const table& states, const request& how) {
    const auto claims = claims_of(path, system, times, states, how.printed_digits());
    double farthest = 0;
    for (const ode::claimed_value& each : claims) {
        const auto time = each.time.convert_to<double>();
        farthest = std::abs(time) > std::abs(farthest) ? time : farthest;
    }
    try {
        return compressed(
            ode::certificate_of(system, claims, how.printed_digits(),
                                [&](const ball& reached, long bits) { report(how, reached, bits, farthest); }));
    } catch (const error& problem) {
        if (problem.subject() != "certificate" || problem.kind() != error_kind::argument) {
            throw;
        }
        throw input_error(std::string(certificate_option) + " '" + path + "' " + problem.reason());
    }
}

void write_certificate(const std::string& path, const std::string& content) {
    try {
        write_whole_file(path, content);
    } catch (const std::runtime_error& problem) {
        throw input_error(certificate_option, path, std::string("cannot be written (") + problem.what() + ")",
                          "choose a file in a folder that exists and that you may write in");
    }
}

}  // namespace libration
