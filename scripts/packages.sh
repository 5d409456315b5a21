# Debian 12 packages required by Bodkin, sourced by scripts/setup.sh. One list for building and running, one for the
# window, one for testing.

packages_to_run=(
  clang lld cmake ninja-build ccache pkg-config
  libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev
  libxml2-dev libsleef-dev libcsv-dev libpng-dev zlib1g-dev libdeflate-dev libxxhash-dev libsqlitecpp-dev libsqlite3-dev libpqxx-dev
  libceres-dev libboost-dev libsimdjson-dev libopenblas-dev libmetis-dev libcgal-dev
  libinsighttoolkit5-dev libgdcm-dev libgdcm-tools
  libcairo2-dev fonts-dejavu-core
  libopencv-core-dev libopencv-imgproc-dev libopencv-calib3d-dev libopencv-contrib-dev
  libjpeg62-turbo-dev ffmpeg
)

# The window, left out by `./run --without-app`.
packages_of_app=(
  qtbase5-dev libvtk9-dev libvtk9-qt-dev libgl-dev libx11-dev fonts-roboto-unhinted
)

packages_to_test=(
  g++ git libgtest-dev libgmock-dev libbenchmark-dev doxygen
  clang-format clang-tidy libclang-rt-14-dev llvm libxml2-utils poppler-utils
  xvfb xauth xdotool imagemagick
  libsuitesparse-dev calculix-ccx libopenigtlink-dev openmpi-bin
  postgresql curl chromium-headless-shell
  pybind11-dev python3-dev python3-numpy
  g++-aarch64-linux-gnu qemu-user
)
