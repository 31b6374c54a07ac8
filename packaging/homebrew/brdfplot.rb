# The command and the library for Homebrew. The project has no public archive yet; one of a tree is made and named by
#
#   git archive --prefix=brdfplot-0.1.0/ -o brdfplot-0.1.0.tar.gz HEAD
#   export HOMEBREW_BRDFPLOT_ARCHIVE="file://$PWD/brdfplot-0.1.0.tar.gz"
#   export HOMEBREW_BRDFPLOT_SHA256=$(shasum -a 256 brdfplot-0.1.0.tar.gz | cut -d ' ' -f 1)
#   brew install --build-from-source packaging/homebrew/brdfplot.rb
class Brdfplot < Formula
  desc "Microfacet BRDF models: evaluation, checks, figures and reports"
  homepage "https://brdfplot.example/"
  url ENV.fetch("HOMEBREW_BRDFPLOT_ARCHIVE")
  sha256 ENV.fetch("HOMEBREW_BRDFPLOT_SHA256")
  version "0.1.0"
  license "MIT"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "eigen" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "boost"
  depends_on "embree"
  depends_on "fftw"
  depends_on "libpng"
  depends_on "librsvg"
  depends_on "muparser"
  depends_on "tbb"

  uses_from_macos "python" => :build
  uses_from_macos "zlib"

  def install
    args = %w[-DBRDFPLOT_BUILD_TESTS=OFF -DBRDFPLOT_BUILD_BENCH=OFF -DBRDFPLOT_BUILD_PYTHON=OFF -DCMAKE_UNITY_BUILD=ON]
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", *args, *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    assert_match version.to_s, shell_output("#{bin}/brdfplot --version")
    (testpath/"ggx.json").write '{"distribution": {"type": "ggx", "alpha": 1}}'
    (testpath/"normal.csv").write "theta_o\n0\n"
    assert_match "0,0.3068528194", shell_output("#{bin}/brdfplot eval ggx.json -q albedo -i normal.csv")
  end
end
