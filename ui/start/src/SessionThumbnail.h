#pragma once
#include <QImage>
#include <QSize>
#include <filesystem>

#include "presenters/RecentSessions.h"

namespace pellucida {

/// A session as it is offered: facts and a small picture.
struct SessionThumbnail {
  RecentSession session;
  QImage picture;  ///< null when the session holds no image
};

/// Reads a session's head and tables and its picture, or else its first image, scaled to cover `size_px`. For any
/// thread. Throws InputError for a session that can't be read; an image that can't be read is no picture.
SessionThumbnail read_thumbnail(const std::filesystem::path& session, QSize size_px);

}  // namespace pellucida
