"""Every function of FMI in every mode: what the standard allows there works, the rest is refused with a message."""

import ctypes
import os
from ctypes import byref, c_bool, c_char_p, c_double, c_int, c_size_t, c_uint32, c_void_p

import fmpy

NUMBER, COUNT, FLAG = c_double, c_size_t, c_bool
LOG = ctypes.CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)

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


class Numbers:
    """Arguments of every function, for an FMU with this input, this output, and so many states and indicators."""

    def __init__(self, known, unknown, states, indicators):
        one, room = (c_double * 1)(1.0), (c_double * max(states, indicators, 1))()
        reference = lambda number: (c_uint32 * 1)(number)
        flags = [byref(c_bool()) for _ in range(5)]
        vector, array = lambda count: (room, COUNT(count)), lambda number: (reference(number), COUNT(1))
        self.state = c_void_p()
        self.arguments = {
            "SetDebugLogging": (FLAG(True), COUNT(0), None),
            "GetFMUState": (byref(self.state),),
            "EnterInitializationMode": (FLAG(False), NUMBER(0), NUMBER(0), FLAG(False), NUMBER(0)),
            "GetFloat64": (*array(unknown), (c_double * 1)(), COUNT(1)),
            "SetFloat64": (*array(known), one, COUNT(1)),
            "GetDirectionalDerivative": (*array(unknown), *array(known), one, COUNT(1), (c_double * 1)(), COUNT(1)),
            "UpdateDiscreteStates": (*flags, byref(c_double())),
            "CompletedIntegratorStep": (FLAG(True), flags[0], flags[1]),
            "SetTime": (NUMBER(0),),
            "SetContinuousStates": None,
            "GetContinuousStates": vector(states),
            "GetContinuousStateDerivatives": vector(states),
            "GetEventIndicators": vector(indicators),
            "GetNominalsOfContinuousStates": vector(states),
            "GetNumberOfContinuousStates": (byref(c_size_t()),),
            "GetNumberOfEventIndicators": (byref(c_size_t()),),
            "DoStep": (NUMBER(0), NUMBER(1e-3), FLAG(True), *flags[:3], byref(c_double())),
        }
        self.room = vector(states)

    def call(self, library, instance, name):
        """0 where the function did it."""
        arguments = self.arguments.get(name, ())
        if name == "SetContinuousStates":
            # As they are: any others may be no pose of the mechanism.
            if library.fmi3GetContinuousStates(instance, *self.room):
                return 3
            arguments = self.room
        return getattr(library, "fmi3" + name)(instance, *arguments)


def check(folder, about, known, unknown, expect):
    """Calls every function in every mode of both interfaces."""
    name = about.coSimulation.modelIdentifier + fmpy.sharedLibraryExtension
    library = ctypes.CDLL(os.path.join(folder, "binaries", fmpy.platform_tuple, name))
    for name in ("ModelExchange", "CoSimulation"):
        getattr(library, "fmi3Instantiate" + name).restype = c_void_p
    heard = []
    log = LOG(lambda environment, status, category, message: heard.append(message.decode()))
    token = about.instantiationToken.encode()
    states = sum(variable.derivative is not None for variable in about.modelVariables)
    indicators = sum(variable.name.startswith("indicator(") for variable in about.modelVariables)

    def made(interface):
        arguments = (b"one", token, None, FLAG(False), FLAG(False))
        if interface == "ModelExchange":
            return c_void_p(library.fmi3InstantiateModelExchange(*arguments, None, log))
        events = FLAG(interface == "CoSimulation with events")
        return c_void_p(library.fmi3InstantiateCoSimulation(*arguments, events, events, None, COUNT(0), None, log, None))

    pairs = 0
    for interface, modes in (
        ("ModelExchange", EXCHANGE_MODES),
        ("CoSimulation with events", CO_SIMULATION_MODES),
        ("CoSimulation", {mode: words for mode, words in CO_SIMULATION_MODES.items() if mode != "Event"}),
    ):
        for mode, words in modes.items():
            allowed = (ALWAYS + " " + words).split() + (CONSTANTS.split() if interface == "ModelExchange" else [])
            path = PATHS[mode].split()
            if interface == "CoSimulation":
                path = [call for call in path if call != "EnterStepMode"]
                allowed = [call for call in allowed if call != "EnterEventMode"]
            for call in EVERY:
                numbers, instance = Numbers(known, unknown, states, indicators), made(interface)
                for step in path:
                    if numbers.call(library, instance, step):
                        return expect(False, f"{interface}: {step} on the way to {mode} {heard}")
                heard.clear()
                outcome = numbers.call(library, instance, call)
                pairs += 1
                if (outcome == 0) != (call in allowed) or bool(heard) != (outcome != 0):
                    return expect(False, f"{interface}, {mode}: {call} gives {outcome} {heard}")
                if numbers.state:
                    library.fmi3FreeFMUState(instance, byref(numbers.state))
                library.fmi3FreeInstance(instance)
    expect(True, f"the modes of FMI, {pairs} pairs of function and mode")
