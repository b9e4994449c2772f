// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/hdf5_file.h"

#include <exception>
#include <system_error>

namespace touchdown {

namespace fs = std::filesystem;

std::string writeHdf5File(const fs::path& path, const std::string& what, const std::function<void(hid_t)>& fill)
{
    const auto refuse = [&](const std::string& reason) {
        return "cannot write " + what + " to " + path.string() + ": " + reason;
    };
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(path, error);
    const fs::path target = error ? path : canonical;
    if (fs::is_directory(target, error)) return refuse("it is a directory");
    const fs::path part = target.string() + ".part";
    const Hdf5Access access;
    try {
        const Hdf5Handle list(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
        checkHdf5(H5Pset_link_creation_order(list, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
        Hdf5Handle file(H5Fcreate(part.c_str(), H5F_ACC_TRUNC, list, hdf5FileAccess()), H5Fclose);
        fill(file);
        file.close();
        fs::rename(part, target);
    } catch (const std::exception& failure) {
        fs::remove(part, error);
        return refuse(failure.what());
    }
    return {};
}

} // namespace touchdown
