#include "equation/problem_series.hpp"

#include <utility>
#include <vector>

#include "equation/complex_times.hpp"
#include "libration/digits/proved/printed_values.hpp"
#include "libration/digits/proved/two_proofs.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/proved/problem_coefficients.hpp"
#include "libration/scalar/error.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

// The names of the columns: unknowns, their parts about a complex point.
std::vector<std::string> names_of_columns(const ode::explicit_system& system, bool parts) {
    std::vector<std::string> names;
    for (const auto& each : system.unknowns()) {
        if (parts) {
            names.push_back(each.name + "_re");
            names.push_back(each.name + "_im");
        } else {
            names.push_back(each.name);
        }
    }
    return names;
}

// The exponent of coefficient n of powers of s^(1/root).
std::string exponent_text(long n, int root) {
    const rational power(n, root);
    return power.str();
}

table series_table(const problem_series_request& request, const std::vector<std::string>& names,
                   const std::vector<printed_number>& values, bool proved, int root) {
    std::vector<column> columns{{"n", ""}};
    for (const std::string& each : names) {
        columns.push_back({each, ""});
    }
    for (const std::string& each : names) {
        if (proved) {
            columns.push_back({each + "_uncertainty", ""});
        }
    }
    if (root > 1) {
        columns.push_back({"power", ""});
    }
    table data(std::move(columns));
    for (std::size_t at = 0; at < values.size(); at += names.size()) {
        const long n = request.first + static_cast<long>(at / names.size());
        table_row_cells row{n};
        for (std::size_t i = 0; i < names.size(); ++i) {
            row.push_back(number_cell(values[at + i].text));
        }
        for (std::size_t i = 0; proved && i < names.size(); ++i) {
            row.push_back(number_cell(values[at + i].uncertainty));
        }
        if (root > 1) {
            row.emplace_back(exponent_text(n, root));
        }
        data.add_row(std::move(row));
    }
    return data;
}

ode::complex_constant point_of_series(const std::string& at) {
    try {
        return ode::parse_complex_constant(at);
    } catch (const error& problem) {
        throw input_error("--at", at, problem.reason(), "write a time as 1/2, or a complex one as 1+2i");
    }
}

// If the path to the point ends before it, the message names the option.
template <class Print>
auto on_the_way_to(const problem_series_request& request, const Print& print) {
    try {
        return print();
    } catch (const error& problem) {
        if (problem.subject() != "time" && problem.subject() != "point") {
            throw;
        }
        throw input_error(
            request.via ? "--at with --via" : "--at", *request.at, problem.reason(),
            "choose a point nearer to the initial point, or a path around the singularity, --via \"1+i,2+i\"");
    }
}

// The arguments of the options as a point and the corners of the path to it.
ode::coefficient_request read_request(const problem_series_request& request) {
    const auto point = request.at ? std::optional(point_of_series(*request.at)) : std::nullopt;
    if (request.via && !point) {
        throw input_error("--via", *request.via, "requires --at", "add --at POINT");
    }
    return {request.system, request.first, request.order, point, corners_of(request.via)};
}

void check_coefficients(const ode::coefficient_request& request, long digits,
                        const std::vector<proved_decimal>& first) {
    const auto second =
        ode::proved_coefficients(request, digits + ode::more_digits_of_second_proof, ode::proof_route::second());
    const std::size_t unknowns = request.system.unknowns().size();
    for (std::size_t i = 0; i < first.size(); ++i) {
        require_agreement(first[i], second.values[i],
                          "coefficient " + std::to_string(request.first + static_cast<long>(i / unknowns)) + " of " +
                              request.system.unknowns()[i % unknowns].name);
    }
}

std::vector<printed_number> printed_fractions(const std::vector<rational>& fractions) {
    std::vector<printed_number> values;
    values.reserve(fractions.size());
    for (const rational& each : fractions) {
        values.push_back({each.str(), ""});
    }
    return values;
}

}  // namespace

table problem_coefficients(const problem_series_request& request, const arithmetic& numbers, bool check) {
    const ode::coefficient_request read = read_request(request);
    const bool proved = numbers.scalar.kind == scalar_kind::proved;
    if (proved && read.complex()) {
        throw input_error("--scalar", numbers.scalar.name(),
                          "cannot prove a path in the complex plane to --at '" + *request.at + "'",
                          "use mpfr:" + std::to_string(numbers.scalar.digits));
    }
    if (proved) {
        const auto checked = checked_products(check);
        const auto found = ode::proved_coefficients(read, numbers.digits);
        if (check) {
            check_coefficients(read, numbers.digits, found.values);
        }
        return series_table(request, names_of_columns(request.system, false), found.values, true, found.root);
    }
    const auto found = on_the_way_to(request, [&] { return ode::rounded_coefficients(numbers.scalar, read); });
    return series_table(request, names_of_columns(request.system, found.complex), printed(found.values, numbers.digits),
                        false, found.root);
}

problem_lists lists_of_problem(const problem_series_request& request, long digits) {
    const auto found = on_the_way_to(request, [&] {
        return ode::rounded_coefficients({scalar_kind::arbitrary, digits}, read_request(request));
    });
    const std::size_t unknowns = request.system.unknowns().size();
    const std::size_t parts = found.complex ? 2 : 1;
    problem_lists result{{}, found.root};
    for (std::size_t i = 0; i < unknowns; ++i) {
        problem_list list{request.system.unknowns()[i].name, {}};
        for (std::size_t part = 0; part < parts; ++part) {
            std::vector<mpfr> values;
            for (std::size_t at = i * parts + part; at < found.values.size(); at += unknowns * parts) {
                values.push_back(found.values[at]);
            }
            list.parts.emplace_back(std::move(values));
        }
        result.unknowns.push_back(std::move(list));
    }
    return result;
}

table problem_fractions(const problem_series_request& request) {
    if (request.at) {
        throw input_error("--at", *request.at,
                          "is not a point for fractions, which a solution has at its initial point only",
                          "leave it out");
    }
    const auto found = ode::exact_coefficients(read_request(request));
    return series_table(request, names_of_columns(request.system, false), printed_fractions(found.values), false,
                        found.root);
}

}  // namespace libration
