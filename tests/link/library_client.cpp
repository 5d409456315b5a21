#include "tests/link/library_client.h"

#include <cstring>

#include "igtlClientSocket.h"
#include "igtlImageMessage.h"
#include "igtlMessageHeader.h"
#include "igtlStringMessage.h"
#include "igtlTrackingDataMessage.h"
#include <gtest/gtest.h>

namespace bodkin::link {

struct LibraryClient::Socket {
  igtl::ClientSocket::Pointer igtl = igtl::ClientSocket::New();
};

LibraryClient::LibraryClient(std::uint16_t port) : socket_(std::make_unique<Socket>()) {
  EXPECT_EQ(socket_->igtl->ConnectToServer("127.0.0.1", port), 0);
  socket_->igtl->SetReceiveTimeout(50);
}

LibraryClient::~LibraryClient() {
  socket_->igtl->CloseSocket();
}

void LibraryClient::send_bytes(std::span<const std::uint8_t> bytes) {
  EXPECT_NE(socket_->igtl->Send(bytes.data(), bytes.size()), 0);
}

void LibraryClient::send_string(const std::string& device, const std::string& text) {
  igtl::StringMessage::Pointer message = igtl::StringMessage::New();
  message->SetDeviceName(device.c_str());
  message->SetString(text.c_str());
  message->Pack();
  EXPECT_NE(socket_->igtl->Send(message->GetPackPointer(), message->GetPackSize()), 0);
}

void LibraryClient::start_tracking(int interval) {
  igtl::StartTrackingDataMessage::Pointer message = igtl::StartTrackingDataMessage::New();
  message->SetDeviceName("Client");
  message->SetResolution(interval);
  message->SetCoordinateName("Reference");
  message->Pack();
  EXPECT_NE(socket_->igtl->Send(message->GetPackPointer(), message->GetPackSize()), 0);
}

void LibraryClient::ask_for_image(const std::string& device) {
  igtl::GetImageMessage::Pointer message = igtl::GetImageMessage::New();
  message->SetDeviceName(device.c_str());
  message->Pack();
  EXPECT_NE(socket_->igtl->Send(message->GetPackPointer(), message->GetPackSize()), 0);
}

bool LibraryClient::read(Message& message) {
  igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
  header->InitPack();
  const auto size = socket_->igtl->Receive(header->GetPackPointer(), header->GetPackSize());
  if (size != header->GetPackSize()) return false;
  header->Unpack();
  message.type = header->GetDeviceType();
  message.device = header->GetDeviceName();
  message.content.assign(static_cast<std::size_t>(header->GetBodySizeToRead()), 0);
  if (message.content.empty()) return true;
  return socket_->igtl->Receive(message.content.data(), static_cast<int>(message.content.size())) ==
         static_cast<int>(message.content.size());
}

bool LibraryClient::wait_for(const std::string& type, std::chrono::milliseconds most,
                             const std::function<bool(const Message&)>& is_it) {
  for (const auto end = std::chrono::steady_clock::now() + most; std::chrono::steady_clock::now() < end;) {
    Message message;
    if (read(message) && (type.empty() || message.type == type) && is_it(message)) return true;
  }
  return false;
}

std::size_t LibraryClient::count(const std::string& type, std::chrono::milliseconds longer) {
  std::size_t found = 0;
  for (const auto end = std::chrono::steady_clock::now() + longer; std::chrono::steady_clock::now() < end;) {
    Message message;
    if (read(message) && message.type == type) ++found;
  }
  return found;
}

}  // namespace bodkin::link
