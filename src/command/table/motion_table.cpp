#include "table/motion_table.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "libration/digits/proved_decimals.hpp"
#include "libration/pendulum/condition.hpp"
#include "libration/pendulum/energy.hpp"
#include "libration/pendulum/proved_states.hpp"
#include "run/parallel.hpp"
#include "table/motion_points.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace pendulum;

namespace {

using rows_of_motion = std::vector<table_row_cells>;

// On the separatrix omega decreases like exp(-t), below every exponent.
proved_states::state_text state_at(proved_states& states, const exact& time, const std::string& typed) {
    try {
        return states.at(time);
    } catch (const error& problem) {
        if (problem.kind() != error_kind::range) {
            throw;
        }
        throw input_error("--times", typed, "has '" + time.text + "', where omega is too small to be printed",
                          "choose times closer to 0");
    }
}

// The condition numbers of one motion, as verify prints them.
class condition_texts {
public:
    explicit condition_texts(const grid_motion& of) : of_(of) {}

    std::string at(const exact& time) {
        const long bits = conditioned_motion::bits_for(of_.of, exponent_of(time));
        const long start = (decimal_digits(bits) + 9) / 10 * 10;
        constexpr int attempts = 5;
        return with_growing_precision(
            {0, start, attempts * start, digit_growth::by_first}, "the condition at time " + time.text,
            [&](const precision_run& run) -> std::optional<std::string> {
                const auto& here = made_.try_emplace(run.more, of_.typed, of_.of).first->second;
                const auto condition = here.at(time, here.of().at(time));
                return condition ? to_decimal(*condition, 3) : "inf";
            });
    }

private:
    // An e with |t| max(1, |omega|) < 2^e: the phase that a relative step of an input is multiplied with. A multiple
    // of a period is one of ordinary size in this, however fast the motion.
    long exponent_of(const exact& time) const {
        if (time.is_zero()) {
            return 0;
        }
        const precision_scope scope(20);
        if (time.only_periods()) {
            return binary_exponent(from_rational<mpfr>(time.coefficient)) + 3;
        }
        const mpfr elapsed = from_exact<mpfr>(time.without_periods()) / time_unit<mpfr>(of_.of);
        const long of_energy = binary_exponent(energies<mpfr>(of_.of).energy);
        const long of_rest = binary_exponent(elapsed) + std::max(0L, of_energy / 2 + 2);
        return time.has_periods() ? std::max(of_rest, binary_exponent(from_rational<mpfr>(time.periods())) + 3)
                                  : of_rest;
    }

    const grid_motion& of_;
    std::map<long, conditioned_motion> made_;
};

std::vector<column> columns_of(const motion_points& points, input_style style) {
    const bool seconds = points.seconds;
    const std::string of_time = seconds ? "s" : "sqrt(l/g)";
    const std::string speed = seconds ? "rad/s" : "sqrt(g/l)";
    std::vector<column> columns{{"energy", "in m g l"}, {"gap", "2 - energy"}};
    if (points.theta0) {
        columns.push_back({"theta0", "rad, at time 0"});
    }
    if (points.omega0) {
        columns.push_back({"omega0", speed + ", at time 0"});
    }
    if (points.direction) {
        columns.push_back({"direction", "sign of omega at time 0 where omega is not 0"});
    }
    columns.insert(columns.end(), {{"time", of_time},
                                   {"theta", "rad"},
                                   {"omega", speed},
                                   {"period", of_time},
                                   {"tstar", of_time + ", from the top to the bottom"},
                                   {"radius", of_time + ", of convergence about the top; about the bottom at energy 2"},
                                   {"condition",
                                    "(|t omega| + sum |x dtheta/dx|)/max(1, |theta|) over the typed numbers "
                                    "x, heuristic, three digits"}});
    if (style == input_style::typed) {
        columns.insert(columns.end(), {{"digits", "significant digits"}, {"rigour", "of all but the condition"}});
        columns.push_back({"time_typed", "as typed"});
        columns.insert(columns.end(), {{"energy_typed", "as typed"}, {"gap_typed", "as typed"}});
        if (points.theta0) {
            columns.push_back({"theta0_typed", "as typed"});
        }
        if (points.omega0) {
            columns.push_back({"omega0_typed", "as typed"});
        }
    }
    return columns;
}

// What the rows of one motion share: the cells before the time, and those behind omega.
class motion_rows {
public:
    motion_rows(const motion_block& block, const motion_points& points, long digits, input_style style)
        : block_(block),
          of_(block.motion),
          points_(points),
          digits_(digits),
          style_(style),
          states_(of_.of, digits),
          conditions_(of_) {}

    rows_of_motion all() {
        const auto front = front_cells();
        const auto constants =
            states_.constants({motion_constant::period, motion_constant::effective_period, motion_constant::radius});
        rows_of_motion result;
        result.reserve(block_.times.size());
        for (const exact& time : block_.times) {
            const auto state = state_at(states_, time, block_.said);
            table_row_cells row = front;
            row.insert(row.end(), {number_cell(time_text(time)), cell::number(state.theta, digits_),
                                   cell::number(state.omega, digits_)});
            for (const proved_decimal& each : constants) {
                row.push_back(number_cell(each.text));
            }
            row.push_back(number_cell(conditions_.at(time)));
            if (style_ == input_style::typed) {
                row.insert(row.end(), {cell(digits_), cell("proved"), cell(time.text)});
                const auto typed = typed_cells();
                row.insert(row.end(), typed.begin(), typed.end());
            }
            result.push_back(std::move(row));
        }
        return result;
    }

private:
    long more_digits() const { return digits_ + more_input_digits; }

    table_row_cells front_cells() {
        table_row_cells cells = energy_cells();
        for (const auto& [shown, number] :
             {std::pair{points_.theta0, &of_.typed.theta0}, {points_.omega0, &of_.typed.omega0}}) {
            if (shown) {
                cells.push_back(*number ? number_cell(decimal_text(**number, more_digits())) : cell());
            }
        }
        if (points_.direction) {
            const bool decimals = style_ != input_style::typed && !block_.direction.empty();
            cells.emplace_back(decimals ? (of_.typed.direction < 0 ? "-1" : "1") : block_.direction);
        }
        return cells;
    }

    // What was typed of the motion; empty where it was not.
    table_row_cells typed_cells() const {
        table_row_cells cells{of_.texts ? of_.texts->energy_typed : "", of_.texts ? of_.texts->gap_typed : ""};
        for (const auto& [shown, number] :
             {std::pair{points_.theta0, &of_.typed.theta0}, {points_.omega0, &of_.typed.omega0}}) {
            if (shown) {
                cells.emplace_back(*number ? (*number)->text : "");
            }
        }
        return cells;
    }

    table_row_cells energy_cells() {
        const auto& energy = of_.of.energy();
        if (!energy) {
            const auto proved = states_.constants({motion_constant::energy, motion_constant::gap});
            return {number_cell(proved[0].text), number_cell(proved[1].text)};
        }
        const auto text = [&](const rational& value) {
            return number_cell(decimal_text(exactly(value), more_digits()));
        };
        // A typed decimal is kept unchanged.
        if (of_.texts && style_ == input_style::typed) {
            const bool by_gap = of_.texts->energy_typed.empty();
            const rational gap = 2 - *energy;
            return {by_gap || !to_finite_decimal(*energy) ? text(*energy) : number_cell(of_.texts->energy),
                    !by_gap || !to_finite_decimal(gap) ? text(gap) : number_cell(of_.texts->gap)};
        }
        return {text(*energy), text(rational(2 - *energy))};
    }

    std::string time_text(const exact& time) {
        if (time.has_periods() && !time.is_zero()) {
            return states_.time_text(time, more_digits());
        }
        return style_ == input_style::typed ? decimal_of(time, more_digits()) : decimal_text(time, more_digits());
    }

    const motion_block& block_;
    const grid_motion& of_;
    const motion_points& points_;
    long digits_;
    input_style style_;
    proved_states states_;
    condition_texts conditions_;
};

}  // namespace

std::string decimal_text(const exact& number, long digits) {
    if (number.is_fraction() || number.is_zero()) {
        if (const auto finite = to_finite_decimal(number.coefficient)) {
            return *finite;
        }
    }
    return proved_value(digits, [&] { return from_exact<ball>(number); }).text;
}

table motion_table(const option_words& said, long digits, input_style style, int jobs) {
    const motion_points points = points_of(said, style == input_style::decimals);
    progress shown("table", points.blocks.size());
    const auto parts = parallel_map(points.blocks.size(), jobs, shown, [&](std::size_t i) {
        return motion_rows(points.blocks[i], points, digits, style).all();
    });
    table data(columns_of(points, style));
    for (const rows_of_motion& part : parts) {
        for (const table_row_cells& row : part) {
            data.add_row(row);
        }
    }
    return data;
}

}  // namespace libration
