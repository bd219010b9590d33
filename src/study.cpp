// libration study NAME: runs one study with any parameters; to stdout, or to files with figures under --out.
#include "sweep/study.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "input_error.hpp"
#include "study_files.hpp"
#include "study_order.hpp"
#include "subcommand.hpp"

namespace libration {

namespace {

struct study_options {
    std::string name;
    study_words words;
    std::optional<std::string> out;
};

// All rows under one header: the tables of a study have the same columns, and one of them is the scalar.
table joined(const std::vector<study_table>& parts) {
    table all{parts.front().data.columns, {}};
    for (const study_table& part : parts) {
        all.rows.insert(all.rows.end(), part.data.rows.begin(), part.data.rows.end());
    }
    return all;
}

int run_study(const study_options& options) {
    const study& what = study_named("study", options.name);
    const study_order order = order_of(what, options.words);
    try {
        if (!options.out) {
            const std::string csv = to_csv(joined(what.run(order.request)));
            write_to_stdout(csv);
            return 0;
        }
        write_study(order, *options.out);
    } catch (const std::range_error& problem) {
        throw input_error("--scalar", options.words.scalar.value_or("double"),
                          std::string("cannot hold an energy of the list (") + problem.what() + ")",
                          "use --scalar mpfr:DIGITS");
    } catch (const std::domain_error& problem) {
        throw input_error("study", what.name, problem.what(), "leave that value out of --energies and --gaps");
    }
    draw_study(what, *options.out);
    fmt::print(stderr, "libration: wrote {}/{}\n", *options.out, what.name);
    return 0;
}

}  // namespace

subcommand study_command(CLI::App& program) {
    const auto options = std::make_shared<study_options>();
    CLI::App* command = program.add_subcommand("study", "run one study; 'libration studies' lists them");
    command->add_option("NAME", options->name, "which study")->required();
    command->add_option("--energies", options->words.energies, "energies: LIST, a:b:count or a:b:COUNTlog")
        ->type_name("LIST");
    command->add_option("--gaps", options->words.gaps, "energies as gaps 2 - E: the same forms")->type_name("LIST");
    command->add_option("--orders", options->words.orders, "orders N")->type_name("LIST");
    command->add_option("--scalar", options->words.scalar, "double, long-double, quad or mpfr:DIGITS")->type_name("S");
    command->add_option("--out", options->out, "write DIR/NAME/: tables, figures, provenance; without it CSV to stdout")
        ->type_name("DIR");
    command->add_option("--jobs", options->words.jobs, "threads; all cores without it")->type_name("J");
    return {command, [options] { return run_study(*options); }};
}

}  // namespace libration
