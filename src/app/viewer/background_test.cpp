// SPDX-License-Identifier: MIT
#include "app/viewer/background.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <string>

namespace vitrine {
namespace {

using namespace std::chrono_literals;
using Worker = Background<std::string>;

/// Waits for what is to come; fails instead of hanging.
std::string takeSoon(Worker& worker) {
    for (int i = 0; i < 2000; ++i) {
        if (auto result = worker.take()) return *result;
        std::this_thread::sleep_for(5ms);
    }
    ADD_FAILURE() << "nothing came";
    return "";
}

/// A job that waits at its checkpoint until it is let go or overtaken.
struct Slow {
    std::shared_ptr<std::atomic<bool>> begun = std::make_shared<std::atomic<bool>>(false);
    std::shared_ptr<std::atomic<bool>> mayEnd = std::make_shared<std::atomic<bool>>(false);
    std::string name;

    std::string operator()(const Checkpoint& checkpoint) const {
        *begun = true;
        while (!*mayEnd) {
            checkpoint();
            std::this_thread::sleep_for(1ms);
        }
        return name;
    }
    void awaitBegin() const {
        while (!*begun) std::this_thread::sleep_for(1ms);
    }
};

Slow slow(const std::string& name) {
    Slow job;
    job.name = name;
    return job;
}

TEST(Background, GivesEachResultOnceAndRings) {
    std::atomic<int> rings = 0;
    Worker worker([&] { ++rings; });
    EXPECT_FALSE(worker.busy());
    EXPECT_FALSE(worker.take());
    worker.ask([](const Checkpoint&) { return std::string("one"); });
    EXPECT_TRUE(worker.busy());
    EXPECT_EQ(takeSoon(worker), "one");
    EXPECT_FALSE(worker.take());
    EXPECT_FALSE(worker.busy());
    worker.ask([](const Checkpoint&) { return std::string("two"); });
    EXPECT_EQ(takeSoon(worker), "two");
    while (rings < 2) std::this_thread::sleep_for(1ms);
}

TEST(Background, TheNewestWins) {
    Worker worker([] {});
    const Slow first = slow("first");
    worker.ask(first);
    first.awaitBegin();
    std::atomic<bool> secondRan = false;
    worker.ask([&](const Checkpoint&) {
        secondRan = true;
        return std::string("second");
    });
    worker.ask([](const Checkpoint&) { return std::string("third"); });
    const std::string result = takeSoon(worker);
    // The second may have been begun when the third came.
    EXPECT_TRUE(result == "third" || (result == "second" && takeSoon(worker) == "third")) << result;
    if (!secondRan) {
        EXPECT_EQ(result, "third");
    }
    EXPECT_FALSE(worker.take());
}

TEST(Background, AResultThatWasOvertakenIsNeverSeen) {
    Worker worker([] {});
    std::promise<void> begun, mayEnd;
    // Without checkpoints: it ends, but too late.
    worker.ask([&](const Checkpoint&) {
        begun.set_value();
        mayEnd.get_future().wait();
        return std::string("old");
    });
    begun.get_future().wait();
    const Slow next = slow("new");
    worker.ask(next);
    mayEnd.set_value();
    next.awaitBegin();
    EXPECT_FALSE(worker.take());
    *next.mayEnd = true;
    EXPECT_EQ(takeSoon(worker), "new");

    // Nor one that nobody has taken when the next is asked for.
    worker.ask([](const Checkpoint&) { return std::string("not taken"); });
    while (!worker.busy()) std::this_thread::sleep_for(1ms);
    std::this_thread::sleep_for(20ms);
    const Slow last = slow("last");
    worker.ask(last);
    EXPECT_FALSE(worker.take());
    *last.mayEnd = true;
    EXPECT_EQ(takeSoon(worker), "last");
}

TEST(Background, WhoAsksAllTheTimeSeesEverySecondResult) {
    Worker worker([] {});
    const Slow a = slow("a"), b = slow("b"), c = slow("c");
    worker.ask(a);
    a.awaitBegin();
    worker.ask(b);  // ends a
    b.awaitBegin();
    worker.ask(c);  // does not end b
    std::this_thread::sleep_for(20ms);
    EXPECT_FALSE(*c.begun);
    *b.mayEnd = true;
    EXPECT_EQ(takeSoon(worker), "b");
    *c.mayEnd = true;
    EXPECT_EQ(takeSoon(worker), "c");
}

TEST(Background, WhatAJobThrowsIsThrownByTake) {
    Worker worker([] {});
    worker.ask([](const Checkpoint&) -> std::string { throw std::runtime_error("no memory"); });
    EXPECT_THROW((void)takeSoon(worker), std::runtime_error);
    worker.ask([](const Checkpoint&) { return std::string("it goes on"); });
    EXPECT_EQ(takeSoon(worker), "it goes on");
}

TEST(Background, GoesWhileBusy) {
    const Slow job = slow("never");
    std::atomic<bool> destroyed = false;
    {
        Worker worker([] {});
        // What a job holds goes with it.
        const std::shared_ptr<void> held(nullptr, [&](void*) { destroyed = true; });
        worker.ask([job, held](const Checkpoint& checkpoint) { return job(checkpoint); });
        job.awaitBegin();
        worker.ask([](const Checkpoint&) { return std::string("waits in vain"); });
    }
    EXPECT_TRUE(destroyed);
}

}  // namespace
}  // namespace vitrine
