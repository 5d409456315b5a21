#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/teacher/http_server.h"
#include "report/teacher/station_page.h"

namespace bodkin::report {

// What a teacher's browser asks for, and what it gets. The site only shows; nothing in the store can be changed by
// it.
//
//   /                        every trainee at every procedure, and plans
//   /trainee/LABEL           learning curves and attempts
//   /attempt/DIGEST          verdict, findings, measures
//   /attempt/DIGEST/report   the whole report, where the session is on this computer
//   /results.csv             everything, for statistics
//   /stations                stations that run elsewhere, live
class TeacherSite {
 public:
  // `store`: as ResultStore takes it; it is opened anew for each page. `token`: without it nothing is shown; empty:
  // everybody who reaches the site may look, and only names of this computer are answered to (a page from elsewhere
  // could else read the site through a name of its own).
  // `stations`: what those are now; empty: there are none.
  TeacherSite(std::string store, std::string token, std::function<std::vector<StationCard>()> stations = {});

  HttpReply answer(const HttpRequest& request) const;

 private:
  HttpReply page(const std::string& path) const;
  bool may_look(const HttpRequest& request, const std::string& query) const;

  std::string store_, token_;
  std::function<std::vector<StationCard>()> stations_;
};

}  // namespace bodkin::report
