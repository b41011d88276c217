// A stand-in for rclcpp: the signatures that a node uses, as the documentation of rclcpp has them, and an executor whose clock and messages
// come from standard input. Each line of it is an event, and what is published is printed.
//
//   tick COUNT                  the timer goes off
//   input TOPIC NUMBER          a message arrives
//   set PARAMETER NUMBER        somebody sets a parameter
//   call SERVICE                somebody calls a service
//
// Parameters at the start are words `NAME:=VALUE` of the command line.

#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <builtin_interfaces/msg/time.hpp>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <rcl_interfaces/msg/set_parameters_result.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_srvs/srv/trigger.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

namespace rclcpp {

inline std::map<std::string, std::string> overrides;

inline void init(int argc, char **argv) {
  for (int k = 1; k < argc; k++) {
    const std::string word = argv[k];
    const auto at = word.find(":=");
    if (at != std::string::npos) {
      overrides[word.substr(0, at)] = word.substr(at + 2);
    }
  }
}

inline bool shutdown() { return true; }

class Logger {
 public:
  std::string name;
};

inline Logger get_logger(const std::string &name) { return Logger{name}; }

#define RCLCPP_ERROR(logger, ...) ((void)(logger), std::printf("error "), std::printf(__VA_ARGS__), std::printf("\n"))
#define RCLCPP_FATAL(logger, ...) ((void)(logger), std::printf("fatal "), std::printf(__VA_ARGS__), std::printf("\n"))

class Time {
 public:
  operator builtin_interfaces::msg::Time() const { return {}; }
};

class Parameter {
 public:
  Parameter(const std::string &name, double value) : name_(name), value_(value) {}
  const std::string &get_name() const { return name_; }
  double as_double() const { return value_; }

 private:
  std::string name_;
  double value_;
};

class TimerBase {
 public:
  using SharedPtr = std::shared_ptr<TimerBase>;
  std::chrono::nanoseconds period;
  std::function<void()> callback;
};

class SubscriptionBase {
 public:
  using SharedPtr = std::shared_ptr<SubscriptionBase>;
  std::function<void(double)> hear;
};

template <typename Message>
class Subscription : public SubscriptionBase {
 public:
  using SharedPtr = std::shared_ptr<Subscription<Message>>;
};

inline void show(const std::string &topic, const std_msgs::msg::Float64 &message) {
  std::printf("%s %a\n", topic.c_str(), message.data);
}

inline void show(const std::string &topic, const tf2_msgs::msg::TFMessage &message) {
  for (const auto &each : message.transforms) {
    const auto &[x, y, z] = each.transform.translation;
    const auto &turn = each.transform.rotation;
    std::printf("%s %s %s %a %a %a %a %a %a %a\n", topic.c_str(), each.header.frame_id.c_str(), each.child_frame_id.c_str(), x, y, z,
                turn.x, turn.y, turn.z, turn.w);
  }
}

template <typename Message>
class Publisher {
 public:
  using SharedPtr = std::shared_ptr<Publisher<Message>>;
  std::string topic;
  void publish(const Message &message) { show(topic, message); }
};

template <typename Kind>
class Service {
 public:
  using SharedPtr = std::shared_ptr<Service<Kind>>;
};

namespace node_interfaces {
class OnSetParametersCallbackHandle {
 public:
  using SharedPtr = std::shared_ptr<OnSetParametersCallbackHandle>;
  std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<Parameter> &)> callback;
};
}  // namespace node_interfaces

class Node {
 public:
  explicit Node(const std::string &name) : name_(name) {}
  virtual ~Node() = default;

  const char *get_name() const { return name_.c_str(); }
  Logger get_logger() const { return Logger{name_}; }
  Time now() const { return {}; }

  template <typename Value>
  Value declare_parameter(const std::string &name, const Value &usual) {
    const auto given = overrides.find(name);
    if (given == overrides.end()) {
      return usual;
    }
    std::istringstream text(given->second);
    Value value;
    text >> value;
    return value;
  }

  template <typename Callback>
  node_interfaces::OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(Callback &&callback) {
    change = std::make_shared<node_interfaces::OnSetParametersCallbackHandle>();
    change->callback = callback;
    return change;
  }

  template <typename Message, typename Callback>
  typename Subscription<Message>::SharedPtr create_subscription(const std::string &topic, int, Callback &&callback) {
    auto made = std::make_shared<Subscription<Message>>();
    made->hear = [callback](double value) mutable {
      auto message = std::make_shared<Message>();
      message->data = value;
      callback(message);
    };
    subscriptions[topic] = made;
    return made;
  }

  template <typename Message>
  typename Publisher<Message>::SharedPtr create_publisher(const std::string &topic, int) {
    auto made = std::make_shared<Publisher<Message>>();
    made->topic = topic;
    return made;
  }

  template <typename Kind, typename Callback>
  typename Service<Kind>::SharedPtr create_service(const std::string &topic, Callback &&callback) {
    services[topic] = [callback]() mutable {
      auto response = std::make_shared<typename Kind::Response>();
      callback(std::make_shared<typename Kind::Request>(), response);
      return response->success;
    };
    return std::make_shared<Service<Kind>>();
  }

  template <typename Callback>
  TimerBase::SharedPtr create_wall_timer(std::chrono::nanoseconds period, Callback &&callback) {
    timer = std::make_shared<TimerBase>();
    timer->period = period;
    timer->callback = callback;
    return timer;
  }

  TimerBase::SharedPtr timer;
  node_interfaces::OnSetParametersCallbackHandle::SharedPtr change;
  std::map<std::string, SubscriptionBase::SharedPtr> subscriptions;
  std::map<std::string, std::function<bool()>> services;

 private:
  std::string name_;
};

inline void spin(const std::shared_ptr<Node> &node) {
  std::printf("period %lld ns\n", static_cast<long long>(node->timer->period.count()));
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    std::string event, name;
    double number = 0.0;
    words >> event;
    if (event == "tick") {
      for (words >> number; number > 0.0; number--) {
        node->timer->callback();
      }
      continue;
    }
    words >> name >> number;
    if (event == "input") {
      node->subscriptions.at(name)->hear(number);
    } else if (event == "set") {
      const auto result = node->change->callback({Parameter(name, number)});
      std::printf("set %d %s\n", result.successful, result.reason.c_str());
    } else if (event == "call") {
      std::printf("call %d\n", node->services.at(name)());
    }
  }
}

}  // namespace rclcpp
