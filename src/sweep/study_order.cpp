#include "sweep/study_order.hpp"

#include <algorithm>
#include <thread>

#include "run/grid.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr int largest_order = 100'000;
constexpr int largest_digits = 10'000;
constexpr int most_jobs = 1024;

void require_number(const exact& value) {
    if (!value.is_fraction()) {
        throw error(error_kind::argument, "list", "", "has '" + value.text + "', which is not a decimal or a fraction");
    }
}

std::vector<exact> read_times(const std::string& words) {
    auto times = read_grid(words);
    for (const exact& time : times) {
        if (time.measure == unit::degree) {
            throw error(error_kind::argument, "list", "", "has the angle '" + time.text + "'");
        }
    }
    return times;
}

std::vector<exact> read_points(const std::string& words) {
    auto points = read_grid(words);
    for (const exact& point : points) {
        require_number(point);
        if (point.coefficient < 0 || point.coefficient > 1) {
            throw error(error_kind::argument, "list", "", "has '" + point.text + "', which is not between 0 and 1");
        }
    }
    return points;
}

std::vector<int> read_digit_counts(const std::string& words) {
    auto digits = read_counts(words, largest_digits);
    if (std::find(digits.begin(), digits.end(), 0) != digits.end()) {
        throw error(error_kind::argument, "list", "", "asks for less than one digit");
    }
    return digits;
}

std::vector<integer> read_periods(const std::string& words) {
    std::vector<integer> periods;
    for (const exact& count : read_grid(words)) {
        require_number(count);
        if (denominator(count.coefficient) != 1 || count.coefficient < 0) {
            throw error(error_kind::argument, "list", "", "has '" + count.text + "', which is not a whole number");
        }
        periods.push_back(numerator(count.coefficient));
    }
    return periods;
}

std::vector<sweep_period_rule> read_period_rules(const std::string& words) {
    std::vector<sweep_period_rule> rules;
    for (std::size_t begin = 0; begin <= words.size();) {
        const std::size_t end = std::min(words.find(',', begin), words.size());
        rules.push_back(read_period_rule(std::string_view(words).substr(begin, end - begin)));
        begin = end + 1;
    }
    return rules;
}

exact read_step(const std::string& words) {
    exact step = read_exact(words);
    if (!step.is_fraction() || step.coefficient <= 0) {
        throw error(error_kind::argument, "list", "", "is not a positive number");
    }
    return step;
}

std::vector<sweep_energy> read_energies(const std::string& words, sweep_energy (*of)(const exact&)) {
    std::vector<sweep_energy> energies;
    for (const exact& value : read_grid(words)) {
        energies.push_back(of(value));
    }
    return energies;
}

// Puts one parameter into the request.
void fill(study_request& request, const std::string& option, const std::string& words, arithmetics offered) {
    const auto add_energies = [&](sweep_energy (*of)(const exact&)) {
        const auto energies = read_energies(words, of);
        request.energies.insert(request.energies.end(), energies.begin(), energies.end());
    };
    if (option == "--energies") {
        add_energies(energy_from);
    } else if (option == "--gaps") {
        add_energies(energy_from_gap);
    } else if (option == "--orders") {
        request.orders = read_counts(words, largest_order);
    } else if (option == "--times") {
        request.times = read_times(words);
    } else if (option == "--points") {
        request.points = read_points(words);
    } else if (option == "--digits") {
        request.digits = read_digit_counts(words);
    } else if (option == "--periods") {
        request.periods = read_periods(words);
    } else if (option == "--period-by") {
        request.period_rules = read_period_rules(words);
    } else if (option == "--step") {
        request.step = read_step(words);
    } else if (option == "--scalar") {
        request.scalar = read_scalar(words, offered);
    } else {
        throw std::logic_error("no study has an option " + option);
    }
}

bool is_energy(const std::string& option) { return option == "--energies" || option == "--gaps"; }

void require_own(const study& what, const study_words& words) {
    for (const auto& [option, value] : words) {
        const bool own = std::any_of(what.parameters.begin(), what.parameters.end(),
                                     [&name = option](const study_parameter& p) { return p.option == name; });
        if (!own) {
            throw input_error(option, value, "is no parameter of the study " + what.name, "leave it out");
        }
    }
}

}  // namespace

const std::vector<study_option>& study_order_options() {
    static const std::vector<study_option> all{
        {"--energies", "LIST", "energies: LIST, a:b:count or a:b:COUNTlog",
         "write energies such as 0.5,1.71,2.02 or 0.1:1.9:19"},
        {"--gaps", "LIST", "energies as gaps 2 - E: the same forms",
         "write gaps 2 - E such as 1e-3,-1e-3 or 1e-1:1e-12:12log"},
        {"--orders", "LIST", "orders N", "write orders such as 5,10,20"},
        {"--times", "LIST", "times, multiples of T allowed", "write times such as 0,1.5,T/4 or a range 0:2T:401"},
        {"--points", "LIST", "expansion points as fractions of T*, 0 the top, 1 the bottom",
         "write fractions of T* such as 0,1/4,1/2,1 or 0:1:21"},
        {"--digits", "LIST", "numbers of correct digits", "write numbers such as 10,20,50"},
        {"--periods", "LIST", "whole numbers of periods", "write whole numbers such as 1,1e3,1e6"},
        {"--period-by", "LIST", "ways to T*: agm, series:N (Kold) or resummed:N (Knew)",
         "write ways to T* such as agm,series:100,resummed:10"},
        {"--step", "DT", "step of the Runge-Kutta method", "write a step such as 1e-5"},
        {"--scalar", "S", "double, long-double, quad or mpfr:DIGITS; error_norm also ball:DIGITS (proved)",
         "write double, long-double, quad or mpfr:DIGITS"}};
    return all;
}

int jobs_of(const std::optional<std::string>& words) {
    if (!words) {
        return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    }
    const char* const remedy = "write the number of threads, 1 or more";
    const int jobs = reading("--jobs", *words, remedy, [&] { return read_count(*words, most_jobs); });
    if (jobs == 0) {
        throw input_error("--jobs", *words, "is no thread at all", remedy);
    }
    return jobs;
}

study_order order_of(const study& what, const study_words& words, int jobs) {
    require_own(what, words);
    study_order order{&what, {}, "libration study " + what.name};
    order.request.jobs = jobs;
    const bool energies_chosen = words.contains("--energies") || words.contains("--gaps");
    for (const study_option& each : study_order_options()) {
        const auto said = words.find(each.option);
        if (said != words.end()) {
            order.command += " " + each.option + (said->second.starts_with("-") ? "=" : " ") + said->second;
            reading(each.option, said->second, each.remedy, [&] {
                fill(order.request, each.option, said->second, what.offers);
                return 0;
            });
            continue;
        }
        for (const study_parameter& own : what.parameters) {
            const bool put_aside = energies_chosen && is_energy(own.option);
            // What a study does where no scalar is said is its own affair.
            if (own.option == each.option && !own.usual.empty() && !put_aside && own.option != "--scalar") {
                fill(order.request, own.option, own.usual, what.offers);
            }
        }
    }
    std::stable_sort(order.request.energies.begin(), order.request.energies.end(),
                     [](const sweep_energy& a, const sweep_energy& b) { return a.value < b.value; });
    return order;
}

}  // namespace libration
