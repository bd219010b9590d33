#include "reference_set.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "option/options.hpp"
#include "sweep/study_files.hpp"

namespace libration {

namespace {

constexpr const char* table_moduli = "1e-30,1e-20,1e-10,1e-6,1e-3,0.01,0.1,0.19,0.36,0.5,0.64,0.75,0.9,0.99,0.999999";

// The command that makes one file of a table.
std::string command_for(const reference_table& each, const std::string& format) {
    const bool named = format == "cpp" || format == "ipp";
    return each.order.command() + " --format " + format + (named ? " --name libration_" + each.name : "");
}

}  // namespace

const std::vector<reference_format>& reference_formats() {
    static const std::vector<reference_format> formats{
        {"csv", ".csv"}, {"cpp", ".hpp"}, {"ipp", ".ipp"}, {"numpy", ".txt"}};
    return formats;
}

const std::vector<reference_table>& reference_set() {
    static const std::vector<reference_table> set{
        {"near_separatrix",
         "Next to the separatrix: gaps 2 - E from 0.1 to 1e-30 on both sides, from the canonical starts.",
         {table_subject_named("pendulum"),
          {{"--gaps", "1e-1:1e-30:30log,-1e-1:-1e-30:30log"}, {"--times", "1,10,100,T/8,T/3"}}}},
        {"release_angles",
         "Released at rest from 1 to 179 degrees, the classical 30, 60, 90, 120 and 150 among them.",
         {table_subject_named("pendulum"),
          {{"--theta0", "1deg,10deg:170deg:17,175deg,179deg"}, {"--omega0", "0"}, {"--times", "1,10,T/8,T/4"}}}},
        {"quarter_periods",
         "A whole period in eighths: theta is exactly 0 or a turning point at the quarters of libration.",
         {table_subject_named("pendulum"),
          {{"--energies", "0.01,0.1,0.5,1,1.5,1.71,1.9,1.99,2.01,2.1,2.5,3,4,10,100"}, {"--times", "0:T:9"}}}},
        {"lemniscatic",
         "The lemniscatic case E = 1, released at 90 degrees: T = Gamma(1/4)^2/sqrt(pi).",
         {table_subject_named("pendulum"), {{"--energies", "1"}, {"--times", "0:T:25,0.1,0.5,1,2,5,10,100,1e6"}}}},
        {"any_state",
         "From any angle with any velocity, also after 1e20 units of time.",
         {table_subject_named("pendulum"),
          {{"--theta0", "0.5,1,2,2.5,3,-10"}, {"--omega0", "-0.3,1.2,2.5"}, {"--times", "1,1000,1e20"}}}},
        {"jacobi_functions",
         "Jacobi's am, sn, cn and dn, with the complementary parameter m1 = 1 - m down to 1e-30.",
         {table_subject_named("am,sn,cn,dn"), {{"--u", "0.1,0.5,1,1.5,2,5,10,40,1000"}, {"--m1", table_moduli}}}},
        {"complete_integral",
         "The complete elliptic integral K.",
         {table_subject_named("K"), {{"--m1", table_moduli}}}},
        {"incomplete_integral",
         "The incomplete elliptic integral F.",
         {table_subject_named("F"),
          {{"--phi", "1deg,30deg,45deg,60deg,89deg,90deg,1,1.5,2,10"}, {"--m1", table_moduli}}}}};
    return set;
}

void write_reference_set(const std::string& folder, int jobs) {
    namespace fs = std::filesystem;
    output_folder into("--out", (fs::path(folder) / "reference").string());
    nlohmann::ordered_json index;
    for (const reference_table& each : reference_set()) {
        const table typed = table_for(each.order, "csv", jobs);
        const table decimals = table_for(each.order, "numpy", jobs);
        nlohmann::ordered_json entry{{"name", each.name}, {"title", each.title}};
        entry.update(nlohmann::ordered_json::parse(provenance_json(each.order, typed, command_for(each, "csv"))));
        for (const auto& [format, extension] : reference_formats()) {
            const std::string file = each.name + extension;
            write_into((fs::path(into.path()) / file).string(),
                       table_file(each.order, has_comments(format) ? decimals : typed, format, "libration_" + each.name,
                                  command_for(each, format)));
            entry["files"].push_back(file);
        }
        into.keep();
        index.push_back(std::move(entry));
    }
    write_into((fs::path(into.path()) / "reference.json").string(), index.dump(2) + '\n');
}

}  // namespace libration
