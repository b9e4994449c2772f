// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/hdf5_file.h"

#include <exception>

#include "core/formats/output_file.h"

namespace touchdown {

namespace fs = std::filesystem;

namespace {

/// The default access, but closing the file closes all that is in it, and a file system without locks is no failure.
Hdf5Handle fileAccess()
{
    Hdf5Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    checkHdf5(H5Pset_fclose_degree(list, H5F_CLOSE_STRONG));
    checkHdf5(H5Pset_file_locking(list, true, true));
    return list;
}

} // namespace

Hdf5Group createHdf5File(const fs::path& file)
{
    const Hdf5Handle list(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    checkHdf5(H5Pset_link_creation_order(list, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    return {H5Fcreate(file.c_str(), H5F_ACC_EXCL, list, fileAccess()), H5Fclose};
}

Hdf5Group openHdf5File(const fs::path& file, unsigned flags)
{
    return {H5Fopen(file.c_str(), flags, fileAccess()), H5Fclose};
}

std::string writeHdf5File(const OutputLock& lock, const std::string& what,
                          const std::function<void(const Hdf5Group&)>& fill)
{
    const Hdf5Access access;
    try {
        const PartFile part(lock, PartName::Own);
        Hdf5Group root = createHdf5File(part.path());
        part.takeMode();
        fill(root);
        root.close();
        part.show();
    } catch (const std::exception& failure) {
        return "cannot write " + what + " to " + lock.target().string() + ": " + failure.what();
    }
    return {};
}

} // namespace touchdown
