#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/teacher/http_server.h"
#include "report/teacher/station_page.h"

namespace bodkin::report {

// The requests of a teacher's browser and their responses. The site is read-only; it cannot change the store.
//
//   /                        every trainee at every procedure, and plans
//   /trainee/LABEL           learning curves and attempts
//   /attempt/DIGEST          verdict, findings, measures
//   /attempt/DIGEST/report   the whole report, where the session is on this computer
//   /results.csv             everything, for statistics
//   /stations                stations that run elsewhere, live
class TeacherSite {
 public:
  // `store`: as for ResultStore; it is opened anew for each page. `token`: required for access; empty: everybody who
  // reaches the site may look, and it responds only to names of this computer (otherwise a page from elsewhere could
  // read the site through a name of its own). `stations`: their present state; empty: none.
  TeacherSite(std::string store, std::string token, std::function<std::vector<StationCard>()> stations = {});

  HttpReply answer(const HttpRequest& request) const;

 private:
  HttpReply page(const std::string& path) const;
  bool may_look(const HttpRequest& request, const std::string& query) const;

  std::string store_, token_;
  std::function<std::vector<StationCard>()> stations_;
};

}  // namespace bodkin::report
