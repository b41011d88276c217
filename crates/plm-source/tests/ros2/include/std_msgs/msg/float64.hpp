// A stand-in for the message std_msgs/Float64.

#pragma once

#include <memory>

namespace std_msgs::msg {
struct Float64 {
  using ConstSharedPtr = std::shared_ptr<const Float64>;
  double data = 0.0;
};
}  // namespace std_msgs::msg
