#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "imaging/canvas.h"
#include "training/procedure.h"

namespace bodkin::report {

// What a report says, without how it looks: a title and blocks one below the other. html_of() and pdf_of() give it
// its form. All texts are plain UTF-8; what a file format needs escaped is escaped there.

struct Heading {
  std::string text;
};

struct Paragraph {
  std::string text;
  bool is_empty_section = false;  // says that there is nothing to say
};

struct Verdict {
  struct Finding {
    std::string sentence;
    std::optional<training::Grade> grade;
  };
  training::Grade grade = training::Grade::pass;
  std::string headline;
  std::vector<Finding> findings;
};

// The few numbers that say most.
struct Tiles {
  struct Tile {
    std::string value, title;
    std::optional<training::Grade> grade;
  };
  std::vector<Tile> tiles;
};

struct Table {
  struct Column {
    std::string title;
    bool is_number = false;  // set to the right
  };
  struct Cell {
    std::string text;
    std::optional<training::Grade> grade = {};
    std::optional<std::uint32_t> swatch = {};  // 0xRRGGBB, of a tissue
    bool is_soft = false;                      // in the grey of remarks
  };
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  // a cell for each column
  bool stays_whole = false;             // is not divided between pages
};

// Names and values. A long value can be folded away behind its summary.
struct Facts {
  struct Fact {
    std::string name, value;
    std::string folded = {};  // preformatted; empty: nothing is folded away
  };
  std::vector<Fact> facts;
};

struct Picture {
  imaging::Canvas picture;
  std::string description;
  bool is_dark = false;
};

using Block = std::variant<Heading, Paragraph, Verdict, Tiles, Table, Facts, Picture>;

struct Document {
  std::string title, subtitle;
  std::vector<Block> blocks;
};

}  // namespace bodkin::report
