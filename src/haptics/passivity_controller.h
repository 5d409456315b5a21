#pragma once

namespace bodkin::haptics {

// Time-domain passivity (Hannaford and Ryu 2002): the tissue never returns more energy along the needle than the hand
// has put in.
//
//   E += R v dt;   if E < 0:  alpha = -E / (dt v^2),  R_out = R + alpha v,  E += alpha v^2 dt
//
//   R resistance, N, positive pushes out; v velocity, mm/s, positive inwards; E energy taken from the hand, N mm;
// alpha damping, N s/mm, at most `damping_limit`. No action at |v| below `threshold` (E is kept). E restarts from 0
// after 0.5 s out of contact, so that old credit hides nothing. Compensation of the device's weight is active by
// design and must be added afterwards.
class PassivityController {
 public:
  // `damping_limit`: N s/mm, what the device can render. `force_limit`: N, bounds R_out. `threshold`: mm/s.
  PassivityController(double dt, double damping_limit, double force_limit, double threshold)
      : dt_(dt), damping_limit_(damping_limit), force_limit_(force_limit), threshold_(threshold) {}

  // Returns R_out.
  double step(double resistance, double velocity, bool in_contact) noexcept;
  void reset() noexcept { energy_ = damping_ = time_outside_ = 0.0; }

  double energy() const noexcept { return energy_; }    // N mm
  double damping() const noexcept { return damping_; }  // alpha of the last step; 0 = no action

 private:
  double dt_, damping_limit_, force_limit_, threshold_;
  double energy_ = 0.0;
  double damping_ = 0.0;
  double time_outside_ = 0.0;  // s
};

}  // namespace bodkin::haptics
