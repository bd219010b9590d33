// The rows of a study as its CSV gives them.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "command/printed.hpp"
#include "sweep/cell_engine.hpp"
#include "sweep/study_order.hpp"

namespace libration::tests {

/// The study of that name.
inline const study& study_of(const std::string& name) {
    for (const study* each : all_studies()) {
        if (each->name == name) {
            return *each;
        }
    }
    throw std::runtime_error("there is no study " + name);
}

/// The tables of a study, run with these words on two threads.
inline std::vector<study_table> tables_of_study(const std::string& name, const study_words& said) {
    const study& what = study_of(name);
    return tables_of(order_of(what, said, 2));
}

/// Whether no two cells of an order have the same key.
inline bool has_different_keys(const study_order& order) {
    const study_cells of(order);
    std::set<cell_key> keys;
    std::size_t cells = 0;
    for (std::size_t i = 0; i < of.plan().groups; ++i) {
        for (const cell_inputs& inputs : of.plan().group(i).cells) {
            keys.insert(of.key(inputs));
            ++cells;
        }
    }
    return keys.size() == cells;
}

/// The tables of an order whose cells are computed one at a time.
inline std::vector<study_table> tables_cell_by_cell(const study_order& order) {
    const study_cells of(order);
    memory_store store;
    for (std::size_t i = 0; i < of.plan().groups; ++i) {
        for (std::size_t which = 0; which < of.plan().group(i).cells.size(); ++which) {
            store.add(of.compute({i, {which}}));
        }
    }
    gathered_tables gathered = gather(of, store);
    without_repetitions(gathered.tables);
    return std::move(gathered.tables);
}

/// The rows of a table as its CSV holds them, quoted cells included.
inline std::vector<table_row> rows_of_table(const study_table& part) {
    const table read = from_csv(to_csv(part.data));
    std::vector<table_row> rows;
    rows.reserve(read.rows().size());
    for (const auto& cells : read.rows()) {
        table_row row;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            row[read.columns()[i].name] = cells[i].text();
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The rows of one of them.
inline std::vector<table_row> rows_of_study(const std::string& name, const study_words& said, std::size_t table = 0) {
    return rows_of_table(tables_of_study(name, said).at(table));
}

/// The rows of all of them, by suffix.
inline std::map<std::string, std::vector<table_row>> rows_by_suffix(const std::string& name, const study_words& said) {
    std::map<std::string, std::vector<table_row>> rows;
    for (const study_table& part : tables_of_study(name, said)) {
        rows[part.suffix] = rows_of_table(part);
    }
    return rows;
}

}  // namespace libration::tests
