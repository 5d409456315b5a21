#pragma once

#include <memory>

#include <zlib.h>

namespace bodkin::io {

struct CloseGzip {
  void operator()(gzFile_s* file) const { gzclose(file); }
};

// A gzip stream that closes itself. Null when it could not be opened.
using GzipStream = std::unique_ptr<gzFile_s, CloseGzip>;

}  // namespace bodkin::io
