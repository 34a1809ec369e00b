#!/bin/sh
# judge_all.sh ISORACLE PYTHON FOLDER: judges each library, a report each, and says in a line what came of it.
set -u
isoracle=$1 python=$2 folder=$3
here=$(dirname "$0")
mkdir -p "$folder"
for adapter in skimage_lewiner skimage_lorensen pymcubes vtk_mc libigl_mc trimesh_check scipy_ndimage; do
    case $adapter in *_check) suite=mesh ;; scipy_*) suite=spline ;; *) suite=isosurface ;; esac
    "$isoracle" judge --suite $suite --report "$folder/$adapter" -- "$python" "$here/$adapter.py" >"$folder/$adapter.txt" 2>"$folder/$adapter.log"
    case $? in
    0 | 1) tail -n 1 "$folder/$adapter.txt" | sed "s/^/$adapter: /" ;;
    *) printf '%s: broke; see %s\n' "$adapter" "$folder/$adapter.log" ;;
    esac
done
echo "reports: $folder/*/report.html"
