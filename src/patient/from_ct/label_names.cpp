#include "patient/from_ct/label_names.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "io/label_scheme.h"

namespace bodkin::patient {
namespace {

using Words = std::vector<std::string>;

// "Kidney, left" -> {"kidney", "left"}: letters and digits, in lower case.
Words words_of(const std::string& name) {
  Words words;
  std::string word;
  for (const char letter : name + " ") {
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, ""));
    }
  }
  return words;
}

// TotalSegmentator's word for the same.
std::string common_word(const std::string& word) {
  static const std::map<std::string, std::string, std::less<>> same = {{"vertebra", "vertebrae"},
                                                                       {"vertebral", "vertebrae"},
                                                                       {"kidneys", "kidney"},
                                                                       {"oesophagus", "esophagus"},
                                                                       {"lt", "left"},
                                                                       {"l", "left"},
                                                                       {"rt", "right"},
                                                                       {"r", "right"},
                                                                       {"clavicle", "clavicula"},
                                                                       {"os", "bone"},
                                                                       {"bones", "bone"},
                                                                       {"bony", "bone"}};
  const auto found = same.find(word);
  return found == same.end() ? word : found->second;
}

Words key_of(const std::string& name) {
  Words key = words_of(name);
  for (std::string& word : key) word = common_word(word);
  std::sort(key.begin(), key.end());
  return key;
}

bool has_any(const Words& words, std::initializer_list<const char*> wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(wanted.begin(), wanted.end(), [&](const char* each) { return word == each; });
  });
}

// A vertebra and nothing else: "L3", "vertebra L3", "L3 body", "VB_L3".
std::optional<std::string> vertebra_of(const std::string& name) {
  std::optional<std::string> level;
  for (const std::string& word : words_of(name)) {
    const bool is_level =
        word.size() >= 2 && word.size() <= 3 && std::string("ctls").find(word[0]) != std::string::npos &&
        std::all_of(word.begin() + 1, word.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (is_level) level = fmt::format("vertebrae_{}{}", static_cast<char>(std::toupper(word[0])), word.substr(1));
    if (!is_level && !has_any({word}, {"vertebra", "vertebrae", "vertebral", "vb", "body"})) return std::nullopt;
  }
  return level;
}

// The tissue implied by a name that no scheme lists; empty if none.
std::optional<std::string> tissue_by_words(const Words& words) {
  const bool target_volume =
      std::any_of(words.begin(), words.end(), [](const std::string& word) { return word.starts_with("gtv"); });
  if (target_volume || has_any(words, {"tumor", "tumour", "lesion", "mass", "neoplasm", "metastasis", "nodule"}))
    return "mass";
  if (has_any(words, {"canal", "thecal"})) return "spinal_canal";
  if (has_any(words, {"bone", "skeleton", "spine", "pelvis", "rib", "ribs", "sacrum"})) return "bone";
  if (has_any(words, {"aorta", "artery", "vein", "vena"})) return "vessel";
  if (has_any(words, {"kidney", "bowel", "rectum", "heart", "liver", "spleen", "bladder"})) return "organ";
  return std::nullopt;
}

// A name on one line that case.xml allows, the words with underscores between.
std::string plain_name(const std::string& name, std::uint16_t label) {
  std::string text;
  for (const std::string& word : words_of(name)) text += (text.empty() ? "" : "_") + word;
  return text.empty() ? fmt::format("label_{}", label) : text;
}

}  // namespace

NamedStructures structures_named(const std::vector<io::LabelName>& names) {
  std::map<Words, anatomy::Structure> known;
  for (const anatomy::Structure& entry : io::read_label_scheme("totalsegmentator")) known[key_of(entry.name)] = entry;
  NamedStructures result;
  std::string by_hounsfield;
  bool cord = false;
  for (const io::LabelName& named : names) {
    anatomy::Structure structure{named.label, plain_name(named.name, named.label), "", false};
    auto match = known.find(key_of(named.name));
    if (match == known.end()) {
      if (const auto vertebra = vertebra_of(named.name)) match = known.find(key_of(*vertebra));
    }
    if (match != known.end()) {
      structure = match->second;
      structure.label = named.label;
      cord = cord || structure.name == "spinal_cord";
    } else if (const auto tissue = tissue_by_words(words_of(named.name))) {
      structure.tissue = *tissue;
      structure.critical = *tissue == "vessel" || *tissue == "organ";
    } else {
      by_hounsfield += fmt::format("{}'{}'", by_hounsfield.empty() ? "" : ", ", named.name);
    }
    result.table.push_back(structure);
  }
  if (!by_hounsfield.empty()) {
    result.notes.push_back(fmt::format(
        "The names {} of the labels name no known tissue, so HU decides there; a --scheme can say what they are.",
        by_hounsfield));
  }
  if (cord) {
    result.notes.push_back(
        "The label of the spinal cord was taken for the whole spinal canal, as TotalSegmentator draws it; if it is "
        "the "
        "cord alone, give a --scheme in which its tissue is spinal_cord.");
  }
  return result;
}

}  // namespace bodkin::patient
