// The cells of a study on the ranks of MPI: rank 0 distributes them and is the only one that writes.
#pragma once

#include "cell_engine.hpp"

namespace libration {

/// The lifetime of MPI. Rank 0 runs the program; all others work for it: they make the same plan from the same command
/// line and compute the groups whose numbers they receive, on all their threads.
class mpi_ranks {
public:
    mpi_ranks(int* argc, char*** argv);
    mpi_ranks(const mpi_ranks&) = delete;
    mpi_ranks& operator=(const mpi_ranks&) = delete;
    /// Waits for all ranks.
    ~mpi_ranks();

    bool is_first() const { return rank_ == 0; }
    int count() const { return count_; }

    /// On rank 0: computes these groups on the others; if there are none, in its own threads.
    void compute(const study_cells& of, const std::vector<group_work>& work, const cell_events& events) const;
    /// On the others: computes the groups that it receives until rank 0 has no more.
    void serve(const study_cells& of);
    /// On rank 0: the others are no longer needed.
    void release() const;
    /// On the others, if the command line requests no cells: waits until rank 0 has finished.
    void wait_for_release();

private:
    int rank_ = 0;
    int count_ = 1;
    bool released_ = false;
};

}  // namespace libration
