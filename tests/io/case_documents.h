#pragma once

#include <string>

#include "io/case_xml.h"
#include "io/tissue_library_file.h"
#include "io/xml_document.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;

inline CaseDescription parse(const std::string& document) {
  return parse_case_xml(document, "case.xml", XmlSchema("case.xsd"),
                        [](const std::string&) { return default_tissue_library(); });
}

// The smallest case, one element a line.
inline const std::string smallest =
    "<case version='1' name='small'>\n"
    "  <volumes>\n"
    "    <ct file='ct.nrrd'/>\n"
    "    <tissues file='tissues.nrrd'/>\n"
    "  </volumes>\n"
    "  <needle gauge='22'/>\n"
    "</case>\n";

// Every element there is; the line of each is what the tests below expect.
inline const std::string largest =
    "<case version='1' name='large' created_by='a person'>\n"                                                 // 1
    "  <volumes>\n"                                                                                           // 2
    "    <ct file='ct.nrrd' digest='0123456789abcdef0123456789abcdef'/>\n"                                    // 3
    "    <structures file='labels/s.nrrd'>\n"                                                                 // 4
    "      <structure label='28' name='vertebrae_L4' tissue='bone'/>\n"                                       // 5
    "      <structure label='2' name='kidney_right' tissue='organ' critical='true'/>\n"                       // 6
    "    </structures>\n"                                                                                     // 7
    "    <tissues file='tissues.nrrd'/>\n"                                                                    // 8
    "  </volumes>\n"                                                                                          // 9
    "  <needle gauge='22' outer_diameter_mm='0.7' inner_diameter_mm='0.4' length_mm='90' tip='whitacre'/>\n"  // 10
    "  <device profile='touch' peak_force_N='3.3' continuous_force_N='0.9' peak_torque_N_mm='0' "
    "stiffness_N_per_mm='1.2'/>\n"                                                 // 11
    "  <haptics rate_Hz='2000'>\n"                                                 // 12
    "    <resistance><layered law='sum' strict='1' layer_mm='1'/></resistance>\n"  // 13
    "    <constraint><line_spring stiffness_N_per_mm='0.4' damping_N_s_per_mm='0.001' "
    "limit_N='2'/></constraint>\n"                                                         // 14
    "    <compensation weight_N='0.45' up_x='0' up_y='0' up_z='2'/>\n"                     // 15
    "  </haptics>\n"                                                                       // 16
    "  <landmarks>\n"                                                                      // 17
    "    <landmark name='L3_L4' x_mm='1' y_mm='2' z_mm='3'/>\n"                            // 18
    "    <landmark name='L4_L5' x_mm='1' y_mm='2' z_mm='-30'/>\n"                          // 19
    "  </landmarks>\n"                                                                     // 20
    "  <procedure name='lumbar_puncture' target_tissue='dura' target_tolerance_mm='2'>\n"  // 21
    "    <entry x_mm='4.5' y_mm='-45' z_mm='293'/>\n"                                      // 22
    "    <target x_mm='3' y_mm='-117.5' z_mm='294'/>\n"                                    // 23
    "  </procedure>\n"                                                                     // 24
    "  <notes><note>one</note></notes>\n"                                                  // 25
    "</case>\n";

}  // namespace bodkin
