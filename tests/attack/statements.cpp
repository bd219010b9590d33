#include "attack/statements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "attack/question.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::attack {

namespace {

constexpr auto longest_question = std::chrono::seconds(120);
constexpr long step_of_kinds = 7919;  // a prime that does not divide the sum of the shares: kinds alternate

const char* name_of(verdict v) {
    switch (v) {
        case verdict::right: return "right";
        case verdict::refused: return "refused";
        case verdict::wrong: return "false";
        case verdict::undecided: return "undecided";
    }
    return "";
}

// The counts of a kind.
struct kind_counts {
    long questions = 0;
    std::array<long, verdicts> of{};
};

class attack_run {
public:
    attack_run(long questions, unsigned long seed, std::string kind = "")
        : questions_(questions), seed_(seed), kind_(std::move(kind)), counts_(statement_kinds().size()) {}

    // One question by itself, with all of its statements.
    void print_question(long index) {
        const std::size_t which = kind_of(index);
        const outcome result = answered(which, index);
        fmt::print("{}: {}\n", statement_kinds()[which].name, result.command);
        for (const auto& [given, statement] : result.statements) {
            fmt::print("  {}: {}\n", name_of(given), statement);
        }
        failed_ = result.count(verdict::wrong) > 0;
    }

    void work() {
        for (long i = next_++; i < questions_; i = next_++) {
            if (is_run(kind_of(i))) {
                ask(i);
            }
        }
        flint_cleanup();
    }

    void ask(long index) {
        const std::size_t which = kind_of(index);
        note(which, index, answered(which, index));
    }

    bool succeeded() const { return !failed_; }

    void print() const {
        fmt::print(
            "# Statements against independent truth\n\n"
            "What became of the statements of `libration-attack statements {} {}{}` (tests/attack): numbers and\n"
            "bounds that are called proved, and the facts that refusals state. *Refused* are questions without an\n"
            "answer, whose message states no fact or facts that hold; *undecided* are those whose truth is not\n"
            "known well enough, or that had no answer in {} s of processor time.\n\n",
            questions_, seed_, kind_.empty() ? "" : fmt::format(" 0 '{}'", kind_), seconds_of_a_question.count());
        fmt::print(
            "| kind | what is stated | questions | statements | proved and right | refused | undecided | false |\n"
            "|---|---|---:|---:|---:|---:|---:|---:|\n");
        kind_counts sum;
        for (std::size_t k = 0; k < counts_.size(); ++k) {
            if (!is_run(k)) {
                continue;
            }
            print_row(statement_kinds()[k].name, statement_kinds()[k].about, counts_[k]);
            sum.questions += counts_[k].questions;
            for (std::size_t v = 0; v < verdicts; ++v) {
                sum.of[v] += counts_[k].of[v];
            }
        }
        print_row("all", "", sum);
    }

    // Ends the program if a question takes too long.
    void watch(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            if (const auto command = command_older_than(longest_question)) {
                const std::lock_guard lock(mutex_);
                print();
                std::fflush(stdout);
                fmt::print(stderr, "no answer in {} s of processor time: {}\n", longest_question.count(), *command);
                std::_Exit(1);
            }
        }
    }

    static std::size_t kind_of(long index) {
        const auto& kinds = statement_kinds();
        long all = 0;
        for (const statement_kind& each : kinds) {
            all += each.share;
        }
        long place = index * step_of_kinds % all;
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            place -= kinds[k].share;
            if (place < 0) {
                return k;
            }
        }
        return 0;
    }

private:
    bool is_run(std::size_t which) const { return kind_.empty() || kind_ == statement_kinds()[which].name; }

    outcome answered(std::size_t which, long index) const {
        choices next(seed_ * 1'000'000'007UL + static_cast<unsigned long>(index));
        outcome result;
        try {
            result = statement_kinds()[which].ask(next);
        } catch (const std::exception& problem) {
            result.command = announced_command();
            result.add(verdict::wrong, std::string("ends by an exception: ") + problem.what());
        }
        announce("");
        return result;
    }

    static void print_row(const char* name, const char* about, const kind_counts& counts) {
        const auto of = [&](verdict v) { return counts.of[static_cast<std::size_t>(v)]; };
        const long all = of(verdict::right) + of(verdict::refused) + of(verdict::undecided) + of(verdict::wrong);
        fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", name, about, counts.questions, all,
                   of(verdict::right), of(verdict::refused), of(verdict::undecided), of(verdict::wrong));
    }

    void note(std::size_t which, long index, const outcome& result) {
        const std::lock_guard lock(mutex_);
        kind_counts& counts = counts_[which];
        ++counts.questions;
        for (std::size_t v = 0; v < verdicts; ++v) {
            counts.of[v] += result.counts[v];
        }
        for (const auto& [given, statement] : result.statements) {
            if (given == verdict::wrong || given == verdict::undecided) {
                fmt::print(stderr, "{} {} (question {} of seed {}): {}\n  {}\n", name_of(given),
                           statement_kinds()[which].name, index, seed_, result.command, statement);
            }
        }
        failed_ = failed_ || result.count(verdict::wrong) > 0;
    }

    long questions_;
    unsigned long seed_;
    std::string kind_;
    std::atomic<long> next_{0};
    std::vector<kind_counts> counts_;
    std::mutex mutex_;
    std::atomic<bool> failed_{false};
};

}  // namespace

int attack_statements(long questions, unsigned long seed, long threads, const std::string& kind) {
    if (!kind.empty() && std::ranges::find(statement_kinds(), kind, &statement_kind::name) == statement_kinds().end()) {
        fmt::print(stderr, "no kind of statements is named '{}'; use a name of the first column of results/attack.md\n",
                   kind);
        return 2;
    }
    attack_run run(questions, seed, kind);
    const std::jthread watching([&](const std::stop_token& stop) { run.watch(stop); });
    {
        std::vector<std::jthread> workers;
        const long all = threads > 0 ? threads : std::max(1L, static_cast<long>(std::thread::hardware_concurrency()));
        for (long i = 0; i < all; ++i) {
            workers.emplace_back([&] { run.work(); });
        }
    }
    run.print();
    return run.succeeded() ? 0 : 1;
}

int attack_statement(long index, unsigned long seed) {
    attack_run run(index + 1, seed);
    run.print_question(index);
    return run.succeeded() ? 0 : 1;
}

}  // namespace libration::attack
