// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/stepper_sizing.h"

namespace millwright::mechanics {

void define_stepper_sizing(FormulaList& list) {
  define(
      list,
      {.name = "stepper.load_angle",
       .handbook_id = "STEP-LOAD-ANGLE",
       .symbol = "Δθ",
       .unit = "rad",
       .title = "Angle by which the rotor lags under a static load",
       .source = "acarnley2002, chapter 5",
       .validity = "load torque at most the static torque"},
      [](const auto&... x) { return stepper::load_angle(x...); },
      quantity("load_torque", "T_L", "N.m", "static load torque").rising(),
      quantity("static_torque", "T_s", "N.m", "static torque amplitude").falling(),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100).falling())
      .valid_when("load_torque <= static_torque",
                  [](double load_torque, double static_torque, double) { return load_torque <= static_torque; });

  define(
      list,
      {.name = "stepper.static_stiffness",
       .handbook_id = "STEP-STATIC-STIFFNESS",
       .symbol = "k_θ",
       .unit = "N.m/rad",
       .title = "Slope of the torque curve at zero load",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::static_stiffness(x...); },
      quantity("static_torque", "T_s", "N.m", "static torque amplitude").rising(),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100).rising());

  define(
      list,
      {.name = "stepper.microstep_torque",
       .handbook_id = "STEP-MICROSTEP-TORQUE",
       .symbol = "T_inc",
       .unit = "N.m",
       .title = "Torque that one microstep of advance builds up",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::microstep_torque(x...); },
      quantity("static_torque", "T_s", "N.m", "static torque amplitude").rising(),
      count("microsteps", "μ_s", "microsteps per full step").typical(1, 64).falling());

  define(
      list,
      {.name = "stepper.inertia_ratio",
       .handbook_id = "STEP-INERTIA-RATIO",
       .symbol = "r_J",
       .unit = "1",
       .title = "Load inertia at the motor over rotor inertia",
       .source = "parker_sizing; sander, eq. 21",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::inertia_ratio(x...); },
      quantity("load_inertia", "J_L", "kg.m^2", "load inertia referred to the motor").rising(),
      quantity("rotor_inertia", "J_M", "kg.m^2", "rotor inertia").falling());

  define(
      list,
      {.name = "stepper.acceleration_torque",
       .handbook_id = "STEP-ACCEL-TORQUE",
       .symbol = "T_a",
       .unit = "N.m",
       .title = "Torque that accelerates rotor and load",
       .source = "sander, eq. 23",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::acceleration_torque(x...); },
      quantity("rotor_inertia", "J_M", "kg.m^2", "rotor inertia").rising(),
      quantity("load_inertia", "J_L", "kg.m^2", "load inertia referred to the motor").rising(),
      quantity("efficiency", "η", "1", "drive efficiency").between(0, 1).typical(0.3, 1).falling(),
      quantity("angular_acceleration", "α", "rad/s^2", "motor acceleration").rising());

  define(
      list,
      {.name = "stepper.rms_torque",
       .handbook_id = "STEP-RMS-TORQUE",
       .symbol = "T_rms",
       .unit = "N.m",
       .title = "Root mean square torque over a cycle",
       .source = "sander, eq. 25",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::rms_torque(x...); },
      list_of("torques", "T", "N.m", "torques per phase").any_sign().typical(-2, 2),
      list_of("durations", "t", "s", "durations incl. dwell").as_long_as(0));

  define(
      list,
      {.name = "stepper.start_rate",
       .handbook_id = "STEP-START-RATE-INERTIA",
       .symbol = "f",
       .unit = "Hz",
       .title = "Highest pulse rate at which the loaded motor starts and stops without a ramp, from the rate of the "
                "bare motor",
       .source = "oriental_motor_sizing",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::start_rate(x...); },
      quantity("no_load_start_rate", "f_s", "Hz", "no-load start/stop pulse rate of the bare motor")
          .typical(200, 4000)
          .rising(),
      quantity("load_inertia", "J_L", "kg.m^2", "load inertia").falling(),
      quantity("rotor_inertia", "J_M", "kg.m^2", "rotor inertia").rising());

  define(
      list,
      {.name = "stepper.start_speed",
       .handbook_id = "STEP-START-SPEED-ENERGY",
       .symbol = "ω_start",
       .unit = "rad/s",
       .title = "Highest speed jump from standstill for which the rotor stays in the potential well of the field",
       .source = "millwright_derivations, definition",
       .validity = "undamped; load torque at most the static torque"},
      [](const auto&... x) { return stepper::start_speed(x...); },
      quantity("static_torque", "T_s", "N.m", "static torque amplitude").rising(),
      quantity("load_torque", "T_L", "N.m", "friction load torque").falling(),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100).falling(),
      quantity("inertia", "J", "kg.m^2", "total inertia at the shaft").falling())
      .valid_when("load_torque <= static_torque", [](double static_torque, double load_torque, double, double) {
        return load_torque <= static_torque;
      });

  define(
      list,
      {.name = "stepper.resonant_frequency",
       .handbook_id = "STEP-RESONANCE",
       .symbol = "f_n",
       .unit = "Hz",
       .title = "Natural frequency of rotor and rigidly coupled inertia on the magnetic spring",
       .source = "acarnley2002, chapter 6",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::resonant_frequency(x...); },
      quantity("static_torque", "T_s", "N.m", "static torque amplitude").rising(),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100).rising(),
      quantity("inertia", "J", "kg.m^2", "total inertia at the shaft").falling());

  define(
      list,
      {.name = "stepper.copper_loss",
       .handbook_id = "STEP-COPPER-LOSS",
       .symbol = "P_Cu",
       .unit = "W",
       .title = "Copper loss of both phases with sinusoidal currents",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::copper_loss(x...); },
      quantity("current_amplitude", "I_p", "A", "current amplitude (sine microstepping)").typical(0.5, 6).rising(),
      quantity("resistance", "R", "ohm", "phase winding resistance").typical(0.3, 5).rising());

  define(
      list,
      {.name = "stepper.copper_loss_two_phases_on",
       .handbook_id = "STEP-COPPER-LOSS-2PHASE-DC",
       .symbol = "P_Cu",
       .unit = "W",
       .title = "Copper loss with both phases at a steady current",
       .source = "acarnley2002, chapter 5",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::copper_loss_two_phases_on(x...); },
      quantity("current", "I_r", "A", "DC current in each of the two phases").typical(0.5, 6).rising(),
      quantity("resistance", "R", "ohm", "phase winding resistance").typical(0.3, 5).rising());

  define(
      list,
      {.name = "stepper.hot_resistance",
       .handbook_id = "STEP-RESISTANCE-HOT",
       .symbol = "R",
       .unit = "ohm",
       .title = "Winding resistance at a temperature",
       .source = "millwright_derivations, definition",
       .validity = "copper windings, 0 to 200 °C"},
      [](const auto&... x) { return stepper::hot_resistance(x...); },
      quantity("resistance_at_20_celsius", "R_20", "ohm", "resistance at 20 °C").rising(),
      quantity("winding_temperature", "T_w", "degC", "winding temperature")
          .between(273.15, 473.15)
          .typical(293.15, 400)
          .rising());

  define(
      list,
      {.name = "stepper.winding_temperature",
       .handbook_id = "STEP-WINDING-TEMP",
       .symbol = "T_w",
       .unit = "degC",
       .title = "Winding temperature at a mean loss",
       .source = "millwright_derivations, definition",
       .validity = "steady state"},
      [](const auto&... x) { return stepper::winding_temperature(x...); },
      quantity("ambient_temperature", "T_amb", "degC", "ambient temperature")
          .between(233.15, 373.15)
          .typical(280, 315)
          .rising(),
      quantity("power_loss", "P_loss", "W", "mean loss in the motor").rising(),
      quantity("thermal_resistance", "R_th", "K/W", "thermal resistance winding to ambient").rising());

  define(
      list,
      {.name = "stepper.thermal_resistance",
       .handbook_id = "STEP-RTH-ESTIMATE",
       .symbol = "R_th",
       .unit = "K/W",
       .title =
           "Thermal resistance winding to ambient, from the temperature rise the catalogue allows at rated current",
       .source = "millwright_derivations, definition",
       .validity = "as mounted by the maker when rating"},
      [](const auto&... x) { return stepper::thermal_resistance(x...); },
      quantity("rated_temperature_rise",
               "ΔT_r",
               "K",
               "temperature rise at rated current, both phases on (catalogue, typ. 80 K)")
          .rising(),
      quantity("rated_current", "I_r", "A", "rated current").typical(0.5, 6).falling(),
      quantity("resistance_at_20_celsius", "R_20", "ohm", "resistance at 20 °C").falling());

  define(
      list,
      {.name = "stepper.drive_input_power",
       .handbook_id = "STEP-DRIVE-INPUT-POWER",
       .symbol = "P_in",
       .unit = "W",
       .title = "Power a drive takes from its supply",
       .source = "millwright_derivations, definition",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::drive_input_power(x...); },
      quantity("copper_loss", "P_cu", "W", "copper loss").rising(),
      quantity("torque", "T", "N.m", "shaft torque").rising(),
      quantity("angular_speed", "ω", "rad/s", "speed").rising(),
      quantity("iron_loss", "P_fe", "W", "iron and friction loss").rising(),
      quantity("driver_efficiency", "η_d", "1", "driver efficiency").between(0, 1).typical(0.8, 1).falling());

  define(
      list,
      {.name = "stepper.supply_power",
       .handbook_id = "STEP-PSU-POWER",
       .symbol = "P_PSU",
       .unit = "W",
       .title = "Power rating needed of a supply",
       .source = "millwright_derivations, definition",
       .validity = "two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state"},
      [](const auto&... x) { return stepper::supply_power(x...); },
      list_of("input_powers", "P_in", "W", "drive input powers that can occur together"),
      quantity("reserve_factor", "k_res", "1", "reserve factor (default 1.25)").at_least(1).typical(1, 2).rising());

  define(
      list,
      {.name = "stepper.supply_current",
       .handbook_id = "STEP-PSU-CURRENT-RULE",
       .symbol = "I_PSU",
       .unit = "A",
       .title = "Supply current by rule of thumb, two thirds of the rated phase currents, because a chopper draws less "
                "than the winding current",
       .source = "gecko_step_motor_basics",
       .validity = "rule of thumb for chopper drives"},
      [](const auto&... x) { return stepper::supply_current(x...); },
      list_of("rated_currents", "I_r", "A", "rated phase currents of the motors on the supply"));

  define(
      list,
      {.name = "stepper.recommended_voltage",
       .handbook_id = "STEP-VOLTAGE-RULE",
       .symbol = "V_max",
       .unit = "V",
       .title = "Highest sensible supply voltage by the rule 32 √(L in mH)",
       .source = "gecko_step_motor_basics",
       .validity = "rule of thumb"},
      [](const auto&... x) { return stepper::recommended_voltage(x...); },
      quantity("inductance", "L_ph", "H", "phase inductance").typical(1e-3, 1e-2).rising());

  define(
      list,
      {.name = "stepper.braking_bus_voltage",
       .handbook_id = "STEP-BUS-PUMP-UP",
       .symbol = "V'",
       .unit = "V",
       .title = "Bus voltage after braking energy has charged the capacitors",
       .source = "millwright_derivations, definition",
       .validity = "no brake resistor, all energy returned"},
      [](const auto&... x) { return stepper::braking_bus_voltage(x...); },
      quantity("voltage", "V", "V", "bus voltage before braking").typical(10, 60).rising(),
      quantity("kinetic_energy", "E_kin", "J", "kinetic + potential energy returned").rising(),
      quantity("capacitance", "C_bus", "F", "bus capacitance").falling());
}

}  // namespace millwright::mechanics
