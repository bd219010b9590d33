#include "libration/scalar/ball/proof_thread.hpp"

#include <unistd.h>
#include <csignal>

#include <atomic>
#include <cfenv>
#include <mutex>
#include <thread>
#include <utility>

#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/ball/failure.hpp"

namespace libration {

namespace {

// Whose turn it is. Shared data is accessed only by the thread whose turn it is.
enum class turn : int { idle, computing, asking, failed, ending };

class proof_thread {
public:
    proof_thread() {
        // Signals to the process are handled by its own threads; those of a fault reach the thread that causes it.
        sigset_t all;
        sigset_t before;
        sigfillset(&all);
        for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP}) {
            sigdelset(&all, fault);
        }
        pthread_sigmask(SIG_BLOCK, &all, &before);
        try {
            thread_ = std::thread([this] { serve(); });
        } catch (...) {
            pthread_sigmask(SIG_SETMASK, &before, nullptr);
            throw;
        }
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
    }
    proof_thread(const proof_thread&) = delete;
    proof_thread& operator=(const proof_thread&) = delete;
    /// Only for one that is idle and was created in this process.
    ~proof_thread() {
        pass(turn::ending);
        thread_.join();
    }

    bool lives_here() const { return process_ == ::getpid(); }

    /// From the caller. `usable` is set to whether the thread may be used again.
    call_ending compute(const call_view<bool>& work, bool& usable) {
        work_ = &work;
        for (pass(turn::computing);; pass(turn::computing)) {
            turn_.wait(turn::computing);
            switch (turn_.load()) {
                case turn::asking:
                    (*question_)();
                    if (!lives_here()) {  // the callback returned in a child process
                        usable = false;
                        return call_ending::no_thread;
                    }
                    break;
                case turn::failed:
                    usable = false;
                    return failure_ == failure_kind::no_memory ? call_ending::no_memory : call_ending::flint_failure;
                case turn::idle:
                case turn::computing:
                case turn::ending: usable = usable_; return call_ending::finished;
            }
        }
    }

    /// From the proof thread.
    void ask(const call_view<void>& question) {
        question_ = &question;
        pass(turn::asking);
        turn_.wait(turn::asking);
    }
    /// From the proof thread in its turn, at a failure: does not return.
    [[noreturn]] void stay(failure_kind kind) {
        failure_ = kind;
        pass(turn::failed);
        for (;;) {
            turn_.wait(turn::failed);
        }
    }

private:
    void pass(turn to) {
        turn_.store(to);
        turn_.notify_one();
    }
    void serve();

    const pid_t process_ = ::getpid();
    std::atomic<turn> turn_{turn::idle};
    const call_view<bool>* work_ = nullptr;
    const call_view<void>* question_ = nullptr;
    failure_kind failure_ = failure_kind::no_memory;
    bool usable_ = true;
    std::thread thread_;
};

// In a proof thread, that thread.
thread_local proof_thread* this_proof_thread = nullptr;

void keep_proof_thread(failure_kind kind) {
    if (this_proof_thread != nullptr) {
        this_proof_thread->stay(kind);
    }
}

// Registers the cleanup at the end of a thread before memory is short: glibc ends the process if it cannot register it.
void register_ends() {
    ball::working_bits();
    mpfr(0);
}

void proof_thread::serve() {
    this_proof_thread = this;
    std::fesetenv(FE_DFL_ENV);
    for (turn_.wait(turn::idle); turn_.load() == turn::computing; turn_.wait(turn::idle)) {
        register_ends();
        usable_ = (*work_)();
        pass(turn::idle);
    }
    this_proof_thread = nullptr;
}

// The proof thread of a thread while it is idle.
class idle_thread {
public:
    idle_thread() = default;
    idle_thread(const idle_thread&) = delete;
    idle_thread& operator=(const idle_thread&) = delete;
    ~idle_thread() { forget_foreign(); }

    /// Throws if none can be started.
    std::unique_ptr<proof_thread> take() {
        forget_foreign();
        return thread_ ? std::move(thread_) : std::make_unique<proof_thread>();
    }
    void put(std::unique_ptr<proof_thread> thread) { thread_ = std::move(thread); }

private:
    // Of a thread of the parent process only the object exists here.
    void forget_foreign() {
        if (thread_ && !thread_->lives_here()) {
            static_cast<void>(thread_.release());
        }
    }

    std::unique_ptr<proof_thread> thread_;
};

}  // namespace

call_ending in_proof_thread(const call_view<bool>& work) noexcept {
    thread_local idle_thread idle;
    std::unique_ptr<proof_thread> thread;
    try {
        static std::once_flag once;
        std::call_once(once, set_failure_handler, keep_proof_thread);
        thread = idle.take();
    } catch (...) {
        return call_ending::no_thread;
    }
    bool usable = false;
    const call_ending how = thread->compute(work, usable);
    if (usable) {
        idle.put(std::move(thread));
    } else {
        static_cast<void>(thread.release());  // it sleeps forever
    }
    return how;
}

void in_calling_thread(const call_view<void>& question) {
    if (this_proof_thread == nullptr) {
        question();
    } else {
        this_proof_thread->ask(question);
    }
}

}  // namespace libration
