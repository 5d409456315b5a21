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

// The content of a report, without its layout: a title and blocks one below the other. html_of() and pdf_of() give it
// a form. All texts are plain UTF-8; escaping is left to the file format.

struct Heading {
  std::string text;
};

struct Paragraph {
  std::string text;
  bool is_empty_section = false;  // states that there is no content
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

// The few most important numbers.
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
    bool is_number = false;  // right-aligned
  };
  struct Cell {
    std::string text;
    std::optional<training::Grade> grade = {};
    std::optional<std::uint32_t> swatch = {};  // 0xRRGGBB, of a tissue
    bool is_muted = false;                     // in the grey of remarks
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
