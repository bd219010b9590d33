// Radii of convergence and positions of singularities, as the program prints them.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "attack/facts.hpp"
#include "attack/program.hpp"
#include "attack/question.hpp"

namespace libration::attack {

namespace {

// Distance up to which closed forms list all singularities.
constexpr double all_listed = 50;

truth modulus_of_place(const place& at) {
    return [=] { return mpfr(hypot(at.re(), at.im())); };
}

truth nearest(const solved_problem& problem) {
    truth best;
    for (double within = all_listed; !best; within *= 8) {
        for (const component& each : problem.parts) {
            for (const place& at : each.singularities(within)) {
                const truth here = modulus_of_place(at);
                if (!best || rough(here) < rough(best)) {
                    best = here;
                }
            }
        }
    }
    return best;
}

solved_problem any_singular(choices& next) {
    const component u = with_singularities(next);
    switch (next.below(4)) {
        case 0:
        case 1: return alone(u);
        case 2: return beside({u, with_singularities(next)});
        default: return mixed(u, with_singularities(next), next);
    }
}

// The facts in an error message: bounds of the radius.
verdict judged_radius_refusal(const std::string& message, const truth& radius) {
    const auto facts = facts_of(message);
    for (const auto& lower : {facts.nothing_within, facts.radius_at_least}) {
        if (lower && judged_bounds(*lower, "", radius) == verdict::wrong) {
            return verdict::wrong;
        }
    }
    const auto& upper = facts.radius_at_most;
    return upper && judged_bounds("", *upper, radius) == verdict::wrong ? verdict::wrong : verdict::refused;
}

mpfr typed(const std::string& decimal) { return real(typed_fraction(decimal)); }

// A row of the map: position_re,position_im,modulus,uncertainty,..,rigour,unknown.
struct map_row {
    explicit map_row(const std::string& line)
        : re(cell_of(line, 0)),
          im(cell_of(line, 1)),
          uncertainty(cell_of(line, 3)),
          unknown(cell_of(line, 8)),
          proved(cell_of(line, 7) == "proved") {}

    bool shows(const place& at) const {
        const precision_scope scope(400);
        const mpfr off = hypot(mpfr(at.re() - typed(re)), mpfr(at.im() - typed(im)));
        return off <= typed(uncertainty);
    }

    std::string re, im, uncertainty, unknown;
    bool proved;
};

// Each row has a singularity of its unknown at its position, and every singularity has a row.
void judge_map(const solved_problem& problem, double within, const program_answer& answer, outcome& result) {
    std::vector<map_row> rows;
    for (std::size_t i = 1; i < answer.lines.size(); ++i) {
        rows.emplace_back(answer.lines[i]);
    }
    for (const map_row& row : rows) {
        bool shown = false;
        for (std::size_t i = 0; i < problem.columns.size(); ++i) {
            const auto all = problem.parts[i].singularities(std::max(all_listed, 2 * within));
            shown = shown || (problem.columns[i] == row.unknown &&
                              std::ranges::any_of(all, [&](const place& at) { return row.shows(at); }));
        }
        const verdict here = row.proved ? verdict::right : verdict::refused;
        result.add(shown ? here : verdict::wrong,
                   fmt::format("{} singular within {} of {} + {}i", row.unknown, row.uncertainty, row.re, row.im));
    }
    for (std::size_t i = 0; i < problem.columns.size(); ++i) {
        for (const place& at : problem.parts[i].singularities(within * (1 - 1e-9))) {
            const bool inside = rough(modulus_of_place(at)) < within * (1 - 1e-9);
            const bool shown = std::ranges::any_of(rows, [&](const map_row& row) { return row.shows(at); });
            if (inside && !shown) {
                result.add(verdict::wrong, fmt::format("no row for the singularity of {} at {} + {}i",
                                                       problem.columns[i], rough(at.re), rough(at.im)));
            }
        }
    }
}

}  // namespace

outcome ask_radius(choices& next) {
    const solved_problem problem = any_singular(next);
    const truth radius = nearest(problem);
    outcome result;
    result.command = announce(
        fmt::format("libration radius --problem \"{}\" --prove --digits {}", problem.text, next.between(1, 4)));
    const auto answer = answer_of(result.command + " --format csv");
    if (!answer.done) {
        result.add(judged_radius_refusal(answer.message, radius), answer.message);
        return result;
    }
    const std::string& row = answer.lines.at(1);
    const std::string lower = cell_of(row, 0);
    result.add(lower == "inf" ? verdict::wrong : judged_bounds(lower, cell_of(row, 1), radius), "bounds " + row);
    return result;
}

outcome ask_position(choices& next) {
    const component u = with_singularities(next);
    const solved_problem problem = next.one_in(2) ? beside({u, with_singularities(next)}) : alone(u);
    const double within = std::ceil(rough(nearest(problem)) * 1500) / 1000;
    outcome result;
    result.command = announce(fmt::format("libration singularities --problem \"{}\" --within {} --prove --digits {}",
                                          problem.text, within, next.between(3, 12)));
    const auto answer = answer_of(result.command + " --format csv");
    if (answer.done) {
        judge_map(problem, within, answer, result);
    } else {
        result.add(judged_radius_refusal(answer.message, nearest(problem)), answer.message);
    }
    return result;
}

}  // namespace libration::attack
