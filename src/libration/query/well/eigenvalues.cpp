#include "libration/query/well/eigenvalues.hpp"

#include <algorithm>
#include <cmath>

#include "../../equation/bound_text.hpp"
#include "eigenvalue_search.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr double widest_sample = 1 << 20;

struct well_ends {
    std::optional<well_end> left, right;
};

[[noreturn]] void refuse_condition(const std::string& text, const std::string& reason) {
    throw error(error_kind::argument, error_subject::condition, text, reason);
}

// The ends at infinity.
void read_limits(const eigenvalue_question& of, const std::string& unknown, well_ends& ends) {
    for (const limit_condition& each : of.limits) {
        if (each.of.name() != unknown || each.value.fraction() != rational(0)) {
            refuse_condition(each.text, "is not that an eigenfunction decays: write " + unknown +
                                            (each.direction > 0 ? "(inf) = 0" : "(-inf) = 0"));
        }
        (each.direction > 0 ? ends.right : ends.left) = well_end{.point = {}, .text = each.text};
    }
}

// A condition at a point: 0, or the ratio of value and slope.
void read_points(const eigenvalue_question& of, const std::string& unknown, const well_equation& well,
                 well_ends& ends) {
    if (ends.left && ends.right) {
        return;  // values at points have no effect
    }
    struct typed_end {
        std::optional<rational> value, slope;
    };
    std::map<rational, typed_end> typed;
    for (const start& each : of.system.starts) {
        const auto point = expression(number_with_values(each.point, of.system)).fraction();
        const auto value = expression(number_with_values(each.value, of.system)).fraction();
        if (!point || !value) {
            refuse_condition(primed(unknown, each.of.derivative()), "is not a fraction at a fraction: write one");
        }
        typed_end& end = typed[*point];
        (each.of.derivative() == 0 ? end.value : end.slope) = *value;
    }
    std::map<rational, well_end> all;
    for (const auto& [point, given] : typed) {
        const std::string place = unknown + "(" + point.str() + ")";
        if (given.value.value_or(1) == 0 && given.slope.value_or(1) == 0) {
            refuse_condition(place, "and the slope there are 0, so that the solution is: give one of the two");
        }
        if (!(given.value && given.slope) && given.value.value_or(0) + given.slope.value_or(0) != 0) {
            refuse_condition(place, "is one nonzero number, and an eigenfunction has a free factor: write " + place +
                                        " = 0, or the slope there too");
        }
        // An open one of the two is the factor.
        const well_end end{point, given.value.value_or(1), given.slope.value_or(1), {}};
        all.emplace(point, end);
        if (well.exponential && point != 0) {
            refuse_condition(place, "is at another point than 0, which is supported only for rational potentials");
        }
    }
    const std::size_t missing = static_cast<std::size_t>(!ends.left) + static_cast<std::size_t>(!ends.right);
    if (all.size() != missing) {
        throw error(error_kind::argument, error_subject::problem, "",
                    "has conditions at " + std::to_string(all.size() + 2 - missing) +
                        " of the two ends that a well has: write " + unknown + "(-inf) = 0; " + unknown +
                        "(inf) = 0, or " + unknown + "(0) = 0; " + unknown + "(inf) = 0");
    }
    auto next = all.begin();
    for (auto* end : {&ends.left, &ends.right}) {
        if (!*end) {
            *end = next++->second;
        }
    }
}

// Whether V has a pole there.
bool is_pole(const well_equation& of, const rational& x) {
    rational value = 0;
    const auto& p = of.potential.below();
    for (int i = p.degree(); i >= 0; --i) {
        value = value * x + p[i];
    }
    return value == 0;
}

// A point at which V is small, between the ends or an end without a pole.
rational point_between(const well_equation& of, const well_ends& ends, const well_side& side) {
    constexpr double none = 1e300;
    const double a = ends.left->point ? ends.left->point->convert_to<double>() : -none;
    const double b = ends.right->point ? ends.right->point->convert_to<double>() : none;
    rational best = ends.left->point ? *ends.left->point : ends.right->point ? *ends.right->point : rational(0);
    bool ordinary = !is_pole(of, best);
    double least = side.potential_near(best.convert_to<double>());
    const double middle = best.convert_to<double>();
    const auto seen = [&](double near) {
        const double each = std::round(near * 64) / 64;
        const double v = side.potential_near(each);
        if (each > a && each < b && std::isfinite(v) && (!ordinary || v < least)) {
            best = rational(std::lround(each * 64), 64);
            least = v;
            ordinary = true;
        }
    };
    for (double s = 1. / 64; s < widest_sample; s *= 1.125) {
        seen(middle - s);
        seen(middle + s);
    }
    for (double s = std::fabs(best.convert_to<double>() - middle); s >= 1. / 64; s /= 2) {
        const auto here = best.convert_to<double>();
        seen(here - s);
        seen(here + s);
    }
    return ordinary ? best : rational((*ends.left->point + *ends.right->point) / 2);
}

// Even and odd eigenfunctions of an even well, or all.
class well_questions {
public:
    well_questions(const eigenvalue_question& of, const std::function<void(long)>& watch)
        : digits_(of.digits), well_(read_well(of.system, of.energy)) {
        read_limits(of, well_.unknown, ends_);
        read_points(of, well_.unknown, well_, ends_);
        const bool line = !ends_.left->point && !ends_.right->point;
        if (line && well_.is_even()) {
            for (const auto& [value, slope] : {std::pair(1, 0), std::pair(0, 1)}) {
                const well_ends half{well_end{rational(0), value, slope, {}}, ends_.right};
                parts_.emplace_back(well_problem(well_, *half.left, *half.right, matching_point(half)), watch);
            }
            return;
        }
        if (well_.mirrored && (!ends_.left->point || *ends_.left->point < 0)) {
            throw error(error_kind::undecided, error_subject::problem, "",
                        "has a potential with a function of the sign of the variable, which is supported on the whole "
                        "line and from a point x >= 0 on");
        }
        parts_.emplace_back(well_problem(well_, *ends_.left, *ends_.right, matching_point(ends_)), watch);
    }

    bool has(long count) { return part_of(count - 1).has(index_in_part(count - 1) + 1); }
    eigenvalue value(long index, long digits) {
        return {index, part_of(index).digits_of(index_in_part(index), digits)};
    }
    eigenvalue value(long index) { return value(index, digits_); }
    /// A number below which the eigenvalue of an index for which has(index + 1) does not hold is not.
    ball largest(long index) { return part_of(index).largest(); }
    const well_equation& well() const { return well_; }
    bool is_halved() const { return parts_.size() > 1; }

    /// Of the part without parity, the index of the eigenvalue nearest to a number.
    long nearest(double e) {
        const precision_scope scope(40);
        eigenvalue_search& part = parts_.front();
        ball at{mpfr(e)};
        const long n = part.below(at);
        const auto distance = [&](long index) {
            const auto found = part.digits_of(index, 6);
            return std::fabs((found.decimal ? std::stod(found.decimal->text) : 0) - e);
        };
        const bool has_next = part.has(n + 1);
        if (n == 0 && !has_next) {
            throw error(error_kind::undecided, error_subject::solution, "",
                        "is not found: no eigenvalue below the continuous spectrum is seen");
        }
        return n > 0 && (!has_next || distance(n - 1) < distance(n)) ? n - 1 : n;
    }

private:
    // Where V is small: there both solutions are computed well.
    rational matching_point(const well_ends& ends) const {
        if (well_.exponential) {
            return 0;
        }
        return point_between(well_, ends, {well_, well_end{}, ball(0)});
    }
    eigenvalue_search& part_of(long index) { return parts_[static_cast<std::size_t>(index) % parts_.size()]; }
    long index_in_part(long index) const { return index / static_cast<long>(parts_.size()); }

    long digits_;
    well_equation well_;
    well_ends ends_;
    std::vector<eigenvalue_search> parts_;
};

}  // namespace

eigenvalues proved_eigenvalues(const eigenvalue_question& question, const march_watch& watch) {
    well_questions wells(question, [&](long bits) {
        if (watch) {
            watch(ball(0), bits);
        }
    });
    eigenvalues result;
    const std::string unknown = wells.well().unknown;
    const std::string zeros = "the eigenfunction of E_n has exactly n zeros between the ends";
    if (question.near) {
        const long index = wells.nearest(*question.near);
        result.values.push_back(wells.value(index));
        result.proved = question.energy + " is the simple eigenvalue of index " + std::to_string(index) +
                        ": the solution has exactly " + std::to_string(index) + (index == 1 ? " zero" : " zeros") +
                        " between the ends, and " + std::to_string(index) +
                        (index == 1 ? " eigenvalue is" : " eigenvalues are") + " below it";
        return result;
    }
    for (long index = 0; index < question.count; ++index) {
        if (!wells.has(index + 1)) {
            result.missing = error(error_kind::undecided, "eigenvalue", "E_" + std::to_string(index),
                                   "is not below " + bound_text(wells.largest(index), MPFR_RNDD) +
                                       ", and eigenvalues are counted up to there, near the continuous spectrum");
            break;
        }
        result.values.push_back(wells.value(index));
    }
    if (!result.values.empty()) {
        const std::size_t count = result.values.size();
        result.proved =
            (count == 1 ? "this is the lowest eigenvalue, and it is simple: "
                        : "these are the " + std::to_string(count) + " lowest eigenvalues, all of them simple: ") +
            zeros;
    }
    return result;
}

bool is_well(const equation_system& system, const std::vector<std::string>& unknowns) {
    return unknowns.size() == 1 && unknowns.front().find('(') == std::string::npos && is_linear_in_time(system);
}

}  // namespace libration::ode
