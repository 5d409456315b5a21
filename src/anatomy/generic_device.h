#pragma once

#include "anatomy/case.h"

namespace bodkin::anatomy {

// The default device of a new case: `generic`, strong enough that a simulated hand feels the needle through the
// ligamentum flavum. An 18G Tuohy needle needs 7.6 N there; a hand that feels a smaller force does not notice the
// loss of resistance. The device is stiffer for thick needles than for thin ones: at 1 N/mm its own compliance would
// add 5 mm, and the tip would be at the dura when it has passed the ligament. With the force tables all needles feel
// alike and 6 N are enough. The steps are our choice; docs/running.md says which experts find the epidural space with
// them.
DeviceLimits generic_device(const Needle& needle, Mechanics mechanics);

}  // namespace bodkin::anatomy
