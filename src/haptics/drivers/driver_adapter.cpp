#include "haptics/drivers/driver_adapter.h"

#include <algorithm>
#include <cstring>

#include "haptics/driver_library.h"

namespace bodkin::haptics {

namespace {

int failed(int result, const char* what, char* message) noexcept {
  if (message != nullptr) {
    const std::size_t size = std::min(std::strlen(what), std::size_t{BODKIN_MESSAGE - 1});
    std::memcpy(message, what, size);
    message[size] = '\0';
  }
  return result;
}

}  // namespace

void copy_text(const std::string& text, char* to, std::size_t size) noexcept {
  const std::size_t fits = std::min(text.size(), size - 1);
  std::memcpy(to, text.data(), fits);
  to[fits] = '\0';
}

int guarded(char* message, const std::function<void()>& call) noexcept {
  try {
    call();
    return BODKIN_OK;
  } catch (const DriverFailure& failure) {
    return failed(failure.result(), failure.what(), message);
  } catch (const LibraryError& error) {
    return failed(error.absent() ? BODKIN_NOT_INSTALLED : BODKIN_WRONG_VERSION, error.what(), message);
  } catch (const std::exception& error) {
    return failed(BODKIN_VENDOR_ERROR, error.what(), message);
  } catch (...) {
    return failed(BODKIN_VENDOR_ERROR, "something that is not an exception was thrown", message);
  }
}

}  // namespace bodkin::haptics
