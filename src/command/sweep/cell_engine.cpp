#include "sweep/cell_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <map>

#include "run/parallel.hpp"
#include "run/progress.hpp"
#include "run/provenance.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

constexpr char between_words = '\x1f';  // does not occur in the words of a command
constexpr std::size_t most_failures_listed = 20;

std::string bytes_of(const cell_key& key) { return {key.begin(), key.end()}; }

// The values of the axes along which the cells of the plan do not differ, and the arithmetic.
std::string common_inputs(const study_request& request, const std::vector<std::string>& split) {
    std::string words;
    for (const auto& [name, values] : request.values.all()) {
        if (std::find(split.begin(), split.end(), name) != split.end()) {
            continue;
        }
        words += between_words + name;
        for (const exact& value : values) {
            words += between_words + value.text;
        }
    }
    words += between_words + (request.scalar ? request.scalar->name() : std::string());
    for (const scalar_spec& each : request.further_scalars) {
        words += "," + each.name();
    }
    return words;
}

journal_record failed_record(const cell_key& key, const cell_inputs& inputs, const std::string& reason) {
    return {key, words_of(inputs), true, 1, 0, reason};
}

}  // namespace

std::string words_of(const cell_inputs& inputs) {
    std::string words;
    for (const cell_input& each : inputs) {
        words += (words.empty() ? "" : " ") + each.axis + "=" + without_controls(each.words, longest_quotation);
    }
    return words;
}

std::optional<journal_record> memory_store::find(const cell_key& key) const {
    const std::lock_guard lock(mutex_);
    const auto found = all_.find(bytes_of(key));
    return found == all_.end() ? std::nullopt : std::optional(found->second);
}

void memory_store::add(std::vector<journal_record> records) {
    const std::lock_guard lock(mutex_);
    for (journal_record& each : records) {
        all_[bytes_of(each.key)] = std::move(each);
    }
}

study_cells::study_cells(const study_order& order) : order_(order), plan_(order.what->plan(order.request)) {
    const journal_stamp own = stamp();
    common_ = own.study + between_words + own.version + between_words + own.library +
              common_inputs(order.request, plan_.axes);
    if (order.what->equation) {
        common_ += between_words + order.what->equation->text;
    }
}

journal_stamp study_cells::stamp() const {
    return {order_.what->name, std::to_string(order_.what->version), program_identity()};
}

cell_key study_cells::key(const cell_inputs& inputs) const {
    std::string words = common_;
    for (const cell_input& each : inputs) {
        words += between_words + each.axis + between_words + each.words;
    }
    return key_of(words);
}

std::vector<journal_record> study_cells::compute(const group_work& work) const {
    const cell_group group = plan_.group(work.group);
    const auto start = std::chrono::steady_clock::now();
    std::vector<journal_record> records;
    records.reserve(work.cells.size());
    try {
        const auto rows = group.compute(work.cells);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        for (std::size_t i = 0; i < work.cells.size(); ++i) {
            const cell_inputs& inputs = group.cells[work.cells[i]];
            records.push_back({key(inputs), words_of(inputs), false, 1,
                               taken.count() / static_cast<double>(work.cells.size()), to_cell_text(rows.at(i))});
        }
    } catch (const std::exception& problem) {
        records.clear();
        if (work.cells.size() == 1) {
            const cell_inputs& inputs = group.cells[work.cells.front()];
            keep_failure(work.group, work.cells.front());
            return {failed_record(key(inputs), inputs, problem.what())};
        }
        for (const std::size_t which : work.cells) {
            auto alone = compute({work.group, {which}});
            std::move(alone.begin(), alone.end(), std::back_inserter(records));
        }
    }
    return records;
}

void study_cells::keep_failure(std::size_t group, std::size_t cell) const {
    const std::lock_guard lock(mutex_);
    if (!first_failure_ || std::pair(group, cell) < place_of_failure_) {
        place_of_failure_ = {group, cell};
        first_failure_ = std::current_exception();
    }
}

void study_cells::rethrow_first_failure() const {
    if (first_failure_) {
        std::rethrow_exception(first_failure_);
    }
}

cells_found missing_cells(const study_cells& of, const cell_store& in, const study_shard& shard) {
    cells_found result;
    for (std::size_t i = shard.index; i < of.plan().groups; i += shard.count) {
        const cell_group group = of.plan().group(i);
        group_work work{i, {}};
        for (std::size_t which = 0; which < group.cells.size(); ++which) {
            const auto record = in.find(of.key(group.cells[which]));
            if (!record || record->failed) {
                work.cells.push_back(which);
            }
        }
        result.cells += group.cells.size();
        result.to_compute += work.cells.size();
        if (!work.cells.empty()) {
            result.missing.push_back(std::move(work));
        }
    }
    return result;
}

void compute_on_threads(const study_cells& of, const std::vector<group_work>& work, const cell_events& events) {
    // Cells that measure times run alone on the machine.
    const int jobs = of.of().alone ? 1 : of.request().jobs;
    on_threads(work.size(), jobs, [&](std::size_t i) {
        events.begun(work[i]);
        events.finished(work[i], of.compute(work[i]));
    });
}

cell_executor& executor() {
    static cell_executor chosen = compute_on_threads;
    return chosen;
}

std::function<void(const study_cells&)>& cell_server() {
    static std::function<void(const study_cells&)> chosen;
    return chosen;
}

namespace {

// The groups that are being computed, by the time at which they started.
class running_groups {
public:
    explicit running_groups(const study_cells& of) : of_(of) {}

    void begin(std::size_t group) {
        const std::lock_guard lock(mutex_);
        begun_[group] = clock::now();
    }
    void end(std::size_t group) {
        const std::lock_guard lock(mutex_);
        begun_.erase(group);
    }
    /// The one that has taken longest, if that is long.
    std::string slowest() const {
        constexpr double long_time = 10;
        const std::lock_guard lock(mutex_);
        const auto first = std::min_element(begun_.begin(), begun_.end(),
                                            [](const auto& a, const auto& b) { return a.second < b.second; });
        const double seconds =
            first == begun_.end() ? 0 : std::chrono::duration<double>(clock::now() - first->second).count();
        if (seconds < long_time) {
            return "";
        }
        const auto cells = of_.plan().group(first->first).cells;
        const std::string more = cells.size() > 1 ? fmt::format(" and {} more", cells.size() - 1) : "";
        return fmt::format("{:.0f} s so far: {}{}", seconds, words_of(cells.front()), more);
    }

private:
    using clock = std::chrono::steady_clock;
    const study_cells& of_;
    mutable std::mutex mutex_;
    std::map<std::size_t, clock::time_point> begun_;
};

}  // namespace

void compute_missing(const study_cells& of, cell_store& store, cells_found found) {
    std::stable_sort(found.missing.begin(), found.missing.end(),
                     [&](const group_work& a, const group_work& b) { return of.cost(a.group) > of.cost(b.group); });
    running_groups running(of);
    progress shown(of.of().name + ", cells", found.to_compute, of.request().shown, [&] { return running.slowest(); });
    const auto finish = [&](const group_work& work, std::vector<journal_record> records) {
        for (journal_record& each : records) {
            if (each.failed) {
                const auto before = store.find(each.key);
                each.attempts = before ? before->attempts + 1 : 1;
            }
        }
        store.add(std::move(records));
        running.end(work.group);
        shown.step(work.cells.size());
    };
    executor()(of, found.missing, {[&](const group_work& work) { running.begin(work.group); }, finish});
    store.flush();
}

namespace {

using see_cell = std::function<void(const journal_record&)>;

// The records of all cells of an order, in its order.
void for_each_record(const study_cells& of, const cell_store& store, const see_cell& see) {
    for (std::size_t i = 0; i < of.plan().groups; ++i) {
        for (const cell_inputs& inputs : of.plan().group(i).cells) {
            const auto record = store.find(of.key(inputs));
            see(record ? *record : failed_record({}, inputs, "was not computed"));
        }
    }
}

}  // namespace

void failures_found::add(const journal_record& failed) {
    ++count;
    if (first.size() < most_failures_listed) {
        first.push_back({failed.inputs, failed.content, failed.attempts});
    }
}

failures_found failures_among(const cells_found& found, const study_cells& of, const cell_store& store) {
    failures_found failures;
    for (const group_work& work : found.missing) {
        const cell_group group = of.plan().group(work.group);
        for (const std::size_t which : work.cells) {
            if (const auto record = store.find(of.key(group.cells[which]))) {
                failures.add(*record);
            }
        }
    }
    return failures;
}

gathered_tables gather(const study_cells& of, const cell_store& store, std::size_t most_rows) {
    gathered_tables result;
    result.tables = of.plan().tables;
    std::size_t longest = 0;
    for_each_record(of, store, [&](const journal_record& record) {
        if (record.failed) {
            result.failures.add(record);
            return;
        }
        ++result.finished;
        cell_rows own = rows_from(record.content);
        for (std::size_t place = 0; place < own.size(); ++place) {
            result.tables.at(place).rows += own[place].size();
            longest = std::max(longest, result.tables.at(place).rows);
            for (table_row_cells& row : own[place]) {
                result.tables.at(place).data.add_row(std::move(row));
            }
        }
        if (longest > most_rows && !of.plan().derive) {
            result.too_long = true;
            for (study_table& each : result.tables) {
                if (!each.data.rows().empty()) {
                    each.data = table(each.data.columns());
                }
            }
        }
    });
    if (of.plan().derive) {
        of.plan().derive(result.tables);
    }
    result.each_row = [&of, &store](const auto& see) {
        for_each_record(of, store, [&](const journal_record& record) {
            const cell_rows own = record.failed ? cell_rows() : rows_from(record.content);
            for (std::size_t place = 0; place < own.size(); ++place) {
                for (const table_row_cells& row : own[place]) {
                    see(place, row);
                }
            }
        });
    };
    return result;
}

namespace {

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

gathered_tables in_memory(const study_cells& of) {
    memory_store store;
    compute_missing(of, store, missing_cells(of, store, {}));
    gathered_tables gathered = gather(of, store, any_number);
    gathered.each_row = {};
    without_repetitions(gathered.tables);
    return gathered;
}

}  // namespace

tables_and_failures answers_of(const study_order& order) {
    const study_cells of(order);
    if (cell_server()) {
        cell_server()(of);
        return {};
    }
    gathered_tables gathered = in_memory(of);
    if (gathered.finished == 0) {
        of.rethrow_first_failure();
    }
    return {std::move(gathered.tables), std::move(gathered.failures)};
}

std::vector<study_table> tables_of(const study_order& order) {
    const study_cells of(order);
    gathered_tables gathered = in_memory(of);
    of.rethrow_first_failure();
    return std::move(gathered.tables);
}

std::string message_of(const failures_found& failures) {
    std::string list;
    for (const cell_failure& each : failures.first) {
        const std::string attempts = each.attempts > 1 ? fmt::format(", {} attempts", each.attempts) : "";
        list += fmt::format("{}{} ({}{})", list.empty() ? "" : "; ", each.inputs, each.reason, attempts);
    }
    return fmt::format("{} failed: {}{}", failures.count == 1 ? "a cell" : fmt::format("{} cells", failures.count),
                       list, failures.count > failures.first.size() ? "; ..." : "");
}

}  // namespace libration
