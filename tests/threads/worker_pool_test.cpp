// The pool on its own: many short jobs, nobody left behind, nobody waited for in vain.
#include "threads/worker_pool.hpp"

#include <gtest/gtest.h>

namespace glint::test {
namespace {

TEST(WorkerPool, does_every_part_of_every_job_once) {
    for (const unsigned threads : {1u, 2u, 5u}) {
        WorkerPool pool(threads);
        ASSERT_EQ(pool.threads(), threads);
        for (int job = 0; job < 2000; ++job) {
            std::atomic<int> next{0}, sum{0};
            pool.run([&](unsigned worker) {
                ASSERT_LT(worker, threads);
                for (int part = next.fetch_add(1); part < 20; part = next.fetch_add(1)) sum += part;
            });
            ASSERT_EQ(sum, 190);
        }
    }
}

TEST(WorkerPool, lets_every_worker_join_a_long_job) {
    WorkerPool pool(4);
    std::atomic<int> joined{0};
    pool.run([&](unsigned) {
        ++joined;
        // Whoever is in waits for the others: this ends only when all four have joined.
        while (joined.load() < 4) std::this_thread::yield();
    });
    EXPECT_EQ(joined, 4);
}

TEST(WorkerPool, wakes_workers_that_fell_asleep) {
    WorkerPool pool(2);
    for (int job = 0; job < 3; ++job) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        std::atomic<int> joined{0};
        pool.run([&](unsigned) {
            ++joined;
            while (joined.load() < 2) std::this_thread::yield();
        });
        EXPECT_EQ(joined, 2);
    }
}

TEST(WorkerPool, can_be_made_and_dropped_at_once) {
    for (int i = 0; i < 200; ++i) WorkerPool pool(3);
}

} // namespace
} // namespace glint::test
