// OpenCV.
//
//   opencv_polygon_test  pointPolygonTest of a contour of three Point2f: signs
//                        only, no distance. Single precision alone. Closed.
//   opencv_fill          fillConvexPoly into an 8-bit image of the grid, then
//                        the image to bits (loop grid): fill and packing are
//                        both timed. It fills and draws the outline, so pixels
//                        up to half a pixel outside an edge count as inside.
//
// Set-up: a vector of points; for the grid an image a call, cleared for each
// triangle.
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/core/version.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "peers/libraries.h"
#include "peers/rows.h"

namespace pitbench {
namespace {

template <class T>
class PolygonTest {
 public:
  explicit PolygonTest(const PeerTriangle<T>& t)
      : contour_{{t.ax, t.ay}, {t.bx, t.by}, {t.cx, t.cy}} {}
  bool Inside(T x, T y) const {
    return cv::pointPolygonTest(contour_, {x, y}, /*measureDist=*/false) >= 0;
  }

 private:
  std::vector<cv::Point_<T>> contour_;
};

void Fill(const Batch<std::int32_t>& in, const Result<std::int32_t>& out) {
  cv::Mat image(static_cast<int>(in.height), static_cast<int>(in.width),
                CV_8UC1);
  std::uint8_t* bits = out.bits;
  for (std::size_t i = 0; i < in.n; ++i) {
    image.setTo(0);
    const cv::Point corners[] = {
        {in.ax[i], in.ay[i]}, {in.bx[i], in.by[i]}, {in.cx[i], in.cy[i]}};
    FalseIfThrown([&] {
      cv::fillConvexPoly(image, corners, 3, cv::Scalar(1));
      return true;
    });
    for (std::size_t row = 0; row < in.height; ++row) {
      const std::uint8_t* pixels = image.ptr(static_cast<int>(row));
      WriteBits(in.width, bits, [&](std::size_t x) { return pixels[x] != 0; });
      bits += BitBytes(in.width);
    }
  }
}

}  // namespace

PeerLibrary AddOpencv(std::vector<Kernel>& rows) {
  AddPeerRows<float, PolygonTest>(
      {.key = "opencv_polygon_test",
       .source = "OpenCV",
       .formula = "pointPolygonTest(contour, point, false) ≥ 0",
       .boundary = Boundary::kClosed},
      rows);
  Kernel fill{.method = {.key = "opencv_fill",
                         .source = "OpenCV",
                         .formula = "fillConvexPoly(image, corners), then bits",
                         .boundary = Boundary::kClosed,
                         .edge_width = 0.5},
              .scalar = Scalar::kI32,
              .isa = Isa::kLibrary,
              .loop = Loop::kGrid,
              .output = Output::kInside};
  fill.i32 = Fill;
  rows.push_back(fill);
  return {"opencv", CV_VERSION};
}

}  // namespace pitbench
