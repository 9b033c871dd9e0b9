#!/usr/bin/env bash
# Both programs may load only libraries of this list: nothing under the GPL alone, nothing by accident.
set -u
allowed='linux-vdso|ld-linux|libc\.|libm\.|libstdc\+\+|libgcc_s|libpthread|libdl|librt|libmvec|libsqlite3|libfmt|libcrypto|libpugixml|libarchive|libxlsxwriter|libgvc|libcgraph|libcdt|libpathplan|libxdot|libexpat|libltdl|libgeos|libproj|libpng|libjpeg|libopencv_(core|imgproc|features2d|flann)|libQt6(Core|Gui|Widgets|PrintSupport|OpenGL|OpenGLWidgets|DBus)|libasan|libubsan|libz\.|libz-ng|liblzma|libzstd|liblz4|libbz2|libacl|libnettle|libhogweed|libgmp|libxml2|libicu|libminizip|libtbb|liblapack|libblas|libgfortran|libquadmath|libtiff|libcurl|libEGL|libGL|libGLX|libGLdispatch|libOpenGL|libX11|libXau|libXdmcp|libxcb|libxkbcommon|libfontconfig|libfreetype|libharfbuzz|libgraphite2|libglib|libpcre2|libdouble-conversion|libb2|libmd4c|libbrotli|libdbus|libsystemd|libcap|libgcrypt|libgpg-error|libbsd|libmd\.|libnghttp2|libidn2|librtmp|libssh2|libpsl|libssl|libgssapi|libldap|liblber|libkrb5|libk5crypto|libcom_err|libkrb5support|libkeyutils|libresolv|libunistring|libgnutls|libp11|libtasn1|libffi|libsasl2|libwebp|libLerc|libjbig|libdeflate|libproxy|libuuid|libatomic|libgomp'
bad=0
for program in "$@"; do
  extra=$(ldd "$program" | awk '{print $1}' | xargs -n1 basename | grep -vE "^($allowed)" || true)
  if [ -n "$extra" ]; then
    echo "$program loads libraries outside the list: $extra"
    bad=1
  fi
done
[ "$bad" -eq 0 ] && echo "linked libraries: as listed"
exit $bad
