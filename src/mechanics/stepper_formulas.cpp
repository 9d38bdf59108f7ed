// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/stepper.h"

namespace millwright::mechanics {

void define_stepper(FormulaList& list) {
  define(
      list,
      {.name = "stepper.electrical_frequency",
       .handbook_id = "STEP-ELEC-FREQUENCY",
       .symbol = "f_e",
       .unit = "Hz",
       .title = "Frequency of the phase currents, a quarter of the full-step rate",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::electrical_frequency(x...); },
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100).rising(),
      quantity("angular_speed", "ω", "rad/s", "shaft speed").rising());

  define(
      list,
      {.name = "stepper.pulse_rate",
       .handbook_id = "STEP-PULSE-RATE",
       .symbol = "f_step",
       .unit = "Hz",
       .title = "Step pulses per second the controller has to send",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::pulse_rate(x...); },
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100).rising(),
      count("microsteps", "μ_s", "microsteps per full step").typical(1, 64).rising(),
      quantity("angular_speed", "ω", "rad/s", "shaft speed").rising());

  define(
      list,
      {.name = "stepper.torque_constant",
       .handbook_id = "STEP-TORQUE-CONSTANT",
       .symbol = "K_m",
       .unit = "N.m/A",
       .title = "Torque per ampere of phase-current amplitude",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state; saturation makes it "
                   "10 to 18 % larger at small currents"},
      [](const auto&... x) { return stepper::torque_constant(x...); },
      quantity("holding_torque", "T_h", "N.m", "holding torque (two phases on, each at I_r)").typical(0.1, 5).rising(),
      quantity("rated_current", "I_r", "A", "rated phase current").typical(0.5, 6).falling());

  define(
      list,
      {.name = "stepper.static_torque",
       .handbook_id = "STEP-STATIC-TORQUE",
       .symbol = "T_s",
       .unit = "N.m",
       .title = "Torque amplitude at standstill and low speed at the current set at the driver",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::static_torque(x...); },
      quantity("torque_constant", "K_m", "N.m/A", "torque constant").typical(0.1, 1).rising(),
      quantity("current_amplitude", "I_p", "A", "amplitude of the phase current").typical(0.5, 6).rising());

  define(
      list,
      {.name = "stepper.back_emf",
       .handbook_id = "STEP-BACK-EMF",
       .symbol = "E",
       .unit = "V",
       .title = "Peak voltage induced in one phase",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::back_emf(x...); },
      quantity("torque_constant", "K_m", "N.m/A", "torque constant").typical(0.1, 1).rising(),
      quantity("angular_speed", "ω", "rad/s", "shaft speed").rising());

  define(
      list,
      {.name = "stepper.electrical_time_constant",
       .handbook_id = "STEP-ELEC-TIME-CONSTANT",
       .symbol = "τ",
       .unit = "s",
       .title = "Time constant of the current in one phase",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::electrical_time_constant(x...); },
      quantity("inductance", "L_ph", "H", "phase inductance").typical(1e-3, 1e-2).rising(),
      quantity("resistance", "R", "ohm", "phase circuit resistance").typical(0.3, 5).falling());

  define(
      list,
      {.name = "stepper.corner_speed",
       .handbook_id = "STEP-CORNER-SPEED",
       .symbol = "ω_c",
       .unit = "rad/s",
       .title = "Highest speed at which the supply can still drive the full current with the current vector square to "
                "the flux",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::corner_speed(x...); },
      quantity("voltage", "V", "V", "usable supply voltage").typical(10, 60).rising(),
      quantity("resistance", "R", "ohm", "phase circuit resistance").typical(0.3, 5).falling(),
      quantity("inductance", "L_ph", "H", "phase inductance").typical(1e-3, 1e-2).falling(),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100).falling(),
      quantity("torque_constant", "K_m", "N.m/A", "torque constant").typical(0.1, 1).falling(),
      quantity("current_amplitude", "I_p", "A", "current amplitude").typical(0.5, 6).falling());

  define(
      list,
      {.name = "stepper.voltage_limited_torque",
       .handbook_id = "STEP-TORQUE-VOLTAGE-LIMITED",
       .symbol = "T_V",
       .unit = "N.m",
       .title = "Pull-out torque when only the voltage limits",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::voltage_limited_torque(x...); },
      quantity("voltage", "V", "V", "usable supply voltage").typical(10, 60).rising(),
      quantity("resistance", "R", "ohm", "phase circuit resistance").typical(0.3, 5),
      quantity("inductance", "L_ph", "H", "phase inductance").typical(1e-3, 1e-2),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100),
      quantity("torque_constant", "K_m", "N.m/A", "torque constant").typical(0.1, 1),
      quantity("angular_speed", "ω", "rad/s", "shaft speed"));

  define(
      list,
      {.name = "stepper.pull_out_torque",
       .handbook_id = "STEP-PULLOUT-TORQUE",
       .symbol = "T_p",
       .unit = "N.m",
       .title = "Largest torque at a speed before the motor loses step, over all load angles",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::pull_out_torque(x...); },
      quantity("voltage", "V", "V", "usable supply voltage").typical(10, 60).rising(),
      quantity("resistance", "R", "ohm", "phase circuit resistance").typical(0.3, 5),
      quantity("inductance", "L_ph", "H", "phase inductance").typical(1e-3, 1e-2),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100),
      quantity("torque_constant", "K_m", "N.m/A", "torque constant").typical(0.1, 1),
      quantity("current_amplitude", "I_p", "A", "current amplitude").typical(0.5, 6).rising(),
      quantity("angular_speed", "ω", "rad/s", "shaft speed").falling());

  define(
      list,
      {.name = "stepper.quadrature_torque",
       .handbook_id = "STEP-TORQUE-QAXIS",
       .symbol = "T_q",
       .unit = "N.m",
       .title = "Pull-out torque of a drive that keeps the current square to the flux",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::quadrature_torque(x...); },
      quantity("voltage", "V", "V", "usable supply voltage").typical(10, 60).rising(),
      quantity("resistance", "R", "ohm", "phase circuit resistance").typical(0.3, 5).falling(),
      quantity("inductance", "L_ph", "H", "phase inductance").typical(1e-3, 1e-2).falling(),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100),
      quantity("torque_constant", "K_m", "N.m/A", "torque constant").typical(0.1, 1),
      quantity("current_amplitude", "I_p", "A", "current amplitude").typical(0.5, 6).rising(),
      quantity("angular_speed", "ω", "rad/s", "shaft speed").falling());

  define(
      list,
      {.name = "stepper.loss_torque",
       .handbook_id = "STEP-LOSS-TORQUE",
       .symbol = "T_loss",
       .unit = "N.m",
       .title = "Torque lost to iron losses, hysteresis and friction, as fractions of the holding torque",
       .source = "millwright_derivations, fit to published pull-out curves",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state; empirical, fitted to "
                   "two motors"},
      [](const auto&... x) { return stepper::loss_torque(x...); },
      quantity("holding_torque", "T_h", "N.m", "holding torque").typical(0.1, 5).rising(),
      quantity("angular_speed", "ω", "rad/s", "shaft speed").rising(),
      quantity("constant_loss", "c_0", "1", "constant loss fraction (default 0.03)")
          .between(0, 1)
          .typical(0, 0.1)
          .rising(),
      quantity("speed_loss", "c_1", "s/rad", "speed-proportional loss fraction (default 0.0005)")
          .typical(0, 1e-3)
          .rising());

  define(
      list,
      {.name = "stepper.available_torque",
       .handbook_id = "STEP-AVAILABLE-TORQUE",
       .symbol = "T_av",
       .unit = "N.m",
       .title = "Pull-out torque at the usable share of the supply voltage",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::available_torque(x...); },
      quantity("supply_voltage", "V", "V", "supply voltage").typical(10, 60).rising(),
      quantity("voltage_fraction", "k_V", "1", "usable fraction of it (default 0.9)")
          .between(0, 1)
          .typical(0.8, 1)
          .rising(),
      quantity("resistance", "R", "ohm", "phase circuit resistance").typical(0.3, 5),
      quantity("inductance", "L_ph", "H", "phase inductance").typical(1e-3, 1e-2),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100),
      quantity("holding_torque", "T_h", "N.m", "holding torque").typical(0.1, 5),
      quantity("rated_current", "I_r", "A", "rated current").typical(0.5, 6),
      quantity("current_amplitude", "I_p", "A", "current amplitude").typical(0.5, 6),
      quantity("angular_speed", "ω", "rad/s", "shaft speed").falling(),
      quantity("constant_loss", "c_0", "1", "loss fraction").between(0, 1).typical(0, 0.1).falling(),
      quantity("speed_loss", "c_1", "s/rad", "loss fraction").typical(0, 1e-3).falling());

  define(
      list,
      {.name = "stepper.no_load_speed",
       .handbook_id = "STEP-NOLOAD-SPEED",
       .symbol = "ω_0",
       .unit = "rad/s",
       .title = "Speed at which the ideal motor has no torque left",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::no_load_speed(x...); },
      quantity("voltage", "V", "V", "usable supply voltage").typical(1, 5).rising(),
      quantity("resistance", "R", "ohm", "phase circuit resistance").typical(2, 6),
      quantity("inductance", "L_ph", "H", "phase inductance").typical(1e-3, 3e-3),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100),
      quantity("torque_constant", "K_m", "N.m/A", "torque constant").typical(0.5, 1))
      .valid_when("voltage·rotor_teeth·inductance < resistance·torque_constant",
                  [](double voltage, double resistance, double inductance, double rotor_teeth, double torque_constant) {
                    return voltage * rotor_teeth * inductance < resistance * torque_constant;
                  });

  define(
      list,
      {.name = "stepper.angular_speed",
       .symbol = "ω",
       .unit = "rad/s",
       .title = "Shaft speed at a pulse rate",
       .source = "torch_table, eq. 4"},
      [](const auto&... x) { return stepper::angular_speed(x...); },
      quantity("pulse_rate", "f", "Hz", "pulses per second").rising(),
      count("pulses_per_revolution", "n", "pulses per revolution, microsteps included").typical(100, 6400).falling());
}

}  // namespace millwright::mechanics
