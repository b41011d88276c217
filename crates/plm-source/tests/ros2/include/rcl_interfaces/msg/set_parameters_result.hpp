// A stand-in for the message rcl_interfaces/SetParametersResult.

#pragma once

#include <string>

namespace rcl_interfaces::msg {
struct SetParametersResult {
  bool successful = false;
  std::string reason;
};
}  // namespace rcl_interfaces::msg
