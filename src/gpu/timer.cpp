// SPDX-License-Identifier: MIT
#include "gpu/timer.hpp"

#include <epoxy/gl.h>

namespace vitrine {

PassTimer::~PassTimer() {
    for (const Pending& p : pending_) glDeleteQueries(1, &p.query);
}

void PassTimer::begin(const std::string& pass) {
    current_ = pass;
    if (wall_) {
        glFinish();
        start_ = std::chrono::steady_clock::now();
        return;
    }
    Pending pending{pass, 0};
    glGenQueries(1, &pending.query);
    glBeginQuery(GL_TIME_ELAPSED, pending.query);
    pending_.push_back(pending);
}

void PassTimer::end() {
    if (wall_) {
        glFinish();
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
        seconds_[current_] += elapsed.count();
        return;
    }
    glEndQuery(GL_TIME_ELAPSED);
}

const std::map<std::string, double>& PassTimer::seconds() {
    for (const Pending& p : pending_) {
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(p.query, GL_QUERY_RESULT, &nanoseconds);
        seconds_[p.pass] += static_cast<double>(nanoseconds) * 1e-9;
        glDeleteQueries(1, &p.query);
    }
    pending_.clear();
    return seconds_;
}

void PassTimer::reset() {
    (void)seconds();
    seconds_.clear();
}

}  // namespace vitrine
