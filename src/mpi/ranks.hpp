// The cells of a study on the ranks of MPI: rank 0 hands them out and is the only one that writes.
#pragma once

#include "sweep/cell_engine.hpp"

namespace libration {

/// MPI while it lives. Rank 0 runs the program; all others serve it: they make the same plan from the same command line
/// and compute the groups whose numbers they are sent, on all their threads.
class mpi_ranks {
public:
    mpi_ranks(int* argc, char*** argv);
    mpi_ranks(const mpi_ranks&) = delete;
    mpi_ranks& operator=(const mpi_ranks&) = delete;
    /// Waits for all ranks.
    ~mpi_ranks();

    bool is_first() const { return rank_ == 0; }
    int count() const { return count_; }

    /// On rank 0: has these groups computed by the others; without others by threads of its own.
    void compute(const study_cells& of, const std::vector<group_work>& work, const cell_events& events) const;
    /// On the others: computes what it is sent until rank 0 has no more.
    void serve(const study_cells& of);
    /// On rank 0: the others are not needed any more.
    void release() const;
    /// On the others, where the command line asked for no cells: waits until rank 0 has come to its end.
    void wait_for_release();

private:
    int rank_ = 0;
    int count_ = 1;
    bool released_ = false;
};

}  // namespace libration
