#include "study_order.hpp"

#include <algorithm>
#include <thread>

#include "input_error.hpp"
#include "options.hpp"
#include "sweep/grid.hpp"

namespace libration {

namespace {

constexpr const char* energies_remedy = "write energies such as 0.5,1.71,2.02 or 0.1:1.9:19";
constexpr const char* gaps_remedy = "write gaps 2 - E such as 1e-3,-1e-3 or 1e-1:1e-12:12log";
constexpr const char* orders_remedy = "write orders such as 5,10,20";
constexpr int largest_order = 100'000;
constexpr int most_jobs = 1024;

void add_energies(std::vector<sweep_energy>& energies, const std::string& option, const std::string& words,
                  const char* remedy, sweep_energy (*of)(const exact&)) {
    reading(option, words, remedy, [&] {
        for (const exact& value : read_grid(words)) {
            energies.push_back(of(value));
        }
        return 0;
    });
}

std::string command_of(const study& what, const study_words& words) {
    std::string command = "libration study " + what.name;
    const auto add = [&](const char* option, const std::optional<std::string>& value) {
        command += value ? std::string(" ") + option + (value->starts_with("-") ? "=" : " ") + *value : "";
    };
    add("--energies", words.energies);
    add("--gaps", words.gaps);
    add("--orders", words.orders);
    add("--scalar", words.scalar);
    return command;
}

}  // namespace

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

study_order order_of(const study& what, const study_words& words) {
    study_order order{&what, {}, command_of(what, words)};
    study_request& request = order.request;
    request.jobs = jobs_of(words.jobs);
    const bool chosen = words.energies || words.gaps;
    const std::string energies = chosen ? words.energies.value_or("") : what.defaults.energies;
    const std::string gaps = chosen ? words.gaps.value_or("") : what.defaults.gaps;
    if (!energies.empty() || words.energies) {
        add_energies(request.energies, "--energies", energies, energies_remedy, energy_from);
    }
    if (!gaps.empty() || words.gaps) {
        add_energies(request.energies, "--gaps", gaps, gaps_remedy, energy_from_gap);
    }
    std::stable_sort(request.energies.begin(), request.energies.end(),
                     [](const sweep_energy& a, const sweep_energy& b) { return a.value < b.value; });
    const std::string orders = words.orders.value_or(what.defaults.orders);
    if (!orders.empty() || words.orders) {
        request.orders = reading("--orders", orders, orders_remedy, [&] { return read_counts(orders, largest_order); });
    }
    if (words.scalar) {
        request.scalar = reading("--scalar", *words.scalar, "write double, long-double, quad or mpfr:DIGITS",
                                 [&] { return read_scalar(*words.scalar); });
    }
    return order;
}

}  // namespace libration
