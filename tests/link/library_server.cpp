#include "tests/link/library_server.h"

#include <chrono>

#include "igtlServerSocket.h"
#include "igtlTrackingDataMessage.h"
#include "igtlTransformMessage.h"
#include <gtest/gtest.h>

namespace bodkin::link {

struct LibraryServer::Socket {
  igtl::ServerSocket::Pointer igtl = igtl::ServerSocket::New();
};

LibraryServer::LibraryServer(const std::string& tool, Kind kind)
    : tool_(tool), kind_(kind), socket_(std::make_unique<Socket>()) {
  EXPECT_EQ(socket_->igtl->CreateServer(0), 0);
  port_ = static_cast<std::uint16_t>(socket_->igtl->GetServerPort());
  thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
}

LibraryServer::~LibraryServer() {
  thread_.request_stop();
  thread_.join();
  socket_->igtl->CloseSocket();
}

void LibraryServer::set_matrix(const std::array<float, 12>& rows) {
  const std::lock_guard lock(mutex_);
  rows_ = rows;
}

void LibraryServer::set_reference(const std::array<float, 12>& rows) {
  const std::lock_guard lock(mutex_);
  reference_ = rows;
}

void LibraryServer::serve(const std::stop_token& stop) {
  igtl::ClientSocket::Pointer client;
  while (!stop.stop_requested()) {
    if (client.IsNull()) {
      client = socket_->igtl->WaitForConnection(20);
      if (client.IsNull()) continue;
      ++clients_;
      hang_up_ = false;
    }
    igtl::Matrix4x4 matrix, other;
    igtl::IdentityMatrix(matrix);
    igtl::IdentityMatrix(other);
    {
      const std::lock_guard lock(mutex_);
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
          matrix[row][column] = rows_[4 * row + column];
          other[row][column] = reference_[4 * row + column];
        }
    }
    int sent = 1;
    if (hidden_) {
      // nothing
    } else if (kind_ == Kind::transform) {
      igtl::TransformMessage::Pointer message = igtl::TransformMessage::New();
      message->SetDeviceName(tool_.c_str());
      message->SetMatrix(matrix);
      message->Pack();
      sent = client->Send(message->GetPackPointer(), message->GetPackSize());
    } else {
      igtl::TrackingDataMessage::Pointer message = igtl::TrackingDataMessage::New();
      message->SetDeviceName("TDATA_2Elem");
      for (const bool is_tool : {false, true}) {
        igtl::TrackingDataElement::Pointer element = igtl::TrackingDataElement::New();
        element->SetName(is_tool ? tool_.c_str() : "ReferenceToTracker");
        element->SetType(igtl::TrackingDataElement::TYPE_6D);
        element->SetMatrix(is_tool ? matrix : other);
        message->AddTrackingDataElement(element);
      }
      message->Pack();
      sent = client->Send(message->GetPackPointer(), message->GetPackSize());
    }
    if (sent == 0 || hang_up_) {
      client->CloseSocket();
      client = nullptr;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if (client.IsNotNull()) client->CloseSocket();
}

}  // namespace bodkin::link
