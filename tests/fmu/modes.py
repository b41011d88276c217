"""Every function of FMI in every mode: what the standard allows there works, the rest is refused with a message."""

import ctypes
import os
from ctypes import byref, c_bool, c_char_p, c_double, c_int, c_size_t, c_uint32, c_void_p

import fmpy

NUMBER, COUNT = c_double, c_size_t
LOG = ctypes.CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)
LOG_OF_2 = ctypes.CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p)

# FMI 3.0.2, "Allowed Function Calls" of each state: sections 2.3.2 to 2.3.9, 3.2.1, 4.2.1. The numbers of states and of event
# indicators are constants, which this FMU tells in every mode of model exchange.
ALWAYS = "SetDebugLogging GetFMUState Reset"
CONSTANTS = "GetNumberOfContinuousStates GetNumberOfEventIndicators"
EXCHANGE = "GetContinuousStates GetContinuousStateDerivatives GetEventIndicators GetNominalsOfContinuousStates"
EXCHANGE_MODES = {
    "Instantiated": "GetFloat64 SetFloat64 EnterInitializationMode",
    "Initialization": f"GetFloat64 SetFloat64 {EXCHANGE} GetDirectionalDerivative ExitInitializationMode",
    "Event": f"GetFloat64 SetFloat64 {EXCHANGE} GetDirectionalDerivative UpdateDiscreteStates EnterContinuousTimeMode Terminate",
    "ContinuousTime": f"GetFloat64 SetFloat64 {EXCHANGE} GetDirectionalDerivative SetTime SetContinuousStates "
    "CompletedIntegratorStep EnterEventMode Terminate",
    "Terminated": f"GetFloat64 {EXCHANGE} GetDirectionalDerivative",
}
CO_SIMULATION_MODES = {
    "Instantiated": "GetFloat64 SetFloat64 EnterInitializationMode",
    "Initialization": "GetFloat64 SetFloat64 GetDirectionalDerivative ExitInitializationMode",
    "Event": "GetFloat64 SetFloat64 GetDirectionalDerivative UpdateDiscreteStates EnterStepMode Terminate",
    "Step": "GetFloat64 SetFloat64 GetDirectionalDerivative DoStep EnterEventMode Terminate",
    "Terminated": "GetFloat64 GetDirectionalDerivative",
}
# How a mode is reached.
BEGIN = "EnterInitializationMode"
PATHS = {
    "Instantiated": "",
    "Initialization": BEGIN,
    "Event": f"{BEGIN} ExitInitializationMode",
    "ContinuousTime": f"{BEGIN} ExitInitializationMode EnterContinuousTimeMode",
    "Step": f"{BEGIN} ExitInitializationMode EnterStepMode",
    "Terminated": f"{BEGIN} ExitInitializationMode Terminate",
}
# What a mechanism does not have: never allowed.
ABSENT = """EnterConfigurationMode ExitConfigurationMode EvaluateDiscreteStates GetNumberOfVariableDependencies GetInt32 SetInt32
    GetBoolean SetBoolean GetString GetClock SetClock GetAdjointDerivative GetOutputDerivatives ActivateModelPartition""".split()
EVERY = sorted({*" ".join([*EXCHANGE_MODES.values(), *CO_SIMULATION_MODES.values(), ALWAYS, CONSTANTS]).split(), *ABSENT})



# FMI 2.0.5, the tables of sections 3.2.3 and 4.2.4: the same protocol but for these names, what it does not have, and what it adds.
# This FMU reads before the start too, as in 3.0.
NAMES_OF_2 = {
    "GetFloat64": "GetReal",
    "SetFloat64": "SetReal",
    "GetContinuousStateDerivatives": "GetDerivatives",
    "UpdateDiscreteStates": "NewDiscreteStates",
    "GetFMUState": "GetFMUstate",
}
NOT_IN_2 = set(CONSTANTS.split()) | {"EnterStepMode", *ABSENT}
ABSENT_IN_2 = """GetBoolean SetBoolean GetString SetString SetRealInputDerivatives GetRealOutputDerivatives CancelStep GetStatus
    GetIntegerStatus GetStringStatus""".split()
ADDED_BY_2 = {
    ("ModelExchange", "Instantiated"): "SetupExperiment GetNominalsOfContinuousStates",
    ("ModelExchange", "Event"): "EnterEventMode",
    ("CoSimulation", "Instantiated"): "SetupExperiment",
    ("CoSimulation", "Step"): "GetRealStatus GetBooleanStatus",
    ("CoSimulation", "Terminated"): "GetRealStatus GetBooleanStatus",
}


class Callbacks(ctypes.Structure):
    """fmi2CallbackFunctions"""

    _fields_ = [("logger", LOG_OF_2), ("others", c_void_p * 3), ("environment", c_void_p)]


class EventInfo(ctypes.Structure):
    """fmi2EventInfo"""

    _fields_ = [("flags", c_int * 5), ("next", c_double)]


class Numbers:
    """Arguments of every function, for an FMU with this input, this output, and so many states and indicators."""

    def __init__(self, version, known, unknown, states, indicators):
        self.version = version
        flag = c_bool if version == 3 else c_int
        one, room = (c_double * 1)(1.0), (c_double * max(states, indicators, 1))()
        reference = lambda number: (c_uint32 * 1)(number)
        flags = [byref(flag()) for _ in range(5)]
        vector, array = lambda count: (room, COUNT(count)), lambda number: (reference(number), COUNT(1))
        # Counts of values that are as many as their references.
        again = (COUNT(1),) if version == 3 else ()
        self.state = c_void_p()
        self.arguments = {
            "SetDebugLogging": (flag(True), COUNT(0), None),
            "GetFMUState": (byref(self.state),),
            "SetupExperiment": (flag(False), NUMBER(0), NUMBER(0), flag(False), NUMBER(0)),
            "EnterInitializationMode": (flag(False), NUMBER(0), NUMBER(0), flag(False), NUMBER(0)) if version == 3 else (),
            "GetFloat64": (*array(unknown), (c_double * 1)(), *again),
            "SetFloat64": (*array(known), one, *again),
            "GetDirectionalDerivative": (*array(unknown), *array(known), one, *again, (c_double * 1)(), *again),
            "UpdateDiscreteStates": (*flags, byref(c_double())) if version == 3 else (byref(EventInfo()),),
            "CompletedIntegratorStep": (flag(True), flags[0], flags[1]),
            "SetTime": (NUMBER(0),),
            "SetContinuousStates": None,
            "GetContinuousStates": vector(states),
            "GetContinuousStateDerivatives": vector(states),
            "GetEventIndicators": vector(indicators),
            "GetNominalsOfContinuousStates": vector(states),
            "GetNumberOfContinuousStates": (byref(c_size_t()),),
            "GetNumberOfEventIndicators": (byref(c_size_t()),),
            "DoStep": (NUMBER(0), NUMBER(1e-3), flag(True), *((*flags[:3], byref(c_double())) if version == 3 else ())),
            "GetRealStatus": (c_int(2), byref(c_double())),
            "GetBooleanStatus": (c_int(3), flags[0]),
        }
        self.room = vector(states)

    def call(self, library, instance, name):
        """0 where the function did it."""
        arguments = self.arguments.get(name, ())
        if name == "SetContinuousStates":
            # As they are: any others may be no pose of the mechanism.
            if self.function(library, "GetContinuousStates")(instance, *self.room):
                return 3
            arguments = self.room
        return self.function(library, name)(instance, *arguments)

    def function(self, library, name):
        own = NAMES_OF_2.get(name, name) if self.version == 2 else name
        return getattr(library, f"fmi{self.version}{own}")


class Made:
    """Instances of an FMU, and what they say."""

    def __init__(self, folder, about):
        self.version = int(about.fmiVersion[0])
        name = about.coSimulation.modelIdentifier + fmpy.sharedLibraryExtension
        place = fmpy.platform_tuple if self.version == 3 else fmpy.platform
        self.library = ctypes.CDLL(os.path.join(folder, "binaries", place, name))
        self.token = (about.instantiationToken if self.version == 3 else about.guid).encode()
        self.heard = []
        self.log = LOG(lambda environment, status, category, message: self.heard.append(message.decode()))
        self.callbacks = Callbacks(LOG_OF_2(lambda environment, name, *rest: self.heard.append(rest[-1].decode())))
        functions = ("3InstantiateModelExchange", "3InstantiateCoSimulation") if self.version == 3 else ("2Instantiate",)
        for function in functions:
            getattr(self.library, "fmi" + function).restype = c_void_p

    def one(self, interface):
        no = (c_bool if self.version == 3 else c_int)(False)
        if self.version == 2:
            kind = c_int(0 if interface == "ModelExchange" else 1)
            return c_void_p(self.library.fmi2Instantiate(b"one", kind, self.token, None, byref(self.callbacks), no, no))
        arguments = (b"one", self.token, None, no, no)
        if interface == "ModelExchange":
            return c_void_p(self.library.fmi3InstantiateModelExchange(*arguments, None, self.log))
        events = c_bool(interface == "CoSimulation with events")
        return c_void_p(
            self.library.fmi3InstantiateCoSimulation(*arguments, events, events, None, COUNT(0), None, self.log, None)
        )


def tables(version):
    """Of every interface: the modes, and what is allowed in each."""
    exchange = {mode: f"{words} {CONSTANTS} {ALWAYS}".split() for mode, words in EXCHANGE_MODES.items()}
    with_events = {mode: f"{words} {ALWAYS}".split() for mode, words in CO_SIMULATION_MODES.items()}
    without = {
        mode: [call for call in calls if call != "EnterEventMode"] for mode, calls in with_events.items() if mode != "Event"
    }
    if version == 3:
        return {"ModelExchange": exchange, "CoSimulation with events": with_events, "CoSimulation": without}
    both = {"ModelExchange": exchange, "CoSimulation": without}
    return {
        interface: {
            mode: [call for call in calls if call not in NOT_IN_2] + ADDED_BY_2.get((interface, mode), "").split()
            for mode, calls in modes.items()
        }
        for interface, modes in both.items()
    }


def every(version):
    """The functions that are tried."""
    if version == 3:
        return EVERY
    added = " ".join(ADDED_BY_2.values()).split()
    return sorted({*(call for call in EVERY if call not in NOT_IN_2), *added, *ABSENT_IN_2})


def check(folder, about, known, unknown, expect):
    """Calls every function in every mode of every interface."""
    made = Made(folder, about)
    version, library, heard = made.version, made.library, made.heard
    states = sum(variable.derivative is not None for variable in about.modelVariables)
    indicators = sum(variable.name.startswith("indicator(") for variable in about.modelVariables)
    pairs = 0
    for interface, modes in tables(version).items():
        for mode, allowed in modes.items():
            path = [call for call in PATHS[mode].split() if interface == "CoSimulation with events" or call != "EnterStepMode"]
            for call in every(version):
                numbers, instance = Numbers(version, known, unknown, states, indicators), made.one(interface)
                for step in path:
                    if numbers.call(library, instance, step):
                        return expect(False, f"{interface}: {step} on the way to {mode} {heard}")
                heard.clear()
                outcome = numbers.call(library, instance, call)
                pairs += 1
                if (outcome == 0) != (call in allowed) or bool(heard) != (outcome != 0):
                    return expect(False, f"{interface}, {mode}: {call} gives {outcome} {heard}")
                if numbers.state:
                    forget = library.fmi3FreeFMUState if version == 3 else library.fmi2FreeFMUstate
                    forget(instance, byref(numbers.state))
                (library.fmi3FreeInstance if version == 3 else library.fmi2FreeInstance)(instance)
    expect(True, f"the modes of FMI {about.fmiVersion}, {pairs} pairs of function and mode")
