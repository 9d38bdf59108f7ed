// SPDX-License-Identifier: Apache-2.0
#include "machine/modelled_torques.h"

#include "mechanics/stepper.h"

namespace millwright::machine {

using scalar::Interval;
namespace st = mechanics::stepper;

ModelledTorques::ModelledTorques(const std::vector<double>& speeds) : speeds_(speeds.begin(), speeds.end()) {
  for (const Interval& speed : speeds_)
    losses_.push_back(st::loss_torque(Interval(1.0), speed, Interval(constant_loss), Interval(speed_loss)));
}

void ModelledTorques::find(const MotorFigures<Interval>& figures,
                           const Interval& current,
                           std::vector<Interval>& torques) const {
  const st::PullOutTorques pull_out(voltage_fraction * figures.voltage,
                                    figures.resistance,
                                    figures.inductance,
                                    figures.rotor_teeth,
                                    st::torque_constant(figures.holding_torque, figures.rated_current),
                                    current);
  torques.clear();
  for (std::size_t i = 0; i < speeds_.size(); ++i)
    torques.push_back(larger(pull_out.at(speeds_[i]) - figures.holding_torque * losses_[i], Interval(0.0)));
}

}  // namespace millwright::machine
