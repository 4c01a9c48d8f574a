#include "out/report/png.hpp"

#include <png.h>

#include <stdexcept>

namespace alate {

namespace {

/// Pictures that grow in the report are small; speed counts for more than the last percent of size.
constexpr int kCompression = 4;

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

[[noreturn]] void fail(png_structp /*png*/, png_const_charp message) { throw std::runtime_error(message); }

void flush(png_structp /*png*/) {}

/// Frees libpng's two structures, also when `fail` throws through it.
struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
  png_infop info = png_create_info_struct(png);

  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

}  // namespace

std::string to_png(const IndexedImage& image) {
  Writer writer;
  std::string bytes;
  std::vector<png_color> palette;
  for (const Rgb& color : image.palette) palette.push_back({color[0], color[1], color[2]});
  png_set_write_fn(writer.png, &bytes, append, flush);
  png_set_compression_level(writer.png, kCompression);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.columns), static_cast<png_uint_32>(image.rows),
               8, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_PLTE(writer.png, writer.info, palette.data(), static_cast<int>(palette.size()));
  png_write_info(writer.png, writer.info);
  for (int row = 0; row < image.rows; ++row)
    png_write_row(writer.png,
                  image.pixels.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(image.columns));
  png_write_end(writer.png, writer.info);
  return bytes;
}

}  // namespace alate
