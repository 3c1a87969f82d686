// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.hpp"

namespace vitrine {

/// There is no display to open a window on. Not a fault: there is a way without one.
class NoDisplay : public MachineError {
  public:
    using MachineError::MachineError;
};

}  // namespace vitrine
