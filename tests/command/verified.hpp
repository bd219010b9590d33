// The comparison of a file by `libration verify`, as its tests call it.
#pragma once

#include <catch2/catch.hpp>
#include <fstream>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace libration::tests::verifying {

struct verified {
    finished_process done;
    std::vector<table_row> rows;
};

inline finished_process verify(const std::string& csv, const words& options = {}) {
    const temporary_folder folder;
    std::ofstream(folder.path() / "f.csv", std::ios::binary) << csv;
    return run_libration(words{"verify", "f.csv"} + options, folder.path());
}

// The compared rows of a file without quotes.
inline verified verify_rows(const std::string& csv, const words& options = {}) {
    const auto done = verify(csv, options);
    INFO(done.err);
    return {done, csv_rows(done.out)};
}

inline std::string verdict_of(const std::string& csv, const words& options = {}) {
    return verify_rows(csv, options).rows.at(0).at("verdict");
}

inline bool says(const finished_process& done, const std::string& what) {
    INFO(done.err);
    return done.err.find(what) != std::string::npos;
}

// The file is rejected as a whole.
inline void refuses(const std::string& csv, const words& options, const std::string& reason) {
    const temporary_folder folder;
    std::ofstream(folder.path() / "f.csv", std::ios::binary) << csv;
    INFO(csv);
    check_refused(words{"verify", "f.csv"} + options, {reason}, folder);
}

// mpmath, mp.dps = 40: 2*asin(sqrt(m)*ellipfun('cd', mpf('0.7'), m=m)), m = mpf('1.71')/2
inline const std::string theta_at_seven_tenths = "2.182887871517687737950367677330840756";

}  // namespace libration::tests::verifying
