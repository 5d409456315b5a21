// Prints where the needle's tip is, RAS mm: needle [HOST [PORT [HOW_MANY]]]. Needs the OpenIGTLink library (Debian:
// libopenigtlink-dev): c++ -I /usr/include/openigtlink needle.cpp -lOpenIGTLink -lpthread
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "igtlClientSocket.h"
#include "igtlMessageHeader.h"
#include "igtlTransformMessage.h"

int main(int argc, char** argv) {
  igtl::ClientSocket::Pointer server = igtl::ClientSocket::New();
  if (server->ConnectToServer(argc > 1 ? argv[1] : "localhost", argc > 2 ? std::atoi(argv[2]) : 18944) != 0) {
    std::fprintf(stderr, "nobody answers there\n");
    return 1;
  }
  for (int wanted = argc > 3 ? std::atoi(argv[3]) : -1; wanted != 0;) {
    igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
    header->InitPack();
    if (server->Receive(header->GetPackPointer(), header->GetPackSize()) != header->GetPackSize()) return 1;
    header->Unpack();
    if (std::strcmp(header->GetDeviceType(), "TRANSFORM") != 0 ||
        std::strcmp(header->GetDeviceName(), "NeedleTipToReference") != 0) {
      server->Skip(static_cast<int>(header->GetBodySizeToRead()));
      continue;
    }
    igtl::TransformMessage::Pointer message = igtl::TransformMessage::New();
    message->SetMessageHeader(header);
    message->AllocatePack();
    if (server->Receive(message->GetPackBodyPointer(), message->GetPackBodySize()) != message->GetPackBodySize())
      return 1;
    message->Unpack(1);
    igtl::Matrix4x4 matrix;
    message->GetMatrix(matrix);
    std::printf("%.2f %.2f %.2f\n", matrix[0][3], matrix[1][3], matrix[2][3]);
    std::fflush(stdout);
    --wanted;
  }
  server->CloseSocket();
  return 0;
}
