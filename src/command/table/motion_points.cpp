#include "table/motion_points.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "problem/motion_cells.hpp"
#include "text/point_file.hpp"

namespace libration {

using namespace pendulum;

namespace {

constexpr std::size_t times_a_block = 32;

// A motion with its times, in blocks of equal work.
void add_blocks(motion_points& points, const motion_block& whole) {
    for (std::size_t begin = 0; begin < whole.times.size(); begin += times_a_block) {
        const auto first = whole.times.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last =
            whole.times.begin() + static_cast<std::ptrdiff_t>(std::min(begin + times_a_block, whole.times.size()));
        points.blocks.push_back({whole.motion, {first, last}, whole.said, whole.direction});
    }
}

motion_points points_of_lists(const option_words& said) {
    const auto motions = motions_of(said);
    const auto times = times_for(motions, said);
    motion_points points;
    points.theta0 = said["--theta0"].has_value();
    points.omega0 = said["--omega0"].has_value();
    points.direction = said["--direction"].has_value();
    points.seconds = said["--length"].has_value();
    for (const grid_motion& motion : motions) {
        add_blocks(points, {motion, times, *said["--times"], said["--direction"].value_or("")});
    }
    return points;
}

// The texts of an energy that was given.
std::optional<sweep_energy> texts_of(const typed_motion& typed) {
    const auto& number = typed.gap ? typed.gap : typed.energy;
    if (!number || !number->is_fraction()) {
        return std::nullopt;
    }
    return typed.gap ? energy_from_gap(*typed.gap) : energy_from(*typed.energy);
}

// The rows of a file: what they share, and the block of one.
class motion_rows_of_file {
public:
    motion_rows_of_file(const option_words& said, bool decimals)
        : said_(said),
          decimals_(decimals),
          file_("--points", *said["--points"], said["--columns"], known()),
          columns_(file_.names()),
          time_(file_.names()) {
        if (time_.there() == said["--times"].has_value()) {
            throw input_error(
                "--points", *said["--points"], time_.there() ? "has times, and --times too" : "has no column 'time'",
                time_.there() ? "leave out --times, or the column by --columns time=-" : "add --times LIST");
        }
    }

    motion_points points() const {
        motion_points all;
        all.theta0 = columns_.has_angle();
        all.omega0 = columns_.has_speed();
        all.direction = columns_.has_direction();
        all.seconds = columns_.has_length();
        for (std::size_t i = 0; i < file_.rows().size();) {
            const motion_cells cells = columns_.in(file_.rows()[i].cells);
            motion_block block = block_of(file_.rows()[i], cells);
            do {
                add_times(block, file_.rows()[i]);
                ++i;
            } while (i < file_.rows().size() && time_.there() &&
                     columns_.in(file_.rows()[i].cells).key() == cells.key());
            add_blocks(all, block);
        }
        return all;
    }

private:
    static std::vector<known_column> known() {
        auto columns = motion_columns::known();
        const auto of_time = time_columns::known();
        columns.insert(columns.end(), of_time.begin(), of_time.end());
        return columns;
    }

    motion_block block_of(const point_file::row& row, const motion_cells& cells) const {
        return file_.reading(row, [&](const auto& /*cells*/) {
            const typed_motion typed = cells.read();
            require_filled(cells);
            return motion_block{{typed, cells.motion_of(typed), texts_of(typed)}, {}, "", cells.direction.text};
        });
    }

    // A reader of columns of numbers does not accept empty cells.
    void require_filled(const motion_cells& cells) const {
        for (const auto& [there, cell] : {std::pair{columns_.has_angle(), &cells.theta0},
                                          {columns_.has_speed(), &cells.omega0},
                                          {columns_.has_direction(), &cells.direction}}) {
            if (decimals_ && there && cell->text.empty()) {
                throw error(error_kind::argument, cell->name, "",
                            "is empty, which only csv, json, text and latex hold");
            }
        }
    }

    void add_times(motion_block& block, const point_file::row& row) const {
        const regime regime = block.motion.of.regime();
        if (!time_.there()) {
            block.said = *said_["--times"];
            block.times = times_of(block.said, regime);
            return;
        }
        block.said = time_.in(row.cells).text;
        block.times.push_back(file_.reading(row, [&](const auto& cells) { return time_for(time_.in(cells), regime); }));
    }

    const option_words& said_;
    bool decimals_;
    point_file file_;
    motion_columns columns_;
    time_columns time_;
};

}  // namespace

motion_points points_of(const option_words& said, bool decimals) {
    if (!said["--points"]) {
        return points_of_lists(said);
    }
    return motion_rows_of_file(said, decimals).points();
}

}  // namespace libration
