#pragma once

#include "anatomy/case.h"

namespace bodkin::anatomy {

// The device that a new case is made for until a real one takes its place: `generic`, strong enough that a simulated
// hand feels the needle through the ligamentum flavum. An 18G Tuohy needle needs 7.6 N there, and a hand that is
// rendered less does not feel the ligament give way. It is stiffer than that for thin needles: at 1 N/mm the device's
// own give would be 5 mm there, and the tip would be at the dura when the ligament is behind it. With the tables of
// forces all needles feel alike and 6 N are enough. The steps are our choice; docs/running.md says which experts find
// the epidural space with them.
DeviceLimits generic_device(const Needle& needle, Mechanics mechanics);

}  // namespace bodkin::anatomy
