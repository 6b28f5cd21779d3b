// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_image.hpp"

#include "mem/image.hpp"
#include "scene/files.hpp"
#include "scene/scene_error.hpp"

namespace castray {

SceneImage read_image(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  SceneImage image;
  image.bytes.assign(text.begin(), text.end());
  const auto refuse = [&](error_t error) { throw SceneError(file.string(), "scene image", meaning(error)); };
  if (image.bytes.size() < static_cast<std::size_t>(HeaderBytes + FrameBytes)) refuse(ErrImage);
  image.header = load_header(image.bytes.data());
  image.frame = load_frame_record(image.bytes.data());
  // As a job that asks for nothing but what the image itself says.
  job_t job;
  job.image_bytes = image.bytes.size();
  job.width = image.frame.width;
  job.height = image.frame.height;
  job.frame_bytes = image.frame.stride * image.frame.height;
  job.is_list = image.frame.width == 0;  // compiled for a list of rays: the frame record is zero
  if (const error_t error = check_records(image.header, image.frame, job); error != ErrNone) refuse(error);
  const auto most = static_cast<std::uint64_t>(MaxFrameSize);
  if (image.frame.width > most || image.frame.height > most) refuse(ErrFrameRecord);
  return image;
}

}  // namespace castray
