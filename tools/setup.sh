#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian packages of tools/packages.txt that are missing, with progress; through sudo when not root.
# Elsewhere than on a Debian it names them and stops.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t wanted < <(sed 's/[[:space:]]*#.*//; /^$/d' tools/packages.txt)
if ! command -v apt-get > /dev/null || ! command -v dpkg-query > /dev/null; then
  echo "setup: this is no Debian system; install these, or what your system calls them: ${wanted[*]}" >&2
  exit 1
fi
missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f '${Status}' "$package" 2> /dev/null || true)
  [[ $status == "install ok installed" ]] || missing+=("$package")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo > /dev/null; then
    echo "setup: not root and no sudo; as root run: apt-get update && apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup: installing ${missing[*]}"
"${as_root[@]}" apt-get update -qq
# apt's status lines, kind:package:percent:text, are all that is shown of its output: each quarter of the way.
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends -o APT::Status-Fd=1 "${missing[@]}" |
  while IFS=: read -r kind _ percent _; do
    case $kind in
      dlstatus) step="download" ;;
      pmstatus) step="install" ;;
      *) continue ;;
    esac
    reached="$step $((${percent%%[.,]*} / 25 * 25))%"
    [[ $reached == "${shown-}" ]] || echo "setup: $reached"
    shown=$reached
  done
