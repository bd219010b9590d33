#include "option/options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "libration/pendulum/energy/energy.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "option/sweep_energy.hpp"
#include "run/grid.hpp"
#include "text/input_error.hpp"
#include "text/latex.hpp"

namespace libration {

namespace {

constexpr const char* number_remedy = "write a number such as 1.71, 171/100 or 1e-30";
constexpr const char* angle_remedy = "write an angle such as 2.5, 3pi/4 or 150deg";
constexpr const char* times_remedy = "write times such as 0,1.5,T/4 or a range 0:20:401";
constexpr int largest_order = 100'000;

exact angle_of(const std::string& option, const std::string& value) {
    exact angle = reading(option, value, angle_remedy, [&] { return read_exact(value); });
    if (angle.has_periods()) {
        throw input_error(option, value, "is a time", angle_remedy);
    }
    return angle;
}

}  // namespace

exact number_of(const std::string& option, const std::string& value) {
    exact number = reading(option, value, number_remedy, [&] { return read_exact(value); });
    if (!number.is_number()) {
        throw input_error(option, value, "has a unit", number_remedy);
    }
    return number;
}

exact positive_number_of(const std::string& option, const std::string& value) {
    const exact number = number_of(option, value);
    if (sign_of_exact(number) <= 0) {
        throw input_error(option, value, "is not positive", "write a positive number");
    }
    return number;
}

exact stiffness_of(const std::optional<std::string>& length, const std::optional<std::string>& gravity) {
    if (length.has_value() != gravity.has_value()) {
        throw input_error(length ? "--length '" + *length + "' comes without --gravity: give both or neither"
                                 : "--gravity '" + *gravity + "' comes without --length: give both or neither");
    }
    return length ? positive_number_of("--gravity", *gravity) / positive_number_of("--length", *length) : exactly(1);
}

int direction_of(const std::optional<std::string>& words) {
    if (!words || *words == "+") {
        return 1;
    }
    if (*words != "-") {
        throw input_error("--direction", *words, "is no direction", "write + or -");
    }
    return -1;
}

long digits_of(const std::optional<std::string>& value) {
    return value ? reading("--digits", *value, fmt::format("write a number from 1 to {}", most_digits),
                           [&] { return read_digits(*value); })
                 : 50;
}

std::vector<exact> times_of(const std::string& value, regime r) {
    auto times = reading("--times", value, times_remedy, [&] { return read_grid(value); });
    for (const exact& time : times) {
        if (time.measure == unit::degree) {
            throw input_error("--times", value, "has the angle '" + time.text + "'", times_remedy);
        }
        if (time.has_periods() && at_critical_energy(r)) {
            throw input_error("--times", value, "has '" + time.text + "', a multiple of an infinite period",
                              "write times without T at E = 2");
        }
    }
    return times;
}

int order_of(const std::string& option, const std::string& value) {
    return reading(option, value, "write the last power to keep, 0 or more",
                   [&] { return read_count(value, largest_order); });
}

void motion_options::add_to(CLI::App& command) {
    const char* const group = "Motion";
    command.add_option("--energy", energy_, "energy E: starts at the top, (+arccos(1-E), 0) or (pi, +-sqrt(2E-4))")
        ->group(group)
        ->type_name("E");
    command.add_option("--gap", gap_, "the energy as 2 - E, exact next to the separatrix")
        ->group(group)
        ->type_name("G");
    command.add_option("--theta0", theta0_, "angle at t = 0: 2.5, 3pi/4, 150deg")->group(group)->type_name("A");
    command.add_option("--omega0", omega0_, "angular velocity at t = 0 (with --theta0)")->group(group)->type_name("W");
    command.add_option("--direction", direction_, "sign of omega at t = 0 for motions given by energy: + or -")
        ->group(group)
        ->type_name("+|-");
    command.add_option("--length", length_, "length in metres: times are then seconds")->group(group)->type_name("L");
    command.add_option("--gravity", gravity_, "gravity in m/s^2 (with --length)")->group(group)->type_name("G");
}

chosen_motion motion_options::by_energy() const {
    const bool by_gap = gap_.has_value();
    const std::string option = by_gap ? "--gap" : "--energy";
    const std::string& value = by_gap ? *gap_ : *energy_;
    const exact number = number_of(option, value);
    const exact energy = by_gap ? exactly(2) - number : number;
    if (sign_of_exact(energy) < 0) {
        throw input_error(option, value, by_gap ? "makes the energy negative" : "is a negative energy",
                          by_gap ? "write a gap 2 - E of at most 2" : "write an energy of 0 or more");
    }
    std::optional<std::string> energy_text;
    std::optional<std::string> gap_text;
    if (energy.is_fraction()) {
        const sweep_energy texts = by_gap ? energy_from_gap(number) : energy_from(number);
        energy_text = texts.energy;
        gap_text = texts.gap;
    }
    const int sense = direction_of(direction_);
    if (!theta0_) {
        return {
            motion::of_energy(energy, sense).with_stiffness(stiffness()), false, option, value, energy_text, gap_text};
    }
    const exact angle = angle_of("--theta0", *theta0_);
    motion of = reading("--theta0", *theta0_, "choose an angle with 1 - cos(angle) <= E",
                        [&] { return motion::of_energy_from(energy, angle, sense); });
    return {of.with_stiffness(stiffness()), false, option, value, energy_text, gap_text};
}

chosen_motion motion_options::by_state() const {
    if (!theta0_ || !omega0_) {
        throw input_error(theta0_ ? "--theta0 '" + *theta0_ + "' is not yet a motion: add --omega0 W or --energy E"
                                  : "--omega0 '" + *omega0_ + "' is not yet a motion: add --theta0 A");
    }
    if (direction_) {
        throw input_error("--direction", *direction_, "goes with --energy or --gap",
                          "give the sign of the motion to --omega0");
    }
    const exact angle = angle_of("--theta0", *theta0_);
    const exact speed = number_of("--omega0", *omega0_);
    motion of =
        reading("--omega0", *omega0_, number_remedy, [&] { return motion::of_state(angle, speed, stiffness()); });
    std::optional<std::string> energy;
    std::optional<std::string> gap;
    if (of.energy()) {
        energy = to_finite_decimal(*of.energy());
        gap = to_finite_decimal(rational(2 - *of.energy()));
    }
    return {std::move(of), true, "--omega0", *omega0_, energy, gap};
}

chosen_motion motion_options::choose() const {
    if (energy_ && gap_) {
        throw input_error("--gap", *gap_, "comes together with --energy '" + *energy_ + "'", "give one of the two");
    }
    const bool energetic = energy_ || gap_;
    if (energetic && omega0_) {
        throw input_error("--omega0", *omega0_, std::string("comes together with ") + (energy_ ? "--energy" : "--gap"),
                          "give an energy, or --theta0 and --omega0, not both");
    }
    if (!energetic && !theta0_ && !omega0_) {
        throw input_error("no motion is given: add --energy E, --gap G, or --theta0 A with --omega0 W");
    }
    return energetic ? by_energy() : by_state();
}

chosen_motion motion_options::choose_for(const scalar_spec& scalar) const {
    chosen_motion chosen = choose();
    if (scalar.kind == scalar_kind::proved) {
        return chosen;  // no energy is outside the range of a ball
    }
    try {
        with_scalar(scalar, 0, [&]<class T>() { energies<T>(chosen.of); });
    } catch (const error& problem) {
        if (problem.kind() != error_kind::range) {
            throw;
        }
        throw input_error(chosen.option, chosen.value, "is outside the range of " + scalar.name(),
                          "use --scalar mpfr:DIGITS");
    }
    return chosen;
}

std::array<motion_options::named, 7> motion_options::all() const {
    return {named{"--energy", &energy_},       named{"--gap", &gap_},
            named{"--theta0", &theta0_},       named{"--omega0", &omega0_},
            named{"--direction", &direction_}, named{"--length", &length_},
            named{"--gravity", &gravity_}};
}

std::optional<std::string> motion_options::first_given() const {
    for (const auto& [name, value] : all()) {
        if (*value) {
            return fmt::format("{} '{}'", name, **value);
        }
    }
    return std::nullopt;
}

const std::optional<std::string>& motion_options::given(std::string_view option) const {
    const auto options = all();
    const auto* const found =
        std::find_if(options.begin(), options.end(), [&](const named& each) { return each.first == option; });
    if (found == options.end()) {
        throw std::logic_error("no option of a motion: " + std::string(option));
    }
    return *found->second;
}

namespace {

std::string names_of(arithmetics offered) {
    return offered == arithmetics::rounding ? "double, long-double, quad or mpfr:DIGITS"
                                            : "double, long-double, quad, mpfr:DIGITS or ball:DIGITS (proved)";
}

}  // namespace

void arithmetic_options::add_to(CLI::App& command, arithmetics offered) {
    offered_ = offered;
    command.add_option("--digits", digits_, "significant digits to print, each right to one unit in the last")
        ->type_name("D");
    command.add_option("--scalar", scalar_, "arithmetic: " + names_of(offered))->type_name("S");
}

arithmetic arithmetic_options::choose() const {
    std::optional<long> digits;
    if (digits_) {
        digits = reading("--digits", *digits_, fmt::format("write a number from 1 to {}", most_digits),
                         [&] { return read_digits(*digits_); });
    }
    if (!scalar_) {
        const long wanted = digits.value_or(50);
        return {{scalar_kind::arbitrary, wanted}, wanted};
    }
    const scalar_spec scalar =
        reading("--scalar", *scalar_, "write " + names_of(offered_), [&] { return read_scalar(*scalar_, offered_); });
    if (digits && *digits > scalar.digits) {
        throw input_error("--digits", *digits_, fmt::format("is more than the {} of {}", scalar.digits, scalar.name()),
                          fmt::format("ask for fewer or for --scalar mpfr:{}", *digits));
    }
    return {scalar, digits.value_or(scalar.digits)};
}

output_options::output_options(std::string usual, const std::vector<std::string>& more) : format_(std::move(usual)) {
    formats_.insert(formats_.end(), more.begin(), more.end());
}

std::string output_options::offered() const {
    std::string names = formats_.front();
    for (std::size_t i = 1; i < formats_.size(); ++i) {
        names += (i + 1 < formats_.size() ? ", " : " or ") + formats_[i];
    }
    return names;
}

void output_options::add_to(CLI::App& command) {
    command.add_option("--format", format_, offered())->type_name("FORMAT")->capture_default_str();
    command.add_option("--out", out_, "write to this file instead of stdout")->type_name("FILE");
}

void output_options::check() const {
    if (std::find(formats_.begin(), formats_.end(), format_) == formats_.end()) {
        throw input_error("--format", format_, "is no format", "write " + offered());
    }
    if (!out_) {
        return;
    }
    const std::filesystem::path target(*out_);
    const auto folder = target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
    std::error_code error;
    if (target.filename().empty() || std::filesystem::is_directory(target, error)) {
        throw input_error("--out", *out_, "is a folder", "name a file");
    }
    if (!std::filesystem::is_directory(folder, error)) {
        throw input_error("--out", *out_, "is in a folder that does not exist", "make the folder first");
    }
    if (::access(folder.c_str(), W_OK) != 0) {
        throw input_error("--out", *out_, "cannot be written", "choose a folder that you may write in");
    }
}

std::string in_format(const std::string& format, const table& data) {
    return format == "csv"     ? to_csv(data)
           : format == "json"  ? to_json(data)
           : format == "latex" ? to_latex(data)
                               : to_text(data);
}

void output_options::write(const table& data, const std::optional<std::string>& text) const {
    write_content(text && format_ == "text" ? *text : in_format(format_, data));
}

void output_options::write_content(const std::string& content) const {
    if (!out_) {
        write_to_stdout(content);
        return;
    }
    try {
        write_whole_file(*out_, content);
    } catch (const std::runtime_error& problem) {
        throw input_error("--out", *out_, fmt::format("cannot be written ({})", problem.what()),
                          "choose a file in a folder that you may write in");
    }
}

output_folder::output_folder(const std::string& option, std::string path) : path_(std::move(path)) {
    namespace fs = std::filesystem;
    if (path_.empty()) {
        throw input_error(option, path_, "is no folder", "name one");
    }
    std::vector<fs::path> missing;
    std::error_code error;
    for (fs::path at = fs::absolute(path_); !fs::exists(at, error) && at.has_relative_path(); at = at.parent_path()) {
        missing.push_back(at);
    }
    std::string reason;
    std::reverse(missing.begin(), missing.end());
    for (const fs::path& at : missing) {
        if (fs::create_directory(at, error)) {
            made_.push_back(at.string());
        } else if (error) {
            reason = " (" + error.message() + ")";
            break;
        }
    }
    if (!reason.empty() || !fs::is_directory(path_, error) || ::access(path_.c_str(), W_OK) != 0) {
        take_away();
        throw input_error(option, path_, "cannot be written" + reason, "choose a folder that you may write in");
    }
}

output_folder::~output_folder() {
    if (!kept_) {
        take_away();
    }
}

void output_folder::take_away() {
    for (; !made_.empty(); made_.pop_back()) {
        std::error_code not_empty;
        std::filesystem::remove(made_.back(), not_empty);
    }
}

}  // namespace libration
