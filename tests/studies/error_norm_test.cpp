// The study error_norm: its norms against a search of our own with nothing but the reference tables and the sum over
// separatrix solutions, and what theory says about them.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "command/reference_motion.hpp"
#include "studies/study_rows.hpp"

namespace studies_error_norm_test {

using namespace libration;
using namespace libration::tests;

namespace {

using words = std::vector<std::string>;

const study& error_norm() { return study_of("error_norm"); }

study_request asked(const words& energies, const words& gaps, const std::vector<int>& orders) {
    const auto numbers = [](const auto& texts) {
        std::vector<exact> values;
        for (const auto& text : texts) {
            values.push_back(read_exact(fmt::format("{}", text)));
        }
        return values;
    };
    study_request request;
    request.values.set("energy", numbers(energies));
    request.values.set("gap", numbers(gaps));
    request.values.set("order", numbers(orders));
    request.jobs = 2;
    return request;
}

// Rows of the tables by suffix; that of the proved norms has none.
using tables_by_suffix = std::map<std::string, std::vector<table_row>>;
tables_by_suffix run(const study_request& request) {
    tables_by_suffix tables;
    for (const study_table& part : tables_of({&error_norm(), request, "", ""})) {
        tables[part.suffix] = csv_rows(to_csv(part.data));
    }
    return tables;
}

std::vector<table_row> run_in(const std::string& scalar, study_request request) {
    request.scalar = read_scalar(scalar, arithmetics::proved_too);
    return run(request).at("");
}

const tables_by_suffix& default_tables() {
    static const tables_by_suffix tables =
        run(asked({"0.05", "0.5", "1.71", "2.02", "8"}, {"1e-3", "-1e-3"}, {5, 10, 20, 40}));
    return tables;
}

// The way from the top to the bottom at energies of the reference tables. Nothing here is of the library but its mpfr:
// T* and R^2 = T*^2 + K~'^2 are read from motions.csv, the coefficients from coefficients.csv, and theta is
// -+[2 gd(c r) + sum_{i>=1} (-+1)^i 4 atan(sinh(c r)/cosh(2 i c T*))], r = t - T*, c = pi/(2 K~') (DESIGN section 3).
class tabulated_arc {
public:
    explicit tabulated_arc(const std::string& energy) : rotates_(number_of(energy) > 2), energy_(number_of(energy)) {
        for (const table_row& row : reference_table("motions.csv")) {
            if (row.at("energy") == energy) {
                duration_ = number_of(row.at("tstar"));
                radius_ = number_of(row.at("radius"));
            }
        }
        for (const table_row& row : reference_table("coefficients.csv")) {
            if (row.at("energy") == energy && row.at("at") == "top") {
                a_.push_back(number_of(row.at("coefficient")));
            }
        }
        rate_ = half_turn() / (sqrt(radius_ * radius_ - duration_ * duration_) * 2);
        // cosh(2 i c T*) > 1e70 leaves nothing to the 60 digits of the tables.
        for (int i = 1; columns_.empty() || columns_.back() > mpfr("1e-70"); ++i) {
            columns_.push_back(1 / cosh(rate_ * duration_ * (2 * i)));
        }
    }

    const mpfr& duration() const { return duration_; }
    mpfr end() const { return rotates_ ? mpfr(half_turn() * 2) : mpfr(0); }
    mpfr end_slope() const { return rotates_ ? mpfr(sqrt(energy_ * 2)) : mpfr(-sqrt(energy_ * 2)); }

    mpfr theta(const mpfr& t) const {
        const mpfr sine = sinh(rate_ * (t - duration_));
        mpfr sum = atan(sine) * 2;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const mpfr pair = atan(sine * columns_[i]) * 4;
            sum += rotates_ || i % 2 == 1 ? pair : mpfr(-pair);
        }
        return rotates_ ? mpfr(end() + sum) : mpfr(-sum);
    }

    /// sigma_N.
    mpfr series(int order, const mpfr& t) const {
        mpfr sum(0);
        for (int n = order; n >= 0; --n) {
            sum = sum * t + a_[static_cast<std::size_t>(n)];
        }
        return sum;
    }

    /// sigma_N + (alpha + beta t) t^(N+1) with the value and the slope of theta at T*.
    mpfr resummed(int order, const mpfr& t) const {
        const mpfr& end_time = duration_;
        mpfr slope(0);
        for (int n = order; n >= 1; --n) {
            slope = slope * end_time + a_[static_cast<std::size_t>(n)] * n;
        }
        const mpfr power = pow(end_time, order + 1);
        const mpfr value_left = (end() - series(order, end_time)) / power;  // alpha + beta T*
        const mpfr slope_left = (end_slope() - slope) / power * end_time;   // (N+1) alpha + (N+2) beta T*
        const mpfr beta = (slope_left - value_left * (order + 1)) / end_time;
        const mpfr alpha = value_left - beta * end_time;
        return series(order, t) + (alpha + beta * t) * pow(t, order + 1);
    }

private:
    static mpfr half_turn() { return acos(mpfr(-1)); }

    bool rotates_;
    mpfr energy_, duration_, radius_, rate_;
    std::vector<mpfr> a_, columns_;
};

struct largest {
    mpfr norm;
    mpfr time;
};

// The largest |f| on [0, end]: 200 even intervals, then golden sections of the two around the largest value. After 90
// of them the place is right to 1e-20, 0.618^90 of the two intervals.
template <class F>
largest search(const F& f, const mpfr& end) {
    constexpr int intervals = 200;
    const auto size = [&](const mpfr& t) { return mpfr(abs(f(t))); };
    largest best{size(mpfr(0)), mpfr(0)};
    for (int i = 1; i <= intervals; ++i) {
        const mpfr t = end * i / intervals;
        const mpfr value = size(t);
        best = value > best.norm ? largest{value, t} : best;
    }
    const mpfr golden = (sqrt(mpfr(5)) - 1) / 2;
    mpfr left = best.time - end / intervals;
    mpfr right = best.time + end / intervals;
    left = left < 0 ? mpfr(0) : left;
    right = right > end ? end : right;
    mpfr low = right - (right - left) * golden;
    mpfr high = left + (right - left) * golden;
    mpfr at_low = size(low);
    mpfr at_high = size(high);
    for (int step = 0; step < 90; ++step) {
        if (at_low < at_high) {
            left = low;
            low = high;
            at_low = at_high;
            high = left + (right - left) * golden;
            at_high = size(high);
        } else {
            right = high;
            high = low;
            at_high = at_low;
            low = right - (right - left) * golden;
            at_low = size(low);
        }
    }
    return at_low > best.norm ? largest{at_low, low} : best;
}

}  // namespace

TEST_CASE("the norms are those of a search over the reference tables", "[studies][error_norm]") {
    const precision_scope scope(80);
    for (const std::string energy : {"1.71", "2.02"}) {
        const tabulated_arc arc(energy);
        for (const table_row& row : run_in("mpfr:50", asked({energy}, {}, {10, 21}))) {
            const int order = std::stoi(row.at("order"));
            const bool is_series = row.at("method") == "series";
            INFO("E = " << energy << ", N = " << order << ", " << row.at("method"));
            const largest found = search(
                [&](const mpfr& t) {
                    return mpfr((is_series ? arc.series(order, t) : arc.resummed(order, t)) - arc.theta(t));
                },
                arc.duration());
            // The tables have 60 digits and the norms are above 1e-6. The place is off by 1e-20, and a maximum is a
            // tenth of a unit of time wide or more, which leaves (1e-19)^2 of the norm.
            const mpfr norm = number_of(row.at("norm"));
            CHECK(abs(norm - found.norm) <= norm * mpfr("1e-37"));
            CHECK(abs(number_of(row.at("time_of_maximum")) - found.time) <= mpfr("1e-19"));
            CHECK(row.at("rigour") == "two-method");
        }
    }
}

TEST_CASE("proved norms are those of refined samples to every digit", "[studies][error_norm]") {
    const auto request = asked({"0.5", "1.71", "4"}, {"1e-6", "-1e-6"}, {0, 1, 10, 40});
    const auto proved = run_in("ball:40", request);
    const auto sampled = run_in("mpfr:40", request);
    REQUIRE(proved.size() == sampled.size());
    for (std::size_t i = 0; i < proved.size(); ++i) {
        INFO("E = " << proved[i].at("energy") << ", N = " << proved[i].at("order") << ", " << proved[i].at("method"));
        CHECK(proved[i].at("rigour") == "proved");
        CHECK(proved[i].at("scalar") == "ball:40");
        // Both are rounded to nearest from more digits; none of these is a tie.
        CHECK(proved[i].at("norm") == sampled[i].at("norm"));
        CHECK(proved[i].at("time_of_maximum") == sampled[i].at("time_of_maximum"));
    }
}

TEST_CASE("no norm is above its bound", "[studies][error_norm]") {
    const precision_scope scope(50);
    std::size_t bounded = 0;
    const auto request = asked({"1e-3", "0.05", "0.5", "1", "1.5", "1.71", "2.3", "4", "8", "1000"},
                               {"1e-3", "-1e-3", "1e-10", "-1e-10"}, {0, 1, 2, 3, 4, 5, 10, 20});
    for (const table_row& row : run_in("mpfr:15", request)) {
        INFO("E = " << row.at("energy") << ", N = " << row.at("order") << ", " << row.at("method"));
        const int order = std::stoi(row.at("order"));
        // Theorem A is for omitted powers from 4 on, which are even below E = 2 and odd above; A2 is from N = 1 on.
        const bool rotates = row.at("gap").front() == '-';
        const int first_order = row.at("method") == "resummed" ? 1 : rotates ? 3 : 2;
        CHECK(row.at("bound").empty() == (order < first_order));
        if (row.at("bound").empty()) {
            continue;
        }
        ++bounded;
        CHECK(number_of(row.at("norm")) <= number_of(row.at("bound")));
        CHECK(abs(number_of(row.at("log10_bound")) - log10(number_of(row.at("bound")))) < mpfr("1e-9"));
    }
    CHECK(bounded > 150);
}

TEST_CASE("from N = 5 on the resummation is better than the series at E = 1.71 and both converge",
          "[studies][error_norm]") {
    std::map<std::string, mpfr> before;
    std::map<std::string, mpfr> norm;
    for (const table_row& row : default_tables().at("")) {
        if (row.at("energy") != "1.71") {
            continue;
        }
        INFO("N = " << row.at("order"));
        norm[row.at("method")] = number_of(row.at("norm"));
        if (row.at("method") == "resummed") {
            CHECK(norm.at("resummed") <= norm.at("series"));
            CHECK((before.empty() || (norm["series"] < before["series"] && norm["resummed"] < before["resummed"])));
            before = norm;
        }
    }
    CHECK(before.size() == 2);
}

TEST_CASE("the fixed scalars have the proved norms down to their floor", "[studies][error_norm]") {
    const std::map<std::string, int> bits{{"double", 53}, {"long-double", 64}, {"quad", 113}};
    const auto& exact = default_tables().at("");
    const precision_scope scope(60);
    for (const auto& [name, digits_of_scalar] : bits) {
        const auto& rounded = default_tables().at(name);
        REQUIRE(rounded.size() == exact.size());
        const mpfr unit = ldexp(mpfr(1), 1 - digits_of_scalar);
        for (std::size_t i = 0; i < exact.size(); ++i) {
            INFO(name << ", E = " << exact[i].at("energy") << ", N = " << exact[i].at("order") << ", "
                      << exact[i].at("method"));
            CHECK(rounded[i].at("scalar") == name);
            CHECK(rounded[i].at("rigour") == "heuristic");
            // theta and the coefficients' sum stay below 2 pi, and each is right to a few units: 20 epsilon pi.
            const mpfr difference = abs(number_of(rounded[i].at("norm")) - number_of(exact[i].at("norm")));
            CHECK(difference <= unit * pi<mpfr>() * 20);
        }
    }
}

TEST_CASE("where the proved norm is far below it double shows its floor and does not hide it",
          "[studies][error_norm]") {
    const precision_scope scope(60);
    const auto& exact = default_tables().at("");
    const auto& rounded = default_tables().at("double");
    const mpfr unit = ldexp(mpfr(1), -52);
    std::size_t floors = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        if (number_of(exact[i].at("norm")) < mpfr("1e-17")) {
            INFO("E = " << exact[i].at("energy") << ", N = " << exact[i].at("order") << ", " << exact[i].at("method"));
            // At E = 0.05 theta is up to 0.32: rounding it once moves it by up to 2^-54.
            CHECK(number_of(rounded[i].at("norm")) > unit / 16);
            CHECK(number_of(rounded[i].at("norm")) < unit * 20);
            ++floors;
        }
    }
    CHECK(floors >= 2);
}

TEST_CASE("rows go by energy, order and method, with the place of the maximum on the way down",
          "[studies][error_norm]") {
    std::vector<std::string> keys;
    const precision_scope scope(60);
    for (const table_row& row : default_tables().at("")) {
        keys.push_back(row.at("energy") + " " + row.at("order") + " " + row.at("method"));
        CHECK(number_of(row.at("time_of_maximum")) >= 0);
        if (row.at("energy") == "1.71") {
            const std::string duration = reference_motion_of("1.71").rows.front().at("tstar");
            const std::string& time = row.at("time_of_maximum");
            CHECK(number_of(time) <= number_of(duration) + last_place(time));
        }
        CHECK(abs(number_of(row.at("log10_norm")) - log10(number_of(row.at("norm")))) < mpfr("1e-9"));
        CHECK(read_exact(row.at("energy")).coefficient + read_exact(row.at("gap")).coefficient == 2);
    }
    std::vector<std::string> expected;
    for (const std::string energy : {"0.05", "0.5", "1.71", "2.02", "8", "1.999", "2.001"}) {
        for (const std::string order : {"5", "10", "20", "40"}) {
            expected.push_back(energy + " " + order + " series");
            expected.push_back(energy + " " + order + " resummed");
        }
    }
    // Energies come by size, whether they were typed as such or as gaps.
    std::sort(keys.begin(), keys.end());
    std::sort(expected.begin(), expected.end());
    CHECK(keys == expected);
}

TEST_CASE("one scalar asked for is one table without a suffix", "[studies][error_norm]") {
    for (const std::string scalar : {"double", "mpfr:20"}) {
        study_request request = asked({"1"}, {}, {5});
        request.scalar = read_scalar(scalar);
        const auto tables = tables_of({&error_norm(), request, "", ""});
        REQUIRE(tables.size() == 1);
        CHECK(tables.front().suffix.empty());
        CHECK(tables.front().data.rows().size() == 2);
        CHECK(tables.front().data.rows().front().at(5).text() == scalar);
    }
}

TEST_CASE("E = 0 and E = 2 have no norm", "[studies][error_norm]") {
    const auto refused = [](const study_words& words) { order_of(error_norm(), words, 1); };
    CHECK_THROWS_AS(refused({{"--energies", "2"}}), libration::error);
    CHECK_THROWS_AS(refused({{"--energies", "1,0"}}), libration::error);
    CHECK_THROWS_WITH(refused({{"--gaps", "0"}}), Catch::Contains("energy 2"));
}

// /usr/bin/python3 -c "
// from mpmath import *
// mp.dps = 40
// h = mpf(1)/4; y, w, worst = mpf(0), mpf(2), (mpf(0), 0)
// for n in range(1, 41):
//     k1, l1 = w, -sin(y)
//     k2, l2 = w + h*l1/2, -sin(y + h*k1/2)
//     k3, l3 = w + h*l2/2, -sin(y + h*k2/2)
//     k4, l4 = w + h*l3, -sin(y + h*k3)
//     y, w = y + h*(k1 + 2*k2 + 2*k3 + k4)/6, w + h*(l1 + 2*l2 + 2*l3 + l4)/6
//     worst = max(worst, (abs(y - (4*atan(exp(n*h)) - pi)), n*h))
// print(worst)"
TEST_CASE("the baseline is the march from (0, 2) against the closed solution", "[studies][error_norm]") {
    const precision_scope scope(60);
    study_request request = asked({"1"}, {}, {5});
    request.values.set("step", {read_exact("1/4")});
    const auto rows = run(request).at("baseline");
    REQUIRE(rows.size() == 4);  // 25 = 100/4 is beyond t = 10
    CHECK(rows.at(0).at("step") == "2.5");
    CHECK(rows.at(2).at("step") == "0.25");
    CHECK(rows.at(2).at("scalar") == "double");
    CHECK(rows.at(3).at("scalar") == "long-double");
    for (const std::size_t i : {2U, 3U}) {
        const table_row& row = rows.at(i);
        CHECK(row.at("energy") == "2");
        CHECK(row.at("steps") == "40");
        CHECK(number_of(row.at("time_of_maximum")) == number_of("10.0"));
        // 40 steps of a few roundings each, multiplied by up to e^10.
        const mpfr unit = number_of(row.at("norm")) / number_of(row.at("norm_in_epsilon"));
        CHECK(abs(number_of(row.at("norm")) - number_of("0.1733408321458228013591967019325719948013268")) <
              unit * 200 * exp(mpfr(10)));
        CHECK(number_of(row.at("norm_without_growth")) < number_of(row.at("norm")));
    }
    request.values.set("step", {read_exact("20")});
    CHECK_THROWS_WITH(run(request), Catch::Contains("0 Runge-Kutta steps"));
}

}  // namespace studies_error_norm_test
