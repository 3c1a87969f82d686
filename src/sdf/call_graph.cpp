// SPDX-License-Identifier: MIT
#include "sdf/call_graph.hpp"

#include <algorithm>
#include <vector>

namespace vitrine::glsl {

namespace {

/// Depth-first search: a call of a function that is still on the path closes a circle.
class CircleFinder {
  public:
    CircleFinder(std::span<const Function> functions, Problems& problems)
        : functions_(functions), problems_(problems), done_(functions.size()) {}

    void run() {
        for (size_t root = 0; root < functions_.size(); ++root)
            if (!done_[root]) visitFrom(root);
    }

  private:
    struct Step {
        size_t function;
        size_t nextCall;
    };

    void visitFrom(size_t root) {
        path_.push_back({root, 0});
        while (!path_.empty()) {
            Step& step = path_.back();
            const Function& function = functions_[step.function];
            if (step.nextCall == function.calls.size()) {
                done_[step.function] = true;
                path_.pop_back();
                continue;
            }
            const Function::Call& call = function.calls[step.nextCall++];
            const auto start = std::find_if(path_.begin(), path_.end(), [&](const Step& s) {
                return s.function == call.callee;
            });
            if (start != path_.end())
                report(static_cast<size_t>(start - path_.begin()), call);
            else if (!done_[call.callee])
                path_.push_back({call.callee, 0});
        }
    }

    void report(size_t start, const Function::Call& call) {
        const std::string& name = functions_[call.callee].name;
        std::string circle;
        for (size_t i = start; i < path_.size(); ++i)
            circle += functions_[path_[i].function].name + " -> ";
        problems_.error(call.place, "'" + name + "' calls itself (" + circle + name +
                                        "), and GLSL has no recursion");
    }

    std::span<const Function> functions_;
    Problems& problems_;
    std::vector<bool> done_;
    std::vector<Step> path_;
};

}  // namespace

void checkCalls(std::span<const Function> functions, Problems& problems) {
    CircleFinder(functions, problems).run();
    std::vector<bool> reported(functions.size());
    for (const Function& function : functions) {
        for (const Function::Call& call : function.calls) {
            if (functions[call.callee].defined || reported[call.callee]) continue;
            reported[call.callee] = true;
            problems.error(call.place, "'" + functions[call.callee].name +
                                           "' is declared, but its body is missing");
        }
    }
}

}  // namespace vitrine::glsl
