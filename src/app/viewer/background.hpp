// SPDX-License-Identifier: MIT
// A thread that does one job after the other, and of those that wait only the newest.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace vitrine {

/// Thrown by a checkpoint: nobody waits for the job's result any more. No fault.
struct Overtaken {};

/// What a job calls between its stages.
using Checkpoint = std::function<void()>;

template <class Result>
class Background {
  public:
    using Job = std::function<Result(const Checkpoint&)>;

    /// `ring` is called on the thread when there is something to take().
    explicit Background(std::function<void()> ring)
        : ring_(std::move(ring)), thread_([this] { run(); }) {}
    /// The job in hand ends at its next checkpoint, and is waited for.
    ~Background() {
        {
            const std::lock_guard lock(mutex_);
            ending_ = true;
            next_.reset();
        }
        changed_.notify_all();
        thread_.join();
    }
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// Takes the place of a job that waits, and ends one in hand at its next checkpoint; but never
    /// two in a row, so that somebody who asks all the time sees something.
    void ask(Job job) {
        {
            const std::lock_guard lock(mutex_);
            next_ = std::move(job);
            done_.reset();
        }
        changed_.notify_all();
    }

    /// What the latest job gave, once; nothing while it is in hand. Throws what the job threw.
    std::optional<Result> take() {
        std::optional<Done> done;
        {
            const std::lock_guard lock(mutex_);
            done.swap(done_);
        }
        if (!done) return {};
        if (done->error) std::rethrow_exception(done->error);
        return std::move(done->result);
    }

    /// There is, or will be, something to take().
    [[nodiscard]] bool busy() const {
        const std::lock_guard lock(mutex_);
        return working_ || next_ || done_;
    }

  private:
    struct Done {
        std::optional<Result> result;
        std::exception_ptr error;
    };

    void run() {
        for (;;) {
            Job job;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] { return ending_ || next_; });
                if (ending_) return;
                job = std::move(*next_);
                next_.reset();
                working_ = true;
            }
            bool dropped = false;
            Done done = work(job, dropped);
            job = nullptr;  // what it holds goes on this thread, before anybody hears of the result
            {
                const std::lock_guard lock(mutex_);
                working_ = false;
                droppedLast_ = dropped;
                if (!dropped) done_ = std::move(done);
            }
            if (!dropped) ring_();
        }
    }

    Done work(const Job& job, bool& dropped) {
        Done done;
        const auto isOvertaken = [this] {
            const std::lock_guard lock(mutex_);
            return ending_ || (next_ && !droppedLast_);
        };
        try {
            done.result = job([&] {
                if (isOvertaken()) throw Overtaken{};
            });
            dropped = isOvertaken();
        } catch (const Overtaken&) {
            dropped = true;
        } catch (...) {
            done.error = std::current_exception();
            dropped = isOvertaken();
        }
        return done;
    }

    std::function<void()> ring_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Job> next_;
    std::optional<Done> done_;
    bool working_ = false, ending_ = false, droppedLast_ = false;
    std::thread thread_;  // last: it uses the others
};

}  // namespace vitrine
