// Linear systems with constant coefficients, made from triangular ones with known exponential sums by exact changes of
// their unknowns: defective matrices, equal and nearly equal eigenvalues, rows of zeros, decays beside growth, chains
// from one unknown that is not 0, and unknowns of 1e-500. The shifted series of the vector and the exponential of the
// matrix.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "attack/question.hpp"
#include "libration/integration/closed_form/linear_flow.hpp"
#include "libration/query/states.hpp"

namespace libration::attack {

namespace {

// A sum of c t^k e^(r t), and of e^(r t) cos(w t), e^(r t) sin(w t): c by (r, w, whether a sine) and k, all fractions.
class exponential_sum {
public:
    using term = std::tuple<rational, rational, bool>;

    void add(const exponential_sum& other, const rational& times) {
        for (const auto& [of, list] : other.terms_) {
            for (std::size_t k = 0; k < list.size(); ++k) {
                at(of, k) += times * list[k];
            }
        }
    }
    rational& at(const term& of, std::size_t k) {
        auto& list = terms_[of];
        list.resize(std::max(list.size(), k + 1));
        return list[k];
    }

    // u with u' = rate u + this, u(0) = start; this has no oscillations.
    exponential_sum solution(const rational& rate, const rational& start) const {
        exponential_sum u;
        rational left = start;
        for (const auto& [of, list] : terms_) {
            const rational difference = std::get<0>(of) - rate;
            rational next = 0;
            for (std::size_t k = list.size(); k-- > 0;) {
                if (difference == 0) {
                    u.at(of, k + 1) += list[k] / rational(static_cast<long>(k + 1));
                } else {
                    next = (list[k] - rational(static_cast<long>(k + 1)) * next) / difference;
                    u.at(of, k) += next;
                }
            }
            left -= next;
        }
        u.at({rate, 0, false}, 0) += left;
        return u;
    }

    // Terms far larger than their sum may cancel in the same way at two precisions: by more digits than they have.
    mpfr value(const rational& time) const {
        constexpr long digits_of_small_sums = 800;
        long larger = 0;
        for (const auto& [of, list] : terms_) {
            for (const rational& each : list) {
                larger = std::max(larger, static_cast<long>(numerator(each).str().size()) -
                                              static_cast<long>(denominator(each).str().size()));
            }
        }
        const long digits = working_digits();
        const precision_scope scope(digits + larger + digits_of_small_sums);
        const mpfr t = real(time);
        mpfr sum(0);
        for (const auto& [of, list] : terms_) {
            mpfr polynomial(0);
            for (std::size_t k = list.size(); k-- > 0;) {
                polynomial = polynomial * t + real(list[k]);
            }
            if (polynomial != 0) {
                const auto& [rate, frequency, sine] = of;
                const mpfr angle = real(frequency) * t;
                sum += polynomial * exp(mpfr(real(rate) * t)) * (sine ? mpfr(sin(angle)) : mpfr(cos(angle)));
            }
        }
        sum.precision(static_cast<unsigned>(digits));
        return sum;
    }

private:
    std::map<term, std::vector<rational>> terms_;
};

// x' = A x + b.
struct linear_system {
    std::vector<std::map<std::size_t, rational>> rows;  // of A
    std::vector<rational> constants, starts;
    std::vector<exponential_sum> solutions;

    // An unknown that the ones before it drive.
    void add(const rational& rate, std::map<std::size_t, rational> drivers, const rational& constant,
             const rational& start) {
        exponential_sum driven;
        for (const auto& [j, by] : drivers) {
            driven.add(solutions[j], by);
        }
        driven.at({0, 0, false}, 0) += constant;
        solutions.push_back(driven.solution(rate, start));
        drivers[rows.size()] = rate;
        rows.push_back(std::move(drivers));
        constants.push_back(constant);
        starts.push_back(start);
    }
    // x + i y = (p + i q) e^((rate + i frequency) t).
    void add_oscillation(const rational& rate, const rational& frequency, const rational& p, const rational& q) {
        const std::size_t x = rows.size();
        rows.push_back({{x, rate}, {x + 1, -frequency}});
        rows.push_back({{x, frequency}, {x + 1, rate}});
        constants.insert(constants.end(), 2, 0);
        starts.insert(starts.end(), {p, q});
        const auto sum_of = [&](const rational& of_cosine, const rational& of_sine) {
            exponential_sum made;
            made.at({rate, frequency, false}, 0) = of_cosine;
            made.at({rate, frequency, true}, 0) = of_sine;
            return made;
        };
        solutions.push_back(sum_of(p, -q));
        solutions.push_back(sum_of(q, p));
    }

    // x_i becomes x_i + k x_j.
    void shear(std::size_t i, std::size_t j, const rational& k) {
        for (const auto& [column, value] : std::map(rows[j])) {
            rows[i][column] += k * value;
        }
        for (auto& row : rows) {
            if (const auto found = row.find(i); found != row.end()) {
                const rational less = k * found->second;
                row[j] -= less;
            }
        }
        constants[i] += k * constants[j];
        starts[i] += k * starts[j];
        solutions[i].add(exponential_sum(solutions[j]), k);
    }
    // x_i becomes c x_i.
    void scale(std::size_t i, const rational& c) {
        for (auto& row : rows) {
            if (const auto found = row.find(i); found != row.end()) {
                found->second /= c;
            }
        }
        for (auto& [column, value] : rows[i]) {
            value *= c;
        }
        constants[i] *= c;
        starts[i] *= c;
        solutions[i].add(exponential_sum(solutions[i]), c - 1);
    }

    solved_problem problem() const {
        solved_problem made;
        std::string initial;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            std::string right = constants[i] == 0 ? "" : constants[i].str();
            for (const auto& [column, value] : rows[i]) {
                if (value != 0) {
                    right += fmt::format("{}({})*x{}", right.empty() ? "" : " + ", value.str(), column);
                }
            }
            made.text += fmt::format("x{}' = {}; ", i, right.empty() ? "0" : right);
            initial += fmt::format("{}x{}(0) = {}", i == 0 ? "" : "; ", i, starts[i].str());
            made.columns.push_back("x" + std::to_string(i));
        }
        made.text += initial;
        return made;
    }
};

rational tiny(long decimals) { return {1, pow(integer(10), static_cast<unsigned>(decimals))}; }

// Some rates from which the eigenvalues are drawn, so that they are equal often.
std::vector<rational> any_rates(choices& next) {
    std::vector<rational> rates;
    for (long count = next.between(1, 3); count > 0; --count) {
        switch (next.below(6)) {
            case 0: rates.emplace_back(0); break;
            case 1: rates.emplace_back(next.between(1, 9), next.between(1, 9)); break;
            case 2: rates.emplace_back(-next.between(10, next.one_in(4) ? 300 : 60)); break;
            case 3: rates.push_back(-1 + tiny(next.between(3, 40))); break;
            default: rates.emplace_back(-next.between(1, 9), next.between(1, 9)); break;
        }
    }
    return rates;
}

rational any_coefficient(choices& next) {
    return next.half([&] { return rational(1) - tiny(next.between(5, 60)); },
                     [&] { return rational(next.between(-9, 9), next.between(1, 9)); });
}

linear_system any_linear_system(choices& next) {
    const auto size = static_cast<std::size_t>(next.one_in(5) ? next.between(1, 8) : next.between(18, 44));
    const bool chain = next.one_in(2);  // of conversions: the first unknown alone is not 0 at the beginning
    const bool forced = next.one_in(3);
    const std::vector<rational> rates = any_rates(next);
    linear_system made;
    while (made.rows.size() < size) {
        const std::size_t i = made.rows.size();
        const rational rate = rates[next.below(rates.size())];
        if (!chain && next.one_in(8)) {
            made.add_oscillation(rate, any_coefficient(next), any_coefficient(next), any_coefficient(next));
            continue;
        }
        std::map<std::size_t, rational> drivers;
        if (i > 0 && chain) {
            drivers[i - 1] = next.one_in(12) ? rational(0) : abs(any_coefficient(next));
        } else if (i > 0 && !next.one_in(4)) {
            const std::size_t j = next.one_in(2) ? i - 1 : next.below(i);
            const auto& row = made.rows[j];
            const bool turns = std::ranges::any_of(row, [&](const auto& each) { return each.first > j; }) ||
                               (j > 0 && made.rows[j - 1].contains(j));
            if (!turns) {
                drivers[j] = any_coefficient(next);
            }
        }
        const bool starts_at_zero = chain ? i > 0 : next.one_in(3);
        made.add(rate, std::move(drivers), forced && next.one_in(3) ? any_coefficient(next) : rational(0),
                 starts_at_zero ? rational(0) : any_coefficient(next));
    }
    if (made.rows.size() > 1 && next.one_in(2)) {
        for (long count = next.between(1, 4); count > 0; --count) {
            const std::size_t i = next.below(made.rows.size());
            const std::size_t j = next.below(made.rows.size());
            if (i != j) {
                made.shear(i, j, next.one_in(2) ? rational(1) : any_coefficient(next));
            }
        }
    }
    if (next.one_in(3)) {
        for (long count = next.between(1, 3); count > 0; --count) {
            made.scale(next.below(made.rows.size()), tiny(next.between(1, 500)));
        }
    }
    return made;
}

}  // namespace

// Each unknown counts as one statement.
outcome ask_linear_system(choices& next) {
    const linear_system made = any_linear_system(next);
    const solved_problem problem = made.problem();
    const rational since = decimal_fraction(next.between(-500, 3000), next.one_in(4) ? 5 : 3);
    const long digits = next.between(5, 60);
    const std::string time = problem.typed_time(since);
    const std::string command =
        fmt::format("libration reference --problem \"{}\" --time={} --digits {}", problem.text, time, digits);
    return answered(command, [&](outcome& result) {
        const auto exact_of = [&](std::size_t i) { return [&, i] { return made.solutions[i].value(since); }; };
        if (next.one_in(2)) {
            const auto found = ode::proved_part_of_trajectory(system_of(problem.text), {time_number(time)}, digits,
                                                              [](const ball&, long) { require_time_left(); });
            for (std::size_t i = 0; i < found.states.front().size(); ++i) {
                add_number(result, found.states.front()[i], digits, exact_of(i), problem.columns[i]);
            }
            if (found.missing) {
                result.add(verdict::refused, found.missing->what());
            }
            return;
        }
        const auto flow = ode::linear_flow::of(system_of(problem.text));
        if (!flow) {
            result.add(verdict::wrong, "a linear system is not taken for one");
            return;
        }
        const long bits = 4 * digits + next.between(0, 64);
        const auto state = flow->at(time_number(time), bits);
        if (!state) {
            result.add(verdict::refused, "no enclosure with so many bits");
            return;
        }
        for (std::size_t i = 0; i < state->size(); ++i) {
            result.add(judged_ball((*state)[i], exact_of(i)), fmt::format("{} in a ball", problem.columns[i]));
        }
    });
}

}  // namespace libration::attack
