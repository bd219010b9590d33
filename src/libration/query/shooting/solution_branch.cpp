#include "libration/query/shooting/solution_branch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "branch_path.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "turning_point.hpp"

namespace libration::ode {

namespace {

constexpr int most_steps_without_point = 30;
constexpr int least_steps_of_loop = 4;
constexpr double margin_of_range = 0.1;

double rough_value(const number& x) {
    const precision_scope scope(20);
    return midpoint_of(constant_value<ball>::of(x)).convert_to<double>();
}

double rough_value(const known_value& x) {
    const precision_scope scope(20);
    return x.decimal ? from_exact<mpfr>(read_exact(x.decimal->text)).convert_to<double>() : 0;
}

number exact_guess(double x) { return number(rational(x)); }

std::vector<double> rough_values(const std::vector<known_value>& values) {
    std::vector<double> result;
    result.reserve(values.size());
    for (const known_value& each : values) {
        result.push_back(rough_value(each));
    }
    return result;
}

// A value of the parameter.
struct branch_value {
    std::string text;
    double about;
};

std::vector<branch_value> read_values(const branch_question& question) {
    std::vector<branch_value> values;
    for (const std::string& each : question.values) {
        values.push_back({each, rough_value(parse_constant(each).constant())});
    }
    const auto by_size = [](const branch_value& a, const branch_value& b) { return a.about < b.about; };
    const bool rising = values.size() > 1 && values[0].about < values[1].about;
    const bool ordered = std::ranges::adjacent_find(values, [&](const branch_value& a, const branch_value& b) {
                             return rising ? !by_size(a, b) : !by_size(b, a);
                         }) == values.end();
    if (values.size() < 2 || !ordered) {
        throw error(
            error_kind::argument, error_subject::along, question.parameter,
            "has not at least two values in one direction: write " + question.parameter + " = first:last:count");
    }
    return values;
}

class branch_search {
public:
    branch_search(const branch_question& question, const std::function<void(const branch_point&)>& found,
                  const proof_route& route, const march_watch& watch)
        : question_(question),
          found_(found),
          route_(route),
          watch_(watch),
          names_(question.unknowns),
          values_(read_values(question)),
          range_(std::abs(values_.back().about - values_.front().about)),
          along_(changed_to(values_.front().text), names_with_parameter(), question.conditions, route, watch),
          map_([this](const std::vector<ball>& x, long bits, long error_bits) { return along_(x, bits, error_bits); }),
          path_(map_, range_) {}

    branch_result result() {
        branch_result result{branch_end::not_continued, "", {}};
        branch_node node = first_node();
        const branch_node begin = node;
        for (int steps = 1;; ++steps) {
            auto next = path_.next(node);
            if (!next) {
                break;
            }
            pass(node, *next, result);
            const bool closed = steps >= least_steps_of_loop && meets(node, *next, begin);
            node = *std::move(next);
            if (closed || is_outside(node) || steps_without_point_++ >= most_steps_without_point) {
                result.end = closed ? branch_end::closed : is_outside(node) ? branch_end::left : branch_end::no_more;
                break;
            }
        }
        result.where = described(node.z);
        return result;
    }

private:
    std::vector<std::string> names_with_parameter() const {
        auto names = question_.unknowns;
        names.push_back(question_.parameter);
        return names;
    }

    equation_system changed_to(const std::string& value) const {
        return changed(question_.system, question_.parameter + " = " + value);
    }

    std::string described(const std::vector<double>& z) const {
        const precision_scope scope(20);
        const auto text = [](double x) { return x == 0 ? std::string("0") : to_decimal(mpfr(x), 6); };
        std::string line = question_.parameter + " = " + text(z.back());
        for (std::size_t i = 0; i + 1 < z.size(); ++i) {
            line += ", " + question_.unknowns[i] + " = " + text(z[i]);
        }
        return line;
    }

    // The solution at a value of the parameter near a first guess.
    std::vector<known_value> proved_at(const std::string& value, const std::vector<number>& guess) const {
        const shooting fixed(changed_to(value), names_, question_.conditions, route_, watch_);
        return proved_part_of_root(
            [&](const std::vector<ball>& x, long bits, long error_bits) { return fixed(x, bits, error_bits); },
            first_iterate(guess), question_.digits, names_);
    }

    void report(const branch_point& point) {
        found_(point);
        steps_without_point_ = 0;
    }

    // A solution at a value of the parameter, which is exact.
    void report(const branch_value& value, const std::vector<known_value>& unknowns) {
        const precision_scope scope(question_.digits + 20);
        const auto x = constant_value<ball>::of(parse_constant(value.text).constant());
        branch_point point{branch_point_kind::solution, {{to_proved_decimal(x, question_.digits), ""}}};
        point.values.insert(point.values.end(), unknowns.begin(), unknowns.end());
        report(point);
    }

    branch_node first_node() {
        auto guess = along_.guess();
        guess.pop_back();
        const auto unknowns = proved_at(values_.front().text, guess);
        report(values_.front(), unknowns);
        auto z = rough_values(unknowns);
        z.push_back(values_.front().about);
        auto node = path_.begin(z, values_.back().about - values_.front().about);
        if (!node) {
            throw error(error_kind::undecided, error_subject::solution, "",
                        "at the first value has no direction: begin at another value of " + question_.parameter);
        }
        return *std::move(node);
    }

    bool is_outside(const branch_node& node) const {
        const auto [low, high] = std::minmax(values_.front().about, values_.back().about);
        return node.z.back() < low - margin_of_range * range_ || node.z.back() > high + margin_of_range * range_;
    }

    // Whether the first point is on the piece, passed in the direction of the beginning.
    static bool meets(const branch_node& from, const branch_node& to, const branch_node& begin) {
        const double length = branch_piece(from, to).length();
        std::vector<double> distance;
        double turn = 0;
        for (std::size_t i = 0; i < to.z.size(); ++i) {
            distance.push_back(to.z[i] - begin.z[i]);
            turn += to.weights[i] * to.weights[i] * to.tangent[i] * begin.tangent[i];
        }
        return turn > 0 && weighted_length(to.weights, distance) <= length;
    }

    // The points on a piece of the branch, with a turning point in between.
    void pass(const branch_node& from, const branch_node& to, branch_result& result) {
        if ((from.tangent.back() < 0) == (to.tangent.back() < 0)) {
            pass_monotone(from, to, end_of_piece::included, result);
            return;
        }
        std::optional<branch_point> point;
        if (const auto turn = turn_between(from, to, point, result)) {
            pass_monotone(from, *turn, end_of_piece::excluded, result);
            if (point) {
                report(*point);
            }
            pass_monotone(*turn, to, end_of_piece::included, result);
        }
    }

    // A turning point at one of the values is not isolated with the parameter fixed.
    enum class end_of_piece { included, excluded };

    void pass_monotone(const branch_node& from, const branch_node& to, end_of_piece end, branch_result& result) {
        const bool rising = from.z.back() < to.z.back();
        const branch_piece piece(from, to);
        const auto at = [&](const branch_value& value) {
            if (rising ? value.about <= from.z.back() || value.about > to.z.back()
                       : value.about >= from.z.back() || value.about < to.z.back()) {
                return;
            }
            if (end == end_of_piece::excluded && value.about == to.z.back()) {
                return;
            }
            const auto guess = piece.at(piece.part_at(value.about));
            try {
                const auto unknowns = proved_at(value.text, exact_guesses(guess, guess.size() - 1));
                auto z = rough_values(unknowns);
                z.push_back(value.about);
                require_near(guess, z, to, piece.length());
                report(value, unknowns);
            } catch (const error& problem) {
                keep_reason(problem, question_.parameter + " = " + value.text, result);
            }
        };
        const bool in_order = rising == (values_.front().about < values_.back().about);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            at(values_[in_order ? i : values_.size() - 1 - i]);
        }
    }

    // The node of the turning point on a piece, proved if it can be.
    std::optional<branch_node> turn_between(const branch_node& from, const branch_node& to,
                                            std::optional<branch_point>& point, branch_result& result) {
        const branch_piece piece(from, to);
        const double rate = std::abs(from.tangent.back());
        const double part = rate / (rate + std::abs(to.tangent.back()));
        const auto guess = piece.at(part);
        std::vector<double> direction;
        for (std::size_t i = 0; i + 1 < guess.size(); ++i) {
            direction.push_back((1 - part) * from.tangent[i] + part * to.tangent[i]);
        }
        const auto pivot = static_cast<std::size_t>(
            std::ranges::max_element(direction, {}, [](double each) { return std::abs(each); }) - direction.begin());
        std::vector<number> of_direction;
        of_direction.reserve(direction.size());
        for (const double each : direction) {
            of_direction.push_back(exact_guess(each / direction[pivot]));
        }
        try {
            const shooting extended = turning_point_conditions(along_, exact_guesses(guess, guess.size()), of_direction,
                                                               pivot, route_, watch_);
            auto values = proved_part_of_root(
                [&](const std::vector<ball>& x, long bits, long error_bits) { return extended(x, bits, error_bits); },
                first_iterate(extended.guess()), question_.digits, names_with_parameter());
            values.resize(guess.size());
            const auto z = rough_values(values);
            require_near(guess, z, to, piece.length());
            point = {branch_point_kind::turning_point, {values.back()}};
            point->values.insert(point->values.end(), values.begin(), values.end() - 1);
            return path_.node_at(z, from.tangent);
        } catch (const error& problem) {
            keep_reason(problem, "the turning point near " + described(guess), result);
        }
        return path_.node_at(guess, from.tangent);
    }

    static std::vector<number> exact_guesses(const std::vector<double>& z, std::size_t count) {
        std::vector<number> numbers;
        for (std::size_t i = 0; i < count; ++i) {
            numbers.push_back(exact_guess(z[i]));
        }
        return numbers;
    }

    // Newton's method may have found a solution on another branch.
    static void require_near(const std::vector<double>& guess, const std::vector<double>& found, const branch_node& at,
                             double step) {
        std::vector<double> distance;
        for (std::size_t i = 0; i < guess.size(); ++i) {
            distance.push_back(found[i] - guess[i]);
        }
        if (weighted_length(at.weights, distance) > step) {
            throw error(error_kind::undecided, error_subject::solution, "",
                        "is on another branch than the first guess");
        }
    }

    static void keep_reason(const error& problem, const std::string& point, branch_result& result) {
        if (problem.kind() != error_kind::undecided || !problem.is_about_solution()) {
            throw error(problem);
        }
        result.unproved.push_back(point + ": the solution " + problem.reason());
    }

    const branch_question& question_;
    const std::function<void(const branch_point&)>& found_;
    proof_route route_;
    march_watch watch_;
    std::vector<std::string> names_;
    std::vector<branch_value> values_;
    double range_;
    shooting along_;
    map_of_unknowns map_;
    branch_path path_;
    int steps_without_point_ = 0;
};

}  // namespace

branch_result follow_branch(const branch_question& question, const std::function<void(const branch_point&)>& found,
                            const proof_route& route, const march_watch& watch) {
    return branch_search(question, found, route, watch).result();
}

}  // namespace libration::ode
